//! Openings: the motions that a mechanism would have if the joints that close its loops were open.
//!
//! An equation of a closing joint may be solved for a coordinate, which then leaves the model. Reactions still need
//! the motion along that coordinate. For example, a slider transmits no force along its own axis, even if a loop
//! prevents it from sliding. So the velocities that each such coordinate gives to frames and points are kept.

use super::configuration_constraints::{OpenedCoordinates, StatedConstraint};
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::{Arena, Expr};
use crate::geometry::Turn;
use crate::model::bodies::elements::Elements;
use crate::model::{AddedVelocity, JointOpeningMotion, Placement};

/// Computes the motions along the coordinates that equations of closing joints determine. The terms of `elements` and
/// of the unsolved `constraints` must still contain these coordinates. `replacements` are the values of all
/// coordinates that constraints determine.
pub(in crate::model) fn joint_opening_motions(
    arena: &mut Arena,
    opened: &OpenedCoordinates,
    elements: &Elements,
    constraints: &[&[StatedConstraint]],
    replacements: &[(Expr, Expr)],
) -> Vec<JointOpeningMotion> {
    let mut slopes = OpeningSlopes {
        before: Substitution::new(&opened.before),
        along: Gradient::new(&opened.symbols),
        along_rates: Gradient::new(&opened.rates),
        fixed: Substitution::new(replacements),
    };
    let mut list = vec![JointOpeningMotion::default(); opened.symbols.len()];
    if list.is_empty() {
        return list;
    }
    for (at, frame) in elements.frames.iter().enumerate() {
        let spins = match &frame.rotation {
            Some((_, Turn::About(axis, angle))) => {
                let mut unit = [Expr::ZERO; 3];
                unit[*axis] = Expr::ONE;
                vec![(*angle, unit)]
            }
            Some((_, Turn::Oriented(oriented))) => oriented.spins.clone(),
            None => Vec::new(),
        };
        for (of, along) in spins {
            let along = along.map(|e| slopes.value(arena, e));
            for (which, slope) in slopes.by_coordinates(arena, of) {
                let turn = opening_velocity(&mut list[which].turns, at);
                for (sum, component) in turn.iter_mut().zip(along) {
                    let share = arena.mul(slope, component);
                    *sum = arena.add(*sum, share);
                }
            }
        }
    }
    for (at, point) in elements.points.iter().enumerate() {
        let Some(Placement { components: place, .. }) = point.position else { continue };
        for (axis, component) in place.into_iter().enumerate() {
            for (which, slope) in slopes.by_coordinates(arena, component) {
                opening_velocity(&mut list[which].moves, at)[axis] = slope;
            }
        }
    }
    for constraint in constraints.iter().copied().flatten() {
        let of_rates = slopes.by_rates(arena, constraint.equation);
        for (which, slope) in slopes.by_coordinates(arena, constraint.equation).into_iter().chain(of_rates) {
            list[which].breaks.push((constraint.name.clone(), slope));
        }
    }
    list
}

/// Three components of the velocity that the list holds for the frame or point `at`. If the list holds none, zeros
/// are added.
fn opening_velocity(list: &mut Vec<AddedVelocity>, at: usize) -> &mut [Expr; 3] {
    if list.last().is_none_or(|(last, _)| *last != at) {
        list.push((at, [Expr::ZERO; 3]));
    }
    let last = list.len() - 1;
    &mut list[last].1
}

/// Derivatives with respect to the opened coordinates and to their rates, evaluated in poses in which all joints are
/// closed. An opened coordinate is one that the equation of a closing joint determines.
struct OpeningSlopes {
    /// Values of the coordinates that the model file's own constraints determine.
    before: Substitution,
    /// Derivatives with respect to the opened coordinates.
    along: Gradient,
    /// Derivatives with respect to the rates of the opened coordinates.
    along_rates: Gradient,
    /// Values of all coordinates that constraints determine, as in poses in which all joints are closed.
    fixed: Substitution,
}

impl OpeningSlopes {
    /// Value of a term in poses in which all joints are closed.
    fn value(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        self.fixed.apply(arena, e)
    }

    /// Derivatives of a term with respect to the opened coordinates, as (index of the opened coordinate, derivative).
    fn by_coordinates(&mut self, arena: &mut Arena, e: Expr) -> Vec<(usize, Expr)> {
        let e = self.before.apply(arena, e);
        let slopes = self.along.apply(arena, e);
        slopes.iter().map(|(at, slope)| (*at, self.fixed.apply(arena, *slope))).collect()
    }

    /// Derivatives of a term with respect to the rates of the opened coordinates, as (index of the opened coordinate,
    /// derivative).
    fn by_rates(&mut self, arena: &mut Arena, e: Expr) -> Vec<(usize, Expr)> {
        let e = self.before.apply(arena, e);
        let slopes = self.along_rates.apply(arena, e);
        slopes.iter().map(|(at, slope)| (*at, self.fixed.apply(arena, *slope))).collect()
    }
}
