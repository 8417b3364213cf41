//! Symmetric rigid body free of forces: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (v1', v2', v3', w1', w2', w3').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by I1.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v1, v2, v3, w1, w2, w3. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M22 = m
/// M33 = m
/// M44 = I1
/// M55 = I1
/// M66 = I3
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (v1', v2', v3', w1', w2', w3'). Entries that are not listed are 0.
///
/// ```text
/// f4 = w2*(I1*w2/tan(theta) - I3*w3)
/// f5 = w1*(I3*w3 - I1*w2/tan(theta))
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (v1', v2', v3', w1', w2', w3'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// w2' = w1*(I3*w3/I1 - w2/tan(theta))
/// w1' = w2*(w2/tan(theta) - I3*w3/I1)
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = v1
/// y' = v2
/// z' = v3
/// psi' = w2/sin(theta)
/// theta' = w1
/// phi' = w3 - w2/tan(theta)
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*v1^2/2 + m*v2^2/2 + m*v3^2/2 + I1*w1^2/2 + I1*w2^2/2 + I3*w3^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::kane::potential_energy;
