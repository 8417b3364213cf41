//! Three-link pendulum on a cart: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q0'', q1'', q2'', q3'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by d1, by s3, by s15, by s22.

pub use super::code::lagrange::{
    Lagrange, derivative, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q0, q1, q2, q3.
///
/// ```text
/// M11 = m0 + m1 + m2 + m3
/// M12 = -l0*cos(q1)*(m1 + m2 + m3)
/// M13 = -l1*cos(q2)*(m2 + m3)
/// M14 = -m3*l2*cos(q3)
/// M22 = l0^2*(m1 + m2 + m3)
/// M23 = l0*l1*cos(q1 - q2)*(m2 + m3)
/// M24 = m3*l0*l2*cos(q1 - q3)
/// M33 = l1^2*(m2 + m3)
/// M34 = m3*l1*l2*cos(q2 - q3)
/// M44 = m3*l2^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q0'', q1'', q2'', q3'').
///
/// ```text
/// f1 = F - l0*q1'^2*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q2)*(m2 + m3) - m3*l2*q3'^2*sin(q3)
/// f2 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q1 - q2)*(m2 + m3) - m3*l2*q3'^2*sin(q1 - q3))
/// f3 = l1*((m2 + m3)*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) - m3*l2*q3'^2*sin(q2 - q3))
/// f4 = m3*l2*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3))
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q0'', q1'', q2'', q3''), solved for when this code was generated.
///
/// ```text
/// d1 = m3*l2^2
/// l2_ = -m3*l2*cos(q3)/d1
/// s3 = m0 + m1 + m2 + m3 + m3*l2*l2_*cos(q3)
/// s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*cos(q1 - q3))
/// s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*cos(q2 - q3))
/// r6 = F - l0*q1'^2*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q2)*(m2 + m3) - m3*l2*(q3'^2*sin(q3) + l2_*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
/// l7 = m3*l0*l2*cos(q1 - q3)/d1
/// s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*cos(q1 - q3))
/// s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - m3*l2*l7*cos(q2 - q3))
/// r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q1 - q2)*(m2 + m3)) - m3*l2*(l0*q3'^2*sin(q1 - q3) + l7*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 -
///     q3)))
/// l11 = m3*l1*l2*cos(q2 - q3)/d1
/// s12 = l1*(l1*(m2 + m3) - m3*l2*l11*cos(q2 - q3))
/// r13 = l1*(m2 + m3)*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) - m3*l2*(l1*q3'^2*sin(q2 - q3) + l11*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
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
/// q2'' = r23/s22
/// q1'' = (r17 - q2''*s16)/s15
/// q0'' = (r6 - q1''*s4 - q2''*s5)/s3
/// q3'' = m3*l2*(g*sin(q3) + q0''*cos(q3) + l0*(q1'^2*sin(q1 - q3) - q1''*cos(q1 - q3)) + l1*(q2'^2*sin(q2 - q3) - q2''*cos(q2 - q3)))/d1
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q0'
/// q1'
/// q2'
/// q3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = q0'^2*(m0 + m1 + m2 + m3)/2 + l0^2*q1'^2*(m1 + m2 + m3)/2 - l0*q0'*q1'*cos(q1)*(m1 + m2 + m3) + l1^2*q2'^2*(m2 + m3)/2 - l1*q0'*q2'*cos(q2)*(m2 + m3) +
///     l0*l1*q1'*q2'*cos(q1 - q2)*(m2 + m3) + m3*l2^2*q3'^2/2 - m3*l2*q0'*q3'*cos(q3) + m3*l0*l2*q1'*q3'*cos(q1 - q3) + m3*l1*l2*q2'*q3'*cos(q2 - q3)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u0 = q0'
/// u1 = q1'
/// u2 = q2'
/// u3 = q3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u0' = q0''
/// u1' = q1''
/// u2' = q2''
/// u3' = q3''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q0' = u0
/// q1' = u1
/// q2' = u2
/// q3' = u3
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
