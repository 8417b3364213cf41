//! Knife edge on an incline: A blade that turns does not run down.
//!
//! Generated from `models/knife_edge/scenes/cycloid.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, y, phi, u, w.
//! States: none. Quadratures: phi, u, y, x.
//! w: generalized speed, constant with the momentum p_phi = ∂L/∂phi'.
//! Parameters that the scene fixes: m = 1, J = 0.5.
//! Singular nowhere.

pub use super::code::cycloid::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, energy_gradient,
    jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// alpha
/// g
/// w
/// ```
#[doc(inline)]
pub use super::code::cycloid::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// phi
/// y
/// x
/// u
/// ```
#[doc(inline)]
pub use super::code::cycloid::start;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// u' = g*sin(alpha)*cos(phi)
/// ```
#[doc(inline)]
pub use super::code::cycloid::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// phi' = w
/// y' = u*sin(phi)
/// x' = u*cos(phi)
/// ```
#[doc(inline)]
pub use super::code::cycloid::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u^2/2
/// ```
#[doc(inline)]
pub use super::code::cycloid::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = w^2/4 - g*x*sin(alpha)
/// ```
#[doc(inline)]
pub use super::code::cycloid::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// x
/// y
/// phi
/// u
/// w
/// ```
#[doc(inline)]
pub use super::code::cycloid::outputs;
