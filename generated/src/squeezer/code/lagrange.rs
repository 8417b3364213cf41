//! Andrews' squeezing mechanism: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

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
    //   m4*(sin(gamma - delta - phi)*(zt + sin(phi)*(e - ea)) + cos(gamma - delta)*(e + zt*sin(phi) +
    //   ea*((ea - zt*sin(phi))/e - 2))))/(zt*cos(beta + theta - gamma)^2*cos(phi)^2) -
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
    //   cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + m6*(cos(gamma - epsilon - omega)*(u +
    //   sin(omega)*(fa - zf)) + sin(gamma - epsilon)*(zf - u*sin(omega) + fa*((fa + u*sin(omega))/zf -
    //   2))))/(u*cos(beta + theta - gamma)^2*cos(omega)^2) - rr^2*beta'^2*sin(theta)*(cos(theta)*(cos(gamma
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
    //   m4*(sin(gamma - delta - phi)*(zt + sin(phi)*(e - ea)) + cos(gamma - delta)*(e + zt*sin(phi) +
    //   ea*((ea - zt*sin(phi))/e - 2))))/(zt*cos(beta + theta - gamma)^2*cos(phi)^2) -
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
    //   cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + m6*(cos(gamma - epsilon - omega)*(u +
    //   sin(omega)*(fa - zf)) + sin(gamma - epsilon)*(zf - u*sin(omega) + fa*((fa + u*sin(omega))/zf -
    //   2))))/(u*cos(beta + theta - gamma)^2*cos(omega)^2) - rr^2*beta'^2*sin(theta)*(cos(theta)*(cos(gamma
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
