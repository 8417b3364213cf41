//! Variables in which a printed formula is read and compared with the derived formula.

use crate::algebra::Expr;
use crate::mechanics::{Formulation, Quantities};
use crate::publication::QuantityNames;

/// Variables in which a printed formula is compared with the derived formula.
#[derive(Clone, Copy, Debug)]
pub struct FormulaReading {
    /// True if the formula is in q and q̇; false if it is in q and u.
    pub in_rates: bool,
    /// True if accelerations in the formula are replaced with their derived values.
    pub is_solved: bool,
}

impl FormulaReading {
    /// Variables for the formulas of a printed system: those of its formulation.
    pub fn of(formulation: Formulation) -> Self {
        Self { in_rates: formulation.is_in_rates(), is_solved: false }
    }

    /// Value of a printed term, in which the names of derived quantities are replaced with their values.
    ///
    /// # Errors
    /// Reason why the term has no value.
    pub fn value(self, quantities: &mut Quantities<'_>, names: &QuantityNames, e: Expr) -> Result<Expr, String> {
        let e = names.resolve_quantity_names(quantities, e)?;
        let e = if self.is_solved { quantities.solved(e)? } else { e };
        Ok(if self.in_rates { quantities.in_rates(e) } else { quantities.in_speeds(e) })
    }
}
