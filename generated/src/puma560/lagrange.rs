//! PUMA 560: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'', q4'', q5'', q6'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 6 pivots, which are positive where the mass matrix is.

pub use super::code::lagrange::{Lagrange, inverse_dynamics, jacobian_product};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3, q4, q5, q6. Entries that are not listed are 0.
///
/// 620 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'', q6'').
///
/// 676 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q1'', q2'', q3'', q4'', q5'', q6''), solved for when this code was generated.
///
/// 1547 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1'
/// q2'
/// q3'
/// q4'
/// q5'
/// q6'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// 180 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 76 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::potential_energy;

/// The power of the loads that have no potential: the rate of T + V.
///
/// ```text
/// d(T + V)/dt = q1'*tau1 + q2'*tau2 + q3'*tau3 + q4'*tau4 + q5'*tau5 + q6'*tau6
/// ```
#[doc(inline)]
pub use super::code::lagrange::power;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = q1'
/// u2 = q2'
/// u3 = q3'
/// u4 = q4'
/// u5 = q5'
/// u6 = q6'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = q1''
/// u2' = q2''
/// u3' = q3''
/// u4' = q4''
/// u5' = q5''
/// u6' = q6''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
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
pub use super::code::lagrange::motion_variables;
