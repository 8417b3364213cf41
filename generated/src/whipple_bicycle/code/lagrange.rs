//! Whipple bicycle: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, psi, phi, theta, delta, thR, thF, constraint contact, constraint rear_1, constraint rear_2, constraint front_1, constraint front_2.
///
/// 872 operations, 6 sines and cosines, 2 other functions.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    _q_dot: &[S; 8],
) -> [[S; 13]; 13] {
    let Parameters {
        w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx, IHxz,
        IHyy, IHzz, rF, mF, IFxx, IFyy,
        ..
    } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    // Step by step, each after the terms that it needs.
    let mp_B_1 = xB * mB;
    let v_Y_in_L_2_3 = sin_psi * cos_phi;
    let v_Y_in_L_3_3 = sin_psi * sin_phi;
    let v_L_in_B_1_3 = (-cos_psi).mul_add(cos_theta, v_Y_in_L_3_3 * sin_theta);
    let v_L_in_B_3_3 = v_Y_in_L_3_3.mul_add(cos_theta, cos_psi * sin_theta);
    let v_B_in_S_1_3 = v_L_in_B_3_3.mul_add(sin_lam, v_L_in_B_1_3 * cos_lam);
    let v_B_in_S_3_3 = (-v_L_in_B_1_3).mul_add(sin_lam, v_L_in_B_3_3 * cos_lam);
    let v_S_in_F_1_3 = v_B_in_S_1_3.mul_add(cos_delta, v_Y_in_L_2_3 * sin_delta);
    let v_S_in_F_2_3 = (-v_Y_in_L_2_3).mul_add(cos_delta, v_B_in_S_1_3 * sin_delta);
    let p_v_FC_3_3 = mF * v_B_in_S_3_3;
    let p_v_FC_2_3 = mF * v_S_in_F_2_3;
    let p_v_FC_1_3 = mF * v_S_in_F_1_3;
    let p_v_Ho_3_5 = mH * v_B_in_S_3_3;
    let p_v_Ho_2_5 = mH * v_S_in_F_2_3;
    let p_v_Ho_1_3 = mH * v_S_in_F_1_3;
    let p_v_S_in_F_2_3 = p_v_FC_2_3 + p_v_Ho_2_5;
    let p_v_S_in_F_1_3 = p_v_FC_1_3 + p_v_Ho_1_3;
    let p_v_Ho_3_6 = p_v_FC_3_3 + p_v_Ho_3_5;
    let p_v_Ho_2_6 = (-p_v_S_in_F_1_3).mul_add(sin_delta, p_v_S_in_F_2_3 * cos_delta);
    let p_v_B_in_S_1_3 = p_v_S_in_F_1_3.mul_add(cos_delta, p_v_S_in_F_2_3 * sin_delta);
    let p_v_Bo_3_3 = mB * v_L_in_B_3_3;
    let p_v_Bo_2_3 = mB * v_Y_in_L_2_3;
    let p_v_Bo_1_3 = mB * v_L_in_B_1_3;
    let p_v_L_in_B_3_3 = p_v_B_in_S_1_3.mul_add(sin_lam, p_v_Ho_3_6 * cos_lam) + p_v_Bo_3_3;
    let p_v_L_in_B_1_3 = (-p_v_B_in_S_1_3).mul_add(cos_lam, p_v_Ho_3_6 * sin_lam) - p_v_Bo_1_3;
    let p_v_RC_2_3 = mR.mul_add(v_Y_in_L_2_3, -p_v_Ho_2_6) + p_v_Bo_2_3;
    let p_v_RC_1_3 = p_v_L_in_B_3_3.mul_add(sin_theta, mR * cos_psi) + p_v_L_in_B_1_3 * cos_theta;
    let p_v_Y_in_L_3_3 = p_v_L_in_B_3_3.mul_add(cos_theta, mR * v_Y_in_L_3_3)
        - p_v_L_in_B_1_3 * sin_theta;
    let p_v_N_in_Y_2_3 = p_v_Y_in_L_3_3.mul_add(sin_phi, p_v_RC_2_3 * cos_phi);
    let v_Y_in_L_2_4 = cos_psi * cos_phi;
    let v_Y_in_L_3_4 = cos_psi * sin_phi;
    let v_L_in_B_1_4 = v_Y_in_L_3_4.mul_add(sin_theta, sin_psi * cos_theta);
    let v_L_in_B_3_4 = (-sin_psi).mul_add(sin_theta, v_Y_in_L_3_4 * cos_theta);
    let v_B_in_S_1_4 = v_L_in_B_3_4.mul_add(sin_lam, v_L_in_B_1_4 * cos_lam);
    let v_B_in_S_3_4 = (-v_L_in_B_1_4).mul_add(sin_lam, v_L_in_B_3_4 * cos_lam);
    let v_S_in_F_1_4 = v_B_in_S_1_4.mul_add(cos_delta, v_Y_in_L_2_4 * sin_delta);
    let v_S_in_F_2_4 = (-v_Y_in_L_2_4).mul_add(cos_delta, v_B_in_S_1_4 * sin_delta);
    let p_v_FC_3_4 = mF * v_B_in_S_3_4;
    let p_v_FC_2_4 = mF * v_S_in_F_2_4;
    let p_v_FC_1_4 = mF * v_S_in_F_1_4;
    let p_v_Ho_3_7 = mH * v_B_in_S_3_4;
    let p_v_Ho_2_7 = mH * v_S_in_F_2_4;
    let p_v_Ho_1_4 = mH * v_S_in_F_1_4;
    let p_v_S_in_F_2_4 = p_v_FC_2_4 + p_v_Ho_2_7;
    let p_v_S_in_F_1_4 = p_v_FC_1_4 + p_v_Ho_1_4;
    let p_v_Ho_3_8 = p_v_FC_3_4 + p_v_Ho_3_7;
    let p_v_Ho_2_8 = (-p_v_S_in_F_1_4).mul_add(sin_delta, p_v_S_in_F_2_4 * cos_delta);
    let p_v_B_in_S_1_4 = p_v_S_in_F_1_4.mul_add(cos_delta, p_v_S_in_F_2_4 * sin_delta);
    let p_v_Bo_3_4 = mB * v_L_in_B_3_4;
    let p_v_Bo_2_4 = mB * v_Y_in_L_2_4;
    let p_v_Bo_1_4 = mB * v_L_in_B_1_4;
    let p_v_L_in_B_3_4 = p_v_B_in_S_1_4.mul_add(sin_lam, p_v_Ho_3_8 * cos_lam) + p_v_Bo_3_4;
    let p_v_L_in_B_1_4 = (-p_v_B_in_S_1_4).mul_add(cos_lam, p_v_Ho_3_8 * sin_lam) - p_v_Bo_1_4;
    let p_v_RC_2_4 = mR.mul_add(v_Y_in_L_2_4, -p_v_Ho_2_8) + p_v_Bo_2_4;
    let p_v_RC_1_4 = (-p_v_L_in_B_3_4).mul_add(sin_theta, mR * sin_psi)
        - p_v_L_in_B_1_4 * cos_theta;
    let p_v_Y_in_L_3_4 = p_v_L_in_B_3_4.mul_add(cos_theta, mR * v_Y_in_L_3_4)
        - p_v_L_in_B_1_4 * sin_theta;
    let p_v_N_in_Y_2_4 = p_v_Y_in_L_3_4.mul_add(sin_phi, p_v_RC_2_4 * cos_phi);
    let w_L_in_B_1_3 = cos_phi * sin_theta;
    let w_L_in_B_3_3 = cos_phi * cos_theta;
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let w_S_in_F_1_3 = (-w_B_in_S_1_3).mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let w_S_in_F_2_3 = w_B_in_S_1_3.mul_add(sin_delta, sin_phi_cos_delta);
    let v_RC_1_3 = rR * sin_phi;
    let v_L_in_B_1_5 = v_RC_1_3 * cos_theta;
    let v_L_in_B_3_5 = v_RC_1_3 * sin_theta;
    let rr_plus_zb = rR + zB;
    let v_Bo_1_3 = rr_plus_zb.mul_add(sin_phi, -v_L_in_B_1_5);
    let v_Bo_2_3 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let v_Bo_3_3 = xB.mul_add(sin_phi, v_L_in_B_3_5);
    let v_B_in_S_1_5 = (-v_L_in_B_1_5).mul_add(cos_lam, v_L_in_B_3_5 * sin_lam);
    let v_B_in_S_3_5 = v_L_in_B_3_5.mul_add(cos_lam, v_L_in_B_1_5 * sin_lam);
    let rr_sin_lam = rR * sin_lam;
    let v_Ho_2_5_of_w_c_lam_rr = rr_sin_lam - cos_lam * (w + c);
    let v_Ho_2_5_of_w_c_lam_rr_2 = -v_Ho_2_5_of_w_c_lam_rr;
    let v_Ho_2_5 = w_B_in_S_3_3 * v_Ho_2_5_of_w_c_lam_rr_2;
    let v_Ho_3_5 = v_Ho_2_5_of_w_c_lam_rr_2.mul_add(sin_phi, v_B_in_S_3_5);
    let v_S_in_F_1_5 = v_Ho_2_5.mul_add(sin_delta, v_B_in_S_1_5 * cos_delta);
    let v_S_in_F_2_5 = (-v_Ho_2_5).mul_add(cos_delta, v_B_in_S_1_5 * sin_delta);
    let rr_plus_zh = rR + zH;
    let v_Ho_1_3_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let v_Ho_1_3 = w_S_in_F_2_3.mul_add(v_Ho_1_3_of_lam_rr_xh_zh, v_S_in_F_1_5);
    let v_Ho_2_6_of_lam_rr_xh_zh = (-xH).mul_add(cos_lam, rr_plus_zh * sin_lam);
    let v_Ho_2_6_of_place = v_Ho_2_5_of_w_c_lam_rr - v_Ho_2_6_of_lam_rr_xh_zh;
    let minus_v_ho_2_6_of_place = -v_Ho_2_6_of_place;
    let v_Ho_2_6 = w_S_in_F_1_3.mul_add(v_Ho_1_3_of_lam_rr_xh_zh, v_S_in_F_2_5)
        + w_B_in_S_3_3 * minus_v_ho_2_6_of_place;
    let v_Ho_3_6 = w_S_in_F_2_3.mul_add(minus_v_ho_2_6_of_place, -v_Ho_3_5);
    let w_sin_lam = w * sin_lam;
    let v_FC_1_3_of_w_lam_rr_rf = cos_lam * (rR - rF) + w_sin_lam;
    let v_FC_1_3 = w_S_in_F_2_3.mul_add(v_FC_1_3_of_w_lam_rr_rf, v_S_in_F_1_5);
    let c_cos_lam = c * cos_lam;
    let v_FC_2_3_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let v_FC_2_3 = w_B_in_S_3_3.mul_add(v_FC_2_3_of_c_lam_rf, -v_S_in_F_2_5)
        - w_S_in_F_1_3 * v_FC_1_3_of_w_lam_rr_rf;
    let v_FC_3_3 = w_S_in_F_2_3.mul_add(v_FC_2_3_of_c_lam_rf, v_Ho_3_5);
    let p_v_FC_3_5 = mF * v_FC_3_3;
    let p_v_FC_2_5 = mF * v_FC_2_3;
    let p_v_FC_1_5 = mF * v_FC_1_3;
    let p_v_Ho_3_9 = mH * v_Ho_3_6;
    let p_v_Ho_2_9 = mH * v_Ho_2_6;
    let p_v_Ho_1_5 = mH * v_Ho_1_3;
    let p_v_S_in_F_2_5 = p_v_FC_2_5 - p_v_Ho_2_9;
    let p_v_S_in_F_1_5 = p_v_FC_1_5 + p_v_Ho_1_5;
    let p_v_Ho_3_10 = p_v_FC_3_5 - p_v_Ho_3_9;
    let p_v_Ho_2_10 = p_v_S_in_F_1_5.mul_add(sin_delta, p_v_S_in_F_2_5 * cos_delta);
    let p_v_B_in_S_1_5 = (-p_v_S_in_F_1_5)
        .mul_add(cos_delta, p_v_S_in_F_2_5 * sin_delta);
    let p_v_Bo_3_5 = mB * v_Bo_3_3;
    let p_v_Bo_2_5 = mB * v_Bo_2_3;
    let p_v_Bo_1_5 = mB * v_Bo_1_3;
    let p_v_L_in_B_3_5 = (-p_v_B_in_S_1_5).mul_add(sin_lam, p_v_Ho_3_10 * cos_lam) + p_v_Bo_3_5;
    let p_v_L_in_B_1_5 = p_v_B_in_S_1_5.mul_add(cos_lam, p_v_Ho_3_10 * sin_lam) - p_v_Bo_1_5;
    let p_v_RC_2_5 = p_v_Ho_2_10 + p_v_Bo_2_5;
    let p_v_RC_1_5 = p_v_L_in_B_3_5.mul_add(sin_theta, mR * v_RC_1_3) + p_v_L_in_B_1_5 * cos_theta;
    let p_v_Y_in_L_3_5 = (-p_v_L_in_B_1_5)
        .mul_add(sin_theta, p_v_L_in_B_3_5 * cos_theta);
    let p_v_N_in_Y_2_5 = p_v_Y_in_L_3_5.mul_add(sin_phi, p_v_RC_2_5 * cos_phi);
    let w_B_in_S_1_4 = (-sin_lam).mul_add(sin_theta, cos_lam * cos_theta);
    let w_B_in_S_3_4 = sin_lam.mul_add(cos_theta, cos_lam * sin_theta);
    let w_S_in_F_1_4 = w_B_in_S_1_4 * cos_delta;
    let w_S_in_F_2_4 = w_B_in_S_1_4 * sin_delta;
    let v_Bo_2_4 = xB.mul_add(sin_theta, rR) - rr_plus_zb * cos_theta;
    let v_Ho_2_7 = w_B_in_S_3_4.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, rR);
    let v_S_in_F_1_6 = v_Ho_2_7 * sin_delta;
    let v_S_in_F_2_6 = v_Ho_2_7 * cos_delta;
    let v_Ho_1_4 = w_S_in_F_2_4.mul_add(v_Ho_1_3_of_lam_rr_xh_zh, -v_S_in_F_1_6);
    let v_Ho_2_8 = w_S_in_F_1_4.mul_add(v_Ho_1_3_of_lam_rr_xh_zh, -v_S_in_F_2_6)
        + w_B_in_S_3_4 * minus_v_ho_2_6_of_place;
    let v_Ho_3_7 = w_S_in_F_2_4 * minus_v_ho_2_6_of_place;
    let v_FC_1_4 = w_S_in_F_2_4.mul_add(v_FC_1_3_of_w_lam_rr_rf, -v_S_in_F_1_6);
    let v_FC_2_4 = (-w_S_in_F_1_4).mul_add(v_FC_1_3_of_w_lam_rr_rf, v_S_in_F_2_6)
        + w_B_in_S_3_4 * v_FC_2_3_of_c_lam_rf;
    let v_FC_3_4 = w_S_in_F_2_4 * v_FC_2_3_of_c_lam_rf;
    let p_v_FC_3_6 = mF * v_FC_3_4;
    let p_v_FC_2_6 = mF * v_FC_2_4;
    let p_v_FC_1_6 = mF * v_FC_1_4;
    let p_v_Ho_3_11 = mH * v_Ho_3_7;
    let p_v_Ho_2_11 = mH * v_Ho_2_8;
    let p_v_Ho_1_6 = mH * v_Ho_1_4;
    let p_v_S_in_F_2_6 = p_v_FC_2_6 - p_v_Ho_2_11;
    let p_v_S_in_F_1_6 = p_v_FC_1_6 + p_v_Ho_1_6;
    let p_v_Ho_3_12 = p_v_FC_3_6 - p_v_Ho_3_11;
    let p_v_Ho_2_12 = (-p_v_S_in_F_1_6).mul_add(sin_delta, p_v_S_in_F_2_6 * cos_delta);
    let p_v_B_in_S_1_6 = p_v_S_in_F_1_6.mul_add(cos_delta, p_v_S_in_F_2_6 * sin_delta);
    let p_v_Bo_2_6 = mB * v_Bo_2_4;
    let p_v_L_in_B_3_6 = p_v_B_in_S_1_6.mul_add(sin_lam, p_v_Ho_3_12 * cos_lam);
    let p_v_L_in_B_1_6 = (-p_v_B_in_S_1_6).mul_add(cos_lam, p_v_Ho_3_12 * sin_lam);
    let p_v_RC_2_6 = rR.mul_add(mR, p_v_Ho_2_12) + p_v_Bo_2_6;
    let p_v_RC_1_6 = p_v_L_in_B_1_6.mul_add(cos_theta, p_v_L_in_B_3_6 * sin_theta);
    let p_v_Y_in_L_3_6 = (-p_v_L_in_B_1_6)
        .mul_add(sin_theta, p_v_L_in_B_3_6 * cos_theta);
    let p_v_N_in_Y_2_6 = (-p_v_RC_2_6).mul_add(cos_phi, p_v_Y_in_L_3_6 * sin_phi);
    let v_Bo_1_4 = rr_plus_zb;
    let v_Ho_3_8 = v_Ho_2_5_of_w_c_lam_rr_2;
    let v_Ho_1_5 = v_Ho_1_3_of_lam_rr_xh_zh * cos_delta;
    let v_Ho_2_9 = v_Ho_1_3_of_lam_rr_xh_zh * sin_delta;
    let v_Ho_3_9 = minus_v_ho_2_6_of_place.mul_add(cos_delta, -v_Ho_3_8);
    let v_FC_1_5 = v_FC_1_3_of_w_lam_rr_rf * cos_delta;
    let v_FC_2_5 = v_FC_1_3_of_w_lam_rr_rf * sin_delta;
    let v_FC_3_5 = v_FC_2_3_of_c_lam_rf.mul_add(cos_delta, v_Ho_3_8);
    let p_v_FC_3_7 = mF * v_FC_3_5;
    let p_v_FC_2_7 = mF * v_FC_2_5;
    let p_v_FC_1_7 = mF * v_FC_1_5;
    let p_v_Ho_3_13 = mH * v_Ho_3_9;
    let p_v_Ho_2_13 = mH * v_Ho_2_9;
    let p_v_Ho_1_7 = mH * v_Ho_1_5;
    let p_v_S_in_F_2_7 = p_v_FC_2_7 + p_v_Ho_2_13;
    let p_v_S_in_F_1_7 = p_v_FC_1_7 + p_v_Ho_1_7;
    let p_v_Ho_3_14 = p_v_FC_3_7 - p_v_Ho_3_13;
    let p_v_Ho_2_14 = (-p_v_S_in_F_1_7).mul_add(sin_delta, p_v_S_in_F_2_7 * cos_delta);
    let p_v_B_in_S_1_7 = p_v_S_in_F_1_7.mul_add(cos_delta, p_v_S_in_F_2_7 * sin_delta);
    let p_v_Bo_1_6 = mB * v_Bo_1_4;
    let p_v_L_in_B_3_7 = p_v_Ho_3_14.mul_add(cos_lam, mp_B_1) + p_v_B_in_S_1_7 * sin_lam;
    let p_v_L_in_B_1_7 = (-p_v_B_in_S_1_7).mul_add(cos_lam, p_v_Ho_3_14 * sin_lam) - p_v_Bo_1_6;
    let p_v_RC_1_7 = p_v_L_in_B_1_7.mul_add(cos_theta, p_v_L_in_B_3_7 * sin_theta);
    let p_v_Y_in_L_3_7 = (-p_v_L_in_B_1_7)
        .mul_add(sin_theta, p_v_L_in_B_3_7 * cos_theta);
    let p_v_N_in_Y_2_7 = (-p_v_Ho_2_14).mul_add(cos_phi, p_v_Y_in_L_3_7 * sin_phi);
    let v_Ho_2_10 = minus_v_ho_2_6_of_place;
    let v_FC_2_6 = v_FC_2_3_of_c_lam_rf;
    let p_v_FC_2_8 = mF * v_FC_2_6;
    let p_v_Ho_2_15 = mH * v_Ho_2_10;
    let p_v_S_in_F_2_8 = p_v_FC_2_8 - p_v_Ho_2_15;
    let p_v_Ho_2_16 = p_v_S_in_F_2_8 * cos_delta;
    let p_v_B_in_S_1_8 = p_v_S_in_F_2_8 * sin_delta;
    let p_v_L_in_B_3_8 = p_v_B_in_S_1_8 * sin_lam;
    let p_v_L_in_B_1_8 = p_v_B_in_S_1_8 * cos_lam;
    let p_v_RC_1_8 = (-p_v_L_in_B_1_8).mul_add(cos_theta, p_v_L_in_B_3_8 * sin_theta);
    let p_v_Y_in_L_3_8 = p_v_L_in_B_1_8.mul_add(sin_theta, p_v_L_in_B_3_8 * cos_theta);
    let p_v_N_in_Y_2_8 = (-p_v_Ho_2_16).mul_add(cos_phi, p_v_Y_in_L_3_8 * sin_phi);
    let w_F_in_H_1_3 = w_S_in_F_1_3.mul_add(cos_lam, w_B_in_S_3_3 * sin_lam);
    let w_F_in_H_3_3 = (-w_S_in_F_1_3).mul_add(sin_lam, w_B_in_S_3_3 * cos_lam);
    let H_rear_wheel_2_3 = IRyy * sin_phi;
    let H_rear_wheel_3_3 = IRxx * cos_phi;
    let H_frame_1_3 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let H_frame_2_3 = IByy * sin_phi;
    let H_frame_3_3 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let H_fork_1_3 = IHxz.mul_add(w_F_in_H_3_3, IHxx * w_F_in_H_1_3);
    let H_fork_2_3 = IHyy * w_S_in_F_2_3;
    let H_fork_3_3 = IHzz.mul_add(w_F_in_H_3_3, IHxz * w_F_in_H_1_3);
    let H_front_wheel_1_3 = IFxx * w_S_in_F_1_3;
    let H_front_wheel_2_3 = IFyy * w_S_in_F_2_3;
    let H_front_wheel_3_3 = IFxx * w_B_in_S_3_3;
    let p_w_F_3_3 = H_fork_3_3.mul_add(cos_lam, H_fork_1_3 * sin_lam) + H_front_wheel_3_3
        + p_v_Ho_2_9 * minus_v_ho_2_6_of_place + p_v_FC_2_5 * v_FC_2_3_of_c_lam_rf;
    let p_w_S_in_F_2_3 = p_v_Ho_1_5
        .mul_add(v_Ho_1_3_of_lam_rr_xh_zh, H_fork_2_3 + H_front_wheel_2_3)
        + p_v_Ho_3_9 * minus_v_ho_2_6_of_place + p_v_FC_1_5 * v_FC_1_3_of_w_lam_rr_rf
        + p_v_FC_3_5 * v_FC_2_3_of_c_lam_rf;
    let p_w_S_in_F_1_3 = (-H_fork_3_3).mul_add(sin_lam, H_fork_1_3 * cos_lam)
        + H_front_wheel_1_3 + p_v_Ho_2_9 * v_Ho_1_3_of_lam_rr_xh_zh
        - p_v_FC_2_5 * v_FC_1_3_of_w_lam_rr_rf;
    let p_w_B_in_S_3_3 = p_v_Ho_2_10.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, p_w_F_3_3);
    let p_w_B_in_S_1_3 = (-p_w_S_in_F_1_3)
        .mul_add(cos_delta, p_w_S_in_F_2_3 * sin_delta);
    let p_w_B_2_3 = xB.mul_add(p_v_Bo_3_5, H_frame_2_3) + p_w_S_in_F_2_3 * cos_delta
        + p_w_S_in_F_1_3 * sin_delta + p_v_Bo_1_5 * rr_plus_zb
        + p_v_Ho_3_10 * v_Ho_2_5_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_3 = (-xB).mul_add(p_v_Bo_2_5, H_frame_3_3)
        - p_w_B_in_S_3_3 * cos_lam - p_w_B_in_S_1_3 * sin_lam;
    let p_w_L_in_B_1_3 = (-p_w_B_in_S_3_3).mul_add(sin_lam, H_frame_1_3)
        + p_w_B_in_S_1_3 * cos_lam + p_v_Bo_2_5 * rr_plus_zb;
    let p_w_Y_in_L_3_3 = (-p_w_L_in_B_3_3).mul_add(cos_theta, H_rear_wheel_3_3)
        + p_w_L_in_B_1_3 * sin_theta;
    let p_w_Y_in_L_2_3 = rR.mul_add(p_v_RC_1_5, H_rear_wheel_2_3) + p_w_B_2_3;
    let w_F_in_H_1_4 = w_S_in_F_1_4.mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = (-w_S_in_F_1_4).mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let H_frame_1_4 = IBxx.mul_add(cos_theta, IBxz * sin_theta);
    let H_frame_3_4 = IBxz.mul_add(cos_theta, IBzz * sin_theta);
    let H_fork_1_4 = IHxz.mul_add(w_F_in_H_3_4, IHxx * w_F_in_H_1_4);
    let H_fork_2_4 = IHyy * w_S_in_F_2_4;
    let H_fork_3_4 = IHzz.mul_add(w_F_in_H_3_4, IHxz * w_F_in_H_1_4);
    let H_front_wheel_1_4 = IFxx * w_S_in_F_1_4;
    let H_front_wheel_2_4 = IFyy * w_S_in_F_2_4;
    let H_front_wheel_3_4 = IFxx * w_B_in_S_3_4;
    let p_w_F_3_4 = H_fork_3_4.mul_add(cos_lam, H_fork_1_4 * sin_lam) + H_front_wheel_3_4
        + p_v_Ho_2_11 * minus_v_ho_2_6_of_place + p_v_FC_2_6 * v_FC_2_3_of_c_lam_rf;
    let p_w_S_in_F_2_4 = p_v_Ho_1_6
        .mul_add(v_Ho_1_3_of_lam_rr_xh_zh, H_fork_2_4 + H_front_wheel_2_4)
        + p_v_Ho_3_11 * minus_v_ho_2_6_of_place + p_v_FC_1_6 * v_FC_1_3_of_w_lam_rr_rf
        + p_v_FC_3_6 * v_FC_2_3_of_c_lam_rf;
    let p_w_S_in_F_1_4 = (-H_fork_3_4).mul_add(sin_lam, H_fork_1_4 * cos_lam)
        + H_front_wheel_1_4 + p_v_Ho_2_11 * v_Ho_1_3_of_lam_rr_xh_zh
        - p_v_FC_2_6 * v_FC_1_3_of_w_lam_rr_rf;
    let p_w_B_in_S_3_4 = p_v_Ho_2_12.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, p_w_F_3_4);
    let p_w_B_in_S_1_4 = p_w_S_in_F_1_4.mul_add(cos_delta, p_w_S_in_F_2_4 * sin_delta);
    let p_w_B_2_4 = (-p_w_S_in_F_1_4).mul_add(sin_delta, p_w_S_in_F_2_4 * cos_delta)
        + p_v_Ho_3_12 * v_Ho_2_5_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_4 = xB.mul_add(p_v_Bo_2_6, H_frame_3_4) + p_w_B_in_S_3_4 * cos_lam
        - p_w_B_in_S_1_4 * sin_lam;
    let p_w_L_in_B_1_4 = p_w_B_in_S_3_4.mul_add(sin_lam, H_frame_1_4)
        + p_w_B_in_S_1_4 * cos_lam - p_v_Bo_2_6 * rr_plus_zb;
    let p_w_Y_in_L_3_4 = (-p_w_L_in_B_1_4)
        .mul_add(sin_theta, p_w_L_in_B_3_4 * cos_theta);
    let p_w_Y_in_L_2_4 = rR.mul_add(p_v_RC_1_6, p_w_B_2_4);
    let w_F_in_H_1_5 = cos_lam * sin_delta;
    let w_F_in_H_3_5 = sin_lam * sin_delta;
    let H_fork_1_5 = (-IHxz).mul_add(w_F_in_H_3_5, IHxx * w_F_in_H_1_5);
    let H_fork_2_5 = IHyy * cos_delta;
    let H_fork_3_5 = (-IHzz).mul_add(w_F_in_H_3_5, IHxz * w_F_in_H_1_5);
    let H_front_wheel_1_5 = IFxx * sin_delta;
    let H_front_wheel_2_5 = IFyy * cos_delta;
    let p_w_F_3_5 = (-H_fork_1_5).mul_add(sin_lam, p_v_FC_2_7 * v_FC_2_3_of_c_lam_rf)
        - H_fork_3_5 * cos_lam - p_v_Ho_2_13 * minus_v_ho_2_6_of_place;
    let p_w_S_in_F_2_5 = p_v_Ho_1_7
        .mul_add(v_Ho_1_3_of_lam_rr_xh_zh, H_fork_2_5 + H_front_wheel_2_5)
        + p_v_Ho_3_13 * minus_v_ho_2_6_of_place + p_v_FC_1_7 * v_FC_1_3_of_w_lam_rr_rf
        + p_v_FC_3_7 * v_FC_2_3_of_c_lam_rf;
    let p_w_S_in_F_1_5 = (-H_fork_3_5).mul_add(sin_lam, H_fork_1_5 * cos_lam)
        + H_front_wheel_1_5 + p_v_Ho_2_13 * v_Ho_1_3_of_lam_rr_xh_zh
        + p_v_FC_2_7 * v_FC_1_3_of_w_lam_rr_rf;
    let p_w_B_in_S_3_5 = p_v_Ho_2_14.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, p_w_F_3_5);
    let p_w_B_in_S_1_5 = (-p_w_S_in_F_1_5)
        .mul_add(cos_delta, p_w_S_in_F_2_5 * sin_delta);
    let p_w_B_2_5 = xB.mul_add(mp_B_1, IByy) + p_w_S_in_F_2_5 * cos_delta
        + p_w_S_in_F_1_5 * sin_delta + p_v_Bo_1_6 * rr_plus_zb
        + p_v_Ho_3_14 * v_Ho_2_5_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_5 = (-p_w_B_in_S_1_5).mul_add(sin_lam, p_w_B_in_S_3_5 * cos_lam);
    let p_w_L_in_B_1_5 = p_w_B_in_S_1_5.mul_add(cos_lam, p_w_B_in_S_3_5 * sin_lam);
    let p_w_Y_in_L_3_5 = (-p_w_L_in_B_1_5)
        .mul_add(sin_theta, p_w_L_in_B_3_5 * cos_theta);
    let p_w_Y_in_L_2_5 = rR.mul_add(p_v_RC_1_7, p_w_B_2_5);
    let H_fork_1_6 = IHxz.mul_add(cos_lam, IHxx * sin_lam);
    let H_fork_3_6 = IHzz.mul_add(cos_lam, IHxz * sin_lam);
    let p_w_F_3_6 = H_fork_1_6.mul_add(sin_lam, IFxx) + H_fork_3_6 * cos_lam
        + p_v_Ho_2_15 * minus_v_ho_2_6_of_place + p_v_FC_2_8 * v_FC_2_3_of_c_lam_rf;
    let p_w_S_in_F_1_6 = (-H_fork_1_6).mul_add(cos_lam, H_fork_3_6 * sin_lam)
        - p_v_Ho_2_15 * v_Ho_1_3_of_lam_rr_xh_zh + p_v_FC_2_8 * v_FC_1_3_of_w_lam_rr_rf;
    let p_w_B_in_S_3_6 = p_v_Ho_2_16.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, p_w_F_3_6);
    let p_w_B_in_S_1_6 = p_w_S_in_F_1_6 * cos_delta;
    let p_w_B_2_6 = p_w_S_in_F_1_6 * sin_delta;
    let p_w_L_in_B_3_6 = p_w_B_in_S_1_6.mul_add(sin_lam, p_w_B_in_S_3_6 * cos_lam);
    let p_w_L_in_B_1_6 = (-p_w_B_in_S_1_6).mul_add(cos_lam, p_w_B_in_S_3_6 * sin_lam);
    let p_w_Y_in_L_3_6 = (-p_w_L_in_B_1_6)
        .mul_add(sin_theta, p_w_L_in_B_3_6 * cos_theta);
    let p_w_Y_in_L_2_6 = rR.mul_add(p_v_RC_1_8, p_w_B_2_6);
    let p_w_B_in_S_1_7 = IFyy * sin_delta;
    let p_w_L_in_B_3_7 = p_w_B_in_S_1_7 * sin_lam;
    let p_w_L_in_B_1_7 = p_w_B_in_S_1_7 * cos_lam;
    let p_w_Y_in_L_3_7 = p_w_L_in_B_1_7.mul_add(sin_theta, p_w_L_in_B_3_7 * cos_theta);
    let m_1_2_of_place = (-p_v_RC_1_4).mul_add(cos_psi, p_v_N_in_Y_2_4 * sin_psi);
    let m_1_3_of_place = p_v_N_in_Y_2_5.mul_add(sin_psi, p_v_RC_1_5 * cos_psi);
    let m_1_4_of_place = p_v_N_in_Y_2_6.mul_add(sin_psi, p_v_RC_1_6 * cos_psi);
    let m_1_5_of_place = p_v_N_in_Y_2_7.mul_add(sin_psi, p_v_RC_1_7 * cos_psi);
    let m_1_6_of_place = p_v_N_in_Y_2_8.mul_add(sin_psi, p_v_RC_1_8 * cos_psi);
    let m_2_3_of_place = (-p_v_N_in_Y_2_5).mul_add(cos_psi, p_v_RC_1_5 * sin_psi);
    let m_2_4_of_place = (-p_v_N_in_Y_2_6).mul_add(cos_psi, p_v_RC_1_6 * sin_psi);
    let m_2_5_of_place = (-p_v_N_in_Y_2_7).mul_add(cos_psi, p_v_RC_1_7 * sin_psi);
    let m_2_6_of_place = (-p_v_N_in_Y_2_8).mul_add(cos_psi, p_v_RC_1_8 * sin_psi);
    let m_3_4_of_place = (-p_w_Y_in_L_2_4).mul_add(sin_phi, p_w_Y_in_L_3_4 * cos_phi);
    let m_3_5_of_place = (-p_w_Y_in_L_2_5).mul_add(sin_phi, p_w_Y_in_L_3_5 * cos_phi);
    let m_3_6_of_place = (-p_w_Y_in_L_2_6).mul_add(sin_phi, p_w_Y_in_L_3_6 * cos_phi);
    let m_3_8_of_place = p_w_Y_in_L_3_7.mul_add(cos_phi, H_front_wheel_2_5 * sin_phi);
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let m_3_12_of_place = sin_phi * v_Ho_2_5_of_w_c_lam_rr_2.mul_add(sin_lam_plus_theta, rR);
    let m_3_12_of_place_2 = cos_phi * sin_lam_plus_theta;
    let m_3_12_of_place_3 = (-m_3_12_of_place_2).mul_add(cos_delta, sin_delta_sin_phi);
    let m_3_12_of_place_4 = cos_phi * cos_lam_plus_theta;
    let m_3_12_of_place_5 = cos_lam_plus_theta * sin_delta;
    let m_3_12_of_place_6 = m_3_12_of_place_2 * sin_delta;
    let m_3_12_of_place_7 = sin_phi_cos_delta + m_3_12_of_place_6;
    let m_3_12_of_place_8 = S::int(1) / m_3_12_of_place_7.mul_add(m_3_12_of_place_7, -S::int(1));
    let m_3_12_of_place_9 = cos_phi * sin_lam_plus_theta * sin_delta;
    let m_3_12_of_place_10 = rF * m_3_12_of_place_8
        * (S::int(1) - (m_3_12_of_place_9 + sin_phi_cos_delta).powi(2)).sqrt();
    let m_3_12_of_place_11 = m_3_12_of_place_7 * m_3_12_of_place_10;
    let m_3_12_of_place_12 = cos_lam_plus_theta * cos_delta
        * (-m_3_12_of_place_4)
            .mul_add(m_3_12_of_place_11, v_FC_1_3_of_w_lam_rr_rf * m_3_12_of_place_7)
        + sin_lam_plus_theta
            * (-v_FC_2_3_of_c_lam_rf)
                .mul_add(m_3_12_of_place_7, m_3_12_of_place_3 * m_3_12_of_place_11);
    let m_3_12_of_place_13 = m_3_12_of_place_5
        * (-v_FC_1_3_of_w_lam_rr_rf)
            .mul_add(m_3_12_of_place_3, v_FC_2_3_of_c_lam_rf * m_3_12_of_place_4)
        - m_3_12_of_place_12;
    let m_3_12_of_place_14 = m_3_12_of_place + m_3_12_of_place_13;
    let sin_lam_cos_delta = sin_lam * cos_delta;
    let m_3_13_of_place = sin_phi_cos_delta.mul_add(S::int(2), m_3_12_of_place_6);
    let m_3_13_of_place_2 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), m_3_12_of_place_9))
        .sqrt()
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + m_3_12_of_place_6 * m_3_13_of_place);
    let m_3_13_of_place_3 = m_3_13_of_place_2 * sin_delta;
    let m_3_13_of_place_4 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    let m_3_13_of_place_5 = -cos_lam_plus_theta
        * (rF * m_3_12_of_place_7.mul_add(m_3_13_of_place_3, -sin_lam_cos_delta)
            + m_3_13_of_place_4) + v_FC_1_3_of_w_lam_rr_rf * sin_lam_plus_theta;
    let m_4_5_of_place = p_w_L_in_B_3_5.mul_add(sin_theta, rR * p_v_Ho_2_14);
    let m_4_5_of_place_2 = p_w_L_in_B_1_5.mul_add(cos_theta, m_4_5_of_place);
    let m_4_6_of_place = p_w_L_in_B_3_6.mul_add(sin_theta, rR * p_v_Ho_2_16);
    let m_4_6_of_place_2 = p_w_L_in_B_1_6.mul_add(cos_theta, m_4_6_of_place);
    let m_4_8_of_place = (-p_w_L_in_B_3_7)
        .mul_add(sin_theta, p_w_L_in_B_1_7 * cos_theta);
    let m_4_9_of_place = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let m_4_9_of_place_2 = (-m_3_12_of_place_3)
        .mul_add(m_3_12_of_place_10, v_FC_2_3_of_c_lam_rf);
    let m_4_9_of_place_3 = m_3_12_of_place_4 * m_3_12_of_place_10;
    let m_4_9_of_place_4 = v_FC_1_3_of_w_lam_rr_rf - m_4_9_of_place_3;
    let m_4_9_of_place_5 = sin_phi * cos_lam_plus_theta;
    let m_4_9_of_place_6 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let m_4_9_of_place_7 = m_3_12_of_place_8 * m_3_12_of_place_11;
    let m_4_9_of_place_8 = m_3_12_of_place_3 * m_4_9_of_place_7;
    let m_4_9_of_place_9 = m_3_12_of_place_4 * m_4_9_of_place_7;
    let m_4_9_of_place_10 = (-m_4_9_of_place)
        .mul_add(m_4_9_of_place_2, m_4_9_of_place_4 * m_4_9_of_place_5);
    let m_4_9_of_place_11 = m_3_12_of_place_3
        * m_4_9_of_place_6.mul_add(m_4_9_of_place_8, m_3_12_of_place_10 * m_4_9_of_place)
        + m_3_12_of_place_4
            * (-m_3_12_of_place_10)
                .mul_add(m_4_9_of_place_5, m_4_9_of_place_6 * m_4_9_of_place_9);
    let m_4_9_of_place_12 = m_4_9_of_place_10 + m_4_9_of_place_11;
    let m_4_9_of_place_13 = m_3_12_of_place - m_4_9_of_place_12;
    let rf_m_3_13_of_place_2 = rF * m_3_13_of_place_2;
    let m_4_13_of_place = sin_delta_sin_phi
        * (c_cos_lam + rF * sin_delta_sin_phi.mul_add(m_3_13_of_place_2, -sin_lam))
        + cos_phi
            * (rR - v_FC_1_3_of_w_lam_rr_rf * cos_lam_plus_theta
                - sin_lam_plus_theta
                    * (rF * m_3_13_of_place.mul_add(m_3_13_of_place_3, -sin_lam_cos_delta)
                        + m_3_13_of_place_4) + rf_m_3_13_of_place_2 * cos_phi);
    let m_5_9_of_place = m_3_12_of_place_4 * sin_delta;
    let m_5_9_of_place_2 = m_3_12_of_place_3
        * m_4_9_of_place_8.mul_add(m_5_9_of_place, m_4_9_of_place_3 * cos_delta)
        + m_3_12_of_place_4
            * m_4_9_of_place_9
                .mul_add(m_5_9_of_place, m_3_12_of_place_2 * m_3_12_of_place_10);
    let m_5_9_of_place_3 = m_3_12_of_place_4
        * m_4_9_of_place_2.mul_add(cos_delta, v_Ho_2_5_of_w_c_lam_rr_2)
        + m_3_12_of_place_2 * m_4_9_of_place_4;
    let m_5_9_of_place_4 = m_5_9_of_place_2 - m_5_9_of_place_3;
    let m_5_12_of_place = cos_lam_plus_theta
        * (rF * m_3_12_of_place_4.mul_add(m_3_13_of_place_2, cos_lam) - rR * cos_lam - w_sin_lam)
        - sin_lam_plus_theta
            * (v_Ho_2_5_of_w_c_lam_rr
                + cos_delta
                    * (c_cos_lam + rF * m_3_12_of_place_3.mul_add(m_3_13_of_place_2, -sin_lam)));
    let m_5_13_of_place = m_3_13_of_place_5 * sin_phi;
    let m_6_9_of_place = m_3_12_of_place_7
        .mul_add(
            m_4_9_of_place_2,
            -m_3_12_of_place_4 * m_3_12_of_place_4 * m_4_9_of_place_8,
        );
    let m_6_9_of_place_2 = m_3_12_of_place_3
        * m_3_12_of_place_3.mul_add(m_4_9_of_place_8, m_3_12_of_place_11) - m_6_9_of_place;
    let m_6_12_of_place = m_3_12_of_place_5 * m_4_9_of_place_2;
    let m_6_13_of_place = m_4_9_of_place_2 * m_4_9_of_place_6;
    let m_8_12_of_place = m_4_9_of_place_6 * rf_m_3_13_of_place_2;
    let m_8_13_of_place = m_3_12_of_place_5 * rf_m_3_13_of_place_2;
    let minus_sin_psi = -sin_psi;
    let minus_cos_psi = -cos_psi;
    let minus_p_w_b_2_6 = -p_w_B_2_6;
    let minus_m_1_2_of_place = -m_1_2_of_place;
    let minus_m_1_3_of_place = -m_1_3_of_place;
    let minus_m_1_5_of_place = -m_1_5_of_place;
    let minus_m_2_3_of_place = -m_2_3_of_place;
    let minus_m_2_5_of_place = -m_2_5_of_place;
    let minus_m_3_5_of_place = -m_3_5_of_place;
    let minus_m_4_5_of_place_2 = -m_4_5_of_place_2;
    let minus_m_4_8_of_place = -m_4_8_of_place;
    // Entries that are not zero.
    let m_1_1 = p_v_N_in_Y_2_3.mul_add(sin_psi, p_v_RC_1_3 * cos_psi);
    let m_1_2 = minus_m_1_2_of_place;
    let m_1_3 = minus_m_1_3_of_place;
    let m_1_4 = m_1_4_of_place;
    let m_1_5 = minus_m_1_5_of_place;
    let m_1_6 = m_1_6_of_place;
    let m_1_10 = minus_cos_psi;
    let m_1_11 = sin_psi;
    let m_1_12 = minus_cos_psi;
    let m_1_13 = sin_psi;
    let m_2_1 = minus_m_1_2_of_place;
    let m_2_2 = p_v_N_in_Y_2_4.mul_add(cos_psi, p_v_RC_1_4 * sin_psi);
    let m_2_3 = minus_m_2_3_of_place;
    let m_2_4 = m_2_4_of_place;
    let m_2_5 = minus_m_2_5_of_place;
    let m_2_6 = m_2_6_of_place;
    let m_2_10 = minus_sin_psi;
    let m_2_11 = minus_cos_psi;
    let m_2_12 = minus_sin_psi;
    let m_2_13 = minus_cos_psi;
    let m_3_1 = minus_m_1_3_of_place;
    let m_3_2 = minus_m_2_3_of_place;
    let m_3_3 = p_w_Y_in_L_2_3.mul_add(sin_phi, p_w_Y_in_L_3_3 * cos_phi);
    let m_3_4 = m_3_4_of_place;
    let m_3_5 = minus_m_3_5_of_place;
    let m_3_6 = m_3_6_of_place;
    let m_3_7 = H_rear_wheel_2_3;
    let m_3_8 = m_3_8_of_place;
    let m_3_12 = m_3_12_of_place_14;
    let m_3_13 = -m_3_13_of_place_5;
    let m_4_1 = m_1_4_of_place;
    let m_4_2 = m_2_4_of_place;
    let m_4_3 = m_3_4_of_place;
    let m_4_4 = rR.mul_add(p_v_RC_2_6, IRxx) + p_w_L_in_B_3_4 * sin_theta
        + p_w_L_in_B_1_4 * cos_theta;
    let m_4_5 = minus_m_4_5_of_place_2;
    let m_4_6 = m_4_6_of_place_2;
    let m_4_8 = minus_m_4_8_of_place;
    let m_4_9 = -m_4_9_of_place_13;
    let m_4_13 = -m_4_13_of_place;
    let m_5_1 = minus_m_1_5_of_place;
    let m_5_2 = minus_m_2_5_of_place;
    let m_5_3 = minus_m_3_5_of_place;
    let m_5_4 = minus_m_4_5_of_place_2;
    let m_5_6 = minus_p_w_b_2_6;
    let m_5_9 = -m_5_9_of_place_4;
    let m_5_12 = m_5_12_of_place;
    let m_5_13 = -m_5_13_of_place;
    let m_6_1 = m_1_6_of_place;
    let m_6_2 = m_2_6_of_place;
    let m_6_3 = m_3_6_of_place;
    let m_6_4 = m_4_6_of_place_2;
    let m_6_5 = minus_p_w_b_2_6;
    let m_6_9 = m_6_9_of_place_2;
    let m_6_12 = m_6_12_of_place;
    let m_6_13 = m_6_13_of_place;
    let m_7_3 = H_rear_wheel_2_3;
    let m_7_7 = IRyy;
    let m_7_10 = -rR;
    let m_8_3 = m_3_8_of_place;
    let m_8_4 = minus_m_4_8_of_place;
    let m_8_8 = IFyy;
    let m_8_12 = -m_8_12_of_place;
    let m_8_13 = m_8_13_of_place;
    let m_9_4 = m_4_9_of_place_13;
    let m_9_5 = m_5_9_of_place_4;
    let m_9_6 = -m_6_9_of_place_2;
    let m_10_1 = cos_psi;
    let m_10_2 = sin_psi;
    let m_10_7 = rR;
    let m_11_1 = minus_sin_psi;
    let m_11_2 = cos_psi;
    let m_12_1 = cos_psi;
    let m_12_2 = sin_psi;
    let m_12_3 = -m_3_12_of_place_14;
    let m_12_5 = -m_5_12_of_place;
    let m_12_6 = -m_6_12_of_place;
    let m_12_8 = m_8_12_of_place;
    let m_13_1 = minus_sin_psi;
    let m_13_2 = cos_psi;
    let m_13_3 = m_3_13_of_place_5;
    let m_13_4 = m_4_13_of_place;
    let m_13_5 = m_5_13_of_place;
    let m_13_6 = -m_6_13_of_place;
    let m_13_8 = -m_8_13_of_place;
    let zero = S::int(0);
    [
        [
            m_1_1, m_1_2, m_1_3, m_1_4, m_1_5, m_1_6, zero, zero, zero, m_1_10, m_1_11, m_1_12,
            m_1_13,
        ],
        [
            m_2_1, m_2_2, m_2_3, m_2_4, m_2_5, m_2_6, zero, zero, zero, m_2_10, m_2_11, m_2_12,
            m_2_13,
        ],
        [
            m_3_1, m_3_2, m_3_3, m_3_4, m_3_5, m_3_6, m_3_7, m_3_8, zero, zero, zero, m_3_12,
            m_3_13,
        ],
        [
            m_4_1, m_4_2, m_4_3, m_4_4, m_4_5, m_4_6, zero, m_4_8, m_4_9, zero, zero, zero, m_4_13,
        ],
        [
            m_5_1, m_5_2, m_5_3, m_5_4, p_w_B_2_5, m_5_6, zero, H_front_wheel_2_5, m_5_9, zero,
            zero, m_5_12, m_5_13,
        ],
        [
            m_6_1, m_6_2, m_6_3, m_6_4, m_6_5, p_w_F_3_6, zero, zero, m_6_9, zero, zero, m_6_12,
            m_6_13,
        ],
        [
            zero, zero, m_7_3, zero, zero, zero, m_7_7, zero, zero, m_7_10, zero, zero, zero,
        ],
        [
            zero, zero, m_8_3, m_8_4, H_front_wheel_2_5, zero, zero, m_8_8, zero, zero, zero,
            m_8_12, m_8_13,
        ],
        [
            zero, zero, zero, m_9_4, m_9_5, m_9_6, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_10_1, m_10_2, zero, zero, zero, zero, m_10_7, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_11_1, m_11_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_12_1, m_12_2, m_12_3, zero, m_12_5, m_12_6, zero, m_12_8, zero, zero, zero, zero,
            zero,
        ],
        [
            m_13_1, m_13_2, m_13_3, m_13_4, m_13_5, m_13_6, zero, m_13_8, zero, zero, zero, zero,
            zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', psi'', phi'', theta'', delta'', thR'', thF'', lambda_contact, lambda_rear_1, lambda_rear_2, lambda_front_1, lambda_front_2).
///
/// 924 operations, 6 sines and cosines, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 8], q_dot: &[S; 8]) -> [S; 13] {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [x, y, psi, phi, theta, delta, _, _] = *q;
    let [x_dot, y_dot, psi_dot, phi_dot, theta_dot, delta_dot, thR_dot, thF_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_Y_in_L_2 = psi_dot * sin_phi;
    let w_Y_in_L_3 = psi_dot * cos_phi;
    let w_L_in_B_1_of_phi_dot = (-phi_dot).mul_add(cos_theta, w_Y_in_L_3 * sin_theta);
    let w_L_in_B_1 = -w_L_in_B_1_of_phi_dot;
    let w_L_in_B_3 = w_Y_in_L_3.mul_add(cos_theta, phi_dot * sin_theta);
    let w_B_2 = theta_dot + w_Y_in_L_2;
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1_of_place = (-w_B_in_S_1).mul_add(cos_delta, w_B_2 * sin_delta);
    let w_S_in_F_1 = -w_S_in_F_1_of_place;
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = delta_dot + w_B_in_S_3;
    let x_Y_in_L_2 = g * sin_phi;
    let x_Y_in_L_3 = g * cos_phi;
    let x_L_in_B_1 = x_Y_in_L_3 * sin_theta;
    let x_L_in_B_3 = x_Y_in_L_3 * cos_theta;
    let x_B_in_S_1 = x_L_in_B_3.mul_add(sin_lam, x_L_in_B_1 * cos_lam);
    let x_B_in_S_3 = (-x_L_in_B_1).mul_add(sin_lam, x_L_in_B_3 * cos_lam);
    let x_S_in_F_1 = (-x_Y_in_L_2).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let x_S_in_F_2 = x_B_in_S_1.mul_add(sin_delta, x_Y_in_L_2 * cos_delta);
    let v_N_in_Y_1 = y_dot.mul_add(sin_psi, x_dot * cos_psi);
    let v_N_in_Y_2 = (-y_dot).mul_add(cos_psi, x_dot * sin_psi);
    let v_Y_in_L_2 = v_N_in_Y_2 * cos_phi;
    let v_Y_in_L_3 = v_N_in_Y_2 * sin_phi;
    let v_RC_1 = rR.mul_add(w_Y_in_L_2, -v_N_in_Y_1);
    let rr_phi_dot = rR * phi_dot;
    let v_RC_2 = rr_phi_dot - v_Y_in_L_2;
    let v_L_in_B_1 = v_RC_1.mul_add(cos_theta, v_Y_in_L_3 * sin_theta);
    let v_L_in_B_3 = (-v_RC_1).mul_add(sin_theta, v_Y_in_L_3 * cos_theta);
    let rr_plus_zb = rR + zB;
    let v_Bo_1 = w_B_2.mul_add(rr_plus_zb, -v_L_in_B_1);
    let v_Bo_2 = xB.mul_add(w_L_in_B_3, v_RC_2) - w_L_in_B_1 * rr_plus_zb;
    let v_Bo_3 = xB.mul_add(w_B_2, -v_L_in_B_3);
    let v_B_in_S_1 = v_L_in_B_3.mul_add(sin_lam, v_L_in_B_1 * cos_lam);
    let v_B_in_S_3 = (-v_L_in_B_1).mul_add(sin_lam, v_L_in_B_3 * cos_lam);
    let v_Ho_2_of_w_c_lam_rr = -cos_lam * (w + c) + rR * sin_lam;
    let v_Ho_2_of_w_c_lam_rr_2 = -v_Ho_2_of_w_c_lam_rr;
    let v_Ho_2 = w_B_in_S_3.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_RC_2);
    let v_Ho_3_of_place = w_B_2 * v_Ho_2_of_w_c_lam_rr_2;
    let v_Ho_3 = v_Ho_3_of_place - v_B_in_S_3;
    let v_S_in_F_1 = (-v_Ho_2).mul_add(sin_delta, v_B_in_S_1 * cos_delta);
    let v_S_in_F_2 = v_Ho_2.mul_add(cos_delta, v_B_in_S_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let v_Ho_1_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let v_Ho_1 = w_S_in_F_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_1);
    let v_Ho_2_2_of_place = (-xH).mul_add(cos_lam, rr_plus_zh * sin_lam) - v_Ho_2_of_w_c_lam_rr;
    let v_Ho_2_2 = w_F_3.mul_add(v_Ho_2_2_of_place, -v_S_in_F_2)
        - w_S_in_F_1 * v_Ho_1_of_lam_rr_xh_zh;
    let v_Ho_3_2 = w_S_in_F_2.mul_add(v_Ho_2_2_of_place, -v_Ho_3);
    let v_FC_1_of_w_lam_rr_rf = cos_lam * (rR - rF) + w * sin_lam;
    let v_FC_1 = w_S_in_F_2.mul_add(v_FC_1_of_w_lam_rr_rf, -v_S_in_F_1);
    let v_FC_2_of_c_lam_rf = (-c).mul_add(cos_lam, rF * sin_lam);
    let v_FC_2 = w_S_in_F_1.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2) + w_F_3 * v_FC_2_of_c_lam_rf;
    let v_FC_3 = w_S_in_F_2.mul_add(v_FC_2_of_c_lam_rf, v_Ho_3);
    let p_v_FC_3 = mF * v_FC_3;
    let p_v_FC_2 = mF * v_FC_2;
    let p_v_FC_1 = mF * v_FC_1;
    let p_v_Ho_3 = mH * v_Ho_3_2;
    let p_v_Ho_2 = mH * v_Ho_2_2;
    let p_v_Ho_1 = mH * v_Ho_1;
    let p_v_S_in_F_2 = p_v_FC_2 - p_v_Ho_2;
    let p_v_S_in_F_1 = p_v_FC_1 + p_v_Ho_1;
    let p_v_Ho_3_2 = p_v_FC_3 - p_v_Ho_3;
    let p_v_Ho_2_2 = p_v_S_in_F_1.mul_add(sin_delta, p_v_S_in_F_2 * cos_delta);
    let p_v_B_in_S_1 = (-p_v_S_in_F_1).mul_add(cos_delta, p_v_S_in_F_2 * sin_delta);
    let p_v_Bo_3 = mB * v_Bo_3;
    let p_v_Bo_2 = mB * v_Bo_2;
    let p_v_Bo_1 = mB * v_Bo_1;
    let p_v_L_in_B_3 = (-p_v_B_in_S_1).mul_add(sin_lam, p_v_Ho_3_2 * cos_lam) + p_v_Bo_3;
    let p_v_L_in_B_1 = p_v_B_in_S_1.mul_add(cos_lam, p_v_Ho_3_2 * sin_lam) - p_v_Bo_1;
    let p_v_RC_2 = mR.mul_add(v_RC_2, p_v_Ho_2_2) + p_v_Bo_2;
    let p_v_RC_1_of_place = p_v_L_in_B_1.mul_add(cos_theta, p_v_L_in_B_3 * sin_theta);
    let p_v_RC_1 = mR.mul_add(v_RC_1, p_v_RC_1_of_place);
    let p_v_Y_in_L_3_of_place = (-p_v_L_in_B_1)
        .mul_add(sin_theta, p_v_L_in_B_3 * cos_theta);
    let p_v_Y_in_L_3 = mR.mul_add(v_Y_in_L_3, -p_v_Y_in_L_3_of_place);
    let p_v_N_in_Y_2 = (-p_v_RC_2).mul_add(cos_phi, p_v_Y_in_L_3 * sin_phi);
    let F_x_F_1 = x_S_in_F_2.mul_add(sin_delta, x_S_in_F_1 * cos_delta);
    let F_x_F_3 = F_x_F_1.mul_add(sin_lam, x_B_in_S_3 * cos_lam);
    let F_x_F_1_2 = (-F_x_F_1).mul_add(cos_lam, x_B_in_S_3 * sin_lam);
    let F_x_F_3_2 = (-F_x_F_1_2).mul_add(sin_theta, F_x_F_3 * cos_theta);
    let F_x_Y_in_L_2 = (-x_S_in_F_1).mul_add(sin_delta, x_S_in_F_2 * cos_delta);
    let F_x_N_in_Y_2 = (-F_x_Y_in_L_2).mul_add(cos_phi, F_x_F_3_2 * sin_phi);
    let F_x_N_in_Y_1 = F_x_F_1_2.mul_add(cos_theta, F_x_F_3 * sin_theta);
    let F_mp_N_1 = F_x_N_in_Y_1.mul_add(cos_psi, F_x_N_in_Y_2 * sin_psi);
    let phi_dot_cos_phi = phi_dot * cos_phi;
    let w_Y_in_L_2_2 = psi_dot * phi_dot_cos_phi;
    let phi_dot_sin_phi = phi_dot * sin_phi;
    let w_Y_in_L_3_2 = psi_dot * phi_dot_sin_phi;
    let w_L_in_B_1_2 = (-w_Y_in_L_3_2).mul_add(sin_theta, theta_dot * w_L_in_B_3);
    let w_L_in_B_3_2 = (-theta_dot)
        .mul_add(w_L_in_B_1_of_phi_dot, -w_Y_in_L_3_2 * cos_theta);
    let w_B_in_S_1_2 = w_L_in_B_3_2.mul_add(sin_lam, w_L_in_B_1_2 * cos_lam);
    let w_B_in_S_3_2 = (-w_L_in_B_1_2).mul_add(sin_lam, w_L_in_B_3_2 * cos_lam);
    let delta_dot_sin_delta = delta_dot * sin_delta;
    let delta_dot_cos_delta = delta_dot * cos_delta;
    let w_S_in_F_1_2 = (-w_B_in_S_1_2).mul_add(cos_delta, w_Y_in_L_2_2 * sin_delta)
        + w_B_in_S_1 * delta_dot_sin_delta + w_B_2 * delta_dot_cos_delta;
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_Y_in_L_2_2 * cos_delta)
        - w_B_2 * delta_dot_sin_delta + w_B_in_S_1 * delta_dot_cos_delta;
    let psi_dot_v_n_in_y_2 = psi_dot * v_N_in_Y_2;
    let v_N_in_Y_1_2 = psi_dot_v_n_in_y_2;
    let psi_dot_v_n_in_y_1 = psi_dot * v_N_in_Y_1;
    let v_N_in_Y_2_2 = psi_dot_v_n_in_y_1;
    let v_Y_in_L_2_2 = (-v_N_in_Y_2_2).mul_add(cos_phi, v_N_in_Y_2 * phi_dot_sin_phi);
    let v_Y_in_L_3_2 = v_N_in_Y_2.mul_add(phi_dot_cos_phi, v_N_in_Y_2_2 * sin_phi);
    let v_RC_1_2 = rR.mul_add(w_Y_in_L_2_2, v_N_in_Y_1_2);
    let v_L_in_B_1_2 = v_Y_in_L_3_2.mul_add(sin_theta, theta_dot * v_L_in_B_3)
        + v_RC_1_2 * cos_theta;
    let v_L_in_B_3_2 = (-v_Y_in_L_3_2).mul_add(cos_theta, theta_dot * v_L_in_B_1)
        + v_RC_1_2 * sin_theta;
    let v_Bo_1_2 = w_Y_in_L_2_2.mul_add(rr_plus_zb, -v_L_in_B_1_2);
    let v_Bo_2_2 = xB.mul_add(w_L_in_B_3_2, v_Y_in_L_2_2) + w_L_in_B_1_2 * rr_plus_zb;
    let v_Bo_3_2 = xB.mul_add(w_Y_in_L_2_2, v_L_in_B_3_2);
    let v_B_in_S_1_2 = (-v_L_in_B_1_2).mul_add(cos_lam, v_L_in_B_3_2 * sin_lam);
    let v_B_in_S_3_2 = v_L_in_B_3_2.mul_add(cos_lam, v_L_in_B_1_2 * sin_lam);
    let v_Ho_2_3 = w_B_in_S_3_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_Y_in_L_2_2);
    let v_Ho_3_3 = w_Y_in_L_2_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_B_in_S_3_2);
    let v_S_in_F_1_2 = v_Ho_2_3.mul_add(sin_delta, v_B_in_S_1_2 * cos_delta)
        + v_B_in_S_1 * delta_dot_sin_delta + v_Ho_2 * delta_dot_cos_delta;
    let v_S_in_F_2_2 = (-v_B_in_S_1_2).mul_add(sin_delta, v_Ho_2_3 * cos_delta)
        - v_Ho_2 * delta_dot_sin_delta + v_B_in_S_1 * delta_dot_cos_delta;
    let v_Ho_1_2 = w_S_in_F_2_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_1_2);
    let v_Ho_2_4 = w_S_in_F_1_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_2_2)
        + w_B_in_S_3_2 * v_Ho_2_2_of_place;
    let v_Ho_3_4 = w_S_in_F_2_2.mul_add(v_Ho_2_2_of_place, -v_Ho_3_3);
    let v_FC_1_2 = w_S_in_F_2_2.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_1_2);
    let v_FC_2_2 = (-w_S_in_F_1_2).mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2_2)
        + w_B_in_S_3_2 * v_FC_2_of_c_lam_rf;
    let v_FC_3_2 = w_S_in_F_2_2.mul_add(v_FC_2_of_c_lam_rf, v_Ho_3_3);
    let p_v_FC_3_2 = mF * v_FC_3_2;
    let p_v_FC_2_2 = mF * v_FC_2_2;
    let p_v_FC_1_2 = mF * v_FC_1_2;
    let p_v_Ho_3_3 = mH * v_Ho_3_4;
    let p_v_Ho_2_3 = mH * v_Ho_2_4;
    let p_v_Ho_1_2 = mH * v_Ho_1_2;
    let p_v_S_in_F_2_2 = p_v_FC_2_2 - p_v_Ho_2_3;
    let p_v_S_in_F_1_2 = p_v_FC_1_2 + p_v_Ho_1_2;
    let p_v_Ho_3_4 = p_v_FC_3_2 - p_v_Ho_3_3;
    let p_v_Ho_2_4 = (-p_v_S_in_F_2_2)
        .mul_add(cos_delta, p_v_S_in_F_2 * delta_dot_sin_delta)
        - p_v_S_in_F_1_2 * sin_delta - p_v_S_in_F_1 * delta_dot_cos_delta;
    let p_v_B_in_S_1_2 = (-p_v_S_in_F_1_2).mul_add(cos_delta, p_v_S_in_F_2_2 * sin_delta)
        + p_v_S_in_F_1 * delta_dot_sin_delta + p_v_S_in_F_2 * delta_dot_cos_delta;
    let p_v_Bo_3_2 = mB * v_Bo_3_2;
    let p_v_Bo_2_2 = mB * v_Bo_2_2;
    let p_v_Bo_1_2 = mB * v_Bo_1_2;
    let p_v_L_in_B_3_2 = (-p_v_B_in_S_1_2).mul_add(sin_lam, p_v_Ho_3_4 * cos_lam) + p_v_Bo_3_2;
    let p_v_L_in_B_1_2 = p_v_B_in_S_1_2.mul_add(cos_lam, p_v_Ho_3_4 * sin_lam) - p_v_Bo_1_2;
    let p_v_RC_2_2 = mR.mul_add(v_Y_in_L_2_2, -p_v_Ho_2_4) + p_v_Bo_2_2;
    let p_v_RC_1_2 = p_v_L_in_B_3_2.mul_add(sin_theta, mR * v_RC_1_2)
        + p_v_L_in_B_1_2 * cos_theta + theta_dot * p_v_Y_in_L_3_of_place;
    let p_v_Y_in_L_3_2 = (-p_v_L_in_B_3_2).mul_add(cos_theta, mR * v_Y_in_L_3_2)
        + p_v_L_in_B_1_2 * sin_theta + theta_dot * p_v_RC_1_of_place;
    let p_v_N_in_Y_2_2 = (-p_v_RC_2_2).mul_add(cos_phi, p_v_Y_in_L_3_2 * sin_phi)
        + p_v_Y_in_L_3 * phi_dot_cos_phi + p_v_RC_2 * phi_dot_sin_phi;
    let F_mp_N_2 = (-F_x_N_in_Y_1).mul_add(sin_psi, F_x_N_in_Y_2 * cos_psi);
    let w_RW_2 = thR_dot + w_Y_in_L_2;
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let w_FW_2 = thF_dot + w_S_in_F_2;
    let mh_plus_mf = mH + mF;
    let mr_plus_mb = mR + mB;
    let mp_N_1_of_mr_mb_mh_mf = mh_plus_mf + mr_plus_mb;
    let mp_N_1 = x * mp_N_1_of_mr_mb_mh_mf;
    let mp_N_2 = y * mp_N_1_of_mr_mb_mh_mf;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let p_w_F_3 = H_fork_3.mul_add(cos_lam, H_fork_1 * sin_lam) + H_front_wheel_3
        + p_v_Ho_2 * v_Ho_2_2_of_place + p_v_FC_2 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_2 = p_v_Ho_1
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2 + H_front_wheel_2)
        + p_v_Ho_3 * v_Ho_2_2_of_place + p_v_FC_1 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1 = (-H_fork_1).mul_add(cos_lam, H_fork_3 * sin_lam) + H_front_wheel_1
        - p_v_Ho_2 * v_Ho_1_of_lam_rr_xh_zh + p_v_FC_2 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3 = p_v_Ho_2_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3);
    let p_w_B_in_S_1 = p_w_S_in_F_1.mul_add(cos_delta, p_w_S_in_F_2 * sin_delta);
    let p_w_B_2 = xB.mul_add(p_v_Bo_3, H_frame_2) + p_w_S_in_F_2 * cos_delta
        - p_w_S_in_F_1 * sin_delta + p_v_Bo_1 * rr_plus_zb + p_v_Ho_3_2 * v_Ho_2_of_w_c_lam_rr_2;
    let p_w_L_in_B_3 = xB.mul_add(p_v_Bo_2, H_frame_3) + p_w_B_in_S_3 * cos_lam
        + p_w_B_in_S_1 * sin_lam;
    let p_w_L_in_B_1 = p_w_B_in_S_3.mul_add(sin_lam, H_frame_1) - p_w_B_in_S_1 * cos_lam
        - p_v_Bo_2 * rr_plus_zb;
    let p_w_Y_in_L_3_of_place = (-p_w_L_in_B_1)
        .mul_add(sin_theta, p_w_L_in_B_3 * cos_theta);
    let p_w_Y_in_L_3 = H_rear_wheel_3 + p_w_Y_in_L_3_of_place;
    let p_w_Y_in_L_2 = rR.mul_add(p_v_RC_1, H_rear_wheel_2) + p_w_B_2;
    let w_F_in_H_1_2 = w_S_in_F_1_2.mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let w_F_in_H_3_2 = (-w_S_in_F_1_2).mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let H_rear_wheel_2_2 = IRyy * w_Y_in_L_2_2;
    let H_rear_wheel_3_2 = IRxx * w_Y_in_L_3_2;
    let H_frame_1_2 = (-IBxz).mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let H_frame_2_2 = IByy * w_Y_in_L_2_2;
    let H_frame_3_2 = (-IBzz).mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let H_fork_1_2 = IHxz.mul_add(w_F_in_H_3_2, IHxx * w_F_in_H_1_2);
    let H_fork_2_2 = IHyy * w_S_in_F_2_2;
    let H_fork_3_2 = IHzz.mul_add(w_F_in_H_3_2, IHxz * w_F_in_H_1_2);
    let H_front_wheel_1_2 = IFxx * w_S_in_F_1_2;
    let H_front_wheel_2_2 = IFyy * w_S_in_F_2_2;
    let H_front_wheel_3_2 = IFxx * w_B_in_S_3_2;
    let p_w_F_3_2 = H_fork_3_2.mul_add(cos_lam, H_fork_1_2 * sin_lam) + H_front_wheel_3_2
        + p_v_Ho_2_3 * v_Ho_2_2_of_place + p_v_FC_2_2 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_2_2 = p_v_Ho_1_2
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2_2 + H_front_wheel_2_2)
        + p_v_Ho_3_3 * v_Ho_2_2_of_place + p_v_FC_1_2 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3_2 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1_2 = (-H_fork_3_2).mul_add(sin_lam, H_fork_1_2 * cos_lam)
        + H_front_wheel_1_2 + p_v_Ho_2_3 * v_Ho_1_of_lam_rr_xh_zh
        - p_v_FC_2_2 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_2 = p_v_Ho_2_4.mul_add(v_Ho_2_of_w_c_lam_rr_2, -p_w_F_3_2);
    let p_w_B_in_S_1_2 = (-p_w_S_in_F_1_2).mul_add(cos_delta, p_w_S_in_F_2_2 * sin_delta)
        - p_w_S_in_F_1 * delta_dot_sin_delta + p_w_S_in_F_2 * delta_dot_cos_delta;
    let p_w_B_2_2 = xB.mul_add(p_v_Bo_3_2, H_frame_2_2) + p_w_S_in_F_2_2 * cos_delta
        + p_w_S_in_F_1_2 * sin_delta + p_v_Bo_1_2 * rr_plus_zb
        + p_v_Ho_3_4 * v_Ho_2_of_w_c_lam_rr_2 - p_w_S_in_F_2 * delta_dot_sin_delta
        - p_w_S_in_F_1 * delta_dot_cos_delta;
    let p_w_L_in_B_3_2 = (-xB).mul_add(p_v_Bo_2_2, H_frame_3_2)
        + p_w_B_in_S_3_2 * cos_lam - p_w_B_in_S_1_2 * sin_lam;
    let p_w_L_in_B_1_2 = p_w_B_in_S_3_2.mul_add(sin_lam, H_frame_1_2)
        + p_w_B_in_S_1_2 * cos_lam + p_v_Bo_2_2 * rr_plus_zb;
    let p_w_Y_in_L_3_2 = theta_dot
        * p_w_L_in_B_1.mul_add(cos_theta, p_w_L_in_B_3 * sin_theta) + H_rear_wheel_3_2
        + p_w_L_in_B_3_2 * cos_theta - p_w_L_in_B_1_2 * sin_theta;
    let p_w_Y_in_L_2_2 = rR.mul_add(p_v_RC_1_2, H_rear_wheel_2_2) + p_w_B_2_2;
    let mp_L_3 = rR * mp_N_1_of_mr_mb_mh_mf;
    let mp_B_1 = xB * mB;
    let mp_B_3 = mB * rr_plus_zb;
    let mp_S_1 = v_Ho_2_of_w_c_lam_rr_2 * mh_plus_mf;
    let mp_F_1 = (-mF).mul_add(v_FC_2_of_c_lam_rf, mH * v_Ho_2_2_of_place);
    let mp_F_3 = mF.mul_add(v_FC_1_of_w_lam_rr_rf, mH * v_Ho_1_of_lam_rr_xh_zh);
    let x_N_in_Y_1 = mp_N_2.mul_add(sin_psi, mp_N_1 * cos_psi);
    let x_N_in_Y_2_of_place = (-mp_N_1).mul_add(sin_psi, mp_N_2 * cos_psi);
    let x_N_in_Y_2 = -x_N_in_Y_2_of_place;
    let x_Y_in_L_2_2 = x_N_in_Y_2 * cos_phi;
    let x_Y_in_L_3_2 = x_N_in_Y_2 * sin_phi;
    let x_F_3 = mp_L_3 - x_Y_in_L_3_2;
    let x_L_in_B_1_2 = x_F_3.mul_add(sin_theta, x_N_in_Y_1 * cos_theta);
    let x_L_in_B_3_2 = (-x_N_in_Y_1).mul_add(sin_theta, x_F_3 * cos_theta);
    let x_F_1 = mp_B_1 + x_L_in_B_1_2;
    let x_F_3_2 = mp_B_3 - x_L_in_B_3_2;
    let x_B_in_S_1_2 = (-x_F_1).mul_add(cos_lam, x_F_3_2 * sin_lam);
    let x_B_in_S_3_2 = x_F_3_2.mul_add(cos_lam, x_F_1 * sin_lam);
    let x_F_1_2 = mp_S_1 - x_B_in_S_1_2;
    let x_S_in_F_1_2 = (-x_Y_in_L_2_2).mul_add(sin_delta, x_F_1_2 * cos_delta);
    let x_S_in_F_2_2 = x_F_1_2.mul_add(sin_delta, x_Y_in_L_2_2 * cos_delta);
    let x_F_1_3 = mp_F_1 - x_S_in_F_1_2;
    let x_F_3_3 = mp_F_3 + x_B_in_S_3_2;
    let F_x_B_in_S_1 = (-x_F_1_3).mul_add(cos_delta, x_S_in_F_2_2 * sin_delta);
    let F_x_L_in_B_3 = (-F_x_B_in_S_1).mul_add(sin_lam, x_F_3_3 * cos_lam);
    let F_x_L_in_B_1 = F_x_B_in_S_1.mul_add(cos_lam, x_F_3_3 * sin_lam);
    let F_x_Y_in_L_3 = (-F_x_L_in_B_1).mul_add(sin_theta, F_x_L_in_B_3 * cos_theta);
    let F_x_Y_in_L_2_2 = x_F_1_3.mul_add(sin_delta, x_S_in_F_2_2 * cos_delta);
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let f_9_of_theta_dot = theta_dot * cos_lam_plus_theta;
    let f_9_of_motion = f_9_of_theta_dot.mul_add(sin_phi, delta_dot * cos_phi);
    let f_9_of_motion_2 = theta_dot.mul_add(theta_dot, phi_dot * phi_dot);
    let f_9_of_place = cos_phi * sin_lam_plus_theta;
    let f_9_of_motion_3 = f_9_of_motion_2 * f_9_of_place;
    let f_9_of_motion_4 = (phi_dot * f_9_of_motion).mul_add(S::int(2), f_9_of_motion_3);
    let f_9_of_place_2 = cos_phi * cos_lam_plus_theta;
    let f_9_of_phi_dot = phi_dot_sin_phi * sin_lam_plus_theta;
    let f_9_of_motion_5 = (-theta_dot).mul_add(f_9_of_place_2, f_9_of_phi_dot);
    let f_9_of_motion_6 = f_9_of_motion_5.mul_add(S::int(2), delta_dot * sin_phi);
    let phi_dot_sin_delta = phi_dot * sin_delta;
    let f_9_of_delta_dot = delta_dot_cos_delta * f_9_of_place;
    let f_9_of_motion_7 = (-delta_dot_sin_delta)
        .mul_add(f_9_of_motion_6, f_9_of_motion_4 * cos_delta)
        - phi_dot_sin_phi * phi_dot_sin_delta + delta_dot * f_9_of_delta_dot;
    let f_9_of_place_3 = (-f_9_of_place).mul_add(cos_delta, sin_phi * sin_delta);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let f_9_of_place_4 = f_9_of_place.mul_add(sin_delta, sin_phi_cos_delta);
    let f_9_of_place_5 = S::int(1) / f_9_of_place_4.mul_add(f_9_of_place_4, -S::int(1));
    let f_9_of_place_6 = rF * f_9_of_place_5
        * (S::int(1)
            - (cos_phi * sin_lam_plus_theta)
                .mul_add(sin_delta, sin_phi_cos_delta)
                .powi(2))
            .sqrt();
    let f_9_of_place_7 = f_9_of_place_3 * f_9_of_place_6;
    let f_9_of_place_8 = v_FC_2_of_c_lam_rf - f_9_of_place_7;
    let f_9_of_motion_8 = (-delta_dot_sin_delta)
        .mul_add(sin_phi, phi_dot_cos_phi * cos_delta) - f_9_of_motion_5 * sin_delta
        + f_9_of_delta_dot;
    let f_9_of_motion_9 = f_9_of_place_6 * f_9_of_motion_8;
    let f_9_of_place_9 = f_9_of_place_4 * f_9_of_place_5;
    let f_9_of_phi_dot_2 = phi_dot_sin_phi * cos_delta;
    let f_9_of_delta_dot_2 = delta_dot_sin_delta * f_9_of_place;
    let f_9_of_motion_10 = f_9_of_motion_8 * f_9_of_motion_9
        * (f_9_of_place_5 - S::int(3) * f_9_of_place_9 * f_9_of_place_9)
        - f_9_of_place_6 * f_9_of_place_9
            * (delta_dot_cos_delta.mul_add(f_9_of_motion_6, f_9_of_motion_4 * sin_delta)
                + phi_dot * f_9_of_phi_dot_2 + delta_dot * f_9_of_delta_dot_2);
    let f_9_of_motion_11 = f_9_of_motion_9 * f_9_of_place_9;
    let f_9_of_motion_12 = delta_dot_cos_delta
        .mul_add(sin_phi, phi_dot_cos_phi * sin_delta) + f_9_of_motion_5 * cos_delta
        + f_9_of_delta_dot_2;
    let f_9_of_motion_12_doubled = S::int(2) * f_9_of_motion_12;
    let f_9_of_motion_13 = (-f_9_of_motion_2)
        .mul_add(f_9_of_place_2, S::int(2) * theta_dot * f_9_of_phi_dot);
    let f_9_of_motion_14 = theta_dot
        .mul_add(f_9_of_place, phi_dot_sin_phi * cos_lam_plus_theta);
    let f_9_of_motion_14_doubled = S::int(2) * f_9_of_motion_14;
    let f_9_of_place_10 = f_9_of_place_2 * f_9_of_place_6;
    let f_9_of_place_11 = v_FC_1_of_w_lam_rr_rf - f_9_of_place_10;
    let f_9_of_motion_15 = (-f_9_of_place_6)
        .mul_add(f_9_of_motion_12, f_9_of_place_3 * f_9_of_motion_11);
    let f_9_of_motion_16 = f_9_of_place_6
        .mul_add(f_9_of_motion_14, f_9_of_place_2 * f_9_of_motion_11);
    let f_9_of_phi_dot_3 = v_Ho_2_of_w_c_lam_rr_2 * phi_dot_sin_phi;
    let psi_dot_f_9_of_place_2 = psi_dot * f_9_of_place_2;
    let f_12_of_motion = phi_dot.mul_add(sin_lam_plus_theta, psi_dot_f_9_of_place_2);
    let f_12_of_motion_2 = delta_dot + f_12_of_motion;
    let f_12_of_place = cos_lam_plus_theta * cos_delta;
    let theta_dot_sin_delta = theta_dot * sin_delta;
    let f_12_of_motion_3 = phi_dot.mul_add(f_12_of_place, psi_dot * f_9_of_place_3)
        + theta_dot_sin_delta;
    let f_12_of_motion_4 = (-phi_dot)
        .mul_add(f_9_of_theta_dot, psi_dot * f_9_of_motion_14);
    let theta_dot_cos_delta = theta_dot * cos_delta;
    let f_12_of_motion_5 = theta_dot_cos_delta
        .mul_add(sin_lam_plus_theta, delta_dot_sin_delta * cos_lam_plus_theta);
    let f_12_of_motion_6 = f_9_of_motion_16 * f_12_of_motion_3
        - f_9_of_motion_15 * f_12_of_motion_2 + f_9_of_place_8 * f_12_of_motion_4
        + f_9_of_place_11
            * (psi_dot.mul_add(f_9_of_motion_12, theta_dot * delta_dot_cos_delta)
                - phi_dot * f_12_of_motion_5);
    let f_12_of_motion_7 = (-phi_dot_sin_delta)
        .mul_add(cos_lam_plus_theta, psi_dot * f_9_of_place_4);
    let f_12_of_motion_8 = theta_dot_cos_delta + f_12_of_motion_7;
    let f_12_of_motion_9 = thF_dot + f_12_of_motion_8;
    let f_12_of_motion_10 = (-delta_dot_cos_delta)
        .mul_add(cos_lam_plus_theta, theta_dot_sin_delta * sin_lam_plus_theta);
    let f_12_of_motion_11 = (-theta_dot)
        .mul_add(delta_dot_sin_delta, psi_dot * f_9_of_motion_8) + phi_dot * f_12_of_motion_10;
    let f_12_of_motion_12 = f_9_of_place_8
        .mul_add(f_12_of_motion_11, f_9_of_motion_15 * f_12_of_motion_9);
    let f_12_of_motion_13 = (-f_9_of_place_10)
        .mul_add(f_12_of_motion_9, v_FC_1_of_w_lam_rr_rf * f_12_of_motion_8);
    let f_12_of_motion_14 = (-f_9_of_place_11)
        .mul_add(f_12_of_motion_3, f_9_of_place_8 * f_12_of_motion_2);
    let f_12_of_motion_15 = (-f_9_of_place_7)
        .mul_add(f_12_of_motion_9, v_FC_2_of_c_lam_rf * f_12_of_motion_8);
    let f_12_of_motion_16 = v_Ho_3_of_place + f_12_of_motion_15;
    let f_12_of_motion_17 = f_9_of_place_11
        .mul_add(f_12_of_motion_11, f_9_of_motion_16 * f_12_of_motion_9);
    let phi_dot_f_9_of_place = phi_dot * f_9_of_place;
    let f_13_of_place = sin_phi * sin_lam_plus_theta;
    let f_13_of_motion = f_9_of_motion + phi_dot_f_9_of_place;
    // Values.
    let f_1 = -psi_dot * p_v_N_in_Y_2.mul_add(cos_psi, p_v_RC_1 * sin_psi)
        + p_v_RC_1_2 * cos_psi - p_v_N_in_Y_2_2 * sin_psi + F_mp_N_1 * mp_N_1_of_mr_mb_mh_mf;
    let f_2 = psi_dot * (-p_v_N_in_Y_2).mul_add(sin_psi, p_v_RC_1 * cos_psi)
        + p_v_RC_1_2 * sin_psi + p_v_N_in_Y_2_2 * cos_psi - F_mp_N_2 * mp_N_1_of_mr_mb_mh_mf;
    let f_3 = v_N_in_Y_1.mul_add(p_v_N_in_Y_2, v_N_in_Y_2 * p_v_RC_1)
        + p_w_Y_in_L_3_2 * cos_phi - p_w_Y_in_L_2_2 * sin_phi + F_x_N_in_Y_2 * x_N_in_Y_1
        - p_w_Y_in_L_2 * phi_dot_cos_phi + p_w_Y_in_L_3 * phi_dot_sin_phi
        + F_x_N_in_Y_1 * x_N_in_Y_2_of_place;
    let f_4 = p_w_L_in_B_3_2 * sin_theta - rR * p_v_RC_2_2 + p_w_L_in_B_1_2 * cos_theta
        + sin_phi
            * ((-psi_dot).mul_add(p_w_Y_in_L_3, v_N_in_Y_2 * p_v_RC_2)
                + F_x_Y_in_L_2 * x_N_in_Y_2 - g * F_x_Y_in_L_3)
        + cos_phi
            * ((-g).mul_add(F_x_Y_in_L_2_2, v_N_in_Y_2 * p_v_Y_in_L_3)
                + psi_dot * p_w_Y_in_L_2 + F_x_F_3_2 * x_N_in_Y_2)
        - theta_dot * p_w_Y_in_L_3_of_place;
    let f_5 = v_L_in_B_3.mul_add(p_v_L_in_B_1, v_L_in_B_1 * p_v_L_in_B_3)
        - w_L_in_B_3 * p_w_L_in_B_1 - p_w_B_2_2 + F_x_F_3 * x_L_in_B_1_2
        + F_x_F_1_2 * x_L_in_B_3_2 - x_L_in_B_1 * F_x_L_in_B_3
        - x_L_in_B_3 * F_x_L_in_B_1 - p_w_L_in_B_3 * w_L_in_B_1_of_phi_dot;
    let f_6 = v_S_in_F_2.mul_add(p_v_S_in_F_1, v_S_in_F_1 * p_v_S_in_F_2)
        - w_S_in_F_2 * p_w_S_in_F_1 - p_w_F_3_2 - x_S_in_F_2 * x_S_in_F_1_2
        - x_S_in_F_2 * x_F_1_3 - p_w_S_in_F_2 * w_S_in_F_1_of_place;
    let f_7 = -H_rear_wheel_2_2;
    let f_8 = -H_front_wheel_2_2;
    let f_9 = f_9_of_place_3
        * ((-f_9_of_place_3).mul_add(f_9_of_motion_10, f_9_of_motion_7 * f_9_of_place_6)
            - f_9_of_motion_11 * f_9_of_motion_12_doubled) - rr_phi_dot * phi_dot_cos_phi
        - v_Ho_2_of_w_c_lam_rr_2 * f_9_of_motion_3 - f_9_of_motion_7 * f_9_of_place_8
        + f_9_of_place_2
            * ((-f_9_of_place_2)
                .mul_add(f_9_of_motion_10, f_9_of_place_6 * f_9_of_motion_13)
                + f_9_of_motion_11 * f_9_of_motion_14_doubled) - f_9_of_motion_13 * f_9_of_place_11
        - f_9_of_motion_12_doubled * f_9_of_motion_15 + f_9_of_motion_14_doubled * f_9_of_motion_16
        - S::int(2) * f_9_of_theta_dot * f_9_of_phi_dot_3;
    let f_10 = psi_dot_v_n_in_y_2;
    let f_11 = psi_dot_v_n_in_y_1;
    let f_12 = (-(f_12_of_motion_6 * cos_lam_plus_theta)).mul_add(sin_delta, v_RC_1_2)
        + f_12_of_motion_12 * sin_lam_plus_theta + f_12_of_motion_5 * f_12_of_motion_13
        - f_12_of_motion_10 * f_12_of_motion_14 + f_9_of_theta_dot * f_12_of_motion_16
        - f_12_of_place * f_12_of_motion_17
        + psi_dot * v_Ho_2_of_w_c_lam_rr_2 * phi_dot_f_9_of_place;
    let f_13 = v_N_in_Y_2_2 + rr_phi_dot * phi_dot_sin_phi
        + f_9_of_phi_dot_3 * (f_12_of_motion - psi_dot_f_9_of_place_2)
        + v_Ho_2_of_w_c_lam_rr_2 * f_12_of_motion_4 * cos_phi
        - f_12_of_motion_12 * sin_phi * cos_lam_plus_theta
        - f_12_of_motion_17 * f_13_of_place.mul_add(cos_delta, cos_phi * sin_delta)
        + f_12_of_motion_16 * (-phi_dot).mul_add(f_9_of_place_2, theta_dot * f_13_of_place)
        + f_12_of_motion_6 * (-f_13_of_place).mul_add(sin_delta, cos_phi * cos_delta)
        + f_12_of_motion_14
            * (delta_dot_cos_delta.mul_add(f_13_of_place, f_9_of_phi_dot_2)
                + f_13_of_motion * sin_delta)
        + f_12_of_motion_13
            * (delta_dot_sin_delta.mul_add(f_13_of_place, phi_dot_sin_phi * sin_delta)
                - f_13_of_motion * cos_delta);
    [f_1, f_2, f_3, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13]
}

/// The accelerations (x'', y'', psi'', phi'', theta'', delta'', thR'', thF''), solved for when this code was generated.
///
/// 2311 operations, 6 sines and cosines, 2 other functions.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    q_dot: &[S; 8],
) -> [S; 8] {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [x, y, psi, phi, theta, delta, _, _] = *q;
    let [x_dot, y_dot, psi_dot, phi_dot, theta_dot, delta_dot, thR_dot, thF_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_Y_in_L_2 = psi_dot * sin_phi;
    let w_Y_in_L_3 = psi_dot * cos_phi;
    let w_L_in_B_1 = (-w_Y_in_L_3).mul_add(sin_theta, phi_dot * cos_theta);
    let w_L_in_B_3 = w_Y_in_L_3.mul_add(cos_theta, phi_dot * sin_theta);
    let w_B_2 = theta_dot + w_Y_in_L_2;
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1 = (-w_B_2).mul_add(sin_delta, w_B_in_S_1 * cos_delta);
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = delta_dot + w_B_in_S_3;
    let x_Y_in_L_2 = g * sin_phi;
    let x_Y_in_L_3 = g * cos_phi;
    let x_L_in_B_1 = x_Y_in_L_3 * sin_theta;
    let x_L_in_B_3 = x_Y_in_L_3 * cos_theta;
    let x_B_in_S_1 = x_L_in_B_3.mul_add(sin_lam, x_L_in_B_1 * cos_lam);
    let x_B_in_S_3 = (-x_L_in_B_1).mul_add(sin_lam, x_L_in_B_3 * cos_lam);
    let x_S_in_F_1 = (-x_Y_in_L_2).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let x_S_in_F_2 = x_B_in_S_1.mul_add(sin_delta, x_Y_in_L_2 * cos_delta);
    let v_N_in_Y_1 = y_dot.mul_add(sin_psi, x_dot * cos_psi);
    let v_N_in_Y_2 = (-y_dot).mul_add(cos_psi, x_dot * sin_psi);
    let v_Y_in_L_2 = v_N_in_Y_2 * cos_phi;
    let v_Y_in_L_3 = v_N_in_Y_2 * sin_phi;
    let v_RC_1 = rR.mul_add(w_Y_in_L_2, -v_N_in_Y_1);
    let v_RC_2 = rR.mul_add(phi_dot, -v_Y_in_L_2);
    let v_L_in_B_1 = v_RC_1.mul_add(cos_theta, v_Y_in_L_3 * sin_theta);
    let v_L_in_B_3 = (-v_RC_1).mul_add(sin_theta, v_Y_in_L_3 * cos_theta);
    let rr_plus_zb = rR + zB;
    let v_Bo_1 = w_B_2.mul_add(rr_plus_zb, -v_L_in_B_1);
    let v_Bo_2 = xB.mul_add(w_L_in_B_3, v_RC_2) - w_L_in_B_1 * rr_plus_zb;
    let v_Bo_3 = xB.mul_add(w_B_2, -v_L_in_B_3);
    let v_B_in_S_1 = v_L_in_B_3.mul_add(sin_lam, v_L_in_B_1 * cos_lam);
    let v_B_in_S_3 = (-v_L_in_B_1).mul_add(sin_lam, v_L_in_B_3 * cos_lam);
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let v_Ho_2_of_w_c_lam_rr = (-w_plus_c).mul_add(cos_lam, rr_sin_lam);
    let v_Ho_2_of_w_c_lam_rr_2 = -v_Ho_2_of_w_c_lam_rr;
    let v_Ho_2 = w_B_in_S_3.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_RC_2);
    let v_Ho_3 = w_B_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, -v_B_in_S_3);
    let v_S_in_F_1 = (-v_Ho_2).mul_add(sin_delta, v_B_in_S_1 * cos_delta);
    let v_S_in_F_2 = v_Ho_2.mul_add(cos_delta, v_B_in_S_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let v_Ho_1_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let v_Ho_1 = w_S_in_F_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_1);
    let v_Ho_2_2_of_lam_rr_xh_zh = (-xH).mul_add(cos_lam, rr_plus_zh * sin_lam);
    let v_Ho_2_2_of_place = v_Ho_2_of_w_c_lam_rr - v_Ho_2_2_of_lam_rr_xh_zh;
    let minus_v_ho_2_2_of_place = -v_Ho_2_2_of_place;
    let v_Ho_2_2 = w_F_3.mul_add(minus_v_ho_2_2_of_place, -v_S_in_F_2)
        - w_S_in_F_1 * v_Ho_1_of_lam_rr_xh_zh;
    let v_Ho_3_2 = w_S_in_F_2.mul_add(minus_v_ho_2_2_of_place, -v_Ho_3);
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let v_FC_1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let v_FC_1 = w_S_in_F_2.mul_add(v_FC_1_of_w_lam_rr_rf, -v_S_in_F_1);
    let c_cos_lam = c * cos_lam;
    let v_FC_2_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let v_FC_2 = w_S_in_F_1.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2) + w_F_3 * v_FC_2_of_c_lam_rf;
    let v_FC_3 = w_S_in_F_2.mul_add(v_FC_2_of_c_lam_rf, v_Ho_3);
    let p_v_FC_3 = mF * v_FC_3;
    let p_v_FC_2 = mF * v_FC_2;
    let p_v_FC_1 = mF * v_FC_1;
    let p_v_Ho_3 = mH * v_Ho_3_2;
    let p_v_Ho_2 = mH * v_Ho_2_2;
    let p_v_Ho_1 = mH * v_Ho_1;
    let p_v_S_in_F_2 = p_v_FC_2 - p_v_Ho_2;
    let p_v_S_in_F_1 = p_v_FC_1 + p_v_Ho_1;
    let p_v_Ho_3_2 = p_v_FC_3 - p_v_Ho_3;
    let p_v_Ho_2_2 = p_v_S_in_F_1.mul_add(sin_delta, p_v_S_in_F_2 * cos_delta);
    let p_v_B_in_S_1 = (-p_v_S_in_F_1).mul_add(cos_delta, p_v_S_in_F_2 * sin_delta);
    let p_v_Bo_3 = mB * v_Bo_3;
    let p_v_Bo_2 = mB * v_Bo_2;
    let p_v_Bo_1 = mB * v_Bo_1;
    let p_v_L_in_B_3 = (-p_v_B_in_S_1).mul_add(sin_lam, p_v_Ho_3_2 * cos_lam) + p_v_Bo_3;
    let p_v_L_in_B_1 = p_v_B_in_S_1.mul_add(cos_lam, p_v_Ho_3_2 * sin_lam) - p_v_Bo_1;
    let p_v_RC_2 = mR.mul_add(v_RC_2, p_v_Ho_2_2) + p_v_Bo_2;
    let p_v_RC_1 = p_v_L_in_B_3.mul_add(sin_theta, mR * v_RC_1) + p_v_L_in_B_1 * cos_theta;
    let p_v_Y_in_L_3 = (-p_v_L_in_B_3).mul_add(cos_theta, mR * v_Y_in_L_3)
        + p_v_L_in_B_1 * sin_theta;
    let p_v_N_in_Y_2 = (-p_v_RC_2).mul_add(cos_phi, p_v_Y_in_L_3 * sin_phi);
    let F_x_F_1 = x_S_in_F_2.mul_add(sin_delta, x_S_in_F_1 * cos_delta);
    let F_x_F_3 = F_x_F_1.mul_add(sin_lam, x_B_in_S_3 * cos_lam);
    let F_x_F_1_2 = (-F_x_F_1).mul_add(cos_lam, x_B_in_S_3 * sin_lam);
    let F_x_F_3_2 = (-F_x_F_1_2).mul_add(sin_theta, F_x_F_3 * cos_theta);
    let F_x_Y_in_L_2 = (-x_S_in_F_1).mul_add(sin_delta, x_S_in_F_2 * cos_delta);
    let F_x_N_in_Y_2 = (-F_x_Y_in_L_2).mul_add(cos_phi, F_x_F_3_2 * sin_phi);
    let F_x_N_in_Y_1 = F_x_F_1_2.mul_add(cos_theta, F_x_F_3 * sin_theta);
    let F_mp_N_1 = F_x_N_in_Y_1.mul_add(cos_psi, F_x_N_in_Y_2 * sin_psi);
    let phi_dot_cos_phi = phi_dot * cos_phi;
    let w_Y_in_L_2_2 = psi_dot * phi_dot_cos_phi;
    let phi_dot_sin_phi = phi_dot * sin_phi;
    let w_Y_in_L_3_2 = psi_dot * phi_dot_sin_phi;
    let theta_dot_sin_theta = theta_dot * sin_theta;
    let theta_dot_cos_theta = theta_dot * cos_theta;
    let w_L_in_B_1_2 = (-w_Y_in_L_3_2).mul_add(sin_theta, phi_dot * theta_dot_sin_theta)
        + w_Y_in_L_3 * theta_dot_cos_theta;
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, phi_dot * theta_dot_cos_theta)
        - w_Y_in_L_3 * theta_dot_sin_theta;
    let w_B_in_S_1_2 = w_L_in_B_3_2.mul_add(sin_lam, w_L_in_B_1_2 * cos_lam);
    let w_B_in_S_3_2 = (-w_L_in_B_1_2).mul_add(sin_lam, w_L_in_B_3_2 * cos_lam);
    let delta_dot_sin_delta = delta_dot * sin_delta;
    let delta_dot_cos_delta = delta_dot * cos_delta;
    let w_S_in_F_1_2 = (-w_B_in_S_1_2).mul_add(cos_delta, w_Y_in_L_2_2 * sin_delta)
        + w_B_in_S_1 * delta_dot_sin_delta + w_B_2 * delta_dot_cos_delta;
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_Y_in_L_2_2 * cos_delta)
        - w_B_2 * delta_dot_sin_delta + w_B_in_S_1 * delta_dot_cos_delta;
    let v_N_in_Y_1_2 = psi_dot * v_N_in_Y_2;
    let v_N_in_Y_2_2 = psi_dot * v_N_in_Y_1;
    let v_Y_in_L_2_2 = (-v_N_in_Y_2_2).mul_add(cos_phi, v_N_in_Y_2 * phi_dot_sin_phi);
    let v_Y_in_L_3_2 = v_N_in_Y_2.mul_add(phi_dot_cos_phi, v_N_in_Y_2_2 * sin_phi);
    let v_RC_1_2 = rR.mul_add(w_Y_in_L_2_2, v_N_in_Y_1_2);
    let v_L_in_B_1_2 = v_RC_1_2.mul_add(cos_theta, v_Y_in_L_3_2 * sin_theta)
        - v_RC_1 * theta_dot_sin_theta + v_Y_in_L_3 * theta_dot_cos_theta;
    let v_L_in_B_3_2 = (-v_Y_in_L_3_2).mul_add(cos_theta, v_RC_1_2 * sin_theta)
        + v_Y_in_L_3 * theta_dot_sin_theta + v_RC_1 * theta_dot_cos_theta;
    let v_Bo_1_2 = w_Y_in_L_2_2.mul_add(rr_plus_zb, -v_L_in_B_1_2);
    let v_Bo_2_2 = xB.mul_add(w_L_in_B_3_2, v_Y_in_L_2_2) + w_L_in_B_1_2 * rr_plus_zb;
    let v_Bo_3_2 = xB.mul_add(w_Y_in_L_2_2, v_L_in_B_3_2);
    let v_B_in_S_1_2 = (-v_L_in_B_1_2).mul_add(cos_lam, v_L_in_B_3_2 * sin_lam);
    let v_B_in_S_3_2 = v_L_in_B_3_2.mul_add(cos_lam, v_L_in_B_1_2 * sin_lam);
    let v_Ho_2_3 = w_B_in_S_3_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_Y_in_L_2_2);
    let v_Ho_3_3 = w_Y_in_L_2_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_B_in_S_3_2);
    let v_S_in_F_1_2 = v_Ho_2_3.mul_add(sin_delta, v_B_in_S_1_2 * cos_delta)
        + v_B_in_S_1 * delta_dot_sin_delta + v_Ho_2 * delta_dot_cos_delta;
    let v_S_in_F_2_2 = (-v_B_in_S_1_2).mul_add(sin_delta, v_Ho_2_3 * cos_delta)
        - v_Ho_2 * delta_dot_sin_delta + v_B_in_S_1 * delta_dot_cos_delta;
    let v_Ho_1_2 = w_S_in_F_2_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_1_2);
    let v_Ho_2_4 = w_S_in_F_1_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_2_2)
        + w_B_in_S_3_2 * minus_v_ho_2_2_of_place;
    let v_Ho_3_4 = w_S_in_F_2_2.mul_add(minus_v_ho_2_2_of_place, -v_Ho_3_3);
    let v_FC_1_2 = w_S_in_F_2_2.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_1_2);
    let v_FC_2_2 = (-w_S_in_F_1_2).mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2_2)
        + w_B_in_S_3_2 * v_FC_2_of_c_lam_rf;
    let v_FC_3_2 = w_S_in_F_2_2.mul_add(v_FC_2_of_c_lam_rf, v_Ho_3_3);
    let p_v_FC_3_2 = mF * v_FC_3_2;
    let p_v_FC_2_2 = mF * v_FC_2_2;
    let p_v_FC_1_2 = mF * v_FC_1_2;
    let p_v_Ho_3_3 = mH * v_Ho_3_4;
    let p_v_Ho_2_3 = mH * v_Ho_2_4;
    let p_v_Ho_1_2 = mH * v_Ho_1_2;
    let p_v_S_in_F_2_2 = p_v_FC_2_2 - p_v_Ho_2_3;
    let p_v_S_in_F_1_2 = p_v_FC_1_2 + p_v_Ho_1_2;
    let p_v_Ho_3_4 = p_v_FC_3_2 - p_v_Ho_3_3;
    let p_v_Ho_2_4 = (-p_v_S_in_F_2_2)
        .mul_add(cos_delta, p_v_S_in_F_2 * delta_dot_sin_delta)
        - p_v_S_in_F_1_2 * sin_delta - p_v_S_in_F_1 * delta_dot_cos_delta;
    let p_v_B_in_S_1_2 = (-p_v_S_in_F_1_2).mul_add(cos_delta, p_v_S_in_F_2_2 * sin_delta)
        + p_v_S_in_F_1 * delta_dot_sin_delta + p_v_S_in_F_2 * delta_dot_cos_delta;
    let p_v_Bo_3_2 = mB * v_Bo_3_2;
    let p_v_Bo_2_2 = mB * v_Bo_2_2;
    let p_v_Bo_1_2 = mB * v_Bo_1_2;
    let p_v_L_in_B_3_2 = (-p_v_B_in_S_1_2).mul_add(sin_lam, p_v_Ho_3_4 * cos_lam) + p_v_Bo_3_2;
    let p_v_L_in_B_1_2 = p_v_B_in_S_1_2.mul_add(cos_lam, p_v_Ho_3_4 * sin_lam) - p_v_Bo_1_2;
    let p_v_RC_2_2 = mR.mul_add(v_Y_in_L_2_2, -p_v_Ho_2_4) + p_v_Bo_2_2;
    let p_v_RC_1_2 = p_v_L_in_B_3_2.mul_add(sin_theta, mR * v_RC_1_2)
        + p_v_L_in_B_1_2 * cos_theta - p_v_L_in_B_1 * theta_dot_sin_theta
        + p_v_L_in_B_3 * theta_dot_cos_theta;
    let F_mp_N_2 = (-F_x_N_in_Y_1).mul_add(sin_psi, F_x_N_in_Y_2 * cos_psi);
    let w_RW_2 = thR_dot + w_Y_in_L_2;
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let w_FW_2 = thF_dot + w_S_in_F_2;
    let mh_plus_mf = mH + mF;
    let mr_plus_mb = mR + mB;
    let mp_N_1_of_mr_mb_mh_mf = mh_plus_mf + mr_plus_mb;
    let mp_N_1 = x * mp_N_1_of_mr_mb_mh_mf;
    let mp_N_2 = y * mp_N_1_of_mr_mb_mh_mf;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let p_w_F_3 = H_fork_3.mul_add(cos_lam, H_fork_1 * sin_lam) + H_front_wheel_3
        + p_v_Ho_2 * minus_v_ho_2_2_of_place + p_v_FC_2 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_2 = p_v_Ho_1
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2 + H_front_wheel_2)
        + p_v_Ho_3 * minus_v_ho_2_2_of_place + p_v_FC_1 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1 = (-H_fork_1).mul_add(cos_lam, H_fork_3 * sin_lam) + H_front_wheel_1
        - p_v_Ho_2 * v_Ho_1_of_lam_rr_xh_zh + p_v_FC_2 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3 = p_v_Ho_2_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3);
    let p_w_B_in_S_1 = p_w_S_in_F_1.mul_add(cos_delta, p_w_S_in_F_2 * sin_delta);
    let p_w_B_2 = xB.mul_add(p_v_Bo_3, H_frame_2) + p_w_S_in_F_2 * cos_delta
        - p_w_S_in_F_1 * sin_delta + p_v_Bo_1 * rr_plus_zb + p_v_Ho_3_2 * v_Ho_2_of_w_c_lam_rr_2;
    let p_w_L_in_B_3 = xB.mul_add(p_v_Bo_2, H_frame_3) + p_w_B_in_S_3 * cos_lam
        + p_w_B_in_S_1 * sin_lam;
    let p_w_L_in_B_1 = p_w_B_in_S_3.mul_add(sin_lam, H_frame_1) - p_w_B_in_S_1 * cos_lam
        - p_v_Bo_2 * rr_plus_zb;
    let p_w_Y_in_L_3_of_place = (-p_w_L_in_B_1)
        .mul_add(sin_theta, p_w_L_in_B_3 * cos_theta);
    let p_w_Y_in_L_3 = H_rear_wheel_3 + p_w_Y_in_L_3_of_place;
    let p_w_Y_in_L_2 = rR.mul_add(p_v_RC_1, H_rear_wheel_2) + p_w_B_2;
    let w_F_in_H_1_2 = w_S_in_F_1_2.mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let w_F_in_H_3_2 = (-w_S_in_F_1_2).mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let H_rear_wheel_2_2 = IRyy * w_Y_in_L_2_2;
    let H_rear_wheel_3_2 = IRxx * w_Y_in_L_3_2;
    let H_frame_1_2 = (-IBxz).mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let H_frame_2_2 = IByy * w_Y_in_L_2_2;
    let H_frame_3_2 = (-IBzz).mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let H_fork_1_2 = IHxz.mul_add(w_F_in_H_3_2, IHxx * w_F_in_H_1_2);
    let H_fork_2_2 = IHyy * w_S_in_F_2_2;
    let H_fork_3_2 = IHzz.mul_add(w_F_in_H_3_2, IHxz * w_F_in_H_1_2);
    let H_front_wheel_1_2 = IFxx * w_S_in_F_1_2;
    let H_front_wheel_2_2 = IFyy * w_S_in_F_2_2;
    let H_front_wheel_3_2 = IFxx * w_B_in_S_3_2;
    let p_w_F_3_2 = H_fork_3_2.mul_add(cos_lam, H_fork_1_2 * sin_lam) + H_front_wheel_3_2
        + p_v_Ho_2_3 * minus_v_ho_2_2_of_place + p_v_FC_2_2 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_2_2 = p_v_Ho_1_2
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2_2 + H_front_wheel_2_2)
        + p_v_Ho_3_3 * minus_v_ho_2_2_of_place + p_v_FC_1_2 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3_2 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1_2 = (-H_fork_3_2).mul_add(sin_lam, H_fork_1_2 * cos_lam)
        + H_front_wheel_1_2 + p_v_Ho_2_3 * v_Ho_1_of_lam_rr_xh_zh
        - p_v_FC_2_2 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_2 = p_v_Ho_2_4.mul_add(v_Ho_2_of_w_c_lam_rr_2, -p_w_F_3_2);
    let p_w_B_in_S_1_2 = (-p_w_S_in_F_1_2).mul_add(cos_delta, p_w_S_in_F_2_2 * sin_delta)
        - p_w_S_in_F_1 * delta_dot_sin_delta + p_w_S_in_F_2 * delta_dot_cos_delta;
    let p_w_B_2_2 = xB.mul_add(p_v_Bo_3_2, H_frame_2_2) + p_w_S_in_F_2_2 * cos_delta
        + p_w_S_in_F_1_2 * sin_delta + p_v_Bo_1_2 * rr_plus_zb
        + p_v_Ho_3_4 * v_Ho_2_of_w_c_lam_rr_2 - p_w_S_in_F_2 * delta_dot_sin_delta
        - p_w_S_in_F_1 * delta_dot_cos_delta;
    let p_w_L_in_B_3_2 = (-xB).mul_add(p_v_Bo_2_2, H_frame_3_2)
        + p_w_B_in_S_3_2 * cos_lam - p_w_B_in_S_1_2 * sin_lam;
    let p_w_L_in_B_1_2 = p_w_B_in_S_3_2.mul_add(sin_lam, H_frame_1_2)
        + p_w_B_in_S_1_2 * cos_lam + p_v_Bo_2_2 * rr_plus_zb;
    let p_w_Y_in_L_3_2 = p_w_L_in_B_3_2.mul_add(cos_theta, H_rear_wheel_3_2)
        - p_w_L_in_B_1_2 * sin_theta + p_w_L_in_B_3 * theta_dot_sin_theta
        + p_w_L_in_B_1 * theta_dot_cos_theta;
    let p_w_Y_in_L_2_2 = rR.mul_add(p_v_RC_1_2, H_rear_wheel_2_2) + p_w_B_2_2;
    let mp_L_3 = rR * mp_N_1_of_mr_mb_mh_mf;
    let mp_B_1 = xB * mB;
    let mp_B_3 = mB * rr_plus_zb;
    let mp_S_1 = v_Ho_2_of_w_c_lam_rr_2 * mh_plus_mf;
    let mp_F_1 = (-mF).mul_add(v_FC_2_of_c_lam_rf, mH * minus_v_ho_2_2_of_place);
    let mp_F_3 = mF.mul_add(v_FC_1_of_w_lam_rr_rf, mH * v_Ho_1_of_lam_rr_xh_zh);
    let x_N_in_Y_1 = mp_N_2.mul_add(sin_psi, mp_N_1 * cos_psi);
    let x_N_in_Y_2 = (-mp_N_2).mul_add(cos_psi, mp_N_1 * sin_psi);
    let x_Y_in_L_2_2 = x_N_in_Y_2 * cos_phi;
    let x_Y_in_L_3_2 = x_N_in_Y_2 * sin_phi;
    let x_F_3 = mp_L_3 - x_Y_in_L_3_2;
    let x_L_in_B_1_2 = x_F_3.mul_add(sin_theta, x_N_in_Y_1 * cos_theta);
    let x_L_in_B_3_2 = (-x_N_in_Y_1).mul_add(sin_theta, x_F_3 * cos_theta);
    let x_F_1 = mp_B_1 + x_L_in_B_1_2;
    let x_F_3_2 = mp_B_3 - x_L_in_B_3_2;
    let x_B_in_S_1_2 = (-x_F_1).mul_add(cos_lam, x_F_3_2 * sin_lam);
    let x_B_in_S_3_2 = x_F_3_2.mul_add(cos_lam, x_F_1 * sin_lam);
    let x_F_1_2 = mp_S_1 - x_B_in_S_1_2;
    let x_S_in_F_1_2 = (-x_Y_in_L_2_2).mul_add(sin_delta, x_F_1_2 * cos_delta);
    let x_S_in_F_2_2 = x_F_1_2.mul_add(sin_delta, x_Y_in_L_2_2 * cos_delta);
    let x_F_1_3 = mp_F_1 - x_S_in_F_1_2;
    let x_F_3_3 = mp_F_3 + x_B_in_S_3_2;
    let F_x_B_in_S_1 = (-x_F_1_3).mul_add(cos_delta, x_S_in_F_2_2 * sin_delta);
    let F_x_L_in_B_3 = (-F_x_B_in_S_1).mul_add(sin_lam, x_F_3_3 * cos_lam);
    let F_x_L_in_B_1 = F_x_B_in_S_1.mul_add(cos_lam, x_F_3_3 * sin_lam);
    let F_x_Y_in_L_3 = (-F_x_L_in_B_1).mul_add(sin_theta, F_x_L_in_B_3 * cos_theta);
    let F_x_Y_in_L_2_2 = x_F_1_3.mul_add(sin_delta, x_S_in_F_2_2 * cos_delta);
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_theta_u1_of_place = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let ratio_theta_u1_of_place_2 = (-ratio_theta_u1_of_place)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let ratio_theta_u1_of_place_3 = ratio_theta_u1_of_place * sin_delta;
    let ratio_theta_u1_of_place_4 = sin_phi_cos_delta + ratio_theta_u1_of_place_3;
    let ratio_theta_u1_of_place_5 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_4;
    let ratio_theta_u1_of_place_6 = S::int(1) / (ratio_theta_u1_of_place_5 - S::int(1));
    let ratio_theta_u1_of_place_7 = cos_phi * sin_lam_plus_theta * sin_delta;
    let ratio_theta_u1_of_place_8 = rF * ratio_theta_u1_of_place_6
        * (S::int(1) - (ratio_theta_u1_of_place_7 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_theta_u1_of_place_9 = (-ratio_theta_u1_of_place_2)
        .mul_add(ratio_theta_u1_of_place_8, v_FC_2_of_c_lam_rf);
    let ratio_psi_u1_of_place = cos_lam_plus_theta * sin_delta;
    let ratio_psi_u1_of_place_2 = ratio_theta_u1_of_place_9 * ratio_psi_u1_of_place;
    let ratio_theta_u1_of_place_10 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_10;
    let ratio_theta_u1_of_place_12 = v_FC_1_of_w_lam_rr_rf - ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_3 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_4 = (-ratio_theta_u1_of_place_12)
        .mul_add(
            ratio_psi_u1_of_place_3,
            ratio_theta_u1_of_place_9 * sin_lam_plus_theta,
        );
    let ratio_psi_u1_of_place_5 = ratio_psi_u1_of_place * ratio_theta_u1_of_place_12;
    let ratio_psi_u1_of_place_6 = ratio_theta_u1_of_place_12 * sin_delta;
    let ratio_psi_u1_of_place_7 = -ratio_theta_u1_of_place_12 * cos_delta;
    let ratio_theta_u1_of_place_13 = ratio_theta_u1_of_place_9
        .mul_add(cos_delta, v_Ho_2_of_w_c_lam_rr_2);
    let ratio_psi_u1_of_place_8 = (-ratio_psi_u1_of_place)
        .mul_add(
            ratio_psi_u1_of_place_6,
            ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_7,
        ) + ratio_theta_u1_of_place_13 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_14 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let ratio_theta_u1_of_place_15 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let ratio_theta_u1_of_place_16 = ratio_theta_u1_of_place_6 * ratio_theta_u1_of_place_8;
    let ratio_theta_u1_of_place_17 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_16;
    let ratio_theta_u1_of_place_18 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_17;
    let ratio_theta_u1_of_place_19 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_of_place_18,
            ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_14,
        );
    let ratio_theta_u1_of_place_20 = sin_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_21 = ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_17;
    let ratio_theta_u1_of_place_22 = (-ratio_theta_u1_of_place_15)
        .mul_add(
            ratio_theta_u1_of_place_21,
            ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_20,
        );
    let ratio_theta_u1_of_place_23 = sin_phi
        * v_Ho_2_of_w_c_lam_rr_2.mul_add(sin_lam_plus_theta, rR);
    let ratio_theta_u1_of_place_24 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_21;
    let ratio_theta_u1_of_place_25 = ratio_theta_u1_of_place_11 * cos_delta;
    let ratio_theta_u1_of_place_26 = ratio_theta_u1_of_place_24
        .mul_add(sin_delta, ratio_theta_u1_of_place_25);
    let ratio_theta_u1_of_place_27 = ratio_theta_u1_of_place_10 * sin_delta;
    let ratio_theta_u1_of_place_28 = ratio_theta_u1_of_place_21
        .mul_add(
            ratio_theta_u1_of_place_27,
            ratio_theta_u1_of_place * ratio_theta_u1_of_place_8,
        );
    let ratio_theta_u1_of_place_29 = ratio_theta_u1_of_place_28 - ratio_theta_u1_of_place_13;
    let ratio_theta_u1_of_place_30 = S::int(1)
        / ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_26,
                ratio_theta_u1_of_place * ratio_theta_u1_of_place_12,
            ) - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_29);
    let ratio_theta_u1 = ratio_theta_u1_of_place_30
        * ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_19,
                ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_14,
            ) - ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_20
            + ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_22 + ratio_theta_u1_of_place_23);
    let ratio_psi_u1_of_place_9 = (-ratio_psi_u1_of_place_2)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place * ratio_psi_u1_of_place_4)
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_5
        + ratio_theta_u1 * ratio_psi_u1_of_place_8;
    let ratio_psi_u1_of_place_10 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * rr_minus_rf.mul_add(sin_lam_plus_theta, w_plus_c * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_11 = ratio_psi_u1_of_place_10
        .mul_add(cos_delta, v_FC_2_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_12 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_13 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_12, ratio_psi_u1_of_place_11 * cos_phi);
    let ratio_psi_u1_of_place_14 = ratio_psi_u1_of_place * ratio_psi_u1_of_place_13;
    let ratio_psi_u1_of_place_15 = (-ratio_psi_u1_of_place_7)
        .mul_add(
            ratio_theta_u1_of_place_14,
            ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_15,
        ) + ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_20;
    let ratio_psi_u1_of_place_16 = v_Ho_2_of_w_c_lam_rr_2
        .mul_add(ratio_theta_u1_of_place, rR * cos_phi)
        - ratio_psi_u1_of_place_5 * ratio_theta_u1_of_place_14
        - ratio_psi_u1_of_place_4 * ratio_theta_u1_of_place_15
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_of_place_20
        + ratio_theta_u1 * ratio_psi_u1_of_place_15;
    let ratio_psi_u1_of_place_17 = ratio_theta_u1_of_place_15 * ratio_psi_u1_of_place_13;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_of_place_17,
            ratio_psi_u1_of_place_9 * ratio_psi_u1_of_place_14,
        );
    let ratio_theta_u2_of_place = ratio_theta_u1_of_place_2
        .mul_add(
            ratio_theta_u1_of_place_18,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_8,
        );
    let ratio_theta_u2_of_place_2 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_9;
    let ratio_theta_u2 = ratio_theta_u1_of_place_30
        * ((-ratio_theta_u1_of_place_10)
            .mul_add(ratio_theta_u1_of_place_24, ratio_theta_u2_of_place_2)
            - ratio_theta_u1_of_place_2 * ratio_theta_u2_of_place);
    let ratio_psi_u2_of_place = ratio_theta_u2
        .mul_add(ratio_psi_u1_of_place_8, ratio_psi_u1_of_place_2);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_15,
            ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_15,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_17
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_14 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_14;
    let ratio_thF_u1_of_place = sin_phi_cos_delta
        .mul_add(S::int(2), ratio_theta_u1_of_place_3);
    let ratio_thF_u1_of_place_2 = S::int(1)
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + ratio_theta_u1_of_place_3 * ratio_thF_u1_of_place);
    let ratio_thF_u1_of_place_3 = ratio_theta_u1_of_place_4 * ratio_thF_u1_of_place_2;
    let ratio_thF_u1_of_place_4 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_7))
        .sqrt();
    let ratio_thF_u1_of_place_5 = (-(ratio_thF_u1_of_place_3 * sin_delta))
        .mul_add(ratio_thF_u1_of_place_4, sin_lam * cos_delta);
    let ratio_thF_u1_of_place_6 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    let ratio_thF_u1_of_place_7 = (-rF)
        .mul_add(ratio_thF_u1_of_place_5, ratio_thF_u1_of_place_6);
    let ratio_thF_u1_of_place_8 = (-ratio_thF_u1_of_place_7)
        .mul_add(cos_lam_plus_theta, v_FC_1_of_w_lam_rr_rf * sin_lam_plus_theta);
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_9 = ratio_psi_u1_of_place_13 * ratio_thF_u1_of_place_4;
    let ratio_thF_u1_of_place_10 = rf_inv * ratio_thF_u1_of_place_9;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_10;
    let ratio_thF_u1_of_place_12 = (-v_FC_1_of_w_lam_rr_rf)
        .mul_add(
            ratio_theta_u1_of_place_2,
            v_FC_2_of_c_lam_rf * ratio_theta_u1_of_place_10,
        );
    let ratio_thF_u1_of_place_13 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12;
    let ratio_thF_u1_of_place_14 = ratio_theta_u2_of_place_2
        .mul_add(sin_lam_plus_theta, ratio_theta_u1_of_place_23)
        + ratio_psi_u1_of_place * ratio_thF_u1_of_place_12
        - ratio_psi_u1_of_place_3 * ratio_thF_u1_of_place_13;
    let ratio_thF_u1_of_place_15 = ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_thF_u1_of_place_15,
            ratio_psi_u1_of_place_9 * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_of_place_15,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u3_of_place = (-ratio_thF_u1_of_place_6)
        .mul_add(rf_inv, ratio_thF_u1_of_place_5);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_w_lam_rr_rf)
        .mul_add(sin_lam_plus_theta, ratio_thF_u3_of_place * cos_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = rR * ratio_thF_u1_of_place_9;
    let ratio_thF_u3 = ratio_thF_u3_of_place_2 * ratio_thF_u3_of_place_3;
    let v_Y_in_L_2_3 = sin_psi * cos_phi;
    let v_Y_in_L_3_3 = sin_psi * sin_phi;
    let v_L_in_B_1_3 = (-cos_psi).mul_add(cos_theta, v_Y_in_L_3_3 * sin_theta);
    let v_L_in_B_3_3 = v_Y_in_L_3_3.mul_add(cos_theta, cos_psi * sin_theta);
    let v_B_in_S_1_3 = v_L_in_B_3_3.mul_add(sin_lam, v_L_in_B_1_3 * cos_lam);
    let v_B_in_S_3_3 = (-v_L_in_B_1_3).mul_add(sin_lam, v_L_in_B_3_3 * cos_lam);
    let v_S_in_F_1_3 = v_B_in_S_1_3.mul_add(cos_delta, v_Y_in_L_2_3 * sin_delta);
    let v_S_in_F_2_3 = (-v_Y_in_L_2_3).mul_add(cos_delta, v_B_in_S_1_3 * sin_delta);
    let p_v_FC_3_3 = mF * v_B_in_S_3_3;
    let p_v_FC_2_3 = mF * v_S_in_F_2_3;
    let p_v_FC_1_3 = mF * v_S_in_F_1_3;
    let p_v_Ho_3_5 = mH * v_B_in_S_3_3;
    let p_v_Ho_2_5 = mH * v_S_in_F_2_3;
    let p_v_Ho_1_3 = mH * v_S_in_F_1_3;
    let p_v_S_in_F_2_3 = p_v_FC_2_3 + p_v_Ho_2_5;
    let p_v_S_in_F_1_3 = p_v_FC_1_3 + p_v_Ho_1_3;
    let p_v_Ho_3_6 = p_v_FC_3_3 + p_v_Ho_3_5;
    let p_v_Ho_2_6 = (-p_v_S_in_F_1_3).mul_add(sin_delta, p_v_S_in_F_2_3 * cos_delta);
    let p_v_B_in_S_1_3 = p_v_S_in_F_1_3.mul_add(cos_delta, p_v_S_in_F_2_3 * sin_delta);
    let p_v_Bo_3_3 = mB * v_L_in_B_3_3;
    let p_v_Bo_2_3 = mB * v_Y_in_L_2_3;
    let p_v_Bo_1_3 = mB * v_L_in_B_1_3;
    let p_v_L_in_B_3_3 = p_v_B_in_S_1_3.mul_add(sin_lam, p_v_Ho_3_6 * cos_lam) + p_v_Bo_3_3;
    let p_v_L_in_B_1_3 = (-p_v_B_in_S_1_3).mul_add(cos_lam, p_v_Ho_3_6 * sin_lam) - p_v_Bo_1_3;
    let p_v_RC_2_3 = mR.mul_add(v_Y_in_L_2_3, -p_v_Ho_2_6) + p_v_Bo_2_3;
    let p_v_RC_1_3 = p_v_L_in_B_3_3.mul_add(sin_theta, mR * cos_psi) + p_v_L_in_B_1_3 * cos_theta;
    let p_v_Y_in_L_3_3 = p_v_L_in_B_3_3.mul_add(cos_theta, mR * v_Y_in_L_3_3)
        - p_v_L_in_B_1_3 * sin_theta;
    let p_v_N_in_Y_2_3 = p_v_Y_in_L_3_3.mul_add(sin_phi, p_v_RC_2_3 * cos_phi);
    let v_Y_in_L_2_4 = cos_psi * cos_phi;
    let v_Y_in_L_3_4 = cos_psi * sin_phi;
    let v_L_in_B_1_4 = v_Y_in_L_3_4.mul_add(sin_theta, sin_psi * cos_theta);
    let v_L_in_B_3_4 = (-sin_psi).mul_add(sin_theta, v_Y_in_L_3_4 * cos_theta);
    let v_B_in_S_1_4 = v_L_in_B_3_4.mul_add(sin_lam, v_L_in_B_1_4 * cos_lam);
    let v_B_in_S_3_4 = (-v_L_in_B_1_4).mul_add(sin_lam, v_L_in_B_3_4 * cos_lam);
    let v_S_in_F_1_4 = v_B_in_S_1_4.mul_add(cos_delta, v_Y_in_L_2_4 * sin_delta);
    let v_S_in_F_2_4 = (-v_Y_in_L_2_4).mul_add(cos_delta, v_B_in_S_1_4 * sin_delta);
    let p_v_FC_3_4 = mF * v_B_in_S_3_4;
    let p_v_FC_2_4 = mF * v_S_in_F_2_4;
    let p_v_FC_1_4 = mF * v_S_in_F_1_4;
    let p_v_Ho_3_7 = mH * v_B_in_S_3_4;
    let p_v_Ho_2_7 = mH * v_S_in_F_2_4;
    let p_v_Ho_1_4 = mH * v_S_in_F_1_4;
    let p_v_S_in_F_2_4 = p_v_FC_2_4 + p_v_Ho_2_7;
    let p_v_S_in_F_1_4 = p_v_FC_1_4 + p_v_Ho_1_4;
    let p_v_Ho_3_8 = p_v_FC_3_4 + p_v_Ho_3_7;
    let p_v_Ho_2_8 = (-p_v_S_in_F_1_4).mul_add(sin_delta, p_v_S_in_F_2_4 * cos_delta);
    let p_v_B_in_S_1_4 = p_v_S_in_F_1_4.mul_add(cos_delta, p_v_S_in_F_2_4 * sin_delta);
    let p_v_Bo_3_4 = mB * v_L_in_B_3_4;
    let p_v_Bo_2_4 = mB * v_Y_in_L_2_4;
    let p_v_Bo_1_4 = mB * v_L_in_B_1_4;
    let p_v_L_in_B_3_4 = p_v_B_in_S_1_4.mul_add(sin_lam, p_v_Ho_3_8 * cos_lam) + p_v_Bo_3_4;
    let p_v_L_in_B_1_4 = (-p_v_B_in_S_1_4).mul_add(cos_lam, p_v_Ho_3_8 * sin_lam) - p_v_Bo_1_4;
    let p_v_RC_2_4 = mR.mul_add(v_Y_in_L_2_4, -p_v_Ho_2_8) + p_v_Bo_2_4;
    let p_v_RC_1_4 = (-p_v_L_in_B_3_4).mul_add(sin_theta, mR * sin_psi)
        - p_v_L_in_B_1_4 * cos_theta;
    let p_v_Y_in_L_3_4 = p_v_L_in_B_3_4.mul_add(cos_theta, mR * v_Y_in_L_3_4)
        - p_v_L_in_B_1_4 * sin_theta;
    let p_v_N_in_Y_2_4 = p_v_Y_in_L_3_4.mul_add(sin_phi, p_v_RC_2_4 * cos_phi);
    let w_L_in_B_1_3 = cos_phi * sin_theta;
    let w_L_in_B_3_3 = cos_phi * cos_theta;
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_1_3 = (-w_B_in_S_1_3).mul_add(cos_delta, sin_delta_sin_phi);
    let w_S_in_F_2_3 = w_B_in_S_1_3.mul_add(sin_delta, sin_phi_cos_delta);
    let v_RC_1_3 = rR * sin_phi;
    let v_L_in_B_1_5 = v_RC_1_3 * cos_theta;
    let v_L_in_B_3_5 = v_RC_1_3 * sin_theta;
    let v_Bo_1_3 = rr_plus_zb.mul_add(sin_phi, -v_L_in_B_1_5);
    let v_Bo_2_3 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let v_Bo_3_3 = xB.mul_add(sin_phi, v_L_in_B_3_5);
    let v_B_in_S_1_5 = (-v_L_in_B_1_5).mul_add(cos_lam, v_L_in_B_3_5 * sin_lam);
    let v_B_in_S_3_5 = v_L_in_B_3_5.mul_add(cos_lam, v_L_in_B_1_5 * sin_lam);
    let v_Ho_2_5 = w_B_in_S_3_3 * v_Ho_2_of_w_c_lam_rr_2;
    let v_Ho_3_5 = v_Ho_2_of_w_c_lam_rr_2.mul_add(sin_phi, v_B_in_S_3_5);
    let v_S_in_F_1_5 = v_Ho_2_5.mul_add(sin_delta, v_B_in_S_1_5 * cos_delta);
    let v_S_in_F_2_5 = (-v_Ho_2_5).mul_add(cos_delta, v_B_in_S_1_5 * sin_delta);
    let v_Ho_1_3 = w_S_in_F_2_3.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_1_5);
    let v_Ho_2_6 = w_S_in_F_1_3.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_2_5)
        + w_B_in_S_3_3 * minus_v_ho_2_2_of_place;
    let v_Ho_3_6 = w_S_in_F_2_3.mul_add(minus_v_ho_2_2_of_place, -v_Ho_3_5);
    let v_FC_1_3 = w_S_in_F_2_3.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_1_5);
    let v_FC_2_3 = w_B_in_S_3_3.mul_add(v_FC_2_of_c_lam_rf, -v_S_in_F_2_5)
        - w_S_in_F_1_3 * v_FC_1_of_w_lam_rr_rf;
    let v_FC_3_3 = w_S_in_F_2_3.mul_add(v_FC_2_of_c_lam_rf, v_Ho_3_5);
    let p_v_FC_3_5 = mF * v_FC_3_3;
    let p_v_FC_2_5 = mF * v_FC_2_3;
    let p_v_FC_1_5 = mF * v_FC_1_3;
    let p_v_Ho_3_9 = mH * v_Ho_3_6;
    let p_v_Ho_2_9 = mH * v_Ho_2_6;
    let p_v_Ho_1_5 = mH * v_Ho_1_3;
    let p_v_S_in_F_2_5 = p_v_FC_2_5 - p_v_Ho_2_9;
    let p_v_S_in_F_1_5 = p_v_FC_1_5 + p_v_Ho_1_5;
    let p_v_Ho_3_10 = p_v_FC_3_5 - p_v_Ho_3_9;
    let p_v_Ho_2_10 = p_v_S_in_F_1_5.mul_add(sin_delta, p_v_S_in_F_2_5 * cos_delta);
    let p_v_B_in_S_1_5 = (-p_v_S_in_F_1_5)
        .mul_add(cos_delta, p_v_S_in_F_2_5 * sin_delta);
    let p_v_Bo_3_5 = mB * v_Bo_3_3;
    let p_v_Bo_2_5 = mB * v_Bo_2_3;
    let p_v_Bo_1_5 = mB * v_Bo_1_3;
    let p_v_L_in_B_3_5 = (-p_v_B_in_S_1_5).mul_add(sin_lam, p_v_Ho_3_10 * cos_lam) + p_v_Bo_3_5;
    let p_v_L_in_B_1_5 = p_v_B_in_S_1_5.mul_add(cos_lam, p_v_Ho_3_10 * sin_lam) - p_v_Bo_1_5;
    let p_v_RC_2_5 = p_v_Ho_2_10 + p_v_Bo_2_5;
    let p_v_RC_1_5 = p_v_L_in_B_3_5.mul_add(sin_theta, mR * v_RC_1_3) + p_v_L_in_B_1_5 * cos_theta;
    let p_v_Y_in_L_3_5 = (-p_v_L_in_B_1_5)
        .mul_add(sin_theta, p_v_L_in_B_3_5 * cos_theta);
    let p_v_N_in_Y_2_5 = p_v_Y_in_L_3_5.mul_add(sin_phi, p_v_RC_2_5 * cos_phi);
    let w_B_in_S_1_4 = (-sin_lam).mul_add(sin_theta, cos_lam * cos_theta);
    let w_B_in_S_3_4 = sin_lam.mul_add(cos_theta, cos_lam * sin_theta);
    let w_S_in_F_1_4 = w_B_in_S_1_4 * cos_delta;
    let w_S_in_F_2_4 = w_B_in_S_1_4 * sin_delta;
    let v_Bo_2_4 = xB.mul_add(sin_theta, rR) - rr_plus_zb * cos_theta;
    let v_Ho_2_7 = w_B_in_S_3_4.mul_add(v_Ho_2_of_w_c_lam_rr_2, rR);
    let v_S_in_F_1_6 = v_Ho_2_7 * sin_delta;
    let v_S_in_F_2_6 = v_Ho_2_7 * cos_delta;
    let v_Ho_1_4 = w_S_in_F_2_4.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_1_6);
    let v_Ho_2_8 = w_S_in_F_1_4.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_2_6)
        + w_B_in_S_3_4 * minus_v_ho_2_2_of_place;
    let v_Ho_3_7 = w_S_in_F_2_4 * minus_v_ho_2_2_of_place;
    let v_FC_1_4 = w_S_in_F_2_4.mul_add(v_FC_1_of_w_lam_rr_rf, -v_S_in_F_1_6);
    let v_FC_2_4 = (-w_S_in_F_1_4).mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2_6)
        + w_B_in_S_3_4 * v_FC_2_of_c_lam_rf;
    let v_FC_3_4 = w_S_in_F_2_4 * v_FC_2_of_c_lam_rf;
    let p_v_FC_3_6 = mF * v_FC_3_4;
    let p_v_FC_2_6 = mF * v_FC_2_4;
    let p_v_FC_1_6 = mF * v_FC_1_4;
    let p_v_Ho_3_11 = mH * v_Ho_3_7;
    let p_v_Ho_2_11 = mH * v_Ho_2_8;
    let p_v_Ho_1_6 = mH * v_Ho_1_4;
    let p_v_S_in_F_2_6 = p_v_FC_2_6 - p_v_Ho_2_11;
    let p_v_S_in_F_1_6 = p_v_FC_1_6 + p_v_Ho_1_6;
    let p_v_Ho_3_12 = p_v_FC_3_6 - p_v_Ho_3_11;
    let p_v_Ho_2_12 = (-p_v_S_in_F_1_6).mul_add(sin_delta, p_v_S_in_F_2_6 * cos_delta);
    let p_v_B_in_S_1_6 = p_v_S_in_F_1_6.mul_add(cos_delta, p_v_S_in_F_2_6 * sin_delta);
    let p_v_Bo_2_6 = mB * v_Bo_2_4;
    let p_v_L_in_B_3_6 = p_v_B_in_S_1_6.mul_add(sin_lam, p_v_Ho_3_12 * cos_lam);
    let p_v_L_in_B_1_6 = (-p_v_B_in_S_1_6).mul_add(cos_lam, p_v_Ho_3_12 * sin_lam);
    let p_v_RC_2_6 = rR.mul_add(mR, p_v_Ho_2_12) + p_v_Bo_2_6;
    let p_v_RC_1_6 = p_v_L_in_B_1_6.mul_add(cos_theta, p_v_L_in_B_3_6 * sin_theta);
    let p_v_Y_in_L_3_6 = (-p_v_L_in_B_1_6)
        .mul_add(sin_theta, p_v_L_in_B_3_6 * cos_theta);
    let p_v_N_in_Y_2_6 = (-p_v_RC_2_6).mul_add(cos_phi, p_v_Y_in_L_3_6 * sin_phi);
    let v_Bo_1_4 = rr_plus_zb;
    let v_Ho_3_8 = v_Ho_2_of_w_c_lam_rr_2;
    let v_Ho_1_5 = v_Ho_1_of_lam_rr_xh_zh * cos_delta;
    let v_Ho_2_9 = v_Ho_1_of_lam_rr_xh_zh * sin_delta;
    let v_Ho_3_9 = minus_v_ho_2_2_of_place.mul_add(cos_delta, -v_Ho_3_8);
    let v_FC_1_5 = v_FC_1_of_w_lam_rr_rf * cos_delta;
    let v_FC_2_5 = v_FC_1_of_w_lam_rr_rf * sin_delta;
    let v_FC_3_5 = v_FC_2_of_c_lam_rf.mul_add(cos_delta, v_Ho_3_8);
    let p_v_FC_3_7 = mF * v_FC_3_5;
    let p_v_FC_2_7 = mF * v_FC_2_5;
    let p_v_FC_1_7 = mF * v_FC_1_5;
    let p_v_Ho_3_13 = mH * v_Ho_3_9;
    let p_v_Ho_2_13 = mH * v_Ho_2_9;
    let p_v_Ho_1_7 = mH * v_Ho_1_5;
    let p_v_S_in_F_2_7 = p_v_FC_2_7 + p_v_Ho_2_13;
    let p_v_S_in_F_1_7 = p_v_FC_1_7 + p_v_Ho_1_7;
    let p_v_Ho_3_14 = p_v_FC_3_7 - p_v_Ho_3_13;
    let p_v_Ho_2_14 = (-p_v_S_in_F_1_7).mul_add(sin_delta, p_v_S_in_F_2_7 * cos_delta);
    let p_v_B_in_S_1_7 = p_v_S_in_F_1_7.mul_add(cos_delta, p_v_S_in_F_2_7 * sin_delta);
    let p_v_Bo_1_6 = mB * v_Bo_1_4;
    let p_v_L_in_B_3_7 = p_v_Ho_3_14.mul_add(cos_lam, mp_B_1) + p_v_B_in_S_1_7 * sin_lam;
    let p_v_L_in_B_1_7 = (-p_v_B_in_S_1_7).mul_add(cos_lam, p_v_Ho_3_14 * sin_lam) - p_v_Bo_1_6;
    let p_v_RC_1_7 = p_v_L_in_B_1_7.mul_add(cos_theta, p_v_L_in_B_3_7 * sin_theta);
    let p_v_Y_in_L_3_7 = (-p_v_L_in_B_1_7)
        .mul_add(sin_theta, p_v_L_in_B_3_7 * cos_theta);
    let p_v_N_in_Y_2_7 = (-p_v_Ho_2_14).mul_add(cos_phi, p_v_Y_in_L_3_7 * sin_phi);
    let v_Ho_2_10 = minus_v_ho_2_2_of_place;
    let v_FC_2_6 = v_FC_2_of_c_lam_rf;
    let p_v_FC_2_8 = mF * v_FC_2_6;
    let p_v_Ho_2_15 = mH * v_Ho_2_10;
    let p_v_S_in_F_2_8 = p_v_FC_2_8 - p_v_Ho_2_15;
    let p_v_Ho_2_16 = p_v_S_in_F_2_8 * cos_delta;
    let p_v_B_in_S_1_8 = p_v_S_in_F_2_8 * sin_delta;
    let p_v_L_in_B_3_8 = p_v_B_in_S_1_8 * sin_lam;
    let p_v_L_in_B_1_8 = p_v_B_in_S_1_8 * cos_lam;
    let p_v_RC_1_8 = (-p_v_L_in_B_1_8).mul_add(cos_theta, p_v_L_in_B_3_8 * sin_theta);
    let p_v_Y_in_L_3_8 = p_v_L_in_B_1_8.mul_add(sin_theta, p_v_L_in_B_3_8 * cos_theta);
    let p_v_N_in_Y_2_8 = (-p_v_Ho_2_16).mul_add(cos_phi, p_v_Y_in_L_3_8 * sin_phi);
    let w_F_in_H_1_3 = w_S_in_F_1_3.mul_add(cos_lam, w_B_in_S_3_3 * sin_lam);
    let w_F_in_H_3_3 = (-w_S_in_F_1_3).mul_add(sin_lam, w_B_in_S_3_3 * cos_lam);
    let H_rear_wheel_2_3 = IRyy * sin_phi;
    let H_rear_wheel_3_3 = IRxx * cos_phi;
    let H_frame_1_3 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let H_frame_2_3 = IByy * sin_phi;
    let H_frame_3_3 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let H_fork_1_3 = IHxz.mul_add(w_F_in_H_3_3, IHxx * w_F_in_H_1_3);
    let H_fork_2_3 = IHyy * w_S_in_F_2_3;
    let H_fork_3_3 = IHzz.mul_add(w_F_in_H_3_3, IHxz * w_F_in_H_1_3);
    let H_front_wheel_1_3 = IFxx * w_S_in_F_1_3;
    let H_front_wheel_2_3 = IFyy * w_S_in_F_2_3;
    let H_front_wheel_3_3 = IFxx * w_B_in_S_3_3;
    let p_w_F_3_3 = H_fork_3_3.mul_add(cos_lam, H_fork_1_3 * sin_lam) + H_front_wheel_3_3
        + p_v_Ho_2_9 * minus_v_ho_2_2_of_place + p_v_FC_2_5 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_2_3 = p_v_Ho_1_5
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2_3 + H_front_wheel_2_3)
        + p_v_Ho_3_9 * minus_v_ho_2_2_of_place + p_v_FC_1_5 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3_5 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1_3 = (-H_fork_3_3).mul_add(sin_lam, H_fork_1_3 * cos_lam)
        + H_front_wheel_1_3 + p_v_Ho_2_9 * v_Ho_1_of_lam_rr_xh_zh
        - p_v_FC_2_5 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_3 = p_v_Ho_2_10.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3_3);
    let p_w_B_in_S_1_3 = (-p_w_S_in_F_1_3)
        .mul_add(cos_delta, p_w_S_in_F_2_3 * sin_delta);
    let p_w_B_2_3 = xB.mul_add(p_v_Bo_3_5, H_frame_2_3) + p_w_S_in_F_2_3 * cos_delta
        + p_w_S_in_F_1_3 * sin_delta + p_v_Bo_1_5 * rr_plus_zb
        + p_v_Ho_3_10 * v_Ho_2_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_3 = (-xB).mul_add(p_v_Bo_2_5, H_frame_3_3)
        - p_w_B_in_S_3_3 * cos_lam - p_w_B_in_S_1_3 * sin_lam;
    let p_w_L_in_B_1_3 = (-p_w_B_in_S_3_3).mul_add(sin_lam, H_frame_1_3)
        + p_w_B_in_S_1_3 * cos_lam + p_v_Bo_2_5 * rr_plus_zb;
    let p_w_Y_in_L_3_3 = (-p_w_L_in_B_3_3).mul_add(cos_theta, H_rear_wheel_3_3)
        + p_w_L_in_B_1_3 * sin_theta;
    let rr_p_v_rc_1_5 = rR * p_v_RC_1_5;
    let p_w_Y_in_L_2_3 = H_rear_wheel_2_3 + p_w_B_2_3 + rr_p_v_rc_1_5;
    let w_F_in_H_1_4 = w_S_in_F_1_4.mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = (-w_S_in_F_1_4).mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let H_frame_1_4 = IBxx.mul_add(cos_theta, IBxz * sin_theta);
    let H_frame_3_4 = IBxz.mul_add(cos_theta, IBzz * sin_theta);
    let H_fork_1_4 = IHxz.mul_add(w_F_in_H_3_4, IHxx * w_F_in_H_1_4);
    let H_fork_2_4 = IHyy * w_S_in_F_2_4;
    let H_fork_3_4 = IHzz.mul_add(w_F_in_H_3_4, IHxz * w_F_in_H_1_4);
    let H_front_wheel_1_4 = IFxx * w_S_in_F_1_4;
    let H_front_wheel_2_4 = IFyy * w_S_in_F_2_4;
    let H_front_wheel_3_4 = IFxx * w_B_in_S_3_4;
    let p_w_F_3_4 = H_fork_3_4.mul_add(cos_lam, H_fork_1_4 * sin_lam) + H_front_wheel_3_4
        + p_v_Ho_2_11 * minus_v_ho_2_2_of_place + p_v_FC_2_6 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_2_4 = p_v_Ho_1_6
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2_4 + H_front_wheel_2_4)
        + p_v_Ho_3_11 * minus_v_ho_2_2_of_place + p_v_FC_1_6 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3_6 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1_4 = (-H_fork_3_4).mul_add(sin_lam, H_fork_1_4 * cos_lam)
        + H_front_wheel_1_4 + p_v_Ho_2_11 * v_Ho_1_of_lam_rr_xh_zh
        - p_v_FC_2_6 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_4 = p_v_Ho_2_12.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3_4);
    let p_w_B_in_S_1_4 = p_w_S_in_F_1_4.mul_add(cos_delta, p_w_S_in_F_2_4 * sin_delta);
    let p_w_B_2_4 = (-p_w_S_in_F_1_4).mul_add(sin_delta, p_w_S_in_F_2_4 * cos_delta)
        + p_v_Ho_3_12 * v_Ho_2_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_4 = xB.mul_add(p_v_Bo_2_6, H_frame_3_4) + p_w_B_in_S_3_4 * cos_lam
        - p_w_B_in_S_1_4 * sin_lam;
    let p_w_L_in_B_1_4 = p_w_B_in_S_3_4.mul_add(sin_lam, H_frame_1_4)
        + p_w_B_in_S_1_4 * cos_lam - p_v_Bo_2_6 * rr_plus_zb;
    let p_w_Y_in_L_3_4 = (-p_w_L_in_B_1_4)
        .mul_add(sin_theta, p_w_L_in_B_3_4 * cos_theta);
    let p_w_Y_in_L_2_4 = rR.mul_add(p_v_RC_1_6, p_w_B_2_4);
    let w_F_in_H_1_5 = cos_lam * sin_delta;
    let w_F_in_H_3_5 = sin_lam * sin_delta;
    let H_fork_1_5 = (-IHxz).mul_add(w_F_in_H_3_5, IHxx * w_F_in_H_1_5);
    let H_fork_2_5 = IHyy * cos_delta;
    let H_fork_3_5 = (-IHzz).mul_add(w_F_in_H_3_5, IHxz * w_F_in_H_1_5);
    let H_front_wheel_1_5 = IFxx * sin_delta;
    let H_front_wheel_2_5 = IFyy * cos_delta;
    let p_w_F_3_5 = (-H_fork_1_5).mul_add(sin_lam, p_v_FC_2_7 * v_FC_2_of_c_lam_rf)
        - H_fork_3_5 * cos_lam - p_v_Ho_2_13 * minus_v_ho_2_2_of_place;
    let p_w_S_in_F_2_5 = p_v_Ho_1_7
        .mul_add(v_Ho_1_of_lam_rr_xh_zh, H_fork_2_5 + H_front_wheel_2_5)
        + p_v_Ho_3_13 * minus_v_ho_2_2_of_place + p_v_FC_1_7 * v_FC_1_of_w_lam_rr_rf
        + p_v_FC_3_7 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1_5 = (-H_fork_3_5).mul_add(sin_lam, H_fork_1_5 * cos_lam)
        + H_front_wheel_1_5 + p_v_Ho_2_13 * v_Ho_1_of_lam_rr_xh_zh
        + p_v_FC_2_7 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_5 = p_v_Ho_2_14.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3_5);
    let p_w_B_in_S_1_5 = (-p_w_S_in_F_1_5)
        .mul_add(cos_delta, p_w_S_in_F_2_5 * sin_delta);
    let p_w_B_2_5 = xB.mul_add(mp_B_1, IByy) + p_w_S_in_F_2_5 * cos_delta
        + p_w_S_in_F_1_5 * sin_delta + p_v_Bo_1_6 * rr_plus_zb
        + p_v_Ho_3_14 * v_Ho_2_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_5 = (-p_w_B_in_S_1_5).mul_add(sin_lam, p_w_B_in_S_3_5 * cos_lam);
    let p_w_L_in_B_1_5 = p_w_B_in_S_1_5.mul_add(cos_lam, p_w_B_in_S_3_5 * sin_lam);
    let p_w_Y_in_L_3_5 = (-p_w_L_in_B_1_5)
        .mul_add(sin_theta, p_w_L_in_B_3_5 * cos_theta);
    let rr_p_v_rc_1_7 = rR * p_v_RC_1_7;
    let p_w_Y_in_L_2_5 = p_w_B_2_5 + rr_p_v_rc_1_7;
    let H_fork_1_6 = IHxz.mul_add(cos_lam, IHxx * sin_lam);
    let H_fork_3_6 = IHzz.mul_add(cos_lam, IHxz * sin_lam);
    let p_w_F_3_6 = H_fork_1_6.mul_add(sin_lam, IFxx) + H_fork_3_6 * cos_lam
        + p_v_Ho_2_15 * minus_v_ho_2_2_of_place + p_v_FC_2_8 * v_FC_2_of_c_lam_rf;
    let p_w_S_in_F_1_6 = (-H_fork_1_6).mul_add(cos_lam, H_fork_3_6 * sin_lam)
        - p_v_Ho_2_15 * v_Ho_1_of_lam_rr_xh_zh + p_v_FC_2_8 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_6 = p_v_Ho_2_16.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3_6);
    let p_w_B_in_S_1_6 = p_w_S_in_F_1_6 * cos_delta;
    let p_w_B_2_6 = p_w_S_in_F_1_6 * sin_delta;
    let p_w_L_in_B_3_6 = p_w_B_in_S_1_6.mul_add(sin_lam, p_w_B_in_S_3_6 * cos_lam);
    let p_w_L_in_B_1_6 = (-p_w_B_in_S_1_6).mul_add(cos_lam, p_w_B_in_S_3_6 * sin_lam);
    let p_w_Y_in_L_3_6 = (-p_w_L_in_B_1_6)
        .mul_add(sin_theta, p_w_L_in_B_3_6 * cos_theta);
    let p_w_Y_in_L_2_6 = rR.mul_add(p_v_RC_1_8, p_w_B_2_6);
    let p_w_B_in_S_1_7 = IFyy * sin_delta;
    let p_w_L_in_B_3_7 = p_w_B_in_S_1_7 * sin_lam;
    let p_w_L_in_B_1_7 = p_w_B_in_S_1_7 * cos_lam;
    let p_w_Y_in_L_3_7 = p_w_L_in_B_1_7.mul_add(sin_theta, p_w_L_in_B_3_7 * cos_theta);
    let ratio_theta_u1_2_of_motion = delta_dot
        .mul_add(ratio_theta_u2, phi_dot * ratio_theta_u1);
    let ratio_theta_u1_2_of_motion_2 = ratio_theta_u1_2_of_motion * sin_lam_plus_theta;
    let ratio_psi_u1_2_of_delta_dot = delta_dot_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_motion = (-ratio_theta_u1_2_of_motion_2)
        .mul_add(sin_delta, ratio_psi_u1_2_of_delta_dot);
    let ratio_theta_u1_2_of_motion_3 = (-ratio_theta_u1_of_place_10)
        .mul_add(ratio_theta_u1_2_of_motion, phi_dot_sin_phi * sin_lam_plus_theta);
    let ratio_theta_u1_2_of_motion_4 = delta_dot_cos_delta
        .mul_add(sin_phi, phi_dot_cos_phi * sin_delta);
    let ratio_theta_u1_2_of_motion_5 = ratio_theta_u1_2_of_motion_3
        .mul_add(cos_delta, delta_dot_sin_delta * ratio_theta_u1_of_place)
        + ratio_theta_u1_2_of_motion_4;
    let ratio_theta_u1_2_of_motion_6 = (-phi_dot_cos_phi)
        .mul_add(cos_delta, delta_dot_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_motion_7 = (-delta_dot_cos_delta)
        .mul_add(ratio_theta_u1_of_place, ratio_theta_u1_2_of_motion_3 * sin_delta);
    let ratio_theta_u1_2_of_motion_8 = -ratio_theta_u1_2_of_motion_6 - ratio_theta_u1_2_of_motion_7;
    let ratio_theta_u1_2_of_motion_9 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_motion_5,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_motion_8,
        );
    let ratio_psi_u1_2_of_motion_2 = ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_motion;
    let ratio_psi_u1_2_of_motion_3 = ratio_psi_u1_of_place
        .mul_add(ratio_theta_u1_2_of_motion_9, ratio_psi_u1_2_of_motion_2);
    let ratio_psi_u1_2_of_motion_4 = ratio_theta_u1_2_of_motion * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_phi_dot = phi_dot * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_motion_10 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_motion_8;
    let ratio_psi_u1_2_of_motion_5 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_phi_dot, ratio_theta_u1_2_of_motion_10);
    let ratio_psi_u1_2_of_delta_dot_2 = delta_dot_sin_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_motion_6 = S::int(2) * ratio_theta_u1_2_of_motion_2;
    let ratio_psi_u1_2_of_motion_7 = ratio_theta_u1_2_of_motion_9
        .mul_add(sin_lam_plus_theta, v_FC_1_5 * ratio_theta_u1_2_of_motion_2)
        + ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_motion_4
        - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_motion_5
        + ratio_theta_u1_of_place_12 * ratio_psi_u1_2_of_delta_dot_2
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_motion_6;
    let ratio_psi_u1_2_of_motion_8 = ratio_theta_u1_2_of_motion_2
        .mul_add(cos_delta, ratio_psi_u1_2_of_delta_dot_2);
    let ratio_psi_u1_2_of_motion_9 = v_FC_1_of_w_lam_rr_rf * ratio_psi_u1_2_of_motion
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_motion_5
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_motion_6
                .mul_add(sin_delta, -ratio_psi_u1_2_of_delta_dot);
    let ratio_theta_u1_2_of_delta_dot = delta_dot_sin_delta * ratio_theta_u1_of_place_9;
    let ratio_psi_u1_2_of_motion_10 = (-ratio_theta_u1_2_of_motion_9)
        .mul_add(cos_delta, ratio_theta_u1_2_of_delta_dot);
    let ratio_theta_u1_2_of_motion_11 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_2_of_motion, ratio_theta_u1_2_of_phi_dot);
    let ratio_theta_u1_2_of_motion_12 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_motion_11, ratio_theta_u1_2_of_motion_10);
    let ratio_psi_u1_2_of_motion_11 = ratio_theta_u1_2_of_motion_12
        .mul_add(sin_delta, delta_dot_cos_delta * ratio_theta_u1_of_place_12);
    let ratio_theta_u1_2_of_motion_13 = ratio_theta_u1_2_of_motion_12 * cos_delta;
    let ratio_psi_u1_2_of_motion_12 = (-delta_dot_sin_delta)
        .mul_add(ratio_theta_u1_of_place_12, ratio_theta_u1_2_of_motion_13);
    let ratio_psi_u1_2_of_motion_13 = (-ratio_theta_u1_of_place_13)
        .mul_add(
            ratio_psi_u1_2_of_motion_4,
            ratio_psi_u1_of_place_6 * ratio_psi_u1_2_of_motion,
        ) + ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_motion_8
        + ratio_psi_u1_2_of_motion_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_motion_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_motion_12;
    let ratio_theta_u1_2_of_motion_14 = ratio_theta_u1_of_place_20
        .mul_add(ratio_theta_u1_2_of_motion, phi_dot * ratio_theta_u1_of_place);
    let ratio_theta_u1_2_of_place = sin_phi * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_motion_15 = (-phi_dot_sin_phi)
        .mul_add(sin_delta, delta_dot_cos_delta * cos_phi)
        + ratio_theta_u1_2_of_motion_14 * cos_delta
        - delta_dot_sin_delta * ratio_theta_u1_2_of_place;
    let ratio_theta_u1_2_of_motion_16 = -ratio_theta_u1_2_of_motion_9;
    let ratio_theta_u1_2_of_motion_17 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_motion_8
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_motion_18 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_motion_17;
    let ratio_theta_u1_2_of_motion_19 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_motion_5, ratio_theta_u1_2_of_motion_18);
    let ratio_theta_u1_2_of_motion_20 = phi_dot
        .mul_add(ratio_theta_u1_of_place_4, delta_dot_sin_delta * cos_phi)
        + ratio_psi_u1_of_place * ratio_theta_u1_2_of_motion * sin_phi
        + delta_dot_cos_delta * ratio_theta_u1_2_of_place;
    let ratio_theta_u1_2_of_motion_21 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_motion_8;
    let ratio_theta_u1_2_of_motion_22 = (-phi_dot)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_motion_2 * sin_phi);
    let ratio_theta_u1_2_of_motion_23 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_motion_17;
    let ratio_theta_u1_2_of_motion_24 = v_Ho_2_of_w_c_lam_rr_2
        .mul_add(ratio_theta_u1_2_of_motion_14, rR * phi_dot_cos_phi);
    let ratio_theta_u1_2_of_motion_25 = ratio_theta_u1_2_of_motion_11 * sin_delta;
    let ratio_theta_u1_2_of_motion_26 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_motion_23
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_motion_3
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_motion_21
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_motion_25)
                .mul_add(S::int(2), delta_dot_cos_delta * ratio_theta_u1_of_place_10);
    let ratio_theta_u1_2_of_motion_27 = ratio_theta_u1_2_of_motion_16
        .mul_add(cos_delta, ratio_theta_u1_2_of_motion_26);
    let ratio_theta_u1_2_of_motion_28 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_motion_3
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_motion_5
        - ratio_theta_u1_of_place_29 * ratio_theta_u1_2_of_motion_11
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_motion_12
        + ratio_theta_u1_of_place_2
            * ((-delta_dot_sin_delta)
                .mul_add(
                    ratio_theta_u1_of_place_11,
                    delta_dot_cos_delta * ratio_theta_u1_of_place_24,
                ) - ratio_theta_u1_2_of_motion_13
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_motion_19
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_motion_25)
        + ratio_theta_u1_of_place_10
            * (ratio_theta_u1_2_of_delta_dot + ratio_theta_u1_2_of_motion_27);
    let ratio_theta_u1_2_of_motion_29 = ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_motion_15
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_motion_5
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_motion_11
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_motion_12
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_motion_16
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_motion_15,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_motion_21,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_motion_19
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_motion_20)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_motion_22
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_motion_20
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_motion_21
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_motion_22
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_motion_11, ratio_theta_u1_2_of_motion_23,
                        )) + ratio_theta_u1_2_of_motion_24;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_30
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_motion_28, ratio_theta_u1_2_of_motion_29);
    let ratio_psi_u1_2_of_motion_14 = (-ratio_theta_u1_2)
        .mul_add(
            ratio_psi_u1_of_place_8,
            ratio_psi_u1_2_of_motion_3 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_motion
        + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_motion_4
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_motion_7
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_2_of_motion_8
        - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_motion_9
        + ratio_theta_u1 * ratio_psi_u1_2_of_motion_13;
    let ratio_psi_u1_2_of_motion_15 = (-ratio_theta_u1_of_place_20)
        .mul_add(
            ratio_psi_u1_2_of_motion_10,
            ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_motion_11,
        ) + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_motion_12
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_motion_15
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_motion_20
        - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_motion_22;
    let ratio_psi_u1_2_of_motion_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_15, rR * phi_dot_sin_phi)
        + v_Ho_2_of_w_c_lam_rr_2 * ratio_theta_u1_2_of_motion_3
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_motion_3
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_motion_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_motion_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_motion_15
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_motion_20
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_motion_22
        - ratio_theta_u1 * ratio_psi_u1_2_of_motion_15;
    let ratio_psi_u1_2_of_motion_17 = rR * ratio_theta_u1_2_of_motion_2;
    let ratio_psi_u1_2_of_motion_18 = phi_dot_sin_phi * ratio_psi_u1_of_place_11
        + ratio_psi_u1_of_place_12 * ratio_theta_u1_2_of_motion_4
        + sin_delta_sin_phi * ratio_psi_u1_2_of_motion_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_motion_2,
                            rr_minus_rf * ratio_psi_u1_2_of_motion_4,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_motion_4, ratio_psi_u1_2_of_motion_17,
                            )) + delta_dot_sin_delta * ratio_psi_u1_of_place_10
                + v_FC_2_of_c_lam_rf * ratio_theta_u1_2_of_motion_2);
    let ratio_psi_u1_2_of_motion_19 = ratio_psi_u1_of_place_13
        * ratio_psi_u1_of_place_14
            .mul_add(ratio_psi_u1_2_of_motion_18, ratio_psi_u1_2_of_motion);
    let ratio_psi_u1_2_of_motion_20 = ratio_psi_u1_of_place_13
        * ratio_psi_u1_of_place_17
            .mul_add(ratio_psi_u1_2_of_motion_18, ratio_theta_u1_2_of_motion_20);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_14)
        .mul_add(
            ratio_psi_u1_2_of_motion_14,
            ratio_psi_u1_of_place_17 * ratio_psi_u1_2_of_motion_16,
        ) + ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_motion_19
        - ratio_psi_u1_of_place_16 * ratio_psi_u1_2_of_motion_20;
    let ratio_theta_u2_2_of_motion = ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_motion_8;
    let ratio_theta_u2_2_of_motion_2 = ratio_theta_u2_2_of_motion
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_motion_5
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_motion_11
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_motion_16
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_motion_19
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_motion_5))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_motion_21,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_motion_8
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_motion_18);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_30
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_motion_28, ratio_theta_u2_2_of_motion_2);
    let ratio_psi_u2_2_of_motion = ratio_theta_u2_2
        .mul_add(ratio_psi_u1_of_place_8, ratio_psi_u1_2_of_motion_2)
        - ratio_theta_u2 * ratio_psi_u1_2_of_motion_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_motion_16;
    let ratio_psi_u2_2_of_motion_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_motion_16,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_15,
        ) - ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_motion_20
        + ratio_theta_u2 * ratio_psi_u1_2_of_motion_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_motion_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_motion_19,
        ) + ratio_psi_u1_of_place_14 * ratio_psi_u2_2_of_motion
        - ratio_psi_u1_of_place_17 * ratio_psi_u2_2_of_motion_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_motion_19;
    let ratio_thF_u1_2_of_motion = S::int(2) * ratio_theta_u1_2_of_motion_6;
    let ratio_thF_u1_2_of_motion_2 = -ratio_thF_u1_of_place
        * ratio_theta_u1_2_of_motion_7 - sin_phi_cos_delta * ratio_thF_u1_2_of_motion
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_motion_7 + ratio_thF_u1_2_of_motion);
    let ratio_thF_u1_2_of_motion_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_motion_2,
            S::int(2) * ratio_psi_u1_of_place_13 * ratio_psi_u1_2_of_motion_18,
        );
    let ratio_thF_u1_2_of_motion_4 = sin_lam_plus_theta
        * ratio_theta_u1_of_place_4
            .mul_add(ratio_theta_u1_2_of_motion_9, ratio_theta_u2_2_of_motion)
        + ratio_thF_u1_of_place_12 * ratio_psi_u1_2_of_motion
        + ratio_theta_u2_of_place_2 * ratio_psi_u1_2_of_motion_4
        + ratio_thF_u1_of_place_13 * ratio_psi_u1_2_of_motion_8
        - ratio_psi_u1_of_place
            * v_FC_2_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_motion_11,
                    v_FC_1_of_w_lam_rr_rf * ratio_theta_u1_2_of_motion_5,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_motion_12,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_motion_8,
                ) + ratio_theta_u1_2_of_motion_24;
    let ratio_thF_u1_2_of_motion_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_motion_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_14 * ratio_thF_u1_2_of_motion_3);
    let ratio_thF_u1_2_of_delta_dot = S::int(2) * delta_dot_sin_delta;
    let ratio_thF_u1_2_of_motion_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_motion_2,
                    S::int(2) * ratio_theta_u1_2_of_motion_8,
                ) + S::int(2) * delta_dot_cos_delta * ratio_theta_u1_of_place_4)
        + ratio_thF_u1_2_of_delta_dot * sin_lam;
    let ratio_thF_u1_2_of_delta_dot_2 = c_cos_lam * ratio_thF_u1_2_of_delta_dot;
    let ratio_thF_u1_2_of_motion_7 = S::int(2) * ratio_psi_u1_2_of_motion_4;
    let ratio_thF_u1_2_of_motion_8 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_motion_6, ratio_thF_u1_2_of_delta_dot_2)
        + ratio_thF_u1_of_place_7 * ratio_psi_u1_2_of_motion_6
        + v_FC_1_of_w_lam_rr_rf * ratio_thF_u1_2_of_motion_7;
    let ratio_thF_u1_2_of_motion_9 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_motion_3, ratio_thF_u1_2_of_motion_8);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_15;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_thF_u1_2_of_motion_5,
            ratio_psi_u1_of_place_9 * ratio_thF_u1_2_of_motion_9,
        ) - ratio_psi_u1_2_of_motion_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_motion_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_motion_9,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_motion_5,
        ) + ratio_psi_u2_2_of_motion * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_motion_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_motion = cos_lam_plus_theta
        * (-rf_inv).mul_add(ratio_thF_u1_2_of_delta_dot_2, ratio_thF_u1_2_of_motion_6)
        + ratio_thF_u3_of_place * ratio_psi_u1_2_of_motion_6
        + ratio_thF_u3_of_w_lam_rr_rf * ratio_thF_u1_2_of_motion_7;
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_motion_3, -ratio_thF_u3_2_of_motion);
    let d1_of_place = ratio_thF_u2 * H_front_wheel_2_5;
    let d1_of_place_2 = ratio_theta_u2.mul_add(p_w_Y_in_L_2_5, d1_of_place);
    let d1_of_place_3 = p_w_Y_in_L_2_6 - d1_of_place_2;
    let d1_of_place_4 = ratio_psi_u2 * p_w_Y_in_L_2_3;
    let d1_of_place_5 = (-ratio_thF_u2)
        .mul_add(p_w_Y_in_L_3_7, ratio_theta_u2 * p_w_Y_in_L_3_5);
    let d1_of_place_6 = p_w_Y_in_L_3_6 - d1_of_place_5;
    let d1_of_place_7 = ratio_psi_u2 * p_w_Y_in_L_3_3;
    let d1_of_place_8 = d1_of_place - p_w_B_2_6;
    let ratio_theta_u2_p_w_b_2_5 = ratio_theta_u2 * p_w_B_2_5;
    let ifyy_ratio_thf_u2 = IFyy * ratio_thF_u2;
    let d1 = p_w_F_3_6
        + ratio_psi_u2
            * (sin_phi * d1_of_place_3.mul_add(S::int(2), d1_of_place_4)
                + cos_phi * (-d1_of_place_6).mul_add(S::int(2), d1_of_place_7))
        + ratio_theta_u2 * d1_of_place_8.mul_add(S::int(2), ratio_theta_u2_p_w_b_2_5)
        + ratio_thF_u2 * ifyy_ratio_thf_u2;
    let l2_of_place = d1_of_place_3 + d1_of_place_4;
    let l2_of_place_2 = d1_of_place_6 - d1_of_place_7;
    let l2_of_place_3 = (-l2_of_place_2).mul_add(cos_phi, l2_of_place * sin_phi);
    let l2_of_place_4 = ratio_thF_u1 * H_front_wheel_2_5;
    let l2_of_place_5 = ratio_theta_u1.mul_add(p_w_Y_in_L_2_5, l2_of_place_4);
    let l2_of_place_6 = p_w_Y_in_L_2_4 - l2_of_place_5;
    let l2_of_place_7 = (-ratio_thF_u1)
        .mul_add(p_w_Y_in_L_3_7, ratio_theta_u1 * p_w_Y_in_L_3_5);
    let l2_of_place_8 = p_w_Y_in_L_3_4 - l2_of_place_7;
    let l2_of_place_9 = p_w_L_in_B_3_5.mul_add(sin_theta, rR * p_v_Ho_2_14);
    let l2_of_place_10 = p_w_L_in_B_1_5.mul_add(cos_theta, -l2_of_place_4);
    let l2_of_place_11 = l2_of_place_9 + l2_of_place_10;
    let ratio_theta_u1_p_w_b_2_5 = ratio_theta_u1 * p_w_B_2_5;
    let l2_of_place_12 = l2_of_place_11 - ratio_theta_u1_p_w_b_2_5;
    let l2_of_place_13 = (-p_w_L_in_B_3_7)
        .mul_add(sin_theta, p_w_L_in_B_1_7 * cos_theta);
    let ifyy_ratio_thf_u1 = IFyy * ratio_thF_u1;
    let l2_of_place_14 = ratio_theta_u1.mul_add(H_front_wheel_2_5, ifyy_ratio_thf_u1);
    let l2_of_place_15 = l2_of_place_13 - l2_of_place_14;
    let l2_of_place_16 = rR * p_v_Ho_2_16 - ratio_theta_u1 * p_w_B_2_6
        + p_w_L_in_B_3_6 * sin_theta + p_w_L_in_B_1_6 * cos_theta + ratio_psi_u1 * l2_of_place_3
        + ratio_psi_u2 * (-l2_of_place_8).mul_add(cos_phi, l2_of_place_6 * sin_phi)
        - ratio_theta_u2 * l2_of_place_12 - ratio_thF_u2 * l2_of_place_15;
    let d1_inv = S::int(1) / d1;
    let l2 = l2_of_place_16 * d1_inv;
    let s3_of_place = ratio_psi_u1 * p_w_Y_in_L_2_3;
    let s3_of_place_2 = ratio_psi_u1 * p_w_Y_in_L_3_3;
    let s3 = IRxx + rR * p_v_RC_2_6 + p_w_L_in_B_3_4 * sin_theta + p_w_L_in_B_1_4 * cos_theta
        + ratio_theta_u1 * (-l2_of_place_11).mul_add(S::int(2), ratio_theta_u1_p_w_b_2_5)
        + ratio_thF_u1 * (-l2_of_place_13).mul_add(S::int(2), ifyy_ratio_thf_u1)
        - l2 * l2_of_place_16
        + ratio_psi_u1
            * (sin_phi * l2_of_place_6.mul_add(S::int(2), s3_of_place)
                + cos_phi * (-l2_of_place_8).mul_add(S::int(2), s3_of_place_2));
    let s4_of_place = l2_of_place_6 + s3_of_place;
    let s4_of_place_2 = l2_of_place_8 - s3_of_place_2;
    let s4_of_place_3 = (-ratio_psi_u2).mul_add(l2, ratio_psi_u1);
    let cos_phi_p_w_y_in_l_3_7 = p_w_Y_in_L_3_7 * cos_phi;
    let s4_of_place_4 = ratio_theta_u2.mul_add(p_v_RC_1_7, -p_v_RC_1_8);
    let s4_of_place_5 = (-ratio_theta_u1).mul_add(p_v_RC_1_7, ratio_psi_u1 * p_v_RC_1_5);
    let s4_of_place_6 = p_v_RC_1_6 + s4_of_place_5;
    let s4 = ratio_psi_u3
        * (sin_phi * (-l2).mul_add(l2_of_place, s4_of_place)
            + cos_phi * l2.mul_add(l2_of_place_2, -s4_of_place_2))
        - H_rear_wheel_2_3 * s4_of_place_3
        + ratio_thF_u3
            * (IFyy * (-ratio_thF_u2).mul_add(l2, ratio_thF_u1) - l2_of_place_13
                + H_front_wheel_2_5
                    * ((-ratio_theta_u2).mul_add(l2, ratio_theta_u1) - s4_of_place_3 * sin_phi)
                - s4_of_place_3 * cos_phi_p_w_y_in_l_3_7)
        - rR * (l2 * (-ratio_psi_u2).mul_add(p_v_RC_1_5, s4_of_place_4) + s4_of_place_6);
    let r5_of_phi_dot = p_w_B_2_2
        + sin_theta
            * ((-v_Y_in_L_3).mul_add(p_v_L_in_B_3, v_RC_1 * p_v_L_in_B_1)
                + w_Y_in_L_3 * p_w_L_in_B_3 + phi_dot * p_w_L_in_B_1
                + F_x_F_1_2 * x_N_in_Y_1 - F_x_F_3 * x_F_3 + x_Y_in_L_3 * F_x_L_in_B_3)
        + cos_theta
            * ((-v_RC_1).mul_add(p_v_L_in_B_3, w_Y_in_L_3 * p_w_L_in_B_1)
                - v_Y_in_L_3 * p_v_L_in_B_1 - phi_dot * p_w_L_in_B_3
                - F_x_F_3 * x_N_in_Y_1 - F_x_F_1_2 * x_F_3 + x_Y_in_L_3 * F_x_L_in_B_1);
    let r5_of_motion = sin_psi
        * (y_dot.mul_add(p_v_N_in_Y_2, x_dot * p_v_RC_1) - F_x_N_in_Y_1 * mp_N_1
            + F_x_N_in_Y_2 * mp_N_2)
        + cos_psi
            * ((-y_dot).mul_add(p_v_RC_1, x_dot * p_v_N_in_Y_2) + F_x_N_in_Y_2 * mp_N_1
                + F_x_N_in_Y_1 * mp_N_2)
        + phi_dot * (-p_w_Y_in_L_2).mul_add(cos_phi, p_w_Y_in_L_3 * sin_phi)
        + p_w_Y_in_L_3_2 * cos_phi - p_w_Y_in_L_2_2 * sin_phi;
    let r5_of_motion_2 = delta_dot.mul_add(ratio_psi_u2_2, phi_dot * ratio_psi_u1_2);
    let r5_of_motion_3 = thR_dot.mul_add(ratio_psi_u3_2, r5_of_motion_2);
    let r5_of_motion_4 = delta_dot.mul_add(ratio_theta_u2_2, phi_dot * ratio_theta_u1_2);
    let r5_of_place = (-p_w_Y_in_L_2_5).mul_add(sin_phi, p_w_Y_in_L_3_5 * cos_phi);
    let r5_of_place_2 = H_front_wheel_2_5.mul_add(sin_phi, cos_phi_p_w_y_in_l_3_7);
    let r5_of_motion_5 = delta_dot.mul_add(ratio_thF_u2_2, phi_dot * ratio_thF_u1_2);
    let r5_of_motion_6 = thR_dot.mul_add(ratio_thF_u3_2, r5_of_motion_5);
    let r5_of_motion_6_halved = S::ratio(1, 2) * r5_of_motion_6;
    let r5_of_place_3 = ratio_psi_u1.mul_add(p_v_N_in_Y_2_5, p_v_N_in_Y_2_6)
        - ratio_theta_u1 * p_v_N_in_Y_2_7;
    let r5_of_motion_7 = thR_dot.mul_add(ratio_psi_u3, phi_dot * ratio_psi_u1);
    let r5_of_motion_8 = rR * thR_dot * delta_dot.mul_add(ratio_psi_u2, r5_of_motion_7);
    let sin_psi_r5_of_motion_8 = r5_of_motion_8 * sin_psi;
    let cos_psi_r5_of_motion_8 = r5_of_motion_8 * cos_psi;
    let r5_of_place_4 = ratio_theta_u2.mul_add(H_front_wheel_2_5, ifyy_ratio_thf_u2);
    let r5_of_place_5 = ratio_psi_u2.mul_add(r5_of_place_2, -r5_of_place_4);
    let l2_of_place_3_doubled = S::int(2) * l2_of_place_3;
    let r5_of_place_6 = (-ratio_psi_u2)
        .mul_add(r5_of_place, -d1_of_place_8 - ratio_theta_u2_p_w_b_2_5);
    let r5_of_place_6_doubled = S::int(2) * r5_of_place_6;
    let r5_of_phi_dot_2 = ratio_theta_u2
        .mul_add(r5_of_phi_dot, H_front_wheel_2_2 * ratio_thF_u2);
    let r5_of_place_7 = ratio_theta_u2.mul_add(p_v_N_in_Y_2_7, -p_v_N_in_Y_2_8);
    let r5_of_motion_9 = sin_delta
        * ((-v_B_in_S_1).mul_add(p_v_S_in_F_1, v_Ho_2 * p_v_S_in_F_2)
            + w_B_2 * p_w_S_in_F_2 + w_B_in_S_1 * p_w_S_in_F_1
            - x_S_in_F_2 * x_Y_in_L_2_2 - x_S_in_F_1 * x_F_1_2
            - x_Y_in_L_2 * x_S_in_F_2_2 + x_B_in_S_1 * x_F_1_3) + ratio_psi_u2 * r5_of_motion;
    let r5_of_place_8 = p_w_F_3_2
        + cos_delta
            * ((-v_B_in_S_1).mul_add(p_v_S_in_F_2, w_B_2 * p_w_S_in_F_1)
                - v_Ho_2 * p_v_S_in_F_1 - w_B_in_S_1 * p_w_S_in_F_2
                - x_S_in_F_1 * x_Y_in_L_2_2 + x_S_in_F_2 * x_F_1_2
                + x_B_in_S_1 * x_S_in_F_2_2 + x_Y_in_L_2 * x_F_1_3);
    let r5_of_motion_10 = phi_dot
        * ((-ratio_thF_u1_2)
            .mul_add(r5_of_place_5, ratio_psi_u1_2 * l2_of_place_3_doubled)
            - ratio_theta_u1_2 * r5_of_place_6_doubled)
        + thR_dot
            * (ratio_psi_u3_2 * l2_of_place_3_doubled - ratio_thF_u3_2 * r5_of_place_5
                - S::int(2) * rR
                    * (ratio_psi_u2
                        * (delta_dot * ratio_psi_u2.mul_add(p_v_N_in_Y_2_5, -r5_of_place_7)
                            + p_v_N_in_Y_2_5 * r5_of_motion_7) - r5_of_motion_7 * r5_of_place_7));
    let r5_of_motion_11 = r5_of_motion_9 + r5_of_place_8;
    let r5_of_motion_12 = delta_dot
        * ((-ratio_thF_u2_2)
            .mul_add(r5_of_place_5, ratio_psi_u2_2 * l2_of_place_3_doubled)
            - ratio_theta_u2_2 * r5_of_place_6_doubled) + S::int(2) * r5_of_phi_dot_2;
    let r5_of_motion_13 = r5_of_motion_11.mul_add(S::int(2), r5_of_motion_10);
    let r5_of_motion_14 = r5_of_motion_12 + r5_of_motion_13;
    let r5_of_motion_14_halved = S::ratio(1, 2) * r5_of_motion_14;
    let r5 = p_w_L_in_B_3_2 * sin_theta - rR * p_v_RC_2_2 + p_w_L_in_B_1_2 * cos_theta
        + sin_phi
            * ((-psi_dot).mul_add(p_w_Y_in_L_3, v_N_in_Y_2 * p_v_RC_2)
                + F_x_Y_in_L_2 * x_N_in_Y_2 - g * F_x_Y_in_L_3)
        + cos_phi
            * ((-g).mul_add(F_x_Y_in_L_2_2, v_N_in_Y_2 * p_v_Y_in_L_3)
                + psi_dot * p_w_Y_in_L_2 + F_x_F_3_2 * x_N_in_Y_2)
        - H_front_wheel_2_2 * ratio_thF_u1 - theta_dot * p_w_Y_in_L_3_of_place
        - ratio_theta_u1 * r5_of_phi_dot - ratio_psi_u1 * r5_of_motion
        + r5_of_motion_3 * (-s4_of_place).mul_add(sin_phi, s4_of_place_2 * cos_phi)
        + r5_of_motion_4 * (-ratio_psi_u1).mul_add(r5_of_place, l2_of_place_12)
        + r5_of_motion_6_halved * ratio_psi_u1.mul_add(r5_of_place_2, l2_of_place_15)
        + sin_psi_r5_of_motion_8 * r5_of_place_3.mul_add(sin_psi, s4_of_place_6 * cos_psi)
        + cos_psi_r5_of_motion_8 * (-s4_of_place_6).mul_add(sin_psi, r5_of_place_3 * cos_psi)
        + l2 * r5_of_motion_14_halved;
    let l6_of_place = ratio_thF_u3 * H_front_wheel_2_5;
    let iryy_plus_l6_of_place = IRyy + l6_of_place;
    let l6_of_place_2 = ratio_psi_u3 * l2_of_place_3 + rR * s4_of_place_4
        + ratio_thF_u3 * r5_of_place_4
        - ratio_psi_u2
            * (ratio_thF_u3.mul_add(cos_phi_p_w_y_in_l_3_7, rr_p_v_rc_1_5)
                + iryy_plus_l6_of_place * sin_phi);
    let l6 = d1_inv * l6_of_place_2;
    let s7_of_place = p_v_N_in_Y_2_3 + p_v_RC_1_4;
    let s7_of_place_2 = ratio_psi_u3 * p_w_Y_in_L_2_3;
    let s7_of_place_3 = ratio_thF_u3 * p_w_Y_in_L_3_7;
    let s7_of_place_4 = ratio_psi_u3 * p_w_Y_in_L_3_3;
    let ifyy_ratio_thf_u3 = IFyy * ratio_thF_u3;
    let s7 = IRyy - l6 * l6_of_place_2
        + rR
            * (rR
                * (cos_psi
                    * (cos_psi
                        * (cos_psi * (p_v_RC_1_3 + p_v_N_in_Y_2_4)
                            + s7_of_place * sin_psi) - p_v_N_in_Y_2_4)
                    + p_v_RC_1_4 * sin_psi) - S::int(2) * ratio_psi_u3 * p_v_RC_1_5)
        - ratio_psi_u3
            * (sin_phi * iryy_plus_l6_of_place.mul_add(S::int(2), -s7_of_place_2)
                + cos_phi * s7_of_place_3.mul_add(S::int(2), -s7_of_place_4))
        + ratio_thF_u3 * ifyy_ratio_thf_u3;
    let r8 = rR
        * (-p_v_RC_1_2 + psi_dot * p_v_N_in_Y_2
            - mp_N_1_of_mr_mb_mh_mf * (-F_mp_N_2).mul_add(sin_psi, F_mp_N_1 * cos_psi))
        - H_rear_wheel_2_2 - H_front_wheel_2_2 * ratio_thF_u3 - ratio_psi_u3 * r5_of_motion
        + cos_psi_r5_of_motion_8
            * (ratio_psi_u3 * (-p_v_RC_1_5).mul_add(sin_psi, p_v_N_in_Y_2_5 * cos_psi)
                + rR * p_v_RC_1_4) + l6 * r5_of_motion_14_halved
        - r5_of_motion_4 * (ratio_psi_u3.mul_add(r5_of_place, rr_p_v_rc_1_7) + l6_of_place)
        + sin_psi_r5_of_motion_8
            * (ratio_psi_u3 * p_v_N_in_Y_2_5.mul_add(sin_psi, p_v_RC_1_5 * cos_psi)
                - rR
                    * (p_v_RC_1_3 * cos_psi * cos_psi
                        + sin_psi * (-p_v_N_in_Y_2_4).mul_add(sin_psi, s7_of_place * cos_psi)))
        + r5_of_motion_3
            * (rr_p_v_rc_1_5 + sin_phi * (iryy_plus_l6_of_place - s7_of_place_2)
                + cos_phi * (s7_of_place_3 - s7_of_place_4))
        + r5_of_motion_6_halved * ratio_psi_u3.mul_add(r5_of_place_2, -ifyy_ratio_thf_u3);
    let s3_inv = S::int(1) / s3;
    let l9 = s4 * s3_inv;
    let s10 = (-s4).mul_add(l9, s7);
    let r11 = (-r5).mul_add(l9, r8);
    let u3_dot = r11 / s10;
    let u1_dot = s3_inv * (-u3_dot).mul_add(s4, r5);
    let u2_dot_of_motion = u3_dot.mul_add(l6_of_place_2, u1_dot * l2_of_place_16);
    let u2_dot = -S::ratio(1, 2) * d1_inv * u2_dot_of_motion.mul_add(S::int(2), r5_of_motion_14);
    let rr_u3_dot = rR * u3_dot;
    let x_ddot = (-rr_u3_dot).mul_add(cos_psi, -sin_psi_r5_of_motion_8);
    let y_ddot = (-rr_u3_dot).mul_add(sin_psi, cos_psi_r5_of_motion_8);
    let psi_ddot = (-u2_dot).mul_add(ratio_psi_u2, -u1_dot * ratio_psi_u1)
        - u3_dot * ratio_psi_u3 - r5_of_motion_3;
    let phi_ddot = u1_dot;
    let theta_ddot = u2_dot.mul_add(ratio_theta_u2, u1_dot * ratio_theta_u1) + r5_of_motion_4;
    let delta_ddot = u2_dot;
    let thR_ddot = u3_dot;
    let thF_ddot = u2_dot.mul_add(ratio_thF_u2, u1_dot * ratio_thF_u1)
        + u3_dot * ratio_thF_u3 + r5_of_motion_6_halved;
    [x_ddot, y_ddot, psi_ddot, phi_ddot, theta_ddot, delta_ddot, thR_ddot, thF_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 8],
    q_dot: &[S; 8],
) -> [S; 8] {
    let [x_dot, y_dot, psi_dot, phi_dot, theta_dot, delta_dot, thR_dot, thF_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // psi'
    let psi_dot_value = psi_dot;
    // phi'
    let phi_dot_value = phi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // delta'
    let delta_dot_value = delta_dot;
    // thR'
    let thR_dot_value = thR_dot;
    // thF'
    let thF_dot_value = thF_dot;
    [
        x_dot_value, y_dot_value, psi_dot_value, phi_dot_value, theta_dot_value, delta_dot_value,
        thR_dot_value, thF_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 185 operations, 5 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 8], q_dot: &[S; 8]) -> S {
    let Parameters {
        w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx, IHxz,
        IHyy, IHzz, rF, mF, IFxx, IFyy,
        ..
    } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [x_dot, y_dot, psi_dot, phi_dot, theta_dot, delta_dot, thR_dot, thF_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_Y_in_L_2 = psi_dot * sin_phi;
    let w_Y_in_L_3 = psi_dot * cos_phi;
    let w_L_in_B_1 = (-w_Y_in_L_3).mul_add(sin_theta, phi_dot * cos_theta);
    let w_L_in_B_3 = w_Y_in_L_3.mul_add(cos_theta, phi_dot * sin_theta);
    let w_B_2 = theta_dot + w_Y_in_L_2;
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1 = (-w_B_2).mul_add(sin_delta, w_B_in_S_1 * cos_delta);
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = delta_dot + w_B_in_S_3;
    let v_N_in_Y_1 = y_dot.mul_add(sin_psi, x_dot * cos_psi);
    let v_N_in_Y_2 = (-y_dot).mul_add(cos_psi, x_dot * sin_psi);
    let v_Y_in_L_2 = v_N_in_Y_2 * cos_phi;
    let v_Y_in_L_3 = v_N_in_Y_2 * sin_phi;
    let v_RC_1 = rR.mul_add(w_Y_in_L_2, -v_N_in_Y_1);
    let v_RC_2 = rR.mul_add(phi_dot, -v_Y_in_L_2);
    let v_L_in_B_1 = v_RC_1.mul_add(cos_theta, v_Y_in_L_3 * sin_theta);
    let v_L_in_B_3 = (-v_RC_1).mul_add(sin_theta, v_Y_in_L_3 * cos_theta);
    let rr_plus_zb = rR + zB;
    let v_Bo_1 = w_B_2.mul_add(rr_plus_zb, -v_L_in_B_1);
    let v_Bo_2 = xB.mul_add(w_L_in_B_3, v_RC_2) - w_L_in_B_1 * rr_plus_zb;
    let v_Bo_3 = xB.mul_add(w_B_2, -v_L_in_B_3);
    let v_B_in_S_1 = v_L_in_B_3.mul_add(sin_lam, v_L_in_B_1 * cos_lam);
    let v_B_in_S_3 = (-v_L_in_B_1).mul_add(sin_lam, v_L_in_B_3 * cos_lam);
    let v_Ho_2_of_w_c_lam_rr = -cos_lam * (w + c) + rR * sin_lam;
    let v_Ho_2_of_w_c_lam_rr_2 = -v_Ho_2_of_w_c_lam_rr;
    let v_Ho_2 = w_B_in_S_3.mul_add(v_Ho_2_of_w_c_lam_rr_2, v_RC_2);
    let v_Ho_3 = w_B_2.mul_add(v_Ho_2_of_w_c_lam_rr_2, -v_B_in_S_3);
    let v_S_in_F_1 = (-v_Ho_2).mul_add(sin_delta, v_B_in_S_1 * cos_delta);
    let v_S_in_F_2 = v_Ho_2.mul_add(cos_delta, v_B_in_S_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let v_Ho_1_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let v_Ho_1 = w_S_in_F_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_1);
    let v_Ho_2_2_of_place = (-xH).mul_add(cos_lam, rr_plus_zh * sin_lam) - v_Ho_2_of_w_c_lam_rr;
    let v_Ho_2_2 = w_F_3.mul_add(v_Ho_2_2_of_place, -v_S_in_F_2)
        - w_S_in_F_1 * v_Ho_1_of_lam_rr_xh_zh;
    let v_Ho_3_2 = w_S_in_F_2.mul_add(v_Ho_2_2_of_place, -v_Ho_3);
    let v_FC_1_of_w_lam_rr_rf = cos_lam * (rR - rF) + w * sin_lam;
    let v_FC_1 = w_S_in_F_2.mul_add(v_FC_1_of_w_lam_rr_rf, -v_S_in_F_1);
    let v_FC_2_of_c_lam_rf = (-c).mul_add(cos_lam, rF * sin_lam);
    let v_FC_2 = w_S_in_F_1.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2) + w_F_3 * v_FC_2_of_c_lam_rf;
    let v_FC_3 = w_S_in_F_2.mul_add(v_FC_2_of_c_lam_rf, v_Ho_3);
    let w_RW_2 = thR_dot + w_Y_in_L_2;
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let w_FW_2 = thF_dot + w_S_in_F_2;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let H_rear_wheel_1 = IRxx * phi_dot;
    let v_rc_1_sq_plus_v_rc_2_sq = v_RC_2.mul_add(v_RC_2, v_RC_1 * v_RC_1);
    let v_bo_1_sq_plus_v_bo_2_sq = v_Bo_2.mul_add(v_Bo_2, v_Bo_1 * v_Bo_1);
    let energy_of_place = v_Ho_2_2.mul_add(v_Ho_2_2, v_Ho_1 * v_Ho_1);
    let v_fc_1_sq_plus_v_fc_2_sq = v_FC_2.mul_add(v_FC_2, v_FC_1 * v_FC_1);
    let energy_of_place_2 = w_S_in_F_1.mul_add(H_front_wheel_1, w_F_in_H_3 * H_fork_3);
    let energy_of_place_3 = w_F_3.mul_add(H_front_wheel_3, w_FW_2 * H_front_wheel_2);
    let energy_of_phi_dot = phi_dot.mul_add(H_rear_wheel_1, w_RW_2 * H_rear_wheel_2);
    let energy_of_place_4 = w_L_in_B_1.mul_add(H_frame_1, w_Y_in_L_3 * H_rear_wheel_3);
    let energy_of_place_5 = w_L_in_B_3.mul_add(H_frame_3, w_B_2 * H_frame_2);
    let energy_of_place_6 = w_S_in_F_2.mul_add(H_fork_2, w_F_in_H_1 * H_fork_1);
    let energy_of_phi_dot_2 = energy_of_phi_dot + energy_of_place_4;
    let energy_of_place_7 = energy_of_place_5 + energy_of_place_6;
    let energy_of_place_8 = energy_of_place_2 + energy_of_place_3;
    let energy_of_phi_dot_3 = energy_of_phi_dot_2 + energy_of_place_7;
    let energy_of_phi_dot_4 = energy_of_place_8 + energy_of_phi_dot_3;
    // Values.
    let energy = S::ratio(1, 2) * mR * v_Y_in_L_3.mul_add(v_Y_in_L_3, v_rc_1_sq_plus_v_rc_2_sq)
        + S::ratio(1, 2) * mB * v_Bo_3.mul_add(v_Bo_3, v_bo_1_sq_plus_v_bo_2_sq)
        + S::ratio(1, 2) * mH * v_Ho_3_2.mul_add(v_Ho_3_2, energy_of_place)
        + S::ratio(1, 2) * mF * v_FC_3.mul_add(v_FC_3, v_fc_1_sq_plus_v_fc_2_sq)
        + S::ratio(1, 2) * energy_of_phi_dot_4;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 89 operations, 5 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 8]) -> S {
    let Parameters { w, c, lam, g, rR, mR, xB, zB, mB, xH, zH, mH, rF, mF, .. } = *p;
    let [x, y, psi, phi, theta, delta, _, _] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let x_Y_in_L_2 = g * sin_phi;
    let x_Y_in_L_3 = g * cos_phi;
    let x_L_in_B_1 = x_Y_in_L_3 * sin_theta;
    let x_L_in_B_3 = x_Y_in_L_3 * cos_theta;
    let x_B_in_S_1 = x_L_in_B_3.mul_add(sin_lam, x_L_in_B_1 * cos_lam);
    let x_B_in_S_3 = (-x_L_in_B_1).mul_add(sin_lam, x_L_in_B_3 * cos_lam);
    let x_S_in_F_1 = (-x_Y_in_L_2).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let x_S_in_F_2 = x_B_in_S_1.mul_add(sin_delta, x_Y_in_L_2 * cos_delta);
    let mh_plus_mf = mH + mF;
    let mr_plus_mb = mR + mB;
    let mp_N_1_of_mr_mb_mh_mf = mh_plus_mf + mr_plus_mb;
    let mp_N_1 = x * mp_N_1_of_mr_mb_mh_mf;
    let mp_N_2 = y * mp_N_1_of_mr_mb_mh_mf;
    let mp_L_3 = rR * mp_N_1_of_mr_mb_mh_mf;
    let mp_B_1 = xB * mB;
    let mp_B_3 = mB * (rR + zB);
    let mp_S_1_of_w_c_lam_rr = -cos_lam * (w + c) + rR * sin_lam;
    let mp_S_1 = -mh_plus_mf * mp_S_1_of_w_c_lam_rr;
    let rr_plus_zh = rR + zH;
    let mp_F_1 = mF * (-rF).mul_add(sin_lam, c * cos_lam)
        + mH * ((-xH).mul_add(cos_lam, rr_plus_zh * sin_lam) - mp_S_1_of_w_c_lam_rr);
    let mp_F_3 = mF * (cos_lam * (rR - rF) + w * sin_lam)
        + mH * rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let x_N_in_Y_1 = mp_N_2.mul_add(sin_psi, mp_N_1 * cos_psi);
    let x_N_in_Y_2 = (-mp_N_2).mul_add(cos_psi, mp_N_1 * sin_psi);
    let x_Y_in_L_2_2 = x_N_in_Y_2 * cos_phi;
    let x_Y_in_L_3_2 = x_N_in_Y_2 * sin_phi;
    let x_F_3 = mp_L_3 - x_Y_in_L_3_2;
    let x_L_in_B_1_2 = x_F_3.mul_add(sin_theta, x_N_in_Y_1 * cos_theta);
    let x_L_in_B_3_2 = (-x_N_in_Y_1).mul_add(sin_theta, x_F_3 * cos_theta);
    let x_F_1 = mp_B_1 + x_L_in_B_1_2;
    let x_F_3_2 = mp_B_3 - x_L_in_B_3_2;
    let x_B_in_S_1_2 = (-x_F_1).mul_add(cos_lam, x_F_3_2 * sin_lam);
    let x_B_in_S_3_2 = x_F_3_2.mul_add(cos_lam, x_F_1 * sin_lam);
    let x_F_1_2 = mp_S_1 - x_B_in_S_1_2;
    let x_S_in_F_1_2 = (-x_Y_in_L_2_2).mul_add(sin_delta, x_F_1_2 * cos_delta);
    let x_S_in_F_2_2 = x_F_1_2.mul_add(sin_delta, x_Y_in_L_2_2 * cos_delta);
    let x_F_1_3 = mp_F_1 - x_S_in_F_1_2;
    let x_F_3_3 = mp_F_3 + x_B_in_S_3_2;
    // Values.
    let energy = (-x_S_in_F_1).mul_add(x_F_1_3, x_S_in_F_2 * x_S_in_F_2_2) - x_B_in_S_3 * x_F_3_3;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 8],
    q_dot: &[S; 8],
) -> [S; 3] {
    let [_, _, _, phi_dot, _, delta_dot, thR_dot, _] = *q_dot;
    // Values.
    // u1 = phi'
    let u1_value = phi_dot;
    // u2 = delta'
    let u2_value = delta_dot;
    // u3 = thR'
    let u3_value = thR_dot;
    [u1_value, u2_value, u3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 8],
    _q_dot: &[S; 8],
    v_dot: &[S; 8],
) -> [S; 3] {
    let [_, _, _, phi_ddot, _, delta_ddot, thR_ddot, _] = *v_dot;
    // Values.
    // u1' = phi''
    let u1_dot_value = phi_ddot;
    // u2' = delta''
    let u2_dot_value = delta_ddot;
    // u3' = thR''
    let u3_dot_value = thR_ddot;
    [u1_dot_value, u2_dot_value, u3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 253 operations, 5 sines and cosines, 2 other functions.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> [S; 8] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // c*cos(lam) - rF*sin(lam)
    let ratio_theta_u1_of_c_lam_rf = (-rF).mul_add(sin_lam, c * cos_lam);
    // -ratio_theta_u1_of_c_lam_rf
    let ratio_psi_u1_of_c_lam_rf = -ratio_theta_u1_of_c_lam_rf;
    // lam + theta
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_theta_u1_of_place = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    // sin_delta_sin_phi - ratio_theta_u1_of_place*cos(delta)
    let ratio_theta_u1_of_place_2 = (-ratio_theta_u1_of_place)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let ratio_theta_u1_of_place_3 = ratio_theta_u1_of_place * sin_delta;
    // sin_phi_cos_delta + ratio_theta_u1_of_place_3
    let ratio_theta_u1_of_place_4 = sin_phi_cos_delta + ratio_theta_u1_of_place_3;
    // 1/(ratio_theta_u1_of_place_4^2 - 1)
    let ratio_theta_u1_of_place_5 = S::int(1)
        / ratio_theta_u1_of_place_4.mul_add(ratio_theta_u1_of_place_4, -S::int(1));
    let ratio_theta_u1_of_place_6 = cos_phi * sin_lam_plus_theta * sin_delta;
    // rF*ratio_theta_u1_of_place_5*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)
    let ratio_theta_u1_of_place_7 = rF * ratio_theta_u1_of_place_5
        * (S::int(1) - (ratio_theta_u1_of_place_6 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_theta_u1_of_place_8 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_7;
    // ratio_theta_u1_of_place_8 - ratio_psi_u1_of_c_lam_rf
    let ratio_psi_u1_of_place = ratio_theta_u1_of_place_8 - ratio_psi_u1_of_c_lam_rf;
    let ratio_psi_u1_of_place_2 = cos_lam_plus_theta * sin_delta;
    // -ratio_psi_u1_of_place*ratio_psi_u1_of_place_2
    let ratio_psi_u1_of_place_3 = -ratio_psi_u1_of_place * ratio_psi_u1_of_place_2;
    let ratio_theta_u1_of_place_9 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_10 = ratio_theta_u1_of_place_7 * ratio_theta_u1_of_place_9;
    // rR - rF
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    // rr_minus_rf*cos(lam) + w_sin_lam
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    // ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_10
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_10;
    // -ratio_theta_u1_of_place_11
    let ratio_psi_u1_of_place_4 = -ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_5 = cos_lam_plus_theta * cos_delta;
    // ratio_psi_u1_of_place_4*ratio_psi_u1_of_place_5 - ratio_psi_u1_of_place*sin(lam + theta)
    let ratio_psi_u1_of_place_6 = (-ratio_psi_u1_of_place)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5);
    // -ratio_psi_u1_of_place_2*ratio_psi_u1_of_place_4
    let ratio_psi_u1_of_place_7 = -ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_4;
    // -ratio_psi_u1_of_place_4*sin(delta)
    let ratio_psi_u1_of_place_8 = -ratio_psi_u1_of_place_4 * sin_delta;
    let ratio_psi_u1_of_place_9 = ratio_psi_u1_of_place_4 * cos_delta;
    // w + c
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    // w_plus_c*cos(lam) - rr_sin_lam
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    // -ratio_psi_u1_of_place*cos(delta)
    let ratio_psi_u1_of_place_10 = -ratio_psi_u1_of_place * cos_delta;
    // ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_10
    let ratio_psi_u1_of_place_11 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_10;
    // ratio_psi_u1_of_place_5*ratio_psi_u1_of_place_9 - ratio_psi_u1_of_place_2*ratio_psi_u1_of_place_8 +
    //   ratio_psi_u1_of_place_11*sin(lam + theta)
    let ratio_psi_u1_of_place_12 = (-ratio_psi_u1_of_place_2)
        .mul_add(
            ratio_psi_u1_of_place_8,
            ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_9,
        ) + ratio_psi_u1_of_place_11 * sin_lam_plus_theta;
    // -ratio_theta_u1_of_c_lam_rf - ratio_theta_u1_of_place_8
    let ratio_theta_u1_of_place_12 = -ratio_theta_u1_of_c_lam_rf - ratio_theta_u1_of_place_8;
    // cos(phi)*sin(delta) + sin_phi_cos_delta*sin(lam + theta)
    let ratio_theta_u1_of_place_13 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    // sin_delta_sin_phi*sin(lam + theta) - cos(phi)*cos(delta)
    let ratio_theta_u1_of_place_14 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let ratio_theta_u1_of_place_15 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_7;
    let ratio_theta_u1_of_place_16 = ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_15;
    let ratio_theta_u1_of_place_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_16;
    let ratio_theta_u1_of_place_18 = sin_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_19 = ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_16;
    // rR + ratio_theta_u1_of_w_c_lam_rr*sin(lam + theta)
    let ratio_theta_u1_of_place_20 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(sin_lam_plus_theta, rR);
    let ratio_theta_u1_of_place_21 = ratio_theta_u1_of_place_20 * sin_phi;
    let ratio_theta_u1_of_place_22 = ratio_theta_u1_of_place_9 * sin_delta;
    // ratio_theta_u1_of_place*ratio_theta_u1_of_place_7 +
    //   ratio_theta_u1_of_place_19*ratio_theta_u1_of_place_22
    let ratio_theta_u1_of_place_23 = ratio_theta_u1_of_place_19
        .mul_add(
            ratio_theta_u1_of_place_22,
            ratio_theta_u1_of_place * ratio_theta_u1_of_place_7,
        );
    // ratio_theta_u1_of_w_c_lam_rr + ratio_theta_u1_of_place_12*cos(delta)
    let ratio_theta_u1_of_place_24 = ratio_theta_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    // 1/(ratio_theta_u1_of_place*ratio_theta_u1_of_place_11 -
    //   ratio_theta_u1_of_place_2*(ratio_theta_u1_of_place_10*cos(delta) +
    //   ratio_theta_u1_of_place_17*ratio_theta_u1_of_place_22) -
    //   ratio_theta_u1_of_place_9*(ratio_theta_u1_of_place_23 - ratio_theta_u1_of_place_24))
    let ratio_theta_u1_of_place_25 = S::int(1)
        / (-ratio_theta_u1_of_place_2
            * ratio_theta_u1_of_place_17
                .mul_add(
                    ratio_theta_u1_of_place_22,
                    ratio_theta_u1_of_place_10 * cos_delta,
                ) + ratio_theta_u1_of_place * ratio_theta_u1_of_place_11
            - ratio_theta_u1_of_place_9
                * (ratio_theta_u1_of_place_23 - ratio_theta_u1_of_place_24));
    // ratio_theta_u1 = (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
    //   (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) - sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam +
    //   theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) -
    //   rR*sin(lam)) + cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam +
    //   theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))
    let ratio_theta_u1 = ratio_theta_u1_of_place_25
        * (-ratio_theta_u1_of_place_2
            * ratio_theta_u1_of_place_14
                .mul_add(
                    ratio_theta_u1_of_place_17,
                    ratio_theta_u1_of_place_7 * ratio_theta_u1_of_place_13,
                ) + ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_13
            - ratio_theta_u1_of_place_11 * ratio_theta_u1_of_place_18
            + ratio_theta_u1_of_place_9
                * (-ratio_theta_u1_of_place_14)
                    .mul_add(
                        ratio_theta_u1_of_place_19,
                        ratio_theta_u1_of_place_7 * ratio_theta_u1_of_place_18,
                    ) + ratio_theta_u1_of_place_21);
    // ratio_psi_u1_of_place_2*ratio_psi_u1_of_place_6 - ratio_psi_u1_of_place_3*sin(lam + theta) +
    //   ratio_psi_u1_of_place_5*ratio_psi_u1_of_place_7 + ratio_theta_u1*ratio_psi_u1_of_place_12
    let ratio_psi_u1_of_place_13 = (-ratio_psi_u1_of_place_3)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_6)
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_7
        + ratio_theta_u1 * ratio_psi_u1_of_place_12;
    // 1/(sin_delta_sin_phi*(rF*cos(lam) + rR*(cos(lam + theta) - cos(lam)) - w_sin_lam) +
    //   cos(phi)*(ratio_psi_u1_of_c_lam_rf*cos(lam + theta) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(rr_minus_rf*sin(lam + theta) + w_plus_c*cos(lam + theta)))))
    let ratio_psi_u1_of_place_14 = S::int(1)
        / (sin_delta_sin_phi * (rR * (cos_lam_plus_theta - cos_lam) + rF * cos_lam - w_sin_lam)
            + cos_phi
                * (cos_delta
                    * (sin_lam * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
                        + cos_lam
                            * w_plus_c
                                .mul_add(
                                    cos_lam_plus_theta,
                                    rr_minus_rf * sin_lam_plus_theta,
                                )) + ratio_psi_u1_of_c_lam_rf * cos_lam_plus_theta));
    let ratio_psi_u1_of_place_15 = ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_14;
    // ratio_psi_u1_of_place_8*ratio_theta_u1_of_place_14 -
    //   ratio_psi_u1_of_place_9*ratio_theta_u1_of_place_13 +
    //   ratio_psi_u1_of_place_11*ratio_theta_u1_of_place_18
    let ratio_psi_u1_of_place_16 = (-ratio_psi_u1_of_place_9)
        .mul_add(
            ratio_theta_u1_of_place_13,
            ratio_psi_u1_of_place_8 * ratio_theta_u1_of_place_14,
        ) + ratio_psi_u1_of_place_11 * ratio_theta_u1_of_place_18;
    // ratio_theta_u1_of_place_20*cos(phi) - ratio_psi_u1_of_place_7*ratio_theta_u1_of_place_13 -
    //   ratio_psi_u1_of_place_6*ratio_theta_u1_of_place_14 -
    //   ratio_psi_u1_of_place_3*ratio_theta_u1_of_place_18 + ratio_theta_u1*ratio_psi_u1_of_place_16
    let ratio_psi_u1_of_place_17 = (-ratio_psi_u1_of_place_7)
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u1_of_place_20 * cos_phi)
        - ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_14
        - ratio_psi_u1_of_place_3 * ratio_theta_u1_of_place_18
        + ratio_theta_u1 * ratio_psi_u1_of_place_16;
    let ratio_psi_u1_of_place_18 = ratio_theta_u1_of_place_14 * ratio_psi_u1_of_place_14;
    // ratio_psi_u1 = cos(lam + theta)*sin(delta)*(cos(lam + theta)*sin(delta)*(sin(lam +
    //   theta)*(rF*sin(lam) - c*cos(lam)) - cos(lam + theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) +
    //   rF*cos(phi)*cos(lam + theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(lam
    //   + theta)*cos(delta)*(cos(lam + theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) +
    //   rF*cos(phi)*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) -
    //   sin(lam + theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam +
    //   theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) -
    //   rR*sin(lam)) + cos(lam + theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) -
    //   cos(lam + theta)*sin(delta)*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam +
    //   theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))) +
    //   (cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))*(rR*cos(phi) + cos(phi)*sin(lam +
    //   theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta))*(sin(lam + theta)*(rF*sin(lam) - c*cos(lam)) - cos(lam +
    //   theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(lam +
    //   theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) - sin(phi)*cos(lam +
    //   theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam +
    //   theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) -
    //   rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam)
    //   + cos(lam)*(rR - rF)) - rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + (sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam +
    //   theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_17)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_psi_u1_of_place_13 * ratio_psi_u1_of_place_15,
        );
    // ratio_theta_u2 = (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))
    let ratio_theta_u2 = ratio_theta_u1_of_place_25
        * (-ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_17
            + ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12
            - ratio_theta_u1_of_place_2
                * ratio_theta_u1_of_place_2
                    .mul_add(ratio_theta_u1_of_place_17, ratio_theta_u1_of_place_15));
    // ratio_theta_u2*ratio_psi_u1_of_place_12 + ratio_psi_u1_of_place_2*ratio_theta_u1_of_place_12
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_12, ratio_theta_u2 * ratio_psi_u1_of_place_12);
    // ratio_theta_u1_of_place_12*ratio_theta_u1_of_place_14 - ratio_theta_u2*ratio_psi_u1_of_place_16
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_16,
            ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_14,
        );
    // ratio_psi_u2 = cos(lam + theta)*sin(delta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam +
    //   theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - cos(lam +
    //   theta)*sin(delta)*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam +
    //   theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))) +
    //   (sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))*((rF*sin(lam) - c*cos(lam) + rF*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta)) +
    //   (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) -
    //   rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR
    //   - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) +
    //   sin(phi)*cos(lam + theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) -
    //   cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) - (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam)
    //   - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))
    let ratio_psi_u2 = ratio_psi_u1_of_place_18
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_15 * ratio_psi_u2_of_place,
        );
    // ratio_psi_u3 = rR*cos(lam + theta)*sin(delta)/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) -
    //   rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_15;
    let rf_inv = S::int(1) / rF;
    // sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))
    let ratio_thF_u1_of_place = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_6))
        .sqrt();
    let ratio_thF_u1_of_place_2 = ratio_psi_u1_of_place_14 * ratio_thF_u1_of_place;
    let ratio_thF_u1_of_place_3 = rf_inv * ratio_thF_u1_of_place_2;
    // ratio_theta_u1_of_place_4*sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))/(sin_phi_cos_delta^2 - 1 + ratio_theta_u1_of_place_3*(2*sin_phi_cos_delta +
    //   ratio_theta_u1_of_place_3)) - sin(lam)*cos(delta)
    let ratio_thF_u1_of_place_4 = ratio_theta_u1_of_place_4 * sin_delta * ratio_thF_u1_of_place
        / (-S::int(1) + sin_phi_cos_delta * sin_phi_cos_delta
            + ratio_theta_u1_of_place_3
                * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_3))
        - sin_lam * cos_delta;
    // rr_sin_lam - cos(lam)*(w + c*(1 - cos(delta)))
    let ratio_thF_u1_of_place_5 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    // ratio_theta_u1_of_w_lam_rr_rf*sin(lam + theta) - cos(lam + theta)*(rF*ratio_thF_u1_of_place_4 +
    //   ratio_thF_u1_of_place_5)
    let ratio_thF_u1_of_place_6 = -cos_lam_plus_theta
        * rF.mul_add(ratio_thF_u1_of_place_4, ratio_thF_u1_of_place_5)
        + ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta;
    // ratio_psi_u1_of_place_2*(ratio_psi_u1_of_c_lam_rf*ratio_theta_u1_of_place_9 -
    //   ratio_theta_u1_of_place_2*ratio_theta_u1_of_w_lam_rr_rf) -
    //   ratio_theta_u1_of_place_4*ratio_psi_u1_of_place*sin(lam + theta) +
    //   ratio_theta_u1_of_place_4*ratio_psi_u1_of_place_4*ratio_psi_u1_of_place_5 +
    //   ratio_theta_u1_of_place_21
    let ratio_thF_u1_of_place_7 = ratio_psi_u1_of_place_2
        * (-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_w_lam_rr_rf,
                ratio_psi_u1_of_c_lam_rf * ratio_theta_u1_of_place_9,
            ) - ratio_theta_u1_of_place_4 * ratio_psi_u1_of_place * sin_lam_plus_theta
        + ratio_theta_u1_of_place_4 * ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5
        + ratio_theta_u1_of_place_21;
    // ratio_thF_u1 = sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(lam +
    //   theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) -
    //   rR*sin(lam) + rF*(sin(lam)*cos(delta) + sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta)
    //   + 2*sin(phi)*cos(delta))))))*(cos(lam + theta)*sin(delta)*(sin(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) - cos(lam + theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(lam
    //   + theta)*cos(delta)*(cos(lam + theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) +
    //   rF*cos(phi)*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) -
    //   sin(lam + theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam +
    //   theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) -
    //   rR*sin(lam)) + cos(lam + theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) -
    //   cos(lam + theta)*sin(delta)*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam +
    //   theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1
    //   - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(lam + theta)*cos(delta)*((w*sin(lam) + cos(lam)*(rR
    //   - rF))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)) - rR*sin(phi) - sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam))
    //   - cos(lam + theta)*sin(delta)*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) - sin(lam +
    //   theta)*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))*(rR*cos(phi) + cos(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
    //   (cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))*(sin(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) - cos(lam + theta)*cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)^2*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(lam +
    //   theta)*sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) - sin(phi)*cos(lam +
    //   theta)*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam +
    //   theta)*(rF*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) -
    //   rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam)
    //   + cos(lam)*(rR - rF)) - rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + (sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam +
    //   theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))))
    let ratio_thF_u1 = ratio_thF_u1_of_place_3
        * (-ratio_psi_u1_of_place_17)
            .mul_add(
                ratio_thF_u1_of_place_7,
                ratio_psi_u1_of_place_13 * ratio_thF_u1_of_place_6,
            );
    // ratio_thF_u2 = sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(lam +
    //   theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) -
    //   rR*sin(lam) + rF*(sin(lam)*cos(delta) + sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta)
    //   + 2*sin(phi)*cos(delta))))))*(cos(lam + theta)*sin(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2))*(sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(lam +
    //   theta)*cos(delta)*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - cos(lam +
    //   theta)*sin(delta)*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(lam +
    //   theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1
    //   - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w +
    //   c) - rR*sin(lam)) + cos(lam + theta)*sin(delta)*(cos(phi)*cos(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) + (w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))) - cos(lam + theta)*cos(delta)*((w*sin(lam) + cos(lam)*(rR -
    //   rF))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)) + sin(lam + theta)*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))*((rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta)) +
    //   (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2 + (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) -
    //   cos(phi)*sin(lam + theta)*cos(delta))^2*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)^2))*(sin(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + (cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta))*(cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) -
    //   rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   (sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR
    //   - rF)) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) +
    //   sin(phi)*cos(lam + theta)*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)))/(cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1
    //   - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) -
    //   cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) - (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) -
    //   w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam +
    //   theta)*(rR - rF) + cos(lam + theta)*(w + c))))))
    let ratio_thF_u2 = ratio_thF_u1_of_place_3
        * ratio_psi_u2_of_place_2
            .mul_add(
                ratio_thF_u1_of_place_7,
                ratio_psi_u2_of_place * ratio_thF_u1_of_place_6,
            );
    // ratio_thF_u3 = rR*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(lam +
    //   theta)*((w*sin(lam) + rR*cos(lam))/rF - cos(lam)) + cos(lam + theta)*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) + (cos(lam)*(w +
    //   c*(1 - cos(delta))) - rR*sin(lam))/rF))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) -
    //   rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))
    let ratio_thF_u3 = -rR * ratio_thF_u1_of_place_2
        * (sin_lam_plus_theta * (cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam))
            + cos_lam_plus_theta
                * rf_inv.mul_add(ratio_thF_u1_of_place_5, ratio_thF_u1_of_place_4));
    let rr_u3 = rR * u3;
    // Values.
    // x' = -rR*u3*cos(psi)
    let x_dot_value = -rr_u3 * cos_psi;
    // y' = -rR*u3*sin(psi)
    let y_dot_value = -rr_u3 * sin_psi;
    // psi' = -u1*ratio_psi_u1 - u2*ratio_psi_u2 - u3*ratio_psi_u3
    let psi_dot_value = (-u2).mul_add(ratio_psi_u2, -u1 * ratio_psi_u1) - u3 * ratio_psi_u3;
    // phi' = u1
    let phi_dot_value = u1;
    // theta' = u1*ratio_theta_u1 + u2*ratio_theta_u2
    let theta_dot_value = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    // delta' = u2
    let delta_dot_value = u2;
    // thR' = u3
    let thR_dot_value = u3;
    // thF' = u1*ratio_thF_u1 + u2*ratio_thF_u2 + u3*ratio_thF_u3
    let thF_dot_value = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1) + u3 * ratio_thF_u3;
    [
        x_dot_value, y_dot_value, psi_dot_value, phi_dot_value, theta_dot_value, delta_dot_value,
        thR_dot_value, thF_dot_value,
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 79 operations, 4 sines and cosines, 1 other function.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 8], _q_dot: &[S; 8]) -> [S; 4] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, _, phi, theta, delta, _, _] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    // Shared terms.
    let sin_phi_cos_delta = sin_phi * cos_delta;
    // lam + theta
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let divisor1_of_place = cos_phi * sin_lam_plus_theta;
    let divisor1_of_place_2 = divisor1_of_place * sin_delta;
    // sin_phi_cos_delta + divisor1_of_place_2
    let divisor1_of_place_3 = sin_phi_cos_delta + divisor1_of_place_2;
    // 1 - divisor1_of_place_3^2
    let divisor1_of_place_4 = (-divisor1_of_place_3)
        .mul_add(divisor1_of_place_3, S::int(1));
    let sin_delta_sin_phi = sin_phi * sin_delta;
    // sin_delta_sin_phi - divisor1_of_place*cos(delta)
    let divisor3_of_place = (-divisor1_of_place).mul_add(cos_delta, sin_delta_sin_phi);
    let divisor3_of_place_2 = cos_phi * cos_lam_plus_theta;
    // -1/divisor1_of_place_4
    let divisor3_of_place_3 = -S::int(1) / divisor1_of_place_4;
    // rF*divisor3_of_place_3*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)
    let divisor3_of_place_4 = rF * divisor3_of_place_3
        * (S::int(1)
            - (cos_phi * sin_lam_plus_theta)
                .mul_add(sin_delta, sin_phi_cos_delta)
                .powi(2))
            .sqrt();
    let divisor3_of_place_5 = divisor3_of_place_2 * divisor3_of_place_4;
    let divisor3_of_place_6 = divisor1_of_place_3 * divisor3_of_place_3
        * divisor3_of_place_5 * sin_delta;
    // rR - rF
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    // c*cos(lam) - rF*sin(lam)
    let divisor3_of_c_lam_rf = (-rF).mul_add(sin_lam, c * cos_lam);
    // w + c
    let w_plus_c = w + c;
    // w_plus_c*cos(lam) - rR*sin(lam)
    let divisor3_of_w_c_lam_rr = (-rR).mul_add(sin_lam, w_plus_c * cos_lam);
    // divisor1_of_place*divisor3_of_place_4 + divisor3_of_place_2*divisor3_of_place_6
    let divisor3_of_place_7 = divisor3_of_place_2
        .mul_add(divisor3_of_place_6, divisor1_of_place * divisor3_of_place_4);
    // divisor3_of_w_c_lam_rr - cos(delta)*(divisor3_of_place*divisor3_of_place_4 + divisor3_of_c_lam_rf)
    let divisor3_of_place_8 = divisor3_of_w_c_lam_rr
        - cos_delta * divisor3_of_place.mul_add(divisor3_of_place_4, divisor3_of_c_lam_rf);
    // Values.
    // divisor1 = (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1
    let divisor1 = -divisor1_of_place_4;
    // divisor2 = sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta))
    let divisor2 = -S::int(1) + sin_phi_cos_delta * sin_phi_cos_delta
        + divisor1_of_place_2 * sin_phi_cos_delta.mul_add(S::int(2), divisor1_of_place_2);
    // divisor3 = cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
    //   theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) +
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) - cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)
    let divisor3 = divisor1_of_place
        * (rr_minus_rf.mul_add(cos_lam, -divisor3_of_place_5) + w_sin_lam)
        - divisor3_of_place
            * divisor3_of_place
                .mul_add(divisor3_of_place_6, divisor3_of_place_5 * cos_delta)
        + divisor3_of_place_2 * (divisor3_of_place_8 - divisor3_of_place_7);
    // divisor4 = sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))
    let divisor4 = sin_delta_sin_phi
        * (rR * (cos_lam_plus_theta - cos_lam) + rF * cos_lam - w_sin_lam)
        + cos_phi
            * (cos_delta
                * (sin_lam * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
                    + cos_lam
                        * w_plus_c
                            .mul_add(
                                cos_lam_plus_theta,
                                rr_minus_rf * sin_lam_plus_theta,
                            )) - divisor3_of_c_lam_rf * cos_lam_plus_theta);
    [divisor1, divisor2, divisor3, divisor4]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 146 operations, 5 sines and cosines, 1 other function.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 8], q_dot: &[S; 8]) -> [S; 6] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [x_dot, y_dot, psi_dot, phi_dot, theta_dot, delta_dot, thR_dot, thF_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Shared terms.
    // lam + theta
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let residual1_of_place = cos_phi * sin_lam_plus_theta;
    // sin(phi)*sin(delta) - residual1_of_place*cos(delta)
    let residual1_of_place_2 = (-residual1_of_place)
        .mul_add(cos_delta, sin_phi * sin_delta);
    // c*cos(lam) - rF*sin(lam)
    let residual1_of_c_lam_rf = (-rF).mul_add(sin_lam, c * cos_lam);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    // sin(phi)*cos(delta) + residual1_of_place*sin(delta)
    let residual1_of_place_3 = residual1_of_place.mul_add(sin_delta, sin_phi_cos_delta);
    // 1/(residual1_of_place_3^2 - 1)
    let residual1_of_place_4 = S::int(1)
        / residual1_of_place_3.mul_add(residual1_of_place_3, -S::int(1));
    // rF*residual1_of_place_4*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)
    let residual1_of_place_5 = rF * residual1_of_place_4
        * (S::int(1)
            - (cos_phi * sin_lam_plus_theta)
                .mul_add(sin_delta, sin_phi_cos_delta)
                .powi(2))
            .sqrt();
    let residual1_of_place_6 = residual1_of_place_2 * residual1_of_place_5;
    // -residual1_of_c_lam_rf - residual1_of_place_6
    let residual1_of_place_7 = -residual1_of_c_lam_rf - residual1_of_place_6;
    // w*sin(lam) + cos(lam)*(rR - rF)
    let residual1_of_w_lam_rr_rf = cos_lam * (rR - rF) + w * sin_lam;
    let residual1_of_place_8 = cos_phi * cos_lam_plus_theta;
    let residual1_of_place_9 = residual1_of_place_5 * residual1_of_place_8;
    // residual1_of_w_lam_rr_rf - residual1_of_place_9
    let residual1_of_place_10 = residual1_of_w_lam_rr_rf - residual1_of_place_9;
    // cos(lam)*(w + c) - rR*sin(lam)
    let residual1_of_w_c_lam_rr = cos_lam * (w + c) - rR * sin_lam;
    let rr_cos_phi = rR * cos_phi;
    let residual2_of_place = sin_phi * sin_lam_plus_theta;
    // phi'*residual2_of_place - theta'*residual1_of_place_8
    let residual2_of_motion = (-theta_dot)
        .mul_add(residual1_of_place_8, phi_dot * residual2_of_place);
    // delta'*sin(phi) + residual2_of_motion
    let residual2_of_motion_2 = delta_dot.mul_add(sin_phi, residual2_of_motion);
    // phi' + delta'*sin(lam + theta)
    let residual2_of_motion_3 = delta_dot.mul_add(sin_lam_plus_theta, phi_dot);
    let sin_delta_cos_phi = cos_phi * sin_delta;
    // residual2_of_motion_2*cos(delta) + residual2_of_motion_3*sin_delta_cos_phi
    let residual2_of_motion_4 = residual2_of_motion_3
        .mul_add(sin_delta_cos_phi, residual2_of_motion_2 * cos_delta);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    // residual1_of_place_3*residual1_of_place_4*(residual2_of_motion_3*cos_delta_cos_phi -
    //   residual2_of_motion_2*sin(delta))
    let residual2_of_motion_5 = residual1_of_place_3 * residual1_of_place_4
        * (-residual2_of_motion_2)
            .mul_add(sin_delta, residual2_of_motion_3 * cos_delta_cos_phi);
    let residual2_of_phi_dot = phi_dot * cos_lam_plus_theta;
    // theta'*residual1_of_place + residual2_of_phi_dot*sin(phi)
    let residual2_of_motion_6 = residual2_of_phi_dot
        .mul_add(sin_phi, theta_dot * residual1_of_place);
    let rr_sin_phi = rR * sin_phi;
    // x'*cos(psi) + y'*sin(psi)
    let residual3_of_x_dot_y_dot = y_dot.mul_add(sin_psi, x_dot * cos_psi);
    // x'*sin(psi) - y'*cos(psi)
    let residual4_of_x_dot_y_dot = (-y_dot).mul_add(cos_psi, x_dot * sin_psi);
    // residual2_of_phi_dot*sin(delta) - psi'*residual1_of_place_3
    let residual5_of_motion = (-psi_dot)
        .mul_add(residual1_of_place_3, residual2_of_phi_dot * sin_delta);
    // theta'*cos(delta) - residual5_of_motion
    let residual5_of_motion_2 = theta_dot.mul_add(cos_delta, -residual5_of_motion);
    // -residual1_of_c_lam_rf
    let residual5_of_c_lam_rf = -residual1_of_c_lam_rf;
    // thF' + residual5_of_motion_2
    let residual5_of_motion_3 = thF_dot + residual5_of_motion_2;
    // residual5_of_motion_2*residual5_of_c_lam_rf - residual1_of_place_6*residual5_of_motion_3
    let residual5_of_motion_4 = (-residual1_of_place_6)
        .mul_add(residual5_of_motion_3, residual5_of_motion_2 * residual5_of_c_lam_rf);
    // residual1_of_w_c_lam_rr*(psi'*sin(phi) + theta') + residual5_of_motion_4
    let residual5_of_motion_5 = residual1_of_w_c_lam_rr
        * psi_dot.mul_add(sin_phi, theta_dot) + residual5_of_motion_4;
    // phi'*sin(lam + theta) + psi'*residual1_of_place_8
    let residual5_of_motion_6 = psi_dot
        .mul_add(residual1_of_place_8, phi_dot * sin_lam_plus_theta);
    // (residual5_of_c_lam_rf - residual1_of_place_6)*(delta' + residual5_of_motion_6) -
    //   residual1_of_place_10*(theta'*sin(delta) + psi'*residual1_of_place_2 +
    //   residual2_of_phi_dot*cos(delta))
    let residual5_of_motion_7 = (residual5_of_c_lam_rf - residual1_of_place_6)
        * (delta_dot + residual5_of_motion_6)
        - residual1_of_place_10
            * (psi_dot.mul_add(residual1_of_place_2, theta_dot * sin_delta)
                + residual2_of_phi_dot * cos_delta);
    // residual1_of_w_lam_rr_rf*residual5_of_motion_2 - residual1_of_place_9*residual5_of_motion_3
    let residual5_of_motion_8 = (-residual1_of_place_9)
        .mul_add(
            residual5_of_motion_3,
            residual1_of_w_lam_rr_rf * residual5_of_motion_2,
        );
    // Values.
    // contact = cos(phi)*sin(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) - rR*cos(phi) +
    //   (sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + cos(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2))
    let residual1 = residual1_of_place_8
        .mul_add(residual1_of_place_10, residual1_of_place_2 * residual1_of_place_7)
        - residual1_of_place * residual1_of_w_c_lam_rr - rr_cos_phi;
    // contact' = rR*phi'*sin(phi) + phi'*sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) -
    //   phi'*sin(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + theta'*cos(phi)*cos(lam +
    //   theta)*(rR*sin(lam) - cos(lam)*(w + c)) - theta'*cos(phi)*sin(lam + theta)*(w*sin(lam) +
    //   cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) +
    //   (rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1))*(phi'*cos(phi)*sin(delta) + phi'*sin(phi)*sin(lam + theta)*cos(delta) - theta'*cos(phi)*cos(lam
    //   + theta)*cos(delta) + delta'*cos(phi)*sin(lam + theta)*sin(delta) + delta'*sin(phi)*cos(delta)) +
    //   (cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))*(rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(phi'*cos(phi)*sin(delta) + phi'*sin(phi)*sin(lam +
    //   theta)*cos(delta) - theta'*cos(phi)*cos(lam + theta)*cos(delta) + delta'*cos(phi)*sin(lam +
    //   theta)*sin(delta) + delta'*sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(phi'*cos(phi)*cos(delta) - phi'*sin(phi)*sin(lam + theta)*sin(delta) +
    //   theta'*cos(phi)*cos(lam + theta)*sin(delta) - delta'*sin(phi)*sin(delta) + delta'*cos(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) +
    //   cos(phi)*cos(lam + theta)*(rF*phi'*sin(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*theta'*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))*(phi'*cos(phi)*cos(delta) - phi'*sin(phi)*sin(lam + theta)*sin(delta) +
    //   theta'*cos(phi)*cos(lam + theta)*sin(delta) - delta'*sin(phi)*sin(delta) + delta'*cos(phi)*sin(lam +
    //   theta)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)
    let residual2 = residual1_of_w_c_lam_rr * residual2_of_motion
        + residual1_of_place_7 * residual2_of_motion_4
        + residual1_of_place_2
            * (-residual1_of_place_5)
                .mul_add(
                    residual2_of_motion_4,
                    residual1_of_place_6 * residual2_of_motion_5,
                ) - residual1_of_place_10 * residual2_of_motion_6
        + residual1_of_place_8
            * residual1_of_place_5
                .mul_add(
                    residual2_of_motion_6,
                    residual1_of_place_9 * residual2_of_motion_5,
                ) + phi_dot * rr_sin_phi;
    // rear_1 = x'*cos(psi) + y'*sin(psi) + rR*thR'
    let residual3 = rR.mul_add(thR_dot, residual3_of_x_dot_y_dot);
    // rear_2 = y'*cos(psi) - x'*sin(psi)
    let residual4 = -residual4_of_x_dot_y_dot;
    // front_1 = x'*cos(psi) + y'*sin(psi) - rR*psi'*sin(phi) + sin(lam + theta)*(rR*sin(lam) - cos(lam)*(w
    //   + c))*(psi'*sin(phi) + theta') + cos(lam + theta)*sin(delta)*((w*sin(lam) + cos(lam)*(rR -
    //   rF))*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta)) + phi'*cos(lam +
    //   theta)*cos(delta) + theta'*sin(delta)) - rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta)) + phi'*cos(lam + theta)*cos(delta) + theta'*sin(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - (rF*sin(lam) - c*cos(lam))*(psi'*cos(phi)*cos(lam
    //   + theta) + phi'*sin(lam + theta) + delta') - rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam + theta) +
    //   delta')/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + cos(lam +
    //   theta)*cos(delta)*((w*sin(lam) + cos(lam)*(rR - rF))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) -
    //   phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) + thF')/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) - sin(lam + theta)*((rF*sin(lam) -
    //   c*cos(lam))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) - phi'*cos(lam +
    //   theta)*sin(delta) + theta'*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) -
    //   phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) + thF')/((cos(phi)*sin(lam + theta)*sin(delta)
    //   + sin(phi)*cos(delta))^2 - 1))
    let residual5 = residual3_of_x_dot_y_dot - psi_dot * rr_sin_phi
        - residual5_of_motion_5 * sin_lam_plus_theta
        + cos_lam_plus_theta
            * (-residual5_of_motion_7)
                .mul_add(sin_delta, residual5_of_motion_8 * cos_delta);
    // front_2 = y'*cos(psi) - x'*sin(psi) + rR*phi'*cos(phi) + cos(phi)*(cos(lam)*(w + c) -
    //   rR*sin(lam))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam + theta)) + sin(phi)*cos(lam +
    //   theta)*(cos(lam)*(w + c) - rR*sin(lam))*(psi'*sin(phi) + theta') + (cos(phi)*cos(delta) -
    //   sin(phi)*sin(lam + theta)*sin(delta))*(rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta)) + phi'*cos(lam + theta)*cos(delta) + theta'*sin(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - (w*sin(lam) + cos(lam)*(rR -
    //   rF))*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta)) + phi'*cos(lam +
    //   theta)*cos(delta) + theta'*sin(delta)) + (rF*sin(lam) - c*cos(lam))*(psi'*cos(phi)*cos(lam + theta)
    //   + phi'*sin(lam + theta) + delta') + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam + theta) +
    //   delta')/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (cos(phi)*sin(delta)
    //   + sin(phi)*sin(lam + theta)*cos(delta))*((w*sin(lam) + cos(lam)*(rR - rF))*(psi'*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta)) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) -
    //   phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) + thF')/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + sin(phi)*cos(lam + theta)*((rF*sin(lam) -
    //   c*cos(lam))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) - phi'*cos(lam +
    //   theta)*sin(delta) + theta'*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) -
    //   phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) + thF')/((cos(phi)*sin(lam + theta)*sin(delta)
    //   + sin(phi)*cos(delta))^2 - 1))
    let residual6 = -residual4_of_x_dot_y_dot + phi_dot * rr_cos_phi
        + residual5_of_motion_5 * sin_phi * cos_lam_plus_theta
        + residual1_of_w_c_lam_rr * residual5_of_motion_6 * cos_phi
        + residual5_of_motion_7 * (-residual2_of_place).mul_add(sin_delta, cos_delta_cos_phi)
        + residual5_of_motion_8 * residual2_of_place.mul_add(cos_delta, sin_delta_cos_phi);
    [residual1, residual2, residual3, residual4, residual5, residual6]
}

/// Slopes of the constraints, one after the other, along x, y, psi, phi, theta, delta, thR, thF, x', y', psi', phi', theta', delta', thR', thF'.
///
/// 651 operations, 5 sines and cosines, 2 other functions.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    q_dot: &[S; 8],
) -> [S; 96] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [x_dot, y_dot, psi_dot, phi_dot, theta_dot, delta_dot, _, thF_dot] = *q_dot;
    // Sines and cosines.
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let rr_sin_lam = rR * sin_lam;
    let residual1_by_phi_of_w_c_lam_rr = cos_lam * (w + c) - rr_sin_lam;
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let residual1_by_phi_of_place = residual1_by_phi_of_w_c_lam_rr
        .mul_add(sin_lam_plus_theta, rR);
    let residual1_by_phi_of_place_2 = residual1_by_phi_of_place * sin_phi;
    let residual1_by_phi_of_place_3 = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let residual1_by_phi_of_place_4 = (-residual1_by_phi_of_place_3)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let residual1_by_phi_of_place_5 = sin_phi_cos_delta * sin_lam_plus_theta;
    let residual1_by_phi_of_place_6 = sin_delta_cos_phi + residual1_by_phi_of_place_5;
    let residual1_by_phi_of_place_7 = residual1_by_phi_of_place_3 * sin_delta;
    let residual1_by_phi_of_place_8 = sin_phi_cos_delta + residual1_by_phi_of_place_7;
    let residual1_by_phi_of_place_9 = residual1_by_phi_of_place_8 * residual1_by_phi_of_place_8;
    let residual1_by_phi_of_place_10 = S::int(1) / (residual1_by_phi_of_place_9 - S::int(1));
    let residual1_by_phi_of_place_11 = cos_phi * sin_lam_plus_theta * sin_delta;
    let residual1_by_phi_of_place_12 = rF * residual1_by_phi_of_place_10
        * (S::int(1) - (residual1_by_phi_of_place_11 + sin_phi_cos_delta).powi(2))
            .sqrt();
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let residual1_by_phi_of_place_13 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
    let residual1_by_phi_of_place_14 = residual1_by_phi_of_place_10 * residual1_by_phi_of_place_12;
    let residual1_by_phi_of_place_15 = residual1_by_phi_of_place_8 * residual1_by_phi_of_place_14;
    let residual1_by_phi_of_place_16 = residual1_by_phi_of_place_4 * residual1_by_phi_of_place_15;
    let residual1_by_phi_of_place_17 = residual1_by_phi_of_place_13
        .mul_add(
            residual1_by_phi_of_place_16,
            residual1_by_phi_of_place_6 * residual1_by_phi_of_place_12,
        );
    let residual1_by_phi_of_place_18 = residual1_by_phi_of_place_4 * residual1_by_phi_of_place_12;
    let c_cos_lam = c * cos_lam;
    let residual1_by_phi_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let residual1_by_phi_of_place_19 = residual1_by_phi_of_c_lam_rf - residual1_by_phi_of_place_18;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let residual1_by_phi_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let residual1_by_phi_of_place_20 = cos_phi * cos_lam_plus_theta;
    let residual1_by_phi_of_place_21 = residual1_by_phi_of_place_12 * residual1_by_phi_of_place_20;
    let residual1_by_phi_of_place_22 = residual1_by_phi_of_w_lam_rr_rf
        - residual1_by_phi_of_place_21;
    let residual1_by_phi_of_place_23 = sin_phi * cos_lam_plus_theta;
    let residual1_by_phi_of_place_24 = residual1_by_phi_of_place_15 * residual1_by_phi_of_place_20;
    let residual1_by_phi_of_place_25 = (-residual1_by_phi_of_place_12)
        .mul_add(
            residual1_by_phi_of_place_23,
            residual1_by_phi_of_place_13 * residual1_by_phi_of_place_24,
        );
    let residual1_by_phi_of_place_26 = -residual1_by_phi_of_place_25;
    let residual1_by_phi_of_place_27 = (-residual1_by_phi_of_place_6)
        .mul_add(
            residual1_by_phi_of_place_19,
            residual1_by_phi_of_place_4 * residual1_by_phi_of_place_17,
        );
    let residual1_by_phi_of_place_28 = (-residual1_by_phi_of_place_20)
        .mul_add(
            residual1_by_phi_of_place_26,
            residual1_by_phi_of_place_22 * residual1_by_phi_of_place_23,
        );
    let residual1_by_phi_of_place_29 = residual1_by_phi_of_place_27 + residual1_by_phi_of_place_28;
    let residual1_by_phi_of_place_30 = residual1_by_phi_of_place_2 - residual1_by_phi_of_place_29;
    let residual1_by_theta_of_place = residual1_by_phi_of_place_20 * cos_delta;
    let residual1_by_theta_of_place_2 = residual1_by_phi_of_place_16 * residual1_by_phi_of_place_20;
    let residual1_by_theta_of_place_3 = residual1_by_theta_of_place_2
        .mul_add(sin_delta, residual1_by_phi_of_place_12 * residual1_by_theta_of_place);
    let residual1_by_theta_of_place_4 = residual1_by_phi_of_place_20 * sin_delta;
    let residual1_by_theta_of_place_5 = residual1_by_phi_of_place_24
        .mul_add(
            residual1_by_theta_of_place_4,
            residual1_by_phi_of_place_3 * residual1_by_phi_of_place_12,
        );
    let residual1_by_theta_of_place_6 = residual1_by_phi_of_w_c_lam_rr
        - residual1_by_theta_of_place_5;
    let residual1_by_theta_of_place_7 = (-residual1_by_phi_of_place_3)
        .mul_add(
            residual1_by_phi_of_place_22,
            residual1_by_phi_of_place_4 * residual1_by_theta_of_place_3,
        );
    let residual1_by_theta_of_place_8 = residual1_by_phi_of_place_20
        .mul_add(
            residual1_by_theta_of_place_6,
            residual1_by_phi_of_place_19 * residual1_by_theta_of_place,
        );
    let residual1_by_theta_of_place_9 = residual1_by_theta_of_place_7
        - residual1_by_theta_of_place_8;
    let residual1_by_delta_of_place = residual1_by_phi_of_place_4
        .mul_add(
            residual1_by_phi_of_place_16,
            residual1_by_phi_of_place_8 * residual1_by_phi_of_place_12,
        );
    let residual1_by_delta_of_place_2 = (-residual1_by_phi_of_place_4)
        .mul_add(
            residual1_by_delta_of_place,
            residual1_by_phi_of_place_8 * residual1_by_phi_of_place_19,
        );
    let residual1_by_delta_of_place_3 = residual1_by_phi_of_place_20
        .mul_add(residual1_by_theta_of_place_2, -residual1_by_delta_of_place_2);
    let residual2_by_phi_of_phi_dot = phi_dot * sin_lam_plus_theta;
    let residual2_by_phi_of_motion = delta_dot + residual2_by_phi_of_phi_dot;
    let theta_dot_cos_delta = theta_dot * cos_delta;
    let residual2_by_phi_of_delta_dot = delta_dot * sin_lam_plus_theta;
    let residual2_by_phi_of_motion_2 = phi_dot + residual2_by_phi_of_delta_dot;
    let residual2_by_phi_of_motion_3 = residual1_by_phi_of_place_23
        .mul_add(theta_dot_cos_delta, cos_delta_cos_phi * residual2_by_phi_of_motion)
        - sin_delta_sin_phi * residual2_by_phi_of_motion_2;
    let residual2_by_phi_of_motion_4 = (-residual1_by_phi_of_place_20)
        .mul_add(theta_dot_cos_delta, sin_phi_cos_delta * residual2_by_phi_of_motion)
        + sin_delta_cos_phi * residual2_by_phi_of_motion_2;
    let theta_dot_sin_delta = theta_dot * sin_delta;
    let residual2_by_phi_of_motion_5 = (-sin_delta_sin_phi)
        .mul_add(
            residual2_by_phi_of_motion,
            cos_delta_cos_phi * residual2_by_phi_of_motion_2,
        ) + residual1_by_phi_of_place_20 * theta_dot_sin_delta;
    let residual2_by_phi_of_motion_6 = (-residual1_by_phi_of_place_16)
        .mul_add(
            residual2_by_phi_of_motion_5,
            residual1_by_phi_of_place_12 * residual2_by_phi_of_motion_4,
        );
    let residual2_by_phi_of_motion_7 = sin_phi_cos_delta
        .mul_add(
            residual2_by_phi_of_motion_2,
            sin_delta_cos_phi * residual2_by_phi_of_motion,
        ) + residual1_by_phi_of_place_23 * theta_dot_sin_delta;
    let residual2_by_phi_of_motion_8 = residual1_by_phi_of_place_14 * residual2_by_phi_of_motion_5
        * (-(residual1_by_phi_of_place_9 * residual1_by_phi_of_place_10))
            .mul_add(S::int(3), S::int(1));
    let residual2_by_phi_of_motion_9 = residual1_by_phi_of_place_4 * residual2_by_phi_of_motion_8;
    let residual2_by_phi_of_motion_10 = residual1_by_phi_of_place_15
        .mul_add(residual2_by_phi_of_motion_4, residual2_by_phi_of_motion_9);
    let residual2_by_phi_of_motion_11 = residual1_by_phi_of_place_15 * residual2_by_phi_of_motion_5;
    let residual2_by_phi_of_theta_dot = theta_dot * residual1_by_phi_of_place_3;
    let residual2_by_phi_of_motion_12 = phi_dot
        .mul_add(residual1_by_phi_of_place_23, residual2_by_phi_of_theta_dot);
    let residual2_by_phi_of_motion_13 = (-residual1_by_phi_of_place_15)
        .mul_add(
            residual2_by_phi_of_motion_12,
            residual1_by_phi_of_place_20 * residual2_by_phi_of_motion_8,
        );
    let theta_dot_sin_phi = theta_dot * sin_phi;
    let residual2_by_phi_of_motion_14 = (-phi_dot)
        .mul_add(residual1_by_phi_of_place_20, theta_dot_sin_phi * sin_lam_plus_theta);
    let phi_dot_cos_phi = phi_dot * cos_phi;
    let residual2_by_phi_of_motion_15 = residual1_by_phi_of_place_12
        .mul_add(
            residual2_by_phi_of_motion_12,
            residual1_by_phi_of_place_20 * residual2_by_phi_of_motion_11,
        );
    let delta_dot_sin_delta = delta_dot * sin_delta;
    let residual2_by_theta_of_motion = residual1_by_phi_of_place_20
        .mul_add(delta_dot_sin_delta, residual2_by_phi_of_motion_12 * cos_delta);
    let residual2_by_theta_of_motion_2 = (-residual2_by_phi_of_motion_12)
        .mul_add(sin_delta, delta_dot * residual1_by_theta_of_place);
    let residual2_by_theta_of_motion_3 = (-theta_dot)
        .mul_add(residual1_by_phi_of_place_20, residual2_by_phi_of_phi_dot * sin_phi);
    let residual3_by_psi_of_x_dot_y_dot = (-y_dot).mul_add(cos_psi, x_dot * sin_psi);
    let residual4_by_psi_of_x_dot_y_dot = y_dot.mul_add(sin_psi, x_dot * cos_psi);
    let residual5_by_phi_of_place = cos_lam_plus_theta * sin_delta;
    let residual5_by_phi_of_psi_dot = psi_dot * residual1_by_phi_of_place_8;
    let residual5_by_phi_of_motion = (-phi_dot)
        .mul_add(residual5_by_phi_of_place, residual5_by_phi_of_psi_dot);
    let residual5_by_phi_of_motion_2 = thF_dot + theta_dot_cos_delta;
    let residual5_by_phi_of_motion_3 = residual5_by_phi_of_motion + residual5_by_phi_of_motion_2;
    let residual5_by_phi_of_place_2 = -residual1_by_phi_of_place_19;
    let residual5_by_phi_of_psi_dot_2 = psi_dot * residual1_by_phi_of_place_13;
    let residual5_by_phi_of_motion_4 = (-residual5_by_phi_of_place_2)
        .mul_add(
            residual5_by_phi_of_psi_dot_2,
            residual1_by_phi_of_place_17 * residual5_by_phi_of_motion_3,
        );
    let residual5_by_phi_of_motion_5 = residual1_by_phi_of_place_22
        .mul_add(
            residual5_by_phi_of_psi_dot_2,
            residual1_by_phi_of_place_25 * residual5_by_phi_of_motion_3,
        );
    let residual5_by_phi_of_place_3 = cos_lam_plus_theta * cos_delta;
    let residual5_by_phi_of_motion_6 = psi_dot
        .mul_add(residual1_by_phi_of_place_4, theta_dot_sin_delta)
        + phi_dot * residual5_by_phi_of_place_3;
    let residual5_by_phi_of_psi_dot_3 = psi_dot * residual1_by_phi_of_place_20;
    let residual5_by_phi_of_motion_7 = residual2_by_phi_of_motion + residual5_by_phi_of_psi_dot_3;
    let residual5_by_phi_of_motion_8 = psi_dot
        * (-residual1_by_phi_of_place_23)
            .mul_add(
                residual5_by_phi_of_place_2,
                residual1_by_phi_of_place_6 * residual1_by_phi_of_place_22,
            ) - residual1_by_phi_of_place_25 * residual5_by_phi_of_motion_6
        + residual1_by_phi_of_place_17 * residual5_by_phi_of_motion_7;
    let psi_dot_cos_phi = psi_dot * cos_phi;
    let residual5_by_theta_of_place = sin_phi_cos_delta
        .mul_add(S::int(2), residual1_by_phi_of_place_7);
    let residual5_by_theta_of_lam_theta = S::int(2) * sin_lam_plus_theta;
    let cos_lam_plus_theta_sq = cos_lam_plus_theta * cos_lam_plus_theta;
    let residual5_by_theta_of_lam_theta_2 = cos_lam_plus_theta_sq - S::int(1);
    let psi_dot_sin_phi = psi_dot * sin_phi;
    let thf_dot_cos_delta = thF_dot * cos_delta;
    let residual5_by_theta_of_motion = theta_dot + psi_dot_sin_phi;
    let sin_delta_sq = sin_delta * sin_delta;
    let residual5_by_theta_of_motion_2 = residual5_by_theta_of_motion * cos_delta;
    let residual5_by_theta_of_motion_3 = sin_phi * (thF_dot + residual5_by_theta_of_motion_2);
    let residual5_by_theta_of_place_2 = S::int(1)
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + residual1_by_phi_of_place_7 * residual5_by_theta_of_place);
    let residual5_by_theta_of_place_3 = residual5_by_theta_of_place_2
        * (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
            - cos_phi * sin_lam_plus_theta * sin_delta
                * sin_phi_cos_delta.mul_add(S::int(2), residual1_by_phi_of_place_11))
            .sqrt();
    let residual5_by_theta_of_place_4 = residual5_by_theta_of_place_3 * sin_delta;
    let residual5_by_theta_of_delta = cos_delta - S::int(1);
    let residual5_by_theta_of_motion_4 = w * residual5_by_theta_of_motion;
    let residual5_by_theta_of_place_5 = rF * residual5_by_theta_of_place_4;
    let residual5_by_delta_of_motion = (-residual5_by_phi_of_place_2)
        .mul_add(
            residual5_by_phi_of_motion_6,
            residual1_by_delta_of_place * residual5_by_phi_of_motion_3,
        );
    let residual5_by_delta_of_motion_2 = residual1_by_phi_of_place_22
        * residual5_by_phi_of_motion_6;
    let residual5_by_delta_of_motion_3 = (-residual5_by_phi_of_place_2)
        .mul_add(residual5_by_phi_of_motion_7, -residual5_by_delta_of_motion_2);
    let residual5_by_delta_of_motion_4 = residual1_by_theta_of_place_2
        .mul_add(residual5_by_phi_of_motion_3, residual5_by_delta_of_motion_2);
    let residual5_by_delta_of_motion_5 = residual5_by_delta_of_motion_3
        + residual5_by_delta_of_motion_4;
    let residual5_by_delta_of_motion_6 = theta_dot_cos_delta + residual5_by_phi_of_motion;
    let residual5_by_delta_of_motion_7 = (-residual1_by_phi_of_place_21)
        .mul_add(
            residual5_by_phi_of_motion_3,
            residual1_by_phi_of_w_lam_rr_rf * residual5_by_delta_of_motion_6,
        );
    let residual5_by_delta_of_motion_8 = (-residual1_by_theta_of_place_2)
        .mul_add(
            residual5_by_phi_of_motion_6,
            residual1_by_delta_of_place * residual5_by_phi_of_motion_7,
        ) + residual1_by_phi_of_place_22 * residual5_by_delta_of_motion_6;
    let residual5_by_delta_of_motion_9 = residual5_by_delta_of_motion_7
        - residual5_by_delta_of_motion_8;
    let residual5_by_theta_dot_of_w_lam_rr = rR.mul_add(cos_lam, w_sin_lam);
    let residual5_by_thF_dot_of_place = rF * residual5_by_theta_of_place_3;
    let residual6_by_phi_of_motion = (-residual1_by_phi_of_place_18)
        .mul_add(
            residual5_by_phi_of_motion_3,
            residual1_by_phi_of_c_lam_rf * residual5_by_delta_of_motion_6,
        );
    let residual6_by_theta_of_motion = psi_dot + theta_dot_sin_phi;
    let residual6_by_theta_of_motion_2 = residual6_by_theta_of_motion * cos_lam_plus_theta;
    let residual6_by_theta_of_phi_dot = S::int(2) * residual2_by_phi_of_phi_dot;
    let cos_delta_sq = cos_delta * cos_delta;
    let delta_dot_sin_phi = delta_dot * sin_phi;
    let cos_phi_sq = cos_phi * cos_phi;
    let residual6_by_theta_of_delta = sin_delta_sq + cos_delta_sq;
    let residual6_by_theta_of_place = (-residual5_by_theta_of_place_4)
        .mul_add(sin_phi, sin_lam);
    let sin_lam_cos_delta = sin_lam * cos_delta;
    let residual6_by_psi_dot_of_place = cos_lam
        * (-c).mul_add(residual5_by_theta_of_delta, w) - rr_sin_lam;
    let residual6_by_psi_dot_of_place_2 = cos_lam_plus_theta
        * (rF
            * (-residual1_by_phi_of_place_8)
                .mul_add(residual5_by_theta_of_place_4, sin_lam_cos_delta)
            + residual6_by_psi_dot_of_place) + residual1_by_phi_of_w_lam_rr_rf * sin_lam_plus_theta;
    let minus_sin_psi = -sin_psi;
    let residual1_by_delta_of_place_4 = -residual1_by_delta_of_place_3;
    let residual3_by_psi_of_x_dot_y_dot_2 = -residual3_by_psi_of_x_dot_y_dot;
    let residual4_by_psi_of_x_dot_y_dot_2 = -residual4_by_psi_of_x_dot_y_dot;
    // Values.
    let residual1_by_phi = residual1_by_phi_of_place_30;
    let residual1_by_theta = residual1_by_theta_of_place_9;
    let residual1_by_delta = residual1_by_delta_of_place_4;
    let residual2_by_phi = residual1_by_phi_of_place_19 * residual2_by_phi_of_motion_3
        - residual1_by_phi_of_place_17 * residual2_by_phi_of_motion_4
        - residual1_by_phi_of_place_6 * residual2_by_phi_of_motion_6
        + residual1_by_phi_of_place_4
            * ((-residual1_by_phi_of_place_12)
                .mul_add(
                    residual2_by_phi_of_motion_3,
                    residual1_by_phi_of_place_6 * residual2_by_phi_of_motion_11,
                ) - residual1_by_phi_of_place_16 * residual2_by_phi_of_motion_7
                - residual1_by_phi_of_place_13 * residual2_by_phi_of_motion_10)
        - residual1_by_phi_of_place_26 * residual2_by_phi_of_motion_12
        + residual1_by_phi_of_place_22 * residual2_by_phi_of_motion_14
        - residual1_by_phi_of_place_20
            * (residual1_by_phi_of_place_23
                .mul_add(
                    residual2_by_phi_of_motion_11,
                    residual1_by_phi_of_place_24 * residual2_by_phi_of_motion_7,
                ) + residual1_by_phi_of_place_13 * residual2_by_phi_of_motion_13
                + residual1_by_phi_of_place_12 * residual2_by_phi_of_motion_14)
        + residual1_by_phi_of_place * phi_dot_cos_phi
        + residual1_by_phi_of_place_23
            * theta_dot
                .mul_add(residual1_by_phi_of_w_c_lam_rr, -residual2_by_phi_of_motion_15);
    let residual2_by_theta = residual1_by_theta_of_place_3 * residual2_by_phi_of_motion_4
        + residual1_by_theta_of_place * residual2_by_phi_of_motion_6
        + residual1_by_theta_of_place_6 * residual2_by_phi_of_motion_12
        - residual1_by_phi_of_place_3 * residual2_by_phi_of_motion_15
        + residual1_by_phi_of_place_19 * residual2_by_theta_of_motion
        + residual1_by_phi_of_place_4
            * ((-residual1_by_theta_of_place)
                .mul_add(
                    residual2_by_phi_of_motion_11,
                    residual1_by_theta_of_place_4 * residual2_by_phi_of_motion_10,
                ) - residual1_by_phi_of_place_12 * residual2_by_theta_of_motion
                + residual1_by_phi_of_place_16 * residual2_by_theta_of_motion_2)
        + residual1_by_phi_of_place_22 * residual2_by_theta_of_motion_3
        + residual1_by_phi_of_place_20
            * ((-residual1_by_phi_of_place_3)
                .mul_add(
                    residual2_by_phi_of_motion_11,
                    residual1_by_theta_of_place_4 * residual2_by_phi_of_motion_13,
                ) + residual1_by_phi_of_place_24 * residual2_by_theta_of_motion_2
                - residual1_by_phi_of_place_12 * residual2_by_theta_of_motion_3);
    let residual2_by_delta = residual1_by_phi_of_place_19 * residual2_by_phi_of_motion_5
        - residual1_by_delta_of_place * residual2_by_phi_of_motion_4
        - residual1_by_phi_of_place_8 * residual2_by_phi_of_motion_6
        + residual1_by_phi_of_place_4
            * ((-(residual1_by_phi_of_place_16 * residual2_by_phi_of_motion_4))
                .mul_add(
                    S::int(2),
                    residual1_by_phi_of_place_8 * residual2_by_phi_of_motion_11,
                ) - residual1_by_phi_of_place_12 * residual2_by_phi_of_motion_5
                - residual1_by_phi_of_place_4 * residual2_by_phi_of_motion_9)
        + residual1_by_theta_of_place_2 * residual2_by_phi_of_motion_12
        + residual1_by_phi_of_place_20
            * (-residual1_by_phi_of_place_20)
                .mul_add(
                    residual2_by_phi_of_motion_10,
                    residual1_by_phi_of_place_16 * residual2_by_phi_of_motion_12,
                );
    let residual2_by_phi_dot = residual1_by_phi_of_place_30;
    let residual2_by_theta_dot = residual1_by_theta_of_place_9;
    let residual2_by_delta_dot = residual1_by_delta_of_place_4;
    let residual3_by_psi = residual3_by_psi_of_x_dot_y_dot_2;
    let residual3_by_x_dot = cos_psi;
    let residual3_by_y_dot = sin_psi;
    let residual3_by_thR_dot = rR;
    let residual4_by_psi = residual4_by_psi_of_x_dot_y_dot_2;
    let residual4_by_x_dot = minus_sin_psi;
    let residual4_by_y_dot = cos_psi;
    let residual5_by_psi = residual3_by_psi_of_x_dot_y_dot_2;
    let residual5_by_phi = (-residual5_by_phi_of_motion_5)
        .mul_add(
            residual5_by_phi_of_place_3,
            residual5_by_phi_of_motion_4 * sin_lam_plus_theta,
        ) + residual5_by_phi_of_place * residual5_by_phi_of_motion_8
        - residual1_by_phi_of_place * psi_dot_cos_phi;
    let residual5_by_theta = cos_lam_plus_theta
        * (rF
            * (residual5_by_theta_of_place_4
                * (residual5_by_theta_of_motion_3
                    + cos_phi
                        * (theta_dot_sin_delta * residual5_by_theta_of_lam_theta
                            - S::int(2) * delta_dot * residual5_by_phi_of_place_3
                            - psi_dot
                                * (-sin_delta_sin_phi)
                                    .mul_add(residual5_by_theta_of_lam_theta, cos_delta_cos_phi)
                            - residual5_by_theta_of_place_2
                                * (sin_delta
                                    * (cos_phi
                                        * (sin_delta
                                            * (sin_phi
                                                * (S::int(3) * residual5_by_phi_of_psi_dot
                                                    + S::int(2) * residual5_by_phi_of_motion_2
                                                    + cos_lam_plus_theta
                                                        * (-cos_lam_plus_theta
                                                            * (theta_dot_cos_delta.mul_add(S::int(2), thF_dot)
                                                                + psi_dot * residual5_by_theta_of_place)
                                                            + delta_dot_sin_delta * residual5_by_theta_of_lam_theta))
                                                - cos_phi
                                                    * (cos_delta
                                                        * (psi_dot_cos_phi
                                                            - cos_lam_plus_theta
                                                                * delta_dot
                                                                    .mul_add(
                                                                        residual5_by_theta_of_lam_theta_2,
                                                                        residual5_by_phi_of_psi_dot_3,
                                                                    ))
                                                        + theta_dot_sin_delta * residual5_by_theta_of_lam_theta_2
                                                            * sin_lam_plus_theta))
                                            - sin_lam_plus_theta
                                                * (cos_phi
                                                    * (psi_dot_sin_phi.mul_add(S::int(2), theta_dot)
                                                        + thf_dot_cos_delta)
                                                    + delta_dot * residual1_by_phi_of_place_23))
                                        + sin_phi * sin_phi
                                            * (sin_lam_plus_theta
                                                * (thf_dot_cos_delta
                                                    + residual5_by_theta_of_motion * (S::int(1) - sin_delta_sq))
                                                + delta_dot_sin_delta * residual5_by_phi_of_place_3))
                                    - residual5_by_theta_of_motion_3 * cos_phi)))
                - residual5_by_theta_of_motion_2 * sin_lam)
            + rr_sin_lam * residual5_by_theta_of_motion
            + cos_lam
                * (c * residual5_by_theta_of_motion)
                    .mul_add(
                        residual5_by_theta_of_delta, -residual5_by_theta_of_motion_4,
                    )) + delta_dot * cos_delta_cos_phi * residual5_by_theta_of_place_5
        - sin_lam_plus_theta
            * (cos_lam
                * rr_minus_rf
                    .mul_add(residual5_by_theta_of_motion, c * delta_dot_sin_delta)
                + sin_lam * (-rF).mul_add(delta_dot_sin_delta, residual5_by_theta_of_motion_4)
                + delta_dot_sin_delta * residual5_by_theta_of_place_5 * sin_phi);
    let residual5_by_delta = (-residual5_by_phi_of_place_3)
        .mul_add(
            residual5_by_delta_of_motion_5,
            residual5_by_delta_of_motion * sin_lam_plus_theta,
        ) - residual5_by_phi_of_place * residual5_by_delta_of_motion_9;
    let residual5_by_x_dot = cos_psi;
    let residual5_by_y_dot = sin_psi;
    let residual5_by_psi_dot = residual5_by_phi_of_place
        * (-residual1_by_phi_of_c_lam_rf)
            .mul_add(
                residual1_by_phi_of_place_20,
                residual1_by_phi_of_place_4 * residual1_by_phi_of_w_lam_rr_rf,
            ) - residual1_by_phi_of_place_2
        + residual1_by_phi_of_place_8 * residual5_by_phi_of_place_2 * sin_lam_plus_theta
        + residual1_by_phi_of_place_8 * residual1_by_phi_of_place_22 * residual5_by_phi_of_place_3;
    let residual5_by_theta_dot = sin_lam_plus_theta
        * (cos_delta
            * (c_cos_lam
                + rF
                    * residual1_by_phi_of_place_4
                        .mul_add(residual5_by_theta_of_place_3, -sin_lam))
            - residual1_by_phi_of_w_c_lam_rr)
        + cos_lam_plus_theta
            * (residual5_by_theta_dot_of_w_lam_rr
                - rF
                    * residual1_by_phi_of_place_20
                        .mul_add(residual5_by_theta_of_place_3, cos_lam));
    let residual5_by_delta_dot = -residual1_by_phi_of_place_19 * residual5_by_phi_of_place;
    let residual5_by_thF_dot = residual1_by_phi_of_place_13 * residual5_by_thF_dot_of_place;
    let residual6_by_psi = residual4_by_psi_of_x_dot_y_dot_2;
    let residual6_by_phi = residual1_by_phi_of_place_13 * residual5_by_phi_of_motion_8
        - residual1_by_phi_of_place_23 * residual5_by_phi_of_motion_4
        - residual1_by_phi_of_place_6 * residual5_by_phi_of_motion_5
        - sin_phi
            * (residual1_by_phi_of_w_c_lam_rr
                * (residual2_by_phi_of_phi_dot + residual5_by_phi_of_psi_dot_3) + rR * phi_dot)
        - residual1_by_phi_of_place_8 * residual5_by_delta_of_motion_3
        - residual1_by_phi_of_place_4 * residual5_by_delta_of_motion_7
        + residual1_by_phi_of_place_20
            * residual1_by_phi_of_w_c_lam_rr
                .mul_add(residual5_by_theta_of_motion, residual6_by_phi_of_motion);
    let residual6_by_theta = cos_lam_plus_theta
        * (-sin_delta
            * (rF
                * (residual5_by_theta_of_place_3
                    * (cos_phi
                        * (sin_phi_cos_delta * residual2_by_phi_of_motion_2
                            * (S::int(2)
                                + cos_delta_cos_phi * cos_delta_cos_phi
                                    * residual5_by_theta_of_place_2)
                            + sin_delta
                                * (cos_phi * (delta_dot + residual6_by_theta_of_phi_dot)
                                    + S::int(2) * residual6_by_theta_of_motion_2
                                    - residual5_by_theta_of_place_2
                                        * (cos_delta
                                            * (-sin_phi
                                                * (-residual5_by_phi_of_motion_2)
                                                    .mul_add(
                                                        cos_lam_plus_theta,
                                                        residual2_by_phi_of_motion_2 * sin_delta,
                                                    ) + psi_dot * residual5_by_phi_of_place_3)
                                            + cos_phi
                                                * (sin_delta
                                                    * (sin_lam_plus_theta
                                                        * (cos_lam_plus_theta
                                                            * residual5_by_theta_of_motion_2.mul_add(S::int(2), thF_dot)
                                                            - phi_dot * sin_delta)
                                                        + delta_dot_sin_delta * residual5_by_theta_of_lam_theta_2
                                                        + cos_phi
                                                            * (delta_dot
                                                                * residual1_by_phi_of_place_5
                                                                    .mul_add(S::int(3), sin_delta_cos_phi)
                                                                + phi_dot
                                                                    * sin_phi_cos_delta
                                                                        .mul_add(S::int(3), residual1_by_phi_of_place_7)
                                                                + cos_lam_plus_theta
                                                                    * (sin_delta
                                                                        * (residual6_by_theta_of_motion
                                                                            - cos_lam_plus_theta
                                                                                * residual2_by_phi_of_motion
                                                                                    .mul_add(cos_phi, residual6_by_theta_of_motion_2))
                                                                        - cos_delta
                                                                            * (residual1_by_phi_of_place_23
                                                                                * phi_dot.mul_add(S::int(3), residual2_by_phi_of_delta_dot)
                                                                                + S::int(2) * residual2_by_phi_of_theta_dot))))
                                                    + cos_delta_sq
                                                        * (delta_dot * (S::int(2) - cos_lam_plus_theta_sq)
                                                            - cos_phi
                                                                * (cos_phi
                                                                    * (delta_dot
                                                                        * (-cos_lam_plus_theta_sq).mul_add(S::int(2), S::int(3))
                                                                        + S::int(3) * residual2_by_phi_of_phi_dot)
                                                                    + residual6_by_theta_of_motion_2)
                                                            + residual6_by_theta_of_phi_dot))))) - delta_dot_sin_delta)
                    + residual6_by_theta_of_motion * cos_lam * sin_delta
                    + delta_dot_sin_phi * sin_lam)
                - residual5_by_theta_dot_of_w_lam_rr * residual6_by_theta_of_motion
                    * sin_delta - c_cos_lam * delta_dot_sin_phi)
            + residual1_by_phi_of_w_c_lam_rr * phi_dot_cos_phi
            + cos_delta
                * (cos_delta
                    * (w_sin_lam
                        .mul_add(
                            residual6_by_theta_of_motion,
                            rr_minus_rf * residual6_by_theta_of_motion * cos_lam,
                        ) + delta_dot * residual5_by_thF_dot_of_place * cos_phi_sq)
                    + residual1_by_phi_of_c_lam_rf * phi_dot_cos_phi))
        + sin_delta_cos_phi * residual5_by_theta_of_place_5 * residual6_by_theta_of_motion
        + sin_lam_plus_theta
            * (cos_lam
                * ((-w)
                    .mul_add(
                        residual6_by_theta_of_motion,
                        c * residual5_by_theta_of_delta * residual6_by_theta_of_motion,
                    ) + rr_minus_rf * phi_dot_cos_phi * residual6_by_theta_of_delta)
                + sin_lam
                    * (w * phi_dot_cos_phi)
                        .mul_add(
                            residual6_by_theta_of_delta,
                            rR * residual6_by_theta_of_motion,
                        )
                + rF
                    * (-cos_delta
                        * (theta_dot
                            * (residual5_by_theta_of_place_4 * (cos_phi_sq - S::int(1))
                                + sin_lam * sin_phi) + psi_dot * residual6_by_theta_of_place)
                        + thF_dot * residual5_by_theta_of_place_4));
    let residual6_by_delta = (-residual1_by_phi_of_place_6)
        .mul_add(
            residual5_by_delta_of_motion_5,
            -residual1_by_phi_of_place_23 * residual5_by_delta_of_motion,
        ) - residual1_by_phi_of_place_13 * residual5_by_delta_of_motion_9;
    let residual6_by_x_dot = minus_sin_psi;
    let residual6_by_y_dot = cos_psi;
    let residual6_by_psi_dot = residual6_by_psi_dot_of_place_2;
    let residual6_by_phi_dot = sin_delta_sin_phi
        * (-rF).mul_add(residual6_by_theta_of_place, c_cos_lam)
        + cos_phi
            * (rR - residual1_by_phi_of_w_lam_rr_rf * cos_lam_plus_theta
                + residual5_by_thF_dot_of_place * cos_phi
                + sin_lam_plus_theta
                    * (rF
                        * (-residual5_by_theta_of_place)
                            .mul_add(residual5_by_theta_of_place_4, sin_lam_cos_delta)
                        + residual6_by_psi_dot_of_place));
    let residual6_by_theta_dot = residual6_by_psi_dot_of_place_2 * sin_phi;
    let residual6_by_delta_dot = -residual1_by_phi_of_place_13 * residual1_by_phi_of_place_19;
    let residual6_by_thF_dot = -residual5_by_theta_of_place_5 * cos_lam_plus_theta;
    let zero = S::int(0);
    [
        zero, zero, zero, residual1_by_phi, residual1_by_theta, residual1_by_delta, zero, zero,
        zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, residual2_by_phi,
        residual2_by_theta, residual2_by_delta, zero, zero, zero, zero, zero, residual2_by_phi_dot,
        residual2_by_theta_dot, residual2_by_delta_dot, zero, zero, zero, zero, residual3_by_psi,
        zero, zero, zero, zero, zero, residual3_by_x_dot, residual3_by_y_dot, zero, zero, zero,
        zero, residual3_by_thR_dot, zero, zero, zero, residual4_by_psi, zero, zero, zero, zero,
        zero, residual4_by_x_dot, residual4_by_y_dot, zero, zero, zero, zero, zero, zero, zero,
        zero, residual5_by_psi, residual5_by_phi, residual5_by_theta, residual5_by_delta, zero,
        zero, residual5_by_x_dot, residual5_by_y_dot, residual5_by_psi_dot, zero,
        residual5_by_theta_dot, residual5_by_delta_dot, zero, residual5_by_thF_dot, zero, zero,
        residual6_by_psi, residual6_by_phi, residual6_by_theta, residual6_by_delta, zero, zero,
        residual6_by_x_dot, residual6_by_y_dot, residual6_by_psi_dot, residual6_by_phi_dot,
        residual6_by_theta_dot, residual6_by_delta_dot, zero, residual6_by_thF_dot,
    ]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    q_dot: &[S; 8],
    direction: &[S; 16],
) -> [S; 16] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[8 + i],
    });
    let (of_q, of_v) = (coordinate_rates(&p, &q, &v), accelerations(&p, &q, &v));
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
            parameters: 26,
            coordinates: 8,
            variables: 8,
            speeds: 3,
            reactions: 5,
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
        11
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
                q_dot
                    .copy_from_slice(
                        &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
                    );
                v_dot
                    .copy_from_slice(
                        &accelerations(&Parameters::from_slice(p), array(q), array(v)),
                    );
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
        4
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1",
            "divisor 2 of the accelerations",
            "divisor 3 of the accelerations",
            "divisor 4 of the accelerations",
        ][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        6
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["contact", "contact'", "rear_1", "rear_2", "front_1", "front_2"][at]
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
