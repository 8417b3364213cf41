//! Satellite with a reaction wheel: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (w1', w2', w3', s').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by 3 + sqrt(3), by J, by 3*C + 2*K, by 3*B*C + K*(2*B + 2*C + K), by K_w3_dot, by D_w2_dot, by D_w1_dot.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, derivative, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows w1, w2, w3, s.
///
/// ```text
/// H_wheel_1_2 = K*sqrt(3)
/// H_wheel_3_2 = J*sqrt(3)
/// M11 = A + J/3 + 2*K/3
/// M12 = J/3 - K/3
/// M13 = J/3 - K/3
/// M14 = J*sqrt(3)/3
/// M22 = B + J/3 + 2*K/3
/// M23 = J/3 - K/3
/// M24 = J*sqrt(3)/3
/// M33 = C + sqrt(3)*(2*H_wheel_1_2 + H_wheel_3_2)/9
/// M34 = J*sqrt(3)/3
/// M44 = J
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (w1', w2', w3', s').
///
/// ```text
/// w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
/// w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
/// w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
/// w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
/// w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
/// w_W_turn1_3 = 3*s + w_S_in_axle_base_3
/// H_bus_1 = A*w1
/// H_bus_2 = B*w2
/// H_wheel_1 = K*w_S_in_axle_base_1
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) - s*w_axle_base_in_W_turn1_1*sin(phi)
/// alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) + s*w_axle_base_in_W_turn1_2*sin(phi)
/// F_w_W_turn1_3 = 9*T + w_S_in_axle_base_2*H_wheel_1 - w_S_in_axle_base_1*H_wheel_2
/// F_w_S_in_axle_base_3 = 9*T - F_w_W_turn1_3
/// F_w_S_in_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 + K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
///     3*alpha_W_turn1_in_axle_base_2)
/// F_w_S_in_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 + K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
///     3*alpha_W_turn1_in_axle_base_1)
/// f1 = w2*(K*(w1 + w2) - 3*w3*(C - B) - J*(w1 + w2 + s*sqrt(3)))/3 + w3*(J*(w1 + w3 + s*sqrt(3)) - K*(w1 + w3))/3
/// f2 = w1*(3*w3*(C - A) - K*(w1 + w2) + J*(w1 + w2 + s*sqrt(3)))/3 + w3*(K*(w2 + w3) - J*(w2 + w3 + s*sqrt(3)))/3
/// f3 = w2*H_bus_1 - w1*H_bus_2 - sqrt(3)*(F_w_S_in_axle_base_3 + F_w_S_in_axle_base_2 + F_w_S_in_axle_base_1)/27
/// f4 = F_w_W_turn1_3/9
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (w1', w2', w3', s'), solved for when this code was generated.
///
/// ```text
/// w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
/// w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
/// w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
/// w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
/// w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
/// w_W_turn1_3 = 3*s + w_S_in_axle_base_3
/// H_bus_1 = A*w1
/// H_bus_2 = B*w2
/// H_bus_3 = C*w3
/// H_wheel_1 = K*w_S_in_axle_base_1
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) - s*w_axle_base_in_W_turn1_1*sin(phi)
/// alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) + s*w_axle_base_in_W_turn1_2*sin(phi)
/// b_alpha_W_3 = w_S_in_axle_base_1*H_wheel_2 - w_S_in_axle_base_2*H_wheel_1
/// b_s_dot = 9*T - b_alpha_W_3
/// over_D_s_dot = 1/J
/// G_s_dot = J*over_D_s_dot
/// b_alpha_W_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*(K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3)
/// b = b_alpha_W_2 - 3*K*alpha_W_turn1_in_axle_base_2
/// b_alpha_W_1 = w_S_in_axle_base_3*H_wheel_2 - w_S_in_axle_base_2*(K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3)
/// b_2 = 3*K*alpha_W_turn1_in_axle_base_1 + b_alpha_W_1
/// b_alpha_S_in_axle_base_3 = b_alpha_W_3 + b_s_dot*G_s_dot
/// K_alpha_S_in_axle_base_3 = J*(G_s_dot - 1)
/// b_w3_dot = 27*w1*H_bus_2 - 27*w2*H_bus_1 + sqrt(3)*(b - b_2 + b_alpha_S_in_axle_base_3)
/// K_w3_dot = 3*C + 2*K - K_alpha_S_in_axle_base_3
/// over_D_w3_dot = 1/K_w3_dot
/// G_w3_dot = K*over_D_w3_dot
/// b_w2_dot = 54*w3*H_bus_1 - 54*w1*H_bus_3 - 3*b - 3*b_2 + sqrt(3)*(b_2 - b + 2*b_alpha_S_in_axle_base_3) + 2*b_w3_dot*G_w3_dot
/// K_w2_dot = K*(C + K)/(3*C + 2*K)
/// D_w2_dot = (3*B*C + K*(2*B + 2*C + K))/(3*C + 2*K)
/// over_D_w2_dot = 1/D_w2_dot
/// G_w2_dot = K_w2_dot*over_D_w2_dot
/// b_w1_dot = 54*w2*H_bus_3 - 54*w3*H_bus_2 + 3*b + 3*b_2 + sqrt(3)*(b_2 - b + 2*b_alpha_S_in_axle_base_3) + 2*b_w3_dot*G_w3_dot + b_w2_dot*G_w2_dot
/// D_w1_dot = (3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K)))/(3*B*C + K*(2*B + 2*C + K))
/// over_D_w1_dot = 1/D_w1_dot
/// G_w1_dot = b_w1_dot*over_D_w1_dot
/// w1' = -G_w1_dot/54
/// G_w2_dot_2 = b_w2_dot*over_D_w2_dot
/// w2' = w1'*G_w2_dot - G_w2_dot_2/54
/// G_w3_dot_2 = b_w3_dot*over_D_w3_dot
/// w3' = w1'*G_w3_dot + w2'*G_w3_dot - G_w3_dot_2/9
/// alpha_S_in_axle_base_3 = w1'*sqrt(3) + w2'*sqrt(3) + w3'*sqrt(3)
/// G_s_dot_2 = b_s_dot*over_D_s_dot
/// s' = G_s_dot_2/9 - alpha_S_in_axle_base_3*G_s_dot/3
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// e0' = -e1*w1/2 - e2*w2/2 - e3*w3/2
/// e1' = e0*w1/2 - e3*w2/2 + e2*w3/2
/// e2' = e3*w1/2 + e0*w2/2 - e1*w3/2
/// e3' = e1*w2/2 - e2*w1/2 + e0*w3/2
/// phi' = s
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
/// w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
/// w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
/// w_W_turn1_3 = 3*s + w_S_in_axle_base_3
/// H_bus_1 = A*w1
/// H_bus_2 = B*w2
/// H_wheel_1 = K*w_S_in_axle_base_1
/// H_wheel_2 = K*w_S_in_axle_base_2
/// H_wheel_3 = J*w_W_turn1_3
/// H_bus_3 = C*w3
/// T = w1*H_bus_1/2 + w2*H_bus_2/2 + w_S_in_axle_base_1*H_wheel_1/18 + w_S_in_axle_base_2*H_wheel_2/18 + w_W_turn1_3*H_wheel_3/18 + w3*H_bus_3/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = -T*phi
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
