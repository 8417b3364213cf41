//! Andrews' squeezing mechanism: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows beta, theta, gamma, delta, phi, epsilon, omega, constraint E3_1, constraint E3_2, constraint E4_1, constraint E4_2, constraint E6_1, constraint E6_2.
///
/// 118 operations, 7 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    _q_dot: &[S; 7],
) -> [[S; 13]; 13] {
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
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    // I2 + m2*da^2
    let i2_plus_m2_da_sq = I2 + m2 * da * da;
    let m2_rr = m2 * rr;
    let da_cos_theta_m2_rr = da * m2_rr * cos_theta;
    // da_cos_theta_m2_rr - i2_plus_m2_da_sq
    let m_1_2_of_place = da_cos_theta_m2_rr - i2_plus_m2_da_sq;
    // cos(beta)*sin(theta) + sin(beta)*cos(theta)
    let sin_beta_plus_theta = sin_beta.mul_add(cos_theta, cos_beta * sin_theta);
    let d_sin_beta_plus_theta = d * sin_beta_plus_theta;
    // rr*sin(beta) - d_sin_beta_plus_theta
    let m_1_8_of_place = rr.mul_add(sin_beta, -d_sin_beta_plus_theta);
    // cos(beta)*cos(theta) - sin(beta)*sin(theta)
    let cos_beta_plus_theta = (-sin_beta).mul_add(sin_theta, cos_beta * cos_theta);
    let d_cos_beta_plus_theta = d * cos_beta_plus_theta;
    // rr*cos(beta) - d_cos_beta_plus_theta
    let m_1_9_of_place = rr.mul_add(cos_beta, -d_cos_beta_plus_theta);
    let ss_cos_gamma = ss * cos_gamma;
    let ss_sin_gamma = ss * sin_gamma;
    // I4 + m4*(ea^2 + e*(e - 2*ea))
    let m_4_4_of_m4_i4_e_ea = I4 + m4 * (e * (-ea).mul_add(S::int(2), e) + ea * ea);
    let m4_zt = m4 * zt;
    // m4_zt*sin(phi)*(e - ea)
    let m_4_4_of_place = m4_zt * sin_phi * (e - ea);
    // m_4_4_of_m4_i4_e_ea + m_4_4_of_place
    let m_4_5_of_place = m_4_4_of_m4_i4_e_ea + m_4_4_of_place;
    // cos(delta)*cos(phi) - sin(delta)*sin(phi)
    let cos_delta_plus_phi = (-sin_delta).mul_add(sin_phi, cos_delta * cos_phi);
    let e_cos_delta_plus_phi = e * cos_delta_plus_phi;
    // zt*sin(delta) - e_cos_delta_plus_phi
    let m_4_10_of_place = zt.mul_add(sin_delta, -e_cos_delta_plus_phi);
    // cos(delta)*sin(phi) + sin(delta)*cos(phi)
    let sin_delta_plus_phi = sin_delta.mul_add(cos_phi, cos_delta * sin_phi);
    let e_sin_delta_plus_phi = e * sin_delta_plus_phi;
    // zt*cos(delta) + e_sin_delta_plus_phi
    let m_4_11_of_place = zt.mul_add(cos_delta, e_sin_delta_plus_phi);
    // I6 + m6*(fa^2 + zf*(zf - 2*fa))
    let m_6_6_of_m6_i6_zf_fa = I6 + m6 * (zf * (-fa).mul_add(S::int(2), zf) + fa * fa);
    let m6_u_2 = m6 * u_2;
    // m6_u_2*sin(omega)*(zf - fa)
    let m_6_6_of_place = m6_u_2 * sin_omega * (zf - fa);
    // m_6_6_of_place - m_6_6_of_m6_i6_zf_fa
    let m_6_7_of_place = m_6_6_of_place - m_6_6_of_m6_i6_zf_fa;
    // cos(epsilon)*sin(omega) + sin(epsilon)*cos(omega)
    let sin_epsilon_plus_omega = sin_epsilon.mul_add(cos_omega, cos_epsilon * sin_omega);
    let m_6_12_of_place = zf * sin_epsilon_plus_omega;
    // u*cos(epsilon) - m_6_12_of_place
    let m_6_12_of_place_2 = u_2.mul_add(cos_epsilon, -m_6_12_of_place);
    // cos(epsilon)*cos(omega) - sin(epsilon)*sin(omega)
    let cos_epsilon_plus_omega = (-sin_epsilon)
        .mul_add(sin_omega, cos_epsilon * cos_omega);
    let m_6_13_of_place = zf * cos_epsilon_plus_omega;
    // u*sin(epsilon) + m_6_13_of_place
    let m_6_13_of_place_2 = u_2.mul_add(sin_epsilon, m_6_13_of_place);
    // -m_1_2_of_place
    let minus_m_1_2_of_place = -m_1_2_of_place;
    // -m_1_8_of_place
    let minus_m_1_8_of_place = -m_1_8_of_place;
    // -d_cos_beta_plus_theta
    let m_2_9_of_d_beta_theta = -d_cos_beta_plus_theta;
    // -m_6_7_of_place
    let minus_m_6_7_of_place = -m_6_7_of_place;
    // -d_sin_beta_plus_theta
    let m_8_2_of_d_beta_theta = -d_sin_beta_plus_theta;
    // -m_1_9_of_place
    let minus_m_1_9_of_place = -m_1_9_of_place;
    // Entries that are not zero.
    // M_1_1 = I1 + I2 + m1*ra^2 + m2*(rr^2 + da*(da - 2*rr*cos(theta)))
    let m_1_1 = rr.mul_add(m2_rr, I1 + m1 * ra * ra + i2_plus_m2_da_sq)
        - S::int(2) * da_cos_theta_m2_rr;
    // M_1_2 = I2 + m2*da*(da - rr*cos(theta))
    let m_1_2 = minus_m_1_2_of_place;
    // M_1_8 = d*sin(beta + theta) - rr*sin(beta)
    let m_1_8 = minus_m_1_8_of_place;
    // M_1_9 = rr*cos(beta) - d*cos(beta + theta)
    let m_1_9 = m_1_9_of_place;
    // M_1_10 = d*sin(beta + theta) - rr*sin(beta)
    let m_1_10 = minus_m_1_8_of_place;
    // M_1_11 = rr*cos(beta) - d*cos(beta + theta)
    let m_1_11 = m_1_9_of_place;
    // M_1_12 = d*sin(beta + theta) - rr*sin(beta)
    let m_1_12 = minus_m_1_8_of_place;
    // M_1_13 = rr*cos(beta) - d*cos(beta + theta)
    let m_1_13 = m_1_9_of_place;
    // M_2_1 = I2 + m2*da*(da - rr*cos(theta))
    let m_2_1 = minus_m_1_2_of_place;
    // M_2_2 = I2 + m2*da^2
    let m_2_2 = i2_plus_m2_da_sq;
    // M_2_8 = d*sin(beta + theta)
    let m_2_8 = d_sin_beta_plus_theta;
    // M_2_9 = -d*cos(beta + theta)
    let m_2_9 = m_2_9_of_d_beta_theta;
    // M_2_10 = d*sin(beta + theta)
    let m_2_10 = d_sin_beta_plus_theta;
    // M_2_11 = -d*cos(beta + theta)
    let m_2_11 = m_2_9_of_d_beta_theta;
    // M_2_12 = d*sin(beta + theta)
    let m_2_12 = d_sin_beta_plus_theta;
    // M_2_13 = -d*cos(beta + theta)
    let m_2_13 = m_2_9_of_d_beta_theta;
    // M_3_3 = I3 + m3*(sa^2 + sb^2)
    let m_3_3 = I3 + m3 * sb.mul_add(sb, sa * sa);
    // M_3_8 = -ss*cos(gamma)
    let m_3_8 = -ss_cos_gamma;
    // M_3_9 = -ss*sin(gamma)
    let m_3_9 = -ss_sin_gamma;
    // M_4_4 = I4 + I5 + m5*(ta^2 + tb^2) + m4*((e - ea)^2 + zt*(zt + 2*sin(phi)*(e - ea)))
    let m_4_4 = I5 + m5 * tb.mul_add(tb, ta * ta) + m_4_4_of_m4_i4_e_ea + zt * m4_zt
        + S::int(2) * m_4_4_of_place;
    // M_4_5 = I4 + m4*(e - ea)*(e - ea + zt*sin(phi))
    let m_4_5 = m_4_5_of_place;
    // M_4_10 = zt*sin(delta) - e*cos(delta + phi)
    let m_4_10 = m_4_10_of_place;
    // M_4_11 = -zt*cos(delta) - e*sin(delta + phi)
    let m_4_11 = -m_4_11_of_place;
    // M_5_4 = I4 + m4*(e - ea)*(e - ea + zt*sin(phi))
    let m_5_4 = m_4_5_of_place;
    // M_5_5 = I4 + m4*(e - ea)^2
    let m_5_5 = m_4_4_of_m4_i4_e_ea;
    // M_5_10 = -e*cos(delta + phi)
    let m_5_10 = -e_cos_delta_plus_phi;
    // M_5_11 = -e*sin(delta + phi)
    let m_5_11 = -e_sin_delta_plus_phi;
    // M_6_6 = I6 + I7 + m7*(ua^2 + ub^2) + m6*((zf - fa)^2 + u*(u + 2*sin(omega)*(fa - zf)))
    let m_6_6 = I7 + m7 * ub.mul_add(ub, ua * ua) + m_6_6_of_m6_i6_zf_fa + u_2 * m6_u_2
        - S::int(2) * m_6_6_of_place;
    // M_6_7 = I6 + m6*(zf - fa)*(zf - fa - u*sin(omega))
    let m_6_7 = minus_m_6_7_of_place;
    // M_6_12 = zf*sin(epsilon + omega) - u*cos(epsilon)
    let m_6_12 = -m_6_12_of_place_2;
    // M_6_13 = -u*sin(epsilon) - zf*cos(epsilon + omega)
    let m_6_13 = -m_6_13_of_place_2;
    // M_7_6 = I6 + m6*(zf - fa)*(zf - fa - u*sin(omega))
    let m_7_6 = minus_m_6_7_of_place;
    // M_7_7 = I6 + m6*(zf - fa)^2
    let m_7_7 = m_6_6_of_m6_i6_zf_fa;
    // M_7_12 = zf*sin(epsilon + omega)
    let m_7_12 = m_6_12_of_place;
    // M_7_13 = -zf*cos(epsilon + omega)
    let m_7_13 = -m_6_13_of_place;
    // M_8_1 = rr*sin(beta) - d*sin(beta + theta)
    let m_8_1 = m_1_8_of_place;
    // M_8_2 = -d*sin(beta + theta)
    let m_8_2 = m_8_2_of_d_beta_theta;
    // M_8_3 = ss*cos(gamma)
    let m_8_3 = ss_cos_gamma;
    // M_9_1 = d*cos(beta + theta) - rr*cos(beta)
    let m_9_1 = minus_m_1_9_of_place;
    // M_9_2 = d*cos(beta + theta)
    let m_9_2 = d_cos_beta_plus_theta;
    // M_9_3 = ss*sin(gamma)
    let m_9_3 = ss_sin_gamma;
    // M_10_1 = rr*sin(beta) - d*sin(beta + theta)
    let m_10_1 = m_1_8_of_place;
    // M_10_2 = -d*sin(beta + theta)
    let m_10_2 = m_8_2_of_d_beta_theta;
    // M_10_4 = e*cos(delta + phi) - zt*sin(delta)
    let m_10_4 = -m_4_10_of_place;
    // M_10_5 = e*cos(delta + phi)
    let m_10_5 = e_cos_delta_plus_phi;
    // M_11_1 = d*cos(beta + theta) - rr*cos(beta)
    let m_11_1 = minus_m_1_9_of_place;
    // M_11_2 = d*cos(beta + theta)
    let m_11_2 = d_cos_beta_plus_theta;
    // M_11_4 = zt*cos(delta) + e*sin(delta + phi)
    let m_11_4 = m_4_11_of_place;
    // M_11_5 = e*sin(delta + phi)
    let m_11_5 = e_sin_delta_plus_phi;
    // M_12_1 = rr*sin(beta) - d*sin(beta + theta)
    let m_12_1 = m_1_8_of_place;
    // M_12_2 = -d*sin(beta + theta)
    let m_12_2 = m_8_2_of_d_beta_theta;
    // M_12_6 = u*cos(epsilon) - zf*sin(epsilon + omega)
    let m_12_6 = m_6_12_of_place_2;
    // M_12_7 = -zf*sin(epsilon + omega)
    let m_12_7 = -m_6_12_of_place;
    // M_13_1 = d*cos(beta + theta) - rr*cos(beta)
    let m_13_1 = minus_m_1_9_of_place;
    // M_13_2 = d*cos(beta + theta)
    let m_13_2 = d_cos_beta_plus_theta;
    // M_13_6 = u*sin(epsilon) + zf*cos(epsilon + omega)
    let m_13_6 = m_6_13_of_place_2;
    // M_13_7 = zf*cos(epsilon + omega)
    let m_13_7 = m_6_13_of_place;
    let zero = S::int(0);
    [
        [
            m_1_1, m_1_2, zero, zero, zero, zero, zero, m_1_8, m_1_9, m_1_10, m_1_11, m_1_12,
            m_1_13,
        ],
        [
            m_2_1, m_2_2, zero, zero, zero, zero, zero, m_2_8, m_2_9, m_2_10, m_2_11, m_2_12,
            m_2_13,
        ],
        [
            zero, zero, m_3_3, zero, zero, zero, zero, m_3_8, m_3_9, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, m_4_4, m_4_5, zero, zero, zero, zero, m_4_10, m_4_11, zero, zero,
        ],
        [
            zero, zero, zero, m_5_4, m_5_5, zero, zero, zero, zero, m_5_10, m_5_11, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, m_6_6, m_6_7, zero, zero, zero, zero, m_6_12, m_6_13,
        ],
        [
            zero, zero, zero, zero, zero, m_7_6, m_7_7, zero, zero, zero, zero, m_7_12, m_7_13,
        ],
        [
            m_8_1, m_8_2, m_8_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_9_1, m_9_2, m_9_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_10_1, m_10_2, zero, m_10_4, m_10_5, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_11_1, m_11_2, zero, m_11_4, m_11_5, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_12_1, m_12_2, zero, zero, zero, m_12_6, m_12_7, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_13_1, m_13_2, zero, zero, zero, m_13_6, m_13_7, zero, zero, zero, zero, zero, zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (beta'', theta'', gamma'', delta'', phi'', epsilon'', omega'', lambda_E3_1, lambda_E3_2, lambda_E4_1, lambda_E4_2, lambda_E6_1, lambda_E6_2).
///
/// 131 operations, 7 sines and cosines, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 7], q_dot: &[S; 7]) -> [S; 13] {
    let Parameters {
        m2, m4, m6, xb, yb, xc, yc, c0, l0, d, da, e, ea, rr, ss, sc, sd, zt,
        u: u_2,
        zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    let m2_da_sin_theta = m2 * da * sin_theta;
    let rr_beta_dot_sq = rr * beta_dot * beta_dot;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // sc*sin(gamma) + sd*cos(gamma)
    let f_3_of_sc_sd_gamma = sd.mul_add(cos_gamma, sc * sin_gamma);
    // yb - yc
    let yb_minus_yc = yb - yc;
    // sd*sin(gamma) - sc*cos(gamma)
    let f_3_of_sc_sd_gamma_2 = (-sc).mul_add(cos_gamma, sd * sin_gamma);
    // m4*cos(phi)*(e - ea)
    let f_4_of_m4_e_ea_phi = m4 * cos_phi * (e - ea);
    let zt_delta_dot_sq = zt * delta_dot * delta_dot;
    // m6*cos(omega)*(zf - fa)
    let f_6_of_place = m6 * cos_omega * (zf - fa);
    let u_2_epsilon_dot_sq = u_2 * epsilon_dot * epsilon_dot;
    // cos(beta)*cos(theta) - sin(beta)*sin(theta)
    let cos_beta_plus_theta = (-sin_beta).mul_add(sin_theta, cos_beta * cos_theta);
    // beta' + theta'
    let beta_dot_plus_theta_dot = beta_dot + theta_dot;
    let f_8_of_motion = d * beta_dot_plus_theta_dot * beta_dot_plus_theta_dot;
    // rr_beta_dot_sq*cos(beta) - cos(beta + theta)*f_8_of_motion
    let f_8_of_motion_2 = (-cos_beta_plus_theta)
        .mul_add(f_8_of_motion, rr_beta_dot_sq * cos_beta);
    let ss_gamma_dot_sq = ss * gamma_dot * gamma_dot;
    // cos(beta)*sin(theta) + sin(beta)*cos(theta)
    let sin_beta_plus_theta = sin_beta.mul_add(cos_theta, cos_beta * sin_theta);
    // rr_beta_dot_sq*sin(beta) - sin(beta + theta)*f_8_of_motion
    let f_9_of_motion = (-sin_beta_plus_theta)
        .mul_add(f_8_of_motion, rr_beta_dot_sq * sin_beta);
    // cos(delta)*sin(phi) + sin(delta)*cos(phi)
    let sin_delta_plus_phi = sin_delta.mul_add(cos_phi, cos_delta * sin_phi);
    // delta' + phi'
    let delta_dot_plus_phi_dot = delta_dot + phi_dot;
    let f_10_of_motion = e * delta_dot_plus_phi_dot * delta_dot_plus_phi_dot;
    // cos(delta)*cos(phi) - sin(delta)*sin(phi)
    let cos_delta_plus_phi = (-sin_delta).mul_add(sin_phi, cos_delta * cos_phi);
    // cos(epsilon)*cos(omega) - sin(epsilon)*sin(omega)
    let cos_epsilon_plus_omega = (-sin_epsilon)
        .mul_add(sin_omega, cos_epsilon * cos_omega);
    // epsilon' + omega'
    let f_12_of_motion = epsilon_dot + omega_dot;
    let zf_f_12_of_motion_sq = zf * f_12_of_motion * f_12_of_motion;
    // cos(epsilon)*sin(omega) + sin(epsilon)*cos(omega)
    let sin_epsilon_plus_omega = sin_epsilon.mul_add(cos_omega, cos_epsilon * sin_omega);
    let sd_sq = sd * sd;
    let sc_sq = sc * sc;
    // sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
    //   yc)*(sd*sin(gamma) - sc*cos(gamma)))
    let f_3_of_place = (yb_minus_yc.mul_add(yb_minus_yc, xb_minus_xc * xb_minus_xc)
        + sc_sq + sd_sq + S::int(2) * xb_minus_xc * f_3_of_sc_sd_gamma
        + S::int(2) * yb_minus_yc * f_3_of_sc_sd_gamma_2)
        .sqrt();
    // Values.
    // f_1 = mom - m2*da*rr*theta'*sin(theta)*(2*beta' + theta')
    let f_1 = mom - rr * theta_dot * m2_da_sin_theta * beta_dot.mul_add(S::int(2), theta_dot);
    // f_2 = m2*da*rr*beta'^2*sin(theta)
    let f_2 = m2_da_sin_theta * rr_beta_dot_sq;
    // f_3 = c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma))
    //   + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sc*cos(gamma) - sd*sin(gamma))*(l0 - sqrt((xb -
    //   xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
    //   yc)*(sd*sin(gamma) - sc*cos(gamma))))*(xb - xc + sc*sin(gamma) + sd*cos(gamma))/((xb - xc)^2 + (yb -
    //   yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
    //   sc*cos(gamma))) + c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) +
    //   sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sc*sin(gamma) + sd*cos(gamma))*(l0 -
    //   sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
    //   yc)*(sd*sin(gamma) - sc*cos(gamma))))*(yb - yc + sd*sin(gamma) - sc*cos(gamma))/((xb - xc)^2 + (yb -
    //   yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
    //   sc*cos(gamma)))
    let f_3 = c0 * f_3_of_place * (l0 - f_3_of_place)
        * (f_3_of_sc_sd_gamma * (yb_minus_yc + f_3_of_sc_sd_gamma_2)
            - f_3_of_sc_sd_gamma_2 * (xb_minus_xc + f_3_of_sc_sd_gamma))
        / (sc_sq + sd_sq + xb_minus_xc * f_3_of_sc_sd_gamma.mul_add(S::int(2), xb_minus_xc)
            + yb_minus_yc * f_3_of_sc_sd_gamma_2.mul_add(S::int(2), yb_minus_yc));
    // f_4 = m4*zt*phi'*cos(phi)*(ea - e)*(2*delta' + phi')
    let f_4 = -zt * phi_dot * f_4_of_m4_e_ea_phi * delta_dot.mul_add(S::int(2), phi_dot);
    // f_5 = m4*zt*delta'^2*cos(phi)*(e - ea)
    let f_5 = f_4_of_m4_e_ea_phi * zt_delta_dot_sq;
    // f_6 = m6*u*omega'*cos(omega)*(zf - fa)*(2*epsilon' + omega')
    let f_6 = u_2 * omega_dot * f_6_of_place * epsilon_dot.mul_add(S::int(2), omega_dot);
    // f_7 = m6*u*epsilon'^2*cos(omega)*(fa - zf)
    let f_7 = -f_6_of_place * u_2_epsilon_dot_sq;
    // f_8 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + ss*gamma'^2*sin(gamma)
    let f_8 = ss_gamma_dot_sq.mul_add(sin_gamma, -f_8_of_motion_2);
    // f_9 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) - ss*gamma'^2*cos(gamma)
    let f_9 = (-ss_gamma_dot_sq).mul_add(cos_gamma, -f_9_of_motion);
    // f_10 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + zt*delta'^2*cos(delta) +
    //   e*sin(delta + phi)*(delta' + phi')^2
    let f_10 = zt_delta_dot_sq.mul_add(cos_delta, -f_8_of_motion_2)
        + sin_delta_plus_phi * f_10_of_motion;
    // f_11 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) + zt*delta'^2*sin(delta) -
    //   e*cos(delta + phi)*(delta' + phi')^2
    let f_11 = zt_delta_dot_sq.mul_add(sin_delta, -f_9_of_motion)
        - cos_delta_plus_phi * f_10_of_motion;
    // f_12 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + u*epsilon'^2*sin(epsilon) +
    //   zf*cos(epsilon + omega)*(epsilon' + omega')^2
    let f_12 = u_2_epsilon_dot_sq.mul_add(sin_epsilon, -f_8_of_motion_2)
        + cos_epsilon_plus_omega * zf_f_12_of_motion_sq;
    // f_13 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) - u*epsilon'^2*cos(epsilon) +
    //   zf*sin(epsilon + omega)*(epsilon' + omega')^2
    let f_13 = (-u_2_epsilon_dot_sq)
        .mul_add(cos_epsilon, sin_epsilon_plus_omega * zf_f_12_of_motion_sq) - f_9_of_motion;
    [f_1, f_2, f_3, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13]
}

/// The accelerations (beta'', theta'', gamma'', delta'', phi'', epsilon'', omega''), solved for when this code was generated.
///
/// 443 operations, 8 sines and cosines, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    q_dot: &[S; 7],
) -> [S; 7] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_dot, theta_dot, _, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
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
    let m2_da = m2 * da;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // cos(gamma - delta)*(ea_e_inv - 2)
    let d1_of_place_2 = cos_gamma_minus_delta * (ea_e_inv - S::int(2));
    let d1_of_place_3 = cos_gamma_minus_delta * sin_phi;
    // sin(gamma - delta)*cos(phi) - d1_of_place_3
    let d1_of_place_4 = sin_gamma_minus_delta.mul_add(cos_phi, -d1_of_place_3);
    let sin_phi_d1_of_place_4 = d1_of_place_4 * sin_phi;
    let d1_of_place_5 = S::int(2) * sin_phi_d1_of_place_4;
    let d1_of_place_6 = e_inv * cos_gamma_minus_delta;
    let i4_d1_of_place_6 = I4 * d1_of_place_6;
    let zt_inv = S::int(1) / zt;
    let d1_of_place_4_zt_inv = d1_of_place_4 * zt_inv;
    // d1_of_place_4_zt_inv*(I5 + m5*(ta^2 + tb^2))
    let d1_of_place_7 = d1_of_place_4_zt_inv * (I5 + m5 * tb.mul_add(tb, ta * ta));
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*(fa_zf_inv - 2)
    let d1_of_place_8 = sin_gamma_minus_epsilon * (fa_zf_inv - S::int(2));
    let d1_of_place_9 = sin_gamma_minus_epsilon * sin_omega;
    // cos(gamma - epsilon)*cos(omega) + d1_of_place_9
    let d1_of_place_10 = cos_gamma_minus_epsilon.mul_add(cos_omega, d1_of_place_9);
    let sin_omega_d1_of_place_10 = d1_of_place_10 * sin_omega;
    let d1_of_place_11 = S::int(2) * sin_omega_d1_of_place_10;
    let d1_of_place_12 = zf_inv * sin_gamma_minus_epsilon;
    let i6_d1_of_place_12 = I6 * d1_of_place_12;
    let u_2_inv = S::int(1) / u_2;
    let d1_of_place_10_u_2_inv = d1_of_place_10 * u_2_inv;
    // d1_of_place_10_u_2_inv*(I7 + m7*(ua^2 + ub^2))
    let d1_of_place_13 = d1_of_place_10_u_2_inv * (I7 + m7 * ub.mul_add(ub, ua * ua));
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_14 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let sin_theta_sq = sin_theta * sin_theta;
    let d1_of_place_15 = d1_of_d_beta_gamma * cos_theta;
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
                        * (d1_of_d_beta_gamma * d1_of_d_beta_gamma * da.mul_add(m2_da, I2)
                            + sin_theta_sq
                                * (cos_phi_inv_sq
                                    * (m4
                                        * (cos_gamma_minus_delta
                                            * (cos_gamma_minus_delta + d1_of_place_5
                                                + ea_e_inv * (d1_of_place_2 - d1_of_place_5))
                                            + d1_of_place_4 * d1_of_place_4)
                                        + d1_of_place_6 * i4_d1_of_place_6
                                        + d1_of_place_4_zt_inv * d1_of_place_7)
                                    + cos_omega_inv_sq
                                        * (m6
                                            * (sin_gamma_minus_epsilon
                                                * (sin_gamma_minus_epsilon - d1_of_place_11
                                                    + fa_zf_inv * (d1_of_place_8 + d1_of_place_11))
                                                + d1_of_place_10 * d1_of_place_10)
                                            + d1_of_place_12 * i6_d1_of_place_12
                                            + d1_of_place_10_u_2_inv * d1_of_place_13)
                                    + ss_inv * d1_of_place_14))
                        - S::int(2) * m2_da * d1_of_place_15));
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let beta_rate_dot_of_place = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    // zt*cos(gamma - delta) - e*sin(gamma - delta - phi)
    let beta_rate_dot_of_place_3 = (-e)
        .mul_add(d1_of_place_4, zt * cos_gamma_minus_delta);
    // e - ea
    let e_minus_ea = e - ea;
    let beta_rate_dot_of_phi_dot = phi_dot * d1_of_place_4 * e_minus_ea;
    // zf - fa
    let zf_minus_fa = zf - fa;
    let beta_rate_dot_of_place_4 = d1_of_place_10 * zf_minus_fa;
    let beta_rate_dot_of_place_5 = u_2 * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_omega_dot = omega_dot * beta_rate_dot_of_place_4;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let beta_rate_dot_of_beta_dot = beta_dot * rr_cos_angle_inv;
    // sin(gamma - delta)*sin(phi) + cos(gamma - delta)*cos(phi)
    let beta_rate_dot_of_place_6 = cos_gamma_minus_delta
        .mul_add(cos_phi, sin_gamma_minus_delta * sin_phi);
    let beta_rate_dot_of_place_7 = sin_phi_d1_of_place_4 * cos_phi_inv;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // ss_inv*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*sin_angle_cos_angle_inv)
    let beta_rate_dot_of_place_8 = ss_inv
        * (-d1_of_place_4).mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_6);
    let beta_rate_dot_of_place_9 = d1_of_d_beta_gamma * sin_angle_cos_angle_inv;
    // sin(gamma - delta - phi)*cos(theta) - rr_cos_angle_inv*(sin(gamma - delta - phi)*d1_of_place_15 +
    //   sin(theta)*(sin(theta)*(beta_rate_dot_of_place_8 -
    //   cos_phi_inv*(d1_of_place_4_zt_inv*beta_rate_dot_of_place_7 + d1_of_place_6*(cos(gamma - delta - phi)
    //   - beta_rate_dot_of_place_7))) + sin(gamma - delta - phi)*beta_rate_dot_of_place_9))
    let beta_rate_dot_of_place_10 = -rr_cos_angle_inv
        * (sin_theta
            * (sin_theta
                * (beta_rate_dot_of_place_8
                    - cos_phi_inv
                        * (d1_of_place_6 * (beta_rate_dot_of_place_6 - beta_rate_dot_of_place_7)
                            + d1_of_place_4_zt_inv * beta_rate_dot_of_place_7))
                + d1_of_place_4 * beta_rate_dot_of_place_9)
            + d1_of_place_4 * d1_of_place_15) + d1_of_place_4 * cos_theta;
    let zt_sin_phi = zt * sin_phi;
    // d1_of_place_6 - d1_of_place_4_zt_inv
    let beta_rate_dot_of_place_11 = d1_of_place_6 - d1_of_place_4_zt_inv;
    let beta_rate_dot_of_place_12 = d1_of_place_3 * cos_phi_inv;
    // beta_rate_dot_of_place_11*cos(theta) +
    //   rr_cos_angle_inv*(sin(theta)*(sin(theta)*(zt_inv*(beta_rate_dot_of_place_8 -
    //   sin_phi_d1_of_place_4*d1_of_place_4_zt_inv*cos_phi_inv_sq) + e_inv*(ss_inv*(sin(gamma - delta) +
    //   sin_angle_cos_angle_inv*cos(gamma - delta)) - cos_phi_inv*(d1_of_place_6*beta_rate_dot_of_place_12 +
    //   zt_inv*(cos(gamma - delta - phi)*cos(gamma - delta) + sin(gamma - delta - phi)*(sin(gamma - delta) -
    //   2*beta_rate_dot_of_place_12))))) - beta_rate_dot_of_place_9*beta_rate_dot_of_place_11) -
    //   d1_of_place_15*beta_rate_dot_of_place_11)
    let beta_rate_dot_of_place_13 = rr_cos_angle_inv
        * (sin_theta
            * (sin_theta
                * (zt_inv
                    * (-(sin_phi_d1_of_place_4 * d1_of_place_4_zt_inv))
                        .mul_add(cos_phi_inv_sq, beta_rate_dot_of_place_8)
                    + e_inv
                        * (ss_inv
                            * sin_angle_cos_angle_inv
                                .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta)
                            - cos_phi_inv
                                * (zt_inv
                                    * (d1_of_place_4
                                        * (-beta_rate_dot_of_place_12)
                                            .mul_add(S::int(2), sin_gamma_minus_delta)
                                        + beta_rate_dot_of_place_6 * cos_gamma_minus_delta)
                                    + d1_of_place_6 * beta_rate_dot_of_place_12)))
                - beta_rate_dot_of_place_9 * beta_rate_dot_of_place_11)
            - d1_of_place_15 * beta_rate_dot_of_place_11) + beta_rate_dot_of_place_11 * cos_theta;
    // ss_inv*(cos(theta) + rr_cos_angle_inv*(ss_inv*sin_theta_sq*sin_angle_cos_angle_inv -
    //   d1_of_d_beta_gamma*(cos(theta) + sin_angle_cos_angle_inv*sin(theta))))
    let beta_rate_dot_of_place_14 = ss_inv
        * (cos_theta
            + rr_cos_angle_inv
                * (-d1_of_d_beta_gamma * sin_angle_cos_angle_inv.mul_add(sin_theta, cos_theta)
                    + ss_inv * sin_theta_sq * sin_angle_cos_angle_inv));
    // sin(gamma - epsilon)*cos(omega) - cos(gamma - epsilon)*sin(omega)
    let beta_rate_dot_of_place_15 = (-cos_gamma_minus_epsilon)
        .mul_add(sin_omega, sin_gamma_minus_epsilon * cos_omega);
    let beta_rate_dot_of_place_16 = sin_omega_d1_of_place_10 * cos_omega_inv;
    let beta_rate_dot_of_place_17 = d1_of_place_10_u_2_inv * beta_rate_dot_of_place_16;
    // ss_inv*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv)
    let beta_rate_dot_of_place_18 = ss_inv
        * d1_of_place_10.mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_15);
    // rr_cos_angle_inv*(cos(gamma - epsilon - omega)*d1_of_place_15 -
    //   sin(theta)*(sin(theta)*(cos_omega_inv*(beta_rate_dot_of_place_17 - d1_of_place_12*(sin(gamma -
    //   epsilon - omega) + beta_rate_dot_of_place_16)) + beta_rate_dot_of_place_18) - cos(gamma - epsilon -
    //   omega)*beta_rate_dot_of_place_9)) - cos(gamma - epsilon - omega)*cos(theta)
    let beta_rate_dot_of_place_19 = rr_cos_angle_inv
        * (-sin_theta
            * (sin_theta
                * (cos_omega_inv
                    * (beta_rate_dot_of_place_17
                        - d1_of_place_12 * (beta_rate_dot_of_place_15 + beta_rate_dot_of_place_16))
                    + beta_rate_dot_of_place_18) - d1_of_place_10 * beta_rate_dot_of_place_9)
            + d1_of_place_10 * d1_of_place_15) - d1_of_place_10 * cos_theta;
    let u_2_sin_omega = u_2 * sin_omega;
    // d1_of_place_12 - d1_of_place_10_u_2_inv
    let beta_rate_dot_of_place_20 = d1_of_place_12 - d1_of_place_10_u_2_inv;
    // rr_cos_angle_inv*(d1_of_place_15*beta_rate_dot_of_place_20 +
    //   sin(theta)*(sin(theta)*(zf_inv*(d1_of_place_9*d1_of_place_12*cos_omega_inv_sq + ss_inv*(cos(gamma -
    //   epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon))) +
    //   u_2_inv*(cos_omega_inv*(beta_rate_dot_of_place_17 - zf_inv*(sin(gamma - epsilon - omega)*sin(gamma -
    //   epsilon) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon) + 2*d1_of_place_9*cos_omega_inv))) +
    //   beta_rate_dot_of_place_18)) + beta_rate_dot_of_place_9*beta_rate_dot_of_place_20)) -
    //   beta_rate_dot_of_place_20*cos(theta)
    let beta_rate_dot_of_place_21 = rr_cos_angle_inv
        * (sin_theta
            * (sin_theta
                * (zf_inv
                    * (ss_inv
                        * (-sin_angle_cos_angle_inv)
                            .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon)
                        + d1_of_place_9 * d1_of_place_12 * cos_omega_inv_sq)
                    + u_2_inv
                        * (cos_omega_inv
                            * (beta_rate_dot_of_place_17
                                - zf_inv
                                    * (d1_of_place_10
                                        * (d1_of_place_9 * cos_omega_inv)
                                            .mul_add(S::int(2), cos_gamma_minus_epsilon)
                                        + beta_rate_dot_of_place_15 * sin_gamma_minus_epsilon))
                            + beta_rate_dot_of_place_18))
                + beta_rate_dot_of_place_9 * beta_rate_dot_of_place_20)
            + d1_of_place_15 * beta_rate_dot_of_place_20) - beta_rate_dot_of_place_20 * cos_theta;
    // cos_phi_inv_sq*(zt_inv*beta_rate_dot_of_place_10*(i4_d1_of_place_6 + d1_of_place_7 + m4*(sin(gamma -
    //   delta - phi)*(zt + e_minus_ea*sin(phi)) + cos(gamma - delta)*(e + zt_sin_phi + ea*(e_inv*(ea -
    //   zt_sin_phi) - 2)))) + beta_rate_dot_of_place_13*(m4*(ea*(d1_of_place_2 - sin_phi_d1_of_place_4) +
    //   e*(cos(gamma - delta) + sin_phi_d1_of_place_4)) + i4_d1_of_place_6)) +
    //   d1_of_place_14*beta_rate_dot_of_place_14
    let beta_rate_dot_of_place_22 = cos_phi_inv_sq
        * (zt_inv * beta_rate_dot_of_place_10
            * (i4_d1_of_place_6 + d1_of_place_7
                + m4
                    * (d1_of_place_4 * e_minus_ea.mul_add(sin_phi, zt)
                        + cos_gamma_minus_delta
                            * (e + zt_sin_phi + ea * (e_inv * (ea - zt_sin_phi) - S::int(2)))))
            + beta_rate_dot_of_place_13
                * (m4
                    * (ea * (d1_of_place_2 - sin_phi_d1_of_place_4)
                        + e * (cos_gamma_minus_delta + sin_phi_d1_of_place_4))
                    + i4_d1_of_place_6)) + d1_of_place_14 * beta_rate_dot_of_place_14;
    let beta_rate_dot_of_place_23 = cos_angle_inv * d1_of_d_beta_gamma;
    let beta_rate_dot_of_beta_dot_2 = beta_dot * beta_rate_dot_of_beta_dot;
    // d_inv*beta_rate_dot_of_beta_dot_2*(sin(beta - gamma) - rr_cos_angle_inv*(ss_inv*sin(theta)*(sin(beta
    //   - gamma) - sin_angle_cos_angle_inv*cos(beta - gamma)) + beta_rate_dot_of_place_9*cos(beta - gamma)))
    let beta_rate_dot_of_beta_dot_3 = d_inv * beta_rate_dot_of_beta_dot_2
        * (sin_beta_minus_gamma
            - rr_cos_angle_inv
                * (ss_inv * sin_theta
                    * (-sin_angle_cos_angle_inv)
                        .mul_add(cos_beta_minus_gamma, sin_beta_minus_gamma)
                    + beta_rate_dot_of_place_9 * cos_beta_minus_gamma));
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
    // beta_rate' = (mom + rr^2*beta'^2*sin(theta)*(I3 + m3*(sa^2 + sb^2))*(cos(theta) -
    //   rr*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta) + sin(theta)*tan(beta
    //   + theta - gamma))/d)/cos(beta + theta - gamma))/(ss^2*cos(beta + theta - gamma)^2) +
    //   rr^2*beta'^2*(sin(beta - gamma) - rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d +
    //   sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta -
    //   gamma))*(I2*cos(beta - gamma)/(d*cos(beta + theta - gamma)) + m2*da*(da*cos(beta -
    //   gamma)/(d*cos(beta + theta - gamma)) - cos(theta)))/(d*cos(beta + theta - gamma)) +
    //   rr^2*beta'^2*sin(theta)*(cos(theta)*sin(gamma - delta - phi) + rr*(sin(theta)*(cos(beta -
    //   gamma)*sin(gamma - delta - phi)*tan(gamma - beta - theta)/d + sin(theta)*((sin(gamma - delta -
    //   phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta -
    //   phi)*tan(phi))/e)/cos(phi) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta
    //   - phi))/ss)) - cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d)/cos(beta + theta -
    //   gamma))*(I4*cos(gamma - delta)/e + sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   m4*(cos(gamma - delta)*(e + zt*sin(phi) + ea*((ea - zt*sin(phi))/e - 2)) + sin(gamma - delta -
    //   phi)*(zt + sin(phi)*(e - ea))))/(zt*cos(beta + theta - gamma)^2*cos(phi)^2) -
    //   rr^2*beta'^2*sin(theta)*(cos(theta)*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e) +
    //   rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d +
    //   sin(theta)*(sin(theta)*(((cos(gamma - delta)^2*tan(phi)/e + (cos(gamma - delta)*cos(gamma - delta -
    //   phi) + sin(gamma - delta - phi)*(sin(gamma - delta) - 2*cos(gamma - delta)*tan(phi)))/zt)/cos(phi) -
    //   (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)/e + (sin(gamma - delta -
    //   phi)^2*tan(phi)/(zt*cos(phi)) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss)/zt) + cos(beta - gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)/e -
    //   sin(gamma - delta - phi)/zt)/d))/cos(beta + theta - gamma))*(I4*cos(gamma - delta)/e +
    //   m4*(ea*(cos(gamma - delta)*(ea/e - 2) - sin(phi)*sin(gamma - delta - phi)) + e*(cos(gamma - delta) +
    //   sin(phi)*sin(gamma - delta - phi))))/(cos(beta + theta - gamma)^2*cos(phi)^2) +
    //   rr^2*beta'^2*sin(theta)*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta -
    //   gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - epsilon)*(sin(gamma - epsilon - omega)
    //   + cos(gamma - epsilon - omega)*tan(omega))/zf - cos(gamma - epsilon -
    //   omega)^2*tan(omega)/u)/cos(omega) - (sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma))/ss)))/cos(beta + theta - gamma))*(I6*sin(gamma - epsilon)/zf +
    //   cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + m6*(sin(gamma - epsilon)*(zf - u*sin(omega)
    //   + fa*((fa + u*sin(omega))/zf - 2)) + cos(gamma - epsilon - omega)*(u + sin(omega)*(fa -
    //   zf))))/(u*cos(beta + theta - gamma)^2*cos(omega)^2) - rr^2*beta'^2*sin(theta)*(cos(theta)*(cos(gamma
    //   - epsilon - omega)/u - sin(gamma - epsilon)/zf) + rr*(cos(theta)*cos(beta - gamma)*(sin(gamma -
    //   epsilon)/zf - cos(gamma - epsilon - omega)/u)/d + sin(theta)*(sin(theta)*(((sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss + (cos(gamma - epsilon -
    //   omega)^2*tan(omega)/u - (sin(gamma - epsilon)*sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*(cos(gamma - epsilon) + 2*sin(gamma - epsilon)*tan(omega)))/zf)/cos(omega))/u + ((sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf) + cos(beta - gamma)*tan(beta + theta - gamma)*(sin(gamma
    //   - epsilon)/zf - cos(gamma - epsilon - omega)/u)/d))/cos(beta + theta - gamma))*(I6*sin(gamma -
    //   epsilon)/zf + m6*(fa*(sin(gamma - epsilon)*(fa/zf - 2) + sin(omega)*cos(gamma - epsilon - omega)) +
    //   zf*(sin(gamma - epsilon) - sin(omega)*cos(gamma - epsilon - omega))))/(cos(beta + theta -
    //   gamma)^2*cos(omega)^2) + rr*sin(theta)*((c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) +
    //   sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + m2*da*rr*beta'^2*cos(beta - gamma)/d - m4*(phi'^2*sin(gamma - delta -
    //   phi)*(e - ea) + delta'*(delta'*(e*sin(gamma - delta - phi) - zt*cos(gamma - delta) +
    //   ea*(zt*cos(gamma - delta)/e - sin(gamma - delta - phi))) + 2*phi'*sin(gamma - delta - phi)*(e -
    //   ea))) + m6*(omega'^2*cos(gamma - epsilon - omega)*(zf - fa) + epsilon'*(epsilon'*(u*sin(gamma -
    //   epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*(zf - fa)) + 2*omega'*cos(gamma - epsilon -
    //   omega)*(zf - fa))))/cos(beta + theta - gamma) - m2*da*(theta'^2 + beta'*(beta' + 2*theta'))))/d1
    let beta_rate_dot = (mom
        + sin_theta
            * (rr
                * (cos_angle_inv
                    * (rr * beta_dot * beta_dot * m2_da * d1_of_d_beta_gamma
                        + c0 * ss_inv * beta_rate_dot_of_place_24 * (l0 - beta_rate_dot_of_place_24)
                            * (-sd)
                                .mul_add(
                                    beta_rate_dot_of_place_2,
                                    sc * beta_rate_dot_of_place,
                                )
                            / (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
                                + sd * beta_rate_dot_of_place.mul_add(S::int(2), sd)
                                + sc * beta_rate_dot_of_place_2.mul_add(S::int(2), sc))
                        - m4
                            * (delta_dot
                                * (-delta_dot
                                    * (ea * (-zt).mul_add(d1_of_place_6, d1_of_place_4)
                                        + beta_rate_dot_of_place_3)
                                    + S::int(2) * beta_rate_dot_of_phi_dot)
                                + phi_dot * beta_rate_dot_of_phi_dot)
                        + m6
                            * (epsilon_dot
                                * (epsilon_dot
                                    * (beta_rate_dot_of_place_4
                                        + beta_rate_dot_of_place_5 * (fa_zf_inv - S::int(1)))
                                    + S::int(2) * beta_rate_dot_of_omega_dot)
                                + omega_dot * beta_rate_dot_of_omega_dot))
                    - m2_da
                        * (beta_dot * theta_dot.mul_add(S::int(2), beta_dot)
                            + theta_dot * theta_dot))
                + beta_rate_dot_of_beta_dot * beta_rate_dot_of_beta_dot
                    * (beta_rate_dot_of_place_22
                        - cos_omega_inv_sq
                            * (u_2_inv * beta_rate_dot_of_place_19
                                * (i6_d1_of_place_12 + d1_of_place_13
                                    + m6
                                        * (d1_of_place_10 * (-zf_minus_fa).mul_add(sin_omega, u_2)
                                            + sin_gamma_minus_epsilon
                                                * (zf - u_2_sin_omega
                                                    + fa * (zf_inv * (fa + u_2_sin_omega) - S::int(2)))))
                                + beta_rate_dot_of_place_21
                                    * (m6
                                        * (fa * (d1_of_place_8 + sin_omega_d1_of_place_10)
                                            + zf * (sin_gamma_minus_epsilon - sin_omega_d1_of_place_10))
                                        + i6_d1_of_place_12))))
        + rr * beta_rate_dot_of_beta_dot_3
            * (-m2_da * (-da).mul_add(beta_rate_dot_of_place_23, cos_theta)
                + I2 * beta_rate_dot_of_place_23)) / d1;
    // beta'' = beta_rate'
    let beta_ddot = beta_rate_dot;
    // theta'' = rr*beta'^2*(rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d + sin(theta)*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta - gamma) - sin(beta -
    //   gamma))/(d*cos(beta + theta - gamma)) + beta_rate'*(rr*cos(beta - gamma)/(d*cos(beta + theta -
    //   gamma)) - 1)
    let theta_ddot = beta_rate_dot * d1_of_d_beta_gamma.mul_add(rr_cos_angle_inv, -S::int(1))
        - beta_rate_dot_of_beta_dot_3;
    let gamma_ddot_of_motion = beta_rate_dot * rr_cos_angle_inv * sin_theta;
    // gamma'' = rr*beta'^2*(rr*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta)
    //   + sin(theta)*tan(beta + theta - gamma))/d)/cos(beta + theta - gamma) - cos(theta))/(ss*cos(beta +
    //   theta - gamma)) + rr*beta_rate'*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_ddot = (-beta_rate_dot_of_place_14)
        .mul_add(beta_rate_dot_of_beta_dot_2, ss_inv * gamma_ddot_of_motion);
    let zt_inv_cos_phi_inv = zt_inv * cos_phi_inv;
    // delta'' = rr*beta_rate'*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    //   - rr*beta'^2*(cos(theta)*sin(gamma - delta - phi) + rr*(sin(theta)*(cos(beta - gamma)*sin(gamma -
    //   delta - phi)*tan(gamma - beta - theta)/d + sin(theta)*((sin(gamma - delta - phi)^2*tan(phi)/zt +
    //   cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi) -
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss)) -
    //   cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d)/cos(beta + theta - gamma))/(zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let delta_ddot = (-(beta_rate_dot_of_place_10 * beta_rate_dot_of_beta_dot_2))
        .mul_add(
            zt_inv_cos_phi_inv,
            d1_of_place_4_zt_inv * cos_phi_inv * gamma_ddot_of_motion,
        );
    // phi'' = rr*beta'^2*(cos(theta)*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e) +
    //   rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d +
    //   sin(theta)*(sin(theta)*(((cos(gamma - delta)^2*tan(phi)/e + (cos(gamma - delta)*cos(gamma - delta -
    //   phi) + sin(gamma - delta - phi)*(sin(gamma - delta) - 2*cos(gamma - delta)*tan(phi)))/zt)/cos(phi) -
    //   (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)/e + (sin(gamma - delta -
    //   phi)^2*tan(phi)/(zt*cos(phi)) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss)/zt) + cos(beta - gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)/e -
    //   sin(gamma - delta - phi)/zt)/d))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(phi)) +
    //   rr*beta_rate'*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta + theta
    //   - gamma)*cos(phi))
    let phi_ddot = (-(cos_phi_inv * beta_rate_dot_of_place_13))
        .mul_add(
            beta_rate_dot_of_beta_dot_2,
            e_inv * beta_rate_dot_of_place_3 * gamma_ddot_of_motion * zt_inv_cos_phi_inv,
        );
    let u_2_inv_cos_omega_inv = u_2_inv * cos_omega_inv;
    // epsilon'' = rr*beta'^2*(rr*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d +
    //   sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d +
    //   sin(theta)*((sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(omega))/zf - cos(gamma - epsilon - omega)^2*tan(omega)/u)/cos(omega) - (sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)))/cos(beta + theta -
    //   gamma) - cos(theta)*cos(gamma - epsilon - omega))/(u*cos(beta + theta - gamma)*cos(omega)) +
    //   rr*beta_rate'*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_ddot = (beta_rate_dot_of_place_19 * beta_rate_dot_of_beta_dot_2)
        .mul_add(
            u_2_inv_cos_omega_inv,
            d1_of_place_10_u_2_inv * cos_omega_inv * gamma_ddot_of_motion,
        );
    // omega'' = rr*beta'^2*(cos(theta)*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf) +
    //   rr*(cos(theta)*cos(beta - gamma)*(sin(gamma - epsilon)/zf - cos(gamma - epsilon - omega)/u)/d +
    //   sin(theta)*(sin(theta)*(((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta +
    //   theta - gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - (sin(gamma - epsilon)*sin(gamma
    //   - epsilon - omega) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon) + 2*sin(gamma -
    //   epsilon)*tan(omega)))/zf)/cos(omega))/u + ((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf) + cos(beta -
    //   gamma)*tan(beta + theta - gamma)*(sin(gamma - epsilon)/zf - cos(gamma - epsilon -
    //   omega)/u)/d))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(omega)) +
    //   rr*beta_rate'*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon - omega))/(u*zf*cos(beta +
    //   theta - gamma)*cos(omega))
    let omega_ddot = zf_inv * gamma_ddot_of_motion * u_2_inv_cos_omega_inv
        * (-zf).mul_add(d1_of_place_10, beta_rate_dot_of_place_5)
        + cos_omega_inv * beta_rate_dot_of_place_21 * beta_rate_dot_of_beta_dot_2;
    [beta_ddot, theta_ddot, gamma_ddot, delta_ddot, phi_ddot, epsilon_ddot, omega_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 7],
    q_dot: &[S; 7],
) -> [S; 7] {
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
    // Values.
    // beta'
    let beta_dot_value = beta_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // gamma'
    let gamma_dot_value = gamma_dot;
    // delta'
    let delta_dot_value = delta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    // epsilon'
    let epsilon_dot_value = epsilon_dot;
    // omega'
    let omega_dot_value = omega_dot;
    [
        beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
        epsilon_dot_value, omega_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 97 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 7], q_dot: &[S; 7]) -> S {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, da, e, ea, rr, ra, sa, sb, ta, tb,
        zt,
        u: u_2,
        ua, ub, zf, fa,
        ..
    } = *p;
    let [_, theta, _, _, phi, _, omega] = *q;
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    let (sin_phi, _) = phi.sin_cos();
    let (sin_omega, _) = omega.sin_cos();
    // Shared terms.
    let rr_cos_theta = rr * cos_theta;
    let m2_da = m2 * da;
    // e - ea
    let e_minus_ea = e - ea;
    // zf - fa
    let zf_minus_fa = zf - fa;
    let zf_minus_fa_sq = zf_minus_fa * zf_minus_fa;
    // beta'^2*(I1 + I2 + m1*ra^2 + m2*(rr^2 + da*(da - 2*rr_cos_theta))) + theta'^2*(I2 + da*m2_da)
    let energy_of_motion = beta_dot * beta_dot
        * (I1 + I2 + m1 * ra * ra + m2 * (da * (-rr_cos_theta).mul_add(S::int(2), da) + rr * rr))
        + theta_dot * theta_dot * da.mul_add(m2_da, I2);
    let e_minus_ea_sq = e_minus_ea * e_minus_ea;
    // gamma'^2*(I3 + m3*(sa^2 + sb^2)) + delta'^2*(I4 + I5 + m5*(ta^2 + tb^2) + m4*(zt*(zt +
    //   2*e_minus_ea*sin(phi)) + e_minus_ea_sq))
    let energy_of_motion_2 = gamma_dot * gamma_dot * (I3 + m3 * sb.mul_add(sb, sa * sa))
        + delta_dot * delta_dot
            * (I4 + I5 + m5 * tb.mul_add(tb, ta * ta)
                + m4
                    * (zt * (e_minus_ea * sin_phi).mul_add(S::int(2), zt) + e_minus_ea_sq));
    // epsilon'^2*(I6 + I7 + m7*(ua^2 + ub^2) + m6*(u*(u - 2*zf_minus_fa*sin(omega)) + zf_minus_fa_sq)) +
    //   phi'^2*(I4 + m4*e_minus_ea_sq)
    let energy_of_motion_3 = epsilon_dot * epsilon_dot
        * (I6 + I7 + m7 * ub.mul_add(ub, ua * ua)
            + m6
                * (u_2 * (-(zf_minus_fa * sin_omega)).mul_add(S::int(2), u_2) + zf_minus_fa_sq))
        + phi_dot * phi_dot * m4.mul_add(e_minus_ea_sq, I4);
    // omega'^2*(I6 + m6*zf_minus_fa_sq) + energy_of_motion
    let energy_of_motion_4 = omega_dot * omega_dot * m6.mul_add(zf_minus_fa_sq, I6)
        + energy_of_motion;
    // energy_of_motion_2 + energy_of_motion_3
    let energy_of_motion_5 = energy_of_motion_2 + energy_of_motion_3;
    // energy_of_motion_4 + energy_of_motion_5
    let energy_of_motion_6 = energy_of_motion_4 + energy_of_motion_5;
    // Values.
    // T = beta'^2*(I1 + I2 + m1*ra^2 + m2*(rr^2 + da*(da - 2*rr*cos(theta))))/2 + theta'^2*(I2 +
    //   m2*da^2)/2 + beta'*theta'*(I2 + m2*da*(da - rr*cos(theta))) + gamma'^2*(I3 + m3*(sa^2 + sb^2))/2 +
    //   delta'^2*(I4 + I5 + m5*(ta^2 + tb^2) + m4*((e - ea)^2 + zt*(zt + 2*sin(phi)*(e - ea))))/2 +
    //   phi'^2*(I4 + m4*(e - ea)^2)/2 + delta'*phi'*(I4 + m4*(e - ea)*(e - ea + zt*sin(phi))) +
    //   epsilon'^2*(I6 + I7 + m7*(ua^2 + ub^2) + m6*((zf - fa)^2 + u*(u + 2*sin(omega)*(fa - zf))))/2 +
    //   omega'^2*(I6 + m6*(zf - fa)^2)/2 + epsilon'*omega'*(I6 + m6*(zf - fa)*(zf - fa - u*sin(omega)))
    let energy = beta_dot * theta_dot * (I2 + m2_da * (da - rr_cos_theta))
        + delta_dot * phi_dot * (I4 + m4 * e_minus_ea * zt.mul_add(sin_phi, e_minus_ea))
        + epsilon_dot * omega_dot * (I6 + m6 * zf_minus_fa * (-u_2).mul_add(sin_omega, zf_minus_fa))
        + S::ratio(1, 2) * energy_of_motion_6;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 7],
    q_dot: &[S; 7],
) -> [S; 1] {
    let [beta_dot, _, _, _, _, _, _] = *q_dot;
    // Values.
    // beta_rate = beta'
    let beta_rate_value = beta_dot;
    [beta_rate_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 7],
    _q_dot: &[S; 7],
    v_dot: &[S; 7],
) -> [S; 1] {
    let [beta_ddot, _, _, _, _, _, _] = *v_dot;
    // Values.
    // beta_rate' = beta''
    let beta_rate_dot_value = beta_ddot;
    [beta_rate_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 35 operations, 7 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 7] {
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
    let gamma_dot_value_of_place = beta_rate * rr_cos_angle_inv * sin_theta;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let delta_dot_value_of_place = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let delta_dot_value_of_place_2 = gamma_dot_value_of_place / (zt * cos_phi);
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let epsilon_dot_value_of_place = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let epsilon_dot_value_of_place_2 = gamma_dot_value_of_place / (u_2 * cos_omega);
    let (_, cos_beta_minus_gamma) = (beta - gamma).sin_cos();
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = beta_rate * (rr_cos_angle_inv * cos_beta_minus_gamma / d - S::int(1));
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = gamma_dot_value_of_place / ss;
    // delta' = rr*beta_rate*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_value = delta_dot_value_of_place * delta_dot_value_of_place_2;
    // phi' = rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let phi_dot_value = delta_dot_value_of_place_2
        * (-e).mul_add(delta_dot_value_of_place, zt * cos_gamma_minus_delta) / e;
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = epsilon_dot_value_of_place * epsilon_dot_value_of_place_2;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = epsilon_dot_value_of_place_2
        * (-zf).mul_add(epsilon_dot_value_of_place, u_2 * sin_gamma_minus_epsilon) / zf;
    [
        beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
        epsilon_dot_value, omega_dot_value,
    ]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 443 operations, 8 sines and cosines, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    q_dot: &[S; 7],
) -> ([S; 7], [S; 7]) {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
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
    let m2_da = m2 * da;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // cos(gamma - delta)*(ea_e_inv - 2)
    let d1_of_place_2 = cos_gamma_minus_delta * (ea_e_inv - S::int(2));
    let d1_of_place_3 = cos_gamma_minus_delta * sin_phi;
    // sin(gamma - delta)*cos(phi) - d1_of_place_3
    let d1_of_place_4 = sin_gamma_minus_delta.mul_add(cos_phi, -d1_of_place_3);
    let sin_phi_d1_of_place_4 = d1_of_place_4 * sin_phi;
    let d1_of_place_5 = S::int(2) * sin_phi_d1_of_place_4;
    let d1_of_place_6 = e_inv * cos_gamma_minus_delta;
    let i4_d1_of_place_6 = I4 * d1_of_place_6;
    let zt_inv = S::int(1) / zt;
    let d1_of_place_4_zt_inv = d1_of_place_4 * zt_inv;
    // d1_of_place_4_zt_inv*(I5 + m5*(ta^2 + tb^2))
    let d1_of_place_7 = d1_of_place_4_zt_inv * (I5 + m5 * tb.mul_add(tb, ta * ta));
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*(fa_zf_inv - 2)
    let d1_of_place_8 = sin_gamma_minus_epsilon * (fa_zf_inv - S::int(2));
    let d1_of_place_9 = sin_gamma_minus_epsilon * sin_omega;
    // cos(gamma - epsilon)*cos(omega) + d1_of_place_9
    let d1_of_place_10 = cos_gamma_minus_epsilon.mul_add(cos_omega, d1_of_place_9);
    let sin_omega_d1_of_place_10 = d1_of_place_10 * sin_omega;
    let d1_of_place_11 = S::int(2) * sin_omega_d1_of_place_10;
    let d1_of_place_12 = zf_inv * sin_gamma_minus_epsilon;
    let i6_d1_of_place_12 = I6 * d1_of_place_12;
    let u_2_inv = S::int(1) / u_2;
    let d1_of_place_10_u_2_inv = d1_of_place_10 * u_2_inv;
    // d1_of_place_10_u_2_inv*(I7 + m7*(ua^2 + ub^2))
    let d1_of_place_13 = d1_of_place_10_u_2_inv * (I7 + m7 * ub.mul_add(ub, ua * ua));
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_14 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let sin_theta_sq = sin_theta * sin_theta;
    let d1_of_place_15 = d1_of_d_beta_gamma * cos_theta;
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
                        * (d1_of_d_beta_gamma * d1_of_d_beta_gamma * da.mul_add(m2_da, I2)
                            + sin_theta_sq
                                * (cos_phi_inv_sq
                                    * (m4
                                        * (cos_gamma_minus_delta
                                            * (cos_gamma_minus_delta + d1_of_place_5
                                                + ea_e_inv * (d1_of_place_2 - d1_of_place_5))
                                            + d1_of_place_4 * d1_of_place_4)
                                        + d1_of_place_6 * i4_d1_of_place_6
                                        + d1_of_place_4_zt_inv * d1_of_place_7)
                                    + cos_omega_inv_sq
                                        * (m6
                                            * (sin_gamma_minus_epsilon
                                                * (sin_gamma_minus_epsilon - d1_of_place_11
                                                    + fa_zf_inv * (d1_of_place_8 + d1_of_place_11))
                                                + d1_of_place_10 * d1_of_place_10)
                                            + d1_of_place_12 * i6_d1_of_place_12
                                            + d1_of_place_10_u_2_inv * d1_of_place_13)
                                    + ss_inv * d1_of_place_14))
                        - S::int(2) * m2_da * d1_of_place_15));
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let beta_rate_dot_of_place = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    // zt*cos(gamma - delta) - e*sin(gamma - delta - phi)
    let beta_rate_dot_of_place_3 = (-e)
        .mul_add(d1_of_place_4, zt * cos_gamma_minus_delta);
    // e - ea
    let e_minus_ea = e - ea;
    let beta_rate_dot_of_phi_dot = phi_dot * d1_of_place_4 * e_minus_ea;
    // zf - fa
    let zf_minus_fa = zf - fa;
    let beta_rate_dot_of_place_4 = d1_of_place_10 * zf_minus_fa;
    let beta_rate_dot_of_place_5 = u_2 * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_omega_dot = omega_dot * beta_rate_dot_of_place_4;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let beta_rate_dot_of_beta_dot = beta_dot * rr_cos_angle_inv;
    // sin(gamma - delta)*sin(phi) + cos(gamma - delta)*cos(phi)
    let beta_rate_dot_of_place_6 = cos_gamma_minus_delta
        .mul_add(cos_phi, sin_gamma_minus_delta * sin_phi);
    let beta_rate_dot_of_place_7 = sin_phi_d1_of_place_4 * cos_phi_inv;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // ss_inv*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*sin_angle_cos_angle_inv)
    let beta_rate_dot_of_place_8 = ss_inv
        * (-d1_of_place_4).mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_6);
    let beta_rate_dot_of_place_9 = d1_of_d_beta_gamma * sin_angle_cos_angle_inv;
    // sin(gamma - delta - phi)*cos(theta) - rr_cos_angle_inv*(sin(gamma - delta - phi)*d1_of_place_15 +
    //   sin(theta)*(sin(theta)*(beta_rate_dot_of_place_8 -
    //   cos_phi_inv*(d1_of_place_4_zt_inv*beta_rate_dot_of_place_7 + d1_of_place_6*(cos(gamma - delta - phi)
    //   - beta_rate_dot_of_place_7))) + sin(gamma - delta - phi)*beta_rate_dot_of_place_9))
    let beta_rate_dot_of_place_10 = -rr_cos_angle_inv
        * (sin_theta
            * (sin_theta
                * (beta_rate_dot_of_place_8
                    - cos_phi_inv
                        * (d1_of_place_6 * (beta_rate_dot_of_place_6 - beta_rate_dot_of_place_7)
                            + d1_of_place_4_zt_inv * beta_rate_dot_of_place_7))
                + d1_of_place_4 * beta_rate_dot_of_place_9)
            + d1_of_place_4 * d1_of_place_15) + d1_of_place_4 * cos_theta;
    let zt_sin_phi = zt * sin_phi;
    // d1_of_place_6 - d1_of_place_4_zt_inv
    let beta_rate_dot_of_place_11 = d1_of_place_6 - d1_of_place_4_zt_inv;
    let beta_rate_dot_of_place_12 = d1_of_place_3 * cos_phi_inv;
    // beta_rate_dot_of_place_11*cos(theta) +
    //   rr_cos_angle_inv*(sin(theta)*(sin(theta)*(zt_inv*(beta_rate_dot_of_place_8 -
    //   sin_phi_d1_of_place_4*d1_of_place_4_zt_inv*cos_phi_inv_sq) + e_inv*(ss_inv*(sin(gamma - delta) +
    //   sin_angle_cos_angle_inv*cos(gamma - delta)) - cos_phi_inv*(d1_of_place_6*beta_rate_dot_of_place_12 +
    //   zt_inv*(cos(gamma - delta - phi)*cos(gamma - delta) + sin(gamma - delta - phi)*(sin(gamma - delta) -
    //   2*beta_rate_dot_of_place_12))))) - beta_rate_dot_of_place_9*beta_rate_dot_of_place_11) -
    //   d1_of_place_15*beta_rate_dot_of_place_11)
    let beta_rate_dot_of_place_13 = rr_cos_angle_inv
        * (sin_theta
            * (sin_theta
                * (zt_inv
                    * (-(sin_phi_d1_of_place_4 * d1_of_place_4_zt_inv))
                        .mul_add(cos_phi_inv_sq, beta_rate_dot_of_place_8)
                    + e_inv
                        * (ss_inv
                            * sin_angle_cos_angle_inv
                                .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta)
                            - cos_phi_inv
                                * (zt_inv
                                    * (d1_of_place_4
                                        * (-beta_rate_dot_of_place_12)
                                            .mul_add(S::int(2), sin_gamma_minus_delta)
                                        + beta_rate_dot_of_place_6 * cos_gamma_minus_delta)
                                    + d1_of_place_6 * beta_rate_dot_of_place_12)))
                - beta_rate_dot_of_place_9 * beta_rate_dot_of_place_11)
            - d1_of_place_15 * beta_rate_dot_of_place_11) + beta_rate_dot_of_place_11 * cos_theta;
    // ss_inv*(cos(theta) + rr_cos_angle_inv*(ss_inv*sin_theta_sq*sin_angle_cos_angle_inv -
    //   d1_of_d_beta_gamma*(cos(theta) + sin_angle_cos_angle_inv*sin(theta))))
    let beta_rate_dot_of_place_14 = ss_inv
        * (cos_theta
            + rr_cos_angle_inv
                * (-d1_of_d_beta_gamma * sin_angle_cos_angle_inv.mul_add(sin_theta, cos_theta)
                    + ss_inv * sin_theta_sq * sin_angle_cos_angle_inv));
    // sin(gamma - epsilon)*cos(omega) - cos(gamma - epsilon)*sin(omega)
    let beta_rate_dot_of_place_15 = (-cos_gamma_minus_epsilon)
        .mul_add(sin_omega, sin_gamma_minus_epsilon * cos_omega);
    let beta_rate_dot_of_place_16 = sin_omega_d1_of_place_10 * cos_omega_inv;
    let beta_rate_dot_of_place_17 = d1_of_place_10_u_2_inv * beta_rate_dot_of_place_16;
    // ss_inv*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv)
    let beta_rate_dot_of_place_18 = ss_inv
        * d1_of_place_10.mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_15);
    // rr_cos_angle_inv*(cos(gamma - epsilon - omega)*d1_of_place_15 -
    //   sin(theta)*(sin(theta)*(cos_omega_inv*(beta_rate_dot_of_place_17 - d1_of_place_12*(sin(gamma -
    //   epsilon - omega) + beta_rate_dot_of_place_16)) + beta_rate_dot_of_place_18) - cos(gamma - epsilon -
    //   omega)*beta_rate_dot_of_place_9)) - cos(gamma - epsilon - omega)*cos(theta)
    let beta_rate_dot_of_place_19 = rr_cos_angle_inv
        * (-sin_theta
            * (sin_theta
                * (cos_omega_inv
                    * (beta_rate_dot_of_place_17
                        - d1_of_place_12 * (beta_rate_dot_of_place_15 + beta_rate_dot_of_place_16))
                    + beta_rate_dot_of_place_18) - d1_of_place_10 * beta_rate_dot_of_place_9)
            + d1_of_place_10 * d1_of_place_15) - d1_of_place_10 * cos_theta;
    let u_2_sin_omega = u_2 * sin_omega;
    // d1_of_place_12 - d1_of_place_10_u_2_inv
    let beta_rate_dot_of_place_20 = d1_of_place_12 - d1_of_place_10_u_2_inv;
    // rr_cos_angle_inv*(d1_of_place_15*beta_rate_dot_of_place_20 +
    //   sin(theta)*(sin(theta)*(zf_inv*(d1_of_place_9*d1_of_place_12*cos_omega_inv_sq + ss_inv*(cos(gamma -
    //   epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon))) +
    //   u_2_inv*(cos_omega_inv*(beta_rate_dot_of_place_17 - zf_inv*(sin(gamma - epsilon - omega)*sin(gamma -
    //   epsilon) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon) + 2*d1_of_place_9*cos_omega_inv))) +
    //   beta_rate_dot_of_place_18)) + beta_rate_dot_of_place_9*beta_rate_dot_of_place_20)) -
    //   beta_rate_dot_of_place_20*cos(theta)
    let beta_rate_dot_of_place_21 = rr_cos_angle_inv
        * (sin_theta
            * (sin_theta
                * (zf_inv
                    * (ss_inv
                        * (-sin_angle_cos_angle_inv)
                            .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon)
                        + d1_of_place_9 * d1_of_place_12 * cos_omega_inv_sq)
                    + u_2_inv
                        * (cos_omega_inv
                            * (beta_rate_dot_of_place_17
                                - zf_inv
                                    * (d1_of_place_10
                                        * (d1_of_place_9 * cos_omega_inv)
                                            .mul_add(S::int(2), cos_gamma_minus_epsilon)
                                        + beta_rate_dot_of_place_15 * sin_gamma_minus_epsilon))
                            + beta_rate_dot_of_place_18))
                + beta_rate_dot_of_place_9 * beta_rate_dot_of_place_20)
            + d1_of_place_15 * beta_rate_dot_of_place_20) - beta_rate_dot_of_place_20 * cos_theta;
    // cos_phi_inv_sq*(zt_inv*beta_rate_dot_of_place_10*(i4_d1_of_place_6 + d1_of_place_7 + m4*(sin(gamma -
    //   delta - phi)*(zt + e_minus_ea*sin(phi)) + cos(gamma - delta)*(e + zt_sin_phi + ea*(e_inv*(ea -
    //   zt_sin_phi) - 2)))) + beta_rate_dot_of_place_13*(m4*(ea*(d1_of_place_2 - sin_phi_d1_of_place_4) +
    //   e*(cos(gamma - delta) + sin_phi_d1_of_place_4)) + i4_d1_of_place_6)) +
    //   d1_of_place_14*beta_rate_dot_of_place_14
    let beta_rate_dot_of_place_22 = cos_phi_inv_sq
        * (zt_inv * beta_rate_dot_of_place_10
            * (i4_d1_of_place_6 + d1_of_place_7
                + m4
                    * (d1_of_place_4 * e_minus_ea.mul_add(sin_phi, zt)
                        + cos_gamma_minus_delta
                            * (e + zt_sin_phi + ea * (e_inv * (ea - zt_sin_phi) - S::int(2)))))
            + beta_rate_dot_of_place_13
                * (m4
                    * (ea * (d1_of_place_2 - sin_phi_d1_of_place_4)
                        + e * (cos_gamma_minus_delta + sin_phi_d1_of_place_4))
                    + i4_d1_of_place_6)) + d1_of_place_14 * beta_rate_dot_of_place_14;
    let beta_rate_dot_of_place_23 = cos_angle_inv * d1_of_d_beta_gamma;
    let beta_rate_dot_of_beta_dot_2 = beta_dot * beta_rate_dot_of_beta_dot;
    // d_inv*beta_rate_dot_of_beta_dot_2*(sin(beta - gamma) - rr_cos_angle_inv*(ss_inv*sin(theta)*(sin(beta
    //   - gamma) - sin_angle_cos_angle_inv*cos(beta - gamma)) + beta_rate_dot_of_place_9*cos(beta - gamma)))
    let beta_rate_dot_of_beta_dot_3 = d_inv * beta_rate_dot_of_beta_dot_2
        * (sin_beta_minus_gamma
            - rr_cos_angle_inv
                * (ss_inv * sin_theta
                    * (-sin_angle_cos_angle_inv)
                        .mul_add(cos_beta_minus_gamma, sin_beta_minus_gamma)
                    + beta_rate_dot_of_place_9 * cos_beta_minus_gamma));
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
    // beta_rate' = (mom + rr^2*beta'^2*sin(theta)*(I3 + m3*(sa^2 + sb^2))*(cos(theta) -
    //   rr*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta) + sin(theta)*tan(beta
    //   + theta - gamma))/d)/cos(beta + theta - gamma))/(ss^2*cos(beta + theta - gamma)^2) +
    //   rr^2*beta'^2*(sin(beta - gamma) - rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d +
    //   sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta -
    //   gamma))*(I2*cos(beta - gamma)/(d*cos(beta + theta - gamma)) + m2*da*(da*cos(beta -
    //   gamma)/(d*cos(beta + theta - gamma)) - cos(theta)))/(d*cos(beta + theta - gamma)) +
    //   rr^2*beta'^2*sin(theta)*(cos(theta)*sin(gamma - delta - phi) + rr*(sin(theta)*(cos(beta -
    //   gamma)*sin(gamma - delta - phi)*tan(gamma - beta - theta)/d + sin(theta)*((sin(gamma - delta -
    //   phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta -
    //   phi)*tan(phi))/e)/cos(phi) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta
    //   - phi))/ss)) - cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d)/cos(beta + theta -
    //   gamma))*(I4*cos(gamma - delta)/e + sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   m4*(cos(gamma - delta)*(e + zt*sin(phi) + ea*((ea - zt*sin(phi))/e - 2)) + sin(gamma - delta -
    //   phi)*(zt + sin(phi)*(e - ea))))/(zt*cos(beta + theta - gamma)^2*cos(phi)^2) -
    //   rr^2*beta'^2*sin(theta)*(cos(theta)*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e) +
    //   rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d +
    //   sin(theta)*(sin(theta)*(((cos(gamma - delta)^2*tan(phi)/e + (cos(gamma - delta)*cos(gamma - delta -
    //   phi) + sin(gamma - delta - phi)*(sin(gamma - delta) - 2*cos(gamma - delta)*tan(phi)))/zt)/cos(phi) -
    //   (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)/e + (sin(gamma - delta -
    //   phi)^2*tan(phi)/(zt*cos(phi)) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss)/zt) + cos(beta - gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)/e -
    //   sin(gamma - delta - phi)/zt)/d))/cos(beta + theta - gamma))*(I4*cos(gamma - delta)/e +
    //   m4*(ea*(cos(gamma - delta)*(ea/e - 2) - sin(phi)*sin(gamma - delta - phi)) + e*(cos(gamma - delta) +
    //   sin(phi)*sin(gamma - delta - phi))))/(cos(beta + theta - gamma)^2*cos(phi)^2) +
    //   rr^2*beta'^2*sin(theta)*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta -
    //   gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - epsilon)*(sin(gamma - epsilon - omega)
    //   + cos(gamma - epsilon - omega)*tan(omega))/zf - cos(gamma - epsilon -
    //   omega)^2*tan(omega)/u)/cos(omega) - (sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma))/ss)))/cos(beta + theta - gamma))*(I6*sin(gamma - epsilon)/zf +
    //   cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + m6*(sin(gamma - epsilon)*(zf - u*sin(omega)
    //   + fa*((fa + u*sin(omega))/zf - 2)) + cos(gamma - epsilon - omega)*(u + sin(omega)*(fa -
    //   zf))))/(u*cos(beta + theta - gamma)^2*cos(omega)^2) - rr^2*beta'^2*sin(theta)*(cos(theta)*(cos(gamma
    //   - epsilon - omega)/u - sin(gamma - epsilon)/zf) + rr*(cos(theta)*cos(beta - gamma)*(sin(gamma -
    //   epsilon)/zf - cos(gamma - epsilon - omega)/u)/d + sin(theta)*(sin(theta)*(((sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss + (cos(gamma - epsilon -
    //   omega)^2*tan(omega)/u - (sin(gamma - epsilon)*sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*(cos(gamma - epsilon) + 2*sin(gamma - epsilon)*tan(omega)))/zf)/cos(omega))/u + ((sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf) + cos(beta - gamma)*tan(beta + theta - gamma)*(sin(gamma
    //   - epsilon)/zf - cos(gamma - epsilon - omega)/u)/d))/cos(beta + theta - gamma))*(I6*sin(gamma -
    //   epsilon)/zf + m6*(fa*(sin(gamma - epsilon)*(fa/zf - 2) + sin(omega)*cos(gamma - epsilon - omega)) +
    //   zf*(sin(gamma - epsilon) - sin(omega)*cos(gamma - epsilon - omega))))/(cos(beta + theta -
    //   gamma)^2*cos(omega)^2) + rr*sin(theta)*((c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) +
    //   sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb
    //   - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))) + m2*da*rr*beta'^2*cos(beta - gamma)/d - m4*(phi'^2*sin(gamma - delta -
    //   phi)*(e - ea) + delta'*(delta'*(e*sin(gamma - delta - phi) - zt*cos(gamma - delta) +
    //   ea*(zt*cos(gamma - delta)/e - sin(gamma - delta - phi))) + 2*phi'*sin(gamma - delta - phi)*(e -
    //   ea))) + m6*(omega'^2*cos(gamma - epsilon - omega)*(zf - fa) + epsilon'*(epsilon'*(u*sin(gamma -
    //   epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*(zf - fa)) + 2*omega'*cos(gamma - epsilon -
    //   omega)*(zf - fa))))/cos(beta + theta - gamma) - m2*da*(theta'^2 + beta'*(beta' + 2*theta'))))/d1
    let beta_rate_dot = (mom
        + sin_theta
            * (rr
                * (cos_angle_inv
                    * (rr * beta_dot * beta_dot * m2_da * d1_of_d_beta_gamma
                        + c0 * ss_inv * beta_rate_dot_of_place_24 * (l0 - beta_rate_dot_of_place_24)
                            * (-sd)
                                .mul_add(
                                    beta_rate_dot_of_place_2,
                                    sc * beta_rate_dot_of_place,
                                )
                            / (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
                                + sd * beta_rate_dot_of_place.mul_add(S::int(2), sd)
                                + sc * beta_rate_dot_of_place_2.mul_add(S::int(2), sc))
                        - m4
                            * (delta_dot
                                * (-delta_dot
                                    * (ea * (-zt).mul_add(d1_of_place_6, d1_of_place_4)
                                        + beta_rate_dot_of_place_3)
                                    + S::int(2) * beta_rate_dot_of_phi_dot)
                                + phi_dot * beta_rate_dot_of_phi_dot)
                        + m6
                            * (epsilon_dot
                                * (epsilon_dot
                                    * (beta_rate_dot_of_place_4
                                        + beta_rate_dot_of_place_5 * (fa_zf_inv - S::int(1)))
                                    + S::int(2) * beta_rate_dot_of_omega_dot)
                                + omega_dot * beta_rate_dot_of_omega_dot))
                    - m2_da
                        * (beta_dot * theta_dot.mul_add(S::int(2), beta_dot)
                            + theta_dot * theta_dot))
                + beta_rate_dot_of_beta_dot * beta_rate_dot_of_beta_dot
                    * (beta_rate_dot_of_place_22
                        - cos_omega_inv_sq
                            * (u_2_inv * beta_rate_dot_of_place_19
                                * (i6_d1_of_place_12 + d1_of_place_13
                                    + m6
                                        * (d1_of_place_10 * (-zf_minus_fa).mul_add(sin_omega, u_2)
                                            + sin_gamma_minus_epsilon
                                                * (zf - u_2_sin_omega
                                                    + fa * (zf_inv * (fa + u_2_sin_omega) - S::int(2)))))
                                + beta_rate_dot_of_place_21
                                    * (m6
                                        * (fa * (d1_of_place_8 + sin_omega_d1_of_place_10)
                                            + zf * (sin_gamma_minus_epsilon - sin_omega_d1_of_place_10))
                                        + i6_d1_of_place_12))))
        + rr * beta_rate_dot_of_beta_dot_3
            * (-m2_da * (-da).mul_add(beta_rate_dot_of_place_23, cos_theta)
                + I2 * beta_rate_dot_of_place_23)) / d1;
    // beta'' = beta_rate'
    let beta_ddot = beta_rate_dot;
    // theta'' = rr*beta'^2*(rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d + sin(theta)*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta - gamma) - sin(beta -
    //   gamma))/(d*cos(beta + theta - gamma)) + beta_rate'*(rr*cos(beta - gamma)/(d*cos(beta + theta -
    //   gamma)) - 1)
    let theta_ddot = beta_rate_dot * d1_of_d_beta_gamma.mul_add(rr_cos_angle_inv, -S::int(1))
        - beta_rate_dot_of_beta_dot_3;
    let gamma_ddot_of_motion = beta_rate_dot * rr_cos_angle_inv * sin_theta;
    // gamma'' = rr*beta'^2*(rr*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta)
    //   + sin(theta)*tan(beta + theta - gamma))/d)/cos(beta + theta - gamma) - cos(theta))/(ss*cos(beta +
    //   theta - gamma)) + rr*beta_rate'*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_ddot = (-beta_rate_dot_of_place_14)
        .mul_add(beta_rate_dot_of_beta_dot_2, ss_inv * gamma_ddot_of_motion);
    let zt_inv_cos_phi_inv = zt_inv * cos_phi_inv;
    // delta'' = rr*beta_rate'*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    //   - rr*beta'^2*(cos(theta)*sin(gamma - delta - phi) + rr*(sin(theta)*(cos(beta - gamma)*sin(gamma -
    //   delta - phi)*tan(gamma - beta - theta)/d + sin(theta)*((sin(gamma - delta - phi)^2*tan(phi)/zt +
    //   cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi) -
    //   (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss)) -
    //   cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d)/cos(beta + theta - gamma))/(zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let delta_ddot = (-(beta_rate_dot_of_place_10 * beta_rate_dot_of_beta_dot_2))
        .mul_add(
            zt_inv_cos_phi_inv,
            d1_of_place_4_zt_inv * cos_phi_inv * gamma_ddot_of_motion,
        );
    // phi'' = rr*beta'^2*(cos(theta)*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e) +
    //   rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d +
    //   sin(theta)*(sin(theta)*(((cos(gamma - delta)^2*tan(phi)/e + (cos(gamma - delta)*cos(gamma - delta -
    //   phi) + sin(gamma - delta - phi)*(sin(gamma - delta) - 2*cos(gamma - delta)*tan(phi)))/zt)/cos(phi) -
    //   (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)/e + (sin(gamma - delta -
    //   phi)^2*tan(phi)/(zt*cos(phi)) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss)/zt) + cos(beta - gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)/e -
    //   sin(gamma - delta - phi)/zt)/d))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(phi)) +
    //   rr*beta_rate'*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta + theta
    //   - gamma)*cos(phi))
    let phi_ddot = (-(cos_phi_inv * beta_rate_dot_of_place_13))
        .mul_add(
            beta_rate_dot_of_beta_dot_2,
            e_inv * beta_rate_dot_of_place_3 * gamma_ddot_of_motion * zt_inv_cos_phi_inv,
        );
    let u_2_inv_cos_omega_inv = u_2_inv * cos_omega_inv;
    // epsilon'' = rr*beta'^2*(rr*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d +
    //   sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d +
    //   sin(theta)*((sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(omega))/zf - cos(gamma - epsilon - omega)^2*tan(omega)/u)/cos(omega) - (sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)))/cos(beta + theta -
    //   gamma) - cos(theta)*cos(gamma - epsilon - omega))/(u*cos(beta + theta - gamma)*cos(omega)) +
    //   rr*beta_rate'*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_ddot = (beta_rate_dot_of_place_19 * beta_rate_dot_of_beta_dot_2)
        .mul_add(
            u_2_inv_cos_omega_inv,
            d1_of_place_10_u_2_inv * cos_omega_inv * gamma_ddot_of_motion,
        );
    // omega'' = rr*beta'^2*(cos(theta)*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf) +
    //   rr*(cos(theta)*cos(beta - gamma)*(sin(gamma - epsilon)/zf - cos(gamma - epsilon - omega)/u)/d +
    //   sin(theta)*(sin(theta)*(((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta +
    //   theta - gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - (sin(gamma - epsilon)*sin(gamma
    //   - epsilon - omega) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon) + 2*sin(gamma -
    //   epsilon)*tan(omega)))/zf)/cos(omega))/u + ((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf) + cos(beta -
    //   gamma)*tan(beta + theta - gamma)*(sin(gamma - epsilon)/zf - cos(gamma - epsilon -
    //   omega)/u)/d))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(omega)) +
    //   rr*beta_rate'*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon - omega))/(u*zf*cos(beta +
    //   theta - gamma)*cos(omega))
    let omega_ddot = zf_inv * gamma_ddot_of_motion * u_2_inv_cos_omega_inv
        * (-zf).mul_add(d1_of_place_10, beta_rate_dot_of_place_5)
        + cos_omega_inv * beta_rate_dot_of_place_21 * beta_rate_dot_of_beta_dot_2;
    // Values.
    // beta'
    let beta_dot_value = beta_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // gamma'
    let gamma_dot_value = gamma_dot;
    // delta'
    let delta_dot_value = delta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    // epsilon'
    let epsilon_dot_value = epsilon_dot;
    // omega'
    let omega_dot_value = omega_dot;
    (
        [
            beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
            epsilon_dot_value, omega_dot_value,
        ],
        [
            beta_ddot, theta_ddot, gamma_ddot, delta_ddot, phi_ddot, epsilon_ddot, omega_ddot,
        ],
    )
}

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')) row by row, and its right-hand side, which share terms.
///
/// 221 operations, 7 sines and cosines, 1 other function.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    q_dot: &[S; 7],
) -> ([S; 169], [S; 13]) {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    // I2 + m2*da^2
    let i2_plus_m2_da_sq = I2 + m2 * da * da;
    let m2_rr = m2 * rr;
    let da_m2_rr = da * m2_rr;
    let cos_theta_da_m2_rr = da_m2_rr * cos_theta;
    // i2_plus_m2_da_sq - cos_theta_da_m2_rr
    let m_1_2_of_place = i2_plus_m2_da_sq - cos_theta_da_m2_rr;
    // cos(beta)*sin(theta) + sin(beta)*cos(theta)
    let sin_beta_plus_theta = sin_beta.mul_add(cos_theta, cos_beta * sin_theta);
    let d_sin_beta_plus_theta = d * sin_beta_plus_theta;
    // rr*sin(beta) - d_sin_beta_plus_theta
    let m_1_8_of_place = rr.mul_add(sin_beta, -d_sin_beta_plus_theta);
    // cos(beta)*cos(theta) - sin(beta)*sin(theta)
    let cos_beta_plus_theta = (-sin_beta).mul_add(sin_theta, cos_beta * cos_theta);
    let d_cos_beta_plus_theta = d * cos_beta_plus_theta;
    // rr*cos(beta) - d_cos_beta_plus_theta
    let m_1_9_of_place = rr.mul_add(cos_beta, -d_cos_beta_plus_theta);
    let ss_cos_gamma = ss * cos_gamma;
    let ss_sin_gamma = ss * sin_gamma;
    // I4 + m4*(ea^2 + e*(e - 2*ea))
    let m_4_4_of_m4_i4_e_ea = I4 + m4 * (e * (-ea).mul_add(S::int(2), e) + ea * ea);
    let m4_zt = m4 * zt;
    // m4_zt*(e - ea)
    let m_4_4_of_m4_e_ea_zt = m4_zt * (e - ea);
    let m_4_4_of_place = m_4_4_of_m4_e_ea_zt * sin_phi;
    // m_4_4_of_m4_i4_e_ea + m_4_4_of_place
    let m_4_5_of_place = m_4_4_of_m4_i4_e_ea + m_4_4_of_place;
    // cos(delta)*cos(phi) - sin(delta)*sin(phi)
    let cos_delta_plus_phi = (-sin_delta).mul_add(sin_phi, cos_delta * cos_phi);
    let e_cos_delta_plus_phi = e * cos_delta_plus_phi;
    // zt*sin(delta) - e_cos_delta_plus_phi
    let m_4_10_of_place = zt.mul_add(sin_delta, -e_cos_delta_plus_phi);
    // cos(delta)*sin(phi) + sin(delta)*cos(phi)
    let sin_delta_plus_phi = sin_delta.mul_add(cos_phi, cos_delta * sin_phi);
    let e_sin_delta_plus_phi = e * sin_delta_plus_phi;
    // zt*cos(delta) + e_sin_delta_plus_phi
    let m_4_11_of_place = zt.mul_add(cos_delta, e_sin_delta_plus_phi);
    // I6 + m6*(fa^2 + zf*(zf - 2*fa))
    let m_6_6_of_m6_i6_zf_fa = I6 + m6 * (zf * (-fa).mul_add(S::int(2), zf) + fa * fa);
    let m6_u_2 = m6 * u_2;
    // m6_u_2*(zf - fa)
    let m_6_6_of_m6_u_2_zf_fa = m6_u_2 * (zf - fa);
    let m_6_6_of_place = m_6_6_of_m6_u_2_zf_fa * sin_omega;
    // m_6_6_of_m6_i6_zf_fa - m_6_6_of_place
    let m_6_7_of_place = m_6_6_of_m6_i6_zf_fa - m_6_6_of_place;
    // cos(epsilon)*sin(omega) + sin(epsilon)*cos(omega)
    let sin_epsilon_plus_omega = sin_epsilon.mul_add(cos_omega, cos_epsilon * sin_omega);
    let m_6_12_of_place = zf * sin_epsilon_plus_omega;
    // u*cos(epsilon) - m_6_12_of_place
    let m_6_12_of_place_2 = u_2.mul_add(cos_epsilon, -m_6_12_of_place);
    // cos(epsilon)*cos(omega) - sin(epsilon)*sin(omega)
    let cos_epsilon_plus_omega = (-sin_epsilon)
        .mul_add(sin_omega, cos_epsilon * cos_omega);
    let m_6_13_of_place = zf * cos_epsilon_plus_omega;
    // u*sin(epsilon) + m_6_13_of_place
    let m_6_13_of_place_2 = u_2.mul_add(sin_epsilon, m_6_13_of_place);
    // theta'*(2*beta' + theta')
    let f_1_of_motion = theta_dot * beta_dot.mul_add(S::int(2), theta_dot);
    let sin_theta_da_m2_rr = da_m2_rr * sin_theta;
    let beta_dot_sq = beta_dot * beta_dot;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*cos(gamma) - xb_minus_xc*sin(gamma)
    let f_3_of_place = (-xb_minus_xc).mul_add(sin_gamma, yb_minus_yc * cos_gamma);
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let f_3_of_place_2 = xb_minus_xc.mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // phi'*(2*delta' + phi')
    let f_4_of_motion = phi_dot * delta_dot.mul_add(S::int(2), phi_dot);
    let f_4_of_place = m_4_4_of_m4_e_ea_zt * cos_phi;
    let delta_dot_sq = delta_dot * delta_dot;
    // omega'*(2*epsilon' + omega')
    let f_6_of_motion = omega_dot * epsilon_dot.mul_add(S::int(2), omega_dot);
    let f_6_of_place = m_6_6_of_m6_u_2_zf_fa * cos_omega;
    let epsilon_dot_sq = epsilon_dot * epsilon_dot;
    // d_cos_beta_plus_theta*f_1_of_motion - m_1_9_of_place*beta_dot_sq
    let f_8_of_motion = (-m_1_9_of_place)
        .mul_add(beta_dot_sq, d_cos_beta_plus_theta * f_1_of_motion);
    let gamma_dot_sq = gamma_dot * gamma_dot;
    // d_sin_beta_plus_theta*f_1_of_motion - m_1_8_of_place*beta_dot_sq
    let f_9_of_motion = (-m_1_8_of_place)
        .mul_add(beta_dot_sq, d_sin_beta_plus_theta * f_1_of_motion);
    // xb*(xb - 2*xc)
    let f_3_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let f_3_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // -m_1_8_of_place
    let minus_m_1_8_of_place = -m_1_8_of_place;
    // -d_cos_beta_plus_theta
    let m_2_9_of_d_beta_theta = -d_cos_beta_plus_theta;
    // -d_sin_beta_plus_theta
    let m_8_2_of_d_beta_theta = -d_sin_beta_plus_theta;
    // -m_1_9_of_place
    let minus_m_1_9_of_place = -m_1_9_of_place;
    // Values.
    // M_1_1 = I1 + I2 + m1*ra^2 + m2*(rr^2 + da*(da - 2*rr*cos(theta)))
    let m_1_1 = rr.mul_add(m2_rr, I1 + m1 * ra * ra + i2_plus_m2_da_sq)
        - S::int(2) * cos_theta_da_m2_rr;
    // M_1_2 = I2 + m2*da*(da - rr*cos(theta))
    let m_1_2 = m_1_2_of_place;
    // M_1_8 = d*sin(beta + theta) - rr*sin(beta)
    let m_1_8 = minus_m_1_8_of_place;
    // M_1_9 = rr*cos(beta) - d*cos(beta + theta)
    let m_1_9 = m_1_9_of_place;
    // M_1_10 = d*sin(beta + theta) - rr*sin(beta)
    let m_1_10 = minus_m_1_8_of_place;
    // M_1_11 = rr*cos(beta) - d*cos(beta + theta)
    let m_1_11 = m_1_9_of_place;
    // M_1_12 = d*sin(beta + theta) - rr*sin(beta)
    let m_1_12 = minus_m_1_8_of_place;
    // M_1_13 = rr*cos(beta) - d*cos(beta + theta)
    let m_1_13 = m_1_9_of_place;
    // M_2_1 = I2 + m2*da*(da - rr*cos(theta))
    let m_2_1 = m_1_2_of_place;
    // M_2_2 = I2 + m2*da^2
    let m_2_2 = i2_plus_m2_da_sq;
    // M_2_8 = d*sin(beta + theta)
    let m_2_8 = d_sin_beta_plus_theta;
    // M_2_9 = -d*cos(beta + theta)
    let m_2_9 = m_2_9_of_d_beta_theta;
    // M_2_10 = d*sin(beta + theta)
    let m_2_10 = d_sin_beta_plus_theta;
    // M_2_11 = -d*cos(beta + theta)
    let m_2_11 = m_2_9_of_d_beta_theta;
    // M_2_12 = d*sin(beta + theta)
    let m_2_12 = d_sin_beta_plus_theta;
    // M_2_13 = -d*cos(beta + theta)
    let m_2_13 = m_2_9_of_d_beta_theta;
    // M_3_3 = I3 + m3*(sa^2 + sb^2)
    let m_3_3 = I3 + m3 * sb.mul_add(sb, sa * sa);
    // M_3_8 = -ss*cos(gamma)
    let m_3_8 = -ss_cos_gamma;
    // M_3_9 = -ss*sin(gamma)
    let m_3_9 = -ss_sin_gamma;
    // M_4_4 = I4 + I5 + m5*(ta^2 + tb^2) + m4*((e - ea)^2 + zt*(zt + 2*sin(phi)*(e - ea)))
    let m_4_4 = I5 + m5 * tb.mul_add(tb, ta * ta) + m_4_4_of_m4_i4_e_ea + zt * m4_zt
        + S::int(2) * m_4_4_of_place;
    // M_4_5 = I4 + m4*(e - ea)*(e - ea + zt*sin(phi))
    let m_4_5 = m_4_5_of_place;
    // M_4_10 = zt*sin(delta) - e*cos(delta + phi)
    let m_4_10 = m_4_10_of_place;
    // M_4_11 = -zt*cos(delta) - e*sin(delta + phi)
    let m_4_11 = -m_4_11_of_place;
    // M_5_4 = I4 + m4*(e - ea)*(e - ea + zt*sin(phi))
    let m_5_4 = m_4_5_of_place;
    // M_5_5 = I4 + m4*(e - ea)^2
    let m_5_5 = m_4_4_of_m4_i4_e_ea;
    // M_5_10 = -e*cos(delta + phi)
    let m_5_10 = -e_cos_delta_plus_phi;
    // M_5_11 = -e*sin(delta + phi)
    let m_5_11 = -e_sin_delta_plus_phi;
    // M_6_6 = I6 + I7 + m7*(ua^2 + ub^2) + m6*((zf - fa)^2 + u*(u + 2*sin(omega)*(fa - zf)))
    let m_6_6 = I7 + m7 * ub.mul_add(ub, ua * ua) + m_6_6_of_m6_i6_zf_fa + u_2 * m6_u_2
        - S::int(2) * m_6_6_of_place;
    // M_6_7 = I6 + m6*(zf - fa)*(zf - fa - u*sin(omega))
    let m_6_7 = m_6_7_of_place;
    // M_6_12 = zf*sin(epsilon + omega) - u*cos(epsilon)
    let m_6_12 = -m_6_12_of_place_2;
    // M_6_13 = -u*sin(epsilon) - zf*cos(epsilon + omega)
    let m_6_13 = -m_6_13_of_place_2;
    // M_7_6 = I6 + m6*(zf - fa)*(zf - fa - u*sin(omega))
    let m_7_6 = m_6_7_of_place;
    // M_7_7 = I6 + m6*(zf - fa)^2
    let m_7_7 = m_6_6_of_m6_i6_zf_fa;
    // M_7_12 = zf*sin(epsilon + omega)
    let m_7_12 = m_6_12_of_place;
    // M_7_13 = -zf*cos(epsilon + omega)
    let m_7_13 = -m_6_13_of_place;
    // M_8_1 = rr*sin(beta) - d*sin(beta + theta)
    let m_8_1 = m_1_8_of_place;
    // M_8_2 = -d*sin(beta + theta)
    let m_8_2 = m_8_2_of_d_beta_theta;
    // M_8_3 = ss*cos(gamma)
    let m_8_3 = ss_cos_gamma;
    // M_9_1 = d*cos(beta + theta) - rr*cos(beta)
    let m_9_1 = minus_m_1_9_of_place;
    // M_9_2 = d*cos(beta + theta)
    let m_9_2 = d_cos_beta_plus_theta;
    // M_9_3 = ss*sin(gamma)
    let m_9_3 = ss_sin_gamma;
    // M_10_1 = rr*sin(beta) - d*sin(beta + theta)
    let m_10_1 = m_1_8_of_place;
    // M_10_2 = -d*sin(beta + theta)
    let m_10_2 = m_8_2_of_d_beta_theta;
    // M_10_4 = e*cos(delta + phi) - zt*sin(delta)
    let m_10_4 = -m_4_10_of_place;
    // M_10_5 = e*cos(delta + phi)
    let m_10_5 = e_cos_delta_plus_phi;
    // M_11_1 = d*cos(beta + theta) - rr*cos(beta)
    let m_11_1 = minus_m_1_9_of_place;
    // M_11_2 = d*cos(beta + theta)
    let m_11_2 = d_cos_beta_plus_theta;
    // M_11_4 = zt*cos(delta) + e*sin(delta + phi)
    let m_11_4 = m_4_11_of_place;
    // M_11_5 = e*sin(delta + phi)
    let m_11_5 = e_sin_delta_plus_phi;
    // M_12_1 = rr*sin(beta) - d*sin(beta + theta)
    let m_12_1 = m_1_8_of_place;
    // M_12_2 = -d*sin(beta + theta)
    let m_12_2 = m_8_2_of_d_beta_theta;
    // M_12_6 = u*cos(epsilon) - zf*sin(epsilon + omega)
    let m_12_6 = m_6_12_of_place_2;
    // M_12_7 = -zf*sin(epsilon + omega)
    let m_12_7 = -m_6_12_of_place;
    // M_13_1 = d*cos(beta + theta) - rr*cos(beta)
    let m_13_1 = minus_m_1_9_of_place;
    // M_13_2 = d*cos(beta + theta)
    let m_13_2 = d_cos_beta_plus_theta;
    // M_13_6 = u*sin(epsilon) + zf*cos(epsilon + omega)
    let m_13_6 = m_6_13_of_place_2;
    // M_13_7 = zf*cos(epsilon + omega)
    let m_13_7 = m_6_13_of_place;
    // f_1 = mom - m2*da*rr*theta'*sin(theta)*(2*beta' + theta')
    let f_1 = (-f_1_of_motion).mul_add(sin_theta_da_m2_rr, mom);
    // f_2 = m2*da*rr*beta'^2*sin(theta)
    let f_2 = sin_theta_da_m2_rr * beta_dot_sq;
    // f_3 = c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma))
    //   + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sc*cos(gamma) - sd*sin(gamma))*(l0 - sqrt((xb -
    //   xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
    //   yc)*(sd*sin(gamma) - sc*cos(gamma))))*(xb - xc + sc*sin(gamma) + sd*cos(gamma))/((xb - xc)^2 + (yb -
    //   yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
    //   sc*cos(gamma))) + c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) +
    //   sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sc*sin(gamma) + sd*cos(gamma))*(l0 -
    //   sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
    //   yc)*(sd*sin(gamma) - sc*cos(gamma))))*(yb - yc + sd*sin(gamma) - sc*cos(gamma))/((xb - xc)^2 + (yb -
    //   yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
    //   sc*cos(gamma)))
    let f_3 = c0 * sc.mul_add(f_3_of_place_2, sd * f_3_of_place)
        * (l0
            * (xc_sq + f_3_of_xb_xc + yc_sq + f_3_of_yb_yc
                + sc
                    * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                        - S::int(2) * cos_gamma * yb_minus_yc)
                + sd
                    * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                        + S::int(2) * cos_gamma * xb_minus_xc))
                .sqrt()
            / (xc_sq + f_3_of_xb_xc + yc_sq + f_3_of_yb_yc
                + sc * (-f_3_of_place).mul_add(S::int(2), sc)
                + sd * f_3_of_place_2.mul_add(S::int(2), sd)) - S::int(1));
    // f_4 = m4*zt*phi'*cos(phi)*(ea - e)*(2*delta' + phi')
    let f_4 = -f_4_of_motion * f_4_of_place;
    // f_5 = m4*zt*delta'^2*cos(phi)*(e - ea)
    let f_5 = f_4_of_place * delta_dot_sq;
    // f_6 = m6*u*omega'*cos(omega)*(zf - fa)*(2*epsilon' + omega')
    let f_6 = f_6_of_motion * f_6_of_place;
    // f_7 = m6*u*epsilon'^2*cos(omega)*(fa - zf)
    let f_7 = -f_6_of_place * epsilon_dot_sq;
    // f_8 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + ss*gamma'^2*sin(gamma)
    let f_8 = ss_sin_gamma.mul_add(gamma_dot_sq, f_8_of_motion);
    // f_9 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) - ss*gamma'^2*cos(gamma)
    let f_9 = (-ss_cos_gamma).mul_add(gamma_dot_sq, f_9_of_motion);
    // f_10 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + zt*delta'^2*cos(delta) +
    //   e*sin(delta + phi)*(delta' + phi')^2
    let f_10 = m_4_11_of_place
        .mul_add(delta_dot_sq, e_sin_delta_plus_phi * f_4_of_motion) + f_8_of_motion;
    // f_11 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) + zt*delta'^2*sin(delta) -
    //   e*cos(delta + phi)*(delta' + phi')^2
    let f_11 = (-e_cos_delta_plus_phi)
        .mul_add(f_4_of_motion, m_4_10_of_place * delta_dot_sq) + f_9_of_motion;
    // f_12 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + u*epsilon'^2*sin(epsilon) +
    //   zf*cos(epsilon + omega)*(epsilon' + omega')^2
    let f_12 = m_6_13_of_place_2.mul_add(epsilon_dot_sq, m_6_13_of_place * f_6_of_motion)
        + f_8_of_motion;
    // f_13 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) - u*epsilon'^2*cos(epsilon) +
    //   zf*sin(epsilon + omega)*(epsilon' + omega')^2
    let f_13 = (-m_6_12_of_place_2)
        .mul_add(epsilon_dot_sq, m_6_12_of_place * f_6_of_motion) + f_9_of_motion;
    let zero = S::int(0);
    (
        [
            m_1_1, m_1_2, zero, zero, zero, zero, zero, m_1_8, m_1_9, m_1_10, m_1_11, m_1_12,
            m_1_13, m_2_1, m_2_2, zero, zero, zero, zero, zero, m_2_8, m_2_9, m_2_10, m_2_11,
            m_2_12, m_2_13, zero, zero, m_3_3, zero, zero, zero, zero, m_3_8, m_3_9, zero, zero,
            zero, zero, zero, zero, zero, m_4_4, m_4_5, zero, zero, zero, zero, m_4_10, m_4_11,
            zero, zero, zero, zero, zero, m_5_4, m_5_5, zero, zero, zero, zero, m_5_10, m_5_11,
            zero, zero, zero, zero, zero, zero, zero, m_6_6, m_6_7, zero, zero, zero, zero, m_6_12,
            m_6_13, zero, zero, zero, zero, zero, m_7_6, m_7_7, zero, zero, zero, zero, m_7_12,
            m_7_13, m_8_1, m_8_2, m_8_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_9_1, m_9_2, m_9_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_10_1,
            m_10_2, zero, m_10_4, m_10_5, zero, zero, zero, zero, zero, zero, zero, zero, m_11_1,
            m_11_2, zero, m_11_4, m_11_5, zero, zero, zero, zero, zero, zero, zero, zero, m_12_1,
            m_12_2, zero, zero, zero, m_12_6, m_12_7, zero, zero, zero, zero, zero, zero, m_13_1,
            m_13_2, zero, zero, zero, m_13_6, m_13_7, zero, zero, zero, zero, zero, zero,
        ],
        [f_1, f_2, f_3, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 2 operations, 3 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 7], _q_dot: &[S; 7]) -> [S; 3] {
    let [beta, theta, gamma, _, phi, _, omega] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (_, cos_omega) = omega.sin_cos();
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    // Values.
    // divisor1 = cos(beta + theta - gamma)
    let divisor1 = cos_angle;
    // divisor2 = cos(phi)
    let divisor2 = cos_phi;
    // divisor3 = cos(omega)
    let divisor3 = cos_omega;
    [divisor1, divisor2, divisor3]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 61 operations, 7 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 7], q_dot: &[S; 7]) -> [S; 12] {
    let Parameters { xa, ya, xb, yb, d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
    // Sines and cosines.
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    // beta + theta
    let beta_plus_theta = beta + theta;
    let (sin_beta_plus_theta, cos_beta_plus_theta) = beta_plus_theta.sin_cos();
    let d_cos_beta_plus_theta = d * cos_beta_plus_theta;
    // rr*cos(beta) - d_cos_beta_plus_theta
    let residual_1_of_place = rr.mul_add(cos_beta, -d_cos_beta_plus_theta);
    let ss_sin_gamma = ss * sin_gamma;
    let d_sin_beta_plus_theta = d * sin_beta_plus_theta;
    // rr*sin(beta) - d_sin_beta_plus_theta
    let residual_2_of_place = rr.mul_add(sin_beta, -d_sin_beta_plus_theta);
    let ss_cos_gamma = ss * cos_gamma;
    let zt_cos_delta = zt * cos_delta;
    // delta + phi
    let delta_plus_phi = delta + phi;
    let (sin_delta_plus_phi, cos_delta_plus_phi) = delta_plus_phi.sin_cos();
    let e_sin_delta_plus_phi = e * sin_delta_plus_phi;
    // xa - residual_1_of_place
    let residual_3_of_place = xa - residual_1_of_place;
    let zt_sin_delta = zt * sin_delta;
    let e_cos_delta_plus_phi = e * cos_delta_plus_phi;
    // ya - residual_2_of_place
    let residual_4_of_place = ya - residual_2_of_place;
    let u_2_sin_epsilon = u_2 * sin_epsilon;
    // epsilon + omega
    let epsilon_plus_omega = epsilon + omega;
    let (sin_epsilon_plus_omega, cos_epsilon_plus_omega) = epsilon_plus_omega.sin_cos();
    let residual_5_of_place = zf * cos_epsilon_plus_omega;
    let u_2_cos_epsilon = u_2 * cos_epsilon;
    let residual_6_of_place = zf * sin_epsilon_plus_omega;
    // theta'*d_sin_beta_plus_theta - beta'*residual_2_of_place
    let residual_7_of_motion = (-beta_dot)
        .mul_add(residual_2_of_place, theta_dot * d_sin_beta_plus_theta);
    // theta'*d_cos_beta_plus_theta - beta'*residual_1_of_place
    let residual_8_of_motion = (-beta_dot)
        .mul_add(residual_1_of_place, theta_dot * d_cos_beta_plus_theta);
    // delta' + phi'
    let delta_dot_plus_phi_dot = delta_dot + phi_dot;
    // epsilon' + omega'
    let residual_11_of_motion = epsilon_dot + omega_dot;
    // Values.
    // E3_1 = xb - rr*cos(beta) + d*cos(beta + theta) + ss*sin(gamma)
    let residual_1 = xb - residual_1_of_place + ss_sin_gamma;
    // E3_2 = yb - rr*sin(beta) + d*sin(beta + theta) - ss*cos(gamma)
    let residual_2 = yb - residual_2_of_place - ss_cos_gamma;
    // E4_1 = xa - rr*cos(beta) + d*cos(beta + theta) + zt*cos(delta) + e*sin(delta + phi)
    let residual_3 = zt_cos_delta + e_sin_delta_plus_phi + residual_3_of_place;
    // E4_2 = ya - rr*sin(beta) + d*sin(beta + theta) + zt*sin(delta) - e*cos(delta + phi)
    let residual_4 = zt_sin_delta - e_cos_delta_plus_phi + residual_4_of_place;
    // E6_1 = xa - rr*cos(beta) + d*cos(beta + theta) + u*sin(epsilon) + zf*cos(epsilon + omega)
    let residual_5 = residual_3_of_place + u_2_sin_epsilon + residual_5_of_place;
    // E6_2 = ya - rr*sin(beta) + d*sin(beta + theta) - u*cos(epsilon) + zf*sin(epsilon + omega)
    let residual_6 = residual_4_of_place - u_2_cos_epsilon + residual_6_of_place;
    // E3_1' = rr*beta'*sin(beta) - d*sin(beta + theta)*(beta' + theta') + ss*gamma'*cos(gamma)
    let residual_7 = gamma_dot.mul_add(ss_cos_gamma, -residual_7_of_motion);
    // E3_2' = d*cos(beta + theta)*(beta' + theta') - rr*beta'*cos(beta) + ss*gamma'*sin(gamma)
    let residual_8 = gamma_dot.mul_add(ss_sin_gamma, residual_8_of_motion);
    // E4_1' = rr*beta'*sin(beta) - d*sin(beta + theta)*(beta' + theta') - zt*delta'*sin(delta) +
    //   e*cos(delta + phi)*(delta' + phi')
    let residual_9 = (-delta_dot)
        .mul_add(zt_sin_delta, e_cos_delta_plus_phi * delta_dot_plus_phi_dot)
        - residual_7_of_motion;
    // E4_2' = d*cos(beta + theta)*(beta' + theta') - rr*beta'*cos(beta) + zt*delta'*cos(delta) +
    //   e*sin(delta + phi)*(delta' + phi')
    let residual_10 = delta_dot.mul_add(zt_cos_delta, residual_8_of_motion)
        + e_sin_delta_plus_phi * delta_dot_plus_phi_dot;
    // E6_1' = rr*beta'*sin(beta) - d*sin(beta + theta)*(beta' + theta') + u*epsilon'*cos(epsilon) -
    //   zf*sin(epsilon + omega)*(epsilon' + omega')
    let residual_11 = epsilon_dot.mul_add(u_2_cos_epsilon, -residual_7_of_motion)
        - residual_6_of_place * residual_11_of_motion;
    // E6_2' = d*cos(beta + theta)*(beta' + theta') - rr*beta'*cos(beta) + u*epsilon'*sin(epsilon) +
    //   zf*cos(epsilon + omega)*(epsilon' + omega')
    let residual_12 = epsilon_dot.mul_add(u_2_sin_epsilon, residual_8_of_motion)
        + residual_5_of_place * residual_11_of_motion;
    [
        residual_1, residual_2, residual_3, residual_4, residual_5, residual_6, residual_7,
        residual_8, residual_9, residual_10, residual_11, residual_12,
    ]
}

/// Slopes of the constraints, one after the other, along beta, theta, gamma, delta, phi, epsilon, omega, beta', theta', gamma', delta', phi', epsilon', omega'.
///
/// 58 operations, 7 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    q_dot: &[S; 7],
) -> [S; 168] {
    let Parameters { d, e, rr, ss, zt, u: u_2, zf, .. } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_dot, theta_dot, gamma_dot, delta_dot, phi_dot, epsilon_dot, omega_dot] = *q_dot;
    // Sines and cosines.
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_epsilon, cos_epsilon) = epsilon.sin_cos();
    // Shared terms.
    // beta + theta
    let beta_plus_theta = beta + theta;
    let (sin_beta_plus_theta, cos_beta_plus_theta) = beta_plus_theta.sin_cos();
    let d_sin_beta_plus_theta = d * sin_beta_plus_theta;
    let rr_sin_beta = rr * sin_beta;
    // rr_sin_beta - d_sin_beta_plus_theta
    let residual_1_by_beta_of_place = rr_sin_beta - d_sin_beta_plus_theta;
    let ss_cos_gamma = ss * cos_gamma;
    let d_cos_beta_plus_theta = d * cos_beta_plus_theta;
    let rr_cos_beta = rr * cos_beta;
    // rr_cos_beta - d_cos_beta_plus_theta
    let residual_2_by_beta_of_place = rr_cos_beta - d_cos_beta_plus_theta;
    let ss_sin_gamma = ss * sin_gamma;
    // delta + phi
    let delta_plus_phi = delta + phi;
    let (sin_delta_plus_phi, cos_delta_plus_phi) = delta_plus_phi.sin_cos();
    let e_cos_delta_plus_phi = e * cos_delta_plus_phi;
    let zt_sin_delta = zt * sin_delta;
    // e_cos_delta_plus_phi - zt_sin_delta
    let residual_3_by_delta_of_place = e_cos_delta_plus_phi - zt_sin_delta;
    let e_sin_delta_plus_phi = e * sin_delta_plus_phi;
    let zt_cos_delta = zt * cos_delta;
    // e_sin_delta_plus_phi + zt_cos_delta
    let residual_4_by_delta_of_place = e_sin_delta_plus_phi + zt_cos_delta;
    // epsilon + omega
    let epsilon_plus_omega = epsilon + omega;
    let (sin_epsilon_plus_omega, cos_epsilon_plus_omega) = epsilon_plus_omega.sin_cos();
    let residual_5_by_epsilon_of_place = zf * sin_epsilon_plus_omega;
    let u_2_cos_epsilon = u_2 * cos_epsilon;
    // residual_5_by_epsilon_of_place - u_2_cos_epsilon
    let residual_5_by_epsilon_of_place_2 = residual_5_by_epsilon_of_place - u_2_cos_epsilon;
    let residual_6_by_epsilon_of_place = zf * cos_epsilon_plus_omega;
    let u_2_sin_epsilon = u_2 * sin_epsilon;
    // residual_6_by_epsilon_of_place + u_2_sin_epsilon
    let residual_6_by_epsilon_of_place_2 = residual_6_by_epsilon_of_place + u_2_sin_epsilon;
    // beta' + theta'
    let beta_dot_plus_theta_dot = beta_dot + theta_dot;
    let residual_7_by_beta_of_motion = d_cos_beta_plus_theta * beta_dot_plus_theta_dot;
    // beta'*rr_cos_beta - residual_7_by_beta_of_motion
    let residual_7_by_beta_of_motion_2 = beta_dot
        .mul_add(rr_cos_beta, -residual_7_by_beta_of_motion);
    let residual_8_by_beta_of_motion = d_sin_beta_plus_theta * beta_dot_plus_theta_dot;
    // beta'*rr_sin_beta - residual_8_by_beta_of_motion
    let residual_8_by_beta_of_motion_2 = beta_dot
        .mul_add(rr_sin_beta, -residual_8_by_beta_of_motion);
    // delta' + phi'
    let delta_dot_plus_phi_dot = delta_dot + phi_dot;
    let residual_9_by_delta_of_motion = e_sin_delta_plus_phi * delta_dot_plus_phi_dot;
    let residual_10_by_delta_of_motion = e_cos_delta_plus_phi * delta_dot_plus_phi_dot;
    // epsilon' + omega'
    let residual_11_by_epsilon_of_motion = epsilon_dot + omega_dot;
    let residual_11_by_epsilon_of_motion_2 = residual_6_by_epsilon_of_place
        * residual_11_by_epsilon_of_motion;
    let residual_12_by_epsilon_of_motion = residual_5_by_epsilon_of_place
        * residual_11_by_epsilon_of_motion;
    // -d_sin_beta_plus_theta
    let residual_1_by_theta_of_d_beta_theta = -d_sin_beta_plus_theta;
    // -residual_2_by_beta_of_place
    let residual_2_by_beta_of_place_2 = -residual_2_by_beta_of_place;
    // -residual_5_by_epsilon_of_place_2
    let residual_5_by_epsilon_of_place_3 = -residual_5_by_epsilon_of_place_2;
    // -residual_5_by_epsilon_of_place
    let residual_5_by_omega_of_place = -residual_5_by_epsilon_of_place;
    // -residual_7_by_beta_of_motion
    let residual_7_by_theta_of_motion = -residual_7_by_beta_of_motion;
    // -residual_8_by_beta_of_motion
    let residual_8_by_theta_of_motion = -residual_8_by_beta_of_motion;
    // Values.
    // d(E3_1)/d(beta) = rr*sin(beta) - d*sin(beta + theta)
    let residual_1_by_beta = residual_1_by_beta_of_place;
    // d(E3_1)/d(theta) = -d*sin(beta + theta)
    let residual_1_by_theta = residual_1_by_theta_of_d_beta_theta;
    // d(E3_1)/d(gamma) = ss*cos(gamma)
    let residual_1_by_gamma = ss_cos_gamma;
    // d(E3_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual_2_by_beta = residual_2_by_beta_of_place_2;
    // d(E3_2)/d(theta) = d*cos(beta + theta)
    let residual_2_by_theta = d_cos_beta_plus_theta;
    // d(E3_2)/d(gamma) = ss*sin(gamma)
    let residual_2_by_gamma = ss_sin_gamma;
    // d(E4_1)/d(beta) = rr*sin(beta) - d*sin(beta + theta)
    let residual_3_by_beta = residual_1_by_beta_of_place;
    // d(E4_1)/d(theta) = -d*sin(beta + theta)
    let residual_3_by_theta = residual_1_by_theta_of_d_beta_theta;
    // d(E4_1)/d(delta) = e*cos(delta + phi) - zt*sin(delta)
    let residual_3_by_delta = residual_3_by_delta_of_place;
    // d(E4_1)/d(phi) = e*cos(delta + phi)
    let residual_3_by_phi = e_cos_delta_plus_phi;
    // d(E4_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual_4_by_beta = residual_2_by_beta_of_place_2;
    // d(E4_2)/d(theta) = d*cos(beta + theta)
    let residual_4_by_theta = d_cos_beta_plus_theta;
    // d(E4_2)/d(delta) = zt*cos(delta) + e*sin(delta + phi)
    let residual_4_by_delta = residual_4_by_delta_of_place;
    // d(E4_2)/d(phi) = e*sin(delta + phi)
    let residual_4_by_phi = e_sin_delta_plus_phi;
    // d(E6_1)/d(beta) = rr*sin(beta) - d*sin(beta + theta)
    let residual_5_by_beta = residual_1_by_beta_of_place;
    // d(E6_1)/d(theta) = -d*sin(beta + theta)
    let residual_5_by_theta = residual_1_by_theta_of_d_beta_theta;
    // d(E6_1)/d(epsilon) = u*cos(epsilon) - zf*sin(epsilon + omega)
    let residual_5_by_epsilon = residual_5_by_epsilon_of_place_3;
    // d(E6_1)/d(omega) = -zf*sin(epsilon + omega)
    let residual_5_by_omega = residual_5_by_omega_of_place;
    // d(E6_2)/d(beta) = d*cos(beta + theta) - rr*cos(beta)
    let residual_6_by_beta = residual_2_by_beta_of_place_2;
    // d(E6_2)/d(theta) = d*cos(beta + theta)
    let residual_6_by_theta = d_cos_beta_plus_theta;
    // d(E6_2)/d(epsilon) = u*sin(epsilon) + zf*cos(epsilon + omega)
    let residual_6_by_epsilon = residual_6_by_epsilon_of_place_2;
    // d(E6_2)/d(omega) = zf*cos(epsilon + omega)
    let residual_6_by_omega = residual_6_by_epsilon_of_place;
    // d(E3_1')/d(beta) = rr*beta'*cos(beta) - d*cos(beta + theta)*(beta' + theta')
    let residual_7_by_beta = residual_7_by_beta_of_motion_2;
    // d(E3_1')/d(theta) = -d*cos(beta + theta)*(beta' + theta')
    let residual_7_by_theta = residual_7_by_theta_of_motion;
    // d(E3_1')/d(gamma) = -ss*gamma'*sin(gamma)
    let residual_7_by_gamma = -gamma_dot * ss_sin_gamma;
    // d(E3_1')/d(beta') = rr*sin(beta) - d*sin(beta + theta)
    let residual_7_by_beta_dot = residual_1_by_beta_of_place;
    // d(E3_1')/d(theta') = -d*sin(beta + theta)
    let residual_7_by_theta_dot = residual_1_by_theta_of_d_beta_theta;
    // d(E3_1')/d(gamma') = ss*cos(gamma)
    let residual_7_by_gamma_dot = ss_cos_gamma;
    // d(E3_2')/d(beta) = rr*beta'*sin(beta) - d*sin(beta + theta)*(beta' + theta')
    let residual_8_by_beta = residual_8_by_beta_of_motion_2;
    // d(E3_2')/d(theta) = -d*sin(beta + theta)*(beta' + theta')
    let residual_8_by_theta = residual_8_by_theta_of_motion;
    // d(E3_2')/d(gamma) = ss*gamma'*cos(gamma)
    let residual_8_by_gamma = gamma_dot * ss_cos_gamma;
    // d(E3_2')/d(beta') = d*cos(beta + theta) - rr*cos(beta)
    let residual_8_by_beta_dot = residual_2_by_beta_of_place_2;
    // d(E3_2')/d(theta') = d*cos(beta + theta)
    let residual_8_by_theta_dot = d_cos_beta_plus_theta;
    // d(E3_2')/d(gamma') = ss*sin(gamma)
    let residual_8_by_gamma_dot = ss_sin_gamma;
    // d(E4_1')/d(beta) = rr*beta'*cos(beta) - d*cos(beta + theta)*(beta' + theta')
    let residual_9_by_beta = residual_7_by_beta_of_motion_2;
    // d(E4_1')/d(theta) = -d*cos(beta + theta)*(beta' + theta')
    let residual_9_by_theta = residual_7_by_theta_of_motion;
    // d(E4_1')/d(delta) = -zt*delta'*cos(delta) - e*sin(delta + phi)*(delta' + phi')
    let residual_9_by_delta = (-delta_dot)
        .mul_add(zt_cos_delta, -residual_9_by_delta_of_motion);
    // d(E4_1')/d(phi) = -e*sin(delta + phi)*(delta' + phi')
    let residual_9_by_phi = -residual_9_by_delta_of_motion;
    // d(E4_1')/d(beta') = rr*sin(beta) - d*sin(beta + theta)
    let residual_9_by_beta_dot = residual_1_by_beta_of_place;
    // d(E4_1')/d(theta') = -d*sin(beta + theta)
    let residual_9_by_theta_dot = residual_1_by_theta_of_d_beta_theta;
    // d(E4_1')/d(delta') = e*cos(delta + phi) - zt*sin(delta)
    let residual_9_by_delta_dot = residual_3_by_delta_of_place;
    // d(E4_1')/d(phi') = e*cos(delta + phi)
    let residual_9_by_phi_dot = e_cos_delta_plus_phi;
    // d(E4_2')/d(beta) = rr*beta'*sin(beta) - d*sin(beta + theta)*(beta' + theta')
    let residual_10_by_beta = residual_8_by_beta_of_motion_2;
    // d(E4_2')/d(theta) = -d*sin(beta + theta)*(beta' + theta')
    let residual_10_by_theta = residual_8_by_theta_of_motion;
    // d(E4_2')/d(delta) = e*cos(delta + phi)*(delta' + phi') - zt*delta'*sin(delta)
    let residual_10_by_delta = (-delta_dot)
        .mul_add(zt_sin_delta, residual_10_by_delta_of_motion);
    // d(E4_2')/d(phi) = e*cos(delta + phi)*(delta' + phi')
    let residual_10_by_phi = residual_10_by_delta_of_motion;
    // d(E4_2')/d(beta') = d*cos(beta + theta) - rr*cos(beta)
    let residual_10_by_beta_dot = residual_2_by_beta_of_place_2;
    // d(E4_2')/d(theta') = d*cos(beta + theta)
    let residual_10_by_theta_dot = d_cos_beta_plus_theta;
    // d(E4_2')/d(delta') = zt*cos(delta) + e*sin(delta + phi)
    let residual_10_by_delta_dot = residual_4_by_delta_of_place;
    // d(E4_2')/d(phi') = e*sin(delta + phi)
    let residual_10_by_phi_dot = e_sin_delta_plus_phi;
    // d(E6_1')/d(beta) = rr*beta'*cos(beta) - d*cos(beta + theta)*(beta' + theta')
    let residual_11_by_beta = residual_7_by_beta_of_motion_2;
    // d(E6_1')/d(theta) = -d*cos(beta + theta)*(beta' + theta')
    let residual_11_by_theta = residual_7_by_theta_of_motion;
    // d(E6_1')/d(epsilon) = -u*epsilon'*sin(epsilon) - zf*cos(epsilon + omega)*(epsilon' + omega')
    let residual_11_by_epsilon = (-epsilon_dot)
        .mul_add(u_2_sin_epsilon, -residual_11_by_epsilon_of_motion_2);
    // d(E6_1')/d(omega) = -zf*cos(epsilon + omega)*(epsilon' + omega')
    let residual_11_by_omega = -residual_11_by_epsilon_of_motion_2;
    // d(E6_1')/d(beta') = rr*sin(beta) - d*sin(beta + theta)
    let residual_11_by_beta_dot = residual_1_by_beta_of_place;
    // d(E6_1')/d(theta') = -d*sin(beta + theta)
    let residual_11_by_theta_dot = residual_1_by_theta_of_d_beta_theta;
    // d(E6_1')/d(epsilon') = u*cos(epsilon) - zf*sin(epsilon + omega)
    let residual_11_by_epsilon_dot = residual_5_by_epsilon_of_place_3;
    // d(E6_1')/d(omega') = -zf*sin(epsilon + omega)
    let residual_11_by_omega_dot = residual_5_by_omega_of_place;
    // d(E6_2')/d(beta) = rr*beta'*sin(beta) - d*sin(beta + theta)*(beta' + theta')
    let residual_12_by_beta = residual_8_by_beta_of_motion_2;
    // d(E6_2')/d(theta) = -d*sin(beta + theta)*(beta' + theta')
    let residual_12_by_theta = residual_8_by_theta_of_motion;
    // d(E6_2')/d(epsilon) = u*epsilon'*cos(epsilon) - zf*sin(epsilon + omega)*(epsilon' + omega')
    let residual_12_by_epsilon = epsilon_dot
        .mul_add(u_2_cos_epsilon, -residual_12_by_epsilon_of_motion);
    // d(E6_2')/d(omega) = -zf*sin(epsilon + omega)*(epsilon' + omega')
    let residual_12_by_omega = -residual_12_by_epsilon_of_motion;
    // d(E6_2')/d(beta') = d*cos(beta + theta) - rr*cos(beta)
    let residual_12_by_beta_dot = residual_2_by_beta_of_place_2;
    // d(E6_2')/d(theta') = d*cos(beta + theta)
    let residual_12_by_theta_dot = d_cos_beta_plus_theta;
    // d(E6_2')/d(epsilon') = u*sin(epsilon) + zf*cos(epsilon + omega)
    let residual_12_by_epsilon_dot = residual_6_by_epsilon_of_place_2;
    // d(E6_2')/d(omega') = zf*cos(epsilon + omega)
    let residual_12_by_omega_dot = residual_6_by_epsilon_of_place;
    let zero = S::int(0);
    [
        residual_1_by_beta, residual_1_by_theta, residual_1_by_gamma, zero, zero, zero, zero, zero,
        zero, zero, zero, zero, zero, zero, residual_2_by_beta, residual_2_by_theta,
        residual_2_by_gamma, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        residual_3_by_beta, residual_3_by_theta, zero, residual_3_by_delta, residual_3_by_phi, zero,
        zero, zero, zero, zero, zero, zero, zero, zero, residual_4_by_beta, residual_4_by_theta,
        zero, residual_4_by_delta, residual_4_by_phi, zero, zero, zero, zero, zero, zero, zero,
        zero, zero, residual_5_by_beta, residual_5_by_theta, zero, zero, zero,
        residual_5_by_epsilon, residual_5_by_omega, zero, zero, zero, zero, zero, zero, zero,
        residual_6_by_beta, residual_6_by_theta, zero, zero, zero, residual_6_by_epsilon,
        residual_6_by_omega, zero, zero, zero, zero, zero, zero, zero, residual_7_by_beta,
        residual_7_by_theta, residual_7_by_gamma, zero, zero, zero, zero, residual_7_by_beta_dot,
        residual_7_by_theta_dot, residual_7_by_gamma_dot, zero, zero, zero, zero,
        residual_8_by_beta, residual_8_by_theta, residual_8_by_gamma, zero, zero, zero, zero,
        residual_8_by_beta_dot, residual_8_by_theta_dot, residual_8_by_gamma_dot, zero, zero, zero,
        zero, residual_9_by_beta, residual_9_by_theta, zero, residual_9_by_delta, residual_9_by_phi,
        zero, zero, residual_9_by_beta_dot, residual_9_by_theta_dot, zero, residual_9_by_delta_dot,
        residual_9_by_phi_dot, zero, zero, residual_10_by_beta, residual_10_by_theta, zero,
        residual_10_by_delta, residual_10_by_phi, zero, zero, residual_10_by_beta_dot,
        residual_10_by_theta_dot, zero, residual_10_by_delta_dot, residual_10_by_phi_dot, zero,
        zero, residual_11_by_beta, residual_11_by_theta, zero, zero, zero, residual_11_by_epsilon,
        residual_11_by_omega, residual_11_by_beta_dot, residual_11_by_theta_dot, zero, zero, zero,
        residual_11_by_epsilon_dot, residual_11_by_omega_dot, residual_12_by_beta,
        residual_12_by_theta, zero, zero, zero, residual_12_by_epsilon, residual_12_by_omega,
        residual_12_by_beta_dot, residual_12_by_theta_dot, zero, zero, zero,
        residual_12_by_epsilon_dot, residual_12_by_omega_dot,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 150 convolutions and 346 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 14]],
    history: &mut [Factors<S, 152>],
) {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I1, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e,
        ea, rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta_0, theta_0, gamma_0, delta_0, phi_0, epsilon_0, omega_0, beta_dot_0,
    theta_dot_0, gamma_dot_0, delta_dot_0, phi_dot_0, epsilon_dot_0, omega_dot_0] = series[0];
    // Shared terms.
    // zf - fa
    let zf_minus_fa_2 = zf - fa;
    // e - ea
    let e_minus_ea_2 = e - ea;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    let d_inv_rr = rr / d;
    let zt_inv = S::int(1) / zt;
    let u_2_inv = S::int(1) / u_2;
    let zf_inv = S::int(1) / zf;
    // I3 + m3*(sa^2 + sb^2)
    let weight_7_of_m3_i3_sa_sb = I3 + m3 * sb.mul_add(sb, sa * sa);
    let m4_e_minus_ea_of_m4_e_ea = m4 * e_minus_ea_2;
    let m6_fa_minus_zf_of_m6_zf_fa = m6 * zf_minus_fa_2;
    let ss_inv = S::int(1) / ss;
    // I5 + m5*(ta^2 + tb^2)
    let weight_3_of_m5_i5_ta_tb = I5 + m5 * tb.mul_add(tb, ta * ta);
    let e_inv_ea = ea / e;
    // ea/e - 2
    let weight_of_e_ea = e_inv_ea - S::int(2);
    // I7 + m7*(ua^2 + ub^2)
    let weight_6_of_m7_i7_ua_ub = I7 + m7 * ub.mul_add(ub, ua * ua);
    let zf_inv_fa = fa / zf;
    // fa/zf - 2
    let weight_4_of_zf_fa = zf_inv_fa - S::int(2);
    // fa/zf - 1
    let weight_5_of_zf_fa = zf_inv_fa - S::int(1);
    let i4_e_inv = I4 / e;
    let i6_zf_inv = I6 / zf;
    let d_inv = S::int(1) / d;
    let rr_ss_inv = rr / ss;
    let rr_zt_inv = rr / zt;
    let weight_11_of_xb_xc_sc = sc * xb_minus_xc;
    let weight_12_of_yb_yc_sc = sc * yb_minus_yc;
    let weight_11_of_yb_yc_sd = sd * yb_minus_yc;
    let weight_12_of_xb_xc_sd = sd * xb_minus_xc;
    let ss_inv_zf_inv = S::int(1) / (ss * zf);
    let e_inv_ea_zt = ea * zt / e;
    // e + ea*(ea/e - 2)
    let weight_26_of_e_ea = ea.mul_add(weight_of_e_ea, e);
    // zf + fa*(fa/zf - 2)
    let weight_29_of_zf_fa = fa.mul_add(weight_4_of_zf_fa, zf);
    // Constant in time.
    // weight = m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight = m4 + I4 / (e * e) + m4 * ea * weight_of_e_ea / e;
    // weight_2 = 2*m4*(1 - ea/e)
    let weight_2 = S::int(2) * m4 * (S::int(1) - e_inv_ea);
    // weight_3 = m4 + (I5 + m5*(ta^2 + tb^2))/zt^2
    let weight_3 = m4 + weight_3_of_m5_i5_ta_tb / (zt * zt);
    // weight_4 = m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight_4 = m6 + I6 / (zf * zf) + m6 * fa * weight_4_of_zf_fa / zf;
    // weight_5 = 2*m6*(fa/zf - 1)
    let weight_5 = S::int(2) * m6 * weight_5_of_zf_fa;
    // weight_6 = m6 + (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_6 = m6 + weight_6_of_m7_i7_ua_ub / (u_2 * u_2);
    // weight_7 = (I3 + m3*(sa^2 + sb^2))/ss^2
    let weight_7 = weight_7_of_m3_i3_sa_sb / (ss * ss);
    // i2_plus_m2_da_2_by_d_2 = (I2 + m2*da^2)/d^2
    let i2_plus_m2_da_2_by_d_2 = (I2 + m2 * da * da) / (d * d);
    // weight_8 = 2*m2*da/d
    let weight_8 = S::int(2) * m2 * da / d;
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
    // weight_13 = sc*(yb - yc) + sd*(xc - xb)
    let weight_13 = weight_12_of_yb_yc_sc - weight_12_of_xb_xc_sd;
    // weight_14 = sc*(xb - xc) + sd*(yb - yc)
    let weight_14 = weight_11_of_xb_xc_sc + weight_11_of_yb_yc_sd;
    // weight_15 = 1/ss
    let weight_15 = ss_inv;
    // weight_16 = 1/d
    let weight_16 = d_inv;
    // minus_rr = -rr
    let minus_rr = -rr;
    // minus_1_by_ss = -1/ss
    let minus_1_by_ss = -ss_inv;
    // weight_17 = 1/e
    let weight_17 = S::int(1) / e;
    // weight_18 = 1/zt
    let weight_18 = zt_inv;
    // minus_1_by_d = -1/d
    let minus_1_by_d = -d_inv;
    // minus_1_by_e_ss = -1/(e*ss)
    let minus_1_by_e_ss = -S::int(1) / (e * ss);
    // minus_1_by_ss_zt = -1/(ss*zt)
    let minus_1_by_ss_zt = -S::int(1) / (ss * zt);
    // weight_19 = 1/zt^2
    let weight_19 = S::int(1) / (zt * zt);
    // minus_1_by_zt = -1/zt
    let minus_1_by_zt = -zt_inv;
    // weight_20 = 1/zf
    let weight_20 = zf_inv;
    // minus_1_by_u = -1/u
    let minus_1_by_u = -u_2_inv;
    // weight_21 = 1/u
    let weight_21 = u_2_inv;
    // minus_1_by_zf = -1/zf
    let minus_1_by_zf = -zf_inv;
    // weight_22 = 1/(ss*u)
    let weight_22 = S::int(1) / (ss * u_2);
    // weight_23 = 1/(ss*zf)
    let weight_23 = ss_inv_zf_inv;
    // minus_1_by_ss_zf = -1/(ss*zf)
    let minus_1_by_ss_zf = -ss_inv_zf_inv;
    // weight_24 = 1/zf^2
    let weight_24 = S::int(1) / (zf * zf);
    // weight_25 = I2/d + m2*da^2/d
    let weight_25 = I2 / d + m2 * da * da / d;
    // minus_m2_da = -m2*da
    let minus_m2_da = -m2 * da;
    // weight_26 = e + ea*(ea/e - 2)
    let weight_26 = weight_26_of_e_ea;
    // zt_minus_ea_zt_by_e = zt - ea*zt/e
    let zt_minus_ea_zt_by_e = zt - e_inv_ea_zt;
    // e_minus_ea = e - ea
    let e_minus_ea = e_minus_ea_2;
    // weight_27 = (I5 + m5*(ta^2 + tb^2))/zt
    let weight_27 = weight_3_of_m5_i5_ta_tb / zt;
    // i4_by_e = I4/e
    let i4_by_e = i4_e_inv;
    // weight_28 = I4/e + m4*(e + ea*(ea/e - 2))
    let weight_28 = m4.mul_add(weight_26_of_e_ea, i4_e_inv);
    // m4_e_minus_ea = m4*(e - ea)
    let m4_e_minus_ea = m4_e_minus_ea_of_m4_e_ea;
    // weight_29 = zf + fa*(fa/zf - 2)
    let weight_29 = weight_29_of_zf_fa;
    // u_fa_by_zf_minus_u = u*fa/zf - u
    let u_fa_by_zf_minus_u = u_2 * fa / zf - u_2;
    // fa_minus_zf = fa - zf
    let fa_minus_zf = fa - zf;
    // weight_30 = (I7 + m7*(ua^2 + ub^2))/u
    let weight_30 = weight_6_of_m7_i7_ua_ub / u_2;
    // i6_by_zf = I6/zf
    let i6_by_zf = i6_zf_inv;
    // weight_31 = I6/zf + m6*(zf + fa*(fa/zf - 2))
    let weight_31 = m6.mul_add(weight_29_of_zf_fa, i6_zf_inv);
    // m6_fa_minus_zf = m6*(fa - zf)
    let m6_fa_minus_zf = -m6_fa_minus_zf_of_m6_zf_fa;
    // ea_zt_by_e_minus_zt = ea*zt/e - zt
    let ea_zt_by_e_minus_zt = e_inv_ea_zt - zt;
    // weight_32 = 2*e - 2*ea
    let weight_32 = (-ea).mul_add(S::int(2), S::int(2) * e);
    // u_fa_by_zf_minus_1 = u*(fa/zf - 1)
    let u_fa_by_zf_minus_1 = u_2 * weight_5_of_zf_fa;
    // zf_minus_fa = zf - fa
    let zf_minus_fa = zf_minus_fa_2;
    // weight_33 = 2*zf - 2*fa
    let weight_33 = (-fa).mul_add(S::int(2), S::int(2) * zf);
    // c0_by_ss = c0/ss
    let c0_by_ss = c0 / ss;
    // minus_m4 = -m4
    let minus_m4 = -m4;
    // m4_ea_minus_e = m4*(ea - e)
    let m4_ea_minus_e = -m4_e_minus_ea_of_m4_e_ea;
    // m6_zf_minus_fa = m6*(zf - fa)
    let m6_zf_minus_fa = m6_fa_minus_zf_of_m6_zf_fa;
    // m2_da_rr_by_d = m2*da*rr/d
    let m2_da_rr_by_d = m2 * da * rr / d;
    // rr_2_by_d = rr^2/d
    let rr_2_by_d = rr * rr / d;
    // weight_34 = rr^2*(I3 + m3*(sa^2 + sb^2))/ss^2
    let weight_34 = rr * rr * weight_7_of_m3_i3_sa_sb / (ss * ss);
    // rr_2_by_zt = rr^2/zt
    let rr_2_by_zt = rr * rr / zt;
    // minus_rr_2_by_u = -rr^2/u
    let minus_rr_2_by_u = -rr * rr / u_2;
    // rr_by_d = rr/d
    let rr_by_d = d_inv_rr;
    // minus_rr_by_d = -rr/d
    let minus_rr_by_d = -d_inv_rr;
    // minus_rr_by_ss = -rr/ss
    let minus_rr_by_ss = -rr_ss_inv;
    // rr_by_ss = rr/ss
    let rr_by_ss = rr_ss_inv;
    // minus_rr_by_zt = -rr/zt
    let minus_rr_by_zt = -rr_zt_inv;
    // rr_by_zt = rr/zt
    let rr_by_zt = rr_zt_inv;
    // minus_zt = -zt
    let minus_zt = -zt;
    // minus_rr_by_e_zt = -rr/(e*zt)
    let minus_rr_by_e_zt = -rr / (e * zt);
    // rr_by_u = rr/u
    let rr_by_u = rr / u_2;
    // minus_u = -u
    let minus_u = -u_2;
    // minus_rr_by_u_zf = -rr/(u*zf)
    let minus_rr_by_u_zf = -rr / (u_2 * zf);
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
    let beta_rate_dot_of_place_3_0 = cos_gamma_0
        .mul_add(weight_14, weight_13 * sin_gamma_0);
    let sin_angle_cos_angle_inv_0 = sin_angle_0 * over_cos_angle;
    let beta_rate_dot_of_place_4_0 = cos_beta_minus_gamma_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_5_0 = sin_beta_minus_gamma_0 - beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_6_0 = sin_theta_0 * beta_rate_dot_of_place_5_0;
    let beta_rate_dot_of_place_7_0 = cos_beta_minus_gamma_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_8_0 = beta_rate_dot_of_place_6_0
        .mul_add(weight_15, weight_16 * beta_rate_dot_of_place_7_0);
    let beta_rate_dot_of_place_9_0 = beta_rate_dot_of_place_8_0 * over_cos_angle;
    let beta_rate_dot_of_place_10_0 = beta_rate_dot_of_place_9_0
        .mul_add(minus_rr, sin_beta_minus_gamma_0);
    let beta_rate_dot_of_place_11_0 = sin_theta_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_12_0 = cos_theta_0 + beta_rate_dot_of_place_11_0;
    let beta_rate_dot_of_place_13_0 = cos_beta_minus_gamma_0 * beta_rate_dot_of_place_12_0;
    let beta_rate_dot_of_place_14_0 = sin_theta_0 * beta_rate_dot_of_place_11_0;
    let beta_rate_dot_of_place_15_0 = beta_rate_dot_of_place_13_0
        .mul_add(weight_16, minus_1_by_ss * beta_rate_dot_of_place_14_0);
    let beta_rate_dot_of_place_16_0 = beta_rate_dot_of_place_15_0 * over_cos_angle;
    let beta_rate_dot_of_place_17_0 = beta_rate_dot_of_place_16_0
        .mul_add(minus_rr, cos_theta_0);
    let sin_phi_cos_phi_inv_0 = sin_phi_0 * over_cos_phi;
    let beta_rate_dot_of_place_18_0 = sin_angle_2_0 * sin_phi_cos_phi_inv_0;
    let beta_rate_dot_of_place_19_0 = cos_angle_2_0 - beta_rate_dot_of_place_18_0;
    let beta_rate_dot_of_place_20_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_19_0;
    let beta_rate_dot_of_place_21_0 = sin_angle_2_0 * beta_rate_dot_of_place_18_0;
    let beta_rate_dot_of_place_22_0 = beta_rate_dot_of_place_20_0
        .mul_add(weight_17, weight_18 * beta_rate_dot_of_place_21_0);
    let beta_rate_dot_of_place_23_0 = beta_rate_dot_of_place_22_0 * over_cos_phi;
    let beta_rate_dot_of_place_24_0 = sin_angle_2_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_25_0 = cos_angle_2_0 - beta_rate_dot_of_place_24_0;
    let beta_rate_dot_of_place_26_0 = minus_1_by_ss * beta_rate_dot_of_place_25_0
        + beta_rate_dot_of_place_23_0;
    let beta_rate_dot_of_place_27_0 = sin_theta_0 * beta_rate_dot_of_place_26_0;
    let beta_rate_dot_of_place_28_0 = sin_angle_2_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_29_0 = minus_1_by_d * beta_rate_dot_of_place_28_0
        + beta_rate_dot_of_place_27_0;
    let beta_rate_dot_of_place_30_0 = sin_theta_0 * beta_rate_dot_of_place_29_0;
    let beta_rate_dot_of_place_31_0 = sin_angle_2_0 * d1_of_place_4_0;
    let beta_rate_dot_of_place_32_0 = minus_1_by_d * beta_rate_dot_of_place_31_0
        + beta_rate_dot_of_place_30_0;
    let beta_rate_dot_of_place_33_0 = beta_rate_dot_of_place_32_0 * over_cos_angle;
    let cos_theta_sin_angle_2_0 = cos_theta_0 * sin_angle_2_0;
    let beta_rate_dot_of_place_34_0 = beta_rate_dot_of_place_33_0
        .mul_add(rr, cos_theta_sin_angle_2_0);
    let beta_rate_dot_of_place_35_0 = cos_gamma_minus_delta_0 * sin_phi_cos_phi_inv_0;
    let beta_rate_dot_of_place_36_0 = beta_rate_dot_of_place_35_0
        .mul_add(-S::int(2), sin_gamma_minus_delta_0);
    let beta_rate_dot_of_place_37_0 = sin_angle_2_0 * beta_rate_dot_of_place_36_0;
    let beta_rate_dot_of_place_38_0 = cos_gamma_minus_delta_0 * cos_angle_2_0;
    let beta_rate_dot_of_place_39_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_35_0;
    let beta_rate_dot_of_place_40_0 = beta_rate_dot_of_place_37_0
        .mul_add(
            weight_18,
            beta_rate_dot_of_place_39_0
                .mul_add(weight_17, weight_18 * beta_rate_dot_of_place_38_0),
        );
    let beta_rate_dot_of_place_41_0 = beta_rate_dot_of_place_40_0 * over_cos_phi;
    let beta_rate_dot_of_place_42_0 = cos_gamma_minus_delta_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_43_0 = beta_rate_dot_of_place_21_0 * over_cos_phi;
    let beta_rate_dot_of_place_44_0 = beta_rate_dot_of_place_41_0
        .mul_add(
            weight_17,
            beta_rate_dot_of_place_43_0
                .mul_add(
                    weight_19,
                    beta_rate_dot_of_place_25_0
                        .mul_add(
                            minus_1_by_ss_zt,
                            beta_rate_dot_of_place_42_0
                                .mul_add(
                                    minus_1_by_e_ss,
                                    minus_1_by_e_ss * sin_gamma_minus_delta_0,
                                ),
                        ),
                ),
        );
    let beta_rate_dot_of_place_45_0 = sin_theta_0 * beta_rate_dot_of_place_44_0;
    let beta_rate_dot_of_place_46_0 = sin_angle_2_0
        .mul_add(minus_1_by_zt, weight_17 * cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_47_0 = beta_rate_dot_of_place_46_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_48_0 = weight_16 * beta_rate_dot_of_place_47_0
        + beta_rate_dot_of_place_45_0;
    let beta_rate_dot_of_place_49_0 = sin_theta_0 * beta_rate_dot_of_place_48_0;
    let beta_rate_dot_of_place_50_0 = beta_rate_dot_of_place_46_0 * d1_of_place_4_0;
    let beta_rate_dot_of_place_51_0 = weight_16 * beta_rate_dot_of_place_50_0
        + beta_rate_dot_of_place_49_0;
    let beta_rate_dot_of_place_52_0 = beta_rate_dot_of_place_51_0 * over_cos_angle;
    let beta_rate_dot_of_place_53_0 = cos_theta_0 * beta_rate_dot_of_place_46_0;
    let beta_rate_dot_of_place_54_0 = beta_rate_dot_of_place_52_0
        .mul_add(rr, -beta_rate_dot_of_place_53_0);
    let sin_omega_cos_omega_inv_0 = sin_omega_0 * over_cos_omega;
    let beta_rate_dot_of_place_55_0 = cos_angle_3_0 * sin_omega_cos_omega_inv_0;
    let beta_rate_dot_of_place_56_0 = sin_angle_3_0 + beta_rate_dot_of_place_55_0;
    let beta_rate_dot_of_place_57_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_56_0;
    let beta_rate_dot_of_place_58_0 = cos_angle_3_0 * beta_rate_dot_of_place_55_0;
    let beta_rate_dot_of_place_59_0 = beta_rate_dot_of_place_57_0
        .mul_add(weight_20, minus_1_by_u * beta_rate_dot_of_place_58_0);
    let beta_rate_dot_of_place_60_0 = beta_rate_dot_of_place_59_0 * over_cos_omega;
    let beta_rate_dot_of_place_61_0 = cos_angle_3_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_62_0 = sin_angle_3_0 + beta_rate_dot_of_place_61_0;
    let beta_rate_dot_of_place_63_0 = minus_1_by_ss * beta_rate_dot_of_place_62_0
        + beta_rate_dot_of_place_60_0;
    let beta_rate_dot_of_place_64_0 = sin_theta_0 * beta_rate_dot_of_place_63_0;
    let beta_rate_dot_of_place_65_0 = cos_angle_3_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_66_0 = weight_16 * beta_rate_dot_of_place_65_0
        + beta_rate_dot_of_place_64_0;
    let beta_rate_dot_of_place_67_0 = sin_theta_0 * beta_rate_dot_of_place_66_0;
    let beta_rate_dot_of_place_68_0 = cos_angle_3_0 * d1_of_place_4_0;
    let beta_rate_dot_of_place_69_0 = weight_16 * beta_rate_dot_of_place_68_0
        + beta_rate_dot_of_place_67_0;
    let beta_rate_dot_of_place_70_0 = beta_rate_dot_of_place_69_0 * over_cos_angle;
    let cos_theta_cos_angle_3_0 = cos_theta_0 * cos_angle_3_0;
    let beta_rate_dot_of_place_71_0 = beta_rate_dot_of_place_70_0
        .mul_add(rr, -cos_theta_cos_angle_3_0);
    let beta_rate_dot_of_place_72_0 = sin_gamma_minus_epsilon_0 * sin_omega_cos_omega_inv_0;
    let beta_rate_dot_of_place_73_0 = beta_rate_dot_of_place_72_0
        .mul_add(S::int(2), cos_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_74_0 = cos_angle_3_0 * beta_rate_dot_of_place_73_0;
    let beta_rate_dot_of_place_75_0 = sin_gamma_minus_epsilon_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_76_0 = beta_rate_dot_of_place_74_0
        .mul_add(
            minus_1_by_zf,
            beta_rate_dot_of_place_58_0
                .mul_add(weight_21, minus_1_by_zf * beta_rate_dot_of_place_75_0),
        );
    let beta_rate_dot_of_place_77_0 = beta_rate_dot_of_place_76_0 * over_cos_omega;
    let beta_rate_dot_of_place_78_0 = sin_gamma_minus_epsilon_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_79_0 = sin_gamma_minus_epsilon_0 * over_cos_omega;
    let beta_rate_dot_of_place_80_0 = beta_rate_dot_of_place_72_0 * beta_rate_dot_of_place_79_0;
    let beta_rate_dot_of_place_81_0 = beta_rate_dot_of_place_77_0
        .mul_add(
            weight_21,
            beta_rate_dot_of_place_80_0
                .mul_add(
                    weight_24,
                    beta_rate_dot_of_place_62_0
                        .mul_add(
                            weight_22,
                            beta_rate_dot_of_place_78_0
                                .mul_add(
                                    minus_1_by_ss_zf,
                                    weight_23 * cos_gamma_minus_epsilon_0,
                                ),
                        ),
                ),
        );
    let beta_rate_dot_of_place_82_0 = sin_theta_0 * beta_rate_dot_of_place_81_0;
    let beta_rate_dot_of_place_83_0 = cos_angle_3_0
        .mul_add(minus_1_by_u, weight_20 * sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_84_0 = beta_rate_dot_of_place_83_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_85_0 = weight_16 * beta_rate_dot_of_place_84_0
        + beta_rate_dot_of_place_82_0;
    let beta_rate_dot_of_place_86_0 = sin_theta_0 * beta_rate_dot_of_place_85_0;
    let beta_rate_dot_of_place_87_0 = beta_rate_dot_of_place_83_0 * d1_of_place_4_0;
    let beta_rate_dot_of_place_88_0 = weight_16 * beta_rate_dot_of_place_87_0
        + beta_rate_dot_of_place_86_0;
    let beta_rate_dot_of_place_89_0 = beta_rate_dot_of_place_88_0 * over_cos_angle;
    let beta_rate_dot_of_place_90_0 = cos_theta_0 * beta_rate_dot_of_place_83_0;
    let beta_rate_dot_of_place_91_0 = beta_rate_dot_of_place_89_0
        .mul_add(rr, -beta_rate_dot_of_place_90_0);
    let beta_rate_dot_of_place_92_0 = beta_rate_dot_of_place_2_0 * beta_rate_dot_of_place_3_0;
    let beta_rate_dot_of_place_93_0 = l0 * beta_rate_dot_of_place_3_0 - beta_rate_dot_of_place_92_0;
    let beta_rate_dot_of_place_94_0 = cos_beta_minus_gamma_0 * over_cos_angle;
    let beta_rate_dot_of_place_95_0 = beta_rate_dot_of_place_94_0
        .mul_add(weight_25, minus_m2_da * cos_theta_0);
    let beta_rate_dot_of_e_ea_zt_phi_0 = sin_phi_0
        .mul_add(zt_minus_ea_zt_by_e, weight_26);
    let beta_rate_dot_of_place_96_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_e_ea_zt_phi_0;
    let beta_rate_dot_of_e_ea_zt_phi_2_0 = sin_phi_0.mul_add(e_minus_ea, zt);
    let beta_rate_dot_of_place_97_0 = sin_angle_2_0 * beta_rate_dot_of_e_ea_zt_phi_2_0;
    let beta_rate_dot_of_place_98_0 = beta_rate_dot_of_place_97_0
        .mul_add(
            m4,
            beta_rate_dot_of_place_96_0
                .mul_add(
                    m4,
                    cos_gamma_minus_delta_0.mul_add(i4_by_e, weight_27 * sin_angle_2_0),
                ),
        );
    let beta_rate_dot_of_place_99_0 = sin_phi_sin_angle_2_0
        .mul_add(m4_e_minus_ea, weight_28 * cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_100_0 = sin_omega_0
        .mul_add(u_fa_by_zf_minus_u, weight_29);
    let beta_rate_dot_of_place_101_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_100_0;
    let beta_rate_dot_of_place_102_0 = sin_omega_0.mul_add(fa_minus_zf, u_2);
    let beta_rate_dot_of_place_103_0 = cos_angle_3_0 * beta_rate_dot_of_place_102_0;
    let beta_rate_dot_of_place_104_0 = beta_rate_dot_of_place_103_0
        .mul_add(
            m6,
            beta_rate_dot_of_place_101_0
                .mul_add(
                    m6,
                    sin_gamma_minus_epsilon_0
                        .mul_add(i6_by_zf, weight_30 * cos_angle_3_0),
                ),
        );
    let beta_rate_dot_of_place_105_0 = sin_omega_cos_angle_3_0
        .mul_add(m6_fa_minus_zf, weight_31 * sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_106_0 = beta_rate_dot_of_place_2_0 * over_beta_rate_dot_of_place;
    let beta_rate_dot_of_place_107_0 = beta_rate_dot_of_place_93_0 * beta_rate_dot_of_place_106_0;
    let beta_rate_dot_of_place_108_0 = cos_gamma_minus_delta_0
        .mul_add(ea_zt_by_e_minus_zt, e_minus_ea * sin_angle_2_0);
    let beta_rate_dot_of_delta_dot_0 = delta_dot_0 * beta_rate_dot_of_place_108_0;
    let phi_dot_sin_angle_2_0 = phi_dot_0 * sin_angle_2_0;
    let beta_rate_dot_of_motion_0 = weight_32 * phi_dot_sin_angle_2_0
        + beta_rate_dot_of_delta_dot_0;
    let beta_rate_dot_of_motion_2_0 = delta_dot_0 * beta_rate_dot_of_motion_0;
    let phi_dot_sq_sin_angle_2_0 = phi_dot_0 * phi_dot_sin_angle_2_0;
    let beta_rate_dot_of_place_109_0 = cos_angle_3_0
        .mul_add(zf_minus_fa, u_fa_by_zf_minus_1 * sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_epsilon_dot_0 = epsilon_dot_0 * beta_rate_dot_of_place_109_0;
    let omega_dot_cos_angle_3_0 = omega_dot_0 * cos_angle_3_0;
    let beta_rate_dot_of_motion_3_0 = weight_33 * omega_dot_cos_angle_3_0
        + beta_rate_dot_of_epsilon_dot_0;
    let beta_rate_dot_of_motion_4_0 = epsilon_dot_0 * beta_rate_dot_of_motion_3_0;
    let omega_dot_sq_cos_angle_3_0 = omega_dot_0 * omega_dot_cos_angle_3_0;
    let beta_dot_sq_0 = beta_dot_0 * beta_dot_0;
    let beta_rate_dot_of_beta_dot_0 = cos_beta_minus_gamma_0 * beta_dot_sq_0;
    let beta_rate_dot_of_motion_5_0 = beta_rate_dot_of_place_107_0
        .mul_add(
            c0_by_ss,
            beta_rate_dot_of_motion_4_0
                .mul_add(
                    m6,
                    beta_rate_dot_of_motion_2_0
                        .mul_add(
                            minus_m4,
                            omega_dot_sq_cos_angle_3_0
                                .mul_add(
                                    m6_zf_minus_fa,
                                    phi_dot_sq_sin_angle_2_0
                                        .mul_add(
                                            m4_ea_minus_e,
                                            m2_da_rr_by_d * beta_rate_dot_of_beta_dot_0,
                                        ),
                                ),
                        ),
                ),
        );
    let beta_rate_dot_of_motion_6_0 = beta_rate_dot_of_motion_5_0 * over_cos_angle;
    let beta_rate_dot_of_motion_7_0 = theta_dot_0.mul_add(S::int(2), beta_dot_0);
    let beta_rate_dot_of_motion_8_0 = beta_dot_0 * beta_rate_dot_of_motion_7_0;
    let theta_dot_sq_0 = theta_dot_0 * theta_dot_0;
    let beta_rate_dot_of_motion_9_0 = beta_rate_dot_of_motion_8_0
        .mul_add(minus_m2_da, minus_m2_da * theta_dot_sq_0) + beta_rate_dot_of_motion_6_0;
    let beta_rate_dot_of_motion_10_0 = sin_theta_0 * beta_rate_dot_of_motion_9_0;
    let beta_rate_dot_of_beta_dot_2_0 = beta_dot_sq_0 * over_cos_angle;
    let beta_rate_dot_of_beta_dot_3_0 = beta_rate_dot_of_place_10_0 * beta_rate_dot_of_beta_dot_2_0;
    let beta_rate_dot_of_beta_dot_4_0 = beta_rate_dot_of_place_95_0 * beta_rate_dot_of_beta_dot_3_0;
    let sin_theta_cos_angle_inv_0 = sin_theta_0 * over_cos_angle;
    let beta_rate_dot_of_beta_dot_5_0 = beta_rate_dot_of_beta_dot_2_0 * sin_theta_cos_angle_inv_0;
    let beta_rate_dot_of_beta_dot_6_0 = beta_rate_dot_of_place_17_0 * beta_rate_dot_of_beta_dot_5_0;
    let beta_rate_dot_of_beta_dot_7_0 = beta_rate_dot_of_beta_dot_5_0 * over_cos_phi_sq;
    let beta_rate_dot_of_beta_dot_8_0 = beta_rate_dot_of_place_98_0 * beta_rate_dot_of_beta_dot_7_0;
    let beta_rate_dot_of_beta_dot_9_0 = beta_rate_dot_of_place_34_0 * beta_rate_dot_of_beta_dot_8_0;
    let beta_rate_dot_of_beta_dot_10_0 = beta_rate_dot_of_place_99_0
        * beta_rate_dot_of_beta_dot_7_0;
    let beta_rate_dot_of_beta_dot_11_0 = beta_rate_dot_of_place_54_0
        * beta_rate_dot_of_beta_dot_10_0;
    let beta_rate_dot_of_beta_dot_12_0 = beta_rate_dot_of_beta_dot_5_0 * over_cos_omega_sq;
    let beta_rate_dot_of_beta_dot_13_0 = beta_rate_dot_of_place_104_0
        * beta_rate_dot_of_beta_dot_12_0;
    let beta_rate_dot_of_beta_dot_14_0 = beta_rate_dot_of_place_71_0
        * beta_rate_dot_of_beta_dot_13_0;
    let beta_rate_dot_of_beta_dot_15_0 = beta_rate_dot_of_place_105_0
        * beta_rate_dot_of_beta_dot_12_0;
    let beta_rate_dot_of_beta_dot_16_0 = beta_rate_dot_of_place_91_0
        * beta_rate_dot_of_beta_dot_15_0;
    let beta_rate_dot_of_motion_11_0 = beta_rate_dot_of_beta_dot_16_0
        .mul_add(
            minus_rr_2,
            beta_rate_dot_of_beta_dot_14_0
                .mul_add(
                    minus_rr_2_by_u,
                    beta_rate_dot_of_beta_dot_11_0
                        .mul_add(
                            minus_rr_2,
                            beta_rate_dot_of_beta_dot_9_0
                                .mul_add(
                                    rr_2_by_zt,
                                    beta_rate_dot_of_beta_dot_4_0
                                        .mul_add(
                                            rr_2_by_d,
                                            beta_rate_dot_of_beta_dot_6_0
                                                .mul_add(
                                                    weight_34,
                                                    beta_rate_dot_of_motion_10_0.mul_add(rr, mom),
                                                ),
                                        ),
                                ),
                        ),
                ),
        );
    let beta_dot_dot_0 = beta_rate_dot_of_motion_11_0 * over_d1_of_place_19;
    let theta_ddot_of_place_0 = beta_rate_dot_of_place_94_0.mul_add(rr_by_d, -S::int(1));
    let theta_ddot_of_motion_0 = beta_dot_dot_0 * theta_ddot_of_place_0;
    let theta_dot_dot_0 = minus_rr_by_d * beta_rate_dot_of_beta_dot_3_0 + theta_ddot_of_motion_0;
    let gamma_ddot_of_beta_dot_0 = beta_rate_dot_of_place_17_0 * beta_rate_dot_of_beta_dot_2_0;
    let gamma_ddot_of_motion_0 = beta_dot_dot_0 * sin_theta_cos_angle_inv_0;
    let gamma_dot_dot_0 = gamma_ddot_of_motion_0
        .mul_add(rr_by_ss, minus_rr_by_ss * gamma_ddot_of_beta_dot_0);
    let delta_ddot_of_beta_dot_0 = beta_rate_dot_of_beta_dot_2_0 * over_cos_phi;
    let delta_ddot_of_beta_dot_2_0 = beta_rate_dot_of_place_34_0 * delta_ddot_of_beta_dot_0;
    let delta_ddot_of_motion_0 = gamma_ddot_of_motion_0 * over_cos_phi;
    let delta_ddot_of_motion_2_0 = sin_angle_2_0 * delta_ddot_of_motion_0;
    let delta_dot_dot_0 = delta_ddot_of_motion_2_0
        .mul_add(rr_by_zt, minus_rr_by_zt * delta_ddot_of_beta_dot_2_0);
    let phi_ddot_of_place_0 = cos_gamma_minus_delta_0
        .mul_add(minus_zt, e * sin_angle_2_0);
    let phi_ddot_of_beta_dot_0 = beta_rate_dot_of_place_54_0 * delta_ddot_of_beta_dot_0;
    let phi_ddot_of_motion_0 = phi_ddot_of_place_0 * delta_ddot_of_motion_0;
    let phi_dot_dot_0 = phi_ddot_of_motion_0
        .mul_add(minus_rr_by_e_zt, rr * phi_ddot_of_beta_dot_0);
    let epsilon_ddot_of_beta_dot_0 = beta_rate_dot_of_beta_dot_2_0 * over_cos_omega;
    let epsilon_ddot_of_beta_dot_2_0 = beta_rate_dot_of_place_71_0 * epsilon_ddot_of_beta_dot_0;
    let epsilon_ddot_of_motion_0 = gamma_ddot_of_motion_0 * over_cos_omega;
    let epsilon_ddot_of_motion_2_0 = cos_angle_3_0 * epsilon_ddot_of_motion_0;
    let epsilon_dot_dot_0 = epsilon_ddot_of_motion_2_0
        .mul_add(rr_by_u, rr_by_u * epsilon_ddot_of_beta_dot_2_0);
    let omega_ddot_of_place_0 = sin_gamma_minus_epsilon_0
        .mul_add(minus_u, zf * cos_angle_3_0);
    let omega_ddot_of_beta_dot_0 = beta_rate_dot_of_place_91_0 * epsilon_ddot_of_beta_dot_0;
    let omega_ddot_of_motion_0 = omega_ddot_of_place_0 * epsilon_ddot_of_motion_0;
    let omega_dot_dot_0 = omega_ddot_of_motion_0
        .mul_add(minus_rr_by_u_zf, rr * omega_ddot_of_beta_dot_0);
    // Order 1: the rates, and what follows from them.
    let beta_1 = beta_dot_0;
    let theta_1 = theta_dot_0;
    let gamma_1 = gamma_dot_0;
    let delta_1 = delta_dot_0;
    let phi_1 = phi_dot_0;
    let epsilon_1 = epsilon_dot_0;
    let omega_1 = omega_dot_0;
    let beta_dot_1 = beta_dot_dot_0;
    let theta_dot_1 = theta_dot_dot_0;
    let gamma_dot_1 = gamma_dot_dot_0;
    let delta_dot_1 = delta_dot_dot_0;
    let phi_dot_1 = phi_dot_dot_0;
    let epsilon_dot_1 = epsilon_dot_dot_0;
    let omega_dot_1 = omega_dot_dot_0;
    if series.len() > 1 {
        series[1] = [
            beta_1, theta_1, gamma_1, delta_1, phi_1, epsilon_1, omega_1, beta_dot_1, theta_dot_1,
            gamma_dot_1, delta_dot_1, phi_dot_1, epsilon_dot_1, omega_dot_1,
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
    let beta_rate_dot_of_place_3_1 = cos_gamma_1
        .mul_add(weight_14, weight_13 * sin_gamma_1);
    let sin_angle_cos_angle_inv_1 = cos_angle_1
        .mul_add(
            -(sin_angle_cos_angle_inv_0 * over_cos_angle),
            sin_angle_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_4_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_5_1 = sin_beta_minus_gamma_1 - beta_rate_dot_of_place_4_1;
    let beta_rate_dot_of_place_6_1 = beta_rate_dot_of_place_5_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_5_0);
    let beta_rate_dot_of_place_7_1 = beta_rate_dot_of_place_4_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * beta_rate_dot_of_place_4_0,
        );
    let beta_rate_dot_of_place_8_1 = beta_rate_dot_of_place_6_1
        .mul_add(weight_15, weight_16 * beta_rate_dot_of_place_7_1);
    let beta_rate_dot_of_place_9_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_9_0 * over_cos_angle),
            beta_rate_dot_of_place_8_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_10_1 = beta_rate_dot_of_place_9_1
        .mul_add(minus_rr, sin_beta_minus_gamma_1);
    let beta_rate_dot_of_place_11_1 = sin_angle_cos_angle_inv_1
        .mul_add(sin_theta_0, sin_theta_1 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_12_1 = cos_theta_1 + beta_rate_dot_of_place_11_1;
    let beta_rate_dot_of_place_13_1 = beta_rate_dot_of_place_12_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * beta_rate_dot_of_place_12_0,
        );
    let beta_rate_dot_of_place_14_1 = beta_rate_dot_of_place_11_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_11_0);
    let beta_rate_dot_of_place_15_1 = beta_rate_dot_of_place_13_1
        .mul_add(weight_16, minus_1_by_ss * beta_rate_dot_of_place_14_1);
    let beta_rate_dot_of_place_16_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_16_0 * over_cos_angle),
            beta_rate_dot_of_place_15_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_17_1 = beta_rate_dot_of_place_16_1
        .mul_add(minus_rr, cos_theta_1);
    let sin_phi_cos_phi_inv_1 = cos_phi_1
        .mul_add(-(sin_phi_cos_phi_inv_0 * over_cos_phi), sin_phi_1 * over_cos_phi);
    let beta_rate_dot_of_place_18_1 = sin_phi_cos_phi_inv_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * sin_phi_cos_phi_inv_0);
    let beta_rate_dot_of_place_19_1 = cos_angle_2_1 - beta_rate_dot_of_place_18_1;
    let beta_rate_dot_of_place_20_1 = beta_rate_dot_of_place_19_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_19_0,
        );
    let beta_rate_dot_of_place_21_1 = beta_rate_dot_of_place_18_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_18_0);
    let beta_rate_dot_of_place_22_1 = beta_rate_dot_of_place_20_1
        .mul_add(weight_17, weight_18 * beta_rate_dot_of_place_21_1);
    let beta_rate_dot_of_place_23_1 = cos_phi_1
        .mul_add(
            -(beta_rate_dot_of_place_23_0 * over_cos_phi),
            beta_rate_dot_of_place_22_1 * over_cos_phi,
        );
    let beta_rate_dot_of_place_24_1 = sin_angle_cos_angle_inv_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_25_1 = cos_angle_2_1 - beta_rate_dot_of_place_24_1;
    let beta_rate_dot_of_place_26_1 = minus_1_by_ss * beta_rate_dot_of_place_25_1
        + beta_rate_dot_of_place_23_1;
    let beta_rate_dot_of_place_27_1 = beta_rate_dot_of_place_26_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_26_0);
    let beta_rate_dot_of_place_28_1 = beta_rate_dot_of_place_4_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_4_0);
    let beta_rate_dot_of_place_29_1 = minus_1_by_d * beta_rate_dot_of_place_28_1
        + beta_rate_dot_of_place_27_1;
    let beta_rate_dot_of_place_30_1 = beta_rate_dot_of_place_29_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_29_0);
    let beta_rate_dot_of_place_31_1 = d1_of_place_4_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * d1_of_place_4_0);
    let beta_rate_dot_of_place_32_1 = minus_1_by_d * beta_rate_dot_of_place_31_1
        + beta_rate_dot_of_place_30_1;
    let beta_rate_dot_of_place_33_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_33_0 * over_cos_angle),
            beta_rate_dot_of_place_32_1 * over_cos_angle,
        );
    let cos_theta_sin_angle_2_1 = sin_angle_2_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_angle_2_0);
    let beta_rate_dot_of_place_34_1 = beta_rate_dot_of_place_33_1
        .mul_add(rr, cos_theta_sin_angle_2_1);
    let beta_rate_dot_of_place_35_1 = sin_phi_cos_phi_inv_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * sin_phi_cos_phi_inv_0,
        );
    let beta_rate_dot_of_place_36_1 = beta_rate_dot_of_place_35_1
        .mul_add(-S::int(2), sin_gamma_minus_delta_1);
    let beta_rate_dot_of_place_37_1 = beta_rate_dot_of_place_36_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_36_0);
    let beta_rate_dot_of_place_38_1 = cos_angle_2_1
        .mul_add(cos_gamma_minus_delta_0, cos_gamma_minus_delta_1 * cos_angle_2_0);
    let beta_rate_dot_of_place_39_1 = beta_rate_dot_of_place_35_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_35_0,
        );
    let beta_rate_dot_of_place_40_1 = beta_rate_dot_of_place_37_1
        .mul_add(
            weight_18,
            beta_rate_dot_of_place_39_1
                .mul_add(weight_17, weight_18 * beta_rate_dot_of_place_38_1),
        );
    let beta_rate_dot_of_place_41_1 = cos_phi_1
        .mul_add(
            -(beta_rate_dot_of_place_41_0 * over_cos_phi),
            beta_rate_dot_of_place_40_1 * over_cos_phi,
        );
    let beta_rate_dot_of_place_42_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_43_1 = cos_phi_1
        .mul_add(
            -(beta_rate_dot_of_place_43_0 * over_cos_phi),
            beta_rate_dot_of_place_21_1 * over_cos_phi,
        );
    let beta_rate_dot_of_place_44_1 = beta_rate_dot_of_place_41_1
        .mul_add(
            weight_17,
            beta_rate_dot_of_place_43_1
                .mul_add(
                    weight_19,
                    beta_rate_dot_of_place_25_1
                        .mul_add(
                            minus_1_by_ss_zt,
                            beta_rate_dot_of_place_42_1
                                .mul_add(
                                    minus_1_by_e_ss,
                                    minus_1_by_e_ss * sin_gamma_minus_delta_1,
                                ),
                        ),
                ),
        );
    let beta_rate_dot_of_place_45_1 = beta_rate_dot_of_place_44_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_44_0);
    let beta_rate_dot_of_place_46_1 = sin_angle_2_1
        .mul_add(minus_1_by_zt, weight_17 * cos_gamma_minus_delta_1);
    let beta_rate_dot_of_place_47_1 = beta_rate_dot_of_place_4_1
        .mul_add(
            beta_rate_dot_of_place_46_0,
            beta_rate_dot_of_place_46_1 * beta_rate_dot_of_place_4_0,
        );
    let beta_rate_dot_of_place_48_1 = weight_16 * beta_rate_dot_of_place_47_1
        + beta_rate_dot_of_place_45_1;
    let beta_rate_dot_of_place_49_1 = beta_rate_dot_of_place_48_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_48_0);
    let beta_rate_dot_of_place_50_1 = d1_of_place_4_1
        .mul_add(
            beta_rate_dot_of_place_46_0,
            beta_rate_dot_of_place_46_1 * d1_of_place_4_0,
        );
    let beta_rate_dot_of_place_51_1 = weight_16 * beta_rate_dot_of_place_50_1
        + beta_rate_dot_of_place_49_1;
    let beta_rate_dot_of_place_52_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_52_0 * over_cos_angle),
            beta_rate_dot_of_place_51_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_53_1 = beta_rate_dot_of_place_46_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_46_0);
    let beta_rate_dot_of_place_54_1 = beta_rate_dot_of_place_52_1
        .mul_add(rr, -beta_rate_dot_of_place_53_1);
    let sin_omega_cos_omega_inv_1 = cos_omega_1
        .mul_add(
            -(sin_omega_cos_omega_inv_0 * over_cos_omega),
            sin_omega_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_55_1 = sin_omega_cos_omega_inv_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * sin_omega_cos_omega_inv_0);
    let beta_rate_dot_of_place_56_1 = sin_angle_3_1 + beta_rate_dot_of_place_55_1;
    let beta_rate_dot_of_place_57_1 = beta_rate_dot_of_place_56_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_56_0,
        );
    let beta_rate_dot_of_place_58_1 = beta_rate_dot_of_place_55_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_55_0);
    let beta_rate_dot_of_place_59_1 = beta_rate_dot_of_place_57_1
        .mul_add(weight_20, minus_1_by_u * beta_rate_dot_of_place_58_1);
    let beta_rate_dot_of_place_60_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_60_0 * over_cos_omega),
            beta_rate_dot_of_place_59_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_61_1 = sin_angle_cos_angle_inv_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_62_1 = sin_angle_3_1 + beta_rate_dot_of_place_61_1;
    let beta_rate_dot_of_place_63_1 = minus_1_by_ss * beta_rate_dot_of_place_62_1
        + beta_rate_dot_of_place_60_1;
    let beta_rate_dot_of_place_64_1 = beta_rate_dot_of_place_63_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_63_0);
    let beta_rate_dot_of_place_65_1 = beta_rate_dot_of_place_4_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_4_0);
    let beta_rate_dot_of_place_66_1 = weight_16 * beta_rate_dot_of_place_65_1
        + beta_rate_dot_of_place_64_1;
    let beta_rate_dot_of_place_67_1 = beta_rate_dot_of_place_66_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_66_0);
    let beta_rate_dot_of_place_68_1 = d1_of_place_4_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * d1_of_place_4_0);
    let beta_rate_dot_of_place_69_1 = weight_16 * beta_rate_dot_of_place_68_1
        + beta_rate_dot_of_place_67_1;
    let beta_rate_dot_of_place_70_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_70_0 * over_cos_angle),
            beta_rate_dot_of_place_69_1 * over_cos_angle,
        );
    let cos_theta_cos_angle_3_1 = cos_angle_3_1
        .mul_add(cos_theta_0, cos_theta_1 * cos_angle_3_0);
    let beta_rate_dot_of_place_71_1 = beta_rate_dot_of_place_70_1
        .mul_add(rr, -cos_theta_cos_angle_3_1);
    let beta_rate_dot_of_place_72_1 = sin_omega_cos_omega_inv_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * sin_omega_cos_omega_inv_0,
        );
    let beta_rate_dot_of_place_73_1 = beta_rate_dot_of_place_72_1
        .mul_add(S::int(2), cos_gamma_minus_epsilon_1);
    let beta_rate_dot_of_place_74_1 = beta_rate_dot_of_place_73_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_73_0);
    let beta_rate_dot_of_place_75_1 = sin_angle_3_1
        .mul_add(sin_gamma_minus_epsilon_0, sin_gamma_minus_epsilon_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_76_1 = beta_rate_dot_of_place_74_1
        .mul_add(
            minus_1_by_zf,
            beta_rate_dot_of_place_58_1
                .mul_add(weight_21, minus_1_by_zf * beta_rate_dot_of_place_75_1),
        );
    let beta_rate_dot_of_place_77_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_77_0 * over_cos_omega),
            beta_rate_dot_of_place_76_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_78_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_79_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_79_0 * over_cos_omega),
            sin_gamma_minus_epsilon_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_80_1 = beta_rate_dot_of_place_72_1
        .mul_add(
            beta_rate_dot_of_place_79_0,
            beta_rate_dot_of_place_79_1 * beta_rate_dot_of_place_72_0,
        );
    let beta_rate_dot_of_place_81_1 = beta_rate_dot_of_place_77_1
        .mul_add(
            weight_21,
            beta_rate_dot_of_place_80_1
                .mul_add(
                    weight_24,
                    beta_rate_dot_of_place_62_1
                        .mul_add(
                            weight_22,
                            beta_rate_dot_of_place_78_1
                                .mul_add(
                                    minus_1_by_ss_zf,
                                    weight_23 * cos_gamma_minus_epsilon_1,
                                ),
                        ),
                ),
        );
    let beta_rate_dot_of_place_82_1 = beta_rate_dot_of_place_81_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_81_0);
    let beta_rate_dot_of_place_83_1 = cos_angle_3_1
        .mul_add(minus_1_by_u, weight_20 * sin_gamma_minus_epsilon_1);
    let beta_rate_dot_of_place_84_1 = beta_rate_dot_of_place_4_1
        .mul_add(
            beta_rate_dot_of_place_83_0,
            beta_rate_dot_of_place_83_1 * beta_rate_dot_of_place_4_0,
        );
    let beta_rate_dot_of_place_85_1 = weight_16 * beta_rate_dot_of_place_84_1
        + beta_rate_dot_of_place_82_1;
    let beta_rate_dot_of_place_86_1 = beta_rate_dot_of_place_85_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_85_0);
    let beta_rate_dot_of_place_87_1 = d1_of_place_4_1
        .mul_add(
            beta_rate_dot_of_place_83_0,
            beta_rate_dot_of_place_83_1 * d1_of_place_4_0,
        );
    let beta_rate_dot_of_place_88_1 = weight_16 * beta_rate_dot_of_place_87_1
        + beta_rate_dot_of_place_86_1;
    let beta_rate_dot_of_place_89_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_89_0 * over_cos_angle),
            beta_rate_dot_of_place_88_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_90_1 = beta_rate_dot_of_place_83_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_83_0);
    let beta_rate_dot_of_place_91_1 = beta_rate_dot_of_place_89_1
        .mul_add(rr, -beta_rate_dot_of_place_90_1);
    let beta_rate_dot_of_place_92_1 = beta_rate_dot_of_place_2_1
        .mul_add(
            beta_rate_dot_of_place_3_0,
            beta_rate_dot_of_place_3_1 * beta_rate_dot_of_place_2_0,
        );
    let beta_rate_dot_of_place_93_1 = l0 * beta_rate_dot_of_place_3_1 - beta_rate_dot_of_place_92_1;
    let beta_rate_dot_of_place_94_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_94_0 * over_cos_angle),
            cos_beta_minus_gamma_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_95_1 = beta_rate_dot_of_place_94_1
        .mul_add(weight_25, minus_m2_da * cos_theta_1);
    let beta_rate_dot_of_e_ea_zt_phi_1 = zt_minus_ea_zt_by_e * sin_phi_1;
    let beta_rate_dot_of_place_96_1 = beta_rate_dot_of_e_ea_zt_phi_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_e_ea_zt_phi_0,
        );
    let beta_rate_dot_of_e_ea_zt_phi_2_1 = e_minus_ea * sin_phi_1;
    let beta_rate_dot_of_place_97_1 = beta_rate_dot_of_e_ea_zt_phi_2_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_e_ea_zt_phi_2_0);
    let beta_rate_dot_of_place_98_1 = beta_rate_dot_of_place_97_1
        .mul_add(
            m4,
            beta_rate_dot_of_place_96_1
                .mul_add(
                    m4,
                    cos_gamma_minus_delta_1.mul_add(i4_by_e, weight_27 * sin_angle_2_1),
                ),
        );
    let beta_rate_dot_of_place_99_1 = sin_phi_sin_angle_2_1
        .mul_add(m4_e_minus_ea, weight_28 * cos_gamma_minus_delta_1);
    let beta_rate_dot_of_place_100_1 = u_fa_by_zf_minus_u * sin_omega_1;
    let beta_rate_dot_of_place_101_1 = beta_rate_dot_of_place_100_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_100_0,
        );
    let beta_rate_dot_of_place_102_1 = fa_minus_zf * sin_omega_1;
    let beta_rate_dot_of_place_103_1 = beta_rate_dot_of_place_102_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_102_0);
    let beta_rate_dot_of_place_104_1 = beta_rate_dot_of_place_103_1
        .mul_add(
            m6,
            beta_rate_dot_of_place_101_1
                .mul_add(
                    m6,
                    sin_gamma_minus_epsilon_1
                        .mul_add(i6_by_zf, weight_30 * cos_angle_3_1),
                ),
        );
    let beta_rate_dot_of_place_105_1 = sin_omega_cos_angle_3_1
        .mul_add(m6_fa_minus_zf, weight_31 * sin_gamma_minus_epsilon_1);
    let beta_rate_dot_of_place_106_1 = beta_rate_dot_of_place_1
        .mul_add(
            -(beta_rate_dot_of_place_106_0 * over_beta_rate_dot_of_place),
            beta_rate_dot_of_place_2_1 * over_beta_rate_dot_of_place,
        );
    let beta_rate_dot_of_place_107_1 = beta_rate_dot_of_place_93_1
        .mul_add(
            beta_rate_dot_of_place_106_0,
            beta_rate_dot_of_place_106_1 * beta_rate_dot_of_place_93_0,
        );
    let beta_rate_dot_of_place_108_1 = cos_gamma_minus_delta_1
        .mul_add(ea_zt_by_e_minus_zt, e_minus_ea * sin_angle_2_1);
    let beta_rate_dot_of_delta_dot_1 = beta_rate_dot_of_place_108_1
        .mul_add(delta_dot_0, delta_dot_1 * beta_rate_dot_of_place_108_0);
    let phi_dot_sin_angle_2_1 = sin_angle_2_1
        .mul_add(phi_dot_0, phi_dot_1 * sin_angle_2_0);
    let beta_rate_dot_of_motion_1 = weight_32 * phi_dot_sin_angle_2_1
        + beta_rate_dot_of_delta_dot_1;
    let beta_rate_dot_of_motion_2_1 = beta_rate_dot_of_motion_1
        .mul_add(delta_dot_0, delta_dot_1 * beta_rate_dot_of_motion_0);
    let phi_dot_sq_sin_angle_2_1 = phi_dot_sin_angle_2_1
        .mul_add(phi_dot_0, phi_dot_1 * phi_dot_sin_angle_2_0);
    let beta_rate_dot_of_place_109_1 = cos_angle_3_1
        .mul_add(zf_minus_fa, u_fa_by_zf_minus_1 * sin_gamma_minus_epsilon_1);
    let beta_rate_dot_of_epsilon_dot_1 = beta_rate_dot_of_place_109_1
        .mul_add(epsilon_dot_0, epsilon_dot_1 * beta_rate_dot_of_place_109_0);
    let omega_dot_cos_angle_3_1 = cos_angle_3_1
        .mul_add(omega_dot_0, omega_dot_1 * cos_angle_3_0);
    let beta_rate_dot_of_motion_3_1 = weight_33 * omega_dot_cos_angle_3_1
        + beta_rate_dot_of_epsilon_dot_1;
    let beta_rate_dot_of_motion_4_1 = beta_rate_dot_of_motion_3_1
        .mul_add(epsilon_dot_0, epsilon_dot_1 * beta_rate_dot_of_motion_3_0);
    let omega_dot_sq_cos_angle_3_1 = omega_dot_cos_angle_3_1
        .mul_add(omega_dot_0, omega_dot_1 * omega_dot_cos_angle_3_0);
    let beta_dot_sq_1 = beta_dot_1 * (beta_dot_0 + beta_dot_0);
    let beta_rate_dot_of_beta_dot_1 = cos_beta_minus_gamma_1
        .mul_add(beta_dot_sq_0, beta_dot_sq_1 * cos_beta_minus_gamma_0);
    let beta_rate_dot_of_motion_5_1 = beta_rate_dot_of_place_107_1
        .mul_add(
            c0_by_ss,
            beta_rate_dot_of_motion_4_1
                .mul_add(
                    m6,
                    beta_rate_dot_of_motion_2_1
                        .mul_add(
                            minus_m4,
                            omega_dot_sq_cos_angle_3_1
                                .mul_add(
                                    m6_zf_minus_fa,
                                    phi_dot_sq_sin_angle_2_1
                                        .mul_add(
                                            m4_ea_minus_e,
                                            m2_da_rr_by_d * beta_rate_dot_of_beta_dot_1,
                                        ),
                                ),
                        ),
                ),
        );
    let beta_rate_dot_of_motion_6_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_motion_6_0 * over_cos_angle),
            beta_rate_dot_of_motion_5_1 * over_cos_angle,
        );
    let beta_rate_dot_of_motion_7_1 = theta_dot_1.mul_add(S::int(2), beta_dot_1);
    let beta_rate_dot_of_motion_8_1 = beta_rate_dot_of_motion_7_1
        .mul_add(beta_dot_0, beta_dot_1 * beta_rate_dot_of_motion_7_0);
    let theta_dot_sq_1 = theta_dot_1 * (theta_dot_0 + theta_dot_0);
    let beta_rate_dot_of_motion_9_1 = beta_rate_dot_of_motion_8_1
        .mul_add(minus_m2_da, minus_m2_da * theta_dot_sq_1) + beta_rate_dot_of_motion_6_1;
    let beta_rate_dot_of_motion_10_1 = beta_rate_dot_of_motion_9_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_motion_9_0);
    let beta_rate_dot_of_beta_dot_2_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_beta_dot_2_0 * over_cos_angle),
            beta_dot_sq_1 * over_cos_angle,
        );
    let beta_rate_dot_of_beta_dot_3_1 = beta_rate_dot_of_place_10_1
        .mul_add(
            beta_rate_dot_of_beta_dot_2_0,
            beta_rate_dot_of_beta_dot_2_1 * beta_rate_dot_of_place_10_0,
        );
    let beta_rate_dot_of_beta_dot_4_1 = beta_rate_dot_of_beta_dot_3_1
        .mul_add(
            beta_rate_dot_of_place_95_0,
            beta_rate_dot_of_place_95_1 * beta_rate_dot_of_beta_dot_3_0,
        );
    let sin_theta_cos_angle_inv_1 = cos_angle_1
        .mul_add(
            -(sin_theta_cos_angle_inv_0 * over_cos_angle),
            sin_theta_1 * over_cos_angle,
        );
    let beta_rate_dot_of_beta_dot_5_1 = sin_theta_cos_angle_inv_1
        .mul_add(
            beta_rate_dot_of_beta_dot_2_0,
            beta_rate_dot_of_beta_dot_2_1 * sin_theta_cos_angle_inv_0,
        );
    let beta_rate_dot_of_beta_dot_6_1 = beta_rate_dot_of_place_17_1
        .mul_add(
            beta_rate_dot_of_beta_dot_5_0,
            beta_rate_dot_of_beta_dot_5_1 * beta_rate_dot_of_place_17_0,
        );
    let beta_rate_dot_of_beta_dot_7_1 = cos_phi_sq_1
        .mul_add(
            -(beta_rate_dot_of_beta_dot_7_0 * over_cos_phi_sq),
            beta_rate_dot_of_beta_dot_5_1 * over_cos_phi_sq,
        );
    let beta_rate_dot_of_beta_dot_8_1 = beta_rate_dot_of_beta_dot_7_1
        .mul_add(
            beta_rate_dot_of_place_98_0,
            beta_rate_dot_of_place_98_1 * beta_rate_dot_of_beta_dot_7_0,
        );
    let beta_rate_dot_of_beta_dot_9_1 = beta_rate_dot_of_place_34_1
        .mul_add(
            beta_rate_dot_of_beta_dot_8_0,
            beta_rate_dot_of_beta_dot_8_1 * beta_rate_dot_of_place_34_0,
        );
    let beta_rate_dot_of_beta_dot_10_1 = beta_rate_dot_of_beta_dot_7_1
        .mul_add(
            beta_rate_dot_of_place_99_0,
            beta_rate_dot_of_place_99_1 * beta_rate_dot_of_beta_dot_7_0,
        );
    let beta_rate_dot_of_beta_dot_11_1 = beta_rate_dot_of_place_54_1
        .mul_add(
            beta_rate_dot_of_beta_dot_10_0,
            beta_rate_dot_of_beta_dot_10_1 * beta_rate_dot_of_place_54_0,
        );
    let beta_rate_dot_of_beta_dot_12_1 = cos_omega_sq_1
        .mul_add(
            -(beta_rate_dot_of_beta_dot_12_0 * over_cos_omega_sq),
            beta_rate_dot_of_beta_dot_5_1 * over_cos_omega_sq,
        );
    let beta_rate_dot_of_beta_dot_13_1 = beta_rate_dot_of_beta_dot_12_1
        .mul_add(
            beta_rate_dot_of_place_104_0,
            beta_rate_dot_of_place_104_1 * beta_rate_dot_of_beta_dot_12_0,
        );
    let beta_rate_dot_of_beta_dot_14_1 = beta_rate_dot_of_place_71_1
        .mul_add(
            beta_rate_dot_of_beta_dot_13_0,
            beta_rate_dot_of_beta_dot_13_1 * beta_rate_dot_of_place_71_0,
        );
    let beta_rate_dot_of_beta_dot_15_1 = beta_rate_dot_of_beta_dot_12_1
        .mul_add(
            beta_rate_dot_of_place_105_0,
            beta_rate_dot_of_place_105_1 * beta_rate_dot_of_beta_dot_12_0,
        );
    let beta_rate_dot_of_beta_dot_16_1 = beta_rate_dot_of_place_91_1
        .mul_add(
            beta_rate_dot_of_beta_dot_15_0,
            beta_rate_dot_of_beta_dot_15_1 * beta_rate_dot_of_place_91_0,
        );
    let beta_rate_dot_of_motion_11_1 = beta_rate_dot_of_beta_dot_16_1
        .mul_add(
            minus_rr_2,
            beta_rate_dot_of_beta_dot_14_1
                .mul_add(
                    minus_rr_2_by_u,
                    beta_rate_dot_of_beta_dot_11_1
                        .mul_add(
                            minus_rr_2,
                            beta_rate_dot_of_beta_dot_9_1
                                .mul_add(
                                    rr_2_by_zt,
                                    beta_rate_dot_of_beta_dot_4_1
                                        .mul_add(
                                            rr_2_by_d,
                                            beta_rate_dot_of_beta_dot_6_1
                                                .mul_add(weight_34, rr * beta_rate_dot_of_motion_10_1),
                                        ),
                                ),
                        ),
                ),
        );
    let beta_dot_dot_1 = d1_of_place_19_1
        .mul_add(
            -(beta_dot_dot_0 * over_d1_of_place_19),
            beta_rate_dot_of_motion_11_1 * over_d1_of_place_19,
        );
    let theta_ddot_of_place_1 = rr_by_d * beta_rate_dot_of_place_94_1;
    let theta_ddot_of_motion_1 = beta_dot_dot_1
        .mul_add(theta_ddot_of_place_0, theta_ddot_of_place_1 * beta_dot_dot_0);
    let theta_dot_dot_1 = minus_rr_by_d * beta_rate_dot_of_beta_dot_3_1 + theta_ddot_of_motion_1;
    let gamma_ddot_of_beta_dot_1 = beta_rate_dot_of_place_17_1
        .mul_add(
            beta_rate_dot_of_beta_dot_2_0,
            beta_rate_dot_of_beta_dot_2_1 * beta_rate_dot_of_place_17_0,
        );
    let gamma_ddot_of_motion_1 = beta_dot_dot_1
        .mul_add(sin_theta_cos_angle_inv_0, sin_theta_cos_angle_inv_1 * beta_dot_dot_0);
    let gamma_dot_dot_1 = gamma_ddot_of_motion_1
        .mul_add(rr_by_ss, minus_rr_by_ss * gamma_ddot_of_beta_dot_1);
    let delta_ddot_of_beta_dot_1 = cos_phi_1
        .mul_add(
            -(delta_ddot_of_beta_dot_0 * over_cos_phi),
            beta_rate_dot_of_beta_dot_2_1 * over_cos_phi,
        );
    let delta_ddot_of_beta_dot_2_1 = beta_rate_dot_of_place_34_1
        .mul_add(
            delta_ddot_of_beta_dot_0,
            delta_ddot_of_beta_dot_1 * beta_rate_dot_of_place_34_0,
        );
    let delta_ddot_of_motion_1 = cos_phi_1
        .mul_add(
            -(delta_ddot_of_motion_0 * over_cos_phi),
            gamma_ddot_of_motion_1 * over_cos_phi,
        );
    let delta_ddot_of_motion_2_1 = delta_ddot_of_motion_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * delta_ddot_of_motion_0);
    let delta_dot_dot_1 = delta_ddot_of_motion_2_1
        .mul_add(rr_by_zt, minus_rr_by_zt * delta_ddot_of_beta_dot_2_1);
    let phi_ddot_of_place_1 = cos_gamma_minus_delta_1
        .mul_add(minus_zt, e * sin_angle_2_1);
    let phi_ddot_of_beta_dot_1 = beta_rate_dot_of_place_54_1
        .mul_add(
            delta_ddot_of_beta_dot_0,
            delta_ddot_of_beta_dot_1 * beta_rate_dot_of_place_54_0,
        );
    let phi_ddot_of_motion_1 = delta_ddot_of_motion_1
        .mul_add(phi_ddot_of_place_0, phi_ddot_of_place_1 * delta_ddot_of_motion_0);
    let phi_dot_dot_1 = phi_ddot_of_motion_1
        .mul_add(minus_rr_by_e_zt, rr * phi_ddot_of_beta_dot_1);
    let epsilon_ddot_of_beta_dot_1 = cos_omega_1
        .mul_add(
            -(epsilon_ddot_of_beta_dot_0 * over_cos_omega),
            beta_rate_dot_of_beta_dot_2_1 * over_cos_omega,
        );
    let epsilon_ddot_of_beta_dot_2_1 = beta_rate_dot_of_place_71_1
        .mul_add(
            epsilon_ddot_of_beta_dot_0,
            epsilon_ddot_of_beta_dot_1 * beta_rate_dot_of_place_71_0,
        );
    let epsilon_ddot_of_motion_1 = cos_omega_1
        .mul_add(
            -(epsilon_ddot_of_motion_0 * over_cos_omega),
            gamma_ddot_of_motion_1 * over_cos_omega,
        );
    let epsilon_ddot_of_motion_2_1 = epsilon_ddot_of_motion_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * epsilon_ddot_of_motion_0);
    let epsilon_dot_dot_1 = epsilon_ddot_of_motion_2_1
        .mul_add(rr_by_u, rr_by_u * epsilon_ddot_of_beta_dot_2_1);
    let omega_ddot_of_place_1 = sin_gamma_minus_epsilon_1
        .mul_add(minus_u, zf * cos_angle_3_1);
    let omega_ddot_of_beta_dot_1 = beta_rate_dot_of_place_91_1
        .mul_add(
            epsilon_ddot_of_beta_dot_0,
            epsilon_ddot_of_beta_dot_1 * beta_rate_dot_of_place_91_0,
        );
    let omega_ddot_of_motion_1 = epsilon_ddot_of_motion_1
        .mul_add(
            omega_ddot_of_place_0,
            omega_ddot_of_place_1 * epsilon_ddot_of_motion_0,
        );
    let omega_dot_dot_1 = omega_ddot_of_motion_1
        .mul_add(minus_rr_by_u_zf, rr * omega_ddot_of_beta_dot_1);
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
                beta_rate_dot_of_place_2_1, cos_angle_1, cos_beta_minus_gamma_1, sin_theta_1,
                cos_beta_minus_gamma_1, cos_angle_1, sin_theta_1, cos_beta_minus_gamma_1,
                sin_theta_1, cos_angle_1, cos_phi_1, sin_angle_2_1, cos_gamma_minus_delta_1,
                sin_angle_2_1, cos_phi_1, sin_angle_2_1, sin_theta_1, sin_angle_2_1, sin_theta_1,
                sin_angle_2_1, cos_angle_1, cos_theta_1, cos_gamma_minus_delta_1, sin_angle_2_1,
                cos_gamma_minus_delta_1, cos_gamma_minus_delta_1, cos_phi_1,
                cos_gamma_minus_delta_1, cos_phi_1, sin_theta_1, beta_rate_dot_of_place_46_1,
                sin_theta_1, beta_rate_dot_of_place_46_1, cos_angle_1, cos_theta_1, cos_omega_1,
                cos_angle_3_1, sin_gamma_minus_epsilon_1, cos_angle_3_1, cos_omega_1, cos_angle_3_1,
                sin_theta_1, cos_angle_3_1, sin_theta_1, cos_angle_3_1, cos_angle_1, cos_theta_1,
                sin_gamma_minus_epsilon_1, cos_angle_3_1, sin_gamma_minus_epsilon_1, cos_omega_1,
                sin_gamma_minus_epsilon_1, cos_omega_1, beta_rate_dot_of_place_72_1, sin_theta_1,
                beta_rate_dot_of_place_83_1, sin_theta_1, beta_rate_dot_of_place_83_1, cos_angle_1,
                cos_theta_1, beta_rate_dot_of_place_2_1, cos_angle_1, cos_gamma_minus_delta_1,
                sin_angle_2_1, sin_gamma_minus_epsilon_1, cos_angle_3_1, beta_rate_dot_of_place_1,
                beta_rate_dot_of_place_93_1, delta_dot_1, phi_dot_1, delta_dot_1, phi_dot_1,
                epsilon_dot_1, omega_dot_1, epsilon_dot_1, omega_dot_1, beta_dot_1,
                cos_beta_minus_gamma_1, cos_angle_1, beta_dot_1, theta_dot_1, sin_theta_1,
                cos_angle_1, beta_rate_dot_of_place_10_1, beta_rate_dot_of_place_95_1, cos_angle_1,
                beta_rate_dot_of_beta_dot_2_1, beta_rate_dot_of_place_17_1, cos_phi_sq_1,
                beta_rate_dot_of_place_98_1, beta_rate_dot_of_place_34_1,
                beta_rate_dot_of_place_99_1, beta_rate_dot_of_place_54_1, cos_omega_sq_1,
                beta_rate_dot_of_place_104_1, beta_rate_dot_of_place_71_1,
                beta_rate_dot_of_place_105_1, beta_rate_dot_of_place_91_1, d1_of_place_19_1,
                beta_dot_dot_1, beta_rate_dot_of_place_17_1, beta_dot_dot_1, cos_phi_1,
                beta_rate_dot_of_place_34_1, cos_phi_1, sin_angle_2_1, beta_rate_dot_of_place_54_1,
                phi_ddot_of_place_1, cos_omega_1, beta_rate_dot_of_place_71_1, cos_omega_1,
                cos_angle_3_1, beta_rate_dot_of_place_91_1, omega_ddot_of_place_1,
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
                beta_rate_dot_of_place_2_1, sin_angle_cos_angle_inv_1, sin_angle_cos_angle_inv_1,
                beta_rate_dot_of_place_5_1, beta_rate_dot_of_place_4_1, beta_rate_dot_of_place_9_1,
                sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_12_1, beta_rate_dot_of_place_11_1,
                beta_rate_dot_of_place_16_1, sin_phi_cos_phi_inv_1, sin_phi_cos_phi_inv_1,
                beta_rate_dot_of_place_19_1, beta_rate_dot_of_place_18_1,
                beta_rate_dot_of_place_23_1, sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_26_1,
                beta_rate_dot_of_place_4_1, beta_rate_dot_of_place_29_1, d1_of_place_4_1,
                beta_rate_dot_of_place_33_1, sin_angle_2_1, sin_phi_cos_phi_inv_1,
                beta_rate_dot_of_place_36_1, cos_angle_2_1, beta_rate_dot_of_place_35_1,
                beta_rate_dot_of_place_41_1, sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_43_1,
                beta_rate_dot_of_place_44_1, beta_rate_dot_of_place_4_1,
                beta_rate_dot_of_place_48_1, d1_of_place_4_1, beta_rate_dot_of_place_52_1,
                beta_rate_dot_of_place_46_1, sin_omega_cos_omega_inv_1, sin_omega_cos_omega_inv_1,
                beta_rate_dot_of_place_56_1, beta_rate_dot_of_place_55_1,
                beta_rate_dot_of_place_60_1, sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_63_1,
                beta_rate_dot_of_place_4_1, beta_rate_dot_of_place_66_1, d1_of_place_4_1,
                beta_rate_dot_of_place_70_1, cos_angle_3_1, sin_omega_cos_omega_inv_1,
                beta_rate_dot_of_place_73_1, sin_angle_3_1, beta_rate_dot_of_place_77_1,
                sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_79_1, beta_rate_dot_of_place_79_1,
                beta_rate_dot_of_place_81_1, beta_rate_dot_of_place_4_1,
                beta_rate_dot_of_place_85_1, d1_of_place_4_1, beta_rate_dot_of_place_89_1,
                beta_rate_dot_of_place_83_1, beta_rate_dot_of_place_3_1,
                beta_rate_dot_of_place_94_1, beta_rate_dot_of_e_ea_zt_phi_1,
                beta_rate_dot_of_e_ea_zt_phi_2_1, beta_rate_dot_of_place_100_1,
                beta_rate_dot_of_place_102_1, beta_rate_dot_of_place_106_1,
                beta_rate_dot_of_place_106_1, beta_rate_dot_of_place_108_1, sin_angle_2_1,
                beta_rate_dot_of_motion_1, phi_dot_sin_angle_2_1, beta_rate_dot_of_place_109_1,
                cos_angle_3_1, beta_rate_dot_of_motion_3_1, omega_dot_cos_angle_3_1, beta_dot_1,
                beta_dot_sq_1, beta_rate_dot_of_motion_6_1, beta_rate_dot_of_motion_7_1,
                theta_dot_1, beta_rate_dot_of_motion_9_1, beta_rate_dot_of_beta_dot_2_1,
                beta_rate_dot_of_beta_dot_2_1, beta_rate_dot_of_beta_dot_3_1,
                sin_theta_cos_angle_inv_1, sin_theta_cos_angle_inv_1, beta_rate_dot_of_beta_dot_5_1,
                beta_rate_dot_of_beta_dot_7_1, beta_rate_dot_of_beta_dot_7_1,
                beta_rate_dot_of_beta_dot_8_1, beta_rate_dot_of_beta_dot_7_1,
                beta_rate_dot_of_beta_dot_10_1, beta_rate_dot_of_beta_dot_12_1,
                beta_rate_dot_of_beta_dot_12_1, beta_rate_dot_of_beta_dot_13_1,
                beta_rate_dot_of_beta_dot_12_1, beta_rate_dot_of_beta_dot_15_1, beta_dot_dot_1,
                theta_ddot_of_place_1, beta_rate_dot_of_beta_dot_2_1, sin_theta_cos_angle_inv_1,
                delta_ddot_of_beta_dot_1, delta_ddot_of_beta_dot_1, delta_ddot_of_motion_1,
                delta_ddot_of_motion_1, delta_ddot_of_beta_dot_1, delta_ddot_of_motion_1,
                epsilon_ddot_of_beta_dot_1, epsilon_ddot_of_beta_dot_1, epsilon_ddot_of_motion_1,
                epsilon_ddot_of_motion_1, epsilon_ddot_of_beta_dot_1, epsilon_ddot_of_motion_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut gamma_last = gamma_1;
    let mut phi_last = phi_1;
    let mut omega_last = omega_1;
    let mut beta_dot_last = beta_dot_1;
    let mut theta_dot_last = theta_dot_1;
    let mut delta_dot_last = delta_dot_1;
    let mut phi_dot_last = phi_dot_1;
    let mut epsilon_dot_last = epsilon_dot_1;
    let mut omega_dot_last = omega_dot_1;
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
    let mut d1_of_place_4_last = d1_of_place_4_1;
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
    let mut sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv_1;
    let mut beta_rate_dot_of_place_4_last = beta_rate_dot_of_place_4_1;
    let mut beta_rate_dot_of_place_5_last = beta_rate_dot_of_place_5_1;
    let mut beta_rate_dot_of_place_9_last = beta_rate_dot_of_place_9_1;
    let mut beta_rate_dot_of_place_10_last = beta_rate_dot_of_place_10_1;
    let mut beta_rate_dot_of_place_11_last = beta_rate_dot_of_place_11_1;
    let mut beta_rate_dot_of_place_12_last = beta_rate_dot_of_place_12_1;
    let mut beta_rate_dot_of_place_16_last = beta_rate_dot_of_place_16_1;
    let mut beta_rate_dot_of_place_17_last = beta_rate_dot_of_place_17_1;
    let mut sin_phi_cos_phi_inv_last = sin_phi_cos_phi_inv_1;
    let mut beta_rate_dot_of_place_18_last = beta_rate_dot_of_place_18_1;
    let mut beta_rate_dot_of_place_19_last = beta_rate_dot_of_place_19_1;
    let mut beta_rate_dot_of_place_23_last = beta_rate_dot_of_place_23_1;
    let mut beta_rate_dot_of_place_26_last = beta_rate_dot_of_place_26_1;
    let mut beta_rate_dot_of_place_29_last = beta_rate_dot_of_place_29_1;
    let mut beta_rate_dot_of_place_33_last = beta_rate_dot_of_place_33_1;
    let mut beta_rate_dot_of_place_34_last = beta_rate_dot_of_place_34_1;
    let mut beta_rate_dot_of_place_35_last = beta_rate_dot_of_place_35_1;
    let mut beta_rate_dot_of_place_36_last = beta_rate_dot_of_place_36_1;
    let mut beta_rate_dot_of_place_41_last = beta_rate_dot_of_place_41_1;
    let mut beta_rate_dot_of_place_43_last = beta_rate_dot_of_place_43_1;
    let mut beta_rate_dot_of_place_44_last = beta_rate_dot_of_place_44_1;
    let mut beta_rate_dot_of_place_46_last = beta_rate_dot_of_place_46_1;
    let mut beta_rate_dot_of_place_48_last = beta_rate_dot_of_place_48_1;
    let mut beta_rate_dot_of_place_52_last = beta_rate_dot_of_place_52_1;
    let mut beta_rate_dot_of_place_54_last = beta_rate_dot_of_place_54_1;
    let mut sin_omega_cos_omega_inv_last = sin_omega_cos_omega_inv_1;
    let mut beta_rate_dot_of_place_55_last = beta_rate_dot_of_place_55_1;
    let mut beta_rate_dot_of_place_56_last = beta_rate_dot_of_place_56_1;
    let mut beta_rate_dot_of_place_60_last = beta_rate_dot_of_place_60_1;
    let mut beta_rate_dot_of_place_63_last = beta_rate_dot_of_place_63_1;
    let mut beta_rate_dot_of_place_66_last = beta_rate_dot_of_place_66_1;
    let mut beta_rate_dot_of_place_70_last = beta_rate_dot_of_place_70_1;
    let mut beta_rate_dot_of_place_71_last = beta_rate_dot_of_place_71_1;
    let mut beta_rate_dot_of_place_72_last = beta_rate_dot_of_place_72_1;
    let mut beta_rate_dot_of_place_73_last = beta_rate_dot_of_place_73_1;
    let mut beta_rate_dot_of_place_77_last = beta_rate_dot_of_place_77_1;
    let mut beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79_1;
    let mut beta_rate_dot_of_place_81_last = beta_rate_dot_of_place_81_1;
    let mut beta_rate_dot_of_place_83_last = beta_rate_dot_of_place_83_1;
    let mut beta_rate_dot_of_place_85_last = beta_rate_dot_of_place_85_1;
    let mut beta_rate_dot_of_place_89_last = beta_rate_dot_of_place_89_1;
    let mut beta_rate_dot_of_place_91_last = beta_rate_dot_of_place_91_1;
    let mut beta_rate_dot_of_place_93_last = beta_rate_dot_of_place_93_1;
    let mut beta_rate_dot_of_place_94_last = beta_rate_dot_of_place_94_1;
    let mut beta_rate_dot_of_place_95_last = beta_rate_dot_of_place_95_1;
    let mut beta_rate_dot_of_e_ea_zt_phi_last = beta_rate_dot_of_e_ea_zt_phi_1;
    let mut beta_rate_dot_of_e_ea_zt_phi_2_last = beta_rate_dot_of_e_ea_zt_phi_2_1;
    let mut beta_rate_dot_of_place_98_last = beta_rate_dot_of_place_98_1;
    let mut beta_rate_dot_of_place_99_last = beta_rate_dot_of_place_99_1;
    let mut beta_rate_dot_of_place_100_last = beta_rate_dot_of_place_100_1;
    let mut beta_rate_dot_of_place_102_last = beta_rate_dot_of_place_102_1;
    let mut beta_rate_dot_of_place_104_last = beta_rate_dot_of_place_104_1;
    let mut beta_rate_dot_of_place_105_last = beta_rate_dot_of_place_105_1;
    let mut beta_rate_dot_of_place_106_last = beta_rate_dot_of_place_106_1;
    let mut beta_rate_dot_of_place_108_last = beta_rate_dot_of_place_108_1;
    let mut phi_dot_sin_angle_2_last = phi_dot_sin_angle_2_1;
    let mut beta_rate_dot_of_motion_last = beta_rate_dot_of_motion_1;
    let mut beta_rate_dot_of_place_109_last = beta_rate_dot_of_place_109_1;
    let mut omega_dot_cos_angle_3_last = omega_dot_cos_angle_3_1;
    let mut beta_rate_dot_of_motion_3_last = beta_rate_dot_of_motion_3_1;
    let mut beta_dot_sq_last = beta_dot_sq_1;
    let mut beta_rate_dot_of_motion_6_last = beta_rate_dot_of_motion_6_1;
    let mut beta_rate_dot_of_motion_7_last = beta_rate_dot_of_motion_7_1;
    let mut beta_rate_dot_of_motion_9_last = beta_rate_dot_of_motion_9_1;
    let mut beta_rate_dot_of_beta_dot_2_last = beta_rate_dot_of_beta_dot_2_1;
    let mut beta_rate_dot_of_beta_dot_3_last = beta_rate_dot_of_beta_dot_3_1;
    let mut sin_theta_cos_angle_inv_last = sin_theta_cos_angle_inv_1;
    let mut beta_rate_dot_of_beta_dot_5_last = beta_rate_dot_of_beta_dot_5_1;
    let mut beta_rate_dot_of_beta_dot_7_last = beta_rate_dot_of_beta_dot_7_1;
    let mut beta_rate_dot_of_beta_dot_8_last = beta_rate_dot_of_beta_dot_8_1;
    let mut beta_rate_dot_of_beta_dot_10_last = beta_rate_dot_of_beta_dot_10_1;
    let mut beta_rate_dot_of_beta_dot_12_last = beta_rate_dot_of_beta_dot_12_1;
    let mut beta_rate_dot_of_beta_dot_13_last = beta_rate_dot_of_beta_dot_13_1;
    let mut beta_rate_dot_of_beta_dot_15_last = beta_rate_dot_of_beta_dot_15_1;
    let mut beta_dot_dot_last = beta_dot_dot_1;
    let mut theta_ddot_of_place_last = theta_ddot_of_place_1;
    let mut delta_ddot_of_beta_dot_last = delta_ddot_of_beta_dot_1;
    let mut delta_ddot_of_motion_last = delta_ddot_of_motion_1;
    let mut phi_ddot_of_place_last = phi_ddot_of_place_1;
    let mut epsilon_ddot_of_beta_dot_last = epsilon_ddot_of_beta_dot_1;
    let mut epsilon_ddot_of_motion_last = epsilon_ddot_of_motion_1;
    let mut omega_ddot_of_place_last = omega_ddot_of_place_1;
    let mut next = [S::int(0); 152];
    // Rates at order k - 1.
    let mut beta_rate_2 = beta_dot_1;
    let mut theta_rate = theta_dot_1;
    let mut gamma_rate = gamma_dot_1;
    let mut delta_rate = delta_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut epsilon_rate = epsilon_dot_1;
    let mut omega_rate = omega_dot_1;
    let mut beta_dot_rate = beta_dot_dot_1;
    let mut theta_dot_rate = theta_dot_dot_1;
    let mut gamma_dot_rate = gamma_dot_dot_1;
    let mut delta_dot_rate = delta_dot_dot_1;
    let mut phi_dot_rate = phi_dot_dot_1;
    let mut epsilon_dot_rate = epsilon_dot_dot_1;
    let mut omega_dot_rate = omega_dot_dot_1;
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
        let beta_dot = beta_dot_rate * over_k;
        let theta_dot = theta_dot_rate * over_k;
        let gamma_dot = gamma_dot_rate * over_k;
        let delta_dot = delta_dot_rate * over_k;
        let phi_dot = phi_dot_rate * over_k;
        let epsilon_dot = epsilon_dot_rate * over_k;
        let omega_dot = omega_dot_rate * over_k;
        series[order] = [
            beta, theta, gamma, delta, phi, epsilon, omega, beta_dot, theta_dot, gamma_dot,
            delta_dot, phi_dot, epsilon_dot, omega_dot,
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
                cos_angle_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_last.mul_add(sin_angle_cos_angle_inv_1, next[37]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_beta_minus_gamma_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[38]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_5_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_5_1, next[39]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        cos_beta_minus_gamma_last
                            .mul_add(beta_rate_dot_of_place_4_1, next[40]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_9_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_9_1, next[41]),
                    ),
                sin_theta_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        sin_theta_last.mul_add(sin_angle_cos_angle_inv_1, next[42]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_12_last,
                        cos_beta_minus_gamma_last
                            .mul_add(beta_rate_dot_of_place_12_1, next[43]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_11_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_11_1, next[44]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_16_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_16_1, next[45]),
                    ),
                cos_phi_1
                    .mul_add(
                        sin_phi_cos_phi_inv_last,
                        cos_phi_last.mul_add(sin_phi_cos_phi_inv_1, next[46]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        sin_phi_cos_phi_inv_last,
                        sin_angle_2_last.mul_add(sin_phi_cos_phi_inv_1, next[47]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_19_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_19_1, next[48]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_18_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_18_1, next[49]),
                    ),
                cos_phi_1
                    .mul_add(
                        beta_rate_dot_of_place_23_last,
                        cos_phi_last.mul_add(beta_rate_dot_of_place_23_1, next[50]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        sin_angle_2_last.mul_add(sin_angle_cos_angle_inv_1, next[51]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_26_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_26_1, next[52]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_4_1, next[53]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_29_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_29_1, next[54]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_4_last,
                        sin_angle_2_last.mul_add(d1_of_place_4_1, next[55]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_33_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_33_1, next[56]),
                    ),
                cos_theta_1
                    .mul_add(
                        sin_angle_2_last,
                        cos_theta_last.mul_add(sin_angle_2_1, next[57]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        sin_phi_cos_phi_inv_last,
                        cos_gamma_minus_delta_last
                            .mul_add(sin_phi_cos_phi_inv_1, next[58]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_36_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_36_1, next[59]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        cos_angle_2_last,
                        cos_gamma_minus_delta_last.mul_add(cos_angle_2_1, next[60]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_35_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_35_1, next[61]),
                    ),
                cos_phi_1
                    .mul_add(
                        beta_rate_dot_of_place_41_last,
                        cos_phi_last.mul_add(beta_rate_dot_of_place_41_1, next[62]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_gamma_minus_delta_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[63]),
                    ),
                cos_phi_1
                    .mul_add(
                        beta_rate_dot_of_place_43_last,
                        cos_phi_last.mul_add(beta_rate_dot_of_place_43_1, next[64]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_44_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_44_1, next[65]),
                    ),
                beta_rate_dot_of_place_46_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        beta_rate_dot_of_place_46_last
                            .mul_add(beta_rate_dot_of_place_4_1, next[66]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_48_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_48_1, next[67]),
                    ),
                beta_rate_dot_of_place_46_1
                    .mul_add(
                        d1_of_place_4_last,
                        beta_rate_dot_of_place_46_last.mul_add(d1_of_place_4_1, next[68]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_52_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_52_1, next[69]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_46_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_46_1, next[70]),
                    ),
                cos_omega_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        cos_omega_last.mul_add(sin_omega_cos_omega_inv_1, next[71]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        cos_angle_3_last.mul_add(sin_omega_cos_omega_inv_1, next[72]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_56_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_56_1, next[73]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_55_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_55_1, next[74]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_60_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_60_1, next[75]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_3_last.mul_add(sin_angle_cos_angle_inv_1, next[76]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_63_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_63_1, next[77]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_4_1, next[78]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_66_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_66_1, next[79]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        d1_of_place_4_last,
                        cos_angle_3_last.mul_add(d1_of_place_4_1, next[80]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_70_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_70_1, next[81]),
                    ),
                cos_theta_1
                    .mul_add(
                        cos_angle_3_last,
                        cos_theta_last.mul_add(cos_angle_3_1, next[82]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        sin_omega_cos_omega_inv_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(sin_omega_cos_omega_inv_1, next[83]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_73_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_73_1, next[84]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        sin_angle_3_last,
                        sin_gamma_minus_epsilon_last.mul_add(sin_angle_3_1, next[85]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_77_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_77_1, next[86]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[87]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_79_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_79_1, next[88]),
                    ),
                beta_rate_dot_of_place_72_1
                    .mul_add(
                        beta_rate_dot_of_place_79_last,
                        beta_rate_dot_of_place_72_last
                            .mul_add(beta_rate_dot_of_place_79_1, next[89]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_81_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_81_1, next[90]),
                    ),
                beta_rate_dot_of_place_83_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        beta_rate_dot_of_place_83_last
                            .mul_add(beta_rate_dot_of_place_4_1, next[91]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_85_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_85_1, next[92]),
                    ),
                beta_rate_dot_of_place_83_1
                    .mul_add(
                        d1_of_place_4_last,
                        beta_rate_dot_of_place_83_last.mul_add(d1_of_place_4_1, next[93]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_89_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_89_1, next[94]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_83_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_83_1, next[95]),
                    ),
                beta_rate_dot_of_place_2_1
                    .mul_add(
                        beta_rate_dot_of_place_3_last,
                        beta_rate_dot_of_place_2_last
                            .mul_add(beta_rate_dot_of_place_3_1, next[96]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_94_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_94_1, next[97]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_e_ea_zt_phi_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_e_ea_zt_phi_1, next[98]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_e_ea_zt_phi_2_last,
                        sin_angle_2_last
                            .mul_add(beta_rate_dot_of_e_ea_zt_phi_2_1, next[99]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_100_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_100_1, next[100]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_102_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_102_1, next[101]),
                    ),
                beta_rate_dot_of_place_1
                    .mul_add(
                        beta_rate_dot_of_place_106_last,
                        beta_rate_dot_of_place_last
                            .mul_add(beta_rate_dot_of_place_106_1, next[102]),
                    ),
                beta_rate_dot_of_place_93_1
                    .mul_add(
                        beta_rate_dot_of_place_106_last,
                        beta_rate_dot_of_place_93_last
                            .mul_add(beta_rate_dot_of_place_106_1, next[103]),
                    ),
                delta_dot_1
                    .mul_add(
                        beta_rate_dot_of_place_108_last,
                        delta_dot_last.mul_add(beta_rate_dot_of_place_108_1, next[104]),
                    ),
                phi_dot_1
                    .mul_add(
                        sin_angle_2_last,
                        phi_dot_last.mul_add(sin_angle_2_1, next[105]),
                    ),
                delta_dot_1
                    .mul_add(
                        beta_rate_dot_of_motion_last,
                        delta_dot_last.mul_add(beta_rate_dot_of_motion_1, next[106]),
                    ),
                phi_dot_1
                    .mul_add(
                        phi_dot_sin_angle_2_last,
                        phi_dot_last.mul_add(phi_dot_sin_angle_2_1, next[107]),
                    ),
                epsilon_dot_1
                    .mul_add(
                        beta_rate_dot_of_place_109_last,
                        epsilon_dot_last.mul_add(beta_rate_dot_of_place_109_1, next[108]),
                    ),
                omega_dot_1
                    .mul_add(
                        cos_angle_3_last,
                        omega_dot_last.mul_add(cos_angle_3_1, next[109]),
                    ),
                epsilon_dot_1
                    .mul_add(
                        beta_rate_dot_of_motion_3_last,
                        epsilon_dot_last.mul_add(beta_rate_dot_of_motion_3_1, next[110]),
                    ),
                omega_dot_1
                    .mul_add(
                        omega_dot_cos_angle_3_last,
                        omega_dot_last.mul_add(omega_dot_cos_angle_3_1, next[111]),
                    ),
                (beta_dot_1 + beta_dot_1).mul_add(beta_dot_last, next[112]),
                cos_beta_minus_gamma_1
                    .mul_add(
                        beta_dot_sq_last,
                        cos_beta_minus_gamma_last.mul_add(beta_dot_sq_1, next[113]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_motion_6_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_motion_6_1, next[114]),
                    ),
                beta_dot_1
                    .mul_add(
                        beta_rate_dot_of_motion_7_last,
                        beta_dot_last.mul_add(beta_rate_dot_of_motion_7_1, next[115]),
                    ),
                (theta_dot_1 + theta_dot_1).mul_add(theta_dot_last, next[116]),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_motion_9_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_motion_9_1, next[117]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_2_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_beta_dot_2_1, next[118]),
                    ),
                beta_rate_dot_of_place_10_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_2_last,
                        beta_rate_dot_of_place_10_last
                            .mul_add(beta_rate_dot_of_beta_dot_2_1, next[119]),
                    ),
                beta_rate_dot_of_place_95_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_3_last,
                        beta_rate_dot_of_place_95_last
                            .mul_add(beta_rate_dot_of_beta_dot_3_1, next[120]),
                    ),
                cos_angle_1
                    .mul_add(
                        sin_theta_cos_angle_inv_last,
                        cos_angle_last.mul_add(sin_theta_cos_angle_inv_1, next[121]),
                    ),
                beta_rate_dot_of_beta_dot_2_1
                    .mul_add(
                        sin_theta_cos_angle_inv_last,
                        beta_rate_dot_of_beta_dot_2_last
                            .mul_add(sin_theta_cos_angle_inv_1, next[122]),
                    ),
                beta_rate_dot_of_place_17_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_5_last,
                        beta_rate_dot_of_place_17_last
                            .mul_add(beta_rate_dot_of_beta_dot_5_1, next[123]),
                    ),
                cos_phi_sq_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_7_last,
                        cos_phi_sq_last.mul_add(beta_rate_dot_of_beta_dot_7_1, next[124]),
                    ),
                beta_rate_dot_of_place_98_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_7_last,
                        beta_rate_dot_of_place_98_last
                            .mul_add(beta_rate_dot_of_beta_dot_7_1, next[125]),
                    ),
                beta_rate_dot_of_place_34_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_8_last,
                        beta_rate_dot_of_place_34_last
                            .mul_add(beta_rate_dot_of_beta_dot_8_1, next[126]),
                    ),
                beta_rate_dot_of_place_99_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_7_last,
                        beta_rate_dot_of_place_99_last
                            .mul_add(beta_rate_dot_of_beta_dot_7_1, next[127]),
                    ),
                beta_rate_dot_of_place_54_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_10_last,
                        beta_rate_dot_of_place_54_last
                            .mul_add(beta_rate_dot_of_beta_dot_10_1, next[128]),
                    ),
                cos_omega_sq_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_12_last,
                        cos_omega_sq_last
                            .mul_add(beta_rate_dot_of_beta_dot_12_1, next[129]),
                    ),
                beta_rate_dot_of_place_104_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_12_last,
                        beta_rate_dot_of_place_104_last
                            .mul_add(beta_rate_dot_of_beta_dot_12_1, next[130]),
                    ),
                beta_rate_dot_of_place_71_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_13_last,
                        beta_rate_dot_of_place_71_last
                            .mul_add(beta_rate_dot_of_beta_dot_13_1, next[131]),
                    ),
                beta_rate_dot_of_place_105_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_12_last,
                        beta_rate_dot_of_place_105_last
                            .mul_add(beta_rate_dot_of_beta_dot_12_1, next[132]),
                    ),
                beta_rate_dot_of_place_91_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_15_last,
                        beta_rate_dot_of_place_91_last
                            .mul_add(beta_rate_dot_of_beta_dot_15_1, next[133]),
                    ),
                d1_of_place_19_1
                    .mul_add(
                        beta_dot_dot_last,
                        d1_of_place_19_last.mul_add(beta_dot_dot_1, next[134]),
                    ),
                beta_dot_dot_1
                    .mul_add(
                        theta_ddot_of_place_last,
                        beta_dot_dot_last.mul_add(theta_ddot_of_place_1, next[135]),
                    ),
                beta_rate_dot_of_place_17_1
                    .mul_add(
                        beta_rate_dot_of_beta_dot_2_last,
                        beta_rate_dot_of_place_17_last
                            .mul_add(beta_rate_dot_of_beta_dot_2_1, next[136]),
                    ),
                beta_dot_dot_1
                    .mul_add(
                        sin_theta_cos_angle_inv_last,
                        beta_dot_dot_last.mul_add(sin_theta_cos_angle_inv_1, next[137]),
                    ),
                cos_phi_1
                    .mul_add(
                        delta_ddot_of_beta_dot_last,
                        cos_phi_last.mul_add(delta_ddot_of_beta_dot_1, next[138]),
                    ),
                beta_rate_dot_of_place_34_1
                    .mul_add(
                        delta_ddot_of_beta_dot_last,
                        beta_rate_dot_of_place_34_last
                            .mul_add(delta_ddot_of_beta_dot_1, next[139]),
                    ),
                cos_phi_1
                    .mul_add(
                        delta_ddot_of_motion_last,
                        cos_phi_last.mul_add(delta_ddot_of_motion_1, next[140]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        delta_ddot_of_motion_last,
                        sin_angle_2_last.mul_add(delta_ddot_of_motion_1, next[141]),
                    ),
                beta_rate_dot_of_place_54_1
                    .mul_add(
                        delta_ddot_of_beta_dot_last,
                        beta_rate_dot_of_place_54_last
                            .mul_add(delta_ddot_of_beta_dot_1, next[142]),
                    ),
                phi_ddot_of_place_1
                    .mul_add(
                        delta_ddot_of_motion_last,
                        phi_ddot_of_place_last.mul_add(delta_ddot_of_motion_1, next[143]),
                    ),
                cos_omega_1
                    .mul_add(
                        epsilon_ddot_of_beta_dot_last,
                        cos_omega_last.mul_add(epsilon_ddot_of_beta_dot_1, next[144]),
                    ),
                beta_rate_dot_of_place_71_1
                    .mul_add(
                        epsilon_ddot_of_beta_dot_last,
                        beta_rate_dot_of_place_71_last
                            .mul_add(epsilon_ddot_of_beta_dot_1, next[145]),
                    ),
                cos_omega_1
                    .mul_add(
                        epsilon_ddot_of_motion_last,
                        cos_omega_last.mul_add(epsilon_ddot_of_motion_1, next[146]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        epsilon_ddot_of_motion_last,
                        cos_angle_3_last.mul_add(epsilon_ddot_of_motion_1, next[147]),
                    ),
                beta_rate_dot_of_place_91_1
                    .mul_add(
                        epsilon_ddot_of_beta_dot_last,
                        beta_rate_dot_of_place_91_last
                            .mul_add(epsilon_ddot_of_beta_dot_1, next[148]),
                    ),
                omega_ddot_of_place_1
                    .mul_add(
                        epsilon_ddot_of_motion_last,
                        omega_ddot_of_place_last
                            .mul_add(epsilon_ddot_of_motion_1, next[149]),
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
        // beta_rate_dot_of_place_3 = weight_13*sin_gamma + weight_14*cos_gamma
        let beta_rate_dot_of_place_3 = cos_gamma
            .mul_add(weight_14, weight_13 * sin_gamma);
        // sin_angle_cos_angle_inv = sin_angle/cos_angle
        let sin_angle_cos_angle_inv = cos_angle
            .mul_add(
                -(sin_angle_cos_angle_inv_0 * over_cos_angle),
                (sin_angle - sums[37]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_4 = cos_beta_minus_gamma*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_4 = sin_angle_cos_angle_inv
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(sin_angle_cos_angle_inv_0, sums[38]),
            );
        // beta_rate_dot_of_place_5 = sin_beta_minus_gamma - beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_5 = sin_beta_minus_gamma - beta_rate_dot_of_place_4;
        // beta_rate_dot_of_place_6 = sin_theta*beta_rate_dot_of_place_5
        let beta_rate_dot_of_place_6 = beta_rate_dot_of_place_5
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_5_0, sums[39]),
            );
        // beta_rate_dot_of_place_7 = cos_beta_minus_gamma*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_7 = beta_rate_dot_of_place_4
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(beta_rate_dot_of_place_4_0, sums[40]),
            );
        // beta_rate_dot_of_place_8 = weight_15*beta_rate_dot_of_place_6 +
        //   weight_16*beta_rate_dot_of_place_7
        let beta_rate_dot_of_place_8 = beta_rate_dot_of_place_6
            .mul_add(weight_15, weight_16 * beta_rate_dot_of_place_7);
        // beta_rate_dot_of_place_9 = beta_rate_dot_of_place_8/cos_angle
        let beta_rate_dot_of_place_9 = beta_rate_dot_of_place_8
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_9_0, sums[41]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_10 = sin_beta_minus_gamma + minus_rr*beta_rate_dot_of_place_9
        let beta_rate_dot_of_place_10 = beta_rate_dot_of_place_9
            .mul_add(minus_rr, sin_beta_minus_gamma);
        // beta_rate_dot_of_place_11 = sin_theta*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_11 = sin_angle_cos_angle_inv
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(sin_angle_cos_angle_inv_0, sums[42]),
            );
        // beta_rate_dot_of_place_12 = cos_theta + beta_rate_dot_of_place_11
        let beta_rate_dot_of_place_12 = cos_theta + beta_rate_dot_of_place_11;
        // beta_rate_dot_of_place_13 = cos_beta_minus_gamma*beta_rate_dot_of_place_12
        let beta_rate_dot_of_place_13 = beta_rate_dot_of_place_12
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(beta_rate_dot_of_place_12_0, sums[43]),
            );
        // beta_rate_dot_of_place_14 = sin_theta*beta_rate_dot_of_place_11
        let beta_rate_dot_of_place_14 = beta_rate_dot_of_place_11
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_11_0, sums[44]),
            );
        // beta_rate_dot_of_place_15 = weight_16*beta_rate_dot_of_place_13 +
        //   minus_1_by_ss*beta_rate_dot_of_place_14
        let beta_rate_dot_of_place_15 = beta_rate_dot_of_place_13
            .mul_add(weight_16, minus_1_by_ss * beta_rate_dot_of_place_14);
        // beta_rate_dot_of_place_16 = beta_rate_dot_of_place_15/cos_angle
        let beta_rate_dot_of_place_16 = beta_rate_dot_of_place_15
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_16_0, sums[45]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_17 = cos_theta + minus_rr*beta_rate_dot_of_place_16
        let beta_rate_dot_of_place_17 = beta_rate_dot_of_place_16
            .mul_add(minus_rr, cos_theta);
        // sin_phi_cos_phi_inv = sin_phi/cos_phi
        let sin_phi_cos_phi_inv = cos_phi
            .mul_add(
                -(sin_phi_cos_phi_inv_0 * over_cos_phi),
                (sin_phi - sums[46]) * over_cos_phi,
            );
        // beta_rate_dot_of_place_18 = sin_angle_2*sin_phi_cos_phi_inv
        let beta_rate_dot_of_place_18 = sin_phi_cos_phi_inv
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(sin_phi_cos_phi_inv_0, sums[47]),
            );
        // beta_rate_dot_of_place_19 = cos_angle_2 - beta_rate_dot_of_place_18
        let beta_rate_dot_of_place_19 = cos_angle_2 - beta_rate_dot_of_place_18;
        // beta_rate_dot_of_place_20 = cos_gamma_minus_delta*beta_rate_dot_of_place_19
        let beta_rate_dot_of_place_20 = beta_rate_dot_of_place_19
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_19_0, sums[48]),
            );
        // beta_rate_dot_of_place_21 = sin_angle_2*beta_rate_dot_of_place_18
        let beta_rate_dot_of_place_21 = beta_rate_dot_of_place_18
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_18_0, sums[49]),
            );
        // beta_rate_dot_of_place_22 = weight_17*beta_rate_dot_of_place_20 +
        //   weight_18*beta_rate_dot_of_place_21
        let beta_rate_dot_of_place_22 = beta_rate_dot_of_place_20
            .mul_add(weight_17, weight_18 * beta_rate_dot_of_place_21);
        // beta_rate_dot_of_place_23 = beta_rate_dot_of_place_22/cos_phi
        let beta_rate_dot_of_place_23 = beta_rate_dot_of_place_22
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(beta_rate_dot_of_place_23_0, sums[50]) * over_cos_phi),
            );
        // beta_rate_dot_of_place_24 = sin_angle_2*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_24 = sin_angle_cos_angle_inv
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(sin_angle_cos_angle_inv_0, sums[51]),
            );
        // beta_rate_dot_of_place_25 = cos_angle_2 - beta_rate_dot_of_place_24
        let beta_rate_dot_of_place_25 = cos_angle_2 - beta_rate_dot_of_place_24;
        // beta_rate_dot_of_place_26 = beta_rate_dot_of_place_23 + minus_1_by_ss*beta_rate_dot_of_place_25
        let beta_rate_dot_of_place_26 = minus_1_by_ss * beta_rate_dot_of_place_25
            + beta_rate_dot_of_place_23;
        // beta_rate_dot_of_place_27 = sin_theta*beta_rate_dot_of_place_26
        let beta_rate_dot_of_place_27 = beta_rate_dot_of_place_26
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_26_0, sums[52]),
            );
        // beta_rate_dot_of_place_28 = sin_angle_2*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_28 = beta_rate_dot_of_place_4
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_4_0, sums[53]),
            );
        // beta_rate_dot_of_place_29 = beta_rate_dot_of_place_27 + minus_1_by_d*beta_rate_dot_of_place_28
        let beta_rate_dot_of_place_29 = minus_1_by_d * beta_rate_dot_of_place_28
            + beta_rate_dot_of_place_27;
        // beta_rate_dot_of_place_30 = sin_theta*beta_rate_dot_of_place_29
        let beta_rate_dot_of_place_30 = beta_rate_dot_of_place_29
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_29_0, sums[54]),
            );
        // beta_rate_dot_of_place_31 = sin_angle_2*d1_of_place_4
        let beta_rate_dot_of_place_31 = d1_of_place_4
            .mul_add(sin_angle_2_0, sin_angle_2.mul_add(d1_of_place_4_0, sums[55]));
        // beta_rate_dot_of_place_32 = beta_rate_dot_of_place_30 + minus_1_by_d*beta_rate_dot_of_place_31
        let beta_rate_dot_of_place_32 = minus_1_by_d * beta_rate_dot_of_place_31
            + beta_rate_dot_of_place_30;
        // beta_rate_dot_of_place_33 = beta_rate_dot_of_place_32/cos_angle
        let beta_rate_dot_of_place_33 = beta_rate_dot_of_place_32
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_33_0, sums[56]) * over_cos_angle),
            );
        // cos_theta_sin_angle_2 = cos_theta*sin_angle_2
        let cos_theta_sin_angle_2 = sin_angle_2
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_angle_2_0, sums[57]));
        // beta_rate_dot_of_place_34 = rr*beta_rate_dot_of_place_33 + cos_theta_sin_angle_2
        let beta_rate_dot_of_place_34 = beta_rate_dot_of_place_33
            .mul_add(rr, cos_theta_sin_angle_2);
        // beta_rate_dot_of_place_35 = cos_gamma_minus_delta*sin_phi_cos_phi_inv
        let beta_rate_dot_of_place_35 = sin_phi_cos_phi_inv
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(sin_phi_cos_phi_inv_0, sums[58]),
            );
        // beta_rate_dot_of_place_36 = sin_gamma_minus_delta - 2*beta_rate_dot_of_place_35
        let beta_rate_dot_of_place_36 = beta_rate_dot_of_place_35
            .mul_add(-S::int(2), sin_gamma_minus_delta);
        // beta_rate_dot_of_place_37 = sin_angle_2*beta_rate_dot_of_place_36
        let beta_rate_dot_of_place_37 = beta_rate_dot_of_place_36
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_36_0, sums[59]),
            );
        // beta_rate_dot_of_place_38 = cos_gamma_minus_delta*cos_angle_2
        let beta_rate_dot_of_place_38 = cos_angle_2
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(cos_angle_2_0, sums[60]),
            );
        // beta_rate_dot_of_place_39 = cos_gamma_minus_delta*beta_rate_dot_of_place_35
        let beta_rate_dot_of_place_39 = beta_rate_dot_of_place_35
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_35_0, sums[61]),
            );
        // beta_rate_dot_of_place_40 = weight_18*beta_rate_dot_of_place_37 +
        //   weight_18*beta_rate_dot_of_place_38 + weight_17*beta_rate_dot_of_place_39
        let beta_rate_dot_of_place_40 = beta_rate_dot_of_place_37
            .mul_add(
                weight_18,
                beta_rate_dot_of_place_39
                    .mul_add(weight_17, weight_18 * beta_rate_dot_of_place_38),
            );
        // beta_rate_dot_of_place_41 = beta_rate_dot_of_place_40/cos_phi
        let beta_rate_dot_of_place_41 = beta_rate_dot_of_place_40
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(beta_rate_dot_of_place_41_0, sums[62]) * over_cos_phi),
            );
        // beta_rate_dot_of_place_42 = cos_gamma_minus_delta*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_42 = sin_angle_cos_angle_inv
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(sin_angle_cos_angle_inv_0, sums[63]),
            );
        // beta_rate_dot_of_place_43 = beta_rate_dot_of_place_21/cos_phi
        let beta_rate_dot_of_place_43 = beta_rate_dot_of_place_21
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(beta_rate_dot_of_place_43_0, sums[64]) * over_cos_phi),
            );
        // beta_rate_dot_of_place_44 = weight_17*beta_rate_dot_of_place_41 +
        //   minus_1_by_e_ss*sin_gamma_minus_delta + minus_1_by_e_ss*beta_rate_dot_of_place_42 +
        //   minus_1_by_ss_zt*beta_rate_dot_of_place_25 + weight_19*beta_rate_dot_of_place_43
        let beta_rate_dot_of_place_44 = beta_rate_dot_of_place_41
            .mul_add(
                weight_17,
                beta_rate_dot_of_place_43
                    .mul_add(
                        weight_19,
                        beta_rate_dot_of_place_25
                            .mul_add(
                                minus_1_by_ss_zt,
                                beta_rate_dot_of_place_42
                                    .mul_add(
                                        minus_1_by_e_ss,
                                        minus_1_by_e_ss * sin_gamma_minus_delta,
                                    ),
                            ),
                    ),
            );
        // beta_rate_dot_of_place_45 = sin_theta*beta_rate_dot_of_place_44
        let beta_rate_dot_of_place_45 = beta_rate_dot_of_place_44
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_44_0, sums[65]),
            );
        // beta_rate_dot_of_place_46 = weight_17*cos_gamma_minus_delta + minus_1_by_zt*sin_angle_2
        let beta_rate_dot_of_place_46 = sin_angle_2
            .mul_add(minus_1_by_zt, weight_17 * cos_gamma_minus_delta);
        // beta_rate_dot_of_place_47 = beta_rate_dot_of_place_46*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_47 = beta_rate_dot_of_place_4
            .mul_add(
                beta_rate_dot_of_place_46_0,
                beta_rate_dot_of_place_46.mul_add(beta_rate_dot_of_place_4_0, sums[66]),
            );
        // beta_rate_dot_of_place_48 = beta_rate_dot_of_place_45 + weight_16*beta_rate_dot_of_place_47
        let beta_rate_dot_of_place_48 = weight_16 * beta_rate_dot_of_place_47
            + beta_rate_dot_of_place_45;
        // beta_rate_dot_of_place_49 = sin_theta*beta_rate_dot_of_place_48
        let beta_rate_dot_of_place_49 = beta_rate_dot_of_place_48
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_48_0, sums[67]),
            );
        // beta_rate_dot_of_place_50 = beta_rate_dot_of_place_46*d1_of_place_4
        let beta_rate_dot_of_place_50 = d1_of_place_4
            .mul_add(
                beta_rate_dot_of_place_46_0,
                beta_rate_dot_of_place_46.mul_add(d1_of_place_4_0, sums[68]),
            );
        // beta_rate_dot_of_place_51 = beta_rate_dot_of_place_49 + weight_16*beta_rate_dot_of_place_50
        let beta_rate_dot_of_place_51 = weight_16 * beta_rate_dot_of_place_50
            + beta_rate_dot_of_place_49;
        // beta_rate_dot_of_place_52 = beta_rate_dot_of_place_51/cos_angle
        let beta_rate_dot_of_place_52 = beta_rate_dot_of_place_51
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_52_0, sums[69]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_53 = cos_theta*beta_rate_dot_of_place_46
        let beta_rate_dot_of_place_53 = beta_rate_dot_of_place_46
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_46_0, sums[70]),
            );
        // beta_rate_dot_of_place_54 = rr*beta_rate_dot_of_place_52 - beta_rate_dot_of_place_53
        let beta_rate_dot_of_place_54 = beta_rate_dot_of_place_52
            .mul_add(rr, -beta_rate_dot_of_place_53);
        // sin_omega_cos_omega_inv = sin_omega/cos_omega
        let sin_omega_cos_omega_inv = cos_omega
            .mul_add(
                -(sin_omega_cos_omega_inv_0 * over_cos_omega),
                (sin_omega - sums[71]) * over_cos_omega,
            );
        // beta_rate_dot_of_place_55 = cos_angle_3*sin_omega_cos_omega_inv
        let beta_rate_dot_of_place_55 = sin_omega_cos_omega_inv
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(sin_omega_cos_omega_inv_0, sums[72]),
            );
        // beta_rate_dot_of_place_56 = sin_angle_3 + beta_rate_dot_of_place_55
        let beta_rate_dot_of_place_56 = sin_angle_3 + beta_rate_dot_of_place_55;
        // beta_rate_dot_of_place_57 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_56
        let beta_rate_dot_of_place_57 = beta_rate_dot_of_place_56
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_56_0, sums[73]),
            );
        // beta_rate_dot_of_place_58 = cos_angle_3*beta_rate_dot_of_place_55
        let beta_rate_dot_of_place_58 = beta_rate_dot_of_place_55
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_55_0, sums[74]),
            );
        // beta_rate_dot_of_place_59 = weight_20*beta_rate_dot_of_place_57 +
        //   minus_1_by_u*beta_rate_dot_of_place_58
        let beta_rate_dot_of_place_59 = beta_rate_dot_of_place_57
            .mul_add(weight_20, minus_1_by_u * beta_rate_dot_of_place_58);
        // beta_rate_dot_of_place_60 = beta_rate_dot_of_place_59/cos_omega
        let beta_rate_dot_of_place_60 = beta_rate_dot_of_place_59
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_60_0, sums[75]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_61 = cos_angle_3*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_61 = sin_angle_cos_angle_inv
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(sin_angle_cos_angle_inv_0, sums[76]),
            );
        // beta_rate_dot_of_place_62 = sin_angle_3 + beta_rate_dot_of_place_61
        let beta_rate_dot_of_place_62 = sin_angle_3 + beta_rate_dot_of_place_61;
        // beta_rate_dot_of_place_63 = beta_rate_dot_of_place_60 + minus_1_by_ss*beta_rate_dot_of_place_62
        let beta_rate_dot_of_place_63 = minus_1_by_ss * beta_rate_dot_of_place_62
            + beta_rate_dot_of_place_60;
        // beta_rate_dot_of_place_64 = sin_theta*beta_rate_dot_of_place_63
        let beta_rate_dot_of_place_64 = beta_rate_dot_of_place_63
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_63_0, sums[77]),
            );
        // beta_rate_dot_of_place_65 = cos_angle_3*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_65 = beta_rate_dot_of_place_4
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_4_0, sums[78]),
            );
        // beta_rate_dot_of_place_66 = beta_rate_dot_of_place_64 + weight_16*beta_rate_dot_of_place_65
        let beta_rate_dot_of_place_66 = weight_16 * beta_rate_dot_of_place_65
            + beta_rate_dot_of_place_64;
        // beta_rate_dot_of_place_67 = sin_theta*beta_rate_dot_of_place_66
        let beta_rate_dot_of_place_67 = beta_rate_dot_of_place_66
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_66_0, sums[79]),
            );
        // beta_rate_dot_of_place_68 = cos_angle_3*d1_of_place_4
        let beta_rate_dot_of_place_68 = d1_of_place_4
            .mul_add(cos_angle_3_0, cos_angle_3.mul_add(d1_of_place_4_0, sums[80]));
        // beta_rate_dot_of_place_69 = beta_rate_dot_of_place_67 + weight_16*beta_rate_dot_of_place_68
        let beta_rate_dot_of_place_69 = weight_16 * beta_rate_dot_of_place_68
            + beta_rate_dot_of_place_67;
        // beta_rate_dot_of_place_70 = beta_rate_dot_of_place_69/cos_angle
        let beta_rate_dot_of_place_70 = beta_rate_dot_of_place_69
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_70_0, sums[81]) * over_cos_angle),
            );
        // cos_theta_cos_angle_3 = cos_theta*cos_angle_3
        let cos_theta_cos_angle_3 = cos_angle_3
            .mul_add(cos_theta_0, cos_theta.mul_add(cos_angle_3_0, sums[82]));
        // beta_rate_dot_of_place_71 = rr*beta_rate_dot_of_place_70 - cos_theta_cos_angle_3
        let beta_rate_dot_of_place_71 = beta_rate_dot_of_place_70
            .mul_add(rr, -cos_theta_cos_angle_3);
        // beta_rate_dot_of_place_72 = sin_gamma_minus_epsilon*sin_omega_cos_omega_inv
        let beta_rate_dot_of_place_72 = sin_omega_cos_omega_inv
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(sin_omega_cos_omega_inv_0, sums[83]),
            );
        // beta_rate_dot_of_place_73 = cos_gamma_minus_epsilon + 2*beta_rate_dot_of_place_72
        let beta_rate_dot_of_place_73 = beta_rate_dot_of_place_72
            .mul_add(S::int(2), cos_gamma_minus_epsilon);
        // beta_rate_dot_of_place_74 = cos_angle_3*beta_rate_dot_of_place_73
        let beta_rate_dot_of_place_74 = beta_rate_dot_of_place_73
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_73_0, sums[84]),
            );
        // beta_rate_dot_of_place_75 = sin_gamma_minus_epsilon*sin_angle_3
        let beta_rate_dot_of_place_75 = sin_angle_3
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(sin_angle_3_0, sums[85]),
            );
        // beta_rate_dot_of_place_76 = weight_21*beta_rate_dot_of_place_58 +
        //   minus_1_by_zf*beta_rate_dot_of_place_74 + minus_1_by_zf*beta_rate_dot_of_place_75
        let beta_rate_dot_of_place_76 = beta_rate_dot_of_place_74
            .mul_add(
                minus_1_by_zf,
                beta_rate_dot_of_place_58
                    .mul_add(weight_21, minus_1_by_zf * beta_rate_dot_of_place_75),
            );
        // beta_rate_dot_of_place_77 = beta_rate_dot_of_place_76/cos_omega
        let beta_rate_dot_of_place_77 = beta_rate_dot_of_place_76
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_77_0, sums[86]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_78 = sin_gamma_minus_epsilon*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_78 = sin_angle_cos_angle_inv
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(sin_angle_cos_angle_inv_0, sums[87]),
            );
        // beta_rate_dot_of_place_79 = sin_gamma_minus_epsilon/cos_omega
        let beta_rate_dot_of_place_79 = sin_gamma_minus_epsilon
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_79_0, sums[88]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_80 = beta_rate_dot_of_place_72*beta_rate_dot_of_place_79
        let beta_rate_dot_of_place_80 = beta_rate_dot_of_place_72
            .mul_add(
                beta_rate_dot_of_place_79_0,
                beta_rate_dot_of_place_79.mul_add(beta_rate_dot_of_place_72_0, sums[89]),
            );
        // beta_rate_dot_of_place_81 = weight_22*beta_rate_dot_of_place_62 +
        //   weight_21*beta_rate_dot_of_place_77 + weight_23*cos_gamma_minus_epsilon +
        //   minus_1_by_ss_zf*beta_rate_dot_of_place_78 + weight_24*beta_rate_dot_of_place_80
        let beta_rate_dot_of_place_81 = beta_rate_dot_of_place_77
            .mul_add(
                weight_21,
                beta_rate_dot_of_place_80
                    .mul_add(
                        weight_24,
                        beta_rate_dot_of_place_62
                            .mul_add(
                                weight_22,
                                beta_rate_dot_of_place_78
                                    .mul_add(
                                        minus_1_by_ss_zf,
                                        weight_23 * cos_gamma_minus_epsilon,
                                    ),
                            ),
                    ),
            );
        // beta_rate_dot_of_place_82 = sin_theta*beta_rate_dot_of_place_81
        let beta_rate_dot_of_place_82 = beta_rate_dot_of_place_81
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_81_0, sums[90]),
            );
        // beta_rate_dot_of_place_83 = weight_20*sin_gamma_minus_epsilon + minus_1_by_u*cos_angle_3
        let beta_rate_dot_of_place_83 = cos_angle_3
            .mul_add(minus_1_by_u, weight_20 * sin_gamma_minus_epsilon);
        // beta_rate_dot_of_place_84 = beta_rate_dot_of_place_83*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_84 = beta_rate_dot_of_place_4
            .mul_add(
                beta_rate_dot_of_place_83_0,
                beta_rate_dot_of_place_83.mul_add(beta_rate_dot_of_place_4_0, sums[91]),
            );
        // beta_rate_dot_of_place_85 = beta_rate_dot_of_place_82 + weight_16*beta_rate_dot_of_place_84
        let beta_rate_dot_of_place_85 = weight_16 * beta_rate_dot_of_place_84
            + beta_rate_dot_of_place_82;
        // beta_rate_dot_of_place_86 = sin_theta*beta_rate_dot_of_place_85
        let beta_rate_dot_of_place_86 = beta_rate_dot_of_place_85
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_85_0, sums[92]),
            );
        // beta_rate_dot_of_place_87 = beta_rate_dot_of_place_83*d1_of_place_4
        let beta_rate_dot_of_place_87 = d1_of_place_4
            .mul_add(
                beta_rate_dot_of_place_83_0,
                beta_rate_dot_of_place_83.mul_add(d1_of_place_4_0, sums[93]),
            );
        // beta_rate_dot_of_place_88 = beta_rate_dot_of_place_86 + weight_16*beta_rate_dot_of_place_87
        let beta_rate_dot_of_place_88 = weight_16 * beta_rate_dot_of_place_87
            + beta_rate_dot_of_place_86;
        // beta_rate_dot_of_place_89 = beta_rate_dot_of_place_88/cos_angle
        let beta_rate_dot_of_place_89 = beta_rate_dot_of_place_88
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_89_0, sums[94]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_90 = cos_theta*beta_rate_dot_of_place_83
        let beta_rate_dot_of_place_90 = beta_rate_dot_of_place_83
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_83_0, sums[95]),
            );
        // beta_rate_dot_of_place_91 = rr*beta_rate_dot_of_place_89 - beta_rate_dot_of_place_90
        let beta_rate_dot_of_place_91 = beta_rate_dot_of_place_89
            .mul_add(rr, -beta_rate_dot_of_place_90);
        // beta_rate_dot_of_place_92 = beta_rate_dot_of_place_2*beta_rate_dot_of_place_3
        let beta_rate_dot_of_place_92 = beta_rate_dot_of_place_2
            .mul_add(
                beta_rate_dot_of_place_3_0,
                beta_rate_dot_of_place_3.mul_add(beta_rate_dot_of_place_2_0, sums[96]),
            );
        // beta_rate_dot_of_place_93 = l0*beta_rate_dot_of_place_3 - beta_rate_dot_of_place_92
        let beta_rate_dot_of_place_93 = l0 * beta_rate_dot_of_place_3 - beta_rate_dot_of_place_92;
        // beta_rate_dot_of_place_94 = cos_beta_minus_gamma/cos_angle
        let beta_rate_dot_of_place_94 = cos_angle
            .mul_add(
                -(beta_rate_dot_of_place_94_0 * over_cos_angle),
                (cos_beta_minus_gamma - sums[97]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_95 = weight_25*beta_rate_dot_of_place_94 + minus_m2_da*cos_theta
        let beta_rate_dot_of_place_95 = beta_rate_dot_of_place_94
            .mul_add(weight_25, minus_m2_da * cos_theta);
        // beta_rate_dot_of_e_ea_zt_phi = weight_26 + zt_minus_ea_zt_by_e*sin_phi
        let beta_rate_dot_of_e_ea_zt_phi = zt_minus_ea_zt_by_e * sin_phi;
        // beta_rate_dot_of_place_96 = cos_gamma_minus_delta*beta_rate_dot_of_e_ea_zt_phi
        let beta_rate_dot_of_place_96 = beta_rate_dot_of_e_ea_zt_phi
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_e_ea_zt_phi_0, sums[98]),
            );
        // beta_rate_dot_of_e_ea_zt_phi_2 = zt + e_minus_ea*sin_phi
        let beta_rate_dot_of_e_ea_zt_phi_2 = e_minus_ea * sin_phi;
        // beta_rate_dot_of_place_97 = sin_angle_2*beta_rate_dot_of_e_ea_zt_phi_2
        let beta_rate_dot_of_place_97 = beta_rate_dot_of_e_ea_zt_phi_2
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_e_ea_zt_phi_2_0, sums[99]),
            );
        // beta_rate_dot_of_place_98 = m4*beta_rate_dot_of_place_96 + m4*beta_rate_dot_of_place_97 +
        //   weight_27*sin_angle_2 + i4_by_e*cos_gamma_minus_delta
        let beta_rate_dot_of_place_98 = beta_rate_dot_of_place_97
            .mul_add(
                m4,
                beta_rate_dot_of_place_96
                    .mul_add(
                        m4,
                        cos_gamma_minus_delta.mul_add(i4_by_e, weight_27 * sin_angle_2),
                    ),
            );
        // beta_rate_dot_of_place_99 = weight_28*cos_gamma_minus_delta + m4_e_minus_ea*sin_phi_sin_angle_2
        let beta_rate_dot_of_place_99 = sin_phi_sin_angle_2
            .mul_add(m4_e_minus_ea, weight_28 * cos_gamma_minus_delta);
        // beta_rate_dot_of_place_100 = weight_29 + u_fa_by_zf_minus_u*sin_omega
        let beta_rate_dot_of_place_100 = u_fa_by_zf_minus_u * sin_omega;
        // beta_rate_dot_of_place_101 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_100
        let beta_rate_dot_of_place_101 = beta_rate_dot_of_place_100
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_100_0, sums[100]),
            );
        // beta_rate_dot_of_place_102 = u + fa_minus_zf*sin_omega
        let beta_rate_dot_of_place_102 = fa_minus_zf * sin_omega;
        // beta_rate_dot_of_place_103 = cos_angle_3*beta_rate_dot_of_place_102
        let beta_rate_dot_of_place_103 = beta_rate_dot_of_place_102
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_102_0, sums[101]),
            );
        // beta_rate_dot_of_place_104 = m6*beta_rate_dot_of_place_101 + m6*beta_rate_dot_of_place_103 +
        //   weight_30*cos_angle_3 + i6_by_zf*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_104 = beta_rate_dot_of_place_103
            .mul_add(
                m6,
                beta_rate_dot_of_place_101
                    .mul_add(
                        m6,
                        sin_gamma_minus_epsilon
                            .mul_add(i6_by_zf, weight_30 * cos_angle_3),
                    ),
            );
        // beta_rate_dot_of_place_105 = weight_31*sin_gamma_minus_epsilon +
        //   m6_fa_minus_zf*sin_omega_cos_angle_3
        let beta_rate_dot_of_place_105 = sin_omega_cos_angle_3
            .mul_add(m6_fa_minus_zf, weight_31 * sin_gamma_minus_epsilon);
        // beta_rate_dot_of_place_106 = beta_rate_dot_of_place_2/beta_rate_dot_of_place
        let beta_rate_dot_of_place_106 = beta_rate_dot_of_place_2
            .mul_add(
                over_beta_rate_dot_of_place,
                -(beta_rate_dot_of_place.mul_add(beta_rate_dot_of_place_106_0, sums[102])
                    * over_beta_rate_dot_of_place),
            );
        // beta_rate_dot_of_place_107 = beta_rate_dot_of_place_93*beta_rate_dot_of_place_106
        let beta_rate_dot_of_place_107 = beta_rate_dot_of_place_93
            .mul_add(
                beta_rate_dot_of_place_106_0,
                beta_rate_dot_of_place_106
                    .mul_add(beta_rate_dot_of_place_93_0, sums[103]),
            );
        // beta_rate_dot_of_place_108 = e_minus_ea*sin_angle_2 + ea_zt_by_e_minus_zt*cos_gamma_minus_delta
        let beta_rate_dot_of_place_108 = cos_gamma_minus_delta
            .mul_add(ea_zt_by_e_minus_zt, e_minus_ea * sin_angle_2);
        // beta_rate_dot_of_delta_dot = delta_dot*beta_rate_dot_of_place_108
        let beta_rate_dot_of_delta_dot = beta_rate_dot_of_place_108
            .mul_add(
                delta_dot_0,
                delta_dot.mul_add(beta_rate_dot_of_place_108_0, sums[104]),
            );
        // phi_dot_sin_angle_2 = phi_dot*sin_angle_2
        let phi_dot_sin_angle_2 = sin_angle_2
            .mul_add(phi_dot_0, phi_dot.mul_add(sin_angle_2_0, sums[105]));
        // beta_rate_dot_of_motion = beta_rate_dot_of_delta_dot + weight_32*phi_dot_sin_angle_2
        let beta_rate_dot_of_motion = weight_32 * phi_dot_sin_angle_2 + beta_rate_dot_of_delta_dot;
        // beta_rate_dot_of_motion_2 = delta_dot*beta_rate_dot_of_motion
        let beta_rate_dot_of_motion_2 = beta_rate_dot_of_motion
            .mul_add(
                delta_dot_0,
                delta_dot.mul_add(beta_rate_dot_of_motion_0, sums[106]),
            );
        // phi_dot_sq_sin_angle_2 = phi_dot*phi_dot_sin_angle_2
        let phi_dot_sq_sin_angle_2 = phi_dot_sin_angle_2
            .mul_add(phi_dot_0, phi_dot.mul_add(phi_dot_sin_angle_2_0, sums[107]));
        // beta_rate_dot_of_place_109 = u_fa_by_zf_minus_1*sin_gamma_minus_epsilon +
        //   zf_minus_fa*cos_angle_3
        let beta_rate_dot_of_place_109 = cos_angle_3
            .mul_add(zf_minus_fa, u_fa_by_zf_minus_1 * sin_gamma_minus_epsilon);
        // beta_rate_dot_of_epsilon_dot = epsilon_dot*beta_rate_dot_of_place_109
        let beta_rate_dot_of_epsilon_dot = beta_rate_dot_of_place_109
            .mul_add(
                epsilon_dot_0,
                epsilon_dot.mul_add(beta_rate_dot_of_place_109_0, sums[108]),
            );
        // omega_dot_cos_angle_3 = omega_dot*cos_angle_3
        let omega_dot_cos_angle_3 = cos_angle_3
            .mul_add(omega_dot_0, omega_dot.mul_add(cos_angle_3_0, sums[109]));
        // beta_rate_dot_of_motion_3 = beta_rate_dot_of_epsilon_dot + weight_33*omega_dot_cos_angle_3
        let beta_rate_dot_of_motion_3 = weight_33 * omega_dot_cos_angle_3
            + beta_rate_dot_of_epsilon_dot;
        // beta_rate_dot_of_motion_4 = epsilon_dot*beta_rate_dot_of_motion_3
        let beta_rate_dot_of_motion_4 = beta_rate_dot_of_motion_3
            .mul_add(
                epsilon_dot_0,
                epsilon_dot.mul_add(beta_rate_dot_of_motion_3_0, sums[110]),
            );
        // omega_dot_sq_cos_angle_3 = omega_dot*omega_dot_cos_angle_3
        let omega_dot_sq_cos_angle_3 = omega_dot_cos_angle_3
            .mul_add(omega_dot_0, omega_dot.mul_add(omega_dot_cos_angle_3_0, sums[111]));
        // beta_dot_sq = beta_dot*beta_dot
        let beta_dot_sq = beta_dot.mul_add(beta_dot_0 + beta_dot_0, sums[112]);
        // beta_rate_dot_of_beta_dot = cos_beta_minus_gamma*beta_dot_sq
        let beta_rate_dot_of_beta_dot = cos_beta_minus_gamma
            .mul_add(
                beta_dot_sq_0,
                beta_dot_sq.mul_add(cos_beta_minus_gamma_0, sums[113]),
            );
        // beta_rate_dot_of_motion_5 = c0_by_ss*beta_rate_dot_of_place_107 +
        //   minus_m4*beta_rate_dot_of_motion_2 + m4_ea_minus_e*phi_dot_sq_sin_angle_2 +
        //   m6*beta_rate_dot_of_motion_4 + m6_zf_minus_fa*omega_dot_sq_cos_angle_3 +
        //   m2_da_rr_by_d*beta_rate_dot_of_beta_dot
        let beta_rate_dot_of_motion_5 = beta_rate_dot_of_place_107
            .mul_add(
                c0_by_ss,
                beta_rate_dot_of_motion_4
                    .mul_add(
                        m6,
                        beta_rate_dot_of_motion_2
                            .mul_add(
                                minus_m4,
                                omega_dot_sq_cos_angle_3
                                    .mul_add(
                                        m6_zf_minus_fa,
                                        phi_dot_sq_sin_angle_2
                                            .mul_add(
                                                m4_ea_minus_e,
                                                m2_da_rr_by_d * beta_rate_dot_of_beta_dot,
                                            ),
                                    ),
                            ),
                    ),
            );
        // beta_rate_dot_of_motion_6 = beta_rate_dot_of_motion_5/cos_angle
        let beta_rate_dot_of_motion_6 = beta_rate_dot_of_motion_5
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_motion_6_0, sums[114]) * over_cos_angle),
            );
        // beta_rate_dot_of_motion_7 = beta_dot + 2*theta_dot
        let beta_rate_dot_of_motion_7 = theta_dot.mul_add(S::int(2), beta_dot);
        // beta_rate_dot_of_motion_8 = beta_dot*beta_rate_dot_of_motion_7
        let beta_rate_dot_of_motion_8 = beta_rate_dot_of_motion_7
            .mul_add(
                beta_dot_0,
                beta_dot.mul_add(beta_rate_dot_of_motion_7_0, sums[115]),
            );
        // theta_dot_sq = theta_dot*theta_dot
        let theta_dot_sq = theta_dot.mul_add(theta_dot_0 + theta_dot_0, sums[116]);
        // beta_rate_dot_of_motion_9 = beta_rate_dot_of_motion_6 + minus_m2_da*beta_rate_dot_of_motion_8 +
        //   minus_m2_da*theta_dot_sq
        let beta_rate_dot_of_motion_9 = beta_rate_dot_of_motion_8
            .mul_add(minus_m2_da, minus_m2_da * theta_dot_sq) + beta_rate_dot_of_motion_6;
        // beta_rate_dot_of_motion_10 = sin_theta*beta_rate_dot_of_motion_9
        let beta_rate_dot_of_motion_10 = beta_rate_dot_of_motion_9
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_motion_9_0, sums[117]),
            );
        // beta_rate_dot_of_beta_dot_2 = beta_dot_sq/cos_angle
        let beta_rate_dot_of_beta_dot_2 = cos_angle
            .mul_add(
                -(beta_rate_dot_of_beta_dot_2_0 * over_cos_angle),
                (beta_dot_sq - sums[118]) * over_cos_angle,
            );
        // beta_rate_dot_of_beta_dot_3 = beta_rate_dot_of_place_10*beta_rate_dot_of_beta_dot_2
        let beta_rate_dot_of_beta_dot_3 = beta_rate_dot_of_place_10
            .mul_add(
                beta_rate_dot_of_beta_dot_2_0,
                beta_rate_dot_of_beta_dot_2
                    .mul_add(beta_rate_dot_of_place_10_0, sums[119]),
            );
        // beta_rate_dot_of_beta_dot_4 = beta_rate_dot_of_place_95*beta_rate_dot_of_beta_dot_3
        let beta_rate_dot_of_beta_dot_4 = beta_rate_dot_of_beta_dot_3
            .mul_add(
                beta_rate_dot_of_place_95_0,
                beta_rate_dot_of_place_95
                    .mul_add(beta_rate_dot_of_beta_dot_3_0, sums[120]),
            );
        // sin_theta_cos_angle_inv = sin_theta/cos_angle
        let sin_theta_cos_angle_inv = cos_angle
            .mul_add(
                -(sin_theta_cos_angle_inv_0 * over_cos_angle),
                (sin_theta - sums[121]) * over_cos_angle,
            );
        // beta_rate_dot_of_beta_dot_5 = beta_rate_dot_of_beta_dot_2*sin_theta_cos_angle_inv
        let beta_rate_dot_of_beta_dot_5 = sin_theta_cos_angle_inv
            .mul_add(
                beta_rate_dot_of_beta_dot_2_0,
                beta_rate_dot_of_beta_dot_2.mul_add(sin_theta_cos_angle_inv_0, sums[122]),
            );
        // beta_rate_dot_of_beta_dot_6 = beta_rate_dot_of_place_17*beta_rate_dot_of_beta_dot_5
        let beta_rate_dot_of_beta_dot_6 = beta_rate_dot_of_place_17
            .mul_add(
                beta_rate_dot_of_beta_dot_5_0,
                beta_rate_dot_of_beta_dot_5
                    .mul_add(beta_rate_dot_of_place_17_0, sums[123]),
            );
        // beta_rate_dot_of_beta_dot_7 = beta_rate_dot_of_beta_dot_5/cos_phi_sq
        let beta_rate_dot_of_beta_dot_7 = beta_rate_dot_of_beta_dot_5
            .mul_add(
                over_cos_phi_sq,
                -(cos_phi_sq.mul_add(beta_rate_dot_of_beta_dot_7_0, sums[124]) * over_cos_phi_sq),
            );
        // beta_rate_dot_of_beta_dot_8 = beta_rate_dot_of_place_98*beta_rate_dot_of_beta_dot_7
        let beta_rate_dot_of_beta_dot_8 = beta_rate_dot_of_beta_dot_7
            .mul_add(
                beta_rate_dot_of_place_98_0,
                beta_rate_dot_of_place_98
                    .mul_add(beta_rate_dot_of_beta_dot_7_0, sums[125]),
            );
        // beta_rate_dot_of_beta_dot_9 = beta_rate_dot_of_place_34*beta_rate_dot_of_beta_dot_8
        let beta_rate_dot_of_beta_dot_9 = beta_rate_dot_of_place_34
            .mul_add(
                beta_rate_dot_of_beta_dot_8_0,
                beta_rate_dot_of_beta_dot_8
                    .mul_add(beta_rate_dot_of_place_34_0, sums[126]),
            );
        // beta_rate_dot_of_beta_dot_10 = beta_rate_dot_of_place_99*beta_rate_dot_of_beta_dot_7
        let beta_rate_dot_of_beta_dot_10 = beta_rate_dot_of_beta_dot_7
            .mul_add(
                beta_rate_dot_of_place_99_0,
                beta_rate_dot_of_place_99
                    .mul_add(beta_rate_dot_of_beta_dot_7_0, sums[127]),
            );
        // beta_rate_dot_of_beta_dot_11 = beta_rate_dot_of_place_54*beta_rate_dot_of_beta_dot_10
        let beta_rate_dot_of_beta_dot_11 = beta_rate_dot_of_place_54
            .mul_add(
                beta_rate_dot_of_beta_dot_10_0,
                beta_rate_dot_of_beta_dot_10
                    .mul_add(beta_rate_dot_of_place_54_0, sums[128]),
            );
        // beta_rate_dot_of_beta_dot_12 = beta_rate_dot_of_beta_dot_5/cos_omega_sq
        let beta_rate_dot_of_beta_dot_12 = beta_rate_dot_of_beta_dot_5
            .mul_add(
                over_cos_omega_sq,
                -(cos_omega_sq.mul_add(beta_rate_dot_of_beta_dot_12_0, sums[129])
                    * over_cos_omega_sq),
            );
        // beta_rate_dot_of_beta_dot_13 = beta_rate_dot_of_place_104*beta_rate_dot_of_beta_dot_12
        let beta_rate_dot_of_beta_dot_13 = beta_rate_dot_of_beta_dot_12
            .mul_add(
                beta_rate_dot_of_place_104_0,
                beta_rate_dot_of_place_104
                    .mul_add(beta_rate_dot_of_beta_dot_12_0, sums[130]),
            );
        // beta_rate_dot_of_beta_dot_14 = beta_rate_dot_of_place_71*beta_rate_dot_of_beta_dot_13
        let beta_rate_dot_of_beta_dot_14 = beta_rate_dot_of_place_71
            .mul_add(
                beta_rate_dot_of_beta_dot_13_0,
                beta_rate_dot_of_beta_dot_13
                    .mul_add(beta_rate_dot_of_place_71_0, sums[131]),
            );
        // beta_rate_dot_of_beta_dot_15 = beta_rate_dot_of_place_105*beta_rate_dot_of_beta_dot_12
        let beta_rate_dot_of_beta_dot_15 = beta_rate_dot_of_beta_dot_12
            .mul_add(
                beta_rate_dot_of_place_105_0,
                beta_rate_dot_of_place_105
                    .mul_add(beta_rate_dot_of_beta_dot_12_0, sums[132]),
            );
        // beta_rate_dot_of_beta_dot_16 = beta_rate_dot_of_place_91*beta_rate_dot_of_beta_dot_15
        let beta_rate_dot_of_beta_dot_16 = beta_rate_dot_of_place_91
            .mul_add(
                beta_rate_dot_of_beta_dot_15_0,
                beta_rate_dot_of_beta_dot_15
                    .mul_add(beta_rate_dot_of_place_91_0, sums[133]),
            );
        // beta_rate_dot_of_motion_11 = mom + rr*beta_rate_dot_of_motion_10 +
        //   rr_2_by_d*beta_rate_dot_of_beta_dot_4 + weight_34*beta_rate_dot_of_beta_dot_6 +
        //   rr_2_by_zt*beta_rate_dot_of_beta_dot_9 + minus_rr_2*beta_rate_dot_of_beta_dot_11 +
        //   minus_rr_2_by_u*beta_rate_dot_of_beta_dot_14 + minus_rr_2*beta_rate_dot_of_beta_dot_16
        let beta_rate_dot_of_motion_11 = beta_rate_dot_of_beta_dot_16
            .mul_add(
                minus_rr_2,
                beta_rate_dot_of_beta_dot_14
                    .mul_add(
                        minus_rr_2_by_u,
                        beta_rate_dot_of_beta_dot_11
                            .mul_add(
                                minus_rr_2,
                                beta_rate_dot_of_beta_dot_9
                                    .mul_add(
                                        rr_2_by_zt,
                                        beta_rate_dot_of_beta_dot_4
                                            .mul_add(
                                                rr_2_by_d,
                                                beta_rate_dot_of_beta_dot_6
                                                    .mul_add(weight_34, rr * beta_rate_dot_of_motion_10),
                                            ),
                                    ),
                            ),
                    ),
            );
        // beta_dot_dot = beta_rate_dot_of_motion_11/d1_of_place_19
        let beta_dot_dot = beta_rate_dot_of_motion_11
            .mul_add(
                over_d1_of_place_19,
                -(d1_of_place_19.mul_add(beta_dot_dot_0, sums[134]) * over_d1_of_place_19),
            );
        // theta_ddot_of_place = -1 + rr_by_d*beta_rate_dot_of_place_94
        let theta_ddot_of_place = rr_by_d * beta_rate_dot_of_place_94;
        // theta_ddot_of_motion = beta_dot_dot*theta_ddot_of_place
        let theta_ddot_of_motion = beta_dot_dot
            .mul_add(
                theta_ddot_of_place_0,
                theta_ddot_of_place.mul_add(beta_dot_dot_0, sums[135]),
            );
        // theta_dot_dot = minus_rr_by_d*beta_rate_dot_of_beta_dot_3 + theta_ddot_of_motion
        let theta_dot_dot = minus_rr_by_d * beta_rate_dot_of_beta_dot_3 + theta_ddot_of_motion;
        // gamma_ddot_of_beta_dot = beta_rate_dot_of_place_17*beta_rate_dot_of_beta_dot_2
        let gamma_ddot_of_beta_dot = beta_rate_dot_of_place_17
            .mul_add(
                beta_rate_dot_of_beta_dot_2_0,
                beta_rate_dot_of_beta_dot_2
                    .mul_add(beta_rate_dot_of_place_17_0, sums[136]),
            );
        // gamma_ddot_of_motion = beta_dot_dot*sin_theta_cos_angle_inv
        let gamma_ddot_of_motion = beta_dot_dot
            .mul_add(
                sin_theta_cos_angle_inv_0,
                sin_theta_cos_angle_inv.mul_add(beta_dot_dot_0, sums[137]),
            );
        // gamma_dot_dot = minus_rr_by_ss*gamma_ddot_of_beta_dot + rr_by_ss*gamma_ddot_of_motion
        let gamma_dot_dot = gamma_ddot_of_motion
            .mul_add(rr_by_ss, minus_rr_by_ss * gamma_ddot_of_beta_dot);
        // delta_ddot_of_beta_dot = beta_rate_dot_of_beta_dot_2/cos_phi
        let delta_ddot_of_beta_dot = beta_rate_dot_of_beta_dot_2
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(delta_ddot_of_beta_dot_0, sums[138]) * over_cos_phi),
            );
        // delta_ddot_of_beta_dot_2 = beta_rate_dot_of_place_34*delta_ddot_of_beta_dot
        let delta_ddot_of_beta_dot_2 = beta_rate_dot_of_place_34
            .mul_add(
                delta_ddot_of_beta_dot_0,
                delta_ddot_of_beta_dot.mul_add(beta_rate_dot_of_place_34_0, sums[139]),
            );
        // delta_ddot_of_motion = gamma_ddot_of_motion/cos_phi
        let delta_ddot_of_motion = gamma_ddot_of_motion
            .mul_add(
                over_cos_phi,
                -(cos_phi.mul_add(delta_ddot_of_motion_0, sums[140]) * over_cos_phi),
            );
        // delta_ddot_of_motion_2 = sin_angle_2*delta_ddot_of_motion
        let delta_ddot_of_motion_2 = delta_ddot_of_motion
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(delta_ddot_of_motion_0, sums[141]),
            );
        // delta_dot_dot = minus_rr_by_zt*delta_ddot_of_beta_dot_2 + rr_by_zt*delta_ddot_of_motion_2
        let delta_dot_dot = delta_ddot_of_motion_2
            .mul_add(rr_by_zt, minus_rr_by_zt * delta_ddot_of_beta_dot_2);
        // phi_ddot_of_place = e*sin_angle_2 + minus_zt*cos_gamma_minus_delta
        let phi_ddot_of_place = cos_gamma_minus_delta.mul_add(minus_zt, e * sin_angle_2);
        // phi_ddot_of_beta_dot = beta_rate_dot_of_place_54*delta_ddot_of_beta_dot
        let phi_ddot_of_beta_dot = beta_rate_dot_of_place_54
            .mul_add(
                delta_ddot_of_beta_dot_0,
                delta_ddot_of_beta_dot.mul_add(beta_rate_dot_of_place_54_0, sums[142]),
            );
        // phi_ddot_of_motion = phi_ddot_of_place*delta_ddot_of_motion
        let phi_ddot_of_motion = delta_ddot_of_motion
            .mul_add(
                phi_ddot_of_place_0,
                phi_ddot_of_place.mul_add(delta_ddot_of_motion_0, sums[143]),
            );
        // phi_dot_dot = rr*phi_ddot_of_beta_dot + minus_rr_by_e_zt*phi_ddot_of_motion
        let phi_dot_dot = phi_ddot_of_motion
            .mul_add(minus_rr_by_e_zt, rr * phi_ddot_of_beta_dot);
        // epsilon_ddot_of_beta_dot = beta_rate_dot_of_beta_dot_2/cos_omega
        let epsilon_ddot_of_beta_dot = beta_rate_dot_of_beta_dot_2
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(epsilon_ddot_of_beta_dot_0, sums[144]) * over_cos_omega),
            );
        // epsilon_ddot_of_beta_dot_2 = beta_rate_dot_of_place_71*epsilon_ddot_of_beta_dot
        let epsilon_ddot_of_beta_dot_2 = beta_rate_dot_of_place_71
            .mul_add(
                epsilon_ddot_of_beta_dot_0,
                epsilon_ddot_of_beta_dot.mul_add(beta_rate_dot_of_place_71_0, sums[145]),
            );
        // epsilon_ddot_of_motion = gamma_ddot_of_motion/cos_omega
        let epsilon_ddot_of_motion = gamma_ddot_of_motion
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(epsilon_ddot_of_motion_0, sums[146]) * over_cos_omega),
            );
        // epsilon_ddot_of_motion_2 = cos_angle_3*epsilon_ddot_of_motion
        let epsilon_ddot_of_motion_2 = epsilon_ddot_of_motion
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(epsilon_ddot_of_motion_0, sums[147]),
            );
        // epsilon_dot_dot = rr_by_u*epsilon_ddot_of_beta_dot_2 + rr_by_u*epsilon_ddot_of_motion_2
        let epsilon_dot_dot = epsilon_ddot_of_motion_2
            .mul_add(rr_by_u, rr_by_u * epsilon_ddot_of_beta_dot_2);
        // omega_ddot_of_place = zf*cos_angle_3 + minus_u*sin_gamma_minus_epsilon
        let omega_ddot_of_place = sin_gamma_minus_epsilon
            .mul_add(minus_u, zf * cos_angle_3);
        // omega_ddot_of_beta_dot = beta_rate_dot_of_place_91*epsilon_ddot_of_beta_dot
        let omega_ddot_of_beta_dot = beta_rate_dot_of_place_91
            .mul_add(
                epsilon_ddot_of_beta_dot_0,
                epsilon_ddot_of_beta_dot.mul_add(beta_rate_dot_of_place_91_0, sums[148]),
            );
        // omega_ddot_of_motion = omega_ddot_of_place*epsilon_ddot_of_motion
        let omega_ddot_of_motion = epsilon_ddot_of_motion
            .mul_add(
                omega_ddot_of_place_0,
                omega_ddot_of_place.mul_add(epsilon_ddot_of_motion_0, sums[149]),
            );
        // omega_dot_dot = rr*omega_ddot_of_beta_dot + minus_rr_by_u_zf*omega_ddot_of_motion
        let omega_dot_dot = omega_ddot_of_motion
            .mul_add(minus_rr_by_u_zf, rr * omega_ddot_of_beta_dot);
        beta_rate_2 = beta_dot;
        theta_rate = theta_dot;
        gamma_rate = gamma_dot;
        delta_rate = delta_dot;
        phi_rate = phi_dot;
        epsilon_rate = epsilon_dot;
        omega_rate = omega_dot;
        beta_dot_rate = beta_dot_dot;
        theta_dot_rate = theta_dot_dot;
        gamma_dot_rate = gamma_dot_dot;
        delta_dot_rate = delta_dot_dot;
        phi_dot_rate = phi_dot_dot;
        epsilon_dot_rate = epsilon_dot_dot;
        omega_dot_rate = omega_dot_dot;
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
                beta_rate_dot_of_place_2, cos_angle, cos_beta_minus_gamma, sin_theta,
                cos_beta_minus_gamma, cos_angle, sin_theta, cos_beta_minus_gamma, sin_theta,
                cos_angle, cos_phi, sin_angle_2, cos_gamma_minus_delta, sin_angle_2, cos_phi,
                sin_angle_2, sin_theta, sin_angle_2, sin_theta, sin_angle_2, cos_angle, cos_theta,
                cos_gamma_minus_delta, sin_angle_2, cos_gamma_minus_delta, cos_gamma_minus_delta,
                cos_phi, cos_gamma_minus_delta, cos_phi, sin_theta, beta_rate_dot_of_place_46,
                sin_theta, beta_rate_dot_of_place_46, cos_angle, cos_theta, cos_omega, cos_angle_3,
                sin_gamma_minus_epsilon, cos_angle_3, cos_omega, cos_angle_3, sin_theta,
                cos_angle_3, sin_theta, cos_angle_3, cos_angle, cos_theta, sin_gamma_minus_epsilon,
                cos_angle_3, sin_gamma_minus_epsilon, cos_omega, sin_gamma_minus_epsilon, cos_omega,
                beta_rate_dot_of_place_72, sin_theta, beta_rate_dot_of_place_83, sin_theta,
                beta_rate_dot_of_place_83, cos_angle, cos_theta, beta_rate_dot_of_place_2,
                cos_angle, cos_gamma_minus_delta, sin_angle_2, sin_gamma_minus_epsilon, cos_angle_3,
                beta_rate_dot_of_place, beta_rate_dot_of_place_93, delta_dot, phi_dot, delta_dot,
                phi_dot, epsilon_dot, omega_dot, epsilon_dot, omega_dot, beta_dot,
                cos_beta_minus_gamma, cos_angle, beta_dot, theta_dot, sin_theta, cos_angle,
                beta_rate_dot_of_place_10, beta_rate_dot_of_place_95, cos_angle,
                beta_rate_dot_of_beta_dot_2, beta_rate_dot_of_place_17, cos_phi_sq,
                beta_rate_dot_of_place_98, beta_rate_dot_of_place_34, beta_rate_dot_of_place_99,
                beta_rate_dot_of_place_54, cos_omega_sq, beta_rate_dot_of_place_104,
                beta_rate_dot_of_place_71, beta_rate_dot_of_place_105, beta_rate_dot_of_place_91,
                d1_of_place_19, beta_dot_dot, beta_rate_dot_of_place_17, beta_dot_dot, cos_phi,
                beta_rate_dot_of_place_34, cos_phi, sin_angle_2, beta_rate_dot_of_place_54,
                phi_ddot_of_place, cos_omega, beta_rate_dot_of_place_71, cos_omega, cos_angle_3,
                beta_rate_dot_of_place_91, omega_ddot_of_place,
            ]),
            padded([
                cos_theta, sin_theta, cos_phi, sin_phi, cos_omega, sin_omega, cos_angle, sin_angle,
                cos_beta_minus_gamma, sin_beta_minus_gamma, cos_angle_2, sin_angle_2,
                cos_gamma_minus_delta, sin_gamma_minus_delta, cos_angle_3, sin_angle_3,
                cos_gamma_minus_epsilon, sin_gamma_minus_epsilon, cos_beta_minus_gamma,
                cos_beta_minus_gamma, sin_angle_2, d1_of_place_5, sin_angle_2, cos_phi,
                d1_of_place_8, cos_angle_3, d1_of_place_9, cos_angle_3, cos_omega, d1_of_place_12,
                sin_theta, sin_theta_sq, d1_of_place_16, d1_of_place_18, cos_gamma, sin_gamma,
                beta_rate_dot_of_place_2, sin_angle_cos_angle_inv, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_5, beta_rate_dot_of_place_4, beta_rate_dot_of_place_9,
                sin_angle_cos_angle_inv, beta_rate_dot_of_place_12, beta_rate_dot_of_place_11,
                beta_rate_dot_of_place_16, sin_phi_cos_phi_inv, sin_phi_cos_phi_inv,
                beta_rate_dot_of_place_19, beta_rate_dot_of_place_18, beta_rate_dot_of_place_23,
                sin_angle_cos_angle_inv, beta_rate_dot_of_place_26, beta_rate_dot_of_place_4,
                beta_rate_dot_of_place_29, d1_of_place_4, beta_rate_dot_of_place_33, sin_angle_2,
                sin_phi_cos_phi_inv, beta_rate_dot_of_place_36, cos_angle_2,
                beta_rate_dot_of_place_35, beta_rate_dot_of_place_41, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_43, beta_rate_dot_of_place_44, beta_rate_dot_of_place_4,
                beta_rate_dot_of_place_48, d1_of_place_4, beta_rate_dot_of_place_52,
                beta_rate_dot_of_place_46, sin_omega_cos_omega_inv, sin_omega_cos_omega_inv,
                beta_rate_dot_of_place_56, beta_rate_dot_of_place_55, beta_rate_dot_of_place_60,
                sin_angle_cos_angle_inv, beta_rate_dot_of_place_63, beta_rate_dot_of_place_4,
                beta_rate_dot_of_place_66, d1_of_place_4, beta_rate_dot_of_place_70, cos_angle_3,
                sin_omega_cos_omega_inv, beta_rate_dot_of_place_73, sin_angle_3,
                beta_rate_dot_of_place_77, sin_angle_cos_angle_inv, beta_rate_dot_of_place_79,
                beta_rate_dot_of_place_79, beta_rate_dot_of_place_81, beta_rate_dot_of_place_4,
                beta_rate_dot_of_place_85, d1_of_place_4, beta_rate_dot_of_place_89,
                beta_rate_dot_of_place_83, beta_rate_dot_of_place_3, beta_rate_dot_of_place_94,
                beta_rate_dot_of_e_ea_zt_phi, beta_rate_dot_of_e_ea_zt_phi_2,
                beta_rate_dot_of_place_100, beta_rate_dot_of_place_102, beta_rate_dot_of_place_106,
                beta_rate_dot_of_place_106, beta_rate_dot_of_place_108, sin_angle_2,
                beta_rate_dot_of_motion, phi_dot_sin_angle_2, beta_rate_dot_of_place_109,
                cos_angle_3, beta_rate_dot_of_motion_3, omega_dot_cos_angle_3, beta_dot,
                beta_dot_sq, beta_rate_dot_of_motion_6, beta_rate_dot_of_motion_7, theta_dot,
                beta_rate_dot_of_motion_9, beta_rate_dot_of_beta_dot_2, beta_rate_dot_of_beta_dot_2,
                beta_rate_dot_of_beta_dot_3, sin_theta_cos_angle_inv, sin_theta_cos_angle_inv,
                beta_rate_dot_of_beta_dot_5, beta_rate_dot_of_beta_dot_7,
                beta_rate_dot_of_beta_dot_7, beta_rate_dot_of_beta_dot_8,
                beta_rate_dot_of_beta_dot_7, beta_rate_dot_of_beta_dot_10,
                beta_rate_dot_of_beta_dot_12, beta_rate_dot_of_beta_dot_12,
                beta_rate_dot_of_beta_dot_13, beta_rate_dot_of_beta_dot_12,
                beta_rate_dot_of_beta_dot_15, beta_dot_dot, theta_ddot_of_place,
                beta_rate_dot_of_beta_dot_2, sin_theta_cos_angle_inv, delta_ddot_of_beta_dot,
                delta_ddot_of_beta_dot, delta_ddot_of_motion, delta_ddot_of_motion,
                delta_ddot_of_beta_dot, delta_ddot_of_motion, epsilon_ddot_of_beta_dot,
                epsilon_ddot_of_beta_dot, epsilon_ddot_of_motion, epsilon_ddot_of_motion,
                epsilon_ddot_of_beta_dot, epsilon_ddot_of_motion,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        gamma_last = gamma;
        phi_last = phi;
        omega_last = omega;
        beta_dot_last = beta_dot;
        theta_dot_last = theta_dot;
        delta_dot_last = delta_dot;
        phi_dot_last = phi_dot;
        epsilon_dot_last = epsilon_dot;
        omega_dot_last = omega_dot;
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
        d1_of_place_4_last = d1_of_place_4;
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
        sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv;
        beta_rate_dot_of_place_4_last = beta_rate_dot_of_place_4;
        beta_rate_dot_of_place_5_last = beta_rate_dot_of_place_5;
        beta_rate_dot_of_place_9_last = beta_rate_dot_of_place_9;
        beta_rate_dot_of_place_10_last = beta_rate_dot_of_place_10;
        beta_rate_dot_of_place_11_last = beta_rate_dot_of_place_11;
        beta_rate_dot_of_place_12_last = beta_rate_dot_of_place_12;
        beta_rate_dot_of_place_16_last = beta_rate_dot_of_place_16;
        beta_rate_dot_of_place_17_last = beta_rate_dot_of_place_17;
        sin_phi_cos_phi_inv_last = sin_phi_cos_phi_inv;
        beta_rate_dot_of_place_18_last = beta_rate_dot_of_place_18;
        beta_rate_dot_of_place_19_last = beta_rate_dot_of_place_19;
        beta_rate_dot_of_place_23_last = beta_rate_dot_of_place_23;
        beta_rate_dot_of_place_26_last = beta_rate_dot_of_place_26;
        beta_rate_dot_of_place_29_last = beta_rate_dot_of_place_29;
        beta_rate_dot_of_place_33_last = beta_rate_dot_of_place_33;
        beta_rate_dot_of_place_34_last = beta_rate_dot_of_place_34;
        beta_rate_dot_of_place_35_last = beta_rate_dot_of_place_35;
        beta_rate_dot_of_place_36_last = beta_rate_dot_of_place_36;
        beta_rate_dot_of_place_41_last = beta_rate_dot_of_place_41;
        beta_rate_dot_of_place_43_last = beta_rate_dot_of_place_43;
        beta_rate_dot_of_place_44_last = beta_rate_dot_of_place_44;
        beta_rate_dot_of_place_46_last = beta_rate_dot_of_place_46;
        beta_rate_dot_of_place_48_last = beta_rate_dot_of_place_48;
        beta_rate_dot_of_place_52_last = beta_rate_dot_of_place_52;
        beta_rate_dot_of_place_54_last = beta_rate_dot_of_place_54;
        sin_omega_cos_omega_inv_last = sin_omega_cos_omega_inv;
        beta_rate_dot_of_place_55_last = beta_rate_dot_of_place_55;
        beta_rate_dot_of_place_56_last = beta_rate_dot_of_place_56;
        beta_rate_dot_of_place_60_last = beta_rate_dot_of_place_60;
        beta_rate_dot_of_place_63_last = beta_rate_dot_of_place_63;
        beta_rate_dot_of_place_66_last = beta_rate_dot_of_place_66;
        beta_rate_dot_of_place_70_last = beta_rate_dot_of_place_70;
        beta_rate_dot_of_place_71_last = beta_rate_dot_of_place_71;
        beta_rate_dot_of_place_72_last = beta_rate_dot_of_place_72;
        beta_rate_dot_of_place_73_last = beta_rate_dot_of_place_73;
        beta_rate_dot_of_place_77_last = beta_rate_dot_of_place_77;
        beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79;
        beta_rate_dot_of_place_81_last = beta_rate_dot_of_place_81;
        beta_rate_dot_of_place_83_last = beta_rate_dot_of_place_83;
        beta_rate_dot_of_place_85_last = beta_rate_dot_of_place_85;
        beta_rate_dot_of_place_89_last = beta_rate_dot_of_place_89;
        beta_rate_dot_of_place_91_last = beta_rate_dot_of_place_91;
        beta_rate_dot_of_place_93_last = beta_rate_dot_of_place_93;
        beta_rate_dot_of_place_94_last = beta_rate_dot_of_place_94;
        beta_rate_dot_of_place_95_last = beta_rate_dot_of_place_95;
        beta_rate_dot_of_e_ea_zt_phi_last = beta_rate_dot_of_e_ea_zt_phi;
        beta_rate_dot_of_e_ea_zt_phi_2_last = beta_rate_dot_of_e_ea_zt_phi_2;
        beta_rate_dot_of_place_98_last = beta_rate_dot_of_place_98;
        beta_rate_dot_of_place_99_last = beta_rate_dot_of_place_99;
        beta_rate_dot_of_place_100_last = beta_rate_dot_of_place_100;
        beta_rate_dot_of_place_102_last = beta_rate_dot_of_place_102;
        beta_rate_dot_of_place_104_last = beta_rate_dot_of_place_104;
        beta_rate_dot_of_place_105_last = beta_rate_dot_of_place_105;
        beta_rate_dot_of_place_106_last = beta_rate_dot_of_place_106;
        beta_rate_dot_of_place_108_last = beta_rate_dot_of_place_108;
        phi_dot_sin_angle_2_last = phi_dot_sin_angle_2;
        beta_rate_dot_of_motion_last = beta_rate_dot_of_motion;
        beta_rate_dot_of_place_109_last = beta_rate_dot_of_place_109;
        omega_dot_cos_angle_3_last = omega_dot_cos_angle_3;
        beta_rate_dot_of_motion_3_last = beta_rate_dot_of_motion_3;
        beta_dot_sq_last = beta_dot_sq;
        beta_rate_dot_of_motion_6_last = beta_rate_dot_of_motion_6;
        beta_rate_dot_of_motion_7_last = beta_rate_dot_of_motion_7;
        beta_rate_dot_of_motion_9_last = beta_rate_dot_of_motion_9;
        beta_rate_dot_of_beta_dot_2_last = beta_rate_dot_of_beta_dot_2;
        beta_rate_dot_of_beta_dot_3_last = beta_rate_dot_of_beta_dot_3;
        sin_theta_cos_angle_inv_last = sin_theta_cos_angle_inv;
        beta_rate_dot_of_beta_dot_5_last = beta_rate_dot_of_beta_dot_5;
        beta_rate_dot_of_beta_dot_7_last = beta_rate_dot_of_beta_dot_7;
        beta_rate_dot_of_beta_dot_8_last = beta_rate_dot_of_beta_dot_8;
        beta_rate_dot_of_beta_dot_10_last = beta_rate_dot_of_beta_dot_10;
        beta_rate_dot_of_beta_dot_12_last = beta_rate_dot_of_beta_dot_12;
        beta_rate_dot_of_beta_dot_13_last = beta_rate_dot_of_beta_dot_13;
        beta_rate_dot_of_beta_dot_15_last = beta_rate_dot_of_beta_dot_15;
        beta_dot_dot_last = beta_dot_dot;
        theta_ddot_of_place_last = theta_ddot_of_place;
        delta_ddot_of_beta_dot_last = delta_ddot_of_beta_dot;
        delta_ddot_of_motion_last = delta_ddot_of_motion;
        phi_ddot_of_place_last = phi_ddot_of_place;
        epsilon_ddot_of_beta_dot_last = epsilon_ddot_of_beta_dot;
        epsilon_ddot_of_motion_last = epsilon_ddot_of_motion;
        omega_ddot_of_place_last = omega_ddot_of_place;
    }
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    q_dot: &[S; 7],
    direction: &[S; 14],
) -> [S; 14] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[7 + i],
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
            parameters: 42,
            coordinates: 7,
            variables: 7,
            speeds: 1,
            reactions: 6,
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
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        304 * order + SLACK
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
        3
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["cos(beta + theta - gamma)", "cos(phi)", "cos(omega)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        12
    }
    fn constraint_name(&self, at: usize) -> &str {
        [
            "E3_1", "E3_2", "E4_1", "E4_2", "E6_1", "E6_2", "E3_1'", "E3_2'", "E4_1'", "E4_2'",
            "E6_1'", "E6_2'",
        ][at]
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
