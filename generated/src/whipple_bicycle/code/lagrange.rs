//! Whipple bicycle: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, psi, phi, theta, delta, thR, thF, constraint contact, constraint rear_1, constraint rear_2, constraint front_1, constraint front_2.
///
/// 912 operations, 6 sines and cosines, 2 other functions.
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
    let cos_delta_v_y_in_l_2_3 = v_Y_in_L_2_3 * cos_delta;
    let v_S_in_F_2_3 = v_B_in_S_1_3.mul_add(sin_delta, -cos_delta_v_y_in_l_2_3);
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
    let cos_delta_v_y_in_l_2_4 = v_Y_in_L_2_4 * cos_delta;
    let v_S_in_F_2_4 = v_B_in_S_1_4.mul_add(sin_delta, -cos_delta_v_y_in_l_2_4);
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
    let v_Ho_3_5_of_place = v_Ho_2_5_of_w_c_lam_rr_2 * sin_phi;
    let v_Ho_3_5 = v_B_in_S_3_5 + v_Ho_3_5_of_place;
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
    let v_FC_1_3_of_w_lam_rr_rf = cos_lam * (rR - rF) + w * sin_lam;
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
    let w_B_in_S_1_4 = (-cos_lam).mul_add(cos_theta, sin_lam * sin_theta);
    let w_B_in_S_3_4 = sin_lam.mul_add(cos_theta, cos_lam * sin_theta);
    let w_S_in_F_1_4 = w_B_in_S_1_4 * cos_delta;
    let w_S_in_F_2_4 = w_B_in_S_1_4 * sin_delta;
    let v_Bo_2_4 = xB.mul_add(sin_theta, rR) - rr_plus_zb * cos_theta;
    let v_Ho_2_7 = w_B_in_S_3_4.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, rR);
    let v_S_in_F_1_6 = v_Ho_2_7 * sin_delta;
    let v_S_in_F_2_6 = v_Ho_2_7 * cos_delta;
    let v_Ho_1_4 = w_S_in_F_2_4.mul_add(v_Ho_1_3_of_lam_rr_xh_zh, v_S_in_F_1_6);
    let v_Ho_2_8 = w_B_in_S_3_4.mul_add(minus_v_ho_2_6_of_place, -v_S_in_F_2_6)
        - w_S_in_F_1_4 * v_Ho_1_3_of_lam_rr_xh_zh;
    let v_Ho_3_7 = w_S_in_F_2_4 * minus_v_ho_2_6_of_place;
    let v_FC_1_4 = w_S_in_F_2_4.mul_add(v_FC_1_3_of_w_lam_rr_rf, v_S_in_F_1_6);
    let v_FC_2_4 = w_S_in_F_1_4.mul_add(v_FC_1_3_of_w_lam_rr_rf, v_S_in_F_2_6)
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
    let p_v_Ho_2_12 = p_v_S_in_F_1_6.mul_add(sin_delta, p_v_S_in_F_2_6 * cos_delta);
    let p_v_B_in_S_1_6 = (-p_v_S_in_F_1_6)
        .mul_add(cos_delta, p_v_S_in_F_2_6 * sin_delta);
    let p_v_Bo_2_6 = mB * v_Bo_2_4;
    let p_v_L_in_B_3_6 = (-p_v_B_in_S_1_6).mul_add(sin_lam, p_v_Ho_3_12 * cos_lam);
    let p_v_L_in_B_1_6 = p_v_B_in_S_1_6.mul_add(cos_lam, p_v_Ho_3_12 * sin_lam);
    let p_v_RC_2_6 = rR.mul_add(mR, p_v_Ho_2_12) + p_v_Bo_2_6;
    let p_v_RC_1_6 = p_v_L_in_B_1_6.mul_add(cos_theta, p_v_L_in_B_3_6 * sin_theta);
    let p_v_Y_in_L_3_6 = (-p_v_L_in_B_1_6)
        .mul_add(sin_theta, p_v_L_in_B_3_6 * cos_theta);
    let p_v_N_in_Y_2_6 = p_v_Y_in_L_3_6.mul_add(sin_phi, p_v_RC_2_6 * cos_phi);
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
    let w_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
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
    let p_w_S_in_F_1_4 = (-H_fork_1_4).mul_add(cos_lam, H_fork_3_4 * sin_lam)
        + H_front_wheel_1_4 - p_v_Ho_2_11 * v_Ho_1_3_of_lam_rr_xh_zh
        + p_v_FC_2_6 * v_FC_1_3_of_w_lam_rr_rf;
    let p_w_B_in_S_3_4 = p_v_Ho_2_12.mul_add(v_Ho_2_5_of_w_c_lam_rr_2, p_w_F_3_4);
    let p_w_B_in_S_1_4 = p_w_S_in_F_1_4.mul_add(cos_delta, p_w_S_in_F_2_4 * sin_delta);
    let p_w_B_2_4 = (-p_w_S_in_F_1_4).mul_add(sin_delta, p_w_S_in_F_2_4 * cos_delta)
        + p_v_Ho_3_12 * v_Ho_2_5_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_4 = xB.mul_add(p_v_Bo_2_6, H_frame_3_4) + p_w_B_in_S_3_4 * cos_lam
        + p_w_B_in_S_1_4 * sin_lam;
    let p_w_L_in_B_1_4 = p_w_B_in_S_3_4.mul_add(sin_lam, H_frame_1_4)
        - p_w_B_in_S_1_4 * cos_lam - p_v_Bo_2_6 * rr_plus_zb;
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
    let m_3_4_of_place = p_w_Y_in_L_2_4.mul_add(sin_phi, p_w_Y_in_L_3_4 * cos_phi);
    let m_3_5_of_place = (-p_w_Y_in_L_2_5).mul_add(sin_phi, p_w_Y_in_L_3_5 * cos_phi);
    let m_3_6_of_place = (-p_w_Y_in_L_2_6).mul_add(sin_phi, p_w_Y_in_L_3_6 * cos_phi);
    let m_3_8_of_place = p_w_Y_in_L_3_7.mul_add(cos_phi, H_front_wheel_2_5 * sin_phi);
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let m_3_12_of_place = sin_psi * cos_lam_plus_theta;
    let m_3_12_of_place_2 = m_3_12_of_place
        .mul_add(sin_phi, cos_psi * sin_lam_plus_theta);
    let m_3_12_of_place_3 = cos_phi * sin_lam_plus_theta;
    let m_3_12_of_place_4 = m_3_12_of_place_3 * sin_delta;
    let m_3_12_of_place_5 = sin_phi_cos_delta + m_3_12_of_place_4;
    let m_3_12_of_place_6 = (-m_3_12_of_place_3).mul_add(cos_delta, sin_delta_sin_phi);
    let m_3_12_of_place_7 = S::int(1) / m_3_12_of_place_5.mul_add(m_3_12_of_place_5, -S::int(1));
    let m_3_12_of_place_8 = cos_phi * sin_lam_plus_theta * sin_delta;
    let m_3_12_of_place_9 = rF * m_3_12_of_place_7
        * (S::int(1) - (m_3_12_of_place_8 + sin_phi_cos_delta).powi(2)).sqrt();
    let m_3_12_of_place_10 = m_3_12_of_place_5 * m_3_12_of_place_9;
    let m_3_12_of_place_11 = (-m_3_12_of_place_6)
        .mul_add(m_3_12_of_place_10, v_FC_2_3_of_c_lam_rf * m_3_12_of_place_5);
    let m_3_12_of_place_12 = v_Ho_3_5_of_place + m_3_12_of_place_11;
    let m_3_12_of_place_13 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let m_3_12_of_place_14 = cos_psi * cos_lam_plus_theta;
    let m_3_12_of_place_15 = (-m_3_12_of_place_13)
        .mul_add(sin_psi, m_3_12_of_place_14 * sin_delta);
    let m_3_12_of_place_16 = cos_phi * cos_lam_plus_theta;
    let m_3_12_of_place_17 = (-v_FC_1_3_of_w_lam_rr_rf)
        .mul_add(m_3_12_of_place_6, v_FC_2_3_of_c_lam_rf * m_3_12_of_place_16);
    let m_3_12_of_place_18 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let m_3_12_of_place_19 = (-m_3_12_of_place_18)
        .mul_add(sin_psi, m_3_12_of_place_14 * cos_delta);
    let m_3_12_of_place_20 = (-m_3_12_of_place_10)
        .mul_add(m_3_12_of_place_16, v_FC_1_3_of_w_lam_rr_rf * m_3_12_of_place_5);
    let m_3_12_of_place_21 = v_Ho_2_5_of_w_c_lam_rr_2 * m_3_12_of_place_16;
    let m_3_12_of_place_22 = (-m_3_12_of_place_19)
        .mul_add(m_3_12_of_place_20, v_Y_in_L_2_3 * m_3_12_of_place_21);
    let m_3_12_of_place_23 = m_3_12_of_place_15
        .mul_add(m_3_12_of_place_17, m_3_12_of_place_2 * m_3_12_of_place_12);
    let m_3_12_of_place_24 = v_RC_1_3.mul_add(cos_psi, m_3_12_of_place_22);
    let m_3_12_of_place_25 = m_3_12_of_place_23 + m_3_12_of_place_24;
    let m_3_13_of_place = m_3_12_of_place_13
        .mul_add(cos_psi, m_3_12_of_place * sin_delta);
    let m_3_13_of_place_2 = (-m_3_12_of_place_14)
        .mul_add(sin_phi, sin_psi * sin_lam_plus_theta);
    let m_3_13_of_place_3 = m_3_12_of_place_18
        .mul_add(cos_psi, m_3_12_of_place * cos_delta);
    let m_3_13_of_place_4 = m_3_12_of_place_20
        .mul_add(m_3_13_of_place_3, v_Y_in_L_2_4 * m_3_12_of_place_21);
    let m_3_13_of_place_5 = m_3_12_of_place_12
        .mul_add(m_3_13_of_place_2, m_3_12_of_place_17 * m_3_13_of_place);
    let m_3_13_of_place_6 = v_RC_1_3.mul_add(sin_psi, -m_3_13_of_place_4);
    let m_3_13_of_place_7 = m_3_13_of_place_5 + m_3_13_of_place_6;
    let m_4_5_of_place = p_w_L_in_B_3_5.mul_add(sin_theta, rR * p_v_Ho_2_14);
    let m_4_5_of_place_2 = p_w_L_in_B_1_5.mul_add(cos_theta, m_4_5_of_place);
    let m_4_6_of_place = p_w_L_in_B_3_6.mul_add(sin_theta, rR * p_v_Ho_2_16);
    let m_4_6_of_place_2 = p_w_L_in_B_1_6.mul_add(cos_theta, m_4_6_of_place);
    let m_4_8_of_place = (-p_w_L_in_B_3_7)
        .mul_add(sin_theta, p_w_L_in_B_1_7 * cos_theta);
    let m_4_9_of_place = m_3_12_of_place_9 * m_3_12_of_place_16;
    let m_4_9_of_place_2 = v_FC_1_3_of_w_lam_rr_rf - m_4_9_of_place;
    let m_4_9_of_place_3 = m_3_12_of_place_7 * m_3_12_of_place_10;
    let m_4_9_of_place_4 = m_3_12_of_place_16 * m_4_9_of_place_3;
    let m_4_9_of_place_5 = (-m_3_12_of_place_6)
        .mul_add(m_3_12_of_place_9, v_FC_2_3_of_c_lam_rf);
    let m_4_9_of_place_6 = m_3_12_of_place_6 * m_4_9_of_place_3;
    let m_4_9_of_place_7 = -m_3_12_of_place_6
        * m_3_12_of_place_13
            .mul_add(m_4_9_of_place_6, m_3_12_of_place_9 * m_3_12_of_place_18)
        + m_3_12_of_place_18 * m_4_9_of_place_5;
    let m_4_9_of_place_8 = sin_phi
        * (-m_4_9_of_place_2)
            .mul_add(cos_lam_plus_theta, v_Ho_2_5_of_w_c_lam_rr_2 * sin_lam_plus_theta)
        + m_3_12_of_place_16
            * (-m_3_12_of_place_13)
                .mul_add(
                    m_4_9_of_place_4,
                    m_3_12_of_place_9 * sin_phi * cos_lam_plus_theta,
                );
    let m_4_9_of_place_9 = v_RC_1_3 + m_4_9_of_place_7;
    let m_4_9_of_place_10 = m_4_9_of_place_8 + m_4_9_of_place_9;
    let m_4_12_of_place = sin_phi_cos_delta.mul_add(S::int(2), m_3_12_of_place_4);
    let m_4_12_of_place_2 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), m_3_12_of_place_8))
        .sqrt()
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + m_3_12_of_place_4 * m_4_12_of_place);
    let rf_m_4_12_of_place_2 = rF * m_4_12_of_place_2;
    let m_4_12_of_place_3 = sin_delta_sin_phi
        * (c_cos_lam + rF * sin_delta_sin_phi.mul_add(m_4_12_of_place_2, -sin_lam))
        + cos_phi
            * (rR - v_FC_1_3_of_w_lam_rr_rf * cos_lam_plus_theta
                + sin_lam_plus_theta
                    * (cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam
                        + rF
                            * (-(m_4_12_of_place * m_4_12_of_place_2))
                                .mul_add(sin_delta, sin_lam * cos_delta))
                + rf_m_4_12_of_place_2 * cos_phi);
    let m_4_12_of_place_4 = m_4_12_of_place_3 * sin_psi;
    let m_4_13_of_place = m_4_12_of_place_3 * cos_psi;
    let m_5_9_of_place = m_3_12_of_place_16 * sin_delta;
    let m_5_9_of_place_2 = m_4_9_of_place_5 * cos_delta;
    let m_5_9_of_place_3 = m_4_9_of_place_4
        .mul_add(m_5_9_of_place, m_3_12_of_place_3 * m_3_12_of_place_9);
    let m_5_9_of_place_4 = m_3_12_of_place_6
        * m_4_9_of_place_6.mul_add(m_5_9_of_place, m_4_9_of_place * cos_delta)
        - m_3_12_of_place_3 * m_4_9_of_place_2;
    let m_5_9_of_place_5 = m_3_12_of_place_21
        + m_3_12_of_place_16 * (m_5_9_of_place_2 - m_5_9_of_place_3);
    let m_5_9_of_place_6 = m_5_9_of_place_4 - m_5_9_of_place_5;
    let m_5_12_of_place = v_Ho_2_5_of_w_c_lam_rr_2 + m_5_9_of_place_2;
    let m_5_12_of_place_2 = -m_4_9_of_place_2 * cos_delta;
    let m_5_12_of_place_3 = m_4_9_of_place_2 * sin_delta;
    let m_5_12_of_place_4 = (-m_3_12_of_place_15)
        .mul_add(m_5_12_of_place_3, m_3_12_of_place_19 * m_5_12_of_place_2);
    let m_5_12_of_place_5 = m_3_12_of_place_2
        .mul_add(m_5_12_of_place, m_5_12_of_place_4);
    let m_5_13_of_place = (-m_3_13_of_place)
        .mul_add(m_5_12_of_place_3, m_3_13_of_place_3 * m_5_12_of_place_2);
    let m_5_13_of_place_2 = m_3_13_of_place_2.mul_add(m_5_12_of_place, m_5_13_of_place);
    let m_6_9_of_place = m_3_12_of_place_5
        .mul_add(
            m_4_9_of_place_5,
            -m_3_12_of_place_16 * m_3_12_of_place_16 * m_4_9_of_place_6,
        );
    let m_6_9_of_place_2 = m_3_12_of_place_6
        * m_3_12_of_place_6.mul_add(m_4_9_of_place_6, m_3_12_of_place_10) - m_6_9_of_place;
    let m_6_12_of_place = m_3_12_of_place_15 * m_4_9_of_place_5;
    let m_6_13_of_place = m_3_13_of_place * m_4_9_of_place_5;
    let rr_cos_psi = rR * cos_psi;
    let rr_sin_psi = rR * sin_psi;
    let m_8_12_of_place = rf_m_4_12_of_place_2
        * (sin_delta * v_Y_in_L_3_4.mul_add(sin_lam_plus_theta, m_3_12_of_place)
            - cos_delta_v_y_in_l_2_4);
    let m_8_13_of_place = rf_m_4_12_of_place_2
        * (cos_delta_v_y_in_l_2_3
            + sin_delta * (-v_Y_in_L_3_3).mul_add(sin_lam_plus_theta, m_3_12_of_place_14));
    let minus_p_w_b_2_6 = -p_w_B_2_6;
    let minus_m_1_2_of_place = -m_1_2_of_place;
    let minus_m_1_3_of_place = -m_1_3_of_place;
    let minus_m_1_4_of_place = -m_1_4_of_place;
    let minus_m_1_5_of_place = -m_1_5_of_place;
    let minus_m_2_3_of_place = -m_2_3_of_place;
    let minus_m_2_4_of_place = -m_2_4_of_place;
    let minus_m_2_5_of_place = -m_2_5_of_place;
    let minus_m_3_5_of_place = -m_3_5_of_place;
    let minus_m_4_5_of_place_2 = -m_4_5_of_place_2;
    let minus_m_4_8_of_place = -m_4_8_of_place;
    // Entries that are not zero.
    let m_1_1 = p_v_N_in_Y_2_3.mul_add(sin_psi, p_v_RC_1_3 * cos_psi);
    let m_1_2 = minus_m_1_2_of_place;
    let m_1_3 = minus_m_1_3_of_place;
    let m_1_4 = minus_m_1_4_of_place;
    let m_1_5 = minus_m_1_5_of_place;
    let m_1_6 = m_1_6_of_place;
    let m_1_10 = -S::int(1);
    let m_1_12 = -S::int(1);
    let m_2_1 = minus_m_1_2_of_place;
    let m_2_2 = p_v_N_in_Y_2_4.mul_add(cos_psi, p_v_RC_1_4 * sin_psi);
    let m_2_3 = minus_m_2_3_of_place;
    let m_2_4 = minus_m_2_4_of_place;
    let m_2_5 = minus_m_2_5_of_place;
    let m_2_6 = m_2_6_of_place;
    let m_2_11 = -S::int(1);
    let m_2_13 = -S::int(1);
    let m_3_1 = minus_m_1_3_of_place;
    let m_3_2 = minus_m_2_3_of_place;
    let m_3_3 = p_w_Y_in_L_2_3.mul_add(sin_phi, p_w_Y_in_L_3_3 * cos_phi);
    let m_3_4 = m_3_4_of_place;
    let m_3_5 = minus_m_3_5_of_place;
    let m_3_6 = m_3_6_of_place;
    let m_3_7 = H_rear_wheel_2_3;
    let m_3_8 = m_3_8_of_place;
    let m_3_12 = m_3_12_of_place_25;
    let m_3_13 = m_3_13_of_place_7;
    let m_4_1 = minus_m_1_4_of_place;
    let m_4_2 = minus_m_2_4_of_place;
    let m_4_3 = m_3_4_of_place;
    let m_4_4 = rR.mul_add(p_v_RC_2_6, IRxx) + p_w_L_in_B_3_4 * sin_theta
        + p_w_L_in_B_1_4 * cos_theta;
    let m_4_5 = minus_m_4_5_of_place_2;
    let m_4_6 = m_4_6_of_place_2;
    let m_4_8 = minus_m_4_8_of_place;
    let m_4_9 = -m_4_9_of_place_10;
    let m_4_12 = m_4_12_of_place_4;
    let m_4_13 = -m_4_13_of_place;
    let m_5_1 = minus_m_1_5_of_place;
    let m_5_2 = minus_m_2_5_of_place;
    let m_5_3 = minus_m_3_5_of_place;
    let m_5_4 = minus_m_4_5_of_place_2;
    let m_5_6 = minus_p_w_b_2_6;
    let m_5_9 = -m_5_9_of_place_6;
    let m_5_12 = m_5_12_of_place_5;
    let m_5_13 = m_5_13_of_place_2;
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
    let m_7_10 = -rr_cos_psi;
    let m_7_11 = -rr_sin_psi;
    let m_8_3 = m_3_8_of_place;
    let m_8_4 = minus_m_4_8_of_place;
    let m_8_8 = IFyy;
    let m_8_12 = -m_8_12_of_place;
    let m_8_13 = m_8_13_of_place;
    let m_9_4 = m_4_9_of_place_10;
    let m_9_5 = m_5_9_of_place_6;
    let m_9_6 = -m_6_9_of_place_2;
    let m_10_1 = S::int(1);
    let m_10_7 = rr_cos_psi;
    let m_11_2 = S::int(1);
    let m_11_7 = rr_sin_psi;
    let m_12_1 = S::int(1);
    let m_12_3 = -m_3_12_of_place_25;
    let m_12_4 = -m_4_12_of_place_4;
    let m_12_5 = -m_5_12_of_place_5;
    let m_12_6 = -m_6_12_of_place;
    let m_12_8 = m_8_12_of_place;
    let m_13_2 = S::int(1);
    let m_13_3 = -m_3_13_of_place_7;
    let m_13_4 = m_4_13_of_place;
    let m_13_5 = -m_5_13_of_place_2;
    let m_13_6 = -m_6_13_of_place;
    let m_13_8 = -m_8_13_of_place;
    let zero = S::int(0);
    [
        [
            m_1_1, m_1_2, m_1_3, m_1_4, m_1_5, m_1_6, zero, zero, zero, m_1_10, zero, m_1_12, zero,
        ],
        [
            m_2_1, m_2_2, m_2_3, m_2_4, m_2_5, m_2_6, zero, zero, zero, zero, m_2_11, zero, m_2_13,
        ],
        [
            m_3_1, m_3_2, m_3_3, m_3_4, m_3_5, m_3_6, m_3_7, m_3_8, zero, zero, zero, m_3_12,
            m_3_13,
        ],
        [
            m_4_1, m_4_2, m_4_3, m_4_4, m_4_5, m_4_6, zero, m_4_8, m_4_9, zero, zero, m_4_12,
            m_4_13,
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
            zero, zero, m_7_3, zero, zero, zero, m_7_7, zero, zero, m_7_10, m_7_11, zero, zero,
        ],
        [
            zero, zero, m_8_3, m_8_4, H_front_wheel_2_5, zero, zero, m_8_8, zero, zero, zero,
            m_8_12, m_8_13,
        ],
        [
            zero, zero, zero, m_9_4, m_9_5, m_9_6, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_10_1, zero, zero, zero, zero, zero, m_10_7, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_11_2, zero, zero, zero, zero, m_11_7, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_12_1, zero, m_12_3, m_12_4, m_12_5, m_12_6, zero, m_12_8, zero, zero, zero, zero,
            zero,
        ],
        [
            zero, m_13_2, m_13_3, m_13_4, m_13_5, m_13_6, zero, m_13_8, zero, zero, zero, zero,
            zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', psi'', phi'', theta'', delta'', thR'', thF'', lambda_contact, lambda_rear_1, lambda_rear_2, lambda_front_1, lambda_front_2).
///
/// 1060 operations, 6 sines and cosines, 1 other function.
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
    let rr_w_y_in_l_2 = rR * w_Y_in_L_2;
    let v_RC_1 = rr_w_y_in_l_2 - v_N_in_Y_1;
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
    let psi_dot_sin_psi = psi_dot * sin_psi;
    let psi_dot_cos_psi = psi_dot * cos_psi;
    let v_N_in_Y_1_2 = (-y_dot).mul_add(psi_dot_cos_psi, x_dot * psi_dot_sin_psi);
    let v_N_in_Y_2_2 = x_dot.mul_add(psi_dot_cos_psi, y_dot * psi_dot_sin_psi);
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
    let v_Ho_3_3_of_place = w_Y_in_L_2_2 * v_Ho_2_of_w_c_lam_rr_2;
    let v_Ho_3_3 = v_B_in_S_3_2 + v_Ho_3_3_of_place;
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
        + p_v_L_in_B_1_2 * cos_theta - p_v_L_in_B_1 * theta_dot_sin_theta
        + p_v_L_in_B_3 * theta_dot_cos_theta;
    let p_v_Y_in_L_3_2 = (-p_v_L_in_B_3_2).mul_add(cos_theta, mR * v_Y_in_L_3_2)
        + p_v_L_in_B_1_2 * sin_theta + p_v_L_in_B_3 * theta_dot_sin_theta
        + p_v_L_in_B_1 * theta_dot_cos_theta;
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
    let p_w_Y_in_L_3_2 = p_w_L_in_B_3_2.mul_add(cos_theta, H_rear_wheel_3_2)
        - p_w_L_in_B_1_2 * sin_theta + p_w_L_in_B_3 * theta_dot_sin_theta
        + p_w_L_in_B_1 * theta_dot_cos_theta;
    let p_w_Y_in_L_2_2 = rR.mul_add(p_v_RC_1_2, H_rear_wheel_2_2) + p_w_B_2_2;
    let mp_L_3 = rR * mp_N_1_of_mr_mb_mh_mf;
    let mp_B_1 = xB * mB;
    let mp_B_3 = mB * rr_plus_zb;
    let mp_S_1 = v_Ho_2_of_w_c_lam_rr_2 * mh_plus_mf;
    let mp_F_1 = (-mF).mul_add(v_FC_2_of_c_lam_rf, mH * v_Ho_2_2_of_place);
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
    let f_9_of_theta_dot = theta_dot * cos_lam_plus_theta;
    let f_9_of_motion = f_9_of_theta_dot.mul_add(sin_phi, delta_dot * cos_phi);
    let f_9_of_motion_2 = theta_dot.mul_add(theta_dot, phi_dot * phi_dot);
    let f_9_of_place = cos_phi * sin_lam_plus_theta;
    let f_9_of_motion_3 = f_9_of_motion_2 * f_9_of_place;
    let f_9_of_motion_4 = (phi_dot * f_9_of_motion).mul_add(S::int(2), f_9_of_motion_3);
    let f_9_of_place_2 = cos_phi * cos_lam_plus_theta;
    let f_9_of_motion_5 = (-theta_dot)
        .mul_add(f_9_of_place_2, phi_dot_sin_phi * sin_lam_plus_theta);
    let f_9_of_motion_6 = f_9_of_motion_5.mul_add(S::int(2), delta_dot * sin_phi);
    let phi_dot_sin_delta = phi_dot * sin_delta;
    let f_9_of_delta_dot = delta_dot_cos_delta * f_9_of_place;
    let f_9_of_motion_7 = (-delta_dot_sin_delta)
        .mul_add(f_9_of_motion_6, f_9_of_motion_4 * cos_delta)
        - phi_dot_sin_phi * phi_dot_sin_delta + delta_dot * f_9_of_delta_dot;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let f_9_of_place_3 = (-f_9_of_place).mul_add(cos_delta, sin_delta_sin_phi);
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
    let f_9_of_motion_8 = (-phi_dot_cos_phi)
        .mul_add(cos_delta, delta_dot_sin_delta * sin_phi);
    let f_9_of_motion_9 = (-f_9_of_motion_5).mul_add(sin_delta, f_9_of_delta_dot) - f_9_of_motion_8;
    let f_9_of_motion_10 = f_9_of_place_6 * f_9_of_motion_9;
    let f_9_of_place_9 = f_9_of_place_4 * f_9_of_place_5;
    let phi_dot_cos_delta = phi_dot * cos_delta;
    let f_9_of_delta_dot_2 = delta_dot_sin_delta * f_9_of_place;
    let f_9_of_motion_11 = f_9_of_motion_9 * f_9_of_motion_10
        * (f_9_of_place_5 - S::int(3) * f_9_of_place_9 * f_9_of_place_9)
        - f_9_of_place_6 * f_9_of_place_9
            * (delta_dot_cos_delta.mul_add(f_9_of_motion_6, f_9_of_motion_4 * sin_delta)
                + phi_dot_sin_phi * phi_dot_cos_delta + delta_dot * f_9_of_delta_dot_2);
    let f_9_of_motion_12 = f_9_of_motion_10 * f_9_of_place_9;
    let f_9_of_motion_13 = delta_dot_cos_delta
        .mul_add(sin_phi, phi_dot_cos_phi * sin_delta);
    let f_9_of_motion_14 = f_9_of_motion_5.mul_add(cos_delta, f_9_of_delta_dot_2)
        + f_9_of_motion_13;
    let f_9_of_motion_14_doubled = S::int(2) * f_9_of_motion_14;
    let f_9_of_theta_dot_2 = theta_dot * sin_lam_plus_theta;
    let phi_dot_sin_phi_doubled = S::int(2) * phi_dot_sin_phi;
    let f_9_of_motion_15 = (-f_9_of_motion_2)
        .mul_add(f_9_of_place_2, f_9_of_theta_dot_2 * phi_dot_sin_phi_doubled);
    let f_9_of_motion_16 = theta_dot
        .mul_add(f_9_of_place, phi_dot_sin_phi * cos_lam_plus_theta);
    let f_9_of_motion_16_doubled = S::int(2) * f_9_of_motion_16;
    let f_9_of_place_10 = f_9_of_place_2 * f_9_of_place_6;
    let f_9_of_place_11 = v_FC_1_of_w_lam_rr_rf - f_9_of_place_10;
    let f_9_of_motion_17 = (-f_9_of_place_6)
        .mul_add(f_9_of_motion_14, f_9_of_place_3 * f_9_of_motion_12);
    let f_9_of_motion_18 = f_9_of_place_6
        .mul_add(f_9_of_motion_16, f_9_of_place_2 * f_9_of_motion_12);
    let rr_thr_dot = rR * thR_dot;
    let f_12_of_place = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let f_12_of_place_2 = cos_psi * cos_lam_plus_theta;
    let f_12_of_phi_dot = phi_dot * cos_lam_plus_theta;
    let f_12_of_motion = psi_dot.mul_add(f_9_of_place_4, theta_dot * cos_delta);
    let f_12_of_motion_2 = f_12_of_phi_dot.mul_add(sin_delta, -f_12_of_motion);
    let f_12_of_motion_3 = thF_dot - f_12_of_motion_2;
    let f_12_of_motion_4 = (-theta_dot)
        .mul_add(delta_dot_sin_delta, psi_dot * f_9_of_motion_9)
        + phi_dot_sin_delta * f_9_of_theta_dot_2 - delta_dot_cos_delta * f_12_of_phi_dot;
    let f_12_of_motion_5 = f_9_of_place_11
        .mul_add(f_12_of_motion_4, f_9_of_motion_18 * f_12_of_motion_3);
    let minus_f_12_of_motion_2 = -f_12_of_motion_2;
    let f_12_of_motion_6 = (-f_9_of_place_10)
        .mul_add(f_12_of_motion_3, v_FC_1_of_w_lam_rr_rf * minus_f_12_of_motion_2);
    let f_12_of_motion_7 = (-phi_dot_sin_phi)
        .mul_add(sin_delta, f_9_of_motion * cos_delta) - f_9_of_motion_8 * sin_lam_plus_theta;
    let f_12_of_motion_8 = f_9_of_theta_dot_2
        .mul_add(cos_psi, psi_dot_sin_psi * cos_lam_plus_theta);
    let f_12_of_place_3 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let f_12_of_motion_9 = psi_dot.mul_add(f_9_of_place_2, phi_dot * sin_lam_plus_theta);
    let f_12_of_motion_10 = delta_dot + f_12_of_motion_9;
    let f_12_of_motion_11 = psi_dot.mul_add(f_9_of_place_3, theta_dot * sin_delta)
        + f_12_of_phi_dot * cos_delta;
    let f_12_of_motion_12 = (-theta_dot)
        .mul_add(f_12_of_phi_dot, psi_dot * f_9_of_motion_16);
    let f_12_of_motion_13 = f_9_of_place_11
        * (psi_dot.mul_add(f_9_of_motion_14, theta_dot * delta_dot_cos_delta)
            - phi_dot_cos_delta * f_9_of_theta_dot_2 - delta_dot_sin_delta * f_12_of_phi_dot)
        - f_9_of_motion_17 * f_12_of_motion_10 + f_9_of_motion_18 * f_12_of_motion_11
        + f_9_of_place_8 * f_12_of_motion_12;
    let f_12_of_motion_14 = (-f_9_of_place_11)
        .mul_add(f_12_of_motion_11, f_9_of_place_8 * f_12_of_motion_10);
    let f_12_of_motion_15 = f_9_of_motion.mul_add(sin_delta, phi_dot_sin_phi * cos_delta)
        + f_9_of_motion_13 * sin_lam_plus_theta;
    let f_12_of_place_4 = v_Ho_2_of_w_c_lam_rr_2 * cos_phi;
    let f_12_of_motion_16 = f_12_of_motion_9
        .mul_add(f_12_of_place_4, S::int(2) * rR * phi_dot_cos_phi);
    let f_12_of_motion_17 = phi_dot_sin_phi
        * v_Ho_2_of_w_c_lam_rr_2.mul_add(f_12_of_motion_9, rr_phi_dot)
        + f_12_of_motion_12 * f_12_of_place_4;
    let f_12_of_place_5 = sin_psi * cos_lam_plus_theta;
    let f_12_of_motion_18 = f_9_of_place_8
        .mul_add(f_12_of_motion_4, f_9_of_motion_17 * f_12_of_motion_3);
    let f_12_of_motion_19 = v_Ho_3_3_of_place + f_12_of_motion_18;
    let f_12_of_motion_20 = (-f_9_of_theta_dot_2)
        .mul_add(sin_psi, psi_dot_cos_psi * cos_lam_plus_theta);
    let phi_dot_f_9_of_place_2 = phi_dot * f_9_of_place_2;
    let f_12_of_motion_21 = (-f_9_of_place_7)
        .mul_add(f_12_of_motion_3, v_FC_2_of_c_lam_rf * minus_f_12_of_motion_2);
    let f_12_of_motion_22 = v_Ho_3_of_place + f_12_of_motion_21;
    // Values.
    let f_1 = -psi_dot * p_v_N_in_Y_2.mul_add(cos_psi, p_v_RC_1 * sin_psi)
        + p_v_RC_1_2 * cos_psi - p_v_N_in_Y_2_2 * sin_psi + F_mp_N_1 * mp_N_1_of_mr_mb_mh_mf;
    let f_2 = psi_dot * (-p_v_N_in_Y_2).mul_add(sin_psi, p_v_RC_1 * cos_psi)
        + p_v_RC_1_2 * sin_psi + p_v_N_in_Y_2_2 * cos_psi - F_mp_N_2 * mp_N_1_of_mr_mb_mh_mf;
    let f_3 = sin_psi
        * (y_dot.mul_add(p_v_N_in_Y_2, x_dot * p_v_RC_1) - F_x_N_in_Y_1 * mp_N_1
            + F_x_N_in_Y_2 * mp_N_2)
        + cos_psi
            * ((-y_dot).mul_add(p_v_RC_1, x_dot * p_v_N_in_Y_2) + F_x_N_in_Y_2 * mp_N_1
                + F_x_N_in_Y_1 * mp_N_2)
        + phi_dot * (-p_w_Y_in_L_2).mul_add(cos_phi, p_w_Y_in_L_3 * sin_phi)
        + p_w_Y_in_L_3_2 * cos_phi - p_w_Y_in_L_2_2 * sin_phi;
    let f_4 = p_w_L_in_B_3_2 * sin_theta - rR * p_v_RC_2_2 + p_w_L_in_B_1_2 * cos_theta
        + sin_phi
            * ((-psi_dot).mul_add(p_w_Y_in_L_3, v_N_in_Y_2 * p_v_RC_2)
                + F_x_Y_in_L_2 * x_N_in_Y_2 - g * F_x_Y_in_L_3)
        + cos_phi
            * ((-g).mul_add(F_x_Y_in_L_2_2, v_N_in_Y_2 * p_v_Y_in_L_3)
                + psi_dot * p_w_Y_in_L_2 + F_x_F_3_2 * x_N_in_Y_2)
        - theta_dot * p_w_Y_in_L_3_of_place;
    let f_5 = sin_theta
        * ((-v_RC_1).mul_add(p_v_L_in_B_1, v_Y_in_L_3 * p_v_L_in_B_3)
            - w_Y_in_L_3 * p_w_L_in_B_3 - phi_dot * p_w_L_in_B_1 - F_x_F_1_2 * x_N_in_Y_1
            + F_x_F_3 * x_F_3 - x_Y_in_L_3 * F_x_L_in_B_3) - p_w_B_2_2
        + cos_theta
            * (v_Y_in_L_3.mul_add(p_v_L_in_B_1, v_RC_1 * p_v_L_in_B_3)
                + phi_dot * p_w_L_in_B_3 - w_Y_in_L_3 * p_w_L_in_B_1
                + F_x_F_3 * x_N_in_Y_1 + F_x_F_1_2 * x_F_3 - x_Y_in_L_3 * F_x_L_in_B_1);
    let f_6 = sin_delta
        * ((-v_Ho_2).mul_add(p_v_S_in_F_2, v_B_in_S_1 * p_v_S_in_F_1)
            - w_B_2 * p_w_S_in_F_2 - w_B_in_S_1 * p_w_S_in_F_1
            + x_S_in_F_2 * x_Y_in_L_2_2 + x_S_in_F_1 * x_F_1_2
            + x_Y_in_L_2 * x_S_in_F_2_2 - x_B_in_S_1 * x_F_1_3) - p_w_F_3_2
        + cos_delta
            * ((-w_B_2).mul_add(p_w_S_in_F_1, v_B_in_S_1 * p_v_S_in_F_2)
                + v_Ho_2 * p_v_S_in_F_1 + w_B_in_S_1 * p_w_S_in_F_2
                + x_S_in_F_1 * x_Y_in_L_2_2 - x_S_in_F_2 * x_F_1_2
                - x_B_in_S_1 * x_S_in_F_2_2 - x_Y_in_L_2 * x_F_1_3);
    let f_7 = -H_rear_wheel_2_2;
    let f_8 = -H_front_wheel_2_2;
    let f_9 = f_9_of_place_3
        * ((-f_9_of_place_3).mul_add(f_9_of_motion_11, f_9_of_motion_7 * f_9_of_place_6)
            - f_9_of_motion_12 * f_9_of_motion_14_doubled) - rr_phi_dot * phi_dot_cos_phi
        - f_9_of_motion_7 * f_9_of_place_8
        - v_Ho_2_of_w_c_lam_rr_2
            * f_9_of_theta_dot.mul_add(phi_dot_sin_phi_doubled, f_9_of_motion_3)
        + f_9_of_place_2
            * ((-f_9_of_place_2)
                .mul_add(f_9_of_motion_11, f_9_of_place_6 * f_9_of_motion_15)
                + f_9_of_motion_12 * f_9_of_motion_16_doubled) - f_9_of_motion_15 * f_9_of_place_11
        - f_9_of_motion_14_doubled * f_9_of_motion_17 + f_9_of_motion_16_doubled * f_9_of_motion_18;
    let f_10 = psi_dot_sin_psi * rr_thr_dot;
    let f_11 = -psi_dot_cos_psi * rr_thr_dot;
    let f_12 = f_12_of_motion_5 * (-f_12_of_place_2).mul_add(cos_delta, f_12_of_place * sin_psi)
        - rr_w_y_in_l_2 * psi_dot_sin_psi
        + f_12_of_motion_6
            * (delta_dot_sin_delta
                .mul_add(f_12_of_place_2, psi_dot_cos_psi * f_12_of_place)
                + f_12_of_motion_7 * sin_psi + f_12_of_motion_8 * cos_delta)
        + f_12_of_motion_13 * (-f_12_of_place_2).mul_add(sin_delta, f_12_of_place_3 * sin_psi)
        + f_12_of_motion_14
            * ((-f_12_of_motion_8)
                .mul_add(sin_delta, delta_dot_cos_delta * f_12_of_place_2)
                - psi_dot_cos_psi * f_12_of_place_3 - f_12_of_motion_15 * sin_psi)
        + psi_dot_cos_psi * f_12_of_motion_16 - f_12_of_motion_17 * sin_psi
        + f_12_of_motion_19 * f_12_of_place_5.mul_add(sin_phi, cos_psi * sin_lam_plus_theta)
        + f_12_of_motion_22
            * ((-psi_dot_sin_psi)
                .mul_add(sin_lam_plus_theta, theta_dot * f_12_of_place_2)
                + f_12_of_motion_20 * sin_phi + phi_dot_f_9_of_place_2 * sin_psi);
    let f_13 = rr_w_y_in_l_2 * psi_dot_cos_psi + psi_dot_sin_psi * f_12_of_motion_16
        + f_12_of_motion_17 * cos_psi
        - f_12_of_motion_5 * f_12_of_place_5.mul_add(cos_delta, f_12_of_place * cos_psi)
        - f_12_of_motion_13 * f_12_of_place_5.mul_add(sin_delta, f_12_of_place_3 * cos_psi)
        + f_12_of_motion_19 * (-f_12_of_place_2).mul_add(sin_phi, sin_psi * sin_lam_plus_theta)
        + f_12_of_motion_14
            * ((-psi_dot_sin_psi).mul_add(f_12_of_place_3, f_12_of_motion_15 * cos_psi)
                + delta_dot_cos_delta * f_12_of_place_5 + f_12_of_motion_20 * sin_delta)
        + f_12_of_motion_6
            * ((-f_12_of_motion_7).mul_add(cos_psi, psi_dot_sin_psi * f_12_of_place)
                + delta_dot_sin_delta * f_12_of_place_5 - f_12_of_motion_20 * cos_delta)
        + f_12_of_motion_22
            * (f_12_of_motion_8.mul_add(sin_phi, psi_dot_cos_psi * sin_lam_plus_theta)
                + theta_dot * f_12_of_place_5 - phi_dot_f_9_of_place_2 * cos_psi);
    [f_1, f_2, f_3, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13]
}

/// The accelerations (x'', y'', psi'', phi'', theta'', delta'', thR'', thF''), solved for when this code was generated.
///
/// 2676 operations, 6 sines and cosines, 2 other functions.
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
    let delta_dot_cos_delta = delta_dot * cos_delta;
    let delta_dot_sin_delta = delta_dot * sin_delta;
    let w_S_in_F_1_2 = (-w_B_in_S_1_2).mul_add(cos_delta, w_Y_in_L_2_2 * sin_delta)
        + w_B_2 * delta_dot_cos_delta + w_B_in_S_1 * delta_dot_sin_delta;
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_Y_in_L_2_2 * cos_delta)
        + w_B_in_S_1 * delta_dot_cos_delta - w_B_2 * delta_dot_sin_delta;
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
        + v_Ho_2 * delta_dot_cos_delta + v_B_in_S_1 * delta_dot_sin_delta;
    let v_S_in_F_2_2 = (-v_B_in_S_1_2).mul_add(sin_delta, v_Ho_2_3 * cos_delta)
        + v_B_in_S_1 * delta_dot_cos_delta - v_Ho_2 * delta_dot_sin_delta;
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
        + p_v_S_in_F_2 * delta_dot_cos_delta + p_v_S_in_F_1 * delta_dot_sin_delta;
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
        + p_w_S_in_F_2 * delta_dot_cos_delta - p_w_S_in_F_1 * delta_dot_sin_delta;
    let p_w_B_2_2 = xB.mul_add(p_v_Bo_3_2, H_frame_2_2) + p_w_S_in_F_2_2 * cos_delta
        + p_w_S_in_F_1_2 * sin_delta + p_v_Bo_1_2 * rr_plus_zb
        + p_v_Ho_3_4 * v_Ho_2_of_w_c_lam_rr_2 - p_w_S_in_F_1 * delta_dot_cos_delta
        - p_w_S_in_F_2 * delta_dot_sin_delta;
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
    let ratio_psi_u1_of_place = cos_phi * sin_lam_plus_theta;
    let ratio_psi_u1_of_place_2 = ratio_psi_u1_of_place * sin_delta;
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let ratio_psi_u1_of_place_3 = S::int(2) * sin_phi_cos_delta;
    let ratio_psi_u1_of_place_4 = ratio_psi_u1_of_place_2 + ratio_psi_u1_of_place_3;
    let ratio_psi_u1_of_place_5 = S::int(1)
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_4);
    let ratio_psi_u1_of_place_6 = cos_phi * sin_lam_plus_theta * sin_delta;
    let ratio_psi_u1_of_place_7 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), ratio_psi_u1_of_place_6))
        .sqrt();
    let ratio_psi_u1_of_place_8 = ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_7;
    let ratio_psi_u1_of_place_9 = ratio_psi_u1_of_place_8 * sin_delta;
    let sin_lam_cos_delta = sin_lam * cos_delta;
    let ratio_psi_u1_of_place_10 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    let ratio_psi_u1_of_place_11 = rF
        * ratio_psi_u1_of_place_4.mul_add(ratio_psi_u1_of_place_9, -sin_lam_cos_delta)
        + ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = v_FC_1_of_w_lam_rr_rf * sin_lam_plus_theta;
    let ratio_psi_u1_of_place_13 = (-ratio_psi_u1_of_place_11)
        .mul_add(cos_lam_plus_theta, ratio_psi_u1_of_place_12);
    let ratio_psi_u1_of_place_14 = cos_phi * cos_lam_plus_theta;
    let ratio_psi_u1_of_place_15 = rF * ratio_psi_u1_of_place_8;
    let ratio_psi_u1_of_place_16 = ratio_psi_u1_of_place_15
        * sin_delta.mul_add(sin_delta, -S::int(1));
    let ratio_psi_u1_of_place_17 = (-ratio_psi_u1_of_place_14)
        .mul_add(
            ratio_psi_u1_of_place_16,
            ratio_psi_u1_of_place_13 * sin_lam_plus_theta,
        );
    let cos_phi_inv = S::int(1) / cos_phi;
    let ratio_psi_u1_of_place_18 = sin_lam.mul_add(sin_phi, -ratio_psi_u1_of_place_9);
    let ratio_psi_u1_of_place_19 = cos_lam_plus_theta * sin_delta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let c_sin_delta_sin_phi = c * sin_delta_sin_phi;
    let ratio_psi_u1_of_place_20 = ratio_psi_u1_of_place_17 * cos_phi - w_sin_lam * cos_phi_inv
        + rF
            * (-ratio_psi_u1_of_place_18)
                .mul_add(ratio_psi_u1_of_place_19, cos_phi_inv * cos_lam)
        + cos_lam * (-rR).mul_add(cos_phi_inv, c_sin_delta_sin_phi * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_21 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * rr_minus_rf.mul_add(sin_lam_plus_theta, w_plus_c * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_22 = ratio_psi_u1_of_place_21
        .mul_add(cos_delta, v_FC_2_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_23 = ratio_psi_u1_of_place_22
        .mul_add(sin_phi, ratio_psi_u1_of_place_20 * sin_delta);
    let cos_delta_doubled = S::int(2) * cos_delta;
    let ratio_psi_u1_of_place_24 = (-ratio_psi_u1_of_place)
        .mul_add(cos_delta_doubled, sin_delta_sin_phi);
    let ratio_psi_u1_of_place_25 = sin_phi_cos_delta * cos_delta_doubled;
    let ratio_psi_u1_of_place_26 = ratio_psi_u1_of_place_24
        .mul_add(sin_delta, -ratio_psi_u1_of_place_25);
    let cos_lam_plus_theta_sq = cos_lam_plus_theta * cos_lam_plus_theta;
    let cos_delta_sq = cos_delta * cos_delta;
    let sin_lam_plus_theta_sq = sin_lam_plus_theta * sin_lam_plus_theta;
    let ratio_psi_u1_of_place_27 = cos_delta_sq
        .mul_add(sin_lam_plus_theta_sq, cos_lam_plus_theta_sq);
    let cos_phi_sq = cos_phi * cos_phi;
    let ratio_psi_u1_of_place_28 = ratio_psi_u1_of_place_27
        .mul_add(cos_phi_sq, ratio_psi_u1_of_place_26 * sin_phi);
    let ratio_psi_u1_of_place_29 = ratio_psi_u1_of_place * cos_delta_sq;
    let ratio_psi_u1_of_place_30 = sin_phi_cos_delta
        .mul_add(ratio_psi_u1_of_place_29, ratio_psi_u1_of_place_28 * sin_delta);
    let ratio_psi_u1_of_place_31 = sin_phi_cos_delta * ratio_psi_u1_of_place_14;
    let ratio_psi_u1_of_place_32 = ratio_psi_u1_of_place_31
        .mul_add(cos_lam_plus_theta, ratio_psi_u1_of_place_30 * sin_lam_plus_theta);
    let sin_delta_sin_phi_sq = sin_delta_sin_phi * sin_delta_sin_phi;
    let ratio_psi_u1_of_place_33 = ratio_psi_u1_of_place_5
        * sin_phi_cos_delta
            .mul_add(sin_delta_sin_phi_sq, ratio_psi_u1_of_place_32 * cos_phi);
    let ratio_psi_u1_of_place_34 = ratio_psi_u1_of_place_3 + ratio_psi_u1_of_place_33;
    let ratio_psi_u1_of_delta = S::int(1) - cos_delta_sq;
    let ratio_psi_u1_of_delta_2 = -ratio_psi_u1_of_delta;
    let ratio_psi_u1_of_delta_3 = S::int(2) * ratio_psi_u1_of_delta_2;
    let ratio_psi_u1_of_place_35 = ratio_psi_u1_of_place_8
        * (-ratio_psi_u1_of_place)
            .mul_add(ratio_psi_u1_of_delta_3, ratio_psi_u1_of_place_34 * sin_delta);
    let ratio_psi_u1_of_place_36 = ratio_psi_u1_of_place_10
        + rF * (ratio_psi_u1_of_place_35 - sin_lam_cos_delta);
    let ratio_psi_u1_of_place_37 = S::int(1)
        / (-ratio_psi_u1_of_place_36)
            .mul_add(cos_lam_plus_theta, ratio_psi_u1_of_place_12);
    let ratio_psi_u1_of_place_38 = ratio_psi_u1_of_place_23 * ratio_psi_u1_of_place_37;
    let ratio_psi_u1_of_place_39 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let ratio_psi_u1_of_place_40 = ratio_psi_u1_of_place * cos_delta;
    let ratio_psi_u1_of_place_41 = sin_delta_sin_phi - ratio_psi_u1_of_place_40;
    let ratio_psi_u1_of_place_42 = ratio_psi_u1_of_place_2 + sin_phi_cos_delta;
    let ratio_psi_u1_of_place_43 = ratio_psi_u1_of_place_42 * ratio_psi_u1_of_place_42;
    let ratio_psi_u1_of_place_44 = S::int(1) / (ratio_psi_u1_of_place_43 - S::int(1));
    let ratio_psi_u1_of_place_45 = rF * ratio_psi_u1_of_place_44
        * (S::int(1) - (ratio_psi_u1_of_place_6 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_psi_u1_of_place_46 = (-ratio_psi_u1_of_place_41)
        .mul_add(ratio_psi_u1_of_place_45, v_FC_2_of_c_lam_rf);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_psi_u1_of_place_47 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
    let ratio_psi_u1_of_place_48 = ratio_psi_u1_of_place_44 * ratio_psi_u1_of_place_45;
    let ratio_psi_u1_of_place_49 = ratio_psi_u1_of_place_42 * ratio_psi_u1_of_place_48;
    let ratio_psi_u1_of_place_50 = ratio_psi_u1_of_place_41 * ratio_psi_u1_of_place_49;
    let ratio_psi_u1_of_place_51 = ratio_psi_u1_of_place_47
        .mul_add(
            ratio_psi_u1_of_place_50,
            ratio_psi_u1_of_place_39 * ratio_psi_u1_of_place_45,
        );
    let ratio_psi_u1_of_place_52 = sin_phi * cos_lam_plus_theta;
    let ratio_psi_u1_of_place_53 = ratio_psi_u1_of_place_14 * ratio_psi_u1_of_place_49;
    let ratio_psi_u1_of_place_54 = (-ratio_psi_u1_of_place_47)
        .mul_add(
            ratio_psi_u1_of_place_53,
            ratio_psi_u1_of_place_45 * ratio_psi_u1_of_place_52,
        );
    let ratio_psi_u1_of_place_55 = ratio_psi_u1_of_place_14 * ratio_psi_u1_of_place_45;
    let ratio_psi_u1_of_place_56 = v_FC_1_of_w_lam_rr_rf - ratio_psi_u1_of_place_55;
    let v_RC_1_3 = rR * sin_phi;
    let ratio_psi_u1_of_place_57 = sin_phi * sin_lam_plus_theta;
    let ratio_psi_u1_of_place_58 = ratio_psi_u1_of_place_39
        .mul_add(ratio_psi_u1_of_place_46, v_RC_1_3)
        - ratio_psi_u1_of_place_41 * ratio_psi_u1_of_place_51
        + ratio_psi_u1_of_place_14 * ratio_psi_u1_of_place_54
        - ratio_psi_u1_of_place_52 * ratio_psi_u1_of_place_56
        + v_Ho_2_of_w_c_lam_rr_2 * ratio_psi_u1_of_place_57;
    let ratio_psi_u1_of_place_59 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_60 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_59, ratio_psi_u1_of_place_22 * cos_phi);
    let ratio_psi_u1_of_place_61 = ratio_psi_u1_of_place_58 * ratio_psi_u1_of_place_60;
    let ratio_psi_u1_of_place_62 = ratio_psi_u1_of_place_15 * cos_phi;
    let ratio_psi_u1_of_place_63 = (-v_FC_1_of_w_lam_rr_rf)
        .mul_add(cos_lam_plus_theta, rR) - ratio_psi_u1_of_place_11 * sin_lam_plus_theta
        + ratio_psi_u1_of_place_62;
    let ratio_psi_u1_of_place_64 = ratio_psi_u1_of_place_8 * sin_delta_sin_phi;
    let ratio_psi_u1_of_place_65 = c_cos_lam + rF * (ratio_psi_u1_of_place_64 - sin_lam);
    let ratio_psi_u1_of_place_66 = sin_delta_sin_phi
        .mul_add(ratio_psi_u1_of_place_65, ratio_psi_u1_of_place_63 * cos_phi);
    let ratio_psi_u1_of_place_67 = ratio_psi_u1_of_place_57
        .mul_add(cos_psi, sin_psi * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_68 = (-cos_delta_cos_phi)
        .mul_add(cos_psi, ratio_psi_u1_of_place_67 * sin_delta);
    let ratio_psi_u1_of_place_69 = (-ratio_psi_u1_of_place_57)
        .mul_add(sin_psi, cos_psi * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_70 = ratio_psi_u1_of_place_69
        .mul_add(sin_delta, cos_delta_cos_phi * sin_psi);
    let ratio_psi_u1_of_place_71 = (-ratio_psi_u1_of_place_70)
        .mul_add(sin_psi, ratio_psi_u1_of_place_68 * cos_psi);
    let ratio_psi_u1_of_place_72 = ratio_psi_u1_of_place_60 * ratio_psi_u1_of_place_71;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_66)
        .mul_add(
            ratio_psi_u1_of_place_72,
            ratio_psi_u1_of_place_38 * ratio_psi_u1_of_place_61,
        );
    let ratio_psi_u2_of_place = (-ratio_psi_u1_of_place_47)
        .mul_add(sin_psi, ratio_psi_u1_of_place_19 * cos_psi);
    let ratio_psi_u2_of_place_2 = ratio_psi_u1_of_place_47
        .mul_add(cos_psi, ratio_psi_u1_of_place_19 * sin_psi);
    let ratio_psi_u2_of_place_3 = ratio_psi_u1_of_place_68
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_70 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u2_of_place_4 = ratio_psi_u1_of_place_41
        .mul_add(
            ratio_psi_u1_of_place_50,
            ratio_psi_u1_of_place_42 * ratio_psi_u1_of_place_45,
        );
    let ratio_psi_u2_of_place_5 = ratio_psi_u1_of_place_14 * ratio_psi_u1_of_place_14;
    let ratio_psi_u2_of_place_6 = ratio_psi_u1_of_place_42 * ratio_psi_u1_of_place_46;
    let ratio_psi_u2_of_place_7 = (-ratio_psi_u1_of_place_41)
        .mul_add(ratio_psi_u2_of_place_4, ratio_psi_u2_of_place_6)
        - ratio_psi_u1_of_place_50 * ratio_psi_u2_of_place_5;
    let ratio_psi_u2_of_place_8 = ratio_psi_u1_of_place_60 * ratio_psi_u2_of_place_7;
    let ratio_psi_u2 = ratio_psi_u1_of_place_38
        .mul_add(
            ratio_psi_u2_of_place_8,
            ratio_psi_u1_of_place_46 * ratio_psi_u1_of_place_60 * ratio_psi_u2_of_place_3,
        );
    let ratio_psi_u3_of_place = rR * ratio_psi_u1_of_place_60;
    let ratio_psi_u3 = ratio_psi_u1_of_place_19 * ratio_psi_u3_of_place;
    let ratio_theta_u1_of_place = ratio_psi_u1_of_place_14 * sin_delta;
    let ratio_theta_u1_of_place_2 = ratio_psi_u1_of_place_50
        .mul_add(ratio_theta_u1_of_place, ratio_psi_u1_of_place_55 * cos_delta);
    let ratio_theta_u1_of_place_3 = ratio_psi_u1_of_place_53
        .mul_add(
            ratio_theta_u1_of_place,
            ratio_psi_u1_of_place * ratio_psi_u1_of_place_45,
        );
    let ratio_theta_u1_of_place_4 = ratio_psi_u1_of_place_46
        .mul_add(cos_delta, v_Ho_2_of_w_c_lam_rr_2);
    let ratio_theta_u1_of_place_5 = ratio_theta_u1_of_place_3 - ratio_theta_u1_of_place_4;
    let ratio_theta_u1_of_place_6 = S::int(1)
        / ((-ratio_psi_u1_of_place_41)
            .mul_add(
                ratio_theta_u1_of_place_2,
                ratio_psi_u1_of_place * ratio_psi_u1_of_place_56,
            ) - ratio_psi_u1_of_place_14 * ratio_theta_u1_of_place_5);
    let ratio_theta_u1 = ratio_psi_u1_of_place_58 * ratio_theta_u1_of_place_6;
    let ratio_theta_u2 = ratio_psi_u2_of_place_7 * ratio_theta_u1_of_place_6;
    let ratio_thF_u1_of_place = cos_lam_plus_theta * cos_delta;
    let ratio_thF_u1_of_place_2 = (-ratio_psi_u1_of_place_39)
        .mul_add(sin_psi, ratio_thF_u1_of_place * cos_psi);
    let ratio_thF_u1_of_place_3 = ratio_psi_u1_of_place_42 * ratio_psi_u1_of_place_56;
    let ratio_thF_u1_of_place_4 = (-v_FC_1_of_w_lam_rr_rf)
        .mul_add(
            ratio_psi_u1_of_place_41,
            v_FC_2_of_c_lam_rf * ratio_psi_u1_of_place_14,
        );
    let ratio_thF_u1_of_place_5 = ratio_psi_u1_of_place_52
        .mul_add(sin_psi, cos_psi * sin_lam_plus_theta);
    let ratio_thF_u1_of_place_6 = v_Ho_2_of_w_c_lam_rr_2 * sin_phi;
    let ratio_thF_u1_of_place_7 = ratio_psi_u2_of_place_6 + ratio_thF_u1_of_place_6;
    let ratio_thF_u1_of_place_8 = v_Ho_2_of_w_c_lam_rr_2 * ratio_psi_u1_of_place_14 * cos_phi;
    let ratio_thF_u1_of_place_9 = (-ratio_thF_u1_of_place_2)
        .mul_add(ratio_thF_u1_of_place_3, v_RC_1_3 * cos_psi)
        + ratio_psi_u2_of_place * ratio_thF_u1_of_place_4
        + ratio_thF_u1_of_place_5 * ratio_thF_u1_of_place_7 + ratio_thF_u1_of_place_8 * sin_psi;
    let ratio_thF_u1_of_place_10 = -ratio_psi_u1_of_place_56 * cos_delta;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place
        .mul_add(sin_psi, ratio_psi_u1_of_place_39 * cos_psi);
    let ratio_thF_u1_of_place_12 = ratio_psi_u1_of_place_56 * sin_delta;
    let ratio_thF_u1_of_place_13 = (-ratio_psi_u1_of_place_52)
        .mul_add(cos_psi, sin_psi * sin_lam_plus_theta);
    let ratio_thF_u1_of_place_14 = (-ratio_psi_u2_of_place_2)
        .mul_add(
            ratio_thF_u1_of_place_12,
            ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_11,
        ) + ratio_thF_u1_of_place_13 * ratio_theta_u1_of_place_4;
    let ratio_thF_u1_of_place_15 = ratio_psi_u2_of_place_2
        .mul_add(ratio_thF_u1_of_place_4, v_RC_1_3 * sin_psi) - ratio_thF_u1_of_place_8 * cos_psi
        - ratio_thF_u1_of_place_3 * ratio_thF_u1_of_place_11
        + ratio_thF_u1_of_place_7 * ratio_thF_u1_of_place_13;
    let ratio_thF_u1_of_place_16 = (-ratio_psi_u2_of_place)
        .mul_add(
            ratio_thF_u1_of_place_12,
            ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_10,
        ) + ratio_thF_u1_of_place_5 * ratio_theta_u1_of_place_4;
    let ratio_thF_u1_of_place_17 = (-ratio_thF_u1_of_place_15)
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_thF_u1_of_place_9 * ratio_thF_u1_of_place_14,
        );
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_18 = rf_inv * ratio_psi_u1_of_place_7;
    let ratio_thF_u1_of_place_19 = ratio_psi_u1_of_place_60 * ratio_thF_u1_of_place_18;
    let ratio_thF_u1_of_place_20 = ratio_thF_u1_of_place_17 * ratio_thF_u1_of_place_19;
    let ratio_thF_u1_of_place_21 = ratio_thF_u1_of_place_19
        * ratio_thF_u1_of_place_15.mul_add(sin_psi, ratio_thF_u1_of_place_9 * cos_psi);
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_66)
        .mul_add(ratio_thF_u1_of_place_21, ratio_theta_u1 * ratio_thF_u1_of_place_20);
    let ratio_thF_u2_of_place = (-ratio_psi_u2_of_place_2)
        .mul_add(
            ratio_thF_u1_of_place_9,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_15,
        );
    let ratio_thF_u2_of_place_2 = ratio_psi_u1_of_place_46 * ratio_thF_u2_of_place;
    let ratio_thF_u2 = (-ratio_thF_u1_of_place_19)
        .mul_add(ratio_thF_u2_of_place_2, ratio_theta_u2 * ratio_thF_u1_of_place_20);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place = (-ratio_psi_u1_of_place_9)
        .mul_add(ratio_psi_u1_of_place_42, sin_lam_cos_delta) - ratio_psi_u1_of_place_10 * rf_inv;
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_place)
        .mul_add(cos_lam_plus_theta, ratio_thF_u3_of_w_lam_rr_rf * sin_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = ratio_psi_u3_of_place * ratio_psi_u1_of_place_7;
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
    let v_L_in_B_1_5 = v_RC_1_3 * cos_theta;
    let v_L_in_B_3_5 = v_RC_1_3 * sin_theta;
    let v_Bo_1_3 = rr_plus_zb.mul_add(sin_phi, -v_L_in_B_1_5);
    let v_Bo_2_3 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let v_Bo_3_3 = xB.mul_add(sin_phi, v_L_in_B_3_5);
    let v_B_in_S_1_5 = (-v_L_in_B_1_5).mul_add(cos_lam, v_L_in_B_3_5 * sin_lam);
    let v_B_in_S_3_5 = v_L_in_B_3_5.mul_add(cos_lam, v_L_in_B_1_5 * sin_lam);
    let v_Ho_2_5 = w_B_in_S_3_3 * v_Ho_2_of_w_c_lam_rr_2;
    let v_Ho_3_5 = v_B_in_S_3_5 + ratio_thF_u1_of_place_6;
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
    let w_B_in_S_1_4 = (-cos_lam).mul_add(cos_theta, sin_lam * sin_theta);
    let w_B_in_S_3_4 = sin_lam.mul_add(cos_theta, cos_lam * sin_theta);
    let w_S_in_F_1_4 = w_B_in_S_1_4 * cos_delta;
    let w_S_in_F_2_4 = w_B_in_S_1_4 * sin_delta;
    let v_Bo_2_4 = xB.mul_add(sin_theta, rR) - rr_plus_zb * cos_theta;
    let v_Ho_2_7 = w_B_in_S_3_4.mul_add(v_Ho_2_of_w_c_lam_rr_2, rR);
    let v_S_in_F_1_6 = v_Ho_2_7 * sin_delta;
    let v_S_in_F_2_6 = v_Ho_2_7 * cos_delta;
    let v_Ho_1_4 = w_S_in_F_2_4.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_1_6);
    let v_Ho_2_8 = w_B_in_S_3_4.mul_add(minus_v_ho_2_2_of_place, -v_S_in_F_2_6)
        - w_S_in_F_1_4 * v_Ho_1_of_lam_rr_xh_zh;
    let v_Ho_3_7 = w_S_in_F_2_4 * minus_v_ho_2_2_of_place;
    let v_FC_1_4 = w_S_in_F_2_4.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_1_6);
    let v_FC_2_4 = w_S_in_F_1_4.mul_add(v_FC_1_of_w_lam_rr_rf, v_S_in_F_2_6)
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
    let p_v_Ho_2_12 = p_v_S_in_F_1_6.mul_add(sin_delta, p_v_S_in_F_2_6 * cos_delta);
    let p_v_B_in_S_1_6 = (-p_v_S_in_F_1_6)
        .mul_add(cos_delta, p_v_S_in_F_2_6 * sin_delta);
    let p_v_Bo_2_6 = mB * v_Bo_2_4;
    let p_v_L_in_B_3_6 = (-p_v_B_in_S_1_6).mul_add(sin_lam, p_v_Ho_3_12 * cos_lam);
    let p_v_L_in_B_1_6 = p_v_B_in_S_1_6.mul_add(cos_lam, p_v_Ho_3_12 * sin_lam);
    let p_v_RC_2_6 = rR.mul_add(mR, p_v_Ho_2_12) + p_v_Bo_2_6;
    let p_v_RC_1_6 = p_v_L_in_B_1_6.mul_add(cos_theta, p_v_L_in_B_3_6 * sin_theta);
    let p_v_Y_in_L_3_6 = (-p_v_L_in_B_1_6)
        .mul_add(sin_theta, p_v_L_in_B_3_6 * cos_theta);
    let p_v_N_in_Y_2_6 = p_v_Y_in_L_3_6.mul_add(sin_phi, p_v_RC_2_6 * cos_phi);
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
    let w_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
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
    let p_w_S_in_F_1_4 = (-H_fork_1_4).mul_add(cos_lam, H_fork_3_4 * sin_lam)
        + H_front_wheel_1_4 - p_v_Ho_2_11 * v_Ho_1_of_lam_rr_xh_zh
        + p_v_FC_2_6 * v_FC_1_of_w_lam_rr_rf;
    let p_w_B_in_S_3_4 = p_v_Ho_2_12.mul_add(v_Ho_2_of_w_c_lam_rr_2, p_w_F_3_4);
    let p_w_B_in_S_1_4 = p_w_S_in_F_1_4.mul_add(cos_delta, p_w_S_in_F_2_4 * sin_delta);
    let p_w_B_2_4 = (-p_w_S_in_F_1_4).mul_add(sin_delta, p_w_S_in_F_2_4 * cos_delta)
        + p_v_Ho_3_12 * v_Ho_2_of_w_c_lam_rr_2;
    let p_w_L_in_B_3_4 = xB.mul_add(p_v_Bo_2_6, H_frame_3_4) + p_w_B_in_S_3_4 * cos_lam
        + p_w_B_in_S_1_4 * sin_lam;
    let p_w_L_in_B_1_4 = p_w_B_in_S_3_4.mul_add(sin_lam, H_frame_1_4)
        - p_w_B_in_S_1_4 * cos_lam - p_v_Bo_2_6 * rr_plus_zb;
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
    let ratio_psi_u1_2_of_motion = delta_dot
        .mul_add(ratio_theta_u2, phi_dot * ratio_theta_u1);
    let ratio_psi_u1_2_of_motion_2 = (-ratio_psi_u1_of_place_14)
        .mul_add(ratio_psi_u1_2_of_motion, phi_dot_sin_phi * sin_lam_plus_theta);
    let ratio_psi_u1_2_of_motion_3 = (-delta_dot_cos_delta)
        .mul_add(ratio_psi_u1_of_place, ratio_psi_u1_2_of_motion_2 * sin_delta);
    let ratio_psi_u1_2_of_phi_dot = phi_dot_cos_phi * cos_delta;
    let ratio_psi_u1_2_of_delta_dot = delta_dot_sin_delta * sin_phi;
    let ratio_psi_u1_2_of_motion_4 = ratio_psi_u1_2_of_delta_dot - ratio_psi_u1_2_of_phi_dot;
    let ratio_psi_u1_2_of_motion_5 = S::int(2) * ratio_psi_u1_2_of_motion_4;
    let ratio_psi_u1_2_of_motion_6 = -ratio_psi_u1_2_of_motion_3 - ratio_psi_u1_2_of_motion_5;
    let sin_phi_doubled = S::int(2) * sin_phi;
    let ratio_psi_u1_2_of_delta_dot_2 = delta_dot_cos_delta * sin_delta_sin_phi;
    let ratio_psi_u1_2_of_delta_dot_3 = sin_phi_doubled * ratio_psi_u1_2_of_delta_dot_2;
    let ratio_psi_u1_2_of_motion_7 = ratio_psi_u1_of_place_5
        * ((-ratio_psi_u1_of_place_4)
            .mul_add(
                ratio_psi_u1_2_of_motion_3,
                phi_dot_cos_phi * ratio_psi_u1_of_place_25,
            ) + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_motion_6
            - ratio_psi_u1_2_of_delta_dot_3);
    let ratio_psi_u1_2_of_delta_dot_4 = S::int(2) * delta_dot_cos_delta;
    let ratio_psi_u1_2_of_motion_8 = ratio_psi_u1_of_place_8
        * ratio_psi_u1_2_of_motion_7.mul_add(sin_delta, -ratio_psi_u1_2_of_delta_dot_4);
    let ratio_psi_u1_2_of_delta_dot_5 = S::int(2) * delta_dot_sin_delta;
    let ratio_psi_u1_2_of_delta_dot_6 = ratio_psi_u1_2_of_delta_dot_5 * sin_lam;
    let ratio_psi_u1_2_of_place = S::int(2) * ratio_psi_u1_of_place_9;
    let ratio_psi_u1_2_of_delta_dot_7 = c_cos_lam * ratio_psi_u1_2_of_delta_dot_5;
    let ratio_psi_u1_2_of_motion_9 = rF
        * (ratio_psi_u1_of_place_4
            .mul_add(ratio_psi_u1_2_of_motion_8, -ratio_psi_u1_2_of_delta_dot_6)
            - ratio_psi_u1_2_of_motion_6 * ratio_psi_u1_2_of_place) + ratio_psi_u1_2_of_delta_dot_7;
    let phi_dot_sin_phi_doubled = S::int(2) * phi_dot_sin_phi;
    let ratio_psi_u1_2_of_motion_10 = ratio_psi_u1_2_of_motion * sin_lam_plus_theta;
    let ratio_psi_u1_2_of_motion_11 = S::int(2) * ratio_psi_u1_2_of_motion_10;
    let ratio_psi_u1_2_of_motion_12 = ratio_psi_u1_2_of_motion * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_motion_13 = S::int(2) * ratio_psi_u1_2_of_motion_12;
    let ratio_psi_u1_2_of_motion_14 = delta_dot_cos_delta
        .mul_add(sin_phi, phi_dot_cos_phi * sin_delta);
    let ratio_psi_u1_2_of_place_2 = S::int(2) * ratio_psi_u1_of_place_8;
    let ratio_psi_u1_2_of_motion_15 = cos_phi
        * ((-ratio_psi_u1_of_place_62)
            .mul_add(
                ratio_psi_u1_2_of_motion_7,
                ratio_psi_u1_2_of_motion_9 * sin_lam_plus_theta,
            ) - ratio_psi_u1_of_place_15 * phi_dot_sin_phi_doubled
            + v_FC_1_of_w_lam_rr_rf * ratio_psi_u1_2_of_motion_11
            - ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_motion_13)
        - ratio_psi_u1_of_place_63 * phi_dot_sin_phi_doubled
        + S::int(2) * ratio_psi_u1_of_place_65 * ratio_psi_u1_2_of_motion_14
        + rF * sin_delta_sin_phi
            * (-ratio_psi_u1_of_place_64)
                .mul_add(
                    ratio_psi_u1_2_of_motion_7,
                    ratio_psi_u1_2_of_motion_14 * ratio_psi_u1_2_of_place_2,
                );
    let ratio_psi_u1_2_of_delta_dot_8 = delta_dot_sin_delta * ratio_psi_u1_of_place_14;
    let ratio_psi_u1_2_of_delta_dot_9 = S::int(4) * delta_dot_cos_delta;
    let ratio_psi_u1_2_of_motion_16 = v_FC_1_of_w_lam_rr_rf * ratio_psi_u1_2_of_motion_13;
    let ratio_psi_u1_2_of_motion_17 = rR * ratio_psi_u1_2_of_motion_10;
    let ratio_psi_u1_2_of_motion_18 = delta_dot_sin_delta * ratio_psi_u1_of_place_21
        + v_FC_2_of_c_lam_rf * ratio_psi_u1_2_of_motion_10
        - cos_delta
            * (cos_lam
                * (-w_plus_c)
                    .mul_add(
                        ratio_psi_u1_2_of_motion_10,
                        rr_minus_rf * ratio_psi_u1_2_of_motion_12,
                    )
                + sin_lam
                    * w
                        .mul_add(
                            ratio_psi_u1_2_of_motion_12, ratio_psi_u1_2_of_motion_17,
                        ));
    let ratio_psi_u1_2_of_motion_19 = ratio_psi_u1_of_place_59
        .mul_add(ratio_psi_u1_2_of_motion_14, phi_dot_sin_phi * ratio_psi_u1_of_place_22)
        + sin_delta_sin_phi * ratio_psi_u1_2_of_motion_17 + ratio_psi_u1_2_of_motion_18 * cos_phi;
    let ratio_psi_u1_2_of_place_3 = S::int(2) * ratio_psi_u1_of_place_60;
    let ratio_psi_u1_2_of_motion_20 = ratio_psi_u1_2_of_motion_19 * ratio_psi_u1_2_of_place_3;
    let ratio_psi_u1_2_of_motion_21 = ratio_psi_u1_2_of_motion_10
        .mul_add(cos_phi, phi_dot_sin_phi * cos_lam_plus_theta);
    let ratio_psi_u1_2_of_motion_22 = S::int(2) * ratio_psi_u1_2_of_motion_21;
    let ratio_psi_u1_2_of_motion_23 = (-delta_dot_cos_delta)
        .mul_add(cos_lam_plus_theta, ratio_psi_u1_2_of_motion_10 * sin_delta);
    let phi_dot_cos_phi_doubled = S::int(2) * phi_dot_cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let ratio_psi_u1_2_of_phi_dot_2 = phi_dot_sin_phi_doubled * cos_phi_inv_sq;
    let ratio_psi_u1_2_of_motion_24 = ratio_psi_u1_of_place_20
        * ratio_psi_u1_2_of_delta_dot_4 - sin_phi_doubled * ratio_psi_u1_2_of_motion_18
        + ratio_psi_u1_of_place_22 * phi_dot_cos_phi_doubled
        + sin_delta
            * (cos_phi
                * (ratio_psi_u1_of_place_13 * ratio_psi_u1_2_of_motion_13
                    - ratio_psi_u1_of_place_15 * ratio_theta_u1_of_place
                        * ratio_psi_u1_2_of_delta_dot_9
                    + sin_lam_plus_theta
                        * (ratio_psi_u1_of_place_11
                            .mul_add(
                                ratio_psi_u1_2_of_motion_11,
                                ratio_psi_u1_2_of_motion_9 * cos_lam_plus_theta,
                            ) + ratio_psi_u1_2_of_motion_16)
                    + ratio_psi_u1_of_place_16
                        * ratio_psi_u1_of_place_14
                            .mul_add(
                                ratio_psi_u1_2_of_motion_7, ratio_psi_u1_2_of_motion_22,
                            )) - ratio_psi_u1_of_place_17 * phi_dot_sin_phi_doubled
                + S::int(2) * cos_lam
                    * (c
                        * phi_dot
                            .mul_add(
                                ratio_theta_u1_of_place,
                                delta_dot_cos_delta * ratio_psi_u1_of_place_52,
                            ) - c_sin_delta_sin_phi * ratio_psi_u1_2_of_motion_10
                        - rR * phi_dot_sin_phi * cos_phi_inv_sq)
                - w_sin_lam * ratio_psi_u1_2_of_phi_dot_2
                + rF
                    * (-ratio_psi_u1_of_place_19
                        * phi_dot_cos_phi_doubled
                            .mul_add(sin_lam, ratio_psi_u1_2_of_motion_8)
                        + S::int(2) * ratio_psi_u1_of_place_18 * ratio_psi_u1_2_of_motion_23
                        + ratio_psi_u1_2_of_phi_dot_2 * cos_lam));
    let ratio_psi_u1_2_of_motion_25 = -ratio_psi_u1_of_place_37
        * (ratio_psi_u1_of_place_23
            * (ratio_psi_u1_2_of_motion_20
                - ratio_psi_u1_of_place_37
                    * (cos_lam_plus_theta
                        * (ratio_psi_u1_2_of_delta_dot_7
                            + rF
                                * (-ratio_psi_u1_2_of_delta_dot_6
                                    + ratio_psi_u1_of_place_35 * ratio_psi_u1_2_of_motion_7
                                    - ratio_psi_u1_2_of_place_2
                                        * (-sin_delta
                                            * (ratio_psi_u1_2_of_motion_5
                                                + ratio_psi_u1_of_place_33 * ratio_psi_u1_2_of_motion_7
                                                + ratio_psi_u1_of_place_5
                                                    * (-sin_delta_sin_phi_sq
                                                        * ratio_psi_u1_2_of_phi_dot
                                                            .mul_add(S::int(3), -ratio_psi_u1_2_of_delta_dot)
                                                        + phi_dot_sin_phi * ratio_psi_u1_of_place_32
                                                        - sin_phi_cos_delta * ratio_psi_u1_2_of_delta_dot_3
                                                        - cos_phi
                                                            * (phi_dot * ratio_psi_u2_of_place_5 * cos_delta
                                                                - phi_dot_sin_phi * sin_phi_cos_delta
                                                                    * cos_lam_plus_theta_sq
                                                                - ratio_psi_u1_of_place_31 * ratio_psi_u1_2_of_motion_11
                                                                + ratio_psi_u1_of_place_30 * ratio_psi_u1_2_of_motion_12
                                                                + sin_lam_plus_theta
                                                                    * (delta_dot_cos_delta * ratio_psi_u1_of_place_28
                                                                        - sin_phi_cos_delta * cos_delta_sq
                                                                            * ratio_psi_u1_2_of_motion_2
                                                                        + ratio_psi_u1_of_place_29 * ratio_psi_u1_2_of_phi_dot
                                                                        - S::int(3) * ratio_psi_u1_of_place_40
                                                                            * ratio_psi_u1_2_of_delta_dot_2
                                                                        + sin_delta
                                                                            * (phi_dot_cos_phi
                                                                                * (-ratio_psi_u1_of_place_27)
                                                                                    .mul_add(sin_phi_doubled, ratio_psi_u1_of_place_26)
                                                                                - S::int(2) * cos_phi_sq
                                                                                    * (ratio_psi_u1_of_delta * ratio_psi_u1_2_of_motion_10)
                                                                                        .mul_add(
                                                                                            cos_lam_plus_theta,
                                                                                            delta_dot_cos_delta * sin_lam_plus_theta_sq * sin_delta,
                                                                                        )
                                                                                + sin_phi
                                                                                    * (delta_dot_cos_delta * ratio_psi_u1_of_place_24
                                                                                        - cos_delta_doubled * ratio_psi_u1_2_of_phi_dot
                                                                                        + S::int(4) * ratio_psi_u1_2_of_delta_dot_2
                                                                                        + sin_delta
                                                                                            * (ratio_psi_u1_of_place
                                                                                                .mul_add(
                                                                                                    ratio_psi_u1_2_of_delta_dot_5,
                                                                                                    cos_delta_doubled * ratio_psi_u1_2_of_motion_2,
                                                                                                ) + ratio_psi_u1_2_of_motion_14))))
                                                                - ratio_psi_u1_of_place_52
                                                                    * ratio_psi_u1_2_of_delta_dot_8)))
                                            + delta_dot_cos_delta * ratio_psi_u1_of_place_34
                                            + ratio_psi_u1_of_delta_3 * ratio_psi_u1_2_of_motion_2
                                            + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_delta_dot_9)))
                        + ratio_psi_u1_of_place_36 * ratio_psi_u1_2_of_motion_11
                        + ratio_psi_u1_2_of_motion_16)) + ratio_psi_u1_2_of_motion_24);
    let ratio_psi_u1_2_of_motion_26 = (-phi_dot)
        .mul_add(sin_delta_sin_phi, delta_dot_cos_delta * cos_phi)
        - ratio_psi_u1_2_of_motion_4 * sin_lam_plus_theta
        + sin_phi_cos_delta * ratio_psi_u1_2_of_motion_12;
    let ratio_psi_u1_2_of_motion_27 = ratio_psi_u1_2_of_motion_2
        .mul_add(cos_delta, delta_dot_sin_delta * ratio_psi_u1_of_place)
        + ratio_psi_u1_2_of_motion_14;
    let ratio_psi_u1_2_of_motion_28 = -ratio_psi_u1_2_of_motion_3 - ratio_psi_u1_2_of_motion_4;
    let ratio_psi_u1_2_of_motion_29 = (-ratio_psi_u1_of_place_50)
        .mul_add(
            ratio_psi_u1_2_of_motion_28,
            ratio_psi_u1_of_place_45 * ratio_psi_u1_2_of_motion_27,
        );
    let ratio_psi_u1_2_of_motion_30 = ratio_psi_u1_of_place_48 * ratio_psi_u1_2_of_motion_28
        * (-(ratio_psi_u1_of_place_43 * ratio_psi_u1_of_place_44))
            .mul_add(S::int(3), S::int(1));
    let ratio_psi_u1_2_of_motion_31 = ratio_psi_u1_of_place_41 * ratio_psi_u1_2_of_motion_30;
    let ratio_psi_u1_2_of_motion_32 = ratio_psi_u1_of_place_49
        .mul_add(ratio_psi_u1_2_of_motion_27, ratio_psi_u1_2_of_motion_31);
    let ratio_psi_u1_2_of_motion_33 = phi_dot
        .mul_add(sin_phi_cos_delta, delta_dot_sin_delta * cos_phi);
    let ratio_psi_u1_2_of_motion_34 = ratio_psi_u1_2_of_motion_14
        .mul_add(sin_lam_plus_theta, sin_delta_sin_phi * ratio_psi_u1_2_of_motion_12)
        + ratio_psi_u1_2_of_motion_33;
    let ratio_psi_u1_2_of_motion_35 = ratio_psi_u1_of_place_49 * ratio_psi_u1_2_of_motion_28;
    let ratio_psi_u1_2_of_motion_36 = (-phi_dot)
        .mul_add(ratio_psi_u1_of_place_14, ratio_psi_u1_2_of_motion_10 * sin_phi);
    let ratio_psi_u1_2_of_motion_37 = ratio_psi_u1_of_place_14 * ratio_psi_u1_2_of_motion_30;
    let ratio_psi_u1_2_of_motion_38 = ratio_psi_u1_of_place_14
        .mul_add(
            ratio_psi_u1_2_of_motion_35,
            ratio_psi_u1_of_place_45 * ratio_psi_u1_2_of_motion_21,
        );
    let ratio_psi_u1_2_of_motion_39 = ratio_psi_u1_2_of_motion_12
        .mul_add(sin_phi, phi_dot_cos_phi * sin_lam_plus_theta);
    let rr_phi_dot_cos_phi = rR * phi_dot_cos_phi;
    let ratio_psi_u1_2_of_motion_40 = ratio_psi_u1_of_place_46 * ratio_psi_u1_2_of_motion_26
        - ratio_psi_u1_of_place_54 * ratio_psi_u1_2_of_motion_21
        - ratio_psi_u1_of_place_51 * ratio_psi_u1_2_of_motion_27
        - ratio_psi_u1_of_place_39 * ratio_psi_u1_2_of_motion_29
        + ratio_psi_u1_of_place_41
            * ((-ratio_psi_u1_of_place_45)
                .mul_add(
                    ratio_psi_u1_2_of_motion_26,
                    ratio_psi_u1_of_place_39 * ratio_psi_u1_2_of_motion_35,
                ) - ratio_psi_u1_of_place_47 * ratio_psi_u1_2_of_motion_32
                - ratio_psi_u1_of_place_50 * ratio_psi_u1_2_of_motion_34)
        + ratio_psi_u1_of_place_56 * ratio_psi_u1_2_of_motion_36
        - ratio_psi_u1_of_place_14
            * (ratio_psi_u1_of_place_53 * ratio_psi_u1_2_of_motion_34
                + ratio_psi_u1_of_place_52 * ratio_psi_u1_2_of_motion_35
                + ratio_psi_u1_of_place_45 * ratio_psi_u1_2_of_motion_36
                + ratio_psi_u1_of_place_47
                    * (-ratio_psi_u1_of_place_49)
                        .mul_add(
                            ratio_psi_u1_2_of_motion_21, ratio_psi_u1_2_of_motion_37,
                        )) - ratio_psi_u1_of_place_52 * ratio_psi_u1_2_of_motion_38
        + v_Ho_2_of_w_c_lam_rr_2 * ratio_psi_u1_2_of_motion_39 + rr_phi_dot_cos_phi;
    let ratio_psi_u1_2_of_place_4 = ratio_psi_u1_of_place_38 * ratio_psi_u1_2_of_place_3;
    let ratio_psi_u1_2_of_motion_41 = thR_dot
        .mul_add(ratio_psi_u3, phi_dot * ratio_psi_u1);
    let ratio_psi_u1_2_of_motion_42 = delta_dot
        .mul_add(ratio_psi_u2, ratio_psi_u1_2_of_motion_41);
    let ratio_psi_u1_2_of_motion_43 = ratio_psi_u1_2_of_motion_42 * cos_psi;
    let ratio_psi_u1_2_of_motion_44 = ratio_psi_u1_2_of_motion_42 * sin_psi;
    let ratio_psi_u1_2_of_motion_45 = ratio_psi_u1_of_place_60 * ratio_psi_u1_2_of_motion_19;
    let ratio_psi_u1_2_of_motion_46 = delta_dot_cos_delta * ratio_psi_u1_of_place_67
        + ratio_psi_u1_2_of_motion_33 * cos_psi - cos_delta_cos_phi * ratio_psi_u1_2_of_motion_44
        + sin_delta
            * ((-ratio_psi_u1_2_of_motion_10)
                .mul_add(sin_psi, ratio_psi_u1_2_of_motion_39 * cos_psi)
                - ratio_psi_u1_2_of_motion_43 * cos_lam_plus_theta
                + ratio_psi_u1_of_place_57 * ratio_psi_u1_2_of_motion_44);
    let ratio_psi_u1_2_of_motion_47 = ratio_psi_u1_2_of_motion_33 * sin_psi
        - delta_dot_cos_delta * ratio_psi_u1_of_place_69
        + cos_delta_cos_phi * ratio_psi_u1_2_of_motion_43
        + sin_delta
            * (ratio_psi_u1_2_of_motion_39
                .mul_add(sin_psi, ratio_psi_u1_2_of_motion_10 * cos_psi)
                - ratio_psi_u1_of_place_57 * ratio_psi_u1_2_of_motion_43
                - ratio_psi_u1_2_of_motion_44 * cos_lam_plus_theta);
    let ratio_psi_u1_2_of_motion_48 = ratio_psi_u1_2_of_motion_47
        .mul_add(sin_psi, ratio_psi_u1_2_of_motion_46 * cos_psi);
    let ratio_psi_u1_2_of_motion_49 = ratio_psi_u1_of_place_68
        .mul_add(
            ratio_psi_u1_2_of_motion_44,
            ratio_psi_u1_of_place_70 * ratio_psi_u1_2_of_motion_43,
        );
    let ratio_psi_u1_2_of_motion_50 = ratio_psi_u1_of_place_71
        .mul_add(ratio_psi_u1_2_of_motion_45, ratio_psi_u1_2_of_motion_48);
    let ratio_psi_u1_2 = ratio_psi_u1_2_of_motion_40 * ratio_psi_u1_2_of_place_4
        - ratio_psi_u1_of_place_72 * ratio_psi_u1_2_of_motion_15
        - ratio_psi_u1_of_place_61 * ratio_psi_u1_2_of_motion_25
        - ratio_psi_u1_of_place_66 * ratio_psi_u1_2_of_place_3
            * (ratio_psi_u1_2_of_motion_49 + ratio_psi_u1_2_of_motion_50);
    let ratio_psi_u2_2_of_motion = ratio_psi_u1_of_place_42 * ratio_psi_u1_2_of_motion_29;
    let ratio_psi_u2_2_of_motion_2 = ratio_psi_u1_of_place_46 * ratio_psi_u1_2_of_motion_28;
    let ratio_psi_u2_2_of_motion_3 = ratio_psi_u1_of_place_14 * ratio_psi_u1_of_place_50
        * ratio_psi_u1_2_of_motion_22 - ratio_psi_u2_of_place_4 * ratio_psi_u1_2_of_motion_27
        + ratio_psi_u2_2_of_motion_2 - ratio_psi_u2_of_place_5 * ratio_psi_u1_2_of_motion_32
        + ratio_psi_u1_of_place_41
            * ((-(ratio_psi_u1_of_place_50 * ratio_psi_u1_2_of_motion_27))
                .mul_add(
                    S::int(2),
                    ratio_psi_u1_of_place_42 * ratio_psi_u1_2_of_motion_35,
                ) - ratio_psi_u1_of_place_45 * ratio_psi_u1_2_of_motion_28
                - ratio_psi_u1_of_place_41 * ratio_psi_u1_2_of_motion_31)
        - ratio_psi_u2_2_of_motion;
    let ratio_psi_u2_2_of_place = ratio_psi_u1_of_place_46 * ratio_psi_u1_2_of_place_3;
    let ratio_psi_u2_2_of_motion_4 = (-ratio_psi_u1_2_of_motion_23)
        .mul_add(cos_psi, ratio_psi_u1_of_place_47 * ratio_psi_u1_2_of_motion_43)
        - ratio_psi_u1_2_of_motion_34 * sin_psi
        + ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_motion_44;
    let ratio_psi_u2_2_of_motion_5 = (-ratio_psi_u1_2_of_motion_23)
        .mul_add(sin_psi, ratio_psi_u1_2_of_motion_34 * cos_psi)
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_motion_43
        + ratio_psi_u1_of_place_47 * ratio_psi_u1_2_of_motion_44;
    let ratio_psi_u2_2_of_motion_6 = (-ratio_psi_u2_of_place)
        .mul_add(
            ratio_psi_u1_2_of_motion_47,
            ratio_psi_u1_of_place_70 * ratio_psi_u2_2_of_motion_4,
        );
    let ratio_psi_u2_2_of_motion_7 = ratio_psi_u1_of_place_68
        .mul_add(
            ratio_psi_u2_2_of_motion_5,
            ratio_psi_u2_of_place_2 * ratio_psi_u1_2_of_motion_46,
        );
    let ratio_psi_u2_2 = ratio_psi_u1_2_of_place_4 * ratio_psi_u2_2_of_motion_3
        - ratio_psi_u2_of_place_8 * ratio_psi_u1_2_of_motion_25
        + ratio_psi_u2_of_place_3
            * (-ratio_psi_u1_2_of_place_3)
                .mul_add(
                    ratio_psi_u1_2_of_motion_29,
                    ratio_psi_u1_2_of_motion_45 * ratio_psi_u2_2_of_place,
                )
        + ratio_psi_u2_2_of_place * (ratio_psi_u2_2_of_motion_6 + ratio_psi_u2_2_of_motion_7);
    let ratio_psi_u3_2 = (-ratio_psi_u3_of_place)
        .mul_add(
            ratio_psi_u1_2_of_motion_23,
            ratio_psi_u3 * ratio_psi_u1_2_of_motion_45,
        );
    let ratio_theta_u1_2_of_motion = ratio_psi_u1_2_of_motion_38 * cos_delta;
    let ratio_theta_u1_2_of_motion_2 = ratio_psi_u1_2_of_motion_29 * cos_delta;
    let ratio_theta_u1_2_of_motion_3 = ratio_psi_u1_of_place_49
        * (-ratio_theta_u1_of_place)
            .mul_add(
                ratio_psi_u1_2_of_motion_22,
                delta_dot_cos_delta * ratio_psi_u2_of_place_5,
            ) - ratio_psi_u1_of_place_45 * ratio_psi_u1_2_of_motion_2
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_motion_35
        + ratio_theta_u1_of_place * ratio_psi_u1_2_of_motion_37;
    let ratio_theta_u1_2_of_motion_4 = ratio_theta_u1_of_place_6
        * (ratio_psi_u1_of_place_56 * ratio_psi_u1_2_of_motion_2
            + ratio_psi_u1_of_place_46 * ratio_psi_u1_2_of_delta_dot_8
            - ratio_theta_u1_of_place_5 * ratio_psi_u1_2_of_motion_21
            + ratio_theta_u1_of_place_2 * ratio_psi_u1_2_of_motion_27
            - ratio_psi_u1_of_place * ratio_psi_u1_2_of_motion_38
            + ratio_psi_u1_of_place_41
                * (ratio_theta_u1_of_place * ratio_psi_u1_2_of_motion_32
                    - delta_dot_sin_delta * ratio_psi_u1_of_place_55
                    - ratio_psi_u1_of_place_50
                        * (-delta_dot_cos_delta)
                            .mul_add(
                                ratio_psi_u1_of_place_14,
                                ratio_psi_u1_2_of_motion_21 * sin_delta,
                            ) - ratio_theta_u1_2_of_motion)
            + ratio_psi_u1_of_place_14
                * (ratio_theta_u1_2_of_motion_2 + ratio_theta_u1_2_of_motion_3));
    let ratio_theta_u1_2 = ratio_theta_u1
        .mul_add(
            ratio_theta_u1_2_of_motion_4,
            ratio_theta_u1_of_place_6 * ratio_psi_u1_2_of_motion_40,
        );
    let ratio_theta_u2_2 = ratio_theta_u2
        .mul_add(
            ratio_theta_u1_2_of_motion_4,
            ratio_theta_u1_of_place_6 * ratio_psi_u2_2_of_motion_3,
        );
    let ratio_thF_u1_2_of_place = ratio_thF_u1_of_place_18 * ratio_psi_u1_2_of_place_3;
    let ratio_thF_u1_2_of_motion = ratio_psi_u1_2_of_motion_7 + ratio_psi_u1_2_of_motion_20;
    let ratio_thF_u1_2_of_motion_2 = ratio_thF_u1_of_place_19 * ratio_thF_u1_2_of_motion;
    let ratio_thF_u1_2_of_motion_3 = ratio_psi_u1_2_of_motion_10
        .mul_add(cos_delta, delta_dot_sin_delta * cos_lam_plus_theta);
    let ratio_thF_u1_2_of_motion_4 = (-ratio_psi_u1_of_place_39)
        .mul_add(ratio_psi_u1_2_of_motion_43, ratio_psi_u1_2_of_motion_26 * sin_psi)
        - ratio_thF_u1_of_place * ratio_psi_u1_2_of_motion_44
        + ratio_thF_u1_2_of_motion_3 * cos_psi;
    let ratio_thF_u1_2_of_motion_5 = ratio_psi_u1_of_place_42
        .mul_add(
            ratio_psi_u1_2_of_motion_38,
            ratio_psi_u1_of_place_56 * ratio_psi_u1_2_of_motion_28,
        );
    let ratio_thF_u1_2_of_motion_6 = v_FC_1_of_w_lam_rr_rf
        .mul_add(
            ratio_psi_u1_2_of_motion_27,
            v_FC_2_of_c_lam_rf * ratio_psi_u1_2_of_motion_21,
        );
    let ratio_thF_u1_2_of_motion_7 = (-ratio_psi_u1_2_of_motion_36)
        .mul_add(sin_psi, ratio_psi_u1_2_of_motion_12 * cos_psi)
        - ratio_psi_u1_of_place_52 * ratio_psi_u1_2_of_motion_43
        + ratio_psi_u1_2_of_motion_44 * sin_lam_plus_theta;
    let ratio_thF_u1_2_of_motion_8 = ratio_psi_u2_2_of_motion_2 - ratio_psi_u2_2_of_motion;
    let ratio_thF_u1_2_of_motion_9 = v_Ho_2_of_w_c_lam_rr_2
        .mul_add(phi_dot_cos_phi, ratio_thF_u1_2_of_motion_8);
    let ratio_thF_u1_2_of_motion_10 = v_Ho_2_of_w_c_lam_rr_2
        * cos_phi_sq
            .mul_add(
                ratio_psi_u1_2_of_motion_10,
                ratio_psi_u1_of_place_14 * phi_dot_sin_phi_doubled,
            );
    let ratio_thF_u1_2_of_motion_11 = (-ratio_thF_u1_of_place_8)
        .mul_add(ratio_psi_u1_2_of_motion_43, rr_phi_dot_cos_phi * cos_psi)
        + v_RC_1_3 * ratio_psi_u1_2_of_motion_44
        + ratio_thF_u1_of_place_4 * ratio_psi_u2_2_of_motion_4
        + ratio_thF_u1_of_place_3 * ratio_thF_u1_2_of_motion_4
        - ratio_thF_u1_of_place_2 * ratio_thF_u1_2_of_motion_5
        - ratio_psi_u2_of_place * ratio_thF_u1_2_of_motion_6
        + ratio_thF_u1_of_place_7 * ratio_thF_u1_2_of_motion_7
        + ratio_thF_u1_of_place_5 * ratio_thF_u1_2_of_motion_9
        - ratio_thF_u1_2_of_motion_10 * sin_psi;
    let ratio_thF_u1_2_of_motion_12 = (-ratio_psi_u1_2_of_motion_26)
        .mul_add(cos_psi, ratio_thF_u1_of_place * ratio_psi_u1_2_of_motion_43)
        - ratio_psi_u1_of_place_39 * ratio_psi_u1_2_of_motion_44
        + ratio_thF_u1_2_of_motion_3 * sin_psi;
    let ratio_thF_u1_2_of_motion_13 = (-delta_dot_sin_delta)
        .mul_add(ratio_psi_u1_of_place_56, ratio_theta_u1_2_of_motion);
    let ratio_thF_u1_2_of_motion_14 = ratio_psi_u1_2_of_motion_38
        .mul_add(sin_delta, delta_dot_cos_delta * ratio_psi_u1_of_place_56);
    let ratio_thF_u1_2_of_motion_15 = delta_dot_sin_delta
        .mul_add(ratio_psi_u1_of_place_46, ratio_theta_u1_2_of_motion_2);
    let ratio_thF_u1_2_of_motion_16 = (-ratio_psi_u1_2_of_motion_12)
        .mul_add(sin_psi, ratio_psi_u1_2_of_motion_43 * sin_lam_plus_theta)
        - ratio_psi_u1_2_of_motion_36 * cos_psi
        + ratio_psi_u1_of_place_52 * ratio_psi_u1_2_of_motion_44;
    let ratio_thF_u1_2_of_motion_17 = (-v_RC_1_3)
        .mul_add(ratio_psi_u1_2_of_motion_43, rr_phi_dot_cos_phi * sin_psi)
        - ratio_thF_u1_of_place_8 * ratio_psi_u1_2_of_motion_44
        + ratio_thF_u1_of_place_4 * ratio_psi_u2_2_of_motion_5
        - ratio_thF_u1_of_place_11 * ratio_thF_u1_2_of_motion_5
        - ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_motion_6
        + ratio_thF_u1_of_place_13 * ratio_thF_u1_2_of_motion_9
        + ratio_thF_u1_2_of_motion_10 * cos_psi
        + ratio_thF_u1_of_place_3 * ratio_thF_u1_2_of_motion_12
        - ratio_thF_u1_of_place_7 * ratio_thF_u1_2_of_motion_16;
    let ratio_thF_u1_2_of_motion_18 = ratio_thF_u1_of_place_17
        * ratio_theta_u1_2_of_motion_4
            .mul_add(ratio_thF_u1_2_of_place, ratio_thF_u1_2_of_motion_2)
        + ratio_thF_u1_2_of_place
            * (ratio_thF_u1_of_place_15
                * (ratio_thF_u1_of_place_10
                    .mul_add(
                        ratio_thF_u1_2_of_motion_4,
                        ratio_thF_u1_of_place_12 * ratio_psi_u2_2_of_motion_4,
                    ) - ratio_theta_u1_of_place_4 * ratio_thF_u1_2_of_motion_7
                    + ratio_thF_u1_of_place_2 * ratio_thF_u1_2_of_motion_13
                    + ratio_psi_u2_of_place * ratio_thF_u1_2_of_motion_14
                    + ratio_thF_u1_of_place_5 * ratio_thF_u1_2_of_motion_15)
                + ratio_thF_u1_of_place_14 * ratio_thF_u1_2_of_motion_11
                - ratio_thF_u1_of_place_9
                    * (ratio_thF_u1_of_place_10
                        .mul_add(
                            ratio_thF_u1_2_of_motion_12,
                            ratio_thF_u1_of_place_12 * ratio_psi_u2_2_of_motion_5,
                        ) + ratio_thF_u1_of_place_11 * ratio_thF_u1_2_of_motion_13
                        + ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_motion_14
                        + ratio_thF_u1_of_place_13 * ratio_thF_u1_2_of_motion_15
                        + ratio_theta_u1_of_place_4 * ratio_thF_u1_2_of_motion_16)
                - ratio_thF_u1_of_place_16 * ratio_thF_u1_2_of_motion_17);
    let ratio_thF_u1_2_of_place_2 = ratio_theta_u1_of_place_6 * ratio_thF_u1_of_place_17
        * ratio_thF_u1_2_of_place;
    let ratio_thF_u1_2_of_motion_19 = ratio_thF_u1_2_of_motion_17
        .mul_add(sin_psi, ratio_thF_u1_2_of_motion_11 * cos_psi);
    let ratio_thF_u1_2_of_motion_20 = (-ratio_thF_u1_of_place_15)
        .mul_add(
            ratio_psi_u1_2_of_motion_43,
            ratio_thF_u1_of_place_9 * ratio_psi_u1_2_of_motion_44,
        );
    let ratio_thF_u1_2 = -ratio_thF_u1_of_place_21
        * ratio_psi_u1_of_place_66
            .mul_add(ratio_thF_u1_2_of_motion, ratio_psi_u1_2_of_motion_15)
        + ratio_theta_u1 * ratio_thF_u1_2_of_motion_18
        + ratio_psi_u1_2_of_motion_40 * ratio_thF_u1_2_of_place_2
        - ratio_psi_u1_of_place_66 * ratio_thF_u1_2_of_place
            * (ratio_thF_u1_2_of_motion_19 + ratio_thF_u1_2_of_motion_20);
    let ratio_thF_u2_2_of_motion = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_motion_17,
            ratio_thF_u1_of_place_15 * ratio_psi_u2_2_of_motion_4,
        );
    let ratio_thF_u2_2_of_motion_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_motion_11,
            ratio_thF_u1_of_place_9 * ratio_psi_u2_2_of_motion_5,
        );
    let ratio_thF_u2_2 = ratio_thF_u2_of_place * ratio_psi_u1_2_of_motion_29
        * ratio_thF_u1_2_of_place - ratio_thF_u2_of_place_2 * ratio_thF_u1_2_of_motion_2
        + ratio_theta_u2 * ratio_thF_u1_2_of_motion_18
        + ratio_psi_u2_2_of_motion_3 * ratio_thF_u1_2_of_place_2
        + ratio_psi_u1_of_place_46 * ratio_thF_u1_2_of_place
            * (ratio_thF_u2_2_of_motion_2 - ratio_thF_u2_2_of_motion);
    let ratio_thF_u3_2_of_motion = ratio_thF_u3_of_place * ratio_psi_u1_2_of_motion_11
        + ratio_thF_u3_of_w_lam_rr_rf * ratio_psi_u1_2_of_motion_13
        + cos_lam_plus_theta
            * ((-ratio_psi_u1_of_place_42)
                .mul_add(ratio_psi_u1_2_of_motion_8, ratio_psi_u1_2_of_delta_dot_6)
                - rf_inv * ratio_psi_u1_2_of_delta_dot_7
                + ratio_psi_u1_2_of_place * ratio_psi_u1_2_of_motion_28);
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_motion, ratio_thF_u3_2_of_motion);
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
    let l2_of_place_6 = p_w_Y_in_L_2_4 + l2_of_place_5;
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
        - ratio_psi_u2 * l2_of_place_8.mul_add(cos_phi, l2_of_place_6 * sin_phi)
        - ratio_theta_u2 * l2_of_place_12 - ratio_thF_u2 * l2_of_place_15;
    let d1_inv = S::int(1) / d1;
    let l2 = l2_of_place_16 * d1_inv;
    let s3_of_place = ratio_psi_u1 * p_w_Y_in_L_2_3;
    let s3_of_place_2 = ratio_psi_u1 * p_w_Y_in_L_3_3;
    let s3 = IRxx + rR * p_v_RC_2_6 + p_w_L_in_B_3_4 * sin_theta + p_w_L_in_B_1_4 * cos_theta
        + ratio_theta_u1 * (-l2_of_place_11).mul_add(S::int(2), ratio_theta_u1_p_w_b_2_5)
        + ratio_thF_u1 * (-l2_of_place_13).mul_add(S::int(2), ifyy_ratio_thf_u1)
        - l2 * l2_of_place_16
        - ratio_psi_u1
            * (sin_phi * l2_of_place_6.mul_add(S::int(2), -s3_of_place)
                + cos_phi * l2_of_place_8.mul_add(S::int(2), -s3_of_place_2));
    let s4_of_place = l2_of_place_6 - s3_of_place;
    let s4_of_place_2 = l2_of_place_8 - s3_of_place_2;
    let s4_of_place_3 = (-ratio_psi_u2).mul_add(l2, ratio_psi_u1);
    let cos_phi_p_w_y_in_l_3_7 = p_w_Y_in_L_3_7 * cos_phi;
    let s4_of_place_4 = ratio_theta_u2.mul_add(p_v_RC_1_7, -p_v_RC_1_8);
    let s4_of_place_5 = (-ratio_theta_u1).mul_add(p_v_RC_1_7, ratio_psi_u1 * p_v_RC_1_5);
    let s4_of_place_6 = p_v_RC_1_6 - s4_of_place_5;
    let s4 = ratio_thF_u3
        * (l2_of_place_13 - IFyy * (-ratio_thF_u2).mul_add(l2, ratio_thF_u1)
            - H_front_wheel_2_5
                * ((-ratio_theta_u2).mul_add(l2, ratio_theta_u1)
                    - s4_of_place_3 * sin_phi) + s4_of_place_3 * cos_phi_p_w_y_in_l_3_7)
        - ratio_psi_u3
            * (sin_phi * l2.mul_add(l2_of_place, s4_of_place)
                + cos_phi * (-l2).mul_add(l2_of_place_2, s4_of_place_2))
        - H_rear_wheel_2_3 * s4_of_place_3
        + rR * (l2 * ratio_psi_u2.mul_add(p_v_RC_1_5, -s4_of_place_4) + s4_of_place_6);
    let r5_of_motion = sin_psi
        * (y_dot.mul_add(p_v_N_in_Y_2, x_dot * p_v_RC_1) - F_x_N_in_Y_1 * mp_N_1
            + F_x_N_in_Y_2 * mp_N_2)
        + cos_psi
            * ((-y_dot).mul_add(p_v_RC_1, x_dot * p_v_N_in_Y_2) + F_x_N_in_Y_2 * mp_N_1
                + F_x_N_in_Y_1 * mp_N_2)
        + phi_dot * (-p_w_Y_in_L_2).mul_add(cos_phi, p_w_Y_in_L_3 * sin_phi)
        + p_w_Y_in_L_3_2 * cos_phi - p_w_Y_in_L_2_2 * sin_phi;
    let r5_of_phi_dot = p_w_B_2_2
        + sin_theta
            * ((-v_Y_in_L_3).mul_add(p_v_L_in_B_3, v_RC_1 * p_v_L_in_B_1)
                + w_Y_in_L_3 * p_w_L_in_B_3 + phi_dot * p_w_L_in_B_1
                + F_x_F_1_2 * x_N_in_Y_1 - F_x_F_3 * x_F_3 + x_Y_in_L_3 * F_x_L_in_B_3)
        + cos_theta
            * ((-v_RC_1).mul_add(p_v_L_in_B_3, w_Y_in_L_3 * p_w_L_in_B_1)
                - v_Y_in_L_3 * p_v_L_in_B_1 - phi_dot * p_w_L_in_B_3
                - F_x_F_3 * x_N_in_Y_1 - F_x_F_1_2 * x_F_3 + x_Y_in_L_3 * F_x_L_in_B_1);
    let r5_of_motion_2 = delta_dot.mul_add(ratio_theta_u2_2, phi_dot * ratio_theta_u1_2);
    let r5_of_place = (-p_w_Y_in_L_2_5).mul_add(sin_phi, p_w_Y_in_L_3_5 * cos_phi);
    let r5_of_place_2 = (-ratio_psi_u1).mul_add(p_v_N_in_Y_2_5, p_v_N_in_Y_2_6)
        + ratio_theta_u1 * p_v_N_in_Y_2_7;
    let rr_thr_dot = rR * thR_dot;
    let r5_of_motion_3 = ratio_psi_u1_2_of_motion_44 * rr_thr_dot;
    let r5_of_motion_4 = ratio_psi_u1_2_of_motion_43 * rr_thr_dot;
    let ratio_psi_u3_2_doubled = S::int(2) * ratio_psi_u3_2;
    let r5_of_motion_5 = delta_dot.mul_add(ratio_psi_u2_2, phi_dot * ratio_psi_u1_2);
    let r5_of_motion_6 = thR_dot.mul_add(ratio_psi_u3_2_doubled, r5_of_motion_5);
    let r5_of_motion_6_halved = S::ratio(1, 2) * r5_of_motion_6;
    let r5_of_place_3 = H_front_wheel_2_5.mul_add(sin_phi, cos_phi_p_w_y_in_l_3_7);
    let r5_of_motion_7 = delta_dot.mul_add(ratio_thF_u2_2, phi_dot * ratio_thF_u1_2);
    let r5_of_motion_8 = thR_dot.mul_add(ratio_thF_u3_2, -r5_of_motion_7);
    let minus_r5_of_motion_8 = -r5_of_motion_8;
    let r5_of_motion_9 = S::ratio(1, 2) * minus_r5_of_motion_8;
    let r5_of_place_4 = ratio_theta_u2.mul_add(p_v_N_in_Y_2_7, -p_v_N_in_Y_2_8);
    let r5_of_place_5 = ratio_theta_u2.mul_add(H_front_wheel_2_5, ifyy_ratio_thf_u2);
    let r5_of_place_6 = ratio_psi_u2.mul_add(r5_of_place_3, -r5_of_place_5);
    let r5_of_phi_dot_2 = ratio_theta_u2
        .mul_add(r5_of_phi_dot, H_front_wheel_2_2 * ratio_thF_u2);
    let r5_of_motion_10 = thR_dot
        * (S::int(2) * rR
            * (ratio_psi_u2
                * (delta_dot * ratio_psi_u2.mul_add(p_v_N_in_Y_2_5, -r5_of_place_4)
                    + p_v_N_in_Y_2_5 * ratio_psi_u1_2_of_motion_41)
                - ratio_psi_u1_2_of_motion_41 * r5_of_place_4)
            - l2_of_place_3 * ratio_psi_u3_2_doubled - ratio_thF_u3_2 * r5_of_place_6)
        - S::int(2) * p_w_F_3_2;
    let r5_of_place_7 = (-ratio_psi_u2)
        .mul_add(r5_of_place, -d1_of_place_8 - ratio_theta_u2_p_w_b_2_5);
    let r5_of_place_7_doubled = S::int(2) * r5_of_place_7;
    let r5_of_motion_11 = sin_delta
        * ((-v_B_in_S_1).mul_add(p_v_S_in_F_1, v_Ho_2 * p_v_S_in_F_2)
            + w_B_2 * p_w_S_in_F_2 + w_B_in_S_1 * p_w_S_in_F_1
            - x_S_in_F_2 * x_Y_in_L_2_2 - x_S_in_F_1 * x_F_1_2
            - x_Y_in_L_2 * x_S_in_F_2_2 + x_B_in_S_1 * x_F_1_3) + ratio_psi_u2 * r5_of_motion;
    let r5_of_motion_12 = phi_dot
        * ((-ratio_thF_u1_2).mul_add(r5_of_place_6, ratio_psi_u1_2 * l2_of_place_3)
            - ratio_theta_u1_2 * r5_of_place_7_doubled)
        + delta_dot
            * ((-ratio_thF_u2_2).mul_add(r5_of_place_6, ratio_psi_u2_2 * l2_of_place_3)
                - ratio_theta_u2_2 * r5_of_place_7_doubled);
    let r5_of_motion_13 = cos_delta_doubled
        * ((-v_B_in_S_1).mul_add(p_v_S_in_F_2, w_B_2 * p_w_S_in_F_1)
            - v_Ho_2 * p_v_S_in_F_1 - w_B_in_S_1 * p_w_S_in_F_2
            - x_S_in_F_1 * x_Y_in_L_2_2 + x_S_in_F_2 * x_F_1_2
            + x_B_in_S_1 * x_S_in_F_2_2 + x_Y_in_L_2 * x_F_1_3) + S::int(2) * r5_of_motion_11;
    let r5_of_motion_14 = r5_of_phi_dot_2.mul_add(S::int(2), -r5_of_motion_10);
    let r5_of_motion_15 = r5_of_motion_12 + r5_of_motion_13;
    let r5_of_motion_16 = r5_of_motion_14 + r5_of_motion_15;
    let r5_of_motion_16_halved = S::ratio(1, 2) * r5_of_motion_16;
    let r5 = p_w_L_in_B_3_2 * sin_theta - rR * p_v_RC_2_2 + p_w_L_in_B_1_2 * cos_theta
        + sin_phi
            * ((-psi_dot).mul_add(p_w_Y_in_L_3, v_N_in_Y_2 * p_v_RC_2)
                + F_x_Y_in_L_2 * x_N_in_Y_2 - g * F_x_Y_in_L_3)
        + cos_phi
            * ((-g).mul_add(F_x_Y_in_L_2_2, v_N_in_Y_2 * p_v_Y_in_L_3)
                + psi_dot * p_w_Y_in_L_2 + F_x_F_3_2 * x_N_in_Y_2)
        - H_front_wheel_2_2 * ratio_thF_u1 - theta_dot * p_w_Y_in_L_3_of_place
        - ratio_psi_u1 * r5_of_motion - ratio_theta_u1 * r5_of_phi_dot
        + r5_of_motion_2 * (-ratio_psi_u1).mul_add(r5_of_place, l2_of_place_12)
        - r5_of_motion_3 * r5_of_place_2.mul_add(sin_psi, s4_of_place_6 * cos_psi)
        + r5_of_motion_4 * (-r5_of_place_2).mul_add(cos_psi, s4_of_place_6 * sin_psi)
        + r5_of_motion_6_halved * s4_of_place_2.mul_add(cos_phi, s4_of_place * sin_phi)
        + r5_of_motion_9 * ratio_psi_u1.mul_add(r5_of_place_3, l2_of_place_15)
        + l2 * r5_of_motion_16_halved;
    let l6_of_place = ratio_thF_u3 * H_front_wheel_2_5;
    let iryy_minus_l6_of_place = IRyy - l6_of_place;
    let l6_of_place_2 = ratio_psi_u3 * l2_of_place_3 + rR * s4_of_place_4
        - ratio_thF_u3 * r5_of_place_5
        + ratio_psi_u2
            * (ratio_thF_u3.mul_add(cos_phi_p_w_y_in_l_3_7, -rr_p_v_rc_1_5)
                - iryy_minus_l6_of_place * sin_phi);
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
        + ratio_psi_u3
            * (cos_phi * s7_of_place_3.mul_add(S::int(2), s7_of_place_4)
                - sin_phi * iryy_minus_l6_of_place.mul_add(S::int(2), -s7_of_place_2))
        + ratio_thF_u3 * ifyy_ratio_thf_u3;
    let r8 = -H_rear_wheel_2_2 + H_front_wheel_2_2 * ratio_thF_u3
        + rR
            * (-p_v_RC_1_2 + psi_dot * p_v_N_in_Y_2
                - mp_N_1_of_mr_mb_mh_mf * (-F_mp_N_2).mul_add(sin_psi, F_mp_N_1 * cos_psi))
        - ratio_psi_u3 * r5_of_motion
        + r5_of_motion_4
            * (ratio_psi_u3 * (-p_v_RC_1_5).mul_add(sin_psi, p_v_N_in_Y_2_5 * cos_psi)
                + rR * p_v_RC_1_4) + l6 * r5_of_motion_16_halved
        + r5_of_motion_2 * (-ratio_psi_u3).mul_add(r5_of_place, l6_of_place - rr_p_v_rc_1_7)
        + r5_of_motion_3
            * (ratio_psi_u3 * p_v_N_in_Y_2_5.mul_add(sin_psi, p_v_RC_1_5 * cos_psi)
                - rR
                    * (p_v_RC_1_3 * cos_psi * cos_psi
                        + sin_psi * (-p_v_N_in_Y_2_4).mul_add(sin_psi, s7_of_place * cos_psi)))
        + r5_of_motion_6_halved
            * (rr_p_v_rc_1_5 + sin_phi * (iryy_minus_l6_of_place - s7_of_place_2)
                - cos_phi * (s7_of_place_3 + s7_of_place_4))
        + r5_of_motion_9 * ratio_psi_u3.mul_add(r5_of_place_3, ifyy_ratio_thf_u3);
    let s3_inv = S::int(1) / s3;
    let l9 = s4 * s3_inv;
    let s10 = (-s4).mul_add(l9, s7);
    let r11 = (-r5).mul_add(l9, r8);
    let u3_dot = r11 / s10;
    let u1_dot = s3_inv * (-u3_dot).mul_add(s4, r5);
    let u2_dot_of_motion = u3_dot.mul_add(l6_of_place_2, u1_dot * l2_of_place_16);
    let u2_dot = -S::ratio(1, 2) * d1_inv * u2_dot_of_motion.mul_add(S::int(2), r5_of_motion_16);
    let rr_u3_dot = rR * u3_dot;
    let x_ddot = (-rr_u3_dot).mul_add(cos_psi, -r5_of_motion_3);
    let y_ddot = (-rr_u3_dot).mul_add(sin_psi, r5_of_motion_4);
    let psi_ddot = (-u2_dot).mul_add(ratio_psi_u2, -u1_dot * ratio_psi_u1)
        - u3_dot * ratio_psi_u3 - r5_of_motion_6_halved;
    let phi_ddot = u1_dot;
    let theta_ddot = u2_dot.mul_add(ratio_theta_u2, u1_dot * ratio_theta_u1) + r5_of_motion_2;
    let delta_ddot = u2_dot;
    let thR_ddot = u3_dot;
    let thF_ddot = u2_dot.mul_add(ratio_thF_u2, u1_dot * ratio_thF_u1)
        - u3_dot * ratio_thF_u3 - S::ratio(1, 2) * r5_of_motion_8;
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
/// 373 operations, 5 sines and cosines, 2 other functions.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> [S; 8] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // rR - rF
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    // rr_minus_rf*cos(lam) + w_sin_lam
    let ratio_psi_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let sin_lam_cos_delta = sin_lam * cos_delta;
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let ratio_psi_u1_of_place = S::int(2) * sin_phi_cos_delta;
    // lam + theta
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_psi_u1_of_place_2 = cos_phi * sin_lam_plus_theta;
    let ratio_psi_u1_of_place_3 = ratio_psi_u1_of_place_2 * sin_delta;
    // ratio_psi_u1_of_place + ratio_psi_u1_of_place_3
    let ratio_psi_u1_of_place_4 = ratio_psi_u1_of_place + ratio_psi_u1_of_place_3;
    // 1/(sin_phi_cos_delta^2 - 1 + ratio_psi_u1_of_place_3*ratio_psi_u1_of_place_4)
    let ratio_psi_u1_of_place_5 = S::int(1)
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_4);
    let ratio_psi_u1_of_place_6 = cos_phi * sin_lam_plus_theta * sin_delta;
    // sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))
    let ratio_psi_u1_of_place_7 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), ratio_psi_u1_of_place_6))
        .sqrt();
    let ratio_psi_u1_of_place_8 = ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_7;
    let ratio_psi_u1_of_place_9 = ratio_psi_u1_of_place_8 * sin_delta;
    let rr_sin_lam = rR * sin_lam;
    // rr_sin_lam - cos(lam)*(w + c*(1 - cos(delta)))
    let ratio_psi_u1_of_place_10 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    // rF*(ratio_psi_u1_of_place_4*ratio_psi_u1_of_place_9 - sin_lam_cos_delta) + ratio_psi_u1_of_place_10
    let ratio_psi_u1_of_place_11 = rF
        * ratio_psi_u1_of_place_4.mul_add(ratio_psi_u1_of_place_9, -sin_lam_cos_delta)
        + ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = rF * ratio_psi_u1_of_place_8;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let c_cos_lam = c * cos_lam;
    // cos(phi)*(rR - ratio_psi_u1_of_w_lam_rr_rf*cos(lam + theta) - ratio_psi_u1_of_place_11*sin(lam +
    //   theta) + ratio_psi_u1_of_place_12*cos(phi)) +
    //   sin_delta_sin_phi*(rF*(ratio_psi_u1_of_place_8*sin_delta_sin_phi - sin(lam)) + c_cos_lam)
    let ratio_psi_u1_of_place_13 = cos_phi
        * ((-ratio_psi_u1_of_w_lam_rr_rf).mul_add(cos_lam_plus_theta, rR)
            - ratio_psi_u1_of_place_11 * sin_lam_plus_theta + ratio_psi_u1_of_place_12 * cos_phi)
        + sin_delta_sin_phi
            * (rF * ratio_psi_u1_of_place_8.mul_add(sin_delta_sin_phi, -sin_lam) + c_cos_lam);
    // w + c
    let w_plus_c = w + c;
    // c_cos_lam - rF*sin(lam)
    let ratio_psi_u1_of_c_lam_rf = (-rF).mul_add(sin_lam, c_cos_lam);
    // -ratio_psi_u1_of_c_lam_rf
    let ratio_psi_u1_of_c_lam_rf_2 = -ratio_psi_u1_of_c_lam_rf;
    // cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(rr_minus_rf*sin(lam +
    //   theta) + w_plus_c*cos(lam + theta))) + ratio_psi_u1_of_c_lam_rf_2*cos(lam + theta)
    let ratio_psi_u1_of_place_14 = cos_delta
        * (sin_lam * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
            + cos_lam * w_plus_c.mul_add(cos_lam_plus_theta, rr_minus_rf * sin_lam_plus_theta))
        + ratio_psi_u1_of_c_lam_rf_2 * cos_lam_plus_theta;
    // 1/(sin_delta_sin_phi*(rF*cos(lam) - rR*(cos(lam) - cos(lam + theta)) - w_sin_lam) +
    //   ratio_psi_u1_of_place_14*cos(phi))
    let ratio_psi_u1_of_place_15 = S::int(1)
        / (sin_delta_sin_phi * (-rR * (cos_lam - cos_lam_plus_theta) + rF * cos_lam - w_sin_lam)
            + ratio_psi_u1_of_place_14 * cos_phi);
    let ratio_psi_u1_of_place_16 = sin_phi * sin_lam_plus_theta;
    let ratio_psi_u1_of_place_17 = sin_psi * cos_lam_plus_theta;
    let cos_delta_cos_phi = cos_phi * cos_delta;
    // sin(delta)*(ratio_psi_u1_of_place_16*cos(psi) + ratio_psi_u1_of_place_17) -
    //   cos_delta_cos_phi*cos(psi)
    let ratio_psi_u1_of_place_18 = sin_delta
        * ratio_psi_u1_of_place_16.mul_add(cos_psi, ratio_psi_u1_of_place_17)
        - cos_delta_cos_phi * cos_psi;
    let ratio_psi_u1_of_place_19 = cos_psi * cos_lam_plus_theta;
    // cos_delta_cos_phi*sin(psi) + sin(delta)*(ratio_psi_u1_of_place_19 -
    //   ratio_psi_u1_of_place_16*sin(psi))
    let ratio_psi_u1_of_place_20 = sin_delta
        * (-ratio_psi_u1_of_place_16).mul_add(sin_psi, ratio_psi_u1_of_place_19)
        + cos_delta_cos_phi * sin_psi;
    // cos(phi)*sin(delta) + sin_phi_cos_delta*sin(lam + theta)
    let ratio_psi_u1_of_place_21 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let ratio_psi_u1_of_place_22 = ratio_psi_u1_of_place_2 * cos_delta;
    // sin_delta_sin_phi - ratio_psi_u1_of_place_22
    let ratio_psi_u1_of_place_23 = sin_delta_sin_phi - ratio_psi_u1_of_place_22;
    // sin_phi_cos_delta + ratio_psi_u1_of_place_3
    let ratio_psi_u1_of_place_24 = sin_phi_cos_delta + ratio_psi_u1_of_place_3;
    // 1/(ratio_psi_u1_of_place_24^2 - 1)
    let ratio_psi_u1_of_place_25 = S::int(1)
        / ratio_psi_u1_of_place_24.mul_add(ratio_psi_u1_of_place_24, -S::int(1));
    // rF*ratio_psi_u1_of_place_25*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)
    let ratio_psi_u1_of_place_26 = rF * ratio_psi_u1_of_place_25
        * (S::int(1) - (ratio_psi_u1_of_place_6 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_psi_u1_of_place_27 = ratio_psi_u1_of_place_23 * ratio_psi_u1_of_place_26;
    // -ratio_psi_u1_of_c_lam_rf - ratio_psi_u1_of_place_27
    let ratio_psi_u1_of_place_28 = -ratio_psi_u1_of_c_lam_rf - ratio_psi_u1_of_place_27;
    // sin_delta_sin_phi*sin(lam + theta) - cos_delta_cos_phi
    let ratio_psi_u1_of_place_29 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
    let ratio_psi_u1_of_place_30 = ratio_psi_u1_of_place_24 * ratio_psi_u1_of_place_26;
    let ratio_psi_u1_of_place_31 = ratio_psi_u1_of_place_25 * ratio_psi_u1_of_place_30;
    let ratio_psi_u1_of_place_32 = ratio_psi_u1_of_place_23 * ratio_psi_u1_of_place_31;
    let ratio_psi_u1_of_place_33 = cos_phi * cos_lam_plus_theta;
    let ratio_psi_u1_of_place_34 = sin_phi * cos_lam_plus_theta;
    let ratio_psi_u1_of_place_35 = ratio_psi_u1_of_place_26 * ratio_psi_u1_of_place_33;
    // ratio_psi_u1_of_w_lam_rr_rf - ratio_psi_u1_of_place_35
    let ratio_psi_u1_of_place_36 = ratio_psi_u1_of_w_lam_rr_rf - ratio_psi_u1_of_place_35;
    // w_plus_c*cos(lam) - rr_sin_lam
    let ratio_psi_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let rr_sin_phi = rR * sin_phi;
    // ratio_psi_u1_of_place_21*ratio_psi_u1_of_place_28 -
    //   ratio_psi_u1_of_place_23*(ratio_psi_u1_of_place_21*ratio_psi_u1_of_place_26 +
    //   ratio_psi_u1_of_place_29*ratio_psi_u1_of_place_32) +
    //   ratio_psi_u1_of_place_33*(ratio_psi_u1_of_place_26*ratio_psi_u1_of_place_34 -
    //   ratio_psi_u1_of_place_29*ratio_psi_u1_of_place_31*ratio_psi_u1_of_place_33) -
    //   ratio_psi_u1_of_place_34*ratio_psi_u1_of_place_36 +
    //   ratio_psi_u1_of_place_16*ratio_psi_u1_of_w_c_lam_rr + rr_sin_phi
    let ratio_psi_u1_of_place_37 = -ratio_psi_u1_of_place_23
        * ratio_psi_u1_of_place_29
            .mul_add(
                ratio_psi_u1_of_place_32,
                ratio_psi_u1_of_place_21 * ratio_psi_u1_of_place_26,
            ) + ratio_psi_u1_of_place_21 * ratio_psi_u1_of_place_28
        + ratio_psi_u1_of_place_33
            * (-(ratio_psi_u1_of_place_29 * ratio_psi_u1_of_place_31))
                .mul_add(
                    ratio_psi_u1_of_place_33,
                    ratio_psi_u1_of_place_26 * ratio_psi_u1_of_place_34,
                ) - ratio_psi_u1_of_place_34 * ratio_psi_u1_of_place_36
        + ratio_psi_u1_of_place_16 * ratio_psi_u1_of_w_c_lam_rr + rr_sin_phi;
    let ratio_psi_u1_of_place_38 = ratio_psi_u1_of_w_lam_rr_rf * sin_lam_plus_theta;
    let cos_phi_inv = S::int(1) / cos_phi;
    let ratio_psi_u1_of_place_39 = cos_lam_plus_theta * sin_delta;
    let cos_delta_sq = cos_delta * cos_delta;
    // ratio_psi_u1_of_place_15*(ratio_psi_u1_of_place_14*sin(phi) +
    //   sin(delta)*(cos(phi)*(ratio_psi_u1_of_place_12*ratio_psi_u1_of_place_33*(1 - sin(delta)^2) + sin(lam
    //   + theta)*(ratio_psi_u1_of_place_38 - ratio_psi_u1_of_place_11*cos(lam + theta))) -
    //   w_sin_lam*cos_phi_inv + cos(lam)*(c*sin_delta_sin_phi*cos(lam + theta) - rR*cos_phi_inv) +
    //   rF*(cos_phi_inv*cos(lam) + ratio_psi_u1_of_place_39*(ratio_psi_u1_of_place_9 -
    //   sin(lam)*sin(phi)))))/(ratio_psi_u1_of_place_38 - cos(lam + theta)*(ratio_psi_u1_of_place_10 +
    //   rF*(ratio_psi_u1_of_place_8*(sin(delta)*(ratio_psi_u1_of_place +
    //   ratio_psi_u1_of_place_5*(sin_phi_cos_delta*sin_delta_sin_phi^2 +
    //   cos(phi)*(sin_phi_cos_delta*ratio_psi_u1_of_place_33*cos(lam + theta) + sin(lam +
    //   theta)*(sin_phi_cos_delta*ratio_psi_u1_of_place_2*cos_delta_sq +
    //   sin(delta)*(sin(phi)*(sin(delta)*(sin_delta_sin_phi - 2*ratio_psi_u1_of_place_22) -
    //   ratio_psi_u1_of_place*cos(delta)) + cos(phi)^2*(cos(lam + theta)^2 + cos_delta_sq*sin(lam +
    //   theta)^2)))))) + 2*ratio_psi_u1_of_place_2*(1 - cos_delta_sq)) - sin_lam_cos_delta)))
    let ratio_psi_u1_of_place_40 = ratio_psi_u1_of_place_15
        * (sin_delta
            * (cos_phi
                * (ratio_psi_u1_of_place_12 * ratio_psi_u1_of_place_33
                    * (-sin_delta).mul_add(sin_delta, S::int(1))
                    + sin_lam_plus_theta
                        * (-ratio_psi_u1_of_place_11)
                            .mul_add(cos_lam_plus_theta, ratio_psi_u1_of_place_38))
                - w_sin_lam * cos_phi_inv
                + cos_lam
                    * (-rR)
                        .mul_add(cos_phi_inv, c * sin_delta_sin_phi * cos_lam_plus_theta)
                + rF
                    * (ratio_psi_u1_of_place_39
                        * (-sin_lam).mul_add(sin_phi, ratio_psi_u1_of_place_9)
                        + cos_phi_inv * cos_lam)) + ratio_psi_u1_of_place_14 * sin_phi)
        / (ratio_psi_u1_of_place_38
            - cos_lam_plus_theta
                * (ratio_psi_u1_of_place_10
                    + rF
                        * (ratio_psi_u1_of_place_8
                            * (sin_delta
                                * (ratio_psi_u1_of_place
                                    + ratio_psi_u1_of_place_5
                                        * (sin_phi_cos_delta * sin_delta_sin_phi * sin_delta_sin_phi
                                            + cos_phi
                                                * (sin_lam_plus_theta
                                                    * (sin_delta
                                                        * (sin_phi
                                                            * (sin_delta
                                                                * (-ratio_psi_u1_of_place_22)
                                                                    .mul_add(S::int(2), sin_delta_sin_phi)
                                                                - ratio_psi_u1_of_place * cos_delta)
                                                            + cos_phi * cos_phi
                                                                * cos_lam_plus_theta
                                                                    .mul_add(
                                                                        cos_lam_plus_theta,
                                                                        cos_delta_sq * sin_lam_plus_theta * sin_lam_plus_theta,
                                                                    ))
                                                        + sin_phi_cos_delta * ratio_psi_u1_of_place_2
                                                            * cos_delta_sq)
                                                    + sin_phi_cos_delta * ratio_psi_u1_of_place_33
                                                        * cos_lam_plus_theta)))
                                + S::int(2) * ratio_psi_u1_of_place_2
                                    * (S::int(1) - cos_delta_sq)) - sin_lam_cos_delta)));
    // ratio_psi_u1 = sin(psi)*(sin(phi)*sin(delta)*(c*cos(lam) - rF*(sin(lam) + sin(phi)*sin(delta)*sqrt(1
    //   - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))))) + cos(phi)*(rR -
    //   cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) + sin(lam +
    //   theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))))))*(sin(delta)*(cos(psi)*cos(lam + theta) - sin(psi)*sin(phi)*sin(lam +
    //   theta)) + sin(psi)*cos(phi)*cos(delta))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) -
    //   rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c))))) + cos(psi)*(sin(phi)*sin(delta)*(c*cos(lam) - rF*(sin(lam) +
    //   sin(phi)*sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))/(1 -
    //   sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta)
    //   + 2*sin(phi)*cos(delta))))) + cos(phi)*(rR - cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) +
    //   rF*cos(phi)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) + sin(lam +
    //   theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))))))*(cos(psi)*cos(phi)*cos(delta) - sin(delta)*(cos(psi)*sin(phi)*sin(lam +
    //   theta) + sin(psi)*cos(lam + theta)))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) -
    //   cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c))))) + (rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) -
    //   rR*sin(lam)) + (cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) -
    //   c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
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
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(sin(phi)*(cos(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam +
    //   theta)*(rR - rF) + cos(lam + theta)*(w + c)))) + sin(delta)*(cos(phi)*(sin(lam + theta)*(sin(lam +
    //   theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) -
    //   rR*sin(lam) + rF*(sin(lam)*cos(delta) + sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))/(1 -
    //   sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta)
    //   + 2*sin(phi)*cos(delta)))))) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(sin(delta)^2 - 1)/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))) -
    //   w*sin(lam)/cos(phi) + rF*(cos(lam)/cos(phi) - cos(lam + theta)*sin(delta)*(sin(lam)*sin(phi) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))))) +
    //   cos(lam)*(c*sin(phi)*cos(lam + theta)*sin(delta) - rR/cos(phi))))/((sin(lam + theta)*(w*sin(lam) +
    //   cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) +
    //   rF*(sin(lam)*cos(delta) + sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(sin(delta)*(2*sin(phi)*cos(delta) + (sin(phi)^3*sin(delta)^2*cos(delta) +
    //   cos(phi)*(sin(phi)*cos(phi)*cos(lam + theta)^2*cos(delta) + sin(lam +
    //   theta)*(sin(phi)*cos(phi)*sin(lam + theta)*cos(delta)^3 + sin(delta)*(cos(phi)^2*(cos(lam + theta)^2
    //   + sin(lam + theta)^2*cos(delta)^2) + sin(phi)*(sin(delta)*(sin(phi)*sin(delta) - 2*cos(phi)*sin(lam
    //   + theta)*cos(delta)) - 2*sin(phi)*cos(delta)^2)))))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam
    //   + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))) +
    //   2*cos(phi)*sin(lam + theta)*(1 - cos(delta)^2))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))))))*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam +
    //   theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam +
    //   theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))))
    let ratio_psi_u1 = ratio_psi_u1_of_place_13 * ratio_psi_u1_of_place_15
        * (-ratio_psi_u1_of_place_18)
            .mul_add(cos_psi, ratio_psi_u1_of_place_20 * sin_psi)
        + ratio_psi_u1_of_place_37 * ratio_psi_u1_of_place_40;
    // ratio_psi_u1_of_place_39*cos(psi) - ratio_psi_u1_of_place_29*sin(psi)
    let ratio_psi_u2_of_place = (-ratio_psi_u1_of_place_29)
        .mul_add(sin_psi, ratio_psi_u1_of_place_39 * cos_psi);
    // ratio_psi_u1_of_place_29*cos(psi) + ratio_psi_u1_of_place_39*sin(psi)
    let ratio_psi_u2_of_place_2 = ratio_psi_u1_of_place_39
        .mul_add(sin_psi, ratio_psi_u1_of_place_29 * cos_psi);
    let ratio_psi_u2_of_place_3 = ratio_psi_u1_of_place_33 * ratio_psi_u1_of_place_33;
    // ratio_psi_u1_of_place_24*ratio_psi_u1_of_place_28 -
    //   ratio_psi_u1_of_place_23*(ratio_psi_u1_of_place_30 +
    //   ratio_psi_u1_of_place_23*ratio_psi_u1_of_place_32) -
    //   ratio_psi_u1_of_place_32*ratio_psi_u2_of_place_3
    let ratio_psi_u2_of_place_4 = -ratio_psi_u1_of_place_23
        * ratio_psi_u1_of_place_23
            .mul_add(ratio_psi_u1_of_place_32, ratio_psi_u1_of_place_30)
        + ratio_psi_u1_of_place_24 * ratio_psi_u1_of_place_28
        - ratio_psi_u1_of_place_32 * ratio_psi_u2_of_place_3;
    // ratio_psi_u2 = (rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1))*(cos(psi)*cos(lam + theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta)))*(sin(delta)*(cos(psi)*cos(lam + theta) - sin(psi)*sin(phi)*sin(lam + theta)) +
    //   sin(psi)*cos(phi)*cos(delta))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) -
    //   cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c))))) + (rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1))*(sin(psi)*cos(lam + theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(sin(delta)*(cos(psi)*sin(phi)*sin(lam + theta) + sin(psi)*cos(lam + theta)) -
    //   cos(psi)*cos(phi)*cos(delta))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) -
    //   cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c))))) + (rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam +
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
    //   1)^2))*(sin(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam +
    //   theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))) +
    //   sin(delta)*(cos(phi)*(sin(lam + theta)*(sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam
    //   + theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))))) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(delta)^2 -
    //   1)/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))) - w*sin(lam)/cos(phi) + rF*(cos(lam)/cos(phi) - cos(lam
    //   + theta)*sin(delta)*(sin(lam)*sin(phi) + sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))))) +
    //   cos(lam)*(c*sin(phi)*cos(lam + theta)*sin(delta) - rR/cos(phi))))/((sin(lam + theta)*(w*sin(lam) +
    //   cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) +
    //   rF*(sin(lam)*cos(delta) + sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(sin(delta)*(2*sin(phi)*cos(delta) + (sin(phi)^3*sin(delta)^2*cos(delta) +
    //   cos(phi)*(sin(phi)*cos(phi)*cos(lam + theta)^2*cos(delta) + sin(lam +
    //   theta)*(sin(phi)*cos(phi)*sin(lam + theta)*cos(delta)^3 + sin(delta)*(cos(phi)^2*(cos(lam + theta)^2
    //   + sin(lam + theta)^2*cos(delta)^2) + sin(phi)*(sin(delta)*(sin(phi)*sin(delta) - 2*cos(phi)*sin(lam
    //   + theta)*cos(delta)) - 2*sin(phi)*cos(delta)^2)))))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam
    //   + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))) +
    //   2*cos(phi)*sin(lam + theta)*(1 - cos(delta)^2))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))))))*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam +
    //   theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam +
    //   theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))))
    let ratio_psi_u2 = ratio_psi_u1_of_place_15 * ratio_psi_u1_of_place_28
        * ratio_psi_u1_of_place_18
            .mul_add(
                ratio_psi_u2_of_place_2,
                ratio_psi_u1_of_place_20 * ratio_psi_u2_of_place,
            ) + ratio_psi_u1_of_place_40 * ratio_psi_u2_of_place_4;
    // ratio_psi_u3 = rR*cos(lam + theta)*sin(delta)/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) -
    //   rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_15 * ratio_psi_u1_of_place_39;
    let ratio_theta_u1_of_place = ratio_psi_u1_of_place_33 * ratio_psi_u1_of_w_c_lam_rr;
    // ratio_psi_u1_of_place_2*ratio_psi_u1_of_place_26 +
    //   ratio_psi_u1_of_place_31*ratio_psi_u2_of_place_3*sin(delta)
    let ratio_theta_u1_of_place_2 = (ratio_psi_u1_of_place_31 * ratio_psi_u2_of_place_3)
        .mul_add(sin_delta, ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_26);
    // 1/(ratio_psi_u1_of_place_2*ratio_psi_u1_of_place_36 -
    //   ratio_psi_u1_of_place_23*(ratio_psi_u1_of_place_32*ratio_psi_u1_of_place_33*sin(delta) +
    //   ratio_psi_u1_of_place_35*cos(delta)) + ratio_theta_u1_of_place +
    //   ratio_psi_u1_of_place_33*(ratio_psi_u1_of_place_28*cos(delta) - ratio_theta_u1_of_place_2))
    let ratio_theta_u1_of_place_3 = S::int(1)
        / (-ratio_psi_u1_of_place_23
            * ratio_psi_u1_of_place_35
                .mul_add(
                    cos_delta,
                    ratio_psi_u1_of_place_32 * ratio_psi_u1_of_place_33 * sin_delta,
                ) + ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_36 + ratio_theta_u1_of_place
            + ratio_psi_u1_of_place_33
                * ratio_psi_u1_of_place_28
                    .mul_add(cos_delta, -ratio_theta_u1_of_place_2));
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
    let ratio_theta_u1 = ratio_psi_u1_of_place_37 * ratio_theta_u1_of_place_3;
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
    let ratio_theta_u2 = ratio_psi_u2_of_place_4 * ratio_theta_u1_of_place_3;
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place = ratio_psi_u1_of_place_15 * ratio_psi_u1_of_place_7;
    let ratio_thF_u1_of_place_2 = rf_inv * ratio_thF_u1_of_place;
    // ratio_psi_u1_of_place_19*cos(delta) - ratio_psi_u1_of_place_21*sin(psi)
    let ratio_thF_u1_of_place_3 = (-ratio_psi_u1_of_place_21)
        .mul_add(sin_psi, ratio_psi_u1_of_place_19 * cos_delta);
    // ratio_psi_u1_of_w_lam_rr_rf*ratio_psi_u1_of_place_24 -
    //   ratio_psi_u1_of_place_30*ratio_psi_u1_of_place_33
    let ratio_thF_u1_of_place_4 = (-ratio_psi_u1_of_place_30)
        .mul_add(
            ratio_psi_u1_of_place_33,
            ratio_psi_u1_of_w_lam_rr_rf * ratio_psi_u1_of_place_24,
        );
    // ratio_psi_u1_of_c_lam_rf_2*ratio_psi_u1_of_place_33 -
    //   ratio_psi_u1_of_w_lam_rr_rf*ratio_psi_u1_of_place_23
    let ratio_thF_u1_of_place_5 = (-ratio_psi_u1_of_w_lam_rr_rf)
        .mul_add(
            ratio_psi_u1_of_place_23,
            ratio_psi_u1_of_c_lam_rf_2 * ratio_psi_u1_of_place_33,
        );
    // cos(psi)*sin(lam + theta) + ratio_psi_u1_of_place_34*sin(psi)
    let ratio_thF_u1_of_place_6 = ratio_psi_u1_of_place_34
        .mul_add(sin_psi, cos_psi * sin_lam_plus_theta);
    // ratio_psi_u1_of_c_lam_rf_2*ratio_psi_u1_of_place_24 -
    //   ratio_psi_u1_of_place_23*ratio_psi_u1_of_place_30
    let ratio_thF_u1_of_place_7 = (-ratio_psi_u1_of_place_23)
        .mul_add(
            ratio_psi_u1_of_place_30,
            ratio_psi_u1_of_c_lam_rf_2 * ratio_psi_u1_of_place_24,
        );
    // ratio_psi_u1_of_w_c_lam_rr*sin(phi) + ratio_thF_u1_of_place_7
    let ratio_thF_u1_of_place_8 = ratio_psi_u1_of_w_c_lam_rr
        .mul_add(sin_phi, ratio_thF_u1_of_place_7);
    let ratio_thF_u1_of_place_9 = ratio_theta_u1_of_place * cos_phi;
    // rr_sin_phi*cos(psi) - ratio_thF_u1_of_place_3*ratio_thF_u1_of_place_4 +
    //   ratio_psi_u2_of_place*ratio_thF_u1_of_place_5 + ratio_thF_u1_of_place_6*ratio_thF_u1_of_place_8 +
    //   ratio_thF_u1_of_place_9*sin(psi)
    let ratio_thF_u1_of_place_10 = (-ratio_thF_u1_of_place_3)
        .mul_add(ratio_thF_u1_of_place_4, rr_sin_phi * cos_psi)
        + ratio_psi_u2_of_place * ratio_thF_u1_of_place_5
        + ratio_thF_u1_of_place_6 * ratio_thF_u1_of_place_8 + ratio_thF_u1_of_place_9 * sin_psi;
    // ratio_psi_u1_of_place_17*cos(delta) + ratio_psi_u1_of_place_21*cos(psi)
    let ratio_thF_u1_of_place_11 = ratio_psi_u1_of_place_21
        .mul_add(cos_psi, ratio_psi_u1_of_place_17 * cos_delta);
    // sin(psi)*sin(lam + theta) - ratio_psi_u1_of_place_34*cos(psi)
    let ratio_thF_u1_of_place_12 = (-ratio_psi_u1_of_place_34)
        .mul_add(cos_psi, sin_psi * sin_lam_plus_theta);
    // rr_sin_phi*sin(psi) + ratio_psi_u2_of_place_2*ratio_thF_u1_of_place_5 -
    //   ratio_thF_u1_of_place_9*cos(psi) - ratio_thF_u1_of_place_4*ratio_thF_u1_of_place_11 +
    //   ratio_thF_u1_of_place_8*ratio_thF_u1_of_place_12
    let ratio_thF_u1_of_place_13 = ratio_psi_u2_of_place_2
        .mul_add(ratio_thF_u1_of_place_5, rr_sin_phi * sin_psi) - ratio_thF_u1_of_place_9 * cos_psi
        - ratio_thF_u1_of_place_4 * ratio_thF_u1_of_place_11
        + ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_12;
    // -ratio_psi_u1_of_place_36*cos(delta)
    let ratio_thF_u1_of_place_14 = -ratio_psi_u1_of_place_36 * cos_delta;
    let ratio_thF_u1_of_place_15 = ratio_psi_u1_of_place_36 * sin_delta;
    // cos(delta)*(ratio_psi_u1_of_c_lam_rf_2 - ratio_psi_u1_of_place_27) + ratio_psi_u1_of_w_c_lam_rr
    let ratio_thF_u1_of_place_16 = cos_delta
        * (ratio_psi_u1_of_c_lam_rf_2 - ratio_psi_u1_of_place_27) + ratio_psi_u1_of_w_c_lam_rr;
    // ratio_thF_u1_of_place_2*(ratio_thF_u1_of_place_10*(ratio_thF_u1_of_place_11*ratio_thF_u1_of_place_14
    //   - ratio_psi_u2_of_place_2*ratio_thF_u1_of_place_15 +
    //   ratio_thF_u1_of_place_12*ratio_thF_u1_of_place_16) +
    //   ratio_thF_u1_of_place_13*(ratio_psi_u2_of_place*ratio_thF_u1_of_place_15 -
    //   ratio_thF_u1_of_place_3*ratio_thF_u1_of_place_14 -
    //   ratio_thF_u1_of_place_6*ratio_thF_u1_of_place_16))
    let ratio_thF_u1_of_place_17 = ratio_thF_u1_of_place_2
        * (ratio_thF_u1_of_place_10
            * ((-ratio_psi_u2_of_place_2)
                .mul_add(
                    ratio_thF_u1_of_place_15,
                    ratio_thF_u1_of_place_11 * ratio_thF_u1_of_place_14,
                ) + ratio_thF_u1_of_place_12 * ratio_thF_u1_of_place_16)
            + ratio_thF_u1_of_place_13
                * ((-ratio_thF_u1_of_place_3)
                    .mul_add(
                        ratio_thF_u1_of_place_14,
                        ratio_psi_u2_of_place * ratio_thF_u1_of_place_15,
                    ) - ratio_thF_u1_of_place_6 * ratio_thF_u1_of_place_16));
    // ratio_thF_u1 = sin(psi)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(sin(phi)*sin(delta)*(c*cos(lam) - rF*(sin(lam) + sin(phi)*sin(delta)*sqrt(1
    //   - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))))) + cos(phi)*(rR -
    //   cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) + sin(lam +
    //   theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))))))*((sin(psi)*cos(lam + theta)*cos(delta) + cos(psi)*(cos(phi)*sin(delta) +
    //   sin(phi)*sin(lam + theta)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) -
    //   rR*sin(psi)*sin(phi) - cos(psi)*cos(phi)^2*cos(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) -
    //   sin(phi)*(cos(lam)*(w + c) - rR*sin(lam))*(sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam +
    //   theta)) - (sin(psi)*cos(lam + theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) -
    //   (sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) -
    //   c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) -
    //   cos(psi)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(phi)*sin(delta)*(c*cos(lam) - rF*(sin(lam) +
    //   sin(phi)*sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))/(1 -
    //   sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta)
    //   + 2*sin(phi)*cos(delta))))) + cos(phi)*(rR - cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) +
    //   rF*cos(phi)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) + sin(lam +
    //   theta)*(cos(lam)*(w + c*(1 - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))))))*(rR*cos(psi)*sin(phi) + sin(psi)*cos(phi)^2*cos(lam +
    //   theta)*(cos(lam)*(w + c) - rR*sin(lam)) + sin(phi)*(cos(lam)*(w + c) -
    //   rR*sin(lam))*(cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam + theta)) + (cos(psi)*cos(lam +
    //   theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta)))*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) +
    //   (sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta)) - cos(psi)*cos(lam +
    //   theta)*cos(delta))*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) -
    //   w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam +
    //   theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
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
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2))*(((sin(psi)*cos(lam + theta)*cos(delta) +
    //   cos(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR -
    //   rF))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)) - rR*sin(psi)*sin(phi) - cos(psi)*cos(phi)^2*cos(lam + theta)*(rR*sin(lam)
    //   - cos(lam)*(w + c)) - sin(phi)*(cos(lam)*(w + c) - rR*sin(lam))*(sin(psi)*sin(lam + theta) -
    //   cos(psi)*sin(phi)*cos(lam + theta)) - (sin(psi)*cos(lam + theta)*sin(delta) +
    //   cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta)))*(cos(phi)*cos(lam +
    //   theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))) - (sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam +
    //   theta))*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))*((cos(lam)*(w + c) - rR*sin(lam))*(cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam +
    //   theta)) + (cos(psi)*cos(lam + theta)*cos(delta) - sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - (cos(psi)*cos(lam +
    //   theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta)))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta))*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))) + (rR*cos(psi)*sin(phi) + sin(psi)*cos(phi)^2*cos(lam +
    //   theta)*(cos(lam)*(w + c) - rR*sin(lam)) + sin(phi)*(cos(lam)*(w + c) -
    //   rR*sin(lam))*(cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam + theta)) + (cos(psi)*cos(lam +
    //   theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta)))*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) +
    //   (sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta)) - cos(psi)*cos(lam +
    //   theta)*cos(delta))*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))*((cos(lam)*(w + c) -
    //   rR*sin(lam))*(sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam + theta)) + (sin(psi)*cos(lam +
    //   theta)*cos(delta) + cos(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - (sin(psi)*cos(lam +
    //   theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (sin(psi)*sin(lam + theta) -
    //   cos(psi)*sin(phi)*cos(lam + theta))*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) -
    //   cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))*(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
    //   cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
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
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)))
    let ratio_thF_u1 = -ratio_psi_u1_of_place_13 * ratio_thF_u1_of_place_2
        * ratio_thF_u1_of_place_13.mul_add(sin_psi, ratio_thF_u1_of_place_10 * cos_psi)
        + ratio_theta_u1 * ratio_thF_u1_of_place_17;
    // ratio_thF_u2 = sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(rF*sin(lam) -
    //   c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1))*(sin(psi)*cos(lam + theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(rR*cos(psi)*sin(phi) + sin(psi)*cos(phi)^2*cos(lam + theta)*(cos(lam)*(w + c)
    //   - rR*sin(lam)) + sin(phi)*(cos(lam)*(w + c) - rR*sin(lam))*(cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta)) + (cos(psi)*cos(lam + theta)*sin(delta) +
    //   sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta)))*(cos(phi)*cos(lam +
    //   theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))) + (sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)) - cos(psi)*cos(lam + theta)*cos(delta))*((w*sin(lam) + cos(lam)*(rR -
    //   rF))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))/(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)) + (cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam +
    //   theta))*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1
    //   - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(c*cos(lam) - rF*sin(lam) - rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))*(cos(psi)*cos(lam + theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) -
    //   sin(phi)*sin(lam + theta)*sin(delta)))*(rR*sin(psi)*sin(phi) + cos(psi)*cos(phi)^2*cos(lam +
    //   theta)*(rR*sin(lam) - cos(lam)*(w + c)) + sin(phi)*(cos(lam)*(w + c) -
    //   rR*sin(lam))*(sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam + theta)) + (sin(psi)*cos(lam +
    //   theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) -
    //   (sin(psi)*cos(lam + theta)*cos(delta) + cos(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (sin(psi)*sin(lam + theta) -
    //   cos(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) -
    //   w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) -
    //   c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam +
    //   theta)*(rR - rF) + cos(lam + theta)*(w + c)))))) + sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam +
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
    //   1)^2))*(((sin(psi)*cos(lam + theta)*cos(delta) + cos(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) - rR*sin(psi)*sin(phi) -
    //   cos(psi)*cos(phi)^2*cos(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) - sin(phi)*(cos(lam)*(w + c) -
    //   rR*sin(lam))*(sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam + theta)) - (sin(psi)*cos(lam +
    //   theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) -
    //   (sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) -
    //   c*cos(lam))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 -
    //   1)))*((cos(lam)*(w + c) - rR*sin(lam))*(cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam +
    //   theta)) + (cos(psi)*cos(lam + theta)*cos(delta) - sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - (cos(psi)*cos(lam +
    //   theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta)))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta))*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))) + (rR*cos(psi)*sin(phi) + sin(psi)*cos(phi)^2*cos(lam +
    //   theta)*(cos(lam)*(w + c) - rR*sin(lam)) + sin(phi)*(cos(lam)*(w + c) -
    //   rR*sin(lam))*(cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam + theta)) + (cos(psi)*cos(lam +
    //   theta)*sin(delta) + sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam +
    //   theta)*sin(delta)))*(cos(phi)*cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + (w*sin(lam) +
    //   cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))) +
    //   (sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam + theta)*cos(delta)) - cos(psi)*cos(lam +
    //   theta)*cos(delta))*((w*sin(lam) + cos(lam)*(rR - rF))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) - c*cos(lam))*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) + rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)))*((cos(lam)*(w + c) -
    //   rR*sin(lam))*(sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam + theta)) + (sin(psi)*cos(lam +
    //   theta)*cos(delta) + cos(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) - cos(delta)*(w*sin(lam) + cos(lam)*(rR - rF))) - (sin(psi)*cos(lam +
    //   theta)*sin(delta) + cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) -
    //   cos(phi)*cos(delta)))*(sin(delta)*(w*sin(lam) + cos(lam)*(rR - rF)) + rF*cos(phi)*cos(lam +
    //   theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (sin(psi)*sin(lam + theta) -
    //   cos(psi)*sin(phi)*cos(lam + theta))*(cos(delta)*(rF*sin(lam) - c*cos(lam)) + rF*cos(delta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1))))/(rF*(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) -
    //   cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))*(cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
    //   cos(phi)*cos(lam + theta)*cos(delta)*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
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
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)))
    let ratio_thF_u2 = ratio_psi_u1_of_place_28 * ratio_thF_u1_of_place_2
        * (-ratio_psi_u2_of_place)
            .mul_add(
                ratio_thF_u1_of_place_13,
                ratio_psi_u2_of_place_2 * ratio_thF_u1_of_place_10,
            ) + ratio_theta_u2 * ratio_thF_u1_of_place_17;
    // ratio_thF_u3 = rR*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(sin(lam +
    //   theta)*(cos(lam) - (w*sin(lam) + rR*cos(lam))/rF) - cos(lam + theta)*(sin(lam)*cos(delta) +
    //   sin(delta)*sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam
    //   + theta)*sin(delta) + 2*sin(phi)*cos(delta)))*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) + (cos(lam)*(w +
    //   c*(1 - cos(delta))) - rR*sin(lam))/rF))/(sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) -
    //   rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) +
    //   cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR -
    //   rF) + cos(lam + theta)*(w + c)))))
    let ratio_thF_u3 = rR * ratio_thF_u1_of_place
        * (sin_lam_plus_theta * (cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam))
            + cos_lam_plus_theta
                * (ratio_psi_u1_of_place_9
                    .mul_add(ratio_psi_u1_of_place_24, -sin_lam_cos_delta)
                    + ratio_psi_u1_of_place_10 * rf_inv));
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
    // thF' = u1*ratio_thF_u1 + u2*ratio_thF_u2 - u3*ratio_thF_u3
    let thF_dot_value = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1) - u3 * ratio_thF_u3;
    [
        x_dot_value, y_dot_value, psi_dot_value, phi_dot_value, theta_dot_value, delta_dot_value,
        thR_dot_value, thF_dot_value,
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 139 operations, 4 sines and cosines, 2 other functions.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 8], _q_dot: &[S; 8]) -> [S; 6] {
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
    let divisor2_of_place = S::int(2) * sin_phi_cos_delta;
    // sin_phi_cos_delta^2 + divisor1_of_place_2*(divisor1_of_place_2 + divisor2_of_place)
    let divisor2_of_place_2 = divisor1_of_place_2 * (divisor1_of_place_2 + divisor2_of_place)
        + sin_phi_cos_delta * sin_phi_cos_delta;
    // 1 - divisor2_of_place_2
    let divisor2_of_place_3 = S::int(1) - divisor2_of_place_2;
    // rR - rF
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    // rr_minus_rf*cos(lam) + w_sin_lam
    let divisor4_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    // -1/divisor2_of_place_3
    let divisor4_of_place = -S::int(1) / divisor2_of_place_3;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let divisor4_of_place_2 = divisor1_of_place * cos_delta;
    let cos_delta_sq = cos_delta * cos_delta;
    let divisor4_of_place_3 = cos_phi * cos_lam_plus_theta;
    let rr_sin_lam = rR * sin_lam;
    // w + c
    let w_plus_c = w + c;
    // rF*sin(lam) - c*cos(lam)
    let divisor5_of_c_lam_rf = (-c).mul_add(cos_lam, rF * sin_lam);
    // sin_delta_sin_phi - divisor4_of_place_2
    let divisor6_of_place = sin_delta_sin_phi - divisor4_of_place_2;
    // -1/divisor1_of_place_4
    let divisor6_of_place_2 = -S::int(1) / divisor1_of_place_4;
    let divisor4_of_place_4 = cos_phi * sin_lam_plus_theta * sin_delta;
    // rF*divisor6_of_place_2*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)
    let divisor6_of_place_3 = rF * divisor6_of_place_2
        * (S::int(1) - (divisor4_of_place_4 + sin_phi_cos_delta).powi(2)).sqrt();
    let divisor6_of_place_4 = divisor4_of_place_3 * divisor6_of_place_3;
    let divisor6_of_place_5 = divisor1_of_place_3 * divisor6_of_place_2
        * divisor6_of_place_4 * sin_delta;
    // w_plus_c*cos(lam) - rr_sin_lam
    let divisor6_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    // divisor1_of_place*divisor6_of_place_3 + divisor4_of_place_3*divisor6_of_place_5
    let divisor6_of_place_6 = divisor4_of_place_3
        .mul_add(divisor6_of_place_5, divisor1_of_place * divisor6_of_place_3);
    // cos(delta)*(divisor5_of_c_lam_rf - divisor6_of_place*divisor6_of_place_3) + divisor6_of_w_c_lam_rr
    let divisor6_of_place_7 = cos_delta
        * (-divisor6_of_place).mul_add(divisor6_of_place_3, divisor5_of_c_lam_rf)
        + divisor6_of_w_c_lam_rr;
    // Values.
    // divisor1 = (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1
    let divisor1 = -divisor1_of_place_4;
    // divisor2 = sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + 2*sin(phi)*cos(delta))
    let divisor2 = -divisor2_of_place_3;
    // divisor3 = cos(phi)
    let divisor3 = cos_phi;
    // divisor4 = sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF)) + cos(lam + theta)*(cos(lam)*(w + c*(1
    //   - cos(delta))) - rR*sin(lam) + rF*(sin(lam)*cos(delta) + sqrt(1 - sin(phi)^2*cos(delta)^2 -
    //   cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   2*sin(phi)*cos(delta)))*(sin(delta)*(2*sin(phi)*cos(delta) + (sin(phi)^3*sin(delta)^2*cos(delta) +
    //   cos(phi)*(sin(phi)*cos(phi)*cos(lam + theta)^2*cos(delta) + sin(lam +
    //   theta)*(sin(phi)*cos(phi)*sin(lam + theta)*cos(delta)^3 + sin(delta)*(cos(phi)^2*(cos(lam + theta)^2
    //   + sin(lam + theta)^2*cos(delta)^2) + sin(phi)*(sin(delta)*(sin(phi)*sin(delta) - 2*cos(phi)*sin(lam
    //   + theta)*cos(delta)) - 2*sin(phi)*cos(delta)^2)))))/(sin(phi)^2*cos(delta)^2 - 1 + cos(phi)*sin(lam
    //   + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))) +
    //   2*cos(phi)*sin(lam + theta)*(1 - cos(delta)^2))/(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam +
    //   theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta)))))
    let divisor4 = cos_lam_plus_theta
        * (cos_lam * (w + c * (S::int(1) - cos_delta))
            + rF
                * (-divisor4_of_place
                    * (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
                        - cos_phi * sin_lam_plus_theta * sin_delta
                            * sin_phi_cos_delta.mul_add(S::int(2), divisor4_of_place_4))
                        .sqrt()
                    * (S::int(2) * divisor1_of_place * (S::int(1) - cos_delta_sq)
                        + sin_delta
                            * (divisor2_of_place
                                + divisor4_of_place
                                    * (sin_phi_cos_delta * sin_delta_sin_phi * sin_delta_sin_phi
                                        + cos_phi
                                            * (sin_lam_plus_theta
                                                * (sin_delta
                                                    * (sin_phi
                                                        * (sin_delta
                                                            * (-divisor4_of_place_2)
                                                                .mul_add(S::int(2), sin_delta_sin_phi)
                                                            - divisor2_of_place * cos_delta)
                                                        + cos_phi * cos_phi
                                                            * cos_lam_plus_theta
                                                                .mul_add(
                                                                    cos_lam_plus_theta,
                                                                    cos_delta_sq * sin_lam_plus_theta * sin_lam_plus_theta,
                                                                )) + sin_phi_cos_delta * divisor1_of_place * cos_delta_sq)
                                                + sin_phi_cos_delta * divisor4_of_place_3
                                                    * cos_lam_plus_theta)))) + sin_lam * cos_delta)
            - rr_sin_lam) + divisor4_of_w_lam_rr_rf * sin_lam_plus_theta;
    // divisor5 = sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) +
    //   cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) -
    //   rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c))))
    let divisor5 = sin_delta_sin_phi
        * (-rR * (cos_lam - cos_lam_plus_theta) + rF * cos_lam - w_sin_lam)
        + cos_phi
            * (cos_delta
                * (sin_lam * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
                    + cos_lam
                        * w_plus_c
                            .mul_add(
                                cos_lam_plus_theta,
                                rr_minus_rf * sin_lam_plus_theta,
                            )) + divisor5_of_c_lam_rf * cos_lam_plus_theta);
    // divisor6 = cos(phi)*cos(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) + cos(phi)*cos(lam +
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
    let divisor6 = divisor1_of_place * (divisor4_of_w_lam_rr_rf - divisor6_of_place_4)
        - divisor6_of_place
            * divisor6_of_place
                .mul_add(divisor6_of_place_5, divisor6_of_place_4 * cos_delta)
        + divisor4_of_place_3 * (divisor6_of_place_7 - divisor6_of_place_6);
    [divisor1, divisor2, divisor3, divisor4, divisor5, divisor6]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 166 operations, 5 sines and cosines, 1 other function.
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
    let residual2_of_place_2 = sin_phi * cos_lam_plus_theta;
    // theta'*residual1_of_place + phi'*residual2_of_place_2
    let residual2_of_motion_6 = phi_dot
        .mul_add(residual2_of_place_2, theta_dot * residual1_of_place);
    let rr_sin_phi = rR * sin_phi;
    let rr_thr_dot = rR * thR_dot;
    let residual5_of_place = cos_lam_plus_theta * sin_delta;
    // phi'*residual5_of_place - psi'*residual1_of_place_3
    let residual5_of_motion = (-psi_dot)
        .mul_add(residual1_of_place_3, phi_dot * residual5_of_place);
    // theta'*cos(delta) - residual5_of_motion
    let residual5_of_motion_2 = theta_dot.mul_add(cos_delta, -residual5_of_motion);
    // thF' + residual5_of_motion_2
    let residual5_of_motion_3 = thF_dot + residual5_of_motion_2;
    // residual1_of_w_lam_rr_rf*residual5_of_motion_2 - residual1_of_place_9*residual5_of_motion_3
    let residual5_of_motion_4 = (-residual1_of_place_9)
        .mul_add(
            residual5_of_motion_3,
            residual1_of_w_lam_rr_rf * residual5_of_motion_2,
        );
    // residual2_of_place*cos(delta) + sin_delta_cos_phi
    let residual5_of_place_2 = residual2_of_place.mul_add(cos_delta, sin_delta_cos_phi);
    let residual5_of_place_3 = cos_lam_plus_theta * cos_delta;
    // phi'*sin(lam + theta) + psi'*residual1_of_place_8
    let residual5_of_motion_5 = psi_dot
        .mul_add(residual1_of_place_8, phi_dot * sin_lam_plus_theta);
    // -residual1_of_c_lam_rf
    let residual5_of_c_lam_rf = -residual1_of_c_lam_rf;
    // (delta' + residual5_of_motion_5)*(residual5_of_c_lam_rf - residual1_of_place_6) -
    //   residual1_of_place_10*(theta'*sin(delta) + psi'*residual1_of_place_2 + phi'*residual5_of_place_3)
    let residual5_of_motion_6 = (delta_dot + residual5_of_motion_5)
        * (residual5_of_c_lam_rf - residual1_of_place_6)
        - residual1_of_place_10
            * (psi_dot.mul_add(residual1_of_place_2, theta_dot * sin_delta)
                + phi_dot * residual5_of_place_3);
    // residual2_of_place*sin(delta) - cos_delta_cos_phi
    let residual5_of_place_4 = residual2_of_place.mul_add(sin_delta, -cos_delta_cos_phi);
    // residual5_of_motion_2*residual5_of_c_lam_rf - residual1_of_place_6*residual5_of_motion_3
    let residual5_of_motion_7 = (-residual1_of_place_6)
        .mul_add(residual5_of_motion_3, residual5_of_motion_2 * residual5_of_c_lam_rf);
    // residual1_of_w_c_lam_rr*(psi'*sin(phi) + theta') + residual5_of_motion_7
    let residual5_of_motion_8 = residual1_of_w_c_lam_rr
        * psi_dot.mul_add(sin_phi, theta_dot) + residual5_of_motion_7;
    // cos(phi)*(rR*phi' + residual1_of_w_c_lam_rr*residual5_of_motion_5)
    let residual5_of_motion_9 = cos_phi
        * residual1_of_w_c_lam_rr.mul_add(residual5_of_motion_5, rR * phi_dot);
    let psi_dot_rr_sin_phi = psi_dot * rr_sin_phi;
    // Values.
    // contact = cos(phi)*sin(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) - rR*cos(phi) +
    //   (sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + cos(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2))
    let residual1 = (-rR).mul_add(cos_phi, residual1_of_place_2 * residual1_of_place_7)
        + residual1_of_place_8 * residual1_of_place_10
        - residual1_of_place * residual1_of_w_c_lam_rr;
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
    // rear_1 = x' + rR*thR'*cos(psi)
    let residual3 = rr_thr_dot.mul_add(cos_psi, x_dot);
    // rear_2 = y' + rR*thR'*sin(psi)
    let residual4 = rr_thr_dot.mul_add(sin_psi, y_dot);
    // front_1 = x' - rR*psi'*cos(psi)*sin(phi) - rR*phi'*sin(psi)*cos(phi) +
    //   sin(psi)*cos(phi)*(rR*sin(lam) - cos(lam)*(w + c))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam +
    //   theta)) + (rR*sin(lam) - cos(lam)*(w + c))*(cos(psi)*sin(lam + theta) + sin(psi)*sin(phi)*cos(lam +
    //   theta))*(psi'*sin(phi) + theta') + (cos(psi)*cos(lam + theta)*sin(delta) +
    //   sin(psi)*(cos(phi)*cos(delta) - sin(phi)*sin(lam + theta)*sin(delta)))*((w*sin(lam) + cos(lam)*(rR -
    //   rF))*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta)) + phi'*cos(lam +
    //   theta)*cos(delta) + theta'*sin(delta)) - rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta)) + phi'*cos(lam + theta)*cos(delta) + theta'*sin(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - (rF*sin(lam) - c*cos(lam))*(psi'*cos(phi)*cos(lam
    //   + theta) + phi'*sin(lam + theta) + delta') - rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam + theta) +
    //   delta')/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (cos(psi)*cos(lam +
    //   theta)*cos(delta) - sin(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR - rF))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) -
    //   phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) + thF')/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) - (cos(psi)*sin(lam + theta) +
    //   sin(psi)*sin(phi)*cos(lam + theta))*((rF*sin(lam) - c*cos(lam))*(psi'*(cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta)) +
    //   rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) +
    //   thF')/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1))
    let residual5 = x_dot
        + residual5_of_motion_4
            * (-residual5_of_place_2).mul_add(sin_psi, residual5_of_place_3 * cos_psi)
        + residual5_of_motion_6
            * (-residual5_of_place).mul_add(cos_psi, residual5_of_place_4 * sin_psi)
        - residual5_of_motion_8
            * residual2_of_place_2.mul_add(sin_psi, cos_psi * sin_lam_plus_theta)
        - residual5_of_motion_9 * sin_psi - psi_dot_rr_sin_phi * cos_psi;
    // front_2 = y' - rR*psi'*sin(psi)*sin(phi) + rR*phi'*cos(psi)*cos(phi) +
    //   cos(psi)*cos(phi)*(cos(lam)*(w + c) - rR*sin(lam))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam +
    //   theta)) + (rR*sin(lam) - cos(lam)*(w + c))*(sin(psi)*sin(lam + theta) - cos(psi)*sin(phi)*cos(lam +
    //   theta))*(psi'*sin(phi) + theta') + (sin(psi)*cos(lam + theta)*sin(delta) +
    //   cos(psi)*(sin(phi)*sin(lam + theta)*sin(delta) - cos(phi)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR -
    //   rF))*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta)) + phi'*cos(lam +
    //   theta)*cos(delta) + theta'*sin(delta)) - rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(psi'*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta)) + phi'*cos(lam + theta)*cos(delta) + theta'*sin(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) - (rF*sin(lam) - c*cos(lam))*(psi'*cos(phi)*cos(lam
    //   + theta) + phi'*sin(lam + theta) + delta') - rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))*(psi'*cos(phi)*cos(lam + theta) + phi'*sin(lam + theta) +
    //   delta')/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) + (sin(psi)*cos(lam +
    //   theta)*cos(delta) + cos(psi)*(cos(phi)*sin(delta) + sin(phi)*sin(lam +
    //   theta)*cos(delta)))*((w*sin(lam) + cos(lam)*(rR - rF))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta)) + rF*cos(phi)*cos(lam +
    //   theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta)) -
    //   phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) + thF')/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (cos(psi)*sin(phi)*cos(lam + theta) -
    //   sin(psi)*sin(lam + theta))*((rF*sin(lam) - c*cos(lam))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta)) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))*(psi'*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta)) - phi'*cos(lam + theta)*sin(delta) + theta'*cos(delta) +
    //   thF')/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1))
    let residual6 = y_dot
        + residual5_of_motion_4
            * residual5_of_place_3.mul_add(sin_psi, residual5_of_place_2 * cos_psi)
        - residual5_of_motion_6
            * residual5_of_place_4.mul_add(cos_psi, residual5_of_place * sin_psi)
        + residual5_of_motion_8
            * (-sin_psi).mul_add(sin_lam_plus_theta, residual2_of_place_2 * cos_psi)
        + residual5_of_motion_9 * cos_psi - psi_dot_rr_sin_phi * sin_psi;
    [residual1, residual2, residual3, residual4, residual5, residual6]
}

/// Slopes of the constraints, one after the other, along x, y, psi, phi, theta, delta, thR, thF, x', y', psi', phi', theta', delta', thR', thF'.
///
/// 546 operations, 5 sines and cosines, 2 other functions.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    q_dot: &[S; 8],
) -> [S; 96] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [_, _, psi_dot, phi_dot, theta_dot, delta_dot, thR_dot, thF_dot] = *q_dot;
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
    let residual1_by_phi_of_place = sin_phi * sin_lam_plus_theta;
    let rr_sin_phi = rR * sin_phi;
    let residual1_by_phi_of_place_2 = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let residual1_by_phi_of_place_3 = (-residual1_by_phi_of_place_2)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let residual1_by_phi_of_place_4 = residual1_by_phi_of_place
        .mul_add(cos_delta, cos_phi * sin_delta);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let residual1_by_phi_of_place_5 = residual1_by_phi_of_place_2 * sin_delta;
    let residual1_by_phi_of_place_6 = sin_phi_cos_delta + residual1_by_phi_of_place_5;
    let residual1_by_phi_of_place_7 = S::int(1)
        / residual1_by_phi_of_place_6.mul_add(residual1_by_phi_of_place_6, -S::int(1));
    let residual1_by_phi_of_place_8 = cos_phi * sin_lam_plus_theta * sin_delta;
    let residual1_by_phi_of_place_9 = rF * residual1_by_phi_of_place_7
        * (S::int(1) - (residual1_by_phi_of_place_8 + sin_phi_cos_delta).powi(2)).sqrt();
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let residual1_by_phi_of_place_10 = residual1_by_phi_of_place
        .mul_add(sin_delta, -cos_delta_cos_phi);
    let residual1_by_phi_of_place_11 = residual1_by_phi_of_place_6 * residual1_by_phi_of_place_7;
    let residual1_by_phi_of_place_12 = residual1_by_phi_of_place_9 * residual1_by_phi_of_place_11;
    let residual1_by_phi_of_place_13 = residual1_by_phi_of_place_3 * residual1_by_phi_of_place_12;
    let residual1_by_phi_of_place_14 = residual1_by_phi_of_place_10
        .mul_add(
            residual1_by_phi_of_place_13,
            residual1_by_phi_of_place_4 * residual1_by_phi_of_place_9,
        );
    let residual1_by_phi_of_place_15 = residual1_by_phi_of_place_3 * residual1_by_phi_of_place_9;
    let c_cos_lam = c * cos_lam;
    let residual1_by_phi_of_c_lam_rf = (-rF).mul_add(sin_lam, c_cos_lam);
    let residual1_by_phi_of_place_16 = -residual1_by_phi_of_place_15 - residual1_by_phi_of_c_lam_rf;
    let residual1_by_phi_of_w_lam_rr_rf = cos_lam * (rR - rF) + w * sin_lam;
    let residual1_by_phi_of_place_17 = cos_phi * cos_lam_plus_theta;
    let residual1_by_phi_of_place_18 = residual1_by_phi_of_place_9 * residual1_by_phi_of_place_17;
    let residual1_by_phi_of_place_19 = residual1_by_phi_of_w_lam_rr_rf
        - residual1_by_phi_of_place_18;
    let residual1_by_phi_of_place_20 = sin_phi * cos_lam_plus_theta;
    let residual1_by_phi_of_place_21 = residual1_by_phi_of_place_11 * residual1_by_phi_of_place_18;
    let residual1_by_phi_of_place_22 = (-residual1_by_phi_of_place_9)
        .mul_add(
            residual1_by_phi_of_place_20,
            residual1_by_phi_of_place_10 * residual1_by_phi_of_place_21,
        );
    let residual1_by_phi_of_place_23 = -residual1_by_phi_of_place_22;
    let residual1_by_phi_of_place_24 = (-residual1_by_phi_of_place_4)
        .mul_add(
            residual1_by_phi_of_place_16,
            residual1_by_phi_of_place_3 * residual1_by_phi_of_place_14,
        );
    let residual1_by_phi_of_place_25 = (-residual1_by_phi_of_place_17)
        .mul_add(
            residual1_by_phi_of_place_23,
            residual1_by_phi_of_place_19 * residual1_by_phi_of_place_20,
        );
    let residual1_by_phi_of_place_26 = residual1_by_phi_of_w_c_lam_rr
        .mul_add(residual1_by_phi_of_place, rr_sin_phi);
    let residual1_by_phi_of_place_27 = residual1_by_phi_of_place_24 + residual1_by_phi_of_place_25;
    let residual1_by_phi_of_place_28 = residual1_by_phi_of_place_26 - residual1_by_phi_of_place_27;
    let residual1_by_theta_of_place = residual1_by_phi_of_place_3 * residual1_by_phi_of_place_21;
    let residual1_by_theta_of_place_2 = residual1_by_theta_of_place
        .mul_add(sin_delta, residual1_by_phi_of_place_18 * cos_delta);
    let residual1_by_theta_of_place_3 = residual1_by_phi_of_place_17 * cos_delta;
    let residual1_by_theta_of_place_4 = residual1_by_phi_of_place_17 * sin_delta;
    let residual1_by_theta_of_place_5 = residual1_by_phi_of_place_21
        .mul_add(
            residual1_by_theta_of_place_4,
            residual1_by_phi_of_place_2 * residual1_by_phi_of_place_9,
        );
    let residual1_by_theta_of_place_6 = residual1_by_phi_of_w_c_lam_rr
        - residual1_by_theta_of_place_5;
    let residual1_by_theta_of_place_7 = (-residual1_by_phi_of_place_3)
        .mul_add(
            residual1_by_theta_of_place_2,
            residual1_by_phi_of_place_16 * residual1_by_theta_of_place_3,
        );
    let residual1_by_theta_of_place_8 = residual1_by_phi_of_place_17
        .mul_add(
            residual1_by_theta_of_place_6,
            residual1_by_phi_of_place_2 * residual1_by_phi_of_place_19,
        );
    let residual1_by_theta_of_place_9 = residual1_by_theta_of_place_7
        + residual1_by_theta_of_place_8;
    let residual1_by_delta_of_place = residual1_by_phi_of_place_3
        .mul_add(
            residual1_by_phi_of_place_13,
            residual1_by_phi_of_place_6 * residual1_by_phi_of_place_9,
        );
    let residual1_by_delta_of_place_2 = (-residual1_by_phi_of_place_3)
        .mul_add(
            residual1_by_delta_of_place,
            residual1_by_phi_of_place_6 * residual1_by_phi_of_place_16,
        );
    let residual1_by_delta_of_place_3 = residual1_by_phi_of_place_17
        .mul_add(residual1_by_theta_of_place, -residual1_by_delta_of_place_2);
    let residual2_by_phi_of_motion = theta_dot
        .mul_add(residual1_by_phi_of_place_20, phi_dot * residual1_by_phi_of_place_2);
    let residual2_by_phi_of_motion_2 = (-phi_dot)
        .mul_add(sin_delta_sin_phi, residual2_by_phi_of_motion * cos_delta)
        - delta_dot * residual1_by_phi_of_place_10;
    let residual2_by_phi_of_phi_dot = phi_dot * residual1_by_phi_of_place;
    let residual2_by_phi_of_motion_3 = (-theta_dot)
        .mul_add(residual1_by_phi_of_place_17, residual2_by_phi_of_phi_dot);
    let phi_dot_cos_phi = phi_dot * cos_phi;
    let residual2_by_phi_of_motion_4 = delta_dot
        .mul_add(residual1_by_phi_of_place_2, phi_dot_cos_phi);
    let residual2_by_phi_of_motion_5 = residual2_by_phi_of_motion_3
        .mul_add(cos_delta, delta_dot * sin_phi_cos_delta)
        + residual2_by_phi_of_motion_4 * sin_delta;
    let residual2_by_phi_of_motion_6 = (-delta_dot)
        .mul_add(sin_delta_sin_phi, residual2_by_phi_of_motion_4 * cos_delta)
        - residual2_by_phi_of_motion_3 * sin_delta;
    let residual2_by_phi_of_motion_7 = (-residual1_by_phi_of_place_13)
        .mul_add(
            residual2_by_phi_of_motion_6,
            residual1_by_phi_of_place_9 * residual2_by_phi_of_motion_5,
        );
    let residual2_by_phi_of_motion_8 = phi_dot
        .mul_add(sin_phi_cos_delta, delta_dot * residual1_by_phi_of_place_4)
        + residual2_by_phi_of_motion * sin_delta;
    let residual2_by_phi_of_motion_9 = residual1_by_phi_of_place_12 * residual2_by_phi_of_motion_6;
    let residual2_by_phi_of_place = residual1_by_phi_of_place_10 * residual1_by_phi_of_place_12;
    let residual2_by_phi_of_motion_10 = residual2_by_phi_of_motion_6
        * (residual1_by_phi_of_place_7
            - S::int(3) * residual1_by_phi_of_place_11 * residual1_by_phi_of_place_11);
    let residual2_by_phi_of_motion_11 = residual1_by_phi_of_place_15
        * residual2_by_phi_of_motion_10;
    let residual2_by_phi_of_motion_12 = phi_dot
        .mul_add(residual1_by_phi_of_place_20, theta_dot * residual1_by_phi_of_place_2);
    let residual2_by_phi_of_motion_13 = residual1_by_phi_of_place_21 * residual2_by_phi_of_motion_6;
    let residual2_by_phi_of_motion_14 = residual1_by_phi_of_place_9
        .mul_add(residual2_by_phi_of_motion_12, residual2_by_phi_of_motion_13);
    let residual2_by_phi_of_motion_15 = residual1_by_phi_of_place_18
        * residual2_by_phi_of_motion_10;
    let residual2_by_phi_of_theta_dot = theta_dot * residual1_by_phi_of_place;
    let residual2_by_phi_of_motion_16 = (-residual1_by_phi_of_place_21)
        .mul_add(residual2_by_phi_of_motion_8, phi_dot * residual1_by_phi_of_place_18)
        - residual1_by_phi_of_place_20 * residual2_by_phi_of_motion_9
        + residual2_by_phi_of_place * residual2_by_phi_of_motion_12
        - residual1_by_phi_of_place_10 * residual2_by_phi_of_motion_15
        - residual1_by_phi_of_place_9 * residual2_by_phi_of_theta_dot;
    let residual2_by_theta_of_motion = residual2_by_phi_of_motion_12
        .mul_add(cos_delta, delta_dot * residual1_by_theta_of_place_4);
    let residual2_by_theta_of_motion_2 = residual2_by_phi_of_motion_12 * sin_delta;
    let residual2_by_theta_of_motion_3 = delta_dot
        .mul_add(residual1_by_theta_of_place_3, -residual2_by_theta_of_motion_2);
    let residual2_by_theta_of_motion_4 = residual1_by_phi_of_place_3
        .mul_add(
            residual2_by_phi_of_motion_15,
            residual1_by_phi_of_place_21 * residual2_by_phi_of_motion_5,
        );
    let rr_sin_psi = rR * sin_psi;
    let rr_cos_psi = rR * cos_psi;
    let residual5_by_psi_of_place = cos_lam_plus_theta * sin_delta;
    let residual5_by_psi_of_motion = (-psi_dot)
        .mul_add(residual1_by_phi_of_place_6, phi_dot * residual5_by_psi_of_place);
    let residual5_by_psi_of_motion_2 = theta_dot
        .mul_add(cos_delta, -residual5_by_psi_of_motion);
    let residual5_by_psi_of_motion_3 = thF_dot + residual5_by_psi_of_motion_2;
    let residual5_by_psi_of_motion_4 = (-residual1_by_phi_of_place_18)
        .mul_add(
            residual5_by_psi_of_motion_3,
            residual1_by_phi_of_w_lam_rr_rf * residual5_by_psi_of_motion_2,
        );
    let residual5_by_psi_of_place_2 = cos_lam_plus_theta * cos_delta;
    let residual5_by_psi_of_place_3 = residual5_by_psi_of_place_2
        .mul_add(sin_psi, residual1_by_phi_of_place_4 * cos_psi);
    let residual5_by_psi_of_motion_5 = psi_dot
        .mul_add(residual1_by_phi_of_place_17, phi_dot * sin_lam_plus_theta);
    let residual5_by_psi_of_motion_6 = delta_dot + residual5_by_psi_of_motion_5;
    let residual5_by_psi_of_c_lam_rf = -residual1_by_phi_of_c_lam_rf;
    let residual5_by_psi_of_place_4 = residual1_by_phi_of_place_15 - residual5_by_psi_of_c_lam_rf;
    let residual5_by_psi_of_motion_7 = psi_dot
        .mul_add(residual1_by_phi_of_place_3, theta_dot * sin_delta)
        + phi_dot * residual5_by_psi_of_place_2;
    let residual5_by_psi_of_motion_8 = residual1_by_phi_of_place_19 * residual5_by_psi_of_motion_7;
    let residual5_by_psi_of_motion_9 = (-residual5_by_psi_of_motion_6)
        .mul_add(residual5_by_psi_of_place_4, -residual5_by_psi_of_motion_8);
    let residual5_by_psi_of_place_5 = residual5_by_psi_of_place
        .mul_add(sin_psi, residual1_by_phi_of_place_10 * cos_psi);
    let residual5_by_psi_of_place_6 = (-residual1_by_phi_of_place_20)
        .mul_add(cos_psi, sin_psi * sin_lam_plus_theta);
    let psi_dot_sin_phi = psi_dot * sin_phi;
    let residual5_by_psi_of_motion_10 = (-residual1_by_phi_of_place_15)
        .mul_add(
            residual5_by_psi_of_motion_3,
            residual5_by_psi_of_motion_2 * residual5_by_psi_of_c_lam_rf,
        );
    let residual5_by_psi_of_motion_11 = residual1_by_phi_of_w_c_lam_rr
        * (theta_dot + psi_dot_sin_phi) + residual5_by_psi_of_motion_10;
    let residual5_by_psi_of_motion_12 = residual1_by_phi_of_w_c_lam_rr
        .mul_add(residual5_by_psi_of_motion_5, rR * phi_dot);
    let residual5_by_psi_of_motion_13 = residual5_by_psi_of_motion_12 * cos_phi;
    let psi_dot_rr_sin_phi = psi_dot * rr_sin_phi;
    let residual5_by_phi_of_place = (-residual1_by_phi_of_place_4)
        .mul_add(sin_psi, residual5_by_psi_of_place_2 * cos_psi);
    let residual5_by_phi_of_psi_dot = psi_dot * residual1_by_phi_of_place_10;
    let residual5_by_phi_of_motion = residual1_by_phi_of_place_19
        .mul_add(
            residual5_by_phi_of_psi_dot,
            residual1_by_phi_of_place_22 * residual5_by_psi_of_motion_3,
        );
    let residual5_by_phi_of_place_2 = (-residual1_by_phi_of_place_10)
        .mul_add(sin_psi, residual5_by_psi_of_place * cos_psi);
    let residual5_by_phi_of_motion_2 = psi_dot
        * (-residual1_by_phi_of_place_20)
            .mul_add(
                residual5_by_psi_of_place_4,
                residual1_by_phi_of_place_4 * residual1_by_phi_of_place_19,
            ) + residual1_by_phi_of_place_14 * residual5_by_psi_of_motion_6
        - residual1_by_phi_of_place_22 * residual5_by_psi_of_motion_7;
    let residual5_by_phi_of_place_3 = residual1_by_phi_of_place_20
        .mul_add(sin_psi, cos_psi * sin_lam_plus_theta);
    let residual5_by_phi_of_motion_3 = (-residual5_by_psi_of_place_4)
        .mul_add(
            residual5_by_phi_of_psi_dot,
            residual1_by_phi_of_place_14 * residual5_by_psi_of_motion_3,
        );
    let residual5_by_phi_of_motion_4 = (residual1_by_phi_of_w_c_lam_rr
        * residual1_by_phi_of_place_17)
        .mul_add(
            psi_dot_sin_phi,
            residual1_by_phi_of_place_3 * residual5_by_psi_of_motion_4,
        );
    let residual5_by_phi_of_motion_5 = (-residual1_by_phi_of_place_17)
        .mul_add(
            residual5_by_psi_of_motion_11,
            residual1_by_phi_of_place_6 * residual5_by_psi_of_motion_9,
        );
    let residual5_by_phi_of_motion_6 = residual5_by_psi_of_motion_12
        .mul_add(sin_phi, residual5_by_phi_of_motion_4);
    let residual5_by_phi_of_motion_7 = residual5_by_phi_of_motion_5 + residual5_by_phi_of_motion_6;
    let residual5_by_phi_of_place_4 = residual1_by_phi_of_w_c_lam_rr
        .mul_add(residual5_by_phi_of_place_3, rr_cos_psi);
    let psi_dot_cos_phi = psi_dot * cos_phi;
    let residual5_by_theta_of_motion = residual5_by_psi_of_motion_5 * sin_delta;
    let residual5_by_theta_of_motion_2 = residual1_by_phi_of_place_19
        .mul_add(
            residual5_by_theta_of_motion,
            residual1_by_theta_of_place_5 * residual5_by_psi_of_motion_3,
        );
    let residual5_by_theta_of_motion_3 = (-phi_dot)
        .mul_add(cos_lam_plus_theta, psi_dot * residual1_by_phi_of_place_2);
    let residual5_by_theta_of_motion_4 = (-(residual1_by_phi_of_place_19
        * residual5_by_psi_of_motion_5))
        .mul_add(cos_delta, residual1_by_theta_of_place_5 * residual5_by_psi_of_motion_7)
        - residual1_by_theta_of_place_2 * residual5_by_psi_of_motion_6
        - residual5_by_psi_of_place_4 * residual5_by_theta_of_motion_3;
    let residual5_by_theta_of_motion_5 = (-residual5_by_psi_of_place_4)
        .mul_add(
            residual5_by_theta_of_motion,
            residual1_by_theta_of_place_2 * residual5_by_psi_of_motion_3,
        );
    let residual5_by_theta_of_place = (-residual1_by_phi_of_place)
        .mul_add(sin_psi, cos_psi * cos_lam_plus_theta);
    let residual5_by_theta_of_place_2 = residual1_by_phi_of_w_c_lam_rr * cos_phi;
    let residual5_by_theta_of_place_3 = residual5_by_theta_of_place_2 * sin_psi;
    let residual5_by_delta_of_motion = (-residual5_by_psi_of_place_4)
        .mul_add(
            residual5_by_psi_of_motion_7,
            residual1_by_delta_of_place * residual5_by_psi_of_motion_3,
        );
    let residual5_by_delta_of_motion_2 = residual1_by_delta_of_place
        .mul_add(
            residual5_by_psi_of_motion_6,
            residual1_by_phi_of_place_19 * residual5_by_psi_of_motion_2,
        ) - residual1_by_theta_of_place * residual5_by_psi_of_motion_7;
    let residual5_by_delta_of_motion_3 = residual5_by_psi_of_motion_4
        - residual5_by_delta_of_motion_2;
    let residual5_by_delta_of_motion_4 = residual1_by_theta_of_place
        .mul_add(residual5_by_psi_of_motion_3, residual5_by_psi_of_motion_8);
    let residual5_by_delta_of_motion_5 = residual5_by_psi_of_motion_9
        + residual5_by_delta_of_motion_4;
    let residual5_by_psi_dot_of_place = residual1_by_phi_of_place_6 * residual1_by_phi_of_place_19;
    let residual5_by_psi_dot_of_place_2 = (-residual1_by_phi_of_place_3)
        .mul_add(
            residual1_by_phi_of_w_lam_rr_rf,
            residual1_by_phi_of_place_17 * residual5_by_psi_of_c_lam_rf,
        );
    let residual5_by_psi_dot_of_place_3 = -residual1_by_phi_of_place_6
        * residual5_by_psi_of_place_4;
    let residual5_by_phi_dot_of_place = sin_phi_cos_delta
        .mul_add(S::int(2), residual1_by_phi_of_place_5);
    let residual5_by_phi_dot_of_place_2 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), residual1_by_phi_of_place_8))
        .sqrt()
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + residual1_by_phi_of_place_5 * residual5_by_phi_dot_of_place);
    let residual5_by_phi_dot_of_place_3 = rF * residual5_by_phi_dot_of_place_2;
    let residual5_by_phi_dot_of_place_4 = sin_delta_sin_phi
        * (c_cos_lam + rF * sin_delta_sin_phi.mul_add(residual5_by_phi_dot_of_place_2, -sin_lam))
        + cos_phi
            * (rR - residual1_by_phi_of_w_lam_rr_rf * cos_lam_plus_theta
                + sin_lam_plus_theta
                    * (cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam
                        + rF
                            * (-(residual5_by_phi_dot_of_place * residual5_by_phi_dot_of_place_2))
                                .mul_add(sin_delta, sin_lam * cos_delta))
                + residual5_by_phi_dot_of_place_3 * cos_phi);
    let residual5_by_theta_dot_of_place = -residual1_by_phi_of_place_19 * cos_delta;
    let residual5_by_theta_dot_of_place_2 = residual1_by_phi_of_place_19 * sin_delta;
    let residual5_by_theta_dot_of_place_3 = -residual5_by_psi_of_place_4 * cos_delta;
    let residual5_by_theta_dot_of_place_4 = residual1_by_phi_of_w_c_lam_rr
        + residual5_by_theta_dot_of_place_3;
    let residual5_by_thF_dot_of_place = residual1_by_phi_of_place
        .mul_add(cos_psi, sin_psi * cos_lam_plus_theta);
    let residual6_by_phi_of_place = residual1_by_phi_of_w_c_lam_rr
        .mul_add(residual5_by_psi_of_place_6, rr_sin_psi);
    let residual6_by_theta_of_place = residual5_by_theta_of_place_2 * cos_psi;
    let residual1_by_theta_of_place_10 = -residual1_by_theta_of_place_9;
    let residual1_by_delta_of_place_4 = -residual1_by_delta_of_place_3;
    // Values.
    let residual1_by_phi = residual1_by_phi_of_place_28;
    let residual1_by_theta = residual1_by_theta_of_place_10;
    let residual1_by_delta = residual1_by_delta_of_place_4;
    let residual2_by_phi = residual1_by_phi_of_w_c_lam_rr * residual2_by_phi_of_motion
        + residual1_by_phi_of_place_16 * residual2_by_phi_of_motion_2 + rR * phi_dot_cos_phi
        - residual1_by_phi_of_place_14 * residual2_by_phi_of_motion_5
        - residual1_by_phi_of_place_4 * residual2_by_phi_of_motion_7
        + residual1_by_phi_of_place_3
            * ((-residual1_by_phi_of_place_9)
                .mul_add(
                    residual2_by_phi_of_motion_2,
                    residual1_by_phi_of_place_4 * residual2_by_phi_of_motion_9,
                ) - residual1_by_phi_of_place_13 * residual2_by_phi_of_motion_8
                - residual2_by_phi_of_motion_5 * residual2_by_phi_of_place
                - residual1_by_phi_of_place_10 * residual2_by_phi_of_motion_11)
        - residual1_by_phi_of_place_23 * residual2_by_phi_of_motion_12
        - residual1_by_phi_of_place_20 * residual2_by_phi_of_motion_14
        + residual1_by_phi_of_place_19 * residual2_by_phi_of_theta_dot
        + residual1_by_phi_of_place_17
            * (-phi_dot)
                .mul_add(residual1_by_phi_of_place_19, residual2_by_phi_of_motion_16);
    let residual2_by_theta = residual1_by_phi_of_place_19 * residual2_by_phi_of_motion_3
        + residual1_by_theta_of_place_2 * residual2_by_phi_of_motion_5
        + residual1_by_theta_of_place_3 * residual2_by_phi_of_motion_7
        + residual1_by_theta_of_place_6 * residual2_by_phi_of_motion_12
        - residual1_by_phi_of_place_2 * residual2_by_phi_of_motion_14
        + residual1_by_phi_of_place_16 * residual2_by_theta_of_motion
        + residual1_by_phi_of_place_17
            * (theta_dot * residual1_by_phi_of_place_18
                - residual1_by_phi_of_place_9 * residual2_by_phi_of_phi_dot
                - residual1_by_phi_of_place_2 * residual2_by_phi_of_motion_9
                + residual1_by_theta_of_place_4 * residual2_by_phi_of_motion_15
                + residual1_by_phi_of_place_21
                    * (residual2_by_theta_of_motion_3 - residual2_by_theta_of_motion_2))
        + residual1_by_phi_of_place_3
            * ((-residual2_by_phi_of_motion_13)
                .mul_add(
                    cos_delta,
                    residual1_by_phi_of_place_13 * residual2_by_theta_of_motion_3,
                ) - residual1_by_phi_of_place_9 * residual2_by_theta_of_motion
                + residual2_by_theta_of_motion_4 * sin_delta);
    let residual2_by_delta = residual1_by_phi_of_place_16 * residual2_by_phi_of_motion_6
        - residual1_by_delta_of_place * residual2_by_phi_of_motion_5
        - residual1_by_phi_of_place_6 * residual2_by_phi_of_motion_7
        + residual1_by_phi_of_place_3
            * ((-(residual1_by_phi_of_place_13 * residual2_by_phi_of_motion_5))
                .mul_add(
                    S::int(2),
                    residual1_by_phi_of_place_6 * residual2_by_phi_of_motion_9,
                ) - residual1_by_phi_of_place_9 * residual2_by_phi_of_motion_6
                - residual1_by_phi_of_place_3 * residual2_by_phi_of_motion_11)
        + residual1_by_theta_of_place * residual2_by_phi_of_motion_12
        + residual1_by_phi_of_place_17
            * residual1_by_phi_of_place_13
                .mul_add(residual2_by_phi_of_motion_12, -residual2_by_theta_of_motion_4);
    let residual2_by_phi_dot = residual1_by_phi_of_place_28;
    let residual2_by_theta_dot = residual1_by_theta_of_place_10;
    let residual2_by_delta_dot = residual1_by_delta_of_place_4;
    let residual3_by_psi = -thR_dot * rr_sin_psi;
    let residual3_by_x_dot = S::int(1);
    let residual3_by_thR_dot = rr_cos_psi;
    let residual4_by_psi = thR_dot * rr_cos_psi;
    let residual4_by_y_dot = S::int(1);
    let residual4_by_thR_dot = rr_sin_psi;
    let residual5_by_psi = (-residual5_by_psi_of_motion_4)
        .mul_add(
            residual5_by_psi_of_place_3,
            residual5_by_psi_of_motion_9 * residual5_by_psi_of_place_5,
        ) + residual5_by_psi_of_place_6 * residual5_by_psi_of_motion_11
        - residual5_by_psi_of_motion_13 * cos_psi + psi_dot_rr_sin_phi * sin_psi;
    let residual5_by_phi = (-residual5_by_phi_of_place)
        .mul_add(
            residual5_by_phi_of_motion,
            residual5_by_phi_of_place_2 * residual5_by_phi_of_motion_2,
        ) + residual5_by_phi_of_place_3 * residual5_by_phi_of_motion_3
        + residual5_by_phi_of_motion_7 * sin_psi - residual5_by_phi_of_place_4 * psi_dot_cos_phi;
    let residual5_by_theta = (-(residual5_by_psi_of_motion_4 * residual5_by_phi_of_place_3))
        .mul_add(
            cos_delta,
            residual5_by_psi_of_motion_9 * residual5_by_phi_of_place_3 * sin_delta,
        ) + residual5_by_phi_of_place * residual5_by_theta_of_motion_2
        + residual5_by_phi_of_place_2 * residual5_by_theta_of_motion_4
        - residual5_by_phi_of_place_3 * residual5_by_theta_of_motion_5
        - residual5_by_psi_of_motion_11 * residual5_by_theta_of_place
        + residual5_by_theta_of_motion_3 * residual5_by_theta_of_place_3;
    let residual5_by_delta = (-residual5_by_phi_of_place_2)
        .mul_add(
            residual5_by_delta_of_motion_3,
            residual5_by_phi_of_place_3 * residual5_by_delta_of_motion,
        ) - residual5_by_phi_of_place * residual5_by_delta_of_motion_5;
    let residual5_by_x_dot = S::int(1);
    let residual5_by_psi_dot = (-residual5_by_phi_of_place_4)
        .mul_add(sin_phi, residual5_by_phi_of_place * residual5_by_psi_dot_of_place)
        - residual1_by_phi_of_place_17 * residual5_by_theta_of_place_3
        - residual5_by_phi_of_place_2 * residual5_by_psi_dot_of_place_2
        - residual5_by_phi_of_place_3 * residual5_by_psi_dot_of_place_3;
    let residual5_by_phi_dot = -residual5_by_phi_dot_of_place_4 * sin_psi;
    let residual5_by_theta_dot = (-residual5_by_phi_of_place)
        .mul_add(
            residual5_by_theta_dot_of_place,
            residual5_by_phi_of_place_2 * residual5_by_theta_dot_of_place_2,
        ) - residual5_by_phi_of_place_3 * residual5_by_theta_dot_of_place_4;
    let residual5_by_delta_dot = -residual1_by_phi_of_place_16 * residual5_by_phi_of_place_2;
    let residual5_by_thF_dot = residual5_by_phi_dot_of_place_3
        * (-cos_delta_cos_phi)
            .mul_add(cos_psi, residual5_by_thF_dot_of_place * sin_delta);
    let residual6_by_psi = (-residual5_by_psi_of_motion_13)
        .mul_add(sin_psi, residual5_by_psi_of_motion_4 * residual5_by_phi_of_place)
        - psi_dot_rr_sin_phi * cos_psi - residual5_by_psi_of_motion_9 * residual5_by_phi_of_place_2
        - residual5_by_psi_of_motion_11 * residual5_by_phi_of_place_3;
    let residual6_by_phi = (-residual5_by_psi_of_place_3)
        .mul_add(
            residual5_by_phi_of_motion,
            residual5_by_psi_of_place_5 * residual5_by_phi_of_motion_2,
        ) + residual5_by_psi_of_place_6 * residual5_by_phi_of_motion_3
        - residual5_by_phi_of_motion_7 * cos_psi - psi_dot_cos_phi * residual6_by_phi_of_place;
    let residual6_by_theta = (-(residual5_by_psi_of_motion_4 * residual5_by_psi_of_place_6))
        .mul_add(
            cos_delta,
            residual5_by_psi_of_motion_9 * residual5_by_psi_of_place_6 * sin_delta,
        ) + residual5_by_psi_of_place_3 * residual5_by_theta_of_motion_2
        + residual5_by_psi_of_place_5 * residual5_by_theta_of_motion_4
        - residual5_by_psi_of_place_6 * residual5_by_theta_of_motion_5
        - residual5_by_psi_of_motion_11 * residual5_by_thF_dot_of_place
        - residual5_by_theta_of_motion_3 * residual6_by_theta_of_place;
    let residual6_by_delta = (-residual5_by_psi_of_place_5)
        .mul_add(
            residual5_by_delta_of_motion_3,
            residual5_by_psi_of_place_6 * residual5_by_delta_of_motion,
        ) - residual5_by_psi_of_place_3 * residual5_by_delta_of_motion_5;
    let residual6_by_y_dot = S::int(1);
    let residual6_by_psi_dot = (-residual5_by_psi_of_place_5)
        .mul_add(
            residual5_by_psi_dot_of_place_2,
            residual5_by_psi_of_place_3 * residual5_by_psi_dot_of_place,
        ) - residual5_by_psi_of_place_6 * residual5_by_psi_dot_of_place_3
        - residual6_by_phi_of_place * sin_phi
        + residual1_by_phi_of_place_17 * residual6_by_theta_of_place;
    let residual6_by_phi_dot = residual5_by_phi_dot_of_place_4 * cos_psi;
    let residual6_by_theta_dot = (-residual5_by_psi_of_place_3)
        .mul_add(
            residual5_by_theta_dot_of_place,
            residual5_by_psi_of_place_5 * residual5_by_theta_dot_of_place_2,
        ) - residual5_by_psi_of_place_6 * residual5_by_theta_dot_of_place_4;
    let residual6_by_delta_dot = -residual1_by_phi_of_place_16 * residual5_by_psi_of_place_5;
    let residual6_by_thF_dot = -residual5_by_phi_dot_of_place_3
        * residual5_by_theta_of_place.mul_add(sin_delta, cos_delta_cos_phi * sin_psi);
    let zero = S::int(0);
    [
        zero, zero, zero, residual1_by_phi, residual1_by_theta, residual1_by_delta, zero, zero,
        zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, residual2_by_phi,
        residual2_by_theta, residual2_by_delta, zero, zero, zero, zero, zero, residual2_by_phi_dot,
        residual2_by_theta_dot, residual2_by_delta_dot, zero, zero, zero, zero, residual3_by_psi,
        zero, zero, zero, zero, zero, residual3_by_x_dot, zero, zero, zero, zero, zero,
        residual3_by_thR_dot, zero, zero, zero, residual4_by_psi, zero, zero, zero, zero, zero,
        zero, residual4_by_y_dot, zero, zero, zero, zero, residual4_by_thR_dot, zero, zero, zero,
        residual5_by_psi, residual5_by_phi, residual5_by_theta, residual5_by_delta, zero, zero,
        residual5_by_x_dot, zero, residual5_by_psi_dot, residual5_by_phi_dot,
        residual5_by_theta_dot, residual5_by_delta_dot, zero, residual5_by_thF_dot, zero, zero,
        residual6_by_psi, residual6_by_phi, residual6_by_theta, residual6_by_delta, zero, zero,
        zero, residual6_by_y_dot, residual6_by_psi_dot, residual6_by_phi_dot,
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
        6
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1",
            "divisor 2 of the accelerations",
            "cos(phi)",
            "divisor 4 of the accelerations",
            "divisor 5 of the accelerations",
            "divisor 6 of the accelerations",
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
    slice.try_into().expect("a slice of the length that System states")
}
