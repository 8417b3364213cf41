//! Satellite with a reaction wheel: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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
/// 142 operations, 1 sine and cosine, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [S; 4] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    let w_S_in_axle_base_1_of__3 = S::int(3) * w_S_in_axle_base_1_of__2;
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__4 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of__5 = S::int(3) * w_S_in_axle_base_1_of__4;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w2
        .mul_add(w_S_in_axle_base_1_of__3, w_S_in_axle_base_1_of_w3)
        + w1 * w_S_in_axle_base_1_of__5;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w1
        .mul_add(w_S_in_axle_base_1_of__3, w_S_in_axle_base_1_of_w3)
        + w2 * w_S_in_axle_base_1_of__5;
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
    let K_alpha_S_in_axle_base_3 = J * (G_s_dot - S::int(1));
    // b - b_2
    let b_minus_b_2 = b - b_2;
    let w1_times_27 = S::int(27) * w1;
    let w2_times_27 = S::int(27) * w2;
    // b_w3_dot = 27*w1*H_bus_2 - 27*w2*H_bus_1 + sqrt(3)*(b - b_2 + b_alpha_S_in_axle_base_3)
    let b_w3_dot = w_S_in_axle_base_1_of_ * (b_alpha_S_in_axle_base_3 + b_minus_b_2)
        + H_bus_2 * w1_times_27 - H_bus_1 * w2_times_27;
    let c_times_3 = S::int(3) * C;
    // 2*K + c_times_3
    let k_doubled_plus_c_times_3 = K.mul_add(S::int(2), c_times_3);
    // K_w3_dot = 3*C + 2*K - K_alpha_S_in_axle_base_3
    let K_w3_dot = k_doubled_plus_c_times_3 - K_alpha_S_in_axle_base_3;
    // over_D_w3_dot = 1/K_w3_dot
    let over_D_w3_dot = S::int(1) / K_w3_dot;
    // G_w3_dot = K*over_D_w3_dot
    let G_w3_dot = K * over_D_w3_dot;
    // b_alpha_S_in_axle_base_3*sqrt(3) + w_S_in_axle_base_1_of__3*b_minus_b_2
    let b_w2_dot_of_place = w_S_in_axle_base_1_of__3
        .mul_add(b_minus_b_2, b_alpha_S_in_axle_base_3 * w_S_in_axle_base_1_of_);
    // b_w3_dot*G_w3_dot + b_w2_dot_of_place
    let b_w2_dot_of_place_2 = b_w3_dot.mul_add(G_w3_dot, b_w2_dot_of_place);
    let w3_times_27 = S::int(27) * w3;
    // b_w2_dot = 27*w3*H_bus_1 - 27*w1*H_bus_3 - 3*b + 3*(b - b_2)/(3 + sqrt(3)) +
    //   b_alpha_S_in_axle_base_3*sqrt(3) + b_w3_dot*G_w3_dot
    let b_w2_dot = (-b).mul_add(S::int(3), b_w2_dot_of_place_2) - H_bus_3 * w1_times_27
        + H_bus_1 * w3_times_27;
    let K_w2_dot_of_c_k = S::int(1) / k_doubled_plus_c_times_3;
    // K_w2_dot = K*(C + K)/(3*C + 2*K)
    let K_w2_dot = K * K_w2_dot_of_c_k * (C + K);
    // 2*C + K
    let c_doubled_plus_k = C.mul_add(S::int(2), K);
    // 2*B + c_doubled_plus_k
    let D_w2_dot_of_b_c_k = B.mul_add(S::int(2), c_doubled_plus_k);
    let b_c_times_3 = B * c_times_3;
    // K*D_w2_dot_of_b_c_k + b_c_times_3
    let D_w2_dot_of_b_c_k_2 = K.mul_add(D_w2_dot_of_b_c_k, b_c_times_3);
    // D_w2_dot = (3*B*C + K*(2*B + 2*C + K))/(3*C + 2*K)
    let D_w2_dot = K_w2_dot_of_c_k * D_w2_dot_of_b_c_k_2;
    // over_D_w2_dot = 1/D_w2_dot
    let over_D_w2_dot = S::int(1) / D_w2_dot;
    // G_w2_dot = K_w2_dot*over_D_w2_dot
    let G_w2_dot = K_w2_dot * over_D_w2_dot;
    // b_w1_dot = 27*w2*H_bus_3 - 27*w3*H_bus_2 + 3*b_2 + 3*(b - b_2)/(3 + sqrt(3)) +
    //   b_alpha_S_in_axle_base_3*sqrt(3) + b_w3_dot*G_w3_dot + b_w2_dot*G_w2_dot
    let b_w1_dot = b_w2_dot.mul_add(G_w2_dot, S::int(3) * b_2) + H_bus_3 * w2_times_27
        + b_w2_dot_of_place_2 - H_bus_2 * w3_times_27;
    // D_w1_dot = (3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K)))/(3*B*C + K*(2*B + 2*C + K))
    let D_w1_dot = (K * (B.mul_add(c_doubled_plus_k, C * K) + A * D_w2_dot_of_b_c_k)
        + A * b_c_times_3) / D_w2_dot_of_b_c_k_2;
    // over_D_w1_dot = 1/D_w1_dot
    let over_D_w1_dot = S::int(1) / D_w1_dot;
    // G_w1_dot = b_w1_dot*over_D_w1_dot
    let G_w1_dot = b_w1_dot * over_D_w1_dot;
    // w1' = -G_w1_dot/27
    let w1_dot = -S::ratio(1, 27) * G_w1_dot;
    // G_w2_dot_2 = b_w2_dot*over_D_w2_dot
    let G_w2_dot_2 = b_w2_dot * over_D_w2_dot;
    // w2' = w1'*G_w2_dot - G_w2_dot_2/27
    let w2_dot = w1_dot.mul_add(G_w2_dot, -S::ratio(1, 27) * G_w2_dot_2);
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
/// 166 operations, 1 sine and cosine, 1 other function.
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
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    let w_S_in_axle_base_1_of__3 = S::int(3) * w_S_in_axle_base_1_of__2;
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__4 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of__5 = S::int(3) * w_S_in_axle_base_1_of__4;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w2
        .mul_add(w_S_in_axle_base_1_of__3, w_S_in_axle_base_1_of_w3)
        + w1 * w_S_in_axle_base_1_of__5;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w1
        .mul_add(w_S_in_axle_base_1_of__3, w_S_in_axle_base_1_of_w3)
        + w2 * w_S_in_axle_base_1_of__5;
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
    let K_alpha_S_in_axle_base_3 = J * (G_s_dot - S::int(1));
    // b - b_2
    let b_minus_b_2 = b - b_2;
    let w1_times_27 = S::int(27) * w1;
    let w2_times_27 = S::int(27) * w2;
    // b_w3_dot = 27*w1*H_bus_2 - 27*w2*H_bus_1 + sqrt(3)*(b - b_2 + b_alpha_S_in_axle_base_3)
    let b_w3_dot = w_S_in_axle_base_1_of_ * (b_alpha_S_in_axle_base_3 + b_minus_b_2)
        + H_bus_2 * w1_times_27 - H_bus_1 * w2_times_27;
    let c_times_3 = S::int(3) * C;
    // 2*K + c_times_3
    let k_doubled_plus_c_times_3 = K.mul_add(S::int(2), c_times_3);
    // K_w3_dot = 3*C + 2*K - K_alpha_S_in_axle_base_3
    let K_w3_dot = k_doubled_plus_c_times_3 - K_alpha_S_in_axle_base_3;
    // over_D_w3_dot = 1/K_w3_dot
    let over_D_w3_dot = S::int(1) / K_w3_dot;
    // G_w3_dot = K*over_D_w3_dot
    let G_w3_dot = K * over_D_w3_dot;
    // b_alpha_S_in_axle_base_3*sqrt(3) + w_S_in_axle_base_1_of__3*b_minus_b_2
    let b_w2_dot_of_place = w_S_in_axle_base_1_of__3
        .mul_add(b_minus_b_2, b_alpha_S_in_axle_base_3 * w_S_in_axle_base_1_of_);
    // b_w3_dot*G_w3_dot + b_w2_dot_of_place
    let b_w2_dot_of_place_2 = b_w3_dot.mul_add(G_w3_dot, b_w2_dot_of_place);
    let w3_times_27 = S::int(27) * w3;
    // b_w2_dot = 27*w3*H_bus_1 - 27*w1*H_bus_3 - 3*b + 3*(b - b_2)/(3 + sqrt(3)) +
    //   b_alpha_S_in_axle_base_3*sqrt(3) + b_w3_dot*G_w3_dot
    let b_w2_dot = (-b).mul_add(S::int(3), b_w2_dot_of_place_2) - H_bus_3 * w1_times_27
        + H_bus_1 * w3_times_27;
    let K_w2_dot_of_c_k = S::int(1) / k_doubled_plus_c_times_3;
    // K_w2_dot = K*(C + K)/(3*C + 2*K)
    let K_w2_dot = K * K_w2_dot_of_c_k * (C + K);
    // 2*C + K
    let c_doubled_plus_k = C.mul_add(S::int(2), K);
    // 2*B + c_doubled_plus_k
    let D_w2_dot_of_b_c_k = B.mul_add(S::int(2), c_doubled_plus_k);
    let b_c_times_3 = B * c_times_3;
    // K*D_w2_dot_of_b_c_k + b_c_times_3
    let D_w2_dot_of_b_c_k_2 = K.mul_add(D_w2_dot_of_b_c_k, b_c_times_3);
    // D_w2_dot = (3*B*C + K*(2*B + 2*C + K))/(3*C + 2*K)
    let D_w2_dot = K_w2_dot_of_c_k * D_w2_dot_of_b_c_k_2;
    // over_D_w2_dot = 1/D_w2_dot
    let over_D_w2_dot = S::int(1) / D_w2_dot;
    // G_w2_dot = K_w2_dot*over_D_w2_dot
    let G_w2_dot = K_w2_dot * over_D_w2_dot;
    // b_w1_dot = 27*w2*H_bus_3 - 27*w3*H_bus_2 + 3*b_2 + 3*(b - b_2)/(3 + sqrt(3)) +
    //   b_alpha_S_in_axle_base_3*sqrt(3) + b_w3_dot*G_w3_dot + b_w2_dot*G_w2_dot
    let b_w1_dot = b_w2_dot.mul_add(G_w2_dot, S::int(3) * b_2) + H_bus_3 * w2_times_27
        + b_w2_dot_of_place_2 - H_bus_2 * w3_times_27;
    // D_w1_dot = (3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K)))/(3*B*C + K*(2*B + 2*C + K))
    let D_w1_dot = (K * (B.mul_add(c_doubled_plus_k, C * K) + A * D_w2_dot_of_b_c_k)
        + A * b_c_times_3) / D_w2_dot_of_b_c_k_2;
    // over_D_w1_dot = 1/D_w1_dot
    let over_D_w1_dot = S::int(1) / D_w1_dot;
    // G_w1_dot = b_w1_dot*over_D_w1_dot
    let G_w1_dot = b_w1_dot * over_D_w1_dot;
    // w1' = -G_w1_dot/27
    let w1_dot = -S::ratio(1, 27) * G_w1_dot;
    // G_w2_dot_2 = b_w2_dot*over_D_w2_dot
    let G_w2_dot_2 = b_w2_dot * over_D_w2_dot;
    // w2' = w1'*G_w2_dot - G_w2_dot_2/27
    let w2_dot = w1_dot.mul_add(G_w2_dot, -S::ratio(1, 27) * G_w2_dot_2);
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

/// Jacobian of the derivative by the state; columns e0, e1, e2, e3, phi, w1, w2, w3, s.
///
/// 416 operations, 1 sine and cosine, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [[S; 9]; 9] {
    let Parameters { A, B, C, J, K, .. } = *p;
    let [e0, e1, e2, e3, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_S_in_axle_base_2_by_w1_of_ = (S::int(3)).sqrt();
    // 3 + sqrt(3)
    let w_S_in_axle_base_2_by_w1_of__2 = S::int(3) + w_S_in_axle_base_2_by_w1_of_;
    let w_S_in_axle_base_2_by_w1_of__3 = S::int(1) / w_S_in_axle_base_2_by_w1_of__2;
    // w_S_in_axle_base_2_by_w1 = 3/(3 + sqrt(3))
    let w_S_in_axle_base_2_by_w1 = S::int(3) * w_S_in_axle_base_2_by_w1_of__3;
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_2_by_w1_of_;
    // w_S_in_axle_base_2_by_w1_of__3 - 1
    let w_S_in_axle_base_1_of_ = w_S_in_axle_base_2_by_w1_of__3 - S::int(1);
    let w_S_in_axle_base_1_of__2 = S::int(3) * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w2
        .mul_add(w_S_in_axle_base_2_by_w1, w_S_in_axle_base_1_of_w3)
        + w1 * w_S_in_axle_base_1_of__2;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w1
        .mul_add(w_S_in_axle_base_2_by_w1, w_S_in_axle_base_1_of_w3)
        + w2 * w_S_in_axle_base_1_of__2;
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w_S_in_axle_base_2_by_w1_of_ * (w1 + w2) + w_S_in_axle_base_1_of_w3;
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
    // over_D_s_dot = 1/J
    let over_D_s_dot = S::int(1) / J;
    // G_s_dot = J*over_D_s_dot
    let G_s_dot = J * over_D_s_dot;
    // G_s_dot - 1
    let K_alpha_S_in_axle_base_3_of_g_s_dot = G_s_dot - S::int(1);
    // K_alpha_S_in_axle_base_3 = J*(G_s_dot - 1)
    let K_alpha_S_in_axle_base_3 = J * K_alpha_S_in_axle_base_3_of_g_s_dot;
    let c_times_3 = S::int(3) * C;
    // 2*K + c_times_3
    let k_doubled_plus_c_times_3 = K.mul_add(S::int(2), c_times_3);
    // K_w3_dot = 3*C + 2*K - K_alpha_S_in_axle_base_3
    let K_w3_dot = k_doubled_plus_c_times_3 - K_alpha_S_in_axle_base_3;
    // over_D_w3_dot = 1/K_w3_dot
    let over_D_w3_dot = S::int(1) / K_w3_dot;
    // G_w3_dot = K*over_D_w3_dot
    let G_w3_dot = K * over_D_w3_dot;
    let K_w2_dot_of_c_k = S::int(1) / k_doubled_plus_c_times_3;
    // K_w2_dot = K*(C + K)/(3*C + 2*K)
    let K_w2_dot = K * K_w2_dot_of_c_k * (C + K);
    // 2*C + K
    let c_doubled_plus_k = C.mul_add(S::int(2), K);
    // 2*B + c_doubled_plus_k
    let D_w2_dot_of_b_c_k = B.mul_add(S::int(2), c_doubled_plus_k);
    let b_c_times_3 = B * c_times_3;
    // K*D_w2_dot_of_b_c_k + b_c_times_3
    let D_w2_dot_of_b_c_k_2 = K.mul_add(D_w2_dot_of_b_c_k, b_c_times_3);
    // D_w2_dot = (3*B*C + K*(2*B + 2*C + K))/(3*C + 2*K)
    let D_w2_dot = K_w2_dot_of_c_k * D_w2_dot_of_b_c_k_2;
    // over_D_w2_dot = 1/D_w2_dot
    let over_D_w2_dot = S::int(1) / D_w2_dot;
    // G_w2_dot = K_w2_dot*over_D_w2_dot
    let G_w2_dot = K_w2_dot * over_D_w2_dot;
    // D_w1_dot = (3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K)))/(3*B*C + K*(2*B + 2*C + K))
    let D_w1_dot = (K * (B.mul_add(c_doubled_plus_k, C * K) + A * D_w2_dot_of_b_c_k)
        + A * b_c_times_3) / D_w2_dot_of_b_c_k_2;
    // over_D_w1_dot = 1/D_w1_dot
    let over_D_w1_dot = S::int(1) / D_w1_dot;
    // w_axle_base_in_W_turn1_1_by_phi = w_S_in_axle_base_2*cos(phi) - w_S_in_axle_base_1*sin(phi)
    let w_axle_base_in_W_turn1_1_by_phi = -w_axle_base_in_W_turn1_2;
    // w_axle_base_in_W_turn1_2_by_phi = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_2_by_phi = w_axle_base_in_W_turn1_1;
    // w_axle_base_in_W_turn1_2 + w_axle_base_in_W_turn1_1_by_phi
    let alpha_W_turn1_in_axle_base_1_by_phi_of_place = w_axle_base_in_W_turn1_2
        + w_axle_base_in_W_turn1_1_by_phi;
    // w_axle_base_in_W_turn1_1 - w_axle_base_in_W_turn1_2_by_phi
    let alpha_W_turn1_in_axle_base_1_by_phi_of_place_2 = w_axle_base_in_W_turn1_1
        - w_axle_base_in_W_turn1_2_by_phi;
    // alpha_W_turn1_in_axle_base_1_by_phi = -s*(sin(phi)*(w_axle_base_in_W_turn1_2 +
    //   w_axle_base_in_W_turn1_1_by_phi) + cos(phi)*(w_axle_base_in_W_turn1_1 -
    //   w_axle_base_in_W_turn1_2_by_phi))
    let alpha_W_turn1_in_axle_base_1_by_phi = -s
        * alpha_W_turn1_in_axle_base_1_by_phi_of_place_2
            .mul_add(cos_phi, alpha_W_turn1_in_axle_base_1_by_phi_of_place * sin_phi);
    // alpha_W_turn1_in_axle_base_2_by_phi = s*(cos(phi)*(w_axle_base_in_W_turn1_2 +
    //   w_axle_base_in_W_turn1_1_by_phi) - sin(phi)*(w_axle_base_in_W_turn1_1 -
    //   w_axle_base_in_W_turn1_2_by_phi))
    let alpha_W_turn1_in_axle_base_2_by_phi = s
        * (-alpha_W_turn1_in_axle_base_1_by_phi_of_place_2)
            .mul_add(sin_phi, alpha_W_turn1_in_axle_base_1_by_phi_of_place * cos_phi);
    // alpha_W_turn1_in_axle_base_1_by_phi + alpha_W_turn1_in_axle_base_2_by_phi
    let b_w3_dot_by_phi_of_place = alpha_W_turn1_in_axle_base_1_by_phi
        + alpha_W_turn1_in_axle_base_2_by_phi;
    let k_times_3 = S::int(3) * K;
    // b_w3_dot_by_phi = -3*K*sqrt(3)*(alpha_W_turn1_in_axle_base_1_by_phi +
    //   alpha_W_turn1_in_axle_base_2_by_phi)
    let b_w3_dot_by_phi = -b_w3_dot_by_phi_of_place * k_times_3 * w_S_in_axle_base_2_by_w1_of_;
    let b_w2_dot_by_phi_of_place = w_S_in_axle_base_2_by_w1_of__3 * b_w3_dot_by_phi_of_place;
    let k_times_9 = S::int(9) * K;
    let g_w3_dot_b_w3_dot_by_phi = G_w3_dot * b_w3_dot_by_phi;
    // b_w2_dot_by_phi = 9*K*(alpha_W_turn1_in_axle_base_2_by_phi - (alpha_W_turn1_in_axle_base_1_by_phi +
    //   alpha_W_turn1_in_axle_base_2_by_phi)/(3 + sqrt(3))) + G_w3_dot*b_w3_dot_by_phi
    let b_w2_dot_by_phi = k_times_9
        * (alpha_W_turn1_in_axle_base_2_by_phi - b_w2_dot_by_phi_of_place)
        + g_w3_dot_b_w3_dot_by_phi;
    // b_w1_dot_by_phi = 9*K*(alpha_W_turn1_in_axle_base_1_by_phi - (alpha_W_turn1_in_axle_base_1_by_phi +
    //   alpha_W_turn1_in_axle_base_2_by_phi)/(3 + sqrt(3))) + G_w3_dot*b_w3_dot_by_phi +
    //   G_w2_dot*b_w2_dot_by_phi
    let b_w1_dot_by_phi = k_times_9
        * (alpha_W_turn1_in_axle_base_1_by_phi - b_w2_dot_by_phi_of_place)
        + G_w2_dot * b_w2_dot_by_phi + g_w3_dot_b_w3_dot_by_phi;
    let over_d_w3_dot_by_9 = S::ratio(1, 9) * over_D_w3_dot;
    // over_D_w1_dot*(1 + G_w2_dot)
    let w3_dot_by_phi_of_place = over_D_w1_dot * (S::int(1) + G_w2_dot);
    // over_D_w2_dot*b_w2_dot_by_phi + b_w1_dot_by_phi*w3_dot_by_phi_of_place
    let w3_dot_by_phi_of_place_2 = b_w1_dot_by_phi
        .mul_add(w3_dot_by_phi_of_place, over_D_w2_dot * b_w2_dot_by_phi);
    let g_w3_dot_by_27 = S::ratio(1, 27) * G_w3_dot;
    // w3_dot_by_phi = -over_D_w3_dot*b_w3_dot_by_phi/9 - G_w3_dot*(over_D_w2_dot*b_w2_dot_by_phi +
    //   over_D_w1_dot*b_w1_dot_by_phi*(1 + G_w2_dot))/27
    let w3_dot_by_phi = (-w3_dot_by_phi_of_place_2)
        .mul_add(g_w3_dot_by_27, -b_w3_dot_by_phi * over_d_w3_dot_by_9);
    let alpha_S_in_axle_base_3_by_phi_of_ = S::ratio(1, 27) * w_S_in_axle_base_2_by_w1_of_;
    // alpha_S_in_axle_base_3_by_phi = sqrt(3)*(27*w3_dot_by_phi - over_D_w2_dot*b_w2_dot_by_phi -
    //   over_D_w1_dot*b_w1_dot_by_phi*(1 + G_w2_dot))/27
    let alpha_S_in_axle_base_3_by_phi = alpha_S_in_axle_base_3_by_phi_of_
        * w3_dot_by_phi.mul_add(S::int(27), -w3_dot_by_phi_of_place_2);
    let w_axle_base_in_W_turn1_1_by_w1_of_ = S::ratio(1, 2) * w_S_in_axle_base_2_by_w1_of__2;
    let w_axle_base_in_W_turn1_1_by_w1_of_phi = w_axle_base_in_W_turn1_1_by_w1_of_ * cos_phi;
    // w_axle_base_in_W_turn1_1_by_w1 = w_S_in_axle_base_2_by_w1*sin(phi) - cos(phi)*(3 + sqrt(3))/2
    let w_axle_base_in_W_turn1_1_by_w1 = w_S_in_axle_base_2_by_w1
        .mul_add(sin_phi, -w_axle_base_in_W_turn1_1_by_w1_of_phi);
    let w_axle_base_in_W_turn1_2_by_w1_of_phi = w_axle_base_in_W_turn1_1_by_w1_of_ * sin_phi;
    // w_axle_base_in_W_turn1_2_by_w1 = -sin(phi)*(3 + sqrt(3))/2 - w_S_in_axle_base_2_by_w1*cos(phi)
    let w_axle_base_in_W_turn1_2_by_w1 = (-w_S_in_axle_base_2_by_w1)
        .mul_add(cos_phi, -w_axle_base_in_W_turn1_2_by_w1_of_phi);
    let H_wheel_1_by_w1_of_k = K * w_axle_base_in_W_turn1_1_by_w1_of_;
    // -H_wheel_1_by_w1_of_k
    let H_wheel_1_by_w1_of_k_2 = -H_wheel_1_by_w1_of_k;
    // H_wheel_1_by_w1 = -K*(3 + sqrt(3))/2
    let H_wheel_1_by_w1 = H_wheel_1_by_w1_of_k_2;
    // alpha_W_turn1_in_axle_base_1_by_w1 = s*(w_axle_base_in_W_turn1_2_by_w1*cos(phi) -
    //   w_axle_base_in_W_turn1_1_by_w1*sin(phi))
    let alpha_W_turn1_in_axle_base_1_by_w1 = s
        * (-w_axle_base_in_W_turn1_1_by_w1)
            .mul_add(sin_phi, w_axle_base_in_W_turn1_2_by_w1 * cos_phi);
    // alpha_W_turn1_in_axle_base_2_by_w1 = s*(w_axle_base_in_W_turn1_1_by_w1*cos(phi) +
    //   w_axle_base_in_W_turn1_2_by_w1*sin(phi))
    let alpha_W_turn1_in_axle_base_2_by_w1 = s
        * w_axle_base_in_W_turn1_2_by_w1
            .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w1 * cos_phi);
    // b_alpha_W_3_by_w1 = w_S_in_axle_base_2_by_w1*(K*w_S_in_axle_base_1 - H_wheel_1) - H_wheel_2*(3 +
    //   sqrt(3))/2 - w_S_in_axle_base_2*H_wheel_1_by_w1
    let b_alpha_W_3_by_w1 = (-H_wheel_2)
        .mul_add(
            w_axle_base_in_W_turn1_1_by_w1_of_,
            -w_S_in_axle_base_2 * H_wheel_1_by_w1,
        );
    // J*w_S_in_axle_base_1 - H_wheel_1
    let b_alpha_W_2_by_w1_of_place = J.mul_add(w_S_in_axle_base_1, -H_wheel_1);
    // w_axle_base_in_W_turn1_1_by_w1_of_*(K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3)
    let b_alpha_W_2_by_w1_of_place_2 = w_axle_base_in_W_turn1_1_by_w1_of_
        * (K * (w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3);
    let b_alpha_W_2_by_w1_of_place_3 = b_alpha_W_2_by_w1_of_place * w_S_in_axle_base_2_by_w1_of_;
    // b_alpha_W_2_by_w1 = H_wheel_1*sqrt(3) - J*w_S_in_axle_base_1*sqrt(3) + (3 +
    //   sqrt(3))*(K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3)/2 + w_S_in_axle_base_3*H_wheel_1_by_w1
    let b_alpha_W_2_by_w1 = w_S_in_axle_base_3
        .mul_add(H_wheel_1_by_w1, -b_alpha_W_2_by_w1_of_place_3) + b_alpha_W_2_by_w1_of_place_2;
    // J*w_S_in_axle_base_2 - H_wheel_2
    let b_alpha_W_1_by_w1_of_place = J.mul_add(w_S_in_axle_base_2, -H_wheel_2);
    // K*w_W_turn1_3 - H_wheel_3
    let b_alpha_W_1_by_w1_of_place_2 = K.mul_add(w_W_turn1_3, -H_wheel_3);
    // -b_alpha_W_1_by_w1_of_place_2
    let b_alpha_W_1_by_w1_of_place_3 = -b_alpha_W_1_by_w1_of_place_2;
    let b_alpha_W_1_by_w1_of_place_4 = b_alpha_W_1_by_w1_of_place * w_S_in_axle_base_2_by_w1_of_;
    // b_alpha_W_1_by_w1 = sqrt(3)*(H_wheel_2 - J*w_S_in_axle_base_2) +
    //   w_S_in_axle_base_2_by_w1*(K*w_W_turn1_3 - H_wheel_3)
    let b_alpha_W_1_by_w1 = (-w_S_in_axle_base_2_by_w1)
        .mul_add(b_alpha_W_1_by_w1_of_place_3, -b_alpha_W_1_by_w1_of_place_4);
    // b_alpha_W_2_by_w1 - k_times_3*(alpha_W_turn1_in_axle_base_1_by_w1 +
    //   alpha_W_turn1_in_axle_base_2_by_w1)
    let b_w3_dot_by_w1_of_place = b_alpha_W_2_by_w1
        - k_times_3 * (alpha_W_turn1_in_axle_base_1_by_w1 + alpha_W_turn1_in_axle_base_2_by_w1);
    // b_alpha_W_1_by_w1 - b_w3_dot_by_w1_of_place
    let b_w3_dot_by_w1_of_place_2 = b_alpha_W_1_by_w1 - b_w3_dot_by_w1_of_place;
    let h_bus_2_times_27 = S::int(27) * H_bus_2;
    let w2_times_27 = S::int(27) * w2;
    // b_w3_dot_by_w1 = 27*H_bus_2 - 27*A*w2 + sqrt(3)*(b_alpha_W_3_by_w1*(1 - G_s_dot) -
    //   3*K*(alpha_W_turn1_in_axle_base_1_by_w1 + alpha_W_turn1_in_axle_base_2_by_w1) + b_alpha_W_2_by_w1 -
    //   b_alpha_W_1_by_w1)
    let b_w3_dot_by_w1 = h_bus_2_times_27
        - w_S_in_axle_base_2_by_w1_of_
            * b_alpha_W_3_by_w1
                .mul_add(K_alpha_S_in_axle_base_3_of_g_s_dot, b_w3_dot_by_w1_of_place_2)
        - A * w2_times_27;
    let b_w2_dot_by_w1_of_g_s_dot = K_alpha_S_in_axle_base_3_of_g_s_dot
        * w_S_in_axle_base_2_by_w1_of_;
    // G_w3_dot*b_w3_dot_by_w1 - w_S_in_axle_base_2_by_w1*b_w3_dot_by_w1_of_place_2
    let b_w2_dot_by_w1_of_place = (-w_S_in_axle_base_2_by_w1)
        .mul_add(b_w3_dot_by_w1_of_place_2, G_w3_dot * b_w3_dot_by_w1);
    // b_alpha_W_3_by_w1*b_w2_dot_by_w1_of_g_s_dot - b_w2_dot_by_w1_of_place
    let b_w2_dot_by_w1_of_place_2 = b_alpha_W_3_by_w1
        .mul_add(b_w2_dot_by_w1_of_g_s_dot, -b_w2_dot_by_w1_of_place);
    let h_bus_3_times_27 = S::int(27) * H_bus_3;
    let w3_times_27 = S::int(27) * w3;
    // b_w2_dot_by_w1 = 27*A*w3 - 27*H_bus_3 + 9*K*alpha_W_turn1_in_axle_base_2_by_w1 +
    //   b_alpha_W_3_by_w1*sqrt(3)*(1 - G_s_dot) - 3*b_alpha_W_2_by_w1 + 3*(b_alpha_W_2_by_w1 -
    //   3*K*(alpha_W_turn1_in_axle_base_1_by_w1 + alpha_W_turn1_in_axle_base_2_by_w1) -
    //   b_alpha_W_1_by_w1)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_w1
    let b_w2_dot_by_w1 = (-b_alpha_W_2_by_w1)
        .mul_add(S::int(3), alpha_W_turn1_in_axle_base_2_by_w1 * k_times_9)
        - b_w2_dot_by_w1_of_place_2 - h_bus_3_times_27 + A * w3_times_27;
    // b_w1_dot_by_w1 = 9*K*alpha_W_turn1_in_axle_base_1_by_w1 + b_alpha_W_3_by_w1*sqrt(3)*(1 - G_s_dot) +
    //   3*b_alpha_W_1_by_w1 + 3*(b_alpha_W_2_by_w1 - 3*K*(alpha_W_turn1_in_axle_base_1_by_w1 +
    //   alpha_W_turn1_in_axle_base_2_by_w1) - b_alpha_W_1_by_w1)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_w1 +
    //   G_w2_dot*b_w2_dot_by_w1
    let b_w1_dot_by_w1 = G_w2_dot.mul_add(b_w2_dot_by_w1, S::int(3) * b_alpha_W_1_by_w1)
        + alpha_W_turn1_in_axle_base_1_by_w1 * k_times_9 - b_w2_dot_by_w1_of_place_2;
    // over_D_w2_dot*b_w2_dot_by_w1 + b_w1_dot_by_w1*w3_dot_by_phi_of_place
    let w3_dot_by_w1_of_place = b_w1_dot_by_w1
        .mul_add(w3_dot_by_phi_of_place, over_D_w2_dot * b_w2_dot_by_w1);
    // w3_dot_by_w1 = -over_D_w3_dot*b_w3_dot_by_w1/9 - G_w3_dot*(over_D_w2_dot*b_w2_dot_by_w1 +
    //   over_D_w1_dot*b_w1_dot_by_w1*(1 + G_w2_dot))/27
    let w3_dot_by_w1 = (-g_w3_dot_by_27)
        .mul_add(w3_dot_by_w1_of_place, -b_w3_dot_by_w1 * over_d_w3_dot_by_9);
    // alpha_S_in_axle_base_3_by_w1 = sqrt(3)*(27*w3_dot_by_w1 - over_D_w2_dot*b_w2_dot_by_w1 -
    //   over_D_w1_dot*b_w1_dot_by_w1*(1 + G_w2_dot))/27
    let alpha_S_in_axle_base_3_by_w1 = alpha_S_in_axle_base_3_by_phi_of_
        * w3_dot_by_w1.mul_add(S::int(27), -w3_dot_by_w1_of_place);
    // w_S_in_axle_base_1_by_w2 = 3/(3 + sqrt(3))
    let w_S_in_axle_base_1_by_w2 = w_S_in_axle_base_2_by_w1;
    // w_axle_base_in_W_turn1_1_by_w2 = w_S_in_axle_base_1_by_w2*cos(phi) - sin(phi)*(3 + sqrt(3))/2
    let w_axle_base_in_W_turn1_1_by_w2 = w_S_in_axle_base_1_by_w2
        .mul_add(cos_phi, -w_axle_base_in_W_turn1_2_by_w1_of_phi);
    // w_axle_base_in_W_turn1_2_by_w2 = cos(phi)*(3 + sqrt(3))/2 + w_S_in_axle_base_1_by_w2*sin(phi)
    let w_axle_base_in_W_turn1_2_by_w2 = w_S_in_axle_base_1_by_w2
        .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w1_of_phi);
    // H_wheel_2_by_w2 = -K*(3 + sqrt(3))/2
    let H_wheel_2_by_w2 = H_wheel_1_by_w1_of_k_2;
    // alpha_W_turn1_in_axle_base_1_by_w2 = s*(w_axle_base_in_W_turn1_2_by_w2*cos(phi) -
    //   w_axle_base_in_W_turn1_1_by_w2*sin(phi))
    let alpha_W_turn1_in_axle_base_1_by_w2 = s
        * (-w_axle_base_in_W_turn1_1_by_w2)
            .mul_add(sin_phi, w_axle_base_in_W_turn1_2_by_w2 * cos_phi);
    // alpha_W_turn1_in_axle_base_2_by_w2 = s*(w_axle_base_in_W_turn1_1_by_w2*cos(phi) +
    //   w_axle_base_in_W_turn1_2_by_w2*sin(phi))
    let alpha_W_turn1_in_axle_base_2_by_w2 = s
        * w_axle_base_in_W_turn1_2_by_w2
            .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w2 * cos_phi);
    // b_alpha_W_3_by_w2 = H_wheel_1*(3 + sqrt(3))/2 + w_S_in_axle_base_1_by_w2*(H_wheel_2 -
    //   K*w_S_in_axle_base_2) + w_S_in_axle_base_1*H_wheel_2_by_w2
    let b_alpha_W_3_by_w2 = H_wheel_1
        .mul_add(
            w_axle_base_in_W_turn1_1_by_w1_of_,
            w_S_in_axle_base_1 * H_wheel_2_by_w2,
        );
    // b_alpha_W_2_by_w2 = sqrt(3)*(H_wheel_1 - J*w_S_in_axle_base_1) +
    //   w_S_in_axle_base_1_by_w2*(K*w_W_turn1_3 - H_wheel_3)
    let b_alpha_W_2_by_w2 = (-w_S_in_axle_base_1_by_w2)
        .mul_add(b_alpha_W_1_by_w1_of_place_3, -b_alpha_W_2_by_w1_of_place_3);
    // b_alpha_W_1_by_w2 = H_wheel_2*sqrt(3) - J*w_S_in_axle_base_2*sqrt(3) + (3 +
    //   sqrt(3))*(K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3)/2 + w_S_in_axle_base_3*H_wheel_2_by_w2
    let b_alpha_W_1_by_w2 = w_S_in_axle_base_3
        .mul_add(H_wheel_2_by_w2, b_alpha_W_2_by_w1_of_place_2) - b_alpha_W_1_by_w1_of_place_4;
    // b_alpha_W_2_by_w2 - k_times_3*(alpha_W_turn1_in_axle_base_1_by_w2 +
    //   alpha_W_turn1_in_axle_base_2_by_w2)
    let b_w3_dot_by_w2_of_place = b_alpha_W_2_by_w2
        - k_times_3 * (alpha_W_turn1_in_axle_base_1_by_w2 + alpha_W_turn1_in_axle_base_2_by_w2);
    // b_alpha_W_1_by_w2 - b_w3_dot_by_w2_of_place
    let b_w3_dot_by_w2_of_place_2 = b_alpha_W_1_by_w2 - b_w3_dot_by_w2_of_place;
    let h_bus_1_times_27 = S::int(27) * H_bus_1;
    let w1_times_27 = S::int(27) * w1;
    // b_w3_dot_by_w2 = 27*B*w1 - 27*H_bus_1 + sqrt(3)*(b_alpha_W_3_by_w2*(1 - G_s_dot) -
    //   3*K*(alpha_W_turn1_in_axle_base_1_by_w2 + alpha_W_turn1_in_axle_base_2_by_w2) + b_alpha_W_2_by_w2 -
    //   b_alpha_W_1_by_w2)
    let b_w3_dot_by_w2 = -w_S_in_axle_base_2_by_w1_of_
        * b_alpha_W_3_by_w2
            .mul_add(K_alpha_S_in_axle_base_3_of_g_s_dot, b_w3_dot_by_w2_of_place_2)
        + B * w1_times_27 - h_bus_1_times_27;
    // G_w3_dot*b_w3_dot_by_w2 - w_S_in_axle_base_2_by_w1*b_w3_dot_by_w2_of_place_2
    let b_w2_dot_by_w2_of_place = (-w_S_in_axle_base_2_by_w1)
        .mul_add(b_w3_dot_by_w2_of_place_2, G_w3_dot * b_w3_dot_by_w2);
    // b_alpha_W_3_by_w2*b_w2_dot_by_w1_of_g_s_dot - b_w2_dot_by_w2_of_place
    let b_w2_dot_by_w2_of_place_2 = b_alpha_W_3_by_w2
        .mul_add(b_w2_dot_by_w1_of_g_s_dot, -b_w2_dot_by_w2_of_place);
    // b_w2_dot_by_w2 = 9*K*alpha_W_turn1_in_axle_base_2_by_w2 + b_alpha_W_3_by_w2*sqrt(3)*(1 - G_s_dot) -
    //   3*b_alpha_W_2_by_w2 + 3*(b_alpha_W_2_by_w2 - 3*K*(alpha_W_turn1_in_axle_base_1_by_w2 +
    //   alpha_W_turn1_in_axle_base_2_by_w2) - b_alpha_W_1_by_w2)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_w2
    let b_w2_dot_by_w2 = (-b_alpha_W_2_by_w2)
        .mul_add(S::int(3), alpha_W_turn1_in_axle_base_2_by_w2 * k_times_9)
        - b_w2_dot_by_w2_of_place_2;
    // b_w1_dot_by_w2 = 27*H_bus_3 - 27*B*w3 + 9*K*alpha_W_turn1_in_axle_base_1_by_w2 +
    //   b_alpha_W_3_by_w2*sqrt(3)*(1 - G_s_dot) + 3*b_alpha_W_1_by_w2 + 3*(b_alpha_W_2_by_w2 -
    //   3*K*(alpha_W_turn1_in_axle_base_1_by_w2 + alpha_W_turn1_in_axle_base_2_by_w2) -
    //   b_alpha_W_1_by_w2)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_w2 + G_w2_dot*b_w2_dot_by_w2
    let b_w1_dot_by_w2 = G_w2_dot.mul_add(b_w2_dot_by_w2, S::int(3) * b_alpha_W_1_by_w2)
        + alpha_W_turn1_in_axle_base_1_by_w2 * k_times_9 + h_bus_3_times_27
        - B * w3_times_27 - b_w2_dot_by_w2_of_place_2;
    // over_D_w2_dot*b_w2_dot_by_w2 + b_w1_dot_by_w2*w3_dot_by_phi_of_place
    let w3_dot_by_w2_of_place = b_w1_dot_by_w2
        .mul_add(w3_dot_by_phi_of_place, over_D_w2_dot * b_w2_dot_by_w2);
    // w3_dot_by_w2 = -over_D_w3_dot*b_w3_dot_by_w2/9 - G_w3_dot*(over_D_w2_dot*b_w2_dot_by_w2 +
    //   over_D_w1_dot*b_w1_dot_by_w2*(1 + G_w2_dot))/27
    let w3_dot_by_w2 = (-g_w3_dot_by_27)
        .mul_add(w3_dot_by_w2_of_place, -b_w3_dot_by_w2 * over_d_w3_dot_by_9);
    // alpha_S_in_axle_base_3_by_w2 = sqrt(3)*(27*w3_dot_by_w2 - over_D_w2_dot*b_w2_dot_by_w2 -
    //   over_D_w1_dot*b_w1_dot_by_w2*(1 + G_w2_dot))/27
    let alpha_S_in_axle_base_3_by_w2 = alpha_S_in_axle_base_3_by_phi_of_
        * w3_dot_by_w2.mul_add(S::int(27), -w3_dot_by_w2_of_place);
    // w_axle_base_in_W_turn1_1_by_w3 = sqrt(3)*(sin(phi) + cos(phi))
    let w_axle_base_in_W_turn1_1_by_w3 = w_S_in_axle_base_2_by_w1_of_ * (sin_phi + cos_phi);
    // w_axle_base_in_W_turn1_2_by_w3 = sqrt(3)*(sin(phi) - cos(phi))
    let w_axle_base_in_W_turn1_2_by_w3 = w_S_in_axle_base_2_by_w1_of_ * (sin_phi - cos_phi);
    // alpha_W_turn1_in_axle_base_1_by_w3 = s*(w_axle_base_in_W_turn1_2_by_w3*cos(phi) -
    //   w_axle_base_in_W_turn1_1_by_w3*sin(phi))
    let alpha_W_turn1_in_axle_base_1_by_w3 = s
        * (-w_axle_base_in_W_turn1_1_by_w3)
            .mul_add(sin_phi, w_axle_base_in_W_turn1_2_by_w3 * cos_phi);
    // alpha_W_turn1_in_axle_base_2_by_w3 = s*(w_axle_base_in_W_turn1_1_by_w3*cos(phi) +
    //   w_axle_base_in_W_turn1_2_by_w3*sin(phi))
    let alpha_W_turn1_in_axle_base_2_by_w3 = s
        * w_axle_base_in_W_turn1_2_by_w3
            .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w3 * cos_phi);
    // w_S_in_axle_base_1 - w_S_in_axle_base_2
    let b_alpha_W_3_by_w3_of_place = w_S_in_axle_base_1 - w_S_in_axle_base_2;
    // b_alpha_W_3_by_w3 = sqrt(3)*(H_wheel_2 - K*(w_S_in_axle_base_2 - w_S_in_axle_base_1) - H_wheel_1)
    let b_alpha_W_3_by_w3 = w_S_in_axle_base_2_by_w1_of_
        * K.mul_add(b_alpha_W_3_by_w3_of_place, H_wheel_2 - H_wheel_1);
    // b_alpha_W_2_by_w3 = sqrt(3)*(K*w_W_turn1_3 - J*w_S_in_axle_base_1 + H_wheel_1 - H_wheel_3)
    let b_alpha_W_2_by_w3 = w_S_in_axle_base_2_by_w1_of_
        * (b_alpha_W_1_by_w1_of_place_2 - b_alpha_W_2_by_w1_of_place);
    // b_alpha_W_1_by_w3 = sqrt(3)*(K*w_W_turn1_3 - J*w_S_in_axle_base_2 + H_wheel_2 - H_wheel_3)
    let b_alpha_W_1_by_w3 = w_S_in_axle_base_2_by_w1_of_
        * (b_alpha_W_1_by_w1_of_place_2 - b_alpha_W_1_by_w1_of_place);
    // b_alpha_W_2_by_w3 - k_times_3*(alpha_W_turn1_in_axle_base_1_by_w3 +
    //   alpha_W_turn1_in_axle_base_2_by_w3)
    let b_w3_dot_by_w3_of_place = b_alpha_W_2_by_w3
        - k_times_3 * (alpha_W_turn1_in_axle_base_1_by_w3 + alpha_W_turn1_in_axle_base_2_by_w3);
    // b_alpha_W_1_by_w3 - b_w3_dot_by_w3_of_place
    let b_w3_dot_by_w3_of_place_2 = b_alpha_W_1_by_w3 - b_w3_dot_by_w3_of_place;
    // b_w3_dot_by_w3 = sqrt(3)*(b_alpha_W_3_by_w3*(1 - G_s_dot) - 3*K*(alpha_W_turn1_in_axle_base_1_by_w3
    //   + alpha_W_turn1_in_axle_base_2_by_w3) + b_alpha_W_2_by_w3 - b_alpha_W_1_by_w3)
    let b_w3_dot_by_w3 = -w_S_in_axle_base_2_by_w1_of_
        * b_alpha_W_3_by_w3
            .mul_add(K_alpha_S_in_axle_base_3_of_g_s_dot, b_w3_dot_by_w3_of_place_2);
    // G_w3_dot*b_w3_dot_by_w3 - w_S_in_axle_base_2_by_w1*b_w3_dot_by_w3_of_place_2
    let b_w2_dot_by_w3_of_place = (-w_S_in_axle_base_2_by_w1)
        .mul_add(b_w3_dot_by_w3_of_place_2, G_w3_dot * b_w3_dot_by_w3);
    // b_alpha_W_3_by_w3*b_w2_dot_by_w1_of_g_s_dot - b_w2_dot_by_w3_of_place
    let b_w2_dot_by_w3_of_place_2 = b_alpha_W_3_by_w3
        .mul_add(b_w2_dot_by_w1_of_g_s_dot, -b_w2_dot_by_w3_of_place);
    // b_w2_dot_by_w3 = 27*H_bus_1 - 27*C*w1 + 9*K*alpha_W_turn1_in_axle_base_2_by_w3 +
    //   b_alpha_W_3_by_w3*sqrt(3)*(1 - G_s_dot) - 3*b_alpha_W_2_by_w3 + 3*(b_alpha_W_2_by_w3 -
    //   3*K*(alpha_W_turn1_in_axle_base_1_by_w3 + alpha_W_turn1_in_axle_base_2_by_w3) -
    //   b_alpha_W_1_by_w3)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_w3
    let b_w2_dot_by_w3 = (-b_alpha_W_2_by_w3)
        .mul_add(S::int(3), alpha_W_turn1_in_axle_base_2_by_w3 * k_times_9)
        + h_bus_1_times_27 - C * w1_times_27 - b_w2_dot_by_w3_of_place_2;
    // b_w1_dot_by_w3 = 27*C*w2 - 27*H_bus_2 + 9*K*alpha_W_turn1_in_axle_base_1_by_w3 +
    //   b_alpha_W_3_by_w3*sqrt(3)*(1 - G_s_dot) + 3*b_alpha_W_1_by_w3 + 3*(b_alpha_W_2_by_w3 -
    //   3*K*(alpha_W_turn1_in_axle_base_1_by_w3 + alpha_W_turn1_in_axle_base_2_by_w3) -
    //   b_alpha_W_1_by_w3)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_w3 + G_w2_dot*b_w2_dot_by_w3
    let b_w1_dot_by_w3 = G_w2_dot.mul_add(b_w2_dot_by_w3, S::int(3) * b_alpha_W_1_by_w3)
        + alpha_W_turn1_in_axle_base_1_by_w3 * k_times_9 - h_bus_2_times_27
        + C * w2_times_27 - b_w2_dot_by_w3_of_place_2;
    // over_D_w2_dot*b_w2_dot_by_w3 + b_w1_dot_by_w3*w3_dot_by_phi_of_place
    let w3_dot_by_w3_of_place = b_w1_dot_by_w3
        .mul_add(w3_dot_by_phi_of_place, over_D_w2_dot * b_w2_dot_by_w3);
    // w3_dot_by_w3 = -over_D_w3_dot*b_w3_dot_by_w3/9 - G_w3_dot*(over_D_w2_dot*b_w2_dot_by_w3 +
    //   over_D_w1_dot*b_w1_dot_by_w3*(1 + G_w2_dot))/27
    let w3_dot_by_w3 = (-g_w3_dot_by_27)
        .mul_add(w3_dot_by_w3_of_place, -b_w3_dot_by_w3 * over_d_w3_dot_by_9);
    // alpha_S_in_axle_base_3_by_w3 = sqrt(3)*(27*w3_dot_by_w3 - over_D_w2_dot*b_w2_dot_by_w3 -
    //   over_D_w1_dot*b_w1_dot_by_w3*(1 + G_w2_dot))/27
    let alpha_S_in_axle_base_3_by_w3 = alpha_S_in_axle_base_3_by_phi_of_
        * w3_dot_by_w3.mul_add(S::int(27), -w3_dot_by_w3_of_place);
    // alpha_W_turn1_in_axle_base_1_by_s = w_axle_base_in_W_turn1_2*cos(phi) -
    //   w_axle_base_in_W_turn1_1*sin(phi)
    let alpha_W_turn1_in_axle_base_1_by_s = (-w_axle_base_in_W_turn1_1)
        .mul_add(sin_phi, w_axle_base_in_W_turn1_2 * cos_phi);
    // alpha_W_turn1_in_axle_base_2_by_s = w_axle_base_in_W_turn1_1*cos(phi) +
    //   w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2_by_s = w_axle_base_in_W_turn1_2
        .mul_add(sin_phi, w_axle_base_in_W_turn1_1 * cos_phi);
    // J - K
    let j_minus_k = J - K;
    // K*(alpha_W_turn1_in_axle_base_1_by_s + alpha_W_turn1_in_axle_base_2_by_s) +
    //   b_alpha_W_3_by_w3_of_place*j_minus_k
    let b_w3_dot_by_s_of_place = K
        * (alpha_W_turn1_in_axle_base_1_by_s + alpha_W_turn1_in_axle_base_2_by_s)
        + b_alpha_W_3_by_w3_of_place * j_minus_k;
    // b_w3_dot_by_s = -3*sqrt(3)*((J - K)*(w_S_in_axle_base_1 - w_S_in_axle_base_2) +
    //   K*(alpha_W_turn1_in_axle_base_1_by_s + alpha_W_turn1_in_axle_base_2_by_s))
    let b_w3_dot_by_s = -S::int(3) * b_w3_dot_by_s_of_place * w_S_in_axle_base_2_by_w1_of_;
    // 9*w_S_in_axle_base_2_by_w1_of__3*b_w3_dot_by_s_of_place - G_w3_dot*b_w3_dot_by_s
    let b_w2_dot_by_s_of_place = (-G_w3_dot)
        .mul_add(
            b_w3_dot_by_s,
            S::int(9) * w_S_in_axle_base_2_by_w1_of__3 * b_w3_dot_by_s_of_place,
        );
    let j_minus_k_times_9 = S::int(9) * j_minus_k;
    // b_w2_dot_by_s = 9*w_S_in_axle_base_1*(J - K) + 9*K*alpha_W_turn1_in_axle_base_2_by_s -
    //   9*(w_S_in_axle_base_1*(J - K) + w_S_in_axle_base_2*(K - J) + K*alpha_W_turn1_in_axle_base_1_by_s +
    //   K*alpha_W_turn1_in_axle_base_2_by_s)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_s
    let b_w2_dot_by_s = alpha_W_turn1_in_axle_base_2_by_s
        .mul_add(k_times_9, -b_w2_dot_by_s_of_place) + w_S_in_axle_base_1 * j_minus_k_times_9;
    // b_w1_dot_by_s = 9*w_S_in_axle_base_2*(K - J) + 9*K*alpha_W_turn1_in_axle_base_1_by_s -
    //   9*(w_S_in_axle_base_1*(J - K) + w_S_in_axle_base_2*(K - J) + K*alpha_W_turn1_in_axle_base_1_by_s +
    //   K*alpha_W_turn1_in_axle_base_2_by_s)/(3 + sqrt(3)) + G_w3_dot*b_w3_dot_by_s + G_w2_dot*b_w2_dot_by_s
    let b_w1_dot_by_s = alpha_W_turn1_in_axle_base_1_by_s
        .mul_add(k_times_9, G_w2_dot * b_w2_dot_by_s) - b_w2_dot_by_s_of_place
        - w_S_in_axle_base_2 * j_minus_k_times_9;
    // over_D_w2_dot*b_w2_dot_by_s + b_w1_dot_by_s*w3_dot_by_phi_of_place
    let w3_dot_by_s_of_place = b_w1_dot_by_s
        .mul_add(w3_dot_by_phi_of_place, over_D_w2_dot * b_w2_dot_by_s);
    // w3_dot_by_s = -over_D_w3_dot*b_w3_dot_by_s/9 - G_w3_dot*(over_D_w2_dot*b_w2_dot_by_s +
    //   over_D_w1_dot*b_w1_dot_by_s*(1 + G_w2_dot))/27
    let w3_dot_by_s = (-g_w3_dot_by_27)
        .mul_add(w3_dot_by_s_of_place, -b_w3_dot_by_s * over_d_w3_dot_by_9);
    // alpha_S_in_axle_base_3_by_s = sqrt(3)*(27*w3_dot_by_s - over_D_w2_dot*b_w2_dot_by_s -
    //   over_D_w1_dot*b_w1_dot_by_s*(1 + G_w2_dot))/27
    let alpha_S_in_axle_base_3_by_s = alpha_S_in_axle_base_3_by_phi_of_
        * w3_dot_by_s.mul_add(S::int(27), -w3_dot_by_s_of_place);
    let w1_halved = S::ratio(1, 2) * w1;
    let w2_halved = S::ratio(1, 2) * w2;
    let w3_halved = S::ratio(1, 2) * w3;
    let e1_halved = S::ratio(1, 2) * e1;
    let e2_halved = S::ratio(1, 2) * e2;
    let e3_halved = S::ratio(1, 2) * e3;
    let e0_halved = S::ratio(1, 2) * e0;
    let over_d_w1_dot_by_27 = S::ratio(1, 27) * over_D_w1_dot;
    let over_d_w2_dot_by_27 = S::ratio(1, 27) * over_D_w2_dot;
    let w2_dot_by_phi_value_of_place = G_w2_dot * over_d_w1_dot_by_27;
    let g_s_dot_by_3 = S::ratio(1, 3) * G_s_dot;
    let over_d_s_dot_by_9 = S::ratio(1, 9) * over_D_s_dot;
    // -w1_halved
    let minus_w1_halved = -w1_halved;
    // -w2_halved
    let minus_w2_halved = -w2_halved;
    // -w3_halved
    let minus_w3_halved = -w3_halved;
    // -e1_halved
    let minus_e1_halved = -e1_halved;
    // -e2_halved
    let minus_e2_halved = -e2_halved;
    // -e3_halved
    let minus_e3_halved = -e3_halved;
    // Entries that are not zero.
    // d(e0')/d(e1) = -w1/2
    let e0_dot_by_e1_value = minus_w1_halved;
    // d(e0')/d(e2) = -w2/2
    let e0_dot_by_e2_value = minus_w2_halved;
    // d(e0')/d(e3) = -w3/2
    let e0_dot_by_e3_value = minus_w3_halved;
    // d(e0')/d(w1) = -e1/2
    let e0_dot_by_w1_value = minus_e1_halved;
    // d(e0')/d(w2) = -e2/2
    let e0_dot_by_w2_value = minus_e2_halved;
    // d(e0')/d(w3) = -e3/2
    let e0_dot_by_w3_value = minus_e3_halved;
    // d(e1')/d(e0) = w1/2
    let e1_dot_by_e0_value = w1_halved;
    // d(e1')/d(e2) = w3/2
    let e1_dot_by_e2_value = w3_halved;
    // d(e1')/d(e3) = -w2/2
    let e1_dot_by_e3_value = minus_w2_halved;
    // d(e1')/d(w1) = e0/2
    let e1_dot_by_w1_value = e0_halved;
    // d(e1')/d(w2) = -e3/2
    let e1_dot_by_w2_value = minus_e3_halved;
    // d(e1')/d(w3) = e2/2
    let e1_dot_by_w3_value = e2_halved;
    // d(e2')/d(e0) = w2/2
    let e2_dot_by_e0_value = w2_halved;
    // d(e2')/d(e1) = -w3/2
    let e2_dot_by_e1_value = minus_w3_halved;
    // d(e2')/d(e3) = w1/2
    let e2_dot_by_e3_value = w1_halved;
    // d(e2')/d(w1) = e3/2
    let e2_dot_by_w1_value = e3_halved;
    // d(e2')/d(w2) = e0/2
    let e2_dot_by_w2_value = e0_halved;
    // d(e2')/d(w3) = -e1/2
    let e2_dot_by_w3_value = minus_e1_halved;
    // d(e3')/d(e0) = w3/2
    let e3_dot_by_e0_value = w3_halved;
    // d(e3')/d(e1) = w2/2
    let e3_dot_by_e1_value = w2_halved;
    // d(e3')/d(e2) = -w1/2
    let e3_dot_by_e2_value = minus_w1_halved;
    // d(e3')/d(w1) = -e2/2
    let e3_dot_by_w1_value = minus_e2_halved;
    // d(e3')/d(w2) = e1/2
    let e3_dot_by_w2_value = e1_halved;
    // d(e3')/d(w3) = e0/2
    let e3_dot_by_w3_value = e0_halved;
    // d(phi')/d(s) = 1
    let phi_dot_by_s_value = S::int(1);
    // d(w1')/d(phi) = -over_D_w1_dot*b_w1_dot_by_phi/27
    let w1_dot_by_phi_value = -b_w1_dot_by_phi * over_d_w1_dot_by_27;
    // d(w1')/d(w1) = -over_D_w1_dot*b_w1_dot_by_w1/27
    let w1_dot_by_w1_value = -b_w1_dot_by_w1 * over_d_w1_dot_by_27;
    // d(w1')/d(w2) = -over_D_w1_dot*b_w1_dot_by_w2/27
    let w1_dot_by_w2_value = -b_w1_dot_by_w2 * over_d_w1_dot_by_27;
    // d(w1')/d(w3) = -over_D_w1_dot*b_w1_dot_by_w3/27
    let w1_dot_by_w3_value = -b_w1_dot_by_w3 * over_d_w1_dot_by_27;
    // d(w1')/d(s) = -over_D_w1_dot*b_w1_dot_by_s/27
    let w1_dot_by_s_value = -b_w1_dot_by_s * over_d_w1_dot_by_27;
    // d(w2')/d(phi) = -over_D_w2_dot*b_w2_dot_by_phi/27 - G_w2_dot*over_D_w1_dot*b_w1_dot_by_phi/27
    let w2_dot_by_phi_value = (-b_w1_dot_by_phi)
        .mul_add(w2_dot_by_phi_value_of_place, -b_w2_dot_by_phi * over_d_w2_dot_by_27);
    // d(w2')/d(w1) = -over_D_w2_dot*b_w2_dot_by_w1/27 - G_w2_dot*over_D_w1_dot*b_w1_dot_by_w1/27
    let w2_dot_by_w1_value = (-b_w1_dot_by_w1)
        .mul_add(w2_dot_by_phi_value_of_place, -b_w2_dot_by_w1 * over_d_w2_dot_by_27);
    // d(w2')/d(w2) = -over_D_w2_dot*b_w2_dot_by_w2/27 - G_w2_dot*over_D_w1_dot*b_w1_dot_by_w2/27
    let w2_dot_by_w2_value = (-b_w1_dot_by_w2)
        .mul_add(w2_dot_by_phi_value_of_place, -b_w2_dot_by_w2 * over_d_w2_dot_by_27);
    // d(w2')/d(w3) = -over_D_w2_dot*b_w2_dot_by_w3/27 - G_w2_dot*over_D_w1_dot*b_w1_dot_by_w3/27
    let w2_dot_by_w3_value = (-b_w1_dot_by_w3)
        .mul_add(w2_dot_by_phi_value_of_place, -b_w2_dot_by_w3 * over_d_w2_dot_by_27);
    // d(w2')/d(s) = -over_D_w2_dot*b_w2_dot_by_s/27 - G_w2_dot*over_D_w1_dot*b_w1_dot_by_s/27
    let w2_dot_by_s_value = (-b_w1_dot_by_s)
        .mul_add(w2_dot_by_phi_value_of_place, -b_w2_dot_by_s * over_d_w2_dot_by_27);
    // d(s')/d(phi) = -G_s_dot*alpha_S_in_axle_base_3_by_phi/3
    let s_dot_by_phi_value = -alpha_S_in_axle_base_3_by_phi * g_s_dot_by_3;
    // d(s')/d(w1) = -over_D_s_dot*b_alpha_W_3_by_w1/9 - G_s_dot*alpha_S_in_axle_base_3_by_w1/3
    let s_dot_by_w1_value = (-b_alpha_W_3_by_w1)
        .mul_add(over_d_s_dot_by_9, -alpha_S_in_axle_base_3_by_w1 * g_s_dot_by_3);
    // d(s')/d(w2) = -over_D_s_dot*b_alpha_W_3_by_w2/9 - G_s_dot*alpha_S_in_axle_base_3_by_w2/3
    let s_dot_by_w2_value = (-b_alpha_W_3_by_w2)
        .mul_add(over_d_s_dot_by_9, -alpha_S_in_axle_base_3_by_w2 * g_s_dot_by_3);
    // d(s')/d(w3) = -over_D_s_dot*b_alpha_W_3_by_w3/9 - G_s_dot*alpha_S_in_axle_base_3_by_w3/3
    let s_dot_by_w3_value = (-b_alpha_W_3_by_w3)
        .mul_add(over_d_s_dot_by_9, -alpha_S_in_axle_base_3_by_w3 * g_s_dot_by_3);
    // d(s')/d(s) = -G_s_dot*alpha_S_in_axle_base_3_by_s/3
    let s_dot_by_s_value = -alpha_S_in_axle_base_3_by_s * g_s_dot_by_3;
    let zero = S::int(0);
    [
        [
            zero, e0_dot_by_e1_value, e0_dot_by_e2_value, e0_dot_by_e3_value, zero,
            e0_dot_by_w1_value, e0_dot_by_w2_value, e0_dot_by_w3_value, zero,
        ],
        [
            e1_dot_by_e0_value, zero, e1_dot_by_e2_value, e1_dot_by_e3_value, zero,
            e1_dot_by_w1_value, e1_dot_by_w2_value, e1_dot_by_w3_value, zero,
        ],
        [
            e2_dot_by_e0_value, e2_dot_by_e1_value, zero, e2_dot_by_e3_value, zero,
            e2_dot_by_w1_value, e2_dot_by_w2_value, e2_dot_by_w3_value, zero,
        ],
        [
            e3_dot_by_e0_value, e3_dot_by_e1_value, e3_dot_by_e2_value, zero, zero,
            e3_dot_by_w1_value, e3_dot_by_w2_value, e3_dot_by_w3_value, zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, phi_dot_by_s_value],
        [
            zero, zero, zero, zero, w1_dot_by_phi_value, w1_dot_by_w1_value, w1_dot_by_w2_value,
            w1_dot_by_w3_value, w1_dot_by_s_value,
        ],
        [
            zero, zero, zero, zero, w2_dot_by_phi_value, w2_dot_by_w1_value, w2_dot_by_w2_value,
            w2_dot_by_w3_value, w2_dot_by_s_value,
        ],
        [
            zero, zero, zero, zero, w3_dot_by_phi, w3_dot_by_w1, w3_dot_by_w2, w3_dot_by_w3,
            w3_dot_by_s,
        ],
        [
            zero, zero, zero, zero, s_dot_by_phi_value, s_dot_by_w1_value, s_dot_by_w2_value,
            s_dot_by_w3_value, s_dot_by_s_value,
        ],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 36 convolutions and 138 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 9]],
    history: &mut [Factors<S, 40>],
) {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0_0, e1_0, e2_0, e3_0, phi_0, w1_0, w2_0, w3_0, s_0] = series[0];
    // Shared terms.
    let weight_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let weight_of__2 = S::int(1) / (S::int(3) + weight_of_);
    // 3*C + 2*K
    let c_times_3_plus_k_doubled = K.mul_add(S::int(2), S::int(3) * C);
    // C + K
    let c_plus_k = C + K;
    // 2*B + 2*C + K
    let weight_9_of_b_c_k = C.mul_add(S::int(2), S::int(2) * B) + K;
    // 3*B*C + K*(2*B + 2*C + K)
    let weight_9_of_b_c_k_2 = K.mul_add(weight_9_of_b_c_k, S::int(3) * B * C);
    // 3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K))
    let weight_11_of_a_b_c_k = K * (C * K + A * weight_9_of_b_c_k + B * C.mul_add(S::int(2), K))
        + S::int(3) * A * B * C;
    // Constant in time.
    // weight = 3/(3 + sqrt(3)) - 3
    let weight = weight_of__2.mul_add(S::int(3), -S::int(3));
    // weight_2 = 3/(3 + sqrt(3))
    let weight_2 = S::int(3) * weight_of__2;
    // sqrt_3 = sqrt(3)
    let sqrt_3 = weight_of_;
    // minus_k = -K
    let minus_k = -K;
    // weight_3 = 9*T
    let weight_3 = S::int(9) * T;
    // j_minus_k = J - K
    let j_minus_k = J - K;
    // minus_3_k = -3*K
    let minus_3_k = -S::int(3) * K;
    // weight_4 = 3*K
    let weight_4 = S::int(3) * K;
    // weight_5 = 27*B
    let weight_5 = S::int(27) * B;
    // minus_27_a = -27*A
    let minus_27_a = -S::int(27) * A;
    // minus_sqrt_3 = -sqrt(3)
    let minus_sqrt_3 = -weight_of_;
    // weight_6 = 27*A
    let weight_6 = S::int(27) * A;
    // minus_27_c = -27*C
    let minus_27_c = -S::int(27) * C;
    // k_by_3_c_plus_2_k = K/(3*C + 2*K)
    let k_by_3_c_plus_2_k = K / c_times_3_plus_k_doubled;
    // minus_3_by_3_plus_sqrt_3 = -3/(3 + sqrt(3))
    let minus_3_by_3_plus_sqrt_3 = -S::int(3) * weight_of__2;
    // weight_7 = 27*C
    let weight_7 = S::int(27) * C;
    // minus_27_b = -27*B
    let minus_27_b = -S::int(27) * B;
    // weight_8 = 3 - 3/(3 + sqrt(3))
    let weight_8 = (-weight_of__2).mul_add(S::int(3), S::int(3));
    // weight_9 = K*(C + K)/(3*B*C + K*(2*B + 2*C + K))
    let weight_9 = K * c_plus_k / weight_9_of_b_c_k_2;
    // weight_10 = -(3*C + 2*K)/(27*(3*B*C + K*(2*B + 2*C + K)))
    let weight_10 = -S::ratio(1, 27) * c_times_3_plus_k_doubled / weight_9_of_b_c_k_2;
    // weight_11 = -K*(C + K)/(27*(3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K))))
    let weight_11 = -S::ratio(1, 27) * K * c_plus_k / weight_11_of_a_b_c_k;
    // weight_12 = -1/(9*(3*C + 2*K))
    let weight_12 = -S::ratio(1, 9) / c_times_3_plus_k_doubled;
    // weight_13 = -K*(3*B*C + K*(2*B + 2*C + K))/(27*(3*C + 2*K)*(3*A*B*C + K*(C*K + A*(2*B + 2*C + K) +
    //   B*(2*C + K))))
    let weight_13 = -S::ratio(1, 27) * K * weight_9_of_b_c_k_2
        / (c_times_3_plus_k_doubled * weight_11_of_a_b_c_k);
    // weight_14 = 1/(9*J)
    let weight_14 = S::ratio(1, 9) / J;
    // minus_sqrt_3_by_3 = -sqrt(3)/3
    let minus_sqrt_3_by_3 = -S::ratio(1, 3) * weight_of_;
    // weight_15 = sqrt(3)*(3*B*C + K*(2*B + 2*C + K))/(81*(3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C +
    //   K))))
    let weight_15 = S::ratio(1, 81) * weight_of_ * weight_9_of_b_c_k_2 / weight_11_of_a_b_c_k;
    // weight_16 = -(3*B*C + K*(2*B + 2*C + K))/(27*(3*A*B*C + K*(C*K + A*(2*B + 2*C + K) + B*(2*C + K))))
    let weight_16 = -S::ratio(1, 27) * weight_9_of_b_c_k_2 / weight_11_of_a_b_c_k;
    // Order 0.
    let w_S_in_axle_base_1_of_w1_w2_w3_0 = w3_0
        .mul_add(sqrt_3, w2_0.mul_add(weight_2, weight * w1_0));
    let w_S_in_axle_base_2_of_w1_w2_w3_0 = w2_0
        .mul_add(weight, w1_0.mul_add(weight_2, sqrt_3 * w3_0));
    let w_S_in_axle_base_3_of_w1_w2_w3_0 = w2_0
        .mul_add(sqrt_3, w1_0.mul_add(sqrt_3, sqrt_3 * w3_0));
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let w_axle_base_in_W_turn1_1_of_w1_w2_w3_0 = cos_phi_0 * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_1_of_w1_w2_w3_2_0 = sin_phi_0 * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_1_of_place_0 = w_axle_base_in_W_turn1_1_of_w1_w2_w3_0
        + w_axle_base_in_W_turn1_1_of_w1_w2_w3_2_0;
    let w_axle_base_in_W_turn1_2_of_w1_w2_w3_0 = sin_phi_0 * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_2_of_w1_w2_w3_2_0 = cos_phi_0 * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_2_of_place_0 = w_axle_base_in_W_turn1_2_of_w1_w2_w3_0
        - w_axle_base_in_W_turn1_2_of_w1_w2_w3_2_0;
    let w_W_turn1_3_of_s_0 = S::int(3) * s_0 + w_S_in_axle_base_3_of_w1_w2_w3_0;
    let s_cos_phi_0 = s_0 * cos_phi_0;
    let alpha_W_turn1_in_axle_base_1_of_s_0 = w_axle_base_in_W_turn1_2_of_place_0 * s_cos_phi_0;
    let s_sin_phi_0 = s_0 * sin_phi_0;
    let alpha_W_turn1_in_axle_base_1_of_s_2_0 = w_axle_base_in_W_turn1_1_of_place_0 * s_sin_phi_0;
    let alpha_W_turn1_in_axle_base_2_of_s_0 = w_axle_base_in_W_turn1_2_of_place_0 * s_sin_phi_0;
    let alpha_W_turn1_in_axle_base_2_of_s_2_0 = w_axle_base_in_W_turn1_1_of_place_0 * s_cos_phi_0;
    let b_alpha_W_3_of_w1_w2_w3_0 = w_S_in_axle_base_1_of_w1_w2_w3_0
        * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let b_alpha_W_3_of_w1_w2_w3_2_0 = w_S_in_axle_base_2_of_w1_w2_w3_0
        * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let b_alpha_W_3_of_place_0 = b_alpha_W_3_of_w1_w2_w3_2_0
        .mul_add(minus_k, K * b_alpha_W_3_of_w1_w2_w3_0);
    let b_s_dot_of_place_0 = weight_3 - b_alpha_W_3_of_place_0;
    let b_alpha_W_2_of_w1_w2_w3_0 = w_S_in_axle_base_3_of_w1_w2_w3_0
        * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let b_alpha_W_2_of_place_0 = w_W_turn1_3_of_s_0
        .mul_add(j_minus_k, K * w_S_in_axle_base_3_of_w1_w2_w3_0);
    let b_alpha_W_2_of_w1_w2_w3_2_0 = w_S_in_axle_base_1_of_w1_w2_w3_0 * b_alpha_W_2_of_place_0;
    let b_of_place_0 = alpha_W_turn1_in_axle_base_2_of_s_2_0
        .mul_add(
            minus_3_k,
            alpha_W_turn1_in_axle_base_2_of_s_0
                .mul_add(
                    minus_3_k,
                    K * b_alpha_W_2_of_w1_w2_w3_0 - b_alpha_W_2_of_w1_w2_w3_2_0,
                ),
        );
    let b_alpha_W_1_of_w1_w2_w3_0 = w_S_in_axle_base_3_of_w1_w2_w3_0
        * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let b_alpha_W_1_of_w1_w2_w3_2_0 = w_S_in_axle_base_2_of_w1_w2_w3_0 * b_alpha_W_2_of_place_0;
    let b_2_of_place_0 = alpha_W_turn1_in_axle_base_1_of_s_2_0
        .mul_add(
            minus_3_k,
            alpha_W_turn1_in_axle_base_1_of_s_0
                .mul_add(
                    weight_4,
                    K * b_alpha_W_1_of_w1_w2_w3_0 - b_alpha_W_1_of_w1_w2_w3_2_0,
                ),
        );
    let b_alpha_S_in_axle_base_3_of_place_0 = b_alpha_W_3_of_place_0 + b_s_dot_of_place_0;
    let w1_w2_0 = w1_0 * w2_0;
    let w1_w2_2_0 = w2_0 * w1_0;
    let b_w3_dot_of_w1_w2_0 = b_2_of_place_0
        .mul_add(
            minus_sqrt_3,
            b_of_place_0
                .mul_add(
                    sqrt_3,
                    b_alpha_S_in_axle_base_3_of_place_0
                        .mul_add(
                            sqrt_3,
                            w1_w2_2_0.mul_add(minus_27_a, weight_5 * w1_w2_0),
                        ),
                ),
        );
    let w1_w3_0 = w3_0 * w1_0;
    let w1_w3_2_0 = w1_0 * w3_0;
    let b_w2_dot_of_w1_w3_0 = b_w3_dot_of_w1_w2_0
        .mul_add(
            k_by_3_c_plus_2_k,
            b_2_of_place_0
                .mul_add(
                    minus_3_by_3_plus_sqrt_3,
                    b_of_place_0
                        .mul_add(
                            weight,
                            b_alpha_S_in_axle_base_3_of_place_0
                                .mul_add(
                                    sqrt_3,
                                    w1_w3_2_0.mul_add(minus_27_c, weight_6 * w1_w3_0),
                                ),
                        ),
                ),
        );
    let w2_w3_0 = w2_0 * w3_0;
    let w2_w3_2_0 = w3_0 * w2_0;
    let b_w1_dot_of_w2_w3_0 = b_w2_dot_of_w1_w3_0
        .mul_add(
            weight_9,
            b_w3_dot_of_w1_w2_0
                .mul_add(
                    k_by_3_c_plus_2_k,
                    b_of_place_0
                        .mul_add(
                            weight_2,
                            b_2_of_place_0
                                .mul_add(
                                    weight_8,
                                    b_alpha_S_in_axle_base_3_of_place_0
                                        .mul_add(
                                            sqrt_3,
                                            w2_w3_2_0.mul_add(minus_27_b, weight_7 * w2_w3_0),
                                        ),
                                ),
                        ),
                ),
        );
    let w2_dot_2_0 = b_w1_dot_of_w2_w3_0
        .mul_add(weight_11, weight_10 * b_w2_dot_of_w1_w3_0);
    let w3_dot_2_0 = w2_dot_2_0
        .mul_add(
            k_by_3_c_plus_2_k,
            b_w1_dot_of_w2_w3_0.mul_add(weight_13, weight_12 * b_w3_dot_of_w1_w2_0),
        );
    let s_dot_2_0 = w3_dot_2_0
        .mul_add(
            minus_sqrt_3_by_3,
            w2_dot_2_0
                .mul_add(
                    minus_sqrt_3_by_3,
                    b_w1_dot_of_w2_w3_0
                        .mul_add(weight_15, weight_14 * b_s_dot_of_place_0),
                ),
        );
    let e1_w1_0 = e1_0 * w1_0;
    let e2_w2_0 = e2_0 * w2_0;
    let e3_w3_0 = e3_0 * w3_0;
    let e0_dot_2_0 = e3_w3_0
        .mul_add(
            -S::ratio(1, 2),
            e2_w2_0.mul_add(-S::ratio(1, 2), -S::ratio(1, 2) * e1_w1_0),
        );
    let e0_w1_0 = e0_0 * w1_0;
    let e3_w2_0 = e3_0 * w2_0;
    let e2_w3_0 = e2_0 * w3_0;
    let e1_dot_2_0 = e2_w3_0
        .mul_add(
            S::ratio(1, 2),
            e3_w2_0.mul_add(-S::ratio(1, 2), S::ratio(1, 2) * e0_w1_0),
        );
    let e3_w1_0 = e3_0 * w1_0;
    let e0_w2_0 = e0_0 * w2_0;
    let e1_w3_0 = e1_0 * w3_0;
    let e2_dot_2_0 = e1_w3_0
        .mul_add(
            -S::ratio(1, 2),
            e0_w2_0.mul_add(S::ratio(1, 2), S::ratio(1, 2) * e3_w1_0),
        );
    let e2_w1_0 = e2_0 * w1_0;
    let e1_w2_0 = e1_0 * w2_0;
    let e0_w3_0 = e0_0 * w3_0;
    let e3_dot_2_0 = e0_w3_0
        .mul_add(
            S::ratio(1, 2),
            e1_w2_0.mul_add(S::ratio(1, 2), -S::ratio(1, 2) * e2_w1_0),
        );
    // Order 1: the rates, and what follows from them.
    let e0_1 = e0_dot_2_0;
    let e1_1 = e1_dot_2_0;
    let e2_1 = e2_dot_2_0;
    let e3_1 = e3_dot_2_0;
    let phi_1 = s_0;
    let w1_1 = weight_16 * b_w1_dot_of_w2_w3_0;
    let w2_1 = w2_dot_2_0;
    let w3_1 = w3_dot_2_0;
    let s_1 = s_dot_2_0;
    if series.len() > 1 {
        series[1] = [e0_1, e1_1, e2_1, e3_1, phi_1, w1_1, w2_1, w3_1, s_1];
    }
    let w_S_in_axle_base_1_of_w1_w2_w3_1 = w3_1
        .mul_add(sqrt_3, w2_1.mul_add(weight_2, weight * w1_1));
    let w_S_in_axle_base_2_of_w1_w2_w3_1 = w2_1
        .mul_add(weight, w1_1.mul_add(weight_2, sqrt_3 * w3_1));
    let w_S_in_axle_base_3_of_w1_w2_w3_1 = w2_1
        .mul_add(sqrt_3, w1_1.mul_add(sqrt_3, sqrt_3 * w3_1));
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let w_axle_base_in_W_turn1_1_of_w1_w2_w3_1 = cos_phi_1
        .mul_add(
            w_S_in_axle_base_1_of_w1_w2_w3_0,
            w_S_in_axle_base_1_of_w1_w2_w3_1 * cos_phi_0,
        );
    let w_axle_base_in_W_turn1_1_of_w1_w2_w3_2_1 = sin_phi_1
        .mul_add(
            w_S_in_axle_base_2_of_w1_w2_w3_0,
            w_S_in_axle_base_2_of_w1_w2_w3_1 * sin_phi_0,
        );
    let w_axle_base_in_W_turn1_1_of_place_1 = w_axle_base_in_W_turn1_1_of_w1_w2_w3_1
        + w_axle_base_in_W_turn1_1_of_w1_w2_w3_2_1;
    let w_axle_base_in_W_turn1_2_of_w1_w2_w3_1 = sin_phi_1
        .mul_add(
            w_S_in_axle_base_1_of_w1_w2_w3_0,
            w_S_in_axle_base_1_of_w1_w2_w3_1 * sin_phi_0,
        );
    let w_axle_base_in_W_turn1_2_of_w1_w2_w3_2_1 = cos_phi_1
        .mul_add(
            w_S_in_axle_base_2_of_w1_w2_w3_0,
            w_S_in_axle_base_2_of_w1_w2_w3_1 * cos_phi_0,
        );
    let w_axle_base_in_W_turn1_2_of_place_1 = w_axle_base_in_W_turn1_2_of_w1_w2_w3_1
        - w_axle_base_in_W_turn1_2_of_w1_w2_w3_2_1;
    let w_W_turn1_3_of_s_1 = S::int(3) * s_1 + w_S_in_axle_base_3_of_w1_w2_w3_1;
    let s_cos_phi_1 = cos_phi_1.mul_add(s_0, s_1 * cos_phi_0);
    let alpha_W_turn1_in_axle_base_1_of_s_1 = w_axle_base_in_W_turn1_2_of_place_1
        .mul_add(s_cos_phi_0, s_cos_phi_1 * w_axle_base_in_W_turn1_2_of_place_0);
    let s_sin_phi_1 = sin_phi_1.mul_add(s_0, s_1 * sin_phi_0);
    let alpha_W_turn1_in_axle_base_1_of_s_2_1 = w_axle_base_in_W_turn1_1_of_place_1
        .mul_add(s_sin_phi_0, s_sin_phi_1 * w_axle_base_in_W_turn1_1_of_place_0);
    let alpha_W_turn1_in_axle_base_2_of_s_1 = w_axle_base_in_W_turn1_2_of_place_1
        .mul_add(s_sin_phi_0, s_sin_phi_1 * w_axle_base_in_W_turn1_2_of_place_0);
    let alpha_W_turn1_in_axle_base_2_of_s_2_1 = w_axle_base_in_W_turn1_1_of_place_1
        .mul_add(s_cos_phi_0, s_cos_phi_1 * w_axle_base_in_W_turn1_1_of_place_0);
    let b_alpha_W_3_of_w1_w2_w3_1 = w_S_in_axle_base_2_of_w1_w2_w3_1
        .mul_add(
            w_S_in_axle_base_1_of_w1_w2_w3_0,
            w_S_in_axle_base_1_of_w1_w2_w3_1 * w_S_in_axle_base_2_of_w1_w2_w3_0,
        );
    let b_alpha_W_3_of_w1_w2_w3_2_1 = w_S_in_axle_base_1_of_w1_w2_w3_1
        .mul_add(
            w_S_in_axle_base_2_of_w1_w2_w3_0,
            w_S_in_axle_base_2_of_w1_w2_w3_1 * w_S_in_axle_base_1_of_w1_w2_w3_0,
        );
    let b_alpha_W_3_of_place_1 = b_alpha_W_3_of_w1_w2_w3_2_1
        .mul_add(minus_k, K * b_alpha_W_3_of_w1_w2_w3_1);
    let b_s_dot_of_place_1 = -b_alpha_W_3_of_place_1;
    let b_alpha_W_2_of_w1_w2_w3_1 = w_S_in_axle_base_1_of_w1_w2_w3_1
        .mul_add(
            w_S_in_axle_base_3_of_w1_w2_w3_0,
            w_S_in_axle_base_3_of_w1_w2_w3_1 * w_S_in_axle_base_1_of_w1_w2_w3_0,
        );
    let b_alpha_W_2_of_place_1 = w_W_turn1_3_of_s_1
        .mul_add(j_minus_k, K * w_S_in_axle_base_3_of_w1_w2_w3_1);
    let b_alpha_W_2_of_w1_w2_w3_2_1 = b_alpha_W_2_of_place_1
        .mul_add(
            w_S_in_axle_base_1_of_w1_w2_w3_0,
            w_S_in_axle_base_1_of_w1_w2_w3_1 * b_alpha_W_2_of_place_0,
        );
    let b_of_place_1 = alpha_W_turn1_in_axle_base_2_of_s_2_1
        .mul_add(
            minus_3_k,
            alpha_W_turn1_in_axle_base_2_of_s_1
                .mul_add(
                    minus_3_k,
                    K * b_alpha_W_2_of_w1_w2_w3_1 - b_alpha_W_2_of_w1_w2_w3_2_1,
                ),
        );
    let b_alpha_W_1_of_w1_w2_w3_1 = w_S_in_axle_base_2_of_w1_w2_w3_1
        .mul_add(
            w_S_in_axle_base_3_of_w1_w2_w3_0,
            w_S_in_axle_base_3_of_w1_w2_w3_1 * w_S_in_axle_base_2_of_w1_w2_w3_0,
        );
    let b_alpha_W_1_of_w1_w2_w3_2_1 = b_alpha_W_2_of_place_1
        .mul_add(
            w_S_in_axle_base_2_of_w1_w2_w3_0,
            w_S_in_axle_base_2_of_w1_w2_w3_1 * b_alpha_W_2_of_place_0,
        );
    let b_2_of_place_1 = alpha_W_turn1_in_axle_base_1_of_s_2_1
        .mul_add(
            minus_3_k,
            alpha_W_turn1_in_axle_base_1_of_s_1
                .mul_add(
                    weight_4,
                    K * b_alpha_W_1_of_w1_w2_w3_1 - b_alpha_W_1_of_w1_w2_w3_2_1,
                ),
        );
    let b_alpha_S_in_axle_base_3_of_place_1 = b_alpha_W_3_of_place_1 + b_s_dot_of_place_1;
    let w1_w2_1 = w2_1.mul_add(w1_0, w1_1 * w2_0);
    let w1_w2_2_1 = w1_1.mul_add(w2_0, w2_1 * w1_0);
    let b_w3_dot_of_w1_w2_1 = b_2_of_place_1
        .mul_add(
            minus_sqrt_3,
            b_of_place_1
                .mul_add(
                    sqrt_3,
                    b_alpha_S_in_axle_base_3_of_place_1
                        .mul_add(
                            sqrt_3,
                            w1_w2_2_1.mul_add(minus_27_a, weight_5 * w1_w2_1),
                        ),
                ),
        );
    let w1_w3_1 = w1_1.mul_add(w3_0, w3_1 * w1_0);
    let w1_w3_2_1 = w3_1.mul_add(w1_0, w1_1 * w3_0);
    let b_w2_dot_of_w1_w3_1 = b_w3_dot_of_w1_w2_1
        .mul_add(
            k_by_3_c_plus_2_k,
            b_2_of_place_1
                .mul_add(
                    minus_3_by_3_plus_sqrt_3,
                    b_of_place_1
                        .mul_add(
                            weight,
                            b_alpha_S_in_axle_base_3_of_place_1
                                .mul_add(
                                    sqrt_3,
                                    w1_w3_2_1.mul_add(minus_27_c, weight_6 * w1_w3_1),
                                ),
                        ),
                ),
        );
    let w2_w3_1 = w3_1.mul_add(w2_0, w2_1 * w3_0);
    let w2_w3_2_1 = w2_1.mul_add(w3_0, w3_1 * w2_0);
    let b_w1_dot_of_w2_w3_1 = b_w2_dot_of_w1_w3_1
        .mul_add(
            weight_9,
            b_w3_dot_of_w1_w2_1
                .mul_add(
                    k_by_3_c_plus_2_k,
                    b_of_place_1
                        .mul_add(
                            weight_2,
                            b_2_of_place_1
                                .mul_add(
                                    weight_8,
                                    b_alpha_S_in_axle_base_3_of_place_1
                                        .mul_add(
                                            sqrt_3,
                                            w2_w3_2_1.mul_add(minus_27_b, weight_7 * w2_w3_1),
                                        ),
                                ),
                        ),
                ),
        );
    let w2_dot_2_1 = b_w1_dot_of_w2_w3_1
        .mul_add(weight_11, weight_10 * b_w2_dot_of_w1_w3_1);
    let w3_dot_2_1 = w2_dot_2_1
        .mul_add(
            k_by_3_c_plus_2_k,
            b_w1_dot_of_w2_w3_1.mul_add(weight_13, weight_12 * b_w3_dot_of_w1_w2_1),
        );
    let s_dot_2_1 = w3_dot_2_1
        .mul_add(
            minus_sqrt_3_by_3,
            w2_dot_2_1
                .mul_add(
                    minus_sqrt_3_by_3,
                    b_w1_dot_of_w2_w3_1
                        .mul_add(weight_15, weight_14 * b_s_dot_of_place_1),
                ),
        );
    let e1_w1_1 = w1_1.mul_add(e1_0, e1_1 * w1_0);
    let e2_w2_1 = w2_1.mul_add(e2_0, e2_1 * w2_0);
    let e3_w3_1 = w3_1.mul_add(e3_0, e3_1 * w3_0);
    let e0_dot_2_1 = e3_w3_1
        .mul_add(
            -S::ratio(1, 2),
            e2_w2_1.mul_add(-S::ratio(1, 2), -S::ratio(1, 2) * e1_w1_1),
        );
    let e0_w1_1 = w1_1.mul_add(e0_0, e0_1 * w1_0);
    let e3_w2_1 = w2_1.mul_add(e3_0, e3_1 * w2_0);
    let e2_w3_1 = w3_1.mul_add(e2_0, e2_1 * w3_0);
    let e1_dot_2_1 = e2_w3_1
        .mul_add(
            S::ratio(1, 2),
            e3_w2_1.mul_add(-S::ratio(1, 2), S::ratio(1, 2) * e0_w1_1),
        );
    let e3_w1_1 = w1_1.mul_add(e3_0, e3_1 * w1_0);
    let e0_w2_1 = w2_1.mul_add(e0_0, e0_1 * w2_0);
    let e1_w3_1 = w3_1.mul_add(e1_0, e1_1 * w3_0);
    let e2_dot_2_1 = e1_w3_1
        .mul_add(
            -S::ratio(1, 2),
            e0_w2_1.mul_add(S::ratio(1, 2), S::ratio(1, 2) * e3_w1_1),
        );
    let e2_w1_1 = w1_1.mul_add(e2_0, e2_1 * w1_0);
    let e1_w2_1 = w2_1.mul_add(e1_0, e1_1 * w2_0);
    let e0_w3_1 = w3_1.mul_add(e0_0, e0_1 * w3_0);
    let e3_dot_2_1 = e0_w3_1
        .mul_add(
            S::ratio(1, 2),
            e1_w2_1.mul_add(S::ratio(1, 2), -S::ratio(1, 2) * e2_w1_1),
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                phi_1, phi_1, cos_phi_1, sin_phi_1, sin_phi_1, cos_phi_1, s_1,
                w_axle_base_in_W_turn1_2_of_place_1, s_1, w_axle_base_in_W_turn1_1_of_place_1,
                w_axle_base_in_W_turn1_2_of_place_1, w_axle_base_in_W_turn1_1_of_place_1,
                w_S_in_axle_base_1_of_w1_w2_w3_1, w_S_in_axle_base_2_of_w1_w2_w3_1,
                w_S_in_axle_base_3_of_w1_w2_w3_1, w_S_in_axle_base_1_of_w1_w2_w3_1,
                w_S_in_axle_base_3_of_w1_w2_w3_1, w_S_in_axle_base_2_of_w1_w2_w3_1, w1_1, w2_1,
                w3_1, w1_1, w2_1, w3_1, e1_1, e2_1, e3_1, e0_1, e3_1, e2_1, e3_1, e0_1, e1_1, e2_1,
                e1_1, e0_1,
            ]),
            padded([
                cos_phi_1, sin_phi_1, w_S_in_axle_base_1_of_w1_w2_w3_1,
                w_S_in_axle_base_2_of_w1_w2_w3_1, w_S_in_axle_base_1_of_w1_w2_w3_1,
                w_S_in_axle_base_2_of_w1_w2_w3_1, cos_phi_1, s_cos_phi_1, sin_phi_1, s_sin_phi_1,
                s_sin_phi_1, s_cos_phi_1, w_S_in_axle_base_2_of_w1_w2_w3_1,
                w_S_in_axle_base_1_of_w1_w2_w3_1, w_S_in_axle_base_1_of_w1_w2_w3_1,
                b_alpha_W_2_of_place_1, w_S_in_axle_base_2_of_w1_w2_w3_1, b_alpha_W_2_of_place_1,
                w2_1, w1_1, w1_1, w3_1, w3_1, w2_1, w1_1, w2_1, w3_1, w1_1, w2_1, w3_1, w1_1, w2_1,
                w3_1, w1_1, w2_1, w3_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut e0_last = e0_1;
    let mut e1_last = e1_1;
    let mut e2_last = e2_1;
    let mut e3_last = e3_1;
    let mut phi_last = phi_1;
    let mut w1_last = w1_1;
    let mut w2_last = w2_1;
    let mut w3_last = w3_1;
    let mut s_last = s_1;
    let mut w_S_in_axle_base_1_of_w1_w2_w3_last = w_S_in_axle_base_1_of_w1_w2_w3_1;
    let mut w_S_in_axle_base_2_of_w1_w2_w3_last = w_S_in_axle_base_2_of_w1_w2_w3_1;
    let mut w_S_in_axle_base_3_of_w1_w2_w3_last = w_S_in_axle_base_3_of_w1_w2_w3_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut w_axle_base_in_W_turn1_1_of_place_last = w_axle_base_in_W_turn1_1_of_place_1;
    let mut w_axle_base_in_W_turn1_2_of_place_last = w_axle_base_in_W_turn1_2_of_place_1;
    let mut s_cos_phi_last = s_cos_phi_1;
    let mut s_sin_phi_last = s_sin_phi_1;
    let mut b_alpha_W_2_of_place_last = b_alpha_W_2_of_place_1;
    let mut next = [S::int(0); 40];
    // Rates at order k - 1.
    let mut e0_rate = e0_dot_2_1;
    let mut e1_rate = e1_dot_2_1;
    let mut e2_rate = e2_dot_2_1;
    let mut e3_rate = e3_dot_2_1;
    let mut phi_rate = s_1;
    let mut w1_rate = weight_16 * b_w1_dot_of_w2_w3_1;
    let mut w2_rate = w2_dot_2_1;
    let mut w3_rate = w3_dot_2_1;
    let mut s_rate = s_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let e0 = e0_rate * over_k;
        let e1 = e1_rate * over_k;
        let e2 = e2_rate * over_k;
        let e3 = e3_rate * over_k;
        let phi = phi_rate * over_k;
        let w1 = w1_rate * over_k;
        let w2 = w2_rate * over_k;
        let w3 = w3_rate * over_k;
        let s = s_rate * over_k;
        series[order] = [e0, e1, e2, e3, phi, w1, w2, w3, s];
        if order + 1 == series.len() {
            break;
        }
        let count = S::int(order as i64);
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            padded([
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[0]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[1]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        cos_phi_last.mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[2]),
                    ),
                sin_phi_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        sin_phi_last.mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[3]),
                    ),
                sin_phi_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        sin_phi_last.mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[4]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        cos_phi_last.mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[5]),
                    ),
                s_1.mul_add(cos_phi_last, s_last.mul_add(cos_phi_1, next[6])),
                w_axle_base_in_W_turn1_2_of_place_1
                    .mul_add(
                        s_cos_phi_last,
                        w_axle_base_in_W_turn1_2_of_place_last
                            .mul_add(s_cos_phi_1, next[7]),
                    ),
                s_1.mul_add(sin_phi_last, s_last.mul_add(sin_phi_1, next[8])),
                w_axle_base_in_W_turn1_1_of_place_1
                    .mul_add(
                        s_sin_phi_last,
                        w_axle_base_in_W_turn1_1_of_place_last
                            .mul_add(s_sin_phi_1, next[9]),
                    ),
                w_axle_base_in_W_turn1_2_of_place_1
                    .mul_add(
                        s_sin_phi_last,
                        w_axle_base_in_W_turn1_2_of_place_last
                            .mul_add(s_sin_phi_1, next[10]),
                    ),
                w_axle_base_in_W_turn1_1_of_place_1
                    .mul_add(
                        s_cos_phi_last,
                        w_axle_base_in_W_turn1_1_of_place_last
                            .mul_add(s_cos_phi_1, next[11]),
                    ),
                w_S_in_axle_base_1_of_w1_w2_w3_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        w_S_in_axle_base_1_of_w1_w2_w3_last
                            .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[12]),
                    ),
                w_S_in_axle_base_2_of_w1_w2_w3_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        w_S_in_axle_base_2_of_w1_w2_w3_last
                            .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[13]),
                    ),
                w_S_in_axle_base_3_of_w1_w2_w3_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        w_S_in_axle_base_3_of_w1_w2_w3_last
                            .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[14]),
                    ),
                w_S_in_axle_base_1_of_w1_w2_w3_1
                    .mul_add(
                        b_alpha_W_2_of_place_last,
                        w_S_in_axle_base_1_of_w1_w2_w3_last
                            .mul_add(b_alpha_W_2_of_place_1, next[15]),
                    ),
                w_S_in_axle_base_3_of_w1_w2_w3_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        w_S_in_axle_base_3_of_w1_w2_w3_last
                            .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[16]),
                    ),
                w_S_in_axle_base_2_of_w1_w2_w3_1
                    .mul_add(
                        b_alpha_W_2_of_place_last,
                        w_S_in_axle_base_2_of_w1_w2_w3_last
                            .mul_add(b_alpha_W_2_of_place_1, next[17]),
                    ),
                w1_1.mul_add(w2_last, w1_last.mul_add(w2_1, next[18])),
                w2_1.mul_add(w1_last, w2_last.mul_add(w1_1, next[19])),
                w3_1.mul_add(w1_last, w3_last.mul_add(w1_1, next[20])),
                w1_1.mul_add(w3_last, w1_last.mul_add(w3_1, next[21])),
                w2_1.mul_add(w3_last, w2_last.mul_add(w3_1, next[22])),
                w3_1.mul_add(w2_last, w3_last.mul_add(w2_1, next[23])),
                e1_1.mul_add(w1_last, e1_last.mul_add(w1_1, next[24])),
                e2_1.mul_add(w2_last, e2_last.mul_add(w2_1, next[25])),
                e3_1.mul_add(w3_last, e3_last.mul_add(w3_1, next[26])),
                e0_1.mul_add(w1_last, e0_last.mul_add(w1_1, next[27])),
                e3_1.mul_add(w2_last, e3_last.mul_add(w2_1, next[28])),
                e2_1.mul_add(w3_last, e2_last.mul_add(w3_1, next[29])),
                e3_1.mul_add(w1_last, e3_last.mul_add(w1_1, next[30])),
                e0_1.mul_add(w2_last, e0_last.mul_add(w2_1, next[31])),
                e1_1.mul_add(w3_last, e1_last.mul_add(w3_1, next[32])),
                e2_1.mul_add(w1_last, e2_last.mul_add(w1_1, next[33])),
                e1_1.mul_add(w2_last, e1_last.mul_add(w2_1, next[34])),
                e0_1.mul_add(w3_last, e0_last.mul_add(w3_1, next[35])),
            ])
        };
        // w_S_in_axle_base_1_of_w1_w2_w3 = weight*w1 + weight_2*w2 + sqrt_3*w3
        let w_S_in_axle_base_1_of_w1_w2_w3 = w3
            .mul_add(sqrt_3, w2.mul_add(weight_2, weight * w1));
        // w_S_in_axle_base_2_of_w1_w2_w3 = sqrt_3*w3 + weight_2*w1 + weight*w2
        let w_S_in_axle_base_2_of_w1_w2_w3 = w2
            .mul_add(weight, w1.mul_add(weight_2, sqrt_3 * w3));
        // w_S_in_axle_base_3_of_w1_w2_w3 = sqrt_3*w3 + sqrt_3*w1 + sqrt_3*w2
        let w_S_in_axle_base_3_of_w1_w2_w3 = w2
            .mul_add(sqrt_3, w1.mul_add(sqrt_3, sqrt_3 * w3));
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // w_axle_base_in_W_turn1_1_of_w1_w2_w3 = cos_phi*w_S_in_axle_base_1_of_w1_w2_w3
        let w_axle_base_in_W_turn1_1_of_w1_w2_w3 = cos_phi
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3.mul_add(cos_phi_0, sums[2]),
            );
        // w_axle_base_in_W_turn1_1_of_w1_w2_w3_2 = sin_phi*w_S_in_axle_base_2_of_w1_w2_w3
        let w_axle_base_in_W_turn1_1_of_w1_w2_w3_2 = sin_phi
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3.mul_add(sin_phi_0, sums[3]),
            );
        // w_axle_base_in_W_turn1_1_of_place = w_axle_base_in_W_turn1_1_of_w1_w2_w3 +
        //   w_axle_base_in_W_turn1_1_of_w1_w2_w3_2
        let w_axle_base_in_W_turn1_1_of_place = w_axle_base_in_W_turn1_1_of_w1_w2_w3
            + w_axle_base_in_W_turn1_1_of_w1_w2_w3_2;
        // w_axle_base_in_W_turn1_2_of_w1_w2_w3 = sin_phi*w_S_in_axle_base_1_of_w1_w2_w3
        let w_axle_base_in_W_turn1_2_of_w1_w2_w3 = sin_phi
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3.mul_add(sin_phi_0, sums[4]),
            );
        // w_axle_base_in_W_turn1_2_of_w1_w2_w3_2 = cos_phi*w_S_in_axle_base_2_of_w1_w2_w3
        let w_axle_base_in_W_turn1_2_of_w1_w2_w3_2 = cos_phi
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3.mul_add(cos_phi_0, sums[5]),
            );
        // w_axle_base_in_W_turn1_2_of_place = w_axle_base_in_W_turn1_2_of_w1_w2_w3 -
        //   w_axle_base_in_W_turn1_2_of_w1_w2_w3_2
        let w_axle_base_in_W_turn1_2_of_place = w_axle_base_in_W_turn1_2_of_w1_w2_w3
            - w_axle_base_in_W_turn1_2_of_w1_w2_w3_2;
        // w_W_turn1_3_of_s = 3*s + w_S_in_axle_base_3_of_w1_w2_w3
        let w_W_turn1_3_of_s = S::int(3) * s + w_S_in_axle_base_3_of_w1_w2_w3;
        // s_cos_phi = s*cos_phi
        let s_cos_phi = cos_phi.mul_add(s_0, s.mul_add(cos_phi_0, sums[6]));
        // alpha_W_turn1_in_axle_base_1_of_s = w_axle_base_in_W_turn1_2_of_place*s_cos_phi
        let alpha_W_turn1_in_axle_base_1_of_s = w_axle_base_in_W_turn1_2_of_place
            .mul_add(
                s_cos_phi_0,
                s_cos_phi.mul_add(w_axle_base_in_W_turn1_2_of_place_0, sums[7]),
            );
        // s_sin_phi = s*sin_phi
        let s_sin_phi = sin_phi.mul_add(s_0, s.mul_add(sin_phi_0, sums[8]));
        // alpha_W_turn1_in_axle_base_1_of_s_2 = w_axle_base_in_W_turn1_1_of_place*s_sin_phi
        let alpha_W_turn1_in_axle_base_1_of_s_2 = w_axle_base_in_W_turn1_1_of_place
            .mul_add(
                s_sin_phi_0,
                s_sin_phi.mul_add(w_axle_base_in_W_turn1_1_of_place_0, sums[9]),
            );
        // alpha_W_turn1_in_axle_base_2_of_s = w_axle_base_in_W_turn1_2_of_place*s_sin_phi
        let alpha_W_turn1_in_axle_base_2_of_s = w_axle_base_in_W_turn1_2_of_place
            .mul_add(
                s_sin_phi_0,
                s_sin_phi.mul_add(w_axle_base_in_W_turn1_2_of_place_0, sums[10]),
            );
        // alpha_W_turn1_in_axle_base_2_of_s_2 = w_axle_base_in_W_turn1_1_of_place*s_cos_phi
        let alpha_W_turn1_in_axle_base_2_of_s_2 = w_axle_base_in_W_turn1_1_of_place
            .mul_add(
                s_cos_phi_0,
                s_cos_phi.mul_add(w_axle_base_in_W_turn1_1_of_place_0, sums[11]),
            );
        // b_alpha_W_3_of_w1_w2_w3 = w_S_in_axle_base_1_of_w1_w2_w3*w_S_in_axle_base_2_of_w1_w2_w3
        let b_alpha_W_3_of_w1_w2_w3 = w_S_in_axle_base_2_of_w1_w2_w3
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3
                    .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_0, sums[12]),
            );
        // b_alpha_W_3_of_w1_w2_w3_2 = w_S_in_axle_base_2_of_w1_w2_w3*w_S_in_axle_base_1_of_w1_w2_w3
        let b_alpha_W_3_of_w1_w2_w3_2 = w_S_in_axle_base_1_of_w1_w2_w3
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3
                    .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_0, sums[13]),
            );
        // b_alpha_W_3_of_place = K*b_alpha_W_3_of_w1_w2_w3 + minus_k*b_alpha_W_3_of_w1_w2_w3_2
        let b_alpha_W_3_of_place = b_alpha_W_3_of_w1_w2_w3_2
            .mul_add(minus_k, K * b_alpha_W_3_of_w1_w2_w3);
        // b_s_dot_of_place = weight_3 - b_alpha_W_3_of_place
        let b_s_dot_of_place = -b_alpha_W_3_of_place;
        // b_alpha_W_2_of_w1_w2_w3 = w_S_in_axle_base_3_of_w1_w2_w3*w_S_in_axle_base_1_of_w1_w2_w3
        let b_alpha_W_2_of_w1_w2_w3 = w_S_in_axle_base_1_of_w1_w2_w3
            .mul_add(
                w_S_in_axle_base_3_of_w1_w2_w3_0,
                w_S_in_axle_base_3_of_w1_w2_w3
                    .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_0, sums[14]),
            );
        // b_alpha_W_2_of_place = j_minus_k*w_W_turn1_3_of_s + K*w_S_in_axle_base_3_of_w1_w2_w3
        let b_alpha_W_2_of_place = w_W_turn1_3_of_s
            .mul_add(j_minus_k, K * w_S_in_axle_base_3_of_w1_w2_w3);
        // b_alpha_W_2_of_w1_w2_w3_2 = w_S_in_axle_base_1_of_w1_w2_w3*b_alpha_W_2_of_place
        let b_alpha_W_2_of_w1_w2_w3_2 = b_alpha_W_2_of_place
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3.mul_add(b_alpha_W_2_of_place_0, sums[15]),
            );
        // b_of_place = K*b_alpha_W_2_of_w1_w2_w3 - b_alpha_W_2_of_w1_w2_w3_2 +
        //   minus_3_k*alpha_W_turn1_in_axle_base_2_of_s + minus_3_k*alpha_W_turn1_in_axle_base_2_of_s_2
        let b_of_place = alpha_W_turn1_in_axle_base_2_of_s_2
            .mul_add(
                minus_3_k,
                alpha_W_turn1_in_axle_base_2_of_s
                    .mul_add(
                        minus_3_k,
                        K * b_alpha_W_2_of_w1_w2_w3 - b_alpha_W_2_of_w1_w2_w3_2,
                    ),
            );
        // b_alpha_W_1_of_w1_w2_w3 = w_S_in_axle_base_3_of_w1_w2_w3*w_S_in_axle_base_2_of_w1_w2_w3
        let b_alpha_W_1_of_w1_w2_w3 = w_S_in_axle_base_2_of_w1_w2_w3
            .mul_add(
                w_S_in_axle_base_3_of_w1_w2_w3_0,
                w_S_in_axle_base_3_of_w1_w2_w3
                    .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_0, sums[16]),
            );
        // b_alpha_W_1_of_w1_w2_w3_2 = w_S_in_axle_base_2_of_w1_w2_w3*b_alpha_W_2_of_place
        let b_alpha_W_1_of_w1_w2_w3_2 = b_alpha_W_2_of_place
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3.mul_add(b_alpha_W_2_of_place_0, sums[17]),
            );
        // b_2_of_place = K*b_alpha_W_1_of_w1_w2_w3 - b_alpha_W_1_of_w1_w2_w3_2 +
        //   weight_4*alpha_W_turn1_in_axle_base_1_of_s + minus_3_k*alpha_W_turn1_in_axle_base_1_of_s_2
        let b_2_of_place = alpha_W_turn1_in_axle_base_1_of_s_2
            .mul_add(
                minus_3_k,
                alpha_W_turn1_in_axle_base_1_of_s
                    .mul_add(
                        weight_4,
                        K * b_alpha_W_1_of_w1_w2_w3 - b_alpha_W_1_of_w1_w2_w3_2,
                    ),
            );
        // b_alpha_S_in_axle_base_3_of_place = b_alpha_W_3_of_place + b_s_dot_of_place
        let b_alpha_S_in_axle_base_3_of_place = b_alpha_W_3_of_place + b_s_dot_of_place;
        // w1_w2 = w1*w2
        let w1_w2 = w2.mul_add(w1_0, w1.mul_add(w2_0, sums[18]));
        // w1_w2_2 = w2*w1
        let w1_w2_2 = w1.mul_add(w2_0, w2.mul_add(w1_0, sums[19]));
        // b_w3_dot_of_w1_w2 = weight_5*w1_w2 + minus_27_a*w1_w2_2 + sqrt_3*b_of_place +
        //   minus_sqrt_3*b_2_of_place + sqrt_3*b_alpha_S_in_axle_base_3_of_place
        let b_w3_dot_of_w1_w2 = b_2_of_place
            .mul_add(
                minus_sqrt_3,
                b_of_place
                    .mul_add(
                        sqrt_3,
                        b_alpha_S_in_axle_base_3_of_place
                            .mul_add(
                                sqrt_3,
                                w1_w2_2.mul_add(minus_27_a, weight_5 * w1_w2),
                            ),
                    ),
            );
        // w1_w3 = w3*w1
        let w1_w3 = w1.mul_add(w3_0, w3.mul_add(w1_0, sums[20]));
        // w1_w3_2 = w1*w3
        let w1_w3_2 = w3.mul_add(w1_0, w1.mul_add(w3_0, sums[21]));
        // b_w2_dot_of_w1_w3 = weight_6*w1_w3 + minus_27_c*w1_w3_2 +
        //   sqrt_3*b_alpha_S_in_axle_base_3_of_place + k_by_3_c_plus_2_k*b_w3_dot_of_w1_w2 +
        //   weight*b_of_place + minus_3_by_3_plus_sqrt_3*b_2_of_place
        let b_w2_dot_of_w1_w3 = b_w3_dot_of_w1_w2
            .mul_add(
                k_by_3_c_plus_2_k,
                b_2_of_place
                    .mul_add(
                        minus_3_by_3_plus_sqrt_3,
                        b_of_place
                            .mul_add(
                                weight,
                                b_alpha_S_in_axle_base_3_of_place
                                    .mul_add(
                                        sqrt_3,
                                        w1_w3_2.mul_add(minus_27_c, weight_6 * w1_w3),
                                    ),
                            ),
                    ),
            );
        // w2_w3 = w2*w3
        let w2_w3 = w3.mul_add(w2_0, w2.mul_add(w3_0, sums[22]));
        // w2_w3_2 = w3*w2
        let w2_w3_2 = w2.mul_add(w3_0, w3.mul_add(w2_0, sums[23]));
        // b_w1_dot_of_w2_w3 = weight_7*w2_w3 + minus_27_b*w2_w3_2 + weight_8*b_2_of_place +
        //   sqrt_3*b_alpha_S_in_axle_base_3_of_place + k_by_3_c_plus_2_k*b_w3_dot_of_w1_w2 +
        //   weight_2*b_of_place + weight_9*b_w2_dot_of_w1_w3
        let b_w1_dot_of_w2_w3 = b_w2_dot_of_w1_w3
            .mul_add(
                weight_9,
                b_w3_dot_of_w1_w2
                    .mul_add(
                        k_by_3_c_plus_2_k,
                        b_of_place
                            .mul_add(
                                weight_2,
                                b_2_of_place
                                    .mul_add(
                                        weight_8,
                                        b_alpha_S_in_axle_base_3_of_place
                                            .mul_add(
                                                sqrt_3,
                                                w2_w3_2.mul_add(minus_27_b, weight_7 * w2_w3),
                                            ),
                                    ),
                            ),
                    ),
            );
        // w2_dot_2 = weight_10*b_w2_dot_of_w1_w3 + weight_11*b_w1_dot_of_w2_w3
        let w2_dot_2 = b_w1_dot_of_w2_w3
            .mul_add(weight_11, weight_10 * b_w2_dot_of_w1_w3);
        // w3_dot_2 = weight_12*b_w3_dot_of_w1_w2 + weight_13*b_w1_dot_of_w2_w3 +
        //   k_by_3_c_plus_2_k*w2_dot_2
        let w3_dot_2 = w2_dot_2
            .mul_add(
                k_by_3_c_plus_2_k,
                b_w1_dot_of_w2_w3.mul_add(weight_13, weight_12 * b_w3_dot_of_w1_w2),
            );
        // s_dot_2 = weight_14*b_s_dot_of_place + minus_sqrt_3_by_3*w3_dot_2 + weight_15*b_w1_dot_of_w2_w3
        //   + minus_sqrt_3_by_3*w2_dot_2
        let s_dot_2 = w3_dot_2
            .mul_add(
                minus_sqrt_3_by_3,
                w2_dot_2
                    .mul_add(
                        minus_sqrt_3_by_3,
                        b_w1_dot_of_w2_w3
                            .mul_add(weight_15, weight_14 * b_s_dot_of_place),
                    ),
            );
        // e1_w1 = e1*w1
        let e1_w1 = w1.mul_add(e1_0, e1.mul_add(w1_0, sums[24]));
        // e2_w2 = e2*w2
        let e2_w2 = w2.mul_add(e2_0, e2.mul_add(w2_0, sums[25]));
        // e3_w3 = e3*w3
        let e3_w3 = w3.mul_add(e3_0, e3.mul_add(w3_0, sums[26]));
        // e0_dot_2 = -1/2*e1_w1 - 1/2*e2_w2 - 1/2*e3_w3
        let e0_dot_2 = e3_w3
            .mul_add(
                -S::ratio(1, 2),
                e2_w2.mul_add(-S::ratio(1, 2), -S::ratio(1, 2) * e1_w1),
            );
        // e0_w1 = e0*w1
        let e0_w1 = w1.mul_add(e0_0, e0.mul_add(w1_0, sums[27]));
        // e3_w2 = e3*w2
        let e3_w2 = w2.mul_add(e3_0, e3.mul_add(w2_0, sums[28]));
        // e2_w3 = e2*w3
        let e2_w3 = w3.mul_add(e2_0, e2.mul_add(w3_0, sums[29]));
        // e1_dot_2 = 1/2*e0_w1 - 1/2*e3_w2 + 1/2*e2_w3
        let e1_dot_2 = e2_w3
            .mul_add(
                S::ratio(1, 2),
                e3_w2.mul_add(-S::ratio(1, 2), S::ratio(1, 2) * e0_w1),
            );
        // e3_w1 = e3*w1
        let e3_w1 = w1.mul_add(e3_0, e3.mul_add(w1_0, sums[30]));
        // e0_w2 = e0*w2
        let e0_w2 = w2.mul_add(e0_0, e0.mul_add(w2_0, sums[31]));
        // e1_w3 = e1*w3
        let e1_w3 = w3.mul_add(e1_0, e1.mul_add(w3_0, sums[32]));
        // e2_dot_2 = 1/2*e3_w1 + 1/2*e0_w2 - 1/2*e1_w3
        let e2_dot_2 = e1_w3
            .mul_add(
                -S::ratio(1, 2),
                e0_w2.mul_add(S::ratio(1, 2), S::ratio(1, 2) * e3_w1),
            );
        // e2_w1 = e2*w1
        let e2_w1 = w1.mul_add(e2_0, e2.mul_add(w1_0, sums[33]));
        // e1_w2 = e1*w2
        let e1_w2 = w2.mul_add(e1_0, e1.mul_add(w2_0, sums[34]));
        // e0_w3 = e0*w3
        let e0_w3 = w3.mul_add(e0_0, e0.mul_add(w3_0, sums[35]));
        // e3_dot_2 = -1/2*e2_w1 + 1/2*e1_w2 + 1/2*e0_w3
        let e3_dot_2 = e0_w3
            .mul_add(
                S::ratio(1, 2),
                e1_w2.mul_add(S::ratio(1, 2), -S::ratio(1, 2) * e2_w1),
            );
        e0_rate = e0_dot_2;
        e1_rate = e1_dot_2;
        e2_rate = e2_dot_2;
        e3_rate = e3_dot_2;
        phi_rate = s;
        w1_rate = weight_16 * b_w1_dot_of_w2_w3;
        w2_rate = w2_dot_2;
        w3_rate = w3_dot_2;
        s_rate = s_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * phi,
                count * phi,
                cos_phi, sin_phi, sin_phi, cos_phi, s, w_axle_base_in_W_turn1_2_of_place, s,
                w_axle_base_in_W_turn1_1_of_place, w_axle_base_in_W_turn1_2_of_place,
                w_axle_base_in_W_turn1_1_of_place, w_S_in_axle_base_1_of_w1_w2_w3,
                w_S_in_axle_base_2_of_w1_w2_w3, w_S_in_axle_base_3_of_w1_w2_w3,
                w_S_in_axle_base_1_of_w1_w2_w3, w_S_in_axle_base_3_of_w1_w2_w3,
                w_S_in_axle_base_2_of_w1_w2_w3, w1, w2, w3, w1, w2, w3, e1, e2, e3, e0, e3, e2, e3,
                e0, e1, e2, e1, e0,
            ]),
            padded([
                cos_phi, sin_phi, w_S_in_axle_base_1_of_w1_w2_w3, w_S_in_axle_base_2_of_w1_w2_w3,
                w_S_in_axle_base_1_of_w1_w2_w3, w_S_in_axle_base_2_of_w1_w2_w3, cos_phi, s_cos_phi,
                sin_phi, s_sin_phi, s_sin_phi, s_cos_phi, w_S_in_axle_base_2_of_w1_w2_w3,
                w_S_in_axle_base_1_of_w1_w2_w3, w_S_in_axle_base_1_of_w1_w2_w3,
                b_alpha_W_2_of_place, w_S_in_axle_base_2_of_w1_w2_w3, b_alpha_W_2_of_place, w2, w1,
                w1, w3, w3, w2, w1, w2, w3, w1, w2, w3, w1, w2, w3, w1, w2, w3,
            ]),
        ];
        count_last = count;
        e0_last = e0;
        e1_last = e1;
        e2_last = e2;
        e3_last = e3;
        phi_last = phi;
        w1_last = w1;
        w2_last = w2;
        w3_last = w3;
        s_last = s;
        w_S_in_axle_base_1_of_w1_w2_w3_last = w_S_in_axle_base_1_of_w1_w2_w3;
        w_S_in_axle_base_2_of_w1_w2_w3_last = w_S_in_axle_base_2_of_w1_w2_w3;
        w_S_in_axle_base_3_of_w1_w2_w3_last = w_S_in_axle_base_3_of_w1_w2_w3;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        w_axle_base_in_W_turn1_1_of_place_last = w_axle_base_in_W_turn1_1_of_place;
        w_axle_base_in_W_turn1_2_of_place_last = w_axle_base_in_W_turn1_2_of_place;
        s_cos_phi_last = s_cos_phi;
        s_sin_phi_last = s_sin_phi;
        b_alpha_W_2_of_place_last = b_alpha_W_2_of_place;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        80 * order + SLACK
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                let x = &mut x.as_chunks_mut().0[..=order];
                taylor(&Parameters::from_slice(p), x, rows(work));
            },
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
    slice.try_into().expect("a slice of the length that System states")
}
