//! Thin disk sliding on a frictionless plane: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5', N).
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by R, by 4*cos(q2)^2 - 5.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian, taylor};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows disk force b1, disk force b2, disk force b3, disk moment b1, disk moment b2, disk moment b3. Entries that are not listed are 0.
///
/// ```text
/// M12 = -M*R*tan(q2)
/// M14 = M*cos(q1)
/// M15 = M*sin(q1)
/// M24 = -M*sin(q1)*sin(q2)
/// M25 = M*cos(q1)*sin(q2)
/// M26 = -cos(q2)
/// M31 = M*R
/// M34 = M*sin(q1)*cos(q2)
/// M35 = -M*cos(q1)*cos(q2)
/// M36 = -sin(q2)
/// M41 = M*R^2/4
/// M46 = R*sin(q2)
/// M52 = M*R^2/4
/// M63 = M*R^2/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', N). Entries that are not listed are 0.
///
/// ```text
/// f1 = -M*R*u1*u2*(2 + tan(q2)^2)
/// f2 = M*(R*(u1^2 + u2^2*tan(q2)^2) - g*cos(q2))
/// f3 = -M*sin(q2)*(g + R*u2^2/cos(q2))
/// f4 = M*R^2*u2*(u2*tan(q2) - 2*u3)/4
/// f5 = M*R^2*u1*(2*u3 - u2*tan(q2))/4
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
