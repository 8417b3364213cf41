//! Momenta that are kept constant, each with a symbol for its value.

use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::fresh_symbol;
use crate::model::{Model, Unit};
use crate::prove::IntegralKind;
use crate::reduce::basis::prose::Prose;
use crate::reduce::basis::reduction_basis::{Momentum, ReductionBasis};

/// Momentum that is kept constant, with a symbol for its value.
#[derive(Clone)]
pub struct HeldMomentum {
    /// Index of the momentum in `ReductionBasis::momenta`.
    pub momentum: usize,
    /// Symbol of the constant value of the momentum.
    pub symbol: Expr,
    /// Value of the constant as a term in q and u: the momentum itself, or the part of it that
    /// remains on a singular surface.
    pub of_state: Expr,
    /// Description of the constant for people, in words and terms.
    pub about: Prose,
    /// Unit of the constant momentum.
    pub unit: Unit,
}

impl ReductionBasis {
    /// Creates a new symbol for the constant value of the momentum with this index.
    pub(in crate::reduce) fn hold_momentum(&mut self, at: usize) -> HeldMomentum {
        let momentum = &self.momenta[at];
        let wanted = held_momentum_name(&self.model, momentum, at);
        let (of_state, about) = (momentum.value, momentum.about.as_str().into());
        let unit = momentum.unit.clone();
        HeldMomentum { momentum: at, symbol: fresh_symbol(&mut self.arena, &wanted), of_state, about, unit }
    }

    /// Two right-hand sides that follow from the momentum row · u + b = c. The first is c − b, for
    /// row · u. The second is −(d row/dt · u + db/dt), for row · u̇.
    pub(in crate::reduce) fn momentum_right_sides(&mut self, held: &HeldMomentum) -> Vec<Expr> {
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

/// Name for the symbol of a constant momentum. It is `p_q3` for the momentum of a coordinate, else
/// its customary symbol, else for example `momentum2`. If a function of q is added to the momentum,
/// the name ends in `_total`.
fn held_momentum_name(model: &Model, momentum: &Momentum, at: usize) -> String {
    let kinds = &momentum.kinds;
    let of_coordinate = kinds.iter().find(|kind| matches!(kind, IntegralKind::Coordinate(_)));
    let found = of_coordinate.into_iter().chain(kinds).find_map(|kind| kind.symbol(model));
    let total = if momentum.has_place { "_total" } else { "" };
    found.map_or_else(|| format!("momentum{}", at + 1), |symbol| symbol + total)
}
