//! Test for terms that do not depend on the state.

use crate::algebra::Expr;
use crate::algebra::term::calculus::Differential;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::mechanics::Quantities;

/// True if a term has the same value in every state.
pub fn is_constant(quantities: &mut Quantities<'_>, e: Expr) -> bool {
    let model = quantities.model;
    let arena = &mut quantities.derivations.kinematics.arena;
    let variables = [model.q(), model.u(), model.q_dot()].concat();
    variables.into_iter().all(|symbol| {
        let slope = Differential::partial(symbol).apply(arena, e);
        zero_test(arena, slope) == ZeroTest::Zero
    })
}
