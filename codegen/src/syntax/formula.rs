//! Formulas as expressions with infix operators, for C, JavaScript, MATLAB and Python.
//!
//! Operations are in the order of the plan, so that the results in all languages differ only by rounding.

use super::Syntax;
use crate::plan::{is_fusible_product, order_sum_for_fusion};
use tripos_derive::algebra::Rational;
use tripos_derive::algebra::text::display_tree::{DisplayTree, constant_and_factors, is_sum_free_formula};

/// Returns the expression for a formula in a language.
#[must_use]
pub fn formula(syntax: &dyn Syntax, view: &DisplayTree) -> String {
    InfixFormula(syntax).of(view)
}

/// Returns the literal of the double nearest to a rational number.
#[must_use]
pub fn number_literal(syntax: &dyn Syntax, value: &Rational) -> String {
    let magnitude = if value.is_negative() { value.neg() } else { value.clone() }.to_big();
    let magnitude = InfixFormula(syntax).number(&magnitude.numer().to_string(), &magnitude.denom().to_string());
    if value.is_negative() { format!("-{magnitude}") } else { magnitude }
}

/// Writer of formulas in one language, with its syntax.
#[derive(Clone, Copy)]
struct InfixFormula<'s>(&'s dyn Syntax);

impl InfixFormula<'_> {
    /// Returns the expression for a formula.
    fn of(self, view: &DisplayTree) -> String {
        match view {
            DisplayTree::Number(text) => self.number(text, "1"),
            DisplayTree::Name(name) | DisplayTree::Word(name) | DisplayTree::Shared(name) => name.clone(),
            DisplayTree::Pi => self.0.pi().to_owned(),
            DisplayTree::Sum(terms) => self.sum(terms),
            DisplayTree::Product(factors) => self.product(&factors.iter().map(|f| self.factor(f)).collect::<Vec<_>>()),
            DisplayTree::Fraction(above, below) => self.fraction(above, below),
            DisplayTree::Power(base, n) => self.power(base, *n),
            DisplayTree::Call(name, argument) => self.0.call(name, &self.of(argument)),
            DisplayTree::Root(argument) => self.0.call("sqrt", &self.of(argument)),
            // A formula is cut only beyond a budget that no formula comes near.
            DisplayTree::Cut => self.0.not_a_number().to_owned(),
        }
    }

    /// Returns the literal of a quotient of two whole numbers, given by their digits.
    fn number(self, numerator: &str, denominator: &str) -> String {
        if denominator == "1" {
            return self.0.integer_literal(numerator);
        }
        let value = Rational::parse_decimal(numerator).zip(Rational::parse_decimal(denominator));
        let value = value.and_then(|(n, d)| Some(n.mul(&d.reciprocal()?)));
        let Some(value) = value else { return self.0.not_a_number().to_owned() };
        let nearest = value.to_f64();
        if nearest.is_normal() {
            return self.0.decimal_literal(&format!("{nearest:?}"));
        }
        // A number outside the normal doubles gets a power of ten, so that the language rounds it.
        let digits = |text: &str| i32::try_from(text.len()).unwrap_or(i32::MAX);
        let size = digits(numerator) - digits(denominator);
        let power = Rational::integer(10).pow(size).and_then(|power| power.reciprocal());
        let scaled = |power: Rational| self.0.decimal_literal(&format!("{}e{size}", value.mul(&power).to_f64()));
        power.map_or_else(|| self.0.not_a_number().to_owned(), scaled)
    }

    /// Returns the expression for a sum, with its terms from left to right. A product of names and numbers may be
    /// moved from the first to the second place.
    fn sum(self, terms: &[(bool, DisplayTree)]) -> String {
        let order = order_sum_for_fusion(terms);
        let mut has_fused = order.iter().any(|(_, term)| !is_sum_free_formula(term));
        let mut out = String::new();
        for (at, (negative, term)) in order.into_iter().enumerate() {
            out += match (at, negative) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            };
            let is_fused = at > 0 && !has_fused && is_fusible_product(term);
            has_fused |= is_fused;
            out += &match term {
                DisplayTree::Sum(_) => self.in_parentheses(term),
                DisplayTree::Product(factors) if is_fused && self.0.is_ordered_as_rust() => {
                    self.product_for_fused_sum(factors)
                }
                _ => self.of(term),
            };
        }
        out
    }

    /// Returns the expression for a product in a sum, with its numbers at the end. The Rust target uses this order
    /// for a product that is fused with a sum.
    fn product_for_fused_sum(self, factors: &[DisplayTree]) -> String {
        let (numbers, others): (Vec<&DisplayTree>, Vec<&DisplayTree>) =
            factors.iter().partition(|f| matches!(f, DisplayTree::Number(_)));
        self.product(&others.into_iter().chain(numbers).map(|f| self.factor(f)).collect::<Vec<_>>())
    }

    /// Returns the product of factors, joined by the language's operator of multiplication.
    fn product(self, factors: &[String]) -> String {
        factors.join(&format!(" {} ", self.0.operators()[0]))
    }

    /// Returns a formula as a factor, in parentheses if it is a sum or a fraction.
    fn factor(self, view: &DisplayTree) -> String {
        if matches!(view, DisplayTree::Sum(_) | DisplayTree::Fraction(..)) {
            self.in_parentheses(view)
        } else {
            self.of(view)
        }
    }

    fn in_parentheses(self, view: &DisplayTree) -> String {
        format!("({})", self.of(view))
    }

    /// Returns the expression for a quotient. The whole numbers in numerator and denominator are
    /// merged into one constant.
    fn fraction(self, above: &DisplayTree, below: &DisplayTree) -> String {
        let (n, above) = constant_and_factors(above);
        let (d, below) = constant_and_factors(below);
        let mut factors: Vec<String> = Vec::new();
        if n != "1" || d != "1" || above.is_empty() {
            factors.push(self.number(&n, &d));
        }
        factors.extend(above.iter().map(|f| self.factor(f)));
        let (numerator, over) = (self.product(&factors), self.0.operators()[1]);
        match below.as_slice() {
            [] => numerator,
            // A power may be written as a product, which needs parentheses in a denominator.
            [one] if !matches!(one, DisplayTree::Power(..)) => format!("{numerator} {over} {}", self.factor(one)),
            many => {
                let many: Vec<String> = many.iter().map(|f| self.factor(f)).collect();
                format!("{numerator} {over} ({})", self.product(&many))
            }
        }
    }

    /// Returns the expression for a power. Squares and cubes of variables become products. The language decides the
    /// form of other powers.
    fn power(self, base: &DisplayTree, n: i32) -> String {
        match base {
            DisplayTree::Name(_) | DisplayTree::Shared(_) if (2..=3).contains(&n) => {
                self.product(&vec![self.of(base); n.unsigned_abs() as usize])
            }
            DisplayTree::Name(_) | DisplayTree::Shared(_) | DisplayTree::Call(..) | DisplayTree::Root(_) => {
                let text = self.of(base);
                self.0.power(&text, &text, n)
            }
            _ => self.0.power(&self.of(base), &self.in_parentheses(base), n),
        }
    }
}
