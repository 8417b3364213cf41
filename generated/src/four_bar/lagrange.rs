//! Four-bar linkage: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'', lambda_loop_x, lambda_loop_y).
//! The kinematic equations are singular where sin(q2 - q3) = 0.
//! The accelerations divide by sin(q2 - q3), by c, by b, by a, by ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)).

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q1, q2, q3, constraint loop_x, constraint loop_y. Entries that are not listed are 0.
///
/// ```text
/// M11 = a^2*(ma + 3*mb)/3
/// M12 = a*b*mb*cos(q1 - q2)/2
/// M14 = a*sin(q1)
/// M15 = -a*cos(q1)
/// M21 = a*b*mb*cos(q1 - q2)/2
/// M22 = b^2*mb/3
/// M24 = b*sin(q2)
/// M25 = -b*cos(q2)
/// M33 = c^2*mc/3
/// M34 = -c*sin(q3)
/// M35 = c*cos(q3)
/// M41 = -a*sin(q1)
/// M42 = -b*sin(q2)
/// M43 = c*sin(q3)
/// M51 = a*cos(q1)
/// M52 = b*cos(q2)
/// M53 = -c*cos(q3)
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', lambda_loop_x, lambda_loop_y).
///
/// ```text
/// f1 = -a*(g*cos(q1)*(ma + 2*mb) + b*mb*q2'^2*sin(q1 - q2))/2
/// f2 = b*mb*(a*q1'^2*sin(q1 - q2) - g*cos(q2))/2
/// f3 = -c*mc*g*cos(q3)/2
/// f4 = a*q1'^2*cos(q1) + b*q2'^2*cos(q2) - c*q3'^2*cos(q3)
/// f5 = a*q1'^2*sin(q1) + b*q2'^2*sin(q2) - c*q3'^2*sin(q3)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q1'', q2'', q3''), solved for when this code was generated.
///
/// ```text
/// u1' = -(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 -
///     q3))/sin(q2 - q3)^2 + a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 -
///     q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) + 3*a*(g*(ma*cos(q1) - mc*sin(q1 - q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) -
///     cos(q2)*sin(q1 - q3)/sin(q2 - q3)) + sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 -
///     sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
/// q1'' = u1'
/// q2'' = -a*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))/(b*sin(q2 - q3)) -
///     a*u1'*sin(q1 - q3)/(b*sin(q2 - q3))
/// q3'' = -a*q1'^2*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(c*sin(q2 - q3)) -
///     a*u1'*sin(q1 - q2)/(c*sin(q2 - q3))
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1'
/// q2'
/// q3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = a^2*q1'^2*(ma + 3*mb)/6 + b^2*mb*q2'^2/6 + a*b*mb*q1'*q2'*cos(q1 - q2)/2 + c^2*mc*q3'^2/6
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = q1'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = q1''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q1' = u1
/// q2' = -a*u1*sin(q1 - q3)/(b*sin(q2 - q3))
/// q3' = -a*u1*sin(q1 - q2)/(c*sin(q2 - q3))
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
