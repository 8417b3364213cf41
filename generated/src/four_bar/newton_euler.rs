//! Four-bar linkage: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', pin_ox, pin_oy, pin_px, pin_py, pin_qx, pin_qy, pin_dx, pin_dy).
//! The kinematic equations are singular where sin(q2 - q3) = 0.
//! The accelerations divide by sin(q2 - q3), by b, by c, by a, by ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)).

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows crank force a1, crank force a2, crank moment a3, coupler force b1, coupler force b2, coupler moment b3, rocker force c1, rocker force c2, rocker moment c3. Entries that are not listed are 0.
///
/// ```text
/// M12 = -cos(q1)
/// M13 = -sin(q1)
/// M14 = cos(q1)
/// M15 = sin(q1)
/// M21 = a*ma/2
/// M22 = sin(q1)
/// M23 = -cos(q1)
/// M24 = -sin(q1)
/// M25 = cos(q1)
/// M31 = a^2*ma/12
/// M32 = -a*sin(q1)/2
/// M33 = a*cos(q1)/2
/// M34 = -a*sin(q1)/2
/// M35 = a*cos(q1)/2
/// M41 = -a*mb*sin(q1 - q2)
/// M44 = -cos(q2)
/// M45 = -sin(q2)
/// M46 = -cos(q2)
/// M47 = -sin(q2)
/// M51 = a*mb*(2*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/2
/// M54 = sin(q2)
/// M55 = -cos(q2)
/// M56 = sin(q2)
/// M57 = -cos(q2)
/// M61 = -a*b*mb*sin(q1 - q3)/(12*sin(q2 - q3))
/// M64 = -b*sin(q2)/2
/// M65 = b*cos(q2)/2
/// M66 = b*sin(q2)/2
/// M67 = -b*cos(q2)/2
/// M76 = cos(q3)
/// M77 = sin(q3)
/// M78 = -cos(q3)
/// M79 = -sin(q3)
/// M81 = -a*mc*sin(q1 - q2)/(2*sin(q2 - q3))
/// M86 = -sin(q3)
/// M87 = cos(q3)
/// M88 = sin(q3)
/// M89 = -cos(q3)
/// M91 = -a*c*mc*sin(q1 - q2)/(12*sin(q2 - q3))
/// M96 = -c*sin(q3)/2
/// M97 = c*cos(q3)/2
/// M98 = -c*sin(q3)/2
/// M99 = c*cos(q3)/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', pin_ox, pin_oy, pin_px, pin_py, pin_qx, pin_qy, pin_dx, pin_dy). Entries that are not listed are 0.
///
/// ```text
/// f1 = a*ma*u1^2/2 - ma*g*sin(q1)
/// f2 = -ma*g*cos(q1)
/// f4 = mb*(a*u1^2*(2*cos(q1 - q2) + a*sin(q1 - q3)^2/(b*sin(q2 - q3)^2)) - 2*g*sin(q2))/2
/// f5 = mb*(a*u1^2*(2*sin(q1 - q2) + (cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 -
///     q3))/sin(q2 - q3)) - 2*g*cos(q2))/2
/// f6 = a*mb*u1^2*(b*cos(q1 - q3) + a*(sin(q1 - q3)^2/tan(q2 - q3) + b*sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))/(12*sin(q2 - q3))
/// f7 = a^2*mc*u1^2*sin(q1 - q2)^2/(2*c*sin(q2 - q3)^2) - mc*g*sin(q3)
/// f8 = mc*(a*u1^2*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3) -
///     2*g*cos(q3))/2
/// f9 = a*mc*u1^2*(c*cos(q1 - q2) + a*(sin(q1 - q2)^2/tan(q3 - q2) + c*sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(12*sin(q2 - q3))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u1'), solved for when this code was generated.
///
/// ```text
/// u1' = ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 -
///     q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) -
///     2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) -
///     2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/sin(q2 - q3) -
///     3*g*(ma*cos(q1) + 2*mb*(cos(q2)*cos(q1 - q2) - sin(q2)*sin(q1 - q2))))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) -
///     sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
