//! Symmetric heavy top in Euler's angles: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', hold1, hold2, hold3).
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by I1.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows top force b1, top force b2, top force b3, top moment b1, top moment b2, top moment b3. Entries that are not listed are 0.
///
/// ```text
/// M12 = m*l
/// M14 = -cos(psi)
/// M15 = -sin(psi)
/// M21 = -m*l
/// M24 = sin(psi)*cos(theta)
/// M25 = -cos(psi)*cos(theta)
/// M26 = -sin(theta)
/// M34 = -sin(psi)*sin(theta)
/// M35 = cos(psi)*sin(theta)
/// M36 = -cos(theta)
/// M41 = I1 - m*l^2
/// M44 = l*sin(psi)*cos(theta)
/// M45 = -l*cos(psi)*cos(theta)
/// M46 = -l*sin(theta)
/// M52 = I1 - m*l^2
/// M54 = l*cos(psi)
/// M55 = l*sin(psi)
/// M63 = I3
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', hold1, hold2, hold3). Entries that are not listed are 0.
///
/// ```text
/// f1 = -m*l*u1*u2/tan(theta)
/// f2 = -m*(g*sin(theta) + l*u2^2/tan(theta))
/// f3 = m*(l*(u1^2 + u2^2) - g*cos(theta))
/// f4 = -u2*(u2*(m*l^2 - I1)/tan(theta) + I3*u3)
/// f5 = u1*(u2*(m*l^2 - I1)/tan(theta) + I3*u3)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u1', u2', u3'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u2' = u1*(I3*u3/I1 - u2/tan(theta))
/// u1' = (m*l*g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
