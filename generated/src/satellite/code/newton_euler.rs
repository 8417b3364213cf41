//! Satellite with a reaction wheel: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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
