//! Thin disk sliding on a frictionless plane: Kane's method as printed (listing-5.4), M(q) u' = f(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5').
//! The kinematic equations are singular where cos(q2) = 0.

pub use super::code::printed_listing_5_4::{PrintedListing54, divisors};

pub use super::printed_kane_final::{coordinate_rates, kinetic_energy, mass_matrix};

pub use super::kane::potential_energy;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5'). Entries that are not listed are 0.
///
/// ```text
/// f1 = -4*g*sin(q2) - R*u2^2*tan(q2) - 3*R*u2*u3
/// f2 = 2*R*u1*u2*tan(q2)*(3 + 2*tan(q2)^2) + 3*R*u1*u3
/// f4 = -R*u1^2*sin(q1)*sin(q2) - R*u2^2*sin(q1)*sin(q2)*(1 + tan(q2)^2) - R*u1*u2*cos(q1)*(2 + tan(q2)^2)
/// f5 = R*u1*u2*sin(q1)*(2 + tan(q2)^2) - R*u1^2*cos(q1)*sin(q2) - 2*R*u2*cos(q1)*sin(q2)*(1 + tan(q2)^2)
/// ```
#[doc(inline)]
pub use super::code::printed_listing_5_4::forcing;
