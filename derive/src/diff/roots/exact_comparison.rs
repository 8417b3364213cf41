//! Exact comparisons of derived and printed terms, with a limit on their number. Beyond the limit, every answer is
//! "no".

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::permitted_states::PermittedStates;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::diff::formulas::ratio::constant_ratio;
use crate::mechanics::{Quantities, QuantityKind};

/// Largest number of comparisons in the search for the root mistakes of one publication.
const COMPARISONS: usize = 20_000;

/// Wrong value of a quantity, as printed and as derived, both as functions of q, u and u̇.
#[derive(Clone)]
pub struct WrongValue {
    /// Kind of the quantity whose printed value is wrong, with its indices.
    pub kind: QuantityKind,
    /// Printed, wrong value of the quantity.
    pub printed: Expr,
    /// Derived, right value of the quantity.
    pub derived: Expr,
}

/// Exact comparison of terms, with a limit on the number of comparisons.
pub struct ExactComparison<'a, 'b> {
    /// Derived quantities, with the arena of all terms.
    pub quantities: &'a mut Quantities<'b>,
    /// Comparer that decides the equality of terms in states that the constraints permit.
    comparer: Comparer,
    /// Number of comparisons that may still be made.
    left: usize,
}

impl<'a, 'b> ExactComparison<'a, 'b> {
    /// Creates a comparison in the states `permitted`, with the full number of comparisons left.
    pub fn new(quantities: &'a mut Quantities<'b>, permitted: &PermittedStates) -> Self {
        Self { quantities, comparer: Comparer::in_permitted_states(permitted.clone()), left: COMPARISONS }
    }

    /// True if no comparison is left, so that every further answer is no.
    pub fn has_no_comparisons_left(&self) -> bool {
        self.left == 0
    }

    /// True if two terms are equal in all states that the constraints permit.
    /// False if they differ, or if no comparison is left.
    pub fn compare_exactly(&mut self, a: Expr, b: Expr) -> bool {
        if self.has_no_comparisons_left() {
            return false;
        }
        self.left -= 1;
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let difference = arena.sub(a, b);
        let difference = self.comparer.permitted().write_in_free_symbols(arena, difference);
        let difference = self.comparer.expand_angles(arena, difference);
        // Terms that are proved to differ need no further test, since no state with numbers is wanted.
        zero_test(arena, difference) != ZeroTest::NonZero && self.comparer.is_zero(arena, difference).is_equal()
    }

    /// Ratio a / b; `None` unless the ratio depends on parameters only, or if no comparison is
    /// left.
    pub fn exact_ratio(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        self.left = self.left.checked_sub(1)?;
        constant_ratio(self.quantities, &mut self.comparer, a, b)
    }
}
