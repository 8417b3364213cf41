//! N-window four-bar: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', close1_force1, close1_force2, close2_force1, close2_force2, coupler2_force_crank1_frame1, coupler2_force_crank1_frame2, coupler1_force_crank0_frame1, coupler1_force_crank0_frame2, crank2_force_n1, crank2_force_n2, crank1_force_n1, crank1_force_n2, crank0_force_n1, crank0_force_n2).
//! The kinematic equations are singular where sin(q - q_ground1 + q_pin1) = 0 and where sin(q_ground1 - q_ground2 + q_pin2) = 0.
//! The accelerations divide by sin(q - q_ground1 + q_pin1), by sin(q_ground1 - q_ground2 + q_pin2), by sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)), by d1.

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, derivative, divisors, jacobian_product,
    linear_system,
};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows crank0 force crank0_frame1, crank0 force crank0_frame2, crank0 moment crank0_frame3, crank1 force crank1_frame1, crank1 force crank1_frame2, crank1 moment crank1_frame3, crank2 force crank2_frame1, crank2 force crank2_frame2, crank2 moment crank2_frame3, coupler1 force coupler1_frame1, coupler1 force coupler1_frame2, coupler1 moment coupler1_frame3, coupler2 force coupler2_frame1, coupler2 force coupler2_frame2, coupler2 moment coupler2_frame3. Entries that are not listed are 0.
///
/// ```text
/// M_1_8 = 1
/// M_1_14 = -cos(q)
/// M_1_15 = -sin(q)
/// M_2_1 = m*l/2
/// M_2_9 = 1
/// M_2_14 = sin(q)
/// M_2_15 = -cos(q)
/// M_3_1 = m*l^2/12
/// M_3_9 = l/2
/// M_3_14 = -l*sin(q)/2
/// M_3_15 = l*cos(q)/2
/// M_4_2 = -cos(q_ground1)
/// M_4_3 = -sin(q_ground1)
/// M_4_6 = 1
/// M_4_12 = -cos(q_ground1)
/// M_4_13 = -sin(q_ground1)
/// M_5_1 = m*l*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1))
/// M_5_2 = sin(q_ground1)
/// M_5_3 = -cos(q_ground1)
/// M_5_7 = 1
/// M_5_12 = sin(q_ground1)
/// M_5_13 = -cos(q_ground1)
/// M_6_1 = m*l^2*sin(q_pin1)/(12*sin(q - q_ground1 + q_pin1))
/// M_6_2 = l*sin(q_ground1)/2
/// M_6_3 = -l*cos(q_ground1)/2
/// M_6_7 = l/2
/// M_6_12 = -l*sin(q_ground1)/2
/// M_6_13 = l*cos(q_ground1)/2
/// M_7_4 = -cos(q_ground2)
/// M_7_5 = -sin(q_ground2)
/// M_7_10 = -cos(q_ground2)
/// M_7_11 = -sin(q_ground2)
/// M_8_1 = m*l*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// M_8_4 = sin(q_ground2)
/// M_8_5 = -cos(q_ground2)
/// M_8_10 = sin(q_ground2)
/// M_8_11 = -cos(q_ground2)
/// M_9_1 = m*l^2*sin(q_pin1)*sin(q_pin2)/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
/// M_9_4 = l*sin(q_ground2)/2
/// M_9_5 = -l*cos(q_ground2)/2
/// M_9_10 = -l*sin(q_ground2)/2
/// M_9_11 = l*cos(q_ground2)/2
/// M_10_1 = m*l*sin(q_pin1)
/// M_10_2 = cos(q + q_pin1)
/// M_10_3 = sin(q + q_pin1)
/// M_10_8 = -cos(q_pin1)
/// M_10_9 = -sin(q_pin1)
/// M_11_1 = m*l*(2*cos(q_pin1) + (cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/2
/// M_11_2 = -sin(q + q_pin1)
/// M_11_3 = cos(q + q_pin1)
/// M_11_8 = sin(q_pin1)
/// M_11_9 = -cos(q_pin1)
/// M_12_1 = m*l^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))
/// M_12_2 = -l*sin(q + q_pin1)/2
/// M_12_3 = l*cos(q + q_pin1)/2
/// M_12_8 = -l*sin(q_pin1)/2
/// M_12_9 = l*cos(q_pin1)/2
/// M_13_1 = m*l*sin(q_pin1)*sin(q_pin2)/sin(q - q_ground1 + q_pin1)
/// M_13_4 = cos(q_ground1 + q_pin2)
/// M_13_5 = sin(q_ground1 + q_pin2)
/// M_13_6 = -cos(q_pin2)
/// M_13_7 = -sin(q_pin2)
/// M_14_1 = m*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(2*sin(q - q_ground1 + q_pin1))
/// M_14_4 = -sin(q_ground1 + q_pin2)
/// M_14_5 = cos(q_ground1 + q_pin2)
/// M_14_6 = sin(q_pin2)
/// M_14_7 = -cos(q_pin2)
/// M_15_1 = m*l^2*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(12*sin(q - q_ground1 + q_pin1))
/// M_15_4 = -l*sin(q_ground1 + q_pin2)/2
/// M_15_5 = l*cos(q_ground1 + q_pin2)/2
/// M_15_6 = -l*sin(q_pin2)/2
/// M_15_7 = l*cos(q_pin2)/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u', close1_force1, close1_force2, close2_force1, close2_force2, coupler2_force_crank1_frame1, coupler2_force_crank1_frame2, coupler1_force_crank0_frame1, coupler1_force_crank0_frame2, crank2_force_n1, crank2_force_n2, crank1_force_n1, crank1_force_n2, crank0_force_n1, crank0_force_n2). Entries that are not listed are 0.
///
/// ```text
/// f_1 = m*l*u^2/2 - m*g*sin(q)
/// f_2 = -m*g*cos(q)
/// f_4 = m*l*u^2*sin(q_pin1)^2/(2*sin(q - q_ground1 + q_pin1)^2) - m*g*sin(q_ground1)
/// f_5 = -m*(2*g*cos(q_ground1) + l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q -
///     q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) -
///     1))/sin(q - q_ground1 + q_pin1)^2)/2
/// f_6 = -m*l^2*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
///     q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/(12*sin(q -
///     q_ground1 + q_pin1)^2)
/// f_7 = m*l*u^2*sin(q_pin1)^2*sin(q_pin2)^2/(2*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*g*sin(q_ground2)
/// f_8 = -m*(2*g*cos(q_ground2) + l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
///     sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
///     q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1)))))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/2
/// f_9 = -m*l^2*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
///     sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
///     q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1)))))/(12*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
/// f_10 = m*l*u^2*cos(q_pin1) - m*g*sin(q + q_pin1) + m*l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))
/// f_11 = m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/2 - m*g*cos(q + q_pin1)
///     - m*l*u^2*sin(q_pin1)
/// f_12 = m*l^2*u^2*(sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) + cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) -
///     sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1)))))) - sin(q_pin1)^2 - cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2 + 2*cos(q_pin1)
///     + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
///     4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) -
///     sin(q_ground1)*(1 + 2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) -
///     3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
///     sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) + sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) -
///     2*sin(q)*sin(q_pin1))))))/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3)
/// f_13 = m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*g*sin(q_ground1 + q_pin2) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(2*sin(q - q_ground1 + q_pin1)) - m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
///     q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)))
/// f_14 = m*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
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
///     q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/2 - m*g*cos(q_ground1 + q_pin2) - m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q -
///     q_ground1 + q_pin1)^2 - m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
///     sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
/// f_15 = m*l^2*u^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(12*sin(q - q_ground1 + q_pin1)^2) +
///     m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
///     q_pin1)))/sin(q - q_ground1 + q_pin1))/(12*sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
///     u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 -
///     q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
///     q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) +
///     sin(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) +
///     cos(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
///     q_pin2))/(12*sin(q - q_ground1 + q_pin1))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// d1 = m*l^2*(4 + (cos(q)*sin(q_ground1)*(3*cos(q_pin1) + cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - sin(q)*cos(q_ground1)*(3*cos(q_pin1) + (2*cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
///     sin(q_pin1)^2*(5 + 3*cos(q_pin2) + (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) + 2*cos(q_ground1 + q_pin2) +
///     3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
///     sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 + q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
///     sin(q_ground2)*cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2) -
///     cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 +
///     q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/3
/// u' = -(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
///     sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1
///     + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2 -
///     5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
///     4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) -
///     sin(q_ground1)*(1 + 2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) -
///     3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
///     sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) + sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
///     sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) + cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) -
///     sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 + m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
///     q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) +
///     ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2
///     + q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
///     sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 + q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1)
///     + l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
///     q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
///     q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) + 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) + l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q)
///     + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
///     q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 +
///     q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q -
///     q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) + m*l*u*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
///     q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
///     l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
///     cos(q)*sin(q_ground1))))*(2*m*g*cos(q + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q -
///     q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
///     cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
///     sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
///     u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
///     q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) - u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
///     u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
///     q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) +
///     2*m*l*u^2*sin(q_pin1)) + 6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) - 2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
///     m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 -
///     q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
///     2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
///     l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q
///     - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) +
///     (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
///     q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 + q_pin1)^2 +
///     2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
///     l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q
///     - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
///     cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
///     q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
///     cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
///     u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
///     q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
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
///     q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
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
///     q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
