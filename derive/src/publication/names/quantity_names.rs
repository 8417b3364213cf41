//! Derived values of the names that a publication gives to derived quantities.

use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Quantities, Quantity, QuantityKind, RowQuantity};
use crate::publication::Publication;

/// Symbols of a publication for derived quantities, each with its derived value or the reason why there is none.
pub struct QuantityNames {
    /// Symbols with a value, each with its value as a function of q and u.
    values: Vec<(Expr, Expr)>,
    /// Symbols that have no derived value, each with the reason.
    missing: Vec<(Expr, String)>,
    /// Symbols of partial derivatives ∂/∂t of momenta, each with the value of the total derivative d/dt of the
    /// momentum.
    held: Vec<(Expr, Expr)>,
}

impl QuantityNames {
    /// Computes the derived values of the symbols in a publication's table `[names]`.
    #[must_use]
    pub fn new(publication: &Publication, quantities: &mut Quantities<'_>) -> Self {
        let (mut values, mut missing, mut held) = (Vec::new(), Vec::new(), Vec::new());
        for (_, quantity, symbol) in &publication.names {
            if let QuantityKind::Row(RowQuantity::HeldMomentumRate, at) = *quantity.kind() {
                let rate = Quantity::new(QuantityKind::Row(RowQuantity::MomentumRate, at), quantities.model);
                held.extend(quantities.value(&rate).ok().map(|value| (*symbol, value)));
            }
            match quantities.value(quantity) {
                Ok(value) => values.push((*symbol, value)),
                Err(why) => missing.push((*symbol, why)),
            }
        }
        Self { values, missing, held }
    }

    /// Copy in which every ∂/∂t has the value of d/dt; `None` unless one of `terms` contains a ∂/∂t.
    #[must_use]
    pub fn with_total_rates(&self, arena: &Arena, terms: &[Expr]) -> Option<Self> {
        let parts = arena.reachable(terms);
        let is_used = self.held.iter().any(|(symbol, _)| parts.binary_search(symbol).is_ok());
        let total = |(symbol, value): &(Expr, Expr)| {
            let rate = self.held.iter().find(|(held, _)| held == symbol);
            (*symbol, rate.map_or(*value, |(_, rate)| *rate))
        };
        let values = self.values.iter().map(total).collect();
        is_used.then(|| Self { values, missing: self.missing.clone(), held: Vec::new() })
    }

    /// Replaces the symbols of derived quantities in a printed term with their derived values.
    ///
    /// # Errors
    /// Reason why a symbol has no value, or a message that the term divides by a quantity that is zero.
    pub fn resolve_quantity_names(&self, quantities: &mut Quantities<'_>, e: Expr) -> Result<Expr, String> {
        let arena = &mut quantities.derivations.kinematics.arena;
        let parts = arena.reachable(&[e]);
        if let Some((_, why)) = self.missing.iter().find(|(symbol, _)| parts.binary_search(symbol).is_ok()) {
            return Err(why.clone());
        }
        let mut substitution = Substitution::new(&self.values);
        let resolved = substitution.apply(arena, e);
        match substitution.undefined {
            Some(_) => Err("it divides by a quantity that is zero".to_owned()),
            None => Ok(resolved),
        }
    }
}
