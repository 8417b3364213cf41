//! N-window four-bar: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u').
//! The kinematic equations are singular where sin(q - q_ground1 + q_pin1) = 0 and where sin(q_ground1 - q_ground2 + q_pin2) = 0.
//! The accelerations divide by sin(q - q_ground1 + q_pin1), by sin(q_ground1 - q_ground2 + q_pin2), by sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)), by 4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, divisors, inverse_dynamics,
    jacobian_product, linear_system,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// ```text
/// M11 = 4*m*l^2/3 + 4*m*l^2*sin(q_pin1)^2/(3*sin(q - q_ground1 + q_pin1)^2) + m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
///     m*l^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))^2/(3*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))^2) + m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1
///     + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))^2/(3*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u').
///
/// ```text
/// f1 = m*l*g*cos(q + q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - 3*m*l*g*cos(q)/2 - 3*m*l*g*cos(q_ground1)*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1)) -
///     m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1
///     + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))/(2*sin(q - q_ground1 + q_pin1)) + m*l^2*u^2*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) +
///     cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - 5*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
///     q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) - sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) - m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) +
///     cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
///     l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(4*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
///     sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
///     q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
///     m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
///     q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
///     m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
///     q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 -
///     q_pin2)))/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + m*l*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))^2)/(4*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
///     (cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q -
///     q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))^2)/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
///     m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
///     (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)
///     - l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
///     + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(1
///     + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) + sin(q_pin1)*(1 +
///     (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))*(m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
///     (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)
///     - m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 -
///     m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
///     q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) +
///     m*l*(cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) -
///     l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
///     q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1))))/2 + m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) + cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
///     + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 +
///     q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)
///     - l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
///     + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(1
///     + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(2*sin(q - q_ground1 + q_pin1)) - m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 +
///     (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1))/2
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// u' = (6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q -
///     q_ground1 + q_pin1) + cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1
///     + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
///     (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)
///     - l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
///     + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(1
///     + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) - 18*m*l*g*cos(q) -
///     18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 6*m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
///     6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - 6*m*l*g*sin(q_pin1)*cos(q_ground1 +
///     q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))/sin(q - q_ground1 + q_pin1) - 6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
///     cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) - 15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
///     q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) - 3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q
///     + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
///     l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
///     sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
///     q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
///     m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
///     q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
///     m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
///     q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 -
///     q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - 3*m*l*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
///     (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q -
///     q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
///     3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 +
///     (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
///     l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q -
///     q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
///     (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
///     q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
///     sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)) - m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
///     q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
///     (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1 +
///     q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
///     q_pin1))/sin(q - q_ground1 + q_pin1) - 6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
///     - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) - cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
///     l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) +
///     cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) -
///     u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
///     cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) - 6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^3 +
///     l*sin(q_pin1)*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q
///     - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
///     + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 +
///     4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
///     cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
///     m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 +
///     (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q' = u
/// q_ground1' = u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
/// q_ground2' = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// q_pin1' = u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
/// q_pin2' = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u^2*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
///     m*l^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))^2 + m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 +
///     (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/6
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*l*g*(3*sin(q) + 3*sin(q_ground1) + sin(q_ground2) + sin(q + q_pin1) + sin(q_ground1 + q_pin2))/2
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
