//! Directions in which a mechanism can move: its permitted motions, and the Lie brackets of these.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::value::rank::rank;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::model::{Model, MotionConstraint, MotionConstraintKind};

/// Largest number of Lie brackets that are computed. If more are needed, it is undecided if a
/// constraint is integrable.
const MOST_BRACKETS: usize = 200;

/// Independent vector fields of permitted motions: the columns of W, the drift w, and their Lie
/// brackets. A field has a component for each coordinate. If there is a drift and no time
/// coordinate, it has a last component for time.
pub(super) struct ReachableDirections {
    /// Vector fields found so far, each with its components.
    pub(super) fields: Vec<Vec<Expr>>,
    /// Symbols of the coordinates with respect to which the fields are differentiated.
    along: Vec<Expr>,
    /// True if one of the fields is the drift w of q̇ = W u + w, that is, if the motion is driven.
    pub(super) drifts: bool,
    /// True if no stated or rolling constraint restricts velocities. Then Lie brackets add no
    /// direction.
    is_holonomic: bool,
}

impl ReachableDirections {
    /// Collects the columns of W, and the drift w if it is not zero, from the model's equations q̇ =
    /// W u + w.
    pub(super) fn new(model: &Model, arena: &mut Arena) -> Self {
        let rates = &model.kinematic_equations.rates;
        let mut slopes = Gradient::new(&model.u());
        let mut fields = vec![vec![Expr::ZERO; rates.len()]; model.speeds.len()];
        for (at, rate) in rates.iter().enumerate() {
            for &(speed, slope) in slopes.apply(arena, *rate).iter() {
                fields[speed][at] = slope;
            }
        }
        let still: Vec<_> = model.u().into_iter().map(|u| (u, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&still);
        let mut drift: Vec<Expr> = rates.iter().map(|rate| at_rest.apply(arena, *rate)).collect();
        let drifts = drift.iter().any(|e| zero_test(arena, *e) != ZeroTest::Zero);
        if drifts {
            if model.time().is_none() {
                for field in &mut fields {
                    field.push(Expr::ZERO);
                }
                drift.push(Expr::ONE);
            }
            fields.push(drift);
        }
        let of_velocities =
            |c: &MotionConstraint| matches!(c.kind, MotionConstraintKind::Stated | MotionConstraintKind::Rolling(_));
        let is_holonomic = !model.motion_constraints.iter().any(of_velocities);
        Self { fields, along: model.q(), drifts, is_holonomic }
    }

    /// Adds Lie brackets of the fields until no bracket is independent. Returns false if too many
    /// brackets were computed or a rank is undecided.
    pub(super) fn close_under_brackets(&mut self, arena: &mut Arena) -> bool {
        let mut simplifier = Simplifier::default();
        let mut tried = 0;
        let mut later = 1;
        if self.is_holonomic {
            return true;
        }
        while later < self.fields.len() {
            for earlier in 0..later {
                // There are as many independent fields as components, so no further field can be
                // independent.
                if self.fields.len() == self.fields[0].len() {
                    return true;
                }
                tried += 1;
                if tried > MOST_BRACKETS {
                    return false;
                }
                let bracket = self.bracket(arena, &mut simplifier, later, earlier);
                self.fields.push(bracket);
                match rank(arena, &self.fields).map(|found| found.dependent.is_none()) {
                    Some(true) => {}
                    Some(false) => {
                        self.fields.pop();
                    }
                    None => return false,
                }
            }
            later += 1;
        }
        true
    }

    /// Lie bracket `[X, Y] = (∂Y/∂q) X − (∂X/∂q) Y` of the fields with the indices `x` and `y`.
    fn bracket(&self, arena: &mut Arena, simplifier: &mut Simplifier, x: usize, y: usize) -> Vec<Expr> {
        let mut gradient = Gradient::new(&self.along);
        let (x, y) = (&self.fields[x], &self.fields[y]);
        let mut along = |arena: &mut Arena, of: Expr, field: &[Expr]| {
            let slopes = gradient.apply(arena, of);
            let terms: Vec<Expr> = slopes.iter().map(|(at, slope)| arena.mul(*slope, field[*at])).collect();
            arena.sum(&terms)
        };
        x.iter()
            .zip(y)
            .map(|(of_x, of_y)| {
                let (there, back) = (along(arena, *of_y, x), along(arena, *of_x, y));
                let difference = arena.sub(there, back);
                simplifier.simplify(arena, difference)
            })
            .collect()
    }

    /// True if every field satisfies a motion constraint, so that the constraint is integrable.
    /// `None` if this is undecided.
    pub(super) fn satisfies_constraint(
        &self,
        model: &Model,
        arena: &mut Arena,
        constraint: &MotionConstraint,
    ) -> Option<bool> {
        let mut row = vec![Expr::ZERO; model.coordinates.len()];
        for &(at, slope) in Gradient::new(&model.q_dot()).apply(arena, constraint.equation).iter() {
            row[at] = slope;
        }
        match model.time() {
            Some(time) => row[time] = arena.add(row[time], constraint.drive),
            None => row.push(constraint.drive),
        }
        let mut is_decided = true;
        for field in &self.fields {
            let terms: Vec<Expr> = row.iter().zip(field).map(|(a, x)| arena.mul(*a, *x)).collect();
            let sum = arena.sum(&terms);
            match zero_test(arena, sum) {
                ZeroTest::Zero => {}
                ZeroTest::NonZero => return Some(false),
                ZeroTest::Undecided => is_decided = false,
            }
        }
        is_decided.then_some(true)
    }
}
