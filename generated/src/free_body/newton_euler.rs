//! Symmetric rigid body free of forces: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (v1', v2', v3', w1', w2', w3').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by I1.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{
    accelerations, coordinate_rates, forcing, kinetic_energy, potential_energy,
};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows body force b1, body force b2, body force b3, body moment b1, body moment b2, body moment b3. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*cos(psi)
/// M12 = m*sin(psi)
/// M21 = -m*sin(psi)*cos(theta)
/// M22 = m*cos(psi)*cos(theta)
/// M23 = m*sin(theta)
/// M31 = m*sin(psi)*sin(theta)
/// M32 = -m*cos(psi)*sin(theta)
/// M33 = m*cos(theta)
/// M44 = I1
/// M55 = I1
/// M66 = I3
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;
