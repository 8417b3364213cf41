//! Pendulum on a driven pivot: Too slow, and it falls.
//!
//! Generated from `models/driven_pendulum/scenes/falling.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q, t, u.
//! States: q, t, u. Quadratures: none.
//! a_w_squared = a*w^2.
//! Parameters that the scene fixes: l = 0.5.
//! Singular nowhere.

pub use super::code::falling::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// m
/// g
/// a
/// w
/// a_w_squared = a*w^2
/// ```
#[doc(inline)]
pub use super::code::falling::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// q
/// t
/// u
/// ```
#[doc(inline)]
pub use super::code::falling::start;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// u' = 2*sin(q)*(a_w_squared*sin(w*t) - g)
/// ```
#[doc(inline)]
pub use super::code::falling::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q' = u
/// t' = 1
/// ```
#[doc(inline)]
pub use super::code::falling::coordinate_rates;

/// Kinetic energy T.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::falling::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::falling::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// q
/// t
/// u
/// ```
#[doc(inline)]
pub use super::code::falling::outputs;
