//! Thin disk sliding on a frictionless plane: Newton–Euler equations as printed (listing-5.6), M(q) u' = f(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5').
//! The kinematic equations are singular where cos(q2) = 0.

pub use super::code::printed_listing_5_6::{PrintedListing56, divisors};

pub use super::printed_kane_final::{coordinate_rates, kinetic_energy};

pub use super::kane::potential_energy;

/// Matrix of the linear system M(q) u' = f(q, u); rows row 1, row 2, row 3, row 4, row 5. Entries that are not listed are 0.
///
/// ```text
/// M11 = 1
/// M22 = 1
/// M33 = 1
/// M44 = 1
/// M55 = 1
/// ```
#[doc(inline)]
pub use super::code::printed_listing_5_6::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5'). Entries that are not listed are 0.
///
/// ```text
/// f1 = (4*R*u1^2*sin(q2)*cos(q2) - 4*g*sin(q2)^3 - 4*g*sin(q2)*cos(q2)^2 + 2*R*u2^2*sin(q2)*cos(q2) + 2*R*u2^2*sin(q2)^2*tan(q2) - 3*R*u2*u3*sin(q2)^2 -
///     3*R*u2*u3*cos(q2)^2)/(R*(5*sin(q2)^2 + cos(q2)^2))
/// f2 = 3*u1*u3 - 2*u1*u2*tan(q2)
/// f4 = (4*g*sin(q1)*sin(q2)*cos(q2) - 5*R*u1^2*sin(q1)*sin(q2) - 3*R*u2^2*sin(q1)*sin(q2) - 5*R*u2^2*sin(q1)*sin(q2)*tan(q2)^2 - 13*R*u1*u2*cos(q1)*sin(q2)^2 -
///     2*R*u1*u2*cos(q1)*cos(q2)^2 - 15*R*u1*u2*cos(q1)*sin(q2)^2*tan(q2)^2 + 3*R*u1*u3*cos(q1)*sin(q2)*cos(q2) + 15*R*u1*u3*cos(q1)*sin(q2)^2*tan(q2) +
///     3*R*u2*u3*sin(q1)*cos(q2))/(5*sin(q2)^2 + cos(q2)^2)
/// f5 = (5*R*u1^2*cos(q1)*sin(q2) - 4*g*cos(q1)*sin(q2)*cos(q2) + 3*R*u2^2*cos(q1)*sin(q2) + 5*R*u2^2*cos(q1)*sin(q2)*tan(q2)^2 - 13*R*u1*u2*sin(q1)*sin(q2)^2 -
///     2*R*u1*u2*sin(q1)*cos(q2)^2 - 15*R*u1*u2*sin(q1)*sin(q2)^2*tan(q2)^2 + 3*R*u1*u3*sin(q1)*sin(q2)*cos(q2) + 15*R*u1*u3*sin(q1)*sin(q2)^2*tan(q2) -
///     3*R*u2*u3*cos(q1)*cos(q2))/(5*sin(q2)^2 + cos(q2)^2)
/// ```
#[doc(inline)]
pub use super::code::printed_listing_5_6::forcing;
