//! Three-link pendulum on a cart: Three links fall over while the cart is pushed.
//!
//! Generated from `models/cart_pendulum_3/scenes/fall.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q0, q1, q2, q3, u0, u1, u2, u3.
//! States: q1, q2, q3, u1, u2, u3. Quadratures: u0, q0.
//! m3_l2 = m3*l2.
//! Parameters that the scene fixes: F = 2.75.
//! Singular nowhere.

pub use super::code::fall::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, energy_gradient,
    jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// m0
/// m1
/// m2
/// m3
/// l0
/// l1
/// l2
/// g
/// m3_l2 = m3*l2
/// ```
#[doc(inline)]
pub use super::code::fall::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// q1
/// q2
/// q3
/// q0
/// u1
/// u2
/// u3
/// u0
/// ```
#[doc(inline)]
pub use super::code::fall::start;

/// The accelerations (u1', u2', u3', u0'), solved for when this code was generated.
///
/// ```text
/// d1 = m3*l2^2
/// l2_ = -m3_l2*cos(q3)/d1
/// s3 = m0 + m1 + m2 + m3 + l2_*m3_l2*cos(q3)
/// s4 = -l0*(cos(q1)*(m1 + m2 + m3) + l2_*m3_l2*cos(q1 - q3))
/// s5 = -l1*(cos(q2)*(m2 + m3) + l2_*m3_l2*cos(q2 - q3))
/// r6 = 11/4 - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3_l2*(u3^2*sin(q3) + l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
/// l7 = m3*l0*l2*cos(q1 - q3)/d1
/// s8 = l0*(l0*(m1 + m2 + m3) - l7*m3_l2*cos(q1 - q3))
/// s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - l7*m3_l2*cos(q2 - q3))
/// r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3_l2*(l0*u3^2*sin(q1 - q3) + l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 -
///     q3)))
/// l11 = m3*l1*l2*cos(q2 - q3)/d1
/// s12 = l1*(l1*(m2 + m3) - l11*m3_l2*cos(q2 - q3))
/// r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3_l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
/// l14 = s4/s3
/// s15 = s8 - s4*l14
/// s16 = s9 - s5*l14
/// r17 = r10 - r6*l14
/// l18 = s5/s3
/// s19 = s12 - s5*l18
/// r20 = r13 - r6*l18
/// l21 = s16/s15
/// s22 = s19 - s16*l21
/// r23 = r20 - r17*l21
/// u2' = r23/s22
/// u0' = (r6 - s5*r23/s22 + s4*(s16*r23/s22 - r17)/s15)/s3
/// u3' = m3*l2*(g*sin(q3) + cos(q3)*(r6 - s5*r23/s22 + s4*(s16*r23/s22 - r17)/s15)/s3 + l0*(u1^2*sin(q1 - q3) + cos(q1 - q3)*(s16*r23/s22 - r17)/s15) +
///     l1*(u2^2*sin(q2 - q3) - r23*cos(q2 - q3)/s22))/d1
/// u1' = (r17 - s16*r23/s22)/s15
/// ```
#[doc(inline)]
pub use super::code::fall::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u1
/// q2' = u2
/// q3' = u3
/// q0' = u0
/// ```
#[doc(inline)]
pub use super::code::fall::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u0^2*(m0 + m1 + m2 + m3)/2 + l0*u1*((m1 + m2 + m3)*(l0*u1 - 2*u0*cos(q1)) + 2*l1*u2*cos(q1 - q2)*(m2 + m3))/2 + l1*u2*(m2 + m3)*(l1*u2 - 2*u0*cos(q2))/2 +
///     m3*l2*u3*(2*l0*u1*cos(q1 - q3) - 2*u0*cos(q3) + 2*l1*u2*cos(q2 - q3) + l2*u3)/2
/// ```
#[doc(inline)]
pub use super::code::fall::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// V = g*(l0*cos(q1)*(m1 + m2 + m3) + l1*cos(q2)*(m2 + m3) + m3*l2*cos(q3)) - 11*q0/4
/// ```
#[doc(inline)]
pub use super::code::fall::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// q0
/// q1
/// q2
/// q3
/// u0
/// u1
/// u2
/// u3
/// ```
#[doc(inline)]
pub use super::code::fall::outputs;
