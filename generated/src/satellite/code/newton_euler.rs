//! Satellite with a reaction wheel: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, potential_energy,
};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bus moment s1, bus moment s2, bus moment s3, wheel moment axle_base1, wheel moment axle_base2, wheel moment axle_base3.
///
/// 18 operations, 1 other function.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 5],
    _u: &[S; 4],
) -> [[S; 6]; 6] {
    let Parameters { A, B, C, J, K, .. } = *p;
    // Elimination, step by step, each after the terms that it shares.
    let x_axle_base_in_S_1_2_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let x_axle_base_in_S_1_2_of__2 = S::int(1) / (S::int(3) + x_axle_base_in_S_1_2_of_);
    // x_axle_base_in_S_1_2 = 1/(3 + sqrt(3)) - 1
    let x_axle_base_in_S_1_2 = x_axle_base_in_S_1_2_of__2 - S::int(1);
    // x_axle_base_in_S_1_3 = 1/(3 + sqrt(3))
    let x_axle_base_in_S_1_3 = x_axle_base_in_S_1_2_of__2;
    // x_axle_base_1_2 = K*x_axle_base_in_S_1_2
    let x_axle_base_1_2 = K * x_axle_base_in_S_1_2;
    // x_axle_base_1_3 = K*x_axle_base_in_S_1_3
    let x_axle_base_1_3 = K * x_axle_base_in_S_1_3;
    // x_axle_base_1_4 = K*sqrt(3)
    let x_axle_base_1_4 = K * x_axle_base_in_S_1_2_of_;
    // x_axle_base_3_2 = J*sqrt(3)
    let x_axle_base_3_2 = J * x_axle_base_in_S_1_2_of_;
    // -sqrt(3)/3
    let m35_of_ = -S::ratio(1, 3) * x_axle_base_in_S_1_2_of_;
    // -x_axle_base_in_S_1_2
    let m15_of_place = -x_axle_base_in_S_1_2;
    // -x_axle_base_in_S_1_3
    let m16_of_place = -x_axle_base_in_S_1_3;
    // -x_axle_base_1_2
    let minus_x_axle_base_1_2 = -x_axle_base_1_2;
    // -x_axle_base_1_3
    let minus_x_axle_base_1_3 = -x_axle_base_1_3;
    // -x_axle_base_1_4/3
    let m43_of_place = -S::ratio(1, 3) * x_axle_base_1_4;
    let x_axle_base_3_2_by_3 = S::ratio(1, 3) * x_axle_base_3_2;
    // Entries that are not zero.
    // M11 = A
    let m11 = A;
    // M15 = -x_axle_base_in_S_1_2
    let m15 = m15_of_place;
    // M16 = -x_axle_base_in_S_1_3
    let m16 = m16_of_place;
    // M22 = B
    let m22 = B;
    // M25 = -x_axle_base_in_S_1_3
    let m25 = m16_of_place;
    // M26 = -x_axle_base_in_S_1_2
    let m26 = m15_of_place;
    // M33 = C
    let m33 = C;
    // M35 = -sqrt(3)/3
    let m35 = m35_of_;
    // M36 = -sqrt(3)/3
    let m36 = m35_of_;
    // M41 = -x_axle_base_1_2
    let m41 = minus_x_axle_base_1_2;
    // M42 = -x_axle_base_1_3
    let m42 = minus_x_axle_base_1_3;
    // M43 = -x_axle_base_1_4/3
    let m43 = m43_of_place;
    // M45 = -1
    let m45 = -S::int(1);
    // M51 = -x_axle_base_1_3
    let m51 = minus_x_axle_base_1_3;
    // M52 = -x_axle_base_1_2
    let m52 = minus_x_axle_base_1_2;
    // M53 = -x_axle_base_1_4/3
    let m53 = m43_of_place;
    // M56 = -1
    let m56 = -S::int(1);
    // M61 = x_axle_base_3_2/3
    let m61 = x_axle_base_3_2_by_3;
    // M62 = x_axle_base_3_2/3
    let m62 = x_axle_base_3_2_by_3;
    // M63 = x_axle_base_3_2/3
    let m63 = x_axle_base_3_2_by_3;
    // M64 = J
    let m64 = J;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, m15, m16],
        [zero, m22, zero, zero, m25, m26],
        [zero, zero, m33, zero, m35, m36],
        [m41, m42, m43, zero, m45, zero],
        [m51, m52, m53, zero, zero, m56],
        [m61, m62, m63, m64, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (w1', w2', w3', s', wheel_torque_axle_base1, wheel_torque_axle_base2).
///
/// 76 operations, 1 sine and cosine, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [S; 6] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    let x_axle_base_in_S_1_of_ = (S::int(3)).sqrt();
    // x_axle_base_in_S_1 = T*sqrt(3)
    let x_axle_base_in_S_1 = T * x_axle_base_in_S_1_of_;
    let w2_times_3 = S::int(3) * w2;
    let w3_times_3 = S::int(3) * w3;
    // x_S_1 = 3*w2*H_bus_3 - 3*w3*H_bus_2 + x_axle_base_in_S_1
    let x_S_1 = H_bus_3.mul_add(w2_times_3, x_axle_base_in_S_1) - H_bus_2 * w3_times_3;
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    let w1_times_3 = S::int(3) * w1;
    // x_S_2 = x_axle_base_in_S_1 - 3*w1*H_bus_3 + 3*w3*H_bus_1
    let x_S_2 = H_bus_1.mul_add(w3_times_3, x_axle_base_in_S_1) - H_bus_3 * w1_times_3;
    // x_S_3 = 3*w1*H_bus_2 + x_axle_base_in_S_1 - 3*w2*H_bus_1
    let x_S_3 = (-H_bus_1).mul_add(w2_times_3, x_axle_base_in_S_1) + H_bus_2 * w1_times_3;
    // w1 + w2
    let w1_plus_w2 = w1 + w2;
    let w_S_in_axle_base_1_of_w3 = w3 * x_axle_base_in_S_1_of_;
    // 3*w1_plus_w2/(3 + sqrt(3)) + w_S_in_axle_base_1_of_w3
    let w_S_in_axle_base_1_of_w1_w2_w3 = S::int(3) * w1_plus_w2
        / (S::int(3) + x_axle_base_in_S_1_of_) + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w_S_in_axle_base_1_of_w1_w2_w3 - w1_times_3;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w_S_in_axle_base_1_of_w1_w2_w3 - w2_times_3;
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = w1_plus_w2
        .mul_add(x_axle_base_in_S_1_of_, w_S_in_axle_base_1_of_w3);
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
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
    // K*(w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3
    let x_axle_base_1_of_place = K * (w_S_in_axle_base_3 - w_W_turn1_3) + H_wheel_3;
    let k_times_3 = S::int(3) * K;
    // x_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 +
    //   K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
    //   3*alpha_W_turn1_in_axle_base_1)
    let x_axle_base_1 = (-w_S_in_axle_base_3)
        .mul_add(H_wheel_2, w_S_in_axle_base_2 * x_axle_base_1_of_place)
        - alpha_W_turn1_in_axle_base_1 * k_times_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    // x_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 +
    //   K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
    //   3*alpha_W_turn1_in_axle_base_2)
    let x_axle_base_2 = (-w_S_in_axle_base_1)
        .mul_add(x_axle_base_1_of_place, w_S_in_axle_base_3 * H_wheel_1)
        - alpha_W_turn1_in_axle_base_2 * k_times_3;
    // x_axle_base_3 = 9*T - w_S_in_axle_base_1*H_wheel_2 + w_S_in_axle_base_2*H_wheel_1
    let x_axle_base_3 = (-w_S_in_axle_base_1).mul_add(H_wheel_2, S::int(9) * T)
        + w_S_in_axle_base_2 * H_wheel_1;
    // Values.
    // f1 = -x_S_1/3
    let f1 = -S::ratio(1, 3) * x_S_1;
    // f2 = -x_S_2/3
    let f2 = -S::ratio(1, 3) * x_S_2;
    // f3 = -x_S_3/3
    let f3 = -S::ratio(1, 3) * x_S_3;
    // f4 = x_axle_base_1/9
    let f4 = S::ratio(1, 9) * x_axle_base_1;
    // f5 = x_axle_base_2/9
    let f5 = S::ratio(1, 9) * x_axle_base_2;
    // f6 = x_axle_base_3/9
    let f6 = S::ratio(1, 9) * x_axle_base_3;
    [f1, f2, f3, f4, f5, f6]
}

/// The accelerations (w1', w2', w3', s'), solved for when this code was generated.
///
/// 149 operations, 1 sine and cosine, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [S; 4] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [_, _, _, _, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    let x_axle_base_in_S_1_of_ = (S::int(3)).sqrt();
    // x_axle_base_in_S_1 = T*sqrt(3)
    let x_axle_base_in_S_1 = T * x_axle_base_in_S_1_of_;
    let w2_times_3 = S::int(3) * w2;
    let w3_times_3 = S::int(3) * w3;
    // x_S_1 = 3*w2*H_bus_3 - 3*w3*H_bus_2 + x_axle_base_in_S_1
    let x_S_1 = H_bus_3.mul_add(w2_times_3, x_axle_base_in_S_1) - H_bus_2 * w3_times_3;
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    let w1_times_3 = S::int(3) * w1;
    // x_S_2 = x_axle_base_in_S_1 - 3*w1*H_bus_3 + 3*w3*H_bus_1
    let x_S_2 = H_bus_1.mul_add(w3_times_3, x_axle_base_in_S_1) - H_bus_3 * w1_times_3;
    // x_S_3 = 3*w1*H_bus_2 + x_axle_base_in_S_1 - 3*w2*H_bus_1
    let x_S_3 = (-H_bus_1).mul_add(w2_times_3, x_axle_base_in_S_1) + H_bus_2 * w1_times_3;
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of_ = S::int(1) / (S::int(3) + x_axle_base_in_S_1_of_);
    // 1 - w_S_in_axle_base_1_of_
    let w_S_in_axle_base_1_of__2 = S::int(1) - w_S_in_axle_base_1_of_;
    // -w_S_in_axle_base_1_of__2
    let w_S_in_axle_base_1_of__3 = -w_S_in_axle_base_1_of__2;
    let w_S_in_axle_base_1_of_w3 = w3 * x_axle_base_in_S_1_of_;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w1_times_3
        .mul_add(w_S_in_axle_base_1_of__3, w2_times_3 * w_S_in_axle_base_1_of_)
        + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w2_times_3
        .mul_add(w_S_in_axle_base_1_of__3, w1_times_3 * w_S_in_axle_base_1_of_)
        + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = x_axle_base_in_S_1_of_ * (w1 + w2) + w_S_in_axle_base_1_of_w3;
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
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
    // w_S_in_axle_base_3 - w_W_turn1_3
    let x_axle_base_1_of_place = w_S_in_axle_base_3 - w_W_turn1_3;
    // x_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 +
    //   K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
    //   3*alpha_W_turn1_in_axle_base_1)
    let x_axle_base_1 = w_S_in_axle_base_2 * H_wheel_3 - w_S_in_axle_base_3 * H_wheel_2
        + K
            * (-alpha_W_turn1_in_axle_base_1)
                .mul_add(S::int(3), w_S_in_axle_base_2 * x_axle_base_1_of_place);
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    // x_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 +
    //   K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
    //   3*alpha_W_turn1_in_axle_base_2)
    let x_axle_base_2 = w_S_in_axle_base_3 * H_wheel_1 - w_S_in_axle_base_1 * H_wheel_3
        - K
            * w_S_in_axle_base_1
                .mul_add(
                    x_axle_base_1_of_place,
                    S::int(3) * alpha_W_turn1_in_axle_base_2,
                );
    // x_axle_base_3 = 9*T - w_S_in_axle_base_1*H_wheel_2 + w_S_in_axle_base_2*H_wheel_1
    let x_axle_base_3 = (-w_S_in_axle_base_1).mul_add(H_wheel_2, S::int(9) * T)
        + w_S_in_axle_base_2 * H_wheel_1;
    // x_axle_base_in_S_1_2 = 1/(3 + sqrt(3)) - 1
    let x_axle_base_in_S_1_2 = w_S_in_axle_base_1_of__3;
    // x_axle_base_in_S_1_3 = 1/(3 + sqrt(3))
    let x_axle_base_in_S_1_3 = w_S_in_axle_base_1_of_;
    // x_axle_base_1_2 = K*x_axle_base_in_S_1_2
    let x_axle_base_1_2 = K * x_axle_base_in_S_1_2;
    // x_axle_base_1_3 = K*x_axle_base_in_S_1_3
    let x_axle_base_1_3 = K * x_axle_base_in_S_1_3;
    // x_axle_base_1_4 = K*sqrt(3)
    let x_axle_base_1_4 = K * x_axle_base_in_S_1_of_;
    // x_axle_base_3_2 = J*sqrt(3)
    let x_axle_base_3_2 = J * x_axle_base_in_S_1_of_;
    // 3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2
    let w3_dot_of_place = x_axle_base_1.mul_add(x_axle_base_in_S_1_2, S::int(3) * x_S_1);
    // x_axle_base_2*x_axle_base_in_S_1_3 + w3_dot_of_place
    let w3_dot_of_place_2 = x_axle_base_2.mul_add(x_axle_base_in_S_1_3, w3_dot_of_place);
    // x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3
    let w3_dot_of_place_3 = x_axle_base_in_S_1_3
        .mul_add(x_axle_base_1_3, x_axle_base_in_S_1_2 * x_axle_base_1_2);
    // 1/(A + w3_dot_of_place_3)
    let w3_dot_of_place_4 = S::int(1) / (A + w3_dot_of_place_3);
    // x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3
    let w3_dot_of_place_5 = x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3;
    let w3_dot_of_place_6 = x_axle_base_1_4 * w3_dot_of_place_5;
    let w3_dot_of_place_7 = w3_dot_of_place_4 * w3_dot_of_place_6;
    // x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3
    let w3_dot_of_place_8 = x_axle_base_in_S_1_2
        .mul_add(x_axle_base_1_3, x_axle_base_in_S_1_3 * x_axle_base_1_2);
    let w3_dot_of_place_9 = w3_dot_of_place_4 * w3_dot_of_place_8;
    // 3*x_S_2 - w3_dot_of_place_2*w3_dot_of_place_9
    let w3_dot_of_place_10 = (-w3_dot_of_place_2)
        .mul_add(w3_dot_of_place_9, S::int(3) * x_S_2);
    // x_axle_base_2*x_axle_base_in_S_1_2 + x_axle_base_1*x_axle_base_in_S_1_3
    let w3_dot_of_place_11 = x_axle_base_1
        .mul_add(x_axle_base_in_S_1_3, x_axle_base_2 * x_axle_base_in_S_1_2);
    // w3_dot_of_place_10 + w3_dot_of_place_11
    let w3_dot_of_place_12 = w3_dot_of_place_10 + w3_dot_of_place_11;
    // 1/(B + w3_dot_of_place_3 - w3_dot_of_place_8*w3_dot_of_place_9)
    let w3_dot_of_place_13 = S::int(1)
        / (-w3_dot_of_place_8).mul_add(w3_dot_of_place_9, B + w3_dot_of_place_3);
    // w3_dot_of_place_6*(w3_dot_of_place_9 - 1)
    let w3_dot_of_place_14 = w3_dot_of_place_6 * (w3_dot_of_place_9 - S::int(1));
    let w3_dot_of_place_15 = w3_dot_of_place_13 * w3_dot_of_place_14;
    // w3' = (x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*(3*x_S_1 +
    //   x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - 9*x_S_3 -
    //   sqrt(3)*(x_axle_base_1 + x_axle_base_2) - x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(3*x_S_2 + x_axle_base_2*x_axle_base_in_S_1_2 +
    //   x_axle_base_1*x_axle_base_in_S_1_3 - (3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 +
    //   x_axle_base_2*x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/(B + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(3*(9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))))
    let w3_dot = S::ratio(1, 3)
        * (w3_dot_of_place_2 * w3_dot_of_place_7 - S::int(9) * x_S_3
            - x_axle_base_in_S_1_of_ * (x_axle_base_1 + x_axle_base_2)
            - w3_dot_of_place_12 * w3_dot_of_place_15)
        / (x_axle_base_1_4
            * (-w3_dot_of_place_5)
                .mul_add(w3_dot_of_place_7, S::int(2) * x_axle_base_in_S_1_of_)
            + S::int(9) * C - w3_dot_of_place_14 * w3_dot_of_place_15);
    let w3_dot_times_3 = S::int(3) * w3_dot;
    // w2' = (3*x_S_2 + x_axle_base_2*x_axle_base_in_S_1_2 + x_axle_base_1*x_axle_base_in_S_1_3 - (3*x_S_1
    //   + x_axle_base_1*x_axle_base_in_S_1_2 +
    //   x_axle_base_2*x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + 3*w3'*x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(1 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w2_dot = S::ratio(1, 9) * w3_dot_of_place_13
        * w3_dot_of_place_14.mul_add(w3_dot_times_3, -w3_dot_of_place_12);
    // w1' = -(3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3 +
    //   9*w2'*(x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3) +
    //   3*w3'*x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3))/(9*(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot = -S::ratio(1, 9) * w3_dot_of_place_4
        * ((w2_dot * w3_dot_of_place_8).mul_add(S::int(9), w3_dot_of_place_2)
            + w3_dot_of_place_6 * w3_dot_times_3);
    // s' = (x_axle_base_3 - 3*x_axle_base_3_2*(w1' + w2' + w3'))/(9*J)
    let s_dot = S::ratio(1, 9)
        * (x_axle_base_3 - S::int(3) * x_axle_base_3_2 * (w1_dot + w2_dot + w3_dot)) / J;
    [w1_dot, w2_dot, w3_dot, s_dot]
}

/// Kinetic energy T.
///
/// 33 operations, 1 other function.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 5], u: &[S; 4]) -> S {
    let Parameters { A, B, C, J, K, .. } = *p;
    let [w1, w2, w3, s] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
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
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // w2*H_bus_2 + w1*H_bus_1
    let energy_of_w1_w2 = w1.mul_add(H_bus_1, w2 * H_bus_2);
    // w_S_in_axle_base_2*H_wheel_2 + w_S_in_axle_base_1*H_wheel_1
    let energy_of_place = w_S_in_axle_base_1
        .mul_add(H_wheel_1, w_S_in_axle_base_2 * H_wheel_2);
    // w3*H_bus_3 + energy_of_w1_w2
    let energy_of_w1_w2_w3 = w3.mul_add(H_bus_3, energy_of_w1_w2);
    // w_W_turn1_3*H_wheel_3 + energy_of_place
    let energy_of_place_2 = w_W_turn1_3.mul_add(H_wheel_3, energy_of_place);
    // Values.
    // T = w2*H_bus_2/2 + w3*H_bus_3/2 + w1*H_bus_1/2 + w_S_in_axle_base_2*H_wheel_2/18 +
    //   w_W_turn1_3*H_wheel_3/18 + w_S_in_axle_base_1*H_wheel_1/18
    let energy = S::ratio(1, 2) * energy_of_w1_w2_w3 + S::ratio(1, 18) * energy_of_place_2;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 173 operations, 1 sine and cosine, 1 other function.
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
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    let x_axle_base_in_S_1_of_ = (S::int(3)).sqrt();
    // x_axle_base_in_S_1 = T*sqrt(3)
    let x_axle_base_in_S_1 = T * x_axle_base_in_S_1_of_;
    let w2_times_3 = S::int(3) * w2;
    let w3_times_3 = S::int(3) * w3;
    // x_S_1 = 3*w2*H_bus_3 - 3*w3*H_bus_2 + x_axle_base_in_S_1
    let x_S_1 = H_bus_3.mul_add(w2_times_3, x_axle_base_in_S_1) - H_bus_2 * w3_times_3;
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    let w1_times_3 = S::int(3) * w1;
    // x_S_2 = x_axle_base_in_S_1 - 3*w1*H_bus_3 + 3*w3*H_bus_1
    let x_S_2 = H_bus_1.mul_add(w3_times_3, x_axle_base_in_S_1) - H_bus_3 * w1_times_3;
    // x_S_3 = 3*w1*H_bus_2 + x_axle_base_in_S_1 - 3*w2*H_bus_1
    let x_S_3 = (-H_bus_1).mul_add(w2_times_3, x_axle_base_in_S_1) + H_bus_2 * w1_times_3;
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of_ = S::int(1) / (S::int(3) + x_axle_base_in_S_1_of_);
    // 1 - w_S_in_axle_base_1_of_
    let w_S_in_axle_base_1_of__2 = S::int(1) - w_S_in_axle_base_1_of_;
    // -w_S_in_axle_base_1_of__2
    let w_S_in_axle_base_1_of__3 = -w_S_in_axle_base_1_of__2;
    let w_S_in_axle_base_1_of_w3 = w3 * x_axle_base_in_S_1_of_;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w1_times_3
        .mul_add(w_S_in_axle_base_1_of__3, w2_times_3 * w_S_in_axle_base_1_of_)
        + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w2_times_3
        .mul_add(w_S_in_axle_base_1_of__3, w1_times_3 * w_S_in_axle_base_1_of_)
        + w_S_in_axle_base_1_of_w3;
    // w_S_in_axle_base_3 = w1*sqrt(3) + w2*sqrt(3) + w3*sqrt(3)
    let w_S_in_axle_base_3 = x_axle_base_in_S_1_of_ * (w1 + w2) + w_S_in_axle_base_1_of_w3;
    // w_axle_base_in_W_turn1_1 = w_S_in_axle_base_1*cos(phi) + w_S_in_axle_base_2*sin(phi)
    let w_axle_base_in_W_turn1_1 = w_S_in_axle_base_2
        .mul_add(sin_phi, w_S_in_axle_base_1 * cos_phi);
    // w_axle_base_in_W_turn1_2 = w_S_in_axle_base_1*sin(phi) - w_S_in_axle_base_2*cos(phi)
    let w_axle_base_in_W_turn1_2 = (-w_S_in_axle_base_2)
        .mul_add(cos_phi, w_S_in_axle_base_1 * sin_phi);
    // w_W_turn1_3 = 3*s + w_S_in_axle_base_3
    let w_W_turn1_3 = s.mul_add(S::int(3), w_S_in_axle_base_3);
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
    // w_S_in_axle_base_3 - w_W_turn1_3
    let x_axle_base_1_of_place = w_S_in_axle_base_3 - w_W_turn1_3;
    // x_axle_base_1 = w_S_in_axle_base_2*H_wheel_3 - w_S_in_axle_base_3*H_wheel_2 +
    //   K*(w_S_in_axle_base_2*w_S_in_axle_base_3 - w_S_in_axle_base_2*w_W_turn1_3 -
    //   3*alpha_W_turn1_in_axle_base_1)
    let x_axle_base_1 = w_S_in_axle_base_2 * H_wheel_3 - w_S_in_axle_base_3 * H_wheel_2
        + K
            * (-alpha_W_turn1_in_axle_base_1)
                .mul_add(S::int(3), w_S_in_axle_base_2 * x_axle_base_1_of_place);
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // alpha_W_turn1_in_axle_base_2 = s*w_axle_base_in_W_turn1_1*cos(phi) +
    //   s*w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2 = w_axle_base_in_W_turn1_2
        .mul_add(s_sin_phi, w_axle_base_in_W_turn1_1 * s_cos_phi);
    // x_axle_base_2 = w_S_in_axle_base_3*H_wheel_1 - w_S_in_axle_base_1*H_wheel_3 +
    //   K*(w_S_in_axle_base_1*w_W_turn1_3 - w_S_in_axle_base_1*w_S_in_axle_base_3 -
    //   3*alpha_W_turn1_in_axle_base_2)
    let x_axle_base_2 = w_S_in_axle_base_3 * H_wheel_1 - w_S_in_axle_base_1 * H_wheel_3
        - K
            * w_S_in_axle_base_1
                .mul_add(
                    x_axle_base_1_of_place,
                    S::int(3) * alpha_W_turn1_in_axle_base_2,
                );
    // x_axle_base_3 = 9*T - w_S_in_axle_base_1*H_wheel_2 + w_S_in_axle_base_2*H_wheel_1
    let x_axle_base_3 = (-w_S_in_axle_base_1).mul_add(H_wheel_2, S::int(9) * T)
        + w_S_in_axle_base_2 * H_wheel_1;
    // x_axle_base_in_S_1_2 = 1/(3 + sqrt(3)) - 1
    let x_axle_base_in_S_1_2 = w_S_in_axle_base_1_of__3;
    // x_axle_base_in_S_1_3 = 1/(3 + sqrt(3))
    let x_axle_base_in_S_1_3 = w_S_in_axle_base_1_of_;
    // x_axle_base_1_2 = K*x_axle_base_in_S_1_2
    let x_axle_base_1_2 = K * x_axle_base_in_S_1_2;
    // x_axle_base_1_3 = K*x_axle_base_in_S_1_3
    let x_axle_base_1_3 = K * x_axle_base_in_S_1_3;
    // x_axle_base_1_4 = K*sqrt(3)
    let x_axle_base_1_4 = K * x_axle_base_in_S_1_of_;
    // x_axle_base_3_2 = J*sqrt(3)
    let x_axle_base_3_2 = J * x_axle_base_in_S_1_of_;
    // 3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2
    let w3_dot_of_place = x_axle_base_1.mul_add(x_axle_base_in_S_1_2, S::int(3) * x_S_1);
    // x_axle_base_2*x_axle_base_in_S_1_3 + w3_dot_of_place
    let w3_dot_of_place_2 = x_axle_base_2.mul_add(x_axle_base_in_S_1_3, w3_dot_of_place);
    // x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3
    let w3_dot_of_place_3 = x_axle_base_in_S_1_3
        .mul_add(x_axle_base_1_3, x_axle_base_in_S_1_2 * x_axle_base_1_2);
    // 1/(A + w3_dot_of_place_3)
    let w3_dot_of_place_4 = S::int(1) / (A + w3_dot_of_place_3);
    // x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3
    let w3_dot_of_place_5 = x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3;
    let w3_dot_of_place_6 = x_axle_base_1_4 * w3_dot_of_place_5;
    let w3_dot_of_place_7 = w3_dot_of_place_4 * w3_dot_of_place_6;
    // x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3
    let w3_dot_of_place_8 = x_axle_base_in_S_1_2
        .mul_add(x_axle_base_1_3, x_axle_base_in_S_1_3 * x_axle_base_1_2);
    let w3_dot_of_place_9 = w3_dot_of_place_4 * w3_dot_of_place_8;
    // 3*x_S_2 - w3_dot_of_place_2*w3_dot_of_place_9
    let w3_dot_of_place_10 = (-w3_dot_of_place_2)
        .mul_add(w3_dot_of_place_9, S::int(3) * x_S_2);
    // x_axle_base_2*x_axle_base_in_S_1_2 + x_axle_base_1*x_axle_base_in_S_1_3
    let w3_dot_of_place_11 = x_axle_base_1
        .mul_add(x_axle_base_in_S_1_3, x_axle_base_2 * x_axle_base_in_S_1_2);
    // w3_dot_of_place_10 + w3_dot_of_place_11
    let w3_dot_of_place_12 = w3_dot_of_place_10 + w3_dot_of_place_11;
    // 1/(B + w3_dot_of_place_3 - w3_dot_of_place_8*w3_dot_of_place_9)
    let w3_dot_of_place_13 = S::int(1)
        / (-w3_dot_of_place_8).mul_add(w3_dot_of_place_9, B + w3_dot_of_place_3);
    // w3_dot_of_place_6*(w3_dot_of_place_9 - 1)
    let w3_dot_of_place_14 = w3_dot_of_place_6 * (w3_dot_of_place_9 - S::int(1));
    let w3_dot_of_place_15 = w3_dot_of_place_13 * w3_dot_of_place_14;
    // w3' = (x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*(3*x_S_1 +
    //   x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) - 9*x_S_3 -
    //   sqrt(3)*(x_axle_base_1 + x_axle_base_2) - x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(3*x_S_2 + x_axle_base_2*x_axle_base_in_S_1_2 +
    //   x_axle_base_1*x_axle_base_in_S_1_3 - (3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 +
    //   x_axle_base_2*x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/(B + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(3*(9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))))
    let w3_dot = S::ratio(1, 3)
        * (w3_dot_of_place_2 * w3_dot_of_place_7 - S::int(9) * x_S_3
            - x_axle_base_in_S_1_of_ * (x_axle_base_1 + x_axle_base_2)
            - w3_dot_of_place_12 * w3_dot_of_place_15)
        / (x_axle_base_1_4
            * (-w3_dot_of_place_5)
                .mul_add(w3_dot_of_place_7, S::int(2) * x_axle_base_in_S_1_of_)
            + S::int(9) * C - w3_dot_of_place_14 * w3_dot_of_place_15);
    let w3_dot_times_3 = S::int(3) * w3_dot;
    // w2' = (3*x_S_2 + x_axle_base_2*x_axle_base_in_S_1_2 + x_axle_base_1*x_axle_base_in_S_1_3 - (3*x_S_1
    //   + x_axle_base_1*x_axle_base_in_S_1_2 +
    //   x_axle_base_2*x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + 3*w3'*x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(1 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w2_dot = S::ratio(1, 9) * w3_dot_of_place_13
        * w3_dot_of_place_14.mul_add(w3_dot_times_3, -w3_dot_of_place_12);
    // w1' = -(3*x_S_1 + x_axle_base_1*x_axle_base_in_S_1_2 + x_axle_base_2*x_axle_base_in_S_1_3 +
    //   9*w2'*(x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3) +
    //   3*w3'*x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3))/(9*(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot = -S::ratio(1, 9) * w3_dot_of_place_4
        * ((w2_dot * w3_dot_of_place_8).mul_add(S::int(9), w3_dot_of_place_2)
            + w3_dot_of_place_6 * w3_dot_times_3);
    // s' = (x_axle_base_3 - 3*x_axle_base_3_2*(w1' + w2' + w3'))/(9*J)
    let s_dot = S::ratio(1, 9)
        * (x_axle_base_3 - S::int(3) * x_axle_base_3_2 * (w1_dot + w2_dot + w3_dot)) / J;
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
/// 394 operations, 1 sine and cosine, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 4]) -> [[S; 9]; 9] {
    let Parameters { A, B, C, J, K, .. } = *p;
    let [e0, e1, e2, e3, phi] = *q;
    let [w1, w2, w3, s] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // H_bus_2 = B*w2
    let H_bus_2 = B * w2;
    // H_bus_3 = C*w3
    let H_bus_3 = C * w3;
    // H_bus_1 = A*w1
    let H_bus_1 = A * w1;
    let w_S_in_axle_base_2_by_w1_of_ = (S::int(3)).sqrt();
    // 3 + sqrt(3)
    let w_S_in_axle_base_2_by_w1_of__2 = S::int(3) + w_S_in_axle_base_2_by_w1_of_;
    let w_S_in_axle_base_2_by_w1_of__3 = S::int(1) / w_S_in_axle_base_2_by_w1_of__2;
    // w_S_in_axle_base_2_by_w1 = 3/(3 + sqrt(3))
    let w_S_in_axle_base_2_by_w1 = S::int(3) * w_S_in_axle_base_2_by_w1_of__3;
    let w_S_in_axle_base_1_of_w3 = w3 * w_S_in_axle_base_2_by_w1_of_;
    // 1 - w_S_in_axle_base_2_by_w1_of__3
    let w_S_in_axle_base_1_of_ = S::int(1) - w_S_in_axle_base_2_by_w1_of__3;
    // -w_S_in_axle_base_1_of_
    let w_S_in_axle_base_1_of__2 = -w_S_in_axle_base_1_of_;
    let w_S_in_axle_base_1_of_place = S::int(3) * w_S_in_axle_base_1_of__2;
    // w_S_in_axle_base_1 = 3*w1*(1/(3 + sqrt(3)) - 1) + 3*w2/(3 + sqrt(3)) + w3*sqrt(3)
    let w_S_in_axle_base_1 = w2
        .mul_add(w_S_in_axle_base_2_by_w1, w_S_in_axle_base_1_of_w3)
        + w1 * w_S_in_axle_base_1_of_place;
    // w_S_in_axle_base_2 = 3*w1/(3 + sqrt(3)) + 3*w2*(1/(3 + sqrt(3)) - 1) + w3*sqrt(3)
    let w_S_in_axle_base_2 = w1
        .mul_add(w_S_in_axle_base_2_by_w1, w_S_in_axle_base_1_of_w3)
        + w2 * w_S_in_axle_base_1_of_place;
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
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // x_axle_base_in_S_1_2 = 1/(3 + sqrt(3)) - 1
    let x_axle_base_in_S_1_2 = w_S_in_axle_base_1_of__2;
    // x_axle_base_in_S_1_3 = 1/(3 + sqrt(3))
    let x_axle_base_in_S_1_3 = w_S_in_axle_base_2_by_w1_of__3;
    // x_axle_base_1_2 = K*x_axle_base_in_S_1_2
    let x_axle_base_1_2 = K * x_axle_base_in_S_1_2;
    // x_axle_base_1_3 = K*x_axle_base_in_S_1_3
    let x_axle_base_1_3 = K * x_axle_base_in_S_1_3;
    // x_axle_base_1_4 = K*sqrt(3)
    let x_axle_base_1_4 = K * w_S_in_axle_base_2_by_w1_of_;
    // x_axle_base_3_2 = J*sqrt(3)
    let x_axle_base_3_2 = J * w_S_in_axle_base_2_by_w1_of_;
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
    // K*(x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_1_by_phi +
    //   x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_2_by_phi)
    let w3_dot_by_phi_of_place = K
        * x_axle_base_in_S_1_3
            .mul_add(
                alpha_W_turn1_in_axle_base_2_by_phi,
                x_axle_base_in_S_1_2 * alpha_W_turn1_in_axle_base_1_by_phi,
            );
    // x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3
    let w3_dot_by_phi_of_place_2 = x_axle_base_in_S_1_3
        .mul_add(x_axle_base_1_3, x_axle_base_in_S_1_2 * x_axle_base_1_2);
    // 1/(A + w3_dot_by_phi_of_place_2)
    let w3_dot_by_phi_of_place_3 = S::int(1) / (A + w3_dot_by_phi_of_place_2);
    // x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3
    let w3_dot_by_phi_of_place_4 = x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3;
    let w3_dot_by_phi_of_place_5 = x_axle_base_1_4 * w3_dot_by_phi_of_place_4;
    let w3_dot_by_phi_of_place_6 = w3_dot_by_phi_of_place_3 * w3_dot_by_phi_of_place_5;
    // x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3
    let w3_dot_by_phi_of_place_7 = x_axle_base_in_S_1_2
        .mul_add(x_axle_base_1_3, x_axle_base_in_S_1_3 * x_axle_base_1_2);
    let w3_dot_by_phi_of_place_8 = w3_dot_by_phi_of_place_3 * w3_dot_by_phi_of_place_7;
    // K*(x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_1_by_phi +
    //   x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_2_by_phi) -
    //   w3_dot_by_phi_of_place*w3_dot_by_phi_of_place_8
    let w3_dot_by_phi_of_place_9 = K
        * x_axle_base_in_S_1_2
            .mul_add(
                alpha_W_turn1_in_axle_base_2_by_phi,
                x_axle_base_in_S_1_3 * alpha_W_turn1_in_axle_base_1_by_phi,
            ) - w3_dot_by_phi_of_place * w3_dot_by_phi_of_place_8;
    // 1/(B + w3_dot_by_phi_of_place_2 - w3_dot_by_phi_of_place_7*w3_dot_by_phi_of_place_8)
    let w3_dot_by_phi_of_place_10 = S::int(1)
        / (-w3_dot_by_phi_of_place_7)
            .mul_add(w3_dot_by_phi_of_place_8, B + w3_dot_by_phi_of_place_2);
    // w3_dot_by_phi_of_place_5*(w3_dot_by_phi_of_place_8 - 1)
    let w3_dot_by_phi_of_place_11 = w3_dot_by_phi_of_place_5
        * (w3_dot_by_phi_of_place_8 - S::int(1));
    let w3_dot_by_phi_of_place_12 = w3_dot_by_phi_of_place_10 * w3_dot_by_phi_of_place_11;
    let c_times_9 = S::int(9) * C;
    // 1/(x_axle_base_1_4*(2*sqrt(3) - w3_dot_by_phi_of_place_4*w3_dot_by_phi_of_place_6) -
    //   w3_dot_by_phi_of_place_11*w3_dot_by_phi_of_place_12 + c_times_9)
    let w3_dot_by_phi_of_place_13 = S::int(1)
        / (x_axle_base_1_4
            * (-w3_dot_by_phi_of_place_4)
                .mul_add(
                    w3_dot_by_phi_of_place_6,
                    S::int(2) * w_S_in_axle_base_2_by_w1_of_,
                ) - w3_dot_by_phi_of_place_11 * w3_dot_by_phi_of_place_12 + c_times_9);
    // w3_dot_by_phi = (sqrt(3)*(K*alpha_W_turn1_in_axle_base_1_by_phi +
    //   K*alpha_W_turn1_in_axle_base_2_by_phi) - x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(K*x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_1_by_phi +
    //   K*x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_2_by_phi)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) +
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2
    //   + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) -
    //   1)*(K*x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_1_by_phi +
    //   K*x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_2_by_phi - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(K*x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_1_by_phi +
    //   K*x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_2_by_phi)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))/(B +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3 -
    //   (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*C +
    //   x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3)))
    let w3_dot_by_phi = w3_dot_by_phi_of_place_13
        * (K * w_S_in_axle_base_2_by_w1_of_
            * (alpha_W_turn1_in_axle_base_1_by_phi + alpha_W_turn1_in_axle_base_2_by_phi)
            - w3_dot_by_phi_of_place * w3_dot_by_phi_of_place_6
            + w3_dot_by_phi_of_place_9 * w3_dot_by_phi_of_place_12);
    let w2_dot_by_phi_of_place = S::ratio(1, 3) * w3_dot_by_phi_of_place_10;
    // w2_dot_by_phi = (K*x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_1_by_phi +
    //   K*x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_2_by_phi - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(K*x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_1_by_phi +
    //   K*x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_2_by_phi)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) +
    //   x_axle_base_1_4*w3_dot_by_phi*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1))/(3*(B + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))
    let w2_dot_by_phi = w2_dot_by_phi_of_place
        * w3_dot_by_phi.mul_add(w3_dot_by_phi_of_place_11, w3_dot_by_phi_of_place_9);
    let w1_dot_by_phi_of_place = S::ratio(1, 3) * w3_dot_by_phi_of_place_3;
    // w1_dot_by_phi = (K*(x_axle_base_in_S_1_2*alpha_W_turn1_in_axle_base_1_by_phi +
    //   x_axle_base_in_S_1_3*alpha_W_turn1_in_axle_base_2_by_phi) -
    //   x_axle_base_1_4*w3_dot_by_phi*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3) -
    //   3*w2_dot_by_phi*(x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3))/(3*(A
    //   + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot_by_phi = w1_dot_by_phi_of_place
        * ((-w3_dot_by_phi).mul_add(w3_dot_by_phi_of_place_5, w3_dot_by_phi_of_place)
            - S::int(3) * w2_dot_by_phi * w3_dot_by_phi_of_place_7);
    let w_axle_base_in_W_turn1_1_by_w1_of_ = S::ratio(1, 2) * w_S_in_axle_base_2_by_w1_of__2;
    let w_axle_base_in_W_turn1_1_by_w1_of_phi = w_axle_base_in_W_turn1_1_by_w1_of_ * cos_phi;
    // w_axle_base_in_W_turn1_1_by_w1 = w_S_in_axle_base_2_by_w1*sin(phi) - cos(phi)*(3 + sqrt(3))/2
    let w_axle_base_in_W_turn1_1_by_w1 = w_S_in_axle_base_2_by_w1
        .mul_add(sin_phi, -w_axle_base_in_W_turn1_1_by_w1_of_phi);
    let w_axle_base_in_W_turn1_2_by_w1_of_phi = w_axle_base_in_W_turn1_1_by_w1_of_ * sin_phi;
    // w_axle_base_in_W_turn1_2_by_w1 = -sin(phi)*(3 + sqrt(3))/2 - w_S_in_axle_base_2_by_w1*cos(phi)
    let w_axle_base_in_W_turn1_2_by_w1 = (-w_S_in_axle_base_2_by_w1)
        .mul_add(cos_phi, -w_axle_base_in_W_turn1_2_by_w1_of_phi);
    // alpha_W_turn1_in_axle_base_1_by_w1 = s*(w_axle_base_in_W_turn1_2_by_w1*cos(phi) -
    //   w_axle_base_in_W_turn1_1_by_w1*sin(phi))
    let alpha_W_turn1_in_axle_base_1_by_w1 = s
        * (-w_axle_base_in_W_turn1_1_by_w1)
            .mul_add(sin_phi, w_axle_base_in_W_turn1_2_by_w1 * cos_phi);
    let j_w_s_in_axle_base_2 = J * w_S_in_axle_base_2;
    // j_w_s_in_axle_base_2 - H_wheel_2
    let x_axle_base_1_by_w1_of_place = j_w_s_in_axle_base_2 - H_wheel_2;
    let x_axle_base_1_by_w1_of_place_2 = x_axle_base_1_by_w1_of_place
        * w_S_in_axle_base_2_by_w1_of_;
    // x_axle_base_1_by_w1 = sqrt(3)*(J*w_S_in_axle_base_2 - H_wheel_2) +
    //   H_wheel_3*w_S_in_axle_base_2_by_w1 - K*(w_W_turn1_3*w_S_in_axle_base_2_by_w1 +
    //   3*alpha_W_turn1_in_axle_base_1_by_w1)
    let x_axle_base_1_by_w1 = -K
        * alpha_W_turn1_in_axle_base_1_by_w1
            .mul_add(S::int(3), w_W_turn1_3 * w_S_in_axle_base_2_by_w1)
        + H_wheel_3 * w_S_in_axle_base_2_by_w1 + x_axle_base_1_by_w1_of_place_2;
    let H_wheel_1_by_w1_of_k = K * w_axle_base_in_W_turn1_1_by_w1_of_;
    // -H_wheel_1_by_w1_of_k
    let H_wheel_1_by_w1_of_k_2 = -H_wheel_1_by_w1_of_k;
    // H_wheel_1_by_w1 = -K*(3 + sqrt(3))/2
    let H_wheel_1_by_w1 = H_wheel_1_by_w1_of_k_2;
    // alpha_W_turn1_in_axle_base_2_by_w1 = s*(w_axle_base_in_W_turn1_1_by_w1*cos(phi) +
    //   w_axle_base_in_W_turn1_2_by_w1*sin(phi))
    let alpha_W_turn1_in_axle_base_2_by_w1 = s
        * w_axle_base_in_W_turn1_2_by_w1
            .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w1 * cos_phi);
    let j_w_s_in_axle_base_1 = J * w_S_in_axle_base_1;
    // j_w_s_in_axle_base_1 - H_wheel_1
    let x_axle_base_2_by_w1_of_place = j_w_s_in_axle_base_1 - H_wheel_1;
    // w_S_in_axle_base_2_by_w1_of__2*(w_S_in_axle_base_3 - w_W_turn1_3)
    let x_axle_base_2_by_w1_of_place_2 = w_S_in_axle_base_2_by_w1_of__2
        * (w_S_in_axle_base_3 - w_W_turn1_3);
    let k_halved = S::ratio(1, 2) * K;
    let x_axle_base_2_by_w1_of_h_wheel_3 = H_wheel_3 * w_axle_base_in_W_turn1_1_by_w1_of_;
    let x_axle_base_2_by_w1_of_place_3 = x_axle_base_2_by_w1_of_place
        * w_S_in_axle_base_2_by_w1_of_;
    // x_axle_base_2_by_w1 = H_wheel_3*(3 + sqrt(3))/2 - J*w_S_in_axle_base_1*sqrt(3) + H_wheel_1*sqrt(3) +
    //   w_S_in_axle_base_3*H_wheel_1_by_w1 + K*(w_S_in_axle_base_3*(3 + sqrt(3)) - w_W_turn1_3*(3 + sqrt(3))
    //   - 6*alpha_W_turn1_in_axle_base_2_by_w1)/2
    let x_axle_base_2_by_w1 = -x_axle_base_2_by_w1_of_place_3 + w_S_in_axle_base_3 * H_wheel_1_by_w1
        + k_halved
            * (-alpha_W_turn1_in_axle_base_2_by_w1)
                .mul_add(S::int(6), x_axle_base_2_by_w1_of_place_2)
        + x_axle_base_2_by_w1_of_h_wheel_3;
    // x_axle_base_3_by_w1 = H_wheel_2*(3 + sqrt(3))/2 + w_S_in_axle_base_2_by_w1*(H_wheel_1 -
    //   K*w_S_in_axle_base_1) + w_S_in_axle_base_2*H_wheel_1_by_w1
    let x_axle_base_3_by_w1 = H_wheel_2
        .mul_add(
            w_axle_base_in_W_turn1_1_by_w1_of_,
            w_S_in_axle_base_2 * H_wheel_1_by_w1,
        );
    // x_axle_base_in_S_1_2*x_axle_base_1_by_w1 + x_axle_base_in_S_1_3*x_axle_base_2_by_w1
    let w3_dot_by_w1_of_place = x_axle_base_in_S_1_3
        .mul_add(x_axle_base_2_by_w1, x_axle_base_in_S_1_2 * x_axle_base_1_by_w1);
    // A*w3 - H_bus_3
    let minus_h_bus_3_plus_a_w3 = A.mul_add(w3, -H_bus_3);
    // x_axle_base_in_S_1_3*x_axle_base_1_by_w1 + x_axle_base_in_S_1_2*x_axle_base_2_by_w1
    let w3_dot_by_w1_of_place_2 = x_axle_base_in_S_1_2
        .mul_add(x_axle_base_2_by_w1, x_axle_base_in_S_1_3 * x_axle_base_1_by_w1);
    // w3_dot_by_phi_of_place_8*w3_dot_by_w1_of_place - 9*minus_h_bus_3_plus_a_w3
    let w3_dot_by_w1_of_w3 = (-minus_h_bus_3_plus_a_w3)
        .mul_add(S::int(9), w3_dot_by_phi_of_place_8 * w3_dot_by_w1_of_place);
    // w3_dot_by_w1_of_place_2 - w3_dot_by_w1_of_w3
    let w3_dot_by_w1_of_w3_2 = w3_dot_by_w1_of_place_2 - w3_dot_by_w1_of_w3;
    // A*w2 - H_bus_2
    let minus_h_bus_2_plus_a_w2 = A.mul_add(w2, -H_bus_2);
    let w3_dot_by_w1_of_place_3 = S::ratio(1, 3) * w3_dot_by_phi_of_place_13;
    // w3_dot_by_w1 = (27*A*w2 - 27*H_bus_2 + x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_2*x_axle_base_1_by_w1 +
    //   x_axle_base_in_S_1_3*x_axle_base_2_by_w1)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - sqrt(3)*(x_axle_base_1_by_w1 + x_axle_base_2_by_w1) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2
    //   + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(9*H_bus_3 - 9*A*w3 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_by_w1 - x_axle_base_in_S_1_2*x_axle_base_2_by_w1 +
    //   (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(x_axle_base_in_S_1_2*x_axle_base_1_by_w1 +
    //   x_axle_base_in_S_1_3*x_axle_base_2_by_w1)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/(3*(9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))))
    let w3_dot_by_w1 = w3_dot_by_w1_of_place_3
        * (-w_S_in_axle_base_2_by_w1_of_ * (x_axle_base_1_by_w1 + x_axle_base_2_by_w1)
            + w3_dot_by_phi_of_place_6 * w3_dot_by_w1_of_place
            - w3_dot_by_phi_of_place_12 * w3_dot_by_w1_of_w3_2
            + S::int(27) * minus_h_bus_2_plus_a_w2);
    let w2_dot_by_w1_of_place = S::int(3) * w3_dot_by_phi_of_place_11;
    let w2_dot_by_w1_of_place_2 = S::ratio(1, 9) * w3_dot_by_phi_of_place_10;
    // w2_dot_by_w1 = (9*H_bus_3 - 9*A*w3 - x_axle_base_in_S_1_3*x_axle_base_1_by_w1 -
    //   x_axle_base_in_S_1_2*x_axle_base_2_by_w1 + (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(x_axle_base_in_S_1_2*x_axle_base_1_by_w1 +
    //   x_axle_base_in_S_1_3*x_axle_base_2_by_w1)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + 3*x_axle_base_1_4*w3_dot_by_w1*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1))/(9*(B + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))
    let w2_dot_by_w1 = w2_dot_by_w1_of_place_2
        * w3_dot_by_w1.mul_add(w2_dot_by_w1_of_place, -w3_dot_by_w1_of_w3_2);
    let w1_dot_by_w1_of_place = S::int(9) * w3_dot_by_phi_of_place_7;
    let w1_dot_by_w1_of_place_2 = S::int(3) * w3_dot_by_phi_of_place_5;
    let w1_dot_by_w1_of_place_3 = S::ratio(1, 9) * w3_dot_by_phi_of_place_3;
    // w1_dot_by_w1 = -(x_axle_base_in_S_1_2*x_axle_base_1_by_w1 + x_axle_base_in_S_1_3*x_axle_base_2_by_w1
    //   + 3*x_axle_base_1_4*w3_dot_by_w1*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3) +
    //   9*w2_dot_by_w1*(x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3))/(9*(A
    //   + x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot_by_w1 = -w1_dot_by_w1_of_place_3
        * (w2_dot_by_w1.mul_add(w1_dot_by_w1_of_place, w3_dot_by_w1_of_place)
            + w3_dot_by_w1 * w1_dot_by_w1_of_place_2);
    let x_axle_base_3_2_times_3 = S::int(3) * x_axle_base_3_2;
    let j_inv = S::int(1) / J;
    let j_inv_by_9 = S::ratio(1, 9) * j_inv;
    // s_dot_by_w1 = (x_axle_base_3_by_w1 - 3*x_axle_base_3_2*(w3_dot_by_w1 + w2_dot_by_w1 +
    //   w1_dot_by_w1))/(9*J)
    let s_dot_by_w1 = j_inv_by_9
        * (x_axle_base_3_by_w1
            - x_axle_base_3_2_times_3 * (w3_dot_by_w1 + w2_dot_by_w1 + w1_dot_by_w1));
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
    // x_axle_base_1_by_w2 = J*w_S_in_axle_base_2*sqrt(3) - H_wheel_2*sqrt(3) - H_wheel_3*(3 + sqrt(3))/2 -
    //   w_S_in_axle_base_3*H_wheel_2_by_w2 + K*(w_W_turn1_3*(3 + sqrt(3)) - w_S_in_axle_base_3*(3 + sqrt(3))
    //   - 6*alpha_W_turn1_in_axle_base_1_by_w2)/2
    let x_axle_base_1_by_w2 = x_axle_base_1_by_w1_of_place_2 - w_S_in_axle_base_3 * H_wheel_2_by_w2
        - k_halved
            * alpha_W_turn1_in_axle_base_1_by_w2
                .mul_add(S::int(6), x_axle_base_2_by_w1_of_place_2)
        - x_axle_base_2_by_w1_of_h_wheel_3;
    // alpha_W_turn1_in_axle_base_2_by_w2 = s*(w_axle_base_in_W_turn1_1_by_w2*cos(phi) +
    //   w_axle_base_in_W_turn1_2_by_w2*sin(phi))
    let alpha_W_turn1_in_axle_base_2_by_w2 = s
        * w_axle_base_in_W_turn1_2_by_w2
            .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w2 * cos_phi);
    // x_axle_base_2_by_w2 = sqrt(3)*(H_wheel_1 - J*w_S_in_axle_base_1) -
    //   H_wheel_3*w_S_in_axle_base_1_by_w2 + K*(w_W_turn1_3*w_S_in_axle_base_1_by_w2 -
    //   3*alpha_W_turn1_in_axle_base_2_by_w2)
    let x_axle_base_2_by_w2 = K
        * (-alpha_W_turn1_in_axle_base_2_by_w2)
            .mul_add(S::int(3), w_W_turn1_3 * w_S_in_axle_base_1_by_w2)
        - H_wheel_3 * w_S_in_axle_base_1_by_w2 - x_axle_base_2_by_w1_of_place_3;
    // x_axle_base_3_by_w2 = w_S_in_axle_base_1_by_w2*(K*w_S_in_axle_base_2 - H_wheel_2) - H_wheel_1*(3 +
    //   sqrt(3))/2 - w_S_in_axle_base_1*H_wheel_2_by_w2
    let x_axle_base_3_by_w2 = (-H_wheel_1)
        .mul_add(
            w_axle_base_in_W_turn1_1_by_w1_of_,
            -w_S_in_axle_base_1 * H_wheel_2_by_w2,
        );
    // B*w3 - H_bus_3
    let minus_h_bus_3_plus_b_w3 = B.mul_add(w3, -H_bus_3);
    // x_axle_base_in_S_1_2*x_axle_base_1_by_w2 + x_axle_base_in_S_1_3*x_axle_base_2_by_w2
    let w3_dot_by_w2_of_place = x_axle_base_in_S_1_3
        .mul_add(x_axle_base_2_by_w2, x_axle_base_in_S_1_2 * x_axle_base_1_by_w2);
    // 9*minus_h_bus_3_plus_b_w3 - w3_dot_by_w2_of_place
    let w3_dot_by_w2_of_w3 = minus_h_bus_3_plus_b_w3
        .mul_add(S::int(9), -w3_dot_by_w2_of_place);
    // -w3_dot_by_w2_of_w3
    let minus_w3_dot_by_w2_of_w3 = -w3_dot_by_w2_of_w3;
    // x_axle_base_in_S_1_3*x_axle_base_1_by_w2 + x_axle_base_in_S_1_2*x_axle_base_2_by_w2
    let w3_dot_by_w2_of_place_2 = x_axle_base_in_S_1_2
        .mul_add(x_axle_base_2_by_w2, x_axle_base_in_S_1_3 * x_axle_base_1_by_w2);
    // w3_dot_by_phi_of_place_8*minus_w3_dot_by_w2_of_w3 - w3_dot_by_w2_of_place_2
    let w3_dot_by_w2_of_w3_2 = w3_dot_by_phi_of_place_8
        .mul_add(minus_w3_dot_by_w2_of_w3, -w3_dot_by_w2_of_place_2);
    // B*w1 - H_bus_1
    let minus_h_bus_1_plus_b_w1 = B.mul_add(w1, -H_bus_1);
    // w3_dot_by_w2 = (27*H_bus_1 - 27*B*w1 + x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(9*H_bus_3 - 9*B*w3 + x_axle_base_in_S_1_2*x_axle_base_1_by_w2 +
    //   x_axle_base_in_S_1_3*x_axle_base_2_by_w2)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - sqrt(3)*(x_axle_base_1_by_w2 + x_axle_base_2_by_w2) +
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2
    //   + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(x_axle_base_in_S_1_3*x_axle_base_1_by_w2 +
    //   x_axle_base_in_S_1_2*x_axle_base_2_by_w2 + (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(9*B*w3 - 9*H_bus_3 - x_axle_base_in_S_1_2*x_axle_base_1_by_w2
    //   - x_axle_base_in_S_1_3*x_axle_base_2_by_w2)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/(3*(9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))))
    let w3_dot_by_w2 = w3_dot_by_w1_of_place_3
        * (-w_S_in_axle_base_2_by_w1_of_ * (x_axle_base_1_by_w2 + x_axle_base_2_by_w2)
            + w3_dot_by_phi_of_place_6 * minus_w3_dot_by_w2_of_w3
            + w3_dot_by_phi_of_place_12 * w3_dot_by_w2_of_w3_2
            - S::int(27) * minus_h_bus_1_plus_b_w1);
    // w2_dot_by_w2 = (x_axle_base_in_S_1_3*x_axle_base_1_by_w2 + x_axle_base_in_S_1_2*x_axle_base_2_by_w2
    //   + (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)*(9*B*w3 - 9*H_bus_3
    //   - x_axle_base_in_S_1_2*x_axle_base_1_by_w2 - x_axle_base_in_S_1_3*x_axle_base_2_by_w2)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) +
    //   3*x_axle_base_1_4*w3_dot_by_w2*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*(1 -
    //   (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w2_dot_by_w2 = w2_dot_by_w1_of_place_2
        * w3_dot_by_w2.mul_add(w2_dot_by_w1_of_place, w3_dot_by_w2_of_w3_2);
    // w1_dot_by_w2 = (9*B*w3 - 9*H_bus_3 - x_axle_base_in_S_1_2*x_axle_base_1_by_w2 -
    //   x_axle_base_in_S_1_3*x_axle_base_2_by_w2 - 3*x_axle_base_1_4*w3_dot_by_w2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3) - 9*w2_dot_by_w2*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3))/(9*(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot_by_w2 = w1_dot_by_w1_of_place_3
        * ((-w2_dot_by_w2).mul_add(w1_dot_by_w1_of_place, w3_dot_by_w2_of_w3)
            - w3_dot_by_w2 * w1_dot_by_w1_of_place_2);
    // s_dot_by_w2 = (x_axle_base_3_by_w2 - 3*x_axle_base_3_2*(w3_dot_by_w2 + w2_dot_by_w2 +
    //   w1_dot_by_w2))/(9*J)
    let s_dot_by_w2 = j_inv_by_9
        * (x_axle_base_3_by_w2
            - x_axle_base_3_2_times_3 * (w3_dot_by_w2 + w2_dot_by_w2 + w1_dot_by_w2));
    // w_axle_base_in_W_turn1_1_by_w3 = sqrt(3)*(sin(phi) + cos(phi))
    let w_axle_base_in_W_turn1_1_by_w3 = w_S_in_axle_base_2_by_w1_of_ * (sin_phi + cos_phi);
    // w_axle_base_in_W_turn1_2_by_w3 = sqrt(3)*(sin(phi) - cos(phi))
    let w_axle_base_in_W_turn1_2_by_w3 = w_S_in_axle_base_2_by_w1_of_ * (sin_phi - cos_phi);
    // alpha_W_turn1_in_axle_base_1_by_w3 = s*(w_axle_base_in_W_turn1_2_by_w3*cos(phi) -
    //   w_axle_base_in_W_turn1_1_by_w3*sin(phi))
    let alpha_W_turn1_in_axle_base_1_by_w3 = s
        * (-w_axle_base_in_W_turn1_1_by_w3)
            .mul_add(sin_phi, w_axle_base_in_W_turn1_2_by_w3 * cos_phi);
    // K*w_W_turn1_3 - H_wheel_3
    let x_axle_base_1_by_w3_of_place = K.mul_add(w_W_turn1_3, -H_wheel_3);
    let k_times_3 = S::int(3) * K;
    // x_axle_base_1_by_w3 = sqrt(3)*(J*w_S_in_axle_base_2 - K*w_W_turn1_3 - H_wheel_2 + H_wheel_3) -
    //   3*K*alpha_W_turn1_in_axle_base_1_by_w3
    let x_axle_base_1_by_w3 = w_S_in_axle_base_2_by_w1_of_
        * (x_axle_base_1_by_w1_of_place - x_axle_base_1_by_w3_of_place)
        - alpha_W_turn1_in_axle_base_1_by_w3 * k_times_3;
    // alpha_W_turn1_in_axle_base_2_by_w3 = s*(w_axle_base_in_W_turn1_1_by_w3*cos(phi) +
    //   w_axle_base_in_W_turn1_2_by_w3*sin(phi))
    let alpha_W_turn1_in_axle_base_2_by_w3 = s
        * w_axle_base_in_W_turn1_2_by_w3
            .mul_add(sin_phi, w_axle_base_in_W_turn1_1_by_w3 * cos_phi);
    // x_axle_base_2_by_w3 = sqrt(3)*(K*w_W_turn1_3 - J*w_S_in_axle_base_1 - H_wheel_3 + H_wheel_1) -
    //   3*K*alpha_W_turn1_in_axle_base_2_by_w3
    let x_axle_base_2_by_w3 = w_S_in_axle_base_2_by_w1_of_
        * (x_axle_base_1_by_w3_of_place - x_axle_base_2_by_w1_of_place)
        - alpha_W_turn1_in_axle_base_2_by_w3 * k_times_3;
    // x_axle_base_3_by_w3 = sqrt(3)*(H_wheel_1 - K*(w_S_in_axle_base_1 - w_S_in_axle_base_2) - H_wheel_2)
    let x_axle_base_3_by_w3 = w_S_in_axle_base_2_by_w1_of_
        * (H_wheel_1 - K * (w_S_in_axle_base_1 - w_S_in_axle_base_2) - H_wheel_2);
    // 9*H_bus_2 - x_axle_base_in_S_1_2*x_axle_base_1_by_w3
    let w3_dot_by_w3_of_place = (-x_axle_base_in_S_1_2)
        .mul_add(x_axle_base_1_by_w3, S::int(9) * H_bus_2);
    // x_axle_base_in_S_1_3*x_axle_base_2_by_w3 + w2*c_times_9
    let w3_dot_by_w3_of_w2 = w2
        .mul_add(c_times_9, x_axle_base_in_S_1_3 * x_axle_base_2_by_w3);
    // w3_dot_by_w3_of_place - w3_dot_by_w3_of_w2
    let w3_dot_by_w3_of_w2_2 = w3_dot_by_w3_of_place - w3_dot_by_w3_of_w2;
    // 9*H_bus_1 + x_axle_base_in_S_1_3*x_axle_base_1_by_w3
    let w3_dot_by_w3_of_place_2 = x_axle_base_in_S_1_3
        .mul_add(x_axle_base_1_by_w3, S::int(9) * H_bus_1);
    // x_axle_base_in_S_1_2*x_axle_base_2_by_w3 + w3_dot_by_phi_of_place_8*w3_dot_by_w3_of_w2_2
    let w3_dot_by_w3_of_w2_3 = w3_dot_by_phi_of_place_8
        .mul_add(w3_dot_by_w3_of_w2_2, x_axle_base_in_S_1_2 * x_axle_base_2_by_w3);
    // w1*c_times_9 - w3_dot_by_w3_of_place_2
    let w3_dot_by_w3_of_w1 = w1.mul_add(c_times_9, -w3_dot_by_w3_of_place_2);
    // w3_dot_by_w3_of_w2_3 - w3_dot_by_w3_of_w1
    let w3_dot_by_w3_of_w1_w2 = w3_dot_by_w3_of_w2_3 - w3_dot_by_w3_of_w1;
    // w3_dot_by_w3 = -(sqrt(3)*(x_axle_base_1_by_w3 + x_axle_base_2_by_w3) +
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*(9*H_bus_2 - 9*C*w2 -
    //   x_axle_base_in_S_1_2*x_axle_base_1_by_w3 - x_axle_base_in_S_1_3*x_axle_base_2_by_w3)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3) +
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2
    //   + x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(9*H_bus_1 - 9*C*w1 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_by_w3 + x_axle_base_in_S_1_2*x_axle_base_2_by_w3 +
    //   (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)*(9*H_bus_2 - 9*C*w2 -
    //   x_axle_base_in_S_1_2*x_axle_base_1_by_w3 - x_axle_base_in_S_1_3*x_axle_base_2_by_w3)/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))/(B +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3 -
    //   (x_axle_base_in_S_1_3*x_axle_base_1_2 + x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3)))/(3*(9*C +
    //   x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))))
    let w3_dot_by_w3 = -w3_dot_by_w1_of_place_3
        * (w_S_in_axle_base_2_by_w1_of_ * (x_axle_base_1_by_w3 + x_axle_base_2_by_w3)
            + w3_dot_by_phi_of_place_6 * w3_dot_by_w3_of_w2_2
            + w3_dot_by_phi_of_place_12 * w3_dot_by_w3_of_w1_w2);
    // w2_dot_by_w3 = (9*H_bus_1 - 9*C*w1 + x_axle_base_in_S_1_3*x_axle_base_1_by_w3 +
    //   x_axle_base_in_S_1_2*x_axle_base_2_by_w3 + (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(9*H_bus_2 - 9*C*w2 - x_axle_base_in_S_1_2*x_axle_base_1_by_w3
    //   - x_axle_base_in_S_1_3*x_axle_base_2_by_w3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + 3*x_axle_base_1_4*w3_dot_by_w3*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(1 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w2_dot_by_w3 = w2_dot_by_w1_of_place_2
        * w3_dot_by_w3.mul_add(w2_dot_by_w1_of_place, -w3_dot_by_w3_of_w1_w2);
    // w1_dot_by_w3 = (9*H_bus_2 - 9*C*w2 - x_axle_base_in_S_1_2*x_axle_base_1_by_w3 -
    //   x_axle_base_in_S_1_3*x_axle_base_2_by_w3 - 3*x_axle_base_1_4*w3_dot_by_w3*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3) - 9*w2_dot_by_w3*(x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3))/(9*(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot_by_w3 = w1_dot_by_w1_of_place_3
        * ((-w2_dot_by_w3).mul_add(w1_dot_by_w1_of_place, w3_dot_by_w3_of_w2_2)
            - w3_dot_by_w3 * w1_dot_by_w1_of_place_2);
    // s_dot_by_w3 = (x_axle_base_3_by_w3 - 3*x_axle_base_3_2*(w3_dot_by_w3 + w2_dot_by_w3 +
    //   w1_dot_by_w3))/(9*J)
    let s_dot_by_w3 = j_inv_by_9
        * (x_axle_base_3_by_w3
            - x_axle_base_3_2_times_3 * (w3_dot_by_w3 + w2_dot_by_w3 + w1_dot_by_w3));
    // alpha_W_turn1_in_axle_base_1_by_s = w_axle_base_in_W_turn1_2*cos(phi) -
    //   w_axle_base_in_W_turn1_1*sin(phi)
    let alpha_W_turn1_in_axle_base_1_by_s = (-w_axle_base_in_W_turn1_1)
        .mul_add(sin_phi, w_axle_base_in_W_turn1_2 * cos_phi);
    // alpha_W_turn1_in_axle_base_2_by_s = w_axle_base_in_W_turn1_1*cos(phi) +
    //   w_axle_base_in_W_turn1_2*sin(phi)
    let alpha_W_turn1_in_axle_base_2_by_s = w_axle_base_in_W_turn1_2
        .mul_add(sin_phi, w_axle_base_in_W_turn1_1 * cos_phi);
    // j_w_s_in_axle_base_2 - K*(w_S_in_axle_base_2 + alpha_W_turn1_in_axle_base_1_by_s)
    let w3_dot_by_s_of_place = j_w_s_in_axle_base_2
        - K * (w_S_in_axle_base_2 + alpha_W_turn1_in_axle_base_1_by_s);
    // K*(alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1) + j_w_s_in_axle_base_1
    let w3_dot_by_s_of_place_2 = K * (alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1)
        + j_w_s_in_axle_base_1;
    // x_axle_base_in_S_1_2*w3_dot_by_s_of_place - x_axle_base_in_S_1_3*w3_dot_by_s_of_place_2
    let w3_dot_by_s_of_place_3 = (-x_axle_base_in_S_1_3)
        .mul_add(w3_dot_by_s_of_place_2, x_axle_base_in_S_1_2 * w3_dot_by_s_of_place);
    // x_axle_base_in_S_1_2*w3_dot_by_s_of_place_2 - x_axle_base_in_S_1_3*w3_dot_by_s_of_place
    let w3_dot_by_s_of_place_4 = (-x_axle_base_in_S_1_3)
        .mul_add(w3_dot_by_s_of_place, x_axle_base_in_S_1_2 * w3_dot_by_s_of_place_2);
    // w3_dot_by_phi_of_place_8*w3_dot_by_s_of_place_3 + w3_dot_by_s_of_place_4
    let w3_dot_by_s_of_place_5 = w3_dot_by_phi_of_place_8
        .mul_add(w3_dot_by_s_of_place_3, w3_dot_by_s_of_place_4);
    // w3_dot_by_s = -(sqrt(3)*(J*w_S_in_axle_base_2 - J*w_S_in_axle_base_1 - K*(w_S_in_axle_base_2 +
    //   alpha_W_turn1_in_axle_base_1_by_s) + K*(w_S_in_axle_base_1 - alpha_W_turn1_in_axle_base_2_by_s)) +
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(x_axle_base_in_S_1_3*(J*w_S_in_axle_base_1 +
    //   K*(alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1)) -
    //   x_axle_base_in_S_1_2*(J*w_S_in_axle_base_2 - K*(w_S_in_axle_base_2 +
    //   alpha_W_turn1_in_axle_base_1_by_s)))/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)*(x_axle_base_in_S_1_3*(J*w_S_in_axle_base_2 -
    //   K*(w_S_in_axle_base_2 + alpha_W_turn1_in_axle_base_1_by_s)) -
    //   x_axle_base_in_S_1_2*(J*w_S_in_axle_base_1 + K*(alpha_W_turn1_in_axle_base_2_by_s -
    //   w_S_in_axle_base_1)) + (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)*(x_axle_base_in_S_1_3*(J*w_S_in_axle_base_1 +
    //   K*(alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1)) -
    //   x_axle_base_in_S_1_2*(J*w_S_in_axle_base_2 - K*(w_S_in_axle_base_2 +
    //   alpha_W_turn1_in_axle_base_1_by_s)))/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))/(B + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(9*C + x_axle_base_1_4^2*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)^2*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - 1)^2/((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*(2*sqrt(3) -
    //   x_axle_base_1_4*(x_axle_base_in_S_1_2 + x_axle_base_in_S_1_3)^2/(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3)))
    let w3_dot_by_s = w3_dot_by_phi_of_place_13
        * (-w_S_in_axle_base_2_by_w1_of_ * (w3_dot_by_s_of_place - w3_dot_by_s_of_place_2)
            + w3_dot_by_phi_of_place_6 * w3_dot_by_s_of_place_3
            + w3_dot_by_phi_of_place_12 * w3_dot_by_s_of_place_5);
    // w2_dot_by_s = (x_axle_base_in_S_1_3*(J*w_S_in_axle_base_2 - K*(w_S_in_axle_base_2 +
    //   alpha_W_turn1_in_axle_base_1_by_s)) - x_axle_base_in_S_1_2*(J*w_S_in_axle_base_1 +
    //   K*(alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1)) + (x_axle_base_in_S_1_3*x_axle_base_1_2
    //   + x_axle_base_in_S_1_2*x_axle_base_1_3)*(x_axle_base_in_S_1_3*(J*w_S_in_axle_base_1 +
    //   K*(alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1)) -
    //   x_axle_base_in_S_1_2*(J*w_S_in_axle_base_2 - K*(w_S_in_axle_base_2 +
    //   alpha_W_turn1_in_axle_base_1_by_s)))/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) + x_axle_base_1_4*w3_dot_by_s*(x_axle_base_in_S_1_2 +
    //   x_axle_base_in_S_1_3)*(1 - (x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3)))/(3*((x_axle_base_in_S_1_3*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_2*x_axle_base_1_3)^2/(A + x_axle_base_in_S_1_2*x_axle_base_1_2 +
    //   x_axle_base_in_S_1_3*x_axle_base_1_3) - B - x_axle_base_in_S_1_2*x_axle_base_1_2 -
    //   x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w2_dot_by_s = w2_dot_by_phi_of_place
        * w3_dot_by_s.mul_add(w3_dot_by_phi_of_place_11, w3_dot_by_s_of_place_5);
    let w1_dot_by_s_of_place = x_axle_base_1_4 * w3_dot_by_s;
    let w2_dot_by_s_times_3 = S::int(3) * w2_dot_by_s;
    // w1_dot_by_s = -(x_axle_base_in_S_1_2*(J*w_S_in_axle_base_2 - K*(w_S_in_axle_base_2 +
    //   alpha_W_turn1_in_axle_base_1_by_s) + x_axle_base_1_4*w3_dot_by_s + 3*x_axle_base_1_3*w2_dot_by_s) +
    //   x_axle_base_in_S_1_3*(x_axle_base_1_4*w3_dot_by_s - J*w_S_in_axle_base_1 -
    //   K*(alpha_W_turn1_in_axle_base_2_by_s - w_S_in_axle_base_1) + 3*x_axle_base_1_2*w2_dot_by_s))/(3*(A +
    //   x_axle_base_in_S_1_2*x_axle_base_1_2 + x_axle_base_in_S_1_3*x_axle_base_1_3))
    let w1_dot_by_s = -w1_dot_by_phi_of_place
        * (x_axle_base_in_S_1_2
            * x_axle_base_1_3
                .mul_add(
                    w2_dot_by_s_times_3,
                    w3_dot_by_s_of_place + w1_dot_by_s_of_place,
                )
            + x_axle_base_in_S_1_3
                * x_axle_base_1_2
                    .mul_add(
                        w2_dot_by_s_times_3,
                        w1_dot_by_s_of_place - w3_dot_by_s_of_place_2,
                    ));
    let w1_halved = S::ratio(1, 2) * w1;
    let w2_halved = S::ratio(1, 2) * w2;
    let w3_halved = S::ratio(1, 2) * w3;
    let e1_halved = S::ratio(1, 2) * e1;
    let e2_halved = S::ratio(1, 2) * e2;
    let e3_halved = S::ratio(1, 2) * e3;
    let e0_halved = S::ratio(1, 2) * e0;
    let s_dot_by_phi_value_of_place = S::ratio(1, 3) * x_axle_base_3_2 * j_inv;
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
    // d(s')/d(phi) = -x_axle_base_3_2*(w3_dot_by_phi + w2_dot_by_phi + w1_dot_by_phi)/(3*J)
    let s_dot_by_phi_value = -s_dot_by_phi_value_of_place
        * (w3_dot_by_phi + w2_dot_by_phi + w1_dot_by_phi);
    // d(s')/d(s) = -x_axle_base_3_2*(w3_dot_by_s + w2_dot_by_s + w1_dot_by_s)/(3*J)
    let s_dot_by_s_value = -s_dot_by_phi_value_of_place * (w3_dot_by_s + w2_dot_by_s + w1_dot_by_s);
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
            zero, zero, zero, zero, w1_dot_by_phi, w1_dot_by_w1, w1_dot_by_w2, w1_dot_by_w3,
            w1_dot_by_s,
        ],
        [
            zero, zero, zero, zero, w2_dot_by_phi, w2_dot_by_w1, w2_dot_by_w2, w2_dot_by_w3,
            w2_dot_by_s,
        ],
        [
            zero, zero, zero, zero, w3_dot_by_phi, w3_dot_by_w1, w3_dot_by_w2, w3_dot_by_w3,
            w3_dot_by_s,
        ],
        [
            zero, zero, zero, zero, s_dot_by_phi_value, s_dot_by_w1, s_dot_by_w2, s_dot_by_w3,
            s_dot_by_s_value,
        ],
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 36 convolutions and 128 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 9]],
    history: &mut [Factors<S, 40>],
) {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0_0, e1_0, e2_0, e3_0, phi_0, w1_0, w2_0, w3_0, s_0] = series[0];
    // Shared terms.
    let t_sqrt_3_of_ = (S::int(3)).sqrt();
    // 3 + sqrt(3)
    let weight_3_of_ = S::int(3) + t_sqrt_3_of_;
    let weight_3_of__2 = S::int(1) / weight_3_of_;
    // 1/(3 + sqrt(3)) - 1
    let weight_8_of_ = weight_3_of__2 - S::int(1);
    let t_sqrt_3_of_t = T * t_sqrt_3_of_;
    let k_sqrt_3_of_k = K * t_sqrt_3_of_;
    let weight_8_of_k = K * weight_8_of_ * weight_8_of_;
    let weight_8_of_k_2 = K / (weight_3_of_ * weight_3_of_);
    // 2/(3 + sqrt(3)) - 1
    let weight_8_of__2 = weight_3_of__2.mul_add(S::int(2), -S::int(1));
    // A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2
    let weight_8_of_a_k = A + weight_8_of_k_2 + weight_8_of_k;
    let weight_8_of_a_k_2 = K * weight_8_of_ / (weight_3_of_ * weight_8_of_a_k);
    // B + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 +
    //   sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2))
    let weight_8_of_a_b_k = B + weight_8_of_k_2 + weight_8_of_k
        - S::int(4) * K * K * weight_8_of_ * weight_8_of_
            / (weight_3_of_ * weight_3_of_ * weight_8_of_a_k);
    // 2*K*(1/(3 + sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1
    let weight_8_of_a_k_3 = weight_8_of_a_k_2.mul_add(S::int(2), -S::int(1));
    // 9*C + 3*K^2*(2/(3 + sqrt(3)) - 1)^2*(2*K*(1/(3 + sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2
    //   + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)^2/(4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - B - K/(3 + sqrt(3))^2 - K*(1/(3 + sqrt(3)) - 1)^2) +
    //   K*sqrt(3)*(2*sqrt(3) - K*sqrt(3)*(2/(3 + sqrt(3)) - 1)^2/(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3))
    //   - 1)^2))
    let weight_12_of_a_b_c_k = -S::int(3) * K * K * weight_8_of__2 * weight_8_of__2
        * weight_8_of_a_k_3 * weight_8_of_a_k_3 / weight_8_of_a_b_k + S::int(9) * C
        + K * t_sqrt_3_of_
            * t_sqrt_3_of_
                .mul_add(
                    S::int(2),
                    -K * t_sqrt_3_of_ * weight_8_of__2 * weight_8_of__2 / weight_8_of_a_k,
                );
    // Constant in time.
    // t_sqrt_3 = T*sqrt(3)
    let t_sqrt_3 = t_sqrt_3_of_t;
    // weight = 3*C
    let weight = S::int(3) * C;
    // minus_3_b = -3*B
    let minus_3_b = -S::int(3) * B;
    // weight_2 = 3*A
    let weight_2 = S::int(3) * A;
    // minus_3_c = -3*C
    let minus_3_c = -S::int(3) * C;
    // weight_3 = 3/(3 + sqrt(3)) - 3
    let weight_3 = weight_3_of__2.mul_add(S::int(3), -S::int(3));
    // weight_4 = 3/(3 + sqrt(3))
    let weight_4 = S::int(3) * weight_3_of__2;
    // sqrt_3 = sqrt(3)
    let sqrt_3 = t_sqrt_3_of_;
    // j_minus_k = J - K
    let j_minus_k = J - K;
    // k_sqrt_3 = K*sqrt(3)
    let k_sqrt_3 = k_sqrt_3_of_k;
    // minus_k_sqrt_3 = -K*sqrt(3)
    let minus_k_sqrt_3 = -k_sqrt_3_of_k;
    // weight_5 = 3*K
    let weight_5 = S::int(3) * K;
    // minus_3_k = -3*K
    let minus_3_k = -S::int(3) * K;
    // weight_6 = 9*T*sqrt(3)
    let weight_6 = S::int(9) * t_sqrt_3_of_t;
    // weight_7 = 27*B
    let weight_7 = S::int(27) * B;
    // minus_27_a = -27*A
    let minus_27_a = -S::int(27) * A;
    // weight_8 = sqrt(3) + K*sqrt(3)*(1 - 1/(3 + sqrt(3)))*(2/(3 + sqrt(3)) - 1)/(A + K/(3 + sqrt(3))^2 +
    //   K*(1/(3 + sqrt(3)) - 1)^2) + K*sqrt(3)*(2/(3 + sqrt(3)) - 1)*(2*K*(1/(3 + sqrt(3)) - 1)/((3 +
    //   sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)/((3 + sqrt(3))*(B + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)))) + 2*K^2*sqrt(3)*(1/(3 + sqrt(3)) - 1)^2*(1 - 2/(3 +
    //   sqrt(3)))*(2*K*(1/(3 + sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) -
    //   1)^2)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)*(B + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2))))
    let weight_8 = t_sqrt_3_of_ - K * t_sqrt_3_of_ * weight_8_of_ * weight_8_of__2 / weight_8_of_a_k
        + K * t_sqrt_3_of_ * weight_8_of__2 * weight_8_of_a_k_3 / (weight_3_of_ * weight_8_of_a_b_k)
        - S::int(2) * K * K * t_sqrt_3_of_ * weight_8_of_ * weight_8_of_ * weight_8_of__2
            * weight_8_of_a_k_3 / (weight_3_of_ * weight_8_of_a_k * weight_8_of_a_b_k);
    // weight_9 = sqrt(3) + K*sqrt(3)*(1 - 2/(3 + sqrt(3)))/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3
    //   + sqrt(3)) - 1)^2)) + K*sqrt(3)*(1/(3 + sqrt(3)) - 1)*(2/(3 + sqrt(3)) - 1)*(2*K*(1/(3 + sqrt(3)) -
    //   1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)/(B + K/(3 + sqrt(3))^2 +
    //   K*(1/(3 + sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 +
    //   K*(1/(3 + sqrt(3)) - 1)^2))) + 2*K^2*sqrt(3)*(1 - 1/(3 + sqrt(3)))*(2/(3 + sqrt(3)) - 1)*(2*K*(1/(3
    //   + sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)/((3 +
    //   sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)*(B + K/(3 + sqrt(3))^2 + K*(1/(3 +
    //   sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 +
    //   sqrt(3)) - 1)^2))))
    let weight_9 = t_sqrt_3_of_
        - K * t_sqrt_3_of_ * weight_8_of__2 / (weight_3_of_ * weight_8_of_a_k)
        + K * t_sqrt_3_of_ * weight_8_of_ * weight_8_of__2 * weight_8_of_a_k_3 / weight_8_of_a_b_k
        - S::int(2) * K * K * t_sqrt_3_of_ * weight_8_of_ * weight_8_of__2 * weight_8_of_a_k_3
            / (weight_3_of_ * weight_3_of_ * weight_8_of_a_k * weight_8_of_a_b_k);
    // weight_10 = 3*K*sqrt(3)*(1 - 2/(3 + sqrt(3)))*(1 + 2*K*(1/(3 + sqrt(3)) - 1)*(2*K*(1/(3 + sqrt(3)) -
    //   1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)/((3 + sqrt(3))*(B + K/(3
    //   + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3
    //   + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)))))/(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)
    let weight_10 = -S::int(3) * K * t_sqrt_3_of_ * weight_8_of__2
        * (S::int(1)
            + S::int(2) * K * weight_8_of_ * weight_8_of_a_k_3
                / (weight_3_of_ * weight_8_of_a_b_k)) / weight_8_of_a_k;
    // weight_11 = 3*K*sqrt(3)*(2/(3 + sqrt(3)) - 1)*(2*K*(1/(3 + sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)/(B + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2 -
    //   4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)))
    let weight_11 = S::int(3) * K * t_sqrt_3_of_ * weight_8_of__2 * weight_8_of_a_k_3
        / weight_8_of_a_b_k;
    // weight_12 = K*sqrt(3)*(2/(3 + sqrt(3)) - 1)*(2*K*(1/(3 + sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)/(9*C + 3*K^2*(2/(3 + sqrt(3)) - 1)^2*(2*K*(1/(3 +
    //   sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) -
    //   1)^2/(4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) -
    //   1)^2)) - B - K/(3 + sqrt(3))^2 - K*(1/(3 + sqrt(3)) - 1)^2) + K*sqrt(3)*(2*sqrt(3) - K*sqrt(3)*(2/(3
    //   + sqrt(3)) - 1)^2/(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)))
    let weight_12 = K * t_sqrt_3_of_ * weight_8_of__2 * weight_8_of_a_k_3 / weight_12_of_a_b_c_k;
    // weight_13 = 1/(3 + sqrt(3)) - 2*K*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 +
    //   K*(1/(3 + sqrt(3)) - 1)^2))
    let weight_13 = weight_3_of__2
        - S::int(2) * K * weight_8_of_ * weight_8_of_ / (weight_3_of_ * weight_8_of_a_k);
    // weight_14 = 1/(3 + sqrt(3)) - 1 + 2*K*(1 - 1/(3 + sqrt(3)))/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2
    //   + K*(1/(3 + sqrt(3)) - 1)^2))
    let weight_14 = weight_3_of__2 - S::int(1)
        - S::int(2) * K * weight_8_of_ / (weight_3_of_ * weight_3_of_ * weight_8_of_a_k);
    // weight_15 = 6*K*(1 - 1/(3 + sqrt(3)))/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) -
    //   1)^2))
    let weight_15 = -S::int(6) * weight_8_of_a_k_2;
    // weight_16 = 1/(3 + sqrt(3)) - 1
    let weight_16 = weight_8_of_;
    // weight_17 = 1/(3 + sqrt(3))
    let weight_17 = weight_3_of__2;
    // weight_18 = K*sqrt(3)*(1 - 2/(3 + sqrt(3)))/(9*C + 3*K^2*(2/(3 + sqrt(3)) - 1)^2*(2*K*(1/(3 +
    //   sqrt(3)) - 1)/((3 + sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) -
    //   1)^2/(4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) -
    //   1)^2)) - B - K/(3 + sqrt(3))^2 - K*(1/(3 + sqrt(3)) - 1)^2) + K*sqrt(3)*(2*sqrt(3) - K*sqrt(3)*(2/(3
    //   + sqrt(3)) - 1)^2/(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)))
    let weight_18 = -K * t_sqrt_3_of_ * weight_8_of__2 / weight_12_of_a_b_c_k;
    // weight_19 = 2*K*(1 - 1/(3 + sqrt(3)))/((3 + sqrt(3))*(B + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) -
    //   1)^2 - 4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) -
    //   1)^2))))
    let weight_19 = -S::int(2) * K * weight_8_of_ / (weight_3_of_ * weight_8_of_a_b_k);
    // weight_20 = 9*T
    let weight_20 = S::int(9) * T;
    // minus_k = -K
    let minus_k = -K;
    // weight_21 = J*sqrt(3)/(3*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2))
    let weight_21 = S::ratio(1, 3) * J * t_sqrt_3_of_ / weight_8_of_a_k;
    // weight_22 = J*sqrt(3)/(3*(B + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2 - 4*K^2*(1/(3 + sqrt(3))
    //   - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2))))
    let weight_22 = S::ratio(1, 3) * J * t_sqrt_3_of_ / weight_8_of_a_b_k;
    // weight_23 = J*sqrt(3)/(9*C + 3*K^2*(2/(3 + sqrt(3)) - 1)^2*(2*K*(1/(3 + sqrt(3)) - 1)/((3 +
    //   sqrt(3))*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)^2/(4*K^2*(1/(3 + sqrt(3)) -
    //   1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - B - K/(3 + sqrt(3))^2 -
    //   K*(1/(3 + sqrt(3)) - 1)^2) + K*sqrt(3)*(2*sqrt(3) - K*sqrt(3)*(2/(3 + sqrt(3)) - 1)^2/(A + K/(3 +
    //   sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)))
    let weight_23 = J * t_sqrt_3_of_ / weight_12_of_a_b_c_k;
    // weight_24 = -1/(9*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2))
    let weight_24 = -S::ratio(1, 9) / weight_8_of_a_k;
    // weight_25 = 1/(9*(4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 + sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 +
    //   sqrt(3)) - 1)^2)) - B - K/(3 + sqrt(3))^2 - K*(1/(3 + sqrt(3)) - 1)^2))
    let weight_25 = -S::ratio(1, 9) / weight_8_of_a_b_k;
    // weight_26 = -1/(3*(9*C + 3*K^2*(2/(3 + sqrt(3)) - 1)^2*(2*K*(1/(3 + sqrt(3)) - 1)/((3 + sqrt(3))*(A
    //   + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - 1)^2/(4*K^2*(1/(3 + sqrt(3)) - 1)^2/((3 +
    //   sqrt(3))^2*(A + K/(3 + sqrt(3))^2 + K*(1/(3 + sqrt(3)) - 1)^2)) - B - K/(3 + sqrt(3))^2 - K*(1/(3 +
    //   sqrt(3)) - 1)^2) + K*sqrt(3)*(2*sqrt(3) - K*sqrt(3)*(2/(3 + sqrt(3)) - 1)^2/(A + K/(3 + sqrt(3))^2 +
    //   K*(1/(3 + sqrt(3)) - 1)^2))))
    let weight_26 = -S::ratio(1, 3) / weight_12_of_a_b_c_k;
    // weight_27 = 1/(9*J)
    let weight_27 = S::ratio(1, 9) / J;
    // Order 0.
    let w2_w3_0 = w2_0 * w3_0;
    let w2_w3_2_0 = w3_0 * w2_0;
    let x_S_1_of_w2_w3_0 = w2_w3_2_0
        .mul_add(minus_3_b, w2_w3_0.mul_add(weight, t_sqrt_3));
    let w1_w3_0 = w3_0 * w1_0;
    let w1_w3_2_0 = w1_0 * w3_0;
    let x_S_2_of_w1_w3_0 = w1_w3_2_0
        .mul_add(minus_3_c, w1_w3_0.mul_add(weight_2, t_sqrt_3));
    let w1_w2_0 = w1_0 * w2_0;
    let w1_w2_2_0 = w2_0 * w1_0;
    let w_S_in_axle_base_1_of_w1_w2_w3_0 = w3_0
        .mul_add(sqrt_3, w2_0.mul_add(weight_4, weight_3 * w1_0));
    let w_S_in_axle_base_2_of_w1_w2_w3_0 = w2_0
        .mul_add(weight_3, w1_0.mul_add(weight_4, sqrt_3 * w3_0));
    let w1_plus_w2_plus_w3_0 = w1_0 + w2_0 + w3_0;
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let w_axle_base_in_W_turn1_1_of_w1_w2_w3_0 = cos_phi_0 * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_1_of_w1_w2_w3_2_0 = sin_phi_0 * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_1_of_place_0 = w_axle_base_in_W_turn1_1_of_w1_w2_w3_0
        + w_axle_base_in_W_turn1_1_of_w1_w2_w3_2_0;
    let w_axle_base_in_W_turn1_2_of_w1_w2_w3_0 = sin_phi_0 * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_2_of_w1_w2_w3_2_0 = cos_phi_0 * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let w_axle_base_in_W_turn1_2_of_place_0 = w_axle_base_in_W_turn1_2_of_w1_w2_w3_0
        - w_axle_base_in_W_turn1_2_of_w1_w2_w3_2_0;
    let w_W_turn1_3_of_s_0 = w1_plus_w2_plus_w3_0.mul_add(sqrt_3, S::int(3) * s_0);
    let alpha_W_turn1_in_axle_base_1_of_place_0 = sin_phi_0 * w_axle_base_in_W_turn1_1_of_place_0;
    let alpha_W_turn1_in_axle_base_1_of_place_2_0 = cos_phi_0 * w_axle_base_in_W_turn1_2_of_place_0;
    let alpha_W_turn1_in_axle_base_1_of_place_3_0 = alpha_W_turn1_in_axle_base_1_of_place_0
        - alpha_W_turn1_in_axle_base_1_of_place_2_0;
    let alpha_W_turn1_in_axle_base_1_of_s_0 = s_0 * alpha_W_turn1_in_axle_base_1_of_place_3_0;
    let x_axle_base_1_of_w1_w2_w3_0 = w1_plus_w2_plus_w3_0 * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let x_axle_base_1_of_place_0 = w_W_turn1_3_of_s_0
        .mul_add(j_minus_k, k_sqrt_3 * w1_plus_w2_plus_w3_0);
    let x_axle_base_1_of_w1_w2_w3_2_0 = w_S_in_axle_base_2_of_w1_w2_w3_0 * x_axle_base_1_of_place_0;
    let x_axle_base_1_of_place_2_0 = alpha_W_turn1_in_axle_base_1_of_s_0
        .mul_add(
            weight_5,
            minus_k_sqrt_3 * x_axle_base_1_of_w1_w2_w3_0 + x_axle_base_1_of_w1_w2_w3_2_0,
        );
    let alpha_W_turn1_in_axle_base_2_of_place_0 = sin_phi_0 * w_axle_base_in_W_turn1_2_of_place_0;
    let alpha_W_turn1_in_axle_base_2_of_place_2_0 = cos_phi_0 * w_axle_base_in_W_turn1_1_of_place_0;
    let alpha_W_turn1_in_axle_base_2_of_place_3_0 = alpha_W_turn1_in_axle_base_2_of_place_0
        + alpha_W_turn1_in_axle_base_2_of_place_2_0;
    let alpha_W_turn1_in_axle_base_2_of_s_0 = s_0 * alpha_W_turn1_in_axle_base_2_of_place_3_0;
    let x_axle_base_2_of_w1_w2_w3_0 = w1_plus_w2_plus_w3_0 * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let x_axle_base_2_of_w1_w2_w3_2_0 = w_S_in_axle_base_1_of_w1_w2_w3_0 * x_axle_base_1_of_place_0;
    let x_axle_base_2_of_place_0 = alpha_W_turn1_in_axle_base_2_of_s_0
        .mul_add(
            minus_3_k,
            k_sqrt_3 * x_axle_base_2_of_w1_w2_w3_0 - x_axle_base_2_of_w1_w2_w3_2_0,
        );
    let x_axle_base_3_of_w1_w2_w3_0 = w_S_in_axle_base_1_of_w1_w2_w3_0
        * w_S_in_axle_base_2_of_w1_w2_w3_0;
    let x_axle_base_3_of_w1_w2_w3_2_0 = w_S_in_axle_base_2_of_w1_w2_w3_0
        * w_S_in_axle_base_1_of_w1_w2_w3_0;
    let w3_dot_of_place_0 = x_axle_base_2_of_place_0
        .mul_add(
            weight_9,
            x_axle_base_1_of_place_2_0
                .mul_add(
                    weight_8,
                    x_S_2_of_w1_w3_0
                        .mul_add(
                            weight_11,
                            x_S_1_of_w2_w3_0
                                .mul_add(
                                    weight_10,
                                    w1_w2_2_0
                                        .mul_add(minus_27_a, w1_w2_0.mul_add(weight_7, weight_6)),
                                ),
                        ),
                ),
        );
    let w2_dot_of_w3_dot_0 = w3_dot_of_place_0
        .mul_add(
            weight_12,
            x_axle_base_2_of_place_0
                .mul_add(
                    weight_14,
                    x_axle_base_1_of_place_2_0
                        .mul_add(
                            weight_13,
                            x_S_1_of_w2_w3_0
                                .mul_add(weight_15, S::int(3) * x_S_2_of_w1_w3_0),
                        ),
                ),
        );
    let w1_dot_of_motion_0 = w2_dot_of_w3_dot_0
        .mul_add(
            weight_19,
            w3_dot_of_place_0
                .mul_add(
                    weight_18,
                    x_axle_base_2_of_place_0
                        .mul_add(
                            weight_17,
                            x_axle_base_1_of_place_2_0
                                .mul_add(weight_16, S::int(3) * x_S_1_of_w2_w3_0),
                        ),
                ),
        );
    let s_dot_of_motion_0 = w1_dot_of_motion_0
        .mul_add(
            weight_21,
            w2_dot_of_w3_dot_0
                .mul_add(
                    weight_22,
                    w3_dot_of_place_0
                        .mul_add(
                            weight_23,
                            x_axle_base_3_of_w1_w2_w3_2_0
                                .mul_add(
                                    K,
                                    x_axle_base_3_of_w1_w2_w3_0.mul_add(minus_k, weight_20),
                                ),
                        ),
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
    let w1_1 = weight_24 * w1_dot_of_motion_0;
    let w2_1 = weight_25 * w2_dot_of_w3_dot_0;
    let w3_1 = weight_26 * w3_dot_of_place_0;
    let s_1 = weight_27 * s_dot_of_motion_0;
    if series.len() > 1 {
        series[1] = [e0_1, e1_1, e2_1, e3_1, phi_1, w1_1, w2_1, w3_1, s_1];
    }
    let w2_w3_1 = w3_1.mul_add(w2_0, w2_1 * w3_0);
    let w2_w3_2_1 = w2_1.mul_add(w3_0, w3_1 * w2_0);
    let x_S_1_of_w2_w3_1 = w2_w3_2_1.mul_add(minus_3_b, weight * w2_w3_1);
    let w1_w3_1 = w1_1.mul_add(w3_0, w3_1 * w1_0);
    let w1_w3_2_1 = w3_1.mul_add(w1_0, w1_1 * w3_0);
    let x_S_2_of_w1_w3_1 = w1_w3_2_1.mul_add(minus_3_c, weight_2 * w1_w3_1);
    let w1_w2_1 = w2_1.mul_add(w1_0, w1_1 * w2_0);
    let w1_w2_2_1 = w1_1.mul_add(w2_0, w2_1 * w1_0);
    let w_S_in_axle_base_1_of_w1_w2_w3_1 = w3_1
        .mul_add(sqrt_3, w2_1.mul_add(weight_4, weight_3 * w1_1));
    let w_S_in_axle_base_2_of_w1_w2_w3_1 = w2_1
        .mul_add(weight_3, w1_1.mul_add(weight_4, sqrt_3 * w3_1));
    let w1_plus_w2_plus_w3_1 = w1_1 + w2_1 + w3_1;
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
    let w_W_turn1_3_of_s_1 = w1_plus_w2_plus_w3_1.mul_add(sqrt_3, S::int(3) * s_1);
    let alpha_W_turn1_in_axle_base_1_of_place_1 = w_axle_base_in_W_turn1_1_of_place_1
        .mul_add(sin_phi_0, sin_phi_1 * w_axle_base_in_W_turn1_1_of_place_0);
    let alpha_W_turn1_in_axle_base_1_of_place_2_1 = w_axle_base_in_W_turn1_2_of_place_1
        .mul_add(cos_phi_0, cos_phi_1 * w_axle_base_in_W_turn1_2_of_place_0);
    let alpha_W_turn1_in_axle_base_1_of_place_3_1 = alpha_W_turn1_in_axle_base_1_of_place_1
        - alpha_W_turn1_in_axle_base_1_of_place_2_1;
    let alpha_W_turn1_in_axle_base_1_of_s_1 = alpha_W_turn1_in_axle_base_1_of_place_3_1
        .mul_add(s_0, s_1 * alpha_W_turn1_in_axle_base_1_of_place_3_0);
    let x_axle_base_1_of_w1_w2_w3_1 = w_S_in_axle_base_2_of_w1_w2_w3_1
        .mul_add(
            w1_plus_w2_plus_w3_0,
            w1_plus_w2_plus_w3_1 * w_S_in_axle_base_2_of_w1_w2_w3_0,
        );
    let x_axle_base_1_of_place_1 = w_W_turn1_3_of_s_1
        .mul_add(j_minus_k, k_sqrt_3 * w1_plus_w2_plus_w3_1);
    let x_axle_base_1_of_w1_w2_w3_2_1 = x_axle_base_1_of_place_1
        .mul_add(
            w_S_in_axle_base_2_of_w1_w2_w3_0,
            w_S_in_axle_base_2_of_w1_w2_w3_1 * x_axle_base_1_of_place_0,
        );
    let x_axle_base_1_of_place_2_1 = alpha_W_turn1_in_axle_base_1_of_s_1
        .mul_add(
            weight_5,
            minus_k_sqrt_3 * x_axle_base_1_of_w1_w2_w3_1 + x_axle_base_1_of_w1_w2_w3_2_1,
        );
    let alpha_W_turn1_in_axle_base_2_of_place_1 = w_axle_base_in_W_turn1_2_of_place_1
        .mul_add(sin_phi_0, sin_phi_1 * w_axle_base_in_W_turn1_2_of_place_0);
    let alpha_W_turn1_in_axle_base_2_of_place_2_1 = w_axle_base_in_W_turn1_1_of_place_1
        .mul_add(cos_phi_0, cos_phi_1 * w_axle_base_in_W_turn1_1_of_place_0);
    let alpha_W_turn1_in_axle_base_2_of_place_3_1 = alpha_W_turn1_in_axle_base_2_of_place_1
        + alpha_W_turn1_in_axle_base_2_of_place_2_1;
    let alpha_W_turn1_in_axle_base_2_of_s_1 = alpha_W_turn1_in_axle_base_2_of_place_3_1
        .mul_add(s_0, s_1 * alpha_W_turn1_in_axle_base_2_of_place_3_0);
    let x_axle_base_2_of_w1_w2_w3_1 = w_S_in_axle_base_1_of_w1_w2_w3_1
        .mul_add(
            w1_plus_w2_plus_w3_0,
            w1_plus_w2_plus_w3_1 * w_S_in_axle_base_1_of_w1_w2_w3_0,
        );
    let x_axle_base_2_of_w1_w2_w3_2_1 = x_axle_base_1_of_place_1
        .mul_add(
            w_S_in_axle_base_1_of_w1_w2_w3_0,
            w_S_in_axle_base_1_of_w1_w2_w3_1 * x_axle_base_1_of_place_0,
        );
    let x_axle_base_2_of_place_1 = alpha_W_turn1_in_axle_base_2_of_s_1
        .mul_add(
            minus_3_k,
            k_sqrt_3 * x_axle_base_2_of_w1_w2_w3_1 - x_axle_base_2_of_w1_w2_w3_2_1,
        );
    let x_axle_base_3_of_w1_w2_w3_1 = w_S_in_axle_base_2_of_w1_w2_w3_1
        .mul_add(
            w_S_in_axle_base_1_of_w1_w2_w3_0,
            w_S_in_axle_base_1_of_w1_w2_w3_1 * w_S_in_axle_base_2_of_w1_w2_w3_0,
        );
    let x_axle_base_3_of_w1_w2_w3_2_1 = w_S_in_axle_base_1_of_w1_w2_w3_1
        .mul_add(
            w_S_in_axle_base_2_of_w1_w2_w3_0,
            w_S_in_axle_base_2_of_w1_w2_w3_1 * w_S_in_axle_base_1_of_w1_w2_w3_0,
        );
    let w3_dot_of_place_1 = x_axle_base_2_of_place_1
        .mul_add(
            weight_9,
            x_axle_base_1_of_place_2_1
                .mul_add(
                    weight_8,
                    x_S_2_of_w1_w3_1
                        .mul_add(
                            weight_11,
                            x_S_1_of_w2_w3_1
                                .mul_add(
                                    weight_10,
                                    w1_w2_2_1.mul_add(minus_27_a, weight_7 * w1_w2_1),
                                ),
                        ),
                ),
        );
    let w2_dot_of_w3_dot_1 = w3_dot_of_place_1
        .mul_add(
            weight_12,
            x_axle_base_2_of_place_1
                .mul_add(
                    weight_14,
                    x_axle_base_1_of_place_2_1
                        .mul_add(
                            weight_13,
                            x_S_1_of_w2_w3_1
                                .mul_add(weight_15, S::int(3) * x_S_2_of_w1_w3_1),
                        ),
                ),
        );
    let w1_dot_of_motion_1 = w2_dot_of_w3_dot_1
        .mul_add(
            weight_19,
            w3_dot_of_place_1
                .mul_add(
                    weight_18,
                    x_axle_base_2_of_place_1
                        .mul_add(
                            weight_17,
                            x_axle_base_1_of_place_2_1
                                .mul_add(weight_16, S::int(3) * x_S_1_of_w2_w3_1),
                        ),
                ),
        );
    let s_dot_of_motion_1 = w1_dot_of_motion_1
        .mul_add(
            weight_21,
            w2_dot_of_w3_dot_1
                .mul_add(
                    weight_22,
                    w3_dot_of_place_1
                        .mul_add(
                            weight_23,
                            x_axle_base_3_of_w1_w2_w3_2_1
                                .mul_add(K, minus_k * x_axle_base_3_of_w1_w2_w3_1),
                        ),
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
                w2_1, w3_1, w3_1, w1_1, w1_1, w2_1, phi_1, phi_1, cos_phi_1, sin_phi_1, sin_phi_1,
                cos_phi_1, sin_phi_1, cos_phi_1, s_1, w1_plus_w2_plus_w3_1,
                w_S_in_axle_base_2_of_w1_w2_w3_1, sin_phi_1, cos_phi_1, s_1, w1_plus_w2_plus_w3_1,
                w_S_in_axle_base_1_of_w1_w2_w3_1, w_S_in_axle_base_1_of_w1_w2_w3_1,
                w_S_in_axle_base_2_of_w1_w2_w3_1, e1_1, e2_1, e3_1, e0_1, e3_1, e2_1, e3_1, e0_1,
                e1_1, e2_1, e1_1, e0_1,
            ]),
            padded([
                w3_1, w2_1, w1_1, w3_1, w2_1, w1_1, cos_phi_1, sin_phi_1,
                w_S_in_axle_base_1_of_w1_w2_w3_1, w_S_in_axle_base_2_of_w1_w2_w3_1,
                w_S_in_axle_base_1_of_w1_w2_w3_1, w_S_in_axle_base_2_of_w1_w2_w3_1,
                w_axle_base_in_W_turn1_1_of_place_1, w_axle_base_in_W_turn1_2_of_place_1,
                alpha_W_turn1_in_axle_base_1_of_place_3_1, w_S_in_axle_base_2_of_w1_w2_w3_1,
                x_axle_base_1_of_place_1, w_axle_base_in_W_turn1_2_of_place_1,
                w_axle_base_in_W_turn1_1_of_place_1, alpha_W_turn1_in_axle_base_2_of_place_3_1,
                w_S_in_axle_base_1_of_w1_w2_w3_1, x_axle_base_1_of_place_1,
                w_S_in_axle_base_2_of_w1_w2_w3_1, w_S_in_axle_base_1_of_w1_w2_w3_1, w1_1, w2_1,
                w3_1, w1_1, w2_1, w3_1, w1_1, w2_1, w3_1, w1_1, w2_1, w3_1,
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
    let mut w1_plus_w2_plus_w3_last = w1_plus_w2_plus_w3_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut w_axle_base_in_W_turn1_1_of_place_last = w_axle_base_in_W_turn1_1_of_place_1;
    let mut w_axle_base_in_W_turn1_2_of_place_last = w_axle_base_in_W_turn1_2_of_place_1;
    let mut alpha_W_turn1_in_axle_base_1_of_place_3_last = alpha_W_turn1_in_axle_base_1_of_place_3_1;
    let mut x_axle_base_1_of_place_last = x_axle_base_1_of_place_1;
    let mut alpha_W_turn1_in_axle_base_2_of_place_3_last = alpha_W_turn1_in_axle_base_2_of_place_3_1;
    let mut next = [S::int(0); 40];
    // Rates at order k - 1.
    let mut e0_rate = e0_dot_2_1;
    let mut e1_rate = e1_dot_2_1;
    let mut e2_rate = e2_dot_2_1;
    let mut e3_rate = e3_dot_2_1;
    let mut phi_rate = s_1;
    let mut w1_rate = weight_24 * w1_dot_of_motion_1;
    let mut w2_rate = weight_25 * w2_dot_of_w3_dot_1;
    let mut w3_rate = weight_26 * w3_dot_of_place_1;
    let mut s_rate = weight_27 * s_dot_of_motion_1;
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
                w2_1.mul_add(w3_last, w2_last.mul_add(w3_1, next[0])),
                w3_1.mul_add(w2_last, w3_last.mul_add(w2_1, next[1])),
                w3_1.mul_add(w1_last, w3_last.mul_add(w1_1, next[2])),
                w1_1.mul_add(w3_last, w1_last.mul_add(w3_1, next[3])),
                w1_1.mul_add(w2_last, w1_last.mul_add(w2_1, next[4])),
                w2_1.mul_add(w1_last, w2_last.mul_add(w1_1, next[5])),
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[6]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[7]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        cos_phi_last.mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[8]),
                    ),
                sin_phi_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        sin_phi_last.mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[9]),
                    ),
                sin_phi_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        sin_phi_last.mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[10]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        cos_phi_last.mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[11]),
                    ),
                sin_phi_1
                    .mul_add(
                        w_axle_base_in_W_turn1_1_of_place_last,
                        sin_phi_last
                            .mul_add(w_axle_base_in_W_turn1_1_of_place_1, next[12]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_axle_base_in_W_turn1_2_of_place_last,
                        cos_phi_last
                            .mul_add(w_axle_base_in_W_turn1_2_of_place_1, next[13]),
                    ),
                s_1
                    .mul_add(
                        alpha_W_turn1_in_axle_base_1_of_place_3_last,
                        s_last
                            .mul_add(alpha_W_turn1_in_axle_base_1_of_place_3_1, next[14]),
                    ),
                w1_plus_w2_plus_w3_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        w1_plus_w2_plus_w3_last
                            .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[15]),
                    ),
                w_S_in_axle_base_2_of_w1_w2_w3_1
                    .mul_add(
                        x_axle_base_1_of_place_last,
                        w_S_in_axle_base_2_of_w1_w2_w3_last
                            .mul_add(x_axle_base_1_of_place_1, next[16]),
                    ),
                sin_phi_1
                    .mul_add(
                        w_axle_base_in_W_turn1_2_of_place_last,
                        sin_phi_last
                            .mul_add(w_axle_base_in_W_turn1_2_of_place_1, next[17]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_axle_base_in_W_turn1_1_of_place_last,
                        cos_phi_last
                            .mul_add(w_axle_base_in_W_turn1_1_of_place_1, next[18]),
                    ),
                s_1
                    .mul_add(
                        alpha_W_turn1_in_axle_base_2_of_place_3_last,
                        s_last
                            .mul_add(alpha_W_turn1_in_axle_base_2_of_place_3_1, next[19]),
                    ),
                w1_plus_w2_plus_w3_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        w1_plus_w2_plus_w3_last
                            .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[20]),
                    ),
                w_S_in_axle_base_1_of_w1_w2_w3_1
                    .mul_add(
                        x_axle_base_1_of_place_last,
                        w_S_in_axle_base_1_of_w1_w2_w3_last
                            .mul_add(x_axle_base_1_of_place_1, next[21]),
                    ),
                w_S_in_axle_base_1_of_w1_w2_w3_1
                    .mul_add(
                        w_S_in_axle_base_2_of_w1_w2_w3_last,
                        w_S_in_axle_base_1_of_w1_w2_w3_last
                            .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_1, next[22]),
                    ),
                w_S_in_axle_base_2_of_w1_w2_w3_1
                    .mul_add(
                        w_S_in_axle_base_1_of_w1_w2_w3_last,
                        w_S_in_axle_base_2_of_w1_w2_w3_last
                            .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_1, next[23]),
                    ),
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
        // w2_w3 = w2*w3
        let w2_w3 = w3.mul_add(w2_0, w2.mul_add(w3_0, sums[0]));
        // w2_w3_2 = w3*w2
        let w2_w3_2 = w2.mul_add(w3_0, w3.mul_add(w2_0, sums[1]));
        // x_S_1_of_w2_w3 = t_sqrt_3 + weight*w2_w3 + minus_3_b*w2_w3_2
        let x_S_1_of_w2_w3 = w2_w3_2.mul_add(minus_3_b, weight * w2_w3);
        // w1_w3 = w3*w1
        let w1_w3 = w1.mul_add(w3_0, w3.mul_add(w1_0, sums[2]));
        // w1_w3_2 = w1*w3
        let w1_w3_2 = w3.mul_add(w1_0, w1.mul_add(w3_0, sums[3]));
        // x_S_2_of_w1_w3 = t_sqrt_3 + weight_2*w1_w3 + minus_3_c*w1_w3_2
        let x_S_2_of_w1_w3 = w1_w3_2.mul_add(minus_3_c, weight_2 * w1_w3);
        // w1_w2 = w1*w2
        let w1_w2 = w2.mul_add(w1_0, w1.mul_add(w2_0, sums[4]));
        // w1_w2_2 = w2*w1
        let w1_w2_2 = w1.mul_add(w2_0, w2.mul_add(w1_0, sums[5]));
        // w_S_in_axle_base_1_of_w1_w2_w3 = weight_3*w1 + weight_4*w2 + sqrt_3*w3
        let w_S_in_axle_base_1_of_w1_w2_w3 = w3
            .mul_add(sqrt_3, w2.mul_add(weight_4, weight_3 * w1));
        // w_S_in_axle_base_2_of_w1_w2_w3 = sqrt_3*w3 + weight_4*w1 + weight_3*w2
        let w_S_in_axle_base_2_of_w1_w2_w3 = w2
            .mul_add(weight_3, w1.mul_add(weight_4, sqrt_3 * w3));
        // w1_plus_w2_plus_w3 = w1 + w2 + w3
        let w1_plus_w2_plus_w3 = w1 + w2 + w3;
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[6] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[7] * over_k);
        // w_axle_base_in_W_turn1_1_of_w1_w2_w3 = cos_phi*w_S_in_axle_base_1_of_w1_w2_w3
        let w_axle_base_in_W_turn1_1_of_w1_w2_w3 = cos_phi
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3.mul_add(cos_phi_0, sums[8]),
            );
        // w_axle_base_in_W_turn1_1_of_w1_w2_w3_2 = sin_phi*w_S_in_axle_base_2_of_w1_w2_w3
        let w_axle_base_in_W_turn1_1_of_w1_w2_w3_2 = sin_phi
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3.mul_add(sin_phi_0, sums[9]),
            );
        // w_axle_base_in_W_turn1_1_of_place = w_axle_base_in_W_turn1_1_of_w1_w2_w3 +
        //   w_axle_base_in_W_turn1_1_of_w1_w2_w3_2
        let w_axle_base_in_W_turn1_1_of_place = w_axle_base_in_W_turn1_1_of_w1_w2_w3
            + w_axle_base_in_W_turn1_1_of_w1_w2_w3_2;
        // w_axle_base_in_W_turn1_2_of_w1_w2_w3 = sin_phi*w_S_in_axle_base_1_of_w1_w2_w3
        let w_axle_base_in_W_turn1_2_of_w1_w2_w3 = sin_phi
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3.mul_add(sin_phi_0, sums[10]),
            );
        // w_axle_base_in_W_turn1_2_of_w1_w2_w3_2 = cos_phi*w_S_in_axle_base_2_of_w1_w2_w3
        let w_axle_base_in_W_turn1_2_of_w1_w2_w3_2 = cos_phi
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3.mul_add(cos_phi_0, sums[11]),
            );
        // w_axle_base_in_W_turn1_2_of_place = w_axle_base_in_W_turn1_2_of_w1_w2_w3 -
        //   w_axle_base_in_W_turn1_2_of_w1_w2_w3_2
        let w_axle_base_in_W_turn1_2_of_place = w_axle_base_in_W_turn1_2_of_w1_w2_w3
            - w_axle_base_in_W_turn1_2_of_w1_w2_w3_2;
        // w_W_turn1_3_of_s = 3*s + sqrt_3*w1_plus_w2_plus_w3
        let w_W_turn1_3_of_s = w1_plus_w2_plus_w3.mul_add(sqrt_3, S::int(3) * s);
        // alpha_W_turn1_in_axle_base_1_of_place = sin_phi*w_axle_base_in_W_turn1_1_of_place
        let alpha_W_turn1_in_axle_base_1_of_place = w_axle_base_in_W_turn1_1_of_place
            .mul_add(
                sin_phi_0,
                sin_phi.mul_add(w_axle_base_in_W_turn1_1_of_place_0, sums[12]),
            );
        // alpha_W_turn1_in_axle_base_1_of_place_2 = cos_phi*w_axle_base_in_W_turn1_2_of_place
        let alpha_W_turn1_in_axle_base_1_of_place_2 = w_axle_base_in_W_turn1_2_of_place
            .mul_add(
                cos_phi_0,
                cos_phi.mul_add(w_axle_base_in_W_turn1_2_of_place_0, sums[13]),
            );
        // alpha_W_turn1_in_axle_base_1_of_place_3 = alpha_W_turn1_in_axle_base_1_of_place -
        //   alpha_W_turn1_in_axle_base_1_of_place_2
        let alpha_W_turn1_in_axle_base_1_of_place_3 = alpha_W_turn1_in_axle_base_1_of_place
            - alpha_W_turn1_in_axle_base_1_of_place_2;
        // alpha_W_turn1_in_axle_base_1_of_s = s*alpha_W_turn1_in_axle_base_1_of_place_3
        let alpha_W_turn1_in_axle_base_1_of_s = alpha_W_turn1_in_axle_base_1_of_place_3
            .mul_add(
                s_0,
                s.mul_add(alpha_W_turn1_in_axle_base_1_of_place_3_0, sums[14]),
            );
        // x_axle_base_1_of_w1_w2_w3 = w1_plus_w2_plus_w3*w_S_in_axle_base_2_of_w1_w2_w3
        let x_axle_base_1_of_w1_w2_w3 = w_S_in_axle_base_2_of_w1_w2_w3
            .mul_add(
                w1_plus_w2_plus_w3_0,
                w1_plus_w2_plus_w3.mul_add(w_S_in_axle_base_2_of_w1_w2_w3_0, sums[15]),
            );
        // x_axle_base_1_of_place = j_minus_k*w_W_turn1_3_of_s + k_sqrt_3*w1_plus_w2_plus_w3
        let x_axle_base_1_of_place = w_W_turn1_3_of_s
            .mul_add(j_minus_k, k_sqrt_3 * w1_plus_w2_plus_w3);
        // x_axle_base_1_of_w1_w2_w3_2 = w_S_in_axle_base_2_of_w1_w2_w3*x_axle_base_1_of_place
        let x_axle_base_1_of_w1_w2_w3_2 = x_axle_base_1_of_place
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3
                    .mul_add(x_axle_base_1_of_place_0, sums[16]),
            );
        // x_axle_base_1_of_place_2 = minus_k_sqrt_3*x_axle_base_1_of_w1_w2_w3 +
        //   x_axle_base_1_of_w1_w2_w3_2 + weight_5*alpha_W_turn1_in_axle_base_1_of_s
        let x_axle_base_1_of_place_2 = alpha_W_turn1_in_axle_base_1_of_s
            .mul_add(
                weight_5,
                minus_k_sqrt_3 * x_axle_base_1_of_w1_w2_w3 + x_axle_base_1_of_w1_w2_w3_2,
            );
        // alpha_W_turn1_in_axle_base_2_of_place = sin_phi*w_axle_base_in_W_turn1_2_of_place
        let alpha_W_turn1_in_axle_base_2_of_place = w_axle_base_in_W_turn1_2_of_place
            .mul_add(
                sin_phi_0,
                sin_phi.mul_add(w_axle_base_in_W_turn1_2_of_place_0, sums[17]),
            );
        // alpha_W_turn1_in_axle_base_2_of_place_2 = cos_phi*w_axle_base_in_W_turn1_1_of_place
        let alpha_W_turn1_in_axle_base_2_of_place_2 = w_axle_base_in_W_turn1_1_of_place
            .mul_add(
                cos_phi_0,
                cos_phi.mul_add(w_axle_base_in_W_turn1_1_of_place_0, sums[18]),
            );
        // alpha_W_turn1_in_axle_base_2_of_place_3 = alpha_W_turn1_in_axle_base_2_of_place +
        //   alpha_W_turn1_in_axle_base_2_of_place_2
        let alpha_W_turn1_in_axle_base_2_of_place_3 = alpha_W_turn1_in_axle_base_2_of_place
            + alpha_W_turn1_in_axle_base_2_of_place_2;
        // alpha_W_turn1_in_axle_base_2_of_s = s*alpha_W_turn1_in_axle_base_2_of_place_3
        let alpha_W_turn1_in_axle_base_2_of_s = alpha_W_turn1_in_axle_base_2_of_place_3
            .mul_add(
                s_0,
                s.mul_add(alpha_W_turn1_in_axle_base_2_of_place_3_0, sums[19]),
            );
        // x_axle_base_2_of_w1_w2_w3 = w1_plus_w2_plus_w3*w_S_in_axle_base_1_of_w1_w2_w3
        let x_axle_base_2_of_w1_w2_w3 = w_S_in_axle_base_1_of_w1_w2_w3
            .mul_add(
                w1_plus_w2_plus_w3_0,
                w1_plus_w2_plus_w3.mul_add(w_S_in_axle_base_1_of_w1_w2_w3_0, sums[20]),
            );
        // x_axle_base_2_of_w1_w2_w3_2 = w_S_in_axle_base_1_of_w1_w2_w3*x_axle_base_1_of_place
        let x_axle_base_2_of_w1_w2_w3_2 = x_axle_base_1_of_place
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3
                    .mul_add(x_axle_base_1_of_place_0, sums[21]),
            );
        // x_axle_base_2_of_place = k_sqrt_3*x_axle_base_2_of_w1_w2_w3 - x_axle_base_2_of_w1_w2_w3_2 +
        //   minus_3_k*alpha_W_turn1_in_axle_base_2_of_s
        let x_axle_base_2_of_place = alpha_W_turn1_in_axle_base_2_of_s
            .mul_add(
                minus_3_k,
                k_sqrt_3 * x_axle_base_2_of_w1_w2_w3 - x_axle_base_2_of_w1_w2_w3_2,
            );
        // x_axle_base_3_of_w1_w2_w3 = w_S_in_axle_base_1_of_w1_w2_w3*w_S_in_axle_base_2_of_w1_w2_w3
        let x_axle_base_3_of_w1_w2_w3 = w_S_in_axle_base_2_of_w1_w2_w3
            .mul_add(
                w_S_in_axle_base_1_of_w1_w2_w3_0,
                w_S_in_axle_base_1_of_w1_w2_w3
                    .mul_add(w_S_in_axle_base_2_of_w1_w2_w3_0, sums[22]),
            );
        // x_axle_base_3_of_w1_w2_w3_2 = w_S_in_axle_base_2_of_w1_w2_w3*w_S_in_axle_base_1_of_w1_w2_w3
        let x_axle_base_3_of_w1_w2_w3_2 = w_S_in_axle_base_1_of_w1_w2_w3
            .mul_add(
                w_S_in_axle_base_2_of_w1_w2_w3_0,
                w_S_in_axle_base_2_of_w1_w2_w3
                    .mul_add(w_S_in_axle_base_1_of_w1_w2_w3_0, sums[23]),
            );
        // w3_dot_of_place = weight_6 + weight_7*w1_w2 + minus_27_a*w1_w2_2 +
        //   weight_8*x_axle_base_1_of_place_2 + weight_9*x_axle_base_2_of_place + weight_10*x_S_1_of_w2_w3 +
        //   weight_11*x_S_2_of_w1_w3
        let w3_dot_of_place = x_axle_base_2_of_place
            .mul_add(
                weight_9,
                x_axle_base_1_of_place_2
                    .mul_add(
                        weight_8,
                        x_S_2_of_w1_w3
                            .mul_add(
                                weight_11,
                                x_S_1_of_w2_w3
                                    .mul_add(
                                        weight_10,
                                        w1_w2_2.mul_add(minus_27_a, weight_7 * w1_w2),
                                    ),
                            ),
                    ),
            );
        // w2_dot_of_w3_dot = 3*x_S_2_of_w1_w3 + weight_12*w3_dot_of_place +
        //   weight_13*x_axle_base_1_of_place_2 + weight_14*x_axle_base_2_of_place + weight_15*x_S_1_of_w2_w3
        let w2_dot_of_w3_dot = w3_dot_of_place
            .mul_add(
                weight_12,
                x_axle_base_2_of_place
                    .mul_add(
                        weight_14,
                        x_axle_base_1_of_place_2
                            .mul_add(
                                weight_13,
                                x_S_1_of_w2_w3
                                    .mul_add(weight_15, S::int(3) * x_S_2_of_w1_w3),
                            ),
                    ),
            );
        // w1_dot_of_motion = 3*x_S_1_of_w2_w3 + weight_16*x_axle_base_1_of_place_2 +
        //   weight_17*x_axle_base_2_of_place + weight_18*w3_dot_of_place + weight_19*w2_dot_of_w3_dot
        let w1_dot_of_motion = w2_dot_of_w3_dot
            .mul_add(
                weight_19,
                w3_dot_of_place
                    .mul_add(
                        weight_18,
                        x_axle_base_2_of_place
                            .mul_add(
                                weight_17,
                                x_axle_base_1_of_place_2
                                    .mul_add(weight_16, S::int(3) * x_S_1_of_w2_w3),
                            ),
                    ),
            );
        // s_dot_of_motion = weight_20 + minus_k*x_axle_base_3_of_w1_w2_w3 + K*x_axle_base_3_of_w1_w2_w3_2
        //   + weight_21*w1_dot_of_motion + weight_22*w2_dot_of_w3_dot + weight_23*w3_dot_of_place
        let s_dot_of_motion = w1_dot_of_motion
            .mul_add(
                weight_21,
                w2_dot_of_w3_dot
                    .mul_add(
                        weight_22,
                        w3_dot_of_place
                            .mul_add(
                                weight_23,
                                x_axle_base_3_of_w1_w2_w3_2
                                    .mul_add(K, minus_k * x_axle_base_3_of_w1_w2_w3),
                            ),
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
        w1_rate = weight_24 * w1_dot_of_motion;
        w2_rate = weight_25 * w2_dot_of_w3_dot;
        w3_rate = weight_26 * w3_dot_of_place;
        s_rate = weight_27 * s_dot_of_motion;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                w2, w3, w3, w1, w1, w2,
                count * phi,
                count * phi,
                cos_phi, sin_phi, sin_phi, cos_phi, sin_phi, cos_phi, s, w1_plus_w2_plus_w3,
                w_S_in_axle_base_2_of_w1_w2_w3, sin_phi, cos_phi, s, w1_plus_w2_plus_w3,
                w_S_in_axle_base_1_of_w1_w2_w3, w_S_in_axle_base_1_of_w1_w2_w3,
                w_S_in_axle_base_2_of_w1_w2_w3, e1, e2, e3, e0, e3, e2, e3, e0, e1, e2, e1, e0,
            ]),
            padded([
                w3, w2, w1, w3, w2, w1, cos_phi, sin_phi, w_S_in_axle_base_1_of_w1_w2_w3,
                w_S_in_axle_base_2_of_w1_w2_w3, w_S_in_axle_base_1_of_w1_w2_w3,
                w_S_in_axle_base_2_of_w1_w2_w3, w_axle_base_in_W_turn1_1_of_place,
                w_axle_base_in_W_turn1_2_of_place, alpha_W_turn1_in_axle_base_1_of_place_3,
                w_S_in_axle_base_2_of_w1_w2_w3, x_axle_base_1_of_place,
                w_axle_base_in_W_turn1_2_of_place, w_axle_base_in_W_turn1_1_of_place,
                alpha_W_turn1_in_axle_base_2_of_place_3, w_S_in_axle_base_1_of_w1_w2_w3,
                x_axle_base_1_of_place, w_S_in_axle_base_2_of_w1_w2_w3,
                w_S_in_axle_base_1_of_w1_w2_w3, w1, w2, w3, w1, w2, w3, w1, w2, w3, w1, w2, w3,
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
        w1_plus_w2_plus_w3_last = w1_plus_w2_plus_w3;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        w_axle_base_in_W_turn1_1_of_place_last = w_axle_base_in_W_turn1_1_of_place;
        w_axle_base_in_W_turn1_2_of_place_last = w_axle_base_in_W_turn1_2_of_place;
        alpha_W_turn1_in_axle_base_1_of_place_3_last = alpha_W_turn1_in_axle_base_1_of_place_3;
        x_axle_base_1_of_place_last = x_axle_base_1_of_place;
        alpha_W_turn1_in_axle_base_2_of_place_3_last = alpha_W_turn1_in_axle_base_2_of_place_3;
    }
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 8,
            coordinates: 5,
            variables: 4,
            speeds: 4,
            reactions: 2,
        }
    }
    fn symmetric(&self) -> bool {
        false
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
