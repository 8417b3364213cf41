//! Chaotic pendulum: a swinging rod with a plate turning about it: Swing with a turning plate.
//!
//! Generated from `models/chaotic_pendulum/scenes/swing.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: theta, phi, omega, alpha.
//! States: theta, phi, omega, alpha. Quadratures: none.
//! lB_times_3 = 3*lB.
//! mA_lA_times_2 = 2*mA*lA.
//! g_by_2 = g/2.
//! mA_lA_squared = mA*lA^2.
//! lB_squared_times_3_by_2 = 3*lB^2/2.
//! Parameters that the scene fixes: mB = 1.5.
//! Singular nowhere.

pub use super::code::swing::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, energy_gradient,
    jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// mA
/// lA
/// lB
/// IAxx
/// IBxx
/// IByy
/// IBzz
/// g
/// lB_times_3 = 3*lB
/// mA_lA_times_2 = 2*mA*lA
/// g_by_2 = g/2
/// mA_lA_squared = mA*lA^2
/// lB_squared_times_3_by_2 = 3*lB^2/2
/// ```
#[doc(inline)]
pub use super::code::swing::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta
/// phi
/// omega
/// alpha
/// ```
#[doc(inline)]
pub use super::code::swing::start;

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// ```text
/// omega' = -(2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) + g_by_2*sin(theta)*(lB_times_3 + mA_lA_times_2))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 +
///     mA_lA_squared + lB_squared_times_3_by_2)
/// alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
/// ```
#[doc(inline)]
pub use super::code::swing::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta' = omega
/// phi' = alpha
/// ```
#[doc(inline)]
pub use super::code::swing::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = omega^2*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/4 + IBzz*alpha^2/2
/// ```
#[doc(inline)]
pub use super::code::swing::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = -g*cos(theta)*(2*mA*lA + 3*lB)/2
/// ```
#[doc(inline)]
pub use super::code::swing::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// theta
/// phi
/// omega
/// alpha
/// ```
#[doc(inline)]
pub use super::code::swing::outputs;
