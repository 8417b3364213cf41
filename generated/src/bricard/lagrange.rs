//! Bricard's mechanism: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/bricard/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q_P1'', q_P2'', q_P3'', q_P4'', q_P5'', lambda_P6_1, lambda_P6_2, lambda_P6_3, lambda_P6_turn13).
//! The kinematic equations are singular where l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) + cos(q_P3)*(sin(q_P5) - 1)))))) - l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)))) - l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) - cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) - l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) - cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) + cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) = 0.
//! The accelerations divide by 1 pivots, which are positive where the mass matrix is.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, divisors, jacobian_product,
};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q_P1, q_P2, q_P3, q_P4, q_P5, constraint P6_1, constraint P6_2, constraint P6_3, constraint P6_turn13. Entries that are not listed are 0.
///
/// 519 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q_P1'', q_P2'', q_P3'', q_P4'', q_P5'', lambda_P6_1, lambda_P6_2, lambda_P6_3, lambda_P6_turn13).
///
/// 772 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q_P1'', q_P2'', q_P3'', q_P4'', q_P5''), solved for when this code was generated.
///
/// 2252 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q_P1'
/// q_P2'
/// q_P3'
/// q_P4'
/// q_P5'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// 119 operations, 4 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 49 operations, 4 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::potential_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u_P1 = q_P1'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u_P1' = q_P1''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// ratio_q_P2_u_P1 = l^3*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2
///     + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) -
///     2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 +
///     2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 +
///     cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
///     sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 +
///     2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) -
///     cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) -
///     2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
///     cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 -
///     2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 -
///     2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) -
///     1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5))
///     + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) +
///     cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^3*cos(q_P5)*(sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)) - cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) +
///     cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) - cos(q_P2)*cos(q_P4))))*(sin(q_P5) - 1 + sin(q_P4)*(sin(q_P5) - 1))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 -
///     sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) -
///     1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 +
///     sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) - sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
///     cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) + sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5))) - l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) -
///     l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l*cos(q_P2)*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) - sin(q_P1)*(cos(q_P2)*sin(q_P4) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
///     sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2
///     + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))))
/// ratio_q_P3_u_P1 = l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
///     cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5)
///     - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
///     sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) +
///     cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) -
///     2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 +
///     2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 +
///     cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
///     sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 +
///     2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) -
///     cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) -
///     2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
///     cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 -
///     2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 -
///     2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) -
///     1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5))
///     + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) +
///     cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) - sin(q_P1)*(cos(q_P2)*sin(q_P4) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))) + l*(sin(q_P2)*sin(q_P4)*(1 -
///     sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
///     sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
///     cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
///     sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
///     cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))^2) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
///     cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) - cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
///     sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1)))) + l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 -
///     sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) -
///     1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 +
///     sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^3*cos(q_P4)*(cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) - cos(q_P2)*cos(q_P4))) -
///     sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)))*(sin(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P5)) + cos(q_P5)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) -
///     2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 +
///     2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 +
///     cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
///     sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 +
///     2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) -
///     cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) -
///     2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
///     cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 -
///     2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 -
///     2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) -
///     1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5))
///     + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) +
///     cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))))
/// ratio_q_P4_u_P1 = l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5))))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2
///     + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) + sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)))) + l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))^2) +
///     l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) - l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
///     sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2
///     + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^3*cos(q_P5)*(cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) - cos(q_P2)*cos(q_P4))) -
///     sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)))*(sin(q_P3) - sin(q_P5) + cos(q_P3)*cos(q_P5) + sin(q_P4)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P4)*(sin(q_P5) - 1) + sin(q_P3)*(2 - sin(q_P5) - sin(q_P4)*(sin(q_P5) - 1))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2
///     + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))))
/// ratio_q_P5_u_P1 = l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5)
///     - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) -
///     2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 +
///     2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 +
///     cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
///     sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 +
///     2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) -
///     cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) -
///     2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
///     cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 -
///     2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 -
///     2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) -
///     1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5))
///     + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
///     sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) +
///     cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))*(l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P2)*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
///     sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + l*(sin(q_P2)*sin(q_P4)*(1 -
///     sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
///     sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)))) + l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1)
///     - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
///     sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1)))) + l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))) +
///     l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P1)*(cos(q_P3)*sin(q_P5)
///     + sin(q_P3)*sin(q_P4)*cos(q_P5)) + sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5))) -
///     l*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 -
///     2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^3*cos(q_P4)*(cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) - cos(q_P2)*cos(q_P4))) -
///     sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)))*(sin(q_P3) - 1 + cos(q_P3)*cos(q_P5) + sin(q_P5)*(1 - sin(q_P3) - cos(q_P3)*cos(q_P5)) +
///     sin(q_P4)*(2*sin(q_P5) - 2 + cos(q_P5)^2 + sin(q_P3)*(2 - 2*sin(q_P5) - cos(q_P5)^2)))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
///     cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2
///     + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 +
///     cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
///     cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
///     sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 +
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
///     sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
///     cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 -
///     2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
///     + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
///     cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 -
///     sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) -
///     sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) -
///     cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) +
///     l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1
///     - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
///     sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
///     l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
///     l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
///     sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
///     sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) +
///     cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
///     cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
///     sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1
///     + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
///     1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
///     sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) -
///     sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
///     sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
///     cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
///     1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) +
///     sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
///     cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
///     cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) +
///     cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
///     cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
///     cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
///     1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
///     sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
///     sin(q_P3)*sin(q_P4)*cos(q_P5)))))
/// q_P1' = u_P1
/// q_P2' = u_P1*ratio_q_P2_u_P1
/// q_P3' = u_P1*ratio_q_P3_u_P1
/// q_P4' = -u_P1*ratio_q_P4_u_P1
/// q_P5' = -u_P1*ratio_q_P5_u_P1
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
