//! Balances of bodies along the directions of reactions. Such a balance gives the reaction without a division.

use crate::algebra::Expr;
use crate::geometry::Vector;
use crate::mechanics::motion::kinematics::Kinematics;
use crate::mechanics::rows::{BalanceName, RowName};
use crate::model::{Model, ReactionKind};

/// Multipliers of `rows`, one list for each reaction, that add the rows up to the balance of the reaction's body
/// along the reaction. They are the components of the reaction's unit direction, so the reaction has the coefficient
/// 1 in the sum.
pub fn balance_multipliers_along_reactions(
    model: &Model,
    kinematics: &mut Kinematics,
    rows: &[RowName],
) -> Vec<Vec<Expr>> {
    let mut result = Vec::new();
    for reaction in &model.reactions {
        let (body, moments) = match reaction.kind {
            ReactionKind::Force { on, .. } => (on.body, false),
            ReactionKind::Torque { on, .. } => (on, true),
        };
        let direction = Vector::in_frame(reaction.frame, reaction.direction);
        let Kinematics { arena, frames, simplifier, .. } = kinematics;
        let mut entry = |row: &RowName| match row {
            RowName::Balance(BalanceName { body: of, moments: kind, frame, axis })
                if (*of, *kind) == (body, moments) =>
            {
                let component = frames.express(arena, &direction, *frame)[*axis];
                simplifier.simplify(arena, component)
            }
            _ => Expr::ZERO,
        };
        result.push(rows.iter().map(&mut entry).collect());
    }
    result
}
