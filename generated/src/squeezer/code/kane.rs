//! Andrews' squeezing mechanism: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    u: &[S; 1],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[7 + i],
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
