//! `DoubleDouble` against an arbitrary-precision library, and its edges.
//!
//! Errors are in units of `DoubleDouble::EPSILON`, bounds about twice the largest met with 300 000 arguments;
//! `TRIPOS_ARGUMENTS=300000 cargo test --release -p tripos-traits -- --nocapture` prints those.

#![allow(clippy::float_cmp, reason = "exact answers are compared exactly")]
#![allow(clippy::cast_possible_truncation, reason = "parts of whole numbers")]

use crate::random::Random;
use astro_float_num::{BigFloat, Consts, RoundingMode};
use std::cell::RefCell;
use tripos_traits::{DoubleDouble, Real, Scalar};

const BITS: usize = 320;
const NEAREST: RoundingMode = RoundingMode::ToEven;

type Unary = (fn(DoubleDouble) -> DoubleDouble, fn(&BigFloat, &mut Consts) -> BigFloat);

/// Number of arguments that each function is tried with.
fn arguments() -> usize {
    std::env::var("TRIPOS_ARGUMENTS").ok().and_then(|n| n.parse().ok()).unwrap_or(3_000)
}

fn exactly(x: DoubleDouble) -> BigFloat {
    BigFloat::from_f64(x.hi(), BITS).add(&BigFloat::from_f64(x.lo(), BITS), BITS, NEAREST)
}

fn nearest_f64(x: &BigFloat) -> f64 {
    x.to_string().parse().expect("the library prints a number")
}

/// |got − wanted| / |scale|, in units of EPSILON.
fn error(got: DoubleDouble, wanted: &BigFloat, scale: &BigFloat) -> f64 {
    let difference = exactly(got).sub(wanted, BITS, NEAREST);
    if difference.is_zero() {
        return 0.0;
    }
    nearest_f64(&difference.div(scale, BITS, NEAREST)).abs() / DoubleDouble::EPSILON
}

fn relative_error(got: DoubleDouble, wanted: &BigFloat) -> f64 {
    error(got, wanted, wanted)
}

impl Random {
    /// In [a, b], both parts filled.
    fn between(&mut self, a: f64, b: f64) -> DoubleDouble {
        let hi = a + (b - a) * self.unit();
        DoubleDouble::sum(hi, hi * (self.unit() - 0.5) * f64::EPSILON)
    }

    /// Random number of either sign, its size between 10ᵃ and 10ᵇ, both parts filled.
    fn wide_of_size(&mut self, a: f64, b: f64) -> DoubleDouble {
        let size = 10_f64.powf(a + (b - a) * self.unit());
        let x = DoubleDouble::sum(size, size * (self.unit() - 0.5) * f64::EPSILON);
        if self.unit() < 0.5 { -x } else { x }
    }
}

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("memory for constants"));
}

/// The largest relative error of a function over arguments that `draw` gives.
fn largest_error((ours, oracle): Unary, mut draw: impl FnMut(&mut Random) -> DoubleDouble) -> f64 {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let errors = (0..arguments()).map(|_| {
        let x = draw(&mut random);
        let wanted = CONSTANTS.with_borrow_mut(|constants| oracle(&exactly(x), constants));
        relative_error(ours(x), &wanted)
    });
    let largest = errors.fold(0.0, f64::max);
    println!("largest error {largest:.2} EPSILON");
    largest
}

const EXP: Unary = (Scalar::exp, |x, c| x.exp(BITS, NEAREST, c));
const LN: Unary = (Scalar::ln, |x, c| x.ln(BITS, NEAREST, c));
const SIN: Unary = (|x| x.sin_cos().0, |x, c| x.sin(BITS, NEAREST, c));
const COS: Unary = (|x| x.sin_cos().1, |x, c| x.cos(BITS, NEAREST, c));
const ASIN: Unary = (Scalar::asin, |x, c| x.asin(BITS, NEAREST, c));
const ACOS: Unary = (Scalar::acos, |x, c| x.acos(BITS, NEAREST, c));
const ATAN: Unary = (Scalar::atan, |x, c| x.atan(BITS, NEAREST, c));
const SINH: Unary = (Scalar::sinh, |x, c| x.sinh(BITS, NEAREST, c));
const COSH: Unary = (Scalar::cosh, |x, c| x.cosh(BITS, NEAREST, c));
const TANH: Unary = (Scalar::tanh, |x, c| x.tanh(BITS, NEAREST, c));
const SQRT: Unary = (Scalar::sqrt, |x, _| x.sqrt(BITS, NEAREST));

#[test]
fn sums_products_and_quotients_are_within_two_units() {
    let mut random = Random(1);
    let mut largest = [0.0_f64; 4];
    for _ in 0..arguments() {
        let (a, b) = (random.wide_of_size(-3.0, 3.0), random.wide_of_size(-3.0, 3.0));
        let (x, y) = (exactly(a), exactly(b));
        let errors = [
            relative_error(a + b, &x.add(&y, BITS, NEAREST)),
            relative_error(a - b, &x.sub(&y, BITS, NEAREST)),
            relative_error(a * b, &x.mul(&y, BITS, NEAREST)),
            relative_error(a / b, &x.div(&y, BITS, NEAREST)),
        ];
        for (largest, error) in largest.iter_mut().zip(errors) {
            *largest = largest.max(error);
        }
    }
    println!("largest errors {largest:.2?} EPSILON");
    assert!(largest.iter().all(|&error| error < 2.0), "{largest:?}");
}

/// Operands of opposite sign whose leading parts cancel: simple double-double addition loses their digits.
#[test]
fn a_difference_of_neighbours_keeps_its_digits() {
    let mut random = Random(2);
    for _ in 0..arguments() {
        let a = random.between(1.0, 2.0);
        let b = DoubleDouble::sum(a.hi(), a.lo() * random.unit());
        let wanted = exactly(a).sub(&exactly(b), BITS, NEAREST);
        assert!(relative_error(a - b, &wanted) <= 1.0, "{a} - {b}");
    }
}

#[test]
fn sqrt_is_within_two_units() {
    assert!(largest_error(SQRT, |random| random.wide_of_size(-200.0, 200.0).abs()) < 2.0);
}

#[test]
fn exp_is_within_two_units_over_its_range() {
    assert!(largest_error(EXP, |random| random.between(-600.0, 700.0)) < 2.0);
    assert!(largest_error(EXP, |random| random.wide_of_size(-20.0, 0.0)) < 2.0);
}

#[test]
fn ln_is_within_two_units_also_next_to_1() {
    assert!(largest_error(LN, |random| random.wide_of_size(-250.0, 250.0).abs()) < 2.0);
    assert!(largest_error(LN, |random| random.between(0.5, 2.0)) < 2.0);
    assert!(largest_error(LN, |random| random.wide_of_size(-25.0, -1.0) + DoubleDouble::int(1)) < 2.0);
}

/// The relative error, so that it holds next to multiples of π too.
#[test]
fn sine_and_cosine_are_within_two_units_up_to_1e5() {
    for function in [SIN, COS] {
        assert!(largest_error(function, |random| random.between(-1.0, 1.0)) < 2.0);
        assert!(largest_error(function, |random| random.wide_of_size(-25.0, 5.0)) < 2.0);
    }
}

#[test]
fn sine_and_cosine_next_to_quarter_turns_are_within_two_units() {
    for function in [SIN, COS] {
        let near_quarter_turn = |random: &mut Random| {
            let quarters = DoubleDouble::from_f64((random.unit() * 60_000.0).floor());
            quarters * DoubleDouble::pi() / DoubleDouble::int(2) + random.wide_of_size(-20.0, -3.0)
        };
        assert!(largest_error(function, near_quarter_turn) < 2.0);
    }
}

#[test]
fn sine_and_cosine_are_within_1e31_absolute_up_to_2_to_the_40() {
    let mut random = Random(3);
    for _ in 0..arguments() {
        let x = random.wide_of_size(5.0, 12.0);
        let (sin, cos) = x.sin_cos();
        let one = BigFloat::from_f64(1.0, BITS);
        let wanted = CONSTANTS.with_borrow_mut(|c| (SIN.1(&exactly(x), c), COS.1(&exactly(x), c)));
        assert!(error(sin, &wanted.0, &one) < 2.0 && error(cos, &wanted.1, &one) < 2.0, "{x}");
    }
}

/// 64 ε of f64: of the angle's parts each turns by what libm computes, and the results are combined in f64.
#[test]
fn sine_and_cosine_of_astronomical_angles_have_the_digits_of_f64() {
    let mut random = Random(4);
    for _ in 0..300 {
        let x = random.wide_of_size(12.1, 60.0);
        let (sin, _) = x.sin_cos();
        let wanted = nearest_f64(&CONSTANTS.with_borrow_mut(|c| exactly(x).sin(640, NEAREST, c)));
        assert!((sin.to_f64() - wanted).abs() < 64.0 * f64::EPSILON, "{x}: {sin} {wanted}");
    }
}

#[test]
fn inverse_circular_functions_are_within_three_units() {
    assert!(largest_error(ATAN, |random| random.wide_of_size(-20.0, 20.0)) < 3.0);
    assert!(largest_error(ASIN, |random| random.between(-1.0, 1.0)) < 3.0);
    assert!(largest_error(ASIN, |random| random.wide_of_size(-20.0, 0.0)) < 3.0);
    assert!(largest_error(ACOS, |random| random.between(-1.0, 1.0)) < 3.0);
    assert!(largest_error(ACOS, |random| DoubleDouble::int(1) - random.wide_of_size(-25.0, 0.0).abs()) < 3.0);
    assert!(largest_error(ASIN, |random| random.wide_of_size(-25.0, 0.0).abs() - DoubleDouble::int(1)) < 3.0);
}

#[test]
fn hyperbolic_functions_are_within_three_units_also_next_to_0() {
    for function in [SINH, COSH, TANH] {
        assert!(largest_error(function, |random| random.wide_of_size(-25.0, 1.0)) < 3.0);
        assert!(largest_error(function, |random| random.between(-45.0, 45.0)) < 3.0);
    }
    assert!(largest_error(SINH, |random| random.between(600.0, 710.4)) < 3.0);
    assert!(largest_error(COSH, |random| random.between(-710.4, -600.0)) < 3.0);
}

/// Each side rounds: 4 units cover two functions and one operation.
#[test]
fn functions_satisfy_their_identities() {
    let mut random = Random(5);
    let one = DoubleDouble::int(1);
    let two = DoubleDouble::int(2);
    let close = |a: DoubleDouble, b: DoubleDouble| ((a - b) / b).abs().to_f64() < 4.0 * DoubleDouble::EPSILON;
    for _ in 0..arguments() {
        let x = random.between(-1.0, 1.0);
        let (sin, cos) = (x * DoubleDouble::int(1000)).sin_cos();
        assert!(close(sin * sin + cos * cos, one));
        assert!(close(x.sinh() + x.cosh(), x.exp()));
        assert!(close(x.exp().ln() + two, x + two));
        assert!(close(x.abs().ln().exp(), x.abs()));
        assert!(close(x.abs().sqrt() * x.abs().sqrt(), x.abs()));
        assert!(close(x.asin() + x.acos() + x.atan(), DoubleDouble::pi() / DoubleDouble::int(2) + x.atan()));
    }
}

/// A quotient, ten products and the last: 12 units.
#[test]
fn powers_and_inverse_powers_cancel() {
    let mut random = Random(7);
    for _ in 0..arguments() {
        let x = random.wide_of_size(-3.0, 3.0);
        let rest = x.powi(7) * x.powi(-7) - DoubleDouble::int(1);
        assert!(rest.abs().to_f64() < 12.0 * DoubleDouble::EPSILON, "{x}");
    }
    assert_eq!(DoubleDouble::int(3).powi(-2), DoubleDouble::int(1) / DoubleDouble::int(3) / DoubleDouble::int(3));
    assert_eq!(DoubleDouble::int(0).powi(0), DoubleDouble::int(1));
}

#[test]
fn pi_is_pi() {
    let wanted = CONSTANTS.with_borrow_mut(|c| c.pi(BITS, NEAREST));
    assert!(relative_error(DoubleDouble::pi(), &wanted) < 0.5);
}

#[test]
fn decimals_are_read_to_full_precision() {
    let read = |text: &str| {
        CONSTANTS.with_borrow_mut(|c| BigFloat::parse(text, astro_float_num::Radix::Dec, BITS, NEAREST, c))
    };
    for (text, bound) in [
        ("0.1", 2.0),
        ("-5.26e-2", 2.0),
        ("3.14159265358979323846264338327950288419716939937510", 2.0),
        ("+00012345678901234567890123456789012345678901234567890.5", 2.0),
        ("0.000000000000000000000000000000123456789012345678901234567890123", 2.0),
        (".5", 0.0001),
        ("7.", 0.0001),
        ("1e22", 0.0001),
        ("6.02214076E+23", 2.0),
        ("1.0e-100", 16.0),
        ("9.87654321098765432109876543210987e280", 16.0),
    ] {
        assert!(relative_error(DoubleDouble::decimal(text), &read(text)) < bound, "{text}");
    }
    for text in ["", "x", "1.2.3", "1e", "--1", "0x10", "1 2", "e5", "nan"] {
        assert!(DoubleDouble::decimal(text).hi().is_nan(), "{text}");
    }
    assert_eq!(DoubleDouble::decimal("1e999"), DoubleDouble::INFINITY);
    assert_eq!(DoubleDouble::decimal("-1e-999").hi(), 0.0);
}

#[test]
fn display_prints_32_digits_that_read_back() {
    assert_eq!(DoubleDouble::pi().to_string(), "3.1415926535897932384626433832795e0");
    assert_eq!(format!("{:.5}", -DoubleDouble::pi()), "-3.14159e0");
    assert_eq!(format!("{:.2}", DoubleDouble::decimal("9.999")), "1.00e1");
    assert_eq!(DoubleDouble::decimal("1e-30").to_string(), "1.0000000000000000000000000000000e-30");
    assert_eq!(DoubleDouble::int(-1000).to_string(), "-1.0000000000000000000000000000000e3");
    assert_eq!(DoubleDouble::NAN.to_string(), "NaN");
    assert_eq!((-DoubleDouble::INFINITY).to_string(), "-inf");
    let mut random = Random(6);
    for _ in 0..arguments() {
        let x = random.wide_of_size(-15.0, 15.0);
        let back = DoubleDouble::decimal(&format!("{x:.32}"));
        assert!(((back - x) / x).abs().to_f64() < 4.0 * DoubleDouble::EPSILON, "{x} {back}");
    }
}

#[test]
fn whole_numbers_and_ratios_are_exact_where_they_can_be() {
    for n in [0, 1, -7, i64::MAX, i64::MIN, (1 << 53) + 1] {
        assert_eq!(DoubleDouble::int(n).hi() as i128 + DoubleDouble::int(n).lo() as i128, i128::from(n));
    }
    let third = BigFloat::from_f64(1.0, BITS).div(&BigFloat::from_f64(3.0, BITS), BITS, NEAREST);
    assert!(relative_error(DoubleDouble::ratio(1, 3), &third) < 1.0);
    assert!(DoubleDouble::ratio(0, 0).hi().is_nan());
    assert_eq!(DoubleDouble::ratio(-1, 0), -DoubleDouble::INFINITY);
}

#[test]
fn outside_its_domain_a_function_is_not_a_number() {
    let [two, minus] = [2, -1].map(DoubleDouble::int);
    for (name, value) in [
        ("sqrt", minus.sqrt()),
        ("ln", minus.ln()),
        ("asin", two.asin()),
        ("asin", (-two).asin()),
        ("acos", two.acos()),
        ("sin", DoubleDouble::INFINITY.sin_cos().0),
        ("cos", (-DoubleDouble::INFINITY).sin_cos().1),
        ("inf - inf", DoubleDouble::INFINITY - DoubleDouble::INFINITY),
        ("0/0", DoubleDouble::int(0) / DoubleDouble::int(0)),
    ] {
        assert!(value.hi().is_nan(), "{name}: {value}");
        assert_eq!(value.lo(), 0.0, "{name}");
    }
}

#[test]
fn infinities_and_zeros_are_those_of_f64() {
    let [zero, one, minus] = [0, 1, -1].map(DoubleDouble::int);
    let infinity = DoubleDouble::INFINITY;
    assert_eq!(one / zero, infinity);
    assert_eq!(one / infinity, zero);
    assert_eq!(infinity + one, infinity);
    assert_eq!(infinity * minus, -infinity);
    assert_eq!(DoubleDouble::from_f64(1e300) * DoubleDouble::from_f64(1e300), infinity);
    assert_eq!(DoubleDouble::from_f64(f64::MAX) + DoubleDouble::from_f64(f64::MAX), infinity);
    assert_eq!((infinity.exp(), (-infinity).exp()), (infinity, zero));
    assert_eq!((zero.ln(), infinity.ln()), (-infinity, infinity));
    assert_eq!((zero.sqrt(), infinity.sqrt()), (zero, infinity));
    assert_eq!((infinity.sinh(), (-infinity).sinh(), infinity.cosh()), (infinity, -infinity, infinity));
    assert_eq!((infinity.tanh(), (-infinity).tanh()), (one, minus));
    let quarter = DoubleDouble::pi() / DoubleDouble::int(2);
    assert_eq!((infinity.atan(), (-infinity).atan()), (quarter, -quarter));
    assert_eq!((one.asin(), one.acos(), minus.acos()), (quarter, zero, DoubleDouble::pi()));
    assert_eq!([zero.sin_cos().0, zero.atan(), zero.asin(), zero.sinh(), zero.tanh()], [zero; 5]);
    assert_eq!([zero.sin_cos().1, zero.exp(), zero.cosh()], [one; 3]);
    assert!(one.ln() == zero && zero.sign() == zero && (-infinity).sign() == minus);
}

/// No function panics or runs on, whatever it is given; what comes out is a number with an ordered pair of parts.
#[test]
fn extreme_arguments_are_survived() {
    let functions = [EXP, LN, SIN, COS, ASIN, ACOS, ATAN, SINH, COSH, TANH, SQRT];
    let sizes = [f64::MAX, f64::MIN_POSITIVE, 5e-324, 1e-310, 1e299, 1e18, 710.0, f64::INFINITY, f64::NAN, 0.0, 1.0];
    for size in sizes {
        for x in [size, -size].map(DoubleDouble::from_f64) {
            for (function, _) in functions {
                let y = function(x);
                assert!(y.hi().is_nan() || y.hi() + y.lo() == y.hi(), "{x}: {y}");
                assert!(y.to_string().len() < 45);
            }
            assert!(!x.powi(-3).lo().is_nan());
        }
    }
}

/// Near the ends of the range digits are lost, but not those of f64.
#[test]
fn results_out_of_the_full_range_keep_the_digits_of_f64() {
    for x in [1e-320, 1e-300, 1e300, 1.7e308] {
        let x = DoubleDouble::from_f64(x);
        let root = x.sqrt();
        assert!(((root * root - x) / x).abs().to_f64() < 1e-4 || x.hi() < 1e-310);
        assert!(((x / DoubleDouble::int(3)).to_f64() / (x.to_f64() / 3.0) - 1.0).abs() < 1e-3);
    }
    assert_eq!(DoubleDouble::decimal("1e-310").to_f64(), 1e-310);
}

#[test]
fn comparison_looks_at_both_parts() {
    let one = DoubleDouble::int(1);
    let above = DoubleDouble::sum(1.0, 1e-25);
    assert!(one < above && -above < -one && one != above);
    assert!(DoubleDouble::NAN.partial_cmp(&one).is_none());
    assert!(-DoubleDouble::INFINITY < -one && above < DoubleDouble::INFINITY);
    assert_eq!(above.to_f64(), 1.0);
}
