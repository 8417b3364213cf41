//! Three-link pendulum on a cart: Three links fall over while the cart is pushed.
//!
//! Generated from `models/cart_pendulum_3/scenes/fall.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q0, q1, q2, q3, u0, u1, u2, u3.
//! States: q1, q2, q3, u1, u2, u3. Quadratures: u0, q0.
//! Parameters that the scene fixes: m0 = 0.87, m1 = 1.37, m2 = 1.96, m3 = 1.49, l0 = 0.64, l1 = 0.52, l2 = 0.4, g = 9.81, F = 2.75.
//! Cost: accelerations 201 operations, 3 sines and cosines; derivative 201 operations, 3 sines and cosines.
//! Singular nowhere.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Scalar, System};

/// The parameters, in the order of the model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// A model without parameters.
    pub none: core::marker::PhantomData<S>,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(_p: &[S]) -> Self {
        Self {
            none: core::marker::PhantomData,
        }
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 0] = [];

/// Names of the outputs.
pub const OUTPUTS: [&str; 8] = ["q0", "q1", "q2", "q3", "u0", "u1", "u2", "u3"];

/// The accelerations (u1', u2', u3', u0'), solved for when this code was generated.
///
/// 201 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(_p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, _] = *u;
    // Sines and cosines.
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // u3^2; used 4 times
    let u3_sq = u3 * u3;
    // u3_sq*sin(q3); used 2 times
    let s3_u3_sq = u3_sq * s3;
    // cos(q3)^2; used 5 times
    let c3_sq = c3 * c3;
    // 85347*cos(q3) - 27500*sin(q3); used 2 times
    let u0_dot_part = (-s3).mul_add(S::int(27500), S::int(85347) * c3);
    // u3_sq*cos(q3); used 3 times
    let c3_u3_sq = u3_sq * c3;
    // u2^2; used 5 times
    let u2_sq = u2 * u2;
    // sin(q2)*sin(q3); used 2 times
    let s2_s3 = s2 * s3;
    // u1^2; used 4 times
    let u1_sq = u1 * u1;
    // 384192*u1_sq; used 2 times
    let u1_sq_scaled = S::int(384192) * u1_sq;
    // u1_sq*cos(q1); used 2 times
    let c1_u1_sq = u1_sq * c1;
    // 2384*c3_u3_sq - 67689 + 4416*c1_u1_sq; used 2 times
    let u0_dot_part_2 = c3_u3_sq.mul_add(S::int(2384), -S::int(67689))
        + S::int(4416) * c1_u1_sq;
    // sin(q2)*(1192*u3_sq - u0_dot_part_2*cos(q3)) + sin(q3)*(3588*u2_sq + u0_dot_part_2*cos(q2))
    let u0_dot_part_3 = s2 * (-u0_dot_part_2).mul_add(c3, S::int(1192) * u3_sq)
        + s3 * u0_dot_part_2.mul_add(c2, S::int(3588) * u2_sq);
    // u2_sq*sin(q2); used 3 times
    let s2_u2_sq = u2_sq * s2;
    // 298*s3_u3_sq + 897*s2_u2_sq; used 2 times
    let u0_dot_part_4 = s2_u2_sq.mul_add(S::int(897), S::int(298) * s3_u3_sq);
    // s2_s3*cos(q3); used 2 times
    let c3_s2_s3 = s2_s3 * c3;
    // sin(q1)*sin(q2); used 2 times
    let s1_s2 = s1 * s2;
    // cos(q1)^2; used 2 times
    let c1_sq = c1 * c1;
    // (cos(q2)*(sin(q1)*(69*cos(q1)*(sin(q2)*(85347*sin(q3) + 27500*cos(q3)) + u0_dot_part*cos(q2)) +
    //   sin(q1)*(sin(q2)*(163304*u3_sq*(2*c3_sq - 1) + 69*u0_dot_part) - cos(q2)*(1897500*cos(q3) +
    //   sin(q3)*(5888943 + 326608*c3_u3_sq)) - 491556*u2_sq*sin(q3)) - u1_sq_scaled*(cos(q2)*cos(q3) +
    //   s2_s3)) - 87*u0_dot_part_3) + cos(q3)*(348*u0_dot_part_4 + sin(q1)*(u1_sq_scaled - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 137*u0_dot_part_4))))/(cos(q2)*(28*cos(q2)*(326608*c3_sq - 373409) +
    //   9145024*c3_s2_s3 + cos(q1)*(11765880*s1_s2 - cos(q1)*(cos(q2)*(5593162*c3_sq - 14562461) +
    //   5593162*c3_s2_s3))) - 15278788 - 4572512*c3_sq + c1_sq*(7059724 + 2796581*c3_sq)); used 2 times
    let u0_dot_part_5 = (c2
        * (s1
            * (S::int(69) * c1
                * (s2 * c3.mul_add(S::int(27500), S::int(85347) * s3) + u0_dot_part * c2)
                + s1
                    * (s2
                        * (S::int(163304) * u3_sq * c3_sq.mul_add(S::int(2), -S::int(1))
                            + S::int(69) * u0_dot_part)
                        - c2
                            * (s3 * c3_u3_sq.mul_add(S::int(326608), S::int(5888943))
                                + S::int(1897500) * c3) - S::int(491556) * u2_sq * s3)
                - u1_sq_scaled * c2.mul_add(c3, s2_s3)) - S::int(87) * u0_dot_part_3)
        + c3
            * (s1
                * (u1_sq_scaled - S::int(5888943) * c1
                    + S::int(4) * s1
                        * u0_dot_part_4.mul_add(S::int(137), S::int(474375)))
                + S::int(348) * u0_dot_part_4))
        / (c2
            * (S::int(28) * c2 * c3_sq.mul_add(S::int(326608), -S::int(373409))
                + S::int(9145024) * c3_s2_s3
                + c1
                    * (-c1
                        * (c2 * c3_sq.mul_add(S::int(5593162), -S::int(14562461))
                            + S::int(5593162) * c3_s2_s3) + S::int(11765880) * s1_s2))
            - S::int(15278788) - S::int(4572512) * c3_sq
            + c1_sq * c3_sq.mul_add(S::int(2796581), S::int(7059724)));
    // 137*u0_dot_part_5; used 2 times
    let u0_dot_part_5_scaled = S::int(137) * u0_dot_part_5;
    // 8*s3_u3_sq + u0_dot_part_5_scaled*cos(q3); used 4 times
    let u0_dot_part_6 = u0_dot_part_5_scaled.mul_add(c3, S::int(8) * s3_u3_sq);
    // u2_sq*cos(q2); used 3 times
    let c2_u2_sq = u2_sq * c2;
    // 8*c3_u3_sq - u0_dot_part_5_scaled*sin(q3); used 3 times
    let u0_dot_part_7 = (-u0_dot_part_5_scaled).mul_add(s3, S::int(8) * c3_u3_sq);
    // 472842 - 745*u0_dot_part_7; used 2 times
    let u0_dot_part_8 = (-u0_dot_part_7).mul_add(S::int(745), S::int(472842));
    // 2651000 + 12963*u0_dot_part_6; used 2 times
    let u0_dot_part_9 = u0_dot_part_6.mul_add(S::int(12963), S::int(2651000));
    // u1_sq*sin(q1); used 2 times
    let s1_u1_sq = u1_sq * s1;
    // cos(q2)^2; used 2 times
    let c2_sq = c2 * c2;
    // (11614997*u0_dot_part_7*sin(q2) + cos(q1)*(185180544*u1_sq*sin(q2) + cos(q1)*(cos(q2)*(914595000 +
    //   14311301*u0_dot_part_6) + sin(q2)*(215387640*c2_u2_sq - 2838470526 - 5366831*u0_dot_part_7)) +
    //   69*sin(q1)*(1560780*u2_sq + 87*cos(q2)*(u0_dot_part_8 - 35880*c2_u2_sq) + 5*u0_dot_part_9*sin(q2)))
    //   - 4*cos(q2)*(228648750 + 26923455*s2_u2_sq + 4021808*u0_dot_part_6 + 46295136*s1_u1_sq))/(77953 +
    //   30015*c2_sq - cos(q1)*(60030*s1_s2*cos(q2) + cos(q1)*(36019 + 60030*c2_sq))); used 3 times
    let u0_dot_part_10 = (c1
        * (c1
            * (c2 * u0_dot_part_6.mul_add(S::int(14311301), S::int(914595000))
                + s2
                    * (c2_u2_sq.mul_add(S::int(215387640), -S::int(2838470526))
                        - S::int(5366831) * u0_dot_part_7))
            + S::int(185180544) * u1_sq * s2
            + S::int(69) * s1
                * (S::int(87) * c2 * (-c2_u2_sq).mul_add(S::int(35880), u0_dot_part_8)
                    + S::int(1560780) * u2_sq + S::int(5) * u0_dot_part_9 * s2))
        + S::int(11614997) * u0_dot_part_7 * s2
        - S::int(4) * c2
            * (s2_u2_sq.mul_add(S::int(26923455), S::int(228648750))
                + S::int(4021808) * u0_dot_part_6 + S::int(46295136) * s1_u1_sq))
        / (S::int(77953) + S::int(30015) * c2_sq
            - c1
                * (c1 * c2_sq.mul_add(S::int(60030), S::int(36019))
                    + S::int(60030) * s1_s2 * c2));
    // 3588*s2_u2_sq + u0_dot_part_10*cos(q2); used 2 times
    let u0_dot_part_11 = u0_dot_part_10.mul_add(c2, S::int(3588) * s2_u2_sq);
    // (sin(q1)*(14868736*c1_u1_sq + 10207860*c2_u2_sq - 569*u0_dot_part_8 - 2845*u0_dot_part_10*sin(q2)) -
    //   5*cos(q1)*(u0_dot_part_9 + 87*u0_dot_part_11))/(482*c1_sq - 569); used 2 times
    let u0_dot_part_12 = (s1
        * (c2_u2_sq.mul_add(S::int(10207860), S::int(14868736) * c1_u1_sq)
            - S::int(569) * u0_dot_part_8 - S::int(2845) * u0_dot_part_10 * s2)
        - S::int(5) * c1 * u0_dot_part_11.mul_add(S::int(87), u0_dot_part_9))
        / c1_sq.mul_add(S::int(482), -S::int(569));
    // Elimination, step by step.
    // u0' = 275/569 - 7712*u1^2*sin(q1)/14225 - 897*u2^2*sin(q2)/2845 - 298*u3^2*sin(q3)/2845 +
    //   20413*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(11380*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(11380*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) + cos(q1)*(sin(q1)*(14868736*u1^2*cos(q1) - 269047098
    //   + 10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(56900*(482*cos(q1)^2 - 569))
    let u0_dot = S::ratio(275, 569) - S::ratio(149, 11380) * u0_dot_part_6
        - S::ratio(7712, 14225) * s1_u1_sq - S::ratio(1, 11380) * u0_dot_part_11
        + S::ratio(1, 56900) * u0_dot_part_12 * c1;
    // u3' = 137*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(8*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))
    let u3_dot = -S::ratio(137, 8) * u0_dot_part_5;
    // u2' = (cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(3588*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2))
    let u2_dot = -S::ratio(1, 3588) * u0_dot_part_10;
    // u1' = (sin(q1)*(14868736*u1^2*cos(q1) - 269047098 + 10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(30848*(482*cos(q1)^2 - 569))
    let u1_dot = S::ratio(1, 30848) * u0_dot_part_12;
    [u1_dot, u2_dot, u3_dot, u0_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 201 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, u0] = *u;
    // Sines and cosines.
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // u3^2; used 4 times
    let u3_sq = u3 * u3;
    // u3_sq*sin(q3); used 2 times
    let s3_u3_sq = u3_sq * s3;
    // cos(q3)^2; used 5 times
    let c3_sq = c3 * c3;
    // 85347*cos(q3) - 27500*sin(q3); used 2 times
    let u0_dot_part = (-s3).mul_add(S::int(27500), S::int(85347) * c3);
    // u3_sq*cos(q3); used 3 times
    let c3_u3_sq = u3_sq * c3;
    // u2^2; used 5 times
    let u2_sq = u2 * u2;
    // sin(q2)*sin(q3); used 2 times
    let s2_s3 = s2 * s3;
    // u1^2; used 4 times
    let u1_sq = u1 * u1;
    // 384192*u1_sq; used 2 times
    let u1_sq_scaled = S::int(384192) * u1_sq;
    // u1_sq*cos(q1); used 2 times
    let c1_u1_sq = u1_sq * c1;
    // 2384*c3_u3_sq - 67689 + 4416*c1_u1_sq; used 2 times
    let u0_dot_part_2 = c3_u3_sq.mul_add(S::int(2384), -S::int(67689))
        + S::int(4416) * c1_u1_sq;
    // sin(q2)*(1192*u3_sq - u0_dot_part_2*cos(q3)) + sin(q3)*(3588*u2_sq + u0_dot_part_2*cos(q2))
    let u0_dot_part_3 = s2 * (-u0_dot_part_2).mul_add(c3, S::int(1192) * u3_sq)
        + s3 * u0_dot_part_2.mul_add(c2, S::int(3588) * u2_sq);
    // u2_sq*sin(q2); used 3 times
    let s2_u2_sq = u2_sq * s2;
    // 298*s3_u3_sq + 897*s2_u2_sq; used 2 times
    let u0_dot_part_4 = s2_u2_sq.mul_add(S::int(897), S::int(298) * s3_u3_sq);
    // s2_s3*cos(q3); used 2 times
    let c3_s2_s3 = s2_s3 * c3;
    // sin(q1)*sin(q2); used 2 times
    let s1_s2 = s1 * s2;
    // cos(q1)^2; used 2 times
    let c1_sq = c1 * c1;
    // (cos(q2)*(sin(q1)*(69*cos(q1)*(sin(q2)*(85347*sin(q3) + 27500*cos(q3)) + u0_dot_part*cos(q2)) +
    //   sin(q1)*(sin(q2)*(163304*u3_sq*(2*c3_sq - 1) + 69*u0_dot_part) - cos(q2)*(1897500*cos(q3) +
    //   sin(q3)*(5888943 + 326608*c3_u3_sq)) - 491556*u2_sq*sin(q3)) - u1_sq_scaled*(cos(q2)*cos(q3) +
    //   s2_s3)) - 87*u0_dot_part_3) + cos(q3)*(348*u0_dot_part_4 + sin(q1)*(u1_sq_scaled - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 137*u0_dot_part_4))))/(cos(q2)*(28*cos(q2)*(326608*c3_sq - 373409) +
    //   9145024*c3_s2_s3 + cos(q1)*(11765880*s1_s2 - cos(q1)*(cos(q2)*(5593162*c3_sq - 14562461) +
    //   5593162*c3_s2_s3))) - 15278788 - 4572512*c3_sq + c1_sq*(7059724 + 2796581*c3_sq)); used 2 times
    let u0_dot_part_5 = (c2
        * (s1
            * (S::int(69) * c1
                * (s2 * c3.mul_add(S::int(27500), S::int(85347) * s3) + u0_dot_part * c2)
                + s1
                    * (s2
                        * (S::int(163304) * u3_sq * c3_sq.mul_add(S::int(2), -S::int(1))
                            + S::int(69) * u0_dot_part)
                        - c2
                            * (s3 * c3_u3_sq.mul_add(S::int(326608), S::int(5888943))
                                + S::int(1897500) * c3) - S::int(491556) * u2_sq * s3)
                - u1_sq_scaled * c2.mul_add(c3, s2_s3)) - S::int(87) * u0_dot_part_3)
        + c3
            * (s1
                * (u1_sq_scaled - S::int(5888943) * c1
                    + S::int(4) * s1
                        * u0_dot_part_4.mul_add(S::int(137), S::int(474375)))
                + S::int(348) * u0_dot_part_4))
        / (c2
            * (S::int(28) * c2 * c3_sq.mul_add(S::int(326608), -S::int(373409))
                + S::int(9145024) * c3_s2_s3
                + c1
                    * (-c1
                        * (c2 * c3_sq.mul_add(S::int(5593162), -S::int(14562461))
                            + S::int(5593162) * c3_s2_s3) + S::int(11765880) * s1_s2))
            - S::int(15278788) - S::int(4572512) * c3_sq
            + c1_sq * c3_sq.mul_add(S::int(2796581), S::int(7059724)));
    // 137*u0_dot_part_5; used 2 times
    let u0_dot_part_5_scaled = S::int(137) * u0_dot_part_5;
    // 8*s3_u3_sq + u0_dot_part_5_scaled*cos(q3); used 4 times
    let u0_dot_part_6 = u0_dot_part_5_scaled.mul_add(c3, S::int(8) * s3_u3_sq);
    // u2_sq*cos(q2); used 3 times
    let c2_u2_sq = u2_sq * c2;
    // 8*c3_u3_sq - u0_dot_part_5_scaled*sin(q3); used 3 times
    let u0_dot_part_7 = (-u0_dot_part_5_scaled).mul_add(s3, S::int(8) * c3_u3_sq);
    // 472842 - 745*u0_dot_part_7; used 2 times
    let u0_dot_part_8 = (-u0_dot_part_7).mul_add(S::int(745), S::int(472842));
    // 2651000 + 12963*u0_dot_part_6; used 2 times
    let u0_dot_part_9 = u0_dot_part_6.mul_add(S::int(12963), S::int(2651000));
    // u1_sq*sin(q1); used 2 times
    let s1_u1_sq = u1_sq * s1;
    // cos(q2)^2; used 2 times
    let c2_sq = c2 * c2;
    // (11614997*u0_dot_part_7*sin(q2) + cos(q1)*(185180544*u1_sq*sin(q2) + cos(q1)*(cos(q2)*(914595000 +
    //   14311301*u0_dot_part_6) + sin(q2)*(215387640*c2_u2_sq - 2838470526 - 5366831*u0_dot_part_7)) +
    //   69*sin(q1)*(1560780*u2_sq + 87*cos(q2)*(u0_dot_part_8 - 35880*c2_u2_sq) + 5*u0_dot_part_9*sin(q2)))
    //   - 4*cos(q2)*(228648750 + 26923455*s2_u2_sq + 4021808*u0_dot_part_6 + 46295136*s1_u1_sq))/(77953 +
    //   30015*c2_sq - cos(q1)*(60030*s1_s2*cos(q2) + cos(q1)*(36019 + 60030*c2_sq))); used 3 times
    let u0_dot_part_10 = (c1
        * (c1
            * (c2 * u0_dot_part_6.mul_add(S::int(14311301), S::int(914595000))
                + s2
                    * (c2_u2_sq.mul_add(S::int(215387640), -S::int(2838470526))
                        - S::int(5366831) * u0_dot_part_7))
            + S::int(185180544) * u1_sq * s2
            + S::int(69) * s1
                * (S::int(87) * c2 * (-c2_u2_sq).mul_add(S::int(35880), u0_dot_part_8)
                    + S::int(1560780) * u2_sq + S::int(5) * u0_dot_part_9 * s2))
        + S::int(11614997) * u0_dot_part_7 * s2
        - S::int(4) * c2
            * (s2_u2_sq.mul_add(S::int(26923455), S::int(228648750))
                + S::int(4021808) * u0_dot_part_6 + S::int(46295136) * s1_u1_sq))
        / (S::int(77953) + S::int(30015) * c2_sq
            - c1
                * (c1 * c2_sq.mul_add(S::int(60030), S::int(36019))
                    + S::int(60030) * s1_s2 * c2));
    // 3588*s2_u2_sq + u0_dot_part_10*cos(q2); used 2 times
    let u0_dot_part_11 = u0_dot_part_10.mul_add(c2, S::int(3588) * s2_u2_sq);
    // (sin(q1)*(14868736*c1_u1_sq + 10207860*c2_u2_sq - 569*u0_dot_part_8 - 2845*u0_dot_part_10*sin(q2)) -
    //   5*cos(q1)*(u0_dot_part_9 + 87*u0_dot_part_11))/(482*c1_sq - 569); used 2 times
    let u0_dot_part_12 = (s1
        * (c2_u2_sq.mul_add(S::int(10207860), S::int(14868736) * c1_u1_sq)
            - S::int(569) * u0_dot_part_8 - S::int(2845) * u0_dot_part_10 * s2)
        - S::int(5) * c1 * u0_dot_part_11.mul_add(S::int(87), u0_dot_part_9))
        / c1_sq.mul_add(S::int(482), -S::int(569));
    // Elimination, step by step.
    // u0' = 275/569 - 7712*u1^2*sin(q1)/14225 - 897*u2^2*sin(q2)/2845 - 298*u3^2*sin(q3)/2845 +
    //   20413*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(11380*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(11380*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) + cos(q1)*(sin(q1)*(14868736*u1^2*cos(q1) - 269047098
    //   + 10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(56900*(482*cos(q1)^2 - 569))
    let u0_dot = S::ratio(275, 569) - S::ratio(149, 11380) * u0_dot_part_6
        - S::ratio(7712, 14225) * s1_u1_sq - S::ratio(1, 11380) * u0_dot_part_11
        + S::ratio(1, 56900) * u0_dot_part_12 * c1;
    // u3' = 137*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(8*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))
    let u3_dot = -S::ratio(137, 8) * u0_dot_part_5;
    // u2' = (cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(3588*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2))
    let u2_dot = -S::ratio(1, 3588) * u0_dot_part_10;
    // u1' = (sin(q1)*(14868736*u1^2*cos(q1) - 269047098 + 10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(30848*(482*cos(q1)^2 - 569))
    let u1_dot = S::ratio(1, 30848) * u0_dot_part_12;
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    // q0' = u0
    let q0_dot_value = u0;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, q0_dot_value],
        [u1_dot, u2_dot, u3_dot, u0_dot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, q0, u1, u2, u3, u0.
///
/// 714 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(_p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [[S; 8]; 8] {
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, _] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    // u1^2; used 4 times
    let u1_sq = u1 * u1;
    // u1_sq*cos(q1); used 4 times
    let c1_u1_sq = u1_sq * c1;
    // cos(q3)^2; used 6 times
    let c3_sq = c3 * c3;
    // 5593162*c3_sq - 14562461; used 2 times
    let u0_dot_by_q1_part = c3_sq.mul_add(S::int(5593162), -S::int(14562461));
    // sin(q3)*cos(q3); used 5 times
    let s3_c3 = s3 * c3;
    // s3_c3*sin(q2); used 2 times
    let s2_s3_c3 = s3_c3 * s2;
    // u0_dot_by_q1_part*cos(q2) + 5593162*s2_s3_c3; used 2 times
    let u0_dot_by_q1_part_2 = s2_s3_c3.mul_add(S::int(5593162), u0_dot_by_q1_part * c2);
    // sin(q1)*sin(q2); used 3 times
    let s1_s2 = s1 * s2;
    // 11765880*s1_s2 - u0_dot_by_q1_part_2*cos(q1); used 2 times
    let u0_dot_by_q1_part_3 = (-u0_dot_by_q1_part_2)
        .mul_add(c1, S::int(11765880) * s1_s2);
    // 326608*c3_sq - 373409
    let u0_dot_by_q1_part_4 = c3_sq.mul_add(S::int(326608), -S::int(373409));
    // 28*u0_dot_by_q1_part_4; used 2 times
    let u0_dot_by_q1_part_4_scaled = S::int(28) * u0_dot_by_q1_part_4;
    // 9145024*s2_s3_c3 + u0_dot_by_q1_part_3*cos(q1) + u0_dot_by_q1_part_4_scaled*cos(q2); used 2 times
    let u0_dot_by_q1_part_5 = u0_dot_by_q1_part_3.mul_add(c1, S::int(9145024) * s2_s3_c3)
        + u0_dot_by_q1_part_4_scaled * c2;
    // 7059724 + 2796581*c3_sq; used 2 times
    let u0_dot_by_q1_part_6 = c3_sq.mul_add(S::int(2796581), S::int(7059724));
    // cos(q1)^2; used 3 times
    let c1_sq = c1 * c1;
    // 1/(15278788 + 4572512*c3_sq - u0_dot_by_q1_part_5*cos(q2) - u0_dot_by_q1_part_6*c1_sq); used 7 times
    let u0_dot_by_q1_part_7 = S::int(1)
        / (c3_sq.mul_add(S::int(4572512), S::int(15278788)) - u0_dot_by_q1_part_5 * c2
            - u0_dot_by_q1_part_6 * c1_sq);
    // u0_dot_by_q1_part_7*cos(q3); used 8 times
    let u0_dot_by_q1_part_8 = u0_dot_by_q1_part_7 * c3;
    // 85347*cos(q3) - 27500*sin(q3); used 2 times
    let u0_dot_by_q1_part_9 = (-s3).mul_add(S::int(27500), S::int(85347) * c3);
    // 1 - 2*c3_sq; used 3 times
    let u0_dot_by_q1_part_10 = (-c3_sq).mul_add(S::int(2), S::int(1));
    // -u0_dot_by_q1_part_10; used 2 times
    let u0_dot_by_q1_part_10_scaled = -u0_dot_by_q1_part_10;
    // u3*u0_dot_by_q1_part_10_scaled; used 2 times
    let u0_dot_by_q1_part_11 = u3 * u0_dot_by_q1_part_10_scaled;
    // -69*u0_dot_by_q1_part_9 - 163304*u3*u0_dot_by_q1_part_11; used 2 times
    let u0_dot_by_q1_part_12 = (-(u3 * u0_dot_by_q1_part_11))
        .mul_add(S::int(163304), -S::int(69) * u0_dot_by_q1_part_9);
    // u3*cos(q3); used 3 times
    let u3_c3 = u3 * c3;
    // u3*u3_c3; used 4 times
    let u3_u3_c3 = u3 * u3_c3;
    // 5888943 + 326608*u3_u3_c3; used 2 times
    let u0_dot_by_q1_part_13 = u3_u3_c3.mul_add(S::int(326608), S::int(5888943));
    // 1897500*cos(q3) + u0_dot_by_q1_part_13*sin(q3); used 2 times
    let u0_dot_by_q1_part_14 = u0_dot_by_q1_part_13.mul_add(s3, S::int(1897500) * c3);
    // u2^2; used 5 times
    let u2_sq = u2 * u2;
    // 491556*u2_sq; used 2 times
    let u2_sq_scaled = S::int(491556) * u2_sq;
    // u0_dot_by_q1_part_12*sin(q2) + u0_dot_by_q1_part_14*cos(q2) + u2_sq_scaled*sin(q3); used 2 times
    let u0_dot_by_q1_part_15 = u0_dot_by_q1_part_14
        .mul_add(c2, u0_dot_by_q1_part_12 * s2) + u2_sq_scaled * s3;
    // sin(q2)*sin(q3); used 2 times
    let s2_s3 = s2 * s3;
    // cos(q2)*cos(q3); used 2 times
    let c2_c3 = c2 * c3;
    // s2_s3 + c2_c3; used 3 times
    let s2_s3_plus_c2_c3 = s2_s3 + c2_c3;
    // 384192*u1_sq; used 4 times
    let u1_sq_scaled = S::int(384192) * u1_sq;
    // 85347*sin(q3) + 27500*cos(q3); used 3 times
    let u0_dot_by_q1_part_16 = c3.mul_add(S::int(27500), S::int(85347) * s3);
    // -u0_dot_by_q1_part_9; used 2 times
    let u0_dot_by_q1_part_9_scaled = -u0_dot_by_q1_part_9;
    // u0_dot_by_q1_part_16*sin(q2) - u0_dot_by_q1_part_9_scaled*cos(q2); used 2 times
    let u0_dot_by_q1_part_17 = (-u0_dot_by_q1_part_9_scaled)
        .mul_add(c2, u0_dot_by_q1_part_16 * s2);
    // 69*cos(q1); used 3 times
    let c1_scaled = S::int(69) * c1;
    // u0_dot_by_q1_part_15*sin(q1) + s2_s3_plus_c2_c3*u1_sq_scaled - u0_dot_by_q1_part_17*c1_scaled; used
    //   2 times
    let u0_dot_by_q1_part_18 = s2_s3_plus_c2_c3
        .mul_add(u1_sq_scaled, u0_dot_by_q1_part_15 * s1)
        - u0_dot_by_q1_part_17 * c1_scaled;
    // 69*sin(q1); used 3 times
    let s1_scaled = S::int(69) * s1;
    // cos(q2)*sin(q3) - sin(q2)*cos(q3); used 4 times
    let u0_dot_by_q1_part_19 = (-s2).mul_add(c3, c2 * s3);
    // u0_dot_by_q1_part_15*cos(q1) + u0_dot_by_q1_part_17*s1_scaled
    let u0_dot_by_q1_part_20 = u0_dot_by_q1_part_17
        .mul_add(s1_scaled, u0_dot_by_q1_part_15 * c1);
    // u2_sq*sin(q2); used 5 times
    let s2_u2_sq = u2_sq * s2;
    // u3*sin(q3); used 8 times
    let u3_s3 = u3 * s3;
    // u3*u3_s3; used 2 times
    let u3_u3_s3 = u3 * u3_s3;
    // 897*s2_u2_sq + 298*u3_u3_s3; used 2 times
    let u0_dot_by_q1_part_21 = u3_u3_s3.mul_add(S::int(298), S::int(897) * s2_u2_sq);
    // 474375 + 137*u0_dot_by_q1_part_21
    let u0_dot_by_q1_part_22 = u0_dot_by_q1_part_21.mul_add(S::int(137), S::int(474375));
    // 4*u0_dot_by_q1_part_22; used 2 times
    let u0_dot_by_q1_part_22_scaled = S::int(4) * u0_dot_by_q1_part_22;
    // 5888943*cos(q1) - u1_sq_scaled - u0_dot_by_q1_part_22_scaled*sin(q1); used 2 times
    let u0_dot_by_q1_part_23 = c1.mul_add(S::int(5888943), -u1_sq_scaled)
        - u0_dot_by_q1_part_22_scaled * s1;
    // cos(q1)*sin(q2); used 3 times
    let c1_s2 = c1 * s2;
    // 4416*c1_u1_sq - 67689 + 2384*u3_u3_c3; used 3 times
    let u0_dot_by_q1_part_24 = c1_u1_sq.mul_add(S::int(4416), -S::int(67689))
        + S::int(2384) * u3_u3_c3;
    // 1192*u3^2 - u0_dot_by_q1_part_24*cos(q3); used 2 times
    let u0_dot_by_q1_part_25 = (-u0_dot_by_q1_part_24)
        .mul_add(c3, S::int(1192) * u3 * u3);
    // 87*sin(q2); used 5 times
    let s2_scaled = S::int(87) * s2;
    // 3588*u2_sq + u0_dot_by_q1_part_24*cos(q2)
    let u0_dot_by_q1_part_26 = u0_dot_by_q1_part_24.mul_add(c2, S::int(3588) * u2_sq);
    // 87*u0_dot_by_q1_part_26; used 2 times
    let u0_dot_by_q1_part_26_scaled = S::int(87) * u0_dot_by_q1_part_26;
    // u0_dot_by_q1_part_18*sin(q1) + u0_dot_by_q1_part_25*s2_scaled + u0_dot_by_q1_part_26_scaled*sin(q3);
    //   used 2 times
    let u0_dot_by_q1_part_27 = u0_dot_by_q1_part_25
        .mul_add(s2_scaled, u0_dot_by_q1_part_18 * s1)
        + u0_dot_by_q1_part_26_scaled * s3;
    // 348*u0_dot_by_q1_part_21 - u0_dot_by_q1_part_23*sin(q1); used 2 times
    let u0_dot_by_q1_part_28 = (-u0_dot_by_q1_part_23)
        .mul_add(s1, S::int(348) * u0_dot_by_q1_part_21);
    // u0_dot_by_q1_part_27*cos(q2) - u0_dot_by_q1_part_28*cos(q3); used 2 times
    let u0_dot_by_q1_part_29 = (-u0_dot_by_q1_part_28)
        .mul_add(c3, u0_dot_by_q1_part_27 * c2);
    // u0_dot_by_q1_part_7*u0_dot_by_q1_part_29; used 3 times
    let u0_dot_by_q1_part_30 = u0_dot_by_q1_part_7 * u0_dot_by_q1_part_29;
    // cos(q2)*(u0_dot_by_q1_part_18*cos(q1) + sin(q1)*(u0_dot_by_q1_part_20 -
    //   u1_sq_scaled*u0_dot_by_q1_part_19)) + cos(q3)*(u0_dot_by_q1_part_23*cos(q1) -
    //   sin(q1)*(5888943*sin(q1) + u0_dot_by_q1_part_22_scaled*cos(q1)))
    let u0_dot_by_q1_part_31 = c2
        * (s1 * (-u1_sq_scaled).mul_add(u0_dot_by_q1_part_19, u0_dot_by_q1_part_20)
            + u0_dot_by_q1_part_18 * c1)
        + c3
            * (-s1 * u0_dot_by_q1_part_22_scaled.mul_add(c1, S::int(5888943) * s1)
                + u0_dot_by_q1_part_23 * c1);
    // u0_dot_by_q1_part_30*(2*u0_dot_by_q1_part_6*sin(q1)*cos(q1) + cos(q2)*(u0_dot_by_q1_part_3*sin(q1) -
    //   cos(q1)*(u0_dot_by_q1_part_2*sin(q1) + 11765880*c1_s2))) - u0_dot_by_q1_part_31; used 4 times
    let u0_dot_by_q1_part_32 = u0_dot_by_q1_part_30
        * (c2
            * (-c1 * c1_s2.mul_add(S::int(11765880), u0_dot_by_q1_part_2 * s1)
                + u0_dot_by_q1_part_3 * s1) + S::int(2) * u0_dot_by_q1_part_6 * s1 * c1)
        - u0_dot_by_q1_part_31;
    // u0_dot_by_q1_part_8*u0_dot_by_q1_part_32; used 4 times
    let u0_dot_by_q1_part_33 = u0_dot_by_q1_part_8 * u0_dot_by_q1_part_32;
    // u0_dot_by_q1_part_7*sin(q3); used 7 times
    let u0_dot_by_q1_part_34 = u0_dot_by_q1_part_7 * s3;
    // 137*u0_dot_by_q1_part_29; used 2 times
    let u0_dot_by_q1_part_29_scaled = S::int(137) * u0_dot_by_q1_part_29;
    // 8*u3_u3_c3 - u0_dot_by_q1_part_34*u0_dot_by_q1_part_29_scaled; used 4 times
    let u0_dot_by_q1_part_35 = (-u0_dot_by_q1_part_34)
        .mul_add(u0_dot_by_q1_part_29_scaled, S::int(8) * u3_u3_c3);
    // u2_sq*cos(q2); used 5 times
    let c2_u2_sq = u2_sq * c2;
    // 215387640*c2_u2_sq - 2838470526 - 5366831*u0_dot_by_q1_part_35; used 2 times
    let u0_dot_by_q1_part_36 = c2_u2_sq.mul_add(S::int(215387640), -S::int(2838470526))
        - S::int(5366831) * u0_dot_by_q1_part_35;
    // 8*u3_u3_s3 + u0_dot_by_q1_part_8*u0_dot_by_q1_part_29_scaled; used 4 times
    let u0_dot_by_q1_part_37 = u0_dot_by_q1_part_8
        .mul_add(u0_dot_by_q1_part_29_scaled, S::int(8) * u3_u3_s3);
    // 914595000 + 14311301*u0_dot_by_q1_part_37; used 2 times
    let u0_dot_by_q1_part_38 = u0_dot_by_q1_part_37
        .mul_add(S::int(14311301), S::int(914595000));
    // u0_dot_by_q1_part_36*sin(q2) + u0_dot_by_q1_part_38*cos(q2); used 2 times
    let u0_dot_by_q1_part_39 = u0_dot_by_q1_part_38
        .mul_add(c2, u0_dot_by_q1_part_36 * s2);
    // 472842 - 745*u0_dot_by_q1_part_35; used 2 times
    let u0_dot_by_q1_part_40 = (-u0_dot_by_q1_part_35)
        .mul_add(S::int(745), S::int(472842));
    // 35880*c2_u2_sq - u0_dot_by_q1_part_40; used 2 times
    let u0_dot_by_q1_part_41 = c2_u2_sq.mul_add(S::int(35880), -u0_dot_by_q1_part_40);
    // 87*cos(q2); used 2 times
    let c2_scaled = S::int(87) * c2;
    // 2651000 + 12963*u0_dot_by_q1_part_37; used 2 times
    let u0_dot_by_q1_part_42 = u0_dot_by_q1_part_37
        .mul_add(S::int(12963), S::int(2651000));
    // 5*u0_dot_by_q1_part_42; used 2 times
    let u0_dot_by_q1_part_42_scaled = S::int(5) * u0_dot_by_q1_part_42;
    // 1560780*u2_sq - u0_dot_by_q1_part_41*c2_scaled + u0_dot_by_q1_part_42_scaled*sin(q2); used 2 times
    let u0_dot_by_q1_part_43 = (-u0_dot_by_q1_part_41)
        .mul_add(c2_scaled, S::int(1560780) * u2_sq) + u0_dot_by_q1_part_42_scaled * s2;
    // 185180544*u1_sq; used 2 times
    let u1_sq_scaled_2 = S::int(185180544) * u1_sq;
    // u0_dot_by_q1_part_39*cos(q1) + s1_scaled*u0_dot_by_q1_part_43 + u1_sq_scaled_2*sin(q2); used 2 times
    let u0_dot_by_q1_part_44 = s1_scaled
        .mul_add(u0_dot_by_q1_part_43, u0_dot_by_q1_part_39 * c1) + u1_sq_scaled_2 * s2;
    // u0_dot_by_q1_part_32*u0_dot_by_q1_part_34; used 4 times
    let u0_dot_by_q1_part_45 = u0_dot_by_q1_part_32 * u0_dot_by_q1_part_34;
    // 612696195*sin(q1); used 2 times
    let s1_scaled_2 = S::int(612696195) * s1;
    // 36019*sin(q2); used 4 times
    let s2_scaled_2 = S::int(36019) * s2;
    // 96049*cos(q2); used 4 times
    let c2_scaled_2 = S::int(96049) * c2;
    // 20413*cos(q1); used 2 times
    let c1_scaled_2 = S::int(20413) * c1;
    // 1591254589*sin(q2); used 4 times
    let s2_scaled_3 = S::int(1591254589) * s2;
    // 60030*cos(q2); used 4 times
    let c2_scaled_3 = S::int(60030) * c2;
    // 36019 + c2_scaled_3*cos(q2); used 2 times
    let u0_dot_by_q1_part_46 = c2_scaled_3.mul_add(c2, S::int(36019));
    // s1_s2*c2_scaled_3 + u0_dot_by_q1_part_46*cos(q1); used 2 times
    let u0_dot_by_q1_part_47 = u0_dot_by_q1_part_46.mul_add(c1, s1_s2 * c2_scaled_3);
    // u1_sq*sin(q1); used 2 times
    let s1_u1_sq = u1_sq * s1;
    // 228648750 + 26923455*s2_u2_sq + 4021808*u0_dot_by_q1_part_37 + 46295136*s1_u1_sq; used 2 times
    let u0_dot_by_q1_part_48 = s2_u2_sq.mul_add(S::int(26923455), S::int(228648750))
        + S::int(4021808) * u0_dot_by_q1_part_37 + S::int(46295136) * s1_u1_sq;
    // 4*cos(q2); used 2 times
    let c2_scaled_4 = S::int(4) * c2;
    // 11614997*u0_dot_by_q1_part_35; used 2 times
    let u0_dot_by_q1_part_35_scaled = S::int(11614997) * u0_dot_by_q1_part_35;
    // u0_dot_by_q1_part_44*cos(q1) - u0_dot_by_q1_part_48*c2_scaled_4 +
    //   u0_dot_by_q1_part_35_scaled*sin(q2); used 3 times
    let u0_dot_by_q1_part_49 = (-u0_dot_by_q1_part_48)
        .mul_add(c2_scaled_4, u0_dot_by_q1_part_44 * c1)
        + u0_dot_by_q1_part_35_scaled * s2;
    // cos(q2)^2; used 2 times
    let c2_sq = c2 * c2;
    // 1/(77953 - u0_dot_by_q1_part_47*cos(q1) + 30015*c2_sq); used 8 times
    let u0_dot_by_q1_part_50 = S::int(1)
        / ((-u0_dot_by_q1_part_47).mul_add(c1, S::int(77953)) + S::int(30015) * c2_sq);
    // u0_dot_by_q1_part_49*u0_dot_by_q1_part_50; used 2 times
    let u0_dot_by_q1_part_51 = u0_dot_by_q1_part_49 * u0_dot_by_q1_part_50;
    // 15424*cos(q2)*(142891*u0_dot_by_q1_part_33 - 12006*c1_u1_sq) - u0_dot_by_q1_part_44*sin(q1) +
    //   cos(q1)*(c1_scaled*u0_dot_by_q1_part_43 - u0_dot_by_q1_part_39*sin(q1) -
    //   s1_scaled_2*(u0_dot_by_q1_part_33*sin(q2) + u0_dot_by_q1_part_45*cos(q2)) -
    //   c1_scaled_2*(u0_dot_by_q1_part_45*s2_scaled_2 + u0_dot_by_q1_part_33*c2_scaled_2)) +
    //   u0_dot_by_q1_part_45*s2_scaled_3
    let u0_dot_by_q1_part_52 = S::int(15424) * c2
        * (-c1_u1_sq).mul_add(S::int(12006), S::int(142891) * u0_dot_by_q1_part_33)
        - u0_dot_by_q1_part_44 * s1
        + c1
            * (c1_scaled * u0_dot_by_q1_part_43 - u0_dot_by_q1_part_39 * s1
                - s1_scaled_2
                    * u0_dot_by_q1_part_45.mul_add(c2, u0_dot_by_q1_part_33 * s2)
                - c1_scaled_2
                    * u0_dot_by_q1_part_33
                        .mul_add(c2_scaled_2, u0_dot_by_q1_part_45 * s2_scaled_2))
        + u0_dot_by_q1_part_45 * s2_scaled_3;
    // u0_dot_by_q1_part_51*(cos(q1)*(u0_dot_by_q1_part_46*sin(q1) - c1_s2*c2_scaled_3) +
    //   u0_dot_by_q1_part_47*sin(q1)) - u0_dot_by_q1_part_52; used 3 times
    let u0_dot_by_q1_part_53 = u0_dot_by_q1_part_51
        * (c1 * (-c1_s2).mul_add(c2_scaled_3, u0_dot_by_q1_part_46 * s1)
            + u0_dot_by_q1_part_47 * s1) - u0_dot_by_q1_part_52;
    // u0_dot_by_q1_part_50*cos(q2); used 7 times
    let u0_dot_by_q1_part_54 = u0_dot_by_q1_part_50 * c2;
    // u0_dot_by_q1_part_53*u0_dot_by_q1_part_54; used 2 times
    let u0_dot_by_q1_part_55 = u0_dot_by_q1_part_53 * u0_dot_by_q1_part_54;
    // 1/(482*c1_sq - 569); used 8 times
    let u0_dot_by_q1_part_56 = S::int(1) / c1_sq.mul_add(S::int(482), -S::int(569));
    // u0_dot_by_q1_part_50*sin(q2); used 7 times
    let u0_dot_by_q1_part_57 = u0_dot_by_q1_part_50 * s2;
    // 3588*c2_u2_sq - u0_dot_by_q1_part_49*u0_dot_by_q1_part_57; used 2 times
    let u0_dot_by_q1_part_58 = (-u0_dot_by_q1_part_49)
        .mul_add(u0_dot_by_q1_part_57, S::int(3588) * c2_u2_sq);
    // 14868736*c1_u1_sq - 569*u0_dot_by_q1_part_40 + 2845*u0_dot_by_q1_part_58; used 2 times
    let u0_dot_by_q1_part_59 = (-u0_dot_by_q1_part_40)
        .mul_add(S::int(569), S::int(14868736) * c1_u1_sq)
        + S::int(2845) * u0_dot_by_q1_part_58;
    // 3588*s2_u2_sq + u0_dot_by_q1_part_49*u0_dot_by_q1_part_54; used 2 times
    let u0_dot_by_q1_part_60 = u0_dot_by_q1_part_49
        .mul_add(u0_dot_by_q1_part_54, S::int(3588) * s2_u2_sq);
    // u0_dot_by_q1_part_42 + 87*u0_dot_by_q1_part_60
    let u0_dot_by_q1_part_61 = u0_dot_by_q1_part_60
        .mul_add(S::int(87), u0_dot_by_q1_part_42);
    // 5*u0_dot_by_q1_part_61; used 2 times
    let u0_dot_by_q1_part_61_scaled = S::int(5) * u0_dot_by_q1_part_61;
    // sin(q1)*(u0_dot_by_q1_part_59*sin(q1) - u0_dot_by_q1_part_61_scaled*cos(q1)); used 2 times
    let u0_dot_by_q1_part_62 = s1
        * (-u0_dot_by_q1_part_61_scaled).mul_add(c1, u0_dot_by_q1_part_59 * s1);
    // u0_dot_by_q1_part_56*cos(q1); used 7 times
    let u0_dot_by_q1_part_63 = u0_dot_by_q1_part_56 * c1;
    // 20413*u0_dot_by_q1_part_8; used 5 times
    let u0_dot_by_q1_part_8_scaled = S::int(20413) * u0_dot_by_q1_part_8;
    // u0_dot_by_q1_part_55 + u0_dot_by_q1_part_32*u0_dot_by_q1_part_8_scaled
    let u0_dot_by_q1_part_64 = u0_dot_by_q1_part_32
        .mul_add(u0_dot_by_q1_part_8_scaled, u0_dot_by_q1_part_55);
    // 14868736*s1_u1_sq - 58074985*u0_dot_by_q1_part_45 - 2845*u0_dot_by_q1_part_53*u0_dot_by_q1_part_57
    let u0_dot_by_q1_part_65 = (-u0_dot_by_q1_part_45)
        .mul_add(S::int(58074985), S::int(14868736) * s1_u1_sq)
        - S::int(2845) * u0_dot_by_q1_part_53 * u0_dot_by_q1_part_57;
    // cos(q1)*(u0_dot_by_q1_part_59 + 435*u0_dot_by_q1_part_64) + sin(q1)*(u0_dot_by_q1_part_61_scaled -
    //   u0_dot_by_q1_part_65)
    let u0_dot_by_q1_part_66 = c1
        * u0_dot_by_q1_part_64.mul_add(S::int(435), u0_dot_by_q1_part_59)
        + s1 * (u0_dot_by_q1_part_61_scaled - u0_dot_by_q1_part_65);
    // 964*u0_dot_by_q1_part_62*u0_dot_by_q1_part_63 + u0_dot_by_q1_part_66; used 2 times
    let u0_dot_by_q1_part_67 = (u0_dot_by_q1_part_62 * u0_dot_by_q1_part_63)
        .mul_add(S::int(964), u0_dot_by_q1_part_66);
    // u0_dot_by_q1_part_56*u0_dot_by_q1_part_62 - u0_dot_by_q1_part_63*u0_dot_by_q1_part_67
    let u0_dot_by_q1_part_68 = (-u0_dot_by_q1_part_63)
        .mul_add(u0_dot_by_q1_part_67, u0_dot_by_q1_part_56 * u0_dot_by_q1_part_62);
    // Elimination, step by step.
    // u0_dot_by_q1 = 20413*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(11380*(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2) -
    //   7712*u1^2*cos(q1)/14225 + cos(q2)*(sin(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) + cos(q1)*(sin(q1)*(36019 + 60030*cos(q2)^2) -
    //   60030*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(11380*(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2) + sin(q1)*(sin(q1)*(14868736*u1^2*cos(q1) - 269047098 +
    //   10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(56900*(569 - 482*cos(q1)^2)) +
    //   241*sin(q1)*cos(q1)^2*(sin(q1)*(14868736*u1^2*cos(q1) - 269047098 + 10207860*u2^2*cos(q2) +
    //   3391240*u3^2*cos(q3) + 58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(14225*(482*cos(q1)^2 - 569)^2) +
    //   20413*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(11380*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(1591254589*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) +
    //   cos(q1)*(69*cos(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   sin(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   612696195*sin(q1)*(cos(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   20413*cos(q1)*(36019*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) - 15424*cos(q2)*(12006*u1^2*cos(q1)
    //   + 142891*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   142891*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(11380*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) + cos(q1)*(cos(q1)*(14868736*u1^2*cos(q1) - 269047098
    //   + 10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) + 5*sin(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))) - sin(q1)*(14868736*u1^2*sin(q1) +
    //   58074985*sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   2845*sin(q2)*(sin(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) +
    //   cos(q1)*(sin(q1)*(36019 + 60030*cos(q2)^2) - 60030*cos(q1)*sin(q2)*cos(q2)))*(4*cos(q2)*(228648750 +
    //   46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2)
    //   - 5960*u3^2*cos(q3) - 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 +
    //   58074985*sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3)
    //   + cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   2845*sin(q2)*(1591254589*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) +
    //   cos(q1)*(69*cos(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   sin(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   612696195*sin(q1)*(cos(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   20413*cos(q1)*(36019*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) - 15424*cos(q2)*(12006*u1^2*cos(q1)
    //   + 142891*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   142891*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) +
    //   435*cos(q1)*(20413*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q2)*(sin(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) +
    //   cos(q1)*(sin(q1)*(36019 + 60030*cos(q2)^2) -
    //   60030*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 + 20413*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3)
    //   - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) + cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(1591254589*sin(q2)*(sin(q3)*…*…/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*…) - (…)^2*…)^2 - …*…/…) - sin(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) + …*… -
    //   15424*…*…)/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) - 77953
    //   - 30015*cos(q2)^2)))/(56900*(482*cos(q1)^2 - 569))
    let u0_dot_by_q1 = S::ratio(20413, 11380) * u0_dot_by_q1_part_33
        - S::ratio(7712, 14225) * c1_u1_sq + S::ratio(1, 11380) * u0_dot_by_q1_part_55
        - S::ratio(1, 56900) * u0_dot_by_q1_part_68;
    // Shared terms.
    // 137*u0_dot_by_q1_part_7/8; used 3 times
    let u0_dot_by_q1_part_7_scaled = S::ratio(137, 8) * u0_dot_by_q1_part_7;
    // Elimination, step by step.
    // u3_dot_by_q1 = 137*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(8*(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2) +
    //   137*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(8*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))
    let u3_dot_by_q1 = u0_dot_by_q1_part_32 * u0_dot_by_q1_part_7_scaled;
    // Shared terms.
    // u0_dot_by_q1_part_50/3588; used 2 times
    let u0_dot_by_q1_part_50_scaled = S::ratio(1, 3588) * u0_dot_by_q1_part_50;
    // Elimination, step by step.
    // u2_dot_by_q1 = (sin(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) +
    //   cos(q1)*(sin(q1)*(36019 + 60030*cos(q2)^2) -
    //   60030*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(3588*(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2) + (1591254589*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 +
    //   2796581*cos(q3)^2) + cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) -
    //   cos(q1)*(11765880*cos(q1)*sin(q2) + sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) +
    //   cos(q1)*(69*cos(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   sin(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   612696195*sin(q1)*(cos(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   20413*cos(q1)*(36019*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) - 15424*cos(q2)*(12006*u1^2*cos(q1)
    //   + 142891*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   142891*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(3588*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2))
    let u2_dot_by_q1 = u0_dot_by_q1_part_53 * u0_dot_by_q1_part_50_scaled;
    // u1_dot_by_q1 = sin(q1)*cos(q1)*(sin(q1)*(14868736*u1^2*cos(q1) - 269047098 + 10207860*u2^2*cos(q2) +
    //   3391240*u3^2*cos(q3) + 58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 5*cos(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))))/(32*(482*cos(q1)^2 - 569)^2) + (cos(q1)*(14868736*u1^2*cos(q1)
    //   - 269047098 + 10207860*u2^2*cos(q2) + 3391240*u3^2*cos(q3) +
    //   58074985*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 2845*sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) + 5*sin(q1)*(2651000 + 312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   87*cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))) - sin(q1)*(14868736*u1^2*sin(q1) +
    //   58074985*sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   2845*sin(q2)*(sin(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) +
    //   cos(q1)*(sin(q1)*(36019 + 60030*cos(q2)^2) - 60030*cos(q1)*sin(q2)*cos(q2)))*(4*cos(q2)*(228648750 +
    //   46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2)
    //   - 5960*u3^2*cos(q3) - 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 +
    //   58074985*sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3)
    //   + cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   2845*sin(q2)*(1591254589*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) +
    //   cos(q1)*(69*cos(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   sin(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   612696195*sin(q1)*(cos(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   20413*cos(q1)*(36019*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) - 15424*cos(q2)*(12006*u1^2*cos(q1)
    //   + 142891*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   142891*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) +
    //   435*cos(q1)*(20413*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q2)*(sin(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) +
    //   cos(q1)*(sin(q1)*(36019 + 60030*cos(q2)^2) -
    //   60030*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 + 20413*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3)
    //   - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) + cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(1591254589*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) +
    //   cos(q1)*(69*cos(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   sin(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   612696195*sin(q1)*(cos(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) -
    //   20413*cos(q1)*(36019*sin(q2)*(sin(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) - 15424*cos(q2)*(12006*u1^2*cos(q1)
    //   + 142891*cos(q3)*(2*sin(q1)*cos(q1)*(7059724 + 2796581*cos(q3)^2) +
    //   cos(q2)*(sin(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) - cos(q1)*(11765880*cos(q1)*sin(q2) +
    //   sin(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 -
    //   14562461)))))*(cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) -
    //   cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   142891*cos(q3)*(cos(q2)*(384192*u1^2*sin(q1)*sin(q2)*cos(q3) - 384192*u1^2*sin(q1)*cos(q2)*sin(q3) +
    //   cos(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) -
    //   27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) +
    //   sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 - 2*cos(q3)^2)) +
    //   cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   sin(q1)*(69*sin(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + cos(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))) + cos(q3)*(cos(q1)*(5888943*cos(q1) - 384192*u1^2 - 4*sin(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3))) - sin(q1)*(5888943*sin(q1) + 4*cos(q1)*(474375 +
    //   122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)))/(30848*(482*cos(q1)^2 - 569))
    let u1_dot_by_q1 = S::ratio(1, 30848) * u0_dot_by_q1_part_56 * u0_dot_by_q1_part_67;
    // Shared terms.
    // -u0_dot_by_q1_part_19; used 3 times
    let u0_dot_by_q1_part_19_scaled = -u0_dot_by_q1_part_19;
    // c1_scaled*(u0_dot_by_q1_part_16*cos(q2) + u0_dot_by_q1_part_9_scaled*sin(q2)) +
    //   u1_sq_scaled*u0_dot_by_q1_part_19_scaled; used 2 times
    let u0_dot_by_q2_part = c1_scaled
        * u0_dot_by_q1_part_9_scaled.mul_add(s2, u0_dot_by_q1_part_16 * c2)
        + u1_sq_scaled * u0_dot_by_q1_part_19_scaled;
    // u0_dot_by_q1_part_24*sin(q3); used 2 times
    let u0_dot_by_q2_part_2 = u0_dot_by_q1_part_24 * s3;
    // 137*sin(q1)^2; used 4 times
    let s1_sq_scaled = S::int(137) * s1 * s1;
    // 87 + s1_sq_scaled; used 6 times
    let u0_dot_by_q2_part_3 = S::int(87) + s1_sq_scaled;
    // s3_c3*cos(q2); used 2 times
    let c2_s3_c3 = s3_c3 * c2;
    // u0_dot_by_q1_part_27*sin(q2) + cos(q2)*(sin(q1)*(sin(q1)*(u0_dot_by_q1_part_14*sin(q2) -
    //   u0_dot_by_q1_part_12*cos(q2)) + u0_dot_by_q2_part) - u0_dot_by_q1_part_25*c2_scaled +
    //   s2_scaled*u0_dot_by_q2_part_2) + 3588*c2_u2_sq*u0_dot_by_q2_part_3*cos(q3)
    let u0_dot_by_q2_part_4 = c2
        * (s1
            * (s1 * (-u0_dot_by_q1_part_12).mul_add(c2, u0_dot_by_q1_part_14 * s2)
                + u0_dot_by_q2_part) - u0_dot_by_q1_part_25 * c2_scaled
            + s2_scaled * u0_dot_by_q2_part_2) + u0_dot_by_q1_part_27 * s2
        + S::int(3588) * c2_u2_sq * u0_dot_by_q2_part_3 * c3;
    // u0_dot_by_q1_part_30*(u0_dot_by_q1_part_5*sin(q2) + cos(q2)*(u0_dot_by_q1_part_4_scaled*sin(q2) -
    //   9145024*c2_s3_c3 - cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(u0_dot_by_q1_part*sin(q2) -
    //   5593162*c2_s3_c3)))) + u0_dot_by_q2_part_4; used 5 times
    let u0_dot_by_q2_part_5 = u0_dot_by_q1_part_30
        * (c2
            * (u0_dot_by_q1_part_4_scaled * s2 - S::int(9145024) * c2_s3_c3
                - c1
                    * (c1 * (-c2_s3_c3).mul_add(S::int(5593162), u0_dot_by_q1_part * s2)
                        + S::int(11765880) * s1 * c2)) + u0_dot_by_q1_part_5 * s2)
        + u0_dot_by_q2_part_4;
    // u0_dot_by_q1_part_8*u0_dot_by_q2_part_5; used 4 times
    let u0_dot_by_q2_part_6 = u0_dot_by_q1_part_8 * u0_dot_by_q2_part_5;
    // u0_dot_by_q1_part_34*u0_dot_by_q2_part_5; used 2 times
    let u0_dot_by_q2_part_7 = u0_dot_by_q1_part_34 * u0_dot_by_q2_part_5;
    // 215387640*s2_u2_sq + 735255847*u0_dot_by_q2_part_7
    let u0_dot_by_q2_part_8 = u0_dot_by_q2_part_7
        .mul_add(S::int(735255847), S::int(215387640) * s2_u2_sq);
    // 1960648237*cos(q2); used 2 times
    let c2_scaled_5 = S::int(1960648237) * c2;
    // 20413*u0_dot_by_q1_part_34; used 3 times
    let u0_dot_by_q1_part_34_scaled = S::int(20413) * u0_dot_by_q1_part_34;
    // u0_dot_by_q2_part_5*u0_dot_by_q1_part_34_scaled; used 2 times
    let u0_dot_by_q2_part_9 = u0_dot_by_q2_part_5 * u0_dot_by_q1_part_34_scaled;
    // 7176*s2_u2_sq - u0_dot_by_q2_part_9
    let u0_dot_by_q2_part_10 = s2_u2_sq.mul_add(S::int(7176), -u0_dot_by_q2_part_9);
    // 2*cos(q2); used 5 times
    let c2_scaled_6 = S::int(2) * c2;
    // 4*u0_dot_by_q1_part_48*sin(q2) + u0_dot_by_q1_part_35_scaled*cos(q2) +
    //   c2_scaled_4*(550987696*u0_dot_by_q2_part_6 - 26923455*c2_u2_sq) + s2_scaled_3*u0_dot_by_q2_part_7 +
    //   cos(q1)*(u1_sq_scaled_2*cos(q2) + cos(q1)*(u0_dot_by_q1_part_36*cos(q2) -
    //   sin(q2)*(u0_dot_by_q1_part_38 + u0_dot_by_q2_part_8) - u0_dot_by_q2_part_6*c2_scaled_5) +
    //   s1_scaled*(s2_scaled*u0_dot_by_q1_part_41 - 8879655*u0_dot_by_q2_part_6*sin(q2) +
    //   cos(q2)*(u0_dot_by_q1_part_42_scaled + 435*u0_dot_by_q2_part_10)))
    let u0_dot_by_q2_part_11 = S::int(4) * u0_dot_by_q1_part_48 * s2
        + u0_dot_by_q1_part_35_scaled * c2
        + c2_scaled_4
            * (-c2_u2_sq)
                .mul_add(S::int(26923455), S::int(550987696) * u0_dot_by_q2_part_6)
        + s2_scaled_3 * u0_dot_by_q2_part_7
        + c1
            * (c1
                * (-s2 * (u0_dot_by_q1_part_38 + u0_dot_by_q2_part_8)
                    + u0_dot_by_q1_part_36 * c2 - u0_dot_by_q2_part_6 * c2_scaled_5)
                + u1_sq_scaled_2 * c2
                + s1_scaled
                    * (s2_scaled * u0_dot_by_q1_part_41
                        - S::int(8879655) * u0_dot_by_q2_part_6 * s2
                        + c2
                            * u0_dot_by_q2_part_10
                                .mul_add(S::int(435), u0_dot_by_q1_part_42_scaled)));
    // 60030*u0_dot_by_q1_part_51*(sin(q2)*cos(q2) + cos(q1)*(c2_sq*sin(q1) - s1_s2*sin(q2) -
    //   c1_s2*c2_scaled_6)) + u0_dot_by_q2_part_11; used 3 times
    let u0_dot_by_q2_part_12 = S::int(60030) * u0_dot_by_q1_part_51
        * (c1 * ((-s1_s2).mul_add(s2, c2_sq * s1) - c1_s2 * c2_scaled_6) + s2 * c2)
        + u0_dot_by_q2_part_11;
    // 569*sin(q1); used 4 times
    let s1_scaled_3 = S::int(569) * s1;
    // u0_dot_by_q1_part_58 + u0_dot_by_q1_part_54*u0_dot_by_q2_part_12; used 2 times
    let u0_dot_by_q2_part_13 = u0_dot_by_q1_part_54
        .mul_add(u0_dot_by_q2_part_12, u0_dot_by_q1_part_58);
    // 87*cos(q1); used 4 times
    let c1_scaled_3 = S::int(87) * c1;
    // s1_scaled_3*(u0_dot_by_q1_part_60 - u0_dot_by_q2_part_9 + u0_dot_by_q1_part_57*u0_dot_by_q2_part_12)
    //   + c1_scaled_3*(u0_dot_by_q2_part_13 - u0_dot_by_q1_part_8_scaled*u0_dot_by_q2_part_5); used 2 times
    let u0_dot_by_q2_part_14 = s1_scaled_3
        * u0_dot_by_q1_part_57
            .mul_add(u0_dot_by_q2_part_12, u0_dot_by_q1_part_60 - u0_dot_by_q2_part_9)
        + c1_scaled_3
            * (-u0_dot_by_q1_part_8_scaled)
                .mul_add(u0_dot_by_q2_part_5, u0_dot_by_q2_part_13);
    // u0_dot_by_q2_part_13 + u0_dot_by_q1_part_63*u0_dot_by_q2_part_14
    let u0_dot_by_q2_part_15 = u0_dot_by_q1_part_63
        .mul_add(u0_dot_by_q2_part_14, u0_dot_by_q2_part_13);
    // Elimination, step by step.
    // u0_dot_by_q2 = 20413*cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(11380*(15278788
    //   + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2) -
    //   897*u2^2*cos(q2)/2845 + sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 +
    //   87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(11380*(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))) + 6003*cos(q2)*(sin(q2)*cos(q2) + cos(q1)*(sin(q1)*cos(q2)^2 -
    //   sin(q1)*sin(q2)^2 - 2*cos(q1)*sin(q2)*cos(q2)))*(4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) +
    //   26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2)
    //   - 5960*u3^2*cos(q3) - 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(1138*(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2) + 20413*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) +
    //   137*u2^2*sin(q1)^2*cos(q2)) + sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(11380*(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(4*sin(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) +
    //   32174464*u3^2*sin(q3) + 550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + cos(q1)*(185180544*u1^2*cos(q2) + 69*sin(q1)*(87*sin(q2)*(35880*u2^2*cos(q2)
    //   - 472842 + 5960*u3^2*cos(q3) + 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*cos(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   435*cos(q2)*(7176*u2^2*sin(q2) + 20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   8879655*sin(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(cos(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   1960648237*cos(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(215387640*u2^2*sin(q2) + 735255847*sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   735255847*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(26923455*u2^2*cos(q2) + 550987696*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   550987696*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   1591254589*sin(q2)*(sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(11380*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) + cos(q1)*(569*sin(q1)*(3588*u2^2*sin(q2) +
    //   20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))) - sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 -
    //   373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2))) + 60030*sin(q2)*(sin(q2)*cos(q2) + cos(q1)*(sin(q1)*cos(q2)^2 -
    //   sin(q1)*sin(q2)^2 - 2*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 + 20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) +
    //   137*u2^2*sin(q1)^2*cos(q2)) + sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + sin(q2)*(4*sin(q2)*(228648750 +
    //   46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + cos(q1)*(185180544*u1^2*cos(q2) + 69*sin(q1)*(87*sin(q2)*(35880*u2^2*cos(q2)
    //   - 472842 + 5960*u3^2*cos(q3) + 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*cos(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   435*cos(q2)*(7176*u2^2*sin(q2) + 20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   8879655*sin(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(cos(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   1960648237*cos(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(215387640*u2^2*sin(q2) + 735255847*sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   735255847*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(26923455*u2^2*cos(q2) + 550987696*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   550987696*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   1591254589*sin(q2)*(sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) +
    //   87*cos(q1)*(3588*u2^2*cos(q2) + 20413*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2) + 60030*cos(q2)*(sin(q2)*cos(q2) + cos(q1)*(sin(q1)*cos(q2)^2 -
    //   sin(q1)*sin(q2)^2 - 2*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 + 20413*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) +
    //   137*u2^2*sin(q1)^2*cos(q2)) + sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q2)*(4*sin(q2)*(228648750 +
    //   46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + cos(q1)*(185180544*u1^2*cos(q2) + 69*sin(q1)*(87*sin(q2)*(35880*u2^2*cos(q2)
    //   - 472842 + 5960*u3^2*cos(q3) + 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*cos(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   435*cos(q2)*(7176*u2^2*sin(q2) + 20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   8879655*sin(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(cos(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   1960648237*cos(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(215387640*u2^2*sin(q2) + 735255847*sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   735255847*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(26923455*u2^2*cos(q2) + 550987696*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   550987696*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   1591254589*sin(q2)*(sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)))))/(11380*(569 - 482*cos(q1)^2))
    let u0_dot_by_q2 = S::ratio(20413, 11380) * u0_dot_by_q2_part_6
        - S::ratio(1, 11380) * u0_dot_by_q2_part_15;
    // u3_dot_by_q2 = 137*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(8*(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2) +
    //   137*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(8*(15278788
    //   + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))
    let u3_dot_by_q2 = u0_dot_by_q1_part_7_scaled * u0_dot_by_q2_part_5;
    // u2_dot_by_q2 = 435*(sin(q2)*cos(q2) + cos(q1)*(sin(q1)*cos(q2)^2 - sin(q1)*sin(q2)^2 -
    //   2*cos(q1)*sin(q2)*cos(q2)))*(4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) +
    //   32174464*u3^2*sin(q3) + 550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2)
    //   - 5960*u3^2*cos(q3) - 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(26*(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2) + (4*sin(q2)*(228648750 + 46295136*u1^2*sin(q1) +
    //   26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + cos(q1)*(185180544*u1^2*cos(q2) + 69*sin(q1)*(87*sin(q2)*(35880*u2^2*cos(q2)
    //   - 472842 + 5960*u3^2*cos(q3) + 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*cos(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   435*cos(q2)*(7176*u2^2*sin(q2) + 20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   8879655*sin(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(cos(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   1960648237*cos(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(215387640*u2^2*sin(q2) + 735255847*sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   735255847*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(26923455*u2^2*cos(q2) + 550987696*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   550987696*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   1591254589*sin(q2)*(sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(3588*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2))
    let u2_dot_by_q2 = -u0_dot_by_q1_part_50_scaled * u0_dot_by_q2_part_12;
    // u1_dot_by_q2 = 5*(569*sin(q1)*(3588*u2^2*sin(q2) +
    //   20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))) - sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 -
    //   373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2))) + 60030*sin(q2)*(sin(q2)*cos(q2) + cos(q1)*(sin(q1)*cos(q2)^2 -
    //   sin(q1)*sin(q2)^2 - 2*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 + 20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) +
    //   137*u2^2*sin(q1)^2*cos(q2)) + sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + sin(q2)*(4*sin(q2)*(228648750 +
    //   46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + cos(q1)*(185180544*u1^2*cos(q2) + 69*sin(q1)*(87*sin(q2)*(35880*u2^2*cos(q2)
    //   - 472842 + 5960*u3^2*cos(q3) + 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*cos(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   435*cos(q2)*(7176*u2^2*sin(q2) + 20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   8879655*sin(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(cos(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   1960648237*cos(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(215387640*u2^2*sin(q2) + 735255847*sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   735255847*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(26923455*u2^2*cos(q2) + 550987696*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   550987696*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   1591254589*sin(q2)*(sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) +
    //   87*cos(q1)*(3588*u2^2*cos(q2) + 20413*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q2)*(cos(q1)*(185180544*u1^2*sin(q2) + 69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 -
    //   35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2) + 60030*cos(q2)*(sin(q2)*cos(q2) + cos(q1)*(sin(q1)*cos(q2)^2 -
    //   sin(q1)*sin(q2)^2 - 2*cos(q1)*sin(q2)*cos(q2)))*(cos(q1)*(185180544*u1^2*sin(q2) +
    //   69*sin(q1)*(1560780*u2^2 + 87*cos(q2)*(472842 - 35880*u2^2*cos(q2) - 5960*u3^2*cos(q3) -
    //   102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*sin(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(sin(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   cos(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(228648750 + 46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)))^2 + 20413*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) +
    //   137*u2^2*sin(q1)^2*cos(q2)) + sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q2)*(4*sin(q2)*(228648750 +
    //   46295136*u1^2*sin(q1) + 26923455*u2^2*sin(q2) + 32174464*u3^2*sin(q3) +
    //   550987696*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   11614997*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + cos(q1)*(185180544*u1^2*cos(q2) + 69*sin(q1)*(87*sin(q2)*(35880*u2^2*cos(q2)
    //   - 472842 + 5960*u3^2*cos(q3) + 102065*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))) + 5*cos(q2)*(2651000 + 103704*u3^2*sin(q3) +
    //   1775931*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   435*cos(q2)*(7176*u2^2*sin(q2) + 20413*sin(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   20413*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   8879655*sin(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(cos(q2)*(215387640*u2^2*cos(q2) - 2838470526 - 42934648*u3^2*cos(q3) +
    //   735255847*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(914595000 + 114490408*u3^2*sin(q3) +
    //   1960648237*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   1960648237*cos(q2)*(cos(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   sin(q2)*(215387640*u2^2*sin(q2) + 735255847*sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   735255847*sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   4*cos(q2)*(26923455*u2^2*cos(q2) + 550987696*cos(q3)*(cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) +
    //   28*sin(q2)*(373409 - 326608*cos(q3)^2) + cos(q1)*(11765880*sin(q1)*cos(q2) +
    //   cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) - 5593162*cos(q2)*sin(q3)*cos(q3)))) -
    //   sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   550987696*cos(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3)))))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   1591254589*sin(q2)*(sin(q3)*(sin(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q2)*(9145024*cos(q2)*sin(q3)*cos(q3) + 28*sin(q2)*(373409 - 326608*cos(q3)^2) +
    //   cos(q1)*(11765880*sin(q1)*cos(q2) + cos(q1)*(sin(q2)*(5593162*cos(q3)^2 - 14562461) -
    //   5593162*cos(q2)*sin(q3)*cos(q3)))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   sin(q3)*(3588*cos(q3)*(87*u2^2*cos(q2) + 137*u2^2*sin(q1)^2*cos(q2)) +
    //   sin(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q2)*(87*sin(q2)*sin(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3)) + 87*cos(q2)*(1192*u3^2
    //   + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) + sin(q1)*(384192*u1^2*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)) - 69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(cos(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) - sin(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3)))))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)))))/(30848*(569 - 482*cos(q1)^2))
    let u1_dot_by_q2 = -S::ratio(5, 30848) * u0_dot_by_q1_part_56 * u0_dot_by_q2_part_14;
    // Shared terms.
    // u3_c3*u3_s3; used 2 times
    let u3_c3_u3_s3 = u3_c3 * u3_s3;
    // u3_s3^2; used 2 times
    let u3_s3_sq = u3_s3 * u3_s3;
    // s2_s3*sin(q3) + s3_c3*c2_scaled_6
    let u0_dot_by_q3_part = s3_c3.mul_add(c2_scaled_6, s2_s3 * s3);
    // c3_sq*sin(q2) - u0_dot_by_q3_part; used 2 times
    let u0_dot_by_q3_part_2 = c3_sq.mul_add(s2, -u0_dot_by_q3_part);
    // 137*c1_sq; used 2 times
    let c1_sq_scaled = S::int(137) * c1_sq;
    // u0_dot_by_q1_part_28*sin(q3) - 1192*u3_u3_c3*u0_dot_by_q2_part_3*cos(q3) +
    //   cos(q2)*(u0_dot_by_q1_part_26_scaled*cos(q3) + s2_scaled*(u0_dot_by_q2_part_2 + 2384*u3_c3_u3_s3) -
    //   207408*u3_s3_sq*cos(q2) + sin(q1)*(u0_dot_by_q2_part + sin(q1)*(u2_sq_scaled*cos(q3) +
    //   sin(q2)*(69*u0_dot_by_q1_part_16 + 653216*u3_c3_u3_s3) + cos(q2)*(u0_dot_by_q1_part_13*cos(q3) -
    //   1897500*sin(q3) - 326608*u3_s3_sq))))
    let u0_dot_by_q3_part_3 = u0_dot_by_q1_part_28 * s3
        - S::int(1192) * u3_u3_c3 * u0_dot_by_q2_part_3 * c3
        + c2
            * (s2_scaled * u3_c3_u3_s3.mul_add(S::int(2384), u0_dot_by_q2_part_2)
                + u0_dot_by_q1_part_26_scaled * c3 - S::int(207408) * u3_s3_sq * c2
                + s1
                    * (u0_dot_by_q2_part
                        + s1
                            * (s2
                                * u3_c3_u3_s3
                                    .mul_add(S::int(653216), S::int(69) * u0_dot_by_q1_part_16)
                                + u2_sq_scaled * c3
                                + c2
                                    * ((-s3).mul_add(S::int(1897500), u0_dot_by_q1_part_13 * c3)
                                        - S::int(326608) * u3_s3_sq))));
    // 40826*u0_dot_by_q1_part_30*(cos(q2)*(224*u0_dot_by_q3_part_2 - u0_dot_by_q3_part_2*c1_sq_scaled) +
    //   s3_c3*(224 - c1_sq_scaled)) + u0_dot_by_q3_part_3; used 2 times
    let u0_dot_by_q3_part_4 = S::int(40826) * u0_dot_by_q1_part_30
        * (c2
            * (-u0_dot_by_q3_part_2)
                .mul_add(c1_sq_scaled, S::int(224) * u0_dot_by_q3_part_2)
            + s3_c3 * (S::int(224) - c1_sq_scaled)) + u0_dot_by_q3_part_3;
    // 137*u0_dot_by_q3_part_4; used 2 times
    let u0_dot_by_q3_part_4_scaled = S::int(137) * u0_dot_by_q3_part_4;
    // u0_dot_by_q1_part_37 + u0_dot_by_q1_part_34*u0_dot_by_q3_part_4_scaled; used 4 times
    let u0_dot_by_q3_part_5 = u0_dot_by_q1_part_34
        .mul_add(u0_dot_by_q3_part_4_scaled, u0_dot_by_q1_part_37);
    // u0_dot_by_q1_part_35 + u0_dot_by_q1_part_8*u0_dot_by_q3_part_4_scaled; used 4 times
    let u0_dot_by_q3_part_6 = u0_dot_by_q1_part_8
        .mul_add(u0_dot_by_q3_part_4_scaled, u0_dot_by_q1_part_35);
    // 30015*sin(q1); used 3 times
    let s1_scaled_4 = S::int(30015) * s1;
    // 77953*sin(q2); used 2 times
    let s2_scaled_4 = S::int(77953) * s2;
    // 107968*cos(q2); used 2 times
    let c2_scaled_7 = S::int(107968) * c2;
    // u0_dot_by_q3_part_5*s2_scaled_4 - cos(q1)*(cos(q1)*(s2_scaled_2*u0_dot_by_q3_part_5 +
    //   c2_scaled_2*u0_dot_by_q3_part_6) + s1_scaled_4*(u0_dot_by_q3_part_5*cos(q2) +
    //   u0_dot_by_q3_part_6*sin(q2))) + u0_dot_by_q3_part_6*c2_scaled_7; used 3 times
    let u0_dot_by_q3_part_7 = -c1
        * (c1
            * c2_scaled_2.mul_add(u0_dot_by_q3_part_6, s2_scaled_2 * u0_dot_by_q3_part_5)
            + s1_scaled_4 * u0_dot_by_q3_part_6.mul_add(s2, u0_dot_by_q3_part_5 * c2))
        + u0_dot_by_q3_part_5 * s2_scaled_4 + u0_dot_by_q3_part_6 * c2_scaled_7;
    // u0_dot_by_q3_part_6 - u0_dot_by_q1_part_54*u0_dot_by_q3_part_7; used 2 times
    let u0_dot_by_q3_part_8 = (-u0_dot_by_q1_part_54)
        .mul_add(u0_dot_by_q3_part_7, u0_dot_by_q3_part_6);
    // s1_scaled_3*(u0_dot_by_q3_part_5 - u0_dot_by_q1_part_57*u0_dot_by_q3_part_7) +
    //   c1_scaled_3*u0_dot_by_q3_part_8; used 2 times
    let u0_dot_by_q3_part_9 = s1_scaled_3
        * (-u0_dot_by_q1_part_57).mul_add(u0_dot_by_q3_part_7, u0_dot_by_q3_part_5)
        + c1_scaled_3 * u0_dot_by_q3_part_8;
    // u0_dot_by_q3_part_8 + u0_dot_by_q1_part_63*u0_dot_by_q3_part_9
    let u0_dot_by_q3_part_10 = u0_dot_by_q1_part_63
        .mul_add(u0_dot_by_q3_part_9, u0_dot_by_q3_part_8);
    // Elimination, step by step.
    // u0_dot_by_q3 = 20413*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(11380*(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   298*u3^2*cos(q3)/2845 + 416690569*cos(q3)*(137*cos(q1)^2*sin(q3)*cos(q3) - 224*sin(q3)*cos(q3) -
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(5690*(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2) +
    //   20413*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(11380*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   149*cos(q2)*(77953*sin(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   107968*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(30015*sin(q1)*(cos(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(36019*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(11380*(77953
    //   + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) +
    //   149*cos(q1)*(569*sin(q1)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(77953*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   107968*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(30015*sin(q1)*(cos(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(36019*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2))
    //   - 77953 - 30015*cos(q2)^2)) + 87*cos(q1)*(8*u3^2*cos(q3) +
    //   137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(77953*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   107968*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(30015*sin(q1)*(cos(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(36019*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2))
    //   - 77953 - 30015*cos(q2)^2)))/(11380*(569 - 482*cos(q1)^2))
    let u0_dot_by_q3 = -S::ratio(149, 11380) * u0_dot_by_q3_part_10;
    // u3_dot_by_q3 = 2796581*(137*cos(q1)^2*sin(q3)*cos(q3) - 224*sin(q3)*cos(q3) -
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(4*(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2) +
    //   137*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) + cos(q2)*(87*cos(q3)*(3588*u2^2 +
    //   cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) - 207408*u3^2*cos(q2)*sin(q3)^2 +
    //   sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) + cos(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) + sin(q1)*(491556*u2^2*cos(q3) +
    //   sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) + 653216*u3^2*sin(q3)*cos(q3)) +
    //   cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) - 326608*u3^2*sin(q3)^2))) +
    //   87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(8*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))
    let u3_dot_by_q3 = -u0_dot_by_q1_part_7_scaled * u0_dot_by_q3_part_4;
    // u2_dot_by_q3 = 149*(77953*sin(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   107968*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(30015*sin(q1)*(cos(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(36019*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(3588*(77953
    //   + 30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2))))
    let u2_dot_by_q3 = S::ratio(149, 3588) * u0_dot_by_q1_part_50 * u0_dot_by_q3_part_7;
    // u1_dot_by_q3 = 745*(569*sin(q1)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(77953*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   107968*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(30015*sin(q1)*(cos(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(36019*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2))
    //   - 77953 - 30015*cos(q2)^2)) + 87*cos(q1)*(8*u3^2*cos(q3) +
    //   137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(77953*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   107968*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) -
    //   cos(q1)*(30015*sin(q1)*(cos(q2)*(8*u3^2*sin(q3) +
    //   137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   sin(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(36019*sin(q2)*(8*u3^2*sin(q3) + 137*cos(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3)
    //   + cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   5593162*sin(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*sin(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   96049*cos(q2)*(8*u3^2*cos(q3) + 137*sin(q3)*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) - 69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) +
    //   27500*cos(q3))) + sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) +
    //   163304*u3^2*(1 - 2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 +
    //   326608*u3^2*cos(q3))))) + 87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) -
    //   2384*u3^2*cos(q3))) + 87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 +
    //   2384*u3^2*cos(q3)))) - cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) +
    //   40826*u3^2*sin(q3)))))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2)
    //   - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) + 5593162*cos(q3)*(224*sin(q3)*cos(q3) - 137*cos(q1)^2*sin(q3)*cos(q3) +
    //   cos(q2)*(224*sin(q2)*cos(q3)^2 - 224*sin(q2)*sin(q3)^2 - 448*cos(q2)*sin(q3)*cos(q3) -
    //   137*cos(q1)^2*(sin(q2)*cos(q3)^2 - sin(q2)*sin(q3)^2 -
    //   2*cos(q2)*sin(q3)*cos(q3))))*(cos(q2)*(sin(q1)*(384192*u1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   69*cos(q1)*(cos(q2)*(85347*cos(q3) - 27500*sin(q3)) + sin(q2)*(85347*sin(q3) + 27500*cos(q3))) +
    //   sin(q1)*(491556*u2^2*sin(q3) + sin(q2)*(1897500*sin(q3) - 5888943*cos(q3) + 163304*u3^2*(1 -
    //   2*cos(q3)^2)) + cos(q2)*(1897500*cos(q3) + sin(q3)*(5888943 + 326608*u3^2*cos(q3))))) +
    //   87*sin(q2)*(1192*u3^2 + cos(q3)*(67689 - 4416*u1^2*cos(q1) - 2384*u3^2*cos(q3))) +
    //   87*sin(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3)))) -
    //   cos(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 - 5888943*cos(q1) +
    //   4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))^2 +
    //   137*cos(q3)*(sin(q3)*(312156*u2^2*sin(q2) + 103704*u3^2*sin(q3) + sin(q1)*(384192*u1^2 -
    //   5888943*cos(q1) + 4*sin(q1)*(474375 + 122889*u2^2*sin(q2) + 40826*u3^2*sin(q3)))) +
    //   cos(q2)*(87*cos(q3)*(3588*u2^2 + cos(q2)*(4416*u1^2*cos(q1) - 67689 + 2384*u3^2*cos(q3))) -
    //   207408*u3^2*cos(q2)*sin(q3)^2 + sin(q1)*(69*cos(q1)*(sin(q2)*(27500*sin(q3) - 85347*cos(q3)) +
    //   cos(q2)*(85347*sin(q3) + 27500*cos(q3))) + 384192*u1^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   sin(q1)*(491556*u2^2*cos(q3) + sin(q2)*(5888943*sin(q3) + 1897500*cos(q3) +
    //   653216*u3^2*sin(q3)*cos(q3)) + cos(q2)*(cos(q3)*(5888943 + 326608*u3^2*cos(q3)) - 1897500*sin(q3) -
    //   326608*u3^2*sin(q3)^2))) + 87*sin(q2)*(2384*u3^2*sin(q3)*cos(q3) + sin(q3)*(4416*u1^2*cos(q1) -
    //   67689 + 2384*u3^2*cos(q3)))) - 1192*cos(q3)*(87*u3^2*cos(q3) +
    //   137*u3^2*sin(q1)^2*cos(q3)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2))
    //   - 77953 - 30015*cos(q2)^2)))/(30848*(569 - 482*cos(q1)^2))
    let u1_dot_by_q3 = -S::ratio(745, 30848) * u0_dot_by_q1_part_56
        * u0_dot_by_q3_part_9;
    // Shared terms.
    // u1*sin(q1); used 4 times
    let u1_s1 = u1 * s1;
    // u1*cos(q1); used 2 times
    let u1_c1 = u1 * c1;
    // cos(q2)*(s2_s3_plus_c2_c3*u1_s1 + u0_dot_by_q1_part_19*u1_c1) - u1_s1*cos(q3); used 3 times
    let u0_dot_by_u1_part = c2
        * u0_dot_by_q1_part_19.mul_add(u1_c1, s2_s3_plus_c2_c3 * u1_s1) - u1_s1 * c3;
    // u0_dot_by_q1_part_8*u0_dot_by_u1_part; used 4 times
    let u0_dot_by_u1_part_2 = u0_dot_by_q1_part_8 * u0_dot_by_u1_part;
    // u0_dot_by_q1_part_34*u0_dot_by_u1_part; used 4 times
    let u0_dot_by_u1_part_3 = u0_dot_by_q1_part_34 * u0_dot_by_u1_part;
    // 482*cos(q2)*(u1_s1 + 4572512*u0_dot_by_u1_part_2) + s2_scaled_3*u0_dot_by_u1_part_3 -
    //   cos(q1)*(482*u1*sin(q2) + s1_scaled_2*(u0_dot_by_u1_part_2*sin(q2) + u0_dot_by_u1_part_3*cos(q2)) +
    //   c1_scaled_2*(c2_scaled_2*u0_dot_by_u1_part_2 + s2_scaled_2*u0_dot_by_u1_part_3)); used 3 times
    let u0_dot_by_u1_part_4 = S::int(482) * c2
        * u0_dot_by_u1_part_2.mul_add(S::int(4572512), u1_s1)
        + s2_scaled_3 * u0_dot_by_u1_part_3
        - c1
            * (s1_scaled_2 * u0_dot_by_u1_part_3.mul_add(c2, u0_dot_by_u1_part_2 * s2)
                + S::int(482) * u1 * s2
                + c1_scaled_2
                    * s2_scaled_2
                        .mul_add(
                            u0_dot_by_u1_part_3,
                            c2_scaled_2 * u0_dot_by_u1_part_2,
                        ));
    // u0_dot_by_q1_part_54*u0_dot_by_u1_part_4; used 2 times
    let u0_dot_by_u1_part_5 = u0_dot_by_q1_part_54 * u0_dot_by_u1_part_4;
    // sin(q1)*(232324*u1_c1 - 348624134955*u0_dot_by_u1_part_3 +
    //   17078535*u0_dot_by_q1_part_57*u0_dot_by_u1_part_4) + 2611305*cos(q1)*(u0_dot_by_u1_part_5 -
    //   u0_dot_by_q1_part_8_scaled*u0_dot_by_u1_part); used 2 times
    let u0_dot_by_u1_part_6 = s1
        * ((-u0_dot_by_u1_part_3).mul_add(S::int(348624134955), S::int(232324) * u1_c1)
            + S::int(17078535) * u0_dot_by_q1_part_57 * u0_dot_by_u1_part_4)
        + S::int(2611305) * c1
            * (-u0_dot_by_q1_part_8_scaled)
                .mul_add(u0_dot_by_u1_part, u0_dot_by_u1_part_5);
    // Elimination, step by step.
    // u0_dot_by_u1 = 3921255648*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(2845*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 15424*u1*sin(q1)/14225 +
    //   192096*cos(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q1)*(482*u1*sin(q2) +
    //   612696195*sin(q1)*(cos(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   20413*cos(q1)*(36019*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   96049*cos(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   482*cos(q2)*(u1*sin(q1) + 4572512*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(2845*(77953 + 30015*cos(q2)^2 -
    //   cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) +
    //   32*cos(q1)*(sin(q1)*(232324*u1*cos(q1) + 348624134955*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) +
    //   17078535*sin(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q1)*(482*u1*sin(q2) +
    //   612696195*sin(q1)*(cos(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   20413*cos(q1)*(36019*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   96049*cos(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   482*cos(q2)*(u1*sin(q1) + 4572512*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 -
    //   cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) -
    //   2611305*cos(q1)*(20413*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q1)*(482*u1*sin(q2) +
    //   612696195*sin(q1)*(cos(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   20413*cos(q1)*(36019*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   96049*cos(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   482*cos(q2)*(u1*sin(q1) + 4572512*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019
    //   + 60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)))/(14225*(482*cos(q1)^2 - 569))
    let u0_dot_by_u1 = S::ratio(192096, 2845) * u0_dot_by_u1_part_5
        - S::ratio(15424, 14225) * u1_s1
        - S::ratio(3921255648, 2845) * u0_dot_by_u1_part_2
        + S::ratio(32, 14225) * u0_dot_by_q1_part_63 * u0_dot_by_u1_part_6;
    // u3_dot_by_u1 = 13158576*u1*(sin(q1)*cos(q3) + cos(q2)*(cos(q1)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) -
    //   sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))
    let u3_dot_by_u1 = S::int(13158576) * u1 * u0_dot_by_q1_part_7
        * (c2 * (-s2_s3_plus_c2_c3).mul_add(s1, u0_dot_by_q1_part_19_scaled * c1)
            + s1 * c3);
    // u2_dot_by_u1 = 2784*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q1)*(482*u1*sin(q2) +
    //   612696195*sin(q1)*(cos(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   20413*cos(q1)*(36019*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   96049*cos(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   482*cos(q2)*(u1*sin(q1) + 4572512*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(13*(77953 + 30015*cos(q2)^2 -
    //   cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2))))
    let u2_dot_by_u1 = S::ratio(2784, 13) * u0_dot_by_q1_part_50 * u0_dot_by_u1_part_4;
    // u1_dot_by_u1 = (sin(q1)*(232324*u1*cos(q1) +
    //   348624134955*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2)) +
    //   17078535*sin(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q1)*(482*u1*sin(q2) +
    //   612696195*sin(q1)*(cos(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   20413*cos(q1)*(36019*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   96049*cos(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   482*cos(q2)*(u1*sin(q1) + 4572512*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 + 30015*cos(q2)^2 -
    //   cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))) -
    //   2611305*cos(q1)*(20413*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q1)*(482*u1*sin(q2) +
    //   612696195*sin(q1)*(cos(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3)
    //   + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) +
    //   20413*cos(q1)*(36019*sin(q2)*sin(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   96049*cos(q2)*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) - u1*cos(q1)*sin(q2)*cos(q3) +
    //   u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) - u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2
    //   - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   482*cos(q2)*(u1*sin(q1) + 4572512*cos(q3)*(cos(q2)*(u1*cos(q1)*cos(q2)*sin(q3) -
    //   u1*cos(q1)*sin(q2)*cos(q3) + u1*sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) -
    //   u1*sin(q1)*cos(q3))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019
    //   + 60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)))/(241*(482*cos(q1)^2 - 569))
    let u1_dot_by_u1 = S::ratio(1, 241) * u0_dot_by_q1_part_56 * u0_dot_by_u1_part_6;
    // Shared terms.
    // u2*sin(q2); used 3 times
    let u2_s2 = u2 * s2;
    // u2*u0_dot_by_q2_part_3*cos(q2)*sin(q3) - u0_dot_by_q2_part_3*u2_s2*cos(q3); used 4 times
    let u0_dot_by_u2_part = (-(u0_dot_by_q2_part_3 * u2_s2))
        .mul_add(c3, u2 * u0_dot_by_q2_part_3 * c2 * s3);
    // u0_dot_by_q1_part_8*u0_dot_by_u2_part; used 3 times
    let u0_dot_by_u2_part_2 = u0_dot_by_q1_part_8 * u0_dot_by_u2_part;
    // u0_dot_by_q1_part_34*u0_dot_by_u2_part; used 2 times
    let u0_dot_by_u2_part_3 = u0_dot_by_q1_part_34 * u0_dot_by_u2_part;
    // u0_dot_by_q1_part_34_scaled*u0_dot_by_u2_part; used 2 times
    let u0_dot_by_u2_part_4 = u0_dot_by_q1_part_34_scaled * u0_dot_by_u2_part;
    // u0_dot_by_q1_part_8_scaled*u0_dot_by_u2_part; used 2 times
    let u0_dot_by_u2_part_5 = u0_dot_by_q1_part_8_scaled * u0_dot_by_u2_part;
    // cos(q1)*(cos(q1)*(c2_scaled_5*u0_dot_by_u2_part_2 + sin(q2)*(u2*c2_scaled_3 +
    //   735255847*u0_dot_by_u2_part_3)) + s1_scaled_4*(u2 + cos(q2)*(u0_dot_by_u2_part_4 - u2*c2_scaled_6) +
    //   u0_dot_by_u2_part_5*sin(q2))) - cos(q2)*(30015*u2_s2 + 2203950784*u0_dot_by_u2_part_2) -
    //   s2_scaled_3*u0_dot_by_u2_part_3; used 3 times
    let u0_dot_by_u2_part_6 = c1
        * (c1
            * (s2 * u0_dot_by_u2_part_3.mul_add(S::int(735255847), u2 * c2_scaled_3)
                + c2_scaled_5 * u0_dot_by_u2_part_2)
            + s1_scaled_4
                * (u2 + c2 * (-u2).mul_add(c2_scaled_6, u0_dot_by_u2_part_4)
                    + u0_dot_by_u2_part_5 * s2))
        - c2 * u0_dot_by_u2_part_2.mul_add(S::int(2203950784), S::int(30015) * u2_s2)
        - s2_scaled_3 * u0_dot_by_u2_part_3;
    // u2_s2 + u0_dot_by_q1_part_54*u0_dot_by_u2_part_6; used 2 times
    let u0_dot_by_u2_part_7 = u0_dot_by_q1_part_54.mul_add(u0_dot_by_u2_part_6, u2_s2);
    // s1_scaled_3*(u2*cos(q2) - u0_dot_by_u2_part_4 - u0_dot_by_q1_part_57*u0_dot_by_u2_part_6) -
    //   c1_scaled_3*(u0_dot_by_u2_part_5 + u0_dot_by_u2_part_7); used 2 times
    let u0_dot_by_u2_part_8 = s1_scaled_3
        * (u2.mul_add(c2, -u0_dot_by_u2_part_4)
            - u0_dot_by_q1_part_57 * u0_dot_by_u2_part_6)
        - c1_scaled_3 * (u0_dot_by_u2_part_5 + u0_dot_by_u2_part_7);
    // u0_dot_by_q1_part_63*u0_dot_by_u2_part_8 - u0_dot_by_u2_part_7
    let u0_dot_by_u2_part_9 = u0_dot_by_q1_part_63
        .mul_add(u0_dot_by_u2_part_8, -u0_dot_by_u2_part_7);
    // Elimination, step by step.
    // u0_dot_by_u2 = 36620922*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(2845*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 1794*u2*sin(q2)/2845 +
    //   1794*cos(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q1)*(30015*sin(q1)*(u2 +
    //   20413*sin(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q2)*(2*u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(1960648237*cos(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(60030*u2*cos(q2) + 735255847*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   cos(q2)*(30015*u2*sin(q2) + 2203950784*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(2845*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) + 1794*cos(q1)*(569*sin(q1)*(u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q1)*(30015*sin(q1)*(u2 +
    //   20413*sin(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q2)*(2*u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(1960648237*cos(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(60030*u2*cos(q2) + 735255847*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   cos(q2)*(30015*u2*sin(q2) + 2203950784*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 87*cos(q1)*(u2*sin(q2) + 20413*cos(q3)*(cos(q2)*(87*u2*sin(q3) +
    //   137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q1)*(30015*sin(q1)*(u2 +
    //   20413*sin(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q2)*(2*u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(1960648237*cos(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(60030*u2*cos(q2) + 735255847*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   cos(q2)*(30015*u2*sin(q2) + 2203950784*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)))))/(2845*(482*cos(q1)^2 - 569))
    let u0_dot_by_u2 = S::ratio(1794, 2845) * u0_dot_by_u2_part_9
        - S::ratio(36620922, 2845) * u0_dot_by_u2_part_2;
    // u3_dot_by_u2 = 122889*u2*(87*sin(q2)*cos(q3) - 87*cos(q2)*sin(q3) + 137*sin(q1)^2*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))
    let u3_dot_by_u2 = S::int(122889) * u2 * u0_dot_by_q1_part_7
        * (-u0_dot_by_q1_part_19)
            .mul_add(S::int(87), u0_dot_by_q1_part_19_scaled * s1_sq_scaled);
    // u2_dot_by_u2 = 2*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q1)*(30015*sin(q1)*(u2 +
    //   20413*sin(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q2)*(2*u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(1960648237*cos(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(60030*u2*cos(q2) + 735255847*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   cos(q2)*(30015*u2*sin(q2) + 2203950784*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)
    let u2_dot_by_u2 = -S::int(2) * u0_dot_by_q1_part_50 * u0_dot_by_u2_part_6;
    // u1_dot_by_u2 = 4485*(569*sin(q1)*(u2*cos(q2) + 20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) +
    //   137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q1)*(30015*sin(q1)*(u2 +
    //   20413*sin(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q2)*(2*u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(1960648237*cos(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(60030*u2*cos(q2) + 735255847*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   cos(q2)*(30015*u2*sin(q2) + 2203950784*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)) -
    //   77953 - 30015*cos(q2)^2)) - 87*cos(q1)*(u2*sin(q2) + 20413*cos(q3)*(cos(q2)*(87*u2*sin(q3) +
    //   137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 +
    //   4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   cos(q2)*(1591254589*sin(q2)*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q1)*(30015*sin(q1)*(u2 +
    //   20413*sin(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) - cos(q2)*(2*u2*cos(q2) +
    //   20413*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) - cos(q3)*(87*u2*sin(q2) +
    //   137*u2*sin(q1)^2*sin(q2)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) +
    //   cos(q1)*(1960648237*cos(q2)*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) +
    //   sin(q2)*(60030*u2*cos(q2) + 735255847*sin(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))) -
    //   cos(q2)*(30015*u2*sin(q2) + 2203950784*cos(q3)*(cos(q2)*(87*u2*sin(q3) + 137*u2*sin(q1)^2*sin(q3)) -
    //   cos(q3)*(87*u2*sin(q2) + 137*u2*sin(q1)^2*sin(q2)))/(15278788 + 4572512*cos(q3)^2 -
    //   cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))/(77953 +
    //   30015*cos(q2)^2 - cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 +
    //   60030*cos(q2)^2)))))/(3856*(482*cos(q1)^2 - 569))
    let u1_dot_by_u2 = S::ratio(4485, 3856) * u0_dot_by_q1_part_56 * u0_dot_by_u2_part_8;
    // Shared terms.
    // cos(q2)*(174*c2_c3*u3_s3 + u3*u0_dot_by_q1_part_10*s2_scaled +
    //   s1_sq_scaled*(u3_s3*c2_scaled_6*cos(q3) - u0_dot_by_q1_part_11*sin(q2))) -
    //   u3_s3*u0_dot_by_q2_part_3*cos(q3); used 3 times
    let u0_dot_by_u3_part = c2
        * (S::int(174) * c2_c3 * u3_s3 + u3 * u0_dot_by_q1_part_10 * s2_scaled
            + s1_sq_scaled
                * (-u0_dot_by_q1_part_11).mul_add(s2, u3_s3 * c2_scaled_6 * c3))
        - u3_s3 * u0_dot_by_q2_part_3 * c3;
    // u0_dot_by_q1_part_34_scaled*u0_dot_by_u3_part - u3_c3; used 2 times
    let u0_dot_by_u3_part_2 = u0_dot_by_q1_part_34_scaled
        .mul_add(u0_dot_by_u3_part, -u3_c3);
    // -u0_dot_by_u3_part_2; used 3 times
    let u0_dot_by_u3_part_2_scaled = -u0_dot_by_u3_part_2;
    // u0_dot_by_q1_part_8_scaled*u0_dot_by_u3_part; used 2 times
    let u0_dot_by_u3_part_3 = u0_dot_by_q1_part_8_scaled * u0_dot_by_u3_part;
    // u3_s3 + u0_dot_by_u3_part_3; used 3 times
    let u0_dot_by_u3_part_4 = u3_s3 + u0_dot_by_u3_part_3;
    // s2_scaled_4*u0_dot_by_u3_part_2_scaled - c2_scaled_7*u0_dot_by_u3_part_4 -
    //   cos(q1)*(cos(q1)*(s2_scaled_2*u0_dot_by_u3_part_2_scaled - c2_scaled_2*u0_dot_by_u3_part_4) +
    //   s1_scaled_4*(u0_dot_by_u3_part_2_scaled*cos(q2) - u0_dot_by_u3_part_4*sin(q2))); used 3 times
    let u0_dot_by_u3_part_5 = s2_scaled_4 * u0_dot_by_u3_part_2_scaled
        - c2_scaled_7 * u0_dot_by_u3_part_4
        - c1
            * (c1
                * (-c2_scaled_2)
                    .mul_add(
                        u0_dot_by_u3_part_4,
                        s2_scaled_2 * u0_dot_by_u3_part_2_scaled,
                    )
                + s1_scaled_4
                    * (-u0_dot_by_u3_part_4)
                        .mul_add(s2, u0_dot_by_u3_part_2_scaled * c2));
    // u3_s3 + u0_dot_by_q1_part_54*u0_dot_by_u3_part_5; used 2 times
    let u0_dot_by_u3_part_6 = u0_dot_by_q1_part_54.mul_add(u0_dot_by_u3_part_5, u3_s3);
    // -s1_scaled_3*(u0_dot_by_u3_part_2 + u0_dot_by_q1_part_57*u0_dot_by_u3_part_5) -
    //   c1_scaled_3*(u0_dot_by_u3_part_3 + u0_dot_by_u3_part_6); used 2 times
    let u0_dot_by_u3_part_7 = -s1_scaled_3
        * u0_dot_by_q1_part_57.mul_add(u0_dot_by_u3_part_5, u0_dot_by_u3_part_2)
        - c1_scaled_3 * (u0_dot_by_u3_part_3 + u0_dot_by_u3_part_6);
    // u0_dot_by_q1_part_63*u0_dot_by_u3_part_7 - u0_dot_by_u3_part_6
    let u0_dot_by_u3_part_8 = u0_dot_by_q1_part_63
        .mul_add(u0_dot_by_u3_part_7, -u0_dot_by_u3_part_6);
    // Elimination, step by step.
    // u0_dot_by_u3 = 12166148*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) +
    //   137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3) - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 -
    //   2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(2845*(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 596*u3*sin(q3)/2845 +
    //   596*cos(q2)*(77953*sin(q2)*(u3*cos(q3) + 20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) +
    //   137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3) - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 -
    //   2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 107968*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - cos(q1)*(30015*sin(q1)*(cos(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) + cos(q1)*(36019*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 96049*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(2845*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) +
    //   596*cos(q1)*(569*sin(q1)*(u3*cos(q3) + 20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) +
    //   137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3) - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 -
    //   2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + sin(q2)*(77953*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 107968*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - cos(q1)*(30015*sin(q1)*(cos(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) + cos(q1)*(36019*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 96049*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) - 87*cos(q1)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q2)*(77953*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 107968*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - cos(q1)*(30015*sin(q1)*(cos(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) + cos(q1)*(36019*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 96049*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(77953 + 30015*cos(q2)^2 -
    //   cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))))/(2845*(482*cos(q1)^2
    //   - 569))
    let u0_dot_by_u3 = S::ratio(596, 2845) * u0_dot_by_u3_part_8
        - S::ratio(12166148, 2845) * u0_dot_by_q1_part_8 * u0_dot_by_u3_part;
    // Shared terms.
    // s3_c3*u0_dot_by_q2_part_3; used 2 times
    let u3_dot_by_u3_part = s3_c3 * u0_dot_by_q2_part_3;
    // Elimination, step by step.
    // u3_dot_by_u3 = 40826*u3*(cos(q2)*(2*cos(q2)*sin(q3)*cos(q3)*(87 + 137*sin(q1)^2) + sin(q2)*(87 -
    //   174*cos(q3)^2 - 137*sin(q1)^2*(2*cos(q3)^2 - 1))) - sin(q3)*cos(q3)*(87 +
    //   137*sin(q1)^2))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) + cos(q1)*(11765880*sin(q1)*sin(q2) -
    //   cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) + cos(q2)*(5593162*cos(q3)^2 - 14562461))) +
    //   28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 - 4572512*cos(q3)^2 + cos(q1)^2*(7059724 +
    //   2796581*cos(q3)^2))
    let u3_dot_by_u3 = S::int(40826) * u3 * u0_dot_by_q1_part_7
        * (u3_dot_by_u3_part
            - c2
                * (s2
                    * (-u0_dot_by_q1_part_10_scaled)
                        .mul_add(s1_sq_scaled, S::int(87) * u0_dot_by_q1_part_10)
                    + c2_scaled_6 * u3_dot_by_u3_part));
    // u2_dot_by_u3 = 596*(77953*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 107968*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - cos(q1)*(30015*sin(q1)*(cos(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) + cos(q1)*(36019*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 96049*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(897*(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2))
    let u2_dot_by_u3 = -S::ratio(596, 897) * u0_dot_by_q1_part_50 * u0_dot_by_u3_part_5;
    // u1_dot_by_u3 = 745*(569*sin(q1)*(u3*cos(q3) + 20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3)
    //   + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3) - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 -
    //   2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + sin(q2)*(77953*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 107968*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - cos(q1)*(30015*sin(q1)*(cos(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) + cos(q1)*(36019*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 96049*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) +
    //   cos(q1)*(36019 + 60030*cos(q2)^2)) - 77953 - 30015*cos(q2)^2)) - 87*cos(q1)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)) + cos(q2)*(77953*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 107968*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - cos(q1)*(30015*sin(q1)*(cos(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - sin(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2)))) + cos(q1)*(36019*sin(q2)*(u3*cos(q3) +
    //   20413*sin(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) - 15278788 -
    //   4572512*cos(q3)^2 + cos(q1)^2*(7059724 + 2796581*cos(q3)^2))) - 96049*cos(q2)*(u3*sin(q3) +
    //   20413*cos(q3)*(cos(q2)*(174*u3*cos(q2)*sin(q3)*cos(q3) + 137*sin(q1)^2*(2*u3*cos(q2)*sin(q3)*cos(q3)
    //   - u3*sin(q2)*(2*cos(q3)^2 - 1)) + 87*sin(q2)*(u3 - 2*u3*cos(q3)^2)) - cos(q3)*(87*u3*sin(q3) +
    //   137*u3*sin(q1)^2*sin(q3)))/(15278788 + 4572512*cos(q3)^2 - cos(q2)*(9145024*sin(q2)*sin(q3)*cos(q3)
    //   + cos(q1)*(11765880*sin(q1)*sin(q2) - cos(q1)*(5593162*sin(q2)*sin(q3)*cos(q3) +
    //   cos(q2)*(5593162*cos(q3)^2 - 14562461))) + 28*cos(q2)*(326608*cos(q3)^2 - 373409)) -
    //   cos(q1)^2*(7059724 + 2796581*cos(q3)^2))))))/(77953 + 30015*cos(q2)^2 -
    //   cos(q1)*(60030*sin(q1)*sin(q2)*cos(q2) + cos(q1)*(36019 + 60030*cos(q2)^2)))))/(1928*(482*cos(q1)^2
    //   - 569))
    let u1_dot_by_u3 = S::ratio(745, 1928) * u0_dot_by_q1_part_56 * u0_dot_by_u3_part_7;
    // Entries that are not zero.
    // d(q1')/d(u1) = 1
    let q1_dot_by_u1_value = S::int(1);
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(q0')/d(u0) = 1
    let q0_dot_by_u0_value = S::int(1);
    [
        [zero, zero, zero, zero, q1_dot_by_u1_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, q2_dot_by_u2_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, q3_dot_by_u3_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, q0_dot_by_u0_value],
        [
            u1_dot_by_q1,
            u1_dot_by_q2,
            u1_dot_by_q3,
            zero,
            u1_dot_by_u1,
            u1_dot_by_u2,
            u1_dot_by_u3,
            zero,
        ],
        [
            u2_dot_by_q1,
            u2_dot_by_q2,
            u2_dot_by_q3,
            zero,
            u2_dot_by_u1,
            u2_dot_by_u2,
            u2_dot_by_u3,
            zero,
        ],
        [
            u3_dot_by_q1,
            u3_dot_by_q2,
            u3_dot_by_q3,
            zero,
            u3_dot_by_u1,
            u3_dot_by_u2,
            u3_dot_by_u3,
            zero,
        ],
        [
            u0_dot_by_q1,
            u0_dot_by_q2,
            u0_dot_by_q3,
            zero,
            u0_dot_by_u1,
            u0_dot_by_u2,
            u0_dot_by_u3,
            zero,
        ],
    ]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    u: &[S; 4],
) -> [S; 4] {
    let [u1, u2, u3, u0] = *u;
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    // q0' = u0
    let q0_dot_value = u0;
    [q1_dot_value, q2_dot_value, q3_dot_value, q0_dot_value]
}

/// Kinetic energy T.
///
/// 41 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> S {
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, u0] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3);
    // Values.
    // T = 149*u3^2/1250 + u0*(14225*u0 - 15424*u1*cos(q1) - 8970*u2*cos(q2) - 2980*u3*cos(q3))/5000 +
    //   4*u1*(3856*u1 + 4485*u2*cos(q1 - q2) + 1490*u3*cos(q1 - q3))/15625 + 13*u2*(897*u2 + 596*u3*cos(q2 -
    //   q3))/25000
    let energy = S::ratio(149, 1250) * u3 * u3
        + S::ratio(1, 5000) * u0
            * ((-(u1 * c1)).mul_add(S::int(15424), S::int(14225) * u0)
                - S::int(8970) * u2 * c2 - S::int(2980) * u3 * c3)
        + S::ratio(4, 15625) * u1
            * ((u2 * cos_q1_minus_q2).mul_add(S::int(4485), S::int(3856) * u1)
                + S::int(1490) * u3 * cos_q1_minus_q3)
        + S::ratio(13, 25000) * u2
            * (u3 * cos_q2_minus_q3).mul_add(S::int(596), S::int(897) * u2);
    energy
}

/// Potential energy V of gravity.
///
/// 7 operations, 3 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, q: &[S; 4]) -> S {
    let [q1, q2, q3, q0] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Values.
    // V = 472842*cos(q1)/15625 - 11*q0/4 + 879957*cos(q2)/50000 + 146169*cos(q3)/25000
    let energy = S::ratio(472842, 15625) * c1 - S::ratio(11, 4) * q0
        + S::ratio(879957, 50000) * c2 + S::ratio(146169, 25000) * c3;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 4], u: &[S; 4]) -> [S; 8] {
    let [q1, q2, q3, q0] = *q;
    let [u1, u2, u3, u0] = *u;
    // Values.
    // q0 = q0
    let q0_value = q0;
    // q1 = q1
    let q1_value = q1;
    // q2 = q2
    let q2_value = q2;
    // q3 = q3
    let q3_value = q3;
    // u0 = u0
    let u0_value = u0;
    // u1 = u1
    let u1_value = u1;
    // u2 = u2
    let u2_value = u2;
    // u3 = u3
    let u3_value = u3;
    [q0_value, q1_value, q2_value, q3_value, u0_value, u1_value, u2_value, u3_value]
}

/// The energy, then its derivatives by the state.
///
/// 103 operations, 3 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(_p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 9] {
    let [q1, q2, q3, q0] = *q;
    let [u1, u2, u3, u0] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // u1*cos(q1); used 3 times
    let u1_c1 = u1 * c1;
    // 16*u1_c1 - 25*u0; used 3 times
    let energy_part = (-u0).mul_add(S::int(25), S::int(16) * u1_c1);
    // u2*cos(q2); used 2 times
    let u2_c2 = u2 * c2;
    // u3*cos(q3); used 2 times
    let u3_c3 = u3 * c3;
    // 897*u2_c2 + 298*u3_c3; used 3 times
    let energy_part_2 = u3_c3.mul_add(S::int(298), S::int(897) * u2_c2);
    // u1*sin(q1); used 4 times
    let u1_s1 = u1 * s1;
    // u2*sin(q2); used 2 times
    let u2_s2 = u2 * s2;
    // u3*sin(q3); used 2 times
    let u3_s3 = u3 * s3;
    // 897*u2_s2 + 298*u3_s3
    let energy_part_3 = u3_s3.mul_add(S::int(298), S::int(897) * u2_s2);
    // 4*energy_part_3/3125; used 3 times
    let energy_part_3_scaled = S::ratio(4, 3125) * energy_part_3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 3 times
    let energy_part_4 = c2.mul_add(c3, s2 * s3);
    // 1937*u2/6250; used 2 times
    let u2_scaled = S::ratio(1937, 6250) * u2;
    // u3*u2_scaled; used 2 times
    let u3_u2_scaled = u3 * u2_scaled;
    // 1928*u1_c1/625; used 2 times
    let u1_c1_scaled = S::ratio(1928, 625) * u1_c1;
    // 2410*u0 - energy_part_2
    let energy_by_q1_part = u0.mul_add(S::int(2410), -energy_part_2);
    // 4*energy_by_q1_part/3125; used 2 times
    let energy_by_q1_part_scaled = S::ratio(4, 3125) * energy_by_q1_part;
    // 897*energy_part/12500; used 2 times
    let energy_part_scaled = S::ratio(897, 12500) * energy_part;
    // 3588*u1_s1/3125; used 2 times
    let u1_s1_scaled = S::ratio(3588, 3125) * u1_s1;
    // u3_u2_scaled*(cos(q2)*sin(q3) - sin(q2)*cos(q3)); used 2 times
    let energy_by_q2_part = u3_u2_scaled * (-s2).mul_add(c3, c2 * s3);
    // 149*energy_part/6250; used 2 times
    let energy_part_scaled_2 = S::ratio(149, 6250) * energy_part;
    // 1192*u1_s1/3125; used 2 times
    let u1_s1_scaled_2 = S::ratio(1192, 3125) * u1_s1;
    // Values.
    // T + V = 472842*cos(q1)/15625 - 11*q0/4 + 879957*cos(q2)/50000 + 146169*cos(q3)/25000 + 149*u3^2/1250
    //   + u0*(14225*u0 - 15424*u1*cos(q1) - 8970*u2*cos(q2) - 2980*u3*cos(q3))/5000 + 4*u1*(3856*u1 +
    //   4485*u2*cos(q1 - q2) + 1490*u3*cos(q1 - q3))/15625 + 13*u2*(897*u2 + 596*u3*cos(q2 - q3))/25000
    let energy = u1_s1
        .mul_add(
            energy_part_3_scaled,
            S::ratio(472842, 15625) * c1 - S::ratio(11, 4) * q0
                + S::ratio(879957, 50000) * c2 + S::ratio(146169, 25000) * c3
                + S::ratio(569, 200) * u0 * u0 + S::ratio(15424, 15625) * u1 * u1
                + S::ratio(11661, 25000) * u2 * u2 + S::ratio(149, 1250) * u3 * u3
                + S::ratio(1, 12500) * energy_part * energy_part_2,
        ) + energy_part_4 * u3_u2_scaled - u0 * u1_c1_scaled;
    // d(T + V)/d(q1) = 4*u1*(2410*u0*sin(q1) - 897*u2*sin(q1 - q2) - 298*u3*sin(q1 - q3))/3125 -
    //   472842*sin(q1)/15625
    let energy_by_q1 = u1_c1.mul_add(energy_part_3_scaled, -S::ratio(472842, 15625) * s1)
        + u1_s1 * energy_by_q1_part_scaled;
    // d(T + V)/d(q2) = 13*u2*(1725*u0*sin(q2) - 298*u3*sin(q2 - q3) + 1104*u1*sin(q1 - q2))/12500 -
    //   879957*sin(q2)/50000
    let energy_by_q2 = u2_c2.mul_add(u1_s1_scaled, -S::ratio(879957, 50000) * s2)
        - u2_s2 * energy_part_scaled + energy_by_q2_part;
    // d(T + V)/d(q3) = 149*u3*(25*u0*sin(q3) + 16*u1*sin(q1 - q3) + 13*u2*sin(q2 - q3))/6250 -
    //   146169*sin(q3)/25000
    let energy_by_q3 = u3_c3.mul_add(u1_s1_scaled_2, -S::ratio(146169, 25000) * s3)
        - energy_by_q2_part - u3_s3 * energy_part_scaled_2;
    // d(T + V)/d(q0) = -11/4
    let energy_by_q0 = -S::ratio(11, 4);
    // d(T + V)/d(u1) = 30848*u1/15625 - 1928*u0*cos(q1)/625 + 3588*u2*cos(q1 - q2)/3125 + 1192*u3*cos(q1 -
    //   q3)/3125
    let energy_by_u1 = energy_part_3_scaled.mul_add(s1, S::ratio(30848, 15625) * u1)
        - energy_by_q1_part_scaled * c1;
    // d(T + V)/d(u2) = 3588*u1*cos(q1 - q2)/3125 - 897*u0*cos(q2)/500 + 11661*u2/12500 + 1937*u3*cos(q2 -
    //   q3)/6250
    let energy_by_u2 = energy_part_scaled
        .mul_add(
            c2,
            S::ratio(11661, 12500) * u2 + S::ratio(1937, 6250) * u3 * energy_part_4,
        ) + u1_s1_scaled * s2;
    // d(T + V)/d(u3) = 1192*u1*cos(q1 - q3)/3125 - 149*u0*cos(q3)/250 + 1937*u2*cos(q2 - q3)/6250 +
    //   149*u3/625
    let energy_by_u3 = energy_part_4.mul_add(u2_scaled, S::ratio(149, 625) * u3)
        + energy_part_scaled_2 * c3 + u1_s1_scaled_2 * s3;
    // d(T + V)/d(u0) = 569*u0/100 - 1928*u1*cos(q1)/625 - 897*u2*cos(q2)/500 - 149*u3*cos(q3)/250
    let energy_by_u0 = S::ratio(569, 100) * u0 - S::ratio(1, 500) * energy_part_2
        - u1_c1_scaled;
    [
        energy,
        energy_by_q1,
        energy_by_q2,
        energy_by_q3,
        energy_by_q0,
        energy_by_u1,
        energy_by_u2,
        energy_by_u3,
        energy_by_u0,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 70 convolutions and 206 linear operations an order.
pub fn taylor<S: Scalar>(
    _p: &Parameters<S>,
    series: &mut [[S; 8]],
    history: &mut [Factors<S, 72>],
) {
    let [q1_0, q2_0, q3_0, _, u1_0, u2_0, u3_0, u0_0] = series[0];
    // Order 0.
    let (s1_0, c1_0) = q1_0.sin_cos();
    let (s2_0, c2_0) = q2_0.sin_cos();
    let (s3_0, c3_0) = q3_0.sin_cos();
    // u1_p2 = u1*u1
    let u1_p2_0 = u1_0 * u1_0;
    // u1_p2_sin_q1 = s1*u1_p2
    let u1_p2_sin_q1_0 = s1_0 * u1_p2_0;
    // u2_p2 = u2*u2
    let u2_p2_0 = u2_0 * u2_0;
    // u2_p2_sin_q2 = s2*u2_p2
    let u2_p2_sin_q2_0 = s2_0 * u2_p2_0;
    // u3_p2 = u3*u3
    let u3_p2_0 = u3_0 * u3_0;
    // u3_p2_sin_q3 = s3*u3_p2
    let u3_p2_sin_q3_0 = s3_0 * u3_p2_0;
    // u1_p2_cos_q1 = c1*u1_p2
    let u1_p2_cos_q1_0 = c1_0 * u1_p2_0;
    // u2_p2_cos_q2 = c2*u2_p2
    let u2_p2_cos_q2_0 = c2_0 * u2_p2_0;
    // u3_p2_cos_q3 = c3*u3_p2
    let u3_p2_cos_q3_0 = c3_0 * u3_p2_0;
    // sin_q2_sin_q3 = s2*s3
    let sin_q2_sin_q3_0 = s2_0 * s3_0;
    // cos_q2_cos_q3 = c2*c3
    let cos_q2_cos_q3_0 = c2_0 * c3_0;
    // u0_dot_part = sin_q2_sin_q3 + cos_q2_cos_q3
    let u0_dot_part_0 = sin_q2_sin_q3_0 + cos_q2_cos_q3_0;
    // cos_q1_p2 = c1*c1
    let cos_q1_p2_0 = c1_0 * c1_0;
    // sin_q1_sin_q2 = s1*s2
    let sin_q1_sin_q2_0 = s1_0 * s2_0;
    // cos_q2_p2 = c2*c2
    let cos_q2_p2_0 = c2_0 * c2_0;
    // cos_q3_p2 = c3*c3
    let cos_q3_p2_0 = c3_0 * c3_0;
    // u0_dot_part_2 = -569 + 482*cos_q1_p2
    let u0_dot_part_2_0 = cos_q1_p2_0.mul_add(S::int(482), -S::int(569));
    let over_u0_dot_part_2 = S::int(1) / u0_dot_part_2_0;
    // u0_dot_part_3 = 36019 + 60030*cos_q2_p2
    let u0_dot_part_3_0 = cos_q2_p2_0.mul_add(S::int(60030), S::int(36019));
    // u0_dot_part_4 = c1*u0_dot_part_3
    let u0_dot_part_4_0 = c1_0 * u0_dot_part_3_0;
    // sin_q1_sin_q2_cos_q2 = c2*sin_q1_sin_q2
    let sin_q1_sin_q2_cos_q2_0 = c2_0 * sin_q1_sin_q2_0;
    // u0_dot_part_5 = u0_dot_part_4 + 60030*sin_q1_sin_q2_cos_q2
    let u0_dot_part_5_0 = S::int(60030) * sin_q1_sin_q2_cos_q2_0 + u0_dot_part_4_0;
    // u0_dot_part_6 = c1*u0_dot_part_5
    let u0_dot_part_6_0 = c1_0 * u0_dot_part_5_0;
    // u0_dot_part_7 = 77953 + 30015*cos_q2_p2 - u0_dot_part_6
    let u0_dot_part_7_0 = cos_q2_p2_0.mul_add(S::int(30015), S::int(77953))
        - u0_dot_part_6_0;
    let over_u0_dot_part_7 = S::int(1) / u0_dot_part_7_0;
    // u1_p2_sin_q2 = s2*u1_p2
    let u1_p2_sin_q2_0 = s2_0 * u1_p2_0;
    // u0_dot_part_8 = -14562461 + 5593162*cos_q3_p2
    let u0_dot_part_8_0 = cos_q3_p2_0.mul_add(S::int(5593162), -S::int(14562461));
    // u0_dot_part_9 = c2*u0_dot_part_8
    let u0_dot_part_9_0 = c2_0 * u0_dot_part_8_0;
    // sin_q2_sin_q3_cos_q3 = c3*sin_q2_sin_q3
    let sin_q2_sin_q3_cos_q3_0 = c3_0 * sin_q2_sin_q3_0;
    // u0_dot_part_10 = u0_dot_part_9 + 5593162*sin_q2_sin_q3_cos_q3
    let u0_dot_part_10_0 = S::int(5593162) * sin_q2_sin_q3_cos_q3_0 + u0_dot_part_9_0;
    // u0_dot_part_11 = c1*u0_dot_part_10
    let u0_dot_part_11_0 = c1_0 * u0_dot_part_10_0;
    // u0_dot_part_12 = 11765880*sin_q1_sin_q2 - u0_dot_part_11
    let u0_dot_part_12_0 = S::int(11765880) * sin_q1_sin_q2_0 - u0_dot_part_11_0;
    // u0_dot_part_13 = c1*u0_dot_part_12
    let u0_dot_part_13_0 = c1_0 * u0_dot_part_12_0;
    // u0_dot_part_14 = -373409 + 326608*cos_q3_p2
    let u0_dot_part_14_0 = cos_q3_p2_0.mul_add(S::int(326608), -S::int(373409));
    // u0_dot_part_15 = c2*u0_dot_part_14
    let u0_dot_part_15_0 = c2_0 * u0_dot_part_14_0;
    // u0_dot_part_16 = 9145024*sin_q2_sin_q3_cos_q3 + u0_dot_part_13 + 28*u0_dot_part_15
    let u0_dot_part_16_0 = u0_dot_part_15_0
        .mul_add(S::int(28), S::int(9145024) * sin_q2_sin_q3_cos_q3_0)
        + u0_dot_part_13_0;
    // u0_dot_part_17 = c2*u0_dot_part_16
    let u0_dot_part_17_0 = c2_0 * u0_dot_part_16_0;
    // u0_dot_part_18 = 7059724 + 2796581*cos_q3_p2
    let u0_dot_part_18_0 = cos_q3_p2_0.mul_add(S::int(2796581), S::int(7059724));
    // u0_dot_part_19 = u0_dot_part_18*cos_q1_p2
    let u0_dot_part_19_0 = u0_dot_part_18_0 * cos_q1_p2_0;
    // u0_dot_part_20 = 15278788 + 4572512*cos_q3_p2 - u0_dot_part_17 - u0_dot_part_19
    let u0_dot_part_20_0 = cos_q3_p2_0.mul_add(S::int(4572512), S::int(15278788))
        - u0_dot_part_19_0 - u0_dot_part_17_0;
    let over_u0_dot_part_20 = S::int(1) / u0_dot_part_20_0;
    // u0_dot_part_21 = -1 + 2*cos_q3_p2
    let u0_dot_part_21_0 = cos_q3_p2_0.mul_add(S::int(2), -S::int(1));
    // u0_dot_part_22 = u0_dot_part_21*u3_p2
    let u0_dot_part_22_0 = u0_dot_part_21_0 * u3_p2_0;
    // u0_dot_part_23 = 27500*s3 - 85347*c3
    let u0_dot_part_23_0 = c3_0.mul_add(-S::int(85347), S::int(27500) * s3_0);
    // u0_dot_part_24 = 1897500*s3 - 5888943*c3 - 163304*u0_dot_part_22
    let u0_dot_part_24_0 = u0_dot_part_22_0
        .mul_add(
            -S::int(163304),
            c3_0.mul_add(-S::int(5888943), S::int(1897500) * s3_0),
        );
    // u0_dot_part_25 = s2*u0_dot_part_24
    let u0_dot_part_25_0 = s2_0 * u0_dot_part_24_0;
    // u0_dot_part_26 = 5888943 + 326608*u3_p2_cos_q3
    let u0_dot_part_26_0 = u3_p2_cos_q3_0.mul_add(S::int(326608), S::int(5888943));
    // u0_dot_part_27 = s3*u0_dot_part_26
    let u0_dot_part_27_0 = s3_0 * u0_dot_part_26_0;
    // u0_dot_part_28 = 1897500*c3 + u0_dot_part_27
    let u0_dot_part_28_0 = S::int(1897500) * c3_0 + u0_dot_part_27_0;
    // u0_dot_part_29 = c2*u0_dot_part_28
    let u0_dot_part_29_0 = c2_0 * u0_dot_part_28_0;
    // u2_p2_sin_q3 = s3*u2_p2
    let u2_p2_sin_q3_0 = s3_0 * u2_p2_0;
    // u0_dot_part_30 = u0_dot_part_25 + u0_dot_part_29 + 491556*u2_p2_sin_q3
    let u0_dot_part_30_0 = S::int(491556) * u2_p2_sin_q3_0 + u0_dot_part_25_0
        + u0_dot_part_29_0;
    // u0_dot_part_31 = s1*u0_dot_part_30
    let u0_dot_part_31_0 = s1_0 * u0_dot_part_30_0;
    // u0_dot_part_32 = 85347*s3 + 27500*c3
    let u0_dot_part_32_0 = c3_0.mul_add(S::int(27500), S::int(85347) * s3_0);
    // u0_dot_part_33 = s2*u0_dot_part_32
    let u0_dot_part_33_0 = s2_0 * u0_dot_part_32_0;
    // u0_dot_part_34 = c2*u0_dot_part_23
    let u0_dot_part_34_0 = c2_0 * u0_dot_part_23_0;
    // u0_dot_part_35 = u0_dot_part_33 - u0_dot_part_34
    let u0_dot_part_35_0 = u0_dot_part_33_0 - u0_dot_part_34_0;
    // u0_dot_part_36 = c1*u0_dot_part_35
    let u0_dot_part_36_0 = c1_0 * u0_dot_part_35_0;
    // u0_dot_part_37 = u0_dot_part*u1_p2
    let u0_dot_part_37_0 = u0_dot_part_0 * u1_p2_0;
    // u0_dot_part_38 = u0_dot_part_31 - 69*u0_dot_part_36 + 384192*u0_dot_part_37
    let u0_dot_part_38_0 = u0_dot_part_36_0
        .mul_add(-S::int(69), S::int(384192) * u0_dot_part_37_0) + u0_dot_part_31_0;
    // u0_dot_part_39 = s1*u0_dot_part_38
    let u0_dot_part_39_0 = s1_0 * u0_dot_part_38_0;
    // u0_dot_part_40 = -67689 + 4416*u1_p2_cos_q1 + 2384*u3_p2_cos_q3
    let u0_dot_part_40_0 = u3_p2_cos_q3_0
        .mul_add(S::int(2384), u1_p2_cos_q1_0.mul_add(S::int(4416), -S::int(67689)));
    // u0_dot_part_41 = c3*u0_dot_part_40
    let u0_dot_part_41_0 = c3_0 * u0_dot_part_40_0;
    // u0_dot_part_42 = 1192*u3_p2 - u0_dot_part_41
    let u0_dot_part_42_0 = S::int(1192) * u3_p2_0 - u0_dot_part_41_0;
    // u0_dot_part_43 = s2*u0_dot_part_42
    let u0_dot_part_43_0 = s2_0 * u0_dot_part_42_0;
    // u0_dot_part_44 = c2*u0_dot_part_40
    let u0_dot_part_44_0 = c2_0 * u0_dot_part_40_0;
    // u0_dot_part_45 = 3588*u2_p2 + u0_dot_part_44
    let u0_dot_part_45_0 = S::int(3588) * u2_p2_0 + u0_dot_part_44_0;
    // u0_dot_part_46 = s3*u0_dot_part_45
    let u0_dot_part_46_0 = s3_0 * u0_dot_part_45_0;
    // u0_dot_part_47 = u0_dot_part_39 + 87*u0_dot_part_43 + 87*u0_dot_part_46
    let u0_dot_part_47_0 = u0_dot_part_46_0
        .mul_add(S::int(87), S::int(87) * u0_dot_part_43_0) + u0_dot_part_39_0;
    // u0_dot_part_48 = c2*u0_dot_part_47
    let u0_dot_part_48_0 = c2_0 * u0_dot_part_47_0;
    // u0_dot_part_49 = 474375 + 122889*u2_p2_sin_q2 + 40826*u3_p2_sin_q3
    let u0_dot_part_49_0 = u3_p2_sin_q3_0
        .mul_add(S::int(40826), u2_p2_sin_q2_0.mul_add(S::int(122889), S::int(474375)));
    // u0_dot_part_50 = s1*u0_dot_part_49
    let u0_dot_part_50_0 = s1_0 * u0_dot_part_49_0;
    // u0_dot_part_51 = 5888943*c1 - 384192*u1_p2 - 4*u0_dot_part_50
    let u0_dot_part_51_0 = u0_dot_part_50_0
        .mul_add(-S::int(4), u1_p2_0.mul_add(-S::int(384192), S::int(5888943) * c1_0));
    // u0_dot_part_52 = s1*u0_dot_part_51
    let u0_dot_part_52_0 = s1_0 * u0_dot_part_51_0;
    // u0_dot_part_53 = 312156*u2_p2_sin_q2 + 103704*u3_p2_sin_q3 - u0_dot_part_52
    let u0_dot_part_53_0 = u3_p2_sin_q3_0
        .mul_add(S::int(103704), S::int(312156) * u2_p2_sin_q2_0) - u0_dot_part_52_0;
    // u0_dot_part_54 = c3*u0_dot_part_53
    let u0_dot_part_54_0 = c3_0 * u0_dot_part_53_0;
    // u0_dot_part_55 = u0_dot_part_48 - u0_dot_part_54
    let u0_dot_part_55_0 = -u0_dot_part_54_0 + u0_dot_part_48_0;
    // u0_dot_part_56 = u0_dot_part_55/u0_dot_part_20
    let u0_dot_part_56_0 = u0_dot_part_55_0 * over_u0_dot_part_20;
    // u0_dot_part_57 = s3*u0_dot_part_56
    let u0_dot_part_57_0 = s3_0 * u0_dot_part_56_0;
    // u0_dot_part_58 = -472842 + 35880*u2_p2_cos_q2 + 5960*u3_p2_cos_q3 - 102065*u0_dot_part_57
    let u0_dot_part_58_0 = u0_dot_part_57_0
        .mul_add(
            -S::int(102065),
            u3_p2_cos_q3_0
                .mul_add(
                    S::int(5960),
                    u2_p2_cos_q2_0.mul_add(S::int(35880), -S::int(472842)),
                ),
        );
    // u0_dot_part_59 = c2*u0_dot_part_58
    let u0_dot_part_59_0 = c2_0 * u0_dot_part_58_0;
    // u0_dot_part_60 = c3*u0_dot_part_56
    let u0_dot_part_60_0 = c3_0 * u0_dot_part_56_0;
    // u0_dot_part_61 = 2651000 + 103704*u3_p2_sin_q3 + 1775931*u0_dot_part_60
    let u0_dot_part_61_0 = u0_dot_part_60_0
        .mul_add(
            S::int(1775931),
            u3_p2_sin_q3_0.mul_add(S::int(103704), S::int(2651000)),
        );
    // u0_dot_part_62 = s2*u0_dot_part_61
    let u0_dot_part_62_0 = s2_0 * u0_dot_part_61_0;
    // u0_dot_part_63 = 1560780*u2_p2 - 87*u0_dot_part_59 + 5*u0_dot_part_62
    let u0_dot_part_63_0 = u0_dot_part_62_0
        .mul_add(
            S::int(5),
            u0_dot_part_59_0.mul_add(-S::int(87), S::int(1560780) * u2_p2_0),
        );
    // u0_dot_part_64 = s1*u0_dot_part_63
    let u0_dot_part_64_0 = s1_0 * u0_dot_part_63_0;
    // u0_dot_part_65 = -2838470526 + 215387640*u2_p2_cos_q2 - 42934648*u3_p2_cos_q3 +
    //   735255847*u0_dot_part_57
    let u0_dot_part_65_0 = u0_dot_part_57_0
        .mul_add(
            S::int(735255847),
            u3_p2_cos_q3_0
                .mul_add(
                    -S::int(42934648),
                    u2_p2_cos_q2_0.mul_add(S::int(215387640), -S::int(2838470526)),
                ),
        );
    // u0_dot_part_66 = s2*u0_dot_part_65
    let u0_dot_part_66_0 = s2_0 * u0_dot_part_65_0;
    // u0_dot_part_67 = 914595000 + 114490408*u3_p2_sin_q3 + 1960648237*u0_dot_part_60
    let u0_dot_part_67_0 = u0_dot_part_60_0
        .mul_add(
            S::int(1960648237),
            u3_p2_sin_q3_0.mul_add(S::int(114490408), S::int(914595000)),
        );
    // u0_dot_part_68 = c2*u0_dot_part_67
    let u0_dot_part_68_0 = c2_0 * u0_dot_part_67_0;
    // u0_dot_part_69 = u0_dot_part_66 + u0_dot_part_68
    let u0_dot_part_69_0 = u0_dot_part_66_0 + u0_dot_part_68_0;
    // u0_dot_part_70 = c1*u0_dot_part_69
    let u0_dot_part_70_0 = c1_0 * u0_dot_part_69_0;
    // u0_dot_part_71 = 185180544*u1_p2_sin_q2 + 69*u0_dot_part_64 + u0_dot_part_70
    let u0_dot_part_71_0 = u0_dot_part_64_0
        .mul_add(S::int(69), S::int(185180544) * u1_p2_sin_q2_0) + u0_dot_part_70_0;
    // u0_dot_part_72 = c1*u0_dot_part_71
    let u0_dot_part_72_0 = c1_0 * u0_dot_part_71_0;
    // u0_dot_part_73 = 228648750 + 46295136*u1_p2_sin_q1 + 26923455*u2_p2_sin_q2 + 32174464*u3_p2_sin_q3 +
    //   550987696*u0_dot_part_60
    let u0_dot_part_73_0 = u0_dot_part_60_0
        .mul_add(
            S::int(550987696),
            u3_p2_sin_q3_0
                .mul_add(
                    S::int(32174464),
                    u2_p2_sin_q2_0
                        .mul_add(
                            S::int(26923455),
                            u1_p2_sin_q1_0.mul_add(S::int(46295136), S::int(228648750)),
                        ),
                ),
        );
    // u0_dot_part_74 = c2*u0_dot_part_73
    let u0_dot_part_74_0 = c2_0 * u0_dot_part_73_0;
    // u0_dot_part_75 = 8*u3_p2_cos_q3 - 137*u0_dot_part_57
    let u0_dot_part_75_0 = u0_dot_part_57_0
        .mul_add(-S::int(137), S::int(8) * u3_p2_cos_q3_0);
    // u0_dot_part_76 = s2*u0_dot_part_75
    let u0_dot_part_76_0 = s2_0 * u0_dot_part_75_0;
    // u0_dot_part_77 = u0_dot_part_72 - 4*u0_dot_part_74 + 11614997*u0_dot_part_76
    let u0_dot_part_77_0 = u0_dot_part_76_0
        .mul_add(S::int(11614997), -S::int(4) * u0_dot_part_74_0) + u0_dot_part_72_0;
    // u0_dot_part_78 = u0_dot_part_77/u0_dot_part_7
    let u0_dot_part_78_0 = u0_dot_part_77_0 * over_u0_dot_part_7;
    // u0_dot_part_79 = s2*u0_dot_part_78
    let u0_dot_part_79_0 = s2_0 * u0_dot_part_78_0;
    // u0_dot_part_80 = -269047098 + 14868736*u1_p2_cos_q1 + 10207860*u2_p2_cos_q2 + 3391240*u3_p2_cos_q3 -
    //   58074985*u0_dot_part_57 - 2845*u0_dot_part_79
    let u0_dot_part_80_0 = u0_dot_part_79_0
        .mul_add(
            -S::int(2845),
            u0_dot_part_57_0
                .mul_add(
                    -S::int(58074985),
                    u3_p2_cos_q3_0
                        .mul_add(
                            S::int(3391240),
                            u2_p2_cos_q2_0
                                .mul_add(
                                    S::int(10207860),
                                    u1_p2_cos_q1_0.mul_add(S::int(14868736), -S::int(269047098)),
                                ),
                        ),
                ),
        );
    // u0_dot_part_81 = s1*u0_dot_part_80
    let u0_dot_part_81_0 = s1_0 * u0_dot_part_80_0;
    // u0_dot_part_82 = c2*u0_dot_part_78
    let u0_dot_part_82_0 = c2_0 * u0_dot_part_78_0;
    // u0_dot_part_83 = 2651000 + 312156*u2_p2_sin_q2 + 103704*u3_p2_sin_q3 + 1775931*u0_dot_part_60 +
    //   87*u0_dot_part_82
    let u0_dot_part_83_0 = u0_dot_part_82_0
        .mul_add(
            S::int(87),
            u0_dot_part_60_0
                .mul_add(
                    S::int(1775931),
                    u3_p2_sin_q3_0
                        .mul_add(
                            S::int(103704),
                            u2_p2_sin_q2_0.mul_add(S::int(312156), S::int(2651000)),
                        ),
                ),
        );
    // u0_dot_part_84 = c1*u0_dot_part_83
    let u0_dot_part_84_0 = c1_0 * u0_dot_part_83_0;
    // u0_dot_part_85 = u0_dot_part_81 - 5*u0_dot_part_84
    let u0_dot_part_85_0 = u0_dot_part_84_0.mul_add(-S::int(5), u0_dot_part_81_0);
    // u0_dot_part_86 = u0_dot_part_85/u0_dot_part_2
    let u0_dot_part_86_0 = u0_dot_part_85_0 * over_u0_dot_part_2;
    // u0_dot_part_87 = c1*u0_dot_part_86
    let u0_dot_part_87_0 = c1_0 * u0_dot_part_86_0;
    // u0_dot_2 = 275/569 - 7712/14225*u1_p2_sin_q1 - 897/2845*u2_p2_sin_q2 - 298/2845*u3_p2_sin_q3 -
    //   20413/11380*u0_dot_part_60 - 1/11380*u0_dot_part_82 + 1/56900*u0_dot_part_87
    let u0_dot_2_0 = u0_dot_part_87_0
        .mul_add(
            S::ratio(1, 56900),
            u0_dot_part_82_0
                .mul_add(
                    -S::ratio(1, 11380),
                    u0_dot_part_60_0
                        .mul_add(
                            -S::ratio(20413, 11380),
                            u3_p2_sin_q3_0
                                .mul_add(
                                    -S::ratio(298, 2845),
                                    u2_p2_sin_q2_0
                                        .mul_add(
                                            -S::ratio(897, 2845),
                                            u1_p2_sin_q1_0
                                                .mul_add(-S::ratio(7712, 14225), S::ratio(275, 569)),
                                        ),
                                ),
                        ),
                ),
        );
    // Order 1: the rates, and what follows from them.
    let q1_1 = u1_0;
    let q2_1 = u2_0;
    let q3_1 = u3_0;
    let q0_1 = u0_0;
    let u1_1 = S::ratio(1, 30848) * u0_dot_part_86_0;
    let u2_1 = -S::ratio(1, 3588) * u0_dot_part_78_0;
    let u3_1 = -S::ratio(137, 8) * u0_dot_part_56_0;
    let u0_1 = u0_dot_2_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, q0_1, u1_1, u2_1, u3_1, u0_1];
    }
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let s3_1 = q3_1 * c3_0;
    let c3_1 = -q3_1 * s3_0;
    let u1_p2_1 = u1_1 * (u1_0 + u1_0);
    let u1_p2_sin_q1_1 = u1_p2_1.mul_add(s1_0, s1_1 * u1_p2_0);
    let u2_p2_1 = u2_1 * (u2_0 + u2_0);
    let u2_p2_sin_q2_1 = u2_p2_1.mul_add(s2_0, s2_1 * u2_p2_0);
    let u3_p2_1 = u3_1 * (u3_0 + u3_0);
    let u3_p2_sin_q3_1 = u3_p2_1.mul_add(s3_0, s3_1 * u3_p2_0);
    let u1_p2_cos_q1_1 = u1_p2_1.mul_add(c1_0, c1_1 * u1_p2_0);
    let u2_p2_cos_q2_1 = u2_p2_1.mul_add(c2_0, c2_1 * u2_p2_0);
    let u3_p2_cos_q3_1 = u3_p2_1.mul_add(c3_0, c3_1 * u3_p2_0);
    let sin_q2_sin_q3_1 = s3_1.mul_add(s2_0, s2_1 * s3_0);
    let cos_q2_cos_q3_1 = c3_1.mul_add(c2_0, c2_1 * c3_0);
    let u0_dot_part_1 = sin_q2_sin_q3_1 + cos_q2_cos_q3_1;
    let cos_q1_p2_1 = c1_1 * (c1_0 + c1_0);
    let sin_q1_sin_q2_1 = s2_1.mul_add(s1_0, s1_1 * s2_0);
    let cos_q2_p2_1 = c2_1 * (c2_0 + c2_0);
    let cos_q3_p2_1 = c3_1 * (c3_0 + c3_0);
    let u0_dot_part_2_1 = S::int(482) * cos_q1_p2_1;
    let u0_dot_part_3_1 = S::int(60030) * cos_q2_p2_1;
    let u0_dot_part_4_1 = u0_dot_part_3_1.mul_add(c1_0, c1_1 * u0_dot_part_3_0);
    let sin_q1_sin_q2_cos_q2_1 = sin_q1_sin_q2_1.mul_add(c2_0, c2_1 * sin_q1_sin_q2_0);
    let u0_dot_part_5_1 = S::int(60030) * sin_q1_sin_q2_cos_q2_1 + u0_dot_part_4_1;
    let u0_dot_part_6_1 = u0_dot_part_5_1.mul_add(c1_0, c1_1 * u0_dot_part_5_0);
    let u0_dot_part_7_1 = S::int(30015) * cos_q2_p2_1 - u0_dot_part_6_1;
    let u1_p2_sin_q2_1 = u1_p2_1.mul_add(s2_0, s2_1 * u1_p2_0);
    let u0_dot_part_8_1 = S::int(5593162) * cos_q3_p2_1;
    let u0_dot_part_9_1 = u0_dot_part_8_1.mul_add(c2_0, c2_1 * u0_dot_part_8_0);
    let sin_q2_sin_q3_cos_q3_1 = sin_q2_sin_q3_1.mul_add(c3_0, c3_1 * sin_q2_sin_q3_0);
    let u0_dot_part_10_1 = S::int(5593162) * sin_q2_sin_q3_cos_q3_1 + u0_dot_part_9_1;
    let u0_dot_part_11_1 = u0_dot_part_10_1.mul_add(c1_0, c1_1 * u0_dot_part_10_0);
    let u0_dot_part_12_1 = S::int(11765880) * sin_q1_sin_q2_1 - u0_dot_part_11_1;
    let u0_dot_part_13_1 = u0_dot_part_12_1.mul_add(c1_0, c1_1 * u0_dot_part_12_0);
    let u0_dot_part_14_1 = S::int(326608) * cos_q3_p2_1;
    let u0_dot_part_15_1 = u0_dot_part_14_1.mul_add(c2_0, c2_1 * u0_dot_part_14_0);
    let u0_dot_part_16_1 = u0_dot_part_15_1
        .mul_add(S::int(28), S::int(9145024) * sin_q2_sin_q3_cos_q3_1)
        + u0_dot_part_13_1;
    let u0_dot_part_17_1 = u0_dot_part_16_1.mul_add(c2_0, c2_1 * u0_dot_part_16_0);
    let u0_dot_part_18_1 = S::int(2796581) * cos_q3_p2_1;
    let u0_dot_part_19_1 = u0_dot_part_18_1
        .mul_add(cos_q1_p2_0, cos_q1_p2_1 * u0_dot_part_18_0);
    let u0_dot_part_20_1 = S::int(4572512) * cos_q3_p2_1 - u0_dot_part_19_1
        - u0_dot_part_17_1;
    let u0_dot_part_21_1 = S::int(2) * cos_q3_p2_1;
    let u0_dot_part_22_1 = u0_dot_part_21_1.mul_add(u3_p2_0, u3_p2_1 * u0_dot_part_21_0);
    let u0_dot_part_23_1 = c3_1.mul_add(-S::int(85347), S::int(27500) * s3_1);
    let u0_dot_part_24_1 = u0_dot_part_22_1
        .mul_add(
            -S::int(163304),
            c3_1.mul_add(-S::int(5888943), S::int(1897500) * s3_1),
        );
    let u0_dot_part_25_1 = u0_dot_part_24_1.mul_add(s2_0, s2_1 * u0_dot_part_24_0);
    let u0_dot_part_26_1 = S::int(326608) * u3_p2_cos_q3_1;
    let u0_dot_part_27_1 = u0_dot_part_26_1.mul_add(s3_0, s3_1 * u0_dot_part_26_0);
    let u0_dot_part_28_1 = S::int(1897500) * c3_1 + u0_dot_part_27_1;
    let u0_dot_part_29_1 = u0_dot_part_28_1.mul_add(c2_0, c2_1 * u0_dot_part_28_0);
    let u2_p2_sin_q3_1 = u2_p2_1.mul_add(s3_0, s3_1 * u2_p2_0);
    let u0_dot_part_30_1 = S::int(491556) * u2_p2_sin_q3_1 + u0_dot_part_25_1
        + u0_dot_part_29_1;
    let u0_dot_part_31_1 = u0_dot_part_30_1.mul_add(s1_0, s1_1 * u0_dot_part_30_0);
    let u0_dot_part_32_1 = c3_1.mul_add(S::int(27500), S::int(85347) * s3_1);
    let u0_dot_part_33_1 = u0_dot_part_32_1.mul_add(s2_0, s2_1 * u0_dot_part_32_0);
    let u0_dot_part_34_1 = u0_dot_part_23_1.mul_add(c2_0, c2_1 * u0_dot_part_23_0);
    let u0_dot_part_35_1 = u0_dot_part_33_1 - u0_dot_part_34_1;
    let u0_dot_part_36_1 = u0_dot_part_35_1.mul_add(c1_0, c1_1 * u0_dot_part_35_0);
    let u0_dot_part_37_1 = u0_dot_part_1.mul_add(u1_p2_0, u1_p2_1 * u0_dot_part_0);
    let u0_dot_part_38_1 = u0_dot_part_36_1
        .mul_add(-S::int(69), S::int(384192) * u0_dot_part_37_1) + u0_dot_part_31_1;
    let u0_dot_part_39_1 = u0_dot_part_38_1.mul_add(s1_0, s1_1 * u0_dot_part_38_0);
    let u0_dot_part_40_1 = u3_p2_cos_q3_1
        .mul_add(S::int(2384), S::int(4416) * u1_p2_cos_q1_1);
    let u0_dot_part_41_1 = u0_dot_part_40_1.mul_add(c3_0, c3_1 * u0_dot_part_40_0);
    let u0_dot_part_42_1 = S::int(1192) * u3_p2_1 - u0_dot_part_41_1;
    let u0_dot_part_43_1 = u0_dot_part_42_1.mul_add(s2_0, s2_1 * u0_dot_part_42_0);
    let u0_dot_part_44_1 = u0_dot_part_40_1.mul_add(c2_0, c2_1 * u0_dot_part_40_0);
    let u0_dot_part_45_1 = S::int(3588) * u2_p2_1 + u0_dot_part_44_1;
    let u0_dot_part_46_1 = u0_dot_part_45_1.mul_add(s3_0, s3_1 * u0_dot_part_45_0);
    let u0_dot_part_47_1 = u0_dot_part_46_1
        .mul_add(S::int(87), S::int(87) * u0_dot_part_43_1) + u0_dot_part_39_1;
    let u0_dot_part_48_1 = u0_dot_part_47_1.mul_add(c2_0, c2_1 * u0_dot_part_47_0);
    let u0_dot_part_49_1 = u3_p2_sin_q3_1
        .mul_add(S::int(40826), S::int(122889) * u2_p2_sin_q2_1);
    let u0_dot_part_50_1 = u0_dot_part_49_1.mul_add(s1_0, s1_1 * u0_dot_part_49_0);
    let u0_dot_part_51_1 = u0_dot_part_50_1
        .mul_add(-S::int(4), u1_p2_1.mul_add(-S::int(384192), S::int(5888943) * c1_1));
    let u0_dot_part_52_1 = u0_dot_part_51_1.mul_add(s1_0, s1_1 * u0_dot_part_51_0);
    let u0_dot_part_53_1 = u3_p2_sin_q3_1
        .mul_add(S::int(103704), S::int(312156) * u2_p2_sin_q2_1) - u0_dot_part_52_1;
    let u0_dot_part_54_1 = u0_dot_part_53_1.mul_add(c3_0, c3_1 * u0_dot_part_53_0);
    let u0_dot_part_55_1 = -u0_dot_part_54_1 + u0_dot_part_48_1;
    let u0_dot_part_56_1 = u0_dot_part_20_1
        .mul_add(
            -(u0_dot_part_56_0 * over_u0_dot_part_20),
            u0_dot_part_55_1 * over_u0_dot_part_20,
        );
    let u0_dot_part_57_1 = u0_dot_part_56_1.mul_add(s3_0, s3_1 * u0_dot_part_56_0);
    let u0_dot_part_58_1 = u0_dot_part_57_1
        .mul_add(
            -S::int(102065),
            u3_p2_cos_q3_1.mul_add(S::int(5960), S::int(35880) * u2_p2_cos_q2_1),
        );
    let u0_dot_part_59_1 = u0_dot_part_58_1.mul_add(c2_0, c2_1 * u0_dot_part_58_0);
    let u0_dot_part_60_1 = u0_dot_part_56_1.mul_add(c3_0, c3_1 * u0_dot_part_56_0);
    let u0_dot_part_61_1 = u0_dot_part_60_1
        .mul_add(S::int(1775931), S::int(103704) * u3_p2_sin_q3_1);
    let u0_dot_part_62_1 = u0_dot_part_61_1.mul_add(s2_0, s2_1 * u0_dot_part_61_0);
    let u0_dot_part_63_1 = u0_dot_part_62_1
        .mul_add(
            S::int(5),
            u0_dot_part_59_1.mul_add(-S::int(87), S::int(1560780) * u2_p2_1),
        );
    let u0_dot_part_64_1 = u0_dot_part_63_1.mul_add(s1_0, s1_1 * u0_dot_part_63_0);
    let u0_dot_part_65_1 = u0_dot_part_57_1
        .mul_add(
            S::int(735255847),
            u3_p2_cos_q3_1.mul_add(-S::int(42934648), S::int(215387640) * u2_p2_cos_q2_1),
        );
    let u0_dot_part_66_1 = u0_dot_part_65_1.mul_add(s2_0, s2_1 * u0_dot_part_65_0);
    let u0_dot_part_67_1 = u0_dot_part_60_1
        .mul_add(S::int(1960648237), S::int(114490408) * u3_p2_sin_q3_1);
    let u0_dot_part_68_1 = u0_dot_part_67_1.mul_add(c2_0, c2_1 * u0_dot_part_67_0);
    let u0_dot_part_69_1 = u0_dot_part_66_1 + u0_dot_part_68_1;
    let u0_dot_part_70_1 = u0_dot_part_69_1.mul_add(c1_0, c1_1 * u0_dot_part_69_0);
    let u0_dot_part_71_1 = u0_dot_part_64_1
        .mul_add(S::int(69), S::int(185180544) * u1_p2_sin_q2_1) + u0_dot_part_70_1;
    let u0_dot_part_72_1 = u0_dot_part_71_1.mul_add(c1_0, c1_1 * u0_dot_part_71_0);
    let u0_dot_part_73_1 = u0_dot_part_60_1
        .mul_add(
            S::int(550987696),
            u3_p2_sin_q3_1
                .mul_add(
                    S::int(32174464),
                    u2_p2_sin_q2_1
                        .mul_add(S::int(26923455), S::int(46295136) * u1_p2_sin_q1_1),
                ),
        );
    let u0_dot_part_74_1 = u0_dot_part_73_1.mul_add(c2_0, c2_1 * u0_dot_part_73_0);
    let u0_dot_part_75_1 = u0_dot_part_57_1
        .mul_add(-S::int(137), S::int(8) * u3_p2_cos_q3_1);
    let u0_dot_part_76_1 = u0_dot_part_75_1.mul_add(s2_0, s2_1 * u0_dot_part_75_0);
    let u0_dot_part_77_1 = u0_dot_part_76_1
        .mul_add(S::int(11614997), -S::int(4) * u0_dot_part_74_1) + u0_dot_part_72_1;
    let u0_dot_part_78_1 = u0_dot_part_7_1
        .mul_add(
            -(u0_dot_part_78_0 * over_u0_dot_part_7),
            u0_dot_part_77_1 * over_u0_dot_part_7,
        );
    let u0_dot_part_79_1 = u0_dot_part_78_1.mul_add(s2_0, s2_1 * u0_dot_part_78_0);
    let u0_dot_part_80_1 = u0_dot_part_79_1
        .mul_add(
            -S::int(2845),
            u0_dot_part_57_1
                .mul_add(
                    -S::int(58074985),
                    u3_p2_cos_q3_1
                        .mul_add(
                            S::int(3391240),
                            u2_p2_cos_q2_1
                                .mul_add(
                                    S::int(10207860),
                                    S::int(14868736) * u1_p2_cos_q1_1,
                                ),
                        ),
                ),
        );
    let u0_dot_part_81_1 = u0_dot_part_80_1.mul_add(s1_0, s1_1 * u0_dot_part_80_0);
    let u0_dot_part_82_1 = u0_dot_part_78_1.mul_add(c2_0, c2_1 * u0_dot_part_78_0);
    let u0_dot_part_83_1 = u0_dot_part_82_1
        .mul_add(
            S::int(87),
            u0_dot_part_60_1
                .mul_add(
                    S::int(1775931),
                    u3_p2_sin_q3_1
                        .mul_add(S::int(103704), S::int(312156) * u2_p2_sin_q2_1),
                ),
        );
    let u0_dot_part_84_1 = u0_dot_part_83_1.mul_add(c1_0, c1_1 * u0_dot_part_83_0);
    let u0_dot_part_85_1 = u0_dot_part_84_1.mul_add(-S::int(5), u0_dot_part_81_1);
    let u0_dot_part_86_1 = u0_dot_part_2_1
        .mul_add(
            -(u0_dot_part_86_0 * over_u0_dot_part_2),
            u0_dot_part_85_1 * over_u0_dot_part_2,
        );
    let u0_dot_part_87_1 = u0_dot_part_86_1.mul_add(c1_0, c1_1 * u0_dot_part_86_0);
    let u0_dot_2_1 = u0_dot_part_87_1
        .mul_add(
            S::ratio(1, 56900),
            u0_dot_part_82_1
                .mul_add(
                    -S::ratio(1, 11380),
                    u0_dot_part_60_1
                        .mul_add(
                            -S::ratio(20413, 11380),
                            u3_p2_sin_q3_1
                                .mul_add(
                                    -S::ratio(298, 2845),
                                    u2_p2_sin_q2_1
                                        .mul_add(
                                            -S::ratio(897, 2845),
                                            -S::ratio(7712, 14225) * u1_p2_sin_q1_1,
                                        ),
                                ),
                        ),
                ),
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q1_1,
                q1_1,
                q2_1,
                q2_1,
                q3_1,
                q3_1,
                u1_1,
                s1_1,
                u2_1,
                s2_1,
                u3_1,
                s3_1,
                c1_1,
                c2_1,
                c3_1,
                s2_1,
                c2_1,
                c1_1,
                s1_1,
                c2_1,
                c3_1,
                c1_1,
                c2_1,
                c1_1,
                s2_1,
                c2_1,
                c3_1,
                c1_1,
                c1_1,
                c2_1,
                c2_1,
                u0_dot_part_18_1,
                u0_dot_part_21_1,
                s2_1,
                s3_1,
                c2_1,
                s3_1,
                s1_1,
                s2_1,
                c2_1,
                c1_1,
                u0_dot_part_1,
                s1_1,
                c3_1,
                s2_1,
                c2_1,
                s3_1,
                c2_1,
                s1_1,
                s1_1,
                c3_1,
                u0_dot_part_20_1,
                s3_1,
                c2_1,
                c3_1,
                s2_1,
                s1_1,
                s2_1,
                c2_1,
                c1_1,
                c1_1,
                c2_1,
                s2_1,
                u0_dot_part_7_1,
                s2_1,
                s1_1,
                c2_1,
                c1_1,
                u0_dot_part_2_1,
                c1_1,
            ]),
            padded([
                c1_1,
                s1_1,
                c2_1,
                s2_1,
                c3_1,
                s3_1,
                u1_1,
                u1_p2_1,
                u2_1,
                u2_p2_1,
                u3_1,
                u3_p2_1,
                u1_p2_1,
                u2_p2_1,
                u3_p2_1,
                s3_1,
                c3_1,
                c1_1,
                s2_1,
                c2_1,
                c3_1,
                u0_dot_part_3_1,
                sin_q1_sin_q2_1,
                u0_dot_part_5_1,
                u1_p2_1,
                u0_dot_part_8_1,
                sin_q2_sin_q3_1,
                u0_dot_part_10_1,
                u0_dot_part_12_1,
                u0_dot_part_14_1,
                u0_dot_part_16_1,
                cos_q1_p2_1,
                u3_p2_1,
                u0_dot_part_24_1,
                u0_dot_part_26_1,
                u0_dot_part_28_1,
                u2_p2_1,
                u0_dot_part_30_1,
                u0_dot_part_32_1,
                u0_dot_part_23_1,
                u0_dot_part_35_1,
                u1_p2_1,
                u0_dot_part_38_1,
                u0_dot_part_40_1,
                u0_dot_part_42_1,
                u0_dot_part_40_1,
                u0_dot_part_45_1,
                u0_dot_part_47_1,
                u0_dot_part_49_1,
                u0_dot_part_51_1,
                u0_dot_part_53_1,
                u0_dot_part_56_1,
                u0_dot_part_56_1,
                u0_dot_part_58_1,
                u0_dot_part_56_1,
                u0_dot_part_61_1,
                u0_dot_part_63_1,
                u0_dot_part_65_1,
                u0_dot_part_67_1,
                u0_dot_part_69_1,
                u0_dot_part_71_1,
                u0_dot_part_73_1,
                u0_dot_part_75_1,
                u0_dot_part_78_1,
                u0_dot_part_78_1,
                u0_dot_part_80_1,
                u0_dot_part_78_1,
                u0_dot_part_83_1,
                u0_dot_part_86_1,
                u0_dot_part_86_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut q3_last = q3_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut u3_last = u3_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut s3_last = s3_1;
    let mut c3_last = c3_1;
    let mut u1_p2_last = u1_p2_1;
    let mut u2_p2_last = u2_p2_1;
    let mut u3_p2_last = u3_p2_1;
    let mut sin_q2_sin_q3_last = sin_q2_sin_q3_1;
    let mut u0_dot_part_last = u0_dot_part_1;
    let mut cos_q1_p2_last = cos_q1_p2_1;
    let mut sin_q1_sin_q2_last = sin_q1_sin_q2_1;
    let mut u0_dot_part_2_last = u0_dot_part_2_1;
    let mut u0_dot_part_3_last = u0_dot_part_3_1;
    let mut u0_dot_part_5_last = u0_dot_part_5_1;
    let mut u0_dot_part_7_last = u0_dot_part_7_1;
    let mut u0_dot_part_8_last = u0_dot_part_8_1;
    let mut u0_dot_part_10_last = u0_dot_part_10_1;
    let mut u0_dot_part_12_last = u0_dot_part_12_1;
    let mut u0_dot_part_14_last = u0_dot_part_14_1;
    let mut u0_dot_part_16_last = u0_dot_part_16_1;
    let mut u0_dot_part_18_last = u0_dot_part_18_1;
    let mut u0_dot_part_20_last = u0_dot_part_20_1;
    let mut u0_dot_part_21_last = u0_dot_part_21_1;
    let mut u0_dot_part_23_last = u0_dot_part_23_1;
    let mut u0_dot_part_24_last = u0_dot_part_24_1;
    let mut u0_dot_part_26_last = u0_dot_part_26_1;
    let mut u0_dot_part_28_last = u0_dot_part_28_1;
    let mut u0_dot_part_30_last = u0_dot_part_30_1;
    let mut u0_dot_part_32_last = u0_dot_part_32_1;
    let mut u0_dot_part_35_last = u0_dot_part_35_1;
    let mut u0_dot_part_38_last = u0_dot_part_38_1;
    let mut u0_dot_part_40_last = u0_dot_part_40_1;
    let mut u0_dot_part_42_last = u0_dot_part_42_1;
    let mut u0_dot_part_45_last = u0_dot_part_45_1;
    let mut u0_dot_part_47_last = u0_dot_part_47_1;
    let mut u0_dot_part_49_last = u0_dot_part_49_1;
    let mut u0_dot_part_51_last = u0_dot_part_51_1;
    let mut u0_dot_part_53_last = u0_dot_part_53_1;
    let mut u0_dot_part_56_last = u0_dot_part_56_1;
    let mut u0_dot_part_58_last = u0_dot_part_58_1;
    let mut u0_dot_part_61_last = u0_dot_part_61_1;
    let mut u0_dot_part_63_last = u0_dot_part_63_1;
    let mut u0_dot_part_65_last = u0_dot_part_65_1;
    let mut u0_dot_part_67_last = u0_dot_part_67_1;
    let mut u0_dot_part_69_last = u0_dot_part_69_1;
    let mut u0_dot_part_71_last = u0_dot_part_71_1;
    let mut u0_dot_part_73_last = u0_dot_part_73_1;
    let mut u0_dot_part_75_last = u0_dot_part_75_1;
    let mut u0_dot_part_78_last = u0_dot_part_78_1;
    let mut u0_dot_part_80_last = u0_dot_part_80_1;
    let mut u0_dot_part_83_last = u0_dot_part_83_1;
    let mut u0_dot_part_86_last = u0_dot_part_86_1;
    let mut next = [S::int(0); 72];
    // Rates at order k - 1.
    let mut q1_rate = u1_1;
    let mut q2_rate = u2_1;
    let mut q3_rate = u3_1;
    let mut q0_rate = u0_1;
    let mut u1_rate = S::ratio(1, 30848) * u0_dot_part_86_1;
    let mut u2_rate = -S::ratio(1, 3588) * u0_dot_part_78_1;
    let mut u3_rate = -S::ratio(137, 8) * u0_dot_part_56_1;
    let mut u0_rate = u0_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let q0 = q0_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        let u3 = u3_rate * over_k;
        let u0 = u0_rate * over_k;
        series[order] = [q1, q2, q3, q0, u1, u2, u3, u0];
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
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[0])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[1])),
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[2])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[3])),
                q3_1.mul_add(c3_last, (count_last * q3_last).mul_add(c3_1, next[4])),
                q3_1.mul_add(s3_last, (count_last * q3_last).mul_add(s3_1, next[5])),
                (u1_1 + u1_1).mul_add(u1_last, next[6]),
                s1_1.mul_add(u1_p2_last, s1_last.mul_add(u1_p2_1, next[7])),
                (u2_1 + u2_1).mul_add(u2_last, next[8]),
                s2_1.mul_add(u2_p2_last, s2_last.mul_add(u2_p2_1, next[9])),
                (u3_1 + u3_1).mul_add(u3_last, next[10]),
                s3_1.mul_add(u3_p2_last, s3_last.mul_add(u3_p2_1, next[11])),
                c1_1.mul_add(u1_p2_last, c1_last.mul_add(u1_p2_1, next[12])),
                c2_1.mul_add(u2_p2_last, c2_last.mul_add(u2_p2_1, next[13])),
                c3_1.mul_add(u3_p2_last, c3_last.mul_add(u3_p2_1, next[14])),
                s2_1.mul_add(s3_last, s2_last.mul_add(s3_1, next[15])),
                c2_1.mul_add(c3_last, c2_last.mul_add(c3_1, next[16])),
                (c1_1 + c1_1).mul_add(c1_last, next[17]),
                s1_1.mul_add(s2_last, s1_last.mul_add(s2_1, next[18])),
                (c2_1 + c2_1).mul_add(c2_last, next[19]),
                (c3_1 + c3_1).mul_add(c3_last, next[20]),
                c1_1
                    .mul_add(
                        u0_dot_part_3_last,
                        c1_last.mul_add(u0_dot_part_3_1, next[21]),
                    ),
                c2_1
                    .mul_add(
                        sin_q1_sin_q2_last,
                        c2_last.mul_add(sin_q1_sin_q2_1, next[22]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_5_last,
                        c1_last.mul_add(u0_dot_part_5_1, next[23]),
                    ),
                s2_1.mul_add(u1_p2_last, s2_last.mul_add(u1_p2_1, next[24])),
                c2_1
                    .mul_add(
                        u0_dot_part_8_last,
                        c2_last.mul_add(u0_dot_part_8_1, next[25]),
                    ),
                c3_1
                    .mul_add(
                        sin_q2_sin_q3_last,
                        c3_last.mul_add(sin_q2_sin_q3_1, next[26]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_10_last,
                        c1_last.mul_add(u0_dot_part_10_1, next[27]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_12_last,
                        c1_last.mul_add(u0_dot_part_12_1, next[28]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_14_last,
                        c2_last.mul_add(u0_dot_part_14_1, next[29]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_16_last,
                        c2_last.mul_add(u0_dot_part_16_1, next[30]),
                    ),
                u0_dot_part_18_1
                    .mul_add(
                        cos_q1_p2_last,
                        u0_dot_part_18_last.mul_add(cos_q1_p2_1, next[31]),
                    ),
                u0_dot_part_21_1
                    .mul_add(u3_p2_last, u0_dot_part_21_last.mul_add(u3_p2_1, next[32])),
                s2_1
                    .mul_add(
                        u0_dot_part_24_last,
                        s2_last.mul_add(u0_dot_part_24_1, next[33]),
                    ),
                s3_1
                    .mul_add(
                        u0_dot_part_26_last,
                        s3_last.mul_add(u0_dot_part_26_1, next[34]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_28_last,
                        c2_last.mul_add(u0_dot_part_28_1, next[35]),
                    ),
                s3_1.mul_add(u2_p2_last, s3_last.mul_add(u2_p2_1, next[36])),
                s1_1
                    .mul_add(
                        u0_dot_part_30_last,
                        s1_last.mul_add(u0_dot_part_30_1, next[37]),
                    ),
                s2_1
                    .mul_add(
                        u0_dot_part_32_last,
                        s2_last.mul_add(u0_dot_part_32_1, next[38]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_23_last,
                        c2_last.mul_add(u0_dot_part_23_1, next[39]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_35_last,
                        c1_last.mul_add(u0_dot_part_35_1, next[40]),
                    ),
                u0_dot_part_1
                    .mul_add(u1_p2_last, u0_dot_part_last.mul_add(u1_p2_1, next[41])),
                s1_1
                    .mul_add(
                        u0_dot_part_38_last,
                        s1_last.mul_add(u0_dot_part_38_1, next[42]),
                    ),
                c3_1
                    .mul_add(
                        u0_dot_part_40_last,
                        c3_last.mul_add(u0_dot_part_40_1, next[43]),
                    ),
                s2_1
                    .mul_add(
                        u0_dot_part_42_last,
                        s2_last.mul_add(u0_dot_part_42_1, next[44]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_40_last,
                        c2_last.mul_add(u0_dot_part_40_1, next[45]),
                    ),
                s3_1
                    .mul_add(
                        u0_dot_part_45_last,
                        s3_last.mul_add(u0_dot_part_45_1, next[46]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_47_last,
                        c2_last.mul_add(u0_dot_part_47_1, next[47]),
                    ),
                s1_1
                    .mul_add(
                        u0_dot_part_49_last,
                        s1_last.mul_add(u0_dot_part_49_1, next[48]),
                    ),
                s1_1
                    .mul_add(
                        u0_dot_part_51_last,
                        s1_last.mul_add(u0_dot_part_51_1, next[49]),
                    ),
                c3_1
                    .mul_add(
                        u0_dot_part_53_last,
                        c3_last.mul_add(u0_dot_part_53_1, next[50]),
                    ),
                u0_dot_part_20_1
                    .mul_add(
                        u0_dot_part_56_last,
                        u0_dot_part_20_last.mul_add(u0_dot_part_56_1, next[51]),
                    ),
                s3_1
                    .mul_add(
                        u0_dot_part_56_last,
                        s3_last.mul_add(u0_dot_part_56_1, next[52]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_58_last,
                        c2_last.mul_add(u0_dot_part_58_1, next[53]),
                    ),
                c3_1
                    .mul_add(
                        u0_dot_part_56_last,
                        c3_last.mul_add(u0_dot_part_56_1, next[54]),
                    ),
                s2_1
                    .mul_add(
                        u0_dot_part_61_last,
                        s2_last.mul_add(u0_dot_part_61_1, next[55]),
                    ),
                s1_1
                    .mul_add(
                        u0_dot_part_63_last,
                        s1_last.mul_add(u0_dot_part_63_1, next[56]),
                    ),
                s2_1
                    .mul_add(
                        u0_dot_part_65_last,
                        s2_last.mul_add(u0_dot_part_65_1, next[57]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_67_last,
                        c2_last.mul_add(u0_dot_part_67_1, next[58]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_69_last,
                        c1_last.mul_add(u0_dot_part_69_1, next[59]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_71_last,
                        c1_last.mul_add(u0_dot_part_71_1, next[60]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_73_last,
                        c2_last.mul_add(u0_dot_part_73_1, next[61]),
                    ),
                s2_1
                    .mul_add(
                        u0_dot_part_75_last,
                        s2_last.mul_add(u0_dot_part_75_1, next[62]),
                    ),
                u0_dot_part_7_1
                    .mul_add(
                        u0_dot_part_78_last,
                        u0_dot_part_7_last.mul_add(u0_dot_part_78_1, next[63]),
                    ),
                s2_1
                    .mul_add(
                        u0_dot_part_78_last,
                        s2_last.mul_add(u0_dot_part_78_1, next[64]),
                    ),
                s1_1
                    .mul_add(
                        u0_dot_part_80_last,
                        s1_last.mul_add(u0_dot_part_80_1, next[65]),
                    ),
                c2_1
                    .mul_add(
                        u0_dot_part_78_last,
                        c2_last.mul_add(u0_dot_part_78_1, next[66]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_83_last,
                        c1_last.mul_add(u0_dot_part_83_1, next[67]),
                    ),
                u0_dot_part_2_1
                    .mul_add(
                        u0_dot_part_86_last,
                        u0_dot_part_2_last.mul_add(u0_dot_part_86_1, next[68]),
                    ),
                c1_1
                    .mul_add(
                        u0_dot_part_86_last,
                        c1_last.mul_add(u0_dot_part_86_1, next[69]),
                    ),
            ])
        };
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[0] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[1] * over_k);
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[2] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[3] * over_k);
        // s3 = sin(q3)
        let s3 = q3.mul_add(c3_0, sums[4] * over_k);
        // c3 = cos(q3)
        let c3 = -q3.mul_add(s3_0, sums[5] * over_k);
        // u1_p2 = u1*u1
        let u1_p2 = u1.mul_add(u1_0 + u1_0, sums[6]);
        // u1_p2_sin_q1 = s1*u1_p2
        let u1_p2_sin_q1 = u1_p2.mul_add(s1_0, s1.mul_add(u1_p2_0, sums[7]));
        // u2_p2 = u2*u2
        let u2_p2 = u2.mul_add(u2_0 + u2_0, sums[8]);
        // u2_p2_sin_q2 = s2*u2_p2
        let u2_p2_sin_q2 = u2_p2.mul_add(s2_0, s2.mul_add(u2_p2_0, sums[9]));
        // u3_p2 = u3*u3
        let u3_p2 = u3.mul_add(u3_0 + u3_0, sums[10]);
        // u3_p2_sin_q3 = s3*u3_p2
        let u3_p2_sin_q3 = u3_p2.mul_add(s3_0, s3.mul_add(u3_p2_0, sums[11]));
        // u1_p2_cos_q1 = c1*u1_p2
        let u1_p2_cos_q1 = u1_p2.mul_add(c1_0, c1.mul_add(u1_p2_0, sums[12]));
        // u2_p2_cos_q2 = c2*u2_p2
        let u2_p2_cos_q2 = u2_p2.mul_add(c2_0, c2.mul_add(u2_p2_0, sums[13]));
        // u3_p2_cos_q3 = c3*u3_p2
        let u3_p2_cos_q3 = u3_p2.mul_add(c3_0, c3.mul_add(u3_p2_0, sums[14]));
        // sin_q2_sin_q3 = s2*s3
        let sin_q2_sin_q3 = s3.mul_add(s2_0, s2.mul_add(s3_0, sums[15]));
        // cos_q2_cos_q3 = c2*c3
        let cos_q2_cos_q3 = c3.mul_add(c2_0, c2.mul_add(c3_0, sums[16]));
        // u0_dot_part = sin_q2_sin_q3 + cos_q2_cos_q3
        let u0_dot_part = sin_q2_sin_q3 + cos_q2_cos_q3;
        // cos_q1_p2 = c1*c1
        let cos_q1_p2 = c1.mul_add(c1_0 + c1_0, sums[17]);
        // sin_q1_sin_q2 = s1*s2
        let sin_q1_sin_q2 = s2.mul_add(s1_0, s1.mul_add(s2_0, sums[18]));
        // cos_q2_p2 = c2*c2
        let cos_q2_p2 = c2.mul_add(c2_0 + c2_0, sums[19]);
        // cos_q3_p2 = c3*c3
        let cos_q3_p2 = c3.mul_add(c3_0 + c3_0, sums[20]);
        // u0_dot_part_2 = -569 + 482*cos_q1_p2
        let u0_dot_part_2 = S::int(482) * cos_q1_p2;
        // u0_dot_part_3 = 36019 + 60030*cos_q2_p2
        let u0_dot_part_3 = S::int(60030) * cos_q2_p2;
        // u0_dot_part_4 = c1*u0_dot_part_3
        let u0_dot_part_4 = u0_dot_part_3
            .mul_add(c1_0, c1.mul_add(u0_dot_part_3_0, sums[21]));
        // sin_q1_sin_q2_cos_q2 = c2*sin_q1_sin_q2
        let sin_q1_sin_q2_cos_q2 = sin_q1_sin_q2
            .mul_add(c2_0, c2.mul_add(sin_q1_sin_q2_0, sums[22]));
        // u0_dot_part_5 = u0_dot_part_4 + 60030*sin_q1_sin_q2_cos_q2
        let u0_dot_part_5 = S::int(60030) * sin_q1_sin_q2_cos_q2 + u0_dot_part_4;
        // u0_dot_part_6 = c1*u0_dot_part_5
        let u0_dot_part_6 = u0_dot_part_5
            .mul_add(c1_0, c1.mul_add(u0_dot_part_5_0, sums[23]));
        // u0_dot_part_7 = 77953 + 30015*cos_q2_p2 - u0_dot_part_6
        let u0_dot_part_7 = S::int(30015) * cos_q2_p2 - u0_dot_part_6;
        // u1_p2_sin_q2 = s2*u1_p2
        let u1_p2_sin_q2 = u1_p2.mul_add(s2_0, s2.mul_add(u1_p2_0, sums[24]));
        // u0_dot_part_8 = -14562461 + 5593162*cos_q3_p2
        let u0_dot_part_8 = S::int(5593162) * cos_q3_p2;
        // u0_dot_part_9 = c2*u0_dot_part_8
        let u0_dot_part_9 = u0_dot_part_8
            .mul_add(c2_0, c2.mul_add(u0_dot_part_8_0, sums[25]));
        // sin_q2_sin_q3_cos_q3 = c3*sin_q2_sin_q3
        let sin_q2_sin_q3_cos_q3 = sin_q2_sin_q3
            .mul_add(c3_0, c3.mul_add(sin_q2_sin_q3_0, sums[26]));
        // u0_dot_part_10 = u0_dot_part_9 + 5593162*sin_q2_sin_q3_cos_q3
        let u0_dot_part_10 = S::int(5593162) * sin_q2_sin_q3_cos_q3 + u0_dot_part_9;
        // u0_dot_part_11 = c1*u0_dot_part_10
        let u0_dot_part_11 = u0_dot_part_10
            .mul_add(c1_0, c1.mul_add(u0_dot_part_10_0, sums[27]));
        // u0_dot_part_12 = 11765880*sin_q1_sin_q2 - u0_dot_part_11
        let u0_dot_part_12 = S::int(11765880) * sin_q1_sin_q2 - u0_dot_part_11;
        // u0_dot_part_13 = c1*u0_dot_part_12
        let u0_dot_part_13 = u0_dot_part_12
            .mul_add(c1_0, c1.mul_add(u0_dot_part_12_0, sums[28]));
        // u0_dot_part_14 = -373409 + 326608*cos_q3_p2
        let u0_dot_part_14 = S::int(326608) * cos_q3_p2;
        // u0_dot_part_15 = c2*u0_dot_part_14
        let u0_dot_part_15 = u0_dot_part_14
            .mul_add(c2_0, c2.mul_add(u0_dot_part_14_0, sums[29]));
        // u0_dot_part_16 = 9145024*sin_q2_sin_q3_cos_q3 + u0_dot_part_13 + 28*u0_dot_part_15
        let u0_dot_part_16 = u0_dot_part_15
            .mul_add(S::int(28), S::int(9145024) * sin_q2_sin_q3_cos_q3)
            + u0_dot_part_13;
        // u0_dot_part_17 = c2*u0_dot_part_16
        let u0_dot_part_17 = u0_dot_part_16
            .mul_add(c2_0, c2.mul_add(u0_dot_part_16_0, sums[30]));
        // u0_dot_part_18 = 7059724 + 2796581*cos_q3_p2
        let u0_dot_part_18 = S::int(2796581) * cos_q3_p2;
        // u0_dot_part_19 = u0_dot_part_18*cos_q1_p2
        let u0_dot_part_19 = u0_dot_part_18
            .mul_add(cos_q1_p2_0, cos_q1_p2.mul_add(u0_dot_part_18_0, sums[31]));
        // u0_dot_part_20 = 15278788 + 4572512*cos_q3_p2 - u0_dot_part_17 - u0_dot_part_19
        let u0_dot_part_20 = S::int(4572512) * cos_q3_p2 - u0_dot_part_19
            - u0_dot_part_17;
        // u0_dot_part_21 = -1 + 2*cos_q3_p2
        let u0_dot_part_21 = S::int(2) * cos_q3_p2;
        // u0_dot_part_22 = u0_dot_part_21*u3_p2
        let u0_dot_part_22 = u0_dot_part_21
            .mul_add(u3_p2_0, u3_p2.mul_add(u0_dot_part_21_0, sums[32]));
        // u0_dot_part_23 = 27500*s3 - 85347*c3
        let u0_dot_part_23 = c3.mul_add(-S::int(85347), S::int(27500) * s3);
        // u0_dot_part_24 = 1897500*s3 - 5888943*c3 - 163304*u0_dot_part_22
        let u0_dot_part_24 = u0_dot_part_22
            .mul_add(
                -S::int(163304),
                c3.mul_add(-S::int(5888943), S::int(1897500) * s3),
            );
        // u0_dot_part_25 = s2*u0_dot_part_24
        let u0_dot_part_25 = u0_dot_part_24
            .mul_add(s2_0, s2.mul_add(u0_dot_part_24_0, sums[33]));
        // u0_dot_part_26 = 5888943 + 326608*u3_p2_cos_q3
        let u0_dot_part_26 = S::int(326608) * u3_p2_cos_q3;
        // u0_dot_part_27 = s3*u0_dot_part_26
        let u0_dot_part_27 = u0_dot_part_26
            .mul_add(s3_0, s3.mul_add(u0_dot_part_26_0, sums[34]));
        // u0_dot_part_28 = 1897500*c3 + u0_dot_part_27
        let u0_dot_part_28 = S::int(1897500) * c3 + u0_dot_part_27;
        // u0_dot_part_29 = c2*u0_dot_part_28
        let u0_dot_part_29 = u0_dot_part_28
            .mul_add(c2_0, c2.mul_add(u0_dot_part_28_0, sums[35]));
        // u2_p2_sin_q3 = s3*u2_p2
        let u2_p2_sin_q3 = u2_p2.mul_add(s3_0, s3.mul_add(u2_p2_0, sums[36]));
        // u0_dot_part_30 = u0_dot_part_25 + u0_dot_part_29 + 491556*u2_p2_sin_q3
        let u0_dot_part_30 = S::int(491556) * u2_p2_sin_q3 + u0_dot_part_25
            + u0_dot_part_29;
        // u0_dot_part_31 = s1*u0_dot_part_30
        let u0_dot_part_31 = u0_dot_part_30
            .mul_add(s1_0, s1.mul_add(u0_dot_part_30_0, sums[37]));
        // u0_dot_part_32 = 85347*s3 + 27500*c3
        let u0_dot_part_32 = c3.mul_add(S::int(27500), S::int(85347) * s3);
        // u0_dot_part_33 = s2*u0_dot_part_32
        let u0_dot_part_33 = u0_dot_part_32
            .mul_add(s2_0, s2.mul_add(u0_dot_part_32_0, sums[38]));
        // u0_dot_part_34 = c2*u0_dot_part_23
        let u0_dot_part_34 = u0_dot_part_23
            .mul_add(c2_0, c2.mul_add(u0_dot_part_23_0, sums[39]));
        // u0_dot_part_35 = u0_dot_part_33 - u0_dot_part_34
        let u0_dot_part_35 = u0_dot_part_33 - u0_dot_part_34;
        // u0_dot_part_36 = c1*u0_dot_part_35
        let u0_dot_part_36 = u0_dot_part_35
            .mul_add(c1_0, c1.mul_add(u0_dot_part_35_0, sums[40]));
        // u0_dot_part_37 = u0_dot_part*u1_p2
        let u0_dot_part_37 = u0_dot_part
            .mul_add(u1_p2_0, u1_p2.mul_add(u0_dot_part_0, sums[41]));
        // u0_dot_part_38 = u0_dot_part_31 - 69*u0_dot_part_36 + 384192*u0_dot_part_37
        let u0_dot_part_38 = u0_dot_part_36
            .mul_add(-S::int(69), S::int(384192) * u0_dot_part_37) + u0_dot_part_31;
        // u0_dot_part_39 = s1*u0_dot_part_38
        let u0_dot_part_39 = u0_dot_part_38
            .mul_add(s1_0, s1.mul_add(u0_dot_part_38_0, sums[42]));
        // u0_dot_part_40 = -67689 + 4416*u1_p2_cos_q1 + 2384*u3_p2_cos_q3
        let u0_dot_part_40 = u3_p2_cos_q3
            .mul_add(S::int(2384), S::int(4416) * u1_p2_cos_q1);
        // u0_dot_part_41 = c3*u0_dot_part_40
        let u0_dot_part_41 = u0_dot_part_40
            .mul_add(c3_0, c3.mul_add(u0_dot_part_40_0, sums[43]));
        // u0_dot_part_42 = 1192*u3_p2 - u0_dot_part_41
        let u0_dot_part_42 = S::int(1192) * u3_p2 - u0_dot_part_41;
        // u0_dot_part_43 = s2*u0_dot_part_42
        let u0_dot_part_43 = u0_dot_part_42
            .mul_add(s2_0, s2.mul_add(u0_dot_part_42_0, sums[44]));
        // u0_dot_part_44 = c2*u0_dot_part_40
        let u0_dot_part_44 = u0_dot_part_40
            .mul_add(c2_0, c2.mul_add(u0_dot_part_40_0, sums[45]));
        // u0_dot_part_45 = 3588*u2_p2 + u0_dot_part_44
        let u0_dot_part_45 = S::int(3588) * u2_p2 + u0_dot_part_44;
        // u0_dot_part_46 = s3*u0_dot_part_45
        let u0_dot_part_46 = u0_dot_part_45
            .mul_add(s3_0, s3.mul_add(u0_dot_part_45_0, sums[46]));
        // u0_dot_part_47 = u0_dot_part_39 + 87*u0_dot_part_43 + 87*u0_dot_part_46
        let u0_dot_part_47 = u0_dot_part_46
            .mul_add(S::int(87), S::int(87) * u0_dot_part_43) + u0_dot_part_39;
        // u0_dot_part_48 = c2*u0_dot_part_47
        let u0_dot_part_48 = u0_dot_part_47
            .mul_add(c2_0, c2.mul_add(u0_dot_part_47_0, sums[47]));
        // u0_dot_part_49 = 474375 + 122889*u2_p2_sin_q2 + 40826*u3_p2_sin_q3
        let u0_dot_part_49 = u3_p2_sin_q3
            .mul_add(S::int(40826), S::int(122889) * u2_p2_sin_q2);
        // u0_dot_part_50 = s1*u0_dot_part_49
        let u0_dot_part_50 = u0_dot_part_49
            .mul_add(s1_0, s1.mul_add(u0_dot_part_49_0, sums[48]));
        // u0_dot_part_51 = 5888943*c1 - 384192*u1_p2 - 4*u0_dot_part_50
        let u0_dot_part_51 = u0_dot_part_50
            .mul_add(-S::int(4), u1_p2.mul_add(-S::int(384192), S::int(5888943) * c1));
        // u0_dot_part_52 = s1*u0_dot_part_51
        let u0_dot_part_52 = u0_dot_part_51
            .mul_add(s1_0, s1.mul_add(u0_dot_part_51_0, sums[49]));
        // u0_dot_part_53 = 312156*u2_p2_sin_q2 + 103704*u3_p2_sin_q3 - u0_dot_part_52
        let u0_dot_part_53 = u3_p2_sin_q3
            .mul_add(S::int(103704), S::int(312156) * u2_p2_sin_q2) - u0_dot_part_52;
        // u0_dot_part_54 = c3*u0_dot_part_53
        let u0_dot_part_54 = u0_dot_part_53
            .mul_add(c3_0, c3.mul_add(u0_dot_part_53_0, sums[50]));
        // u0_dot_part_55 = u0_dot_part_48 - u0_dot_part_54
        let u0_dot_part_55 = -u0_dot_part_54 + u0_dot_part_48;
        // u0_dot_part_56 = u0_dot_part_55/u0_dot_part_20
        let u0_dot_part_56 = u0_dot_part_55
            .mul_add(
                over_u0_dot_part_20,
                -(u0_dot_part_20.mul_add(u0_dot_part_56_0, sums[51])
                    * over_u0_dot_part_20),
            );
        // u0_dot_part_57 = s3*u0_dot_part_56
        let u0_dot_part_57 = u0_dot_part_56
            .mul_add(s3_0, s3.mul_add(u0_dot_part_56_0, sums[52]));
        // u0_dot_part_58 = -472842 + 35880*u2_p2_cos_q2 + 5960*u3_p2_cos_q3 - 102065*u0_dot_part_57
        let u0_dot_part_58 = u0_dot_part_57
            .mul_add(
                -S::int(102065),
                u3_p2_cos_q3.mul_add(S::int(5960), S::int(35880) * u2_p2_cos_q2),
            );
        // u0_dot_part_59 = c2*u0_dot_part_58
        let u0_dot_part_59 = u0_dot_part_58
            .mul_add(c2_0, c2.mul_add(u0_dot_part_58_0, sums[53]));
        // u0_dot_part_60 = c3*u0_dot_part_56
        let u0_dot_part_60 = u0_dot_part_56
            .mul_add(c3_0, c3.mul_add(u0_dot_part_56_0, sums[54]));
        // u0_dot_part_61 = 2651000 + 103704*u3_p2_sin_q3 + 1775931*u0_dot_part_60
        let u0_dot_part_61 = u0_dot_part_60
            .mul_add(S::int(1775931), S::int(103704) * u3_p2_sin_q3);
        // u0_dot_part_62 = s2*u0_dot_part_61
        let u0_dot_part_62 = u0_dot_part_61
            .mul_add(s2_0, s2.mul_add(u0_dot_part_61_0, sums[55]));
        // u0_dot_part_63 = 1560780*u2_p2 - 87*u0_dot_part_59 + 5*u0_dot_part_62
        let u0_dot_part_63 = u0_dot_part_62
            .mul_add(
                S::int(5),
                u0_dot_part_59.mul_add(-S::int(87), S::int(1560780) * u2_p2),
            );
        // u0_dot_part_64 = s1*u0_dot_part_63
        let u0_dot_part_64 = u0_dot_part_63
            .mul_add(s1_0, s1.mul_add(u0_dot_part_63_0, sums[56]));
        // u0_dot_part_65 = -2838470526 + 215387640*u2_p2_cos_q2 - 42934648*u3_p2_cos_q3 +
        //   735255847*u0_dot_part_57
        let u0_dot_part_65 = u0_dot_part_57
            .mul_add(
                S::int(735255847),
                u3_p2_cos_q3.mul_add(-S::int(42934648), S::int(215387640) * u2_p2_cos_q2),
            );
        // u0_dot_part_66 = s2*u0_dot_part_65
        let u0_dot_part_66 = u0_dot_part_65
            .mul_add(s2_0, s2.mul_add(u0_dot_part_65_0, sums[57]));
        // u0_dot_part_67 = 914595000 + 114490408*u3_p2_sin_q3 + 1960648237*u0_dot_part_60
        let u0_dot_part_67 = u0_dot_part_60
            .mul_add(S::int(1960648237), S::int(114490408) * u3_p2_sin_q3);
        // u0_dot_part_68 = c2*u0_dot_part_67
        let u0_dot_part_68 = u0_dot_part_67
            .mul_add(c2_0, c2.mul_add(u0_dot_part_67_0, sums[58]));
        // u0_dot_part_69 = u0_dot_part_66 + u0_dot_part_68
        let u0_dot_part_69 = u0_dot_part_66 + u0_dot_part_68;
        // u0_dot_part_70 = c1*u0_dot_part_69
        let u0_dot_part_70 = u0_dot_part_69
            .mul_add(c1_0, c1.mul_add(u0_dot_part_69_0, sums[59]));
        // u0_dot_part_71 = 185180544*u1_p2_sin_q2 + 69*u0_dot_part_64 + u0_dot_part_70
        let u0_dot_part_71 = u0_dot_part_64
            .mul_add(S::int(69), S::int(185180544) * u1_p2_sin_q2) + u0_dot_part_70;
        // u0_dot_part_72 = c1*u0_dot_part_71
        let u0_dot_part_72 = u0_dot_part_71
            .mul_add(c1_0, c1.mul_add(u0_dot_part_71_0, sums[60]));
        // u0_dot_part_73 = 228648750 + 46295136*u1_p2_sin_q1 + 26923455*u2_p2_sin_q2 +
        //   32174464*u3_p2_sin_q3 + 550987696*u0_dot_part_60
        let u0_dot_part_73 = u0_dot_part_60
            .mul_add(
                S::int(550987696),
                u3_p2_sin_q3
                    .mul_add(
                        S::int(32174464),
                        u2_p2_sin_q2
                            .mul_add(S::int(26923455), S::int(46295136) * u1_p2_sin_q1),
                    ),
            );
        // u0_dot_part_74 = c2*u0_dot_part_73
        let u0_dot_part_74 = u0_dot_part_73
            .mul_add(c2_0, c2.mul_add(u0_dot_part_73_0, sums[61]));
        // u0_dot_part_75 = 8*u3_p2_cos_q3 - 137*u0_dot_part_57
        let u0_dot_part_75 = u0_dot_part_57
            .mul_add(-S::int(137), S::int(8) * u3_p2_cos_q3);
        // u0_dot_part_76 = s2*u0_dot_part_75
        let u0_dot_part_76 = u0_dot_part_75
            .mul_add(s2_0, s2.mul_add(u0_dot_part_75_0, sums[62]));
        // u0_dot_part_77 = u0_dot_part_72 - 4*u0_dot_part_74 + 11614997*u0_dot_part_76
        let u0_dot_part_77 = u0_dot_part_76
            .mul_add(S::int(11614997), -S::int(4) * u0_dot_part_74) + u0_dot_part_72;
        // u0_dot_part_78 = u0_dot_part_77/u0_dot_part_7
        let u0_dot_part_78 = u0_dot_part_77
            .mul_add(
                over_u0_dot_part_7,
                -(u0_dot_part_7.mul_add(u0_dot_part_78_0, sums[63]) * over_u0_dot_part_7),
            );
        // u0_dot_part_79 = s2*u0_dot_part_78
        let u0_dot_part_79 = u0_dot_part_78
            .mul_add(s2_0, s2.mul_add(u0_dot_part_78_0, sums[64]));
        // u0_dot_part_80 = -269047098 + 14868736*u1_p2_cos_q1 + 10207860*u2_p2_cos_q2 +
        //   3391240*u3_p2_cos_q3 - 58074985*u0_dot_part_57 - 2845*u0_dot_part_79
        let u0_dot_part_80 = u0_dot_part_79
            .mul_add(
                -S::int(2845),
                u0_dot_part_57
                    .mul_add(
                        -S::int(58074985),
                        u3_p2_cos_q3
                            .mul_add(
                                S::int(3391240),
                                u2_p2_cos_q2
                                    .mul_add(S::int(10207860), S::int(14868736) * u1_p2_cos_q1),
                            ),
                    ),
            );
        // u0_dot_part_81 = s1*u0_dot_part_80
        let u0_dot_part_81 = u0_dot_part_80
            .mul_add(s1_0, s1.mul_add(u0_dot_part_80_0, sums[65]));
        // u0_dot_part_82 = c2*u0_dot_part_78
        let u0_dot_part_82 = u0_dot_part_78
            .mul_add(c2_0, c2.mul_add(u0_dot_part_78_0, sums[66]));
        // u0_dot_part_83 = 2651000 + 312156*u2_p2_sin_q2 + 103704*u3_p2_sin_q3 + 1775931*u0_dot_part_60 +
        //   87*u0_dot_part_82
        let u0_dot_part_83 = u0_dot_part_82
            .mul_add(
                S::int(87),
                u0_dot_part_60
                    .mul_add(
                        S::int(1775931),
                        u3_p2_sin_q3
                            .mul_add(S::int(103704), S::int(312156) * u2_p2_sin_q2),
                    ),
            );
        // u0_dot_part_84 = c1*u0_dot_part_83
        let u0_dot_part_84 = u0_dot_part_83
            .mul_add(c1_0, c1.mul_add(u0_dot_part_83_0, sums[67]));
        // u0_dot_part_85 = u0_dot_part_81 - 5*u0_dot_part_84
        let u0_dot_part_85 = u0_dot_part_84.mul_add(-S::int(5), u0_dot_part_81);
        // u0_dot_part_86 = u0_dot_part_85/u0_dot_part_2
        let u0_dot_part_86 = u0_dot_part_85
            .mul_add(
                over_u0_dot_part_2,
                -(u0_dot_part_2.mul_add(u0_dot_part_86_0, sums[68]) * over_u0_dot_part_2),
            );
        // u0_dot_part_87 = c1*u0_dot_part_86
        let u0_dot_part_87 = u0_dot_part_86
            .mul_add(c1_0, c1.mul_add(u0_dot_part_86_0, sums[69]));
        // u0_dot_2 = 275/569 - 7712/14225*u1_p2_sin_q1 - 897/2845*u2_p2_sin_q2 - 298/2845*u3_p2_sin_q3 -
        //   20413/11380*u0_dot_part_60 - 1/11380*u0_dot_part_82 + 1/56900*u0_dot_part_87
        let u0_dot_2 = u0_dot_part_87
            .mul_add(
                S::ratio(1, 56900),
                u0_dot_part_82
                    .mul_add(
                        -S::ratio(1, 11380),
                        u0_dot_part_60
                            .mul_add(
                                -S::ratio(20413, 11380),
                                u3_p2_sin_q3
                                    .mul_add(
                                        -S::ratio(298, 2845),
                                        u2_p2_sin_q2
                                            .mul_add(
                                                -S::ratio(897, 2845),
                                                -S::ratio(7712, 14225) * u1_p2_sin_q1,
                                            ),
                                    ),
                            ),
                    ),
            );
        q1_rate = u1;
        q2_rate = u2;
        q3_rate = u3;
        q0_rate = u0;
        u1_rate = S::ratio(1, 30848) * u0_dot_part_86;
        u2_rate = -S::ratio(1, 3588) * u0_dot_part_78;
        u3_rate = -S::ratio(137, 8) * u0_dot_part_56;
        u0_rate = u0_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q1,
                count * q1,
                count * q2,
                count * q2,
                count * q3,
                count * q3,
                u1,
                s1,
                u2,
                s2,
                u3,
                s3,
                c1,
                c2,
                c3,
                s2,
                c2,
                c1,
                s1,
                c2,
                c3,
                c1,
                c2,
                c1,
                s2,
                c2,
                c3,
                c1,
                c1,
                c2,
                c2,
                u0_dot_part_18,
                u0_dot_part_21,
                s2,
                s3,
                c2,
                s3,
                s1,
                s2,
                c2,
                c1,
                u0_dot_part,
                s1,
                c3,
                s2,
                c2,
                s3,
                c2,
                s1,
                s1,
                c3,
                u0_dot_part_20,
                s3,
                c2,
                c3,
                s2,
                s1,
                s2,
                c2,
                c1,
                c1,
                c2,
                s2,
                u0_dot_part_7,
                s2,
                s1,
                c2,
                c1,
                u0_dot_part_2,
                c1,
            ]),
            padded([
                c1,
                s1,
                c2,
                s2,
                c3,
                s3,
                u1,
                u1_p2,
                u2,
                u2_p2,
                u3,
                u3_p2,
                u1_p2,
                u2_p2,
                u3_p2,
                s3,
                c3,
                c1,
                s2,
                c2,
                c3,
                u0_dot_part_3,
                sin_q1_sin_q2,
                u0_dot_part_5,
                u1_p2,
                u0_dot_part_8,
                sin_q2_sin_q3,
                u0_dot_part_10,
                u0_dot_part_12,
                u0_dot_part_14,
                u0_dot_part_16,
                cos_q1_p2,
                u3_p2,
                u0_dot_part_24,
                u0_dot_part_26,
                u0_dot_part_28,
                u2_p2,
                u0_dot_part_30,
                u0_dot_part_32,
                u0_dot_part_23,
                u0_dot_part_35,
                u1_p2,
                u0_dot_part_38,
                u0_dot_part_40,
                u0_dot_part_42,
                u0_dot_part_40,
                u0_dot_part_45,
                u0_dot_part_47,
                u0_dot_part_49,
                u0_dot_part_51,
                u0_dot_part_53,
                u0_dot_part_56,
                u0_dot_part_56,
                u0_dot_part_58,
                u0_dot_part_56,
                u0_dot_part_61,
                u0_dot_part_63,
                u0_dot_part_65,
                u0_dot_part_67,
                u0_dot_part_69,
                u0_dot_part_71,
                u0_dot_part_73,
                u0_dot_part_75,
                u0_dot_part_78,
                u0_dot_part_78,
                u0_dot_part_80,
                u0_dot_part_78,
                u0_dot_part_83,
                u0_dot_part_86,
                u0_dot_part_86,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        q3_last = q3;
        u1_last = u1;
        u2_last = u2;
        u3_last = u3;
        s1_last = s1;
        c1_last = c1;
        s2_last = s2;
        c2_last = c2;
        s3_last = s3;
        c3_last = c3;
        u1_p2_last = u1_p2;
        u2_p2_last = u2_p2;
        u3_p2_last = u3_p2;
        sin_q2_sin_q3_last = sin_q2_sin_q3;
        u0_dot_part_last = u0_dot_part;
        cos_q1_p2_last = cos_q1_p2;
        sin_q1_sin_q2_last = sin_q1_sin_q2;
        u0_dot_part_2_last = u0_dot_part_2;
        u0_dot_part_3_last = u0_dot_part_3;
        u0_dot_part_5_last = u0_dot_part_5;
        u0_dot_part_7_last = u0_dot_part_7;
        u0_dot_part_8_last = u0_dot_part_8;
        u0_dot_part_10_last = u0_dot_part_10;
        u0_dot_part_12_last = u0_dot_part_12;
        u0_dot_part_14_last = u0_dot_part_14;
        u0_dot_part_16_last = u0_dot_part_16;
        u0_dot_part_18_last = u0_dot_part_18;
        u0_dot_part_20_last = u0_dot_part_20;
        u0_dot_part_21_last = u0_dot_part_21;
        u0_dot_part_23_last = u0_dot_part_23;
        u0_dot_part_24_last = u0_dot_part_24;
        u0_dot_part_26_last = u0_dot_part_26;
        u0_dot_part_28_last = u0_dot_part_28;
        u0_dot_part_30_last = u0_dot_part_30;
        u0_dot_part_32_last = u0_dot_part_32;
        u0_dot_part_35_last = u0_dot_part_35;
        u0_dot_part_38_last = u0_dot_part_38;
        u0_dot_part_40_last = u0_dot_part_40;
        u0_dot_part_42_last = u0_dot_part_42;
        u0_dot_part_45_last = u0_dot_part_45;
        u0_dot_part_47_last = u0_dot_part_47;
        u0_dot_part_49_last = u0_dot_part_49;
        u0_dot_part_51_last = u0_dot_part_51;
        u0_dot_part_53_last = u0_dot_part_53;
        u0_dot_part_56_last = u0_dot_part_56;
        u0_dot_part_58_last = u0_dot_part_58;
        u0_dot_part_61_last = u0_dot_part_61;
        u0_dot_part_63_last = u0_dot_part_63;
        u0_dot_part_65_last = u0_dot_part_65;
        u0_dot_part_67_last = u0_dot_part_67;
        u0_dot_part_69_last = u0_dot_part_69;
        u0_dot_part_71_last = u0_dot_part_71;
        u0_dot_part_73_last = u0_dot_part_73;
        u0_dot_part_75_last = u0_dot_part_75;
        u0_dot_part_78_last = u0_dot_part_78;
        u0_dot_part_80_last = u0_dot_part_80;
        u0_dot_part_83_last = u0_dot_part_83;
        u0_dot_part_86_last = u0_dot_part_86;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn parameters(&self) -> usize {
        0
    }
    fn coordinates(&self) -> usize {
        4
    }
    fn speeds(&self) -> usize {
        4
    }
    fn reactions(&self) -> usize {
        0
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn output_count(&self) -> usize {
        8
    }
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&outputs(&Parameters::from_slice(p), t, array(q), array(v)));
    }
    fn has_energy_gradient(&self) -> bool {
        true
    }
    fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
        let [energy, gradient @ ..] = energy_gradient(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        out.copy_from_slice(&gradient);
        energy
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
        144 * order + SLACK
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        let x = &mut x.as_chunks_mut().0[..=order];
        taylor(&Parameters::from_slice(p), x, rows(work));
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

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "fall",
    key: "a2b764e3cf11e50c",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
