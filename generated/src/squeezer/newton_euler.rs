//! Andrews' squeezing mechanism: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (beta_rate', E3_force1, E3_force2, E4_force1, E4_force2, E6_force1, E6_force2, K6_force_k7_frame1, K6_force_k7_frame2, K4_force_k5_frame1, K4_force_k5_frame2, K2_force_k1_frame1, K2_force_k1_frame2, K7_force_n1, K7_force_n2, K5_force_n1, K5_force_n2, K3_force_n1, K3_force_n2, K1_force_n1, K1_force_n2).
//! The kinematic equations are singular where cos(beta + theta - gamma) = 0 and where cos(phi) = 0 and where cos(omega) = 0.
//! The accelerations divide by e, by zf, by cos(beta + theta - gamma), by d, by ss, by zt, by cos(phi), by u, by cos(omega), by xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)), by d1.

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::{coordinate_rates, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows K1 force k1_frame1, K1 force k1_frame2, K1 moment k1_frame3, K2 force k2_frame1, K2 force k2_frame2, K2 moment k2_frame3, K3 force k3_frame1, K3 force k3_frame2, K3 moment k3_frame3, K4 force k4_frame1, K4 force k4_frame2, K4 moment k4_frame3, K5 force k5_frame1, K5 force k5_frame2, K5 moment k5_frame3, K6 force k6_frame1, K6 force k6_frame2, K6 moment k6_frame3, K7 force k7_frame1, K7 force k7_frame2, K7 moment k7_frame3. Entries that are not listed are 0.
///
/// ```text
/// M_1_12 = 1
/// M_1_20 = -cos(beta)
/// M_1_21 = -sin(beta)
/// M_2_1 = m1*ra
/// M_2_13 = 1
/// M_2_20 = sin(beta)
/// M_2_21 = -cos(beta)
/// M_3_1 = I1
/// M_3_13 = rr - ra
/// M_3_20 = -ra*sin(beta)
/// M_3_21 = ra*cos(beta)
/// M_4_1 = m2*rr*sin(theta)
/// M_4_2 = cos(beta + theta)
/// M_4_3 = sin(beta + theta)
/// M_4_4 = cos(beta + theta)
/// M_4_5 = sin(beta + theta)
/// M_4_6 = cos(beta + theta)
/// M_4_7 = sin(beta + theta)
/// M_4_12 = -cos(theta)
/// M_4_13 = -sin(theta)
/// M_5_1 = m2*rr*(cos(theta) - da*cos(beta - gamma)/(d*cos(beta + theta - gamma)))
/// M_5_2 = -sin(beta + theta)
/// M_5_3 = cos(beta + theta)
/// M_5_4 = -sin(beta + theta)
/// M_5_5 = cos(beta + theta)
/// M_5_6 = -sin(beta + theta)
/// M_5_7 = cos(beta + theta)
/// M_5_12 = sin(theta)
/// M_5_13 = -cos(theta)
/// M_6_1 = I2*rr*cos(beta - gamma)/(d*cos(beta + theta - gamma))
/// M_6_2 = sin(beta + theta)*(d - da)
/// M_6_3 = cos(beta + theta)*(da - d)
/// M_6_4 = sin(beta + theta)*(d - da)
/// M_6_5 = cos(beta + theta)*(da - d)
/// M_6_6 = sin(beta + theta)*(d - da)
/// M_6_7 = cos(beta + theta)*(da - d)
/// M_6_12 = da*sin(theta)
/// M_6_13 = -da*cos(theta)
/// M_7_1 = m3*rr*sa*sin(theta)/(ss*cos(beta + theta - gamma))
/// M_7_2 = -cos(gamma)
/// M_7_3 = -sin(gamma)
/// M_7_18 = -cos(gamma)
/// M_7_19 = -sin(gamma)
/// M_8_1 = m3*rr*sb*sin(theta)/(ss*cos(beta + theta - gamma))
/// M_8_2 = sin(gamma)
/// M_8_3 = -cos(gamma)
/// M_8_18 = sin(gamma)
/// M_8_19 = -cos(gamma)
/// M_9_1 = I3*rr*sin(theta)/(ss*cos(beta + theta - gamma))
/// M_9_2 = cos(gamma)*(sa - ss) - sb*sin(gamma)
/// M_9_3 = sin(gamma)*(sa - ss) + sb*cos(gamma)
/// M_9_18 = sa*cos(gamma) - sb*sin(gamma)
/// M_9_19 = sa*sin(gamma) + sb*cos(gamma)
/// M_10_1 = m4*rr*sin(theta)*(sin(phi)*sin(gamma - delta - phi) - cos(gamma - delta)*(ea/e - 1))/(cos(beta + theta - gamma)*cos(phi))
/// M_10_4 = -cos(delta + phi)
/// M_10_5 = -sin(delta + phi)
/// M_10_10 = -cos(phi)
/// M_10_11 = -sin(phi)
/// M_11_1 = m4*rr*sin(theta)*sin(gamma - delta - phi)/cos(beta + theta - gamma)
/// M_11_4 = sin(delta + phi)
/// M_11_5 = -cos(delta + phi)
/// M_11_10 = sin(phi)
/// M_11_11 = -cos(phi)
/// M_12_1 = I4*rr*sin(theta)*cos(gamma - delta)/(e*cos(beta + theta - gamma)*cos(phi))
/// M_12_4 = -ea*cos(delta + phi)
/// M_12_5 = -ea*sin(delta + phi)
/// M_12_10 = cos(phi)*(e - ea)
/// M_12_11 = sin(phi)*(e - ea)
/// M_13_1 = m5*rr*tb*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
/// M_13_10 = 1
/// M_13_16 = -cos(delta)
/// M_13_17 = -sin(delta)
/// M_14_1 = m5*rr*ta*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
/// M_14_11 = 1
/// M_14_16 = sin(delta)
/// M_14_17 = -cos(delta)
/// M_15_1 = I5*rr*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
/// M_15_10 = -tb
/// M_15_11 = zt - ta
/// M_15_16 = tb*cos(delta) - ta*sin(delta)
/// M_15_17 = tb*sin(delta) + ta*cos(delta)
/// M_16_1 = m6*rr*sin(theta)*cos(gamma - epsilon - omega)/cos(beta + theta - gamma)
/// M_16_6 = -cos(epsilon + omega)
/// M_16_7 = -sin(epsilon + omega)
/// M_16_8 = -cos(omega)
/// M_16_9 = -sin(omega)
/// M_17_1 = -m6*rr*sin(theta)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega))/(cos(beta + theta - gamma)*cos(omega))
/// M_17_6 = sin(epsilon + omega)
/// M_17_7 = -cos(epsilon + omega)
/// M_17_8 = sin(omega)
/// M_17_9 = -cos(omega)
/// M_18_1 = I6*rr*sin(theta)*sin(gamma - epsilon)/(zf*cos(beta + theta - gamma)*cos(omega))
/// M_18_6 = fa*sin(epsilon + omega)
/// M_18_7 = -fa*cos(epsilon + omega)
/// M_18_8 = sin(omega)*(fa - zf)
/// M_18_9 = cos(omega)*(zf - fa)
/// M_19_1 = m7*rr*ua*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
/// M_19_8 = 1
/// M_19_14 = -cos(epsilon)
/// M_19_15 = -sin(epsilon)
/// M_20_1 = m7*rr*ub*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
/// M_20_9 = 1
/// M_20_14 = sin(epsilon)
/// M_20_15 = -cos(epsilon)
/// M_21_1 = I7*rr*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
/// M_21_8 = u - ua
/// M_21_9 = -ub
/// M_21_14 = ua*cos(epsilon) - ub*sin(epsilon)
/// M_21_15 = ua*sin(epsilon) + ub*cos(epsilon)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (beta_rate', E3_force1, E3_force2, E4_force1, E4_force2, E6_force1, E6_force2, K6_force_k7_frame1, K6_force_k7_frame2, K4_force_k5_frame1, K4_force_k5_frame2, K2_force_k1_frame1, K2_force_k1_frame2, K7_force_n1, K7_force_n2, K5_force_n1, K5_force_n2, K3_force_n1, K3_force_n2, K1_force_n1, K1_force_n2). Entries that are not listed are 0.
///
/// ```text
/// f_1 = m1*ra*beta_rate^2
/// f_3 = mom
/// f_4 = m2*rr*beta_rate^2*(cos(theta) - da*rr*cos(beta - gamma)^2/(d^2*cos(beta + theta - gamma)^2))
/// f_5 = -m2*rr*beta_rate^2*(sin(theta) + da*(sin(beta - gamma) - rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d + sin(theta)*(sin(beta - gamma) + cos(beta -
///     gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta - gamma))/(d*cos(beta + theta - gamma)))
/// f_6 = I2*rr*beta_rate^2*(sin(beta - gamma) - rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d + sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma -
///     beta - theta))/ss)/cos(beta + theta - gamma))/(d*cos(beta + theta - gamma))
/// f_7 = c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
///     2*cos(gamma)*(xb - xc)))*(l0*(sd + sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb
///     - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd + sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)))/(xc^2 + xb*(xb
///     - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))) +
///     m3*rr*beta_rate^2*(sa*cos(theta) - rr*(sa*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta) + sin(theta)*tan(beta + theta - gamma))/d)
///     - sb*sin(theta)^2/ss)/cos(beta + theta - gamma))/(ss*cos(beta + theta - gamma))
/// f_8 = c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
///     2*cos(gamma)*(xb - xc)))*(sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
///     2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sc + sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - l0*(sc + sin(gamma)*(xb - xc) + cos(gamma)*(yc -
///     yb)))/(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
///     2*cos(gamma)*(xb - xc))) + m3*rr*beta_rate^2*(sb*cos(theta) - rr*(sa*sin(theta)^2/ss + sb*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta -
///     gamma)*(cos(theta) + sin(theta)*tan(beta + theta - gamma))/d))/cos(beta + theta - gamma))/(ss*cos(beta + theta - gamma))
/// f_9 = c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sqrt((xb -
///     xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))) - l0)*(yb - yc + sd*sin(gamma) -
///     sc*cos(gamma))*(sin(gamma)*(sa - sc) + cos(gamma)*(sb - sd))/((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
///     yc)*(sd*sin(gamma) - sc*cos(gamma))) + c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
///     yc)*(sd*sin(gamma) - sc*cos(gamma)))*(l0 - sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
///     yc)*(sd*sin(gamma) - sc*cos(gamma))))*(xb - xc + sc*sin(gamma) + sd*cos(gamma))*(sin(gamma)*(sb - sd) + cos(gamma)*(sc - sa))/((xb - xc)^2 + (yb - yc)^2 + sc^2
///     + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))) + I3*rr*beta_rate^2*cos(theta)*(cos(beta + theta - gamma) -
///     rr*cos(beta - gamma)/d)/(ss*cos(beta + theta - gamma)^2) + I3*rr*beta_rate*sin(theta)*tan(gamma - beta - theta)*(beta_rate -
///     rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma)) + beta_rate*(rr*cos(beta - gamma)/d - cos(beta + theta - gamma))/cos(beta + theta - gamma))/(ss*cos(beta
///     + theta - gamma))
/// f_10 = m4*rr*beta_rate^2*(cos(theta)*(sin(phi)*sin(gamma - delta - phi) - cos(gamma - delta)*(ea/e - 1)) + rr*(cos(theta)*cos(beta - gamma)*(cos(gamma -
///     delta)*(ea/e - 1) - sin(phi)*sin(gamma - delta - phi))/d + sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*(cos(gamma - delta)*(ea/e - 1) -
///     sin(phi)*sin(gamma - delta - phi))/d + sin(theta)*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - ea*(sin(gamma - delta) + cos(gamma -
///     delta)*tan(beta + theta - gamma))/e)/ss + sin(phi)*((cos(gamma - delta)*cos(gamma - delta - phi)/e + (sin(phi)*sin(gamma - delta - phi)^2/zt + cos(gamma -
///     delta)*(sin(gamma - delta - phi)/zt - (cos(gamma - delta) + sin(phi)*sin(gamma - delta - phi) + ea*(sin(gamma - delta - phi)/zt - cos(gamma -
///     delta)/e))/e))/cos(phi))/cos(phi) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss) + sin(gamma - delta - phi)*(sin(gamma -
///     delta - phi) + sin(gamma - delta)*(ea/e - 1)/cos(phi))/zt)))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(phi))
/// f_11 = m4*rr*beta_rate^2*(cos(theta)*sin(gamma - delta - phi) - rr*(cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta -
///     gamma)*sin(gamma - delta - phi)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss -
///     cos(gamma - delta)*(cos(gamma - delta - phi) + (cos(gamma - delta)*(ea/e - 1) - sin(phi)*sin(gamma - delta - phi))/cos(phi))/(e*cos(phi)))))/cos(beta + theta -
///     gamma))/cos(beta + theta - gamma)
/// f_12 = I4*rr*beta_rate^2*(cos(theta)*cos(gamma - delta) - rr*(cos(theta)*cos(beta - gamma)*cos(gamma - delta)/d + sin(theta)*(cos(beta - gamma)*cos(gamma -
///     delta)*tan(beta + theta - gamma)/d + sin(theta)*((cos(gamma - delta)^2*tan(phi)/e + sin(gamma - delta - phi)*(sin(gamma - delta) - cos(gamma -
///     delta)*tan(phi))/zt)/cos(phi) - (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)))/cos(beta + theta - gamma))/(e*cos(beta + theta -
///     gamma)*cos(phi))
/// f_13 = m5*rr*beta_rate^2*(tb*cos(theta)*sin(gamma - delta - phi) - rr*(tb*(cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta -
///     gamma)*sin(gamma - delta - phi)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss -
///     (sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi)))) -
///     ta*sin(theta)^2*sin(gamma - delta - phi)^2/(zt*cos(phi)))/cos(beta + theta - gamma))/(zt*cos(beta + theta - gamma)*cos(phi))
/// f_14 = m5*rr*beta_rate^2*(ta*cos(theta)*sin(gamma - delta - phi) - rr*(tb*sin(theta)^2*sin(gamma - delta - phi)^2/(zt*cos(phi)) + ta*(cos(theta)*cos(beta -
///     gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - delta -
///     phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss - (sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) -
///     sin(gamma - delta - phi)*tan(phi))/e)/cos(phi)))))/cos(beta + theta - gamma))/(zt*cos(beta + theta - gamma)*cos(phi))
/// f_15 = I5*rr*beta_rate^2*(cos(theta)*sin(gamma - delta - phi) - rr*(cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d + sin(theta)*(cos(beta -
///     gamma)*sin(gamma - delta - phi)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss -
///     (sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi))))/cos(beta + theta -
///     gamma))/(zt*cos(beta + theta - gamma)*cos(phi))
/// f_16 = m6*rr*beta_rate^2*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta -
///     gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d + sin(theta)*(sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + (sin(gamma - epsilon)*(fa/zf
///     - 1) + sin(omega)*cos(gamma - epsilon - omega))/cos(omega))/(zf*cos(omega)) - (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
///     gamma))/ss)))/cos(beta + theta - gamma))/cos(beta + theta - gamma)
/// f_17 = -m6*rr*beta_rate^2*(cos(theta)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega)) + rr*(sin(theta)*(cos(beta - gamma)*tan(gamma
///     - beta - theta)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega))/d + sin(theta)*((sin(gamma - epsilon)*tan(gamma - beta - theta) +
///     cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf)/ss + sin(omega)*((sin(gamma - epsilon - omega) + cos(gamma
///     - epsilon - omega)*tan(beta + theta - gamma))/ss - (sin(gamma - epsilon)*sin(gamma - epsilon - omega)/zf + (sin(gamma - epsilon)*(cos(gamma - epsilon - omega)/u
///     + (sin(omega)*cos(gamma - epsilon - omega) - sin(gamma - epsilon) - fa*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf))/zf) - sin(omega)*cos(gamma -
///     epsilon - omega)^2/u)/cos(omega))/cos(omega)) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon)*(fa/zf - 1)/cos(omega) + cos(gamma - epsilon - omega))/u)) -
///     cos(theta)*cos(beta - gamma)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon - omega))/d)/cos(beta + theta - gamma))/(cos(beta + theta -
///     gamma)*cos(omega))
/// f_18 = I6*rr*beta_rate^2*(cos(theta)*sin(gamma - epsilon) + rr*(sin(theta)*(cos(beta - gamma)*sin(gamma - epsilon)*tan(gamma - beta - theta)/d +
///     sin(theta)*((cos(gamma - epsilon - omega)*(cos(gamma - epsilon) + sin(gamma - epsilon)*tan(omega))/u - sin(gamma - epsilon)^2*tan(omega)/zf)/cos(omega) -
///     (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss)) - cos(theta)*cos(beta - gamma)*sin(gamma - epsilon)/d)/cos(beta + theta -
///     gamma))/(zf*cos(beta + theta - gamma)*cos(omega))
/// f_19 = m7*rr*beta_rate^2*(ua*cos(theta)*cos(gamma - epsilon - omega) - rr*(ua*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d +
///     sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d - sin(theta)*((sin(gamma - epsilon - omega) + cos(gamma - epsilon -
///     omega)*tan(beta + theta - gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
///     omega)*tan(omega))/zf)/cos(omega)))) - ub*sin(theta)^2*cos(gamma - epsilon - omega)^2/(u*cos(omega)))/cos(beta + theta - gamma))/(u*cos(beta + theta -
///     gamma)*cos(omega))
/// f_20 = m7*rr*beta_rate^2*(ub*cos(theta)*cos(gamma - epsilon - omega) - rr*(ua*sin(theta)^2*cos(gamma - epsilon - omega)^2/(u*cos(omega)) +
///     ub*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d -
///     sin(theta)*((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u -
///     sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/zf)/cos(omega)))))/cos(beta + theta - gamma))/(u*cos(beta + theta
///     - gamma)*cos(omega))
/// f_21 = I7*rr*beta_rate^2*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta -
///     gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d - sin(theta)*((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta -
///     gamma))/ss + (cos(gamma - epsilon - omega)^2*tan(omega)/u - sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
///     omega)*tan(omega))/zf)/cos(omega))))/cos(beta + theta - gamma))/(u*cos(beta + theta - gamma)*cos(omega))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (beta_rate'), solved for when this code was generated.
///
/// ```text
/// d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma
///     - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) -
///     ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
///     + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
///     fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - 2*m2*da*cos(theta)*cos(beta -
///     gamma)/d)/cos(beta + theta - gamma))
/// beta_rate' = (mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta
///     - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta -
///     gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
///     gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma -
///     delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
///     2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2
///     + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
///     2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d +
///     sin(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(1 - ea/e) +
///     (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + (2*m4*ea*sin(gamma - delta - phi) +
///     sin(phi)*(sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/cos(phi))/e + m4*(sin(gamma - delta) - (cos(gamma
///     - delta)*sin(phi) + 2*sin(gamma - delta - phi))/cos(phi))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4
///     + (I5 + m5*(ta^2 + tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma
///     - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta -
///     phi))))/(ss*zt))/zt - m4*((cos(gamma - delta)*(cos(gamma - delta) + (cos(gamma - delta - phi) + (2*cos(gamma - delta)*(ea/e - 1) - sin(phi)*sin(gamma - delta -
///     phi))/cos(phi))/cos(phi) - ea*(cos(gamma - delta)/e + 2*sin(phi)*tan(beta + theta - gamma)/ss)) - ea*sin(gamma - delta)*sin(phi)/ss)/e + (sin(phi)*(sin(gamma -
///     delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) - sin(gamma - delta - phi)*tan(gamma - beta - theta) - cos(gamma - delta - phi))/ss)) + cos(gamma -
///     delta)*(m4*((ea*((cos(gamma - delta)*(ea*tan(gamma - beta - theta)/ss + tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))) -
///     ea*sin(gamma - delta)/ss)/e + (2*sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) + cos(gamma -
///     delta)*tan(phi)*(cos(gamma - delta)/cos(phi) - cos(gamma - delta - phi)))/e + (sin(phi)*cos(gamma - delta - phi) - sin(gamma - delta) - cos(gamma -
///     delta)*tan(beta + theta - gamma))/ss) + I4*(cos(gamma - delta)^2*tan(phi)/(e*cos(phi)) - (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta -
///     gamma))/ss)/e^2))/cos(phi)^2 + (cos(gamma - epsilon - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(fa/zf - 1) + (sin(gamma -
///     epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u - cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + (sin(omega)*(cos(gamma - epsilon -
///     omega)*(I7 + m7*(ua^2 + ub^2))/u - sin(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2))) - 2*m6*fa*cos(gamma - epsilon - omega))/cos(omega))/zf - m6*(cos(gamma -
///     epsilon) + (sin(gamma - epsilon)*sin(omega) - 2*cos(gamma - epsilon - omega))/cos(omega))) - sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma -
///     epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 + ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon - omega) + cos(gamma -
///     epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma
///     - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma -
///     epsilon)*(sin(gamma - epsilon) + (sin(gamma - epsilon - omega) + (2*sin(gamma - epsilon)*(fa/zf - 1) + sin(omega)*cos(gamma - epsilon -
///     omega))/cos(omega))/cos(omega) - fa*(sin(gamma - epsilon)/zf + 2*sin(omega)*tan(beta + theta - gamma)/ss)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma -
///     beta - theta) + cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma -
///     epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 -
///     m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma -
///     epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) + sin(gamma - epsilon)*(fa/zf -
///     2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma - epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma -
///     beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta -
///     gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss
///     + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2
///     + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma - delta -
///     phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
///     sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon
///     - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) - cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta -
///     phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) -
///     ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
///     + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
///     fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - m2*da*cos(beta - gamma)/d) -
///     c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) +
///     2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc)
///     + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
///     xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc)
///     + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;

/// Kinetic energy T.
///
/// ```text
/// T = beta_rate^2*(I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2
///     + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
///     delta - phi) - ea*(cos(gamma - delta)*(2 - ea/e) + 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon
///     - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
///     omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
///     2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma)))/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;
