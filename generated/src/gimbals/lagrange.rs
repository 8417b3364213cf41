//! Gyroscope in gimbals: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (psi'', theta'', phi'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by s2, by s5, by C.

pub use super::code::lagrange::{
    Lagrange, derivative, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows psi, theta, phi. Entries that are not listed are 0.
///
/// ```text
/// w_inner_frame_in_rotor_frame_1_4 = sin(theta)*sin(phi)
/// w_inner_frame_in_rotor_frame_2_4 = sin(theta)*cos(phi)
/// H_inner_2_4 = Ay*sin(theta)
/// H_inner_3_4 = Az*cos(theta)
/// H_rotor_1_4 = B*w_inner_frame_in_rotor_frame_1_4
/// H_rotor_2_4 = B*w_inner_frame_in_rotor_frame_2_4
/// H_rotor_3_4 = C*cos(theta)
/// p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4
/// p_w_outer_frame_in_inner_frame_2_4 = H_inner_2_4 + H_rotor_1_4*sin(phi) + H_rotor_2_4*cos(phi)
/// H_rotor_1_5 = B*cos(phi)
/// H_rotor_2_5 = B*sin(phi)
/// p_w_outer_frame_in_inner_frame_2_5 = H_rotor_2_5*cos(phi) - H_rotor_1_5*sin(phi)
/// M11 = Iz + p_w_outer_frame_in_inner_frame_3_4*cos(theta) + p_w_outer_frame_in_inner_frame_2_4*sin(theta)
/// M12 = -p_w_outer_frame_in_inner_frame_2_5*sin(theta)
/// M13 = C*cos(theta)
/// M22 = Ax + H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi)
/// M33 = C
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (psi'', theta'', phi'').
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
/// w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
/// w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3
/// p_w_outer_frame_in_inner_frame_2 = H_inner_2 + H_rotor_1*sin(phi) - H_rotor_2*cos(phi)
/// w_outer_frame_in_inner_frame_2_2 = psi'*theta'*cos(theta)
/// w_outer_frame_in_inner_frame_3_2 = psi'*theta'*sin(theta)
/// w_inner_frame_in_rotor_frame_1_2 = theta'*phi'*sin(phi) - phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2_2 = theta'*phi'*cos(phi) + phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_2*cos(phi)
/// H_inner_2_2 = Ay*w_outer_frame_in_inner_frame_2_2
/// H_inner_3_2 = Az*w_outer_frame_in_inner_frame_3_2
/// H_rotor_1_2 = B*w_inner_frame_in_rotor_frame_1_2
/// H_rotor_2_2 = B*w_inner_frame_in_rotor_frame_2_2
/// H_rotor_3_2 = C*w_outer_frame_in_inner_frame_3_2
/// p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2
/// p_w_outer_frame_in_inner_frame_2_2 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_2 - H_rotor_1_2*sin(phi) - H_rotor_2_2*cos(phi)
/// f1 = theta'*(p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)) + p_w_outer_frame_in_inner_frame_3_2*cos(theta) -
///     p_w_outer_frame_in_inner_frame_2_2*sin(theta)
/// f2 = phi'*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) + psi'*(p_w_outer_frame_in_inner_frame_2*cos(theta) - p_w_outer_frame_in_inner_frame_3*sin(theta)) +
///     H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi)
/// f3 = H_rotor_1*(w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)) + H_rotor_2*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_2
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (psi'', theta'', phi''), solved for when this code was generated.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
/// w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
/// w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3
/// p_w_outer_frame_in_inner_frame_2 = H_inner_2 + H_rotor_1*sin(phi) - H_rotor_2*cos(phi)
/// w_outer_frame_in_inner_frame_2_2 = psi'*theta'*cos(theta)
/// w_outer_frame_in_inner_frame_3_2 = psi'*theta'*sin(theta)
/// w_inner_frame_in_rotor_frame_1_2 = theta'*phi'*sin(phi) - phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2_2 = theta'*phi'*cos(phi) + phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_2*cos(phi)
/// H_inner_2_2 = Ay*w_outer_frame_in_inner_frame_2_2
/// H_inner_3_2 = Az*w_outer_frame_in_inner_frame_3_2
/// H_rotor_1_2 = B*w_inner_frame_in_rotor_frame_1_2
/// H_rotor_2_2 = B*w_inner_frame_in_rotor_frame_2_2
/// H_rotor_3_2 = C*w_outer_frame_in_inner_frame_3_2
/// p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2
/// p_w_outer_frame_in_inner_frame_2_2 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_2 - H_rotor_1_2*sin(phi) - H_rotor_2_2*cos(phi)
/// w_inner_frame_in_rotor_frame_1_4 = sin(theta)*sin(phi)
/// w_inner_frame_in_rotor_frame_2_4 = sin(theta)*cos(phi)
/// H_inner_2_4 = Ay*sin(theta)
/// H_inner_3_4 = Az*cos(theta)
/// H_rotor_1_4 = B*w_inner_frame_in_rotor_frame_1_4
/// H_rotor_2_4 = B*w_inner_frame_in_rotor_frame_2_4
/// H_rotor_3_4 = C*cos(theta)
/// p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4
/// p_w_outer_frame_in_inner_frame_2_4 = H_inner_2_4 + H_rotor_1_4*sin(phi) + H_rotor_2_4*cos(phi)
/// H_rotor_1_5 = B*cos(phi)
/// H_rotor_2_5 = B*sin(phi)
/// p_w_outer_frame_in_inner_frame_2_5 = H_rotor_2_5*cos(phi) - H_rotor_1_5*sin(phi)
/// l1 = cos(theta)
/// s2 = Iz + p_w_outer_frame_in_inner_frame_2_4*sin(theta) + cos(theta)*(p_w_outer_frame_in_inner_frame_3_4 - C*l1)
/// r3 = theta'*(p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)) + p_w_outer_frame_in_inner_frame_3_2*cos(theta) -
///     p_w_outer_frame_in_inner_frame_2_2*sin(theta) - l1*(H_rotor_1*(w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)) + H_rotor_2*(theta'*cos(phi) +
///     w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_2)
/// l4 = -p_w_outer_frame_in_inner_frame_2_5*sin(theta)/s2
/// s5 = Ax + H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi) + p_w_outer_frame_in_inner_frame_2_5*l4*sin(theta)
/// r6 = phi'*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) + psi'*(p_w_outer_frame_in_inner_frame_2*cos(theta) - p_w_outer_frame_in_inner_frame_3*sin(theta)) +
///     H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi) - r3*l4
/// theta'' = r6/s5
/// psi'' = (theta''*p_w_outer_frame_in_inner_frame_2_5*sin(theta) + r3)/s2
/// phi'' = (theta'*(H_rotor_2*cos(phi) - H_rotor_1*sin(phi)) + w_outer_frame_in_inner_frame_2*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) + H_rotor_3_2)/C -
///     psi''*cos(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// psi'
/// theta'
/// phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
/// w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
/// w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// H_outer_3_2 = Iz*psi'
/// H_inner_1_2 = Ax*theta'
/// T = w_outer_frame_in_inner_frame_2*H_inner_2/2 + w_outer_frame_in_inner_frame_3*H_inner_3/2 + w_inner_frame_in_rotor_frame_1*H_rotor_1/2 +
///     w_inner_frame_in_rotor_frame_2*H_rotor_2/2 + w_rotor_frame_3*H_rotor_3/2 + psi'*H_outer_3_2/2 + theta'*H_inner_1_2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u_psi = psi'
/// u_theta = theta'
/// u_phi = phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u_psi' = psi''
/// u_theta' = theta''
/// u_phi' = phi''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// psi' = u_psi
/// theta' = u_theta
/// phi' = u_phi
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
