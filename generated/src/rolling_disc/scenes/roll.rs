//! Thin disc rolling on a plane: Rolling in curves.
//!
//! Generated from `models/rolling_disc/scenes/roll.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q1, q2, q3, x, y, u1, u2, u3.
//! States: q2, u1, u2, u3. Quadratures: q1, y, x, q3.
//! g_times_4 = 4*g.
//! r_m_by_4 = r*m/4.
//! r_squared_m = r^2*m.
//! r_squared_m_by_4 = r^2*m/4.
//! r_squared_m_times_5_by_4 = 5*r^2*m/4.
//! r_squared_m_times_3_by_2 = 3*r^2*m/2.
//! Singular where cos(q2) = 0.

pub use super::code::roll::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// r
/// m
/// g
/// g_times_4 = 4*g
/// r_m_by_4 = r*m/4
/// r_squared_m = r^2*m
/// r_squared_m_by_4 = r^2*m/4
/// r_squared_m_times_5_by_4 = 5*r^2*m/4
/// r_squared_m_times_3_by_2 = 3*r^2*m/2
/// ```
#[doc(inline)]
pub use super::code::roll::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// q2
/// q1
/// y
/// x
/// q3
/// u1
/// u2
/// u3
/// ```
#[doc(inline)]
pub use super::code::roll::start;

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// ```text
/// u3' = u1*(u3*tan(q2) - 2*u2)
/// u2' = -u1*u3*r_squared_m/r_squared_m_times_3_by_2
/// u1' = r_m_by_4*(r*u3*(6*u2 - u3*tan(q2)) + g_times_4*sin(q2))/r_squared_m_times_5_by_4
/// ```
#[doc(inline)]
pub use super::code::roll::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q2' = u1
/// q1' = u3/cos(q2)
/// y' = r*sin(q1)*(u2 - u3*tan(q2))
/// x' = r*cos(q1)*(u2 - u3*tan(q2))
/// q3' = u2 - u3*tan(q2)
/// ```
#[doc(inline)]
pub use super::code::roll::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = r^2*m*(5*u1^2 + 6*u2^2 + u3^2)/8
/// ```
#[doc(inline)]
pub use super::code::roll::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = r*m*g*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::roll::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// q1
/// q2
/// q3
/// x
/// y
/// u1
/// u2
/// u3
/// ```
#[doc(inline)]
pub use super::code::roll::outputs;
