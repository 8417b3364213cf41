//! Furuta pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u_theta1', u_theta2', pendulum_force_a1, pendulum_force_a2, pendulum_force_a3, pendulum_torque_a2, pendulum_torque_a3, arm_force_n1, arm_force_n2, arm_force_n3, arm_torque_n1, arm_torque_n2).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l2^2*m2 + J2, by l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))).

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{
    accelerations, coordinate_rates, kinetic_energy, potential_energy, power,
};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows arm force a1, arm force a2, arm force a3, arm moment a1, arm moment a2, arm moment a3, pendulum force p1, pendulum force p2, pendulum force p3, pendulum moment p1, pendulum moment p2, pendulum moment p3. Entries that are not listed are 0.
///
/// ```text
/// M_1_3 = 1
/// M_1_8 = -cos(theta1)
/// M_1_9 = -sin(theta1)
/// M_2_1 = l1*m1
/// M_2_4 = 1
/// M_2_8 = sin(theta1)
/// M_2_9 = -cos(theta1)
/// M_3_5 = 1
/// M_3_10 = -1
/// M_4_11 = -cos(theta1)
/// M_4_12 = -sin(theta1)
/// M_5_5 = l1
/// M_5_6 = 1
/// M_5_10 = -l1
/// M_5_11 = sin(theta1)
/// M_5_12 = -cos(theta1)
/// M_6_1 = J1
/// M_6_4 = -l1
/// M_6_7 = 1
/// M_6_8 = -l1*sin(theta1)
/// M_6_9 = l1*cos(theta1)
/// M_7_1 = -l2*m2*sin(theta2)
/// M_7_3 = -1
/// M_8_1 = L1*m2*cos(theta2)
/// M_8_2 = l2*m2
/// M_8_4 = -cos(theta2)
/// M_8_5 = -sin(theta2)
/// M_9_1 = -L1*m2*sin(theta2)
/// M_9_4 = sin(theta2)
/// M_9_5 = -cos(theta2)
/// M_10_2 = J2
/// M_10_4 = l2*cos(theta2)
/// M_10_5 = l2*sin(theta2)
/// M_11_1 = J2*sin(theta2)
/// M_11_3 = -l2
/// M_11_4 = L1*sin(theta2)
/// M_11_5 = -L1*cos(theta2)
/// M_11_6 = -cos(theta2)
/// M_11_7 = -sin(theta2)
/// M_12_4 = L1*cos(theta2)
/// M_12_5 = L1*sin(theta2)
/// M_12_6 = sin(theta2)
/// M_12_7 = -cos(theta2)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u_theta1', u_theta2', pendulum_force_a1, pendulum_force_a2, pendulum_force_a3, pendulum_torque_a2, pendulum_torque_a3, arm_force_n1, arm_force_n2, arm_force_n3, arm_torque_n1, arm_torque_n2). Entries that are not listed are 0.
///
/// ```text
/// f_1 = l1*m1*u_theta1^2
/// f_3 = -m1*g
/// f_4 = b2*u_theta2
/// f_6 = tau - b1*u_theta1
/// f_7 = m2*u_theta1*(L1*u_theta1 + 2*l2*u_theta2*cos(theta2))
/// f_8 = m2*sin(theta2)*(l2*u_theta1^2*cos(theta2) - g)
/// f_9 = -m2*(g*cos(theta2) + l2*(u_theta1^2*sin(theta2)^2 + u_theta2^2))
/// f_10 = J2*u_theta1^2*sin(theta2)*cos(theta2) - b2*u_theta2
/// f_11 = -2*J2*u_theta1*u_theta2*cos(theta2)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
