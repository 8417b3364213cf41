//! Slider-crank: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u').
//! The kinematic equations are singular where cos(q + p) = 0.
//! The accelerations divide by cos(q + p), by l, by I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)).

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, divisors, inverse_dynamics,
    jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// ```text
/// M11 = I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p))
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u').
///
/// ```text
/// f1 = r*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q +
///     p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) + b*mr*cos(p)/l)) -
///     g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g - 2*r*u^2*cos(q))))
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// u' = r*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q +
///     p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) + b*mr*cos(p)/l)) -
///     g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g - 2*r*u^2*cos(q))))/(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q +
///     p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q' = u
/// p' = -u*(1 + r*cos(q)/(l*cos(q + p)))
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u^2*(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q +
///     p)))/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = g*(r*cos(q)*(mr + mp) + cos(q + p)*(b*mr + l*mp))
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
