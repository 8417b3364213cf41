//! Pendulum in Cartesian coordinates: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cartesian_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (v').
//! The kinematic equations are singular where x^2 + y^2 = 0.
//! The accelerations divide by ratio_x_v^2 + ratio_y_v^2.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, divisors, inverse_dynamics,
    jacobian_product, taylor,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// M11 = m*(ratio_x_v^2 + ratio_y_v^2)
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (v').
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// ratio_x_v_2 = l*v*ratio_y_v/(x^2 + y^2) + 2*l*y*(x*v*ratio_x_v - y*v*ratio_y_v)/(x^2 + y^2)^2
/// ratio_y_v_2 = l*v*ratio_x_v/(x^2 + y^2) + 2*l*x*(y*v*ratio_y_v - x*v*ratio_x_v)/(x^2 + y^2)^2
/// f1 = -m*(g*ratio_y_v + v*(ratio_x_v*ratio_x_v_2 - ratio_y_v*ratio_y_v_2))
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (v'), solved for when this code was generated.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// ratio_x_v_2 = l*v*ratio_y_v/(x^2 + y^2) + 2*l*y*(x*v*ratio_x_v - y*v*ratio_y_v)/(x^2 + y^2)^2
/// ratio_y_v_2 = l*v*ratio_x_v/(x^2 + y^2) + 2*l*x*(y*v*ratio_y_v - x*v*ratio_x_v)/(x^2 + y^2)^2
/// v' = -(g*ratio_y_v + v*(ratio_x_v*ratio_x_v_2 - ratio_y_v*ratio_y_v_2))/(ratio_x_v^2 + ratio_y_v^2)
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// x' = -v*ratio_x_v
/// y' = v*ratio_y_v
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// T = m*v^2*(ratio_x_v^2 + ratio_y_v^2)/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*g*y
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
