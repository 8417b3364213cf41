//! Exact comparisons of derived and printed terms, in limited number. After the last allowed comparison, every answer
//! is no.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::permitted::Permitted;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::diff::formulas::ratio::constant_ratio;
use crate::mechanics::{Quantities, QuantityKind};

/// Most comparisons that the search for the roots of one publication may use.
const COMPARISONS: usize = 20_000;

/// Wrong value of a quantity, printed and derived, in q, u and u̇.
#[derive(Clone)]
pub struct Value {
    /// Kind of the quantity, with its indices.
    pub kind: QuantityKind,
    /// Printed value of the quantity.
    pub printed: Expr,
    /// Derived value of the quantity.
    pub derived: Expr,
}

/// Comparison of terms of a model's quantities, up to a limited number.
pub struct Exact<'a, 'b> {
    /// Derived quantities, with the store of all terms.
    pub quantities: &'a mut Quantities<'b>,
    comparer: Comparer,
    left: usize,
}

impl<'a, 'b> Exact<'a, 'b> {
    /// Comparison with the full number of comparisons left.
    pub fn new(quantities: &'a mut Quantities<'b>, permitted: &Permitted) -> Self {
        Self { quantities, comparer: Comparer::within(permitted.clone()), left: COMPARISONS }
    }

    /// True if no comparison is left.
    pub fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// True if two terms are equal by meaning in permitted states; false after the last comparison.
    pub fn same(&mut self, a: Expr, b: Expr) -> bool {
        if self.is_spent() {
            return false;
        }
        self.left -= 1;
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let difference = arena.sub(a, b);
        let difference = self.comparer.permitted().put(arena, difference);
        let difference = self.comparer.with_plain_angles(arena, difference);
        // No witness is needed: terms proved to differ need no further test.
        zero_test(arena, difference) != ZeroTest::NonZero && self.comparer.is_zero(arena, difference).is_equal()
    }

    /// Ratio a / b; `None` unless it depends on parameters only, or after the last comparison.
    pub fn ratio(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        self.left = self.left.checked_sub(1)?;
        constant_ratio(self.quantities, &mut self.comparer, a, b)
    }
}
