//! The expression language: precedence, places of errors, limits.

use std::ops::Range;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::{Arena, Expr, Rational};

fn error(text: &str) -> (Range<usize>, String) {
    let mut arena = Arena::new();
    let e = parse_free(&mut arena, text).expect_err(text);
    assert!(e.help.is_some(), "{text}: every error has a hint");
    (e.span, e.message)
}

#[test]
fn precedence_is_the_usual_one() {
    let mut arena = Arena::new();
    for (a, b) in [
        ("-x^2", "-(x*x)"),
        ("2^3^2", "512"),
        ("a/b/c", "a/(b*c)"),
        ("a - b - c", "a - (b + c)"),
        ("x^-1", "1/x"),
        ("2*-x", "-2*x"),
        ("x^(3/2)", "x*sqrt(x)"),
        ("1.5e-3", "3/2000"),
        ("0^0", "1"),
        ("sin(-x) + sin(x)", "0"),
        ("cos(pi/2 - x)", "sin(x)"),
        ("sin(x - pi/2)", "-cos(x)"),
        ("cos(pi/6)^2", "3/4"),
    ] {
        let (x, y) = (parse_free(&mut arena, a).unwrap(), parse_free(&mut arena, b).unwrap());
        assert_eq!(x, y, "{a} is {b}");
    }
}

#[test]
fn every_wrong_text_gets_its_place() {
    for (text, at) in [
        ("2q1", 1),
        ("q1 q2", 3),
        ("sin q1", 0),
        ("q1(t)", 0),
        ("q1''", 0),
        ("q1.dot", 2),
        ("(a + b", 0),
        ("a + b)", 5),
        ("a +", 3),
        ("a ** 2", 3),
        ("1/0", 2),
        ("1/(a - a)", 2),
        ("log(0)", 0),
        ("sqrt(-1)", 0),
        ("acos(2)", 0),
        ("tan(pi/2)", 0),
        ("x^y", 2),
        ("2^(2^20)", 0),
        ("10°", 2),
        ("1.2.3", 0),
        ("", 0),
    ] {
        assert_eq!(error(text).0.start, at, "{text}");
    }
}

#[test]
fn deep_nesting_and_long_sums_neither_overflow_nor_hang() {
    let deep = format!("{}q{}", "(".repeat(100_000), ")".repeat(100_000));
    assert!(error(&deep).1.contains("nesting deeper"));
    assert!(error(&"sin(".repeat(100_000)).1.contains("nesting deeper"));
    assert!(error(&"x^".repeat(100_000)).1.contains("nesting deeper"));
    // The place of an error lies inside the text, also at its end.
    let short = "2^".repeat(201);
    assert_eq!(error(&short).0, short.len()..short.len());
    let mut arena = Arena::new();
    let minus = format!("{}q", "-".repeat(100_001));
    let e = parse_free(&mut arena, &minus).unwrap();
    let q = arena.symbol("q");
    assert_eq!(e, arena.neg(q));
    let long = vec!["q"; 1_000_000].join("+");
    let e = parse_free(&mut arena, &long).unwrap();
    assert_eq!(e, arena.scale(q, &Rational::integer(1_000_000)));
}

#[test]
fn big_numbers_stay_exact() {
    let mut arena = Arena::new();
    let e = parse_free(&mut arena, "9223372036854775808 - 9223372036854775807 + 10^400 - 10^400").unwrap();
    assert_eq!(e, Expr::ONE);
}

#[test]
fn a_root_without_a_value_is_printed_as_it_was_written() {
    let mut arena = Arena::new();
    let m = arena.symbol("m");
    arena.assume_positive(m);
    for written in ["sqrt(-m^2)", "x*sqrt(-3*m^4)"] {
        let e = parse_free(&mut arena, written).unwrap();
        assert_eq!(print_text(&arena, e), written);
    }
}
