//! Values of the names that a publication gives to derived quantities.

use super::Publication;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Substitution;
use crate::mechanics::Quantities;

/// Symbols of a publication with the derived values for which they stand; a symbol without a value has a reason.
pub struct Names {
    /// Symbols, each with its value in q and u.
    values: Vec<(Expr, Expr)>,
    /// Symbols without a value, each with the reason.
    missing: Vec<(Expr, String)>,
}

impl Names {
    /// Derived values of the symbols of a publication's `[names]`.
    #[must_use]
    pub fn new(publication: &Publication, quantities: &mut Quantities<'_>) -> Self {
        let (mut values, mut missing) = (Vec::new(), Vec::new());
        for (_, quantity, symbol) in &publication.names {
            match quantities.value(quantity) {
                Ok(value) => values.push((*symbol, value)),
                Err(why) => missing.push((*symbol, why)),
            }
        }
        Self { values, missing }
    }

    /// Replaces the symbols of derived quantities in a printed term by their values, in the arena of the derivations.
    ///
    /// # Errors
    /// The reason why a symbol has no value, or that the term divides by a quantity that is zero.
    pub fn resolve(&self, quantities: &mut Quantities<'_>, e: Expr) -> Result<Expr, String> {
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
