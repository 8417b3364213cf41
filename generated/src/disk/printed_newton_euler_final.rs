//! Thin disk sliding on a frictionless plane: Newton–Euler equations as printed (newton-euler-final), A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5', N).
//! The kinematic equations are singular where cos(q2) = 0.

pub use super::code::printed_newton_euler_final::{PrintedNewtonEulerFinal, divisors};

pub use super::printed_kane_final::{coordinate_rates, kinetic_energy};

pub use super::kane::potential_energy;

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows row 1, row 2, row 3, row 4, row 5, row 6. Entries that are not listed are 0.
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
/// M41 = M*R^2
/// M46 = 4*R*sin(q2)
/// M52 = 1
/// M63 = 1
/// ```
#[doc(inline)]
pub use super::code::printed_newton_euler_final::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', N). Entries that are not listed are 0.
///
/// ```text
/// f1 = -M*R*u1*u2*(2 + tan(q2)^2)
/// f2 = M*R*u1^2 - M*g*cos(q2) + M*R*u2^2*tan(q2)^2
/// f3 = -M*g*sin(q2) - M*R*u2^2*tan(q2)
/// f4 = M*R^2*u2^2*tan(q2) - 2*M*R^2*u2*u3 + M*R^2*u2*(u2*tan(q2) - u3)
/// f5 = 3*u1*u3 - 2*u1*u2*tan(q2)
/// ```
#[doc(inline)]
pub use super::code::printed_newton_euler_final::forcing;
