//! PUMA 560: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5', u6').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 6 pivots, which are positive where the mass matrix is.

pub use super::code::kane::{Kane, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5, u6. Entries that are not listed are 0.
///
/// 256 operations, 4 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', u6').
///
/// 422 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2', u3', u4', u5', u6'), solved for when this code was generated.
///
/// 802 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u1
/// q2' = u2
/// q3' = u3
/// q4' = u4
/// q5' = u5
/// q6' = u6
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// 180 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 76 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::potential_energy;

/// The power of the loads that have no potential: the rate of T + V.
///
/// ```text
/// d(T + V)/dt = u1*tau1 + u2*tau2 + u3*tau3 + u4*tau4 + u5*tau5 + u6*tau6
/// ```
#[doc(inline)]
pub use super::code::kane::power;
