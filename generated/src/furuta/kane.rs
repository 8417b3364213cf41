//! Furuta pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u_theta1', u_theta2').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l2^2*m2 + J2, by l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))).

pub use super::code::kane::{Kane, derivative, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u_theta1, u_theta2.
///
/// ```text
/// M11 = l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2)
/// M12 = L1*l2*m2*cos(theta2)
/// M22 = l2^2*m2 + J2
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u_theta1', u_theta2').
///
/// ```text
/// f1 = tau + L1*l2*m2*u_theta2^2*sin(theta2) - u_theta1*(b1 + 2*u_theta2*sin(theta2)*cos(theta2)*(l2^2*m2 + J2))
/// f2 = sin(theta2)*(J2*u_theta1^2*cos(theta2) - l2*m2*(g - l2*u_theta1^2*cos(theta2))) - b2*u_theta2
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u_theta1', u_theta2'), solved for when this code was generated.
///
/// ```text
/// u_theta1' = (tau + L1*l2*m2*u_theta2^2*sin(theta2) - u_theta1*(b1 + 2*u_theta2*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) +
///     L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g - l2*u_theta1^2*cos(theta2)) - J2*u_theta1^2*cos(theta2)) + b2*u_theta2)/(l2^2*m2 + J2))/(l1^2*m1 + J1 +
///     J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
/// u_theta2' = (J2*u_theta1^2*sin(theta2)*cos(theta2) - b2*u_theta2 - l2*m2*(sin(theta2)*(g - l2*u_theta1^2*cos(theta2)) + L1*u_theta1'*cos(theta2)))/(l2^2*m2 +
///     J2)
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta1' = u_theta1
/// theta2' = u_theta2
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u_theta1^2*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2))/2 + u_theta2^2*(l2^2*m2 + J2)/2 + L1*l2*m2*u_theta1*u_theta2*cos(theta2)
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = -tau*theta1 - l2*m2*g*cos(theta2)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;

/// The power of the loads that have no potential: the rate of T + V.
///
/// ```text
/// d(T + V)/dt = -b1*u_theta1^2 - b2*u_theta2^2
/// ```
#[doc(inline)]
pub use super::code::kane::power;
