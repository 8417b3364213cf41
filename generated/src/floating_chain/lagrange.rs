//! Chain of three rods floating in a plane: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'', y'', theta1'', theta2'', theta3'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) + cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) - 9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))), by 3*cos(theta1)^2*cos(theta2)^2 - 7 + 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)).

pub use super::code::lagrange::{
    Lagrange, derivative, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y, theta1, theta2, theta3. Entries that are not listed are 0.
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
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'', y'', theta1'', theta2'', theta3'').
///
/// ```text
/// f1 = m*l*(2*theta1'^2*cos(theta1) + 3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3))/2
/// f2 = m*l*(2*theta1'^2*sin(theta1) + 3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3))/2
/// f3 = -m*l^2*(3*theta2'^2*sin(theta1 - theta2) + theta3'^2*sin(theta1 - theta3))/4
/// f4 = m*l^2*(3*theta1'^2*sin(theta1 - theta2) - 2*theta3'^2*sin(theta2 - theta3))/4
/// f5 = m*l^2*(theta1'^2*sin(theta1 - theta3) + 2*theta2'^2*sin(theta2 - theta3))/4
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x'', y'', theta1'', theta2'', theta3''), solved for when this code was generated.
///
/// ```text
/// theta3'' = (theta3'^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) - 3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) -
///     theta2'^2*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))) + cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) +
///     cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) + 3*theta2'^2*(6*sin(theta2) +
///     cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) + 2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
///     cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
///     cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) - 9*cos(theta2)*(sin(theta2)*sin(theta3) +
///     cos(theta2)*cos(theta3)))))
/// theta2'' = (sin(theta1)*(3*theta1'^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + theta3''*sin(theta3)) +
///     cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + theta3''*sin(theta3)) - sin(theta2)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3)
///     - theta3''*cos(theta3)))) + cos(theta2)*(3*theta3'^2*sin(theta3) - 3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3) - 3*theta2'^2*sin(theta2) -
///     theta3'^2*sin(theta3))) - 3*sin(theta2)*(theta1'^2*cos(theta1) + theta3'^2*cos(theta3) + theta3''*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2 -
///     3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
/// theta1'' = cos(theta1)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - 3*theta2''*cos(theta2) - theta3''*cos(theta3))/3 -
///     sin(theta1)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + 3*theta2''*sin(theta2) + theta3''*sin(theta3))/3
/// y'' = l*(2*theta1'^2*sin(theta1) + 3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - 2*theta1''*cos(theta1) - 3*theta2''*cos(theta2) - theta3''*cos(theta3))/6
/// x'' = l*(2*theta1'^2*cos(theta1) + 3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + 2*theta1''*sin(theta1) + 3*theta2''*sin(theta2) + theta3''*sin(theta3))/6
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// y'
/// theta1'
/// theta2'
/// theta3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = 3*m*x'^2/2 + 3*m*y'^2/2 + 7*m*l^2*theta1'^2/24 - m*l*x'*theta1'*sin(theta1) + m*l*y'*theta1'*cos(theta1) + 2*m*l^2*theta2'^2/3 -
///     3*m*l*x'*theta2'*sin(theta2)/2 + 3*m*l*y'*theta2'*cos(theta2)/2 + 3*m*l^2*theta1'*theta2'*cos(theta1 - theta2)/4 + m*l^2*theta3'^2/6 -
///     m*l*x'*theta3'*sin(theta3)/2 + m*l*y'*theta3'*cos(theta3)/2 + m*l^2*theta1'*theta3'*cos(theta1 - theta3)/4 + m*l^2*theta2'*theta3'*cos(theta2 - theta3)/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = x'
/// u2 = y'
/// u3 = theta1'
/// u4 = theta2'
/// u5 = theta3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = x''
/// u2' = y''
/// u3' = theta1''
/// u4' = theta2''
/// u5' = theta3''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// x' = u1
/// y' = u2
/// theta1' = u3
/// theta2' = u4
/// theta3' = u5
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
