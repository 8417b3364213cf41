//! Satellite with a reaction wheel: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (e0'', e1'', e2'', e3'', phi'', lambda_S_norm).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by e0^2 + e1^2 + e2^2 + e3^2, by 3*A + 2*K, by 3*B + K*(2 - K/(3*A + 2*K)), by 3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))), by J.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, divisors, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows e0, e1, e2, e3, phi, constraint S_norm. Entries that are not listed are 0.
///
/// ```text
/// M11 = 4*(e3^2*(3*C + J + 2*K) + e1*(3*A*e1 + J*(e1 + 2*e2 + 2*e3) + 2*K*(e1 - e2 - e3)) + e2*(e2*(3*B + J + 2*K) + 2*e3*(J - K)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M12 = -4*(e0*e1*(3*A + J + 2*K) + e2*(J*(e0 + e1 + e2) - K*(e0 + e1 + e2) + 3*e3*(C - B)) + e3*(J*(e0 - e1 - e3) + K*(e1 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M13 = -4*(e0*e2*(3*B + J + 2*K) + e1*(J*(e0 - e1 - e2) + K*(e1 - e0 + e2) + 3*e3*(A - C)) + e3*(J*(e0 + e2 + e3) - K*(e0 + e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M14 = -4*(e0*e3*(3*C + J + 2*K) + e1*(3*e2*(B - A) + J*(e0 + e1 + e3) - K*(e0 + e1 + e3)) + e2*(J*(e0 - e2 - e3) + K*(e2 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M15 = -2*J*sqrt(3)*(e1 + e2 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M16 = -2*e0
/// M21 = -4*(e0*e1*(3*A + J + 2*K) + e2*(J*(e0 + e1 + e2) - K*(e0 + e1 + e2) + 3*e3*(C - B)) + e3*(J*(e0 - e1 - e3) + K*(e1 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M22 = 4*(e3^2*(3*B + J + 2*K) + e0*(3*A*e0 + J*(e0 + 2*e2 - 2*e3) + 2*K*(e0 - e2 + e3)) + e2*(e2*(3*C + J + 2*K) - 2*e3*(J - K)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M23 = 4*(e0*(J*(e0 - e1 + e2) + K*(e1 - e0 - e2) + 3*e3*(A - B)) - e1*e2*(3*C + J + 2*K) + e3*(J*(e1 + e2 - e3) + K*(e3 - e1 - e2)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M24 = 4*(e0*(3*e2*(C - A) + J*(e0 + e1 - e3) + K*(e3 - e0 - e1)) - e1*e3*(3*B + J + 2*K) + e2*(J*(e1 - e2 + e3) + K*(e2 - e1 - e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M25 = 2*J*sqrt(3)*(e0 + e2 - e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M26 = -2*e1
/// M31 = -4*(e0*e2*(3*B + J + 2*K) + e1*(J*(e0 - e1 - e2) + K*(e1 - e0 + e2) + 3*e3*(A - C)) + e3*(J*(e0 + e2 + e3) - K*(e0 + e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M32 = 4*(e0*(J*(e0 - e1 + e2) + K*(e1 - e0 - e2) + 3*e3*(A - B)) - e1*e2*(3*C + J + 2*K) + e3*(J*(e1 + e2 - e3) + K*(e3 - e1 - e2)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M33 = 4*(e3^2*(3*A + J + 2*K) + e0*(3*B*e0 + 2*K*(e0 + e1 - e3) + J*(e0 - 2*e1 + 2*e3)) + e1*(e1*(3*C + J + 2*K) - 2*e3*(J - K)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M34 = 4*(e1*(J*(e2 - e1 + e3) + K*(e1 - e2 - e3)) - e2*e3*(3*A + J + 2*K) - e0*(3*e1*(C - B) + J*(e2 - e0 - e3) + K*(e0 - e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M35 = 2*J*sqrt(3)*(e0 - e1 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M36 = -2*e2
/// M41 = -4*(e0*e3*(3*C + J + 2*K) + e1*(3*e2*(B - A) + J*(e0 + e1 + e3) - K*(e0 + e1 + e3)) + e2*(J*(e0 - e2 - e3) + K*(e2 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M42 = 4*(e0*(3*e2*(C - A) + J*(e0 + e1 - e3) + K*(e3 - e0 - e1)) - e1*e3*(3*B + J + 2*K) + e2*(J*(e1 - e2 + e3) + K*(e2 - e1 - e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M43 = 4*(e1*(J*(e2 - e1 + e3) + K*(e1 - e2 - e3)) - e2*e3*(3*A + J + 2*K) - e0*(3*e1*(C - B) + J*(e2 - e0 - e3) + K*(e0 - e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M44 = 4*(e2^2*(3*A + J + 2*K) + e0*(3*C*e0 + 2*K*(e0 - e1 + e2) + J*(e0 + 2*e1 - 2*e2)) + e1*(e1*(3*B + J + 2*K) + 2*e2*(K - J)))/(3*(e0^2 + e1^2 + e2^2 +
///     e3^2)^2)
/// M45 = 2*J*sqrt(3)*(e0 + e1 - e2)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M46 = -2*e3
/// M51 = -2*J*sqrt(3)*(e1 + e2 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M52 = 2*J*sqrt(3)*(e0 + e2 - e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M53 = 2*J*sqrt(3)*(e0 - e1 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M54 = 2*J*sqrt(3)*(e0 + e1 - e2)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
/// M55 = J
/// M61 = 2*e0
/// M62 = 2*e1
/// M63 = 2*e2
/// M64 = 2*e3
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (e0'', e1'', e2'', e3'', phi'', lambda_S_norm).
///
/// ```text
/// w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
///     sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' +
///     e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 +
///     e3^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
/// H_bus_1 = A*w_S_1
/// H_bus_2 = B*w_S_2
/// H_bus_3 = C*w_S_3
/// H_wheel_1 = K*w_S_in_axle_base_1
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_in_axle_base_1_2 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*(e0*e2'
///     - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
///     e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_in_axle_base_2_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*(1/(3 +
///     sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
///     e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_in_axle_base_3_2 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e0*e2' - e2*e0'
///     - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' +
///     e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// H_bus_1_2 = A*w_S_1_2
/// H_bus_2_2 = B*w_S_2_2
/// H_bus_3_2 = C*w_S_3_2
/// H_wheel_1_2 = K*w_S_in_axle_base_1_2
/// H_wheel_2_2 = K*w_S_in_axle_base_2_2
/// H_wheel_3_2 = J*w_S_in_axle_base_3_2
/// f1 = 4*(3*e3*(e0*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) - 6*e0*H_bus_3_2) + e3*(e2'*(6*H_bus_2 + H_wheel_1 -
///     H_wheel_2) + e1'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 6*e3*H_bus_3_2)) - 3*e1*(e2*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2'*(6*H_bus_1 - H_wheel_1 +
///     H_wheel_2) + e1*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e1*(e2'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) -
///     6*e3'*H_bus_3 + 6*e3*H_bus_3_2 + e1*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e0*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) - 6*e2'*H_bus_3 + e0*(6*H_bus_1_2 -
///     H_wheel_1_2 + H_wheel_2_2)) + e3*(6*e1'*H_bus_3 + e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) -
///     3*e2*(e2*(e1'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) - 6*e3'*H_bus_3 + 6*e3*H_bus_3_2 + e2*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2)) + e0*(6*e1'*H_bus_3 -
///     e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - e0*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2)) + e3*(6*e2'*H_bus_3 + e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
///     e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) + sqrt(3)*(e1*(e1*(e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
///     e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) - 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) +
///     e0*(e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e2*(e1'*(H_wheel_1
///     + H_wheel_2 - H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e3'*(H_wheel_1 + H_wheel_2 -
///     H_wheel_3) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2))) + e2*(e2*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
///     e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) - 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) +
///     e0*(e3'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) - e3*(e3'*(H_wheel_3
///     - H_wheel_1 - H_wheel_2) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2))) + e3*(e0*(e1'*(H_wheel_3 - H_wheel_1 -
///     H_wheel_2) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e0*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
///     e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
/// f2 = 4*(3*e0*(e3*(e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e0*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) +
///     e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e0*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) - 6*e2'*H_bus_3 + 6*e2*H_bus_3_2 + e0*(6*H_bus_1_2 - H_wheel_1_2 +
///     H_wheel_2_2)) + e1*(e2'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) - 6*e3'*H_bus_3 + e1*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e2*(6*e0'*H_bus_3 + e2'*(6*H_bus_1
///     - H_wheel_1 + H_wheel_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) - 3*e3*(e1*(e2'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 6*e0'*H_bus_3 + e1*(6*H_bus_2_2
///     + H_wheel_1_2 - H_wheel_2_2)) + e3*(6*e2'*H_bus_3 + e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) +
///     3*e2*(e1*(e0'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*e1*H_bus_3_2) + e3*(6*e3'*H_bus_3 - e2'*(6*H_bus_2 + H_wheel_1 -
///     H_wheel_2) + 6*e3*H_bus_3_2) + e2*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e0'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) + 6*e2*H_bus_3_2 + e3*(H_wheel_2_2 -
///     6*H_bus_2_2 - H_wheel_1_2))) - sqrt(3)*(e0*(e0*(e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0*(H_wheel_1_2 +
///     H_wheel_2_2 - 2*H_wheel_3_2) + e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e1*(e2'*(H_wheel_3 - H_wheel_1
///     - H_wheel_2) + e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e2*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
///     e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(H_wheel_1 +
///     H_wheel_2 - H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2))) + e2*(e2*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(H_wheel_1 + H_wheel_2 -
///     H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e1*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
///     e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e3*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(2*H_wheel_1 +
///     2*H_wheel_2 + H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2))) + e3*(e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(2*H_wheel_1 + 2*H_wheel_2 +
///     H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) - e1*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
///     e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
/// f3 = 4*(3*e3*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e3*(6*e1'*H_bus_3 + e0'*(H_wheel_2 -
///     6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) - 3*e0*(e2*(6*e3'*H_bus_3 + e1'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e2*(H_wheel_2_2 -
///     6*H_bus_2_2 - H_wheel_1_2)) - e3*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e3*(6*H_bus_2_2 + H_wheel_1_2 -
///     H_wheel_2_2) + e0*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e1'*H_bus_3 - e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 6*e1*H_bus_3_2 - e0*(H_wheel_2_2 -
///     6*H_bus_2_2 - H_wheel_1_2)) - e1*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) - 6*e0'*H_bus_3 + e1*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) -
///     3*e1*(e2*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e0'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) + 6*e2*H_bus_3_2) - e1*(e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
///     e3'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) - 6*e1*H_bus_3_2 + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e3*(6*e3'*H_bus_3 + e1'*(H_wheel_1 - 6*H_bus_1 -
///     H_wheel_2) + 6*e3*H_bus_3_2)) - sqrt(3)*(e0*(e0*(e3'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0*(H_wheel_1_2 +
///     H_wheel_2_2 - 2*H_wheel_3_2) + e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) + 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e1*(e1'*(H_wheel_1 + H_wheel_2
///     - H_wheel_3) + e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e2*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
///     e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(H_wheel_1 +
///     H_wheel_2 - H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2))) + e1*(e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(2*H_wheel_1 + 2*H_wheel_2 +
///     H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e1*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
///     e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e2*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(H_wheel_1
///     + H_wheel_2 - H_wheel_3) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2))) + e3*(e2*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0'*(2*H_wheel_1 + 2*H_wheel_2 +
///     H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
///     e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
/// f4 = 4*(3*e1*(e1*(e2'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 6*e0'*H_bus_3 + e1*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2)) + e3*(6*e2'*H_bus_3 + e0'*(6*H_bus_1 -
///     H_wheel_1 + H_wheel_2) + e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2)) - e2*(e2'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e1'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) +
///     e2*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) + e1*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e0*(6*e1'*H_bus_3 + e0'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
///     6*e1*H_bus_3_2 + e0*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) - 3*e2*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2*(6*H_bus_1_2 -
///     H_wheel_1_2 + H_wheel_2_2)) + e3*(6*e1'*H_bus_3 + e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) +
///     3*e0*(e2*(6*e2'*H_bus_3 + e0'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) + 6*e2*H_bus_3_2) - e3*(e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e1'*(6*H_bus_1 - H_wheel_1 +
///     H_wheel_2) - 6*e3*H_bus_3_2) - e0*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) - 6*e0*H_bus_3_2 + e2*(6*H_bus_1_2 -
///     H_wheel_1_2 + H_wheel_2_2))) + sqrt(3)*(e2*(e2*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2*(H_wheel_1_2 +
///     H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 -
///     2*H_wheel_3_2))) + e0*(e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) +
///     e0*(2*e0*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2) - e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e1*(H_wheel_1_2 +
///     H_wheel_2_2 - 2*H_wheel_3_2) - e2*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) + e1*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e1'*(2*H_wheel_1 + 2*H_wheel_2 +
///     H_wheel_3) + 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e2*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
///     2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2))) + e1*(e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
///     e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) - e1*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1*(H_wheel_1_2 +
///     H_wheel_2_2 - 2*H_wheel_3_2) + e2*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) - e2*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 + H_wheel_2 -
///     H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
/// f5 = T + 4*H_wheel_3_2/3
/// f6 = -2*e0'^2 - 2*e1'^2 - 2*e2'^2 - 2*e3'^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (e0'', e1'', e2'', e3'', phi''), solved for when this code was generated.
///
/// ```text
/// w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
///     sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' +
///     e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 +
///     e3^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
/// H_bus_1 = A*w_S_1
/// H_bus_2 = B*w_S_2
/// H_bus_3 = C*w_S_3
/// H_wheel_1 = K*w_S_in_axle_base_1
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_in_axle_base_1_2 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*(e0*e2'
///     - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
///     e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_in_axle_base_2_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*(1/(3 +
///     sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
///     e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// w_S_in_axle_base_3_2 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e0*e2' - e2*e0'
///     - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' +
///     e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
/// H_bus_1_2 = A*w_S_1_2
/// H_bus_2_2 = B*w_S_2_2
/// H_bus_3_2 = C*w_S_3_2
/// H_wheel_1_2 = K*w_S_in_axle_base_1_2
/// H_wheel_2_2 = K*w_S_in_axle_base_2_2
/// H_wheel_3_2 = J*w_S_in_axle_base_3_2
/// r1 = 2*(18*H_bus_3_2*(e0^2 + e1^2 + e2^2 + e3^2) - 18*H_bus_1*(e2*e0' - e0*e2' + e3*e1' - e1*e3') - 18*H_bus_2*(e0*e1' - e1*e0' + e3*e2' - e2*e3') -
///     3*H_wheel_1*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) - 3*H_wheel_2*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' -
///     e3')) - sqrt(3)*(e0*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e0*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) -
///     e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e1*(e0'*(H_wheel_1 +
///     H_wheel_2 - H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e2*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2)
///     + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)) - sqrt(3)*(3*T + 4*H_wheel_3_2)/9
///     - K*(sqrt(3)*(3*T + 4*H_wheel_3_2) + 2*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 -
///     H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
///     H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
///     2*H_wheel_3_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(9*(3*A + 2*K)) + K*(A + K)*(2*(18*H_bus_3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
///     e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) - K*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1'
///     + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)
///     + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)
///     + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))/(3*A + 2*K) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
///     H_wheel_3) + (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(2*H_wheel_3_2 - H_wheel_1_2 -
///     H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2) - sqrt(3)*(1 + K/(3*A + 2*K))*(3*T + 4*H_wheel_3_2))/(3*(3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K))))
/// w3' = 3*r1/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))))
/// w2' = -(sqrt(3)*(3*T + 4*H_wheel_3_2) + 2*(K*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 -
///     H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
///     H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
///     2*H_wheel_3_2)))/(3*A + 2*K) - 18*H_bus_3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') - 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) -
///     3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) - sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
///     (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)))/(e0^2 +
///     e1^2 + e2^2 + e3^2) + K*(sqrt(3)*(3*T + 4*H_wheel_3_2) - 9*w3'*(A + K))/(3*A + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
/// w1' = (3*K*(w2' + w3') - sqrt(3)*(3*T + 4*H_wheel_3_2) - 2*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 +
///     H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
///     H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
///     2*H_wheel_3_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*A + 2*K))
/// s' = (3*T + 4*H_wheel_3_2)/(3*J) - sqrt(3)*(w1' + w2' + w3')/3
/// e0'' = -e0*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' +
///     e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e1*w1'/2 - e2*w2'/2 - e3*w3'/2
/// e1'' = e0*w1'/2 - e1*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) -
///     2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e3*w2'/2 + e2*w3'/2
/// e2'' = e3*w1'/2 - e2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) -
///     2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e0*w2'/2 - e1*w3'/2
/// e3'' = e1*w2'/2 - e3*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) -
///     2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e2*w1'/2 + e0*w3'/2
/// phi'' = s'
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// e0'
/// e1'
/// e2'
/// e3'
/// phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
///     sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' +
///     e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 +
///     e3^2) + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
/// H_bus_1 = A*w_S_1
/// H_bus_2 = B*w_S_2
/// H_bus_3 = C*w_S_3
/// H_wheel_1 = K*w_S_in_axle_base_1
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// T = 2*w_S_1*H_bus_1 + 2*w_S_2*H_bus_2 + 2*w_S_3*H_bus_3 + 2*w_S_in_axle_base_1*H_wheel_1/9 + 2*w_S_in_axle_base_2*H_wheel_2/9 + w_W_turn1_3*H_wheel_3/18
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// w1 = 2*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w2 = 2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// w3 = 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
/// s = phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// w1' = 4*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 2*(e0*e1'' - e1*e0'' + e3*e2'' - e2*e3'')/(e0^2
///     + e1^2 + e2^2 + e3^2)
/// w2' = 4*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 2*(e0*e2'' - e2*e0'' - e3*e1'' + e1*e3'')/(e0^2
///     + e1^2 + e2^2 + e3^2)
/// w3' = 4*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 2*(e2*e1'' - e3*e0'' - e1*e2'' + e0*e3'')/(e0^2
///     + e1^2 + e2^2 + e3^2)
/// s' = phi''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// e0' = -e1*w1/2 - e2*w2/2 - e3*w3/2
/// e1' = e0*w1/2 - e3*w2/2 + e2*w3/2
/// e2' = e3*w1/2 + e0*w2/2 - e1*w3/2
/// e3' = e1*w2/2 - e2*w1/2 + e0*w3/2
/// phi' = s
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
