//! Andrews' squeezing mechanism: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (beta_rate').
//! The kinematic equations are singular where cos(beta + theta - gamma) = 0 and where cos(phi) = 0 and where cos(omega) = 0.
//! The accelerations divide by e, by zt, by cos(phi), by zf, by u, by cos(omega), by ss, by d, by cos(beta + theta - gamma), by xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)), by d1.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, divisors, inverse_dynamics,
    jacobian_product, linear_system,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows beta_rate.
///
/// ```text
/// M11 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma
///     - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
///     ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
///     + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
///     fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - 2*m2*da*cos(theta)*cos(beta -
///     gamma)/d)/cos(beta + theta - gamma))
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (beta_rate').
///
/// ```text
/// f1 = mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
///     theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta -
///     gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
///     gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma -
///     delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
///     2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2
///     + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
///     2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d +
///     sin(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) +
///     (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta -
///     phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta)
///     + 2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
///     tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta -
///     phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt
///     + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta +
///     theta - gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma - delta - phi)*tan(gamma - beta - theta)
///     - sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
///     delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss - tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
///     (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta - gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta
///     - phi) - cos(gamma - delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) +
///     I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma - epsilon
///     - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u -
///     cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma -
///     epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
///     sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 +
///     ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma -
///     epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
///     - gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma - epsilon -
///     omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
///     omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma -
///     epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss +
///     sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
///     epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma -
///     epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
///     epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon -
///     omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta
///     - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 +
///     sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta
///     - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
///     omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
///     omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) - cos(theta)*((I3
///     + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma -
///     delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
///     (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
///     epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
///     omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
///     2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
///     xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
///     2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
///     yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
///     2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (beta_rate'), solved for when this code was generated.
///
/// ```text
/// d1 = I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma
///     - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) +
///     ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7
///     + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) +
///     fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - 2*m2*da*cos(theta)*cos(beta -
///     gamma)/d)/cos(beta + theta - gamma))
/// beta_rate' = (mom - rr*(rr*beta_rate^2*(m2*da*cos(theta)*sin(beta - gamma) - cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta
///     - theta)/(d*cos(beta + theta - gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta -
///     gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)))/d + sin(theta)*(rr*beta_rate^2*((rr*(m2*da*(cos(beta -
///     gamma)^2/d - cos(theta)*sin(beta - gamma)/ss)/d + (sin(theta)*(cos(beta - gamma)*tan(beta + theta - gamma)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma -
///     delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
///     2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2
///     + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
///     2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d +
///     sin(theta)*(tan(gamma - beta - theta)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (sin(gamma - delta - phi)*((m4*cos(gamma - delta)*sin(gamma - delta - phi)*(ea/e - 1) +
///     (cos(gamma - delta)*((sin(gamma - delta)*(I4/e + m4*ea*(ea/e - 2)) - cos(gamma - delta - phi)*(I5 + m5*(ta^2 + tb^2))/zt + tan(phi)*(sin(gamma - delta -
///     phi)*((I5 + m5*(ta^2 + tb^2))/zt + 2*m4*ea*sin(phi)) - cos(gamma - delta)*(I4/e + m4*ea*(ea/e - 2))))/e + m4*(sin(gamma - delta) - tan(phi)*(cos(gamma - delta)
///     + 2*sin(phi)*sin(gamma - delta - phi)))) - sin(phi)*sin(gamma - delta - phi)*(m4*sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)*(m4 + (I5 + m5*(ta^2 +
///     tb^2))/zt^2)/cos(phi)))/cos(phi) + (I5*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + m5*(ta^2*(sin(gamma - delta -
///     phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))))/(ss*zt))/zt
///     + m4*((ea*sin(gamma - delta)*sin(phi)/ss + cos(gamma - delta)*(cos(gamma - delta)*(1 - ea/e) - cos(gamma - delta - phi)/cos(phi) + sin(phi)*(2*ea*tan(beta +
///     theta - gamma)/ss + (2*cos(gamma - delta)*sin(phi)*(1 - ea/e) + sin(gamma - delta - phi))/cos(phi)^2)))/e + (sin(gamma - delta - phi)*tan(gamma - beta - theta)
///     - sin(phi)*(sin(gamma - delta) + 2*cos(gamma - delta)*tan(beta + theta - gamma)) + cos(gamma - delta - phi))/ss)) - cos(gamma - delta)*(m4*((ea*((ea*sin(gamma -
///     delta)/ss + cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss - tan(phi)*(cos(gamma - delta)*(ea/e - 2)/cos(phi) + cos(gamma - delta - phi))))/e +
///     (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma - delta) - 2*cos(gamma - delta)*tan(beta + theta - gamma))/ss) + cos(gamma - delta)*tan(phi)*(cos(gamma - delta
///     - phi) - cos(gamma - delta)/cos(phi)))/e + (sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss) +
///     I4*((sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta - gamma))/ss - cos(gamma - delta)^2*tan(phi)/(e*cos(phi)))/e^2))/cos(phi)^2 + (cos(gamma - epsilon
///     - omega)*((m6*sin(gamma - epsilon)*cos(gamma - epsilon - omega)*(1 - fa/zf) + (sin(gamma - epsilon)*((sin(gamma - epsilon - omega)*(I7 + m7*(ua^2 + ub^2))/u -
///     cos(gamma - epsilon)*(I6/zf + m6*fa*(fa/zf - 2)) + tan(omega)*(cos(gamma - epsilon - omega)*((I7 + m7*(ua^2 + ub^2))/u - 2*m6*fa*sin(omega)) - sin(gamma -
///     epsilon)*(I6/zf + m6*fa*(fa/zf - 2))))/zf - m6*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))) -
///     sin(omega)*cos(gamma - epsilon - omega)*(m6*cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)*(m6 + (I7 + m7*(ua^2 +
///     ub^2))/u^2)/cos(omega)))/cos(omega) - (I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + m7*(ua^2*(sin(gamma -
///     epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta
///     - gamma))))/(ss*u))/u + m6*((fa*cos(gamma - epsilon)*sin(omega)/ss + sin(gamma - epsilon)*(sin(gamma - epsilon)*(fa/zf - 1) + sin(gamma - epsilon -
///     omega)/cos(omega) + sin(omega)*(2*fa*tan(gamma - beta - theta)/ss + (2*sin(gamma - epsilon)*sin(omega)*(fa/zf - 1) + cos(gamma - epsilon -
///     omega))/cos(omega)^2)))/zf - (sin(omega)*(2*sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon)) + sin(gamma - epsilon - omega) + cos(gamma -
///     epsilon - omega)*tan(beta + theta - gamma))/ss)) + sin(gamma - epsilon)*(I6*((sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/ss +
///     sin(gamma - epsilon)^2*tan(omega)/(zf*cos(omega)))/zf^2 - m6*((fa*((2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) - fa*(sin(gamma -
///     epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon))/zf + sin(omega)*sin(gamma - epsilon - omega))/ss - sin(gamma - epsilon)*tan(omega)*(sin(gamma -
///     epsilon - omega) + sin(gamma - epsilon)*(fa/zf - 2)/cos(omega))/zf) + sin(gamma - epsilon)*tan(omega)*(sin(gamma - epsilon - omega) - sin(gamma -
///     epsilon)/cos(omega)))/zf - (sin(gamma - epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon -
///     omega))/ss)))/cos(omega)^2)) + cos(beta - gamma)*((I2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta
///     - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 + m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 +
///     sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta
///     - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon -
///     omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
///     omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)) - cos(theta)*((I3
///     + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma -
///     delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
///     (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
///     epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
///     omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) - m2*da*cos(beta - gamma)/d) - c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc +
///     2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
///     xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
///     2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
///     yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
///     2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc))))))/cos(beta + theta - gamma))/d1
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
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
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = beta_rate^2*(I1 + m1*ra^2 + rr^2*(m2 + ((cos(beta - gamma)^2*(I2 + m2*da^2)/d^2 + sin(theta)^2*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2
///     + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma -
///     delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon
///     - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon -
///     omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/cos(beta + theta - gamma) -
///     2*m2*da*cos(theta)*cos(beta - gamma)/d)/cos(beta + theta - gamma)))/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = c0*(l0 - sqrt((xb - xc)^2 + (yb - yc)^2 + sc^2 + sd^2 + 2*(xb - xc)*(sc*sin(gamma) + sd*cos(gamma)) + 2*(yb - yc)*(sd*sin(gamma) - sc*cos(gamma))))^2/2 -
///     mom*beta
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
