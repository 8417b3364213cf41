//! Tests for terms that do not depend on the state, or that keep their value in every motion.

use crate::algebra::Expr;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::term::calculus::Differential;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::mechanics::Quantities;

/// True if a term has the same value in every state: its derivatives by q, u and q̇ are zero.
pub fn is_constant(quantities: &mut Quantities<'_>, e: Expr) -> bool {
    let model = quantities.model;
    let arena = &mut quantities.derivations.kinematics.arena;
    let variables = [model.q(), model.u(), model.q_dot()].concat();
    variables.into_iter().all(|symbol| {
        let slope = Differential::partial(symbol).apply(arena, e);
        zero_test(arena, slope) == ZeroTest::Zero
    })
}

/// True if a term keeps its value in every motion that the constraints permit: it does not depend on the speeds, and
/// its time derivative is 0.
pub fn is_constant_in_motion(quantities: &mut Quantities<'_>, comparer: &mut Comparer, e: Expr) -> bool {
    let model = quantities.model;
    let e = quantities.in_speeds(e);
    let along = model.q().into_iter().zip(model.kinematic_equations.rates.iter().copied());
    let rate = Differential::along(&along.collect::<Vec<_>>()).apply(&mut quantities.derivations.kinematics.arena, e);
    let arena = &mut quantities.derivations.kinematics.arena;
    let slopes = model.u().into_iter().map(|speed| Differential::partial(speed).apply(arena, e));
    let slopes: Vec<Expr> = slopes.chain([rate]).collect();
    slopes.into_iter().all(|slope| comparer.compare(arena, slope, Expr::ZERO).is_equal())
}
