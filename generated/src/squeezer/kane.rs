//! Andrews' squeezing mechanism: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (beta_rate').
//! The kinematic equations are singular where cos(phi) = 0 and where cos(omega) = 0 and where cos(beta + theta - gamma) = 0.
//! The accelerations divide by e, by zt, by u, by zf, by cos(phi), by cos(omega), by ss, by d, by cos(beta + theta - gamma), by xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)), by d1.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, divisors, inverse_dynamics,
    jacobian, taylor,
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
/// f1 = mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta - gamma))) +
///     m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta
///     - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc
///     + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb -
///     xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) +
///     2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb -
///     yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd +
///     2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma -
///     delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) +
///     2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2
///     + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
///     2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2) +
///     rr*(m2*da*(cos(theta)*sin(beta - gamma)/ss - cos(beta - gamma)^2/d)/d + (sin(theta)*(cos(beta - gamma)*tan(gamma - beta - theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 +
///     (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta)
///     + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma -
///     epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) -
///     2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2)/d +
///     sin(theta)*(tan(beta + theta - gamma)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - delta)*((I4*(sin(gamma - delta) + cos(gamma - delta)*tan(beta + theta -
///     gamma))/(e*ss) + m4*(ea*((cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + sin(gamma - delta - phi) + tan(phi)*((2*cos(gamma - delta) +
///     2*sin(phi)*sin(gamma - delta - phi) + ea*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e))/cos(phi) - cos(gamma - delta - phi))) + ea*sin(gamma -
///     delta)*(1/ss - sin(gamma - delta - phi)/(zt*cos(phi))))/e - sin(gamma - delta - phi)*(2*sin(phi)*tan(beta + theta - gamma)/ss + (sin(gamma - delta - phi) +
///     2*(tan(phi)*(cos(gamma - delta) + sin(phi)*sin(gamma - delta - phi)) - sin(gamma - delta))/cos(phi))/zt) + (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma -
///     delta) - 2*cos(gamma - delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*sin(gamma - delta - phi) + (sin(gamma - delta - phi)*cos(gamma - delta - phi)
///     - sin(phi)*((sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))/cos(phi) - cos(gamma - delta)*cos(gamma
///     - delta - phi)))/cos(phi)) + (sin(gamma - delta - phi)*((I5*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi)) + m5*(ta^2*(cos(gamma - delta - phi)
///     - sin(gamma - delta - phi)*tan(phi)) + tb^2*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))))/zt + I4*(cos(gamma - delta)*tan(phi) - sin(gamma -
///     delta))/e)/zt - I4*cos(gamma - delta)^2*tan(phi)/e^2)/cos(phi))/e + m4*(sin(gamma - delta - phi)*(2*sin(phi)*tan(beta + theta - gamma)/ss + (sin(gamma - delta -
///     phi) + (tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)) - sin(gamma - delta))/cos(phi))/zt) + (sin(gamma - delta) + cos(gamma -
///     delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss)) - sin(gamma - delta - phi)*(((m5*((ta^2*(sin(gamma - delta - phi)*tan(gamma - beta -
///     theta) + cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)))/ss - sin(gamma - delta -
///     phi)^2*tan(phi)*(ta^2 + tb^2)/(zt*cos(phi))) + I5*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss - sin(gamma - delta -
///     phi)^2*tan(phi)/(zt*cos(phi))))/zt - m4*sin(gamma - delta - phi)*tan(phi)*(sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)/cos(phi)))/zt +
///     m4*(sin(gamma - delta)*sin(phi)*(ea/e - 1) + sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss))/cos(phi)^2 + (cos(gamma -
///     epsilon - omega)*(((m7*(cos(gamma - epsilon - omega)^2*tan(omega)*(ua^2 + ub^2)/(u*cos(omega)) + (ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
///     omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)))/ss) + I7*(cos(gamma - epsilon
///     - omega)^2*tan(omega)/(u*cos(omega)) + (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss))/u + m6*cos(gamma - epsilon -
///     omega)*tan(omega)*(cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)/cos(omega)))/u + m6*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma
///     - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss) - sin(gamma - epsilon)*((I6*(sin(gamma - epsilon)*tan(gamma - beta - theta) +
///     cos(gamma - epsilon))/(ss*zf) + m6*(fa*((sin(gamma - epsilon)*(fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega) + tan(omega)*(sin(gamma - epsilon
///     - omega) + (2*sin(omega)*cos(gamma - epsilon - omega) - 2*sin(gamma - epsilon) - fa*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf))/cos(omega))) +
///     fa*cos(gamma - epsilon)*(1/ss - cos(gamma - epsilon - omega)/(u*cos(omega))))/zf - cos(gamma - epsilon - omega)*(2*sin(omega)*tan(beta + theta - gamma)/ss +
///     (cos(gamma - epsilon - omega) - 2*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - sin(omega)*cos(gamma - epsilon - omega)))/cos(omega))/u) -
///     (2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss) - sin(gamma - epsilon)*cos(gamma -
///     epsilon - omega) + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + sin(omega)*((cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
///     epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))/cos(omega) - sin(gamma - epsilon)*sin(gamma - epsilon - omega)))/cos(omega)) + (I6*sin(gamma -
///     epsilon)^2*tan(omega)/zf^2 + cos(gamma - epsilon - omega)*((I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega)) + m7*(ua^2*(sin(gamma -
///     epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))))/u - I6*(cos(gamma
///     - epsilon) + sin(gamma - epsilon)*tan(omega))/zf)/u)/cos(omega))/zf + m6*(cos(gamma - epsilon - omega)*(2*sin(omega)*tan(beta + theta - gamma)/ss + (cos(gamma -
///     epsilon - omega) - (cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))/cos(omega))/u) + (sin(gamma -
///     epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) - cos(beta - gamma)*((I2*(sin(beta -
///     gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 +
///     m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
///     m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
///     2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
///     m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf -
///     2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta - gamma))))/cos(beta + theta - gamma)
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
/// beta_rate' = (mom + rr*(rr*beta_rate^2*(cos(beta - gamma)*(I2*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta - theta)/(d*cos(beta + theta -
///     gamma))) + m2*da*(rr*cos(theta)*cos(beta - gamma)*tan(beta + theta - gamma) + da*(sin(beta - gamma) + rr*cos(beta - gamma)^2*tan(gamma - beta -
///     theta)/(d*cos(beta + theta - gamma)))))/(d*cos(beta + theta - gamma)) - m2*da*cos(theta)*sin(beta - gamma))/d + sin(theta)*(c0*sqrt(xc^2 + xb*(xb - 2*xc) + yc^2
///     + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb -
///     xc)))*(l0*(sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc)) - sd*(sin(gamma)*(xb - xc) + cos(gamma)*(yc - yb))) + sqrt(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb -
///     2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc) + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))*(sd*(sin(gamma)*(xb - xc) +
///     cos(gamma)*(yc - yb)) - sc*(sin(gamma)*(yb - yc) + cos(gamma)*(xb - xc))))/(ss*(xc^2 + xb*(xb - 2*xc) + yc^2 + yb*(yb - 2*yc) + sc*(sc + 2*sin(gamma)*(xb - xc)
///     + 2*cos(gamma)*(yc - yb)) + sd*(sd + 2*sin(gamma)*(yb - yc) + 2*cos(gamma)*(xb - xc)))) + rr*beta_rate^2*(m2*da*cos(beta - gamma)/d + (cos(theta)*((I3 +
///     m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 + cos(gamma -
///     delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 +
///     (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 + sin(gamma -
///     epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon -
///     omega))/zf)))/cos(omega)^2) + rr*(m2*da*(cos(theta)*sin(beta - gamma)/ss - cos(beta - gamma)^2/d)/d + (sin(theta)*(cos(beta - gamma)*tan(gamma - beta -
///     theta)*((I3 + m3*(sa^2 + sb^2))/ss^2 + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 + m4*(sin(gamma - delta - phi)^2 +
///     cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) - 2*sin(phi)*sin(gamma - delta -
///     phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 + m6*(cos(gamma - epsilon - omega)^2 +
///     sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf - 2) + 2*sin(omega)*cos(gamma - epsilon
///     - omega))/zf)))/cos(omega)^2)/d + sin(theta)*(tan(beta + theta - gamma)*(I3 + m3*(sa^2 + sb^2))/ss^3 + (cos(gamma - delta)*((I4*(sin(gamma - delta) + cos(gamma
///     - delta)*tan(beta + theta - gamma))/(e*ss) + m4*(ea*((cos(gamma - delta)*(ea*tan(beta + theta - gamma)/ss + sin(gamma - delta - phi) + tan(phi)*((2*cos(gamma -
///     delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(sin(gamma - delta - phi)/zt - cos(gamma - delta)/e))/cos(phi) - cos(gamma - delta - phi))) + ea*sin(gamma -
///     delta)*(1/ss - sin(gamma - delta - phi)/(zt*cos(phi))))/e - sin(gamma - delta - phi)*(2*sin(phi)*tan(beta + theta - gamma)/ss + (sin(gamma - delta - phi) +
///     2*(tan(phi)*(cos(gamma - delta) + sin(phi)*sin(gamma - delta - phi)) - sin(gamma - delta))/cos(phi))/zt) + (sin(phi)*cos(gamma - delta - phi) - 2*sin(gamma -
///     delta) - 2*cos(gamma - delta)*tan(beta + theta - gamma))/ss) - cos(gamma - delta)*sin(gamma - delta - phi) + (sin(gamma - delta - phi)*cos(gamma - delta - phi)
///     - sin(phi)*((sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)))/cos(phi) - cos(gamma - delta)*cos(gamma
///     - delta - phi)))/cos(phi)) + (sin(gamma - delta - phi)*((I5*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi)) + m5*(ta^2*(cos(gamma - delta - phi)
///     - sin(gamma - delta - phi)*tan(phi)) + tb^2*(cos(gamma - delta - phi) - sin(gamma - delta - phi)*tan(phi))))/zt + I4*(cos(gamma - delta)*tan(phi) - sin(gamma -
///     delta))/e)/zt - I4*cos(gamma - delta)^2*tan(phi)/e^2)/cos(phi))/e + m4*(sin(gamma - delta - phi)*(2*sin(phi)*tan(beta + theta - gamma)/ss + (sin(gamma - delta -
///     phi) + (tan(phi)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi)) - sin(gamma - delta))/cos(phi))/zt) + (sin(gamma - delta) + cos(gamma -
///     delta)*tan(beta + theta - gamma) - sin(phi)*cos(gamma - delta - phi))/ss)) - sin(gamma - delta - phi)*(((m5*((ta^2*(sin(gamma - delta - phi)*tan(gamma - beta -
///     theta) + cos(gamma - delta - phi)) + tb^2*(sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi)))/ss - sin(gamma - delta -
///     phi)^2*tan(phi)*(ta^2 + tb^2)/(zt*cos(phi))) + I5*((sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss - sin(gamma - delta -
///     phi)^2*tan(phi)/(zt*cos(phi))))/zt - m4*sin(gamma - delta - phi)*tan(phi)*(sin(gamma - delta)*(ea/e - 1) + sin(gamma - delta - phi)/cos(phi)))/zt +
///     m4*(sin(gamma - delta)*sin(phi)*(ea/e - 1) + sin(gamma - delta - phi)*tan(gamma - beta - theta) + cos(gamma - delta - phi))/ss))/cos(phi)^2 + (cos(gamma -
///     epsilon - omega)*(((m7*(cos(gamma - epsilon - omega)^2*tan(omega)*(ua^2 + ub^2)/(u*cos(omega)) + (ua^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon -
///     omega)*tan(beta + theta - gamma)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma)))/ss) + I7*(cos(gamma - epsilon
///     - omega)^2*tan(omega)/(u*cos(omega)) + (sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss))/u + m6*cos(gamma - epsilon -
///     omega)*tan(omega)*(cos(gamma - epsilon)*(fa/zf - 1) + cos(gamma - epsilon - omega)/cos(omega)))/u + m6*(cos(gamma - epsilon)*sin(omega)*(1 - fa/zf) + sin(gamma
///     - epsilon - omega) + cos(gamma - epsilon - omega)*tan(beta + theta - gamma))/ss) - sin(gamma - epsilon)*((I6*(sin(gamma - epsilon)*tan(gamma - beta - theta) +
///     cos(gamma - epsilon))/(ss*zf) + m6*(fa*((sin(gamma - epsilon)*(fa*tan(gamma - beta - theta)/ss + cos(gamma - epsilon - omega) + tan(omega)*(sin(gamma - epsilon
///     - omega) + (2*sin(omega)*cos(gamma - epsilon - omega) - 2*sin(gamma - epsilon) - fa*(cos(gamma - epsilon - omega)/u - sin(gamma - epsilon)/zf))/cos(omega))) +
///     fa*cos(gamma - epsilon)*(1/ss - cos(gamma - epsilon - omega)/(u*cos(omega))))/zf - cos(gamma - epsilon - omega)*(2*sin(omega)*tan(beta + theta - gamma)/ss +
///     (cos(gamma - epsilon - omega) - 2*(cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - sin(omega)*cos(gamma - epsilon - omega)))/cos(omega))/u) -
///     (2*sin(gamma - epsilon)*tan(gamma - beta - theta) + 2*cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss) - sin(gamma - epsilon)*cos(gamma -
///     epsilon - omega) + (sin(gamma - epsilon - omega)*cos(gamma - epsilon - omega) + sin(omega)*((cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma -
///     epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))/cos(omega) - sin(gamma - epsilon)*sin(gamma - epsilon - omega)))/cos(omega)) + (I6*sin(gamma -
///     epsilon)^2*tan(omega)/zf^2 + cos(gamma - epsilon - omega)*((I7*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega)) + m7*(ua^2*(sin(gamma -
///     epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega)) + ub^2*(sin(gamma - epsilon - omega) + cos(gamma - epsilon - omega)*tan(omega))))/u - I6*(cos(gamma
///     - epsilon) + sin(gamma - epsilon)*tan(omega))/zf)/u)/cos(omega))/zf + m6*(cos(gamma - epsilon - omega)*(2*sin(omega)*tan(beta + theta - gamma)/ss + (cos(gamma -
///     epsilon - omega) - (cos(gamma - epsilon) + tan(omega)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega)))/cos(omega))/u) + (sin(gamma -
///     epsilon)*tan(gamma - beta - theta) + cos(gamma - epsilon) + sin(omega)*sin(gamma - epsilon - omega))/ss)))/cos(omega)^2)) - cos(beta - gamma)*((I2*(sin(beta -
///     gamma) + cos(beta - gamma)*tan(gamma - beta - theta)) + m2*da^2*(sin(beta - gamma) + cos(beta - gamma)*tan(gamma - beta - theta)))/(d*ss) + cos(theta)*(((I3 +
///     m3*(sa^2 + sb^2))/ss + m2*da*sin(beta + theta - gamma))/ss + (I4*cos(gamma - delta)^2/e^2 + sin(gamma - delta - phi)^2*(I5 + m5*(ta^2 + tb^2))/zt^2 +
///     m4*(sin(gamma - delta - phi)^2 + cos(gamma - delta)*(cos(gamma - delta) + 2*sin(phi)*sin(gamma - delta - phi) + ea*(cos(gamma - delta)*(ea/e - 2) -
///     2*sin(phi)*sin(gamma - delta - phi))/e)))/cos(phi)^2 + (I6*sin(gamma - epsilon)^2/zf^2 + cos(gamma - epsilon - omega)^2*(I7 + m7*(ua^2 + ub^2))/u^2 +
///     m6*(cos(gamma - epsilon - omega)^2 + sin(gamma - epsilon)*(sin(gamma - epsilon) - 2*sin(omega)*cos(gamma - epsilon - omega) + fa*(sin(gamma - epsilon)*(fa/zf -
///     2) + 2*sin(omega)*cos(gamma - epsilon - omega))/zf)))/cos(omega)^2))/d)/cos(beta + theta - gamma)))/cos(beta + theta - gamma))))/cos(beta + theta - gamma))/d1
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
