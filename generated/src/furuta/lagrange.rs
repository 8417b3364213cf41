//! Furuta pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (theta1'', theta2'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l2^2*m2 + J2, by l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))).

pub use super::code::lagrange::{
    Lagrange, derivative, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta1, theta2.
///
/// ```text
/// M11 = l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2)
/// M12 = L1*l2*m2*cos(theta2)
/// M22 = l2^2*m2 + J2
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (theta1'', theta2'').
///
/// ```text
/// f1 = tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 + 2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2))
/// f2 = sin(theta2)*(J2*theta1'^2*cos(theta2) - l2*m2*(g - l2*theta1'^2*cos(theta2))) - b2*theta2'
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (theta1'', theta2''), solved for when this code was generated.
///
/// ```text
/// theta1'' = (tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 + 2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) + L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g
///     - l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 -
///     l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
/// theta2'' = (J2*theta1'^2*sin(theta2)*cos(theta2) - b2*theta2' - l2*m2*(sin(theta2)*(g - l2*theta1'^2*cos(theta2)) + L1*theta1''*cos(theta2)))/(l2^2*m2 + J2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta1'
/// theta2'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = theta1'^2*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2))/2 + theta2'^2*(l2^2*m2 + J2)/2 + L1*l2*m2*theta1'*theta2'*cos(theta2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The power of the loads that have no potential: the rate of T + V.
///
/// ```text
/// d(T + V)/dt = -b1*theta1'^2 - b2*theta2'^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::power;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u_theta1 = theta1'
/// u_theta2 = theta2'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u_theta1' = theta1''
/// u_theta2' = theta2''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// theta1' = u_theta1
/// theta2' = u_theta2
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
