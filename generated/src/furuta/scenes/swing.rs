//! Furuta pendulum: The pendulum falls from upright.
//!
//! Generated from `models/furuta/scenes/swing.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: theta1, theta2, u_theta1, u_theta2.
//! States: theta1, theta2, u_theta2. Quadratures: none.
//! p_theta1_total = b1*theta1 + u_theta1*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2)) + L1*l2*m2*u_theta2*cos(theta2): momentum p_theta1 + b1*theta1, where p_theta1 = ∂L/∂theta1'.
//! l2_squared = l2^2.
//! l1_squared_m1 = l1^2*m1.
//! L1_l2_m2 = L1*l2*m2.
//! l2_squared_m2 = l2^2*m2.
//! l2_m2 = l2*m2.
//! L1_squared_m2 = L1^2*m2.
//! Parameters that the scene fixes: tau = 0.
//! Singular nowhere.

pub use super::code::swing::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// L1
/// l1
/// m1
/// J1
/// l2
/// m2
/// J2
/// b1
/// b2
/// g
/// p_theta1_total = b1*theta1 + u_theta1*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2)) + L1*l2*m2*u_theta2*cos(theta2)
/// l2_squared = l2^2
/// l1_squared_m1 = l1^2*m1
/// L1_l2_m2 = L1*l2*m2
/// l2_squared_m2 = l2^2*m2
/// l2_m2 = l2*m2
/// L1_squared_m2 = L1^2*m2
/// ```
#[doc(inline)]
pub use super::code::swing::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta1
/// theta2
/// u_theta2
/// ```
#[doc(inline)]
pub use super::code::swing::start;

/// The accelerations (u_theta2'), solved for when this code was generated.
///
/// ```text
/// u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
/// u_theta2' = (sin(theta2)*(J2*u_theta1^2*cos(theta2) + l2_m2*(l2*u_theta1^2*cos(theta2) - g)) - b2*u_theta2 -
///     L1_l2_m2*cos(theta2)*(u_theta2^2*L1_l2_m2*sin(theta2) - u_theta1*(b1 + 2*u_theta2*sin(theta2)*cos(theta2)*(J2 + l2_squared_m2)))/(J1 + J2*sin(theta2)^2 +
///     m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1))/(J2 + l2_squared_m2*(1 - L1_squared_m2*cos(theta2)^2/(J1 + J2*sin(theta2)^2 + m2*(L1^2 +
///     l2_squared*sin(theta2)^2) + l1_squared_m1)))
/// ```
#[doc(inline)]
pub use super::code::swing::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
/// theta2' = u_theta2
/// ```
#[doc(inline)]
pub use super::code::swing::coordinate_rates;

/// Kinetic energy T.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::swing::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::swing::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u_theta1 = (p_theta1_total - b1*theta1 - u_theta2*L1_l2_m2*cos(theta2))/(J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2_squared*sin(theta2)^2) + l1_squared_m1)
/// theta1
/// theta2
/// u_theta2
/// ```
#[doc(inline)]
pub use super::code::swing::outputs;
