//! Symmetric heavy top about a fixed point: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', hold1, hold2, hold3).
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by I1.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows top force b1, top force b2, top force b3, top moment b1, top moment b2, top moment b3. Entries that are not listed are 0.
///
/// ```text
/// M12 = m*l
/// M14 = -cos(q2)
/// M15 = -sin(q1)*sin(q2)
/// M16 = cos(q1)*sin(q2)
/// M21 = -m*l
/// M25 = -cos(q1)
/// M26 = -sin(q1)
/// M34 = -sin(q2)
/// M35 = sin(q1)*cos(q2)
/// M36 = -cos(q1)*cos(q2)
/// M41 = I1 - m*l^2
/// M45 = -l*cos(q1)
/// M46 = -l*sin(q1)
/// M52 = I1 - m*l^2
/// M54 = l*cos(q2)
/// M55 = l*sin(q1)*sin(q2)
/// M56 = -l*cos(q1)*sin(q2)
/// M63 = I3
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', hold1, hold2, hold3). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*sin(q2)*(g*cos(q1) - l*u1^2/cos(q2))
/// f2 = -m*(g*sin(q1) + l*u1*u2*tan(q2))
/// f3 = m*(l*(u1^2 + u2^2) - g*cos(q1)*cos(q2))
/// f4 = -u2*(u1*tan(q2)*(m*l^2 - I1) + I3*u3)
/// f5 = u1*(u1*tan(q2)*(m*l^2 - I1) + I3*u3)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u1', u2', u3'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u2' = (m*l*g*cos(q1)*sin(q2) + u1*(I3*u3 - I1*u1*tan(q2)))/I1
/// u1' = (m*l*g*sin(q1) - u2*(I3*u3 - I1*u1*tan(q2)))/I1
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
