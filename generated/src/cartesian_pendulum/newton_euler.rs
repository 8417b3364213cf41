//! Pendulum in Cartesian coordinates: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cartesian_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (v', bob_force_to_o).
//! The kinematic equations are singular where x^2 + y^2 = 0.
//! The accelerations divide by ratio_x_v^2 + ratio_y_v^2.

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, derivative, divisors, jacobian_product,
    taylor,
};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2.
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// M11 = -m*ratio_x_v
/// M12 = x*sqrt(x^2 + y^2)/(x^2 + y^2)
/// M21 = m*ratio_y_v
/// M22 = y*sqrt(x^2 + y^2)/(x^2 + y^2)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (v', bob_force_to_o).
///
/// ```text
/// ratio_x_v = l*y/(x^2 + y^2)
/// ratio_y_v = l*x/(x^2 + y^2)
/// ratio_x_v_2 = l*v*ratio_y_v/(x^2 + y^2) + 2*l*y*(x*v*ratio_x_v - y*v*ratio_y_v)/(x^2 + y^2)^2
/// ratio_y_v_2 = l*v*ratio_x_v/(x^2 + y^2) + 2*l*x*(y*v*ratio_y_v - x*v*ratio_x_v)/(x^2 + y^2)^2
/// f1 = m*v*ratio_x_v_2
/// f2 = m*(v*ratio_y_v_2 - g)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
