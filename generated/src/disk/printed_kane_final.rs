//! Thin disk sliding on a frictionless plane: Kane's method as printed (kane-final), M(q) u' = f(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5').
//! The kinematic equations are singular where cos(q2) = 0.

pub use super::code::printed_kane_final::{PrintedKaneFinal, divisors};

pub use super::kane::potential_energy;

/// Matrix of the linear system M(q) u' = f(q, u); rows row 1, row 2, row 3, row 4, row 5. Entries that are not listed are 0.
///
/// ```text
/// M11 = 5*R
/// M14 = 4*sin(q1)*cos(q2)
/// M15 = -4*cos(q1)*cos(q2)
/// M22 = R*(1 + 4*tan(q2)^2)
/// M24 = -4*cos(q1)*tan(q2)
/// M25 = -4*sin(q1)*tan(q2)
/// M33 = 1
/// M41 = R*sin(q1)*cos(q2)
/// M42 = -R*cos(q1)*tan(q2)
/// M44 = 1
/// M51 = R*cos(q1)*cos(q2)
/// M52 = R*sin(q1)*tan(q2)
/// M55 = -1
/// ```
#[doc(inline)]
pub use super::code::printed_kane_final::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5'). Entries that are not listed are 0.
///
/// ```text
/// f1 = -4*g*sin(q2) - R*u2^2*tan(q2) - 3*R*u2*u3
/// f2 = 2*R*u1*u2*tan(q2)*(3 + 2*tan(q2)^2) + 3*R*u1*u3
/// f4 = -R*u1^2*sin(q1)*sin(q2) - R*u2^2*sin(q1)*sin(q2)*(1 + tan(q2)^2) - R*u1*u2*cos(q1)*(2 + tan(q2)^2)
/// f5 = R*u1*u2*sin(q1)*(2 + tan(q2)^2) - R*u1^2*cos(q1)*sin(q2) - R*u2^2*cos(q1)*sin(q2)*(1 + tan(q2)^2)
/// ```
#[doc(inline)]
pub use super::code::printed_kane_final::forcing;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u2/cos(q2)
/// q2' = -u1
/// q3' = u3 - u2*tan(q2)
/// q4' = u4
/// q5' = u5
/// ```
#[doc(inline)]
pub use super::code::printed_kane_final::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = 5*M*R^2*u1^2/8 + M*R^2*u2^2*(1 + 4*tan(q2)^2)/8 + M*R^2*u3^2/4 + M*u4^2/2 + M*R*u1*u4*sin(q1)*cos(q2) - M*R*u2*u4*cos(q1)*tan(q2) + M*u5^2/2 -
///     M*R*u1*u5*cos(q1)*cos(q2) - M*R*u2*u5*sin(q1)*tan(q2)
/// ```
#[doc(inline)]
pub use super::code::printed_kane_final::kinetic_energy;
