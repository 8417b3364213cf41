//! Time derivatives in the formulas of a publication.

use crate::algebra::term::calculus::Differential;
use crate::algebra::{Arena, Expr};
use crate::model::Model;

/// Rule for the time derivative of formulas in the symbols of a model.
pub struct TimeDerivatives {
    /// Rule of differentiation along the motion: q → q̇ → q̈ and u → u̇.
    d_dt: Differential,
    /// Symbols without a time derivative: accelerations, reactions and the symbols of derived
    /// quantities.
    still: Vec<Expr>,
}

impl TimeDerivatives {
    /// Creates the rule for the coordinates, their rates and the generalized speeds of a model.
    pub fn new(model: &Model) -> Self {
        let mut rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        rates.extend(model.coordinates.iter().map(|c| (c.rate, c.second_rate)));
        rates.extend(model.speeds.iter().map(|s| (s.symbol, s.rate)));
        let accelerations = model.coordinates.iter().map(|c| c.second_rate).chain(model.speeds.iter().map(|s| s.rate));
        let still = accelerations.chain(model.reactions.iter().map(|r| r.symbol)).collect();
        Self { d_dt: Differential::along(&rates), still }
    }

    /// Time derivative of the term `e` along the motion.
    ///
    /// # Errors
    /// Message that a symbol in the term has no time derivative, and advice.
    pub fn time_derivative(&mut self, arena: &mut Arena, e: Expr) -> Result<Expr, (String, Option<String>)> {
        let parts = arena.reachable(&[e]);
        if let Some(still) = self.still.iter().find(|symbol| parts.binary_search(symbol).is_ok()) {
            let name = arena.symbol_name(*still).unwrap_or_default();
            let help = "a time derivative here is of coordinates, their rates and speeds";
            return Err((format!("no time derivative of `{name}` is known"), Some(help.to_owned())));
        }
        Ok(self.d_dt.apply(arena, e))
    }

    /// Records a symbol that has no time derivative, such as the symbol of a derived quantity.
    pub fn exclude_symbol(&mut self, symbol: Expr) {
        self.still.push(symbol);
    }
}
