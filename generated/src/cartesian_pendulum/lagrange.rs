//! Pendulum in Cartesian coordinates: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/cartesian_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'', y'', lambda_rod).
//! The kinematic equations are singular where x^2 + y^2 = 0.
//! The accelerations divide by l, by ratio_x_v^2 + ratio_y_v^2.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
    taylor,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, constraint rod. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M13 = -2*x
/// M22 = m
/// M23 = -2*y
/// M31 = 2*x
/// M32 = 2*y
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'', y'', lambda_rod). Entries that are not listed are 0.
///
/// ```text
/// f2 = -m*g
/// f3 = -2*x'^2 - 2*y'^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x'', y''), solved for when this code was generated.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// ratio_x_v_2 = ratio_y_v*(x*y' - y*x')/(x^2 + y^2) + 2*l*y*(x*ratio_x_v*(x*y' - y*x')/l + y*ratio_y_v*(y*x' - x*y')/l)/(x^2 + y^2)^2
/// ratio_y_v_2 = ratio_x_v*(x*y' - y*x')/(x^2 + y^2) - 2*l*x*(x*ratio_x_v*(x*y' - y*x')/l + y*ratio_y_v*(y*x' - x*y')/l)/(x^2 + y^2)^2
/// v' = (ratio_x_v*ratio_x_v_2*(y*x' - x*y') + ratio_y_v*(ratio_y_v_2*(x*y' - y*x') - l*g))/(l*(ratio_x_v^2 + ratio_y_v^2))
/// x'' = ratio_x_v_2*(y*x' - x*y')/l - v'*ratio_x_v
/// y'' = v'*ratio_y_v + ratio_y_v_2*(y*x' - x*y')/l
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// y'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*x'^2/2 + m*y'^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// v = (x*y' - y*x')/l
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// v' = (x*y'' - y*x'')/l
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// x' = -v*ratio_x_v
/// y' = v*ratio_y_v
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
