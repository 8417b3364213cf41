//! Chain of three rods floating in a plane: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) + cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) - 9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))), by 3*cos(theta1)^2*cos(theta2)^2 - 7 + 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)).

pub use super::code::kane::{Kane, derivative, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5. Entries that are not listed are 0.
///
/// ```text
/// M11 = 3*m
/// M13 = -m*l*sin(theta1)
/// M14 = -3*m*l*sin(theta2)/2
/// M15 = -m*l*sin(theta3)/2
/// M22 = 3*m
/// M23 = m*l*cos(theta1)
/// M24 = 3*m*l*cos(theta2)/2
/// M25 = m*l*cos(theta3)/2
/// M33 = 7*m*l^2/12
/// M34 = 3*m*l^2*cos(theta1 - theta2)/4
/// M35 = m*l^2*cos(theta1 - theta3)/4
/// M44 = 4*m*l^2/3
/// M45 = m*l^2*cos(theta2 - theta3)/2
/// M55 = m*l^2/3
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5').
///
/// ```text
/// f1 = m*l*(2*u3^2*cos(theta1) + 3*u4^2*cos(theta2) + u5^2*cos(theta3))/2
/// f2 = m*l*(2*u3^2*sin(theta1) + 3*u4^2*sin(theta2) + u5^2*sin(theta3))/2
/// f3 = -m*l^2*(3*u4^2*sin(theta1 - theta2) + u5^2*sin(theta1 - theta3))/4
/// f4 = m*l^2*(3*u3^2*sin(theta1 - theta2) - 2*u5^2*sin(theta2 - theta3))/4
/// f5 = m*l^2*(u3^2*sin(theta1 - theta3) + 2*u4^2*sin(theta2 - theta3))/4
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2', u3', u4', u5'), solved for when this code was generated.
///
/// ```text
/// u5' = (u5^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) - 3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) +
///     cos(theta1)*cos(theta2))) + cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) + cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) -
///     sin(theta1)*(3*cos(theta2)^2 - 2)) + 3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) + 2*u5^2*(sin(theta3)*(4 +
///     cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 -
///     cos(theta3)^2) + cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) - 9*cos(theta2)*(sin(theta2)*sin(theta3) +
///     cos(theta2)*cos(theta3)))))
/// u4' = (sin(theta1)*(3*u3^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) +
///     cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) - sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - u5'*cos(theta3)))) +
///     cos(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) + cos(theta1)^2*(u5'*cos(theta3) - 3*u4^2*sin(theta2) - u5^2*sin(theta3))) - 3*sin(theta2)*(u3^2*cos(theta1)
///     + u5^2*cos(theta3) + u5'*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2 - 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
/// u3' = cos(theta1)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - 3*u4'*cos(theta2) - u5'*cos(theta3))/3 - sin(theta1)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) +
///     3*u4'*sin(theta2) + u5'*sin(theta3))/3
/// u2' = l*(2*u3^2*sin(theta1) + 3*u4^2*sin(theta2) + u5^2*sin(theta3) - 2*u3'*cos(theta1) - 3*u4'*cos(theta2) - u5'*cos(theta3))/6
/// u1' = l*(2*u3^2*cos(theta1) + 3*u4^2*cos(theta2) + u5^2*cos(theta3) + 2*u3'*sin(theta1) + 3*u4'*sin(theta2) + u5'*sin(theta3))/6
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = u1
/// y' = u2
/// theta1' = u3
/// theta2' = u4
/// theta3' = u5
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = 3*m*u1^2/2 + 3*m*u2^2/2 + 7*m*l^2*u3^2/24 - m*l*u1*u3*sin(theta1) + m*l*u2*u3*cos(theta1) + 2*m*l^2*u4^2/3 - 3*m*l*u1*u4*sin(theta2)/2 +
///     3*m*l*u2*u4*cos(theta2)/2 + 3*m*l^2*u3*u4*cos(theta1 - theta2)/4 + m*l^2*u5^2/6 - m*l*u1*u5*sin(theta3)/2 + m*l*u2*u5*cos(theta3)/2 + m*l^2*u3*u5*cos(theta1 -
///     theta3)/4 + m*l^2*u4*u5*cos(theta2 - theta3)/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::kane::potential_energy;
