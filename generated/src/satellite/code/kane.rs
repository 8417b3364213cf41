//! Satellite with a reaction wheel: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows w1, w2, w3, s.
///
/// 15 operations, 1 other function.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 5],
    _u: &[S; 4],
) -> [[S; 4]; 4] {
    let Parameters { A, B, C, J, K, .. } = *p;
    // Elimination, step by step, each after the terms that it shares.
    let H_wheel_1_2_of_ = (S::int(3)).sqrt();
    // H_wheel_1_2 = K*sqrt(3)
    let H_wheel_1_2 = K * H_wheel_1_2_of_;
    // H_wheel_3_2 = J*sqrt(3)
    let H_wheel_3_2 = J * H_wheel_1_2_of_;
    let j_by_3 = S::ratio(1, 3) * J;
    let k_times_2_by_3 = S::ratio(2, 3) * K;
    // j_by_3 + k_times_2_by_3
    let m11_of_j_k = j_by_3 + k_times_2_by_3;
    let k_by_3 = S::ratio(1, 3) * K;
    // j_by_3 - k_by_3
    let j_by_3_minus_k_by_3 = j_by_3 - k_by_3;
    let m14_of_j = j_by_3 * H_wheel_1_2_of_;
    // Entries that are not zero; upper triangle.
    // M11 = A + J/3 + 2*K/3
    let m11 = A + m11_of_j_k;
    // M12 = J/3 - K/3
    let m12 = j_by_3_minus_k_by_3;
    // M13 = J/3 - K/3
    let m13 = j_by_3_minus_k_by_3;
    // M14 = J*sqrt(3)/3
    let m14 = m14_of_j;
    // M22 = B + J/3 + 2*K/3
    let m22 = B + m11_of_j_k;
    // M23 = J/3 - K/3
    let m23 = j_by_3_minus_k_by_3;
    // M24 = J*sqrt(3)/3
    let m24 = m14_of_j;
    // M33 = C + sqrt(3)*(2*H_wheel_1_2 + H_wheel_3_2)/9
    let m33 = C + S::ratio(1, 9) * H_wheel_1_2_of_ * H_wheel_1_2.mul_add(S::int(2), H_wheel_3_2);
    // M34 = J*sqrt(3)/3
    let m34 = m14_of_j;
    // M44 = J
    let m44 = J;
    [
        [m11, m12, m13, m14],
        [m12, m22, m23, m24],
        [m13, m23, m33, m34],
        [m14, m24, m34, m44],
    ]
}

/// Right-hand side of the linear system; unknowns (w1', w2', w3', s').
///
/// 88 operations, 1 sine and cosine, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [S; 4] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w1 + w2
    let w1_plus_w2 = w1 + w2;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // 3*w1_plus_w2/(3 + sqrt(3)) + w_S_in_axle_base_1_of_w3
    let w_S_in_axle_base_1_of_w1_w2_w3 = S::int(3) * w1_plus_w2
        / (S::int(3) + w_S_in_axle_base_1_of_) + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = (-w1).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = (-w2).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w1_plus_w2
        .mul_add(w_S_in_axle_base_1_of_, w_S_in_axle_base_1_of_w3);
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    let s_cos_phi = s * cos_phi;
    let s_sin_phi = s * sin_phi;
    // alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) -
    //   s*w_axle_base_in_W_turn1_1*sin(phi)
    let alpha_W_turn1_in_axle_base_1 = (-w_axle_base_in_W_turn1_1)
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_2 * s_cos_phi);
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    let t_times_9 = S::int(9) * T;
    // F_w_W_turn1_3 = 9*T + w_S_in_axle_base_2*H_wheel_1 - w_S_in_axle_base_1*H_wheel_2
    let F_w_W_turn1_3 = (-w_S_in_axle_base_1)
        .mul_add(H_wheel_2, w_S_in_axle_base_2 * H_wheel_1) + t_times_9;
    // F_w_S_in_axle_base_3 = 9*T - F_w_W_turn1_3
    let F_w_S_in_axle_base_3 = t_times_9 - F_w_W_turn1_3;
    // K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3
    let F_w_S_in_axle_base_2_of_place = K * (w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3;
    let k_times_3 = S::int(3) * K;
    // F_w_S_in_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 +
    //   K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
    //   3*alpha_W_turn1_in_axle_base_2)
    let F_w_S_in_axle_base_2 = (-w_S_in_axle_base_1)
        .mul_add(F_w_S_in_axle_base_2_of_place, w_S_in_axle_base_3 * H_wheel_1)
        - alpha_W_turn1_in_axle_base_2 * k_times_3;
    // F_w_S_in_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 +
    //   K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
    //   3*alpha_W_turn1_in_axle_base_1)
    let F_w_S_in_axle_base_1 = (-w_S_in_axle_base_3)
        .mul_add(H_wheel_2, w_S_in_axle_base_2 * F_w_S_in_axle_base_2_of_place)
        - alpha_W_turn1_in_axle_base_1 * k_times_3;
    let w3_by_3 = S::ratio(1, 3) * w3;
    // K - J
    let minus_j_plus_k = K - J;
    let f1_of_s = J * s * w_S_in_axle_base_1_of_;
    // f1_of_s - w3*minus_j_plus_k
    let f1_of_w3_s = (-w3).mul_add(minus_j_plus_k, f1_of_s);
    // f1_of_s - w1_plus_w2*minus_j_plus_k
    let f1_of_w1_w2_s = (-w1_plus_w2).mul_add(minus_j_plus_k, f1_of_s);
    // 3*C*w3 + f1_of_w1_w2_s
    let f1_of_w1_w2_w3_s = (C * w3).mul_add(S::int(3), f1_of_w1_w2_s);
    let f1_of_w1_w2_w3_s_by_3 = S::ratio(1, 3) * f1_of_w1_w2_w3_s;
    // F_w_S_in_axle_base_3 + F_w_S_in_axle_base_2
    let f3_of_place = F_w_S_in_axle_base_3 + F_w_S_in_axle_base_2;
    // Values.
    // f1 = w2*(K*(w1 + w2) - 3*w3*(C - B) - J*(w1 + w2 + s*sqrt(3)))/3 + w3*(J*(w1 + w3 + s*sqrt(3)) -
    //   K*(w1 + w3))/3
    let f1 = w3_by_3 * (-w1).mul_add(minus_j_plus_k, f1_of_w3_s) + w3 * H_bus_2
        - w2 * f1_of_w1_w2_w3_s_by_3;
    // f2 = w1*(3*w3*(C - A) - K*(w1 + w2) + J*(w1 + w2 + s*sqrt(3)))/3 + w3*(K*(w2 + w3) - J*(w2 + w3 +
    //   s*sqrt(3)))/3
    let f2 = w3_by_3 * w2.mul_add(minus_j_plus_k, -f1_of_w3_s) - w3 * H_bus_1
        + w1 * f1_of_w1_w2_w3_s_by_3;
    // f3 = w2*H_bus_1 - w1*H_bus_2 - sqrt(3)*(F_w_S_in_axle_base_3 + F_w_S_in_axle_base_2 +
    //   F_w_S_in_axle_base_1)/27
    let f3 = w2 * H_bus_1 - w1 * H_bus_2
        - S::ratio(1, 27) * w_S_in_axle_base_1_of_ * (F_w_S_in_axle_base_1 + f3_of_place);
    // f4 = F_w_W_turn1_3/9
    let f4 = S::ratio(1, 9) * F_w_W_turn1_3;
    [f1, f2, f3, f4]
}

/// The accelerations (w1', w2', w3', s'), solved for when this code was generated.
///
/// 138 operations, 1 sine and cosine, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [S; 4] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w1 + w2
    let w1_plus_w2 = w1 + w2;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // 3*w1_plus_w2/(3 + sqrt(3)) + w_S_in_axle_base_1_of_w3
    let w_S_in_axle_base_1_of_w1_w2_w3 = S::int(3) * w1_plus_w2
        / (S::int(3) + w_S_in_axle_base_1_of_) + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = (-w1).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = (-w2).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w1_plus_w2
        .mul_add(w_S_in_axle_base_1_of_, w_S_in_axle_base_1_of_w3);
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    let s_cos_phi = s * cos_phi;
    let s_sin_phi = s * sin_phi;
    // alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) -
    //   s*w_axle_base_in_W_turn1_1*sin(phi)
    let alpha_W_turn1_in_axle_base_1 = (-w_axle_base_in_W_turn1_1)
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_2 * s_cos_phi);
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    // b_alpha_W_3 = w_S_in_axle_base_1*H_wheel_2 - w_S_in_axle_base_2*H_wheel_1
    let b_alpha_W_3 = (-w_S_in_axle_base_2)
        .mul_add(H_wheel_1, w_S_in_axle_base_1 * H_wheel_2);
    // b_s_dot = 9*T - b_alpha_W_3
    let b_s_dot = T.mul_add(S::int(9), -b_alpha_W_3);
    // over_D_s_dot = 1/J
    let over_D_s_dot = S::int(1) / J;
    // G_s_dot = J*over_D_s_dot
    let G_s_dot = J * over_D_s_dot;
    // K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3
    let b_alpha_W_2_of_place = K * (w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3;
    // b_alpha_W_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*(K*(w_S_in_axle_base_3 -
    //   w_W_turn1_3) + H_wheel_3)
    let b_alpha_W_2 = (-w_S_in_axle_base_1)
        .mul_add(b_alpha_W_2_of_place, w_S_in_axle_base_3 * H_wheel_1);
    let k_times_3 = S::int(3) * K;
    // b = b_alpha_W_2 - 3*K*alpha_W_turn1_in_axle_base_2
    let b = (-alpha_W_turn1_in_axle_base_2).mul_add(k_times_3, b_alpha_W_2);
    // b_alpha_W_1 = w_S_in_axle_base_3*H_wheel_2 - w_S_in_axle_base_2*(K*(w_S_in_axle_base_3 -
    //   w_W_turn1_3) + H_wheel_3)
    let b_alpha_W_1 = (-w_S_in_axle_base_2)
        .mul_add(b_alpha_W_2_of_place, w_S_in_axle_base_3 * H_wheel_2);
    // b_2 = 3*K*alpha_W_turn1_in_axle_base_1 + b_alpha_W_1
    let b_2 = alpha_W_turn1_in_axle_base_1.mul_add(k_times_3, b_alpha_W_1);
    // b_alpha_S_in_axle_base_3 = b_alpha_W_3 + b_s_dot*G_s_dot
    let b_alpha_S_in_axle_base_3 = b_s_dot.mul_add(G_s_dot, b_alpha_W_3);
    // K_alpha_S_in_axle_base_3 = J*(G_s_dot - 1)
    let K_alpha_S_in_axle_base_3 = J.mul_add(G_s_dot, -J);
    let b_w3_dot_of_place = b_alpha_S_in_axle_base_3 * w_S_in_axle_base_1_of_;
    // sqrt(3)*(b - b_2)
    let b_w3_dot_of_b_b_2 = w_S_in_axle_base_1_of_ * (b - b_2);
    // w1*H_bus_2 - w2*H_bus_1
    let b_w3_dot_of_w1_w2 = (-w2).mul_add(H_bus_1, w1 * H_bus_2);
    // b_w3_dot = 27*w1*H_bus_2 - 27*w2*H_bus_1 + sqrt(3)*(b - b_2 + b_alpha_S_in_axle_base_3)
    let b_w3_dot = b_w3_dot_of_w1_w2
        .mul_add(S::int(27), b_w3_dot_of_place + b_w3_dot_of_b_b_2);
    let c_times_3 = S::int(3) * C;
    // 2*K + c_times_3
    let k_doubled_plus_c_times_3 = K.mul_add(S::int(2), c_times_3);
    // K_w3_dot = 3*C + 2*K - K_alpha_S_in_axle_base_3
    let K_w3_dot = k_doubled_plus_c_times_3 - K_alpha_S_in_axle_base_3;
    // over_D_w3_dot = 1/K_w3_dot
    let over_D_w3_dot = S::int(1) / K_w3_dot;
    // G_w3_dot = K*over_D_w3_dot
    let G_w3_dot = K * over_D_w3_dot;
    // b_w3_dot*G_w3_dot + b_w3_dot_of_place
    let b_w2_dot_of_place = b_w3_dot.mul_add(G_w3_dot, b_w3_dot_of_place);
    // b_w3_dot_of_b_b_2 - 2*b_w2_dot_of_place
    let b_w2_dot_of_place_2 = (-b_w2_dot_of_place).mul_add(S::int(2), b_w3_dot_of_b_b_2);
    let w3_times_54 = S::int(54) * w3;
    let h_bus_3_times_54 = S::int(54) * H_bus_3;
    // b + b_2
    let b_plus_b_2 = b + b_2;
    let b_plus_b_2_times_3 = S::int(3) * b_plus_b_2;
    // b_w2_dot = 54*w3*H_bus_1 - 54*w1*H_bus_3 - 3*b - 3*b_2 + sqrt(3)*(b_2 - b +
    //   2*b_alpha_S_in_axle_base_3) + 2*b_w3_dot*G_w3_dot
    let b_w2_dot = H_bus_1.mul_add(w3_times_54, -b_w2_dot_of_place_2)
        - w1 * h_bus_3_times_54 - b_plus_b_2_times_3;
    let K_w2_dot_of_c_k = S::int(1) / k_doubled_plus_c_times_3;
    // K_w2_dot = K*(C + K)/(3*C + 2*K)
    let K_w2_dot = K * K_w2_dot_of_c_k * (C + K);
    // 2*C + K
    let c_doubled_plus_k = C.mul_add(S::int(2), K);
    // B*k_doubled_plus_c_times_3 + K*c_doubled_plus_k
    let D_w2_dot_of_b_c_k = K.mul_add(c_doubled_plus_k, B * k_doubled_plus_c_times_3);
    // D_w2_dot = (3*B*C + K*(2*B + 2*C + K))/(3*C + 2*K)
    let D_w2_dot = K_w2_dot_of_c_k * D_w2_dot_of_b_c_k;
    // over_D_w2_dot = 1/D_w2_dot
    let over_D_w2_dot = S::int(1) / D_w2_dot;
    // G_w2_dot = K_w2_dot*over_D_w2_dot
    let G_w2_dot = K_w2_dot * over_D_w2_dot;
    // b_w1_dot = 54*w2*H_bus_3 - 54*w3*H_bus_2 + 3*b + 3*b_2 + sqrt(3)*(b_2 - b +
    //   2*b_alpha_S_in_axle_base_3) + 2*b_w3_dot*G_w3_dot + b_w2_dot*G_w2_dot
    let b_w1_dot = b_w2_dot.mul_add(G_w2_dot, -b_w2_dot_of_place_2)
        - H_bus_2 * w3_times_54 + w2 * h_bus_3_times_54 + b_plus_b_2_times_3;
    // D_w1_dot = (3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K)))/(3*B*C + K*(2*B + 2*C + K))
    let D_w1_dot = (K * B.mul_add(c_doubled_plus_k, C * K) + A * D_w2_dot_of_b_c_k)
        / (K * B.mul_add(S::int(2), c_doubled_plus_k) + B * c_times_3);
    // over_D_w1_dot = 1/D_w1_dot
    let over_D_w1_dot = S::int(1) / D_w1_dot;
    // G_w1_dot = b_w1_dot*over_D_w1_dot
    let G_w1_dot = b_w1_dot * over_D_w1_dot;
    // w1' = -G_w1_dot/54
    let w1_dot = -S::ratio(1, 54) * G_w1_dot;
    // G_w2_dot_2 = b_w2_dot*over_D_w2_dot
    let G_w2_dot_2 = b_w2_dot * over_D_w2_dot;
    // w2' = w1'*G_w2_dot - G_w2_dot_2/54
    let w2_dot = w1_dot.mul_add(G_w2_dot, -S::ratio(1, 54) * G_w2_dot_2);
    // G_w3_dot_2 = b_w3_dot*over_D_w3_dot
    let G_w3_dot_2 = b_w3_dot * over_D_w3_dot;
    // w1' + w2'
    let w1_dot_plus_w2_dot = w1_dot + w2_dot;
    // w3' = w1'*G_w3_dot + w2'*G_w3_dot - G_w3_dot_2/9
    let w3_dot = G_w3_dot.mul_add(w1_dot_plus_w2_dot, -S::ratio(1, 9) * G_w3_dot_2);
    // alpha_S_in_axle_base_3 = w1'*sqrt(3) + w2'*sqrt(3) + w3'*sqrt(3)
    let alpha_S_in_axle_base_3 = w_S_in_axle_base_1_of_ * (w3_dot + w1_dot_plus_w2_dot);
    // G_s_dot_2 = b_s_dot*over_D_s_dot
    let G_s_dot_2 = b_s_dot * over_D_s_dot;
    // s' = G_s_dot_2/9 - alpha_S_in_axle_base_3*G_s_dot/3
    let s_dot = S::ratio(1, 9) * G_s_dot_2 - S::ratio(1, 3) * alpha_S_in_axle_base_3 * G_s_dot;
    [w1_dot, w2_dot, w3_dot, s_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 24 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 4],
) -> [S; 5] {
    let [e0, e1, e2, e3, _] = *q;
    let [w1, w2, w3, s] = *u;
    // Shared terms.
    let w1_halved = S::ratio(1, 2) * w1;
    let w2_halved = S::ratio(1, 2) * w2;
    let w3_halved = S::ratio(1, 2) * w3;
    // Values.
    // e0' = -e1*w1/2 - e2*w2/2 - e3*w3/2
    let e0_dot_value = (-e2).mul_add(w2_halved, -e1 * w1_halved) - e3 * w3_halved;
    // e1' = e0*w1/2 - e3*w2/2 + e2*w3/2
    let e1_dot_value = (-e3).mul_add(w2_halved, e0 * w1_halved) + e2 * w3_halved;
    // e2' = e3*w1/2 + e0*w2/2 - e1*w3/2
    let e2_dot_value = e0.mul_add(w2_halved, e3 * w1_halved) - e1 * w3_halved;
    // e3' = e1*w2/2 - e2*w1/2 + e0*w3/2
    let e3_dot_value = (-e2).mul_add(w1_halved, e1 * w2_halved) + e0 * w3_halved;
    // phi' = s
    let phi_dot_value = s;
    [e0_dot_value, e1_dot_value, e2_dot_value, e3_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 33 operations, 1 other function.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 5], u: &[S; 4]) -> S {
    let Parameters { A, B, C, J, K, .. } = *p;
    let [w1, w2, w3, s] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // w1 + w2
    let w1_plus_w2 = w1 + w2;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // 3*w1_plus_w2/(3 + sqrt(3)) + w_S_in_axle_base_1_of_w3
    let w_S_in_axle_base_1_of_w1_w2_w3 = S::int(3) * w1_plus_w2
        / (S::int(3) + w_S_in_axle_base_1_of_) + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = (-w1).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = (-w2).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w1_plus_w2
        .mul_add(w_S_in_axle_base_1_of_, w_S_in_axle_base_1_of_w3);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    // w1*H_bus_1 + w2*H_bus_2
    let energy_of_w1_w2 = w2.mul_add(H_bus_2, w1 * H_bus_1);
    // w_S_in_axle_base_1*H_wheel_1 + w_S_in_axle_base_2*H_wheel_2
    let energy_of_place = w_S_in_axle_base_2
        .mul_add(H_wheel_2, w_S_in_axle_base_1 * H_wheel_1);
    // w3*H_bus_3 + energy_of_w1_w2
    let energy_of_w1_w2_w3 = w3.mul_add(H_bus_3, energy_of_w1_w2);
    // w_W_turn1_3*H_wheel_3 + energy_of_place
    let energy_of_place_2 = w_W_turn1_3.mul_add(H_wheel_3, energy_of_place);
    // Values.
    // T = w1*H_bus_1/2 + w2*H_bus_2/2 + w_S_in_axle_base_1*H_wheel_1/18 + w_S_in_axle_base_2*H_wheel_2/18
    //   + w_W_turn1_3*H_wheel_3/18 + w3*H_bus_3/2
    let energy = S::ratio(1, 2) * energy_of_w1_w2_w3 + S::ratio(1, 18) * energy_of_place_2;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 2 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    // Values.
    // V = -T*phi
    let energy = -T * phi;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 162 operations, 1 sine and cosine, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 4],
) -> ([S; 5], [S; 4]) {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0, e1, e2, e3, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w1 + w2
    let w1_plus_w2 = w1 + w2;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // 3*w1_plus_w2/(3 + sqrt(3)) + w_S_in_axle_base_1_of_w3
    let w_S_in_axle_base_1_of_w1_w2_w3 = S::int(3) * w1_plus_w2
        / (S::int(3) + w_S_in_axle_base_1_of_) + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = (-w1).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = (-w2).mul_add(S::int(3), w_S_in_axle_base_1_of_w1_w2_w3);
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w1_plus_w2
        .mul_add(w_S_in_axle_base_1_of_, w_S_in_axle_base_1_of_w3);
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    let s_cos_phi = s * cos_phi;
    let s_sin_phi = s * sin_phi;
    // alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) -
    //   s*w_axle_base_in_W_turn1_1*sin(phi)
    let alpha_W_turn1_in_axle_base_1 = (-w_axle_base_in_W_turn1_1)
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_2 * s_cos_phi);
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    // b_alpha_W_3 = w_S_in_axle_base_1*H_wheel_2 - w_S_in_axle_base_2*H_wheel_1
    let b_alpha_W_3 = (-w_S_in_axle_base_2)
        .mul_add(H_wheel_1, w_S_in_axle_base_1 * H_wheel_2);
    // b_s_dot = 9*T - b_alpha_W_3
    let b_s_dot = T.mul_add(S::int(9), -b_alpha_W_3);
    // over_D_s_dot = 1/J
    let over_D_s_dot = S::int(1) / J;
    // G_s_dot = J*over_D_s_dot
    let G_s_dot = J * over_D_s_dot;
    // K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3
    let b_alpha_W_2_of_place = K * (w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3;
    // b_alpha_W_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*(K*(w_S_in_axle_base_3 -
    //   w_W_turn1_3) + H_wheel_3)
    let b_alpha_W_2 = (-w_S_in_axle_base_1)
        .mul_add(b_alpha_W_2_of_place, w_S_in_axle_base_3 * H_wheel_1);
    let k_times_3 = S::int(3) * K;
    // b = b_alpha_W_2 - 3*K*alpha_W_turn1_in_axle_base_2
    let b = (-alpha_W_turn1_in_axle_base_2).mul_add(k_times_3, b_alpha_W_2);
    // b_alpha_W_1 = w_S_in_axle_base_3*H_wheel_2 - w_S_in_axle_base_2*(K*(w_S_in_axle_base_3 -
    //   w_W_turn1_3) + H_wheel_3)
    let b_alpha_W_1 = (-w_S_in_axle_base_2)
        .mul_add(b_alpha_W_2_of_place, w_S_in_axle_base_3 * H_wheel_2);
    // b_2 = 3*K*alpha_W_turn1_in_axle_base_1 + b_alpha_W_1
    let b_2 = alpha_W_turn1_in_axle_base_1.mul_add(k_times_3, b_alpha_W_1);
    // b_alpha_S_in_axle_base_3 = b_alpha_W_3 + b_s_dot*G_s_dot
    let b_alpha_S_in_axle_base_3 = b_s_dot.mul_add(G_s_dot, b_alpha_W_3);
    // K_alpha_S_in_axle_base_3 = J*(G_s_dot - 1)
    let K_alpha_S_in_axle_base_3 = J.mul_add(G_s_dot, -J);
    let b_w3_dot_of_place = b_alpha_S_in_axle_base_3 * w_S_in_axle_base_1_of_;
    // sqrt(3)*(b - b_2)
    let b_w3_dot_of_b_b_2 = w_S_in_axle_base_1_of_ * (b - b_2);
    // w1*H_bus_2 - w2*H_bus_1
    let b_w3_dot_of_w1_w2 = (-w2).mul_add(H_bus_1, w1 * H_bus_2);
    // b_w3_dot = 27*w1*H_bus_2 - 27*w2*H_bus_1 + sqrt(3)*(b - b_2 + b_alpha_S_in_axle_base_3)
    let b_w3_dot = b_w3_dot_of_w1_w2
        .mul_add(S::int(27), b_w3_dot_of_place + b_w3_dot_of_b_b_2);
    let c_times_3 = S::int(3) * C;
    // 2*K + c_times_3
    let k_doubled_plus_c_times_3 = K.mul_add(S::int(2), c_times_3);
    // K_w3_dot = 3*C + 2*K - K_alpha_S_in_axle_base_3
    let K_w3_dot = k_doubled_plus_c_times_3 - K_alpha_S_in_axle_base_3;
    // over_D_w3_dot = 1/K_w3_dot
    let over_D_w3_dot = S::int(1) / K_w3_dot;
    // G_w3_dot = K*over_D_w3_dot
    let G_w3_dot = K * over_D_w3_dot;
    // b_w3_dot*G_w3_dot + b_w3_dot_of_place
    let b_w2_dot_of_place = b_w3_dot.mul_add(G_w3_dot, b_w3_dot_of_place);
    // b_w3_dot_of_b_b_2 - 2*b_w2_dot_of_place
    let b_w2_dot_of_place_2 = (-b_w2_dot_of_place).mul_add(S::int(2), b_w3_dot_of_b_b_2);
    let w3_times_54 = S::int(54) * w3;
    let h_bus_3_times_54 = S::int(54) * H_bus_3;
    // b + b_2
    let b_plus_b_2 = b + b_2;
    let b_plus_b_2_times_3 = S::int(3) * b_plus_b_2;
    // b_w2_dot = 54*w3*H_bus_1 - 54*w1*H_bus_3 - 3*b - 3*b_2 + sqrt(3)*(b_2 - b +
    //   2*b_alpha_S_in_axle_base_3) + 2*b_w3_dot*G_w3_dot
    let b_w2_dot = H_bus_1.mul_add(w3_times_54, -b_w2_dot_of_place_2)
        - w1 * h_bus_3_times_54 - b_plus_b_2_times_3;
    let K_w2_dot_of_c_k = S::int(1) / k_doubled_plus_c_times_3;
    // K_w2_dot = K*(C + K)/(3*C + 2*K)
    let K_w2_dot = K * K_w2_dot_of_c_k * (C + K);
    // 2*C + K
    let c_doubled_plus_k = C.mul_add(S::int(2), K);
    // B*k_doubled_plus_c_times_3 + K*c_doubled_plus_k
    let D_w2_dot_of_b_c_k = K.mul_add(c_doubled_plus_k, B * k_doubled_plus_c_times_3);
    // D_w2_dot = (3*B*C + K*(2*B + 2*C + K))/(3*C + 2*K)
    let D_w2_dot = K_w2_dot_of_c_k * D_w2_dot_of_b_c_k;
    // over_D_w2_dot = 1/D_w2_dot
    let over_D_w2_dot = S::int(1) / D_w2_dot;
    // G_w2_dot = K_w2_dot*over_D_w2_dot
    let G_w2_dot = K_w2_dot * over_D_w2_dot;
    // b_w1_dot = 54*w2*H_bus_3 - 54*w3*H_bus_2 + 3*b + 3*b_2 + sqrt(3)*(b_2 - b +
    //   2*b_alpha_S_in_axle_base_3) + 2*b_w3_dot*G_w3_dot + b_w2_dot*G_w2_dot
    let b_w1_dot = b_w2_dot.mul_add(G_w2_dot, -b_w2_dot_of_place_2)
        - H_bus_2 * w3_times_54 + w2 * h_bus_3_times_54 + b_plus_b_2_times_3;
    // D_w1_dot = (3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K)))/(3*B*C + K*(2*B + 2*C + K))
    let D_w1_dot = (K * B.mul_add(c_doubled_plus_k, C * K) + A * D_w2_dot_of_b_c_k)
        / (K * B.mul_add(S::int(2), c_doubled_plus_k) + B * c_times_3);
    // over_D_w1_dot = 1/D_w1_dot
    let over_D_w1_dot = S::int(1) / D_w1_dot;
    // G_w1_dot = b_w1_dot*over_D_w1_dot
    let G_w1_dot = b_w1_dot * over_D_w1_dot;
    // w1' = -G_w1_dot/54
    let w1_dot = -S::ratio(1, 54) * G_w1_dot;
    // G_w2_dot_2 = b_w2_dot*over_D_w2_dot
    let G_w2_dot_2 = b_w2_dot * over_D_w2_dot;
    // w2' = w1'*G_w2_dot - G_w2_dot_2/54
    let w2_dot = w1_dot.mul_add(G_w2_dot, -S::ratio(1, 54) * G_w2_dot_2);
    // G_w3_dot_2 = b_w3_dot*over_D_w3_dot
    let G_w3_dot_2 = b_w3_dot * over_D_w3_dot;
    // w1' + w2'
    let w1_dot_plus_w2_dot = w1_dot + w2_dot;
    // w3' = w1'*G_w3_dot + w2'*G_w3_dot - G_w3_dot_2/9
    let w3_dot = G_w3_dot.mul_add(w1_dot_plus_w2_dot, -S::ratio(1, 9) * G_w3_dot_2);
    // alpha_S_in_axle_base_3 = w1'*sqrt(3) + w2'*sqrt(3) + w3'*sqrt(3)
    let alpha_S_in_axle_base_3 = w_S_in_axle_base_1_of_ * (w3_dot + w1_dot_plus_w2_dot);
    // G_s_dot_2 = b_s_dot*over_D_s_dot
    let G_s_dot_2 = b_s_dot * over_D_s_dot;
    // s' = G_s_dot_2/9 - alpha_S_in_axle_base_3*G_s_dot/3
    let s_dot = S::ratio(1, 9) * G_s_dot_2 - S::ratio(1, 3) * alpha_S_in_axle_base_3 * G_s_dot;
    let w1_halved = S::ratio(1, 2) * w1;
    let w2_halved = S::ratio(1, 2) * w2;
    let w3_halved = S::ratio(1, 2) * w3;
    // Values.
    // e0' = -e1*w1/2 - e2*w2/2 - e3*w3/2
    let e0_dot_value = (-e2).mul_add(w2_halved, -e1 * w1_halved) - e3 * w3_halved;
    // e1' = e0*w1/2 - e3*w2/2 + e2*w3/2
    let e1_dot_value = (-e3).mul_add(w2_halved, e0 * w1_halved) + e2 * w3_halved;
    // e2' = e3*w1/2 + e0*w2/2 - e1*w3/2
    let e2_dot_value = e0.mul_add(w2_halved, e3 * w1_halved) - e1 * w3_halved;
    // e3' = e1*w2/2 - e2*w1/2 + e0*w3/2
    let e3_dot_value = (-e2).mul_add(w1_halved, e1 * w2_halved) + e0 * w3_halved;
    // phi' = s
    let phi_dot_value = s;
    (
        [e0_dot_value, e1_dot_value, e2_dot_value, e3_dot_value, phi_dot_value],
        [w1_dot, w2_dot, w3_dot, s_dot],
    )
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 8 operations.
#[must_use]
pub fn constraints<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 4]) -> [S; 1] {
    let [e0, e1, e2, e3, _] = *q;
    // Values.
    // S_norm = e0^2 - 1 + e1^2 + e2^2 + e3^2
    let residual1 = e0.mul_add(e0, -S::int(1)) + e1 * e1 + e2 * e2 + e3 * e3;
    [residual1]
}

/// Slopes of the constraints, one after the other, along e0, e1, e2, e3, phi, w1, w2, w3, s.
///
/// 4 operations.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 4],
) -> [S; 9] {
    let [e0, e1, e2, e3, _] = *q;
    // Values.
    // d(S_norm)/d(e0) = 2*e0
    let residual1_by_e0 = S::int(2) * e0;
    // d(S_norm)/d(e1) = 2*e1
    let residual1_by_e1 = S::int(2) * e1;
    // d(S_norm)/d(e2) = 2*e2
    let residual1_by_e2 = S::int(2) * e2;
    // d(S_norm)/d(e3) = 2*e3
    let residual1_by_e3 = S::int(2) * e3;
    let zero = S::int(0);
    [
        residual1_by_e0, residual1_by_e1, residual1_by_e2, residual1_by_e3, zero, zero, zero, zero,
        zero,
    ]
}

/// Inverse dynamics: the generalized forces along (w1, w2, w3, s) that must act beside the loads of the model for the accelerations to be (w1', w2', w3', s').
///
/// 113 operations, 1 sine and cosine, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 4],
    v_dot: &[S; 4],
) -> [S; 4] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    let [w1, w2, w3, s] = *u;
    let [w1_dot, w2_dot, w3_dot, s_dot] = *v_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    let w_S_in_axle_base_1_of__3 = S::int(3) * w_S_in_axle_base_1_of__2;
    // 1 - w_S_in_axle_base_1_of__2
    let w_S_in_axle_base_1_of__4 = S::int(1) - w_S_in_axle_base_1_of__2;
    let w_S_in_axle_base_1_of__5 = S::int(3) * w_S_in_axle_base_1_of__4;
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = (-w1)
        .mul_add(w_S_in_axle_base_1_of__5, w2 * w_S_in_axle_base_1_of__3)
        + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = (-w2)
        .mul_add(w_S_in_axle_base_1_of__5, w1 * w_S_in_axle_base_1_of__3)
        + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w_S_in_axle_base_1_of_ * (w1 + w2) + w_S_in_axle_base_1_of_w3;
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    let s_cos_phi = s * cos_phi;
    let s_sin_phi = s * sin_phi;
    // alpha_W_turn1_in_axle_base_1 = s*w_axle_base_in_W_turn1_2*cos(phi) -
    //   s*w_axle_base_in_W_turn1_1*sin(phi)
    let alpha_W_turn1_in_axle_base_1 = (-w_axle_base_in_W_turn1_1)
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_2 * s_cos_phi);
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    let alpha_S_in_axle_base_1_of_w3_dot = w3_dot * w_S_in_axle_base_1_of_;
    // alpha_S_in_axle_base_1 = 3*w1'*(1/(3 + sqrt(3)) - 1) + 3*w2'/(3 + sqrt(3)) + w3'*sqrt(3)
    let alpha_S_in_axle_base_1 = (-w1_dot)
        .mul_add(w_S_in_axle_base_1_of__5, w2_dot * w_S_in_axle_base_1_of__3)
        + alpha_S_in_axle_base_1_of_w3_dot;
    // alpha_S_in_axle_base_2 = 3*w1'/(3 + sqrt(3)) + 3*w2'*(1/(3 + sqrt(3)) - 1) + w3'*sqrt(3)
    let alpha_S_in_axle_base_2 = (-w2_dot)
        .mul_add(w_S_in_axle_base_1_of__5, w1_dot * w_S_in_axle_base_1_of__3)
        + alpha_S_in_axle_base_1_of_w3_dot;
    // alpha_S_in_axle_base_3 = w1'*sqrt(3) + w2'*sqrt(3) + w3'*sqrt(3)
    let alpha_S_in_axle_base_3 = w_S_in_axle_base_1_of_ * (w1_dot + w2_dot)
        + alpha_S_in_axle_base_1_of_w3_dot;
    // alpha_W_3 = 3*s' + alpha_S_in_axle_base_3
    let alpha_W_3 = s_dot.mul_add(S::int(3), alpha_S_in_axle_base_3);
    // alpha_W_1 = alpha_W_turn1_in_axle_base_1 - alpha_S_in_axle_base_1
    let alpha_W_1 = alpha_W_turn1_in_axle_base_1 - alpha_S_in_axle_base_1;
    // alpha_W_2 = alpha_W_turn1_in_axle_base_2 - alpha_S_in_axle_base_2
    let alpha_W_2 = alpha_W_turn1_in_axle_base_2 - alpha_S_in_axle_base_2;
    let t_times_9 = S::int(9) * T;
    // F_w_W_turn1_3_2 = 9*T + w_S_in_axle_base_2*H_wheel_1 - w_S_in_axle_base_1*H_wheel_2 - 3*J*alpha_W_3
    let F_w_W_turn1_3_2 = (-w_S_in_axle_base_1)
        .mul_add(H_wheel_2, w_S_in_axle_base_2 * H_wheel_1) - S::int(3) * J * alpha_W_3 + t_times_9;
    // F_w_S_in_axle_base_3_2 = 9*T - F_w_W_turn1_3_2
    let F_w_S_in_axle_base_3_2 = t_times_9 - F_w_W_turn1_3_2;
    // K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3
    let F_w_S_in_axle_base_2_2_of_place = K * (w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3;
    let k_times_3 = S::int(3) * K;
    // F_w_S_in_axle_base_2_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 +
    //   K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 - 3*alpha_W_2)
    let F_w_S_in_axle_base_2_2 = (-w_S_in_axle_base_1)
        .mul_add(F_w_S_in_axle_base_2_2_of_place, w_S_in_axle_base_3 * H_wheel_1)
        - alpha_W_2 * k_times_3;
    // F_w_S_in_axle_base_1_2 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 +
    //   K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 - 3*alpha_W_1)
    let F_w_S_in_axle_base_1_2 = (-w_S_in_axle_base_3)
        .mul_add(H_wheel_2, w_S_in_axle_base_2 * F_w_S_in_axle_base_2_2_of_place)
        - alpha_W_1 * k_times_3;
    let tau1_of_ = S::ratio(1, 27) * w_S_in_axle_base_1_of_;
    let tau1_of_place = F_w_S_in_axle_base_3_2 * tau1_of_;
    let tau1_of_place_2 = S::ratio(1, 9) * F_w_S_in_axle_base_1_2;
    let tau1_of_place_3 = S::ratio(1, 9) * F_w_S_in_axle_base_2_2;
    // Values.
    // tau1 = A*w1' - w3*H_bus_2 + w2*H_bus_3 + F_w_S_in_axle_base_3_2*sqrt(3)/27 +
    //   F_w_S_in_axle_base_2_2/(9*(3 + sqrt(3))) + F_w_S_in_axle_base_1_2*(1/(3 + sqrt(3)) - 1)/9
    let tau1 = (-w3).mul_add(H_bus_2, A * w1_dot) + w2 * H_bus_3 + tau1_of_place
        - w_S_in_axle_base_1_of__4 * tau1_of_place_2 + w_S_in_axle_base_1_of__2 * tau1_of_place_3;
    // tau2 = B*w2' + w3*H_bus_1 - w1*H_bus_3 + F_w_S_in_axle_base_3_2*sqrt(3)/27 +
    //   F_w_S_in_axle_base_2_2*(1/(3 + sqrt(3)) - 1)/9 + F_w_S_in_axle_base_1_2/(9*(3 + sqrt(3)))
    let tau2 = w3.mul_add(H_bus_1, B * w2_dot) - w1 * H_bus_3 + tau1_of_place
        + w_S_in_axle_base_1_of__2 * tau1_of_place_2 - w_S_in_axle_base_1_of__4 * tau1_of_place_3;
    // tau3 = C*w3' - w2*H_bus_1 + w1*H_bus_2 + F_w_S_in_axle_base_3_2*sqrt(3)/27 +
    //   F_w_S_in_axle_base_2_2*sqrt(3)/27 + F_w_S_in_axle_base_1_2*sqrt(3)/27
    let tau3 = C * w3_dot - w2 * H_bus_1 + w1 * H_bus_2
        + tau1_of_ * (F_w_S_in_axle_base_2_2 + F_w_S_in_axle_base_1_2) + tau1_of_place;
    // tau4 = -F_w_W_turn1_3_2/9
    let tau4 = -S::ratio(1, 9) * F_w_W_turn1_3_2;
    [tau1, tau2, tau3, tau4]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 4],
    direction: &[S; 9],
) -> [S; 9] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[5 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 8,
            coordinates: 5,
            variables: 4,
            speeds: 4,
            reactions: 0,
        }
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            mass_matrix(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&forcing(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn output_count(&self) -> usize {
        9
    }
    fn outputs(&self, p: &[S], _t: S, q: &[S], v: &[S], out: &mut [S]) {
        self.whole_state(p, q, v, out);
    }
    fn has_accelerations(&self) -> bool {
        true
    }
    fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                out
                    .copy_from_slice(
                        &accelerations(&Parameters::from_slice(p), array(q), array(v)),
                    )
            },
        );
    }
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                let (of_q, of_v) = derivative(
                    &Parameters::from_slice(p),
                    array(q),
                    array(v),
                );
                q_dot.copy_from_slice(&of_q);
                v_dot.copy_from_slice(&of_v);
            },
        );
    }
    fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        by_columns(
            out,
            |direction| jacobian_product(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                direction,
            ),
        );
    }
    fn constraint_count(&self) -> usize {
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["S_norm"][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn generalized_speeds(&self, _p: &[S], _q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(v);
    }
    fn generalized_speed_rates(
        &self,
        _p: &[S],
        _q: &[S],
        _v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(v_dot);
    }
    fn motion_variables(&self, _p: &[S], _q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(u);
    }
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S {
        kinetic_energy(&Parameters::from_slice(p), array(q), array(v))
    }
    fn potential_energy(&self, p: &[S], q: &[S]) -> S {
        potential_energy(&Parameters::from_slice(p), array(q))
    }
}

#[inline(always)]
fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that `System` requires")
}
