//! Whipple bicycle: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{constraint_slopes, constraints, coordinate_rates, divisors};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rear_wheel force l1, rear_wheel force l2, rear_wheel force l3, rear_wheel moment l1, rear_wheel moment l2, rear_wheel moment l3, frame force b1, frame force b2, frame force b3, frame moment b1, frame moment b2, frame moment b3, fork force h1, fork force h2, fork force h3, fork moment h1, fork moment h2, fork moment h3, front_wheel force f1, front_wheel force f2, front_wheel force f3, front_wheel moment f1, front_wheel moment f2, front_wheel moment f3.
///
/// 869 operations, 7 sines and cosines, 2 other functions.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    _u: &[S; 3],
) -> [[S; 24]; 24] {
    let Parameters {
        w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx, IHxz,
        IHyy, IHzz, rF, mF, IFxx, IFyy,
        ..
    } = *p;
    let [_, _, psi, phi, theta, delta, thR, _] = *q;
    // Sines and cosines.
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    // Step by step, each after the terms that it needs.
    let ratio_theta_u1_of_c_lam_rf = (-rF).mul_add(sin_lam, c * cos_lam);
    let ratio_psi_u1_of_c_lam_rf = -ratio_theta_u1_of_c_lam_rf;
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let x_F_in_S_3_2_of_place = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let ratio_theta_u1_of_place = (-x_F_in_S_3_2_of_place)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let x_F_in_S_3_2_of_place_2 = x_F_in_S_3_2_of_place * sin_delta;
    let x_F_in_S_3_2_of_place_3 = sin_phi_cos_delta + x_F_in_S_3_2_of_place_2;
    let x_F_in_S_3_2_of_place_4 = S::int(1)
        / x_F_in_S_3_2_of_place_3.mul_add(x_F_in_S_3_2_of_place_3, -S::int(1));
    let x_F_in_S_3_2_of_place_5 = cos_phi * sin_lam_plus_theta * sin_delta;
    let x_F_in_S_3_2_of_place_6 = rF * x_F_in_S_3_2_of_place_4
        * (S::int(1) - (x_F_in_S_3_2_of_place_5 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_theta_u1_of_place_2 = ratio_theta_u1_of_place * x_F_in_S_3_2_of_place_6;
    let ratio_psi_u1_of_place = ratio_theta_u1_of_place_2 - ratio_psi_u1_of_c_lam_rf;
    let ratio_psi_u1_of_place_2 = cos_lam_plus_theta * sin_delta;
    let ratio_psi_u1_of_place_3 = -ratio_psi_u1_of_place * ratio_psi_u1_of_place_2;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let x_F_in_S_3_2_of_place_7 = cos_phi * cos_lam_plus_theta;
    let x_F_in_S_3_2 = x_F_in_S_3_2_of_place_6 * x_F_in_S_3_2_of_place_7;
    let ratio_theta_u1_of_place_3 = ratio_theta_u1_of_w_lam_rr_rf - x_F_in_S_3_2;
    let ratio_psi_u1_of_place_4 = -ratio_theta_u1_of_place_3;
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
    let ratio_theta_u1_of_place_4 = -ratio_theta_u1_of_c_lam_rf - ratio_theta_u1_of_place_2;
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let ratio_theta_u1_of_place_5 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, sin_delta_cos_phi);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_theta_u1_of_place_6 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
    let ratio_theta_u1_of_place_7 = x_F_in_S_3_2_of_place_3 * x_F_in_S_3_2_of_place_4;
    let ratio_theta_u1_of_place_8 = ratio_theta_u1_of_place_2 * ratio_theta_u1_of_place_7;
    let ratio_theta_u1_of_place_9 = sin_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_10 = x_F_in_S_3_2 * ratio_theta_u1_of_place_7;
    let ratio_theta_u1_of_place_11 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(sin_lam_plus_theta, rR);
    let ratio_theta_u1_of_place_12 = ratio_theta_u1_of_place_11 * sin_phi;
    let ratio_theta_u1_of_place_13 = x_F_in_S_3_2_of_place_7 * sin_delta;
    let ratio_theta_u1_of_place_14 = ratio_theta_u1_of_place_10
        .mul_add(
            ratio_theta_u1_of_place_13,
            x_F_in_S_3_2_of_place * x_F_in_S_3_2_of_place_6,
        );
    let ratio_theta_u1_of_place_15 = ratio_theta_u1_of_place_4
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_16 = S::int(1)
        / (-ratio_theta_u1_of_place
            * ratio_theta_u1_of_place_8
                .mul_add(ratio_theta_u1_of_place_13, x_F_in_S_3_2 * cos_delta)
            + x_F_in_S_3_2_of_place * ratio_theta_u1_of_place_3
            - x_F_in_S_3_2_of_place_7 * (ratio_theta_u1_of_place_14 - ratio_theta_u1_of_place_15));
    let ratio_theta_u1 = ratio_theta_u1_of_place_16
        * (-ratio_theta_u1_of_place
            * ratio_theta_u1_of_place_6
                .mul_add(
                    ratio_theta_u1_of_place_8,
                    x_F_in_S_3_2_of_place_6 * ratio_theta_u1_of_place_5,
                ) + ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_5
            - ratio_theta_u1_of_place_3 * ratio_theta_u1_of_place_9
            + x_F_in_S_3_2_of_place_7
                * (-ratio_theta_u1_of_place_6)
                    .mul_add(
                        ratio_theta_u1_of_place_10,
                        x_F_in_S_3_2_of_place_6 * ratio_theta_u1_of_place_9,
                    ) + ratio_theta_u1_of_place_12);
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
            ratio_theta_u1_of_place_5,
            ratio_psi_u1_of_place_8 * ratio_theta_u1_of_place_6,
        ) + ratio_psi_u1_of_place_11 * ratio_theta_u1_of_place_9;
    let ratio_psi_u1_of_place_17 = (-ratio_psi_u1_of_place_7)
        .mul_add(ratio_theta_u1_of_place_5, ratio_theta_u1_of_place_11 * cos_phi)
        - ratio_psi_u1_of_place_6 * ratio_theta_u1_of_place_6
        - ratio_psi_u1_of_place_3 * ratio_theta_u1_of_place_9
        + ratio_theta_u1 * ratio_psi_u1_of_place_16;
    let ratio_psi_u1_of_place_18 = ratio_theta_u1_of_place_6 * ratio_psi_u1_of_place_14;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_17)
        .mul_add(
            ratio_psi_u1_of_place_18,
            ratio_psi_u1_of_place_13 * ratio_psi_u1_of_place_15,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_16
        * (-x_F_in_S_3_2_of_place_7 * x_F_in_S_3_2_of_place_7 * ratio_theta_u1_of_place_8
            + x_F_in_S_3_2_of_place_3 * ratio_theta_u1_of_place_4
            - ratio_theta_u1_of_place
                * ratio_theta_u1_of_place
                    .mul_add(
                        ratio_theta_u1_of_place_8,
                        x_F_in_S_3_2_of_place_3 * x_F_in_S_3_2_of_place_6,
                    ));
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place_2
        .mul_add(ratio_theta_u1_of_place_4, ratio_theta_u2 * ratio_psi_u1_of_place_12);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_16,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_6,
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
            * sin_phi_cos_delta.mul_add(S::int(2), x_F_in_S_3_2_of_place_5))
        .sqrt();
    let ratio_thF_u1_of_place_2 = ratio_psi_u1_of_place_14 * ratio_thF_u1_of_place;
    let ratio_thF_u1_of_place_3 = rf_inv * ratio_thF_u1_of_place_2;
    let x_S_in_B_3_2 = sin_lam * cos_delta;
    let ratio_thF_u1_of_place_4 = x_F_in_S_3_2_of_place_3 * sin_delta * ratio_thF_u1_of_place
        / (-S::int(1) + sin_phi_cos_delta * sin_phi_cos_delta
            + x_F_in_S_3_2_of_place_2
                * sin_phi_cos_delta.mul_add(S::int(2), x_F_in_S_3_2_of_place_2)) - x_S_in_B_3_2;
    let ratio_thF_u1_of_place_5 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    let ratio_thF_u1_of_place_6 = -cos_lam_plus_theta
        * rF.mul_add(ratio_thF_u1_of_place_4, ratio_thF_u1_of_place_5)
        + ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta;
    let ratio_thF_u1_of_place_7 = ratio_psi_u1_of_place_2
        * (-ratio_theta_u1_of_place)
            .mul_add(
                ratio_theta_u1_of_w_lam_rr_rf,
                ratio_psi_u1_of_c_lam_rf * x_F_in_S_3_2_of_place_7,
            ) - x_F_in_S_3_2_of_place_3 * ratio_psi_u1_of_place * sin_lam_plus_theta
        + x_F_in_S_3_2_of_place_3 * ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_5
        + ratio_theta_u1_of_place_12;
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
                * rf_inv.mul_add(ratio_thF_u1_of_place_5, ratio_thF_u1_of_place_4));
    let w_Y_in_L_2_2 = ratio_psi_u1 * sin_phi;
    let x_F_1_3 = rR * w_Y_in_L_2_2;
    let x_L_1_3 = mR * x_F_1_3;
    let w_Y_in_L_2_3 = ratio_psi_u2 * sin_phi;
    let x_F_1_4 = rR * w_Y_in_L_2_3;
    let x_L_1_4 = mR * x_F_1_4;
    let w_Y_in_L_2_4 = ratio_psi_u3 * sin_phi;
    let x_N_in_Y_1 = rR * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let x_F_1_5 = rR.mul_add(w_Y_in_L_2_4, -x_N_in_Y_1);
    let x_L_1_5 = mR * x_F_1_5;
    let x_L_2_3 = rR * mR;
    let x_L_in_Y_3 = rR * cos_phi;
    let x_L_in_Y_2 = rR * sin_phi;
    let x_Y_in_N_1 = x_L_in_Y_2 * sin_psi;
    let x_Y_in_N_2 = x_L_in_Y_2 * cos_psi;
    let x_N_in_Y_1_2 = x_Y_in_N_2.mul_add(cos_psi, x_Y_in_N_1 * sin_psi);
    let x_L_2_4 = IRyy * w_Y_in_L_2_2;
    let x_L_2_5 = IRyy * w_Y_in_L_2_3;
    let w_RW_2_2 = w_Y_in_L_2_4 - S::int(1);
    let x_L_2_6 = IRyy * w_RW_2_2;
    let x_Y_in_L_2 = x_L_in_Y_2.mul_add(sin_phi, x_L_in_Y_3 * cos_phi);
    let x_N_in_Y_2 = (-x_Y_in_N_1).mul_add(cos_psi, x_Y_in_N_2 * sin_psi);
    let x_Y_in_L_2_2 = x_N_in_Y_2 * cos_phi;
    let w_Y_in_L_3_2 = ratio_psi_u1 * cos_phi;
    let x_L_3_3 = IRxx * w_Y_in_L_3_2;
    let w_Y_in_L_3_3 = ratio_psi_u2 * cos_phi;
    let x_L_3_4 = IRxx * w_Y_in_L_3_3;
    let w_Y_in_L_3_4 = ratio_psi_u3 * cos_phi;
    let x_L_3_5 = IRxx * w_Y_in_L_3_4;
    let x_Y_in_L_3 = (-x_L_in_Y_2).mul_add(cos_phi, x_L_in_Y_3 * sin_phi);
    let x_Y_in_L_3_2 = x_N_in_Y_2 * sin_phi;
    let w_B_2_2 = ratio_theta_u1 - w_Y_in_L_2_2;
    let x_L_in_B_1 = x_F_1_3 * cos_theta;
    let rr_plus_zb = rR + zB;
    let a_Bo_1_2 = w_B_2_2.mul_add(rr_plus_zb, x_L_in_B_1);
    let x_B_1_3 = mB * a_Bo_1_2;
    let w_B_2_3 = ratio_theta_u2 - w_Y_in_L_2_3;
    let x_L_in_B_1_2 = x_F_1_4 * cos_theta;
    let a_Bo_1_3 = w_B_2_3.mul_add(rr_plus_zb, x_L_in_B_1_2);
    let x_B_1_4 = mB * a_Bo_1_3;
    let x_L_in_B_1_3 = x_F_1_5 * cos_theta;
    let a_Bo_1_4 = (-w_Y_in_L_2_4).mul_add(rr_plus_zb, x_L_in_B_1_3);
    let x_B_1_5 = mB * a_Bo_1_4;
    let x_L_in_B_1_4 = cos_theta.mul_add(cos_thR, sin_theta * sin_thR);
    let x_L_in_B_1_5 = (-cos_theta).mul_add(sin_thR, sin_theta * cos_thR);
    let w_L_in_B_1_2 = w_Y_in_L_3_2.mul_add(sin_theta, cos_theta);
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, sin_theta);
    let a_Bo_2_2 = xB.mul_add(w_L_in_B_3_2, rR) - w_L_in_B_1_2 * rr_plus_zb;
    let x_B_2_3 = mB * a_Bo_2_2;
    let w_L_in_B_1_3 = w_Y_in_L_3_3 * sin_theta;
    let w_L_in_B_3_3 = w_Y_in_L_3_3 * cos_theta;
    let a_Bo_2_3 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let x_B_2_4 = mB * a_Bo_2_3;
    let w_L_in_B_1_4 = w_Y_in_L_3_4 * sin_theta;
    let w_L_in_B_3_4 = w_Y_in_L_3_4 * cos_theta;
    let a_Bo_2_4 = w_L_in_B_1_4.mul_add(rr_plus_zb, xB * w_L_in_B_3_4);
    let x_B_2_5 = mB * a_Bo_2_4;
    let x_L_in_B_3 = x_F_1_3 * sin_theta;
    let a_Bo_3_2 = (-xB).mul_add(w_B_2_2, x_L_in_B_3);
    let x_B_3_3 = mB * a_Bo_3_2;
    let x_L_in_B_3_2 = x_F_1_4 * sin_theta;
    let a_Bo_3_3 = (-xB).mul_add(w_B_2_3, x_L_in_B_3_2);
    let x_B_3_4 = mB * a_Bo_3_3;
    let x_L_in_B_3_3 = x_F_1_5 * sin_theta;
    let a_Bo_3_4 = xB.mul_add(w_Y_in_L_2_4, x_L_in_B_3_3);
    let x_B_3_5 = mB * a_Bo_3_4;
    let x_B_1_6 = IBxz.mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let x_B_1_7 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let x_B_1_8 = (-IBxz).mul_add(w_L_in_B_3_4, IBxx * w_L_in_B_1_4);
    let x_S_in_B_3 = ratio_theta_u1_of_w_c_lam_rr * sin_lam;
    let x_B_3_6 = x_S_in_B_3 + rr_plus_zb;
    let x_S_in_B_1 = cos_lam * cos_delta;
    let x_B_in_L_1 = rr_plus_zb.mul_add(sin_theta, xB * cos_theta);
    let x_B_in_L_3 = (-xB).mul_add(sin_theta, rr_plus_zb * cos_theta);
    let x_L_in_RW_1 = (-x_B_in_L_1).mul_add(cos_thR, x_B_in_L_3 * sin_thR);
    let x_L_in_RW_3 = x_B_in_L_3.mul_add(cos_thR, x_B_in_L_1 * sin_thR);
    let x_RW_in_L_1 = x_L_in_RW_3.mul_add(cos_thR, x_L_in_RW_1 * sin_thR);
    let x_RW_in_L_3 = (-x_L_in_RW_3).mul_add(sin_thR, x_L_in_RW_1 * cos_thR);
    let x_L_in_B_1_6 = (-x_RW_in_L_1).mul_add(cos_theta, x_RW_in_L_3 * sin_theta);
    let x_B_2_6 = IByy * w_B_2_2;
    let x_B_2_7 = IByy * w_B_2_3;
    let x_B_2_8 = IByy * w_Y_in_L_2_4;
    let x_S_in_B_1_2 = ratio_theta_u1_of_w_c_lam_rr * cos_lam;
    let x_B_1_9 = xB - x_S_in_B_1_2;
    let x_B_3_7 = IBzz.mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let x_B_3_8 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let x_B_3_9 = (-IBzz).mul_add(w_L_in_B_3_4, IBxz * w_L_in_B_1_4);
    let x_L_in_B_3_4 = x_RW_in_L_3.mul_add(cos_theta, x_RW_in_L_1 * sin_theta);
    let w_B_in_S_1_2 = (-w_L_in_B_1_2).mul_add(cos_lam, w_L_in_B_3_2 * sin_lam);
    let w_B_in_S_3_2 = w_L_in_B_3_2.mul_add(cos_lam, w_L_in_B_1_2 * sin_lam);
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_B_2_2 * cos_delta);
    let x_B_in_S_1 = (-x_L_in_B_1).mul_add(cos_lam, x_L_in_B_3 * sin_lam);
    let x_B_in_S_3 = x_L_in_B_3.mul_add(cos_lam, x_L_in_B_1 * sin_lam);
    let x_F_2_3 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, rR);
    let x_F_3_3 = w_B_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3);
    let x_S_in_F_1 = (-x_F_2_3).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_3_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_3 = (-w_S_in_F_2_2).mul_add(a_Ho_1_3_of_lam_rr_xh_zh, x_S_in_F_1);
    let a_Ho_3_3_of_lam_rr_xh_zh = (-rr_plus_zh).mul_add(sin_lam, xH * cos_lam);
    let a_Ho_3_3_of_place = ratio_theta_u1_of_w_c_lam_rr - a_Ho_3_3_of_lam_rr_xh_zh;
    let a_Ho_3_3 = (-w_S_in_F_2_2).mul_add(a_Ho_3_3_of_place, x_F_3_3);
    let x_H_1_3 = mH * a_Ho_1_3;
    let x_H_3_3 = mH * a_Ho_3_3;
    let x_F_in_H_1_2 = x_H_3_3.mul_add(sin_lam, x_H_1_3 * cos_lam);
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_2_3 = (-w_B_2_3).mul_add(cos_delta, w_B_in_S_1_3 * sin_delta);
    let x_B_in_S_1_2 = (-x_L_in_B_1_2).mul_add(cos_lam, x_L_in_B_3_2 * sin_lam);
    let x_B_in_S_3_2 = x_L_in_B_3_2.mul_add(cos_lam, x_L_in_B_1_2 * sin_lam);
    let x_F_2_4 = w_B_in_S_3_3 * ratio_theta_u1_of_w_c_lam_rr;
    let x_F_3_4 = w_B_2_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3_2);
    let x_S_in_F_1_2 = x_F_2_4.mul_add(sin_delta, x_B_in_S_1_2 * cos_delta);
    let a_Ho_1_4 = w_S_in_F_2_3.mul_add(a_Ho_1_3_of_lam_rr_xh_zh, x_S_in_F_1_2);
    let a_Ho_3_4 = w_S_in_F_2_3.mul_add(a_Ho_3_3_of_place, x_F_3_4);
    let x_H_1_4 = mH * a_Ho_1_4;
    let x_H_3_4 = mH * a_Ho_3_4;
    let x_F_in_H_1_3 = x_H_3_4.mul_add(sin_lam, x_H_1_4 * cos_lam);
    let w_B_in_S_1_4 = w_L_in_B_3_4.mul_add(sin_lam, w_L_in_B_1_4 * cos_lam);
    let w_B_in_S_3_4 = (-w_L_in_B_1_4).mul_add(sin_lam, w_L_in_B_3_4 * cos_lam);
    let w_S_in_F_2_4 = w_B_in_S_1_4.mul_add(sin_delta, w_Y_in_L_2_4 * cos_delta);
    let x_B_in_S_1_3 = (-x_L_in_B_1_3).mul_add(cos_lam, x_L_in_B_3_3 * sin_lam);
    let x_B_in_S_3_3 = x_L_in_B_3_3.mul_add(cos_lam, x_L_in_B_1_3 * sin_lam);
    let x_F_2_5 = w_B_in_S_3_4 * ratio_theta_u1_of_w_c_lam_rr;
    let x_F_3_5 = w_Y_in_L_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, x_B_in_S_3_3);
    let x_S_in_F_1_3 = x_F_2_5.mul_add(sin_delta, x_B_in_S_1_3 * cos_delta);
    let a_Ho_1_5 = w_S_in_F_2_4.mul_add(a_Ho_1_3_of_lam_rr_xh_zh, x_S_in_F_1_3);
    let a_Ho_3_5 = (-w_S_in_F_2_4).mul_add(a_Ho_3_3_of_place, x_F_3_5);
    let x_H_1_5 = mH * a_Ho_1_5;
    let x_H_3_5 = mH * a_Ho_3_5;
    let x_F_in_H_1_4 = (-x_H_1_5).mul_add(cos_lam, x_H_3_5 * sin_lam);
    let x_F_in_H_1_5 = x_S_in_B_1.mul_add(cos_lam, sin_lam * sin_lam);
    let x_F_in_H_1_6 = cos_lam * sin_delta;
    let cos_lam_sin_lam = sin_lam * cos_lam;
    let x_F_in_H_1_7 = (-x_S_in_B_3_2).mul_add(cos_lam, cos_lam_sin_lam);
    let w_S_in_F_1_2 = (-w_B_2_2).mul_add(sin_delta, w_B_in_S_1_2 * cos_delta);
    let x_S_in_F_2 = x_F_2_3.mul_add(cos_delta, x_B_in_S_1 * sin_delta);
    let a_Ho_2_3 = w_S_in_F_1_2.mul_add(a_Ho_1_3_of_lam_rr_xh_zh, x_S_in_F_2)
        - w_B_in_S_3_2 * a_Ho_3_3_of_place;
    let x_H_2_3 = mH * a_Ho_2_3;
    let w_S_in_F_1_3 = w_B_in_S_1_3.mul_add(cos_delta, w_B_2_3 * sin_delta);
    let w_F_3_2 = w_B_in_S_3_3 - S::int(1);
    let x_S_in_F_2_2 = (-x_F_2_4).mul_add(cos_delta, x_B_in_S_1_2 * sin_delta);
    let a_Ho_2_4 = (-w_S_in_F_1_3).mul_add(a_Ho_1_3_of_lam_rr_xh_zh, x_S_in_F_2_2)
        + w_F_3_2 * a_Ho_3_3_of_place;
    let x_H_2_4 = mH * a_Ho_2_4;
    let w_S_in_F_1_4 = (-w_Y_in_L_2_4).mul_add(sin_delta, w_B_in_S_1_4 * cos_delta);
    let x_S_in_F_2_3 = (-x_F_2_5).mul_add(cos_delta, x_B_in_S_1_3 * sin_delta);
    let a_Ho_2_5 = (-w_S_in_F_1_4).mul_add(a_Ho_1_3_of_lam_rr_xh_zh, x_S_in_F_2_3)
        + w_B_in_S_3_4 * a_Ho_3_3_of_place;
    let x_H_2_5 = mH * a_Ho_2_5;
    let x_S_in_F_2_4 = sin_lam * sin_delta;
    let x_F_in_H_3_2 = (-x_H_1_3).mul_add(sin_lam, x_H_3_3 * cos_lam);
    let x_F_in_H_3_3 = (-x_H_1_4).mul_add(sin_lam, x_H_3_4 * cos_lam);
    let x_F_in_H_3_4 = x_H_3_5.mul_add(cos_lam, x_H_1_5 * sin_lam);
    let x_F_in_H_3_5 = (-x_S_in_B_1).mul_add(sin_lam, cos_lam_sin_lam);
    let x_F_in_H_3_6 = x_S_in_B_3_2.mul_add(sin_lam, cos_lam * cos_lam);
    let alpha_F_in_H_1_2 = (-w_S_in_F_1_2).mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let alpha_F_in_H_3_2 = w_S_in_F_1_2.mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let x_H_1_6 = IHxz.mul_add(alpha_F_in_H_3_2, IHxx * alpha_F_in_H_1_2);
    let alpha_F_in_H_1_3 = (-w_S_in_F_1_3).mul_add(cos_lam, w_F_3_2 * sin_lam);
    let alpha_F_in_H_3_3 = w_F_3_2.mul_add(cos_lam, w_S_in_F_1_3 * sin_lam);
    let x_H_1_7 = IHxz.mul_add(alpha_F_in_H_3_3, IHxx * alpha_F_in_H_1_3);
    let alpha_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let alpha_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let x_H_1_8 = IHxz.mul_add(alpha_F_in_H_3_4, IHxx * alpha_F_in_H_1_4);
    let x_F_1_6 = a_Ho_3_3_of_place - ratio_theta_u1_of_c_lam_rf;
    let x_F_3_6 = a_Ho_1_3_of_lam_rr_xh_zh - ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_in_H_1_8 = x_F_3_6.mul_add(cos_lam, x_F_1_6 * sin_lam);
    let x_F_in_S_1 = a_Ho_3_3_of_place * cos_delta;
    let x_F_in_S_2 = a_Ho_3_3_of_place * sin_delta;
    let x_F_in_S_3 = a_Ho_1_3_of_lam_rr_xh_zh;
    let x_S_in_B_3_3 = x_F_in_S_3.mul_add(cos_lam, x_F_in_S_1 * sin_lam);
    let x_B_in_S_1_4 = x_F_in_S_2 * sin_lam;
    let x_B_in_S_1_5 = x_F_in_S_2 * cos_lam;
    let x_S_in_F_1_4 = (-x_S_in_B_3_3).mul_add(sin_delta, x_B_in_S_1_4 * cos_delta);
    let x_F_in_H_1_9 = (-x_S_in_F_1_4).mul_add(cos_lam, x_B_in_S_1_5 * sin_lam);
    let x_S_in_B_1_3 = (-x_F_in_S_1).mul_add(cos_lam, x_F_in_S_3 * sin_lam);
    let x_B_in_S_1_6 = x_S_in_B_1_3.mul_add(sin_lam, x_S_in_B_3_3 * cos_lam);
    let x_B_in_S_3_4 = (-x_S_in_B_3_3).mul_add(sin_lam, x_S_in_B_1_3 * cos_lam);
    let x_S_in_F_1_5 = x_B_in_S_1_6 * cos_delta;
    let x_F_in_H_1_10 = (-x_S_in_F_1_5).mul_add(cos_lam, x_B_in_S_3_4 * sin_lam);
    let x_S_in_F_1_6 = x_S_in_B_1_3.mul_add(sin_delta, x_B_in_S_1_5 * cos_delta);
    let x_F_in_H_1_11 = x_S_in_F_1_6.mul_add(cos_lam, x_B_in_S_1_4 * sin_lam);
    let x_H_2_6 = IHyy * w_S_in_F_2_2;
    let x_H_2_7 = IHyy * w_S_in_F_2_3;
    let x_H_2_8 = IHyy * w_S_in_F_2_4;
    let x_S_in_F_2_5 = x_B_in_S_1_4.mul_add(sin_delta, x_S_in_B_3_3 * cos_delta);
    let x_S_in_F_2_6 = x_B_in_S_1_6 * sin_delta;
    let x_S_in_F_2_7 = (-x_S_in_B_1_3).mul_add(cos_delta, x_B_in_S_1_5 * sin_delta);
    let x_H_3_6 = IHzz.mul_add(alpha_F_in_H_3_2, IHxz * alpha_F_in_H_1_2);
    let x_H_3_7 = IHzz.mul_add(alpha_F_in_H_3_3, IHxz * alpha_F_in_H_1_3);
    let x_H_3_8 = IHzz.mul_add(alpha_F_in_H_3_4, IHxz * alpha_F_in_H_1_4);
    let x_F_in_H_3_7 = (-x_F_3_6).mul_add(sin_lam, x_F_1_6 * cos_lam);
    let x_F_in_H_3_8 = x_S_in_F_1_4.mul_add(sin_lam, x_B_in_S_1_5 * cos_lam);
    let x_F_in_H_3_9 = x_S_in_F_1_5.mul_add(sin_lam, x_B_in_S_3_4 * cos_lam);
    let x_F_in_H_3_10 = (-x_S_in_F_1_6).mul_add(sin_lam, x_B_in_S_1_4 * cos_lam);
    let a_FC_1_2 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -x_S_in_F_1);
    let x_F_1_7 = mF * a_FC_1_2;
    let a_FC_1_3 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_w_lam_rr_rf, x_S_in_F_1_2);
    let x_F_1_8 = mF * a_FC_1_3;
    let a_FC_1_4 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_w_lam_rr_rf, x_S_in_F_1_3);
    let x_F_1_9 = mF * a_FC_1_4;
    let x_B_in_S_1_7 = (-sin_lam).mul_add(sin_theta, cos_lam * cos_theta);
    let x_S_in_F_1_7 = x_B_in_S_1_7 * cos_delta;
    let x_L_in_B_1_7 = sin_phi * sin_theta;
    let x_L_in_B_3_5 = sin_phi * cos_theta;
    let x_B_in_S_1_8 = x_L_in_B_3_5.mul_add(sin_lam, x_L_in_B_1_7 * cos_lam);
    let x_S_in_F_1_8 = x_B_in_S_1_8.mul_add(cos_delta, sin_delta_cos_phi);
    let x_L_in_B_1_8 = cos_phi * sin_theta;
    let x_L_in_B_3_6 = cos_phi * cos_theta;
    let x_B_in_S_1_9 = x_L_in_B_3_6.mul_add(sin_lam, x_L_in_B_1_8 * cos_lam);
    let x_S_in_F_1_9 = (-x_B_in_S_1_9).mul_add(cos_delta, sin_delta_sin_phi);
    let a_FC_2_2 = w_B_in_S_3_2.mul_add(ratio_psi_u1_of_c_lam_rf, x_S_in_F_2)
        + w_S_in_F_1_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_6 = mF * a_FC_2_2;
    let a_FC_2_3 = w_F_3_2.mul_add(ratio_psi_u1_of_c_lam_rf, -x_S_in_F_2_2)
        + w_S_in_F_1_3 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_7 = mF * a_FC_2_3;
    let a_FC_2_4 = w_B_in_S_3_4.mul_add(ratio_psi_u1_of_c_lam_rf, -x_S_in_F_2_3)
        + w_S_in_F_1_4 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_8 = mF * a_FC_2_4;
    let x_S_in_F_2_8 = x_B_in_S_1_7 * sin_delta;
    let x_S_in_F_2_9 = (-x_B_in_S_1_8).mul_add(sin_delta, cos_delta_cos_phi);
    let x_S_in_F_2_10 = x_B_in_S_1_9.mul_add(sin_delta, sin_phi_cos_delta);
    let a_FC_3_2 = w_S_in_F_2_2.mul_add(ratio_psi_u1_of_c_lam_rf, x_F_3_3);
    let x_F_3_7 = mF * a_FC_3_2;
    let a_FC_3_3 = w_S_in_F_2_3.mul_add(ratio_psi_u1_of_c_lam_rf, -x_F_3_4);
    let x_F_3_8 = mF * a_FC_3_3;
    let a_FC_3_4 = w_S_in_F_2_4.mul_add(ratio_psi_u1_of_c_lam_rf, x_F_3_5);
    let x_F_3_9 = mF * a_FC_3_4;
    let x_B_in_S_3_5 = sin_lam.mul_add(cos_theta, cos_lam * sin_theta);
    let x_B_in_S_3_6 = (-x_L_in_B_1_7).mul_add(sin_lam, x_L_in_B_3_5 * cos_lam);
    let x_B_in_S_3_7 = (-x_L_in_B_1_8).mul_add(sin_lam, x_L_in_B_3_6 * cos_lam);
    let x_F_1_10 = IFxx * w_S_in_F_1_2;
    let x_F_1_11 = IFxx * w_S_in_F_1_3;
    let x_F_1_12 = IFxx * w_S_in_F_1_4;
    let x_F_in_S_1_2 = ratio_theta_u1_of_place_2 * cos_delta;
    let x_F_in_S_2_2 = ratio_theta_u1_of_place_2 * sin_delta;
    let x_S_in_B_1_4 = x_F_in_S_3_2.mul_add(sin_lam, x_F_in_S_1_2 * cos_lam);
    let x_S_in_B_3_4 = (-x_F_in_S_1_2).mul_add(sin_lam, x_F_in_S_3_2 * cos_lam);
    let x_B_in_L_3_2 = (-x_S_in_B_1_4).mul_add(sin_theta, x_S_in_B_3_4 * cos_theta);
    let x_L_in_Y_2_2 = (-x_B_in_L_3_2).mul_add(sin_phi, x_F_in_S_2_2 * cos_phi);
    let x_L_in_Y_3_2 = x_B_in_L_3_2.mul_add(cos_phi, x_F_in_S_2_2 * sin_phi);
    let x_Y_in_L_2_3 = (-x_L_in_Y_2_2).mul_add(sin_phi, x_L_in_Y_3_2 * cos_phi);
    let x_Y_in_L_3_3 = x_L_in_Y_3_2.mul_add(sin_phi, x_L_in_Y_2_2 * cos_phi);
    let x_L_in_B_1_9 = x_Y_in_L_3_3 * sin_theta;
    let x_L_in_B_3_7 = x_Y_in_L_3_3 * cos_theta;
    let x_B_in_S_1_10 = x_L_in_B_3_7.mul_add(sin_lam, x_L_in_B_1_9 * cos_lam);
    let x_S_in_F_1_10 = x_B_in_S_1_10.mul_add(cos_delta, x_Y_in_L_2_3 * sin_delta);
    let x_B_in_L_1_2 = x_S_in_B_3_4.mul_add(sin_theta, x_S_in_B_1_4 * cos_theta);
    let x_Y_in_L_2_4 = x_B_in_L_1_2 * sin_phi;
    let x_Y_in_L_3_4 = x_B_in_L_1_2 * cos_phi;
    let x_L_in_B_1_10 = x_Y_in_L_3_4.mul_add(sin_theta, x_L_in_Y_3_2 * cos_theta);
    let x_L_in_B_3_8 = (-x_L_in_Y_3_2).mul_add(sin_theta, x_Y_in_L_3_4 * cos_theta);
    let x_B_in_S_1_11 = x_L_in_B_3_8.mul_add(sin_lam, x_L_in_B_1_10 * cos_lam);
    let x_S_in_F_1_11 = (-x_Y_in_L_2_4).mul_add(sin_delta, x_B_in_S_1_11 * cos_delta);
    let x_Y_in_N_1_2 = (-x_L_in_Y_2_2).mul_add(sin_psi, x_B_in_L_1_2 * cos_psi);
    let x_Y_in_N_2_2 = x_B_in_L_1_2.mul_add(sin_psi, x_L_in_Y_2_2 * cos_psi);
    let x_N_in_Y_1_3 = (-x_Y_in_N_1_2).mul_add(sin_psi, x_Y_in_N_2_2 * cos_psi);
    let x_N_in_Y_2_2 = x_Y_in_N_2_2.mul_add(sin_psi, x_Y_in_N_1_2 * cos_psi);
    let x_Y_in_L_2_5 = x_N_in_Y_2_2 * cos_phi;
    let x_Y_in_L_3_5 = x_N_in_Y_2_2 * sin_phi;
    let x_L_in_B_1_11 = (-x_N_in_Y_1_3).mul_add(cos_theta, x_Y_in_L_3_5 * sin_theta);
    let x_L_in_B_3_9 = x_Y_in_L_3_5.mul_add(cos_theta, x_N_in_Y_1_3 * sin_theta);
    let x_B_in_S_1_12 = x_L_in_B_3_9.mul_add(sin_lam, x_L_in_B_1_11 * cos_lam);
    let x_S_in_F_1_12 = x_B_in_S_1_12.mul_add(cos_delta, x_Y_in_L_2_5 * sin_delta);
    let w_FW_2_2 = ratio_thF_u1 + w_S_in_F_2_2;
    let x_F_2_9 = IFyy * w_FW_2_2;
    let w_FW_2_3 = ratio_thF_u2 - w_S_in_F_2_3;
    let x_F_2_10 = IFyy * w_FW_2_3;
    let w_FW_2_4 = ratio_thF_u3 - w_S_in_F_2_4;
    let x_F_2_11 = IFyy * w_FW_2_4;
    let x_S_in_F_2_11 = (-x_Y_in_L_2_3).mul_add(cos_delta, x_B_in_S_1_10 * sin_delta);
    let x_S_in_F_2_12 = x_B_in_S_1_11.mul_add(sin_delta, x_Y_in_L_2_4 * cos_delta);
    let x_S_in_F_2_13 = (-x_Y_in_L_2_5).mul_add(cos_delta, x_B_in_S_1_12 * sin_delta);
    let x_F_3_10 = IFxx * w_B_in_S_3_2;
    let x_F_3_11 = IFxx * w_F_3_2;
    let x_F_3_12 = IFxx * w_B_in_S_3_4;
    let x_B_in_S_3_8 = (-x_L_in_B_1_9).mul_add(sin_lam, x_L_in_B_3_7 * cos_lam);
    let x_B_in_S_3_9 = (-x_L_in_B_1_10).mul_add(sin_lam, x_L_in_B_3_8 * cos_lam);
    let x_B_in_S_3_10 = (-x_L_in_B_1_11).mul_add(sin_lam, x_L_in_B_3_9 * cos_lam);
    let minus_sin_lam = -sin_lam;
    let minus_sin_thr = -sin_thR;
    let minus_cos_phi = -cos_phi;
    let minus_cos_delta = -cos_delta;
    let minus_x_l_in_b_1_4 = -x_L_in_B_1_4;
    let minus_x_l_in_b_1_5 = -x_L_in_B_1_5;
    let minus_x_f_in_h_1_6 = -x_F_in_H_1_6;
    // Entries that are not zero.
    let m_1_4 = -S::int(1);
    let m_1_18 = cos_thR;
    let m_1_20 = sin_thR;
    let m_2_5 = minus_cos_phi;
    let m_2_19 = S::int(1);
    let m_2_23 = -sin_phi;
    let m_3_5 = sin_phi;
    let m_3_18 = minus_sin_thr;
    let m_3_20 = cos_thR;
    let m_3_23 = minus_cos_phi;
    let m_4_1 = IRxx;
    let m_4_21 = cos_thR;
    let m_4_22 = sin_thR;
    let m_5_1 = -x_L_2_4;
    let m_5_2 = -x_L_2_5;
    let m_5_3 = -x_L_2_6;
    let m_5_4 = -x_Y_in_L_2;
    let m_5_23 = -x_Y_in_L_2_2;
    let m_6_1 = -x_L_3_3;
    let m_6_2 = -x_L_3_4;
    let m_6_3 = -x_L_3_5;
    let m_6_21 = minus_sin_thr;
    let m_6_22 = cos_thR;
    let m_7_13 = S::int(1);
    let m_7_18 = minus_x_l_in_b_1_4;
    let m_8_2 = -x_B_2_4;
    let m_8_3 = -x_B_2_5;
    let m_8_14 = S::int(1);
    let m_8_19 = -S::int(1);
    let m_9_15 = S::int(1);
    let m_9_18 = minus_x_l_in_b_1_5;
    let m_9_20 = minus_x_l_in_b_1_4;
    let m_10_21 = minus_x_l_in_b_1_4;
    let m_11_3 = -x_B_2_8;
    let m_11_13 = -x_B_3_6;
    let m_11_16 = S::int(1);
    let m_11_17 = sin_delta;
    let m_12_14 = -x_B_1_9;
    let m_12_17 = -x_S_in_B_3_2;
    let m_12_19 = -x_L_in_B_3_4;
    let m_12_21 = minus_x_l_in_b_1_5;
    let m_12_22 = minus_x_l_in_b_1_4;
    let m_13_1 = -x_F_in_H_1_2;
    let m_13_2 = -x_F_in_H_1_3;
    let m_13_8 = cos_lam;
    let m_13_10 = sin_lam;
    let m_13_13 = -x_F_in_H_1_5;
    let m_13_14 = minus_x_f_in_h_1_6;
    let m_13_15 = -x_F_in_H_1_7;
    let m_14_9 = S::int(1);
    let m_14_14 = minus_cos_delta;
    let m_14_15 = -x_S_in_F_2_4;
    let m_15_1 = -x_F_in_H_3_2;
    let m_15_2 = -x_F_in_H_3_3;
    let m_15_8 = minus_sin_lam;
    let m_15_10 = cos_lam;
    let m_15_13 = -x_F_in_H_3_5;
    let m_15_15 = -x_F_in_H_3_6;
    let m_16_2 = -x_H_1_7;
    let m_16_3 = -x_H_1_8;
    let m_16_11 = cos_lam;
    let m_16_12 = sin_lam;
    let m_16_15 = -x_F_in_H_1_11;
    let m_16_16 = minus_x_f_in_h_1_6;
    let m_16_17 = -cos_lam;
    let m_17_2 = -x_H_2_7;
    let m_17_3 = -x_H_2_8;
    let m_17_8 = -x_F_3_6;
    let m_17_10 = -x_F_1_6;
    let m_17_16 = minus_cos_delta;
    let m_18_2 = -x_H_3_7;
    let m_18_3 = -x_H_3_8;
    let m_18_11 = minus_sin_lam;
    let m_18_12 = cos_lam;
    let m_18_15 = -x_F_in_H_3_10;
    let m_18_17 = sin_lam;
    let m_19_2 = -x_F_1_8;
    let m_19_3 = -x_F_1_9;
    let m_19_6 = -x_S_in_F_1_7;
    let m_19_7 = -x_S_in_F_1_8;
    let m_19_8 = -S::int(1);
    let m_19_24 = -x_S_in_F_1_9;
    let m_20_2 = -x_F_2_7;
    let m_20_3 = -x_F_2_8;
    let m_20_7 = -x_S_in_F_2_9;
    let m_20_9 = -S::int(1);
    let m_20_24 = -x_S_in_F_2_10;
    let m_21_1 = -x_F_3_7;
    let m_21_6 = -x_B_in_S_3_5;
    let m_21_10 = -S::int(1);
    let m_21_24 = -x_B_in_S_3_7;
    let m_22_1 = -x_F_1_10;
    let m_22_7 = -x_S_in_F_1_11;
    let m_22_11 = -S::int(1);
    let m_22_24 = -x_S_in_F_1_12;
    let m_23_6 = -x_S_in_F_2_11;
    let m_24_2 = -x_F_3_11;
    let m_24_3 = -x_F_3_12;
    let m_24_6 = -x_B_in_S_3_8;
    let m_24_12 = -S::int(1);
    let zero = S::int(0);
    [
        [
            x_L_1_3, x_L_1_4, x_L_1_5, m_1_4, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_1_18, zero, m_1_20, zero, zero, zero, zero,
        ],
        [
            x_L_2_3, zero, zero, zero, m_2_5, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_2_19, zero, zero, zero, m_2_23, zero,
        ],
        [
            zero, zero, zero, zero, m_3_5, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_3_18, zero, m_3_20, zero, zero, m_3_23, zero,
        ],
        [
            m_4_1, zero, zero, zero, x_L_in_Y_3, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_4_21, m_4_22, x_N_in_Y_1_2, zero,
        ],
        [
            m_5_1, m_5_2, m_5_3, m_5_4, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_5_23, zero,
        ],
        [
            m_6_1, m_6_2, m_6_3, x_Y_in_L_3, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_6_21, m_6_22, x_Y_in_L_3_2, zero,
        ],
        [
            x_B_1_3, x_B_1_4, x_B_1_5, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_7_13,
            zero, zero, zero, zero, m_7_18, zero, x_L_in_B_1_5, zero, zero, zero, zero,
        ],
        [
            x_B_2_3, m_8_2, m_8_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_8_14, zero, zero, zero, zero, m_8_19, zero, zero, zero, zero, zero,
        ],
        [
            x_B_3_3, x_B_3_4, x_B_3_5, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_9_15, zero, zero, m_9_18, zero, m_9_20, zero, zero, zero, zero,
        ],
        [
            x_B_1_6, x_B_1_7, x_B_1_8, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            x_B_3_6, zero, zero, x_S_in_B_1, zero, x_L_in_B_1_6, zero, m_10_21, x_L_in_B_1_5, zero,
            zero,
        ],
        [
            x_B_2_6, x_B_2_7, m_11_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_11_13,
            zero, x_B_1_9, m_11_16, m_11_17, x_L_in_RW_3, zero, x_L_in_RW_1, zero, zero, zero, zero,
        ],
        [
            x_B_3_7, x_B_3_8, x_B_3_9, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_12_14, zero, zero, m_12_17, zero, m_12_19, zero, m_12_21, m_12_22, zero, zero,
        ],
        [
            m_13_1, m_13_2, x_F_in_H_1_4, zero, zero, zero, zero, m_13_8, zero, m_13_10, zero, zero,
            m_13_13, m_13_14, m_13_15, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_H_2_3, x_H_2_4, x_H_2_5, zero, zero, zero, zero, zero, m_14_9, zero, zero, zero,
            x_F_in_H_1_6, m_14_14, m_14_15, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_15_1, m_15_2, x_F_in_H_3_4, zero, zero, zero, zero, m_15_8, zero, m_15_10, zero, zero,
            m_15_13, x_S_in_F_2_4, m_15_15, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_H_1_6, m_16_2, m_16_3, zero, zero, zero, zero, zero, x_F_in_H_1_8, zero, m_16_11,
            m_16_12, x_F_in_H_1_9, x_F_in_H_1_10, m_16_15, m_16_16, m_16_17, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            x_H_2_6, m_17_2, m_17_3, zero, zero, zero, zero, m_17_8, zero, m_17_10, zero, zero,
            x_S_in_F_2_5, x_S_in_F_2_6, x_S_in_F_2_7, m_17_16, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            x_H_3_6, m_18_2, m_18_3, zero, zero, zero, zero, zero, x_F_in_H_3_7, zero, m_18_11,
            m_18_12, x_F_in_H_3_8, x_F_in_H_3_9, m_18_15, x_S_in_F_2_4, m_18_17, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            x_F_1_7, m_19_2, m_19_3, zero, zero, m_19_6, m_19_7, m_19_8, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_19_24,
        ],
        [
            x_F_2_6, m_20_2, m_20_3, zero, zero, x_S_in_F_2_8, m_20_7, zero, m_20_9, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_20_24,
        ],
        [
            m_21_1, x_F_3_8, x_F_3_9, zero, zero, m_21_6, x_B_in_S_3_6, zero, zero, m_21_10, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_21_24,
        ],
        [
            m_22_1, x_F_1_11, x_F_1_12, zero, zero, x_S_in_F_1_10, m_22_7, zero, zero, zero,
            m_22_11, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_22_24,
        ],
        [
            x_F_2_9, x_F_2_10, x_F_2_11, zero, zero, m_23_6, x_S_in_F_2_12, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, x_S_in_F_2_13,
        ],
        [
            x_F_3_10, m_24_2, m_24_3, zero, zero, m_24_6, x_B_in_S_3_9, zero, zero, zero, zero,
            m_24_12, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            x_B_in_S_3_10,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', rear_wheel_force_y1, rear_wheel_force_y2, front_wheel_force_y1, front_wheel_force_y2, front_wheel_force_f1, front_wheel_force_f2, front_wheel_force_f3, front_wheel_torque_f1, front_wheel_torque_f3, fork_force_b1, fork_force_b2, fork_force_b3, fork_torque_b2, fork_torque_f1, frame_force_rw1, frame_force_rw2, frame_force_rw3, frame_torque_rw1, frame_torque_rw3, rear_wheel_force_n3, front_wheel_force_n3).
///
/// 1009 operations, 8 sines and cosines, 2 other functions.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 8], u: &[S; 3]) -> [S; 24] {
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
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
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
    let w_Y_in_L_3_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_3 = w_Y_in_L_3_of_u1_u2_u3 * cos_phi;
    let ratio_theta_u1_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let ratio_theta_u1_2_of_u1_u2_2 = ratio_theta_u1_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2_2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = (-ratio_theta_u1_of_place_10)
        .mul_add(ratio_theta_u1_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_4 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_5 = ratio_theta_u1_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_3 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_4;
    let ratio_theta_u1_2_of_u1_u2_6 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_3 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_8 = -ratio_theta_u1_2_of_u1_u2_6 - ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_9 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_5,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_8,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_9,
            ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = ratio_theta_u1_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_8;
    let ratio_psi_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_10);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2_2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2_2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place_9)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_9 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_12 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_9)
        .mul_add(cos_delta, -ratio_theta_u1_of_place_9 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_11 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_12 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_11, ratio_theta_u1_2_of_u1_u2_10);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_12
        .mul_add(sin_delta, ratio_theta_u1_of_place_12 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_2_of_u1_u2_12 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_12)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_13);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_6)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_14 = ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_15 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_6 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_14 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_16 = -ratio_theta_u1_2_of_u1_u2_9;
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_8
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_17;
    let ratio_theta_u1_2_of_u1_u2_19 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_u1_u2_5, ratio_theta_u1_2_of_u1_u2_18);
    let ratio_theta_u1_2_of_u1_u2_20 = (ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2)
        .mul_add(sin_phi, u1 * ratio_theta_u1_of_place_4) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_21 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_22 = (-u1)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_u1_u2_2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_23 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_17;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_14, u1 * ratio_psi_u1_of_place_17);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_11 * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_23
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_3
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_21
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_u1_u2_25)
                .mul_add(S::int(2), ratio_theta_u1_of_place_10 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_2_of_u1_u2_16
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_26);
    let ratio_theta_u1_2_of_u1_u2_28 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_3
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_30 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_12
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_11)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_24 * u2_cos_delta)
                - ratio_theta_u1_2_of_u1_u2_13
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_19
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_25)
        + ratio_theta_u1_of_place_10
            * ratio_theta_u1_of_place_13
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_theta_u1_2_of_u1_u2_29 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_12
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_16
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_15,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_21,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_19
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_20)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_21
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_22
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_11, ratio_theta_u1_2_of_u1_u2_23,
                        )) + ratio_theta_u1_2_of_u1_u2_24;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_28, ratio_theta_u1_2_of_u1_u2_29);
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
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_20
        - ratio_psi_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_22;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_18, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_3
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2_2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_13 * u1_sin_phi
        + ratio_psi_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_4
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2_2
                + ratio_psi_u1_of_place_12 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_16
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_20
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_20);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_8
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_5
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_16
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_5))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_21,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_8
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_18);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_28, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_13)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_10)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_16,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_18,
        ) - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_16 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_20 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let w_L_13 = u1 * w_Y_in_L_3;
    let alpha_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2_2, u1 * ratio_psi_u1_2)
        + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2 = alpha_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let alpha_L_2 = w_L_13 + alpha_Y_in_L_2;
    let turn_L_13 = w_L_13 + alpha_L_2;
    let a_RC_1 = rR * turn_L_13;
    let x_L_1 = mR * a_RC_1;
    let w_Y_in_L_2 = w_Y_in_L_3_of_u1_u2_u3 * sin_phi;
    let w_L_23 = w_Y_in_L_3 * w_Y_in_L_2;
    let a_N_in_Y_2 = rR * u3 * w_Y_in_L_3_of_u1_u2_u3 * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let a_Y_in_L_2 = (-a_N_in_Y_2).mul_add(cos_phi, g * sin_phi);
    let a_RC_2 = rR.mul_add(w_L_23, a_Y_in_L_2);
    let x_L_2 = mR * a_RC_2;
    let w_L_11 = u1 * u1;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let turn_L_33 = w_L_11 + w_L_22;
    let a_Y_in_L_3 = a_N_in_Y_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_3 = rR.mul_add(turn_L_33, -a_Y_in_L_3);
    let x_L_3 = mR * a_RC_3;
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let x_L_1_2 = w_Y_in_L_3 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_3
        + IRxx * (-w_Y_in_L_3).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_in_L_1);
    let H_rear_wheel_1 = IRxx * u1;
    let x_L_2_2 = (-u1).mul_add(H_rear_wheel_3, IRyy * alpha_L_2) + w_Y_in_L_3 * H_rear_wheel_1;
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let alpha_Y_in_L_3 = alpha_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let alpha_L_3 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3);
    let alpha_RW_3 = alpha_RW_in_L_3 + alpha_L_3;
    let x_L_3_2 = u1 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_1
        + IRxx * (-u1).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_3);
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-w_Y_in_L_3).mul_add(cos_theta, u1 * sin_theta);
    let w_B_2 = ratio_theta_u1_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let alpha_B_2 = u1.mul_add(ratio_theta_u1_2, -alpha_L_2) + u2 * ratio_theta_u2_2;
    let turn_B_13 = w_B_13 + alpha_B_2;
    let a_L_in_B_1 = (-a_RC_1).mul_add(cos_theta, a_RC_3 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1 = xB.mul_add(turn_B_11, a_L_in_B_1) - turn_B_13 * rr_plus_zb;
    let x_B_1 = mB * a_Bo_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let alpha_L_in_B_1 = alpha_L_3 * sin_theta;
    let alpha_L_in_B_3 = alpha_L_3 * cos_theta;
    let alpha_B_1 = w_L_in_B_3.mul_add(ratio_theta_u1_2_of_u1_u2, alpha_L_in_B_1);
    let alpha_B_3 = w_L_in_B_1.mul_add(ratio_theta_u1_2_of_u1_u2, alpha_L_in_B_3);
    let turn_B_21 = w_B_12 + alpha_B_3;
    let turn_B_23 = w_B_23 + alpha_B_1;
    let a_Bo_2 = (-xB).mul_add(turn_B_21, a_RC_2) - turn_B_23 * rr_plus_zb;
    let x_B_2 = mB * a_Bo_2;
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let turn_B_33 = w_B_22 + w_B_11;
    let turn_B_31 = w_B_13 - alpha_B_2;
    let a_L_in_B_3 = a_RC_3.mul_add(cos_theta, a_RC_1 * sin_theta);
    let a_Bo_3 = (-xB).mul_add(turn_B_31, turn_B_33 * rr_plus_zb) - a_L_in_B_3;
    let x_B_3 = mB * a_Bo_3;
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let x_B_1_2 = (-IBxx).mul_add(alpha_B_1, IBxz * alpha_B_3) - w_L_in_B_3 * H_frame_2
        + w_B_2 * H_frame_3;
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let x_B_2_2 = (-w_L_in_B_1).mul_add(H_frame_3, IByy * alpha_B_2) + w_L_in_B_3 * H_frame_1;
    let x_B_3_2 = (-IBxz).mul_add(alpha_B_1, IBzz * alpha_B_3) + w_L_in_B_1 * H_frame_2
        - w_B_2 * H_frame_1;
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1 = (-w_B_2).mul_add(sin_delta, w_B_in_S_1 * cos_delta);
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = u2 + w_B_in_S_3;
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_33 = w_F_11 + w_F_22;
    let alpha_B_in_S_1 = alpha_B_3.mul_add(sin_lam, alpha_B_1 * cos_lam);
    let alpha_B_in_S_3 = (-alpha_B_1).mul_add(sin_lam, alpha_B_3 * cos_lam);
    let turn_S_21 = w_S_12 - alpha_B_in_S_3;
    let turn_S_31 = alpha_B_2 + w_S_13;
    let alpha_S_in_F_2 = alpha_B_in_S_1.mul_add(sin_delta, alpha_B_2 * cos_delta);
    let alpha_F_2 = u2.mul_add(w_S_in_F_1, alpha_S_in_F_2);
    let turn_F_13 = w_F_13 - alpha_F_2;
    let turn_F_31 = w_F_13 + alpha_F_2;
    let a_B_in_S_1 = a_L_in_B_3.mul_add(sin_lam, a_L_in_B_1 * cos_lam);
    let a_B_in_S_3 = (-a_L_in_B_1).mul_add(sin_lam, a_L_in_B_3 * cos_lam);
    let a_Ho_1 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1);
    let a_Ho_2 = turn_S_21.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_RC_2);
    let a_Ho_3 = turn_S_31.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3);
    let a_S_in_F_1 = a_Ho_2.mul_add(sin_delta, a_Ho_1 * cos_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_2_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let a_Ho_1_2_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_2 = turn_F_11.mul_add(a_Ho_1_2_of_place, -a_S_in_F_1)
        - turn_F_13 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_3_2 = (-turn_F_31).mul_add(a_Ho_1_2_of_place, a_Ho_3)
        + turn_F_33 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_1 = mH * a_Ho_1_2;
    let x_H_3 = mH * a_Ho_3_2;
    let x_F_in_H_1 = (-x_H_1).mul_add(cos_lam, x_H_3 * sin_lam);
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let alpha_S_in_F_1 = (-alpha_B_2).mul_add(sin_delta, alpha_B_in_S_1 * cos_delta);
    let alpha_F_1 = u2.mul_add(w_S_in_F_2, -alpha_S_in_F_1);
    let turn_F_21 = w_F_12 - alpha_B_in_S_3;
    let turn_F_23 = w_F_23 - alpha_F_1;
    let a_S_in_F_2 = (-a_Ho_2).mul_add(cos_delta, a_Ho_1 * sin_delta);
    let a_Ho_2_2 = turn_F_21.mul_add(a_Ho_1_2_of_place, a_S_in_F_2)
        + turn_F_23 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_2 = mH * a_Ho_2_2;
    let x_F_in_H_3 = x_H_3.mul_add(cos_lam, x_H_1 * sin_lam);
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let alpha_F_in_H_1 = alpha_F_1.mul_add(cos_lam, alpha_B_in_S_3 * sin_lam);
    let alpha_F_in_H_3 = (-alpha_F_1).mul_add(sin_lam, alpha_B_in_S_3 * cos_lam);
    let x_H_1_2 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        + IHxx * alpha_F_in_H_1 + IHxz * alpha_F_in_H_3;
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let x_H_2_2 = (-w_F_in_H_1).mul_add(H_fork_3, IHyy * alpha_F_2) + w_F_in_H_3 * H_fork_1;
    let x_H_3_2 = IHxz.mul_add(alpha_F_in_H_1, w_F_in_H_1 * H_fork_2)
        + IHzz * alpha_F_in_H_3 - w_S_in_F_2 * H_fork_1;
    let a_FC_1 = turn_F_11.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_1)
        + turn_F_13 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_1 = mF * a_FC_1;
    let a_FC_2 = (-turn_F_21).mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_2)
        + turn_F_23 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2 = mF * a_FC_2;
    let a_FC_3 = turn_F_31.mul_add(ratio_theta_u1_of_c_lam_rf, a_Ho_3)
        + turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_3 = mF * a_FC_3;
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
    let w_F_in_FW_1 = w_F_3.mul_add(sin_thF, w_S_in_F_1 * cos_thF);
    let w_F_in_FW_3 = (-w_S_in_F_1).mul_add(sin_thF, w_F_3 * cos_thF);
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 + w_FW_in_F_2;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_1 = alpha_FW_in_F_1 - alpha_F_1;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let x_F_1_2 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - IFxx * w_F_3.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1);
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_6;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_theta_u1_2_of_u1_u2_7 * ratio_thF_u1_of_place
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_u1_u2_7 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_theta_u1_of_place_9)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_8,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_9,
            )
        - ratio_psi_u1_of_place
            * ratio_theta_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_5,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_12,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_8,
                ) + ratio_theta_u1_2_of_u1_u2_24
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_of_place_12
        - ratio_psi_u1_2_of_u1_u2 * ratio_thF_u1_of_place_13
        + ratio_psi_u1_2_of_u1_u2_8 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_8,
                ) + S::int(2) * ratio_theta_u1_of_place_4 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_u1_u2_7 = S::int(2) * ratio_psi_u1_2_of_u1_u2_3;
    let ratio_thF_u1_2_of_u1_u2_8 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_psi_u1_2_of_u1_u2_6 * ratio_thF_u1_of_place_7
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_thF_u1_2_of_u1_u2_7;
    let ratio_thF_u1_2_of_u1_u2_9 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_8);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_2_of_u1_u2_9,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_9,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = cos_lam_plus_theta
        * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6)
        + ratio_psi_u1_2_of_u1_u2_6 * ratio_thF_u3_of_place
        + ratio_thF_u3_of_w_lam_rr_rf * ratio_thF_u1_2_of_u1_u2_7;
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let alpha_FW_in_F_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2) + u3 * ratio_thF_u3_2;
    let alpha_FW_2 = alpha_F_2.mul_add(S::int(2), alpha_FW_in_F_2);
    let x_F_2_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let x_F_2_2 = (-x_F_2_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2);
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_FW_3 = alpha_FW_in_F_3 - alpha_B_in_S_3;
    let x_F_3_2 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_3);
    // Values.
    let f_1 = -x_L_1;
    let f_3 = -x_L_3;
    let f_4 = -x_L_1_2;
    let f_6 = -x_L_3_2;
    let f_10 = -x_B_1_2;
    let f_11 = -x_B_2_2;
    let f_12 = -x_B_3_2;
    let f_14 = -x_H_2;
    let f_16 = -x_H_1_2;
    let f_17 = -x_H_2_2;
    let f_18 = -x_H_3_2;
    let f_20 = -x_F_2;
    let f_22 = -x_F_1_2;
    let f_23 = S::ratio(1, 2) * x_F_2_2;
    [
        f_1, x_L_2, f_3, f_4, x_L_2_2, f_6, x_B_1, x_B_2, x_B_3, f_10, f_11, f_12, x_F_in_H_1, f_14,
        x_F_in_H_3, f_16, f_17, f_18, x_F_1, f_20, x_F_3, f_22, f_23, x_F_3_2,
    ]
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 1811 operations, 8 sines and cosines, 2 other functions.
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
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
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
    let w_Y_in_L_3_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_3 = w_Y_in_L_3_of_u1_u2_u3 * cos_phi;
    let ratio_theta_u1_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let ratio_theta_u1_2_of_u1_u2_2 = ratio_theta_u1_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2_2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = (-ratio_theta_u1_of_place_10)
        .mul_add(ratio_theta_u1_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_4 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_5 = ratio_theta_u1_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_3 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_4;
    let ratio_theta_u1_2_of_u1_u2_6 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_3 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_8 = -ratio_theta_u1_2_of_u1_u2_6 - ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_9 = (-ratio_theta_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_5,
            ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_8,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_9,
            ratio_theta_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = ratio_theta_u1_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_20;
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_8;
    let ratio_psi_u1_2_of_u1_u2_4 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_10);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2_2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2_2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_theta_u1_of_place_9)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_9 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_12 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_25 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + ratio_theta_u1_of_place_11
            * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_9)
        .mul_add(cos_delta, -ratio_theta_u1_of_place_9 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_11 = ratio_theta_u1_of_place
        .mul_add(ratio_theta_u1_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_12 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_11, ratio_theta_u1_2_of_u1_u2_10);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_12
        .mul_add(sin_delta, ratio_theta_u1_of_place_12 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_2_of_u1_u2_12 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_12)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_13);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_6)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_7 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_9 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_14 = ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_15 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_6 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_14 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_16 = -ratio_theta_u1_2_of_u1_u2_9;
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_8
        * (-(ratio_theta_u1_of_place_5 * ratio_theta_u1_of_place_6))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_17;
    let ratio_theta_u1_2_of_u1_u2_19 = ratio_theta_u1_of_place_17
        .mul_add(ratio_theta_u1_2_of_u1_u2_5, ratio_theta_u1_2_of_u1_u2_18);
    let ratio_theta_u1_2_of_u1_u2_20 = (ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2)
        .mul_add(sin_phi, u1 * ratio_theta_u1_of_place_4) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_21 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_22 = (-u1)
        .mul_add(ratio_theta_u1_of_place_10, ratio_theta_u1_2_of_u1_u2_2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_23 = ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_17;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_14, u1 * ratio_psi_u1_of_place_17);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_11 * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_23
        - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_3
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_21
        + ratio_theta_u1_of_place_21
            * (-ratio_theta_u1_2_of_u1_u2_25)
                .mul_add(S::int(2), ratio_theta_u1_of_place_10 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_2_of_u1_u2_16
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_26);
    let ratio_theta_u1_2_of_u1_u2_28 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_3
        + ratio_theta_u1_of_place_26 * ratio_theta_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_30 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_12
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_11)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_24 * u2_cos_delta)
                - ratio_theta_u1_2_of_u1_u2_13
                + ratio_theta_u1_of_place_27 * ratio_theta_u1_2_of_u1_u2_19
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_25)
        + ratio_theta_u1_of_place_10
            * ratio_theta_u1_of_place_13
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_theta_u1_2_of_u1_u2_29 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_19 * ratio_theta_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_22 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_12
        - ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_16
        + ratio_theta_u1_of_place_2
            * ((-ratio_theta_u1_of_place_8)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_15,
                    ratio_theta_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_21,
                ) - ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_19
                - ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_20)
        + ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1_of_place_10
            * (ratio_theta_u1_of_place_21 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_21
                + ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_22
                + ratio_theta_u1_of_place_15
                    * (-ratio_theta_u1_of_place_17)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_11, ratio_theta_u1_2_of_u1_u2_23,
                        )) + ratio_theta_u1_2_of_u1_u2_24;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_28, ratio_theta_u1_2_of_u1_u2_29);
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
        - ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_20
        - ratio_psi_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_22;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_18, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_3
        + ratio_theta_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_14 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_psi_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20
        - ratio_psi_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2_2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_13 * u1_sin_phi
        + ratio_psi_u1_of_place_14 * ratio_theta_u1_2_of_u1_u2_4
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_theta_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2_2
                + ratio_psi_u1_of_place_12 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_16
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_15
        * ratio_psi_u1_of_place_20
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_20);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_16)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_19 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_8
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_5
        + S::int(2) * ratio_theta_u1_of_place_24 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_16
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u1_of_place_2
            * ((-(ratio_theta_u1_of_place_18 * ratio_theta_u1_2_of_u1_u2_5))
                .mul_add(
                    S::int(2),
                    ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_21,
                ) - ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_8
                - ratio_theta_u1_of_place_2 * ratio_theta_u1_2_of_u1_u2_18);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_31
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_28, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_13)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_10)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_15
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_16,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_18,
        ) - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_16 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_20 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let w_L_13 = u1 * w_Y_in_L_3;
    let alpha_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2_2, u1 * ratio_psi_u1_2)
        + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2 = alpha_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let alpha_L_2 = w_L_13 + alpha_Y_in_L_2;
    let turn_L_13 = w_L_13 + alpha_L_2;
    let a_RC_1 = rR * turn_L_13;
    let x_L_1 = mR * a_RC_1;
    let w_Y_in_L_2 = w_Y_in_L_3_of_u1_u2_u3 * sin_phi;
    let w_L_23 = w_Y_in_L_3 * w_Y_in_L_2;
    let x_N_in_Y_1 = rR * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let a_N_in_Y_2 = u3 * x_N_in_Y_1 * w_Y_in_L_3_of_u1_u2_u3;
    let a_Y_in_L_2 = (-a_N_in_Y_2).mul_add(cos_phi, g * sin_phi);
    let a_RC_2 = rR.mul_add(w_L_23, a_Y_in_L_2);
    let x_L_2 = mR * a_RC_2;
    let w_L_11 = u1 * u1;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let turn_L_33 = w_L_11 + w_L_22;
    let a_Y_in_L_3 = a_N_in_Y_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_3 = rR.mul_add(turn_L_33, -a_Y_in_L_3);
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let x_L_1_2 = w_Y_in_L_3 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_3
        + IRxx * (-w_Y_in_L_3).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_in_L_1);
    let H_rear_wheel_1 = IRxx * u1;
    let x_L_2_2 = (-u1).mul_add(H_rear_wheel_3, IRyy * alpha_L_2) + w_Y_in_L_3 * H_rear_wheel_1;
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let alpha_Y_in_L_3 = alpha_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let alpha_L_3 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3);
    let alpha_RW_3 = alpha_RW_in_L_3 + alpha_L_3;
    let x_L_3_2 = u1 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_1
        + IRxx * (-u1).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_3);
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-w_Y_in_L_3).mul_add(cos_theta, u1 * sin_theta);
    let w_B_2 = ratio_theta_u1_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let alpha_B_2 = u1.mul_add(ratio_theta_u1_2, -alpha_L_2) + u2 * ratio_theta_u2_2;
    let turn_B_13 = w_B_13 + alpha_B_2;
    let a_L_in_B_1 = (-a_RC_1).mul_add(cos_theta, a_RC_3 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1 = xB.mul_add(turn_B_11, a_L_in_B_1) - turn_B_13 * rr_plus_zb;
    let x_B_1 = mB * a_Bo_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let alpha_L_in_B_1 = alpha_L_3 * sin_theta;
    let alpha_L_in_B_3 = alpha_L_3 * cos_theta;
    let alpha_B_1 = w_L_in_B_3.mul_add(ratio_theta_u1_2_of_u1_u2, alpha_L_in_B_1);
    let alpha_B_3 = w_L_in_B_1.mul_add(ratio_theta_u1_2_of_u1_u2, alpha_L_in_B_3);
    let turn_B_21 = w_B_12 + alpha_B_3;
    let turn_B_23 = w_B_23 + alpha_B_1;
    let a_Bo_2 = (-xB).mul_add(turn_B_21, a_RC_2) - turn_B_23 * rr_plus_zb;
    let x_B_2 = mB * a_Bo_2;
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let turn_B_33 = w_B_22 + w_B_11;
    let turn_B_31 = w_B_13 - alpha_B_2;
    let a_L_in_B_3 = a_RC_3.mul_add(cos_theta, a_RC_1 * sin_theta);
    let a_Bo_3 = (-xB).mul_add(turn_B_31, turn_B_33 * rr_plus_zb) - a_L_in_B_3;
    let x_B_3 = mB * a_Bo_3;
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let x_B_1_2 = (-IBxx).mul_add(alpha_B_1, IBxz * alpha_B_3) - w_L_in_B_3 * H_frame_2
        + w_B_2 * H_frame_3;
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let x_B_2_2 = (-w_L_in_B_1).mul_add(H_frame_3, IByy * alpha_B_2) + w_L_in_B_3 * H_frame_1;
    let x_B_3_2 = (-IBxz).mul_add(alpha_B_1, IBzz * alpha_B_3) + w_L_in_B_1 * H_frame_2
        - w_B_2 * H_frame_1;
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1 = (-w_B_2).mul_add(sin_delta, w_B_in_S_1 * cos_delta);
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = u2 + w_B_in_S_3;
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_33 = w_F_11 + w_F_22;
    let alpha_B_in_S_1 = alpha_B_3.mul_add(sin_lam, alpha_B_1 * cos_lam);
    let alpha_B_in_S_3 = (-alpha_B_1).mul_add(sin_lam, alpha_B_3 * cos_lam);
    let turn_S_21 = w_S_12 - alpha_B_in_S_3;
    let turn_S_31 = alpha_B_2 + w_S_13;
    let alpha_S_in_F_2 = alpha_B_in_S_1.mul_add(sin_delta, alpha_B_2 * cos_delta);
    let alpha_F_2 = u2.mul_add(w_S_in_F_1, alpha_S_in_F_2);
    let turn_F_13 = w_F_13 - alpha_F_2;
    let turn_F_31 = w_F_13 + alpha_F_2;
    let a_B_in_S_1 = a_L_in_B_3.mul_add(sin_lam, a_L_in_B_1 * cos_lam);
    let a_B_in_S_3 = (-a_L_in_B_1).mul_add(sin_lam, a_L_in_B_3 * cos_lam);
    let a_Ho_1 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1);
    let a_Ho_2 = turn_S_21.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_RC_2);
    let a_Ho_3 = turn_S_31.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3);
    let a_S_in_F_1 = a_Ho_2.mul_add(sin_delta, a_Ho_1 * cos_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_2_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let a_Ho_1_2_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_2 = turn_F_11.mul_add(a_Ho_1_2_of_place, -a_S_in_F_1)
        - turn_F_13 * a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_3_2 = (-turn_F_31).mul_add(a_Ho_1_2_of_place, a_Ho_3)
        + turn_F_33 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_1 = mH * a_Ho_1_2;
    let x_H_3 = mH * a_Ho_3_2;
    let x_F_in_H_1 = (-x_H_1).mul_add(cos_lam, x_H_3 * sin_lam);
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let alpha_S_in_F_1 = (-alpha_B_2).mul_add(sin_delta, alpha_B_in_S_1 * cos_delta);
    let alpha_F_1 = u2.mul_add(w_S_in_F_2, -alpha_S_in_F_1);
    let turn_F_21 = w_F_12 - alpha_B_in_S_3;
    let turn_F_23 = w_F_23 - alpha_F_1;
    let a_S_in_F_2 = (-a_Ho_2).mul_add(cos_delta, a_Ho_1 * sin_delta);
    let a_Ho_2_2 = turn_F_21.mul_add(a_Ho_1_2_of_place, a_S_in_F_2)
        + turn_F_23 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_2 = mH * a_Ho_2_2;
    let x_F_in_H_3 = x_H_3.mul_add(cos_lam, x_H_1 * sin_lam);
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let alpha_F_in_H_1 = alpha_F_1.mul_add(cos_lam, alpha_B_in_S_3 * sin_lam);
    let alpha_F_in_H_3 = (-alpha_F_1).mul_add(sin_lam, alpha_B_in_S_3 * cos_lam);
    let x_H_1_2 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        + IHxx * alpha_F_in_H_1 + IHxz * alpha_F_in_H_3;
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let x_H_2_2 = (-w_F_in_H_1).mul_add(H_fork_3, IHyy * alpha_F_2) + w_F_in_H_3 * H_fork_1;
    let x_H_3_2 = IHxz.mul_add(alpha_F_in_H_1, w_F_in_H_1 * H_fork_2)
        + IHzz * alpha_F_in_H_3 - w_S_in_F_2 * H_fork_1;
    let a_FC_1 = turn_F_11.mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_1)
        + turn_F_13 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_1 = mF * a_FC_1;
    let a_FC_2 = (-turn_F_21).mul_add(ratio_theta_u1_of_c_lam_rf, a_S_in_F_2)
        + turn_F_23 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2 = mF * a_FC_2;
    let a_FC_3 = turn_F_31.mul_add(ratio_theta_u1_of_c_lam_rf, a_Ho_3)
        + turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_3 = mF * a_FC_3;
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
    let w_F_in_FW_1 = w_F_3.mul_add(sin_thF, w_S_in_F_1 * cos_thF);
    let w_F_in_FW_3 = (-w_S_in_F_1).mul_add(sin_thF, w_F_3 * cos_thF);
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 + w_FW_in_F_2;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_1 = alpha_FW_in_F_1 - alpha_F_1;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let x_F_1_2 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - IFxx * w_F_3.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1);
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_6;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_theta_u1_2_of_u1_u2_7 * ratio_thF_u1_of_place
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - ratio_theta_u1_of_place_3 * (ratio_theta_u1_2_of_u1_u2_7 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_15 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_theta_u1_of_place_9)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_8,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_9,
            )
        - ratio_psi_u1_of_place
            * ratio_theta_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_5,
                )
        - ratio_psi_u1_of_place_3
            * ratio_theta_u1_of_place_4
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_12,
                    ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_8,
                ) + ratio_theta_u1_2_of_u1_u2_24
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_of_place_12
        - ratio_psi_u1_2_of_u1_u2 * ratio_thF_u1_of_place_13
        + ratio_psi_u1_2_of_u1_u2_8 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_8,
                ) + S::int(2) * ratio_theta_u1_of_place_4 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_u1_u2_7 = S::int(2) * ratio_psi_u1_2_of_u1_u2_3;
    let ratio_thF_u1_2_of_u1_u2_8 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_psi_u1_2_of_u1_u2_6 * ratio_thF_u1_of_place_7
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_thF_u1_2_of_u1_u2_7;
    let ratio_thF_u1_2_of_u1_u2_9 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_8);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_19)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_11 * ratio_thF_u1_2_of_u1_u2_9,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_9,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = cos_lam_plus_theta
        * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6)
        + ratio_psi_u1_2_of_u1_u2_6 * ratio_thF_u3_of_place
        + ratio_thF_u3_of_w_lam_rr_rf * ratio_thF_u1_2_of_u1_u2_7;
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let alpha_FW_in_F_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2) + u3 * ratio_thF_u3_2;
    let alpha_FW_2 = alpha_F_2.mul_add(S::int(2), alpha_FW_in_F_2);
    let x_F_2_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let x_F_2_2 = (-x_F_2_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2);
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_FW_3 = alpha_FW_in_F_3 - alpha_B_in_S_3;
    let x_F_3_2 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_3);
    let w_Y_in_L_2_2 = ratio_psi_u1 * sin_phi;
    let x_F_1_3 = rR * w_Y_in_L_2_2;
    let x_L_1_3 = mR * x_F_1_3;
    let w_Y_in_L_2_3 = ratio_psi_u2 * sin_phi;
    let x_F_1_4 = rR * w_Y_in_L_2_3;
    let x_L_1_4 = mR * x_F_1_4;
    let w_Y_in_L_2_4 = ratio_psi_u3 * sin_phi;
    let x_F_1_5 = rR.mul_add(w_Y_in_L_2_4, -x_N_in_Y_1);
    let x_L_1_5 = mR * x_F_1_5;
    let x_L_2_3 = rR * mR;
    let x_L_2_4 = IRyy * w_Y_in_L_2_2;
    let x_L_2_5 = IRyy * w_Y_in_L_2_3;
    let w_RW_2_2 = w_Y_in_L_2_4 - S::int(1);
    let x_L_2_6 = IRyy * w_RW_2_2;
    let w_Y_in_L_3_2 = ratio_psi_u1 * cos_phi;
    let x_L_3_3 = IRxx * w_Y_in_L_3_2;
    let w_Y_in_L_3_3 = ratio_psi_u2 * cos_phi;
    let x_L_3_4 = IRxx * w_Y_in_L_3_3;
    let w_Y_in_L_3_4 = ratio_psi_u3 * cos_phi;
    let x_L_3_5 = IRxx * w_Y_in_L_3_4;
    let w_B_2_2 = ratio_theta_u1 - w_Y_in_L_2_2;
    let x_L_in_B_1 = x_F_1_3 * cos_theta;
    let a_Bo_1_2 = w_B_2_2.mul_add(rr_plus_zb, x_L_in_B_1);
    let x_B_1_3 = mB * a_Bo_1_2;
    let w_B_2_3 = ratio_theta_u2 - w_Y_in_L_2_3;
    let x_L_in_B_1_2 = x_F_1_4 * cos_theta;
    let a_Bo_1_3 = w_B_2_3.mul_add(rr_plus_zb, x_L_in_B_1_2);
    let x_B_1_4 = mB * a_Bo_1_3;
    let x_L_in_B_1_3 = x_F_1_5 * cos_theta;
    let a_Bo_1_4 = (-w_Y_in_L_2_4).mul_add(rr_plus_zb, x_L_in_B_1_3);
    let x_B_1_5 = mB * a_Bo_1_4;
    let w_L_in_B_1_2 = w_Y_in_L_3_2.mul_add(sin_theta, cos_theta);
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, sin_theta);
    let a_Bo_2_2 = xB.mul_add(w_L_in_B_3_2, rR) - w_L_in_B_1_2 * rr_plus_zb;
    let x_B_2_3 = mB * a_Bo_2_2;
    let w_L_in_B_1_3 = w_Y_in_L_3_3 * sin_theta;
    let w_L_in_B_3_3 = w_Y_in_L_3_3 * cos_theta;
    let a_Bo_2_3 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let x_B_2_4 = mB * a_Bo_2_3;
    let w_L_in_B_1_4 = w_Y_in_L_3_4 * sin_theta;
    let w_L_in_B_3_4 = w_Y_in_L_3_4 * cos_theta;
    let a_Bo_2_4 = w_L_in_B_1_4.mul_add(rr_plus_zb, xB * w_L_in_B_3_4);
    let x_B_2_5 = mB * a_Bo_2_4;
    let x_L_in_B_3 = x_F_1_3 * sin_theta;
    let a_Bo_3_2 = (-xB).mul_add(w_B_2_2, x_L_in_B_3);
    let x_B_3_3 = mB * a_Bo_3_2;
    let x_L_in_B_3_2 = x_F_1_4 * sin_theta;
    let a_Bo_3_3 = (-xB).mul_add(w_B_2_3, x_L_in_B_3_2);
    let x_B_3_4 = mB * a_Bo_3_3;
    let x_L_in_B_3_3 = x_F_1_5 * sin_theta;
    let a_Bo_3_4 = xB.mul_add(w_Y_in_L_2_4, x_L_in_B_3_3);
    let x_B_3_5 = mB * a_Bo_3_4;
    let x_B_1_6 = IBxz.mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let x_B_1_7 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let x_B_1_8 = (-IBxz).mul_add(w_L_in_B_3_4, IBxx * w_L_in_B_1_4);
    let x_B_2_6 = IByy * w_B_2_2;
    let x_B_2_7 = IByy * w_B_2_3;
    let x_B_2_8 = IByy * w_Y_in_L_2_4;
    let x_B_3_7 = IBzz.mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let x_B_3_8 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let x_B_3_9 = (-IBzz).mul_add(w_L_in_B_3_4, IBxz * w_L_in_B_1_4);
    let w_B_in_S_1_2 = (-w_L_in_B_1_2).mul_add(cos_lam, w_L_in_B_3_2 * sin_lam);
    let w_B_in_S_3_2 = w_L_in_B_3_2.mul_add(cos_lam, w_L_in_B_1_2 * sin_lam);
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_B_2_2 * cos_delta);
    let x_B_in_S_1 = (-x_L_in_B_1).mul_add(cos_lam, x_L_in_B_3 * sin_lam);
    let x_B_in_S_3 = x_L_in_B_3.mul_add(cos_lam, x_L_in_B_1 * sin_lam);
    let x_F_2_3 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, rR);
    let x_F_3_3 = w_B_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3);
    let x_S_in_F_1 = (-x_F_2_3).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let a_Ho_1_3 = (-w_S_in_F_2_2).mul_add(a_Ho_1_2_of_lam_rr_xh_zh, x_S_in_F_1);
    let a_Ho_3_3 = (-w_S_in_F_2_2).mul_add(a_Ho_1_2_of_place, x_F_3_3);
    let x_H_1_3 = mH * a_Ho_1_3;
    let x_H_3_3 = mH * a_Ho_3_3;
    let x_F_in_H_1_2 = x_H_3_3.mul_add(sin_lam, x_H_1_3 * cos_lam);
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_2_3 = (-w_B_2_3).mul_add(cos_delta, w_B_in_S_1_3 * sin_delta);
    let x_B_in_S_1_2 = (-x_L_in_B_1_2).mul_add(cos_lam, x_L_in_B_3_2 * sin_lam);
    let x_B_in_S_3_2 = x_L_in_B_3_2.mul_add(cos_lam, x_L_in_B_1_2 * sin_lam);
    let x_F_2_4 = w_B_in_S_3_3 * ratio_theta_u1_of_w_c_lam_rr;
    let x_F_3_4 = w_B_2_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3_2);
    let x_S_in_F_1_2 = x_F_2_4.mul_add(sin_delta, x_B_in_S_1_2 * cos_delta);
    let a_Ho_1_4 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, x_S_in_F_1_2);
    let a_Ho_3_4 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_place, x_F_3_4);
    let x_H_1_4 = mH * a_Ho_1_4;
    let x_H_3_4 = mH * a_Ho_3_4;
    let x_F_in_H_1_3 = x_H_3_4.mul_add(sin_lam, x_H_1_4 * cos_lam);
    let w_B_in_S_1_4 = w_L_in_B_3_4.mul_add(sin_lam, w_L_in_B_1_4 * cos_lam);
    let w_B_in_S_3_4 = (-w_L_in_B_1_4).mul_add(sin_lam, w_L_in_B_3_4 * cos_lam);
    let w_S_in_F_2_4 = w_B_in_S_1_4.mul_add(sin_delta, w_Y_in_L_2_4 * cos_delta);
    let x_B_in_S_1_3 = (-x_L_in_B_1_3).mul_add(cos_lam, x_L_in_B_3_3 * sin_lam);
    let x_B_in_S_3_3 = x_L_in_B_3_3.mul_add(cos_lam, x_L_in_B_1_3 * sin_lam);
    let x_F_2_5 = w_B_in_S_3_4 * ratio_theta_u1_of_w_c_lam_rr;
    let x_F_3_5 = w_Y_in_L_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, x_B_in_S_3_3);
    let x_S_in_F_1_3 = x_F_2_5.mul_add(sin_delta, x_B_in_S_1_3 * cos_delta);
    let a_Ho_1_5 = w_S_in_F_2_4.mul_add(a_Ho_1_2_of_lam_rr_xh_zh, x_S_in_F_1_3);
    let a_Ho_3_5 = (-w_S_in_F_2_4).mul_add(a_Ho_1_2_of_place, x_F_3_5);
    let x_H_1_5 = mH * a_Ho_1_5;
    let x_H_3_5 = mH * a_Ho_3_5;
    let x_F_in_H_1_4 = (-x_H_1_5).mul_add(cos_lam, x_H_3_5 * sin_lam);
    let w_S_in_F_1_2 = (-w_B_2_2).mul_add(sin_delta, w_B_in_S_1_2 * cos_delta);
    let x_S_in_F_2 = x_F_2_3.mul_add(cos_delta, x_B_in_S_1 * sin_delta);
    let a_Ho_2_3 = (-w_B_in_S_3_2).mul_add(a_Ho_1_2_of_place, x_S_in_F_2)
        + w_S_in_F_1_2 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_2_3 = mH * a_Ho_2_3;
    let w_S_in_F_1_3 = w_B_in_S_1_3.mul_add(cos_delta, w_B_2_3 * sin_delta);
    let w_F_3_2 = w_B_in_S_3_3 - S::int(1);
    let x_S_in_F_2_2 = (-x_F_2_4).mul_add(cos_delta, x_B_in_S_1_2 * sin_delta);
    let a_Ho_2_4 = w_F_3_2.mul_add(a_Ho_1_2_of_place, x_S_in_F_2_2)
        - w_S_in_F_1_3 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_2_4 = mH * a_Ho_2_4;
    let w_S_in_F_1_4 = (-w_Y_in_L_2_4).mul_add(sin_delta, w_B_in_S_1_4 * cos_delta);
    let x_S_in_F_2_3 = (-x_F_2_5).mul_add(cos_delta, x_B_in_S_1_3 * sin_delta);
    let a_Ho_2_5 = w_B_in_S_3_4.mul_add(a_Ho_1_2_of_place, x_S_in_F_2_3)
        - w_S_in_F_1_4 * a_Ho_1_2_of_lam_rr_xh_zh;
    let x_H_2_5 = mH * a_Ho_2_5;
    let x_F_in_H_3_2 = (-x_H_1_3).mul_add(sin_lam, x_H_3_3 * cos_lam);
    let x_F_in_H_3_3 = (-x_H_1_4).mul_add(sin_lam, x_H_3_4 * cos_lam);
    let x_F_in_H_3_4 = x_H_3_5.mul_add(cos_lam, x_H_1_5 * sin_lam);
    let alpha_F_in_H_1_2 = (-w_S_in_F_1_2).mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let alpha_F_in_H_3_2 = w_S_in_F_1_2.mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let x_H_1_6 = IHxz.mul_add(alpha_F_in_H_3_2, IHxx * alpha_F_in_H_1_2);
    let alpha_F_in_H_1_3 = (-w_S_in_F_1_3).mul_add(cos_lam, w_F_3_2 * sin_lam);
    let alpha_F_in_H_3_3 = w_F_3_2.mul_add(cos_lam, w_S_in_F_1_3 * sin_lam);
    let x_H_1_7 = IHxz.mul_add(alpha_F_in_H_3_3, IHxx * alpha_F_in_H_1_3);
    let alpha_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let alpha_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let x_H_1_8 = IHxz.mul_add(alpha_F_in_H_3_4, IHxx * alpha_F_in_H_1_4);
    let x_H_2_6 = IHyy * w_S_in_F_2_2;
    let x_H_2_7 = IHyy * w_S_in_F_2_3;
    let x_H_2_8 = IHyy * w_S_in_F_2_4;
    let x_H_3_6 = IHzz.mul_add(alpha_F_in_H_3_2, IHxz * alpha_F_in_H_1_2);
    let x_H_3_7 = IHzz.mul_add(alpha_F_in_H_3_3, IHxz * alpha_F_in_H_1_3);
    let x_H_3_8 = IHzz.mul_add(alpha_F_in_H_3_4, IHxz * alpha_F_in_H_1_4);
    let a_FC_1_2 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -x_S_in_F_1);
    let x_F_1_7 = mF * a_FC_1_2;
    let a_FC_1_3 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_w_lam_rr_rf, x_S_in_F_1_2);
    let x_F_1_8 = mF * a_FC_1_3;
    let a_FC_1_4 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_w_lam_rr_rf, x_S_in_F_1_3);
    let x_F_1_9 = mF * a_FC_1_4;
    let a_FC_2_2 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_c_lam_rf, x_S_in_F_2)
        + w_S_in_F_1_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_6 = mF * a_FC_2_2;
    let a_FC_2_3 = w_F_3_2.mul_add(ratio_theta_u1_of_c_lam_rf, -x_S_in_F_2_2)
        + w_S_in_F_1_3 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_7 = mF * a_FC_2_3;
    let a_FC_2_4 = w_B_in_S_3_4.mul_add(ratio_theta_u1_of_c_lam_rf, -x_S_in_F_2_3)
        + w_S_in_F_1_4 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_8 = mF * a_FC_2_4;
    let a_FC_3_2 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_c_lam_rf, x_F_3_3);
    let x_F_3_7 = mF * a_FC_3_2;
    let a_FC_3_3 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_c_lam_rf, -x_F_3_4);
    let x_F_3_8 = mF * a_FC_3_3;
    let a_FC_3_4 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_c_lam_rf, x_F_3_5);
    let x_F_3_9 = mF * a_FC_3_4;
    let x_F_1_10 = IFxx * w_S_in_F_1_2;
    let x_F_1_11 = IFxx * w_S_in_F_1_3;
    let x_F_1_12 = IFxx * w_S_in_F_1_4;
    let w_FW_2_2 = ratio_thF_u1 + w_S_in_F_2_2;
    let x_F_2_9 = IFyy * w_FW_2_2;
    let w_FW_2_3 = ratio_thF_u2 - w_S_in_F_2_3;
    let x_F_2_10 = IFyy * w_FW_2_3;
    let w_FW_2_4 = ratio_thF_u3 - w_S_in_F_2_4;
    let x_F_2_11 = IFyy * w_FW_2_4;
    let x_F_3_10 = IFxx * w_B_in_S_3_2;
    let x_F_3_11 = IFxx * w_F_3_2;
    let x_F_3_12 = IFxx * w_B_in_S_3_4;
    let x_F_in_H_1_12 = a_Ho_3_3.mul_add(sin_lam, a_Ho_1_3 * cos_lam);
    let x_F_in_H_3_11 = (-a_Ho_1_3).mul_add(sin_lam, a_Ho_3_3 * cos_lam);
    let x_F_in_H_1_13 = a_Ho_3_4.mul_add(sin_lam, a_Ho_1_4 * cos_lam);
    let x_F_in_H_3_12 = (-a_Ho_1_4).mul_add(sin_lam, a_Ho_3_4 * cos_lam);
    let x_F_in_H_1_14 = (-a_Ho_1_5).mul_add(cos_lam, a_Ho_3_5 * sin_lam);
    let x_F_in_H_3_13 = a_Ho_3_5.mul_add(cos_lam, a_Ho_1_5 * sin_lam);
    let d1 = w_Y_in_L_2_3.mul_add(x_L_2_5, x_F_1_4 * x_L_1_4) + w_Y_in_L_3_3 * x_L_3_4
        + a_Bo_1_3 * x_B_1_4 + a_Bo_2_3 * x_B_2_4 + a_Bo_3_3 * x_B_3_4
        + w_L_in_B_1_3 * x_B_1_7 + w_B_2_3 * x_B_2_7 - w_L_in_B_3_3 * x_B_3_8
        + a_Ho_2_4 * x_H_2_4 + alpha_F_in_H_1_3 * x_H_1_7 + w_S_in_F_2_3 * x_H_2_7
        + alpha_F_in_H_3_3 * x_H_3_7 + a_FC_1_3 * x_F_1_8 + a_FC_2_3 * x_F_2_7
        + a_FC_3_3 * x_F_3_8 + w_S_in_F_1_3 * x_F_1_11 + w_FW_2_3 * x_F_2_10
        + w_F_3_2 * x_F_3_11 + x_F_in_H_1_3 * x_F_in_H_1_13 + x_F_in_H_3_3 * x_F_in_H_3_12;
    let d1_inv = S::int(1) / d1;
    let l2 = d1_inv
        * (w_Y_in_L_2_2.mul_add(x_L_2_5, x_F_1_3 * x_L_1_4) + w_Y_in_L_3_2 * x_L_3_4
            + a_Bo_1_2 * x_B_1_4 - a_Bo_2_2 * x_B_2_4 + a_Bo_3_2 * x_B_3_4
            + w_L_in_B_1_2 * x_B_1_7 + w_B_2_2 * x_B_2_7 + w_L_in_B_3_2 * x_B_3_8
            + a_Ho_2_3 * x_H_2_4 - alpha_F_in_H_1_2 * x_H_1_7 - w_S_in_F_2_2 * x_H_2_7
            - alpha_F_in_H_3_2 * x_H_3_7 - a_FC_1_2 * x_F_1_8 - a_FC_2_2 * x_F_2_7
            - a_FC_3_2 * x_F_3_8 - w_S_in_F_1_2 * x_F_1_11 + w_FW_2_2 * x_F_2_10
            - w_B_in_S_3_2 * x_F_3_11 + x_F_in_H_1_3 * x_F_in_H_1_12
            + x_F_in_H_3_3 * x_F_in_H_3_11);
    let s3_of_place = w_Y_in_L_2_3.mul_add(x_L_2_4, x_L_1_3 * x_F_1_4)
        + x_L_3_3 * w_Y_in_L_3_3 + x_B_1_3 * a_Bo_1_3 - x_B_2_3 * a_Bo_2_3
        + x_B_3_3 * a_Bo_3_3 + w_L_in_B_1_3 * x_B_1_6 + w_B_2_3 * x_B_2_6
        - w_L_in_B_3_3 * x_B_3_7 + x_H_2_3 * a_Ho_2_4 - x_H_1_6 * alpha_F_in_H_1_3
        - w_S_in_F_2_3 * x_H_2_6 - alpha_F_in_H_3_3 * x_H_3_6 - x_F_1_7 * a_FC_1_3
        - x_F_2_6 * a_FC_2_3 - x_F_3_7 * a_FC_3_3 - w_S_in_F_1_3 * x_F_1_10
        + x_F_2_9 * w_FW_2_3 - w_F_3_2 * x_F_3_10 + x_F_in_H_1_2 * x_F_in_H_1_13
        + x_F_in_H_3_2 * x_F_in_H_3_12;
    let s3 = x_F_1_3.mul_add(x_L_1_3, IRxx) + rR * x_L_2_3 + w_Y_in_L_2_2 * x_L_2_4
        + w_Y_in_L_3_2 * x_L_3_3 + a_Bo_1_2 * x_B_1_3 + a_Bo_2_2 * x_B_2_3
        + a_Bo_3_2 * x_B_3_3 + w_L_in_B_1_2 * x_B_1_6 + w_B_2_2 * x_B_2_6
        + w_L_in_B_3_2 * x_B_3_7 + a_Ho_2_3 * x_H_2_3 + alpha_F_in_H_1_2 * x_H_1_6
        + w_S_in_F_2_2 * x_H_2_6 + alpha_F_in_H_3_2 * x_H_3_6 + a_FC_1_2 * x_F_1_7
        + a_FC_2_2 * x_F_2_6 + a_FC_3_2 * x_F_3_7 + w_S_in_F_1_2 * x_F_1_10
        + w_FW_2_2 * x_F_2_9 + w_B_in_S_3_2 * x_F_3_10 + x_F_in_H_1_2 * x_F_in_H_1_12
        + x_F_in_H_3_2 * x_F_in_H_3_11 - l2 * s3_of_place;
    let s4_of_place = w_Y_in_L_2_3.mul_add(x_L_2_6, x_F_1_4 * x_L_1_5)
        + w_Y_in_L_3_3 * x_L_3_5 + a_Bo_1_3 * x_B_1_5 + a_Bo_2_3 * x_B_2_5
        + a_Bo_3_3 * x_B_3_5 + w_L_in_B_1_3 * x_B_1_8 - w_B_2_3 * x_B_2_8
        - w_L_in_B_3_3 * x_B_3_9 + a_Ho_2_4 * x_H_2_5 + alpha_F_in_H_1_3 * x_H_1_8
        + w_S_in_F_2_3 * x_H_2_8 + alpha_F_in_H_3_3 * x_H_3_8 + a_FC_1_3 * x_F_1_9
        + a_FC_2_3 * x_F_2_8 + a_FC_3_3 * x_F_3_9 + w_S_in_F_1_3 * x_F_1_12
        + w_FW_2_3 * x_F_2_11 + w_F_3_2 * x_F_3_12 - x_F_in_H_1_4 * x_F_in_H_1_13
        - x_F_in_H_3_4 * x_F_in_H_3_12;
    let s4 = w_Y_in_L_2_2.mul_add(x_L_2_6, x_F_1_3 * x_L_1_5) + w_Y_in_L_3_2 * x_L_3_5
        + a_Bo_1_2 * x_B_1_5 - a_Bo_2_2 * x_B_2_5 + a_Bo_3_2 * x_B_3_5
        + w_L_in_B_1_2 * x_B_1_8 - w_B_2_2 * x_B_2_8 + w_L_in_B_3_2 * x_B_3_9
        + a_Ho_2_3 * x_H_2_5 - alpha_F_in_H_1_2 * x_H_1_8 - w_S_in_F_2_2 * x_H_2_8
        - alpha_F_in_H_3_2 * x_H_3_8 - a_FC_1_2 * x_F_1_9 - a_FC_2_2 * x_F_2_8
        - a_FC_3_2 * x_F_3_9 - w_S_in_F_1_2 * x_F_1_12 + w_FW_2_2 * x_F_2_11
        - w_B_in_S_3_2 * x_F_3_12 - x_F_in_H_1_4 * x_F_in_H_1_12
        - x_F_in_H_3_4 * x_F_in_H_3_11 - l2 * s4_of_place;
    let x_f_2_2_halved = S::ratio(1, 2) * x_F_2_2;
    let r5_of_place = x_L_1.mul_add(x_F_1_4, x_L_2_2 * w_Y_in_L_2_3);
    let r5_of_place_2 = x_B_1_2.mul_add(w_L_in_B_1_3, x_B_2_2 * w_B_2_3);
    let r5_of_place_3 = (-x_F_in_H_1).mul_add(x_F_in_H_1_13, x_B_3_2 * w_L_in_B_3_3);
    let r5_of_place_4 = x_F_in_H_3.mul_add(x_F_in_H_3_12, x_H_2 * a_Ho_2_4);
    let r5_of_place_5 = x_H_1_2.mul_add(alpha_F_in_H_1_3, x_H_2_2 * w_S_in_F_2_3);
    let r5_of_place_6 = r5_of_place_2 - r5_of_place_3;
    let r5_of_place_7 = r5_of_place_4 - r5_of_place_5;
    let r5_of_place_8 = (-x_F_1).mul_add(a_FC_1_3, x_H_3_2 * alpha_F_in_H_3_3);
    let r5_of_place_9 = x_F_3.mul_add(a_FC_3_3, x_F_2 * a_FC_2_3);
    let r5_of_place_10 = x_B_1.mul_add(a_Bo_1_3, x_L_3_2 * w_Y_in_L_3_3);
    let r5_of_place_11 = (-x_B_3).mul_add(a_Bo_3_3, x_B_2 * a_Bo_2_3);
    let r5_of_place_12 = x_F_3_2.mul_add(w_F_3_2, x_F_1_2 * w_S_in_F_1_3);
    let r5_of_place_13 = r5_of_place_10 - r5_of_place_11;
    let r5_of_place_14 = r5_of_place_8 + r5_of_place_9;
    let r5_of_place_15 = r5_of_place_12 - r5_of_place_13;
    let r5_of_place_16 = r5_of_place_6 + r5_of_place_7;
    let r5_of_place_17 = r5_of_place_14 - r5_of_place_15;
    let r5_of_place_18 = (-r5_of_place).mul_add(S::int(2), x_F_2_2 * w_FW_2_3);
    let r5_of_place_19 = r5_of_place_16 - r5_of_place_17;
    let r5_of_place_20 = (-r5_of_place_19).mul_add(S::int(2), r5_of_place_18);
    let minus_r5_of_place_20 = -r5_of_place_20;
    let r5_of_place_21 = S::ratio(1, 2) * minus_r5_of_place_20;
    let r5 = rR.mul_add(x_L_2, -x_L_1_2) - x_L_2_2 * w_Y_in_L_2_2 - x_L_1 * x_F_1_3
        + x_L_3_2 * w_Y_in_L_3_2 - x_B_2_2 * w_B_2_2 + x_B_1 * a_Bo_1_2
        - x_B_1_2 * w_L_in_B_1_2 - x_B_3_2 * w_L_in_B_3_2 + x_B_2 * a_Bo_2_2
        + x_B_3 * a_Bo_3_2 + x_F_3_2 * w_B_in_S_3_2 - x_H_2_2 * w_S_in_F_2_2
        + x_F_1_2 * w_S_in_F_1_2 - x_H_2 * a_Ho_2_3 - x_H_1_2 * alpha_F_in_H_1_2
        - x_H_3_2 * alpha_F_in_H_3_2 + x_F_1 * a_FC_1_2 - x_F_2 * a_FC_2_2
        - x_F_3 * a_FC_3_2 - x_F_in_H_1 * x_F_in_H_1_12 - x_F_in_H_3 * x_F_in_H_3_11
        + w_FW_2_2 * x_f_2_2_halved + l2 * r5_of_place_21;
    let l6 = d1_inv
        * (x_L_2_5.mul_add(w_RW_2_2, x_L_1_4 * x_F_1_5) + x_L_3_4 * w_Y_in_L_3_4
            + x_B_1_4 * a_Bo_1_4 + x_B_2_4 * a_Bo_2_4 + x_B_3_4 * a_Bo_3_4
            + w_L_in_B_1_4 * x_B_1_7 - w_Y_in_L_2_4 * x_B_2_7 - w_L_in_B_3_4 * x_B_3_8
            + x_H_2_4 * a_Ho_2_5 + x_H_1_7 * alpha_F_in_H_1_4 + w_S_in_F_2_4 * x_H_2_7
            + alpha_F_in_H_3_4 * x_H_3_7 + x_F_1_8 * a_FC_1_4 + x_F_2_7 * a_FC_2_4
            + x_F_3_8 * a_FC_3_4 + w_S_in_F_1_4 * x_F_1_11 + x_F_2_10 * w_FW_2_4
            + w_B_in_S_3_4 * x_F_3_11 - x_F_in_H_1_3 * x_F_in_H_1_14
            - x_F_in_H_3_3 * x_F_in_H_3_13);
    let s7 = w_RW_2_2.mul_add(x_L_2_6, x_F_1_5 * x_L_1_5) + w_Y_in_L_3_4 * x_L_3_5
        + a_Bo_1_4 * x_B_1_5 + a_Bo_2_4 * x_B_2_5 + a_Bo_3_4 * x_B_3_5
        + w_L_in_B_1_4 * x_B_1_8 + w_Y_in_L_2_4 * x_B_2_8 - w_L_in_B_3_4 * x_B_3_9
        + a_Ho_2_5 * x_H_2_5 + alpha_F_in_H_1_4 * x_H_1_8 + w_S_in_F_2_4 * x_H_2_8
        + alpha_F_in_H_3_4 * x_H_3_8 + a_FC_1_4 * x_F_1_9 + a_FC_2_4 * x_F_2_8
        + a_FC_3_4 * x_F_3_9 + w_S_in_F_1_4 * x_F_1_12 + w_FW_2_4 * x_F_2_11
        + w_B_in_S_3_4 * x_F_3_12 + x_F_in_H_1_4 * x_F_in_H_1_14
        + x_F_in_H_3_4 * x_F_in_H_3_13 - l6 * s4_of_place;
    let r8 = (-x_L_1).mul_add(x_F_1_5, x_B_2_2 * w_Y_in_L_2_4) - x_L_2_2 * w_RW_2_2
        + x_L_3_2 * w_Y_in_L_3_4 + x_B_1 * a_Bo_1_4 - x_B_1_2 * w_L_in_B_1_4
        + x_B_3_2 * w_L_in_B_3_4 - x_B_2 * a_Bo_2_4 + x_B_3 * a_Bo_3_4
        - x_F_3_2 * w_B_in_S_3_4 + x_H_2_2 * w_S_in_F_2_4 - x_F_1_2 * w_S_in_F_1_4
        - x_H_2 * a_Ho_2_5 + x_H_1_2 * alpha_F_in_H_1_4 + x_H_3_2 * alpha_F_in_H_3_4
        - x_F_1 * a_FC_1_4 + x_F_2 * a_FC_2_4 + x_F_3 * a_FC_3_4
        + x_F_in_H_1 * x_F_in_H_1_14 + x_F_in_H_3 * x_F_in_H_3_13
        + w_FW_2_4 * x_f_2_2_halved + l6 * r5_of_place_21;
    let s3_inv = S::int(1) / s3;
    let l9 = s4 * s3_inv;
    let s10 = (-s4).mul_add(l9, s7);
    let r11 = (-r5).mul_add(l9, r8);
    let u3_dot = r11 / s10;
    let u1_dot = s3_inv * (-u3_dot).mul_add(s4, r5);
    let u2_dot_of_motion = u3_dot.mul_add(s4_of_place, u1_dot * s3_of_place);
    let u2_dot = S::ratio(1, 2) * d1_inv * (-u2_dot_of_motion).mul_add(S::int(2), r5_of_place_20);
    [u1_dot, u2_dot, u3_dot]
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
    let w_Y_in_L_3_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_3 = w_Y_in_L_3_of_u1_u2_u3 * cos_phi;
    let w_Y_in_L_2 = w_Y_in_L_3_of_u1_u2_u3 * sin_phi;
    let w_RW_2 = u3 - w_Y_in_L_2;
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let H_rear_wheel_1 = IRxx * u1;
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-w_Y_in_L_3).mul_add(cos_theta, u1 * sin_theta);
    let w_B_2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1) - w_Y_in_L_2;
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1 = (-w_B_2).mul_add(sin_delta, w_B_in_S_1 * cos_delta);
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = u2 + w_B_in_S_3;
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
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
    let w_FW_in_F_2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1) + u3 * ratio_thF_u3;
    let w_FW_2 = w_S_in_F_2 + w_FW_in_F_2;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let x_N_in_Y_1_4 = rR * u3 * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let x_F_1_13 = rR.mul_add(w_Y_in_L_2, -x_N_in_Y_1_4);
    let x_F_2_12 = rR * u1;
    let x_L_in_B_1_12 = x_F_1_13 * cos_theta;
    let x_L_in_B_3_10 = x_F_1_13 * sin_theta;
    let x_B_in_S_1_13 = (-x_L_in_B_1_12).mul_add(cos_lam, x_L_in_B_3_10 * sin_lam);
    let x_B_in_S_3_11 = x_L_in_B_3_10.mul_add(cos_lam, x_L_in_B_1_12 * sin_lam);
    let x_F_2_13 = w_B_in_S_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, x_F_2_12);
    let x_F_3_13 = w_B_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3_11);
    let x_S_in_F_1_13 = (-x_F_2_13).mul_add(sin_delta, x_B_in_S_1_13 * cos_delta);
    let x_S_in_F_2_14 = x_F_2_13.mul_add(cos_delta, x_B_in_S_1_13 * sin_delta);
    let rr_plus_zb = rR + zB;
    let x_B_1_10 = w_B_2.mul_add(rr_plus_zb, x_L_in_B_1_12);
    let x_B_2_9 = xB.mul_add(w_L_in_B_3, x_F_2_12) - w_L_in_B_1 * rr_plus_zb;
    let x_B_3_10 = (-xB).mul_add(w_B_2, x_L_in_B_3_10);
    let rr_plus_zh = rR + zH;
    let x_H_1_9_of_lam_rr_xh_zh = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let x_H_1_9 = (-w_S_in_F_2).mul_add(x_H_1_9_of_lam_rr_xh_zh, x_S_in_F_1_13);
    let x_H_2_9_of_place = (-xH).mul_add(cos_lam, ratio_theta_u1_of_w_c_lam_rr)
        + rr_plus_zh * sin_lam;
    let x_H_2_9 = w_S_in_F_1.mul_add(x_H_1_9_of_lam_rr_xh_zh, x_S_in_F_2_14)
        - w_F_3 * x_H_2_9_of_place;
    let x_H_3_9 = (-w_S_in_F_2).mul_add(x_H_2_9_of_place, x_F_3_13);
    let x_F_1_14 = w_S_in_F_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -x_S_in_F_1_13);
    let x_F_2_14 = w_F_3.mul_add(ratio_psi_u1_of_c_lam_rf, x_S_in_F_2_14)
        + w_S_in_F_1 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_3_14 = w_S_in_F_2.mul_add(ratio_psi_u1_of_c_lam_rf, x_F_3_13);
    let energy_of_place = x_B_2_9.mul_add(x_B_2_9, x_B_1_10 * x_B_1_10);
    let energy_of_place_2 = x_H_2_9.mul_add(x_H_2_9, x_H_1_9 * x_H_1_9);
    let energy_of_place_3 = x_F_2_14.mul_add(x_F_2_14, x_F_1_14 * x_F_1_14);
    let energy_of_u1 = u1.mul_add(H_rear_wheel_1, w_RW_2 * H_rear_wheel_2);
    let energy_of_place_4 = w_F_3.mul_add(H_front_wheel_3, w_FW_2 * H_front_wheel_2);
    let energy_of_u1_2 = mR * x_F_2_12.mul_add(x_F_2_12, x_F_1_13 * x_F_1_13) + energy_of_u1;
    let energy_of_place_5 = w_L_in_B_1.mul_add(H_frame_1, w_Y_in_L_3 * H_rear_wheel_3);
    let energy_of_place_6 = w_L_in_B_3.mul_add(H_frame_3, w_B_2 * H_frame_2);
    let energy_of_place_7 = w_F_in_H_1.mul_add(H_fork_1, w_S_in_F_2 * H_fork_2);
    let energy_of_place_8 = w_S_in_F_1.mul_add(H_front_wheel_1, w_F_in_H_3 * H_fork_3);
    let energy_of_place_9 = energy_of_place_5 + energy_of_place_6;
    let energy_of_place_10 = energy_of_place_7 + energy_of_place_8;
    let energy_of_u1_3 = energy_of_place_4 + energy_of_u1_2;
    let energy_of_place_11 = energy_of_place_9 + energy_of_place_10;
    let energy_of_u1_4 = energy_of_u1_3 + energy_of_place_11;
    // Values.
    let energy = S::ratio(1, 2) * mB * x_B_3_10.mul_add(x_B_3_10, energy_of_place)
        + S::ratio(1, 2) * mH * x_H_3_9.mul_add(x_H_3_9, energy_of_place_2)
        + S::ratio(1, 2) * mF * x_F_3_14.mul_add(x_F_3_14, energy_of_place_3)
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
    let x_Y_in_L_2_6 = g * sin_phi;
    let x_Y_in_L_3_6 = g * cos_phi;
    let x_L_in_B_1_13 = x_Y_in_L_3_6 * sin_theta;
    let x_L_in_B_3_11 = x_Y_in_L_3_6 * cos_theta;
    let x_B_in_S_1_14 = x_L_in_B_3_11.mul_add(sin_lam, x_L_in_B_1_13 * cos_lam);
    let x_B_in_S_3_12 = (-x_L_in_B_1_13).mul_add(sin_lam, x_L_in_B_3_11 * cos_lam);
    let x_S_in_F_1_14 = (-x_Y_in_L_2_6).mul_add(sin_delta, x_B_in_S_1_14 * cos_delta);
    let x_S_in_F_2_15 = x_B_in_S_1_14.mul_add(sin_delta, x_Y_in_L_2_6 * cos_delta);
    let x_N_in_Y_1_5 = mp_N_2.mul_add(sin_psi, mp_N_1 * cos_psi);
    let x_N_in_Y_2_3 = (-mp_N_2).mul_add(cos_psi, mp_N_1 * sin_psi);
    let x_Y_in_L_2_7 = x_N_in_Y_2_3 * cos_phi;
    let x_Y_in_L_3_7 = x_N_in_Y_2_3 * sin_phi;
    let x_F_3_15 = mp_L_3 - x_Y_in_L_3_7;
    let x_L_in_B_1_14 = x_F_3_15.mul_add(sin_theta, x_N_in_Y_1_5 * cos_theta);
    let x_L_in_B_3_12 = (-x_N_in_Y_1_5).mul_add(sin_theta, x_F_3_15 * cos_theta);
    let x_F_1_15 = mp_B_1 + x_L_in_B_1_14;
    let x_F_3_16 = mp_B_3 - x_L_in_B_3_12;
    let x_B_in_S_1_15 = (-x_F_1_15).mul_add(cos_lam, x_F_3_16 * sin_lam);
    let x_B_in_S_3_13 = x_F_3_16.mul_add(cos_lam, x_F_1_15 * sin_lam);
    let x_F_1_16 = mp_S_1 - x_B_in_S_1_15;
    let x_S_in_F_1_15 = (-x_Y_in_L_2_7).mul_add(sin_delta, x_F_1_16 * cos_delta);
    let x_S_in_F_2_16 = x_F_1_16.mul_add(sin_delta, x_Y_in_L_2_7 * cos_delta);
    let x_F_1_17 = mp_F_1 - x_S_in_F_1_15;
    let x_F_3_17 = mp_F_3 + x_B_in_S_3_13;
    // Values.
    let energy = (-x_S_in_F_1_14).mul_add(x_F_1_17, x_S_in_F_2_15 * x_S_in_F_2_16)
        - x_B_in_S_3_12 * x_F_3_17;
    energy
}

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u) row by row, and its right-hand side, which share terms.
///
/// 1633 operations, 8 sines and cosines, 2 other functions.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 8],
    u: &[S; 3],
) -> ([S; 576], [S; 24]) {
    let Parameters {
        w, c, lam, g, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBxz, IByy, IBzz, xH, zH, mH, IHxx,
        IHxz, IHyy, IHzz, rF, mF, IFxx, IFyy,
    } = *p;
    let [_, _, psi, phi, theta, delta, thR, thF] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_lam, cos_lam) = lam.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (sin_thR, cos_thR) = thR.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_thF, cos_thF) = thF.sin_cos();
    // Step by step, each after the terms that it needs.
    let lam_plus_theta = lam + theta;
    let (sin_lam_plus_theta, cos_lam_plus_theta) = lam_plus_theta.sin_cos();
    let ratio_psi_u1_of_place = cos_lam_plus_theta * sin_delta;
    let c_cos_lam = c * cos_lam;
    let ratio_theta_u1_of_c_lam_rf = (-rF).mul_add(sin_lam, c_cos_lam);
    let ratio_psi_u1_of_c_lam_rf = -ratio_theta_u1_of_c_lam_rf;
    let x_F_in_S_3_2_of_place = cos_phi * sin_lam_plus_theta;
    let sin_delta_sin_phi = sin_phi * sin_delta;
    let ratio_theta_u1_of_place = (-x_F_in_S_3_2_of_place)
        .mul_add(cos_delta, sin_delta_sin_phi);
    let sin_phi_cos_delta = sin_phi * cos_delta;
    let x_F_in_S_3_2_of_place_2 = x_F_in_S_3_2_of_place * sin_delta;
    let x_F_in_S_3_2_of_place_3 = sin_phi_cos_delta + x_F_in_S_3_2_of_place_2;
    let x_F_in_S_3_2_of_place_4 = x_F_in_S_3_2_of_place_3 * x_F_in_S_3_2_of_place_3;
    let x_F_in_S_3_2_of_place_5 = S::int(1) / (x_F_in_S_3_2_of_place_4 - S::int(1));
    let x_F_in_S_3_2_of_place_6 = cos_phi * sin_lam_plus_theta * sin_delta;
    let x_F_in_S_3_2_of_place_7 = rF * x_F_in_S_3_2_of_place_5
        * (S::int(1) - (x_F_in_S_3_2_of_place_6 + sin_phi_cos_delta).powi(2)).sqrt();
    let ratio_theta_u1_of_place_2 = ratio_theta_u1_of_place * x_F_in_S_3_2_of_place_7;
    let ratio_psi_u1_of_place_2 = ratio_theta_u1_of_place_2 - ratio_psi_u1_of_c_lam_rf;
    let ratio_psi_u1_of_place_3 = -ratio_psi_u1_of_place * ratio_psi_u1_of_place_2;
    let rr_minus_rf = rR - rF;
    let w_sin_lam = w * sin_lam;
    let ratio_theta_u1_of_w_lam_rr_rf = rr_minus_rf.mul_add(cos_lam, w_sin_lam);
    let x_F_in_S_3_2_of_place_8 = cos_phi * cos_lam_plus_theta;
    let x_F_in_S_3_2 = x_F_in_S_3_2_of_place_7 * x_F_in_S_3_2_of_place_8;
    let ratio_theta_u1_of_place_3 = ratio_theta_u1_of_w_lam_rr_rf - x_F_in_S_3_2;
    let ratio_psi_u1_of_place_4 = cos_lam_plus_theta * cos_delta;
    let ratio_psi_u1_of_place_5 = (-ratio_theta_u1_of_place_3)
        .mul_add(ratio_psi_u1_of_place_4, -ratio_psi_u1_of_place_2 * sin_lam_plus_theta);
    let ratio_psi_u1_of_place_6 = ratio_psi_u1_of_place * ratio_theta_u1_of_place_3;
    let ratio_psi_u1_of_place_7 = ratio_theta_u1_of_place_3 * sin_delta;
    let ratio_psi_u1_of_place_8 = -ratio_theta_u1_of_place_3 * cos_delta;
    let w_plus_c = w + c;
    let rr_sin_lam = rR * sin_lam;
    let ratio_theta_u1_of_w_c_lam_rr = w_plus_c.mul_add(cos_lam, -rr_sin_lam);
    let ratio_psi_u1_of_place_9 = -ratio_psi_u1_of_place_2 * cos_delta;
    let ratio_psi_u1_of_place_10 = ratio_theta_u1_of_w_c_lam_rr + ratio_psi_u1_of_place_9;
    let ratio_psi_u1_of_place_11 = (-ratio_psi_u1_of_place)
        .mul_add(
            ratio_psi_u1_of_place_7,
            ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_8,
        ) + ratio_psi_u1_of_place_10 * sin_lam_plus_theta;
    let ratio_theta_u1_of_place_4 = -ratio_theta_u1_of_c_lam_rf - ratio_theta_u1_of_place_2;
    let sin_delta_cos_phi = cos_phi * sin_delta;
    let ratio_theta_u1_of_place_5 = sin_phi_cos_delta
        .mul_add(sin_lam_plus_theta, sin_delta_cos_phi);
    let cos_delta_cos_phi = cos_phi * cos_delta;
    let ratio_theta_u1_of_place_6 = sin_delta_sin_phi
        .mul_add(sin_lam_plus_theta, -cos_delta_cos_phi);
    let ratio_theta_u1_of_place_7 = x_F_in_S_3_2_of_place_5 * x_F_in_S_3_2_of_place_7;
    let ratio_theta_u1_of_place_8 = x_F_in_S_3_2_of_place_3 * ratio_theta_u1_of_place_7;
    let ratio_theta_u1_of_place_9 = ratio_theta_u1_of_place * ratio_theta_u1_of_place_8;
    let ratio_theta_u1_of_place_10 = ratio_theta_u1_of_place_6
        .mul_add(
            ratio_theta_u1_of_place_9,
            x_F_in_S_3_2_of_place_7 * ratio_theta_u1_of_place_5,
        );
    let ratio_theta_u1_of_place_11 = sin_phi * cos_lam_plus_theta;
    let ratio_theta_u1_of_place_12 = x_F_in_S_3_2_of_place_8 * ratio_theta_u1_of_place_8;
    let ratio_theta_u1_of_place_13 = (-ratio_theta_u1_of_place_6)
        .mul_add(
            ratio_theta_u1_of_place_12,
            x_F_in_S_3_2_of_place_7 * ratio_theta_u1_of_place_11,
        );
    let ratio_theta_u1_of_place_14 = sin_phi
        * ratio_theta_u1_of_w_c_lam_rr.mul_add(sin_lam_plus_theta, rR);
    let ratio_theta_u1_of_place_15 = ratio_theta_u1_of_place * ratio_theta_u1_of_place_12;
    let cos_delta_x_f_in_s_3_2 = x_F_in_S_3_2 * cos_delta;
    let ratio_theta_u1_of_place_16 = ratio_theta_u1_of_place_15
        .mul_add(sin_delta, cos_delta_x_f_in_s_3_2);
    let ratio_theta_u1_of_place_17 = x_F_in_S_3_2_of_place_8 * sin_delta;
    let ratio_theta_u1_of_place_18 = ratio_theta_u1_of_place_12
        .mul_add(
            ratio_theta_u1_of_place_17,
            x_F_in_S_3_2_of_place * x_F_in_S_3_2_of_place_7,
        );
    let ratio_theta_u1_of_place_19 = ratio_theta_u1_of_place_4
        .mul_add(cos_delta, ratio_theta_u1_of_w_c_lam_rr);
    let ratio_theta_u1_of_place_20 = ratio_theta_u1_of_place_18 - ratio_theta_u1_of_place_19;
    let ratio_theta_u1_of_place_21 = S::int(1)
        / ((-ratio_theta_u1_of_place)
            .mul_add(
                ratio_theta_u1_of_place_16,
                x_F_in_S_3_2_of_place * ratio_theta_u1_of_place_3,
            ) - x_F_in_S_3_2_of_place_8 * ratio_theta_u1_of_place_20);
    let ratio_theta_u1 = ratio_theta_u1_of_place_21
        * ((-ratio_theta_u1_of_place)
            .mul_add(
                ratio_theta_u1_of_place_10,
                ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_5,
            ) - ratio_theta_u1_of_place_3 * ratio_theta_u1_of_place_11
            + x_F_in_S_3_2_of_place_8 * ratio_theta_u1_of_place_13 + ratio_theta_u1_of_place_14);
    let ratio_psi_u1_of_place_12 = (-ratio_psi_u1_of_place_3)
        .mul_add(sin_lam_plus_theta, ratio_psi_u1_of_place * ratio_psi_u1_of_place_5)
        + ratio_psi_u1_of_place_4 * ratio_psi_u1_of_place_6
        + ratio_theta_u1 * ratio_psi_u1_of_place_11;
    let ratio_psi_u1_of_place_13 = sin_lam
        * (-rR).mul_add(cos_lam_plus_theta, w * sin_lam_plus_theta)
        + cos_lam * w_plus_c.mul_add(cos_lam_plus_theta, rr_minus_rf * sin_lam_plus_theta);
    let ratio_psi_u1_of_place_14 = ratio_psi_u1_of_place_13
        .mul_add(cos_delta, ratio_psi_u1_of_c_lam_rf * cos_lam_plus_theta);
    let ratio_psi_u1_of_place_15 = rR * (cos_lam - cos_lam_plus_theta) - rF * cos_lam + w_sin_lam;
    let ratio_psi_u1_of_place_16 = S::int(1)
        / (-sin_delta_sin_phi)
            .mul_add(ratio_psi_u1_of_place_15, ratio_psi_u1_of_place_14 * cos_phi);
    let ratio_psi_u1_of_place_17 = ratio_psi_u1_of_place * ratio_psi_u1_of_place_16;
    let x_L_in_Y_3 = rR * cos_phi;
    let ratio_psi_u1_of_place_18 = x_F_in_S_3_2_of_place
        .mul_add(ratio_theta_u1_of_w_c_lam_rr, x_L_in_Y_3);
    let ratio_psi_u1_of_place_19 = (-ratio_psi_u1_of_place_8)
        .mul_add(
            ratio_theta_u1_of_place_5,
            ratio_psi_u1_of_place_7 * ratio_theta_u1_of_place_6,
        ) + ratio_psi_u1_of_place_10 * ratio_theta_u1_of_place_11;
    let ratio_psi_u1_of_place_20 = (-ratio_psi_u1_of_place_6)
        .mul_add(ratio_theta_u1_of_place_5, ratio_psi_u1_of_place_18)
        - ratio_psi_u1_of_place_5 * ratio_theta_u1_of_place_6
        - ratio_psi_u1_of_place_3 * ratio_theta_u1_of_place_11
        + ratio_theta_u1 * ratio_psi_u1_of_place_19;
    let ratio_psi_u1_of_place_21 = ratio_theta_u1_of_place_6 * ratio_psi_u1_of_place_16;
    let ratio_psi_u1 = (-ratio_psi_u1_of_place_20)
        .mul_add(
            ratio_psi_u1_of_place_21,
            ratio_psi_u1_of_place_12 * ratio_psi_u1_of_place_17,
        );
    let ratio_theta_u2_of_place = ratio_theta_u1_of_place
        .mul_add(
            ratio_theta_u1_of_place_9,
            x_F_in_S_3_2_of_place_3 * x_F_in_S_3_2_of_place_7,
        );
    let ratio_theta_u2 = ratio_theta_u1_of_place_21
        * ((-x_F_in_S_3_2_of_place_8)
            .mul_add(
                ratio_theta_u1_of_place_15,
                x_F_in_S_3_2_of_place_3 * ratio_theta_u1_of_place_4,
            ) - ratio_theta_u1_of_place * ratio_theta_u2_of_place);
    let ratio_psi_u2_of_place = ratio_psi_u1_of_place
        .mul_add(ratio_theta_u1_of_place_4, ratio_theta_u2 * ratio_psi_u1_of_place_11);
    let ratio_psi_u2_of_place_2 = (-ratio_theta_u2)
        .mul_add(
            ratio_psi_u1_of_place_19,
            ratio_theta_u1_of_place_4 * ratio_theta_u1_of_place_6,
        );
    let ratio_psi_u2 = ratio_psi_u1_of_place_21
        .mul_add(
            ratio_psi_u2_of_place_2,
            ratio_psi_u1_of_place_17 * ratio_psi_u2_of_place,
        );
    let ratio_psi_u3 = rR * ratio_psi_u1_of_place_17;
    let w_Y_in_L_3_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2, u1 * ratio_psi_u1) + u3 * ratio_psi_u3;
    let w_Y_in_L_3 = w_Y_in_L_3_of_u1_u2_u3 * cos_phi;
    let ratio_theta_u1_2_of_u1_u2 = u2.mul_add(ratio_theta_u2, u1 * ratio_theta_u1);
    let ratio_theta_u1_2_of_u1_u2_2 = ratio_theta_u1_2_of_u1_u2 * sin_lam_plus_theta;
    let u2_cos_delta = u2 * cos_delta;
    let ratio_psi_u1_2_of_u2 = u2_cos_delta * cos_lam_plus_theta;
    let ratio_psi_u1_2_of_u1_u2 = ratio_theta_u1_2_of_u1_u2_2
        .mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let u1_sin_phi = u1 * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_3 = (-x_F_in_S_3_2_of_place_8)
        .mul_add(ratio_theta_u1_2_of_u1_u2, u1_sin_phi * sin_lam_plus_theta);
    let u2_sin_delta = u2 * sin_delta;
    let sin_phi_u2_cos_delta = u2_cos_delta * sin_phi;
    let ratio_theta_u1_2_of_u1_u2_4 = u1
        .mul_add(sin_delta_cos_phi, sin_phi_u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_5 = x_F_in_S_3_2_of_place
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_3 * cos_delta)
        + ratio_theta_u1_2_of_u1_u2_4;
    let ratio_theta_u1_2_of_u1_u2_6 = (-u1)
        .mul_add(cos_delta_cos_phi, u2_sin_delta * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_7 = (-x_F_in_S_3_2_of_place)
        .mul_add(u2_cos_delta, ratio_theta_u1_2_of_u1_u2_3 * sin_delta);
    let ratio_theta_u1_2_of_u1_u2_8 = -ratio_theta_u1_2_of_u1_u2_6 - ratio_theta_u1_2_of_u1_u2_7;
    let ratio_theta_u1_2_of_u1_u2_9 = (-x_F_in_S_3_2_of_place_7)
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_5,
            ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_8,
        );
    let ratio_psi_u1_2_of_u1_u2_2 = ratio_psi_u1_of_place
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_9,
            ratio_psi_u1_of_place_2 * ratio_psi_u1_2_of_u1_u2,
        );
    let ratio_psi_u1_2_of_u1_u2_3 = ratio_theta_u1_2_of_u1_u2 * cos_lam_plus_theta;
    let ratio_theta_u1_2_of_u1 = u1 * ratio_theta_u1_of_place_11;
    let ratio_theta_u1_2_of_u1_u2_10 = ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_8;
    let ratio_psi_u1_2_of_u1_u2_4 = x_F_in_S_3_2_of_place_7
        .mul_add(ratio_theta_u1_2_of_u1, ratio_theta_u1_2_of_u1_u2_10);
    let u2_ratio_psi_u1_of_place = u2 * ratio_psi_u1_of_place;
    let ratio_psi_u1_2_of_u1_u2_5 = ratio_theta_u1_2_of_u1_u2_2 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_6 = S::int(2) * ratio_theta_u1_2_of_u1_u2_2;
    let ratio_psi_u1_2_of_u1_u2_7 = (-ratio_psi_u1_of_place_2)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_3,
            ratio_theta_u1_2_of_u1_u2_9 * sin_lam_plus_theta,
        ) - ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2_4
        + ratio_theta_u1_of_place_3 * u2_ratio_psi_u1_of_place
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2_5
        - cos_delta_x_f_in_s_3_2 * ratio_psi_u1_2_of_u1_u2_6;
    let ratio_psi_u1_2_of_u1_u2_8 = u2_ratio_psi_u1_of_place + ratio_psi_u1_2_of_u1_u2_5;
    let ratio_psi_u1_2_of_u1_u2_9 = ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_4
        - ratio_theta_u1_of_w_lam_rr_rf * ratio_psi_u1_2_of_u1_u2
        + x_F_in_S_3_2 * ratio_psi_u1_2_of_u1_u2_6.mul_add(sin_delta, -ratio_psi_u1_2_of_u2);
    let ratio_psi_u1_2_of_u1_u2_10 = (-ratio_theta_u1_2_of_u1_u2_9)
        .mul_add(cos_delta, -ratio_psi_u1_of_place_2 * u2_sin_delta);
    let ratio_theta_u1_2_of_u1_u2_11 = x_F_in_S_3_2_of_place
        .mul_add(ratio_theta_u1_2_of_u1_u2, ratio_theta_u1_2_of_u1);
    let ratio_theta_u1_2_of_u1_u2_12 = x_F_in_S_3_2_of_place_7
        .mul_add(ratio_theta_u1_2_of_u1_u2_11, ratio_theta_u1_2_of_u1_u2_10);
    let ratio_psi_u1_2_of_u1_u2_11 = ratio_theta_u1_2_of_u1_u2_12
        .mul_add(sin_delta, ratio_theta_u1_of_place_3 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_13 = ratio_theta_u1_2_of_u1_u2_12 * cos_delta;
    let ratio_psi_u1_2_of_u1_u2_12 = (-ratio_theta_u1_of_place_3)
        .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_13);
    let ratio_psi_u1_2_of_u1_u2_13 = (-ratio_psi_u1_of_place_7)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2,
            ratio_psi_u1_of_place_8 * ratio_psi_u1_2_of_u1_u2_8,
        ) - ratio_psi_u1_of_place_10 * ratio_psi_u1_2_of_u1_u2_3
        + ratio_psi_u1_2_of_u1_u2_10 * sin_lam_plus_theta
        + ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_11
        + ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2_12;
    let ratio_theta_u1_2_of_u1_u2_14 = ratio_theta_u1_of_place_11 * ratio_theta_u1_2_of_u1_u2;
    let ratio_theta_u1_2_of_u1_u2_15 = (-u1)
        .mul_add(sin_delta_sin_phi, u2_cos_delta * cos_phi)
        - ratio_theta_u1_2_of_u1_u2_6 * sin_lam_plus_theta
        + ratio_theta_u1_2_of_u1_u2_14 * cos_delta;
    let ratio_theta_u1_2_of_u1_u2_16 = -ratio_theta_u1_2_of_u1_u2_9;
    let ratio_theta_u1_2_of_u1_u2_17 = ratio_theta_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_8
        * (-(x_F_in_S_3_2_of_place_4 * x_F_in_S_3_2_of_place_5))
            .mul_add(S::int(3), S::int(1));
    let ratio_theta_u1_2_of_u1_u2_18 = ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_17;
    let ratio_theta_u1_2_of_u1_u2_19 = ratio_theta_u1_of_place_8
        .mul_add(ratio_theta_u1_2_of_u1_u2_5, ratio_theta_u1_2_of_u1_u2_18);
    let ratio_theta_u1_2_of_u1_u2_20 = (ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2)
        .mul_add(sin_phi, u1 * x_F_in_S_3_2_of_place_3) + u2_sin_delta * cos_phi
        + sin_phi_u2_cos_delta * sin_lam_plus_theta;
    let ratio_theta_u1_2_of_u1_u2_21 = ratio_theta_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_8;
    let ratio_theta_u1_2_of_u1_u2_22 = (-u1)
        .mul_add(x_F_in_S_3_2_of_place_8, ratio_theta_u1_2_of_u1_u2_2 * sin_phi);
    let ratio_theta_u1_2_of_u1_u2_23 = x_F_in_S_3_2_of_place_8 * ratio_theta_u1_2_of_u1_u2_17;
    let ratio_theta_u1_2_of_u1_u2_24 = ratio_theta_u1_of_w_c_lam_rr
        .mul_add(ratio_theta_u1_2_of_u1_u2_14, u1 * ratio_psi_u1_of_place_18);
    let ratio_theta_u1_2_of_u1_u2_25 = ratio_theta_u1_2_of_u1_u2_11 * sin_delta;
    let ratio_theta_u1_2_of_u1_u2_26 = ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_23
        - x_F_in_S_3_2_of_place_7 * ratio_theta_u1_2_of_u1_u2_3
        - x_F_in_S_3_2_of_place * ratio_theta_u1_2_of_u1_u2_21
        + ratio_theta_u1_of_place_12
            * (-ratio_theta_u1_2_of_u1_u2_25)
                .mul_add(S::int(2), x_F_in_S_3_2_of_place_8 * u2_cos_delta);
    let ratio_theta_u1_2_of_u1_u2_27 = ratio_theta_u1_2_of_u1_u2_16
        .mul_add(cos_delta, ratio_theta_u1_2_of_u1_u2_26);
    let ratio_theta_u1_2_of_u1_u2_28 = ratio_theta_u1_of_place_3 * ratio_theta_u1_2_of_u1_u2_3
        + ratio_theta_u1_of_place_16 * ratio_theta_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_20 * ratio_theta_u1_2_of_u1_u2_11
        - x_F_in_S_3_2_of_place * ratio_theta_u1_2_of_u1_u2_12
        + ratio_theta_u1_of_place
            * ((-x_F_in_S_3_2)
                .mul_add(u2_sin_delta, ratio_theta_u1_of_place_15 * u2_cos_delta)
                - ratio_theta_u1_2_of_u1_u2_13
                + ratio_theta_u1_of_place_17 * ratio_theta_u1_2_of_u1_u2_19
                - ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_25)
        + x_F_in_S_3_2_of_place_8
            * ratio_theta_u1_of_place_4
                .mul_add(u2_sin_delta, ratio_theta_u1_2_of_u1_u2_27);
    let ratio_theta_u1_2_of_u1_u2_29 = ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_15
        - ratio_theta_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_5
        - ratio_theta_u1_of_place_13 * ratio_theta_u1_2_of_u1_u2_11
        - ratio_theta_u1_of_place_11 * ratio_theta_u1_2_of_u1_u2_12
        - ratio_theta_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_16
        + ratio_theta_u1_of_place
            * ((-x_F_in_S_3_2_of_place_7)
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_15,
                    ratio_theta_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_21,
                ) - ratio_theta_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_19
                - ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_20)
        + ratio_theta_u1_of_place_3 * ratio_theta_u1_2_of_u1_u2_22
        - x_F_in_S_3_2_of_place_8
            * (ratio_theta_u1_of_place_12 * ratio_theta_u1_2_of_u1_u2_20
                + ratio_theta_u1_of_place_11 * ratio_theta_u1_2_of_u1_u2_21
                + x_F_in_S_3_2_of_place_7 * ratio_theta_u1_2_of_u1_u2_22
                + ratio_theta_u1_of_place_6
                    * (-ratio_theta_u1_of_place_8)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_11, ratio_theta_u1_2_of_u1_u2_23,
                        )) + ratio_theta_u1_2_of_u1_u2_24;
    let ratio_theta_u1_2 = ratio_theta_u1_of_place_21
        * ratio_theta_u1
            .mul_add(ratio_theta_u1_2_of_u1_u2_28, ratio_theta_u1_2_of_u1_u2_29);
    let ratio_psi_u1_2_of_u1_u2_14 = (-ratio_theta_u1_2)
        .mul_add(
            ratio_psi_u1_of_place_11,
            ratio_psi_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2,
        ) + ratio_psi_u1_2_of_u1_u2_2 * sin_lam_plus_theta
        + ratio_psi_u1_of_place_3 * ratio_psi_u1_2_of_u1_u2_3
        - ratio_psi_u1_of_place * ratio_psi_u1_2_of_u1_u2_7
        + ratio_psi_u1_of_place_6 * ratio_psi_u1_2_of_u1_u2_8
        - ratio_psi_u1_of_place_4 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_13;
    let ratio_psi_u1_2_of_u1_u2_15 = (-ratio_theta_u1_of_place_11)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_10,
            ratio_theta_u1_of_place_6 * ratio_psi_u1_2_of_u1_u2_11,
        ) + ratio_theta_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2_12
        - ratio_psi_u1_of_place_8 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_psi_u1_of_place_7 * ratio_theta_u1_2_of_u1_u2_20
        - ratio_psi_u1_of_place_10 * ratio_theta_u1_2_of_u1_u2_22;
    let ratio_psi_u1_2_of_u1_u2_16 = (-ratio_theta_u1_2)
        .mul_add(ratio_psi_u1_of_place_19, rR * u1_sin_phi)
        + ratio_theta_u1_of_w_c_lam_rr * ratio_theta_u1_2_of_u1_u2_3
        + ratio_theta_u1_of_place_11 * ratio_psi_u1_2_of_u1_u2_2
        + ratio_theta_u1_of_place_6 * ratio_psi_u1_2_of_u1_u2_7
        + ratio_theta_u1_of_place_5 * ratio_psi_u1_2_of_u1_u2_9
        + ratio_psi_u1_of_place_6 * ratio_theta_u1_2_of_u1_u2_15
        + ratio_psi_u1_of_place_5 * ratio_theta_u1_2_of_u1_u2_20
        - ratio_psi_u1_of_place_3 * ratio_theta_u1_2_of_u1_u2_22
        - ratio_theta_u1 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u1_2_of_u1_u2_17 = rR * ratio_theta_u1_2_of_u1_u2_2;
    let ratio_psi_u1_2_of_u1_u2_18 = ratio_psi_u1_of_place_14 * u1_sin_phi
        + ratio_psi_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_4
        + sin_delta_sin_phi * ratio_psi_u1_2_of_u1_u2_17
        + cos_phi
            * (-cos_delta
                * (cos_lam
                    * (-w_plus_c)
                        .mul_add(
                            ratio_theta_u1_2_of_u1_u2_2,
                            rr_minus_rf * ratio_psi_u1_2_of_u1_u2_3,
                        )
                    + sin_lam
                        * w
                            .mul_add(
                                ratio_psi_u1_2_of_u1_u2_3, ratio_psi_u1_2_of_u1_u2_17,
                            )) + ratio_psi_u1_of_c_lam_rf * ratio_theta_u1_2_of_u1_u2_2
                + ratio_psi_u1_of_place_13 * u2_sin_delta);
    let ratio_psi_u1_2_of_u1_u2_19 = ratio_psi_u1_of_place_16
        * ratio_psi_u1_of_place_17
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, -ratio_psi_u1_2_of_u1_u2);
    let ratio_psi_u1_2_of_u1_u2_20 = ratio_psi_u1_of_place_16
        * ratio_psi_u1_of_place_21
            .mul_add(ratio_psi_u1_2_of_u1_u2_18, ratio_theta_u1_2_of_u1_u2_20);
    let ratio_psi_u1_2 = (-ratio_psi_u1_of_place_17)
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_14,
            ratio_psi_u1_of_place_21 * ratio_psi_u1_2_of_u1_u2_16,
        ) + ratio_psi_u1_of_place_12 * ratio_psi_u1_2_of_u1_u2_19
        - ratio_psi_u1_of_place_20 * ratio_psi_u1_2_of_u1_u2_20;
    let ratio_theta_u2_2_of_u1_u2 = ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_8
        - ratio_theta_u2_of_place * ratio_theta_u1_2_of_u1_u2_5
        + S::int(2) * ratio_theta_u1_of_place_15 * ratio_theta_u1_2_of_u1_u2_11
        - x_F_in_S_3_2_of_place_3 * ratio_theta_u1_2_of_u1_u2_16
        - x_F_in_S_3_2_of_place_8 * x_F_in_S_3_2_of_place_8 * ratio_theta_u1_2_of_u1_u2_19
        + ratio_theta_u1_of_place
            * ((-(ratio_theta_u1_of_place_9 * ratio_theta_u1_2_of_u1_u2_5))
                .mul_add(
                    S::int(2),
                    x_F_in_S_3_2_of_place_3 * ratio_theta_u1_2_of_u1_u2_21,
                ) - x_F_in_S_3_2_of_place_7 * ratio_theta_u1_2_of_u1_u2_8
                - ratio_theta_u1_of_place * ratio_theta_u1_2_of_u1_u2_18);
    let ratio_theta_u2_2 = ratio_theta_u1_of_place_21
        * ratio_theta_u2
            .mul_add(ratio_theta_u1_2_of_u1_u2_28, ratio_theta_u2_2_of_u1_u2);
    let ratio_psi_u2_2_of_u1_u2 = (-ratio_theta_u1_of_place_4)
        .mul_add(ratio_psi_u1_2_of_u1_u2, ratio_theta_u2_2 * ratio_psi_u1_of_place_11)
        - ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_13
        - ratio_psi_u1_of_place * ratio_theta_u1_2_of_u1_u2_16;
    let ratio_psi_u2_2_of_u1_u2_2 = ratio_theta_u1_of_place_6
        .mul_add(
            ratio_theta_u1_2_of_u1_u2_16,
            ratio_theta_u2_2 * ratio_psi_u1_of_place_19,
        ) - ratio_theta_u1_of_place_4 * ratio_theta_u1_2_of_u1_u2_20
        + ratio_theta_u2 * ratio_psi_u1_2_of_u1_u2_15;
    let ratio_psi_u2_2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_psi_u1_2_of_u1_u2_20,
            ratio_psi_u2_of_place * ratio_psi_u1_2_of_u1_u2_19,
        ) + ratio_psi_u1_of_place_17 * ratio_psi_u2_2_of_u1_u2
        - ratio_psi_u1_of_place_21 * ratio_psi_u2_2_of_u1_u2_2;
    let ratio_psi_u3_2 = rR * ratio_psi_u1_2_of_u1_u2_19;
    let w_L_13 = u1 * w_Y_in_L_3;
    let alpha_Y_in_L_2_of_u1_u2_u3 = u2.mul_add(ratio_psi_u2_2, u1 * ratio_psi_u1_2)
        + u3 * ratio_psi_u3_2;
    let alpha_Y_in_L_2 = alpha_Y_in_L_2_of_u1_u2_u3 * sin_phi;
    let alpha_L_2 = w_L_13 + alpha_Y_in_L_2;
    let turn_L_13 = w_L_13 + alpha_L_2;
    let a_RC_1 = rR * turn_L_13;
    let x_L_1 = mR * a_RC_1;
    let w_Y_in_L_2 = w_Y_in_L_3_of_u1_u2_u3 * sin_phi;
    let w_L_23 = w_Y_in_L_3 * w_Y_in_L_2;
    let x_N_in_Y_1 = rR * cos_psi.mul_add(cos_psi, sin_psi * sin_psi);
    let a_N_in_Y_2 = u3 * x_N_in_Y_1 * w_Y_in_L_3_of_u1_u2_u3;
    let a_Y_in_L_2 = (-a_N_in_Y_2).mul_add(cos_phi, g * sin_phi);
    let a_RC_2 = rR.mul_add(w_L_23, a_Y_in_L_2);
    let x_L_2 = mR * a_RC_2;
    let w_L_11 = u1 * u1;
    let w_L_22 = w_Y_in_L_2 * w_Y_in_L_2;
    let turn_L_33 = w_L_11 + w_L_22;
    let a_Y_in_L_3 = a_N_in_Y_2.mul_add(sin_phi, g * cos_phi);
    let a_RC_3 = rR.mul_add(turn_L_33, -a_Y_in_L_3);
    let x_L_3 = mR * a_RC_3;
    let w_RW_2 = u3 - w_Y_in_L_2;
    let w_L_in_RW_1 = w_Y_in_L_3.mul_add(sin_thR, u1 * cos_thR);
    let w_L_in_RW_3 = (-u1).mul_add(sin_thR, w_Y_in_L_3 * cos_thR);
    let H_rear_wheel_2 = IRyy * w_RW_2;
    let H_rear_wheel_3 = IRxx * w_Y_in_L_3;
    let u3_sin_thr = u3 * sin_thR;
    let u3_cos_thr = u3 * cos_thR;
    let alpha_RW_in_L_1 = w_L_in_RW_3.mul_add(u3_cos_thr, w_L_in_RW_1 * u3_sin_thr);
    let w_y_in_l_2_plus_w_rw_2 = w_Y_in_L_2 + w_RW_2;
    let x_L_1_2 = w_Y_in_L_3 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_3
        + IRxx * (-w_Y_in_L_3).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_in_L_1);
    let H_rear_wheel_1 = IRxx * u1;
    let x_L_2_2 = (-u1).mul_add(H_rear_wheel_3, IRyy * alpha_L_2) + w_Y_in_L_3 * H_rear_wheel_1;
    let alpha_RW_in_L_3 = (-w_L_in_RW_3).mul_add(u3_sin_thr, w_L_in_RW_1 * u3_cos_thr);
    let alpha_Y_in_L_3 = alpha_Y_in_L_2_of_u1_u2_u3 * cos_phi;
    let alpha_L_3 = u1.mul_add(w_Y_in_L_2, -alpha_Y_in_L_3);
    let alpha_RW_3 = alpha_RW_in_L_3 + alpha_L_3;
    let x_L_3_2 = u1 * H_rear_wheel_2 + w_Y_in_L_2 * H_rear_wheel_1
        + IRxx * (-u1).mul_add(w_y_in_l_2_plus_w_rw_2, alpha_RW_3);
    let w_L_in_B_1 = w_Y_in_L_3.mul_add(sin_theta, u1 * cos_theta);
    let w_L_in_B_3 = (-w_Y_in_L_3).mul_add(cos_theta, u1 * sin_theta);
    let w_B_2 = ratio_theta_u1_2_of_u1_u2 - w_Y_in_L_2;
    let w_B_13 = w_L_in_B_1 * w_L_in_B_3;
    let w_B_22 = w_B_2 * w_B_2;
    let w_B_33 = w_L_in_B_3 * w_L_in_B_3;
    let turn_B_11 = w_B_22 + w_B_33;
    let alpha_B_2 = u1.mul_add(ratio_theta_u1_2, -alpha_L_2) + u2 * ratio_theta_u2_2;
    let turn_B_13 = w_B_13 + alpha_B_2;
    let a_L_in_B_1 = (-a_RC_1).mul_add(cos_theta, a_RC_3 * sin_theta);
    let rr_plus_zb = rR + zB;
    let a_Bo_1 = xB.mul_add(turn_B_11, a_L_in_B_1) - turn_B_13 * rr_plus_zb;
    let x_B_1 = mB * a_Bo_1;
    let w_B_12 = w_L_in_B_1 * w_B_2;
    let w_B_23 = w_L_in_B_3 * w_B_2;
    let alpha_L_in_B_1 = alpha_L_3 * sin_theta;
    let alpha_L_in_B_3 = alpha_L_3 * cos_theta;
    let alpha_B_1 = w_L_in_B_3.mul_add(ratio_theta_u1_2_of_u1_u2, alpha_L_in_B_1);
    let alpha_B_3 = w_L_in_B_1.mul_add(ratio_theta_u1_2_of_u1_u2, alpha_L_in_B_3);
    let turn_B_21 = w_B_12 + alpha_B_3;
    let turn_B_23 = w_B_23 + alpha_B_1;
    let a_Bo_2 = (-xB).mul_add(turn_B_21, a_RC_2) - turn_B_23 * rr_plus_zb;
    let x_B_2 = mB * a_Bo_2;
    let w_B_11 = w_L_in_B_1 * w_L_in_B_1;
    let turn_B_33 = w_B_22 + w_B_11;
    let turn_B_31 = w_B_13 - alpha_B_2;
    let a_L_in_B_3 = a_RC_3.mul_add(cos_theta, a_RC_1 * sin_theta);
    let a_Bo_3 = (-xB).mul_add(turn_B_31, turn_B_33 * rr_plus_zb) - a_L_in_B_3;
    let x_B_3 = mB * a_Bo_3;
    let H_frame_2 = IByy * w_B_2;
    let H_frame_3 = IBzz.mul_add(w_L_in_B_3, IBxz * w_L_in_B_1);
    let x_B_1_2 = (-IBxx).mul_add(alpha_B_1, IBxz * alpha_B_3) - w_L_in_B_3 * H_frame_2
        + w_B_2 * H_frame_3;
    let H_frame_1 = IBxz.mul_add(w_L_in_B_3, IBxx * w_L_in_B_1);
    let x_B_2_2 = (-w_L_in_B_1).mul_add(H_frame_3, IByy * alpha_B_2) + w_L_in_B_3 * H_frame_1;
    let x_B_3_2 = (-IBxz).mul_add(alpha_B_1, IBzz * alpha_B_3) + w_L_in_B_1 * H_frame_2
        - w_B_2 * H_frame_1;
    let w_B_in_S_1 = (-w_L_in_B_1).mul_add(cos_lam, w_L_in_B_3 * sin_lam);
    let w_B_in_S_3 = w_L_in_B_3.mul_add(cos_lam, w_L_in_B_1 * sin_lam);
    let w_S_in_F_1 = (-w_B_2).mul_add(sin_delta, w_B_in_S_1 * cos_delta);
    let w_S_in_F_2 = w_B_in_S_1.mul_add(sin_delta, w_B_2 * cos_delta);
    let w_F_3 = u2 + w_B_in_S_3;
    let w_S_12 = w_B_2 * w_B_in_S_1;
    let w_S_13 = w_B_in_S_1 * w_B_in_S_3;
    let w_S_33 = w_B_in_S_3 * w_B_in_S_3;
    let turn_S_11 = w_B_22 + w_S_33;
    let w_F_11 = w_S_in_F_1 * w_S_in_F_1;
    let w_F_13 = w_S_in_F_1 * w_F_3;
    let w_F_22 = w_S_in_F_2 * w_S_in_F_2;
    let w_F_33 = w_F_3 * w_F_3;
    let turn_F_11 = w_F_22 + w_F_33;
    let turn_F_33 = w_F_11 + w_F_22;
    let alpha_B_in_S_1 = alpha_B_3.mul_add(sin_lam, alpha_B_1 * cos_lam);
    let alpha_B_in_S_3 = (-alpha_B_1).mul_add(sin_lam, alpha_B_3 * cos_lam);
    let turn_S_21 = w_S_12 - alpha_B_in_S_3;
    let turn_S_31 = alpha_B_2 + w_S_13;
    let alpha_S_in_F_2 = alpha_B_in_S_1.mul_add(sin_delta, alpha_B_2 * cos_delta);
    let alpha_F_2 = u2.mul_add(w_S_in_F_1, alpha_S_in_F_2);
    let turn_F_13 = w_F_13 - alpha_F_2;
    let turn_F_31 = w_F_13 + alpha_F_2;
    let a_B_in_S_1 = a_L_in_B_3.mul_add(sin_lam, a_L_in_B_1 * cos_lam);
    let a_B_in_S_3 = (-a_L_in_B_1).mul_add(sin_lam, a_L_in_B_3 * cos_lam);
    let a_Ho_1 = turn_S_11.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_B_in_S_1);
    let a_Ho_2 = turn_S_21.mul_add(ratio_theta_u1_of_w_c_lam_rr, a_RC_2);
    let a_Ho_3 = turn_S_31.mul_add(ratio_theta_u1_of_w_c_lam_rr, -a_B_in_S_3);
    let a_S_in_F_1 = a_Ho_2.mul_add(sin_delta, a_Ho_1 * cos_delta);
    let rr_plus_zh = rR + zH;
    let a_Ho_1_2_of_lam_rr_xh_zh = (-rr_plus_zh).mul_add(sin_lam, xH * cos_lam);
    let a_Ho_1_2_of_place = ratio_theta_u1_of_w_c_lam_rr - a_Ho_1_2_of_lam_rr_xh_zh;
    let a_Ho_1_2_of_lam_rr_xh_zh_2 = rr_plus_zh.mul_add(cos_lam, xH * sin_lam);
    let a_Ho_1_2 = turn_F_11.mul_add(a_Ho_1_2_of_place, -a_S_in_F_1)
        - turn_F_13 * a_Ho_1_2_of_lam_rr_xh_zh_2;
    let a_Ho_3_2 = (-turn_F_31).mul_add(a_Ho_1_2_of_place, a_Ho_3)
        + turn_F_33 * a_Ho_1_2_of_lam_rr_xh_zh_2;
    let x_H_1 = mH * a_Ho_1_2;
    let x_H_3 = mH * a_Ho_3_2;
    let x_F_in_H_1 = (-x_H_1).mul_add(cos_lam, x_H_3 * sin_lam);
    let w_F_12 = w_S_in_F_1 * w_S_in_F_2;
    let w_F_23 = w_S_in_F_2 * w_F_3;
    let alpha_S_in_F_1 = (-alpha_B_2).mul_add(sin_delta, alpha_B_in_S_1 * cos_delta);
    let alpha_F_1 = u2.mul_add(w_S_in_F_2, -alpha_S_in_F_1);
    let turn_F_21 = w_F_12 - alpha_B_in_S_3;
    let turn_F_23 = w_F_23 - alpha_F_1;
    let a_S_in_F_2 = (-a_Ho_2).mul_add(cos_delta, a_Ho_1 * sin_delta);
    let a_Ho_2_2 = turn_F_21.mul_add(a_Ho_1_2_of_place, a_S_in_F_2)
        + turn_F_23 * a_Ho_1_2_of_lam_rr_xh_zh_2;
    let x_H_2 = mH * a_Ho_2_2;
    let x_F_in_H_3 = x_H_3.mul_add(cos_lam, x_H_1 * sin_lam);
    let w_F_in_H_1 = (-w_S_in_F_1).mul_add(cos_lam, w_F_3 * sin_lam);
    let w_F_in_H_3 = w_F_3.mul_add(cos_lam, w_S_in_F_1 * sin_lam);
    let H_fork_2 = IHyy * w_S_in_F_2;
    let H_fork_3 = IHzz.mul_add(w_F_in_H_3, IHxz * w_F_in_H_1);
    let alpha_F_in_H_1 = alpha_F_1.mul_add(cos_lam, alpha_B_in_S_3 * sin_lam);
    let alpha_F_in_H_3 = (-alpha_F_1).mul_add(sin_lam, alpha_B_in_S_3 * cos_lam);
    let x_H_1_2 = (-w_F_in_H_3).mul_add(H_fork_2, w_S_in_F_2 * H_fork_3)
        + IHxx * alpha_F_in_H_1 + IHxz * alpha_F_in_H_3;
    let H_fork_1 = IHxz.mul_add(w_F_in_H_3, IHxx * w_F_in_H_1);
    let x_H_2_2 = (-w_F_in_H_1).mul_add(H_fork_3, IHyy * alpha_F_2) + w_F_in_H_3 * H_fork_1;
    let x_H_3_2 = IHxz.mul_add(alpha_F_in_H_1, w_F_in_H_1 * H_fork_2)
        + IHzz * alpha_F_in_H_3 - w_S_in_F_2 * H_fork_1;
    let a_FC_1 = turn_F_11.mul_add(ratio_psi_u1_of_c_lam_rf, a_S_in_F_1)
        + turn_F_13 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_1 = mF * a_FC_1;
    let a_FC_2 = (-turn_F_21).mul_add(ratio_psi_u1_of_c_lam_rf, a_S_in_F_2)
        + turn_F_23 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2 = mF * a_FC_2;
    let a_FC_3 = turn_F_31.mul_add(ratio_psi_u1_of_c_lam_rf, a_Ho_3)
        + turn_F_33 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_3 = mF * a_FC_3;
    let x_S_in_B_3_2 = sin_lam * cos_delta;
    let ratio_thF_u1_of_place = sin_phi_cos_delta
        .mul_add(S::int(2), x_F_in_S_3_2_of_place_2);
    let ratio_thF_u1_of_place_2 = S::int(1)
        / (sin_phi_cos_delta.mul_add(sin_phi_cos_delta, -S::int(1))
            + x_F_in_S_3_2_of_place_2 * ratio_thF_u1_of_place);
    let ratio_thF_u1_of_place_3 = x_F_in_S_3_2_of_place_3 * ratio_thF_u1_of_place_2;
    let ratio_thF_u1_of_place_4 = (S::int(1) - sin_phi * sin_phi * cos_delta * cos_delta
        - cos_phi * sin_lam_plus_theta * sin_delta
            * sin_phi_cos_delta.mul_add(S::int(2), x_F_in_S_3_2_of_place_6))
        .sqrt();
    let ratio_thF_u1_of_place_5 = (ratio_thF_u1_of_place_3 * sin_delta)
        .mul_add(ratio_thF_u1_of_place_4, -x_S_in_B_3_2);
    let ratio_thF_u1_of_place_6 = rr_sin_lam - cos_lam * (w + c * (S::int(1) - cos_delta));
    let ratio_thF_u1_of_place_7 = rF
        .mul_add(ratio_thF_u1_of_place_5, ratio_thF_u1_of_place_6);
    let ratio_thF_u1_of_place_8 = (-ratio_thF_u1_of_place_7)
        .mul_add(cos_lam_plus_theta, ratio_theta_u1_of_w_lam_rr_rf * sin_lam_plus_theta);
    let rf_inv = S::int(1) / rF;
    let ratio_thF_u1_of_place_9 = ratio_psi_u1_of_place_16 * ratio_thF_u1_of_place_4;
    let ratio_thF_u1_of_place_10 = rf_inv * ratio_thF_u1_of_place_9;
    let ratio_thF_u1_of_place_11 = ratio_thF_u1_of_place_8 * ratio_thF_u1_of_place_10;
    let ratio_thF_u1_of_place_12 = -x_F_in_S_3_2_of_place_3 * ratio_psi_u1_of_place_2;
    let ratio_thF_u1_of_place_13 = (-ratio_theta_u1_of_place)
        .mul_add(
            ratio_theta_u1_of_w_lam_rr_rf,
            ratio_psi_u1_of_c_lam_rf * x_F_in_S_3_2_of_place_8,
        );
    let ratio_thF_u1_of_place_14 = x_F_in_S_3_2_of_place_3 * ratio_theta_u1_of_place_3;
    let ratio_thF_u1_of_place_15 = ratio_thF_u1_of_place_12
        .mul_add(sin_lam_plus_theta, ratio_theta_u1_of_place_14)
        + ratio_psi_u1_of_place * ratio_thF_u1_of_place_13
        - ratio_psi_u1_of_place_4 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_of_place_16 = ratio_thF_u1_of_place_10 * ratio_thF_u1_of_place_15;
    let ratio_thF_u1 = (-ratio_psi_u1_of_place_20)
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u1_of_place_12 * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u2 = ratio_psi_u2_of_place_2
        .mul_add(
            ratio_thF_u1_of_place_16,
            ratio_psi_u2_of_place * ratio_thF_u1_of_place_11,
        );
    let ratio_thF_u3_of_place = (-ratio_thF_u1_of_place_6)
        .mul_add(rf_inv, -ratio_thF_u1_of_place_5);
    let ratio_thF_u3_of_w_lam_rr_rf = cos_lam - rf_inv * rR.mul_add(cos_lam, w_sin_lam);
    let ratio_thF_u3_of_place_2 = (-ratio_thF_u3_of_w_lam_rr_rf)
        .mul_add(sin_lam_plus_theta, ratio_thF_u3_of_place * cos_lam_plus_theta);
    let ratio_thF_u3_of_place_3 = rR * ratio_thF_u1_of_place_9;
    let ratio_thF_u3 = ratio_thF_u3_of_place_2 * ratio_thF_u3_of_place_3;
    let w_F_in_FW_1 = w_F_3.mul_add(sin_thF, w_S_in_F_1 * cos_thF);
    let w_F_in_FW_3 = (-w_S_in_F_1).mul_add(sin_thF, w_F_3 * cos_thF);
    let w_FW_in_F_2_of_u1_u2 = u2.mul_add(ratio_thF_u2, u1 * ratio_thF_u1);
    let w_FW_in_F_2 = u3.mul_add(ratio_thF_u3, w_FW_in_F_2_of_u1_u2);
    let w_FW_2 = w_S_in_F_2 + w_FW_in_F_2;
    let H_front_wheel_2 = IFyy * w_FW_2;
    let H_front_wheel_3 = IFxx * w_F_3;
    let sin_thf_w_fw_in_f_2 = w_FW_in_F_2 * sin_thF;
    let cos_thf_w_fw_in_f_2 = w_FW_in_F_2 * cos_thF;
    let alpha_FW_in_F_1 = w_F_in_FW_3
        .mul_add(cos_thf_w_fw_in_f_2, w_F_in_FW_1 * sin_thf_w_fw_in_f_2);
    let alpha_FW_1 = alpha_FW_in_F_1 - alpha_F_1;
    let w_s_in_f_2_minus_w_fw_2 = w_S_in_F_2 - w_FW_2;
    let x_F_1_2 = w_S_in_F_2 * H_front_wheel_3 - w_F_3 * H_front_wheel_2
        - IFxx * w_F_3.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_1);
    let ratio_thF_u1_2_of_u1_u2 = S::int(2) * ratio_theta_u1_2_of_u1_u2_6;
    let ratio_thF_u1_2_of_u1_u2_2 = -ratio_theta_u1_2_of_u1_u2_7 * ratio_thF_u1_of_place
        - sin_phi_cos_delta * ratio_thF_u1_2_of_u1_u2
        - x_F_in_S_3_2_of_place_2 * (ratio_theta_u1_2_of_u1_u2_7 + ratio_thF_u1_2_of_u1_u2);
    let ratio_thF_u1_2_of_u1_u2_3 = ratio_thF_u1_of_place_2
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_2,
            S::int(2) * ratio_psi_u1_of_place_16 * ratio_psi_u1_2_of_u1_u2_18,
        );
    let ratio_thF_u1_2_of_u1_u2_4 = sin_lam_plus_theta
        * (-ratio_psi_u1_of_place_2)
            .mul_add(
                ratio_theta_u1_2_of_u1_u2_8,
                x_F_in_S_3_2_of_place_3 * ratio_theta_u1_2_of_u1_u2_9,
            )
        - ratio_psi_u1_of_place
            * ratio_psi_u1_of_c_lam_rf
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_11,
                    ratio_theta_u1_of_w_lam_rr_rf * ratio_theta_u1_2_of_u1_u2_5,
                )
        - ratio_psi_u1_of_place_4
            * x_F_in_S_3_2_of_place_3
                .mul_add(
                    ratio_theta_u1_2_of_u1_u2_12,
                    ratio_theta_u1_of_place_3 * ratio_theta_u1_2_of_u1_u2_8,
                ) + ratio_theta_u1_2_of_u1_u2_24
        + ratio_psi_u1_2_of_u1_u2_3 * ratio_thF_u1_of_place_12
        - ratio_psi_u1_2_of_u1_u2 * ratio_thF_u1_of_place_13
        + ratio_psi_u1_2_of_u1_u2_8 * ratio_thF_u1_of_place_14;
    let ratio_thF_u1_2_of_u1_u2_5 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_2_of_u1_u2_4
            .mul_add(S::int(2), ratio_thF_u1_of_place_15 * ratio_thF_u1_2_of_u1_u2_3);
    let u2_sin_delta_doubled = S::int(2) * u2_sin_delta;
    let ratio_thF_u1_2_of_u1_u2_6 = ratio_thF_u1_of_place_2 * ratio_thF_u1_of_place_4
        * (sin_delta
            * (-ratio_thF_u1_of_place_3)
                .mul_add(
                    ratio_thF_u1_2_of_u1_u2_2,
                    S::int(2) * ratio_theta_u1_2_of_u1_u2_8,
                ) + S::int(2) * x_F_in_S_3_2_of_place_3 * u2_cos_delta)
        + u2_sin_delta_doubled * sin_lam;
    let ratio_thF_u1_2_of_u2 = c_cos_lam * u2_sin_delta_doubled;
    let ratio_thF_u1_2_of_u1_u2_7 = S::int(2) * ratio_psi_u1_2_of_u1_u2_3;
    let ratio_thF_u1_2_of_u1_u2_8 = cos_lam_plus_theta
        * (-rF).mul_add(ratio_thF_u1_2_of_u1_u2_6, ratio_thF_u1_2_of_u2)
        + ratio_psi_u1_2_of_u1_u2_6 * ratio_thF_u1_of_place_7
        + ratio_theta_u1_of_w_lam_rr_rf * ratio_thF_u1_2_of_u1_u2_7;
    let ratio_thF_u1_2_of_u1_u2_9 = ratio_thF_u1_of_place_10
        * ratio_thF_u1_of_place_8
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, ratio_thF_u1_2_of_u1_u2_8);
    let ratio_thF_u1_2_of_place = S::int(2) * ratio_thF_u1_of_place_11;
    let ratio_thF_u1_2_of_place_2 = S::int(2) * ratio_thF_u1_of_place_16;
    let ratio_thF_u1_2 = (-ratio_psi_u1_of_place_20)
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_5,
            ratio_psi_u1_of_place_12 * ratio_thF_u1_2_of_u1_u2_9,
        ) - ratio_psi_u1_2_of_u1_u2_14 * ratio_thF_u1_2_of_place
        + ratio_psi_u1_2_of_u1_u2_16 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u2_2 = ratio_psi_u2_of_place
        .mul_add(
            ratio_thF_u1_2_of_u1_u2_9,
            ratio_psi_u2_of_place_2 * ratio_thF_u1_2_of_u1_u2_5,
        ) + ratio_psi_u2_2_of_u1_u2 * ratio_thF_u1_2_of_place
        - ratio_psi_u2_2_of_u1_u2_2 * ratio_thF_u1_2_of_place_2;
    let ratio_thF_u3_2_of_u1_u2 = cos_lam_plus_theta
        * (-rf_inv).mul_add(ratio_thF_u1_2_of_u2, ratio_thF_u1_2_of_u1_u2_6)
        + ratio_psi_u1_2_of_u1_u2_6 * ratio_thF_u3_of_place
        + ratio_thF_u3_of_w_lam_rr_rf * ratio_thF_u1_2_of_u1_u2_7;
    let ratio_thF_u3_2 = ratio_thF_u3_of_place_3
        * ratio_thF_u3_of_place_2
            .mul_add(ratio_thF_u1_2_of_u1_u2_3, -ratio_thF_u3_2_of_u1_u2);
    let H_front_wheel_1 = IFxx * w_S_in_F_1;
    let alpha_FW_in_F_2 = u2.mul_add(ratio_thF_u2_2, u1 * ratio_thF_u1_2) + u3 * ratio_thF_u3_2;
    let alpha_FW_2 = alpha_F_2.mul_add(S::int(2), alpha_FW_in_F_2);
    let x_F_2_2_of_place = (-w_F_3)
        .mul_add(H_front_wheel_1, w_S_in_F_1 * H_front_wheel_3);
    let x_F_2_2 = (-x_F_2_2_of_place).mul_add(S::int(2), -IFyy * alpha_FW_2);
    let alpha_FW_in_F_3 = (-w_F_in_FW_3)
        .mul_add(sin_thf_w_fw_in_f_2, w_F_in_FW_1 * cos_thf_w_fw_in_f_2);
    let alpha_FW_3 = alpha_FW_in_F_3 - alpha_B_in_S_3;
    let x_F_3_2 = w_S_in_F_1 * H_front_wheel_2 - w_S_in_F_2 * H_front_wheel_1
        + IFxx * w_S_in_F_1.mul_add(w_s_in_f_2_minus_w_fw_2, alpha_FW_3);
    let w_Y_in_L_2_2 = ratio_psi_u1 * sin_phi;
    let x_F_1_3 = rR * w_Y_in_L_2_2;
    let x_L_1_3 = mR * x_F_1_3;
    let w_Y_in_L_2_3 = ratio_psi_u2 * sin_phi;
    let x_F_1_4 = rR * w_Y_in_L_2_3;
    let x_L_1_4 = mR * x_F_1_4;
    let w_Y_in_L_2_4 = ratio_psi_u3 * sin_phi;
    let x_F_1_5 = rR.mul_add(w_Y_in_L_2_4, -x_N_in_Y_1);
    let x_L_1_5 = mR * x_F_1_5;
    let x_L_2_3 = rR * mR;
    let x_L_in_Y_2 = rR * sin_phi;
    let x_Y_in_N_1 = x_L_in_Y_2 * sin_psi;
    let x_Y_in_N_2 = x_L_in_Y_2 * cos_psi;
    let x_N_in_Y_1_2 = x_Y_in_N_2.mul_add(cos_psi, x_Y_in_N_1 * sin_psi);
    let x_L_2_4 = IRyy * w_Y_in_L_2_2;
    let x_L_2_5 = IRyy * w_Y_in_L_2_3;
    let w_RW_2_2 = w_Y_in_L_2_4 - S::int(1);
    let x_L_2_6 = IRyy * w_RW_2_2;
    let x_Y_in_L_2 = x_L_in_Y_2.mul_add(sin_phi, x_L_in_Y_3 * cos_phi);
    let x_N_in_Y_2 = (-x_Y_in_N_1).mul_add(cos_psi, x_Y_in_N_2 * sin_psi);
    let x_Y_in_L_2_2 = x_N_in_Y_2 * cos_phi;
    let w_Y_in_L_3_2 = ratio_psi_u1 * cos_phi;
    let x_L_3_3 = IRxx * w_Y_in_L_3_2;
    let w_Y_in_L_3_3 = ratio_psi_u2 * cos_phi;
    let x_L_3_4 = IRxx * w_Y_in_L_3_3;
    let w_Y_in_L_3_4 = ratio_psi_u3 * cos_phi;
    let x_L_3_5 = IRxx * w_Y_in_L_3_4;
    let x_Y_in_L_3 = (-x_L_in_Y_2).mul_add(cos_phi, x_L_in_Y_3 * sin_phi);
    let x_Y_in_L_3_2 = x_N_in_Y_2 * sin_phi;
    let w_B_2_2 = ratio_theta_u1 - w_Y_in_L_2_2;
    let x_L_in_B_1 = x_F_1_3 * cos_theta;
    let a_Bo_1_2 = w_B_2_2.mul_add(rr_plus_zb, x_L_in_B_1);
    let x_B_1_3 = mB * a_Bo_1_2;
    let w_B_2_3 = ratio_theta_u2 - w_Y_in_L_2_3;
    let x_L_in_B_1_2 = x_F_1_4 * cos_theta;
    let a_Bo_1_3 = w_B_2_3.mul_add(rr_plus_zb, x_L_in_B_1_2);
    let x_B_1_4 = mB * a_Bo_1_3;
    let x_L_in_B_1_3 = x_F_1_5 * cos_theta;
    let a_Bo_1_4 = (-w_Y_in_L_2_4).mul_add(rr_plus_zb, x_L_in_B_1_3);
    let x_B_1_5 = mB * a_Bo_1_4;
    let x_L_in_B_1_4 = cos_theta.mul_add(cos_thR, sin_theta * sin_thR);
    let x_L_in_B_1_5 = (-cos_theta).mul_add(sin_thR, sin_theta * cos_thR);
    let w_L_in_B_1_2 = w_Y_in_L_3_2.mul_add(sin_theta, cos_theta);
    let w_L_in_B_3_2 = (-w_Y_in_L_3_2).mul_add(cos_theta, sin_theta);
    let a_Bo_2_2 = xB.mul_add(w_L_in_B_3_2, rR) - w_L_in_B_1_2 * rr_plus_zb;
    let x_B_2_3 = mB * a_Bo_2_2;
    let w_L_in_B_1_3 = w_Y_in_L_3_3 * sin_theta;
    let w_L_in_B_3_3 = w_Y_in_L_3_3 * cos_theta;
    let a_Bo_2_3 = w_L_in_B_1_3.mul_add(rr_plus_zb, xB * w_L_in_B_3_3);
    let x_B_2_4 = mB * a_Bo_2_3;
    let w_L_in_B_1_4 = w_Y_in_L_3_4 * sin_theta;
    let w_L_in_B_3_4 = w_Y_in_L_3_4 * cos_theta;
    let a_Bo_2_4 = w_L_in_B_1_4.mul_add(rr_plus_zb, xB * w_L_in_B_3_4);
    let x_B_2_5 = mB * a_Bo_2_4;
    let x_L_in_B_3 = x_F_1_3 * sin_theta;
    let a_Bo_3_2 = (-xB).mul_add(w_B_2_2, x_L_in_B_3);
    let x_B_3_3 = mB * a_Bo_3_2;
    let x_L_in_B_3_2 = x_F_1_4 * sin_theta;
    let a_Bo_3_3 = (-xB).mul_add(w_B_2_3, x_L_in_B_3_2);
    let x_B_3_4 = mB * a_Bo_3_3;
    let x_L_in_B_3_3 = x_F_1_5 * sin_theta;
    let a_Bo_3_4 = xB.mul_add(w_Y_in_L_2_4, x_L_in_B_3_3);
    let x_B_3_5 = mB * a_Bo_3_4;
    let x_B_1_6 = IBxz.mul_add(w_L_in_B_3_2, IBxx * w_L_in_B_1_2);
    let x_B_1_7 = (-IBxz).mul_add(w_L_in_B_3_3, IBxx * w_L_in_B_1_3);
    let x_B_1_8 = (-IBxz).mul_add(w_L_in_B_3_4, IBxx * w_L_in_B_1_4);
    let x_S_in_B_3 = ratio_theta_u1_of_w_c_lam_rr * sin_lam;
    let x_B_3_6 = x_S_in_B_3 + rr_plus_zb;
    let x_S_in_B_1 = cos_lam * cos_delta;
    let x_B_in_L_1 = rr_plus_zb.mul_add(sin_theta, xB * cos_theta);
    let x_B_in_L_3 = (-xB).mul_add(sin_theta, rr_plus_zb * cos_theta);
    let x_L_in_RW_1 = (-x_B_in_L_1).mul_add(cos_thR, x_B_in_L_3 * sin_thR);
    let x_L_in_RW_3 = x_B_in_L_3.mul_add(cos_thR, x_B_in_L_1 * sin_thR);
    let x_RW_in_L_1 = x_L_in_RW_3.mul_add(cos_thR, x_L_in_RW_1 * sin_thR);
    let x_RW_in_L_3 = (-x_L_in_RW_3).mul_add(sin_thR, x_L_in_RW_1 * cos_thR);
    let x_L_in_B_1_6 = (-x_RW_in_L_1).mul_add(cos_theta, x_RW_in_L_3 * sin_theta);
    let x_B_2_6 = IByy * w_B_2_2;
    let x_B_2_7 = IByy * w_B_2_3;
    let x_B_2_8 = IByy * w_Y_in_L_2_4;
    let x_S_in_B_1_2 = ratio_theta_u1_of_w_c_lam_rr * cos_lam;
    let x_B_1_9 = xB - x_S_in_B_1_2;
    let x_B_3_7 = IBzz.mul_add(w_L_in_B_3_2, IBxz * w_L_in_B_1_2);
    let x_B_3_8 = (-IBzz).mul_add(w_L_in_B_3_3, IBxz * w_L_in_B_1_3);
    let x_B_3_9 = (-IBzz).mul_add(w_L_in_B_3_4, IBxz * w_L_in_B_1_4);
    let x_L_in_B_3_4 = x_RW_in_L_3.mul_add(cos_theta, x_RW_in_L_1 * sin_theta);
    let w_B_in_S_1_2 = (-w_L_in_B_1_2).mul_add(cos_lam, w_L_in_B_3_2 * sin_lam);
    let w_B_in_S_3_2 = w_L_in_B_3_2.mul_add(cos_lam, w_L_in_B_1_2 * sin_lam);
    let w_S_in_F_2_2 = w_B_in_S_1_2.mul_add(sin_delta, w_B_2_2 * cos_delta);
    let x_B_in_S_1 = (-x_L_in_B_1).mul_add(cos_lam, x_L_in_B_3 * sin_lam);
    let x_B_in_S_3 = x_L_in_B_3.mul_add(cos_lam, x_L_in_B_1 * sin_lam);
    let x_F_2_3 = w_B_in_S_3_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, rR);
    let x_F_3_3 = w_B_2_2.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3);
    let x_S_in_F_1 = (-x_F_2_3).mul_add(sin_delta, x_B_in_S_1 * cos_delta);
    let a_Ho_1_3 = (-w_S_in_F_2_2).mul_add(a_Ho_1_2_of_lam_rr_xh_zh_2, x_S_in_F_1);
    let a_Ho_3_3 = (-w_S_in_F_2_2).mul_add(a_Ho_1_2_of_place, x_F_3_3);
    let x_H_1_3 = mH * a_Ho_1_3;
    let x_H_3_3 = mH * a_Ho_3_3;
    let x_F_in_H_1_2 = x_H_3_3.mul_add(sin_lam, x_H_1_3 * cos_lam);
    let w_B_in_S_1_3 = w_L_in_B_3_3.mul_add(sin_lam, w_L_in_B_1_3 * cos_lam);
    let w_B_in_S_3_3 = (-w_L_in_B_1_3).mul_add(sin_lam, w_L_in_B_3_3 * cos_lam);
    let w_S_in_F_2_3 = (-w_B_2_3).mul_add(cos_delta, w_B_in_S_1_3 * sin_delta);
    let x_B_in_S_1_2 = (-x_L_in_B_1_2).mul_add(cos_lam, x_L_in_B_3_2 * sin_lam);
    let x_B_in_S_3_2 = x_L_in_B_3_2.mul_add(cos_lam, x_L_in_B_1_2 * sin_lam);
    let x_F_2_4 = w_B_in_S_3_3 * ratio_theta_u1_of_w_c_lam_rr;
    let x_F_3_4 = w_B_2_3.mul_add(ratio_theta_u1_of_w_c_lam_rr, -x_B_in_S_3_2);
    let x_S_in_F_1_2 = x_F_2_4.mul_add(sin_delta, x_B_in_S_1_2 * cos_delta);
    let a_Ho_1_4 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_lam_rr_xh_zh_2, x_S_in_F_1_2);
    let a_Ho_3_4 = w_S_in_F_2_3.mul_add(a_Ho_1_2_of_place, x_F_3_4);
    let x_H_1_4 = mH * a_Ho_1_4;
    let x_H_3_4 = mH * a_Ho_3_4;
    let x_F_in_H_1_3 = x_H_3_4.mul_add(sin_lam, x_H_1_4 * cos_lam);
    let w_B_in_S_1_4 = w_L_in_B_3_4.mul_add(sin_lam, w_L_in_B_1_4 * cos_lam);
    let w_B_in_S_3_4 = (-w_L_in_B_1_4).mul_add(sin_lam, w_L_in_B_3_4 * cos_lam);
    let w_S_in_F_2_4 = w_B_in_S_1_4.mul_add(sin_delta, w_Y_in_L_2_4 * cos_delta);
    let x_B_in_S_1_3 = (-x_L_in_B_1_3).mul_add(cos_lam, x_L_in_B_3_3 * sin_lam);
    let x_B_in_S_3_3 = x_L_in_B_3_3.mul_add(cos_lam, x_L_in_B_1_3 * sin_lam);
    let x_F_2_5 = w_B_in_S_3_4 * ratio_theta_u1_of_w_c_lam_rr;
    let x_F_3_5 = w_Y_in_L_2_4.mul_add(ratio_theta_u1_of_w_c_lam_rr, x_B_in_S_3_3);
    let x_S_in_F_1_3 = x_F_2_5.mul_add(sin_delta, x_B_in_S_1_3 * cos_delta);
    let a_Ho_1_5 = w_S_in_F_2_4.mul_add(a_Ho_1_2_of_lam_rr_xh_zh_2, x_S_in_F_1_3);
    let a_Ho_3_5 = (-w_S_in_F_2_4).mul_add(a_Ho_1_2_of_place, x_F_3_5);
    let x_H_1_5 = mH * a_Ho_1_5;
    let x_H_3_5 = mH * a_Ho_3_5;
    let x_F_in_H_1_4 = (-x_H_1_5).mul_add(cos_lam, x_H_3_5 * sin_lam);
    let x_F_in_H_1_5 = x_S_in_B_1.mul_add(cos_lam, sin_lam * sin_lam);
    let x_F_in_H_1_6 = cos_lam * sin_delta;
    let cos_lam_sin_lam = sin_lam * cos_lam;
    let x_F_in_H_1_7 = (-x_S_in_B_3_2).mul_add(cos_lam, cos_lam_sin_lam);
    let w_S_in_F_1_2 = (-w_B_2_2).mul_add(sin_delta, w_B_in_S_1_2 * cos_delta);
    let x_S_in_F_2 = x_F_2_3.mul_add(cos_delta, x_B_in_S_1 * sin_delta);
    let a_Ho_2_3 = (-w_B_in_S_3_2).mul_add(a_Ho_1_2_of_place, x_S_in_F_2)
        + w_S_in_F_1_2 * a_Ho_1_2_of_lam_rr_xh_zh_2;
    let x_H_2_3 = mH * a_Ho_2_3;
    let w_S_in_F_1_3 = w_B_in_S_1_3.mul_add(cos_delta, w_B_2_3 * sin_delta);
    let w_F_3_2 = w_B_in_S_3_3 - S::int(1);
    let x_S_in_F_2_2 = (-x_F_2_4).mul_add(cos_delta, x_B_in_S_1_2 * sin_delta);
    let a_Ho_2_4 = w_F_3_2.mul_add(a_Ho_1_2_of_place, x_S_in_F_2_2)
        - w_S_in_F_1_3 * a_Ho_1_2_of_lam_rr_xh_zh_2;
    let x_H_2_4 = mH * a_Ho_2_4;
    let w_S_in_F_1_4 = (-w_Y_in_L_2_4).mul_add(sin_delta, w_B_in_S_1_4 * cos_delta);
    let x_S_in_F_2_3 = (-x_F_2_5).mul_add(cos_delta, x_B_in_S_1_3 * sin_delta);
    let a_Ho_2_5 = w_B_in_S_3_4.mul_add(a_Ho_1_2_of_place, x_S_in_F_2_3)
        - w_S_in_F_1_4 * a_Ho_1_2_of_lam_rr_xh_zh_2;
    let x_H_2_5 = mH * a_Ho_2_5;
    let x_S_in_F_2_4 = sin_lam * sin_delta;
    let x_F_in_H_3_2 = (-x_H_1_3).mul_add(sin_lam, x_H_3_3 * cos_lam);
    let x_F_in_H_3_3 = (-x_H_1_4).mul_add(sin_lam, x_H_3_4 * cos_lam);
    let x_F_in_H_3_4 = x_H_3_5.mul_add(cos_lam, x_H_1_5 * sin_lam);
    let x_F_in_H_3_5 = (-x_S_in_B_1).mul_add(sin_lam, cos_lam_sin_lam);
    let x_F_in_H_3_6 = x_S_in_B_3_2.mul_add(sin_lam, cos_lam * cos_lam);
    let alpha_F_in_H_1_2 = (-w_S_in_F_1_2).mul_add(cos_lam, w_B_in_S_3_2 * sin_lam);
    let alpha_F_in_H_3_2 = w_S_in_F_1_2.mul_add(sin_lam, w_B_in_S_3_2 * cos_lam);
    let x_H_1_6 = IHxz.mul_add(alpha_F_in_H_3_2, IHxx * alpha_F_in_H_1_2);
    let alpha_F_in_H_1_3 = (-w_S_in_F_1_3).mul_add(cos_lam, w_F_3_2 * sin_lam);
    let alpha_F_in_H_3_3 = w_F_3_2.mul_add(cos_lam, w_S_in_F_1_3 * sin_lam);
    let x_H_1_7 = IHxz.mul_add(alpha_F_in_H_3_3, IHxx * alpha_F_in_H_1_3);
    let alpha_F_in_H_1_4 = (-w_S_in_F_1_4).mul_add(cos_lam, w_B_in_S_3_4 * sin_lam);
    let alpha_F_in_H_3_4 = w_S_in_F_1_4.mul_add(sin_lam, w_B_in_S_3_4 * cos_lam);
    let x_H_1_8 = IHxz.mul_add(alpha_F_in_H_3_4, IHxx * alpha_F_in_H_1_4);
    let x_F_1_6 = a_Ho_1_2_of_place - ratio_theta_u1_of_c_lam_rf;
    let x_F_3_6 = a_Ho_1_2_of_lam_rr_xh_zh_2 - ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_in_H_1_8 = x_F_3_6.mul_add(cos_lam, x_F_1_6 * sin_lam);
    let x_F_in_S_1 = a_Ho_1_2_of_place * cos_delta;
    let x_F_in_S_2 = a_Ho_1_2_of_place * sin_delta;
    let x_F_in_S_3 = a_Ho_1_2_of_lam_rr_xh_zh_2;
    let x_S_in_B_3_3 = x_F_in_S_3.mul_add(cos_lam, x_F_in_S_1 * sin_lam);
    let x_B_in_S_1_4 = x_F_in_S_2 * sin_lam;
    let x_B_in_S_1_5 = x_F_in_S_2 * cos_lam;
    let x_S_in_F_1_4 = (-x_S_in_B_3_3).mul_add(sin_delta, x_B_in_S_1_4 * cos_delta);
    let x_F_in_H_1_9 = (-x_S_in_F_1_4).mul_add(cos_lam, x_B_in_S_1_5 * sin_lam);
    let x_S_in_B_1_3 = (-x_F_in_S_1).mul_add(cos_lam, x_F_in_S_3 * sin_lam);
    let x_B_in_S_1_6 = x_S_in_B_1_3.mul_add(sin_lam, x_S_in_B_3_3 * cos_lam);
    let x_B_in_S_3_4 = (-x_S_in_B_3_3).mul_add(sin_lam, x_S_in_B_1_3 * cos_lam);
    let x_S_in_F_1_5 = x_B_in_S_1_6 * cos_delta;
    let x_F_in_H_1_10 = (-x_S_in_F_1_5).mul_add(cos_lam, x_B_in_S_3_4 * sin_lam);
    let x_S_in_F_1_6 = x_S_in_B_1_3.mul_add(sin_delta, x_B_in_S_1_5 * cos_delta);
    let x_F_in_H_1_11 = x_S_in_F_1_6.mul_add(cos_lam, x_B_in_S_1_4 * sin_lam);
    let x_H_2_6 = IHyy * w_S_in_F_2_2;
    let x_H_2_7 = IHyy * w_S_in_F_2_3;
    let x_H_2_8 = IHyy * w_S_in_F_2_4;
    let x_S_in_F_2_5 = x_B_in_S_1_4.mul_add(sin_delta, x_S_in_B_3_3 * cos_delta);
    let x_S_in_F_2_6 = x_B_in_S_1_6 * sin_delta;
    let x_S_in_F_2_7 = (-x_S_in_B_1_3).mul_add(cos_delta, x_B_in_S_1_5 * sin_delta);
    let x_H_3_6 = IHzz.mul_add(alpha_F_in_H_3_2, IHxz * alpha_F_in_H_1_2);
    let x_H_3_7 = IHzz.mul_add(alpha_F_in_H_3_3, IHxz * alpha_F_in_H_1_3);
    let x_H_3_8 = IHzz.mul_add(alpha_F_in_H_3_4, IHxz * alpha_F_in_H_1_4);
    let x_F_in_H_3_7 = (-x_F_3_6).mul_add(sin_lam, x_F_1_6 * cos_lam);
    let x_F_in_H_3_8 = x_S_in_F_1_4.mul_add(sin_lam, x_B_in_S_1_5 * cos_lam);
    let x_F_in_H_3_9 = x_S_in_F_1_5.mul_add(sin_lam, x_B_in_S_3_4 * cos_lam);
    let x_F_in_H_3_10 = (-x_S_in_F_1_6).mul_add(sin_lam, x_B_in_S_1_4 * cos_lam);
    let a_FC_1_2 = w_S_in_F_2_2.mul_add(ratio_theta_u1_of_w_lam_rr_rf, -x_S_in_F_1);
    let x_F_1_7 = mF * a_FC_1_2;
    let a_FC_1_3 = w_S_in_F_2_3.mul_add(ratio_theta_u1_of_w_lam_rr_rf, x_S_in_F_1_2);
    let x_F_1_8 = mF * a_FC_1_3;
    let a_FC_1_4 = w_S_in_F_2_4.mul_add(ratio_theta_u1_of_w_lam_rr_rf, x_S_in_F_1_3);
    let x_F_1_9 = mF * a_FC_1_4;
    let x_B_in_S_1_7 = (-sin_lam).mul_add(sin_theta, cos_lam * cos_theta);
    let x_S_in_F_1_7 = x_B_in_S_1_7 * cos_delta;
    let x_L_in_B_1_7 = sin_phi * sin_theta;
    let x_L_in_B_3_5 = sin_phi * cos_theta;
    let x_B_in_S_1_8 = x_L_in_B_3_5.mul_add(sin_lam, x_L_in_B_1_7 * cos_lam);
    let x_S_in_F_1_8 = x_B_in_S_1_8.mul_add(cos_delta, sin_delta_cos_phi);
    let x_L_in_B_1_8 = cos_phi * sin_theta;
    let x_L_in_B_3_6 = cos_phi * cos_theta;
    let x_B_in_S_1_9 = x_L_in_B_3_6.mul_add(sin_lam, x_L_in_B_1_8 * cos_lam);
    let x_S_in_F_1_9 = (-x_B_in_S_1_9).mul_add(cos_delta, sin_delta_sin_phi);
    let a_FC_2_2 = w_B_in_S_3_2.mul_add(ratio_psi_u1_of_c_lam_rf, x_S_in_F_2)
        + w_S_in_F_1_2 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_6 = mF * a_FC_2_2;
    let a_FC_2_3 = w_F_3_2.mul_add(ratio_psi_u1_of_c_lam_rf, -x_S_in_F_2_2)
        + w_S_in_F_1_3 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_7 = mF * a_FC_2_3;
    let a_FC_2_4 = w_B_in_S_3_4.mul_add(ratio_psi_u1_of_c_lam_rf, -x_S_in_F_2_3)
        + w_S_in_F_1_4 * ratio_theta_u1_of_w_lam_rr_rf;
    let x_F_2_8 = mF * a_FC_2_4;
    let x_S_in_F_2_8 = x_B_in_S_1_7 * sin_delta;
    let x_S_in_F_2_9 = (-x_B_in_S_1_8).mul_add(sin_delta, cos_delta_cos_phi);
    let x_S_in_F_2_10 = x_B_in_S_1_9.mul_add(sin_delta, sin_phi_cos_delta);
    let a_FC_3_2 = w_S_in_F_2_2.mul_add(ratio_psi_u1_of_c_lam_rf, x_F_3_3);
    let x_F_3_7 = mF * a_FC_3_2;
    let a_FC_3_3 = w_S_in_F_2_3.mul_add(ratio_psi_u1_of_c_lam_rf, -x_F_3_4);
    let x_F_3_8 = mF * a_FC_3_3;
    let a_FC_3_4 = w_S_in_F_2_4.mul_add(ratio_psi_u1_of_c_lam_rf, x_F_3_5);
    let x_F_3_9 = mF * a_FC_3_4;
    let x_B_in_S_3_5 = sin_lam.mul_add(cos_theta, cos_lam * sin_theta);
    let x_B_in_S_3_6 = (-x_L_in_B_1_7).mul_add(sin_lam, x_L_in_B_3_5 * cos_lam);
    let x_B_in_S_3_7 = (-x_L_in_B_1_8).mul_add(sin_lam, x_L_in_B_3_6 * cos_lam);
    let x_F_1_10 = IFxx * w_S_in_F_1_2;
    let x_F_1_11 = IFxx * w_S_in_F_1_3;
    let x_F_1_12 = IFxx * w_S_in_F_1_4;
    let x_F_in_S_1_2 = ratio_theta_u1_of_place_2 * cos_delta;
    let x_F_in_S_2_2 = ratio_theta_u1_of_place_2 * sin_delta;
    let x_S_in_B_1_4 = x_F_in_S_3_2.mul_add(sin_lam, x_F_in_S_1_2 * cos_lam);
    let x_S_in_B_3_4 = (-x_F_in_S_1_2).mul_add(sin_lam, x_F_in_S_3_2 * cos_lam);
    let x_B_in_L_3_2 = (-x_S_in_B_1_4).mul_add(sin_theta, x_S_in_B_3_4 * cos_theta);
    let x_L_in_Y_2_2 = (-x_B_in_L_3_2).mul_add(sin_phi, x_F_in_S_2_2 * cos_phi);
    let x_L_in_Y_3_2 = x_B_in_L_3_2.mul_add(cos_phi, x_F_in_S_2_2 * sin_phi);
    let x_Y_in_L_2_3 = (-x_L_in_Y_2_2).mul_add(sin_phi, x_L_in_Y_3_2 * cos_phi);
    let x_Y_in_L_3_3 = x_L_in_Y_3_2.mul_add(sin_phi, x_L_in_Y_2_2 * cos_phi);
    let x_L_in_B_1_9 = x_Y_in_L_3_3 * sin_theta;
    let x_L_in_B_3_7 = x_Y_in_L_3_3 * cos_theta;
    let x_B_in_S_1_10 = x_L_in_B_3_7.mul_add(sin_lam, x_L_in_B_1_9 * cos_lam);
    let x_S_in_F_1_10 = x_B_in_S_1_10.mul_add(cos_delta, x_Y_in_L_2_3 * sin_delta);
    let x_B_in_L_1_2 = x_S_in_B_3_4.mul_add(sin_theta, x_S_in_B_1_4 * cos_theta);
    let x_Y_in_L_2_4 = x_B_in_L_1_2 * sin_phi;
    let x_Y_in_L_3_4 = x_B_in_L_1_2 * cos_phi;
    let x_L_in_B_1_10 = x_Y_in_L_3_4.mul_add(sin_theta, x_L_in_Y_3_2 * cos_theta);
    let x_L_in_B_3_8 = (-x_L_in_Y_3_2).mul_add(sin_theta, x_Y_in_L_3_4 * cos_theta);
    let x_B_in_S_1_11 = x_L_in_B_3_8.mul_add(sin_lam, x_L_in_B_1_10 * cos_lam);
    let x_S_in_F_1_11 = (-x_Y_in_L_2_4).mul_add(sin_delta, x_B_in_S_1_11 * cos_delta);
    let x_Y_in_N_1_2 = (-x_L_in_Y_2_2).mul_add(sin_psi, x_B_in_L_1_2 * cos_psi);
    let x_Y_in_N_2_2 = x_B_in_L_1_2.mul_add(sin_psi, x_L_in_Y_2_2 * cos_psi);
    let x_N_in_Y_1_3 = (-x_Y_in_N_1_2).mul_add(sin_psi, x_Y_in_N_2_2 * cos_psi);
    let x_N_in_Y_2_2 = x_Y_in_N_2_2.mul_add(sin_psi, x_Y_in_N_1_2 * cos_psi);
    let x_Y_in_L_2_5 = x_N_in_Y_2_2 * cos_phi;
    let x_Y_in_L_3_5 = x_N_in_Y_2_2 * sin_phi;
    let x_L_in_B_1_11 = (-x_N_in_Y_1_3).mul_add(cos_theta, x_Y_in_L_3_5 * sin_theta);
    let x_L_in_B_3_9 = x_Y_in_L_3_5.mul_add(cos_theta, x_N_in_Y_1_3 * sin_theta);
    let x_B_in_S_1_12 = x_L_in_B_3_9.mul_add(sin_lam, x_L_in_B_1_11 * cos_lam);
    let x_S_in_F_1_12 = x_B_in_S_1_12.mul_add(cos_delta, x_Y_in_L_2_5 * sin_delta);
    let w_FW_2_2 = ratio_thF_u1 + w_S_in_F_2_2;
    let x_F_2_9 = IFyy * w_FW_2_2;
    let w_FW_2_3 = ratio_thF_u2 - w_S_in_F_2_3;
    let x_F_2_10 = IFyy * w_FW_2_3;
    let w_FW_2_4 = ratio_thF_u3 - w_S_in_F_2_4;
    let x_F_2_11 = IFyy * w_FW_2_4;
    let x_S_in_F_2_11 = (-x_Y_in_L_2_3).mul_add(cos_delta, x_B_in_S_1_10 * sin_delta);
    let x_S_in_F_2_12 = x_B_in_S_1_11.mul_add(sin_delta, x_Y_in_L_2_4 * cos_delta);
    let x_S_in_F_2_13 = (-x_Y_in_L_2_5).mul_add(cos_delta, x_B_in_S_1_12 * sin_delta);
    let x_F_3_10 = IFxx * w_B_in_S_3_2;
    let x_F_3_11 = IFxx * w_F_3_2;
    let x_F_3_12 = IFxx * w_B_in_S_3_4;
    let x_B_in_S_3_8 = (-x_L_in_B_1_9).mul_add(sin_lam, x_L_in_B_3_7 * cos_lam);
    let x_B_in_S_3_9 = (-x_L_in_B_1_10).mul_add(sin_lam, x_L_in_B_3_8 * cos_lam);
    let x_B_in_S_3_10 = (-x_L_in_B_1_11).mul_add(sin_lam, x_L_in_B_3_9 * cos_lam);
    let minus_sin_lam = -sin_lam;
    let minus_sin_thr = -sin_thR;
    let minus_cos_phi = -cos_phi;
    let minus_cos_delta = -cos_delta;
    let minus_x_l_in_b_1_4 = -x_L_in_B_1_4;
    let minus_x_l_in_b_1_5 = -x_L_in_B_1_5;
    let minus_x_f_in_h_1_6 = -x_F_in_H_1_6;
    // Values.
    let m_1_4 = -S::int(1);
    let m_1_18 = cos_thR;
    let m_1_20 = sin_thR;
    let m_2_5 = minus_cos_phi;
    let m_2_19 = S::int(1);
    let m_2_23 = -sin_phi;
    let m_3_5 = sin_phi;
    let m_3_18 = minus_sin_thr;
    let m_3_20 = cos_thR;
    let m_3_23 = minus_cos_phi;
    let m_4_1 = IRxx;
    let m_4_21 = cos_thR;
    let m_4_22 = sin_thR;
    let m_5_1 = -x_L_2_4;
    let m_5_2 = -x_L_2_5;
    let m_5_3 = -x_L_2_6;
    let m_5_4 = -x_Y_in_L_2;
    let m_5_23 = -x_Y_in_L_2_2;
    let m_6_1 = -x_L_3_3;
    let m_6_2 = -x_L_3_4;
    let m_6_3 = -x_L_3_5;
    let m_6_21 = minus_sin_thr;
    let m_6_22 = cos_thR;
    let m_7_13 = S::int(1);
    let m_7_18 = minus_x_l_in_b_1_4;
    let m_8_2 = -x_B_2_4;
    let m_8_3 = -x_B_2_5;
    let m_8_14 = S::int(1);
    let m_8_19 = -S::int(1);
    let m_9_15 = S::int(1);
    let m_9_18 = minus_x_l_in_b_1_5;
    let m_9_20 = minus_x_l_in_b_1_4;
    let m_10_21 = minus_x_l_in_b_1_4;
    let m_11_3 = -x_B_2_8;
    let m_11_13 = -x_B_3_6;
    let m_11_16 = S::int(1);
    let m_11_17 = sin_delta;
    let m_12_14 = -x_B_1_9;
    let m_12_17 = -x_S_in_B_3_2;
    let m_12_19 = -x_L_in_B_3_4;
    let m_12_21 = minus_x_l_in_b_1_5;
    let m_12_22 = minus_x_l_in_b_1_4;
    let m_13_1 = -x_F_in_H_1_2;
    let m_13_2 = -x_F_in_H_1_3;
    let m_13_8 = cos_lam;
    let m_13_10 = sin_lam;
    let m_13_13 = -x_F_in_H_1_5;
    let m_13_14 = minus_x_f_in_h_1_6;
    let m_13_15 = -x_F_in_H_1_7;
    let m_14_9 = S::int(1);
    let m_14_14 = minus_cos_delta;
    let m_14_15 = -x_S_in_F_2_4;
    let m_15_1 = -x_F_in_H_3_2;
    let m_15_2 = -x_F_in_H_3_3;
    let m_15_8 = minus_sin_lam;
    let m_15_10 = cos_lam;
    let m_15_13 = -x_F_in_H_3_5;
    let m_15_15 = -x_F_in_H_3_6;
    let m_16_2 = -x_H_1_7;
    let m_16_3 = -x_H_1_8;
    let m_16_11 = cos_lam;
    let m_16_12 = sin_lam;
    let m_16_15 = -x_F_in_H_1_11;
    let m_16_16 = minus_x_f_in_h_1_6;
    let m_16_17 = -cos_lam;
    let m_17_2 = -x_H_2_7;
    let m_17_3 = -x_H_2_8;
    let m_17_8 = -x_F_3_6;
    let m_17_10 = -x_F_1_6;
    let m_17_16 = minus_cos_delta;
    let m_18_2 = -x_H_3_7;
    let m_18_3 = -x_H_3_8;
    let m_18_11 = minus_sin_lam;
    let m_18_12 = cos_lam;
    let m_18_15 = -x_F_in_H_3_10;
    let m_18_17 = sin_lam;
    let m_19_2 = -x_F_1_8;
    let m_19_3 = -x_F_1_9;
    let m_19_6 = -x_S_in_F_1_7;
    let m_19_7 = -x_S_in_F_1_8;
    let m_19_8 = -S::int(1);
    let m_19_24 = -x_S_in_F_1_9;
    let m_20_2 = -x_F_2_7;
    let m_20_3 = -x_F_2_8;
    let m_20_7 = -x_S_in_F_2_9;
    let m_20_9 = -S::int(1);
    let m_20_24 = -x_S_in_F_2_10;
    let m_21_1 = -x_F_3_7;
    let m_21_6 = -x_B_in_S_3_5;
    let m_21_10 = -S::int(1);
    let m_21_24 = -x_B_in_S_3_7;
    let m_22_1 = -x_F_1_10;
    let m_22_7 = -x_S_in_F_1_11;
    let m_22_11 = -S::int(1);
    let m_22_24 = -x_S_in_F_1_12;
    let m_23_6 = -x_S_in_F_2_11;
    let m_24_2 = -x_F_3_11;
    let m_24_3 = -x_F_3_12;
    let m_24_6 = -x_B_in_S_3_8;
    let m_24_12 = -S::int(1);
    let f_1 = -x_L_1;
    let f_3 = -x_L_3;
    let f_4 = -x_L_1_2;
    let f_6 = -x_L_3_2;
    let f_10 = -x_B_1_2;
    let f_11 = -x_B_2_2;
    let f_12 = -x_B_3_2;
    let f_14 = -x_H_2;
    let f_16 = -x_H_1_2;
    let f_17 = -x_H_2_2;
    let f_18 = -x_H_3_2;
    let f_20 = -x_F_2;
    let f_22 = -x_F_1_2;
    let f_23 = S::ratio(1, 2) * x_F_2_2;
    let zero = S::int(0);
    (
        [
            x_L_1_3, x_L_1_4, x_L_1_5, m_1_4, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_1_18, zero, m_1_20, zero, zero, zero, zero, x_L_2_3, zero,
            zero, zero, m_2_5, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_2_19, zero, zero, zero, m_2_23, zero, zero, zero, zero, zero, m_3_5, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_3_18, zero, m_3_20,
            zero, zero, m_3_23, zero, m_4_1, zero, zero, zero, x_L_in_Y_3, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_4_21, m_4_22,
            x_N_in_Y_1_2, zero, m_5_1, m_5_2, m_5_3, m_5_4, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_5_23, zero,
            m_6_1, m_6_2, m_6_3, x_Y_in_L_3, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_6_21, m_6_22, x_Y_in_L_3_2, zero, x_B_1_3,
            x_B_1_4, x_B_1_5, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_7_13, zero,
            zero, zero, zero, m_7_18, zero, x_L_in_B_1_5, zero, zero, zero, zero, x_B_2_3, m_8_2,
            m_8_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_8_14, zero, zero,
            zero, zero, m_8_19, zero, zero, zero, zero, zero, x_B_3_3, x_B_3_4, x_B_3_5, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, m_9_15, zero, zero, m_9_18, zero,
            m_9_20, zero, zero, zero, zero, x_B_1_6, x_B_1_7, x_B_1_8, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, x_B_3_6, zero, zero, x_S_in_B_1, zero, x_L_in_B_1_6, zero,
            m_10_21, x_L_in_B_1_5, zero, zero, x_B_2_6, x_B_2_7, m_11_3, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, m_11_13, zero, x_B_1_9, m_11_16, m_11_17, x_L_in_RW_3,
            zero, x_L_in_RW_1, zero, zero, zero, zero, x_B_3_7, x_B_3_8, x_B_3_9, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_12_14, zero, zero, m_12_17, zero, m_12_19,
            zero, m_12_21, m_12_22, zero, zero, m_13_1, m_13_2, x_F_in_H_1_4, zero, zero, zero,
            zero, m_13_8, zero, m_13_10, zero, zero, m_13_13, m_13_14, m_13_15, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, x_H_2_3, x_H_2_4, x_H_2_5, zero, zero, zero, zero,
            zero, m_14_9, zero, zero, zero, x_F_in_H_1_6, m_14_14, m_14_15, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, m_15_1, m_15_2, x_F_in_H_3_4, zero, zero, zero, zero,
            m_15_8, zero, m_15_10, zero, zero, m_15_13, x_S_in_F_2_4, m_15_15, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, x_H_1_6, m_16_2, m_16_3, zero, zero, zero, zero,
            zero, x_F_in_H_1_8, zero, m_16_11, m_16_12, x_F_in_H_1_9, x_F_in_H_1_10, m_16_15,
            m_16_16, m_16_17, zero, zero, zero, zero, zero, zero, zero, x_H_2_6, m_17_2, m_17_3,
            zero, zero, zero, zero, m_17_8, zero, m_17_10, zero, zero, x_S_in_F_2_5, x_S_in_F_2_6,
            x_S_in_F_2_7, m_17_16, zero, zero, zero, zero, zero, zero, zero, zero, x_H_3_6, m_18_2,
            m_18_3, zero, zero, zero, zero, zero, x_F_in_H_3_7, zero, m_18_11, m_18_12,
            x_F_in_H_3_8, x_F_in_H_3_9, m_18_15, x_S_in_F_2_4, m_18_17, zero, zero, zero, zero,
            zero, zero, zero, x_F_1_7, m_19_2, m_19_3, zero, zero, m_19_6, m_19_7, m_19_8, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_19_24, x_F_2_6, m_20_2, m_20_3, zero, zero, x_S_in_F_2_8, m_20_7, zero, m_20_9, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_20_24,
            m_21_1, x_F_3_8, x_F_3_9, zero, zero, m_21_6, x_B_in_S_3_6, zero, zero, m_21_10, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_21_24, m_22_1,
            x_F_1_11, x_F_1_12, zero, zero, x_S_in_F_1_10, m_22_7, zero, zero, zero, m_22_11, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_22_24, x_F_2_9,
            x_F_2_10, x_F_2_11, zero, zero, m_23_6, x_S_in_F_2_12, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, x_S_in_F_2_13,
            x_F_3_10, m_24_2, m_24_3, zero, zero, m_24_6, x_B_in_S_3_9, zero, zero, zero, zero,
            m_24_12, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            x_B_in_S_3_10,
        ],
        [
            f_1, x_L_2, f_3, f_4, x_L_2_2, f_6, x_B_1, x_B_2, x_B_3, f_10, f_11, f_12, x_F_in_H_1,
            f_14, x_F_in_H_3, f_16, f_17, f_18, x_F_1, f_20, x_F_3, f_22, f_23, x_F_3_2,
        ],
    )
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 26,
            coordinates: 8,
            variables: 3,
            speeds: 3,
            reactions: 21,
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
