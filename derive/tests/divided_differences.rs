//! Divided differences in floating point: against the plain quotient where it is exact enough, and against the
//! derivative.

use tripos_derive::algebra::term::calculus::{Differential, Substitution};
use tripos_derive::algebra::term::divided_difference::divided_difference;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};

/// Potentials as models have them: powers, roots of both signs of exponent, trigonometric poles, angles with constants.
const TERMS: [&str; 12] = [
    "m*x^7 - 3*x^4 + x^-3 + 2",
    "m*sin(3*x + 0.4) + x*cos(m*x)",
    "(m - 2*cos(x))^2/sin(x)^2 + 9*cos(x)",
    "1/(1 + sin(x)^2)",
    "sqrt(1 + m*x^2)",
    "x/sqrt(1 + x^2)^3",
    "sqrt(2*x*m)/(x*m)",
    "x^2*sqrt(x)",
    "tan(x)*sin(x/2)",
    "(x - m)^9*(x + m)^-5",
    "sin(2*x + pi/3)*cos(x - pi/4)",
    "m^2/(2*x^2) - 1/x",
];

fn sinc(z: f64) -> f64 {
    if z == 0.0 { 1.0 } else { z.sin() / z }
}

/// (e[a, b], e(a), e(b), de/dx at the middle) for m = 1.7.
fn values(term: &str, a: f64, b: f64) -> [f64; 4] {
    let mut arena = Arena::new();
    let [m, x, from, to] = ["m", "x", "a", "b"].map(|name| arena.symbol(name));
    let e = parse_free(&mut arena, term).unwrap();
    let divided = divided_difference(&mut arena, e, x, from, to).unwrap();
    let slope = Differential::partial(x).apply(&mut arena, e);
    let (symbols, arguments): (Vec<Expr>, Vec<Expr>) = divided.sincs.iter().copied().unzip();
    let arguments = Tape::new(&arena, &[m, from, to], &arguments).unwrap().evaluate(&[1.7, a, b]);
    let sincs: Vec<f64> = arguments.into_iter().map(sinc).collect();
    let value = Tape::new(&arena, &[&[m, from, to], &symbols[..]].concat(), &[divided.value]).unwrap();
    let value = value.evaluate(&[&[1.7, a, b], &sincs[..]].concat())[0];
    let plain = Tape::new(&arena, &[m, x], &[e, slope]).unwrap();
    let at = |x: f64| plain.evaluate(&[1.7, x]);
    [value, at(a)[0], at(b)[0], at(f64::midpoint(a, b))[1]]
}

/// The plain quotient has the error of two values, 10 ε of the larger for some operations, over b − a ≥ 0.3; the other
/// one as much.
#[test]
fn far_apart_it_is_the_quotient_of_differences() {
    for term in TERMS {
        for (a, b) in [(0.4, 1.1), (1.3, 0.6), (0.2, 0.5), (1.4, 0.01)] {
            let [value, low, high, _] = values(term, a, b);
            let scale = low.abs().max(high.abs()).max(1.0) / (b - a).abs();
            let quotient = (high - low) / (b - a);
            assert!((value - quotient).abs() < 100.0 * f64::EPSILON * scale, "{term}: {value} and {quotient}");
        }
    }
}

/// At b − a = 1e-12 the two differ by the square of that, and the plain quotient would have four digits: 1e-13 of the
/// derivative is the rounding of some twenty operations of its own size. At b = a nothing differs but the order of
/// operations.
#[test]
fn next_to_each_other_it_is_the_derivative() {
    for term in TERMS {
        for a in [0.3, 0.9, 1.35] {
            for width in [1e-12, -1e-12, 0.0] {
                let [value, _, _, slope] = values(term, a, a + width);
                assert!((value - slope).abs() <= 1e-13 * slope.abs().max(1.0), "{term} at {a}: {value} and {slope}");
            }
        }
    }
}

/// Goal: the root of a small number over that of a large one is not the rest of a subtraction. 1/√x from 1e-20 to 1 and
/// back; the exact quotient is that of numbers that are far apart.
#[test]
fn inverse_roots_keep_their_digits_at_any_ratio() {
    for (a, b) in [(1e-20, 1.0), (1.0, 1e-20), (1e-12, 1e12), (1e12, 1e-12)] {
        let [value, low, high, _] = values("1/sqrt(x)", a, b);
        let quotient = (high - low) / (b - a);
        assert!((value / quotient - 1.0).abs() < 4.0 * f64::EPSILON, "{value} and {quotient}");
    }
}

#[test]
fn what_is_asked_with_a_equal_to_b_is_the_derivative_by_meaning() {
    for term in TERMS {
        let mut arena = Arena::new();
        let [x, a] = ["x", "a"].map(|name| arena.symbol(name));
        let e = parse_free(&mut arena, term).unwrap();
        let divided = divided_difference(&mut arena, e, x, a, a).unwrap();
        let slope = Differential::partial(x).apply(&mut arena, e);
        let slope = Substitution::new(&[(x, a)]).apply(&mut arena, slope);
        let difference = arena.sub(divided.value, slope);
        assert!(divided.sincs.is_empty());
        assert_eq!(zero_test(&arena, difference), ZeroTest::Zero, "{term}");
    }
}

#[test]
fn a_term_without_a_rule_has_none() {
    for (term, has) in [
        ("exp(x)", false),
        ("sin(x^2)", false),
        ("abs(x)", false),
        ("sin(x*m)", true),
        ("exp(m) + x", true),
        ("1/(x - a)", false),
    ] {
        let mut arena = Arena::new();
        let [x, a, b] = ["x", "a", "b"].map(|name| arena.symbol(name));
        let e = parse_free(&mut arena, term).unwrap();
        assert_eq!(divided_difference(&mut arena, e, x, a, b).is_some(), has, "{term}");
    }
}

/// One value of sinc serves x and −x, sine and cosine, and no name is taken twice.
#[test]
fn sincs_are_shared_and_have_names_of_their_own() {
    let mut arena = Arena::new();
    let [x, a, b, taken] = ["x", "a", "b", "sinc1"].map(|name| arena.symbol(name));
    let e = parse_free(&mut arena, "sin(x) + cos(m - x) + sin(2*x)*sinc1").unwrap();
    let divided = divided_difference(&mut arena, e, x, a, b).unwrap();
    let sincs: Vec<String> = divided
        .sincs
        .iter()
        .map(|(symbol, z)| format!("{} {}", print_text(&arena, *symbol), print_text(&arena, *z)))
        .collect();
    assert_eq!(sincs.len(), 2, "{sincs:?}");
    assert!(divided.sincs.iter().all(|(symbol, _)| *symbol != taken));
}

/// The exponent counts by its digits only.
#[test]
fn a_high_power_stays_short() {
    let mut arena = Arena::new();
    let [x, a, b] = ["x", "a", "b"].map(|name| arena.symbol(name));
    let e = parse_free(&mut arena, "x^1000").unwrap();
    let divided = divided_difference(&mut arena, e, x, a, b).unwrap();
    assert!(arena.reachable(&[divided.value]).len() < 100);
}
