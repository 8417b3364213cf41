//! Formulas as JavaScript expressions, in double precision.
//!
//! Operations are in the order of the other targets, so that results differ only by rounding. A product and a sum are
//! never fused into one operation.

use crate::plan::{constant_and_factors, led};
use tripos_derive::algebra::Rational;
use tripos_derive::algebra::text::view::View;

/// JavaScript expression for a formula.
#[must_use]
pub fn expression(view: &View) -> String {
    match view {
        View::Number(text) => number(text, "1"),
        View::Name(name) | View::Word(name) | View::Shared(name) => name.clone(),
        View::Pi => "Math.PI".to_owned(),
        View::Sum(terms) => sum(terms),
        View::Product(factors) => factors.iter().map(factor).collect::<Vec<_>>().join(" * "),
        View::Fraction(above, below) => fraction(above, below),
        View::Power(base, n) => power(base, *n),
        View::Call(name, argument) => format!("Math.{name}({})", expression(argument)),
        View::Root(argument) => format!("Math.sqrt({})", expression(argument)),
        // A formula is cut only beyond a budget that no formula comes near.
        View::Cut => "NaN".to_owned(),
    }
}

/// JavaScript literal of the double nearest to a number.
#[must_use]
pub fn constant(value: &Rational) -> String {
    let magnitude = if value.is_negative() { value.neg() } else { value.clone() }.to_big();
    let magnitude = number(&magnitude.numer().to_string(), &magnitude.denom().to_string());
    if value.is_negative() { format!("-{magnitude}") } else { magnitude }
}

/// Quotient of two whole numbers, as one JavaScript literal.
fn number(numerator: &str, denominator: &str) -> String {
    if denominator == "1" {
        return numerator.to_owned();
    }
    let value = Rational::parse_decimal(numerator).zip(Rational::parse_decimal(denominator));
    let value = value.and_then(|(n, d)| Some(n.mul(&d.recip()?)));
    let Some(value) = value else { return "NaN".to_owned() };
    let nearest = value.to_f64();
    if nearest.is_normal() {
        return format!("{nearest:?}");
    }
    // Numbers outside the normal doubles get a power of ten, so that the language rounds them.
    let digits = |text: &str| i32::try_from(text.len()).unwrap_or(i32::MAX);
    let size = digits(numerator) - digits(denominator);
    let power = Rational::integer(10).pow(size).and_then(|power| power.recip());
    power.map_or_else(|| "NaN".to_owned(), |power| format!("{}e{size}", value.mul(&power).to_f64()))
}

/// Sum with its terms from left to right.
fn sum(terms: &[(bool, View)]) -> String {
    let mut out = String::new();
    for (at, (negative, term)) in led(terms).into_iter().enumerate() {
        out += match (at, negative) {
            (0, true) => "-",
            (0, false) => "",
            (_, true) => " - ",
            (_, false) => " + ",
        };
        out += &if matches!(term, View::Sum(_)) { in_parentheses(term) } else { expression(term) };
    }
    out
}

fn factor(view: &View) -> String {
    if matches!(view, View::Sum(_) | View::Fraction(..)) { in_parentheses(view) } else { expression(view) }
}

fn in_parentheses(view: &View) -> String {
    format!("({})", expression(view))
}

/// Quotient above / below, with the whole numbers of both terms merged into one constant.
fn fraction(above: &View, below: &View) -> String {
    let (n, above) = constant_and_factors(above);
    let (d, below) = constant_and_factors(below);
    let mut factors: Vec<String> = Vec::new();
    if n != "1" || d != "1" || above.is_empty() {
        factors.push(number(&n, &d));
    }
    factors.extend(above.iter().map(factor));
    let numerator = factors.join(" * ");
    match below.as_slice() {
        [] => numerator,
        // A power may be written as a product, which binds no tighter than the division.
        [one] if !matches!(one, View::Power(..)) => format!("{numerator} / {}", factor(one)),
        many => format!("{numerator} / ({})", many.iter().map(factor).collect::<Vec<_>>().join(" * ")),
    }
}

/// Power of a variable: squares and cubes as products, other powers by `Math.pow`, because `-x ** 2` is no expression.
fn power(base: &View, n: i32) -> String {
    let text = expression(base);
    match (base, n) {
        (View::Name(_) | View::Shared(_), 2..=3) => vec![text; n.unsigned_abs() as usize].join(" * "),
        _ => format!("Math.pow({text}, {n})"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tripos_derive::algebra::Arena;
    use tripos_derive::algebra::text::parse::parse_primed;
    use tripos_derive::algebra::text::view::{Shared, view};

    fn written(formula: &str) -> String {
        let mut arena = Arena::default();
        let e = parse_primed(&mut arena, formula, 0, &mut |arena, name| Ok(arena.symbol(name))).unwrap();
        expression(&view(&arena, e, &Shared::default(), usize::MAX))
    }

    /// Goal: the written expression has the value of the formula, by the precedence of the language. Method: forms in
    /// which a missing parenthesis changes the value, or leaves no expression at all.
    #[test]
    fn formulas_keep_their_meaning() {
        let forms = [
            ("-a^2 - b", "-b - a * a"),
            ("-(a + b)^4", "-Math.pow(a + b, 4)"),
            ("a/(b*c)", "a / (b * c)"),
            ("a/b^2", "a / (b * b)"),
            ("a/(b + c)", "a / (b + c)"),
            ("2*a/3", "0.6666666666666666 * a"),
            ("a*(b - c*(a - b))", "a * (b + c * (b - a))"),
            ("sqrt(a)*log(b)*sign(c)", "Math.sqrt(a) * Math.log(b) * Math.sign(c)"),
            ("a/10^400", "1e-400 * a"),
        ];
        for (formula, expected) in forms {
            assert_eq!(written(formula), expected, "{formula}");
        }
    }
}
