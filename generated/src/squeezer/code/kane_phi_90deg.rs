//! Andrews' squeezing mechanism: Kane's method in phi-90°, M(q) u' = f(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows beta_rate.
///
/// 106 operations, 7 sines and cosines.
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
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    // Sines and cosines.
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    // Shared terms.
    let cos_angle_inv = S::int(1) / cos_angle;
    let ss_inv = S::int(1) / ss;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let m11_of_place = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let m11_of_place_2 = S::int(2) * m11_of_place * sin_omega;
    let m11_of_place_sq = m11_of_place * m11_of_place;
    let u_2_inv = S::int(1) / u_2;
    let m11_of_place_3 = zf_inv * sin_gamma_minus_epsilon;
    let cos_omega_inv = S::int(1) / cos_omega;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let m11_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let m11_of_place_5 = S::int(2) * m11_of_place_4 * cos_phi_minus_90deg;
    let m11_of_place_4_sq = m11_of_place_4 * m11_of_place_4;
    let zt_inv = S::int(1) / zt;
    let m11_of_place_6 = e_inv * cos_gamma_minus_delta;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let m2_da = m2 * da;
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    let m11_of_d_beta_gamma = cos_beta_minus_gamma / d;
    // Entries that are not zero; upper triangle.
    // M11 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let m11 = I1 + m1 * ra * ra
        + rr * rr
            * (m2
                + cos_angle_inv
                    * (cos_angle_inv
                        * (sin_theta * sin_theta
                            * (ss_inv * ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa))
                                + cos_omega_inv * cos_omega_inv
                                    * (m6
                                        * (sin_gamma_minus_epsilon
                                            * (sin_gamma_minus_epsilon - m11_of_place_2
                                                + fa_zf_inv
                                                    * (sin_gamma_minus_epsilon * (fa_zf_inv - S::int(2))
                                                        + m11_of_place_2)) + m11_of_place_sq)
                                        + m11_of_place_sq * u_2_inv * u_2_inv
                                            * (I7 + m7 * ub.mul_add(ub, ua * ua))
                                        + I6 * m11_of_place_3 * m11_of_place_3)
                                + sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv
                                    * (m4
                                        * (cos_gamma_minus_delta
                                            * (cos_gamma_minus_delta - m11_of_place_5
                                                + ea_e_inv
                                                    * (cos_gamma_minus_delta * (ea_e_inv - S::int(2))
                                                        + m11_of_place_5)) + m11_of_place_4_sq)
                                        + m11_of_place_4_sq * zt_inv * zt_inv
                                            * (I5 + m5 * tb.mul_add(tb, ta * ta))
                                        + I4 * m11_of_place_6 * m11_of_place_6))
                            + m11_of_d_beta_gamma * m11_of_d_beta_gamma * da.mul_add(m2_da, I2))
                        - S::int(2) * m2_da * m11_of_d_beta_gamma * cos_theta));
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (beta_rate').
///
/// 419 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 1] {
    let Parameters {
        m2, m3, m4, m5, m6, m7, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e, ea, rr,
        ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
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
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let f1_of_place_4 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let u_2_inv = S::int(1) / u_2;
    let cos_omega_inv = S::int(1) / cos_omega;
    let zf_inv = S::int(1) / zf;
    let i6_zf_inv = I6 * zf_inv;
    let fa_zf_inv = fa * zf_inv;
    // 2 - fa_zf_inv
    let f1_of_zf_fa = S::int(2) - fa_zf_inv;
    // -f1_of_zf_fa
    let minus_f1_of_zf_fa = -f1_of_zf_fa;
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_f1_of_zf_fa*m6_fa
    let f1_of_m6_i6_zf_fa = minus_f1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let f1_of_place_5 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - f1_of_place_5
    let f1_of_place_6 = sin_gamma_minus_epsilon.mul_add(cos_omega, -f1_of_place_5);
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let f1_of_place_7 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    let f1_of_place_8 = f1_of_place_4 * sin_omega_doubled;
    // sin(gamma - epsilon) - f1_of_place_8
    let f1_of_place_9 = sin_gamma_minus_epsilon - f1_of_place_8;
    // fa_zf_inv - 1
    let f1_of_zf_fa_2 = fa_zf_inv - S::int(1);
    let u_2_inv_f1_of_place_7 = u_2_inv * f1_of_place_7;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let f1_of_place_10 = f1_of_place_4.mul_add(sin_angle_cos_angle_inv, f1_of_place_6);
    let f1_of_place_11 = f1_of_zf_fa_2 * sin_gamma_minus_epsilon;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let f1_of_place_12 = S::int(2) * sin_angle_cos_angle_inv;
    let fa_ss_inv = fa * ss_inv;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let f1_of_place_13 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let sin_omega_f1_of_place_6 = f1_of_place_6 * sin_omega;
    let f1_of_place_14 = cos_omega_inv * sin_gamma_minus_epsilon;
    let sin_omega_f1_of_place_14 = f1_of_place_14 * sin_omega;
    let f1_of_place_15 = zf_inv * sin_omega_f1_of_place_14;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let f1_of_place_16 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let zt_inv = S::int(1) / zt;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
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
    let f1_of_place_17 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let f1_of_place_18 = S::int(2) * cos_phi_minus_90deg;
    let f1_of_place_19 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    let f1_of_place_20 = sin_gamma_minus_delta * cos_phi_minus_90deg;
    // f1_of_place_20 - cos(gamma - delta)*sin(phi_minus_90deg)
    let f1_of_place_21 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, f1_of_place_20);
    let f1_of_place_22 = f1_of_place_16 * f1_of_place_18;
    // cos(gamma - delta) - f1_of_place_22
    let f1_of_place_23 = cos_gamma_minus_delta - f1_of_place_22;
    // ea_e_inv - 1
    let f1_of_e_ea_2 = ea_e_inv - S::int(1);
    let zt_inv_f1_of_place_17 = zt_inv * f1_of_place_17;
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let f1_of_place_24 = f1_of_place_16.mul_add(sin_angle_cos_angle_inv, f1_of_place_21);
    let f1_of_place_25 = f1_of_e_ea_2 * cos_gamma_minus_delta;
    let ea_ss_inv = ea * ss_inv;
    let f1_of_place_26 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
    let f1_of_place_27 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let f1_of_place_28 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let f1_of_place_29 = f1_of_place_21 * cos_phi_minus_90deg;
    let f1_of_place_30 = e_inv * cos_gamma_minus_delta;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let f1_of_place_31 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_f1_of_place_31 = ss_inv * f1_of_place_31;
    let f1_of_place_4_sq = f1_of_place_4 * f1_of_place_4;
    let f1_of_place_16_sq = f1_of_place_16 * f1_of_place_16;
    // cos_omega_inv_sq*(zf_inv_i6_zf_inv*sin(gamma - epsilon)^2 + u_2_inv_f1_of_place_7*f1_of_place_4_sq +
    //   m6*(sin(gamma - epsilon)*(fa_zf_inv*(minus_f1_of_zf_fa*sin(gamma - epsilon) + f1_of_place_8) +
    //   f1_of_place_9) + f1_of_place_4_sq)) + f1_of_place_26*(i4_e_inv*f1_of_place_30*cos(gamma - delta) +
    //   zt_inv_f1_of_place_17*f1_of_place_16_sq + m4*(cos(gamma - delta)*(ea_e_inv*(f1_of_e_ea*cos(gamma -
    //   delta) + f1_of_place_22) + f1_of_place_23) + f1_of_place_16_sq))
    let f1_of_place_32 = cos_omega_inv_sq
        * (zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon
            + u_2_inv_f1_of_place_7 * f1_of_place_4_sq
            + m6
                * (sin_gamma_minus_epsilon
                    * (fa_zf_inv
                        * minus_f1_of_zf_fa
                            .mul_add(sin_gamma_minus_epsilon, f1_of_place_8)
                        + f1_of_place_9) + f1_of_place_4_sq))
        + f1_of_place_26
            * (i4_e_inv * f1_of_place_30 * cos_gamma_minus_delta
                + zt_inv_f1_of_place_17 * f1_of_place_16_sq
                + m4
                    * (cos_gamma_minus_delta
                        * (ea_e_inv * f1_of_e_ea.mul_add(cos_gamma_minus_delta, f1_of_place_22)
                            + f1_of_place_23) + f1_of_place_16_sq));
    // ss_inv_f1_of_place_31 + f1_of_place_32
    let f1_of_place_33 = ss_inv_f1_of_place_31 + f1_of_place_32;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let f1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let f1_of_place_34 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let m2_da = m2 * da;
    let f1_of_place_35 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - f1_of_d_beta_gamma*f1_of_place_34*rr_cos_angle_inv
    let f1_of_place_36 = (-(f1_of_d_beta_gamma * f1_of_place_34))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let f1_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let f1_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let f1_of_place_37 = (xc_sq + f1_of_xb_xc + yc_sq + f1_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // Values.
    // f1 = mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta -
    //   gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma)
    let f1 = mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * f1_of_place_37 * (l0 - f1_of_place_37)
                    * (-sd).mul_add(f1_of_place_2, sc * f1_of_place)
                    / (xc_sq + f1_of_xb_xc + yc_sq + f1_of_yb_yc
                        + sd * f1_of_place.mul_add(S::int(2), sd)
                        + sc * f1_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (cos_angle_inv
                            * (rr
                                * (cos_angle_inv
                                    * (sin_theta
                                        * (sin_theta
                                            * (cos_omega_inv_sq
                                                * (f1_of_place_4
                                                    * (u_2_inv
                                                        * (cos_omega_inv
                                                            * (sin_gamma_minus_epsilon
                                                                * (zf_inv
                                                                    * (f1_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                        - f1_of_place_6 * f1_of_place_7
                                                                        + sin_omega_cos_omega_inv
                                                                            * (f1_of_place_4
                                                                                * m6_fa.mul_add(sin_omega_doubled, -f1_of_place_7)
                                                                                + f1_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                    + m6
                                                                        * sin_omega_cos_omega_inv
                                                                            .mul_add(f1_of_place_9, cos_gamma_minus_epsilon))
                                                                + f1_of_place_4 * sin_omega
                                                                    * (f1_of_place_4 * cos_omega_inv
                                                                        * (m6 + u_2_inv_f1_of_place_7)
                                                                        + m6 * f1_of_zf_fa_2 * cos_gamma_minus_epsilon))
                                                            + ss_inv * u_2_inv
                                                                * (m7 * ua_sq_plus_ub_sq)
                                                                    .mul_add(f1_of_place_10, I7 * f1_of_place_10)
                                                            + m6 * f1_of_place_4 * f1_of_place_11)
                                                        + m6
                                                            * (ss_inv
                                                                * (f1_of_place_10
                                                                    + sin_omega
                                                                        * (-f1_of_place_12)
                                                                            .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon))
                                                                - zf_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (f1_of_place_11 + f1_of_place_6 * cos_omega_inv
                                                                            + sin_omega
                                                                                * (cos_omega_inv_sq
                                                                                    * sin_omega_doubled.mul_add(f1_of_place_11, f1_of_place_4)
                                                                                    - f1_of_place_12 * fa_ss_inv))
                                                                        + f1_of_place_5 * fa_ss_inv)))
                                                    + sin_gamma_minus_epsilon
                                                        * (m6
                                                            * (zf_inv
                                                                * (sin_omega_f1_of_place_14
                                                                    * (f1_of_place_6 - f1_of_place_14)
                                                                    + fa
                                                                        * (ss_inv
                                                                            * f1_of_zf_fa
                                                                                .mul_add(f1_of_place_13, sin_omega_f1_of_place_6)
                                                                            - f1_of_place_15
                                                                                * minus_f1_of_zf_fa.mul_add(f1_of_place_14, f1_of_place_6)))
                                                                - ss_inv * (f1_of_place_13 + sin_omega_f1_of_place_6))
                                                            - zf_inv_i6_zf_inv
                                                                * f1_of_place_14
                                                                    .mul_add(f1_of_place_15, ss_inv * f1_of_place_13)))
                                                + f1_of_place_26
                                                    * (cos_gamma_minus_delta
                                                        * (m4
                                                            * (e_inv
                                                                * (ea
                                                                    * (e_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (f1_of_place_19
                                                                                * (-f1_of_e_ea).mul_add(f1_of_place_27, f1_of_place_21)
                                                                                + sin_angle_cos_angle_inv * ea_ss_inv)
                                                                            + ea_ss_inv * sin_gamma_minus_delta)
                                                                        + ss_inv
                                                                            * (-f1_of_place_28).mul_add(S::int(2), f1_of_place_29))
                                                                    - f1_of_place_19 * cos_gamma_minus_delta
                                                                        * (f1_of_place_21 + f1_of_place_27))
                                                                + ss_inv * (f1_of_place_28 - f1_of_place_29))
                                                            + e_inv * i4_e_inv
                                                                * (-(f1_of_place_19 * f1_of_place_27))
                                                                    .mul_add(f1_of_place_30, ss_inv * f1_of_place_28))
                                                        - f1_of_place_16
                                                            * (zt_inv
                                                                * (sin_phi_minus_90deg_inv
                                                                    * (cos_gamma_minus_delta
                                                                        * (e_inv
                                                                            * (f1_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                - f1_of_place_21 * f1_of_place_17
                                                                                + f1_of_place_19
                                                                                    * (f1_of_place_16
                                                                                        * m4_ea.mul_add(f1_of_place_18, f1_of_place_17)
                                                                                        + f1_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                            + m4
                                                                                * f1_of_place_19
                                                                                    .mul_add(f1_of_place_23, sin_gamma_minus_delta))
                                                                        + f1_of_place_16 * cos_phi_minus_90deg
                                                                            * (f1_of_place_16 * sin_phi_minus_90deg_inv
                                                                                * (m4 + zt_inv_f1_of_place_17)
                                                                                + m4 * f1_of_e_ea_2 * sin_gamma_minus_delta))
                                                                    - ss_inv * zt_inv
                                                                        * (m5 * ta_sq_plus_tb_sq)
                                                                            .mul_add(f1_of_place_24, I5 * f1_of_place_24)
                                                                    + m4 * f1_of_place_16 * f1_of_place_25)
                                                                + m4
                                                                    * (ss_inv
                                                                        * (cos_phi_minus_90deg
                                                                            * f1_of_place_12
                                                                                .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta)
                                                                            - f1_of_place_24)
                                                                        + e_inv
                                                                            * (cos_gamma_minus_delta
                                                                                * (f1_of_place_25 - f1_of_place_21 * sin_phi_minus_90deg_inv
                                                                                    + cos_phi_minus_90deg
                                                                                        * (f1_of_place_26
                                                                                            * f1_of_place_18.mul_add(f1_of_place_25, f1_of_place_16)
                                                                                            - f1_of_place_12 * ea_ss_inv))
                                                                                - f1_of_place_20 * ea_ss_inv))))
                                                + ss_inv * sin_angle_cos_angle_inv * ss_inv_f1_of_place_31)
                                            - sin_angle_cos_angle_inv * f1_of_place_33
                                                * f1_of_d_beta_gamma)
                                        - f1_of_d_beta_gamma
                                            * (ss_inv * d_inv * (sin_beta_minus_gamma - f1_of_place_34)
                                                * da.mul_add(m2_da, I2)
                                                + cos_theta
                                                    * (f1_of_place_32
                                                        + ss_inv * m2_da.mul_add(sin_angle, f1_of_place_31))))
                                    + d_inv * m2_da
                                        * (-f1_of_d_beta_gamma)
                                            .mul_add(cos_beta_minus_gamma, ss_inv * f1_of_place_35))
                                + f1_of_place_33 * cos_theta) + f1_of_d_beta_gamma * m2_da))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * f1_of_d_beta_gamma
                        * (m2_da * da.mul_add(f1_of_place_36, rr * f1_of_place_34 * cos_theta)
                            + I2 * f1_of_place_36) - m2_da * f1_of_place_35));
    [f1]
}

/// The accelerations (beta_rate'), solved for when this code was generated.
///
/// 437 operations, 8 sines and cosines, 1 other function.
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
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // beta + theta - gamma
    let d1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // 2 - fa_zf_inv
    let d1_of_zf_fa = S::int(2) - fa_zf_inv;
    // -d1_of_zf_fa
    let minus_d1_of_zf_fa = -d1_of_zf_fa;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let d1_of_place_2 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let d1_of_place_3 = d1_of_place_2 * sin_omega_doubled;
    // sin(gamma - epsilon) - d1_of_place_3
    let d1_of_place_4 = sin_gamma_minus_epsilon - d1_of_place_3;
    let d1_of_place_2_sq = d1_of_place_2 * d1_of_place_2;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_5 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_5 = u_2_inv * d1_of_place_5;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let d1_of_place_6 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let d1_of_place_7 = S::int(2) * cos_phi_minus_90deg;
    let d1_of_place_8 = d1_of_place_6 * d1_of_place_7;
    // cos(gamma - delta) - d1_of_place_8
    let d1_of_place_9 = cos_gamma_minus_delta - d1_of_place_8;
    let d1_of_place_6_sq = d1_of_place_6 * d1_of_place_6;
    let d1_of_place_10 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let d1_of_place_11 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_d1_of_place_11 = zt_inv * d1_of_place_11;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let d1_of_place_12 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
    // cos_omega_inv_sq*(m6*(sin(gamma - epsilon)*(fa_zf_inv*(minus_d1_of_zf_fa*sin(gamma - epsilon) +
    //   d1_of_place_3) + d1_of_place_4) + d1_of_place_2_sq) + d1_of_place_2_sq*u_2_inv_d1_of_place_5 +
    //   zf_inv_i6_zf_inv*sin(gamma - epsilon)^2) + d1_of_place_12*(m4*(cos(gamma -
    //   delta)*(ea_e_inv*(d1_of_e_ea*cos(gamma - delta) + d1_of_place_8) + d1_of_place_9) +
    //   d1_of_place_6_sq) + I4*d1_of_place_10^2 + d1_of_place_6_sq*zt_inv_d1_of_place_11)
    let d1_of_place_13 = cos_omega_inv_sq
        * (m6
            * (sin_gamma_minus_epsilon
                * (fa_zf_inv * minus_d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_3)
                    + d1_of_place_4) + d1_of_place_2_sq) + d1_of_place_2_sq * u_2_inv_d1_of_place_5
            + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon)
        + d1_of_place_12
            * (m4
                * (cos_gamma_minus_delta
                    * (ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, d1_of_place_8)
                        + d1_of_place_9) + d1_of_place_6_sq) + I4 * d1_of_place_10 * d1_of_place_10
                + d1_of_place_6_sq * zt_inv_d1_of_place_11);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_14 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_14 = ss_inv * d1_of_place_14;
    // d1_of_place_13 + ss_inv_d1_of_place_14
    let d1_of_place_15 = d1_of_place_13 + ss_inv_d1_of_place_14;
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
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let d1 = I1 + m1 * ra * ra
        + rr * rr
            * (m2
                + cos_angle_inv
                    * (cos_angle_inv
                        * (d1_of_place_15 * sin_theta * sin_theta
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
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = minus_d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let beta_rate_dot_of_place_3 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_of_place_3
    let beta_rate_dot_of_place_4 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_of_place_3);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_5 = d1_of_place_2
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_4);
    let beta_rate_dot_of_place_6 = beta_rate_dot_of_zf_fa * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_7 = S::int(2) * sin_angle_cos_angle_inv;
    let fa_ss_inv = fa * ss_inv;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_8 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_9 = beta_rate_dot_of_place_4 * sin_omega;
    let beta_rate_dot_of_place_10 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_11 = beta_rate_dot_of_place_10 * sin_omega;
    let beta_rate_dot_of_place_12 = zf_inv * beta_rate_dot_of_place_11;
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let beta_rate_dot_of_place_13 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    let beta_rate_dot_of_place_14 = sin_gamma_minus_delta * cos_phi_minus_90deg;
    // beta_rate_dot_of_place_14 - cos(gamma - delta)*sin(phi_minus_90deg)
    let beta_rate_dot_of_place_15 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, beta_rate_dot_of_place_14);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_16 = d1_of_place_6
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_15);
    let beta_rate_dot_of_place_17 = beta_rate_dot_of_e_ea * cos_gamma_minus_delta;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_18 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_19 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_of_place_20 = beta_rate_dot_of_place_15 * cos_phi_minus_90deg;
    let beta_rate_dot_of_place_21 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_22 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - d1_of_d_beta_gamma*beta_rate_dot_of_place_21*rr_cos_angle_inv
    let beta_rate_dot_of_place_23 = (-(d1_of_d_beta_gamma * beta_rate_dot_of_place_21))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_24 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // beta_rate' = (mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta -
    //   gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_24 * (l0 - beta_rate_dot_of_place_24)
                    * (-sd)
                        .mul_add(beta_rate_dot_of_place_2, sc * beta_rate_dot_of_place)
                    / (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
                        + sd * beta_rate_dot_of_place.mul_add(S::int(2), sd)
                        + sc * beta_rate_dot_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (m2_da_d1_of_d_beta_gamma
                            + cos_angle_inv
                                * (rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_omega_inv_sq
                                                    * (d1_of_place_2
                                                        * (u_2_inv
                                                            * (cos_omega_inv
                                                                * (sin_gamma_minus_epsilon
                                                                    * (zf_inv
                                                                        * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                            - beta_rate_dot_of_place_4 * d1_of_place_5
                                                                            + sin_omega_cos_omega_inv
                                                                                * (d1_of_place_2
                                                                                    * sin_omega_doubled.mul_add(m6_fa, -d1_of_place_5)
                                                                                    + beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                        + m6
                                                                            * d1_of_place_4
                                                                                .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                    + d1_of_place_2 * sin_omega
                                                                        * (d1_of_place_2 * cos_omega_inv
                                                                            * (m6 + u_2_inv_d1_of_place_5)
                                                                            + m6 * beta_rate_dot_of_zf_fa * cos_gamma_minus_epsilon))
                                                                + u_2_inv * ss_inv
                                                                    * (m7 * ua_sq_plus_ub_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_5,
                                                                            I7 * beta_rate_dot_of_place_5,
                                                                        ) + m6 * d1_of_place_2 * beta_rate_dot_of_place_6)
                                                            + m6
                                                                * (ss_inv
                                                                    * (beta_rate_dot_of_place_5
                                                                        + sin_omega
                                                                            * (-beta_rate_dot_of_place_7)
                                                                                .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon))
                                                                    - zf_inv
                                                                        * (sin_gamma_minus_epsilon
                                                                            * (beta_rate_dot_of_place_6
                                                                                + beta_rate_dot_of_place_4 * cos_omega_inv
                                                                                + sin_omega
                                                                                    * (cos_omega_inv_sq
                                                                                        * sin_omega_doubled
                                                                                            .mul_add(beta_rate_dot_of_place_6, d1_of_place_2)
                                                                                        - beta_rate_dot_of_place_7 * fa_ss_inv))
                                                                            + beta_rate_dot_of_place_3 * fa_ss_inv)))
                                                        + sin_gamma_minus_epsilon
                                                            * (m6
                                                                * (zf_inv
                                                                    * (beta_rate_dot_of_place_11
                                                                        * (beta_rate_dot_of_place_4 - beta_rate_dot_of_place_10)
                                                                        + fa
                                                                            * (ss_inv
                                                                                * d1_of_zf_fa
                                                                                    .mul_add(beta_rate_dot_of_place_8, beta_rate_dot_of_place_9)
                                                                                - beta_rate_dot_of_place_12
                                                                                    * minus_d1_of_zf_fa
                                                                                        .mul_add(
                                                                                            beta_rate_dot_of_place_10,
                                                                                            beta_rate_dot_of_place_4,
                                                                                        )))
                                                                    - ss_inv
                                                                        * (beta_rate_dot_of_place_8 + beta_rate_dot_of_place_9))
                                                                - zf_inv_i6_zf_inv
                                                                    * beta_rate_dot_of_place_10
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_12,
                                                                            ss_inv * beta_rate_dot_of_place_8,
                                                                        )))
                                                    + ss_inv * ss_inv_d1_of_place_14 * sin_angle_cos_angle_inv
                                                    + d1_of_place_12
                                                        * (cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-(d1_of_place_10 * beta_rate_dot_of_place_13))
                                                                    .mul_add(
                                                                        beta_rate_dot_of_place_18,
                                                                        ss_inv * beta_rate_dot_of_place_19,
                                                                    )
                                                                + m4
                                                                    * (e_inv
                                                                        * (ea
                                                                            * (e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (beta_rate_dot_of_place_13
                                                                                        * (-d1_of_e_ea)
                                                                                            .mul_add(
                                                                                                beta_rate_dot_of_place_18,
                                                                                                beta_rate_dot_of_place_15,
                                                                                            ) + sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                    + ea_ss_inv * sin_gamma_minus_delta)
                                                                                + ss_inv
                                                                                    * (-beta_rate_dot_of_place_19)
                                                                                        .mul_add(S::int(2), beta_rate_dot_of_place_20))
                                                                            - beta_rate_dot_of_place_13 * cos_gamma_minus_delta
                                                                                * (beta_rate_dot_of_place_15 + beta_rate_dot_of_place_18))
                                                                        + ss_inv
                                                                            * (beta_rate_dot_of_place_19 - beta_rate_dot_of_place_20)))
                                                            - d1_of_place_6
                                                                * (zt_inv
                                                                    * (sin_phi_minus_90deg_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (e_inv
                                                                                * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                    - beta_rate_dot_of_place_15 * d1_of_place_11
                                                                                    + beta_rate_dot_of_place_13
                                                                                        * (d1_of_place_6
                                                                                            * d1_of_place_7.mul_add(m4_ea, d1_of_place_11)
                                                                                            + beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                                + m4
                                                                                    * d1_of_place_9
                                                                                        .mul_add(beta_rate_dot_of_place_13, sin_gamma_minus_delta))
                                                                            + d1_of_place_6 * cos_phi_minus_90deg
                                                                                * (d1_of_place_6 * sin_phi_minus_90deg_inv
                                                                                    * (m4 + zt_inv_d1_of_place_11)
                                                                                    + m4 * beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                        - zt_inv * ss_inv
                                                                            * (m5 * ta_sq_plus_tb_sq)
                                                                                .mul_add(
                                                                                    beta_rate_dot_of_place_16,
                                                                                    I5 * beta_rate_dot_of_place_16,
                                                                                ) + m4 * d1_of_place_6 * beta_rate_dot_of_place_17)
                                                                    + m4
                                                                        * (ss_inv
                                                                            * (cos_phi_minus_90deg
                                                                                * beta_rate_dot_of_place_7
                                                                                    .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta)
                                                                                - beta_rate_dot_of_place_16)
                                                                            + e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (beta_rate_dot_of_place_17
                                                                                        - beta_rate_dot_of_place_15 * sin_phi_minus_90deg_inv
                                                                                        + cos_phi_minus_90deg
                                                                                            * (d1_of_place_12
                                                                                                * d1_of_place_7
                                                                                                    .mul_add(beta_rate_dot_of_place_17, d1_of_place_6)
                                                                                                - beta_rate_dot_of_place_7 * ea_ss_inv))
                                                                                    - beta_rate_dot_of_place_14 * ea_ss_inv)))))
                                                - d1_of_place_15 * d1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            - d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (d1_of_place_13
                                                        + ss_inv * m2_da.mul_add(sin_angle, d1_of_place_14))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_21)))
                                        + m2_da * d_inv
                                            * (-d1_of_d_beta_gamma)
                                                .mul_add(
                                                    cos_beta_minus_gamma,
                                                    ss_inv * beta_rate_dot_of_place_22,
                                                )) + d1_of_place_15 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_23,
                                    rr * beta_rate_dot_of_place_21 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_23)
                        - m2_da * beta_rate_dot_of_place_22))) / d1;
    [beta_rate_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 29 operations, 7 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 7] {
    let Parameters { d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    // Shared terms.
    let theta_dot_value_of_beta_rate = rr * beta_rate / cos_angle;
    let gamma_dot_value_of_beta_rate = theta_dot_value_of_beta_rate * sin_theta;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    let delta_dot_value_of_place = cos_gamma_minus_delta / sin_phi_minus_90deg;
    // gamma_dot_value_of_beta_rate*(sin(gamma - delta) + delta_dot_value_of_place*cos(phi_minus_90deg))/zt
    let delta_dot_value_of_beta_rate = gamma_dot_value_of_beta_rate
        * delta_dot_value_of_place.mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta) / zt;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    let epsilon_dot_value_of_place = sin_gamma_minus_epsilon / cos_omega;
    // gamma_dot_value_of_beta_rate*(cos(gamma - epsilon) + epsilon_dot_value_of_place*sin(omega))/u
    let epsilon_dot_value_of_beta_rate = gamma_dot_value_of_beta_rate
        * epsilon_dot_value_of_place.mul_add(sin_omega, cos_gamma_minus_epsilon) / u_2;
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = theta_dot_value_of_beta_rate * cos_beta_minus_gamma / d - beta_rate;
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = gamma_dot_value_of_beta_rate / ss;
    // delta' = rr*beta_rate*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_value = delta_dot_value_of_beta_rate;
    // phi' = -rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) + e*cos(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_value = -gamma_dot_value_of_beta_rate * delta_dot_value_of_place / e
        - delta_dot_value_of_beta_rate;
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = epsilon_dot_value_of_beta_rate;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = gamma_dot_value_of_beta_rate * epsilon_dot_value_of_place / zf
        - epsilon_dot_value_of_beta_rate;
    [
        beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
        epsilon_dot_value, omega_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 109 operations, 7 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> S {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, d, da, e, ea, rr, ra, ss, sa, sb,
        ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    // Shared terms.
    let cos_angle_inv = S::int(1) / cos_angle;
    let ss_inv = S::int(1) / ss;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let energy_of_place = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let energy_of_place_2 = S::int(2) * energy_of_place * sin_omega;
    let energy_of_place_sq = energy_of_place * energy_of_place;
    let u_2_inv = S::int(1) / u_2;
    let energy_of_place_3 = zf_inv * sin_gamma_minus_epsilon;
    let cos_omega_inv = S::int(1) / cos_omega;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let energy_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let energy_of_place_5 = S::int(2) * energy_of_place_4 * cos_phi_minus_90deg;
    let energy_of_place_4_sq = energy_of_place_4 * energy_of_place_4;
    let zt_inv = S::int(1) / zt;
    let energy_of_place_6 = e_inv * cos_gamma_minus_delta;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let m2_da = m2 * da;
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    let energy_of_d_beta_gamma = cos_beta_minus_gamma / d;
    // Values.
    // T = beta_rate^2*(I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 +
    //   sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta
    //   + theta - gamma) - 2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma)))/2
    let energy = S::ratio(1, 2) * beta_rate * beta_rate
        * (I1 + m1 * ra * ra
            + rr * rr
                * (m2
                    + cos_angle_inv
                        * (cos_angle_inv
                            * (sin_theta * sin_theta
                                * (ss_inv * ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa))
                                    + cos_omega_inv * cos_omega_inv
                                        * (m6
                                            * (sin_gamma_minus_epsilon
                                                * (sin_gamma_minus_epsilon - energy_of_place_2
                                                    + fa_zf_inv
                                                        * (sin_gamma_minus_epsilon * (fa_zf_inv - S::int(2))
                                                            + energy_of_place_2)) + energy_of_place_sq)
                                            + energy_of_place_sq * u_2_inv * u_2_inv
                                                * (I7 + m7 * ub.mul_add(ub, ua * ua))
                                            + I6 * energy_of_place_3 * energy_of_place_3)
                                    + sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv
                                        * (m4
                                            * (cos_gamma_minus_delta
                                                * (cos_gamma_minus_delta - energy_of_place_5
                                                    + ea_e_inv
                                                        * (cos_gamma_minus_delta * (ea_e_inv - S::int(2))
                                                            + energy_of_place_5)) + energy_of_place_4_sq)
                                            + energy_of_place_4_sq * zt_inv * zt_inv
                                                * (I5 + m5 * tb.mul_add(tb, ta * ta))
                                            + I4 * energy_of_place_6 * energy_of_place_6))
                                + energy_of_d_beta_gamma * energy_of_d_beta_gamma
                                    * da.mul_add(m2_da, I2))
                            - S::int(2) * m2_da * energy_of_d_beta_gamma * cos_theta)));
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 459 operations, 8 sines and cosines, 1 other function.
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
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // beta + theta - gamma
    let d1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // 2 - fa_zf_inv
    let d1_of_zf_fa = S::int(2) - fa_zf_inv;
    // -d1_of_zf_fa
    let minus_d1_of_zf_fa = -d1_of_zf_fa;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let d1_of_place_2 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let d1_of_place_3 = d1_of_place_2 * sin_omega_doubled;
    // sin(gamma - epsilon) - d1_of_place_3
    let d1_of_place_4 = sin_gamma_minus_epsilon - d1_of_place_3;
    let d1_of_place_2_sq = d1_of_place_2 * d1_of_place_2;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_5 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_5 = u_2_inv * d1_of_place_5;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let d1_of_place_6 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let d1_of_place_7 = S::int(2) * cos_phi_minus_90deg;
    let d1_of_place_8 = d1_of_place_6 * d1_of_place_7;
    // cos(gamma - delta) - d1_of_place_8
    let d1_of_place_9 = cos_gamma_minus_delta - d1_of_place_8;
    let d1_of_place_6_sq = d1_of_place_6 * d1_of_place_6;
    let d1_of_place_10 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let d1_of_place_11 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_d1_of_place_11 = zt_inv * d1_of_place_11;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let d1_of_place_12 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
    // cos_omega_inv_sq*(m6*(sin(gamma - epsilon)*(fa_zf_inv*(minus_d1_of_zf_fa*sin(gamma - epsilon) +
    //   d1_of_place_3) + d1_of_place_4) + d1_of_place_2_sq) + d1_of_place_2_sq*u_2_inv_d1_of_place_5 +
    //   zf_inv_i6_zf_inv*sin(gamma - epsilon)^2) + d1_of_place_12*(m4*(cos(gamma -
    //   delta)*(ea_e_inv*(d1_of_e_ea*cos(gamma - delta) + d1_of_place_8) + d1_of_place_9) +
    //   d1_of_place_6_sq) + I4*d1_of_place_10^2 + d1_of_place_6_sq*zt_inv_d1_of_place_11)
    let d1_of_place_13 = cos_omega_inv_sq
        * (m6
            * (sin_gamma_minus_epsilon
                * (fa_zf_inv * minus_d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_3)
                    + d1_of_place_4) + d1_of_place_2_sq) + d1_of_place_2_sq * u_2_inv_d1_of_place_5
            + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon)
        + d1_of_place_12
            * (m4
                * (cos_gamma_minus_delta
                    * (ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, d1_of_place_8)
                        + d1_of_place_9) + d1_of_place_6_sq) + I4 * d1_of_place_10 * d1_of_place_10
                + d1_of_place_6_sq * zt_inv_d1_of_place_11);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_14 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_14 = ss_inv * d1_of_place_14;
    // d1_of_place_13 + ss_inv_d1_of_place_14
    let d1_of_place_15 = d1_of_place_13 + ss_inv_d1_of_place_14;
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
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let d1 = I1 + m1 * ra * ra
        + rr * rr
            * (m2
                + cos_angle_inv
                    * (cos_angle_inv
                        * (d1_of_place_15 * sin_theta * sin_theta
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
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = minus_d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let beta_rate_dot_of_place_3 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_of_place_3
    let beta_rate_dot_of_place_4 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_of_place_3);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let beta_rate_dot_of_place_5 = d1_of_place_2 * cos_omega_inv;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_6 = d1_of_place_2
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_4);
    let beta_rate_dot_of_place_7 = beta_rate_dot_of_zf_fa * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_8 = S::int(2) * sin_angle_cos_angle_inv;
    let fa_ss_inv = fa * ss_inv;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_9 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_10 = beta_rate_dot_of_place_4 * sin_omega;
    let beta_rate_dot_of_place_11 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_12 = beta_rate_dot_of_place_11 * sin_omega;
    let beta_rate_dot_of_place_13 = zf_inv * beta_rate_dot_of_place_12;
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let beta_rate_dot_of_place_14 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    let beta_rate_dot_of_place_15 = sin_gamma_minus_delta * cos_phi_minus_90deg;
    // beta_rate_dot_of_place_15 - cos(gamma - delta)*sin(phi_minus_90deg)
    let beta_rate_dot_of_place_16 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, beta_rate_dot_of_place_15);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    let beta_rate_dot_of_place_17 = d1_of_place_6 * sin_phi_minus_90deg_inv;
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_18 = d1_of_place_6
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_16);
    let beta_rate_dot_of_place_19 = beta_rate_dot_of_e_ea * cos_gamma_minus_delta;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_20 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_21 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_of_place_22 = beta_rate_dot_of_place_16 * cos_phi_minus_90deg;
    let beta_rate_dot_of_place_23 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_24 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let beta_rate_dot_of_place_25 = d1_of_d_beta_gamma * rr_cos_angle_inv;
    // sin(beta - gamma) - beta_rate_dot_of_place_23*beta_rate_dot_of_place_25
    let beta_rate_dot_of_place_26 = (-beta_rate_dot_of_place_23)
        .mul_add(beta_rate_dot_of_place_25, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_27 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // beta_rate' = (mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta -
    //   gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_27 * (l0 - beta_rate_dot_of_place_27)
                    * (-sd)
                        .mul_add(beta_rate_dot_of_place_2, sc * beta_rate_dot_of_place)
                    / (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
                        + sd * beta_rate_dot_of_place.mul_add(S::int(2), sd)
                        + sc * beta_rate_dot_of_place_2.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (m2_da_d1_of_d_beta_gamma
                            + cos_angle_inv
                                * (rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_omega_inv_sq
                                                    * (d1_of_place_2
                                                        * (u_2_inv
                                                            * (cos_omega_inv
                                                                * (sin_gamma_minus_epsilon
                                                                    * (zf_inv
                                                                        * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                            - beta_rate_dot_of_place_4 * d1_of_place_5
                                                                            + sin_omega_cos_omega_inv
                                                                                * (d1_of_place_2
                                                                                    * sin_omega_doubled.mul_add(m6_fa, -d1_of_place_5)
                                                                                    + beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                        + m6
                                                                            * d1_of_place_4
                                                                                .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                    + d1_of_place_2 * sin_omega
                                                                        * (beta_rate_dot_of_place_5 * (m6 + u_2_inv_d1_of_place_5)
                                                                            + m6 * beta_rate_dot_of_zf_fa * cos_gamma_minus_epsilon))
                                                                + u_2_inv * ss_inv
                                                                    * (m7 * ua_sq_plus_ub_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_6,
                                                                            I7 * beta_rate_dot_of_place_6,
                                                                        ) + m6 * d1_of_place_2 * beta_rate_dot_of_place_7)
                                                            + m6
                                                                * (ss_inv
                                                                    * (beta_rate_dot_of_place_6
                                                                        + sin_omega
                                                                            * (-beta_rate_dot_of_place_8)
                                                                                .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon))
                                                                    - zf_inv
                                                                        * (sin_gamma_minus_epsilon
                                                                            * (beta_rate_dot_of_place_7
                                                                                + beta_rate_dot_of_place_4 * cos_omega_inv
                                                                                + sin_omega
                                                                                    * (cos_omega_inv_sq
                                                                                        * sin_omega_doubled
                                                                                            .mul_add(beta_rate_dot_of_place_7, d1_of_place_2)
                                                                                        - beta_rate_dot_of_place_8 * fa_ss_inv))
                                                                            + beta_rate_dot_of_place_3 * fa_ss_inv)))
                                                        + sin_gamma_minus_epsilon
                                                            * (m6
                                                                * (zf_inv
                                                                    * (beta_rate_dot_of_place_12
                                                                        * (beta_rate_dot_of_place_4 - beta_rate_dot_of_place_11)
                                                                        + fa
                                                                            * (ss_inv
                                                                                * d1_of_zf_fa
                                                                                    .mul_add(
                                                                                        beta_rate_dot_of_place_9,
                                                                                        beta_rate_dot_of_place_10,
                                                                                    )
                                                                                - beta_rate_dot_of_place_13
                                                                                    * minus_d1_of_zf_fa
                                                                                        .mul_add(
                                                                                            beta_rate_dot_of_place_11,
                                                                                            beta_rate_dot_of_place_4,
                                                                                        )))
                                                                    - ss_inv
                                                                        * (beta_rate_dot_of_place_9 + beta_rate_dot_of_place_10))
                                                                - zf_inv_i6_zf_inv
                                                                    * beta_rate_dot_of_place_11
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_13,
                                                                            ss_inv * beta_rate_dot_of_place_9,
                                                                        )))
                                                    + ss_inv * ss_inv_d1_of_place_14 * sin_angle_cos_angle_inv
                                                    + d1_of_place_12
                                                        * (cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-(d1_of_place_10 * beta_rate_dot_of_place_14))
                                                                    .mul_add(
                                                                        beta_rate_dot_of_place_20,
                                                                        ss_inv * beta_rate_dot_of_place_21,
                                                                    )
                                                                + m4
                                                                    * (e_inv
                                                                        * (ea
                                                                            * (e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (beta_rate_dot_of_place_14
                                                                                        * (-d1_of_e_ea)
                                                                                            .mul_add(
                                                                                                beta_rate_dot_of_place_20,
                                                                                                beta_rate_dot_of_place_16,
                                                                                            ) + sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                    + ea_ss_inv * sin_gamma_minus_delta)
                                                                                + ss_inv
                                                                                    * (-beta_rate_dot_of_place_21)
                                                                                        .mul_add(S::int(2), beta_rate_dot_of_place_22))
                                                                            - beta_rate_dot_of_place_14 * cos_gamma_minus_delta
                                                                                * (beta_rate_dot_of_place_16 + beta_rate_dot_of_place_20))
                                                                        + ss_inv
                                                                            * (beta_rate_dot_of_place_21 - beta_rate_dot_of_place_22)))
                                                            - d1_of_place_6
                                                                * (zt_inv
                                                                    * (sin_phi_minus_90deg_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (e_inv
                                                                                * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                    - beta_rate_dot_of_place_16 * d1_of_place_11
                                                                                    + beta_rate_dot_of_place_14
                                                                                        * (d1_of_place_6
                                                                                            * d1_of_place_7.mul_add(m4_ea, d1_of_place_11)
                                                                                            + beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                                + m4
                                                                                    * d1_of_place_9
                                                                                        .mul_add(beta_rate_dot_of_place_14, sin_gamma_minus_delta))
                                                                            + d1_of_place_6 * cos_phi_minus_90deg
                                                                                * (beta_rate_dot_of_place_17 * (m4 + zt_inv_d1_of_place_11)
                                                                                    + m4 * beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                        - zt_inv * ss_inv
                                                                            * (m5 * ta_sq_plus_tb_sq)
                                                                                .mul_add(
                                                                                    beta_rate_dot_of_place_18,
                                                                                    I5 * beta_rate_dot_of_place_18,
                                                                                ) + m4 * d1_of_place_6 * beta_rate_dot_of_place_19)
                                                                    + m4
                                                                        * (ss_inv
                                                                            * (cos_phi_minus_90deg
                                                                                * beta_rate_dot_of_place_8
                                                                                    .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta)
                                                                                - beta_rate_dot_of_place_18)
                                                                            + e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (beta_rate_dot_of_place_19
                                                                                        - beta_rate_dot_of_place_16 * sin_phi_minus_90deg_inv
                                                                                        + cos_phi_minus_90deg
                                                                                            * (d1_of_place_12
                                                                                                * d1_of_place_7
                                                                                                    .mul_add(beta_rate_dot_of_place_19, d1_of_place_6)
                                                                                                - beta_rate_dot_of_place_8 * ea_ss_inv))
                                                                                    - beta_rate_dot_of_place_15 * ea_ss_inv)))))
                                                - d1_of_place_15 * d1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            - d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (d1_of_place_13
                                                        + ss_inv * m2_da.mul_add(sin_angle, d1_of_place_14))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_23)))
                                        + m2_da * d_inv
                                            * (-d1_of_d_beta_gamma)
                                                .mul_add(
                                                    cos_beta_minus_gamma,
                                                    ss_inv * beta_rate_dot_of_place_24,
                                                )) + d1_of_place_15 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_26,
                                    rr * beta_rate_dot_of_place_23 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_26)
                        - m2_da * beta_rate_dot_of_place_24))) / d1;
    let gamma_dot_value_of_beta_rate = beta_rate * rr_cos_angle_inv * sin_theta;
    let delta_dot_value_of_beta_rate = zt_inv * gamma_dot_value_of_beta_rate;
    let epsilon_dot_value_of_beta_rate = u_2_inv * gamma_dot_value_of_beta_rate;
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = beta_rate * (beta_rate_dot_of_place_25 - S::int(1));
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = ss_inv * gamma_dot_value_of_beta_rate;
    // delta' = rr*beta_rate*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_value = beta_rate_dot_of_place_17 * delta_dot_value_of_beta_rate;
    // phi' = -rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) + e*cos(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_value = -e_inv * sin_phi_minus_90deg_inv * delta_dot_value_of_beta_rate
        * e.mul_add(d1_of_place_6, zt * cos_gamma_minus_delta);
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = beta_rate_dot_of_place_5 * epsilon_dot_value_of_beta_rate;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = zf_inv * cos_omega_inv * epsilon_dot_value_of_beta_rate
        * (-zf).mul_add(d1_of_place_2, u_2 * sin_gamma_minus_epsilon);
    (
        [
            beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
            epsilon_dot_value, omega_dot_value,
        ],
        [beta_rate_dot],
    )
}

/// Jacobian of the derivative by the state; columns beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega, beta_rate.
///
/// 1769 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [[S; 8]; 8] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // beta + theta - gamma
    let d1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let d1_of_zf_fa = fa_zf_inv - S::int(2);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    let d1_of_place_2 = sin_gamma_minus_epsilon * sin_omega;
    let d1_of_place_3 = cos_gamma_minus_epsilon * cos_omega;
    // d1_of_place_2 + d1_of_place_3
    let d1_of_place_4 = d1_of_place_2 + d1_of_place_3;
    let sin_omega_d1_of_place_4 = d1_of_place_4 * sin_omega;
    let d1_of_place_5 = S::int(2) * sin_omega_d1_of_place_4;
    // sin(gamma - epsilon) - d1_of_place_5
    let d1_of_place_6 = sin_gamma_minus_epsilon - d1_of_place_5;
    // fa_zf_inv*(d1_of_zf_fa*sin(gamma - epsilon) + d1_of_place_5) + d1_of_place_6
    let d1_of_place_7 = fa_zf_inv
        * d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_5) + d1_of_place_6;
    let d1_of_place_8 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    let d1_of_place_4_u_2_inv = d1_of_place_4 * u_2_inv;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // I7 + m7*ua_sq_plus_ub_sq
    let d1_of_m7_i7_ua_ub = m7.mul_add(ua_sq_plus_ub_sq, I7);
    let d1_of_place_9 = d1_of_place_4_u_2_inv * d1_of_m7_i7_ua_ub;
    // m6*(cos(gamma - epsilon - omega)^2 + d1_of_place_7*sin(gamma - epsilon)) + I6*d1_of_place_8^2 +
    //   d1_of_place_4_u_2_inv*d1_of_place_9
    let d1_of_place_10 = m6
        * d1_of_place_7.mul_add(sin_gamma_minus_epsilon, d1_of_place_4 * d1_of_place_4)
        + I6 * d1_of_place_8 * d1_of_place_8 + d1_of_place_4_u_2_inv * d1_of_place_9;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    let d1_of_place_11 = d1_of_e_ea * cos_gamma_minus_delta;
    let d1_of_place_12 = cos_gamma_minus_delta * cos_phi_minus_90deg;
    // sin(gamma - delta)*sin(phi_minus_90deg) + d1_of_place_12
    let d1_of_place_13 = sin_gamma_minus_delta
        .mul_add(sin_phi_minus_90deg, d1_of_place_12);
    let d1_of_place_14 = d1_of_place_13 * cos_phi_minus_90deg;
    let d1_of_place_14_doubled = S::int(2) * d1_of_place_14;
    // cos(gamma - delta) - d1_of_place_14_doubled
    let d1_of_place_15 = cos_gamma_minus_delta - d1_of_place_14_doubled;
    // ea_e_inv*(d1_of_place_11 + d1_of_place_14_doubled) + d1_of_place_15
    let d1_of_place_16 = ea_e_inv * (d1_of_place_11 + d1_of_place_14_doubled) + d1_of_place_15;
    let d1_of_place_17 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    let d1_of_place_13_zt_inv = d1_of_place_13 * zt_inv;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // I5 + m5*ta_sq_plus_tb_sq
    let d1_of_m5_i5_ta_tb = m5.mul_add(ta_sq_plus_tb_sq, I5);
    let d1_of_place_18 = d1_of_place_13_zt_inv * d1_of_m5_i5_ta_tb;
    // m4*(cos(gamma - delta - phi_minus_90deg)^2 + d1_of_place_16*cos(gamma - delta)) +
    //   I4*d1_of_place_17^2 + d1_of_place_13_zt_inv*d1_of_place_18
    let d1_of_place_19 = m4
        * d1_of_place_16.mul_add(cos_gamma_minus_delta, d1_of_place_13 * d1_of_place_13)
        + I4 * d1_of_place_17 * d1_of_place_17 + d1_of_place_13_zt_inv * d1_of_place_18;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let d1_of_place_20 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
    // d1_of_place_10*cos_omega_inv_sq + d1_of_place_19*d1_of_place_20
    let d1_of_place_21 = d1_of_place_19
        .mul_add(d1_of_place_20, d1_of_place_10 * cos_omega_inv_sq);
    let ss_inv = S::int(1) / ss;
    // sa^2 + sb^2
    let sa_sq_plus_sb_sq = sb.mul_add(sb, sa * sa);
    // ss_inv*(I3 + m3*sa_sq_plus_sb_sq)
    let d1_of_place_22 = ss_inv * m3.mul_add(sa_sq_plus_sb_sq, I3);
    // d1_of_place_21 + ss_inv*d1_of_place_22
    let d1_of_place_23 = ss_inv.mul_add(d1_of_place_22, d1_of_place_21);
    let sin_theta_d1_of_place_23 = d1_of_place_23 * sin_theta;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d1_of_place_24 = d1_of_d_beta_gamma * i2_plus_da_m2_da;
    // cos_angle_inv*(sin_theta_d1_of_place_23*sin(theta) + d1_of_d_beta_gamma*d1_of_place_24)
    let d1_of_place_25 = cos_angle_inv
        * d1_of_d_beta_gamma
            .mul_add(d1_of_place_24, sin_theta_d1_of_place_23 * sin_theta);
    let cos_theta_m2_da = m2_da * cos_theta;
    let d1_of_place_26 = d1_of_d_beta_gamma * cos_theta_m2_da;
    // d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) -
    //   2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))
    let d1 = I1 + m1 * ra * ra
        + rr * rr
            * (m2 + cos_angle_inv * (-d1_of_place_26).mul_add(S::int(2), d1_of_place_25));
    let d1_by_beta_of_d_beta_gamma = d_inv * sin_beta_minus_gamma;
    let d1_by_beta_of_place = cos_theta_m2_da * d1_by_beta_of_d_beta_gamma;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let rr_doubled = S::int(2) * rr;
    let d1_by_beta_of_place_2 = rr_cos_angle_inv * rr_doubled;
    // d1_by_beta = 2*rr^2*(m2*da*cos(theta)*sin(beta - gamma)/d - (sin(beta - gamma)*cos(beta - gamma)*(I2
    //   + m2*da^2)/d^2 + sin(beta + theta - gamma)*(m2*da*cos(theta)*cos(beta - gamma)/d - (cos(beta -
    //   gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))/cos(beta + theta - gamma)
    let d1_by_beta = d1_by_beta_of_place_2
        * (cos_angle_inv
            * (sin_angle * (d1_of_place_25 - d1_of_place_26)
                - d1_of_place_24 * d1_by_beta_of_d_beta_gamma) + d1_by_beta_of_place);
    let d1_inv = S::int(1) / d1;
    let rr_beta_rate = rr * beta_rate;
    let beta_rate_rr_beta_rate = beta_rate * rr_beta_rate;
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
    let beta_rate_dot_by_beta_of_place_20 = d1_of_zf_fa * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_21 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_by_beta_of_place_21
    let beta_rate_dot_by_beta_of_place_22 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_by_beta_of_place_21);
    let beta_rate_dot_by_beta_of_place_23 = S::int(3) * beta_rate_dot_by_beta_of_place_22;
    // sin(omega)*(cos(gamma - epsilon - omega)*beta_rate_dot_by_beta_of_place_19 +
    //   beta_rate_dot_by_beta_of_place_23)
    let beta_rate_dot_by_beta_of_place_24 = sin_omega
        * d1_of_place_4
            .mul_add(
                beta_rate_dot_by_beta_of_place_19, beta_rate_dot_by_beta_of_place_23,
            );
    // 3*cos(gamma - epsilon) - beta_rate_dot_by_beta_of_place_12*sin(gamma - epsilon)
    let beta_rate_dot_by_beta_of_place_25 = (-beta_rate_dot_by_beta_of_place_12)
        .mul_add(sin_gamma_minus_epsilon, S::int(3) * cos_gamma_minus_epsilon);
    // cos(gamma - epsilon - omega)*beta_rate_dot_by_beta_of_place_12 + beta_rate_dot_by_beta_of_place_23
    let beta_rate_dot_by_beta_of_place_26 = d1_of_place_4
        .mul_add(beta_rate_dot_by_beta_of_place_12, beta_rate_dot_by_beta_of_place_23);
    // 1 - fa_zf_inv
    let beta_rate_dot_by_beta_of_zf_fa = S::int(1) - fa_zf_inv;
    // -beta_rate_dot_by_beta_of_zf_fa
    let beta_rate_dot_by_beta_of_zf_fa_2 = -beta_rate_dot_by_beta_of_zf_fa;
    let beta_rate_dot_by_beta_of_place_27 = beta_rate_dot_by_beta_of_zf_fa_2
        * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_28 = beta_rate_dot_by_beta_of_place_27 * sin_omega;
    let i6_zf_inv = I6 * zf_inv;
    let d1_of_place_8_i6_zf_inv = d1_of_place_8 * i6_zf_inv;
    let beta_rate_dot_by_beta_of_place_29 = d1_of_e_ea * sin_gamma_minus_delta;
    // sin(gamma - delta)*cos(phi_minus_90deg) - cos(gamma - delta)*sin(phi_minus_90deg)
    let beta_rate_dot_by_beta_of_place_30 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, sin_gamma_minus_delta * cos_phi_minus_90deg);
    let beta_rate_dot_by_beta_of_place_31 = S::int(3) * beta_rate_dot_by_beta_of_place_30;
    // cos(phi_minus_90deg)*(cos(gamma - delta - phi_minus_90deg)*beta_rate_dot_by_beta_of_place_19 +
    //   beta_rate_dot_by_beta_of_place_31)
    let beta_rate_dot_by_beta_of_place_32 = cos_phi_minus_90deg
        * d1_of_place_13
            .mul_add(
                beta_rate_dot_by_beta_of_place_19, beta_rate_dot_by_beta_of_place_31,
            );
    // 3*sin(gamma - delta) + beta_rate_dot_by_beta_of_place_12*cos(gamma - delta)
    let beta_rate_dot_by_beta_of_place_33 = beta_rate_dot_by_beta_of_place_12
        .mul_add(cos_gamma_minus_delta, S::int(3) * sin_gamma_minus_delta);
    // cos(gamma - delta - phi_minus_90deg)*beta_rate_dot_by_beta_of_place_12 +
    //   beta_rate_dot_by_beta_of_place_31
    let beta_rate_dot_by_beta_of_place_34 = d1_of_place_13
        .mul_add(beta_rate_dot_by_beta_of_place_12, beta_rate_dot_by_beta_of_place_31);
    // ea_e_inv - 1
    let beta_rate_dot_by_beta_of_e_ea = ea_e_inv - S::int(1);
    let beta_rate_dot_by_beta_of_place_35 = beta_rate_dot_by_beta_of_e_ea * sin_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_36 = beta_rate_dot_by_beta_of_place_35 * cos_phi_minus_90deg;
    let i4_e_inv = I4 * e_inv;
    let d1_of_place_17_i4_e_inv = d1_of_place_17 * i4_e_inv;
    let ss_inv_sq = ss_inv * ss_inv;
    let beta_rate_dot_by_beta_of_place_37 = u_2_inv * d1_of_m7_i7_ua_ub;
    let sin_omega_doubled = S::int(2) * sin_omega;
    let m6_fa = m6 * fa;
    // beta_rate_dot_by_beta_of_place_37 - sin_omega_doubled*m6_fa
    let beta_rate_dot_by_beta_of_place_38 = (-sin_omega_doubled)
        .mul_add(m6_fa, beta_rate_dot_by_beta_of_place_37);
    // i6_zf_inv + d1_of_zf_fa*m6_fa
    let beta_rate_dot_by_beta_of_m6_i6_zf_fa = d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let beta_rate_dot_by_beta_of_place_39 = beta_rate_dot_by_beta_of_m6_i6_zf_fa
        * sin_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_39 - cos(gamma - epsilon - omega)*beta_rate_dot_by_beta_of_place_38
    let beta_rate_dot_by_beta_of_place_40 = (-d1_of_place_4)
        .mul_add(beta_rate_dot_by_beta_of_place_38, beta_rate_dot_by_beta_of_place_39);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    let beta_rate_dot_by_beta_of_place_41 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_beta_of_place_37;
    let beta_rate_dot_by_beta_of_place_42 = beta_rate_dot_by_beta_of_m6_i6_zf_fa
        * cos_gamma_minus_epsilon;
    // m6*(cos(gamma - epsilon) + d1_of_place_6*sin_omega_cos_omega_inv) +
    //   zf_inv*(beta_rate_dot_by_beta_of_place_40*sin_omega_cos_omega_inv -
    //   beta_rate_dot_by_beta_of_place_41 + beta_rate_dot_by_beta_of_place_42)
    let beta_rate_dot_by_beta_of_place_43 = m6
        * d1_of_place_6.mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon)
        + zf_inv
            * (beta_rate_dot_by_beta_of_place_40
                .mul_add(sin_omega_cos_omega_inv, -beta_rate_dot_by_beta_of_place_41)
                + beta_rate_dot_by_beta_of_place_42);
    // m6 + u_2_inv*beta_rate_dot_by_beta_of_place_37
    let beta_rate_dot_by_beta_of_place_44 = u_2_inv
        .mul_add(beta_rate_dot_by_beta_of_place_37, m6);
    let beta_rate_dot_by_beta_of_place_45 = d1_of_place_4 * cos_omega_inv;
    let beta_rate_dot_by_beta_of_place_46 = beta_rate_dot_by_beta_of_place_44
        * beta_rate_dot_by_beta_of_place_45;
    // m6*beta_rate_dot_by_beta_of_place_27 + beta_rate_dot_by_beta_of_place_46
    let beta_rate_dot_by_beta_of_place_47 = m6
        .mul_add(beta_rate_dot_by_beta_of_place_27, beta_rate_dot_by_beta_of_place_46);
    // beta_rate_dot_by_beta_of_place_43*sin(gamma - epsilon) +
    //   sin_omega_d1_of_place_4*beta_rate_dot_by_beta_of_place_47
    let beta_rate_dot_by_beta_of_place_48 = sin_omega_d1_of_place_4
        .mul_add(
            beta_rate_dot_by_beta_of_place_47,
            beta_rate_dot_by_beta_of_place_43 * sin_gamma_minus_epsilon,
        );
    let beta_rate_dot_by_beta_of_place_49 = beta_rate_dot_by_beta_of_zf_fa_2
        * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon - omega) + sin_omega_doubled*beta_rate_dot_by_beta_of_place_49
    let beta_rate_dot_by_beta_of_place_50 = sin_omega_doubled
        .mul_add(beta_rate_dot_by_beta_of_place_49, d1_of_place_4);
    // sin(gamma - epsilon - omega) + sin_omega_cos_omega_inv*beta_rate_dot_by_beta_of_place_50
    let beta_rate_dot_by_beta_of_place_51 = sin_omega_cos_omega_inv
        .mul_add(beta_rate_dot_by_beta_of_place_50, beta_rate_dot_by_beta_of_place_22);
    let beta_rate_dot_by_beta_of_place_52 = cos_omega_inv * sin_gamma_minus_epsilon;
    // sin(gamma - epsilon - omega) + d1_of_zf_fa*beta_rate_dot_by_beta_of_place_52
    let beta_rate_dot_by_beta_of_place_53 = d1_of_zf_fa
        .mul_add(beta_rate_dot_by_beta_of_place_52, beta_rate_dot_by_beta_of_place_22);
    // sin(gamma - epsilon - omega) - beta_rate_dot_by_beta_of_place_52
    let beta_rate_dot_by_beta_of_place_54 = beta_rate_dot_by_beta_of_place_22
        - beta_rate_dot_by_beta_of_place_52;
    // d1_of_place_8 - d1_of_place_4_u_2_inv
    let beta_rate_dot_by_beta_of_place_55 = d1_of_place_8 - d1_of_place_4_u_2_inv;
    let m6_d1_of_place_4 = m6 * d1_of_place_4;
    let zt_inv_d1_of_m5_i5_ta_tb = zt_inv * d1_of_m5_i5_ta_tb;
    let beta_rate_dot_by_beta_of_place_56 = S::int(2) * cos_phi_minus_90deg;
    let m4_ea = m4 * ea;
    // zt_inv_d1_of_m5_i5_ta_tb + beta_rate_dot_by_beta_of_place_56*m4_ea
    let beta_rate_dot_by_beta_of_place_57 = beta_rate_dot_by_beta_of_place_56
        .mul_add(m4_ea, zt_inv_d1_of_m5_i5_ta_tb);
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_by_beta_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let beta_rate_dot_by_beta_of_place_58 = beta_rate_dot_by_beta_of_m4_i4_e_ea
        * cos_gamma_minus_delta;
    // cos(gamma - delta - phi_minus_90deg)*beta_rate_dot_by_beta_of_place_57 +
    //   beta_rate_dot_by_beta_of_place_58
    let beta_rate_dot_by_beta_of_place_59 = d1_of_place_13
        .mul_add(beta_rate_dot_by_beta_of_place_57, beta_rate_dot_by_beta_of_place_58);
    let beta_rate_dot_by_beta_of_place_60 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    let beta_rate_dot_by_beta_of_place_61 = beta_rate_dot_by_beta_of_place_30
        * zt_inv_d1_of_m5_i5_ta_tb;
    let beta_rate_dot_by_beta_of_place_62 = beta_rate_dot_by_beta_of_m4_i4_e_ea
        * sin_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_place_59*beta_rate_dot_by_beta_of_place_60 -
    //   beta_rate_dot_by_beta_of_place_61 + beta_rate_dot_by_beta_of_place_62
    let beta_rate_dot_by_beta_of_place_63 = beta_rate_dot_by_beta_of_place_59
        .mul_add(beta_rate_dot_by_beta_of_place_60, -beta_rate_dot_by_beta_of_place_61)
        + beta_rate_dot_by_beta_of_place_62;
    let beta_rate_dot_by_beta_of_place_64 = beta_rate_dot_by_beta_of_e_ea * cos_gamma_minus_delta;
    // cos(gamma - delta - phi_minus_90deg) +
    //   beta_rate_dot_by_beta_of_place_56*beta_rate_dot_by_beta_of_place_64
    let beta_rate_dot_by_beta_of_place_65 = beta_rate_dot_by_beta_of_place_56
        .mul_add(beta_rate_dot_by_beta_of_place_64, d1_of_place_13);
    let beta_rate_dot_by_beta_of_place_66 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    // sin(gamma - delta - phi_minus_90deg) - d1_of_e_ea*beta_rate_dot_by_beta_of_place_66
    let beta_rate_dot_by_beta_of_place_67 = (-d1_of_e_ea)
        .mul_add(beta_rate_dot_by_beta_of_place_66, beta_rate_dot_by_beta_of_place_30);
    // -beta_rate_dot_by_beta_of_place_67
    let beta_rate_dot_by_beta_of_place_68 = -beta_rate_dot_by_beta_of_place_67;
    // sin(gamma - delta - phi_minus_90deg) + beta_rate_dot_by_beta_of_place_66
    let beta_rate_dot_by_beta_of_place_69 = beta_rate_dot_by_beta_of_place_30
        + beta_rate_dot_by_beta_of_place_66;
    // cos(gamma - delta - phi_minus_90deg)*(zt_inv*beta_rate_dot_by_beta_of_place_63 +
    //   m4*(beta_rate_dot_by_beta_of_place_60*beta_rate_dot_by_beta_of_place_65 - sin(gamma - delta -
    //   phi_minus_90deg))) + d1_of_place_12*(sin_phi_minus_90deg_inv*d1_of_place_17_i4_e_inv +
    //   m4*(ea_e_inv*beta_rate_dot_by_beta_of_place_68 + beta_rate_dot_by_beta_of_place_69))
    let beta_rate_dot_by_beta_of_place_70 = d1_of_place_13
        * (m4
            * beta_rate_dot_by_beta_of_place_60
                .mul_add(
                    beta_rate_dot_by_beta_of_place_65, -beta_rate_dot_by_beta_of_place_30,
                ) + zt_inv * beta_rate_dot_by_beta_of_place_63)
        + d1_of_place_12
            * (m4
                * ea_e_inv
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_68, beta_rate_dot_by_beta_of_place_69,
                    ) + sin_phi_minus_90deg_inv * d1_of_place_17_i4_e_inv);
    // sin(gamma - delta) + d1_of_place_15*beta_rate_dot_by_beta_of_place_60
    let beta_rate_dot_by_beta_of_place_71 = d1_of_place_15
        .mul_add(beta_rate_dot_by_beta_of_place_60, sin_gamma_minus_delta);
    let beta_rate_dot_by_beta_of_place_72 = m4 * beta_rate_dot_by_beta_of_place_71;
    // m4 + zt_inv*zt_inv_d1_of_m5_i5_ta_tb
    let beta_rate_dot_by_beta_of_place_73 = zt_inv.mul_add(zt_inv_d1_of_m5_i5_ta_tb, m4);
    let beta_rate_dot_by_beta_of_place_74 = d1_of_place_13 * sin_phi_minus_90deg_inv;
    // m4*beta_rate_dot_by_beta_of_place_35 +
    //   beta_rate_dot_by_beta_of_place_73*beta_rate_dot_by_beta_of_place_74
    let beta_rate_dot_by_beta_of_place_75 = beta_rate_dot_by_beta_of_place_73
        .mul_add(
            beta_rate_dot_by_beta_of_place_74,
            m4 * beta_rate_dot_by_beta_of_place_35,
        );
    let beta_rate_dot_by_beta_of_place_76 = d1_of_place_14 * beta_rate_dot_by_beta_of_place_75;
    // d1_of_place_17 + d1_of_place_13_zt_inv
    let beta_rate_dot_by_beta_of_place_77 = d1_of_place_17 + d1_of_place_13_zt_inv;
    let m4_d1_of_place_13 = m4 * d1_of_place_13;
    // cos_omega_inv_sq*(cos_omega_inv*(cos(gamma - epsilon -
    //   omega)*(u_2_inv*beta_rate_dot_by_beta_of_place_48 -
    //   m6*d1_of_place_8*beta_rate_dot_by_beta_of_place_51) +
    //   d1_of_place_2*d1_of_place_8*(m6*(beta_rate_dot_by_beta_of_place_54 -
    //   fa_zf_inv*beta_rate_dot_by_beta_of_place_53) - cos_omega_inv*d1_of_place_8_i6_zf_inv)) -
    //   m6_d1_of_place_4*sin(gamma - epsilon)*(d1_of_place_4_u_2_inv +
    //   zf_inv*(fa*beta_rate_dot_by_beta_of_place_55 - sin(gamma - epsilon)))) +
    //   d1_of_place_20*(m4_d1_of_place_13*cos(gamma - delta)*(d1_of_place_13_zt_inv + e_inv*(cos(gamma -
    //   delta) - ea*beta_rate_dot_by_beta_of_place_77)) - sin_phi_minus_90deg_inv*(cos(gamma -
    //   delta)*(e_inv*beta_rate_dot_by_beta_of_place_70 +
    //   d1_of_place_13_zt_inv*beta_rate_dot_by_beta_of_place_72) +
    //   d1_of_place_13_zt_inv*beta_rate_dot_by_beta_of_place_76))
    let beta_rate_dot_by_beta_of_place_78 = cos_omega_inv_sq
        * (cos_omega_inv
            * (d1_of_place_4
                * (-(m6 * d1_of_place_8))
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_51,
                        u_2_inv * beta_rate_dot_by_beta_of_place_48,
                    )
                + d1_of_place_2 * d1_of_place_8
                    * (m6
                        * (-fa_zf_inv)
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_53,
                                beta_rate_dot_by_beta_of_place_54,
                            ) - cos_omega_inv * d1_of_place_8_i6_zf_inv))
            - m6_d1_of_place_4 * sin_gamma_minus_epsilon
                * (d1_of_place_4_u_2_inv
                    + zf_inv
                        * fa
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_55, -sin_gamma_minus_epsilon,
                            )))
        + d1_of_place_20
            * (m4_d1_of_place_13 * cos_gamma_minus_delta
                * (d1_of_place_13_zt_inv
                    + e_inv
                        * (-ea)
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_77, cos_gamma_minus_delta,
                            ))
                - sin_phi_minus_90deg_inv
                    * (cos_gamma_minus_delta
                        * d1_of_place_13_zt_inv
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_72,
                                e_inv * beta_rate_dot_by_beta_of_place_70,
                            ) + d1_of_place_13_zt_inv * beta_rate_dot_by_beta_of_place_76));
    let beta_rate_dot_by_beta_of_place_79 = cos_omega_inv * beta_rate_dot_by_beta_of_place_48;
    let beta_rate_dot_by_beta_of_place_80 = m6 * beta_rate_dot_by_beta_of_place_49;
    let beta_rate_dot_by_beta_of_place_81 = d1_of_place_4 * beta_rate_dot_by_beta_of_place_80;
    // beta_rate_dot_by_beta_of_place_79 + beta_rate_dot_by_beta_of_place_81
    let beta_rate_dot_by_beta_of_place_82 = beta_rate_dot_by_beta_of_place_79
        + beta_rate_dot_by_beta_of_place_81;
    let fa_ss_inv = fa * ss_inv;
    let beta_rate_dot_by_beta_of_place_83 = beta_rate_dot_by_beta_of_place_21 * fa_ss_inv;
    let beta_rate_dot_by_beta_of_place_84 = sin_omega_cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_85 = beta_rate_dot_by_beta_of_place_22 * sin_omega;
    let beta_rate_dot_by_beta_of_place_86 = S::int(2) * cos_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_85 + beta_rate_dot_by_beta_of_place_86
    let beta_rate_dot_by_beta_of_place_87 = beta_rate_dot_by_beta_of_place_85
        + beta_rate_dot_by_beta_of_place_86;
    // -beta_rate_dot_by_beta_of_place_54
    let beta_rate_dot_by_beta_of_place_88 = -beta_rate_dot_by_beta_of_place_54;
    let beta_rate_dot_by_beta_of_place_89 = beta_rate_dot_by_beta_of_place_84
        * beta_rate_dot_by_beta_of_place_88;
    // cos(gamma - epsilon) + beta_rate_dot_by_beta_of_place_85
    let beta_rate_dot_by_beta_of_place_90 = cos_gamma_minus_epsilon
        + beta_rate_dot_by_beta_of_place_85;
    let beta_rate_dot_by_beta_of_place_91 = cos_omega_inv * beta_rate_dot_by_beta_of_place_84;
    let beta_rate_dot_by_beta_of_place_92 = d1_of_place_8 * beta_rate_dot_by_beta_of_place_91;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let beta_rate_dot_by_beta_of_place_93 = beta_rate_dot_by_beta_of_place_30 * cos_phi_minus_90deg;
    // beta_rate_dot_by_beta_of_place_29 + beta_rate_dot_by_beta_of_place_93
    let beta_rate_dot_by_beta_of_place_94 = beta_rate_dot_by_beta_of_place_29
        + beta_rate_dot_by_beta_of_place_93;
    // sin(gamma - delta) - beta_rate_dot_by_beta_of_place_93
    let beta_rate_dot_by_beta_of_place_95 = sin_gamma_minus_delta
        - beta_rate_dot_by_beta_of_place_93;
    let beta_rate_dot_by_beta_of_place_96 = sin_phi_minus_90deg_inv
        * beta_rate_dot_by_beta_of_place_60;
    let beta_rate_dot_by_beta_of_place_97 = d1_of_place_13 * beta_rate_dot_by_beta_of_place_96;
    // sin(gamma - delta - phi_minus_90deg)*ss_inv -
    //   d1_of_place_13_zt_inv*beta_rate_dot_by_beta_of_place_97
    let beta_rate_dot_by_beta_of_place_98 = (-d1_of_place_13_zt_inv)
        .mul_add(
            beta_rate_dot_by_beta_of_place_97,
            beta_rate_dot_by_beta_of_place_30 * ss_inv,
        );
    // beta_rate_dot_by_beta_of_place_35 + beta_rate_dot_by_beta_of_place_74
    let beta_rate_dot_by_beta_of_place_99 = beta_rate_dot_by_beta_of_place_35
        + beta_rate_dot_by_beta_of_place_74;
    // sin(gamma - delta - phi_minus_90deg) + beta_rate_dot_by_beta_of_place_36
    let beta_rate_dot_by_beta_of_place_100 = beta_rate_dot_by_beta_of_place_30
        + beta_rate_dot_by_beta_of_place_36;
    let sin_angle_m2_da = m2_da * sin_angle;
    // d1_of_place_21 + ss_inv*(d1_of_place_22 + sin_angle_m2_da)
    let beta_rate_dot_by_beta_of_place_101 = d1_of_place_21
        + ss_inv * (d1_of_place_22 + sin_angle_m2_da);
    let cos_theta_doubled = S::int(2) * cos_theta;
    let beta_rate_dot_by_beta_of_beta_rate = d_inv * beta_rate_rr_beta_rate;
    // beta_rate_dot_by_beta = -(mom*d1_by_beta/d1 + rr*(m2*da*rr*beta_rate^2*cos(theta)*(cos(beta - gamma)
    //   - d1_by_beta*sin(beta - gamma)/d1)/d + (rr*beta_rate^2*(sin(theta)*(d1_by_beta*(cos(theta)*(((I3 +
    //   m3*(sa^2 + sb^2))/ss + m2*da*rr*sin(beta - gamma)/d)/ss + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) -
    //   m2*da*rr*cos(beta - gamma)^2/d^2)/d1 - m2*da*cos(beta - gamma)*(sin(beta + theta - gamma) +
    //   2*rr*sin(beta - gamma)/d)/d + (rr*(sin(theta)*(sin(theta)*(tan(beta + theta - gamma)*(3*((cos(gamma
    //   - epsilon - omega)*((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u -
    //   cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 +
    //   m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/u + m6*sin(gamma -
    //   epsilon)*(sin(gamma - epsilon - omega) + tan(omega)*(2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)))/zf) + sin(gamma - epsilon)^2*sin(omega)*(I6*sin(gamma -
    //   epsilon)/(zf^2*cos(omega)) - m6*(sin(gamma - epsilon - omega) - sin(gamma - epsilon)/cos(omega) -
    //   fa*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf))/zf)/cos(omega)
    //   + m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(cos(gamma - epsilon - omega)/u - (sin(gamma
    //   - epsilon) + fa*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf))/zf))/cos(omega)^2 +
    //   3*((cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)^2*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg))/zt +
    //   cos(gamma - delta)*(m4*cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/zt +
    //   (cos(gamma - delta - phi_minus_90deg)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma -
    //   delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))
    //   + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/zt + m4*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)
    //   - sin(gamma - delta - phi_minus_90deg))) + cos(gamma - delta)*cos(phi_minus_90deg)*(I4*cos(gamma -
    //   delta)/(e^2*sin(phi_minus_90deg)) + m4*(cos(gamma - delta)/sin(phi_minus_90deg) + sin(gamma - delta
    //   - phi_minus_90deg) - ea*(cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/e)))/e))/sin(phi_minus_90deg) - m4*cos(gamma - delta)*cos(gamma - delta -
    //   phi_minus_90deg)*(cos(gamma - delta - phi_minus_90deg)/zt + (cos(gamma - delta) - ea*(cos(gamma -
    //   delta)/e + cos(gamma - delta - phi_minus_90deg)/zt))/e))/sin(phi_minus_90deg)^2 + ((I6*sin(gamma -
    //   epsilon)*(3*cos(gamma - epsilon) + sin(gamma - epsilon)*(d1_by_beta/d1 - 4*tan(beta + theta -
    //   gamma)))/zf^2 + m6*(sin(gamma - epsilon)*(3*cos(gamma - epsilon) + sin(gamma -
    //   epsilon)*(d1_by_beta/d1 - 4*tan(beta + theta - gamma)) + sin(omega)*(3*sin(gamma - epsilon - omega)
    //   + 2*cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) + fa*(3*cos(gamma -
    //   epsilon)*(fa/zf - 2) + sin(gamma - epsilon)*(8*tan(beta + theta - gamma) - 2*d1_by_beta/d1 +
    //   fa*(d1_by_beta/d1 - 4*tan(beta + theta - gamma))/zf) - sin(omega)*(3*sin(gamma - epsilon - omega) +
    //   2*cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)))/zf) - cos(gamma -
    //   epsilon - omega)*(3*cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + 3*sin(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*(4*tan(beta + theta - gamma) - d1_by_beta/d1))) - cos(gamma - epsilon -
    //   omega)*(I7*(3*sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*(4*tan(beta + theta -
    //   gamma) - d1_by_beta/d1)) + m7*(3*sin(gamma - epsilon - omega)*(ua^2 + ub^2) + cos(gamma - epsilon -
    //   omega)*(ua^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1) + ub^2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1))))/u^2)/cos(omega)^2 - (I4*cos(gamma - delta)*(3*sin(gamma - delta) + cos(gamma -
    //   delta)*(4*tan(beta + theta - gamma) - d1_by_beta/d1))/e^2 + m4*(cos(gamma - delta)*(3*sin(gamma -
    //   delta) + cos(gamma - delta)*(4*tan(beta + theta - gamma) - d1_by_beta/d1) -
    //   cos(phi_minus_90deg)*(3*sin(gamma - delta - phi_minus_90deg) + 2*cos(gamma - delta -
    //   phi_minus_90deg)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) +
    //   ea*(cos(phi_minus_90deg)*(3*sin(gamma - delta - phi_minus_90deg) + 2*cos(gamma - delta -
    //   phi_minus_90deg)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) - 3*sin(gamma - delta)*(2 - ea/e) -
    //   cos(gamma - delta)*(8*tan(beta + theta - gamma) - 2*d1_by_beta/d1 + ea*(d1_by_beta/d1 - 4*tan(beta +
    //   theta - gamma))/e))/e) + cos(gamma - delta - phi_minus_90deg)*(3*sin(gamma - delta -
    //   phi_minus_90deg) + 3*sin(gamma - delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)*(4*tan(beta + theta - gamma) - d1_by_beta/d1))) + cos(gamma - delta -
    //   phi_minus_90deg)*(I5*(3*sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) + m5*(3*sin(gamma - delta -
    //   phi_minus_90deg)*(ta^2 + tb^2) + cos(gamma - delta - phi_minus_90deg)*(ta^2*(4*tan(beta + theta -
    //   gamma) - d1_by_beta/d1) + tb^2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1))))/zt^2)/sin(phi_minus_90deg)^2 - (I3*(4*tan(beta + theta - gamma) - d1_by_beta/d1) +
    //   m3*(sa^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1) + sb^2*(4*tan(beta + theta - gamma) -
    //   d1_by_beta/d1)))/ss^2)/ss) - ((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/ss -
    //   d1_by_beta*((cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1
    //   - fa/zf) - sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/(ss*u) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega))/u + m6*((fa*cos(gamma -
    //   epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + (sin(gamma -
    //   epsilon - omega) + tan(omega)*(2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)))/cos(omega)))/zf - (cos(gamma - epsilon)*sin(omega) + sin(gamma - epsilon - omega))/ss)) +
    //   sin(gamma - epsilon)*(I6*(cos(gamma - epsilon)/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((sin(gamma - epsilon)*tan(omega)*(sin(gamma -
    //   epsilon - omega) - sin(gamma - epsilon)/cos(omega)) + fa*((2*cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss - (fa*cos(gamma - epsilon)/ss + sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf -
    //   2)/cos(omega)))/zf))/zf - (cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss)))/cos(omega)^2 + (cos(gamma - delta)*(((cos(gamma - delta - phi_minus_90deg)*((sin(gamma
    //   - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt
    //   + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/zt + m4*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)
    //   - sin(gamma - delta - phi_minus_90deg))) + cos(gamma - delta)*cos(phi_minus_90deg)*(I4*cos(gamma -
    //   delta)/(e^2*sin(phi_minus_90deg)) + m4*(cos(gamma - delta)/sin(phi_minus_90deg) + sin(gamma - delta
    //   - phi_minus_90deg) - ea*(cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg) - I4*sin(gamma - delta)/(e*ss) - m4*(cos(gamma -
    //   delta)*cos(gamma - delta - phi_minus_90deg) + ea*((sin(gamma - delta)*(ea/e - 2) + sin(gamma - delta
    //   - phi_minus_90deg)*cos(phi_minus_90deg))/ss - cos(gamma - delta - phi_minus_90deg)*(cos(gamma -
    //   delta)/e + cos(gamma - delta - phi_minus_90deg)/zt))))/e - m4*(cos(gamma - delta -
    //   phi_minus_90deg)*(cos(gamma - delta - phi_minus_90deg) - (sin(gamma - delta) + (cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/sin(phi_minus_90deg))/zt + (sin(gamma - delta) - sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss)) + cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)/sin(phi_minus_90deg))/tan(phi_minus_90deg) + (m5*(cos(gamma -
    //   delta - phi_minus_90deg)^2*(ta^2 + tb^2)/(zt*sin(phi_minus_90deg)*tan(phi_minus_90deg)) - sin(gamma
    //   - delta - phi_minus_90deg)*(ta^2 + tb^2)/ss) + I5*(cos(gamma - delta -
    //   phi_minus_90deg)^2/(zt*sin(phi_minus_90deg)*tan(phi_minus_90deg)) - sin(gamma - delta -
    //   phi_minus_90deg)/ss))/zt)/zt - m4*(sin(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1))/ss))/sin(phi_minus_90deg)^2)/d1) + (cos(beta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + tan(beta + theta - gamma)*(cos(beta -
    //   gamma)*(4*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2
    //   + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) -
    //   d1_by_beta*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d1) -
    //   sin(beta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)))/d) -
    //   (cos(theta)*(sin(beta - gamma)*(((I3 + m3*(sa^2 + sb^2))/ss + 3*m2*da*sin(beta + theta - gamma))/ss
    //   + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + cos(beta - gamma)*(d1_by_beta*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d1 + sin(beta + theta -
    //   gamma)*(m2*da*d1_by_beta/(ss*d1) - 3*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta -
    //   gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/cos(beta + theta - gamma)))) + ((sin(beta -
    //   gamma)^2*(I2 + m2*da^2) + cos(beta - gamma)*(d1_by_beta*sin(beta - gamma)*(I2 + m2*da^2)/d1 +
    //   tan(beta + theta - gamma)*(cos(beta - gamma)*(I2*(4*tan(beta + theta - gamma) - d1_by_beta/d1) +
    //   m2*da^2*(4*tan(beta + theta - gamma) - d1_by_beta/d1)) - 5*sin(beta - gamma)*(I2 + m2*da^2))))/ss -
    //   2*m2*da*sin(beta + theta - gamma)*cos(beta - gamma)^2)/d)/d) - 2*cos(theta)*sin(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta
    //   + theta - gamma)) + (m2*da*cos(theta)*sin(beta + theta - gamma)*sin(beta - gamma) + (sin(beta -
    //   gamma)^2*(I2 + m2*da^2) + cos(beta - gamma)*((rr*(2*m2*da*cos(theta)*sin(beta + theta -
    //   gamma)*sin(beta - gamma) + cos(beta - gamma)*((cos(beta - gamma)*(I2 + m2*da^2) + tan(beta + theta -
    //   gamma)*(cos(beta - gamma)*(I2*(4*tan(beta + theta - gamma) - d1_by_beta/d1) + m2*da^2*(4*tan(beta +
    //   theta - gamma) - d1_by_beta/d1)) - 3*sin(beta - gamma)*(I2 + m2*da^2)))/d +
    //   m2*da*cos(theta)*sin(beta + theta - gamma)*(d1_by_beta/d1 - 3*tan(beta + theta - gamma)))) -
    //   2*sin(beta + theta - gamma)*sin(beta - gamma)*(I2 + m2*da^2))/cos(beta + theta - gamma) +
    //   I2*(d1_by_beta*sin(beta - gamma)/d1 - cos(beta - gamma)) - m2*da*(rr*cos(theta)*cos(beta - gamma) +
    //   da*(cos(beta - gamma) - d1_by_beta*sin(beta - gamma)/d1))))/d)/d) - c0*sin(theta)*sin(beta + theta -
    //   gamma)*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))))/cos(beta + theta - gamma) + sin(theta)*(m2*da*rr*beta_rate^2*sin(beta -
    //   gamma)/d + d1_by_beta*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + m2*da*rr*beta_rate^2*cos(beta - gamma)/d)/d1))/cos(beta + theta -
    //   gamma))/d1
    let beta_rate_dot_by_beta = -d1_inv
        * (rr_cos_angle_inv
            * (sin_theta
                * (d1_by_beta_d1_inv
                    * beta_rate_rr_beta_rate
                        .mul_add(
                            d1_of_d_beta_gamma_m2_da, beta_rate_dot_by_beta_of_place_9,
                        ) + beta_rate_rr_beta_rate * beta_rate_dot_by_beta_of_place_10)
                + cos_angle_inv
                    * (beta_rate_rr_beta_rate
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
                                            * (d1_of_place_21
                                                + ss_inv
                                                    * rr
                                                        .mul_add(beta_rate_dot_by_beta_of_place_10, d1_of_place_22))
                                            + rr * d1_of_d_beta_gamma * d1_of_d_beta_gamma_m2_da)
                                    + cos_angle_inv
                                        * (rr
                                            * (sin_theta
                                                * (sin_theta
                                                    * (sin_angle_cos_angle_inv
                                                        * (-ss_inv
                                                            * (cos_omega_inv_sq
                                                                * (m6
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (beta_rate_dot_by_beta_of_place_24
                                                                            + fa_zf_inv
                                                                                * (sin_gamma_minus_epsilon
                                                                                    * (-fa_zf_inv)
                                                                                        .mul_add(
                                                                                            beta_rate_dot_by_beta_of_place_12,
                                                                                            beta_rate_dot_by_beta_of_place_19,
                                                                                        ) + S::int(3) * beta_rate_dot_by_beta_of_place_20
                                                                                    - beta_rate_dot_by_beta_of_place_24)
                                                                            + beta_rate_dot_by_beta_of_place_25)
                                                                        + d1_of_place_4
                                                                            * beta_rate_dot_by_beta_of_place_28
                                                                                .mul_add(S::int(3), -beta_rate_dot_by_beta_of_place_26))
                                                                    - u_2_inv * d1_of_place_4_u_2_inv
                                                                        * (m7
                                                                            * ua_sq_plus_ub_sq
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_beta_of_place_23,
                                                                                    d1_of_place_4 * ua_sq_plus_ub_sq
                                                                                        * beta_rate_dot_by_beta_of_place_12,
                                                                                ) + I7 * beta_rate_dot_by_beta_of_place_26)
                                                                    + beta_rate_dot_by_beta_of_place_25
                                                                        * d1_of_place_8_i6_zf_inv)
                                                                + d1_of_place_20
                                                                    * (m4
                                                                        * (cos_gamma_minus_delta
                                                                            * (beta_rate_dot_by_beta_of_place_32
                                                                                - ea_e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * ea_e_inv
                                                                                            .mul_add(
                                                                                                beta_rate_dot_by_beta_of_place_12,
                                                                                                -beta_rate_dot_by_beta_of_place_19,
                                                                                            ) + S::int(3) * beta_rate_dot_by_beta_of_place_29
                                                                                        + beta_rate_dot_by_beta_of_place_32)
                                                                                - beta_rate_dot_by_beta_of_place_33)
                                                                            - d1_of_place_13
                                                                                * beta_rate_dot_by_beta_of_place_36
                                                                                    .mul_add(S::int(3), beta_rate_dot_by_beta_of_place_34))
                                                                        - zt_inv * d1_of_place_13_zt_inv
                                                                            * (m5
                                                                                * ta_sq_plus_tb_sq
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_31,
                                                                                        d1_of_place_13 * ta_sq_plus_tb_sq
                                                                                            * beta_rate_dot_by_beta_of_place_12,
                                                                                    ) + I5 * beta_rate_dot_by_beta_of_place_34)
                                                                        - beta_rate_dot_by_beta_of_place_33
                                                                            * d1_of_place_17_i4_e_inv)
                                                                - ss_inv_sq
                                                                    * (m3 * sa_sq_plus_sb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_beta_of_place_12,
                                                                            I3 * beta_rate_dot_by_beta_of_place_12,
                                                                        )) + S::int(3) * beta_rate_dot_by_beta_of_place_78)
                                                        + ss_inv * d1_of_place_23
                                                        - d1_by_beta_d1_inv
                                                            * (cos_omega_inv_sq
                                                                * (d1_of_place_4
                                                                    * (u_2_inv
                                                                        * ss_inv
                                                                            .mul_add(
                                                                                beta_rate_dot_by_beta_of_place_41,
                                                                                beta_rate_dot_by_beta_of_place_82,
                                                                            )
                                                                        + m6
                                                                            * (ss_inv
                                                                                * (beta_rate_dot_by_beta_of_place_22
                                                                                    + beta_rate_dot_by_beta_of_place_21)
                                                                                - zf_inv
                                                                                    * (sin_gamma_minus_epsilon
                                                                                        * cos_omega_inv
                                                                                            .mul_add(
                                                                                                beta_rate_dot_by_beta_of_place_51,
                                                                                                beta_rate_dot_by_beta_of_place_49,
                                                                                            ) + beta_rate_dot_by_beta_of_place_83)))
                                                                    - sin_gamma_minus_epsilon
                                                                        * (m6
                                                                            * (zf_inv
                                                                                * (fa
                                                                                    * (zf_inv
                                                                                        * beta_rate_dot_by_beta_of_place_53
                                                                                            .mul_add(
                                                                                                beta_rate_dot_by_beta_of_place_84,
                                                                                                fa_ss_inv * cos_gamma_minus_epsilon,
                                                                                            ) - ss_inv * beta_rate_dot_by_beta_of_place_87)
                                                                                    + beta_rate_dot_by_beta_of_place_89)
                                                                                + ss_inv * beta_rate_dot_by_beta_of_place_90)
                                                                            + zf_inv_i6_zf_inv
                                                                                * ss_inv
                                                                                    .mul_add(
                                                                                        cos_gamma_minus_epsilon,
                                                                                        beta_rate_dot_by_beta_of_place_92,
                                                                                    )))
                                                                + d1_of_place_20
                                                                    * (d1_of_place_13
                                                                        * (zt_inv
                                                                            * (zt_inv
                                                                                * (m5 * ta_sq_plus_tb_sq)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_98,
                                                                                        I5 * beta_rate_dot_by_beta_of_place_98,
                                                                                    )
                                                                                - beta_rate_dot_by_beta_of_place_60 * m4_d1_of_place_13
                                                                                    * beta_rate_dot_by_beta_of_place_99)
                                                                            + m4 * ss_inv * beta_rate_dot_by_beta_of_place_100)
                                                                        - cos_gamma_minus_delta
                                                                            * (e_inv
                                                                                * (sin_phi_minus_90deg_inv
                                                                                    * beta_rate_dot_by_beta_of_place_70
                                                                                    - ss_inv * i4_e_inv * sin_gamma_minus_delta
                                                                                    - m4
                                                                                        * (ea
                                                                                            * (-d1_of_place_13)
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_beta_of_place_77,
                                                                                                    ss_inv * beta_rate_dot_by_beta_of_place_94,
                                                                                                ) + d1_of_place_13 * cos_gamma_minus_delta))
                                                                                - m4
                                                                                    * (d1_of_place_13_zt_inv
                                                                                        * (-sin_phi_minus_90deg_inv)
                                                                                            .mul_add(beta_rate_dot_by_beta_of_place_71, d1_of_place_13)
                                                                                        + ss_inv * beta_rate_dot_by_beta_of_place_95)))))
                                                    - d_inv
                                                        * (sin_angle_cos_angle_inv
                                                            * (-d1_of_place_23)
                                                                .mul_add(
                                                                    sin_beta_minus_gamma,
                                                                    d1_of_place_23 * beta_rate_dot_by_beta_of_place_12
                                                                        * cos_beta_minus_gamma,
                                                                ) + d1_of_place_23 * cos_beta_minus_gamma))
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
                                                                * (d1_of_place_21
                                                                    + ss_inv
                                                                        * sin_angle_m2_da.mul_add(S::int(3), d1_of_place_22))
                                                                - cos_beta_minus_gamma
                                                                    * (sin_angle
                                                                        * (-(ss_inv * m2_da))
                                                                            .mul_add(
                                                                                d1_by_beta_d1_inv,
                                                                                S::int(3) * cos_angle_inv
                                                                                    * beta_rate_dot_by_beta_of_place_101,
                                                                            ) - d1_of_place_23 * d1_by_beta_d1_inv))))
                                            + d1_of_place_23 * cos_theta_doubled * sin_angle)))
                        - beta_rate_dot_by_beta_of_place_9 * sin_theta * sin_angle)
                + cos_theta_m2_da * beta_rate_dot_by_beta_of_place_15
                    * beta_rate_dot_by_beta_of_beta_rate) + mom * d1_by_beta_d1_inv);
    let d1_by_theta_of_place = sin_angle_cos_angle_inv * sin_theta;
    // cos(theta) + d1_by_theta_of_place
    let d1_by_theta_of_place_2 = cos_theta + d1_by_theta_of_place;
    let d1_by_theta_of_place_3 = cos_angle_inv * d1_of_d_beta_gamma;
    // d1_by_theta = 2*rr^2*(m2*da*sin(theta)*cos(beta - gamma)/d + (sin(beta + theta - gamma)*cos(beta -
    //   gamma)*(I2*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - m2*da*(cos(theta) - da*cos(beta -
    //   gamma)/(d*cos(beta + theta - gamma))))/d + sin(theta)*(cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + sin(theta)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)))/cos(beta + theta - gamma))/cos(beta + theta
    //   - gamma)
    let d1_by_theta = d1_by_beta_of_place_2
        * (cos_angle_inv
            * (d1_of_d_beta_gamma * sin_angle
                * (-m2_da * (-da).mul_add(d1_by_theta_of_place_3, cos_theta)
                    + I2 * d1_by_theta_of_place_3)
                + d1_of_place_23 * d1_by_theta_of_place_2 * sin_theta)
            + d1_of_d_beta_gamma_m2_da * sin_theta);
    let d1_of_place_22_ss_inv_sq = d1_of_place_22 * ss_inv_sq;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_by_theta_of_place = d1_of_place_4
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_by_beta_of_place_22);
    let u_2_inv_ss_inv = u_2_inv * ss_inv;
    let beta_rate_dot_by_theta_of_place_2 = S::int(2) * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_theta_of_place_3 = cos_omega_inv_sq * beta_rate_dot_by_beta_of_place_50;
    // fa_ss_inv*beta_rate_dot_by_theta_of_place_2 - beta_rate_dot_by_theta_of_place_3
    let beta_rate_dot_by_theta_of_place_4 = fa_ss_inv
        .mul_add(beta_rate_dot_by_theta_of_place_2, -beta_rate_dot_by_theta_of_place_3);
    let beta_rate_dot_by_theta_of_place_5 = beta_rate_dot_by_beta_of_place_22 * cos_omega_inv;
    // beta_rate_dot_by_beta_of_place_49 - beta_rate_dot_by_theta_of_place_4*sin(omega) +
    //   beta_rate_dot_by_theta_of_place_5
    let beta_rate_dot_by_theta_of_place_6 = (-beta_rate_dot_by_theta_of_place_4)
        .mul_add(sin_omega, beta_rate_dot_by_beta_of_place_49) + beta_rate_dot_by_theta_of_place_5;
    let beta_rate_dot_by_theta_of_place_7 = beta_rate_dot_by_theta_of_place_2
        * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - beta_rate_dot_by_theta_of_place_7
    let beta_rate_dot_by_theta_of_place_8 = cos_gamma_minus_epsilon
        - beta_rate_dot_by_theta_of_place_7;
    // u_2_inv*(beta_rate_dot_by_beta_of_place_82 + u_2_inv_ss_inv*(I7*beta_rate_dot_by_theta_of_place +
    //   m7*ua_sq_plus_ub_sq*beta_rate_dot_by_theta_of_place)) + m6*(ss_inv*(beta_rate_dot_by_theta_of_place
    //   + beta_rate_dot_by_theta_of_place_8*sin(omega)) - zf_inv*(beta_rate_dot_by_beta_of_place_83 +
    //   beta_rate_dot_by_theta_of_place_6*sin(gamma - epsilon)))
    let beta_rate_dot_by_theta_of_place_9 = u_2_inv
        * (beta_rate_dot_by_beta_of_place_82
            + u_2_inv_ss_inv
                * (m7 * ua_sq_plus_ub_sq)
                    .mul_add(
                        beta_rate_dot_by_theta_of_place,
                        I7 * beta_rate_dot_by_theta_of_place,
                    ))
        + m6
            * (ss_inv
                * beta_rate_dot_by_theta_of_place_8
                    .mul_add(sin_omega, beta_rate_dot_by_theta_of_place)
                - zf_inv
                    * beta_rate_dot_by_theta_of_place_6
                        .mul_add(
                            sin_gamma_minus_epsilon, beta_rate_dot_by_beta_of_place_83,
                        ));
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_by_theta_of_place_10 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_by_theta_of_place_11 = d1_of_place_8 * sin_omega_cos_omega_inv;
    // zf_inv_i6_zf_inv*(beta_rate_dot_by_beta_of_place_92 + ss_inv*beta_rate_dot_by_theta_of_place_10) +
    //   m6*(ss_inv*(beta_rate_dot_by_beta_of_place_85 + beta_rate_dot_by_theta_of_place_10) +
    //   zf_inv*(beta_rate_dot_by_beta_of_place_89 +
    //   fa*(beta_rate_dot_by_beta_of_place_53*beta_rate_dot_by_theta_of_place_11 -
    //   ss_inv*(beta_rate_dot_by_beta_of_place_87 - beta_rate_dot_by_theta_of_place_7 -
    //   fa_zf_inv*beta_rate_dot_by_theta_of_place_10))))
    let beta_rate_dot_by_theta_of_place_12 = zf_inv_i6_zf_inv
        * ss_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_10, beta_rate_dot_by_beta_of_place_92,
            )
        + m6
            * (ss_inv
                * (beta_rate_dot_by_beta_of_place_85 + beta_rate_dot_by_theta_of_place_10)
                + zf_inv
                    * (beta_rate_dot_by_beta_of_place_89
                        + fa
                            * (-ss_inv
                                * (-fa_zf_inv)
                                    .mul_add(
                                        beta_rate_dot_by_theta_of_place_10,
                                        beta_rate_dot_by_beta_of_place_87
                                            - beta_rate_dot_by_theta_of_place_7,
                                    )
                                + beta_rate_dot_by_beta_of_place_53
                                    * beta_rate_dot_by_theta_of_place_11)));
    // cos_omega_inv_sq*(cos(gamma - epsilon - omega)*beta_rate_dot_by_theta_of_place_9 -
    //   beta_rate_dot_by_theta_of_place_12*sin(gamma - epsilon))
    let beta_rate_dot_by_theta_of_place_13 = cos_omega_inv_sq
        * (-beta_rate_dot_by_theta_of_place_12)
            .mul_add(
                sin_gamma_minus_epsilon,
                d1_of_place_4 * beta_rate_dot_by_theta_of_place_9,
            );
    // e_inv*beta_rate_dot_by_beta_of_place_63 + beta_rate_dot_by_beta_of_place_72
    let beta_rate_dot_by_theta_of_place_14 = e_inv
        .mul_add(beta_rate_dot_by_beta_of_place_63, beta_rate_dot_by_beta_of_place_72);
    // beta_rate_dot_by_beta_of_place_76 + beta_rate_dot_by_theta_of_place_14*cos(gamma - delta)
    let beta_rate_dot_by_theta_of_place_15 = beta_rate_dot_by_theta_of_place_14
        .mul_add(cos_gamma_minus_delta, beta_rate_dot_by_beta_of_place_76);
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let beta_rate_dot_by_theta_of_place_16 = d1_of_place_13
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_by_beta_of_place_30);
    let zt_inv_ss_inv = zt_inv * ss_inv;
    let beta_rate_dot_by_theta_of_place_17 = beta_rate_dot_by_beta_of_place_64 * m4_d1_of_place_13;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_by_theta_of_place_18 = d1_of_place_20 * beta_rate_dot_by_beta_of_place_65;
    // beta_rate_dot_by_theta_of_place_2*ea_ss_inv - beta_rate_dot_by_theta_of_place_18
    let beta_rate_dot_by_theta_of_place_19 = beta_rate_dot_by_theta_of_place_2
        .mul_add(ea_ss_inv, -beta_rate_dot_by_theta_of_place_18);
    let beta_rate_dot_by_theta_of_place_20 = beta_rate_dot_by_beta_of_place_30
        * sin_phi_minus_90deg_inv;
    // beta_rate_dot_by_beta_of_place_64 - beta_rate_dot_by_theta_of_place_19*cos(phi_minus_90deg) -
    //   beta_rate_dot_by_theta_of_place_20
    let beta_rate_dot_by_theta_of_place_21 = (-beta_rate_dot_by_theta_of_place_19)
        .mul_add(cos_phi_minus_90deg, beta_rate_dot_by_beta_of_place_64)
        - beta_rate_dot_by_theta_of_place_20;
    let beta_rate_dot_by_theta_of_place_22 = ea_ss_inv * sin_gamma_minus_delta;
    let beta_rate_dot_by_theta_of_place_23 = beta_rate_dot_by_theta_of_place_2
        * cos_gamma_minus_delta;
    // sin(gamma - delta) + beta_rate_dot_by_theta_of_place_23
    let beta_rate_dot_by_theta_of_place_24 = sin_gamma_minus_delta
        + beta_rate_dot_by_theta_of_place_23;
    // zt_inv*(sin_phi_minus_90deg_inv*beta_rate_dot_by_theta_of_place_15 -
    //   zt_inv_ss_inv*(I5*beta_rate_dot_by_theta_of_place_16 +
    //   m5*ta_sq_plus_tb_sq*beta_rate_dot_by_theta_of_place_16) + beta_rate_dot_by_theta_of_place_17) +
    //   m4*(e_inv*(beta_rate_dot_by_theta_of_place_21*cos(gamma - delta) -
    //   beta_rate_dot_by_theta_of_place_22*cos(phi_minus_90deg)) +
    //   ss_inv*(beta_rate_dot_by_theta_of_place_24*cos(phi_minus_90deg) -
    //   beta_rate_dot_by_theta_of_place_16))
    let beta_rate_dot_by_theta_of_place_25 = zt_inv
        * (-zt_inv_ss_inv
            * (m5 * ta_sq_plus_tb_sq)
                .mul_add(
                    beta_rate_dot_by_theta_of_place_16,
                    I5 * beta_rate_dot_by_theta_of_place_16,
                ) + sin_phi_minus_90deg_inv * beta_rate_dot_by_theta_of_place_15
            + beta_rate_dot_by_theta_of_place_17)
        + m4
            * (e_inv
                * (-beta_rate_dot_by_theta_of_place_22)
                    .mul_add(
                        cos_phi_minus_90deg,
                        beta_rate_dot_by_theta_of_place_21 * cos_gamma_minus_delta,
                    )
                + ss_inv
                    * beta_rate_dot_by_theta_of_place_24
                        .mul_add(
                            cos_phi_minus_90deg, -beta_rate_dot_by_theta_of_place_16,
                        ));
    // sin_angle_cos_angle_inv*ea_ss_inv -
    //   beta_rate_dot_by_beta_of_place_60*beta_rate_dot_by_beta_of_place_68
    let beta_rate_dot_by_theta_of_place_26 = (-beta_rate_dot_by_beta_of_place_60)
        .mul_add(beta_rate_dot_by_beta_of_place_68, sin_angle_cos_angle_inv * ea_ss_inv);
    let beta_rate_dot_by_theta_of_gamma_delta = S::int(2) * sin_gamma_minus_delta;
    let beta_rate_dot_by_theta_of_place_27 = beta_rate_dot_by_beta_of_place_60
        * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_by_theta_of_place_28 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_by_theta_of_place_29 = d1_of_place_17 * beta_rate_dot_by_beta_of_place_96;
    let e_inv_i4_e_inv = e_inv * i4_e_inv;
    // m4*(e_inv*(ea*(e_inv*(beta_rate_dot_by_theta_of_place_22 +
    //   beta_rate_dot_by_theta_of_place_26*cos(gamma - delta)) + ss_inv*(beta_rate_dot_by_beta_of_place_93 -
    //   beta_rate_dot_by_theta_of_place_23 - beta_rate_dot_by_theta_of_gamma_delta)) -
    //   beta_rate_dot_by_beta_of_place_69*beta_rate_dot_by_theta_of_place_27) +
    //   ss_inv*(beta_rate_dot_by_theta_of_place_28 - beta_rate_dot_by_beta_of_place_93)) +
    //   e_inv_i4_e_inv*(ss_inv*beta_rate_dot_by_theta_of_place_28 -
    //   beta_rate_dot_by_theta_of_place_29*cos(gamma - delta))
    let beta_rate_dot_by_theta_of_place_30 = m4
        * (e_inv
            * (ea
                * (e_inv
                    * beta_rate_dot_by_theta_of_place_26
                        .mul_add(
                            cos_gamma_minus_delta, beta_rate_dot_by_theta_of_place_22,
                        )
                    + ss_inv
                        * (beta_rate_dot_by_beta_of_place_93 - beta_rate_dot_by_theta_of_place_23
                            - beta_rate_dot_by_theta_of_gamma_delta))
                - beta_rate_dot_by_beta_of_place_69 * beta_rate_dot_by_theta_of_place_27)
            + ss_inv
                * (beta_rate_dot_by_theta_of_place_28 - beta_rate_dot_by_beta_of_place_93))
        + e_inv_i4_e_inv
            * (-beta_rate_dot_by_theta_of_place_29)
                .mul_add(
                    cos_gamma_minus_delta,
                    ss_inv * beta_rate_dot_by_theta_of_place_28,
                );
    // d1_of_place_20*(cos(gamma - delta - phi_minus_90deg)*beta_rate_dot_by_theta_of_place_25 -
    //   beta_rate_dot_by_theta_of_place_30*cos(gamma - delta))
    let beta_rate_dot_by_theta_of_place_31 = d1_of_place_20
        * (-beta_rate_dot_by_theta_of_place_30)
            .mul_add(
                cos_gamma_minus_delta,
                d1_of_place_13 * beta_rate_dot_by_theta_of_place_25,
            );
    // sin_angle_cos_angle_inv*d1_of_place_22_ss_inv_sq + beta_rate_dot_by_theta_of_place_13 -
    //   beta_rate_dot_by_theta_of_place_31
    let beta_rate_dot_by_theta_of_place_32 = sin_angle_cos_angle_inv
        .mul_add(d1_of_place_22_ss_inv_sq, beta_rate_dot_by_theta_of_place_13)
        - beta_rate_dot_by_theta_of_place_31;
    let beta_rate_dot_by_theta_of_place_33 = d1_of_d_beta_gamma * sin_angle_cos_angle_inv;
    // beta_rate_dot_by_theta_of_place_32*sin(theta) - d1_of_place_23*beta_rate_dot_by_theta_of_place_33
    let beta_rate_dot_by_theta_of_place_34 = (-d1_of_place_23)
        .mul_add(
            beta_rate_dot_by_theta_of_place_33,
            beta_rate_dot_by_theta_of_place_32 * sin_theta,
        );
    // sin_angle_cos_angle_inv*cos(beta - gamma) - sin(beta - gamma)
    let beta_rate_dot_by_theta_of_place_35 = sin_angle_cos_angle_inv
        .mul_add(cos_beta_minus_gamma, -sin_beta_minus_gamma);
    // -beta_rate_dot_by_theta_of_place_35
    let beta_rate_dot_by_theta_of_place_36 = -beta_rate_dot_by_theta_of_place_35;
    let beta_rate_dot_by_theta_of_place_37 = i2_plus_da_m2_da * beta_rate_dot_by_theta_of_place_36;
    let ss_inv_d_inv = ss_inv * d_inv;
    // beta_rate_dot_by_beta_of_place_101*cos(theta) + beta_rate_dot_by_theta_of_place_37*ss_inv_d_inv
    let beta_rate_dot_by_theta_of_place_38 = beta_rate_dot_by_theta_of_place_37
        .mul_add(ss_inv_d_inv, beta_rate_dot_by_beta_of_place_101 * cos_theta);
    // beta_rate_dot_by_theta_of_place_34*sin(theta) -
    //   d1_of_d_beta_gamma*beta_rate_dot_by_theta_of_place_38
    let beta_rate_dot_by_theta_of_place_39 = (-d1_of_d_beta_gamma)
        .mul_add(
            beta_rate_dot_by_theta_of_place_38,
            beta_rate_dot_by_theta_of_place_34 * sin_theta,
        );
    let beta_rate_dot_by_theta_of_place_40 = cos_theta * sin_beta_minus_gamma;
    let d_inv_m2_da = d_inv * m2_da;
    // -d1_of_place_23*cos(theta) - rr*(cos_angle_inv*beta_rate_dot_by_theta_of_place_39 +
    //   d_inv_m2_da*(ss_inv*beta_rate_dot_by_theta_of_place_40 - d1_of_d_beta_gamma*cos(beta - gamma)))
    let beta_rate_dot_by_theta_of_place_41 = -rr
        * (d_inv_m2_da
            * (-d1_of_d_beta_gamma)
                .mul_add(
                    cos_beta_minus_gamma,
                    ss_inv * beta_rate_dot_by_theta_of_place_40,
                ) + cos_angle_inv * beta_rate_dot_by_theta_of_place_39)
        - d1_of_place_23 * cos_theta;
    // d1_of_d_beta_gamma_m2_da - cos_angle_inv*beta_rate_dot_by_theta_of_place_41
    let beta_rate_dot_by_theta_of_place_42 = (-cos_angle_inv)
        .mul_add(beta_rate_dot_by_theta_of_place_41, d1_of_d_beta_gamma_m2_da);
    // beta_rate_dot_by_beta_of_place_9 + beta_rate_rr_beta_rate*beta_rate_dot_by_theta_of_place_42
    let beta_rate_dot_by_theta_of_beta_rate = beta_rate_rr_beta_rate
        .mul_add(beta_rate_dot_by_theta_of_place_42, beta_rate_dot_by_beta_of_place_9);
    // 1 + sin_angle_cos_angle_inv^2
    let beta_rate_dot_by_theta_of_place_43 = sin_angle_cos_angle_inv
        .mul_add(sin_angle_cos_angle_inv, S::int(1));
    let beta_rate_dot_by_theta_of_place_44 = beta_rate_dot_by_theta_of_place_43
        * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_theta_of_place_45 = S::int(2) * beta_rate_dot_by_theta_of_place_43;
    let beta_rate_dot_by_theta_of_place_46 = ss_inv * beta_rate_dot_by_theta_of_place_44;
    let beta_rate_dot_by_theta_of_place_47 = d1_of_place_4 * beta_rate_dot_by_theta_of_place_43;
    let beta_rate_dot_by_theta_of_place_48 = beta_rate_dot_by_theta_of_place_43
        * cos_gamma_minus_delta;
    let beta_rate_dot_by_theta_of_place_49 = ss_inv * beta_rate_dot_by_theta_of_place_48;
    let beta_rate_dot_by_theta_of_place_50 = ea_ss_inv * beta_rate_dot_by_theta_of_place_43;
    let beta_rate_dot_by_theta_of_place_51 = d1_of_place_17 * beta_rate_dot_by_theta_of_place_50;
    let beta_rate_dot_by_theta_of_place_52 = d1_of_place_13 * beta_rate_dot_by_theta_of_place_43;
    let beta_rate_dot_by_theta_of_place_53 = d1_of_place_22_ss_inv_sq
        * beta_rate_dot_by_theta_of_place_43;
    let beta_rate_dot_by_theta_of_place_54 = d1_of_place_23 * d1_of_d_beta_gamma
        * beta_rate_dot_by_theta_of_place_43;
    let cos_angle_ss_inv = ss_inv * cos_angle;
    let beta_rate_dot_by_theta_of_place_55 = cos_angle_inv * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_theta_of_place_56 = beta_rate_dot_by_theta_of_place_39
        * beta_rate_dot_by_theta_of_place_55;
    let beta_rate_dot_by_theta_of_place_57 = beta_rate_dot_by_theta_of_place_41
        * beta_rate_dot_by_theta_of_place_55;
    let beta_rate_dot_by_theta_of_place_58 = rr_cos_angle_inv * cos_beta_minus_gamma;
    // beta_rate_dot_by_theta_of_place_58*(d1_of_d_beta_gamma +
    //   beta_rate_dot_by_theta_of_place_2*beta_rate_dot_by_theta_of_place_33)
    let beta_rate_dot_by_theta_of_place_59 = beta_rate_dot_by_theta_of_place_58
        * beta_rate_dot_by_theta_of_place_2
            .mul_add(beta_rate_dot_by_theta_of_place_33, d1_of_d_beta_gamma);
    let beta_rate_dot_by_theta_of_place_60 = beta_rate_dot_by_beta_of_place_17
        * beta_rate_dot_by_theta_of_place_43;
    // sin(beta - gamma) - beta_rate_dot_by_theta_of_place_33*beta_rate_dot_by_theta_of_place_58
    let beta_rate_dot_by_theta_of_place_61 = (-beta_rate_dot_by_theta_of_place_33)
        .mul_add(beta_rate_dot_by_theta_of_place_58, sin_beta_minus_gamma);
    // I2*beta_rate_dot_by_theta_of_place_61 +
    //   m2_da*(sin_angle_cos_angle_inv*beta_rate_dot_by_beta_of_place_17 +
    //   da*beta_rate_dot_by_theta_of_place_61)
    let beta_rate_dot_by_theta_of_place_62 = m2_da
        * da
            .mul_add(
                beta_rate_dot_by_theta_of_place_61,
                sin_angle_cos_angle_inv * beta_rate_dot_by_beta_of_place_17,
            ) + I2 * beta_rate_dot_by_theta_of_place_61;
    let beta_rate_dot_by_theta_of_place_63 = cos_angle_inv * beta_rate_dot_by_theta_of_place_62;
    // d1_by_theta_of_place_3*beta_rate_dot_by_theta_of_place_62 - cos_theta_m2_da*sin(beta - gamma)
    let beta_rate_dot_by_theta_of_place_64 = (-cos_theta_m2_da)
        .mul_add(
            sin_beta_minus_gamma,
            d1_by_theta_of_place_3 * beta_rate_dot_by_theta_of_place_62,
        );
    // rr_cos_angle_inv*(beta_rate_dot_by_theta_of_beta_rate*sin(theta) +
    //   beta_rate_dot_by_beta_of_beta_rate*beta_rate_dot_by_theta_of_place_64)
    let beta_rate_dot_by_theta_of_beta_rate_2 = rr_cos_angle_inv
        * beta_rate_dot_by_beta_of_beta_rate
            .mul_add(
                beta_rate_dot_by_theta_of_place_64,
                beta_rate_dot_by_theta_of_beta_rate * sin_theta,
            );
    let beta_rate_dot_by_theta_of_beta_rate_3 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_beta_rate_2;
    // d1_inv^2*(mom + beta_rate_dot_by_theta_of_beta_rate_2)
    let beta_rate_dot_by_theta_of_beta_rate_4 = d1_inv * d1_inv
        * (mom + beta_rate_dot_by_theta_of_beta_rate_2);
    // beta_rate_dot_by_theta = (rr*tan(beta + theta - gamma)*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma) + rr*(rr*beta_rate^2*(m2*da*sin(theta)*sin(beta - gamma) +
    //   cos(beta - gamma)*tan(beta + theta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) + cos(beta -
    //   gamma)*(m2*da*(rr*cos(theta)*cos(beta - gamma) + rr*sin(theta)*cos(beta - gamma)*tan(gamma - beta -
    //   theta) + rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma)^2 - da*(rr*cos(beta -
    //   gamma)^2/(d*cos(beta + theta - gamma)) + 2*rr*cos(beta - gamma)^2*tan(beta + theta -
    //   gamma)^2/(d*cos(beta + theta - gamma)))) - I2*(rr*cos(beta - gamma)^2/(d*cos(beta + theta - gamma))
    //   + 2*rr*cos(beta - gamma)^2*tan(beta + theta - gamma)^2/(d*cos(beta + theta - gamma))))/(d*cos(beta +
    //   theta - gamma)))/d + cos(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))) - rr*beta_rate^2*sin(theta)*(tan(beta + theta - gamma)*(rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)) - cos(theta)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) + (sin(theta)*((I3
    //   + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + rr*(m2*da*sin(theta)*sin(beta -
    //   gamma)/(d*ss) + tan(beta + theta - gamma)*(sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d +
    //   sin(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon -
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
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma) + (cos(theta)*(cos(beta
    //   - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d +
    //   sin(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon -
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
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) +
    //   sin(theta)*(cos(beta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d -
    //   sin(theta)*((I3 + m3*(sa^2 + sb^2))/ss^3 + tan(beta + theta - gamma)^2*(I3 + m3*(sa^2 + sb^2))/ss^3
    //   + (sin(gamma - epsilon)*(I6*(sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta -
    //   gamma)^2)/(ss*zf^2) - m6*(fa*(2*sin(gamma - epsilon) + 2*sin(gamma - epsilon)*tan(beta + theta -
    //   gamma)^2 - fa*(sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/zf)/(ss*zf)
    //   - (sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/ss)) + cos(gamma -
    //   epsilon - omega)*((I7*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma)^2) + m7*(ua^2*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma)^2) + ub^2*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)^2)))/(ss*u^2) + m6*(2*sin(gamma - epsilon)*sin(omega)*(fa/ss + fa*tan(beta + theta -
    //   gamma)^2/ss)/zf + (cos(gamma - epsilon - omega) - 2*sin(omega)*(sin(gamma - epsilon) + sin(gamma -
    //   epsilon)*tan(beta + theta - gamma)^2) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)^2)/ss)))/cos(omega)^2 + (cos(gamma - delta)*(I4*(cos(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma)^2)/(e^2*ss) + m4*((cos(gamma - delta) + cos(gamma - delta)*tan(beta
    //   + theta - gamma)^2)/ss + ea*(cos(gamma - delta)*(ea/ss + ea*tan(beta + theta - gamma)^2/ss)/e -
    //   2*(cos(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma)^2)/ss)/e)) + cos(gamma - delta
    //   - phi_minus_90deg)*((I5*(cos(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)^2) + m5*(ta^2*(cos(gamma - delta - phi_minus_90deg) +
    //   cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2) + tb^2*(cos(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2)))/(ss*zt^2) +
    //   m4*(2*cos(gamma - delta)*cos(phi_minus_90deg)*(ea/ss + ea*tan(beta + theta - gamma)^2/ss)/e +
    //   (cos(gamma - delta - phi_minus_90deg) - 2*cos(phi_minus_90deg)*(cos(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma)^2) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)^2)/ss)))/sin(phi_minus_90deg)^2) + cos(beta - gamma)*tan(beta + theta - gamma)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + cos(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*(m2*da*cos(theta)*cos(beta + theta - gamma)/ss - (I2*(cos(beta - gamma) + cos(beta -
    //   gamma)*tan(beta + theta - gamma)^2) + m2*da^2*(cos(beta - gamma) + cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2))/(d*ss) - sin(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta -
    //   gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma)))/cos(beta + theta - gamma))/d1 - d1_by_theta*(mom + rr*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_theta = d1_inv
        * (rr_cos_angle_inv
            * (-beta_rate_rr_beta_rate * sin_theta
                * (cos_angle_inv
                    * (sin_theta_d1_of_place_23
                        + rr
                            * (-cos_angle_inv
                                * (sin_theta
                                    * (-beta_rate_dot_by_theta_of_place_54
                                        + beta_rate_dot_by_theta_of_place_32 * cos_theta
                                        + sin_theta
                                            * (cos_omega_inv_sq
                                                * (sin_gamma_minus_epsilon
                                                    * (m6
                                                        * (fa_zf_inv * ss_inv
                                                            * (-beta_rate_dot_by_theta_of_place_45)
                                                                .mul_add(
                                                                    sin_gamma_minus_epsilon,
                                                                    fa_zf_inv * beta_rate_dot_by_theta_of_place_44,
                                                                ) + beta_rate_dot_by_theta_of_place_46)
                                                        + zf_inv_i6_zf_inv * beta_rate_dot_by_theta_of_place_46)
                                                    + d1_of_place_4
                                                        * (m6
                                                            * (ss_inv
                                                                * (-sin_omega_doubled)
                                                                    .mul_add(
                                                                        beta_rate_dot_by_theta_of_place_44,
                                                                        beta_rate_dot_by_theta_of_place_47,
                                                                    )
                                                                + d1_of_place_8 * sin_omega_doubled * fa_ss_inv
                                                                    * beta_rate_dot_by_theta_of_place_43)
                                                            + u_2_inv * u_2_inv_ss_inv
                                                                * (m7 * ua_sq_plus_ub_sq)
                                                                    .mul_add(
                                                                        beta_rate_dot_by_theta_of_place_47,
                                                                        I7 * beta_rate_dot_by_theta_of_place_47,
                                                                    )))
                                                + d1_of_place_20
                                                    * (cos_gamma_minus_delta
                                                        * (m4
                                                            * (beta_rate_dot_by_theta_of_place_49
                                                                + ea_e_inv
                                                                    * (-beta_rate_dot_by_theta_of_place_49)
                                                                        .mul_add(S::int(2), beta_rate_dot_by_theta_of_place_51))
                                                            + e_inv_i4_e_inv * beta_rate_dot_by_theta_of_place_49)
                                                        + d1_of_place_13
                                                            * (m4
                                                                * (ss_inv
                                                                    * (-beta_rate_dot_by_beta_of_place_56)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_theta_of_place_48,
                                                                            beta_rate_dot_by_theta_of_place_52,
                                                                        )
                                                                    + beta_rate_dot_by_beta_of_place_56
                                                                        * beta_rate_dot_by_theta_of_place_51)
                                                                + zt_inv * zt_inv_ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_theta_of_place_52,
                                                                            I5 * beta_rate_dot_by_theta_of_place_52,
                                                                        ))) + beta_rate_dot_by_theta_of_place_53))
                                    + beta_rate_dot_by_theta_of_place_34 * cos_theta
                                    + d1_of_d_beta_gamma
                                        * ((i2_plus_da_m2_da * ss_inv_d_inv
                                            * beta_rate_dot_by_theta_of_place_43)
                                            .mul_add(
                                                cos_beta_minus_gamma,
                                                beta_rate_dot_by_beta_of_place_101 * sin_theta,
                                            ) - cos_theta_m2_da * cos_angle_ss_inv))
                                + ss_inv * beta_rate_dot_by_beta_of_place_10 * sin_theta
                                - beta_rate_dot_by_theta_of_place_56))
                    + beta_rate_dot_by_theta_of_place_57)
                + beta_rate_dot_by_theta_of_beta_rate * cos_theta
                + beta_rate_dot_by_beta_of_beta_rate
                    * (-d1_by_theta_of_place_3
                        * (m2_da
                            * ((rr * d1_by_theta_of_place)
                                .mul_add(
                                    cos_beta_minus_gamma, -beta_rate_dot_by_theta_of_place_60,
                                ) + da * beta_rate_dot_by_theta_of_place_59)
                            + I2 * beta_rate_dot_by_theta_of_place_59)
                        + m2_da * sin_theta * sin_beta_minus_gamma
                        + beta_rate_dot_by_theta_of_place_33 * beta_rate_dot_by_theta_of_place_63))
            + beta_rate_dot_by_theta_of_beta_rate_3)
        - d1_by_theta * beta_rate_dot_by_theta_of_beta_rate_4;
    let d1_by_gamma_of_place = d1_of_place_23 * sin_angle_cos_angle_inv;
    let d1_by_gamma_of_place_2 = d1_of_place_4_u_2_inv * beta_rate_dot_by_beta_of_place_41;
    // d1_of_place_8_i6_zf_inv*cos(gamma - epsilon) - d1_by_gamma_of_place_2
    let d1_by_gamma_of_place_3 = d1_of_place_8_i6_zf_inv
        .mul_add(cos_gamma_minus_epsilon, -d1_by_gamma_of_place_2);
    // cos_omega_inv_sq*(m6*(cos(gamma - epsilon - omega)*(beta_rate_dot_by_beta_of_place_28 - sin(gamma -
    //   epsilon - omega)) + sin(gamma - epsilon)*(fa_zf_inv*(beta_rate_dot_by_beta_of_place_20 -
    //   beta_rate_dot_by_beta_of_place_85) + beta_rate_dot_by_beta_of_place_90)) + d1_by_gamma_of_place_3)
    let d1_by_gamma_of_place_4 = cos_omega_inv_sq
        * (m6
            * (d1_of_place_4
                * (beta_rate_dot_by_beta_of_place_28 - beta_rate_dot_by_beta_of_place_22)
                + sin_gamma_minus_epsilon
                    * (fa_zf_inv
                        * (beta_rate_dot_by_beta_of_place_20 - beta_rate_dot_by_beta_of_place_85)
                        + beta_rate_dot_by_beta_of_place_90)) + d1_by_gamma_of_place_3);
    let d1_by_gamma_of_place_5 = d1_of_place_13_zt_inv * beta_rate_dot_by_beta_of_place_61;
    // d1_of_place_17_i4_e_inv*sin(gamma - delta) + d1_by_gamma_of_place_5
    let d1_by_gamma_of_place_6 = d1_of_place_17_i4_e_inv
        .mul_add(sin_gamma_minus_delta, d1_by_gamma_of_place_5);
    // d1_of_place_20*(m4*(cos(gamma - delta)*(ea_e_inv*beta_rate_dot_by_beta_of_place_94 +
    //   beta_rate_dot_by_beta_of_place_95) + cos(gamma - delta -
    //   phi_minus_90deg)*beta_rate_dot_by_beta_of_place_100) + d1_by_gamma_of_place_6)
    let d1_by_gamma_of_place_7 = d1_of_place_20
        * (m4
            * (cos_gamma_minus_delta
                * ea_e_inv
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_94, beta_rate_dot_by_beta_of_place_95,
                    ) + d1_of_place_13 * beta_rate_dot_by_beta_of_place_100)
            + d1_by_gamma_of_place_6);
    // d1_by_gamma = -2*rr^2*(m2*da*cos(theta)*sin(beta - gamma)/d + (sin(theta)^2*((sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma - epsilon)*cos(gamma
    //   - epsilon)/zf^2 + m6*(cos(gamma - epsilon - omega)*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) +
    //   sin(gamma - epsilon - omega)) - sin(gamma - epsilon)*(cos(gamma - epsilon) + sin(omega)*sin(gamma -
    //   epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) + sin(omega)*sin(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2 + tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma
    //   - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + (I4*sin(gamma - delta)*cos(gamma - delta)/e^2 +
    //   sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg) +
    //   sin(gamma - delta)*cos(phi_minus_90deg)*(ea/e - 1)) + cos(gamma - delta)*(sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) +
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - cos(beta -
    //   gamma)*(m2*da*cos(theta)*sin(beta + theta - gamma) + (I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/d)/d)/cos(beta + theta - gamma))/cos(beta + theta - gamma)
    let d1_by_gamma = -d1_by_beta_of_place_2
        * (d1_by_beta_of_place
            + cos_angle_inv
                * (sin_theta * sin_theta
                    * (d1_by_gamma_of_place - d1_by_gamma_of_place_4 + d1_by_gamma_of_place_7)
                    - d1_of_d_beta_gamma
                        * d_inv
                            .mul_add(
                                beta_rate_dot_by_theta_of_place_37,
                                beta_rate_dot_by_beta_of_place_14,
                            )));
    let beta_rate_dot_by_gamma_of_place = sin_angle_cos_angle_inv * beta_rate_dot_by_theta_of_place;
    let beta_rate_dot_by_gamma_of_place_2 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_beta_of_place_38;
    let beta_rate_dot_by_gamma_of_place_3 = S::int(2) * beta_rate_dot_by_beta_of_place_85;
    // cos(gamma - epsilon) + beta_rate_dot_by_gamma_of_place_3
    let beta_rate_dot_by_gamma_of_place_4 = cos_gamma_minus_epsilon
        + beta_rate_dot_by_gamma_of_place_3;
    let beta_rate_dot_by_gamma_of_place_5 = beta_rate_dot_by_beta_of_place_44
        * beta_rate_dot_by_theta_of_place_5;
    // beta_rate_dot_by_beta_of_place_27*m6_d1_of_place_4 +
    //   cos_omega_inv*(beta_rate_dot_by_beta_of_place_43*cos(gamma - epsilon) -
    //   beta_rate_dot_by_beta_of_place_47*beta_rate_dot_by_beta_of_place_85 - sin(gamma -
    //   epsilon)*(zf_inv*(d1_of_place_9 + beta_rate_dot_by_beta_of_place_39 -
    //   sin_omega_cos_omega_inv*(beta_rate_dot_by_beta_of_place_42 + beta_rate_dot_by_gamma_of_place_2)) +
    //   m6*(sin(gamma - epsilon) - sin_omega_cos_omega_inv*beta_rate_dot_by_gamma_of_place_4)) -
    //   sin_omega_d1_of_place_4*(beta_rate_dot_by_beta_of_place_80 + beta_rate_dot_by_gamma_of_place_5))
    let beta_rate_dot_by_gamma_of_place_6 = cos_omega_inv
        * (beta_rate_dot_by_beta_of_place_43 * cos_gamma_minus_epsilon
            - beta_rate_dot_by_beta_of_place_47 * beta_rate_dot_by_beta_of_place_85
            - sin_gamma_minus_epsilon
                * (zf_inv
                    * (d1_of_place_9 + beta_rate_dot_by_beta_of_place_39
                        - sin_omega_cos_omega_inv
                            * (beta_rate_dot_by_beta_of_place_42
                                + beta_rate_dot_by_gamma_of_place_2))
                    + m6
                        * (-sin_omega_cos_omega_inv)
                            .mul_add(
                                beta_rate_dot_by_gamma_of_place_4, sin_gamma_minus_epsilon,
                            ))
            - sin_omega_d1_of_place_4
                * (beta_rate_dot_by_beta_of_place_80 + beta_rate_dot_by_gamma_of_place_5))
        + beta_rate_dot_by_beta_of_place_27 * m6_d1_of_place_4;
    let beta_rate_dot_by_gamma_of_place_7 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_beta_of_place_80;
    // beta_rate_dot_by_beta_of_place_27*sin_omega_doubled - sin(gamma - epsilon - omega)
    let beta_rate_dot_by_gamma_of_place_8 = beta_rate_dot_by_beta_of_place_27
        .mul_add(sin_omega_doubled, -beta_rate_dot_by_beta_of_place_22);
    // beta_rate_dot_by_beta_of_place_27 + beta_rate_dot_by_beta_of_place_45
    let beta_rate_dot_by_gamma_of_place_9 = beta_rate_dot_by_beta_of_place_27
        + beta_rate_dot_by_beta_of_place_45;
    // d1_of_place_2*fa_ss_inv - beta_rate_dot_by_theta_of_place_6*cos(gamma - epsilon)
    let beta_rate_dot_by_gamma_of_place_10 = (-beta_rate_dot_by_theta_of_place_6)
        .mul_add(cos_gamma_minus_epsilon, d1_of_place_2 * fa_ss_inv);
    let beta_rate_dot_by_gamma_of_place_11 = beta_rate_dot_by_theta_of_place_2
        * beta_rate_dot_by_theta_of_place_10;
    let beta_rate_dot_by_gamma_of_place_12 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_place_10;
    // -beta_rate_dot_by_gamma_of_place_12
    let beta_rate_dot_by_gamma_of_place_13 = -beta_rate_dot_by_gamma_of_place_12;
    let beta_rate_dot_by_gamma_of_place_14 = sin_omega_cos_omega_inv
        * beta_rate_dot_by_beta_of_place_53;
    // beta_rate_dot_by_theta_of_place_11*(cos(gamma - epsilon - omega) +
    //   cos_omega_inv*beta_rate_dot_by_beta_of_place_20) +
    //   zf_inv*beta_rate_dot_by_gamma_of_place_14*cos(gamma - epsilon)
    let beta_rate_dot_by_gamma_of_place_15 = beta_rate_dot_by_theta_of_place_11
        * cos_omega_inv.mul_add(beta_rate_dot_by_beta_of_place_20, d1_of_place_4)
        + zf_inv * beta_rate_dot_by_gamma_of_place_14 * cos_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_84*(cos_omega_inv*cos(gamma - epsilon) - cos(gamma - epsilon -
    //   omega)) + sin_omega_cos_omega_inv*beta_rate_dot_by_beta_of_place_88*cos(gamma - epsilon)
    let beta_rate_dot_by_gamma_of_place_16 = beta_rate_dot_by_beta_of_place_84
        * cos_omega_inv.mul_add(cos_gamma_minus_epsilon, -d1_of_place_4)
        + sin_omega_cos_omega_inv * beta_rate_dot_by_beta_of_place_88 * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_gamma_of_place_17 = cos_omega_inv
        * beta_rate_dot_by_beta_of_place_86 * beta_rate_dot_by_theta_of_place_11;
    let beta_rate_dot_by_gamma_of_place_18 = beta_rate_dot_by_beta_of_place_22
        * beta_rate_dot_by_theta_of_place_9;
    // beta_rate_dot_by_theta_of_place_12*cos(gamma - epsilon) + beta_rate_dot_by_gamma_of_place_18
    let beta_rate_dot_by_gamma_of_place_19 = beta_rate_dot_by_theta_of_place_12
        .mul_add(cos_gamma_minus_epsilon, beta_rate_dot_by_gamma_of_place_18);
    let beta_rate_dot_by_gamma_of_place_20 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_place_16;
    let beta_rate_dot_by_gamma_of_place_21 = beta_rate_dot_by_beta_of_place_30
        * beta_rate_dot_by_beta_of_place_57;
    let beta_rate_dot_by_gamma_of_place_22 = S::int(2) * beta_rate_dot_by_beta_of_place_93;
    // sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_22
    let beta_rate_dot_by_gamma_of_place_23 = sin_gamma_minus_delta
        - beta_rate_dot_by_gamma_of_place_22;
    let beta_rate_dot_by_gamma_of_place_24 = m4 * beta_rate_dot_by_beta_of_place_64;
    let beta_rate_dot_by_gamma_of_place_25 = beta_rate_dot_by_beta_of_place_73
        * beta_rate_dot_by_theta_of_place_20;
    // beta_rate_dot_by_beta_of_place_35*m4_d1_of_place_13 +
    //   sin_phi_minus_90deg_inv*(beta_rate_dot_by_beta_of_place_75*beta_rate_dot_by_beta_of_place_93 +
    //   beta_rate_dot_by_theta_of_place_14*sin(gamma - delta) + cos(gamma - delta)*(e_inv*(d1_of_place_18 -
    //   beta_rate_dot_by_beta_of_place_58 +
    //   beta_rate_dot_by_beta_of_place_60*(beta_rate_dot_by_beta_of_place_62 +
    //   beta_rate_dot_by_gamma_of_place_21)) +
    //   m4*(beta_rate_dot_by_beta_of_place_60*beta_rate_dot_by_gamma_of_place_23 - cos(gamma - delta))) +
    //   d1_of_place_14*(beta_rate_dot_by_gamma_of_place_25 - beta_rate_dot_by_gamma_of_place_24))
    let beta_rate_dot_by_gamma_of_place_26 = sin_phi_minus_90deg_inv
        * (beta_rate_dot_by_beta_of_place_75 * beta_rate_dot_by_beta_of_place_93
            + beta_rate_dot_by_theta_of_place_14 * sin_gamma_minus_delta
            + cos_gamma_minus_delta
                * (e_inv
                    * (d1_of_place_18 - beta_rate_dot_by_beta_of_place_58
                        + beta_rate_dot_by_beta_of_place_60
                            * (beta_rate_dot_by_beta_of_place_62
                                + beta_rate_dot_by_gamma_of_place_21))
                    + m4
                        * beta_rate_dot_by_beta_of_place_60
                            .mul_add(
                                beta_rate_dot_by_gamma_of_place_23, -cos_gamma_minus_delta,
                            ))
            + d1_of_place_14
                * (beta_rate_dot_by_gamma_of_place_25 - beta_rate_dot_by_gamma_of_place_24))
        + beta_rate_dot_by_beta_of_place_35 * m4_d1_of_place_13;
    let beta_rate_dot_by_gamma_of_place_27 = beta_rate_dot_by_beta_of_place_30
        * beta_rate_dot_by_gamma_of_place_24;
    // sin(gamma - delta - phi_minus_90deg) +
    //   beta_rate_dot_by_beta_of_place_35*beta_rate_dot_by_beta_of_place_56
    let beta_rate_dot_by_gamma_of_place_28 = beta_rate_dot_by_beta_of_place_35
        .mul_add(beta_rate_dot_by_beta_of_place_56, beta_rate_dot_by_beta_of_place_30);
    // d1_of_place_12*ea_ss_inv + beta_rate_dot_by_theta_of_place_21*sin(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_29 = beta_rate_dot_by_theta_of_place_21
        .mul_add(sin_gamma_minus_delta, d1_of_place_12 * ea_ss_inv);
    let beta_rate_dot_by_gamma_of_place_30 = beta_rate_dot_by_theta_of_place_2
        * beta_rate_dot_by_theta_of_place_28;
    // cos(gamma - delta - phi_minus_90deg) + sin_phi_minus_90deg_inv*beta_rate_dot_by_beta_of_place_29
    let beta_rate_dot_by_gamma_of_place_31 = sin_phi_minus_90deg_inv
        .mul_add(beta_rate_dot_by_beta_of_place_29, d1_of_place_13);
    // beta_rate_dot_by_theta_of_place_26*sin(gamma - delta) - ea_ss_inv*cos(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_32 = (-ea_ss_inv)
        .mul_add(
            cos_gamma_minus_delta,
            beta_rate_dot_by_theta_of_place_26 * sin_gamma_minus_delta,
        );
    let beta_rate_dot_by_gamma_of_place_33 = beta_rate_dot_by_beta_of_place_60
        * beta_rate_dot_by_beta_of_place_69;
    // beta_rate_dot_by_theta_of_place_27*(sin_phi_minus_90deg_inv*sin(gamma - delta) - cos(gamma - delta -
    //   phi_minus_90deg)) + beta_rate_dot_by_gamma_of_place_33*sin(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_34 = beta_rate_dot_by_theta_of_place_27
        * sin_phi_minus_90deg_inv.mul_add(sin_gamma_minus_delta, -d1_of_place_13)
        + beta_rate_dot_by_gamma_of_place_33 * sin_gamma_minus_delta;
    let beta_rate_dot_by_gamma_of_place_35 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_theta_of_place_28;
    let beta_rate_dot_by_gamma_of_place_36 = beta_rate_dot_by_theta_of_gamma_delta
        * beta_rate_dot_by_theta_of_place_29;
    let beta_rate_dot_by_gamma_of_place_37 = beta_rate_dot_by_beta_of_place_30
        * beta_rate_dot_by_theta_of_place_25;
    // beta_rate_dot_by_theta_of_place_30*sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_37
    let beta_rate_dot_by_gamma_of_place_38 = beta_rate_dot_by_theta_of_place_30
        .mul_add(sin_gamma_minus_delta, -beta_rate_dot_by_gamma_of_place_37);
    let beta_rate_dot_by_gamma_of_place_39 = beta_rate_dot_by_beta_of_place_22 * d1_of_place_4;
    // cos_omega_inv_sq*(2*d1_by_gamma_of_place_3 + m6*(d1_of_place_7*cos(gamma - epsilon) -
    //   2*beta_rate_dot_by_gamma_of_place_39 + sin(gamma -
    //   epsilon)*(fa_zf_inv*(beta_rate_dot_by_beta_of_place_20 - beta_rate_dot_by_gamma_of_place_3) +
    //   beta_rate_dot_by_gamma_of_place_4)))
    let beta_rate_dot_by_gamma_of_place_40 = cos_omega_inv_sq
        * (m6
            * (d1_of_place_7 * cos_gamma_minus_epsilon
                - S::int(2) * beta_rate_dot_by_gamma_of_place_39
                + sin_gamma_minus_epsilon
                    * (fa_zf_inv
                        * (beta_rate_dot_by_beta_of_place_20 - beta_rate_dot_by_gamma_of_place_3)
                        + beta_rate_dot_by_gamma_of_place_4)) + S::int(2) * d1_by_gamma_of_place_3);
    let beta_rate_dot_by_gamma_of_place_41 = beta_rate_dot_by_beta_of_place_30 * d1_of_place_13;
    // d1_of_place_20*(2*d1_by_gamma_of_place_6 + m4*(d1_of_place_16*sin(gamma - delta) + cos(gamma -
    //   delta)*(ea_e_inv*(beta_rate_dot_by_beta_of_place_29 + beta_rate_dot_by_gamma_of_place_22) +
    //   beta_rate_dot_by_gamma_of_place_23) + 2*beta_rate_dot_by_gamma_of_place_41))
    let beta_rate_dot_by_gamma_of_place_42 = d1_of_place_20
        * (m4
            * (cos_gamma_minus_delta
                * (ea_e_inv
                    * (beta_rate_dot_by_beta_of_place_29 + beta_rate_dot_by_gamma_of_place_22)
                    + beta_rate_dot_by_gamma_of_place_23) + d1_of_place_16 * sin_gamma_minus_delta
                + S::int(2) * beta_rate_dot_by_gamma_of_place_41)
            + S::int(2) * d1_by_gamma_of_place_6);
    // beta_rate_dot_by_gamma_of_place_40 - beta_rate_dot_by_gamma_of_place_42
    let beta_rate_dot_by_gamma_of_place_43 = beta_rate_dot_by_gamma_of_place_40
        - beta_rate_dot_by_gamma_of_place_42;
    let beta_rate_dot_by_gamma_of_place_44 = d1_of_d_beta_gamma * beta_rate_dot_by_theta_of_place_2;
    // cos(beta - gamma) - beta_rate_dot_by_theta_of_place_59 +
    //   rr_cos_angle_inv*beta_rate_dot_by_gamma_of_place_44*sin(beta - gamma)
    let beta_rate_dot_by_gamma_of_place_45 = (rr_cos_angle_inv * beta_rate_dot_by_gamma_of_place_44)
        .mul_add(
            sin_beta_minus_gamma,
            cos_beta_minus_gamma - beta_rate_dot_by_theta_of_place_59,
        );
    // beta_rate_dot_by_gamma = -(rr*tan(beta + theta - gamma)*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma) + rr*(rr*beta_rate^2*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*cos(beta - gamma) - sin(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) + cos(beta - gamma)*(I2*(cos(beta - gamma) - rr*cos(beta -
    //   gamma)^2/(d*cos(beta + theta - gamma)) - 2*rr*cos(beta - gamma)^2*tan(beta + theta -
    //   gamma)^2/(d*cos(beta + theta - gamma)) + 2*rr*sin(beta - gamma)*cos(beta - gamma)*tan(beta + theta -
    //   gamma)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*sin(beta - gamma)*tan(gamma - beta -
    //   theta) + rr*cos(theta)*cos(beta - gamma) + rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2 + da*(cos(beta - gamma) - rr*cos(beta - gamma)^2/(d*cos(beta + theta - gamma)) -
    //   2*rr*cos(beta - gamma)^2*tan(beta + theta - gamma)^2/(d*cos(beta + theta - gamma)) + 2*rr*sin(beta -
    //   gamma)*cos(beta - gamma)*tan(beta + theta - gamma)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))^2) + c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb)))^2/(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc))) + l0*(sd*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) + sc*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) - sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) + sc*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*((cos(theta)*((2*I4*sin(gamma - delta)*cos(gamma -
    //   delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) + sin(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta
    //   - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e) + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2 - (2*I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf) - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2) +
    //   rr*(m2*da*(cos(theta)*cos(beta - gamma)/ss + 2*sin(beta - gamma)*cos(beta - gamma)/d)/d + tan(gamma
    //   - beta - theta)*(sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 +
    //   sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma) + (sin(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d +
    //   sin(theta)*(sin(theta)*((I3 + m3*(sa^2 + sb^2))/ss^3 + tan(beta + theta - gamma)^2*(I3 + m3*(sa^2 +
    //   sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*sin(gamma - epsilon -
    //   omega)*(fa/zf - 1) + m6*cos(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (cos(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) +
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
    //   epsilon)*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega)^2 + (sin(gamma -
    //   delta)*(m4*((ea*((ea*sin(gamma - delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss +
    //   (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)))/e + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta
    //   - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) + I4*((sin(gamma -
    //   delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2) - sin(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*sin(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   m4*sin(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) + (sin(gamma -
    //   delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta -
    //   phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg)) -
    //   cos(gamma - delta)*((cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt - (sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(cos(gamma - delta) + (2*sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg) - sin(gamma - delta))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg)*(m4
    //   + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg) - m4*cos(gamma - delta)*(ea/e -
    //   1)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma) +
    //   cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)^2) + tb^2*(sin(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma) + cos(gamma - delta
    //   - phi_minus_90deg)*tan(beta + theta - gamma)^2)))/(ss*zt))/zt + m4*((ea*cos(gamma -
    //   delta)*cos(phi_minus_90deg)/ss + sin(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma -
    //   delta - phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) + cos(gamma -
    //   delta)*(sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)/sin(phi_minus_90deg) +
    //   cos(phi_minus_90deg)*((sin(gamma - delta - phi_minus_90deg) + 2*sin(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1))/sin(phi_minus_90deg)^2 - 2*ea/ss - 2*ea*tan(beta + theta -
    //   gamma)^2/ss)))/e + (cos(phi_minus_90deg)*(2*sin(gamma - delta)*tan(beta + theta - gamma) + cos(gamma
    //   - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)^2) - sin(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma) - cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)^2)/ss)) - cos(gamma - delta)*(m4*((sin(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((ea*cos(gamma - delta)/ss - sin(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma -
    //   delta)*(2 - ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))
    //   + cos(gamma - delta)*((sin(gamma - delta)*(ea/e - 2)/sin(phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg) - ea/ss - ea*tan(beta + theta - gamma)^2/ss))/e +
    //   (2*sin(gamma - delta)*tan(beta + theta - gamma) + 2*cos(gamma - delta)*tan(beta + theta - gamma)^2 +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss) + cos(gamma - delta)*(sin(gamma -
    //   delta)/sin(phi_minus_90deg) - cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e -
    //   (sin(gamma - delta)*tan(beta + theta - gamma) + cos(gamma - delta)*tan(beta + theta - gamma)^2 +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss) + I4*(2*sin(gamma - delta)*cos(gamma
    //   - delta)/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)) - (sin(gamma - delta)*tan(beta + theta -
    //   gamma) + cos(gamma - delta)*tan(beta + theta - gamma)^2)/ss)/e^2))/sin(phi_minus_90deg)^2) -
    //   sin(beta - gamma)*tan(gamma - beta - theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d - cos(beta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d - cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d -
    //   cos(beta - gamma)*tan(gamma - beta - theta)*((2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 -
    //   2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma
    //   - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 - (2*I4*sin(gamma - delta)*cos(gamma -
    //   delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) + sin(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta
    //   - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e) + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma)*tan(gamma - beta - theta) + cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2) + m2*da^2*(sin(beta - gamma)*tan(gamma - beta - theta) + cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2))/(d*ss) - cos(theta)*(m2*da*cos(beta + theta - gamma)/ss + (2*sin(gamma - epsilon
    //   - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 - m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon
    //   - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) -
    //   fa*(cos(gamma - epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma
    //   - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + sin(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e) + cos(gamma - delta)*(sin(gamma -
    //   delta) - 2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e
    //   - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta -
    //   gamma)))/cos(beta + theta - gamma) - m2*da*sin(beta - gamma)/d - tan(beta + theta -
    //   gamma)*(rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d +
    //   (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)) - cos(theta)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma))))/cos(beta +
    //   theta - gamma))/d1 - d1_by_gamma*(mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma)
    //   + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc)
    //   + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_gamma = d1_inv
        * (rr_cos_angle_inv
            * (sin_theta
                * (beta_rate_rr_beta_rate
                    * (beta_rate_dot_by_beta_of_place_10 + beta_rate_dot_by_theta_of_place_57
                        + cos_angle_inv
                            * (-rr
                                * (d_inv_m2_da
                                    * ss_inv
                                        .mul_add(
                                            beta_rate_dot_by_beta_of_place_16,
                                            d1_of_d_beta_gamma * beta_rate_dot_by_beta_of_beta_gamma,
                                        ) + beta_rate_dot_by_theta_of_place_56
                                    + cos_angle_inv
                                        * (-sin_theta
                                            * (beta_rate_dot_by_theta_of_place_54
                                                - d1_by_beta_of_d_beta_gamma * d1_by_gamma_of_place
                                                - sin_theta
                                                    * (beta_rate_dot_by_theta_of_place_53
                                                        + cos_omega_inv_sq
                                                            * (sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (ss_inv
                                                                        * (sin_omega_d1_of_place_4
                                                                            - beta_rate_dot_by_gamma_of_place_12)
                                                                        + zf_inv
                                                                            * (fa
                                                                                * (ss_inv
                                                                                    * fa_zf_inv
                                                                                        .mul_add(
                                                                                            beta_rate_dot_by_gamma_of_place_13,
                                                                                            beta_rate_dot_by_gamma_of_place_11 - sin_omega_d1_of_place_4,
                                                                                        ) + beta_rate_dot_by_gamma_of_place_15)
                                                                                + beta_rate_dot_by_gamma_of_place_16))
                                                                    + zf_inv_i6_zf_inv
                                                                        * ss_inv
                                                                            .mul_add(
                                                                                beta_rate_dot_by_gamma_of_place_13,
                                                                                beta_rate_dot_by_gamma_of_place_17,
                                                                            ))
                                                                - d1_of_place_4
                                                                    * (u_2_inv
                                                                        * (beta_rate_dot_by_gamma_of_place_6
                                                                            - u_2_inv_ss_inv
                                                                                * (m7 * ua_sq_plus_ub_sq)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_gamma_of_place,
                                                                                        I7 * beta_rate_dot_by_gamma_of_place,
                                                                                    ) - beta_rate_dot_by_gamma_of_place_7)
                                                                        + m6
                                                                            * (zf_inv
                                                                                * (beta_rate_dot_by_gamma_of_place_10
                                                                                    - sin_gamma_minus_epsilon
                                                                                        * (sin_omega
                                                                                            * cos_omega_inv_sq
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_gamma_of_place_8,
                                                                                                    fa_ss_inv * beta_rate_dot_by_theta_of_place_45,
                                                                                                ) + beta_rate_dot_by_gamma_of_place_9))
                                                                                - ss_inv
                                                                                    * (beta_rate_dot_by_gamma_of_place
                                                                                        + sin_omega
                                                                                            * (beta_rate_dot_by_gamma_of_place_11
                                                                                                - sin_gamma_minus_epsilon))))
                                                                + beta_rate_dot_by_gamma_of_place_19)
                                                        + d1_of_place_20
                                                            * (beta_rate_dot_by_gamma_of_place_38
                                                                - d1_of_place_13
                                                                    * (zt_inv
                                                                        * (beta_rate_dot_by_gamma_of_place_26
                                                                            - zt_inv_ss_inv
                                                                                * (m5 * ta_sq_plus_tb_sq)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_gamma_of_place_20,
                                                                                        I5 * beta_rate_dot_by_gamma_of_place_20,
                                                                                    ) + beta_rate_dot_by_gamma_of_place_27)
                                                                        + m4
                                                                            * (e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (beta_rate_dot_by_beta_of_place_99
                                                                                        + cos_phi_minus_90deg
                                                                                            * (-ea_ss_inv)
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_theta_of_place_45,
                                                                                                    d1_of_place_20 * beta_rate_dot_by_gamma_of_place_28,
                                                                                                )) + beta_rate_dot_by_gamma_of_place_29)
                                                                                + ss_inv
                                                                                    * (cos_phi_minus_90deg
                                                                                        * (cos_gamma_minus_delta
                                                                                            + beta_rate_dot_by_gamma_of_place_30)
                                                                                        - beta_rate_dot_by_gamma_of_place_20)))
                                                                - cos_gamma_minus_delta
                                                                    * (m4
                                                                        * (e_inv
                                                                            * (ea
                                                                                * (ss_inv
                                                                                    * (d1_of_place_14 + beta_rate_dot_by_gamma_of_place_30)
                                                                                    - e_inv
                                                                                        * (cos_gamma_minus_delta
                                                                                            * (-beta_rate_dot_by_beta_of_place_60)
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_gamma_of_place_31,
                                                                                                    beta_rate_dot_by_theta_of_place_50,
                                                                                                ) + beta_rate_dot_by_gamma_of_place_32))
                                                                                + beta_rate_dot_by_gamma_of_place_34)
                                                                            - ss_inv
                                                                                * (d1_of_place_14 + beta_rate_dot_by_gamma_of_place_35))
                                                                        + e_inv_i4_e_inv
                                                                            * (-ss_inv)
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_gamma_of_place_35,
                                                                                    beta_rate_dot_by_gamma_of_place_36,
                                                                                ))))
                                                - beta_rate_dot_by_theta_of_place_33
                                                    * beta_rate_dot_by_gamma_of_place_43)
                                            + d1_by_beta_of_d_beta_gamma
                                                * beta_rate_dot_by_theta_of_place_38
                                            + d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (-m2_da)
                                                        .mul_add(
                                                            cos_angle_ss_inv,
                                                            beta_rate_dot_by_gamma_of_place_43,
                                                        )
                                                    + i2_plus_da_m2_da * sin_angle_cos_angle_inv
                                                        * beta_rate_dot_by_theta_of_place_35 * ss_inv_d_inv)))
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
                + beta_rate_dot_by_beta_of_beta_rate
                    * (beta_rate_dot_by_theta_of_place_63
                        * (d1_by_beta_of_d_beta_gamma - beta_rate_dot_by_theta_of_place_33)
                        + cos_theta_m2_da * cos_beta_minus_gamma
                        - d1_by_theta_of_place_3
                            * (m2_da
                                * ((-(rr * sin_angle_cos_angle_inv))
                                    .mul_add(
                                        beta_rate_dot_by_theta_of_place_40,
                                        beta_rate_dot_by_theta_of_place_60,
                                    ) + da * beta_rate_dot_by_gamma_of_place_45)
                                + I2 * beta_rate_dot_by_gamma_of_place_45)))
            - beta_rate_dot_by_theta_of_beta_rate_3)
        - d1_by_gamma * beta_rate_dot_by_theta_of_beta_rate_4;
    let d1_by_delta_of_place = rr_cos_angle_inv * sin_theta;
    let d1_by_delta_of_place_2 = S::int(2) * d1_by_delta_of_place * d1_by_delta_of_place;
    // d1_by_delta = 2*rr^2*sin(theta)^2*(I4*sin(gamma - delta)*cos(gamma - delta)/e^2 + sin(gamma - delta
    //   - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1)) + cos(gamma - delta)*(sin(gamma - delta) - sin(gamma - delta
    //   - phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/(cos(beta + theta - gamma)^2*sin(phi_minus_90deg)^2)
    let d1_by_delta = d1_by_gamma_of_place_7 * d1_by_delta_of_place_2;
    // sin(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv - cos(gamma - delta - phi_minus_90deg)
    let beta_rate_dot_by_delta_of_place = beta_rate_dot_by_beta_of_place_30
        .mul_add(sin_angle_cos_angle_inv, -d1_of_place_13);
    // -beta_rate_dot_by_delta_of_place
    let beta_rate_dot_by_delta_of_place_2 = -beta_rate_dot_by_delta_of_place;
    // beta_rate_dot_by_gamma_of_place_27 + zt_inv_ss_inv*(I5*beta_rate_dot_by_delta_of_place_2 +
    //   m5*ta_sq_plus_tb_sq*beta_rate_dot_by_delta_of_place_2)
    let beta_rate_dot_by_delta_of_place_3 = beta_rate_dot_by_gamma_of_place_27
        + zt_inv_ss_inv
            * (m5 * ta_sq_plus_tb_sq)
                .mul_add(
                    beta_rate_dot_by_delta_of_place_2,
                    I5 * beta_rate_dot_by_delta_of_place_2,
                );
    let beta_rate_dot_by_delta_of_place_4 = beta_rate_dot_by_theta_of_place_2
        * sin_gamma_minus_delta;
    // sin_angle_cos_angle_inv*sin(gamma - delta) - cos(gamma - delta)
    let beta_rate_dot_by_delta_of_place_5 = sin_angle_cos_angle_inv
        .mul_add(sin_gamma_minus_delta, -cos_gamma_minus_delta);
    let beta_rate_dot_by_delta_of_place_6 = d1_of_d_beta_gamma * cos_theta;
    let beta_rate_dot_by_delta_of_beta_rate = beta_rate * rr_cos_angle_inv;
    let beta_rate_dot_by_delta_of_beta_rate_2 = beta_rate * d1_by_delta_of_place;
    let beta_rate_dot_by_delta_of_beta_rate_3 = d1_inv
        * beta_rate_dot_by_delta_of_beta_rate * beta_rate_dot_by_delta_of_beta_rate_2;
    // beta_rate_dot_by_delta = rr^2*beta_rate^2*sin(theta)*(cos(theta)*(2*I4*sin(gamma - delta)*cos(gamma
    //   - delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) + sin(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta
    //   - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e) + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2 - rr*(cos(theta)*cos(beta -
    //   gamma)*(2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma
    //   - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + sin(gamma - delta)*(cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e
    //   - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e) + cos(gamma -
    //   delta)*(sin(gamma - delta) - 2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) +
    //   ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/(d*sin(phi_minus_90deg)^2) + sin(theta)*(cos(beta -
    //   gamma)*tan(beta + theta - gamma)*(2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 + 2*sin(gamma -
    //   delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)
    //   + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/(d*sin(phi_minus_90deg)^2) + sin(theta)*(sin(gamma -
    //   delta - phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - sin(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2) + cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*sin(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   m4*sin(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) + (sin(gamma -
    //   delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta -
    //   phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg)) -
    //   cos(gamma - delta)*((cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt - (sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(cos(gamma - delta) + (2*sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg) - sin(gamma - delta))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg)*(m4
    //   + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg) - m4*cos(gamma - delta)*(ea/e -
    //   1)))/sin(phi_minus_90deg) + (I5*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi_minus_90deg)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg)*tan(gamma -
    //   beta - theta) + cos(gamma - delta - phi_minus_90deg)) + tb^2*(sin(gamma - delta -
    //   phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma - delta - phi_minus_90deg))))/(ss*zt))/zt +
    //   m4*((ea*cos(gamma - delta)*cos(phi_minus_90deg)/ss + sin(gamma - delta)*(cos(gamma - delta)*(ea/e -
    //   1) - sin(gamma - delta - phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma
    //   - delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) + cos(gamma -
    //   delta)*(sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)/sin(phi_minus_90deg) +
    //   (sin(gamma - delta - phi_minus_90deg) + 2*sin(gamma - delta)*cos(phi_minus_90deg)*(ea/e -
    //   1))/(sin(phi_minus_90deg)*tan(phi_minus_90deg))))/e + (sin(gamma - delta -
    //   phi_minus_90deg)*tan(gamma - beta - theta) - cos(phi_minus_90deg)*(2*sin(gamma - delta)*tan(gamma -
    //   beta - theta) + cos(gamma - delta)) + cos(gamma - delta - phi_minus_90deg))/ss)) + cos(gamma -
    //   delta)*(m4*((sin(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg) + cos(gamma - delta)*(sin(gamma - delta)/sin(phi_minus_90deg)
    //   - cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) + ea*((ea*cos(gamma - delta)/ss -
    //   sin(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)) + cos(gamma
    //   - delta)*(sin(gamma - delta)*(ea/e - 2)/sin(phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/e + (cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - 2*sin(gamma - delta)*tan(gamma - beta - theta) - 2*cos(gamma - delta))/ss))/e +
    //   (sin(gamma - delta)*tan(gamma - beta - theta) + cos(gamma - delta) - cos(phi_minus_90deg)*cos(gamma
    //   - delta - phi_minus_90deg))/ss) + I4*((sin(gamma - delta)*tan(gamma - beta - theta) + cos(gamma -
    //   delta))/ss + 2*sin(gamma - delta)*cos(gamma -
    //   delta)/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2))/cos(beta +
    //   theta - gamma))/(d1*cos(beta + theta - gamma)^2) - d1_by_delta*(mom + rr*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_delta = beta_rate_dot_by_delta_of_beta_rate_3
        * (rr_cos_angle_inv
            * (sin_theta
                * (d1_of_place_20 * sin_theta
                    * (beta_rate_dot_by_gamma_of_place_38
                        - d1_of_place_13
                            * (zt_inv
                                * (beta_rate_dot_by_gamma_of_place_26
                                    + beta_rate_dot_by_delta_of_place_3)
                                + m4
                                    * (e_inv
                                        * (cos_gamma_minus_delta
                                            * beta_rate_dot_by_beta_of_place_96
                                                .mul_add(
                                                    beta_rate_dot_by_gamma_of_place_28,
                                                    beta_rate_dot_by_beta_of_place_99,
                                                ) + beta_rate_dot_by_gamma_of_place_29)
                                        - ss_inv
                                            * (beta_rate_dot_by_delta_of_place
                                                + cos_phi_minus_90deg
                                                    * (cos_gamma_minus_delta
                                                        - beta_rate_dot_by_delta_of_place_4))))
                        - cos_gamma_minus_delta
                            * (m4
                                * (e_inv
                                    * (beta_rate_dot_by_gamma_of_place_34
                                        - ea
                                            * (e_inv
                                                * (-beta_rate_dot_by_theta_of_place_27)
                                                    .mul_add(
                                                        beta_rate_dot_by_gamma_of_place_31,
                                                        beta_rate_dot_by_gamma_of_place_32,
                                                    )
                                                + ss_inv
                                                    * (cos_gamma_minus_delta.mul_add(S::int(2), -d1_of_place_14)
                                                        - beta_rate_dot_by_delta_of_place_4)))
                                    - ss_inv * (d1_of_place_14 + beta_rate_dot_by_delta_of_place_5))
                                + e_inv_i4_e_inv
                                    * (-ss_inv)
                                        .mul_add(
                                            beta_rate_dot_by_delta_of_place_5,
                                            beta_rate_dot_by_gamma_of_place_36,
                                        )))
                    - beta_rate_dot_by_theta_of_place_33 * beta_rate_dot_by_gamma_of_place_42)
                - beta_rate_dot_by_gamma_of_place_42 * beta_rate_dot_by_delta_of_place_6)
            + beta_rate_dot_by_gamma_of_place_42 * cos_theta)
        - d1_by_delta * beta_rate_dot_by_theta_of_beta_rate_4;
    // d1_by_phi_minus_90deg = 2*rr^2*sin(theta)^2*((sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta
    //   - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2) + cos(phi_minus_90deg)*(m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*(ea/e - 1) - (I4*cos(gamma - delta)^2/e^2 + cos(gamma -
    //   delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2
    //   + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - m4*cos(gamma - delta)*cos(gamma
    //   - delta - phi_minus_90deg)*(ea/e - 1))/(cos(beta + theta - gamma)^2*sin(phi_minus_90deg))
    let d1_by_phi_minus_90deg = sin_phi_minus_90deg_inv * d1_by_delta_of_place_2
        * (sin_phi_minus_90deg_inv
            * (cos_phi_minus_90deg
                * (-d1_of_place_19)
                    .mul_add(sin_phi_minus_90deg_inv, beta_rate_dot_by_gamma_of_place_27)
                + beta_rate_dot_by_beta_of_place_73 * beta_rate_dot_by_gamma_of_place_41)
            - beta_rate_dot_by_theta_of_place_17);
    let beta_rate_dot_by_phi_minus_90deg_of_place = S::int(2) * sin_phi_minus_90deg;
    let beta_rate_dot_by_phi_minus_90deg_of_place_2 = beta_rate_dot_by_beta_of_place_60
        * beta_rate_dot_by_beta_of_place_60;
    // 1 + beta_rate_dot_by_phi_minus_90deg_of_place_2
    let beta_rate_dot_by_phi_minus_90deg_of_place_3 = S::int(1)
        + beta_rate_dot_by_phi_minus_90deg_of_place_2;
    // cos(gamma - delta - phi_minus_90deg)*sin(phi_minus_90deg) - beta_rate_dot_by_beta_of_place_93
    let beta_rate_dot_by_phi_minus_90deg_of_place_4 = d1_of_place_13
        .mul_add(sin_phi_minus_90deg, -beta_rate_dot_by_beta_of_place_93);
    // -beta_rate_dot_by_phi_minus_90deg_of_place_4
    let beta_rate_dot_by_phi_minus_90deg_of_place_5 = -beta_rate_dot_by_phi_minus_90deg_of_place_4;
    let beta_rate_dot_by_phi_minus_90deg_of_place_6 = S::int(2) * beta_rate_dot_by_beta_of_place_60;
    // ss_inv*(sin(gamma - delta - phi_minus_90deg)*sin(phi_minus_90deg) + d1_of_place_14)
    let beta_rate_dot_by_phi_minus_90deg_of_place_7 = ss_inv
        * beta_rate_dot_by_beta_of_place_30.mul_add(sin_phi_minus_90deg, d1_of_place_14);
    // cos(gamma - delta - phi_minus_90deg) + beta_rate_dot_by_beta_of_place_96*cos(gamma - delta)
    let beta_rate_dot_by_phi_minus_90deg_of_place_8 = beta_rate_dot_by_beta_of_place_96
        .mul_add(cos_gamma_minus_delta, d1_of_place_13);
    // d1_by_gamma_of_place_5 + m4*(beta_rate_dot_by_gamma_of_place_41 + cos(gamma -
    //   delta)*(beta_rate_dot_by_phi_minus_90deg_of_place_4 +
    //   ea_e_inv*beta_rate_dot_by_phi_minus_90deg_of_place_5))
    let beta_rate_dot_by_phi_minus_90deg_of_place_9 = d1_by_gamma_of_place_5
        + m4
            * (beta_rate_dot_by_gamma_of_place_41
                + cos_gamma_minus_delta
                    * ea_e_inv
                        .mul_add(
                            beta_rate_dot_by_phi_minus_90deg_of_place_5,
                            beta_rate_dot_by_phi_minus_90deg_of_place_4,
                        ));
    // d1_of_place_20*(d1_of_place_19*beta_rate_dot_by_beta_of_place_60 -
    //   beta_rate_dot_by_phi_minus_90deg_of_place_9)
    let beta_rate_dot_by_phi_minus_90deg_of_place_10 = d1_of_place_20
        * d1_of_place_19
            .mul_add(
                beta_rate_dot_by_beta_of_place_60, -beta_rate_dot_by_phi_minus_90deg_of_place_9,
            );
    let beta_rate_dot_by_phi_minus_90deg_of_place_11 = cos_theta_doubled
        * beta_rate_dot_by_phi_minus_90deg_of_place_10;
    // beta_rate_dot_by_phi_minus_90deg = rr^2*beta_rate^2*sin(theta)*(rr*(2*cos(theta)*cos(beta -
    //   gamma)*((I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)) - (sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta)*(sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - ea*(sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(2*cos(beta -
    //   gamma)*tan(beta + theta - gamma)*((I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)) - (sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta)*(sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - ea*(sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(2*(cos(gamma -
    //   delta - phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg))
    //   + (cos(gamma - delta)*(m4*((sin(phi_minus_90deg)*sin(gamma - delta - phi_minus_90deg) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss + (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg)) - ea*(cos(gamma -
    //   delta)*(cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg) +
    //   (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)^2 + (cos(gamma - delta)*(2 -
    //   ea/e)/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(phi_minus_90deg)*sin(gamma - delta -
    //   phi_minus_90deg) + cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss) + cos(gamma -
    //   delta)*(cos(gamma - delta)/sin(phi_minus_90deg) + sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma -
    //   delta)/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/e) + I4*(cos(gamma - delta)^2/(e*sin(phi_minus_90deg)) +
    //   2*cos(gamma - delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)^2))/e^2) - sin(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*sin(gamma - delta - phi_minus_90deg)*(ea/e - 1) -
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + (I5*(sin(gamma -
    //   delta - phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma - delta - phi_minus_90deg)) +
    //   m5*(ta^2*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma - delta -
    //   phi_minus_90deg)) + tb^2*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma
    //   - delta - phi_minus_90deg))))/(ss*zt) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg)) -
    //   sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/sin(phi_minus_90deg)) -
    //   cos(gamma - delta)*((cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 +
    //   tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)) + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg)^2 + (2*m4*ea*sin(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) - sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)^2 + 2*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg) - sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg) - cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/(sin(phi_minus_90deg)*tan(phi_minus_90deg))))/sin(phi_minus_90deg))/zt +
    //   m4*((ea*sin(gamma - delta)*sin(phi_minus_90deg)/ss + cos(gamma - delta)*(sin(gamma - delta -
    //   phi_minus_90deg)/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + cos(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + sin(phi_minus_90deg)*(2*ea*tan(beta + theta - gamma)/ss -
    //   (2*cos(gamma - delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*sin(phi_minus_90deg)*(1 - ea/e) + sin(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*(2*cos(gamma - delta)*cos(phi_minus_90deg)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)))))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta) - sin(phi_minus_90deg)*(sin(gamma -
    //   delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) + cos(gamma - delta -
    //   phi_minus_90deg))/ss)))/sin(phi_minus_90deg)^2)))/cos(beta + theta - gamma) -
    //   2*cos(theta)*((I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 +
    //   tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)) - (sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta)*(sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - ea*(sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/(d1*cos(beta + theta -
    //   gamma)^2) - d1_by_phi_minus_90deg*(mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc)
    //   + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_phi_minus_90deg = -beta_rate_dot_by_delta_of_beta_rate_3
        * (beta_rate_dot_by_phi_minus_90deg_of_place_11
            + rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (d1_of_place_20
                            * (beta_rate_dot_by_gamma_of_place_37
                                + d1_of_place_13
                                    * (zt_inv
                                        * (beta_rate_dot_by_delta_of_place_3
                                            - beta_rate_dot_by_beta_of_place_96
                                                * beta_rate_dot_by_theta_of_place_15
                                            + sin_phi_minus_90deg_inv
                                                * (d1_of_place_14
                                                    * (-beta_rate_dot_by_beta_of_place_73)
                                                        .mul_add(
                                                            beta_rate_dot_by_beta_of_place_97,
                                                            beta_rate_dot_by_gamma_of_place_25,
                                                        )
                                                    - beta_rate_dot_by_beta_of_place_75
                                                        * beta_rate_dot_by_phi_minus_90deg_of_place_4
                                                    + cos_gamma_minus_delta
                                                        * (e_inv
                                                            * (d1_of_place_18
                                                                + beta_rate_dot_by_beta_of_place_60
                                                                    * (-(ea * m4_d1_of_place_13))
                                                                        .mul_add(
                                                                            beta_rate_dot_by_phi_minus_90deg_of_place,
                                                                            beta_rate_dot_by_gamma_of_place_21,
                                                                        )
                                                                - beta_rate_dot_by_beta_of_place_59
                                                                    * beta_rate_dot_by_phi_minus_90deg_of_place_3)
                                                            - m4
                                                                * beta_rate_dot_by_phi_minus_90deg_of_place_5
                                                                    .mul_add(
                                                                        beta_rate_dot_by_phi_minus_90deg_of_place_6,
                                                                        d1_of_place_15 * beta_rate_dot_by_phi_minus_90deg_of_place_3,
                                                                    ))))
                                        + m4
                                            * (e_inv
                                                * (cos_gamma_minus_delta
                                                    * (beta_rate_dot_by_beta_of_place_74
                                                        + beta_rate_dot_by_beta_of_place_30
                                                            * beta_rate_dot_by_beta_of_place_96
                                                        + beta_rate_dot_by_theta_of_place_19 * sin_phi_minus_90deg
                                                        + cos_phi_minus_90deg
                                                            * (d1_of_place_20
                                                                * (-beta_rate_dot_by_beta_of_place_64)
                                                                    .mul_add(
                                                                        beta_rate_dot_by_phi_minus_90deg_of_place,
                                                                        beta_rate_dot_by_beta_of_place_30,
                                                                    )
                                                                - beta_rate_dot_by_theta_of_place_18
                                                                    * beta_rate_dot_by_phi_minus_90deg_of_place_6))
                                                    + beta_rate_dot_by_theta_of_place_22 * sin_phi_minus_90deg)
                                                - ss_inv
                                                    * beta_rate_dot_by_theta_of_place_24
                                                        .mul_add(
                                                            sin_phi_minus_90deg,
                                                            beta_rate_dot_by_delta_of_place,
                                                        )))
                                - cos_gamma_minus_delta
                                    * (e_inv_i4_e_inv
                                        * (beta_rate_dot_by_theta_of_place_27
                                            * beta_rate_dot_by_theta_of_place_29)
                                            .mul_add(
                                                S::int(2),
                                                d1_of_place_17 * beta_rate_dot_by_beta_of_place_66,
                                            )
                                        + m4
                                            * (beta_rate_dot_by_phi_minus_90deg_of_place_7
                                                + e_inv
                                                    * (-ea
                                                        * (d1_of_place_17
                                                            * (beta_rate_dot_by_beta_of_place_67
                                                                + beta_rate_dot_by_beta_of_place_60
                                                                    * (-d1_of_place_11)
                                                                        .mul_add(beta_rate_dot_by_beta_of_place_96, d1_of_place_13)
                                                                - beta_rate_dot_by_beta_of_place_68
                                                                    * beta_rate_dot_by_phi_minus_90deg_of_place_2)
                                                            + beta_rate_dot_by_phi_minus_90deg_of_place_7)
                                                        + beta_rate_dot_by_beta_of_place_69 * cos_gamma_minus_delta
                                                        + beta_rate_dot_by_theta_of_place_27
                                                            * (beta_rate_dot_by_gamma_of_place_33
                                                                + beta_rate_dot_by_phi_minus_90deg_of_place_8)))))
                            - beta_rate_dot_by_theta_of_place_31
                                * beta_rate_dot_by_phi_minus_90deg_of_place_6)
                        - beta_rate_dot_by_gamma_of_place_44
                            * beta_rate_dot_by_phi_minus_90deg_of_place_10)
                    - d1_of_d_beta_gamma * beta_rate_dot_by_phi_minus_90deg_of_place_11))
        - d1_by_phi_minus_90deg * beta_rate_dot_by_theta_of_beta_rate_4;
    // d1_by_epsilon = 2*rr^2*sin(theta)^2*(sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 + m6*(cos(gamma - epsilon
    //   - omega)*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega)) - sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + sin(omega)*sin(gamma - epsilon - omega))/zf)))/(cos(beta + theta -
    //   gamma)^2*cos(omega)^2)
    let d1_by_epsilon = -d1_by_gamma_of_place_4 * d1_by_delta_of_place_2;
    // sin(gamma - epsilon - omega)*sin_angle_cos_angle_inv - cos(gamma - epsilon - omega)
    let beta_rate_dot_by_epsilon_of_place = beta_rate_dot_by_beta_of_place_22
        .mul_add(sin_angle_cos_angle_inv, -d1_of_place_4);
    // -beta_rate_dot_by_epsilon_of_place
    let beta_rate_dot_by_epsilon_of_place_2 = -beta_rate_dot_by_epsilon_of_place;
    // u_2_inv_ss_inv*(I7*beta_rate_dot_by_epsilon_of_place_2 +
    //   m7*ua_sq_plus_ub_sq*beta_rate_dot_by_epsilon_of_place_2) - beta_rate_dot_by_gamma_of_place_7
    let beta_rate_dot_by_epsilon_of_place_3 = u_2_inv_ss_inv
        * (m7 * ua_sq_plus_ub_sq)
            .mul_add(
                beta_rate_dot_by_epsilon_of_place_2,
                I7 * beta_rate_dot_by_epsilon_of_place_2,
            ) - beta_rate_dot_by_gamma_of_place_7;
    let beta_rate_dot_by_epsilon_of_place_4 = beta_rate_dot_by_theta_of_place_2
        * cos_gamma_minus_epsilon;
    // sin(gamma - epsilon) + sin_angle_cos_angle_inv*cos(gamma - epsilon)
    let beta_rate_dot_by_epsilon_of_place_5 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_epsilon, sin_gamma_minus_epsilon);
    // beta_rate_dot_by_epsilon = -rr^2*beta_rate^2*sin(theta)*(cos(theta)*(2*I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf) - 2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 +
    //   rr*(cos(theta)*cos(beta - gamma)*(2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 - m6*(cos(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - 2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/(d*cos(omega)^2) + sin(theta)*(cos(beta -
    //   gamma)*tan(gamma - beta - theta)*(2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 - 2*sin(gamma
    //   - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
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
    //   theta - gamma)^2) - d1_by_epsilon*(mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc)
    //   + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_epsilon = beta_rate_dot_by_delta_of_beta_rate_3
        * (rr_cos_angle_inv
            * (sin_theta
                * (cos_omega_inv_sq * sin_theta
                    * (beta_rate_dot_by_gamma_of_place_19
                        - d1_of_place_4
                            * (u_2_inv
                                * (beta_rate_dot_by_gamma_of_place_6
                                    + beta_rate_dot_by_epsilon_of_place_3)
                                + m6
                                    * (zf_inv
                                        * (beta_rate_dot_by_gamma_of_place_10
                                            - sin_gamma_minus_epsilon
                                                * (cos_omega_inv * sin_omega_cos_omega_inv)
                                                    .mul_add(
                                                        beta_rate_dot_by_gamma_of_place_8,
                                                        beta_rate_dot_by_gamma_of_place_9,
                                                    ))
                                        - ss_inv
                                            * (beta_rate_dot_by_epsilon_of_place
                                                + sin_omega
                                                    * (sin_gamma_minus_epsilon
                                                        + beta_rate_dot_by_epsilon_of_place_4))))
                        + sin_gamma_minus_epsilon
                            * (m6
                                * (zf_inv
                                    * (beta_rate_dot_by_gamma_of_place_16
                                        + fa
                                            * (beta_rate_dot_by_gamma_of_place_15
                                                + ss_inv
                                                    * (sin_gamma_minus_epsilon
                                                        .mul_add(S::int(2), -sin_omega_d1_of_place_4)
                                                        + beta_rate_dot_by_epsilon_of_place_4
                                                        - fa_zf_inv * beta_rate_dot_by_epsilon_of_place_5)))
                                    + ss_inv
                                        * (sin_omega_d1_of_place_4
                                            - beta_rate_dot_by_epsilon_of_place_5))
                                + zf_inv_i6_zf_inv
                                    * (-ss_inv)
                                        .mul_add(
                                            beta_rate_dot_by_epsilon_of_place_5,
                                            beta_rate_dot_by_gamma_of_place_17,
                                        )))
                    + beta_rate_dot_by_theta_of_place_33 * beta_rate_dot_by_gamma_of_place_40)
                + beta_rate_dot_by_gamma_of_place_40 * beta_rate_dot_by_delta_of_place_6)
            - beta_rate_dot_by_gamma_of_place_40 * cos_theta)
        - d1_by_epsilon * beta_rate_dot_by_theta_of_beta_rate_4;
    // d1_by_omega = 2*rr^2*sin(theta)^2*(m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(fa/zf - 1)
    //   + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2) +
    //   sin(omega)*(m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*(fa/zf - 1) + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)))/cos(omega))/(cos(beta + theta - gamma)^2*cos(omega))
    let d1_by_omega = cos_omega_inv * d1_by_delta_of_place_2
        * (beta_rate_dot_by_beta_of_place_81
            + cos_omega_inv
                * (sin_omega
                    * d1_of_place_10
                        .mul_add(cos_omega_inv, beta_rate_dot_by_gamma_of_place_7)
                    + beta_rate_dot_by_beta_of_place_44 * beta_rate_dot_by_gamma_of_place_39));
    let cos_omega_d1_of_place_4 = d1_of_place_4 * cos_omega;
    // 1 + sin_omega_cos_omega_inv^2
    let beta_rate_dot_by_omega_of_omega = sin_omega_cos_omega_inv
        .mul_add(sin_omega_cos_omega_inv, S::int(1));
    // beta_rate_dot_by_beta_of_place_85 + cos_omega_d1_of_place_4
    let beta_rate_dot_by_omega_of_place = beta_rate_dot_by_beta_of_place_85
        + cos_omega_d1_of_place_4;
    let beta_rate_dot_by_omega_of_omega_2 = S::int(2) * sin_omega_cos_omega_inv;
    // ss_inv*(sin_omega_d1_of_place_4 - sin(gamma - epsilon - omega)*cos(omega))
    let beta_rate_dot_by_omega_of_place_2 = ss_inv
        * (-beta_rate_dot_by_beta_of_place_22)
            .mul_add(cos_omega, sin_omega_d1_of_place_4);
    // d1_of_zf_fa*beta_rate_dot_by_beta_of_place_91 - cos(gamma - epsilon - omega)
    let beta_rate_dot_by_omega_of_place_3 = d1_of_zf_fa
        .mul_add(beta_rate_dot_by_beta_of_place_91, -d1_of_place_4);
    // d1_by_gamma_of_place_2 + m6*(beta_rate_dot_by_gamma_of_place_39 -
    //   beta_rate_dot_by_beta_of_zf_fa*beta_rate_dot_by_omega_of_place*sin(gamma - epsilon))
    let beta_rate_dot_by_omega_of_place_4 = d1_by_gamma_of_place_2
        + m6
            * (-(beta_rate_dot_by_beta_of_zf_fa * beta_rate_dot_by_omega_of_place))
                .mul_add(sin_gamma_minus_epsilon, beta_rate_dot_by_gamma_of_place_39);
    // cos_omega_inv_sq*(d1_of_place_10*sin_omega_cos_omega_inv + beta_rate_dot_by_omega_of_place_4)
    let beta_rate_dot_by_omega_of_place_5 = cos_omega_inv_sq
        * d1_of_place_10
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
    //   omega)))/zf)))/cos(omega)^2)))/cos(beta + theta - gamma))/(d1*cos(beta + theta - gamma)^2) -
    //   d1_by_omega*(mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta -
    //   gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_omega = beta_rate_dot_by_delta_of_beta_rate_3
        * (beta_rate_dot_by_omega_of_place_6
            + rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (cos_omega_inv_sq
                            * (beta_rate_dot_by_gamma_of_place_18
                                + d1_of_place_4
                                    * (m6
                                        * (ss_inv
                                            * beta_rate_dot_by_theta_of_place_8
                                                .mul_add(cos_omega, beta_rate_dot_by_epsilon_of_place)
                                            + zf_inv
                                                * (sin_gamma_minus_epsilon
                                                    * (beta_rate_dot_by_beta_of_place_45
                                                        + beta_rate_dot_by_theta_of_place_4 * cos_omega
                                                        - sin_omega_cos_omega_inv
                                                            * beta_rate_dot_by_theta_of_place_5
                                                        - sin_omega
                                                            * (cos_omega_inv_sq
                                                                * (beta_rate_dot_by_beta_of_place_49 * cos_omega)
                                                                    .mul_add(S::int(2), beta_rate_dot_by_beta_of_place_22)
                                                                + beta_rate_dot_by_theta_of_place_3
                                                                    * beta_rate_dot_by_omega_of_omega_2))
                                                    - d1_of_place_3 * fa_ss_inv))
                                        - u_2_inv
                                            * (beta_rate_dot_by_epsilon_of_place_3
                                                - sin_omega_cos_omega_inv
                                                    * beta_rate_dot_by_beta_of_place_79
                                                - cos_omega_inv
                                                    * (sin_omega_d1_of_place_4
                                                        * sin_omega_cos_omega_inv
                                                            .mul_add(
                                                                beta_rate_dot_by_beta_of_place_46,
                                                                beta_rate_dot_by_gamma_of_place_5,
                                                            )
                                                        + beta_rate_dot_by_beta_of_place_47
                                                            * beta_rate_dot_by_omega_of_place
                                                        + sin_gamma_minus_epsilon
                                                            * (zf_inv
                                                                * (d1_of_place_9
                                                                    + sin_omega_cos_omega_inv
                                                                        * (m6_fa * cos_omega_d1_of_place_4)
                                                                            .mul_add(S::int(2), -beta_rate_dot_by_gamma_of_place_2)
                                                                    + beta_rate_dot_by_beta_of_place_40
                                                                        * beta_rate_dot_by_omega_of_omega)
                                                                + m6
                                                                    * (-beta_rate_dot_by_omega_of_place)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_omega_of_omega_2,
                                                                            d1_of_place_6 * beta_rate_dot_by_omega_of_omega,
                                                                        )))))
                                + sin_gamma_minus_epsilon
                                    * (m6
                                        * (beta_rate_dot_by_omega_of_place_2
                                            - zf_inv
                                                * (beta_rate_dot_by_beta_of_place_88
                                                    * sin_gamma_minus_epsilon
                                                    + sin_omega_cos_omega_inv
                                                        * beta_rate_dot_by_beta_of_place_89
                                                    + beta_rate_dot_by_beta_of_place_84
                                                        * (d1_of_place_4 + beta_rate_dot_by_beta_of_place_91)
                                                    + fa
                                                        * (beta_rate_dot_by_omega_of_place_2
                                                            + d1_of_place_8 * beta_rate_dot_by_beta_of_place_53
                                                            + beta_rate_dot_by_theta_of_place_11
                                                                * (beta_rate_dot_by_gamma_of_place_14
                                                                    + beta_rate_dot_by_omega_of_place_3))))
                                        - zf_inv_i6_zf_inv
                                            * (beta_rate_dot_by_beta_of_place_91
                                                * beta_rate_dot_by_theta_of_place_11)
                                                .mul_add(
                                                    S::int(2),
                                                    d1_of_place_8 * beta_rate_dot_by_beta_of_place_52,
                                                )))
                            + beta_rate_dot_by_theta_of_place_13
                                * beta_rate_dot_by_omega_of_omega_2)
                        - beta_rate_dot_by_gamma_of_place_44 * beta_rate_dot_by_omega_of_place_5)
                    - d1_of_d_beta_gamma * beta_rate_dot_by_omega_of_place_6))
        - d1_by_omega * beta_rate_dot_by_theta_of_beta_rate_4;
    // beta_rate_dot_by_beta_rate = 2*rr*(rr*beta_rate*(cos(beta - gamma)*(I2*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + rr*beta_rate*sin(theta)*(m2*da*cos(beta -
    //   gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) -
    //   rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta -
    //   gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2
    //   + m4*(cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d +
    //   sin(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon -
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
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
    //   epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma
    //   - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta -
    //   theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma -
    //   epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf)
    //   + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) +
    //   sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma)))/(d1*cos(beta + theta - gamma))
    let beta_rate_dot_by_beta_rate = S::int(2) * rr_cos_angle_inv * d1_inv * rr_beta_rate
        * d_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_64,
                beta_rate_dot_by_theta_of_place_42 * sin_theta,
            );
    let theta_dot_by_beta_value_of_beta_rate = d_inv * beta_rate_dot_by_theta_of_place_36
        * beta_rate_dot_by_delta_of_beta_rate;
    let gamma_dot_by_beta_value_of_beta_rate = ss_inv * sin_angle_cos_angle_inv
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let gamma_dot_by_theta_value_of_beta_rate = d1_by_theta_of_place_2
        * beta_rate_dot_by_delta_of_beta_rate;
    let delta_dot_by_beta_value_of_beta_rate = sin_phi_minus_90deg_inv
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let delta_dot_by_gamma_value_of_beta_rate = zt_inv * delta_dot_by_beta_value_of_beta_rate;
    // sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*beta_rate_dot_by_beta_of_place_60
    let delta_dot_by_phi_minus_90deg_value_of_place = (-d1_of_place_13)
        .mul_add(beta_rate_dot_by_beta_of_place_60, beta_rate_dot_by_beta_of_place_30);
    let delta_dot_by_beta_rate_value_of_place = sin_phi_minus_90deg_inv * d1_by_delta_of_place;
    // e_inv*(zt*cos(gamma - delta) + e*cos(gamma - delta - phi_minus_90deg))
    let phi_dot_by_beta_value_of_place = e_inv
        * e.mul_add(d1_of_place_13, zt * cos_gamma_minus_delta);
    let epsilon_dot_by_beta_value_of_beta_rate = cos_omega_inv
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let epsilon_dot_by_gamma_value_of_beta_rate = u_2_inv * epsilon_dot_by_beta_value_of_beta_rate;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_omega_cos_omega_inv
    let epsilon_dot_by_omega_value_of_place = d1_of_place_4
        .mul_add(sin_omega_cos_omega_inv, beta_rate_dot_by_beta_of_place_22);
    let epsilon_dot_by_beta_rate_value_of_place = cos_omega_inv * d1_by_delta_of_place;
    // zf_inv*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon - omega))
    let omega_dot_by_beta_value_of_place = zf_inv
        * (-zf).mul_add(d1_of_place_4, u_2 * sin_gamma_minus_epsilon);
    // Entries that are not zero.
    // d(beta')/d(beta_rate) = 1
    let beta_dot_by_beta_rate_value = S::int(1);
    // d(theta')/d(beta) = -rr*beta_rate*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
    //   theta))/(d*cos(beta + theta - gamma))
    let theta_dot_by_beta_value = -theta_dot_by_beta_value_of_beta_rate;
    // d(theta')/d(theta) = rr*beta_rate*cos(beta - gamma)*tan(beta + theta - gamma)/(d*cos(beta + theta -
    //   gamma))
    let theta_dot_by_theta_value = beta_rate_dot_by_theta_of_place_33
        * beta_rate_dot_by_delta_of_beta_rate;
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
    // d(delta')/d(beta) = rr*beta_rate*sin(theta)*cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)/(zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let delta_dot_by_beta_value = d1_of_place_13_zt_inv * sin_angle_cos_angle_inv
        * delta_dot_by_beta_value_of_beta_rate;
    // d(delta')/d(theta) = rr*beta_rate*cos(gamma - delta - phi_minus_90deg)*(cos(theta) +
    //   sin(theta)*tan(beta + theta - gamma))/(zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let delta_dot_by_theta_value = d1_of_place_13_zt_inv * sin_phi_minus_90deg_inv
        * gamma_dot_by_theta_value_of_beta_rate;
    // d(delta')/d(gamma) = -rr*beta_rate*sin(theta)*(sin(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta - phi_minus_90deg)*tan(beta + theta - gamma))/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_by_gamma_value = -beta_rate_dot_by_theta_of_place_16
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(delta) = rr*beta_rate*sin(theta)*sin(gamma - delta - phi_minus_90deg)/(zt*cos(beta +
    //   theta - gamma)*sin(phi_minus_90deg))
    let delta_dot_by_delta_value = beta_rate_dot_by_beta_of_place_30
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(phi_minus_90deg) = rr*beta_rate*sin(theta)*(sin(gamma - delta - phi_minus_90deg) -
    //   cos(gamma - delta - phi_minus_90deg)/tan(phi_minus_90deg))/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_by_phi_minus_90deg_value = delta_dot_by_gamma_value_of_beta_rate
        * delta_dot_by_phi_minus_90deg_value_of_place;
    // d(delta')/d(beta_rate) = rr*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_by_beta_rate_value = d1_of_place_13_zt_inv
        * delta_dot_by_beta_rate_value_of_place;
    // d(phi')/d(beta) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(zt*cos(gamma - delta) +
    //   e*cos(gamma - delta - phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_beta_value = -sin_angle_cos_angle_inv
        * delta_dot_by_gamma_value_of_beta_rate * phi_dot_by_beta_value_of_place;
    // d(phi')/d(theta) = -rr*beta_rate*(cos(gamma - delta)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/e + cos(gamma - delta - phi_minus_90deg)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/zt)/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_theta_value = -sin_phi_minus_90deg_inv
        * beta_rate_dot_by_beta_of_place_77 * d1_by_theta_of_place_2
        * beta_rate_dot_by_delta_of_beta_rate;
    // d(phi')/d(gamma) = rr*beta_rate*sin(theta)*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/e + (sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/zt)/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_gamma_value = delta_dot_by_beta_value_of_beta_rate
        * e_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_28,
                zt_inv * beta_rate_dot_by_theta_of_place_16,
            );
    // d(phi')/d(delta) = -rr*beta_rate*sin(theta)*(zt*sin(gamma - delta) + e*sin(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_delta_value = -e_inv * delta_dot_by_gamma_value_of_beta_rate
        * e.mul_add(beta_rate_dot_by_beta_of_place_30, zt * sin_gamma_minus_delta);
    // d(phi')/d(phi_minus_90deg) = rr*beta_rate*sin(theta)*(cos(gamma - delta)/(e*tan(phi_minus_90deg)) -
    //   (sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)/tan(phi_minus_90deg))/zt)/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_phi_minus_90deg_value = delta_dot_by_beta_value_of_beta_rate
        * (-zt_inv)
            .mul_add(
                delta_dot_by_phi_minus_90deg_value_of_place,
                d1_of_place_17 * beta_rate_dot_by_beta_of_place_60,
            );
    // d(phi')/d(beta_rate) = -rr*sin(theta)*(zt*cos(gamma - delta) + e*cos(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_beta_rate_value = -zt_inv * delta_dot_by_beta_rate_value_of_place
        * phi_dot_by_beta_value_of_place;
    // d(epsilon')/d(beta) = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_beta_value = d1_of_place_4_u_2_inv * sin_angle_cos_angle_inv
        * epsilon_dot_by_beta_value_of_beta_rate;
    // d(epsilon')/d(theta) = rr*beta_rate*cos(gamma - epsilon - omega)*(cos(theta) + sin(theta)*tan(beta +
    //   theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_theta_value = d1_of_place_4_u_2_inv * cos_omega_inv
        * gamma_dot_by_theta_value_of_beta_rate;
    // d(epsilon')/d(gamma) = -rr*beta_rate*sin(theta)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon
    //   - omega)*tan(beta + theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_gamma_value = -beta_rate_dot_by_theta_of_place
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(epsilon) = rr*beta_rate*sin(theta)*sin(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_by_epsilon_value = beta_rate_dot_by_beta_of_place_22
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(omega) = rr*beta_rate*sin(theta)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(omega))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_omega_value = epsilon_dot_by_gamma_value_of_beta_rate
        * epsilon_dot_by_omega_value_of_place;
    // d(epsilon')/d(beta_rate) = rr*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_by_beta_rate_value = d1_of_place_4_u_2_inv
        * epsilon_dot_by_beta_rate_value_of_place;
    // d(omega')/d(beta) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(zf*cos(gamma - epsilon -
    //   omega) - u*sin(gamma - epsilon))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_beta_value = sin_angle_cos_angle_inv
        * epsilon_dot_by_gamma_value_of_beta_rate * omega_dot_by_beta_value_of_place;
    // d(omega')/d(theta) = rr*beta_rate*(sin(gamma - epsilon)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/zf - cos(gamma - epsilon - omega)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/u)/(cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_theta_value = cos_omega_inv * beta_rate_dot_by_beta_of_place_55
        * d1_by_theta_of_place_2 * beta_rate_dot_by_delta_of_beta_rate;
    // d(omega')/d(gamma) = rr*beta_rate*sin(theta)*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/zf + (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta +
    //   theta - gamma))/u)/(cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_gamma_value = epsilon_dot_by_beta_value_of_beta_rate
        * zf_inv
            .mul_add(
                beta_rate_dot_by_theta_of_place_10,
                u_2_inv * beta_rate_dot_by_theta_of_place,
            );
    // d(omega')/d(epsilon) = -rr*beta_rate*sin(theta)*(u*cos(gamma - epsilon) + zf*sin(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_epsilon_value = -zf_inv * epsilon_dot_by_gamma_value_of_beta_rate
        * zf.mul_add(beta_rate_dot_by_beta_of_place_22, u_2 * cos_gamma_minus_epsilon);
    // d(omega')/d(omega) = rr*beta_rate*sin(theta)*(sin(gamma - epsilon)*tan(omega)/zf - (sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/u)/(cos(beta + theta -
    //   gamma)*cos(omega))
    let omega_dot_by_omega_value = epsilon_dot_by_beta_value_of_beta_rate
        * (-u_2_inv)
            .mul_add(
                epsilon_dot_by_omega_value_of_place, beta_rate_dot_by_theta_of_place_11,
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
            delta_dot_by_delta_value, delta_dot_by_phi_minus_90deg_value, zero, zero,
            delta_dot_by_beta_rate_value,
        ],
        [
            phi_dot_by_beta_value, phi_dot_by_theta_value, phi_dot_by_gamma_value,
            phi_dot_by_delta_value, phi_dot_by_phi_minus_90deg_value, zero, zero,
            phi_dot_by_beta_rate_value,
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
            beta_rate_dot_by_delta, beta_rate_dot_by_phi_minus_90deg, beta_rate_dot_by_epsilon,
            beta_rate_dot_by_omega, beta_rate_dot_by_beta_rate,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 29 operations, 4 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 7], _u: &[S; 1]) -> [S; 4] {
    let Parameters { xb, yb, xc, yc, sc, sd, .. } = *p;
    let [beta, theta, gamma, _, phi_minus_90deg, _, omega] = *q;
    // Sines and cosines.
    let (_, cos_omega) = omega.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi_minus_90deg, _) = phi_minus_90deg.sin_cos();
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
    // divisor2 = cos(omega)
    let divisor2 = cos_omega;
    // divisor3 = xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))
    let divisor3 = xb * (-xc).mul_add(S::int(2), xb) + xc * xc + yc * yc
        + yb * (-yc).mul_add(S::int(2), yb)
        + sc
            * (xb_minus_xc_doubled.mul_add(sin_gamma, sc) - yb_minus_yc_doubled * cos_gamma)
        + sd
            * (xb_minus_xc_doubled.mul_add(cos_gamma, sd) + yb_minus_yc_doubled * sin_gamma);
    // divisor4 = sin(phi_minus_90deg)
    let divisor4 = sin_phi_minus_90deg;
    [divisor1, divisor2, divisor3, divisor4]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 33 operations, 7 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 7], _u: &[S; 1]) -> [S; 6] {
    let Parameters { xa, ya, xb, yb, d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
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
    // epsilon + omega
    let epsilon_plus_omega = epsilon + omega;
    let (sin_epsilon_plus_omega, cos_epsilon_plus_omega) = epsilon_plus_omega.sin_cos();
    // delta + phi_minus_90deg
    let residual3_of_place_2 = delta + phi_minus_90deg;
    let (sin_angle, cos_angle) = residual3_of_place_2.sin_cos();
    // Values.
    // E3_1 = xb - rr*cos(beta) + d*cos(beta + theta) + ss*sin(gamma)
    let residual1 = ss.mul_add(sin_gamma, xb) - residual1_of_place;
    // E3_2 = yb - rr*sin(beta) + d*sin(beta + theta) - ss*cos(gamma)
    let residual2 = (-ss).mul_add(cos_gamma, yb) - residual2_of_place;
    // E4_1 = xa - rr*cos(beta) + d*cos(beta + theta) + zt*cos(delta) + e*cos(delta + phi_minus_90deg)
    let residual3 = e.mul_add(cos_angle, zt * cos_delta) + residual3_of_place;
    // E4_2 = ya - rr*sin(beta) + d*sin(beta + theta) + zt*sin(delta) + e*sin(delta + phi_minus_90deg)
    let residual4 = e.mul_add(sin_angle, zt * sin_delta) + residual4_of_place;
    // E6_1 = xa - rr*cos(beta) + d*cos(beta + theta) + u*sin(epsilon) + zf*cos(epsilon + omega)
    let residual5 = zf.mul_add(cos_epsilon_plus_omega, u_2 * sin_epsilon) + residual3_of_place;
    // E6_2 = ya - rr*sin(beta) + d*sin(beta + theta) - u*cos(epsilon) + zf*sin(epsilon + omega)
    let residual6 = (-u_2).mul_add(cos_epsilon, zf * sin_epsilon_plus_omega) + residual4_of_place;
    [residual1, residual2, residual3, residual4, residual5, residual6]
}

/// Slopes of the constraints, one after the other, along beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega, beta_rate.
///
/// 27 operations, 7 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    _u: &[S; 1],
) -> [S; 48] {
    let Parameters { d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
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
    // delta + phi_minus_90deg
    let residual3_by_delta_of_place = delta + phi_minus_90deg;
    let (sin_angle, cos_angle) = residual3_by_delta_of_place.sin_cos();
    let e_sin_angle = e * sin_angle;
    let e_cos_angle = e * cos_angle;
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
    // d(E4_1)/d(delta) = -zt*sin(delta) - e*sin(delta + phi_minus_90deg)
    let residual3_by_delta = (-zt).mul_add(sin_delta, -e_sin_angle);
    // d(E4_1)/d(phi_minus_90deg) = -e*sin(delta + phi_minus_90deg)
    let residual3_by_phi_minus_90deg = -e_sin_angle;
    // d(E4_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual4_by_beta = residual2_by_beta_of_place;
    // d(E4_2)/d(theta) = d*cos(beta + theta)
    let residual4_by_theta = d_cos_beta_plus_theta;
    // d(E4_2)/d(delta) = zt*cos(delta) + e*cos(delta + phi_minus_90deg)
    let residual4_by_delta = zt.mul_add(cos_delta, e_cos_angle);
    // d(E4_2)/d(phi_minus_90deg) = e*cos(delta + phi_minus_90deg)
    let residual4_by_phi_minus_90deg = e_cos_angle;
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
        residual3_by_beta, residual3_by_theta, zero, residual3_by_delta,
        residual3_by_phi_minus_90deg, zero, zero, zero, residual4_by_beta, residual4_by_theta, zero,
        residual4_by_delta, residual4_by_phi_minus_90deg, zero, zero, zero, residual5_by_beta,
        residual5_by_theta, zero, zero, zero, residual5_by_epsilon, residual5_by_omega, zero,
        residual6_by_beta, residual6_by_theta, zero, zero, zero, residual6_by_epsilon,
        residual6_by_omega, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (beta_rate) that must act beside the loads of the model for the accelerations to be (beta_rate').
///
/// 438 operations, 8 sines and cosines, 1 other function.
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
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    let [beta_rate_dot] = *v_dot;
    // Sines and cosines.
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // beta + theta - gamma
    let tau1_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = tau1_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // 2 - fa_zf_inv
    let tau1_of_zf_fa = S::int(2) - fa_zf_inv;
    // -tau1_of_zf_fa
    let minus_tau1_of_zf_fa = -tau1_of_zf_fa;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let tau1_of_place_2 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_doubled = S::int(2) * sin_omega;
    let tau1_of_place_3 = tau1_of_place_2 * sin_omega_doubled;
    // sin(gamma - epsilon) - tau1_of_place_3
    let tau1_of_place_4 = sin_gamma_minus_epsilon - tau1_of_place_3;
    let tau1_of_place_2_sq = tau1_of_place_2 * tau1_of_place_2;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let tau1_of_place_5 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_tau1_of_place_5 = u_2_inv * tau1_of_place_5;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let tau1_of_e_ea = ea_e_inv - S::int(2);
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let tau1_of_place_6 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let tau1_of_place_7 = S::int(2) * cos_phi_minus_90deg;
    let tau1_of_place_8 = tau1_of_place_6 * tau1_of_place_7;
    // cos(gamma - delta) - tau1_of_place_8
    let tau1_of_place_9 = cos_gamma_minus_delta - tau1_of_place_8;
    let tau1_of_place_6_sq = tau1_of_place_6 * tau1_of_place_6;
    let i4_e_inv = I4 * e_inv;
    let tau1_of_place_10 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let tau1_of_place_11 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_tau1_of_place_11 = zt_inv * tau1_of_place_11;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let tau1_of_place_12 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
    // cos_omega_inv_sq*(m6*(sin(gamma - epsilon)*(fa_zf_inv*(minus_tau1_of_zf_fa*sin(gamma - epsilon) +
    //   tau1_of_place_3) + tau1_of_place_4) + tau1_of_place_2_sq) +
    //   tau1_of_place_2_sq*u_2_inv_tau1_of_place_5 + zf_inv_i6_zf_inv*sin(gamma - epsilon)^2) +
    //   tau1_of_place_12*(m4*(cos(gamma - delta)*(ea_e_inv*(tau1_of_e_ea*cos(gamma - delta) +
    //   tau1_of_place_8) + tau1_of_place_9) + tau1_of_place_6_sq) + i4_e_inv*tau1_of_place_10*cos(gamma -
    //   delta) + tau1_of_place_6_sq*zt_inv_tau1_of_place_11)
    let tau1_of_place_13 = cos_omega_inv_sq
        * (m6
            * (sin_gamma_minus_epsilon
                * (fa_zf_inv
                    * minus_tau1_of_zf_fa
                        .mul_add(sin_gamma_minus_epsilon, tau1_of_place_3)
                    + tau1_of_place_4) + tau1_of_place_2_sq)
            + tau1_of_place_2_sq * u_2_inv_tau1_of_place_5
            + zf_inv_i6_zf_inv * sin_gamma_minus_epsilon * sin_gamma_minus_epsilon)
        + tau1_of_place_12
            * (m4
                * (cos_gamma_minus_delta
                    * (ea_e_inv * tau1_of_e_ea.mul_add(cos_gamma_minus_delta, tau1_of_place_8)
                        + tau1_of_place_9) + tau1_of_place_6_sq)
                + i4_e_inv * tau1_of_place_10 * cos_gamma_minus_delta
                + tau1_of_place_6_sq * zt_inv_tau1_of_place_11);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let tau1_of_place_14 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_tau1_of_place_14 = ss_inv * tau1_of_place_14;
    // tau1_of_place_13 + ss_inv_tau1_of_place_14
    let tau1_of_place_15 = tau1_of_place_13 + ss_inv_tau1_of_place_14;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let tau1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let tau1_of_place_16 = m2_da * tau1_of_d_beta_gamma;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let tau1_of_place_17 = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let tau1_of_place_18 = (-yb_minus_yc).mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_tau1_of_zf_fa*m6_fa
    let tau1_of_m6_i6_zf_fa = minus_tau1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let tau1_of_place_19 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - tau1_of_place_19
    let tau1_of_place_20 = sin_gamma_minus_epsilon.mul_add(cos_omega, -tau1_of_place_19);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // fa_zf_inv - 1
    let tau1_of_zf_fa_2 = fa_zf_inv - S::int(1);
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let tau1_of_place_21 = tau1_of_place_2
        .mul_add(sin_angle_cos_angle_inv, tau1_of_place_20);
    let tau1_of_place_22 = tau1_of_zf_fa_2 * sin_gamma_minus_epsilon;
    let tau1_of_place_23 = S::int(2) * sin_angle_cos_angle_inv;
    let fa_ss_inv = fa * ss_inv;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let tau1_of_place_24 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let tau1_of_place_25 = tau1_of_place_20 * sin_omega;
    let tau1_of_place_26 = cos_omega_inv * sin_gamma_minus_epsilon;
    let tau1_of_place_27 = tau1_of_place_26 * sin_omega;
    let zf_inv_tau1_of_place_27 = zf_inv * tau1_of_place_27;
    let m4_ea = m4 * ea;
    // i4_e_inv + tau1_of_e_ea*m4_ea
    let tau1_of_m4_i4_e_ea = tau1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let tau1_of_place_28 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    let tau1_of_place_29 = sin_gamma_minus_delta * cos_phi_minus_90deg;
    // tau1_of_place_29 - cos(gamma - delta)*sin(phi_minus_90deg)
    let tau1_of_place_30 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, tau1_of_place_29);
    // ea_e_inv - 1
    let tau1_of_e_ea_2 = ea_e_inv - S::int(1);
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let tau1_of_place_31 = tau1_of_place_6
        .mul_add(sin_angle_cos_angle_inv, tau1_of_place_30);
    let tau1_of_place_32 = tau1_of_e_ea_2 * cos_gamma_minus_delta;
    let ea_ss_inv = ea * ss_inv;
    let tau1_of_place_33 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let tau1_of_place_34 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let tau1_of_place_35 = tau1_of_place_30 * cos_phi_minus_90deg;
    let tau1_of_place_36 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let tau1_of_place_37 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - tau1_of_d_beta_gamma*tau1_of_place_36*rr_cos_angle_inv
    let tau1_of_place_38 = (-(tau1_of_d_beta_gamma * tau1_of_place_36))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let tau1_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let tau1_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let tau1_of_place_39 = (xc_sq + tau1_of_xb_xc + yc_sq + tau1_of_yb_yc
        + sc
            * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                - S::int(2) * cos_gamma * yb_minus_yc)
        + sd
            * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                + S::int(2) * cos_gamma * xb_minus_xc))
        .sqrt();
    // Values.
    // tau1 = beta_rate'*(I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 +
    //   sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta
    //   + theta - gamma) - 2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma))) - mom -
    //   rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma -
    //   beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta +
    //   theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta -
    //   gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2
    //   + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*(tan(gamma - beta - theta)*(I3
    //   + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 +
    //   ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta -
    //   theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
    //   - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2 + (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)*(ea/e - 1) +
    //   (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 +
    //   tb^2))/zt^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma))))/(ss*zt))/zt + m4*((cos(gamma - delta)*(cos(gamma - delta)*(ea/e - 1) - sin(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) + cos(phi_minus_90deg)*((2*cos(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg)^2 - 2*ea*tan(beta + theta - gamma)/ss)) - ea*sin(gamma -
    //   delta)*cos(phi_minus_90deg)/ss)/e + (cos(phi_minus_90deg)*(sin(gamma - delta) + 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
    //   delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg)
    //   + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/ss) +
    //   I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))))/cos(beta + theta - gamma)
    let tau1 = beta_rate_dot
        * (I1 + m1 * ra * ra
            + rr * rr
                * (m2
                    + cos_angle_inv
                        * (cos_angle_inv
                            * (tau1_of_place_15 * sin_theta * sin_theta
                                + i2_plus_da_m2_da * tau1_of_d_beta_gamma * tau1_of_d_beta_gamma)
                            - S::int(2) * tau1_of_place_16 * cos_theta))) - mom
        - rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * tau1_of_place_39 * (l0 - tau1_of_place_39)
                    * (-sd).mul_add(tau1_of_place_18, sc * tau1_of_place_17)
                    / (xc_sq + tau1_of_xb_xc + yc_sq + tau1_of_yb_yc
                        + sd * tau1_of_place_17.mul_add(S::int(2), sd)
                        + sc * tau1_of_place_18.mul_add(S::int(2), sc))
                    + rr_beta_rate_sq
                        * (tau1_of_place_16
                            + cos_angle_inv
                                * (rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_omega_inv_sq
                                                    * (tau1_of_place_2
                                                        * (u_2_inv
                                                            * (cos_omega_inv
                                                                * (sin_gamma_minus_epsilon
                                                                    * (zf_inv
                                                                        * (tau1_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                            - tau1_of_place_20 * tau1_of_place_5
                                                                            + sin_omega_cos_omega_inv
                                                                                * (tau1_of_place_2
                                                                                    * sin_omega_doubled.mul_add(m6_fa, -tau1_of_place_5)
                                                                                    + tau1_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                        + m6
                                                                            * tau1_of_place_4
                                                                                .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                    + tau1_of_place_2 * sin_omega
                                                                        * (tau1_of_place_2 * cos_omega_inv
                                                                            * (m6 + u_2_inv_tau1_of_place_5)
                                                                            + m6 * tau1_of_zf_fa_2 * cos_gamma_minus_epsilon))
                                                                + u_2_inv * ss_inv
                                                                    * (m7 * ua_sq_plus_ub_sq)
                                                                        .mul_add(tau1_of_place_21, I7 * tau1_of_place_21)
                                                                + m6 * tau1_of_place_2 * tau1_of_place_22)
                                                            + m6
                                                                * (ss_inv
                                                                    * (tau1_of_place_21
                                                                        + sin_omega
                                                                            * (-tau1_of_place_23)
                                                                                .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon))
                                                                    - zf_inv
                                                                        * (sin_gamma_minus_epsilon
                                                                            * (tau1_of_place_22 + tau1_of_place_20 * cos_omega_inv
                                                                                + sin_omega
                                                                                    * (cos_omega_inv_sq
                                                                                        * sin_omega_doubled
                                                                                            .mul_add(tau1_of_place_22, tau1_of_place_2)
                                                                                        - tau1_of_place_23 * fa_ss_inv))
                                                                            + tau1_of_place_19 * fa_ss_inv)))
                                                        + sin_gamma_minus_epsilon
                                                            * (m6
                                                                * (zf_inv
                                                                    * (tau1_of_place_27 * (tau1_of_place_20 - tau1_of_place_26)
                                                                        + fa
                                                                            * (ss_inv
                                                                                * tau1_of_zf_fa.mul_add(tau1_of_place_24, tau1_of_place_25)
                                                                                - zf_inv_tau1_of_place_27
                                                                                    * minus_tau1_of_zf_fa
                                                                                        .mul_add(tau1_of_place_26, tau1_of_place_20)))
                                                                    - ss_inv * (tau1_of_place_24 + tau1_of_place_25))
                                                                - zf_inv_i6_zf_inv
                                                                    * tau1_of_place_26
                                                                        .mul_add(
                                                                            zf_inv_tau1_of_place_27,
                                                                            ss_inv * tau1_of_place_24,
                                                                        )))
                                                    + ss_inv * ss_inv_tau1_of_place_14 * sin_angle_cos_angle_inv
                                                    + tau1_of_place_12
                                                        * (cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-(tau1_of_place_10 * tau1_of_place_28))
                                                                    .mul_add(tau1_of_place_33, ss_inv * tau1_of_place_34)
                                                                + m4
                                                                    * (e_inv
                                                                        * (ea
                                                                            * (e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (tau1_of_place_28
                                                                                        * (-tau1_of_e_ea)
                                                                                            .mul_add(tau1_of_place_33, tau1_of_place_30)
                                                                                        + sin_angle_cos_angle_inv * ea_ss_inv)
                                                                                    + ea_ss_inv * sin_gamma_minus_delta)
                                                                                + ss_inv
                                                                                    * (-tau1_of_place_34).mul_add(S::int(2), tau1_of_place_35))
                                                                            - tau1_of_place_28 * cos_gamma_minus_delta
                                                                                * (tau1_of_place_30 + tau1_of_place_33))
                                                                        + ss_inv * (tau1_of_place_34 - tau1_of_place_35)))
                                                            - tau1_of_place_6
                                                                * (zt_inv
                                                                    * (sin_phi_minus_90deg_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (e_inv
                                                                                * (tau1_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                    - tau1_of_place_30 * tau1_of_place_11
                                                                                    + tau1_of_place_28
                                                                                        * (tau1_of_place_6
                                                                                            * tau1_of_place_7.mul_add(m4_ea, tau1_of_place_11)
                                                                                            + tau1_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                                + m4
                                                                                    * tau1_of_place_9
                                                                                        .mul_add(tau1_of_place_28, sin_gamma_minus_delta))
                                                                            + tau1_of_place_6 * cos_phi_minus_90deg
                                                                                * (tau1_of_place_6 * sin_phi_minus_90deg_inv
                                                                                    * (m4 + zt_inv_tau1_of_place_11)
                                                                                    + m4 * tau1_of_e_ea_2 * sin_gamma_minus_delta))
                                                                        - zt_inv * ss_inv
                                                                            * (m5 * ta_sq_plus_tb_sq)
                                                                                .mul_add(tau1_of_place_31, I5 * tau1_of_place_31)
                                                                        + m4 * tau1_of_place_6 * tau1_of_place_32)
                                                                    + m4
                                                                        * (ss_inv
                                                                            * (cos_phi_minus_90deg
                                                                                * tau1_of_place_23
                                                                                    .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta)
                                                                                - tau1_of_place_31)
                                                                            + e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (tau1_of_place_32
                                                                                        - tau1_of_place_30 * sin_phi_minus_90deg_inv
                                                                                        + cos_phi_minus_90deg
                                                                                            * (tau1_of_place_12
                                                                                                * tau1_of_place_7.mul_add(tau1_of_place_32, tau1_of_place_6)
                                                                                                - tau1_of_place_23 * ea_ss_inv))
                                                                                    - tau1_of_place_29 * ea_ss_inv)))))
                                                - tau1_of_place_15 * tau1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            - tau1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (tau1_of_place_13
                                                        + ss_inv * m2_da.mul_add(sin_angle, tau1_of_place_14))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - tau1_of_place_36)))
                                        + m2_da * d_inv
                                            * (-tau1_of_d_beta_gamma)
                                                .mul_add(cos_beta_minus_gamma, ss_inv * tau1_of_place_37))
                                    + tau1_of_place_15 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * tau1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    tau1_of_place_38,
                                    rr * tau1_of_place_36 * cos_theta,
                                ) + I2 * tau1_of_place_38) - m2_da * tau1_of_place_37));
    [tau1]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 109 convolutions and 260 linear operations an order.
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
    let [beta_0, theta_0, gamma_0, delta_0, phi_minus_90deg_0, epsilon_0, omega_0,
    beta_rate_0] = series[0];
    // Shared terms.
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    let zt_inv = S::int(1) / zt;
    let e_inv_ea = ea / e;
    // ea/e - 2
    let weight_4_of_e_ea = e_inv_ea - S::int(2);
    // I5 + m5*(ta^2 + tb^2)
    let weight_6_of_m5_i5_ta_tb = I5 + m5 * tb.mul_add(tb, ta * ta);
    let zf_inv_fa = fa / zf;
    // fa/zf - 2
    let weight_of_zf_fa = zf_inv_fa - S::int(2);
    // I7 + m7*(ua^2 + ub^2)
    let weight_3_of_m7_i7_ua_ub = I7 + m7 * ub.mul_add(ub, ua * ua);
    // I3 + m3*(sa^2 + sb^2)
    let weight_7_of_m3_i3_sa_sb = I3 + m3 * sb.mul_add(sb, sa * sa);
    // I2 + m2*da^2
    let i2_plus_m2_da_sq = I2 + m2 * da * da;
    // I4/e + m4*ea*(ea/e - 2)
    let weight_28_of_m4_i4_e_ea = (m4 * ea).mul_add(weight_4_of_e_ea, I4 / e);
    // m4 + (I5 + m5*(ta^2 + tb^2))/zt^2
    let weight_6_of_place = m4 + weight_6_of_m5_i5_ta_tb / (zt * zt);
    // ea/e - 1
    let weight_5_of_e_ea = e_inv_ea - S::int(1);
    let i4_e_inv2 = I4 / (e * e);
    // I6/zf + m6*fa*(fa/zf - 2)
    let weight_18_of_m6_i6_zf_fa = (m6 * fa).mul_add(weight_of_zf_fa, I6 / zf);
    // m6 + (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_3_of_place = m6 + weight_3_of_m7_i7_ua_ub / (u_2 * u_2);
    // fa/zf - 1
    let weight_2_of_zf_fa = zf_inv_fa - S::int(1);
    let i6_zf_inv2 = I6 / (zf * zf);
    let m2_d_inv_da = m2 * da / d;
    let m2_da_2 = m2 * da;
    let d_inv = S::int(1) / d;
    let weight_5_of_m4_e_ea = m4 * weight_5_of_e_ea;
    let weight_2_of_m6_zf_fa = m6 * weight_2_of_zf_fa;
    let weight_11_of_xb_xc_sc = sc * xb_minus_xc;
    let weight_12_of_yb_yc_sc = sc * yb_minus_yc;
    let weight_11_of_yb_yc_sd = sd * yb_minus_yc;
    let weight_12_of_xb_xc_sd = sd * xb_minus_xc;
    // sc*(yb - yc) + sd*(xc - xb)
    let weight_42_of_place = weight_12_of_yb_yc_sc - weight_12_of_xb_xc_sd;
    // sc*(xb - xc) + sd*(yb - yc)
    let weight_41_of_place = weight_11_of_xb_xc_sc + weight_11_of_yb_yc_sd;
    let weight_32_of_place = i2_plus_m2_da_sq / (d * ss);
    // m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight_of_m6_i6_zf_fa = m6 + i6_zf_inv2 + m6 * fa * weight_of_zf_fa / zf;
    // m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight_4_of_m4_i4_e_ea = m4 + i4_e_inv2 + m4 * ea * weight_4_of_e_ea / e;
    // m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf
    let weight_37_of_m6_i6_zf_fa = m6 + i6_zf_inv2 + m6 * fa * fa / (zf * zf)
        - S::int(2) * m6 * fa / zf;
    let m4_ea_by_e_minus_1_by_ss_of_m4_e_ea_ss = m4 * weight_5_of_e_ea / ss;
    // m4 + I4/e^2 + m4*ea^2/e^2 - 2*m4*ea/e
    let weight_35_of_m4_i4_e_ea = m4 + i4_e_inv2 + m4 * ea * ea / (e * e) - S::int(2) * m4 * ea / e;
    let weight_19_of_m6_zf_fa = m6 * weight_2_of_zf_fa / zf;
    let weight_29_of_m4_e_ea = m4 * weight_5_of_e_ea / e;
    // Constant in time.
    // weight = m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight = weight_of_m6_i6_zf_fa;
    // weight_2 = 2*m6*(fa/zf - 1)
    let weight_2 = S::int(2) * weight_2_of_m6_zf_fa;
    // weight_3 = m6 + (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_3 = weight_3_of_place;
    // weight_4 = m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight_4 = weight_4_of_m4_i4_e_ea;
    // weight_5 = 2*m4*(ea/e - 1)
    let weight_5 = S::int(2) * weight_5_of_m4_e_ea;
    // weight_6 = m4 + (I5 + m5*(ta^2 + tb^2))/zt^2
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
    // weight_13 = 1/u
    let weight_13 = S::int(1) / u_2;
    // minus_1_by_zf = -1/zf
    let minus_1_by_zf = -S::int(1) / zf;
    // m6_fa_by_zf_minus_1 = m6*(fa/zf - 1)
    let m6_fa_by_zf_minus_1 = weight_2_of_m6_zf_fa;
    // m4_ea_by_e_minus_1 = m4*(ea/e - 1)
    let m4_ea_by_e_minus_1 = weight_5_of_m4_e_ea;
    // weight_14 = 1/e
    let weight_14 = S::int(1) / e;
    // weight_15 = 1/zt
    let weight_15 = zt_inv;
    // weight_16 = m6/zf + (I7 + m7*(ua^2 + ub^2))/(u^2*zf)
    let weight_16 = m6 / zf + weight_3_of_m7_i7_ua_ub / (u_2 * u_2 * zf);
    // weight_17 = 2*m6*(1 - fa/zf)/u
    let weight_17 = -S::int(2) * m6 * weight_2_of_zf_fa / u_2;
    // weight_18 = m6/u + (I6/zf + m6*fa*(fa/zf - 2))/(u*zf)
    let weight_18 = m6 / u_2 + weight_18_of_m6_i6_zf_fa / (u_2 * zf);
    // weight_19 = 2*m6*(1 - fa/zf)/zf
    let weight_19 = -S::int(2) * weight_19_of_m6_zf_fa;
    // weight_20 = (m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf)/zf
    let weight_20 = weight_of_m6_i6_zf_fa / zf;
    // weight_21 = m6*(fa/zf - 1)/zf
    let weight_21 = weight_19_of_m6_zf_fa;
    // weight_22 = (m6 + (I6/zf + m6*fa*(fa/zf - 2))/zf)/u
    let weight_22 = (m6 + weight_18_of_m6_i6_zf_fa / zf) / u_2;
    // weight_23 = -(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/zf
    let weight_23 = -weight_3_of_place / zf;
    // weight_24 = (m6 + I7/u^2 + m7*ua^2/u^2 + m7*ub^2/u^2)/ss
    let weight_24 = (m6 + I7 / (u_2 * u_2) + m7 * ua * ua / (u_2 * u_2)
        + m7 * ub * ub / (u_2 * u_2)) / ss;
    // weight_25 = m6*(1 - fa/zf)/ss
    let weight_25 = -m6 * weight_2_of_zf_fa / ss;
    // weight_26 = m4/e + (I5 + m5*(ta^2 + tb^2))/(e*zt^2)
    let weight_26 = m4 / e + weight_6_of_m5_i5_ta_tb / (e * zt * zt);
    // weight_27 = 2*m4*(ea/e - 1)/zt
    let weight_27 = S::int(2) * m4 * weight_5_of_e_ea / zt;
    // weight_28 = m4/zt + (I4/e + m4*ea*(ea/e - 2))/(e*zt)
    let weight_28 = m4 / zt + weight_28_of_m4_i4_e_ea / (e * zt);
    // weight_29 = 2*m4*(ea/e - 1)/e
    let weight_29 = S::int(2) * weight_29_of_m4_e_ea;
    // weight_30 = (m4 + I4/e^2 + m4*ea*(ea/e - 2)/e)/e
    let weight_30 = weight_4_of_m4_i4_e_ea / e;
    // m4_1_minus_ea_by_e_by_e = m4*(1 - ea/e)/e
    let m4_1_minus_ea_by_e_by_e = -weight_29_of_m4_e_ea;
    // weight_31 = (m4 + I5/zt^2 + m5*ta^2/zt^2 + m5*tb^2/zt^2)/ss
    let weight_31 = (m4 + I5 / (zt * zt) + m5 * ta * ta / (zt * zt)
        + m5 * tb * tb / (zt * zt)) / ss;
    // minus_1_by_zt = -1/zt
    let minus_1_by_zt = -zt_inv;
    // m4_ea_by_e_minus_1_by_ss = m4*(ea/e - 1)/ss
    let m4_ea_by_e_minus_1_by_ss = m4_ea_by_e_minus_1_by_ss_of_m4_e_ea_ss;
    // m2_da_by_ss = m2*da/ss
    let m2_da_by_ss = m2 * da / ss;
    // weight_32 = -(I2 + m2*da^2)/(d*ss)
    let weight_32 = -weight_32_of_place;
    // i2_plus_m2_da_2_by_d_ss = (I2 + m2*da^2)/(d*ss)
    let i2_plus_m2_da_2_by_d_ss = weight_32_of_place;
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
    // weight_33 = (m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/e
    let weight_33 = weight_6_of_place / e;
    // weight_34 = -(m4 + (I4/e + m4*ea*(ea/e - 2))/e)/zt
    let weight_34 = -(m4 + weight_28_of_m4_i4_e_ea / e) / zt;
    // weight_35 = m4 + I4/e^2 + m4*ea^2/e^2 - 2*m4*ea/e
    let weight_35 = weight_35_of_m4_i4_e_ea;
    // minus_1_by_ss = -1/ss
    let minus_1_by_ss = -S::int(1) / ss;
    // weight_36 = (2*m4*ea/e - m4 - I4/e^2 - m4*ea^2/e^2)/ss
    let weight_36 = -weight_35_of_m4_i4_e_ea / ss;
    // m4_1_minus_ea_by_e_by_ss = m4*(1 - ea/e)/ss
    let m4_1_minus_ea_by_e_by_ss = -m4_ea_by_e_minus_1_by_ss_of_m4_e_ea_ss;
    // weight_37 = m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf
    let weight_37 = weight_37_of_m6_i6_zf_fa;
    // weight_38 = (m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf)/ss
    let weight_38 = weight_37_of_m6_i6_zf_fa / ss;
    // m6_1_minus_fa_by_zf = m6*(1 - fa/zf)
    let m6_1_minus_fa_by_zf = -weight_2_of_m6_zf_fa;
    // weight_39 = (I3 + m3*(sa^2 + sb^2))/ss^3
    let weight_39 = weight_7_of_m3_i3_sa_sb / (ss * ss * ss);
    // weight_40 = 1/d
    let weight_40 = d_inv;
    // m2_da_rr_by_d_2 = m2*da*rr/d^2
    let m2_da_rr_by_d_2 = m2 * da * rr / (d * d);
    // m2_da_by_d = m2*da/d
    let m2_da_by_d = m2_d_inv_da;
    // weight_41 = sc*(xb - xc) + sd*(yb - yc)
    let weight_41 = weight_41_of_place;
    // weight_42 = sc*(yb - yc) + sd*(xc - xb)
    let weight_42 = weight_42_of_place;
    // weight_43 = -l0*(sc*(xb - xc) + sd*(yb - yc))
    let weight_43 = -l0 * weight_41_of_place;
    // weight_44 = -l0*(sc*(yb - yc) + sd*(xc - xb))
    let weight_44 = -l0 * weight_42_of_place;
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
    let (sin_omega_0, cos_omega_0) = omega_0.sin_cos();
    let over_cos_omega = S::int(1) / cos_omega_0;
    let beta_minus_gamma_0 = beta_0 - gamma_0;
    let d1_of_place_0 = beta_0 + theta_0 - gamma_0;
    let (sin_angle_0, cos_angle_0) = d1_of_place_0.sin_cos();
    let over_cos_angle = S::int(1) / cos_angle_0;
    let (sin_beta_minus_gamma_0, cos_beta_minus_gamma_0) = beta_minus_gamma_0.sin_cos();
    let gamma_minus_delta_0 = gamma_0 - delta_0;
    let (sin_gamma_minus_delta_0, cos_gamma_minus_delta_0) = gamma_minus_delta_0
        .sin_cos();
    let d1_of_place_2_0 = gamma_0 - epsilon_0 - omega_0;
    let (sin_angle_2_0, cos_angle_2_0) = d1_of_place_2_0.sin_cos();
    let gamma_minus_epsilon_0 = gamma_0 - epsilon_0;
    let (sin_gamma_minus_epsilon_0, cos_gamma_minus_epsilon_0) = gamma_minus_epsilon_0
        .sin_cos();
    let cos_beta_minus_gamma_sq_0 = cos_beta_minus_gamma_0 * cos_beta_minus_gamma_0;
    let d1_of_place_3_0 = cos_theta_0 * cos_beta_minus_gamma_0;
    let (sin_phi_minus_90deg_0, cos_phi_minus_90deg_0) = phi_minus_90deg_0.sin_cos();
    let over_sin_phi_minus_90deg = S::int(1) / sin_phi_minus_90deg_0;
    let d1_of_place_4_0 = gamma_0 - delta_0 - phi_minus_90deg_0;
    let (sin_angle_3_0, cos_angle_3_0) = d1_of_place_4_0.sin_cos();
    let sin_omega_cos_angle_2_0 = sin_omega_0 * cos_angle_2_0;
    let d1_of_place_5_0 = sin_omega_cos_angle_2_0
        .mul_add(weight_2, weight * sin_gamma_minus_epsilon_0);
    let d1_of_place_6_0 = sin_gamma_minus_epsilon_0 * d1_of_place_5_0;
    let cos_angle_2_sq_0 = cos_angle_2_0 * cos_angle_2_0;
    let d1_of_place_7_0 = weight_3 * cos_angle_2_sq_0 + d1_of_place_6_0;
    let cos_omega_sq_0 = cos_omega_0 * cos_omega_0;
    let over_cos_omega_sq = S::int(1) / cos_omega_sq_0;
    let d1_of_place_8_0 = d1_of_place_7_0 * over_cos_omega_sq;
    let d1_of_place_9_0 = cos_phi_minus_90deg_0 * cos_angle_3_0;
    let d1_of_place_10_0 = d1_of_place_9_0
        .mul_add(weight_5, weight_4 * cos_gamma_minus_delta_0);
    let d1_of_place_11_0 = cos_gamma_minus_delta_0 * d1_of_place_10_0;
    let cos_angle_3_sq_0 = cos_angle_3_0 * cos_angle_3_0;
    let d1_of_place_12_0 = weight_6 * cos_angle_3_sq_0 + d1_of_place_11_0;
    let sin_phi_minus_90deg_sq_0 = sin_phi_minus_90deg_0 * sin_phi_minus_90deg_0;
    let over_sin_phi_minus_90deg_sq = S::int(1) / sin_phi_minus_90deg_sq_0;
    let d1_of_place_13_0 = d1_of_place_12_0 * over_sin_phi_minus_90deg_sq;
    let d1_of_place_14_0 = weight_7 + d1_of_place_8_0 + d1_of_place_13_0;
    let sin_theta_sq_0 = sin_theta_0 * sin_theta_0;
    let d1_of_place_15_0 = d1_of_place_14_0 * sin_theta_sq_0;
    let d1_of_place_16_0 = i2_plus_m2_da_2_by_d_2 * cos_beta_minus_gamma_sq_0 + d1_of_place_15_0;
    let d1_of_place_17_0 = d1_of_place_16_0 * over_cos_angle;
    let d1_of_place_18_0 = weight_8 * d1_of_place_3_0 - d1_of_place_17_0;
    let d1_of_place_19_0 = d1_of_place_18_0 * over_cos_angle;
    let d1_of_place_20_0 = d1_of_place_19_0.mul_add(minus_rr_2, weight_9);
    let over_d1_of_place_20 = S::int(1) / d1_of_place_20_0;
    let (sin_gamma_0, cos_gamma_0) = gamma_0.sin_cos();
    let beta_rate_dot_of_place_0 = cos_gamma_0
        .mul_add(weight_12, sin_gamma_0.mul_add(weight_11, weight_10));
    let over_beta_rate_dot_of_place = S::int(1) / beta_rate_dot_of_place_0;
    let beta_rate_dot_of_place_2_0 = beta_rate_dot_of_place_0.sqrt();
    let over_twice_beta_rate_dot_of_place_2 = S::int(1)
        / (beta_rate_dot_of_place_2_0 + beta_rate_dot_of_place_2_0);
    let beta_rate_dot_of_place_3_0 = sin_gamma_minus_epsilon_0
        .mul_add(minus_1_by_zf, weight_13 * cos_angle_2_0);
    let beta_rate_dot_of_place_4_0 = cos_angle_2_0 * over_cos_omega;
    let beta_rate_dot_of_place_5_0 = beta_rate_dot_of_place_4_0
        .mul_add(weight_3, m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon_0);
    let sin_angle_cos_angle_inv_0 = sin_angle_0 * over_cos_angle;
    let beta_rate_dot_of_place_6_0 = cos_theta_0 * sin_beta_minus_gamma_0;
    let beta_rate_dot_of_place_7_0 = cos_angle_3_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_8_0 = beta_rate_dot_of_place_7_0
        .mul_add(weight_6, m4_ea_by_e_minus_1 * sin_gamma_minus_delta_0);
    let beta_rate_dot_of_place_9_0 = cos_angle_3_0
        .mul_add(weight_15, weight_14 * cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_10_0 = sin_omega_0.mul_add(weight_17, weight_16);
    let beta_rate_dot_of_place_11_0 = cos_angle_2_0 * beta_rate_dot_of_place_10_0;
    let beta_rate_dot_of_place_12_0 = sin_omega_0.mul_add(weight_19, weight_18);
    let beta_rate_dot_of_place_13_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_12_0;
    let beta_rate_dot_of_place_14_0 = beta_rate_dot_of_place_11_0 - beta_rate_dot_of_place_13_0;
    let beta_rate_dot_of_place_15_0 = cos_angle_2_0 * beta_rate_dot_of_place_14_0;
    let beta_rate_dot_of_place_16_0 = sin_gamma_minus_epsilon_0 * sin_gamma_minus_epsilon_0;
    let beta_rate_dot_of_place_17_0 = weight_20 * beta_rate_dot_of_place_16_0
        + beta_rate_dot_of_place_15_0;
    let beta_rate_dot_of_place_18_0 = beta_rate_dot_of_place_17_0 * over_cos_omega;
    let beta_rate_dot_of_place_19_0 = sin_gamma_minus_epsilon_0 * sin_angle_2_0;
    let beta_rate_dot_of_place_20_0 = weight_21 * beta_rate_dot_of_place_19_0
        + beta_rate_dot_of_place_18_0;
    let beta_rate_dot_of_place_21_0 = sin_angle_2_0
        .mul_add(weight_23, weight_22 * cos_gamma_minus_epsilon_0);
    let sin_omega_cos_omega_inv_0 = sin_omega_0 * over_cos_omega;
    let beta_rate_dot_of_place_22_0 = beta_rate_dot_of_place_5_0 * sin_omega_cos_omega_inv_0;
    let beta_rate_dot_of_place_23_0 = beta_rate_dot_of_place_22_0
        .mul_add(weight_13, weight_24 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_24_0 = cos_angle_2_0 * beta_rate_dot_of_place_23_0;
    let beta_rate_dot_of_place_25_0 = sin_omega_0 * cos_gamma_minus_epsilon_0;
    let beta_rate_dot_of_place_26_0 = beta_rate_dot_of_place_25_0
        .mul_add(weight_25, weight_24 * sin_angle_2_0) + beta_rate_dot_of_place_24_0;
    let beta_rate_dot_of_place_27_0 = cos_angle_2_0 * beta_rate_dot_of_place_26_0;
    let beta_rate_dot_of_place_28_0 = cos_phi_minus_90deg_0
        .mul_add(weight_27, weight_26);
    let beta_rate_dot_of_place_29_0 = cos_angle_3_0 * beta_rate_dot_of_place_28_0;
    let beta_rate_dot_of_place_30_0 = cos_phi_minus_90deg_0
        .mul_add(weight_29, weight_28);
    let beta_rate_dot_of_place_31_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_30_0;
    let beta_rate_dot_of_place_32_0 = beta_rate_dot_of_place_29_0 + beta_rate_dot_of_place_31_0;
    let beta_rate_dot_of_place_33_0 = cos_angle_3_0 * beta_rate_dot_of_place_32_0;
    let cos_gamma_minus_delta_sq_0 = cos_gamma_minus_delta_0 * cos_gamma_minus_delta_0;
    let beta_rate_dot_of_place_34_0 = weight_30 * cos_gamma_minus_delta_sq_0
        + beta_rate_dot_of_place_33_0;
    let beta_rate_dot_of_place_35_0 = beta_rate_dot_of_place_34_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_36_0 = cos_gamma_minus_delta_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_37_0 = m4_1_minus_ea_by_e_by_e
        * beta_rate_dot_of_place_36_0 + beta_rate_dot_of_place_35_0;
    let beta_rate_dot_of_place_38_0 = cos_phi_minus_90deg_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_39_0 = beta_rate_dot_of_place_8_0 * beta_rate_dot_of_place_38_0;
    let beta_rate_dot_of_place_40_0 = beta_rate_dot_of_place_39_0
        .mul_add(minus_1_by_zt, weight_31 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_41_0 = cos_angle_3_0 * beta_rate_dot_of_place_40_0;
    let beta_rate_dot_of_place_42_0 = sin_gamma_minus_delta_0 * cos_phi_minus_90deg_0;
    let beta_rate_dot_of_place_43_0 = beta_rate_dot_of_place_42_0
        .mul_add(m4_ea_by_e_minus_1_by_ss, weight_31 * sin_angle_3_0) + beta_rate_dot_of_place_41_0;
    let beta_rate_dot_of_place_44_0 = cos_angle_3_0 * beta_rate_dot_of_place_43_0;
    let beta_rate_dot_of_place_45_0 = cos_beta_minus_gamma_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_46_0 = d1_of_place_14_0 * beta_rate_dot_of_place_45_0;
    let beta_rate_dot_of_place_47_0 = sin_angle_0.mul_add(m2_da_by_ss, weight_7)
        + d1_of_place_8_0 + d1_of_place_13_0;
    let beta_rate_dot_of_place_48_0 = cos_theta_0 * beta_rate_dot_of_place_47_0;
    let beta_rate_dot_of_place_49_0 = beta_rate_dot_of_place_45_0
        .mul_add(weight_32, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma_0)
        + beta_rate_dot_of_place_48_0;
    let beta_rate_dot_of_place_50_0 = cos_beta_minus_gamma_0 * beta_rate_dot_of_place_49_0;
    let beta_rate_dot_of_place_51_0 = sin_beta_minus_gamma_0
        .mul_add(m2_da_rr_by_d_ss, weight_7) + d1_of_place_8_0 + d1_of_place_13_0;
    let beta_rate_dot_of_place_52_0 = cos_theta_0 * beta_rate_dot_of_place_51_0;
    let beta_rate_dot_of_place_53_0 = cos_beta_minus_gamma_0 * over_cos_angle;
    let beta_rate_dot_of_place_54_0 = beta_rate_dot_of_place_53_0
        .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta_0);
    let beta_rate_dot_of_place_55_0 = beta_rate_dot_of_place_54_0 * beta_rate_dot_of_place_45_0;
    let beta_rate_dot_of_place_56_0 = beta_rate_dot_of_place_55_0
        .mul_add(minus_rr, i2_plus_m2_da_2 * sin_beta_minus_gamma_0);
    let beta_rate_dot_of_place_57_0 = beta_rate_dot_of_place_56_0 * beta_rate_dot_of_place_53_0;
    let beta_rate_dot_of_place_58_0 = beta_rate_dot_of_place_57_0
        .mul_add(minus_1_by_d, m2_da * beta_rate_dot_of_place_6_0);
    let beta_rate_sq_0 = beta_rate_0 * beta_rate_0;
    let beta_rate_dot_of_beta_rate_0 = beta_rate_dot_of_place_58_0 * beta_rate_sq_0;
    let beta_rate_dot_of_place_59_0 = cos_phi_minus_90deg_0 * beta_rate_dot_of_place_37_0;
    let beta_rate_dot_of_place_60_0 = sin_gamma_minus_delta_0
        .mul_add(weight_34, weight_33 * sin_angle_3_0);
    let beta_rate_dot_of_place_61_0 = cos_angle_3_0 * beta_rate_dot_of_place_60_0;
    let beta_rate_dot_of_place_62_0 = -beta_rate_dot_of_place_61_0 + beta_rate_dot_of_place_59_0;
    let beta_rate_dot_of_place_63_0 = beta_rate_dot_of_place_62_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_64_0 = d1_of_place_9_0
        .mul_add(weight_5, weight_35 * cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_65_0 = beta_rate_dot_of_place_64_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_66_0 = cos_phi_minus_90deg_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_67_0 = cos_angle_3_0 * beta_rate_dot_of_place_9_0;
    let beta_rate_dot_of_place_68_0 = beta_rate_dot_of_place_65_0
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_67_0
                .mul_add(
                    m4_ea_by_e_minus_1,
                    beta_rate_dot_of_place_66_0
                        .mul_add(
                            m4_1_minus_ea_by_e_by_ss,
                            weight_36 * sin_gamma_minus_delta_0,
                        ),
                ),
        ) + beta_rate_dot_of_place_63_0;
    let beta_rate_dot_of_place_69_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_68_0;
    let beta_rate_dot_of_place_70_0 = beta_rate_dot_of_place_44_0 - beta_rate_dot_of_place_69_0;
    let beta_rate_dot_of_place_71_0 = beta_rate_dot_of_place_70_0 * over_sin_phi_minus_90deg_sq;
    let beta_rate_dot_of_place_72_0 = sin_omega_0 * beta_rate_dot_of_place_20_0;
    let beta_rate_dot_of_place_73_0 = cos_angle_2_0 * beta_rate_dot_of_place_21_0;
    let beta_rate_dot_of_place_74_0 = -beta_rate_dot_of_place_73_0 + beta_rate_dot_of_place_72_0;
    let beta_rate_dot_of_place_75_0 = beta_rate_dot_of_place_74_0 * over_cos_omega;
    let beta_rate_dot_of_place_76_0 = sin_omega_cos_angle_2_0
        .mul_add(weight_2, weight_37 * sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_77_0 = beta_rate_dot_of_place_76_0 * sin_angle_cos_angle_inv_0;
    let sin_omega_sin_angle_2_0 = sin_omega_0 * sin_angle_2_0;
    let beta_rate_dot_of_place_78_0 = cos_angle_2_0 * beta_rate_dot_of_place_3_0;
    let beta_rate_dot_of_place_79_0 = beta_rate_dot_of_place_77_0
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_78_0
                .mul_add(
                    m6_1_minus_fa_by_zf,
                    sin_omega_sin_angle_2_0
                        .mul_add(weight_25, weight_38 * cos_gamma_minus_epsilon_0),
                ),
        ) + beta_rate_dot_of_place_75_0;
    let beta_rate_dot_of_place_80_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_79_0;
    let beta_rate_dot_of_place_81_0 = beta_rate_dot_of_place_27_0 - beta_rate_dot_of_place_80_0;
    let beta_rate_dot_of_place_82_0 = beta_rate_dot_of_place_81_0 * over_cos_omega_sq;
    let beta_rate_dot_of_place_83_0 = weight_39 * sin_angle_cos_angle_inv_0
        + beta_rate_dot_of_place_71_0 + beta_rate_dot_of_place_82_0;
    let beta_rate_dot_of_place_84_0 = sin_theta_0 * beta_rate_dot_of_place_83_0;
    let beta_rate_dot_of_place_85_0 = weight_40 * beta_rate_dot_of_place_46_0
        - beta_rate_dot_of_place_84_0;
    let beta_rate_dot_of_place_86_0 = sin_theta_0 * beta_rate_dot_of_place_85_0;
    let beta_rate_dot_of_place_87_0 = weight_40 * beta_rate_dot_of_place_50_0
        + beta_rate_dot_of_place_86_0;
    let beta_rate_dot_of_place_88_0 = beta_rate_dot_of_place_87_0 * over_cos_angle;
    let beta_rate_dot_of_place_89_0 = beta_rate_dot_of_place_88_0
        .mul_add(
            rr,
            m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq_0 - beta_rate_dot_of_place_52_0,
        );
    let beta_rate_dot_of_place_90_0 = beta_rate_dot_of_place_89_0 * over_cos_angle;
    let beta_rate_dot_of_place_91_0 = m2_da_by_d * cos_beta_minus_gamma_0
        - beta_rate_dot_of_place_90_0;
    let beta_rate_dot_of_beta_rate_2_0 = beta_rate_dot_of_place_91_0 * beta_rate_sq_0;
    let beta_rate_dot_of_place_92_0 = sin_gamma_0
        .mul_add(weight_42, weight_41 * cos_gamma_0);
    let beta_rate_dot_of_place_93_0 = beta_rate_dot_of_place_2_0 * beta_rate_dot_of_place_92_0;
    let beta_rate_dot_of_place_94_0 = sin_gamma_0
        .mul_add(weight_44, weight_43 * cos_gamma_0) + beta_rate_dot_of_place_93_0;
    let beta_rate_dot_of_place_95_0 = beta_rate_dot_of_place_2_0 * over_beta_rate_dot_of_place;
    let beta_rate_dot_of_place_96_0 = beta_rate_dot_of_place_94_0 * beta_rate_dot_of_place_95_0;
    let beta_rate_dot_of_beta_rate_3_0 = beta_rate_dot_of_beta_rate_2_0
        .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_96_0);
    let beta_rate_dot_of_beta_rate_4_0 = sin_theta_0 * beta_rate_dot_of_beta_rate_3_0;
    let beta_rate_dot_of_beta_rate_5_0 = rr_by_d * beta_rate_dot_of_beta_rate_0
        - beta_rate_dot_of_beta_rate_4_0;
    let beta_rate_dot_of_beta_rate_6_0 = beta_rate_dot_of_beta_rate_5_0 * over_cos_angle;
    let beta_rate_dot_of_beta_rate_7_0 = beta_rate_dot_of_beta_rate_6_0
        .mul_add(minus_rr, mom);
    let beta_rate_dot_2_0 = beta_rate_dot_of_beta_rate_7_0 * over_d1_of_place_20;
    let theta_of_place_0 = beta_rate_dot_of_place_53_0.mul_add(rr_by_d, -S::int(1));
    let theta_dot_2_0 = beta_rate_0 * theta_of_place_0;
    let beta_rate_sin_theta_0 = beta_rate_0 * sin_theta_0;
    let gamma_of_beta_rate_0 = beta_rate_sin_theta_0 * over_cos_angle;
    let delta_of_beta_rate_0 = gamma_of_beta_rate_0 * beta_rate_dot_of_place_7_0;
    let phi_minus_90deg_of_place_0 = beta_rate_dot_of_place_9_0 * over_sin_phi_minus_90deg;
    let phi_minus_90deg_of_beta_rate_0 = gamma_of_beta_rate_0 * phi_minus_90deg_of_place_0;
    let epsilon_of_beta_rate_0 = gamma_of_beta_rate_0 * beta_rate_dot_of_place_4_0;
    let omega_of_place_0 = beta_rate_dot_of_place_3_0 * over_cos_omega;
    let omega_of_beta_rate_0 = gamma_of_beta_rate_0 * omega_of_place_0;
    // Order 1: the rates, and what follows from them.
    let beta_1 = beta_rate_0;
    let theta_1 = theta_dot_2_0;
    let gamma_1 = rr_by_ss * gamma_of_beta_rate_0;
    let delta_1 = rr_by_zt * delta_of_beta_rate_0;
    let phi_minus_90deg_1 = minus_rr * phi_minus_90deg_of_beta_rate_0;
    let epsilon_1 = rr_by_u * epsilon_of_beta_rate_0;
    let omega_1 = minus_rr * omega_of_beta_rate_0;
    let beta_rate_1 = beta_rate_dot_2_0;
    if series.len() > 1 {
        series[1] = [
            beta_1, theta_1, gamma_1, delta_1, phi_minus_90deg_1, epsilon_1, omega_1, beta_rate_1,
        ];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let sin_omega_1 = omega_1 * cos_omega_0;
    let cos_omega_1 = -omega_1 * sin_omega_0;
    let beta_minus_gamma_1 = beta_1 - gamma_1;
    let d1_of_place_1 = beta_1 + theta_1 - gamma_1;
    let sin_angle_1 = d1_of_place_1 * cos_angle_0;
    let cos_angle_1 = -d1_of_place_1 * sin_angle_0;
    let sin_beta_minus_gamma_1 = beta_minus_gamma_1 * cos_beta_minus_gamma_0;
    let cos_beta_minus_gamma_1 = -beta_minus_gamma_1 * sin_beta_minus_gamma_0;
    let gamma_minus_delta_1 = gamma_1 - delta_1;
    let sin_gamma_minus_delta_1 = gamma_minus_delta_1 * cos_gamma_minus_delta_0;
    let cos_gamma_minus_delta_1 = -gamma_minus_delta_1 * sin_gamma_minus_delta_0;
    let d1_of_place_2_1 = gamma_1 - epsilon_1 - omega_1;
    let sin_angle_2_1 = d1_of_place_2_1 * cos_angle_2_0;
    let cos_angle_2_1 = -d1_of_place_2_1 * sin_angle_2_0;
    let gamma_minus_epsilon_1 = gamma_1 - epsilon_1;
    let sin_gamma_minus_epsilon_1 = gamma_minus_epsilon_1 * cos_gamma_minus_epsilon_0;
    let cos_gamma_minus_epsilon_1 = -gamma_minus_epsilon_1 * sin_gamma_minus_epsilon_0;
    let cos_beta_minus_gamma_sq_1 = cos_beta_minus_gamma_1
        * (cos_beta_minus_gamma_0 + cos_beta_minus_gamma_0);
    let d1_of_place_3_1 = cos_beta_minus_gamma_1
        .mul_add(cos_theta_0, cos_theta_1 * cos_beta_minus_gamma_0);
    let sin_phi_minus_90deg_1 = phi_minus_90deg_1 * cos_phi_minus_90deg_0;
    let cos_phi_minus_90deg_1 = -phi_minus_90deg_1 * sin_phi_minus_90deg_0;
    let d1_of_place_4_1 = gamma_1 - delta_1 - phi_minus_90deg_1;
    let sin_angle_3_1 = d1_of_place_4_1 * cos_angle_3_0;
    let cos_angle_3_1 = -d1_of_place_4_1 * sin_angle_3_0;
    let sin_omega_cos_angle_2_1 = cos_angle_2_1
        .mul_add(sin_omega_0, sin_omega_1 * cos_angle_2_0);
    let d1_of_place_5_1 = sin_omega_cos_angle_2_1
        .mul_add(weight_2, weight * sin_gamma_minus_epsilon_1);
    let d1_of_place_6_1 = d1_of_place_5_1
        .mul_add(sin_gamma_minus_epsilon_0, sin_gamma_minus_epsilon_1 * d1_of_place_5_0);
    let cos_angle_2_sq_1 = cos_angle_2_1 * (cos_angle_2_0 + cos_angle_2_0);
    let d1_of_place_7_1 = weight_3 * cos_angle_2_sq_1 + d1_of_place_6_1;
    let cos_omega_sq_1 = cos_omega_1 * (cos_omega_0 + cos_omega_0);
    let d1_of_place_8_1 = cos_omega_sq_1
        .mul_add(
            -(d1_of_place_8_0 * over_cos_omega_sq),
            d1_of_place_7_1 * over_cos_omega_sq,
        );
    let d1_of_place_9_1 = cos_angle_3_1
        .mul_add(cos_phi_minus_90deg_0, cos_phi_minus_90deg_1 * cos_angle_3_0);
    let d1_of_place_10_1 = d1_of_place_9_1
        .mul_add(weight_5, weight_4 * cos_gamma_minus_delta_1);
    let d1_of_place_11_1 = d1_of_place_10_1
        .mul_add(cos_gamma_minus_delta_0, cos_gamma_minus_delta_1 * d1_of_place_10_0);
    let cos_angle_3_sq_1 = cos_angle_3_1 * (cos_angle_3_0 + cos_angle_3_0);
    let d1_of_place_12_1 = weight_6 * cos_angle_3_sq_1 + d1_of_place_11_1;
    let sin_phi_minus_90deg_sq_1 = sin_phi_minus_90deg_1
        * (sin_phi_minus_90deg_0 + sin_phi_minus_90deg_0);
    let d1_of_place_13_1 = sin_phi_minus_90deg_sq_1
        .mul_add(
            -(d1_of_place_13_0 * over_sin_phi_minus_90deg_sq),
            d1_of_place_12_1 * over_sin_phi_minus_90deg_sq,
        );
    let d1_of_place_14_1 = d1_of_place_8_1 + d1_of_place_13_1;
    let sin_theta_sq_1 = sin_theta_1 * (sin_theta_0 + sin_theta_0);
    let d1_of_place_15_1 = d1_of_place_14_1
        .mul_add(sin_theta_sq_0, sin_theta_sq_1 * d1_of_place_14_0);
    let d1_of_place_16_1 = i2_plus_m2_da_2_by_d_2 * cos_beta_minus_gamma_sq_1 + d1_of_place_15_1;
    let d1_of_place_17_1 = cos_angle_1
        .mul_add(
            -(d1_of_place_17_0 * over_cos_angle),
            d1_of_place_16_1 * over_cos_angle,
        );
    let d1_of_place_18_1 = weight_8 * d1_of_place_3_1 - d1_of_place_17_1;
    let d1_of_place_19_1 = cos_angle_1
        .mul_add(
            -(d1_of_place_19_0 * over_cos_angle),
            d1_of_place_18_1 * over_cos_angle,
        );
    let d1_of_place_20_1 = minus_rr_2 * d1_of_place_19_1;
    let sin_gamma_1 = gamma_1 * cos_gamma_0;
    let cos_gamma_1 = -gamma_1 * sin_gamma_0;
    let beta_rate_dot_of_place_1 = cos_gamma_1
        .mul_add(weight_12, weight_11 * sin_gamma_1);
    let beta_rate_dot_of_place_2_1 = beta_rate_dot_of_place_1 * over_twice_beta_rate_dot_of_place_2;
    let beta_rate_dot_of_place_3_1 = sin_gamma_minus_epsilon_1
        .mul_add(minus_1_by_zf, weight_13 * cos_angle_2_1);
    let beta_rate_dot_of_place_4_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_4_0 * over_cos_omega),
            cos_angle_2_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_5_1 = beta_rate_dot_of_place_4_1
        .mul_add(weight_3, m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon_1);
    let sin_angle_cos_angle_inv_1 = cos_angle_1
        .mul_add(
            -(sin_angle_cos_angle_inv_0 * over_cos_angle),
            sin_angle_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_6_1 = sin_beta_minus_gamma_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_beta_minus_gamma_0);
    let beta_rate_dot_of_place_7_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_7_0 * over_sin_phi_minus_90deg),
            cos_angle_3_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_8_1 = beta_rate_dot_of_place_7_1
        .mul_add(weight_6, m4_ea_by_e_minus_1 * sin_gamma_minus_delta_1);
    let beta_rate_dot_of_place_9_1 = cos_angle_3_1
        .mul_add(weight_15, weight_14 * cos_gamma_minus_delta_1);
    let beta_rate_dot_of_place_10_1 = weight_17 * sin_omega_1;
    let beta_rate_dot_of_place_11_1 = beta_rate_dot_of_place_10_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_10_0);
    let beta_rate_dot_of_place_12_1 = weight_19 * sin_omega_1;
    let beta_rate_dot_of_place_13_1 = beta_rate_dot_of_place_12_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_12_0,
        );
    let beta_rate_dot_of_place_14_1 = beta_rate_dot_of_place_11_1 - beta_rate_dot_of_place_13_1;
    let beta_rate_dot_of_place_15_1 = beta_rate_dot_of_place_14_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_14_0);
    let beta_rate_dot_of_place_16_1 = sin_gamma_minus_epsilon_1
        * (sin_gamma_minus_epsilon_0 + sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_17_1 = weight_20 * beta_rate_dot_of_place_16_1
        + beta_rate_dot_of_place_15_1;
    let beta_rate_dot_of_place_18_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_18_0 * over_cos_omega),
            beta_rate_dot_of_place_17_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_19_1 = sin_angle_2_1
        .mul_add(sin_gamma_minus_epsilon_0, sin_gamma_minus_epsilon_1 * sin_angle_2_0);
    let beta_rate_dot_of_place_20_1 = weight_21 * beta_rate_dot_of_place_19_1
        + beta_rate_dot_of_place_18_1;
    let beta_rate_dot_of_place_21_1 = sin_angle_2_1
        .mul_add(weight_23, weight_22 * cos_gamma_minus_epsilon_1);
    let sin_omega_cos_omega_inv_1 = cos_omega_1
        .mul_add(
            -(sin_omega_cos_omega_inv_0 * over_cos_omega),
            sin_omega_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_22_1 = beta_rate_dot_of_place_5_1
        .mul_add(
            sin_omega_cos_omega_inv_0,
            sin_omega_cos_omega_inv_1 * beta_rate_dot_of_place_5_0,
        );
    let beta_rate_dot_of_place_23_1 = beta_rate_dot_of_place_22_1
        .mul_add(weight_13, weight_24 * sin_angle_cos_angle_inv_1);
    let beta_rate_dot_of_place_24_1 = beta_rate_dot_of_place_23_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_23_0);
    let beta_rate_dot_of_place_25_1 = cos_gamma_minus_epsilon_1
        .mul_add(sin_omega_0, sin_omega_1 * cos_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_26_1 = beta_rate_dot_of_place_25_1
        .mul_add(weight_25, weight_24 * sin_angle_2_1) + beta_rate_dot_of_place_24_1;
    let beta_rate_dot_of_place_27_1 = beta_rate_dot_of_place_26_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_26_0);
    let beta_rate_dot_of_place_28_1 = weight_27 * cos_phi_minus_90deg_1;
    let beta_rate_dot_of_place_29_1 = beta_rate_dot_of_place_28_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_28_0);
    let beta_rate_dot_of_place_30_1 = weight_29 * cos_phi_minus_90deg_1;
    let beta_rate_dot_of_place_31_1 = beta_rate_dot_of_place_30_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_30_0,
        );
    let beta_rate_dot_of_place_32_1 = beta_rate_dot_of_place_29_1 + beta_rate_dot_of_place_31_1;
    let beta_rate_dot_of_place_33_1 = beta_rate_dot_of_place_32_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_32_0);
    let cos_gamma_minus_delta_sq_1 = cos_gamma_minus_delta_1
        * (cos_gamma_minus_delta_0 + cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_34_1 = weight_30 * cos_gamma_minus_delta_sq_1
        + beta_rate_dot_of_place_33_1;
    let beta_rate_dot_of_place_35_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_35_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_34_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_36_1 = sin_angle_3_1
        .mul_add(cos_gamma_minus_delta_0, cos_gamma_minus_delta_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_37_1 = m4_1_minus_ea_by_e_by_e
        * beta_rate_dot_of_place_36_1 + beta_rate_dot_of_place_35_1;
    let beta_rate_dot_of_place_38_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_38_0 * over_sin_phi_minus_90deg),
            cos_phi_minus_90deg_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_39_1 = beta_rate_dot_of_place_8_1
        .mul_add(
            beta_rate_dot_of_place_38_0,
            beta_rate_dot_of_place_38_1 * beta_rate_dot_of_place_8_0,
        );
    let beta_rate_dot_of_place_40_1 = beta_rate_dot_of_place_39_1
        .mul_add(minus_1_by_zt, weight_31 * sin_angle_cos_angle_inv_1);
    let beta_rate_dot_of_place_41_1 = beta_rate_dot_of_place_40_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_40_0);
    let beta_rate_dot_of_place_42_1 = sin_gamma_minus_delta_1
        .mul_add(cos_phi_minus_90deg_0, cos_phi_minus_90deg_1 * sin_gamma_minus_delta_0);
    let beta_rate_dot_of_place_43_1 = beta_rate_dot_of_place_42_1
        .mul_add(m4_ea_by_e_minus_1_by_ss, weight_31 * sin_angle_3_1) + beta_rate_dot_of_place_41_1;
    let beta_rate_dot_of_place_44_1 = beta_rate_dot_of_place_43_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_43_0);
    let beta_rate_dot_of_place_45_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_46_1 = d1_of_place_14_1
        .mul_add(
            beta_rate_dot_of_place_45_0,
            beta_rate_dot_of_place_45_1 * d1_of_place_14_0,
        );
    let beta_rate_dot_of_place_47_1 = m2_da_by_ss * sin_angle_1 + d1_of_place_8_1
        + d1_of_place_13_1;
    let beta_rate_dot_of_place_48_1 = beta_rate_dot_of_place_47_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_47_0);
    let beta_rate_dot_of_place_49_1 = beta_rate_dot_of_place_45_1
        .mul_add(weight_32, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma_1)
        + beta_rate_dot_of_place_48_1;
    let beta_rate_dot_of_place_50_1 = beta_rate_dot_of_place_49_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * beta_rate_dot_of_place_49_0,
        );
    let beta_rate_dot_of_place_51_1 = m2_da_rr_by_d_ss * sin_beta_minus_gamma_1
        + d1_of_place_8_1 + d1_of_place_13_1;
    let beta_rate_dot_of_place_52_1 = beta_rate_dot_of_place_51_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_51_0);
    let beta_rate_dot_of_place_53_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_53_0 * over_cos_angle),
            cos_beta_minus_gamma_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_54_1 = beta_rate_dot_of_place_53_1
        .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta_1);
    let beta_rate_dot_of_place_55_1 = beta_rate_dot_of_place_45_1
        .mul_add(
            beta_rate_dot_of_place_54_0,
            beta_rate_dot_of_place_54_1 * beta_rate_dot_of_place_45_0,
        );
    let beta_rate_dot_of_place_56_1 = beta_rate_dot_of_place_55_1
        .mul_add(minus_rr, i2_plus_m2_da_2 * sin_beta_minus_gamma_1);
    let beta_rate_dot_of_place_57_1 = beta_rate_dot_of_place_56_1
        .mul_add(
            beta_rate_dot_of_place_53_0,
            beta_rate_dot_of_place_53_1 * beta_rate_dot_of_place_56_0,
        );
    let beta_rate_dot_of_place_58_1 = beta_rate_dot_of_place_57_1
        .mul_add(minus_1_by_d, m2_da * beta_rate_dot_of_place_6_1);
    let beta_rate_sq_1 = beta_rate_1 * (beta_rate_0 + beta_rate_0);
    let beta_rate_dot_of_beta_rate_1 = beta_rate_dot_of_place_58_1
        .mul_add(beta_rate_sq_0, beta_rate_sq_1 * beta_rate_dot_of_place_58_0);
    let beta_rate_dot_of_place_59_1 = beta_rate_dot_of_place_37_1
        .mul_add(
            cos_phi_minus_90deg_0,
            cos_phi_minus_90deg_1 * beta_rate_dot_of_place_37_0,
        );
    let beta_rate_dot_of_place_60_1 = sin_gamma_minus_delta_1
        .mul_add(weight_34, weight_33 * sin_angle_3_1);
    let beta_rate_dot_of_place_61_1 = beta_rate_dot_of_place_60_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_60_0);
    let beta_rate_dot_of_place_62_1 = -beta_rate_dot_of_place_61_1 + beta_rate_dot_of_place_59_1;
    let beta_rate_dot_of_place_63_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_63_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_62_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_64_1 = d1_of_place_9_1
        .mul_add(weight_5, weight_35 * cos_gamma_minus_delta_1);
    let beta_rate_dot_of_place_65_1 = beta_rate_dot_of_place_64_1
        .mul_add(
            sin_angle_cos_angle_inv_0,
            sin_angle_cos_angle_inv_1 * beta_rate_dot_of_place_64_0,
        );
    let beta_rate_dot_of_place_66_1 = sin_angle_3_1
        .mul_add(cos_phi_minus_90deg_0, cos_phi_minus_90deg_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_67_1 = beta_rate_dot_of_place_9_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_9_0);
    let beta_rate_dot_of_place_68_1 = beta_rate_dot_of_place_65_1
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_67_1
                .mul_add(
                    m4_ea_by_e_minus_1,
                    beta_rate_dot_of_place_66_1
                        .mul_add(
                            m4_1_minus_ea_by_e_by_ss,
                            weight_36 * sin_gamma_minus_delta_1,
                        ),
                ),
        ) + beta_rate_dot_of_place_63_1;
    let beta_rate_dot_of_place_69_1 = beta_rate_dot_of_place_68_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_68_0,
        );
    let beta_rate_dot_of_place_70_1 = beta_rate_dot_of_place_44_1 - beta_rate_dot_of_place_69_1;
    let beta_rate_dot_of_place_71_1 = sin_phi_minus_90deg_sq_1
        .mul_add(
            -(beta_rate_dot_of_place_71_0 * over_sin_phi_minus_90deg_sq),
            beta_rate_dot_of_place_70_1 * over_sin_phi_minus_90deg_sq,
        );
    let beta_rate_dot_of_place_72_1 = beta_rate_dot_of_place_20_1
        .mul_add(sin_omega_0, sin_omega_1 * beta_rate_dot_of_place_20_0);
    let beta_rate_dot_of_place_73_1 = beta_rate_dot_of_place_21_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_21_0);
    let beta_rate_dot_of_place_74_1 = -beta_rate_dot_of_place_73_1 + beta_rate_dot_of_place_72_1;
    let beta_rate_dot_of_place_75_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_75_0 * over_cos_omega),
            beta_rate_dot_of_place_74_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_76_1 = sin_omega_cos_angle_2_1
        .mul_add(weight_2, weight_37 * sin_gamma_minus_epsilon_1);
    let beta_rate_dot_of_place_77_1 = beta_rate_dot_of_place_76_1
        .mul_add(
            sin_angle_cos_angle_inv_0,
            sin_angle_cos_angle_inv_1 * beta_rate_dot_of_place_76_0,
        );
    let sin_omega_sin_angle_2_1 = sin_angle_2_1
        .mul_add(sin_omega_0, sin_omega_1 * sin_angle_2_0);
    let beta_rate_dot_of_place_78_1 = beta_rate_dot_of_place_3_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_3_0);
    let beta_rate_dot_of_place_79_1 = beta_rate_dot_of_place_77_1
        .mul_add(
            minus_1_by_ss,
            beta_rate_dot_of_place_78_1
                .mul_add(
                    m6_1_minus_fa_by_zf,
                    sin_omega_sin_angle_2_1
                        .mul_add(weight_25, weight_38 * cos_gamma_minus_epsilon_1),
                ),
        ) + beta_rate_dot_of_place_75_1;
    let beta_rate_dot_of_place_80_1 = beta_rate_dot_of_place_79_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_79_0,
        );
    let beta_rate_dot_of_place_81_1 = beta_rate_dot_of_place_27_1 - beta_rate_dot_of_place_80_1;
    let beta_rate_dot_of_place_82_1 = cos_omega_sq_1
        .mul_add(
            -(beta_rate_dot_of_place_82_0 * over_cos_omega_sq),
            beta_rate_dot_of_place_81_1 * over_cos_omega_sq,
        );
    let beta_rate_dot_of_place_83_1 = weight_39 * sin_angle_cos_angle_inv_1
        + beta_rate_dot_of_place_71_1 + beta_rate_dot_of_place_82_1;
    let beta_rate_dot_of_place_84_1 = beta_rate_dot_of_place_83_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_83_0);
    let beta_rate_dot_of_place_85_1 = weight_40 * beta_rate_dot_of_place_46_1
        - beta_rate_dot_of_place_84_1;
    let beta_rate_dot_of_place_86_1 = beta_rate_dot_of_place_85_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_85_0);
    let beta_rate_dot_of_place_87_1 = weight_40 * beta_rate_dot_of_place_50_1
        + beta_rate_dot_of_place_86_1;
    let beta_rate_dot_of_place_88_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_88_0 * over_cos_angle),
            beta_rate_dot_of_place_87_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_89_1 = beta_rate_dot_of_place_88_1
        .mul_add(
            rr,
            m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq_1 - beta_rate_dot_of_place_52_1,
        );
    let beta_rate_dot_of_place_90_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_90_0 * over_cos_angle),
            beta_rate_dot_of_place_89_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_91_1 = m2_da_by_d * cos_beta_minus_gamma_1
        - beta_rate_dot_of_place_90_1;
    let beta_rate_dot_of_beta_rate_2_1 = beta_rate_dot_of_place_91_1
        .mul_add(beta_rate_sq_0, beta_rate_sq_1 * beta_rate_dot_of_place_91_0);
    let beta_rate_dot_of_place_92_1 = sin_gamma_1
        .mul_add(weight_42, weight_41 * cos_gamma_1);
    let beta_rate_dot_of_place_93_1 = beta_rate_dot_of_place_2_1
        .mul_add(
            beta_rate_dot_of_place_92_0,
            beta_rate_dot_of_place_92_1 * beta_rate_dot_of_place_2_0,
        );
    let beta_rate_dot_of_place_94_1 = sin_gamma_1
        .mul_add(weight_44, weight_43 * cos_gamma_1) + beta_rate_dot_of_place_93_1;
    let beta_rate_dot_of_place_95_1 = beta_rate_dot_of_place_1
        .mul_add(
            -(beta_rate_dot_of_place_95_0 * over_beta_rate_dot_of_place),
            beta_rate_dot_of_place_2_1 * over_beta_rate_dot_of_place,
        );
    let beta_rate_dot_of_place_96_1 = beta_rate_dot_of_place_94_1
        .mul_add(
            beta_rate_dot_of_place_95_0,
            beta_rate_dot_of_place_95_1 * beta_rate_dot_of_place_94_0,
        );
    let beta_rate_dot_of_beta_rate_3_1 = beta_rate_dot_of_beta_rate_2_1
        .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_96_1);
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
    let beta_rate_dot_2_1 = d1_of_place_20_1
        .mul_add(
            -(beta_rate_dot_2_0 * over_d1_of_place_20),
            beta_rate_dot_of_beta_rate_7_1 * over_d1_of_place_20,
        );
    let theta_of_place_1 = rr_by_d * beta_rate_dot_of_place_53_1;
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
            beta_rate_dot_of_place_7_0,
            beta_rate_dot_of_place_7_1 * gamma_of_beta_rate_0,
        );
    let phi_minus_90deg_of_place_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(phi_minus_90deg_of_place_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_9_1 * over_sin_phi_minus_90deg,
        );
    let phi_minus_90deg_of_beta_rate_1 = phi_minus_90deg_of_place_1
        .mul_add(
            gamma_of_beta_rate_0,
            gamma_of_beta_rate_1 * phi_minus_90deg_of_place_0,
        );
    let epsilon_of_beta_rate_1 = gamma_of_beta_rate_1
        .mul_add(
            beta_rate_dot_of_place_4_0,
            beta_rate_dot_of_place_4_1 * gamma_of_beta_rate_0,
        );
    let omega_of_place_1 = cos_omega_1
        .mul_add(
            -(omega_of_place_0 * over_cos_omega),
            beta_rate_dot_of_place_3_1 * over_cos_omega,
        );
    let omega_of_beta_rate_1 = omega_of_place_1
        .mul_add(gamma_of_beta_rate_0, gamma_of_beta_rate_1 * omega_of_place_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, omega_1, omega_1, d1_of_place_1, d1_of_place_1,
                beta_minus_gamma_1, beta_minus_gamma_1, gamma_minus_delta_1, gamma_minus_delta_1,
                d1_of_place_2_1, d1_of_place_2_1, gamma_minus_epsilon_1, gamma_minus_epsilon_1,
                cos_beta_minus_gamma_1, cos_theta_1, phi_minus_90deg_1, phi_minus_90deg_1,
                d1_of_place_4_1, d1_of_place_4_1, sin_omega_1, sin_gamma_minus_epsilon_1,
                cos_angle_2_1, cos_omega_1, cos_omega_sq_1, cos_phi_minus_90deg_1,
                cos_gamma_minus_delta_1, cos_angle_3_1, sin_phi_minus_90deg_1,
                sin_phi_minus_90deg_sq_1, sin_theta_1, d1_of_place_14_1, cos_angle_1, cos_angle_1,
                gamma_1, gamma_1, beta_rate_dot_of_place_2_1, cos_omega_1, cos_angle_1, cos_theta_1,
                sin_phi_minus_90deg_1, cos_angle_2_1, sin_gamma_minus_epsilon_1, cos_angle_2_1,
                sin_gamma_minus_epsilon_1, cos_omega_1, sin_gamma_minus_epsilon_1, cos_omega_1,
                beta_rate_dot_of_place_5_1, cos_angle_2_1, sin_omega_1, cos_angle_2_1,
                cos_angle_3_1, cos_gamma_minus_delta_1, cos_angle_3_1, cos_gamma_minus_delta_1,
                sin_phi_minus_90deg_1, cos_gamma_minus_delta_1, sin_phi_minus_90deg_1,
                beta_rate_dot_of_place_8_1, cos_angle_3_1, sin_gamma_minus_delta_1, cos_angle_3_1,
                cos_beta_minus_gamma_1, d1_of_place_14_1, cos_theta_1, cos_beta_minus_gamma_1,
                cos_theta_1, cos_angle_1, beta_rate_dot_of_place_54_1, beta_rate_dot_of_place_56_1,
                beta_rate_1, beta_rate_dot_of_place_58_1, cos_phi_minus_90deg_1, cos_angle_3_1,
                sin_phi_minus_90deg_1, beta_rate_dot_of_place_64_1, cos_phi_minus_90deg_1,
                cos_angle_3_1, cos_gamma_minus_delta_1, sin_phi_minus_90deg_sq_1, sin_omega_1,
                cos_angle_2_1, cos_omega_1, beta_rate_dot_of_place_76_1, sin_omega_1, cos_angle_2_1,
                sin_gamma_minus_epsilon_1, cos_omega_sq_1, sin_theta_1, sin_theta_1, cos_angle_1,
                cos_angle_1, beta_rate_dot_of_place_91_1, beta_rate_dot_of_place_2_1,
                beta_rate_dot_of_place_1, beta_rate_dot_of_place_94_1, sin_theta_1, cos_angle_1,
                d1_of_place_20_1, beta_rate_1, beta_rate_1, cos_angle_1, gamma_of_beta_rate_1,
                sin_phi_minus_90deg_1, gamma_of_beta_rate_1, gamma_of_beta_rate_1, cos_omega_1,
                gamma_of_beta_rate_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, cos_omega_1, sin_omega_1, cos_angle_1, sin_angle_1,
                cos_beta_minus_gamma_1, sin_beta_minus_gamma_1, cos_gamma_minus_delta_1,
                sin_gamma_minus_delta_1, cos_angle_2_1, sin_angle_2_1, cos_gamma_minus_epsilon_1,
                sin_gamma_minus_epsilon_1, cos_beta_minus_gamma_1, cos_beta_minus_gamma_1,
                cos_phi_minus_90deg_1, sin_phi_minus_90deg_1, cos_angle_3_1, sin_angle_3_1,
                cos_angle_2_1, d1_of_place_5_1, cos_angle_2_1, cos_omega_1, d1_of_place_8_1,
                cos_angle_3_1, d1_of_place_10_1, cos_angle_3_1, sin_phi_minus_90deg_1,
                d1_of_place_13_1, sin_theta_1, sin_theta_sq_1, d1_of_place_17_1, d1_of_place_19_1,
                cos_gamma_1, sin_gamma_1, beta_rate_dot_of_place_2_1, beta_rate_dot_of_place_4_1,
                sin_angle_cos_angle_inv_1, sin_beta_minus_gamma_1, beta_rate_dot_of_place_7_1,
                beta_rate_dot_of_place_10_1, beta_rate_dot_of_place_12_1,
                beta_rate_dot_of_place_14_1, sin_gamma_minus_epsilon_1, beta_rate_dot_of_place_18_1,
                sin_angle_2_1, sin_omega_cos_omega_inv_1, sin_omega_cos_omega_inv_1,
                beta_rate_dot_of_place_23_1, cos_gamma_minus_epsilon_1, beta_rate_dot_of_place_26_1,
                beta_rate_dot_of_place_28_1, beta_rate_dot_of_place_30_1,
                beta_rate_dot_of_place_32_1, cos_gamma_minus_delta_1, beta_rate_dot_of_place_35_1,
                sin_angle_3_1, beta_rate_dot_of_place_38_1, beta_rate_dot_of_place_38_1,
                beta_rate_dot_of_place_40_1, cos_phi_minus_90deg_1, beta_rate_dot_of_place_43_1,
                sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_45_1, beta_rate_dot_of_place_47_1,
                beta_rate_dot_of_place_49_1, beta_rate_dot_of_place_51_1,
                beta_rate_dot_of_place_53_1, beta_rate_dot_of_place_45_1,
                beta_rate_dot_of_place_53_1, beta_rate_1, beta_rate_sq_1,
                beta_rate_dot_of_place_37_1, beta_rate_dot_of_place_60_1,
                beta_rate_dot_of_place_63_1, sin_angle_cos_angle_inv_1, sin_angle_3_1,
                beta_rate_dot_of_place_9_1, beta_rate_dot_of_place_68_1,
                beta_rate_dot_of_place_71_1, beta_rate_dot_of_place_20_1,
                beta_rate_dot_of_place_21_1, beta_rate_dot_of_place_75_1, sin_angle_cos_angle_inv_1,
                sin_angle_2_1, beta_rate_dot_of_place_3_1, beta_rate_dot_of_place_79_1,
                beta_rate_dot_of_place_82_1, beta_rate_dot_of_place_83_1,
                beta_rate_dot_of_place_85_1, beta_rate_dot_of_place_88_1,
                beta_rate_dot_of_place_90_1, beta_rate_sq_1, beta_rate_dot_of_place_92_1,
                beta_rate_dot_of_place_95_1, beta_rate_dot_of_place_95_1,
                beta_rate_dot_of_beta_rate_3_1, beta_rate_dot_of_beta_rate_6_1, beta_rate_dot_2_1,
                theta_of_place_1, sin_theta_1, gamma_of_beta_rate_1, beta_rate_dot_of_place_7_1,
                phi_minus_90deg_of_place_1, phi_minus_90deg_of_place_1, beta_rate_dot_of_place_4_1,
                omega_of_place_1, omega_of_place_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut gamma_last = gamma_1;
    let mut phi_minus_90deg_last = phi_minus_90deg_1;
    let mut omega_last = omega_1;
    let mut beta_rate_last = beta_rate_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut sin_omega_last = sin_omega_1;
    let mut cos_omega_last = cos_omega_1;
    let mut beta_minus_gamma_last = beta_minus_gamma_1;
    let mut d1_of_place_last = d1_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_beta_minus_gamma_last = sin_beta_minus_gamma_1;
    let mut cos_beta_minus_gamma_last = cos_beta_minus_gamma_1;
    let mut gamma_minus_delta_last = gamma_minus_delta_1;
    let mut sin_gamma_minus_delta_last = sin_gamma_minus_delta_1;
    let mut cos_gamma_minus_delta_last = cos_gamma_minus_delta_1;
    let mut d1_of_place_2_last = d1_of_place_2_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut gamma_minus_epsilon_last = gamma_minus_epsilon_1;
    let mut sin_gamma_minus_epsilon_last = sin_gamma_minus_epsilon_1;
    let mut cos_gamma_minus_epsilon_last = cos_gamma_minus_epsilon_1;
    let mut sin_phi_minus_90deg_last = sin_phi_minus_90deg_1;
    let mut cos_phi_minus_90deg_last = cos_phi_minus_90deg_1;
    let mut d1_of_place_4_last = d1_of_place_4_1;
    let mut sin_angle_3_last = sin_angle_3_1;
    let mut cos_angle_3_last = cos_angle_3_1;
    let mut d1_of_place_5_last = d1_of_place_5_1;
    let mut cos_omega_sq_last = cos_omega_sq_1;
    let mut d1_of_place_8_last = d1_of_place_8_1;
    let mut d1_of_place_10_last = d1_of_place_10_1;
    let mut sin_phi_minus_90deg_sq_last = sin_phi_minus_90deg_sq_1;
    let mut d1_of_place_13_last = d1_of_place_13_1;
    let mut d1_of_place_14_last = d1_of_place_14_1;
    let mut sin_theta_sq_last = sin_theta_sq_1;
    let mut d1_of_place_17_last = d1_of_place_17_1;
    let mut d1_of_place_19_last = d1_of_place_19_1;
    let mut d1_of_place_20_last = d1_of_place_20_1;
    let mut sin_gamma_last = sin_gamma_1;
    let mut cos_gamma_last = cos_gamma_1;
    let mut beta_rate_dot_of_place_last = beta_rate_dot_of_place_1;
    let mut beta_rate_dot_of_place_2_last = beta_rate_dot_of_place_2_1;
    let mut beta_rate_dot_of_place_3_last = beta_rate_dot_of_place_3_1;
    let mut beta_rate_dot_of_place_4_last = beta_rate_dot_of_place_4_1;
    let mut beta_rate_dot_of_place_5_last = beta_rate_dot_of_place_5_1;
    let mut sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv_1;
    let mut beta_rate_dot_of_place_7_last = beta_rate_dot_of_place_7_1;
    let mut beta_rate_dot_of_place_8_last = beta_rate_dot_of_place_8_1;
    let mut beta_rate_dot_of_place_9_last = beta_rate_dot_of_place_9_1;
    let mut beta_rate_dot_of_place_10_last = beta_rate_dot_of_place_10_1;
    let mut beta_rate_dot_of_place_12_last = beta_rate_dot_of_place_12_1;
    let mut beta_rate_dot_of_place_14_last = beta_rate_dot_of_place_14_1;
    let mut beta_rate_dot_of_place_18_last = beta_rate_dot_of_place_18_1;
    let mut beta_rate_dot_of_place_20_last = beta_rate_dot_of_place_20_1;
    let mut beta_rate_dot_of_place_21_last = beta_rate_dot_of_place_21_1;
    let mut sin_omega_cos_omega_inv_last = sin_omega_cos_omega_inv_1;
    let mut beta_rate_dot_of_place_23_last = beta_rate_dot_of_place_23_1;
    let mut beta_rate_dot_of_place_26_last = beta_rate_dot_of_place_26_1;
    let mut beta_rate_dot_of_place_28_last = beta_rate_dot_of_place_28_1;
    let mut beta_rate_dot_of_place_30_last = beta_rate_dot_of_place_30_1;
    let mut beta_rate_dot_of_place_32_last = beta_rate_dot_of_place_32_1;
    let mut beta_rate_dot_of_place_35_last = beta_rate_dot_of_place_35_1;
    let mut beta_rate_dot_of_place_37_last = beta_rate_dot_of_place_37_1;
    let mut beta_rate_dot_of_place_38_last = beta_rate_dot_of_place_38_1;
    let mut beta_rate_dot_of_place_40_last = beta_rate_dot_of_place_40_1;
    let mut beta_rate_dot_of_place_43_last = beta_rate_dot_of_place_43_1;
    let mut beta_rate_dot_of_place_45_last = beta_rate_dot_of_place_45_1;
    let mut beta_rate_dot_of_place_47_last = beta_rate_dot_of_place_47_1;
    let mut beta_rate_dot_of_place_49_last = beta_rate_dot_of_place_49_1;
    let mut beta_rate_dot_of_place_51_last = beta_rate_dot_of_place_51_1;
    let mut beta_rate_dot_of_place_53_last = beta_rate_dot_of_place_53_1;
    let mut beta_rate_dot_of_place_54_last = beta_rate_dot_of_place_54_1;
    let mut beta_rate_dot_of_place_56_last = beta_rate_dot_of_place_56_1;
    let mut beta_rate_dot_of_place_58_last = beta_rate_dot_of_place_58_1;
    let mut beta_rate_sq_last = beta_rate_sq_1;
    let mut beta_rate_dot_of_place_60_last = beta_rate_dot_of_place_60_1;
    let mut beta_rate_dot_of_place_63_last = beta_rate_dot_of_place_63_1;
    let mut beta_rate_dot_of_place_64_last = beta_rate_dot_of_place_64_1;
    let mut beta_rate_dot_of_place_68_last = beta_rate_dot_of_place_68_1;
    let mut beta_rate_dot_of_place_71_last = beta_rate_dot_of_place_71_1;
    let mut beta_rate_dot_of_place_75_last = beta_rate_dot_of_place_75_1;
    let mut beta_rate_dot_of_place_76_last = beta_rate_dot_of_place_76_1;
    let mut beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79_1;
    let mut beta_rate_dot_of_place_82_last = beta_rate_dot_of_place_82_1;
    let mut beta_rate_dot_of_place_83_last = beta_rate_dot_of_place_83_1;
    let mut beta_rate_dot_of_place_85_last = beta_rate_dot_of_place_85_1;
    let mut beta_rate_dot_of_place_88_last = beta_rate_dot_of_place_88_1;
    let mut beta_rate_dot_of_place_90_last = beta_rate_dot_of_place_90_1;
    let mut beta_rate_dot_of_place_91_last = beta_rate_dot_of_place_91_1;
    let mut beta_rate_dot_of_place_92_last = beta_rate_dot_of_place_92_1;
    let mut beta_rate_dot_of_place_94_last = beta_rate_dot_of_place_94_1;
    let mut beta_rate_dot_of_place_95_last = beta_rate_dot_of_place_95_1;
    let mut beta_rate_dot_of_beta_rate_3_last = beta_rate_dot_of_beta_rate_3_1;
    let mut beta_rate_dot_of_beta_rate_6_last = beta_rate_dot_of_beta_rate_6_1;
    let mut beta_rate_dot_2_last = beta_rate_dot_2_1;
    let mut theta_of_place_last = theta_of_place_1;
    let mut gamma_of_beta_rate_last = gamma_of_beta_rate_1;
    let mut phi_minus_90deg_of_place_last = phi_minus_90deg_of_place_1;
    let mut omega_of_place_last = omega_of_place_1;
    let mut next = [S::int(0); 112];
    // Rates at order k - 1.
    let mut beta_rate_2 = beta_rate_1;
    let mut theta_rate = theta_dot_2_1;
    let mut gamma_rate = rr_by_ss * gamma_of_beta_rate_1;
    let mut delta_rate = rr_by_zt * delta_of_beta_rate_1;
    let mut phi_minus_90deg_rate = minus_rr * phi_minus_90deg_of_beta_rate_1;
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
        let phi_minus_90deg = phi_minus_90deg_rate * over_k;
        let epsilon = epsilon_rate * over_k;
        let omega = omega_rate * over_k;
        let beta_rate = beta_rate_rate * over_k;
        series[order] = [
            beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega, beta_rate,
        ];
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
                omega_1
                    .mul_add(
                        cos_omega_last,
                        (count_last * omega_last).mul_add(cos_omega_1, next[2]),
                    ),
                omega_1
                    .mul_add(
                        sin_omega_last,
                        (count_last * omega_last).mul_add(sin_omega_1, next[3]),
                    ),
                d1_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * d1_of_place_last).mul_add(cos_angle_1, next[4]),
                    ),
                d1_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * d1_of_place_last).mul_add(sin_angle_1, next[5]),
                    ),
                beta_minus_gamma_1
                    .mul_add(
                        cos_beta_minus_gamma_last,
                        (count_last * beta_minus_gamma_last)
                            .mul_add(cos_beta_minus_gamma_1, next[6]),
                    ),
                beta_minus_gamma_1
                    .mul_add(
                        sin_beta_minus_gamma_last,
                        (count_last * beta_minus_gamma_last)
                            .mul_add(sin_beta_minus_gamma_1, next[7]),
                    ),
                gamma_minus_delta_1
                    .mul_add(
                        cos_gamma_minus_delta_last,
                        (count_last * gamma_minus_delta_last)
                            .mul_add(cos_gamma_minus_delta_1, next[8]),
                    ),
                gamma_minus_delta_1
                    .mul_add(
                        sin_gamma_minus_delta_last,
                        (count_last * gamma_minus_delta_last)
                            .mul_add(sin_gamma_minus_delta_1, next[9]),
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
                gamma_minus_epsilon_1
                    .mul_add(
                        cos_gamma_minus_epsilon_last,
                        (count_last * gamma_minus_epsilon_last)
                            .mul_add(cos_gamma_minus_epsilon_1, next[12]),
                    ),
                gamma_minus_epsilon_1
                    .mul_add(
                        sin_gamma_minus_epsilon_last,
                        (count_last * gamma_minus_epsilon_last)
                            .mul_add(sin_gamma_minus_epsilon_1, next[13]),
                    ),
                (cos_beta_minus_gamma_1 + cos_beta_minus_gamma_1)
                    .mul_add(cos_beta_minus_gamma_last, next[14]),
                cos_theta_1
                    .mul_add(
                        cos_beta_minus_gamma_last,
                        cos_theta_last.mul_add(cos_beta_minus_gamma_1, next[15]),
                    ),
                phi_minus_90deg_1
                    .mul_add(
                        cos_phi_minus_90deg_last,
                        (count_last * phi_minus_90deg_last)
                            .mul_add(cos_phi_minus_90deg_1, next[16]),
                    ),
                phi_minus_90deg_1
                    .mul_add(
                        sin_phi_minus_90deg_last,
                        (count_last * phi_minus_90deg_last)
                            .mul_add(sin_phi_minus_90deg_1, next[17]),
                    ),
                d1_of_place_4_1
                    .mul_add(
                        cos_angle_3_last,
                        (count_last * d1_of_place_4_last)
                            .mul_add(cos_angle_3_1, next[18]),
                    ),
                d1_of_place_4_1
                    .mul_add(
                        sin_angle_3_last,
                        (count_last * d1_of_place_4_last)
                            .mul_add(sin_angle_3_1, next[19]),
                    ),
                sin_omega_1
                    .mul_add(
                        cos_angle_2_last,
                        sin_omega_last.mul_add(cos_angle_2_1, next[20]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        d1_of_place_5_last,
                        sin_gamma_minus_epsilon_last.mul_add(d1_of_place_5_1, next[21]),
                    ),
                (cos_angle_2_1 + cos_angle_2_1).mul_add(cos_angle_2_last, next[22]),
                (cos_omega_1 + cos_omega_1).mul_add(cos_omega_last, next[23]),
                cos_omega_sq_1
                    .mul_add(
                        d1_of_place_8_last,
                        cos_omega_sq_last.mul_add(d1_of_place_8_1, next[24]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        cos_angle_3_last,
                        cos_phi_minus_90deg_last.mul_add(cos_angle_3_1, next[25]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        d1_of_place_10_last,
                        cos_gamma_minus_delta_last.mul_add(d1_of_place_10_1, next[26]),
                    ),
                (cos_angle_3_1 + cos_angle_3_1).mul_add(cos_angle_3_last, next[27]),
                (sin_phi_minus_90deg_1 + sin_phi_minus_90deg_1)
                    .mul_add(sin_phi_minus_90deg_last, next[28]),
                sin_phi_minus_90deg_sq_1
                    .mul_add(
                        d1_of_place_13_last,
                        sin_phi_minus_90deg_sq_last.mul_add(d1_of_place_13_1, next[29]),
                    ),
                (sin_theta_1 + sin_theta_1).mul_add(sin_theta_last, next[30]),
                d1_of_place_14_1
                    .mul_add(
                        sin_theta_sq_last,
                        d1_of_place_14_last.mul_add(sin_theta_sq_1, next[31]),
                    ),
                cos_angle_1
                    .mul_add(
                        d1_of_place_17_last,
                        cos_angle_last.mul_add(d1_of_place_17_1, next[32]),
                    ),
                cos_angle_1
                    .mul_add(
                        d1_of_place_19_last,
                        cos_angle_last.mul_add(d1_of_place_19_1, next[33]),
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
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_4_1, next[37]),
                    ),
                cos_angle_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_last.mul_add(sin_angle_cos_angle_inv_1, next[38]),
                    ),
                cos_theta_1
                    .mul_add(
                        sin_beta_minus_gamma_last,
                        cos_theta_last.mul_add(sin_beta_minus_gamma_1, next[39]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_7_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_7_1, next[40]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_10_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_10_1, next[41]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_12_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_12_1, next[42]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_14_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_14_1, next[43]),
                    ),
                (sin_gamma_minus_epsilon_1 + sin_gamma_minus_epsilon_1)
                    .mul_add(sin_gamma_minus_epsilon_last, next[44]),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_18_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_18_1, next[45]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        sin_angle_2_last,
                        sin_gamma_minus_epsilon_last.mul_add(sin_angle_2_1, next[46]),
                    ),
                cos_omega_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        cos_omega_last.mul_add(sin_omega_cos_omega_inv_1, next[47]),
                    ),
                beta_rate_dot_of_place_5_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        beta_rate_dot_of_place_5_last
                            .mul_add(sin_omega_cos_omega_inv_1, next[48]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_23_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_23_1, next[49]),
                    ),
                sin_omega_1
                    .mul_add(
                        cos_gamma_minus_epsilon_last,
                        sin_omega_last.mul_add(cos_gamma_minus_epsilon_1, next[50]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_26_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_26_1, next[51]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_28_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_28_1, next[52]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_30_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_30_1, next[53]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_32_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_32_1, next[54]),
                    ),
                (cos_gamma_minus_delta_1 + cos_gamma_minus_delta_1)
                    .mul_add(cos_gamma_minus_delta_last, next[55]),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_35_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_35_1, next[56]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        sin_angle_3_last,
                        cos_gamma_minus_delta_last.mul_add(sin_angle_3_1, next[57]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_38_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_38_1, next[58]),
                    ),
                beta_rate_dot_of_place_8_1
                    .mul_add(
                        beta_rate_dot_of_place_38_last,
                        beta_rate_dot_of_place_8_last
                            .mul_add(beta_rate_dot_of_place_38_1, next[59]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_40_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_40_1, next[60]),
                    ),
                sin_gamma_minus_delta_1
                    .mul_add(
                        cos_phi_minus_90deg_last,
                        sin_gamma_minus_delta_last
                            .mul_add(cos_phi_minus_90deg_1, next[61]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_43_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_43_1, next[62]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_beta_minus_gamma_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[63]),
                    ),
                d1_of_place_14_1
                    .mul_add(
                        beta_rate_dot_of_place_45_last,
                        d1_of_place_14_last
                            .mul_add(beta_rate_dot_of_place_45_1, next[64]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_47_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_47_1, next[65]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_49_last,
                        cos_beta_minus_gamma_last
                            .mul_add(beta_rate_dot_of_place_49_1, next[66]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_51_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_51_1, next[67]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_53_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_53_1, next[68]),
                    ),
                beta_rate_dot_of_place_54_1
                    .mul_add(
                        beta_rate_dot_of_place_45_last,
                        beta_rate_dot_of_place_54_last
                            .mul_add(beta_rate_dot_of_place_45_1, next[69]),
                    ),
                beta_rate_dot_of_place_56_1
                    .mul_add(
                        beta_rate_dot_of_place_53_last,
                        beta_rate_dot_of_place_56_last
                            .mul_add(beta_rate_dot_of_place_53_1, next[70]),
                    ),
                (beta_rate_1 + beta_rate_1).mul_add(beta_rate_last, next[71]),
                beta_rate_dot_of_place_58_1
                    .mul_add(
                        beta_rate_sq_last,
                        beta_rate_dot_of_place_58_last.mul_add(beta_rate_sq_1, next[72]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_37_last,
                        cos_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_37_1, next[73]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_60_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_60_1, next[74]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_63_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_63_1, next[75]),
                    ),
                beta_rate_dot_of_place_64_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        beta_rate_dot_of_place_64_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[76]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        sin_angle_3_last,
                        cos_phi_minus_90deg_last.mul_add(sin_angle_3_1, next[77]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_9_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_9_1, next[78]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_68_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_68_1, next[79]),
                    ),
                sin_phi_minus_90deg_sq_1
                    .mul_add(
                        beta_rate_dot_of_place_71_last,
                        sin_phi_minus_90deg_sq_last
                            .mul_add(beta_rate_dot_of_place_71_1, next[80]),
                    ),
                sin_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_20_last,
                        sin_omega_last.mul_add(beta_rate_dot_of_place_20_1, next[81]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_21_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_21_1, next[82]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_75_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_75_1, next[83]),
                    ),
                beta_rate_dot_of_place_76_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        beta_rate_dot_of_place_76_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[84]),
                    ),
                sin_omega_1
                    .mul_add(
                        sin_angle_2_last,
                        sin_omega_last.mul_add(sin_angle_2_1, next[85]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_3_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_3_1, next[86]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_79_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_79_1, next[87]),
                    ),
                cos_omega_sq_1
                    .mul_add(
                        beta_rate_dot_of_place_82_last,
                        cos_omega_sq_last.mul_add(beta_rate_dot_of_place_82_1, next[88]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_83_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_83_1, next[89]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_85_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_85_1, next[90]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_88_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_88_1, next[91]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_90_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_90_1, next[92]),
                    ),
                beta_rate_dot_of_place_91_1
                    .mul_add(
                        beta_rate_sq_last,
                        beta_rate_dot_of_place_91_last.mul_add(beta_rate_sq_1, next[93]),
                    ),
                beta_rate_dot_of_place_2_1
                    .mul_add(
                        beta_rate_dot_of_place_92_last,
                        beta_rate_dot_of_place_2_last
                            .mul_add(beta_rate_dot_of_place_92_1, next[94]),
                    ),
                beta_rate_dot_of_place_1
                    .mul_add(
                        beta_rate_dot_of_place_95_last,
                        beta_rate_dot_of_place_last
                            .mul_add(beta_rate_dot_of_place_95_1, next[95]),
                    ),
                beta_rate_dot_of_place_94_1
                    .mul_add(
                        beta_rate_dot_of_place_95_last,
                        beta_rate_dot_of_place_94_last
                            .mul_add(beta_rate_dot_of_place_95_1, next[96]),
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
                d1_of_place_20_1
                    .mul_add(
                        beta_rate_dot_2_last,
                        d1_of_place_20_last.mul_add(beta_rate_dot_2_1, next[99]),
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
                        beta_rate_dot_of_place_7_last,
                        gamma_of_beta_rate_last
                            .mul_add(beta_rate_dot_of_place_7_1, next[103]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        phi_minus_90deg_of_place_last,
                        sin_phi_minus_90deg_last
                            .mul_add(phi_minus_90deg_of_place_1, next[104]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        phi_minus_90deg_of_place_last,
                        gamma_of_beta_rate_last
                            .mul_add(phi_minus_90deg_of_place_1, next[105]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        gamma_of_beta_rate_last
                            .mul_add(beta_rate_dot_of_place_4_1, next[106]),
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
        // sin_omega = sin(omega)
        let sin_omega = omega.mul_add(cos_omega_0, sums[2] * over_k);
        // cos_omega = cos(omega)
        let cos_omega = -omega.mul_add(sin_omega_0, sums[3] * over_k);
        // beta_minus_gamma = beta - gamma
        let beta_minus_gamma = beta - gamma;
        // d1_of_place = beta + theta - gamma
        let d1_of_place = beta + theta - gamma;
        // sin_angle = sin(d1_of_place)
        let sin_angle = d1_of_place.mul_add(cos_angle_0, sums[4] * over_k);
        // cos_angle = cos(d1_of_place)
        let cos_angle = -d1_of_place.mul_add(sin_angle_0, sums[5] * over_k);
        // sin_beta_minus_gamma = sin(beta_minus_gamma)
        let sin_beta_minus_gamma = beta_minus_gamma
            .mul_add(cos_beta_minus_gamma_0, sums[6] * over_k);
        // cos_beta_minus_gamma = cos(beta_minus_gamma)
        let cos_beta_minus_gamma = -beta_minus_gamma
            .mul_add(sin_beta_minus_gamma_0, sums[7] * over_k);
        // gamma_minus_delta = gamma - delta
        let gamma_minus_delta = gamma - delta;
        // sin_gamma_minus_delta = sin(gamma_minus_delta)
        let sin_gamma_minus_delta = gamma_minus_delta
            .mul_add(cos_gamma_minus_delta_0, sums[8] * over_k);
        // cos_gamma_minus_delta = cos(gamma_minus_delta)
        let cos_gamma_minus_delta = -gamma_minus_delta
            .mul_add(sin_gamma_minus_delta_0, sums[9] * over_k);
        // d1_of_place_2 = gamma - epsilon - omega
        let d1_of_place_2 = gamma - epsilon - omega;
        // sin_angle_2 = sin(d1_of_place_2)
        let sin_angle_2 = d1_of_place_2.mul_add(cos_angle_2_0, sums[10] * over_k);
        // cos_angle_2 = cos(d1_of_place_2)
        let cos_angle_2 = -d1_of_place_2.mul_add(sin_angle_2_0, sums[11] * over_k);
        // gamma_minus_epsilon = gamma - epsilon
        let gamma_minus_epsilon = gamma - epsilon;
        // sin_gamma_minus_epsilon = sin(gamma_minus_epsilon)
        let sin_gamma_minus_epsilon = gamma_minus_epsilon
            .mul_add(cos_gamma_minus_epsilon_0, sums[12] * over_k);
        // cos_gamma_minus_epsilon = cos(gamma_minus_epsilon)
        let cos_gamma_minus_epsilon = -gamma_minus_epsilon
            .mul_add(sin_gamma_minus_epsilon_0, sums[13] * over_k);
        // cos_beta_minus_gamma_sq = cos_beta_minus_gamma*cos_beta_minus_gamma
        let cos_beta_minus_gamma_sq = cos_beta_minus_gamma
            .mul_add(cos_beta_minus_gamma_0 + cos_beta_minus_gamma_0, sums[14]);
        // d1_of_place_3 = cos_theta*cos_beta_minus_gamma
        let d1_of_place_3 = cos_beta_minus_gamma
            .mul_add(cos_theta_0, cos_theta.mul_add(cos_beta_minus_gamma_0, sums[15]));
        // sin_phi_minus_90deg = sin(phi_minus_90deg)
        let sin_phi_minus_90deg = phi_minus_90deg
            .mul_add(cos_phi_minus_90deg_0, sums[16] * over_k);
        // cos_phi_minus_90deg = cos(phi_minus_90deg)
        let cos_phi_minus_90deg = -phi_minus_90deg
            .mul_add(sin_phi_minus_90deg_0, sums[17] * over_k);
        // d1_of_place_4 = gamma - delta - phi_minus_90deg
        let d1_of_place_4 = gamma - delta - phi_minus_90deg;
        // sin_angle_3 = sin(d1_of_place_4)
        let sin_angle_3 = d1_of_place_4.mul_add(cos_angle_3_0, sums[18] * over_k);
        // cos_angle_3 = cos(d1_of_place_4)
        let cos_angle_3 = -d1_of_place_4.mul_add(sin_angle_3_0, sums[19] * over_k);
        // sin_omega_cos_angle_2 = sin_omega*cos_angle_2
        let sin_omega_cos_angle_2 = cos_angle_2
            .mul_add(sin_omega_0, sin_omega.mul_add(cos_angle_2_0, sums[20]));
        // d1_of_place_5 = weight*sin_gamma_minus_epsilon + weight_2*sin_omega_cos_angle_2
        let d1_of_place_5 = sin_omega_cos_angle_2
            .mul_add(weight_2, weight * sin_gamma_minus_epsilon);
        // d1_of_place_6 = sin_gamma_minus_epsilon*d1_of_place_5
        let d1_of_place_6 = d1_of_place_5
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(d1_of_place_5_0, sums[21]),
            );
        // cos_angle_2_sq = cos_angle_2*cos_angle_2
        let cos_angle_2_sq = cos_angle_2
            .mul_add(cos_angle_2_0 + cos_angle_2_0, sums[22]);
        // d1_of_place_7 = d1_of_place_6 + weight_3*cos_angle_2_sq
        let d1_of_place_7 = weight_3 * cos_angle_2_sq + d1_of_place_6;
        // cos_omega_sq = cos_omega*cos_omega
        let cos_omega_sq = cos_omega.mul_add(cos_omega_0 + cos_omega_0, sums[23]);
        // d1_of_place_8 = d1_of_place_7/cos_omega_sq
        let d1_of_place_8 = d1_of_place_7
            .mul_add(
                over_cos_omega_sq,
                -(cos_omega_sq.mul_add(d1_of_place_8_0, sums[24]) * over_cos_omega_sq),
            );
        // d1_of_place_9 = cos_phi_minus_90deg*cos_angle_3
        let d1_of_place_9 = cos_angle_3
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(cos_angle_3_0, sums[25]),
            );
        // d1_of_place_10 = weight_4*cos_gamma_minus_delta + weight_5*d1_of_place_9
        let d1_of_place_10 = d1_of_place_9
            .mul_add(weight_5, weight_4 * cos_gamma_minus_delta);
        // d1_of_place_11 = cos_gamma_minus_delta*d1_of_place_10
        let d1_of_place_11 = d1_of_place_10
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(d1_of_place_10_0, sums[26]),
            );
        // cos_angle_3_sq = cos_angle_3*cos_angle_3
        let cos_angle_3_sq = cos_angle_3
            .mul_add(cos_angle_3_0 + cos_angle_3_0, sums[27]);
        // d1_of_place_12 = d1_of_place_11 + weight_6*cos_angle_3_sq
        let d1_of_place_12 = weight_6 * cos_angle_3_sq + d1_of_place_11;
        // sin_phi_minus_90deg_sq = sin_phi_minus_90deg*sin_phi_minus_90deg
        let sin_phi_minus_90deg_sq = sin_phi_minus_90deg
            .mul_add(sin_phi_minus_90deg_0 + sin_phi_minus_90deg_0, sums[28]);
        // d1_of_place_13 = d1_of_place_12/sin_phi_minus_90deg_sq
        let d1_of_place_13 = d1_of_place_12
            .mul_add(
                over_sin_phi_minus_90deg_sq,
                -(sin_phi_minus_90deg_sq.mul_add(d1_of_place_13_0, sums[29])
                    * over_sin_phi_minus_90deg_sq),
            );
        // d1_of_place_14 = weight_7 + d1_of_place_8 + d1_of_place_13
        let d1_of_place_14 = d1_of_place_8 + d1_of_place_13;
        // sin_theta_sq = sin_theta*sin_theta
        let sin_theta_sq = sin_theta.mul_add(sin_theta_0 + sin_theta_0, sums[30]);
        // d1_of_place_15 = d1_of_place_14*sin_theta_sq
        let d1_of_place_15 = d1_of_place_14
            .mul_add(sin_theta_sq_0, sin_theta_sq.mul_add(d1_of_place_14_0, sums[31]));
        // d1_of_place_16 = i2_plus_m2_da_2_by_d_2*cos_beta_minus_gamma_sq + d1_of_place_15
        let d1_of_place_16 = i2_plus_m2_da_2_by_d_2 * cos_beta_minus_gamma_sq + d1_of_place_15;
        // d1_of_place_17 = d1_of_place_16/cos_angle
        let d1_of_place_17 = d1_of_place_16
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(d1_of_place_17_0, sums[32]) * over_cos_angle),
            );
        // d1_of_place_18 = weight_8*d1_of_place_3 - d1_of_place_17
        let d1_of_place_18 = weight_8 * d1_of_place_3 - d1_of_place_17;
        // d1_of_place_19 = d1_of_place_18/cos_angle
        let d1_of_place_19 = d1_of_place_18
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(d1_of_place_19_0, sums[33]) * over_cos_angle),
            );
        // d1_of_place_20 = weight_9 + minus_rr_2*d1_of_place_19
        let d1_of_place_20 = minus_rr_2 * d1_of_place_19;
        // sin_gamma = sin(gamma)
        let sin_gamma = gamma.mul_add(cos_gamma_0, sums[34] * over_k);
        // cos_gamma = cos(gamma)
        let cos_gamma = -gamma.mul_add(sin_gamma_0, sums[35] * over_k);
        // beta_rate_dot_of_place = weight_10 + weight_11*sin_gamma + weight_12*cos_gamma
        let beta_rate_dot_of_place = cos_gamma.mul_add(weight_12, weight_11 * sin_gamma);
        // beta_rate_dot_of_place_2 = sqrt(beta_rate_dot_of_place)
        let beta_rate_dot_of_place_2 = (beta_rate_dot_of_place - sums[36])
            * over_twice_beta_rate_dot_of_place_2;
        // beta_rate_dot_of_place_3 = weight_13*cos_angle_2 + minus_1_by_zf*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_3 = sin_gamma_minus_epsilon
            .mul_add(minus_1_by_zf, weight_13 * cos_angle_2);
        // beta_rate_dot_of_place_4 = cos_angle_2/cos_omega
        let beta_rate_dot_of_place_4 = cos_angle_2
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_4_0, sums[37]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_5 = weight_3*beta_rate_dot_of_place_4 +
        //   m6_fa_by_zf_minus_1*cos_gamma_minus_epsilon
        let beta_rate_dot_of_place_5 = beta_rate_dot_of_place_4
            .mul_add(weight_3, m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon);
        // sin_angle_cos_angle_inv = sin_angle/cos_angle
        let sin_angle_cos_angle_inv = cos_angle
            .mul_add(
                -(sin_angle_cos_angle_inv_0 * over_cos_angle),
                (sin_angle - sums[38]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_6 = cos_theta*sin_beta_minus_gamma
        let beta_rate_dot_of_place_6 = sin_beta_minus_gamma
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_beta_minus_gamma_0, sums[39]));
        // beta_rate_dot_of_place_7 = cos_angle_3/sin_phi_minus_90deg
        let beta_rate_dot_of_place_7 = cos_angle_3
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_7_0, sums[40])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_8 = m4_ea_by_e_minus_1*sin_gamma_minus_delta +
        //   weight_6*beta_rate_dot_of_place_7
        let beta_rate_dot_of_place_8 = beta_rate_dot_of_place_7
            .mul_add(weight_6, m4_ea_by_e_minus_1 * sin_gamma_minus_delta);
        // beta_rate_dot_of_place_9 = weight_14*cos_gamma_minus_delta + weight_15*cos_angle_3
        let beta_rate_dot_of_place_9 = cos_angle_3
            .mul_add(weight_15, weight_14 * cos_gamma_minus_delta);
        // beta_rate_dot_of_place_10 = weight_16 + weight_17*sin_omega
        let beta_rate_dot_of_place_10 = weight_17 * sin_omega;
        // beta_rate_dot_of_place_11 = cos_angle_2*beta_rate_dot_of_place_10
        let beta_rate_dot_of_place_11 = beta_rate_dot_of_place_10
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_10_0, sums[41]),
            );
        // beta_rate_dot_of_place_12 = weight_18 + weight_19*sin_omega
        let beta_rate_dot_of_place_12 = weight_19 * sin_omega;
        // beta_rate_dot_of_place_13 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_12
        let beta_rate_dot_of_place_13 = beta_rate_dot_of_place_12
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_12_0, sums[42]),
            );
        // beta_rate_dot_of_place_14 = beta_rate_dot_of_place_11 - beta_rate_dot_of_place_13
        let beta_rate_dot_of_place_14 = beta_rate_dot_of_place_11 - beta_rate_dot_of_place_13;
        // beta_rate_dot_of_place_15 = cos_angle_2*beta_rate_dot_of_place_14
        let beta_rate_dot_of_place_15 = beta_rate_dot_of_place_14
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_14_0, sums[43]),
            );
        // beta_rate_dot_of_place_16 = sin_gamma_minus_epsilon*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_16 = sin_gamma_minus_epsilon
            .mul_add(sin_gamma_minus_epsilon_0 + sin_gamma_minus_epsilon_0, sums[44]);
        // beta_rate_dot_of_place_17 = beta_rate_dot_of_place_15 + weight_20*beta_rate_dot_of_place_16
        let beta_rate_dot_of_place_17 = weight_20 * beta_rate_dot_of_place_16
            + beta_rate_dot_of_place_15;
        // beta_rate_dot_of_place_18 = beta_rate_dot_of_place_17/cos_omega
        let beta_rate_dot_of_place_18 = beta_rate_dot_of_place_17
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_18_0, sums[45]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_19 = sin_gamma_minus_epsilon*sin_angle_2
        let beta_rate_dot_of_place_19 = sin_angle_2
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(sin_angle_2_0, sums[46]),
            );
        // beta_rate_dot_of_place_20 = beta_rate_dot_of_place_18 + weight_21*beta_rate_dot_of_place_19
        let beta_rate_dot_of_place_20 = weight_21 * beta_rate_dot_of_place_19
            + beta_rate_dot_of_place_18;
        // beta_rate_dot_of_place_21 = weight_22*cos_gamma_minus_epsilon + weight_23*sin_angle_2
        let beta_rate_dot_of_place_21 = sin_angle_2
            .mul_add(weight_23, weight_22 * cos_gamma_minus_epsilon);
        // sin_omega_cos_omega_inv = sin_omega/cos_omega
        let sin_omega_cos_omega_inv = cos_omega
            .mul_add(
                -(sin_omega_cos_omega_inv_0 * over_cos_omega),
                (sin_omega - sums[47]) * over_cos_omega,
            );
        // beta_rate_dot_of_place_22 = beta_rate_dot_of_place_5*sin_omega_cos_omega_inv
        let beta_rate_dot_of_place_22 = beta_rate_dot_of_place_5
            .mul_add(
                sin_omega_cos_omega_inv_0,
                sin_omega_cos_omega_inv.mul_add(beta_rate_dot_of_place_5_0, sums[48]),
            );
        // beta_rate_dot_of_place_23 = weight_24*sin_angle_cos_angle_inv +
        //   weight_13*beta_rate_dot_of_place_22
        let beta_rate_dot_of_place_23 = beta_rate_dot_of_place_22
            .mul_add(weight_13, weight_24 * sin_angle_cos_angle_inv);
        // beta_rate_dot_of_place_24 = cos_angle_2*beta_rate_dot_of_place_23
        let beta_rate_dot_of_place_24 = beta_rate_dot_of_place_23
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_23_0, sums[49]),
            );
        // beta_rate_dot_of_place_25 = sin_omega*cos_gamma_minus_epsilon
        let beta_rate_dot_of_place_25 = cos_gamma_minus_epsilon
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(cos_gamma_minus_epsilon_0, sums[50]),
            );
        // beta_rate_dot_of_place_26 = beta_rate_dot_of_place_24 + weight_24*sin_angle_2 +
        //   weight_25*beta_rate_dot_of_place_25
        let beta_rate_dot_of_place_26 = beta_rate_dot_of_place_25
            .mul_add(weight_25, weight_24 * sin_angle_2) + beta_rate_dot_of_place_24;
        // beta_rate_dot_of_place_27 = cos_angle_2*beta_rate_dot_of_place_26
        let beta_rate_dot_of_place_27 = beta_rate_dot_of_place_26
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_26_0, sums[51]),
            );
        // beta_rate_dot_of_place_28 = weight_26 + weight_27*cos_phi_minus_90deg
        let beta_rate_dot_of_place_28 = weight_27 * cos_phi_minus_90deg;
        // beta_rate_dot_of_place_29 = cos_angle_3*beta_rate_dot_of_place_28
        let beta_rate_dot_of_place_29 = beta_rate_dot_of_place_28
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_28_0, sums[52]),
            );
        // beta_rate_dot_of_place_30 = weight_28 + weight_29*cos_phi_minus_90deg
        let beta_rate_dot_of_place_30 = weight_29 * cos_phi_minus_90deg;
        // beta_rate_dot_of_place_31 = cos_gamma_minus_delta*beta_rate_dot_of_place_30
        let beta_rate_dot_of_place_31 = beta_rate_dot_of_place_30
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_30_0, sums[53]),
            );
        // beta_rate_dot_of_place_32 = beta_rate_dot_of_place_29 + beta_rate_dot_of_place_31
        let beta_rate_dot_of_place_32 = beta_rate_dot_of_place_29 + beta_rate_dot_of_place_31;
        // beta_rate_dot_of_place_33 = cos_angle_3*beta_rate_dot_of_place_32
        let beta_rate_dot_of_place_33 = beta_rate_dot_of_place_32
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_32_0, sums[54]),
            );
        // cos_gamma_minus_delta_sq = cos_gamma_minus_delta*cos_gamma_minus_delta
        let cos_gamma_minus_delta_sq = cos_gamma_minus_delta
            .mul_add(cos_gamma_minus_delta_0 + cos_gamma_minus_delta_0, sums[55]);
        // beta_rate_dot_of_place_34 = beta_rate_dot_of_place_33 + weight_30*cos_gamma_minus_delta_sq
        let beta_rate_dot_of_place_34 = weight_30 * cos_gamma_minus_delta_sq
            + beta_rate_dot_of_place_33;
        // beta_rate_dot_of_place_35 = beta_rate_dot_of_place_34/sin_phi_minus_90deg
        let beta_rate_dot_of_place_35 = beta_rate_dot_of_place_34
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_35_0, sums[56])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_36 = cos_gamma_minus_delta*sin_angle_3
        let beta_rate_dot_of_place_36 = sin_angle_3
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(sin_angle_3_0, sums[57]),
            );
        // beta_rate_dot_of_place_37 = beta_rate_dot_of_place_35 +
        //   m4_1_minus_ea_by_e_by_e*beta_rate_dot_of_place_36
        let beta_rate_dot_of_place_37 = m4_1_minus_ea_by_e_by_e
            * beta_rate_dot_of_place_36 + beta_rate_dot_of_place_35;
        // beta_rate_dot_of_place_38 = cos_phi_minus_90deg/sin_phi_minus_90deg
        let beta_rate_dot_of_place_38 = sin_phi_minus_90deg
            .mul_add(
                -(beta_rate_dot_of_place_38_0 * over_sin_phi_minus_90deg),
                (cos_phi_minus_90deg - sums[58]) * over_sin_phi_minus_90deg,
            );
        // beta_rate_dot_of_place_39 = beta_rate_dot_of_place_8*beta_rate_dot_of_place_38
        let beta_rate_dot_of_place_39 = beta_rate_dot_of_place_8
            .mul_add(
                beta_rate_dot_of_place_38_0,
                beta_rate_dot_of_place_38.mul_add(beta_rate_dot_of_place_8_0, sums[59]),
            );
        // beta_rate_dot_of_place_40 = weight_31*sin_angle_cos_angle_inv +
        //   minus_1_by_zt*beta_rate_dot_of_place_39
        let beta_rate_dot_of_place_40 = beta_rate_dot_of_place_39
            .mul_add(minus_1_by_zt, weight_31 * sin_angle_cos_angle_inv);
        // beta_rate_dot_of_place_41 = cos_angle_3*beta_rate_dot_of_place_40
        let beta_rate_dot_of_place_41 = beta_rate_dot_of_place_40
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_40_0, sums[60]),
            );
        // beta_rate_dot_of_place_42 = sin_gamma_minus_delta*cos_phi_minus_90deg
        let beta_rate_dot_of_place_42 = sin_gamma_minus_delta
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(sin_gamma_minus_delta_0, sums[61]),
            );
        // beta_rate_dot_of_place_43 = beta_rate_dot_of_place_41 + weight_31*sin_angle_3 +
        //   m4_ea_by_e_minus_1_by_ss*beta_rate_dot_of_place_42
        let beta_rate_dot_of_place_43 = beta_rate_dot_of_place_42
            .mul_add(m4_ea_by_e_minus_1_by_ss, weight_31 * sin_angle_3) + beta_rate_dot_of_place_41;
        // beta_rate_dot_of_place_44 = cos_angle_3*beta_rate_dot_of_place_43
        let beta_rate_dot_of_place_44 = beta_rate_dot_of_place_43
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_43_0, sums[62]),
            );
        // beta_rate_dot_of_place_45 = cos_beta_minus_gamma*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_45 = sin_angle_cos_angle_inv
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(sin_angle_cos_angle_inv_0, sums[63]),
            );
        // beta_rate_dot_of_place_46 = d1_of_place_14*beta_rate_dot_of_place_45
        let beta_rate_dot_of_place_46 = d1_of_place_14
            .mul_add(
                beta_rate_dot_of_place_45_0,
                beta_rate_dot_of_place_45.mul_add(d1_of_place_14_0, sums[64]),
            );
        // beta_rate_dot_of_place_47 = weight_7 + d1_of_place_8 + d1_of_place_13 + m2_da_by_ss*sin_angle
        let beta_rate_dot_of_place_47 = m2_da_by_ss * sin_angle + d1_of_place_8 + d1_of_place_13;
        // beta_rate_dot_of_place_48 = cos_theta*beta_rate_dot_of_place_47
        let beta_rate_dot_of_place_48 = beta_rate_dot_of_place_47
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_47_0, sums[65]),
            );
        // beta_rate_dot_of_place_49 = beta_rate_dot_of_place_48 + weight_32*beta_rate_dot_of_place_45 +
        //   i2_plus_m2_da_2_by_d_ss*sin_beta_minus_gamma
        let beta_rate_dot_of_place_49 = beta_rate_dot_of_place_45
            .mul_add(weight_32, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma)
            + beta_rate_dot_of_place_48;
        // beta_rate_dot_of_place_50 = cos_beta_minus_gamma*beta_rate_dot_of_place_49
        let beta_rate_dot_of_place_50 = beta_rate_dot_of_place_49
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(beta_rate_dot_of_place_49_0, sums[66]),
            );
        // beta_rate_dot_of_place_51 = weight_7 + d1_of_place_8 + d1_of_place_13 +
        //   m2_da_rr_by_d_ss*sin_beta_minus_gamma
        let beta_rate_dot_of_place_51 = m2_da_rr_by_d_ss * sin_beta_minus_gamma
            + d1_of_place_8 + d1_of_place_13;
        // beta_rate_dot_of_place_52 = cos_theta*beta_rate_dot_of_place_51
        let beta_rate_dot_of_place_52 = beta_rate_dot_of_place_51
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_51_0, sums[67]),
            );
        // beta_rate_dot_of_place_53 = cos_beta_minus_gamma/cos_angle
        let beta_rate_dot_of_place_53 = cos_angle
            .mul_add(
                -(beta_rate_dot_of_place_53_0 * over_cos_angle),
                (cos_beta_minus_gamma - sums[68]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_54 = i2_plus_m2_da_2_by_d*beta_rate_dot_of_place_53 +
        //   minus_m2_da*cos_theta
        let beta_rate_dot_of_place_54 = beta_rate_dot_of_place_53
            .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta);
        // beta_rate_dot_of_place_55 = beta_rate_dot_of_place_54*beta_rate_dot_of_place_45
        let beta_rate_dot_of_place_55 = beta_rate_dot_of_place_45
            .mul_add(
                beta_rate_dot_of_place_54_0,
                beta_rate_dot_of_place_54.mul_add(beta_rate_dot_of_place_45_0, sums[69]),
            );
        // beta_rate_dot_of_place_56 = i2_plus_m2_da_2*sin_beta_minus_gamma +
        //   minus_rr*beta_rate_dot_of_place_55
        let beta_rate_dot_of_place_56 = beta_rate_dot_of_place_55
            .mul_add(minus_rr, i2_plus_m2_da_2 * sin_beta_minus_gamma);
        // beta_rate_dot_of_place_57 = beta_rate_dot_of_place_56*beta_rate_dot_of_place_53
        let beta_rate_dot_of_place_57 = beta_rate_dot_of_place_56
            .mul_add(
                beta_rate_dot_of_place_53_0,
                beta_rate_dot_of_place_53.mul_add(beta_rate_dot_of_place_56_0, sums[70]),
            );
        // beta_rate_dot_of_place_58 = m2_da*beta_rate_dot_of_place_6 +
        //   minus_1_by_d*beta_rate_dot_of_place_57
        let beta_rate_dot_of_place_58 = beta_rate_dot_of_place_57
            .mul_add(minus_1_by_d, m2_da * beta_rate_dot_of_place_6);
        // beta_rate_sq = beta_rate*beta_rate
        let beta_rate_sq = beta_rate.mul_add(beta_rate_0 + beta_rate_0, sums[71]);
        // beta_rate_dot_of_beta_rate = beta_rate_dot_of_place_58*beta_rate_sq
        let beta_rate_dot_of_beta_rate = beta_rate_dot_of_place_58
            .mul_add(
                beta_rate_sq_0,
                beta_rate_sq.mul_add(beta_rate_dot_of_place_58_0, sums[72]),
            );
        // beta_rate_dot_of_place_59 = cos_phi_minus_90deg*beta_rate_dot_of_place_37
        let beta_rate_dot_of_place_59 = beta_rate_dot_of_place_37
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(beta_rate_dot_of_place_37_0, sums[73]),
            );
        // beta_rate_dot_of_place_60 = weight_33*sin_angle_3 + weight_34*sin_gamma_minus_delta
        let beta_rate_dot_of_place_60 = sin_gamma_minus_delta
            .mul_add(weight_34, weight_33 * sin_angle_3);
        // beta_rate_dot_of_place_61 = cos_angle_3*beta_rate_dot_of_place_60
        let beta_rate_dot_of_place_61 = beta_rate_dot_of_place_60
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_60_0, sums[74]),
            );
        // beta_rate_dot_of_place_62 = beta_rate_dot_of_place_59 - beta_rate_dot_of_place_61
        let beta_rate_dot_of_place_62 = -beta_rate_dot_of_place_61 + beta_rate_dot_of_place_59;
        // beta_rate_dot_of_place_63 = beta_rate_dot_of_place_62/sin_phi_minus_90deg
        let beta_rate_dot_of_place_63 = beta_rate_dot_of_place_62
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_63_0, sums[75])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_64 = weight_5*d1_of_place_9 + weight_35*cos_gamma_minus_delta
        let beta_rate_dot_of_place_64 = d1_of_place_9
            .mul_add(weight_5, weight_35 * cos_gamma_minus_delta);
        // beta_rate_dot_of_place_65 = beta_rate_dot_of_place_64*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_65 = beta_rate_dot_of_place_64
            .mul_add(
                sin_angle_cos_angle_inv_0,
                sin_angle_cos_angle_inv.mul_add(beta_rate_dot_of_place_64_0, sums[76]),
            );
        // beta_rate_dot_of_place_66 = cos_phi_minus_90deg*sin_angle_3
        let beta_rate_dot_of_place_66 = sin_angle_3
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(sin_angle_3_0, sums[77]),
            );
        // beta_rate_dot_of_place_67 = cos_angle_3*beta_rate_dot_of_place_9
        let beta_rate_dot_of_place_67 = beta_rate_dot_of_place_9
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_9_0, sums[78]),
            );
        // beta_rate_dot_of_place_68 = beta_rate_dot_of_place_63 + minus_1_by_ss*beta_rate_dot_of_place_65
        //   + weight_36*sin_gamma_minus_delta + m4_1_minus_ea_by_e_by_ss*beta_rate_dot_of_place_66 +
        //   m4_ea_by_e_minus_1*beta_rate_dot_of_place_67
        let beta_rate_dot_of_place_68 = beta_rate_dot_of_place_65
            .mul_add(
                minus_1_by_ss,
                beta_rate_dot_of_place_67
                    .mul_add(
                        m4_ea_by_e_minus_1,
                        beta_rate_dot_of_place_66
                            .mul_add(
                                m4_1_minus_ea_by_e_by_ss,
                                weight_36 * sin_gamma_minus_delta,
                            ),
                    ),
            ) + beta_rate_dot_of_place_63;
        // beta_rate_dot_of_place_69 = cos_gamma_minus_delta*beta_rate_dot_of_place_68
        let beta_rate_dot_of_place_69 = beta_rate_dot_of_place_68
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_68_0, sums[79]),
            );
        // beta_rate_dot_of_place_70 = beta_rate_dot_of_place_44 - beta_rate_dot_of_place_69
        let beta_rate_dot_of_place_70 = beta_rate_dot_of_place_44 - beta_rate_dot_of_place_69;
        // beta_rate_dot_of_place_71 = beta_rate_dot_of_place_70/sin_phi_minus_90deg_sq
        let beta_rate_dot_of_place_71 = beta_rate_dot_of_place_70
            .mul_add(
                over_sin_phi_minus_90deg_sq,
                -(sin_phi_minus_90deg_sq.mul_add(beta_rate_dot_of_place_71_0, sums[80])
                    * over_sin_phi_minus_90deg_sq),
            );
        // beta_rate_dot_of_place_72 = sin_omega*beta_rate_dot_of_place_20
        let beta_rate_dot_of_place_72 = beta_rate_dot_of_place_20
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(beta_rate_dot_of_place_20_0, sums[81]),
            );
        // beta_rate_dot_of_place_73 = cos_angle_2*beta_rate_dot_of_place_21
        let beta_rate_dot_of_place_73 = beta_rate_dot_of_place_21
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_21_0, sums[82]),
            );
        // beta_rate_dot_of_place_74 = beta_rate_dot_of_place_72 - beta_rate_dot_of_place_73
        let beta_rate_dot_of_place_74 = -beta_rate_dot_of_place_73 + beta_rate_dot_of_place_72;
        // beta_rate_dot_of_place_75 = beta_rate_dot_of_place_74/cos_omega
        let beta_rate_dot_of_place_75 = beta_rate_dot_of_place_74
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_75_0, sums[83]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_76 = weight_2*sin_omega_cos_angle_2 + weight_37*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_76 = sin_omega_cos_angle_2
            .mul_add(weight_2, weight_37 * sin_gamma_minus_epsilon);
        // beta_rate_dot_of_place_77 = beta_rate_dot_of_place_76*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_77 = beta_rate_dot_of_place_76
            .mul_add(
                sin_angle_cos_angle_inv_0,
                sin_angle_cos_angle_inv.mul_add(beta_rate_dot_of_place_76_0, sums[84]),
            );
        // sin_omega_sin_angle_2 = sin_omega*sin_angle_2
        let sin_omega_sin_angle_2 = sin_angle_2
            .mul_add(sin_omega_0, sin_omega.mul_add(sin_angle_2_0, sums[85]));
        // beta_rate_dot_of_place_78 = cos_angle_2*beta_rate_dot_of_place_3
        let beta_rate_dot_of_place_78 = beta_rate_dot_of_place_3
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_3_0, sums[86]),
            );
        // beta_rate_dot_of_place_79 = weight_38*cos_gamma_minus_epsilon + beta_rate_dot_of_place_75 +
        //   minus_1_by_ss*beta_rate_dot_of_place_77 + weight_25*sin_omega_sin_angle_2 +
        //   m6_1_minus_fa_by_zf*beta_rate_dot_of_place_78
        let beta_rate_dot_of_place_79 = beta_rate_dot_of_place_77
            .mul_add(
                minus_1_by_ss,
                beta_rate_dot_of_place_78
                    .mul_add(
                        m6_1_minus_fa_by_zf,
                        sin_omega_sin_angle_2
                            .mul_add(weight_25, weight_38 * cos_gamma_minus_epsilon),
                    ),
            ) + beta_rate_dot_of_place_75;
        // beta_rate_dot_of_place_80 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_79
        let beta_rate_dot_of_place_80 = beta_rate_dot_of_place_79
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_79_0, sums[87]),
            );
        // beta_rate_dot_of_place_81 = beta_rate_dot_of_place_27 - beta_rate_dot_of_place_80
        let beta_rate_dot_of_place_81 = beta_rate_dot_of_place_27 - beta_rate_dot_of_place_80;
        // beta_rate_dot_of_place_82 = beta_rate_dot_of_place_81/cos_omega_sq
        let beta_rate_dot_of_place_82 = beta_rate_dot_of_place_81
            .mul_add(
                over_cos_omega_sq,
                -(cos_omega_sq.mul_add(beta_rate_dot_of_place_82_0, sums[88]) * over_cos_omega_sq),
            );
        // beta_rate_dot_of_place_83 = weight_39*sin_angle_cos_angle_inv + beta_rate_dot_of_place_71 +
        //   beta_rate_dot_of_place_82
        let beta_rate_dot_of_place_83 = weight_39 * sin_angle_cos_angle_inv
            + beta_rate_dot_of_place_71 + beta_rate_dot_of_place_82;
        // beta_rate_dot_of_place_84 = sin_theta*beta_rate_dot_of_place_83
        let beta_rate_dot_of_place_84 = beta_rate_dot_of_place_83
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_83_0, sums[89]),
            );
        // beta_rate_dot_of_place_85 = weight_40*beta_rate_dot_of_place_46 - beta_rate_dot_of_place_84
        let beta_rate_dot_of_place_85 = weight_40 * beta_rate_dot_of_place_46
            - beta_rate_dot_of_place_84;
        // beta_rate_dot_of_place_86 = sin_theta*beta_rate_dot_of_place_85
        let beta_rate_dot_of_place_86 = beta_rate_dot_of_place_85
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_85_0, sums[90]),
            );
        // beta_rate_dot_of_place_87 = weight_40*beta_rate_dot_of_place_50 + beta_rate_dot_of_place_86
        let beta_rate_dot_of_place_87 = weight_40 * beta_rate_dot_of_place_50
            + beta_rate_dot_of_place_86;
        // beta_rate_dot_of_place_88 = beta_rate_dot_of_place_87/cos_angle
        let beta_rate_dot_of_place_88 = beta_rate_dot_of_place_87
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_88_0, sums[91]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_89 = m2_da_rr_by_d_2*cos_beta_minus_gamma_sq - beta_rate_dot_of_place_52
        //   + rr*beta_rate_dot_of_place_88
        let beta_rate_dot_of_place_89 = beta_rate_dot_of_place_88
            .mul_add(
                rr,
                m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq - beta_rate_dot_of_place_52,
            );
        // beta_rate_dot_of_place_90 = beta_rate_dot_of_place_89/cos_angle
        let beta_rate_dot_of_place_90 = beta_rate_dot_of_place_89
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_90_0, sums[92]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_91 = m2_da_by_d*cos_beta_minus_gamma - beta_rate_dot_of_place_90
        let beta_rate_dot_of_place_91 = m2_da_by_d * cos_beta_minus_gamma
            - beta_rate_dot_of_place_90;
        // beta_rate_dot_of_beta_rate_2 = beta_rate_dot_of_place_91*beta_rate_sq
        let beta_rate_dot_of_beta_rate_2 = beta_rate_dot_of_place_91
            .mul_add(
                beta_rate_sq_0,
                beta_rate_sq.mul_add(beta_rate_dot_of_place_91_0, sums[93]),
            );
        // beta_rate_dot_of_place_92 = weight_41*cos_gamma + weight_42*sin_gamma
        let beta_rate_dot_of_place_92 = sin_gamma
            .mul_add(weight_42, weight_41 * cos_gamma);
        // beta_rate_dot_of_place_93 = beta_rate_dot_of_place_2*beta_rate_dot_of_place_92
        let beta_rate_dot_of_place_93 = beta_rate_dot_of_place_2
            .mul_add(
                beta_rate_dot_of_place_92_0,
                beta_rate_dot_of_place_92.mul_add(beta_rate_dot_of_place_2_0, sums[94]),
            );
        // beta_rate_dot_of_place_94 = beta_rate_dot_of_place_93 + weight_43*cos_gamma +
        //   weight_44*sin_gamma
        let beta_rate_dot_of_place_94 = sin_gamma
            .mul_add(weight_44, weight_43 * cos_gamma) + beta_rate_dot_of_place_93;
        // beta_rate_dot_of_place_95 = beta_rate_dot_of_place_2/beta_rate_dot_of_place
        let beta_rate_dot_of_place_95 = beta_rate_dot_of_place_2
            .mul_add(
                over_beta_rate_dot_of_place,
                -(beta_rate_dot_of_place.mul_add(beta_rate_dot_of_place_95_0, sums[95])
                    * over_beta_rate_dot_of_place),
            );
        // beta_rate_dot_of_place_96 = beta_rate_dot_of_place_94*beta_rate_dot_of_place_95
        let beta_rate_dot_of_place_96 = beta_rate_dot_of_place_94
            .mul_add(
                beta_rate_dot_of_place_95_0,
                beta_rate_dot_of_place_95.mul_add(beta_rate_dot_of_place_94_0, sums[96]),
            );
        // beta_rate_dot_of_beta_rate_3 = rr*beta_rate_dot_of_beta_rate_2 +
        //   minus_c0_by_ss*beta_rate_dot_of_place_96
        let beta_rate_dot_of_beta_rate_3 = beta_rate_dot_of_beta_rate_2
            .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_96);
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
        // beta_rate_dot_2 = beta_rate_dot_of_beta_rate_7/d1_of_place_20
        let beta_rate_dot_2 = beta_rate_dot_of_beta_rate_7
            .mul_add(
                over_d1_of_place_20,
                -(d1_of_place_20.mul_add(beta_rate_dot_2_0, sums[99]) * over_d1_of_place_20),
            );
        // theta_of_place = -1 + rr_by_d*beta_rate_dot_of_place_53
        let theta_of_place = rr_by_d * beta_rate_dot_of_place_53;
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
        // delta_of_beta_rate = gamma_of_beta_rate*beta_rate_dot_of_place_7
        let delta_of_beta_rate = gamma_of_beta_rate
            .mul_add(
                beta_rate_dot_of_place_7_0,
                beta_rate_dot_of_place_7.mul_add(gamma_of_beta_rate_0, sums[103]),
            );
        // phi_minus_90deg_of_place = beta_rate_dot_of_place_9/sin_phi_minus_90deg
        let phi_minus_90deg_of_place = beta_rate_dot_of_place_9
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(phi_minus_90deg_of_place_0, sums[104])
                    * over_sin_phi_minus_90deg),
            );
        // phi_minus_90deg_of_beta_rate = gamma_of_beta_rate*phi_minus_90deg_of_place
        let phi_minus_90deg_of_beta_rate = phi_minus_90deg_of_place
            .mul_add(
                gamma_of_beta_rate_0,
                gamma_of_beta_rate.mul_add(phi_minus_90deg_of_place_0, sums[105]),
            );
        // epsilon_of_beta_rate = gamma_of_beta_rate*beta_rate_dot_of_place_4
        let epsilon_of_beta_rate = gamma_of_beta_rate
            .mul_add(
                beta_rate_dot_of_place_4_0,
                beta_rate_dot_of_place_4.mul_add(gamma_of_beta_rate_0, sums[106]),
            );
        // omega_of_place = beta_rate_dot_of_place_3/cos_omega
        let omega_of_place = beta_rate_dot_of_place_3
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
        phi_minus_90deg_rate = minus_rr * phi_minus_90deg_of_beta_rate;
        epsilon_rate = rr_by_u * epsilon_of_beta_rate;
        omega_rate = minus_rr * omega_of_beta_rate;
        beta_rate_rate = beta_rate_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                count * omega,
                count * omega,
                count * d1_of_place,
                count * d1_of_place,
                count * beta_minus_gamma,
                count * beta_minus_gamma,
                count * gamma_minus_delta,
                count * gamma_minus_delta,
                count * d1_of_place_2,
                count * d1_of_place_2,
                count * gamma_minus_epsilon,
                count * gamma_minus_epsilon,
                cos_beta_minus_gamma, cos_theta,
                count * phi_minus_90deg,
                count * phi_minus_90deg,
                count * d1_of_place_4,
                count * d1_of_place_4,
                sin_omega, sin_gamma_minus_epsilon, cos_angle_2, cos_omega, cos_omega_sq,
                cos_phi_minus_90deg, cos_gamma_minus_delta, cos_angle_3, sin_phi_minus_90deg,
                sin_phi_minus_90deg_sq, sin_theta, d1_of_place_14, cos_angle, cos_angle,
                count * gamma,
                count * gamma,
                beta_rate_dot_of_place_2, cos_omega, cos_angle, cos_theta, sin_phi_minus_90deg,
                cos_angle_2, sin_gamma_minus_epsilon, cos_angle_2, sin_gamma_minus_epsilon,
                cos_omega, sin_gamma_minus_epsilon, cos_omega, beta_rate_dot_of_place_5,
                cos_angle_2, sin_omega, cos_angle_2, cos_angle_3, cos_gamma_minus_delta,
                cos_angle_3, cos_gamma_minus_delta, sin_phi_minus_90deg, cos_gamma_minus_delta,
                sin_phi_minus_90deg, beta_rate_dot_of_place_8, cos_angle_3, sin_gamma_minus_delta,
                cos_angle_3, cos_beta_minus_gamma, d1_of_place_14, cos_theta, cos_beta_minus_gamma,
                cos_theta, cos_angle, beta_rate_dot_of_place_54, beta_rate_dot_of_place_56,
                beta_rate, beta_rate_dot_of_place_58, cos_phi_minus_90deg, cos_angle_3,
                sin_phi_minus_90deg, beta_rate_dot_of_place_64, cos_phi_minus_90deg, cos_angle_3,
                cos_gamma_minus_delta, sin_phi_minus_90deg_sq, sin_omega, cos_angle_2, cos_omega,
                beta_rate_dot_of_place_76, sin_omega, cos_angle_2, sin_gamma_minus_epsilon,
                cos_omega_sq, sin_theta, sin_theta, cos_angle, cos_angle, beta_rate_dot_of_place_91,
                beta_rate_dot_of_place_2, beta_rate_dot_of_place, beta_rate_dot_of_place_94,
                sin_theta, cos_angle, d1_of_place_20, beta_rate, beta_rate, cos_angle,
                gamma_of_beta_rate, sin_phi_minus_90deg, gamma_of_beta_rate, gamma_of_beta_rate,
                cos_omega, gamma_of_beta_rate,
            ]),
            padded([
                cos_theta, sin_theta, cos_omega, sin_omega, cos_angle, sin_angle,
                cos_beta_minus_gamma, sin_beta_minus_gamma, cos_gamma_minus_delta,
                sin_gamma_minus_delta, cos_angle_2, sin_angle_2, cos_gamma_minus_epsilon,
                sin_gamma_minus_epsilon, cos_beta_minus_gamma, cos_beta_minus_gamma,
                cos_phi_minus_90deg, sin_phi_minus_90deg, cos_angle_3, sin_angle_3, cos_angle_2,
                d1_of_place_5, cos_angle_2, cos_omega, d1_of_place_8, cos_angle_3, d1_of_place_10,
                cos_angle_3, sin_phi_minus_90deg, d1_of_place_13, sin_theta, sin_theta_sq,
                d1_of_place_17, d1_of_place_19, cos_gamma, sin_gamma, beta_rate_dot_of_place_2,
                beta_rate_dot_of_place_4, sin_angle_cos_angle_inv, sin_beta_minus_gamma,
                beta_rate_dot_of_place_7, beta_rate_dot_of_place_10, beta_rate_dot_of_place_12,
                beta_rate_dot_of_place_14, sin_gamma_minus_epsilon, beta_rate_dot_of_place_18,
                sin_angle_2, sin_omega_cos_omega_inv, sin_omega_cos_omega_inv,
                beta_rate_dot_of_place_23, cos_gamma_minus_epsilon, beta_rate_dot_of_place_26,
                beta_rate_dot_of_place_28, beta_rate_dot_of_place_30, beta_rate_dot_of_place_32,
                cos_gamma_minus_delta, beta_rate_dot_of_place_35, sin_angle_3,
                beta_rate_dot_of_place_38, beta_rate_dot_of_place_38, beta_rate_dot_of_place_40,
                cos_phi_minus_90deg, beta_rate_dot_of_place_43, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_45, beta_rate_dot_of_place_47, beta_rate_dot_of_place_49,
                beta_rate_dot_of_place_51, beta_rate_dot_of_place_53, beta_rate_dot_of_place_45,
                beta_rate_dot_of_place_53, beta_rate, beta_rate_sq, beta_rate_dot_of_place_37,
                beta_rate_dot_of_place_60, beta_rate_dot_of_place_63, sin_angle_cos_angle_inv,
                sin_angle_3, beta_rate_dot_of_place_9, beta_rate_dot_of_place_68,
                beta_rate_dot_of_place_71, beta_rate_dot_of_place_20, beta_rate_dot_of_place_21,
                beta_rate_dot_of_place_75, sin_angle_cos_angle_inv, sin_angle_2,
                beta_rate_dot_of_place_3, beta_rate_dot_of_place_79, beta_rate_dot_of_place_82,
                beta_rate_dot_of_place_83, beta_rate_dot_of_place_85, beta_rate_dot_of_place_88,
                beta_rate_dot_of_place_90, beta_rate_sq, beta_rate_dot_of_place_92,
                beta_rate_dot_of_place_95, beta_rate_dot_of_place_95, beta_rate_dot_of_beta_rate_3,
                beta_rate_dot_of_beta_rate_6, beta_rate_dot_2, theta_of_place, sin_theta,
                gamma_of_beta_rate, beta_rate_dot_of_place_7, phi_minus_90deg_of_place,
                phi_minus_90deg_of_place, beta_rate_dot_of_place_4, omega_of_place, omega_of_place,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        gamma_last = gamma;
        phi_minus_90deg_last = phi_minus_90deg;
        omega_last = omega;
        beta_rate_last = beta_rate;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        sin_omega_last = sin_omega;
        cos_omega_last = cos_omega;
        beta_minus_gamma_last = beta_minus_gamma;
        d1_of_place_last = d1_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_beta_minus_gamma_last = sin_beta_minus_gamma;
        cos_beta_minus_gamma_last = cos_beta_minus_gamma;
        gamma_minus_delta_last = gamma_minus_delta;
        sin_gamma_minus_delta_last = sin_gamma_minus_delta;
        cos_gamma_minus_delta_last = cos_gamma_minus_delta;
        d1_of_place_2_last = d1_of_place_2;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        gamma_minus_epsilon_last = gamma_minus_epsilon;
        sin_gamma_minus_epsilon_last = sin_gamma_minus_epsilon;
        cos_gamma_minus_epsilon_last = cos_gamma_minus_epsilon;
        sin_phi_minus_90deg_last = sin_phi_minus_90deg;
        cos_phi_minus_90deg_last = cos_phi_minus_90deg;
        d1_of_place_4_last = d1_of_place_4;
        sin_angle_3_last = sin_angle_3;
        cos_angle_3_last = cos_angle_3;
        d1_of_place_5_last = d1_of_place_5;
        cos_omega_sq_last = cos_omega_sq;
        d1_of_place_8_last = d1_of_place_8;
        d1_of_place_10_last = d1_of_place_10;
        sin_phi_minus_90deg_sq_last = sin_phi_minus_90deg_sq;
        d1_of_place_13_last = d1_of_place_13;
        d1_of_place_14_last = d1_of_place_14;
        sin_theta_sq_last = sin_theta_sq;
        d1_of_place_17_last = d1_of_place_17;
        d1_of_place_19_last = d1_of_place_19;
        d1_of_place_20_last = d1_of_place_20;
        sin_gamma_last = sin_gamma;
        cos_gamma_last = cos_gamma;
        beta_rate_dot_of_place_last = beta_rate_dot_of_place;
        beta_rate_dot_of_place_2_last = beta_rate_dot_of_place_2;
        beta_rate_dot_of_place_3_last = beta_rate_dot_of_place_3;
        beta_rate_dot_of_place_4_last = beta_rate_dot_of_place_4;
        beta_rate_dot_of_place_5_last = beta_rate_dot_of_place_5;
        sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv;
        beta_rate_dot_of_place_7_last = beta_rate_dot_of_place_7;
        beta_rate_dot_of_place_8_last = beta_rate_dot_of_place_8;
        beta_rate_dot_of_place_9_last = beta_rate_dot_of_place_9;
        beta_rate_dot_of_place_10_last = beta_rate_dot_of_place_10;
        beta_rate_dot_of_place_12_last = beta_rate_dot_of_place_12;
        beta_rate_dot_of_place_14_last = beta_rate_dot_of_place_14;
        beta_rate_dot_of_place_18_last = beta_rate_dot_of_place_18;
        beta_rate_dot_of_place_20_last = beta_rate_dot_of_place_20;
        beta_rate_dot_of_place_21_last = beta_rate_dot_of_place_21;
        sin_omega_cos_omega_inv_last = sin_omega_cos_omega_inv;
        beta_rate_dot_of_place_23_last = beta_rate_dot_of_place_23;
        beta_rate_dot_of_place_26_last = beta_rate_dot_of_place_26;
        beta_rate_dot_of_place_28_last = beta_rate_dot_of_place_28;
        beta_rate_dot_of_place_30_last = beta_rate_dot_of_place_30;
        beta_rate_dot_of_place_32_last = beta_rate_dot_of_place_32;
        beta_rate_dot_of_place_35_last = beta_rate_dot_of_place_35;
        beta_rate_dot_of_place_37_last = beta_rate_dot_of_place_37;
        beta_rate_dot_of_place_38_last = beta_rate_dot_of_place_38;
        beta_rate_dot_of_place_40_last = beta_rate_dot_of_place_40;
        beta_rate_dot_of_place_43_last = beta_rate_dot_of_place_43;
        beta_rate_dot_of_place_45_last = beta_rate_dot_of_place_45;
        beta_rate_dot_of_place_47_last = beta_rate_dot_of_place_47;
        beta_rate_dot_of_place_49_last = beta_rate_dot_of_place_49;
        beta_rate_dot_of_place_51_last = beta_rate_dot_of_place_51;
        beta_rate_dot_of_place_53_last = beta_rate_dot_of_place_53;
        beta_rate_dot_of_place_54_last = beta_rate_dot_of_place_54;
        beta_rate_dot_of_place_56_last = beta_rate_dot_of_place_56;
        beta_rate_dot_of_place_58_last = beta_rate_dot_of_place_58;
        beta_rate_sq_last = beta_rate_sq;
        beta_rate_dot_of_place_60_last = beta_rate_dot_of_place_60;
        beta_rate_dot_of_place_63_last = beta_rate_dot_of_place_63;
        beta_rate_dot_of_place_64_last = beta_rate_dot_of_place_64;
        beta_rate_dot_of_place_68_last = beta_rate_dot_of_place_68;
        beta_rate_dot_of_place_71_last = beta_rate_dot_of_place_71;
        beta_rate_dot_of_place_75_last = beta_rate_dot_of_place_75;
        beta_rate_dot_of_place_76_last = beta_rate_dot_of_place_76;
        beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79;
        beta_rate_dot_of_place_82_last = beta_rate_dot_of_place_82;
        beta_rate_dot_of_place_83_last = beta_rate_dot_of_place_83;
        beta_rate_dot_of_place_85_last = beta_rate_dot_of_place_85;
        beta_rate_dot_of_place_88_last = beta_rate_dot_of_place_88;
        beta_rate_dot_of_place_90_last = beta_rate_dot_of_place_90;
        beta_rate_dot_of_place_91_last = beta_rate_dot_of_place_91;
        beta_rate_dot_of_place_92_last = beta_rate_dot_of_place_92;
        beta_rate_dot_of_place_94_last = beta_rate_dot_of_place_94;
        beta_rate_dot_of_place_95_last = beta_rate_dot_of_place_95;
        beta_rate_dot_of_beta_rate_3_last = beta_rate_dot_of_beta_rate_3;
        beta_rate_dot_of_beta_rate_6_last = beta_rate_dot_of_beta_rate_6;
        beta_rate_dot_2_last = beta_rate_dot_2;
        theta_of_place_last = theta_of_place;
        gamma_of_beta_rate_last = gamma_of_beta_rate;
        phi_minus_90deg_of_place_last = phi_minus_90deg_of_place;
        omega_of_place_last = omega_of_place;
    }
}

/// Kane's method in phi-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct KanePhi90deg;

impl<S: Scalar> System<S> for KanePhi90deg {
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
        let x = &mut x.as_chunks_mut().0[..=order];
        taylor(&Parameters::from_slice(p), x, rows(work));
    }
    fn divisor_count(&self) -> usize {
        4
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "cos(beta + theta - gamma)",
            "cos(omega)",
            "divisor 3 of the accelerations",
            "sin(phi_minus_90deg)",
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
