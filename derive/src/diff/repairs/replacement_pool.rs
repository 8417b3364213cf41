//! Symbols and factors that a repair of a formula may insert.

use crate::algebra::term::transfer::Transfer;
use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::Quantities;
use crate::model::Unit;
use rustc_hash::FxHashMap;

/// Number of symbols of a model up to which each may replace any other. In larger models, only symbols that occur in
/// the formulas may.
const MOST_SYMBOLS: usize = 40;
/// Largest number of factors by which terms are multiplied.
const MOST_FACTORS: usize = 30;

/// Symbols that may replace other symbols in a repair, and factors that may have been lost.
pub struct ReplacementPool {
    /// List of possible replacements for each symbol of the printed formula.
    swaps: FxHashMap<Expr, Vec<Expr>>,
    /// All symbols that changed formulas may contain, sorted.
    symbols: Vec<Expr>,
    /// Factors by which a term may be multiplied or divided.
    factors: Vec<Expr>,
}

impl ReplacementPool {
    /// Creates the pool for repairs of the printed formula `root`, in `arena`. `derived` is the right value, in the
    /// arena of the derivations. `abbreviations` are the abbreviations that may occur in the formula, each with its
    /// unit.
    pub fn new(
        quantities: &Quantities<'_>,
        arena: &mut Arena,
        root: Expr,
        derived: Expr,
        abbreviations: &[(Expr, Unit)],
    ) -> Self {
        let model = quantities.model;
        let main = &quantities.derivations.kinematics.arena;
        let mut transfer = Transfer::new(main);
        let printed: Vec<Expr> =
            arena.reachable(&[root]).into_iter().filter(|e| arena.symbol_name(*e).is_some()).collect();
        let in_derived = main.reachable(&[derived]);
        let all = model.parameters.len() + 3 * model.coordinates.len() + model.speeds.len();
        let offered = |e: &Expr| all <= MOST_SYMBOLS || in_derived.binary_search(e).is_ok();
        // Accelerations occur only in equations of motion.
        let used = |arena: &Arena, rate: Expr| {
            let is_printed = |e: &Expr| arena.symbol_name(*e) == main.symbol_name(rate);
            in_derived.binary_search(&rate).is_ok() || printed.iter().any(is_printed)
        };
        // Each symbol with its unit. The last entry is the symbol without dots if the symbol is a rate.
        let mut known: Vec<(Expr, Unit, Option<Expr>)> = Vec::new();
        for p in model.parameters.iter().filter(|p| offered(&p.symbol)) {
            known.push((transfer.transfer_term(arena, p.symbol), p.unit.clone(), None));
        }
        for c in model.coordinates.iter().filter(|c| offered(&c.symbol) || offered(&c.rate)) {
            let base = transfer.transfer_term(arena, c.symbol);
            known.push((base, c.unit.clone(), Some(base)));
            known.push((transfer.transfer_term(arena, c.rate), c.unit.per_second(), Some(base)));
            if used(arena, c.second_rate) {
                let unit = c.unit.per_second().per_second();
                known.push((transfer.transfer_term(arena, c.second_rate), unit, Some(base)));
            }
        }
        for s in model.speeds.iter().filter(|s| offered(&s.symbol)) {
            let base = transfer.transfer_term(arena, s.symbol);
            known.push((base, s.unit.clone(), Some(base)));
            if used(arena, s.rate) {
                known.push((transfer.transfer_term(arena, s.rate), s.unit.per_second(), Some(base)));
            }
        }
        // A speed u = q' counts as q with a dot.
        let dots: Vec<(Expr, Expr)> = model
            .speeds
            .iter()
            .filter_map(|s| Some((s, model.coordinates.iter().find(|c| c.rate == s.definition)?)))
            .map(|(s, c)| (transfer.transfer_term(arena, s.symbol), transfer.transfer_term(arena, c.symbol)))
            .collect();
        // Authors may confuse indices whatever the units are: q1' for q4'.
        let mut lists: [Vec<Expr>; 5] = [
            model.coordinates.iter().map(|c| c.symbol).collect(),
            model.coordinates.iter().map(|c| c.rate).collect(),
            model.coordinates.iter().map(|c| c.second_rate).collect(),
            model.speeds.iter().map(|s| s.symbol).collect(),
            model.speeds.iter().map(|s| s.rate).collect(),
        ];
        lists.iter_mut().flatten().for_each(|e| *e = transfer.transfer_term(arena, *e));
        let mut swaps: FxHashMap<Expr, Vec<Expr>> = FxHashMap::default();
        for symbol in &printed {
            let Some((_, unit, base)) = known.iter().find(|(s, ..)| s == symbol) else { continue };
            let same = |(other, its, of): &&(Expr, Unit, Option<Expr>)| {
                let dotted = base.is_some() && of == base;
                let speed = dots.iter().any(|(u, q)| (u == symbol && q == other) || (q == symbol && u == other));
                let index = lists.iter().any(|list| list.contains(symbol) && list.contains(other));
                other != symbol && (its == unit || dotted || speed || index)
            };
            swaps.insert(*symbol, known.iter().filter(same).map(|(other, ..)| *other).collect());
        }
        for (symbol, unit) in abbreviations.iter().filter(|(symbol, _)| printed.contains(symbol)) {
            let others = abbreviations.iter().filter(|(other, its)| other != symbol && its == unit);
            swaps.insert(*symbol, others.map(|(other, _)| *other).collect());
        }
        let mut symbols: Vec<Expr> = printed.iter().copied().chain(known.iter().map(|(s, ..)| *s)).collect();
        symbols.sort_unstable();
        symbols.dedup();
        let mut factors = symbols.clone();
        for part in in_derived {
            if let Node::Apply(Function::Sin | Function::Cos, _) = main.node(part) {
                factors.push(transfer.transfer_term(arena, part));
            }
        }
        factors.truncate(MOST_FACTORS);
        // The symbols of angles may occur, too.
        for factor in &factors {
            let more = arena.reachable(&[*factor]).into_iter().filter(|e| arena.symbol_name(*e).is_some());
            symbols.extend(more.collect::<Vec<_>>());
        }
        symbols.sort_unstable();
        symbols.dedup();
        Self { swaps, symbols, factors }
    }

    /// Symbols that may replace `symbol`: symbols of the same unit, with a dot more or less, or with another index.
    pub fn replacements_for_symbol(&self, symbol: Expr) -> &[Expr] {
        self.swaps.get(&symbol).map_or(&[], Vec::as_slice)
    }

    /// Symbols that changed formulas may contain, sorted.
    pub fn symbols(&self) -> &[Expr] {
        &self.symbols
    }

    /// Factors by which a term may be multiplied or divided.
    pub fn factors(&self) -> &[Expr] {
        &self.factors
    }
}
