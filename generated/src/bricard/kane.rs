//! Bricard's mechanism: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/bricard/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u_P1').
//! The kinematic equations are singular where l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) - cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) + sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) + cos(q_P3)*(sin(q_P5) - 1)))))) - l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) - cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) - cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) - cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + 2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) + cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) + cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) + cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) + cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)))) - l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) - cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) - cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))))) - l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) - cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) + cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) + l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) + cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) - cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))) = 0.
//! The accelerations divide by 1 pivots, which are positive where the mass matrix is.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, divisors, inverse_dynamics, jacobian_product,
    linear_system,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u_P1.
///
/// 566 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u_P1').
///
/// 1524 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u_P1'), solved for when this code was generated.
///
/// 1701 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
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
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// 508 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 49 operations, 4 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::potential_energy;
