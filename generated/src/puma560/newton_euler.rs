//! PUMA 560: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5', u6', flange_force_l51, flange_force_l52, flange_force_l53, flange_torque_l51, flange_torque_l52, wrist2_force_l41, wrist2_force_l42, wrist2_force_l43, wrist2_torque_l41, wrist2_torque_l42, wrist1_force_l31, wrist1_force_l32, wrist1_force_l33, wrist1_torque_l31, wrist1_torque_l32, forearm_force_l21, forearm_force_l22, forearm_force_l23, forearm_torque_l21, forearm_torque_l22, upper_arm_force_j11, upper_arm_force_j12, upper_arm_force_j13, upper_arm_torque_j11, upper_arm_torque_j13, column_force_n1, column_force_n2, column_force_n3, column_torque_n1, column_torque_n2).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 6 pivots, which are positive where the mass matrix is.

pub use super::code::newton_euler::{NewtonEuler, jacobian_product};

pub use super::kane::{coordinate_rates, power};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows column force j11, column force j12, column force j13, column moment j11, column moment j12, column moment j13, upper_arm force l21, upper_arm force l22, upper_arm force l23, upper_arm moment l21, upper_arm moment l22, upper_arm moment l23, forearm force l31, forearm force l32, forearm force l33, forearm moment l31, forearm moment l32, forearm moment l33, wrist1 force l41, wrist1 force l42, wrist1 force l43, wrist1 moment l41, wrist1 moment l42, wrist1 moment l43, wrist2 force l51, wrist2 force l52, wrist2 force l53, wrist2 moment l51, wrist2 moment l52, wrist2 moment l53, flange force l61, flange force l62, flange force l63, flange moment l61, flange moment l62, flange moment l63. Entries that are not listed are 0.
///
/// 307 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', u6', flange_force_l51, flange_force_l52, flange_force_l53, flange_torque_l51, flange_torque_l52, wrist2_force_l41, wrist2_force_l42, wrist2_force_l43, wrist2_torque_l41, wrist2_torque_l42, wrist1_force_l31, wrist1_force_l32, wrist1_force_l33, wrist1_torque_l31, wrist1_torque_l32, forearm_force_l21, forearm_force_l22, forearm_force_l23, forearm_torque_l21, forearm_torque_l22, upper_arm_force_j11, upper_arm_force_j12, upper_arm_force_j13, upper_arm_torque_j11, upper_arm_torque_j13, column_force_n1, column_force_n2, column_force_n3, column_torque_n1, column_torque_n2). Entries that are not listed are 0.
///
/// 331 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u1', u2', u3', u4', u5', u6'), solved for when this code was generated.
///
/// 1050 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::accelerations;

/// Kinetic energy T.
///
/// 180 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 76 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::potential_energy;
