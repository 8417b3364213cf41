//! Equations of closing joints that no coordinate changes: conditions on parameters.

use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr, Node};
use crate::model::Unit;
use crate::model::units::unit_of;
use rustc_hash::FxHashMap;

/// Gap up to which an equation without coordinates counts as fulfilled, relative to the size of its terms.
const CLOSED: f64 = 1e-9;
/// Gap up to which an equation without coordinates counts as fulfilled, relative to the longest length of the
/// mechanism, or to 1 for directions. It is the rounding error of numbers that a program wrote.
const ROUNDING: f64 = 1e-15;

/// Values of parameters, at which equations without coordinates are tested.
pub struct KnownParameters<'u> {
    /// Symbols of the parameters.
    symbols: Vec<Expr>,
    /// Values of the parameters, in SI units.
    values: Vec<f64>,
    /// Units of the parameters.
    units: &'u FxHashMap<Expr, Unit>,
    /// Largest absolute value of a length among the parameters, m; 0 if there is none.
    longest: f64,
}

impl<'u> KnownParameters<'u> {
    /// Takes the values of parameters as (symbol, value in SI units), and the units of all symbols.
    pub fn new(known: &[(Expr, f64)], units: &'u FxHashMap<Expr, Unit>) -> Self {
        let length = Unit::new(1, 0, 0);
        let lengths = known.iter().filter(|(symbol, _)| units.get(symbol) == Some(&length));
        let longest = lengths.fold(0.0, |most: f64, (_, value)| most.max(value.abs()));
        let (symbols, values) = known.iter().copied().unzip();
        Self { symbols, values, units, longest }
    }

    /// Gap of an equation without coordinates: its value, in SI units. It is 0 if it is within rounding. `None` if the
    /// equation contains a symbol without a value.
    pub fn gap(&self, arena: &Arena, equation: Expr) -> Option<f64> {
        let (gap, size) = self.value_and_size(arena, equation)?;
        let unit = unit_of(arena, equation, self.units).ok().flatten().unwrap_or_default();
        let reach = if unit.is_plain() { 1.0 } else { self.longest };
        let is_closed = gap.abs() <= (CLOSED * size).max(ROUNDING * reach);
        Some(if is_closed { 0.0 } else { gap })
    }

    /// Value of an equation, and the size of its terms. Differences inside factors count with the sizes of their own
    /// terms: a product of a difference that cancels is as large as the terms of this difference.
    fn value_and_size(&self, arena: &Arena, equation: Expr) -> Option<(f64, f64)> {
        let (constant, terms): (f64, Vec<(Expr, f64)>) = match arena.node(equation) {
            Node::Sum(constant, terms) => (constant.to_f64(), terms.iter().map(|(e, k)| (*e, k.to_f64())).collect()),
            _ => (0.0, vec![(equation, 1.0)]),
        };
        let (parts, factors): (Vec<Expr>, Vec<f64>) = terms.into_iter().unzip();
        let tape = Tape::new(arena, &self.symbols, &parts).ok()?;
        let sum = |list: Vec<f64>, constant: f64| list.iter().zip(&factors).fold(constant, |sum, (x, k)| sum + x * k);
        let gap = sum(tape.evaluate(&self.values), constant);
        let sizes = tape.largest_terms(&self.values);
        let size = sizes.iter().zip(&factors).fold(constant.abs(), |size, (term, factor)| size + (term * factor).abs());
        Some((gap, size))
    }
}
