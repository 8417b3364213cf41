//! Motion constraints of a model file: equations between velocities, rolling, and rates of loops.
//!
//! Let there be p generalized speeds u = J q̇ + d and m motion constraints A q̇ + a = 0, with p + m = n. The rates q̇
//! of the n coordinates follow from
//!
//! ```text
//! [ A ]        [  −a   ]
//! [ J ] q̇  =  [ u − d ]
//! ```
//!
//! as q̇ = W u + w. An equation between coordinates that cannot be solved for a coordinate restricts their rates by
//! its time derivative.

/// Definitions of all speeds as terms in q and q̇.
#[derive(Clone, Copy)]
pub struct SpeedDefinitions<'s> {
    /// Terms that define the speeds.
    pub definitions: &'s [Expr],
    /// For each speed, true if a joint adds it, false if the section `[speeds]` states it.
    pub brought: &'s [bool],
}

use super::assembly::Assembly;
use super::closed_pose_search::MeantPoses;
use super::configuration_constraints::{Drive, StatedConstraint};
use super::independent_constraints::{ConstrainedSystem, ConstraintCandidate, IndependentConstraints};
use crate::algebra::Expr;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::diagnostic::shortened_for_message;
use crate::model::bodies::elements::Elements;
use crate::model::bodies::joints::Joints;
use crate::model::bodies::mechanism_motion::MechanismMotion;
use crate::model::impossible_bodies::default_parameter_values;
use crate::model::reading::declared_names::{NameKind, TIME};
use crate::model::reading::loading::Loading;
use crate::model::{
    AssemblyBranch, Coordinate, HeldOrientation, LoopEquation, MotionConstraint, MotionConstraintKind, Parameter,
    RedundantConstraint, RedundantEquation, SlipComponent, Speed,
};
use crate::toml_reader::Located;
use std::ops::Range;
use toml::de::DeTable;

/// Rolling of a body as the model file states it in `[rolling.NAME]`.
pub struct StatedRolling {
    /// Name of the rolling contact.
    pub name: Located,
    /// Index of the body that rolls.
    body: usize,
    /// Index of the point of contact.
    point: usize,
    /// Index of the body on which the rolling body rolls; `None` for the ground.
    against: Option<usize>,
    /// Index of the frame along whose axes the components of the slip velocity are taken.
    frame: usize,
    /// True if the model file states the frame; false if it is the inertial frame by default.
    is_stated: bool,
}

/// Parts from which motion constraints are formed. Their terms contain only the coordinates that remain in the model.
pub struct ConstraintParts<'m> {
    /// Coordinates that no constraint has eliminated.
    pub coordinates: &'m [Coordinate],
    /// Frames, points and bodies.
    pub elements: &'m Elements,
    /// Speeds, each with the byte range of its definition.
    pub speeds: &'m [(Speed, Range<usize>)],
    /// Joints of the model file, which add speeds.
    pub joints: &'m Joints<'m>,
    /// Parameters of the model, whose default values are used in closed poses.
    pub parameters: &'m [Parameter],
    /// Values of coordinates near which the mechanism is assembled; `None` if the model file does not state them.
    pub assembly: Option<&'m Assembly>,
    /// Constraints that set a coordinate as a function of time, and that are no longer among the equations.
    pub drives: &'m [Drive],
    /// Orientations that closing joints hold.
    pub orientations: &'m [HeldOrientation],
    /// Equations between coordinates that cannot be solved for a coordinate.
    pub kept: Vec<StatedConstraint>,
    /// Equations between velocities that the model file states.
    pub stated: Vec<StatedConstraint>,
    /// Equations of rolling, each with the component of the slip velocity that it makes zero.
    pub rolling: Vec<(StatedConstraint, SlipComponent)>,
}

/// Motion constraints and loops of a model, and the constraints that are redundant.
#[derive(Default)]
pub struct MotionConstraints {
    /// Motion constraints, each with its byte range in the model file.
    pub motion: Vec<(MotionConstraint, Range<usize>)>,
    /// Loop equations, whose time derivatives are among the motion constraints.
    pub loops: Vec<LoopEquation>,
    /// Redundant equations of rolling and of joints.
    pub repeated: Vec<RedundantEquation>,
    /// Equations of closing joints that no coordinate changes, as (name, term in parameters that is zero).
    pub conditions: Vec<(String, Expr)>,
    /// Loop equations whose time derivatives follow from other constraints in all poses in which the loops are
    /// closed.
    pub closed: Vec<LoopEquation>,
    /// Constraints that follow from other constraints in all poses in which the loops are closed.
    pub dependent: Vec<RedundantConstraint>,
    /// Branch of closed poses in which redundancy was decided. `None` if there are no loops or no closed pose was
    /// found.
    pub branch: Option<AssemblyBranch>,
    /// Indices of the speeds that remain generalized speeds. `None` if closed poses did not decide which speeds of
    /// joints remain.
    pub speeds: Option<Vec<usize>>,
}

impl<'a> Loading<'a> {
    /// Reads the section `[rolling]` of a model file: an entry `[rolling.NAME]` for each contact.
    /// Errors are recorded in the reader.
    pub fn rolling_constraints(&mut self, table: &'a DeTable<'a>, elements: &Elements) -> Vec<StatedRolling> {
        let mut list = Vec::new();
        for (name, value) in self.section(table, "rolling", &[]) {
            let example = "[rolling.NAME] with body = \"wheel\" and at = \"P\"";
            let Some((entry, what)) = self.entry(&name, value, NameKind::Constraint, None, example) else { continue };
            self.reader.report_unknown_keys(entry, &what, &["body", "at", "against", "frame", "about"]);
            let mut named = |key: &str, needed: bool| {
                let value = if needed {
                    self.reader.required(entry, key, &what, &name.span)
                } else {
                    self.reader.get(entry, key)
                };
                let stated = self.reader.string(value?, &format!("`{key}`"))?;
                let body = elements.body_named(self, &stated)?;
                if elements.bodies[body].rigid.is_none() {
                    let message = format!("the particle `{}` cannot roll", shortened_for_message(&stated.text));
                    self.reader.error(
                        stated.span,
                        message,
                        "name a rigid body, or hold a velocity under [constraints]",
                    );
                    return None;
                }
                Some(body)
            };
            let (body, against) = (named("body", true), named("against", false));
            let point = elements.point(self, entry, "at", &what, &name.span);
            let is_stated = self.reader.get(entry, "frame").is_some();
            let frame = if is_stated { elements.frame(self, entry, &what, &name.span) } else { Some(0) };
            if let (Some(body), Some(point), Some(frame)) = (body, point, frame) {
                list.push(StatedRolling { name, body, point, against, frame, is_stated });
            }
        }
        list
    }

    /// Equations of rolling: each of the three components of the velocity at which a rolling body would
    /// slip is zero.
    pub fn rolling_constraint_equations(
        &mut self,
        moving: &mut MechanismMotion,
        elements: &Elements,
        rolling: Vec<StatedRolling>,
    ) -> Vec<(StatedConstraint, SlipComponent)> {
        let mut list = Vec::new();
        for (contact, rolling) in rolling.into_iter().enumerate() {
            let StatedRolling { name, body, point, against, frame, is_stated } = rolling;
            let span = name.span.clone();
            let mut slip = moving.material_velocity(&mut self.arena, elements, body, point);
            if let Some(other) = against {
                let back = moving.material_velocity(&mut self.arena, elements, other, point).neg(&mut self.arena);
                slip = slip.add(&mut self.arena, &back);
            }
            for axis in 0..3 {
                let equation = moving.component(&mut self.arena, &slip, frame, axis);
                let name = format!("{}_{}", name.text, axis + 1);
                let stated =
                    StatedConstraint { name, equation, enforced_by: None, span: span.clone(), may_repeat: true };
                list.push((stated, SlipComponent { contact, body, against, point, frame, axis, is_stated }));
            }
        }
        list
    }

    /// Forms the independent motion constraints of a mechanism. Reports constraints that contradict earlier ones, and
    /// redundant ones if their redundancy is an error. `None` after errors.
    pub fn motion_constraints(&mut self, tied: ConstraintParts<'_>) -> Option<MotionConstraints> {
        let ConstraintParts {
            coordinates,
            elements,
            speeds,
            joints,
            parameters,
            assembly,
            drives,
            orientations,
            kept,
            stated,
            rolling,
        } = tied;
        let clock = coordinates.iter().any(|c| c.name == TIME);
        if !clock && kept.is_empty() && stated.is_empty() && rolling.is_empty() {
            return Some(MotionConstraints::default());
        }
        let before = self.reader.errors.len();
        if before > 0 {
            return None;
        }
        let (mut loops, mut candidates) = (Vec::new(), Vec::new());
        let rates: Vec<_> = coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut d_dt = Differential::along(&rates);
        let mut simplifier = Simplifier::default();
        for StatedConstraint { name, equation, enforced_by, span, may_repeat } in kept {
            let rate = d_dt.apply(&mut self.arena, equation);
            let rate = simplifier.simplify(&mut self.arena, rate);
            let kind = MotionConstraintKind::Loop(loops.len());
            candidates.push(ConstraintCandidate {
                name: name.clone(),
                equation: rate,
                kind,
                enforced_by,
                span,
                may_repeat,
            });
            let unit = self.motion_constraint_unit(equation);
            loops.push(LoopEquation { name, equation, unit, prescribes: false });
        }
        let definitions: Vec<_> = speeds.iter().map(|(s, _)| (s.symbol, s.definition)).collect();
        let mut put = Substitution::new(&definitions);
        let stated = stated.into_iter().map(|c| (c, MotionConstraintKind::Stated));
        for (StatedConstraint { name, equation, enforced_by, span, may_repeat }, kind) in
            stated.chain(rolling.into_iter().map(|(c, rolled)| (c, MotionConstraintKind::Rolling(rolled))))
        {
            let equation = put.apply(&mut self.arena, equation);
            candidates.push(ConstraintCandidate { name, equation, kind, enforced_by, span, may_repeat });
        }
        if let Some(time) = coordinates.iter().find(|c| c.name == TIME) {
            let equation = self.arena.sub(time.rate, Expr::ONE);
            let name = TIME.to_owned();
            candidates.push(ConstraintCandidate {
                name,
                equation,
                kind: MotionConstraintKind::Clock,
                enforced_by: None,
                span: 0..0,
                may_repeat: false,
            });
        }
        let known = default_parameter_values(parameters);
        let given = ConstrainedSystem { coordinates, elements, loops: &loops, drives, defaults: &known };
        let IndependentConstraints { mut motion, repeated, mut also, conditions } =
            self.choose_independent_constraints(&given, candidates);
        if self.reader.errors.len() > before {
            return None;
        }
        // A loop that no coordinate changes is no loop equation between coordinates.
        let constant: Vec<usize> = conditions.iter().map(|(place, _)| *place).collect();
        for (constraint, _) in motion.iter_mut().chain(&mut also) {
            if let MotionConstraintKind::Loop(at) = &mut constraint.kind {
                *at -= constant.iter().filter(|place| **place < *at).count();
            }
        }
        let conditions = conditions.into_iter().map(|(place, e)| (loops[place].name.clone(), e)).collect();
        let mut place = 0..loops.len();
        loops.retain(|_| !place.next().is_some_and(|at| constant.contains(&at)));
        // The rates of loops come first in the list of motion constraints.
        let place = motion.iter().take_while(|(c, _)| matches!(c.kind, MotionConstraintKind::Loop(_))).count();
        let also_at = place..place + also.len();
        motion.splice(place..place, also);
        let mut ties = MotionConstraints { motion, loops, repeated, conditions, ..MotionConstraints::default() };
        let brought: Vec<bool> = speeds.iter().map(|(speed, _)| joints.adds_joint_speed(speed)).collect();
        let speeds: Vec<Expr> = speeds.iter().map(|(speed, _)| speed.definition).collect();
        let home = assembly.and_then(|assembly| {
            let pose = assembly.pose(&self.arena, coordinates, &elements.frames, &known)?;
            Some((pose, &assembly.place))
        });
        self.remove_redundant_constraints(
            coordinates,
            SpeedDefinitions { definitions: &speeds, brought: &brought },
            &known,
            MeantPoses { home: home.as_ref().map(|(pose, place)| (pose.as_slice(), *place)), orientations },
            also_at,
            &mut ties,
        );
        (self.reader.errors.len() == before).then_some(ties)
    }

    /// Unit of a constraint's term, which is left side less right side of its equation. The unit is 1 if the term has
    /// no definite unit. The units in its sums were checked when it was read.
    pub fn motion_constraint_unit(&self, e: Expr) -> crate::model::Unit {
        crate::model::units::unit_of(&self.arena, e, &self.units).ok().flatten().unwrap_or_default()
    }
}
