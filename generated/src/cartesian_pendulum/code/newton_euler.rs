//! Pendulum in Cartesian coordinates: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cartesian_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    accelerations, constraint_slopes, constraints, coordinate_rates, derivative,
    divisors, kinetic_energy, potential_energy,
};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2.
///
/// 13 operations, 1 other function.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 1],
) -> [[S; 2]; 2] {
    let Parameters { m, l, .. } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let over_x_sq_plus_y_sq = S::int(1) / x_sq_plus_y_sq;
    let y_over_x_sq_plus_y_sq = y * over_x_sq_plus_y_sq;
    // ratio_x_v = l*y/(x^2 + y^2)
    let ratio_x_v = l * y_over_x_sq_plus_y_sq;
    let x_over_x_sq_plus_y_sq = x * over_x_sq_plus_y_sq;
    // ratio_y_v = l*x/(x^2 + y^2)
    let ratio_y_v = l * x_over_x_sq_plus_y_sq;
    let m12_of_x_y = x_sq_plus_y_sq.sqrt();
    // Entries that are not zero.
    // M11 = -m*ratio_x_v
    let m11 = -m * ratio_x_v;
    // M12 = x*sqrt(x^2 + y^2)/(x^2 + y^2)
    let m12 = x_over_x_sq_plus_y_sq * m12_of_x_y;
    // M21 = m*ratio_y_v
    let m21 = m * ratio_y_v;
    // M22 = y*sqrt(x^2 + y^2)/(x^2 + y^2)
    let m22 = y_over_x_sq_plus_y_sq * m12_of_x_y;
    [[m11, m12], [m21, m22]]
}

/// Right-hand side of the linear system; unknowns (v', bob_force_to_o).
///
/// 25 operations.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [x, y] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // 1/(x^2 + y^2)
    let over_x_sq_plus_y_sq = S::int(1) / y.mul_add(y, x * x);
    let l_over_x_sq_plus_y_sq = l * over_x_sq_plus_y_sq;
    // ratio_x_v = l*y/(x^2 + y^2)
    let ratio_x_v = y * l_over_x_sq_plus_y_sq;
    // ratio_y_v = l*x/(x^2 + y^2)
    let ratio_y_v = x * l_over_x_sq_plus_y_sq;
    let v_ratio_y_v = v * ratio_y_v;
    let v_ratio_x_v = v * ratio_x_v;
    // 2*over_x_sq_plus_y_sq*(x*v_ratio_x_v - y*v_ratio_y_v)
    let ratio_x_v_2_of_v = S::int(2) * over_x_sq_plus_y_sq
        * (-y).mul_add(v_ratio_y_v, x * v_ratio_x_v);
    // ratio_x_v_2 = l*v*ratio_y_v/(x^2 + y^2) + 2*l*y*(x*v*ratio_x_v - y*v*ratio_y_v)/(x^2 + y^2)^2
    let ratio_x_v_2 = ratio_x_v
        .mul_add(ratio_x_v_2_of_v, l_over_x_sq_plus_y_sq * v_ratio_y_v);
    // ratio_y_v_2 = l*v*ratio_x_v/(x^2 + y^2) + 2*l*x*(y*v*ratio_y_v - x*v*ratio_x_v)/(x^2 + y^2)^2
    let ratio_y_v_2 = (-ratio_y_v)
        .mul_add(ratio_x_v_2_of_v, l_over_x_sq_plus_y_sq * v_ratio_x_v);
    // Values.
    // f1 = m*v*ratio_x_v_2
    let f1 = m * v * ratio_x_v_2;
    // f2 = m*(v*ratio_y_v_2 - g)
    let f2 = m * v.mul_add(ratio_y_v_2, -g);
    [f1, f2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 19 convolutions and 26 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 3]],
    history: &mut [Factors<S, 24>],
) {
    let Parameters { l, g, .. } = *p;
    let [x_0, y_0, v_0] = series[0];
    // Constant in time.
    // minus_l = -l
    let minus_l = -l;
    // l_2 = l^2
    let l_2 = l * l;
    // weight = 2*l
    let weight = S::int(2) * l;
    // minus_2_l = -2*l
    let minus_2_l = -S::int(2) * l;
    // Order 0.
    let x_sq_0 = x_0 * x_0;
    let y_sq_0 = y_0 * y_0;
    let x_sq_plus_y_sq_0 = x_sq_0 + y_sq_0;
    let over_x_sq_plus_y_sq = S::int(1) / x_sq_plus_y_sq_0;
    let y_over_x_sq_plus_y_sq_0 = y_0 * over_x_sq_plus_y_sq;
    let x_over_x_sq_plus_y_sq_0 = x_0 * over_x_sq_plus_y_sq;
    let y_v_over_x_sq_plus_y_sq_0 = v_0 * y_over_x_sq_plus_y_sq_0;
    let ratio_x_v_2_of_v_0 = x_0 * y_v_over_x_sq_plus_y_sq_0;
    let x_v_over_x_sq_plus_y_sq_0 = v_0 * x_over_x_sq_plus_y_sq_0;
    let ratio_x_v_2_of_v_2_0 = y_0 * x_v_over_x_sq_plus_y_sq_0;
    let ratio_x_v_2_of_v_3_0 = x_v_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq;
    let ratio_x_v_2_of_v_4_0 = ratio_x_v_2_of_v_2_0
        .mul_add(minus_l, l * ratio_x_v_2_of_v_0);
    let ratio_x_v_2_of_v_5_0 = ratio_x_v_2_of_v_4_0 * over_x_sq_plus_y_sq;
    let ratio_x_v_2_of_v_6_0 = y_over_x_sq_plus_y_sq_0 * ratio_x_v_2_of_v_5_0;
    let ratio_x_v_2_of_v_7_0 = ratio_x_v_2_of_v_6_0
        .mul_add(weight, l_2 * ratio_x_v_2_of_v_3_0);
    let ratio_y_v_2_of_v_0 = y_v_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq;
    let ratio_y_v_2_of_v_2_0 = x_over_x_sq_plus_y_sq_0 * ratio_x_v_2_of_v_5_0;
    let ratio_y_v_2_of_v_3_0 = ratio_y_v_2_of_v_2_0
        .mul_add(minus_2_l, l_2 * ratio_y_v_2_of_v_0);
    let v_dot_2_of_v_0 = v_0 * ratio_y_v_2_of_v_3_0;
    let g_minus_v_ratio_y_v_2_0 = g - v_dot_2_of_v_0;
    let v_dot_2_of_x_y_0 = y_over_x_sq_plus_y_sq_0 * y_over_x_sq_plus_y_sq_0;
    let v_dot_2_of_x_y_2_0 = x_over_x_sq_plus_y_sq_0 * x_over_x_sq_plus_y_sq_0;
    let v_dot_2_of_place_0 = v_dot_2_of_x_y_2_0.mul_add(l_2, l_2 * v_dot_2_of_x_y_0);
    let over_v_dot_2_of_place = S::int(1) / v_dot_2_of_place_0;
    let v_dot_2_of_v_2_0 = ratio_x_v_2_of_v_7_0 * y_v_over_x_sq_plus_y_sq_0;
    let v_dot_2_of_v_3_0 = x_over_x_sq_plus_y_sq_0 * g_minus_v_ratio_y_v_2_0;
    let v_dot_2_of_v_4_0 = v_dot_2_of_v_3_0.mul_add(l, l * v_dot_2_of_v_2_0);
    let v_dot_2_of_v_5_0 = v_dot_2_of_v_4_0 * over_v_dot_2_of_place;
    // Order 1: the rates, and what follows from them.
    let x_1 = minus_l * y_v_over_x_sq_plus_y_sq_0;
    let y_1 = l * x_v_over_x_sq_plus_y_sq_0;
    let v_1 = -v_dot_2_of_v_5_0;
    if series.len() > 1 {
        series[1] = [x_1, y_1, v_1];
    }
    let x_sq_1 = x_1 * (x_0 + x_0);
    let y_sq_1 = y_1 * (y_0 + y_0);
    let x_sq_plus_y_sq_1 = x_sq_1 + y_sq_1;
    let y_over_x_sq_plus_y_sq_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(y_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
            y_1 * over_x_sq_plus_y_sq,
        );
    let x_over_x_sq_plus_y_sq_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(x_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
            x_1 * over_x_sq_plus_y_sq,
        );
    let y_v_over_x_sq_plus_y_sq_1 = y_over_x_sq_plus_y_sq_1
        .mul_add(v_0, v_1 * y_over_x_sq_plus_y_sq_0);
    let ratio_x_v_2_of_v_1 = y_v_over_x_sq_plus_y_sq_1
        .mul_add(x_0, x_1 * y_v_over_x_sq_plus_y_sq_0);
    let x_v_over_x_sq_plus_y_sq_1 = x_over_x_sq_plus_y_sq_1
        .mul_add(v_0, v_1 * x_over_x_sq_plus_y_sq_0);
    let ratio_x_v_2_of_v_2_1 = x_v_over_x_sq_plus_y_sq_1
        .mul_add(y_0, y_1 * x_v_over_x_sq_plus_y_sq_0);
    let ratio_x_v_2_of_v_3_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(ratio_x_v_2_of_v_3_0 * over_x_sq_plus_y_sq),
            x_v_over_x_sq_plus_y_sq_1 * over_x_sq_plus_y_sq,
        );
    let ratio_x_v_2_of_v_4_1 = ratio_x_v_2_of_v_2_1
        .mul_add(minus_l, l * ratio_x_v_2_of_v_1);
    let ratio_x_v_2_of_v_5_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(ratio_x_v_2_of_v_5_0 * over_x_sq_plus_y_sq),
            ratio_x_v_2_of_v_4_1 * over_x_sq_plus_y_sq,
        );
    let ratio_x_v_2_of_v_6_1 = ratio_x_v_2_of_v_5_1
        .mul_add(
            y_over_x_sq_plus_y_sq_0,
            y_over_x_sq_plus_y_sq_1 * ratio_x_v_2_of_v_5_0,
        );
    let ratio_x_v_2_of_v_7_1 = ratio_x_v_2_of_v_6_1
        .mul_add(weight, l_2 * ratio_x_v_2_of_v_3_1);
    let ratio_y_v_2_of_v_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(ratio_y_v_2_of_v_0 * over_x_sq_plus_y_sq),
            y_v_over_x_sq_plus_y_sq_1 * over_x_sq_plus_y_sq,
        );
    let ratio_y_v_2_of_v_2_1 = ratio_x_v_2_of_v_5_1
        .mul_add(
            x_over_x_sq_plus_y_sq_0,
            x_over_x_sq_plus_y_sq_1 * ratio_x_v_2_of_v_5_0,
        );
    let ratio_y_v_2_of_v_3_1 = ratio_y_v_2_of_v_2_1
        .mul_add(minus_2_l, l_2 * ratio_y_v_2_of_v_1);
    let v_dot_2_of_v_1 = ratio_y_v_2_of_v_3_1.mul_add(v_0, v_1 * ratio_y_v_2_of_v_3_0);
    let g_minus_v_ratio_y_v_2_1 = -v_dot_2_of_v_1;
    let v_dot_2_of_x_y_1 = y_over_x_sq_plus_y_sq_1
        * (y_over_x_sq_plus_y_sq_0 + y_over_x_sq_plus_y_sq_0);
    let v_dot_2_of_x_y_2_1 = x_over_x_sq_plus_y_sq_1
        * (x_over_x_sq_plus_y_sq_0 + x_over_x_sq_plus_y_sq_0);
    let v_dot_2_of_place_1 = v_dot_2_of_x_y_2_1.mul_add(l_2, l_2 * v_dot_2_of_x_y_1);
    let v_dot_2_of_v_2_1 = ratio_x_v_2_of_v_7_1
        .mul_add(
            y_v_over_x_sq_plus_y_sq_0,
            y_v_over_x_sq_plus_y_sq_1 * ratio_x_v_2_of_v_7_0,
        );
    let v_dot_2_of_v_3_1 = g_minus_v_ratio_y_v_2_1
        .mul_add(
            x_over_x_sq_plus_y_sq_0,
            x_over_x_sq_plus_y_sq_1 * g_minus_v_ratio_y_v_2_0,
        );
    let v_dot_2_of_v_4_1 = v_dot_2_of_v_3_1.mul_add(l, l * v_dot_2_of_v_2_1);
    let v_dot_2_of_v_5_1 = v_dot_2_of_place_1
        .mul_add(
            -(v_dot_2_of_v_5_0 * over_v_dot_2_of_place),
            v_dot_2_of_v_4_1 * over_v_dot_2_of_place,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                x_1, y_1, x_sq_plus_y_sq_1, x_sq_plus_y_sq_1, v_1, x_1, v_1, y_1, x_sq_plus_y_sq_1,
                x_sq_plus_y_sq_1, y_over_x_sq_plus_y_sq_1, x_sq_plus_y_sq_1,
                x_over_x_sq_plus_y_sq_1, v_1, y_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1,
                ratio_x_v_2_of_v_7_1, x_over_x_sq_plus_y_sq_1, v_dot_2_of_place_1,
            ]),
            padded([
                x_1, y_1, y_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1, y_over_x_sq_plus_y_sq_1,
                y_v_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1, x_v_over_x_sq_plus_y_sq_1,
                ratio_x_v_2_of_v_3_1, ratio_x_v_2_of_v_5_1, ratio_x_v_2_of_v_5_1,
                ratio_y_v_2_of_v_1, ratio_x_v_2_of_v_5_1, ratio_y_v_2_of_v_3_1,
                y_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1, y_v_over_x_sq_plus_y_sq_1,
                g_minus_v_ratio_y_v_2_1, v_dot_2_of_v_5_1,
            ]),
        ];
    }
    let mut x_last = x_1;
    let mut y_last = y_1;
    let mut v_last = v_1;
    let mut x_sq_plus_y_sq_last = x_sq_plus_y_sq_1;
    let mut y_over_x_sq_plus_y_sq_last = y_over_x_sq_plus_y_sq_1;
    let mut x_over_x_sq_plus_y_sq_last = x_over_x_sq_plus_y_sq_1;
    let mut y_v_over_x_sq_plus_y_sq_last = y_v_over_x_sq_plus_y_sq_1;
    let mut x_v_over_x_sq_plus_y_sq_last = x_v_over_x_sq_plus_y_sq_1;
    let mut ratio_x_v_2_of_v_3_last = ratio_x_v_2_of_v_3_1;
    let mut ratio_x_v_2_of_v_5_last = ratio_x_v_2_of_v_5_1;
    let mut ratio_x_v_2_of_v_7_last = ratio_x_v_2_of_v_7_1;
    let mut ratio_y_v_2_of_v_last = ratio_y_v_2_of_v_1;
    let mut ratio_y_v_2_of_v_3_last = ratio_y_v_2_of_v_3_1;
    let mut g_minus_v_ratio_y_v_2_last = g_minus_v_ratio_y_v_2_1;
    let mut v_dot_2_of_place_last = v_dot_2_of_place_1;
    let mut v_dot_2_of_v_5_last = v_dot_2_of_v_5_1;
    let mut next = [S::int(0); 24];
    // Rates at order k - 1.
    let mut x_rate = minus_l * y_v_over_x_sq_plus_y_sq_1;
    let mut y_rate = l * x_v_over_x_sq_plus_y_sq_1;
    let mut v_rate = -v_dot_2_of_v_5_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let v = v_rate * over_k;
        series[order] = [x, y, v];
        if order + 1 == series.len() {
            break;
        }
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            padded([
                (x_1 + x_1).mul_add(x_last, next[0]),
                (y_1 + y_1).mul_add(y_last, next[1]),
                x_sq_plus_y_sq_1
                    .mul_add(
                        y_over_x_sq_plus_y_sq_last,
                        x_sq_plus_y_sq_last.mul_add(y_over_x_sq_plus_y_sq_1, next[2]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        x_over_x_sq_plus_y_sq_last,
                        x_sq_plus_y_sq_last.mul_add(x_over_x_sq_plus_y_sq_1, next[3]),
                    ),
                v_1
                    .mul_add(
                        y_over_x_sq_plus_y_sq_last,
                        v_last.mul_add(y_over_x_sq_plus_y_sq_1, next[4]),
                    ),
                x_1
                    .mul_add(
                        y_v_over_x_sq_plus_y_sq_last,
                        x_last.mul_add(y_v_over_x_sq_plus_y_sq_1, next[5]),
                    ),
                v_1
                    .mul_add(
                        x_over_x_sq_plus_y_sq_last,
                        v_last.mul_add(x_over_x_sq_plus_y_sq_1, next[6]),
                    ),
                y_1
                    .mul_add(
                        x_v_over_x_sq_plus_y_sq_last,
                        y_last.mul_add(x_v_over_x_sq_plus_y_sq_1, next[7]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_v_3_last,
                        x_sq_plus_y_sq_last.mul_add(ratio_x_v_2_of_v_3_1, next[8]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_v_5_last,
                        x_sq_plus_y_sq_last.mul_add(ratio_x_v_2_of_v_5_1, next[9]),
                    ),
                y_over_x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_v_5_last,
                        y_over_x_sq_plus_y_sq_last
                            .mul_add(ratio_x_v_2_of_v_5_1, next[10]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_y_v_2_of_v_last,
                        x_sq_plus_y_sq_last.mul_add(ratio_y_v_2_of_v_1, next[11]),
                    ),
                x_over_x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_v_5_last,
                        x_over_x_sq_plus_y_sq_last
                            .mul_add(ratio_x_v_2_of_v_5_1, next[12]),
                    ),
                v_1
                    .mul_add(
                        ratio_y_v_2_of_v_3_last,
                        v_last.mul_add(ratio_y_v_2_of_v_3_1, next[13]),
                    ),
                (y_over_x_sq_plus_y_sq_1 + y_over_x_sq_plus_y_sq_1)
                    .mul_add(y_over_x_sq_plus_y_sq_last, next[14]),
                (x_over_x_sq_plus_y_sq_1 + x_over_x_sq_plus_y_sq_1)
                    .mul_add(x_over_x_sq_plus_y_sq_last, next[15]),
                ratio_x_v_2_of_v_7_1
                    .mul_add(
                        y_v_over_x_sq_plus_y_sq_last,
                        ratio_x_v_2_of_v_7_last
                            .mul_add(y_v_over_x_sq_plus_y_sq_1, next[16]),
                    ),
                x_over_x_sq_plus_y_sq_1
                    .mul_add(
                        g_minus_v_ratio_y_v_2_last,
                        x_over_x_sq_plus_y_sq_last
                            .mul_add(g_minus_v_ratio_y_v_2_1, next[17]),
                    ),
                v_dot_2_of_place_1
                    .mul_add(
                        v_dot_2_of_v_5_last,
                        v_dot_2_of_place_last.mul_add(v_dot_2_of_v_5_1, next[18]),
                    ),
            ])
        };
        // x_sq = x*x
        let x_sq = x.mul_add(x_0 + x_0, sums[0]);
        // y_sq = y*y
        let y_sq = y.mul_add(y_0 + y_0, sums[1]);
        // x_sq_plus_y_sq = x_sq + y_sq
        let x_sq_plus_y_sq = x_sq + y_sq;
        // y_over_x_sq_plus_y_sq = y/x_sq_plus_y_sq
        let y_over_x_sq_plus_y_sq = x_sq_plus_y_sq
            .mul_add(
                -(y_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
                (y - sums[2]) * over_x_sq_plus_y_sq,
            );
        // x_over_x_sq_plus_y_sq = x/x_sq_plus_y_sq
        let x_over_x_sq_plus_y_sq = x_sq_plus_y_sq
            .mul_add(
                -(x_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
                (x - sums[3]) * over_x_sq_plus_y_sq,
            );
        // y_v_over_x_sq_plus_y_sq = v*y_over_x_sq_plus_y_sq
        let y_v_over_x_sq_plus_y_sq = y_over_x_sq_plus_y_sq
            .mul_add(v_0, v.mul_add(y_over_x_sq_plus_y_sq_0, sums[4]));
        // ratio_x_v_2_of_v = x*y_v_over_x_sq_plus_y_sq
        let ratio_x_v_2_of_v = y_v_over_x_sq_plus_y_sq
            .mul_add(x_0, x.mul_add(y_v_over_x_sq_plus_y_sq_0, sums[5]));
        // x_v_over_x_sq_plus_y_sq = v*x_over_x_sq_plus_y_sq
        let x_v_over_x_sq_plus_y_sq = x_over_x_sq_plus_y_sq
            .mul_add(v_0, v.mul_add(x_over_x_sq_plus_y_sq_0, sums[6]));
        // ratio_x_v_2_of_v_2 = y*x_v_over_x_sq_plus_y_sq
        let ratio_x_v_2_of_v_2 = x_v_over_x_sq_plus_y_sq
            .mul_add(y_0, y.mul_add(x_v_over_x_sq_plus_y_sq_0, sums[7]));
        // ratio_x_v_2_of_v_3 = x_v_over_x_sq_plus_y_sq/x_sq_plus_y_sq
        let ratio_x_v_2_of_v_3 = x_v_over_x_sq_plus_y_sq
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_v_3_0, sums[8]) * over_x_sq_plus_y_sq),
            );
        // ratio_x_v_2_of_v_4 = l*ratio_x_v_2_of_v + minus_l*ratio_x_v_2_of_v_2
        let ratio_x_v_2_of_v_4 = ratio_x_v_2_of_v_2
            .mul_add(minus_l, l * ratio_x_v_2_of_v);
        // ratio_x_v_2_of_v_5 = ratio_x_v_2_of_v_4/x_sq_plus_y_sq
        let ratio_x_v_2_of_v_5 = ratio_x_v_2_of_v_4
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_v_5_0, sums[9]) * over_x_sq_plus_y_sq),
            );
        // ratio_x_v_2_of_v_6 = y_over_x_sq_plus_y_sq*ratio_x_v_2_of_v_5
        let ratio_x_v_2_of_v_6 = ratio_x_v_2_of_v_5
            .mul_add(
                y_over_x_sq_plus_y_sq_0,
                y_over_x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_v_5_0, sums[10]),
            );
        // ratio_x_v_2_of_v_7 = l_2*ratio_x_v_2_of_v_3 + weight*ratio_x_v_2_of_v_6
        let ratio_x_v_2_of_v_7 = ratio_x_v_2_of_v_6
            .mul_add(weight, l_2 * ratio_x_v_2_of_v_3);
        // ratio_y_v_2_of_v = y_v_over_x_sq_plus_y_sq/x_sq_plus_y_sq
        let ratio_y_v_2_of_v = y_v_over_x_sq_plus_y_sq
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(ratio_y_v_2_of_v_0, sums[11]) * over_x_sq_plus_y_sq),
            );
        // ratio_y_v_2_of_v_2 = x_over_x_sq_plus_y_sq*ratio_x_v_2_of_v_5
        let ratio_y_v_2_of_v_2 = ratio_x_v_2_of_v_5
            .mul_add(
                x_over_x_sq_plus_y_sq_0,
                x_over_x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_v_5_0, sums[12]),
            );
        // ratio_y_v_2_of_v_3 = l_2*ratio_y_v_2_of_v + minus_2_l*ratio_y_v_2_of_v_2
        let ratio_y_v_2_of_v_3 = ratio_y_v_2_of_v_2
            .mul_add(minus_2_l, l_2 * ratio_y_v_2_of_v);
        // v_dot_2_of_v = v*ratio_y_v_2_of_v_3
        let v_dot_2_of_v = ratio_y_v_2_of_v_3
            .mul_add(v_0, v.mul_add(ratio_y_v_2_of_v_3_0, sums[13]));
        // g_minus_v_ratio_y_v_2 = g - v_dot_2_of_v
        let g_minus_v_ratio_y_v_2 = -v_dot_2_of_v;
        // v_dot_2_of_x_y = y_over_x_sq_plus_y_sq*y_over_x_sq_plus_y_sq
        let v_dot_2_of_x_y = y_over_x_sq_plus_y_sq
            .mul_add(y_over_x_sq_plus_y_sq_0 + y_over_x_sq_plus_y_sq_0, sums[14]);
        // v_dot_2_of_x_y_2 = x_over_x_sq_plus_y_sq*x_over_x_sq_plus_y_sq
        let v_dot_2_of_x_y_2 = x_over_x_sq_plus_y_sq
            .mul_add(x_over_x_sq_plus_y_sq_0 + x_over_x_sq_plus_y_sq_0, sums[15]);
        // v_dot_2_of_place = l_2*v_dot_2_of_x_y + l_2*v_dot_2_of_x_y_2
        let v_dot_2_of_place = v_dot_2_of_x_y_2.mul_add(l_2, l_2 * v_dot_2_of_x_y);
        // v_dot_2_of_v_2 = ratio_x_v_2_of_v_7*y_v_over_x_sq_plus_y_sq
        let v_dot_2_of_v_2 = ratio_x_v_2_of_v_7
            .mul_add(
                y_v_over_x_sq_plus_y_sq_0,
                y_v_over_x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_v_7_0, sums[16]),
            );
        // v_dot_2_of_v_3 = x_over_x_sq_plus_y_sq*g_minus_v_ratio_y_v_2
        let v_dot_2_of_v_3 = g_minus_v_ratio_y_v_2
            .mul_add(
                x_over_x_sq_plus_y_sq_0,
                x_over_x_sq_plus_y_sq.mul_add(g_minus_v_ratio_y_v_2_0, sums[17]),
            );
        // v_dot_2_of_v_4 = l*v_dot_2_of_v_2 + l*v_dot_2_of_v_3
        let v_dot_2_of_v_4 = v_dot_2_of_v_3.mul_add(l, l * v_dot_2_of_v_2);
        // v_dot_2_of_v_5 = v_dot_2_of_v_4/v_dot_2_of_place
        let v_dot_2_of_v_5 = v_dot_2_of_v_4
            .mul_add(
                over_v_dot_2_of_place,
                -(v_dot_2_of_place.mul_add(v_dot_2_of_v_5_0, sums[18]) * over_v_dot_2_of_place),
            );
        x_rate = minus_l * y_v_over_x_sq_plus_y_sq;
        y_rate = l * x_v_over_x_sq_plus_y_sq;
        v_rate = -v_dot_2_of_v_5;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                x, y, x_sq_plus_y_sq, x_sq_plus_y_sq, v, x, v, y, x_sq_plus_y_sq, x_sq_plus_y_sq,
                y_over_x_sq_plus_y_sq, x_sq_plus_y_sq, x_over_x_sq_plus_y_sq, v,
                y_over_x_sq_plus_y_sq, x_over_x_sq_plus_y_sq, ratio_x_v_2_of_v_7,
                x_over_x_sq_plus_y_sq, v_dot_2_of_place,
            ]),
            padded([
                x, y, y_over_x_sq_plus_y_sq, x_over_x_sq_plus_y_sq, y_over_x_sq_plus_y_sq,
                y_v_over_x_sq_plus_y_sq, x_over_x_sq_plus_y_sq, x_v_over_x_sq_plus_y_sq,
                ratio_x_v_2_of_v_3, ratio_x_v_2_of_v_5, ratio_x_v_2_of_v_5, ratio_y_v_2_of_v,
                ratio_x_v_2_of_v_5, ratio_y_v_2_of_v_3, y_over_x_sq_plus_y_sq,
                x_over_x_sq_plus_y_sq, y_v_over_x_sq_plus_y_sq, g_minus_v_ratio_y_v_2,
                v_dot_2_of_v_5,
            ]),
        ];
        x_last = x;
        y_last = y;
        v_last = v;
        x_sq_plus_y_sq_last = x_sq_plus_y_sq;
        y_over_x_sq_plus_y_sq_last = y_over_x_sq_plus_y_sq;
        x_over_x_sq_plus_y_sq_last = x_over_x_sq_plus_y_sq;
        y_v_over_x_sq_plus_y_sq_last = y_v_over_x_sq_plus_y_sq;
        x_v_over_x_sq_plus_y_sq_last = x_v_over_x_sq_plus_y_sq;
        ratio_x_v_2_of_v_3_last = ratio_x_v_2_of_v_3;
        ratio_x_v_2_of_v_5_last = ratio_x_v_2_of_v_5;
        ratio_x_v_2_of_v_7_last = ratio_x_v_2_of_v_7;
        ratio_y_v_2_of_v_last = ratio_y_v_2_of_v;
        ratio_y_v_2_of_v_3_last = ratio_y_v_2_of_v_3;
        g_minus_v_ratio_y_v_2_last = g_minus_v_ratio_y_v_2;
        v_dot_2_of_place_last = v_dot_2_of_place;
        v_dot_2_of_v_5_last = v_dot_2_of_v_5;
    }
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
    direction: &[S; 3],
) -> [S; 3] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[2 + i],
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
            parameters: 3,
            coordinates: 2,
            variables: 1,
            speeds: 1,
            reactions: 1,
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
        3
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
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        48 * order + SLACK
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
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["x^2 + y^2"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["rod"][at]
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
