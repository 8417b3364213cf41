//! Values of the names that a publication gives to derived quantities.

use super::Publication;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Substitution;
use crate::mechanics::Quantities;

/// Symbols of the text with the derived values that they stand for; a symbol without a value has a reason.
pub struct Names {
    /// (symbol, value in q and u)
    values: Vec<(Expr, Expr)>,
    /// (symbol, reason)
    missing: Vec<(Expr, String)>,
}

impl Names {
    /// The derived values of a publication's `[names]`.
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

    /// A printed term, in the arena of the derivations, with its symbols replaced.
    ///
    /// # Errors
    /// Why one of its symbols has no value, or that it divides by one that is zero.
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
