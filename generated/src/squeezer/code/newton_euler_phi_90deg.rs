//! Andrews' squeezing mechanism: Newton–Euler equations in phi-90°, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane_phi_90deg::{
    constraint_slopes, constraints, coordinate_rates, kinetic_energy,
};

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_beta, cos_beta) = beta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_delta, cos_delta) = delta.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
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
    // cos(delta)*cos(phi_minus_90deg) - sin(delta)*sin(phi_minus_90deg)
    let m_10_1_of_place = (-sin_delta)
        .mul_add(sin_phi_minus_90deg, cos_delta * cos_phi_minus_90deg);
    // cos(delta)*sin(phi_minus_90deg) + sin(delta)*cos(phi_minus_90deg)
    let m_10_1_of_place_2 = sin_delta
        .mul_add(cos_phi_minus_90deg, cos_delta * sin_phi_minus_90deg);
    // sin(delta + phi_minus_90deg)*sin(gamma) + cos(delta + phi_minus_90deg)*cos(gamma)
    let m_10_1_of_place_3 = m_10_1_of_place
        .mul_add(cos_gamma, m_10_1_of_place_2 * sin_gamma);
    let m_10_1_of_place_4 = m_7_1_of_place / sin_phi_minus_90deg;
    let m_10_1_of_place_5 = m_10_1_of_place_3 * m_10_1_of_place_4;
    let e_inv = S::int(1) / e;
    // sin(gamma)*sin(delta) + cos(gamma)*cos(delta)
    let cos_gamma_minus_delta = cos_gamma.mul_add(cos_delta, sin_gamma * sin_delta);
    let m_10_1_of_place_6 = cos_gamma_minus_delta * m_10_1_of_place_4;
    // e - ea
    let e_minus_ea = e - ea;
    let zt_inv_m_10_1_of_place_5 = m_10_1_of_place_5 / zt;
    let m_13_1_of_place = m5 * zt_inv_m_10_1_of_place_5;
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
    // -cos(delta)
    let minus_cos_delta = -cos_delta;
    // -cos(omega)
    let minus_cos_omega = -cos_omega;
    // -cos(epsilon)
    let minus_cos_epsilon = -cos_epsilon;
    // -sin(beta + theta)
    let m_5_2_of_beta_theta = -sin_beta_plus_theta;
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
    // M_10_1 = m4*rr*sin(theta)*(cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let m_10_1 = m4
        * (m_10_1_of_place_6 * ea.mul_add(e_inv, -S::int(1))
            + m_10_1_of_place_5 * cos_phi_minus_90deg);
    // M_10_4 = sin(delta + phi_minus_90deg)
    let m_10_4 = m_10_1_of_place_2;
    // M_10_5 = -cos(delta + phi_minus_90deg)
    let m_10_5 = -m_10_1_of_place;
    // M_10_10 = sin(phi_minus_90deg)
    let m_10_10 = sin_phi_minus_90deg;
    // M_10_11 = -cos(phi_minus_90deg)
    let m_10_11 = -cos_phi_minus_90deg;
    // M_11_1 = -m4*rr*sin(theta)*cos(gamma - delta - phi_minus_90deg)/cos(beta + theta - gamma)
    let m_11_1 = -m4 * m_10_1_of_place_3 * m_7_1_of_place;
    // M_11_4 = cos(delta + phi_minus_90deg)
    let m_11_4 = m_10_1_of_place;
    // M_11_5 = sin(delta + phi_minus_90deg)
    let m_11_5 = m_10_1_of_place_2;
    // M_11_10 = cos(phi_minus_90deg)
    let m_11_10 = cos_phi_minus_90deg;
    // M_11_11 = sin(phi_minus_90deg)
    let m_11_11 = sin_phi_minus_90deg;
    // M_12_1 = -I4*rr*sin(theta)*cos(gamma - delta)/(e*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let m_12_1 = -I4 * e_inv * m_10_1_of_place_6;
    // M_12_4 = ea*sin(delta + phi_minus_90deg)
    let m_12_4 = ea * m_10_1_of_place_2;
    // M_12_5 = -ea*cos(delta + phi_minus_90deg)
    let m_12_5 = -ea * m_10_1_of_place;
    // M_12_10 = sin(phi_minus_90deg)*(ea - e)
    let m_12_10 = -e_minus_ea * sin_phi_minus_90deg;
    // M_12_11 = cos(phi_minus_90deg)*(e - ea)
    let m_12_11 = e_minus_ea * cos_phi_minus_90deg;
    // M_13_1 = m5*rr*tb*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let m_13_1 = tb * m_13_1_of_place;
    // M_13_10 = 1
    let m_13_10 = S::int(1);
    // M_13_16 = -cos(delta)
    let m_13_16 = minus_cos_delta;
    // M_13_17 = -sin(delta)
    let m_13_17 = -sin_delta;
    // M_14_1 = m5*rr*ta*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let m_14_1 = ta * m_13_1_of_place;
    // M_14_11 = 1
    let m_14_11 = S::int(1);
    // M_14_16 = sin(delta)
    let m_14_16 = sin_delta;
    // M_14_17 = -cos(delta)
    let m_14_17 = minus_cos_delta;
    // M_15_1 = I5*rr*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let m_15_1 = I5 * zt_inv_m_10_1_of_place_5;
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
    let [beta, theta, gamma, delta, phi_minus_90deg, epsilon, omega] = *q;
    let [beta_rate] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_gamma, cos_gamma) = gamma.sin_cos();
    let (sin_phi_minus_90deg, cos_phi_minus_90deg) = phi_minus_90deg.sin_cos();
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
    // sin(gamma - delta)*sin(phi_minus_90deg) + cos(gamma - delta)*cos(phi_minus_90deg)
    let f_10_of_place = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let f_10_of_place_2 = sin_phi_minus_90deg_inv / zt;
    let f_10_of_place_3 = f_10_of_place * f_10_of_place_2;
    let f_10_of_beta_rate = f_5_of_beta_rate_sq * f_10_of_place_3;
    let m4_f_10_of_place = m4 * f_10_of_place;
    let f_10_of_place_4 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    let e_inv = S::int(1) / e;
    let f_10_of_place_5 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    let e_inv_f_10_of_place_5 = e_inv * f_10_of_place_5;
    // f_5_of_beta_rate_sq*f_10_of_place_4*e_inv_f_10_of_place_5 - f_7_of_beta_rate_2
    let f_10_of_beta_rate_2 = (f_5_of_beta_rate_sq * f_10_of_place_4)
        .mul_add(e_inv_f_10_of_place_5, -f_7_of_beta_rate_2);
    // f_10_of_beta_rate*f_10_of_place_4 + f_10_of_beta_rate_2
    let f_10_of_beta_rate_3 = f_10_of_beta_rate
        .mul_add(f_10_of_place_4, f_10_of_beta_rate_2);
    // sin(gamma - delta)*cos(phi_minus_90deg) - cos(gamma - delta)*sin(phi_minus_90deg)
    let f_10_of_place_6 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, sin_gamma_minus_delta * cos_phi_minus_90deg);
    // sin(gamma - delta - phi_minus_90deg)*(ss_inv + e_inv_f_10_of_place_5)
    let f_10_of_place_7 = f_10_of_place_6 * (ss_inv + e_inv_f_10_of_place_5);
    // f_5_of_beta_rate_sq*f_10_of_place_7 - cos(gamma - delta - phi_minus_90deg)*f_10_of_beta_rate_3
    let f_10_of_beta_rate_4 = (-f_10_of_place)
        .mul_add(f_10_of_beta_rate_3, f_5_of_beta_rate_sq * f_10_of_place_7);
    // 1 - ea*e_inv
    let f_10_of_e_ea = (-ea).mul_add(e_inv, S::int(1));
    // sin_phi_minus_90deg_inv*(f_10_of_beta_rate_3*cos(gamma - delta) - f_5_of_beta_rate_sq*sin(gamma -
    //   delta)*(ss_inv - f_10_of_place_3))
    let f_10_of_beta_rate_5 = sin_phi_minus_90deg_inv
        * (-f_5_of_beta_rate_sq * sin_gamma_minus_delta * (ss_inv - f_10_of_place_3)
            + f_10_of_beta_rate_3 * cos_gamma_minus_delta);
    let f_13_of_beta_rate = f_10_of_place_2 * f_10_of_beta_rate_4;
    let m5_tb = m5 * tb;
    let m5_ta = m5 * ta;
    let f_13_of_beta_rate_2 = f_10_of_place_3 * f_10_of_beta_rate;
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
    // f_10 = m4*rr*beta_rate^2*(cos(theta)*(cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma
    //   - delta - phi_minus_90deg)) - rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/d + sin(theta)*(cos(beta -
    //   gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/d + sin(theta)*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta
    //   - gamma) - ea*(sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/e)/ss -
    //   cos(phi_minus_90deg)*((cos(gamma - delta)*sin(gamma - delta - phi_minus_90deg)/e + (cos(gamma -
    //   delta)*(cos(gamma - delta - phi_minus_90deg)/zt + (cos(gamma - delta) -
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - ea*(cos(gamma - delta)/e + cos(gamma -
    //   delta - phi_minus_90deg)/zt))/e) - cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)^2/zt)/sin(phi_minus_90deg))/sin(phi_minus_90deg) + (sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma))/ss) + cos(gamma -
    //   delta - phi_minus_90deg)*(sin(gamma - delta)*(ea/e - 1)/sin(phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg))/zt)))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let f_10 = m4
        * f_10_of_e_ea
            .mul_add(f_10_of_beta_rate_5, f_10_of_place_4 * f_10_of_beta_rate_4)
        - f_10_of_beta_rate * m4_f_10_of_place;
    // f_11 = -m4*rr*beta_rate^2*(cos(theta)*cos(gamma - delta - phi_minus_90deg) +
    //   rr*(sin(theta)*(cos(beta - gamma)*cos(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta)/d +
    //   sin(theta)*((sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta +
    //   theta - gamma))/ss + cos(gamma - delta)*(sin(gamma - delta - phi_minus_90deg) - (cos(gamma -
    //   delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg))/(e*sin(phi_minus_90deg)))) - cos(theta)*cos(beta -
    //   gamma)*cos(gamma - delta - phi_minus_90deg)/d)/cos(beta + theta - gamma))/cos(beta + theta - gamma)
    let f_11 = -m4 * f_5_of_beta_rate_sq
        * (f_10_of_place_5 * e_inv_f_10_of_place_5)
            .mul_add(f_10_of_e_ea, f_10_of_place_7) + m4_f_10_of_place * f_10_of_beta_rate_2;
    // f_12 = I4*rr*beta_rate^2*(rr*(cos(theta)*cos(beta - gamma)*cos(gamma - delta)/d +
    //   sin(theta)*(cos(beta - gamma)*cos(gamma - delta)*tan(beta + theta - gamma)/d + sin(theta)*(cos(gamma
    //   - delta)*(tan(gamma - beta - theta)/ss + (cos(gamma - delta)/e + cos(gamma - delta -
    //   phi_minus_90deg)/zt)/(sin(phi_minus_90deg)*tan(phi_minus_90deg))) + sin(gamma - delta)*(cos(gamma -
    //   delta - phi_minus_90deg)/(zt*sin(phi_minus_90deg)) - 1/ss))))/cos(beta + theta - gamma) -
    //   cos(theta)*cos(gamma - delta))/(e*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let f_12 = I4 * e_inv * f_10_of_beta_rate_5;
    // f_13 = m5*rr*beta_rate^2*(tb*cos(theta)*cos(gamma - delta - phi_minus_90deg) -
    //   rr*(tb*(cos(theta)*cos(beta - gamma)*cos(gamma - delta - phi_minus_90deg)/d + sin(theta)*(cos(beta -
    //   gamma)*cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)/d + sin(theta)*((cos(gamma -
    //   delta - phi_minus_90deg)^2/(zt*tan(phi_minus_90deg)) + cos(gamma - delta)*(cos(gamma - delta -
    //   phi_minus_90deg)/tan(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/e)/sin(phi_minus_90deg) - (sin(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta - phi_minus_90deg)*tan(beta + theta - gamma))/ss))) - ta*sin(theta)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2/(zt*sin(phi_minus_90deg)))/cos(beta + theta - gamma))/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let f_13 = m5_ta.mul_add(f_13_of_beta_rate_2, f_13_of_beta_rate * m5_tb);
    // f_14 = m5*rr*beta_rate^2*(ta*cos(theta)*cos(gamma - delta - phi_minus_90deg) -
    //   rr*(tb*sin(theta)^2*cos(gamma - delta - phi_minus_90deg)^2/(zt*sin(phi_minus_90deg)) +
    //   ta*(cos(theta)*cos(beta - gamma)*cos(gamma - delta - phi_minus_90deg)/d + sin(theta)*(cos(beta -
    //   gamma)*cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)/d + sin(theta)*((cos(gamma -
    //   delta - phi_minus_90deg)^2/(zt*tan(phi_minus_90deg)) + cos(gamma - delta)*(cos(gamma - delta -
    //   phi_minus_90deg)/tan(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/e)/sin(phi_minus_90deg) - (sin(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta - phi_minus_90deg)*tan(beta + theta - gamma))/ss))))/cos(beta + theta - gamma))/(zt*cos(beta +
    //   theta - gamma)*sin(phi_minus_90deg))
    let f_14 = (-m5_tb).mul_add(f_13_of_beta_rate_2, f_13_of_beta_rate * m5_ta);
    // f_15 = I5*rr*beta_rate^2*(cos(theta)*cos(gamma - delta - phi_minus_90deg) - rr*(cos(theta)*cos(beta
    //   - gamma)*cos(gamma - delta - phi_minus_90deg)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)/d + sin(theta)*((cos(gamma - delta -
    //   phi_minus_90deg)^2/(zt*tan(phi_minus_90deg)) + cos(gamma - delta)*(cos(gamma - delta -
    //   phi_minus_90deg)/tan(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/e)/sin(phi_minus_90deg) - (sin(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta - phi_minus_90deg)*tan(beta + theta - gamma))/ss)))/cos(beta + theta - gamma))/(zt*cos(beta +
    //   theta - gamma)*sin(phi_minus_90deg))
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
/// 483 operations, 8 sines and cosines, 1 other function.
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
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_2 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_2 = ss_inv * d1_of_place_2;
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
    let d1_of_place_3 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_d1_of_place_3 = d1_of_place_3 * sin_omega;
    let d1_of_place_4 = S::int(2) * sin_omega_d1_of_place_3;
    // sin(gamma - epsilon) - d1_of_place_4
    let d1_of_place_5 = sin_gamma_minus_epsilon - d1_of_place_4;
    // sin(gamma - epsilon)*(fa_zf_inv*(minus_d1_of_zf_fa*sin(gamma - epsilon) + d1_of_place_4) +
    //   d1_of_place_5)
    let d1_of_place_6 = sin_gamma_minus_epsilon
        * (fa_zf_inv * minus_d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_4)
            + d1_of_place_5);
    let d1_of_place_3_sq = d1_of_place_3 * d1_of_place_3;
    let d1_of_place_7 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_8 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_8 = u_2_inv * d1_of_place_8;
    // I6*d1_of_place_7^2 + d1_of_place_3_sq*u_2_inv_d1_of_place_8
    let d1_of_place_9 = d1_of_place_3_sq
        .mul_add(u_2_inv_d1_of_place_8, I6 * d1_of_place_7 * d1_of_place_7);
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
    let d1_of_place_10 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let d1_of_place_11 = d1_of_place_10 * cos_phi_minus_90deg;
    let d1_of_place_11_doubled = S::int(2) * d1_of_place_11;
    // cos(gamma - delta) - d1_of_place_11_doubled
    let d1_of_place_12 = cos_gamma_minus_delta - d1_of_place_11_doubled;
    // cos(gamma - delta)*(ea_e_inv*(d1_of_e_ea*cos(gamma - delta) + d1_of_place_11_doubled) +
    //   d1_of_place_12)
    let d1_of_place_13 = cos_gamma_minus_delta
        * (ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, d1_of_place_11_doubled)
            + d1_of_place_12);
    let d1_of_place_10_sq = d1_of_place_10 * d1_of_place_10;
    let d1_of_place_14 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let d1_of_place_15 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_d1_of_place_15 = zt_inv * d1_of_place_15;
    // I4*d1_of_place_14^2 + d1_of_place_10_sq*zt_inv_d1_of_place_15
    let d1_of_place_16 = d1_of_place_10_sq
        .mul_add(zt_inv_d1_of_place_15, I4 * d1_of_place_14 * d1_of_place_14);
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let d1_of_place_17 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
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
                        * (sin_theta * sin_theta
                            * (ss_inv_d1_of_place_2
                                + cos_omega_inv_sq
                                    * (m6 * (d1_of_place_6 + d1_of_place_3_sq) + d1_of_place_9)
                                + d1_of_place_17
                                    * (m4 * (d1_of_place_13 + d1_of_place_10_sq) + d1_of_place_16))
                            + i2_plus_da_m2_da * d1_of_d_beta_gamma * d1_of_d_beta_gamma)
                        - S::int(2) * m2_da_d1_of_d_beta_gamma * cos_theta));
    // sin(gamma)^2 - 1 + cos(gamma)^2
    let beta_rate_dot_of_gamma = sin_gamma.mul_add(sin_gamma, -S::int(1)) + cos_gamma * cos_gamma;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb_minus_xc*cos(gamma) + yb_minus_yc*sin(gamma)
    let beta_rate_dot_of_place = yb_minus_yc.mul_add(sin_gamma, xb_minus_xc * cos_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let i6_zf_inv = I6 * zf_inv;
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = minus_d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - cos(gamma - epsilon)*sin(omega)
    let beta_rate_dot_of_place_3 = (-cos_gamma_minus_epsilon)
        .mul_add(sin_omega, sin_gamma_minus_epsilon * cos_omega);
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_4 = d1_of_place_3
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_3);
    let beta_rate_dot_of_place_5 = beta_rate_dot_of_zf_fa * sin_gamma_minus_epsilon;
    let m6_d1_of_place_3 = m6 * d1_of_place_3;
    let beta_rate_dot_of_place_6 = S::int(2) * sin_angle_cos_angle_inv;
    let fa_ss_inv = fa * ss_inv;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_7 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_8 = beta_rate_dot_of_place_3 * sin_omega;
    let beta_rate_dot_of_place_9 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_10 = d1_of_place_7 * sin_omega_cos_omega_inv;
    let beta_rate_dot_of_place_11 = beta_rate_dot_of_place_3 * m6_d1_of_place_3;
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let beta_rate_dot_of_place_12 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    // sin(gamma - delta)*cos(phi_minus_90deg) - cos(gamma - delta)*sin(phi_minus_90deg)
    let beta_rate_dot_of_place_13 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, sin_gamma_minus_delta * cos_phi_minus_90deg);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_14 = d1_of_place_10
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_13);
    let beta_rate_dot_of_place_15 = beta_rate_dot_of_e_ea * cos_gamma_minus_delta;
    let m4_d1_of_place_10 = m4 * d1_of_place_10;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_16 = ea_ss_inv * sin_gamma_minus_delta;
    let beta_rate_dot_of_place_17 = beta_rate_dot_of_place_13 * cos_phi_minus_90deg;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_18 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_of_place_19 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_20 = beta_rate_dot_of_place_13 * m4_d1_of_place_10;
    // cos(gamma - epsilon - omega)*m6_d1_of_place_3 + cos(gamma - delta -
    //   phi_minus_90deg)*m4_d1_of_place_10
    let beta_rate_dot_of_place_21 = d1_of_place_10
        .mul_add(m4_d1_of_place_10, d1_of_place_3 * m6_d1_of_place_3);
    // cos_omega_inv_sq*(m6*(sin_omega_d1_of_place_3^2 + d1_of_place_6) + d1_of_place_9) +
    //   d1_of_place_17*(m4*(d1_of_place_11^2 + d1_of_place_13) + d1_of_place_16)
    let beta_rate_dot_of_place_22 = cos_omega_inv_sq
        * (m6 * sin_omega_d1_of_place_3.mul_add(sin_omega_d1_of_place_3, d1_of_place_6)
            + d1_of_place_9)
        + d1_of_place_17
            * (m4 * d1_of_place_11.mul_add(d1_of_place_11, d1_of_place_13) + d1_of_place_16);
    // beta_rate_dot_of_place_21 + beta_rate_dot_of_place_22
    let beta_rate_dot_of_place_23 = beta_rate_dot_of_place_21 + beta_rate_dot_of_place_22;
    // ss_inv_d1_of_place_2 + beta_rate_dot_of_place_23
    let beta_rate_dot_of_place_24 = ss_inv_d1_of_place_2 + beta_rate_dot_of_place_23;
    let beta_rate_dot_of_place_25 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_26 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    // sin(beta - gamma) - d1_of_d_beta_gamma*beta_rate_dot_of_place_25*rr_cos_angle_inv
    let beta_rate_dot_of_place_27 = (-(d1_of_d_beta_gamma * beta_rate_dot_of_place_25))
        .mul_add(rr_cos_angle_inv, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_28 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
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
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1
    //   + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta -
    //   gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_28 * (l0 - beta_rate_dot_of_place_28)
                    * (sc * sb.mul_add(beta_rate_dot_of_gamma, beta_rate_dot_of_place)
                        - sd
                            * sa
                                .mul_add(beta_rate_dot_of_gamma, beta_rate_dot_of_place_2))
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
                                                * (cos_omega_inv
                                                    * (cos_omega_inv
                                                        * (d1_of_place_3
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - beta_rate_dot_of_place_3 * d1_of_place_8
                                                                                + sin_omega_cos_omega_inv
                                                                                    * (d1_of_place_3
                                                                                        * (m6_fa * sin_omega).mul_add(S::int(2), -d1_of_place_8)
                                                                                        + beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                            + m6
                                                                                * d1_of_place_5
                                                                                    .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                        + sin_omega_d1_of_place_3
                                                                            * (d1_of_place_3 * cos_omega_inv
                                                                                * (m6 * sin_omega * sin_omega + u_2_inv_d1_of_place_8)
                                                                                + m6 * beta_rate_dot_of_zf_fa * cos_gamma_minus_epsilon))
                                                                    + ss_inv * u_2_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_4,
                                                                                I7 * beta_rate_dot_of_place_4,
                                                                            )
                                                                    + m6_d1_of_place_3
                                                                        * (sin_omega_d1_of_place_3 + beta_rate_dot_of_place_5))
                                                                - m6
                                                                    * (sin_omega
                                                                        * (ss_inv
                                                                            * (beta_rate_dot_of_place_6
                                                                                .mul_add(sin_gamma_minus_epsilon, -cos_gamma_minus_epsilon)
                                                                                - beta_rate_dot_of_place_4 * sin_omega)
                                                                            + zf_inv
                                                                                * (sin_gamma_minus_epsilon
                                                                                    * (d1_of_place_3
                                                                                        + sin_omega_cos_omega_inv
                                                                                            * (beta_rate_dot_of_place_3
                                                                                                + cos_omega_inv
                                                                                                    * beta_rate_dot_of_place_5
                                                                                                        .mul_add(S::int(2), sin_omega_d1_of_place_3))
                                                                                        - beta_rate_dot_of_place_6 * fa_ss_inv)
                                                                                    + fa_ss_inv * cos_gamma_minus_epsilon))
                                                                        + d1_of_place_7 * beta_rate_dot_of_place_5))
                                                            - sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_7 + beta_rate_dot_of_place_8)
                                                                        - zf_inv
                                                                            * (sin_omega_cos_omega_inv * sin_gamma_minus_epsilon
                                                                                * (beta_rate_dot_of_place_3 - beta_rate_dot_of_place_9)
                                                                                + fa
                                                                                    * (ss_inv
                                                                                        * d1_of_zf_fa
                                                                                            .mul_add(beta_rate_dot_of_place_7, beta_rate_dot_of_place_8)
                                                                                        - beta_rate_dot_of_place_10
                                                                                            * minus_d1_of_zf_fa
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_of_place_9,
                                                                                                    beta_rate_dot_of_place_3,
                                                                                                ))))
                                                                    + zf_inv * i6_zf_inv
                                                                        * beta_rate_dot_of_place_9
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_10,
                                                                                ss_inv * beta_rate_dot_of_place_7,
                                                                            ))) - d1_of_place_7 * beta_rate_dot_of_place_11)
                                                    + sin_phi_minus_90deg_inv
                                                        * (-sin_phi_minus_90deg_inv
                                                            * (d1_of_place_10
                                                                * (zt_inv
                                                                    * (sin_phi_minus_90deg_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (e_inv
                                                                                * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                    - beta_rate_dot_of_place_13 * d1_of_place_15
                                                                                    + beta_rate_dot_of_place_12
                                                                                        * (d1_of_place_10
                                                                                            * (m4_ea * cos_phi_minus_90deg)
                                                                                                .mul_add(S::int(2), d1_of_place_15)
                                                                                            + beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                                + m4
                                                                                    * d1_of_place_12
                                                                                        .mul_add(beta_rate_dot_of_place_12, sin_gamma_minus_delta))
                                                                            + d1_of_place_11
                                                                                * (d1_of_place_10 * sin_phi_minus_90deg_inv
                                                                                    * (m4 * cos_phi_minus_90deg * cos_phi_minus_90deg
                                                                                        + zt_inv_d1_of_place_15)
                                                                                    + m4 * beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                        - ss_inv * zt_inv
                                                                            * (m5 * ta_sq_plus_tb_sq)
                                                                                .mul_add(
                                                                                    beta_rate_dot_of_place_14,
                                                                                    I5 * beta_rate_dot_of_place_14,
                                                                                )
                                                                        + m4_d1_of_place_10
                                                                            * (d1_of_place_11 + beta_rate_dot_of_place_15))
                                                                    + m4
                                                                        * (-cos_phi_minus_90deg
                                                                            * (e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (-d1_of_place_10 + beta_rate_dot_of_place_6 * ea_ss_inv
                                                                                        - beta_rate_dot_of_place_12
                                                                                            * (sin_phi_minus_90deg_inv
                                                                                                * beta_rate_dot_of_place_15
                                                                                                    .mul_add(S::int(2), d1_of_place_11)
                                                                                                - beta_rate_dot_of_place_13)) + beta_rate_dot_of_place_16)
                                                                                + ss_inv
                                                                                    * (beta_rate_dot_of_place_17 - sin_gamma_minus_delta
                                                                                        - sin_angle_cos_angle_inv
                                                                                            * cos_gamma_minus_delta
                                                                                                .mul_add(S::int(2), -d1_of_place_11)))
                                                                            + d1_of_place_14 * beta_rate_dot_of_place_15))
                                                                + cos_gamma_minus_delta
                                                                    * (e_inv * i4_e_inv
                                                                        * (-ss_inv)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_18,
                                                                                d1_of_place_14 * beta_rate_dot_of_place_12
                                                                                    * beta_rate_dot_of_place_19,
                                                                            )
                                                                        + m4
                                                                            * (ss_inv
                                                                                * (beta_rate_dot_of_place_17 - beta_rate_dot_of_place_18)
                                                                                + e_inv
                                                                                    * (beta_rate_dot_of_place_12 * cos_gamma_minus_delta
                                                                                        * (beta_rate_dot_of_place_13 + beta_rate_dot_of_place_19)
                                                                                        - ea
                                                                                            * (ss_inv
                                                                                                * (-beta_rate_dot_of_place_18)
                                                                                                    .mul_add(S::int(2), beta_rate_dot_of_place_17)
                                                                                                + e_inv
                                                                                                    * (beta_rate_dot_of_place_16
                                                                                                        + cos_gamma_minus_delta
                                                                                                            * (beta_rate_dot_of_place_12
                                                                                                                * (-d1_of_e_ea)
                                                                                                                    .mul_add(
                                                                                                                        beta_rate_dot_of_place_19,
                                                                                                                        beta_rate_dot_of_place_13,
                                                                                                                    ) + sin_angle_cos_angle_inv * ea_ss_inv)))))))
                                                            + d1_of_place_14 * beta_rate_dot_of_place_20)
                                                    + ss_inv
                                                        * (beta_rate_dot_of_place_11 + beta_rate_dot_of_place_20
                                                            + sin_angle_cos_angle_inv
                                                                * (ss_inv_d1_of_place_2 + beta_rate_dot_of_place_21)))
                                                - d1_of_d_beta_gamma * sin_angle_cos_angle_inv
                                                    * beta_rate_dot_of_place_24)
                                            - d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (ss_inv * m2_da.mul_add(sin_angle, d1_of_place_2)
                                                        + beta_rate_dot_of_place_23)
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_25)))
                                        + m2_da * d_inv
                                            * (-d1_of_d_beta_gamma)
                                                .mul_add(
                                                    cos_beta_minus_gamma,
                                                    ss_inv * beta_rate_dot_of_place_26,
                                                )) + beta_rate_dot_of_place_24 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_27,
                                    rr * beta_rate_dot_of_place_25 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_27)
                        - m2_da * beta_rate_dot_of_place_26))) / d1;
    [beta_rate_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 505 operations, 8 sines and cosines, 1 other function.
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
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_2 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_2 = ss_inv * d1_of_place_2;
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
    let d1_of_place_3 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_d1_of_place_3 = d1_of_place_3 * sin_omega;
    let d1_of_place_4 = S::int(2) * sin_omega_d1_of_place_3;
    // sin(gamma - epsilon) - d1_of_place_4
    let d1_of_place_5 = sin_gamma_minus_epsilon - d1_of_place_4;
    // sin(gamma - epsilon)*(fa_zf_inv*(minus_d1_of_zf_fa*sin(gamma - epsilon) + d1_of_place_4) +
    //   d1_of_place_5)
    let d1_of_place_6 = sin_gamma_minus_epsilon
        * (fa_zf_inv * minus_d1_of_zf_fa.mul_add(sin_gamma_minus_epsilon, d1_of_place_4)
            + d1_of_place_5);
    let d1_of_place_3_sq = d1_of_place_3 * d1_of_place_3;
    let d1_of_place_7 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // u_2_inv*(I7 + m7*ua_sq_plus_ub_sq)
    let d1_of_place_8 = u_2_inv * m7.mul_add(ua_sq_plus_ub_sq, I7);
    let u_2_inv_d1_of_place_8 = u_2_inv * d1_of_place_8;
    // I6*d1_of_place_7^2 + d1_of_place_3_sq*u_2_inv_d1_of_place_8
    let d1_of_place_9 = d1_of_place_3_sq
        .mul_add(u_2_inv_d1_of_place_8, I6 * d1_of_place_7 * d1_of_place_7);
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
    let d1_of_place_10 = cos_gamma_minus_delta
        .mul_add(cos_phi_minus_90deg, sin_gamma_minus_delta * sin_phi_minus_90deg);
    let d1_of_place_11 = d1_of_place_10 * cos_phi_minus_90deg;
    let d1_of_place_11_doubled = S::int(2) * d1_of_place_11;
    // cos(gamma - delta) - d1_of_place_11_doubled
    let d1_of_place_12 = cos_gamma_minus_delta - d1_of_place_11_doubled;
    // cos(gamma - delta)*(ea_e_inv*(d1_of_e_ea*cos(gamma - delta) + d1_of_place_11_doubled) +
    //   d1_of_place_12)
    let d1_of_place_13 = cos_gamma_minus_delta
        * (ea_e_inv * d1_of_e_ea.mul_add(cos_gamma_minus_delta, d1_of_place_11_doubled)
            + d1_of_place_12);
    let d1_of_place_10_sq = d1_of_place_10 * d1_of_place_10;
    let d1_of_place_14 = e_inv * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // zt_inv*(I5 + m5*ta_sq_plus_tb_sq)
    let d1_of_place_15 = zt_inv * m5.mul_add(ta_sq_plus_tb_sq, I5);
    let zt_inv_d1_of_place_15 = zt_inv * d1_of_place_15;
    // I4*d1_of_place_14^2 + d1_of_place_10_sq*zt_inv_d1_of_place_15
    let d1_of_place_16 = d1_of_place_10_sq
        .mul_add(zt_inv_d1_of_place_15, I4 * d1_of_place_14 * d1_of_place_14);
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let d1_of_place_17 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
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
                        * (sin_theta * sin_theta
                            * (ss_inv_d1_of_place_2
                                + cos_omega_inv_sq
                                    * (m6 * (d1_of_place_6 + d1_of_place_3_sq) + d1_of_place_9)
                                + d1_of_place_17
                                    * (m4 * (d1_of_place_13 + d1_of_place_10_sq) + d1_of_place_16))
                            + i2_plus_da_m2_da * d1_of_d_beta_gamma * d1_of_d_beta_gamma)
                        - S::int(2) * m2_da_d1_of_d_beta_gamma * cos_theta));
    // sin(gamma)^2 - 1 + cos(gamma)^2
    let beta_rate_dot_of_gamma = sin_gamma.mul_add(sin_gamma, -S::int(1)) + cos_gamma * cos_gamma;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb_minus_xc*cos(gamma) + yb_minus_yc*sin(gamma)
    let beta_rate_dot_of_place = yb_minus_yc.mul_add(sin_gamma, xb_minus_xc * cos_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_of_place_2 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    let i6_zf_inv = I6 * zf_inv;
    let m6_fa = m6 * fa;
    // i6_zf_inv + minus_d1_of_zf_fa*m6_fa
    let beta_rate_dot_of_m6_i6_zf_fa = minus_d1_of_zf_fa.mul_add(m6_fa, i6_zf_inv);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // sin(gamma - epsilon)*cos(omega) - cos(gamma - epsilon)*sin(omega)
    let beta_rate_dot_of_place_3 = (-cos_gamma_minus_epsilon)
        .mul_add(sin_omega, sin_gamma_minus_epsilon * cos_omega);
    // fa_zf_inv - 1
    let beta_rate_dot_of_zf_fa = fa_zf_inv - S::int(1);
    let beta_rate_dot_of_place_4 = d1_of_place_3 * cos_omega_inv;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    // sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_5 = d1_of_place_3
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_3);
    let beta_rate_dot_of_place_6 = beta_rate_dot_of_zf_fa * sin_gamma_minus_epsilon;
    let m6_d1_of_place_3 = m6 * d1_of_place_3;
    let beta_rate_dot_of_place_7 = S::int(2) * sin_angle_cos_angle_inv;
    let fa_ss_inv = fa * ss_inv;
    // cos(gamma - epsilon) - sin_angle_cos_angle_inv*sin(gamma - epsilon)
    let beta_rate_dot_of_place_8 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_epsilon, cos_gamma_minus_epsilon);
    let beta_rate_dot_of_place_9 = beta_rate_dot_of_place_3 * sin_omega;
    let beta_rate_dot_of_place_10 = cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_of_place_11 = d1_of_place_7 * sin_omega_cos_omega_inv;
    let beta_rate_dot_of_place_12 = beta_rate_dot_of_place_3 * m6_d1_of_place_3;
    let i4_e_inv = I4 * e_inv;
    let m4_ea = m4 * ea;
    // i4_e_inv + d1_of_e_ea*m4_ea
    let beta_rate_dot_of_m4_i4_e_ea = d1_of_e_ea.mul_add(m4_ea, i4_e_inv);
    let beta_rate_dot_of_place_13 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    // sin(gamma - delta)*cos(phi_minus_90deg) - cos(gamma - delta)*sin(phi_minus_90deg)
    let beta_rate_dot_of_place_14 = (-cos_gamma_minus_delta)
        .mul_add(sin_phi_minus_90deg, sin_gamma_minus_delta * cos_phi_minus_90deg);
    // ea_e_inv - 1
    let beta_rate_dot_of_e_ea = ea_e_inv - S::int(1);
    let beta_rate_dot_of_place_15 = d1_of_place_10 * sin_phi_minus_90deg_inv;
    // sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*sin_angle_cos_angle_inv
    let beta_rate_dot_of_place_16 = d1_of_place_10
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_of_place_14);
    let beta_rate_dot_of_place_17 = beta_rate_dot_of_e_ea * cos_gamma_minus_delta;
    let m4_d1_of_place_10 = m4 * d1_of_place_10;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_of_place_18 = ea_ss_inv * sin_gamma_minus_delta;
    let beta_rate_dot_of_place_19 = beta_rate_dot_of_place_14 * cos_phi_minus_90deg;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_of_place_20 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    let beta_rate_dot_of_place_21 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    let beta_rate_dot_of_place_22 = beta_rate_dot_of_place_14 * m4_d1_of_place_10;
    // cos(gamma - epsilon - omega)*m6_d1_of_place_3 + cos(gamma - delta -
    //   phi_minus_90deg)*m4_d1_of_place_10
    let beta_rate_dot_of_place_23 = d1_of_place_10
        .mul_add(m4_d1_of_place_10, d1_of_place_3 * m6_d1_of_place_3);
    // cos_omega_inv_sq*(m6*(sin_omega_d1_of_place_3^2 + d1_of_place_6) + d1_of_place_9) +
    //   d1_of_place_17*(m4*(d1_of_place_11^2 + d1_of_place_13) + d1_of_place_16)
    let beta_rate_dot_of_place_24 = cos_omega_inv_sq
        * (m6 * sin_omega_d1_of_place_3.mul_add(sin_omega_d1_of_place_3, d1_of_place_6)
            + d1_of_place_9)
        + d1_of_place_17
            * (m4 * d1_of_place_11.mul_add(d1_of_place_11, d1_of_place_13) + d1_of_place_16);
    // beta_rate_dot_of_place_23 + beta_rate_dot_of_place_24
    let beta_rate_dot_of_place_25 = beta_rate_dot_of_place_23 + beta_rate_dot_of_place_24;
    // ss_inv_d1_of_place_2 + beta_rate_dot_of_place_25
    let beta_rate_dot_of_place_26 = ss_inv_d1_of_place_2 + beta_rate_dot_of_place_25;
    let beta_rate_dot_of_place_27 = sin_angle_cos_angle_inv * cos_beta_minus_gamma;
    let beta_rate_dot_of_place_28 = cos_theta * sin_beta_minus_gamma;
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let rr_cos_angle_inv = rr * cos_angle_inv;
    let beta_rate_dot_of_place_29 = d1_of_d_beta_gamma * rr_cos_angle_inv;
    // sin(beta - gamma) - beta_rate_dot_of_place_27*beta_rate_dot_of_place_29
    let beta_rate_dot_of_place_30 = (-beta_rate_dot_of_place_27)
        .mul_add(beta_rate_dot_of_place_29, sin_beta_minus_gamma);
    // xb*(xb - 2*xc)
    let beta_rate_dot_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_of_place_31 = (xc_sq + beta_rate_dot_of_xb_xc + yc_sq + beta_rate_dot_of_yb_yc
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
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1
    //   + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta -
    //   gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1
    let beta_rate_dot = (mom
        + rr_cos_angle_inv
            * (sin_theta
                * (c0 * ss_inv * beta_rate_dot_of_place_31 * (l0 - beta_rate_dot_of_place_31)
                    * (sc * sb.mul_add(beta_rate_dot_of_gamma, beta_rate_dot_of_place)
                        - sd
                            * sa
                                .mul_add(beta_rate_dot_of_gamma, beta_rate_dot_of_place_2))
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
                                                * (cos_omega_inv
                                                    * (cos_omega_inv
                                                        * (d1_of_place_3
                                                            * (u_2_inv
                                                                * (cos_omega_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (zf_inv
                                                                            * (beta_rate_dot_of_m6_i6_zf_fa * cos_gamma_minus_epsilon
                                                                                - beta_rate_dot_of_place_3 * d1_of_place_8
                                                                                + sin_omega_cos_omega_inv
                                                                                    * (d1_of_place_3
                                                                                        * (m6_fa * sin_omega).mul_add(S::int(2), -d1_of_place_8)
                                                                                        + beta_rate_dot_of_m6_i6_zf_fa * sin_gamma_minus_epsilon))
                                                                            + m6
                                                                                * d1_of_place_5
                                                                                    .mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon))
                                                                        + sin_omega_d1_of_place_3
                                                                            * (beta_rate_dot_of_place_4
                                                                                * (m6 * sin_omega * sin_omega + u_2_inv_d1_of_place_8)
                                                                                + m6 * beta_rate_dot_of_zf_fa * cos_gamma_minus_epsilon))
                                                                    + ss_inv * u_2_inv
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_5,
                                                                                I7 * beta_rate_dot_of_place_5,
                                                                            )
                                                                    + m6_d1_of_place_3
                                                                        * (sin_omega_d1_of_place_3 + beta_rate_dot_of_place_6))
                                                                - m6
                                                                    * (sin_omega
                                                                        * (ss_inv
                                                                            * (beta_rate_dot_of_place_7
                                                                                .mul_add(sin_gamma_minus_epsilon, -cos_gamma_minus_epsilon)
                                                                                - beta_rate_dot_of_place_5 * sin_omega)
                                                                            + zf_inv
                                                                                * (sin_gamma_minus_epsilon
                                                                                    * (d1_of_place_3
                                                                                        + sin_omega_cos_omega_inv
                                                                                            * (beta_rate_dot_of_place_3
                                                                                                + cos_omega_inv
                                                                                                    * beta_rate_dot_of_place_6
                                                                                                        .mul_add(S::int(2), sin_omega_d1_of_place_3))
                                                                                        - beta_rate_dot_of_place_7 * fa_ss_inv)
                                                                                    + fa_ss_inv * cos_gamma_minus_epsilon))
                                                                        + d1_of_place_7 * beta_rate_dot_of_place_6))
                                                            - sin_gamma_minus_epsilon
                                                                * (m6
                                                                    * (ss_inv
                                                                        * (beta_rate_dot_of_place_8 + beta_rate_dot_of_place_9)
                                                                        - zf_inv
                                                                            * (sin_omega_cos_omega_inv * sin_gamma_minus_epsilon
                                                                                * (beta_rate_dot_of_place_3 - beta_rate_dot_of_place_10)
                                                                                + fa
                                                                                    * (ss_inv
                                                                                        * d1_of_zf_fa
                                                                                            .mul_add(beta_rate_dot_of_place_8, beta_rate_dot_of_place_9)
                                                                                        - beta_rate_dot_of_place_11
                                                                                            * minus_d1_of_zf_fa
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_of_place_10,
                                                                                                    beta_rate_dot_of_place_3,
                                                                                                ))))
                                                                    + zf_inv * i6_zf_inv
                                                                        * beta_rate_dot_of_place_10
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_11,
                                                                                ss_inv * beta_rate_dot_of_place_8,
                                                                            ))) - d1_of_place_7 * beta_rate_dot_of_place_12)
                                                    + sin_phi_minus_90deg_inv
                                                        * (-sin_phi_minus_90deg_inv
                                                            * (d1_of_place_10
                                                                * (zt_inv
                                                                    * (sin_phi_minus_90deg_inv
                                                                        * (cos_gamma_minus_delta
                                                                            * (e_inv
                                                                                * (beta_rate_dot_of_m4_i4_e_ea * sin_gamma_minus_delta
                                                                                    - beta_rate_dot_of_place_14 * d1_of_place_15
                                                                                    + beta_rate_dot_of_place_13
                                                                                        * (d1_of_place_10
                                                                                            * (m4_ea * cos_phi_minus_90deg)
                                                                                                .mul_add(S::int(2), d1_of_place_15)
                                                                                            + beta_rate_dot_of_m4_i4_e_ea * cos_gamma_minus_delta))
                                                                                + m4
                                                                                    * d1_of_place_12
                                                                                        .mul_add(beta_rate_dot_of_place_13, sin_gamma_minus_delta))
                                                                            + d1_of_place_11
                                                                                * (beta_rate_dot_of_place_15
                                                                                    * (m4 * cos_phi_minus_90deg * cos_phi_minus_90deg
                                                                                        + zt_inv_d1_of_place_15)
                                                                                    + m4 * beta_rate_dot_of_e_ea * sin_gamma_minus_delta))
                                                                        - ss_inv * zt_inv
                                                                            * (m5 * ta_sq_plus_tb_sq)
                                                                                .mul_add(
                                                                                    beta_rate_dot_of_place_16,
                                                                                    I5 * beta_rate_dot_of_place_16,
                                                                                )
                                                                        + m4_d1_of_place_10
                                                                            * (d1_of_place_11 + beta_rate_dot_of_place_17))
                                                                    + m4
                                                                        * (-cos_phi_minus_90deg
                                                                            * (e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (-d1_of_place_10 + beta_rate_dot_of_place_7 * ea_ss_inv
                                                                                        - beta_rate_dot_of_place_13
                                                                                            * (sin_phi_minus_90deg_inv
                                                                                                * beta_rate_dot_of_place_17
                                                                                                    .mul_add(S::int(2), d1_of_place_11)
                                                                                                - beta_rate_dot_of_place_14)) + beta_rate_dot_of_place_18)
                                                                                + ss_inv
                                                                                    * (beta_rate_dot_of_place_19 - sin_gamma_minus_delta
                                                                                        - sin_angle_cos_angle_inv
                                                                                            * cos_gamma_minus_delta
                                                                                                .mul_add(S::int(2), -d1_of_place_11)))
                                                                            + d1_of_place_14 * beta_rate_dot_of_place_17))
                                                                + cos_gamma_minus_delta
                                                                    * (e_inv * i4_e_inv
                                                                        * (-ss_inv)
                                                                            .mul_add(
                                                                                beta_rate_dot_of_place_20,
                                                                                d1_of_place_14 * beta_rate_dot_of_place_13
                                                                                    * beta_rate_dot_of_place_21,
                                                                            )
                                                                        + m4
                                                                            * (ss_inv
                                                                                * (beta_rate_dot_of_place_19 - beta_rate_dot_of_place_20)
                                                                                + e_inv
                                                                                    * (beta_rate_dot_of_place_13 * cos_gamma_minus_delta
                                                                                        * (beta_rate_dot_of_place_14 + beta_rate_dot_of_place_21)
                                                                                        - ea
                                                                                            * (ss_inv
                                                                                                * (-beta_rate_dot_of_place_20)
                                                                                                    .mul_add(S::int(2), beta_rate_dot_of_place_19)
                                                                                                + e_inv
                                                                                                    * (beta_rate_dot_of_place_18
                                                                                                        + cos_gamma_minus_delta
                                                                                                            * (beta_rate_dot_of_place_13
                                                                                                                * (-d1_of_e_ea)
                                                                                                                    .mul_add(
                                                                                                                        beta_rate_dot_of_place_21,
                                                                                                                        beta_rate_dot_of_place_14,
                                                                                                                    ) + sin_angle_cos_angle_inv * ea_ss_inv)))))))
                                                            + d1_of_place_14 * beta_rate_dot_of_place_22)
                                                    + ss_inv
                                                        * (beta_rate_dot_of_place_12 + beta_rate_dot_of_place_22
                                                            + sin_angle_cos_angle_inv
                                                                * (ss_inv_d1_of_place_2 + beta_rate_dot_of_place_23)))
                                                - d1_of_d_beta_gamma * sin_angle_cos_angle_inv
                                                    * beta_rate_dot_of_place_26)
                                            - d1_of_d_beta_gamma
                                                * (cos_theta
                                                    * (ss_inv * m2_da.mul_add(sin_angle, d1_of_place_2)
                                                        + beta_rate_dot_of_place_25)
                                                    + ss_inv * i2_plus_da_m2_da * d_inv
                                                        * (sin_beta_minus_gamma - beta_rate_dot_of_place_27)))
                                        + m2_da * d_inv
                                            * (-d1_of_d_beta_gamma)
                                                .mul_add(
                                                    cos_beta_minus_gamma,
                                                    ss_inv * beta_rate_dot_of_place_28,
                                                )) + beta_rate_dot_of_place_26 * cos_theta)))
                + d_inv * rr_beta_rate_sq
                    * (cos_angle_inv * d1_of_d_beta_gamma
                        * (m2_da
                            * da
                                .mul_add(
                                    beta_rate_dot_of_place_30,
                                    rr * beta_rate_dot_of_place_27 * cos_theta,
                                ) + I2 * beta_rate_dot_of_place_30)
                        - m2_da * beta_rate_dot_of_place_28))) / d1;
    let gamma_dot_value_of_beta_rate = beta_rate * rr_cos_angle_inv * sin_theta;
    let delta_dot_value_of_beta_rate = zt_inv * gamma_dot_value_of_beta_rate;
    let epsilon_dot_value_of_beta_rate = u_2_inv * gamma_dot_value_of_beta_rate;
    // Values.
    // beta' = beta_rate
    let beta_dot_value = beta_rate;
    // theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
    let theta_dot_value = beta_rate * (beta_rate_dot_of_place_29 - S::int(1));
    // gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
    let gamma_dot_value = ss_inv * gamma_dot_value_of_beta_rate;
    // delta' = rr*beta_rate*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_value = beta_rate_dot_of_place_15 * delta_dot_value_of_beta_rate;
    // phi' = -rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) + e*cos(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_value = -e_inv * sin_phi_minus_90deg_inv * delta_dot_value_of_beta_rate
        * e.mul_add(d1_of_place_10, zt * cos_gamma_minus_delta);
    // epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_value = beta_rate_dot_of_place_4 * epsilon_dot_value_of_beta_rate;
    // omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_value = zf_inv * cos_omega_inv * epsilon_dot_value_of_beta_rate
        * (-zf).mul_add(d1_of_place_3, u_2 * sin_gamma_minus_epsilon);
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
/// 1868 operations, 8 sines and cosines, 1 other function.
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
    let ss_inv = S::int(1) / ss;
    // ss_inv*(I3 + m3*(sa^2 + sb^2))
    let d1_of_place_2 = ss_inv * (I3 + m3 * sb.mul_add(sb, sa * sa));
    let ss_inv_d1_of_place_2 = ss_inv * d1_of_place_2;
    // gamma - epsilon
    let gamma_minus_epsilon = gamma - epsilon;
    let (sin_gamma_minus_epsilon, cos_gamma_minus_epsilon) = gamma_minus_epsilon
        .sin_cos();
    // sin(gamma - epsilon)*sin(omega) + cos(gamma - epsilon)*cos(omega)
    let d1_of_place_3 = cos_gamma_minus_epsilon
        .mul_add(cos_omega, sin_gamma_minus_epsilon * sin_omega);
    let sin_omega_d1_of_place_3 = d1_of_place_3 * sin_omega;
    let d1_of_place_4 = S::int(2) * sin_omega_d1_of_place_3;
    let zf_inv = S::int(1) / zf;
    let fa_zf_inv = fa * zf_inv;
    // fa_zf_inv - 2
    let d1_of_zf_fa = fa_zf_inv - S::int(2);
    let d1_of_place_5 = d1_of_zf_fa * sin_gamma_minus_epsilon;
    // d1_of_place_4 + d1_of_place_5
    let d1_of_place_6 = d1_of_place_4 + d1_of_place_5;
    // sin(gamma - epsilon) - d1_of_place_4
    let d1_of_place_7 = sin_gamma_minus_epsilon - d1_of_place_4;
    // fa_zf_inv*d1_of_place_6 + d1_of_place_7
    let d1_of_place_8 = fa_zf_inv.mul_add(d1_of_place_6, d1_of_place_7);
    let d1_of_place_9 = d1_of_place_8 * sin_gamma_minus_epsilon;
    let d1_of_place_10 = zf_inv * sin_gamma_minus_epsilon;
    let u_2_inv = S::int(1) / u_2;
    let d1_of_place_3_u_2_inv = d1_of_place_3 * u_2_inv;
    // ua^2 + ub^2
    let ua_sq_plus_ub_sq = ub.mul_add(ub, ua * ua);
    // I7 + m7*ua_sq_plus_ub_sq
    let d1_of_m7_i7_ua_ub = m7.mul_add(ua_sq_plus_ub_sq, I7);
    let d1_of_place_11 = d1_of_place_3_u_2_inv * d1_of_m7_i7_ua_ub;
    // I6*d1_of_place_10^2 + d1_of_place_3_u_2_inv*d1_of_place_11
    let d1_of_place_12 = d1_of_place_3_u_2_inv
        .mul_add(d1_of_place_11, I6 * d1_of_place_10 * d1_of_place_10);
    // m6*(d1_of_place_3^2 + d1_of_place_9) + d1_of_place_12
    let d1_of_place_13 = m6 * d1_of_place_3.mul_add(d1_of_place_3, d1_of_place_9) + d1_of_place_12;
    let cos_omega_inv = S::int(1) / cos_omega;
    let cos_omega_inv_sq = cos_omega_inv * cos_omega_inv;
    // gamma - delta
    let gamma_minus_delta = gamma - delta;
    let (sin_gamma_minus_delta, cos_gamma_minus_delta) = gamma_minus_delta.sin_cos();
    let d1_of_place_14 = cos_gamma_minus_delta * cos_phi_minus_90deg;
    // sin(gamma - delta)*sin(phi_minus_90deg) + d1_of_place_14
    let d1_of_place_15 = sin_gamma_minus_delta
        .mul_add(sin_phi_minus_90deg, d1_of_place_14);
    let d1_of_place_16 = d1_of_place_15 * cos_phi_minus_90deg;
    let d1_of_place_16_doubled = S::int(2) * d1_of_place_16;
    let e_inv = S::int(1) / e;
    let ea_e_inv = ea * e_inv;
    // ea_e_inv - 2
    let d1_of_e_ea = ea_e_inv - S::int(2);
    let d1_of_place_17 = d1_of_e_ea * cos_gamma_minus_delta;
    // cos(gamma - delta) - d1_of_place_16_doubled
    let d1_of_place_18 = cos_gamma_minus_delta - d1_of_place_16_doubled;
    // ea_e_inv*(d1_of_place_16_doubled + d1_of_place_17) + d1_of_place_18
    let d1_of_place_19 = ea_e_inv * (d1_of_place_16_doubled + d1_of_place_17) + d1_of_place_18;
    let d1_of_place_20 = d1_of_place_19 * cos_gamma_minus_delta;
    let zt_inv = S::int(1) / zt;
    let d1_of_place_15_zt_inv = d1_of_place_15 * zt_inv;
    // ta^2 + tb^2
    let ta_sq_plus_tb_sq = tb.mul_add(tb, ta * ta);
    // I5 + m5*ta_sq_plus_tb_sq
    let d1_of_m5_i5_ta_tb = m5.mul_add(ta_sq_plus_tb_sq, I5);
    let d1_of_place_21 = d1_of_place_15_zt_inv * d1_of_m5_i5_ta_tb;
    let d1_of_place_22 = e_inv * cos_gamma_minus_delta;
    let i4_d1_of_place_22 = I4 * d1_of_place_22;
    // d1_of_place_15_zt_inv*d1_of_place_21 + d1_of_place_22*i4_d1_of_place_22
    let d1_of_place_23 = d1_of_place_22
        .mul_add(i4_d1_of_place_22, d1_of_place_15_zt_inv * d1_of_place_21);
    // m4*(d1_of_place_15^2 + d1_of_place_20) + d1_of_place_23
    let d1_of_place_24 = m4 * d1_of_place_15.mul_add(d1_of_place_15, d1_of_place_20)
        + d1_of_place_23;
    let sin_phi_minus_90deg_inv = S::int(1) / sin_phi_minus_90deg;
    let d1_of_place_25 = sin_phi_minus_90deg_inv * sin_phi_minus_90deg_inv;
    // d1_of_place_13*cos_omega_inv_sq + d1_of_place_24*d1_of_place_25
    let d1_of_place_26 = d1_of_place_24
        .mul_add(d1_of_place_25, d1_of_place_13 * cos_omega_inv_sq);
    // ss_inv_d1_of_place_2 + d1_of_place_26
    let d1_of_place_27 = ss_inv_d1_of_place_2 + d1_of_place_26;
    let sin_theta_sq = sin_theta * sin_theta;
    let d_inv = S::int(1) / d;
    // beta - gamma
    let beta_minus_gamma = beta - gamma;
    let (sin_beta_minus_gamma, cos_beta_minus_gamma) = beta_minus_gamma.sin_cos();
    let d1_of_d_beta_gamma = d_inv * cos_beta_minus_gamma;
    let m2_da = m2 * da;
    // I2 + da*m2_da
    let i2_plus_da_m2_da = da.mul_add(m2_da, I2);
    let d1_of_place_28 = d1_of_d_beta_gamma * i2_plus_da_m2_da;
    // cos_angle_inv*(d1_of_place_27*sin_theta_sq + d1_of_d_beta_gamma*d1_of_place_28)
    let d1_of_place_29 = cos_angle_inv
        * d1_of_d_beta_gamma.mul_add(d1_of_place_28, d1_of_place_27 * sin_theta_sq);
    let cos_theta_m2_da = m2_da * cos_theta;
    let d1_of_d_beta_gamma_2 = S::int(2) * d1_of_d_beta_gamma;
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
                + cos_angle_inv * (-cos_theta_m2_da).mul_add(d1_of_d_beta_gamma_2, d1_of_place_29));
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
            * (sin_angle * (-d1_of_d_beta_gamma).mul_add(cos_theta_m2_da, d1_of_place_29)
                - d1_of_place_28 * d1_by_beta_of_d_beta_gamma) + d1_by_beta_of_place);
    let m4_d1_of_place_15 = m4 * d1_of_place_15;
    let beta_rate_dot_by_beta_of_place = d1_of_place_15 * m4_d1_of_place_15;
    let m6_d1_of_place_3 = m6 * d1_of_place_3;
    let beta_rate_dot_by_beta_of_place_2 = d1_of_place_3 * m6_d1_of_place_3;
    // beta_rate_dot_by_beta_of_place + beta_rate_dot_by_beta_of_place_2
    let beta_rate_dot_by_beta_of_place_3 = beta_rate_dot_by_beta_of_place
        + beta_rate_dot_by_beta_of_place_2;
    // ss_inv_d1_of_place_2 + beta_rate_dot_by_beta_of_place_3
    let beta_rate_dot_by_beta_of_place_4 = ss_inv_d1_of_place_2 + beta_rate_dot_by_beta_of_place_3;
    let sin_angle_cos_angle_inv = cos_angle_inv * sin_angle;
    let beta_rate_dot_by_beta_of_place_5 = sin_angle_cos_angle_inv * sin_angle_cos_angle_inv;
    // 1 + beta_rate_dot_by_beta_of_place_5
    let beta_rate_dot_by_beta_of_place_6 = S::int(1) + beta_rate_dot_by_beta_of_place_5;
    let beta_rate_dot_by_beta_of_place_7 = beta_rate_dot_by_beta_of_place_6
        * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_8 = S::int(2) * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_9 = beta_rate_dot_by_beta_of_place_6
        * beta_rate_dot_by_beta_of_place_8;
    let beta_rate_dot_by_beta_of_place_10 = ss_inv * beta_rate_dot_by_beta_of_place_7;
    let i6_zf_inv = I6 * zf_inv;
    let zf_inv_i6_zf_inv = zf_inv * i6_zf_inv;
    let beta_rate_dot_by_beta_of_place_11 = d1_of_place_3 * beta_rate_dot_by_beta_of_place_6;
    let ss_inv_u_2_inv = ss_inv * u_2_inv;
    let fa_ss_inv = fa * ss_inv;
    let beta_rate_dot_by_beta_of_place_12 = S::int(2) * beta_rate_dot_by_beta_of_place_6
        * fa_ss_inv;
    let m6_sin_omega = m6 * sin_omega;
    let ea_ss_inv = ea * ss_inv;
    let beta_rate_dot_by_beta_of_place_13 = beta_rate_dot_by_beta_of_place_6 * ea_ss_inv;
    let beta_rate_dot_by_beta_of_place_14 = ss_inv * beta_rate_dot_by_beta_of_place_6
        * cos_gamma_minus_delta;
    let i4_e_inv = I4 * e_inv;
    let e_inv_i4_e_inv = e_inv * i4_e_inv;
    let beta_rate_dot_by_beta_of_place_15 = d1_of_place_15 * beta_rate_dot_by_beta_of_place_6;
    let ss_inv_zt_inv = ss_inv * zt_inv;
    let beta_rate_dot_by_beta_of_gamma_delta = S::int(2) * cos_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_gamma_delta - d1_of_place_16
    let beta_rate_dot_by_beta_of_place_16 = beta_rate_dot_by_beta_of_gamma_delta - d1_of_place_16;
    let beta_rate_dot_by_beta_of_place_17 = S::int(2) * beta_rate_dot_by_beta_of_place_13;
    let m4_cos_phi_minus_90deg = m4 * cos_phi_minus_90deg;
    // sin(theta)*(ss_inv*beta_rate_dot_by_beta_of_place_4*beta_rate_dot_by_beta_of_place_6 +
    //   cos_omega_inv_sq*(sin(gamma -
    //   epsilon)*(m6*(ss_inv*fa_zf_inv*(fa_zf_inv*beta_rate_dot_by_beta_of_place_7 -
    //   beta_rate_dot_by_beta_of_place_9) + beta_rate_dot_by_beta_of_place_10) +
    //   beta_rate_dot_by_beta_of_place_10*zf_inv_i6_zf_inv) +
    //   d1_of_place_3*(u_2_inv*ss_inv_u_2_inv*(I7*beta_rate_dot_by_beta_of_place_11 +
    //   m7*ua_sq_plus_ub_sq*beta_rate_dot_by_beta_of_place_11) +
    //   m6_sin_omega*(d1_of_place_10*beta_rate_dot_by_beta_of_place_12 -
    //   ss_inv*(beta_rate_dot_by_beta_of_place_9 - beta_rate_dot_by_beta_of_place_11*sin(omega))))) +
    //   d1_of_place_25*(cos(gamma - delta)*(m4*(beta_rate_dot_by_beta_of_place_14 +
    //   ea_e_inv*(d1_of_place_22*beta_rate_dot_by_beta_of_place_13 - 2*beta_rate_dot_by_beta_of_place_14)) +
    //   beta_rate_dot_by_beta_of_place_14*e_inv_i4_e_inv) +
    //   d1_of_place_15*(zt_inv*ss_inv_zt_inv*(I5*beta_rate_dot_by_beta_of_place_15 +
    //   m5*ta_sq_plus_tb_sq*beta_rate_dot_by_beta_of_place_15) +
    //   m4_cos_phi_minus_90deg*(d1_of_place_22*beta_rate_dot_by_beta_of_place_17 -
    //   ss_inv*beta_rate_dot_by_beta_of_place_6*beta_rate_dot_by_beta_of_place_16))))
    let beta_rate_dot_by_beta_of_place_18 = sin_theta
        * (cos_omega_inv_sq
            * (sin_gamma_minus_epsilon
                * (m6
                    * (ss_inv * fa_zf_inv
                        * fa_zf_inv
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_7, -beta_rate_dot_by_beta_of_place_9,
                            ) + beta_rate_dot_by_beta_of_place_10)
                    + beta_rate_dot_by_beta_of_place_10 * zf_inv_i6_zf_inv)
                + d1_of_place_3
                    * (u_2_inv * ss_inv_u_2_inv
                        * (m7 * ua_sq_plus_ub_sq)
                            .mul_add(
                                beta_rate_dot_by_beta_of_place_11,
                                I7 * beta_rate_dot_by_beta_of_place_11,
                            )
                        + m6_sin_omega
                            * (-ss_inv
                                * (-beta_rate_dot_by_beta_of_place_11)
                                    .mul_add(sin_omega, beta_rate_dot_by_beta_of_place_9)
                                + d1_of_place_10 * beta_rate_dot_by_beta_of_place_12)))
            + ss_inv * beta_rate_dot_by_beta_of_place_4 * beta_rate_dot_by_beta_of_place_6
            + d1_of_place_25
                * (cos_gamma_minus_delta
                    * (m4
                        * (beta_rate_dot_by_beta_of_place_14
                            + ea_e_inv
                                * (-beta_rate_dot_by_beta_of_place_14)
                                    .mul_add(
                                        S::int(2),
                                        d1_of_place_22 * beta_rate_dot_by_beta_of_place_13,
                                    )) + beta_rate_dot_by_beta_of_place_14 * e_inv_i4_e_inv)
                    + d1_of_place_15
                        * (zt_inv * ss_inv_zt_inv
                            * (m5 * ta_sq_plus_tb_sq)
                                .mul_add(
                                    beta_rate_dot_by_beta_of_place_15,
                                    I5 * beta_rate_dot_by_beta_of_place_15,
                                )
                            + m4_cos_phi_minus_90deg
                                * (-(ss_inv * beta_rate_dot_by_beta_of_place_6))
                                    .mul_add(
                                        beta_rate_dot_by_beta_of_place_16,
                                        d1_of_place_22 * beta_rate_dot_by_beta_of_place_17,
                                    ))));
    // m6*(sin_omega_d1_of_place_3^2 + d1_of_place_9) + d1_of_place_12
    let beta_rate_dot_by_beta_of_place_19 = m6
        * sin_omega_d1_of_place_3.mul_add(sin_omega_d1_of_place_3, d1_of_place_9) + d1_of_place_12;
    // m4*(d1_of_place_16^2 + d1_of_place_20) + d1_of_place_23
    let beta_rate_dot_by_beta_of_place_20 = m4
        * d1_of_place_16.mul_add(d1_of_place_16, d1_of_place_20) + d1_of_place_23;
    // cos_omega_inv_sq*beta_rate_dot_by_beta_of_place_19 +
    //   d1_of_place_25*beta_rate_dot_by_beta_of_place_20
    let beta_rate_dot_by_beta_of_place_21 = d1_of_place_25
        .mul_add(
            beta_rate_dot_by_beta_of_place_20,
            cos_omega_inv_sq * beta_rate_dot_by_beta_of_place_19,
        );
    // beta_rate_dot_by_beta_of_place_4 + beta_rate_dot_by_beta_of_place_21
    let beta_rate_dot_by_beta_of_place_22 = beta_rate_dot_by_beta_of_place_4
        + beta_rate_dot_by_beta_of_place_21;
    let beta_rate_dot_by_beta_of_place_23 = d1_of_d_beta_gamma * beta_rate_dot_by_beta_of_place_6;
    // beta_rate_dot_by_beta_of_place_22*(d1_by_beta_of_d_beta_gamma*sin_angle_cos_angle_inv -
    //   beta_rate_dot_by_beta_of_place_23)
    let beta_rate_dot_by_beta_of_place_24 = beta_rate_dot_by_beta_of_place_22
        * d1_by_beta_of_d_beta_gamma
            .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_by_beta_of_place_23);
    let ss_inv_d_inv = ss_inv * d_inv;
    // i2_plus_da_m2_da*ss_inv_d_inv*(beta_rate_dot_by_beta_of_place_5*cos(beta - gamma) -
    //   sin_angle_cos_angle_inv*sin(beta - gamma))
    let beta_rate_dot_by_beta_of_place_25 = i2_plus_da_m2_da * ss_inv_d_inv
        * (-sin_angle_cos_angle_inv)
            .mul_add(
                sin_beta_minus_gamma,
                beta_rate_dot_by_beta_of_place_5 * cos_beta_minus_gamma,
            );
    let cos_angle_ss_inv = ss_inv * cos_angle;
    let beta_rate_dot_by_beta_of_place_26 = cos_theta_m2_da * cos_angle_ss_inv;
    // ss_inv*(d1_of_place_2 + m2_da*sin(beta + theta - gamma))
    let beta_rate_dot_by_beta_of_place_27 = ss_inv * m2_da.mul_add(sin_angle, d1_of_place_2);
    // beta_rate_dot_by_beta_of_place_3 + beta_rate_dot_by_beta_of_place_21 +
    //   beta_rate_dot_by_beta_of_place_27
    let beta_rate_dot_by_beta_of_place_28 = beta_rate_dot_by_beta_of_place_3
        + beta_rate_dot_by_beta_of_place_21 + beta_rate_dot_by_beta_of_place_27;
    // sin(beta - gamma) - sin_angle_cos_angle_inv*cos(beta - gamma)
    let beta_rate_dot_by_beta_of_place_29 = (-sin_angle_cos_angle_inv)
        .mul_add(cos_beta_minus_gamma, sin_beta_minus_gamma);
    let beta_rate_dot_by_beta_of_place_30 = i2_plus_da_m2_da * beta_rate_dot_by_beta_of_place_29;
    let beta_rate_dot_by_beta_of_place_31 = ss_inv_d_inv * beta_rate_dot_by_beta_of_place_30;
    // beta_rate_dot_by_beta_of_place_28*cos(theta) + beta_rate_dot_by_beta_of_place_31
    let beta_rate_dot_by_beta_of_place_32 = beta_rate_dot_by_beta_of_place_28
        .mul_add(cos_theta, beta_rate_dot_by_beta_of_place_31);
    let beta_rate_dot_by_beta_of_place_33 = d1_by_beta_of_d_beta_gamma
        * beta_rate_dot_by_beta_of_place_32;
    let beta_rate_dot_by_beta_of_place_34 = cos_theta * cos_beta_minus_gamma;
    let d_inv_m2_da = d_inv * m2_da;
    let beta_rate_dot_by_beta_of_place_35 = u_2_inv * d1_of_m7_i7_ua_ub;
    let fa_doubled = S::int(2) * fa;
    // beta_rate_dot_by_beta_of_place_35 - m6_sin_omega*fa_doubled
    let beta_rate_dot_by_beta_of_place_36 = (-m6_sin_omega)
        .mul_add(fa_doubled, beta_rate_dot_by_beta_of_place_35);
    // m6*fa*d1_of_zf_fa + i6_zf_inv
    let beta_rate_dot_by_beta_of_m6_i6_zf_fa = (m6 * fa).mul_add(d1_of_zf_fa, i6_zf_inv);
    let beta_rate_dot_by_beta_of_place_37 = beta_rate_dot_by_beta_of_m6_i6_zf_fa
        * sin_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_37 - d1_of_place_3*beta_rate_dot_by_beta_of_place_36
    let beta_rate_dot_by_beta_of_place_38 = (-d1_of_place_3)
        .mul_add(beta_rate_dot_by_beta_of_place_36, beta_rate_dot_by_beta_of_place_37);
    let sin_omega_cos_omega_inv = cos_omega_inv * sin_omega;
    // cos(gamma - epsilon)*sin(omega) - sin(gamma - epsilon)*cos(omega)
    let beta_rate_dot_by_beta_of_place_39 = (-sin_gamma_minus_epsilon)
        .mul_add(cos_omega, cos_gamma_minus_epsilon * sin_omega);
    let beta_rate_dot_by_beta_of_place_40 = beta_rate_dot_by_beta_of_place_35
        * beta_rate_dot_by_beta_of_place_39;
    let beta_rate_dot_by_beta_of_place_41 = beta_rate_dot_by_beta_of_m6_i6_zf_fa
        * cos_gamma_minus_epsilon;
    // m6*(cos(gamma - epsilon) + d1_of_place_7*sin_omega_cos_omega_inv) +
    //   zf_inv*(beta_rate_dot_by_beta_of_place_38*sin_omega_cos_omega_inv +
    //   beta_rate_dot_by_beta_of_place_40 + beta_rate_dot_by_beta_of_place_41)
    let beta_rate_dot_by_beta_of_place_42 = m6
        * d1_of_place_7.mul_add(sin_omega_cos_omega_inv, cos_gamma_minus_epsilon)
        + zf_inv
            * (beta_rate_dot_by_beta_of_place_38
                .mul_add(sin_omega_cos_omega_inv, beta_rate_dot_by_beta_of_place_40)
                + beta_rate_dot_by_beta_of_place_41);
    // fa_zf_inv - 1
    let beta_rate_dot_by_beta_of_zf_fa = fa_zf_inv - S::int(1);
    let beta_rate_dot_by_beta_of_place_43 = beta_rate_dot_by_beta_of_zf_fa
        * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_place_44 = u_2_inv * beta_rate_dot_by_beta_of_place_35;
    // m6_sin_omega*sin(omega) + beta_rate_dot_by_beta_of_place_44
    let beta_rate_dot_by_beta_of_place_45 = m6_sin_omega
        .mul_add(sin_omega, beta_rate_dot_by_beta_of_place_44);
    let beta_rate_dot_by_beta_of_place_46 = cos_omega_inv * beta_rate_dot_by_beta_of_place_45;
    // m6*beta_rate_dot_by_beta_of_place_43 + d1_of_place_3*beta_rate_dot_by_beta_of_place_46
    let beta_rate_dot_by_beta_of_place_47 = d1_of_place_3
        .mul_add(
            beta_rate_dot_by_beta_of_place_46,
            m6 * beta_rate_dot_by_beta_of_place_43,
        );
    // beta_rate_dot_by_beta_of_place_42*sin(gamma - epsilon) +
    //   sin_omega_d1_of_place_3*beta_rate_dot_by_beta_of_place_47
    let beta_rate_dot_by_beta_of_place_48 = sin_omega_d1_of_place_3
        .mul_add(
            beta_rate_dot_by_beta_of_place_47,
            beta_rate_dot_by_beta_of_place_42 * sin_gamma_minus_epsilon,
        );
    let beta_rate_dot_by_beta_of_place_49 = beta_rate_dot_by_beta_of_zf_fa
        * sin_gamma_minus_epsilon;
    // sin_omega_d1_of_place_3 + beta_rate_dot_by_beta_of_place_49
    let beta_rate_dot_by_beta_of_place_50 = sin_omega_d1_of_place_3
        + beta_rate_dot_by_beta_of_place_49;
    // beta_rate_dot_by_beta_of_place_39 - d1_of_place_3*sin_angle_cos_angle_inv
    let beta_rate_dot_by_beta_of_place_51 = (-d1_of_place_3)
        .mul_add(sin_angle_cos_angle_inv, beta_rate_dot_by_beta_of_place_39);
    // sin_omega_d1_of_place_3 + beta_rate_dot_by_beta_of_place_8*beta_rate_dot_by_beta_of_zf_fa
    let beta_rate_dot_by_beta_of_place_52 = beta_rate_dot_by_beta_of_place_8
        .mul_add(beta_rate_dot_by_beta_of_zf_fa, sin_omega_d1_of_place_3);
    let beta_rate_dot_by_beta_of_place_53 = cos_omega_inv * beta_rate_dot_by_beta_of_place_52;
    // beta_rate_dot_by_beta_of_place_39 - beta_rate_dot_by_beta_of_place_53
    let beta_rate_dot_by_beta_of_place_54 = beta_rate_dot_by_beta_of_place_39
        - beta_rate_dot_by_beta_of_place_53;
    let beta_rate_dot_by_beta_of_place_55 = S::int(2) * sin_angle_cos_angle_inv;
    // d1_of_place_3 - sin_omega_cos_omega_inv*beta_rate_dot_by_beta_of_place_54 -
    //   fa_ss_inv*beta_rate_dot_by_beta_of_place_55
    let beta_rate_dot_by_beta_of_place_56 = (-sin_omega_cos_omega_inv)
        .mul_add(beta_rate_dot_by_beta_of_place_54, d1_of_place_3)
        - fa_ss_inv * beta_rate_dot_by_beta_of_place_55;
    let beta_rate_dot_by_beta_of_place_57 = beta_rate_dot_by_beta_of_place_55
        * sin_gamma_minus_epsilon;
    // zf_inv*(fa_ss_inv*cos(gamma - epsilon) + beta_rate_dot_by_beta_of_place_56*sin(gamma - epsilon)) +
    //   ss_inv*(beta_rate_dot_by_beta_of_place_51*sin(omega) - cos(gamma - epsilon) +
    //   beta_rate_dot_by_beta_of_place_57)
    let beta_rate_dot_by_beta_of_place_58 = zf_inv
        * beta_rate_dot_by_beta_of_place_56
            .mul_add(sin_gamma_minus_epsilon, fa_ss_inv * cos_gamma_minus_epsilon)
        + ss_inv
            * (beta_rate_dot_by_beta_of_place_51
                .mul_add(sin_omega, -cos_gamma_minus_epsilon) + beta_rate_dot_by_beta_of_place_57);
    // u_2_inv*(cos_omega_inv*beta_rate_dot_by_beta_of_place_48 +
    //   m6_d1_of_place_3*beta_rate_dot_by_beta_of_place_50 -
    //   ss_inv_u_2_inv*(I7*beta_rate_dot_by_beta_of_place_51 +
    //   m7*ua_sq_plus_ub_sq*beta_rate_dot_by_beta_of_place_51)) -
    //   m6*(d1_of_place_10*beta_rate_dot_by_beta_of_place_49 + beta_rate_dot_by_beta_of_place_58*sin(omega))
    let beta_rate_dot_by_beta_of_place_59 = u_2_inv
        * (cos_omega_inv * beta_rate_dot_by_beta_of_place_48
            + m6_d1_of_place_3 * beta_rate_dot_by_beta_of_place_50
            - ss_inv_u_2_inv
                * (m7 * ua_sq_plus_ub_sq)
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_51,
                        I7 * beta_rate_dot_by_beta_of_place_51,
                    ))
        - m6
            * beta_rate_dot_by_beta_of_place_58
                .mul_add(sin_omega, d1_of_place_10 * beta_rate_dot_by_beta_of_place_49);
    let beta_rate_dot_by_beta_of_place_60 = beta_rate_dot_by_beta_of_place_39 * sin_omega;
    // sin_angle_cos_angle_inv*sin(gamma - epsilon) - cos(gamma - epsilon)
    let beta_rate_dot_by_beta_of_place_61 = sin_angle_cos_angle_inv
        .mul_add(sin_gamma_minus_epsilon, -cos_gamma_minus_epsilon);
    // -beta_rate_dot_by_beta_of_place_61
    let beta_rate_dot_by_beta_of_place_62 = -beta_rate_dot_by_beta_of_place_61;
    let beta_rate_dot_by_beta_of_place_63 = S::int(2) * cos_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_39 - d1_of_place_5*cos_omega_inv
    let beta_rate_dot_by_beta_of_place_64 = (-d1_of_place_5)
        .mul_add(cos_omega_inv, beta_rate_dot_by_beta_of_place_39);
    let beta_rate_dot_by_beta_of_place_65 = d1_of_place_10 * sin_omega_cos_omega_inv;
    let beta_rate_dot_by_beta_of_place_66 = cos_omega_inv * sin_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_39 + beta_rate_dot_by_beta_of_place_66
    let beta_rate_dot_by_beta_of_place_67 = beta_rate_dot_by_beta_of_place_39
        + beta_rate_dot_by_beta_of_place_66;
    let beta_rate_dot_by_beta_of_place_68 = sin_omega_cos_omega_inv * sin_gamma_minus_epsilon;
    let beta_rate_dot_by_beta_of_omega = cos_omega_inv * sin_omega_cos_omega_inv;
    let beta_rate_dot_by_beta_of_place_69 = d1_of_place_10 * beta_rate_dot_by_beta_of_omega;
    // m6*(zf_inv*(fa*(ss_inv*(beta_rate_dot_by_beta_of_place_57 + beta_rate_dot_by_beta_of_place_60 +
    //   fa_zf_inv*beta_rate_dot_by_beta_of_place_62 - beta_rate_dot_by_beta_of_place_63) -
    //   beta_rate_dot_by_beta_of_place_64*beta_rate_dot_by_beta_of_place_65) +
    //   beta_rate_dot_by_beta_of_place_67*beta_rate_dot_by_beta_of_place_68) -
    //   ss_inv*(beta_rate_dot_by_beta_of_place_60 + beta_rate_dot_by_beta_of_place_61)) +
    //   zf_inv_i6_zf_inv*(ss_inv*beta_rate_dot_by_beta_of_place_62 +
    //   beta_rate_dot_by_beta_of_place_69*sin(gamma - epsilon))
    let beta_rate_dot_by_beta_of_place_70 = m6
        * (zf_inv
            * (fa
                * (ss_inv
                    * (fa_zf_inv
                        .mul_add(
                            beta_rate_dot_by_beta_of_place_62,
                            beta_rate_dot_by_beta_of_place_57 + beta_rate_dot_by_beta_of_place_60,
                        ) - beta_rate_dot_by_beta_of_place_63)
                    - beta_rate_dot_by_beta_of_place_64 * beta_rate_dot_by_beta_of_place_65)
                + beta_rate_dot_by_beta_of_place_67 * beta_rate_dot_by_beta_of_place_68)
            - ss_inv
                * (beta_rate_dot_by_beta_of_place_60 + beta_rate_dot_by_beta_of_place_61))
        + zf_inv_i6_zf_inv
            * beta_rate_dot_by_beta_of_place_69
                .mul_add(
                    sin_gamma_minus_epsilon,
                    ss_inv * beta_rate_dot_by_beta_of_place_62,
                );
    // d1_of_place_3*beta_rate_dot_by_beta_of_place_59 - beta_rate_dot_by_beta_of_place_70*sin(gamma -
    //   epsilon)
    let beta_rate_dot_by_beta_of_place_71 = (-beta_rate_dot_by_beta_of_place_70)
        .mul_add(
            sin_gamma_minus_epsilon,
            d1_of_place_3 * beta_rate_dot_by_beta_of_place_59,
        );
    let beta_rate_dot_by_beta_of_place_72 = m6_d1_of_place_3 * beta_rate_dot_by_beta_of_place_39;
    // cos_omega_inv*beta_rate_dot_by_beta_of_place_71 + d1_of_place_10*beta_rate_dot_by_beta_of_place_72
    let beta_rate_dot_by_beta_of_place_73 = d1_of_place_10
        .mul_add(
            beta_rate_dot_by_beta_of_place_72,
            cos_omega_inv * beta_rate_dot_by_beta_of_place_71,
        );
    let zt_inv_d1_of_m5_i5_ta_tb = zt_inv * d1_of_m5_i5_ta_tb;
    let ea_doubled = S::int(2) * ea;
    // zt_inv_d1_of_m5_i5_ta_tb + m4_cos_phi_minus_90deg*ea_doubled
    let beta_rate_dot_by_beta_of_place_74 = m4_cos_phi_minus_90deg
        .mul_add(ea_doubled, zt_inv_d1_of_m5_i5_ta_tb);
    // m4*ea*d1_of_e_ea + i4_e_inv
    let beta_rate_dot_by_beta_of_m4_i4_e_ea = (m4 * ea).mul_add(d1_of_e_ea, i4_e_inv);
    let beta_rate_dot_by_beta_of_place_75 = beta_rate_dot_by_beta_of_m4_i4_e_ea
        * cos_gamma_minus_delta;
    // d1_of_place_15*beta_rate_dot_by_beta_of_place_74 + beta_rate_dot_by_beta_of_place_75
    let beta_rate_dot_by_beta_of_place_76 = d1_of_place_15
        .mul_add(beta_rate_dot_by_beta_of_place_74, beta_rate_dot_by_beta_of_place_75);
    let beta_rate_dot_by_beta_of_place_77 = sin_phi_minus_90deg_inv * cos_phi_minus_90deg;
    // cos(gamma - delta)*sin(phi_minus_90deg) - sin(gamma - delta)*cos(phi_minus_90deg)
    let beta_rate_dot_by_beta_of_place_78 = (-sin_gamma_minus_delta)
        .mul_add(cos_phi_minus_90deg, cos_gamma_minus_delta * sin_phi_minus_90deg);
    // -beta_rate_dot_by_beta_of_place_78
    let beta_rate_dot_by_beta_of_place_79 = -beta_rate_dot_by_beta_of_place_78;
    let beta_rate_dot_by_beta_of_place_80 = zt_inv_d1_of_m5_i5_ta_tb
        * beta_rate_dot_by_beta_of_place_79;
    let beta_rate_dot_by_beta_of_place_81 = beta_rate_dot_by_beta_of_m4_i4_e_ea
        * sin_gamma_minus_delta;
    // m4*(sin(gamma - delta) + d1_of_place_18*beta_rate_dot_by_beta_of_place_77) +
    //   e_inv*(beta_rate_dot_by_beta_of_place_76*beta_rate_dot_by_beta_of_place_77 -
    //   beta_rate_dot_by_beta_of_place_80 + beta_rate_dot_by_beta_of_place_81)
    let beta_rate_dot_by_beta_of_place_82 = m4
        * d1_of_place_18
            .mul_add(beta_rate_dot_by_beta_of_place_77, sin_gamma_minus_delta)
        + e_inv
            * (beta_rate_dot_by_beta_of_place_76
                .mul_add(
                    beta_rate_dot_by_beta_of_place_77, -beta_rate_dot_by_beta_of_place_80,
                ) + beta_rate_dot_by_beta_of_place_81);
    // ea_e_inv - 1
    let beta_rate_dot_by_beta_of_e_ea = ea_e_inv - S::int(1);
    let beta_rate_dot_by_beta_of_place_83 = beta_rate_dot_by_beta_of_e_ea * sin_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_84 = zt_inv * zt_inv_d1_of_m5_i5_ta_tb;
    // m4_cos_phi_minus_90deg*cos(phi_minus_90deg) + beta_rate_dot_by_beta_of_place_84
    let beta_rate_dot_by_beta_of_place_85 = m4_cos_phi_minus_90deg
        .mul_add(cos_phi_minus_90deg, beta_rate_dot_by_beta_of_place_84);
    let beta_rate_dot_by_beta_of_place_86 = d1_of_place_15 * sin_phi_minus_90deg_inv;
    // m4*beta_rate_dot_by_beta_of_place_83 +
    //   beta_rate_dot_by_beta_of_place_85*beta_rate_dot_by_beta_of_place_86
    let beta_rate_dot_by_beta_of_place_87 = beta_rate_dot_by_beta_of_place_85
        .mul_add(
            beta_rate_dot_by_beta_of_place_86,
            m4 * beta_rate_dot_by_beta_of_place_83,
        );
    // beta_rate_dot_by_beta_of_place_82*cos(gamma - delta) +
    //   d1_of_place_16*beta_rate_dot_by_beta_of_place_87
    let beta_rate_dot_by_beta_of_place_88 = d1_of_place_16
        .mul_add(
            beta_rate_dot_by_beta_of_place_87,
            beta_rate_dot_by_beta_of_place_82 * cos_gamma_minus_delta,
        );
    let beta_rate_dot_by_beta_of_place_89 = beta_rate_dot_by_beta_of_e_ea * cos_gamma_minus_delta;
    // d1_of_place_16 + beta_rate_dot_by_beta_of_place_89
    let beta_rate_dot_by_beta_of_place_90 = d1_of_place_16 + beta_rate_dot_by_beta_of_place_89;
    // d1_of_place_15*sin_angle_cos_angle_inv - beta_rate_dot_by_beta_of_place_78
    let beta_rate_dot_by_beta_of_place_91 = d1_of_place_15
        .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_by_beta_of_place_78);
    let beta_rate_dot_by_beta_of_place_92 = ta_sq_plus_tb_sq * beta_rate_dot_by_beta_of_place_91;
    // d1_of_place_16 + 2*beta_rate_dot_by_beta_of_place_89
    let beta_rate_dot_by_beta_of_place_93 = beta_rate_dot_by_beta_of_place_89
        .mul_add(S::int(2), d1_of_place_16);
    let beta_rate_dot_by_beta_of_place_94 = sin_phi_minus_90deg_inv
        * beta_rate_dot_by_beta_of_place_93;
    // -beta_rate_dot_by_beta_of_place_78 - beta_rate_dot_by_beta_of_place_94
    let beta_rate_dot_by_beta_of_place_95 = -beta_rate_dot_by_beta_of_place_78
        - beta_rate_dot_by_beta_of_place_94;
    // ea_ss_inv*beta_rate_dot_by_beta_of_place_55 - d1_of_place_15 +
    //   beta_rate_dot_by_beta_of_place_77*beta_rate_dot_by_beta_of_place_95
    let beta_rate_dot_by_beta_of_place_96 = ea_ss_inv
        .mul_add(beta_rate_dot_by_beta_of_place_55, -d1_of_place_15)
        + beta_rate_dot_by_beta_of_place_77 * beta_rate_dot_by_beta_of_place_95;
    let beta_rate_dot_by_beta_of_place_97 = ea_ss_inv * sin_gamma_minus_delta;
    let beta_rate_dot_by_beta_of_place_98 = beta_rate_dot_by_beta_of_place_79 * cos_phi_minus_90deg;
    // sin(gamma - delta) - beta_rate_dot_by_beta_of_place_98
    let beta_rate_dot_by_beta_of_place_99 = sin_gamma_minus_delta
        - beta_rate_dot_by_beta_of_place_98;
    // e_inv*(beta_rate_dot_by_beta_of_place_96*cos(gamma - delta) + beta_rate_dot_by_beta_of_place_97) -
    //   ss_inv*(sin_angle_cos_angle_inv*beta_rate_dot_by_beta_of_place_16 +
    //   beta_rate_dot_by_beta_of_place_99)
    let beta_rate_dot_by_beta_of_place_100 = e_inv
        * beta_rate_dot_by_beta_of_place_96
            .mul_add(cos_gamma_minus_delta, beta_rate_dot_by_beta_of_place_97)
        - ss_inv
            * sin_angle_cos_angle_inv
                .mul_add(
                    beta_rate_dot_by_beta_of_place_16, beta_rate_dot_by_beta_of_place_99,
                );
    // zt_inv*(sin_phi_minus_90deg_inv*beta_rate_dot_by_beta_of_place_88 +
    //   m4_d1_of_place_15*beta_rate_dot_by_beta_of_place_90 -
    //   ss_inv_zt_inv*(I5*beta_rate_dot_by_beta_of_place_91 + m5*beta_rate_dot_by_beta_of_place_92)) +
    //   m4*(d1_of_place_22*beta_rate_dot_by_beta_of_place_89 -
    //   beta_rate_dot_by_beta_of_place_100*cos(phi_minus_90deg))
    let beta_rate_dot_by_beta_of_place_101 = zt_inv
        * (sin_phi_minus_90deg_inv * beta_rate_dot_by_beta_of_place_88
            + m4_d1_of_place_15 * beta_rate_dot_by_beta_of_place_90
            - ss_inv_zt_inv
                * m5
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_92,
                        I5 * beta_rate_dot_by_beta_of_place_91,
                    ))
        + m4
            * (-beta_rate_dot_by_beta_of_place_100)
                .mul_add(
                    cos_phi_minus_90deg,
                    d1_of_place_22 * beta_rate_dot_by_beta_of_place_89,
                );
    // d1_of_place_17*sin_phi_minus_90deg_inv + beta_rate_dot_by_beta_of_place_78
    let beta_rate_dot_by_beta_of_place_102 = d1_of_place_17
        .mul_add(sin_phi_minus_90deg_inv, beta_rate_dot_by_beta_of_place_78);
    // -beta_rate_dot_by_beta_of_place_102
    let beta_rate_dot_by_beta_of_place_103 = -beta_rate_dot_by_beta_of_place_102;
    let beta_rate_dot_by_beta_of_place_104 = sin_angle_cos_angle_inv * ea_ss_inv;
    // beta_rate_dot_by_beta_of_place_77*beta_rate_dot_by_beta_of_place_103 +
    //   beta_rate_dot_by_beta_of_place_104
    let beta_rate_dot_by_beta_of_place_105 = beta_rate_dot_by_beta_of_place_77
        .mul_add(beta_rate_dot_by_beta_of_place_103, beta_rate_dot_by_beta_of_place_104);
    let beta_rate_dot_by_beta_of_gamma_delta_2 = S::int(2) * sin_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_place_98 - beta_rate_dot_by_beta_of_gamma_delta_2
    let beta_rate_dot_by_beta_of_place_106 = beta_rate_dot_by_beta_of_place_98
        - beta_rate_dot_by_beta_of_gamma_delta_2;
    // ss_inv*(beta_rate_dot_by_beta_of_place_55*cos(gamma - delta) - beta_rate_dot_by_beta_of_place_106)
    let beta_rate_dot_by_beta_of_place_107 = ss_inv
        * beta_rate_dot_by_beta_of_place_55
            .mul_add(cos_gamma_minus_delta, -beta_rate_dot_by_beta_of_place_106);
    let beta_rate_dot_by_beta_of_place_108 = sin_phi_minus_90deg_inv * cos_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_place_108 - beta_rate_dot_by_beta_of_place_78
    let beta_rate_dot_by_beta_of_place_109 = beta_rate_dot_by_beta_of_place_108
        - beta_rate_dot_by_beta_of_place_78;
    let beta_rate_dot_by_beta_of_place_110 = beta_rate_dot_by_beta_of_place_77
        * cos_gamma_minus_delta;
    // sin(gamma - delta) + sin_angle_cos_angle_inv*cos(gamma - delta)
    let beta_rate_dot_by_beta_of_place_111 = sin_angle_cos_angle_inv
        .mul_add(cos_gamma_minus_delta, sin_gamma_minus_delta);
    // ss_inv*(beta_rate_dot_by_beta_of_place_111 - beta_rate_dot_by_beta_of_place_98)
    let beta_rate_dot_by_beta_of_place_112 = ss_inv
        * (beta_rate_dot_by_beta_of_place_111 - beta_rate_dot_by_beta_of_place_98);
    let beta_rate_dot_by_beta_of_place_113 = ss_inv * beta_rate_dot_by_beta_of_place_111;
    let beta_rate_dot_by_beta_of_place_114 = sin_phi_minus_90deg_inv
        * beta_rate_dot_by_beta_of_place_77;
    let beta_rate_dot_by_beta_of_place_115 = beta_rate_dot_by_beta_of_place_114
        * cos_gamma_minus_delta;
    // m4*(beta_rate_dot_by_beta_of_place_112 - e_inv*(ea*(beta_rate_dot_by_beta_of_place_107 -
    //   e_inv*(beta_rate_dot_by_beta_of_place_97 + beta_rate_dot_by_beta_of_place_105*cos(gamma - delta))) +
    //   beta_rate_dot_by_beta_of_place_109*beta_rate_dot_by_beta_of_place_110)) +
    //   e_inv_i4_e_inv*(beta_rate_dot_by_beta_of_place_113 -
    //   d1_of_place_22*beta_rate_dot_by_beta_of_place_115)
    let beta_rate_dot_by_beta_of_place_116 = m4
        * (beta_rate_dot_by_beta_of_place_112
            - e_inv
                * (ea
                    * (beta_rate_dot_by_beta_of_place_107
                        - e_inv
                            * beta_rate_dot_by_beta_of_place_105
                                .mul_add(
                                    cos_gamma_minus_delta, beta_rate_dot_by_beta_of_place_97,
                                ))
                    + beta_rate_dot_by_beta_of_place_109 * beta_rate_dot_by_beta_of_place_110))
        + e_inv_i4_e_inv
            * (-d1_of_place_22)
                .mul_add(
                    beta_rate_dot_by_beta_of_place_115, beta_rate_dot_by_beta_of_place_113,
                );
    // d1_of_place_15*beta_rate_dot_by_beta_of_place_101 - beta_rate_dot_by_beta_of_place_116*cos(gamma -
    //   delta)
    let beta_rate_dot_by_beta_of_place_117 = (-beta_rate_dot_by_beta_of_place_116)
        .mul_add(
            cos_gamma_minus_delta,
            d1_of_place_15 * beta_rate_dot_by_beta_of_place_101,
        );
    let beta_rate_dot_by_beta_of_place_118 = m4_d1_of_place_15 * beta_rate_dot_by_beta_of_place_79;
    // sin_phi_minus_90deg_inv*beta_rate_dot_by_beta_of_place_117 -
    //   d1_of_place_22*beta_rate_dot_by_beta_of_place_118
    let beta_rate_dot_by_beta_of_place_119 = (-d1_of_place_22)
        .mul_add(
            beta_rate_dot_by_beta_of_place_118,
            sin_phi_minus_90deg_inv * beta_rate_dot_by_beta_of_place_117,
        );
    // beta_rate_dot_by_beta_of_place_72 - beta_rate_dot_by_beta_of_place_118
    let beta_rate_dot_by_beta_of_place_120 = beta_rate_dot_by_beta_of_place_72
        - beta_rate_dot_by_beta_of_place_118;
    // cos_omega_inv*beta_rate_dot_by_beta_of_place_73 -
    //   sin_phi_minus_90deg_inv*beta_rate_dot_by_beta_of_place_119 +
    //   ss_inv*(beta_rate_dot_by_beta_of_place_4*sin_angle_cos_angle_inv -
    //   beta_rate_dot_by_beta_of_place_120)
    let beta_rate_dot_by_beta_of_place_121 = cos_omega_inv * beta_rate_dot_by_beta_of_place_73
        - sin_phi_minus_90deg_inv * beta_rate_dot_by_beta_of_place_119
        + ss_inv
            * beta_rate_dot_by_beta_of_place_4
                .mul_add(sin_angle_cos_angle_inv, -beta_rate_dot_by_beta_of_place_120);
    let beta_rate_dot_by_beta_of_place_122 = d1_of_d_beta_gamma * sin_angle_cos_angle_inv;
    // beta_rate_dot_by_beta_of_place_121*sin(theta) -
    //   beta_rate_dot_by_beta_of_place_22*beta_rate_dot_by_beta_of_place_122
    let beta_rate_dot_by_beta_of_place_123 = (-beta_rate_dot_by_beta_of_place_22)
        .mul_add(
            beta_rate_dot_by_beta_of_place_122,
            beta_rate_dot_by_beta_of_place_121 * sin_theta,
        );
    // beta_rate_dot_by_beta_of_place_123*sin(theta) - d1_of_d_beta_gamma*beta_rate_dot_by_beta_of_place_32
    let beta_rate_dot_by_beta_of_place_124 = (-d1_of_d_beta_gamma)
        .mul_add(
            beta_rate_dot_by_beta_of_place_32,
            beta_rate_dot_by_beta_of_place_123 * sin_theta,
        );
    let beta_rate_dot_by_beta_of_place_125 = cos_angle_inv * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_beta_of_place_126 = beta_rate_dot_by_beta_of_place_124
        * beta_rate_dot_by_beta_of_place_125;
    // d_inv_m2_da*(d1_of_d_beta_gamma_2*sin(beta - gamma) + ss_inv*beta_rate_dot_by_beta_of_place_34) +
    //   beta_rate_dot_by_beta_of_place_126
    let beta_rate_dot_by_beta_of_place_127 = d_inv_m2_da
        * ss_inv
            .mul_add(
                beta_rate_dot_by_beta_of_place_34,
                d1_of_d_beta_gamma_2 * sin_beta_minus_gamma,
            ) + beta_rate_dot_by_beta_of_place_126;
    let beta_rate_dot_by_beta_of_place_128 = cos_theta * sin_beta_minus_gamma;
    // d_inv_m2_da*(d1_of_d_beta_gamma*cos(beta - gamma) - ss_inv*beta_rate_dot_by_beta_of_place_128)
    let beta_rate_dot_by_beta_of_place_129 = d_inv_m2_da
        * (-ss_inv)
            .mul_add(
                beta_rate_dot_by_beta_of_place_128,
                d1_of_d_beta_gamma * cos_beta_minus_gamma,
            );
    // rr*(beta_rate_dot_by_beta_of_place_129 - cos_angle_inv*beta_rate_dot_by_beta_of_place_124) -
    //   beta_rate_dot_by_beta_of_place_22*cos(theta)
    let beta_rate_dot_by_beta_of_place_130 = rr
        * (-cos_angle_inv)
            .mul_add(
                beta_rate_dot_by_beta_of_place_124, beta_rate_dot_by_beta_of_place_129,
            ) - beta_rate_dot_by_beta_of_place_22 * cos_theta;
    let beta_rate_dot_by_beta_of_place_131 = beta_rate_dot_by_beta_of_place_125
        * beta_rate_dot_by_beta_of_place_130;
    // m2_da*d1_by_beta_of_d_beta_gamma + beta_rate_dot_by_beta_of_place_131
    let beta_rate_dot_by_beta_of_place_132 = m2_da
        .mul_add(d1_by_beta_of_d_beta_gamma, beta_rate_dot_by_beta_of_place_131);
    let rr_beta_rate_sq = rr * beta_rate * beta_rate;
    let beta_rate_dot_by_beta_of_beta_rate = rr_beta_rate_sq * sin_theta;
    let beta_rate_dot_by_beta_of_place_133 = d1_of_d_beta_gamma * beta_rate_dot_by_beta_of_place_55;
    let beta_rate_dot_by_beta_of_place_134 = rr_cos_angle_inv * cos_beta_minus_gamma;
    // beta_rate_dot_by_beta_of_place_134*(d1_of_d_beta_gamma +
    //   beta_rate_dot_by_beta_of_place_55*beta_rate_dot_by_beta_of_place_122)
    let beta_rate_dot_by_beta_of_place_135 = beta_rate_dot_by_beta_of_place_134
        * beta_rate_dot_by_beta_of_place_55
            .mul_add(beta_rate_dot_by_beta_of_place_122, d1_of_d_beta_gamma);
    // cos(beta - gamma) + rr_cos_angle_inv*beta_rate_dot_by_beta_of_place_133*sin(beta - gamma) -
    //   beta_rate_dot_by_beta_of_place_135
    let beta_rate_dot_by_beta_of_place_136 = (rr_cos_angle_inv * beta_rate_dot_by_beta_of_place_133)
        .mul_add(sin_beta_minus_gamma, cos_beta_minus_gamma) - beta_rate_dot_by_beta_of_place_135;
    let beta_rate_dot_by_beta_of_place_137 = rr * sin_angle_cos_angle_inv;
    let beta_rate_dot_by_beta_of_place_138 = rr * beta_rate_dot_by_beta_of_place_6
        * beta_rate_dot_by_beta_of_place_34;
    let beta_rate_dot_by_beta_of_place_139 = cos_angle_inv * d1_of_d_beta_gamma;
    // sin(beta - gamma) - beta_rate_dot_by_beta_of_place_122*beta_rate_dot_by_beta_of_place_134
    let beta_rate_dot_by_beta_of_place_140 = (-beta_rate_dot_by_beta_of_place_122)
        .mul_add(beta_rate_dot_by_beta_of_place_134, sin_beta_minus_gamma);
    // I2*beta_rate_dot_by_beta_of_place_140 +
    //   m2_da*(beta_rate_dot_by_beta_of_place_34*beta_rate_dot_by_beta_of_place_137 +
    //   da*beta_rate_dot_by_beta_of_place_140)
    let beta_rate_dot_by_beta_of_place_141 = m2_da
        * da
            .mul_add(
                beta_rate_dot_by_beta_of_place_140,
                beta_rate_dot_by_beta_of_place_34 * beta_rate_dot_by_beta_of_place_137,
            ) + I2 * beta_rate_dot_by_beta_of_place_140;
    let beta_rate_dot_by_beta_of_place_142 = cos_angle_inv * beta_rate_dot_by_beta_of_place_141;
    let d_inv_rr_beta_rate_sq = d_inv * rr_beta_rate_sq;
    // d_inv_rr_beta_rate_sq*(beta_rate_dot_by_beta_of_place_139*(I2*beta_rate_dot_by_beta_of_place_136 +
    //   m2_da*(da*beta_rate_dot_by_beta_of_place_136 -
    //   beta_rate_dot_by_beta_of_place_128*beta_rate_dot_by_beta_of_place_137 +
    //   beta_rate_dot_by_beta_of_place_138)) - cos_theta_m2_da*cos(beta - gamma) -
    //   beta_rate_dot_by_beta_of_place_142*(d1_by_beta_of_d_beta_gamma -
    //   beta_rate_dot_by_beta_of_place_122))
    let beta_rate_dot_by_beta_of_beta_rate_2 = d_inv_rr_beta_rate_sq
        * (beta_rate_dot_by_beta_of_place_139
            * (m2_da
                * ((-beta_rate_dot_by_beta_of_place_128)
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_137,
                        da * beta_rate_dot_by_beta_of_place_136,
                    ) + beta_rate_dot_by_beta_of_place_138)
                + I2 * beta_rate_dot_by_beta_of_place_136) - cos_theta_m2_da * cos_beta_minus_gamma
            - beta_rate_dot_by_beta_of_place_142
                * (d1_by_beta_of_d_beta_gamma - beta_rate_dot_by_beta_of_place_122));
    let d1_of_d_beta_gamma_m2_da = d1_of_d_beta_gamma * m2_da;
    // sin(gamma)^2 - 1 + cos(gamma)^2
    let beta_rate_dot_by_beta_of_gamma = sin_gamma.mul_add(sin_gamma, -S::int(1))
        + cos_gamma * cos_gamma;
    // yb - yc
    let yb_minus_yc = yb - yc;
    // xb - xc
    let xb_minus_xc = xb - xc;
    // yb_minus_yc*sin(gamma) + xb_minus_xc*cos(gamma)
    let beta_rate_dot_by_beta_of_place_143 = xb_minus_xc
        .mul_add(cos_gamma, yb_minus_yc * sin_gamma);
    // xb_minus_xc*sin(gamma) - yb_minus_yc*cos(gamma)
    let beta_rate_dot_by_beta_of_place_144 = (-yb_minus_yc)
        .mul_add(cos_gamma, xb_minus_xc * sin_gamma);
    // sc*(sb*beta_rate_dot_by_beta_of_gamma + beta_rate_dot_by_beta_of_place_143) -
    //   sd*(sa*beta_rate_dot_by_beta_of_gamma + beta_rate_dot_by_beta_of_place_144)
    let beta_rate_dot_by_beta_of_place_145 = sc
        * sb.mul_add(beta_rate_dot_by_beta_of_gamma, beta_rate_dot_by_beta_of_place_143)
        - sd
            * sa
                .mul_add(
                    beta_rate_dot_by_beta_of_gamma, beta_rate_dot_by_beta_of_place_144,
                );
    // xb*(xb - 2*xc)
    let beta_rate_dot_by_beta_of_xb_xc = xb * (-xc).mul_add(S::int(2), xb);
    // yb*(yb - 2*yc)
    let beta_rate_dot_by_beta_of_yb_yc = yb * (-yc).mul_add(S::int(2), yb);
    let xc_sq = xc * xc;
    let yc_sq = yc * yc;
    // sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))
    let beta_rate_dot_by_beta_of_place_146 = (xc_sq + beta_rate_dot_by_beta_of_xb_xc
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
    let beta_rate_dot_by_beta_of_place_147 = l0 - beta_rate_dot_by_beta_of_place_146;
    let beta_rate_dot_by_beta_of_place_148 = beta_rate_dot_by_beta_of_place_145
        * beta_rate_dot_by_beta_of_place_147;
    // 1/(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sd*(sd + 2*beta_rate_dot_by_beta_of_place_143) +
    //   sc*(sc + 2*beta_rate_dot_by_beta_of_place_144))
    let beta_rate_dot_by_beta_of_place_149 = S::int(1)
        / (xc_sq + beta_rate_dot_by_beta_of_xb_xc + yc_sq + beta_rate_dot_by_beta_of_yb_yc
            + sd * beta_rate_dot_by_beta_of_place_143.mul_add(S::int(2), sd)
            + sc * beta_rate_dot_by_beta_of_place_144.mul_add(S::int(2), sc));
    let beta_rate_dot_by_beta_of_place_150 = beta_rate_dot_by_beta_of_place_149
        * beta_rate_dot_by_beta_of_place_146;
    let beta_rate_dot_by_beta_of_place_151 = c0 * ss_inv * beta_rate_dot_by_beta_of_place_150;
    // rr_beta_rate_sq*(d1_of_d_beta_gamma_m2_da - cos_angle_inv*beta_rate_dot_by_beta_of_place_130) +
    //   beta_rate_dot_by_beta_of_place_148*beta_rate_dot_by_beta_of_place_151
    let beta_rate_dot_by_beta_of_beta_rate_3 = rr_beta_rate_sq
        * (-cos_angle_inv)
            .mul_add(beta_rate_dot_by_beta_of_place_130, d1_of_d_beta_gamma_m2_da)
        + beta_rate_dot_by_beta_of_place_148 * beta_rate_dot_by_beta_of_place_151;
    // d_inv_rr_beta_rate_sq*(beta_rate_dot_by_beta_of_place_139*beta_rate_dot_by_beta_of_place_141 -
    //   cos_theta_m2_da*sin(beta - gamma))
    let beta_rate_dot_by_beta_of_beta_rate_4 = d_inv_rr_beta_rate_sq
        * (-cos_theta_m2_da)
            .mul_add(
                sin_beta_minus_gamma,
                beta_rate_dot_by_beta_of_place_139 * beta_rate_dot_by_beta_of_place_141,
            );
    // rr_cos_angle_inv*(beta_rate_dot_by_beta_of_beta_rate_3*sin(theta) +
    //   beta_rate_dot_by_beta_of_beta_rate_4)
    let beta_rate_dot_by_beta_of_beta_rate_5 = rr_cos_angle_inv
        * beta_rate_dot_by_beta_of_beta_rate_3
            .mul_add(sin_theta, beta_rate_dot_by_beta_of_beta_rate_4);
    let beta_rate_dot_by_beta_of_beta_rate_6 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_beta_of_beta_rate_5;
    let d1_inv = S::int(1) / d1;
    // d1_inv^2*(mom + beta_rate_dot_by_beta_of_beta_rate_5)
    let beta_rate_dot_by_beta_of_beta_rate_7 = d1_inv * d1_inv
        * (mom + beta_rate_dot_by_beta_of_beta_rate_5);
    // beta_rate_dot_by_beta = (rr*tan(beta + theta - gamma)*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d +
    //   (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma) + rr*(rr*beta_rate^2*(cos(beta - gamma)*tan(beta + theta
    //   - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
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
    //   theta - gamma)))/d + rr*beta_rate^2*sin(theta)*(rr*(m2*da*(cos(theta)*cos(beta - gamma)/ss +
    //   2*sin(beta - gamma)*cos(beta - gamma)/d)/d + tan(gamma - beta - theta)*(sin(theta)*(cos(beta -
    //   gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma - epsilon)*sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon - omega)*(((sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) - m6*cos(gamma -
    //   epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma) + (cos(beta -
    //   gamma)*((I2*(sin(beta - gamma)*tan(gamma - beta - theta) + cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2) + m2*da^2*(sin(beta - gamma)*tan(gamma - beta - theta) + cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2))/(d*ss) - m2*da*cos(theta)*cos(beta + theta - gamma)/ss)/d + sin(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma
    //   - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d + sin(theta)*(sin(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d - cos(beta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d - cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((sin(gamma - epsilon)*(I6*(sin(gamma
    //   - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/(ss*zf^2) + m6*((sin(gamma - epsilon)
    //   + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/ss + fa*(fa*(sin(gamma - epsilon) + sin(gamma -
    //   epsilon)*tan(beta + theta - gamma)^2)/zf - 2*sin(gamma - epsilon) - 2*sin(gamma - epsilon)*tan(beta
    //   + theta - gamma)^2)/(ss*zf))) + cos(gamma - epsilon - omega)*((I7*(cos(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) + m7*(ua^2*(cos(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) + ub^2*(cos(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2)))/(ss*u^2) + m6*sin(omega)*(2*sin(gamma -
    //   epsilon)*(fa/ss + fa*tan(beta + theta - gamma)^2/ss)/zf + (sin(omega)*(cos(gamma - epsilon - omega)
    //   + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) - 2*sin(gamma - epsilon) - 2*sin(gamma -
    //   epsilon)*tan(beta + theta - gamma)^2)/ss)))/cos(omega)^2 + (cos(gamma - delta)*(I4*(cos(gamma -
    //   delta) + cos(gamma - delta)*tan(beta + theta - gamma)^2)/(e^2*ss) + m4*((cos(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma)^2)/ss + ea*(cos(gamma - delta)*(ea/ss + ea*tan(beta +
    //   theta - gamma)^2/ss)/e - 2*(cos(gamma - delta) + cos(gamma - delta)*tan(beta + theta -
    //   gamma)^2)/ss)/e)) + cos(gamma - delta - phi_minus_90deg)*((I5*(cos(gamma - delta - phi_minus_90deg)
    //   + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2) + m5*(ta^2*(cos(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2) +
    //   tb^2*(cos(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)^2)))/(ss*zt^2) + m4*cos(phi_minus_90deg)*(2*cos(gamma - delta)*(ea/ss + ea*tan(beta + theta -
    //   gamma)^2/ss)/e + (cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - 2*cos(gamma - delta) -
    //   tan(beta + theta - gamma)^2*(2*cos(gamma - delta) - cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)))/ss)))/sin(phi_minus_90deg)^2 + ((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma -
    //   epsilon - omega)^2 + m4*cos(gamma - delta - phi_minus_90deg)^2 + tan(beta + theta - gamma)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2))/ss)))/cos(beta + theta - gamma))/cos(beta + theta - gamma) - m2*da*sin(beta -
    //   gamma)/d - tan(beta + theta - gamma)*(rr*(m2*da*(cos(beta - gamma)^2/d - cos(theta)*sin(beta -
    //   gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 +
    //   sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma))/d1 - d1_by_beta*(mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc)
    //   + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) +
    //   sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc
    //   + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) +
    //   rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma
    //   - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_beta = d1_inv
        * (rr_cos_angle_inv
            * (beta_rate_dot_by_beta_of_beta_rate
                * (rr_cos_angle_inv
                    * (cos_angle_inv
                        * (sin_theta
                            * (beta_rate_dot_by_beta_of_place_18
                                + beta_rate_dot_by_beta_of_place_24)
                            + d1_of_d_beta_gamma
                                * (beta_rate_dot_by_beta_of_place_25
                                    - beta_rate_dot_by_beta_of_place_26)
                            + beta_rate_dot_by_beta_of_place_33)
                        + beta_rate_dot_by_beta_of_place_127) - beta_rate_dot_by_beta_of_place_132)
                + beta_rate_dot_by_beta_of_beta_rate_2) + beta_rate_dot_by_beta_of_beta_rate_6)
        - d1_by_beta * beta_rate_dot_by_beta_of_beta_rate_7;
    // cos(theta) + sin_angle_cos_angle_inv*sin(theta)
    let d1_by_theta_of_place = sin_angle_cos_angle_inv.mul_add(sin_theta, cos_theta);
    let sin_theta_m2_da = m2_da * sin_theta;
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
                * (-m2_da * (-da).mul_add(beta_rate_dot_by_beta_of_place_139, cos_theta)
                    + I2 * beta_rate_dot_by_beta_of_place_139)
                + d1_of_place_27 * d1_by_theta_of_place * sin_theta)
            + d1_of_d_beta_gamma * sin_theta_m2_da);
    let beta_rate_dot_by_theta_of_place = sin_theta * cos_beta_minus_gamma;
    // beta_rate_dot_by_theta = (rr*tan(beta + theta - gamma)*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d +
    //   (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma) + rr*(rr*beta_rate^2*(m2*da*sin(theta)*sin(beta - gamma)
    //   + cos(beta - gamma)*tan(beta + theta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
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
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1
    //   + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta -
    //   gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))) - rr*beta_rate^2*sin(theta)*(tan(beta + theta - gamma)*(rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma - epsilon)*sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon - omega)*(((sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) - m6*cos(gamma -
    //   epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) + (sin(theta)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + rr*(m2*da*sin(theta)*sin(beta -
    //   gamma)/(d*ss) + tan(beta + theta - gamma)*(sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma - epsilon)*sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon - omega)*(((sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) - m6*cos(gamma -
    //   epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma) +
    //   (cos(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + sin(theta)*(cos(beta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d - cos(theta)*((m6*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) + tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon
    //   - omega)^2 + m4*cos(gamma - delta - phi_minus_90deg)^2))/ss - (m6*sin(gamma - epsilon)*sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon - omega)*(((sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) - m6*cos(gamma -
    //   epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) - ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg)) + cos(beta - gamma)*tan(beta + theta - gamma)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d - sin(theta)*((sin(gamma -
    //   epsilon)*(I6*(sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/(ss*zf^2) +
    //   m6*((sin(gamma - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/ss + fa*(fa*(sin(gamma
    //   - epsilon) + sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/zf - 2*sin(gamma - epsilon) -
    //   2*sin(gamma - epsilon)*tan(beta + theta - gamma)^2)/(ss*zf))) + cos(gamma - epsilon -
    //   omega)*((I7*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)^2) + m7*(ua^2*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)^2) + ub^2*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)^2)))/(ss*u^2) + m6*sin(omega)*(2*sin(gamma - epsilon)*(fa/ss + fa*tan(beta + theta -
    //   gamma)^2/ss)/zf + (sin(omega)*(cos(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta
    //   + theta - gamma)^2) - 2*sin(gamma - epsilon) - 2*sin(gamma - epsilon)*tan(beta + theta -
    //   gamma)^2)/ss)))/cos(omega)^2 + (cos(gamma - delta)*(I4*(cos(gamma - delta) + cos(gamma -
    //   delta)*tan(beta + theta - gamma)^2)/(e^2*ss) + m4*((cos(gamma - delta) + cos(gamma - delta)*tan(beta
    //   + theta - gamma)^2)/ss + ea*(cos(gamma - delta)*(ea/ss + ea*tan(beta + theta - gamma)^2/ss)/e -
    //   2*(cos(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma)^2)/ss)/e)) + cos(gamma - delta
    //   - phi_minus_90deg)*((I5*(cos(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)^2) + m5*(ta^2*(cos(gamma - delta - phi_minus_90deg) +
    //   cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2) + tb^2*(cos(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)^2)))/(ss*zt^2) +
    //   m4*cos(phi_minus_90deg)*(2*cos(gamma - delta)*(ea/ss + ea*tan(beta + theta - gamma)^2/ss)/e +
    //   (cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - 2*cos(gamma - delta) - tan(beta + theta
    //   - gamma)^2*(2*cos(gamma - delta) - cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)))/ss)))/sin(phi_minus_90deg)^2 + ((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma -
    //   epsilon - omega)^2 + m4*cos(gamma - delta - phi_minus_90deg)^2 + tan(beta + theta - gamma)^2*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*(m2*da*cos(theta)*cos(beta + theta - gamma)/ss -
    //   (I2*(cos(beta - gamma) + cos(beta - gamma)*tan(beta + theta - gamma)^2) + m2*da^2*(cos(beta - gamma)
    //   + cos(beta - gamma)*tan(beta + theta - gamma)^2))/(d*ss) - sin(theta)*(((I3 + m3*(sa^2 + sb^2))/ss +
    //   m2*da*sin(beta + theta - gamma))/ss + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta -
    //   gamma)))/cos(beta + theta - gamma))/d1 - d1_by_theta*(mom + rr*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d +
    //   (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_theta = d1_inv
        * (beta_rate_dot_by_beta_of_beta_rate_6
            + rr_cos_angle_inv
                * (-beta_rate_dot_by_beta_of_beta_rate
                    * (beta_rate_dot_by_beta_of_place_131
                        + cos_angle_inv
                            * (-rr
                                * (cos_angle_inv
                                    * (d1_of_d_beta_gamma
                                        * ((i2_plus_da_m2_da * beta_rate_dot_by_beta_of_place_6
                                            * ss_inv_d_inv)
                                            .mul_add(
                                                cos_beta_minus_gamma,
                                                -beta_rate_dot_by_beta_of_place_26,
                                            ) + beta_rate_dot_by_beta_of_place_28 * sin_theta)
                                        + sin_theta
                                            * ((-beta_rate_dot_by_beta_of_place_22)
                                                .mul_add(
                                                    beta_rate_dot_by_beta_of_place_23,
                                                    beta_rate_dot_by_beta_of_place_18,
                                                ) + beta_rate_dot_by_beta_of_place_121 * cos_theta)
                                        + beta_rate_dot_by_beta_of_place_123 * cos_theta)
                                    + beta_rate_dot_by_beta_of_place_126
                                    - ss_inv * d1_by_beta_of_d_beta_gamma * sin_theta_m2_da)
                                + beta_rate_dot_by_beta_of_place_22 * sin_theta))
                    + beta_rate_dot_by_beta_of_beta_rate_3 * cos_theta
                    + d_inv_rr_beta_rate_sq
                        * (-beta_rate_dot_by_beta_of_place_139
                            * (m2_da
                                * (da
                                    .mul_add(
                                        beta_rate_dot_by_beta_of_place_135,
                                        -beta_rate_dot_by_beta_of_place_138,
                                    )
                                    + beta_rate_dot_by_beta_of_place_137
                                        * beta_rate_dot_by_theta_of_place)
                                + I2 * beta_rate_dot_by_beta_of_place_135)
                            + beta_rate_dot_by_beta_of_place_122
                                * beta_rate_dot_by_beta_of_place_142
                            + sin_theta_m2_da * sin_beta_minus_gamma)))
        - d1_by_theta * beta_rate_dot_by_beta_of_beta_rate_7;
    let d1_by_gamma_of_place = d1_of_zf_fa * cos_gamma_minus_epsilon;
    // beta_rate_dot_by_beta_of_place_60 + d1_by_gamma_of_place
    let d1_by_gamma_of_place_2 = beta_rate_dot_by_beta_of_place_60 + d1_by_gamma_of_place;
    let d1_of_place_10_i6_zf_inv = d1_of_place_10 * i6_zf_inv;
    let d1_by_gamma_of_place_3 = d1_of_place_3_u_2_inv * beta_rate_dot_by_beta_of_place_40;
    // cos_omega_inv_sq*(m6*(d1_of_place_3*(beta_rate_dot_by_beta_of_place_39 +
    //   beta_rate_dot_by_beta_of_place_43*sin(omega)) + sin(gamma - epsilon)*(cos(gamma - epsilon) -
    //   beta_rate_dot_by_beta_of_place_60 + fa_zf_inv*d1_by_gamma_of_place_2)) +
    //   d1_of_place_10_i6_zf_inv*cos(gamma - epsilon) + d1_by_gamma_of_place_3)
    let d1_by_gamma_of_place_4 = cos_omega_inv_sq
        * (m6
            * (d1_of_place_3
                * beta_rate_dot_by_beta_of_place_43
                    .mul_add(sin_omega, beta_rate_dot_by_beta_of_place_39)
                + sin_gamma_minus_epsilon
                    * fa_zf_inv
                        .mul_add(
                            d1_by_gamma_of_place_2,
                            cos_gamma_minus_epsilon - beta_rate_dot_by_beta_of_place_60,
                        )) + d1_of_place_10_i6_zf_inv * cos_gamma_minus_epsilon
            + d1_by_gamma_of_place_3);
    let d1_by_gamma_of_place_5 = d1_of_e_ea * sin_gamma_minus_delta;
    let d1_by_gamma_of_place_6 = beta_rate_dot_by_beta_of_place_83 * cos_phi_minus_90deg;
    let d1_by_gamma_of_place_7 = d1_of_place_15_zt_inv * beta_rate_dot_by_beta_of_place_80;
    // d1_of_place_25*(d1_of_place_22*i4_e_inv*sin(gamma - delta) + m4*(cos(gamma -
    //   delta)*(beta_rate_dot_by_beta_of_place_99 + ea_e_inv*(beta_rate_dot_by_beta_of_place_98 +
    //   d1_by_gamma_of_place_5)) + d1_of_place_15*(d1_by_gamma_of_place_6 -
    //   beta_rate_dot_by_beta_of_place_78)) + d1_by_gamma_of_place_7)
    let d1_by_gamma_of_place_8 = d1_of_place_25
        * (m4
            * (cos_gamma_minus_delta
                * (beta_rate_dot_by_beta_of_place_99
                    + ea_e_inv * (beta_rate_dot_by_beta_of_place_98 + d1_by_gamma_of_place_5))
                + d1_of_place_15 * (d1_by_gamma_of_place_6 - beta_rate_dot_by_beta_of_place_78))
            + d1_of_place_22 * i4_e_inv * sin_gamma_minus_delta + d1_by_gamma_of_place_7);
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
    //   tb^2))/zt^2 + m4*(cos(gamma - delta)*(sin(gamma - delta) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e) + cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta
    //   - phi_minus_90deg) + sin(gamma - delta)*cos(phi_minus_90deg)*(ea/e - 1))))/sin(phi_minus_90deg)^2) -
    //   cos(beta - gamma)*(m2*da*cos(theta)*sin(beta + theta - gamma) + (I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/d)/d)/cos(beta + theta - gamma))/cos(beta + theta - gamma)
    let d1_by_gamma = d1_by_beta_of_place_2
        * (cos_angle_inv
            * (d1_of_d_beta_gamma
                * d_inv
                    .mul_add(
                        beta_rate_dot_by_beta_of_place_30,
                        cos_theta_m2_da * sin_angle,
                    )
                + sin_theta_sq
                    * ((-d1_of_place_27)
                        .mul_add(sin_angle_cos_angle_inv, d1_by_gamma_of_place_4)
                        - d1_by_gamma_of_place_8)) - d1_by_beta_of_place);
    let beta_rate_dot_by_gamma_of_place = beta_rate_dot_by_beta_of_place_36
        * beta_rate_dot_by_beta_of_place_39;
    let beta_rate_dot_by_gamma_of_place_2 = S::int(2) * beta_rate_dot_by_beta_of_place_60;
    // cos(gamma - epsilon) - beta_rate_dot_by_gamma_of_place_2
    let beta_rate_dot_by_gamma_of_place_3 = cos_gamma_minus_epsilon
        - beta_rate_dot_by_gamma_of_place_2;
    let beta_rate_dot_by_gamma_of_place_4 = beta_rate_dot_by_beta_of_place_39
        * beta_rate_dot_by_beta_of_place_46;
    let beta_rate_dot_by_gamma_of_place_5 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_beta_of_place_39;
    // d1_of_place_3*beta_rate_dot_by_beta_of_place_5 - beta_rate_dot_by_gamma_of_place_5
    let beta_rate_dot_by_gamma_of_place_6 = d1_of_place_3
        .mul_add(beta_rate_dot_by_beta_of_place_5, -beta_rate_dot_by_gamma_of_place_5);
    let beta_rate_dot_by_gamma_of_place_7 = m6 * beta_rate_dot_by_beta_of_place_39;
    let beta_rate_dot_by_gamma_of_place_8 = beta_rate_dot_by_beta_of_place_50
        * beta_rate_dot_by_gamma_of_place_7;
    let beta_rate_dot_by_gamma_of_place_9 = beta_rate_dot_by_beta_of_zf_fa
        * beta_rate_dot_by_beta_of_place_63;
    // beta_rate_dot_by_beta_of_place_12 + beta_rate_dot_by_beta_of_place_39 +
    //   sin_omega_cos_omega_inv*(d1_of_place_3 + cos_omega_inv*(beta_rate_dot_by_beta_of_place_60 +
    //   beta_rate_dot_by_gamma_of_place_9))
    let beta_rate_dot_by_gamma_of_place_10 = beta_rate_dot_by_beta_of_place_12
        + beta_rate_dot_by_beta_of_place_39
        + sin_omega_cos_omega_inv
            * (d1_of_place_3
                + cos_omega_inv
                    * (beta_rate_dot_by_beta_of_place_60 + beta_rate_dot_by_gamma_of_place_9));
    let beta_rate_dot_by_gamma_of_place_11 = beta_rate_dot_by_beta_of_place_55
        * beta_rate_dot_by_beta_of_place_61;
    let beta_rate_dot_by_gamma_of_place_12 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_beta_of_place_61;
    let beta_rate_dot_by_gamma_of_place_13 = zf_inv * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_gamma_of_place_14 = sin_omega_cos_omega_inv
        * beta_rate_dot_by_beta_of_place_64;
    let beta_rate_dot_by_gamma_of_place_15 = sin_omega_cos_omega_inv
        * beta_rate_dot_by_beta_of_place_67;
    let beta_rate_dot_by_gamma_of_place_16 = beta_rate_dot_by_beta_of_place_39
        * beta_rate_dot_by_beta_of_place_59;
    let beta_rate_dot_by_gamma_of_place_17 = beta_rate_dot_by_beta_of_place_39
        * beta_rate_dot_by_gamma_of_place_7;
    // beta_rate_dot_by_beta_of_place_2 - beta_rate_dot_by_gamma_of_place_17
    let beta_rate_dot_by_gamma_of_place_18 = beta_rate_dot_by_beta_of_place_2
        - beta_rate_dot_by_gamma_of_place_17;
    let beta_rate_dot_by_gamma_of_place_19 = d1_of_place_10 * beta_rate_dot_by_gamma_of_place_18;
    let beta_rate_dot_by_gamma_of_place_20 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_beta_of_place_79;
    // d1_of_place_15*beta_rate_dot_by_beta_of_place_5 + beta_rate_dot_by_gamma_of_place_20
    let beta_rate_dot_by_gamma_of_place_21 = d1_of_place_15
        .mul_add(beta_rate_dot_by_beta_of_place_5, beta_rate_dot_by_gamma_of_place_20);
    let beta_rate_dot_by_gamma_of_place_22 = beta_rate_dot_by_beta_of_place_74
        * beta_rate_dot_by_beta_of_place_79;
    let beta_rate_dot_by_gamma_of_place_23 = S::int(2) * beta_rate_dot_by_beta_of_place_98;
    // sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_23
    let beta_rate_dot_by_gamma_of_place_24 = sin_gamma_minus_delta
        - beta_rate_dot_by_gamma_of_place_23;
    let beta_rate_dot_by_gamma_of_place_25 = sin_phi_minus_90deg_inv
        * beta_rate_dot_by_beta_of_place_79 * beta_rate_dot_by_beta_of_place_85;
    // m4_d1_of_place_15*(beta_rate_dot_by_beta_of_place_83 + beta_rate_dot_by_beta_of_place_98) +
    //   sin_phi_minus_90deg_inv*(beta_rate_dot_by_beta_of_place_82*sin(gamma - delta) +
    //   beta_rate_dot_by_beta_of_place_87*beta_rate_dot_by_beta_of_place_98 + cos(gamma -
    //   delta)*(e_inv*(d1_of_place_21 - beta_rate_dot_by_beta_of_place_75 +
    //   beta_rate_dot_by_beta_of_place_77*(beta_rate_dot_by_beta_of_place_81 +
    //   beta_rate_dot_by_gamma_of_place_22)) +
    //   m4*(beta_rate_dot_by_beta_of_place_77*beta_rate_dot_by_gamma_of_place_24 - cos(gamma - delta))) +
    //   d1_of_place_16*(beta_rate_dot_by_gamma_of_place_25 - m4*beta_rate_dot_by_beta_of_place_89))
    let beta_rate_dot_by_gamma_of_place_26 = m4_d1_of_place_15
        * (beta_rate_dot_by_beta_of_place_83 + beta_rate_dot_by_beta_of_place_98)
        + sin_phi_minus_90deg_inv
            * (beta_rate_dot_by_beta_of_place_82 * sin_gamma_minus_delta
                + beta_rate_dot_by_beta_of_place_87 * beta_rate_dot_by_beta_of_place_98
                + cos_gamma_minus_delta
                    * (e_inv
                        * (d1_of_place_21 - beta_rate_dot_by_beta_of_place_75
                            + beta_rate_dot_by_beta_of_place_77
                                * (beta_rate_dot_by_beta_of_place_81
                                    + beta_rate_dot_by_gamma_of_place_22))
                        + m4
                            * beta_rate_dot_by_beta_of_place_77
                                .mul_add(
                                    beta_rate_dot_by_gamma_of_place_24, -cos_gamma_minus_delta,
                                ))
                + d1_of_place_16
                    * (-m4)
                        .mul_add(
                            beta_rate_dot_by_beta_of_place_89, beta_rate_dot_by_gamma_of_place_25,
                        ));
    let beta_rate_dot_by_gamma_of_place_27 = m4 * beta_rate_dot_by_beta_of_place_79;
    let beta_rate_dot_by_gamma_of_place_28 = beta_rate_dot_by_beta_of_place_90
        * beta_rate_dot_by_gamma_of_place_27;
    // beta_rate_dot_by_beta_of_place_77*(d1_of_place_15 +
    //   sin_phi_minus_90deg_inv*(beta_rate_dot_by_beta_of_place_98 +
    //   beta_rate_dot_by_beta_of_e_ea*beta_rate_dot_by_beta_of_gamma_delta_2)) -
    //   beta_rate_dot_by_beta_of_place_78
    let beta_rate_dot_by_gamma_of_place_29 = beta_rate_dot_by_beta_of_place_77
        * (d1_of_place_15
            + sin_phi_minus_90deg_inv
                * beta_rate_dot_by_beta_of_e_ea
                    .mul_add(
                        beta_rate_dot_by_beta_of_gamma_delta_2, beta_rate_dot_by_beta_of_place_98,
                    )) - beta_rate_dot_by_beta_of_place_78;
    let beta_rate_dot_by_gamma_of_place_30 = ea_ss_inv * cos_gamma_minus_delta;
    // beta_rate_dot_by_beta_of_place_96*sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_30
    let beta_rate_dot_by_gamma_of_place_31 = beta_rate_dot_by_beta_of_place_96
        .mul_add(sin_gamma_minus_delta, -beta_rate_dot_by_gamma_of_place_30);
    // -sin_angle_cos_angle_inv*beta_rate_dot_by_beta_of_place_106
    let beta_rate_dot_by_gamma_of_place_32 = -sin_angle_cos_angle_inv
        * beta_rate_dot_by_beta_of_place_106;
    let beta_rate_dot_by_gamma_of_place_33 = d1_of_place_22
        * beta_rate_dot_by_beta_of_gamma_delta_2;
    let beta_rate_dot_by_gamma_of_place_34 = beta_rate_dot_by_beta_of_e_ea
        * beta_rate_dot_by_gamma_of_place_33;
    let beta_rate_dot_by_gamma_of_place_35 = sin_angle_cos_angle_inv
        * beta_rate_dot_by_beta_of_place_111;
    // d1_of_place_15 + sin_phi_minus_90deg_inv*d1_by_gamma_of_place_5
    let beta_rate_dot_by_gamma_of_place_36 = sin_phi_minus_90deg_inv
        .mul_add(d1_by_gamma_of_place_5, d1_of_place_15);
    // beta_rate_dot_by_beta_of_place_105*sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_30
    let beta_rate_dot_by_gamma_of_place_37 = beta_rate_dot_by_beta_of_place_105
        .mul_add(sin_gamma_minus_delta, -beta_rate_dot_by_gamma_of_place_30);
    let beta_rate_dot_by_gamma_of_place_38 = beta_rate_dot_by_beta_of_place_77
        * beta_rate_dot_by_beta_of_place_109;
    // beta_rate_dot_by_beta_of_place_110*(sin_phi_minus_90deg_inv*sin(gamma - delta) - d1_of_place_15) +
    //   beta_rate_dot_by_gamma_of_place_38*sin(gamma - delta)
    let beta_rate_dot_by_gamma_of_place_39 = beta_rate_dot_by_beta_of_place_110
        * sin_phi_minus_90deg_inv.mul_add(sin_gamma_minus_delta, -d1_of_place_15)
        + beta_rate_dot_by_gamma_of_place_38 * sin_gamma_minus_delta;
    let beta_rate_dot_by_gamma_of_place_40 = beta_rate_dot_by_beta_of_place_114
        * beta_rate_dot_by_gamma_of_place_33;
    let beta_rate_dot_by_gamma_of_place_41 = beta_rate_dot_by_beta_of_place_79
        * beta_rate_dot_by_beta_of_place_101;
    // beta_rate_dot_by_beta_of_place_116*sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_41
    let beta_rate_dot_by_gamma_of_place_42 = beta_rate_dot_by_beta_of_place_116
        .mul_add(sin_gamma_minus_delta, -beta_rate_dot_by_gamma_of_place_41);
    let beta_rate_dot_by_gamma_of_place_43 = beta_rate_dot_by_beta_of_place_79
        * beta_rate_dot_by_gamma_of_place_27;
    // beta_rate_dot_by_beta_of_place - beta_rate_dot_by_gamma_of_place_43
    let beta_rate_dot_by_gamma_of_place_44 = beta_rate_dot_by_beta_of_place
        - beta_rate_dot_by_gamma_of_place_43;
    let beta_rate_dot_by_gamma_of_place_45 = d1_of_place_22 * beta_rate_dot_by_gamma_of_place_44;
    // e_inv*beta_rate_dot_by_beta_of_place_118*sin(gamma - delta) - beta_rate_dot_by_gamma_of_place_45
    let beta_rate_dot_by_gamma_of_place_46 = (e_inv * beta_rate_dot_by_beta_of_place_118)
        .mul_add(sin_gamma_minus_delta, -beta_rate_dot_by_gamma_of_place_45);
    // fa_zf_inv*(d1_by_gamma_of_place + beta_rate_dot_by_gamma_of_place_2) +
    //   beta_rate_dot_by_gamma_of_place_3
    let beta_rate_dot_by_gamma_of_place_47 = fa_zf_inv
        * (d1_by_gamma_of_place + beta_rate_dot_by_gamma_of_place_2)
        + beta_rate_dot_by_gamma_of_place_3;
    let beta_rate_dot_by_gamma_of_place_48 = S::int(2) * beta_rate_dot_by_beta_of_place_39;
    // d1_of_place_25*(2*d1_by_gamma_of_place_7 + m4*(d1_of_place_19*sin(gamma - delta) +
    //   d1_of_place_16_doubled*beta_rate_dot_by_beta_of_place_98 + cos(gamma -
    //   delta)*(ea_e_inv*(d1_by_gamma_of_place_5 + beta_rate_dot_by_gamma_of_place_23) +
    //   beta_rate_dot_by_gamma_of_place_24)) + i4_e_inv*beta_rate_dot_by_gamma_of_place_33)
    let beta_rate_dot_by_gamma_of_place_49 = d1_of_place_25
        * (m4
            * (d1_of_place_19 * sin_gamma_minus_delta
                + d1_of_place_16_doubled * beta_rate_dot_by_beta_of_place_98
                + cos_gamma_minus_delta
                    * (ea_e_inv * (d1_by_gamma_of_place_5 + beta_rate_dot_by_gamma_of_place_23)
                        + beta_rate_dot_by_gamma_of_place_24)) + S::int(2) * d1_by_gamma_of_place_7
            + i4_e_inv * beta_rate_dot_by_gamma_of_place_33);
    // cos_omega_inv_sq*(beta_rate_dot_by_beta_of_place_63*d1_of_place_10_i6_zf_inv +
    //   m6*(d1_of_place_8*cos(gamma - epsilon) + d1_of_place_4*beta_rate_dot_by_beta_of_place_60 +
    //   beta_rate_dot_by_gamma_of_place_47*sin(gamma - epsilon)) +
    //   d1_of_place_3_u_2_inv*beta_rate_dot_by_beta_of_place_35*beta_rate_dot_by_gamma_of_place_48) -
    //   beta_rate_dot_by_gamma_of_place_49
    let beta_rate_dot_by_gamma_of_place_50 = cos_omega_inv_sq
        * (m6
            * (d1_of_place_4
                .mul_add(
                    beta_rate_dot_by_beta_of_place_60,
                    d1_of_place_8 * cos_gamma_minus_epsilon,
                ) + beta_rate_dot_by_gamma_of_place_47 * sin_gamma_minus_epsilon)
            + beta_rate_dot_by_beta_of_place_63 * d1_of_place_10_i6_zf_inv
            + d1_of_place_3_u_2_inv * beta_rate_dot_by_beta_of_place_35
                * beta_rate_dot_by_gamma_of_place_48) - beta_rate_dot_by_gamma_of_place_49;
    // 2*beta_rate_dot_by_beta_of_place_120 + beta_rate_dot_by_gamma_of_place_50
    let beta_rate_dot_by_gamma_of_place_51 = beta_rate_dot_by_beta_of_place_120
        .mul_add(S::int(2), beta_rate_dot_by_gamma_of_place_50);
    // -beta_rate_dot_by_gamma_of_place_51
    let beta_rate_dot_by_gamma_of_place_52 = -beta_rate_dot_by_gamma_of_place_51;
    // sc*beta_rate_dot_by_beta_of_place_143 - sd*beta_rate_dot_by_beta_of_place_144
    let beta_rate_dot_by_gamma_of_place_53 = (-sd)
        .mul_add(
            beta_rate_dot_by_beta_of_place_144,
            sc * beta_rate_dot_by_beta_of_place_143,
        );
    // beta_rate_dot_by_beta_of_place_147*(sd*beta_rate_dot_by_beta_of_place_143 +
    //   sc*beta_rate_dot_by_beta_of_place_144) +
    //   beta_rate_dot_by_beta_of_place_145*beta_rate_dot_by_beta_of_place_150*beta_rate_dot_by_gamma_of_place_53
    let beta_rate_dot_by_gamma_of_place_54 = beta_rate_dot_by_beta_of_place_147
        * sc
            .mul_add(
                beta_rate_dot_by_beta_of_place_144,
                sd * beta_rate_dot_by_beta_of_place_143,
            )
        + beta_rate_dot_by_beta_of_place_145 * beta_rate_dot_by_beta_of_place_150
            * beta_rate_dot_by_gamma_of_place_53;
    // beta_rate_dot_by_gamma = -(rr*tan(beta + theta - gamma)*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d +
    //   (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma) + rr*(rr*beta_rate^2*(cos(beta - gamma)*tan(beta + theta
    //   - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
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
    //   theta - gamma)))/d - sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
    //   yc) + cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2
    //   - 1 + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))^2) + c0*sqrt(xc^2 + xb*(xb - 2*xc) +
    //   yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) + sc*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb))) - sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb -
    //   xc) + cos(gamma)*(yc - yb)))*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1
    //   + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2)))/(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))) -
    //   l0*(sd*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) + sc*(sin(gamma)*(xb - xc) + cos(gamma)*(yc -
    //   yb))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
    //   2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) +
    //   rr*beta_rate^2*(m2*da*sin(beta - gamma)/d + tan(beta + theta - gamma)*(rr*(m2*da*(cos(beta -
    //   gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta -
    //   gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma - epsilon)*sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon - omega)*(((sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) - m6*cos(gamma -
    //   epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)) -
    //   cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/cos(beta + theta - gamma) -
    //   (cos(theta)*(2*m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + (2*sin(gamma - epsilon
    //   - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 + m6*(2*sin(omega)^2*sin(gamma - epsilon - omega)*cos(gamma -
    //   epsilon - omega) - cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) -
    //   sin(gamma - epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) -
    //   fa*(cos(gamma - epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + 2*m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (2*I4*sin(gamma -
    //   delta)*cos(gamma - delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)
    //   + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) + rr*(m2*da*(cos(theta)*cos(beta
    //   - gamma)/ss + 2*sin(beta - gamma)*cos(beta - gamma)/d)/d + tan(gamma - beta -
    //   theta)*(sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma) + (sin(beta -
    //   gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta -
    //   gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma
    //   - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d - sin(theta)*(sin(beta - gamma)*tan(gamma - beta -
    //   theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + cos(beta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma - epsilon)*sin(gamma -
    //   epsilon - omega)^2/zf - m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)^2/zf - m6*cos(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (sin(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) - cos(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2) - cos(gamma -
    //   epsilon - omega)*((m6*sin(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega)) + (cos(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7
    //   + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma -
    //   epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega)))) + sin(omega)*sin(gamma - epsilon - omega)*(m6*cos(gamma
    //   - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*sin(omega)^2)/cos(omega)) + sin(gamma - epsilon)*((sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf -
    //   2)) + cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - tan(omega)*(cos(gamma -
    //   epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + sin(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega))))/zf + m6*(sin(gamma - epsilon) - tan(omega)*(cos(gamma - epsilon) +
    //   2*sin(omega)*sin(gamma - epsilon - omega)))) + sin(omega)*cos(gamma - epsilon - omega)*(m6*sin(gamma
    //   - epsilon)*(fa/zf - 1) + sin(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*sin(omega)^2)/cos(omega)))/cos(omega) + (I7*(sin(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) + m7*(ua^2*(sin(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) +
    //   ub^2*(sin(gamma - epsilon - omega)*tan(beta + theta - gamma) + cos(gamma - epsilon - omega)*tan(beta
    //   + theta - gamma)^2)))/(ss*u) + m6*cos(gamma - epsilon - omega)*(cos(gamma - epsilon)*(1 - fa/zf) +
    //   sin(omega)*sin(gamma - epsilon - omega)))/u + m6*(2*sin(gamma - epsilon)*cos(gamma - epsilon)*(fa/zf
    //   - 1)/zf + sin(omega)*((cos(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon
    //   - omega) + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))) - fa*sin(gamma - epsilon)/ss + sin(gamma -
    //   epsilon)*(2*fa/ss - sin(gamma - epsilon - omega) + 2*fa*tan(beta + theta - gamma)^2/ss -
    //   tan(omega)*((2*cos(gamma - epsilon)*(1 - fa/zf) + sin(omega)*sin(gamma - epsilon -
    //   omega))/cos(omega) - cos(gamma - epsilon - omega))))/zf + (sin(omega)*(sin(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)^2) -
    //   sin(gamma - epsilon) - 2*sin(gamma - epsilon)*tan(beta + theta - gamma)^2 - 2*cos(gamma -
    //   epsilon)*tan(gamma - beta - theta))/ss))) - sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(beta
    //   + theta - gamma)^2 + cos(gamma - epsilon)*tan(gamma - beta - theta) + sin(omega)*cos(gamma - epsilon
    //   - omega))/ss - (cos(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
    //   epsilon)/cos(omega)) + fa*((2*sin(gamma - epsilon)*tan(beta + theta - gamma)^2 + 2*cos(gamma -
    //   epsilon)*tan(gamma - beta - theta) - fa*(sin(gamma - epsilon)*tan(beta + theta - gamma)^2 +
    //   cos(gamma - epsilon)*tan(gamma - beta - theta))/zf + sin(omega)*cos(gamma - epsilon - omega))/ss -
    //   cos(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf -
    //   2)/cos(omega))/zf - sin(gamma - epsilon)*tan(omega)*(cos(gamma - epsilon)*(fa/zf - 2)/cos(omega) +
    //   cos(gamma - epsilon - omega))/zf) + sin(gamma - epsilon)*tan(omega)*(cos(gamma - epsilon - omega) -
    //   cos(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(beta + theta - gamma)^2 +
    //   cos(gamma - epsilon)*tan(gamma - beta - theta))/ss + 2*sin(gamma - epsilon)*cos(gamma -
    //   epsilon)*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + (m4*cos(gamma -
    //   delta)*cos(gamma - delta - phi_minus_90deg)^2/e - m4*cos(gamma - delta)*sin(gamma - delta -
    //   phi_minus_90deg)^2/e - m4*sin(gamma - delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta
    //   - phi_minus_90deg)/e + (sin(gamma - delta - phi_minus_90deg)*((m4*cos(gamma - delta -
    //   phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma -
    //   delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))
    //   + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) +
    //   m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta +
    //   theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e - 1)/e +
    //   cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma - delta -
    //   phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))
    //   - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma - delta) -
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - sin(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2) + cos(gamma - delta -
    //   phi_minus_90deg)*((m4*sin(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (sin(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)) -
    //   cos(gamma - delta)*((cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt - (sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(cos(gamma - delta) + (2*sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg) - sin(gamma - delta))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*cos(gamma - delta)*(1 - ea/e) +
    //   sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)^2) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma) + cos(gamma -
    //   delta - phi_minus_90deg)*tan(beta + theta - gamma)^2) + tb^2*(sin(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)^2)))/(ss*zt) + m4*cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta)*(ea/e - 1) +
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg)))/zt + m4*(2*sin(gamma - delta)*cos(gamma
    //   - delta)*(ea/e - 1)/e + cos(phi_minus_90deg)*((ea*cos(gamma - delta)/ss + sin(gamma -
    //   delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma - delta - phi_minus_90deg) + ((2*cos(gamma -
    //   delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/sin(phi_minus_90deg)
    //   - sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)) + cos(gamma - delta)*(sin(gamma -
    //   delta - phi_minus_90deg) - 2*ea/ss - 2*ea*tan(beta + theta - gamma)^2/ss + (cos(gamma - delta -
    //   phi_minus_90deg) + (2*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/sin(phi_minus_90deg))/tan(phi_minus_90deg)))/e + (cos(gamma -
    //   delta) + tan(beta + theta - gamma)^2*(2*cos(gamma - delta) - cos(phi_minus_90deg)*cos(gamma - delta
    //   - phi_minus_90deg)) + tan(beta + theta - gamma)*(2*sin(gamma - delta) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)))/ss))) - cos(gamma - delta)*(m4*((sin(gamma - delta)*tan(beta
    //   + theta - gamma) + cos(gamma - delta)*tan(beta + theta - gamma)^2 + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/ss - (sin(gamma - delta)*(cos(gamma - delta)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) + cos(gamma - delta)*(sin(gamma -
    //   delta)/sin(phi_minus_90deg) - cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta)*tan(beta + theta - gamma) + 2*cos(gamma - delta)*tan(beta + theta -
    //   gamma)^2 + cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss + (ea*cos(gamma - delta)/ss
    //   - sin(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)) + cos(gamma
    //   - delta)*((sin(gamma - delta)*(ea/e - 2)/sin(phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg) - ea/ss - ea*tan(beta + theta - gamma)^2/ss))/e))/e) +
    //   I4*((sin(gamma - delta)*tan(beta + theta - gamma) + cos(gamma - delta)*tan(beta + theta -
    //   gamma)^2)/ss - 2*sin(gamma - delta)*cos(gamma -
    //   delta)/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg))/sin(phi_minus_90deg)
    //   - ((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*sin(gamma - epsilon - omega)^2 + m4*sin(gamma - delta -
    //   phi_minus_90deg)^2 + tan(beta + theta - gamma)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma -
    //   epsilon - omega)^2 + m4*cos(gamma - delta - phi_minus_90deg)^2) + 2*tan(beta + theta -
    //   gamma)*(m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + m4*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss) + cos(beta - gamma)*tan(beta + theta -
    //   gamma)*(2*m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + (2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma -
    //   epsilon)*cos(gamma - epsilon)/zf^2 + m6*(2*sin(omega)^2*sin(gamma - epsilon - omega)*cos(gamma -
    //   epsilon - omega) - cos(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) -
    //   sin(gamma - epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) -
    //   fa*(cos(gamma - epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + 2*m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (2*I4*sin(gamma -
    //   delta)*cos(gamma - delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)
    //   + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d) + cos(beta -
    //   gamma)*((I2*(sin(beta - gamma)*tan(gamma - beta - theta) + cos(beta - gamma)*tan(beta + theta -
    //   gamma)^2) + m2*da^2*(sin(beta - gamma)*tan(gamma - beta - theta) + cos(beta - gamma)*tan(beta +
    //   theta - gamma)^2))/(d*ss) - cos(theta)*(m2*da*cos(beta + theta - gamma)/ss + 2*m6*sin(gamma -
    //   epsilon - omega)*cos(gamma - epsilon - omega) + (2*sin(gamma - epsilon - omega)*cos(gamma - epsilon
    //   - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - 2*I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 +
    //   m6*(2*sin(omega)^2*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) - cos(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf) - sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 +
    //   2*m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (2*I4*sin(gamma -
    //   delta)*cos(gamma - delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)
    //   + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta -
    //   gamma)))/cos(beta + theta - gamma))))/cos(beta + theta - gamma))/d1 - d1_by_gamma*(mom +
    //   rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma -
    //   beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta +
    //   theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta -
    //   gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
    //   2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1
    //   + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta -
    //   gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 +
    //   (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_gamma = -d1_inv
        * (beta_rate_dot_by_beta_of_beta_rate_6
            + rr_cos_angle_inv
                * (beta_rate_dot_by_beta_of_beta_rate_2
                    + sin_theta
                        * (beta_rate_dot_by_beta_of_place_151
                            * (beta_rate_dot_by_beta_of_place_148
                                * beta_rate_dot_by_beta_of_place_149)
                                .mul_add(
                                    beta_rate_dot_by_gamma_of_place_53,
                                    beta_rate_dot_by_gamma_of_place_54,
                                )
                            - rr_beta_rate_sq
                                * (beta_rate_dot_by_beta_of_place_132
                                    - cos_angle_inv
                                        * (rr
                                            * (beta_rate_dot_by_beta_of_place_127
                                                + cos_angle_inv
                                                    * (beta_rate_dot_by_beta_of_place_33
                                                        + d1_of_d_beta_gamma
                                                            * (beta_rate_dot_by_beta_of_place_25
                                                                + cos_theta
                                                                    * (-m2_da)
                                                                        .mul_add(
                                                                            cos_angle_ss_inv,
                                                                            beta_rate_dot_by_gamma_of_place_51,
                                                                        ))
                                                        + sin_theta
                                                            * (beta_rate_dot_by_beta_of_place_24
                                                                + sin_theta
                                                                    * (cos_omega_inv
                                                                        * (cos_omega_inv
                                                                            * (-d1_of_place_3
                                                                                * (u_2_inv
                                                                                    * (m6_d1_of_place_3
                                                                                        * (beta_rate_dot_by_beta_of_place_43
                                                                                            + beta_rate_dot_by_beta_of_place_60)
                                                                                        + cos_omega_inv
                                                                                            * (beta_rate_dot_by_beta_of_place_42
                                                                                                * cos_gamma_minus_epsilon
                                                                                                + beta_rate_dot_by_beta_of_place_47
                                                                                                    * beta_rate_dot_by_beta_of_place_60
                                                                                                - sin_gamma_minus_epsilon
                                                                                                    * (zf_inv
                                                                                                        * (d1_of_place_11 + beta_rate_dot_by_beta_of_place_37
                                                                                                            + sin_omega_cos_omega_inv
                                                                                                                * (beta_rate_dot_by_gamma_of_place
                                                                                                                    - beta_rate_dot_by_beta_of_place_41))
                                                                                                        + m6
                                                                                                            * (-sin_omega_cos_omega_inv)
                                                                                                                .mul_add(
                                                                                                                    beta_rate_dot_by_gamma_of_place_3,
                                                                                                                    sin_gamma_minus_epsilon,
                                                                                                                ))
                                                                                                + sin_omega_d1_of_place_3
                                                                                                    * (-m6)
                                                                                                        .mul_add(
                                                                                                            beta_rate_dot_by_beta_of_place_49,
                                                                                                            beta_rate_dot_by_gamma_of_place_4,
                                                                                                        ))
                                                                                        - ss_inv_u_2_inv
                                                                                            * (m7 * ua_sq_plus_ub_sq)
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_gamma_of_place_6,
                                                                                                    I7 * beta_rate_dot_by_gamma_of_place_6,
                                                                                                ) + beta_rate_dot_by_gamma_of_place_8)
                                                                                    - m6
                                                                                        * (sin_omega
                                                                                            * (zf_inv
                                                                                                * (sin_gamma_minus_epsilon
                                                                                                    * (beta_rate_dot_by_gamma_of_place_10 - fa_ss_inv)
                                                                                                    + beta_rate_dot_by_beta_of_place_56
                                                                                                        * cos_gamma_minus_epsilon)
                                                                                                + ss_inv
                                                                                                    * (beta_rate_dot_by_gamma_of_place_6
                                                                                                        .mul_add(sin_omega, -sin_gamma_minus_epsilon)
                                                                                                        - beta_rate_dot_by_gamma_of_place_11))
                                                                                            + d1_of_place_10 * beta_rate_dot_by_gamma_of_place_9))
                                                                                + beta_rate_dot_by_beta_of_place_70
                                                                                    * cos_gamma_minus_epsilon
                                                                                + sin_gamma_minus_epsilon
                                                                                    * (zf_inv_i6_zf_inv
                                                                                        * ss_inv
                                                                                            .mul_add(
                                                                                                beta_rate_dot_by_gamma_of_place_12,
                                                                                                beta_rate_dot_by_beta_of_place_63
                                                                                                    * beta_rate_dot_by_beta_of_place_69,
                                                                                            )
                                                                                        + m6
                                                                                            * (ss_inv
                                                                                                * (sin_omega_d1_of_place_3
                                                                                                    + beta_rate_dot_by_gamma_of_place_12)
                                                                                                + zf_inv
                                                                                                    * (-beta_rate_dot_by_beta_of_place_68
                                                                                                        * (-cos_omega_inv)
                                                                                                            .mul_add(cos_gamma_minus_epsilon, d1_of_place_3)
                                                                                                        + beta_rate_dot_by_gamma_of_place_15
                                                                                                            * cos_gamma_minus_epsilon
                                                                                                        - fa
                                                                                                            * (ss_inv
                                                                                                                * (-fa_zf_inv)
                                                                                                                    .mul_add(
                                                                                                                        beta_rate_dot_by_gamma_of_place_12,
                                                                                                                        sin_omega_d1_of_place_3 + beta_rate_dot_by_gamma_of_place_11,
                                                                                                                    )
                                                                                                                - beta_rate_dot_by_beta_of_place_65
                                                                                                                    * cos_omega_inv.mul_add(d1_by_gamma_of_place, d1_of_place_3)
                                                                                                                + beta_rate_dot_by_gamma_of_place_13
                                                                                                                    * beta_rate_dot_by_gamma_of_place_14))))
                                                                                - beta_rate_dot_by_gamma_of_place_16)
                                                                            - beta_rate_dot_by_beta_of_place_72
                                                                                * beta_rate_dot_by_gamma_of_place_13
                                                                            + beta_rate_dot_by_gamma_of_place_19)
                                                                        + ss_inv
                                                                            * (beta_rate_dot_by_beta_of_place_4
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_beta_of_place_5,
                                                                                    ss_inv_d1_of_place_2,
                                                                                )
                                                                                - beta_rate_dot_by_beta_of_place_55
                                                                                    * beta_rate_dot_by_beta_of_place_120
                                                                                + beta_rate_dot_by_gamma_of_place_17
                                                                                + beta_rate_dot_by_gamma_of_place_43)
                                                                        + sin_phi_minus_90deg_inv
                                                                            * (sin_phi_minus_90deg_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (m4
                                                                                        * (ss_inv
                                                                                            * (d1_of_place_16 + beta_rate_dot_by_gamma_of_place_35)
                                                                                            - e_inv
                                                                                                * (ea
                                                                                                    * (ss_inv
                                                                                                        * beta_rate_dot_by_beta_of_place_55
                                                                                                            .mul_add(beta_rate_dot_by_beta_of_place_111, d1_of_place_16)
                                                                                                        - e_inv
                                                                                                            * (cos_gamma_minus_delta
                                                                                                                * (-beta_rate_dot_by_beta_of_place_77)
                                                                                                                    .mul_add(
                                                                                                                        beta_rate_dot_by_gamma_of_place_36,
                                                                                                                        beta_rate_dot_by_beta_of_place_13,
                                                                                                                    ) + beta_rate_dot_by_gamma_of_place_37))
                                                                                                    + beta_rate_dot_by_gamma_of_place_39))
                                                                                        + e_inv_i4_e_inv
                                                                                            * ss_inv
                                                                                                .mul_add(
                                                                                                    beta_rate_dot_by_gamma_of_place_35,
                                                                                                    -beta_rate_dot_by_gamma_of_place_40,
                                                                                                ))
                                                                                    - d1_of_place_15
                                                                                        * (zt_inv
                                                                                            * (beta_rate_dot_by_gamma_of_place_26
                                                                                                - ss_inv_zt_inv
                                                                                                    * (m5 * ta_sq_plus_tb_sq)
                                                                                                        .mul_add(
                                                                                                            beta_rate_dot_by_gamma_of_place_21,
                                                                                                            I5 * beta_rate_dot_by_gamma_of_place_21,
                                                                                                        ) + beta_rate_dot_by_gamma_of_place_28)
                                                                                            + m4
                                                                                                * (cos_phi_minus_90deg
                                                                                                    * (ss_inv
                                                                                                        * (beta_rate_dot_by_beta_of_place_5
                                                                                                            .mul_add(
                                                                                                                beta_rate_dot_by_beta_of_place_16,
                                                                                                                cos_gamma_minus_delta,
                                                                                                            ) + beta_rate_dot_by_gamma_of_place_32)
                                                                                                        - e_inv
                                                                                                            * (cos_gamma_minus_delta
                                                                                                                * (beta_rate_dot_by_beta_of_place_17
                                                                                                                    - beta_rate_dot_by_gamma_of_place_29)
                                                                                                                + beta_rate_dot_by_gamma_of_place_31))
                                                                                                    + beta_rate_dot_by_gamma_of_place_34))
                                                                                    + beta_rate_dot_by_gamma_of_place_42)
                                                                                + beta_rate_dot_by_gamma_of_place_46))
                                                                - beta_rate_dot_by_beta_of_place_122
                                                                    * beta_rate_dot_by_gamma_of_place_52)))
                                            + beta_rate_dot_by_gamma_of_place_52 * cos_theta)))))
        - d1_by_gamma * beta_rate_dot_by_beta_of_beta_rate_7;
    let d1_by_delta_of_place = rr_cos_angle_inv * sin_theta;
    let d1_by_delta_of_place_sq = d1_by_delta_of_place * d1_by_delta_of_place;
    let d1_by_delta_of_place_2 = S::int(2) * d1_by_delta_of_place_sq;
    // d1_by_delta = 2*rr^2*sin(theta)^2*(I4*sin(gamma - delta)*cos(gamma - delta)/e^2 + sin(gamma - delta
    //   - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta)*(sin(gamma - delta) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) +
    //   ea*(sin(gamma - delta)*(ea/e - 2) + sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/e) +
    //   cos(gamma - delta - phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*cos(phi_minus_90deg)*(ea/e - 1))))/(cos(beta + theta - gamma)^2*sin(phi_minus_90deg)^2)
    let d1_by_delta = d1_by_gamma_of_place_8 * d1_by_delta_of_place_2;
    // d1_of_place_15 - beta_rate_dot_by_gamma_of_place_20
    let beta_rate_dot_by_delta_of_place = d1_of_place_15 - beta_rate_dot_by_gamma_of_place_20;
    // beta_rate_dot_by_gamma_of_place_28 + ss_inv_zt_inv*(I5*beta_rate_dot_by_delta_of_place +
    //   m5*ta_sq_plus_tb_sq*beta_rate_dot_by_delta_of_place)
    let beta_rate_dot_by_delta_of_place_2 = beta_rate_dot_by_gamma_of_place_28
        + ss_inv_zt_inv
            * (m5 * ta_sq_plus_tb_sq)
                .mul_add(
                    beta_rate_dot_by_delta_of_place,
                    I5 * beta_rate_dot_by_delta_of_place,
                );
    // cos(gamma - delta) - sin_angle_cos_angle_inv*sin(gamma - delta)
    let beta_rate_dot_by_delta_of_place_3 = (-sin_angle_cos_angle_inv)
        .mul_add(sin_gamma_minus_delta, cos_gamma_minus_delta);
    // ss_inv*(beta_rate_dot_by_gamma_of_place_44 -
    //   beta_rate_dot_by_beta_of_place_55*beta_rate_dot_by_beta_of_place_118)
    let beta_rate_dot_by_delta_of_place_4 = ss_inv
        * (-beta_rate_dot_by_beta_of_place_55)
            .mul_add(
                beta_rate_dot_by_beta_of_place_118, beta_rate_dot_by_gamma_of_place_44,
            );
    // 2*beta_rate_dot_by_beta_of_place_118 + beta_rate_dot_by_gamma_of_place_49
    let beta_rate_dot_by_delta_of_place_5 = beta_rate_dot_by_beta_of_place_118
        .mul_add(S::int(2), beta_rate_dot_by_gamma_of_place_49);
    let beta_rate_dot_by_delta_of_place_6 = beta_rate_dot_by_delta_of_place_5 * cos_theta;
    let beta_rate_dot_by_delta_of_beta_rate = beta_rate * d1_by_delta_of_place;
    let beta_rate_dot_by_delta_of_beta_rate_2 = beta_rate * rr_cos_angle_inv;
    let beta_rate_dot_by_delta_of_beta_rate_3 = d1_inv * beta_rate_dot_by_delta_of_beta_rate_2;
    let beta_rate_dot_by_delta_of_beta_rate_4 = beta_rate_dot_by_delta_of_beta_rate
        * beta_rate_dot_by_delta_of_beta_rate_3;
    // beta_rate_dot_by_delta = rr^2*beta_rate^2*sin(theta)*(cos(theta)*(2*m4*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (2*I4*sin(gamma - delta)*cos(gamma -
    //   delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma
    //   - delta - phi_minus_90deg) + sin(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e) + cos(gamma - delta)*(sin(gamma -
    //   delta) - 2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e
    //   - 2) + 2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) +
    //   rr*(sin(theta)*(cos(beta - gamma)*tan(gamma - beta - theta)*(2*m4*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (2*I4*sin(gamma - delta)*cos(gamma -
    //   delta)/e^2 + 2*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma
    //   - delta - phi_minus_90deg) + sin(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e) + cos(gamma - delta)*(sin(gamma -
    //   delta) - 2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e
    //   - 2) + 2*sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d +
    //   sin(theta)*((m4*cos(gamma - delta)*sin(gamma - delta - phi_minus_90deg)^2/e - m4*cos(gamma -
    //   delta)*cos(gamma - delta - phi_minus_90deg)^2/e + m4*sin(gamma - delta)*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)/e + (sin(gamma - delta)*(m4*((sin(gamma -
    //   delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2) - sin(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma - delta -
    //   phi_minus_90deg)*((m4*sin(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (sin(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)) -
    //   cos(gamma - delta)*((cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta -
    //   phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt - (sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) +
    //   sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(cos(gamma - delta) + (2*sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg) - sin(gamma - delta))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*cos(gamma - delta)*(1 - ea/e) +
    //   sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) + m4*cos(gamma - delta -
    //   phi_minus_90deg)*(sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)) + (I5*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta
    //   - theta) + cos(gamma - delta - phi_minus_90deg)) + m5*(ta^2*(sin(gamma - delta -
    //   phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma - delta - phi_minus_90deg)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma - delta -
    //   phi_minus_90deg))))/(ss*zt))/zt + m4*(2*sin(gamma - delta)*cos(gamma - delta)*(ea/e - 1)/e +
    //   cos(phi_minus_90deg)*((ea*cos(gamma - delta)/ss + sin(gamma - delta)*(2*ea*tan(gamma - beta -
    //   theta)/ss + cos(gamma - delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta
    //   - phi_minus_90deg))/tan(phi_minus_90deg)) + cos(gamma - delta)*(sin(gamma - delta - phi_minus_90deg)
    //   + (cos(gamma - delta - phi_minus_90deg) + (2*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/sin(phi_minus_90deg))/tan(phi_minus_90deg)))/e +
    //   (cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - cos(gamma - delta) - tan(gamma - beta -
    //   theta)*(2*sin(gamma - delta) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg)))/ss))) -
    //   cos(gamma - delta)*(m4*((sin(gamma - delta)*tan(gamma - beta - theta) + cos(gamma - delta) -
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss + (sin(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) + cos(gamma
    //   - delta)*(sin(gamma - delta)/sin(phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg) - ea*((2*sin(gamma - delta)*tan(gamma - beta - theta) +
    //   2*cos(gamma - delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss + (sin(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)) - ea*cos(gamma - delta)/ss - cos(gamma -
    //   delta)*(sin(gamma - delta)*(ea/e - 2)/sin(phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/e))/e) + I4*((sin(gamma - delta)*tan(gamma - beta - theta) +
    //   cos(gamma - delta))/ss + 2*sin(gamma - delta)*cos(gamma -
    //   delta)/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg))/sin(phi_minus_90deg)
    //   + (m4*sin(gamma - delta - phi_minus_90deg)^2 - m4*cos(gamma - delta - phi_minus_90deg)^2 -
    //   2*m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*tan(gamma - beta -
    //   theta))/ss)) - cos(theta)*cos(beta - gamma)*(2*m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + (2*I4*sin(gamma - delta)*cos(gamma - delta)/e^2 + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(2*sin(gamma
    //   - delta - phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) + sin(gamma -
    //   delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) +
    //   ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)
    //   + cos(gamma - delta)*(sin(gamma - delta) - 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + ea*(sin(gamma - delta)*(ea/e - 2) + 2*sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d)/cos(beta + theta -
    //   gamma))/(d1*cos(beta + theta - gamma)^2) - d1_by_delta*(mom + rr*(rr*beta_rate^2*(cos(beta -
    //   gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
    //   - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d +
    //   (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_delta = beta_rate_dot_by_delta_of_beta_rate_4
        * (beta_rate_dot_by_delta_of_place_6
            - rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (beta_rate_dot_by_delta_of_place_4
                            - sin_phi_minus_90deg_inv
                                * (beta_rate_dot_by_gamma_of_place_46
                                    + sin_phi_minus_90deg_inv
                                        * (beta_rate_dot_by_gamma_of_place_42
                                            - d1_of_place_15
                                                * (m4
                                                    * (beta_rate_dot_by_gamma_of_place_34
                                                        - cos_phi_minus_90deg
                                                            * (e_inv
                                                                * (-beta_rate_dot_by_gamma_of_place_29)
                                                                    .mul_add(
                                                                        cos_gamma_minus_delta,
                                                                        beta_rate_dot_by_gamma_of_place_31,
                                                                    )
                                                                + ss_inv
                                                                    * (cos_gamma_minus_delta - d1_of_place_16
                                                                        - beta_rate_dot_by_gamma_of_place_32)))
                                                    + zt_inv
                                                        * (beta_rate_dot_by_gamma_of_place_26
                                                            + beta_rate_dot_by_delta_of_place_2))
                                            + cos_gamma_minus_delta
                                                * (m4
                                                    * (e_inv
                                                        * (ea
                                                            * (ss_inv
                                                                * (-beta_rate_dot_by_beta_of_place_55)
                                                                    .mul_add(
                                                                        sin_gamma_minus_delta,
                                                                        beta_rate_dot_by_beta_of_place_16,
                                                                    )
                                                                + e_inv
                                                                    * (-beta_rate_dot_by_beta_of_place_110)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_gamma_of_place_36,
                                                                            beta_rate_dot_by_gamma_of_place_37,
                                                                        )) - beta_rate_dot_by_gamma_of_place_39)
                                                        + ss_inv
                                                            * (d1_of_place_16 - beta_rate_dot_by_delta_of_place_3))
                                                    - e_inv_i4_e_inv
                                                        * ss_inv
                                                            .mul_add(
                                                                beta_rate_dot_by_delta_of_place_3,
                                                                beta_rate_dot_by_gamma_of_place_40,
                                                            )))))
                        + beta_rate_dot_by_beta_of_place_122 * beta_rate_dot_by_delta_of_place_5)
                    + d1_of_d_beta_gamma * beta_rate_dot_by_delta_of_place_6))
        - d1_by_delta * beta_rate_dot_by_beta_of_beta_rate_7;
    // d1_by_phi_minus_90deg = -2*rr^2*sin(theta)^2*(m4*cos(gamma - delta)*cos(gamma - delta -
    //   phi_minus_90deg)*(ea/e - 1) + (cos(phi_minus_90deg)*(m4*cos(gamma - delta)*sin(gamma - delta -
    //   phi_minus_90deg)*(1 - ea/e) + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)) - sin(gamma - delta - phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg)*(m4 + (I5 + m5*(ta^2 + tb^2))/zt^2))/sin(phi_minus_90deg))/(cos(beta +
    //   theta - gamma)^2*sin(phi_minus_90deg))
    let d1_by_phi_minus_90deg = -sin_phi_minus_90deg_inv * d1_by_delta_of_place_2
        * (sin_phi_minus_90deg_inv
            * (cos_phi_minus_90deg
                * (-beta_rate_dot_by_beta_of_place_89)
                    .mul_add(
                        beta_rate_dot_by_gamma_of_place_27,
                        d1_of_place_24 * sin_phi_minus_90deg_inv,
                    )
                - d1_of_place_15 * beta_rate_dot_by_beta_of_place_79
                    * (m4 + beta_rate_dot_by_beta_of_place_84))
            + m4_d1_of_place_15 * beta_rate_dot_by_beta_of_place_89);
    let beta_rate_dot_by_phi_minus_90deg_of_place = beta_rate_dot_by_beta_of_place_77
        * beta_rate_dot_by_beta_of_place_77;
    // 1 + beta_rate_dot_by_phi_minus_90deg_of_place
    let beta_rate_dot_by_phi_minus_90deg_of_place_2 = S::int(1)
        + beta_rate_dot_by_phi_minus_90deg_of_place;
    // d1_of_place_15*sin(phi_minus_90deg) - beta_rate_dot_by_beta_of_place_98
    let beta_rate_dot_by_phi_minus_90deg_of_place_3 = d1_of_place_15
        .mul_add(sin_phi_minus_90deg, -beta_rate_dot_by_beta_of_place_98);
    // -beta_rate_dot_by_phi_minus_90deg_of_place_3
    let beta_rate_dot_by_phi_minus_90deg_of_place_4 = -beta_rate_dot_by_phi_minus_90deg_of_place_3;
    let beta_rate_dot_by_phi_minus_90deg_of_place_5 = d1_of_place_15
        * beta_rate_dot_by_beta_of_place_114;
    // d1_of_place_16 + beta_rate_dot_by_beta_of_place_79*sin(phi_minus_90deg)
    let beta_rate_dot_by_phi_minus_90deg_of_place_6 = beta_rate_dot_by_beta_of_place_79
        .mul_add(sin_phi_minus_90deg, d1_of_place_16);
    let beta_rate_dot_by_phi_minus_90deg_of_place_7 = ss_inv
        * beta_rate_dot_by_phi_minus_90deg_of_place_6;
    // d1_of_place_15 + beta_rate_dot_by_beta_of_place_115
    let beta_rate_dot_by_phi_minus_90deg_of_place_8 = d1_of_place_15
        + beta_rate_dot_by_beta_of_place_115;
    // beta_rate_dot_by_beta_of_place_118 -
    //   sin_phi_minus_90deg_inv*beta_rate_dot_by_beta_of_place_20*beta_rate_dot_by_beta_of_place_114 +
    //   d1_of_place_25*(d1_by_gamma_of_place_7 + m4*(cos(gamma -
    //   delta)*(beta_rate_dot_by_phi_minus_90deg_of_place_3 +
    //   ea_e_inv*beta_rate_dot_by_phi_minus_90deg_of_place_4) -
    //   d1_of_place_16*beta_rate_dot_by_phi_minus_90deg_of_place_3))
    let beta_rate_dot_by_phi_minus_90deg_of_place_9 = beta_rate_dot_by_beta_of_place_118
        - sin_phi_minus_90deg_inv * beta_rate_dot_by_beta_of_place_20
            * beta_rate_dot_by_beta_of_place_114
        + d1_of_place_25
            * (d1_by_gamma_of_place_7
                + m4
                    * (cos_gamma_minus_delta
                        * ea_e_inv
                            .mul_add(
                                beta_rate_dot_by_phi_minus_90deg_of_place_4,
                                beta_rate_dot_by_phi_minus_90deg_of_place_3,
                            ) - d1_of_place_16 * beta_rate_dot_by_phi_minus_90deg_of_place_3));
    let cos_theta_doubled = S::int(2) * cos_theta;
    let beta_rate_dot_by_phi_minus_90deg_of_place_10 = beta_rate_dot_by_phi_minus_90deg_of_place_9
        * cos_theta_doubled;
    // beta_rate_dot_by_phi_minus_90deg = rr^2*beta_rate^2*sin(theta)*(2*cos(theta)*(m4*sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - (I4*cos(gamma - delta)^2/e^2 + cos(gamma -
    //   delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma -
    //   delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) -
    //   sin(phi_minus_90deg)*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma -
    //   delta)*(sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - ea*(sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(2*cos(theta)*cos(beta -
    //   gamma)*(m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e
    //   - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) -
    //   sin(phi_minus_90deg)*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma -
    //   delta)*(sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - ea*(sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d +
    //   sin(theta)*(sin(theta)*((m4*cos(gamma - delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg)/e - (cos(gamma - delta - phi_minus_90deg)*((m4*cos(gamma - delta -
    //   phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma -
    //   delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))
    //   + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) + (cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) - (I5*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) +
    //   m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta +
    //   theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e - 1)/e +
    //   cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma - delta -
    //   phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg))
    //   - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma - delta) -
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg))/(sin(phi_minus_90deg)*tan(phi_minus_90deg))
    //   + (m4*cos(gamma - delta - phi_minus_90deg)^2 - m4*sin(gamma - delta - phi_minus_90deg)^2 +
    //   2*m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*tan(gamma - beta -
    //   theta))/ss + (m4*cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg)^2/e - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)^2/e - (cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/(sin(phi_minus_90deg)*tan(phi_minus_90deg))
    //   - (cos(gamma - delta)*(m4*((sin(phi_minus_90deg)*sin(gamma - delta - phi_minus_90deg) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/ss + (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg)) -
    //   ea*((sin(phi_minus_90deg)*sin(gamma - delta - phi_minus_90deg) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/ss + cos(gamma - delta)*(cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg) + (cos(gamma - delta)*(2 -
    //   ea/e)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)^2 +
    //   (cos(gamma - delta)*(2 - ea/e)/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))/e) + cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta)/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + cos(gamma -
    //   delta - phi_minus_90deg))/tan(phi_minus_90deg))/e) + I4*(cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)) + 2*cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)^2))/e^2) - sin(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma - delta -
    //   phi_minus_90deg)*((m4*sin(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) - (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) +
    //   (I5*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta) + cos(gamma - delta -
    //   phi_minus_90deg)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta - theta) +
    //   cos(gamma - delta - phi_minus_90deg)) + tb^2*(sin(gamma - delta - phi_minus_90deg)*tan(gamma - beta
    //   - theta) + cos(gamma - delta - phi_minus_90deg))))/(ss*zt) + m4*cos(gamma - delta -
    //   phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) -
    //   sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)) -
    //   sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) +
    //   cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)) - cos(gamma - delta)*((cos(gamma - delta)*(I4/e +
    //   m4*ea*(ea/e - 2)) - cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt + cos(gamma -
    //   delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)) + (cos(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt
    //   + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg)^2 + (2*m4*ea*sin(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) - sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt +
    //   2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + (cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)^2 + 2*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg) - sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg) - 2*m4*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*cos(phi_minus_90deg)^2)/(sin(phi_minus_90deg)*tan(phi_minus_90deg))))/sin(phi_minus_90deg))/zt +
    //   m4*(cos(phi_minus_90deg)*(cos(gamma - delta)*(2*sin(gamma - delta - phi_minus_90deg) - (2*cos(gamma
    //   - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg) + (sin(gamma - delta - phi_minus_90deg) - (2*cos(gamma -
    //   delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg))/tan(phi_minus_90deg)^2 + (cos(gamma - delta -
    //   phi_minus_90deg) - (2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/(sin(phi_minus_90deg)*tan(phi_minus_90deg)) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/sin(phi_minus_90deg))/tan(phi_minus_90deg))/e + (sin(phi_minus_90deg)*sin(gamma -
    //   delta - phi_minus_90deg) + cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(gamma -
    //   beta - theta)*(sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) -
    //   sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss) - sin(phi_minus_90deg)*((cos(gamma -
    //   delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma - delta - phi_minus_90deg) + ((2*cos(gamma -
    //   delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/sin(phi_minus_90deg)
    //   - sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e +
    //   (sin(gamma - delta) - sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta -
    //   gamma)*(2*cos(gamma - delta) - cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)))/ss))))/sin(phi_minus_90deg))/sin(phi_minus_90deg)) + 2*cos(beta - gamma)*tan(beta
    //   + theta - gamma)*(m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) -
    //   (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
    //   m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma -
    //   delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e
    //   - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/(sin(phi_minus_90deg)^2*tan(phi_minus_90deg)) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma -
    //   delta - phi_minus_90deg)*cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg) -
    //   sin(phi_minus_90deg)*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)^2 + cos(gamma -
    //   delta)*(sin(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - ea*(sin(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d))/cos(beta + theta -
    //   gamma))/(d1*cos(beta + theta - gamma)^2) - d1_by_phi_minus_90deg*(mom + rr*(rr*beta_rate^2*(cos(beta
    //   - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
    //   gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d +
    //   sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
    //   + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
    //   xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) -
    //   sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2
    //   + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb))
    //   + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
    //   cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) +
    //   cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d +
    //   (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma - delta -
    //   phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta - phi_minus_90deg)^2 +
    //   cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)
    //   + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_phi_minus_90deg = beta_rate_dot_by_delta_of_beta_rate_4
        * (beta_rate_dot_by_phi_minus_90deg_of_place_10
            - rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (beta_rate_dot_by_delta_of_place_4
                            - beta_rate_dot_by_beta_of_place_114
                                * beta_rate_dot_by_beta_of_place_119
                            + sin_phi_minus_90deg_inv
                                * (beta_rate_dot_by_gamma_of_place_45
                                    - beta_rate_dot_by_beta_of_place_114
                                        * beta_rate_dot_by_beta_of_place_117
                                    + sin_phi_minus_90deg_inv
                                        * (beta_rate_dot_by_gamma_of_place_41
                                            + d1_of_place_15
                                                * (zt_inv
                                                    * (beta_rate_dot_by_delta_of_place_2
                                                        - beta_rate_dot_by_beta_of_place_88
                                                            * beta_rate_dot_by_beta_of_place_114
                                                        + m4_d1_of_place_15
                                                            * beta_rate_dot_by_phi_minus_90deg_of_place_4
                                                        + sin_phi_minus_90deg_inv
                                                            * (cos_gamma_minus_delta
                                                                * (e_inv
                                                                    * (d1_of_place_21
                                                                        + beta_rate_dot_by_beta_of_place_77
                                                                            * (-(m4_d1_of_place_15 * ea_doubled))
                                                                                .mul_add(
                                                                                    sin_phi_minus_90deg,
                                                                                    beta_rate_dot_by_gamma_of_place_22,
                                                                                )
                                                                        - beta_rate_dot_by_beta_of_place_76
                                                                            * beta_rate_dot_by_phi_minus_90deg_of_place_2)
                                                                    - m4
                                                                        * (beta_rate_dot_by_beta_of_place_77
                                                                            * beta_rate_dot_by_phi_minus_90deg_of_place_4)
                                                                            .mul_add(
                                                                                S::int(2),
                                                                                d1_of_place_18 * beta_rate_dot_by_phi_minus_90deg_of_place_2,
                                                                            ))
                                                                - beta_rate_dot_by_beta_of_place_87
                                                                    * beta_rate_dot_by_phi_minus_90deg_of_place_3
                                                                + d1_of_place_16
                                                                    * ((-(m4_d1_of_place_15 * cos_phi_minus_90deg))
                                                                        .mul_add(S::int(2), beta_rate_dot_by_gamma_of_place_25)
                                                                        - beta_rate_dot_by_beta_of_place_85
                                                                            * beta_rate_dot_by_phi_minus_90deg_of_place_5)))
                                                    + m4
                                                        * (cos_phi_minus_90deg
                                                            * (d1_of_place_22
                                                                * (beta_rate_dot_by_beta_of_place_95
                                                                    * beta_rate_dot_by_phi_minus_90deg_of_place
                                                                    - S::int(2) * beta_rate_dot_by_beta_of_place_78
                                                                    - beta_rate_dot_by_beta_of_place_94
                                                                    - beta_rate_dot_by_beta_of_place_77
                                                                        * (beta_rate_dot_by_beta_of_place_93
                                                                            .mul_add(
                                                                                beta_rate_dot_by_beta_of_place_114,
                                                                                -d1_of_place_15,
                                                                            )
                                                                            - sin_phi_minus_90deg_inv
                                                                                * beta_rate_dot_by_phi_minus_90deg_of_place_4))
                                                                + ss_inv
                                                                    * (-sin_angle_cos_angle_inv)
                                                                        .mul_add(
                                                                            beta_rate_dot_by_phi_minus_90deg_of_place_4,
                                                                            beta_rate_dot_by_phi_minus_90deg_of_place_6,
                                                                        ))
                                                            + beta_rate_dot_by_beta_of_place_100 * sin_phi_minus_90deg))
                                            - cos_gamma_minus_delta
                                                * (d1_of_place_22 * e_inv_i4_e_inv
                                                    * (beta_rate_dot_by_beta_of_place_110
                                                        * beta_rate_dot_by_beta_of_place_114)
                                                        .mul_add(S::int(2), beta_rate_dot_by_beta_of_place_108)
                                                    + m4
                                                        * (beta_rate_dot_by_phi_minus_90deg_of_place_7
                                                            + e_inv
                                                                * (-ea
                                                                    * (d1_of_place_22
                                                                        * (-beta_rate_dot_by_beta_of_place_102
                                                                            + beta_rate_dot_by_beta_of_place_103
                                                                                * beta_rate_dot_by_phi_minus_90deg_of_place
                                                                            - beta_rate_dot_by_beta_of_place_77
                                                                                * d1_of_place_17
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_114,
                                                                                        -d1_of_place_15,
                                                                                    )) + beta_rate_dot_by_phi_minus_90deg_of_place_7)
                                                                    + beta_rate_dot_by_beta_of_place_109 * cos_gamma_minus_delta
                                                                    + beta_rate_dot_by_beta_of_place_110
                                                                        * (beta_rate_dot_by_gamma_of_place_38
                                                                            + beta_rate_dot_by_phi_minus_90deg_of_place_8)))))))
                        + beta_rate_dot_by_beta_of_place_133
                            * beta_rate_dot_by_phi_minus_90deg_of_place_9)
                    + d1_of_d_beta_gamma * beta_rate_dot_by_phi_minus_90deg_of_place_10))
        - d1_by_phi_minus_90deg * beta_rate_dot_by_beta_of_beta_rate_7;
    // d1_by_epsilon = 2*rr^2*sin(theta)^2*(sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 + m6*(cos(gamma - epsilon
    //   - omega)*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega)) - sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + sin(omega)*sin(gamma - epsilon - omega))/zf)))/(cos(beta + theta -
    //   gamma)^2*cos(omega)^2)
    let d1_by_epsilon = -d1_by_gamma_of_place_4 * d1_by_delta_of_place_2;
    // d1_of_place_15_zt_inv + d1_of_place_22
    let beta_rate_dot_by_epsilon_of_place = d1_of_place_15_zt_inv + d1_of_place_22;
    let beta_rate_dot_by_epsilon_of_place_2 = S::int(2) * beta_rate_dot_by_beta_of_place_86;
    let beta_rate_dot_by_epsilon_of_place_3 = d1_of_place_15_zt_inv * sin_phi_minus_90deg_inv;
    let beta_rate_dot_by_epsilon_of_place_4 = ss_inv * beta_rate_dot_by_beta_of_place_55
        * cos_phi_minus_90deg;
    // -d1_of_place_15*beta_rate_dot_by_beta_of_place_77 - beta_rate_dot_by_beta_of_place_78
    let beta_rate_dot_by_epsilon_of_place_5 = (-d1_of_place_15)
        .mul_add(beta_rate_dot_by_beta_of_place_77, -beta_rate_dot_by_beta_of_place_78);
    let beta_rate_dot_by_epsilon_of_place_6 = d1_of_place_22 * beta_rate_dot_by_beta_of_place_77;
    let beta_rate_dot_by_epsilon_of_place_7 = d1_of_place_15_zt_inv
        * beta_rate_dot_by_phi_minus_90deg_of_place_5;
    let beta_rate_dot_by_epsilon_of_place_8 = ss_inv * sin_angle_cos_angle_inv;
    let d1_by_epsilon_d1_inv = d1_by_epsilon * d1_inv;
    let beta_rate_dot_by_epsilon_of_place_9 = d1_by_epsilon_d1_inv * sin_gamma_minus_epsilon;
    // 3*cos(gamma - epsilon) + beta_rate_dot_by_epsilon_of_place_9
    let beta_rate_dot_by_epsilon_of_place_10 = cos_gamma_minus_epsilon
        .mul_add(S::int(3), beta_rate_dot_by_epsilon_of_place_9);
    let beta_rate_dot_by_epsilon_of_place_11 = d1_of_place_3 * d1_by_epsilon_d1_inv;
    // beta_rate_dot_by_beta_of_place_39 + beta_rate_dot_by_epsilon_of_place_11
    let beta_rate_dot_by_epsilon_of_place_12 = beta_rate_dot_by_beta_of_place_39
        + beta_rate_dot_by_epsilon_of_place_11;
    let beta_rate_dot_by_epsilon_of_place_13 = beta_rate_dot_by_beta_of_place_39
        * d1_by_epsilon_d1_inv;
    // d1_of_place_3 - beta_rate_dot_by_epsilon_of_place_13
    let beta_rate_dot_by_epsilon_of_place_14 = d1_of_place_3 - beta_rate_dot_by_epsilon_of_place_13;
    let cos_omega_inv_doubled = S::int(2) * cos_omega_inv;
    let beta_rate_dot_by_epsilon_of_omega = S::int(2) * sin_omega_cos_omega_inv;
    // beta_rate_dot_by_gamma_of_place_48 + beta_rate_dot_by_epsilon_of_place_11
    let beta_rate_dot_by_epsilon_of_place_15 = beta_rate_dot_by_gamma_of_place_48
        + beta_rate_dot_by_epsilon_of_place_11;
    // beta_rate_dot_by_beta_of_place_63 + beta_rate_dot_by_epsilon_of_place_9
    let beta_rate_dot_by_epsilon_of_place_16 = beta_rate_dot_by_beta_of_place_63
        + beta_rate_dot_by_epsilon_of_place_9;
    let beta_rate_dot_by_epsilon_of_place_17 = beta_rate_dot_by_epsilon_of_place_16 * sin_omega;
    // cos(gamma - epsilon) + beta_rate_dot_by_beta_of_place_68
    let beta_rate_dot_by_epsilon_of_place_18 = cos_gamma_minus_epsilon
        + beta_rate_dot_by_beta_of_place_68;
    let beta_rate_dot_by_epsilon_of_place_19 = d1_of_place_3 * beta_rate_dot_by_epsilon_of_place_15;
    // sin(gamma - epsilon) - d1_by_epsilon_d1_inv*cos(gamma - epsilon)
    let beta_rate_dot_by_epsilon_of_place_20 = (-d1_by_epsilon_d1_inv)
        .mul_add(cos_gamma_minus_epsilon, sin_gamma_minus_epsilon);
    let beta_rate_dot_by_epsilon_of_place_21 = beta_rate_dot_by_beta_of_place_39
        * beta_rate_dot_by_epsilon_of_place_18;
    // sin_angle_cos_angle_inv*beta_rate_dot_by_epsilon_of_place_16 + beta_rate_dot_by_epsilon_of_place_20
    let beta_rate_dot_by_epsilon_of_place_22 = sin_angle_cos_angle_inv
        .mul_add(
            beta_rate_dot_by_epsilon_of_place_16, beta_rate_dot_by_epsilon_of_place_20,
        );
    // d1_of_place_3*cos_omega_inv_doubled + beta_rate_dot_by_epsilon_of_place_15*sin(omega)
    let beta_rate_dot_by_epsilon_of_place_23 = beta_rate_dot_by_epsilon_of_place_15
        .mul_add(sin_omega, d1_of_place_3 * cos_omega_inv_doubled);
    // d1_by_epsilon_d1_inv - beta_rate_dot_by_beta_of_place_55
    let beta_rate_dot_by_epsilon_of_place_24 = d1_by_epsilon_d1_inv
        - beta_rate_dot_by_beta_of_place_55;
    let zf_inv_cos_omega_inv = zf_inv * cos_omega_inv;
    // beta_rate_dot_by_epsilon_of_place_14 + sin_angle_cos_angle_inv*beta_rate_dot_by_epsilon_of_place_15
    let beta_rate_dot_by_epsilon_of_place_25 = sin_angle_cos_angle_inv
        .mul_add(
            beta_rate_dot_by_epsilon_of_place_15, beta_rate_dot_by_epsilon_of_place_14,
        );
    let beta_rate_dot_by_epsilon_of_place_26 = ss_inv * beta_rate_dot_by_epsilon_of_place_25;
    // 3*beta_rate_dot_by_beta_of_place_39 + beta_rate_dot_by_epsilon_of_place_11
    let beta_rate_dot_by_epsilon_of_place_27 = beta_rate_dot_by_beta_of_place_39
        .mul_add(S::int(3), beta_rate_dot_by_epsilon_of_place_11);
    let beta_rate_dot_by_epsilon_of_place_28 = d1_of_place_3_u_2_inv
        * beta_rate_dot_by_epsilon_of_place_27;
    let beta_rate_dot_by_epsilon_of_place_29 = beta_rate_dot_by_beta_of_place_39
        * beta_rate_dot_by_beta_of_place_39;
    // beta_rate_dot_by_epsilon_of_place_14 + sin_omega_cos_omega_inv*beta_rate_dot_by_epsilon_of_place_15
    let beta_rate_dot_by_epsilon_of_place_30 = sin_omega_cos_omega_inv
        .mul_add(
            beta_rate_dot_by_epsilon_of_place_15, beta_rate_dot_by_epsilon_of_place_14,
        );
    // beta_rate_dot_by_beta_of_place_39 - d1_of_place_3*sin_omega_cos_omega_inv
    let beta_rate_dot_by_epsilon_of_place_31 = (-d1_of_place_3)
        .mul_add(sin_omega_cos_omega_inv, beta_rate_dot_by_beta_of_place_39);
    // ss_inv - d1_of_place_10*cos_omega_inv
    let beta_rate_dot_by_epsilon_of_place_32 = (-d1_of_place_10)
        .mul_add(cos_omega_inv, ss_inv);
    let beta_rate_dot_by_epsilon_of_place_33 = cos_gamma_minus_epsilon * cos_gamma_minus_epsilon;
    let beta_rate_dot_by_epsilon_of_place_34 = S::int(2) * d1_by_gamma_of_place_4;
    // d1_of_place_27*d1_by_epsilon_d1_inv + beta_rate_dot_by_epsilon_of_place_34
    let beta_rate_dot_by_epsilon_of_place_35 = d1_of_place_27
        .mul_add(d1_by_epsilon_d1_inv, beta_rate_dot_by_epsilon_of_place_34);
    // beta_rate_dot_by_epsilon = (rr*(rr*beta_rate^2*d1_by_epsilon*(m2*da*cos(theta)*sin(beta - gamma) -
    //   cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta -
    //   gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta +
    //   theta - gamma)))))/(d*cos(beta + theta - gamma)))/(d*d1) +
    //   sin(theta)*(rr*beta_rate^2*((cos(theta)*(2*(sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega)*(I7 + m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 +
    //   m6*(cos(gamma - epsilon - omega)*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon
    //   - omega)) - sin(gamma - epsilon)*(cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega) -
    //   fa*(cos(gamma - epsilon)*(2 - fa/zf) + sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 -
    //   d1_by_epsilon*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon
    //   - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d1) +
    //   rr*(m2*da*d1_by_epsilon*(cos(beta - gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/(d*d1) +
    //   (sin(theta)*(sin(theta)*((m6*((sin(gamma - epsilon - omega)^2 + cos(gamma - epsilon)*(cos(gamma -
    //   epsilon) + 2*sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   2*sin(omega)*sin(gamma - epsilon - omega))/zf))/ss + sin(gamma - epsilon)*((2*cos(gamma -
    //   epsilon)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1 - sin(gamma - epsilon - omega)) + fa*(sin(gamma - epsilon)*sin(gamma - epsilon - omega)/zf
    //   + ((sin(gamma - epsilon)*(fa*cos(gamma - epsilon - omega)/u + 2*(d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1 - sin(gamma - epsilon - omega))/cos(omega) + sin(omega)*(cos(gamma - epsilon - omega) +
    //   d1_by_epsilon*sin(gamma - epsilon - omega)/d1 + (fa*((sin(gamma - epsilon - omega) -
    //   d1_by_epsilon*cos(gamma - epsilon - omega)/d1)/u + (3*cos(gamma - epsilon) + d1_by_epsilon*sin(gamma
    //   - epsilon)/d1)/zf) - 6*cos(gamma - epsilon) - 2*d1_by_epsilon*sin(gamma - epsilon)/d1)/cos(omega)))
    //   + cos(gamma - epsilon)*(2*sin(omega)*sin(gamma - epsilon - omega) + 4*cos(gamma - epsilon -
    //   omega)/cos(omega) + fa*(sin(gamma - epsilon - omega) - cos(gamma - epsilon - omega)*(2*tan(omega) +
    //   d1_by_epsilon/d1))/u))/zf - (2*sin(gamma - epsilon - omega)*(cos(gamma - epsilon) + sin(gamma -
    //   epsilon)*tan(omega)) + cos(gamma - epsilon - omega)*(2*sin(gamma - epsilon) - sin(omega)*cos(gamma -
    //   epsilon - omega) - 2*d1_by_epsilon*cos(gamma - epsilon)/d1 + 2*(d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1 - 2*sin(gamma - epsilon - omega) - sin(omega)*(2*cos(gamma - epsilon) +
    //   d1_by_epsilon*sin(gamma - epsilon)/d1))/cos(omega)))/u)/cos(omega) - (sin(gamma - epsilon)*(fa/zf -
    //   2) + 2*sin(omega)*cos(gamma - epsilon - omega) + d1_by_epsilon*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   sin(omega)*sin(gamma - epsilon - omega))/d1 + tan(gamma - beta - theta)*(2*cos(gamma - epsilon)*(2 -
    //   fa/zf) + 2*sin(omega)*sin(gamma - epsilon - omega) - d1_by_epsilon*(sin(gamma - epsilon)*(fa/zf - 2)
    //   + 2*sin(omega)*cos(gamma - epsilon - omega))/d1))/ss - cos(gamma - epsilon - omega)*((2*cos(gamma -
    //   epsilon) + d1_by_epsilon*sin(gamma - epsilon)/d1)/zf + (2*sin(gamma - epsilon - omega) -
    //   d1_by_epsilon*cos(gamma - epsilon - omega)/d1)/u)) + (sin(gamma - epsilon - omega)*(2*sin(gamma -
    //   epsilon)/cos(omega) - sin(gamma - epsilon - omega)) + sin(omega)*((sin(gamma - epsilon)*(3*cos(gamma
    //   - epsilon) + d1_by_epsilon*sin(gamma - epsilon)/d1) + cos(gamma - epsilon -
    //   omega)*(d1_by_epsilon*cos(gamma - epsilon - omega)/d1 - 2*sin(gamma - epsilon - omega)))/cos(omega)
    //   - 2*cos(gamma - epsilon)*sin(gamma - epsilon - omega) - sin(gamma - epsilon)*(cos(gamma - epsilon -
    //   omega) + d1_by_epsilon*sin(gamma - epsilon - omega)/d1)) + cos(gamma - epsilon - omega)*(cos(gamma -
    //   epsilon - omega) + d1_by_epsilon*sin(gamma - epsilon - omega)/d1 - 2*(2*cos(gamma - epsilon) +
    //   d1_by_epsilon*sin(gamma - epsilon)/d1)/cos(omega)))/cos(omega))/zf + (cos(gamma - epsilon -
    //   omega)*(2*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma - epsilon - omega)/d1) + (sin(gamma
    //   - epsilon - omega)*(cos(gamma - epsilon) + sin(gamma - epsilon)*tan(omega)) + cos(gamma - epsilon -
    //   omega)*(sin(gamma - epsilon) - sin(omega)*cos(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma -
    //   epsilon)/d1 + (2*d1_by_epsilon*cos(gamma - epsilon - omega)/d1 - 4*sin(gamma - epsilon - omega) -
    //   sin(omega)*(2*cos(gamma - epsilon) + d1_by_epsilon*sin(gamma -
    //   epsilon)/d1))/cos(omega)))/cos(omega))/u + (d1_by_epsilon*cos(gamma - epsilon)/d1 - sin(gamma -
    //   epsilon) - tan(beta + theta - gamma)*(2*cos(gamma - epsilon) + d1_by_epsilon*sin(gamma -
    //   epsilon)/d1) + sin(omega)*(2*cos(gamma - epsilon - omega) + d1_by_epsilon*sin(gamma - epsilon -
    //   omega)/d1 + 2*tan(gamma - beta - theta)*(sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma -
    //   epsilon - omega)/d1)))/ss) - cos(gamma - epsilon - omega)*(cos(gamma - epsilon)*((cos(gamma -
    //   epsilon - omega)*(1 - fa/zf) + (cos(gamma - epsilon) - 2*cos(gamma - epsilon - omega)/cos(omega) +
    //   sin(omega)*(2*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma - epsilon - omega)/d1) +
    //   fa*(cos(gamma - epsilon)*(fa/zf - 2) + 2*cos(gamma - epsilon - omega)/cos(omega) +
    //   sin(omega)*(d1_by_epsilon*cos(gamma - epsilon - omega)/d1 - 2*sin(gamma - epsilon -
    //   omega)))/zf)/cos(omega))/u - sin(gamma - epsilon - omega)/(zf*cos(omega)) - sin(omega)*(cos(gamma -
    //   epsilon - omega)/(zf*cos(omega)^2) + (2*tan(beta + theta - gamma) - d1_by_epsilon/d1 +
    //   fa*(d1_by_epsilon/d1 - 2*tan(beta + theta - gamma))/zf)/ss)) + (cos(gamma - epsilon - omega) +
    //   d1_by_epsilon*sin(gamma - epsilon - omega)/d1 + tan(gamma - beta - theta)*(2*sin(gamma - epsilon -
    //   omega) - d1_by_epsilon*cos(gamma - epsilon - omega)/d1))/ss + cos(gamma - epsilon -
    //   omega)*tan(omega)*(d1_by_epsilon*cos(gamma - epsilon - omega)/d1 - 3*sin(gamma - epsilon -
    //   omega))/(u*cos(omega)))) + ((sin(gamma - epsilon - omega)^2*(m7*((ua^2 + ub^2)/ss - sin(gamma -
    //   epsilon)*(ua^2 + ub^2)/(zf*cos(omega))) + I7*(1/ss - sin(gamma - epsilon)/(zf*cos(omega)))) +
    //   cos(gamma - epsilon - omega)*(m7*(((cos(gamma - epsilon)*(ua^2*(sin(gamma - epsilon - omega) +
    //   cos(gamma - epsilon - omega)*tan(omega)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon
    //   - omega)*tan(omega))) + sin(gamma - epsilon)*(ua^2*(cos(gamma - epsilon - omega) +
    //   d1_by_epsilon*sin(gamma - epsilon - omega)/d1 + tan(omega)*(d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1 - 2*sin(gamma - epsilon - omega))) + ub^2*(cos(gamma - epsilon - omega) +
    //   d1_by_epsilon*sin(gamma - epsilon - omega)/d1 + tan(omega)*(d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1 - 2*sin(gamma - epsilon - omega)))))/zf + cos(gamma - epsilon -
    //   omega)*tan(omega)*(ua^2*(3*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1) + ub^2*(3*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma - epsilon -
    //   omega)/d1))/u)/cos(omega) - (ua^2*(cos(gamma - epsilon - omega) + d1_by_epsilon*sin(gamma - epsilon
    //   - omega)/d1 + tan(gamma - beta - theta)*(2*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma -
    //   epsilon - omega)/d1)) + ub^2*(cos(gamma - epsilon - omega) + d1_by_epsilon*sin(gamma - epsilon -
    //   omega)/d1 + tan(gamma - beta - theta)*(2*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma -
    //   epsilon - omega)/d1)))/ss) + I7*((cos(gamma - epsilon - omega)*tan(omega)*(3*sin(gamma - epsilon -
    //   omega) - d1_by_epsilon*cos(gamma - epsilon - omega)/d1)/u + (cos(gamma - epsilon)*(sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega)) + sin(gamma - epsilon)*(cos(gamma -
    //   epsilon - omega) + d1_by_epsilon*sin(gamma - epsilon - omega)/d1 +
    //   tan(omega)*(d1_by_epsilon*cos(gamma - epsilon - omega)/d1 - 2*sin(gamma - epsilon -
    //   omega))))/zf)/cos(omega) - (cos(gamma - epsilon - omega) + d1_by_epsilon*sin(gamma - epsilon -
    //   omega)/d1 + tan(gamma - beta - theta)*(2*sin(gamma - epsilon - omega) - d1_by_epsilon*cos(gamma -
    //   epsilon - omega)/d1))/ss)))/u + I6*(sin(gamma - epsilon)*(sin(gamma - epsilon - omega)*(cos(gamma -
    //   epsilon) + sin(gamma - epsilon)*tan(omega)) + cos(gamma - epsilon - omega)*(sin(gamma - epsilon) -
    //   d1_by_epsilon*cos(gamma - epsilon)/d1 - tan(omega)*(2*cos(gamma - epsilon) + d1_by_epsilon*sin(gamma
    //   - epsilon)/d1))) - cos(gamma - epsilon)^2*cos(gamma - epsilon - omega))/(zf^2*cos(omega)))/u +
    //   I6*(cos(gamma - epsilon)^2/ss - sin(gamma - epsilon)*((sin(gamma - epsilon) -
    //   d1_by_epsilon*cos(gamma - epsilon)/d1 + tan(beta + theta - gamma)*(2*cos(gamma - epsilon) +
    //   d1_by_epsilon*sin(gamma - epsilon)/d1))/ss - sin(gamma - epsilon)*tan(omega)*(3*cos(gamma - epsilon)
    //   + d1_by_epsilon*sin(gamma - epsilon)/d1)/(zf*cos(omega))))/zf^2)/cos(omega)^2 -
    //   d1_by_epsilon*(tan(beta + theta - gamma)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma -
    //   delta)*((I4*(sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/(e*ss) +
    //   m4*(ea*((ea*sin(gamma - delta)*(1/ss - cos(gamma - delta -
    //   phi_minus_90deg)/(zt*sin(phi_minus_90deg))) + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss +
    //   cos(gamma - delta - phi_minus_90deg) + (cos(phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg) +
    //   (2*cos(gamma - delta) - ea*(cos(gamma - delta)/e + cos(gamma - delta -
    //   phi_minus_90deg)/zt))/sin(phi_minus_90deg)) - 2*cos(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg))/sin(phi_minus_90deg)))/e + cos(gamma - delta -
    //   phi_minus_90deg)*(2*cos(phi_minus_90deg)*tan(beta + theta - gamma)/ss + (cos(gamma - delta -
    //   phi_minus_90deg) + 2*(sin(gamma - delta) + (cos(gamma - delta)*cos(phi_minus_90deg) - cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg))/sin(phi_minus_90deg))/zt) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta
    //   - gamma))/ss) - cos(gamma - delta)*cos(gamma - delta - phi_minus_90deg) + (cos(gamma - delta -
    //   phi_minus_90deg)*(sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)/tan(phi_minus_90deg)) + cos(gamma - delta)*(2*cos(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg) - cos(phi_minus_90deg)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))))/sin(phi_minus_90deg)) +
    //   (cos(gamma - delta - phi_minus_90deg)*((I5*(sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta
    //   - phi_minus_90deg)/tan(phi_minus_90deg)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) -
    //   cos(gamma - delta - phi_minus_90deg)/tan(phi_minus_90deg)) + tb^2*(sin(gamma - delta -
    //   phi_minus_90deg) - cos(gamma - delta - phi_minus_90deg)/tan(phi_minus_90deg))))/zt - I4*(sin(gamma -
    //   delta) + cos(gamma - delta)/tan(phi_minus_90deg))/e)/zt - I4*cos(gamma -
    //   delta)^2/(e^2*tan(phi_minus_90deg)))/sin(phi_minus_90deg))/e - m4*(cos(gamma - delta -
    //   phi_minus_90deg)*(2*cos(phi_minus_90deg)*tan(beta + theta - gamma)/ss + (cos(gamma - delta -
    //   phi_minus_90deg) + (sin(gamma - delta) + (cos(gamma - delta)*cos(phi_minus_90deg) - 2*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg))/sin(phi_minus_90deg))/zt) + (sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg) - sin(gamma - delta) - cos(gamma - delta)*tan(beta + theta -
    //   gamma))/ss)) + cos(gamma - delta - phi_minus_90deg)*(((m5*((ta^2*(sin(gamma - delta -
    //   phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma
    //   - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta - gamma)))/ss -
    //   cos(gamma - delta - phi_minus_90deg)^2*(ta^2 + tb^2)/(zt*sin(phi_minus_90deg)*tan(phi_minus_90deg)))
    //   + I5*((sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta
    //   - gamma))/ss - cos(gamma - delta -
    //   phi_minus_90deg)^2/(zt*sin(phi_minus_90deg)*tan(phi_minus_90deg))))/zt - m4*cos(gamma - delta -
    //   phi_minus_90deg)*(sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)/sin(phi_minus_90deg))/tan(phi_minus_90deg))/zt + m4*(sin(gamma - delta -
    //   phi_minus_90deg) + sin(gamma - delta)*cos(phi_minus_90deg)*(ea/e - 1) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/ss))/sin(phi_minus_90deg)^2)/d1) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)*(2*(sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 - I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 + m6*(cos(gamma - epsilon
    //   - omega)*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega)) - sin(gamma -
    //   epsilon)*(cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma -
    //   epsilon)*(2 - fa/zf) + sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 -
    //   d1_by_epsilon*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon
    //   - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d1)/d) +
    //   cos(beta - gamma)*(d1_by_epsilon*(I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
    //   theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss*d1) -
    //   cos(theta)*(2*(sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2
    //   - I6*sin(gamma - epsilon)*cos(gamma - epsilon)/zf^2 + m6*(cos(gamma - epsilon - omega)*(cos(gamma -
    //   epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma - epsilon - omega)) - sin(gamma - epsilon)*(cos(gamma -
    //   epsilon) + sin(omega)*sin(gamma - epsilon - omega) - fa*(cos(gamma - epsilon)*(2 - fa/zf) +
    //   sin(omega)*sin(gamma - epsilon - omega))/zf)))/cos(omega)^2 - d1_by_epsilon*(((I3 + m3*(sa^2 +
    //   sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (I4*cos(gamma
    //   - delta)^2/e^2 + cos(gamma - delta - phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(gamma
    //   - delta - phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) -
    //   2*cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) +
    //   2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d1))/d)/cos(beta + theta - gamma)))/cos(beta + theta
    //   - gamma) - m2*da*d1_by_epsilon*cos(beta - gamma)/(d*d1)) - c0*d1_by_epsilon*sqrt(xc^2 + xb*(xb -
    //   2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 +
    //   yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))
    //   - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*d1*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
    //   2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc)
    //   + 2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma) - mom*d1_by_epsilon/d1)/d1
    let beta_rate_dot_by_epsilon = d1_inv
        * (rr_cos_angle_inv
            * (sin_theta
                * (rr_beta_rate_sq
                    * (cos_angle_inv
                        * (rr
                            * (cos_angle_inv
                                * (d1_of_d_beta_gamma
                                    * (cos_theta
                                        * (d1_by_epsilon_d1_inv
                                            * (d1_of_place_26 + beta_rate_dot_by_beta_of_place_27)
                                            + beta_rate_dot_by_epsilon_of_place_34)
                                        + beta_rate_dot_by_beta_of_place_31 * d1_by_epsilon_d1_inv)
                                    + sin_theta
                                        * (sin_theta
                                            * (d1_by_epsilon_d1_inv
                                                * (d1_of_place_25
                                                    * (cos_gamma_minus_delta
                                                        * (m4
                                                            * (d1_of_place_15
                                                                * (zt_inv
                                                                    * (d1_of_place_15
                                                                        + sin_phi_minus_90deg_inv
                                                                            * (sin_gamma_minus_delta
                                                                                - sin_phi_minus_90deg_inv
                                                                                    * beta_rate_dot_by_beta_of_gamma_delta_2
                                                                                        .mul_add(sin_phi_minus_90deg, d1_of_place_14)))
                                                                    + beta_rate_dot_by_epsilon_of_place_4)
                                                                - beta_rate_dot_by_beta_of_place_112)
                                                            + e_inv
                                                                * (m4
                                                                    * (ea
                                                                        * (beta_rate_dot_by_beta_of_place_107
                                                                            - e_inv
                                                                                * (cos_gamma_minus_delta
                                                                                    * (d1_of_place_15 + beta_rate_dot_by_beta_of_place_104
                                                                                        - sin_phi_minus_90deg_inv
                                                                                            * (cos_phi_minus_90deg
                                                                                                * (beta_rate_dot_by_beta_of_place_78
                                                                                                    + sin_phi_minus_90deg_inv
                                                                                                        * ea
                                                                                                            .mul_add(
                                                                                                                beta_rate_dot_by_epsilon_of_place,
                                                                                                                -beta_rate_dot_by_beta_of_gamma_delta,
                                                                                                            )) + beta_rate_dot_by_epsilon_of_place_2))
                                                                                    + ea * sin_gamma_minus_delta
                                                                                        * (ss_inv - beta_rate_dot_by_epsilon_of_place_3))
                                                                            - d1_of_place_15
                                                                                * (d1_of_place_15_zt_inv
                                                                                    + beta_rate_dot_by_epsilon_of_place_4))
                                                                        + d1_of_place_15 * cos_gamma_minus_delta
                                                                        - sin_phi_minus_90deg_inv
                                                                            * (cos_gamma_minus_delta
                                                                                * (-beta_rate_dot_by_beta_of_place_109)
                                                                                    .mul_add(
                                                                                        cos_phi_minus_90deg,
                                                                                        beta_rate_dot_by_epsilon_of_place_2,
                                                                                    ) + d1_of_place_15 * beta_rate_dot_by_epsilon_of_place_5))
                                                                    - i4_e_inv * beta_rate_dot_by_beta_of_place_113
                                                                    + sin_phi_minus_90deg_inv
                                                                        * (-d1_of_place_15_zt_inv
                                                                            * (zt_inv
                                                                                * (m5 * ta_sq_plus_tb_sq)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_epsilon_of_place_5,
                                                                                        I5 * beta_rate_dot_by_epsilon_of_place_5,
                                                                                    )
                                                                                - i4_e_inv
                                                                                    * (sin_gamma_minus_delta
                                                                                        + beta_rate_dot_by_beta_of_place_110))
                                                                            + i4_d1_of_place_22 * beta_rate_dot_by_epsilon_of_place_6)))
                                                        - d1_of_place_15
                                                            * (m4 * ss_inv
                                                                * (beta_rate_dot_by_beta_of_place_91
                                                                    + d1_by_gamma_of_place_6)
                                                                + zt_inv
                                                                    * (zt_inv
                                                                        * (m5
                                                                            * (-ta_sq_plus_tb_sq)
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_epsilon_of_place_7,
                                                                                    ss_inv * beta_rate_dot_by_beta_of_place_92,
                                                                                )
                                                                            + I5
                                                                                * ss_inv
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_91,
                                                                                        -beta_rate_dot_by_epsilon_of_place_7,
                                                                                    ))
                                                                        - m4_d1_of_place_15 * beta_rate_dot_by_beta_of_place_77
                                                                            * (beta_rate_dot_by_beta_of_place_83
                                                                                + beta_rate_dot_by_beta_of_place_86))))
                                                    - ss_inv_d1_of_place_2
                                                        * beta_rate_dot_by_epsilon_of_place_8)
                                                + cos_omega_inv_sq
                                                    * (m6
                                                        * (sin_gamma_minus_epsilon
                                                            * (zf_inv
                                                                * (d1_of_place_3 * beta_rate_dot_by_beta_of_place_63
                                                                    + beta_rate_dot_by_epsilon_of_place_12
                                                                        * sin_gamma_minus_epsilon
                                                                    + fa
                                                                        * (ss_inv
                                                                            * (-d1_of_place_6
                                                                                + d1_by_gamma_of_place_2 * d1_by_epsilon_d1_inv
                                                                                - sin_angle_cos_angle_inv
                                                                                    * (d1_of_zf_fa
                                                                                        .mul_add(
                                                                                            beta_rate_dot_by_beta_of_place_63,
                                                                                            beta_rate_dot_by_gamma_of_place_2,
                                                                                        ) + d1_of_place_6 * d1_by_epsilon_d1_inv))
                                                                            - d1_of_place_10 * beta_rate_dot_by_beta_of_place_39
                                                                            + d1_of_place_3
                                                                                * (-zf_inv)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_epsilon_of_place_16,
                                                                                        u_2_inv * beta_rate_dot_by_epsilon_of_place_15,
                                                                                    )
                                                                            + cos_omega_inv
                                                                                * (zf_inv
                                                                                    * (sin_gamma_minus_epsilon
                                                                                        * (sin_omega
                                                                                            * (beta_rate_dot_by_epsilon_of_place_14
                                                                                                - cos_omega_inv
                                                                                                    * (S::int(6) * cos_gamma_minus_epsilon
                                                                                                        + beta_rate_dot_by_beta_of_place_8 * d1_by_epsilon_d1_inv
                                                                                                        + fa
                                                                                                            * (-zf_inv)
                                                                                                                .mul_add(
                                                                                                                    beta_rate_dot_by_epsilon_of_place_10,
                                                                                                                    u_2_inv * beta_rate_dot_by_epsilon_of_place_12,
                                                                                                                ))) + fa * d1_of_place_3_u_2_inv
                                                                                            + beta_rate_dot_by_epsilon_of_place_12
                                                                                                * cos_omega_inv_doubled)
                                                                                        + cos_gamma_minus_epsilon
                                                                                            * (-beta_rate_dot_by_gamma_of_place_2
                                                                                                + S::int(4) * d1_of_place_3 * cos_omega_inv
                                                                                                - fa * u_2_inv
                                                                                                    * (beta_rate_dot_by_beta_of_place_39
                                                                                                        + d1_of_place_3
                                                                                                            * (d1_by_epsilon_d1_inv
                                                                                                                + beta_rate_dot_by_epsilon_of_omega))))
                                                                                    + u_2_inv
                                                                                        * (d1_of_place_3
                                                                                            * (sin_omega_d1_of_place_3
                                                                                                - beta_rate_dot_by_beta_of_place_8
                                                                                                + beta_rate_dot_by_beta_of_place_63 * d1_by_epsilon_d1_inv
                                                                                                + cos_omega_inv_doubled
                                                                                                    * (beta_rate_dot_by_epsilon_of_place_17
                                                                                                        - beta_rate_dot_by_epsilon_of_place_15))
                                                                                            + beta_rate_dot_by_gamma_of_place_48
                                                                                                * beta_rate_dot_by_epsilon_of_place_18)))
                                                                    + cos_omega_inv
                                                                        * (d1_of_place_3
                                                                            * (-cos_omega_inv_doubled)
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_epsilon_of_place_16,
                                                                                    beta_rate_dot_by_epsilon_of_place_14,
                                                                                )
                                                                            - beta_rate_dot_by_beta_of_place_39
                                                                                * cos_omega_inv
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_beta_of_place_8,
                                                                                        beta_rate_dot_by_beta_of_place_39,
                                                                                    )
                                                                            + sin_omega
                                                                                * (beta_rate_dot_by_beta_of_place_39
                                                                                    * beta_rate_dot_by_beta_of_place_63
                                                                                    - beta_rate_dot_by_epsilon_of_place_14
                                                                                        * sin_gamma_minus_epsilon
                                                                                    + cos_omega_inv
                                                                                        * beta_rate_dot_by_epsilon_of_place_10
                                                                                            .mul_add(
                                                                                                sin_gamma_minus_epsilon,
                                                                                                beta_rate_dot_by_epsilon_of_place_19,
                                                                                            ))))
                                                                - u_2_inv
                                                                    * (beta_rate_dot_by_epsilon_of_place_19
                                                                        + cos_omega_inv
                                                                            * (d1_of_place_3
                                                                                * (sin_omega_d1_of_place_3
                                                                                    + cos_omega_inv
                                                                                        * (-beta_rate_dot_by_epsilon_of_place_15)
                                                                                            .mul_add(S::int(2), beta_rate_dot_by_epsilon_of_place_17)
                                                                                    - beta_rate_dot_by_epsilon_of_place_20)
                                                                                + beta_rate_dot_by_epsilon_of_place_21))
                                                                - ss_inv
                                                                    * (sin_omega
                                                                        * ((-d1_of_place_3)
                                                                            .mul_add(S::int(2), beta_rate_dot_by_epsilon_of_place_13)
                                                                            - beta_rate_dot_by_beta_of_place_55
                                                                                * beta_rate_dot_by_epsilon_of_place_12)
                                                                        + beta_rate_dot_by_epsilon_of_place_22))
                                                            - d1_of_place_3
                                                                * (cos_gamma_minus_epsilon
                                                                    * (u_2_inv
                                                                        * (cos_omega_inv
                                                                            * (cos_gamma_minus_epsilon
                                                                                - beta_rate_dot_by_epsilon_of_place_23
                                                                                + fa_zf_inv
                                                                                    * (d1_by_gamma_of_place
                                                                                        + beta_rate_dot_by_epsilon_of_place_23))
                                                                            - d1_of_place_3 * beta_rate_dot_by_beta_of_zf_fa)
                                                                        + sin_omega
                                                                            * (ss_inv
                                                                                * (-fa_zf_inv)
                                                                                    .mul_add(
                                                                                        beta_rate_dot_by_epsilon_of_place_24,
                                                                                        beta_rate_dot_by_epsilon_of_place_24,
                                                                                    ) - d1_of_place_3 * zf_inv * cos_omega_inv_sq)
                                                                        + beta_rate_dot_by_beta_of_place_39 * zf_inv_cos_omega_inv)
                                                                    + beta_rate_dot_by_epsilon_of_place_26
                                                                    + beta_rate_dot_by_beta_of_omega
                                                                        * beta_rate_dot_by_epsilon_of_place_28)
                                                            + ss_inv
                                                                * beta_rate_dot_by_gamma_of_place_47
                                                                    .mul_add(
                                                                        cos_gamma_minus_epsilon,
                                                                        beta_rate_dot_by_epsilon_of_place_29,
                                                                    ))
                                                        + u_2_inv
                                                            * (u_2_inv
                                                                * (d1_of_place_3
                                                                    * (m7
                                                                        * (cos_omega_inv
                                                                            * (zf_inv
                                                                                * (-(ua_sq_plus_ub_sq
                                                                                    * beta_rate_dot_by_epsilon_of_place_31))
                                                                                    .mul_add(
                                                                                        cos_gamma_minus_epsilon,
                                                                                        ua_sq_plus_ub_sq * beta_rate_dot_by_epsilon_of_place_30
                                                                                            * sin_gamma_minus_epsilon,
                                                                                    )
                                                                                - d1_of_place_3_u_2_inv * ua_sq_plus_ub_sq
                                                                                    * sin_omega_cos_omega_inv
                                                                                    * beta_rate_dot_by_epsilon_of_place_27)
                                                                            - ss_inv * ua_sq_plus_ub_sq
                                                                                * beta_rate_dot_by_epsilon_of_place_25)
                                                                        - I7
                                                                            * (beta_rate_dot_by_epsilon_of_place_26
                                                                                + cos_omega_inv
                                                                                    * (-zf_inv
                                                                                        * (-beta_rate_dot_by_epsilon_of_place_31)
                                                                                            .mul_add(
                                                                                                cos_gamma_minus_epsilon,
                                                                                                beta_rate_dot_by_epsilon_of_place_30
                                                                                                    * sin_gamma_minus_epsilon,
                                                                                            )
                                                                                        + sin_omega_cos_omega_inv
                                                                                            * beta_rate_dot_by_epsilon_of_place_28)))
                                                                    + beta_rate_dot_by_epsilon_of_place_29
                                                                        * (m7 * ua_sq_plus_ub_sq)
                                                                            .mul_add(
                                                                                beta_rate_dot_by_epsilon_of_place_32,
                                                                                I7 * beta_rate_dot_by_epsilon_of_place_32,
                                                                            ))
                                                                - cos_omega_inv * zf_inv_i6_zf_inv
                                                                    * (sin_gamma_minus_epsilon
                                                                        * (d1_of_place_3
                                                                            * sin_omega_cos_omega_inv
                                                                                .mul_add(
                                                                                    beta_rate_dot_by_epsilon_of_place_16,
                                                                                    -beta_rate_dot_by_epsilon_of_place_20,
                                                                                ) + beta_rate_dot_by_epsilon_of_place_21)
                                                                        + d1_of_place_3 * beta_rate_dot_by_epsilon_of_place_33))
                                                        + zf_inv_i6_zf_inv
                                                            * (-sin_gamma_minus_epsilon
                                                                * (-beta_rate_dot_by_beta_of_place_69)
                                                                    .mul_add(
                                                                        beta_rate_dot_by_epsilon_of_place_10,
                                                                        ss_inv * beta_rate_dot_by_epsilon_of_place_22,
                                                                    ) + ss_inv * beta_rate_dot_by_epsilon_of_place_33)))
                                            + beta_rate_dot_by_beta_of_place_122
                                                * beta_rate_dot_by_epsilon_of_place_35))
                                + beta_rate_dot_by_beta_of_place_129 * d1_by_epsilon_d1_inv)
                            - beta_rate_dot_by_epsilon_of_place_35 * cos_theta)
                        - d1_of_d_beta_gamma_m2_da * d1_by_epsilon_d1_inv)
                    - beta_rate_dot_by_beta_of_place_147 * beta_rate_dot_by_beta_of_place_151
                        * beta_rate_dot_by_gamma_of_place_53 * d1_by_epsilon_d1_inv)
                - beta_rate_dot_by_beta_of_beta_rate_4 * d1_by_epsilon_d1_inv)
            - mom * d1_by_epsilon_d1_inv);
    // d1_by_omega = 2*rr^2*sin(theta)^2*(m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(fa/zf - 1)
    //   + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2) +
    //   sin(omega)*(m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*(fa/zf - 1) + (I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma -
    //   epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
    //   omega))/zf)))/cos(omega)))/cos(omega))/(cos(beta + theta - gamma)^2*cos(omega))
    let d1_by_omega = d1_by_delta_of_place_sq * cos_omega_inv_doubled
        * (cos_omega_inv
            * (sin_omega
                * (-beta_rate_dot_by_beta_of_place_49)
                    .mul_add(
                        beta_rate_dot_by_gamma_of_place_7,
                        d1_of_place_13 * cos_omega_inv,
                    )
                - d1_of_place_3 * beta_rate_dot_by_beta_of_place_39
                    * (m6 + beta_rate_dot_by_beta_of_place_44))
            + m6_d1_of_place_3 * beta_rate_dot_by_beta_of_place_49);
    let beta_rate_dot_by_omega_of_omega = sin_omega_cos_omega_inv * sin_omega_cos_omega_inv;
    // 1 + beta_rate_dot_by_omega_of_omega
    let beta_rate_dot_by_omega_of_omega_2 = S::int(1) + beta_rate_dot_by_omega_of_omega;
    // d1_of_place_3*cos(omega) - beta_rate_dot_by_beta_of_place_60
    let beta_rate_dot_by_omega_of_place = d1_of_place_3
        .mul_add(cos_omega, -beta_rate_dot_by_beta_of_place_60);
    // -beta_rate_dot_by_omega_of_place
    let beta_rate_dot_by_omega_of_place_2 = -beta_rate_dot_by_omega_of_place;
    // d1_of_place_3 + beta_rate_dot_by_gamma_of_place_5
    let beta_rate_dot_by_omega_of_place_3 = d1_of_place_3 + beta_rate_dot_by_gamma_of_place_5;
    // ss_inv*(sin_omega_d1_of_place_3 + beta_rate_dot_by_beta_of_place_39*cos(omega))
    let beta_rate_dot_by_omega_of_place_4 = ss_inv
        * beta_rate_dot_by_beta_of_place_39.mul_add(cos_omega, sin_omega_d1_of_place_3);
    // d1_of_place_3 - d1_of_place_5*beta_rate_dot_by_beta_of_omega
    let beta_rate_dot_by_omega_of_place_5 = (-d1_of_place_5)
        .mul_add(beta_rate_dot_by_beta_of_omega, d1_of_place_3);
    // d1_of_place_3 + beta_rate_dot_by_beta_of_omega*sin(gamma - epsilon)
    let beta_rate_dot_by_omega_of_place_6 = beta_rate_dot_by_beta_of_omega
        .mul_add(sin_gamma_minus_epsilon, d1_of_place_3);
    // d1_by_gamma_of_place_3 + m6*(sin(gamma - epsilon)*(beta_rate_dot_by_omega_of_place +
    //   fa_zf_inv*beta_rate_dot_by_omega_of_place_2) -
    //   sin_omega_d1_of_place_3*beta_rate_dot_by_omega_of_place)
    let beta_rate_dot_by_omega_of_place_7 = d1_by_gamma_of_place_3
        + m6
            * (sin_gamma_minus_epsilon
                * fa_zf_inv
                    .mul_add(
                        beta_rate_dot_by_omega_of_place_2, beta_rate_dot_by_omega_of_place,
                    ) - sin_omega_d1_of_place_3 * beta_rate_dot_by_omega_of_place);
    // beta_rate_dot_by_beta_of_place_72 + cos_omega_inv_sq*(beta_rate_dot_by_omega_of_place_7 -
    //   beta_rate_dot_by_beta_of_place_19*sin_omega_cos_omega_inv)
    let beta_rate_dot_by_omega_of_place_8 = beta_rate_dot_by_beta_of_place_72
        + cos_omega_inv_sq
            * (-beta_rate_dot_by_beta_of_place_19)
                .mul_add(sin_omega_cos_omega_inv, beta_rate_dot_by_omega_of_place_7);
    let beta_rate_dot_by_omega_of_place_9 = cos_theta_doubled * beta_rate_dot_by_omega_of_place_8;
    // beta_rate_dot_by_omega = rr^2*beta_rate^2*sin(theta)*(2*cos(theta)*(m6*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + tan(omega)*(I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma -
    //   epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 +
    //   sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)*cos(omega)*cos(gamma - epsilon - omega)^2 + sin(omega)^2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa*(sin(omega)*sin(gamma - epsilon -
    //   omega) + cos(omega)*cos(gamma - epsilon - omega))/zf - sin(omega)*sin(gamma - epsilon - omega) -
    //   cos(omega)*cos(gamma - epsilon - omega))))/cos(omega)^2) - rr*(2*cos(theta)*cos(beta -
    //   gamma)*(m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + tan(omega)*(I6*sin(gamma -
    //   epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
    //   2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)*cos(omega)*cos(gamma - epsilon - omega)^2 + sin(omega)^2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa*(sin(omega)*sin(gamma - epsilon -
    //   omega) + cos(omega)*cos(gamma - epsilon - omega))/zf - sin(omega)*sin(gamma - epsilon - omega) -
    //   cos(omega)*cos(gamma - epsilon - omega))))/cos(omega)^2)/d +
    //   sin(theta)*(sin(theta)*(tan(omega)*(m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)*cos(gamma -
    //   epsilon - omega)/zf + (cos(gamma - epsilon - omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon -
    //   omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) +
    //   tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) +
    //   tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
    //   sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) - m6*cos(gamma -
    //   epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) -
    //   (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) +
    //   ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + (m6*cos(gamma - epsilon -
    //   omega)^2 - m6*sin(gamma - epsilon - omega)^2 + 2*m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon
    //   - omega)*tan(gamma - beta - theta))/ss + (m6*sin(gamma - epsilon)*sin(gamma - epsilon - omega)^2/zf
    //   - m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)^2/zf + tan(omega)*(cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega) +
    //   (sin(gamma - epsilon - omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2
    //   + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon -
    //   omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf
    //   - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma -
    //   epsilon - omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) +
    //   cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega)
    //   - m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon
    //   - omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + cos(gamma - epsilon -
    //   omega)*(m6*(cos(omega)*((fa*cos(gamma - epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta -
    //   theta)/ss + cos(gamma - epsilon - omega) + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma -
    //   epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega)
    //   + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)))/ss) + sin(omega)*(sin(gamma -
    //   epsilon)*(2*sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega) + tan(omega)^2*(sin(gamma - epsilon - omega) +
    //   (2*sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega))/cos(omega)) +
    //   tan(omega)*(tan(omega)*(2*sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega))/cos(omega) - cos(gamma - epsilon - omega) + (sin(omega)*sin(gamma - epsilon - omega) +
    //   cos(omega)*cos(gamma - epsilon - omega))/cos(omega)))/zf + (sin(omega)*(sin(gamma - epsilon -
    //   omega)*tan(gamma - beta - theta) + cos(gamma - epsilon - omega)) - cos(omega)*(sin(gamma - epsilon -
    //   omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)))/ss)) - (m6*sin(gamma - epsilon -
    //   omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) +
    //   tan(omega)*(sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)) - sin(gamma -
    //   epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf +
    //   m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u -
    //   2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma -
    //   epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))))/cos(omega) - (I7*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon - omega)) + m7*(ua^2*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon - omega)) + ub^2*(sin(gamma - epsilon - omega)*tan(gamma - beta - theta) + cos(gamma -
    //   epsilon - omega))))/(ss*u) + m6*cos(gamma - epsilon - omega)*(sin(omega)*sin(gamma - epsilon -
    //   omega) + cos(omega)*cos(gamma - epsilon - omega)) + (sin(omega)*sin(gamma - epsilon -
    //   omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)) + cos(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma -
    //   epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*sin(omega)^2)/cos(omega)) - sin(gamma - epsilon)*((cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) - cos(gamma -
    //   epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + tan(omega)^2*(cos(gamma - epsilon - omega)*((I7 +
    //   m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))) +
    //   tan(omega)*(sin(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) -
    //   2*m6*fa*cos(omega)*cos(gamma - epsilon - omega)))/zf + m6*(2*sin(omega)*cos(gamma - epsilon - omega)
    //   - sin(gamma - epsilon) - tan(omega)^2*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)) + 2*tan(omega)*(sin(omega)*sin(gamma - epsilon - omega) + cos(omega)*cos(gamma - epsilon -
    //   omega)))) + sin(omega)*cos(gamma - epsilon - omega)*(2*m6*sin(omega)*cos(gamma - epsilon - omega) +
    //   sin(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega) + cos(gamma
    //   - epsilon - omega)*tan(omega)*((I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*sin(omega)^2)/cos(omega)))/cos(omega))/u) + sin(gamma - epsilon)*(I6*(sin(gamma -
    //   epsilon)^2/(zf*cos(omega)) + 2*sin(gamma - epsilon)^2*tan(omega)^2/(zf*cos(omega)))/zf^2 -
    //   m6*((sin(omega)*cos(gamma - epsilon - omega) - sin(gamma - epsilon - omega)*cos(omega))/ss -
    //   (sin(gamma - epsilon)*(sin(gamma - epsilon)/cos(omega) - sin(gamma - epsilon - omega)) + sin(gamma -
    //   epsilon)*tan(omega)^2*(sin(gamma - epsilon)/cos(omega) - sin(gamma - epsilon - omega)) +
    //   fa*(sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf -
    //   2)/cos(omega))/zf + sin(gamma - epsilon)*tan(omega)^2*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf + (sin(omega)*cos(gamma - epsilon - omega) - sin(gamma - epsilon
    //   - omega)*cos(omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon)*tan(omega)*(2 -
    //   fa/zf)/cos(omega) + cos(gamma - epsilon - omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma -
    //   epsilon)*tan(omega)/cos(omega) + cos(gamma - epsilon - omega)))/zf)))/cos(omega))/cos(omega)) +
    //   2*cos(beta - gamma)*tan(beta + theta - gamma)*(m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + tan(omega)*(I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2
    //   + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
    //   epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) +
    //   2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + (sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u^2 +
    //   m6*(sin(omega)*cos(omega)*cos(gamma - epsilon - omega)^2 + sin(omega)^2*sin(gamma - epsilon -
    //   omega)*cos(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa*(sin(omega)*sin(gamma - epsilon -
    //   omega) + cos(omega)*cos(gamma - epsilon - omega))/zf - sin(omega)*sin(gamma - epsilon - omega) -
    //   cos(omega)*cos(gamma - epsilon - omega))))/cos(omega)^2)/d))/cos(beta + theta - gamma))/(d1*cos(beta
    //   + theta - gamma)^2) - d1_by_omega*(mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta -
    //   gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
    //   m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) +
    //   rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta +
    //   theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc)
    //   + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
    //   2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
    //   xc) + sb*(sin(gamma)^2 - 1 + cos(gamma)^2)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) +
    //   sa*(sin(gamma)^2 - 1 + cos(gamma)^2))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc
    //   + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
    //   2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb) + sa*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2)) - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc) + sb*(sin(gamma)^2 - 1 +
    //   cos(gamma)^2))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb -
    //   xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) +
    //   rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma
    //   - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 +
    //   m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma)))/cos(beta +
    //   theta - gamma))))/cos(beta + theta - gamma))/d1^2
    let beta_rate_dot_by_omega = -beta_rate_dot_by_delta_of_beta_rate_4
        * (beta_rate_dot_by_omega_of_place_9
            + rr_cos_angle_inv
                * (sin_theta
                    * (sin_theta
                        * (ss_inv
                            * beta_rate_dot_by_beta_of_place_55
                                .mul_add(
                                    beta_rate_dot_by_beta_of_place_72,
                                    beta_rate_dot_by_gamma_of_place_18,
                                )
                            - beta_rate_dot_by_beta_of_omega * beta_rate_dot_by_beta_of_place_73
                            + cos_omega_inv
                                * (cos_omega_inv
                                    * (beta_rate_dot_by_gamma_of_place_16
                                        + d1_of_place_3
                                            * (u_2_inv
                                                * (beta_rate_dot_by_gamma_of_place_8
                                                    - beta_rate_dot_by_beta_of_place_48
                                                        * beta_rate_dot_by_beta_of_omega
                                                    + m6_d1_of_place_3 * beta_rate_dot_by_omega_of_place_2
                                                    - cos_omega_inv
                                                        * (sin_omega_d1_of_place_3
                                                            * (m6
                                                                .mul_add(d1_of_place_4, -beta_rate_dot_by_gamma_of_place_4)
                                                                + d1_of_place_3 * beta_rate_dot_by_beta_of_place_45
                                                                    * beta_rate_dot_by_beta_of_omega)
                                                            + beta_rate_dot_by_beta_of_place_47
                                                                * beta_rate_dot_by_omega_of_place
                                                            + sin_gamma_minus_epsilon
                                                                * (zf_inv
                                                                    * (d1_of_place_11
                                                                        + sin_omega_cos_omega_inv
                                                                            * (m6_d1_of_place_3 * fa_doubled)
                                                                                .mul_add(cos_omega, beta_rate_dot_by_gamma_of_place)
                                                                        + beta_rate_dot_by_beta_of_place_38
                                                                            * beta_rate_dot_by_omega_of_omega_2)
                                                                    + m6
                                                                        * beta_rate_dot_by_epsilon_of_omega
                                                                            .mul_add(
                                                                                beta_rate_dot_by_omega_of_place_2,
                                                                                d1_of_place_7 * beta_rate_dot_by_omega_of_omega_2,
                                                                            )))
                                                    + ss_inv_u_2_inv
                                                        * (m7 * ua_sq_plus_ub_sq)
                                                            .mul_add(
                                                                beta_rate_dot_by_omega_of_place_3,
                                                                I7 * beta_rate_dot_by_omega_of_place_3,
                                                            ))
                                                + m6
                                                    * (sin_omega
                                                        * (d1_of_place_10
                                                            * (beta_rate_dot_by_beta_of_place_53
                                                                - beta_rate_dot_by_gamma_of_place_48
                                                                - beta_rate_dot_by_beta_of_place_54
                                                                    * beta_rate_dot_by_omega_of_omega
                                                                + sin_omega_cos_omega_inv
                                                                    * (beta_rate_dot_by_beta_of_place_52
                                                                        .mul_add(beta_rate_dot_by_beta_of_omega, -d1_of_place_3)
                                                                        - cos_omega_inv * beta_rate_dot_by_omega_of_place_2))
                                                            + ss_inv
                                                                * beta_rate_dot_by_omega_of_place_3
                                                                    .mul_add(
                                                                        sin_omega,
                                                                        beta_rate_dot_by_beta_of_place_51 * cos_omega,
                                                                    )) + beta_rate_dot_by_beta_of_place_58 * cos_omega))
                                        + sin_gamma_minus_epsilon
                                            * (zf_inv_i6_zf_inv
                                                * (beta_rate_dot_by_beta_of_place_8
                                                    * beta_rate_dot_by_beta_of_place_65)
                                                    .mul_add(
                                                        beta_rate_dot_by_beta_of_omega,
                                                        d1_of_place_10 * beta_rate_dot_by_beta_of_place_66,
                                                    )
                                                - m6
                                                    * (beta_rate_dot_by_omega_of_place_4
                                                        - zf_inv
                                                            * (fa
                                                                * (beta_rate_dot_by_omega_of_place_4
                                                                    - d1_of_place_10 * beta_rate_dot_by_beta_of_place_64
                                                                    - beta_rate_dot_by_beta_of_place_65
                                                                        * (beta_rate_dot_by_gamma_of_place_14
                                                                            + beta_rate_dot_by_omega_of_place_5))
                                                                + beta_rate_dot_by_beta_of_place_67
                                                                    * sin_gamma_minus_epsilon
                                                                + beta_rate_dot_by_beta_of_place_68
                                                                    * (beta_rate_dot_by_gamma_of_place_15
                                                                        + beta_rate_dot_by_omega_of_place_6)))))
                                    - beta_rate_dot_by_beta_of_omega
                                        * beta_rate_dot_by_beta_of_place_71
                                    - beta_rate_dot_by_gamma_of_place_19))
                        - beta_rate_dot_by_beta_of_place_133 * beta_rate_dot_by_omega_of_place_8)
                    - d1_of_d_beta_gamma * beta_rate_dot_by_omega_of_place_9))
        - d1_by_omega * beta_rate_dot_by_beta_of_beta_rate_7;
    // beta_rate_dot_by_beta_rate = 2*rr^2*beta_rate*(m2*da*(sin(theta)*cos(beta - gamma) -
    //   cos(theta)*sin(beta - gamma))/d + (cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta -
    //   gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta -
    //   gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
    //   theta)/(d*cos(beta + theta - gamma)))))/d^2 + sin(theta)*(cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2) - rr*(m2*da*(cos(beta - gamma)^2/d -
    //   cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 +
    //   m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 +
    //   cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon -
    //   omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
    //   fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2
    //   + m4*cos(gamma - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2)/d + sin(theta)*((m6*sin(gamma -
    //   epsilon)*sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega)/zf + (cos(gamma - epsilon -
    //   omega)*(((sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma
    //   - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 +
    //   ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf -
    //   m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
    //   omega)))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma
    //   - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u^2 + m6*sin(omega)^2)/cos(omega)))/cos(omega) -
    //   m6*cos(gamma - epsilon - omega)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
    //   omega)) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma))))/(ss*u))/u + m6*(sin(gamma - epsilon)^2*(fa/zf - 1)/zf + sin(omega)*((fa*cos(gamma -
    //   epsilon)/ss + sin(gamma - epsilon)*(2*fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega)
    //   + tan(omega)*(sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) +
    //   sin(omega)*cos(gamma - epsilon - omega))/cos(omega))))/zf - (2*sin(gamma - epsilon)*tan(gamma - beta
    //   - theta) + cos(gamma - epsilon) + sin(omega)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(beta + theta - gamma)))/ss))) + sin(gamma - epsilon)*(m6*((sin(gamma - epsilon)*tan(gamma
    //   - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss -
    //   (fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
    //   epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon -
    //   omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma -
    //   epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega)
    //   - sin(gamma - epsilon)/cos(omega)))/zf) + I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/ss + sin(gamma -
    //   epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2))/cos(omega))/cos(omega) + ((cos(gamma - delta -
    //   phi_minus_90deg)*((m4*cos(gamma - delta - phi_minus_90deg)*(cos(gamma - delta)*(ea/e - 1) +
    //   cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)) + (cos(gamma - delta)*((sin(gamma -
    //   delta)*(I4/e + m4*ea*(ea/e - 2)) - sin(gamma - delta - phi_minus_90deg)*(I5 + m5*(ta^2 + tb^2))/zt +
    //   (cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) + cos(gamma - delta - phi_minus_90deg)*((I5 + m5*(ta^2
    //   + tb^2))/zt + 2*m4*ea*cos(phi_minus_90deg)))/tan(phi_minus_90deg))/e + m4*(sin(gamma - delta) +
    //   (cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg))) + cos(phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)*(m4*sin(gamma - delta)*(ea/e - 1) + cos(gamma - delta - phi_minus_90deg)*((I5 +
    //   m5*(ta^2 + tb^2))/zt^2 + m4*cos(phi_minus_90deg)^2)/sin(phi_minus_90deg)))/sin(phi_minus_90deg) -
    //   (I5*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)) + m5*(ta^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma)) + tb^2*(sin(gamma - delta - phi_minus_90deg) + cos(gamma
    //   - delta - phi_minus_90deg)*tan(beta + theta - gamma))))/(ss*zt))/zt + m4*(cos(gamma - delta)^2*(ea/e
    //   - 1)/e + cos(phi_minus_90deg)*((cos(gamma - delta)*(2*ea*tan(gamma - beta - theta)/ss + cos(gamma -
    //   delta - phi_minus_90deg) + ((2*cos(gamma - delta)*(ea/e - 1) + cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/sin(phi_minus_90deg) - sin(gamma - delta -
    //   phi_minus_90deg))/tan(phi_minus_90deg)) - ea*sin(gamma - delta)/ss)/e + (sin(gamma - delta) -
    //   sin(gamma - delta - phi_minus_90deg)*cos(phi_minus_90deg) + tan(beta + theta - gamma)*(2*cos(gamma -
    //   delta) - cos(phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg)))/ss))) - cos(gamma -
    //   delta)*(m4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (cos(gamma - delta)*(cos(gamma -
    //   delta)/sin(phi_minus_90deg) + sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg) +
    //   ea*((2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(gamma - delta -
    //   phi_minus_90deg)*cos(phi_minus_90deg))/ss - (ea*sin(gamma - delta)/ss + cos(gamma -
    //   delta)*(ea*tan(beta + theta - gamma)/ss + (cos(gamma - delta)*(2 - ea/e)/sin(phi_minus_90deg) +
    //   sin(gamma - delta - phi_minus_90deg))/tan(phi_minus_90deg)))/e))/e) + I4*((sin(gamma - delta) +
    //   cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma -
    //   delta)^2/(e*sin(phi_minus_90deg)*tan(phi_minus_90deg)))/e^2))/sin(phi_minus_90deg) - m4*cos(gamma -
    //   delta)*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta -
    //   phi_minus_90deg)/e)/sin(phi_minus_90deg) - (m6*sin(gamma - epsilon - omega)*cos(gamma - epsilon -
    //   omega) + m4*sin(gamma - delta - phi_minus_90deg)*cos(gamma - delta - phi_minus_90deg) + tan(beta +
    //   theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + m6*cos(gamma - epsilon - omega)^2 + m4*cos(gamma -
    //   delta - phi_minus_90deg)^2))/ss)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
    //   gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta
    //   - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss +
    //   m6*cos(gamma - epsilon - omega)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
    //   omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(sin(omega)^2*cos(gamma - epsilon - omega)^2 + sin(gamma -
    //   epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma -
    //   epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2 + m4*cos(gamma
    //   - delta - phi_minus_90deg)^2 + (I4*cos(gamma - delta)^2/e^2 + cos(gamma - delta -
    //   phi_minus_90deg)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(cos(phi_minus_90deg)^2*cos(gamma - delta -
    //   phi_minus_90deg)^2 + cos(gamma - delta)*(cos(gamma - delta) - 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg) + ea*(cos(gamma - delta)*(ea/e - 2) + 2*cos(phi_minus_90deg)*cos(gamma -
    //   delta - phi_minus_90deg))/e)))/sin(phi_minus_90deg)^2))/d)/cos(beta + theta - gamma))))/cos(beta +
    //   theta - gamma))/(d1*cos(beta + theta - gamma))
    let beta_rate_dot_by_beta_rate = -rr_doubled * beta_rate_dot_by_delta_of_beta_rate_3
        * (cos_angle_inv
            * (-(d_inv * d1_of_d_beta_gamma))
                .mul_add(
                    beta_rate_dot_by_beta_of_place_141,
                    beta_rate_dot_by_beta_of_place_130 * sin_theta,
                )
            + d_inv_m2_da
                * (beta_rate_dot_by_beta_of_place_128 - beta_rate_dot_by_theta_of_place));
    let theta_dot_by_beta_value_of_beta_rate = d_inv * beta_rate_dot_by_beta_of_place_29
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let gamma_dot_by_beta_value_of_beta_rate = beta_rate_dot_by_delta_of_beta_rate
        * beta_rate_dot_by_epsilon_of_place_8;
    let gamma_dot_by_theta_value_of_beta_rate = d1_by_theta_of_place
        * beta_rate_dot_by_delta_of_beta_rate_2;
    let delta_dot_by_beta_value_of_beta_rate = sin_phi_minus_90deg_inv
        * beta_rate_dot_by_delta_of_beta_rate;
    let delta_dot_by_gamma_value_of_beta_rate = zt_inv * delta_dot_by_beta_value_of_beta_rate;
    // e_inv*(zt*cos(gamma - delta) + e*d1_of_place_15)
    let phi_dot_by_beta_value_of_place = e_inv
        * e.mul_add(d1_of_place_15, zt * cos_gamma_minus_delta);
    let epsilon_dot_by_beta_value_of_beta_rate = cos_omega_inv
        * beta_rate_dot_by_delta_of_beta_rate;
    let epsilon_dot_by_theta_value_of_place = d1_of_place_3_u_2_inv * cos_omega_inv;
    let epsilon_dot_by_gamma_value_of_beta_rate = u_2_inv * epsilon_dot_by_beta_value_of_beta_rate;
    // u*sin(gamma - epsilon) - zf*d1_of_place_3
    let omega_dot_by_beta_value_of_place = (-zf)
        .mul_add(d1_of_place_3, u_2 * sin_gamma_minus_epsilon);
    let omega_dot_by_beta_value_of_beta_rate = zf_inv * epsilon_dot_by_gamma_value_of_beta_rate;
    // Entries that are not zero.
    // d(beta')/d(beta_rate) = 1
    let beta_dot_by_beta_rate_value = S::int(1);
    // d(theta')/d(beta) = -rr*beta_rate*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
    //   theta))/(d*cos(beta + theta - gamma))
    let theta_dot_by_beta_value = -theta_dot_by_beta_value_of_beta_rate;
    // d(theta')/d(theta) = rr*beta_rate*cos(beta - gamma)*tan(beta + theta - gamma)/(d*cos(beta + theta -
    //   gamma))
    let theta_dot_by_theta_value = beta_rate_dot_by_beta_of_place_122
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
    // d(delta')/d(beta) = rr*beta_rate*sin(theta)*cos(gamma - delta - phi_minus_90deg)*tan(beta + theta -
    //   gamma)/(zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let delta_dot_by_beta_value = d1_of_place_15_zt_inv * sin_angle_cos_angle_inv
        * delta_dot_by_beta_value_of_beta_rate;
    // d(delta')/d(theta) = rr*beta_rate*cos(gamma - delta - phi_minus_90deg)*(cos(theta) +
    //   sin(theta)*tan(beta + theta - gamma))/(zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let delta_dot_by_theta_value = beta_rate_dot_by_epsilon_of_place_3
        * gamma_dot_by_theta_value_of_beta_rate;
    // d(delta')/d(gamma) = -rr*beta_rate*sin(theta)*(sin(gamma - delta - phi_minus_90deg) + cos(gamma -
    //   delta - phi_minus_90deg)*tan(beta + theta - gamma))/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_by_gamma_value = -beta_rate_dot_by_beta_of_place_91
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(delta) = rr*beta_rate*sin(theta)*sin(gamma - delta - phi_minus_90deg)/(zt*cos(beta +
    //   theta - gamma)*sin(phi_minus_90deg))
    let delta_dot_by_delta_value = beta_rate_dot_by_beta_of_place_79
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(phi_minus_90deg) = rr*beta_rate*sin(theta)*(sin(gamma - delta - phi_minus_90deg) -
    //   cos(gamma - delta - phi_minus_90deg)/tan(phi_minus_90deg))/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_by_phi_minus_90deg_value = beta_rate_dot_by_epsilon_of_place_5
        * delta_dot_by_gamma_value_of_beta_rate;
    // d(delta')/d(beta_rate) = rr*sin(theta)*cos(gamma - delta - phi_minus_90deg)/(zt*cos(beta + theta -
    //   gamma)*sin(phi_minus_90deg))
    let delta_dot_by_beta_rate_value = d1_by_delta_of_place * beta_rate_dot_by_epsilon_of_place_3;
    // d(phi')/d(beta) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(zt*cos(gamma - delta) +
    //   e*cos(gamma - delta - phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_beta_value = -sin_angle_cos_angle_inv
        * delta_dot_by_gamma_value_of_beta_rate * phi_dot_by_beta_value_of_place;
    // d(phi')/d(theta) = -rr*beta_rate*(cos(gamma - delta)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/e + cos(gamma - delta - phi_minus_90deg)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/zt)/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_theta_value = -sin_phi_minus_90deg_inv * d1_by_theta_of_place
        * beta_rate_dot_by_delta_of_beta_rate_2 * beta_rate_dot_by_epsilon_of_place;
    // d(phi')/d(gamma) = rr*beta_rate*sin(theta)*((sin(gamma - delta) + cos(gamma - delta)*tan(beta +
    //   theta - gamma))/e + (sin(gamma - delta - phi_minus_90deg) + cos(gamma - delta -
    //   phi_minus_90deg)*tan(beta + theta - gamma))/zt)/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_gamma_value = delta_dot_by_beta_value_of_beta_rate
        * e_inv
            .mul_add(
                beta_rate_dot_by_beta_of_place_111,
                zt_inv * beta_rate_dot_by_beta_of_place_91,
            );
    // d(phi')/d(delta) = -rr*beta_rate*sin(theta)*(zt*sin(gamma - delta) + e*sin(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_delta_value = -e_inv * delta_dot_by_gamma_value_of_beta_rate
        * e.mul_add(beta_rate_dot_by_beta_of_place_79, zt * sin_gamma_minus_delta);
    // d(phi')/d(phi_minus_90deg) = rr*beta_rate*sin(theta)*(cos(gamma - delta)/(e*tan(phi_minus_90deg)) -
    //   (sin(gamma - delta - phi_minus_90deg) - cos(gamma - delta -
    //   phi_minus_90deg)/tan(phi_minus_90deg))/zt)/(cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_phi_minus_90deg_value = delta_dot_by_beta_value_of_beta_rate
        * (-zt_inv)
            .mul_add(
                beta_rate_dot_by_epsilon_of_place_5, beta_rate_dot_by_epsilon_of_place_6,
            );
    // d(phi')/d(beta_rate) = -rr*sin(theta)*(zt*cos(gamma - delta) + e*cos(gamma - delta -
    //   phi_minus_90deg))/(e*zt*cos(beta + theta - gamma)*sin(phi_minus_90deg))
    let phi_dot_by_beta_rate_value = -zt_inv * sin_phi_minus_90deg_inv
        * d1_by_delta_of_place * phi_dot_by_beta_value_of_place;
    // d(epsilon')/d(beta) = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)*tan(beta + theta -
    //   gamma)/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_beta_value = d1_of_place_3_u_2_inv * sin_angle_cos_angle_inv
        * epsilon_dot_by_beta_value_of_beta_rate;
    // d(epsilon')/d(theta) = rr*beta_rate*cos(gamma - epsilon - omega)*(cos(theta) + sin(theta)*tan(beta +
    //   theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_theta_value = gamma_dot_by_theta_value_of_beta_rate
        * epsilon_dot_by_theta_value_of_place;
    // d(epsilon')/d(gamma) = -rr*beta_rate*sin(theta)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon
    //   - omega)*tan(beta + theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_gamma_value = beta_rate_dot_by_beta_of_place_51
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(epsilon) = rr*beta_rate*sin(theta)*sin(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_by_epsilon_value = -beta_rate_dot_by_beta_of_place_39
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(omega) = rr*beta_rate*sin(theta)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
    //   omega)*tan(omega))/(u*cos(beta + theta - gamma)*cos(omega))
    let epsilon_dot_by_omega_value = -beta_rate_dot_by_epsilon_of_place_31
        * epsilon_dot_by_gamma_value_of_beta_rate;
    // d(epsilon')/d(beta_rate) = rr*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
    //   gamma)*cos(omega))
    let epsilon_dot_by_beta_rate_value = d1_by_delta_of_place * epsilon_dot_by_theta_value_of_place;
    // d(omega')/d(beta) = rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(zf*cos(gamma - epsilon -
    //   omega) - u*sin(gamma - epsilon))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_beta_value = sin_angle_cos_angle_inv
        * omega_dot_by_beta_value_of_place * omega_dot_by_beta_value_of_beta_rate;
    // d(omega')/d(theta) = rr*beta_rate*(sin(gamma - epsilon)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/zf - cos(gamma - epsilon - omega)*(cos(theta) + sin(theta)*tan(beta + theta -
    //   gamma))/u)/(cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_theta_value = cos_omega_inv * d1_by_theta_of_place
        * beta_rate_dot_by_delta_of_beta_rate_2 * (d1_of_place_10 - d1_of_place_3_u_2_inv);
    // d(omega')/d(gamma) = rr*beta_rate*sin(theta)*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
    //   cos(gamma - epsilon))/zf + (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta +
    //   theta - gamma))/u)/(cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_gamma_value = epsilon_dot_by_beta_value_of_beta_rate
        * (-u_2_inv)
            .mul_add(
                beta_rate_dot_by_beta_of_place_51,
                zf_inv * beta_rate_dot_by_beta_of_place_62,
            );
    // d(omega')/d(epsilon) = -rr*beta_rate*sin(theta)*(u*cos(gamma - epsilon) + zf*sin(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_epsilon_value = omega_dot_by_beta_value_of_beta_rate
        * (-u_2)
            .mul_add(cos_gamma_minus_epsilon, zf * beta_rate_dot_by_beta_of_place_39);
    // d(omega')/d(omega) = rr*beta_rate*sin(theta)*(sin(gamma - epsilon)*tan(omega)/zf - (sin(gamma -
    //   epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/u)/(cos(beta + theta -
    //   gamma)*cos(omega))
    let omega_dot_by_omega_value = epsilon_dot_by_beta_value_of_beta_rate
        * u_2_inv
            .mul_add(
                beta_rate_dot_by_epsilon_of_place_31, beta_rate_dot_by_beta_of_place_65,
            );
    // d(omega')/d(beta_rate) = rr*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon -
    //   omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
    let omega_dot_by_beta_rate_value = u_2_inv * d1_by_delta_of_place
        * zf_inv_cos_omega_inv * omega_dot_by_beta_value_of_place;
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
    // divisor3 = sin(phi_minus_90deg)
    let divisor3 = sin_phi_minus_90deg;
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 132 convolutions and 352 linear operations an order.
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 8]],
    history: &mut [Factors<S, 136>],
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
    let d_inv_rr = rr / d;
    let e_inv = S::int(1) / e;
    let zt_inv = S::int(1) / zt;
    let u_2_inv = S::int(1) / u_2;
    let sa_sd = sa * sd;
    let sb_sc = sb * sc;
    let weight_12_of_yb_yc_sc = sc * yb_minus_yc;
    let weight_12_of_xb_xc_sd = sd * xb_minus_xc;
    let weight_11_of_xb_xc_sc = sc * xb_minus_xc;
    let weight_11_of_yb_yc_sd = sd * yb_minus_yc;
    let e_inv_ea = ea / e;
    // ea/e - 1
    let weight_5_of_e_ea = e_inv_ea - S::int(1);
    let zf_inv_fa = fa / zf;
    // fa/zf - 1
    let weight_2_of_zf_fa = zf_inv_fa - S::int(1);
    let zf_inv = S::int(1) / zf;
    // ea/e - 2
    let weight_4_of_e_ea = e_inv_ea - S::int(2);
    // I5 + m5*(ta^2 + tb^2)
    let weight_6_of_m5_i5_ta_tb = I5 + m5 * tb.mul_add(tb, ta * ta);
    // fa/zf - 2
    let weight_of_zf_fa = zf_inv_fa - S::int(2);
    // I7 + m7*(ua^2 + ub^2)
    let weight_3_of_m7_i7_ua_ub = I7 + m7 * ub.mul_add(ub, ua * ua);
    let m2_da_sq = m2 * da * da;
    // I2 + m2*da^2
    let i2_plus_m2_da_sq = I2 + m2_da_sq;
    let m6_ss_inv = m6 / ss;
    let m4_ss_inv = m4 / ss;
    let m2_d_inv_da = m2 * da / d;
    let m2_da_2 = m2 * da;
    let weight_3_of_place = weight_3_of_m7_i7_ua_ub / (u_2 * u_2);
    let i6_zf_inv2 = I6 / (zf * zf);
    let weight_6_of_place = weight_6_of_m5_i5_ta_tb / (zt * zt);
    let i4_e_inv2 = I4 / (e * e);
    let weight_2_of_m6_zf_fa = m6 * weight_2_of_zf_fa;
    let weight_5_of_m4_e_ea = m4 * weight_5_of_e_ea;
    let weight_41_of_place = i2_plus_m2_da_sq / (d * ss);
    // m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight_of_m6_i6_zf_fa = m6 + i6_zf_inv2 + m6 * fa * weight_of_zf_fa / zf;
    // m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight_4_of_m4_i4_e_ea = m4 + i4_e_inv2 + m4 * ea * weight_4_of_e_ea / e;
    let m4_ea_by_e_minus_1_by_ss_of_m4_e_ea_ss = m4 * weight_5_of_e_ea / ss;
    // Constant in time.
    // weight = m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf
    let weight = weight_of_m6_i6_zf_fa;
    // weight_2 = 2*m6*(fa/zf - 1)
    let weight_2 = S::int(2) * weight_2_of_m6_zf_fa;
    // weight_3 = m6 + (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_3 = m6 + weight_3_of_place;
    // weight_4 = m4 + I4/e^2 + m4*ea*(ea/e - 2)/e
    let weight_4 = weight_4_of_m4_i4_e_ea;
    // weight_5 = 2*m4*(ea/e - 1)
    let weight_5 = S::int(2) * weight_5_of_m4_e_ea;
    // weight_6 = m4 + (I5 + m5*(ta^2 + tb^2))/zt^2
    let weight_6 = m4 + weight_6_of_place;
    // weight_7 = (I3 + m3*(sa^2 + sb^2))/ss^2
    let weight_7 = (I3 + m3 * sb.mul_add(sb, sa * sa)) / (ss * ss);
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
    // fa_by_zf_minus_1 = fa/zf - 1
    let fa_by_zf_minus_1 = weight_2_of_zf_fa;
    // ea_by_e_minus_1 = ea/e - 1
    let ea_by_e_minus_1 = weight_5_of_e_ea;
    // weight_13 = (I7 + m7*(ua^2 + ub^2))/u^2
    let weight_13 = weight_3_of_place;
    // m6_fa_by_zf_minus_1 = m6*(fa/zf - 1)
    let m6_fa_by_zf_minus_1 = weight_2_of_m6_zf_fa;
    // weight_14 = (I5 + m5*(ta^2 + tb^2))/zt^2
    let weight_14 = weight_6_of_place;
    // m4_ea_by_e_minus_1 = m4*(ea/e - 1)
    let m4_ea_by_e_minus_1 = weight_5_of_m4_e_ea;
    // weight_15 = 2/u - 2*fa/(u*zf)
    let weight_15 = u_2_inv.mul_add(S::int(2), -S::int(2) * fa / (u_2 * zf));
    // weight_16 = 1/zf
    let weight_16 = zf_inv;
    // weight_17 = 2*(fa/zf - 1)/zf
    let weight_17 = S::int(2) * weight_2_of_zf_fa / zf;
    // weight_18 = -(m6 + (I6/zf + m6*fa*(fa/zf - 2))/zf)/u
    let weight_18 = -(m6 + (m6 * fa).mul_add(weight_of_zf_fa, I6 / zf) / zf) / u_2;
    // weight_19 = (I7 + m7*(ua^2 + ub^2))/(u^2*zf)
    let weight_19 = weight_3_of_m7_i7_ua_ub / (u_2 * u_2 * zf);
    // weight_20 = (m6 + I6/zf^2 + m6*fa*(fa/zf - 2)/zf)/zf
    let weight_20 = weight_of_m6_i6_zf_fa / zf;
    // m6_by_zf = m6/zf
    let m6_by_zf = m6 / zf;
    // weight_21 = 2*(fa/zf - 1)/ss
    let weight_21 = S::int(2) * weight_2_of_zf_fa / ss;
    // minus_1_by_zf = -1/zf
    let minus_1_by_zf = -zf_inv;
    // minus_m6 = -m6
    let minus_m6 = -m6;
    // weight_22 = m6*(1 - fa/zf)/ss
    let weight_22 = -m6 * weight_2_of_zf_fa / ss;
    // weight_23 = m6/ss + I6/(ss*zf^2) + m6*fa^2/(ss*zf^2) - 2*m6*fa/(ss*zf)
    let weight_23 = m6_ss_inv + I6 / (ss * zf * zf) + m6 * fa * fa / (ss * zf * zf)
        - S::int(2) * m6 * fa / (ss * zf);
    // weight_24 = (m6 + I6/zf^2 + m6*fa^2/zf^2 - 2*m6*fa/zf)/ss
    let weight_24 = (m6 + i6_zf_inv2 + m6 * fa * fa / (zf * zf) - S::int(2) * m6 * fa / zf) / ss;
    // weight_25 = m6*(1 - fa/zf)/zf
    let weight_25 = -m6 * weight_2_of_zf_fa / zf;
    // weight_26 = -(I7 + m7*(ua^2 + ub^2))/(u*zf)
    let weight_26 = -weight_3_of_m7_i7_ua_ub / (u_2 * zf);
    // minus_1_by_u = -1/u
    let minus_1_by_u = -u_2_inv;
    // weight_27 = 1/u
    let weight_27 = u_2_inv;
    // m6_by_u = m6/u
    let m6_by_u = m6 / u_2;
    // m6_by_ss = m6/ss
    let m6_by_ss = m6_ss_inv;
    // weight_28 = (I7 + m7*ua^2 + m7*ub^2)/(ss*u^2)
    let weight_28 = (I7 + m7 * ua * ua + m7 * ub * ub) / (ss * u_2 * u_2);
    // weight_29 = 2/zt - 2*ea/(e*zt)
    let weight_29 = zt_inv.mul_add(S::int(2), -S::int(2) * ea / (e * zt));
    // minus_1_by_e = -1/e
    let minus_1_by_e = -e_inv;
    // weight_30 = 2*(1 - ea/e)/e
    let weight_30 = -S::int(2) * weight_5_of_e_ea / e;
    // weight_31 = -(m4 + (I4/e + m4*ea*(ea/e - 2))/e)/zt
    let weight_31 = -(m4 + (m4 * ea).mul_add(weight_4_of_e_ea, I4 / e) / e) / zt;
    // weight_32 = -(I5 + m5*(ta^2 + tb^2))/(e*zt^2)
    let weight_32 = -weight_6_of_m5_i5_ta_tb / (e * zt * zt);
    // weight_33 = -(m4 + I4/e^2 + m4*ea*(ea/e - 2)/e)/e
    let weight_33 = -weight_4_of_m4_i4_e_ea / e;
    // m4_by_e = m4/e
    let m4_by_e = m4 / e;
    // weight_34 = 2*(ea/e - 1)/ss
    let weight_34 = S::int(2) * weight_5_of_e_ea / ss;
    // m4_ea_by_e_minus_1_by_ss = m4*(ea/e - 1)/ss
    let m4_ea_by_e_minus_1_by_ss = m4_ea_by_e_minus_1_by_ss_of_m4_e_ea_ss;
    // weight_35 = m4/ss + I4/(e^2*ss) + m4*ea^2/(e^2*ss) - 2*m4*ea/(e*ss)
    let weight_35 = m4_ss_inv + I4 / (e * e * ss) + m4 * ea * ea / (e * e * ss)
        - S::int(2) * m4 * ea / (e * ss);
    // weight_36 = (m4 + I4/e^2 + m4*ea^2/e^2 - 2*m4*ea/e)/ss
    let weight_36 = (m4 + i4_e_inv2 + m4 * ea * ea / (e * e) - S::int(2) * m4 * ea / e) / ss;
    // m4_1_minus_ea_by_e_by_e = m4*(1 - ea/e)/e
    let m4_1_minus_ea_by_e_by_e = -m4 * weight_5_of_e_ea / e;
    // weight_37 = -(I5 + m5*(ta^2 + tb^2))/(e*zt)
    let weight_37 = -weight_6_of_m5_i5_ta_tb / (e * zt);
    // minus_1_by_zt = -1/zt
    let minus_1_by_zt = -zt_inv;
    // weight_38 = 1/zt
    let weight_38 = zt_inv;
    // m4_by_zt = m4/zt
    let m4_by_zt = m4 / zt;
    // minus_m4_by_ss = -m4/ss
    let minus_m4_by_ss = -m4_ss_inv;
    // m4_1_minus_ea_by_e_by_ss = m4*(1 - ea/e)/ss
    let m4_1_minus_ea_by_e_by_ss = -m4_ea_by_e_minus_1_by_ss_of_m4_e_ea_ss;
    // weight_39 = -(I5 + m5*ta^2 + m5*tb^2)/(ss*zt^2)
    let weight_39 = -(I5 + m5 * ta * ta + m5 * tb * tb) / (ss * zt * zt);
    // minus_1_by_ss = -1/ss
    let minus_1_by_ss = -S::int(1) / ss;
    // minus_m6_by_ss = -m6/ss
    let minus_m6_by_ss = -m6_ss_inv;
    // weight_40 = 1/d
    let weight_40 = S::int(1) / d;
    // m2_da_by_ss = m2*da/ss
    let m2_da_by_ss = m2 * da / ss;
    // weight_41 = -(I2 + m2*da^2)/(d*ss)
    let weight_41 = -weight_41_of_place;
    // i2_plus_m2_da_2_by_d_ss = (I2 + m2*da^2)/(d*ss)
    let i2_plus_m2_da_2_by_d_ss = weight_41_of_place;
    // m2_da_rr_by_d_ss = m2*da*rr/(d*ss)
    let m2_da_rr_by_d_ss = m2 * da * rr / (d * ss);
    // m2_da_rr_by_d_2 = m2*da*rr/d^2
    let m2_da_rr_by_d_2 = m2 * da * rr / (d * d);
    // m2_da_by_d = m2*da/d
    let m2_da_by_d = m2_d_inv_da;
    // weight_42 = sc*(yb - yc) + sd*(xc - xb)
    let weight_42 = weight_12_of_yb_yc_sc - weight_12_of_xb_xc_sd;
    // sb_sc_minus_sa_sd = sb*sc - sa*sd
    let sb_sc_minus_sa_sd = sb_sc - sa_sd;
    // weight_43 = sc*(xb - xc) + sd*(yb - yc)
    let weight_43 = weight_11_of_xb_xc_sc + weight_11_of_yb_yc_sd;
    // sa_sd_minus_sb_sc = sa*sd - sb*sc
    let sa_sd_minus_sb_sc = sa_sd - sb_sc;
    // l0_sb_sc_minus_l0_sa_sd = l0*sb*sc - l0*sa*sd
    let l0_sb_sc_minus_l0_sa_sd = (-(l0 * sa)).mul_add(sd, l0 * sb * sc);
    // minus_l0 = -l0
    let minus_l0 = -l0;
    // minus_c0_by_ss = -c0/ss
    let minus_c0_by_ss = -c0 / ss;
    // i2_plus_m2_da_2_by_d = (I2 + m2*da^2)/d
    let i2_plus_m2_da_2_by_d = i2_plus_m2_da_sq / d;
    // minus_m2_da = -m2*da
    let minus_m2_da = -m2_da_2;
    // minus_i2_minus_m2_da_2 = -I2 - m2*da^2
    let minus_i2_minus_m2_da_2 = -I2 - m2_da_sq;
    // m2_da = m2*da
    let m2_da = m2_da_2;
    // minus_rr_by_d = -rr/d
    let minus_rr_by_d = -d_inv_rr;
    // rr_by_d = rr/d
    let rr_by_d = d_inv_rr;
    // weight_44 = 1/e
    let weight_44 = e_inv;
    // rr_by_ss = rr/ss
    let rr_by_ss = rr / ss;
    // rr_by_zt = rr/zt
    let rr_by_zt = rr / zt;
    // minus_rr = -rr
    let minus_rr = -rr;
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
    let gamma_minus_epsilon_0 = gamma_0 - epsilon_0;
    let (sin_gamma_minus_epsilon_0, cos_gamma_minus_epsilon_0) = gamma_minus_epsilon_0
        .sin_cos();
    let d1_of_place_2_0 = gamma_0 - epsilon_0 - omega_0;
    let (sin_angle_2_0, cos_angle_2_0) = d1_of_place_2_0.sin_cos();
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
    let beta_rate_dot_of_place_3_0 = fa_by_zf_minus_1 * sin_gamma_minus_epsilon_0
        + sin_omega_cos_angle_2_0;
    let beta_rate_dot_of_place_4_0 = ea_by_e_minus_1 * cos_gamma_minus_delta_0 + d1_of_place_9_0;
    let beta_rate_dot_of_place_5_0 = cos_angle_2_sq_0
        .mul_add(m6, cos_angle_3_sq_0.mul_add(m4, weight_7));
    let beta_rate_dot_of_place_6_0 = cos_theta_0 * sin_beta_minus_gamma_0;
    let sin_omega_sq_0 = sin_omega_0 * sin_omega_0;
    let beta_rate_dot_of_place_7_0 = sin_omega_sq_0.mul_add(m6, weight_13);
    let beta_rate_dot_of_place_8_0 = cos_angle_2_0 * over_cos_omega;
    let beta_rate_dot_of_place_9_0 = beta_rate_dot_of_place_7_0 * beta_rate_dot_of_place_8_0;
    let beta_rate_dot_of_place_10_0 = m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon_0
        + beta_rate_dot_of_place_9_0;
    let cos_angle_2_sin_angle_2_0 = cos_angle_2_0 * sin_angle_2_0;
    let beta_rate_dot_of_place_11_0 = sin_gamma_minus_epsilon_0 * cos_angle_2_sin_angle_2_0;
    let cos_phi_minus_90deg_sq_0 = cos_phi_minus_90deg_0 * cos_phi_minus_90deg_0;
    let beta_rate_dot_of_place_12_0 = cos_phi_minus_90deg_sq_0.mul_add(m4, weight_14);
    let beta_rate_dot_of_place_13_0 = cos_angle_3_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_14_0 = beta_rate_dot_of_place_12_0 * beta_rate_dot_of_place_13_0;
    let beta_rate_dot_of_place_15_0 = m4_ea_by_e_minus_1 * sin_gamma_minus_delta_0
        + beta_rate_dot_of_place_14_0;
    let cos_angle_3_sin_angle_3_0 = cos_angle_3_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_16_0 = cos_gamma_minus_delta_0 * cos_angle_3_sin_angle_3_0;
    let beta_rate_dot_of_place_17_0 = sin_omega_0.mul_add(weight_16, weight_15);
    let beta_rate_dot_of_place_18_0 = cos_angle_2_0 * beta_rate_dot_of_place_17_0;
    let beta_rate_dot_of_place_19_0 = weight_17 * sin_gamma_minus_epsilon_0
        + beta_rate_dot_of_place_18_0;
    let beta_rate_dot_of_place_20_0 = sin_omega_0 * beta_rate_dot_of_place_19_0;
    let beta_rate_dot_of_place_21_0 = beta_rate_dot_of_place_20_0
        .mul_add(
            m6,
            cos_angle_2_0.mul_add(weight_19, weight_18 * sin_gamma_minus_epsilon_0),
        );
    let beta_rate_dot_of_place_22_0 = cos_angle_2_0 * beta_rate_dot_of_place_21_0;
    let beta_rate_dot_of_place_23_0 = sin_gamma_minus_epsilon_0 * sin_gamma_minus_epsilon_0;
    let beta_rate_dot_of_place_24_0 = weight_20 * beta_rate_dot_of_place_23_0
        + beta_rate_dot_of_place_22_0;
    let beta_rate_dot_of_place_25_0 = beta_rate_dot_of_place_24_0 * over_cos_omega;
    let beta_rate_dot_of_place_26_0 = sin_angle_2_0 * beta_rate_dot_of_place_3_0;
    let beta_rate_dot_of_place_27_0 = m6_by_zf * beta_rate_dot_of_place_26_0
        + beta_rate_dot_of_place_25_0;
    let beta_rate_dot_of_place_28_0 = beta_rate_dot_of_place_27_0 * over_cos_omega;
    let sin_angle_cos_angle_inv_0 = sin_angle_0 * over_cos_angle;
    let beta_rate_dot_of_place_29_0 = sin_angle_cos_angle_inv_0
        .mul_add(weight_21, minus_1_by_zf * cos_angle_2_0);
    let beta_rate_dot_of_place_30_0 = cos_angle_2_0 * beta_rate_dot_of_place_29_0;
    let beta_rate_dot_of_place_31_0 = beta_rate_dot_of_place_30_0
        .mul_add(minus_m6, weight_22 * sin_angle_2_0) + beta_rate_dot_of_place_28_0;
    let beta_rate_dot_of_place_32_0 = sin_omega_0 * beta_rate_dot_of_place_31_0;
    let beta_rate_dot_of_place_33_0 = beta_rate_dot_of_place_8_0
        .mul_add(weight_18, weight_23);
    let beta_rate_dot_of_place_34_0 = cos_gamma_minus_epsilon_0 * beta_rate_dot_of_place_33_0;
    let beta_rate_dot_of_place_35_0 = sin_angle_cos_angle_inv_0
        .mul_add(weight_24, weight_25 * cos_angle_2_0);
    let beta_rate_dot_of_place_36_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_35_0;
    let beta_rate_dot_of_place_37_0 = sin_angle_2_0 * over_cos_omega;
    let beta_rate_dot_of_place_38_0 = beta_rate_dot_of_place_37_0
        .mul_add(weight_26, m6_fa_by_zf_minus_1 * cos_angle_2_0);
    let beta_rate_dot_of_place_39_0 = cos_angle_2_0 * beta_rate_dot_of_place_38_0;
    let beta_rate_dot_of_place_40_0 = beta_rate_dot_of_place_39_0
        .mul_add(minus_1_by_u, beta_rate_dot_of_place_34_0) - beta_rate_dot_of_place_36_0
        + beta_rate_dot_of_place_32_0;
    let beta_rate_dot_of_place_41_0 = sin_gamma_minus_epsilon_0 * beta_rate_dot_of_place_40_0;
    let beta_rate_dot_of_place_42_0 = beta_rate_dot_of_place_10_0 * over_cos_omega;
    let beta_rate_dot_of_place_43_0 = sin_omega_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_44_0 = beta_rate_dot_of_place_42_0
        .mul_add(
            weight_27,
            beta_rate_dot_of_place_43_0.mul_add(m6_by_ss, m6_by_u * cos_angle_2_0),
        );
    let beta_rate_dot_of_place_45_0 = cos_angle_2_0 * beta_rate_dot_of_place_44_0;
    let sin_omega_sin_angle_2_0 = sin_omega_0 * sin_angle_2_0;
    let beta_rate_dot_of_place_46_0 = sin_omega_sin_angle_2_0
        .mul_add(m6_by_ss, weight_22 * cos_gamma_minus_epsilon_0) + beta_rate_dot_of_place_45_0;
    let beta_rate_dot_of_place_47_0 = sin_omega_0 * beta_rate_dot_of_place_46_0;
    let beta_rate_dot_of_place_48_0 = cos_angle_2_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_49_0 = beta_rate_dot_of_place_48_0
        .mul_add(weight_28, weight_28 * sin_angle_2_0) + beta_rate_dot_of_place_47_0;
    let beta_rate_dot_of_place_50_0 = cos_angle_2_0 * beta_rate_dot_of_place_49_0;
    let beta_rate_dot_of_place_51_0 = -beta_rate_dot_of_place_50_0 + beta_rate_dot_of_place_41_0;
    let beta_rate_dot_of_place_52_0 = beta_rate_dot_of_place_51_0 * over_cos_omega;
    let beta_rate_dot_of_place_53_0 = m6_by_zf * beta_rate_dot_of_place_11_0
        + beta_rate_dot_of_place_52_0;
    let beta_rate_dot_of_place_54_0 = beta_rate_dot_of_place_53_0 * over_cos_omega;
    let beta_rate_dot_of_place_55_0 = cos_phi_minus_90deg_0
        .mul_add(minus_1_by_e, weight_29);
    let beta_rate_dot_of_place_56_0 = cos_angle_3_0 * beta_rate_dot_of_place_55_0;
    let beta_rate_dot_of_place_57_0 = weight_30 * cos_gamma_minus_delta_0
        + beta_rate_dot_of_place_56_0;
    let beta_rate_dot_of_place_58_0 = cos_phi_minus_90deg_0 * beta_rate_dot_of_place_57_0;
    let beta_rate_dot_of_place_59_0 = beta_rate_dot_of_place_58_0
        .mul_add(
            m4,
            cos_angle_3_0.mul_add(weight_32, weight_31 * cos_gamma_minus_delta_0),
        );
    let beta_rate_dot_of_place_60_0 = cos_angle_3_0 * beta_rate_dot_of_place_59_0;
    let cos_gamma_minus_delta_sq_0 = cos_gamma_minus_delta_0 * cos_gamma_minus_delta_0;
    let beta_rate_dot_of_place_61_0 = weight_33 * cos_gamma_minus_delta_sq_0
        + beta_rate_dot_of_place_60_0;
    let beta_rate_dot_of_place_62_0 = beta_rate_dot_of_place_61_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_63_0 = sin_angle_3_0 * beta_rate_dot_of_place_4_0;
    let beta_rate_dot_of_place_64_0 = m4_by_e * beta_rate_dot_of_place_63_0
        + beta_rate_dot_of_place_62_0;
    let beta_rate_dot_of_place_65_0 = beta_rate_dot_of_place_64_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_66_0 = sin_angle_cos_angle_inv_0
        .mul_add(weight_34, minus_1_by_e * cos_angle_3_0);
    let beta_rate_dot_of_place_67_0 = cos_angle_3_0 * beta_rate_dot_of_place_66_0;
    let beta_rate_dot_of_place_68_0 = beta_rate_dot_of_place_67_0
        .mul_add(m4, m4_ea_by_e_minus_1_by_ss * sin_angle_3_0) + beta_rate_dot_of_place_65_0;
    let beta_rate_dot_of_place_69_0 = cos_phi_minus_90deg_0 * beta_rate_dot_of_place_68_0;
    let beta_rate_dot_of_place_70_0 = beta_rate_dot_of_place_13_0
        .mul_add(weight_31, weight_35);
    let beta_rate_dot_of_place_71_0 = sin_gamma_minus_delta_0 * beta_rate_dot_of_place_70_0;
    let beta_rate_dot_of_place_72_0 = sin_angle_cos_angle_inv_0
        .mul_add(weight_36, m4_1_minus_ea_by_e_by_e * cos_angle_3_0);
    let beta_rate_dot_of_place_73_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_72_0;
    let beta_rate_dot_of_place_74_0 = sin_angle_3_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_75_0 = beta_rate_dot_of_place_74_0
        .mul_add(weight_37, m4_ea_by_e_minus_1 * cos_angle_3_0);
    let beta_rate_dot_of_place_76_0 = cos_angle_3_0 * beta_rate_dot_of_place_75_0;
    let beta_rate_dot_of_place_77_0 = beta_rate_dot_of_place_76_0
        .mul_add(
            minus_1_by_zt,
            beta_rate_dot_of_place_71_0 + beta_rate_dot_of_place_73_0,
        ) + beta_rate_dot_of_place_69_0;
    let beta_rate_dot_of_place_78_0 = cos_gamma_minus_delta_0 * beta_rate_dot_of_place_77_0;
    let beta_rate_dot_of_place_79_0 = beta_rate_dot_of_place_15_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_80_0 = cos_phi_minus_90deg_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_81_0 = beta_rate_dot_of_place_79_0
        .mul_add(
            weight_38,
            beta_rate_dot_of_place_80_0.mul_add(minus_m4_by_ss, m4_by_zt * cos_angle_3_0),
        );
    let beta_rate_dot_of_place_82_0 = cos_angle_3_0 * beta_rate_dot_of_place_81_0;
    let beta_rate_dot_of_place_83_0 = cos_phi_minus_90deg_0 * sin_angle_3_0;
    let beta_rate_dot_of_place_84_0 = beta_rate_dot_of_place_83_0
        .mul_add(minus_m4_by_ss, m4_1_minus_ea_by_e_by_ss * sin_gamma_minus_delta_0)
        + beta_rate_dot_of_place_82_0;
    let beta_rate_dot_of_place_85_0 = cos_phi_minus_90deg_0 * beta_rate_dot_of_place_84_0;
    let beta_rate_dot_of_place_86_0 = cos_angle_3_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_87_0 = beta_rate_dot_of_place_86_0
        .mul_add(weight_39, weight_39 * sin_angle_3_0) + beta_rate_dot_of_place_85_0;
    let beta_rate_dot_of_place_88_0 = cos_angle_3_0 * beta_rate_dot_of_place_87_0;
    let beta_rate_dot_of_place_89_0 = -beta_rate_dot_of_place_88_0 + beta_rate_dot_of_place_78_0;
    let beta_rate_dot_of_place_90_0 = beta_rate_dot_of_place_89_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_91_0 = m4_by_e * beta_rate_dot_of_place_16_0
        + beta_rate_dot_of_place_90_0;
    let beta_rate_dot_of_place_92_0 = beta_rate_dot_of_place_91_0 * over_sin_phi_minus_90deg;
    let beta_rate_dot_of_place_93_0 = beta_rate_dot_of_place_5_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_94_0 = beta_rate_dot_of_place_93_0
        .mul_add(
            minus_1_by_ss,
            cos_angle_2_sin_angle_2_0
                .mul_add(minus_m6_by_ss, minus_m4_by_ss * cos_angle_3_sin_angle_3_0),
        ) + beta_rate_dot_of_place_54_0 - beta_rate_dot_of_place_92_0;
    let beta_rate_dot_of_place_95_0 = sin_theta_0 * beta_rate_dot_of_place_94_0;
    let beta_rate_dot_of_place_96_0 = beta_rate_dot_of_place_7_0 * cos_angle_2_sq_0;
    let beta_rate_dot_of_place_97_0 = beta_rate_dot_of_place_96_0 + d1_of_place_6_0;
    let beta_rate_dot_of_place_98_0 = beta_rate_dot_of_place_97_0 * over_cos_omega_sq;
    let beta_rate_dot_of_place_99_0 = beta_rate_dot_of_place_12_0 * cos_angle_3_sq_0;
    let beta_rate_dot_of_place_100_0 = beta_rate_dot_of_place_99_0 + d1_of_place_11_0;
    let beta_rate_dot_of_place_101_0 = beta_rate_dot_of_place_100_0 * over_sin_phi_minus_90deg_sq;
    let beta_rate_dot_of_place_102_0 = cos_angle_2_sq_0
        .mul_add(m6, cos_angle_3_sq_0.mul_add(m4, weight_7))
        + beta_rate_dot_of_place_98_0 + beta_rate_dot_of_place_101_0;
    let beta_rate_dot_of_place_103_0 = cos_beta_minus_gamma_0 * sin_angle_cos_angle_inv_0;
    let beta_rate_dot_of_place_104_0 = beta_rate_dot_of_place_102_0 * beta_rate_dot_of_place_103_0;
    let beta_rate_dot_of_place_105_0 = weight_40 * beta_rate_dot_of_place_104_0
        + beta_rate_dot_of_place_95_0;
    let beta_rate_dot_of_place_106_0 = sin_theta_0 * beta_rate_dot_of_place_105_0;
    let beta_rate_dot_of_place_107_0 = cos_angle_2_sq_0
        .mul_add(
            m6,
            cos_angle_3_sq_0.mul_add(m4, sin_angle_0.mul_add(m2_da_by_ss, weight_7)),
        ) + beta_rate_dot_of_place_98_0 + beta_rate_dot_of_place_101_0;
    let beta_rate_dot_of_place_108_0 = cos_theta_0 * beta_rate_dot_of_place_107_0;
    let beta_rate_dot_of_place_109_0 = beta_rate_dot_of_place_103_0
        .mul_add(weight_41, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma_0)
        + beta_rate_dot_of_place_108_0;
    let beta_rate_dot_of_place_110_0 = cos_beta_minus_gamma_0 * beta_rate_dot_of_place_109_0;
    let beta_rate_dot_of_place_111_0 = weight_40 * beta_rate_dot_of_place_110_0
        + beta_rate_dot_of_place_106_0;
    let beta_rate_dot_of_place_112_0 = beta_rate_dot_of_place_111_0 * over_cos_angle;
    let beta_rate_dot_of_place_113_0 = cos_angle_2_sq_0
        .mul_add(
            m6,
            cos_angle_3_sq_0
                .mul_add(m4, sin_beta_minus_gamma_0.mul_add(m2_da_rr_by_d_ss, weight_7)),
        ) + beta_rate_dot_of_place_98_0 + beta_rate_dot_of_place_101_0;
    let beta_rate_dot_of_place_114_0 = cos_theta_0 * beta_rate_dot_of_place_113_0;
    let beta_rate_dot_of_place_115_0 = beta_rate_dot_of_place_112_0
        .mul_add(
            rr,
            m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq_0 - beta_rate_dot_of_place_114_0,
        );
    let beta_rate_dot_of_place_116_0 = beta_rate_dot_of_place_115_0 * over_cos_angle;
    let beta_rate_dot_of_place_117_0 = m2_da_by_d * cos_beta_minus_gamma_0
        - beta_rate_dot_of_place_116_0;
    let beta_rate_sq_0 = beta_rate_0 * beta_rate_0;
    let beta_rate_dot_of_beta_rate_0 = beta_rate_dot_of_place_117_0 * beta_rate_sq_0;
    let beta_rate_dot_of_place_118_0 = sin_gamma_0.mul_add(sb_sc_minus_sa_sd, weight_42);
    let beta_rate_dot_of_place_119_0 = sin_gamma_0 * beta_rate_dot_of_place_118_0;
    let beta_rate_dot_of_place_120_0 = cos_gamma_0.mul_add(sb_sc_minus_sa_sd, weight_43);
    let beta_rate_dot_of_place_121_0 = cos_gamma_0 * beta_rate_dot_of_place_120_0;
    let beta_rate_dot_of_place_122_0 = sa_sd_minus_sb_sc + beta_rate_dot_of_place_119_0
        + beta_rate_dot_of_place_121_0;
    let beta_rate_dot_of_place_123_0 = beta_rate_dot_of_place_2_0 * beta_rate_dot_of_place_122_0;
    let beta_rate_dot_of_place_124_0 = beta_rate_dot_of_place_121_0
        .mul_add(
            minus_l0,
            beta_rate_dot_of_place_119_0.mul_add(minus_l0, l0_sb_sc_minus_l0_sa_sd),
        ) + beta_rate_dot_of_place_123_0;
    let beta_rate_dot_of_place_125_0 = beta_rate_dot_of_place_2_0 * over_beta_rate_dot_of_place;
    let beta_rate_dot_of_place_126_0 = beta_rate_dot_of_place_124_0 * beta_rate_dot_of_place_125_0;
    let beta_rate_dot_of_beta_rate_2_0 = beta_rate_dot_of_beta_rate_0
        .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_126_0);
    let beta_rate_dot_of_beta_rate_3_0 = sin_theta_0 * beta_rate_dot_of_beta_rate_2_0;
    let beta_rate_dot_of_place_127_0 = cos_beta_minus_gamma_0 * over_cos_angle;
    let beta_rate_dot_of_place_128_0 = beta_rate_dot_of_place_127_0
        .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta_0);
    let beta_rate_dot_of_place_129_0 = beta_rate_dot_of_place_128_0 * beta_rate_dot_of_place_103_0;
    let beta_rate_dot_of_place_130_0 = beta_rate_dot_of_place_129_0
        .mul_add(rr, minus_i2_minus_m2_da_2 * sin_beta_minus_gamma_0);
    let beta_rate_dot_of_place_131_0 = beta_rate_dot_of_place_130_0 * beta_rate_dot_of_place_127_0;
    let beta_rate_dot_of_place_132_0 = beta_rate_dot_of_place_131_0
        .mul_add(weight_40, m2_da * beta_rate_dot_of_place_6_0);
    let beta_rate_dot_of_beta_rate_4_0 = beta_rate_dot_of_place_132_0 * beta_rate_sq_0;
    let beta_rate_dot_of_beta_rate_5_0 = minus_rr_by_d * beta_rate_dot_of_beta_rate_4_0
        + beta_rate_dot_of_beta_rate_3_0;
    let beta_rate_dot_of_beta_rate_6_0 = beta_rate_dot_of_beta_rate_5_0 * over_cos_angle;
    let beta_rate_dot_of_beta_rate_7_0 = beta_rate_dot_of_beta_rate_6_0.mul_add(rr, mom);
    let beta_rate_dot_2_0 = beta_rate_dot_of_beta_rate_7_0 * over_d1_of_place_20;
    let theta_of_place_0 = beta_rate_dot_of_place_127_0.mul_add(rr_by_d, -S::int(1));
    let theta_dot_2_0 = beta_rate_0 * theta_of_place_0;
    let beta_rate_sin_theta_0 = beta_rate_0 * sin_theta_0;
    let gamma_of_beta_rate_0 = beta_rate_sin_theta_0 * over_cos_angle;
    let delta_of_beta_rate_0 = gamma_of_beta_rate_0 * beta_rate_dot_of_place_13_0;
    let phi_minus_90deg_of_place_0 = cos_angle_3_0
        .mul_add(weight_38, weight_44 * cos_gamma_minus_delta_0);
    let phi_minus_90deg_of_place_2_0 = phi_minus_90deg_of_place_0 * over_sin_phi_minus_90deg;
    let phi_minus_90deg_of_beta_rate_0 = gamma_of_beta_rate_0 * phi_minus_90deg_of_place_2_0;
    let epsilon_of_beta_rate_0 = gamma_of_beta_rate_0 * beta_rate_dot_of_place_8_0;
    let omega_of_place_0 = sin_gamma_minus_epsilon_0
        .mul_add(minus_1_by_zf, weight_27 * cos_angle_2_0);
    let omega_of_place_2_0 = omega_of_place_0 * over_cos_omega;
    let omega_of_beta_rate_0 = gamma_of_beta_rate_0 * omega_of_place_2_0;
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
    let gamma_minus_epsilon_1 = gamma_1 - epsilon_1;
    let sin_gamma_minus_epsilon_1 = gamma_minus_epsilon_1 * cos_gamma_minus_epsilon_0;
    let cos_gamma_minus_epsilon_1 = -gamma_minus_epsilon_1 * sin_gamma_minus_epsilon_0;
    let d1_of_place_2_1 = gamma_1 - epsilon_1 - omega_1;
    let sin_angle_2_1 = d1_of_place_2_1 * cos_angle_2_0;
    let cos_angle_2_1 = -d1_of_place_2_1 * sin_angle_2_0;
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
    let beta_rate_dot_of_place_3_1 = fa_by_zf_minus_1 * sin_gamma_minus_epsilon_1
        + sin_omega_cos_angle_2_1;
    let beta_rate_dot_of_place_4_1 = ea_by_e_minus_1 * cos_gamma_minus_delta_1 + d1_of_place_9_1;
    let beta_rate_dot_of_place_5_1 = cos_angle_2_sq_1.mul_add(m6, m4 * cos_angle_3_sq_1);
    let beta_rate_dot_of_place_6_1 = sin_beta_minus_gamma_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_beta_minus_gamma_0);
    let sin_omega_sq_1 = sin_omega_1 * (sin_omega_0 + sin_omega_0);
    let beta_rate_dot_of_place_7_1 = m6 * sin_omega_sq_1;
    let beta_rate_dot_of_place_8_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_8_0 * over_cos_omega),
            cos_angle_2_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_9_1 = beta_rate_dot_of_place_8_1
        .mul_add(
            beta_rate_dot_of_place_7_0,
            beta_rate_dot_of_place_7_1 * beta_rate_dot_of_place_8_0,
        );
    let beta_rate_dot_of_place_10_1 = m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon_1
        + beta_rate_dot_of_place_9_1;
    let cos_angle_2_sin_angle_2_1 = sin_angle_2_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * sin_angle_2_0);
    let beta_rate_dot_of_place_11_1 = cos_angle_2_sin_angle_2_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * cos_angle_2_sin_angle_2_0,
        );
    let cos_phi_minus_90deg_sq_1 = cos_phi_minus_90deg_1
        * (cos_phi_minus_90deg_0 + cos_phi_minus_90deg_0);
    let beta_rate_dot_of_place_12_1 = m4 * cos_phi_minus_90deg_sq_1;
    let beta_rate_dot_of_place_13_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_13_0 * over_sin_phi_minus_90deg),
            cos_angle_3_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_14_1 = beta_rate_dot_of_place_13_1
        .mul_add(
            beta_rate_dot_of_place_12_0,
            beta_rate_dot_of_place_12_1 * beta_rate_dot_of_place_13_0,
        );
    let beta_rate_dot_of_place_15_1 = m4_ea_by_e_minus_1 * sin_gamma_minus_delta_1
        + beta_rate_dot_of_place_14_1;
    let cos_angle_3_sin_angle_3_1 = sin_angle_3_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_16_1 = cos_angle_3_sin_angle_3_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * cos_angle_3_sin_angle_3_0,
        );
    let beta_rate_dot_of_place_17_1 = weight_16 * sin_omega_1;
    let beta_rate_dot_of_place_18_1 = beta_rate_dot_of_place_17_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_17_0);
    let beta_rate_dot_of_place_19_1 = weight_17 * sin_gamma_minus_epsilon_1
        + beta_rate_dot_of_place_18_1;
    let beta_rate_dot_of_place_20_1 = beta_rate_dot_of_place_19_1
        .mul_add(sin_omega_0, sin_omega_1 * beta_rate_dot_of_place_19_0);
    let beta_rate_dot_of_place_21_1 = beta_rate_dot_of_place_20_1
        .mul_add(
            m6,
            cos_angle_2_1.mul_add(weight_19, weight_18 * sin_gamma_minus_epsilon_1),
        );
    let beta_rate_dot_of_place_22_1 = beta_rate_dot_of_place_21_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_21_0);
    let beta_rate_dot_of_place_23_1 = sin_gamma_minus_epsilon_1
        * (sin_gamma_minus_epsilon_0 + sin_gamma_minus_epsilon_0);
    let beta_rate_dot_of_place_24_1 = weight_20 * beta_rate_dot_of_place_23_1
        + beta_rate_dot_of_place_22_1;
    let beta_rate_dot_of_place_25_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_25_0 * over_cos_omega),
            beta_rate_dot_of_place_24_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_26_1 = beta_rate_dot_of_place_3_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * beta_rate_dot_of_place_3_0);
    let beta_rate_dot_of_place_27_1 = m6_by_zf * beta_rate_dot_of_place_26_1
        + beta_rate_dot_of_place_25_1;
    let beta_rate_dot_of_place_28_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_28_0 * over_cos_omega),
            beta_rate_dot_of_place_27_1 * over_cos_omega,
        );
    let sin_angle_cos_angle_inv_1 = cos_angle_1
        .mul_add(
            -(sin_angle_cos_angle_inv_0 * over_cos_angle),
            sin_angle_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_29_1 = sin_angle_cos_angle_inv_1
        .mul_add(weight_21, minus_1_by_zf * cos_angle_2_1);
    let beta_rate_dot_of_place_30_1 = beta_rate_dot_of_place_29_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_29_0);
    let beta_rate_dot_of_place_31_1 = beta_rate_dot_of_place_30_1
        .mul_add(minus_m6, weight_22 * sin_angle_2_1) + beta_rate_dot_of_place_28_1;
    let beta_rate_dot_of_place_32_1 = beta_rate_dot_of_place_31_1
        .mul_add(sin_omega_0, sin_omega_1 * beta_rate_dot_of_place_31_0);
    let beta_rate_dot_of_place_33_1 = weight_18 * beta_rate_dot_of_place_8_1;
    let beta_rate_dot_of_place_34_1 = beta_rate_dot_of_place_33_1
        .mul_add(
            cos_gamma_minus_epsilon_0,
            cos_gamma_minus_epsilon_1 * beta_rate_dot_of_place_33_0,
        );
    let beta_rate_dot_of_place_35_1 = sin_angle_cos_angle_inv_1
        .mul_add(weight_24, weight_25 * cos_angle_2_1);
    let beta_rate_dot_of_place_36_1 = beta_rate_dot_of_place_35_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_35_0,
        );
    let beta_rate_dot_of_place_37_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_37_0 * over_cos_omega),
            sin_angle_2_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_38_1 = beta_rate_dot_of_place_37_1
        .mul_add(weight_26, m6_fa_by_zf_minus_1 * cos_angle_2_1);
    let beta_rate_dot_of_place_39_1 = beta_rate_dot_of_place_38_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_38_0);
    let beta_rate_dot_of_place_40_1 = beta_rate_dot_of_place_39_1
        .mul_add(minus_1_by_u, beta_rate_dot_of_place_34_1) - beta_rate_dot_of_place_36_1
        + beta_rate_dot_of_place_32_1;
    let beta_rate_dot_of_place_41_1 = beta_rate_dot_of_place_40_1
        .mul_add(
            sin_gamma_minus_epsilon_0,
            sin_gamma_minus_epsilon_1 * beta_rate_dot_of_place_40_0,
        );
    let beta_rate_dot_of_place_42_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_42_0 * over_cos_omega),
            beta_rate_dot_of_place_10_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_43_1 = sin_angle_cos_angle_inv_1
        .mul_add(sin_omega_0, sin_omega_1 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_44_1 = beta_rate_dot_of_place_42_1
        .mul_add(
            weight_27,
            beta_rate_dot_of_place_43_1.mul_add(m6_by_ss, m6_by_u * cos_angle_2_1),
        );
    let beta_rate_dot_of_place_45_1 = beta_rate_dot_of_place_44_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_44_0);
    let sin_omega_sin_angle_2_1 = sin_angle_2_1
        .mul_add(sin_omega_0, sin_omega_1 * sin_angle_2_0);
    let beta_rate_dot_of_place_46_1 = sin_omega_sin_angle_2_1
        .mul_add(m6_by_ss, weight_22 * cos_gamma_minus_epsilon_1) + beta_rate_dot_of_place_45_1;
    let beta_rate_dot_of_place_47_1 = beta_rate_dot_of_place_46_1
        .mul_add(sin_omega_0, sin_omega_1 * beta_rate_dot_of_place_46_0);
    let beta_rate_dot_of_place_48_1 = sin_angle_cos_angle_inv_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_49_1 = beta_rate_dot_of_place_48_1
        .mul_add(weight_28, weight_28 * sin_angle_2_1) + beta_rate_dot_of_place_47_1;
    let beta_rate_dot_of_place_50_1 = beta_rate_dot_of_place_49_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * beta_rate_dot_of_place_49_0);
    let beta_rate_dot_of_place_51_1 = -beta_rate_dot_of_place_50_1 + beta_rate_dot_of_place_41_1;
    let beta_rate_dot_of_place_52_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_52_0 * over_cos_omega),
            beta_rate_dot_of_place_51_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_53_1 = m6_by_zf * beta_rate_dot_of_place_11_1
        + beta_rate_dot_of_place_52_1;
    let beta_rate_dot_of_place_54_1 = cos_omega_1
        .mul_add(
            -(beta_rate_dot_of_place_54_0 * over_cos_omega),
            beta_rate_dot_of_place_53_1 * over_cos_omega,
        );
    let beta_rate_dot_of_place_55_1 = minus_1_by_e * cos_phi_minus_90deg_1;
    let beta_rate_dot_of_place_56_1 = beta_rate_dot_of_place_55_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_55_0);
    let beta_rate_dot_of_place_57_1 = weight_30 * cos_gamma_minus_delta_1
        + beta_rate_dot_of_place_56_1;
    let beta_rate_dot_of_place_58_1 = beta_rate_dot_of_place_57_1
        .mul_add(
            cos_phi_minus_90deg_0,
            cos_phi_minus_90deg_1 * beta_rate_dot_of_place_57_0,
        );
    let beta_rate_dot_of_place_59_1 = beta_rate_dot_of_place_58_1
        .mul_add(
            m4,
            cos_angle_3_1.mul_add(weight_32, weight_31 * cos_gamma_minus_delta_1),
        );
    let beta_rate_dot_of_place_60_1 = beta_rate_dot_of_place_59_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_59_0);
    let cos_gamma_minus_delta_sq_1 = cos_gamma_minus_delta_1
        * (cos_gamma_minus_delta_0 + cos_gamma_minus_delta_0);
    let beta_rate_dot_of_place_61_1 = weight_33 * cos_gamma_minus_delta_sq_1
        + beta_rate_dot_of_place_60_1;
    let beta_rate_dot_of_place_62_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_62_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_61_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_63_1 = beta_rate_dot_of_place_4_1
        .mul_add(sin_angle_3_0, sin_angle_3_1 * beta_rate_dot_of_place_4_0);
    let beta_rate_dot_of_place_64_1 = m4_by_e * beta_rate_dot_of_place_63_1
        + beta_rate_dot_of_place_62_1;
    let beta_rate_dot_of_place_65_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_65_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_64_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_66_1 = sin_angle_cos_angle_inv_1
        .mul_add(weight_34, minus_1_by_e * cos_angle_3_1);
    let beta_rate_dot_of_place_67_1 = beta_rate_dot_of_place_66_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_66_0);
    let beta_rate_dot_of_place_68_1 = beta_rate_dot_of_place_67_1
        .mul_add(m4, m4_ea_by_e_minus_1_by_ss * sin_angle_3_1) + beta_rate_dot_of_place_65_1;
    let beta_rate_dot_of_place_69_1 = beta_rate_dot_of_place_68_1
        .mul_add(
            cos_phi_minus_90deg_0,
            cos_phi_minus_90deg_1 * beta_rate_dot_of_place_68_0,
        );
    let beta_rate_dot_of_place_70_1 = weight_31 * beta_rate_dot_of_place_13_1;
    let beta_rate_dot_of_place_71_1 = beta_rate_dot_of_place_70_1
        .mul_add(
            sin_gamma_minus_delta_0,
            sin_gamma_minus_delta_1 * beta_rate_dot_of_place_70_0,
        );
    let beta_rate_dot_of_place_72_1 = sin_angle_cos_angle_inv_1
        .mul_add(weight_36, m4_1_minus_ea_by_e_by_e * cos_angle_3_1);
    let beta_rate_dot_of_place_73_1 = beta_rate_dot_of_place_72_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_72_0,
        );
    let beta_rate_dot_of_place_74_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_74_0 * over_sin_phi_minus_90deg),
            sin_angle_3_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_75_1 = beta_rate_dot_of_place_74_1
        .mul_add(weight_37, m4_ea_by_e_minus_1 * cos_angle_3_1);
    let beta_rate_dot_of_place_76_1 = beta_rate_dot_of_place_75_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_75_0);
    let beta_rate_dot_of_place_77_1 = beta_rate_dot_of_place_76_1
        .mul_add(
            minus_1_by_zt,
            beta_rate_dot_of_place_71_1 + beta_rate_dot_of_place_73_1,
        ) + beta_rate_dot_of_place_69_1;
    let beta_rate_dot_of_place_78_1 = beta_rate_dot_of_place_77_1
        .mul_add(
            cos_gamma_minus_delta_0,
            cos_gamma_minus_delta_1 * beta_rate_dot_of_place_77_0,
        );
    let beta_rate_dot_of_place_79_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_79_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_15_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_80_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            cos_phi_minus_90deg_0,
            cos_phi_minus_90deg_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_81_1 = beta_rate_dot_of_place_79_1
        .mul_add(
            weight_38,
            beta_rate_dot_of_place_80_1.mul_add(minus_m4_by_ss, m4_by_zt * cos_angle_3_1),
        );
    let beta_rate_dot_of_place_82_1 = beta_rate_dot_of_place_81_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_81_0);
    let beta_rate_dot_of_place_83_1 = sin_angle_3_1
        .mul_add(cos_phi_minus_90deg_0, cos_phi_minus_90deg_1 * sin_angle_3_0);
    let beta_rate_dot_of_place_84_1 = beta_rate_dot_of_place_83_1
        .mul_add(minus_m4_by_ss, m4_1_minus_ea_by_e_by_ss * sin_gamma_minus_delta_1)
        + beta_rate_dot_of_place_82_1;
    let beta_rate_dot_of_place_85_1 = beta_rate_dot_of_place_84_1
        .mul_add(
            cos_phi_minus_90deg_0,
            cos_phi_minus_90deg_1 * beta_rate_dot_of_place_84_0,
        );
    let beta_rate_dot_of_place_86_1 = sin_angle_cos_angle_inv_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * sin_angle_cos_angle_inv_0);
    let beta_rate_dot_of_place_87_1 = beta_rate_dot_of_place_86_1
        .mul_add(weight_39, weight_39 * sin_angle_3_1) + beta_rate_dot_of_place_85_1;
    let beta_rate_dot_of_place_88_1 = beta_rate_dot_of_place_87_1
        .mul_add(cos_angle_3_0, cos_angle_3_1 * beta_rate_dot_of_place_87_0);
    let beta_rate_dot_of_place_89_1 = -beta_rate_dot_of_place_88_1 + beta_rate_dot_of_place_78_1;
    let beta_rate_dot_of_place_90_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_90_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_89_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_91_1 = m4_by_e * beta_rate_dot_of_place_16_1
        + beta_rate_dot_of_place_90_1;
    let beta_rate_dot_of_place_92_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(beta_rate_dot_of_place_92_0 * over_sin_phi_minus_90deg),
            beta_rate_dot_of_place_91_1 * over_sin_phi_minus_90deg,
        );
    let beta_rate_dot_of_place_93_1 = beta_rate_dot_of_place_5_1
        .mul_add(
            sin_angle_cos_angle_inv_0,
            sin_angle_cos_angle_inv_1 * beta_rate_dot_of_place_5_0,
        );
    let beta_rate_dot_of_place_94_1 = beta_rate_dot_of_place_93_1
        .mul_add(
            minus_1_by_ss,
            cos_angle_2_sin_angle_2_1
                .mul_add(minus_m6_by_ss, minus_m4_by_ss * cos_angle_3_sin_angle_3_1),
        ) + beta_rate_dot_of_place_54_1 - beta_rate_dot_of_place_92_1;
    let beta_rate_dot_of_place_95_1 = beta_rate_dot_of_place_94_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_94_0);
    let beta_rate_dot_of_place_96_1 = cos_angle_2_sq_1
        .mul_add(
            beta_rate_dot_of_place_7_0,
            beta_rate_dot_of_place_7_1 * cos_angle_2_sq_0,
        );
    let beta_rate_dot_of_place_97_1 = beta_rate_dot_of_place_96_1 + d1_of_place_6_1;
    let beta_rate_dot_of_place_98_1 = cos_omega_sq_1
        .mul_add(
            -(beta_rate_dot_of_place_98_0 * over_cos_omega_sq),
            beta_rate_dot_of_place_97_1 * over_cos_omega_sq,
        );
    let beta_rate_dot_of_place_99_1 = cos_angle_3_sq_1
        .mul_add(
            beta_rate_dot_of_place_12_0,
            beta_rate_dot_of_place_12_1 * cos_angle_3_sq_0,
        );
    let beta_rate_dot_of_place_100_1 = beta_rate_dot_of_place_99_1 + d1_of_place_11_1;
    let beta_rate_dot_of_place_101_1 = sin_phi_minus_90deg_sq_1
        .mul_add(
            -(beta_rate_dot_of_place_101_0 * over_sin_phi_minus_90deg_sq),
            beta_rate_dot_of_place_100_1 * over_sin_phi_minus_90deg_sq,
        );
    let beta_rate_dot_of_place_102_1 = cos_angle_2_sq_1
        .mul_add(m6, m4 * cos_angle_3_sq_1) + beta_rate_dot_of_place_98_1
        + beta_rate_dot_of_place_101_1;
    let beta_rate_dot_of_place_103_1 = sin_angle_cos_angle_inv_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * sin_angle_cos_angle_inv_0,
        );
    let beta_rate_dot_of_place_104_1 = beta_rate_dot_of_place_102_1
        .mul_add(
            beta_rate_dot_of_place_103_0,
            beta_rate_dot_of_place_103_1 * beta_rate_dot_of_place_102_0,
        );
    let beta_rate_dot_of_place_105_1 = weight_40 * beta_rate_dot_of_place_104_1
        + beta_rate_dot_of_place_95_1;
    let beta_rate_dot_of_place_106_1 = beta_rate_dot_of_place_105_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_place_105_0);
    let beta_rate_dot_of_place_107_1 = cos_angle_2_sq_1
        .mul_add(m6, cos_angle_3_sq_1.mul_add(m4, m2_da_by_ss * sin_angle_1))
        + beta_rate_dot_of_place_98_1 + beta_rate_dot_of_place_101_1;
    let beta_rate_dot_of_place_108_1 = beta_rate_dot_of_place_107_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_107_0);
    let beta_rate_dot_of_place_109_1 = beta_rate_dot_of_place_103_1
        .mul_add(weight_41, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma_1)
        + beta_rate_dot_of_place_108_1;
    let beta_rate_dot_of_place_110_1 = beta_rate_dot_of_place_109_1
        .mul_add(
            cos_beta_minus_gamma_0,
            cos_beta_minus_gamma_1 * beta_rate_dot_of_place_109_0,
        );
    let beta_rate_dot_of_place_111_1 = weight_40 * beta_rate_dot_of_place_110_1
        + beta_rate_dot_of_place_106_1;
    let beta_rate_dot_of_place_112_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_112_0 * over_cos_angle),
            beta_rate_dot_of_place_111_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_113_1 = cos_angle_2_sq_1
        .mul_add(
            m6,
            cos_angle_3_sq_1.mul_add(m4, m2_da_rr_by_d_ss * sin_beta_minus_gamma_1),
        ) + beta_rate_dot_of_place_98_1 + beta_rate_dot_of_place_101_1;
    let beta_rate_dot_of_place_114_1 = beta_rate_dot_of_place_113_1
        .mul_add(cos_theta_0, cos_theta_1 * beta_rate_dot_of_place_113_0);
    let beta_rate_dot_of_place_115_1 = beta_rate_dot_of_place_112_1
        .mul_add(
            rr,
            m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq_1 - beta_rate_dot_of_place_114_1,
        );
    let beta_rate_dot_of_place_116_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_116_0 * over_cos_angle),
            beta_rate_dot_of_place_115_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_117_1 = m2_da_by_d * cos_beta_minus_gamma_1
        - beta_rate_dot_of_place_116_1;
    let beta_rate_sq_1 = beta_rate_1 * (beta_rate_0 + beta_rate_0);
    let beta_rate_dot_of_beta_rate_1 = beta_rate_dot_of_place_117_1
        .mul_add(beta_rate_sq_0, beta_rate_sq_1 * beta_rate_dot_of_place_117_0);
    let beta_rate_dot_of_place_118_1 = sb_sc_minus_sa_sd * sin_gamma_1;
    let beta_rate_dot_of_place_119_1 = beta_rate_dot_of_place_118_1
        .mul_add(sin_gamma_0, sin_gamma_1 * beta_rate_dot_of_place_118_0);
    let beta_rate_dot_of_place_120_1 = sb_sc_minus_sa_sd * cos_gamma_1;
    let beta_rate_dot_of_place_121_1 = beta_rate_dot_of_place_120_1
        .mul_add(cos_gamma_0, cos_gamma_1 * beta_rate_dot_of_place_120_0);
    let beta_rate_dot_of_place_122_1 = beta_rate_dot_of_place_119_1 + beta_rate_dot_of_place_121_1;
    let beta_rate_dot_of_place_123_1 = beta_rate_dot_of_place_122_1
        .mul_add(
            beta_rate_dot_of_place_2_0,
            beta_rate_dot_of_place_2_1 * beta_rate_dot_of_place_122_0,
        );
    let beta_rate_dot_of_place_124_1 = beta_rate_dot_of_place_121_1
        .mul_add(minus_l0, minus_l0 * beta_rate_dot_of_place_119_1) + beta_rate_dot_of_place_123_1;
    let beta_rate_dot_of_place_125_1 = beta_rate_dot_of_place_1
        .mul_add(
            -(beta_rate_dot_of_place_125_0 * over_beta_rate_dot_of_place),
            beta_rate_dot_of_place_2_1 * over_beta_rate_dot_of_place,
        );
    let beta_rate_dot_of_place_126_1 = beta_rate_dot_of_place_124_1
        .mul_add(
            beta_rate_dot_of_place_125_0,
            beta_rate_dot_of_place_125_1 * beta_rate_dot_of_place_124_0,
        );
    let beta_rate_dot_of_beta_rate_2_1 = beta_rate_dot_of_beta_rate_1
        .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_126_1);
    let beta_rate_dot_of_beta_rate_3_1 = beta_rate_dot_of_beta_rate_2_1
        .mul_add(sin_theta_0, sin_theta_1 * beta_rate_dot_of_beta_rate_2_0);
    let beta_rate_dot_of_place_127_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_place_127_0 * over_cos_angle),
            cos_beta_minus_gamma_1 * over_cos_angle,
        );
    let beta_rate_dot_of_place_128_1 = beta_rate_dot_of_place_127_1
        .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta_1);
    let beta_rate_dot_of_place_129_1 = beta_rate_dot_of_place_103_1
        .mul_add(
            beta_rate_dot_of_place_128_0,
            beta_rate_dot_of_place_128_1 * beta_rate_dot_of_place_103_0,
        );
    let beta_rate_dot_of_place_130_1 = beta_rate_dot_of_place_129_1
        .mul_add(rr, minus_i2_minus_m2_da_2 * sin_beta_minus_gamma_1);
    let beta_rate_dot_of_place_131_1 = beta_rate_dot_of_place_130_1
        .mul_add(
            beta_rate_dot_of_place_127_0,
            beta_rate_dot_of_place_127_1 * beta_rate_dot_of_place_130_0,
        );
    let beta_rate_dot_of_place_132_1 = beta_rate_dot_of_place_131_1
        .mul_add(weight_40, m2_da * beta_rate_dot_of_place_6_1);
    let beta_rate_dot_of_beta_rate_4_1 = beta_rate_dot_of_place_132_1
        .mul_add(beta_rate_sq_0, beta_rate_sq_1 * beta_rate_dot_of_place_132_0);
    let beta_rate_dot_of_beta_rate_5_1 = minus_rr_by_d * beta_rate_dot_of_beta_rate_4_1
        + beta_rate_dot_of_beta_rate_3_1;
    let beta_rate_dot_of_beta_rate_6_1 = cos_angle_1
        .mul_add(
            -(beta_rate_dot_of_beta_rate_6_0 * over_cos_angle),
            beta_rate_dot_of_beta_rate_5_1 * over_cos_angle,
        );
    let beta_rate_dot_of_beta_rate_7_1 = rr * beta_rate_dot_of_beta_rate_6_1;
    let beta_rate_dot_2_1 = d1_of_place_20_1
        .mul_add(
            -(beta_rate_dot_2_0 * over_d1_of_place_20),
            beta_rate_dot_of_beta_rate_7_1 * over_d1_of_place_20,
        );
    let theta_of_place_1 = rr_by_d * beta_rate_dot_of_place_127_1;
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
            beta_rate_dot_of_place_13_0,
            beta_rate_dot_of_place_13_1 * gamma_of_beta_rate_0,
        );
    let phi_minus_90deg_of_place_1 = cos_angle_3_1
        .mul_add(weight_38, weight_44 * cos_gamma_minus_delta_1);
    let phi_minus_90deg_of_place_2_1 = sin_phi_minus_90deg_1
        .mul_add(
            -(phi_minus_90deg_of_place_2_0 * over_sin_phi_minus_90deg),
            phi_minus_90deg_of_place_1 * over_sin_phi_minus_90deg,
        );
    let phi_minus_90deg_of_beta_rate_1 = phi_minus_90deg_of_place_2_1
        .mul_add(
            gamma_of_beta_rate_0,
            gamma_of_beta_rate_1 * phi_minus_90deg_of_place_2_0,
        );
    let epsilon_of_beta_rate_1 = gamma_of_beta_rate_1
        .mul_add(
            beta_rate_dot_of_place_8_0,
            beta_rate_dot_of_place_8_1 * gamma_of_beta_rate_0,
        );
    let omega_of_place_1 = sin_gamma_minus_epsilon_1
        .mul_add(minus_1_by_zf, weight_27 * cos_angle_2_1);
    let omega_of_place_2_1 = cos_omega_1
        .mul_add(
            -(omega_of_place_2_0 * over_cos_omega),
            omega_of_place_1 * over_cos_omega,
        );
    let omega_of_beta_rate_1 = omega_of_place_2_1
        .mul_add(gamma_of_beta_rate_0, gamma_of_beta_rate_1 * omega_of_place_2_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, omega_1, omega_1, d1_of_place_1, d1_of_place_1,
                beta_minus_gamma_1, beta_minus_gamma_1, gamma_minus_delta_1, gamma_minus_delta_1,
                gamma_minus_epsilon_1, gamma_minus_epsilon_1, d1_of_place_2_1, d1_of_place_2_1,
                cos_beta_minus_gamma_1, cos_theta_1, phi_minus_90deg_1, phi_minus_90deg_1,
                d1_of_place_4_1, d1_of_place_4_1, sin_omega_1, sin_gamma_minus_epsilon_1,
                cos_angle_2_1, cos_omega_1, cos_omega_sq_1, cos_phi_minus_90deg_1,
                cos_gamma_minus_delta_1, cos_angle_3_1, sin_phi_minus_90deg_1,
                sin_phi_minus_90deg_sq_1, sin_theta_1, d1_of_place_14_1, cos_angle_1, cos_angle_1,
                gamma_1, gamma_1, beta_rate_dot_of_place_2_1, cos_theta_1, sin_omega_1, cos_omega_1,
                beta_rate_dot_of_place_7_1, cos_angle_2_1, sin_gamma_minus_epsilon_1,
                cos_phi_minus_90deg_1, sin_phi_minus_90deg_1, beta_rate_dot_of_place_12_1,
                cos_angle_3_1, cos_gamma_minus_delta_1, cos_angle_2_1, sin_omega_1, cos_angle_2_1,
                sin_gamma_minus_epsilon_1, cos_omega_1, sin_angle_2_1, cos_omega_1, cos_angle_1,
                cos_angle_2_1, sin_omega_1, cos_gamma_minus_epsilon_1, sin_gamma_minus_epsilon_1,
                cos_omega_1, cos_angle_2_1, sin_gamma_minus_epsilon_1, cos_omega_1, sin_omega_1,
                cos_angle_2_1, sin_omega_1, sin_omega_1, cos_angle_2_1, cos_angle_2_1, cos_omega_1,
                cos_omega_1, cos_angle_3_1, cos_phi_minus_90deg_1, cos_angle_3_1,
                cos_gamma_minus_delta_1, sin_phi_minus_90deg_1, sin_angle_3_1,
                sin_phi_minus_90deg_1, cos_angle_3_1, cos_phi_minus_90deg_1,
                sin_gamma_minus_delta_1, cos_gamma_minus_delta_1, sin_phi_minus_90deg_1,
                cos_angle_3_1, cos_gamma_minus_delta_1, sin_phi_minus_90deg_1,
                cos_phi_minus_90deg_1, cos_angle_3_1, cos_phi_minus_90deg_1, cos_phi_minus_90deg_1,
                cos_angle_3_1, cos_angle_3_1, sin_phi_minus_90deg_1, sin_phi_minus_90deg_1,
                beta_rate_dot_of_place_5_1, sin_theta_1, beta_rate_dot_of_place_7_1, cos_omega_sq_1,
                beta_rate_dot_of_place_12_1, sin_phi_minus_90deg_sq_1, cos_beta_minus_gamma_1,
                beta_rate_dot_of_place_102_1, sin_theta_1, cos_theta_1, cos_beta_minus_gamma_1,
                cos_angle_1, cos_theta_1, cos_angle_1, beta_rate_1, beta_rate_dot_of_place_117_1,
                sin_gamma_1, cos_gamma_1, beta_rate_dot_of_place_2_1, beta_rate_dot_of_place_1,
                beta_rate_dot_of_place_124_1, sin_theta_1, cos_angle_1,
                beta_rate_dot_of_place_128_1, beta_rate_dot_of_place_130_1,
                beta_rate_dot_of_place_132_1, cos_angle_1, d1_of_place_20_1, beta_rate_1,
                beta_rate_1, cos_angle_1, gamma_of_beta_rate_1, sin_phi_minus_90deg_1,
                gamma_of_beta_rate_1, gamma_of_beta_rate_1, cos_omega_1, gamma_of_beta_rate_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, cos_omega_1, sin_omega_1, cos_angle_1, sin_angle_1,
                cos_beta_minus_gamma_1, sin_beta_minus_gamma_1, cos_gamma_minus_delta_1,
                sin_gamma_minus_delta_1, cos_gamma_minus_epsilon_1, sin_gamma_minus_epsilon_1,
                cos_angle_2_1, sin_angle_2_1, cos_beta_minus_gamma_1, cos_beta_minus_gamma_1,
                cos_phi_minus_90deg_1, sin_phi_minus_90deg_1, cos_angle_3_1, sin_angle_3_1,
                cos_angle_2_1, d1_of_place_5_1, cos_angle_2_1, cos_omega_1, d1_of_place_8_1,
                cos_angle_3_1, d1_of_place_10_1, cos_angle_3_1, sin_phi_minus_90deg_1,
                d1_of_place_13_1, sin_theta_1, sin_theta_sq_1, d1_of_place_17_1, d1_of_place_19_1,
                cos_gamma_1, sin_gamma_1, beta_rate_dot_of_place_2_1, sin_beta_minus_gamma_1,
                sin_omega_1, beta_rate_dot_of_place_8_1, beta_rate_dot_of_place_8_1, sin_angle_2_1,
                cos_angle_2_sin_angle_2_1, cos_phi_minus_90deg_1, beta_rate_dot_of_place_13_1,
                beta_rate_dot_of_place_13_1, sin_angle_3_1, cos_angle_3_sin_angle_3_1,
                beta_rate_dot_of_place_17_1, beta_rate_dot_of_place_19_1,
                beta_rate_dot_of_place_21_1, sin_gamma_minus_epsilon_1, beta_rate_dot_of_place_25_1,
                beta_rate_dot_of_place_3_1, beta_rate_dot_of_place_28_1, sin_angle_cos_angle_inv_1,
                beta_rate_dot_of_place_29_1, beta_rate_dot_of_place_31_1,
                beta_rate_dot_of_place_33_1, beta_rate_dot_of_place_35_1,
                beta_rate_dot_of_place_37_1, beta_rate_dot_of_place_38_1,
                beta_rate_dot_of_place_40_1, beta_rate_dot_of_place_42_1, sin_angle_cos_angle_inv_1,
                beta_rate_dot_of_place_44_1, sin_angle_2_1, beta_rate_dot_of_place_46_1,
                sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_49_1, beta_rate_dot_of_place_52_1,
                beta_rate_dot_of_place_54_1, beta_rate_dot_of_place_55_1,
                beta_rate_dot_of_place_57_1, beta_rate_dot_of_place_59_1, cos_gamma_minus_delta_1,
                beta_rate_dot_of_place_62_1, beta_rate_dot_of_place_4_1,
                beta_rate_dot_of_place_65_1, beta_rate_dot_of_place_66_1,
                beta_rate_dot_of_place_68_1, beta_rate_dot_of_place_70_1,
                beta_rate_dot_of_place_72_1, beta_rate_dot_of_place_74_1,
                beta_rate_dot_of_place_75_1, beta_rate_dot_of_place_77_1,
                beta_rate_dot_of_place_79_1, sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_81_1,
                sin_angle_3_1, beta_rate_dot_of_place_84_1, sin_angle_cos_angle_inv_1,
                beta_rate_dot_of_place_87_1, beta_rate_dot_of_place_90_1,
                beta_rate_dot_of_place_92_1, sin_angle_cos_angle_inv_1, beta_rate_dot_of_place_94_1,
                cos_angle_2_sq_1, beta_rate_dot_of_place_98_1, cos_angle_3_sq_1,
                beta_rate_dot_of_place_101_1, sin_angle_cos_angle_inv_1,
                beta_rate_dot_of_place_103_1, beta_rate_dot_of_place_105_1,
                beta_rate_dot_of_place_107_1, beta_rate_dot_of_place_109_1,
                beta_rate_dot_of_place_112_1, beta_rate_dot_of_place_113_1,
                beta_rate_dot_of_place_116_1, beta_rate_1, beta_rate_sq_1,
                beta_rate_dot_of_place_118_1, beta_rate_dot_of_place_120_1,
                beta_rate_dot_of_place_122_1, beta_rate_dot_of_place_125_1,
                beta_rate_dot_of_place_125_1, beta_rate_dot_of_beta_rate_2_1,
                beta_rate_dot_of_place_127_1, beta_rate_dot_of_place_103_1,
                beta_rate_dot_of_place_127_1, beta_rate_sq_1, beta_rate_dot_of_beta_rate_6_1,
                beta_rate_dot_2_1, theta_of_place_1, sin_theta_1, gamma_of_beta_rate_1,
                beta_rate_dot_of_place_13_1, phi_minus_90deg_of_place_2_1,
                phi_minus_90deg_of_place_2_1, beta_rate_dot_of_place_8_1, omega_of_place_2_1,
                omega_of_place_2_1,
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
    let mut gamma_minus_epsilon_last = gamma_minus_epsilon_1;
    let mut sin_gamma_minus_epsilon_last = sin_gamma_minus_epsilon_1;
    let mut cos_gamma_minus_epsilon_last = cos_gamma_minus_epsilon_1;
    let mut d1_of_place_2_last = d1_of_place_2_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut sin_phi_minus_90deg_last = sin_phi_minus_90deg_1;
    let mut cos_phi_minus_90deg_last = cos_phi_minus_90deg_1;
    let mut d1_of_place_4_last = d1_of_place_4_1;
    let mut sin_angle_3_last = sin_angle_3_1;
    let mut cos_angle_3_last = cos_angle_3_1;
    let mut d1_of_place_5_last = d1_of_place_5_1;
    let mut cos_angle_2_sq_last = cos_angle_2_sq_1;
    let mut cos_omega_sq_last = cos_omega_sq_1;
    let mut d1_of_place_8_last = d1_of_place_8_1;
    let mut d1_of_place_10_last = d1_of_place_10_1;
    let mut cos_angle_3_sq_last = cos_angle_3_sq_1;
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
    let mut beta_rate_dot_of_place_7_last = beta_rate_dot_of_place_7_1;
    let mut beta_rate_dot_of_place_8_last = beta_rate_dot_of_place_8_1;
    let mut cos_angle_2_sin_angle_2_last = cos_angle_2_sin_angle_2_1;
    let mut beta_rate_dot_of_place_12_last = beta_rate_dot_of_place_12_1;
    let mut beta_rate_dot_of_place_13_last = beta_rate_dot_of_place_13_1;
    let mut cos_angle_3_sin_angle_3_last = cos_angle_3_sin_angle_3_1;
    let mut beta_rate_dot_of_place_17_last = beta_rate_dot_of_place_17_1;
    let mut beta_rate_dot_of_place_19_last = beta_rate_dot_of_place_19_1;
    let mut beta_rate_dot_of_place_21_last = beta_rate_dot_of_place_21_1;
    let mut beta_rate_dot_of_place_25_last = beta_rate_dot_of_place_25_1;
    let mut beta_rate_dot_of_place_28_last = beta_rate_dot_of_place_28_1;
    let mut sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv_1;
    let mut beta_rate_dot_of_place_29_last = beta_rate_dot_of_place_29_1;
    let mut beta_rate_dot_of_place_31_last = beta_rate_dot_of_place_31_1;
    let mut beta_rate_dot_of_place_33_last = beta_rate_dot_of_place_33_1;
    let mut beta_rate_dot_of_place_35_last = beta_rate_dot_of_place_35_1;
    let mut beta_rate_dot_of_place_37_last = beta_rate_dot_of_place_37_1;
    let mut beta_rate_dot_of_place_38_last = beta_rate_dot_of_place_38_1;
    let mut beta_rate_dot_of_place_40_last = beta_rate_dot_of_place_40_1;
    let mut beta_rate_dot_of_place_42_last = beta_rate_dot_of_place_42_1;
    let mut beta_rate_dot_of_place_44_last = beta_rate_dot_of_place_44_1;
    let mut beta_rate_dot_of_place_46_last = beta_rate_dot_of_place_46_1;
    let mut beta_rate_dot_of_place_49_last = beta_rate_dot_of_place_49_1;
    let mut beta_rate_dot_of_place_52_last = beta_rate_dot_of_place_52_1;
    let mut beta_rate_dot_of_place_54_last = beta_rate_dot_of_place_54_1;
    let mut beta_rate_dot_of_place_55_last = beta_rate_dot_of_place_55_1;
    let mut beta_rate_dot_of_place_57_last = beta_rate_dot_of_place_57_1;
    let mut beta_rate_dot_of_place_59_last = beta_rate_dot_of_place_59_1;
    let mut beta_rate_dot_of_place_62_last = beta_rate_dot_of_place_62_1;
    let mut beta_rate_dot_of_place_65_last = beta_rate_dot_of_place_65_1;
    let mut beta_rate_dot_of_place_66_last = beta_rate_dot_of_place_66_1;
    let mut beta_rate_dot_of_place_68_last = beta_rate_dot_of_place_68_1;
    let mut beta_rate_dot_of_place_70_last = beta_rate_dot_of_place_70_1;
    let mut beta_rate_dot_of_place_72_last = beta_rate_dot_of_place_72_1;
    let mut beta_rate_dot_of_place_74_last = beta_rate_dot_of_place_74_1;
    let mut beta_rate_dot_of_place_75_last = beta_rate_dot_of_place_75_1;
    let mut beta_rate_dot_of_place_77_last = beta_rate_dot_of_place_77_1;
    let mut beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79_1;
    let mut beta_rate_dot_of_place_81_last = beta_rate_dot_of_place_81_1;
    let mut beta_rate_dot_of_place_84_last = beta_rate_dot_of_place_84_1;
    let mut beta_rate_dot_of_place_87_last = beta_rate_dot_of_place_87_1;
    let mut beta_rate_dot_of_place_90_last = beta_rate_dot_of_place_90_1;
    let mut beta_rate_dot_of_place_92_last = beta_rate_dot_of_place_92_1;
    let mut beta_rate_dot_of_place_94_last = beta_rate_dot_of_place_94_1;
    let mut beta_rate_dot_of_place_98_last = beta_rate_dot_of_place_98_1;
    let mut beta_rate_dot_of_place_101_last = beta_rate_dot_of_place_101_1;
    let mut beta_rate_dot_of_place_102_last = beta_rate_dot_of_place_102_1;
    let mut beta_rate_dot_of_place_103_last = beta_rate_dot_of_place_103_1;
    let mut beta_rate_dot_of_place_105_last = beta_rate_dot_of_place_105_1;
    let mut beta_rate_dot_of_place_107_last = beta_rate_dot_of_place_107_1;
    let mut beta_rate_dot_of_place_109_last = beta_rate_dot_of_place_109_1;
    let mut beta_rate_dot_of_place_112_last = beta_rate_dot_of_place_112_1;
    let mut beta_rate_dot_of_place_113_last = beta_rate_dot_of_place_113_1;
    let mut beta_rate_dot_of_place_116_last = beta_rate_dot_of_place_116_1;
    let mut beta_rate_dot_of_place_117_last = beta_rate_dot_of_place_117_1;
    let mut beta_rate_sq_last = beta_rate_sq_1;
    let mut beta_rate_dot_of_place_118_last = beta_rate_dot_of_place_118_1;
    let mut beta_rate_dot_of_place_120_last = beta_rate_dot_of_place_120_1;
    let mut beta_rate_dot_of_place_122_last = beta_rate_dot_of_place_122_1;
    let mut beta_rate_dot_of_place_124_last = beta_rate_dot_of_place_124_1;
    let mut beta_rate_dot_of_place_125_last = beta_rate_dot_of_place_125_1;
    let mut beta_rate_dot_of_beta_rate_2_last = beta_rate_dot_of_beta_rate_2_1;
    let mut beta_rate_dot_of_place_127_last = beta_rate_dot_of_place_127_1;
    let mut beta_rate_dot_of_place_128_last = beta_rate_dot_of_place_128_1;
    let mut beta_rate_dot_of_place_130_last = beta_rate_dot_of_place_130_1;
    let mut beta_rate_dot_of_place_132_last = beta_rate_dot_of_place_132_1;
    let mut beta_rate_dot_of_beta_rate_6_last = beta_rate_dot_of_beta_rate_6_1;
    let mut beta_rate_dot_2_last = beta_rate_dot_2_1;
    let mut theta_of_place_last = theta_of_place_1;
    let mut gamma_of_beta_rate_last = gamma_of_beta_rate_1;
    let mut phi_minus_90deg_of_place_2_last = phi_minus_90deg_of_place_2_1;
    let mut omega_of_place_2_last = omega_of_place_2_1;
    let mut next = [S::int(0); 136];
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
                gamma_minus_epsilon_1
                    .mul_add(
                        cos_gamma_minus_epsilon_last,
                        (count_last * gamma_minus_epsilon_last)
                            .mul_add(cos_gamma_minus_epsilon_1, next[10]),
                    ),
                gamma_minus_epsilon_1
                    .mul_add(
                        sin_gamma_minus_epsilon_last,
                        (count_last * gamma_minus_epsilon_last)
                            .mul_add(sin_gamma_minus_epsilon_1, next[11]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        cos_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(cos_angle_2_1, next[12]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        sin_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(sin_angle_2_1, next[13]),
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
                cos_theta_1
                    .mul_add(
                        sin_beta_minus_gamma_last,
                        cos_theta_last.mul_add(sin_beta_minus_gamma_1, next[37]),
                    ),
                (sin_omega_1 + sin_omega_1).mul_add(sin_omega_last, next[38]),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_8_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_8_1, next[39]),
                    ),
                beta_rate_dot_of_place_7_1
                    .mul_add(
                        beta_rate_dot_of_place_8_last,
                        beta_rate_dot_of_place_7_last
                            .mul_add(beta_rate_dot_of_place_8_1, next[40]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        sin_angle_2_last,
                        cos_angle_2_last.mul_add(sin_angle_2_1, next[41]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        cos_angle_2_sin_angle_2_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(cos_angle_2_sin_angle_2_1, next[42]),
                    ),
                (cos_phi_minus_90deg_1 + cos_phi_minus_90deg_1)
                    .mul_add(cos_phi_minus_90deg_last, next[43]),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_13_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_13_1, next[44]),
                    ),
                beta_rate_dot_of_place_12_1
                    .mul_add(
                        beta_rate_dot_of_place_13_last,
                        beta_rate_dot_of_place_12_last
                            .mul_add(beta_rate_dot_of_place_13_1, next[45]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        sin_angle_3_last,
                        cos_angle_3_last.mul_add(sin_angle_3_1, next[46]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        cos_angle_3_sin_angle_3_last,
                        cos_gamma_minus_delta_last
                            .mul_add(cos_angle_3_sin_angle_3_1, next[47]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_17_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_17_1, next[48]),
                    ),
                sin_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_19_last,
                        sin_omega_last.mul_add(beta_rate_dot_of_place_19_1, next[49]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_21_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_21_1, next[50]),
                    ),
                (sin_gamma_minus_epsilon_1 + sin_gamma_minus_epsilon_1)
                    .mul_add(sin_gamma_minus_epsilon_last, next[51]),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_25_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_25_1, next[52]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_3_last,
                        sin_angle_2_last.mul_add(beta_rate_dot_of_place_3_1, next[53]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_28_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_28_1, next[54]),
                    ),
                cos_angle_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_last.mul_add(sin_angle_cos_angle_inv_1, next[55]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_29_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_29_1, next[56]),
                    ),
                sin_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_31_last,
                        sin_omega_last.mul_add(beta_rate_dot_of_place_31_1, next[57]),
                    ),
                cos_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_33_last,
                        cos_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_33_1, next[58]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_35_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_35_1, next[59]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_37_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_37_1, next[60]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_38_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_38_1, next[61]),
                    ),
                sin_gamma_minus_epsilon_1
                    .mul_add(
                        beta_rate_dot_of_place_40_last,
                        sin_gamma_minus_epsilon_last
                            .mul_add(beta_rate_dot_of_place_40_1, next[62]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_42_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_42_1, next[63]),
                    ),
                sin_omega_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        sin_omega_last.mul_add(sin_angle_cos_angle_inv_1, next[64]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_44_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_44_1, next[65]),
                    ),
                sin_omega_1
                    .mul_add(
                        sin_angle_2_last,
                        sin_omega_last.mul_add(sin_angle_2_1, next[66]),
                    ),
                sin_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_46_last,
                        sin_omega_last.mul_add(beta_rate_dot_of_place_46_1, next[67]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_2_last.mul_add(sin_angle_cos_angle_inv_1, next[68]),
                    ),
                cos_angle_2_1
                    .mul_add(
                        beta_rate_dot_of_place_49_last,
                        cos_angle_2_last.mul_add(beta_rate_dot_of_place_49_1, next[69]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_52_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_52_1, next[70]),
                    ),
                cos_omega_1
                    .mul_add(
                        beta_rate_dot_of_place_54_last,
                        cos_omega_last.mul_add(beta_rate_dot_of_place_54_1, next[71]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_55_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_55_1, next[72]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_57_last,
                        cos_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_57_1, next[73]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_59_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_59_1, next[74]),
                    ),
                (cos_gamma_minus_delta_1 + cos_gamma_minus_delta_1)
                    .mul_add(cos_gamma_minus_delta_last, next[75]),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_62_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_62_1, next[76]),
                    ),
                sin_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_4_last,
                        sin_angle_3_last.mul_add(beta_rate_dot_of_place_4_1, next[77]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_65_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_65_1, next[78]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_66_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_66_1, next[79]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_68_last,
                        cos_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_68_1, next[80]),
                    ),
                sin_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_70_last,
                        sin_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_70_1, next[81]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_72_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_72_1, next[82]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_74_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_74_1, next[83]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_75_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_75_1, next[84]),
                    ),
                cos_gamma_minus_delta_1
                    .mul_add(
                        beta_rate_dot_of_place_77_last,
                        cos_gamma_minus_delta_last
                            .mul_add(beta_rate_dot_of_place_77_1, next[85]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_79_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_79_1, next[86]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_phi_minus_90deg_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[87]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_81_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_81_1, next[88]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        sin_angle_3_last,
                        cos_phi_minus_90deg_last.mul_add(sin_angle_3_1, next[89]),
                    ),
                cos_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_84_last,
                        cos_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_84_1, next[90]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_angle_3_last.mul_add(sin_angle_cos_angle_inv_1, next[91]),
                    ),
                cos_angle_3_1
                    .mul_add(
                        beta_rate_dot_of_place_87_last,
                        cos_angle_3_last.mul_add(beta_rate_dot_of_place_87_1, next[92]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_90_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_90_1, next[93]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        beta_rate_dot_of_place_92_last,
                        sin_phi_minus_90deg_last
                            .mul_add(beta_rate_dot_of_place_92_1, next[94]),
                    ),
                beta_rate_dot_of_place_5_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        beta_rate_dot_of_place_5_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[95]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_94_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_94_1, next[96]),
                    ),
                beta_rate_dot_of_place_7_1
                    .mul_add(
                        cos_angle_2_sq_last,
                        beta_rate_dot_of_place_7_last.mul_add(cos_angle_2_sq_1, next[97]),
                    ),
                cos_omega_sq_1
                    .mul_add(
                        beta_rate_dot_of_place_98_last,
                        cos_omega_sq_last.mul_add(beta_rate_dot_of_place_98_1, next[98]),
                    ),
                beta_rate_dot_of_place_12_1
                    .mul_add(
                        cos_angle_3_sq_last,
                        beta_rate_dot_of_place_12_last
                            .mul_add(cos_angle_3_sq_1, next[99]),
                    ),
                sin_phi_minus_90deg_sq_1
                    .mul_add(
                        beta_rate_dot_of_place_101_last,
                        sin_phi_minus_90deg_sq_last
                            .mul_add(beta_rate_dot_of_place_101_1, next[100]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        sin_angle_cos_angle_inv_last,
                        cos_beta_minus_gamma_last
                            .mul_add(sin_angle_cos_angle_inv_1, next[101]),
                    ),
                beta_rate_dot_of_place_102_1
                    .mul_add(
                        beta_rate_dot_of_place_103_last,
                        beta_rate_dot_of_place_102_last
                            .mul_add(beta_rate_dot_of_place_103_1, next[102]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_105_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_place_105_1, next[103]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_107_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_107_1, next[104]),
                    ),
                cos_beta_minus_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_109_last,
                        cos_beta_minus_gamma_last
                            .mul_add(beta_rate_dot_of_place_109_1, next[105]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_112_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_112_1, next[106]),
                    ),
                cos_theta_1
                    .mul_add(
                        beta_rate_dot_of_place_113_last,
                        cos_theta_last.mul_add(beta_rate_dot_of_place_113_1, next[107]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_116_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_116_1, next[108]),
                    ),
                (beta_rate_1 + beta_rate_1).mul_add(beta_rate_last, next[109]),
                beta_rate_dot_of_place_117_1
                    .mul_add(
                        beta_rate_sq_last,
                        beta_rate_dot_of_place_117_last
                            .mul_add(beta_rate_sq_1, next[110]),
                    ),
                sin_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_118_last,
                        sin_gamma_last.mul_add(beta_rate_dot_of_place_118_1, next[111]),
                    ),
                cos_gamma_1
                    .mul_add(
                        beta_rate_dot_of_place_120_last,
                        cos_gamma_last.mul_add(beta_rate_dot_of_place_120_1, next[112]),
                    ),
                beta_rate_dot_of_place_2_1
                    .mul_add(
                        beta_rate_dot_of_place_122_last,
                        beta_rate_dot_of_place_2_last
                            .mul_add(beta_rate_dot_of_place_122_1, next[113]),
                    ),
                beta_rate_dot_of_place_1
                    .mul_add(
                        beta_rate_dot_of_place_125_last,
                        beta_rate_dot_of_place_last
                            .mul_add(beta_rate_dot_of_place_125_1, next[114]),
                    ),
                beta_rate_dot_of_place_124_1
                    .mul_add(
                        beta_rate_dot_of_place_125_last,
                        beta_rate_dot_of_place_124_last
                            .mul_add(beta_rate_dot_of_place_125_1, next[115]),
                    ),
                sin_theta_1
                    .mul_add(
                        beta_rate_dot_of_beta_rate_2_last,
                        sin_theta_last.mul_add(beta_rate_dot_of_beta_rate_2_1, next[116]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_place_127_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_place_127_1, next[117]),
                    ),
                beta_rate_dot_of_place_128_1
                    .mul_add(
                        beta_rate_dot_of_place_103_last,
                        beta_rate_dot_of_place_128_last
                            .mul_add(beta_rate_dot_of_place_103_1, next[118]),
                    ),
                beta_rate_dot_of_place_130_1
                    .mul_add(
                        beta_rate_dot_of_place_127_last,
                        beta_rate_dot_of_place_130_last
                            .mul_add(beta_rate_dot_of_place_127_1, next[119]),
                    ),
                beta_rate_dot_of_place_132_1
                    .mul_add(
                        beta_rate_sq_last,
                        beta_rate_dot_of_place_132_last
                            .mul_add(beta_rate_sq_1, next[120]),
                    ),
                cos_angle_1
                    .mul_add(
                        beta_rate_dot_of_beta_rate_6_last,
                        cos_angle_last.mul_add(beta_rate_dot_of_beta_rate_6_1, next[121]),
                    ),
                d1_of_place_20_1
                    .mul_add(
                        beta_rate_dot_2_last,
                        d1_of_place_20_last.mul_add(beta_rate_dot_2_1, next[122]),
                    ),
                beta_rate_1
                    .mul_add(
                        theta_of_place_last,
                        beta_rate_last.mul_add(theta_of_place_1, next[123]),
                    ),
                beta_rate_1
                    .mul_add(
                        sin_theta_last,
                        beta_rate_last.mul_add(sin_theta_1, next[124]),
                    ),
                cos_angle_1
                    .mul_add(
                        gamma_of_beta_rate_last,
                        cos_angle_last.mul_add(gamma_of_beta_rate_1, next[125]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        beta_rate_dot_of_place_13_last,
                        gamma_of_beta_rate_last
                            .mul_add(beta_rate_dot_of_place_13_1, next[126]),
                    ),
                sin_phi_minus_90deg_1
                    .mul_add(
                        phi_minus_90deg_of_place_2_last,
                        sin_phi_minus_90deg_last
                            .mul_add(phi_minus_90deg_of_place_2_1, next[127]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        phi_minus_90deg_of_place_2_last,
                        gamma_of_beta_rate_last
                            .mul_add(phi_minus_90deg_of_place_2_1, next[128]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        beta_rate_dot_of_place_8_last,
                        gamma_of_beta_rate_last
                            .mul_add(beta_rate_dot_of_place_8_1, next[129]),
                    ),
                cos_omega_1
                    .mul_add(
                        omega_of_place_2_last,
                        cos_omega_last.mul_add(omega_of_place_2_1, next[130]),
                    ),
                gamma_of_beta_rate_1
                    .mul_add(
                        omega_of_place_2_last,
                        gamma_of_beta_rate_last.mul_add(omega_of_place_2_1, next[131]),
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
        // gamma_minus_epsilon = gamma - epsilon
        let gamma_minus_epsilon = gamma - epsilon;
        // sin_gamma_minus_epsilon = sin(gamma_minus_epsilon)
        let sin_gamma_minus_epsilon = gamma_minus_epsilon
            .mul_add(cos_gamma_minus_epsilon_0, sums[10] * over_k);
        // cos_gamma_minus_epsilon = cos(gamma_minus_epsilon)
        let cos_gamma_minus_epsilon = -gamma_minus_epsilon
            .mul_add(sin_gamma_minus_epsilon_0, sums[11] * over_k);
        // d1_of_place_2 = gamma - epsilon - omega
        let d1_of_place_2 = gamma - epsilon - omega;
        // sin_angle_2 = sin(d1_of_place_2)
        let sin_angle_2 = d1_of_place_2.mul_add(cos_angle_2_0, sums[12] * over_k);
        // cos_angle_2 = cos(d1_of_place_2)
        let cos_angle_2 = -d1_of_place_2.mul_add(sin_angle_2_0, sums[13] * over_k);
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
        // beta_rate_dot_of_place_3 = fa_by_zf_minus_1*sin_gamma_minus_epsilon + sin_omega_cos_angle_2
        let beta_rate_dot_of_place_3 = fa_by_zf_minus_1 * sin_gamma_minus_epsilon
            + sin_omega_cos_angle_2;
        // beta_rate_dot_of_place_4 = ea_by_e_minus_1*cos_gamma_minus_delta + d1_of_place_9
        let beta_rate_dot_of_place_4 = ea_by_e_minus_1 * cos_gamma_minus_delta + d1_of_place_9;
        // beta_rate_dot_of_place_5 = weight_7 + m4*cos_angle_3_sq + m6*cos_angle_2_sq
        let beta_rate_dot_of_place_5 = cos_angle_2_sq.mul_add(m6, m4 * cos_angle_3_sq);
        // beta_rate_dot_of_place_6 = cos_theta*sin_beta_minus_gamma
        let beta_rate_dot_of_place_6 = sin_beta_minus_gamma
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_beta_minus_gamma_0, sums[37]));
        // sin_omega_sq = sin_omega*sin_omega
        let sin_omega_sq = sin_omega.mul_add(sin_omega_0 + sin_omega_0, sums[38]);
        // beta_rate_dot_of_place_7 = weight_13 + m6*sin_omega_sq
        let beta_rate_dot_of_place_7 = m6 * sin_omega_sq;
        // beta_rate_dot_of_place_8 = cos_angle_2/cos_omega
        let beta_rate_dot_of_place_8 = cos_angle_2
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_8_0, sums[39]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_9 = beta_rate_dot_of_place_7*beta_rate_dot_of_place_8
        let beta_rate_dot_of_place_9 = beta_rate_dot_of_place_8
            .mul_add(
                beta_rate_dot_of_place_7_0,
                beta_rate_dot_of_place_7.mul_add(beta_rate_dot_of_place_8_0, sums[40]),
            );
        // beta_rate_dot_of_place_10 = beta_rate_dot_of_place_9 +
        //   m6_fa_by_zf_minus_1*cos_gamma_minus_epsilon
        let beta_rate_dot_of_place_10 = m6_fa_by_zf_minus_1 * cos_gamma_minus_epsilon
            + beta_rate_dot_of_place_9;
        // cos_angle_2_sin_angle_2 = cos_angle_2*sin_angle_2
        let cos_angle_2_sin_angle_2 = sin_angle_2
            .mul_add(cos_angle_2_0, cos_angle_2.mul_add(sin_angle_2_0, sums[41]));
        // beta_rate_dot_of_place_11 = sin_gamma_minus_epsilon*cos_angle_2_sin_angle_2
        let beta_rate_dot_of_place_11 = cos_angle_2_sin_angle_2
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(cos_angle_2_sin_angle_2_0, sums[42]),
            );
        // cos_phi_minus_90deg_sq = cos_phi_minus_90deg*cos_phi_minus_90deg
        let cos_phi_minus_90deg_sq = cos_phi_minus_90deg
            .mul_add(cos_phi_minus_90deg_0 + cos_phi_minus_90deg_0, sums[43]);
        // beta_rate_dot_of_place_12 = weight_14 + m4*cos_phi_minus_90deg_sq
        let beta_rate_dot_of_place_12 = m4 * cos_phi_minus_90deg_sq;
        // beta_rate_dot_of_place_13 = cos_angle_3/sin_phi_minus_90deg
        let beta_rate_dot_of_place_13 = cos_angle_3
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_13_0, sums[44])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_14 = beta_rate_dot_of_place_12*beta_rate_dot_of_place_13
        let beta_rate_dot_of_place_14 = beta_rate_dot_of_place_13
            .mul_add(
                beta_rate_dot_of_place_12_0,
                beta_rate_dot_of_place_12.mul_add(beta_rate_dot_of_place_13_0, sums[45]),
            );
        // beta_rate_dot_of_place_15 = beta_rate_dot_of_place_14 + m4_ea_by_e_minus_1*sin_gamma_minus_delta
        let beta_rate_dot_of_place_15 = m4_ea_by_e_minus_1 * sin_gamma_minus_delta
            + beta_rate_dot_of_place_14;
        // cos_angle_3_sin_angle_3 = cos_angle_3*sin_angle_3
        let cos_angle_3_sin_angle_3 = sin_angle_3
            .mul_add(cos_angle_3_0, cos_angle_3.mul_add(sin_angle_3_0, sums[46]));
        // beta_rate_dot_of_place_16 = cos_gamma_minus_delta*cos_angle_3_sin_angle_3
        let beta_rate_dot_of_place_16 = cos_angle_3_sin_angle_3
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(cos_angle_3_sin_angle_3_0, sums[47]),
            );
        // beta_rate_dot_of_place_17 = weight_15 + weight_16*sin_omega
        let beta_rate_dot_of_place_17 = weight_16 * sin_omega;
        // beta_rate_dot_of_place_18 = cos_angle_2*beta_rate_dot_of_place_17
        let beta_rate_dot_of_place_18 = beta_rate_dot_of_place_17
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_17_0, sums[48]),
            );
        // beta_rate_dot_of_place_19 = beta_rate_dot_of_place_18 + weight_17*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_19 = weight_17 * sin_gamma_minus_epsilon
            + beta_rate_dot_of_place_18;
        // beta_rate_dot_of_place_20 = sin_omega*beta_rate_dot_of_place_19
        let beta_rate_dot_of_place_20 = beta_rate_dot_of_place_19
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(beta_rate_dot_of_place_19_0, sums[49]),
            );
        // beta_rate_dot_of_place_21 = m6*beta_rate_dot_of_place_20 + weight_18*sin_gamma_minus_epsilon +
        //   weight_19*cos_angle_2
        let beta_rate_dot_of_place_21 = beta_rate_dot_of_place_20
            .mul_add(
                m6,
                cos_angle_2.mul_add(weight_19, weight_18 * sin_gamma_minus_epsilon),
            );
        // beta_rate_dot_of_place_22 = cos_angle_2*beta_rate_dot_of_place_21
        let beta_rate_dot_of_place_22 = beta_rate_dot_of_place_21
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_21_0, sums[50]),
            );
        // beta_rate_dot_of_place_23 = sin_gamma_minus_epsilon*sin_gamma_minus_epsilon
        let beta_rate_dot_of_place_23 = sin_gamma_minus_epsilon
            .mul_add(sin_gamma_minus_epsilon_0 + sin_gamma_minus_epsilon_0, sums[51]);
        // beta_rate_dot_of_place_24 = beta_rate_dot_of_place_22 + weight_20*beta_rate_dot_of_place_23
        let beta_rate_dot_of_place_24 = weight_20 * beta_rate_dot_of_place_23
            + beta_rate_dot_of_place_22;
        // beta_rate_dot_of_place_25 = beta_rate_dot_of_place_24/cos_omega
        let beta_rate_dot_of_place_25 = beta_rate_dot_of_place_24
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_25_0, sums[52]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_26 = sin_angle_2*beta_rate_dot_of_place_3
        let beta_rate_dot_of_place_26 = beta_rate_dot_of_place_3
            .mul_add(
                sin_angle_2_0,
                sin_angle_2.mul_add(beta_rate_dot_of_place_3_0, sums[53]),
            );
        // beta_rate_dot_of_place_27 = beta_rate_dot_of_place_25 + m6_by_zf*beta_rate_dot_of_place_26
        let beta_rate_dot_of_place_27 = m6_by_zf * beta_rate_dot_of_place_26
            + beta_rate_dot_of_place_25;
        // beta_rate_dot_of_place_28 = beta_rate_dot_of_place_27/cos_omega
        let beta_rate_dot_of_place_28 = beta_rate_dot_of_place_27
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_28_0, sums[54]) * over_cos_omega),
            );
        // sin_angle_cos_angle_inv = sin_angle/cos_angle
        let sin_angle_cos_angle_inv = cos_angle
            .mul_add(
                -(sin_angle_cos_angle_inv_0 * over_cos_angle),
                (sin_angle - sums[55]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_29 = weight_21*sin_angle_cos_angle_inv + minus_1_by_zf*cos_angle_2
        let beta_rate_dot_of_place_29 = sin_angle_cos_angle_inv
            .mul_add(weight_21, minus_1_by_zf * cos_angle_2);
        // beta_rate_dot_of_place_30 = cos_angle_2*beta_rate_dot_of_place_29
        let beta_rate_dot_of_place_30 = beta_rate_dot_of_place_29
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_29_0, sums[56]),
            );
        // beta_rate_dot_of_place_31 = beta_rate_dot_of_place_28 + minus_m6*beta_rate_dot_of_place_30 +
        //   weight_22*sin_angle_2
        let beta_rate_dot_of_place_31 = beta_rate_dot_of_place_30
            .mul_add(minus_m6, weight_22 * sin_angle_2) + beta_rate_dot_of_place_28;
        // beta_rate_dot_of_place_32 = sin_omega*beta_rate_dot_of_place_31
        let beta_rate_dot_of_place_32 = beta_rate_dot_of_place_31
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(beta_rate_dot_of_place_31_0, sums[57]),
            );
        // beta_rate_dot_of_place_33 = weight_23 + weight_18*beta_rate_dot_of_place_8
        let beta_rate_dot_of_place_33 = weight_18 * beta_rate_dot_of_place_8;
        // beta_rate_dot_of_place_34 = cos_gamma_minus_epsilon*beta_rate_dot_of_place_33
        let beta_rate_dot_of_place_34 = beta_rate_dot_of_place_33
            .mul_add(
                cos_gamma_minus_epsilon_0,
                cos_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_33_0, sums[58]),
            );
        // beta_rate_dot_of_place_35 = weight_24*sin_angle_cos_angle_inv + weight_25*cos_angle_2
        let beta_rate_dot_of_place_35 = sin_angle_cos_angle_inv
            .mul_add(weight_24, weight_25 * cos_angle_2);
        // beta_rate_dot_of_place_36 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_35
        let beta_rate_dot_of_place_36 = beta_rate_dot_of_place_35
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_35_0, sums[59]),
            );
        // beta_rate_dot_of_place_37 = sin_angle_2/cos_omega
        let beta_rate_dot_of_place_37 = sin_angle_2
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_37_0, sums[60]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_38 = m6_fa_by_zf_minus_1*cos_angle_2 +
        //   weight_26*beta_rate_dot_of_place_37
        let beta_rate_dot_of_place_38 = beta_rate_dot_of_place_37
            .mul_add(weight_26, m6_fa_by_zf_minus_1 * cos_angle_2);
        // beta_rate_dot_of_place_39 = cos_angle_2*beta_rate_dot_of_place_38
        let beta_rate_dot_of_place_39 = beta_rate_dot_of_place_38
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_38_0, sums[61]),
            );
        // beta_rate_dot_of_place_40 = beta_rate_dot_of_place_32 + beta_rate_dot_of_place_34 -
        //   beta_rate_dot_of_place_36 + minus_1_by_u*beta_rate_dot_of_place_39
        let beta_rate_dot_of_place_40 = beta_rate_dot_of_place_39
            .mul_add(minus_1_by_u, beta_rate_dot_of_place_34) - beta_rate_dot_of_place_36
            + beta_rate_dot_of_place_32;
        // beta_rate_dot_of_place_41 = sin_gamma_minus_epsilon*beta_rate_dot_of_place_40
        let beta_rate_dot_of_place_41 = beta_rate_dot_of_place_40
            .mul_add(
                sin_gamma_minus_epsilon_0,
                sin_gamma_minus_epsilon.mul_add(beta_rate_dot_of_place_40_0, sums[62]),
            );
        // beta_rate_dot_of_place_42 = beta_rate_dot_of_place_10/cos_omega
        let beta_rate_dot_of_place_42 = beta_rate_dot_of_place_10
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_42_0, sums[63]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_43 = sin_omega*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_43 = sin_angle_cos_angle_inv
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(sin_angle_cos_angle_inv_0, sums[64]),
            );
        // beta_rate_dot_of_place_44 = weight_27*beta_rate_dot_of_place_42 + m6_by_u*cos_angle_2 +
        //   m6_by_ss*beta_rate_dot_of_place_43
        let beta_rate_dot_of_place_44 = beta_rate_dot_of_place_42
            .mul_add(
                weight_27,
                beta_rate_dot_of_place_43.mul_add(m6_by_ss, m6_by_u * cos_angle_2),
            );
        // beta_rate_dot_of_place_45 = cos_angle_2*beta_rate_dot_of_place_44
        let beta_rate_dot_of_place_45 = beta_rate_dot_of_place_44
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_44_0, sums[65]),
            );
        // sin_omega_sin_angle_2 = sin_omega*sin_angle_2
        let sin_omega_sin_angle_2 = sin_angle_2
            .mul_add(sin_omega_0, sin_omega.mul_add(sin_angle_2_0, sums[66]));
        // beta_rate_dot_of_place_46 = beta_rate_dot_of_place_45 + weight_22*cos_gamma_minus_epsilon +
        //   m6_by_ss*sin_omega_sin_angle_2
        let beta_rate_dot_of_place_46 = sin_omega_sin_angle_2
            .mul_add(m6_by_ss, weight_22 * cos_gamma_minus_epsilon) + beta_rate_dot_of_place_45;
        // beta_rate_dot_of_place_47 = sin_omega*beta_rate_dot_of_place_46
        let beta_rate_dot_of_place_47 = beta_rate_dot_of_place_46
            .mul_add(
                sin_omega_0,
                sin_omega.mul_add(beta_rate_dot_of_place_46_0, sums[67]),
            );
        // beta_rate_dot_of_place_48 = cos_angle_2*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_48 = sin_angle_cos_angle_inv
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(sin_angle_cos_angle_inv_0, sums[68]),
            );
        // beta_rate_dot_of_place_49 = beta_rate_dot_of_place_47 + weight_28*beta_rate_dot_of_place_48 +
        //   weight_28*sin_angle_2
        let beta_rate_dot_of_place_49 = beta_rate_dot_of_place_48
            .mul_add(weight_28, weight_28 * sin_angle_2) + beta_rate_dot_of_place_47;
        // beta_rate_dot_of_place_50 = cos_angle_2*beta_rate_dot_of_place_49
        let beta_rate_dot_of_place_50 = beta_rate_dot_of_place_49
            .mul_add(
                cos_angle_2_0,
                cos_angle_2.mul_add(beta_rate_dot_of_place_49_0, sums[69]),
            );
        // beta_rate_dot_of_place_51 = beta_rate_dot_of_place_41 - beta_rate_dot_of_place_50
        let beta_rate_dot_of_place_51 = -beta_rate_dot_of_place_50 + beta_rate_dot_of_place_41;
        // beta_rate_dot_of_place_52 = beta_rate_dot_of_place_51/cos_omega
        let beta_rate_dot_of_place_52 = beta_rate_dot_of_place_51
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_52_0, sums[70]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_53 = m6_by_zf*beta_rate_dot_of_place_11 + beta_rate_dot_of_place_52
        let beta_rate_dot_of_place_53 = m6_by_zf * beta_rate_dot_of_place_11
            + beta_rate_dot_of_place_52;
        // beta_rate_dot_of_place_54 = beta_rate_dot_of_place_53/cos_omega
        let beta_rate_dot_of_place_54 = beta_rate_dot_of_place_53
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(beta_rate_dot_of_place_54_0, sums[71]) * over_cos_omega),
            );
        // beta_rate_dot_of_place_55 = weight_29 + minus_1_by_e*cos_phi_minus_90deg
        let beta_rate_dot_of_place_55 = minus_1_by_e * cos_phi_minus_90deg;
        // beta_rate_dot_of_place_56 = cos_angle_3*beta_rate_dot_of_place_55
        let beta_rate_dot_of_place_56 = beta_rate_dot_of_place_55
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_55_0, sums[72]),
            );
        // beta_rate_dot_of_place_57 = beta_rate_dot_of_place_56 + weight_30*cos_gamma_minus_delta
        let beta_rate_dot_of_place_57 = weight_30 * cos_gamma_minus_delta
            + beta_rate_dot_of_place_56;
        // beta_rate_dot_of_place_58 = cos_phi_minus_90deg*beta_rate_dot_of_place_57
        let beta_rate_dot_of_place_58 = beta_rate_dot_of_place_57
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(beta_rate_dot_of_place_57_0, sums[73]),
            );
        // beta_rate_dot_of_place_59 = m4*beta_rate_dot_of_place_58 + weight_31*cos_gamma_minus_delta +
        //   weight_32*cos_angle_3
        let beta_rate_dot_of_place_59 = beta_rate_dot_of_place_58
            .mul_add(
                m4,
                cos_angle_3.mul_add(weight_32, weight_31 * cos_gamma_minus_delta),
            );
        // beta_rate_dot_of_place_60 = cos_angle_3*beta_rate_dot_of_place_59
        let beta_rate_dot_of_place_60 = beta_rate_dot_of_place_59
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_59_0, sums[74]),
            );
        // cos_gamma_minus_delta_sq = cos_gamma_minus_delta*cos_gamma_minus_delta
        let cos_gamma_minus_delta_sq = cos_gamma_minus_delta
            .mul_add(cos_gamma_minus_delta_0 + cos_gamma_minus_delta_0, sums[75]);
        // beta_rate_dot_of_place_61 = beta_rate_dot_of_place_60 + weight_33*cos_gamma_minus_delta_sq
        let beta_rate_dot_of_place_61 = weight_33 * cos_gamma_minus_delta_sq
            + beta_rate_dot_of_place_60;
        // beta_rate_dot_of_place_62 = beta_rate_dot_of_place_61/sin_phi_minus_90deg
        let beta_rate_dot_of_place_62 = beta_rate_dot_of_place_61
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_62_0, sums[76])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_63 = sin_angle_3*beta_rate_dot_of_place_4
        let beta_rate_dot_of_place_63 = beta_rate_dot_of_place_4
            .mul_add(
                sin_angle_3_0,
                sin_angle_3.mul_add(beta_rate_dot_of_place_4_0, sums[77]),
            );
        // beta_rate_dot_of_place_64 = beta_rate_dot_of_place_62 + m4_by_e*beta_rate_dot_of_place_63
        let beta_rate_dot_of_place_64 = m4_by_e * beta_rate_dot_of_place_63
            + beta_rate_dot_of_place_62;
        // beta_rate_dot_of_place_65 = beta_rate_dot_of_place_64/sin_phi_minus_90deg
        let beta_rate_dot_of_place_65 = beta_rate_dot_of_place_64
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_65_0, sums[78])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_66 = weight_34*sin_angle_cos_angle_inv + minus_1_by_e*cos_angle_3
        let beta_rate_dot_of_place_66 = sin_angle_cos_angle_inv
            .mul_add(weight_34, minus_1_by_e * cos_angle_3);
        // beta_rate_dot_of_place_67 = cos_angle_3*beta_rate_dot_of_place_66
        let beta_rate_dot_of_place_67 = beta_rate_dot_of_place_66
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_66_0, sums[79]),
            );
        // beta_rate_dot_of_place_68 = beta_rate_dot_of_place_65 + m4*beta_rate_dot_of_place_67 +
        //   m4_ea_by_e_minus_1_by_ss*sin_angle_3
        let beta_rate_dot_of_place_68 = beta_rate_dot_of_place_67
            .mul_add(m4, m4_ea_by_e_minus_1_by_ss * sin_angle_3) + beta_rate_dot_of_place_65;
        // beta_rate_dot_of_place_69 = cos_phi_minus_90deg*beta_rate_dot_of_place_68
        let beta_rate_dot_of_place_69 = beta_rate_dot_of_place_68
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(beta_rate_dot_of_place_68_0, sums[80]),
            );
        // beta_rate_dot_of_place_70 = weight_35 + weight_31*beta_rate_dot_of_place_13
        let beta_rate_dot_of_place_70 = weight_31 * beta_rate_dot_of_place_13;
        // beta_rate_dot_of_place_71 = sin_gamma_minus_delta*beta_rate_dot_of_place_70
        let beta_rate_dot_of_place_71 = beta_rate_dot_of_place_70
            .mul_add(
                sin_gamma_minus_delta_0,
                sin_gamma_minus_delta.mul_add(beta_rate_dot_of_place_70_0, sums[81]),
            );
        // beta_rate_dot_of_place_72 = weight_36*sin_angle_cos_angle_inv +
        //   m4_1_minus_ea_by_e_by_e*cos_angle_3
        let beta_rate_dot_of_place_72 = sin_angle_cos_angle_inv
            .mul_add(weight_36, m4_1_minus_ea_by_e_by_e * cos_angle_3);
        // beta_rate_dot_of_place_73 = cos_gamma_minus_delta*beta_rate_dot_of_place_72
        let beta_rate_dot_of_place_73 = beta_rate_dot_of_place_72
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_72_0, sums[82]),
            );
        // beta_rate_dot_of_place_74 = sin_angle_3/sin_phi_minus_90deg
        let beta_rate_dot_of_place_74 = sin_angle_3
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_74_0, sums[83])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_75 = m4_ea_by_e_minus_1*cos_angle_3 + weight_37*beta_rate_dot_of_place_74
        let beta_rate_dot_of_place_75 = beta_rate_dot_of_place_74
            .mul_add(weight_37, m4_ea_by_e_minus_1 * cos_angle_3);
        // beta_rate_dot_of_place_76 = cos_angle_3*beta_rate_dot_of_place_75
        let beta_rate_dot_of_place_76 = beta_rate_dot_of_place_75
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_75_0, sums[84]),
            );
        // beta_rate_dot_of_place_77 = beta_rate_dot_of_place_69 + beta_rate_dot_of_place_71 +
        //   beta_rate_dot_of_place_73 + minus_1_by_zt*beta_rate_dot_of_place_76
        let beta_rate_dot_of_place_77 = beta_rate_dot_of_place_76
            .mul_add(
                minus_1_by_zt,
                beta_rate_dot_of_place_71 + beta_rate_dot_of_place_73,
            ) + beta_rate_dot_of_place_69;
        // beta_rate_dot_of_place_78 = cos_gamma_minus_delta*beta_rate_dot_of_place_77
        let beta_rate_dot_of_place_78 = beta_rate_dot_of_place_77
            .mul_add(
                cos_gamma_minus_delta_0,
                cos_gamma_minus_delta.mul_add(beta_rate_dot_of_place_77_0, sums[85]),
            );
        // beta_rate_dot_of_place_79 = beta_rate_dot_of_place_15/sin_phi_minus_90deg
        let beta_rate_dot_of_place_79 = beta_rate_dot_of_place_15
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_79_0, sums[86])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_80 = cos_phi_minus_90deg*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_80 = sin_angle_cos_angle_inv
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(sin_angle_cos_angle_inv_0, sums[87]),
            );
        // beta_rate_dot_of_place_81 = weight_38*beta_rate_dot_of_place_79 + m4_by_zt*cos_angle_3 +
        //   minus_m4_by_ss*beta_rate_dot_of_place_80
        let beta_rate_dot_of_place_81 = beta_rate_dot_of_place_79
            .mul_add(
                weight_38,
                beta_rate_dot_of_place_80.mul_add(minus_m4_by_ss, m4_by_zt * cos_angle_3),
            );
        // beta_rate_dot_of_place_82 = cos_angle_3*beta_rate_dot_of_place_81
        let beta_rate_dot_of_place_82 = beta_rate_dot_of_place_81
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_81_0, sums[88]),
            );
        // beta_rate_dot_of_place_83 = cos_phi_minus_90deg*sin_angle_3
        let beta_rate_dot_of_place_83 = sin_angle_3
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(sin_angle_3_0, sums[89]),
            );
        // beta_rate_dot_of_place_84 = beta_rate_dot_of_place_82 +
        //   m4_1_minus_ea_by_e_by_ss*sin_gamma_minus_delta + minus_m4_by_ss*beta_rate_dot_of_place_83
        let beta_rate_dot_of_place_84 = beta_rate_dot_of_place_83
            .mul_add(minus_m4_by_ss, m4_1_minus_ea_by_e_by_ss * sin_gamma_minus_delta)
            + beta_rate_dot_of_place_82;
        // beta_rate_dot_of_place_85 = cos_phi_minus_90deg*beta_rate_dot_of_place_84
        let beta_rate_dot_of_place_85 = beta_rate_dot_of_place_84
            .mul_add(
                cos_phi_minus_90deg_0,
                cos_phi_minus_90deg.mul_add(beta_rate_dot_of_place_84_0, sums[90]),
            );
        // beta_rate_dot_of_place_86 = cos_angle_3*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_86 = sin_angle_cos_angle_inv
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(sin_angle_cos_angle_inv_0, sums[91]),
            );
        // beta_rate_dot_of_place_87 = beta_rate_dot_of_place_85 + weight_39*beta_rate_dot_of_place_86 +
        //   weight_39*sin_angle_3
        let beta_rate_dot_of_place_87 = beta_rate_dot_of_place_86
            .mul_add(weight_39, weight_39 * sin_angle_3) + beta_rate_dot_of_place_85;
        // beta_rate_dot_of_place_88 = cos_angle_3*beta_rate_dot_of_place_87
        let beta_rate_dot_of_place_88 = beta_rate_dot_of_place_87
            .mul_add(
                cos_angle_3_0,
                cos_angle_3.mul_add(beta_rate_dot_of_place_87_0, sums[92]),
            );
        // beta_rate_dot_of_place_89 = beta_rate_dot_of_place_78 - beta_rate_dot_of_place_88
        let beta_rate_dot_of_place_89 = -beta_rate_dot_of_place_88 + beta_rate_dot_of_place_78;
        // beta_rate_dot_of_place_90 = beta_rate_dot_of_place_89/sin_phi_minus_90deg
        let beta_rate_dot_of_place_90 = beta_rate_dot_of_place_89
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_90_0, sums[93])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_91 = m4_by_e*beta_rate_dot_of_place_16 + beta_rate_dot_of_place_90
        let beta_rate_dot_of_place_91 = m4_by_e * beta_rate_dot_of_place_16
            + beta_rate_dot_of_place_90;
        // beta_rate_dot_of_place_92 = beta_rate_dot_of_place_91/sin_phi_minus_90deg
        let beta_rate_dot_of_place_92 = beta_rate_dot_of_place_91
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(beta_rate_dot_of_place_92_0, sums[94])
                    * over_sin_phi_minus_90deg),
            );
        // beta_rate_dot_of_place_93 = beta_rate_dot_of_place_5*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_93 = beta_rate_dot_of_place_5
            .mul_add(
                sin_angle_cos_angle_inv_0,
                sin_angle_cos_angle_inv.mul_add(beta_rate_dot_of_place_5_0, sums[95]),
            );
        // beta_rate_dot_of_place_94 = beta_rate_dot_of_place_54 - beta_rate_dot_of_place_92 +
        //   minus_1_by_ss*beta_rate_dot_of_place_93 + minus_m4_by_ss*cos_angle_3_sin_angle_3 +
        //   minus_m6_by_ss*cos_angle_2_sin_angle_2
        let beta_rate_dot_of_place_94 = beta_rate_dot_of_place_93
            .mul_add(
                minus_1_by_ss,
                cos_angle_2_sin_angle_2
                    .mul_add(minus_m6_by_ss, minus_m4_by_ss * cos_angle_3_sin_angle_3),
            ) + beta_rate_dot_of_place_54 - beta_rate_dot_of_place_92;
        // beta_rate_dot_of_place_95 = sin_theta*beta_rate_dot_of_place_94
        let beta_rate_dot_of_place_95 = beta_rate_dot_of_place_94
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_94_0, sums[96]),
            );
        // beta_rate_dot_of_place_96 = beta_rate_dot_of_place_7*cos_angle_2_sq
        let beta_rate_dot_of_place_96 = cos_angle_2_sq
            .mul_add(
                beta_rate_dot_of_place_7_0,
                beta_rate_dot_of_place_7.mul_add(cos_angle_2_sq_0, sums[97]),
            );
        // beta_rate_dot_of_place_97 = d1_of_place_6 + beta_rate_dot_of_place_96
        let beta_rate_dot_of_place_97 = beta_rate_dot_of_place_96 + d1_of_place_6;
        // beta_rate_dot_of_place_98 = beta_rate_dot_of_place_97/cos_omega_sq
        let beta_rate_dot_of_place_98 = beta_rate_dot_of_place_97
            .mul_add(
                over_cos_omega_sq,
                -(cos_omega_sq.mul_add(beta_rate_dot_of_place_98_0, sums[98]) * over_cos_omega_sq),
            );
        // beta_rate_dot_of_place_99 = beta_rate_dot_of_place_12*cos_angle_3_sq
        let beta_rate_dot_of_place_99 = cos_angle_3_sq
            .mul_add(
                beta_rate_dot_of_place_12_0,
                beta_rate_dot_of_place_12.mul_add(cos_angle_3_sq_0, sums[99]),
            );
        // beta_rate_dot_of_place_100 = d1_of_place_11 + beta_rate_dot_of_place_99
        let beta_rate_dot_of_place_100 = beta_rate_dot_of_place_99 + d1_of_place_11;
        // beta_rate_dot_of_place_101 = beta_rate_dot_of_place_100/sin_phi_minus_90deg_sq
        let beta_rate_dot_of_place_101 = beta_rate_dot_of_place_100
            .mul_add(
                over_sin_phi_minus_90deg_sq,
                -(sin_phi_minus_90deg_sq.mul_add(beta_rate_dot_of_place_101_0, sums[100])
                    * over_sin_phi_minus_90deg_sq),
            );
        // beta_rate_dot_of_place_102 = weight_7 + m4*cos_angle_3_sq + m6*cos_angle_2_sq +
        //   beta_rate_dot_of_place_98 + beta_rate_dot_of_place_101
        let beta_rate_dot_of_place_102 = cos_angle_2_sq.mul_add(m6, m4 * cos_angle_3_sq)
            + beta_rate_dot_of_place_98 + beta_rate_dot_of_place_101;
        // beta_rate_dot_of_place_103 = cos_beta_minus_gamma*sin_angle_cos_angle_inv
        let beta_rate_dot_of_place_103 = sin_angle_cos_angle_inv
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(sin_angle_cos_angle_inv_0, sums[101]),
            );
        // beta_rate_dot_of_place_104 = beta_rate_dot_of_place_102*beta_rate_dot_of_place_103
        let beta_rate_dot_of_place_104 = beta_rate_dot_of_place_102
            .mul_add(
                beta_rate_dot_of_place_103_0,
                beta_rate_dot_of_place_103
                    .mul_add(beta_rate_dot_of_place_102_0, sums[102]),
            );
        // beta_rate_dot_of_place_105 = beta_rate_dot_of_place_95 + weight_40*beta_rate_dot_of_place_104
        let beta_rate_dot_of_place_105 = weight_40 * beta_rate_dot_of_place_104
            + beta_rate_dot_of_place_95;
        // beta_rate_dot_of_place_106 = sin_theta*beta_rate_dot_of_place_105
        let beta_rate_dot_of_place_106 = beta_rate_dot_of_place_105
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_place_105_0, sums[103]),
            );
        // beta_rate_dot_of_place_107 = weight_7 + m4*cos_angle_3_sq + m6*cos_angle_2_sq +
        //   beta_rate_dot_of_place_98 + beta_rate_dot_of_place_101 + m2_da_by_ss*sin_angle
        let beta_rate_dot_of_place_107 = cos_angle_2_sq
            .mul_add(m6, cos_angle_3_sq.mul_add(m4, m2_da_by_ss * sin_angle))
            + beta_rate_dot_of_place_98 + beta_rate_dot_of_place_101;
        // beta_rate_dot_of_place_108 = cos_theta*beta_rate_dot_of_place_107
        let beta_rate_dot_of_place_108 = beta_rate_dot_of_place_107
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_107_0, sums[104]),
            );
        // beta_rate_dot_of_place_109 = beta_rate_dot_of_place_108 + weight_41*beta_rate_dot_of_place_103 +
        //   i2_plus_m2_da_2_by_d_ss*sin_beta_minus_gamma
        let beta_rate_dot_of_place_109 = beta_rate_dot_of_place_103
            .mul_add(weight_41, i2_plus_m2_da_2_by_d_ss * sin_beta_minus_gamma)
            + beta_rate_dot_of_place_108;
        // beta_rate_dot_of_place_110 = cos_beta_minus_gamma*beta_rate_dot_of_place_109
        let beta_rate_dot_of_place_110 = beta_rate_dot_of_place_109
            .mul_add(
                cos_beta_minus_gamma_0,
                cos_beta_minus_gamma.mul_add(beta_rate_dot_of_place_109_0, sums[105]),
            );
        // beta_rate_dot_of_place_111 = beta_rate_dot_of_place_106 + weight_40*beta_rate_dot_of_place_110
        let beta_rate_dot_of_place_111 = weight_40 * beta_rate_dot_of_place_110
            + beta_rate_dot_of_place_106;
        // beta_rate_dot_of_place_112 = beta_rate_dot_of_place_111/cos_angle
        let beta_rate_dot_of_place_112 = beta_rate_dot_of_place_111
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_112_0, sums[106]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_113 = weight_7 + m4*cos_angle_3_sq + m6*cos_angle_2_sq +
        //   beta_rate_dot_of_place_98 + beta_rate_dot_of_place_101 + m2_da_rr_by_d_ss*sin_beta_minus_gamma
        let beta_rate_dot_of_place_113 = cos_angle_2_sq
            .mul_add(
                m6,
                cos_angle_3_sq.mul_add(m4, m2_da_rr_by_d_ss * sin_beta_minus_gamma),
            ) + beta_rate_dot_of_place_98 + beta_rate_dot_of_place_101;
        // beta_rate_dot_of_place_114 = cos_theta*beta_rate_dot_of_place_113
        let beta_rate_dot_of_place_114 = beta_rate_dot_of_place_113
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(beta_rate_dot_of_place_113_0, sums[107]),
            );
        // beta_rate_dot_of_place_115 = rr*beta_rate_dot_of_place_112 - beta_rate_dot_of_place_114 +
        //   m2_da_rr_by_d_2*cos_beta_minus_gamma_sq
        let beta_rate_dot_of_place_115 = beta_rate_dot_of_place_112
            .mul_add(
                rr,
                m2_da_rr_by_d_2 * cos_beta_minus_gamma_sq - beta_rate_dot_of_place_114,
            );
        // beta_rate_dot_of_place_116 = beta_rate_dot_of_place_115/cos_angle
        let beta_rate_dot_of_place_116 = beta_rate_dot_of_place_115
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_place_116_0, sums[108]) * over_cos_angle),
            );
        // beta_rate_dot_of_place_117 = m2_da_by_d*cos_beta_minus_gamma - beta_rate_dot_of_place_116
        let beta_rate_dot_of_place_117 = m2_da_by_d * cos_beta_minus_gamma
            - beta_rate_dot_of_place_116;
        // beta_rate_sq = beta_rate*beta_rate
        let beta_rate_sq = beta_rate.mul_add(beta_rate_0 + beta_rate_0, sums[109]);
        // beta_rate_dot_of_beta_rate = beta_rate_dot_of_place_117*beta_rate_sq
        let beta_rate_dot_of_beta_rate = beta_rate_dot_of_place_117
            .mul_add(
                beta_rate_sq_0,
                beta_rate_sq.mul_add(beta_rate_dot_of_place_117_0, sums[110]),
            );
        // beta_rate_dot_of_place_118 = weight_42 + sb_sc_minus_sa_sd*sin_gamma
        let beta_rate_dot_of_place_118 = sb_sc_minus_sa_sd * sin_gamma;
        // beta_rate_dot_of_place_119 = sin_gamma*beta_rate_dot_of_place_118
        let beta_rate_dot_of_place_119 = beta_rate_dot_of_place_118
            .mul_add(
                sin_gamma_0,
                sin_gamma.mul_add(beta_rate_dot_of_place_118_0, sums[111]),
            );
        // beta_rate_dot_of_place_120 = weight_43 + sb_sc_minus_sa_sd*cos_gamma
        let beta_rate_dot_of_place_120 = sb_sc_minus_sa_sd * cos_gamma;
        // beta_rate_dot_of_place_121 = cos_gamma*beta_rate_dot_of_place_120
        let beta_rate_dot_of_place_121 = beta_rate_dot_of_place_120
            .mul_add(
                cos_gamma_0,
                cos_gamma.mul_add(beta_rate_dot_of_place_120_0, sums[112]),
            );
        // beta_rate_dot_of_place_122 = sa_sd_minus_sb_sc + beta_rate_dot_of_place_119 +
        //   beta_rate_dot_of_place_121
        let beta_rate_dot_of_place_122 = beta_rate_dot_of_place_119 + beta_rate_dot_of_place_121;
        // beta_rate_dot_of_place_123 = beta_rate_dot_of_place_2*beta_rate_dot_of_place_122
        let beta_rate_dot_of_place_123 = beta_rate_dot_of_place_122
            .mul_add(
                beta_rate_dot_of_place_2_0,
                beta_rate_dot_of_place_2.mul_add(beta_rate_dot_of_place_122_0, sums[113]),
            );
        // beta_rate_dot_of_place_124 = l0_sb_sc_minus_l0_sa_sd + beta_rate_dot_of_place_123 +
        //   minus_l0*beta_rate_dot_of_place_119 + minus_l0*beta_rate_dot_of_place_121
        let beta_rate_dot_of_place_124 = beta_rate_dot_of_place_121
            .mul_add(minus_l0, minus_l0 * beta_rate_dot_of_place_119) + beta_rate_dot_of_place_123;
        // beta_rate_dot_of_place_125 = beta_rate_dot_of_place_2/beta_rate_dot_of_place
        let beta_rate_dot_of_place_125 = beta_rate_dot_of_place_2
            .mul_add(
                over_beta_rate_dot_of_place,
                -(beta_rate_dot_of_place.mul_add(beta_rate_dot_of_place_125_0, sums[114])
                    * over_beta_rate_dot_of_place),
            );
        // beta_rate_dot_of_place_126 = beta_rate_dot_of_place_124*beta_rate_dot_of_place_125
        let beta_rate_dot_of_place_126 = beta_rate_dot_of_place_124
            .mul_add(
                beta_rate_dot_of_place_125_0,
                beta_rate_dot_of_place_125
                    .mul_add(beta_rate_dot_of_place_124_0, sums[115]),
            );
        // beta_rate_dot_of_beta_rate_2 = rr*beta_rate_dot_of_beta_rate +
        //   minus_c0_by_ss*beta_rate_dot_of_place_126
        let beta_rate_dot_of_beta_rate_2 = beta_rate_dot_of_beta_rate
            .mul_add(rr, minus_c0_by_ss * beta_rate_dot_of_place_126);
        // beta_rate_dot_of_beta_rate_3 = sin_theta*beta_rate_dot_of_beta_rate_2
        let beta_rate_dot_of_beta_rate_3 = beta_rate_dot_of_beta_rate_2
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(beta_rate_dot_of_beta_rate_2_0, sums[116]),
            );
        // beta_rate_dot_of_place_127 = cos_beta_minus_gamma/cos_angle
        let beta_rate_dot_of_place_127 = cos_angle
            .mul_add(
                -(beta_rate_dot_of_place_127_0 * over_cos_angle),
                (cos_beta_minus_gamma - sums[117]) * over_cos_angle,
            );
        // beta_rate_dot_of_place_128 = i2_plus_m2_da_2_by_d*beta_rate_dot_of_place_127 +
        //   minus_m2_da*cos_theta
        let beta_rate_dot_of_place_128 = beta_rate_dot_of_place_127
            .mul_add(i2_plus_m2_da_2_by_d, minus_m2_da * cos_theta);
        // beta_rate_dot_of_place_129 = beta_rate_dot_of_place_128*beta_rate_dot_of_place_103
        let beta_rate_dot_of_place_129 = beta_rate_dot_of_place_103
            .mul_add(
                beta_rate_dot_of_place_128_0,
                beta_rate_dot_of_place_128
                    .mul_add(beta_rate_dot_of_place_103_0, sums[118]),
            );
        // beta_rate_dot_of_place_130 = rr*beta_rate_dot_of_place_129 +
        //   minus_i2_minus_m2_da_2*sin_beta_minus_gamma
        let beta_rate_dot_of_place_130 = beta_rate_dot_of_place_129
            .mul_add(rr, minus_i2_minus_m2_da_2 * sin_beta_minus_gamma);
        // beta_rate_dot_of_place_131 = beta_rate_dot_of_place_130*beta_rate_dot_of_place_127
        let beta_rate_dot_of_place_131 = beta_rate_dot_of_place_130
            .mul_add(
                beta_rate_dot_of_place_127_0,
                beta_rate_dot_of_place_127
                    .mul_add(beta_rate_dot_of_place_130_0, sums[119]),
            );
        // beta_rate_dot_of_place_132 = m2_da*beta_rate_dot_of_place_6 +
        //   weight_40*beta_rate_dot_of_place_131
        let beta_rate_dot_of_place_132 = beta_rate_dot_of_place_131
            .mul_add(weight_40, m2_da * beta_rate_dot_of_place_6);
        // beta_rate_dot_of_beta_rate_4 = beta_rate_dot_of_place_132*beta_rate_sq
        let beta_rate_dot_of_beta_rate_4 = beta_rate_dot_of_place_132
            .mul_add(
                beta_rate_sq_0,
                beta_rate_sq.mul_add(beta_rate_dot_of_place_132_0, sums[120]),
            );
        // beta_rate_dot_of_beta_rate_5 = beta_rate_dot_of_beta_rate_3 +
        //   minus_rr_by_d*beta_rate_dot_of_beta_rate_4
        let beta_rate_dot_of_beta_rate_5 = minus_rr_by_d * beta_rate_dot_of_beta_rate_4
            + beta_rate_dot_of_beta_rate_3;
        // beta_rate_dot_of_beta_rate_6 = beta_rate_dot_of_beta_rate_5/cos_angle
        let beta_rate_dot_of_beta_rate_6 = beta_rate_dot_of_beta_rate_5
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(beta_rate_dot_of_beta_rate_6_0, sums[121]) * over_cos_angle),
            );
        // beta_rate_dot_of_beta_rate_7 = mom + rr*beta_rate_dot_of_beta_rate_6
        let beta_rate_dot_of_beta_rate_7 = rr * beta_rate_dot_of_beta_rate_6;
        // beta_rate_dot_2 = beta_rate_dot_of_beta_rate_7/d1_of_place_20
        let beta_rate_dot_2 = beta_rate_dot_of_beta_rate_7
            .mul_add(
                over_d1_of_place_20,
                -(d1_of_place_20.mul_add(beta_rate_dot_2_0, sums[122]) * over_d1_of_place_20),
            );
        // theta_of_place = -1 + rr_by_d*beta_rate_dot_of_place_127
        let theta_of_place = rr_by_d * beta_rate_dot_of_place_127;
        // theta_dot_2 = beta_rate*theta_of_place
        let theta_dot_2 = theta_of_place
            .mul_add(beta_rate_0, beta_rate.mul_add(theta_of_place_0, sums[123]));
        // beta_rate_sin_theta = beta_rate*sin_theta
        let beta_rate_sin_theta = sin_theta
            .mul_add(beta_rate_0, beta_rate.mul_add(sin_theta_0, sums[124]));
        // gamma_of_beta_rate = beta_rate_sin_theta/cos_angle
        let gamma_of_beta_rate = beta_rate_sin_theta
            .mul_add(
                over_cos_angle,
                -(cos_angle.mul_add(gamma_of_beta_rate_0, sums[125]) * over_cos_angle),
            );
        // delta_of_beta_rate = gamma_of_beta_rate*beta_rate_dot_of_place_13
        let delta_of_beta_rate = gamma_of_beta_rate
            .mul_add(
                beta_rate_dot_of_place_13_0,
                beta_rate_dot_of_place_13.mul_add(gamma_of_beta_rate_0, sums[126]),
            );
        // phi_minus_90deg_of_place = weight_44*cos_gamma_minus_delta + weight_38*cos_angle_3
        let phi_minus_90deg_of_place = cos_angle_3
            .mul_add(weight_38, weight_44 * cos_gamma_minus_delta);
        // phi_minus_90deg_of_place_2 = phi_minus_90deg_of_place/sin_phi_minus_90deg
        let phi_minus_90deg_of_place_2 = phi_minus_90deg_of_place
            .mul_add(
                over_sin_phi_minus_90deg,
                -(sin_phi_minus_90deg.mul_add(phi_minus_90deg_of_place_2_0, sums[127])
                    * over_sin_phi_minus_90deg),
            );
        // phi_minus_90deg_of_beta_rate = gamma_of_beta_rate*phi_minus_90deg_of_place_2
        let phi_minus_90deg_of_beta_rate = phi_minus_90deg_of_place_2
            .mul_add(
                gamma_of_beta_rate_0,
                gamma_of_beta_rate.mul_add(phi_minus_90deg_of_place_2_0, sums[128]),
            );
        // epsilon_of_beta_rate = gamma_of_beta_rate*beta_rate_dot_of_place_8
        let epsilon_of_beta_rate = gamma_of_beta_rate
            .mul_add(
                beta_rate_dot_of_place_8_0,
                beta_rate_dot_of_place_8.mul_add(gamma_of_beta_rate_0, sums[129]),
            );
        // omega_of_place = weight_27*cos_angle_2 + minus_1_by_zf*sin_gamma_minus_epsilon
        let omega_of_place = sin_gamma_minus_epsilon
            .mul_add(minus_1_by_zf, weight_27 * cos_angle_2);
        // omega_of_place_2 = omega_of_place/cos_omega
        let omega_of_place_2 = omega_of_place
            .mul_add(
                over_cos_omega,
                -(cos_omega.mul_add(omega_of_place_2_0, sums[130]) * over_cos_omega),
            );
        // omega_of_beta_rate = gamma_of_beta_rate*omega_of_place_2
        let omega_of_beta_rate = omega_of_place_2
            .mul_add(
                gamma_of_beta_rate_0,
                gamma_of_beta_rate.mul_add(omega_of_place_2_0, sums[131]),
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
                count * gamma_minus_epsilon,
                count * gamma_minus_epsilon,
                count * d1_of_place_2,
                count * d1_of_place_2,
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
                beta_rate_dot_of_place_2, cos_theta, sin_omega, cos_omega, beta_rate_dot_of_place_7,
                cos_angle_2, sin_gamma_minus_epsilon, cos_phi_minus_90deg, sin_phi_minus_90deg,
                beta_rate_dot_of_place_12, cos_angle_3, cos_gamma_minus_delta, cos_angle_2,
                sin_omega, cos_angle_2, sin_gamma_minus_epsilon, cos_omega, sin_angle_2, cos_omega,
                cos_angle, cos_angle_2, sin_omega, cos_gamma_minus_epsilon, sin_gamma_minus_epsilon,
                cos_omega, cos_angle_2, sin_gamma_minus_epsilon, cos_omega, sin_omega, cos_angle_2,
                sin_omega, sin_omega, cos_angle_2, cos_angle_2, cos_omega, cos_omega, cos_angle_3,
                cos_phi_minus_90deg, cos_angle_3, cos_gamma_minus_delta, sin_phi_minus_90deg,
                sin_angle_3, sin_phi_minus_90deg, cos_angle_3, cos_phi_minus_90deg,
                sin_gamma_minus_delta, cos_gamma_minus_delta, sin_phi_minus_90deg, cos_angle_3,
                cos_gamma_minus_delta, sin_phi_minus_90deg, cos_phi_minus_90deg, cos_angle_3,
                cos_phi_minus_90deg, cos_phi_minus_90deg, cos_angle_3, cos_angle_3,
                sin_phi_minus_90deg, sin_phi_minus_90deg, beta_rate_dot_of_place_5, sin_theta,
                beta_rate_dot_of_place_7, cos_omega_sq, beta_rate_dot_of_place_12,
                sin_phi_minus_90deg_sq, cos_beta_minus_gamma, beta_rate_dot_of_place_102, sin_theta,
                cos_theta, cos_beta_minus_gamma, cos_angle, cos_theta, cos_angle, beta_rate,
                beta_rate_dot_of_place_117, sin_gamma, cos_gamma, beta_rate_dot_of_place_2,
                beta_rate_dot_of_place, beta_rate_dot_of_place_124, sin_theta, cos_angle,
                beta_rate_dot_of_place_128, beta_rate_dot_of_place_130, beta_rate_dot_of_place_132,
                cos_angle, d1_of_place_20, beta_rate, beta_rate, cos_angle, gamma_of_beta_rate,
                sin_phi_minus_90deg, gamma_of_beta_rate, gamma_of_beta_rate, cos_omega,
                gamma_of_beta_rate,
            ]),
            padded([
                cos_theta, sin_theta, cos_omega, sin_omega, cos_angle, sin_angle,
                cos_beta_minus_gamma, sin_beta_minus_gamma, cos_gamma_minus_delta,
                sin_gamma_minus_delta, cos_gamma_minus_epsilon, sin_gamma_minus_epsilon,
                cos_angle_2, sin_angle_2, cos_beta_minus_gamma, cos_beta_minus_gamma,
                cos_phi_minus_90deg, sin_phi_minus_90deg, cos_angle_3, sin_angle_3, cos_angle_2,
                d1_of_place_5, cos_angle_2, cos_omega, d1_of_place_8, cos_angle_3, d1_of_place_10,
                cos_angle_3, sin_phi_minus_90deg, d1_of_place_13, sin_theta, sin_theta_sq,
                d1_of_place_17, d1_of_place_19, cos_gamma, sin_gamma, beta_rate_dot_of_place_2,
                sin_beta_minus_gamma, sin_omega, beta_rate_dot_of_place_8, beta_rate_dot_of_place_8,
                sin_angle_2, cos_angle_2_sin_angle_2, cos_phi_minus_90deg,
                beta_rate_dot_of_place_13, beta_rate_dot_of_place_13, sin_angle_3,
                cos_angle_3_sin_angle_3, beta_rate_dot_of_place_17, beta_rate_dot_of_place_19,
                beta_rate_dot_of_place_21, sin_gamma_minus_epsilon, beta_rate_dot_of_place_25,
                beta_rate_dot_of_place_3, beta_rate_dot_of_place_28, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_29, beta_rate_dot_of_place_31, beta_rate_dot_of_place_33,
                beta_rate_dot_of_place_35, beta_rate_dot_of_place_37, beta_rate_dot_of_place_38,
                beta_rate_dot_of_place_40, beta_rate_dot_of_place_42, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_44, sin_angle_2, beta_rate_dot_of_place_46,
                sin_angle_cos_angle_inv, beta_rate_dot_of_place_49, beta_rate_dot_of_place_52,
                beta_rate_dot_of_place_54, beta_rate_dot_of_place_55, beta_rate_dot_of_place_57,
                beta_rate_dot_of_place_59, cos_gamma_minus_delta, beta_rate_dot_of_place_62,
                beta_rate_dot_of_place_4, beta_rate_dot_of_place_65, beta_rate_dot_of_place_66,
                beta_rate_dot_of_place_68, beta_rate_dot_of_place_70, beta_rate_dot_of_place_72,
                beta_rate_dot_of_place_74, beta_rate_dot_of_place_75, beta_rate_dot_of_place_77,
                beta_rate_dot_of_place_79, sin_angle_cos_angle_inv, beta_rate_dot_of_place_81,
                sin_angle_3, beta_rate_dot_of_place_84, sin_angle_cos_angle_inv,
                beta_rate_dot_of_place_87, beta_rate_dot_of_place_90, beta_rate_dot_of_place_92,
                sin_angle_cos_angle_inv, beta_rate_dot_of_place_94, cos_angle_2_sq,
                beta_rate_dot_of_place_98, cos_angle_3_sq, beta_rate_dot_of_place_101,
                sin_angle_cos_angle_inv, beta_rate_dot_of_place_103, beta_rate_dot_of_place_105,
                beta_rate_dot_of_place_107, beta_rate_dot_of_place_109, beta_rate_dot_of_place_112,
                beta_rate_dot_of_place_113, beta_rate_dot_of_place_116, beta_rate, beta_rate_sq,
                beta_rate_dot_of_place_118, beta_rate_dot_of_place_120, beta_rate_dot_of_place_122,
                beta_rate_dot_of_place_125, beta_rate_dot_of_place_125,
                beta_rate_dot_of_beta_rate_2, beta_rate_dot_of_place_127,
                beta_rate_dot_of_place_103, beta_rate_dot_of_place_127, beta_rate_sq,
                beta_rate_dot_of_beta_rate_6, beta_rate_dot_2, theta_of_place, sin_theta,
                gamma_of_beta_rate, beta_rate_dot_of_place_13, phi_minus_90deg_of_place_2,
                phi_minus_90deg_of_place_2, beta_rate_dot_of_place_8, omega_of_place_2,
                omega_of_place_2,
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
        gamma_minus_epsilon_last = gamma_minus_epsilon;
        sin_gamma_minus_epsilon_last = sin_gamma_minus_epsilon;
        cos_gamma_minus_epsilon_last = cos_gamma_minus_epsilon;
        d1_of_place_2_last = d1_of_place_2;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        sin_phi_minus_90deg_last = sin_phi_minus_90deg;
        cos_phi_minus_90deg_last = cos_phi_minus_90deg;
        d1_of_place_4_last = d1_of_place_4;
        sin_angle_3_last = sin_angle_3;
        cos_angle_3_last = cos_angle_3;
        d1_of_place_5_last = d1_of_place_5;
        cos_angle_2_sq_last = cos_angle_2_sq;
        cos_omega_sq_last = cos_omega_sq;
        d1_of_place_8_last = d1_of_place_8;
        d1_of_place_10_last = d1_of_place_10;
        cos_angle_3_sq_last = cos_angle_3_sq;
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
        beta_rate_dot_of_place_7_last = beta_rate_dot_of_place_7;
        beta_rate_dot_of_place_8_last = beta_rate_dot_of_place_8;
        cos_angle_2_sin_angle_2_last = cos_angle_2_sin_angle_2;
        beta_rate_dot_of_place_12_last = beta_rate_dot_of_place_12;
        beta_rate_dot_of_place_13_last = beta_rate_dot_of_place_13;
        cos_angle_3_sin_angle_3_last = cos_angle_3_sin_angle_3;
        beta_rate_dot_of_place_17_last = beta_rate_dot_of_place_17;
        beta_rate_dot_of_place_19_last = beta_rate_dot_of_place_19;
        beta_rate_dot_of_place_21_last = beta_rate_dot_of_place_21;
        beta_rate_dot_of_place_25_last = beta_rate_dot_of_place_25;
        beta_rate_dot_of_place_28_last = beta_rate_dot_of_place_28;
        sin_angle_cos_angle_inv_last = sin_angle_cos_angle_inv;
        beta_rate_dot_of_place_29_last = beta_rate_dot_of_place_29;
        beta_rate_dot_of_place_31_last = beta_rate_dot_of_place_31;
        beta_rate_dot_of_place_33_last = beta_rate_dot_of_place_33;
        beta_rate_dot_of_place_35_last = beta_rate_dot_of_place_35;
        beta_rate_dot_of_place_37_last = beta_rate_dot_of_place_37;
        beta_rate_dot_of_place_38_last = beta_rate_dot_of_place_38;
        beta_rate_dot_of_place_40_last = beta_rate_dot_of_place_40;
        beta_rate_dot_of_place_42_last = beta_rate_dot_of_place_42;
        beta_rate_dot_of_place_44_last = beta_rate_dot_of_place_44;
        beta_rate_dot_of_place_46_last = beta_rate_dot_of_place_46;
        beta_rate_dot_of_place_49_last = beta_rate_dot_of_place_49;
        beta_rate_dot_of_place_52_last = beta_rate_dot_of_place_52;
        beta_rate_dot_of_place_54_last = beta_rate_dot_of_place_54;
        beta_rate_dot_of_place_55_last = beta_rate_dot_of_place_55;
        beta_rate_dot_of_place_57_last = beta_rate_dot_of_place_57;
        beta_rate_dot_of_place_59_last = beta_rate_dot_of_place_59;
        beta_rate_dot_of_place_62_last = beta_rate_dot_of_place_62;
        beta_rate_dot_of_place_65_last = beta_rate_dot_of_place_65;
        beta_rate_dot_of_place_66_last = beta_rate_dot_of_place_66;
        beta_rate_dot_of_place_68_last = beta_rate_dot_of_place_68;
        beta_rate_dot_of_place_70_last = beta_rate_dot_of_place_70;
        beta_rate_dot_of_place_72_last = beta_rate_dot_of_place_72;
        beta_rate_dot_of_place_74_last = beta_rate_dot_of_place_74;
        beta_rate_dot_of_place_75_last = beta_rate_dot_of_place_75;
        beta_rate_dot_of_place_77_last = beta_rate_dot_of_place_77;
        beta_rate_dot_of_place_79_last = beta_rate_dot_of_place_79;
        beta_rate_dot_of_place_81_last = beta_rate_dot_of_place_81;
        beta_rate_dot_of_place_84_last = beta_rate_dot_of_place_84;
        beta_rate_dot_of_place_87_last = beta_rate_dot_of_place_87;
        beta_rate_dot_of_place_90_last = beta_rate_dot_of_place_90;
        beta_rate_dot_of_place_92_last = beta_rate_dot_of_place_92;
        beta_rate_dot_of_place_94_last = beta_rate_dot_of_place_94;
        beta_rate_dot_of_place_98_last = beta_rate_dot_of_place_98;
        beta_rate_dot_of_place_101_last = beta_rate_dot_of_place_101;
        beta_rate_dot_of_place_102_last = beta_rate_dot_of_place_102;
        beta_rate_dot_of_place_103_last = beta_rate_dot_of_place_103;
        beta_rate_dot_of_place_105_last = beta_rate_dot_of_place_105;
        beta_rate_dot_of_place_107_last = beta_rate_dot_of_place_107;
        beta_rate_dot_of_place_109_last = beta_rate_dot_of_place_109;
        beta_rate_dot_of_place_112_last = beta_rate_dot_of_place_112;
        beta_rate_dot_of_place_113_last = beta_rate_dot_of_place_113;
        beta_rate_dot_of_place_116_last = beta_rate_dot_of_place_116;
        beta_rate_dot_of_place_117_last = beta_rate_dot_of_place_117;
        beta_rate_sq_last = beta_rate_sq;
        beta_rate_dot_of_place_118_last = beta_rate_dot_of_place_118;
        beta_rate_dot_of_place_120_last = beta_rate_dot_of_place_120;
        beta_rate_dot_of_place_122_last = beta_rate_dot_of_place_122;
        beta_rate_dot_of_place_124_last = beta_rate_dot_of_place_124;
        beta_rate_dot_of_place_125_last = beta_rate_dot_of_place_125;
        beta_rate_dot_of_beta_rate_2_last = beta_rate_dot_of_beta_rate_2;
        beta_rate_dot_of_place_127_last = beta_rate_dot_of_place_127;
        beta_rate_dot_of_place_128_last = beta_rate_dot_of_place_128;
        beta_rate_dot_of_place_130_last = beta_rate_dot_of_place_130;
        beta_rate_dot_of_place_132_last = beta_rate_dot_of_place_132;
        beta_rate_dot_of_beta_rate_6_last = beta_rate_dot_of_beta_rate_6;
        beta_rate_dot_2_last = beta_rate_dot_2;
        theta_of_place_last = theta_of_place;
        gamma_of_beta_rate_last = gamma_of_beta_rate;
        phi_minus_90deg_of_place_2_last = phi_minus_90deg_of_place_2;
        omega_of_place_2_last = omega_of_place_2;
    }
}

/// Newton–Euler equations in phi-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEulerPhi90deg;

impl<S: Scalar> System<S> for NewtonEulerPhi90deg {
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        272 * order + SLACK
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
            "sin(phi_minus_90deg)",
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
