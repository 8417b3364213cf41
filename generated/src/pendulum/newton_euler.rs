//! Pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (omega', rod, plane).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l.

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product, taylor};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2, bob force n3. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*l*cos(theta)
/// M12 = sin(theta)
/// M21 = m*l*sin(theta)
/// M22 = -cos(theta)
/// M33 = -1
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (omega', rod, plane). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*l*omega^2*sin(theta)
/// f2 = -m*(g + l*omega^2*cos(theta))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
