//! Choices made in the closed poses of a mechanism: redundant constraints, and the joint speeds that become
//! generalized speeds.

use super::closed_pose_search::{ClosedPoseSearch, MeantPoses, orientation_program, random_coordinate_ranges};
use super::closed_poses::{ClosedPoses, RedundantRow};
use super::motion_constraints::{MotionConstraints, SpeedDefinitions};
use crate::algebra::Expr;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::value::rank::rank;
use crate::model::reading::loading::Loading;
use crate::model::{Coordinate, MotionConstraintKind, RedundantConstraint, Unit};
use crate::plain_text::with_significant_digits;
use std::ops::{Range, RangeInclusive};

impl Loading<'_> {
    /// Removes from `ties` the constraints that follow from others in all poses in which the loops are closed. If
    /// there are too many speeds, chooses among those of joints.
    ///
    /// If no closed pose is found, removes the constraints at the indices `also`. Their rates follow from the other
    /// constraints in every pose.
    pub fn remove_redundant_constraints(
        &mut self,
        coordinates: &[Coordinate],
        speeds: SpeedDefinitions<'_>,
        defaults: &[(Expr, f64)],
        meant: MeantPoses<'_>,
        also: Range<usize>,
        ties: &mut MotionConstraints,
    ) {
        let SpeedDefinitions { definitions: speeds, brought } = speeds;
        if ties.loops.is_empty() {
            return;
        }
        let declared = brought.iter().filter(|brought| !**brought).count()..=speeds.len();
        let home = meant.home;
        let found = self.redundancy_in_closed_poses(coordinates, speeds, declared, defaults, meant, ties);
        let closed = match (found, home) {
            (Ok(closed), _) => closed,
            (Err(gap), Some((_, place))) => {
                self.report_open_assembly(gap.map(|(at, gap)| (ties.loops[at].name.as_str(), gap)), place);
                return;
            }
            (Err(_), None) => {
                for at in also.rev() {
                    remove_redundant_constraint_at(ties, at);
                }
                return;
            }
        };
        let count = ties.motion.len();
        ties.branch = Some(closed.branch().clone());
        let (stated, may_go): (Vec<usize>, Vec<usize>) = (0..speeds.len()).partition(|at| !brought[*at]);
        let kept: Vec<usize> = closed.independent().iter().copied().chain(stated.iter().map(|at| count + at)).collect();
        let wanted = coordinates.len().saturating_sub(kept.len());
        if may_go.len() > wanted {
            let among = may_go.iter().map(|at| count + at).collect();
            let chosen = closed.choose_independent_rows(kept.clone(), among, wanted);
            let rows: Vec<usize> = kept.into_iter().chain(chosen.iter().copied()).collect();
            if let Some((_, place)) = home
                && self.are_dependent(coordinates, speeds, &rows, ties)
            {
                self.report_singular_assembly(coordinates, &closed.undetermined_coordinates(&rows), place);
                return;
            }
            ties.speeds = Some(stated.into_iter().chain(chosen.into_iter().map(|row| row - count)).collect());
        }
        let names: Vec<String> = ties.motion.iter().map(|(c, _)| c.name.clone()).collect();
        for RedundantRow { at, of } in closed.dependent().iter().rev() {
            let (name, equation) = remove_redundant_constraint_at(ties, *at);
            let of = of.iter().map(|at| names[*at].clone()).collect();
            ties.dependent.insert(0, RedundantConstraint { name, equation, of, poses: closed.count() });
        }
    }

    /// True if rows depend on one another in every pose. They are indices of constraints, and of speeds after these.
    fn are_dependent(
        &mut self,
        coordinates: &[Coordinate],
        speeds: &[Expr],
        rows: &[usize],
        ties: &MotionConstraints,
    ) -> bool {
        let count = ties.motion.len();
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let equation = |row: &usize| if *row < count { ties.motion[*row].0.equation } else { speeds[row - count] };
        let rows = rows.iter().map(equation).map(|e| form.coefficients(&mut self.arena, e).map(|(row, _)| row));
        let rows: Result<Vec<Vec<Expr>>, _> = rows.collect();
        rows.is_ok_and(|rows| rank(&self.arena, &rows).is_some_and(|found| found.dependent.is_some()))
    }

    /// Reports that no pose with closed loops is near the assembled pose. `widest` is the loop that stays open the most
    /// in the pose in which the search ended, with its gap in SI units.
    fn report_open_assembly(&mut self, widest: Option<(&str, f64)>, place: &Range<usize>) {
        let widest = widest.filter(|(_, gap)| *gap != 0.0).map(|(name, gap)| {
            let gap = with_significant_digits(gap.abs(), 2);
            format!(": `{name}` stays open by {gap} in the nearest pose that was found")
        });
        let message = "no pose with closed loops is near the values under `assembly`".to_owned();
        let help = "state values nearer to a pose in which the mechanism is assembled, and in which it can move; a small \
                    gap remains if positions or axes of the loop do not fit exactly";
        self.reader.error(place.clone(), message + widest.as_deref().unwrap_or_default(), help);
    }

    /// Reports that no choice of speeds determines the rates of the coordinates `undetermined` at the assembled pose.
    fn report_singular_assembly(&mut self, coordinates: &[Coordinate], undetermined: &[usize], place: &Range<usize>) {
        let names: Vec<String> = undetermined.iter().map(|at| format!("`{}`", coordinates[*at].name)).collect();
        let rates = if names.is_empty() { "all coordinates".to_owned() } else { names.join(", ") };
        let message = format!(
            "the speeds of joints do not determine the rates of {rates} in the pose under `assembly`, nor near it: the \
             angles of a joint are singular there"
        );
        let help = "state another pose, or give the joint of these coordinates another `sequence`, such as \"euler\"";
        self.reader.error(place.clone(), message, help);
    }

    /// Finds closed poses that are meant, with the derivatives of constraints and speeds in them. The poses are on a
    /// branch whose number of degrees of freedom is in `declared`, if the search reaches one. If no closed pose is
    /// found, the error is the loop that stays open the most near the assembled pose, as (index, gap in SI units).
    fn redundancy_in_closed_poses(
        &mut self,
        coordinates: &[Coordinate],
        speeds: &[Expr],
        declared: RangeInclusive<usize>,
        defaults: &[(Expr, f64)],
        meant: MeantPoses<'_>,
        ties: &MotionConstraints,
    ) -> Result<ClosedPoses, Option<(usize, f64)>> {
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let mut form = LinearForm::new(&rates);
        let equations = ties.motion.iter().map(|(c, _)| c.equation).chain(speeds.iter().copied());
        let rows: Result<Vec<Vec<Expr>>, _> =
            equations.map(|e| form.coefficients(&mut self.arena, e).map(|(row, _)| row)).collect();
        // A row that is not linear is reported later, when the equations are solved for the rates.
        let rows = rows.map_err(|_| None)?;
        let lengths = defaults.iter().filter(|(symbol, _)| self.units.get(symbol) == Some(&Unit::new(1, 0, 0)));
        let reach =
            random_coordinate_ranges(coordinates.iter().map(|c| c.unit.is_plain()), lengths.map(|(_, value)| *value));
        let places: Vec<Expr> = coordinates.iter().map(|c| c.symbol).collect();
        let equations: Vec<Expr> = ties.loops.iter().map(|c| c.equation).collect();
        let sides = orientation_program(&self.arena, defaults, &places, meant.orientations);
        let home = meant.home.map(|(pose, _)| pose);
        let poses = ClosedPoseSearch {
            known: defaults,
            coordinates: &places,
            reach: &reach,
            loops: &equations,
            flat: 0.0,
            sides: sides.as_ref(),
            home,
        };
        let of_constraint = |kind: MotionConstraintKind| match kind {
            MotionConstraintKind::Loop(at) => Some(at),
            _ => None,
        };
        let constraints: Vec<Option<usize>> = ties.motion.iter().map(|(c, _)| of_constraint(c.kind)).collect();
        let arena = &mut self.arena.clone();
        let closed = ClosedPoses::new(arena, &poses, &constraints, &rows, declared);
        closed.ok_or_else(|| home.and_then(|home| poses.widest_gap_near(arena, home)))
    }
}

/// Removes the constraint at the index `at` from the independent constraints. Its loop equation, if it has one, moves
/// to the loops that must still be closed. Returns its name and, for a constraint between velocities, the term that
/// it makes zero.
fn remove_redundant_constraint_at(ties: &mut MotionConstraints, at: usize) -> (String, Option<Expr>) {
    let (constraint, _) = ties.motion.remove(at);
    let MotionConstraintKind::Loop(place) = constraint.kind else {
        return (constraint.name, Some(constraint.equation));
    };
    ties.closed.insert(0, ties.loops.remove(place));
    for (other, _) in &mut ties.motion {
        if let MotionConstraintKind::Loop(at) = &mut other.kind {
            *at -= usize::from(*at > place);
        }
    }
    (constraint.name, None)
}
