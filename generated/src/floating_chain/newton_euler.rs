//! Chain of three rods floating in a plane: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5', pin1_x, pin1_y, pin2_x, pin2_y).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) + cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) - 9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))), by 3*cos(theta1)^2*cos(theta2)^2 - 7 + 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)).

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rod1 force a1, rod1 force a2, rod1 moment a3, rod2 force b1, rod2 force b2, rod2 moment b3, rod3 force c1, rod3 force c2, rod3 moment c3. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*cos(theta1)
/// M12 = m*sin(theta1)
/// M16 = cos(theta1)
/// M17 = sin(theta1)
/// M21 = -m*sin(theta1)
/// M22 = m*cos(theta1)
/// M26 = -sin(theta1)
/// M27 = cos(theta1)
/// M33 = m*l^2/12
/// M36 = -l*sin(theta1)/2
/// M37 = l*cos(theta1)/2
/// M41 = m*cos(theta2)
/// M42 = m*sin(theta2)
/// M43 = -m*l*sin(theta1 - theta2)/2
/// M46 = -cos(theta2)
/// M47 = -sin(theta2)
/// M48 = cos(theta2)
/// M49 = sin(theta2)
/// M51 = -m*sin(theta2)
/// M52 = m*cos(theta2)
/// M53 = m*l*cos(theta1 - theta2)/2
/// M54 = m*l/2
/// M56 = sin(theta2)
/// M57 = -cos(theta2)
/// M58 = -sin(theta2)
/// M59 = cos(theta2)
/// M64 = m*l^2/12
/// M66 = -l*sin(theta2)/2
/// M67 = l*cos(theta2)/2
/// M68 = -l*sin(theta2)/2
/// M69 = l*cos(theta2)/2
/// M71 = m*cos(theta3)
/// M72 = m*sin(theta3)
/// M73 = -m*l*sin(theta1 - theta3)/2
/// M74 = -m*l*sin(theta2 - theta3)
/// M78 = -cos(theta3)
/// M79 = -sin(theta3)
/// M81 = -m*sin(theta3)
/// M82 = m*cos(theta3)
/// M83 = m*l*cos(theta1 - theta3)/2
/// M84 = m*l*cos(theta2 - theta3)
/// M85 = m*l/2
/// M88 = sin(theta3)
/// M89 = -cos(theta3)
/// M95 = m*l^2/12
/// M98 = -l*sin(theta3)/2
/// M99 = l*cos(theta3)/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', pin1_x, pin1_y, pin2_x, pin2_y). Entries that are not listed are 0.
///
/// ```text
/// f4 = m*l*(u3^2*cos(theta1 - theta2) + u4^2)/2
/// f5 = m*l*u3^2*sin(theta1 - theta2)/2
/// f7 = m*l*(u3^2*cos(theta1 - theta3) + 2*u4^2*cos(theta2 - theta3) + u5^2)/2
/// f8 = m*l*(u3^2*sin(theta1 - theta3) + 2*u4^2*sin(theta2 - theta3))/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
