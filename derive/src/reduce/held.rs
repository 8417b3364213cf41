//! Momenta that are held fixed, each with a symbol for its value.

use super::ground::{Ground, Momentum};
use super::prose::Prose;
use crate::algebra::Expr;
use crate::algebra::calculus::Differential;
use crate::algebra::steps::fresh_symbol;
use crate::model::{Model, Unit};
use crate::prove::IntegralKind;

/// A momentum that is held fixed.
#[derive(Clone)]
pub struct Held {
    /// Its place among the momenta of the ground.
    pub momentum: usize,
    /// The symbol of its value.
    pub symbol: Expr,
    /// What the symbol is, in q and u: the momentum, or what is left of it on a singular surface.
    pub of_state: Expr,
    /// What the symbol is, in words.
    pub about: Prose,
    /// Its unit.
    pub unit: Unit,
}

impl Ground {
    /// A momentum with a symbol for its value.
    pub(super) fn hold(&mut self, at: usize) -> Held {
        let momentum = &self.momenta[at];
        let wanted = symbol_of(&self.model, momentum, at);
        let (of_state, about) = (momentum.value, momentum.about.as_str().into());
        let unit = momentum.unit.clone();
        Held { momentum: at, symbol: fresh_symbol(&mut self.arena, &wanted), of_state, about, unit }
    }

    /// What a momentum's row times u is, c − b, and what it times u̇ is: minus the change of the row and of b along the
    /// motion.
    pub(super) fn right_of(&mut self, held: &Held) -> Vec<Expr> {
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

/// `p_q3` where it is the momentum of a coordinate, else its customary symbol; `momentum2` where it has none. With a function of
/// place beside it, it is another quantity: `p_q3_total`.
fn symbol_of(model: &Model, momentum: &Momentum, at: usize) -> String {
    let kinds = &momentum.kinds;
    let of_coordinate = kinds.iter().find(|kind| matches!(kind, IntegralKind::Coordinate(_)));
    let found = of_coordinate.into_iter().chain(kinds).find_map(|kind| kind.symbol(model));
    let total = if momentum.has_place { "_total" } else { "" };
    found.map_or_else(|| format!("momentum{}", at + 1), |symbol| symbol + total)
}
