//! Sine and cosine of `f64` and of lanes against numbers of 32 digits, which are held against an arbitrary-precision
//! library in `double_double.rs`.
//!
//! `TRIPOS_ARGUMENTS=10000000 cargo test --release -p tripos-traits --test circular -- --nocapture` prints the errors
//! that the documentation states.

#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]

use crate::random::Random;
use tripos_traits::{DoubleDouble, Lanes, Real, Scalar};

/// Up to here arguments are reduced fast.
const FAST: f64 = 262_144.0;
/// Largest error that the documentation of `Scalar::sin_cos` states, in ulp.
const BOUND: f64 = 0.9;

fn arguments() -> usize {
    std::env::var("TRIPOS_ARGUMENTS").ok().and_then(|n| n.parse().ok()).unwrap_or(200_000)
}

/// The spacing of doubles of the size of `x`.
fn ulp(x: f64) -> f64 {
    x.abs().next_up() - x.abs()
}

/// got − wanted| in ulp of the wanted number.
fn error(got: f64, wanted: DoubleDouble) -> f64 {
    (DoubleDouble::from(got) - wanted).to_f64().abs() / ulp(wanted.to_f64())
}

/// The largest errors of sine and cosine, in `f64` and in lanes.
#[derive(Clone, Copy, Default)]
struct Largest {
    double: [f64; 2],
    lanes: [f64; 2],
}

impl Largest {
    fn note(&mut self, arguments: [f64; 8]) {
        let lanes = Lanes::<8>::dispatch(|| Lanes(arguments).sin_cos());
        for (l, x) in arguments.into_iter().enumerate() {
            let wanted = DoubleDouble::from(x).sin_cos();
            let double = Scalar::sin_cos(x);
            let larger = |old: &mut f64, got: f64, wanted| *old = old.max(error(got, wanted));
            larger(&mut self.double[0], double.0, wanted.0);
            larger(&mut self.double[1], double.1, wanted.1);
            larger(&mut self.lanes[0], lanes.0.0[l], wanted.0);
            larger(&mut self.lanes[1], lanes.1.0[l], wanted.1);
        }
    }

    fn check(self, what: &str) {
        println!("{what}: sine and cosine {:.4?} ulp, in lanes {:.4?}", self.double, self.lanes);
        assert!(self.double.into_iter().chain(self.lanes).all(|e| e < BOUND), "{what}");
    }
}

fn largest(mut draw: impl FnMut() -> f64) -> Largest {
    let mut largest = Largest::default();
    for _ in 0..arguments() / 8 {
        largest.note(std::array::from_fn(|_| draw()));
    }
    largest
}

#[test]
fn angles_of_every_size_are_within_the_bound() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    largest(|| 2.0 * FAST * (random.unit() - 0.5)).check("up to 2^18");
    largest(|| 8.0 * (random.unit() - 0.5)).check("up to 4");
    largest(|| random.of_size(-20.0, 5.0)).check("of every size");
}

/// Goal: the relative error where a sine or cosine vanishes, as on a passage near a singular surface. Method: multiples
/// of π/2 with offsets of every size.
#[test]
fn small_values_keep_their_digits() {
    let mut random = Random(0xD1B5_4A32_D192_ED03);
    let quarter = DoubleDouble::pi() / DoubleDouble::int(2);
    for (turns, what) in [(20.0, "near the first zeros"), (166_000.0, "near zeros up to 2^18")] {
        let near_zero = || {
            let n = DoubleDouble::from((turns * (2.0 * random.unit() - 1.0)).round());
            (n * quarter + DoubleDouble::from(random.of_size(-17.0, -1.0))).to_f64()
        };
        largest(near_zero).check(what);
    }
}

/// Every multiple of π/2 in the range: the two doubles around it, one of them the hardest there is.
#[test]
fn no_multiple_of_a_quarter_turn_in_the_range_is_too_hard() {
    let quarter = DoubleDouble::pi() / DoubleDouble::int(2);
    let mut largest = Largest::default();
    // Five in a debug build, which is slow; a number without a factor 2, so that all quadrants are met.
    let stride = if cfg!(debug_assertions) { 5 } else { 1 };
    for n in (1..166_886).step_by(stride) {
        let x = (DoubleDouble::int(n) * quarter).to_f64();
        let x = x.min(FAST);
        let (below, above) = (x.next_down(), x.next_up().min(FAST));
        largest.note([x, below, above, -x, -below, -above, 0.5 * x, -0.5 * x]);
    }
    largest.check("neighbours of multiples");
}

#[test]
fn the_edge_of_the_range_is_no_edge_of_the_values() {
    for x in [FAST, FAST.next_up(), FAST.next_down(), 1e6, 1e15, 1e22, 1e300, f64::MAX] {
        let (sine, cosine) = libm::sincos(x);
        for x in [x, -x] {
            let sine = if x < 0.0 { -sine } else { sine };
            let near = |got: (f64, f64)| (got.0 - sine).abs() <= ulp(sine) && (got.1 - cosine).abs() <= ulp(cosine);
            assert!(near(Scalar::sin_cos(x)), "{x}");
            let (s, c) = Lanes([1.0, x, 2.0, x]).sin_cos();
            assert!(near((s.0[1], c.0[1])) && near((s.0[3], c.0[3])), "{x}");
            assert_eq!([s.0[0], s.0[2]], Lanes([1.0, 2.0]).sin_cos().0.0, "neighbours of {x}");
        }
    }
}

#[test]
fn what_has_no_angle_has_no_sine() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (sine, cosine) = Scalar::sin_cos(x);
        assert!(sine.is_nan() && cosine.is_nan(), "{x}");
        let (sine, cosine) = Lanes([0.25, x, 0.5, 0.75]).sin_cos();
        assert!(sine.0[1].is_nan() && cosine.0[1].is_nan(), "{x}");
        assert!([0, 2, 3].into_iter().all(|l| sine.0[l].is_finite() && cosine.0[l].is_finite()), "{x}");
    }
}

#[test]
fn zeros_and_tiny_angles_are_their_own_sines() {
    for x in [0.0_f64, -0.0, 5e-324, -5e-324, 1e-308, -1e-308, 1e-20, -1e-9] {
        let (sine, cosine) = Scalar::sin_cos(x);
        assert_eq!((sine.to_bits(), cosine), (x.to_bits(), 1.0), "{x}");
        let (sine, cosine) = Lanes([x; 4]).sin_cos();
        assert_eq!((sine.0[3].to_bits(), cosine.0[3]), (x.to_bits(), 1.0), "{x} in lanes");
    }
}
