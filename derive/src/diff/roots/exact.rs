//! Exact comparisons of derived and printed terms, counted: after the last allowed one, every answer is no.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::meaning::permitted::Permitted;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::diff::formulas::ratio::constant_ratio;
use crate::mechanics::{Quantities, QuantityKind};

/// Number of comparisons that one publication may cost.
const COMPARISONS: usize = 20_000;

/// A wrong value of a quantity, in q, u and u̇.
#[derive(Clone)]
pub struct Value {
    /// The quantity.
    pub kind: QuantityKind,
    /// The printed value.
    pub printed: Expr,
    /// The derived value.
    pub derived: Expr,
}

/// Comparison of terms of a model's quantities, up to a limited number.
pub struct Exact<'a, 'b> {
    /// The derived quantities.
    pub quantities: &'a mut Quantities<'b>,
    comparer: Comparer,
    left: usize,
}

impl<'a, 'b> Exact<'a, 'b> {
    /// Starts with all comparisons left.
    pub fn new(quantities: &'a mut Quantities<'b>, permitted: &Permitted) -> Self {
        Self { quantities, comparer: Comparer::within(permitted.clone()), left: COMPARISONS }
    }

    /// True if no comparison is left.
    pub fn is_spent(&self) -> bool {
        self.left == 0
    }

    /// True if two terms are equal by meaning.
    pub fn same(&mut self, a: Expr, b: Expr) -> bool {
        if self.is_spent() {
            return false;
        }
        self.left -= 1;
        let arena = &mut self.quantities.derivations.kinematics.arena;
        let difference = arena.sub(a, b);
        let difference = self.comparer.permitted().put(arena, difference);
        let difference = self.comparer.with_plain_angles(arena, difference);
        // No witness is wanted: what is shown to differ is left at once.
        zero_test(arena, difference) != ZeroTest::NonZero && self.comparer.is_zero(arena, difference).is_equal()
    }

    /// a / b, if it depends on parameters alone.
    pub fn ratio(&mut self, a: Expr, b: Expr) -> Option<Expr> {
        self.left = self.left.checked_sub(1)?;
        constant_ratio(self.quantities, &mut self.comparer, a, b)
    }
}
