//! Symmetric heavy top about a fixed point: Looping.
//!
//! Generated from `models/heavy_top/scenes/looping.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q1, q2, q3, u1, u2, u3.
//! States: q1, q2, u1, u2. Quadratures: q3.
//! p_q3 = I3*u3: momentum p_q3 = ∂L/∂q3'.
//! m_l_g = m*l*g.
//! Singular where cos(q2) = 0.

pub use super::code::looping::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// m
/// l
/// I1
/// I3
/// g
/// p_q3 = I3*u3
/// m_l_g = m*l*g
/// ```
#[doc(inline)]
pub use super::code::looping::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// q1
/// q2
/// q3
/// u1
/// u2
/// ```
#[doc(inline)]
pub use super::code::looping::start;

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// ```text
/// u3 = p_q3/I3
/// u2' = (u1*(I3*u3 - I1*u1*tan(q2)) + m_l_g*cos(q1)*sin(q2))/I1
/// u1' = (m_l_g*sin(q1) - u2*(I3*u3 - I1*u1*tan(q2)))/I1
/// ```
#[doc(inline)]
pub use super::code::looping::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u3 = p_q3/I3
/// q1' = u1/cos(q2)
/// q2' = u2
/// q3' = u3 - u1*tan(q2)
/// ```
#[doc(inline)]
pub use super::code::looping::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = I1*(u1^2 + u2^2)/2
/// ```
#[doc(inline)]
pub use super::code::looping::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// u3 = p_q3/I3
/// V = m*l*g*cos(q1)*cos(q2) + I3*u3^2/2
/// ```
#[doc(inline)]
pub use super::code::looping::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u3 = p_q3/I3
/// q1
/// q2
/// q3
/// u1
/// u2
/// ```
#[doc(inline)]
pub use super::code::looping::outputs;
