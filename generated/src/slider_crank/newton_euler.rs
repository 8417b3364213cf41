//! Slider-crank: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', wrist_force1, wrist_force2, rod_force_crank_frame1, rod_force_crank_frame2, piston_force_n1, crank_force_n1, crank_force_n2).
//! The kinematic equations are singular where cos(q + p) = 0.
//! The accelerations divide by cos(q + p), by l, by I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)).

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows crank force crank_frame1, crank force crank_frame2, crank moment crank_frame3, rod force rod_frame1, rod force rod_frame2, rod moment rod_frame3, piston force piston_frame1, piston force piston_frame2. Entries that are not listed are 0.
///
/// ```text
/// M14 = 1
/// M17 = -cos(q)
/// M18 = -sin(q)
/// M25 = 1
/// M27 = sin(q)
/// M28 = -cos(q)
/// M31 = I
/// M34 = -r
/// M41 = r*mr*(b*cos(q)/(l*cos(q + p)) - cos(p))
/// M42 = cos(q + p)
/// M43 = sin(q + p)
/// M44 = -cos(p)
/// M45 = -sin(p)
/// M51 = r*mr*sin(p)
/// M52 = -sin(q + p)
/// M53 = cos(q + p)
/// M54 = sin(p)
/// M55 = -cos(p)
/// M61 = -r*Ir*cos(q)/(l*cos(q + p))
/// M62 = cos(q + p)*(b - l)
/// M63 = sin(q + p)*(b - l)
/// M64 = -b*cos(p)
/// M65 = -b*sin(p)
/// M72 = -1
/// M76 = -1
/// M81 = r*mp*(cos(q)*tan(q + p) - sin(q))
/// M83 = -1
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u', wrist_force1, wrist_force2, rod_force_crank_frame1, rod_force_crank_frame2, piston_force_n1, crank_force_n1, crank_force_n2). Entries that are not listed are 0.
///
/// ```text
/// f1 = -mc*g*sin(q)
/// f2 = -mc*g*cos(q)
/// f4 = mr*(r*u^2*(sin(p) + b*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p))) - g*sin(q + p))
/// f5 = mr*(r*u^2*(cos(p) + r*b*cos(q)^2/(l^2*cos(q + p)^2)) - g*cos(q + p))
/// f6 = -r*Ir*u^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p))
/// f8 = mp*(r*u^2*(sin(q)*tan(q + p) + cos(q)*(1 + r*cos(q)/(l*cos(q + p)^3))) - g)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// u' = r*(g*(mp*sin(q) + mr*(sin(q + p)*cos(p) - sin(p)*cos(q + p))) - r*mp*u^2*sin(q)*cos(q) + (r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l +
///     r*cos(q)*(b*mr*sin(p)/l + (sin(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q + p)))/cos(q + p))/l +
///     mp*sin(q + p)*(cos(q) + sin(q)*tan(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) + b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p))/(I + r^2*(mr +
///     mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
