//! Witnesses of differences: states at which two sides have different values. Their numbers have
//! few digits, so that people can type them.

use super::signs::{Bounds, Signs};
use crate::algebra::value::field::Generator;
use crate::algebra::value::interval::{PointInterval, enclose_in_interval};
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;

/// State at which the two sides of a comparison have different values.
#[derive(Clone, Debug, PartialEq)]
pub struct Witness {
    /// Values of the symbols at the state, as pairs (name, value).
    pub at: Vec<(String, f64)>,
    /// Value of the left side of the comparison at the state.
    pub left: f64,
    /// Value of the right side of the comparison at the state.
    pub right: f64,
    /// Value of left − right at the state, evaluated as one expression.
    pub difference: f64,
}

/// Number of states that are tried for a witness with a clear difference.
const STATES: usize = 100;
/// Largest number of states that are tried until both sides have values at one of them. Square
/// roots and conditions may exclude many states.
const MOST_STATES: usize = 2000;

/// Requirements on a witness: a state at which the two sides of a comparison differ.
#[derive(Clone, Debug)]
pub struct WitnessRequest<'a> {
    /// Left side, right side, and their difference, as terms.
    pub sides: [Expr; 3],
    /// Terms that must have a value at the witness state.
    pub defined: Vec<Expr>,
    /// Terms that must be positive at the witness state.
    pub positive: &'a [Expr],
    /// Known signs of terms, which limit the values of symbols.
    pub signs: &'a Signs,
    /// Symbols whose values the witness shows, each with its value as a term in free symbols.
    pub shown: Vec<(Expr, Expr)>,
}

/// Finds a state at which the two sides differ. All terms of `defined` have a value there. `None`
/// if no such state was found.
///
/// The flag is true if the difference is proved: an interval that encloses it excludes 0.
pub fn find_witness(arena: &Arena, asked: &WitnessRequest<'_>) -> Option<(Witness, bool)> {
    let symbols_of = |roots: &[Expr]| {
        let parts = arena.reachable(roots).into_iter();
        parts.filter(|e| arena.symbol_name(*e).is_some()).collect::<Vec<_>>()
    };
    let values_shown: Vec<Expr> = asked.shown.iter().map(|(_, value)| *value).collect();
    let mut symbols = symbols_of(&[&asked.sides, values_shown.as_slice()].concat());
    let mut generator = Generator(symbols.len() as u64);
    // A condition on symbols that do not occur excludes no value of the symbols that do.
    let positive: Vec<Expr> =
        asked.positive.iter().copied().filter(|e| mentions_witness_symbol(arena, *e, &symbols)).collect();
    let others = [asked.defined.as_slice(), &positive].concat();
    symbols.extend(symbols_of(&others).into_iter().filter(|s| symbols.binary_search(s).is_err()).collect::<Vec<_>>());
    let outputs = [&asked.sides, positive.as_slice(), values_shown.as_slice(), asked.defined.as_slice()].concat();
    let tape = Tape::new(arena, &symbols, &outputs).ok()?;
    let (after, count) = (3 + positive.len(), asked.shown.len());
    // States are ranked by a proved difference first, then by the relative size of the difference.
    let mut best: Option<((bool, f64), Witness)> = None;
    for tried in 0..MOST_STATES {
        if tried >= STATES && best.is_some() {
            break;
        }
        let values: Vec<f64> = symbols.iter().map(|s| witness_value(arena, asked.signs, *s, &mut generator)).collect();
        let found = tape.evaluate(&values);
        let (left, right, difference) = (found[0], found[1], found[2]);
        if found.iter().any(|x| !x.is_finite()) || difference == 0.0 || found[3..after].iter().any(|x| *x <= 0.0) {
            continue;
        }
        let at: FxHashMap<Expr, f64> = symbols.iter().copied().zip(values).collect();
        let is_inside = |e: &Expr| enclose_in_interval(arena, *e, &at).is_some_and(PointInterval::is_positive);
        if !positive.iter().all(is_inside) {
            continue;
        }
        let proved = enclose_in_interval(arena, asked.sides[2], &at).is_some_and(PointInterval::excludes_zero);
        let share = difference.abs() / left.abs().max(right.abs()).max(f64::MIN_POSITIVE);
        if best.as_ref().is_none_or(|(most, _)| (proved, share) > *most) {
            let names = asked.shown.iter().filter_map(|(s, _)| arena.symbol_name(*s)).map(str::to_owned);
            let at = names.zip(found[after..after + count].iter().copied()).collect();
            best = Some(((proved, share), Witness { at, left, right, difference }));
        }
        // A relative difference above 5% is clear to any reader.
        if proved && share > 0.05 {
            break;
        }
    }
    best.map(|((proved, _), witness)| (witness, proved))
}

/// Random value for a symbol, within the symbol's bounds if it has any.
fn witness_value(arena: &Arena, signs: &Signs, symbol: Expr, generator: &mut Generator) -> f64 {
    let size = handy_witness_size(generator);
    let is_positive = arena.is_positive(symbol) || generator.next().is_multiple_of(2);
    let plain = if is_positive { size } else { -size };
    let Some(Bounds { low, high, .. }) = signs.bounds_of(symbol) else { return plain };
    let number = |e: &Option<Expr>| {
        let e = (*e)?;
        Tape::new(arena, &[], &[e]).ok().map(|tape| tape.evaluate(&[])[0])
    };
    let (low, high) = (number(low), number(high));
    if low.is_none_or(|low| plain > low) && high.is_none_or(|high| plain < high) {
        return plain;
    }
    // The value lies between both bounds. With a single bound, its distance from the bound is the
    // number's distance from 0.
    match (low, high) {
        (Some(low), Some(high)) => low + (high - low) * (plain.abs() / LARGEST),
        (Some(low), None) => low + plain.abs(),
        (None, Some(high)) => high - plain.abs(),
        (None, None) => plain,
    }
}

/// True if the term `e` contains any of the given symbols, which must be sorted.
fn mentions_witness_symbol(arena: &Arena, e: Expr, symbols: &[Expr]) -> bool {
    arena.reachable(&[e]).iter().any(|part| symbols.binary_search(part).is_ok())
}

/// Upper limit of the absolute values of random numbers that scales them between two bounds.
const LARGEST: f64 = 3.2;

/// Random number from 0.2 to 2.99 with two decimals, short enough for people to type.
fn handy_witness_size(generator: &mut Generator) -> f64 {
    (20 + generator.next() % 280) as f64 / 100.0
}
