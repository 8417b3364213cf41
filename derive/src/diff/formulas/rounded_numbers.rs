//! Equality to the digits printed, for formulas with numbers instead of parameters, such as 2.1853 θ.
//!
//! A printed decimal number represents any number that rounds to it: up to half a unit of its last decimal more or
//! less. Numbers may replace parameters only in a formula that mentions no parameter: a lost factor is a mistake, even
//! if its value is 1.

use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::field::Generator;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Node, Rational};
use crate::mechanics::Quantities;

/// Number of random states at which the printed and the derived value are compared.
const STATES: usize = 6;
/// Largest number of decimals of a printed number that may be rounded.
const MOST_DECIMALS: u32 = 15;
/// Largest number of rounded numbers in a printed formula.
const MOST_NUMBERS: usize = 40;
/// Relative tolerance for the rounding errors of the comparison.
const ROUNDING: f64 = 1e-9;

/// True if a printed value with numbers instead of all parameters equals the derived value to the digits printed.
/// `values` are the parameters with their numbers. The printed value may mention inputs.
pub fn agrees_to_printed_digits(
    quantities: &mut Quantities<'_>,
    comparer: &mut Comparer,
    values: &[(Expr, Expr)],
    printed: Expr,
    derived: Expr,
) -> bool {
    let arena = &mut quantities.derivations.kinematics.arena;
    let (own, other) = (arena.reachable(&[printed]), arena.reachable(&[derived]));
    let is_lost = |(symbol, _): &&(Expr, Expr)| {
        other.binary_search(symbol).is_ok()
            && own.binary_search(symbol).is_err()
            && arena.symbol_name(*symbol).is_some()
    };
    let model = quantities.model;
    let is_printed = model.parameters.iter().any(|p| !p.is_input && own.binary_search(&p.symbol).is_ok());
    if is_printed || values.iter().find(is_lost).is_none() {
        return false;
    }
    let decimals = rounded_decimals(arena, &own);
    if decimals.is_empty() || decimals.len() > MOST_NUMBERS {
        return false;
    }
    let epsilon = fresh_symbol(arena, "rounding");
    let mut terms = vec![printed, derived];
    for RoundedDecimal { sum, term, .. } in &decimals {
        let more = arena.mul(epsilon, *term);
        let changed = arena.add(*sum, more);
        let whole = Substitution::new(&[(*sum, changed)]).apply(arena, printed);
        let slope = Differential::partial(epsilon).apply(arena, whole);
        terms.push(Substitution::new(&[(epsilon, Expr::ZERO)]).apply(arena, slope));
    }
    let mut put = Substitution::new(values);
    let terms: Vec<Expr> = terms
        .into_iter()
        .map(|e| {
            let permitted = comparer.permitted().write_in_free_symbols(arena, e);
            put.apply(arena, permitted)
        })
        .collect();
    let symbols: Vec<Expr> = arena.reachable(&terms).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect();
    let Ok(tape) = Tape::new(arena, &symbols, &terms) else { return false };
    let mut generator = Generator(7);
    (0..STATES).all(|_| {
        let state: Vec<f64> = symbols.iter().map(|_| (generator.next() % 4001) as f64 * 1e-3 - 2.0).collect();
        let found = tape.evaluate(&state);
        let slack: f64 = decimals.iter().zip(&found[2..]).map(|(decimal, slope)| decimal.slack * slope.abs()).sum();
        let size = found[0].abs().max(found[1].abs());
        // The comparison is false if a value is NaN.
        (found[0] - found[1]).abs() <= slack + ROUNDING * size
    })
}

/// Decimal number in a printed formula: the constant of a sum, or the factor of a term.
struct RoundedDecimal {
    /// Sum that contains the number, or the number itself.
    sum: Expr,
    /// Term that the number multiplies; 1 for a constant.
    term: Expr,
    /// Uncertainty of the number: half a unit of its last decimal.
    slack: f64,
}

/// Finds the decimal numbers among the terms `parts`, each with its uncertainty.
fn rounded_decimals(arena: &Arena, parts: &[Expr]) -> Vec<RoundedDecimal> {
    let mut list = Vec::new();
    for sum in parts {
        let mut add = |term: Expr, number: &Rational| {
            if let Some(slack) = rounding_uncertainty(number) {
                list.push(RoundedDecimal { sum: *sum, term, slack });
            }
        };
        match arena.node(*sum) {
            Node::Number(value) => add(Expr::ONE, value),
            Node::Sum(constant, terms) => {
                add(Expr::ONE, constant);
                terms.iter().for_each(|(term, k)| add(*term, k));
            }
            _ => {}
        }
    }
    list
}

/// Uncertainty of a decimal number, half a unit of its last decimal. `None` for an integer, or a fraction without a
/// finite decimal form.
fn rounding_uncertainty(number: &Rational) -> Option<f64> {
    let (_, denominator) = number.small()?;
    let places = (1..=MOST_DECIMALS).find(|places| 10_i64.pow(*places) % denominator == 0)?;
    (denominator > 1).then(|| 0.5 * 10_f64.powi(-i32::try_from(places).unwrap_or(0)))
}

#[cfg(test)]
mod tests {
    use super::rounding_uncertainty;
    use crate::algebra::Rational;

    #[test]
    fn decimals_are_rounded_and_fractions_are_not() {
        let of = |n, d| rounding_uncertainty(&Rational::fraction(n, d).unwrap());
        assert_eq!(of(25, 10), Some(0.05));
        assert!((of(21853, 10_000).unwrap() - 5e-5).abs() < 1e-12);
        assert_eq!((of(3, 1), of(2, 3)), (None, None));
    }
}
