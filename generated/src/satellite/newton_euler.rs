//! Satellite with a reaction wheel: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (w1', w2', w3', s', wheel_torque_axle_base1, wheel_torque_axle_base2).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by A + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3, by B + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3), by 9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 - x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) - x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3)), by J.

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, derivative, jacobian_product,
};

pub use super::kane::{coordinate_rates, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bus moment s1, bus moment s2, bus moment s3, wheel moment axle_base1, wheel moment axle_base2, wheel moment axle_base3. Entries that are not listed are 0.
///
/// ```text
/// x_axle_base_in_S_1_2 = 1/(3 + sqrt(3)) - 1
/// x_axle_base_in_S_1_3 = 1/(3 + sqrt(3))
/// x_axle_base_1_2 = K*x_axle_base_in_S_1_2
/// x_axle_base_1_3 = K*x_axle_base_in_S_1_3
/// x_axle_base_1_4 = K*sqrt(3)
/// x_axle_base_3_2 = J*sqrt(3)
/// M11 = A
/// M15 = -x_axle_base_in_S_1_2
/// M16 = -x_axle_base_in_S_1_3
/// M22 = B
/// M25 = -x_axle_base_in_S_1_3
/// M26 = -x_axle_base_in_S_1_2
/// M33 = C
/// M35 = -sqrt(3)/3
/// M36 = -sqrt(3)/3
/// M41 = -x_axle_base_1_2
/// M42 = -x_axle_base_1_3
/// M43 = -x_axle_base_1_4/3
/// M45 = -1
/// M51 = -x_axle_base_1_3
/// M52 = -x_axle_base_1_2
/// M53 = -x_axle_base_1_4/3
/// M56 = -1
/// M61 = x_axle_base_3_2/3
/// M62 = x_axle_base_3_2/3
/// M63 = x_axle_base_3_2/3
/// M64 = J
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (w1', w2', w3', s', wheel_torque_axle_base1, wheel_torque_axle_base2).
///
/// ```text
/// H_bus_2 = B*w2
/// H_bus_3 = C*w3
/// x_axle_base_in_S_1 = T*sqrt(3)
/// x_S_1 = 3*w2*H_bus_3 - 3*w3*H_bus_2 + x_axle_base_in_S_1
/// H_bus_1 = A*w1
/// x_S_2 = x_axle_base_in_S_1 - 3*w1*H_bus_3 + 3*w3*H_bus_1
/// x_S_3 = 3*w1*H_bus_2 + x_axle_base_in_S_1 - 3*w2*H_bus_1
/// w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
/// w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
/// w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
/// w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
/// w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
/// w_W_turn1_3 = 3*s + w_S_in_axle_base_3
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) - s*w_axle_base_in_W_turn1_1*sin(phi)
/// x_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 + K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
///     3*alpha_W_turn1_in_axle_base_1)
/// H_wheel_1 = K*w_S_in_axle_base_1
/// alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) + s*w_axle_base_in_W_turn1_2*sin(phi)
/// x_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 + K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
///     3*alpha_W_turn1_in_axle_base_2)
/// x_axle_base_3 = 9*T - w_S_in_axle_base_1*H_wheel_2 + w_S_in_axle_base_2*H_wheel_1
/// f1 = -x_S_1/3
/// f2 = -x_S_2/3
/// f3 = -x_S_3/3
/// f4 = x_axle_base_1/9
/// f5 = x_axle_base_2/9
/// f6 = x_axle_base_3/9
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (w1', w2', w3', s'), solved for when this code was generated.
///
/// ```text
/// H_bus_2 = B*w2
/// H_bus_3 = C*w3
/// x_axle_base_in_S_1 = T*sqrt(3)
/// x_S_1 = 3*w2*H_bus_3 - 3*w3*H_bus_2 + x_axle_base_in_S_1
/// H_bus_1 = A*w1
/// x_S_2 = x_axle_base_in_S_1 - 3*w1*H_bus_3 + 3*w3*H_bus_1
/// x_S_3 = 3*w1*H_bus_2 + x_axle_base_in_S_1 - 3*w2*H_bus_1
/// w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
/// w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
/// w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
/// w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
/// w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
/// w_W_turn1_3 = 3*s + w_S_in_axle_base_3
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) - s*w_axle_base_in_W_turn1_1*sin(phi)
/// x_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 + K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
///     3*alpha_W_turn1_in_axle_base_1)
/// H_wheel_1 = K*w_S_in_axle_base_1
/// alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) + s*w_axle_base_in_W_turn1_2*sin(phi)
/// x_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 + K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
///     3*alpha_W_turn1_in_axle_base_2)
/// x_axle_base_3 = 9*T - w_S_in_axle_base_1*H_wheel_2 + w_S_in_axle_base_2*H_wheel_1
/// x_axle_base_in_S_1_2 = 1/(3 + sqrt(3)) - 1
/// x_axle_base_in_S_1_3 = 1/(3 + sqrt(3))
/// x_axle_base_1_2 = K*x_axle_base_in_S_1_2
/// x_axle_base_1_3 = K*x_axle_base_in_S_1_3
/// x_axle_base_1_4 = K*sqrt(3)
/// x_axle_base_3_2 = J*sqrt(3)
/// w3' = (x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*(3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3)/(A +
///     x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - 9*x_S_3 - sqrt(3)*(x_axle_base_1 + x_axle_base_2) -
///     x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A +
///     x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(3*x_S_2 + x_axle_base_2*x_axle_base_in_S_1_2 +
///     x_axle_base_1*x_axle_base_in_S_1_3 - (3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
///     x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))/(B +
///     x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A
///     + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3)))/(3*(9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
///     x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
///     x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A +
///     x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 - x_axle_base_in_S_1_3*x_axle_base_1_3)
///     + x_axle_base_1_4*(2*sqrt(3) - x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
///     x_axle_base_in_S_1_3*x_axle_base_1_3))))
/// w2' = (3*x_S_2 + x_axle_base_2*x_axle_base_in_S_1_2 + x_axle_base_1*x_axle_base_in_S_1_3 - (3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 +
///     x_axle_base_2*x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
///     x_axle_base_in_S_1_3*x_axle_base_1_3) + 3*w3'*x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*(1 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
///     x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
///     x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*((x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A +
///     x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 - x_axle_base_in_S_1_3*x_axle_base_1_3))
/// w1' = -(3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3 + 9*w2'*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
///     x_axle_base_in_S_1_2*x_axle_base_1_3) + 3*w3'*x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3))/(9*(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
///     x_axle_base_in_S_1_3*x_axle_base_1_3))
/// s' = (x_axle_base_3 - 3*x_axle_base_3_2*(w1' + w2' + w3'))/(9*J)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;

/// Kinetic energy T.
///
/// ```text
/// H_bus_2 = B*w2
/// H_bus_3 = C*w3
/// H_bus_1 = A*w1
/// w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
/// w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
/// w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
/// w_W_turn1_3 = 3*s + w_S_in_axle_base_3
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// H_wheel_1 = K*w_S_in_axle_base_1
/// T = w2*H_bus_2/2 + w3*H_bus_3/2 + w1*H_bus_1/2 + w_S_in_axle_base_2*H_wheel_2/18 + w_W_turn1_3*H_wheel_3/18 + w_S_in_axle_base_1*H_wheel_1/18
/// ```
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;
