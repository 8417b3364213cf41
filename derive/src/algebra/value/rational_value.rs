//! Exact values of terms as rational numbers.

use crate::algebra::term::fold::{Fold, Values, fold};
use crate::algebra::{Arena, Expr, Function, Rational};

/// The number π with 60 decimals, more than twice the digits that any number type holds.
const PI: &str = "3.141592653589793238462643383279502884197169399375105820974945";

/// Rational approximation of π with 60 decimals, more exact than any number type in use.
#[must_use]
pub fn rational_value_of_pi() -> Rational {
    Rational::parse_decimal(PI).expect("decimals")
}

/// Value of the term `e` as a rational number, with π to 60 decimals. `known` has values of terms,
/// such as symbols, as pairs (term, value). `None` if a function, a symbol without a value or a
/// division by 0 occurs.
#[must_use]
pub fn exact_value(arena: &Arena, e: Expr, known: &[(Expr, Rational)]) -> Option<Rational> {
    fold(arena, e, &mut Exact(known))
}

/// Rules that evaluate terms in rational numbers. The list gives the values of some terms as pairs
/// (term, value).
struct Exact<'a>(&'a [(Expr, Rational)]);

impl Fold for Exact<'_> {
    type Value = Rational;
    fn number(&mut self, value: &Rational) -> Option<Rational> {
        Some(value.clone())
    }
    fn pi(&mut self) -> Option<Rational> {
        Some(rational_value_of_pi())
    }
    fn symbol(&mut self, _: Expr) -> Option<Rational> {
        None
    }
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, Rational>) -> Option<Rational> {
        Some(terms.iter().fold(constant.clone(), |sum, (term, k)| sum.add(&of[*term].mul(k))))
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, Rational>) -> Option<Rational> {
        factors.iter().try_fold(Rational::ONE, |product, (base, n)| Some(product.mul(&of[*base].pow(*n)?)))
    }
    fn apply(&mut self, _: Function, _: Expr, _: &Values<'_, Rational>) -> Option<Rational> {
        None
    }
    fn known(&mut self, term: Expr) -> Option<Rational> {
        self.0.iter().find(|(known, _)| *known == term).map(|(_, value)| value.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::value::tape::Numeric;
    use tripos_traits::DoubleDouble;

    fn extended(text: &str) -> Option<DoubleDouble> {
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, text).unwrap();
        exact_value(&arena, e, &[]).map(|value| DoubleDouble::from_rational(&value))
    }

    /// The double nearest to 9.81 and the rest are kept. The rest was computed from the exact
    /// decimal expansion of the double: 9.81000000000000049737991503207013010978698730468750.
    #[test]
    fn what_a_double_leaves_of_a_decimal_is_kept() {
        assert_eq!(extended("9.81"), Some(DoubleDouble::sum(9.81, -4.973_799_150_320_702e-16)));
    }

    /// The double nearest to π and the rest are kept. The rest is 1.2246467991473532e-16, the sine
    /// of that double.
    #[test]
    fn pi_has_more_digits_than_a_double() {
        assert_eq!(extended("pi"), Some(DoubleDouble::sum(std::f64::consts::PI, 1.224_646_799_147_353_2e-16)));
        let small = DoubleDouble::sum(-1e-3, 2.081_668_171_172_168_5e-20);
        assert_eq!(extended("pi/2 - 1/1000 - pi/2"), Some(small));
    }

    #[test]
    fn function_values_have_no_exact_value() {
        assert_eq!(extended("sqrt(2)"), None);
    }
}
