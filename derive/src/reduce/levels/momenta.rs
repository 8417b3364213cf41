//! Momenta that are held fixed, each with a symbol for its value.

use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::fresh_symbol;
use crate::model::{Model, Unit};
use crate::prove::IntegralKind;
use crate::reduce::basis::ground::{Ground, Momentum};
use crate::reduce::basis::prose::Prose;

/// A momentum that is held fixed.
#[derive(Clone)]
pub struct Held {
    /// Its place among the momenta of the ground.
    pub momentum: usize,
    /// The symbol of its value.
    pub symbol: Expr,
    /// Value of the symbol, in q and u: the momentum, or the remaining part of it on a singular surface.
    pub of_state: Expr,
    /// Description of the symbol, in words.
    pub about: Prose,
    /// Its unit.
    pub unit: Unit,
}

impl Ground {
    /// A momentum with a symbol for its value.
    pub(in crate::reduce) fn hold(&mut self, at: usize) -> Held {
        let momentum = &self.momenta[at];
        let wanted = symbol_of(&self.model, momentum, at);
        let (of_state, about) = (momentum.value, momentum.about.as_str().into());
        let unit = momentum.unit.clone();
        Held { momentum: at, symbol: fresh_symbol(&mut self.arena, &wanted), of_state, about, unit }
    }

    /// Right-hand sides of a momentum's row: row · u = c − b, and row · u̇ = minus the change of the row times u and of
    /// b along the motion.
    pub(in crate::reduce) fn right_of(&mut self, held: &Held) -> Vec<Expr> {
        let momentum = &self.momenta[held.momentum];
        let arena = &mut self.arena;
        let along: Vec<(Expr, Expr)> = self.q.iter().copied().zip(self.kane.coordinate_rates.iter().copied()).collect();
        let mut change = Differential::along(&along);
        let mut terms = vec![change.apply(arena, momentum.rest)];
        for (entry, u) in momentum.row.iter().zip(&self.kane.variables) {
            let slope = change.apply(arena, *entry);
            terms.push(arena.mul(slope, *u));
        }
        let sum = arena.sum(&terms);
        let back = arena.neg(sum);
        let at_level = arena.sub(held.symbol, momentum.rest);
        [at_level, back].map(|e| self.simplifier.simplify(arena, e)).to_vec()
    }
}

/// Symbol of a momentum: `p_q3` for the momentum of a coordinate, else its customary symbol, else `momentum2`. A
/// momentum with a function of place beside it is another quantity: `p_q3_total`.
fn symbol_of(model: &Model, momentum: &Momentum, at: usize) -> String {
    let kinds = &momentum.kinds;
    let of_coordinate = kinds.iter().find(|kind| matches!(kind, IntegralKind::Coordinate(_)));
    let found = of_coordinate.into_iter().chain(kinds).find_map(|kind| kind.symbol(model));
    let total = if momentum.has_place { "_total" } else { "" };
    found.map_or_else(|| format!("momentum{}", at + 1), |symbol| symbol + total)
}
