//! Chaotic pendulum: a swinging rod with a plate turning about it: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (omega', alpha').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2, by IBzz.

pub use super::code::kane::{Kane, derivative, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows omega, alpha. Entries that are not listed are 0.
///
/// ```text
/// M11 = mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2
/// M22 = IBzz
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (omega', alpha').
///
/// ```text
/// f1 = 2*omega*alpha*sin(phi)*cos(phi)*(IByy - IBxx) - g*sin(theta)*(mA*lA + mB*lB)
/// f2 = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// ```text
/// omega' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
/// alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta' = omega
/// phi' = alpha
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = omega^2*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)/2 + IBzz*alpha^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = -g*cos(theta)*(mA*lA + mB*lB)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
