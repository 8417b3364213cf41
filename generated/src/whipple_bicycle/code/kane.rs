//! Whipple bicycle: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3.
///
/// 839 operations, 6 sines and cosines, 2 other functions.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    _u: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters {
        w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx, IHxz,
        IHyy, IHzz, rF, mF, IFxx, IFyy,
        ..
    } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    // Sines and cosines.
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let ratio_theta_u1_of_c_lam_rf = (-rF).mul_add(sin_lam, c * cos_lam);
    let ratio_psi_u1_of_c_lam_rf = -ratio_theta_u1_of_c_lam_rf;
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_theta_u1_of_place = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let ratio_theta_u1_of_place_2 = (-ratio_theta_u1_of_place)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let ratio_theta_u1_of_place_3 = ratio_theta_u1_of_place * sin_delta;
    let ratio_theta_u1_of_place_4 = sin_phi_cos_delta + ratio_theta_u1_of_place_3;
    let ratio_theta_u1_of_place_5 = S::int(1)
        / ratio_theta_u1_of_place_4.mul_add(ratio_theta_u1_of_place_4, -S::int(1));
    let ratio_theta_u1_of_place_6 = cos_phi * sin_lam_plus_theta * sin_delta;
    let ratio_theta_u1_of_place_7 = rF * ratio_theta_u1_of_place_5
        * (S::int(1) - (ratio_theta_u1_of_place_6 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_theta_u1_of_place_8 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_7;
    let ratio_psi_u1_of_place = ratio_theta_u1_of_place_8 - ratio_psi_u1_of_c_lam_rf;
    let ratio_psi_u1_of_place_2 = cos_lam_plus_theta * sin_delta;
    let ratio_psi_u1_of_place_3 = -ratio_psi_u1_of_place * ratio_psi_u1_of_place_2;
    let ratio_theta_u1_of_place_9 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_10 = ratio_theta_u1_of_place_7 * ratio_theta_u1_of_place_9;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_10;
    let ratio_psi_u1_of_place_4 = -ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_5 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_6 = (-ratio_psi_u1_of_place)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5);
    let ratio_psi_u1_of_place_7 = -ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_4;
    let ratio_psi_u1_of_place_8 = -ratio_psi_u1_of_place_4 * sin_delta;
    let ratio_psi_u1_of_place_9 = ratio_psi_u1_of_place_4 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_10 = -ratio_psi_u1_of_place * cos_delta;
    let ratio_psi_u1_of_place_11 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = (-ratio_psi_u1_of_place_2)
        .mul_add(
            ratio_psi_u1_of_place_8,
            ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_9,
        ) + ratio_psi_u1_of_place_11 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_12 = -ratio_theta_u1_of_c_lam_rf - ratio_theta_u1_of_place_8;
    let ratio_theta_u1_of_place_13 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let ratio_theta_u1_of_place_14 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let ratio_theta_u1_of_place_15 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_7;
    let ratio_theta_u1_of_place_16 = ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_15;
    let ratio_theta_u1_of_place_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_16;
    let ratio_theta_u1_of_place_18 = sin_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_19 = ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_16;
    let ratio_theta_u1_of_place_20 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(sin_lam_plus_theta, rR);
    let ratio_theta_u1_of_place_21 = ratio_theta_u1_of_place_20 * sin_phi;
    let ratio_theta_u1_of_place_22 = ratio_theta_u1_of_place_9 * sin_delta;
    let ratio_theta_u1_of_place_23 = ratio_theta_u1_of_place_19
        .mul_add(
            ratio_theta_u1_of_place_22,
            ratio_theta_u1_of_place * ratio_theta_u1_of_place_7,
        );
    let ratio_theta_u1_of_place_24 = ratio_theta_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_25 = S::int(1)
        / (-ratio_theta_u1_of_place_2
            * ratio_theta_u1_of_place_17
                .mul_add(
                    ratio_theta_u1_of_place_22,
                    ratio_theta_u1_of_place_10 * cos_delta,
                ) + ratio_theta_u1_of_place * ratio_theta_u1_of_place_11
            - ratio_theta_u1_of_place_9
                * (ratio_theta_u1_of_place_23 - ratio_theta_u1_of_place_24));
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
    let ratio_psi_u1_of_place_13 = (-ratio_psi_u1_of_place_3)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_6)
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_7
        + ratio_theta_u1 * ratio_psi_u1_of_place_12;
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
    let ratio_psi_u1_of_place_16 = (-ratio_psi_u1_of_place_9)
        .mul_add(
            ratio_theta_u1_of_place_13,
            ratio_psi_u1_of_place_8 * ratio_theta_u1_of_place_14,
        ) + ratio_psi_u1_of_place_11 * ratio_theta_u1_of_place_18;
    let ratio_psi_u1_of_place_17 = (-ratio_psi_u1_of_place_7)
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u1_of_place_20 * cos_phi)
        - ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_14
        - ratio_psi_u1_of_place_3 * ratio_theta_u1_of_place_18
        + ratio_theta_u1 * ratio_psi_u1_of_place_16;
    let ratio_psi_u1_of_place_18 = ratio_theta_u1_of_place_14 * ratio_psi_u1_of_place_14;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_17)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_psi_u1_of_place_13 * ratio_psi_u1_of_place_15,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_25
        * (-ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_17
            + ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12
            - ratio_theta_u1_of_place_2
                * ratio_theta_u1_of_place_2
                    .mul_add(ratio_theta_u1_of_place_17, ratio_theta_u1_of_place_15));
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_12, ratio_theta_u2 * ratio_psi_u1_of_place_12);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_16,
            ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_14,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_18
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_15 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_15;
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_6))
        .sqrt();
    let ratio_thF_u1_of_place_2 = ratio_psi_u1_of_place_14 * ratio_thF_u1_of_place;
    let ratio_thF_u1_of_place_3 = rf_inv * ratio_thF_u1_of_place_2;
    let ratio_thF_u1_of_place_4 = ratio_theta_u1_of_place_4 * sin_delta * ratio_thF_u1_of_place
        / (-S::int(1) + sin_phi_cos_delta * sin_phi_cos_delta
            + ratio_theta_u1_of_place_3
                * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_3))
        - sin_lam * cos_delta;
    let ratio_thF_u1_of_place_5 = cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam;
    let ratio_thF_u1_of_place_6 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_of_place_4, ratio_thF_u1_of_place_5)
        + ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta;
    let ratio_thF_u1_of_place_7 = ratio_psi_u1_of_place_2
        * (-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_w_lam_rr_rf,
                ratio_psi_u1_of_c_lam_rf * ratio_theta_u1_of_place_9,
            ) - ratio_theta_u1_of_place_4 * ratio_psi_u1_of_place * sin_lam_plus_theta
        + ratio_theta_u1_of_place_4 * ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5
        + ratio_theta_u1_of_place_21;
    let ratio_thF_u1 = ratio_thF_u1_of_place_3
        * (-ratio_psi_u1_of_place_17)
            .mul_add(
                ratio_thF_u1_of_place_7,
                ratio_psi_u1_of_place_13 * ratio_thF_u1_of_place_6,
            );
    let ratio_thF_u2 = ratio_thF_u1_of_place_3
        * ratio_psi_u2_of_place_2
            .mul_add(
                ratio_thF_u1_of_place_7,
                ratio_psi_u2_of_place * ratio_thF_u1_of_place_6,
            );
    let ratio_thF_u3 = -rR * ratio_thF_u1_of_place_2
        * (sin_lam_plus_theta * (cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam))
            + cos_lam_plus_theta
                * (-rf_inv).mul_add(ratio_thF_u1_of_place_5, ratio_thF_u1_of_place_4));
    let w_Y_in_L_2_2 = ratio_psi_u1 * sin_phi;
    let w_Y_in_L_3_2 = ratio_psi_u1 * cos_phi;
    let w_L_in_B_1_2 = w_Y_in_L_3_2.mul_add(sin_theta, cos_theta);
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, sin_theta);
    let w_B_2_2 = ratio_theta_u1 - w_Y_in_L_2_2;
    let w_B_in_S_1_2 = (-w_L_in_B_1_2).mul_add(cos_lam, w_L_in_B_3_2 * sin_lam);
    let w_B_in_S_3_2 = w_L_in_B_3_2.mul_add(cos_lam, w_L_in_B_1_2 * sin_lam);
    let w_S_in_F_1_2 = (-w_B_2_2).mul_add(sin_delta, w_B_in_S_1_2 * cos_delta);
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_B_2_2 * cos_delta);
    let w_F_in_H_1_2 = (-w_S_in_F_1_2).mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let w_F_in_H_3_2 = w_S_in_F_1_2.mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let v_RC_1 = rR * w_Y_in_L_2_2;
    let H_rear_wheel_2_2 = IRyy * w_Y_in_L_2_2;
    let H_rear_wheel_3_2 = IRxx * w_Y_in_L_3_2;
    let v_L_in_B_1 = v_RC_1 * cos_theta;
    let v_L_in_B_3 = v_RC_1 * sin_theta;
    let rr_plus_zb = rR + zB;
    let v_Bo_1 = w_B_2_2.mul_add(rr_plus_zb, v_L_in_B_1);
    let v_Bo_2 = xB.mul_add(w_L_in_B_3_2, rR) - w_L_in_B_1_2 * rr_plus_zb;
    let v_Bo_3 = xB.mul_add(w_B_2_2, -v_L_in_B_3);
    let H_frame_1_2 = IBxz.mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let H_frame_2_2 = IByy * w_B_2_2;
    let H_frame_3_2 = IBzz.mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let v_B_in_S_1 = (-v_L_in_B_1).mul_add(cos_lam, v_L_in_B_3 * sin_lam);
    let v_B_in_S_3 = v_L_in_B_3.mul_add(cos_lam, v_L_in_B_1 * sin_lam);
    let v_Ho_2 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, rR);
    let v_Ho_3 = w_B_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3);
    let v_S_in_F_1 = (-v_Ho_2).mul_add(sin_delta, v_B_in_S_1 * cos_delta);
    let v_S_in_F_2 = v_Ho_2.mul_add(cos_delta, v_B_in_S_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let v_Ho_1_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let v_Ho_1 = w_S_in_F_2_2.mul_add(v_Ho_1_of_lam_rr_xh_zh, -v_S_in_F_1);
    let v_Ho_2_2_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let v_Ho_2_2 = w_B_in_S_3_2.mul_add(v_Ho_2_2_of_place, -v_S_in_F_2)
        - w_S_in_F_1_2 * v_Ho_1_of_lam_rr_xh_zh;
    let v_Ho_3_2 = w_S_in_F_2_2.mul_add(v_Ho_2_2_of_place, -v_Ho_3);
    let H_fork_1_2 = IHxz.mul_add(w_F_in_H_3_2, IHxx * w_F_in_H_1_2);
    let H_fork_2_2 = IHyy * w_S_in_F_2_2;
    let H_fork_3_2 = IHzz.mul_add(w_F_in_H_3_2, IHxz * w_F_in_H_1_2);
    let v_FC_1 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -v_S_in_F_1);
    let v_FC_2 = w_B_in_S_3_2.mul_add(ratio_psi_u1_of_c_lam_rf, v_S_in_F_2)
        + w_S_in_F_1_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3 = w_S_in_F_2_2.mul_add(ratio_psi_u1_of_c_lam_rf, v_Ho_3);
    let w_FW_2_2 = ratio_thF_u1 + w_S_in_F_2_2;
    let H_front_wheel_1_2 = IFxx * w_S_in_F_1_2;
    let H_front_wheel_2_2 = IFyy * w_FW_2_2;
    let H_front_wheel_3_2 = IFxx * w_B_in_S_3_2;
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
    let p_v_RC_2 = rR.mul_add(mR, p_v_Ho_2_2) + p_v_Bo_2;
    let p_v_RC_1 = (-p_v_L_in_B_3).mul_add(sin_theta, mR * v_RC_1) - p_v_L_in_B_1 * cos_theta;
    let p_w_F_3 = H_fork_3_2.mul_add(cos_lam, H_fork_1_2 * sin_lam) + H_front_wheel_3_2
        + p_v_FC_2 * ratio_psi_u1_of_c_lam_rf + p_v_Ho_2 * v_Ho_2_2_of_place;
    let p_w_S_in_F_2 = p_v_FC_3
        .mul_add(ratio_psi_u1_of_c_lam_rf, H_fork_2_2 + H_front_wheel_2_2)
        + p_v_FC_1 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_1 * v_Ho_1_of_lam_rr_xh_zh
        + p_v_Ho_3 * v_Ho_2_2_of_place;
    let p_w_S_in_F_1 = (-H_fork_1_2).mul_add(cos_lam, H_fork_3_2 * sin_lam)
        + H_front_wheel_1_2 + p_v_FC_2 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2 * v_Ho_1_of_lam_rr_xh_zh;
    let p_w_B_in_S_3 = p_v_Ho_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3);
    let p_w_B_in_S_1 = p_w_S_in_F_1.mul_add(cos_delta, p_w_S_in_F_2 * sin_delta);
    let p_w_B_2 = xB.mul_add(p_v_Bo_3, H_frame_2_2) + p_w_S_in_F_2 * cos_delta
        - p_w_S_in_F_1 * sin_delta + p_v_Ho_3_2 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1 * rr_plus_zb;
    let p_w_L_in_B_3 = xB.mul_add(p_v_Bo_2, H_frame_3_2) + p_w_B_in_S_3 * cos_lam
        + p_w_B_in_S_1 * sin_lam;
    let p_w_L_in_B_1 = p_w_B_in_S_3.mul_add(sin_lam, H_frame_1_2)
        - p_w_B_in_S_1 * cos_lam - p_v_Bo_2 * rr_plus_zb;
    let p_w_Y_in_L_3 = (-p_w_L_in_B_3).mul_add(cos_theta, H_rear_wheel_3_2)
        + p_w_L_in_B_1 * sin_theta;
    let p_w_Y_in_L_2 = rR.mul_add(p_v_RC_1, H_rear_wheel_2_2) - p_w_B_2;
    let w_Y_in_L_2_3 = ratio_psi_u2 * sin_phi;
    let w_Y_in_L_3_3 = ratio_psi_u2 * cos_phi;
    let w_L_in_B_1_3 = w_Y_in_L_3_3 * sin_theta;
    let w_L_in_B_3_3 = w_Y_in_L_3_3 * cos_theta;
    let w_B_2_3 = ratio_theta_u2 - w_Y_in_L_2_3;
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_1_3 = w_B_in_S_1_3.mul_add(cos_delta, w_B_2_3 * sin_delta);
    let w_S_in_F_2_3 = (-w_B_2_3).mul_add(cos_delta, w_B_in_S_1_3 * sin_delta);
    let w_F_3_2 = w_B_in_S_3_3 - S::int(1);
    let w_F_in_H_1_3 = (-w_S_in_F_1_3).mul_add(cos_lam, w_F_3_2 * sin_lam);
    let w_F_in_H_3_3 = w_F_3_2.mul_add(cos_lam, w_S_in_F_1_3 * sin_lam);
    let v_RC_1_2 = rR * w_Y_in_L_2_3;
    let H_rear_wheel_2_3 = IRyy * w_Y_in_L_2_3;
    let H_rear_wheel_3_3 = IRxx * w_Y_in_L_3_3;
    let v_L_in_B_1_2 = v_RC_1_2 * cos_theta;
    let v_L_in_B_3_2 = v_RC_1_2 * sin_theta;
    let v_Bo_1_2 = w_B_2_3.mul_add(rr_plus_zb, v_L_in_B_1_2);
    let v_Bo_2_2 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let v_Bo_3_2 = xB.mul_add(w_B_2_3, -v_L_in_B_3_2);
    let H_frame_1_3 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let H_frame_2_3 = IByy * w_B_2_3;
    let H_frame_3_3 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let v_B_in_S_1_2 = (-v_L_in_B_1_2).mul_add(cos_lam, v_L_in_B_3_2 * sin_lam);
    let v_B_in_S_3_2 = v_L_in_B_3_2.mul_add(cos_lam, v_L_in_B_1_2 * sin_lam);
    let v_Ho_2_3 = w_B_in_S_3_3 * ratio_theta_u1_of_w_c_lam_rr;
    let v_Ho_3_3 = w_B_2_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3_2);
    let v_S_in_F_1_2 = v_Ho_2_3.mul_add(sin_delta, v_B_in_S_1_2 * cos_delta);
    let v_S_in_F_2_2 = (-v_Ho_2_3).mul_add(cos_delta, v_B_in_S_1_2 * sin_delta);
    let v_Ho_1_2 = w_S_in_F_2_3.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_1_2);
    let v_Ho_2_4 = (-w_S_in_F_1_3).mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_2_2)
        + w_F_3_2 * v_Ho_2_2_of_place;
    let v_Ho_3_4 = w_S_in_F_2_3.mul_add(v_Ho_2_2_of_place, v_Ho_3_3);
    let H_fork_1_3 = IHxz.mul_add(w_F_in_H_3_3, IHxx * w_F_in_H_1_3);
    let H_fork_2_3 = IHyy * w_S_in_F_2_3;
    let H_fork_3_3 = IHzz.mul_add(w_F_in_H_3_3, IHxz * w_F_in_H_1_3);
    let v_FC_1_2 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_2);
    let v_FC_2_2 = w_F_3_2.mul_add(ratio_psi_u1_of_c_lam_rf, -v_S_in_F_2_2)
        + w_S_in_F_1_3 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_2 = w_S_in_F_2_3.mul_add(ratio_psi_u1_of_c_lam_rf, -v_Ho_3_3);
    let w_FW_2_3 = ratio_thF_u2 - w_S_in_F_2_3;
    let H_front_wheel_1_3 = IFxx * w_S_in_F_1_3;
    let H_front_wheel_2_3 = IFyy * w_FW_2_3;
    let H_front_wheel_3_3 = IFxx * w_F_3_2;
    let p_v_FC_3_2 = mF * v_FC_3_2;
    let p_v_FC_2_2 = mF * v_FC_2_2;
    let p_v_FC_1_2 = mF * v_FC_1_2;
    let p_v_Ho_3_3 = mH * v_Ho_3_4;
    let p_v_Ho_2_3 = mH * v_Ho_2_4;
    let p_v_Ho_1_2 = mH * v_Ho_1_2;
    let p_v_S_in_F_2_2 = p_v_FC_2_2 - p_v_Ho_2_3;
    let p_v_S_in_F_1_2 = p_v_FC_1_2 + p_v_Ho_1_2;
    let p_v_Ho_3_4 = p_v_FC_3_2 - p_v_Ho_3_3;
    let p_v_Ho_2_4 = p_v_S_in_F_1_2.mul_add(sin_delta, p_v_S_in_F_2_2 * cos_delta);
    let p_v_B_in_S_1_2 = (-p_v_S_in_F_1_2)
        .mul_add(cos_delta, p_v_S_in_F_2_2 * sin_delta);
    let p_v_Bo_3_2 = mB * v_Bo_3_2;
    let p_v_Bo_2_2 = mB * v_Bo_2_2;
    let p_v_Bo_1_2 = mB * v_Bo_1_2;
    let p_v_L_in_B_3_2 = (-p_v_B_in_S_1_2).mul_add(sin_lam, p_v_Ho_3_4 * cos_lam) - p_v_Bo_3_2;
    let p_v_L_in_B_1_2 = p_v_B_in_S_1_2.mul_add(cos_lam, p_v_Ho_3_4 * sin_lam) + p_v_Bo_1_2;
    let p_v_RC_2_2 = p_v_Ho_2_4 + p_v_Bo_2_2;
    let p_v_RC_1_2 = p_v_L_in_B_3_2.mul_add(sin_theta, mR * v_RC_1_2) + p_v_L_in_B_1_2 * cos_theta;
    let p_w_F_3_2 = H_fork_3_3.mul_add(cos_lam, H_fork_1_3 * sin_lam) + H_front_wheel_3_3
        + p_v_FC_2_2 * ratio_psi_u1_of_c_lam_rf + p_v_Ho_2_3 * v_Ho_2_2_of_place;
    let p_w_S_in_F_2_2 = p_v_FC_3_2
        .mul_add(ratio_psi_u1_of_c_lam_rf, H_fork_2_3 - H_front_wheel_2_3)
        + p_v_FC_1_2 * ratio_theta_u1_of_w_lam_rr_rf
        + p_v_Ho_1_2 * v_Ho_1_of_lam_rr_xh_zh + p_v_Ho_3_3 * v_Ho_2_2_of_place;
    let p_w_S_in_F_1_2 = (-H_fork_1_3).mul_add(cos_lam, H_fork_3_3 * sin_lam)
        + H_front_wheel_1_3 + p_v_FC_2_2 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2_3 * v_Ho_1_of_lam_rr_xh_zh;
    let p_w_B_in_S_3_2 = p_v_Ho_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3_2);
    let p_w_B_in_S_1_2 = p_w_S_in_F_1_2.mul_add(cos_delta, p_w_S_in_F_2_2 * sin_delta);
    let p_w_B_2_2 = xB.mul_add(p_v_Bo_3_2, H_frame_2_3) - p_w_S_in_F_2_2 * cos_delta
        + p_w_S_in_F_1_2 * sin_delta - p_v_Ho_3_4 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1_2 * rr_plus_zb;
    let p_w_L_in_B_3_2 = (-xB).mul_add(p_v_Bo_2_2, H_frame_3_3)
        - p_w_B_in_S_3_2 * cos_lam - p_w_B_in_S_1_2 * sin_lam;
    let p_w_L_in_B_1_2 = (-p_w_B_in_S_3_2).mul_add(sin_lam, H_frame_1_3)
        + p_w_B_in_S_1_2 * cos_lam + p_v_Bo_2_2 * rr_plus_zb;
    let p_w_Y_in_L_3_2 = (-p_w_L_in_B_3_2).mul_add(cos_theta, H_rear_wheel_3_3)
        + p_w_L_in_B_1_2 * sin_theta;
    let p_w_Y_in_L_2_2 = rR.mul_add(p_v_RC_1_2, H_rear_wheel_2_3) - p_w_B_2_2;
    let w_Y_in_L_2_4 = ratio_psi_u3 * sin_phi;
    let w_Y_in_L_3_4 = ratio_psi_u3 * cos_phi;
    let w_RW_2_2 = w_Y_in_L_2_4 - S::int(1);
    let w_L_in_B_1_4 = w_Y_in_L_3_4 * sin_theta;
    let w_L_in_B_3_4 = w_Y_in_L_3_4 * cos_theta;
    let w_B_in_S_1_4 = w_L_in_B_3_4.mul_add(sin_lam, w_L_in_B_1_4 * cos_lam);
    let w_B_in_S_3_4 = (-w_L_in_B_1_4).mul_add(sin_lam, w_L_in_B_3_4 * cos_lam);
    let w_S_in_F_1_4 = (-w_Y_in_L_2_4).mul_add(sin_delta, w_B_in_S_1_4 * cos_delta);
    let w_S_in_F_2_4 = w_B_in_S_1_4.mul_add(sin_delta, w_Y_in_L_2_4 * cos_delta);
    let w_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let v_N_in_Y_1 = rR * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let v_RC_1_3 = rR.mul_add(w_Y_in_L_2_4, -v_N_in_Y_1);
    let H_rear_wheel_2_4 = IRyy * w_RW_2_2;
    let H_rear_wheel_3_4 = IRxx * w_Y_in_L_3_4;
    let v_L_in_B_1_3 = v_RC_1_3 * cos_theta;
    let v_L_in_B_3_3 = v_RC_1_3 * sin_theta;
    let v_Bo_1_3 = w_Y_in_L_2_4.mul_add(rr_plus_zb, -v_L_in_B_1_3);
    let v_Bo_2_3 = w_L_in_B_1_4.mul_add(rr_plus_zb, xB * w_L_in_B_3_4);
    let v_Bo_3_3 = xB.mul_add(w_Y_in_L_2_4, v_L_in_B_3_3);
    let H_frame_1_4 = (-IBxz).mul_add(w_L_in_B_3_4, IBxx * w_L_in_B_1_4);
    let H_frame_2_4 = IByy * w_Y_in_L_2_4;
    let H_frame_3_4 = (-IBzz).mul_add(w_L_in_B_3_4, IBxz * w_L_in_B_1_4);
    let v_B_in_S_1_3 = (-v_L_in_B_1_3).mul_add(cos_lam, v_L_in_B_3_3 * sin_lam);
    let v_B_in_S_3_3 = v_L_in_B_3_3.mul_add(cos_lam, v_L_in_B_1_3 * sin_lam);
    let v_Ho_2_5 = w_B_in_S_3_4 * ratio_theta_u1_of_w_c_lam_rr;
    let v_Ho_3_5 = w_Y_in_L_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, v_B_in_S_3_3);
    let v_S_in_F_1_3 = v_Ho_2_5.mul_add(sin_delta, v_B_in_S_1_3 * cos_delta);
    let v_S_in_F_2_3 = (-v_Ho_2_5).mul_add(cos_delta, v_B_in_S_1_3 * sin_delta);
    let v_Ho_1_3 = w_S_in_F_2_4.mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_1_3);
    let v_Ho_2_6 = (-w_S_in_F_1_4).mul_add(v_Ho_1_of_lam_rr_xh_zh, v_S_in_F_2_3)
        + w_B_in_S_3_4 * v_Ho_2_2_of_place;
    let v_Ho_3_6 = w_S_in_F_2_4.mul_add(v_Ho_2_2_of_place, -v_Ho_3_5);
    let H_fork_1_4 = IHxz.mul_add(w_F_in_H_3_4, IHxx * w_F_in_H_1_4);
    let H_fork_2_4 = IHyy * w_S_in_F_2_4;
    let H_fork_3_4 = IHzz.mul_add(w_F_in_H_3_4, IHxz * w_F_in_H_1_4);
    let v_FC_1_3 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_3);
    let v_FC_2_3 = w_B_in_S_3_4.mul_add(ratio_psi_u1_of_c_lam_rf, -v_S_in_F_2_3)
        + w_S_in_F_1_4 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_3 = w_S_in_F_2_4.mul_add(ratio_psi_u1_of_c_lam_rf, v_Ho_3_5);
    let w_FW_2_4 = ratio_thF_u3 - w_S_in_F_2_4;
    let H_front_wheel_1_4 = IFxx * w_S_in_F_1_4;
    let H_front_wheel_2_4 = IFyy * w_FW_2_4;
    let H_front_wheel_3_4 = IFxx * w_B_in_S_3_4;
    let p_v_FC_3_3 = mF * v_FC_3_3;
    let p_v_FC_2_3 = mF * v_FC_2_3;
    let p_v_FC_1_3 = mF * v_FC_1_3;
    let p_v_Ho_3_5 = mH * v_Ho_3_6;
    let p_v_Ho_2_5 = mH * v_Ho_2_6;
    let p_v_Ho_1_3 = mH * v_Ho_1_3;
    let p_v_S_in_F_2_3 = p_v_FC_2_3 - p_v_Ho_2_5;
    let p_v_S_in_F_1_3 = p_v_FC_1_3 + p_v_Ho_1_3;
    let p_v_Ho_3_6 = p_v_FC_3_3 - p_v_Ho_3_5;
    let p_v_Ho_2_6 = p_v_S_in_F_1_3.mul_add(sin_delta, p_v_S_in_F_2_3 * cos_delta);
    let p_v_B_in_S_1_3 = (-p_v_S_in_F_1_3)
        .mul_add(cos_delta, p_v_S_in_F_2_3 * sin_delta);
    let p_v_Bo_3_3 = mB * v_Bo_3_3;
    let p_v_Bo_2_3 = mB * v_Bo_2_3;
    let p_v_Bo_1_3 = mB * v_Bo_1_3;
    let p_v_L_in_B_3_3 = (-p_v_B_in_S_1_3).mul_add(sin_lam, p_v_Ho_3_6 * cos_lam) + p_v_Bo_3_3;
    let p_v_L_in_B_1_3 = p_v_B_in_S_1_3.mul_add(cos_lam, p_v_Ho_3_6 * sin_lam) - p_v_Bo_1_3;
    let p_v_RC_2_3 = p_v_Ho_2_6 + p_v_Bo_2_3;
    let p_v_RC_1_3 = p_v_L_in_B_3_3.mul_add(sin_theta, mR * v_RC_1_3) + p_v_L_in_B_1_3 * cos_theta;
    let p_w_F_3_3 = H_fork_3_4.mul_add(cos_lam, H_fork_1_4 * sin_lam) + H_front_wheel_3_4
        + p_v_FC_2_3 * ratio_psi_u1_of_c_lam_rf + p_v_Ho_2_5 * v_Ho_2_2_of_place;
    let p_w_S_in_F_2_3 = p_v_FC_3_3
        .mul_add(ratio_psi_u1_of_c_lam_rf, H_fork_2_4 - H_front_wheel_2_4)
        + p_v_FC_1_3 * ratio_theta_u1_of_w_lam_rr_rf
        + p_v_Ho_1_3 * v_Ho_1_of_lam_rr_xh_zh + p_v_Ho_3_5 * v_Ho_2_2_of_place;
    let p_w_S_in_F_1_3 = (-H_fork_1_4).mul_add(cos_lam, H_fork_3_4 * sin_lam)
        + H_front_wheel_1_4 + p_v_FC_2_3 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2_5 * v_Ho_1_of_lam_rr_xh_zh;
    let p_w_B_in_S_3_3 = p_v_Ho_2_6.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3_3);
    let p_w_B_in_S_1_3 = p_w_S_in_F_1_3.mul_add(cos_delta, p_w_S_in_F_2_3 * sin_delta);
    let p_w_B_2_3 = xB.mul_add(p_v_Bo_3_3, H_frame_2_4) + p_w_S_in_F_2_3 * cos_delta
        - p_w_S_in_F_1_3 * sin_delta + p_v_Ho_3_6 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1_3 * rr_plus_zb;
    let p_w_L_in_B_3_3 = (-xB).mul_add(p_v_Bo_2_3, H_frame_3_4)
        - p_w_B_in_S_3_3 * cos_lam - p_w_B_in_S_1_3 * sin_lam;
    let p_w_L_in_B_1_3 = (-p_w_B_in_S_3_3).mul_add(sin_lam, H_frame_1_4)
        + p_w_B_in_S_1_3 * cos_lam + p_v_Bo_2_3 * rr_plus_zb;
    let p_w_Y_in_L_3_3 = (-p_w_L_in_B_3_3).mul_add(cos_theta, H_rear_wheel_3_4)
        + p_w_L_in_B_1_3 * sin_theta;
    let p_w_Y_in_L_2_3_of_place = rR.mul_add(p_v_RC_1_3, H_rear_wheel_2_4);
    let p_w_Y_in_L_2_3 = p_w_B_2_3 + p_w_Y_in_L_2_3_of_place;
    let m12_of_place = p_w_Y_in_L_2_2.mul_add(sin_phi, p_w_Y_in_L_3_2 * cos_phi);
    let m13_of_place = p_w_Y_in_L_2_3.mul_add(sin_phi, p_w_Y_in_L_3_3 * cos_phi);
    // Entries that are not zero; upper triangle.
    let m11 = IRxx + ratio_thF_u1 * H_front_wheel_2_2 + rR * p_v_RC_2
        + ratio_theta_u1 * p_w_B_2 + p_w_L_in_B_3 * sin_theta + p_w_L_in_B_1 * cos_theta
        + ratio_psi_u1 * p_w_Y_in_L_2.mul_add(sin_phi, p_w_Y_in_L_3 * cos_phi);
    let m12 = (-rR).mul_add(p_v_RC_2_2, ratio_thF_u1 * H_front_wheel_2_3)
        + ratio_theta_u1 * p_w_B_2_2 + p_w_L_in_B_3_2 * sin_theta
        + p_w_L_in_B_1_2 * cos_theta + ratio_psi_u1 * m12_of_place;
    let m13 = (-rR).mul_add(p_v_RC_2_3, ratio_thF_u1 * H_front_wheel_2_4)
        - ratio_theta_u1 * p_w_B_2_3 + p_w_L_in_B_3_3 * sin_theta
        + p_w_L_in_B_1_3 * cos_theta + ratio_psi_u1 * m13_of_place;
    let m22 = ratio_thF_u2.mul_add(H_front_wheel_2_3, -p_w_F_3_2)
        + ratio_theta_u2 * p_w_B_2_2 + ratio_psi_u2 * m12_of_place;
    let m23 = ratio_thF_u2.mul_add(H_front_wheel_2_4, -p_w_F_3_3)
        - ratio_theta_u2 * p_w_B_2_3 + ratio_psi_u2 * m13_of_place;
    let m33 = ratio_thF_u3.mul_add(H_front_wheel_2_4, -p_w_Y_in_L_2_3_of_place)
        + ratio_psi_u3 * m13_of_place;
    [[m11, m12, m13], [m12, m22, m23], [m13, m23, m33]]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3').
///
/// 1114 operations, 8 sines and cosines, 2 other functions.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> [S; 3] {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [_, _, psi, phi, theta, delta, thR, thF] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_psi_u1_of_place = cos_lam_plus_theta * sin_delta;
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
    let c_cos_lam = c * cos_lam;
    let ratio_theta_u1_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let ratio_theta_u1_of_place_9 = ratio_theta_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_8, -ratio_theta_u1_of_c_lam_rf);
    let ratio_psi_u1_of_place_2 = -ratio_psi_u1_of_place * ratio_theta_u1_of_place_9;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let ratio_theta_u1_of_place_10 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_10;
    let ratio_theta_u1_of_place_12 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_3 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_4 = (-ratio_theta_u1_of_place_12)
        .mul_add(
            ratio_psi_u1_of_place_3,
            -ratio_theta_u1_of_place_9 * sin_lam_plus_theta,
        );
    let ratio_psi_u1_of_place_5 = ratio_psi_u1_of_place * ratio_theta_u1_of_place_12;
    let ratio_psi_u1_of_place_6 = ratio_theta_u1_of_place_12 * sin_delta;
    let ratio_psi_u1_of_place_7 = -ratio_theta_u1_of_place_12 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_8 = -ratio_theta_u1_of_place_9 * cos_delta;
    let ratio_psi_u1_of_place_9 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_8;
    let ratio_psi_u1_of_place_10 = (-ratio_psi_u1_of_place)
        .mul_add(
            ratio_psi_u1_of_place_6,
            ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_7,
        ) + ratio_psi_u1_of_place_9 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_13 = -ratio_theta_u1_of_place_9;
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let ratio_theta_u1_of_place_14 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, sin_delta_cos_phi);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_theta_u1_of_place_15 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
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
        * ratio_theta_u1_of_w_c_lam_rr.mul_add(sin_lam_plus_theta, rR);
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
    let ratio_theta_u1_of_place_29 = ratio_theta_u1_of_place_13
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_30 = ratio_theta_u1_of_place_28 - ratio_theta_u1_of_place_29;
    let ratio_theta_u1_of_place_31 = S::int(1)
        / ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_26,
                ratio_theta_u1_of_place * ratio_theta_u1_of_place_12,
            ) - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_30);
    let ratio_theta_u1 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_19,
                ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_14,
            ) - ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_20
            + ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_22 + ratio_theta_u1_of_place_23);
    let ratio_psi_u1_of_place_11 = (-ratio_psi_u1_of_place_2)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place * ratio_psi_u1_of_place_4)
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_5
        + ratio_theta_u1 * ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * w_plus_c.mul_add(cos_lam_plus_theta, rr_minus_rf * sin_lam_plus_theta);
    let ratio_psi_u1_of_place_13 = ratio_psi_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_14 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_15 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_14, ratio_psi_u1_of_place_13 * cos_phi);
    let ratio_psi_u1_of_place_16 = ratio_psi_u1_of_place * ratio_psi_u1_of_place_15;
    let ratio_psi_u1_of_place_17 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_of_w_c_lam_rr, rR * cos_phi);
    let ratio_psi_u1_of_place_18 = (-ratio_psi_u1_of_place_7)
        .mul_add(
            ratio_theta_u1_of_place_14,
            ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_15,
        ) + ratio_psi_u1_of_place_9 * ratio_theta_u1_of_place_20;
    let ratio_psi_u1_of_place_19 = (-ratio_psi_u1_of_place_5)
        .mul_add(ratio_theta_u1_of_place_14, ratio_psi_u1_of_place_17)
        - ratio_psi_u1_of_place_4 * ratio_theta_u1_of_place_15
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_of_place_20
        + ratio_theta_u1 * ratio_psi_u1_of_place_18;
    let ratio_psi_u1_of_place_20 = ratio_theta_u1_of_place_15 * ratio_psi_u1_of_place_15;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_psi_u1_of_place_20,
            ratio_psi_u1_of_place_11 * ratio_psi_u1_of_place_16,
        );
    let ratio_theta_u2_of_place = ratio_theta_u1_of_place_2
        .mul_add(
            ratio_theta_u1_of_place_18,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_8,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_10)
            .mul_add(
                ratio_theta_u1_of_place_24,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_13,
            ) - ratio_theta_u1_of_place_2 * ratio_theta_u2_of_place);
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u2 * ratio_psi_u1_of_place_10);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_15,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_20
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_16 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_16;
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
    let ratio_thF_u1_of_place_5 = (-sin_lam)
        .mul_add(
            cos_delta,
            ratio_thF_u1_of_place_3 * sin_delta * ratio_thF_u1_of_place_4,
        );
    let ratio_thF_u1_of_place_6 = cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam;
    let ratio_thF_u1_of_place_7 = rF
        .mul_add(ratio_thF_u1_of_place_5, -ratio_thF_u1_of_place_6);
    let ratio_thF_u1_of_place_8 = (-ratio_thF_u1_of_place_7)
        .mul_add(cos_lam_plus_theta, ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta);
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_9 = ratio_psi_u1_of_place_15 * ratio_thF_u1_of_place_4;
    let ratio_thF_u1_of_place_10 = rf_inv * ratio_thF_u1_of_place_9;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_10;
    let ratio_thF_u1_of_place_12 = -ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_9;
    let ratio_thF_u1_of_place_13 = (-ratio_theta_u1_of_place_2)
        .mul_add(
            ratio_theta_u1_of_w_lam_rr_rf,
            ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_of_place_10,
        );
    let ratio_thF_u1_of_place_14 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12;
    let ratio_thF_u1_of_place_15 = ratio_thF_u1_of_place_12
        .mul_add(sin_lam_plus_theta, ratio_theta_u1_of_place_23)
        + ratio_psi_u1_of_place * ratio_thF_u1_of_place_13
        - ratio_psi_u1_of_place_3 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_of_place_16 = ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_15;
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u3_of_place = ratio_thF_u1_of_place_6
        .mul_add(rf_inv, -ratio_thF_u1_of_place_5);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_w_lam_rr_rf)
        .mul_add(sin_lam_plus_theta, ratio_thF_u3_of_place * cos_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = rR * ratio_thF_u1_of_place_9;
    let ratio_thF_u3 = ratio_thF_u3_of_place_2 * ratio_thF_u3_of_place_3;
    let w_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_2 = w_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let w_Y_in_L_3 = w_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-u1).mul_add(sin_theta, w_Y_in_L_3 * cos_theta);
    let w_B_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let w_B_2 = w_B_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_in_S_1 = w_L_in_B_3.mul_add(sin_lam, w_L_in_B_1 * cos_lam);
    let w_B_in_S_3 = (-w_L_in_B_1).mul_add(sin_lam, w_L_in_B_3 * cos_lam);
    let w_S_in_F_1 = w_B_in_S_1.mul_add(cos_delta, w_B_2 * sin_delta);
    let w_S_in_F_2 = (-w_B_2).mul_add(cos_delta, w_B_in_S_1 * sin_delta);
    let w_F_3 = u2 - w_B_in_S_3;
    let w_F_in_H_1 = w_F_3.mul_add(sin_lam, w_S_in_F_1 * cos_lam);
    let w_F_in_H_3 = (-w_S_in_F_1).mul_add(sin_lam, w_F_3 * cos_lam);
    let w_F_in_FW_1 = (-w_S_in_F_1).mul_add(cos_thF, w_F_3 * sin_thF);
    let w_F_in_FW_3 = w_F_3.mul_add(cos_thF, w_S_in_F_1 * sin_thF);
    let ratio_theta_u1_2_of_u1_u2 = w_B_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_2 = (-ratio_theta_u1_of_place_10)
        .mul_add(w_B_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_2 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_3;
    let ratio_theta_u1_2_of_u1_u2_5 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_6 = (-ratio_theta_u1_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_2 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_7 = -ratio_theta_u1_2_of_u1_u2_5 - ratio_theta_u1_2_of_u1_u2_6;
    let ratio_theta_u1_2_of_u1_u2_8 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_4,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_7,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_8,
            ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = w_B_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_u1_u2_9 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_psi_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_9);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place_9)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_8 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_12 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_8)
        .mul_add(cos_delta, -ratio_theta_u1_of_place_9 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place
        .mul_add(w_B_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_11 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_9);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_11
        .mul_add(sin_delta, ratio_theta_u1_of_place_12 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_12 = ratio_theta_u1_2_of_u1_u2_11 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_12)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_12);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_6)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_of_place_20 * w_B_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_14 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_5 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_13 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_15 = -ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_16 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_7
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_u1_u2_4, ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u1_2_of_u1_u2_19 = (ratio_psi_u1_of_place * w_B_2_of_u1_u2)
        .mul_add(sin_phi, u1 * ratio_theta_u1_of_place_4) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_20 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_21 = (-u1)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_u1_u2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_22 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_23 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_13, u1 * ratio_psi_u1_of_place_17);
    let sin_delta_doubled = S::int(2) * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_2
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_u1_u2_10)
                .mul_add(sin_delta_doubled, ratio_theta_u1_of_place_10 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_15
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_24);
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_30 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_11
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_11)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_24 * u2_cos_delta)
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_10 * sin_delta
                - ratio_theta_u1_2_of_u1_u2_12
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_18)
        + ratio_theta_u1_of_place_10
            * ratio_theta_u1_of_place_13
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_25);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_14
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_14,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_18
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_19)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_19
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_21
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_22,
                        )) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_psi_u1_2_of_u1_u2_14 = (-ratio_theta_u1_2)
        .mul_add(
            ratio_psi_u1_of_place_10,
            ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2,
        ) + ratio_psi_u1_2_of_u1_u2_2 * sin_lam_plus_theta
        + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_u1_u2_3
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_7
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_13;
    let ratio_psi_u1_2_of_u1_u2_15 = (-ratio_theta_u1_of_place_20)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_10,
            ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_11,
        ) + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_12
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_21;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_18, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_13 * u1_sin_phi
        + ratio_psi_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_3
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2
                + ratio_psi_u1_of_place_12 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_16
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_20
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_19);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_7
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_4
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_18
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_4))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_7
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_13)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_10)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_15,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_18,
        ) - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_16 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_20 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_5;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_thF_u1_of_place * ratio_theta_u1_2_of_u1_u2_6
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_u1_u2_6 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_theta_u1_of_place_9)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_7,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_8,
            ) - ratio_thF_u1_of_place_13 * ratio_psi_u1_2_of_u1_u2
        + ratio_thF_u1_of_place_12 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_thF_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place
            * ratio_theta_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_10,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_4,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_7,
                ) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_7,
                ) + S::int(2) * ratio_theta_u1_of_place_4 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_w_lam_rr_rf = S::int(2) * ratio_theta_u1_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_7 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_thF_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_6
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_2_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_8 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_7);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_8,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = S::int(2) * ratio_thF_u3_of_w_lam_rr_rf
        * ratio_psi_u1_2_of_u1_u2_3 + ratio_thF_u3_of_place * ratio_psi_u1_2_of_u1_u2_6
        + cos_lam_plus_theta * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6);
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let alpha_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2_2, u1 * ratio_psi_u1_2)
        + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2 = alpha_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let alpha_Y_in_L_3 = alpha_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_13 = u1 * w_Y_in_L_3;
    let alpha_L_2 = alpha_Y_in_L_2 + w_L_13;
    let alpha_L_3 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3);
    let w_L_11 = u1 * u1;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let w_L_23 = w_Y_in_L_2 * w_Y_in_L_3;
    let turn_L_13 = alpha_L_2 + w_L_13;
    let turn_L_33 = w_L_11 + w_L_22;
    let alpha_L_in_B_1 = alpha_L_3 * sin_theta;
    let alpha_L_in_B_3 = alpha_L_3 * cos_theta;
    let alpha_B_1 = w_L_in_B_3.mul_add(w_B_2_of_u1_u2, -alpha_L_in_B_1);
    let alpha_B_2 = u2.mul_add(ratio_theta_u2_2, u1 * ratio_theta_u1_2) - alpha_L_2;
    let alpha_B_3 = w_L_in_B_1.mul_add(w_B_2_of_u1_u2, alpha_L_in_B_3);
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let turn_B_13 = alpha_B_2 - w_B_13;
    let turn_B_21 = alpha_B_3 + w_B_12;
    let turn_B_23 = alpha_B_1 + w_B_23;
    let turn_B_31 = alpha_B_2 + w_B_13;
    let turn_B_33 = w_B_11 + w_B_22;
    let alpha_B_in_S_1 = (-alpha_B_1).mul_add(cos_lam, alpha_B_3 * sin_lam);
    let alpha_B_in_S_3 = alpha_B_3.mul_add(cos_lam, alpha_B_1 * sin_lam);
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let turn_S_21 = alpha_B_in_S_3 + w_S_12;
    let turn_S_31 = alpha_B_2 + w_S_13;
    let alpha_S_in_F_1 = (-alpha_B_2).mul_add(sin_delta, alpha_B_in_S_1 * cos_delta);
    let alpha_S_in_F_2 = alpha_B_in_S_1.mul_add(sin_delta, alpha_B_2 * cos_delta);
    let alpha_F_1 = u2.mul_add(w_S_in_F_2, alpha_S_in_F_1);
    let alpha_F_2 = u2.mul_add(w_S_in_F_1, -alpha_S_in_F_2);
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_13 = alpha_F_2 - w_F_13;
    let turn_F_21 = alpha_B_in_S_3 - w_F_12;
    let turn_F_23 = alpha_F_1 - w_F_23;
    let turn_F_31 = alpha_F_2 + w_F_13;
    let turn_F_33 = w_F_11 + w_F_22;
    let a_N_in_Y_2 = rR * u3 * w_Y_in_L_2_of_u1_u2_u3 * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let a_Y_in_L_2 = (-g).mul_add(sin_phi, a_N_in_Y_2 * cos_phi);
    let a_Y_in_L_3 = a_N_in_Y_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_1 = rR * turn_L_13;
    let a_RC_2 = rR.mul_add(w_L_23, -a_Y_in_L_2);
    let a_RC_3 = rR.mul_add(turn_L_33, -a_Y_in_L_3);
    let H_rear_wheel_1 = IRxx * u1;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let alpha_RW_3 = alpha_L_3 + alpha_RW_in_L_3;
    let a_L_in_B_1 = (-a_RC_1).mul_add(cos_theta, a_RC_3 * sin_theta);
    let a_L_in_B_3 = a_RC_3.mul_add(cos_theta, a_RC_1 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1 = xB.mul_add(turn_B_11, a_L_in_B_1) - turn_B_13 * rr_plus_zb;
    let a_Bo_2 = xB.mul_add(turn_B_21, -a_RC_2) - turn_B_23 * rr_plus_zb;
    let a_Bo_3 = xB.mul_add(turn_B_31, -a_L_in_B_3) + turn_B_33 * rr_plus_zb;
    let H_frame_1 = (-IBxz).mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = (-IBzz).mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let a_B_in_S_1 = a_L_in_B_3.mul_add(sin_lam, a_L_in_B_1 * cos_lam);
    let a_B_in_S_3 = (-a_L_in_B_1).mul_add(sin_lam, a_L_in_B_3 * cos_lam);
    let a_Ho_1 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1);
    let a_Ho_2 = turn_S_21.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_RC_2);
    let a_Ho_3 = turn_S_31.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3);
    let a_S_in_F_1 = (-a_Ho_2).mul_add(sin_delta, a_Ho_1 * cos_delta);
    let a_S_in_F_2 = a_Ho_2.mul_add(cos_delta, a_Ho_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_2_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let a_Ho_1_2_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_2 = turn_F_11.mul_add(a_Ho_1_2_of_place, -a_S_in_F_1)
        - turn_F_13 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_2_2 = turn_F_21.mul_add(a_Ho_1_2_of_place, -a_S_in_F_2)
        - turn_F_23 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_3_2 = turn_F_31.mul_add(a_Ho_1_2_of_place, a_Ho_3)
        + turn_F_33 * a_Ho_1_2_of_lam_rr_xh_zh;
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let alpha_F_in_H_1 = (-alpha_F_1).mul_add(cos_lam, alpha_B_in_S_3 * sin_lam);
    let alpha_F_in_H_3 = alpha_F_1.mul_add(sin_lam, alpha_B_in_S_3 * cos_lam);
    let a_FC_1 = turn_F_11.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_1)
        + turn_F_13 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_2 = turn_F_21.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_2)
        + turn_F_23 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_3 = turn_F_31.mul_add(ratio_theta_u1_of_c_lam_rf, -a_Ho_3)
        - turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 - w_FW_in_F_2;
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_in_F_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2) + u3 * ratio_thF_u3_2;
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_FW_1 = alpha_F_1 + alpha_FW_in_F_1;
    let alpha_f_2_doubled = S::int(2) * alpha_F_2;
    let alpha_FW_2 = alpha_f_2_doubled - alpha_FW_in_F_2;
    let alpha_FW_3 = alpha_B_in_S_3 - alpha_FW_in_F_3;
    let F_w_FW_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let F_w_FW_2 = (-F_w_FW_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2);
    let F_v_FC_3 = mF * a_FC_3;
    let F_v_FC_2 = mF * a_FC_2;
    let F_v_FC_1 = mF * a_FC_1;
    let F_v_Ho_3 = mH * a_Ho_3_2;
    let F_v_Ho_2 = mH * a_Ho_2_2;
    let F_v_Ho_1 = mH * a_Ho_1_2;
    let F_v_S_in_F_2 = F_v_FC_2 - F_v_Ho_2;
    let F_v_S_in_F_1 = F_v_FC_1 - F_v_Ho_1;
    let F_v_Ho_3_2 = F_v_FC_3 - F_v_Ho_3;
    let F_v_Ho_2_2 = (-F_v_S_in_F_1).mul_add(sin_delta, F_v_S_in_F_2 * cos_delta);
    let F_v_B_in_S_1 = F_v_S_in_F_1.mul_add(cos_delta, F_v_S_in_F_2 * sin_delta);
    let F_v_Bo_3 = mB * a_Bo_3;
    let F_v_Bo_2 = mB * a_Bo_2;
    let F_v_Bo_1 = mB * a_Bo_1;
    let F_v_L_in_B_3 = F_v_B_in_S_1.mul_add(sin_lam, F_v_Ho_3_2 * cos_lam) - F_v_Bo_3;
    let F_v_L_in_B_1 = (-F_v_B_in_S_1).mul_add(cos_lam, F_v_Ho_3_2 * sin_lam) - F_v_Bo_1;
    let F_v_RC_2 = mR.mul_add(a_RC_2, -F_v_Ho_2_2) - F_v_Bo_2;
    let F_v_RC_1 = F_v_L_in_B_3.mul_add(sin_theta, mR * a_RC_1) + F_v_L_in_B_1 * cos_theta;
    let F_w_F_in_H_3 = (-w_S_in_F_2).mul_add(H_fork_1, w_F_in_H_1 * H_fork_2)
        - IHxz * alpha_F_in_H_1 - IHzz * alpha_F_in_H_3;
    let F_w_F_in_H_1 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        - IHxx * alpha_F_in_H_1 - IHxz * alpha_F_in_H_3;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let F_w_F_3 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + F_w_F_in_H_3 * cos_lam + F_w_F_in_H_1 * sin_lam
        - F_v_FC_2 * ratio_theta_u1_of_c_lam_rf - F_v_Ho_2 * a_Ho_1_2_of_place
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, -alpha_FW_3);
    let F_w_S_in_F_2_of_place = (-w_F_in_H_3).mul_add(H_fork_1, w_F_in_H_1 * H_fork_3);
    let F_w_S_in_F_2_of_place_2 = F_v_Ho_3
        .mul_add(a_Ho_1_2_of_place, F_v_FC_3 * ratio_theta_u1_of_c_lam_rf);
    let F_w_S_in_F_2_of_place_3 = F_v_Ho_1
        .mul_add(a_Ho_1_2_of_lam_rr_xh_zh, -F_w_S_in_F_2_of_place);
    let F_w_S_in_F_2_of_place_4 = F_w_S_in_F_2_of_place_2 - F_w_S_in_F_2_of_place_3;
    let F_w_S_in_F_2 = (-F_v_FC_1).mul_add(ratio_thF_u1_2_of_w_lam_rr_rf, F_w_FW_2)
        - IHyy * alpha_f_2_doubled - S::int(2) * F_w_S_in_F_2_of_place_4;
    let F_w_S_in_F_1 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - F_w_F_in_H_3 * sin_lam + F_w_F_in_H_1 * cos_lam
        + F_v_FC_2 * ratio_theta_u1_of_w_lam_rr_rf - F_v_Ho_2 * a_Ho_1_2_of_lam_rr_xh_zh
        + IFxx * (-w_F_3).mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1);
    let F_w_B_in_S_3 = F_v_Ho_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -F_w_F_3);
    let F_w_B_in_S_1 = (F_w_S_in_F_1 * cos_delta)
        .mul_add(S::int(2), F_w_S_in_F_2 * sin_delta);
    let w_l_in_b_3_doubled = S::int(2) * w_L_in_B_3;
    let w_l_in_b_1_doubled = S::int(2) * w_L_in_B_1;
    let xb_doubled = S::int(2) * xB;
    let rr_plus_zb_doubled = S::int(2) * rr_plus_zb;
    let F_w_B_2_of_place = (-IByy)
        .mul_add(alpha_B_2, F_v_Ho_3_2 * ratio_theta_u1_of_w_c_lam_rr);
    let F_w_B_2 = (-F_w_S_in_F_2).mul_add(cos_delta, F_w_S_in_F_1 * sin_delta_doubled)
        + H_frame_1 * w_l_in_b_3_doubled + H_frame_3 * w_l_in_b_1_doubled
        - F_v_Bo_3 * xb_doubled + F_v_Bo_1 * rr_plus_zb_doubled + S::int(2) * F_w_B_2_of_place;
    let w_b_2_doubled = S::int(2) * w_B_2;
    let alpha_b_1_doubled = S::int(2) * alpha_B_1;
    let alpha_b_3_doubled = S::int(2) * alpha_B_3;
    let f_w_b_in_s_3_doubled = S::int(2) * F_w_B_in_S_3;
    let F_w_L_in_B_3 = H_frame_2.mul_add(w_l_in_b_1_doubled, F_w_B_in_S_1 * sin_lam)
        + F_v_Bo_2 * xb_doubled - H_frame_1 * w_b_2_doubled + IBxz * alpha_b_1_doubled
        + IBzz * alpha_b_3_doubled + f_w_b_in_s_3_doubled * cos_lam;
    let F_w_L_in_B_1 = (-F_w_B_in_S_1).mul_add(cos_lam, H_frame_2 * w_l_in_b_3_doubled)
        - F_v_Bo_2 * rr_plus_zb_doubled + H_frame_3 * w_b_2_doubled
        + IBxx * alpha_b_1_doubled + IBxz * alpha_b_3_doubled + f_w_b_in_s_3_doubled * sin_lam;
    let F_w_RW_2 = w_Y_in_L_3.mul_add(H_rear_wheel_1, IRyy * alpha_L_2) - u1 * H_rear_wheel_3;
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let F_w_Y_in_L_3_of_u1 = u1.mul_add(H_rear_wheel_2, w_Y_in_L_2 * H_rear_wheel_1);
    let F_w_Y_in_L_3_of_u1_2 = IRxx * u1.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_3)
        - F_w_Y_in_L_3_of_u1;
    let F_w_Y_in_L_3 = (-F_w_L_in_B_1).mul_add(sin_theta, F_w_L_in_B_3 * cos_theta)
        - S::int(2) * F_w_Y_in_L_3_of_u1_2;
    let F_w_Y_in_L_2_of_place = rR.mul_add(F_v_RC_1, F_w_RW_2);
    let F_w_Y_in_L_2 = F_w_Y_in_L_2_of_place.mul_add(S::int(2), F_w_B_2);
    let f_w_fw_2_halved = S::ratio(1, 2) * F_w_FW_2;
    let f1_of_place = (-F_w_Y_in_L_3).mul_add(cos_phi, F_w_Y_in_L_2 * sin_phi);
    let f1_of_place_halved = S::ratio(1, 2) * f1_of_place;
    let f_w_b_2_halved = S::ratio(1, 2) * F_w_B_2;
    let f1_of_place_2 = F_w_L_in_B_1.mul_add(cos_theta, F_w_L_in_B_3 * sin_theta);
    // Values.
    let f1 = rR * F_v_RC_2 - w_Y_in_L_3 * H_rear_wheel_2 - w_Y_in_L_2 * H_rear_wheel_3
        + IRxx * w_Y_in_L_3.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_in_L_1)
        - ratio_thF_u1 * f_w_fw_2_halved - ratio_psi_u1 * f1_of_place_halved
        + ratio_theta_u1 * f_w_b_2_halved - S::ratio(1, 2) * f1_of_place_2;
    let f2 = (-ratio_thF_u2).mul_add(f_w_fw_2_halved, F_w_F_3)
        - ratio_psi_u2 * f1_of_place_halved + ratio_theta_u2 * f_w_b_2_halved;
    let f3 = (-ratio_thF_u3).mul_add(f_w_fw_2_halved, F_w_Y_in_L_2_of_place)
        - ratio_psi_u3 * f1_of_place_halved;
    [f1, f2, f3]
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 1740 operations, 8 sines and cosines, 2 other functions.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> [S; 3] {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [_, _, psi, phi, theta, delta, thR, thF] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_psi_u1_of_place = cos_lam_plus_theta * sin_delta;
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
    let c_cos_lam = c * cos_lam;
    let ratio_theta_u1_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let ratio_theta_u1_of_place_9 = ratio_theta_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_8, -ratio_theta_u1_of_c_lam_rf);
    let ratio_psi_u1_of_place_2 = -ratio_psi_u1_of_place * ratio_theta_u1_of_place_9;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let ratio_theta_u1_of_place_10 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_10;
    let ratio_theta_u1_of_place_12 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_3 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_4 = (-ratio_theta_u1_of_place_12)
        .mul_add(
            ratio_psi_u1_of_place_3,
            -ratio_theta_u1_of_place_9 * sin_lam_plus_theta,
        );
    let ratio_psi_u1_of_place_5 = ratio_psi_u1_of_place * ratio_theta_u1_of_place_12;
    let ratio_psi_u1_of_place_6 = ratio_theta_u1_of_place_12 * sin_delta;
    let ratio_psi_u1_of_place_7 = -ratio_theta_u1_of_place_12 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_8 = -ratio_theta_u1_of_place_9 * cos_delta;
    let ratio_psi_u1_of_place_9 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_8;
    let ratio_psi_u1_of_place_10 = (-ratio_psi_u1_of_place)
        .mul_add(
            ratio_psi_u1_of_place_6,
            ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_7,
        ) + ratio_psi_u1_of_place_9 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_13 = -ratio_theta_u1_of_place_9;
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let ratio_theta_u1_of_place_14 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, sin_delta_cos_phi);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_theta_u1_of_place_15 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
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
        * ratio_theta_u1_of_w_c_lam_rr.mul_add(sin_lam_plus_theta, rR);
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
    let ratio_theta_u1_of_place_29 = ratio_theta_u1_of_place_13
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_30 = ratio_theta_u1_of_place_28 - ratio_theta_u1_of_place_29;
    let ratio_theta_u1_of_place_31 = S::int(1)
        / ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_26,
                ratio_theta_u1_of_place * ratio_theta_u1_of_place_12,
            ) - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_30);
    let ratio_theta_u1 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_19,
                ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_14,
            ) - ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_20
            + ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_22 + ratio_theta_u1_of_place_23);
    let ratio_psi_u1_of_place_11 = (-ratio_psi_u1_of_place_2)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place * ratio_psi_u1_of_place_4)
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_5
        + ratio_theta_u1 * ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * w_plus_c.mul_add(cos_lam_plus_theta, rr_minus_rf * sin_lam_plus_theta);
    let ratio_psi_u1_of_place_13 = ratio_psi_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_14 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_15 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_14, ratio_psi_u1_of_place_13 * cos_phi);
    let ratio_psi_u1_of_place_16 = ratio_psi_u1_of_place * ratio_psi_u1_of_place_15;
    let ratio_psi_u1_of_place_17 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_of_w_c_lam_rr, rR * cos_phi);
    let ratio_psi_u1_of_place_18 = (-ratio_psi_u1_of_place_7)
        .mul_add(
            ratio_theta_u1_of_place_14,
            ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_15,
        ) + ratio_psi_u1_of_place_9 * ratio_theta_u1_of_place_20;
    let ratio_psi_u1_of_place_19 = (-ratio_psi_u1_of_place_5)
        .mul_add(ratio_theta_u1_of_place_14, ratio_psi_u1_of_place_17)
        - ratio_psi_u1_of_place_4 * ratio_theta_u1_of_place_15
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_of_place_20
        + ratio_theta_u1 * ratio_psi_u1_of_place_18;
    let ratio_psi_u1_of_place_20 = ratio_theta_u1_of_place_15 * ratio_psi_u1_of_place_15;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_psi_u1_of_place_20,
            ratio_psi_u1_of_place_11 * ratio_psi_u1_of_place_16,
        );
    let ratio_theta_u2_of_place = ratio_theta_u1_of_place_2
        .mul_add(
            ratio_theta_u1_of_place_18,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_8,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_10)
            .mul_add(
                ratio_theta_u1_of_place_24,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_13,
            ) - ratio_theta_u1_of_place_2 * ratio_theta_u2_of_place);
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u2 * ratio_psi_u1_of_place_10);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_15,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_20
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_16 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_16;
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
    let ratio_thF_u1_of_place_5 = (-sin_lam)
        .mul_add(
            cos_delta,
            ratio_thF_u1_of_place_3 * sin_delta * ratio_thF_u1_of_place_4,
        );
    let ratio_thF_u1_of_place_6 = cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam;
    let ratio_thF_u1_of_place_7 = rF
        .mul_add(ratio_thF_u1_of_place_5, -ratio_thF_u1_of_place_6);
    let ratio_thF_u1_of_place_8 = (-ratio_thF_u1_of_place_7)
        .mul_add(cos_lam_plus_theta, ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta);
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_9 = ratio_psi_u1_of_place_15 * ratio_thF_u1_of_place_4;
    let ratio_thF_u1_of_place_10 = rf_inv * ratio_thF_u1_of_place_9;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_10;
    let ratio_thF_u1_of_place_12 = -ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_9;
    let ratio_thF_u1_of_place_13 = (-ratio_theta_u1_of_place_2)
        .mul_add(
            ratio_theta_u1_of_w_lam_rr_rf,
            ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_of_place_10,
        );
    let ratio_thF_u1_of_place_14 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12;
    let ratio_thF_u1_of_place_15 = ratio_thF_u1_of_place_12
        .mul_add(sin_lam_plus_theta, ratio_theta_u1_of_place_23)
        + ratio_psi_u1_of_place * ratio_thF_u1_of_place_13
        - ratio_psi_u1_of_place_3 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_of_place_16 = ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_15;
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u3_of_place = ratio_thF_u1_of_place_6
        .mul_add(rf_inv, -ratio_thF_u1_of_place_5);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_w_lam_rr_rf)
        .mul_add(sin_lam_plus_theta, ratio_thF_u3_of_place * cos_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = rR * ratio_thF_u1_of_place_9;
    let ratio_thF_u3 = ratio_thF_u3_of_place_2 * ratio_thF_u3_of_place_3;
    let w_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_2 = w_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let w_Y_in_L_3 = w_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-u1).mul_add(sin_theta, w_Y_in_L_3 * cos_theta);
    let w_B_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let w_B_2 = w_B_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_in_S_1 = w_L_in_B_3.mul_add(sin_lam, w_L_in_B_1 * cos_lam);
    let w_B_in_S_3 = (-w_L_in_B_1).mul_add(sin_lam, w_L_in_B_3 * cos_lam);
    let w_S_in_F_1 = w_B_in_S_1.mul_add(cos_delta, w_B_2 * sin_delta);
    let w_S_in_F_2 = (-w_B_2).mul_add(cos_delta, w_B_in_S_1 * sin_delta);
    let w_F_3 = u2 - w_B_in_S_3;
    let w_F_in_H_1 = w_F_3.mul_add(sin_lam, w_S_in_F_1 * cos_lam);
    let w_F_in_H_3 = (-w_S_in_F_1).mul_add(sin_lam, w_F_3 * cos_lam);
    let w_F_in_FW_1 = (-w_S_in_F_1).mul_add(cos_thF, w_F_3 * sin_thF);
    let w_F_in_FW_3 = w_F_3.mul_add(cos_thF, w_S_in_F_1 * sin_thF);
    let ratio_theta_u1_2_of_u1_u2 = w_B_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_2 = (-ratio_theta_u1_of_place_10)
        .mul_add(w_B_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_2 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_3;
    let ratio_theta_u1_2_of_u1_u2_5 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_6 = (-ratio_theta_u1_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_2 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_7 = -ratio_theta_u1_2_of_u1_u2_5 - ratio_theta_u1_2_of_u1_u2_6;
    let ratio_theta_u1_2_of_u1_u2_8 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_4,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_7,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_8,
            ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = w_B_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_u1_u2_9 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_psi_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_9);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place_9)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_8 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_12 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_8)
        .mul_add(cos_delta, -ratio_theta_u1_of_place_9 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place
        .mul_add(w_B_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_11 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_9);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_11
        .mul_add(sin_delta, ratio_theta_u1_of_place_12 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_12 = ratio_theta_u1_2_of_u1_u2_11 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_12)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_12);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_6)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_of_place_20 * w_B_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_14 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_5 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_13 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_15 = -ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_16 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_7
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_u1_u2_4, ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u1_2_of_u1_u2_19 = (ratio_psi_u1_of_place * w_B_2_of_u1_u2)
        .mul_add(sin_phi, u1 * ratio_theta_u1_of_place_4) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_20 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_21 = (-u1)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_u1_u2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_22 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_23 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_13, u1 * ratio_psi_u1_of_place_17);
    let sin_delta_doubled = S::int(2) * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_2
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_u1_u2_10)
                .mul_add(sin_delta_doubled, ratio_theta_u1_of_place_10 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_15
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_24);
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_30 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_11
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_11)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_24 * u2_cos_delta)
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_10 * sin_delta
                - ratio_theta_u1_2_of_u1_u2_12
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_18)
        + ratio_theta_u1_of_place_10
            * ratio_theta_u1_of_place_13
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_25);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_14
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_14,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_18
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_19)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_19
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_21
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_22,
                        )) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_psi_u1_2_of_u1_u2_14 = (-ratio_theta_u1_2)
        .mul_add(
            ratio_psi_u1_of_place_10,
            ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2,
        ) + ratio_psi_u1_2_of_u1_u2_2 * sin_lam_plus_theta
        + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_u1_u2_3
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_7
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_13;
    let ratio_psi_u1_2_of_u1_u2_15 = (-ratio_theta_u1_of_place_20)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_10,
            ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_11,
        ) + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_12
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_21;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_18, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_13 * u1_sin_phi
        + ratio_psi_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_3
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2
                + ratio_psi_u1_of_place_12 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_16
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_20
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_19);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_7
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_4
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_18
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_4))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_7
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_13)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_10)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_15,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_18,
        ) - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_16 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_20 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_5;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_thF_u1_of_place * ratio_theta_u1_2_of_u1_u2_6
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_u1_u2_6 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_theta_u1_of_place_9)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_7,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_8,
            ) - ratio_thF_u1_of_place_13 * ratio_psi_u1_2_of_u1_u2
        + ratio_thF_u1_of_place_12 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_thF_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place
            * ratio_theta_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_10,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_4,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_7,
                ) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_7,
                ) + S::int(2) * ratio_theta_u1_of_place_4 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_w_lam_rr_rf = S::int(2) * ratio_theta_u1_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_7 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_thF_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_6
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_2_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_8 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_7);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_8,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = S::int(2) * ratio_thF_u3_of_w_lam_rr_rf
        * ratio_psi_u1_2_of_u1_u2_3 + ratio_thF_u3_of_place * ratio_psi_u1_2_of_u1_u2_6
        + cos_lam_plus_theta * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6);
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let alpha_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2_2, u1 * ratio_psi_u1_2)
        + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2 = alpha_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let alpha_Y_in_L_3 = alpha_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_13 = u1 * w_Y_in_L_3;
    let alpha_L_2 = alpha_Y_in_L_2 + w_L_13;
    let alpha_L_3 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3);
    let w_L_11 = u1 * u1;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let w_L_23 = w_Y_in_L_2 * w_Y_in_L_3;
    let turn_L_13 = alpha_L_2 + w_L_13;
    let turn_L_33 = w_L_11 + w_L_22;
    let alpha_L_in_B_1 = alpha_L_3 * sin_theta;
    let alpha_L_in_B_3 = alpha_L_3 * cos_theta;
    let alpha_B_1 = w_L_in_B_3.mul_add(w_B_2_of_u1_u2, -alpha_L_in_B_1);
    let alpha_B_2 = u2.mul_add(ratio_theta_u2_2, u1 * ratio_theta_u1_2) - alpha_L_2;
    let alpha_B_3 = w_L_in_B_1.mul_add(w_B_2_of_u1_u2, alpha_L_in_B_3);
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let turn_B_13 = alpha_B_2 - w_B_13;
    let turn_B_21 = alpha_B_3 + w_B_12;
    let turn_B_23 = alpha_B_1 + w_B_23;
    let turn_B_31 = alpha_B_2 + w_B_13;
    let turn_B_33 = w_B_11 + w_B_22;
    let alpha_B_in_S_1 = (-alpha_B_1).mul_add(cos_lam, alpha_B_3 * sin_lam);
    let alpha_B_in_S_3 = alpha_B_3.mul_add(cos_lam, alpha_B_1 * sin_lam);
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let turn_S_21 = alpha_B_in_S_3 + w_S_12;
    let turn_S_31 = alpha_B_2 + w_S_13;
    let alpha_S_in_F_1 = (-alpha_B_2).mul_add(sin_delta, alpha_B_in_S_1 * cos_delta);
    let alpha_S_in_F_2 = alpha_B_in_S_1.mul_add(sin_delta, alpha_B_2 * cos_delta);
    let alpha_F_1 = u2.mul_add(w_S_in_F_2, alpha_S_in_F_1);
    let alpha_F_2 = u2.mul_add(w_S_in_F_1, -alpha_S_in_F_2);
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_13 = alpha_F_2 - w_F_13;
    let turn_F_21 = alpha_B_in_S_3 - w_F_12;
    let turn_F_23 = alpha_F_1 - w_F_23;
    let turn_F_31 = alpha_F_2 + w_F_13;
    let turn_F_33 = w_F_11 + w_F_22;
    let v_N_in_Y_1 = rR * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let a_N_in_Y_2 = u3 * v_N_in_Y_1 * w_Y_in_L_2_of_u1_u2_u3;
    let a_Y_in_L_2 = (-g).mul_add(sin_phi, a_N_in_Y_2 * cos_phi);
    let a_Y_in_L_3 = a_N_in_Y_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_1 = rR * turn_L_13;
    let a_RC_2 = rR.mul_add(w_L_23, -a_Y_in_L_2);
    let a_RC_3 = rR.mul_add(turn_L_33, -a_Y_in_L_3);
    let H_rear_wheel_1 = IRxx * u1;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let alpha_RW_3 = alpha_L_3 + alpha_RW_in_L_3;
    let a_L_in_B_1 = (-a_RC_1).mul_add(cos_theta, a_RC_3 * sin_theta);
    let a_L_in_B_3 = a_RC_3.mul_add(cos_theta, a_RC_1 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1 = xB.mul_add(turn_B_11, a_L_in_B_1) - turn_B_13 * rr_plus_zb;
    let a_Bo_2 = xB.mul_add(turn_B_21, -a_RC_2) - turn_B_23 * rr_plus_zb;
    let a_Bo_3 = xB.mul_add(turn_B_31, -a_L_in_B_3) + turn_B_33 * rr_plus_zb;
    let H_frame_1 = (-IBxz).mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = (-IBzz).mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let a_B_in_S_1 = a_L_in_B_3.mul_add(sin_lam, a_L_in_B_1 * cos_lam);
    let a_B_in_S_3 = (-a_L_in_B_1).mul_add(sin_lam, a_L_in_B_3 * cos_lam);
    let a_Ho_1 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1);
    let a_Ho_2 = turn_S_21.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_RC_2);
    let a_Ho_3 = turn_S_31.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3);
    let a_S_in_F_1 = (-a_Ho_2).mul_add(sin_delta, a_Ho_1 * cos_delta);
    let a_S_in_F_2 = a_Ho_2.mul_add(cos_delta, a_Ho_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_2_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let a_Ho_1_2_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_2 = turn_F_11.mul_add(a_Ho_1_2_of_place, -a_S_in_F_1)
        - turn_F_13 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_2_2 = turn_F_21.mul_add(a_Ho_1_2_of_place, -a_S_in_F_2)
        - turn_F_23 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_3_2 = turn_F_31.mul_add(a_Ho_1_2_of_place, a_Ho_3)
        + turn_F_33 * a_Ho_1_2_of_lam_rr_xh_zh;
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let alpha_F_in_H_1 = (-alpha_F_1).mul_add(cos_lam, alpha_B_in_S_3 * sin_lam);
    let alpha_F_in_H_3 = alpha_F_1.mul_add(sin_lam, alpha_B_in_S_3 * cos_lam);
    let a_FC_1 = turn_F_11.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_1)
        + turn_F_13 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_2 = turn_F_21.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_2)
        + turn_F_23 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_3 = turn_F_31.mul_add(ratio_theta_u1_of_c_lam_rf, -a_Ho_3)
        - turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 - w_FW_in_F_2;
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_in_F_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2) + u3 * ratio_thF_u3_2;
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_FW_1 = alpha_F_1 + alpha_FW_in_F_1;
    let alpha_f_2_doubled = S::int(2) * alpha_F_2;
    let alpha_FW_2 = alpha_f_2_doubled - alpha_FW_in_F_2;
    let alpha_FW_3 = alpha_B_in_S_3 - alpha_FW_in_F_3;
    let F_w_FW_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let F_w_FW_2 = (-F_w_FW_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2);
    let F_v_FC_3 = mF * a_FC_3;
    let F_v_FC_2 = mF * a_FC_2;
    let F_v_FC_1 = mF * a_FC_1;
    let F_v_Ho_3 = mH * a_Ho_3_2;
    let F_v_Ho_2 = mH * a_Ho_2_2;
    let F_v_Ho_1 = mH * a_Ho_1_2;
    let F_v_S_in_F_2 = F_v_FC_2 - F_v_Ho_2;
    let F_v_S_in_F_1 = F_v_FC_1 - F_v_Ho_1;
    let F_v_Ho_3_2 = F_v_FC_3 - F_v_Ho_3;
    let F_v_Ho_2_2 = (-F_v_S_in_F_1).mul_add(sin_delta, F_v_S_in_F_2 * cos_delta);
    let F_v_B_in_S_1 = F_v_S_in_F_1.mul_add(cos_delta, F_v_S_in_F_2 * sin_delta);
    let F_v_Bo_3 = mB * a_Bo_3;
    let F_v_Bo_2 = mB * a_Bo_2;
    let F_v_Bo_1 = mB * a_Bo_1;
    let F_v_L_in_B_3 = F_v_B_in_S_1.mul_add(sin_lam, F_v_Ho_3_2 * cos_lam) - F_v_Bo_3;
    let F_v_L_in_B_1 = (-F_v_B_in_S_1).mul_add(cos_lam, F_v_Ho_3_2 * sin_lam) - F_v_Bo_1;
    let F_v_RC_2 = mR.mul_add(a_RC_2, -F_v_Ho_2_2) - F_v_Bo_2;
    let F_v_RC_1 = F_v_L_in_B_3.mul_add(sin_theta, mR * a_RC_1) + F_v_L_in_B_1 * cos_theta;
    let F_w_F_in_H_3 = (-w_S_in_F_2).mul_add(H_fork_1, w_F_in_H_1 * H_fork_2)
        - IHxz * alpha_F_in_H_1 - IHzz * alpha_F_in_H_3;
    let F_w_F_in_H_1 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        - IHxx * alpha_F_in_H_1 - IHxz * alpha_F_in_H_3;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let F_w_F_3 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + F_w_F_in_H_3 * cos_lam + F_w_F_in_H_1 * sin_lam
        - F_v_FC_2 * ratio_theta_u1_of_c_lam_rf - F_v_Ho_2 * a_Ho_1_2_of_place
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, -alpha_FW_3);
    let F_w_S_in_F_2_of_place = (-w_F_in_H_3).mul_add(H_fork_1, w_F_in_H_1 * H_fork_3);
    let F_w_S_in_F_2_of_place_2 = F_v_Ho_3
        .mul_add(a_Ho_1_2_of_place, F_v_FC_3 * ratio_theta_u1_of_c_lam_rf);
    let F_w_S_in_F_2_of_place_3 = F_v_Ho_1
        .mul_add(a_Ho_1_2_of_lam_rr_xh_zh, -F_w_S_in_F_2_of_place);
    let F_w_S_in_F_2_of_place_4 = F_w_S_in_F_2_of_place_2 - F_w_S_in_F_2_of_place_3;
    let F_w_S_in_F_2 = (-F_v_FC_1).mul_add(ratio_thF_u1_2_of_w_lam_rr_rf, F_w_FW_2)
        - IHyy * alpha_f_2_doubled - S::int(2) * F_w_S_in_F_2_of_place_4;
    let F_w_S_in_F_1 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - F_w_F_in_H_3 * sin_lam + F_w_F_in_H_1 * cos_lam
        + F_v_FC_2 * ratio_theta_u1_of_w_lam_rr_rf - F_v_Ho_2 * a_Ho_1_2_of_lam_rr_xh_zh
        + IFxx * (-w_F_3).mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1);
    let F_w_B_in_S_3 = F_v_Ho_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -F_w_F_3);
    let F_w_B_in_S_1 = (F_w_S_in_F_1 * cos_delta)
        .mul_add(S::int(2), F_w_S_in_F_2 * sin_delta);
    let w_l_in_b_3_doubled = S::int(2) * w_L_in_B_3;
    let w_l_in_b_1_doubled = S::int(2) * w_L_in_B_1;
    let xb_doubled = S::int(2) * xB;
    let rr_plus_zb_doubled = S::int(2) * rr_plus_zb;
    let F_w_B_2_of_place = (-IByy)
        .mul_add(alpha_B_2, F_v_Ho_3_2 * ratio_theta_u1_of_w_c_lam_rr);
    let F_w_B_2 = (-F_w_S_in_F_2).mul_add(cos_delta, F_w_S_in_F_1 * sin_delta_doubled)
        + H_frame_1 * w_l_in_b_3_doubled + H_frame_3 * w_l_in_b_1_doubled
        - F_v_Bo_3 * xb_doubled + F_v_Bo_1 * rr_plus_zb_doubled + S::int(2) * F_w_B_2_of_place;
    let w_b_2_doubled = S::int(2) * w_B_2;
    let alpha_b_1_doubled = S::int(2) * alpha_B_1;
    let alpha_b_3_doubled = S::int(2) * alpha_B_3;
    let f_w_b_in_s_3_doubled = S::int(2) * F_w_B_in_S_3;
    let F_w_L_in_B_3 = H_frame_2.mul_add(w_l_in_b_1_doubled, F_w_B_in_S_1 * sin_lam)
        + F_v_Bo_2 * xb_doubled - H_frame_1 * w_b_2_doubled + IBxz * alpha_b_1_doubled
        + IBzz * alpha_b_3_doubled + f_w_b_in_s_3_doubled * cos_lam;
    let F_w_L_in_B_1 = (-F_w_B_in_S_1).mul_add(cos_lam, H_frame_2 * w_l_in_b_3_doubled)
        - F_v_Bo_2 * rr_plus_zb_doubled + H_frame_3 * w_b_2_doubled
        + IBxx * alpha_b_1_doubled + IBxz * alpha_b_3_doubled + f_w_b_in_s_3_doubled * sin_lam;
    let F_w_RW_2 = w_Y_in_L_3.mul_add(H_rear_wheel_1, IRyy * alpha_L_2) - u1 * H_rear_wheel_3;
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let F_w_Y_in_L_3_of_u1 = u1.mul_add(H_rear_wheel_2, w_Y_in_L_2 * H_rear_wheel_1);
    let F_w_Y_in_L_3_of_u1_2 = IRxx * u1.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_3)
        - F_w_Y_in_L_3_of_u1;
    let F_w_Y_in_L_3 = (-F_w_L_in_B_1).mul_add(sin_theta, F_w_L_in_B_3 * cos_theta)
        - S::int(2) * F_w_Y_in_L_3_of_u1_2;
    let F_w_Y_in_L_2_of_place = rR.mul_add(F_v_RC_1, F_w_RW_2);
    let F_w_Y_in_L_2 = F_w_Y_in_L_2_of_place.mul_add(S::int(2), F_w_B_2);
    let w_Y_in_L_2_2 = ratio_psi_u1 * sin_phi;
    let w_Y_in_L_3_2 = ratio_psi_u1 * cos_phi;
    let w_L_in_B_1_2 = w_Y_in_L_3_2.mul_add(sin_theta, cos_theta);
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, sin_theta);
    let w_B_2_2 = ratio_theta_u1 - w_Y_in_L_2_2;
    let w_B_in_S_1_2 = (-w_L_in_B_1_2).mul_add(cos_lam, w_L_in_B_3_2 * sin_lam);
    let w_B_in_S_3_2 = w_L_in_B_3_2.mul_add(cos_lam, w_L_in_B_1_2 * sin_lam);
    let w_S_in_F_1_2 = (-w_B_2_2).mul_add(sin_delta, w_B_in_S_1_2 * cos_delta);
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_B_2_2 * cos_delta);
    let w_F_in_H_1_2 = (-w_S_in_F_1_2).mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let w_F_in_H_3_2 = w_S_in_F_1_2.mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let v_RC_1 = rR * w_Y_in_L_2_2;
    let H_rear_wheel_2_2 = IRyy * w_Y_in_L_2_2;
    let H_rear_wheel_3_2 = IRxx * w_Y_in_L_3_2;
    let v_L_in_B_1 = v_RC_1 * cos_theta;
    let v_L_in_B_3 = v_RC_1 * sin_theta;
    let v_Bo_1 = w_B_2_2.mul_add(rr_plus_zb, v_L_in_B_1);
    let v_Bo_2 = xB.mul_add(w_L_in_B_3_2, rR) - w_L_in_B_1_2 * rr_plus_zb;
    let v_Bo_3 = xB.mul_add(w_B_2_2, -v_L_in_B_3);
    let H_frame_1_2 = IBxz.mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let H_frame_2_2 = IByy * w_B_2_2;
    let H_frame_3_2 = IBzz.mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let v_B_in_S_1 = (-v_L_in_B_1).mul_add(cos_lam, v_L_in_B_3 * sin_lam);
    let v_B_in_S_3 = v_L_in_B_3.mul_add(cos_lam, v_L_in_B_1 * sin_lam);
    let v_Ho_2 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, rR);
    let v_Ho_3 = w_B_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3);
    let v_S_in_F_1 = (-v_Ho_2).mul_add(sin_delta, v_B_in_S_1 * cos_delta);
    let v_S_in_F_2 = v_Ho_2.mul_add(cos_delta, v_B_in_S_1 * sin_delta);
    let v_Ho_1 = w_S_in_F_2_2.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, -v_S_in_F_1);
    let v_Ho_2_2 = w_B_in_S_3_2.mul_add(a_Ho_1_2_of_place, -v_S_in_F_2)
        - w_S_in_F_1_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let v_Ho_3_2 = w_S_in_F_2_2.mul_add(a_Ho_1_2_of_place, -v_Ho_3);
    let H_fork_1_2 = IHxz.mul_add(w_F_in_H_3_2, IHxx * w_F_in_H_1_2);
    let H_fork_2_2 = IHyy * w_S_in_F_2_2;
    let H_fork_3_2 = IHzz.mul_add(w_F_in_H_3_2, IHxz * w_F_in_H_1_2);
    let v_FC_1 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -v_S_in_F_1);
    let v_FC_2 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_c_lam_rf, v_S_in_F_2)
        + w_S_in_F_1_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_c_lam_rf, v_Ho_3);
    let w_FW_2_2 = ratio_thF_u1 + w_S_in_F_2_2;
    let H_front_wheel_1_2 = IFxx * w_S_in_F_1_2;
    let H_front_wheel_2_2 = IFyy * w_FW_2_2;
    let H_front_wheel_3_2 = IFxx * w_B_in_S_3_2;
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
    let p_v_RC_2 = rR.mul_add(mR, p_v_Ho_2_2) + p_v_Bo_2;
    let p_v_RC_1 = (-p_v_L_in_B_3).mul_add(sin_theta, mR * v_RC_1) - p_v_L_in_B_1 * cos_theta;
    let p_w_F_3 = H_fork_3_2.mul_add(cos_lam, H_fork_1_2 * sin_lam) + H_front_wheel_3_2
        + p_v_FC_2 * ratio_theta_u1_of_c_lam_rf + p_v_Ho_2 * a_Ho_1_2_of_place;
    let p_w_S_in_F_2 = p_v_FC_3
        .mul_add(ratio_theta_u1_of_c_lam_rf, H_fork_2_2 + H_front_wheel_2_2)
        + p_v_FC_1 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_3 * a_Ho_1_2_of_place
        + p_v_Ho_1 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_S_in_F_1 = (-H_fork_1_2).mul_add(cos_lam, H_fork_3_2 * sin_lam)
        + H_front_wheel_1_2 + p_v_FC_2 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_B_in_S_3 = p_v_Ho_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3);
    let p_w_B_in_S_1 = p_w_S_in_F_1.mul_add(cos_delta, p_w_S_in_F_2 * sin_delta);
    let p_w_B_2 = xB.mul_add(p_v_Bo_3, H_frame_2_2) + p_w_S_in_F_2 * cos_delta
        - p_w_S_in_F_1 * sin_delta + p_v_Ho_3_2 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1 * rr_plus_zb;
    let p_w_L_in_B_3 = xB.mul_add(p_v_Bo_2, H_frame_3_2) + p_w_B_in_S_3 * cos_lam
        + p_w_B_in_S_1 * sin_lam;
    let p_w_L_in_B_1 = p_w_B_in_S_3.mul_add(sin_lam, H_frame_1_2)
        - p_w_B_in_S_1 * cos_lam - p_v_Bo_2 * rr_plus_zb;
    let p_w_Y_in_L_3 = (-p_w_L_in_B_3).mul_add(cos_theta, H_rear_wheel_3_2)
        + p_w_L_in_B_1 * sin_theta;
    let p_w_Y_in_L_2 = rR.mul_add(p_v_RC_1, H_rear_wheel_2_2) - p_w_B_2;
    let w_Y_in_L_2_3 = ratio_psi_u2 * sin_phi;
    let w_Y_in_L_3_3 = ratio_psi_u2 * cos_phi;
    let w_L_in_B_1_3 = w_Y_in_L_3_3 * sin_theta;
    let w_L_in_B_3_3 = w_Y_in_L_3_3 * cos_theta;
    let w_B_2_3 = ratio_theta_u2 - w_Y_in_L_2_3;
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_1_3 = w_B_in_S_1_3.mul_add(cos_delta, w_B_2_3 * sin_delta);
    let w_S_in_F_2_3 = (-w_B_2_3).mul_add(cos_delta, w_B_in_S_1_3 * sin_delta);
    let w_F_3_2 = w_B_in_S_3_3 - S::int(1);
    let w_F_in_H_1_3 = (-w_S_in_F_1_3).mul_add(cos_lam, w_F_3_2 * sin_lam);
    let w_F_in_H_3_3 = w_F_3_2.mul_add(cos_lam, w_S_in_F_1_3 * sin_lam);
    let v_RC_1_2 = rR * w_Y_in_L_2_3;
    let H_rear_wheel_2_3 = IRyy * w_Y_in_L_2_3;
    let H_rear_wheel_3_3 = IRxx * w_Y_in_L_3_3;
    let v_L_in_B_1_2 = v_RC_1_2 * cos_theta;
    let v_L_in_B_3_2 = v_RC_1_2 * sin_theta;
    let v_Bo_1_2 = w_B_2_3.mul_add(rr_plus_zb, v_L_in_B_1_2);
    let v_Bo_2_2 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let v_Bo_3_2 = xB.mul_add(w_B_2_3, -v_L_in_B_3_2);
    let H_frame_1_3 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let H_frame_2_3 = IByy * w_B_2_3;
    let H_frame_3_3 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let v_B_in_S_1_2 = (-v_L_in_B_1_2).mul_add(cos_lam, v_L_in_B_3_2 * sin_lam);
    let v_B_in_S_3_2 = v_L_in_B_3_2.mul_add(cos_lam, v_L_in_B_1_2 * sin_lam);
    let v_Ho_2_3 = w_B_in_S_3_3 * ratio_theta_u1_of_w_c_lam_rr;
    let v_Ho_3_3 = w_B_2_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3_2);
    let v_S_in_F_1_2 = v_Ho_2_3.mul_add(sin_delta, v_B_in_S_1_2 * cos_delta);
    let v_S_in_F_2_2 = (-v_Ho_2_3).mul_add(cos_delta, v_B_in_S_1_2 * sin_delta);
    let v_Ho_1_2 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, v_S_in_F_1_2);
    let v_Ho_2_4 = w_F_3_2.mul_add(a_Ho_1_2_of_place, v_S_in_F_2_2)
        - w_S_in_F_1_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let v_Ho_3_4 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_place, v_Ho_3_3);
    let H_fork_1_3 = IHxz.mul_add(w_F_in_H_3_3, IHxx * w_F_in_H_1_3);
    let H_fork_2_3 = IHyy * w_S_in_F_2_3;
    let H_fork_3_3 = IHzz.mul_add(w_F_in_H_3_3, IHxz * w_F_in_H_1_3);
    let v_FC_1_2 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_2);
    let v_FC_2_2 = w_F_3_2.mul_add(ratio_theta_u1_of_c_lam_rf, -v_S_in_F_2_2)
        + w_S_in_F_1_3 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_2 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_c_lam_rf, -v_Ho_3_3);
    let w_FW_2_3 = ratio_thF_u2 - w_S_in_F_2_3;
    let H_front_wheel_1_3 = IFxx * w_S_in_F_1_3;
    let H_front_wheel_2_3 = IFyy * w_FW_2_3;
    let H_front_wheel_3_3 = IFxx * w_F_3_2;
    let p_v_FC_3_2 = mF * v_FC_3_2;
    let p_v_FC_2_2 = mF * v_FC_2_2;
    let p_v_FC_1_2 = mF * v_FC_1_2;
    let p_v_Ho_3_3 = mH * v_Ho_3_4;
    let p_v_Ho_2_3 = mH * v_Ho_2_4;
    let p_v_Ho_1_2 = mH * v_Ho_1_2;
    let p_v_S_in_F_2_2 = p_v_FC_2_2 - p_v_Ho_2_3;
    let p_v_S_in_F_1_2 = p_v_FC_1_2 + p_v_Ho_1_2;
    let p_v_Ho_3_4 = p_v_FC_3_2 - p_v_Ho_3_3;
    let p_v_Ho_2_4 = p_v_S_in_F_1_2.mul_add(sin_delta, p_v_S_in_F_2_2 * cos_delta);
    let p_v_B_in_S_1_2 = (-p_v_S_in_F_1_2)
        .mul_add(cos_delta, p_v_S_in_F_2_2 * sin_delta);
    let p_v_Bo_3_2 = mB * v_Bo_3_2;
    let p_v_Bo_2_2 = mB * v_Bo_2_2;
    let p_v_Bo_1_2 = mB * v_Bo_1_2;
    let p_v_L_in_B_3_2 = (-p_v_B_in_S_1_2).mul_add(sin_lam, p_v_Ho_3_4 * cos_lam) - p_v_Bo_3_2;
    let p_v_L_in_B_1_2 = p_v_B_in_S_1_2.mul_add(cos_lam, p_v_Ho_3_4 * sin_lam) + p_v_Bo_1_2;
    let p_v_RC_2_2 = p_v_Ho_2_4 + p_v_Bo_2_2;
    let p_v_RC_1_2 = p_v_L_in_B_3_2.mul_add(sin_theta, mR * v_RC_1_2) + p_v_L_in_B_1_2 * cos_theta;
    let p_w_F_3_2 = H_fork_3_3.mul_add(cos_lam, H_fork_1_3 * sin_lam) + H_front_wheel_3_3
        + p_v_FC_2_2 * ratio_theta_u1_of_c_lam_rf + p_v_Ho_2_3 * a_Ho_1_2_of_place;
    let p_w_S_in_F_2_2 = p_v_FC_3_2
        .mul_add(ratio_theta_u1_of_c_lam_rf, H_fork_2_3 - H_front_wheel_2_3)
        + p_v_FC_1_2 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_3_3 * a_Ho_1_2_of_place
        + p_v_Ho_1_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_S_in_F_1_2 = (-H_fork_1_3).mul_add(cos_lam, H_fork_3_3 * sin_lam)
        + H_front_wheel_1_3 + p_v_FC_2_2 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_B_in_S_3_2 = p_v_Ho_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3_2);
    let p_w_B_in_S_1_2 = p_w_S_in_F_1_2.mul_add(cos_delta, p_w_S_in_F_2_2 * sin_delta);
    let p_w_B_2_2 = xB.mul_add(p_v_Bo_3_2, H_frame_2_3) - p_w_S_in_F_2_2 * cos_delta
        + p_w_S_in_F_1_2 * sin_delta - p_v_Ho_3_4 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1_2 * rr_plus_zb;
    let p_w_L_in_B_3_2 = (-xB).mul_add(p_v_Bo_2_2, H_frame_3_3)
        - p_w_B_in_S_3_2 * cos_lam - p_w_B_in_S_1_2 * sin_lam;
    let p_w_L_in_B_1_2 = (-p_w_B_in_S_3_2).mul_add(sin_lam, H_frame_1_3)
        + p_w_B_in_S_1_2 * cos_lam + p_v_Bo_2_2 * rr_plus_zb;
    let p_w_Y_in_L_3_2 = (-p_w_L_in_B_3_2).mul_add(cos_theta, H_rear_wheel_3_3)
        + p_w_L_in_B_1_2 * sin_theta;
    let p_w_Y_in_L_2_2 = rR.mul_add(p_v_RC_1_2, H_rear_wheel_2_3) - p_w_B_2_2;
    let w_Y_in_L_2_4 = ratio_psi_u3 * sin_phi;
    let w_Y_in_L_3_4 = ratio_psi_u3 * cos_phi;
    let w_RW_2_2 = w_Y_in_L_2_4 - S::int(1);
    let w_L_in_B_1_4 = w_Y_in_L_3_4 * sin_theta;
    let w_L_in_B_3_4 = w_Y_in_L_3_4 * cos_theta;
    let w_B_in_S_1_4 = w_L_in_B_3_4.mul_add(sin_lam, w_L_in_B_1_4 * cos_lam);
    let w_B_in_S_3_4 = (-w_L_in_B_1_4).mul_add(sin_lam, w_L_in_B_3_4 * cos_lam);
    let w_S_in_F_1_4 = (-w_Y_in_L_2_4).mul_add(sin_delta, w_B_in_S_1_4 * cos_delta);
    let w_S_in_F_2_4 = w_B_in_S_1_4.mul_add(sin_delta, w_Y_in_L_2_4 * cos_delta);
    let w_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let v_RC_1_3 = rR.mul_add(w_Y_in_L_2_4, -v_N_in_Y_1);
    let H_rear_wheel_2_4 = IRyy * w_RW_2_2;
    let H_rear_wheel_3_4 = IRxx * w_Y_in_L_3_4;
    let v_L_in_B_1_3 = v_RC_1_3 * cos_theta;
    let v_L_in_B_3_3 = v_RC_1_3 * sin_theta;
    let v_Bo_1_3 = w_Y_in_L_2_4.mul_add(rr_plus_zb, -v_L_in_B_1_3);
    let v_Bo_2_3 = w_L_in_B_1_4.mul_add(rr_plus_zb, xB * w_L_in_B_3_4);
    let v_Bo_3_3 = xB.mul_add(w_Y_in_L_2_4, v_L_in_B_3_3);
    let H_frame_1_4 = (-IBxz).mul_add(w_L_in_B_3_4, IBxx * w_L_in_B_1_4);
    let H_frame_2_4 = IByy * w_Y_in_L_2_4;
    let H_frame_3_4 = (-IBzz).mul_add(w_L_in_B_3_4, IBxz * w_L_in_B_1_4);
    let v_B_in_S_1_3 = (-v_L_in_B_1_3).mul_add(cos_lam, v_L_in_B_3_3 * sin_lam);
    let v_B_in_S_3_3 = v_L_in_B_3_3.mul_add(cos_lam, v_L_in_B_1_3 * sin_lam);
    let v_Ho_2_5 = w_B_in_S_3_4 * ratio_theta_u1_of_w_c_lam_rr;
    let v_Ho_3_5 = w_Y_in_L_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, v_B_in_S_3_3);
    let v_S_in_F_1_3 = v_Ho_2_5.mul_add(sin_delta, v_B_in_S_1_3 * cos_delta);
    let v_S_in_F_2_3 = (-v_Ho_2_5).mul_add(cos_delta, v_B_in_S_1_3 * sin_delta);
    let v_Ho_1_3 = w_S_in_F_2_4.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, v_S_in_F_1_3);
    let v_Ho_2_6 = w_B_in_S_3_4.mul_add(a_Ho_1_2_of_place, v_S_in_F_2_3)
        - w_S_in_F_1_4 * a_Ho_1_2_of_lam_rr_xh_zh;
    let v_Ho_3_6 = w_S_in_F_2_4.mul_add(a_Ho_1_2_of_place, -v_Ho_3_5);
    let H_fork_1_4 = IHxz.mul_add(w_F_in_H_3_4, IHxx * w_F_in_H_1_4);
    let H_fork_2_4 = IHyy * w_S_in_F_2_4;
    let H_fork_3_4 = IHzz.mul_add(w_F_in_H_3_4, IHxz * w_F_in_H_1_4);
    let v_FC_1_3 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_3);
    let v_FC_2_3 = w_B_in_S_3_4.mul_add(ratio_theta_u1_of_c_lam_rf, -v_S_in_F_2_3)
        + w_S_in_F_1_4 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_3 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_c_lam_rf, v_Ho_3_5);
    let w_FW_2_4 = ratio_thF_u3 - w_S_in_F_2_4;
    let H_front_wheel_1_4 = IFxx * w_S_in_F_1_4;
    let H_front_wheel_2_4 = IFyy * w_FW_2_4;
    let H_front_wheel_3_4 = IFxx * w_B_in_S_3_4;
    let p_v_FC_3_3 = mF * v_FC_3_3;
    let p_v_FC_2_3 = mF * v_FC_2_3;
    let p_v_FC_1_3 = mF * v_FC_1_3;
    let p_v_Ho_3_5 = mH * v_Ho_3_6;
    let p_v_Ho_2_5 = mH * v_Ho_2_6;
    let p_v_Ho_1_3 = mH * v_Ho_1_3;
    let p_v_S_in_F_2_3 = p_v_FC_2_3 - p_v_Ho_2_5;
    let p_v_S_in_F_1_3 = p_v_FC_1_3 + p_v_Ho_1_3;
    let p_v_Ho_3_6 = p_v_FC_3_3 - p_v_Ho_3_5;
    let p_v_Ho_2_6 = p_v_S_in_F_1_3.mul_add(sin_delta, p_v_S_in_F_2_3 * cos_delta);
    let p_v_B_in_S_1_3 = (-p_v_S_in_F_1_3)
        .mul_add(cos_delta, p_v_S_in_F_2_3 * sin_delta);
    let p_v_Bo_3_3 = mB * v_Bo_3_3;
    let p_v_Bo_2_3 = mB * v_Bo_2_3;
    let p_v_Bo_1_3 = mB * v_Bo_1_3;
    let p_v_L_in_B_3_3 = (-p_v_B_in_S_1_3).mul_add(sin_lam, p_v_Ho_3_6 * cos_lam) + p_v_Bo_3_3;
    let p_v_L_in_B_1_3 = p_v_B_in_S_1_3.mul_add(cos_lam, p_v_Ho_3_6 * sin_lam) - p_v_Bo_1_3;
    let p_v_RC_2_3 = p_v_Ho_2_6 + p_v_Bo_2_3;
    let p_v_RC_1_3 = p_v_L_in_B_3_3.mul_add(sin_theta, mR * v_RC_1_3) + p_v_L_in_B_1_3 * cos_theta;
    let p_w_F_3_3 = H_fork_3_4.mul_add(cos_lam, H_fork_1_4 * sin_lam) + H_front_wheel_3_4
        + p_v_FC_2_3 * ratio_theta_u1_of_c_lam_rf + p_v_Ho_2_5 * a_Ho_1_2_of_place;
    let p_w_S_in_F_2_3 = p_v_FC_3_3
        .mul_add(ratio_theta_u1_of_c_lam_rf, H_fork_2_4 - H_front_wheel_2_4)
        + p_v_FC_1_3 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_3_5 * a_Ho_1_2_of_place
        + p_v_Ho_1_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_S_in_F_1_3 = (-H_fork_1_4).mul_add(cos_lam, H_fork_3_4 * sin_lam)
        + H_front_wheel_1_4 + p_v_FC_2_3 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2_5 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_B_in_S_3_3 = p_v_Ho_2_6.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3_3);
    let p_w_B_in_S_1_3 = p_w_S_in_F_1_3.mul_add(cos_delta, p_w_S_in_F_2_3 * sin_delta);
    let p_w_B_2_3 = xB.mul_add(p_v_Bo_3_3, H_frame_2_4) + p_w_S_in_F_2_3 * cos_delta
        - p_w_S_in_F_1_3 * sin_delta + p_v_Ho_3_6 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1_3 * rr_plus_zb;
    let p_w_L_in_B_3_3 = (-xB).mul_add(p_v_Bo_2_3, H_frame_3_4)
        - p_w_B_in_S_3_3 * cos_lam - p_w_B_in_S_1_3 * sin_lam;
    let p_w_L_in_B_1_3 = (-p_w_B_in_S_3_3).mul_add(sin_lam, H_frame_1_4)
        + p_w_B_in_S_1_3 * cos_lam + p_v_Bo_2_3 * rr_plus_zb;
    let p_w_Y_in_L_3_3 = (-p_w_L_in_B_3_3).mul_add(cos_theta, H_rear_wheel_3_4)
        + p_w_L_in_B_1_3 * sin_theta;
    let p_w_Y_in_L_2_3_of_place = rR.mul_add(p_v_RC_1_3, H_rear_wheel_2_4);
    let p_w_Y_in_L_2_3 = p_w_B_2_3 + p_w_Y_in_L_2_3_of_place;
    let d1_of_place = p_w_Y_in_L_2_2.mul_add(sin_phi, p_w_Y_in_L_3_2 * cos_phi);
    let d1 = ratio_thF_u2.mul_add(H_front_wheel_2_3, -p_w_F_3_2)
        + ratio_theta_u2 * p_w_B_2_2 + ratio_psi_u2 * d1_of_place;
    let l2_of_place = (-rR).mul_add(p_v_RC_2_2, ratio_thF_u1 * H_front_wheel_2_3)
        + ratio_theta_u1 * p_w_B_2_2 + p_w_L_in_B_3_2 * sin_theta
        + p_w_L_in_B_1_2 * cos_theta + ratio_psi_u1 * d1_of_place;
    let d1_inv = S::int(1) / d1;
    let l2 = l2_of_place * d1_inv;
    let s3 = IRxx + ratio_thF_u1 * H_front_wheel_2_2 + rR * p_v_RC_2
        + ratio_theta_u1 * p_w_B_2 + p_w_L_in_B_3 * sin_theta + p_w_L_in_B_1 * cos_theta
        + ratio_psi_u1 * p_w_Y_in_L_2.mul_add(sin_phi, p_w_Y_in_L_3 * cos_phi) - l2 * l2_of_place;
    let s4_of_place = p_w_Y_in_L_2_3.mul_add(sin_phi, p_w_Y_in_L_3_3 * cos_phi);
    let s4_of_place_2 = (-ratio_thF_u2).mul_add(H_front_wheel_2_4, p_w_F_3_3)
        + ratio_theta_u2 * p_w_B_2_3 - ratio_psi_u2 * s4_of_place;
    let s4 = (-rR).mul_add(p_v_RC_2_3, ratio_thF_u1 * H_front_wheel_2_4)
        - ratio_theta_u1 * p_w_B_2_3 + p_w_L_in_B_3_3 * sin_theta
        + p_w_L_in_B_1_3 * cos_theta + ratio_psi_u1 * s4_of_place + l2 * s4_of_place_2;
    let f_w_fw_2_halved = S::ratio(1, 2) * F_w_FW_2;
    let r5_of_place = (-F_w_Y_in_L_3).mul_add(cos_phi, F_w_Y_in_L_2 * sin_phi);
    let r5_of_place_halved = S::ratio(1, 2) * r5_of_place;
    let r5_of_place_2 = (-F_w_F_3).mul_add(S::int(2), ratio_thF_u2 * F_w_FW_2);
    let r5_of_place_3 = (-ratio_theta_u2).mul_add(F_w_B_2, ratio_psi_u2 * r5_of_place);
    let r5_of_place_4 = r5_of_place_2 + r5_of_place_3;
    let minus_r5_of_place_4 = -r5_of_place_4;
    let r5_of_place_5 = S::ratio(1, 2) * minus_r5_of_place_4;
    let r5_of_place_6 = (-F_w_L_in_B_3).mul_add(sin_theta, ratio_theta_u1 * F_w_B_2);
    let r5_of_place_7 = F_w_L_in_B_1.mul_add(cos_theta, -r5_of_place_6);
    let r5 = rR * F_v_RC_2 - w_Y_in_L_3 * H_rear_wheel_2 - w_Y_in_L_2 * H_rear_wheel_3
        + IRxx * w_Y_in_L_3.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_in_L_1)
        - ratio_thF_u1 * f_w_fw_2_halved - ratio_psi_u1 * r5_of_place_halved
        - l2 * r5_of_place_5 - S::ratio(1, 2) * r5_of_place_7;
    let l6 = -d1_inv * s4_of_place_2;
    let s7 = ratio_thF_u3.mul_add(H_front_wheel_2_4, -p_w_Y_in_L_2_3_of_place)
        + ratio_psi_u3 * s4_of_place + l6 * s4_of_place_2;
    let r8 = (-ratio_thF_u3).mul_add(f_w_fw_2_halved, F_w_Y_in_L_2_of_place)
        - ratio_psi_u3 * r5_of_place_halved - l6 * r5_of_place_5;
    let s3_inv = S::int(1) / s3;
    let l9 = s4 * s3_inv;
    let s10 = (-s4).mul_add(l9, s7);
    let r11 = (-r5).mul_add(l9, r8);
    let u3_dot = r11 / s10;
    let u1_dot = s3_inv * (-u3_dot).mul_add(s4, r5);
    let u2_dot_of_motion = (-u3_dot).mul_add(s4_of_place_2, u1_dot * l2_of_place);
    let u2_dot = -S::ratio(1, 2) * d1_inv * u2_dot_of_motion.mul_add(S::int(2), r5_of_place_4);
    [u1_dot, u2_dot, u3_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 253 operations, 5 sines and cosines, 2 other functions.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> [S; 8] {
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

/// Kinetic energy T.
///
/// 409 operations, 6 sines and cosines, 2 other functions.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> S {
    let Parameters {
        w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx, IHxz,
        IHyy, IHzz, rF, mF, IFxx, IFyy,
        ..
    } = *p;
    let [_, _, psi, phi, theta, delta, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let ratio_theta_u1_of_c_lam_rf = (-rF).mul_add(sin_lam, c * cos_lam);
    let ratio_psi_u1_of_c_lam_rf = -ratio_theta_u1_of_c_lam_rf;
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_theta_u1_of_place = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let ratio_theta_u1_of_place_2 = (-ratio_theta_u1_of_place)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let ratio_theta_u1_of_place_3 = ratio_theta_u1_of_place * sin_delta;
    let ratio_theta_u1_of_place_4 = sin_phi_cos_delta + ratio_theta_u1_of_place_3;
    let ratio_theta_u1_of_place_5 = S::int(1)
        / ratio_theta_u1_of_place_4.mul_add(ratio_theta_u1_of_place_4, -S::int(1));
    let ratio_theta_u1_of_place_6 = cos_phi * sin_lam_plus_theta * sin_delta;
    let ratio_theta_u1_of_place_7 = rF * ratio_theta_u1_of_place_5
        * (S::int(1) - (ratio_theta_u1_of_place_6 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_theta_u1_of_place_8 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_7;
    let ratio_psi_u1_of_place = ratio_theta_u1_of_place_8 - ratio_psi_u1_of_c_lam_rf;
    let ratio_psi_u1_of_place_2 = cos_lam_plus_theta * sin_delta;
    let ratio_psi_u1_of_place_3 = -ratio_psi_u1_of_place * ratio_psi_u1_of_place_2;
    let ratio_theta_u1_of_place_9 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_10 = ratio_theta_u1_of_place_7 * ratio_theta_u1_of_place_9;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_10;
    let ratio_psi_u1_of_place_4 = -ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_5 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_6 = (-ratio_psi_u1_of_place)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5);
    let ratio_psi_u1_of_place_7 = -ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_4;
    let ratio_psi_u1_of_place_8 = -ratio_psi_u1_of_place_4 * sin_delta;
    let ratio_psi_u1_of_place_9 = ratio_psi_u1_of_place_4 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_10 = -ratio_psi_u1_of_place * cos_delta;
    let ratio_psi_u1_of_place_11 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = (-ratio_psi_u1_of_place_2)
        .mul_add(
            ratio_psi_u1_of_place_8,
            ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_9,
        ) + ratio_psi_u1_of_place_11 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_12 = -ratio_theta_u1_of_c_lam_rf - ratio_theta_u1_of_place_8;
    let ratio_theta_u1_of_place_13 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, cos_phi * sin_delta);
    let ratio_theta_u1_of_place_14 = (-cos_phi)
        .mul_add(cos_delta, sin_delta_sin_phi * sin_lam_plus_theta);
    let ratio_theta_u1_of_place_15 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_7;
    let ratio_theta_u1_of_place_16 = ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_15;
    let ratio_theta_u1_of_place_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_16;
    let ratio_theta_u1_of_place_18 = sin_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_19 = ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_16;
    let ratio_theta_u1_of_place_20 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(sin_lam_plus_theta, rR);
    let ratio_theta_u1_of_place_21 = ratio_theta_u1_of_place_20 * sin_phi;
    let ratio_theta_u1_of_place_22 = ratio_theta_u1_of_place_9 * sin_delta;
    let ratio_theta_u1_of_place_23 = ratio_theta_u1_of_place_19
        .mul_add(
            ratio_theta_u1_of_place_22,
            ratio_theta_u1_of_place * ratio_theta_u1_of_place_7,
        );
    let ratio_theta_u1_of_place_24 = ratio_theta_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_25 = S::int(1)
        / (-ratio_theta_u1_of_place_2
            * ratio_theta_u1_of_place_17
                .mul_add(
                    ratio_theta_u1_of_place_22,
                    ratio_theta_u1_of_place_10 * cos_delta,
                ) + ratio_theta_u1_of_place * ratio_theta_u1_of_place_11
            - ratio_theta_u1_of_place_9
                * (ratio_theta_u1_of_place_23 - ratio_theta_u1_of_place_24));
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
    let ratio_psi_u1_of_place_13 = (-ratio_psi_u1_of_place_3)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place_2 * ratio_psi_u1_of_place_6)
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_of_place_7
        + ratio_theta_u1 * ratio_psi_u1_of_place_12;
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
    let ratio_psi_u1_of_place_16 = (-ratio_psi_u1_of_place_9)
        .mul_add(
            ratio_theta_u1_of_place_13,
            ratio_psi_u1_of_place_8 * ratio_theta_u1_of_place_14,
        ) + ratio_psi_u1_of_place_11 * ratio_theta_u1_of_place_18;
    let ratio_psi_u1_of_place_17 = (-ratio_psi_u1_of_place_7)
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u1_of_place_20 * cos_phi)
        - ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_14
        - ratio_psi_u1_of_place_3 * ratio_theta_u1_of_place_18
        + ratio_theta_u1 * ratio_psi_u1_of_place_16;
    let ratio_psi_u1_of_place_18 = ratio_theta_u1_of_place_14 * ratio_psi_u1_of_place_14;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_17)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_psi_u1_of_place_13 * ratio_psi_u1_of_place_15,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_25
        * (-ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_9 * ratio_theta_u1_of_place_17
            + ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12
            - ratio_theta_u1_of_place_2
                * ratio_theta_u1_of_place_2
                    .mul_add(ratio_theta_u1_of_place_17, ratio_theta_u1_of_place_15));
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_12, ratio_theta_u2 * ratio_psi_u1_of_place_12);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_16,
            ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_14,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_18
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_15 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_15;
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_6))
        .sqrt();
    let ratio_thF_u1_of_place_2 = ratio_psi_u1_of_place_14 * ratio_thF_u1_of_place;
    let ratio_thF_u1_of_place_3 = rf_inv * ratio_thF_u1_of_place_2;
    let ratio_thF_u1_of_place_4 = ratio_theta_u1_of_place_4 * sin_delta * ratio_thF_u1_of_place
        / (-S::int(1) + sin_phi_cos_delta * sin_phi_cos_delta
            + ratio_theta_u1_of_place_3
                * sin_phi_cos_delta.mul_add(S::int(2), ratio_theta_u1_of_place_3))
        - sin_lam * cos_delta;
    let ratio_thF_u1_of_place_5 = cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam;
    let ratio_thF_u1_of_place_6 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_of_place_4, ratio_thF_u1_of_place_5)
        + ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta;
    let ratio_thF_u1_of_place_7 = ratio_psi_u1_of_place_2
        * (-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_w_lam_rr_rf,
                ratio_psi_u1_of_c_lam_rf * ratio_theta_u1_of_place_9,
            ) - ratio_theta_u1_of_place_4 * ratio_psi_u1_of_place * sin_lam_plus_theta
        + ratio_theta_u1_of_place_4 * ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5
        + ratio_theta_u1_of_place_21;
    let ratio_thF_u1 = ratio_thF_u1_of_place_3
        * (-ratio_psi_u1_of_place_17)
            .mul_add(
                ratio_thF_u1_of_place_7,
                ratio_psi_u1_of_place_13 * ratio_thF_u1_of_place_6,
            );
    let ratio_thF_u2 = ratio_thF_u1_of_place_3
        * ratio_psi_u2_of_place_2
            .mul_add(
                ratio_thF_u1_of_place_7,
                ratio_psi_u2_of_place * ratio_thF_u1_of_place_6,
            );
    let ratio_thF_u3 = -rR * ratio_thF_u1_of_place_2
        * (sin_lam_plus_theta * (cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam))
            + cos_lam_plus_theta
                * (-rf_inv).mul_add(ratio_thF_u1_of_place_5, ratio_thF_u1_of_place_4));
    let w_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_2 = w_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let w_Y_in_L_3 = w_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-u1).mul_add(sin_theta, w_Y_in_L_3 * cos_theta);
    let w_B_2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1) - w_Y_in_L_2;
    let w_B_in_S_1 = w_L_in_B_3.mul_add(sin_lam, w_L_in_B_1 * cos_lam);
    let w_B_in_S_3 = (-w_L_in_B_1).mul_add(sin_lam, w_L_in_B_3 * cos_lam);
    let w_S_in_F_1 = w_B_in_S_1.mul_add(cos_delta, w_B_2 * sin_delta);
    let w_S_in_F_2 = (-w_B_2).mul_add(cos_delta, w_B_in_S_1 * sin_delta);
    let w_F_3 = u2 - w_B_in_S_3;
    let w_F_in_H_1 = w_F_3.mul_add(sin_lam, w_S_in_F_1 * cos_lam);
    let w_F_in_H_3 = (-w_S_in_F_1).mul_add(sin_lam, w_F_3 * cos_lam);
    let H_rear_wheel_1 = IRxx * u1;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let H_frame_1 = (-IBxz).mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = (-IBzz).mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let w_FW_in_F_2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1) + u3 * ratio_thF_u3;
    let w_FW_2 = w_S_in_F_2 - w_FW_in_F_2;
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let v_N_in_Y_1_2 = rR * u3 * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let v_RC_1_4 = rR.mul_add(w_Y_in_L_2, -v_N_in_Y_1_2);
    let v_RC_2 = rR * u1;
    let v_L_in_B_1_4 = v_RC_1_4 * cos_theta;
    let v_L_in_B_3_4 = v_RC_1_4 * sin_theta;
    let rr_plus_zb = rR + zB;
    let v_Bo_1_4 = w_B_2.mul_add(rr_plus_zb, v_L_in_B_1_4);
    let v_Bo_2_4 = xB.mul_add(w_L_in_B_3, -v_RC_2) + w_L_in_B_1 * rr_plus_zb;
    let v_Bo_3_4 = xB.mul_add(w_B_2, -v_L_in_B_3_4);
    let v_B_in_S_1_4 = (-v_L_in_B_1_4).mul_add(cos_lam, v_L_in_B_3_4 * sin_lam);
    let v_B_in_S_3_4 = v_L_in_B_3_4.mul_add(cos_lam, v_L_in_B_1_4 * sin_lam);
    let v_Ho_2_7 = w_B_in_S_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_RC_2);
    let v_Ho_3_7 = w_B_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3_4);
    let v_S_in_F_1_4 = v_Ho_2_7.mul_add(sin_delta, v_B_in_S_1_4 * cos_delta);
    let v_S_in_F_2_4 = (-v_Ho_2_7).mul_add(cos_delta, v_B_in_S_1_4 * sin_delta);
    let rr_plus_zh = rR + zH;
    let v_Ho_1_4_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let v_Ho_1_4 = w_S_in_F_2.mul_add(v_Ho_1_4_of_lam_rr_xh_zh, v_S_in_F_1_4);
    let v_Ho_2_8_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let v_Ho_2_8 = w_S_in_F_1.mul_add(v_Ho_1_4_of_lam_rr_xh_zh, -v_S_in_F_2_4)
        + w_F_3 * v_Ho_2_8_of_place;
    let v_Ho_3_8 = w_S_in_F_2.mul_add(v_Ho_2_8_of_place, v_Ho_3_7);
    let v_FC_1_4 = w_S_in_F_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_4);
    let v_FC_2_4 = w_F_3.mul_add(ratio_psi_u1_of_c_lam_rf, v_S_in_F_2_4)
        - w_S_in_F_1 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_4 = w_S_in_F_2.mul_add(ratio_psi_u1_of_c_lam_rf, -v_Ho_3_7);
    let energy_of_place = v_Bo_2_4.mul_add(v_Bo_2_4, v_Bo_1_4 * v_Bo_1_4);
    let energy_of_place_2 = v_Ho_2_8.mul_add(v_Ho_2_8, v_Ho_1_4 * v_Ho_1_4);
    let energy_of_place_3 = v_FC_2_4.mul_add(v_FC_2_4, v_FC_1_4 * v_FC_1_4);
    let energy_of_u1 = w_RW_2.mul_add(H_rear_wheel_2, u1 * H_rear_wheel_1);
    let energy_of_place_4 = w_F_3.mul_add(H_front_wheel_3, w_FW_2 * H_front_wheel_2);
    let energy_of_u1_2 = mR * v_RC_2.mul_add(v_RC_2, v_RC_1_4 * v_RC_1_4) + energy_of_u1;
    let energy_of_place_5 = w_L_in_B_1.mul_add(H_frame_1, w_Y_in_L_3 * H_rear_wheel_3);
    let energy_of_place_6 = (-w_B_2).mul_add(H_frame_2, w_L_in_B_3 * H_frame_3);
    let energy_of_place_7 = w_S_in_F_2.mul_add(H_fork_2, w_F_in_H_1 * H_fork_1);
    let energy_of_place_8 = w_S_in_F_1.mul_add(H_front_wheel_1, w_F_in_H_3 * H_fork_3);
    let energy_of_place_9 = energy_of_place_5 - energy_of_place_6;
    let energy_of_place_10 = energy_of_place_7 + energy_of_place_8;
    let energy_of_u1_3 = energy_of_place_4 + energy_of_u1_2;
    let energy_of_place_11 = energy_of_place_9 + energy_of_place_10;
    let energy_of_u1_4 = energy_of_u1_3 + energy_of_place_11;
    // Values.
    let energy = S::ratio(1, 2) * mB * v_Bo_3_4.mul_add(v_Bo_3_4, energy_of_place)
        + S::ratio(1, 2) * mH * v_Ho_3_8.mul_add(v_Ho_3_8, energy_of_place_2)
        + S::ratio(1, 2) * mF * v_FC_3_4.mul_add(v_FC_3_4, energy_of_place_3)
        + S::ratio(1, 2) * energy_of_u1_4;
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
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
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
    let x_Y_in_L_2 = g * sin_phi;
    let x_Y_in_L_3 = g * cos_phi;
    let x_L_in_B_1 = x_Y_in_L_3 * sin_theta;
    let x_L_in_B_3 = x_Y_in_L_3 * cos_theta;
    let x_B_in_S_1 = x_L_in_B_3.mul_add(sin_lam, x_L_in_B_1 * cos_lam);
    let x_B_in_S_3 = (-x_L_in_B_1).mul_add(sin_lam, x_L_in_B_3 * cos_lam);
    let x_S_in_F_1 = (-x_Y_in_L_2).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let x_S_in_F_2 = x_B_in_S_1.mul_add(sin_delta, x_Y_in_L_2 * cos_delta);
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

/// Matrix of the linear system M(q) u' = f(q, u) row by row, and its right-hand side, which share terms.
///
/// 1707 operations, 8 sines and cosines, 2 other functions.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    u: &[S; 3],
) -> ([S; 9], [S; 3]) {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [_, _, psi, phi, theta, delta, thR, thF] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_psi_u1_of_place = cos_lam_plus_theta * sin_delta;
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
    let c_cos_lam = c * cos_lam;
    let ratio_theta_u1_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let ratio_theta_u1_of_place_9 = ratio_theta_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_8, -ratio_theta_u1_of_c_lam_rf);
    let ratio_psi_u1_of_place_2 = -ratio_psi_u1_of_place * ratio_theta_u1_of_place_9;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let ratio_theta_u1_of_place_10 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_10;
    let ratio_theta_u1_of_place_12 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_3 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_4 = (-ratio_theta_u1_of_place_12)
        .mul_add(
            ratio_psi_u1_of_place_3,
            -ratio_theta_u1_of_place_9 * sin_lam_plus_theta,
        );
    let ratio_psi_u1_of_place_5 = ratio_psi_u1_of_place * ratio_theta_u1_of_place_12;
    let ratio_psi_u1_of_place_6 = ratio_theta_u1_of_place_12 * sin_delta;
    let ratio_psi_u1_of_place_7 = -ratio_theta_u1_of_place_12 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_8 = -ratio_theta_u1_of_place_9 * cos_delta;
    let ratio_psi_u1_of_place_9 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_8;
    let ratio_psi_u1_of_place_10 = (-ratio_psi_u1_of_place)
        .mul_add(
            ratio_psi_u1_of_place_6,
            ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_7,
        ) + ratio_psi_u1_of_place_9 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_13 = -ratio_theta_u1_of_place_9;
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let ratio_theta_u1_of_place_14 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, sin_delta_cos_phi);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_theta_u1_of_place_15 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
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
        * ratio_theta_u1_of_w_c_lam_rr.mul_add(sin_lam_plus_theta, rR);
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
    let ratio_theta_u1_of_place_29 = ratio_theta_u1_of_place_13
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_30 = ratio_theta_u1_of_place_28 - ratio_theta_u1_of_place_29;
    let ratio_theta_u1_of_place_31 = S::int(1)
        / ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_26,
                ratio_theta_u1_of_place * ratio_theta_u1_of_place_12,
            ) - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_30);
    let ratio_theta_u1 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_19,
                ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_14,
            ) - ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_20
            + ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_22 + ratio_theta_u1_of_place_23);
    let ratio_psi_u1_of_place_11 = (-ratio_psi_u1_of_place_2)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place * ratio_psi_u1_of_place_4)
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_5
        + ratio_theta_u1 * ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * w_plus_c.mul_add(cos_lam_plus_theta, rr_minus_rf * sin_lam_plus_theta);
    let ratio_psi_u1_of_place_13 = ratio_psi_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_14 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_15 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_14, ratio_psi_u1_of_place_13 * cos_phi);
    let ratio_psi_u1_of_place_16 = ratio_psi_u1_of_place * ratio_psi_u1_of_place_15;
    let ratio_psi_u1_of_place_17 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_of_w_c_lam_rr, rR * cos_phi);
    let ratio_psi_u1_of_place_18 = (-ratio_psi_u1_of_place_7)
        .mul_add(
            ratio_theta_u1_of_place_14,
            ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_15,
        ) + ratio_psi_u1_of_place_9 * ratio_theta_u1_of_place_20;
    let ratio_psi_u1_of_place_19 = (-ratio_psi_u1_of_place_5)
        .mul_add(ratio_theta_u1_of_place_14, ratio_psi_u1_of_place_17)
        - ratio_psi_u1_of_place_4 * ratio_theta_u1_of_place_15
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_of_place_20
        + ratio_theta_u1 * ratio_psi_u1_of_place_18;
    let ratio_psi_u1_of_place_20 = ratio_theta_u1_of_place_15 * ratio_psi_u1_of_place_15;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_psi_u1_of_place_20,
            ratio_psi_u1_of_place_11 * ratio_psi_u1_of_place_16,
        );
    let ratio_theta_u2_of_place = ratio_theta_u1_of_place_2
        .mul_add(
            ratio_theta_u1_of_place_18,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_8,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_10)
            .mul_add(
                ratio_theta_u1_of_place_24,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_13,
            ) - ratio_theta_u1_of_place_2 * ratio_theta_u2_of_place);
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u2 * ratio_psi_u1_of_place_10);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_15,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_20
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_16 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_16;
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
    let ratio_thF_u1_of_place_5 = (-sin_lam)
        .mul_add(
            cos_delta,
            ratio_thF_u1_of_place_3 * sin_delta * ratio_thF_u1_of_place_4,
        );
    let ratio_thF_u1_of_place_6 = cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam;
    let ratio_thF_u1_of_place_7 = rF
        .mul_add(ratio_thF_u1_of_place_5, -ratio_thF_u1_of_place_6);
    let ratio_thF_u1_of_place_8 = (-ratio_thF_u1_of_place_7)
        .mul_add(cos_lam_plus_theta, ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta);
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_9 = ratio_psi_u1_of_place_15 * ratio_thF_u1_of_place_4;
    let ratio_thF_u1_of_place_10 = rf_inv * ratio_thF_u1_of_place_9;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_10;
    let ratio_thF_u1_of_place_12 = -ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_9;
    let ratio_thF_u1_of_place_13 = (-ratio_theta_u1_of_place_2)
        .mul_add(
            ratio_theta_u1_of_w_lam_rr_rf,
            ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_of_place_10,
        );
    let ratio_thF_u1_of_place_14 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12;
    let ratio_thF_u1_of_place_15 = ratio_thF_u1_of_place_12
        .mul_add(sin_lam_plus_theta, ratio_theta_u1_of_place_23)
        + ratio_psi_u1_of_place * ratio_thF_u1_of_place_13
        - ratio_psi_u1_of_place_3 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_of_place_16 = ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_15;
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u3_of_place = ratio_thF_u1_of_place_6
        .mul_add(rf_inv, -ratio_thF_u1_of_place_5);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_w_lam_rr_rf)
        .mul_add(sin_lam_plus_theta, ratio_thF_u3_of_place * cos_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = rR * ratio_thF_u1_of_place_9;
    let ratio_thF_u3 = ratio_thF_u3_of_place_2 * ratio_thF_u3_of_place_3;
    let w_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_2 = w_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let w_Y_in_L_3 = w_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-u1).mul_add(sin_theta, w_Y_in_L_3 * cos_theta);
    let w_B_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let w_B_2 = w_B_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_in_S_1 = w_L_in_B_3.mul_add(sin_lam, w_L_in_B_1 * cos_lam);
    let w_B_in_S_3 = (-w_L_in_B_1).mul_add(sin_lam, w_L_in_B_3 * cos_lam);
    let w_S_in_F_1 = w_B_in_S_1.mul_add(cos_delta, w_B_2 * sin_delta);
    let w_S_in_F_2 = (-w_B_2).mul_add(cos_delta, w_B_in_S_1 * sin_delta);
    let w_F_3 = u2 - w_B_in_S_3;
    let w_F_in_H_1 = w_F_3.mul_add(sin_lam, w_S_in_F_1 * cos_lam);
    let w_F_in_H_3 = (-w_S_in_F_1).mul_add(sin_lam, w_F_3 * cos_lam);
    let w_F_in_FW_1 = (-w_S_in_F_1).mul_add(cos_thF, w_F_3 * sin_thF);
    let w_F_in_FW_3 = w_F_3.mul_add(cos_thF, w_S_in_F_1 * sin_thF);
    let ratio_theta_u1_2_of_u1_u2 = w_B_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_2 = (-ratio_theta_u1_of_place_10)
        .mul_add(w_B_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_2 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_3;
    let ratio_theta_u1_2_of_u1_u2_5 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_6 = (-ratio_theta_u1_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_2 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_7 = -ratio_theta_u1_2_of_u1_u2_5 - ratio_theta_u1_2_of_u1_u2_6;
    let ratio_theta_u1_2_of_u1_u2_8 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_4,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_7,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_8,
            ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = w_B_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_u1_u2_9 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_psi_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_9);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place_9)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_8 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_12 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_8)
        .mul_add(cos_delta, -ratio_theta_u1_of_place_9 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place
        .mul_add(w_B_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_11 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_9);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_11
        .mul_add(sin_delta, ratio_theta_u1_of_place_12 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_12 = ratio_theta_u1_2_of_u1_u2_11 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_12)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_12);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_6)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_of_place_20 * w_B_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_14 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_5 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_13 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_15 = -ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_16 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_7
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_u1_u2_4, ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u1_2_of_u1_u2_19 = (ratio_psi_u1_of_place * w_B_2_of_u1_u2)
        .mul_add(sin_phi, u1 * ratio_theta_u1_of_place_4) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_20 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_21 = (-u1)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_u1_u2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_22 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_23 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_13, u1 * ratio_psi_u1_of_place_17);
    let sin_delta_doubled = S::int(2) * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_2
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_u1_u2_10)
                .mul_add(sin_delta_doubled, ratio_theta_u1_of_place_10 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_15
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_24);
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_30 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_11
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_11)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_24 * u2_cos_delta)
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_10 * sin_delta
                - ratio_theta_u1_2_of_u1_u2_12
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_18)
        + ratio_theta_u1_of_place_10
            * ratio_theta_u1_of_place_13
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_25);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_14
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_14,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_18
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_19)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_19
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_21
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_22,
                        )) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_psi_u1_2_of_u1_u2_14 = (-ratio_theta_u1_2)
        .mul_add(
            ratio_psi_u1_of_place_10,
            ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2,
        ) + ratio_psi_u1_2_of_u1_u2_2 * sin_lam_plus_theta
        + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_u1_u2_3
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_7
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_13;
    let ratio_psi_u1_2_of_u1_u2_15 = (-ratio_theta_u1_of_place_20)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_10,
            ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_11,
        ) + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_12
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_21;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_18, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_13 * u1_sin_phi
        + ratio_psi_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_3
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2
                + ratio_psi_u1_of_place_12 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_16
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_20
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_19);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_7
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_4
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_18
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_4))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_7
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_13)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_10)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_15,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_18,
        ) - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_16 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_20 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_5;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_thF_u1_of_place * ratio_theta_u1_2_of_u1_u2_6
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_u1_u2_6 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_theta_u1_of_place_9)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_7,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_8,
            ) - ratio_thF_u1_of_place_13 * ratio_psi_u1_2_of_u1_u2
        + ratio_thF_u1_of_place_12 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_thF_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place
            * ratio_theta_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_10,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_4,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_7,
                ) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_7,
                ) + S::int(2) * ratio_theta_u1_of_place_4 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_w_lam_rr_rf = S::int(2) * ratio_theta_u1_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_7 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_thF_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_6
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_2_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_8 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_7);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_8,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = S::int(2) * ratio_thF_u3_of_w_lam_rr_rf
        * ratio_psi_u1_2_of_u1_u2_3 + ratio_thF_u3_of_place * ratio_psi_u1_2_of_u1_u2_6
        + cos_lam_plus_theta * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6);
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let alpha_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2_2, u1 * ratio_psi_u1_2)
        + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2 = alpha_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let alpha_Y_in_L_3 = alpha_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_13 = u1 * w_Y_in_L_3;
    let alpha_L_2 = alpha_Y_in_L_2 + w_L_13;
    let alpha_L_3 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3);
    let w_L_11 = u1 * u1;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let w_L_23 = w_Y_in_L_2 * w_Y_in_L_3;
    let turn_L_13 = alpha_L_2 + w_L_13;
    let turn_L_33 = w_L_11 + w_L_22;
    let alpha_L_in_B_1 = alpha_L_3 * sin_theta;
    let alpha_L_in_B_3 = alpha_L_3 * cos_theta;
    let alpha_B_1 = w_L_in_B_3.mul_add(w_B_2_of_u1_u2, -alpha_L_in_B_1);
    let alpha_B_2 = u2.mul_add(ratio_theta_u2_2, u1 * ratio_theta_u1_2) - alpha_L_2;
    let alpha_B_3 = w_L_in_B_1.mul_add(w_B_2_of_u1_u2, alpha_L_in_B_3);
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let turn_B_13 = alpha_B_2 - w_B_13;
    let turn_B_21 = alpha_B_3 + w_B_12;
    let turn_B_23 = alpha_B_1 + w_B_23;
    let turn_B_31 = alpha_B_2 + w_B_13;
    let turn_B_33 = w_B_11 + w_B_22;
    let alpha_B_in_S_1 = (-alpha_B_1).mul_add(cos_lam, alpha_B_3 * sin_lam);
    let alpha_B_in_S_3 = alpha_B_3.mul_add(cos_lam, alpha_B_1 * sin_lam);
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let turn_S_21 = alpha_B_in_S_3 + w_S_12;
    let turn_S_31 = alpha_B_2 + w_S_13;
    let alpha_S_in_F_1 = (-alpha_B_2).mul_add(sin_delta, alpha_B_in_S_1 * cos_delta);
    let alpha_S_in_F_2 = alpha_B_in_S_1.mul_add(sin_delta, alpha_B_2 * cos_delta);
    let alpha_F_1 = u2.mul_add(w_S_in_F_2, alpha_S_in_F_1);
    let alpha_F_2 = u2.mul_add(w_S_in_F_1, -alpha_S_in_F_2);
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_13 = alpha_F_2 - w_F_13;
    let turn_F_21 = alpha_B_in_S_3 - w_F_12;
    let turn_F_23 = alpha_F_1 - w_F_23;
    let turn_F_31 = alpha_F_2 + w_F_13;
    let turn_F_33 = w_F_11 + w_F_22;
    let v_N_in_Y_1 = rR * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let a_N_in_Y_2 = u3 * v_N_in_Y_1 * w_Y_in_L_2_of_u1_u2_u3;
    let a_Y_in_L_2 = (-g).mul_add(sin_phi, a_N_in_Y_2 * cos_phi);
    let a_Y_in_L_3 = a_N_in_Y_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_1 = rR * turn_L_13;
    let a_RC_2 = rR.mul_add(w_L_23, -a_Y_in_L_2);
    let a_RC_3 = rR.mul_add(turn_L_33, -a_Y_in_L_3);
    let H_rear_wheel_1 = IRxx * u1;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let alpha_RW_3 = alpha_L_3 + alpha_RW_in_L_3;
    let a_L_in_B_1 = (-a_RC_1).mul_add(cos_theta, a_RC_3 * sin_theta);
    let a_L_in_B_3 = a_RC_3.mul_add(cos_theta, a_RC_1 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1 = xB.mul_add(turn_B_11, a_L_in_B_1) - turn_B_13 * rr_plus_zb;
    let a_Bo_2 = xB.mul_add(turn_B_21, -a_RC_2) - turn_B_23 * rr_plus_zb;
    let a_Bo_3 = xB.mul_add(turn_B_31, -a_L_in_B_3) + turn_B_33 * rr_plus_zb;
    let H_frame_1 = (-IBxz).mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = (-IBzz).mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let a_B_in_S_1 = a_L_in_B_3.mul_add(sin_lam, a_L_in_B_1 * cos_lam);
    let a_B_in_S_3 = (-a_L_in_B_1).mul_add(sin_lam, a_L_in_B_3 * cos_lam);
    let a_Ho_1 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1);
    let a_Ho_2 = turn_S_21.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_RC_2);
    let a_Ho_3 = turn_S_31.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3);
    let a_S_in_F_1 = (-a_Ho_2).mul_add(sin_delta, a_Ho_1 * cos_delta);
    let a_S_in_F_2 = a_Ho_2.mul_add(cos_delta, a_Ho_1 * sin_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_2_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let a_Ho_1_2_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_2 = turn_F_11.mul_add(a_Ho_1_2_of_place, -a_S_in_F_1)
        - turn_F_13 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_2_2 = turn_F_21.mul_add(a_Ho_1_2_of_place, -a_S_in_F_2)
        - turn_F_23 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_3_2 = turn_F_31.mul_add(a_Ho_1_2_of_place, a_Ho_3)
        + turn_F_33 * a_Ho_1_2_of_lam_rr_xh_zh;
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let alpha_F_in_H_1 = (-alpha_F_1).mul_add(cos_lam, alpha_B_in_S_3 * sin_lam);
    let alpha_F_in_H_3 = alpha_F_1.mul_add(sin_lam, alpha_B_in_S_3 * cos_lam);
    let a_FC_1 = turn_F_11.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_1)
        + turn_F_13 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_2 = turn_F_21.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_2)
        + turn_F_23 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_3 = turn_F_31.mul_add(ratio_theta_u1_of_c_lam_rf, -a_Ho_3)
        - turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 - w_FW_in_F_2;
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_in_F_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2) + u3 * ratio_thF_u3_2;
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_FW_1 = alpha_F_1 + alpha_FW_in_F_1;
    let alpha_f_2_doubled = S::int(2) * alpha_F_2;
    let alpha_FW_2 = alpha_f_2_doubled - alpha_FW_in_F_2;
    let alpha_FW_3 = alpha_B_in_S_3 - alpha_FW_in_F_3;
    let F_w_FW_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let F_w_FW_2 = (-F_w_FW_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2);
    let F_v_FC_3 = mF * a_FC_3;
    let F_v_FC_2 = mF * a_FC_2;
    let F_v_FC_1 = mF * a_FC_1;
    let F_v_Ho_3 = mH * a_Ho_3_2;
    let F_v_Ho_2 = mH * a_Ho_2_2;
    let F_v_Ho_1 = mH * a_Ho_1_2;
    let F_v_S_in_F_2 = F_v_FC_2 - F_v_Ho_2;
    let F_v_S_in_F_1 = F_v_FC_1 - F_v_Ho_1;
    let F_v_Ho_3_2 = F_v_FC_3 - F_v_Ho_3;
    let F_v_Ho_2_2 = (-F_v_S_in_F_1).mul_add(sin_delta, F_v_S_in_F_2 * cos_delta);
    let F_v_B_in_S_1 = F_v_S_in_F_1.mul_add(cos_delta, F_v_S_in_F_2 * sin_delta);
    let F_v_Bo_3 = mB * a_Bo_3;
    let F_v_Bo_2 = mB * a_Bo_2;
    let F_v_Bo_1 = mB * a_Bo_1;
    let F_v_L_in_B_3 = F_v_B_in_S_1.mul_add(sin_lam, F_v_Ho_3_2 * cos_lam) - F_v_Bo_3;
    let F_v_L_in_B_1 = (-F_v_B_in_S_1).mul_add(cos_lam, F_v_Ho_3_2 * sin_lam) - F_v_Bo_1;
    let F_v_RC_2 = mR.mul_add(a_RC_2, -F_v_Ho_2_2) - F_v_Bo_2;
    let F_v_RC_1 = F_v_L_in_B_3.mul_add(sin_theta, mR * a_RC_1) + F_v_L_in_B_1 * cos_theta;
    let F_w_F_in_H_3 = (-w_S_in_F_2).mul_add(H_fork_1, w_F_in_H_1 * H_fork_2)
        - IHxz * alpha_F_in_H_1 - IHzz * alpha_F_in_H_3;
    let F_w_F_in_H_1 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        - IHxx * alpha_F_in_H_1 - IHxz * alpha_F_in_H_3;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let F_w_F_3 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + F_w_F_in_H_3 * cos_lam + F_w_F_in_H_1 * sin_lam
        - F_v_FC_2 * ratio_theta_u1_of_c_lam_rf - F_v_Ho_2 * a_Ho_1_2_of_place
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, -alpha_FW_3);
    let F_w_S_in_F_2_of_place = (-w_F_in_H_3).mul_add(H_fork_1, w_F_in_H_1 * H_fork_3);
    let F_w_S_in_F_2_of_place_2 = F_v_Ho_3
        .mul_add(a_Ho_1_2_of_place, F_v_FC_3 * ratio_theta_u1_of_c_lam_rf);
    let F_w_S_in_F_2_of_place_3 = F_v_Ho_1
        .mul_add(a_Ho_1_2_of_lam_rr_xh_zh, -F_w_S_in_F_2_of_place);
    let F_w_S_in_F_2_of_place_4 = F_w_S_in_F_2_of_place_2 - F_w_S_in_F_2_of_place_3;
    let F_w_S_in_F_2 = (-F_v_FC_1).mul_add(ratio_thF_u1_2_of_w_lam_rr_rf, F_w_FW_2)
        - IHyy * alpha_f_2_doubled - S::int(2) * F_w_S_in_F_2_of_place_4;
    let F_w_S_in_F_1 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - F_w_F_in_H_3 * sin_lam + F_w_F_in_H_1 * cos_lam
        + F_v_FC_2 * ratio_theta_u1_of_w_lam_rr_rf - F_v_Ho_2 * a_Ho_1_2_of_lam_rr_xh_zh
        + IFxx * (-w_F_3).mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1);
    let F_w_B_in_S_3 = F_v_Ho_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -F_w_F_3);
    let F_w_B_in_S_1 = (F_w_S_in_F_1 * cos_delta)
        .mul_add(S::int(2), F_w_S_in_F_2 * sin_delta);
    let w_l_in_b_3_doubled = S::int(2) * w_L_in_B_3;
    let w_l_in_b_1_doubled = S::int(2) * w_L_in_B_1;
    let xb_doubled = S::int(2) * xB;
    let rr_plus_zb_doubled = S::int(2) * rr_plus_zb;
    let F_w_B_2_of_place = (-IByy)
        .mul_add(alpha_B_2, F_v_Ho_3_2 * ratio_theta_u1_of_w_c_lam_rr);
    let F_w_B_2 = (-F_w_S_in_F_2).mul_add(cos_delta, F_w_S_in_F_1 * sin_delta_doubled)
        + H_frame_1 * w_l_in_b_3_doubled + H_frame_3 * w_l_in_b_1_doubled
        - F_v_Bo_3 * xb_doubled + F_v_Bo_1 * rr_plus_zb_doubled + S::int(2) * F_w_B_2_of_place;
    let w_b_2_doubled = S::int(2) * w_B_2;
    let alpha_b_1_doubled = S::int(2) * alpha_B_1;
    let alpha_b_3_doubled = S::int(2) * alpha_B_3;
    let f_w_b_in_s_3_doubled = S::int(2) * F_w_B_in_S_3;
    let F_w_L_in_B_3 = H_frame_2.mul_add(w_l_in_b_1_doubled, F_w_B_in_S_1 * sin_lam)
        + F_v_Bo_2 * xb_doubled - H_frame_1 * w_b_2_doubled + IBxz * alpha_b_1_doubled
        + IBzz * alpha_b_3_doubled + f_w_b_in_s_3_doubled * cos_lam;
    let F_w_L_in_B_1 = (-F_w_B_in_S_1).mul_add(cos_lam, H_frame_2 * w_l_in_b_3_doubled)
        - F_v_Bo_2 * rr_plus_zb_doubled + H_frame_3 * w_b_2_doubled
        + IBxx * alpha_b_1_doubled + IBxz * alpha_b_3_doubled + f_w_b_in_s_3_doubled * sin_lam;
    let F_w_RW_2 = w_Y_in_L_3.mul_add(H_rear_wheel_1, IRyy * alpha_L_2) - u1 * H_rear_wheel_3;
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let F_w_Y_in_L_3_of_u1 = u1.mul_add(H_rear_wheel_2, w_Y_in_L_2 * H_rear_wheel_1);
    let F_w_Y_in_L_3_of_u1_2 = IRxx * u1.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_3)
        - F_w_Y_in_L_3_of_u1;
    let F_w_Y_in_L_3 = (-F_w_L_in_B_1).mul_add(sin_theta, F_w_L_in_B_3 * cos_theta)
        - S::int(2) * F_w_Y_in_L_3_of_u1_2;
    let F_w_Y_in_L_2_of_place = rR.mul_add(F_v_RC_1, F_w_RW_2);
    let F_w_Y_in_L_2 = F_w_Y_in_L_2_of_place.mul_add(S::int(2), F_w_B_2);
    let w_Y_in_L_2_2 = ratio_psi_u1 * sin_phi;
    let w_Y_in_L_3_2 = ratio_psi_u1 * cos_phi;
    let w_L_in_B_1_2 = w_Y_in_L_3_2.mul_add(sin_theta, cos_theta);
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, sin_theta);
    let w_B_2_2 = ratio_theta_u1 - w_Y_in_L_2_2;
    let w_B_in_S_1_2 = (-w_L_in_B_1_2).mul_add(cos_lam, w_L_in_B_3_2 * sin_lam);
    let w_B_in_S_3_2 = w_L_in_B_3_2.mul_add(cos_lam, w_L_in_B_1_2 * sin_lam);
    let w_S_in_F_1_2 = (-w_B_2_2).mul_add(sin_delta, w_B_in_S_1_2 * cos_delta);
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_B_2_2 * cos_delta);
    let w_F_in_H_1_2 = (-w_S_in_F_1_2).mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let w_F_in_H_3_2 = w_S_in_F_1_2.mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let v_RC_1 = rR * w_Y_in_L_2_2;
    let H_rear_wheel_2_2 = IRyy * w_Y_in_L_2_2;
    let H_rear_wheel_3_2 = IRxx * w_Y_in_L_3_2;
    let v_L_in_B_1 = v_RC_1 * cos_theta;
    let v_L_in_B_3 = v_RC_1 * sin_theta;
    let v_Bo_1 = w_B_2_2.mul_add(rr_plus_zb, v_L_in_B_1);
    let v_Bo_2 = xB.mul_add(w_L_in_B_3_2, rR) - w_L_in_B_1_2 * rr_plus_zb;
    let v_Bo_3 = xB.mul_add(w_B_2_2, -v_L_in_B_3);
    let H_frame_1_2 = IBxz.mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let H_frame_2_2 = IByy * w_B_2_2;
    let H_frame_3_2 = IBzz.mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let v_B_in_S_1 = (-v_L_in_B_1).mul_add(cos_lam, v_L_in_B_3 * sin_lam);
    let v_B_in_S_3 = v_L_in_B_3.mul_add(cos_lam, v_L_in_B_1 * sin_lam);
    let v_Ho_2 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, rR);
    let v_Ho_3 = w_B_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3);
    let v_S_in_F_1 = (-v_Ho_2).mul_add(sin_delta, v_B_in_S_1 * cos_delta);
    let v_S_in_F_2 = v_Ho_2.mul_add(cos_delta, v_B_in_S_1 * sin_delta);
    let v_Ho_1 = w_S_in_F_2_2.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, -v_S_in_F_1);
    let v_Ho_2_2 = w_B_in_S_3_2.mul_add(a_Ho_1_2_of_place, -v_S_in_F_2)
        - w_S_in_F_1_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let v_Ho_3_2 = w_S_in_F_2_2.mul_add(a_Ho_1_2_of_place, -v_Ho_3);
    let H_fork_1_2 = IHxz.mul_add(w_F_in_H_3_2, IHxx * w_F_in_H_1_2);
    let H_fork_2_2 = IHyy * w_S_in_F_2_2;
    let H_fork_3_2 = IHzz.mul_add(w_F_in_H_3_2, IHxz * w_F_in_H_1_2);
    let v_FC_1 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -v_S_in_F_1);
    let v_FC_2 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_c_lam_rf, v_S_in_F_2)
        + w_S_in_F_1_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_c_lam_rf, v_Ho_3);
    let w_FW_2_2 = ratio_thF_u1 + w_S_in_F_2_2;
    let H_front_wheel_1_2 = IFxx * w_S_in_F_1_2;
    let H_front_wheel_2_2 = IFyy * w_FW_2_2;
    let H_front_wheel_3_2 = IFxx * w_B_in_S_3_2;
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
    let p_v_RC_2 = rR.mul_add(mR, p_v_Ho_2_2) + p_v_Bo_2;
    let p_v_RC_1 = (-p_v_L_in_B_3).mul_add(sin_theta, mR * v_RC_1) - p_v_L_in_B_1 * cos_theta;
    let p_w_F_3 = H_fork_3_2.mul_add(cos_lam, H_fork_1_2 * sin_lam) + H_front_wheel_3_2
        + p_v_FC_2 * ratio_theta_u1_of_c_lam_rf + p_v_Ho_2 * a_Ho_1_2_of_place;
    let p_w_S_in_F_2 = p_v_FC_3
        .mul_add(ratio_theta_u1_of_c_lam_rf, H_fork_2_2 + H_front_wheel_2_2)
        + p_v_FC_1 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_3 * a_Ho_1_2_of_place
        + p_v_Ho_1 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_S_in_F_1 = (-H_fork_1_2).mul_add(cos_lam, H_fork_3_2 * sin_lam)
        + H_front_wheel_1_2 + p_v_FC_2 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_B_in_S_3 = p_v_Ho_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3);
    let p_w_B_in_S_1 = p_w_S_in_F_1.mul_add(cos_delta, p_w_S_in_F_2 * sin_delta);
    let p_w_B_2 = xB.mul_add(p_v_Bo_3, H_frame_2_2) + p_w_S_in_F_2 * cos_delta
        - p_w_S_in_F_1 * sin_delta + p_v_Ho_3_2 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1 * rr_plus_zb;
    let p_w_L_in_B_3 = xB.mul_add(p_v_Bo_2, H_frame_3_2) + p_w_B_in_S_3 * cos_lam
        + p_w_B_in_S_1 * sin_lam;
    let p_w_L_in_B_1 = p_w_B_in_S_3.mul_add(sin_lam, H_frame_1_2)
        - p_w_B_in_S_1 * cos_lam - p_v_Bo_2 * rr_plus_zb;
    let p_w_Y_in_L_3 = (-p_w_L_in_B_3).mul_add(cos_theta, H_rear_wheel_3_2)
        + p_w_L_in_B_1 * sin_theta;
    let p_w_Y_in_L_2 = rR.mul_add(p_v_RC_1, H_rear_wheel_2_2) - p_w_B_2;
    let w_Y_in_L_2_3 = ratio_psi_u2 * sin_phi;
    let w_Y_in_L_3_3 = ratio_psi_u2 * cos_phi;
    let w_L_in_B_1_3 = w_Y_in_L_3_3 * sin_theta;
    let w_L_in_B_3_3 = w_Y_in_L_3_3 * cos_theta;
    let w_B_2_3 = ratio_theta_u2 - w_Y_in_L_2_3;
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_1_3 = w_B_in_S_1_3.mul_add(cos_delta, w_B_2_3 * sin_delta);
    let w_S_in_F_2_3 = (-w_B_2_3).mul_add(cos_delta, w_B_in_S_1_3 * sin_delta);
    let w_F_3_2 = w_B_in_S_3_3 - S::int(1);
    let w_F_in_H_1_3 = (-w_S_in_F_1_3).mul_add(cos_lam, w_F_3_2 * sin_lam);
    let w_F_in_H_3_3 = w_F_3_2.mul_add(cos_lam, w_S_in_F_1_3 * sin_lam);
    let v_RC_1_2 = rR * w_Y_in_L_2_3;
    let H_rear_wheel_2_3 = IRyy * w_Y_in_L_2_3;
    let H_rear_wheel_3_3 = IRxx * w_Y_in_L_3_3;
    let v_L_in_B_1_2 = v_RC_1_2 * cos_theta;
    let v_L_in_B_3_2 = v_RC_1_2 * sin_theta;
    let v_Bo_1_2 = w_B_2_3.mul_add(rr_plus_zb, v_L_in_B_1_2);
    let v_Bo_2_2 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let v_Bo_3_2 = xB.mul_add(w_B_2_3, -v_L_in_B_3_2);
    let H_frame_1_3 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let H_frame_2_3 = IByy * w_B_2_3;
    let H_frame_3_3 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let v_B_in_S_1_2 = (-v_L_in_B_1_2).mul_add(cos_lam, v_L_in_B_3_2 * sin_lam);
    let v_B_in_S_3_2 = v_L_in_B_3_2.mul_add(cos_lam, v_L_in_B_1_2 * sin_lam);
    let v_Ho_2_3 = w_B_in_S_3_3 * ratio_theta_u1_of_w_c_lam_rr;
    let v_Ho_3_3 = w_B_2_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -v_B_in_S_3_2);
    let v_S_in_F_1_2 = v_Ho_2_3.mul_add(sin_delta, v_B_in_S_1_2 * cos_delta);
    let v_S_in_F_2_2 = (-v_Ho_2_3).mul_add(cos_delta, v_B_in_S_1_2 * sin_delta);
    let v_Ho_1_2 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, v_S_in_F_1_2);
    let v_Ho_2_4 = w_F_3_2.mul_add(a_Ho_1_2_of_place, v_S_in_F_2_2)
        - w_S_in_F_1_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let v_Ho_3_4 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_place, v_Ho_3_3);
    let H_fork_1_3 = IHxz.mul_add(w_F_in_H_3_3, IHxx * w_F_in_H_1_3);
    let H_fork_2_3 = IHyy * w_S_in_F_2_3;
    let H_fork_3_3 = IHzz.mul_add(w_F_in_H_3_3, IHxz * w_F_in_H_1_3);
    let v_FC_1_2 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_2);
    let v_FC_2_2 = w_F_3_2.mul_add(ratio_theta_u1_of_c_lam_rf, -v_S_in_F_2_2)
        + w_S_in_F_1_3 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_2 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_c_lam_rf, -v_Ho_3_3);
    let w_FW_2_3 = ratio_thF_u2 - w_S_in_F_2_3;
    let H_front_wheel_1_3 = IFxx * w_S_in_F_1_3;
    let H_front_wheel_2_3 = IFyy * w_FW_2_3;
    let H_front_wheel_3_3 = IFxx * w_F_3_2;
    let p_v_FC_3_2 = mF * v_FC_3_2;
    let p_v_FC_2_2 = mF * v_FC_2_2;
    let p_v_FC_1_2 = mF * v_FC_1_2;
    let p_v_Ho_3_3 = mH * v_Ho_3_4;
    let p_v_Ho_2_3 = mH * v_Ho_2_4;
    let p_v_Ho_1_2 = mH * v_Ho_1_2;
    let p_v_S_in_F_2_2 = p_v_FC_2_2 - p_v_Ho_2_3;
    let p_v_S_in_F_1_2 = p_v_FC_1_2 + p_v_Ho_1_2;
    let p_v_Ho_3_4 = p_v_FC_3_2 - p_v_Ho_3_3;
    let p_v_Ho_2_4 = p_v_S_in_F_1_2.mul_add(sin_delta, p_v_S_in_F_2_2 * cos_delta);
    let p_v_B_in_S_1_2 = (-p_v_S_in_F_1_2)
        .mul_add(cos_delta, p_v_S_in_F_2_2 * sin_delta);
    let p_v_Bo_3_2 = mB * v_Bo_3_2;
    let p_v_Bo_2_2 = mB * v_Bo_2_2;
    let p_v_Bo_1_2 = mB * v_Bo_1_2;
    let p_v_L_in_B_3_2 = (-p_v_B_in_S_1_2).mul_add(sin_lam, p_v_Ho_3_4 * cos_lam) - p_v_Bo_3_2;
    let p_v_L_in_B_1_2 = p_v_B_in_S_1_2.mul_add(cos_lam, p_v_Ho_3_4 * sin_lam) + p_v_Bo_1_2;
    let p_v_RC_2_2 = p_v_Ho_2_4 + p_v_Bo_2_2;
    let p_v_RC_1_2 = p_v_L_in_B_3_2.mul_add(sin_theta, mR * v_RC_1_2) + p_v_L_in_B_1_2 * cos_theta;
    let p_w_F_3_2 = H_fork_3_3.mul_add(cos_lam, H_fork_1_3 * sin_lam) + H_front_wheel_3_3
        + p_v_FC_2_2 * ratio_theta_u1_of_c_lam_rf + p_v_Ho_2_3 * a_Ho_1_2_of_place;
    let p_w_S_in_F_2_2 = p_v_FC_3_2
        .mul_add(ratio_theta_u1_of_c_lam_rf, H_fork_2_3 - H_front_wheel_2_3)
        + p_v_FC_1_2 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_3_3 * a_Ho_1_2_of_place
        + p_v_Ho_1_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_S_in_F_1_2 = (-H_fork_1_3).mul_add(cos_lam, H_fork_3_3 * sin_lam)
        + H_front_wheel_1_3 + p_v_FC_2_2 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_B_in_S_3_2 = p_v_Ho_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3_2);
    let p_w_B_in_S_1_2 = p_w_S_in_F_1_2.mul_add(cos_delta, p_w_S_in_F_2_2 * sin_delta);
    let p_w_B_2_2 = xB.mul_add(p_v_Bo_3_2, H_frame_2_3) - p_w_S_in_F_2_2 * cos_delta
        + p_w_S_in_F_1_2 * sin_delta - p_v_Ho_3_4 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1_2 * rr_plus_zb;
    let p_w_L_in_B_3_2 = (-xB).mul_add(p_v_Bo_2_2, H_frame_3_3)
        - p_w_B_in_S_3_2 * cos_lam - p_w_B_in_S_1_2 * sin_lam;
    let p_w_L_in_B_1_2 = (-p_w_B_in_S_3_2).mul_add(sin_lam, H_frame_1_3)
        + p_w_B_in_S_1_2 * cos_lam + p_v_Bo_2_2 * rr_plus_zb;
    let p_w_Y_in_L_3_2 = (-p_w_L_in_B_3_2).mul_add(cos_theta, H_rear_wheel_3_3)
        + p_w_L_in_B_1_2 * sin_theta;
    let p_w_Y_in_L_2_2 = rR.mul_add(p_v_RC_1_2, H_rear_wheel_2_3) - p_w_B_2_2;
    let w_Y_in_L_2_4 = ratio_psi_u3 * sin_phi;
    let w_Y_in_L_3_4 = ratio_psi_u3 * cos_phi;
    let w_RW_2_2 = w_Y_in_L_2_4 - S::int(1);
    let w_L_in_B_1_4 = w_Y_in_L_3_4 * sin_theta;
    let w_L_in_B_3_4 = w_Y_in_L_3_4 * cos_theta;
    let w_B_in_S_1_4 = w_L_in_B_3_4.mul_add(sin_lam, w_L_in_B_1_4 * cos_lam);
    let w_B_in_S_3_4 = (-w_L_in_B_1_4).mul_add(sin_lam, w_L_in_B_3_4 * cos_lam);
    let w_S_in_F_1_4 = (-w_Y_in_L_2_4).mul_add(sin_delta, w_B_in_S_1_4 * cos_delta);
    let w_S_in_F_2_4 = w_B_in_S_1_4.mul_add(sin_delta, w_Y_in_L_2_4 * cos_delta);
    let w_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let w_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let v_RC_1_3 = rR.mul_add(w_Y_in_L_2_4, -v_N_in_Y_1);
    let H_rear_wheel_2_4 = IRyy * w_RW_2_2;
    let H_rear_wheel_3_4 = IRxx * w_Y_in_L_3_4;
    let v_L_in_B_1_3 = v_RC_1_3 * cos_theta;
    let v_L_in_B_3_3 = v_RC_1_3 * sin_theta;
    let v_Bo_1_3 = w_Y_in_L_2_4.mul_add(rr_plus_zb, -v_L_in_B_1_3);
    let v_Bo_2_3 = w_L_in_B_1_4.mul_add(rr_plus_zb, xB * w_L_in_B_3_4);
    let v_Bo_3_3 = xB.mul_add(w_Y_in_L_2_4, v_L_in_B_3_3);
    let H_frame_1_4 = (-IBxz).mul_add(w_L_in_B_3_4, IBxx * w_L_in_B_1_4);
    let H_frame_2_4 = IByy * w_Y_in_L_2_4;
    let H_frame_3_4 = (-IBzz).mul_add(w_L_in_B_3_4, IBxz * w_L_in_B_1_4);
    let v_B_in_S_1_3 = (-v_L_in_B_1_3).mul_add(cos_lam, v_L_in_B_3_3 * sin_lam);
    let v_B_in_S_3_3 = v_L_in_B_3_3.mul_add(cos_lam, v_L_in_B_1_3 * sin_lam);
    let v_Ho_2_5 = w_B_in_S_3_4 * ratio_theta_u1_of_w_c_lam_rr;
    let v_Ho_3_5 = w_Y_in_L_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, v_B_in_S_3_3);
    let v_S_in_F_1_3 = v_Ho_2_5.mul_add(sin_delta, v_B_in_S_1_3 * cos_delta);
    let v_S_in_F_2_3 = (-v_Ho_2_5).mul_add(cos_delta, v_B_in_S_1_3 * sin_delta);
    let v_Ho_1_3 = w_S_in_F_2_4.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, v_S_in_F_1_3);
    let v_Ho_2_6 = w_B_in_S_3_4.mul_add(a_Ho_1_2_of_place, v_S_in_F_2_3)
        - w_S_in_F_1_4 * a_Ho_1_2_of_lam_rr_xh_zh;
    let v_Ho_3_6 = w_S_in_F_2_4.mul_add(a_Ho_1_2_of_place, -v_Ho_3_5);
    let H_fork_1_4 = IHxz.mul_add(w_F_in_H_3_4, IHxx * w_F_in_H_1_4);
    let H_fork_2_4 = IHyy * w_S_in_F_2_4;
    let H_fork_3_4 = IHzz.mul_add(w_F_in_H_3_4, IHxz * w_F_in_H_1_4);
    let v_FC_1_3 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_w_lam_rr_rf, v_S_in_F_1_3);
    let v_FC_2_3 = w_B_in_S_3_4.mul_add(ratio_theta_u1_of_c_lam_rf, -v_S_in_F_2_3)
        + w_S_in_F_1_4 * ratio_theta_u1_of_w_lam_rr_rf;
    let v_FC_3_3 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_c_lam_rf, v_Ho_3_5);
    let w_FW_2_4 = ratio_thF_u3 - w_S_in_F_2_4;
    let H_front_wheel_1_4 = IFxx * w_S_in_F_1_4;
    let H_front_wheel_2_4 = IFyy * w_FW_2_4;
    let H_front_wheel_3_4 = IFxx * w_B_in_S_3_4;
    let p_v_FC_3_3 = mF * v_FC_3_3;
    let p_v_FC_2_3 = mF * v_FC_2_3;
    let p_v_FC_1_3 = mF * v_FC_1_3;
    let p_v_Ho_3_5 = mH * v_Ho_3_6;
    let p_v_Ho_2_5 = mH * v_Ho_2_6;
    let p_v_Ho_1_3 = mH * v_Ho_1_3;
    let p_v_S_in_F_2_3 = p_v_FC_2_3 - p_v_Ho_2_5;
    let p_v_S_in_F_1_3 = p_v_FC_1_3 + p_v_Ho_1_3;
    let p_v_Ho_3_6 = p_v_FC_3_3 - p_v_Ho_3_5;
    let p_v_Ho_2_6 = p_v_S_in_F_1_3.mul_add(sin_delta, p_v_S_in_F_2_3 * cos_delta);
    let p_v_B_in_S_1_3 = (-p_v_S_in_F_1_3)
        .mul_add(cos_delta, p_v_S_in_F_2_3 * sin_delta);
    let p_v_Bo_3_3 = mB * v_Bo_3_3;
    let p_v_Bo_2_3 = mB * v_Bo_2_3;
    let p_v_Bo_1_3 = mB * v_Bo_1_3;
    let p_v_L_in_B_3_3 = (-p_v_B_in_S_1_3).mul_add(sin_lam, p_v_Ho_3_6 * cos_lam) + p_v_Bo_3_3;
    let p_v_L_in_B_1_3 = p_v_B_in_S_1_3.mul_add(cos_lam, p_v_Ho_3_6 * sin_lam) - p_v_Bo_1_3;
    let p_v_RC_2_3 = p_v_Ho_2_6 + p_v_Bo_2_3;
    let p_v_RC_1_3 = p_v_L_in_B_3_3.mul_add(sin_theta, mR * v_RC_1_3) + p_v_L_in_B_1_3 * cos_theta;
    let p_w_F_3_3 = H_fork_3_4.mul_add(cos_lam, H_fork_1_4 * sin_lam) + H_front_wheel_3_4
        + p_v_FC_2_3 * ratio_theta_u1_of_c_lam_rf + p_v_Ho_2_5 * a_Ho_1_2_of_place;
    let p_w_S_in_F_2_3 = p_v_FC_3_3
        .mul_add(ratio_theta_u1_of_c_lam_rf, H_fork_2_4 - H_front_wheel_2_4)
        + p_v_FC_1_3 * ratio_theta_u1_of_w_lam_rr_rf + p_v_Ho_3_5 * a_Ho_1_2_of_place
        + p_v_Ho_1_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_S_in_F_1_3 = (-H_fork_1_4).mul_add(cos_lam, H_fork_3_4 * sin_lam)
        + H_front_wheel_1_4 + p_v_FC_2_3 * ratio_theta_u1_of_w_lam_rr_rf
        - p_v_Ho_2_5 * a_Ho_1_2_of_lam_rr_xh_zh;
    let p_w_B_in_S_3_3 = p_v_Ho_2_6.mul_add(ratio_theta_u1_of_w_c_lam_rr, p_w_F_3_3);
    let p_w_B_in_S_1_3 = p_w_S_in_F_1_3.mul_add(cos_delta, p_w_S_in_F_2_3 * sin_delta);
    let p_w_B_2_3 = xB.mul_add(p_v_Bo_3_3, H_frame_2_4) + p_w_S_in_F_2_3 * cos_delta
        - p_w_S_in_F_1_3 * sin_delta + p_v_Ho_3_6 * ratio_theta_u1_of_w_c_lam_rr
        + p_v_Bo_1_3 * rr_plus_zb;
    let p_w_L_in_B_3_3 = (-xB).mul_add(p_v_Bo_2_3, H_frame_3_4)
        - p_w_B_in_S_3_3 * cos_lam - p_w_B_in_S_1_3 * sin_lam;
    let p_w_L_in_B_1_3 = (-p_w_B_in_S_3_3).mul_add(sin_lam, H_frame_1_4)
        + p_w_B_in_S_1_3 * cos_lam + p_v_Bo_2_3 * rr_plus_zb;
    let p_w_Y_in_L_3_3 = (-p_w_L_in_B_3_3).mul_add(cos_theta, H_rear_wheel_3_4)
        + p_w_L_in_B_1_3 * sin_theta;
    let p_w_Y_in_L_2_3_of_place = rR.mul_add(p_v_RC_1_3, H_rear_wheel_2_4);
    let p_w_Y_in_L_2_3 = p_w_B_2_3 + p_w_Y_in_L_2_3_of_place;
    let m12_of_place = p_w_Y_in_L_2_2.mul_add(sin_phi, p_w_Y_in_L_3_2 * cos_phi);
    let m12_of_place_2 = (-ratio_thF_u1).mul_add(H_front_wheel_2_3, rR * p_v_RC_2_2);
    let m12_of_place_3 = p_w_L_in_B_3_2.mul_add(sin_theta, ratio_theta_u1 * p_w_B_2_2);
    let m12_of_place_4 = ratio_psi_u1.mul_add(m12_of_place, p_w_L_in_B_1_2 * cos_theta);
    let m12_of_place_5 = m12_of_place_2 - m12_of_place_3;
    let m12_of_place_6 = m12_of_place_4 - m12_of_place_5;
    let m13_of_place = p_w_Y_in_L_2_3.mul_add(sin_phi, p_w_Y_in_L_3_3 * cos_phi);
    let m13_of_place_2 = (-ratio_thF_u1).mul_add(H_front_wheel_2_4, rR * p_v_RC_2_3);
    let m13_of_place_3 = (-p_w_L_in_B_3_3)
        .mul_add(sin_theta, ratio_theta_u1 * p_w_B_2_3);
    let m13_of_place_4 = ratio_psi_u1.mul_add(m13_of_place, p_w_L_in_B_1_3 * cos_theta);
    let m13_of_place_5 = m13_of_place_2 + m13_of_place_3;
    let m13_of_place_6 = m13_of_place_4 - m13_of_place_5;
    let m23_of_place = (-ratio_thF_u2)
        .mul_add(H_front_wheel_2_4, ratio_theta_u2 * p_w_B_2_3);
    let m23_of_place_2 = ratio_psi_u2.mul_add(m13_of_place, -p_w_F_3_3);
    let m23_of_place_3 = m23_of_place - m23_of_place_2;
    let f_w_fw_2_halved = S::ratio(1, 2) * F_w_FW_2;
    let f1_of_place = (-F_w_Y_in_L_3).mul_add(cos_phi, F_w_Y_in_L_2 * sin_phi);
    let f1_of_place_halved = S::ratio(1, 2) * f1_of_place;
    let f_w_b_2_halved = S::ratio(1, 2) * F_w_B_2;
    let f1_of_place_2 = F_w_L_in_B_1.mul_add(cos_theta, F_w_L_in_B_3 * sin_theta);
    let minus_m23_of_place_3 = -m23_of_place_3;
    // Values.
    let m11 = IRxx + ratio_thF_u1 * H_front_wheel_2_2 + rR * p_v_RC_2
        + ratio_theta_u1 * p_w_B_2 + p_w_L_in_B_3 * sin_theta + p_w_L_in_B_1 * cos_theta
        + ratio_psi_u1 * p_w_Y_in_L_2.mul_add(sin_phi, p_w_Y_in_L_3 * cos_phi);
    let m12 = m12_of_place_6;
    let m13 = m13_of_place_6;
    let m21 = m12_of_place_6;
    let m22 = ratio_thF_u2.mul_add(H_front_wheel_2_3, -p_w_F_3_2)
        + ratio_theta_u2 * p_w_B_2_2 + ratio_psi_u2 * m12_of_place;
    let m23 = minus_m23_of_place_3;
    let m31 = m13_of_place_6;
    let m32 = minus_m23_of_place_3;
    let m33 = ratio_thF_u3.mul_add(H_front_wheel_2_4, -p_w_Y_in_L_2_3_of_place)
        + ratio_psi_u3 * m13_of_place;
    let f1 = rR * F_v_RC_2 - w_Y_in_L_3 * H_rear_wheel_2 - w_Y_in_L_2 * H_rear_wheel_3
        + IRxx * w_Y_in_L_3.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_in_L_1)
        - ratio_thF_u1 * f_w_fw_2_halved - ratio_psi_u1 * f1_of_place_halved
        + ratio_theta_u1 * f_w_b_2_halved - S::ratio(1, 2) * f1_of_place_2;
    let f2 = (-ratio_thF_u2).mul_add(f_w_fw_2_halved, F_w_F_3)
        - ratio_psi_u2 * f1_of_place_halved + ratio_theta_u2 * f_w_b_2_halved;
    let f3 = (-ratio_thF_u3).mul_add(f_w_fw_2_halved, F_w_Y_in_L_2_of_place)
        - ratio_psi_u3 * f1_of_place_halved;
    ([m11, m12, m13, m21, m22, m23, m31, m32, m33], [f1, f2, f3])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 79 operations, 4 sines and cosines, 1 other function.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 8], _u: &[S; 3]) -> [S; 4] {
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
/// 40 operations, 4 sines and cosines, 1 other function.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 8], _u: &[S; 3]) -> [S; 1] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, _, phi, theta, delta, _, _] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    // Shared terms.
    // lam + theta
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let residual1_of_place = cos_phi * sin_lam_plus_theta;
    // sin(phi)*sin(delta) - residual1_of_place*cos(delta)
    let residual1_of_place_2 = (-residual1_of_place)
        .mul_add(cos_delta, sin_phi * sin_delta);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    // sin(phi)*cos(delta) + residual1_of_place*sin(delta)
    let residual1_of_place_3 = residual1_of_place.mul_add(sin_delta, sin_phi_cos_delta);
    // rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(residual1_of_place_3^2
    //   - 1)
    let residual1_of_place_4 = rF
        * (S::int(1)
            - (cos_phi * sin_lam_plus_theta)
                .mul_add(sin_delta, sin_phi_cos_delta)
                .powi(2))
            .sqrt() / residual1_of_place_3.mul_add(residual1_of_place_3, -S::int(1));
    let residual1_of_place_5 = cos_phi * cos_lam_plus_theta;
    // Values.
    // contact = cos(phi)*sin(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) - rR*cos(phi) +
    //   (sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(rF*sin(lam) - c*cos(lam) + rF*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam +
    //   theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1)) + cos(phi)*cos(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) +
    //   rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2))
    let residual1 = residual1_of_place * (-cos_lam * (w + c) + rR * sin_lam) - rR * cos_phi
        + residual1_of_place_2
            * ((-c).mul_add(cos_lam, rF * sin_lam) - residual1_of_place_2 * residual1_of_place_4)
        + residual1_of_place_5
            * (cos_lam * (rR - rF) + w * sin_lam - residual1_of_place_4 * residual1_of_place_5);
    [residual1]
}

/// Slopes of the constraints, one after the other, along x, y, psi, phi, theta, delta, thR, thF, u1, u2, u3.
///
/// 86 operations, 4 sines and cosines, 1 other function.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    _u: &[S; 3],
) -> [S; 11] {
    let Parameters { w, c, lam, rR, rF, .. } = *p;
    let [_, _, _, phi, theta, delta, _, _] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    // Shared terms.
    // lam + theta
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let residual1_by_phi_of_place = sin_phi * sin_lam_plus_theta;
    // cos(phi)*sin(delta) + residual1_by_phi_of_place*cos(delta)
    let residual1_by_phi_of_place_2 = residual1_by_phi_of_place
        .mul_add(cos_delta, cos_phi * sin_delta);
    let residual1_by_phi_of_place_3 = cos_phi * sin_lam_plus_theta;
    // sin(phi)*sin(delta) - residual1_by_phi_of_place_3*cos(delta)
    let residual1_by_phi_of_place_4 = (-residual1_by_phi_of_place_3)
        .mul_add(cos_delta, sin_phi * sin_delta);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    // sin(phi)*cos(delta) + residual1_by_phi_of_place_3*sin(delta)
    let residual1_by_phi_of_place_5 = residual1_by_phi_of_place_3
        .mul_add(sin_delta, sin_phi_cos_delta);
    // 1/(residual1_by_phi_of_place_5^2 - 1)
    let residual1_by_phi_of_place_6 = S::int(1)
        / residual1_by_phi_of_place_5.mul_add(residual1_by_phi_of_place_5, -S::int(1));
    // rF*residual1_by_phi_of_place_6*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)
    let residual1_by_phi_of_place_7 = rF * residual1_by_phi_of_place_6
        * (S::int(1)
            - (cos_phi * sin_lam_plus_theta)
                .mul_add(sin_delta, sin_phi_cos_delta)
                .powi(2))
            .sqrt();
    // rF*sin(lam) - c*cos(lam) - residual1_by_phi_of_place_4*residual1_by_phi_of_place_7
    let residual1_by_phi_of_place_8 = (-c).mul_add(cos_lam, rF * sin_lam)
        - residual1_by_phi_of_place_4 * residual1_by_phi_of_place_7;
    // residual1_by_phi_of_place*sin(delta) - cos(phi)*cos(delta)
    let residual1_by_phi_of_place_9 = (-cos_phi)
        .mul_add(cos_delta, residual1_by_phi_of_place * sin_delta);
    let residual1_by_phi_of_place_10 = residual1_by_phi_of_place_5 * residual1_by_phi_of_place_7;
    let residual1_by_phi_of_place_11 = residual1_by_phi_of_place_6 * residual1_by_phi_of_place_10;
    let residual1_by_phi_of_place_12 = residual1_by_phi_of_place_4 * residual1_by_phi_of_place_11;
    let residual1_by_phi_of_place_13 = sin_phi * cos_lam_plus_theta;
    let residual1_by_phi_of_place_14 = cos_phi * cos_lam_plus_theta;
    let residual1_by_phi_of_place_15 = residual1_by_phi_of_place_11 * residual1_by_phi_of_place_14;
    // cos(lam)*(w + c) - rR*sin(lam)
    let residual1_by_phi_of_w_c_lam_rr = cos_lam * (w + c) - rR * sin_lam;
    let residual1_by_phi_of_place_16 = residual1_by_phi_of_place_7 * residual1_by_phi_of_place_14;
    // w*sin(lam) + cos(lam)*(rR - rF) - residual1_by_phi_of_place_16
    let residual1_by_phi_of_place_17 = cos_lam * (rR - rF) + w * sin_lam
        - residual1_by_phi_of_place_16;
    let residual1_by_theta_of_place = residual1_by_phi_of_place_14 * sin_delta;
    // residual1_by_phi_of_place_3*residual1_by_phi_of_place_7 +
    //   residual1_by_phi_of_place_15*residual1_by_theta_of_place
    let residual1_by_theta_of_place_2 = residual1_by_phi_of_place_15
        .mul_add(
            residual1_by_theta_of_place,
            residual1_by_phi_of_place_3 * residual1_by_phi_of_place_7,
        );
    // residual1_by_phi_of_place_8*cos(delta) + residual1_by_phi_of_w_c_lam_rr
    let residual1_by_theta_of_place_3 = residual1_by_phi_of_place_8
        .mul_add(cos_delta, residual1_by_phi_of_w_c_lam_rr);
    // Values.
    // d(contact)/d(phi) = rR*sin(phi) + sin(phi)*sin(lam + theta)*(cos(lam)*(w + c) - rR*sin(lam)) +
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
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)
    let residual1_by_phi = rR * sin_phi + residual1_by_phi_of_place_2 * residual1_by_phi_of_place_8
        - residual1_by_phi_of_place_4
            * residual1_by_phi_of_place_9
                .mul_add(
                    residual1_by_phi_of_place_12,
                    residual1_by_phi_of_place_2 * residual1_by_phi_of_place_7,
                )
        + residual1_by_phi_of_place_14
            * (-residual1_by_phi_of_place_9)
                .mul_add(
                    residual1_by_phi_of_place_15,
                    residual1_by_phi_of_place_7 * residual1_by_phi_of_place_13,
                ) + residual1_by_phi_of_place * residual1_by_phi_of_w_c_lam_rr
        - residual1_by_phi_of_place_13 * residual1_by_phi_of_place_17;
    // d(contact)/d(theta) = cos(phi)*cos(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) + cos(phi)*cos(lam
    //   + theta)*cos(delta)*(c*cos(lam) - rF*sin(lam) - rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) -
    //   sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) -
    //   cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 -
    //   (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam +
    //   theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam +
    //   theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam
    //   + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam
    //   + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam +
    //   theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) +
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)
    let residual1_by_theta = residual1_by_phi_of_place_4
        * residual1_by_phi_of_place_12
            .mul_add(
                residual1_by_theta_of_place,
                residual1_by_phi_of_place_16 * cos_delta,
            ) - residual1_by_phi_of_place_3 * residual1_by_phi_of_place_17
        + residual1_by_phi_of_place_14
            * (residual1_by_theta_of_place_2 - residual1_by_theta_of_place_3);
    // d(contact)/d(delta) = rF*cos(phi)^2*cos(lam + theta)^2*sqrt(1 - (cos(phi)*sin(lam +
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
    //   sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2)
    let residual1_by_delta = -residual1_by_phi_of_place_4
        * residual1_by_phi_of_place_4
            .mul_add(residual1_by_phi_of_place_12, residual1_by_phi_of_place_10)
        + residual1_by_phi_of_place_5 * residual1_by_phi_of_place_8
        - residual1_by_phi_of_place_12 * residual1_by_phi_of_place_14
            * residual1_by_phi_of_place_14;
    let zero = S::int(0);
    [
        zero, zero, zero, residual1_by_phi, residual1_by_theta, residual1_by_delta, zero, zero,
        zero, zero, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3) that must act beside the loads of the model for the accelerations to be (u1', u2', u3').
///
/// 1155 operations, 8 sines and cosines, 2 other functions.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    u: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [_, _, psi, phi, theta, delta, thR, thF] = *q;
    let [u1, u2, u3] = *u;
    let [u1_dot, u2_dot, u3_dot] = *v_dot;
    // Sines and cosines.
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_psi_u1_of_place = cos_lam_plus_theta * sin_delta;
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
    let c_cos_lam = c * cos_lam;
    let ratio_theta_u1_of_c_lam_rf = rF.mul_add(sin_lam, -c_cos_lam);
    let ratio_theta_u1_of_place_9 = ratio_theta_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_8, -ratio_theta_u1_of_c_lam_rf);
    let ratio_psi_u1_of_place_2 = -ratio_psi_u1_of_place * ratio_theta_u1_of_place_9;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let ratio_theta_u1_of_place_10 = cos_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_place_8 * ratio_theta_u1_of_place_10;
    let ratio_theta_u1_of_place_12 = ratio_theta_u1_of_w_lam_rr_rf - ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_3 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_4 = (-ratio_theta_u1_of_place_12)
        .mul_add(
            ratio_psi_u1_of_place_3,
            -ratio_theta_u1_of_place_9 * sin_lam_plus_theta,
        );
    let ratio_psi_u1_of_place_5 = ratio_psi_u1_of_place * ratio_theta_u1_of_place_12;
    let ratio_psi_u1_of_place_6 = ratio_theta_u1_of_place_12 * sin_delta;
    let ratio_psi_u1_of_place_7 = -ratio_theta_u1_of_place_12 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_8 = -ratio_theta_u1_of_place_9 * cos_delta;
    let ratio_psi_u1_of_place_9 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_8;
    let ratio_psi_u1_of_place_10 = (-ratio_psi_u1_of_place)
        .mul_add(
            ratio_psi_u1_of_place_6,
            ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_7,
        ) + ratio_psi_u1_of_place_9 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_13 = -ratio_theta_u1_of_place_9;
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let ratio_theta_u1_of_place_14 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, sin_delta_cos_phi);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_theta_u1_of_place_15 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
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
        * ratio_theta_u1_of_w_c_lam_rr.mul_add(sin_lam_plus_theta, rR);
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
    let ratio_theta_u1_of_place_29 = ratio_theta_u1_of_place_13
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_30 = ratio_theta_u1_of_place_28 - ratio_theta_u1_of_place_29;
    let ratio_theta_u1_of_place_31 = S::int(1)
        / ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_26,
                ratio_theta_u1_of_place * ratio_theta_u1_of_place_12,
            ) - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_30);
    let ratio_theta_u1 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_of_place_19,
                ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_14,
            ) - ratio_theta_u1_of_place_12 * ratio_theta_u1_of_place_20
            + ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_22 + ratio_theta_u1_of_place_23);
    let ratio_psi_u1_of_place_11 = (-ratio_psi_u1_of_place_2)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place * ratio_psi_u1_of_place_4)
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_of_place_5
        + ratio_theta_u1 * ratio_psi_u1_of_place_10;
    let ratio_psi_u1_of_place_12 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * w_plus_c.mul_add(cos_lam_plus_theta, rr_minus_rf * sin_lam_plus_theta);
    let ratio_psi_u1_of_place_13 = ratio_psi_u1_of_place_12
        .mul_add(cos_delta, ratio_theta_u1_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_14 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_15 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_14, ratio_psi_u1_of_place_13 * cos_phi);
    let ratio_psi_u1_of_place_16 = ratio_psi_u1_of_place * ratio_psi_u1_of_place_15;
    let ratio_psi_u1_of_place_17 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_of_w_c_lam_rr, rR * cos_phi);
    let ratio_psi_u1_of_place_18 = (-ratio_psi_u1_of_place_7)
        .mul_add(
            ratio_theta_u1_of_place_14,
            ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_15,
        ) + ratio_psi_u1_of_place_9 * ratio_theta_u1_of_place_20;
    let ratio_psi_u1_of_place_19 = (-ratio_psi_u1_of_place_5)
        .mul_add(ratio_theta_u1_of_place_14, ratio_psi_u1_of_place_17)
        - ratio_psi_u1_of_place_4 * ratio_theta_u1_of_place_15
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_of_place_20
        + ratio_theta_u1 * ratio_psi_u1_of_place_18;
    let ratio_psi_u1_of_place_20 = ratio_theta_u1_of_place_15 * ratio_psi_u1_of_place_15;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_psi_u1_of_place_20,
            ratio_psi_u1_of_place_11 * ratio_psi_u1_of_place_16,
        );
    let ratio_theta_u2_of_place = ratio_theta_u1_of_place_2
        .mul_add(
            ratio_theta_u1_of_place_18,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_8,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_31
        * ((-ratio_theta_u1_of_place_10)
            .mul_add(
                ratio_theta_u1_of_place_24,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_13,
            ) - ratio_theta_u1_of_place_2 * ratio_theta_u2_of_place);
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place
        .mul_add(ratio_theta_u1_of_place_13, ratio_theta_u2 * ratio_psi_u1_of_place_10);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_theta_u1_of_place_13 * ratio_theta_u1_of_place_15,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_20
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_16 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_16;
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
    let ratio_thF_u1_of_place_5 = (-sin_lam)
        .mul_add(
            cos_delta,
            ratio_thF_u1_of_place_3 * sin_delta * ratio_thF_u1_of_place_4,
        );
    let ratio_thF_u1_of_place_6 = cos_lam * (w + c * (S::int(1) - cos_delta)) - rr_sin_lam;
    let ratio_thF_u1_of_place_7 = rF
        .mul_add(ratio_thF_u1_of_place_5, -ratio_thF_u1_of_place_6);
    let ratio_thF_u1_of_place_8 = (-ratio_thF_u1_of_place_7)
        .mul_add(cos_lam_plus_theta, ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta);
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_9 = ratio_psi_u1_of_place_15 * ratio_thF_u1_of_place_4;
    let ratio_thF_u1_of_place_10 = rf_inv * ratio_thF_u1_of_place_9;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_10;
    let ratio_thF_u1_of_place_12 = -ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_9;
    let ratio_thF_u1_of_place_13 = (-ratio_theta_u1_of_place_2)
        .mul_add(
            ratio_theta_u1_of_w_lam_rr_rf,
            ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_of_place_10,
        );
    let ratio_thF_u1_of_place_14 = ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_12;
    let ratio_thF_u1_of_place_15 = ratio_thF_u1_of_place_12
        .mul_add(sin_lam_plus_theta, ratio_theta_u1_of_place_23)
        + ratio_psi_u1_of_place * ratio_thF_u1_of_place_13
        - ratio_psi_u1_of_place_3 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_of_place_16 = ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_15;
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u3_of_place = ratio_thF_u1_of_place_6
        .mul_add(rf_inv, -ratio_thF_u1_of_place_5);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_w_lam_rr_rf)
        .mul_add(sin_lam_plus_theta, ratio_thF_u3_of_place * cos_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = rR * ratio_thF_u1_of_place_9;
    let ratio_thF_u3 = ratio_thF_u3_of_place_2 * ratio_thF_u3_of_place_3;
    let w_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_2 = w_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let w_Y_in_L_3 = w_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-u1).mul_add(sin_theta, w_Y_in_L_3 * cos_theta);
    let w_B_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let w_B_2 = w_B_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_in_S_1 = w_L_in_B_3.mul_add(sin_lam, w_L_in_B_1 * cos_lam);
    let w_B_in_S_3 = (-w_L_in_B_1).mul_add(sin_lam, w_L_in_B_3 * cos_lam);
    let w_S_in_F_1 = w_B_in_S_1.mul_add(cos_delta, w_B_2 * sin_delta);
    let w_S_in_F_2 = (-w_B_2).mul_add(cos_delta, w_B_in_S_1 * sin_delta);
    let w_F_3 = u2 - w_B_in_S_3;
    let w_F_in_H_1 = w_F_3.mul_add(sin_lam, w_S_in_F_1 * cos_lam);
    let w_F_in_H_3 = (-w_S_in_F_1).mul_add(sin_lam, w_F_3 * cos_lam);
    let w_F_in_FW_1 = (-w_S_in_F_1).mul_add(cos_thF, w_F_3 * sin_thF);
    let w_F_in_FW_3 = w_F_3.mul_add(cos_thF, w_S_in_F_1 * sin_thF);
    let ratio_theta_u1_2_of_u1_u2 = w_B_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_2 = (-ratio_theta_u1_of_place_10)
        .mul_add(w_B_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_2 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_3;
    let ratio_theta_u1_2_of_u1_u2_5 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_6 = (-ratio_theta_u1_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_2 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_7 = -ratio_theta_u1_2_of_u1_u2_5 - ratio_theta_u1_2_of_u1_u2_6;
    let ratio_theta_u1_2_of_u1_u2_8 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_4,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_7,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_8,
            ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = w_B_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_u1_u2_9 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_psi_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_9);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place_9)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_8 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_12 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_8)
        .mul_add(cos_delta, -ratio_theta_u1_of_place_9 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place
        .mul_add(w_B_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_11 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_9);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_11
        .mul_add(sin_delta, ratio_theta_u1_of_place_12 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_12 = ratio_theta_u1_2_of_u1_u2_11 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_12)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_12);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_6)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_of_place_20 * w_B_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_14 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_5 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_13 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_15 = -ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_16 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_7
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_u1_u2_4, ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u1_2_of_u1_u2_19 = (ratio_psi_u1_of_place * w_B_2_of_u1_u2)
        .mul_add(sin_phi, u1 * ratio_theta_u1_of_place_4) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_20 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_21 = (-u1)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_u1_u2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_22 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_theta_u1_2_of_u1_u2_23 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_13, u1 * ratio_psi_u1_of_place_17);
    let sin_delta_doubled = S::int(2) * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_2
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_u1_u2_10)
                .mul_add(sin_delta_doubled, ratio_theta_u1_of_place_10 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_15
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_24);
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_30 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_11
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_11)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_24 * u2_cos_delta)
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_10 * sin_delta
                - ratio_theta_u1_2_of_u1_u2_12
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_18)
        + ratio_theta_u1_of_place_10
            * ratio_theta_u1_of_place_13
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_25);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_14
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_14,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_18
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_19)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_19
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_21
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_10, ratio_theta_u1_2_of_u1_u2_22,
                        )) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_psi_u1_2_of_u1_u2_14 = (-ratio_theta_u1_2)
        .mul_add(
            ratio_psi_u1_of_place_10,
            ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2,
        ) + ratio_psi_u1_2_of_u1_u2_2 * sin_lam_plus_theta
        + ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_u1_u2_3
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_7
        + ratio_psi_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_13;
    let ratio_psi_u1_2_of_u1_u2_15 = (-ratio_theta_u1_of_place_20)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_10,
            ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_11,
        ) + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_12
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_21;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_18, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_14
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_21
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_13 * u1_sin_phi
        + ratio_psi_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_3
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2
                + ratio_psi_u1_of_place_12 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_16
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_20
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_19);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_7
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_4
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_u1_u2_10
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_18
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_4))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_7
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_17);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_26, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_13)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_10)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_15,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_18,
        ) - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_16 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_20 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_5;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_thF_u1_of_place * ratio_theta_u1_2_of_u1_u2_6
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_u1_u2_6 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_theta_u1_of_place_9)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_7,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_8,
            ) - ratio_thF_u1_of_place_13 * ratio_psi_u1_2_of_u1_u2
        + ratio_thF_u1_of_place_12 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_thF_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place
            * ratio_theta_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_10,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_4,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_7,
                ) + ratio_theta_u1_2_of_u1_u2_23;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_7,
                ) + S::int(2) * ratio_theta_u1_of_place_4 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_w_lam_rr_rf = S::int(2) * ratio_theta_u1_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_7 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_thF_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_6
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_2_of_w_lam_rr_rf;
    let ratio_thF_u1_2_of_u1_u2_8 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_7);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_8,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = S::int(2) * ratio_thF_u3_of_w_lam_rr_rf
        * ratio_psi_u1_2_of_u1_u2_3 + ratio_thF_u3_of_place * ratio_psi_u1_2_of_u1_u2_6
        + cos_lam_plus_theta * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6);
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let w_L_11 = u1 * u1;
    let w_L_13 = u1 * w_Y_in_L_3;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let w_L_23 = w_Y_in_L_2 * w_Y_in_L_3;
    let turn_L_33 = w_L_11 + w_L_22;
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let turn_B_33 = w_B_11 + w_B_22;
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_33 = w_F_11 + w_F_22;
    let H_rear_wheel_1 = IRxx * u1;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let H_frame_1 = (-IBxz).mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = (-IBzz).mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 - w_FW_in_F_2;
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_Y_in_L_2_2_of_motion = u2_dot.mul_add(ratio_psi_u2, u1_dot * ratio_psi_u1)
        + u3_dot * ratio_psi_u3 + u1 * ratio_psi_u1_2 + u2 * ratio_psi_u2_2 + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2_2 = alpha_Y_in_L_2_2_of_motion * sin_phi;
    let alpha_Y_in_L_3_2 = alpha_Y_in_L_2_2_of_motion * cos_phi;
    let alpha_L_2_2 = w_L_13 + alpha_Y_in_L_2_2;
    let alpha_L_3_2 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3_2);
    let turn_L_13_2 = w_L_13 + alpha_L_2_2;
    let turn_L_23 = u1_dot - w_L_23;
    let alpha_L_in_B_1_2 = (-u1_dot).mul_add(cos_theta, alpha_L_3_2 * sin_theta);
    let alpha_L_in_B_3_2 = alpha_L_3_2.mul_add(cos_theta, u1_dot * sin_theta);
    let alpha_B_1_2 = w_L_in_B_3.mul_add(w_B_2_of_u1_u2, -alpha_L_in_B_1_2);
    let alpha_B_2_2 = u2_dot.mul_add(ratio_theta_u2, u1_dot * ratio_theta_u1)
        + u1 * ratio_theta_u1_2 + u2 * ratio_theta_u2_2 - alpha_L_2_2;
    let alpha_B_3_2 = w_L_in_B_1.mul_add(w_B_2_of_u1_u2, alpha_L_in_B_3_2);
    let turn_B_13_2 = w_B_13 - alpha_B_2_2;
    let turn_B_21_2 = w_B_12 + alpha_B_3_2;
    let turn_B_23_2 = w_B_23 + alpha_B_1_2;
    let turn_B_31_2 = w_B_13 + alpha_B_2_2;
    let alpha_B_in_S_1_2 = (-alpha_B_1_2).mul_add(cos_lam, alpha_B_3_2 * sin_lam);
    let alpha_B_in_S_3_2 = alpha_B_3_2.mul_add(cos_lam, alpha_B_1_2 * sin_lam);
    let turn_S_21_2 = w_S_12 + alpha_B_in_S_3_2;
    let turn_S_31_2 = w_S_13 + alpha_B_2_2;
    let alpha_S_in_F_1_2 = (-alpha_B_2_2)
        .mul_add(sin_delta, alpha_B_in_S_1_2 * cos_delta);
    let alpha_S_in_F_2_2 = alpha_B_in_S_1_2.mul_add(sin_delta, alpha_B_2_2 * cos_delta);
    let alpha_F_1_2 = u2.mul_add(w_S_in_F_2, alpha_S_in_F_1_2);
    let alpha_F_2_2 = u2.mul_add(w_S_in_F_1, -alpha_S_in_F_2_2);
    let alpha_F_3 = u2_dot + alpha_B_in_S_3_2;
    let turn_F_13_2 = w_F_13 - alpha_F_2_2;
    let turn_F_21_2 = w_F_12 - alpha_F_3;
    let turn_F_23_2 = w_F_23 - alpha_F_1_2;
    let turn_F_31_2 = w_F_13 + alpha_F_2_2;
    let rr_cos_psi = rR * cos_psi;
    let rr_sin_psi = rR * sin_psi;
    let a_N_in_Y_1_of_u1_u2_u3 = u3 * w_Y_in_L_2_of_u1_u2_u3;
    let a_N_in_Y_1_of_motion = rr_sin_psi
        .mul_add(a_N_in_Y_1_of_u1_u2_u3, u3_dot * rr_cos_psi);
    let a_N_in_Y_1_of_motion_2 = (-rr_cos_psi)
        .mul_add(a_N_in_Y_1_of_u1_u2_u3, u3_dot * rr_sin_psi);
    let a_N_in_Y_1 = a_N_in_Y_1_of_motion_2
        .mul_add(sin_psi, a_N_in_Y_1_of_motion * cos_psi);
    let a_N_in_Y_2_2 = (-a_N_in_Y_1_of_motion_2)
        .mul_add(cos_psi, a_N_in_Y_1_of_motion * sin_psi);
    let a_Y_in_L_2_2 = (-a_N_in_Y_2_2).mul_add(cos_phi, g * sin_phi);
    let a_Y_in_L_3_2 = a_N_in_Y_2_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_1_2 = rR.mul_add(turn_L_13_2, -a_N_in_Y_1);
    let a_RC_2_2 = rR.mul_add(turn_L_23, -a_Y_in_L_2_2);
    let a_RC_3_2 = rR.mul_add(turn_L_33, -a_Y_in_L_3_2);
    let alpha_RW_1 = u1_dot + alpha_RW_in_L_1;
    let alpha_RW_2 = u3_dot - alpha_L_2_2;
    let alpha_RW_3_2 = alpha_RW_in_L_3 + alpha_L_3_2;
    let a_L_in_B_1_2 = (-a_RC_1_2).mul_add(cos_theta, a_RC_3_2 * sin_theta);
    let a_L_in_B_3_2 = a_RC_3_2.mul_add(cos_theta, a_RC_1_2 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1_2 = xB.mul_add(turn_B_11, a_L_in_B_1_2) + turn_B_13_2 * rr_plus_zb;
    let a_Bo_2_2 = xB.mul_add(turn_B_21_2, a_RC_2_2) - turn_B_23_2 * rr_plus_zb;
    let a_Bo_3_2 = xB.mul_add(turn_B_31_2, -a_L_in_B_3_2) + turn_B_33 * rr_plus_zb;
    let a_B_in_S_1_2 = a_L_in_B_3_2.mul_add(sin_lam, a_L_in_B_1_2 * cos_lam);
    let a_B_in_S_3_2 = (-a_L_in_B_1_2).mul_add(sin_lam, a_L_in_B_3_2 * cos_lam);
    let a_Ho_1_3 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1_2);
    let a_Ho_2_3 = turn_S_21_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_RC_2_2);
    let a_Ho_3_3 = turn_S_31_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3_2);
    let a_S_in_F_1_2 = (-a_Ho_2_3).mul_add(sin_delta, a_Ho_1_3 * cos_delta);
    let a_S_in_F_2_2 = a_Ho_2_3.mul_add(cos_delta, a_Ho_1_3 * sin_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_4_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let a_Ho_1_4_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_4 = turn_F_11.mul_add(a_Ho_1_4_of_place, -a_S_in_F_1_2)
        + turn_F_13_2 * a_Ho_1_4_of_lam_rr_xh_zh;
    let a_Ho_2_4 = turn_F_21_2.mul_add(a_Ho_1_4_of_place, a_S_in_F_2_2)
        - turn_F_23_2 * a_Ho_1_4_of_lam_rr_xh_zh;
    let a_Ho_3_4 = turn_F_31_2.mul_add(a_Ho_1_4_of_place, a_Ho_3_3)
        + turn_F_33 * a_Ho_1_4_of_lam_rr_xh_zh;
    let alpha_F_in_H_1_2 = (-alpha_F_1_2).mul_add(cos_lam, alpha_F_3 * sin_lam);
    let alpha_F_in_H_3_2 = alpha_F_3.mul_add(cos_lam, alpha_F_1_2 * sin_lam);
    let a_FC_1_2 = turn_F_11.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_1_2)
        - turn_F_13_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_2_2 = turn_F_21_2.mul_add(ratio_theta_u1_of_c_lam_rf, -a_S_in_F_2_2)
        + turn_F_23_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let a_FC_3_2 = (-turn_F_31_2).mul_add(ratio_theta_u1_of_c_lam_rf, a_Ho_3_3)
        + turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let alpha_FW_in_F_2_2_of_motion = u2_dot
        .mul_add(ratio_thF_u2, u1_dot * ratio_thF_u1);
    let alpha_FW_in_F_2_2_of_motion_2 = u3_dot
        .mul_add(ratio_thF_u3, alpha_FW_in_F_2_2_of_motion);
    let alpha_FW_in_F_2_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2)
        + u3 * ratio_thF_u3_2 + S::int(2) * alpha_FW_in_F_2_2_of_motion_2;
    let alpha_FW_1_2 = alpha_FW_in_F_1 + alpha_F_1_2;
    let alpha_f_2_2_doubled = S::int(2) * alpha_F_2_2;
    let alpha_FW_2_2 = alpha_f_2_2_doubled - alpha_FW_in_F_2_2;
    let alpha_FW_3_2 = alpha_FW_in_F_3 - alpha_F_3;
    let F_w_FW_2_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let F_w_FW_2_2 = (-F_w_FW_2_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2_2);
    let F_v_FC_3_2 = mF * a_FC_3_2;
    let F_v_FC_2_2 = mF * a_FC_2_2;
    let F_v_FC_1_2 = mF * a_FC_1_2;
    let F_v_Ho_3_3 = mH * a_Ho_3_4;
    let F_v_Ho_2_3 = mH * a_Ho_2_4;
    let F_v_Ho_1_2 = mH * a_Ho_1_4;
    let F_v_S_in_F_2_2 = F_v_FC_2_2 - F_v_Ho_2_3;
    let F_v_S_in_F_1_2 = F_v_FC_1_2 - F_v_Ho_1_2;
    let F_v_Ho_3_4 = F_v_FC_3_2 + F_v_Ho_3_3;
    let F_v_Ho_2_4 = F_v_S_in_F_1_2.mul_add(sin_delta, F_v_S_in_F_2_2 * cos_delta);
    let F_v_B_in_S_1_2 = (-F_v_S_in_F_1_2)
        .mul_add(cos_delta, F_v_S_in_F_2_2 * sin_delta);
    let F_v_Bo_3_2 = mB * a_Bo_3_2;
    let F_v_Bo_2_2 = mB * a_Bo_2_2;
    let F_v_Bo_1_2 = mB * a_Bo_1_2;
    let F_v_L_in_B_3_2 = F_v_B_in_S_1_2.mul_add(sin_lam, F_v_Ho_3_4 * cos_lam) + F_v_Bo_3_2;
    let F_v_L_in_B_1_2 = (-F_v_B_in_S_1_2).mul_add(cos_lam, F_v_Ho_3_4 * sin_lam) + F_v_Bo_1_2;
    let F_v_RC_2_2 = mR.mul_add(a_RC_2_2, -F_v_Ho_2_4) + F_v_Bo_2_2;
    let F_v_RC_1_2 = (-F_v_L_in_B_3_2).mul_add(sin_theta, mR * a_RC_1_2)
        - F_v_L_in_B_1_2 * cos_theta;
    let F_w_F_in_H_3_2 = (-w_S_in_F_2).mul_add(H_fork_1, w_F_in_H_1 * H_fork_2)
        - IHxz * alpha_F_in_H_1_2 - IHzz * alpha_F_in_H_3_2;
    let F_w_F_in_H_1_2 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        - IHxx * alpha_F_in_H_1_2 - IHxz * alpha_F_in_H_3_2;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let F_w_F_3_2 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + F_w_F_in_H_3_2 * cos_lam + F_w_F_in_H_1_2 * sin_lam
        + F_v_FC_2_2 * ratio_theta_u1_of_c_lam_rf + F_v_Ho_2_3 * a_Ho_1_4_of_place
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_3_2);
    let F_w_S_in_F_2_2_of_place = (-w_F_in_H_3).mul_add(H_fork_1, w_F_in_H_1 * H_fork_3);
    let F_w_S_in_F_2_2_of_place_2 = (-F_v_Ho_3_3)
        .mul_add(a_Ho_1_4_of_place, F_v_FC_3_2 * ratio_theta_u1_of_c_lam_rf);
    let F_w_S_in_F_2_2_of_place_3 = F_v_Ho_1_2
        .mul_add(a_Ho_1_4_of_lam_rr_xh_zh, -F_w_S_in_F_2_2_of_place);
    let F_w_S_in_F_2_2_of_place_4 = F_w_S_in_F_2_2_of_place_2 + F_w_S_in_F_2_2_of_place_3;
    let F_w_S_in_F_2_2 = (-F_v_FC_1_2).mul_add(ratio_thF_u1_2_of_w_lam_rr_rf, F_w_FW_2_2)
        - IHyy * alpha_f_2_2_doubled + S::int(2) * F_w_S_in_F_2_2_of_place_4;
    let F_w_S_in_F_1_2 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - F_w_F_in_H_3_2 * sin_lam + F_w_F_in_H_1_2 * cos_lam
        - F_v_FC_2_2 * ratio_theta_u1_of_w_lam_rr_rf + F_v_Ho_2_3 * a_Ho_1_4_of_lam_rr_xh_zh
        + IFxx * (-w_F_3).mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1_2);
    let F_w_B_in_S_3_2 = F_v_Ho_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, F_w_F_3_2);
    let F_w_B_in_S_1_2 = (F_w_S_in_F_1_2 * cos_delta)
        .mul_add(S::int(2), F_w_S_in_F_2_2 * sin_delta);
    let w_l_in_b_3_doubled = S::int(2) * w_L_in_B_3;
    let w_l_in_b_1_doubled = S::int(2) * w_L_in_B_1;
    let xb_doubled = S::int(2) * xB;
    let rr_plus_zb_doubled = S::int(2) * rr_plus_zb;
    let F_w_B_2_2_of_place = F_v_Ho_3_4
        .mul_add(ratio_theta_u1_of_w_c_lam_rr, IByy * alpha_B_2_2);
    let F_w_B_2_2 = (-F_w_S_in_F_2_2)
        .mul_add(cos_delta, F_w_S_in_F_1_2 * sin_delta_doubled)
        + H_frame_1 * w_l_in_b_3_doubled + H_frame_3 * w_l_in_b_1_doubled
        - F_v_Bo_3_2 * xb_doubled + F_v_Bo_1_2 * rr_plus_zb_doubled
        - S::int(2) * F_w_B_2_2_of_place;
    let w_b_2_doubled = S::int(2) * w_B_2;
    let ibxz_doubled = S::int(2) * IBxz;
    let f_w_b_in_s_3_2_doubled = S::int(2) * F_w_B_in_S_3_2;
    let F_w_L_in_B_3_2 = F_w_B_in_S_1_2.mul_add(sin_lam, S::int(2) * IBzz * alpha_B_3_2)
        + H_frame_2 * w_l_in_b_1_doubled + F_v_Bo_2_2 * xb_doubled
        - H_frame_1 * w_b_2_doubled + alpha_B_1_2 * ibxz_doubled - f_w_b_in_s_3_2_doubled * cos_lam;
    let F_w_L_in_B_1_2 = (-F_w_B_in_S_1_2)
        .mul_add(cos_lam, S::int(2) * IBxx * alpha_B_1_2)
        + H_frame_2 * w_l_in_b_3_doubled - F_v_Bo_2_2 * rr_plus_zb_doubled
        + H_frame_3 * w_b_2_doubled + alpha_B_3_2 * ibxz_doubled - f_w_b_in_s_3_2_doubled * sin_lam;
    let F_w_RW_2_2 = (-u1).mul_add(H_rear_wheel_3, w_Y_in_L_3 * H_rear_wheel_1) - IRyy * alpha_RW_2;
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let F_w_Y_in_L_3_2_of_u1 = u1.mul_add(H_rear_wheel_2, w_Y_in_L_2 * H_rear_wheel_1);
    let F_w_Y_in_L_3_2_of_u1_2 = IRxx * u1.mul_add(w_y_in_l_2_plus_w_rw_2, -alpha_RW_3_2)
        - F_w_Y_in_L_3_2_of_u1;
    let F_w_Y_in_L_3_2 = (-F_w_L_in_B_1_2).mul_add(sin_theta, F_w_L_in_B_3_2 * cos_theta)
        - S::int(2) * F_w_Y_in_L_3_2_of_u1_2;
    let F_w_Y_in_L_2_2_of_place = rR.mul_add(F_v_RC_1_2, F_w_RW_2_2);
    let F_w_Y_in_L_2_2 = F_w_Y_in_L_2_2_of_place.mul_add(S::int(2), F_w_B_2_2);
    let f_w_fw_2_2_halved = S::ratio(1, 2) * F_w_FW_2_2;
    let tau1_of_place = (-F_w_Y_in_L_2_2).mul_add(sin_phi, F_w_Y_in_L_3_2 * cos_phi);
    let tau1_of_place_halved = S::ratio(1, 2) * tau1_of_place;
    let f_w_b_2_2_halved = S::ratio(1, 2) * F_w_B_2_2;
    let tau1_of_place_2 = F_w_L_in_B_1_2.mul_add(cos_theta, F_w_L_in_B_3_2 * sin_theta);
    // Values.
    let tau1 = w_Y_in_L_3 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_3 + rR * F_v_RC_2_2
        + IRxx * (-w_Y_in_L_3).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_1)
        + ratio_thF_u1 * f_w_fw_2_2_halved - ratio_psi_u1 * tau1_of_place_halved
        - ratio_theta_u1 * f_w_b_2_2_halved + S::ratio(1, 2) * tau1_of_place_2;
    let tau2 = ratio_thF_u2.mul_add(f_w_fw_2_2_halved, -F_w_F_3_2)
        - ratio_psi_u2 * tau1_of_place_halved - ratio_theta_u2 * f_w_b_2_2_halved;
    let tau3 = -F_w_RW_2_2 + ratio_thF_u3 * f_w_fw_2_2_halved
        - F_v_RC_1_2 * rr_sin_psi.mul_add(sin_psi, rr_cos_psi * cos_psi)
        - ratio_psi_u3 * tau1_of_place_halved;
    [tau1, tau2, tau3]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    u: &[S; 3],
    direction: &[S; 11],
) -> [S; 11] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[8 + i],
    });
    let (of_q, of_v) = (coordinate_rates(&p, &q, &v), accelerations(&p, &q, &v));
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
            parameters: 26,
            coordinates: 8,
            variables: 3,
            speeds: 3,
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
    fn linear_system(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        matrix: &mut [S],
        forcing: &mut [S],
    ) {
        let (of_matrix, of_forcing) = linear_system(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        matrix.copy_from_slice(&of_matrix);
        forcing.copy_from_slice(&of_forcing);
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
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["contact"][at]
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
