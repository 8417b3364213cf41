//! Chaotic pendulum: a swinging rod with a plate turning about it: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (omega', alpha', pin1, pin2, pin3, pin_torque1, pin_torque3, bearing1, bearing2, bearing3, bearing_torque1, bearing_torque2).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by mA*lA^2 + mB*lB^2 + IAxx + IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2), by IBzz.

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rod force a1, rod force a2, rod force a3, rod moment a1, rod moment a2, rod moment a3, plate force b1, plate force b2, plate force b3, plate moment b1, plate moment b2, plate moment b3. Entries that are not listed are 0.
///
/// ```text
/// M_1_1 = mA*lA
/// M_1_3 = -1
/// M_1_8 = 1
/// M_2_4 = -1
/// M_2_9 = 1
/// M_3_5 = -1
/// M_3_10 = 1
/// M_4_4 = -lA
/// M_4_6 = -1
/// M_4_9 = lA - lB
/// M_4_11 = 1
/// M_5_1 = IAxx
/// M_5_3 = lA
/// M_5_8 = lB - lA
/// M_5_12 = 1
/// M_6_7 = -1
/// M_7_1 = mB*lB*cos(phi)
/// M_7_8 = -cos(phi)
/// M_7_9 = -sin(phi)
/// M_8_1 = -mB*lB*sin(phi)
/// M_8_8 = sin(phi)
/// M_8_9 = -cos(phi)
/// M_9_10 = -1
/// M_10_1 = IBxx*sin(phi)
/// M_10_11 = -cos(phi)
/// M_10_12 = -sin(phi)
/// M_11_1 = IByy*cos(phi)
/// M_11_11 = sin(phi)
/// M_11_12 = -cos(phi)
/// M_12_2 = IBzz
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (omega', alpha', pin1, pin2, pin3, pin_torque1, pin_torque3, bearing1, bearing2, bearing3, bearing_torque1, bearing_torque2). Entries that are not listed are 0.
///
/// ```text
/// f_1 = -mA*g*sin(theta)
/// f_3 = mA*(g*cos(theta) + lA*omega^2)
/// f_7 = -mB*g*sin(theta)*cos(phi)
/// f_8 = mB*g*sin(theta)*sin(phi)
/// f_9 = mB*(g*cos(theta) + lB*omega^2)
/// f_10 = omega*alpha*cos(phi)*(IByy - IBxx - IBzz)
/// f_11 = omega*alpha*sin(phi)*(IByy - IBxx + IBzz)
/// f_12 = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// ```text
/// omega' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2))
/// alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;
