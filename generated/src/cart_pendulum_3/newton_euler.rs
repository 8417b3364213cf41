//! Three-link pendulum on a cart: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u0', u1', u2', u3', rail, T1, T2, T3).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by d1, by s3, by s15, by s22.

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows cart force n1, cart force n2, bob1 force n1, bob1 force n2, bob2 force n1, bob2 force n2, bob3 force n1, bob3 force n2. Entries that are not listed are 0.
///
/// ```text
/// M11 = m0
/// M16 = -sin(q1)
/// M25 = -1
/// M26 = cos(q1)
/// M31 = m1
/// M32 = -m1*l0*cos(q1)
/// M36 = sin(q1)
/// M37 = -sin(q2)
/// M42 = -m1*l0*sin(q1)
/// M46 = -cos(q1)
/// M47 = cos(q2)
/// M51 = m2
/// M52 = -m2*l0*cos(q1)
/// M53 = -m2*l1*cos(q2)
/// M57 = sin(q2)
/// M58 = -sin(q3)
/// M62 = -m2*l0*sin(q1)
/// M63 = -m2*l1*sin(q2)
/// M67 = -cos(q2)
/// M68 = cos(q3)
/// M71 = m3
/// M72 = -m3*l0*cos(q1)
/// M73 = -m3*l1*cos(q2)
/// M74 = -m3*l2*cos(q3)
/// M78 = sin(q3)
/// M82 = -m3*l0*sin(q1)
/// M83 = -m3*l1*sin(q2)
/// M84 = -m3*l2*sin(q3)
/// M88 = -cos(q3)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u0', u1', u2', u3', rail, T1, T2, T3).
///
/// ```text
/// f1 = F
/// f2 = -m0*g
/// f3 = -m1*l0*u1^2*sin(q1)
/// f4 = m1*(l0*u1^2*cos(q1) - g)
/// f5 = -m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2))
/// f6 = m2*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2))
/// f7 = -m3*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
/// f8 = m3*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2) + l2*u3^2*cos(q3))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u0', u1', u2', u3'), solved for when this code was generated.
///
/// ```text
/// d1 = m3*l2^2
/// l2_ = -m3*l2*cos(q3)/d1
/// s3 = m0 + m1 + m2 + m3 + m3*l2*l2_*cos(q3)
/// s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*(sin(q1)*sin(q3) + cos(q1)*cos(q3)))
/// s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
/// r6 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - m3*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2) + l2*(u3^2*sin(q3) + l2_*(cos(q3)*(l0*u1^2*sin(q1)
///     + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))))
/// l7 = m3*l0*l2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))/d1
/// s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*(sin(q1)*sin(q3) + cos(q1)*cos(q3)))
/// s9 = l1*(m2*l0*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(l0*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) - l2*l7*(sin(q2)*sin(q3) + cos(q2)*cos(q3))))
/// r10 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(g*sin(q1) - l1*u2^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) -
///     l2*(u3^2*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) + u1^2*l7*(sin(q1)*cos(q3) - cos(q1)*sin(q3))))) - m3*l2*l7*(g*sin(q3) + l1*u2^2*(sin(q2)*cos(q3) -
///     cos(q2)*sin(q3)))
/// l11 = m3*l1*l2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))/d1
/// s12 = l1*(l1*(m2 + m3) - m3*l2*l11*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
/// r13 = m2*l1*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(l1*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) -
///     l2*(u3^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) + u2^2*l11*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))) - l2*l11*(g*sin(q3) + l0*u1^2*(sin(q1)*cos(q3) -
///     cos(q1)*sin(q3))))
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
/// u1' = (r17 - u2'*s16)/s15
/// u0' = (r6 - u1'*s4 - u2'*s5)/s3
/// u3' = m3*l2*(sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))) + cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2)
///     - u2'*cos(q2))))/d1
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
