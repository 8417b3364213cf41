//! Andrews' squeezing mechanism: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows beta_rate.
///
/// 103 operations, 7 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, d, da, e, ea, rr, ra, ss, sa, sb,
        ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    // Shared terms.
    let m2_rr = m2 * rr;
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    let rr_cos_angle_inv = rr / cos_angle;
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    let m11_of_place = rr_cos_angle_inv * cos_beta_minus_gamma / d;
    let m11_of_place_2 = rr_cos_angle_inv * sin_theta;
    let m4_ea = m4 * ea;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    let m11_of_place_3 = cos_gamma_minus_delta / e;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    // cos(gamma - delta) + cos_phi_inv*sin(gamma - delta)*sin(phi)
    let m11_of_place_4 = (cos_phi_inv * sin_gamma_minus_delta)
        .mul_add(sin_phi, cos_gamma_minus_delta);
    let m11_of_place_4_doubled = S::int(2) * m11_of_place_4;
    // m4 + m6
    let m4_plus_m6 = m4 + m6;
    let ss_inv = S::int(1) / ss;
    let zt_inv = S::int(1) / zt;
    let zf_inv = S::int(1) / zf;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // 1 - cos(gamma - epsilon)^2
    let m11_of_place_5 = (-cos_gamma_minus_epsilon)
        .mul_add(cos_gamma_minus_epsilon, S::int(1));
    let cos_omega_inv = S::int(1) / cos_omega;
    let m11_of_place_6 = cos_omega_inv * sin_gamma_minus_epsilon * sin_omega;
    let m6_fa = m6 * fa;
    let m11_of_place_7 = m11_of_place_5 * cos_omega_inv * cos_omega_inv;
    let u_2_inv = S::int(1) / u_2;
    // 2*cos(gamma - epsilon)*(cos(gamma - epsilon) + m11_of_place_6) + m11_of_place_7
    let m11_of_place_8 = S::int(2) * cos_gamma_minus_epsilon
        * (cos_gamma_minus_epsilon + m11_of_place_6) + m11_of_place_7;
    // ss_inv^2*(I3 + m3*(sa^2 + sb^2)) + zt_inv^2*(I5 + m5*(ta^2 + tb^2))*(1 - cos(gamma -
    //   delta)*(m11_of_place_4_doubled - cos_phi_inv_sq*cos(gamma - delta)))
    let m11_of_place_9 = ss_inv * ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa))
        + zt_inv * zt_inv * (I5 + m5 * tb.mul_add(tb, ta * ta))
            * (S::int(1)
                - cos_gamma_minus_delta
                    * (-cos_phi_inv_sq)
                        .mul_add(cos_gamma_minus_delta, m11_of_place_4_doubled));
    // zf_inv*(zf_inv*m11_of_place_7*(I6 + fa*m6_fa) - 2*m6_fa*(m11_of_place_5 - m11_of_place_6*cos(gamma -
    //   epsilon))) + u_2_inv^2*(I7 + m7*(ua^2 + ub^2))*(m11_of_place_8 - 1)
    let m11_of_place_10 = zf_inv
        * (zf_inv * m11_of_place_7 * fa.mul_add(m6_fa, I6)
            - S::int(2) * m6_fa
                * (-m11_of_place_6).mul_add(cos_gamma_minus_epsilon, m11_of_place_5))
        + u_2_inv * u_2_inv * (I7 + m7 * ub.mul_add(ub, ua * ua)) * (m11_of_place_8 - S::int(1));
    // m11_of_place_3*(m11_of_place_3*cos_phi_inv_sq*(I4 + ea*m4_ea) - m4_ea*m11_of_place_4_doubled) +
    //   m4_plus_m6
    let m11_of_place_11 = m11_of_place_3
        * (m11_of_place_3 * cos_phi_inv_sq * ea.mul_add(m4_ea, I4)
            - m4_ea * m11_of_place_4_doubled) + m4_plus_m6;
    // m11_of_place_9 + m11_of_place_10
    let m11_of_place_12 = m11_of_place_9 + m11_of_place_10;
    // Entries that are not zero; upper triangle.
    // M11 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let m11 = I1 + m1 * ra * ra + rr * m2_rr
        + m11_of_place * (m11_of_place * (I2 + m2 * da * da) - S::int(2) * da * m2_rr * cos_theta)
        + m11_of_place_2 * m11_of_place_2 * (m11_of_place_11 + m11_of_place_12);
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (beta_rate').
///
/// 423 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 1] {
    let Parameters {
        m2, m3, m4, m5, m6, m7, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e, ea, rr,
        ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let ss_inv = S::int(1) / ss;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let f1_of_place = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let f1_of_place_2 = (-yb_minus_yc).mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    // beta + theta - gamma
    let f1_of_place_3 = beta + theta - gamma;
    let (sin_angle, cos_angle) = f1_of_place_3.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let f1_of_place_4 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let zt_inv = S::int(1) / zt;
    let cos_phi_inv = S::int(1) / cos_phi;
    let e_inv = S::int(1) / e;
    let i4_e_inv = I4 * e_inv;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let f1_of_e_ea = ea_e_inv - S::int(2);
    let m4_ea = m4 * ea;
    // i4_e_inv + f1_of_e_ea*m4_ea
    let f1_of_m4_i4_e_ea = f1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let f1_of_place_5 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let sin_phi_doubled = S::int(2) * sin_phi;
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let f1_of_place_6 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + f1_of_place_6
    let f1_of_place_7 = cos_gamma_minus_delta.mul_add(cos_phi, f1_of_place_6);
    let f1_of_place_8 = f1_of_place_4 * sin_phi_doubled;
    // cos(gamma - delta) + f1_of_place_8
    let f1_of_place_9 = cos_gamma_minus_delta + f1_of_place_8;
    // ea_e_inv - 1
    let f1_of_e_ea_2 = ea_e_inv - S::int(1);
    let zt_inv_f1_of_place_5 = zt_inv * f1_of_place_5;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let f1_of_place_10 = f1_of_place_4.mul_add(sin_angle_cos_angle_inv, -f1_of_place_7);
    // -f1_of_place_10
    let minus_f1_of_place_10 = -f1_of_place_10;
    let f1_of_place_11 = f1_of_e_ea_2 * cos_gamma_minus_delta;
    let f1_of_place_12 = S::int(2) * sin_angle_cos_angle_inv;
    let ea_ss_inv = ea * ss_inv;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let f1_of_place_13 = f1_of_place_12 * cos_gamma_minus_delta;
    let f1_of_place_14 = cos_phi_inv * cos_gamma_minus_delta;
    let sin_phi_f1_of_place_7 = f1_of_place_7 * sin_phi;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let f1_of_place_15 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let f1_of_place_16 = e_inv * cos_gamma_minus_delta;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let f1_of_place_17 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let u_2_inv = S::int(1) / u_2;
    let cos_omega_inv = S::int(1) / cos_omega;
    let zf_inv = S::int(1) / zf;
    let i6_zf_inv = I6 * zf_inv;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let f1_of_zf_fa = fa_zf_inv - S::int(2);
    let m6_fa = m6 * fa;
    // i6_zf_inv + f1_of_zf_fa*m6_fa
    let f1_of_m6_i6_zf_fa = f1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let f1_of_place_18 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - f1_of_place_18
    let f1_of_place_19 = sin_gamma_minus_epsilon.mul_add(cos_omega, -f1_of_place_18);
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let f1_of_place_20 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    let f1_of_place_21 = f1_of_place_17 * sin_omega_doubled;
    // sin(gamma - epsilon) - f1_of_place_21
    let f1_of_place_22 = sin_gamma_minus_epsilon - f1_of_place_21;
    // fa_zf_inv - 1
    let f1_of_zf_fa_2 = fa_zf_inv - S::int(1);
    let u_2_inv_f1_of_place_20 = u_2_inv * f1_of_place_20;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let f1_of_place_23 = f1_of_place_17.mul_add(sin_angle_cos_angle_inv, f1_of_place_19);
    let f1_of_place_24 = f1_of_zf_fa_2 * sin_gamma_minus_epsilon;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let fa_ss_inv = fa * ss_inv;
    let f1_of_place_25 = f1_of_place_12 * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let f1_of_place_26 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let sin_omega_f1_of_place_19 = f1_of_place_19 * sin_omega;
    let f1_of_place_27 = cos_omega_inv * sin_gamma_minus_epsilon;
    let sin_omega_f1_of_place_27 = f1_of_place_27 * sin_omega;
    let f1_of_place_28 = zf_inv * sin_omega_f1_of_place_27;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let f1_of_place_29 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_f1_of_place_29 = ss_inv * f1_of_place_29;
    let f1_of_place_4_sq = f1_of_place_4 * f1_of_place_4;
    let f1_of_place_17_sq = f1_of_place_17 * f1_of_place_17;
    // cos_phi_inv_sq*(i4_e_inv*f1_of_place_16*cos(gamma - delta) + zt_inv_f1_of_place_5*f1_of_place_4_sq +
    //   m4*(cos(gamma - delta)*(ea_e_inv*(f1_of_e_ea*cos(gamma - delta) - f1_of_place_8) + f1_of_place_9) +
    //   f1_of_place_4_sq)) + cos_omega_inv_sq*(zf_inv_i6_zf_inv*sin(gamma - epsilon)^2 +
    //   u_2_inv_f1_of_place_20*f1_of_place_17_sq + m6*(sin(gamma -
    //   epsilon)*(fa_zf_inv*(f1_of_zf_fa*sin(gamma - epsilon) + f1_of_place_21) + f1_of_place_22) +
    //   f1_of_place_17_sq))
    let f1_of_place_30 = cos_phi_inv_sq
        * (i4_e_inv * f1_of_place_16 * cos_gamma_minus_delta
            + zt_inv_f1_of_place_5 * f1_of_place_4_sq
            + m4
                * (cos_gamma_minus_delta
                    * (ea_e_inv * f1_of_e_ea.mul_add(cos_gamma_minus_delta, -f1_of_place_8)
                        + f1_of_place_9) + f1_of_place_4_sq))
        + cos_omega_inv_sq
            * (zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon
                + u_2_inv_f1_of_place_20 * f1_of_place_17_sq
                + m6
                    * (sin_gamma_minus_epsilon
                        * (fa_zf_inv
                            * f1_of_zf_fa
                                .mul_add(sin_gamma_minus_epsilon, f1_of_place_21)
                            + f1_of_place_22) + f1_of_place_17_sq));
    // ss_inv_f1_of_place_29 + f1_of_place_30
    let f1_of_place_31 = ss_inv_f1_of_place_29 + f1_of_place_30;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let f1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let f1_of_place_32 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let m2_da = m2 * da;
    let f1_of_place_33 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - f1_of_d_beta_gamma*f1_of_place_32*rr_cos_angle_inv
    let f1_of_place_34 = (-(f1_of_d_beta_gamma * f1_of_place_32))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let f1_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let f1_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let f1_of_place_35 = (xc_sq + f1_of_xb_xc + yc_sq + f1_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // Values.
    // f1 = mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta
    //   - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma)
    let f1 = mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * f1_of_place_35 * (l0 - f1_of_place_35)
                    * (-sd).mul_add(f1_of_place_2, sc * f1_of_place)
                    / (xc_sq + f1_of_xb_xc + yc_sq + f1_of_yb_yc
                        + sd * f1_of_place.mul_add(S::int(2), sd)
                        + sc * f1_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (-cos_angle_inv
                            * (rr
                                * (cos_angle_inv
                                    * (sin_theta
                                        * (sin_theta
                                            * (cos_phi_inv_sq
                                                * (f1_of_place_4
                                                    * (zt_inv
                                                        * (cos_phi_inv
                                                            * (cos_gamma_minus_delta
                                                                * (e_inv
                                                                    * (f1_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                        - f1_of_place_7 * f1_of_place_5
                                                                        + sin_phi_cos_phi_inv
                                                                            * (f1_of_place_4
                                                                                * m4_ea.mul_add(sin_phi_doubled, f1_of_place_5)
                                                                                - f1_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                    + m4
                                                                        * (-sin_phi_cos_phi_inv)
                                                                            .mul_add(f1_of_place_9, sin_gamma_minus_delta))
                                                                - f1_of_place_4 * sin_phi
                                                                    * (f1_of_place_4 * cos_phi_inv * (m4 + zt_inv_f1_of_place_5)
                                                                        + m4 * f1_of_e_ea_2 * sin_gamma_minus_delta))
                                                            + ss_inv * zt_inv
                                                                * (m5 * ta_sq_plus_tb_sq)
                                                                    .mul_add(minus_f1_of_place_10, I5 * minus_f1_of_place_10)
                                                            + m4 * f1_of_place_4 * f1_of_place_11)
                                                        - m4
                                                            * (e_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (f1_of_place_11 + f1_of_place_7 * cos_phi_inv
                                                                        - sin_phi
                                                                            * (cos_phi_inv_sq
                                                                                * (-sin_phi_doubled).mul_add(f1_of_place_11, f1_of_place_4)
                                                                                + f1_of_place_12 * ea_ss_inv)) - f1_of_place_6 * ea_ss_inv)
                                                                + ss_inv
                                                                    * (f1_of_place_10
                                                                        + sin_phi * (sin_gamma_minus_delta + f1_of_place_13))))
                                                    + cos_gamma_minus_delta
                                                        * (m4
                                                            * (e_inv
                                                                * (sin_phi_cos_phi_inv * cos_gamma_minus_delta
                                                                    * (f1_of_place_14 - f1_of_place_7)
                                                                    + ea
                                                                        * (e_inv
                                                                            * (cos_gamma_minus_delta
                                                                                * (sin_phi_cos_phi_inv
                                                                                    * f1_of_e_ea.mul_add(f1_of_place_14, f1_of_place_7)
                                                                                    - sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                - ea_ss_inv * sin_gamma_minus_delta)
                                                                            + ss_inv
                                                                                * (sin_gamma_minus_delta.mul_add(S::int(2), f1_of_place_13)
                                                                                    - sin_phi_f1_of_place_7)))
                                                                + ss_inv * (sin_phi_f1_of_place_7 - f1_of_place_15))
                                                            + e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        f1_of_place_15,
                                                                        sin_phi_cos_phi_inv * f1_of_place_14 * f1_of_place_16,
                                                                    )))
                                                - cos_omega_inv_sq
                                                    * (f1_of_place_17
                                                        * (u_2_inv
                                                            * (cos_omega_inv
                                                                * (sin_gamma_minus_epsilon
                                                                    * (zf_inv
                                                                        * (f1_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                            - f1_of_place_19 * f1_of_place_20
                                                                            + sin_omega_cos_omega_inv
                                                                                * (f1_of_place_17
                                                                                    * m6_fa.mul_add(sin_omega_doubled, -f1_of_place_20)
                                                                                    + f1_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                        + m6
                                                                            * sin_omega_cos_omega_inv
                                                                                .mul_add(f1_of_place_22, cos_gamma_minus_epsilon))
                                                                    + f1_of_place_17 * sin_omega
                                                                        * (f1_of_place_17 * cos_omega_inv
                                                                            * (m6 + u_2_inv_f1_of_place_20)
                                                                            + m6 * f1_of_zf_fa_2 * cos_gamma_minus_epsilon))
                                                                + ss_inv * u_2_inv
                                                                    * (m7 * ua_sq_plus_ub_sq)
                                                                        .mul_add(f1_of_place_23, I7 * f1_of_place_23)
                                                                + m6 * f1_of_place_17 * f1_of_place_24)
                                                            + m6
                                                                * (ss_inv
                                                                    * (f1_of_place_23
                                                                        + sin_omega * (cos_gamma_minus_epsilon - f1_of_place_25))
                                                                    - zf_inv
                                                                        * (sin_gamma_minus_epsilon
                                                                            * (f1_of_place_24 + f1_of_place_19 * cos_omega_inv
                                                                                + sin_omega
                                                                                    * (cos_omega_inv_sq
                                                                                        * sin_omega_doubled.mul_add(f1_of_place_24, f1_of_place_17)
                                                                                        - f1_of_place_12 * fa_ss_inv))
                                                                            + f1_of_place_18 * fa_ss_inv)))
                                                        + sin_gamma_minus_epsilon
                                                            * (m6
                                                                * (zf_inv
                                                                    * (sin_omega_f1_of_place_27
                                                                        * (f1_of_place_19 - f1_of_place_27)
                                                                        + fa
                                                                            * (ss_inv
                                                                                * (cos_gamma_minus_epsilon
                                                                                    .mul_add(S::int(2), -f1_of_place_25)
                                                                                    - fa_zf_inv * f1_of_place_26 + sin_omega_f1_of_place_19)
                                                                                - f1_of_place_28
                                                                                    * f1_of_zf_fa.mul_add(f1_of_place_27, f1_of_place_19)))
                                                                    - ss_inv * (f1_of_place_26 + sin_omega_f1_of_place_19))
                                                                - zf_inv_i6_zf_inv
                                                                    * f1_of_place_27
                                                                        .mul_add(f1_of_place_28, ss_inv * f1_of_place_26)))
                                                - ss_inv * sin_angle_cos_angle_inv * ss_inv_f1_of_place_29)
                                            + sin_angle_cos_angle_inv * f1_of_place_31
                                                * f1_of_d_beta_gamma)
                                        + f1_of_d_beta_gamma
                                            * (ss_inv * d_inv * (sin_beta_minus_gamma - f1_of_place_32)
                                                * da.mul_add(m2_da, I2)
                                                + cos_theta
                                                    * (f1_of_place_30
                                                        + ss_inv * m2_da.mul_add(sin_angle, f1_of_place_29))))
                                    + d_inv * m2_da
                                        * (-ss_inv)
                                            .mul_add(
                                                f1_of_place_33,
                                                f1_of_d_beta_gamma * cos_beta_minus_gamma,
                                            )) - f1_of_place_31 * cos_theta)
                            + f1_of_d_beta_gamma * m2_da))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * f1_of_d_beta_gamma
                        * (m2_da * da.mul_add(f1_of_place_34, rr * f1_of_place_32 * cos_theta)
                            + I2 * f1_of_place_34) - m2_da * f1_of_place_33));
    [f1]
}

/// The accelerations (beta_rate'), solved for when this code was generated.
///
/// 441 operations, 8 sines and cosines, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 1] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // beta + theta - gamma
    let d1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let d1_of_place_2 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let sin_phi_doubled = S::int(2) * sin_phi;
    let d1_of_place_3 = d1_of_place_2 * sin_phi_doubled;
    // cos(gamma - delta) + d1_of_place_3
    let d1_of_place_4 = cos_gamma_minus_delta + d1_of_place_3;
    let d1_of_place_2_sq = d1_of_place_2 * d1_of_place_2;
    let d1_of_place_5 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let d1_of_place_6 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_d1_of_place_6 = zt_inv * d1_of_place_6;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let d1_of_zf_fa = fa_zf_inv - S::int(2);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let d1_of_place_7 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let d1_of_place_8 = d1_of_place_7 * sin_omega_doubled;
    // sin(gamma - epsilon) - d1_of_place_8
    let d1_of_place_9 = sin_gamma_minus_epsilon - d1_of_place_8;
    let d1_of_place_7_sq = d1_of_place_7 * d1_of_place_7;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_10 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_10 = u_2_inv * d1_of_place_10;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // cos_phi_inv_sq*(m4*(cos(gamma - delta)*(ea_e_inv*(d1_of_e_ea*cos(gamma - delta) - d1_of_place_3) +
    //   d1_of_place_4) + d1_of_place_2_sq) + I4*d1_of_place_5^2 + d1_of_place_2_sq*zt_inv_d1_of_place_6) +
    //   cos_omega_inv_sq*(m6*(sin(gamma - epsilon)*(fa_zf_inv*(d1_of_zf_fa*sin(gamma - epsilon) +
    //   d1_of_place_8) + d1_of_place_9) + d1_of_place_7_sq) + d1_of_place_7_sq*u_2_inv_d1_of_place_10 +
    //   zf_inv_i6_zf_inv*sin(gamma - epsilon)^2)
    let d1_of_place_11 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, -d1_of_place_3)
                    + d1_of_place_4) + d1_of_place_2_sq) + I4 * d1_of_place_5 * d1_of_place_5
            + d1_of_place_2_sq * zt_inv_d1_of_place_6)
        + cos_omega_inv_sq
            * (m6
                * (sin_gamma_minus_epsilon
                    * (fa_zf_inv * d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_8)
                        + d1_of_place_9) + d1_of_place_7_sq)
                + d1_of_place_7_sq * u_2_inv_d1_of_place_10
                + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_12 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_12 = ss_inv * d1_of_place_12;
    // d1_of_place_11 + ss_inv_d1_of_place_12
    let d1_of_place_13 = d1_of_place_11 + ss_inv_d1_of_place_12;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let m2_da_d1_of_d_beta_gamma = m2_da * d1_of_d_beta_gamma;
    // d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let d1 = I1 + m1 * ra * ra
        + rr * rr
            * (m2
                + cos_angle_inv
                    * (cos_angle_inv
                        * (d1_of_place_13 * sin_theta * sin_theta
                            + i2_plus_da_m2_da * d1_of_d_beta_gamma * d1_of_d_beta_gamma)
                        - S::int(2) * m2_da_d1_of_d_beta_gamma * cos_theta));
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let beta_rate_dot_of_place = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let beta_rate_dot_of_place_3 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + beta_rate_dot_of_place_3
    let beta_rate_dot_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi, beta_rate_dot_of_place_3);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let beta_rate_dot_of_place_5 = d1_of_place_2
        .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_of_place_4);
    // -beta_rate_dot_of_place_5
    let beta_rate_dot_of_place_6 = -beta_rate_dot_of_place_5;
    let beta_rate_dot_of_place_7 = beta_rate_dot_of_e_ea * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_8 = S::int(2) * sin_angle_cos_angle_inv;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_9 = beta_rate_dot_of_place_8 * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_10 = cos_phi_inv * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_11 = beta_rate_dot_of_place_4 * sin_phi;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_12 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let m6_fa = m6 * fa;
    // i6_zf_inv + d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let beta_rate_dot_of_place_13 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_of_place_13
    let beta_rate_dot_of_place_14 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_of_place_13);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_15 = d1_of_place_7
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_14);
    let beta_rate_dot_of_place_16 = beta_rate_dot_of_zf_fa * sin_gamma_minus_epsilon;
    let fa_ss_inv = fa * ss_inv;
    let beta_rate_dot_of_place_17 = beta_rate_dot_of_place_8 * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_18 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_19 = beta_rate_dot_of_place_14 * sin_omega;
    let beta_rate_dot_of_place_20 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_21 = beta_rate_dot_of_place_20 * sin_omega;
    let beta_rate_dot_of_place_22 = zf_inv * beta_rate_dot_of_place_21;
    let beta_rate_dot_of_place_23 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_24 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - d1_of_d_beta_gamma*beta_rate_dot_of_place_23*rr_cos_angle_inv
    let beta_rate_dot_of_place_25 = (-(d1_of_d_beta_gamma * beta_rate_dot_of_place_23))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_26 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // beta_rate' = (mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_26 * (l0 - beta_rate_dot_of_place_26)
                    * (-sd)
                        .mul_add(beta_rate_dot_of_place_2, sc * beta_rate_dot_of_place)
                    / (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
                        + sd * beta_rate_dot_of_place.mul_add(S::int(2), sd)
                        + sc * beta_rate_dot_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (m2_da_d1_of_d_beta_gamma
                            + cos_angle_inv
                                * (-rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_phi_inv_sq
                                                    * (d1_of_place_2
                                                        * (zt_inv
                                                            * (cos_phi_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (e_inv
                                                                        * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                            - beta_rate_dot_of_place_4 * d1_of_place_6
                                                                            + sin_phi_cos_phi_inv
                                                                                * (d1_of_place_2
                                                                                    * sin_phi_doubled.mul_add(m4_ea, d1_of_place_6)
                                                                                    - beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                        + m4
                                                                            * (-d1_of_place_4)
                                                                                .mul_add(sin_phi_cos_phi_inv, sin_gamma_minus_delta))
                                                                    - d1_of_place_2 * sin_phi
                                                                        * (d1_of_place_2 * cos_phi_inv * (m4 + zt_inv_d1_of_place_6)
                                                                            + m4 * beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                + zt_inv * ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_6,
                                                                            I5 * beta_rate_dot_of_place_6,
                                                                        ) + m4 * d1_of_place_2 * beta_rate_dot_of_place_7)
                                                            - m4
                                                                * (e_inv
                                                                    * (cos_gamma_minus_delta
                                                                        * (beta_rate_dot_of_place_7
                                                                            + beta_rate_dot_of_place_4 * cos_phi_inv
                                                                            - sin_phi
                                                                                * (cos_phi_inv_sq
                                                                                    * (-sin_phi_doubled)
                                                                                        .mul_add(beta_rate_dot_of_place_7, d1_of_place_2)
                                                                                    + beta_rate_dot_of_place_8 * ea_ss_inv))
                                                                        - beta_rate_dot_of_place_3 * ea_ss_inv)
                                                                    + ss_inv
                                                                        * (beta_rate_dot_of_place_5
                                                                            + sin_phi
                                                                                * (sin_gamma_minus_delta + beta_rate_dot_of_place_9))))
                                                        + cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        beta_rate_dot_of_place_12,
                                                                        d1_of_place_5 * sin_phi_cos_phi_inv
                                                                            * beta_rate_dot_of_place_10,
                                                                    )
                                                                + m4
                                                                    * (e_inv
                                                                        * (sin_phi_cos_phi_inv * cos_gamma_minus_delta
                                                                            * (beta_rate_dot_of_place_10 - beta_rate_dot_of_place_4)
                                                                            + ea
                                                                                * (e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * (sin_phi_cos_phi_inv
                                                                                            * d1_of_e_ea
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_of_place_10,
                                                                                                    beta_rate_dot_of_place_4,
                                                                                                ) - sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                        - ea_ss_inv * sin_gamma_minus_delta)
                                                                                    + ss_inv
                                                                                        * (sin_gamma_minus_delta
                                                                                            .mul_add(S::int(2), beta_rate_dot_of_place_9)
                                                                                            - beta_rate_dot_of_place_11)))
                                                                        + ss_inv
                                                                            * (beta_rate_dot_of_place_11 - beta_rate_dot_of_place_12))))
                                                    - ss_inv * ss_inv_d1_of_place_12 * sin_angle_cos_angle_inv
                                                    - cos_omega_inv_sq
                                                        * (d1_of_place_7
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - beta_rate_dot_of_place_14 * d1_of_place_10
                                                                                + sin_omega_cos_omega_inv
                                                                                    * (d1_of_place_7
                                                                                        * sin_omega_doubled.mul_add(m6_fa, -d1_of_place_10)
                                                                                        + beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                            + m6
                                                                                * d1_of_place_9
                                                                                    .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                        + d1_of_place_7 * sin_omega
                                                                            * (d1_of_place_7 * cos_omega_inv
                                                                                * (m6 + u_2_inv_d1_of_place_10)
                                                                                + m6 * beta_rate_dot_of_zf_fa * cos_gamma_minus_epsilon))
                                                                    + u_2_inv * ss_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_15,
                                                                                I7 * beta_rate_dot_of_place_15,
                                                                            ) + m6 * d1_of_place_7 * beta_rate_dot_of_place_16)
                                                                + m6
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_15
                                                                            + sin_omega
                                                                                * (cos_gamma_minus_epsilon - beta_rate_dot_of_place_17))
                                                                        - zf_inv
                                                                            * (sin_gamma_minus_epsilon
                                                                                * (beta_rate_dot_of_place_16
                                                                                    + beta_rate_dot_of_place_14 * cos_omega_inv
                                                                                    + sin_omega
                                                                                        * (cos_omega_inv_sq
                                                                                            * sin_omega_doubled
                                                                                                .mul_add(beta_rate_dot_of_place_16, d1_of_place_7)
                                                                                            - beta_rate_dot_of_place_8 * fa_ss_inv))
                                                                                + beta_rate_dot_of_place_13 * fa_ss_inv)))
                                                            + sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (zf_inv
                                                                        * (beta_rate_dot_of_place_21
                                                                            * (beta_rate_dot_of_place_14 - beta_rate_dot_of_place_20)
                                                                            + fa
                                                                                * (ss_inv
                                                                                    * (cos_gamma_minus_epsilon
                                                                                        .mul_add(S::int(2), -beta_rate_dot_of_place_17)
                                                                                        - fa_zf_inv * beta_rate_dot_of_place_18
                                                                                        + beta_rate_dot_of_place_19)
                                                                                    - beta_rate_dot_of_place_22
                                                                                        * d1_of_zf_fa
                                                                                            .mul_add(
                                                                                                beta_rate_dot_of_place_20,
                                                                                                beta_rate_dot_of_place_14,
                                                                                            )))
                                                                        - ss_inv
                                                                            * (beta_rate_dot_of_place_18 + beta_rate_dot_of_place_19))
                                                                    - zf_inv_i6_zf_inv
                                                                        * beta_rate_dot_of_place_20
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_22,
                                                                                ss_inv * beta_rate_dot_of_place_18,
                                                                            ))))
                                                + d1_of_place_13 * d1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            + d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (d1_of_place_11
                                                        + ss_inv * m2_da.mul_add(sin_angle, d1_of_place_12))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_23)))
                                        + m2_da * d_inv
                                            * (-ss_inv)
                                                .mul_add(
                                                    beta_rate_dot_of_place_24,
                                                    d1_of_d_beta_gamma * cos_beta_minus_gamma,
                                                )) + d1_of_place_13 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_25,
                                    rr * beta_rate_dot_of_place_23 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_25)
                        - m2_da * beta_rate_dot_of_place_24))) / d1;
    [beta_rate_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 35 operations, 7 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 7] {
    let Parameters { d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    // Shared terms.
    let rr_cos_angle_inv = rr / cos_angle;
    let gamma_dot_value_of_beta_rate = beta_rate * rr_cos_angle_inv * sin_theta;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let delta_dot_value_of_place = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let delta_dot_value_of_beta_rate = gamma_dot_value_of_beta_rate / (zt * cos_phi);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let epsilon_dot_value_of_place = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let epsilon_dot_value_of_beta_rate = gamma_dot_value_of_beta_rate / (u_2 * cos_omega);
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = beta_rate * (rr_cos_angle_inv * cos_beta_minus_gamma / d - S::int(1));
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = gamma_dot_value_of_beta_rate / ss;
    // delta' = rr*beta_rate*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_value = delta_dot_value_of_place * delta_dot_value_of_beta_rate;
    // phi' = rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let phi_dot_value = delta_dot_value_of_beta_rate
        * (-e).mul_add(delta_dot_value_of_place, zt * cos_gamma_minus_delta) / e;
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = epsilon_dot_value_of_place * epsilon_dot_value_of_beta_rate;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = epsilon_dot_value_of_beta_rate
        * (-zf).mul_add(epsilon_dot_value_of_place, u_2 * sin_gamma_minus_epsilon) / zf;
    [
        beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
        epsilon_dot_value, omega_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 108 operations, 7 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> S {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, d, da, e, ea, rr, ra, ss, sa, sb,
        ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    // Shared terms.
    let rr_beta_rate = rr * beta_rate;
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    let energy_of_beta_rate = rr_beta_rate / cos_angle;
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    let energy_of_beta_rate_2 = energy_of_beta_rate * cos_beta_minus_gamma / d;
    let m2_da = m2 * da;
    let energy_of_beta_rate_3 = energy_of_beta_rate * sin_theta;
    let energy_of_beta_rate_3_sq = energy_of_beta_rate_3 * energy_of_beta_rate_3;
    let cos_phi_inv = S::int(1) / cos_phi;
    let zt_inv = S::int(1) / zt;
    // zt_inv^2*(I5 + m5*(ta^2 + tb^2))
    let energy_of_place = zt_inv * zt_inv * (I5 + m5 * tb.mul_add(tb, ta * ta));
    let e_inv = S::int(1) / e;
    let m4_ea = m4 * ea;
    let zf_inv = S::int(1) / zf;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // 1 - cos(gamma - epsilon)^2
    let energy_of_place_2 = (-cos_gamma_minus_epsilon)
        .mul_add(cos_gamma_minus_epsilon, S::int(1));
    let cos_omega_inv = S::int(1) / cos_omega;
    let energy_of_place_3 = cos_omega_inv * sin_gamma_minus_epsilon * sin_omega;
    let m6_fa = m6 * fa;
    let energy_of_beta_rate_4 = S::ratio(1, 2) * energy_of_beta_rate_3_sq;
    let u_2_inv = S::int(1) / u_2;
    // u_2_inv^2*(I7 + m7*(ua^2 + ub^2))
    let energy_of_place_4 = u_2_inv * u_2_inv * (I7 + m7 * ub.mul_add(ub, ua * ua));
    // beta_rate^2*(I1 + m1*ra^2) + m2*rr_beta_rate^2
    let energy_of_beta_rate_5 = beta_rate * beta_rate * (I1 + m1 * ra * ra)
        + m2 * rr_beta_rate * rr_beta_rate;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    let energy_of_place_5 = cos_phi_inv * cos_gamma_minus_delta;
    let ss_inv = S::int(1) / ss;
    // m4 + m6
    let m4_plus_m6 = m4 + m6;
    // energy_of_place_2*cos_omega_inv^2*(zf_inv^2*(I6 + fa*m6_fa) + energy_of_place_4) + ss_inv^2*(I3 +
    //   m3*(sa^2 + sb^2))
    let energy_of_place_6 = energy_of_place_2 * cos_omega_inv * cos_omega_inv
        * (zf_inv * zf_inv * fa.mul_add(m6_fa, I6) + energy_of_place_4)
        + ss_inv * ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    // energy_of_place + energy_of_place_5^2*(energy_of_place + e_inv^2*(I4 + ea*m4_ea))
    let energy_of_place_7 = energy_of_place
        + energy_of_place_5 * energy_of_place_5
            * (energy_of_place + e_inv * e_inv * ea.mul_add(m4_ea, I4));
    // m4_plus_m6 + energy_of_place_6
    let energy_of_place_8 = m4_plus_m6 + energy_of_place_6;
    // energy_of_beta_rate_2^2*(I2 + da*m2_da) + energy_of_beta_rate_5
    let energy_of_beta_rate_6 = energy_of_beta_rate_2 * energy_of_beta_rate_2
        * da.mul_add(m2_da, I2) + energy_of_beta_rate_5;
    // Values.
    // T = beta_rate^2*(I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 +
    //   sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - 2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma)))/2
    let energy = energy_of_place_4
        * (energy_of_beta_rate_3_sq * cos_gamma_minus_epsilon
            * (cos_gamma_minus_epsilon + energy_of_place_3) - energy_of_beta_rate_4)
        - rr_beta_rate * energy_of_beta_rate_2 * m2_da * cos_theta
        - energy_of_beta_rate_3_sq
            * (cos_gamma_minus_delta
                * (cos_phi_inv * sin_gamma_minus_delta)
                    .mul_add(sin_phi, cos_gamma_minus_delta) * e_inv.mul_add(m4_ea, energy_of_place)
                + zf_inv * m6_fa
                    * (-energy_of_place_3)
                        .mul_add(cos_gamma_minus_epsilon, energy_of_place_2))
        + energy_of_beta_rate_4 * (energy_of_place_7 + energy_of_place_8)
        + S::ratio(1, 2) * energy_of_beta_rate_6;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 27 operations, 1 sine and cosine, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 7]) -> S {
    let Parameters { xb, yb, xc, yc, c0, l0, sc, sd, mom, .. } = *p;
    let [beta, _, gamma, _, _, _, _] = *q;
    // Sines and cosines.
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Shared terms.
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // Values.
    // V = c0*(l0 - sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) +
    //   sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))))^2/2 - mom*beta
    let energy = S::ratio(1, 2) * c0
        * (l0
            - (xb_minus_xc * xb_minus_xc + yb_minus_yc * yb_minus_yc + sc * sc + sd * sd
                + S::int(2) * xb_minus_xc * sd.mul_add(cos_gamma, sc * sin_gamma)
                + S::int(2) * yb_minus_yc * (-sc).mul_add(cos_gamma, sd * sin_gamma))
                .sqrt())
            .powi(2) - mom * beta;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 462 operations, 8 sines and cosines, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    u: &[S; 1],
) -> ([S; 7], [S; 1]) {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // beta + theta - gamma
    let d1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let d1_of_place_2 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let sin_phi_doubled = S::int(2) * sin_phi;
    let d1_of_place_3 = d1_of_place_2 * sin_phi_doubled;
    // cos(gamma - delta) + d1_of_place_3
    let d1_of_place_4 = cos_gamma_minus_delta + d1_of_place_3;
    let d1_of_place_2_sq = d1_of_place_2 * d1_of_place_2;
    let d1_of_place_5 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let d1_of_place_6 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_d1_of_place_6 = zt_inv * d1_of_place_6;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let d1_of_zf_fa = fa_zf_inv - S::int(2);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let d1_of_place_7 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let d1_of_place_8 = d1_of_place_7 * sin_omega_doubled;
    // sin(gamma - epsilon) - d1_of_place_8
    let d1_of_place_9 = sin_gamma_minus_epsilon - d1_of_place_8;
    let d1_of_place_7_sq = d1_of_place_7 * d1_of_place_7;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_10 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_10 = u_2_inv * d1_of_place_10;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // cos_phi_inv_sq*(m4*(cos(gamma - delta)*(ea_e_inv*(d1_of_e_ea*cos(gamma - delta) - d1_of_place_3) +
    //   d1_of_place_4) + d1_of_place_2_sq) + I4*d1_of_place_5^2 + d1_of_place_2_sq*zt_inv_d1_of_place_6) +
    //   cos_omega_inv_sq*(m6*(sin(gamma - epsilon)*(fa_zf_inv*(d1_of_zf_fa*sin(gamma - epsilon) +
    //   d1_of_place_8) + d1_of_place_9) + d1_of_place_7_sq) + d1_of_place_7_sq*u_2_inv_d1_of_place_10 +
    //   zf_inv_i6_zf_inv*sin(gamma - epsilon)^2)
    let d1_of_place_11 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, -d1_of_place_3)
                    + d1_of_place_4) + d1_of_place_2_sq) + I4 * d1_of_place_5 * d1_of_place_5
            + d1_of_place_2_sq * zt_inv_d1_of_place_6)
        + cos_omega_inv_sq
            * (m6
                * (sin_gamma_minus_epsilon
                    * (fa_zf_inv * d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_8)
                        + d1_of_place_9) + d1_of_place_7_sq)
                + d1_of_place_7_sq * u_2_inv_d1_of_place_10
                + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_12 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_12 = ss_inv * d1_of_place_12;
    // d1_of_place_11 + ss_inv_d1_of_place_12
    let d1_of_place_13 = d1_of_place_11 + ss_inv_d1_of_place_12;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let m2_da_d1_of_d_beta_gamma = m2_da * d1_of_d_beta_gamma;
    // d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let d1 = I1 + m1 * ra * ra
        + rr * rr
            * (m2
                + cos_angle_inv
                    * (cos_angle_inv
                        * (d1_of_place_13 * sin_theta * sin_theta
                            + i2_plus_da_m2_da * d1_of_d_beta_gamma * d1_of_d_beta_gamma)
                        - S::int(2) * m2_da_d1_of_d_beta_gamma * cos_theta));
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let beta_rate_dot_of_place = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let beta_rate_dot_of_place_3 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + beta_rate_dot_of_place_3
    let beta_rate_dot_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi, beta_rate_dot_of_place_3);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    let beta_rate_dot_of_place_5 = d1_of_place_2 * cos_phi_inv;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let beta_rate_dot_of_place_6 = d1_of_place_2
        .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_of_place_4);
    // -beta_rate_dot_of_place_6
    let beta_rate_dot_of_place_7 = -beta_rate_dot_of_place_6;
    let beta_rate_dot_of_place_8 = beta_rate_dot_of_e_ea * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_9 = S::int(2) * sin_angle_cos_angle_inv;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_10 = beta_rate_dot_of_place_9 * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_11 = cos_phi_inv * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_12 = beta_rate_dot_of_place_4 * sin_phi;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_13 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let m6_fa = m6 * fa;
    // i6_zf_inv + d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let beta_rate_dot_of_place_14 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_of_place_14
    let beta_rate_dot_of_place_15 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_of_place_14);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let beta_rate_dot_of_place_16 = d1_of_place_7 * cos_omega_inv;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_17 = d1_of_place_7
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_15);
    let beta_rate_dot_of_place_18 = beta_rate_dot_of_zf_fa * sin_gamma_minus_epsilon;
    let fa_ss_inv = fa * ss_inv;
    let beta_rate_dot_of_place_19 = beta_rate_dot_of_place_9 * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_20 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_21 = beta_rate_dot_of_place_15 * sin_omega;
    let beta_rate_dot_of_place_22 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_23 = beta_rate_dot_of_place_22 * sin_omega;
    let beta_rate_dot_of_place_24 = zf_inv * beta_rate_dot_of_place_23;
    let beta_rate_dot_of_place_25 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_26 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let beta_rate_dot_of_place_27 = d1_of_d_beta_gamma * rr_cos_angle_inv;
    // sin(beta - gamma) - beta_rate_dot_of_place_25*beta_rate_dot_of_place_27
    let beta_rate_dot_of_place_28 = (-beta_rate_dot_of_place_25)
        .mul_add(beta_rate_dot_of_place_27, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_29 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // beta_rate' = (mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_29 * (l0 - beta_rate_dot_of_place_29)
                    * (-sd)
                        .mul_add(beta_rate_dot_of_place_2, sc * beta_rate_dot_of_place)
                    / (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
                        + sd * beta_rate_dot_of_place.mul_add(S::int(2), sd)
                        + sc * beta_rate_dot_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (m2_da_d1_of_d_beta_gamma
                            + cos_angle_inv
                                * (-rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_phi_inv_sq
                                                    * (d1_of_place_2
                                                        * (zt_inv
                                                            * (cos_phi_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (e_inv
                                                                        * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                            - beta_rate_dot_of_place_4 * d1_of_place_6
                                                                            + sin_phi_cos_phi_inv
                                                                                * (d1_of_place_2
                                                                                    * sin_phi_doubled.mul_add(m4_ea, d1_of_place_6)
                                                                                    - beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                        + m4
                                                                            * (-d1_of_place_4)
                                                                                .mul_add(sin_phi_cos_phi_inv, sin_gamma_minus_delta))
                                                                    - d1_of_place_2 * sin_phi
                                                                        * (beta_rate_dot_of_place_5 * (m4 + zt_inv_d1_of_place_6)
                                                                            + m4 * beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                + zt_inv * ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_7,
                                                                            I5 * beta_rate_dot_of_place_7,
                                                                        ) + m4 * d1_of_place_2 * beta_rate_dot_of_place_8)
                                                            - m4
                                                                * (e_inv
                                                                    * (cos_gamma_minus_delta
                                                                        * (beta_rate_dot_of_place_8
                                                                            + beta_rate_dot_of_place_4 * cos_phi_inv
                                                                            - sin_phi
                                                                                * (cos_phi_inv_sq
                                                                                    * (-sin_phi_doubled)
                                                                                        .mul_add(beta_rate_dot_of_place_8, d1_of_place_2)
                                                                                    + beta_rate_dot_of_place_9 * ea_ss_inv))
                                                                        - beta_rate_dot_of_place_3 * ea_ss_inv)
                                                                    + ss_inv
                                                                        * (beta_rate_dot_of_place_6
                                                                            + sin_phi
                                                                                * (sin_gamma_minus_delta + beta_rate_dot_of_place_10))))
                                                        + cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        beta_rate_dot_of_place_13,
                                                                        d1_of_place_5 * sin_phi_cos_phi_inv
                                                                            * beta_rate_dot_of_place_11,
                                                                    )
                                                                + m4
                                                                    * (e_inv
                                                                        * (sin_phi_cos_phi_inv * cos_gamma_minus_delta
                                                                            * (beta_rate_dot_of_place_11 - beta_rate_dot_of_place_4)
                                                                            + ea
                                                                                * (e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * (sin_phi_cos_phi_inv
                                                                                            * d1_of_e_ea
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_of_place_11,
                                                                                                    beta_rate_dot_of_place_4,
                                                                                                ) - sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                        - ea_ss_inv * sin_gamma_minus_delta)
                                                                                    + ss_inv
                                                                                        * (sin_gamma_minus_delta
                                                                                            .mul_add(S::int(2), beta_rate_dot_of_place_10)
                                                                                            - beta_rate_dot_of_place_12)))
                                                                        + ss_inv
                                                                            * (beta_rate_dot_of_place_12 - beta_rate_dot_of_place_13))))
                                                    - ss_inv * ss_inv_d1_of_place_12 * sin_angle_cos_angle_inv
                                                    - cos_omega_inv_sq
                                                        * (d1_of_place_7
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - beta_rate_dot_of_place_15 * d1_of_place_10
                                                                                + sin_omega_cos_omega_inv
                                                                                    * (d1_of_place_7
                                                                                        * sin_omega_doubled.mul_add(m6_fa, -d1_of_place_10)
                                                                                        + beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                            + m6
                                                                                * d1_of_place_9
                                                                                    .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                        + d1_of_place_7 * sin_omega
                                                                            * (beta_rate_dot_of_place_16 * (m6 + u_2_inv_d1_of_place_10)
                                                                                + m6 * beta_rate_dot_of_zf_fa * cos_gamma_minus_epsilon))
                                                                    + u_2_inv * ss_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_17,
                                                                                I7 * beta_rate_dot_of_place_17,
                                                                            ) + m6 * d1_of_place_7 * beta_rate_dot_of_place_18)
                                                                + m6
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_17
                                                                            + sin_omega
                                                                                * (cos_gamma_minus_epsilon - beta_rate_dot_of_place_19))
                                                                        - zf_inv
                                                                            * (sin_gamma_minus_epsilon
                                                                                * (beta_rate_dot_of_place_18
                                                                                    + beta_rate_dot_of_place_15 * cos_omega_inv
                                                                                    + sin_omega
                                                                                        * (cos_omega_inv_sq
                                                                                            * sin_omega_doubled
                                                                                                .mul_add(beta_rate_dot_of_place_18, d1_of_place_7)
                                                                                            - beta_rate_dot_of_place_9 * fa_ss_inv))
                                                                                + beta_rate_dot_of_place_14 * fa_ss_inv)))
                                                            + sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (zf_inv
                                                                        * (beta_rate_dot_of_place_23
                                                                            * (beta_rate_dot_of_place_15 - beta_rate_dot_of_place_22)
                                                                            + fa
                                                                                * (ss_inv
                                                                                    * (cos_gamma_minus_epsilon
                                                                                        .mul_add(S::int(2), -beta_rate_dot_of_place_19)
                                                                                        - fa_zf_inv * beta_rate_dot_of_place_20
                                                                                        + beta_rate_dot_of_place_21)
                                                                                    - beta_rate_dot_of_place_24
                                                                                        * d1_of_zf_fa
                                                                                            .mul_add(
                                                                                                beta_rate_dot_of_place_22,
                                                                                                beta_rate_dot_of_place_15,
                                                                                            )))
                                                                        - ss_inv
                                                                            * (beta_rate_dot_of_place_20 + beta_rate_dot_of_place_21))
                                                                    - zf_inv_i6_zf_inv
                                                                        * beta_rate_dot_of_place_22
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_24,
                                                                                ss_inv * beta_rate_dot_of_place_20,
                                                                            ))))
                                                + d1_of_place_13 * d1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            + d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (d1_of_place_11
                                                        + ss_inv * m2_da.mul_add(sin_angle, d1_of_place_12))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_25)))
                                        + m2_da * d_inv
                                            * (-ss_inv)
                                                .mul_add(
                                                    beta_rate_dot_of_place_26,
                                                    d1_of_d_beta_gamma * cos_beta_minus_gamma,
                                                )) + d1_of_place_13 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_28,
                                    rr * beta_rate_dot_of_place_25 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_28)
                        - m2_da * beta_rate_dot_of_place_26))) / d1;
    let gamma_dot_value_of_beta_rate = beta_rate * rr_cos_angle_inv * sin_theta;
    let delta_dot_value_of_beta_rate = zt_inv * gamma_dot_value_of_beta_rate;
    let epsilon_dot_value_of_beta_rate = u_2_inv * gamma_dot_value_of_beta_rate;
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = beta_rate * (beta_rate_dot_of_place_27 - S::int(1));
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = ss_inv * gamma_dot_value_of_beta_rate;
    // delta' = rr*beta_rate*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_value = beta_rate_dot_of_place_5 * delta_dot_value_of_beta_rate;
    // phi' = rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let phi_dot_value = e_inv * cos_phi_inv * delta_dot_value_of_beta_rate
        * (-e).mul_add(d1_of_place_2, zt * cos_gamma_minus_delta);
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = beta_rate_dot_of_place_16 * epsilon_dot_value_of_beta_rate;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = zf_inv * cos_omega_inv * epsilon_dot_value_of_beta_rate
        * (-zf).mul_add(d1_of_place_7, u_2 * sin_gamma_minus_epsilon);
    (
        [
            beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
            epsilon_dot_value, omega_dot_value,
        ],
        [beta_rate_dot],
    )
}

/// Jacobian of the derivative by the state; columns beta, theta, gamma, delta, phi, epsilon, omega, beta_rate.
///
/// 1760 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [[S; 8]; 8] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // beta + theta - gamma
    let d1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    let d1_of_place_2 = cos_gamma_minus_delta * sin_phi;
    // sin(gamma - delta)*cos(phi) - d1_of_place_2
    let d1_of_place_3 = sin_gamma_minus_delta.mul_add(cos_phi, -d1_of_place_2);
    let sin_phi_d1_of_place_3 = d1_of_place_3 * sin_phi;
    let d1_of_place_4 = S::int(2) * sin_phi_d1_of_place_3;
    // cos(gamma - delta) + d1_of_place_4
    let d1_of_place_5 = cos_gamma_minus_delta + d1_of_place_4;
    // ea_e_inv*(d1_of_e_ea*cos(gamma - delta) - d1_of_place_4) + d1_of_place_5
    let d1_of_place_6 = ea_e_inv
        * d1_of_e_ea.mul_add(cos_gamma_minus_delta, -d1_of_place_4) + d1_of_place_5;
    let d1_of_place_7 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    let d1_of_place_3_zt_inv = d1_of_place_3 * zt_inv;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // I5 + m5*ta_sq_plus_tb_sq
    let d1_of_m5_i5_ta_tb = m5.mul_add(ta_sq_plus_tb_sq, I5);
    let d1_of_place_8 = d1_of_place_3_zt_inv * d1_of_m5_i5_ta_tb;
    // m4*(sin(gamma - delta - phi)^2 + d1_of_place_6*cos(gamma - delta)) + I4*d1_of_place_7^2 +
    //   d1_of_place_3_zt_inv*d1_of_place_8
    let d1_of_place_9 = m4
        * d1_of_place_6.mul_add(cos_gamma_minus_delta, d1_of_place_3 * d1_of_place_3)
        + I4 * d1_of_place_7 * d1_of_place_7 + d1_of_place_3_zt_inv * d1_of_place_8;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let d1_of_zf_fa = fa_zf_inv - S::int(2);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    let d1_of_place_10 = sin_gamma_minus_epsilon * sin_omega;
    let d1_of_place_11 = cos_gamma_minus_epsilon * cos_omega;
    // d1_of_place_10 + d1_of_place_11
    let d1_of_place_12 = d1_of_place_10 + d1_of_place_11;
    let sin_omega_d1_of_place_12 = d1_of_place_12 * sin_omega;
    let d1_of_place_13 = S::int(2) * sin_omega_d1_of_place_12;
    // sin(gamma - epsilon) - d1_of_place_13
    let d1_of_place_14 = sin_gamma_minus_epsilon - d1_of_place_13;
    // fa_zf_inv*(d1_of_zf_fa*sin(gamma - epsilon) + d1_of_place_13) + d1_of_place_14
    let d1_of_place_15 = fa_zf_inv
        * d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_13) + d1_of_place_14;
    let d1_of_place_16 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    let d1_of_place_12_u_2_inv = d1_of_place_12 * u_2_inv;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // I7 + m7*ua_sq_plus_ub_sq
    let d1_of_m7_i7_ua_ub = m7.mul_add(ua_sq_plus_ub_sq, I7);
    let d1_of_place_17 = d1_of_place_12_u_2_inv * d1_of_m7_i7_ua_ub;
    // m6*(cos(gamma - epsilon - omega)^2 + d1_of_place_15*sin(gamma - epsilon)) + I6*d1_of_place_16^2 +
    //   d1_of_place_12_u_2_inv*d1_of_place_17
    let d1_of_place_18 = m6
        * d1_of_place_15
            .mul_add(sin_gamma_minus_epsilon, d1_of_place_12 * d1_of_place_12)
        + I6 * d1_of_place_16 * d1_of_place_16 + d1_of_place_12_u_2_inv * d1_of_place_17;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // d1_of_place_9*cos_phi_inv_sq + d1_of_place_18*cos_omega_inv_sq
    let d1_of_place_19 = d1_of_place_18
        .mul_add(cos_omega_inv_sq, d1_of_place_9 * cos_phi_inv_sq);
    let ss_inv = S::int(1) / ss;
    // sa^2 + sb^2
    let sa_sq_plus_sb_sq = sb.mul_add(sb, sa * sa);
    // ss_inv*(I3 + m3*sa_sq_plus_sb_sq)
    let d1_of_place_20 = ss_inv * m3.mul_add(sa_sq_plus_sb_sq, I3);
    // d1_of_place_19 + ss_inv*d1_of_place_20
    let d1_of_place_21 = ss_inv.mul_add(d1_of_place_20, d1_of_place_19);
    let sin_theta_d1_of_place_21 = d1_of_place_21 * sin_theta;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d1_of_place_22 = d1_of_d_beta_gamma * i2_plus_da_m2_da;
    // cos_angle_inv*(sin_theta_d1_of_place_21*sin(theta) + d1_of_d_beta_gamma*d1_of_place_22)
    let d1_of_place_23 = cos_angle_inv
        * d1_of_d_beta_gamma
            .mul_add(d1_of_place_22, sin_theta_d1_of_place_21 * sin_theta);
    let cos_theta_m2_da = m2_da * cos_theta;
    let d1_of_place_24 = d1_of_d_beta_gamma * cos_theta_m2_da;
    // d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let d1 = I1 + m1 * ra * ra
        + rr * rr
            * (m2 + cos_angle_inv * (-d1_of_place_24).mul_add(S::int(2), d1_of_place_23));
    let d1_by_beta_of_d_beta_gamma = d_inv * sin_beta_minus_gamma;
    let d1_by_beta_of_place = cos_theta_m2_da * d1_by_beta_of_d_beta_gamma;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let rr_doubled = S::int(2) * rr;
    let d1_by_beta_of_place_2 = rr_cos_angle_inv * rr_doubled;
    // d1_by_beta = 2*rr^2*(m2*da*cos(theta)*sin(beta - gamma)/d - (sin(beta - gamma)*cos(beta - gamma)*(I2
    //   + m2*da^2)/d^2 + sin(beta + theta - gamma)*(m2*da*cos(theta)*cos(beta - gamma)/d - (cos(beta -
    //   gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma -
    //   delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta -
    //   phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma)))/cos(beta
    //   + theta - gamma))/cos(beta + theta - gamma)
    let d1_by_beta = d1_by_beta_of_place_2
        * (cos_angle_inv
            * (sin_angle * (d1_of_place_23 - d1_of_place_24)
                - d1_of_place_22 * d1_by_beta_of_d_beta_gamma) + d1_by_beta_of_place);
    let d1_inv = S::int(1) / d1;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let d1_of_d_beta_gamma_m2_da = d1_of_d_beta_gamma * m2_da;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let beta_rate_dot_by_beta_of_place = xb_minus_xc
        .mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_by_beta_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    // sc*beta_rate_dot_by_beta_of_place - sd*beta_rate_dot_by_beta_of_place_2
    let beta_rate_dot_by_beta_of_place_3 = (-sd)
        .mul_add(beta_rate_dot_by_beta_of_place_2, sc * beta_rate_dot_by_beta_of_place);
    // xb*(xb - 2*xc)
    let beta_rate_dot_by_beta_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_by_beta_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_by_beta_of_place_4 = (xc_sq + beta_rate_dot_by_beta_of_xb_xc
        + yc_sq + beta_rate_dot_by_beta_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // l0 - sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_by_beta_of_place_5 = l0 - beta_rate_dot_by_beta_of_place_4;
    // 1/(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sd*(sd + 2*beta_rate_dot_by_beta_of_place) +
    //   sc*(sc + 2*beta_rate_dot_by_beta_of_place_2))
    let beta_rate_dot_by_beta_of_place_6 = S::int(1)
        / (xc_sq + beta_rate_dot_by_beta_of_xb_xc + yc_sq + beta_rate_dot_by_beta_of_yb_yc
            + sd * beta_rate_dot_by_beta_of_place.mul_add(S::int(2), sd)
            + sc * beta_rate_dot_by_beta_of_place_2.mul_add(S::int(2), sc));
    let beta_rate_dot_by_beta_of_place_7 = beta_rate_dot_by_beta_of_place_6
        * beta_rate_dot_by_beta_of_place_4;
    let beta_rate_dot_by_beta_of_place_8 = c0 * ss_inv * beta_rate_dot_by_beta_of_place_7;
    let beta_rate_dot_by_beta_of_place_9 = beta_rate_dot_by_beta_of_place_3
        * beta_rate_dot_by_beta_of_place_5 * beta_rate_dot_by_beta_of_place_8;
    let d1_by_beta_d1_inv = d1_by_beta * d1_inv;
    let beta_rate_dot_by_beta_of_place_10 = m2_da * d1_by_beta_of_d_beta_gamma;
    let beta_rate_dot_by_beta_of_place_11 = i2_plus_da_m2_da * sin_beta_minus_gamma;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // 4*sin_angle_cos_angle_inv - d1_by_beta_d1_inv
    let beta_rate_dot_by_beta_of_place_12 = sin_angle_cos_angle_inv
        .mul_add(S::int(4), -d1_by_beta_d1_inv);
    let beta_rate_dot_by_beta_of_place_13 = i2_plus_da_m2_da
        * beta_rate_dot_by_beta_of_place_12 * cos_beta_minus_gamma;
    let beta_rate_dot_by_beta_of_place_14 = cos_theta_m2_da * sin_angle;
    let beta_rate_dot_by_beta_of_beta_gamma = S::int(2) * sin_beta_minus_gamma;
    // cos(beta - gamma) - d1_by_beta_d1_inv*sin(beta - gamma)
    let beta_rate_dot_by_beta_of_place_15 = (-d1_by_beta_d1_inv)
        .mul_add(sin_beta_minus_gamma, cos_beta_minus_gamma);
    let beta_rate_dot_by_beta_of_place_16 = cos_theta * cos_beta_minus_gamma;
    let beta_rate_dot_by_beta_of_place_17 = rr * beta_rate_dot_by_beta_of_place_16;
    let beta_rate_dot_by_beta_of_place_18 = beta_rate_dot_by_beta_of_place_11
        * sin_beta_minus_gamma;
    let beta_rate_dot_by_beta_of_place_19 = S::int(2) * beta_rate_dot_by_beta_of_place_12;
    let beta_rate_dot_by_beta_of_place_20 = d1_of_e_ea * sin_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_21 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + beta_rate_dot_by_beta_of_place_21
    let beta_rate_dot_by_beta_of_place_22 = cos_gamma_minus_delta
        .mul_add(cos_phi, beta_rate_dot_by_beta_of_place_21);
    let beta_rate_dot_by_beta_of_place_23 = S::int(3) * beta_rate_dot_by_beta_of_place_22;
    // sin(phi)*(beta_rate_dot_by_beta_of_place_23 - sin(gamma - delta -
    //   phi)*beta_rate_dot_by_beta_of_place_19)
    let beta_rate_dot_by_beta_of_place_24 = sin_phi
        * (-d1_of_place_3)
            .mul_add(
                beta_rate_dot_by_beta_of_place_19, beta_rate_dot_by_beta_of_place_23,
            );
    // 3*sin(gamma - delta) + beta_rate_dot_by_beta_of_place_12*cos(gamma - delta)
    let beta_rate_dot_by_beta_of_place_25 = beta_rate_dot_by_beta_of_place_12
        .mul_add(cos_gamma_minus_delta, S::int(3) * sin_gamma_minus_delta);
    // sin(gamma - delta - phi)*beta_rate_dot_by_beta_of_place_12 - beta_rate_dot_by_beta_of_place_23
    let beta_rate_dot_by_beta_of_place_26 = d1_of_place_3
        .mul_add(beta_rate_dot_by_beta_of_place_12, -beta_rate_dot_by_beta_of_place_23);
    // ea_e_inv - 1
    let beta_rate_dot_by_beta_of_e_ea = ea_e_inv - S::int(1);
    let beta_rate_dot_by_beta_of_place_27 = beta_rate_dot_by_beta_of_e_ea * sin_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_28 = beta_rate_dot_by_beta_of_place_27 * sin_phi;
    let i4_e_inv = I4 * e_inv;
    let d1_of_place_7_i4_e_inv = d1_of_place_7 * i4_e_inv;
    let beta_rate_dot_by_beta_of_place_29 = d1_of_zf_fa * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_30 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_by_beta_of_place_30
    let beta_rate_dot_by_beta_of_place_31 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_by_beta_of_place_30);
    let beta_rate_dot_by_beta_of_place_32 = S::int(3) * beta_rate_dot_by_beta_of_place_31;
    // sin(omega)*(cos(gamma - epsilon - omega)*beta_rate_dot_by_beta_of_place_19 +
    //   beta_rate_dot_by_beta_of_place_32)
    let beta_rate_dot_by_beta_of_place_33 = sin_omega
        * d1_of_place_12
            .mul_add(
                beta_rate_dot_by_beta_of_place_19, beta_rate_dot_by_beta_of_place_32,
            );
    // 3*cos(gamma - epsilon) - beta_rate_dot_by_beta_of_place_12*sin(gamma - epsilon)
    let beta_rate_dot_by_beta_of_place_34 = (-beta_rate_dot_by_beta_of_place_12)
        .mul_add(sin_gamma_minus_epsilon, S::int(3) * cos_gamma_minus_epsilon);
    // cos(gamma - epsilon - omega)*beta_rate_dot_by_beta_of_place_12 + beta_rate_dot_by_beta_of_place_32
    let beta_rate_dot_by_beta_of_place_35 = d1_of_place_12
        .mul_add(beta_rate_dot_by_beta_of_place_12, beta_rate_dot_by_beta_of_place_32);
    // 1 - fa_zf_inv
    let beta_rate_dot_by_beta_of_zf_fa = S::int(1) - fa_zf_inv;
    // -beta_rate_dot_by_beta_of_zf_fa
    let beta_rate_dot_by_beta_of_zf_fa_2 = -beta_rate_dot_by_beta_of_zf_fa;
    let beta_rate_dot_by_beta_of_place_36 = beta_rate_dot_by_beta_of_zf_fa_2
        * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_37 = beta_rate_dot_by_beta_of_place_36 * sin_omega;
    let i6_zf_inv = I6 * zf_inv;
    let d1_of_place_16_i6_zf_inv = d1_of_place_16 * i6_zf_inv;
    let ss_inv_sq = ss_inv * ss_inv;
    let zt_inv_d1_of_m5_i5_ta_tb = zt_inv * d1_of_m5_i5_ta_tb;
    let sin_phi_doubled = S::int(2) * sin_phi;
    let m4_ea = m4 * ea;
    // zt_inv_d1_of_m5_i5_ta_tb + sin_phi_doubled*m4_ea
    let beta_rate_dot_by_beta_of_place_38 = sin_phi_doubled
        .mul_add(m4_ea, zt_inv_d1_of_m5_i5_ta_tb);
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_by_beta_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let beta_rate_dot_by_beta_of_place_39 = beta_rate_dot_by_beta_of_m4_i4_e_ea
        * cos_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_place_39 - sin(gamma - delta - phi)*beta_rate_dot_by_beta_of_place_38
    let beta_rate_dot_by_beta_of_place_40 = (-d1_of_place_3)
        .mul_add(beta_rate_dot_by_beta_of_place_38, beta_rate_dot_by_beta_of_place_39);
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let beta_rate_dot_by_beta_of_place_41 = beta_rate_dot_by_beta_of_place_22
        * zt_inv_d1_of_m5_i5_ta_tb;
    let beta_rate_dot_by_beta_of_place_42 = beta_rate_dot_by_beta_of_m4_i4_e_ea
        * sin_gamma_minus_delta;
    // m4*(sin(gamma - delta) - d1_of_place_5*sin_phi_cos_phi_inv) +
    //   e_inv*(beta_rate_dot_by_beta_of_place_42 - beta_rate_dot_by_beta_of_place_40*sin_phi_cos_phi_inv -
    //   beta_rate_dot_by_beta_of_place_41)
    let beta_rate_dot_by_beta_of_place_43 = m4
        * (-d1_of_place_5).mul_add(sin_phi_cos_phi_inv, sin_gamma_minus_delta)
        + e_inv
            * ((-beta_rate_dot_by_beta_of_place_40)
                .mul_add(sin_phi_cos_phi_inv, beta_rate_dot_by_beta_of_place_42)
                - beta_rate_dot_by_beta_of_place_41);
    // m4 + zt_inv*zt_inv_d1_of_m5_i5_ta_tb
    let beta_rate_dot_by_beta_of_place_44 = zt_inv.mul_add(zt_inv_d1_of_m5_i5_ta_tb, m4);
    let beta_rate_dot_by_beta_of_place_45 = d1_of_place_3 * cos_phi_inv;
    // m4*beta_rate_dot_by_beta_of_place_27 +
    //   beta_rate_dot_by_beta_of_place_44*beta_rate_dot_by_beta_of_place_45
    let beta_rate_dot_by_beta_of_place_46 = beta_rate_dot_by_beta_of_place_44
        .mul_add(
            beta_rate_dot_by_beta_of_place_45,
            m4 * beta_rate_dot_by_beta_of_place_27,
        );
    // beta_rate_dot_by_beta_of_place_43*cos(gamma - delta) -
    //   sin_phi_d1_of_place_3*beta_rate_dot_by_beta_of_place_46
    let beta_rate_dot_by_beta_of_place_47 = (-sin_phi_d1_of_place_3)
        .mul_add(
            beta_rate_dot_by_beta_of_place_46,
            beta_rate_dot_by_beta_of_place_43 * cos_gamma_minus_delta,
        );
    let beta_rate_dot_by_beta_of_place_48 = beta_rate_dot_by_beta_of_e_ea * cos_gamma_minus_delta;
    // sin_phi_doubled*beta_rate_dot_by_beta_of_place_48 - sin(gamma - delta - phi)
    let beta_rate_dot_by_beta_of_place_49 = sin_phi_doubled
        .mul_add(beta_rate_dot_by_beta_of_place_48, -d1_of_place_3);
    // cos(gamma - delta - phi) + sin_phi_cos_phi_inv*beta_rate_dot_by_beta_of_place_49
    let beta_rate_dot_by_beta_of_place_50 = sin_phi_cos_phi_inv
        .mul_add(beta_rate_dot_by_beta_of_place_49, beta_rate_dot_by_beta_of_place_22);
    let beta_rate_dot_by_beta_of_place_51 = cos_phi_inv * cos_gamma_minus_delta;
    // cos(gamma - delta - phi) + d1_of_e_ea*beta_rate_dot_by_beta_of_place_51
    let beta_rate_dot_by_beta_of_place_52 = d1_of_e_ea
        .mul_add(beta_rate_dot_by_beta_of_place_51, beta_rate_dot_by_beta_of_place_22);
    // cos(gamma - delta - phi) - beta_rate_dot_by_beta_of_place_51
    let beta_rate_dot_by_beta_of_place_53 = beta_rate_dot_by_beta_of_place_22
        - beta_rate_dot_by_beta_of_place_51;
    // d1_of_place_7 - d1_of_place_3_zt_inv
    let beta_rate_dot_by_beta_of_place_54 = d1_of_place_7 - d1_of_place_3_zt_inv;
    let m4_d1_of_place_3 = m4 * d1_of_place_3;
    let beta_rate_dot_by_beta_of_place_55 = u_2_inv * d1_of_m7_i7_ua_ub;
    let sin_omega_doubled = S::int(2) * sin_omega;
    let m6_fa = m6 * fa;
    // beta_rate_dot_by_beta_of_place_55 - sin_omega_doubled*m6_fa
    let beta_rate_dot_by_beta_of_place_56 = (-sin_omega_doubled)
        .mul_add(m6_fa, beta_rate_dot_by_beta_of_place_55);
    // i6_zf_inv + d1_of_zf_fa*m6_fa
    let beta_rate_dot_by_beta_of_m6_i6_zf_fa = d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let beta_rate_dot_by_beta_of_place_57 = beta_rate_dot_by_beta_of_m6_i6_zf_fa
        * sin_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_57 - cos(gamma - epsilon - omega)*beta_rate_dot_by_beta_of_place_56
    let beta_rate_dot_by_beta_of_place_58 = (-d1_of_place_12)
        .mul_add(beta_rate_dot_by_beta_of_place_56, beta_rate_dot_by_beta_of_place_57);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    let beta_rate_dot_by_beta_of_place_59 = beta_rate_dot_by_beta_of_place_31
        * beta_rate_dot_by_beta_of_place_55;
    let beta_rate_dot_by_beta_of_place_60 = beta_rate_dot_by_beta_of_m6_i6_zf_fa
        * cos_gamma_minus_epsilon;
    // m6*(cos(gamma - epsilon) + d1_of_place_14*sin_omega_cos_omega_inv) +
    //   zf_inv*(beta_rate_dot_by_beta_of_place_58*sin_omega_cos_omega_inv -
    //   beta_rate_dot_by_beta_of_place_59 + beta_rate_dot_by_beta_of_place_60)
    let beta_rate_dot_by_beta_of_place_61 = m6
        * d1_of_place_14.mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon)
        + zf_inv
            * (beta_rate_dot_by_beta_of_place_58
                .mul_add(sin_omega_cos_omega_inv, -beta_rate_dot_by_beta_of_place_59)
                + beta_rate_dot_by_beta_of_place_60);
    // m6 + u_2_inv*beta_rate_dot_by_beta_of_place_55
    let beta_rate_dot_by_beta_of_place_62 = u_2_inv
        .mul_add(beta_rate_dot_by_beta_of_place_55, m6);
    let beta_rate_dot_by_beta_of_place_63 = d1_of_place_12 * cos_omega_inv;
    let beta_rate_dot_by_beta_of_place_64 = beta_rate_dot_by_beta_of_place_62
        * beta_rate_dot_by_beta_of_place_63;
    // m6*beta_rate_dot_by_beta_of_place_36 + beta_rate_dot_by_beta_of_place_64
    let beta_rate_dot_by_beta_of_place_65 = m6
        .mul_add(beta_rate_dot_by_beta_of_place_36, beta_rate_dot_by_beta_of_place_64);
    // beta_rate_dot_by_beta_of_place_61*sin(gamma - epsilon) +
    //   sin_omega_d1_of_place_12*beta_rate_dot_by_beta_of_place_65
    let beta_rate_dot_by_beta_of_place_66 = sin_omega_d1_of_place_12
        .mul_add(
            beta_rate_dot_by_beta_of_place_65,
            beta_rate_dot_by_beta_of_place_61 * sin_gamma_minus_epsilon,
        );
    let beta_rate_dot_by_beta_of_place_67 = beta_rate_dot_by_beta_of_zf_fa_2
        * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon - omega) + sin_omega_doubled*beta_rate_dot_by_beta_of_place_67
    let beta_rate_dot_by_beta_of_place_68 = sin_omega_doubled
        .mul_add(beta_rate_dot_by_beta_of_place_67, d1_of_place_12);
    // sin(gamma - epsilon - omega) + sin_omega_cos_omega_inv*beta_rate_dot_by_beta_of_place_68
    let beta_rate_dot_by_beta_of_place_69 = sin_omega_cos_omega_inv
        .mul_add(beta_rate_dot_by_beta_of_place_68, beta_rate_dot_by_beta_of_place_31);
    let beta_rate_dot_by_beta_of_place_70 = cos_omega_inv * sin_gamma_minus_epsilon;
    // sin(gamma - epsilon - omega) + d1_of_zf_fa*beta_rate_dot_by_beta_of_place_70
    let beta_rate_dot_by_beta_of_place_71 = d1_of_zf_fa
        .mul_add(beta_rate_dot_by_beta_of_place_70, beta_rate_dot_by_beta_of_place_31);
    // sin(gamma - epsilon - omega) - beta_rate_dot_by_beta_of_place_70
    let beta_rate_dot_by_beta_of_place_72 = beta_rate_dot_by_beta_of_place_31
        - beta_rate_dot_by_beta_of_place_70;
    // d1_of_place_16 - d1_of_place_12_u_2_inv
    let beta_rate_dot_by_beta_of_place_73 = d1_of_place_16 - d1_of_place_12_u_2_inv;
    let m6_d1_of_place_12 = m6 * d1_of_place_12;
    // cos_phi_inv_sq*(cos_phi_inv*(sin(gamma - delta - phi)*(zt_inv*beta_rate_dot_by_beta_of_place_47 -
    //   m4*d1_of_place_7*beta_rate_dot_by_beta_of_place_50) +
    //   d1_of_place_2*d1_of_place_7*(cos_phi_inv*d1_of_place_7_i4_e_inv -
    //   m4*(beta_rate_dot_by_beta_of_place_53 - ea_e_inv*beta_rate_dot_by_beta_of_place_52))) -
    //   m4_d1_of_place_3*cos(gamma - delta)*(d1_of_place_3_zt_inv +
    //   e_inv*(ea*beta_rate_dot_by_beta_of_place_54 - cos(gamma - delta)))) +
    //   cos_omega_inv_sq*(m6_d1_of_place_12*sin(gamma - epsilon)*(d1_of_place_12_u_2_inv +
    //   zf_inv*(fa*beta_rate_dot_by_beta_of_place_73 - sin(gamma - epsilon))) - cos_omega_inv*(cos(gamma -
    //   epsilon - omega)*(u_2_inv*beta_rate_dot_by_beta_of_place_66 -
    //   m6*d1_of_place_16*beta_rate_dot_by_beta_of_place_69) +
    //   d1_of_place_10*d1_of_place_16*(m6*(beta_rate_dot_by_beta_of_place_72 -
    //   fa_zf_inv*beta_rate_dot_by_beta_of_place_71) - cos_omega_inv*d1_of_place_16_i6_zf_inv)))
    let beta_rate_dot_by_beta_of_place_74 = cos_phi_inv_sq
        * (cos_phi_inv
            * (d1_of_place_3
                * (-(m4 * d1_of_place_7))
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_50,
                        zt_inv * beta_rate_dot_by_beta_of_place_47,
                    )
                + d1_of_place_2 * d1_of_place_7
                    * (-m4
                        * (-ea_e_inv)
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_52,
                                beta_rate_dot_by_beta_of_place_53,
                            ) + cos_phi_inv * d1_of_place_7_i4_e_inv))
            - m4_d1_of_place_3 * cos_gamma_minus_delta
                * (d1_of_place_3_zt_inv
                    + e_inv
                        * ea
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_54, -cos_gamma_minus_delta,
                            )))
        + cos_omega_inv_sq
            * (m6_d1_of_place_12 * sin_gamma_minus_epsilon
                * (d1_of_place_12_u_2_inv
                    + zf_inv
                        * fa
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_73, -sin_gamma_minus_epsilon,
                            ))
                - cos_omega_inv
                    * (d1_of_place_12
                        * (-(m6 * d1_of_place_16))
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_69,
                                u_2_inv * beta_rate_dot_by_beta_of_place_66,
                            )
                        + d1_of_place_10 * d1_of_place_16
                            * (m6
                                * (-fa_zf_inv)
                                    .mul_add(
                                        beta_rate_dot_by_beta_of_place_71,
                                        beta_rate_dot_by_beta_of_place_72,
                                    ) - cos_omega_inv * d1_of_place_16_i6_zf_inv)));
    let beta_rate_dot_by_beta_of_place_75 = m4 * beta_rate_dot_by_beta_of_place_48;
    let beta_rate_dot_by_beta_of_place_76 = d1_of_place_3 * beta_rate_dot_by_beta_of_place_75;
    // cos_phi_inv*beta_rate_dot_by_beta_of_place_47 + beta_rate_dot_by_beta_of_place_76
    let beta_rate_dot_by_beta_of_place_77 = cos_phi_inv
        .mul_add(beta_rate_dot_by_beta_of_place_47, beta_rate_dot_by_beta_of_place_76);
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_by_beta_of_place_78 = ea_ss_inv * sin_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_79 = beta_rate_dot_by_beta_of_place_78 * sin_phi;
    let beta_rate_dot_by_beta_of_place_80 = sin_phi_cos_phi_inv * cos_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_81 = beta_rate_dot_by_beta_of_place_22 * sin_phi;
    let beta_rate_dot_by_beta_of_gamma_delta = S::int(2) * sin_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_place_81 - beta_rate_dot_by_beta_of_gamma_delta
    let beta_rate_dot_by_beta_of_place_82 = beta_rate_dot_by_beta_of_place_81
        - beta_rate_dot_by_beta_of_gamma_delta;
    // -beta_rate_dot_by_beta_of_place_53
    let beta_rate_dot_by_beta_of_place_83 = -beta_rate_dot_by_beta_of_place_53;
    let beta_rate_dot_by_beta_of_place_84 = beta_rate_dot_by_beta_of_place_80
        * beta_rate_dot_by_beta_of_place_83;
    // sin(gamma - delta) - beta_rate_dot_by_beta_of_place_81
    let beta_rate_dot_by_beta_of_place_85 = sin_gamma_minus_delta
        - beta_rate_dot_by_beta_of_place_81;
    let beta_rate_dot_by_beta_of_place_86 = cos_phi_inv * beta_rate_dot_by_beta_of_place_80;
    let beta_rate_dot_by_beta_of_place_87 = d1_of_place_7 * beta_rate_dot_by_beta_of_place_86;
    let e_inv_i4_e_inv = e_inv * i4_e_inv;
    let beta_rate_dot_by_beta_of_place_88 = cos_omega_inv * beta_rate_dot_by_beta_of_place_66;
    let beta_rate_dot_by_beta_of_place_89 = m6 * beta_rate_dot_by_beta_of_place_67;
    let beta_rate_dot_by_beta_of_place_90 = d1_of_place_12 * beta_rate_dot_by_beta_of_place_89;
    // beta_rate_dot_by_beta_of_place_88 + beta_rate_dot_by_beta_of_place_90
    let beta_rate_dot_by_beta_of_place_91 = beta_rate_dot_by_beta_of_place_88
        + beta_rate_dot_by_beta_of_place_90;
    let fa_ss_inv = fa * ss_inv;
    let beta_rate_dot_by_beta_of_place_92 = beta_rate_dot_by_beta_of_place_30 * fa_ss_inv;
    let beta_rate_dot_by_beta_of_place_93 = sin_omega_cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_94 = beta_rate_dot_by_beta_of_place_31 * sin_omega;
    let beta_rate_dot_by_beta_of_place_95 = S::int(2) * cos_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_94 + beta_rate_dot_by_beta_of_place_95
    let beta_rate_dot_by_beta_of_place_96 = beta_rate_dot_by_beta_of_place_94
        + beta_rate_dot_by_beta_of_place_95;
    // -beta_rate_dot_by_beta_of_place_72
    let beta_rate_dot_by_beta_of_place_97 = -beta_rate_dot_by_beta_of_place_72;
    let beta_rate_dot_by_beta_of_place_98 = beta_rate_dot_by_beta_of_place_93
        * beta_rate_dot_by_beta_of_place_97;
    // cos(gamma - epsilon) + beta_rate_dot_by_beta_of_place_94
    let beta_rate_dot_by_beta_of_place_99 = cos_gamma_minus_epsilon
        + beta_rate_dot_by_beta_of_place_94;
    let beta_rate_dot_by_beta_of_place_100 = cos_omega_inv * beta_rate_dot_by_beta_of_place_93;
    let beta_rate_dot_by_beta_of_place_101 = d1_of_place_16 * beta_rate_dot_by_beta_of_place_100;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let sin_angle_m2_da = m2_da * sin_angle;
    // d1_of_place_19 + ss_inv*(d1_of_place_20 + sin_angle_m2_da)
    let beta_rate_dot_by_beta_of_place_102 = d1_of_place_19
        + ss_inv * (d1_of_place_20 + sin_angle_m2_da);
    let cos_theta_doubled = S::int(2) * cos_theta;
    let d_inv_rr_beta_rate_sq = d_inv * rr_beta_rate_sq;
    // beta_rate_dot_by_beta = (rr*(m2*da*rr*beta_rate^2*cos(theta)*(d1_by_beta*sin(beta - gamma)/d1 -
    //   cos(beta - gamma))/d + (c0*sin(theta)*sin(beta + theta - gamma)*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(sin(theta)*(m2*da*cos(beta - gamma)*(sin(beta + theta
    //   - gamma) + 2*rr*sin(beta - gamma)/d)/d + d1_by_beta*(m2*da*rr*cos(beta - gamma)^2/d^2 -
    //   cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*rr*sin(beta - gamma)/d)/ss + (I4*cos(gamma -
    //   delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta -
    //   phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d1 + (2*cos(theta)*sin(beta + theta
    //   - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2) +
    //   rr*(sin(theta)*(sin(theta)*(((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma
    //   - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma -
    //   delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2)
    //   - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma
    //   - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/ss +
    //   d1_by_beta*((sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) +
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/(ss*zt) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/cos(phi)))/cos(phi))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss - cos(gamma -
    //   delta)*(cos(gamma - delta)*(ea/e - 1) + (cos(gamma - delta - phi) - tan(phi)*(2*cos(gamma -
    //   delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi)))/cos(phi)))/e + (cos(gamma - delta - phi) -
    //   sin(gamma - delta)*sin(phi))/ss)) - cos(gamma - delta)*(m4*((cos(gamma - delta)*tan(phi)*(cos(gamma
    //   - delta - phi) - cos(gamma - delta)/cos(phi)) + ea*((ea*sin(gamma - delta)/ss - cos(gamma -
    //   delta)*tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi)))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta))/ss))/e + (sin(gamma - delta) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*(sin(gamma - delta)/ss - cos(gamma -
    //   delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma - epsilon - omega)*((m6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) - sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/(ss*u) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u -
    //   cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 +
    //   m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega))/u + m6*((fa*cos(gamma
    //   - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + (sin(gamma -
    //   epsilon - omega) + tan(omega)*(2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)))/cos(omega)))/zf - (cos(gamma - epsilon)*sin(omega) + sin(gamma - epsilon - omega))/ss)) +
    //   sin(gamma - epsilon)*(I6*(cos(gamma - epsilon)/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((sin(gamma - epsilon)*tan(omega)*(sin(gamma -
    //   epsilon - omega) - sin(gamma - epsilon)/cos(omega)) + fa*((2*cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss - (fa*cos(gamma - epsilon)/ss + sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf -
    //   2)/cos(omega)))/zf))/zf - (cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss)))/cos(omega)^2)/d1 + tan(beta + theta - gamma)*(((I4*cos(gamma - delta)*(3*sin(gamma -
    //   delta) + cos(gamma - delta)*(4*tan(beta + theta - gamma) - d1_by_beta/d1))/e^2 + m4*(cos(gamma -
    //   delta)*(3*sin(gamma - delta) + cos(gamma - delta)*(4*tan(beta + theta - gamma) - d1_by_beta/d1) -
    //   sin(phi)*(3*cos(gamma - delta - phi) + 2*sin(gamma - delta - phi)*(d1_by_beta/d1 - 4*tan(beta +
    //   theta - gamma))) + ea*(sin(phi)*(3*cos(gamma - delta - phi) + 2*sin(gamma - delta -
    //   phi)*(d1_by_beta/d1 - 4*tan(beta + theta - gamma))) - 3*sin(gamma - delta)*(2 - ea/e) - cos(gamma -
    //   delta)*(8*tan(beta + theta - gamma) - 2*d1_by_beta/d1 + ea*(d1_by_beta/d1 - 4*tan(beta + theta -
    //   gamma))/e))/e) - sin(gamma - delta - phi)*(3*sin(gamma - delta)*sin(phi)*(ea/e - 1) + 3*cos(gamma -
    //   delta - phi) + sin(gamma - delta - phi)*(d1_by_beta/d1 - 4*tan(beta + theta - gamma)))) + sin(gamma
    //   - delta - phi)*(m5*(sin(gamma - delta - phi)*(ta^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1) +
    //   tb^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) - 3*cos(gamma - delta - phi)*(ta^2 + tb^2)) -
    //   I5*(3*cos(gamma - delta - phi) + sin(gamma - delta - phi)*(d1_by_beta/d1 - 4*tan(beta + theta -
    //   gamma))))/zt^2)/cos(phi)^2 + (cos(gamma - epsilon - omega)*(I7*(3*sin(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) + m7*(3*sin(gamma -
    //   epsilon - omega)*(ua^2 + ub^2) + cos(gamma - epsilon - omega)*(ua^2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1) + ub^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1))))/u^2 - I6*sin(gamma -
    //   epsilon)*(3*cos(gamma - epsilon) + sin(gamma - epsilon)*(d1_by_beta/d1 - 4*tan(beta + theta -
    //   gamma)))/zf^2 - m6*(sin(gamma - epsilon)*(3*cos(gamma - epsilon) + sin(gamma -
    //   epsilon)*(d1_by_beta/d1 - 4*tan(beta + theta - gamma)) + sin(omega)*(3*sin(gamma - epsilon - omega)
    //   + 2*cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) + fa*(3*cos(gamma -
    //   epsilon)*(fa/zf - 2) + sin(gamma - epsilon)*(8*tan(beta + theta - gamma) - 2*d1_by_beta/d1 +
    //   fa*(d1_by_beta/d1 - 4*tan(beta + theta - gamma))/zf) - sin(omega)*(3*sin(gamma - epsilon - omega) +
    //   2*cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)))/zf) - cos(gamma -
    //   epsilon - omega)*(3*cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + 3*sin(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1))))/cos(omega)^2 +
    //   (I3*(4*tan(beta + theta - gamma) - d1_by_beta/d1) + m3*(sa^2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1) + sb^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1)))/ss^2)/ss - 3*((sin(gamma -
    //   delta - phi)*((cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta
    //   - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) -
    //   tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta -
    //   phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/cos(phi)))/zt + m4*cos(gamma - delta)*(tan(phi)*(2*cos(gamma - delta)*sin(phi)*(1 -
    //   ea/e) + sin(gamma - delta - phi)) - cos(gamma - delta - phi))/e) + cos(gamma -
    //   delta)^2*sin(phi)*(I4*cos(gamma - delta)/(e^2*cos(phi)) - m4*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi) - ea*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta -
    //   phi))/e))/e)/cos(phi) + m4*cos(gamma - delta)*sin(gamma - delta - phi)*((cos(gamma - delta) +
    //   ea*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e))/e - sin(gamma - delta -
    //   phi)/zt))/cos(phi)^2 - 3*((cos(gamma - epsilon - omega)*((sin(gamma - epsilon)*((sin(gamma - epsilon
    //   - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) +
    //   tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) +
    //   tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/u + m6*sin(gamma - epsilon)*(sin(gamma -
    //   epsilon - omega) + tan(omega)*(2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)))/zf) + sin(gamma - epsilon)^2*sin(omega)*(I6*sin(gamma - epsilon)/(zf^2*cos(omega)) -
    //   m6*(sin(gamma - epsilon - omega) - sin(gamma - epsilon)/cos(omega) - fa*(sin(gamma - epsilon -
    //   omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf))/zf)/cos(omega) + m6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon - omega)*(cos(gamma - epsilon - omega)/u - (sin(gamma - epsilon) +
    //   fa*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf))/zf))/cos(omega)^2)) - (cos(beta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2) + tan(beta + theta - gamma)*(cos(beta
    //   - gamma)*(4*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma
    //   - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e -
    //   2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2) - d1_by_beta*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma -
    //   delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta -
    //   phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d1) - sin(beta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)))/d) + (cos(theta)*(sin(beta -
    //   gamma)*(((I3 + m3*(sa^2 + sb^2))/ss + 3*m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma -
    //   delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta -
    //   phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2) + cos(beta - gamma)*(d1_by_beta*((I3
    //   + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2
    //   + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d1 + sin(beta + theta -
    //   gamma)*(m2*da*d1_by_beta/(ss*d1) - 3*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta -
    //   gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/cos(beta + theta - gamma)))) +
    //   ((sin(beta - gamma)^2*(I2 + m2*da^2) + cos(beta - gamma)*(d1_by_beta*sin(beta - gamma)*(I2 +
    //   m2*da^2)/d1 + tan(beta + theta - gamma)*(cos(beta - gamma)*(I2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1) + m2*da^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) - 5*sin(beta - gamma)*(I2 +
    //   m2*da^2))))/ss - 2*m2*da*sin(beta + theta - gamma)*cos(beta - gamma)^2)/d)/d))/cos(beta + theta -
    //   gamma)) - (m2*da*cos(theta)*sin(beta + theta - gamma)*sin(beta - gamma) + (sin(beta - gamma)^2*(I2 +
    //   m2*da^2) + cos(beta - gamma)*((rr*(2*m2*da*cos(theta)*sin(beta + theta - gamma)*sin(beta - gamma) +
    //   cos(beta - gamma)*((cos(beta - gamma)*(I2 + m2*da^2) + tan(beta + theta - gamma)*(cos(beta -
    //   gamma)*(I2*(4*tan(beta + theta - gamma) - d1_by_beta/d1) + m2*da^2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1)) - 3*sin(beta - gamma)*(I2 + m2*da^2)))/d + m2*da*cos(theta)*sin(beta + theta -
    //   gamma)*(d1_by_beta/d1 - 3*tan(beta + theta - gamma)))) - 2*sin(beta + theta - gamma)*sin(beta -
    //   gamma)*(I2 + m2*da^2))/cos(beta + theta - gamma) + I2*(d1_by_beta*sin(beta - gamma)/d1 - cos(beta -
    //   gamma)) - m2*da*(rr*cos(theta)*cos(beta - gamma) + da*(cos(beta - gamma) - d1_by_beta*sin(beta -
    //   gamma)/d1))))/d)/d))/cos(beta + theta - gamma) - sin(theta)*(m2*da*rr*beta_rate^2*sin(beta -
    //   gamma)/d + d1_by_beta*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + m2*da*rr*beta_rate^2*cos(beta - gamma)/d)/d1))/cos(beta + theta - gamma)
    //   - mom*d1_by_beta/d1)/d1
    let beta_rate_dot_by_beta = -d1_inv
        * (rr_cos_angle_inv
            * (sin_theta
                * (d1_by_beta_d1_inv
                    * rr_beta_rate_sq
                        .mul_add(
                            d1_of_d_beta_gamma_m2_da, beta_rate_dot_by_beta_of_place_9,
                        ) + rr_beta_rate_sq * beta_rate_dot_by_beta_of_place_10)
                + cos_angle_inv
                    * (rr_beta_rate_sq
                        * (d_inv
                            * (d_inv
                                * (cos_beta_minus_gamma
                                    * (cos_angle_inv
                                        * (rr
                                            * (cos_beta_minus_gamma
                                                * (d_inv
                                                    * (sin_angle_cos_angle_inv
                                                        * (-beta_rate_dot_by_beta_of_place_11)
                                                            .mul_add(S::int(3), beta_rate_dot_by_beta_of_place_13)
                                                        + i2_plus_da_m2_da * cos_beta_minus_gamma)
                                                    + beta_rate_dot_by_beta_of_place_14
                                                        * (-sin_angle_cos_angle_inv)
                                                            .mul_add(S::int(3), d1_by_beta_d1_inv))
                                                + beta_rate_dot_by_beta_of_place_14
                                                    * beta_rate_dot_by_beta_of_beta_gamma)
                                            - S::int(2) * beta_rate_dot_by_beta_of_place_11 * sin_angle)
                                        - I2 * beta_rate_dot_by_beta_of_place_15
                                        - m2_da
                                            * da
                                                .mul_add(
                                                    beta_rate_dot_by_beta_of_place_15,
                                                    beta_rate_dot_by_beta_of_place_17,
                                                )) + beta_rate_dot_by_beta_of_place_18)
                                + beta_rate_dot_by_beta_of_place_14 * sin_beta_minus_gamma)
                            - sin_theta
                                * (d1_of_d_beta_gamma_m2_da
                                    * d1_by_beta_of_d_beta_gamma.mul_add(rr_doubled, sin_angle)
                                    + d1_by_beta_d1_inv
                                        * (-cos_theta
                                            * (d1_of_place_19
                                                + ss_inv
                                                    * rr
                                                        .mul_add(beta_rate_dot_by_beta_of_place_10, d1_of_place_20))
                                            + rr * d1_of_d_beta_gamma * d1_of_d_beta_gamma_m2_da)
                                    + cos_angle_inv
                                        * (rr
                                            * (sin_theta
                                                * (sin_theta
                                                    * (-sin_angle_cos_angle_inv
                                                        * (ss_inv
                                                            * (cos_phi_inv_sq
                                                                * (m4
                                                                    * (cos_gamma_minus_delta
                                                                        * (beta_rate_dot_by_beta_of_place_24
                                                                            - ea_e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * ea_e_inv
                                                                                        .mul_add(
                                                                                            beta_rate_dot_by_beta_of_place_12,
                                                                                            -beta_rate_dot_by_beta_of_place_19,
                                                                                        ) + S::int(3) * beta_rate_dot_by_beta_of_place_20
                                                                                    + beta_rate_dot_by_beta_of_place_24)
                                                                            - beta_rate_dot_by_beta_of_place_25)
                                                                        + d1_of_place_3
                                                                            * beta_rate_dot_by_beta_of_place_28
                                                                                .mul_add(S::int(3), -beta_rate_dot_by_beta_of_place_26))
                                                                    - zt_inv * d1_of_place_3_zt_inv
                                                                        * (m5
                                                                            * (-ta_sq_plus_tb_sq)
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_beta_of_place_23,
                                                                                    d1_of_place_3 * ta_sq_plus_tb_sq
                                                                                        * beta_rate_dot_by_beta_of_place_12,
                                                                                ) + I5 * beta_rate_dot_by_beta_of_place_26)
                                                                    - beta_rate_dot_by_beta_of_place_25
                                                                        * d1_of_place_7_i4_e_inv)
                                                                + cos_omega_inv_sq
                                                                    * (m6
                                                                        * (sin_gamma_minus_epsilon
                                                                            * (beta_rate_dot_by_beta_of_place_33
                                                                                + fa_zf_inv
                                                                                    * (sin_gamma_minus_epsilon
                                                                                        * (-fa_zf_inv)
                                                                                            .mul_add(
                                                                                                beta_rate_dot_by_beta_of_place_12,
                                                                                                beta_rate_dot_by_beta_of_place_19,
                                                                                            ) + S::int(3) * beta_rate_dot_by_beta_of_place_29
                                                                                        - beta_rate_dot_by_beta_of_place_33)
                                                                                + beta_rate_dot_by_beta_of_place_34)
                                                                            + d1_of_place_12
                                                                                * beta_rate_dot_by_beta_of_place_37
                                                                                    .mul_add(S::int(3), -beta_rate_dot_by_beta_of_place_35))
                                                                        - u_2_inv * d1_of_place_12_u_2_inv
                                                                            * (m7
                                                                                * ua_sq_plus_ub_sq
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_32,
                                                                                        d1_of_place_12 * ua_sq_plus_ub_sq
                                                                                            * beta_rate_dot_by_beta_of_place_12,
                                                                                    ) + I7 * beta_rate_dot_by_beta_of_place_35)
                                                                        + beta_rate_dot_by_beta_of_place_34
                                                                            * d1_of_place_16_i6_zf_inv)
                                                                - ss_inv_sq
                                                                    * (m3 * sa_sq_plus_sb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_beta_of_place_12,
                                                                            I3 * beta_rate_dot_by_beta_of_place_12,
                                                                        )) + S::int(3) * beta_rate_dot_by_beta_of_place_74)
                                                        + ss_inv * d1_of_place_21
                                                        + d1_by_beta_d1_inv
                                                            * (cos_phi_inv_sq
                                                                * (d1_of_place_3
                                                                    * (zt_inv
                                                                        * ss_inv
                                                                            .mul_add(
                                                                                beta_rate_dot_by_beta_of_place_41,
                                                                                beta_rate_dot_by_beta_of_place_77,
                                                                            )
                                                                        + m4
                                                                            * (ss_inv
                                                                                * (beta_rate_dot_by_beta_of_place_22
                                                                                    - beta_rate_dot_by_beta_of_place_21)
                                                                                + e_inv
                                                                                    * (beta_rate_dot_by_beta_of_place_79
                                                                                        - cos_gamma_minus_delta
                                                                                            * cos_phi_inv
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_beta_of_place_50,
                                                                                                    beta_rate_dot_by_beta_of_place_48,
                                                                                                ))))
                                                                    + cos_gamma_minus_delta
                                                                        * (m4
                                                                            * (e_inv
                                                                                * (beta_rate_dot_by_beta_of_place_84
                                                                                    - ea
                                                                                        * (e_inv
                                                                                            * (-beta_rate_dot_by_beta_of_place_52)
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_beta_of_place_80,
                                                                                                    beta_rate_dot_by_beta_of_place_78,
                                                                                                ) + ss_inv * beta_rate_dot_by_beta_of_place_82))
                                                                                - ss_inv * beta_rate_dot_by_beta_of_place_85)
                                                                            + e_inv_i4_e_inv
                                                                                * (-ss_inv)
                                                                                    .mul_add(
                                                                                        sin_gamma_minus_delta,
                                                                                        beta_rate_dot_by_beta_of_place_87,
                                                                                    )))
                                                                + cos_omega_inv_sq
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (m6
                                                                            * (zf_inv
                                                                                * (fa
                                                                                    * (zf_inv
                                                                                        * beta_rate_dot_by_beta_of_place_71
                                                                                            .mul_add(
                                                                                                beta_rate_dot_by_beta_of_place_93,
                                                                                                fa_ss_inv * cos_gamma_minus_epsilon,
                                                                                            ) - ss_inv * beta_rate_dot_by_beta_of_place_96)
                                                                                    + beta_rate_dot_by_beta_of_place_98)
                                                                                + ss_inv * beta_rate_dot_by_beta_of_place_99)
                                                                            + zf_inv_i6_zf_inv
                                                                                * ss_inv
                                                                                    .mul_add(
                                                                                        cos_gamma_minus_epsilon,
                                                                                        beta_rate_dot_by_beta_of_place_101,
                                                                                    ))
                                                                        - d1_of_place_12
                                                                            * (u_2_inv
                                                                                * ss_inv
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_59,
                                                                                        beta_rate_dot_by_beta_of_place_91,
                                                                                    )
                                                                                + m6
                                                                                    * (ss_inv
                                                                                        * (beta_rate_dot_by_beta_of_place_31
                                                                                            + beta_rate_dot_by_beta_of_place_30)
                                                                                        - zf_inv
                                                                                            * (sin_gamma_minus_epsilon
                                                                                                * cos_omega_inv
                                                                                                    .mul_add(
                                                                                                        beta_rate_dot_by_beta_of_place_69,
                                                                                                        beta_rate_dot_by_beta_of_place_67,
                                                                                                    ) + beta_rate_dot_by_beta_of_place_92))))))
                                                    - d_inv
                                                        * (sin_angle_cos_angle_inv
                                                            * (-d1_of_place_21)
                                                                .mul_add(
                                                                    sin_beta_minus_gamma,
                                                                    d1_of_place_21 * beta_rate_dot_by_beta_of_place_12
                                                                        * cos_beta_minus_gamma,
                                                                ) + d1_of_place_21 * cos_beta_minus_gamma))
                                                + d_inv
                                                    * (d_inv
                                                        * (ss_inv
                                                            * (cos_beta_minus_gamma
                                                                * (-sin_angle_cos_angle_inv
                                                                    * beta_rate_dot_by_beta_of_place_11
                                                                        .mul_add(S::int(5), -beta_rate_dot_by_beta_of_place_13)
                                                                    + d1_by_beta_d1_inv * beta_rate_dot_by_beta_of_place_11)
                                                                + beta_rate_dot_by_beta_of_place_18)
                                                            - S::int(2) * sin_angle_m2_da * cos_beta_minus_gamma
                                                                * cos_beta_minus_gamma)
                                                        + cos_theta
                                                            * (sin_beta_minus_gamma
                                                                * (d1_of_place_19
                                                                    + ss_inv
                                                                        * sin_angle_m2_da.mul_add(S::int(3), d1_of_place_20))
                                                                - cos_beta_minus_gamma
                                                                    * (sin_angle
                                                                        * (-(ss_inv * m2_da))
                                                                            .mul_add(
                                                                                d1_by_beta_d1_inv,
                                                                                S::int(3) * cos_angle_inv
                                                                                    * beta_rate_dot_by_beta_of_place_102,
                                                                            ) - d1_of_place_21 * d1_by_beta_d1_inv))))
                                            + d1_of_place_21 * cos_theta_doubled * sin_angle)))
                        - beta_rate_dot_by_beta_of_place_9 * sin_theta * sin_angle)
                + cos_theta_m2_da * beta_rate_dot_by_beta_of_place_15
                    * d_inv_rr_beta_rate_sq) + mom * d1_by_beta_d1_inv);
    // cos(theta) + sin_angle_cos_angle_inv*sin(theta)
    let d1_by_theta_of_place = sin_angle_cos_angle_inv.mul_add(sin_theta, cos_theta);
    let d1_by_theta_of_place_2 = cos_angle_inv * d1_of_d_beta_gamma;
    // d1_by_theta = 2*rr^2*(m2*da*sin(theta)*cos(beta - gamma)/d + (sin(beta + theta - gamma)*cos(beta -
    //   gamma)*(I2*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - m2*da*(cos(theta) - da*cos(beta -
    //   gamma)/(d*cos(beta + theta - gamma))))/d + sin(theta)*(cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2) + sin(theta)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)))/cos(beta + theta - gamma))/cos(beta
    //   + theta - gamma)
    let d1_by_theta = d1_by_beta_of_place_2
        * (cos_angle_inv
            * (d1_of_d_beta_gamma * sin_angle
                * (-m2_da * (-da).mul_add(d1_by_theta_of_place_2, cos_theta)
                    + I2 * d1_by_theta_of_place_2)
                + d1_of_place_21 * d1_by_theta_of_place * sin_theta)
            + d1_of_d_beta_gamma_m2_da * sin_theta);
    let d1_of_place_20_ss_inv_sq = d1_of_place_20 * ss_inv_sq;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let beta_rate_dot_by_theta_of_place = d1_of_place_3
        .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_by_beta_of_place_22);
    // -beta_rate_dot_by_theta_of_place
    let beta_rate_dot_by_theta_of_place_2 = -beta_rate_dot_by_theta_of_place;
    let zt_inv_ss_inv = zt_inv * ss_inv;
    let beta_rate_dot_by_theta_of_place_3 = S::int(2) * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_theta_of_place_4 = cos_phi_inv_sq * beta_rate_dot_by_beta_of_place_49;
    // ea_ss_inv*beta_rate_dot_by_theta_of_place_3 - beta_rate_dot_by_theta_of_place_4
    let beta_rate_dot_by_theta_of_place_5 = ea_ss_inv
        .mul_add(beta_rate_dot_by_theta_of_place_3, -beta_rate_dot_by_theta_of_place_4);
    let beta_rate_dot_by_theta_of_place_6 = beta_rate_dot_by_beta_of_place_22 * cos_phi_inv;
    // beta_rate_dot_by_beta_of_place_48 - beta_rate_dot_by_theta_of_place_5*sin(phi) +
    //   beta_rate_dot_by_theta_of_place_6
    let beta_rate_dot_by_theta_of_place_7 = (-beta_rate_dot_by_theta_of_place_5)
        .mul_add(sin_phi, beta_rate_dot_by_beta_of_place_48) + beta_rate_dot_by_theta_of_place_6;
    let beta_rate_dot_by_theta_of_place_8 = beta_rate_dot_by_theta_of_place_3
        * cos_gamma_minus_delta;
    // sin(gamma - delta) + beta_rate_dot_by_theta_of_place_8
    let beta_rate_dot_by_theta_of_place_9 = sin_gamma_minus_delta
        + beta_rate_dot_by_theta_of_place_8;
    // zt_inv*(beta_rate_dot_by_beta_of_place_77 + zt_inv_ss_inv*(I5*beta_rate_dot_by_theta_of_place_2 +
    //   m5*ta_sq_plus_tb_sq*beta_rate_dot_by_theta_of_place_2)) +
    //   m4*(e_inv*(beta_rate_dot_by_beta_of_place_79 - beta_rate_dot_by_theta_of_place_7*cos(gamma - delta))
    //   - ss_inv*(beta_rate_dot_by_theta_of_place + beta_rate_dot_by_theta_of_place_9*sin(phi)))
    let beta_rate_dot_by_theta_of_place_10 = zt_inv
        * (beta_rate_dot_by_beta_of_place_77
            + zt_inv_ss_inv
                * (m5 * ta_sq_plus_tb_sq)
                    .mul_add(
                        beta_rate_dot_by_theta_of_place_2,
                        I5 * beta_rate_dot_by_theta_of_place_2,
                    ))
        + m4
            * (e_inv
                * (-beta_rate_dot_by_theta_of_place_7)
                    .mul_add(cos_gamma_minus_delta, beta_rate_dot_by_beta_of_place_79)
                - ss_inv
                    * beta_rate_dot_by_theta_of_place_9
                        .mul_add(sin_phi, beta_rate_dot_by_theta_of_place));
    // sin_angle_cos_angle_inv*ea_ss_inv - sin_phi_cos_phi_inv*beta_rate_dot_by_beta_of_place_52
    let beta_rate_dot_by_theta_of_place_11 = (-sin_phi_cos_phi_inv)
        .mul_add(beta_rate_dot_by_beta_of_place_52, sin_angle_cos_angle_inv * ea_ss_inv);
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_by_theta_of_place_12 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    // e_inv_i4_e_inv*(ss_inv*beta_rate_dot_by_theta_of_place_12 - beta_rate_dot_by_beta_of_place_87) -
    //   m4*(e_inv*(beta_rate_dot_by_beta_of_place_84 - ea*(ss_inv*(beta_rate_dot_by_beta_of_place_82 -
    //   beta_rate_dot_by_theta_of_place_8) + e_inv*(beta_rate_dot_by_beta_of_place_78 +
    //   beta_rate_dot_by_theta_of_place_11*cos(gamma - delta)))) + ss_inv*(beta_rate_dot_by_beta_of_place_81
    //   - beta_rate_dot_by_theta_of_place_12))
    let beta_rate_dot_by_theta_of_place_13 = e_inv_i4_e_inv
        * ss_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_12, -beta_rate_dot_by_beta_of_place_87,
            )
        - m4
            * (e_inv
                * (beta_rate_dot_by_beta_of_place_84
                    - ea
                        * (ss_inv
                            * (beta_rate_dot_by_beta_of_place_82
                                - beta_rate_dot_by_theta_of_place_8)
                            + e_inv
                                * beta_rate_dot_by_theta_of_place_11
                                    .mul_add(
                                        cos_gamma_minus_delta, beta_rate_dot_by_beta_of_place_78,
                                    )))
                + ss_inv
                    * (beta_rate_dot_by_beta_of_place_81 - beta_rate_dot_by_theta_of_place_12));
    // cos_phi_inv_sq*(sin(gamma - delta - phi)*beta_rate_dot_by_theta_of_place_10 -
    //   beta_rate_dot_by_theta_of_place_13*cos(gamma - delta))
    let beta_rate_dot_by_theta_of_place_14 = cos_phi_inv_sq
        * (-beta_rate_dot_by_theta_of_place_13)
            .mul_add(
                cos_gamma_minus_delta,
                d1_of_place_3 * beta_rate_dot_by_theta_of_place_10,
            );
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_by_theta_of_place_15 = d1_of_place_12
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_by_beta_of_place_31);
    let u_2_inv_ss_inv = u_2_inv * ss_inv;
    let beta_rate_dot_by_theta_of_place_16 = cos_omega_inv_sq * beta_rate_dot_by_beta_of_place_68;
    // fa_ss_inv*beta_rate_dot_by_theta_of_place_3 - beta_rate_dot_by_theta_of_place_16
    let beta_rate_dot_by_theta_of_place_17 = fa_ss_inv
        .mul_add(beta_rate_dot_by_theta_of_place_3, -beta_rate_dot_by_theta_of_place_16);
    let beta_rate_dot_by_theta_of_place_18 = beta_rate_dot_by_beta_of_place_31 * cos_omega_inv;
    // beta_rate_dot_by_beta_of_place_67 - beta_rate_dot_by_theta_of_place_17*sin(omega) +
    //   beta_rate_dot_by_theta_of_place_18
    let beta_rate_dot_by_theta_of_place_19 = (-beta_rate_dot_by_theta_of_place_17)
        .mul_add(sin_omega, beta_rate_dot_by_beta_of_place_67) + beta_rate_dot_by_theta_of_place_18;
    let beta_rate_dot_by_theta_of_place_20 = beta_rate_dot_by_theta_of_place_3
        * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - beta_rate_dot_by_theta_of_place_20
    let beta_rate_dot_by_theta_of_place_21 = cos_gamma_minus_epsilon
        - beta_rate_dot_by_theta_of_place_20;
    // u_2_inv*(beta_rate_dot_by_beta_of_place_91 + u_2_inv_ss_inv*(I7*beta_rate_dot_by_theta_of_place_15 +
    //   m7*ua_sq_plus_ub_sq*beta_rate_dot_by_theta_of_place_15)) +
    //   m6*(ss_inv*(beta_rate_dot_by_theta_of_place_15 + beta_rate_dot_by_theta_of_place_21*sin(omega)) -
    //   zf_inv*(beta_rate_dot_by_beta_of_place_92 + beta_rate_dot_by_theta_of_place_19*sin(gamma -
    //   epsilon)))
    let beta_rate_dot_by_theta_of_place_22 = u_2_inv
        * (beta_rate_dot_by_beta_of_place_91
            + u_2_inv_ss_inv
                * (m7 * ua_sq_plus_ub_sq)
                    .mul_add(
                        beta_rate_dot_by_theta_of_place_15,
                        I7 * beta_rate_dot_by_theta_of_place_15,
                    ))
        + m6
            * (ss_inv
                * beta_rate_dot_by_theta_of_place_21
                    .mul_add(sin_omega, beta_rate_dot_by_theta_of_place_15)
                - zf_inv
                    * beta_rate_dot_by_theta_of_place_19
                        .mul_add(
                            sin_gamma_minus_epsilon, beta_rate_dot_by_beta_of_place_92,
                        ));
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_by_theta_of_place_23 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_by_theta_of_place_24 = d1_of_place_16 * sin_omega_cos_omega_inv;
    // zf_inv_i6_zf_inv*(beta_rate_dot_by_beta_of_place_101 + ss_inv*beta_rate_dot_by_theta_of_place_23) +
    //   m6*(ss_inv*(beta_rate_dot_by_beta_of_place_94 + beta_rate_dot_by_theta_of_place_23) +
    //   zf_inv*(beta_rate_dot_by_beta_of_place_98 +
    //   fa*(beta_rate_dot_by_beta_of_place_71*beta_rate_dot_by_theta_of_place_24 -
    //   ss_inv*(beta_rate_dot_by_beta_of_place_96 - beta_rate_dot_by_theta_of_place_20 -
    //   fa_zf_inv*beta_rate_dot_by_theta_of_place_23))))
    let beta_rate_dot_by_theta_of_place_25 = zf_inv_i6_zf_inv
        * ss_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_23, beta_rate_dot_by_beta_of_place_101,
            )
        + m6
            * (ss_inv
                * (beta_rate_dot_by_beta_of_place_94 + beta_rate_dot_by_theta_of_place_23)
                + zf_inv
                    * (beta_rate_dot_by_beta_of_place_98
                        + fa
                            * (-ss_inv
                                * (-fa_zf_inv)
                                    .mul_add(
                                        beta_rate_dot_by_theta_of_place_23,
                                        beta_rate_dot_by_beta_of_place_96
                                            - beta_rate_dot_by_theta_of_place_20,
                                    )
                                + beta_rate_dot_by_beta_of_place_71
                                    * beta_rate_dot_by_theta_of_place_24)));
    // cos_omega_inv_sq*(cos(gamma - epsilon - omega)*beta_rate_dot_by_theta_of_place_22 -
    //   beta_rate_dot_by_theta_of_place_25*sin(gamma - epsilon))
    let beta_rate_dot_by_theta_of_place_26 = cos_omega_inv_sq
        * (-beta_rate_dot_by_theta_of_place_25)
            .mul_add(
                sin_gamma_minus_epsilon,
                d1_of_place_12 * beta_rate_dot_by_theta_of_place_22,
            );
    // sin_angle_cos_angle_inv*d1_of_place_20_ss_inv_sq - beta_rate_dot_by_theta_of_place_14 +
    //   beta_rate_dot_by_theta_of_place_26
    let beta_rate_dot_by_theta_of_place_27 = sin_angle_cos_angle_inv
        .mul_add(d1_of_place_20_ss_inv_sq, -beta_rate_dot_by_theta_of_place_14)
        + beta_rate_dot_by_theta_of_place_26;
    let beta_rate_dot_by_theta_of_place_28 = d1_of_d_beta_gamma * sin_angle_cos_angle_inv;
    // beta_rate_dot_by_theta_of_place_27*sin(theta) - d1_of_place_21*beta_rate_dot_by_theta_of_place_28
    let beta_rate_dot_by_theta_of_place_29 = (-d1_of_place_21)
        .mul_add(
            beta_rate_dot_by_theta_of_place_28,
            beta_rate_dot_by_theta_of_place_27 * sin_theta,
        );
    // sin_angle_cos_angle_inv*cos(beta - gamma) - sin(beta - gamma)
    let beta_rate_dot_by_theta_of_place_30 = sin_angle_cos_angle_inv
        .mul_add(cos_beta_minus_gamma, -sin_beta_minus_gamma);
    // -beta_rate_dot_by_theta_of_place_30
    let beta_rate_dot_by_theta_of_place_31 = -beta_rate_dot_by_theta_of_place_30;
    let beta_rate_dot_by_theta_of_place_32 = i2_plus_da_m2_da * beta_rate_dot_by_theta_of_place_31;
    let ss_inv_d_inv = ss_inv * d_inv;
    // beta_rate_dot_by_beta_of_place_102*cos(theta) + beta_rate_dot_by_theta_of_place_32*ss_inv_d_inv
    let beta_rate_dot_by_theta_of_place_33 = beta_rate_dot_by_theta_of_place_32
        .mul_add(ss_inv_d_inv, beta_rate_dot_by_beta_of_place_102 * cos_theta);
    // beta_rate_dot_by_theta_of_place_29*sin(theta) -
    //   d1_of_d_beta_gamma*beta_rate_dot_by_theta_of_place_33
    let beta_rate_dot_by_theta_of_place_34 = (-d1_of_d_beta_gamma)
        .mul_add(
            beta_rate_dot_by_theta_of_place_33,
            beta_rate_dot_by_theta_of_place_29 * sin_theta,
        );
    let beta_rate_dot_by_theta_of_place_35 = cos_theta * sin_beta_minus_gamma;
    let d_inv_m2_da = d_inv * m2_da;
    // -d1_of_place_21*cos(theta) - rr*(cos_angle_inv*beta_rate_dot_by_theta_of_place_34 +
    //   d_inv_m2_da*(ss_inv*beta_rate_dot_by_theta_of_place_35 - d1_of_d_beta_gamma*cos(beta - gamma)))
    let beta_rate_dot_by_theta_of_place_36 = -rr
        * (d_inv_m2_da
            * (-d1_of_d_beta_gamma)
                .mul_add(
                    cos_beta_minus_gamma,
                    ss_inv * beta_rate_dot_by_theta_of_place_35,
                ) + cos_angle_inv * beta_rate_dot_by_theta_of_place_34)
        - d1_of_place_21 * cos_theta;
    // beta_rate_dot_by_beta_of_place_9 + rr_beta_rate_sq*(d1_of_d_beta_gamma_m2_da -
    //   cos_angle_inv*beta_rate_dot_by_theta_of_place_36)
    let beta_rate_dot_by_theta_of_beta_rate = beta_rate_dot_by_beta_of_place_9
        + rr_beta_rate_sq
            * (-cos_angle_inv)
                .mul_add(beta_rate_dot_by_theta_of_place_36, d1_of_d_beta_gamma_m2_da);
    // 1 + sin_angle_cos_angle_inv^2
    let beta_rate_dot_by_theta_of_place_37 = sin_angle_cos_angle_inv
        .mul_add(sin_angle_cos_angle_inv, S::int(1));
    let beta_rate_dot_by_theta_of_place_38 = beta_rate_dot_by_theta_of_place_37
        * cos_gamma_minus_delta;
    let beta_rate_dot_by_theta_of_place_39 = ss_inv * beta_rate_dot_by_theta_of_place_38;
    let beta_rate_dot_by_theta_of_place_40 = ea_ss_inv * beta_rate_dot_by_theta_of_place_37;
    let beta_rate_dot_by_theta_of_place_41 = d1_of_place_7 * beta_rate_dot_by_theta_of_place_40;
    let beta_rate_dot_by_theta_of_place_42 = d1_of_place_3 * beta_rate_dot_by_theta_of_place_37;
    let beta_rate_dot_by_theta_of_place_43 = beta_rate_dot_by_theta_of_place_37
        * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_theta_of_place_44 = S::int(2) * beta_rate_dot_by_theta_of_place_37;
    let beta_rate_dot_by_theta_of_place_45 = ss_inv * beta_rate_dot_by_theta_of_place_43;
    let beta_rate_dot_by_theta_of_place_46 = d1_of_place_12 * beta_rate_dot_by_theta_of_place_37;
    let beta_rate_dot_by_theta_of_place_47 = d1_of_place_20_ss_inv_sq
        * beta_rate_dot_by_theta_of_place_37;
    let beta_rate_dot_by_theta_of_place_48 = d1_of_place_21 * d1_of_d_beta_gamma
        * beta_rate_dot_by_theta_of_place_37;
    let cos_angle_ss_inv = ss_inv * cos_angle;
    let beta_rate_dot_by_theta_of_place_49 = cos_angle_inv * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_theta_of_place_50 = beta_rate_dot_by_theta_of_place_34
        * beta_rate_dot_by_theta_of_place_49;
    let beta_rate_dot_by_theta_of_place_51 = beta_rate_dot_by_theta_of_place_36
        * beta_rate_dot_by_theta_of_place_49;
    let beta_rate_dot_by_theta_of_place_52 = rr_cos_angle_inv * cos_beta_minus_gamma;
    // beta_rate_dot_by_theta_of_place_52*(d1_of_d_beta_gamma +
    //   beta_rate_dot_by_theta_of_place_3*beta_rate_dot_by_theta_of_place_28)
    let beta_rate_dot_by_theta_of_place_53 = beta_rate_dot_by_theta_of_place_52
        * beta_rate_dot_by_theta_of_place_3
            .mul_add(beta_rate_dot_by_theta_of_place_28, d1_of_d_beta_gamma);
    let beta_rate_dot_by_theta_of_place_54 = sin_theta * cos_beta_minus_gamma;
    let beta_rate_dot_by_theta_of_place_55 = rr * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_theta_of_place_56 = beta_rate_dot_by_beta_of_place_17
        * beta_rate_dot_by_theta_of_place_37;
    // sin(beta - gamma) - beta_rate_dot_by_theta_of_place_28*beta_rate_dot_by_theta_of_place_52
    let beta_rate_dot_by_theta_of_place_57 = (-beta_rate_dot_by_theta_of_place_28)
        .mul_add(beta_rate_dot_by_theta_of_place_52, sin_beta_minus_gamma);
    // I2*beta_rate_dot_by_theta_of_place_57 +
    //   m2_da*(sin_angle_cos_angle_inv*beta_rate_dot_by_beta_of_place_17 +
    //   da*beta_rate_dot_by_theta_of_place_57)
    let beta_rate_dot_by_theta_of_place_58 = m2_da
        * da
            .mul_add(
                beta_rate_dot_by_theta_of_place_57,
                sin_angle_cos_angle_inv * beta_rate_dot_by_beta_of_place_17,
            ) + I2 * beta_rate_dot_by_theta_of_place_57;
    let beta_rate_dot_by_theta_of_place_59 = cos_angle_inv * beta_rate_dot_by_theta_of_place_58;
    // rr_cos_angle_inv*(beta_rate_dot_by_theta_of_beta_rate*sin(theta) +
    //   d_inv_rr_beta_rate_sq*(d1_by_theta_of_place_2*beta_rate_dot_by_theta_of_place_58 -
    //   cos_theta_m2_da*sin(beta - gamma)))
    let beta_rate_dot_by_theta_of_beta_rate_2 = rr_cos_angle_inv
        * (d_inv_rr_beta_rate_sq
            * (-cos_theta_m2_da)
                .mul_add(
                    sin_beta_minus_gamma,
                    d1_by_theta_of_place_2 * beta_rate_dot_by_theta_of_place_58,
                ) + beta_rate_dot_by_theta_of_beta_rate * sin_theta);
    let beta_rate_dot_by_theta_of_beta_rate_3 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_beta_rate_2;
    // d1_inv^2*(mom + beta_rate_dot_by_theta_of_beta_rate_2)
    let beta_rate_dot_by_theta_of_beta_rate_4 = d1_inv * d1_inv
        * (mom + beta_rate_dot_by_theta_of_beta_rate_2);
    // beta_rate_dot_by_theta = d1_by_theta*(rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) -
    //   cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma)))))/(d*cos(beta + theta - gamma)))/d +
    //   sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom)/d1^2 - (rr*tan(beta + theta -
    //   gamma)*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) + rr*(rr*beta_rate^2*sin(theta)*(tan(beta +
    //   theta - gamma)*(rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) + (sin(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma
    //   - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e -
    //   2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2) + rr*(m2*da*sin(theta)*sin(beta - gamma)/(d*ss) + tan(beta + theta -
    //   gamma)*(sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma) +
    //   (cos(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + sin(theta)*(cos(beta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d - sin(theta)*((I3 + m3*(sa^2 +
    //   sb^2))/ss^3 + tan(beta + theta - gamma)^2*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma -
    //   delta)*(I4*(cos(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma)^2)/(e^2*ss) +
    //   m4*((cos(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma)^2)/ss + ea*(cos(gamma -
    //   delta)*(ea/ss + ea*tan(beta + theta - gamma)^2/ss)/e - 2*(cos(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma)^2)/ss)/e)) + sin(gamma - delta - phi)*((I5*(sin(gamma - delta -
    //   phi) + sin(gamma - delta - phi)*tan(beta + theta - gamma)^2) + m5*(ta^2*(sin(gamma - delta - phi) +
    //   sin(gamma - delta - phi)*tan(beta + theta - gamma)^2) + tb^2*(sin(gamma - delta - phi) + sin(gamma -
    //   delta - phi)*tan(beta + theta - gamma)^2)))/(ss*zt^2) + m4*((2*sin(phi)*(cos(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma)^2) + sin(gamma - delta - phi) + sin(gamma - delta -
    //   phi)*tan(beta + theta - gamma)^2)/ss - 2*cos(gamma - delta)*sin(phi)*(ea/ss + ea*tan(beta + theta -
    //   gamma)^2/ss)/e)))/cos(phi)^2 + (sin(gamma - epsilon)*(I6*(sin(gamma - epsilon) + sin(gamma -
    //   epsilon)*tan(beta + theta - gamma)^2)/(ss*zf^2) - m6*(fa*(2*sin(gamma - epsilon) + 2*sin(gamma -
    //   epsilon)*tan(beta + theta - gamma)^2 - fa*(sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta +
    //   theta - gamma)^2)/zf)/(ss*zf) - (sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta -
    //   gamma)^2)/ss)) + cos(gamma - epsilon - omega)*((I7*(cos(gamma - epsilon - omega) + cos(gamma -
    //   epsilon - omega)*tan(beta + theta - gamma)^2) + m7*(ua^2*(cos(gamma - epsilon - omega) + cos(gamma -
    //   epsilon - omega)*tan(beta + theta - gamma)^2) + ub^2*(cos(gamma - epsilon - omega) + cos(gamma -
    //   epsilon - omega)*tan(beta + theta - gamma)^2)))/(ss*u^2) + m6*(2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/ss + fa*tan(beta + theta - gamma)^2/ss)/zf + (cos(gamma - epsilon - omega) -
    //   2*sin(omega)*(sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2) + cos(gamma -
    //   epsilon - omega)*tan(beta + theta - gamma)^2)/ss)))/cos(omega)^2) + cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d +
    //   cos(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta -
    //   phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi)
    //   + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt +
    //   m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma - delta)*(1 - ea/e) -
    //   cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss + (2*cos(gamma -
    //   delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma - delta -
    //   phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta +
    //   theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss - tan(phi)*(cos(gamma - delta)*(ea/e
    //   - 2)/cos(phi) + cos(gamma - delta - phi))))/e + (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma -
    //   delta) - 2*cos(gamma - delta)*tan(beta + theta - gamma))/ss) + cos(gamma -
    //   delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma - delta)/cos(phi)))/e + (sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma - epsilon - omega)*((m6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon -
    //   omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) +
    //   tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) +
    //   tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta -
    //   gamma)*(m2*da*cos(theta)*cos(beta + theta - gamma)/ss - (I2*(cos(beta - gamma) + cos(beta -
    //   gamma)*tan(beta + theta - gamma)^2) + m2*da^2*(cos(beta - gamma) + cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2))/(d*ss) - sin(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta -
    //   gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta -
    //   gamma)))/cos(beta + theta - gamma)) - rr*beta_rate^2*(m2*da*sin(theta)*sin(beta - gamma) + cos(beta
    //   - gamma)*tan(beta + theta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta
    //   - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma)))))/(d*cos(beta + theta - gamma)) + cos(beta - gamma)*(m2*da*(rr*cos(theta)*cos(beta
    //   - gamma) + rr*sin(theta)*cos(beta - gamma)*tan(gamma - beta - theta) + rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma)^2 - da*(rr*cos(beta - gamma)^2/(d*cos(beta + theta - gamma)) +
    //   2*rr*cos(beta - gamma)^2*tan(beta + theta - gamma)^2/(d*cos(beta + theta - gamma)))) -
    //   I2*(rr*cos(beta - gamma)^2/(d*cos(beta + theta - gamma)) + 2*rr*cos(beta - gamma)^2*tan(beta + theta
    //   - gamma)^2/(d*cos(beta + theta - gamma))))/(d*cos(beta + theta - gamma)))/d +
    //   cos(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot_by_theta = d1_inv
        * (rr_cos_angle_inv
            * (-rr_beta_rate_sq * sin_theta
                * (cos_angle_inv
                    * (sin_theta_d1_of_place_21
                        + rr
                            * (-cos_angle_inv
                                * (sin_theta
                                    * (-beta_rate_dot_by_theta_of_place_48
                                        + beta_rate_dot_by_theta_of_place_27 * cos_theta
                                        + sin_theta
                                            * (cos_phi_inv_sq
                                                * (cos_gamma_minus_delta
                                                    * (m4
                                                        * (beta_rate_dot_by_theta_of_place_39
                                                            + ea_e_inv
                                                                * (-beta_rate_dot_by_theta_of_place_39)
                                                                    .mul_add(S::int(2), beta_rate_dot_by_theta_of_place_41))
                                                        + e_inv_i4_e_inv * beta_rate_dot_by_theta_of_place_39)
                                                    + d1_of_place_3
                                                        * (zt_inv * zt_inv_ss_inv
                                                            * (m5 * ta_sq_plus_tb_sq)
                                                                .mul_add(
                                                                    beta_rate_dot_by_theta_of_place_42,
                                                                    I5 * beta_rate_dot_by_theta_of_place_42,
                                                                )
                                                            + m4
                                                                * (ss_inv
                                                                    * sin_phi_doubled
                                                                        .mul_add(
                                                                            beta_rate_dot_by_theta_of_place_38,
                                                                            beta_rate_dot_by_theta_of_place_42,
                                                                        ) - sin_phi_doubled * beta_rate_dot_by_theta_of_place_41)))
                                                + cos_omega_inv_sq
                                                    * (sin_gamma_minus_epsilon
                                                        * (m6
                                                            * (fa_zf_inv * ss_inv
                                                                * (-beta_rate_dot_by_theta_of_place_44)
                                                                    .mul_add(
                                                                        sin_gamma_minus_epsilon,
                                                                        fa_zf_inv * beta_rate_dot_by_theta_of_place_43,
                                                                    ) + beta_rate_dot_by_theta_of_place_45)
                                                            + zf_inv_i6_zf_inv * beta_rate_dot_by_theta_of_place_45)
                                                        + d1_of_place_12
                                                            * (m6
                                                                * (ss_inv
                                                                    * (-sin_omega_doubled)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_theta_of_place_43,
                                                                            beta_rate_dot_by_theta_of_place_46,
                                                                        )
                                                                    + d1_of_place_16 * sin_omega_doubled * fa_ss_inv
                                                                        * beta_rate_dot_by_theta_of_place_37)
                                                                + u_2_inv * u_2_inv_ss_inv
                                                                    * (m7 * ua_sq_plus_ub_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_theta_of_place_46,
                                                                            I7 * beta_rate_dot_by_theta_of_place_46,
                                                                        ))) + beta_rate_dot_by_theta_of_place_47))
                                    + beta_rate_dot_by_theta_of_place_29 * cos_theta
                                    + d1_of_d_beta_gamma
                                        * ((i2_plus_da_m2_da * ss_inv_d_inv
                                            * beta_rate_dot_by_theta_of_place_37)
                                            .mul_add(
                                                cos_beta_minus_gamma,
                                                beta_rate_dot_by_beta_of_place_102 * sin_theta,
                                            ) - cos_theta_m2_da * cos_angle_ss_inv))
                                + ss_inv * beta_rate_dot_by_beta_of_place_10 * sin_theta
                                - beta_rate_dot_by_theta_of_place_50))
                    + beta_rate_dot_by_theta_of_place_51)
                + beta_rate_dot_by_theta_of_beta_rate * cos_theta
                + d_inv_rr_beta_rate_sq
                    * (-d1_by_theta_of_place_2
                        * (m2_da
                            * (da
                                .mul_add(
                                    beta_rate_dot_by_theta_of_place_53,
                                    -beta_rate_dot_by_theta_of_place_56,
                                )
                                + beta_rate_dot_by_theta_of_place_54
                                    * beta_rate_dot_by_theta_of_place_55)
                            + I2 * beta_rate_dot_by_theta_of_place_53)
                        + m2_da * sin_theta * sin_beta_minus_gamma
                        + beta_rate_dot_by_theta_of_place_28 * beta_rate_dot_by_theta_of_place_59))
            + beta_rate_dot_by_theta_of_beta_rate_3)
        - d1_by_theta * beta_rate_dot_by_theta_of_beta_rate_4;
    let d1_by_gamma_of_place = d1_of_place_21 * sin_angle_cos_angle_inv;
    let d1_by_gamma_of_place_2 = d1_of_place_3_zt_inv * beta_rate_dot_by_beta_of_place_41;
    // d1_of_place_7_i4_e_inv*sin(gamma - delta) - d1_by_gamma_of_place_2
    let d1_by_gamma_of_place_3 = d1_of_place_7_i4_e_inv
        .mul_add(sin_gamma_minus_delta, -d1_by_gamma_of_place_2);
    // cos_phi_inv_sq*(m4*(cos(gamma - delta)*(ea_e_inv*(beta_rate_dot_by_beta_of_place_20 +
    //   beta_rate_dot_by_beta_of_place_81) + beta_rate_dot_by_beta_of_place_85) - sin(gamma - delta -
    //   phi)*(cos(gamma - delta - phi) + beta_rate_dot_by_beta_of_place_28)) + d1_by_gamma_of_place_3)
    let d1_by_gamma_of_place_4 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (ea_e_inv
                    * (beta_rate_dot_by_beta_of_place_20 + beta_rate_dot_by_beta_of_place_81)
                    + beta_rate_dot_by_beta_of_place_85)
                - d1_of_place_3
                    * (beta_rate_dot_by_beta_of_place_22
                        + beta_rate_dot_by_beta_of_place_28)) + d1_by_gamma_of_place_3);
    let d1_by_gamma_of_place_5 = d1_of_place_12_u_2_inv * beta_rate_dot_by_beta_of_place_59;
    // d1_of_place_16_i6_zf_inv*cos(gamma - epsilon) - d1_by_gamma_of_place_5
    let d1_by_gamma_of_place_6 = d1_of_place_16_i6_zf_inv
        .mul_add(cos_gamma_minus_epsilon, -d1_by_gamma_of_place_5);
    // cos_omega_inv_sq*(m6*(cos(gamma - epsilon - omega)*(beta_rate_dot_by_beta_of_place_37 - sin(gamma -
    //   epsilon - omega)) + sin(gamma - epsilon)*(fa_zf_inv*(beta_rate_dot_by_beta_of_place_29 -
    //   beta_rate_dot_by_beta_of_place_94) + beta_rate_dot_by_beta_of_place_99)) + d1_by_gamma_of_place_6)
    let d1_by_gamma_of_place_7 = cos_omega_inv_sq
        * (m6
            * (d1_of_place_12
                * (beta_rate_dot_by_beta_of_place_37 - beta_rate_dot_by_beta_of_place_31)
                + sin_gamma_minus_epsilon
                    * (fa_zf_inv
                        * (beta_rate_dot_by_beta_of_place_29 - beta_rate_dot_by_beta_of_place_94)
                        + beta_rate_dot_by_beta_of_place_99)) + d1_by_gamma_of_place_6);
    // d1_by_gamma = -2*rr^2*(m2*da*cos(theta)*sin(beta - gamma)/d + (sin(theta)^2*((I4*sin(gamma -
    //   delta)*cos(gamma - delta)/e^2 - sin(gamma - delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 - m4*(sin(gamma - delta - phi)*(sin(gamma - delta)*sin(phi)*(ea/e - 1) + cos(gamma -
    //   delta - phi)) - cos(gamma - delta)*(sin(gamma - delta) - sin(phi)*cos(gamma - delta - phi) +
    //   ea*(sin(gamma - delta)*(ea/e - 2) + sin(phi)*cos(gamma - delta - phi))/e)))/cos(phi)^2 + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2) + (sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 + m6*(cos(gamma - epsilon - omega)*(cos(gamma -
    //   epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega)) - sin(gamma - epsilon)*(cos(gamma -
    //   epsilon) + sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2) - cos(beta -
    //   gamma)*(m2*da*cos(theta)*sin(beta + theta - gamma) + (I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/d)/d)/cos(beta + theta - gamma))/cos(beta + theta - gamma)
    let d1_by_gamma = -d1_by_beta_of_place_2
        * (d1_by_beta_of_place
            + cos_angle_inv
                * (sin_theta * sin_theta
                    * (d1_by_gamma_of_place + d1_by_gamma_of_place_4 - d1_by_gamma_of_place_7)
                    - d1_of_d_beta_gamma
                        * d_inv
                            .mul_add(
                                beta_rate_dot_by_theta_of_place_32,
                                beta_rate_dot_by_beta_of_place_14,
                            )));
    let beta_rate_dot_by_gamma_of_place = sin_angle_cos_angle_inv * beta_rate_dot_by_theta_of_place;
    let beta_rate_dot_by_gamma_of_place_2 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_beta_of_place_38;
    let beta_rate_dot_by_gamma_of_place_3 = S::int(2) * beta_rate_dot_by_beta_of_place_81;
    // sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_3
    let beta_rate_dot_by_gamma_of_place_4 = sin_gamma_minus_delta
        - beta_rate_dot_by_gamma_of_place_3;
    let beta_rate_dot_by_gamma_of_place_5 = beta_rate_dot_by_beta_of_place_44
        * beta_rate_dot_by_theta_of_place_6;
    // beta_rate_dot_by_beta_of_place_27*m4_d1_of_place_3 +
    //   cos_phi_inv*(beta_rate_dot_by_beta_of_place_43*sin(gamma - delta) +
    //   beta_rate_dot_by_beta_of_place_46*beta_rate_dot_by_beta_of_place_81 - cos(gamma -
    //   delta)*(e_inv*(d1_of_place_8 + beta_rate_dot_by_beta_of_place_39 +
    //   sin_phi_cos_phi_inv*(beta_rate_dot_by_beta_of_place_42 + beta_rate_dot_by_gamma_of_place_2)) +
    //   m4*(cos(gamma - delta) + sin_phi_cos_phi_inv*beta_rate_dot_by_gamma_of_place_4)) +
    //   sin_phi_d1_of_place_3*(beta_rate_dot_by_beta_of_place_75 + beta_rate_dot_by_gamma_of_place_5))
    let beta_rate_dot_by_gamma_of_place_6 = cos_phi_inv
        * (beta_rate_dot_by_beta_of_place_43 * sin_gamma_minus_delta
            + beta_rate_dot_by_beta_of_place_46 * beta_rate_dot_by_beta_of_place_81
            - cos_gamma_minus_delta
                * (e_inv
                    * (d1_of_place_8 + beta_rate_dot_by_beta_of_place_39
                        + sin_phi_cos_phi_inv
                            * (beta_rate_dot_by_beta_of_place_42
                                + beta_rate_dot_by_gamma_of_place_2))
                    + m4
                        * sin_phi_cos_phi_inv
                            .mul_add(
                                beta_rate_dot_by_gamma_of_place_4, cos_gamma_minus_delta,
                            ))
            + sin_phi_d1_of_place_3
                * (beta_rate_dot_by_beta_of_place_75 + beta_rate_dot_by_gamma_of_place_5))
        + beta_rate_dot_by_beta_of_place_27 * m4_d1_of_place_3;
    let beta_rate_dot_by_gamma_of_place_7 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_beta_of_place_75;
    // cos(gamma - delta - phi) + beta_rate_dot_by_beta_of_place_27*sin_phi_doubled
    let beta_rate_dot_by_gamma_of_place_8 = beta_rate_dot_by_beta_of_place_27
        .mul_add(sin_phi_doubled, beta_rate_dot_by_beta_of_place_22);
    // beta_rate_dot_by_beta_of_place_27 + beta_rate_dot_by_beta_of_place_45
    let beta_rate_dot_by_gamma_of_place_9 = beta_rate_dot_by_beta_of_place_27
        + beta_rate_dot_by_beta_of_place_45;
    // d1_of_place_2*ea_ss_inv + beta_rate_dot_by_theta_of_place_7*sin(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_10 = beta_rate_dot_by_theta_of_place_7
        .mul_add(sin_gamma_minus_delta, d1_of_place_2 * ea_ss_inv);
    let beta_rate_dot_by_gamma_of_place_11 = beta_rate_dot_by_theta_of_place_3
        * beta_rate_dot_by_theta_of_place_12;
    // sin(gamma - delta - phi) + cos_phi_inv*beta_rate_dot_by_beta_of_place_20
    let beta_rate_dot_by_gamma_of_place_12 = cos_phi_inv
        .mul_add(beta_rate_dot_by_beta_of_place_20, d1_of_place_3);
    // ea_ss_inv*cos(gamma - delta) - beta_rate_dot_by_theta_of_place_11*sin(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_13 = (-beta_rate_dot_by_theta_of_place_11)
        .mul_add(sin_gamma_minus_delta, ea_ss_inv * cos_gamma_minus_delta);
    // beta_rate_dot_by_beta_of_place_80*(cos_phi_inv*sin(gamma - delta) - sin(gamma - delta - phi)) +
    //   sin_phi_cos_phi_inv*beta_rate_dot_by_beta_of_place_83*sin(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_14 = beta_rate_dot_by_beta_of_place_80
        * cos_phi_inv.mul_add(sin_gamma_minus_delta, -d1_of_place_3)
        + sin_phi_cos_phi_inv * beta_rate_dot_by_beta_of_place_83 * sin_gamma_minus_delta;
    let beta_rate_dot_by_gamma_of_place_15 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_place_12;
    let beta_rate_dot_by_gamma_of_phi = cos_phi_inv * sin_phi_cos_phi_inv;
    let beta_rate_dot_by_gamma_of_place_16 = d1_of_place_7 * beta_rate_dot_by_gamma_of_phi;
    let beta_rate_dot_by_gamma_of_place_17 = beta_rate_dot_by_beta_of_gamma_delta
        * beta_rate_dot_by_gamma_of_place_16;
    let beta_rate_dot_by_gamma_of_place_18 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_theta_of_place_10;
    // beta_rate_dot_by_theta_of_place_13*sin(gamma - delta) + beta_rate_dot_by_gamma_of_place_18
    let beta_rate_dot_by_gamma_of_place_19 = beta_rate_dot_by_theta_of_place_13
        .mul_add(sin_gamma_minus_delta, beta_rate_dot_by_gamma_of_place_18);
    let beta_rate_dot_by_gamma_of_place_20 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_place_15;
    let beta_rate_dot_by_gamma_of_place_21 = beta_rate_dot_by_beta_of_place_31
        * beta_rate_dot_by_beta_of_place_56;
    let beta_rate_dot_by_gamma_of_place_22 = S::int(2) * beta_rate_dot_by_beta_of_place_94;
    // cos(gamma - epsilon) + beta_rate_dot_by_gamma_of_place_22
    let beta_rate_dot_by_gamma_of_place_23 = cos_gamma_minus_epsilon
        + beta_rate_dot_by_gamma_of_place_22;
    let beta_rate_dot_by_gamma_of_place_24 = beta_rate_dot_by_beta_of_place_62
        * beta_rate_dot_by_theta_of_place_18;
    // beta_rate_dot_by_beta_of_place_36*m6_d1_of_place_12 +
    //   cos_omega_inv*(beta_rate_dot_by_beta_of_place_61*cos(gamma - epsilon) -
    //   beta_rate_dot_by_beta_of_place_65*beta_rate_dot_by_beta_of_place_94 - sin(gamma -
    //   epsilon)*(zf_inv*(d1_of_place_17 + beta_rate_dot_by_beta_of_place_57 -
    //   sin_omega_cos_omega_inv*(beta_rate_dot_by_beta_of_place_60 + beta_rate_dot_by_gamma_of_place_21)) +
    //   m6*(sin(gamma - epsilon) - sin_omega_cos_omega_inv*beta_rate_dot_by_gamma_of_place_23)) -
    //   sin_omega_d1_of_place_12*(beta_rate_dot_by_beta_of_place_89 + beta_rate_dot_by_gamma_of_place_24))
    let beta_rate_dot_by_gamma_of_place_25 = cos_omega_inv
        * (beta_rate_dot_by_beta_of_place_61 * cos_gamma_minus_epsilon
            - beta_rate_dot_by_beta_of_place_65 * beta_rate_dot_by_beta_of_place_94
            - sin_gamma_minus_epsilon
                * (zf_inv
                    * (d1_of_place_17 + beta_rate_dot_by_beta_of_place_57
                        - sin_omega_cos_omega_inv
                            * (beta_rate_dot_by_beta_of_place_60
                                + beta_rate_dot_by_gamma_of_place_21))
                    + m6
                        * (-sin_omega_cos_omega_inv)
                            .mul_add(
                                beta_rate_dot_by_gamma_of_place_23, sin_gamma_minus_epsilon,
                            ))
            - sin_omega_d1_of_place_12
                * (beta_rate_dot_by_beta_of_place_89 + beta_rate_dot_by_gamma_of_place_24))
        + beta_rate_dot_by_beta_of_place_36 * m6_d1_of_place_12;
    let beta_rate_dot_by_gamma_of_place_26 = beta_rate_dot_by_beta_of_place_31
        * beta_rate_dot_by_beta_of_place_89;
    // beta_rate_dot_by_beta_of_place_36*sin_omega_doubled - sin(gamma - epsilon - omega)
    let beta_rate_dot_by_gamma_of_place_27 = beta_rate_dot_by_beta_of_place_36
        .mul_add(sin_omega_doubled, -beta_rate_dot_by_beta_of_place_31);
    // beta_rate_dot_by_beta_of_place_36 + beta_rate_dot_by_beta_of_place_63
    let beta_rate_dot_by_gamma_of_place_28 = beta_rate_dot_by_beta_of_place_36
        + beta_rate_dot_by_beta_of_place_63;
    // d1_of_place_10*fa_ss_inv - beta_rate_dot_by_theta_of_place_19*cos(gamma - epsilon)
    let beta_rate_dot_by_gamma_of_place_29 = (-beta_rate_dot_by_theta_of_place_19)
        .mul_add(cos_gamma_minus_epsilon, d1_of_place_10 * fa_ss_inv);
    let beta_rate_dot_by_gamma_of_place_30 = beta_rate_dot_by_theta_of_place_3
        * beta_rate_dot_by_theta_of_place_23;
    let beta_rate_dot_by_gamma_of_place_31 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_place_23;
    // -beta_rate_dot_by_gamma_of_place_31
    let beta_rate_dot_by_gamma_of_place_32 = -beta_rate_dot_by_gamma_of_place_31;
    let beta_rate_dot_by_gamma_of_place_33 = sin_omega_cos_omega_inv
        * beta_rate_dot_by_beta_of_place_71;
    // beta_rate_dot_by_theta_of_place_24*(cos(gamma - epsilon - omega) +
    //   cos_omega_inv*beta_rate_dot_by_beta_of_place_29) +
    //   zf_inv*beta_rate_dot_by_gamma_of_place_33*cos(gamma - epsilon)
    let beta_rate_dot_by_gamma_of_place_34 = beta_rate_dot_by_theta_of_place_24
        * cos_omega_inv.mul_add(beta_rate_dot_by_beta_of_place_29, d1_of_place_12)
        + zf_inv * beta_rate_dot_by_gamma_of_place_33 * cos_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_93*(cos_omega_inv*cos(gamma - epsilon) - cos(gamma - epsilon -
    //   omega)) + sin_omega_cos_omega_inv*beta_rate_dot_by_beta_of_place_97*cos(gamma - epsilon)
    let beta_rate_dot_by_gamma_of_place_35 = beta_rate_dot_by_beta_of_place_93
        * cos_omega_inv.mul_add(cos_gamma_minus_epsilon, -d1_of_place_12)
        + sin_omega_cos_omega_inv * beta_rate_dot_by_beta_of_place_97 * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_gamma_of_place_36 = cos_omega_inv
        * beta_rate_dot_by_beta_of_place_95 * beta_rate_dot_by_theta_of_place_24;
    let beta_rate_dot_by_gamma_of_place_37 = beta_rate_dot_by_beta_of_place_31
        * beta_rate_dot_by_theta_of_place_22;
    // beta_rate_dot_by_theta_of_place_25*cos(gamma - epsilon) + beta_rate_dot_by_gamma_of_place_37
    let beta_rate_dot_by_gamma_of_place_38 = beta_rate_dot_by_theta_of_place_25
        .mul_add(cos_gamma_minus_epsilon, beta_rate_dot_by_gamma_of_place_37);
    let beta_rate_dot_by_gamma_of_place_39 = d1_of_place_3 * beta_rate_dot_by_beta_of_place_22;
    // cos_phi_inv_sq*(2*d1_by_gamma_of_place_3 + m4*(d1_of_place_6*sin(gamma - delta) -
    //   2*beta_rate_dot_by_gamma_of_place_39 + cos(gamma -
    //   delta)*(ea_e_inv*(beta_rate_dot_by_beta_of_place_20 + beta_rate_dot_by_gamma_of_place_3) +
    //   beta_rate_dot_by_gamma_of_place_4)))
    let beta_rate_dot_by_gamma_of_place_40 = cos_phi_inv_sq
        * (m4
            * (d1_of_place_6 * sin_gamma_minus_delta
                - S::int(2) * beta_rate_dot_by_gamma_of_place_39
                + cos_gamma_minus_delta
                    * (ea_e_inv
                        * (beta_rate_dot_by_beta_of_place_20 + beta_rate_dot_by_gamma_of_place_3)
                        + beta_rate_dot_by_gamma_of_place_4)) + S::int(2) * d1_by_gamma_of_place_3);
    let beta_rate_dot_by_gamma_of_place_41 = beta_rate_dot_by_beta_of_place_31 * d1_of_place_12;
    // cos_omega_inv_sq*(2*d1_by_gamma_of_place_6 + m6*(d1_of_place_15*cos(gamma - epsilon) -
    //   2*beta_rate_dot_by_gamma_of_place_41 + sin(gamma -
    //   epsilon)*(fa_zf_inv*(beta_rate_dot_by_beta_of_place_29 - beta_rate_dot_by_gamma_of_place_22) +
    //   beta_rate_dot_by_gamma_of_place_23)))
    let beta_rate_dot_by_gamma_of_place_42 = cos_omega_inv_sq
        * (m6
            * (d1_of_place_15 * cos_gamma_minus_epsilon
                - S::int(2) * beta_rate_dot_by_gamma_of_place_41
                + sin_gamma_minus_epsilon
                    * (fa_zf_inv
                        * (beta_rate_dot_by_beta_of_place_29 - beta_rate_dot_by_gamma_of_place_22)
                        + beta_rate_dot_by_gamma_of_place_23))
            + S::int(2) * d1_by_gamma_of_place_6);
    // beta_rate_dot_by_gamma_of_place_40 - beta_rate_dot_by_gamma_of_place_42
    let beta_rate_dot_by_gamma_of_place_43 = beta_rate_dot_by_gamma_of_place_40
        - beta_rate_dot_by_gamma_of_place_42;
    let beta_rate_dot_by_gamma_of_place_44 = d1_of_d_beta_gamma * beta_rate_dot_by_theta_of_place_3;
    // cos(beta - gamma) - beta_rate_dot_by_theta_of_place_53 +
    //   rr_cos_angle_inv*beta_rate_dot_by_gamma_of_place_44*sin(beta - gamma)
    let beta_rate_dot_by_gamma_of_place_45 = (rr_cos_angle_inv * beta_rate_dot_by_gamma_of_place_44)
        .mul_add(
            sin_beta_minus_gamma,
            cos_beta_minus_gamma - beta_rate_dot_by_theta_of_place_53,
        );
    // beta_rate_dot_by_gamma = (rr*tan(beta + theta - gamma)*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta -
    //   gamma) - cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma)))))/(d*cos(beta + theta - gamma)))/d +
    //   sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) + rr*(sin(theta)*(c0*sqrt(xc^2 + xb*(xb -
    //   2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))^2) + c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) + sc*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb))) - sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb)))^2/(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))) - l0*(sd*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) + sc*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*sin(beta - gamma)/d + tan(beta + theta -
    //   gamma)*(rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) + (rr*(tan(beta + theta - gamma)*(sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma) -
    //   m2*da*(cos(theta)*cos(beta - gamma)/ss + 2*sin(beta - gamma)*cos(beta - gamma)/d)/d - (sin(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d +
    //   sin(theta)*(sin(theta)*((I3 + m3*(sa^2 + sb^2))/ss^3 + tan(beta + theta - gamma)^2*(I3 + m3*(sa^2 +
    //   sb^2))/ss^3 + (cos(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1)
    //   + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5
    //   + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) -
    //   tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta -
    //   phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma
    //   - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta -
    //   phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma -
    //   delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss
    //   + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma
    //   - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) + sin(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2) - sin(gamma - delta -
    //   phi)*((m4*sin(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) + m4*cos(gamma - delta)*cos(gamma -
    //   delta - phi)*(1 - ea/e) + (sin(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) +
    //   sin(phi)*cos(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)) - cos(gamma - delta)*((cos(gamma - delta)*(I4/e +
    //   m4*ea*(ea/e - 2)) + sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*sin(phi))))/e + m4*(cos(gamma - delta) + tan(phi)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma
    //   - delta - phi)))) + sin(phi)*sin(gamma - delta - phi)*(m4*cos(gamma - delta)*(ea/e - 1) + cos(gamma
    //   - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) - (I5*(sin(gamma - delta -
    //   phi)*tan(beta + theta - gamma)^2 + cos(gamma - delta - phi)*tan(gamma - beta - theta)) +
    //   m5*(ta^2*(sin(gamma - delta - phi)*tan(beta + theta - gamma)^2 + cos(gamma - delta - phi)*tan(gamma
    //   - beta - theta)) + tb^2*(sin(gamma - delta - phi)*tan(beta + theta - gamma)^2 + cos(gamma - delta -
    //   phi)*tan(gamma - beta - theta))))/(ss*zt))/zt + m4*((sin(gamma - delta)*(cos(gamma - delta)*(1 -
    //   ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss +
    //   (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)) - ea*cos(gamma -
    //   delta)*sin(phi)/ss - cos(gamma - delta)*(sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta -
    //   phi)/cos(phi) + sin(phi)*((2*sin(gamma - delta)*sin(phi)*(ea/e - 1) + cos(gamma - delta -
    //   phi))/cos(phi)^2 - 2*ea/ss - 2*ea*tan(beta + theta - gamma)^2/ss)))/e - (sin(phi)*(2*sin(gamma -
    //   delta)*tan(beta + theta - gamma) + cos(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma)^2) + sin(gamma - delta - phi)*tan(beta + theta - gamma)^2 + cos(gamma - delta -
    //   phi)*tan(gamma - beta - theta))/ss)) + cos(gamma - delta)*(m4*((sin(gamma -
    //   delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma - delta)/cos(phi)) + ea*((sin(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss - tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) +
    //   cos(gamma - delta - phi))) - ea*cos(gamma - delta)/ss + cos(gamma - delta)*(ea/ss + ea*tan(beta +
    //   theta - gamma)^2/ss - tan(phi)*(sin(gamma - delta - phi) + sin(gamma - delta)*(ea/e -
    //   2)/cos(phi))))/e + (2*sin(gamma - delta)*tan(gamma - beta - theta) - 2*cos(gamma - delta)*tan(beta +
    //   theta - gamma)^2 + sin(phi)*sin(gamma - delta - phi))/ss) + cos(gamma - delta)*tan(phi)*(sin(gamma -
    //   delta - phi) - sin(gamma - delta)/cos(phi)))/e + (cos(gamma - delta)*tan(beta + theta - gamma)^2 -
    //   sin(gamma - delta)*tan(gamma - beta - theta) - sin(phi)*sin(gamma - delta - phi))/ss) +
    //   I4*((sin(gamma - delta)*tan(beta + theta - gamma) + cos(gamma - delta)*tan(beta + theta -
    //   gamma)^2)/ss - 2*sin(gamma - delta)*cos(gamma - delta)*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 +
    //   (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*(fa/zf - 1) +
    //   m6*cos(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (cos(gamma - epsilon)*((sin(gamma
    //   - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) +
    //   tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) +
    //   tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) +
    //   sin(omega)*sin(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)) + sin(gamma - epsilon)*((sin(gamma -
    //   epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u -
    //   tan(omega)*(cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + sin(gamma - epsilon - omega)*((I7 +
    //   m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega))))/zf + m6*(sin(gamma - epsilon) - tan(omega)*(cos(gamma -
    //   epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega)))) + sin(omega)*cos(gamma - epsilon -
    //   omega)*(m6*sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 +
    //   ub^2))/u^2)/cos(omega)))/cos(omega) + (I7*(sin(gamma - epsilon - omega)*tan(beta + theta - gamma) +
    //   cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) +
    //   ub^2*(sin(gamma - epsilon - omega)*tan(beta + theta - gamma) + cos(gamma - epsilon - omega)*tan(beta
    //   + theta - gamma)^2)))/(ss*u))/u + m6*((cos(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss +
    //   (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)) -
    //   fa*sin(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa/ss + 2*fa*tan(beta + theta - gamma)^2/ss
    //   - (2*cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega))/cos(omega)^2)))/zf
    //   + (sin(gamma - epsilon - omega)*tan(beta + theta - gamma) - sin(omega)*(sin(gamma - epsilon) +
    //   2*sin(gamma - epsilon)*tan(beta + theta - gamma)^2 + 2*cos(gamma - epsilon)*tan(gamma - beta -
    //   theta)) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2)/ss)) - sin(gamma - epsilon -
    //   omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) - cos(gamma -
    //   epsilon)*(m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) -
    //   fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma
    //   - epsilon - omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss) - I6*((sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2)
    //   - sin(gamma - epsilon)*(m6*((cos(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) -
    //   sin(gamma - epsilon)/cos(omega)) + fa*((2*sin(gamma - epsilon)*tan(beta + theta - gamma)^2 +
    //   2*cos(gamma - epsilon)*tan(gamma - beta - theta) - fa*(sin(gamma - epsilon)*tan(beta + theta -
    //   gamma)^2 + cos(gamma - epsilon)*tan(gamma - beta - theta))/zf + sin(omega)*cos(gamma - epsilon -
    //   omega))/ss - cos(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf - sin(gamma - epsilon)*tan(omega)*(cos(gamma - epsilon)*(fa/zf -
    //   2)/cos(omega) + cos(gamma - epsilon - omega))/zf) + sin(gamma - epsilon)*tan(omega)*(cos(gamma -
    //   epsilon - omega) - cos(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(beta + theta -
    //   gamma)^2 + cos(gamma - epsilon)*tan(gamma - beta - theta) + sin(omega)*cos(gamma - epsilon -
    //   omega))/ss) - I6*((sin(gamma - epsilon)*tan(beta + theta - gamma)^2 + cos(gamma - epsilon)*tan(gamma
    //   - beta - theta))/ss + 2*sin(gamma - epsilon)*cos(gamma -
    //   epsilon)*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega)^2) - sin(beta - gamma)*tan(gamma - beta -
    //   theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d - cos(beta - gamma)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d - cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d - cos(beta -
    //   gamma)*tan(beta + theta - gamma)*((2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 - 2*sin(gamma -
    //   delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2)
    //   - 2*sin(phi)*sin(gamma - delta - phi))/e) - 2*sin(gamma - delta - phi)*cos(gamma - delta - phi) +
    //   cos(gamma - delta)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi) + ea*(sin(gamma -
    //   delta)*(ea/e - 2) + 2*sin(phi)*cos(gamma - delta - phi))/e)))/cos(phi)^2 + (2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 - m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon
    //   - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) -
    //   fa*(cos(gamma - epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2)/d) + cos(beta - gamma)*((I2*(sin(beta - gamma)*tan(gamma - beta - theta)
    //   + cos(beta - gamma)*tan(beta + theta - gamma)^2) + m2*da^2*(sin(beta - gamma)*tan(gamma - beta -
    //   theta) + cos(beta - gamma)*tan(beta + theta - gamma)^2))/(d*ss) - cos(theta)*(m2*da*cos(beta + theta
    //   - gamma)/ss + (2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 - 2*sin(gamma - delta - phi)*cos(gamma
    //   - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e) - 2*sin(gamma - delta - phi)*cos(gamma - delta - phi) + cos(gamma -
    //   delta)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi) + ea*(sin(gamma - delta)*(ea/e - 2)
    //   + 2*sin(phi)*cos(gamma - delta - phi))/e)))/cos(phi)^2 + (2*sin(gamma - epsilon - omega)*cos(gamma -
    //   epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 -
    //   m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma
    //   - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 - 2*sin(gamma - delta - phi)*cos(gamma -
    //   delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e) - 2*sin(gamma - delta - phi)*cos(gamma - delta - phi) + cos(gamma -
    //   delta)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi) + ea*(sin(gamma - delta)*(ea/e - 2)
    //   + 2*sin(phi)*cos(gamma - delta - phi))/e)))/cos(phi)^2 + (2*sin(gamma - epsilon - omega)*cos(gamma -
    //   epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 -
    //   m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma
    //   - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma))) -
    //   rr*beta_rate^2*(cos(beta - gamma)*tan(beta + theta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*cos(beta -
    //   gamma) - sin(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma)))))/(d*cos(beta + theta - gamma)) + cos(beta - gamma)*(I2*(cos(beta - gamma) -
    //   rr*cos(beta - gamma)^2/(d*cos(beta + theta - gamma)) - 2*rr*cos(beta - gamma)^2*tan(beta + theta -
    //   gamma)^2/(d*cos(beta + theta - gamma)) + 2*rr*sin(beta - gamma)*cos(beta - gamma)*tan(beta + theta -
    //   gamma)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*sin(beta - gamma)*tan(gamma - beta -
    //   theta) + rr*cos(theta)*cos(beta - gamma) + rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2 + da*(cos(beta - gamma) - rr*cos(beta - gamma)^2/(d*cos(beta + theta - gamma)) -
    //   2*rr*cos(beta - gamma)^2*tan(beta + theta - gamma)^2/(d*cos(beta + theta - gamma)) + 2*rr*sin(beta -
    //   gamma)*cos(beta - gamma)*tan(beta + theta - gamma)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)))/d)/cos(beta + theta - gamma))/d1 +
    //   d1_by_gamma*(rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom)/d1^2
    let beta_rate_dot_by_gamma = d1_inv
        * (rr_cos_angle_inv
            * (sin_theta
                * (rr_beta_rate_sq
                    * (beta_rate_dot_by_beta_of_place_10 + beta_rate_dot_by_theta_of_place_51
                        - cos_angle_inv
                            * (rr
                                * (d_inv_m2_da
                                    * ss_inv
                                        .mul_add(
                                            beta_rate_dot_by_beta_of_place_16,
                                            d1_of_d_beta_gamma * beta_rate_dot_by_beta_of_beta_gamma,
                                        ) + beta_rate_dot_by_theta_of_place_50
                                    + cos_angle_inv
                                        * (-sin_theta
                                            * (beta_rate_dot_by_theta_of_place_48
                                                - d1_by_beta_of_d_beta_gamma * d1_by_gamma_of_place
                                                - sin_theta
                                                    * (beta_rate_dot_by_theta_of_place_47
                                                        + cos_phi_inv_sq
                                                            * (d1_of_place_3
                                                                * (m4
                                                                    * (e_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (sin_phi
                                                                                * (-ea_ss_inv)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_theta_of_place_44,
                                                                                        cos_phi_inv_sq * beta_rate_dot_by_gamma_of_place_8,
                                                                                    ) + beta_rate_dot_by_gamma_of_place_9)
                                                                            + beta_rate_dot_by_gamma_of_place_10)
                                                                        + ss_inv
                                                                            * (beta_rate_dot_by_gamma_of_place
                                                                                + sin_phi
                                                                                    * (cos_gamma_minus_delta
                                                                                        + beta_rate_dot_by_gamma_of_place_11)))
                                                                    - zt_inv
                                                                        * (beta_rate_dot_by_gamma_of_place_6
                                                                            - zt_inv_ss_inv
                                                                                * (m5 * ta_sq_plus_tb_sq)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_gamma_of_place,
                                                                                        I5 * beta_rate_dot_by_gamma_of_place,
                                                                                    ) - beta_rate_dot_by_gamma_of_place_7))
                                                                - cos_gamma_minus_delta
                                                                    * (m4
                                                                        * (e_inv
                                                                            * (ea
                                                                                * (ss_inv
                                                                                    * (beta_rate_dot_by_gamma_of_place_11
                                                                                        - sin_phi_d1_of_place_3)
                                                                                    + e_inv
                                                                                        * (cos_gamma_minus_delta
                                                                                            * sin_phi_cos_phi_inv
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_gamma_of_place_12,
                                                                                                    -beta_rate_dot_by_theta_of_place_40,
                                                                                                ) + beta_rate_dot_by_gamma_of_place_13))
                                                                                + beta_rate_dot_by_gamma_of_place_14)
                                                                            + ss_inv
                                                                                * (sin_phi_d1_of_place_3
                                                                                    - beta_rate_dot_by_gamma_of_place_15))
                                                                        + e_inv_i4_e_inv
                                                                            * (-ss_inv)
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_gamma_of_place_15,
                                                                                    beta_rate_dot_by_gamma_of_place_17,
                                                                                )) + beta_rate_dot_by_gamma_of_place_19)
                                                        + cos_omega_inv_sq
                                                            * (sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (ss_inv
                                                                        * (sin_omega_d1_of_place_12
                                                                            - beta_rate_dot_by_gamma_of_place_31)
                                                                        + zf_inv
                                                                            * (fa
                                                                                * (ss_inv
                                                                                    * fa_zf_inv
                                                                                        .mul_add(
                                                                                            beta_rate_dot_by_gamma_of_place_32,
                                                                                            beta_rate_dot_by_gamma_of_place_30
                                                                                                - sin_omega_d1_of_place_12,
                                                                                        ) + beta_rate_dot_by_gamma_of_place_34)
                                                                                + beta_rate_dot_by_gamma_of_place_35))
                                                                    + zf_inv_i6_zf_inv
                                                                        * ss_inv
                                                                            .mul_add(
                                                                                beta_rate_dot_by_gamma_of_place_32,
                                                                                beta_rate_dot_by_gamma_of_place_36,
                                                                            ))
                                                                - d1_of_place_12
                                                                    * (u_2_inv
                                                                        * (beta_rate_dot_by_gamma_of_place_25
                                                                            - u_2_inv_ss_inv
                                                                                * (m7 * ua_sq_plus_ub_sq)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_gamma_of_place_20,
                                                                                        I7 * beta_rate_dot_by_gamma_of_place_20,
                                                                                    ) - beta_rate_dot_by_gamma_of_place_26)
                                                                        + m6
                                                                            * (zf_inv
                                                                                * (beta_rate_dot_by_gamma_of_place_29
                                                                                    - sin_gamma_minus_epsilon
                                                                                        * (sin_omega
                                                                                            * cos_omega_inv_sq
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_gamma_of_place_27,
                                                                                                    fa_ss_inv * beta_rate_dot_by_theta_of_place_44,
                                                                                                ) + beta_rate_dot_by_gamma_of_place_28))
                                                                                - ss_inv
                                                                                    * (beta_rate_dot_by_gamma_of_place_20
                                                                                        + sin_omega
                                                                                            * (beta_rate_dot_by_gamma_of_place_30
                                                                                                - sin_gamma_minus_epsilon))))
                                                                + beta_rate_dot_by_gamma_of_place_38))
                                                + beta_rate_dot_by_theta_of_place_28
                                                    * beta_rate_dot_by_gamma_of_place_43)
                                            + d1_by_beta_of_d_beta_gamma
                                                * beta_rate_dot_by_theta_of_place_33
                                            - d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * m2_da
                                                        .mul_add(
                                                            cos_angle_ss_inv,
                                                            beta_rate_dot_by_gamma_of_place_43,
                                                        )
                                                    - i2_plus_da_m2_da * sin_angle_cos_angle_inv
                                                        * beta_rate_dot_by_theta_of_place_30 * ss_inv_d_inv)))
                                + beta_rate_dot_by_gamma_of_place_43 * cos_theta))
                    - beta_rate_dot_by_beta_of_place_8
                        * (beta_rate_dot_by_beta_of_place_5
                            * sc
                                .mul_add(
                                    beta_rate_dot_by_beta_of_place_2,
                                    sd * beta_rate_dot_by_beta_of_place,
                                )
                            + beta_rate_dot_by_beta_of_place_3 * beta_rate_dot_by_beta_of_place_3
                                * beta_rate_dot_by_beta_of_place_7)
                    - beta_rate_dot_by_beta_of_place_3 * beta_rate_dot_by_beta_of_place_6
                        * beta_rate_dot_by_beta_of_place_9)
                + d_inv_rr_beta_rate_sq
                    * (beta_rate_dot_by_theta_of_place_59
                        * (d1_by_beta_of_d_beta_gamma - beta_rate_dot_by_theta_of_place_28)
                        + cos_theta_m2_da * cos_beta_minus_gamma
                        - d1_by_theta_of_place_2
                            * (m2_da
                                * ((-beta_rate_dot_by_theta_of_place_35)
                                    .mul_add(
                                        beta_rate_dot_by_theta_of_place_55,
                                        beta_rate_dot_by_theta_of_place_56,
                                    ) + da * beta_rate_dot_by_gamma_of_place_45)
                                + I2 * beta_rate_dot_by_gamma_of_place_45)))
            - beta_rate_dot_by_theta_of_beta_rate_3)
        - d1_by_gamma * beta_rate_dot_by_theta_of_beta_rate_4;
    let d1_by_delta_of_place = rr_cos_angle_inv * sin_theta;
    let d1_by_delta_of_place_2 = S::int(2) * d1_by_delta_of_place * d1_by_delta_of_place;
    // d1_by_delta = 2*rr^2*sin(theta)^2*(I4*sin(gamma - delta)*cos(gamma - delta)/e^2 - sin(gamma - delta
    //   - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 - m4*(sin(gamma - delta -
    //   phi)*(sin(gamma - delta)*sin(phi)*(ea/e - 1) + cos(gamma - delta - phi)) - cos(gamma -
    //   delta)*(sin(gamma - delta) - sin(phi)*cos(gamma - delta - phi) + ea*(sin(gamma - delta)*(ea/e - 2) +
    //   sin(phi)*cos(gamma - delta - phi))/e)))/(cos(beta + theta - gamma)^2*cos(phi)^2)
    let d1_by_delta = d1_by_gamma_of_place_4 * d1_by_delta_of_place_2;
    // sin(gamma - delta - phi) + cos(gamma - delta - phi)*sin_angle_cos_angle_inv
    let beta_rate_dot_by_delta_of_place = beta_rate_dot_by_beta_of_place_22
        .mul_add(sin_angle_cos_angle_inv, d1_of_place_3);
    // zt_inv_ss_inv*(I5*beta_rate_dot_by_delta_of_place +
    //   m5*ta_sq_plus_tb_sq*beta_rate_dot_by_delta_of_place) - beta_rate_dot_by_gamma_of_place_7
    let beta_rate_dot_by_delta_of_place_2 = zt_inv_ss_inv
        * (m5 * ta_sq_plus_tb_sq)
            .mul_add(
                beta_rate_dot_by_delta_of_place,
                I5 * beta_rate_dot_by_delta_of_place,
            ) - beta_rate_dot_by_gamma_of_place_7;
    let beta_rate_dot_by_delta_of_place_3 = beta_rate_dot_by_theta_of_place_3
        * sin_gamma_minus_delta;
    // cos(gamma - delta) - sin_angle_cos_angle_inv*sin(gamma - delta)
    let beta_rate_dot_by_delta_of_place_4 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_delta, cos_gamma_minus_delta);
    let beta_rate_dot_by_delta_of_place_5 = d1_of_d_beta_gamma * cos_theta;
    let beta_rate_dot_by_delta_of_beta_rate = beta_rate * d1_by_delta_of_place;
    let beta_rate_dot_by_delta_of_beta_rate_2 = beta_rate * rr_cos_angle_inv;
    let beta_rate_dot_by_delta_of_beta_rate_3 = d1_inv * beta_rate_dot_by_delta_of_beta_rate_2;
    let beta_rate_dot_by_delta_of_beta_rate_4 = beta_rate_dot_by_delta_of_beta_rate
        * beta_rate_dot_by_delta_of_beta_rate_3;
    // beta_rate_dot_by_delta = rr^2*beta_rate^2*sin(theta)*(cos(theta)*(2*I4*sin(gamma - delta)*cos(gamma
    //   - delta)/e^2 - 2*sin(gamma - delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma -
    //   delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e) - 2*sin(gamma - delta - phi)*cos(gamma -
    //   delta - phi) + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi) +
    //   ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(phi)*cos(gamma - delta - phi))/e)))/cos(phi)^2 +
    //   rr*(cos(theta)*cos(beta - gamma)*(2*sin(gamma - delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2
    //   + tb^2))/zt^2 - 2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 - m4*(sin(gamma - delta)*(cos(gamma -
    //   delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e) - 2*sin(gamma - delta - phi)*cos(gamma - delta - phi) +
    //   cos(gamma - delta)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi) + ea*(sin(gamma -
    //   delta)*(ea/e - 2) + 2*sin(phi)*cos(gamma - delta - phi))/e)))/(d*cos(phi)^2) + sin(theta)*(cos(beta
    //   - gamma)*tan(gamma - beta - theta)*(2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 - 2*sin(gamma -
    //   delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2)
    //   - 2*sin(phi)*sin(gamma - delta - phi))/e) - 2*sin(gamma - delta - phi)*cos(gamma - delta - phi) +
    //   cos(gamma - delta)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi) + ea*(sin(gamma -
    //   delta)*(ea/e - 2) + 2*sin(phi)*cos(gamma - delta - phi))/e)))/(d*cos(phi)^2) + sin(theta)*(cos(gamma
    //   - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) + (cos(gamma -
    //   delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 +
    //   tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) -
    //   cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma -
    //   delta) + 2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi)
    //   + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt +
    //   m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma - delta)*(1 - ea/e) -
    //   cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss + (2*cos(gamma -
    //   delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma - delta -
    //   phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta +
    //   theta - gamma)) + cos(gamma - delta - phi))/ss)) + sin(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss - tan(phi)*(cos(gamma - delta)*(ea/e
    //   - 2)/cos(phi) + cos(gamma - delta - phi))))/e + (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma -
    //   delta) - 2*cos(gamma - delta)*tan(beta + theta - gamma))/ss) + cos(gamma -
    //   delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma - delta)/cos(phi)))/e + (sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2*tan(phi)/(e*cos(phi)))/e^2) - sin(gamma - delta - phi)*((m4*sin(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + m4*cos(gamma - delta)*cos(gamma - delta - phi)*(1 - ea/e) + (sin(gamma -
    //   delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 +
    //   tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) -
    //   cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma -
    //   delta) + 2*sin(phi)*sin(gamma - delta - phi)))) + sin(phi)*cos(gamma - delta - phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)) -
    //   cos(gamma - delta)*((cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + sin(gamma - delta - phi)*(I5 +
    //   m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta -
    //   phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi))))/e + m4*(cos(gamma - delta) +
    //   tan(phi)*(sin(gamma - delta) - 2*sin(phi)*cos(gamma - delta - phi)))) + sin(phi)*sin(gamma - delta -
    //   phi)*(m4*cos(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi) + cos(gamma - delta - phi)*tan(beta
    //   + theta - gamma)) + m5*(ta^2*(sin(gamma - delta - phi) + cos(gamma - delta - phi)*tan(beta + theta -
    //   gamma)) + tb^2*(sin(gamma - delta - phi) + cos(gamma - delta - phi)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((sin(gamma - delta)*(cos(gamma - delta)*(1 - ea/e) - cos(gamma - delta -
    //   phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 -
    //   ea/e) + sin(gamma - delta - phi))/cos(phi)^2)) - ea*cos(gamma - delta)*sin(phi)/ss - cos(gamma -
    //   delta)*(sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)/cos(phi) + tan(phi)*(2*sin(gamma -
    //   delta)*sin(phi)*(ea/e - 1) + cos(gamma - delta - phi))/cos(phi)))/e + (sin(phi)*(2*sin(gamma -
    //   delta)*tan(gamma - beta - theta) + cos(gamma - delta)) + sin(gamma - delta - phi) + cos(gamma -
    //   delta - phi)*tan(beta + theta - gamma))/ss)) + cos(gamma - delta)*(m4*((sin(gamma -
    //   delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma - delta)/cos(phi)) + cos(gamma -
    //   delta)*tan(phi)*(sin(gamma - delta - phi) - sin(gamma - delta)/cos(phi)) + ea*((sin(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss - tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) +
    //   cos(gamma - delta - phi))) - ea*cos(gamma - delta)/ss - cos(gamma - delta)*tan(phi)*(sin(gamma -
    //   delta - phi) + sin(gamma - delta)*(ea/e - 2)/cos(phi)))/e + (2*sin(gamma - delta)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - delta) + sin(phi)*sin(gamma - delta - phi))/ss))/e - (sin(gamma -
    //   delta)*tan(gamma - beta - theta) + cos(gamma - delta) + sin(phi)*sin(gamma - delta - phi))/ss) -
    //   I4*((sin(gamma - delta)*tan(gamma - beta - theta) + cos(gamma - delta))/ss + 2*sin(gamma -
    //   delta)*cos(gamma - delta)*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2))/cos(beta + theta -
    //   gamma))/(d1*cos(beta + theta - gamma)^2) +
    //   d1_by_delta*(rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom)/d1^2
    let beta_rate_dot_by_delta = beta_rate_dot_by_delta_of_beta_rate_4
        * (rr_cos_angle_inv
            * (sin_theta
                * (cos_phi_inv_sq * sin_theta
                    * (beta_rate_dot_by_gamma_of_place_19
                        - d1_of_place_3
                            * (zt_inv
                                * (beta_rate_dot_by_gamma_of_place_6
                                    + beta_rate_dot_by_delta_of_place_2)
                                + m4
                                    * (ss_inv
                                        * (beta_rate_dot_by_delta_of_place
                                            + sin_phi
                                                * (cos_gamma_minus_delta
                                                    - beta_rate_dot_by_delta_of_place_3))
                                        - e_inv
                                            * (beta_rate_dot_by_gamma_of_place_10
                                                + cos_gamma_minus_delta
                                                    * beta_rate_dot_by_gamma_of_place_8
                                                        .mul_add(
                                                            beta_rate_dot_by_gamma_of_phi,
                                                            beta_rate_dot_by_gamma_of_place_9,
                                                        ))))
                        - cos_gamma_minus_delta
                            * (m4
                                * (e_inv
                                    * (beta_rate_dot_by_gamma_of_place_14
                                        + ea
                                            * (e_inv
                                                * beta_rate_dot_by_beta_of_place_80
                                                    .mul_add(
                                                        beta_rate_dot_by_gamma_of_place_12,
                                                        beta_rate_dot_by_gamma_of_place_13,
                                                    )
                                                + ss_inv
                                                    * ((-cos_gamma_minus_delta)
                                                        .mul_add(S::int(2), beta_rate_dot_by_delta_of_place_3)
                                                        - sin_phi_d1_of_place_3)))
                                    + ss_inv
                                        * (sin_phi_d1_of_place_3
                                            + beta_rate_dot_by_delta_of_place_4))
                                + e_inv_i4_e_inv
                                    * ss_inv
                                        .mul_add(
                                            beta_rate_dot_by_delta_of_place_4,
                                            beta_rate_dot_by_gamma_of_place_17,
                                        )))
                    - beta_rate_dot_by_theta_of_place_28 * beta_rate_dot_by_gamma_of_place_40)
                - beta_rate_dot_by_gamma_of_place_40 * beta_rate_dot_by_delta_of_place_5)
            + beta_rate_dot_by_gamma_of_place_40 * cos_theta)
        - d1_by_delta * beta_rate_dot_by_theta_of_beta_rate_4;
    // d1_by_phi = -2*rr^2*sin(theta)^2*(m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) +
    //   (sin(gamma - delta - phi)*cos(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2) -
    //   sin(phi)*(m4*cos(gamma - delta)*cos(gamma - delta - phi)*(ea/e - 1) + (I4*cos(gamma - delta)^2/e^2 +
    //   sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma
    //   - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e -
    //   2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)))/cos(phi))/(cos(beta + theta -
    //   gamma)^2*cos(phi))
    let d1_by_phi = -cos_phi_inv * d1_by_delta_of_place_2
        * (beta_rate_dot_by_beta_of_place_76
            + cos_phi_inv
                * (-sin_phi
                    * d1_of_place_9
                        .mul_add(cos_phi_inv, beta_rate_dot_by_gamma_of_place_7)
                    + beta_rate_dot_by_beta_of_place_44 * beta_rate_dot_by_gamma_of_place_39));
    let cos_phi_d1_of_place_3 = d1_of_place_3 * cos_phi;
    // 1 + sin_phi_cos_phi_inv^2
    let beta_rate_dot_by_phi_of_phi = sin_phi_cos_phi_inv
        .mul_add(sin_phi_cos_phi_inv, S::int(1));
    // cos_phi_d1_of_place_3 - beta_rate_dot_by_beta_of_place_81
    let beta_rate_dot_by_phi_of_place = cos_phi_d1_of_place_3 - beta_rate_dot_by_beta_of_place_81;
    // -beta_rate_dot_by_phi_of_place
    let beta_rate_dot_by_phi_of_place_2 = -beta_rate_dot_by_phi_of_place;
    let beta_rate_dot_by_phi_of_phi_2 = S::int(2) * sin_phi_cos_phi_inv;
    // ss_inv*(cos(gamma - delta - phi)*cos(phi) + sin_phi_d1_of_place_3)
    let beta_rate_dot_by_phi_of_place_3 = ss_inv
        * beta_rate_dot_by_beta_of_place_22.mul_add(cos_phi, sin_phi_d1_of_place_3);
    // d1_by_gamma_of_place_2 + m4*(beta_rate_dot_by_gamma_of_place_39 - cos(gamma -
    //   delta)*(beta_rate_dot_by_phi_of_place + ea_e_inv*beta_rate_dot_by_phi_of_place_2))
    let beta_rate_dot_by_phi_of_place_4 = d1_by_gamma_of_place_2
        + m4
            * (beta_rate_dot_by_gamma_of_place_39
                - cos_gamma_minus_delta
                    * ea_e_inv
                        .mul_add(
                            beta_rate_dot_by_phi_of_place_2, beta_rate_dot_by_phi_of_place,
                        ));
    // cos_phi_inv_sq*(d1_of_place_9*sin_phi_cos_phi_inv - beta_rate_dot_by_phi_of_place_4)
    let beta_rate_dot_by_phi_of_place_5 = cos_phi_inv_sq
        * d1_of_place_9.mul_add(sin_phi_cos_phi_inv, -beta_rate_dot_by_phi_of_place_4);
    let beta_rate_dot_by_phi_of_place_6 = cos_theta_doubled * beta_rate_dot_by_phi_of_place_5;
    // beta_rate_dot_by_phi = rr^2*beta_rate^2*sin(theta)*(2*cos(theta)*(tan(phi)*(I4*cos(gamma -
    //   delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta -
    //   phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 -
    //   (sin(gamma - delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi)*cos(gamma - delta - phi) + cos(gamma - delta)*(sin(phi)*cos(gamma - delta - phi) -
    //   sin(gamma - delta - phi)*cos(phi) + ea*(sin(gamma - delta - phi)*cos(phi) - sin(phi)*cos(gamma -
    //   delta - phi))/e)))/cos(phi)^2) - rr*(2*cos(theta)*cos(beta - gamma)*(tan(phi)*(I4*cos(gamma -
    //   delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta -
    //   phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 -
    //   (sin(gamma - delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi)*cos(gamma - delta - phi) + cos(gamma - delta)*(sin(phi)*cos(gamma - delta - phi) -
    //   sin(gamma - delta - phi)*cos(phi) + ea*(sin(gamma - delta - phi)*cos(phi) - sin(phi)*cos(gamma -
    //   delta - phi))/e)))/cos(phi)^2)/d + sin(theta)*(2*cos(beta - gamma)*tan(beta + theta -
    //   gamma)*(tan(phi)*(I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 - (sin(gamma - delta - phi)*cos(gamma - delta - phi)*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)*cos(gamma - delta - phi) + cos(gamma -
    //   delta)*(sin(phi)*cos(gamma - delta - phi) - sin(gamma - delta - phi)*cos(phi) + ea*(sin(gamma -
    //   delta - phi)*cos(phi) - sin(phi)*cos(gamma - delta - phi))/e)))/cos(phi)^2)/d +
    //   sin(theta)*(2*tan(phi)*(sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta -
    //   phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma -
    //   delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 +
    //   tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma -
    //   delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma
    //   - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma
    //   - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta -
    //   phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma -
    //   delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss
    //   + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma
    //   - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   delta)*(m4*((sin(phi)*sin(gamma - delta - phi) + cos(phi)*cos(gamma - delta - phi))/ss + (cos(gamma
    //   - delta)*(cos(gamma - delta)/cos(phi) - cos(gamma - delta - phi)) + cos(gamma -
    //   delta)*tan(phi)^2*(cos(gamma - delta)/cos(phi) - cos(gamma - delta - phi)) + ea*(cos(gamma -
    //   delta)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi) + tan(phi)^2*(cos(gamma -
    //   delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi)) + tan(phi)*(sin(gamma - delta - phi) +
    //   cos(gamma - delta)*tan(phi)*(ea/e - 2)/cos(phi)))/e - (sin(phi)*sin(gamma - delta - phi) +
    //   cos(phi)*cos(gamma - delta - phi))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma -
    //   delta)*tan(phi)/cos(phi) - sin(gamma - delta - phi)))/e) + I4*(cos(gamma - delta)^2/(e*cos(phi)) +
    //   2*cos(gamma - delta)^2*tan(phi)^2/(e*cos(phi)))/e^2) - cos(gamma - delta - phi)*((m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e +
    //   m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma -
    //   delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e +
    //   m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma
    //   - delta - phi)))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma
    //   - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta -
    //   phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta -
    //   phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta -
    //   phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma -
    //   delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma - delta)*(1 - ea/e) - cos(gamma - delta -
    //   phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta - gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 -
    //   ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) + cos(gamma
    //   - delta - phi))/ss)) - sin(gamma - delta - phi)*((m4*cos(gamma - delta)*cos(gamma - delta -
    //   phi)*(ea/e - 1) + tan(phi)*(sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)) - cos(gamma -
    //   delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 +
    //   tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) -
    //   cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma -
    //   delta) + 2*sin(phi)*sin(gamma - delta - phi)))))/cos(phi) - (I5*(sin(gamma - delta - phi) +
    //   cos(gamma - delta - phi)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta - phi) + cos(gamma
    //   - delta - phi)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi) + cos(gamma - delta -
    //   phi)*tan(beta + theta - gamma))))/(ss*zt) + (sin(gamma - delta - phi)*cos(phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)) -
    //   sin(phi)*cos(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)) - cos(gamma - delta)*((sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma
    //   - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)^2*(sin(gamma - delta - phi)*((I5 + m5*(ta^2 +
    //   tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))) +
    //   tan(phi)*(2*m4*ea*sin(gamma - delta - phi)*cos(phi) - cos(gamma - delta - phi)*((I5 + m5*(ta^2 +
    //   tb^2))/zt + 2*m4*ea*sin(phi))))/e - m4*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
    //   tan(phi)^2*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)) + 2*tan(phi)*(sin(gamma -
    //   delta - phi)*cos(phi) - sin(phi)*cos(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta -
    //   phi)*(cos(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi) - sin(gamma - delta -
    //   phi)*tan(phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi))/zt + m4*((cos(gamma -
    //   delta)*(sin(gamma - delta - phi)/cos(phi) + cos(gamma - delta - phi)*tan(phi)/cos(phi) -
    //   cos(phi)*(2*ea*tan(beta + theta - gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma
    //   - delta - phi))/cos(phi)^2) + sin(phi)*((2*cos(gamma - delta)*cos(phi)*(ea/e - 1) + cos(gamma -
    //   delta - phi))/cos(phi)^2 - 2*tan(phi)*(2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta
    //   - phi))/cos(phi)^2)) - ea*sin(gamma - delta)*cos(phi)/ss)/e + (cos(phi)*(sin(gamma - delta) +
    //   2*cos(gamma - delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi) - cos(gamma - delta -
    //   phi)*tan(beta + theta - gamma))/ss)))/cos(phi)^2)))/cos(beta + theta - gamma))/(d1*cos(beta + theta
    //   - gamma)^2) + d1_by_phi*(rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom)/d1^2
    let beta_rate_dot_by_phi = beta_rate_dot_by_delta_of_beta_rate_4
        * (beta_rate_dot_by_phi_of_place_6
            + rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (cos_phi_inv_sq
                            * (beta_rate_dot_by_gamma_of_place_18
                                + d1_of_place_3
                                    * (m4
                                        * (ss_inv
                                            * beta_rate_dot_by_theta_of_place_9
                                                .mul_add(cos_phi, -beta_rate_dot_by_delta_of_place)
                                            + e_inv
                                                * (cos_gamma_minus_delta
                                                    * (beta_rate_dot_by_beta_of_place_45
                                                        - beta_rate_dot_by_theta_of_place_5 * cos_phi
                                                        + beta_rate_dot_by_beta_of_place_22
                                                            * beta_rate_dot_by_gamma_of_phi
                                                        + sin_phi
                                                            * (cos_phi_inv_sq
                                                                * (beta_rate_dot_by_beta_of_place_48 * cos_phi)
                                                                    .mul_add(S::int(2), beta_rate_dot_by_beta_of_place_22)
                                                                + beta_rate_dot_by_theta_of_place_4
                                                                    * beta_rate_dot_by_phi_of_phi_2))
                                                    - beta_rate_dot_by_beta_of_place_78 * cos_phi))
                                        - zt_inv
                                            * (beta_rate_dot_by_delta_of_place_2
                                                + beta_rate_dot_by_beta_of_place_47
                                                    * beta_rate_dot_by_gamma_of_phi
                                                - cos_phi_inv
                                                    * (sin_phi_d1_of_place_3
                                                        * (d1_of_place_3 * beta_rate_dot_by_beta_of_place_44)
                                                            .mul_add(
                                                                beta_rate_dot_by_gamma_of_phi,
                                                                -beta_rate_dot_by_gamma_of_place_5,
                                                            )
                                                        + beta_rate_dot_by_beta_of_place_46
                                                            * beta_rate_dot_by_phi_of_place
                                                        + cos_gamma_minus_delta
                                                            * (e_inv
                                                                * (d1_of_place_8
                                                                    + sin_phi_cos_phi_inv
                                                                        * (-(m4_ea * cos_phi_d1_of_place_3))
                                                                            .mul_add(S::int(2), beta_rate_dot_by_gamma_of_place_2)
                                                                    + beta_rate_dot_by_beta_of_place_40
                                                                        * beta_rate_dot_by_phi_of_phi)
                                                                + m4
                                                                    * (-beta_rate_dot_by_phi_of_place_2)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_phi_of_phi_2,
                                                                            d1_of_place_5 * beta_rate_dot_by_phi_of_phi,
                                                                        )))))
                                - cos_gamma_minus_delta
                                    * (e_inv_i4_e_inv
                                        * (beta_rate_dot_by_beta_of_place_80
                                            * beta_rate_dot_by_gamma_of_place_16)
                                            .mul_add(
                                                S::int(2),
                                                d1_of_place_7 * beta_rate_dot_by_beta_of_place_51,
                                            )
                                        + m4
                                            * (beta_rate_dot_by_phi_of_place_3
                                                + e_inv
                                                    * (-beta_rate_dot_by_beta_of_place_80
                                                        * (d1_of_place_3 - beta_rate_dot_by_beta_of_place_86)
                                                        + beta_rate_dot_by_beta_of_place_83 * cos_gamma_minus_delta
                                                        + sin_phi_cos_phi_inv * beta_rate_dot_by_beta_of_place_84
                                                        - ea
                                                            * (beta_rate_dot_by_phi_of_place_3
                                                                - d1_of_place_7
                                                                    * (sin_phi_cos_phi_inv
                                                                        * d1_of_e_ea
                                                                            .mul_add(beta_rate_dot_by_beta_of_place_86, d1_of_place_3)
                                                                        + beta_rate_dot_by_beta_of_place_52
                                                                            * beta_rate_dot_by_phi_of_phi))))))
                            - beta_rate_dot_by_theta_of_place_14 * beta_rate_dot_by_phi_of_phi_2)
                        - beta_rate_dot_by_gamma_of_place_44 * beta_rate_dot_by_phi_of_place_5)
                    - d1_of_d_beta_gamma * beta_rate_dot_by_phi_of_place_6))
        - d1_by_phi * beta_rate_dot_by_theta_of_beta_rate_4;
    // d1_by_epsilon = 2*rr^2*sin(theta)^2*(sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 + m6*(cos(gamma - epsilon
    //   - omega)*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega)) - sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + sin(omega)*sin(gamma - epsilon - omega))/zf)))/(cos(beta + theta -
    //   gamma)^2*cos(omega)^2)
    let d1_by_epsilon = -d1_by_gamma_of_place_7 * d1_by_delta_of_place_2;
    // sin(gamma - epsilon - omega)*sin_angle_cos_angle_inv - cos(gamma - epsilon - omega)
    let beta_rate_dot_by_epsilon_of_place = beta_rate_dot_by_beta_of_place_31
        .mul_add(sin_angle_cos_angle_inv, -d1_of_place_12);
    // -beta_rate_dot_by_epsilon_of_place
    let beta_rate_dot_by_epsilon_of_place_2 = -beta_rate_dot_by_epsilon_of_place;
    // u_2_inv_ss_inv*(I7*beta_rate_dot_by_epsilon_of_place_2 +
    //   m7*ua_sq_plus_ub_sq*beta_rate_dot_by_epsilon_of_place_2) - beta_rate_dot_by_gamma_of_place_26
    let beta_rate_dot_by_epsilon_of_place_3 = u_2_inv_ss_inv
        * (m7 * ua_sq_plus_ub_sq)
            .mul_add(
                beta_rate_dot_by_epsilon_of_place_2,
                I7 * beta_rate_dot_by_epsilon_of_place_2,
            ) - beta_rate_dot_by_gamma_of_place_26;
    let beta_rate_dot_by_epsilon_of_place_4 = beta_rate_dot_by_theta_of_place_3
        * cos_gamma_minus_epsilon;
    // sin(gamma - epsilon) + sin_angle_cos_angle_inv*cos(gamma - epsilon)
    let beta_rate_dot_by_epsilon_of_place_5 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_epsilon, sin_gamma_minus_epsilon);
    // beta_rate_dot_by_epsilon = d1_by_epsilon*(rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) -
    //   cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma)))))/(d*cos(beta + theta - gamma)))/d +
    //   sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom)/d1^2 -
    //   rr^2*beta_rate^2*sin(theta)*(cos(theta)*(2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 -
    //   2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma
    //   - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 + rr*(cos(theta)*cos(beta -
    //   gamma)*(2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 -
    //   2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 - m6*(cos(gamma - epsilon)*(sin(gamma - epsilon)
    //   - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon
    //   - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) -
    //   fa*(cos(gamma - epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon -
    //   omega))/zf)))/(d*cos(omega)^2) + sin(theta)*(cos(beta - gamma)*tan(gamma - beta -
    //   theta)*(2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 - 2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/(d*cos(omega)^2) + sin(theta)*(sin(gamma - epsilon
    //   - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + cos(gamma -
    //   epsilon)*(m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) -
    //   fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma
    //   - epsilon - omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss) - I6*((sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2)
    //   - cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*(fa/zf - 1) +
    //   m6*cos(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (cos(gamma - epsilon)*((sin(gamma
    //   - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) +
    //   tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) +
    //   tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) +
    //   sin(omega)*sin(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)) + sin(gamma - epsilon)*((sin(gamma -
    //   epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u -
    //   tan(omega)*(cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + sin(gamma - epsilon - omega)*((I7 +
    //   m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega))))/zf + m6*(sin(gamma - epsilon) - tan(omega)*(cos(gamma -
    //   epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega)))) + sin(omega)*cos(gamma - epsilon -
    //   omega)*(m6*sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 +
    //   ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon - omega)) + m7*(ua^2*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon - omega)) + ub^2*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon - omega))))/(ss*u))/u + m6*((cos(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf -
    //   1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss +
    //   (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)) -
    //   fa*sin(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)/cos(omega) - tan(omega)*(2*cos(gamma - epsilon)*sin(omega)*(1 - fa/zf)
    //   + sin(gamma - epsilon - omega))/cos(omega)))/zf + (sin(omega)*(sin(gamma - epsilon) + 2*cos(gamma -
    //   epsilon)*tan(beta + theta - gamma)) - sin(gamma - epsilon - omega)*tan(gamma - beta - theta) -
    //   cos(gamma - epsilon - omega))/ss)) + sin(gamma - epsilon)*(m6*((cos(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma - epsilon)/cos(omega)) + sin(gamma -
    //   epsilon)*tan(omega)*(cos(gamma - epsilon - omega) - cos(gamma - epsilon)/cos(omega)) - fa*(cos(gamma
    //   - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf -
    //   2)/cos(omega))/zf + sin(gamma - epsilon)*tan(omega)*(cos(gamma - epsilon)*(fa/zf - 2)/cos(omega) +
    //   cos(gamma - epsilon - omega))/zf + (2*sin(gamma - epsilon) + 2*cos(gamma - epsilon)*tan(beta + theta
    //   - gamma) - fa*(sin(gamma - epsilon) + cos(gamma - epsilon)*tan(beta + theta - gamma))/zf -
    //   sin(omega)*cos(gamma - epsilon - omega))/ss))/zf + (sin(gamma - epsilon) + cos(gamma -
    //   epsilon)*tan(beta + theta - gamma) - sin(omega)*cos(gamma - epsilon - omega))/ss) + I6*((sin(gamma -
    //   epsilon) + cos(gamma - epsilon)*tan(beta + theta - gamma))/ss - 2*sin(gamma - epsilon)*cos(gamma -
    //   epsilon)*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega)^2))/cos(beta + theta - gamma))/(d1*cos(beta +
    //   theta - gamma)^2)
    let beta_rate_dot_by_epsilon = beta_rate_dot_by_delta_of_beta_rate_4
        * (rr_cos_angle_inv
            * (sin_theta
                * (cos_omega_inv_sq * sin_theta
                    * (beta_rate_dot_by_gamma_of_place_38
                        - d1_of_place_12
                            * (u_2_inv
                                * (beta_rate_dot_by_gamma_of_place_25
                                    + beta_rate_dot_by_epsilon_of_place_3)
                                + m6
                                    * (zf_inv
                                        * (beta_rate_dot_by_gamma_of_place_29
                                            - sin_gamma_minus_epsilon
                                                * (cos_omega_inv * sin_omega_cos_omega_inv)
                                                    .mul_add(
                                                        beta_rate_dot_by_gamma_of_place_27,
                                                        beta_rate_dot_by_gamma_of_place_28,
                                                    ))
                                        - ss_inv
                                            * (beta_rate_dot_by_epsilon_of_place
                                                + sin_omega
                                                    * (sin_gamma_minus_epsilon
                                                        + beta_rate_dot_by_epsilon_of_place_4))))
                        + sin_gamma_minus_epsilon
                            * (m6
                                * (zf_inv
                                    * (beta_rate_dot_by_gamma_of_place_35
                                        + fa
                                            * (beta_rate_dot_by_gamma_of_place_34
                                                + ss_inv
                                                    * (sin_gamma_minus_epsilon
                                                        .mul_add(S::int(2), -sin_omega_d1_of_place_12)
                                                        + beta_rate_dot_by_epsilon_of_place_4
                                                        - fa_zf_inv * beta_rate_dot_by_epsilon_of_place_5)))
                                    + ss_inv
                                        * (sin_omega_d1_of_place_12
                                            - beta_rate_dot_by_epsilon_of_place_5))
                                + zf_inv_i6_zf_inv
                                    * (-ss_inv)
                                        .mul_add(
                                            beta_rate_dot_by_epsilon_of_place_5,
                                            beta_rate_dot_by_gamma_of_place_36,
                                        )))
                    + beta_rate_dot_by_theta_of_place_28 * beta_rate_dot_by_gamma_of_place_42)
                + beta_rate_dot_by_gamma_of_place_42 * beta_rate_dot_by_delta_of_place_5)
            - beta_rate_dot_by_gamma_of_place_42 * cos_theta)
        - d1_by_epsilon * beta_rate_dot_by_theta_of_beta_rate_4;
    // d1_by_omega = 2*rr^2*sin(theta)^2*(m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(fa/zf - 1)
    //   + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2) +
    //   sin(omega)*(m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*(fa/zf - 1) + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)))/cos(omega))/(cos(beta + theta - gamma)^2*cos(omega))
    let d1_by_omega = cos_omega_inv * d1_by_delta_of_place_2
        * (beta_rate_dot_by_beta_of_place_90
            + cos_omega_inv
                * (sin_omega
                    * d1_of_place_18
                        .mul_add(cos_omega_inv, beta_rate_dot_by_gamma_of_place_26)
                    + beta_rate_dot_by_beta_of_place_62 * beta_rate_dot_by_gamma_of_place_41));
    let cos_omega_d1_of_place_12 = d1_of_place_12 * cos_omega;
    // 1 + sin_omega_cos_omega_inv^2
    let beta_rate_dot_by_omega_of_omega = sin_omega_cos_omega_inv
        .mul_add(sin_omega_cos_omega_inv, S::int(1));
    // beta_rate_dot_by_beta_of_place_94 + cos_omega_d1_of_place_12
    let beta_rate_dot_by_omega_of_place = beta_rate_dot_by_beta_of_place_94
        + cos_omega_d1_of_place_12;
    let beta_rate_dot_by_omega_of_omega_2 = S::int(2) * sin_omega_cos_omega_inv;
    // ss_inv*(sin_omega_d1_of_place_12 - sin(gamma - epsilon - omega)*cos(omega))
    let beta_rate_dot_by_omega_of_place_2 = ss_inv
        * (-beta_rate_dot_by_beta_of_place_31)
            .mul_add(cos_omega, sin_omega_d1_of_place_12);
    // d1_of_zf_fa*beta_rate_dot_by_beta_of_place_100 - cos(gamma - epsilon - omega)
    let beta_rate_dot_by_omega_of_place_3 = d1_of_zf_fa
        .mul_add(beta_rate_dot_by_beta_of_place_100, -d1_of_place_12);
    // d1_by_gamma_of_place_5 + m6*(beta_rate_dot_by_gamma_of_place_41 -
    //   beta_rate_dot_by_beta_of_zf_fa*beta_rate_dot_by_omega_of_place*sin(gamma - epsilon))
    let beta_rate_dot_by_omega_of_place_4 = d1_by_gamma_of_place_5
        + m6
            * (-(beta_rate_dot_by_beta_of_zf_fa * beta_rate_dot_by_omega_of_place))
                .mul_add(sin_gamma_minus_epsilon, beta_rate_dot_by_gamma_of_place_41);
    // cos_omega_inv_sq*(d1_of_place_18*sin_omega_cos_omega_inv + beta_rate_dot_by_omega_of_place_4)
    let beta_rate_dot_by_omega_of_place_5 = cos_omega_inv_sq
        * d1_of_place_18
            .mul_add(sin_omega_cos_omega_inv, beta_rate_dot_by_omega_of_place_4);
    let beta_rate_dot_by_omega_of_place_6 = cos_theta_doubled * beta_rate_dot_by_omega_of_place_5;
    // beta_rate_dot_by_omega = rr^2*beta_rate^2*sin(theta)*(2*cos(theta)*(tan(omega)*(I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2 + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa*(sin(omega)*sin(gamma - epsilon - omega) + cos(omega)*cos(gamma - epsilon - omega))/zf
    //   - sin(omega)*sin(gamma - epsilon - omega) - cos(omega)*cos(gamma - epsilon - omega))))/cos(omega)^2)
    //   - rr*(2*cos(theta)*cos(beta - gamma)*(tan(omega)*(I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(gamma - epsilon
    //   - omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa*(sin(omega)*sin(gamma - epsilon -
    //   omega) + cos(omega)*cos(gamma - epsilon - omega))/zf - sin(omega)*sin(gamma - epsilon - omega) -
    //   cos(omega)*cos(gamma - epsilon - omega))))/cos(omega)^2)/d + sin(theta)*(2*cos(beta -
    //   gamma)*tan(beta + theta - gamma)*(tan(omega)*(I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(gamma - epsilon
    //   - omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa*(sin(omega)*sin(gamma - epsilon -
    //   omega) + cos(omega)*cos(gamma - epsilon - omega))/zf - sin(omega)*sin(gamma - epsilon - omega) -
    //   cos(omega)*cos(gamma - epsilon - omega))))/cos(omega)^2)/d + sin(theta)*(2*tan(omega)*(cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (sin(gamma - epsilon -
    //   omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) - cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*(fa/zf - 1) +
    //   tan(omega)*(sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)) - sin(gamma - epsilon)*((sin(gamma
    //   - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) +
    //   tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) +
    //   tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) + cos(gamma - epsilon - omega)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) + cos(gamma - epsilon - omega)) +
    //   ub^2*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) + cos(gamma - epsilon -
    //   omega))))/(ss*u) + (sin(omega)*sin(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)) + cos(omega)*cos(gamma -
    //   epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*(m6 + (I7 +
    //   m7*(ua^2 + ub^2))/u^2)/cos(omega)) - sin(gamma - epsilon)*((cos(gamma - epsilon - omega)*((I7 +
    //   m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) -
    //   cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + tan(omega)^2*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))) + tan(omega)*(sin(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   2*m6*fa*cos(omega)*cos(gamma - epsilon - omega)))/zf + m6*(2*sin(omega)*cos(gamma - epsilon - omega)
    //   - sin(gamma - epsilon) - tan(omega)^2*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)) + 2*tan(omega)*(sin(omega)*sin(gamma - epsilon - omega) + cos(omega)*cos(gamma - epsilon -
    //   omega)))) + sin(omega)*cos(gamma - epsilon - omega)*(sin(gamma - epsilon - omega)*(m6 + (I7 +
    //   m7*(ua^2 + ub^2))/u^2)/cos(omega) + cos(gamma - epsilon - omega)*tan(omega)*(m6 + (I7 + m7*(ua^2 +
    //   ub^2))/u^2)/cos(omega)))/cos(omega))/u + m6*((sin(gamma - epsilon)*(cos(gamma - epsilon -
    //   omega)/cos(omega) - sin(gamma - epsilon - omega)*tan(omega)/cos(omega) - cos(omega)*(2*fa*tan(gamma
    //   - beta - theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2) - sin(omega)*(2*tan(omega)*(2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega))/cos(omega)^2 + (sin(gamma - epsilon - omega) + 2*sin(gamma -
    //   epsilon)*cos(omega)*(fa/zf - 1))/cos(omega)^2)) - fa*cos(gamma - epsilon)*cos(omega)/ss)/zf +
    //   (cos(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) - sin(gamma -
    //   epsilon - omega)*tan(gamma - beta - theta) - cos(gamma - epsilon - omega))/ss)) + sin(gamma -
    //   epsilon)*(I6*(sin(gamma - epsilon)^2/(zf*cos(omega)) + 2*sin(gamma -
    //   epsilon)^2*tan(omega)^2/(zf*cos(omega)))/zf^2 - m6*((sin(omega)*cos(gamma - epsilon - omega) -
    //   sin(gamma - epsilon - omega)*cos(omega))/ss - (sin(gamma - epsilon)*(sin(gamma - epsilon)/cos(omega)
    //   - sin(gamma - epsilon - omega)) + sin(gamma - epsilon)*tan(omega)^2*(sin(gamma - epsilon)/cos(omega)
    //   - sin(gamma - epsilon - omega)) + fa*(sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + sin(gamma
    //   - epsilon)*(fa/zf - 2)/cos(omega))/zf + sin(gamma - epsilon)*tan(omega)^2*(sin(gamma - epsilon -
    //   omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf + (sin(omega)*cos(gamma - epsilon - omega)
    //   - sin(gamma - epsilon - omega)*cos(omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma -
    //   epsilon)*tan(omega)*(2 - fa/zf)/cos(omega) + cos(gamma - epsilon - omega))/zf) + sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon)*tan(omega)/cos(omega) + cos(gamma - epsilon -
    //   omega)))/zf)))/cos(omega)^2)))/cos(beta + theta - gamma))/(d1*cos(beta + theta - gamma)^2) +
    //   d1_by_omega*(rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom)/d1^2
    let beta_rate_dot_by_omega = beta_rate_dot_by_delta_of_beta_rate_4
        * (beta_rate_dot_by_omega_of_place_6
            + rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (cos_omega_inv_sq
                            * (beta_rate_dot_by_gamma_of_place_37
                                + d1_of_place_12
                                    * (m6
                                        * (ss_inv
                                            * beta_rate_dot_by_theta_of_place_21
                                                .mul_add(cos_omega, beta_rate_dot_by_epsilon_of_place)
                                            + zf_inv
                                                * (sin_gamma_minus_epsilon
                                                    * (beta_rate_dot_by_beta_of_place_63
                                                        + beta_rate_dot_by_theta_of_place_17 * cos_omega
                                                        - sin_omega_cos_omega_inv
                                                            * beta_rate_dot_by_theta_of_place_18
                                                        - sin_omega
                                                            * (cos_omega_inv_sq
                                                                * (beta_rate_dot_by_beta_of_place_67 * cos_omega)
                                                                    .mul_add(S::int(2), beta_rate_dot_by_beta_of_place_31)
                                                                + beta_rate_dot_by_theta_of_place_16
                                                                    * beta_rate_dot_by_omega_of_omega_2))
                                                    - d1_of_place_11 * fa_ss_inv))
                                        - u_2_inv
                                            * (beta_rate_dot_by_epsilon_of_place_3
                                                - sin_omega_cos_omega_inv
                                                    * beta_rate_dot_by_beta_of_place_88
                                                - cos_omega_inv
                                                    * (sin_omega_d1_of_place_12
                                                        * sin_omega_cos_omega_inv
                                                            .mul_add(
                                                                beta_rate_dot_by_beta_of_place_64,
                                                                beta_rate_dot_by_gamma_of_place_24,
                                                            )
                                                        + beta_rate_dot_by_beta_of_place_65
                                                            * beta_rate_dot_by_omega_of_place
                                                        + sin_gamma_minus_epsilon
                                                            * (zf_inv
                                                                * (d1_of_place_17
                                                                    + sin_omega_cos_omega_inv
                                                                        * (m6_fa * cos_omega_d1_of_place_12)
                                                                            .mul_add(S::int(2), -beta_rate_dot_by_gamma_of_place_21)
                                                                    + beta_rate_dot_by_beta_of_place_58
                                                                        * beta_rate_dot_by_omega_of_omega)
                                                                + m6
                                                                    * (-beta_rate_dot_by_omega_of_place)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_omega_of_omega_2,
                                                                            d1_of_place_14 * beta_rate_dot_by_omega_of_omega,
                                                                        )))))
                                + sin_gamma_minus_epsilon
                                    * (m6
                                        * (beta_rate_dot_by_omega_of_place_2
                                            - zf_inv
                                                * (beta_rate_dot_by_beta_of_place_97
                                                    * sin_gamma_minus_epsilon
                                                    + sin_omega_cos_omega_inv
                                                        * beta_rate_dot_by_beta_of_place_98
                                                    + beta_rate_dot_by_beta_of_place_93
                                                        * (d1_of_place_12 + beta_rate_dot_by_beta_of_place_100)
                                                    + fa
                                                        * (beta_rate_dot_by_omega_of_place_2
                                                            + d1_of_place_16 * beta_rate_dot_by_beta_of_place_71
                                                            + beta_rate_dot_by_theta_of_place_24
                                                                * (beta_rate_dot_by_gamma_of_place_33
                                                                    + beta_rate_dot_by_omega_of_place_3))))
                                        - zf_inv_i6_zf_inv
                                            * (beta_rate_dot_by_beta_of_place_100
                                                * beta_rate_dot_by_theta_of_place_24)
                                                .mul_add(
                                                    S::int(2),
                                                    d1_of_place_16 * beta_rate_dot_by_beta_of_place_70,
                                                )))
                            + beta_rate_dot_by_theta_of_place_26
                                * beta_rate_dot_by_omega_of_omega_2)
                        - beta_rate_dot_by_gamma_of_place_44 * beta_rate_dot_by_omega_of_place_5)
                    - d1_of_d_beta_gamma * beta_rate_dot_by_omega_of_place_6))
        - d1_by_omega * beta_rate_dot_by_theta_of_beta_rate_4;
    // beta_rate_dot_by_beta_rate = -2*rr^2*beta_rate*(m2*da*(cos(theta)*sin(beta - gamma) -
    //   sin(theta)*cos(beta - gamma))/d + (sin(theta)*(rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/d^2)/cos(beta + theta - gamma))/(d1*cos(beta + theta - gamma))
    let beta_rate_dot_by_beta_rate = -rr_doubled * beta_rate_dot_by_delta_of_beta_rate_3
        * (d_inv_m2_da * (beta_rate_dot_by_theta_of_place_35 - beta_rate_dot_by_theta_of_place_54)
            + cos_angle_inv
                * (-(d_inv * d1_of_d_beta_gamma))
                    .mul_add(
                        beta_rate_dot_by_theta_of_place_58,
                        beta_rate_dot_by_theta_of_place_36 * sin_theta,
                    ));
    let theta_dot_by_beta_value_of_beta_rate = d_inv * beta_rate_dot_by_theta_of_place_31
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let gamma_dot_by_beta_value_of_beta_rate = ss_inv * sin_angle_cos_angle_inv
        * beta_rate_dot_by_delta_of_beta_rate;
    let gamma_dot_by_theta_value_of_beta_rate = d1_by_theta_of_place
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let delta_dot_by_beta_value_of_beta_rate = cos_phi_inv * beta_rate_dot_by_delta_of_beta_rate;
    let delta_dot_by_gamma_value_of_beta_rate = zt_inv * delta_dot_by_beta_value_of_beta_rate;
    // cos(gamma - delta - phi) - sin(gamma - delta - phi)*sin_phi_cos_phi_inv
    let delta_dot_by_phi_value_of_place = (-d1_of_place_3)
        .mul_add(sin_phi_cos_phi_inv, beta_rate_dot_by_beta_of_place_22);
    let delta_dot_by_beta_rate_value_of_place = cos_phi_inv * d1_by_delta_of_place;
    // e_inv*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))
    let phi_dot_by_beta_value_of_place = e_inv
        * (-e).mul_add(d1_of_place_3, zt * cos_gamma_minus_delta);
    let epsilon_dot_by_beta_value_of_beta_rate = cos_omega_inv
        * beta_rate_dot_by_delta_of_beta_rate;
    let epsilon_dot_by_gamma_value_of_beta_rate = u_2_inv * epsilon_dot_by_beta_value_of_beta_rate;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_omega_cos_omega_inv
    let epsilon_dot_by_omega_value_of_place = d1_of_place_12
        .mul_add(sin_omega_cos_omega_inv, beta_rate_dot_by_beta_of_place_31);
    let epsilon_dot_by_beta_rate_value_of_place = cos_omega_inv * d1_by_delta_of_place;
    // zf_inv*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon - omega))
    let omega_dot_by_beta_value_of_place = zf_inv
        * (-zf).mul_add(d1_of_place_12, u_2 * sin_gamma_minus_epsilon);
    // Entries that are not zero.
    // d(beta')/d(beta_rate) = 1
    let beta_dot_by_beta_rate_value = S::int(1);
    // d(theta')/d(beta) = -rr*beta_rate*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
    //   theta))/(d*cos(beta + theta - gamma))
    let theta_dot_by_beta_value = -theta_dot_by_beta_value_of_beta_rate;
    // d(theta')/d(theta) = rr*beta_rate*cos(beta - gamma)*tan(beta + theta - gamma)/(d*cos(beta + theta -
    //   gamma))
    let theta_dot_by_theta_value = beta_rate_dot_by_theta_of_place_28
        * beta_rate_dot_by_delta_of_beta_rate_2;
    // d(theta')/d(gamma) = rr*beta_rate*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
    //   theta))/(d*cos(beta + theta - gamma))
    let theta_dot_by_gamma_value = theta_dot_by_beta_value_of_beta_rate;
    // d(theta')/d(beta_rate) = rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1
    let theta_dot_by_beta_rate_value = d1_of_d_beta_gamma
        .mul_add(rr_cos_angle_inv, -S::int(1));
    // d(gamma')/d(beta) = rr*beta_rate*sin(theta)*tan(beta + theta - gamma)/(ss*cos(beta + theta - gamma))
    let gamma_dot_by_beta_value = gamma_dot_by_beta_value_of_beta_rate;
    // d(gamma')/d(theta) = rr*beta_rate*(cos(theta) + sin(theta)*tan(beta + theta - gamma))/(ss*cos(beta +
    //   theta - gamma))
    let gamma_dot_by_theta_value = ss_inv * gamma_dot_by_theta_value_of_beta_rate;
    // d(gamma')/d(gamma) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)/(ss*cos(beta + theta -
    //   gamma))
    let gamma_dot_by_gamma_value = -gamma_dot_by_beta_value_of_beta_rate;
    // d(gamma')/d(beta_rate) = rr*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_by_beta_rate_value = ss_inv * d1_by_delta_of_place;
    // d(delta')/d(beta) = rr*beta_rate*sin(theta)*sin(gamma - delta - phi)*tan(beta + theta -
    //   gamma)/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_by_beta_value = d1_of_place_3_zt_inv * sin_angle_cos_angle_inv
        * delta_dot_by_beta_value_of_beta_rate;
    // d(delta')/d(theta) = rr*beta_rate*sin(gamma - delta - phi)*(cos(theta) + sin(theta)*tan(beta + theta
    //   - gamma))/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_by_theta_value = d1_of_place_3_zt_inv * cos_phi_inv
        * gamma_dot_by_theta_value_of_beta_rate;
    // d(delta')/d(gamma) = rr*beta_rate*sin(theta)*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi))/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_by_gamma_value = beta_rate_dot_by_theta_of_place_2
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(delta) = -rr*beta_rate*sin(theta)*cos(gamma - delta - phi)/(zt*cos(beta + theta -
    //   gamma)*cos(phi))
    let delta_dot_by_delta_value = -beta_rate_dot_by_beta_of_place_22
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(phi) = rr*beta_rate*sin(theta)*(sin(gamma - delta - phi)*tan(phi) - cos(gamma - delta -
    //   phi))/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_by_phi_value = -delta_dot_by_gamma_value_of_beta_rate
        * delta_dot_by_phi_value_of_place;
    // d(delta')/d(beta_rate) = rr*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta -
    //   gamma)*cos(phi))
    let delta_dot_by_beta_rate_value = d1_of_place_3_zt_inv * delta_dot_by_beta_rate_value_of_place;
    // d(phi')/d(beta) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(e*sin(gamma - delta - phi) -
    //   zt*cos(gamma - delta))/(e*zt*cos(beta + theta - gamma)*cos(phi))
    let phi_dot_by_beta_value = sin_angle_cos_angle_inv
        * delta_dot_by_gamma_value_of_beta_rate * phi_dot_by_beta_value_of_place;
    // d(phi')/d(theta) = rr*beta_rate*(cos(gamma - delta)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/e - sin(gamma - delta - phi)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/zt)/(cos(beta + theta - gamma)*cos(phi))
    let phi_dot_by_theta_value = cos_phi_inv * beta_rate_dot_by_beta_of_place_54
        * d1_by_theta_of_place * beta_rate_dot_by_delta_of_beta_rate_2;
    // d(phi')/d(gamma) = -rr*beta_rate*sin(theta)*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/e + (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta -
    //   phi))/zt)/(cos(beta + theta - gamma)*cos(phi))
    let phi_dot_by_gamma_value = -delta_dot_by_beta_value_of_beta_rate
        * e_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_12,
                zt_inv * beta_rate_dot_by_theta_of_place_2,
            );
    // d(phi')/d(delta) = rr*beta_rate*sin(theta)*(zt*sin(gamma - delta) + e*cos(gamma - delta -
    //   phi))/(e*zt*cos(beta + theta - gamma)*cos(phi))
    let phi_dot_by_delta_value = e_inv * delta_dot_by_gamma_value_of_beta_rate
        * e.mul_add(beta_rate_dot_by_beta_of_place_22, zt * sin_gamma_minus_delta);
    // d(phi')/d(phi) = rr*beta_rate*sin(theta)*(cos(gamma - delta)*tan(phi)/e + (cos(gamma - delta - phi)
    //   - sin(gamma - delta - phi)*tan(phi))/zt)/(cos(beta + theta - gamma)*cos(phi))
    let phi_dot_by_phi_value = delta_dot_by_beta_value_of_beta_rate
        * zt_inv
            .mul_add(
                delta_dot_by_phi_value_of_place,
                d1_of_place_7 * sin_phi_cos_phi_inv,
            );
    // d(phi')/d(beta_rate) = rr*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta -
    //   phi))/(e*zt*cos(beta + theta - gamma)*cos(phi))
    let phi_dot_by_beta_rate_value = zt_inv * delta_dot_by_beta_rate_value_of_place
        * phi_dot_by_beta_value_of_place;
    // d(epsilon')/d(beta) = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_beta_value = d1_of_place_12_u_2_inv * sin_angle_cos_angle_inv
        * epsilon_dot_by_beta_value_of_beta_rate;
    // d(epsilon')/d(theta) = rr*beta_rate*cos(gamma - epsilon - omega)*(cos(theta) + sin(theta)*tan(beta +
    //   theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_theta_value = d1_of_place_12_u_2_inv * cos_omega_inv
        * gamma_dot_by_theta_value_of_beta_rate;
    // d(epsilon')/d(gamma) = -rr*beta_rate*sin(theta)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon
    //   - omega)*tan(beta + theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_gamma_value = -beta_rate_dot_by_theta_of_place_15
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(epsilon) = rr*beta_rate*sin(theta)*sin(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_by_epsilon_value = beta_rate_dot_by_beta_of_place_31
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(omega) = rr*beta_rate*sin(theta)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(omega))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_omega_value = epsilon_dot_by_gamma_value_of_beta_rate
        * epsilon_dot_by_omega_value_of_place;
    // d(epsilon')/d(beta_rate) = rr*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_by_beta_rate_value = d1_of_place_12_u_2_inv
        * epsilon_dot_by_beta_rate_value_of_place;
    // d(omega')/d(beta) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(zf*cos(gamma - epsilon -
    //   omega) - u*sin(gamma - epsilon))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_beta_value = sin_angle_cos_angle_inv
        * epsilon_dot_by_gamma_value_of_beta_rate * omega_dot_by_beta_value_of_place;
    // d(omega')/d(theta) = rr*beta_rate*(sin(gamma - epsilon)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/zf - cos(gamma - epsilon - omega)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/u)/(cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_theta_value = cos_omega_inv * beta_rate_dot_by_beta_of_place_73
        * d1_by_theta_of_place * beta_rate_dot_by_delta_of_beta_rate_2;
    // d(omega')/d(gamma) = rr*beta_rate*sin(theta)*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/zf + (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta +
    //   theta - gamma))/u)/(cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_gamma_value = epsilon_dot_by_beta_value_of_beta_rate
        * zf_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_23,
                u_2_inv * beta_rate_dot_by_theta_of_place_15,
            );
    // d(omega')/d(epsilon) = -rr*beta_rate*sin(theta)*(u*cos(gamma - epsilon) + zf*sin(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_epsilon_value = -zf_inv * epsilon_dot_by_gamma_value_of_beta_rate
        * zf.mul_add(beta_rate_dot_by_beta_of_place_31, u_2 * cos_gamma_minus_epsilon);
    // d(omega')/d(omega) = rr*beta_rate*sin(theta)*(sin(gamma - epsilon)*tan(omega)/zf - (sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/u)/(cos(beta + theta -
    //   gamma)*cos(omega))
    let omega_dot_by_omega_value = epsilon_dot_by_beta_value_of_beta_rate
        * (-u_2_inv)
            .mul_add(
                epsilon_dot_by_omega_value_of_place, beta_rate_dot_by_theta_of_place_24,
            );
    // d(omega')/d(beta_rate) = rr*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_beta_rate_value = u_2_inv * epsilon_dot_by_beta_rate_value_of_place
        * omega_dot_by_beta_value_of_place;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, zero, zero, beta_dot_by_beta_rate_value],
        [
            theta_dot_by_beta_value, theta_dot_by_theta_value, theta_dot_by_gamma_value, zero, zero,
            zero, zero, theta_dot_by_beta_rate_value,
        ],
        [
            gamma_dot_by_beta_value, gamma_dot_by_theta_value, gamma_dot_by_gamma_value, zero, zero,
            zero, zero, gamma_dot_by_beta_rate_value,
        ],
        [
            delta_dot_by_beta_value, delta_dot_by_theta_value, delta_dot_by_gamma_value,
            delta_dot_by_delta_value, delta_dot_by_phi_value, zero, zero,
            delta_dot_by_beta_rate_value,
        ],
        [
            phi_dot_by_beta_value, phi_dot_by_theta_value, phi_dot_by_gamma_value,
            phi_dot_by_delta_value, phi_dot_by_phi_value, zero, zero, phi_dot_by_beta_rate_value,
        ],
        [
            epsilon_dot_by_beta_value, epsilon_dot_by_theta_value, epsilon_dot_by_gamma_value, zero,
            zero, epsilon_dot_by_epsilon_value, epsilon_dot_by_omega_value,
            epsilon_dot_by_beta_rate_value,
        ],
        [
            omega_dot_by_beta_value, omega_dot_by_theta_value, omega_dot_by_gamma_value, zero, zero,
            omega_dot_by_epsilon_value, omega_dot_by_omega_value, omega_dot_by_beta_rate_value,
        ],
        [
            beta_rate_dot_by_beta, beta_rate_dot_by_theta, beta_rate_dot_by_gamma,
            beta_rate_dot_by_delta, beta_rate_dot_by_phi, beta_rate_dot_by_epsilon,
            beta_rate_dot_by_omega, beta_rate_dot_by_beta_rate,
        ],
    ]
}

/// Matrix of the linear system M(q) u' = f(q, u) row by row, and its right-hand side, which share terms.
///
/// 440 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // beta + theta - gamma
    let m11_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = m11_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let m11_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let m11_of_place_2 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let sin_phi_doubled = S::int(2) * sin_phi;
    let m11_of_place_3 = m11_of_place_2 * sin_phi_doubled;
    // cos(gamma - delta) + m11_of_place_3
    let m11_of_place_4 = cos_gamma_minus_delta + m11_of_place_3;
    let m11_of_place_2_sq = m11_of_place_2 * m11_of_place_2;
    let m11_of_place_5 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let m11_of_place_6 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_m11_of_place_6 = zt_inv * m11_of_place_6;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let m11_of_zf_fa = fa_zf_inv - S::int(2);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let m11_of_place_7 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let m11_of_place_8 = m11_of_place_7 * sin_omega_doubled;
    // sin(gamma - epsilon) - m11_of_place_8
    let m11_of_place_9 = sin_gamma_minus_epsilon - m11_of_place_8;
    let m11_of_place_7_sq = m11_of_place_7 * m11_of_place_7;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let m11_of_place_10 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_m11_of_place_10 = u_2_inv * m11_of_place_10;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // cos_phi_inv_sq*(m4*(cos(gamma - delta)*(ea_e_inv*(m11_of_e_ea*cos(gamma - delta) - m11_of_place_3) +
    //   m11_of_place_4) + m11_of_place_2_sq) + I4*m11_of_place_5^2 +
    //   m11_of_place_2_sq*zt_inv_m11_of_place_6) + cos_omega_inv_sq*(m6*(sin(gamma -
    //   epsilon)*(fa_zf_inv*(m11_of_zf_fa*sin(gamma - epsilon) + m11_of_place_8) + m11_of_place_9) +
    //   m11_of_place_7_sq) + m11_of_place_7_sq*u_2_inv_m11_of_place_10 + zf_inv_i6_zf_inv*sin(gamma -
    //   epsilon)^2)
    let m11_of_place_11 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (ea_e_inv * m11_of_e_ea.mul_add(cos_gamma_minus_delta, -m11_of_place_3)
                    + m11_of_place_4) + m11_of_place_2_sq) + I4 * m11_of_place_5 * m11_of_place_5
            + m11_of_place_2_sq * zt_inv_m11_of_place_6)
        + cos_omega_inv_sq
            * (m6
                * (sin_gamma_minus_epsilon
                    * (fa_zf_inv * m11_of_zf_fa.mul_add(sin_gamma_minus_epsilon, m11_of_place_8)
                        + m11_of_place_9) + m11_of_place_7_sq)
                + m11_of_place_7_sq * u_2_inv_m11_of_place_10
                + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let m11_of_place_12 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_m11_of_place_12 = ss_inv * m11_of_place_12;
    // m11_of_place_11 + ss_inv_m11_of_place_12
    let m11_of_place_13 = m11_of_place_11 + ss_inv_m11_of_place_12;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let m11_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let m11_of_place_14 = m2_da * m11_of_d_beta_gamma;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let f1_of_place = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let f1_of_place_2 = (-yb_minus_yc).mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + m11_of_e_ea*m4_ea
    let f1_of_m4_i4_e_ea = m11_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let f1_of_place_3 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + f1_of_place_3
    let f1_of_place_4 = cos_gamma_minus_delta.mul_add(cos_phi, f1_of_place_3);
    // ea_e_inv - 1
    let f1_of_e_ea = ea_e_inv - S::int(1);
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let f1_of_place_5 = m11_of_place_2.mul_add(sin_angle_cos_angle_inv, -f1_of_place_4);
    // -f1_of_place_5
    let minus_f1_of_place_5 = -f1_of_place_5;
    let f1_of_place_6 = f1_of_e_ea * cos_gamma_minus_delta;
    let f1_of_place_7 = S::int(2) * sin_angle_cos_angle_inv;
    let ea_ss_inv = ea * ss_inv;
    let f1_of_place_8 = f1_of_place_7 * cos_gamma_minus_delta;
    let f1_of_place_9 = cos_phi_inv * cos_gamma_minus_delta;
    let sin_phi_f1_of_place_4 = f1_of_place_4 * sin_phi;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let f1_of_place_10 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let m6_fa = m6 * fa;
    // i6_zf_inv + m11_of_zf_fa*m6_fa
    let f1_of_m6_i6_zf_fa = m11_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let f1_of_place_11 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - f1_of_place_11
    let f1_of_place_12 = sin_gamma_minus_epsilon.mul_add(cos_omega, -f1_of_place_11);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let f1_of_zf_fa = fa_zf_inv - S::int(1);
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let f1_of_place_13 = m11_of_place_7.mul_add(sin_angle_cos_angle_inv, f1_of_place_12);
    let f1_of_place_14 = f1_of_zf_fa * sin_gamma_minus_epsilon;
    let fa_ss_inv = fa * ss_inv;
    let f1_of_place_15 = f1_of_place_7 * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let f1_of_place_16 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let sin_omega_f1_of_place_12 = f1_of_place_12 * sin_omega;
    let f1_of_place_17 = cos_omega_inv * sin_gamma_minus_epsilon;
    let sin_omega_f1_of_place_17 = f1_of_place_17 * sin_omega;
    let f1_of_place_18 = zf_inv * sin_omega_f1_of_place_17;
    let f1_of_place_19 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let f1_of_place_20 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - m11_of_d_beta_gamma*f1_of_place_19*rr_cos_angle_inv
    let f1_of_place_21 = (-(m11_of_d_beta_gamma * f1_of_place_19))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let f1_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let f1_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let f1_of_place_22 = (xc_sq + f1_of_xb_xc + yc_sq + f1_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // Values.
    // M11 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let m11 = I1 + m1 * ra * ra
        + rr * rr
            * (m2
                + cos_angle_inv
                    * (cos_angle_inv
                        * (m11_of_place_13 * sin_theta * sin_theta
                            + i2_plus_da_m2_da * m11_of_d_beta_gamma * m11_of_d_beta_gamma)
                        - S::int(2) * m11_of_place_14 * cos_theta));
    // f1 = mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta
    //   - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma)
    let f1 = mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * f1_of_place_22 * (l0 - f1_of_place_22)
                    * (-sd).mul_add(f1_of_place_2, sc * f1_of_place)
                    / (xc_sq + f1_of_xb_xc + yc_sq + f1_of_yb_yc
                        + sd * f1_of_place.mul_add(S::int(2), sd)
                        + sc * f1_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (m11_of_place_14
                            + cos_angle_inv
                                * (-rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_phi_inv_sq
                                                    * (m11_of_place_2
                                                        * (zt_inv
                                                            * (cos_phi_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (e_inv
                                                                        * (f1_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                            - f1_of_place_4 * m11_of_place_6
                                                                            + sin_phi_cos_phi_inv
                                                                                * (m11_of_place_2
                                                                                    * sin_phi_doubled.mul_add(m4_ea, m11_of_place_6)
                                                                                    - f1_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                        + m4
                                                                            * (-m11_of_place_4)
                                                                                .mul_add(sin_phi_cos_phi_inv, sin_gamma_minus_delta))
                                                                    - m11_of_place_2 * sin_phi
                                                                        * (m11_of_place_2 * cos_phi_inv
                                                                            * (m4 + zt_inv_m11_of_place_6)
                                                                            + m4 * f1_of_e_ea * sin_gamma_minus_delta))
                                                                + zt_inv * ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(minus_f1_of_place_5, I5 * minus_f1_of_place_5)
                                                                + m4 * m11_of_place_2 * f1_of_place_6)
                                                            - m4
                                                                * (e_inv
                                                                    * (cos_gamma_minus_delta
                                                                        * (f1_of_place_6 + f1_of_place_4 * cos_phi_inv
                                                                            - sin_phi
                                                                                * (cos_phi_inv_sq
                                                                                    * (-sin_phi_doubled).mul_add(f1_of_place_6, m11_of_place_2)
                                                                                    + f1_of_place_7 * ea_ss_inv)) - f1_of_place_3 * ea_ss_inv)
                                                                    + ss_inv
                                                                        * (f1_of_place_5
                                                                            + sin_phi * (sin_gamma_minus_delta + f1_of_place_8))))
                                                        + cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        f1_of_place_10,
                                                                        m11_of_place_5 * sin_phi_cos_phi_inv * f1_of_place_9,
                                                                    )
                                                                + m4
                                                                    * (e_inv
                                                                        * (sin_phi_cos_phi_inv * cos_gamma_minus_delta
                                                                            * (f1_of_place_9 - f1_of_place_4)
                                                                            + ea
                                                                                * (e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * (sin_phi_cos_phi_inv
                                                                                            * m11_of_e_ea.mul_add(f1_of_place_9, f1_of_place_4)
                                                                                            - sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                        - ea_ss_inv * sin_gamma_minus_delta)
                                                                                    + ss_inv
                                                                                        * (sin_gamma_minus_delta.mul_add(S::int(2), f1_of_place_8)
                                                                                            - sin_phi_f1_of_place_4)))
                                                                        + ss_inv * (sin_phi_f1_of_place_4 - f1_of_place_10))))
                                                    - ss_inv * ss_inv_m11_of_place_12 * sin_angle_cos_angle_inv
                                                    - cos_omega_inv_sq
                                                        * (m11_of_place_7
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (f1_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - f1_of_place_12 * m11_of_place_10
                                                                                + sin_omega_cos_omega_inv
                                                                                    * (m11_of_place_7
                                                                                        * sin_omega_doubled.mul_add(m6_fa, -m11_of_place_10)
                                                                                        + f1_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                            + m6
                                                                                * m11_of_place_9
                                                                                    .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                        + m11_of_place_7 * sin_omega
                                                                            * (m11_of_place_7 * cos_omega_inv
                                                                                * (m6 + u_2_inv_m11_of_place_10)
                                                                                + m6 * f1_of_zf_fa * cos_gamma_minus_epsilon))
                                                                    + u_2_inv * ss_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(f1_of_place_13, I7 * f1_of_place_13)
                                                                    + m6 * m11_of_place_7 * f1_of_place_14)
                                                                + m6
                                                                    * (ss_inv
                                                                        * (f1_of_place_13
                                                                            + sin_omega * (cos_gamma_minus_epsilon - f1_of_place_15))
                                                                        - zf_inv
                                                                            * (sin_gamma_minus_epsilon
                                                                                * (f1_of_place_14 + f1_of_place_12 * cos_omega_inv
                                                                                    + sin_omega
                                                                                        * (cos_omega_inv_sq
                                                                                            * sin_omega_doubled.mul_add(f1_of_place_14, m11_of_place_7)
                                                                                            - f1_of_place_7 * fa_ss_inv))
                                                                                + f1_of_place_11 * fa_ss_inv)))
                                                            + sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (zf_inv
                                                                        * (sin_omega_f1_of_place_17
                                                                            * (f1_of_place_12 - f1_of_place_17)
                                                                            + fa
                                                                                * (ss_inv
                                                                                    * (cos_gamma_minus_epsilon
                                                                                        .mul_add(S::int(2), -f1_of_place_15)
                                                                                        - fa_zf_inv * f1_of_place_16 + sin_omega_f1_of_place_12)
                                                                                    - f1_of_place_18
                                                                                        * m11_of_zf_fa.mul_add(f1_of_place_17, f1_of_place_12)))
                                                                        - ss_inv * (f1_of_place_16 + sin_omega_f1_of_place_12))
                                                                    - zf_inv_i6_zf_inv
                                                                        * f1_of_place_17
                                                                            .mul_add(f1_of_place_18, ss_inv * f1_of_place_16))))
                                                + m11_of_place_13 * m11_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            + m11_of_d_beta_gamma
                                                * (cos_theta
                                                    * (m11_of_place_11
                                                        + ss_inv * m2_da.mul_add(sin_angle, m11_of_place_12))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - f1_of_place_19)))
                                        + m2_da * d_inv
                                            * (-ss_inv)
                                                .mul_add(
                                                    f1_of_place_20,
                                                    m11_of_d_beta_gamma * cos_beta_minus_gamma,
                                                )) + m11_of_place_13 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * m11_of_d_beta_gamma
                        * (m2_da * da.mul_add(f1_of_place_21, rr * f1_of_place_19 * cos_theta)
                            + I2 * f1_of_place_21) - m2_da * f1_of_place_20));
    ([m11], [f1])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 29 operations, 4 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 7], _u: &[S; 1]) -> [S; 4] {
    let Parameters { xb, yb, xc, yc, sc, sd, .. } = *p;
    let [beta, theta, gamma, _, phi, _, omega] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (_, cos_omega) = omega.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Shared terms.
    // xb - xc
    let xb_minus_xc = xb - xc;
    let xb_minus_xc_doubled = S::int(2) * xb_minus_xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    let yb_minus_yc_doubled = S::int(2) * yb_minus_yc;
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    // Values.
    // divisor1 = cos(beta + theta - gamma)
    let divisor1 = cos_angle;
    // divisor2 = cos(phi)
    let divisor2 = cos_phi;
    // divisor3 = cos(omega)
    let divisor3 = cos_omega;
    // divisor4 = xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))
    let divisor4 = xb * (-xc).mul_add(S::int(2), xb) + xc * xc + yc * yc
        + yb * (-yc).mul_add(S::int(2), yb)
        + sc
            * (xb_minus_xc_doubled.mul_add(sin_gamma, sc) - yb_minus_yc_doubled * cos_gamma)
        + sd
            * (xb_minus_xc_doubled.mul_add(cos_gamma, sd) + yb_minus_yc_doubled * sin_gamma);
    [divisor1, divisor2, divisor3, divisor4]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 33 operations, 7 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 7], _u: &[S; 1]) -> [S; 6] {
    let Parameters { xa, ya, xb, yb, d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    // Sines and cosines.
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    // beta + theta
    let beta_plus_theta = beta + theta;
    let (sin_beta_plus_theta, cos_beta_plus_theta) = beta_plus_theta.sin_cos();
    // rr*cos(beta) - d*cos(beta + theta)
    let residual1_of_place = (-d).mul_add(cos_beta_plus_theta, rr * cos_beta);
    // rr*sin(beta) - d*sin(beta + theta)
    let residual2_of_place = (-d).mul_add(sin_beta_plus_theta, rr * sin_beta);
    // xa - residual1_of_place
    let residual3_of_place = xa - residual1_of_place;
    // ya - residual2_of_place
    let residual4_of_place = ya - residual2_of_place;
    // delta + phi
    let delta_plus_phi = delta + phi;
    let (sin_delta_plus_phi, cos_delta_plus_phi) = delta_plus_phi.sin_cos();
    // epsilon + omega
    let epsilon_plus_omega = epsilon + omega;
    let (sin_epsilon_plus_omega, cos_epsilon_plus_omega) = epsilon_plus_omega.sin_cos();
    // Values.
    // E3_1 = xb - rr*cos(beta) + d*cos(beta + theta) + ss*sin(gamma)
    let residual1 = ss.mul_add(sin_gamma, xb) - residual1_of_place;
    // E3_2 = yb - rr*sin(beta) + d*sin(beta + theta) - ss*cos(gamma)
    let residual2 = (-ss).mul_add(cos_gamma, yb) - residual2_of_place;
    // E4_1 = xa - rr*cos(beta) + d*cos(beta + theta) + zt*cos(delta) + e*sin(delta + phi)
    let residual3 = e.mul_add(sin_delta_plus_phi, zt * cos_delta) + residual3_of_place;
    // E4_2 = ya - rr*sin(beta) + d*sin(beta + theta) + zt*sin(delta) - e*cos(delta + phi)
    let residual4 = (-e).mul_add(cos_delta_plus_phi, zt * sin_delta) + residual4_of_place;
    // E6_1 = xa - rr*cos(beta) + d*cos(beta + theta) + u*sin(epsilon) + zf*cos(epsilon + omega)
    let residual5 = zf.mul_add(cos_epsilon_plus_omega, u_2 * sin_epsilon) + residual3_of_place;
    // E6_2 = ya - rr*sin(beta) + d*sin(beta + theta) - u*cos(epsilon) + zf*sin(epsilon + omega)
    let residual6 = (-u_2).mul_add(cos_epsilon, zf * sin_epsilon_plus_omega) + residual4_of_place;
    [residual1, residual2, residual3, residual4, residual5, residual6]
}

/// Slopes of the constraints, one after the other, along beta, theta, gamma, delta, phi, epsilon, omega, beta_rate.
///
/// 25 operations, 7 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    _u: &[S; 1],
) -> [S; 48] {
    let Parameters { d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    // Sines and cosines.
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    // beta + theta
    let beta_plus_theta = beta + theta;
    let (sin_beta_plus_theta, cos_beta_plus_theta) = beta_plus_theta.sin_cos();
    let d_cos_beta_plus_theta = d * cos_beta_plus_theta;
    let d_sin_beta_plus_theta = d * sin_beta_plus_theta;
    // delta + phi
    let delta_plus_phi = delta + phi;
    let (sin_delta_plus_phi, cos_delta_plus_phi) = delta_plus_phi.sin_cos();
    let e_sin_delta_plus_phi = e * sin_delta_plus_phi;
    let e_cos_delta_plus_phi = e * cos_delta_plus_phi;
    // epsilon + omega
    let epsilon_plus_omega = epsilon + omega;
    let (sin_epsilon_plus_omega, cos_epsilon_plus_omega) = epsilon_plus_omega.sin_cos();
    let residual6_by_epsilon_of_place = zf * cos_epsilon_plus_omega;
    let residual5_by_epsilon_of_place = zf * sin_epsilon_plus_omega;
    // -d*sin(beta + theta)
    let residual1_by_theta_of_d_beta_theta = -d_sin_beta_plus_theta;
    // rr*sin(beta) - d*sin(beta + theta)
    let residual1_by_beta_of_place = rr.mul_add(sin_beta, -d_sin_beta_plus_theta);
    // d*cos(beta + theta) - rr*cos(beta)
    let residual2_by_beta_of_place = (-rr).mul_add(cos_beta, d_cos_beta_plus_theta);
    // Values.
    // d(E3_1)/d(beta) = rr*sin(beta) - d*sin(beta + theta)
    let residual1_by_beta = residual1_by_beta_of_place;
    // d(E3_1)/d(theta) = -d*sin(beta + theta)
    let residual1_by_theta = residual1_by_theta_of_d_beta_theta;
    // d(E3_1)/d(gamma) = ss*cos(gamma)
    let residual1_by_gamma = ss * cos_gamma;
    // d(E3_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual2_by_beta = residual2_by_beta_of_place;
    // d(E3_2)/d(theta) = d*cos(beta + theta)
    let residual2_by_theta = d_cos_beta_plus_theta;
    // d(E3_2)/d(gamma) = ss*sin(gamma)
    let residual2_by_gamma = ss * sin_gamma;
    // d(E4_1)/d(beta) = rr*sin(beta) - d*sin(beta + theta)
    let residual3_by_beta = residual1_by_beta_of_place;
    // d(E4_1)/d(theta) = -d*sin(beta + theta)
    let residual3_by_theta = residual1_by_theta_of_d_beta_theta;
    // d(E4_1)/d(delta) = e*cos(delta + phi) - zt*sin(delta)
    let residual3_by_delta = (-zt).mul_add(sin_delta, e_cos_delta_plus_phi);
    // d(E4_1)/d(phi) = e*cos(delta + phi)
    let residual3_by_phi = e_cos_delta_plus_phi;
    // d(E4_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual4_by_beta = residual2_by_beta_of_place;
    // d(E4_2)/d(theta) = d*cos(beta + theta)
    let residual4_by_theta = d_cos_beta_plus_theta;
    // d(E4_2)/d(delta) = zt*cos(delta) + e*sin(delta + phi)
    let residual4_by_delta = zt.mul_add(cos_delta, e_sin_delta_plus_phi);
    // d(E4_2)/d(phi) = e*sin(delta + phi)
    let residual4_by_phi = e_sin_delta_plus_phi;
    // d(E6_1)/d(beta) = rr*sin(beta) - d*sin(beta + theta)
    let residual5_by_beta = residual1_by_beta_of_place;
    // d(E6_1)/d(theta) = -d*sin(beta + theta)
    let residual5_by_theta = residual1_by_theta_of_d_beta_theta;
    // d(E6_1)/d(epsilon) = u*cos(epsilon) - zf*sin(epsilon + omega)
    let residual5_by_epsilon = u_2.mul_add(cos_epsilon, -residual5_by_epsilon_of_place);
    // d(E6_1)/d(omega) = -zf*sin(epsilon + omega)
    let residual5_by_omega = -residual5_by_epsilon_of_place;
    // d(E6_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual6_by_beta = residual2_by_beta_of_place;
    // d(E6_2)/d(theta) = d*cos(beta + theta)
    let residual6_by_theta = d_cos_beta_plus_theta;
    // d(E6_2)/d(epsilon) = u*sin(epsilon) + zf*cos(epsilon + omega)
    let residual6_by_epsilon = u_2.mul_add(sin_epsilon, residual6_by_epsilon_of_place);
    // d(E6_2)/d(omega) = zf*cos(epsilon + omega)
    let residual6_by_omega = residual6_by_epsilon_of_place;
    let zero = S::int(0);
    [
        residual1_by_beta, residual1_by_theta, residual1_by_gamma, zero, zero, zero, zero, zero,
        residual2_by_beta, residual2_by_theta, residual2_by_gamma, zero, zero, zero, zero, zero,
        residual3_by_beta, residual3_by_theta, zero, residual3_by_delta, residual3_by_phi, zero,
        zero, zero, residual4_by_beta, residual4_by_theta, zero, residual4_by_delta,
        residual4_by_phi, zero, zero, zero, residual5_by_beta, residual5_by_theta, zero, zero, zero,
        residual5_by_epsilon, residual5_by_omega, zero, residual6_by_beta, residual6_by_theta, zero,
        zero, zero, residual6_by_epsilon, residual6_by_omega, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (beta_rate) that must act beside the loads of the model for the accelerations to be (beta_rate').
///
/// 442 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    let [beta_rate_dot] = *v_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // beta + theta - gamma
    let tau1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = tau1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let tau1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let tau1_of_place_2 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let sin_phi_doubled = S::int(2) * sin_phi;
    let tau1_of_place_3 = tau1_of_place_2 * sin_phi_doubled;
    // cos(gamma - delta) + tau1_of_place_3
    let tau1_of_place_4 = cos_gamma_minus_delta + tau1_of_place_3;
    let tau1_of_place_2_sq = tau1_of_place_2 * tau1_of_place_2;
    let i4_e_inv = I4 * e_inv;
    let tau1_of_place_5 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let tau1_of_place_6 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_tau1_of_place_6 = zt_inv * tau1_of_place_6;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let tau1_of_zf_fa = fa_zf_inv - S::int(2);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let tau1_of_place_7 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let tau1_of_place_8 = tau1_of_place_7 * sin_omega_doubled;
    // sin(gamma - epsilon) - tau1_of_place_8
    let tau1_of_place_9 = sin_gamma_minus_epsilon - tau1_of_place_8;
    let tau1_of_place_7_sq = tau1_of_place_7 * tau1_of_place_7;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let tau1_of_place_10 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_tau1_of_place_10 = u_2_inv * tau1_of_place_10;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // cos_phi_inv_sq*(m4*(cos(gamma - delta)*(ea_e_inv*(tau1_of_e_ea*cos(gamma - delta) - tau1_of_place_3)
    //   + tau1_of_place_4) + tau1_of_place_2_sq) + i4_e_inv*tau1_of_place_5*cos(gamma - delta) +
    //   tau1_of_place_2_sq*zt_inv_tau1_of_place_6) + cos_omega_inv_sq*(m6*(sin(gamma -
    //   epsilon)*(fa_zf_inv*(tau1_of_zf_fa*sin(gamma - epsilon) + tau1_of_place_8) + tau1_of_place_9) +
    //   tau1_of_place_7_sq) + tau1_of_place_7_sq*u_2_inv_tau1_of_place_10 + zf_inv_i6_zf_inv*sin(gamma -
    //   epsilon)^2)
    let tau1_of_place_11 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (ea_e_inv * tau1_of_e_ea.mul_add(cos_gamma_minus_delta, -tau1_of_place_3)
                    + tau1_of_place_4) + tau1_of_place_2_sq)
            + i4_e_inv * tau1_of_place_5 * cos_gamma_minus_delta
            + tau1_of_place_2_sq * zt_inv_tau1_of_place_6)
        + cos_omega_inv_sq
            * (m6
                * (sin_gamma_minus_epsilon
                    * (fa_zf_inv * tau1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, tau1_of_place_8)
                        + tau1_of_place_9) + tau1_of_place_7_sq)
                + tau1_of_place_7_sq * u_2_inv_tau1_of_place_10
                + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let tau1_of_place_12 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_tau1_of_place_12 = ss_inv * tau1_of_place_12;
    // tau1_of_place_11 + ss_inv_tau1_of_place_12
    let tau1_of_place_13 = tau1_of_place_11 + ss_inv_tau1_of_place_12;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let tau1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let tau1_of_place_14 = m2_da * tau1_of_d_beta_gamma;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let tau1_of_place_15 = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let tau1_of_place_16 = (-yb_minus_yc).mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let m4_ea = m4 * ea;
    // i4_e_inv + tau1_of_e_ea*m4_ea
    let tau1_of_m4_i4_e_ea = tau1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let tau1_of_place_17 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + tau1_of_place_17
    let tau1_of_place_18 = cos_gamma_minus_delta.mul_add(cos_phi, tau1_of_place_17);
    // ea_e_inv - 1
    let tau1_of_e_ea_2 = ea_e_inv - S::int(1);
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let tau1_of_place_19 = tau1_of_place_2
        .mul_add(sin_angle_cos_angle_inv, -tau1_of_place_18);
    // -tau1_of_place_19
    let minus_tau1_of_place_19 = -tau1_of_place_19;
    let tau1_of_place_20 = tau1_of_e_ea_2 * cos_gamma_minus_delta;
    let tau1_of_place_21 = S::int(2) * sin_angle_cos_angle_inv;
    let ea_ss_inv = ea * ss_inv;
    let tau1_of_place_22 = tau1_of_place_21 * cos_gamma_minus_delta;
    let tau1_of_place_23 = cos_phi_inv * cos_gamma_minus_delta;
    let sin_phi_tau1_of_place_18 = tau1_of_place_18 * sin_phi;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let tau1_of_place_24 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let m6_fa = m6 * fa;
    // i6_zf_inv + tau1_of_zf_fa*m6_fa
    let tau1_of_m6_i6_zf_fa = tau1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let tau1_of_place_25 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - tau1_of_place_25
    let tau1_of_place_26 = sin_gamma_minus_epsilon.mul_add(cos_omega, -tau1_of_place_25);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let tau1_of_zf_fa_2 = fa_zf_inv - S::int(1);
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let tau1_of_place_27 = tau1_of_place_7
        .mul_add(sin_angle_cos_angle_inv, tau1_of_place_26);
    let tau1_of_place_28 = tau1_of_zf_fa_2 * sin_gamma_minus_epsilon;
    let fa_ss_inv = fa * ss_inv;
    let tau1_of_place_29 = tau1_of_place_21 * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let tau1_of_place_30 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let tau1_of_place_31 = tau1_of_place_26 * sin_omega;
    let tau1_of_place_32 = cos_omega_inv * sin_gamma_minus_epsilon;
    let tau1_of_place_33 = tau1_of_place_32 * sin_omega;
    let zf_inv_tau1_of_place_33 = zf_inv * tau1_of_place_33;
    let tau1_of_place_34 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let tau1_of_place_35 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - tau1_of_d_beta_gamma*tau1_of_place_34*rr_cos_angle_inv
    let tau1_of_place_36 = (-(tau1_of_d_beta_gamma * tau1_of_place_34))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let tau1_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let tau1_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let tau1_of_place_37 = (xc_sq + tau1_of_xb_xc + yc_sq + tau1_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // Values.
    // tau1 = rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(ea/e - 1) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta - phi)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e +
    //   m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))) -
    //   sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 +
    //   (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta -
    //   theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))))/(ss*zt))/zt + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma
    //   - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta + theta -
    //   gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e +
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) - sin(phi)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss -
    //   tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta - phi) - cos(gamma -
    //   delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) -
    //   sin(phi)*cos(gamma - delta - phi))/ss) + I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma -
    //   epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma -
    //   epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon - omega))/cos(omega)^2)))/zf -
    //   (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta
    //   + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta +
    //   theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
    //   + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom + beta_rate'*(I1 + m1*ra^2 + rr^2*(m2 +
    //   ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
    //   delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
    //   phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma)))
    let tau1 = beta_rate_dot
        * (I1 + m1 * ra * ra
            + rr * rr
                * (m2
                    + cos_angle_inv
                        * (cos_angle_inv
                            * (tau1_of_place_13 * sin_theta * sin_theta
                                + i2_plus_da_m2_da * tau1_of_d_beta_gamma * tau1_of_d_beta_gamma)
                            - S::int(2) * tau1_of_place_14 * cos_theta))) - mom
        - rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * tau1_of_place_37 * (l0 - tau1_of_place_37)
                    * (-sd).mul_add(tau1_of_place_16, sc * tau1_of_place_15)
                    / (xc_sq + tau1_of_xb_xc + yc_sq + tau1_of_yb_yc
                        + sd * tau1_of_place_15.mul_add(S::int(2), sd)
                        + sc * tau1_of_place_16.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (tau1_of_place_14
                            + cos_angle_inv
                                * (-rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_phi_inv_sq
                                                    * (tau1_of_place_2
                                                        * (zt_inv
                                                            * (cos_phi_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (e_inv
                                                                        * (tau1_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                            - tau1_of_place_18 * tau1_of_place_6
                                                                            + sin_phi_cos_phi_inv
                                                                                * (tau1_of_place_2
                                                                                    * sin_phi_doubled.mul_add(m4_ea, tau1_of_place_6)
                                                                                    - tau1_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                        + m4
                                                                            * (-tau1_of_place_4)
                                                                                .mul_add(sin_phi_cos_phi_inv, sin_gamma_minus_delta))
                                                                    - tau1_of_place_2 * sin_phi
                                                                        * (tau1_of_place_2 * cos_phi_inv
                                                                            * (m4 + zt_inv_tau1_of_place_6)
                                                                            + m4 * tau1_of_e_ea_2 * sin_gamma_minus_delta))
                                                                + zt_inv * ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(
                                                                            minus_tau1_of_place_19,
                                                                            I5 * minus_tau1_of_place_19,
                                                                        ) + m4 * tau1_of_place_2 * tau1_of_place_20)
                                                            - m4
                                                                * (e_inv
                                                                    * (cos_gamma_minus_delta
                                                                        * (tau1_of_place_20 + tau1_of_place_18 * cos_phi_inv
                                                                            - sin_phi
                                                                                * (cos_phi_inv_sq
                                                                                    * (-sin_phi_doubled)
                                                                                        .mul_add(tau1_of_place_20, tau1_of_place_2)
                                                                                    + tau1_of_place_21 * ea_ss_inv))
                                                                        - tau1_of_place_17 * ea_ss_inv)
                                                                    + ss_inv
                                                                        * (tau1_of_place_19
                                                                            + sin_phi * (sin_gamma_minus_delta + tau1_of_place_22))))
                                                        + cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        tau1_of_place_24,
                                                                        tau1_of_place_5 * sin_phi_cos_phi_inv * tau1_of_place_23,
                                                                    )
                                                                + m4
                                                                    * (e_inv
                                                                        * (sin_phi_cos_phi_inv * cos_gamma_minus_delta
                                                                            * (tau1_of_place_23 - tau1_of_place_18)
                                                                            + ea
                                                                                * (e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * (sin_phi_cos_phi_inv
                                                                                            * tau1_of_e_ea.mul_add(tau1_of_place_23, tau1_of_place_18)
                                                                                            - sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                        - ea_ss_inv * sin_gamma_minus_delta)
                                                                                    + ss_inv
                                                                                        * (sin_gamma_minus_delta
                                                                                            .mul_add(S::int(2), tau1_of_place_22)
                                                                                            - sin_phi_tau1_of_place_18)))
                                                                        + ss_inv * (sin_phi_tau1_of_place_18 - tau1_of_place_24))))
                                                    - ss_inv * ss_inv_tau1_of_place_12 * sin_angle_cos_angle_inv
                                                    - cos_omega_inv_sq
                                                        * (tau1_of_place_7
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (tau1_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - tau1_of_place_26 * tau1_of_place_10
                                                                                + sin_omega_cos_omega_inv
                                                                                    * (tau1_of_place_7
                                                                                        * sin_omega_doubled.mul_add(m6_fa, -tau1_of_place_10)
                                                                                        + tau1_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                            + m6
                                                                                * tau1_of_place_9
                                                                                    .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                        + tau1_of_place_7 * sin_omega
                                                                            * (tau1_of_place_7 * cos_omega_inv
                                                                                * (m6 + u_2_inv_tau1_of_place_10)
                                                                                + m6 * tau1_of_zf_fa_2 * cos_gamma_minus_epsilon))
                                                                    + u_2_inv * ss_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(tau1_of_place_27, I7 * tau1_of_place_27)
                                                                    + m6 * tau1_of_place_7 * tau1_of_place_28)
                                                                + m6
                                                                    * (ss_inv
                                                                        * (tau1_of_place_27
                                                                            + sin_omega * (cos_gamma_minus_epsilon - tau1_of_place_29))
                                                                        - zf_inv
                                                                            * (sin_gamma_minus_epsilon
                                                                                * (tau1_of_place_28 + tau1_of_place_26 * cos_omega_inv
                                                                                    + sin_omega
                                                                                        * (cos_omega_inv_sq
                                                                                            * sin_omega_doubled
                                                                                                .mul_add(tau1_of_place_28, tau1_of_place_7)
                                                                                            - tau1_of_place_21 * fa_ss_inv))
                                                                                + tau1_of_place_25 * fa_ss_inv)))
                                                            + sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (zf_inv
                                                                        * (tau1_of_place_33 * (tau1_of_place_26 - tau1_of_place_32)
                                                                            + fa
                                                                                * (ss_inv
                                                                                    * (cos_gamma_minus_epsilon
                                                                                        .mul_add(S::int(2), -tau1_of_place_29)
                                                                                        - fa_zf_inv * tau1_of_place_30 + tau1_of_place_31)
                                                                                    - zf_inv_tau1_of_place_33
                                                                                        * tau1_of_zf_fa
                                                                                            .mul_add(tau1_of_place_32, tau1_of_place_26)))
                                                                        - ss_inv * (tau1_of_place_30 + tau1_of_place_31))
                                                                    - zf_inv_i6_zf_inv
                                                                        * tau1_of_place_32
                                                                            .mul_add(
                                                                                zf_inv_tau1_of_place_33,
                                                                                ss_inv * tau1_of_place_30,
                                                                            ))))
                                                + tau1_of_place_13 * tau1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            + tau1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (tau1_of_place_11
                                                        + ss_inv * m2_da.mul_add(sin_angle, tau1_of_place_12))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - tau1_of_place_34)))
                                        + m2_da * d_inv
                                            * (-ss_inv)
                                                .mul_add(
                                                    tau1_of_place_35,
                                                    tau1_of_d_beta_gamma * cos_beta_minus_gamma,
                                                )) + tau1_of_place_13 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * tau1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    tau1_of_place_36,
                                    rr * tau1_of_place_34 * cos_theta,
                                ) + I2 * tau1_of_place_36) - m2_da * tau1_of_place_35));
    [tau1]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 109 convolutions and 260 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 8]],
    history: &mut [Factors<S, 112>],
) {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta_0, theta_0, gamma_0, delta_0, phi_0, epsilon_0, omega_0, beta_rate_0] = series[0];
    // Shared terms.
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    let zt_inv = S::int(1) / zt;
    let e_inv_ea = ea / e;
    // ea/e - 2
    let weight_of_e_ea = e_inv_ea - S::int(2);
    // I5 + m5*(ta^2 + tb^2)
    let weight_3_of_m5_i5_ta_tb = I5 + m5 * tb.mul_add(tb, ta * ta);
    let zf_inv_fa = fa / zf;
    // fa/zf - 2
    let weight_4_of_zf_fa = zf_inv_fa - S::int(2);
    // I7 + m7*(ua^2 + ub^2)
    let weight_6_of_m7_i7_ua_ub = I7 + m7 * ub.mul_add(ub, ua * ua);
    // I3 + m3*(sa^2 + sb^2)
    let weight_7_of_m3_i3_sa_sb = I3 + m3 * sb.mul_add(sb, sa * sa);
    // I2 + m2*da^2
    let i2_plus_m2_da_sq = I2 + m2 * da * da;
    // I4/e + m4*ea*(ea/e - 2)
    let weight_17_of_m4_i4_e_ea = (m4 * ea).mul_add(weight_of_e_ea, I4 / e);
    // m4 + (I5 + m5*(ta^2 + tb^2))/zt^2
    let weight_3_of_place = m4 + weight_3_of_m5_i5_ta_tb / (zt * zt);
    // ea/e - 1
    let weight_2_of_e_ea = e_inv_ea - S::int(1);
    let i4_e_inv2 = I4 / (e * e);
    // I6/zf + m6*fa*(fa/zf - 2)
    let weight_27_of_m6_i6_zf_fa = (m6 * fa).mul_add(weight_4_of_zf_fa, I6 / zf);
    // m6 + (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_6_of_place = m6 + weight_6_of_m7_i7_ua_ub / (u_2 * u_2);
    // fa/zf - 1
    let weight_5_of_zf_fa = zf_inv_fa - S::int(1);
    let i6_zf_inv2 = I6 / (zf * zf);
    let m2_d_inv_da = m2 * da / d;
    let m2_da_2 = m2 * da;
    let d_inv = S::int(1) / d;
    let weight_2_of_m4_e_ea = m4 * weight_2_of_e_ea;
    let weight_5_of_m6_zf_fa = m6 * weight_5_of_zf_fa;
    let weight_11_of_xb_xc_sc = sc * xb_minus_xc;
    let weight_12_of_yb_yc_sc = sc * yb_minus_yc;
    let weight_11_of_yb_yc_sd = sd * yb_minus_yc;
    let weight_12_of_xb_xc_sd = sd * xb_minus_xc;
    // sc*(yb - yc) + sd*(xc - xb)
    let weight_44_of_place = weight_12_of_yb_yc_sc - weight_12_of_xb_xc_sd;
    // sc*(xb - xc) + sd*(yb - yc)
    let weight_43_of_place = weight_11_of_xb_xc_sc + weight_11_of_yb_yc_sd;
    let weight_35_of_place = i2_plus_m2_da_sq / (d * ss);
    // m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight_of_m4_i4_e_ea = m4 + i4_e_inv2 + m4 * ea * weight_of_e_ea / e;
    // m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight_4_of_m6_i6_zf_fa = m6 + i6_zf_inv2 + m6 * fa * weight_4_of_zf_fa / zf;
    let m4_1_minus_ea_by_e_by_ss_of_m4_e_ea_ss = m4 * weight_2_of_e_ea / ss;
    let m4_e_inv2_ea_sq = m4 * ea * ea / (e * e);
    let m4_e_inv_ea = m4 * ea / e;
    // (m4 + I5/zt^2 + m5*ta^2/zt^2 + m5*tb^2/zt^2)/ss
    let weight_22_of_place = (m4 + I5 / (zt * zt) + m5 * ta * ta / (zt * zt)
        + m5 * tb * tb / (zt * zt)) / ss;
    // m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf
    let weight_36_of_m6_i6_zf_fa = m6 + i6_zf_inv2 + m6 * fa * fa / (zf * zf)
        - S::int(2) * m6 * fa / zf;
    let weight_18_of_m4_e_ea = m4 * weight_2_of_e_ea / e;
    let weight_28_of_m6_zf_fa = m6 * weight_5_of_zf_fa / zf;
    // Constant in time.
    // weight = m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight = weight_of_m4_i4_e_ea;
    // weight_2 = 2*m4*(1 - ea/e)
    let weight_2 = -S::int(2) * weight_2_of_m4_e_ea;
    // weight_3 = m4 + (I5 + m5*(ta^2 + tb^2))/zt^2
    let weight_3 = weight_3_of_place;
    // weight_4 = m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight_4 = weight_4_of_m6_i6_zf_fa;
    // weight_5 = 2*m6*(fa/zf - 1)
    let weight_5 = S::int(2) * weight_5_of_m6_zf_fa;
    // weight_6 = m6 + (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_6 = weight_6_of_place;
    // weight_7 = (I3 + m3*(sa^2 + sb^2))/ss^2
    let weight_7 = weight_7_of_m3_i3_sa_sb / (ss * ss);
    // i2_plus_m2_da_2_by_d_2 = (I2 + m2*da^2)/d^2
    let i2_plus_m2_da_2_by_d_2 = i2_plus_m2_da_sq / (d * d);
    // weight_8 = 2*m2*da/d
    let weight_8 = S::int(2) * m2_d_inv_da;
    // weight_9 = I1 + m2*rr^2 + m1*ra^2
    let weight_9 = I1 + m2 * rr * rr + m1 * ra * ra;
    // minus_rr_2 = -rr^2
    let minus_rr_2 = -rr * rr;
    // weight_10 = xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc^2 + sd^2
    let weight_10 = xb * (-xc).mul_add(S::int(2), xb) + xc * xc + yc * yc
        + yb * (-yc).mul_add(S::int(2), yb) + sc * sc + sd * sd;
    // weight_11 = 2*sc*(xb - xc) + 2*sd*(yb - yc)
    let weight_11 = weight_11_of_yb_yc_sd
        .mul_add(S::int(2), S::int(2) * weight_11_of_xb_xc_sc);
    // weight_12 = 2*sc*(yc - yb) + 2*sd*(xb - xc)
    let weight_12 = (-weight_12_of_yb_yc_sc)
        .mul_add(S::int(2), S::int(2) * weight_12_of_xb_xc_sd);
    // weight_13 = 1/e
    let weight_13 = S::int(1) / e;
    // minus_1_by_zt = -1/zt
    let minus_1_by_zt = -zt_inv;
    // weight_14 = 1/u
    let weight_14 = S::int(1) / u_2;
    // minus_1_by_zf = -1/zf
    let minus_1_by_zf = -S::int(1) / zf;
    // m4_ea_by_e_minus_1 = m4*(ea/e - 1)
    let m4_ea_by_e_minus_1 = weight_2_of_m4_e_ea;
    // m6_fa_by_zf_minus_1 = m6*(fa/zf - 1)
    let m6_fa_by_zf_minus_1 = weight_5_of_m6_zf_fa;
    // weight_15 = m4/e + (I5 + m5*(ta^2 + tb^2))/(e*zt^2)
    let weight_15 = m4 / e + weight_3_of_m5_i5_ta_tb / (e * zt * zt);
    // weight_16 = 2*m4*(ea/e - 1)/zt
    let weight_16 = S::int(2) * m4 * weight_2_of_e_ea / zt;
    // weight_17 = m4/zt + (I4/e + m4*ea*(ea/e - 2))/(e*zt)
    let weight_17 = m4 / zt + weight_17_of_m4_i4_e_ea / (e * zt);
    // weight_18 = 2*m4*(ea/e - 1)/e
    let weight_18 = S::int(2) * weight_18_of_m4_e_ea;
    // weight_19 = (m4 + I4/e^2 + m4*ea*(ea/e - 2)/e)/e
    let weight_19 = weight_of_m4_i4_e_ea / e;
    // m4_ea_by_e_minus_1_by_e = m4*(ea/e - 1)/e
    let m4_ea_by_e_minus_1_by_e = weight_18_of_m4_e_ea;
    // weight_20 = (m4 + (I4/e + m4*ea*(ea/e - 2))/e)/zt
    let weight_20 = (m4 + weight_17_of_m4_i4_e_ea / e) / zt;
    // weight_21 = -(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/e
    let weight_21 = -weight_3_of_place / e;
    // weight_22 = (m4 + I5/zt^2 + m5*ta^2/zt^2 + m5*tb^2/zt^2)/ss
    let weight_22 = weight_22_of_place;
    // weight_23 = 1/zt
    let weight_23 = zt_inv;
    // weight_24 = -(m4 + I5/zt^2 + m5*ta^2/zt^2 + m5*tb^2/zt^2)/ss
    let weight_24 = -weight_22_of_place;
    // m4_1_minus_ea_by_e_by_ss = m4*(1 - ea/e)/ss
    let m4_1_minus_ea_by_e_by_ss = -m4_1_minus_ea_by_e_by_ss_of_m4_e_ea_ss;
    // weight_25 = m6/zf + (I7 + m7*(ua^2 + ub^2))/(u^2*zf)
    let weight_25 = m6 / zf + weight_6_of_m7_i7_ua_ub / (u_2 * u_2 * zf);
    // weight_26 = 2*m6*(1 - fa/zf)/u
    let weight_26 = -S::int(2) * m6 * weight_5_of_zf_fa / u_2;
    // weight_27 = m6/u + (I6/zf + m6*fa*(fa/zf - 2))/(u*zf)
    let weight_27 = m6 / u_2 + weight_27_of_m6_i6_zf_fa / (u_2 * zf);
    // weight_28 = 2*m6*(1 - fa/zf)/zf
    let weight_28 = -S::int(2) * weight_28_of_m6_zf_fa;
    // weight_29 = (m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf)/zf
    let weight_29 = weight_4_of_m6_i6_zf_fa / zf;
    // weight_30 = m6*(fa/zf - 1)/zf
    let weight_30 = weight_28_of_m6_zf_fa;
    // weight_31 = (m6 + (I6/zf + m6*fa*(fa/zf - 2))/zf)/u
    let weight_31 = (m6 + weight_27_of_m6_i6_zf_fa / zf) / u_2;
    // weight_32 = -(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/zf
    let weight_32 = -weight_6_of_place / zf;
    // weight_33 = (m6 + I7/u^2 + m7*ua^2/u^2 + m7*ub^2/u^2)/ss
    let weight_33 = (m6 + I7 / (u_2 * u_2) + m7 * ua * ua / (u_2 * u_2)
        + m7 * ub * ub / (u_2 * u_2)) / ss;
    // weight_34 = m6*(1 - fa/zf)/ss
    let weight_34 = -m6 * weight_5_of_zf_fa / ss;
    // m2_da_by_ss = m2*da/ss
    let m2_da_by_ss = m2 * da / ss;
    // weight_35 = -(I2 + m2*da^2)/(d*ss)
    let weight_35 = -weight_35_of_place;
    // i2_plus_m2_da_2_by_d_ss = (I2 + m2*da^2)/(d*ss)
    let i2_plus_m2_da_2_by_d_ss = weight_35_of_place;
    // m2_da_rr_by_d_ss = m2*da*rr/(d*ss)
    let m2_da_rr_by_d_ss = m2 * da * rr / (d * ss);
    // i2_plus_m2_da_2_by_d = (I2 + m2*da^2)/d
    let i2_plus_m2_da_2_by_d = i2_plus_m2_da_sq / d;
    // minus_m2_da = -m2*da
    let minus_m2_da = -m2_da_2;
    // i2_plus_m2_da_2 = I2 + m2*da^2
    let i2_plus_m2_da_2 = i2_plus_m2_da_sq;
    // minus_rr = -rr
    let minus_rr = -rr;
    // m2_da = m2*da
    let m2_da = m2_da_2;
    // minus_1_by_d = -1/d
    let minus_1_by_d = -d_inv;
    // weight_36 = m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf
    let weight_36 = weight_36_of_m6_i6_zf_fa;
    // weight_37 = (m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf)/ss
    let weight_37 = weight_36_of_m6_i6_zf_fa / ss;
    // minus_1_by_ss = -1/ss
    let minus_1_by_ss = -S::int(1) / ss;
    // m6_1_minus_fa_by_zf = m6*(1 - fa/zf)
    let m6_1_minus_fa_by_zf = -weight_5_of_m6_zf_fa;
    // weight_38 = 2*m4*(ea/e - 1)
    let weight_38 = S::int(2) * weight_2_of_m4_e_ea;
    // weight_39 = 2*m4*ea/e - m4 - I4/e^2 - m4*ea^2/e^2
    let weight_39 = m4_e_inv_ea.mul_add(S::int(2), -m4) - i4_e_inv2 - m4_e_inv2_ea_sq;
    // weight_40 = (m4 + I4/e^2 + m4*ea^2/e^2 - 2*m4*ea/e)/ss
    let weight_40 = (-m4_e_inv_ea).mul_add(S::int(2), m4 + i4_e_inv2 + m4_e_inv2_ea_sq) / ss;
    // m4_ea_by_e_minus_1_by_ss = m4*(ea/e - 1)/ss
    let m4_ea_by_e_minus_1_by_ss = m4_1_minus_ea_by_e_by_ss_of_m4_e_ea_ss;
    // weight_41 = (I3 + m3*(sa^2 + sb^2))/ss^3
    let weight_41 = weight_7_of_m3_i3_sa_sb / (ss * ss * ss);
    // weight_42 = 1/d
    let weight_42 = d_inv;
    // m2_da_rr_by_d_2 = m2*da*rr/d^2
    let m2_da_rr_by_d_2 = m2 * da * rr / (d * d);
    // m2_da_by_d = m2*da/d
    let m2_da_by_d = m2_d_inv_da;
    // weight_43 = sc*(xb - xc) + sd*(yb - yc)
    let weight_43 = weight_43_of_place;
    // weight_44 = sc*(yb - yc) + sd*(xc - xb)
    let weight_44 = weight_44_of_place;
    // weight_45 = -l0*(sc*(xb - xc) + sd*(yb - yc))
    let weight_45 = -l0 * weight_43_of_place;
    // weight_46 = -l0*(sc*(yb - yc) + sd*(xc - xb))
    let weight_46 = -l0 * weight_44_of_place;
    // minus_c0_by_ss = -c0/ss
    let minus_c0_by_ss = -c0 / ss;
    // rr_by_d = rr/d
    let rr_by_d = rr / d;
    // rr_by_ss = rr/ss
    let rr_by_ss = rr / ss;
    // rr_by_zt = rr/zt
    let rr_by_zt = rr / zt;
    // rr_by_u = rr/u
    let rr_by_u = rr / u_2;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let over_cos_phi = S::int(1) / cos_phi_0;
    let (sin_omega_0, cos_omega_0) = omega_0.sin_cos();
    let over_cos_omega = S::int(1) / cos_omega_0;
    let beta_minus_gamma_0 = beta_0 - gamma_0;
    let d1_of_place_0 = beta_0 + theta_0 - gamma_0;
    let (sin_angle_0, cos_angle_0) = d1_of_place_0.sin_cos();
    let over_cos_angle = S::int(1) / cos_angle_0;
    let (sin_beta_minus_gamma_0, cos_beta_minus_gamma_0) = beta_minus_gamma_0.sin_cos();
    let d1_of_place_2_0 = gamma_0 - delta_0 - phi_0;
    let (sin_angle_2_0, cos_angle_2_0) = d1_of_place_2_0.sin_cos();
    let gamma_minus_delta_0 = gamma_0 - delta_0;
    let (sin_gamma_minus_delta_0, cos_gamma_minus_delta_0) = gamma_minus_delta_0
        .sin_cos();
    let d1_of_place_3_0 = gamma_0 - epsilon_0 - omega_0;
    let (sin_angle_3_0, cos_angle_3_0) = d1_of_place_3_0.sin_cos();
    let gamma_minus_epsilon_0 = gamma_0 - epsilon_0;
    let (sin_gamma_minus_epsilon_0, cos_gamma_minus_epsilon_0) = gamma_minus_epsilon_0
        .sin_cos();
    let cos_beta_minus_gamma_sq_0 = cos_beta_minus_gamma_0 * cos_beta_minus_gamma_0;
    let d1_of_place_4_0 = cos_theta_0 * cos_beta_minus_gamma_0;
    let sin_phi_sin_angle_2_0 = sin_phi_0 * sin_angle_2_0;
    let d1_of_place_5_0 = sin_phi_sin_angle_2_0
        .mul_add(weight_2, weight * cos_gamma_minus_delta_0);
    let d1_of_place_6_0 = cos_gamma_minus_delta_0 * d1_of_place_5_0;
    let sin_angle_2_sq_0 = sin_angle_2_0 * sin_angle_2_0;
    let d1_of_place_7_0 = weight_3 * sin_angle_2_sq_0 + d1_of_place_6_0;
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let over_cos_phi_sq = S::int(1) / cos_phi_sq_0;
    let d1_of_place_8_0 = d1_of_place_7_0 * over_cos_phi_sq;
    let sin_omega_cos_angle_3_0 = sin_omega_0 * cos_angle_3_0;
    let d1_of_place_9_0 = sin_omega_cos_angle_3_0
        .mul_add(weight_5, weight_4 * sin_gamma_minus_epsilon_0);
    let d1_of_place_10_0 = sin_gamma_minus_epsilon_0 * d1_of_place_9_0;
    let cos_angle_3_sq_0 = cos_angle_3_0 * cos_angle_3_0;
    let d1_of_place_11_0 = weight_6 * cos_angle_3_sq_0 + d1_of_place_10_0;
    let cos_omega_sq_0 = cos_omega_0 * cos_omega_0;
    let over_cos_omega_sq = S::int(1) / cos_omega_sq_0;
    let d1_of_place_12_0 = d1_of_place_11_0 * over_cos_omega_sq;
    let d1_of_place_13_0 = weight_7 + d1_of_place_8_0 + d1_of_place_12_0;
    let sin_theta_sq_0 = sin_theta_0 * sin_theta_0;
    let d1_of_place_14_0 = d1_of_place_13_0 * sin_theta_sq_0;
    let d1_of_place_15_0 = i2_plus_m2_da_2_by_d_2 * cos_beta_minus_gamma_sq_0 + d1_of_place_14_0;
    let d1_of_place_16_0 = d1_of_place_15_0 * over_cos_angle;
    let d1_of_place_17_0 = weight_8 * d1_of_place_4_0 - d1_of_place_16_0;
    let d1_of_place_18_0 = d1_of_place_17_0 * over_cos_angle;
    let d1_of_place_19_0 = d1_of_place_18_0.mul_add(minus_rr_2, weight_9);
    let over_d1_of_place_19 = S::int(1) / d1_of_place_19_0;
    let (sin_gamma_0, cos_gamma_0) = gamma_0.sin_cos();
    let beta_rate_dot_of_place_0 = cos_gamma_0
        .mul_add(weight_12, sin_gamma_0.mul_add(weight_11, weight_10));
    let over_beta_rate_dot_of_place = S::int(1) / beta_rate_dot_of_place_0;
    let beta_rate_dot_of_place_2_0 = beta_rate_dot_of_place_0.sqrt();
    let over_twice_beta_rate_dot_of_place_2 = S::int(1)
        / (beta_rate_dot_of_place_2_0 + beta_rate_dot_of_place_2_0);
    let beta_rate_dot_of_place_3_0 = sin_angle_2_0
        .mul_add(minus_1_by_zt, weight_13 * cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_4_0 = sin_gamma_minus_epsilon_0
        .mul_add(minus_1_by_zf, weight_14 * cos_angle_3_0);
    let cos_phi_inv_sin_angle_2_0 = sin_angle_2_0 * over_cos_phi;
    let beta_rate_dot_of_place_5_0 = cos_phi_inv_sin_angle_2_0
        .mul_add(weight_3, m4_ea_by_e_minus_1 * sin_gamma_minus_delta_0);
    let beta_rate_dot_of_place_6_0 = cos_angle_3_0 * over_cos_omega;
    let beta_rate_dot_of_place_7_0 = beta_rate_dot_of_place_6_0
        .mul_add(weight_6, m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon_0);
    let sin_angle_cos_angle_inv_0 = sin_angle_0 * over_cos_angle;
    let beta_rate_dot_of_place_8_0 = cos_theta_0 * sin_beta_minus_gamma_0;
    let beta_rate_dot_of_place_9_0 = sin_phi_0.mul_add(weight_16, weight_15);
    let beta_rate_dot_of_place_10_0 = sin_angle_2_0 * beta_rate_dot_of_place_9_0;
    let beta_rate_dot_of_place_11_0 = sin_phi_0.mul_add(weight_18, weight_17);
    let beta_rate_dot_of_place_12_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_11_0;
    let beta_rate_dot_of_place_13_0 = beta_rate_dot_of_place_10_0 - beta_rate_dot_of_place_12_0;
    let beta_rate_dot_of_place_14_0 = sin_angle_2_0 * beta_rate_dot_of_place_13_0;
    let cos_gamma_minus_delta_sq_0 = cos_gamma_minus_delta_0 * cos_gamma_minus_delta_0;
    let beta_rate_dot_of_place_15_0 = weight_19 * cos_gamma_minus_delta_sq_0
        + beta_rate_dot_of_place_14_0;
    let beta_rate_dot_of_place_16_0 = beta_rate_dot_of_place_15_0 * over_cos_phi;
    let beta_rate_dot_of_place_17_0 = cos_gamma_minus_delta_0 * cos_angle_2_0;
    let beta_rate_dot_of_place_18_0 = m4_ea_by_e_minus_1_by_e
        * beta_rate_dot_of_place_17_0 + beta_rate_dot_of_place_16_0;
    let beta_rate_dot_of_place_19_0 = cos_angle_2_0
        .mul_add(weight_21, weight_20 * sin_gamma_minus_delta_0);
    let sin_phi_cos_phi_inv_0 = sin_phi_0 * over_cos_phi;
    let beta_rate_dot_of_place_20_0 = beta_rate_dot_of_place_5_0 * sin_phi_cos_phi_inv_0;
    let beta_rate_dot_of_place_21_0 = beta_rate_dot_of_place_20_0
        .mul_add(weight_23, weight_22 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_22_0 = sin_angle_2_0 * beta_rate_dot_of_place_21_0;
    let beta_rate_dot_of_place_23_0 = sin_phi_0 * sin_gamma_minus_delta_0;
    let beta_rate_dot_of_place_24_0 = beta_rate_dot_of_place_23_0
        .mul_add(m4_1_minus_ea_by_e_by_ss, weight_24 * cos_angle_2_0) + beta_rate_dot_of_place_22_0;
    let beta_rate_dot_of_place_25_0 = sin_angle_2_0 * beta_rate_dot_of_place_24_0;
    let beta_rate_dot_of_place_26_0 = sin_omega_0.mul_add(weight_26, weight_25);
    let beta_rate_dot_of_place_27_0 = cos_angle_3_0 * beta_rate_dot_of_place_26_0;
    let beta_rate_dot_of_place_28_0 = sin_omega_0.mul_add(weight_28, weight_27);
    let beta_rate_dot_of_place_29_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_28_0;
    let beta_rate_dot_of_place_30_0 = beta_rate_dot_of_place_27_0 - beta_rate_dot_of_place_29_0;
    let beta_rate_dot_of_place_31_0 = cos_angle_3_0 * beta_rate_dot_of_place_30_0;
    let beta_rate_dot_of_place_32_0 = sin_gamma_minus_epsilon_0 * sin_gamma_minus_epsilon_0;
    let beta_rate_dot_of_place_33_0 = weight_29 * beta_rate_dot_of_place_32_0
        + beta_rate_dot_of_place_31_0;
    let beta_rate_dot_of_place_34_0 = beta_rate_dot_of_place_33_0 * over_cos_omega;
    let beta_rate_dot_of_place_35_0 = sin_gamma_minus_epsilon_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_36_0 = weight_30 * beta_rate_dot_of_place_35_0
        + beta_rate_dot_of_place_34_0;
    let beta_rate_dot_of_place_37_0 = sin_angle_3_0
        .mul_add(weight_32, weight_31 * cos_gamma_minus_epsilon_0);
    let sin_omega_cos_omega_inv_0 = sin_omega_0 * over_cos_omega;
    let beta_rate_dot_of_place_38_0 = beta_rate_dot_of_place_7_0 * sin_omega_cos_omega_inv_0;
    let beta_rate_dot_of_place_39_0 = beta_rate_dot_of_place_38_0
        .mul_add(weight_14, weight_33 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_40_0 = cos_angle_3_0 * beta_rate_dot_of_place_39_0;
    let beta_rate_dot_of_place_41_0 = sin_omega_0 * cos_gamma_minus_epsilon_0;
    let beta_rate_dot_of_place_42_0 = beta_rate_dot_of_place_41_0
        .mul_add(weight_34, weight_33 * sin_angle_3_0) + beta_rate_dot_of_place_40_0;
    let beta_rate_dot_of_place_43_0 = cos_angle_3_0 * beta_rate_dot_of_place_42_0;
    let beta_rate_dot_of_place_44_0 = cos_beta_minus_gamma_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_45_0 = d1_of_place_13_0 * beta_rate_dot_of_place_44_0;
    let beta_rate_dot_of_place_46_0 = sin_angle_0.mul_add(m2_da_by_ss, weight_7)
        + d1_of_place_8_0 + d1_of_place_12_0;
    let beta_rate_dot_of_place_47_0 = cos_theta_0 * beta_rate_dot_of_place_46_0;
    let beta_rate_dot_of_place_48_0 = beta_rate_dot_of_place_44_0
        .mul_add(weight_35, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma_0)
        + beta_rate_dot_of_place_47_0;
    let beta_rate_dot_of_place_49_0 = cos_beta_minus_gamma_0 * beta_rate_dot_of_place_48_0;
    let beta_rate_dot_of_place_50_0 = sin_beta_minus_gamma_0
        .mul_add(m2_da_rr_by_d_ss, weight_7) + d1_of_place_8_0 + d1_of_place_12_0;
    let beta_rate_dot_of_place_51_0 = cos_theta_0 * beta_rate_dot_of_place_50_0;
    let beta_rate_dot_of_place_52_0 = cos_beta_minus_gamma_0 * over_cos_angle;
    let beta_rate_dot_of_place_53_0 = beta_rate_dot_of_place_52_0
        .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta_0);
    let beta_rate_dot_of_place_54_0 = beta_rate_dot_of_place_53_0 * beta_rate_dot_of_place_44_0;
    let beta_rate_dot_of_place_55_0 = beta_rate_dot_of_place_54_0
        .mul_add(minus_rr, i2_plus_m2_da_2 * sin_beta_minus_gamma_0);
    let beta_rate_dot_of_place_56_0 = beta_rate_dot_of_place_55_0 * beta_rate_dot_of_place_52_0;
    let beta_rate_dot_of_place_57_0 = beta_rate_dot_of_place_56_0
        .mul_add(minus_1_by_d, m2_da * beta_rate_dot_of_place_8_0);
    let beta_rate_sq_0 = beta_rate_0 * beta_rate_0;
    let beta_rate_dot_of_beta_rate_0 = beta_rate_dot_of_place_57_0 * beta_rate_sq_0;
    let beta_rate_dot_of_place_58_0 = sin_omega_0 * beta_rate_dot_of_place_36_0;
    let beta_rate_dot_of_place_59_0 = cos_angle_3_0 * beta_rate_dot_of_place_37_0;
    let beta_rate_dot_of_place_60_0 = -beta_rate_dot_of_place_59_0 + beta_rate_dot_of_place_58_0;
    let beta_rate_dot_of_place_61_0 = beta_rate_dot_of_place_60_0 * over_cos_omega;
    let beta_rate_dot_of_place_62_0 = sin_omega_cos_angle_3_0
        .mul_add(weight_5, weight_36 * sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_63_0 = beta_rate_dot_of_place_62_0 * sin_angle_cos_angle_inv_0;
    let sin_omega_sin_angle_3_0 = sin_omega_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_64_0 = cos_angle_3_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_65_0 = beta_rate_dot_of_place_63_0
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_64_0
                .mul_add(
                    m6_1_minus_fa_by_zf,
                    sin_omega_sin_angle_3_0
                        .mul_add(weight_34, weight_37 * cos_gamma_minus_epsilon_0),
                ),
        ) + beta_rate_dot_of_place_61_0;
    let beta_rate_dot_of_place_66_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_65_0;
    let beta_rate_dot_of_place_67_0 = beta_rate_dot_of_place_43_0 - beta_rate_dot_of_place_66_0;
    let beta_rate_dot_of_place_68_0 = beta_rate_dot_of_place_67_0 * over_cos_omega_sq;
    let beta_rate_dot_of_place_69_0 = sin_phi_0 * beta_rate_dot_of_place_18_0;
    let beta_rate_dot_of_place_70_0 = sin_angle_2_0 * beta_rate_dot_of_place_19_0;
    let beta_rate_dot_of_place_71_0 = beta_rate_dot_of_place_70_0 + beta_rate_dot_of_place_69_0;
    let beta_rate_dot_of_place_72_0 = beta_rate_dot_of_place_71_0 * over_cos_phi;
    let beta_rate_dot_of_place_73_0 = sin_phi_sin_angle_2_0
        .mul_add(weight_38, weight_39 * cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_74_0 = beta_rate_dot_of_place_73_0 * sin_angle_cos_angle_inv_0;
    let sin_phi_cos_angle_2_0 = sin_phi_0 * cos_angle_2_0;
    let beta_rate_dot_of_place_75_0 = sin_angle_2_0 * beta_rate_dot_of_place_3_0;
    let beta_rate_dot_of_place_76_0 = beta_rate_dot_of_place_74_0
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_75_0
                .mul_add(
                    m4_ea_by_e_minus_1,
                    sin_phi_cos_angle_2_0
                        .mul_add(
                            m4_ea_by_e_minus_1_by_ss,
                            weight_40 * sin_gamma_minus_delta_0,
                        ),
                ),
        ) - beta_rate_dot_of_place_72_0;
    let beta_rate_dot_of_place_77_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_76_0;
    let beta_rate_dot_of_place_78_0 = beta_rate_dot_of_place_25_0 + beta_rate_dot_of_place_77_0;
    let beta_rate_dot_of_place_79_0 = beta_rate_dot_of_place_78_0 * over_cos_phi_sq;
    let beta_rate_dot_of_place_80_0 = weight_41 * sin_angle_cos_angle_inv_0
        + beta_rate_dot_of_place_68_0 + beta_rate_dot_of_place_79_0;
    let beta_rate_dot_of_place_81_0 = sin_theta_0 * beta_rate_dot_of_place_80_0;
    let beta_rate_dot_of_place_82_0 = weight_42 * beta_rate_dot_of_place_45_0
        - beta_rate_dot_of_place_81_0;
    let beta_rate_dot_of_place_83_0 = sin_theta_0 * beta_rate_dot_of_place_82_0;
    let beta_rate_dot_of_place_84_0 = weight_42 * beta_rate_dot_of_place_49_0
        + beta_rate_dot_of_place_83_0;
    let beta_rate_dot_of_place_85_0 = beta_rate_dot_of_place_84_0 * over_cos_angle;
    let beta_rate_dot_of_place_86_0 = beta_rate_dot_of_place_85_0
        .mul_add(
            rr,
            m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq_0 - beta_rate_dot_of_place_51_0,
        );
    let beta_rate_dot_of_place_87_0 = beta_rate_dot_of_place_86_0 * over_cos_angle;
    let beta_rate_dot_of_place_88_0 = m2_da_by_d * cos_beta_minus_gamma_0
        - beta_rate_dot_of_place_87_0;
    let beta_rate_dot_of_beta_rate_2_0 = beta_rate_dot_of_place_88_0 * beta_rate_sq_0;
    let beta_rate_dot_of_place_89_0 = sin_gamma_0
        .mul_add(weight_44, weight_43 * cos_gamma_0);
    let beta_rate_dot_of_place_90_0 = beta_rate_dot_of_place_2_0 * beta_rate_dot_of_place_89_0;
    let beta_rate_dot_of_place_91_0 = sin_gamma_0
        .mul_add(weight_46, weight_45 * cos_gamma_0) + beta_rate_dot_of_place_90_0;
    let beta_rate_dot_of_place_92_0 = beta_rate_dot_of_place_2_0 * over_beta_rate_dot_of_place;
    let beta_rate_dot_of_place_93_0 = beta_rate_dot_of_place_91_0 * beta_rate_dot_of_place_92_0;
    let beta_rate_dot_of_beta_rate_3_0 = beta_rate_dot_of_beta_rate_2_0
        .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_93_0);
    let beta_rate_dot_of_beta_rate_4_0 = sin_theta_0 * beta_rate_dot_of_beta_rate_3_0;
    let beta_rate_dot_of_beta_rate_5_0 = rr_by_d * beta_rate_dot_of_beta_rate_0
        - beta_rate_dot_of_beta_rate_4_0;
    let beta_rate_dot_of_beta_rate_6_0 = beta_rate_dot_of_beta_rate_5_0 * over_cos_angle;
    let beta_rate_dot_of_beta_rate_7_0 = beta_rate_dot_of_beta_rate_6_0
        .mul_add(minus_rr, mom);
    let beta_rate_dot_2_0 = beta_rate_dot_of_beta_rate_7_0 * over_d1_of_place_19;
    let theta_of_place_0 = beta_rate_dot_of_place_52_0.mul_add(rr_by_d, -S::int(1));
    let theta_dot_2_0 = beta_rate_0 * theta_of_place_0;
    let beta_rate_sin_theta_0 = beta_rate_0 * sin_theta_0;
    let gamma_of_beta_rate_0 = beta_rate_sin_theta_0 * over_cos_angle;
    let delta_of_beta_rate_0 = gamma_of_beta_rate_0 * cos_phi_inv_sin_angle_2_0;
    let phi_of_place_0 = beta_rate_dot_of_place_3_0 * over_cos_phi;
    let phi_of_beta_rate_0 = gamma_of_beta_rate_0 * phi_of_place_0;
    let epsilon_of_beta_rate_0 = gamma_of_beta_rate_0 * beta_rate_dot_of_place_6_0;
    let omega_of_place_0 = beta_rate_dot_of_place_4_0 * over_cos_omega;
    let omega_of_beta_rate_0 = gamma_of_beta_rate_0 * omega_of_place_0;
    // Order 1: the rates, and what follows from them.
    let beta_1 = beta_rate_0;
    let theta_1 = theta_dot_2_0;
    let gamma_1 = rr_by_ss * gamma_of_beta_rate_0;
    let delta_1 = rr_by_zt * delta_of_beta_rate_0;
    let phi_1 = rr * phi_of_beta_rate_0;
    let epsilon_1 = rr_by_u * epsilon_of_beta_rate_0;
    let omega_1 = minus_rr * omega_of_beta_rate_0;
    let beta_rate_1 = beta_rate_dot_2_0;
    if series.len() > 1 {
        series[1] = [
            beta_1, theta_1, gamma_1, delta_1, phi_1, epsilon_1, omega_1, beta_rate_1,
        ];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let sin_omega_1 = omega_1 * cos_omega_0;
    let cos_omega_1 = -omega_1 * sin_omega_0;
    let beta_minus_gamma_1 = beta_1 - gamma_1;
    let d1_of_place_1 = beta_1 + theta_1 - gamma_1;
    let sin_angle_1 = d1_of_place_1 * cos_angle_0;
    let cos_angle_1 = -d1_of_place_1 * sin_angle_0;
    let sin_beta_minus_gamma_1 = beta_minus_gamma_1 * cos_beta_minus_gamma_0;
    let cos_beta_minus_gamma_1 = -beta_minus_gamma_1 * sin_beta_minus_gamma_0;
    let d1_of_place_2_1 = gamma_1 - delta_1 - phi_1;
    let sin_angle_2_1 = d1_of_place_2_1 * cos_angle_2_0;
    let cos_angle_2_1 = -d1_of_place_2_1 * sin_angle_2_0;
    let gamma_minus_delta_1 = gamma_1 - delta_1;
    let sin_gamma_minus_delta_1 = gamma_minus_delta_1 * cos_gamma_minus_delta_0;
    let cos_gamma_minus_delta_1 = -gamma_minus_delta_1 * sin_gamma_minus_delta_0;
    let d1_of_place_3_1 = gamma_1 - epsilon_1 - omega_1;
    let sin_angle_3_1 = d1_of_place_3_1 * cos_angle_3_0;
    let cos_angle_3_1 = -d1_of_place_3_1 * sin_angle_3_0;
    let gamma_minus_epsilon_1 = gamma_1 - epsilon_1;
    let sin_gamma_minus_epsilon_1 = gamma_minus_epsilon_1 * cos_gamma_minus_epsilon_0;
    let cos_gamma_minus_epsilon_1 = -gamma_minus_epsilon_1 * sin_gamma_minus_epsilon_0;
    let cos_beta_minus_gamma_sq_1 = cos_beta_minus_gamma_1
        * (cos_beta_minus_gamma_0 + cos_beta_minus_gamma_0);
    let d1_of_place_4_1 = cos_beta_minus_gamma_1
        .mul_add(cos_theta_0, cos_theta_1 * cos_beta_minus_gamma_0);
    let sin_phi_sin_angle_2_1 = sin_angle_2_1
        .mul_add(sin_phi_0, sin_phi_1 * sin_angle_2_0);
    let d1_of_place_5_1 = sin_phi_sin_angle_2_1
        .mul_add(weight_2, weight * cos_gamma_minus_delta_1);
    let d1_of_place_6_1 = d1_of_place_5_1
        .mul_add(cos_gamma_minus_delta_0, cos_gamma_minus_delta_1 * d1_of_place_5_0);
    let sin_angle_2_sq_1 = sin_angle_2_1 * (sin_angle_2_0 + sin_angle_2_0);
    let d1_of_place_7_1 = weight_3 * sin_angle_2_sq_1 + d1_of_place_6_1;
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let d1_of_place_8_1 = cos_phi_sq_1
        .mul_add(
            -(d1_of_place_8_0 * over_cos_phi_sq),
            d1_of_place_7_1 * over_cos_phi_sq,
        );
    let sin_omega_cos_angle_3_1 = cos_angle_3_1
        .mul_add(sin_omega_0, sin_omega_1 * cos_angle_3_0);
    let d1_of_place_9_1 = sin_omega_cos_angle_3_1
        .mul_add(weight_5, weight_4 * sin_gamma_minus_epsilon_1);
    let d1_of_place_10_1 = d1_of_place_9_1
        .mul_add(sin_gamma_minus_epsilon_0, sin_gamma_minus_epsilon_1 * d1_of_place_9_0);
    let cos_angle_3_sq_1 = cos_angle_3_1 * (cos_angle_3_0 + cos_angle_3_0);
    let d1_of_place_11_1 = weight_6 * cos_angle_3_sq_1 + d1_of_place_10_1;
    let cos_omega_sq_1 = cos_omega_1 * (cos_omega_0 + cos_omega_0);
    let d1_of_place_12_1 = cos_omega_sq_1
        .mul_add(
            -(d1_of_place_12_0 * over_cos_omega_sq),
            d1_of_place_11_1 * over_cos_omega_sq,
        );
    let d1_of_place_13_1 = d1_of_place_8_1 + d1_of_place_12_1;
    let sin_theta_sq_1 = sin_theta_1 * (sin_theta_0 + sin_theta_0);
    let d1_of_place_14_1 = d1_of_place_13_1
        .mul_add(sin_theta_sq_0, sin_theta_sq_1 * d1_of_place_13_0);
    let d1_of_place_15_1 = i2_plus_m2_da_2_by_d_2 * cos_beta_minus_gamma_sq_1 + d1_of_place_14_1;
    let d1_of_place_16_1 = cos_angle_1
        .mul_add(
            -(d1_of_place_16_0 * over_cos_angle),
            d1_of_place_15_1 * over_cos_angle,
        );
    let d1_of_place_17_1 = weight_8 * d1_of_place_4_1 - d1_of_place_16_1;
    let d1_of_place_18_1 = cos_angle_1
        .mul_add(
            -(d1_of_place_18_0 * over_cos_angle),
            d1_of_place_17_1 * over_cos_angle,
        );
    let d1_of_place_19_1 = minus_rr_2 * d1_of_place_18_1;
    let sin_gamma_1 = gamma_1 * cos_gamma_0;
    let cos_gamma_1 = -gamma_1 * sin_gamma_0;
    let beta_rate_dot_of_place_1 = cos_gamma_1
        .mul_add(weight_12, weight_11 * sin_gamma_1);
    let beta_rate_dot_of_place_2_1 = beta_rate_dot_of_place_1 * over_twice_beta_rate_dot_of_place_2;
    let beta_rate_dot_of_place_3_1 = sin_angle_2_1
        .mul_add(minus_1_by_zt, weight_13 * cos_gamma_minus_delta_1);
    let beta_rate_dot_of_place_4_1 = sin_gamma_minus_epsilon_1
        .mul_add(minus_1_by_zf, weight_14 * cos_angle_3_1);
    let cos_phi_inv_sin_angle_2_1 = cos_phi_1
        .mul_add(
            -(cos_phi_inv_sin_angle_2_0 * over_cos_phi),
            sin_angle_2_1 * over_cos_phi,
        );
    let beta_rate_dot_of_place_5_1 = cos_phi_inv_sin_angle_2_1
        .mul_add(weight_3, m4_ea_by_e_minus_1 * sin_gamma_minus_delta_1);
    let beta_rate_dot_of_place_6_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_6_0 * over_cos_omega),
            cos_angle_3_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_7_1 = beta_rate_dot_of_place_6_1
        .mul_add(weight_6, m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon_1);
    let sin_angle_cos_angle_inv_1 = cos_angle_1
        .mul_add(
            -(sin_angle_cos_angle_inv_0 * over_cos_angle),
            sin_angle_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_8_1 = sin_beta_minus_gamma_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_beta_minus_gamma_0);
    let beta_rate_dot_of_place_9_1 = weight_16 * sin_phi_1;
    let beta_rate_dot_of_place_10_1 = beta_rate_dot_of_place_9_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_9_0);
    let beta_rate_dot_of_place_11_1 = weight_18 * sin_phi_1;
    let beta_rate_dot_of_place_12_1 = beta_rate_dot_of_place_11_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_11_0,
        );
    let beta_rate_dot_of_place_13_1 = beta_rate_dot_of_place_10_1 - beta_rate_dot_of_place_12_1;
    let beta_rate_dot_of_place_14_1 = beta_rate_dot_of_place_13_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_13_0);
    let cos_gamma_minus_delta_sq_1 = cos_gamma_minus_delta_1
        * (cos_gamma_minus_delta_0 + cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_15_1 = weight_19 * cos_gamma_minus_delta_sq_1
        + beta_rate_dot_of_place_14_1;
    let beta_rate_dot_of_place_16_1 = cos_phi_1
        .mul_add(
            -(beta_rate_dot_of_place_16_0 * over_cos_phi),
            beta_rate_dot_of_place_15_1 * over_cos_phi,
        );
    let beta_rate_dot_of_place_17_1 = cos_angle_2_1
        .mul_add(cos_gamma_minus_delta_0, cos_gamma_minus_delta_1 * cos_angle_2_0);
    let beta_rate_dot_of_place_18_1 = m4_ea_by_e_minus_1_by_e
        * beta_rate_dot_of_place_17_1 + beta_rate_dot_of_place_16_1;
    let beta_rate_dot_of_place_19_1 = cos_angle_2_1
        .mul_add(weight_21, weight_20 * sin_gamma_minus_delta_1);
    let sin_phi_cos_phi_inv_1 = cos_phi_1
        .mul_add(-(sin_phi_cos_phi_inv_0 * over_cos_phi), sin_phi_1 * over_cos_phi);
    let beta_rate_dot_of_place_20_1 = beta_rate_dot_of_place_5_1
        .mul_add(
            sin_phi_cos_phi_inv_0,
            sin_phi_cos_phi_inv_1 * beta_rate_dot_of_place_5_0,
        );
    let beta_rate_dot_of_place_21_1 = beta_rate_dot_of_place_20_1
        .mul_add(weight_23, weight_22 * sin_angle_cos_angle_inv_1);
    let beta_rate_dot_of_place_22_1 = beta_rate_dot_of_place_21_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_21_0);
    let beta_rate_dot_of_place_23_1 = sin_gamma_minus_delta_1
        .mul_add(sin_phi_0, sin_phi_1 * sin_gamma_minus_delta_0);
    let beta_rate_dot_of_place_24_1 = beta_rate_dot_of_place_23_1
        .mul_add(m4_1_minus_ea_by_e_by_ss, weight_24 * cos_angle_2_1) + beta_rate_dot_of_place_22_1;
    let beta_rate_dot_of_place_25_1 = beta_rate_dot_of_place_24_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_24_0);
    let beta_rate_dot_of_place_26_1 = weight_26 * sin_omega_1;
    let beta_rate_dot_of_place_27_1 = beta_rate_dot_of_place_26_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_26_0);
    let beta_rate_dot_of_place_28_1 = weight_28 * sin_omega_1;
    let beta_rate_dot_of_place_29_1 = beta_rate_dot_of_place_28_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_28_0,
        );
    let beta_rate_dot_of_place_30_1 = beta_rate_dot_of_place_27_1 - beta_rate_dot_of_place_29_1;
    let beta_rate_dot_of_place_31_1 = beta_rate_dot_of_place_30_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_30_0);
    let beta_rate_dot_of_place_32_1 = sin_gamma_minus_epsilon_1
        * (sin_gamma_minus_epsilon_0 + sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_33_1 = weight_29 * beta_rate_dot_of_place_32_1
        + beta_rate_dot_of_place_31_1;
    let beta_rate_dot_of_place_34_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_34_0 * over_cos_omega),
            beta_rate_dot_of_place_33_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_35_1 = sin_angle_3_1
        .mul_add(sin_gamma_minus_epsilon_0, sin_gamma_minus_epsilon_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_36_1 = weight_30 * beta_rate_dot_of_place_35_1
        + beta_rate_dot_of_place_34_1;
    let beta_rate_dot_of_place_37_1 = sin_angle_3_1
        .mul_add(weight_32, weight_31 * cos_gamma_minus_epsilon_1);
    let sin_omega_cos_omega_inv_1 = cos_omega_1
        .mul_add(
            -(sin_omega_cos_omega_inv_0 * over_cos_omega),
            sin_omega_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_38_1 = beta_rate_dot_of_place_7_1
        .mul_add(
            sin_omega_cos_omega_inv_0,
            sin_omega_cos_omega_inv_1 * beta_rate_dot_of_place_7_0,
        );
    let beta_rate_dot_of_place_39_1 = beta_rate_dot_of_place_38_1
        .mul_add(weight_14, weight_33 * sin_angle_cos_angle_inv_1);
    let beta_rate_dot_of_place_40_1 = beta_rate_dot_of_place_39_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_39_0);
    let beta_rate_dot_of_place_41_1 = cos_gamma_minus_epsilon_1
        .mul_add(sin_omega_0, sin_omega_1 * cos_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_42_1 = beta_rate_dot_of_place_41_1
        .mul_add(weight_34, weight_33 * sin_angle_3_1) + beta_rate_dot_of_place_40_1;
    let beta_rate_dot_of_place_43_1 = beta_rate_dot_of_place_42_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_42_0);
    let beta_rate_dot_of_place_44_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_45_1 = d1_of_place_13_1
        .mul_add(
            beta_rate_dot_of_place_44_0,
            beta_rate_dot_of_place_44_1 * d1_of_place_13_0,
        );
    let beta_rate_dot_of_place_46_1 = m2_da_by_ss * sin_angle_1 + d1_of_place_8_1
        + d1_of_place_12_1;
    let beta_rate_dot_of_place_47_1 = beta_rate_dot_of_place_46_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_46_0);
    let beta_rate_dot_of_place_48_1 = beta_rate_dot_of_place_44_1
        .mul_add(weight_35, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma_1)
        + beta_rate_dot_of_place_47_1;
    let beta_rate_dot_of_place_49_1 = beta_rate_dot_of_place_48_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * beta_rate_dot_of_place_48_0,
        );
    let beta_rate_dot_of_place_50_1 = m2_da_rr_by_d_ss * sin_beta_minus_gamma_1
        + d1_of_place_8_1 + d1_of_place_12_1;
    let beta_rate_dot_of_place_51_1 = beta_rate_dot_of_place_50_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_50_0);
    let beta_rate_dot_of_place_52_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_52_0 * over_cos_angle),
            cos_beta_minus_gamma_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_53_1 = beta_rate_dot_of_place_52_1
        .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta_1);
    let beta_rate_dot_of_place_54_1 = beta_rate_dot_of_place_44_1
        .mul_add(
            beta_rate_dot_of_place_53_0,
            beta_rate_dot_of_place_53_1 * beta_rate_dot_of_place_44_0,
        );
    let beta_rate_dot_of_place_55_1 = beta_rate_dot_of_place_54_1
        .mul_add(minus_rr, i2_plus_m2_da_2 * sin_beta_minus_gamma_1);
    let beta_rate_dot_of_place_56_1 = beta_rate_dot_of_place_55_1
        .mul_add(
            beta_rate_dot_of_place_52_0,
            beta_rate_dot_of_place_52_1 * beta_rate_dot_of_place_55_0,
        );
    let beta_rate_dot_of_place_57_1 = beta_rate_dot_of_place_56_1
        .mul_add(minus_1_by_d, m2_da * beta_rate_dot_of_place_8_1);
    let beta_rate_sq_1 = beta_rate_1 * (beta_rate_0 + beta_rate_0);
    let beta_rate_dot_of_beta_rate_1 = beta_rate_dot_of_place_57_1
        .mul_add(beta_rate_sq_0, beta_rate_sq_1 * beta_rate_dot_of_place_57_0);
    let beta_rate_dot_of_place_58_1 = beta_rate_dot_of_place_36_1
        .mul_add(sin_omega_0, sin_omega_1 * beta_rate_dot_of_place_36_0);
    let beta_rate_dot_of_place_59_1 = beta_rate_dot_of_place_37_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_37_0);
    let beta_rate_dot_of_place_60_1 = -beta_rate_dot_of_place_59_1 + beta_rate_dot_of_place_58_1;
    let beta_rate_dot_of_place_61_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_61_0 * over_cos_omega),
            beta_rate_dot_of_place_60_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_62_1 = sin_omega_cos_angle_3_1
        .mul_add(weight_5, weight_36 * sin_gamma_minus_epsilon_1);
    let beta_rate_dot_of_place_63_1 = beta_rate_dot_of_place_62_1
        .mul_add(
            sin_angle_cos_angle_inv_0,
            sin_angle_cos_angle_inv_1 * beta_rate_dot_of_place_62_0,
        );
    let sin_omega_sin_angle_3_1 = sin_angle_3_1
        .mul_add(sin_omega_0, sin_omega_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_64_1 = beta_rate_dot_of_place_4_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_4_0);
    let beta_rate_dot_of_place_65_1 = beta_rate_dot_of_place_63_1
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_64_1
                .mul_add(
                    m6_1_minus_fa_by_zf,
                    sin_omega_sin_angle_3_1
                        .mul_add(weight_34, weight_37 * cos_gamma_minus_epsilon_1),
                ),
        ) + beta_rate_dot_of_place_61_1;
    let beta_rate_dot_of_place_66_1 = beta_rate_dot_of_place_65_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_65_0,
        );
    let beta_rate_dot_of_place_67_1 = beta_rate_dot_of_place_43_1 - beta_rate_dot_of_place_66_1;
    let beta_rate_dot_of_place_68_1 = cos_omega_sq_1
        .mul_add(
            -(beta_rate_dot_of_place_68_0 * over_cos_omega_sq),
            beta_rate_dot_of_place_67_1 * over_cos_omega_sq,
        );
    let beta_rate_dot_of_place_69_1 = beta_rate_dot_of_place_18_1
        .mul_add(sin_phi_0, sin_phi_1 * beta_rate_dot_of_place_18_0);
    let beta_rate_dot_of_place_70_1 = beta_rate_dot_of_place_19_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_19_0);
    let beta_rate_dot_of_place_71_1 = beta_rate_dot_of_place_70_1 + beta_rate_dot_of_place_69_1;
    let beta_rate_dot_of_place_72_1 = cos_phi_1
        .mul_add(
            -(beta_rate_dot_of_place_72_0 * over_cos_phi),
            beta_rate_dot_of_place_71_1 * over_cos_phi,
        );
    let beta_rate_dot_of_place_73_1 = sin_phi_sin_angle_2_1
        .mul_add(weight_38, weight_39 * cos_gamma_minus_delta_1);
    let beta_rate_dot_of_place_74_1 = beta_rate_dot_of_place_73_1
        .mul_add(
            sin_angle_cos_angle_inv_0,
            sin_angle_cos_angle_inv_1 * beta_rate_dot_of_place_73_0,
        );
    let sin_phi_cos_angle_2_1 = cos_angle_2_1
        .mul_add(sin_phi_0, sin_phi_1 * cos_angle_2_0);
    let beta_rate_dot_of_place_75_1 = beta_rate_dot_of_place_3_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_3_0);
    let beta_rate_dot_of_place_76_1 = beta_rate_dot_of_place_74_1
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_75_1
                .mul_add(
                    m4_ea_by_e_minus_1,
                    sin_phi_cos_angle_2_1
                        .mul_add(
                            m4_ea_by_e_minus_1_by_ss,
                            weight_40 * sin_gamma_minus_delta_1,
                        ),
                ),
        ) - beta_rate_dot_of_place_72_1;
    let beta_rate_dot_of_place_77_1 = beta_rate_dot_of_place_76_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_76_0,
        );
    let beta_rate_dot_of_place_78_1 = beta_rate_dot_of_place_25_1 + beta_rate_dot_of_place_77_1;
    let beta_rate_dot_of_place_79_1 = cos_phi_sq_1
        .mul_add(
            -(beta_rate_dot_of_place_79_0 * over_cos_phi_sq),
            beta_rate_dot_of_place_78_1 * over_cos_phi_sq,
        );
    let beta_rate_dot_of_place_80_1 = weight_41 * sin_angle_cos_angle_inv_1
        + beta_rate_dot_of_place_68_1 + beta_rate_dot_of_place_79_1;
    let beta_rate_dot_of_place_81_1 = beta_rate_dot_of_place_80_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_80_0);
    let beta_rate_dot_of_place_82_1 = weight_42 * beta_rate_dot_of_place_45_1
        - beta_rate_dot_of_place_81_1;
    let beta_rate_dot_of_place_83_1 = beta_rate_dot_of_place_82_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_82_0);
    let beta_rate_dot_of_place_84_1 = weight_42 * beta_rate_dot_of_place_49_1
        + beta_rate_dot_of_place_83_1;
    let beta_rate_dot_of_place_85_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_85_0 * over_cos_angle),
            beta_rate_dot_of_place_84_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_86_1 = beta_rate_dot_of_place_85_1
        .mul_add(
            rr,
            m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq_1 - beta_rate_dot_of_place_51_1,
        );
    let beta_rate_dot_of_place_87_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_87_0 * over_cos_angle),
            beta_rate_dot_of_place_86_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_88_1 = m2_da_by_d * cos_beta_minus_gamma_1
        - beta_rate_dot_of_place_87_1;
    let beta_rate_dot_of_beta_rate_2_1 = beta_rate_dot_of_place_88_1
        .mul_add(beta_rate_sq_0, beta_rate_sq_1 * beta_rate_dot_of_place_88_0);
    let beta_rate_dot_of_place_89_1 = sin_gamma_1
        .mul_add(weight_44, weight_43 * cos_gamma_1);
    let beta_rate_dot_of_place_90_1 = beta_rate_dot_of_place_2_1
        .mul_add(
            beta_rate_dot_of_place_89_0,
            beta_rate_dot_of_place_89_1 * beta_rate_dot_of_place_2_0,
        );
    let beta_rate_dot_of_place_91_1 = sin_gamma_1
        .mul_add(weight_46, weight_45 * cos_gamma_1) + beta_rate_dot_of_place_90_1;
    let beta_rate_dot_of_place_92_1 = beta_rate_dot_of_place_1
        .mul_add(
            -(beta_rate_dot_of_place_92_0 * over_beta_rate_dot_of_place),
            beta_rate_dot_of_place_2_1 * over_beta_rate_dot_of_place,
        );
    let beta_rate_dot_of_place_93_1 = beta_rate_dot_of_place_91_1
        .mul_add(
            beta_rate_dot_of_place_92_0,
            beta_rate_dot_of_place_92_1 * beta_rate_dot_of_place_91_0,
        );
    let beta_rate_dot_of_beta_rate_3_1 = beta_rate_dot_of_beta_rate_2_1
        .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_93_1);
    let beta_rate_dot_of_beta_rate_4_1 = beta_rate_dot_of_beta_rate_3_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_beta_rate_3_0);
    let beta_rate_dot_of_beta_rate_5_1 = rr_by_d * beta_rate_dot_of_beta_rate_1
        - beta_rate_dot_of_beta_rate_4_1;
    let beta_rate_dot_of_beta_rate_6_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_beta_rate_6_0 * over_cos_angle),
            beta_rate_dot_of_beta_rate_5_1 * over_cos_angle,
        );
    let beta_rate_dot_of_beta_rate_7_1 = minus_rr * beta_rate_dot_of_beta_rate_6_1;
    let beta_rate_dot_2_1 = d1_of_place_19_1
        .mul_add(
            -(beta_rate_dot_2_0 * over_d1_of_place_19),
            beta_rate_dot_of_beta_rate_7_1 * over_d1_of_place_19,
        );
    let theta_of_place_1 = rr_by_d * beta_rate_dot_of_place_52_1;
    let theta_dot_2_1 = theta_of_place_1
        .mul_add(beta_rate_0, beta_rate_1 * theta_of_place_0);
    let beta_rate_sin_theta_1 = sin_theta_1
        .mul_add(beta_rate_0, beta_rate_1 * sin_theta_0);
    let gamma_of_beta_rate_1 = cos_angle_1
        .mul_add(
            -(gamma_of_beta_rate_0 * over_cos_angle),
            beta_rate_sin_theta_1 * over_cos_angle,
        );
    let delta_of_beta_rate_1 = gamma_of_beta_rate_1
        .mul_add(
            cos_phi_inv_sin_angle_2_0,
            cos_phi_inv_sin_angle_2_1 * gamma_of_beta_rate_0,
        );
    let phi_of_place_1 = cos_phi_1
        .mul_add(
            -(phi_of_place_0 * over_cos_phi),
            beta_rate_dot_of_place_3_1 * over_cos_phi,
        );
    let phi_of_beta_rate_1 = phi_of_place_1
        .mul_add(gamma_of_beta_rate_0, gamma_of_beta_rate_1 * phi_of_place_0);
    let epsilon_of_beta_rate_1 = gamma_of_beta_rate_1
        .mul_add(
            beta_rate_dot_of_place_6_0,
            beta_rate_dot_of_place_6_1 * gamma_of_beta_rate_0,
        );
    let omega_of_place_1 = cos_omega_1
        .mul_add(
            -(omega_of_place_0 * over_cos_omega),
            beta_rate_dot_of_place_4_1 * over_cos_omega,
        );
    let omega_of_beta_rate_1 = omega_of_place_1
        .mul_add(gamma_of_beta_rate_0, gamma_of_beta_rate_1 * omega_of_place_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, phi_1, phi_1, omega_1, omega_1, d1_of_place_1, d1_of_place_1,
                beta_minus_gamma_1, beta_minus_gamma_1, d1_of_place_2_1, d1_of_place_2_1,
                gamma_minus_delta_1, gamma_minus_delta_1, d1_of_place_3_1, d1_of_place_3_1,
                gamma_minus_epsilon_1, gamma_minus_epsilon_1, cos_beta_minus_gamma_1, cos_theta_1,
                sin_phi_1, cos_gamma_minus_delta_1, sin_angle_2_1, cos_phi_1, cos_phi_sq_1,
                sin_omega_1, sin_gamma_minus_epsilon_1, cos_angle_3_1, cos_omega_1, cos_omega_sq_1,
                sin_theta_1, d1_of_place_13_1, cos_angle_1, cos_angle_1, gamma_1, gamma_1,
                beta_rate_dot_of_place_2_1, cos_phi_1, cos_omega_1, cos_angle_1, cos_theta_1,
                sin_angle_2_1, cos_gamma_minus_delta_1, sin_angle_2_1, cos_gamma_minus_delta_1,
                cos_phi_1, cos_gamma_minus_delta_1, cos_phi_1, beta_rate_dot_of_place_5_1,
                sin_angle_2_1, sin_phi_1, sin_angle_2_1, cos_angle_3_1, sin_gamma_minus_epsilon_1,
                cos_angle_3_1, sin_gamma_minus_epsilon_1, cos_omega_1, sin_gamma_minus_epsilon_1,
                cos_omega_1, beta_rate_dot_of_place_7_1, cos_angle_3_1, sin_omega_1, cos_angle_3_1,
                cos_beta_minus_gamma_1, d1_of_place_13_1, cos_theta_1, cos_beta_minus_gamma_1,
                cos_theta_1, cos_angle_1, beta_rate_dot_of_place_53_1, beta_rate_dot_of_place_55_1,
                beta_rate_1, beta_rate_dot_of_place_57_1, sin_omega_1, cos_angle_3_1, cos_omega_1,
                beta_rate_dot_of_place_62_1, sin_omega_1, cos_angle_3_1, sin_gamma_minus_epsilon_1,
                cos_omega_sq_1, sin_phi_1, sin_angle_2_1, cos_phi_1, beta_rate_dot_of_place_73_1,
                sin_phi_1, sin_angle_2_1, cos_gamma_minus_delta_1, cos_phi_sq_1, sin_theta_1,
                sin_theta_1, cos_angle_1, cos_angle_1, beta_rate_dot_of_place_88_1,
                beta_rate_dot_of_place_2_1, beta_rate_dot_of_place_1, beta_rate_dot_of_place_91_1,
                sin_theta_1, cos_angle_1, d1_of_place_19_1, beta_rate_1, beta_rate_1, cos_angle_1,
                gamma_of_beta_rate_1, cos_phi_1, gamma_of_beta_rate_1, gamma_of_beta_rate_1,
                cos_omega_1, gamma_of_beta_rate_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, cos_phi_1, sin_phi_1, cos_omega_1, sin_omega_1,
                cos_angle_1, sin_angle_1, cos_beta_minus_gamma_1, sin_beta_minus_gamma_1,
                cos_angle_2_1, sin_angle_2_1, cos_gamma_minus_delta_1, sin_gamma_minus_delta_1,
                cos_angle_3_1, sin_angle_3_1, cos_gamma_minus_epsilon_1, sin_gamma_minus_epsilon_1,
                cos_beta_minus_gamma_1, cos_beta_minus_gamma_1, sin_angle_2_1, d1_of_place_5_1,
                sin_angle_2_1, cos_phi_1, d1_of_place_8_1, cos_angle_3_1, d1_of_place_9_1,
                cos_angle_3_1, cos_omega_1, d1_of_place_12_1, sin_theta_1, sin_theta_sq_1,
                d1_of_place_16_1, d1_of_place_18_1, cos_gamma_1, sin_gamma_1,
                beta_rate_dot_of_place_2_1, cos_phi_inv_sin_angle_2_1, beta_rate_dot_of_place_6_1,
                sin_angle_cos_angle_inv_1, sin_beta_minus_gamma_1, beta_rate_dot_of_place_9_1,
                beta_rate_dot_of_place_11_1, beta_rate_dot_of_place_13_1, cos_gamma_minus_delta_1,
                beta_rate_dot_of_place_16_1, cos_angle_2_1, sin_phi_cos_phi_inv_1,
                sin_phi_cos_phi_inv_1, beta_rate_dot_of_place_21_1, sin_gamma_minus_delta_1,
                beta_rate_dot_of_place_24_1, beta_rate_dot_of_place_26_1,
                beta_rate_dot_of_place_28_1, beta_rate_dot_of_place_30_1, sin_gamma_minus_epsilon_1,
                beta_rate_dot_of_place_34_1, sin_angle_3_1, sin_omega_cos_omega_inv_1,
                sin_omega_cos_omega_inv_1, beta_rate_dot_of_place_39_1, cos_gamma_minus_epsilon_1,
                beta_rate_dot_of_place_42_1, sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_44_1,
                beta_rate_dot_of_place_46_1, beta_rate_dot_of_place_48_1,
                beta_rate_dot_of_place_50_1, beta_rate_dot_of_place_52_1,
                beta_rate_dot_of_place_44_1, beta_rate_dot_of_place_52_1, beta_rate_1,
                beta_rate_sq_1, beta_rate_dot_of_place_36_1, beta_rate_dot_of_place_37_1,
                beta_rate_dot_of_place_61_1, sin_angle_cos_angle_inv_1, sin_angle_3_1,
                beta_rate_dot_of_place_4_1, beta_rate_dot_of_place_65_1,
                beta_rate_dot_of_place_68_1, beta_rate_dot_of_place_18_1,
                beta_rate_dot_of_place_19_1, beta_rate_dot_of_place_72_1, sin_angle_cos_angle_inv_1,
                cos_angle_2_1, beta_rate_dot_of_place_3_1, beta_rate_dot_of_place_76_1,
                beta_rate_dot_of_place_79_1, beta_rate_dot_of_place_80_1,
                beta_rate_dot_of_place_82_1, beta_rate_dot_of_place_85_1,
                beta_rate_dot_of_place_87_1, beta_rate_sq_1, beta_rate_dot_of_place_89_1,
                beta_rate_dot_of_place_92_1, beta_rate_dot_of_place_92_1,
                beta_rate_dot_of_beta_rate_3_1, beta_rate_dot_of_beta_rate_6_1, beta_rate_dot_2_1,
                theta_of_place_1, sin_theta_1, gamma_of_beta_rate_1, cos_phi_inv_sin_angle_2_1,
                phi_of_place_1, phi_of_place_1, beta_rate_dot_of_place_6_1, omega_of_place_1,
                omega_of_place_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut gamma_last = gamma_1;
    let mut phi_last = phi_1;
    let mut omega_last = omega_1;
    let mut beta_rate_last = beta_rate_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut sin_omega_last = sin_omega_1;
    let mut cos_omega_last = cos_omega_1;
    let mut beta_minus_gamma_last = beta_minus_gamma_1;
    let mut d1_of_place_last = d1_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_beta_minus_gamma_last = sin_beta_minus_gamma_1;
    let mut cos_beta_minus_gamma_last = cos_beta_minus_gamma_1;
    let mut d1_of_place_2_last = d1_of_place_2_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut gamma_minus_delta_last = gamma_minus_delta_1;
    let mut sin_gamma_minus_delta_last = sin_gamma_minus_delta_1;
    let mut cos_gamma_minus_delta_last = cos_gamma_minus_delta_1;
    let mut d1_of_place_3_last = d1_of_place_3_1;
    let mut sin_angle_3_last = sin_angle_3_1;
    let mut cos_angle_3_last = cos_angle_3_1;
    let mut gamma_minus_epsilon_last = gamma_minus_epsilon_1;
    let mut sin_gamma_minus_epsilon_last = sin_gamma_minus_epsilon_1;
    let mut cos_gamma_minus_epsilon_last = cos_gamma_minus_epsilon_1;
    let mut d1_of_place_5_last = d1_of_place_5_1;
    let mut cos_phi_sq_last = cos_phi_sq_1;
    let mut d1_of_place_8_last = d1_of_place_8_1;
    let mut d1_of_place_9_last = d1_of_place_9_1;
    let mut cos_omega_sq_last = cos_omega_sq_1;
    let mut d1_of_place_12_last = d1_of_place_12_1;
    let mut d1_of_place_13_last = d1_of_place_13_1;
    let mut sin_theta_sq_last = sin_theta_sq_1;
    let mut d1_of_place_16_last = d1_of_place_16_1;
    let mut d1_of_place_18_last = d1_of_place_18_1;
    let mut d1_of_place_19_last = d1_of_place_19_1;
    let mut sin_gamma_last = sin_gamma_1;
    let mut cos_gamma_last = cos_gamma_1;
    let mut beta_rate_dot_of_place_last = beta_rate_dot_of_place_1;
    let mut beta_rate_dot_of_place_2_last = beta_rate_dot_of_place_2_1;
    let mut beta_rate_dot_of_place_3_last = beta_rate_dot_of_place_3_1;
    let mut beta_rate_dot_of_place_4_last = beta_rate_dot_of_place_4_1;
    let mut cos_phi_inv_sin_angle_2_last = cos_phi_inv_sin_angle_2_1;
    let mut beta_rate_dot_of_place_5_last = beta_rate_dot_of_place_5_1;
    let mut beta_rate_dot_of_place_6_last = beta_rate_dot_of_place_6_1;
    let mut beta_rate_dot_of_place_7_last = beta_rate_dot_of_place_7_1;
    let mut sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv_1;
    let mut beta_rate_dot_of_place_9_last = beta_rate_dot_of_place_9_1;
    let mut beta_rate_dot_of_place_11_last = beta_rate_dot_of_place_11_1;
    let mut beta_rate_dot_of_place_13_last = beta_rate_dot_of_place_13_1;
    let mut beta_rate_dot_of_place_16_last = beta_rate_dot_of_place_16_1;
    let mut beta_rate_dot_of_place_18_last = beta_rate_dot_of_place_18_1;
    let mut beta_rate_dot_of_place_19_last = beta_rate_dot_of_place_19_1;
    let mut sin_phi_cos_phi_inv_last = sin_phi_cos_phi_inv_1;
    let mut beta_rate_dot_of_place_21_last = beta_rate_dot_of_place_21_1;
    let mut beta_rate_dot_of_place_24_last = beta_rate_dot_of_place_24_1;
    let mut beta_rate_dot_of_place_26_last = beta_rate_dot_of_place_26_1;
    let mut beta_rate_dot_of_place_28_last = beta_rate_dot_of_place_28_1;
    let mut beta_rate_dot_of_place_30_last = beta_rate_dot_of_place_30_1;
    let mut beta_rate_dot_of_place_34_last = beta_rate_dot_of_place_34_1;
    let mut beta_rate_dot_of_place_36_last = beta_rate_dot_of_place_36_1;
    let mut beta_rate_dot_of_place_37_last = beta_rate_dot_of_place_37_1;
    let mut sin_omega_cos_omega_inv_last = sin_omega_cos_omega_inv_1;
    let mut beta_rate_dot_of_place_39_last = beta_rate_dot_of_place_39_1;
    let mut beta_rate_dot_of_place_42_last = beta_rate_dot_of_place_42_1;
    let mut beta_rate_dot_of_place_44_last = beta_rate_dot_of_place_44_1;
    let mut beta_rate_dot_of_place_46_last = beta_rate_dot_of_place_46_1;
    let mut beta_rate_dot_of_place_48_last = beta_rate_dot_of_place_48_1;
    let mut beta_rate_dot_of_place_50_last = beta_rate_dot_of_place_50_1;
    let mut beta_rate_dot_of_place_52_last = beta_rate_dot_of_place_52_1;
    let mut beta_rate_dot_of_place_53_last = beta_rate_dot_of_place_53_1;
    let mut beta_rate_dot_of_place_55_last = beta_rate_dot_of_place_55_1;
    let mut beta_rate_dot_of_place_57_last = beta_rate_dot_of_place_57_1;
    let mut beta_rate_sq_last = beta_rate_sq_1;
    let mut beta_rate_dot_of_place_61_last = beta_rate_dot_of_place_61_1;
    let mut beta_rate_dot_of_place_62_last = beta_rate_dot_of_place_62_1;
    let mut beta_rate_dot_of_place_65_last = beta_rate_dot_of_place_65_1;
    let mut beta_rate_dot_of_place_68_last = beta_rate_dot_of_place_68_1;
    let mut beta_rate_dot_of_place_72_last = beta_rate_dot_of_place_72_1;
    let mut beta_rate_dot_of_place_73_last = beta_rate_dot_of_place_73_1;
    let mut beta_rate_dot_of_place_76_last = beta_rate_dot_of_place_76_1;
    let mut beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79_1;
    let mut beta_rate_dot_of_place_80_last = beta_rate_dot_of_place_80_1;
    let mut beta_rate_dot_of_place_82_last = beta_rate_dot_of_place_82_1;
    let mut beta_rate_dot_of_place_85_last = beta_rate_dot_of_place_85_1;
    let mut beta_rate_dot_of_place_87_last = beta_rate_dot_of_place_87_1;
    let mut beta_rate_dot_of_place_88_last = beta_rate_dot_of_place_88_1;
    let mut beta_rate_dot_of_place_89_last = beta_rate_dot_of_place_89_1;
    let mut beta_rate_dot_of_place_91_last = beta_rate_dot_of_place_91_1;
    let mut beta_rate_dot_of_place_92_last = beta_rate_dot_of_place_92_1;
    let mut beta_rate_dot_of_beta_rate_3_last = beta_rate_dot_of_beta_rate_3_1;
    let mut beta_rate_dot_of_beta_rate_6_last = beta_rate_dot_of_beta_rate_6_1;
    let mut beta_rate_dot_2_last = beta_rate_dot_2_1;
    let mut theta_of_place_last = theta_of_place_1;
    let mut gamma_of_beta_rate_last = gamma_of_beta_rate_1;
    let mut phi_of_place_last = phi_of_place_1;
    let mut omega_of_place_last = omega_of_place_1;
    let mut next = [S::int(0); 112];
    // Rates at order k - 1.
    let mut beta_rate_2 = beta_rate_1;
    let mut theta_rate = theta_dot_2_1;
    let mut gamma_rate = rr_by_ss * gamma_of_beta_rate_1;
    let mut delta_rate = rr_by_zt * delta_of_beta_rate_1;
    let mut phi_rate = rr * phi_of_beta_rate_1;
    let mut epsilon_rate = rr_by_u * epsilon_of_beta_rate_1;
    let mut omega_rate = minus_rr * omega_of_beta_rate_1;
    let mut beta_rate_rate = beta_rate_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let beta = beta_rate_2 * over_k;
        let theta = theta_rate * over_k;
        let gamma = gamma_rate * over_k;
        let delta = delta_rate * over_k;
        let phi = phi_rate * over_k;
        let epsilon = epsilon_rate * over_k;
        let omega = omega_rate * over_k;
        let beta_rate = beta_rate_rate * over_k;
        series[order] = [beta, theta, gamma, delta, phi, epsilon, omega, beta_rate];
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
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[0]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[1]),
                    ),
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[2]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[3]),
                    ),
                omega_1
                    .mul_add(
                        cos_omega_last,
                        (count_last * omega_last).mul_add(cos_omega_1, next[4]),
                    ),
                omega_1
                    .mul_add(
                        sin_omega_last,
                        (count_last * omega_last).mul_add(sin_omega_1, next[5]),
                    ),
                d1_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * d1_of_place_last).mul_add(cos_angle_1, next[6]),
                    ),
                d1_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * d1_of_place_last).mul_add(sin_angle_1, next[7]),
                    ),
                beta_minus_gamma_1
                    .mul_add(
                        cos_beta_minus_gamma_last,
                        (count_last * beta_minus_gamma_last)
                            .mul_add(cos_beta_minus_gamma_1, next[8]),
                    ),
                beta_minus_gamma_1
                    .mul_add(
                        sin_beta_minus_gamma_last,
                        (count_last * beta_minus_gamma_last)
                            .mul_add(sin_beta_minus_gamma_1, next[9]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        cos_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(cos_angle_2_1, next[10]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        sin_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(sin_angle_2_1, next[11]),
                    ),
                gamma_minus_delta_1
                    .mul_add(
                        cos_gamma_minus_delta_last,
                        (count_last * gamma_minus_delta_last)
                            .mul_add(cos_gamma_minus_delta_1, next[12]),
                    ),
                gamma_minus_delta_1
                    .mul_add(
                        sin_gamma_minus_delta_last,
                        (count_last * gamma_minus_delta_last)
                            .mul_add(sin_gamma_minus_delta_1, next[13]),
                    ),
                d1_of_place_3_1
                    .mul_add(
                        cos_angle_3_last,
                        (count_last * d1_of_place_3_last)
                            .mul_add(cos_angle_3_1, next[14]),
                    ),
                d1_of_place_3_1
                    .mul_add(
                        sin_angle_3_last,
                        (count_last * d1_of_place_3_last)
                            .mul_add(sin_angle_3_1, next[15]),
                    ),
                gamma_minus_epsilon_1
                    .mul_add(
                        cos_gamma_minus_epsilon_last,
                        (count_last * gamma_minus_epsilon_last)
                            .mul_add(cos_gamma_minus_epsilon_1, next[16]),
                    ),
                gamma_minus_epsilon_1
                    .mul_add(
                        sin_gamma_minus_epsilon_last,
                        (count_last * gamma_minus_epsilon_last)
                            .mul_add(sin_gamma_minus_epsilon_1, next[17]),
                    ),
                (cos_beta_minus_gamma_1 + cos_beta_minus_gamma_1)
                    .mul_add(cos_beta_minus_gamma_last, next[18]),
                cos_theta_1
                    .mul_add(
                        cos_beta_minus_gamma_last,
                        cos_theta_last.mul_add(cos_beta_minus_gamma_1, next[19]),
                    ),
                sin_phi_1
                    .mul_add(
                        sin_angle_2_last,
                        sin_phi_last.mul_add(sin_angle_2_1, next[20]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        d1_of_place_5_last,
                        cos_gamma_minus_delta_last.mul_add(d1_of_place_5_1, next[21]),
                    ),
                (sin_angle_2_1 + sin_angle_2_1).mul_add(sin_angle_2_last, next[22]),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[23]),
                cos_phi_sq_1
                    .mul_add(
                        d1_of_place_8_last,
                        cos_phi_sq_last.mul_add(d1_of_place_8_1, next[24]),
                    ),
                sin_omega_1
                    .mul_add(
                        cos_angle_3_last,
                        sin_omega_last.mul_add(cos_angle_3_1, next[25]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        d1_of_place_9_last,
                        sin_gamma_minus_epsilon_last.mul_add(d1_of_place_9_1, next[26]),
                    ),
                (cos_angle_3_1 + cos_angle_3_1).mul_add(cos_angle_3_last, next[27]),
                (cos_omega_1 + cos_omega_1).mul_add(cos_omega_last, next[28]),
                cos_omega_sq_1
                    .mul_add(
                        d1_of_place_12_last,
                        cos_omega_sq_last.mul_add(d1_of_place_12_1, next[29]),
                    ),
                (sin_theta_1 + sin_theta_1).mul_add(sin_theta_last, next[30]),
                d1_of_place_13_1
                    .mul_add(
                        sin_theta_sq_last,
                        d1_of_place_13_last.mul_add(sin_theta_sq_1, next[31]),
                    ),
                cos_angle_1
                    .mul_add(
                        d1_of_place_16_last,
                        cos_angle_last.mul_add(d1_of_place_16_1, next[32]),
                    ),
                cos_angle_1
                    .mul_add(
                        d1_of_place_18_last,
                        cos_angle_last.mul_add(d1_of_place_18_1, next[33]),
                    ),
                gamma_1
                    .mul_add(
                        cos_gamma_last,
                        (count_last * gamma_last).mul_add(cos_gamma_1, next[34]),
                    ),
                gamma_1
                    .mul_add(
                        sin_gamma_last,
                        (count_last * gamma_last).mul_add(sin_gamma_1, next[35]),
                    ),
                (beta_rate_dot_of_place_2_1 + beta_rate_dot_of_place_2_1)
                    .mul_add(beta_rate_dot_of_place_2_last, next[36]),
                cos_phi_1
                    .mul_add(
                        cos_phi_inv_sin_angle_2_last,
                        cos_phi_last.mul_add(cos_phi_inv_sin_angle_2_1, next[37]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_6_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_6_1, next[38]),
                    ),
                cos_angle_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_last.mul_add(sin_angle_cos_angle_inv_1, next[39]),
                    ),
                cos_theta_1
                    .mul_add(
                        sin_beta_minus_gamma_last,
                        cos_theta_last.mul_add(sin_beta_minus_gamma_1, next[40]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_9_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_9_1, next[41]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_11_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_11_1, next[42]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_13_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_13_1, next[43]),
                    ),
                (cos_gamma_minus_delta_1 + cos_gamma_minus_delta_1)
                    .mul_add(cos_gamma_minus_delta_last, next[44]),
                cos_phi_1
                    .mul_add(
                        beta_rate_dot_of_place_16_last,
                        cos_phi_last.mul_add(beta_rate_dot_of_place_16_1, next[45]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        cos_angle_2_last,
                        cos_gamma_minus_delta_last.mul_add(cos_angle_2_1, next[46]),
                    ),
                cos_phi_1
                    .mul_add(
                        sin_phi_cos_phi_inv_last,
                        cos_phi_last.mul_add(sin_phi_cos_phi_inv_1, next[47]),
                    ),
                beta_rate_dot_of_place_5_1
                    .mul_add(
                        sin_phi_cos_phi_inv_last,
                        beta_rate_dot_of_place_5_last
                            .mul_add(sin_phi_cos_phi_inv_1, next[48]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_21_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_21_1, next[49]),
                    ),
                sin_phi_1
                    .mul_add(
                        sin_gamma_minus_delta_last,
                        sin_phi_last.mul_add(sin_gamma_minus_delta_1, next[50]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_24_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_24_1, next[51]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_26_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_26_1, next[52]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_28_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_28_1, next[53]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_30_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_30_1, next[54]),
                    ),
                (sin_gamma_minus_epsilon_1 + sin_gamma_minus_epsilon_1)
                    .mul_add(sin_gamma_minus_epsilon_last, next[55]),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_34_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_34_1, next[56]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        sin_angle_3_last,
                        sin_gamma_minus_epsilon_last.mul_add(sin_angle_3_1, next[57]),
                    ),
                cos_omega_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        cos_omega_last.mul_add(sin_omega_cos_omega_inv_1, next[58]),
                    ),
                beta_rate_dot_of_place_7_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        beta_rate_dot_of_place_7_last
                            .mul_add(sin_omega_cos_omega_inv_1, next[59]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_39_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_39_1, next[60]),
                    ),
                sin_omega_1
                    .mul_add(
                        cos_gamma_minus_epsilon_last,
                        sin_omega_last.mul_add(cos_gamma_minus_epsilon_1, next[61]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_42_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_42_1, next[62]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_beta_minus_gamma_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[63]),
                    ),
                d1_of_place_13_1
                    .mul_add(
                        beta_rate_dot_of_place_44_last,
                        d1_of_place_13_last
                            .mul_add(beta_rate_dot_of_place_44_1, next[64]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_46_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_46_1, next[65]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_48_last,
                        cos_beta_minus_gamma_last
                            .mul_add(beta_rate_dot_of_place_48_1, next[66]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_50_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_50_1, next[67]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_52_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_52_1, next[68]),
                    ),
                beta_rate_dot_of_place_53_1
                    .mul_add(
                        beta_rate_dot_of_place_44_last,
                        beta_rate_dot_of_place_53_last
                            .mul_add(beta_rate_dot_of_place_44_1, next[69]),
                    ),
                beta_rate_dot_of_place_55_1
                    .mul_add(
                        beta_rate_dot_of_place_52_last,
                        beta_rate_dot_of_place_55_last
                            .mul_add(beta_rate_dot_of_place_52_1, next[70]),
                    ),
                (beta_rate_1 + beta_rate_1).mul_add(beta_rate_last, next[71]),
                beta_rate_dot_of_place_57_1
                    .mul_add(
                        beta_rate_sq_last,
                        beta_rate_dot_of_place_57_last.mul_add(beta_rate_sq_1, next[72]),
                    ),
                sin_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_36_last,
                        sin_omega_last.mul_add(beta_rate_dot_of_place_36_1, next[73]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_37_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_37_1, next[74]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_61_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_61_1, next[75]),
                    ),
                beta_rate_dot_of_place_62_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        beta_rate_dot_of_place_62_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[76]),
                    ),
                sin_omega_1
                    .mul_add(
                        sin_angle_3_last,
                        sin_omega_last.mul_add(sin_angle_3_1, next[77]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_4_1, next[78]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_65_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_65_1, next[79]),
                    ),
                cos_omega_sq_1
                    .mul_add(
                        beta_rate_dot_of_place_68_last,
                        cos_omega_sq_last.mul_add(beta_rate_dot_of_place_68_1, next[80]),
                    ),
                sin_phi_1
                    .mul_add(
                        beta_rate_dot_of_place_18_last,
                        sin_phi_last.mul_add(beta_rate_dot_of_place_18_1, next[81]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_19_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_19_1, next[82]),
                    ),
                cos_phi_1
                    .mul_add(
                        beta_rate_dot_of_place_72_last,
                        cos_phi_last.mul_add(beta_rate_dot_of_place_72_1, next[83]),
                    ),
                beta_rate_dot_of_place_73_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        beta_rate_dot_of_place_73_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[84]),
                    ),
                sin_phi_1
                    .mul_add(
                        cos_angle_2_last,
                        sin_phi_last.mul_add(cos_angle_2_1, next[85]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_3_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_3_1, next[86]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_76_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_76_1, next[87]),
                    ),
                cos_phi_sq_1
                    .mul_add(
                        beta_rate_dot_of_place_79_last,
                        cos_phi_sq_last.mul_add(beta_rate_dot_of_place_79_1, next[88]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_80_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_80_1, next[89]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_82_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_82_1, next[90]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_85_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_85_1, next[91]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_87_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_87_1, next[92]),
                    ),
                beta_rate_dot_of_place_88_1
                    .mul_add(
                        beta_rate_sq_last,
                        beta_rate_dot_of_place_88_last.mul_add(beta_rate_sq_1, next[93]),
                    ),
                beta_rate_dot_of_place_2_1
                    .mul_add(
                        beta_rate_dot_of_place_89_last,
                        beta_rate_dot_of_place_2_last
                            .mul_add(beta_rate_dot_of_place_89_1, next[94]),
                    ),
                beta_rate_dot_of_place_1
                    .mul_add(
                        beta_rate_dot_of_place_92_last,
                        beta_rate_dot_of_place_last
                            .mul_add(beta_rate_dot_of_place_92_1, next[95]),
                    ),
                beta_rate_dot_of_place_91_1
                    .mul_add(
                        beta_rate_dot_of_place_92_last,
                        beta_rate_dot_of_place_91_last
                            .mul_add(beta_rate_dot_of_place_92_1, next[96]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_beta_rate_3_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_beta_rate_3_1, next[97]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_beta_rate_6_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_beta_rate_6_1, next[98]),
                    ),
                d1_of_place_19_1
                    .mul_add(
                        beta_rate_dot_2_last,
                        d1_of_place_19_last.mul_add(beta_rate_dot_2_1, next[99]),
                    ),
                beta_rate_1
                    .mul_add(
                        theta_of_place_last,
                        beta_rate_last.mul_add(theta_of_place_1, next[100]),
                    ),
                beta_rate_1
                    .mul_add(
                        sin_theta_last,
                        beta_rate_last.mul_add(sin_theta_1, next[101]),
                    ),
                cos_angle_1
                    .mul_add(
                        gamma_of_beta_rate_last,
                        cos_angle_last.mul_add(gamma_of_beta_rate_1, next[102]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        cos_phi_inv_sin_angle_2_last,
                        gamma_of_beta_rate_last
                            .mul_add(cos_phi_inv_sin_angle_2_1, next[103]),
                    ),
                cos_phi_1
                    .mul_add(
                        phi_of_place_last,
                        cos_phi_last.mul_add(phi_of_place_1, next[104]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        phi_of_place_last,
                        gamma_of_beta_rate_last.mul_add(phi_of_place_1, next[105]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        beta_rate_dot_of_place_6_last,
                        gamma_of_beta_rate_last
                            .mul_add(beta_rate_dot_of_place_6_1, next[106]),
                    ),
                cos_omega_1
                    .mul_add(
                        omega_of_place_last,
                        cos_omega_last.mul_add(omega_of_place_1, next[107]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        omega_of_place_last,
                        gamma_of_beta_rate_last.mul_add(omega_of_place_1, next[108]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[2] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[3] * over_k);
        // sin_omega = sin(omega)
        let sin_omega = omega.mul_add(cos_omega_0, sums[4] * over_k);
        // cos_omega = cos(omega)
        let cos_omega = -omega.mul_add(sin_omega_0, sums[5] * over_k);
        // beta_minus_gamma = beta - gamma
        let beta_minus_gamma = beta - gamma;
        // d1_of_place = beta + theta - gamma
        let d1_of_place = beta + theta - gamma;
        // sin_angle = sin(d1_of_place)
        let sin_angle = d1_of_place.mul_add(cos_angle_0, sums[6] * over_k);
        // cos_angle = cos(d1_of_place)
        let cos_angle = -d1_of_place.mul_add(sin_angle_0, sums[7] * over_k);
        // sin_beta_minus_gamma = sin(beta_minus_gamma)
        let sin_beta_minus_gamma = beta_minus_gamma
            .mul_add(cos_beta_minus_gamma_0, sums[8] * over_k);
        // cos_beta_minus_gamma = cos(beta_minus_gamma)
        let cos_beta_minus_gamma = -beta_minus_gamma
            .mul_add(sin_beta_minus_gamma_0, sums[9] * over_k);
        // d1_of_place_2 = gamma - delta - phi
        let d1_of_place_2 = gamma - delta - phi;
        // sin_angle_2 = sin(d1_of_place_2)
        let sin_angle_2 = d1_of_place_2.mul_add(cos_angle_2_0, sums[10] * over_k);
        // cos_angle_2 = cos(d1_of_place_2)
        let cos_angle_2 = -d1_of_place_2.mul_add(sin_angle_2_0, sums[11] * over_k);
        // gamma_minus_delta = gamma - delta
        let gamma_minus_delta = gamma - delta;
        // sin_gamma_minus_delta = sin(gamma_minus_delta)
        let sin_gamma_minus_delta = gamma_minus_delta
            .mul_add(cos_gamma_minus_delta_0, sums[12] * over_k);
        // cos_gamma_minus_delta = cos(gamma_minus_delta)
        let cos_gamma_minus_delta = -gamma_minus_delta
            .mul_add(sin_gamma_minus_delta_0, sums[13] * over_k);
        // d1_of_place_3 = gamma - epsilon - omega
        let d1_of_place_3 = gamma - epsilon - omega;
        // sin_angle_3 = sin(d1_of_place_3)
        let sin_angle_3 = d1_of_place_3.mul_add(cos_angle_3_0, sums[14] * over_k);
        // cos_angle_3 = cos(d1_of_place_3)
        let cos_angle_3 = -d1_of_place_3.mul_add(sin_angle_3_0, sums[15] * over_k);
        // gamma_minus_epsilon = gamma - epsilon
        let gamma_minus_epsilon = gamma - epsilon;
        // sin_gamma_minus_epsilon = sin(gamma_minus_epsilon)
        let sin_gamma_minus_epsilon = gamma_minus_epsilon
            .mul_add(cos_gamma_minus_epsilon_0, sums[16] * over_k);
        // cos_gamma_minus_epsilon = cos(gamma_minus_epsilon)
        let cos_gamma_minus_epsilon = -gamma_minus_epsilon
            .mul_add(sin_gamma_minus_epsilon_0, sums[17] * over_k);
        // cos_beta_minus_gamma_sq = cos_beta_minus_gamma*cos_beta_minus_gamma
        let cos_beta_minus_gamma_sq = cos_beta_minus_gamma
            .mul_add(cos_beta_minus_gamma_0 + cos_beta_minus_gamma_0, sums[18]);
        // d1_of_place_4 = cos_theta*cos_beta_minus_gamma
        let d1_of_place_4 = cos_beta_minus_gamma
            .mul_add(cos_theta_0, cos_theta.mul_add(cos_beta_minus_gamma_0, sums[19]));
        // sin_phi_sin_angle_2 = sin_phi*sin_angle_2
        let sin_phi_sin_angle_2 = sin_angle_2
            .mul_add(sin_phi_0, sin_phi.mul_add(sin_angle_2_0, sums[20]));
        // d1_of_place_5 = weight*cos_gamma_minus_delta + weight_2*sin_phi_sin_angle_2
        let d1_of_place_5 = sin_phi_sin_angle_2
            .mul_add(weight_2, weight * cos_gamma_minus_delta);
        // d1_of_place_6 = cos_gamma_minus_delta*d1_of_place_5
        let d1_of_place_6 = d1_of_place_5
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(d1_of_place_5_0, sums[21]),
            );
        // sin_angle_2_sq = sin_angle_2*sin_angle_2
        let sin_angle_2_sq = sin_angle_2
            .mul_add(sin_angle_2_0 + sin_angle_2_0, sums[22]);
        // d1_of_place_7 = d1_of_place_6 + weight_3*sin_angle_2_sq
        let d1_of_place_7 = weight_3 * sin_angle_2_sq + d1_of_place_6;
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[23]);
        // d1_of_place_8 = d1_of_place_7/cos_phi_sq
        let d1_of_place_8 = d1_of_place_7
            .mul_add(
                over_cos_phi_sq,
                -(cos_phi_sq.mul_add(d1_of_place_8_0, sums[24]) * over_cos_phi_sq),
            );
        // sin_omega_cos_angle_3 = sin_omega*cos_angle_3
        let sin_omega_cos_angle_3 = cos_angle_3
            .mul_add(sin_omega_0, sin_omega.mul_add(cos_angle_3_0, sums[25]));
        // d1_of_place_9 = weight_4*sin_gamma_minus_epsilon + weight_5*sin_omega_cos_angle_3
        let d1_of_place_9 = sin_omega_cos_angle_3
            .mul_add(weight_5, weight_4 * sin_gamma_minus_epsilon);
        // d1_of_place_10 = sin_gamma_minus_epsilon*d1_of_place_9
        let d1_of_place_10 = d1_of_place_9
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(d1_of_place_9_0, sums[26]),
            );
        // cos_angle_3_sq = cos_angle_3*cos_angle_3
        let cos_angle_3_sq = cos_angle_3
            .mul_add(cos_angle_3_0 + cos_angle_3_0, sums[27]);
        // d1_of_place_11 = d1_of_place_10 + weight_6*cos_angle_3_sq
        let d1_of_place_11 = weight_6 * cos_angle_3_sq + d1_of_place_10;
        // cos_omega_sq = cos_omega*cos_omega
        let cos_omega_sq = cos_omega.mul_add(cos_omega_0 + cos_omega_0, sums[28]);
        // d1_of_place_12 = d1_of_place_11/cos_omega_sq
        let d1_of_place_12 = d1_of_place_11
            .mul_add(
                over_cos_omega_sq,
                -(cos_omega_sq.mul_add(d1_of_place_12_0, sums[29]) * over_cos_omega_sq),
            );
        // d1_of_place_13 = weight_7 + d1_of_place_8 + d1_of_place_12
        let d1_of_place_13 = d1_of_place_8 + d1_of_place_12;
        // sin_theta_sq = sin_theta*sin_theta
        let sin_theta_sq = sin_theta.mul_add(sin_theta_0 + sin_theta_0, sums[30]);
        // d1_of_place_14 = d1_of_place_13*sin_theta_sq
        let d1_of_place_14 = d1_of_place_13
            .mul_add(sin_theta_sq_0, sin_theta_sq.mul_add(d1_of_place_13_0, sums[31]));
        // d1_of_place_15 = i2_plus_m2_da_2_by_d_2*cos_beta_minus_gamma_sq + d1_of_place_14
        let d1_of_place_15 = i2_plus_m2_da_2_by_d_2 * cos_beta_minus_gamma_sq + d1_of_place_14;
        // d1_of_place_16 = d1_of_place_15/cos_angle
        let d1_of_place_16 = d1_of_place_15
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(d1_of_place_16_0, sums[32]) * over_cos_angle),
            );
        // d1_of_place_17 = weight_8*d1_of_place_4 - d1_of_place_16
        let d1_of_place_17 = weight_8 * d1_of_place_4 - d1_of_place_16;
        // d1_of_place_18 = d1_of_place_17/cos_angle
        let d1_of_place_18 = d1_of_place_17
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(d1_of_place_18_0, sums[33]) * over_cos_angle),
            );
        // d1_of_place_19 = weight_9 + minus_rr_2*d1_of_place_18
        let d1_of_place_19 = minus_rr_2 * d1_of_place_18;
        // sin_gamma = sin(gamma)
        let sin_gamma = gamma.mul_add(cos_gamma_0, sums[34] * over_k);
        // cos_gamma = cos(gamma)
        let cos_gamma = -gamma.mul_add(sin_gamma_0, sums[35] * over_k);
        // beta_rate_dot_of_place = weight_10 + weight_11*sin_gamma + weight_12*cos_gamma
        let beta_rate_dot_of_place = cos_gamma.mul_add(weight_12, weight_11 * sin_gamma);
        // beta_rate_dot_of_place_2 = sqrt(beta_rate_dot_of_place)
        let beta_rate_dot_of_place_2 = (beta_rate_dot_of_place - sums[36])
            * over_twice_beta_rate_dot_of_place_2;
        // beta_rate_dot_of_place_3 = weight_13*cos_gamma_minus_delta + minus_1_by_zt*sin_angle_2
        let beta_rate_dot_of_place_3 = sin_angle_2
            .mul_add(minus_1_by_zt, weight_13 * cos_gamma_minus_delta);
        // beta_rate_dot_of_place_4 = weight_14*cos_angle_3 + minus_1_by_zf*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_4 = sin_gamma_minus_epsilon
            .mul_add(minus_1_by_zf, weight_14 * cos_angle_3);
        // cos_phi_inv_sin_angle_2 = sin_angle_2/cos_phi
        let cos_phi_inv_sin_angle_2 = sin_angle_2
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(cos_phi_inv_sin_angle_2_0, sums[37]) * over_cos_phi),
            );
        // beta_rate_dot_of_place_5 = weight_3*cos_phi_inv_sin_angle_2 +
        //   m4_ea_by_e_minus_1*sin_gamma_minus_delta
        let beta_rate_dot_of_place_5 = cos_phi_inv_sin_angle_2
            .mul_add(weight_3, m4_ea_by_e_minus_1 * sin_gamma_minus_delta);
        // beta_rate_dot_of_place_6 = cos_angle_3/cos_omega
        let beta_rate_dot_of_place_6 = cos_angle_3
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_6_0, sums[38]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_7 = weight_6*beta_rate_dot_of_place_6 +
        //   m6_fa_by_zf_minus_1*cos_gamma_minus_epsilon
        let beta_rate_dot_of_place_7 = beta_rate_dot_of_place_6
            .mul_add(weight_6, m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon);
        // sin_angle_cos_angle_inv = sin_angle/cos_angle
        let sin_angle_cos_angle_inv = cos_angle
            .mul_add(
                -(sin_angle_cos_angle_inv_0 * over_cos_angle),
                (sin_angle - sums[39]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_8 = cos_theta*sin_beta_minus_gamma
        let beta_rate_dot_of_place_8 = sin_beta_minus_gamma
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_beta_minus_gamma_0, sums[40]));
        // beta_rate_dot_of_place_9 = weight_15 + weight_16*sin_phi
        let beta_rate_dot_of_place_9 = weight_16 * sin_phi;
        // beta_rate_dot_of_place_10 = sin_angle_2*beta_rate_dot_of_place_9
        let beta_rate_dot_of_place_10 = beta_rate_dot_of_place_9
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_9_0, sums[41]),
            );
        // beta_rate_dot_of_place_11 = weight_17 + weight_18*sin_phi
        let beta_rate_dot_of_place_11 = weight_18 * sin_phi;
        // beta_rate_dot_of_place_12 = cos_gamma_minus_delta*beta_rate_dot_of_place_11
        let beta_rate_dot_of_place_12 = beta_rate_dot_of_place_11
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_11_0, sums[42]),
            );
        // beta_rate_dot_of_place_13 = beta_rate_dot_of_place_10 - beta_rate_dot_of_place_12
        let beta_rate_dot_of_place_13 = beta_rate_dot_of_place_10 - beta_rate_dot_of_place_12;
        // beta_rate_dot_of_place_14 = sin_angle_2*beta_rate_dot_of_place_13
        let beta_rate_dot_of_place_14 = beta_rate_dot_of_place_13
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_13_0, sums[43]),
            );
        // cos_gamma_minus_delta_sq = cos_gamma_minus_delta*cos_gamma_minus_delta
        let cos_gamma_minus_delta_sq = cos_gamma_minus_delta
            .mul_add(cos_gamma_minus_delta_0 + cos_gamma_minus_delta_0, sums[44]);
        // beta_rate_dot_of_place_15 = beta_rate_dot_of_place_14 + weight_19*cos_gamma_minus_delta_sq
        let beta_rate_dot_of_place_15 = weight_19 * cos_gamma_minus_delta_sq
            + beta_rate_dot_of_place_14;
        // beta_rate_dot_of_place_16 = beta_rate_dot_of_place_15/cos_phi
        let beta_rate_dot_of_place_16 = beta_rate_dot_of_place_15
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(beta_rate_dot_of_place_16_0, sums[45]) * over_cos_phi),
            );
        // beta_rate_dot_of_place_17 = cos_gamma_minus_delta*cos_angle_2
        let beta_rate_dot_of_place_17 = cos_angle_2
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(cos_angle_2_0, sums[46]),
            );
        // beta_rate_dot_of_place_18 = beta_rate_dot_of_place_16 +
        //   m4_ea_by_e_minus_1_by_e*beta_rate_dot_of_place_17
        let beta_rate_dot_of_place_18 = m4_ea_by_e_minus_1_by_e
            * beta_rate_dot_of_place_17 + beta_rate_dot_of_place_16;
        // beta_rate_dot_of_place_19 = weight_20*sin_gamma_minus_delta + weight_21*cos_angle_2
        let beta_rate_dot_of_place_19 = cos_angle_2
            .mul_add(weight_21, weight_20 * sin_gamma_minus_delta);
        // sin_phi_cos_phi_inv = sin_phi/cos_phi
        let sin_phi_cos_phi_inv = cos_phi
            .mul_add(
                -(sin_phi_cos_phi_inv_0 * over_cos_phi),
                (sin_phi - sums[47]) * over_cos_phi,
            );
        // beta_rate_dot_of_place_20 = beta_rate_dot_of_place_5*sin_phi_cos_phi_inv
        let beta_rate_dot_of_place_20 = beta_rate_dot_of_place_5
            .mul_add(
                sin_phi_cos_phi_inv_0,
                sin_phi_cos_phi_inv.mul_add(beta_rate_dot_of_place_5_0, sums[48]),
            );
        // beta_rate_dot_of_place_21 = weight_22*sin_angle_cos_angle_inv +
        //   weight_23*beta_rate_dot_of_place_20
        let beta_rate_dot_of_place_21 = beta_rate_dot_of_place_20
            .mul_add(weight_23, weight_22 * sin_angle_cos_angle_inv);
        // beta_rate_dot_of_place_22 = sin_angle_2*beta_rate_dot_of_place_21
        let beta_rate_dot_of_place_22 = beta_rate_dot_of_place_21
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_21_0, sums[49]),
            );
        // beta_rate_dot_of_place_23 = sin_phi*sin_gamma_minus_delta
        let beta_rate_dot_of_place_23 = sin_gamma_minus_delta
            .mul_add(sin_phi_0, sin_phi.mul_add(sin_gamma_minus_delta_0, sums[50]));
        // beta_rate_dot_of_place_24 = beta_rate_dot_of_place_22 + weight_24*cos_angle_2 +
        //   m4_1_minus_ea_by_e_by_ss*beta_rate_dot_of_place_23
        let beta_rate_dot_of_place_24 = beta_rate_dot_of_place_23
            .mul_add(m4_1_minus_ea_by_e_by_ss, weight_24 * cos_angle_2) + beta_rate_dot_of_place_22;
        // beta_rate_dot_of_place_25 = sin_angle_2*beta_rate_dot_of_place_24
        let beta_rate_dot_of_place_25 = beta_rate_dot_of_place_24
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_24_0, sums[51]),
            );
        // beta_rate_dot_of_place_26 = weight_25 + weight_26*sin_omega
        let beta_rate_dot_of_place_26 = weight_26 * sin_omega;
        // beta_rate_dot_of_place_27 = cos_angle_3*beta_rate_dot_of_place_26
        let beta_rate_dot_of_place_27 = beta_rate_dot_of_place_26
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_26_0, sums[52]),
            );
        // beta_rate_dot_of_place_28 = weight_27 + weight_28*sin_omega
        let beta_rate_dot_of_place_28 = weight_28 * sin_omega;
        // beta_rate_dot_of_place_29 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_28
        let beta_rate_dot_of_place_29 = beta_rate_dot_of_place_28
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_28_0, sums[53]),
            );
        // beta_rate_dot_of_place_30 = beta_rate_dot_of_place_27 - beta_rate_dot_of_place_29
        let beta_rate_dot_of_place_30 = beta_rate_dot_of_place_27 - beta_rate_dot_of_place_29;
        // beta_rate_dot_of_place_31 = cos_angle_3*beta_rate_dot_of_place_30
        let beta_rate_dot_of_place_31 = beta_rate_dot_of_place_30
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_30_0, sums[54]),
            );
        // beta_rate_dot_of_place_32 = sin_gamma_minus_epsilon*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_32 = sin_gamma_minus_epsilon
            .mul_add(sin_gamma_minus_epsilon_0 + sin_gamma_minus_epsilon_0, sums[55]);
        // beta_rate_dot_of_place_33 = beta_rate_dot_of_place_31 + weight_29*beta_rate_dot_of_place_32
        let beta_rate_dot_of_place_33 = weight_29 * beta_rate_dot_of_place_32
            + beta_rate_dot_of_place_31;
        // beta_rate_dot_of_place_34 = beta_rate_dot_of_place_33/cos_omega
        let beta_rate_dot_of_place_34 = beta_rate_dot_of_place_33
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_34_0, sums[56]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_35 = sin_gamma_minus_epsilon*sin_angle_3
        let beta_rate_dot_of_place_35 = sin_angle_3
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(sin_angle_3_0, sums[57]),
            );
        // beta_rate_dot_of_place_36 = beta_rate_dot_of_place_34 + weight_30*beta_rate_dot_of_place_35
        let beta_rate_dot_of_place_36 = weight_30 * beta_rate_dot_of_place_35
            + beta_rate_dot_of_place_34;
        // beta_rate_dot_of_place_37 = weight_31*cos_gamma_minus_epsilon + weight_32*sin_angle_3
        let beta_rate_dot_of_place_37 = sin_angle_3
            .mul_add(weight_32, weight_31 * cos_gamma_minus_epsilon);
        // sin_omega_cos_omega_inv = sin_omega/cos_omega
        let sin_omega_cos_omega_inv = cos_omega
            .mul_add(
                -(sin_omega_cos_omega_inv_0 * over_cos_omega),
                (sin_omega - sums[58]) * over_cos_omega,
            );
        // beta_rate_dot_of_place_38 = beta_rate_dot_of_place_7*sin_omega_cos_omega_inv
        let beta_rate_dot_of_place_38 = beta_rate_dot_of_place_7
            .mul_add(
                sin_omega_cos_omega_inv_0,
                sin_omega_cos_omega_inv.mul_add(beta_rate_dot_of_place_7_0, sums[59]),
            );
        // beta_rate_dot_of_place_39 = weight_33*sin_angle_cos_angle_inv +
        //   weight_14*beta_rate_dot_of_place_38
        let beta_rate_dot_of_place_39 = beta_rate_dot_of_place_38
            .mul_add(weight_14, weight_33 * sin_angle_cos_angle_inv);
        // beta_rate_dot_of_place_40 = cos_angle_3*beta_rate_dot_of_place_39
        let beta_rate_dot_of_place_40 = beta_rate_dot_of_place_39
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_39_0, sums[60]),
            );
        // beta_rate_dot_of_place_41 = sin_omega*cos_gamma_minus_epsilon
        let beta_rate_dot_of_place_41 = cos_gamma_minus_epsilon
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(cos_gamma_minus_epsilon_0, sums[61]),
            );
        // beta_rate_dot_of_place_42 = beta_rate_dot_of_place_40 + weight_33*sin_angle_3 +
        //   weight_34*beta_rate_dot_of_place_41
        let beta_rate_dot_of_place_42 = beta_rate_dot_of_place_41
            .mul_add(weight_34, weight_33 * sin_angle_3) + beta_rate_dot_of_place_40;
        // beta_rate_dot_of_place_43 = cos_angle_3*beta_rate_dot_of_place_42
        let beta_rate_dot_of_place_43 = beta_rate_dot_of_place_42
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_42_0, sums[62]),
            );
        // beta_rate_dot_of_place_44 = cos_beta_minus_gamma*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_44 = sin_angle_cos_angle_inv
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(sin_angle_cos_angle_inv_0, sums[63]),
            );
        // beta_rate_dot_of_place_45 = d1_of_place_13*beta_rate_dot_of_place_44
        let beta_rate_dot_of_place_45 = d1_of_place_13
            .mul_add(
                beta_rate_dot_of_place_44_0,
                beta_rate_dot_of_place_44.mul_add(d1_of_place_13_0, sums[64]),
            );
        // beta_rate_dot_of_place_46 = weight_7 + d1_of_place_8 + d1_of_place_12 + m2_da_by_ss*sin_angle
        let beta_rate_dot_of_place_46 = m2_da_by_ss * sin_angle + d1_of_place_8 + d1_of_place_12;
        // beta_rate_dot_of_place_47 = cos_theta*beta_rate_dot_of_place_46
        let beta_rate_dot_of_place_47 = beta_rate_dot_of_place_46
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_46_0, sums[65]),
            );
        // beta_rate_dot_of_place_48 = beta_rate_dot_of_place_47 + weight_35*beta_rate_dot_of_place_44 +
        //   i2_plus_m2_da_2_by_d_ss*sin_beta_minus_gamma
        let beta_rate_dot_of_place_48 = beta_rate_dot_of_place_44
            .mul_add(weight_35, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma)
            + beta_rate_dot_of_place_47;
        // beta_rate_dot_of_place_49 = cos_beta_minus_gamma*beta_rate_dot_of_place_48
        let beta_rate_dot_of_place_49 = beta_rate_dot_of_place_48
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(beta_rate_dot_of_place_48_0, sums[66]),
            );
        // beta_rate_dot_of_place_50 = weight_7 + d1_of_place_8 + d1_of_place_12 +
        //   m2_da_rr_by_d_ss*sin_beta_minus_gamma
        let beta_rate_dot_of_place_50 = m2_da_rr_by_d_ss * sin_beta_minus_gamma
            + d1_of_place_8 + d1_of_place_12;
        // beta_rate_dot_of_place_51 = cos_theta*beta_rate_dot_of_place_50
        let beta_rate_dot_of_place_51 = beta_rate_dot_of_place_50
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_50_0, sums[67]),
            );
        // beta_rate_dot_of_place_52 = cos_beta_minus_gamma/cos_angle
        let beta_rate_dot_of_place_52 = cos_angle
            .mul_add(
                -(beta_rate_dot_of_place_52_0 * over_cos_angle),
                (cos_beta_minus_gamma - sums[68]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_53 = i2_plus_m2_da_2_by_d*beta_rate_dot_of_place_52 +
        //   minus_m2_da*cos_theta
        let beta_rate_dot_of_place_53 = beta_rate_dot_of_place_52
            .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta);
        // beta_rate_dot_of_place_54 = beta_rate_dot_of_place_53*beta_rate_dot_of_place_44
        let beta_rate_dot_of_place_54 = beta_rate_dot_of_place_44
            .mul_add(
                beta_rate_dot_of_place_53_0,
                beta_rate_dot_of_place_53.mul_add(beta_rate_dot_of_place_44_0, sums[69]),
            );
        // beta_rate_dot_of_place_55 = i2_plus_m2_da_2*sin_beta_minus_gamma +
        //   minus_rr*beta_rate_dot_of_place_54
        let beta_rate_dot_of_place_55 = beta_rate_dot_of_place_54
            .mul_add(minus_rr, i2_plus_m2_da_2 * sin_beta_minus_gamma);
        // beta_rate_dot_of_place_56 = beta_rate_dot_of_place_55*beta_rate_dot_of_place_52
        let beta_rate_dot_of_place_56 = beta_rate_dot_of_place_55
            .mul_add(
                beta_rate_dot_of_place_52_0,
                beta_rate_dot_of_place_52.mul_add(beta_rate_dot_of_place_55_0, sums[70]),
            );
        // beta_rate_dot_of_place_57 = m2_da*beta_rate_dot_of_place_8 +
        //   minus_1_by_d*beta_rate_dot_of_place_56
        let beta_rate_dot_of_place_57 = beta_rate_dot_of_place_56
            .mul_add(minus_1_by_d, m2_da * beta_rate_dot_of_place_8);
        // beta_rate_sq = beta_rate*beta_rate
        let beta_rate_sq = beta_rate.mul_add(beta_rate_0 + beta_rate_0, sums[71]);
        // beta_rate_dot_of_beta_rate = beta_rate_dot_of_place_57*beta_rate_sq
        let beta_rate_dot_of_beta_rate = beta_rate_dot_of_place_57
            .mul_add(
                beta_rate_sq_0,
                beta_rate_sq.mul_add(beta_rate_dot_of_place_57_0, sums[72]),
            );
        // beta_rate_dot_of_place_58 = sin_omega*beta_rate_dot_of_place_36
        let beta_rate_dot_of_place_58 = beta_rate_dot_of_place_36
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(beta_rate_dot_of_place_36_0, sums[73]),
            );
        // beta_rate_dot_of_place_59 = cos_angle_3*beta_rate_dot_of_place_37
        let beta_rate_dot_of_place_59 = beta_rate_dot_of_place_37
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_37_0, sums[74]),
            );
        // beta_rate_dot_of_place_60 = beta_rate_dot_of_place_58 - beta_rate_dot_of_place_59
        let beta_rate_dot_of_place_60 = -beta_rate_dot_of_place_59 + beta_rate_dot_of_place_58;
        // beta_rate_dot_of_place_61 = beta_rate_dot_of_place_60/cos_omega
        let beta_rate_dot_of_place_61 = beta_rate_dot_of_place_60
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_61_0, sums[75]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_62 = weight_5*sin_omega_cos_angle_3 + weight_36*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_62 = sin_omega_cos_angle_3
            .mul_add(weight_5, weight_36 * sin_gamma_minus_epsilon);
        // beta_rate_dot_of_place_63 = beta_rate_dot_of_place_62*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_63 = beta_rate_dot_of_place_62
            .mul_add(
                sin_angle_cos_angle_inv_0,
                sin_angle_cos_angle_inv.mul_add(beta_rate_dot_of_place_62_0, sums[76]),
            );
        // sin_omega_sin_angle_3 = sin_omega*sin_angle_3
        let sin_omega_sin_angle_3 = sin_angle_3
            .mul_add(sin_omega_0, sin_omega.mul_add(sin_angle_3_0, sums[77]));
        // beta_rate_dot_of_place_64 = cos_angle_3*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_64 = beta_rate_dot_of_place_4
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_4_0, sums[78]),
            );
        // beta_rate_dot_of_place_65 = weight_37*cos_gamma_minus_epsilon + beta_rate_dot_of_place_61 +
        //   minus_1_by_ss*beta_rate_dot_of_place_63 + weight_34*sin_omega_sin_angle_3 +
        //   m6_1_minus_fa_by_zf*beta_rate_dot_of_place_64
        let beta_rate_dot_of_place_65 = beta_rate_dot_of_place_63
            .mul_add(
                minus_1_by_ss,
                beta_rate_dot_of_place_64
                    .mul_add(
                        m6_1_minus_fa_by_zf,
                        sin_omega_sin_angle_3
                            .mul_add(weight_34, weight_37 * cos_gamma_minus_epsilon),
                    ),
            ) + beta_rate_dot_of_place_61;
        // beta_rate_dot_of_place_66 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_65
        let beta_rate_dot_of_place_66 = beta_rate_dot_of_place_65
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_65_0, sums[79]),
            );
        // beta_rate_dot_of_place_67 = beta_rate_dot_of_place_43 - beta_rate_dot_of_place_66
        let beta_rate_dot_of_place_67 = beta_rate_dot_of_place_43 - beta_rate_dot_of_place_66;
        // beta_rate_dot_of_place_68 = beta_rate_dot_of_place_67/cos_omega_sq
        let beta_rate_dot_of_place_68 = beta_rate_dot_of_place_67
            .mul_add(
                over_cos_omega_sq,
                -(cos_omega_sq.mul_add(beta_rate_dot_of_place_68_0, sums[80]) * over_cos_omega_sq),
            );
        // beta_rate_dot_of_place_69 = sin_phi*beta_rate_dot_of_place_18
        let beta_rate_dot_of_place_69 = beta_rate_dot_of_place_18
            .mul_add(sin_phi_0, sin_phi.mul_add(beta_rate_dot_of_place_18_0, sums[81]));
        // beta_rate_dot_of_place_70 = sin_angle_2*beta_rate_dot_of_place_19
        let beta_rate_dot_of_place_70 = beta_rate_dot_of_place_19
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_19_0, sums[82]),
            );
        // beta_rate_dot_of_place_71 = beta_rate_dot_of_place_69 + beta_rate_dot_of_place_70
        let beta_rate_dot_of_place_71 = beta_rate_dot_of_place_70 + beta_rate_dot_of_place_69;
        // beta_rate_dot_of_place_72 = beta_rate_dot_of_place_71/cos_phi
        let beta_rate_dot_of_place_72 = beta_rate_dot_of_place_71
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(beta_rate_dot_of_place_72_0, sums[83]) * over_cos_phi),
            );
        // beta_rate_dot_of_place_73 = weight_38*sin_phi_sin_angle_2 + weight_39*cos_gamma_minus_delta
        let beta_rate_dot_of_place_73 = sin_phi_sin_angle_2
            .mul_add(weight_38, weight_39 * cos_gamma_minus_delta);
        // beta_rate_dot_of_place_74 = beta_rate_dot_of_place_73*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_74 = beta_rate_dot_of_place_73
            .mul_add(
                sin_angle_cos_angle_inv_0,
                sin_angle_cos_angle_inv.mul_add(beta_rate_dot_of_place_73_0, sums[84]),
            );
        // sin_phi_cos_angle_2 = sin_phi*cos_angle_2
        let sin_phi_cos_angle_2 = cos_angle_2
            .mul_add(sin_phi_0, sin_phi.mul_add(cos_angle_2_0, sums[85]));
        // beta_rate_dot_of_place_75 = sin_angle_2*beta_rate_dot_of_place_3
        let beta_rate_dot_of_place_75 = beta_rate_dot_of_place_3
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_3_0, sums[86]),
            );
        // beta_rate_dot_of_place_76 = weight_40*sin_gamma_minus_delta - beta_rate_dot_of_place_72 +
        //   minus_1_by_ss*beta_rate_dot_of_place_74 + m4_ea_by_e_minus_1_by_ss*sin_phi_cos_angle_2 +
        //   m4_ea_by_e_minus_1*beta_rate_dot_of_place_75
        let beta_rate_dot_of_place_76 = beta_rate_dot_of_place_74
            .mul_add(
                minus_1_by_ss,
                beta_rate_dot_of_place_75
                    .mul_add(
                        m4_ea_by_e_minus_1,
                        sin_phi_cos_angle_2
                            .mul_add(
                                m4_ea_by_e_minus_1_by_ss,
                                weight_40 * sin_gamma_minus_delta,
                            ),
                    ),
            ) - beta_rate_dot_of_place_72;
        // beta_rate_dot_of_place_77 = cos_gamma_minus_delta*beta_rate_dot_of_place_76
        let beta_rate_dot_of_place_77 = beta_rate_dot_of_place_76
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_76_0, sums[87]),
            );
        // beta_rate_dot_of_place_78 = beta_rate_dot_of_place_25 + beta_rate_dot_of_place_77
        let beta_rate_dot_of_place_78 = beta_rate_dot_of_place_25 + beta_rate_dot_of_place_77;
        // beta_rate_dot_of_place_79 = beta_rate_dot_of_place_78/cos_phi_sq
        let beta_rate_dot_of_place_79 = beta_rate_dot_of_place_78
            .mul_add(
                over_cos_phi_sq,
                -(cos_phi_sq.mul_add(beta_rate_dot_of_place_79_0, sums[88]) * over_cos_phi_sq),
            );
        // beta_rate_dot_of_place_80 = weight_41*sin_angle_cos_angle_inv + beta_rate_dot_of_place_68 +
        //   beta_rate_dot_of_place_79
        let beta_rate_dot_of_place_80 = weight_41 * sin_angle_cos_angle_inv
            + beta_rate_dot_of_place_68 + beta_rate_dot_of_place_79;
        // beta_rate_dot_of_place_81 = sin_theta*beta_rate_dot_of_place_80
        let beta_rate_dot_of_place_81 = beta_rate_dot_of_place_80
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_80_0, sums[89]),
            );
        // beta_rate_dot_of_place_82 = weight_42*beta_rate_dot_of_place_45 - beta_rate_dot_of_place_81
        let beta_rate_dot_of_place_82 = weight_42 * beta_rate_dot_of_place_45
            - beta_rate_dot_of_place_81;
        // beta_rate_dot_of_place_83 = sin_theta*beta_rate_dot_of_place_82
        let beta_rate_dot_of_place_83 = beta_rate_dot_of_place_82
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_82_0, sums[90]),
            );
        // beta_rate_dot_of_place_84 = weight_42*beta_rate_dot_of_place_49 + beta_rate_dot_of_place_83
        let beta_rate_dot_of_place_84 = weight_42 * beta_rate_dot_of_place_49
            + beta_rate_dot_of_place_83;
        // beta_rate_dot_of_place_85 = beta_rate_dot_of_place_84/cos_angle
        let beta_rate_dot_of_place_85 = beta_rate_dot_of_place_84
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_85_0, sums[91]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_86 = m2_da_rr_by_d_2*cos_beta_minus_gamma_sq - beta_rate_dot_of_place_51
        //   + rr*beta_rate_dot_of_place_85
        let beta_rate_dot_of_place_86 = beta_rate_dot_of_place_85
            .mul_add(
                rr,
                m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq - beta_rate_dot_of_place_51,
            );
        // beta_rate_dot_of_place_87 = beta_rate_dot_of_place_86/cos_angle
        let beta_rate_dot_of_place_87 = beta_rate_dot_of_place_86
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_87_0, sums[92]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_88 = m2_da_by_d*cos_beta_minus_gamma - beta_rate_dot_of_place_87
        let beta_rate_dot_of_place_88 = m2_da_by_d * cos_beta_minus_gamma
            - beta_rate_dot_of_place_87;
        // beta_rate_dot_of_beta_rate_2 = beta_rate_dot_of_place_88*beta_rate_sq
        let beta_rate_dot_of_beta_rate_2 = beta_rate_dot_of_place_88
            .mul_add(
                beta_rate_sq_0,
                beta_rate_sq.mul_add(beta_rate_dot_of_place_88_0, sums[93]),
            );
        // beta_rate_dot_of_place_89 = weight_43*cos_gamma + weight_44*sin_gamma
        let beta_rate_dot_of_place_89 = sin_gamma
            .mul_add(weight_44, weight_43 * cos_gamma);
        // beta_rate_dot_of_place_90 = beta_rate_dot_of_place_2*beta_rate_dot_of_place_89
        let beta_rate_dot_of_place_90 = beta_rate_dot_of_place_2
            .mul_add(
                beta_rate_dot_of_place_89_0,
                beta_rate_dot_of_place_89.mul_add(beta_rate_dot_of_place_2_0, sums[94]),
            );
        // beta_rate_dot_of_place_91 = beta_rate_dot_of_place_90 + weight_45*cos_gamma +
        //   weight_46*sin_gamma
        let beta_rate_dot_of_place_91 = sin_gamma
            .mul_add(weight_46, weight_45 * cos_gamma) + beta_rate_dot_of_place_90;
        // beta_rate_dot_of_place_92 = beta_rate_dot_of_place_2/beta_rate_dot_of_place
        let beta_rate_dot_of_place_92 = beta_rate_dot_of_place_2
            .mul_add(
                over_beta_rate_dot_of_place,
                -(beta_rate_dot_of_place.mul_add(beta_rate_dot_of_place_92_0, sums[95])
                    * over_beta_rate_dot_of_place),
            );
        // beta_rate_dot_of_place_93 = beta_rate_dot_of_place_91*beta_rate_dot_of_place_92
        let beta_rate_dot_of_place_93 = beta_rate_dot_of_place_91
            .mul_add(
                beta_rate_dot_of_place_92_0,
                beta_rate_dot_of_place_92.mul_add(beta_rate_dot_of_place_91_0, sums[96]),
            );
        // beta_rate_dot_of_beta_rate_3 = rr*beta_rate_dot_of_beta_rate_2 +
        //   minus_c0_by_ss*beta_rate_dot_of_place_93
        let beta_rate_dot_of_beta_rate_3 = beta_rate_dot_of_beta_rate_2
            .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_93);
        // beta_rate_dot_of_beta_rate_4 = sin_theta*beta_rate_dot_of_beta_rate_3
        let beta_rate_dot_of_beta_rate_4 = beta_rate_dot_of_beta_rate_3
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_beta_rate_3_0, sums[97]),
            );
        // beta_rate_dot_of_beta_rate_5 = rr_by_d*beta_rate_dot_of_beta_rate - beta_rate_dot_of_beta_rate_4
        let beta_rate_dot_of_beta_rate_5 = rr_by_d * beta_rate_dot_of_beta_rate
            - beta_rate_dot_of_beta_rate_4;
        // beta_rate_dot_of_beta_rate_6 = beta_rate_dot_of_beta_rate_5/cos_angle
        let beta_rate_dot_of_beta_rate_6 = beta_rate_dot_of_beta_rate_5
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_beta_rate_6_0, sums[98]) * over_cos_angle),
            );
        // beta_rate_dot_of_beta_rate_7 = mom + minus_rr*beta_rate_dot_of_beta_rate_6
        let beta_rate_dot_of_beta_rate_7 = minus_rr * beta_rate_dot_of_beta_rate_6;
        // beta_rate_dot_2 = beta_rate_dot_of_beta_rate_7/d1_of_place_19
        let beta_rate_dot_2 = beta_rate_dot_of_beta_rate_7
            .mul_add(
                over_d1_of_place_19,
                -(d1_of_place_19.mul_add(beta_rate_dot_2_0, sums[99]) * over_d1_of_place_19),
            );
        // theta_of_place = -1 + rr_by_d*beta_rate_dot_of_place_52
        let theta_of_place = rr_by_d * beta_rate_dot_of_place_52;
        // theta_dot_2 = beta_rate*theta_of_place
        let theta_dot_2 = theta_of_place
            .mul_add(beta_rate_0, beta_rate.mul_add(theta_of_place_0, sums[100]));
        // beta_rate_sin_theta = beta_rate*sin_theta
        let beta_rate_sin_theta = sin_theta
            .mul_add(beta_rate_0, beta_rate.mul_add(sin_theta_0, sums[101]));
        // gamma_of_beta_rate = beta_rate_sin_theta/cos_angle
        let gamma_of_beta_rate = beta_rate_sin_theta
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(gamma_of_beta_rate_0, sums[102]) * over_cos_angle),
            );
        // delta_of_beta_rate = gamma_of_beta_rate*cos_phi_inv_sin_angle_2
        let delta_of_beta_rate = gamma_of_beta_rate
            .mul_add(
                cos_phi_inv_sin_angle_2_0,
                cos_phi_inv_sin_angle_2.mul_add(gamma_of_beta_rate_0, sums[103]),
            );
        // phi_of_place = beta_rate_dot_of_place_3/cos_phi
        let phi_of_place = beta_rate_dot_of_place_3
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(phi_of_place_0, sums[104]) * over_cos_phi),
            );
        // phi_of_beta_rate = gamma_of_beta_rate*phi_of_place
        let phi_of_beta_rate = phi_of_place
            .mul_add(
                gamma_of_beta_rate_0,
                gamma_of_beta_rate.mul_add(phi_of_place_0, sums[105]),
            );
        // epsilon_of_beta_rate = gamma_of_beta_rate*beta_rate_dot_of_place_6
        let epsilon_of_beta_rate = gamma_of_beta_rate
            .mul_add(
                beta_rate_dot_of_place_6_0,
                beta_rate_dot_of_place_6.mul_add(gamma_of_beta_rate_0, sums[106]),
            );
        // omega_of_place = beta_rate_dot_of_place_4/cos_omega
        let omega_of_place = beta_rate_dot_of_place_4
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(omega_of_place_0, sums[107]) * over_cos_omega),
            );
        // omega_of_beta_rate = gamma_of_beta_rate*omega_of_place
        let omega_of_beta_rate = omega_of_place
            .mul_add(
                gamma_of_beta_rate_0,
                gamma_of_beta_rate.mul_add(omega_of_place_0, sums[108]),
            );
        beta_rate_2 = beta_rate;
        theta_rate = theta_dot_2;
        gamma_rate = rr_by_ss * gamma_of_beta_rate;
        delta_rate = rr_by_zt * delta_of_beta_rate;
        phi_rate = rr * phi_of_beta_rate;
        epsilon_rate = rr_by_u * epsilon_of_beta_rate;
        omega_rate = minus_rr * omega_of_beta_rate;
        beta_rate_rate = beta_rate_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                count * phi,
                count * phi,
                count * omega,
                count * omega,
                count * d1_of_place,
                count * d1_of_place,
                count * beta_minus_gamma,
                count * beta_minus_gamma,
                count * d1_of_place_2,
                count * d1_of_place_2,
                count * gamma_minus_delta,
                count * gamma_minus_delta,
                count * d1_of_place_3,
                count * d1_of_place_3,
                count * gamma_minus_epsilon,
                count * gamma_minus_epsilon,
                cos_beta_minus_gamma, cos_theta, sin_phi, cos_gamma_minus_delta, sin_angle_2,
                cos_phi, cos_phi_sq, sin_omega, sin_gamma_minus_epsilon, cos_angle_3, cos_omega,
                cos_omega_sq, sin_theta, d1_of_place_13, cos_angle, cos_angle,
                count * gamma,
                count * gamma,
                beta_rate_dot_of_place_2, cos_phi, cos_omega, cos_angle, cos_theta, sin_angle_2,
                cos_gamma_minus_delta, sin_angle_2, cos_gamma_minus_delta, cos_phi,
                cos_gamma_minus_delta, cos_phi, beta_rate_dot_of_place_5, sin_angle_2, sin_phi,
                sin_angle_2, cos_angle_3, sin_gamma_minus_epsilon, cos_angle_3,
                sin_gamma_minus_epsilon, cos_omega, sin_gamma_minus_epsilon, cos_omega,
                beta_rate_dot_of_place_7, cos_angle_3, sin_omega, cos_angle_3, cos_beta_minus_gamma,
                d1_of_place_13, cos_theta, cos_beta_minus_gamma, cos_theta, cos_angle,
                beta_rate_dot_of_place_53, beta_rate_dot_of_place_55, beta_rate,
                beta_rate_dot_of_place_57, sin_omega, cos_angle_3, cos_omega,
                beta_rate_dot_of_place_62, sin_omega, cos_angle_3, sin_gamma_minus_epsilon,
                cos_omega_sq, sin_phi, sin_angle_2, cos_phi, beta_rate_dot_of_place_73, sin_phi,
                sin_angle_2, cos_gamma_minus_delta, cos_phi_sq, sin_theta, sin_theta, cos_angle,
                cos_angle, beta_rate_dot_of_place_88, beta_rate_dot_of_place_2,
                beta_rate_dot_of_place, beta_rate_dot_of_place_91, sin_theta, cos_angle,
                d1_of_place_19, beta_rate, beta_rate, cos_angle, gamma_of_beta_rate, cos_phi,
                gamma_of_beta_rate, gamma_of_beta_rate, cos_omega, gamma_of_beta_rate,
            ]),
            padded([
                cos_theta, sin_theta, cos_phi, sin_phi, cos_omega, sin_omega, cos_angle, sin_angle,
                cos_beta_minus_gamma, sin_beta_minus_gamma, cos_angle_2, sin_angle_2,
                cos_gamma_minus_delta, sin_gamma_minus_delta, cos_angle_3, sin_angle_3,
                cos_gamma_minus_epsilon, sin_gamma_minus_epsilon, cos_beta_minus_gamma,
                cos_beta_minus_gamma, sin_angle_2, d1_of_place_5, sin_angle_2, cos_phi,
                d1_of_place_8, cos_angle_3, d1_of_place_9, cos_angle_3, cos_omega, d1_of_place_12,
                sin_theta, sin_theta_sq, d1_of_place_16, d1_of_place_18, cos_gamma, sin_gamma,
                beta_rate_dot_of_place_2, cos_phi_inv_sin_angle_2, beta_rate_dot_of_place_6,
                sin_angle_cos_angle_inv, sin_beta_minus_gamma, beta_rate_dot_of_place_9,
                beta_rate_dot_of_place_11, beta_rate_dot_of_place_13, cos_gamma_minus_delta,
                beta_rate_dot_of_place_16, cos_angle_2, sin_phi_cos_phi_inv, sin_phi_cos_phi_inv,
                beta_rate_dot_of_place_21, sin_gamma_minus_delta, beta_rate_dot_of_place_24,
                beta_rate_dot_of_place_26, beta_rate_dot_of_place_28, beta_rate_dot_of_place_30,
                sin_gamma_minus_epsilon, beta_rate_dot_of_place_34, sin_angle_3,
                sin_omega_cos_omega_inv, sin_omega_cos_omega_inv, beta_rate_dot_of_place_39,
                cos_gamma_minus_epsilon, beta_rate_dot_of_place_42, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_44, beta_rate_dot_of_place_46, beta_rate_dot_of_place_48,
                beta_rate_dot_of_place_50, beta_rate_dot_of_place_52, beta_rate_dot_of_place_44,
                beta_rate_dot_of_place_52, beta_rate, beta_rate_sq, beta_rate_dot_of_place_36,
                beta_rate_dot_of_place_37, beta_rate_dot_of_place_61, sin_angle_cos_angle_inv,
                sin_angle_3, beta_rate_dot_of_place_4, beta_rate_dot_of_place_65,
                beta_rate_dot_of_place_68, beta_rate_dot_of_place_18, beta_rate_dot_of_place_19,
                beta_rate_dot_of_place_72, sin_angle_cos_angle_inv, cos_angle_2,
                beta_rate_dot_of_place_3, beta_rate_dot_of_place_76, beta_rate_dot_of_place_79,
                beta_rate_dot_of_place_80, beta_rate_dot_of_place_82, beta_rate_dot_of_place_85,
                beta_rate_dot_of_place_87, beta_rate_sq, beta_rate_dot_of_place_89,
                beta_rate_dot_of_place_92, beta_rate_dot_of_place_92, beta_rate_dot_of_beta_rate_3,
                beta_rate_dot_of_beta_rate_6, beta_rate_dot_2, theta_of_place, sin_theta,
                gamma_of_beta_rate, cos_phi_inv_sin_angle_2, phi_of_place, phi_of_place,
                beta_rate_dot_of_place_6, omega_of_place, omega_of_place,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        gamma_last = gamma;
        phi_last = phi;
        omega_last = omega;
        beta_rate_last = beta_rate;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        sin_omega_last = sin_omega;
        cos_omega_last = cos_omega;
        beta_minus_gamma_last = beta_minus_gamma;
        d1_of_place_last = d1_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_beta_minus_gamma_last = sin_beta_minus_gamma;
        cos_beta_minus_gamma_last = cos_beta_minus_gamma;
        d1_of_place_2_last = d1_of_place_2;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        gamma_minus_delta_last = gamma_minus_delta;
        sin_gamma_minus_delta_last = sin_gamma_minus_delta;
        cos_gamma_minus_delta_last = cos_gamma_minus_delta;
        d1_of_place_3_last = d1_of_place_3;
        sin_angle_3_last = sin_angle_3;
        cos_angle_3_last = cos_angle_3;
        gamma_minus_epsilon_last = gamma_minus_epsilon;
        sin_gamma_minus_epsilon_last = sin_gamma_minus_epsilon;
        cos_gamma_minus_epsilon_last = cos_gamma_minus_epsilon;
        d1_of_place_5_last = d1_of_place_5;
        cos_phi_sq_last = cos_phi_sq;
        d1_of_place_8_last = d1_of_place_8;
        d1_of_place_9_last = d1_of_place_9;
        cos_omega_sq_last = cos_omega_sq;
        d1_of_place_12_last = d1_of_place_12;
        d1_of_place_13_last = d1_of_place_13;
        sin_theta_sq_last = sin_theta_sq;
        d1_of_place_16_last = d1_of_place_16;
        d1_of_place_18_last = d1_of_place_18;
        d1_of_place_19_last = d1_of_place_19;
        sin_gamma_last = sin_gamma;
        cos_gamma_last = cos_gamma;
        beta_rate_dot_of_place_last = beta_rate_dot_of_place;
        beta_rate_dot_of_place_2_last = beta_rate_dot_of_place_2;
        beta_rate_dot_of_place_3_last = beta_rate_dot_of_place_3;
        beta_rate_dot_of_place_4_last = beta_rate_dot_of_place_4;
        cos_phi_inv_sin_angle_2_last = cos_phi_inv_sin_angle_2;
        beta_rate_dot_of_place_5_last = beta_rate_dot_of_place_5;
        beta_rate_dot_of_place_6_last = beta_rate_dot_of_place_6;
        beta_rate_dot_of_place_7_last = beta_rate_dot_of_place_7;
        sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv;
        beta_rate_dot_of_place_9_last = beta_rate_dot_of_place_9;
        beta_rate_dot_of_place_11_last = beta_rate_dot_of_place_11;
        beta_rate_dot_of_place_13_last = beta_rate_dot_of_place_13;
        beta_rate_dot_of_place_16_last = beta_rate_dot_of_place_16;
        beta_rate_dot_of_place_18_last = beta_rate_dot_of_place_18;
        beta_rate_dot_of_place_19_last = beta_rate_dot_of_place_19;
        sin_phi_cos_phi_inv_last = sin_phi_cos_phi_inv;
        beta_rate_dot_of_place_21_last = beta_rate_dot_of_place_21;
        beta_rate_dot_of_place_24_last = beta_rate_dot_of_place_24;
        beta_rate_dot_of_place_26_last = beta_rate_dot_of_place_26;
        beta_rate_dot_of_place_28_last = beta_rate_dot_of_place_28;
        beta_rate_dot_of_place_30_last = beta_rate_dot_of_place_30;
        beta_rate_dot_of_place_34_last = beta_rate_dot_of_place_34;
        beta_rate_dot_of_place_36_last = beta_rate_dot_of_place_36;
        beta_rate_dot_of_place_37_last = beta_rate_dot_of_place_37;
        sin_omega_cos_omega_inv_last = sin_omega_cos_omega_inv;
        beta_rate_dot_of_place_39_last = beta_rate_dot_of_place_39;
        beta_rate_dot_of_place_42_last = beta_rate_dot_of_place_42;
        beta_rate_dot_of_place_44_last = beta_rate_dot_of_place_44;
        beta_rate_dot_of_place_46_last = beta_rate_dot_of_place_46;
        beta_rate_dot_of_place_48_last = beta_rate_dot_of_place_48;
        beta_rate_dot_of_place_50_last = beta_rate_dot_of_place_50;
        beta_rate_dot_of_place_52_last = beta_rate_dot_of_place_52;
        beta_rate_dot_of_place_53_last = beta_rate_dot_of_place_53;
        beta_rate_dot_of_place_55_last = beta_rate_dot_of_place_55;
        beta_rate_dot_of_place_57_last = beta_rate_dot_of_place_57;
        beta_rate_sq_last = beta_rate_sq;
        beta_rate_dot_of_place_61_last = beta_rate_dot_of_place_61;
        beta_rate_dot_of_place_62_last = beta_rate_dot_of_place_62;
        beta_rate_dot_of_place_65_last = beta_rate_dot_of_place_65;
        beta_rate_dot_of_place_68_last = beta_rate_dot_of_place_68;
        beta_rate_dot_of_place_72_last = beta_rate_dot_of_place_72;
        beta_rate_dot_of_place_73_last = beta_rate_dot_of_place_73;
        beta_rate_dot_of_place_76_last = beta_rate_dot_of_place_76;
        beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79;
        beta_rate_dot_of_place_80_last = beta_rate_dot_of_place_80;
        beta_rate_dot_of_place_82_last = beta_rate_dot_of_place_82;
        beta_rate_dot_of_place_85_last = beta_rate_dot_of_place_85;
        beta_rate_dot_of_place_87_last = beta_rate_dot_of_place_87;
        beta_rate_dot_of_place_88_last = beta_rate_dot_of_place_88;
        beta_rate_dot_of_place_89_last = beta_rate_dot_of_place_89;
        beta_rate_dot_of_place_91_last = beta_rate_dot_of_place_91;
        beta_rate_dot_of_place_92_last = beta_rate_dot_of_place_92;
        beta_rate_dot_of_beta_rate_3_last = beta_rate_dot_of_beta_rate_3;
        beta_rate_dot_of_beta_rate_6_last = beta_rate_dot_of_beta_rate_6;
        beta_rate_dot_2_last = beta_rate_dot_2;
        theta_of_place_last = theta_of_place;
        gamma_of_beta_rate_last = gamma_of_beta_rate;
        phi_of_place_last = phi_of_place;
        omega_of_place_last = omega_of_place;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 42,
            coordinates: 7,
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
        8
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
        224 * order + SLACK
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
        4
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "cos(beta + theta - gamma)",
            "cos(phi)",
            "cos(omega)",
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
        ["E3_1", "E3_2", "E4_1", "E4_2", "E6_1", "E6_2"][at]
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
