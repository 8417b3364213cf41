//! Andrews' squeezing mechanism: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (beta'', theta'', gamma'', delta'', phi'', epsilon'', omega'', lambda_E3_1, lambda_E3_2, lambda_E4_1, lambda_E4_2, lambda_E6_1, lambda_E6_2).
//! The kinematic equations are singular where cos(beta + theta - gamma) = 0 and where cos(phi) = 0 and where cos(omega) = 0.
//! The accelerations divide by cos(beta + theta - gamma), by ss, by d, by cos(phi), by e, by zt, by cos(omega), by zf, by u, by xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)), by d1.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
    linear_system,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows beta, theta, gamma, delta, phi, epsilon, omega, constraint E3_1, constraint E3_2, constraint E4_1, constraint E4_2, constraint E6_1, constraint E6_2. Entries that are not listed are 0.
///
/// ```text
/// M_1_1 = I1 + I2 + m1*ra^2 + m2*(rr^2 + da*(da - 2*rr*cos(theta)))
/// M_1_2 = I2 + m2*da*(da - rr*cos(theta))
/// M_1_8 = d*sin(beta + theta) - rr*sin(beta)
/// M_1_9 = rr*cos(beta) - d*cos(beta + theta)
/// M_1_10 = d*sin(beta + theta) - rr*sin(beta)
/// M_1_11 = rr*cos(beta) - d*cos(beta + theta)
/// M_1_12 = d*sin(beta + theta) - rr*sin(beta)
/// M_1_13 = rr*cos(beta) - d*cos(beta + theta)
/// M_2_1 = I2 + m2*da*(da - rr*cos(theta))
/// M_2_2 = I2 + m2*da^2
/// M_2_8 = d*sin(beta + theta)
/// M_2_9 = -d*cos(beta + theta)
/// M_2_10 = d*sin(beta + theta)
/// M_2_11 = -d*cos(beta + theta)
/// M_2_12 = d*sin(beta + theta)
/// M_2_13 = -d*cos(beta + theta)
/// M_3_3 = I3 + m3*(sa^2 + sb^2)
/// M_3_8 = -ss*cos(gamma)
/// M_3_9 = -ss*sin(gamma)
/// M_4_4 = I4 + I5 + m5*(ta^2 + tb^2) + m4*((e - ea)^2 + zt*(zt + 2*sin(phi)*(e - ea)))
/// M_4_5 = I4 + m4*(e - ea)*(e - ea + zt*sin(phi))
/// M_4_10 = zt*sin(delta) - e*cos(delta + phi)
/// M_4_11 = -zt*cos(delta) - e*sin(delta + phi)
/// M_5_4 = I4 + m4*(e - ea)*(e - ea + zt*sin(phi))
/// M_5_5 = I4 + m4*(e - ea)^2
/// M_5_10 = -e*cos(delta + phi)
/// M_5_11 = -e*sin(delta + phi)
/// M_6_6 = I6 + I7 + m7*(ua^2 + ub^2) + m6*((zf - fa)^2 + u*(u + 2*sin(omega)*(fa - zf)))
/// M_6_7 = I6 + m6*(zf - fa)*(zf - fa - u*sin(omega))
/// M_6_12 = zf*sin(epsilon + omega) - u*cos(epsilon)
/// M_6_13 = -u*sin(epsilon) - zf*cos(epsilon + omega)
/// M_7_6 = I6 + m6*(zf - fa)*(zf - fa - u*sin(omega))
/// M_7_7 = I6 + m6*(zf - fa)^2
/// M_7_12 = zf*sin(epsilon + omega)
/// M_7_13 = -zf*cos(epsilon + omega)
/// M_8_1 = rr*sin(beta) - d*sin(beta + theta)
/// M_8_2 = -d*sin(beta + theta)
/// M_8_3 = ss*cos(gamma)
/// M_9_1 = d*cos(beta + theta) - rr*cos(beta)
/// M_9_2 = d*cos(beta + theta)
/// M_9_3 = ss*sin(gamma)
/// M_10_1 = rr*sin(beta) - d*sin(beta + theta)
/// M_10_2 = -d*sin(beta + theta)
/// M_10_4 = e*cos(delta + phi) - zt*sin(delta)
/// M_10_5 = e*cos(delta + phi)
/// M_11_1 = d*cos(beta + theta) - rr*cos(beta)
/// M_11_2 = d*cos(beta + theta)
/// M_11_4 = zt*cos(delta) + e*sin(delta + phi)
/// M_11_5 = e*sin(delta + phi)
/// M_12_1 = rr*sin(beta) - d*sin(beta + theta)
/// M_12_2 = -d*sin(beta + theta)
/// M_12_6 = u*cos(epsilon) - zf*sin(epsilon + omega)
/// M_12_7 = -zf*sin(epsilon + omega)
/// M_13_1 = d*cos(beta + theta) - rr*cos(beta)
/// M_13_2 = d*cos(beta + theta)
/// M_13_6 = u*sin(epsilon) + zf*cos(epsilon + omega)
/// M_13_7 = zf*cos(epsilon + omega)
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (beta'', theta'', gamma'', delta'', phi'', epsilon'', omega'', lambda_E3_1, lambda_E3_2, lambda_E4_1, lambda_E4_2, lambda_E6_1, lambda_E6_2).
///
/// ```text
/// f_1 = mom - m2*da*rr*theta'*sin(theta)*(2*beta' + theta')
/// f_2 = m2*da*rr*beta'^2*sin(theta)
/// f_3 = c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) -
///     sc*cos(gamma)))*(sc*cos(gamma) - sd*sin(gamma))*(l0 - sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb -
///     yc)*(sd*sin(gamma) - sc*cos(gamma))))*(xb - xc + sc*sin(gamma) + sd*cos(gamma))/((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) +
///     sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))) + c0*sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) +
///     2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))*(sc*sin(gamma) + sd*cos(gamma))*(l0 - sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) +
///     sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))))*(yb - yc + sd*sin(gamma) - sc*cos(gamma))/((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb -
///     xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma)))
/// f_4 = m4*zt*phi'*cos(phi)*(ea - e)*(2*delta' + phi')
/// f_5 = m4*zt*delta'^2*cos(phi)*(e - ea)
/// f_6 = m6*u*omega'*cos(omega)*(zf - fa)*(2*epsilon' + omega')
/// f_7 = m6*u*epsilon'^2*cos(omega)*(fa - zf)
/// f_8 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + ss*gamma'^2*sin(gamma)
/// f_9 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) - ss*gamma'^2*cos(gamma)
/// f_10 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + zt*delta'^2*cos(delta) + e*sin(delta + phi)*(delta' + phi')^2
/// f_11 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) + zt*delta'^2*sin(delta) - e*cos(delta + phi)*(delta' + phi')^2
/// f_12 = d*cos(beta + theta)*(beta' + theta')^2 - rr*beta'^2*cos(beta) + u*epsilon'^2*sin(epsilon) + zf*cos(epsilon + omega)*(epsilon' + omega')^2
/// f_13 = d*sin(beta + theta)*(beta' + theta')^2 - rr*beta'^2*sin(beta) - u*epsilon'^2*cos(epsilon) + zf*sin(epsilon + omega)*(epsilon' + omega')^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (beta'', theta'', gamma'', delta'', phi'', epsilon'', omega''), solved for when this code was generated.
///
/// ```text
/// d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma
///     - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
///     ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
///     + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
///     fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - 2*m2*da*cos(theta)*cos(beta -
///     gamma)/d)/cos(beta + theta - gamma))
/// beta_rate' = (mom + rr^2*beta'^2*sin(theta)*(I3 + m3*(sa^2 + sb^2))*(cos(theta) - rr*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta)
///     + sin(theta)*tan(beta + theta - gamma))/d)/cos(beta + theta - gamma))/(ss^2*cos(beta + theta - gamma)^2) + rr^2*beta'^2*(sin(beta - gamma) - rr*(cos(beta -
///     gamma)^2*tan(beta + theta - gamma)/d + sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta))/ss)/cos(beta + theta - gamma))*(I2*cos(beta
///     - gamma)/(d*cos(beta + theta - gamma)) + m2*da*(da*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - cos(theta)))/(d*cos(beta + theta - gamma)) +
///     rr^2*beta'^2*sin(theta)*(cos(theta)*sin(gamma - delta - phi) + rr*(sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(gamma - beta - theta)/d +
///     sin(theta)*((sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma - delta)*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi) - (sin(gamma
///     - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss)) - cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d)/cos(beta + theta -
///     gamma))*(I4*cos(gamma - delta)/e + sin(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + m4*(sin(gamma - delta - phi)*(zt + sin(phi)*(e - ea)) + cos(gamma -
///     delta)*(e + zt*sin(phi) + ea*((ea - zt*sin(phi))/e - 2))))/(zt*cos(beta + theta - gamma)^2*cos(phi)^2) - rr^2*beta'^2*sin(theta)*(cos(theta)*(sin(gamma - delta
///     - phi)/zt - cos(gamma - delta)/e) + rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d +
///     sin(theta)*(sin(theta)*(((cos(gamma - delta)^2*tan(phi)/e + (cos(gamma - delta)*cos(gamma - delta - phi) + sin(gamma - delta - phi)*(sin(gamma - delta) -
///     2*cos(gamma - delta)*tan(phi)))/zt)/cos(phi) - (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)/e + (sin(gamma - delta -
///     phi)^2*tan(phi)/(zt*cos(phi)) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss)/zt) + cos(beta - gamma)*tan(beta + theta -
///     gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d))/cos(beta + theta - gamma))*(I4*cos(gamma - delta)/e + m4*(ea*(cos(gamma - delta)*(ea/e - 2) -
///     sin(phi)*sin(gamma - delta - phi)) + e*(cos(gamma - delta) + sin(phi)*sin(gamma - delta - phi))))/(cos(beta + theta - gamma)^2*cos(phi)^2) +
///     rr^2*beta'^2*sin(theta)*(cos(theta)*cos(gamma - epsilon - omega) - rr*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta -
///     gamma)*cos(gamma - epsilon - omega)*tan(beta + theta - gamma)/d + sin(theta)*((sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
///     omega)*tan(omega))/zf - cos(gamma - epsilon - omega)^2*tan(omega)/u)/cos(omega) - (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
///     - gamma))/ss)))/cos(beta + theta - gamma))*(I6*sin(gamma - epsilon)/zf + cos(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u + m6*(cos(gamma - epsilon -
///     omega)*(u + sin(omega)*(fa - zf)) + sin(gamma - epsilon)*(zf - u*sin(omega) + fa*((fa + u*sin(omega))/zf - 2))))/(u*cos(beta + theta - gamma)^2*cos(omega)^2) -
///     rr^2*beta'^2*sin(theta)*(cos(theta)*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf) + rr*(cos(theta)*cos(beta - gamma)*(sin(gamma - epsilon)/zf -
///     cos(gamma - epsilon - omega)/u)/d + sin(theta)*(sin(theta)*(((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss +
///     (cos(gamma - epsilon - omega)^2*tan(omega)/u - (sin(gamma - epsilon)*sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon) +
///     2*sin(gamma - epsilon)*tan(omega)))/zf)/cos(omega))/u + ((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma -
///     epsilon)^2*tan(omega)/(zf*cos(omega)))/zf) + cos(beta - gamma)*tan(beta + theta - gamma)*(sin(gamma - epsilon)/zf - cos(gamma - epsilon - omega)/u)/d))/cos(beta
///     + theta - gamma))*(I6*sin(gamma - epsilon)/zf + m6*(fa*(sin(gamma - epsilon)*(fa/zf - 2) + sin(omega)*cos(gamma - epsilon - omega)) + zf*(sin(gamma - epsilon) -
///     sin(omega)*cos(gamma - epsilon - omega))))/(cos(beta + theta - gamma)^2*cos(omega)^2) + rr*sin(theta)*((c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) +
///     sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) +
///     cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
///     + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
///     yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
///     2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + m2*da*rr*beta'^2*cos(beta - gamma)/d - m4*(phi'^2*sin(gamma - delta - phi)*(e - ea) +
///     delta'*(delta'*(e*sin(gamma - delta - phi) - zt*cos(gamma - delta) + ea*(zt*cos(gamma - delta)/e - sin(gamma - delta - phi))) + 2*phi'*sin(gamma - delta -
///     phi)*(e - ea))) + m6*(omega'^2*cos(gamma - epsilon - omega)*(zf - fa) + epsilon'*(epsilon'*(u*sin(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon -
///     omega)*(zf - fa)) + 2*omega'*cos(gamma - epsilon - omega)*(zf - fa))))/cos(beta + theta - gamma) - m2*da*(theta'^2 + beta'*(beta' + 2*theta'))))/d1
/// beta'' = beta_rate'
/// theta'' = rr*beta'^2*(rr*(cos(beta - gamma)^2*tan(beta + theta - gamma)/d + sin(theta)*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta -
///     theta))/ss)/cos(beta + theta - gamma) - sin(beta - gamma))/(d*cos(beta + theta - gamma)) + beta_rate'*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
/// gamma'' = rr*beta'^2*(rr*(sin(theta)^2*tan(gamma - beta - theta)/ss + cos(beta - gamma)*(cos(theta) + sin(theta)*tan(beta + theta - gamma))/d)/cos(beta + theta
///     - gamma) - cos(theta))/(ss*cos(beta + theta - gamma)) + rr*beta_rate'*sin(theta)/(ss*cos(beta + theta - gamma))
/// delta'' = rr*beta_rate'*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi)) - rr*beta'^2*(cos(theta)*sin(gamma - delta - phi) +
///     rr*(sin(theta)*(cos(beta - gamma)*sin(gamma - delta - phi)*tan(gamma - beta - theta)/d + sin(theta)*((sin(gamma - delta - phi)^2*tan(phi)/zt + cos(gamma -
///     delta)*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))/e)/cos(phi) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta -
///     phi))/ss)) - cos(theta)*cos(beta - gamma)*sin(gamma - delta - phi)/d)/cos(beta + theta - gamma))/(zt*cos(beta + theta - gamma)*cos(phi))
/// phi'' = rr*beta'^2*(cos(theta)*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e) + rr*(cos(theta)*cos(beta - gamma)*(cos(gamma - delta)/e - sin(gamma - delta
///     - phi)/zt)/d + sin(theta)*(sin(theta)*(((cos(gamma - delta)^2*tan(phi)/e + (cos(gamma - delta)*cos(gamma - delta - phi) + sin(gamma - delta - phi)*(sin(gamma -
///     delta) - 2*cos(gamma - delta)*tan(phi)))/zt)/cos(phi) - (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss)/e + (sin(gamma - delta -
///     phi)^2*tan(phi)/(zt*cos(phi)) - (sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss)/zt) + cos(beta - gamma)*tan(beta + theta -
///     gamma)*(cos(gamma - delta)/e - sin(gamma - delta - phi)/zt)/d))/cos(beta + theta - gamma))/(cos(beta + theta - gamma)*cos(phi)) +
///     rr*beta_rate'*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta + theta - gamma)*cos(phi))
/// epsilon'' = rr*beta'^2*(rr*(cos(theta)*cos(beta - gamma)*cos(gamma - epsilon - omega)/d + sin(theta)*(cos(beta - gamma)*cos(gamma - epsilon - omega)*tan(beta +
///     theta - gamma)/d + sin(theta)*((sin(gamma - epsilon)*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))/zf - cos(gamma - epsilon -
///     omega)^2*tan(omega)/u)/cos(omega) - (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss)))/cos(beta + theta - gamma) -
///     cos(theta)*cos(gamma - epsilon - omega))/(u*cos(beta + theta - gamma)*cos(omega)) + rr*beta_rate'*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta -
///     gamma)*cos(omega))
/// omega'' = rr*beta'^2*(cos(theta)*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf) + rr*(cos(theta)*cos(beta - gamma)*(sin(gamma - epsilon)/zf -
///     cos(gamma - epsilon - omega)/u)/d + sin(theta)*(sin(theta)*(((sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss +
///     (cos(gamma - epsilon - omega)^2*tan(omega)/u - (sin(gamma - epsilon)*sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*(cos(gamma - epsilon) +
///     2*sin(gamma - epsilon)*tan(omega)))/zf)/cos(omega))/u + ((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss + sin(gamma -
///     epsilon)^2*tan(omega)/(zf*cos(omega)))/zf) + cos(beta - gamma)*tan(beta + theta - gamma)*(sin(gamma - epsilon)/zf - cos(gamma - epsilon - omega)/u)/d))/cos(beta
///     + theta - gamma))/(cos(beta + theta - gamma)*cos(omega)) + rr*beta_rate'*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon - omega))/(u*zf*cos(beta +
///     theta - gamma)*cos(omega))
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// beta'
/// theta'
/// gamma'
/// delta'
/// phi'
/// epsilon'
/// omega'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = beta'^2*(I1 + I2 + m1*ra^2 + m2*(rr^2 + da*(da - 2*rr*cos(theta))))/2 + theta'^2*(I2 + m2*da^2)/2 + beta'*theta'*(I2 + m2*da*(da - rr*cos(theta))) +
///     gamma'^2*(I3 + m3*(sa^2 + sb^2))/2 + delta'^2*(I4 + I5 + m5*(ta^2 + tb^2) + m4*((e - ea)^2 + zt*(zt + 2*sin(phi)*(e - ea))))/2 + phi'^2*(I4 + m4*(e - ea)^2)/2 +
///     delta'*phi'*(I4 + m4*(e - ea)*(e - ea + zt*sin(phi))) + epsilon'^2*(I6 + I7 + m7*(ua^2 + ub^2) + m6*((zf - fa)^2 + u*(u + 2*sin(omega)*(fa - zf))))/2 +
///     omega'^2*(I6 + m6*(zf - fa)^2)/2 + epsilon'*omega'*(I6 + m6*(zf - fa)*(zf - fa - u*sin(omega)))
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// beta_rate = beta'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// beta_rate' = beta''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// beta' = beta_rate
/// theta' = beta_rate*(rr*cos(beta - gamma)/(d*cos(beta + theta - gamma)) - 1)
/// gamma' = rr*beta_rate*sin(theta)/(ss*cos(beta + theta - gamma))
/// delta' = rr*beta_rate*sin(theta)*sin(gamma - delta - phi)/(zt*cos(beta + theta - gamma)*cos(phi))
/// phi' = rr*beta_rate*sin(theta)*(zt*cos(gamma - delta) - e*sin(gamma - delta - phi))/(e*zt*cos(beta + theta - gamma)*cos(phi))
/// epsilon' = rr*beta_rate*sin(theta)*cos(gamma - epsilon - omega)/(u*cos(beta + theta - gamma)*cos(omega))
/// omega' = rr*beta_rate*sin(theta)*(u*sin(gamma - epsilon) - zf*cos(gamma - epsilon - omega))/(u*zf*cos(beta + theta - gamma)*cos(omega))
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
