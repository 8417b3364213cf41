//! Four-bar linkage: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1').
//! The kinematic equations are singular where sin(q2 - q3) = 0.
//! The accelerations divide by sin(q2 - q3), by b, by c, by a, by ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)).

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, divisors, inverse_dynamics,
    jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1.
///
/// ```text
/// M11 = a^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))/3
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1').
///
/// ```text
/// f1 = a*((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 -
///     q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) -
///     2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) -
///     2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/sin(q2 - q3) -
///     3*g*cos(q1)*(ma + 2*mb))/6
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1'), solved for when this code was generated.
///
/// ```text
/// u1' = ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 -
///     q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) -
///     2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) -
///     2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/sin(q2 - q3) -
///     3*g*cos(q1)*(ma + 2*mb))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u1
/// q2' = -a*u1*sin(q1 - q3)/(b*sin(q2 - q3))
/// q3' = -a*u1*sin(q1 - q2)/(c*sin(q2 - q3))
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = a^2*u1^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))/6
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = g*(a*sin(q1)*(ma + 2*mb) + b*mb*sin(q2) + c*mc*sin(q3))/2
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
