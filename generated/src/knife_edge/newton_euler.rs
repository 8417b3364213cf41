//! Knife edge on an incline: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', w', side, normal).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by nothing.

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows blade force b1, blade force b2, blade force b3, blade moment b3. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M23 = -1
/// M34 = -1
/// M42 = J
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u', w', side, normal). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*g*sin(alpha)*cos(phi)
/// f2 = -m*(g*sin(alpha)*sin(phi) + u*w)
/// f3 = -m*g*cos(alpha)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
