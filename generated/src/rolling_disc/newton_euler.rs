//! Thin disc rolling on a plane: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', friction_x, friction_y, normal).
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by r.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{accelerations, coordinate_rates, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows disc force l1, disc force l2, disc force l3, disc moment l1, disc moment l2, disc moment l3. Entries that are not listed are 0.
///
/// ```text
/// M12 = r*m
/// M14 = -cos(q1)
/// M15 = -sin(q1)
/// M21 = -r*m
/// M24 = sin(q1)*cos(q2)
/// M25 = -cos(q1)*cos(q2)
/// M26 = -sin(q2)
/// M34 = -sin(q1)*sin(q2)
/// M35 = cos(q1)*sin(q2)
/// M36 = -cos(q2)
/// M41 = r^2*m/4
/// M44 = r*sin(q1)*cos(q2)
/// M45 = -r*cos(q1)*cos(q2)
/// M46 = -r*sin(q2)
/// M52 = r^2*m/2
/// M54 = r*cos(q1)
/// M55 = r*sin(q1)
/// M63 = r^2*m/4
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', friction_x, friction_y, normal). Entries that are not listed are 0.
///
/// ```text
/// f1 = -r*m*u1*u3
/// f2 = -m*(g*sin(q2) + r*u2*u3)
/// f3 = m*(r*(u1^2 + u2*u3*tan(q2)) - g*cos(q2))
/// f4 = r^2*m*u3*(2*u2 - u3*tan(q2))/4
/// f6 = r^2*m*u1*(u3*tan(q2) - 2*u2)/4
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// Kinetic energy T.
///
/// ```text
/// T = 5*r^2*m*u1^2/8 + 3*r^2*m*u2^2/4 + r^2*m*u3^2/8
/// ```
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;
