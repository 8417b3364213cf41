//! Independent motion constraints: chooses them among all constraints and leaves out redundant constraints.
//!
//! Components of rolling that follow from other constraints are left out. Often the coordinates already keep a body
//! from penetrating the ground.
//!
//! Along some axes a component follows in most poses, but not in all. An example is two wheels on an axle. The second
//! wheel's slip along a fixed axis of the ground determines its rotation, except where the wheel heads across that
//! axis.
//!
//! So a contact whose frame the model file does not state may be taken along the axes of another frame. In that frame
//! every redundant component is redundant in every pose, if the mechanism has such a frame.

use super::closed_pose_search::{ClosedPoseSearch, random_coordinate_ranges};
use super::configuration_constraints::{Drive, HELD_DRIVE_ADVICE, held_drive_message};
use super::constant_loops::KnownParameters;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::LinearForm;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::rank::{keeps_rank_everywhere, rank};
use crate::algebra::value::tape::Tape;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::geometry::{Frames, Vector};
use crate::model::bodies::elements::Elements;
use crate::model::reading::declared_names::{NameKind, TIME};
use crate::model::reading::loading::Loading;
use crate::model::{
    Coordinate, LoopEquation, MotionConstraint, MotionConstraintKind, RedundantEquation, SlipComponent, Unit,
};
use crate::plain_text::with_significant_digits;
use crate::toml_reader::Located;
use rustc_hash::FxHashSet;
use std::ops::Range;

/// Candidate for a motion constraint: an equation A q̇ + a = 0, before its independence is tested.
pub struct ConstraintCandidate {
    /// Name of the constraint.
    pub name: String,
    /// Left side of the candidate's equation, linear in the rates of the coordinates.
    pub equation: Expr,
    /// Kind of the motion constraint: stated, rolling, rate of a loop, or time.
    pub kind: MotionConstraintKind,
    /// Index of the reaction that enforces the constraint; `None` if the model file states none.
    pub enforced_by: Option<usize>,
    /// Byte range of the candidate in the model file.
    pub span: Range<usize>,
    /// True if the candidate may be redundant without an error.
    pub may_repeat: bool,
}

/// Motion constraints that are independent of one another, and the equations that are redundant.
#[derive(Default)]
pub struct IndependentConstraints {
    /// Independent constraints, each with its byte range in the model file.
    pub motion: Vec<(MotionConstraint, Range<usize>)>,
    /// Equations of rolling contacts and of joints that follow from other constraints.
    pub repeated: Vec<RedundantEquation>,
    /// Loops of joints whose rates follow from the constraints in `motion`, so that these loops may still be open in
    /// poses in which all other loops are closed.
    pub also: Vec<(MotionConstraint, Range<usize>)>,
    /// Loop equations of joints that no coordinate changes, as (index of the loop, term in parameters that is zero).
    /// They are conditions on parameters, which the default values fulfil.
    pub conditions: Vec<(usize, Expr)>,
}

/// Parts of the model to which constraints refer: coordinates, elements, loops and parameter values.
pub struct ConstrainedSystem<'m> {
    /// Coordinates that no constraint has eliminated.
    pub coordinates: &'m [Coordinate],
    /// Frames, points and bodies.
    pub elements: &'m Elements,
    /// Loop equations between coordinates, indexed by [`MotionConstraintKind::Loop`].
    pub loops: &'m [LoopEquation],
    /// Constraints that set a coordinate as a function of time, and that are no longer among the equations.
    pub drives: &'m [Drive],
    /// Symbols of the parameters with their default values, in SI units.
    pub defaults: &'m [(Expr, f64)],
}

/// Number of closed poses in which a redundant equation between coordinates is tested.
const POSES: usize = 6;
/// Residual up to which a redundant equation holds in a closed pose. It is relative to the sum of the equation's
/// derivatives, each times the range of its coordinate.
const CLOSED: f64 = 1e-8;

/// Constraints accepted so far, with the rows of coefficients against which further candidates are tested.
struct AcceptedConstraints {
    /// Form that extracts the coefficients of the rates from a linear term.
    form: LinearForm,
    /// Rows of the accepted constraints: the coefficients of the rates, followed by the term without rates.
    rows: Vec<Vec<Expr>>,
    /// For each accepted constraint, true if the model file states it as an equation.
    is_stated: Vec<bool>,
    /// Coefficients of the rates in the accepted constraints that are not rolling contacts.
    others: Vec<Vec<Expr>>,
    /// Slip velocities of the accepted rolling contacts, each with all three components.
    slips: Vec<Vector>,
    /// Frames of the model, with their rotation matrices.
    frames: Frames,
    /// Simplifier of slip components.
    simplifier: Simplifier,
    /// Symbols of all coordinates, time included.
    places: FxHashSet<Expr>,
    /// Independent constraints and redundant equations found so far.
    found: IndependentConstraints,
}

impl AcceptedConstraints {
    /// Coefficients of the rates in every accepted constraint, without the term that has no rates.
    fn slopes(&self) -> Vec<Vec<Expr>> {
        self.rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect()
    }

    /// Components of a slip velocity along the axes of a frame, simplified.
    fn components(&mut self, arena: &mut Arena, slip: &Vector, frame: usize) -> [Expr; 3] {
        let components = self.frames.express(arena, slip, frame);
        components.map(|e| self.simplifier.simplify(arena, e))
    }

    /// True if every redundant component of a contact is redundant in every pose, once its components are taken along
    /// the axes of `frame`. A component may also follow from other components of the same contact. Earlier contacts
    /// are taken along the same axes, which does not change the motions that their three components together permit.
    fn are_redundant_everywhere(&mut self, arena: &mut Arena, slip: &Vector, frame: usize) -> bool {
        let mut kept = self.others.clone();
        for before in self.slips.clone() {
            let components = self.components(arena, &before, frame);
            if self.keep_independent(arena, &mut kept, &components).is_none() {
                return true;
            }
        }
        let components = self.components(arena, slip, frame);
        let Some(left) = self.keep_independent(arena, &mut kept, &components) else { return true };
        left.iter().all(|row| keeps_rank_everywhere(arena, &kept, row, &self.places))
    }

    /// Adds to `kept` the rows of those equations that are independent of the rows in `kept`. Returns the dependent
    /// rows. `None` if independence is undecided.
    fn keep_independent(
        &mut self,
        arena: &mut Arena,
        kept: &mut Vec<Vec<Expr>>,
        equations: &[Expr],
    ) -> Option<Vec<Vec<Expr>>> {
        let mut left = Vec::new();
        for equation in equations {
            let (row, _) = self.form.coefficients(arena, *equation).ok()?;
            kept.push(row);
            if rank(arena, kept)?.dependent.is_some() {
                left.extend(kept.pop());
            }
        }
        Some(left)
    }
}

/// Poses in which a redundant constraint follows from other constraints.
#[derive(Clone, Copy, PartialEq, Eq)]
enum RedundantPoses {
    /// The redundant constraint follows in every pose.
    EveryPose,
    /// The redundant constraint follows in all poses except those in which the other constraints are
    /// dependent themselves.
    MostPoses,
}

impl Loading<'_> {
    /// Chooses the candidates that are independent of earlier candidates. Reports redundant candidates that may not
    /// be redundant, and candidates that contradict earlier ones.
    pub fn choose_independent_constraints(
        &mut self,
        given: &ConstrainedSystem<'_>,
        candidates: Vec<ConstraintCandidate>,
    ) -> IndependentConstraints {
        let coordinates = given.coordinates;
        let rates: Vec<Expr> = coordinates.iter().map(|c| c.rate).collect();
        let form = LinearForm::new(&rates);
        let places = coordinates.iter().map(|c| c.symbol).collect();
        let mut taken = AcceptedConstraints {
            form,
            rows: Vec::new(),
            is_stated: Vec::new(),
            others: Vec::new(),
            slips: Vec::new(),
            frames: Frames::new(&given.elements.frames),
            simplifier: Simplifier::default(),
            places,
            found: IndependentConstraints::default(),
        };
        let mut waiting = candidates.into_iter();
        while let Some(candidate) = waiting.next() {
            let MotionConstraintKind::Rolling(rolled) = candidate.kind else {
                self.accept_constraint(&mut taken, given, candidate, RedundantPoses::EveryPose);
                continue;
            };
            // The three components of a rolling contact come one after another.
            let mut group = vec![candidate];
            group.extend(waiting.by_ref().take(2));
            let reach = self.choose_independent_contact_frame(&mut taken, given.elements, rolled, &mut group);
            for candidate in group {
                self.accept_constraint(&mut taken, given, candidate, reach);
            }
        }
        taken.found
    }

    /// Takes a rolling contact along the axes of another frame, if one of its components along its own axes is
    /// redundant in most poses only. Returns the poses in which the contact's redundant components are redundant.
    fn choose_independent_contact_frame(
        &mut self,
        taken: &mut AcceptedConstraints,
        elements: &Elements,
        rolled: SlipComponent,
        group: &mut [ConstraintCandidate],
    ) -> RedundantPoses {
        let stated: Vec<Expr> = group.iter().map(|c| c.equation).collect();
        let &[x, y, z] = stated.as_slice() else { return RedundantPoses::EveryPose };
        let slip = Vector::in_frame(rolled.frame, [x, y, z]);
        let mut everywhere = taken.are_redundant_everywhere(&mut self.arena, &slip, rolled.frame);
        let others =
            if everywhere || rolled.is_stated { Vec::new() } else { frames_for_independent_contact(elements, rolled) };
        if let Some(frame) =
            others.into_iter().find(|frame| taken.are_redundant_everywhere(&mut self.arena, &slip, *frame))
        {
            let turned = taken.components(&mut self.arena, &slip, frame);
            for (candidate, equation) in group.iter_mut().zip(turned) {
                candidate.equation = equation;
                candidate.kind = match candidate.kind {
                    MotionConstraintKind::Rolling(rolled) => {
                        MotionConstraintKind::Rolling(SlipComponent { frame, ..rolled })
                    }
                    kind => kind,
                };
            }
            everywhere = true;
        }
        taken.slips.push(slip);
        if everywhere { RedundantPoses::EveryPose } else { RedundantPoses::MostPoses }
    }

    /// Accepts a candidate if it is independent of the accepted constraints. Otherwise records it as redundant in the
    /// poses `reach`, or reports an error.
    fn accept_constraint(
        &mut self,
        taken: &mut AcceptedConstraints,
        given: &ConstrainedSystem<'_>,
        candidate: ConstraintCandidate,
        reach: RedundantPoses,
    ) {
        let ConstraintCandidate { name, equation, kind, enforced_by, span, may_repeat } = candidate;
        let (row, rest) = match taken.form.coefficients(&mut self.arena, equation) {
            Ok(linear) => linear,
            Err(not_linear) => {
                let of = self.arena.symbol_name(not_linear.symbol).unwrap_or_default();
                let message = format!(
                    "the constraint `{name}` is not linear in velocities: its slope along {of} depends on them"
                );
                self.reader.error(span, message, "a motion constraint must read  Σ a_i(q) q_i' + a(q) = 0");
                return;
            }
        };
        let is_zero = |arena: &Arena, e: &Expr| zero_test(arena, *e) == ZeroTest::Zero;
        if row.iter().all(|e| is_zero(&self.arena, e)) {
            match (may_repeat, is_zero(&self.arena, &rest), kind) {
                // An equation between coordinates whose left side is identically zero was left out earlier.
                (true, true, MotionConstraintKind::Loop(place)) => {
                    if let Some(condition) = self.condition_on_parameters(given, &name, span, place) {
                        taken.found.conditions.push((place, condition));
                        taken.found.repeated.push(RedundantEquation::of(name, kind, None));
                    }
                }
                (true, true, _) => taken.found.repeated.push(RedundantEquation::of(name, kind, None)),
                (_, true, _) => self.report_dependent_constraint(&name, span, "is always fulfilled"),
                (_, false, _) => self.report_dependent_constraint(&name, span, "is never fulfilled"),
            }
            return;
        }
        taken.rows.push([row.as_slice(), &[rest]].concat());
        let Some(found) = rank(&self.arena, &taken.slopes()) else {
            self.report_undecided_constraint(&name, span);
            taken.rows.pop();
            return;
        };
        let is_new = found.dependent.is_none();
        if is_new || may_repeat && matches!(kind, MotionConstraintKind::Loop(_)) {
            let unit = self.motion_constraint_unit(equation);
            let drive = if is_zero(&self.arena, &rest) { Expr::ZERO } else { rest };
            let stated = Located { text: format!("lambda_{name}"), span: span.clone(), exact: false };
            let multiplier = self.arena.symbol(&stated.text);
            self.names.declare(&mut self.reader, &stated, NameKind::Multiplier, Some(multiplier));
            if is_new && !matches!(kind, MotionConstraintKind::Rolling(_)) {
                taken.others.push(row);
            }
            let list = if is_new { &mut taken.found.motion } else { &mut taken.found.also };
            list.push((MotionConstraint { name, equation, drive, unit, multiplier, kind, enforced_by }, span));
            if is_new {
                taken.is_stated.push(!may_repeat);
            } else {
                taken.rows.pop();
            }
            return;
        }
        let all = rank(&self.arena, &taken.rows).map(|found| found.dependent.is_some());
        taken.rows.pop();
        if kind == MotionConstraintKind::Clock && all == Some(false) {
            self.report_held_drive(taken, given);
            return;
        }
        match (may_repeat, all) {
            (_, None) => self.report_undecided_constraint(&name, span),
            (_, Some(false)) => self.report_dependent_constraint(&name, span, "contradicts those before it"),
            (true, Some(true)) => {
                taken.found.repeated.push(RedundantEquation::of(
                    name,
                    kind,
                    (reach == RedundantPoses::MostPoses).then_some(equation),
                ));
            }
            (_, Some(true)) => {
                let how = match kind {
                    MotionConstraintKind::Loop(place) => self.dependence_in_words(taken, given, place),
                    _ => "follows from those before it",
                };
                self.report_dependent_constraint(&name, span, how);
            }
        }
    }

    /// Reports a drive that the other constraints hold, so that time could not go on. It is the last equation of the
    /// model file that contains time, or else the last drive that replaced a coordinate, or else the last joint whose
    /// equation contains time.
    fn report_held_drive(&mut self, taken: &AcceptedConstraints, given: &ConstrainedSystem<'_>) {
        let Some(time) = given.coordinates.iter().position(|c| c.name == TIME) else { return };
        let is_driven = |at: &usize| zero_test(&self.arena, taken.rows[*at][time]) != ZeroTest::Zero;
        let driven: Vec<usize> = (0..taken.rows.len()).filter(is_driven).collect();
        let accepted = |at: &usize| {
            let (constraint, span) = &taken.found.motion[*at];
            (constraint.name.as_str(), span)
        };
        let stated = driven.iter().rev().find(|at| taken.is_stated[**at]).map(accepted);
        let replaced = || given.drives.last().map(|drive| (drive.name.as_str(), &drive.span));
        let Some((name, span)) = stated.or_else(replaced).or_else(|| driven.last().map(accepted)) else { return };
        self.reader.error(span.clone(), held_drive_message(name), HELD_DRIVE_ADVICE);
    }

    /// Words for an error message about an equation between coordinates whose rate is redundant. They say that, in
    /// the poses where the earlier equations hold, it follows from them or contradicts them.
    fn dependence_in_words(
        &mut self,
        taken: &AcceptedConstraints,
        given: &ConstrainedSystem<'_>,
        place: usize,
    ) -> &'static str {
        let others = taken.found.motion.iter().filter_map(|(c, _)| match c.kind {
            MotionConstraintKind::Loop(at) => Some(given.loops[at].equation),
            _ => None,
        });
        let others: Vec<Expr> = others.collect();
        match self.count_poses_with_constraint(given, &others, given.loops[place].equation) {
            Some((0, _)) => "contradicts those before it",
            Some((closed, all)) if closed == all => "follows from those before it",
            Some(_) => {
                "follows from those before it in some of the poses in which they hold, and contradicts them in the others"
            }
            None => "adds nothing to the constraints before it: it follows from them, or contradicts them",
        }
    }

    /// Counts the closed poses of the equations `others` in which `equation` holds, at the default parameter values.
    /// Returns (poses in which it holds, poses tested). `None` if no pose was found.
    fn count_poses_with_constraint(
        &mut self,
        given: &ConstrainedSystem<'_>,
        others: &[Expr],
        equation: Expr,
    ) -> Option<(usize, usize)> {
        let lengths = given.defaults.iter().filter(|(symbol, _)| self.units.get(symbol) == Some(&Unit::new(1, 0, 0)));
        let reach = random_coordinate_ranges(
            given.coordinates.iter().map(|c| c.unit.is_plain()),
            lengths.map(|(_, value)| *value),
        );
        let places: Vec<Expr> = given.coordinates.iter().map(|c| c.symbol).collect();
        let poses = ClosedPoseSearch {
            known: given.defaults,
            coordinates: &places,
            reach: &reach,
            loops: others,
            flat: 0.0,
            sides: None,
            home: None,
        };
        let found = poses.find_closed_poses(&mut self.arena, POSES)?;
        let mut values = vec![equation];
        for place in &places {
            values.push(Differential::partial(*place).apply(&mut self.arena, equation));
        }
        let inputs: Vec<Expr> = given.defaults.iter().map(|(symbol, _)| *symbol).chain(places).collect();
        let tape = Tape::new(&self.arena, &inputs, &values).ok()?;
        let is_closed = |q: &&Vec<f64>| {
            let known = given.defaults.iter().map(|(_, value)| *value);
            let values = tape.evaluate(&known.chain(q.iter().copied()).collect::<Vec<f64>>());
            let size: f64 = values[1..].iter().zip(&reach).map(|(slope, reach)| (slope * reach).abs()).sum();
            values[0].abs() <= CLOSED * size
        };
        (!found.is_empty()).then(|| (found.iter().filter(is_closed).count(), found.len()))
    }

    /// Left side of the loop equation with the index `place`, which no coordinate changes, as a term in parameters.
    /// `None` after reporting an equation that the default values do not fulfil: the other joints then keep this
    /// joint's points or axes apart in every pose.
    fn condition_on_parameters(
        &mut self,
        given: &ConstrainedSystem<'_>,
        name: &str,
        span: Range<usize>,
        place: usize,
    ) -> Option<Expr> {
        let zero: Vec<(Expr, Expr)> = given.coordinates.iter().map(|c| (c.symbol, Expr::ZERO)).collect();
        let mut put = Substitution::new(&zero);
        let equation = put.apply(&mut self.arena, given.loops[place].equation);
        let known = KnownParameters::new(given.defaults, &self.units);
        let gap = if put.undefined.is_some() { None } else { known.gap(&self.arena, equation) };
        if gap == Some(0.0) {
            return Some(equation);
        }
        let value = gap.map_or_else(String::new, |gap| {
            format!(": it is {} at the default values", with_significant_digits(gap, 4))
        });
        let message = format!(
            "the loop does not close: no coordinate changes `{name}`, which must be 0 whatever the parameters are{value}"
        );
        let help = "write the parameters as formulas of one another so that it is exactly 0, or let a joint of the loop \
                    leave that direction free";
        self.reader.error(span, message, help);
        None
    }

    /// Reports a constraint whose independence could not be decided.
    fn report_undecided_constraint(&mut self, name: &str, span: Range<usize>) {
        let message = format!("it cannot be decided whether the constraint `{name}` follows from those before it");
        self.reader.error(
            span,
            message,
            "none of the random points at which it was asked gives it a value: state it otherwise",
        );
    }

    /// Reports a constraint that restricts nothing or contradicts other constraints. The message is "the constraint
    /// NAME" followed by `how`.
    fn report_dependent_constraint(&mut self, name: &str, span: Range<usize>, how: &str) {
        self.reader.error(span, format!("the constraint `{name}` {how}"), "remove it, or correct one of the others");
    }
}

/// Frames along whose axes a rolling contact may be taken: the frames on the paths from the ground to its bodies and
/// to its point.
fn frames_for_independent_contact(elements: &Elements, rolled: SlipComponent) -> Vec<usize> {
    let of_body = |body: usize| elements.bodies[body].rigid.as_ref().map(|(frame, _)| *frame);
    let of_point = elements.points[rolled.point].position.map(|placement| placement.frame);
    let mut list: Vec<usize> = Vec::new();
    for last in [of_body(rolled.body), rolled.against.and_then(of_body), of_point].into_iter().flatten() {
        let parent = |at: &usize| elements.frames[*at].rotation.as_ref().map(|(parent, _)| *parent);
        let mut chain: Vec<usize> = std::iter::successors(Some(last), parent).collect();
        chain.reverse();
        list.extend(chain.into_iter().filter(|at| *at != rolled.frame));
    }
    let mut seen = FxHashSet::default();
    list.retain(|at| seen.insert(*at));
    list
}
