//! Andrews' squeezing mechanism: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, divisors, potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows K1 force k1_frame1, K1 force k1_frame2, K1 moment k1_frame3, K2 force k2_frame1, K2 force k2_frame2, K2 moment k2_frame3, K3 force k3_frame1, K3 force k3_frame2, K3 moment k3_frame3, K4 force k4_frame1, K4 force k4_frame2, K4 moment k4_frame3, K5 force k5_frame1, K5 force k5_frame2, K5 moment k5_frame3, K6 force k6_frame1, K6 force k6_frame2, K6 moment k6_frame3, K7 force k7_frame1, K7 force k7_frame2, K7 moment k7_frame3.
///
/// 163 operations, 8 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 7],
    _u: &[S; 1],
) -> [[S; 21]; 21] {
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
    let m2_rr = m2 * rr;
    // cos(beta)*cos(theta) - sin(beta)*sin(theta)
    let cos_beta_plus_theta = (-sin_beta).mul_add(sin_theta, cos_beta * cos_theta);
    // cos(beta)*sin(theta) + sin(beta)*cos(theta)
    let sin_beta_plus_theta = sin_beta.mul_add(cos_theta, cos_beta * sin_theta);
    let (_, cos_angle) = (beta + theta - gamma).sin_cos();
    let rr_cos_angle_inv = rr / cos_angle;
    // sin(beta)*sin(gamma) + cos(beta)*cos(gamma)
    let cos_beta_minus_gamma = cos_beta.mul_add(cos_gamma, sin_beta * sin_gamma);
    let m_5_1_of_place = cos_beta_minus_gamma * rr_cos_angle_inv / d;
    // d - da
    let d_minus_da = d - da;
    let m_6_2_of_place = sin_beta_plus_theta * d_minus_da;
    let m_6_3_of_place = cos_beta_plus_theta * d_minus_da;
    let m_7_1_of_place = rr_cos_angle_inv * sin_theta;
    let ss_inv_m_7_1_of_place = m_7_1_of_place / ss;
    let m3_ss_inv_m_7_1_of_place = m3 * ss_inv_m_7_1_of_place;
    // ss - sa
    let ss_minus_sa = ss - sa;
    let sb_sin_gamma = sb * sin_gamma;
    let sb_cos_gamma = sb * cos_gamma;
    // cos(delta)*cos(phi) - sin(delta)*sin(phi)
    let cos_delta_plus_phi = (-sin_delta).mul_add(sin_phi, cos_delta * cos_phi);
    // cos(delta)*sin(phi) + sin(delta)*cos(phi)
    let sin_delta_plus_phi = sin_delta.mul_add(cos_phi, cos_delta * sin_phi);
    // cos(delta + phi)*sin(gamma) - sin(delta + phi)*cos(gamma)
    let m_10_1_of_place = (-sin_delta_plus_phi)
        .mul_add(cos_gamma, cos_delta_plus_phi * sin_gamma);
    let m_10_1_of_place_2 = m_7_1_of_place / cos_phi;
    let m_10_1_of_place_3 = m_10_1_of_place * m_10_1_of_place_2;
    let e_inv = S::int(1) / e;
    // sin(gamma)*sin(delta) + cos(gamma)*cos(delta)
    let cos_gamma_minus_delta = cos_gamma.mul_add(cos_delta, sin_gamma * sin_delta);
    let m_10_1_of_place_4 = cos_gamma_minus_delta * m_10_1_of_place_2;
    // e - ea
    let e_minus_ea = e - ea;
    let zt_inv_m_10_1_of_place_3 = m_10_1_of_place_3 / zt;
    let m_13_1_of_place = m5 * zt_inv_m_10_1_of_place_3;
    // cos(epsilon)*cos(omega) - sin(epsilon)*sin(omega)
    let cos_epsilon_plus_omega = (-sin_epsilon)
        .mul_add(sin_omega, cos_epsilon * cos_omega);
    // cos(epsilon)*sin(omega) + sin(epsilon)*cos(omega)
    let sin_epsilon_plus_omega = sin_epsilon.mul_add(cos_omega, cos_epsilon * sin_omega);
    // sin(epsilon + omega)*sin(gamma) + cos(epsilon + omega)*cos(gamma)
    let m_16_1_of_place = cos_epsilon_plus_omega
        .mul_add(cos_gamma, sin_epsilon_plus_omega * sin_gamma);
    let m_17_1_of_place = m_7_1_of_place / cos_omega;
    let m_17_1_of_place_2 = m_16_1_of_place * m_17_1_of_place;
    let zf_inv = S::int(1) / zf;
    // sin(gamma)*cos(epsilon) - cos(gamma)*sin(epsilon)
    let sin_gamma_minus_epsilon = (-cos_gamma)
        .mul_add(sin_epsilon, sin_gamma * cos_epsilon);
    let m_17_1_of_place_3 = sin_gamma_minus_epsilon * m_17_1_of_place;
    // zf - fa
    let zf_minus_fa = zf - fa;
    let m_19_1_of_place = m_17_1_of_place_2 / u_2;
    let m7_m_19_1_of_place = m7 * m_19_1_of_place;
    // -sin(gamma)
    let minus_sin_gamma = -sin_gamma;
    // -cos(beta)
    let minus_cos_beta = -cos_beta;
    // -cos(theta)
    let minus_cos_theta = -cos_theta;
    // -cos(gamma)
    let minus_cos_gamma = -cos_gamma;
    // -cos(phi)
    let minus_cos_phi = -cos_phi;
    // -cos(delta)
    let minus_cos_delta = -cos_delta;
    // -cos(omega)
    let minus_cos_omega = -cos_omega;
    // -cos(epsilon)
    let minus_cos_epsilon = -cos_epsilon;
    // -sin(beta + theta)
    let m_5_2_of_beta_theta = -sin_beta_plus_theta;
    // -cos(delta + phi)
    let minus_cos_delta_plus_phi = -cos_delta_plus_phi;
    // -cos(epsilon + omega)
    let m_16_6_of_place = -cos_epsilon_plus_omega;
    // -m_6_3_of_place
    let minus_m_6_3_of_place = -m_6_3_of_place;
    // Entries that are not zero.
    // M_1_12 = 1
    let m_1_12 = S::int(1);
    // M_1_20 = -cos(beta)
    let m_1_20 = minus_cos_beta;
    // M_1_21 = -sin(beta)
    let m_1_21 = -sin_beta;
    // M_2_1 = m1*ra
    let m_2_1 = m1 * ra;
    // M_2_13 = 1
    let m_2_13 = S::int(1);
    // M_2_20 = sin(beta)
    let m_2_20 = sin_beta;
    // M_2_21 = -cos(beta)
    let m_2_21 = minus_cos_beta;
    // M_3_1 = I1
    let m_3_1 = I1;
    // M_3_13 = rr - ra
    let m_3_13 = rr - ra;
    // M_3_20 = -ra*sin(beta)
    let m_3_20 = -ra * sin_beta;
    // M_3_21 = ra*cos(beta)
    let m_3_21 = ra * cos_beta;
    // M_4_1 = m2*rr*sin(theta)
    let m_4_1 = m2_rr * sin_theta;
    // M_4_2 = cos(beta + theta)
    let m_4_2 = cos_beta_plus_theta;
    // M_4_3 = sin(beta + theta)
    let m_4_3 = sin_beta_plus_theta;
    // M_4_4 = cos(beta + theta)
    let m_4_4 = cos_beta_plus_theta;
    // M_4_5 = sin(beta + theta)
    let m_4_5 = sin_beta_plus_theta;
    // M_4_6 = cos(beta + theta)
    let m_4_6 = cos_beta_plus_theta;
    // M_4_7 = sin(beta + theta)
    let m_4_7 = sin_beta_plus_theta;
    // M_4_12 = -cos(theta)
    let m_4_12 = minus_cos_theta;
    // M_4_13 = -sin(theta)
    let m_4_13 = -sin_theta;
    // M_5_1 = m2*rr*(cos(theta) - da*cos(beta - gamma)/(d*cos(beta + theta - gamma)))
    let m_5_1 = (-(m2 * da)).mul_add(m_5_1_of_place, m2_rr * cos_theta);
    // M_5_2 = -sin(beta + theta)
    let m_5_2 = m_5_2_of_beta_theta;
    // M_5_3 = cos(beta + theta)
    let m_5_3 = cos_beta_plus_theta;
    // M_5_4 = -sin(beta + theta)
    let m_5_4 = m_5_2_of_beta_theta;
    // M_5_5 = cos(beta + theta)
    let m_5_5 = cos_beta_plus_theta;
    // M_5_6 = -sin(beta + theta)
    let m_5_6 = m_5_2_of_beta_theta;
    // M_5_7 = cos(beta + theta)
    let m_5_7 = cos_beta_plus_theta;
    // M_5_12 = sin(theta)
    let m_5_12 = sin_theta;
    // M_5_13 = -cos(theta)
    let m_5_13 = minus_cos_theta;
    // M_6_1 = I2*rr*cos(beta - gamma)/(d*cos(beta + theta - gamma))
    let m_6_1 = I2 * m_5_1_of_place;
    // M_6_2 = sin(beta + theta)*(d - da)
    let m_6_2 = m_6_2_of_place;
    // M_6_3 = cos(beta + theta)*(da - d)
    let m_6_3 = minus_m_6_3_of_place;
    // M_6_4 = sin(beta + theta)*(d - da)
    let m_6_4 = m_6_2_of_place;
    // M_6_5 = cos(beta + theta)*(da - d)
    let m_6_5 = minus_m_6_3_of_place;
    // M_6_6 = sin(beta + theta)*(d - da)
    let m_6_6 = m_6_2_of_place;
    // M_6_7 = cos(beta + theta)*(da - d)
    let m_6_7 = minus_m_6_3_of_place;
    // M_6_12 = da*sin(theta)
    let m_6_12 = da * sin_theta;
    // M_6_13 = -da*cos(theta)
    let m_6_13 = -da * cos_theta;
    // M_7_1 = m3*rr*sa*sin(theta)/(ss*cos(beta + theta - gamma))
    let m_7_1 = sa * m3_ss_inv_m_7_1_of_place;
    // M_7_2 = -cos(gamma)
    let m_7_2 = minus_cos_gamma;
    // M_7_3 = -sin(gamma)
    let m_7_3 = minus_sin_gamma;
    // M_7_18 = -cos(gamma)
    let m_7_18 = minus_cos_gamma;
    // M_7_19 = -sin(gamma)
    let m_7_19 = minus_sin_gamma;
    // M_8_1 = m3*rr*sb*sin(theta)/(ss*cos(beta + theta - gamma))
    let m_8_1 = sb * m3_ss_inv_m_7_1_of_place;
    // M_8_2 = sin(gamma)
    let m_8_2 = sin_gamma;
    // M_8_3 = -cos(gamma)
    let m_8_3 = minus_cos_gamma;
    // M_8_18 = sin(gamma)
    let m_8_18 = sin_gamma;
    // M_8_19 = -cos(gamma)
    let m_8_19 = minus_cos_gamma;
    // M_9_1 = I3*rr*sin(theta)/(ss*cos(beta + theta - gamma))
    let m_9_1 = I3 * ss_inv_m_7_1_of_place;
    // M_9_2 = cos(gamma)*(sa - ss) - sb*sin(gamma)
    let m_9_2 = (-ss_minus_sa).mul_add(cos_gamma, -sb_sin_gamma);
    // M_9_3 = sin(gamma)*(sa - ss) + sb*cos(gamma)
    let m_9_3 = (-ss_minus_sa).mul_add(sin_gamma, sb_cos_gamma);
    // M_9_18 = sa*cos(gamma) - sb*sin(gamma)
    let m_9_18 = sa.mul_add(cos_gamma, -sb_sin_gamma);
    // M_9_19 = sa*sin(gamma) + sb*cos(gamma)
    let m_9_19 = sa.mul_add(sin_gamma, sb_cos_gamma);
    // M_10_1 = m4*rr*sin(theta)*(sin(phi)*sin(gamma - delta - phi) - cos(gamma - delta)*(ea/e -
    //   1))/(cos(beta + theta - gamma)*cos(phi))
    let m_10_1 = m4
        * (m_10_1_of_place_4 * (-ea).mul_add(e_inv, S::int(1)) + m_10_1_of_place_3 * sin_phi);
    // M_10_4 = -cos(delta + phi)
    let m_10_4 = minus_cos_delta_plus_phi;
    // M_10_5 = -sin(delta + phi)
    let m_10_5 = -sin_delta_plus_phi;
    // M_10_10 = -cos(phi)
    let m_10_10 = minus_cos_phi;
    // M_10_11 = -sin(phi)
    let m_10_11 = -sin_phi;
    // M_11_1 = m4*rr*sin(theta)*sin(gamma - delta - phi)/cos(beta + theta - gamma)
    let m_11_1 = m4 * m_10_1_of_place * m_7_1_of_place;
    // M_11_4 = sin(delta + phi)
    let m_11_4 = sin_delta_plus_phi;
    // M_11_5 = -cos(delta + phi)
    let m_11_5 = minus_cos_delta_plus_phi;
    // M_11_10 = sin(phi)
    let m_11_10 = sin_phi;
    // M_11_11 = -cos(phi)
    let m_11_11 = minus_cos_phi;
    // M_12_1 = I4*rr*sin(theta)*cos(gamma - delta)/(e*cos(beta + theta - gamma)*cos(phi))
    let m_12_1 = I4 * e_inv * m_10_1_of_place_4;
    // M_12_4 = -ea*cos(delta + phi)
    let m_12_4 = -ea * cos_delta_plus_phi;
    // M_12_5 = -ea*sin(delta + phi)
    let m_12_5 = -ea * sin_delta_plus_phi;
    // M_12_10 = cos(phi)*(e - ea)
    let m_12_10 = e_minus_ea * cos_phi;
    // M_12_11 = sin(phi)*(e - ea)
    let m_12_11 = e_minus_ea * sin_phi;
    // M_13_1 = m5*rr*tb*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let m_13_1 = tb * m_13_1_of_place;
    // M_13_10 = 1
    let m_13_10 = S::int(1);
    // M_13_16 = -cos(delta)
    let m_13_16 = minus_cos_delta;
    // M_13_17 = -sin(delta)
    let m_13_17 = -sin_delta;
    // M_14_1 = m5*rr*ta*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let m_14_1 = ta * m_13_1_of_place;
    // M_14_11 = 1
    let m_14_11 = S::int(1);
    // M_14_16 = sin(delta)
    let m_14_16 = sin_delta;
    // M_14_17 = -cos(delta)
    let m_14_17 = minus_cos_delta;
    // M_15_1 = I5*rr*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let m_15_1 = I5 * zt_inv_m_10_1_of_place_3;
    // M_15_10 = -tb
    let m_15_10 = -tb;
    // M_15_11 = zt - ta
    let m_15_11 = zt - ta;
    // M_15_16 = tb*cos(delta) - ta*sin(delta)
    let m_15_16 = (-ta).mul_add(sin_delta, tb * cos_delta);
    // M_15_17 = tb*sin(delta) + ta*cos(delta)
    let m_15_17 = ta.mul_add(cos_delta, tb * sin_delta);
    // M_16_1 = m6*rr*sin(theta)*cos(gamma - epsilon - omega)/cos(beta + theta - gamma)
    let m_16_1 = m6 * m_16_1_of_place * m_7_1_of_place;
    // M_16_6 = -cos(epsilon + omega)
    let m_16_6 = m_16_6_of_place;
    // M_16_7 = -sin(epsilon + omega)
    let m_16_7 = -sin_epsilon_plus_omega;
    // M_16_8 = -cos(omega)
    let m_16_8 = minus_cos_omega;
    // M_16_9 = -sin(omega)
    let m_16_9 = -sin_omega;
    // M_17_1 = -m6*rr*sin(theta)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega))/(cos(beta + theta - gamma)*cos(omega))
    let m_17_1 = -m6
        * (m_17_1_of_place_3 * fa.mul_add(zf_inv, -S::int(1)) + m_17_1_of_place_2 * sin_omega);
    // M_17_6 = sin(epsilon + omega)
    let m_17_6 = sin_epsilon_plus_omega;
    // M_17_7 = -cos(epsilon + omega)
    let m_17_7 = m_16_6_of_place;
    // M_17_8 = sin(omega)
    let m_17_8 = sin_omega;
    // M_17_9 = -cos(omega)
    let m_17_9 = minus_cos_omega;
    // M_18_1 = I6*rr*sin(theta)*sin(gamma - epsilon)/(zf*cos(beta + theta - gamma)*cos(omega))
    let m_18_1 = I6 * zf_inv * m_17_1_of_place_3;
    // M_18_6 = fa*sin(epsilon + omega)
    let m_18_6 = fa * sin_epsilon_plus_omega;
    // M_18_7 = -fa*cos(epsilon + omega)
    let m_18_7 = -fa * cos_epsilon_plus_omega;
    // M_18_8 = sin(omega)*(fa - zf)
    let m_18_8 = -zf_minus_fa * sin_omega;
    // M_18_9 = cos(omega)*(zf - fa)
    let m_18_9 = zf_minus_fa * cos_omega;
    // M_19_1 = m7*rr*ua*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
    let m_19_1 = ua * m7_m_19_1_of_place;
    // M_19_8 = 1
    let m_19_8 = S::int(1);
    // M_19_14 = -cos(epsilon)
    let m_19_14 = minus_cos_epsilon;
    // M_19_15 = -sin(epsilon)
    let m_19_15 = -sin_epsilon;
    // M_20_1 = m7*rr*ub*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
    let m_20_1 = ub * m7_m_19_1_of_place;
    // M_20_9 = 1
    let m_20_9 = S::int(1);
    // M_20_14 = sin(epsilon)
    let m_20_14 = sin_epsilon;
    // M_20_15 = -cos(epsilon)
    let m_20_15 = minus_cos_epsilon;
    // M_21_1 = I7*rr*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
    let m_21_1 = I7 * m_19_1_of_place;
    // M_21_8 = u - ua
    let m_21_8 = u_2 - ua;
    // M_21_9 = -ub
    let m_21_9 = -ub;
    // M_21_14 = ua*cos(epsilon) - ub*sin(epsilon)
    let m_21_14 = (-ub).mul_add(sin_epsilon, ua * cos_epsilon);
    // M_21_15 = ua*sin(epsilon) + ub*cos(epsilon)
    let m_21_15 = ub.mul_add(cos_epsilon, ua * sin_epsilon);
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_1_12, zero, zero,
            zero, zero, zero, zero, zero, m_1_20, m_1_21,
        ],
        [
            m_2_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_2_13, zero,
            zero, zero, zero, zero, zero, m_2_20, m_2_21,
        ],
        [
            m_3_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_3_13, zero,
            zero, zero, zero, zero, zero, m_3_20, m_3_21,
        ],
        [
            m_4_1, m_4_2, m_4_3, m_4_4, m_4_5, m_4_6, m_4_7, zero, zero, zero, zero, m_4_12, m_4_13,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_5_1, m_5_2, m_5_3, m_5_4, m_5_5, m_5_6, m_5_7, zero, zero, zero, zero, m_5_12, m_5_13,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_6_1, m_6_2, m_6_3, m_6_4, m_6_5, m_6_6, m_6_7, zero, zero, zero, zero, m_6_12, m_6_13,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_7_1, m_7_2, m_7_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_7_18, m_7_19, zero, zero,
        ],
        [
            m_8_1, m_8_2, m_8_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_8_18, m_8_19, zero, zero,
        ],
        [
            m_9_1, m_9_2, m_9_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_9_18, m_9_19, zero, zero,
        ],
        [
            m_10_1, zero, zero, m_10_4, m_10_5, zero, zero, zero, zero, m_10_10, m_10_11, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_11_1, zero, zero, m_11_4, m_11_5, zero, zero, zero, zero, m_11_10, m_11_11, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_12_1, zero, zero, m_12_4, m_12_5, zero, zero, zero, zero, m_12_10, m_12_11, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_13_1, zero, zero, zero, zero, zero, zero, zero, zero, m_13_10, zero, zero, zero, zero,
            zero, m_13_16, m_13_17, zero, zero, zero, zero,
        ],
        [
            m_14_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_14_11, zero, zero, zero,
            zero, m_14_16, m_14_17, zero, zero, zero, zero,
        ],
        [
            m_15_1, zero, zero, zero, zero, zero, zero, zero, zero, m_15_10, m_15_11, zero, zero,
            zero, zero, m_15_16, m_15_17, zero, zero, zero, zero,
        ],
        [
            m_16_1, zero, zero, zero, zero, m_16_6, m_16_7, m_16_8, m_16_9, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_17_1, zero, zero, zero, zero, m_17_6, m_17_7, m_17_8, m_17_9, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_18_1, zero, zero, zero, zero, m_18_6, m_18_7, m_18_8, m_18_9, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_19_1, zero, zero, zero, zero, zero, zero, m_19_8, zero, zero, zero, zero, zero,
            m_19_14, m_19_15, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_20_1, zero, zero, zero, zero, zero, zero, zero, m_20_9, zero, zero, zero, zero,
            m_20_14, m_20_15, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_21_1, zero, zero, zero, zero, zero, zero, m_21_8, m_21_9, zero, zero, zero, zero,
            m_21_14, m_21_15, zero, zero, zero, zero, zero, zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (beta_rate', E3_force1, E3_force2, E4_force1, E4_force2, E6_force1, E6_force2, K6_force_k7_frame1, K6_force_k7_frame2, K4_force_k5_frame1, K4_force_k5_frame2, K2_force_k1_frame1, K2_force_k1_frame2, K7_force_n1, K7_force_n2, K5_force_n1, K5_force_n2, K3_force_n1, K3_force_n2, K1_force_n1, K1_force_n2).
///
/// 254 operations, 8 sines and cosines, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 7], u: &[S; 1]) -> [S; 21] {
    let Parameters {
        m1, m2, m3, m4, m5, m6, m7, I2, I3, I4, I5, I6, I7, xb, yb, xc, yc, c0, l0, d, da, e, ea,
        rr, ra, ss, sa, sb, sc, sd, ta, tb, zt,
        u: u_2,
        ua, ub, zf, fa, mom,
        ..
    } = *p;
    let [beta, theta, gamma, delta, phi, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_omega, cos_omega) = omega.sin_cos();
    // Shared terms.
    let m2_da = m2 * da;
    // beta + theta - gamma
    let f_4_of_place = beta + theta - gamma;
    let (sin_angle, cos_angle) = f_4_of_place.sin_cos();
    let cos_angle_inv = S::int(1) / cos_angle;
    let rr_beta_rate = rr * beta_rate;
    let f_4_of_beta_rate = cos_angle_inv * rr_beta_rate;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let f_4_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let f_4_of_beta_rate_2 = f_4_of_beta_rate * f_4_of_d_beta_gamma;
    let f_4_of_beta_rate_3 = m2 * beta_rate * rr_beta_rate;
    let ss_inv = S::int(1) / ss;
    let f_5_of_beta_rate = f_4_of_beta_rate * sin_theta;
    // cos_angle_inv*sin(beta + theta - gamma)*(f_4_of_d_beta_gamma - ss_inv*sin(theta))
    let f_5_of_place = cos_angle_inv * sin_angle
        * (-ss_inv).mul_add(sin_theta, f_4_of_d_beta_gamma);
    // ss_inv*f_5_of_beta_rate*sin(beta - gamma) + f_4_of_beta_rate*f_5_of_place*cos(beta - gamma)
    let f_5_of_beta_rate_2 = (f_4_of_beta_rate * f_5_of_place)
        .mul_add(cos_beta_minus_gamma, ss_inv * f_5_of_beta_rate * sin_beta_minus_gamma);
    // f_4_of_beta_rate*d_inv*(beta_rate*sin(beta - gamma) - f_5_of_beta_rate_2)
    let f_5_of_beta_rate_3 = f_4_of_beta_rate * d_inv
        * beta_rate.mul_add(sin_beta_minus_gamma, -f_5_of_beta_rate_2);
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let f_7_of_place = (-yb_minus_yc).mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    // xb_minus_xc*cos(gamma) + yb_minus_yc*sin(gamma)
    let f_7_of_place_2 = yb_minus_yc.mul_add(sin_gamma, xb_minus_xc * cos_gamma);
    // xb*(xb - 2*xc)
    let f_7_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let f_7_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // c0*(1 - l0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))/(xc^2 + xb*(xb
    //   - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*f_7_of_place) + sd*(sd + 2*f_7_of_place_2)))
    let f_7_of_place_3 = c0
        * (S::int(1)
            - l0
                * (xc_sq + f_7_of_xb_xc + yc_sq + f_7_of_yb_yc
                    + sc
                        * ((sin_gamma * xb_minus_xc).mul_add(S::int(2), sc)
                            - S::int(2) * cos_gamma * yb_minus_yc)
                    + sd
                        * ((sin_gamma * yb_minus_yc).mul_add(S::int(2), sd)
                            + S::int(2) * cos_gamma * xb_minus_xc))
                    .sqrt()
                / (xc_sq + f_7_of_xb_xc + yc_sq + f_7_of_yb_yc
                    + sc * f_7_of_place.mul_add(S::int(2), sc)
                    + sd * f_7_of_place_2.mul_add(S::int(2), sd)));
    let f_7_of_place_4 = f_7_of_place_2 * f_7_of_place_3;
    let f_5_of_beta_rate_sq = f_5_of_beta_rate * f_5_of_beta_rate;
    let f_7_of_beta_rate = ss_inv * f_5_of_beta_rate_sq;
    let m3_ss_inv = m3 * ss_inv;
    let sb_m3_ss_inv = sb * m3_ss_inv;
    // f_4_of_beta_rate*(beta_rate*cos(theta) - f_4_of_beta_rate*(f_4_of_d_beta_gamma*cos(theta) +
    //   f_5_of_place*sin(theta)))
    let f_7_of_beta_rate_2 = f_4_of_beta_rate
        * (-f_4_of_beta_rate * f_5_of_place.mul_add(sin_theta, f_4_of_d_beta_gamma * cos_theta)
            + beta_rate * cos_theta);
    let sa_m3_ss_inv = sa * m3_ss_inv;
    let f_8_of_place = f_7_of_place * f_7_of_place_3;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    // sin(gamma - delta)*cos(phi) - cos(gamma - delta)*sin(phi)
    let f_10_of_place = (-cos_gamma_minus_delta)
        .mul_add(sin_phi, sin_gamma_minus_delta * cos_phi);
    let cos_phi_inv = S::int(1) / cos_phi;
    let zt_inv_cos_phi_inv = cos_phi_inv / zt;
    let f_10_of_place_2 = f_10_of_place * zt_inv_cos_phi_inv;
    let f_10_of_beta_rate = f_5_of_beta_rate_sq * f_10_of_place_2;
    let m4_f_10_of_place = m4 * f_10_of_place;
    let sin_phi_cos_phi_inv = cos_phi_inv * sin_phi;
    let e_inv = S::int(1) / e;
    let f_10_of_place_3 = cos_phi_inv * cos_gamma_minus_delta;
    let e_inv_f_10_of_place_3 = e_inv * f_10_of_place_3;
    // f_5_of_beta_rate_sq*sin_phi_cos_phi_inv*e_inv_f_10_of_place_3 - f_7_of_beta_rate_2
    let f_10_of_beta_rate_2 = (f_5_of_beta_rate_sq * sin_phi_cos_phi_inv)
        .mul_add(e_inv_f_10_of_place_3, -f_7_of_beta_rate_2);
    // f_10_of_beta_rate*sin_phi_cos_phi_inv - f_10_of_beta_rate_2
    let f_10_of_beta_rate_3 = f_10_of_beta_rate
        .mul_add(sin_phi_cos_phi_inv, -f_10_of_beta_rate_2);
    // sin(gamma - delta)*sin(phi) + cos(gamma - delta)*cos(phi)
    let f_10_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi, sin_gamma_minus_delta * sin_phi);
    // cos(gamma - delta - phi)*(e_inv_f_10_of_place_3 - ss_inv)
    let f_10_of_place_5 = f_10_of_place_4 * (e_inv_f_10_of_place_3 - ss_inv);
    // sin(gamma - delta - phi)*f_10_of_beta_rate_3 + f_5_of_beta_rate_sq*f_10_of_place_5
    let f_10_of_beta_rate_4 = f_5_of_beta_rate_sq
        .mul_add(f_10_of_place_5, f_10_of_place * f_10_of_beta_rate_3);
    // 1 - ea*e_inv
    let f_10_of_e_ea = (-ea).mul_add(e_inv, S::int(1));
    // cos_phi_inv*(f_5_of_beta_rate_sq*sin(gamma - delta)*(ss_inv - f_10_of_place_2) +
    //   f_10_of_beta_rate_3*cos(gamma - delta))
    let f_10_of_beta_rate_5 = cos_phi_inv
        * (f_5_of_beta_rate_sq * sin_gamma_minus_delta * (ss_inv - f_10_of_place_2)
            + f_10_of_beta_rate_3 * cos_gamma_minus_delta);
    let f_13_of_beta_rate = zt_inv_cos_phi_inv * f_10_of_beta_rate_4;
    let m5_tb = m5 * tb;
    let m5_ta = m5 * ta;
    let f_13_of_beta_rate_2 = f_10_of_place_2 * f_10_of_beta_rate;
    let zf_inv = S::int(1) / zf;
    // 1 - fa*zf_inv
    let f_16_of_zf_fa = (-fa).mul_add(zf_inv, S::int(1));
    let cos_omega_inv = S::int(1) / cos_omega;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    let f_16_of_place = cos_omega_inv * sin_gamma_minus_epsilon;
    let zf_inv_f_16_of_place = zf_inv * f_16_of_place;
    // sin(gamma - epsilon)*cos(omega) - cos(gamma - epsilon)*sin(omega)
    let f_16_of_place_2 = (-cos_gamma_minus_epsilon)
        .mul_add(sin_omega, sin_gamma_minus_epsilon * cos_omega);
    // sin(gamma - epsilon - omega)*(zf_inv_f_16_of_place - ss_inv)
    let f_16_of_place_3 = f_16_of_place_2 * (zf_inv_f_16_of_place - ss_inv);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // f_5_of_beta_rate_sq*zf_inv_f_16_of_place*sin_omega_cos_omega_inv - f_7_of_beta_rate_2
    let f_16_of_beta_rate = (f_5_of_beta_rate_sq * zf_inv_f_16_of_place)
        .mul_add(sin_omega_cos_omega_inv, -f_7_of_beta_rate_2);
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let f_16_of_place_4 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let m6_f_16_of_place_4 = m6 * f_16_of_place_4;
    let u_2_inv_cos_omega_inv = cos_omega_inv / u_2;
    let f_17_of_place = f_16_of_place_4 * u_2_inv_cos_omega_inv;
    let f_17_of_beta_rate = f_5_of_beta_rate_sq * f_17_of_place;
    // sin_omega_cos_omega_inv*f_17_of_beta_rate - f_16_of_beta_rate
    let f_17_of_beta_rate_2 = sin_omega_cos_omega_inv
        .mul_add(f_17_of_beta_rate, -f_16_of_beta_rate);
    // f_5_of_beta_rate_sq*f_16_of_place_3 - cos(gamma - epsilon - omega)*f_17_of_beta_rate_2
    let f_17_of_beta_rate_3 = (-f_16_of_place_4)
        .mul_add(f_17_of_beta_rate_2, f_5_of_beta_rate_sq * f_16_of_place_3);
    // cos_omega_inv*(f_17_of_beta_rate_2*sin(gamma - epsilon) - f_5_of_beta_rate_sq*cos(gamma -
    //   epsilon)*(ss_inv - f_17_of_place))
    let f_17_of_beta_rate_4 = cos_omega_inv
        * (-f_5_of_beta_rate_sq * cos_gamma_minus_epsilon * (ss_inv - f_17_of_place)
            + f_17_of_beta_rate_2 * sin_gamma_minus_epsilon);
    let f_19_of_beta_rate = u_2_inv_cos_omega_inv * f_17_of_beta_rate_3;
    let m7_ua = m7 * ua;
    let m7_ub = m7 * ub;
    let f_19_of_beta_rate_2 = f_17_of_place * f_17_of_beta_rate;
    // Values.
    // f_1 = m1*ra*beta_rate^2
    let f_1 = m1 * ra * beta_rate * beta_rate;
    // f_3 = mom
    let f_3 = mom;
    // f_4 = m2*rr*beta_rate^2*(cos(theta) - da*rr*cos(beta - gamma)^2/(d^2*cos(beta + theta - gamma)^2))
    let f_4 = f_4_of_beta_rate_3
        .mul_add(cos_theta, -m2_da * f_4_of_beta_rate_2 * f_4_of_beta_rate_2);
    // f_5 = -m2*rr*beta_rate^2*(sin(theta) + da*(sin(beta - gamma) - rr*(cos(beta - gamma)^2*tan(beta +
    //   theta - gamma)/d + sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
    //   theta))/ss)/cos(beta + theta - gamma))/(d*cos(beta + theta - gamma)))
    let f_5 = (-m2_da).mul_add(f_5_of_beta_rate_3, -f_4_of_beta_rate_3 * sin_theta);
    // f_6 = I2*rr*beta_rate^2*(sin(beta - gamma) - rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d +
    //   sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta -
    //   gamma))/(d*cos(beta + theta - gamma))
    let f_6 = I2 * f_5_of_beta_rate_3;
    // f_7 = c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sd +
    //   sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) +
    //   sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd + sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)))/(xc^2 + xb*(xb - 2*xc)
    //   + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))) + m3*rr*beta_rate^2*(sa*cos(theta) -
    //   rr*(sa*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta) +
    //   sin(theta)*tan(beta + theta - gamma))/d) - sb*sin(theta)^2/ss)/cos(beta + theta -
    //   gamma))/(ss*cos(beta + theta - gamma))
    let f_7 = (-sd).mul_add(f_7_of_place_3, f_7_of_beta_rate * sb_m3_ss_inv)
        - f_7_of_place_4 + f_7_of_beta_rate_2 * sa_m3_ss_inv;
    // f_8 = c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sqrt(xc^2 +
    //   xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) +
    //   sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sc + sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb)) - l0*(sc + sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)))/(xc^2 + xb*(xb -
    //   2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))) + m3*rr*beta_rate^2*(sb*cos(theta) -
    //   rr*(sa*sin(theta)^2/ss + sb*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta -
    //   gamma)*(cos(theta) + sin(theta)*tan(beta + theta - gamma))/d))/cos(beta + theta -
    //   gamma))/(ss*cos(beta + theta - gamma))
    let f_8 = sb_m3_ss_inv.mul_add(f_7_of_beta_rate_2, sc * f_7_of_place_3)
        - f_7_of_beta_rate * sa_m3_ss_inv + f_8_of_place;
    // f_9 = c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma))
    //   + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb
    //   - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))) - l0)*(yb - yc
    //   + sd*sin(gamma) - sc*cos(gamma))*(sin(gamma)*(sa - sc) + cos(gamma)*(sb - sd))/((xb - xc)^2 + (yb -
    //   yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
    //   sc*cos(gamma))) + c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) +
    //   sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(l0 - sqrt((xb - xc)^2 + (yb - yc)^2 +
    //   sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
    //   sc*cos(gamma))))*(xb - xc + sc*sin(gamma) + sd*cos(gamma))*(sin(gamma)*(sb - sd) + cos(gamma)*(sc -
    //   sa))/((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb
    //   - yc)*(sd*sin(gamma) - sc*cos(gamma))) + I3*rr*beta_rate^2*cos(theta)*(cos(beta + theta - gamma) -
    //   rr*cos(beta - gamma)/d)/(ss*cos(beta + theta - gamma)^2) + I3*rr*beta_rate*sin(theta)*tan(gamma -
    //   beta - theta)*(beta_rate - rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma)) +
    //   beta_rate*(rr*cos(beta - gamma)/d - cos(beta + theta - gamma))/cos(beta + theta -
    //   gamma))/(ss*cos(beta + theta - gamma))
    let f_9 = f_7_of_place_3 * (-sb).mul_add(sc, sa * sd)
        * cos_gamma.mul_add(cos_gamma, sin_gamma * sin_gamma)
        + f_7_of_place_4 * (sa - sc) + I3 * ss_inv * f_7_of_beta_rate_2 + f_8_of_place * (sd - sb);
    // f_10 = m4*rr*beta_rate^2*(cos(theta)*(sin(phi)*sin(gamma - delta - phi) - cos(gamma - delta)*(ea/e -
    //   1)) + rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)*(ea/e - 1) - sin(phi)*sin(gamma - delta -
    //   phi))/d + sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)*(ea/e - 1) -
    //   sin(phi)*sin(gamma - delta - phi))/d + sin(theta)*((sin(gamma - delta) + cos(gamma - delta)*tan(beta
    //   + theta - gamma) - ea*(sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/e)/ss +
    //   sin(phi)*((cos(gamma - delta)*cos(gamma - delta - phi)/e + (sin(phi)*sin(gamma - delta - phi)^2/zt +
    //   cos(gamma - delta)*(sin(gamma - delta - phi)/zt - (cos(gamma - delta) + sin(phi)*sin(gamma - delta -
    //   phi) + ea*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e))/e))/cos(phi))/cos(phi) - (sin(gamma
    //   - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss) + sin(gamma - delta -
    //   phi)*(sin(gamma - delta - phi) + sin(gamma - delta)*(ea/e - 1)/cos(phi))/zt)))/cos(beta + theta -
    //   gamma))/(cos(beta + theta - gamma)*cos(phi))
    let f_10 = m4
        * f_10_of_e_ea
            .mul_add(f_10_of_beta_rate_5, sin_phi_cos_phi_inv * f_10_of_beta_rate_4)
        + f_10_of_beta_rate * m4_f_10_of_place;
    // f_11 = m4*rr*beta_rate^2*(cos(theta)*sin(gamma - delta - phi) - rr*(cos(theta)*cos(beta -
    //   gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(beta
    //   + theta - gamma)/d + sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss - cos(gamma - delta)*(cos(gamma - delta - phi) + (cos(gamma - delta)*(ea/e - 1) -
    //   sin(phi)*sin(gamma - delta - phi))/cos(phi))/(e*cos(phi)))))/cos(beta + theta - gamma))/cos(beta +
    //   theta - gamma)
    let f_11 = m4 * f_5_of_beta_rate_sq
        * (-(f_10_of_place_3 * e_inv_f_10_of_place_3))
            .mul_add(f_10_of_e_ea, f_10_of_place_5) - m4_f_10_of_place * f_10_of_beta_rate_2;
    // f_12 = I4*rr*beta_rate^2*(cos(theta)*cos(gamma - delta) - rr*(cos(theta)*cos(beta - gamma)*cos(gamma
    //   - delta)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - delta)*tan(beta + theta - gamma)/d +
    //   sin(theta)*((cos(gamma - delta)^2*tan(phi)/e + sin(gamma - delta - phi)*(sin(gamma - delta) -
    //   cos(gamma - delta)*tan(phi))/zt)/cos(phi) - (sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/ss)))/cos(beta + theta - gamma))/(e*cos(beta + theta - gamma)*cos(phi))
    let f_12 = I4 * e_inv * f_10_of_beta_rate_5;
    // f_13 = m5*rr*beta_rate^2*(tb*cos(theta)*sin(gamma - delta - phi) - rr*(tb*(cos(theta)*cos(beta -
    //   gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(beta
    //   + theta - gamma)/d + sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss - (sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta -
    //   phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi)))) - ta*sin(theta)^2*sin(gamma - delta -
    //   phi)^2/(zt*cos(phi)))/cos(beta + theta - gamma))/(zt*cos(beta + theta - gamma)*cos(phi))
    let f_13 = m5_ta.mul_add(f_13_of_beta_rate_2, f_13_of_beta_rate * m5_tb);
    // f_14 = m5*rr*beta_rate^2*(ta*cos(theta)*sin(gamma - delta - phi) - rr*(tb*sin(theta)^2*sin(gamma -
    //   delta - phi)^2/(zt*cos(phi)) + ta*(cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d +
    //   sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(beta + theta - gamma)/d +
    //   sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss -
    //   (sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma -
    //   delta - phi)*tan(phi))/e)/cos(phi)))))/cos(beta + theta - gamma))/(zt*cos(beta + theta -
    //   gamma)*cos(phi))
    let f_14 = (-m5_tb).mul_add(f_13_of_beta_rate_2, f_13_of_beta_rate * m5_ta);
    // f_15 = I5*rr*beta_rate^2*(cos(theta)*sin(gamma - delta - phi) - rr*(cos(theta)*cos(beta -
    //   gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(beta
    //   + theta - gamma)/d + sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma -
    //   delta - phi))/ss - (sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta -
    //   phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi))))/cos(beta + theta - gamma))/(zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let f_15 = I5 * f_13_of_beta_rate;
    // f_16 = m6*rr*beta_rate^2*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta -
    //   gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)/d + sin(theta)*(sin(gamma - epsilon)*(sin(gamma - epsilon - omega)
    //   + (sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega))/cos(omega))/(zf*cos(omega)) - (sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma))/ss)))/cos(beta + theta - gamma))/cos(beta + theta - gamma)
    let f_16 = m6 * f_5_of_beta_rate_sq
        * (f_16_of_zf_fa * f_16_of_place).mul_add(zf_inv_f_16_of_place, -f_16_of_place_3)
        - f_16_of_beta_rate * m6_f_16_of_place_4;
    // f_17 = -m6*rr*beta_rate^2*(cos(theta)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma -
    //   epsilon - omega)) + rr*(sin(theta)*(cos(beta - gamma)*tan(gamma - beta - theta)*(sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega))/d + sin(theta)*((sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon))/zf)/ss + sin(omega)*((sin(gamma - epsilon - omega) + cos(gamma
    //   - epsilon - omega)*tan(beta + theta - gamma))/ss - (sin(gamma - epsilon)*sin(gamma - epsilon -
    //   omega)/zf + (sin(gamma - epsilon)*(cos(gamma - epsilon - omega)/u + (sin(omega)*cos(gamma - epsilon
    //   - omega) - sin(gamma - epsilon) - fa*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf))/zf)
    //   - sin(omega)*cos(gamma - epsilon - omega)^2/u)/cos(omega))/cos(omega)) + cos(gamma - epsilon -
    //   omega)*(cos(gamma - epsilon)*(fa/zf - 1)/cos(omega) + cos(gamma - epsilon - omega))/u)) -
    //   cos(theta)*cos(beta - gamma)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega))/d)/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(omega))
    let f_17 = m6
        * f_16_of_zf_fa
            .mul_add(f_17_of_beta_rate_4, sin_omega_cos_omega_inv * f_17_of_beta_rate_3)
        - m6_f_16_of_place_4 * f_17_of_beta_rate;
    // f_18 = I6*rr*beta_rate^2*(cos(theta)*sin(gamma - epsilon) + rr*(sin(theta)*(cos(beta -
    //   gamma)*sin(gamma - epsilon)*tan(gamma - beta - theta)/d + sin(theta)*((cos(gamma - epsilon -
    //   omega)*(cos(gamma - epsilon) + sin(gamma - epsilon)*tan(omega))/u - sin(gamma -
    //   epsilon)^2*tan(omega)/zf)/cos(omega) - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon))/ss)) - cos(theta)*cos(beta - gamma)*sin(gamma - epsilon)/d)/cos(beta + theta -
    //   gamma))/(zf*cos(beta + theta - gamma)*cos(omega))
    let f_18 = I6 * zf_inv * f_17_of_beta_rate_4;
    // f_19 = m7*rr*beta_rate^2*(ua*cos(theta)*cos(gamma - epsilon - omega) - rr*(ua*(cos(theta)*cos(beta -
    //   gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)/d - sin(theta)*((sin(gamma - epsilon - omega) + cos(gamma - epsilon
    //   - omega)*tan(beta + theta - gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - sin(gamma -
    //   epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/zf)/cos(omega))))
    //   - ub*sin(theta)^2*cos(gamma - epsilon - omega)^2/(u*cos(omega)))/cos(beta + theta -
    //   gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let f_19 = (-f_19_of_beta_rate).mul_add(m7_ua, m7_ub * f_19_of_beta_rate_2);
    // f_20 = m7*rr*beta_rate^2*(ub*cos(theta)*cos(gamma - epsilon - omega) - rr*(ua*sin(theta)^2*cos(gamma
    //   - epsilon - omega)^2/(u*cos(omega)) + ub*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon -
    //   omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d -
    //   sin(theta)*((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - sin(gamma - epsilon)*(sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/zf)/cos(omega)))))/cos(beta + theta -
    //   gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let f_20 = (-m7_ua).mul_add(f_19_of_beta_rate_2, -f_19_of_beta_rate * m7_ub);
    // f_21 = I7*rr*beta_rate^2*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta -
    //   gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)/d - sin(theta)*((sin(gamma - epsilon - omega) + cos(gamma - epsilon
    //   - omega)*tan(beta + theta - gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - sin(gamma -
    //   epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(omega))/zf)/cos(omega))))/cos(beta + theta - gamma))/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let f_21 = -I7 * f_19_of_beta_rate;
    let zero = S::int(0);
    [
        f_1, zero, f_3, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13, f_14, f_15, f_16,
        f_17, f_18, f_19, f_20, f_21,
    ]
}

/// The accelerations (beta_rate'), solved for when this code was generated.
///
/// 444 operations, 8 sines and cosines, 1 other function.
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
    let d1_of_place_2 = cos_gamma_minus_delta * sin_phi;
    // sin(gamma - delta)*cos(phi) - d1_of_place_2
    let d1_of_place_3 = sin_gamma_minus_delta.mul_add(cos_phi, -d1_of_place_2);
    let sin_phi_d1_of_place_3 = d1_of_place_3 * sin_phi;
    let d1_of_place_4 = S::int(2) * sin_phi_d1_of_place_3;
    let d1_of_place_3_sq = d1_of_place_3 * d1_of_place_3;
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
    // 2 - fa_zf_inv
    let d1_of_zf_fa = S::int(2) - fa_zf_inv;
    // -d1_of_zf_fa
    let minus_d1_of_zf_fa = -d1_of_zf_fa;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    let d1_of_place_7 = sin_gamma_minus_epsilon * sin_omega;
    // cos(gamma - epsilon)*cos(omega) + d1_of_place_7
    let d1_of_place_8 = cos_gamma_minus_epsilon.mul_add(cos_omega, d1_of_place_7);
    let sin_omega_d1_of_place_8 = d1_of_place_8 * sin_omega;
    let d1_of_place_9 = S::int(2) * sin_omega_d1_of_place_8;
    let d1_of_place_8_sq = d1_of_place_8 * d1_of_place_8;
    let d1_of_place_10 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_11 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_11 = u_2_inv * d1_of_place_11;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // cos_phi_inv_sq*(m4*(cos(gamma - delta)*(cos(gamma - delta) + d1_of_place_4 +
    //   ea_e_inv*(d1_of_e_ea*cos(gamma - delta) - d1_of_place_4)) + d1_of_place_3_sq) + I4*d1_of_place_5^2 +
    //   d1_of_place_3_sq*zt_inv_d1_of_place_6) + cos_omega_inv_sq*(m6*(sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - d1_of_place_9 + fa_zf_inv*(minus_d1_of_zf_fa*sin(gamma - epsilon) + d1_of_place_9)) +
    //   d1_of_place_8_sq) + I6*d1_of_place_10^2 + d1_of_place_8_sq*u_2_inv_d1_of_place_11)
    let d1_of_place_12 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (cos_gamma_minus_delta + d1_of_place_4
                    + ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, -d1_of_place_4))
                + d1_of_place_3_sq) + I4 * d1_of_place_5 * d1_of_place_5
            + d1_of_place_3_sq * zt_inv_d1_of_place_6)
        + cos_omega_inv_sq
            * (m6
                * (sin_gamma_minus_epsilon
                    * (sin_gamma_minus_epsilon - d1_of_place_9
                        + fa_zf_inv
                            * minus_d1_of_zf_fa
                                .mul_add(sin_gamma_minus_epsilon, d1_of_place_9))
                    + d1_of_place_8_sq) + I6 * d1_of_place_10 * d1_of_place_10
                + d1_of_place_8_sq * u_2_inv_d1_of_place_11);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_13 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_13 = ss_inv * d1_of_place_13;
    // d1_of_place_12 + ss_inv_d1_of_place_13
    let d1_of_place_14 = d1_of_place_12 + ss_inv_d1_of_place_13;
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
    //   2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma -
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
                        * (d1_of_place_14 * sin_theta * sin_theta
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
    let d1_of_place_3_doubled = S::int(2) * d1_of_place_3;
    let beta_rate_dot_of_place_3 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + beta_rate_dot_of_place_3
    let beta_rate_dot_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi, beta_rate_dot_of_place_3);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    let m4_beta_rate_dot_of_e_ea = m4 * beta_rate_dot_of_e_ea;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let beta_rate_dot_of_place_5 = d1_of_place_3
        .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_of_place_4);
    // -beta_rate_dot_of_place_5
    let beta_rate_dot_of_place_6 = -beta_rate_dot_of_place_5;
    let beta_rate_dot_of_place_7 = ss_inv * sin_angle_cos_angle_inv;
    let beta_rate_dot_of_place_8 = S::int(2) * beta_rate_dot_of_place_7;
    let beta_rate_dot_of_gamma_delta = S::int(2) * cos_gamma_minus_delta;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_9 = cos_phi_inv * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_10 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_of_place_11 = beta_rate_dot_of_place_4 * sin_phi;
    let beta_rate_dot_of_place_12 = beta_rate_dot_of_place_9 * sin_phi;
    let i6_zf_inv = I6 * zf_inv;
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = minus_d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let d1_of_place_8_doubled = S::int(2) * d1_of_place_8;
    let beta_rate_dot_of_place_13 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_of_place_13
    let beta_rate_dot_of_place_14 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_of_place_13);
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let beta_rate_dot_of_m6_zf_fa = m6 * beta_rate_dot_of_zf_fa;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_15 = d1_of_place_8
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_14);
    let beta_rate_dot_of_place_16 = S::int(2) * sin_gamma_minus_epsilon;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_17 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_18 = beta_rate_dot_of_place_14 * sin_omega;
    let beta_rate_dot_of_place_19 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_20 = beta_rate_dot_of_place_19 * sin_omega;
    let beta_rate_dot_of_place_21 = zf_inv * beta_rate_dot_of_place_20;
    let beta_rate_dot_of_place_22 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_23 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - d1_of_d_beta_gamma*beta_rate_dot_of_place_22*rr_cos_angle_inv
    let beta_rate_dot_of_place_24 = (-(d1_of_d_beta_gamma * beta_rate_dot_of_place_22))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_25 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
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
    //   2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(1 - ea/e) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + (2*m4*ea*sin(gamma - delta - phi) +
    //   sin(phi)*(sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt - cos(gamma - delta)*(I4/e +
    //   m4*ea*(ea/e - 2))))/cos(phi))/e + m4*(sin(gamma - delta) - (cos(gamma - delta)*sin(phi) +
    //   2*sin(gamma - delta - phi))/cos(phi))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi)
    //   + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt -
    //   m4*((cos(gamma - delta)*(cos(gamma - delta) + (cos(gamma - delta - phi) + (2*cos(gamma -
    //   delta)*(ea/e - 1) - sin(phi)*sin(gamma - delta - phi))/cos(phi))/cos(phi) - ea*(cos(gamma - delta)/e
    //   + 2*sin(phi)*tan(beta + theta - gamma)/ss)) - ea*sin(gamma - delta)*sin(phi)/ss)/e +
    //   (sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) - sin(gamma - delta
    //   - phi)*tan(gamma - beta - theta) - cos(gamma - delta - phi))/ss)) + cos(gamma -
    //   delta)*(m4*((ea*((cos(gamma - delta)*(ea*tan(gamma - beta - theta)/ss + tan(phi)*(cos(gamma -
    //   delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))) - ea*sin(gamma - delta)/ss)/e + (2*sin(gamma
    //   - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) +
    //   cos(gamma - delta)*tan(phi)*(cos(gamma - delta)/cos(phi) - cos(gamma - delta - phi)))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - sin(gamma - delta) - cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + I4*(cos(gamma - delta)^2*tan(phi)/(e*cos(phi)) - (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss)/e^2))/cos(phi)^2 + (cos(gamma - epsilon -
    //   omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(fa/zf - 1) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + (sin(omega)*(cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - sin(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))) - 2*m6*fa*cos(gamma - epsilon - omega))/cos(omega))/zf -
    //   m6*(cos(gamma - epsilon) + (sin(gamma - epsilon)*sin(omega) - 2*cos(gamma - epsilon -
    //   omega))/cos(omega))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1)
    //   + cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) + (sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))/cos(omega) - fa*(sin(gamma - epsilon)/zf +
    //   2*sin(omega)*tan(beta + theta - gamma)/ss)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) +
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta +
    //   theta - gamma)) - cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma
    //   - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 -
    //   ea/e) + 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 +
    //   xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) +
    //   sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb -
    //   2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_25 * (l0 - beta_rate_dot_of_place_25)
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
                                                    * (d1_of_place_3
                                                        * (zt_inv
                                                            * (cos_phi_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (e_inv
                                                                        * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                            - beta_rate_dot_of_place_4 * d1_of_place_6
                                                                            + cos_phi_inv
                                                                                * (-sin_phi
                                                                                    * (-d1_of_place_3)
                                                                                        .mul_add(
                                                                                            d1_of_place_6,
                                                                                            beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta,
                                                                                        ) + m4_ea * d1_of_place_3_doubled))
                                                                        + m4
                                                                            * (sin_gamma_minus_delta
                                                                                - cos_phi_inv * (d1_of_place_2 + d1_of_place_3_doubled)))
                                                                    - sin_phi_d1_of_place_3
                                                                        * (d1_of_place_3 * cos_phi_inv * (m4 + zt_inv_d1_of_place_6)
                                                                            + m4_beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                - d1_of_place_3 * m4_beta_rate_dot_of_e_ea
                                                                    * cos_gamma_minus_delta
                                                                + zt_inv * ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_6,
                                                                            I5 * beta_rate_dot_of_place_6,
                                                                        ))
                                                            - m4
                                                                * (ss_inv
                                                                    * (beta_rate_dot_of_place_5
                                                                        + sin_phi
                                                                            * sin_angle_cos_angle_inv
                                                                                .mul_add(
                                                                                    beta_rate_dot_of_gamma_delta,
                                                                                    sin_gamma_minus_delta,
                                                                                ))
                                                                    + e_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (cos_gamma_minus_delta
                                                                                - ea
                                                                                    * beta_rate_dot_of_place_8.mul_add(sin_phi, d1_of_place_5)
                                                                                + cos_phi_inv
                                                                                    * (beta_rate_dot_of_place_4
                                                                                        + cos_phi_inv
                                                                                            * beta_rate_dot_of_e_ea
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_of_gamma_delta,
                                                                                                    -sin_phi_d1_of_place_3,
                                                                                                ))) - beta_rate_dot_of_place_3 * ea_ss_inv)))
                                                        + cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        beta_rate_dot_of_place_10,
                                                                        e_inv * beta_rate_dot_of_place_9 * beta_rate_dot_of_place_12,
                                                                    )
                                                                + m4
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_11 - beta_rate_dot_of_place_10)
                                                                        + e_inv
                                                                            * (ea
                                                                                * (e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * (cos_phi_inv * sin_phi
                                                                                            * d1_of_e_ea
                                                                                                .mul_add(beta_rate_dot_of_place_9, beta_rate_dot_of_place_4)
                                                                                            - ea * beta_rate_dot_of_place_7)
                                                                                        - ea_ss_inv * sin_gamma_minus_delta)
                                                                                    + ss_inv
                                                                                        * beta_rate_dot_of_place_10
                                                                                            .mul_add(S::int(2), -beta_rate_dot_of_place_11))
                                                                                + beta_rate_dot_of_place_12
                                                                                    * (beta_rate_dot_of_place_9 - beta_rate_dot_of_place_4)))))
                                                    - ss_inv_d1_of_place_13 * beta_rate_dot_of_place_7
                                                    - cos_omega_inv_sq
                                                        * (d1_of_place_8
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - beta_rate_dot_of_place_14 * d1_of_place_11
                                                                                + cos_omega_inv
                                                                                    * (sin_omega
                                                                                        * (-d1_of_place_8)
                                                                                            .mul_add(
                                                                                                d1_of_place_11,
                                                                                                beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon,
                                                                                            ) + m6_fa * d1_of_place_8_doubled))
                                                                            + m6
                                                                                * (cos_gamma_minus_epsilon
                                                                                    + cos_omega_inv * (d1_of_place_7 - d1_of_place_8_doubled)))
                                                                        + sin_omega_d1_of_place_8
                                                                            * (d1_of_place_8 * cos_omega_inv
                                                                                * (m6 + u_2_inv_d1_of_place_11)
                                                                                + beta_rate_dot_of_m6_zf_fa * cos_gamma_minus_epsilon))
                                                                    - d1_of_place_8 * beta_rate_dot_of_m6_zf_fa
                                                                        * sin_gamma_minus_epsilon
                                                                    + u_2_inv * ss_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_15,
                                                                                I7 * beta_rate_dot_of_place_15,
                                                                            ))
                                                                + m6
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_15
                                                                            + sin_omega
                                                                                * (-sin_angle_cos_angle_inv)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_of_place_16,
                                                                                        cos_gamma_minus_epsilon,
                                                                                    ))
                                                                        - zf_inv
                                                                            * (sin_gamma_minus_epsilon
                                                                                * (sin_gamma_minus_epsilon
                                                                                    - fa
                                                                                        * beta_rate_dot_of_place_8
                                                                                            .mul_add(sin_omega, d1_of_place_10)
                                                                                    + cos_omega_inv
                                                                                        * (beta_rate_dot_of_place_14
                                                                                            + cos_omega_inv
                                                                                                * beta_rate_dot_of_zf_fa
                                                                                                    .mul_add(
                                                                                                        beta_rate_dot_of_place_16,
                                                                                                        sin_omega_d1_of_place_8,
                                                                                                    ))) + fa * ss_inv * beta_rate_dot_of_place_13)))
                                                            + sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (zf_inv
                                                                        * (beta_rate_dot_of_place_20
                                                                            * (beta_rate_dot_of_place_14 - beta_rate_dot_of_place_19)
                                                                            + fa
                                                                                * (ss_inv
                                                                                    * d1_of_zf_fa
                                                                                        .mul_add(
                                                                                            beta_rate_dot_of_place_17,
                                                                                            beta_rate_dot_of_place_18,
                                                                                        )
                                                                                    - beta_rate_dot_of_place_21
                                                                                        * minus_d1_of_zf_fa
                                                                                            .mul_add(
                                                                                                beta_rate_dot_of_place_19,
                                                                                                beta_rate_dot_of_place_14,
                                                                                            )))
                                                                        - ss_inv
                                                                            * (beta_rate_dot_of_place_17 + beta_rate_dot_of_place_18))
                                                                    - zf_inv * i6_zf_inv
                                                                        * beta_rate_dot_of_place_19
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_21,
                                                                                ss_inv * beta_rate_dot_of_place_17,
                                                                            ))))
                                                + d1_of_place_14 * d1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            + d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (d1_of_place_12
                                                        + ss_inv * m2_da.mul_add(sin_angle, d1_of_place_13))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_22)))
                                        + m2_da * d_inv
                                            * (-ss_inv)
                                                .mul_add(
                                                    beta_rate_dot_of_place_23,
                                                    d1_of_d_beta_gamma * cos_beta_minus_gamma,
                                                )) + d1_of_place_14 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_24,
                                    rr * beta_rate_dot_of_place_22 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_24)
                        - m2_da * beta_rate_dot_of_place_23))) / d1;
    [beta_rate_dot]
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
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) +
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 467 operations, 8 sines and cosines, 1 other function.
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
    let d1_of_place_2 = cos_gamma_minus_delta * sin_phi;
    // sin(gamma - delta)*cos(phi) - d1_of_place_2
    let d1_of_place_3 = sin_gamma_minus_delta.mul_add(cos_phi, -d1_of_place_2);
    let sin_phi_d1_of_place_3 = d1_of_place_3 * sin_phi;
    let d1_of_place_4 = S::int(2) * sin_phi_d1_of_place_3;
    let d1_of_place_5 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    let d1_of_place_3_zt_inv = d1_of_place_3 * zt_inv;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // I5 + m5*ta_sq_plus_tb_sq
    let d1_of_m5_i5_ta_tb = m5.mul_add(ta_sq_plus_tb_sq, I5);
    let d1_of_place_6 = d1_of_place_3_zt_inv * d1_of_m5_i5_ta_tb;
    let cos_phi_inv = S::int(1) / cos_phi;
    let cos_phi_inv_sq = cos_phi_inv * cos_phi_inv;
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
    let d1_of_place_7 = sin_gamma_minus_epsilon * sin_omega;
    // cos(gamma - epsilon)*cos(omega) + d1_of_place_7
    let d1_of_place_8 = cos_gamma_minus_epsilon.mul_add(cos_omega, d1_of_place_7);
    let sin_omega_d1_of_place_8 = d1_of_place_8 * sin_omega;
    let d1_of_place_9 = S::int(2) * sin_omega_d1_of_place_8;
    let d1_of_place_10 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    let d1_of_place_8_u_2_inv = d1_of_place_8 * u_2_inv;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // I7 + m7*ua_sq_plus_ub_sq
    let d1_of_m7_i7_ua_ub = m7.mul_add(ua_sq_plus_ub_sq, I7);
    let d1_of_place_11 = d1_of_place_8_u_2_inv * d1_of_m7_i7_ua_ub;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // cos_phi_inv_sq*(m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   d1_of_place_4 + ea_e_inv*(d1_of_e_ea*cos(gamma - delta) - d1_of_place_4))) + I4*d1_of_place_5^2 +
    //   d1_of_place_3_zt_inv*d1_of_place_6) + cos_omega_inv_sq*(m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - d1_of_place_9 + fa_zf_inv*(minus_d1_of_zf_fa*sin(gamma
    //   - epsilon) + d1_of_place_9))) + I6*d1_of_place_10^2 + d1_of_place_8_u_2_inv*d1_of_place_11)
    let d1_of_place_12 = cos_phi_inv_sq
        * (m4
            * (cos_gamma_minus_delta
                * (cos_gamma_minus_delta + d1_of_place_4
                    + ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, -d1_of_place_4))
                + d1_of_place_3 * d1_of_place_3) + I4 * d1_of_place_5 * d1_of_place_5
            + d1_of_place_3_zt_inv * d1_of_place_6)
        + cos_omega_inv_sq
            * (m6
                * (sin_gamma_minus_epsilon
                    * (sin_gamma_minus_epsilon - d1_of_place_9
                        + fa_zf_inv
                            * minus_d1_of_zf_fa
                                .mul_add(sin_gamma_minus_epsilon, d1_of_place_9))
                    + d1_of_place_8 * d1_of_place_8) + I6 * d1_of_place_10 * d1_of_place_10
                + d1_of_place_8_u_2_inv * d1_of_place_11);
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_13 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_13 = ss_inv * d1_of_place_13;
    // d1_of_place_12 + ss_inv_d1_of_place_13
    let d1_of_place_14 = d1_of_place_12 + ss_inv_d1_of_place_13;
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
    //   2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma -
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
                        * (d1_of_place_14 * sin_theta * sin_theta
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
    let d1_of_place_3_doubled = S::int(2) * d1_of_place_3;
    let beta_rate_dot_of_place_3 = sin_gamma_minus_delta * sin_phi;
    // cos(gamma - delta)*cos(phi) + beta_rate_dot_of_place_3
    let beta_rate_dot_of_place_4 = cos_gamma_minus_delta
        .mul_add(cos_phi, beta_rate_dot_of_place_3);
    let zt_inv_d1_of_m5_i5_ta_tb = zt_inv * d1_of_m5_i5_ta_tb;
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    let m4_beta_rate_dot_of_e_ea = m4 * beta_rate_dot_of_e_ea;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - delta - phi)*sin_angle_cos_angle_inv - cos(gamma - delta - phi)
    let beta_rate_dot_of_place_5 = d1_of_place_3
        .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_of_place_4);
    // -beta_rate_dot_of_place_5
    let beta_rate_dot_of_place_6 = -beta_rate_dot_of_place_5;
    let beta_rate_dot_of_place_7 = ss_inv * sin_angle_cos_angle_inv;
    let beta_rate_dot_of_place_8 = S::int(2) * beta_rate_dot_of_place_7;
    let beta_rate_dot_of_gamma_delta = S::int(2) * cos_gamma_minus_delta;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_9 = cos_phi_inv * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_10 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_of_place_11 = beta_rate_dot_of_place_4 * sin_phi;
    let beta_rate_dot_of_place_12 = beta_rate_dot_of_place_9 * sin_phi;
    let i6_zf_inv = I6 * zf_inv;
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = minus_d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let d1_of_place_8_doubled = S::int(2) * d1_of_place_8;
    let beta_rate_dot_of_place_13 = cos_gamma_minus_epsilon * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - beta_rate_dot_of_place_13
    let beta_rate_dot_of_place_14 = sin_gamma_minus_epsilon
        .mul_add(cos_omega, -beta_rate_dot_of_place_13);
    let beta_rate_dot_of_place_15 = u_2_inv * d1_of_m7_i7_ua_ub;
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let beta_rate_dot_of_m6_zf_fa = m6 * beta_rate_dot_of_zf_fa;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_16 = d1_of_place_8
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_14);
    let beta_rate_dot_of_place_17 = S::int(2) * sin_gamma_minus_epsilon;
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
    // beta_rate' = (mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5
    //   + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
    //   2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma -
    //   delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
    //   + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(gamma - beta -
    //   theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma -
    //   delta - phi)*(1 - ea/e) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) -
    //   cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + (2*m4*ea*sin(gamma - delta - phi) +
    //   sin(phi)*(sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt - cos(gamma - delta)*(I4/e +
    //   m4*ea*(ea/e - 2))))/cos(phi))/e + m4*(sin(gamma - delta) - (cos(gamma - delta)*sin(phi) +
    //   2*sin(gamma - delta - phi))/cos(phi))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma -
    //   delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi)
    //   + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   m5*(ta^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) +
    //   tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt -
    //   m4*((cos(gamma - delta)*(cos(gamma - delta) + (cos(gamma - delta - phi) + (2*cos(gamma -
    //   delta)*(ea/e - 1) - sin(phi)*sin(gamma - delta - phi))/cos(phi))/cos(phi) - ea*(cos(gamma - delta)/e
    //   + 2*sin(phi)*tan(beta + theta - gamma)/ss)) - ea*sin(gamma - delta)*sin(phi)/ss)/e +
    //   (sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) - sin(gamma - delta
    //   - phi)*tan(gamma - beta - theta) - cos(gamma - delta - phi))/ss)) + cos(gamma -
    //   delta)*(m4*((ea*((cos(gamma - delta)*(ea*tan(gamma - beta - theta)/ss + tan(phi)*(cos(gamma -
    //   delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))) - ea*sin(gamma - delta)/ss)/e + (2*sin(gamma
    //   - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) +
    //   cos(gamma - delta)*tan(phi)*(cos(gamma - delta)/cos(phi) - cos(gamma - delta - phi)))/e +
    //   (sin(phi)*cos(gamma - delta - phi) - sin(gamma - delta) - cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss) + I4*(cos(gamma - delta)^2*tan(phi)/(e*cos(phi)) - (sin(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma))/ss)/e^2))/cos(phi)^2 + (cos(gamma - epsilon -
    //   omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(fa/zf - 1) + (sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + (sin(omega)*(cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - sin(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))) - 2*m6*fa*cos(gamma - epsilon - omega))/cos(omega))/zf -
    //   m6*(cos(gamma - epsilon) + (sin(gamma - epsilon)*sin(omega) - 2*cos(gamma - epsilon -
    //   omega))/cos(omega))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1)
    //   + cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) + (sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))/cos(omega) - fa*(sin(gamma - epsilon)/zf +
    //   2*sin(omega)*tan(beta + theta - gamma)/ss)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma -
    //   beta - theta) + cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
    //   m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma
    //   - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma
    //   - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
    //   phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma
    //   - delta) + 2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) +
    //   2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta +
    //   theta - gamma)) - cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 +
    //   sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma
    //   - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 -
    //   ea/e) + 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 +
    //   xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) +
    //   sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb -
    //   2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
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
                                * (-rr
                                    * (cos_angle_inv
                                        * (sin_theta
                                            * (sin_theta
                                                * (cos_phi_inv_sq
                                                    * (d1_of_place_3
                                                        * (zt_inv
                                                            * (cos_phi_inv
                                                                * (cos_gamma_minus_delta
                                                                    * (m4
                                                                        * (sin_gamma_minus_delta
                                                                            - cos_phi_inv * (d1_of_place_2 + d1_of_place_3_doubled))
                                                                        + e_inv
                                                                            * (cos_phi_inv
                                                                                * (sin_phi
                                                                                    * (-beta_rate_dot_of_m4_i4_e_ea)
                                                                                        .mul_add(cos_gamma_minus_delta, d1_of_place_6)
                                                                                    + m4_ea * d1_of_place_3_doubled)
                                                                                + beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                - beta_rate_dot_of_place_4 * zt_inv_d1_of_m5_i5_ta_tb))
                                                                    - sin_phi_d1_of_place_3
                                                                        * (d1_of_place_3 * cos_phi_inv
                                                                            * zt_inv.mul_add(zt_inv_d1_of_m5_i5_ta_tb, m4)
                                                                            + m4_beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                - d1_of_place_3 * m4_beta_rate_dot_of_e_ea
                                                                    * cos_gamma_minus_delta
                                                                + zt_inv * ss_inv
                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                        .mul_add(
                                                                            beta_rate_dot_of_place_6,
                                                                            I5 * beta_rate_dot_of_place_6,
                                                                        ))
                                                            - m4
                                                                * (ss_inv
                                                                    * (beta_rate_dot_of_place_5
                                                                        + sin_phi
                                                                            * sin_angle_cos_angle_inv
                                                                                .mul_add(
                                                                                    beta_rate_dot_of_gamma_delta,
                                                                                    sin_gamma_minus_delta,
                                                                                ))
                                                                    + e_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (cos_gamma_minus_delta
                                                                                - ea
                                                                                    * beta_rate_dot_of_place_8.mul_add(sin_phi, d1_of_place_5)
                                                                                + cos_phi_inv
                                                                                    * (beta_rate_dot_of_place_4
                                                                                        + cos_phi_inv
                                                                                            * beta_rate_dot_of_e_ea
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_of_gamma_delta,
                                                                                                    -sin_phi_d1_of_place_3,
                                                                                                ))) - beta_rate_dot_of_place_3 * ea_ss_inv)))
                                                        + cos_gamma_minus_delta
                                                            * (e_inv * i4_e_inv
                                                                * (-ss_inv)
                                                                    .mul_add(
                                                                        beta_rate_dot_of_place_10,
                                                                        e_inv * beta_rate_dot_of_place_9 * beta_rate_dot_of_place_12,
                                                                    )
                                                                + m4
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_11 - beta_rate_dot_of_place_10)
                                                                        + e_inv
                                                                            * (ea
                                                                                * (e_inv
                                                                                    * (cos_gamma_minus_delta
                                                                                        * (cos_phi_inv * sin_phi
                                                                                            * d1_of_e_ea
                                                                                                .mul_add(beta_rate_dot_of_place_9, beta_rate_dot_of_place_4)
                                                                                            - ea * beta_rate_dot_of_place_7)
                                                                                        - ea_ss_inv * sin_gamma_minus_delta)
                                                                                    + ss_inv
                                                                                        * beta_rate_dot_of_place_10
                                                                                            .mul_add(S::int(2), -beta_rate_dot_of_place_11))
                                                                                + beta_rate_dot_of_place_12
                                                                                    * (beta_rate_dot_of_place_9 - beta_rate_dot_of_place_4)))))
                                                    - ss_inv_d1_of_place_13 * beta_rate_dot_of_place_7
                                                    - cos_omega_inv_sq
                                                        * (d1_of_place_8
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (m6
                                                                            * (cos_gamma_minus_epsilon
                                                                                + cos_omega_inv * (d1_of_place_7 - d1_of_place_8_doubled))
                                                                            + zf_inv
                                                                                * (cos_omega_inv
                                                                                    * (-sin_omega
                                                                                        * (-beta_rate_dot_of_m6_i6_zf_fa)
                                                                                            .mul_add(sin_gamma_minus_epsilon, d1_of_place_11)
                                                                                        + m6_fa * d1_of_place_8_doubled)
                                                                                    + beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                    - beta_rate_dot_of_place_14 * beta_rate_dot_of_place_15))
                                                                        + sin_omega_d1_of_place_8
                                                                            * (d1_of_place_8 * cos_omega_inv
                                                                                * u_2_inv.mul_add(beta_rate_dot_of_place_15, m6)
                                                                                + beta_rate_dot_of_m6_zf_fa * cos_gamma_minus_epsilon))
                                                                    - d1_of_place_8 * beta_rate_dot_of_m6_zf_fa
                                                                        * sin_gamma_minus_epsilon
                                                                    + u_2_inv * ss_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_16,
                                                                                I7 * beta_rate_dot_of_place_16,
                                                                            ))
                                                                + m6
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_16
                                                                            + sin_omega
                                                                                * (-sin_angle_cos_angle_inv)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_of_place_17,
                                                                                        cos_gamma_minus_epsilon,
                                                                                    ))
                                                                        - zf_inv
                                                                            * (sin_gamma_minus_epsilon
                                                                                * (sin_gamma_minus_epsilon
                                                                                    - fa
                                                                                        * beta_rate_dot_of_place_8
                                                                                            .mul_add(sin_omega, d1_of_place_10)
                                                                                    + cos_omega_inv
                                                                                        * (beta_rate_dot_of_place_14
                                                                                            + cos_omega_inv
                                                                                                * beta_rate_dot_of_zf_fa
                                                                                                    .mul_add(
                                                                                                        beta_rate_dot_of_place_17,
                                                                                                        sin_omega_d1_of_place_8,
                                                                                                    ))) + fa * ss_inv * beta_rate_dot_of_place_13)))
                                                            + sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (zf_inv
                                                                        * (beta_rate_dot_of_place_21
                                                                            * (beta_rate_dot_of_place_14 - beta_rate_dot_of_place_20)
                                                                            + fa
                                                                                * (ss_inv
                                                                                    * d1_of_zf_fa
                                                                                        .mul_add(
                                                                                            beta_rate_dot_of_place_18,
                                                                                            beta_rate_dot_of_place_19,
                                                                                        )
                                                                                    - beta_rate_dot_of_place_22
                                                                                        * minus_d1_of_zf_fa
                                                                                            .mul_add(
                                                                                                beta_rate_dot_of_place_20,
                                                                                                beta_rate_dot_of_place_14,
                                                                                            )))
                                                                        - ss_inv
                                                                            * (beta_rate_dot_of_place_18 + beta_rate_dot_of_place_19))
                                                                    - zf_inv * i6_zf_inv
                                                                        * beta_rate_dot_of_place_20
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_22,
                                                                                ss_inv * beta_rate_dot_of_place_18,
                                                                            ))))
                                                + d1_of_place_14 * d1_of_d_beta_gamma
                                                    * sin_angle_cos_angle_inv)
                                            + d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (d1_of_place_12
                                                        + ss_inv * m2_da.mul_add(sin_angle, d1_of_place_13))
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_23)))
                                        + m2_da * d_inv
                                            * (-ss_inv)
                                                .mul_add(
                                                    beta_rate_dot_of_place_24,
                                                    d1_of_d_beta_gamma * cos_beta_minus_gamma,
                                                )) + d1_of_place_14 * cos_theta)))
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
    let delta_dot_value_of_beta_rate = cos_phi_inv * gamma_dot_value_of_beta_rate;
    let epsilon_dot_value_of_beta_rate = cos_omega_inv * gamma_dot_value_of_beta_rate;
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = beta_rate * (beta_rate_dot_of_place_25 - S::int(1));
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = ss_inv * gamma_dot_value_of_beta_rate;
    // delta' = rr*beta_rate*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
    let delta_dot_value = d1_of_place_3_zt_inv * delta_dot_value_of_beta_rate;
    // phi' = rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta +
    //   theta - gamma)*cos(phi))
    let phi_dot_value = e_inv * zt_inv * delta_dot_value_of_beta_rate
        * (-e).mul_add(d1_of_place_3, zt * cos_gamma_minus_delta);
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = d1_of_place_8_u_2_inv * epsilon_dot_value_of_beta_rate;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = zf_inv * u_2_inv * epsilon_dot_value_of_beta_rate
        * (-zf).mul_add(d1_of_place_8, u_2 * sin_gamma_minus_epsilon);
    (
        [
            beta_dot_value, theta_dot_value, gamma_dot_value, delta_dot_value, phi_dot_value,
            epsilon_dot_value, omega_dot_value,
        ],
        [beta_rate_dot],
    )
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 42,
            coordinates: 7,
            variables: 1,
            speeds: 1,
            reactions: 20,
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
