//! Whipple bicycle: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/whipple_bicycle/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', rear_wheel_force_y1, rear_wheel_force_y2, front_wheel_force_y1, front_wheel_force_y2, front_wheel_force_f1, front_wheel_force_f2, front_wheel_force_f3, front_wheel_torque_f1, front_wheel_torque_f3, fork_force_b1, fork_force_b2, fork_force_b3, fork_torque_b2, fork_torque_f1, frame_force_rw1, frame_force_rw2, frame_force_rw3, frame_torque_rw1, frame_torque_rw3, rear_wheel_force_n3, front_wheel_force_n3).
//! The kinematic equations are singular where cos(phi)*cos(lam + theta)*(rR*sin(lam) - cos(lam)*(w + c)) + cos(phi)*cos(lam + theta)*cos(delta)*(c*cos(lam) - rF*sin(lam) - rF*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*cos(delta) - sin(phi)*sin(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)) - cos(phi)*sin(lam + theta)*(w*sin(lam) + cos(lam)*(rR - rF) + rF*cos(phi)*cos(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)) + (sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(rF*cos(phi)*cos(lam + theta)*cos(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)*cos(lam + theta)*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(sin(phi)*sin(delta) - cos(phi)*sin(lam + theta)*cos(delta))*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) + cos(phi)*cos(lam + theta)*(rF*cos(phi)*sin(lam + theta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1) + rF*cos(phi)^2*cos(lam + theta)^2*sin(delta)*sqrt(1 - (cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2)*(cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))/((cos(phi)*sin(lam + theta)*sin(delta) + sin(phi)*cos(delta))^2 - 1)^2) = 0 and where sqrt(1 - sin(phi)^2*cos(delta)^2 - cos(phi)*sin(lam + theta)*sin(delta)*(cos(phi)*sin(lam + theta)*sin(delta) + 2*sin(phi)*cos(delta))) = 0 and where sin(phi)*sin(delta)*(rF*cos(lam) - w*sin(lam) - rR*(cos(lam) - cos(lam + theta))) + cos(phi)*(cos(lam + theta)*(rF*sin(lam) - c*cos(lam)) + cos(delta)*(sin(lam)*(w*sin(lam + theta) - rR*cos(lam + theta)) + cos(lam)*(sin(lam + theta)*(rR - rF) + cos(lam + theta)*(w + c)))) = 0.
//! The accelerations divide by 3 pivots, which are positive where the mass matrix is.

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, divisors, jacobian_product,
    linear_system,
};

pub use super::kane::coordinate_rates;

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rear_wheel force l1, rear_wheel force l2, rear_wheel force l3, rear_wheel moment l1, rear_wheel moment l2, rear_wheel moment l3, frame force b1, frame force b2, frame force b3, frame moment b1, frame moment b2, frame moment b3, fork force h1, fork force h2, fork force h3, fork moment h1, fork moment h2, fork moment h3, front_wheel force f1, front_wheel force f2, front_wheel force f3, front_wheel moment f1, front_wheel moment f2, front_wheel moment f3. Entries that are not listed are 0.
///
/// 869 operations, 7 sines and cosines, 2 other functions, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', rear_wheel_force_y1, rear_wheel_force_y2, front_wheel_force_y1, front_wheel_force_y2, front_wheel_force_f1, front_wheel_force_f2, front_wheel_force_f3, front_wheel_torque_f1, front_wheel_torque_f3, fork_force_b1, fork_force_b2, fork_force_b3, fork_torque_b2, fork_torque_f1, frame_force_rw1, frame_force_rw2, frame_force_rw3, frame_torque_rw1, frame_torque_rw3, rear_wheel_force_n3, front_wheel_force_n3).
///
/// 1009 operations, 8 sines and cosines, 2 other functions, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 1811 operations, 8 sines and cosines, 2 other functions, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::accelerations;

/// Kinetic energy T.
///
/// 409 operations, 6 sines and cosines, 2 other functions, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 89 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::potential_energy;
