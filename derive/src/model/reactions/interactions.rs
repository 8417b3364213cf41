//! Interactions: the force or torque that one body exerts on another through their connections. It is the sum of all
//! reactions between them.
//!
//! A formula states a component of the force or torque as `force(base on arm) @ N [1]`. While the model file is read,
//! a symbol stands for the component, since reactions are found last. Then the sum replaces the symbol, so that only
//! the code that reads files knows of the name.

use super::found_reactions::{MOST_EQUATIONS, found_reaction_prefix};
use super::relative_motion::{BodyPair, Holder, reaction_pair};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::parse::InteractionName;
use crate::algebra::{Arena, Expr};
use crate::diagnostic::{Diagnostic, nearest_name_advice};
use crate::geometry::{Frames, Vector};
use crate::model::units::Unit;
use crate::model::{ForcePlace, JointedBody, Model, Placement, Reaction, ReactionKind};
use crate::toml_reader::Located;
use std::ops::Range;

/// Name of the ground in place of a body's name. A body that has this name takes precedence.
pub const GROUND: &str = "ground";

/// Component of the force or torque that a body exerts on another, as a formula states it: names with their places in
/// the file.
#[derive(Clone, Debug)]
pub struct StatedInteraction {
    /// Symbol that stands for the component until the reactions are known.
    pub symbol: Expr,
    /// Name of the component in canonical form, such as `force(base on arm) @ N [1]`.
    pub text: String,
    /// True for a torque, false for a force.
    pub is_torque: bool,
    /// Name of the body that exerts the force or torque.
    pub by: Located,
    /// Name of the body on which the force or torque acts.
    pub on: Located,
    /// Name of the point about which a torque is taken; `None` if the formula names no point.
    pub about: Option<Located>,
    /// Name of the frame along whose axis the component is taken.
    pub frame: Located,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
    /// Byte range of the component's whole name in the file.
    pub span: Range<usize>,
}

/// Component of the force or torque that a body exerts on another. Bodies, point and frame are given by index.
#[derive(Clone, Copy, Debug)]
pub struct Interaction {
    /// True for a torque, false for a force.
    pub is_torque: bool,
    /// Body that exerts the force or torque; `None` is the ground.
    pub by: Holder,
    /// Body on which the force or torque acts; `None` is the ground.
    pub on: Holder,
    /// Index of the point about which a torque is taken; `None` if the point is not known or not needed.
    pub about: Option<usize>,
    /// Index of the frame along whose axis the component is taken.
    pub frame: usize,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
}

impl StatedInteraction {
    /// Creates the force or torque component that the parsed `name` in the text `formula` denotes.
    pub fn new(arena: &mut Arena, formula: &Located, name: &InteractionName<'_>) -> Self {
        let located = |(text, place): &(&str, Range<usize>)| Located {
            text: (*text).to_owned(),
            span: formula.part(place.clone()),
            exact: formula.exact,
        };
        let text = name.text();
        let span = formula.part(name.by.1.start..name.frame.1.end);
        Self {
            symbol: arena.symbol(&text),
            text,
            is_torque: name.is_torque,
            by: located(&name.by),
            on: located(&name.on),
            about: name.about.as_ref().map(located),
            frame: located(&name.frame),
            axis: name.axis,
            span,
        }
    }

    /// Unit of the component: N for a force, N m for a torque.
    pub fn unit(&self) -> Unit {
        Unit::new(if self.is_torque { 2 } else { 1 }, 1, -2)
    }
}

/// Sense of a reaction relative to the wanted force or torque between two bodies.
#[derive(Clone, Copy, PartialEq, Eq)]
enum ReactionSense {
    /// The reaction acts on the same body as the wanted force or torque.
    Along,
    /// The opposite of the reaction acts on the same body as the wanted force or torque.
    Against,
}

/// A reaction between the two bodies of a wanted force or torque, with its sense.
#[derive(Clone)]
struct ActingReaction {
    /// Reaction that acts between the two bodies.
    reaction: Reaction,
    /// Sense of the reaction relative to the wanted force or torque.
    sense: ReactionSense,
}

impl Interaction {
    /// The reaction with its sense, if it acts between the two bodies of the wanted force or torque; otherwise
    /// `None`.
    fn part_of_interaction(&self, reaction: &Reaction) -> Option<ActingReaction> {
        let BodyPair { body, against } = reaction_pair(reaction.kind);
        let sense = match (Some(body), against) {
            pair if pair == (self.on, self.by) => ReactionSense::Along,
            pair if pair == (self.by, self.on) => ReactionSense::Against,
            _ => return None,
        };
        Some(ActingReaction { reaction: reaction.clone(), sense })
    }
}

impl Model {
    /// Force or torque component that a formula names, as a term in the model's reactions and in q.
    ///
    /// # Errors
    /// Returns a [`Diagnostic`] at the component's place in the file in these cases: a name is unknown, nothing acts
    /// between the bodies, the point of a torque is ambiguous, or equilibrium does not determine the component.
    pub fn interaction(&mut self, stated: &StatedInteraction) -> Result<Expr, Diagnostic> {
        let mut sought = self.found_interaction(stated)?;
        let acting: Vec<ActingReaction> = self.reactions.iter().filter_map(|r| sought.part_of_interaction(r)).collect();
        // A redundant joint also connects the two bodies.
        let again = self.redundant.iter().filter_map(|r| sought.part_of_interaction(&r.reaction));
        let joined: Vec<ActingReaction> = acting.iter().cloned().chain(again).collect();
        if joined.is_empty() {
            return Err(self.no_reaction_diagnostic(stated));
        }
        if sought.is_torque {
            sought.about = self.point_of(stated, sought, &joined)?;
        }
        if let Some((message, help)) = self.undetermined_component_message(&sought, &stated.text) {
            return Err(Diagnostic::new(stated.span.clone(), message, help));
        }
        let mut arena = std::mem::take(&mut self.arena);
        let value = self.sum_of(&mut arena, sought, &acting);
        self.arena = arena;
        Ok(value)
    }

    /// Component of the sum of the reactions `acting`, as a term. For a torque, the moments of forces about the point
    /// `sought.about` are included.
    fn sum_of(&self, arena: &mut Arena, sought: Interaction, acting: &[ActingReaction]) -> Expr {
        let mut frames = Frames::new(&self.frames);
        let mut sum = Vector::default();
        for ActingReaction { reaction, sense } in acting {
            let mut vector = Vector::in_frame(reaction.frame, reaction.direction).scale(arena, reaction.symbol);
            if *sense == ReactionSense::Against {
                vector = vector.neg(arena);
            }
            let part = match (reaction.kind, sought.about) {
                (ReactionKind::Force { .. }, _) if !sought.is_torque => vector,
                (ReactionKind::Torque { .. }, _) if sought.is_torque => vector,
                (ReactionKind::Force { on, against }, Some(about)) => {
                    let point = interaction_point(on, against, *sense);
                    let back = self.position(arena, about).neg(arena);
                    let arm = self.position(arena, point).add(arena, &back);
                    frames.cross(arena, &arm, &vector)
                }
                _ => continue,
            };
            sum = sum.add(arena, &part);
        }
        let component = frames.component(arena, &sum, sought.frame, sought.axis);
        Simplifier::default().simplify(arena, component)
    }

    /// Position vector of a point from the origin, m.
    pub(in crate::model) fn position(&self, arena: &mut Arena, point: usize) -> Vector {
        let (mut at, mut sum) = (point, Vector::default());
        while let Some(Placement { parent, frame, components }) = self.points[at].position {
            sum = sum.add(arena, &Vector::in_frame(frame, components));
            at = parent;
        }
        sum
    }

    /// Index of the point about which a torque is taken. It is the stated point, else the point of the joint, else
    /// the only point at which forces act. `Ok(None)` if no force acts. Returns an error if forces act at several
    /// points.
    fn point_of(
        &self,
        stated: &StatedInteraction,
        sought: Interaction,
        acting: &[ActingReaction],
    ) -> Result<Option<usize>, Diagnostic> {
        if sought.about.is_some() {
            return Ok(sought.about);
        }
        let joins = |carried: &&JointedBody| {
            let pair = (Some(carried.body), carried.on);
            pair == (sought.on, sought.by) || pair == (sought.by, sought.on)
        };
        if let Some(joint) = self.carried.iter().find(joins) {
            return Ok(Some(joint.point));
        }
        let mut points = Vec::new();
        for ActingReaction { reaction, sense } in acting {
            if let ReactionKind::Force { on, against } = reaction.kind {
                let point = interaction_point(on, against, *sense);
                if !points.contains(&point) {
                    points.push(point);
                }
            }
        }
        if points.len() < 2 {
            return Ok(points.first().copied());
        }
        let names: Vec<String> = points.iter().map(|at| format!("`{}`", self.points[*at].name)).collect();
        let message = format!("forces act between the two at several points, {}", names.join(", "));
        let help = format!(
            "name the point about which the torque is meant: torque({} on {} about {}) @ {} [{}]",
            stated.by.text,
            stated.on.text,
            self.points[points[0]].name,
            stated.frame.text,
            stated.axis + 1
        );
        Err(Diagnostic::new(stated.span.clone(), message, help))
    }

    /// Resolves the bodies, the point and the frame that a formula names to indices. Returns an error for an unknown
    /// name, or if both bodies are the same.
    fn found_interaction(&self, stated: &StatedInteraction) -> Result<Interaction, Diagnostic> {
        let (by, on) = (self.body_or_ground(&stated.by)?, self.body_or_ground(&stated.on)?);
        if by == on {
            let message = format!("`{}` names one body twice", stated.text);
            return Err(Diagnostic::new(stated.span.clone(), message, "name two that are connected"));
        }
        let find = |name: &Located, noun: &str, names: Vec<&str>| {
            names.iter().position(|known| *known == name.text).ok_or_else(|| {
                let message = format!("the model has no {noun} `{}`", name.text);
                Diagnostic::new(name.span.clone(), message, nearest_name_advice(&name.text, names))
            })
        };
        let frame = find(&stated.frame, "frame", self.frames.iter().map(|f| f.name.as_str()).collect())?;
        let point = |name: &Located| find(name, "point", self.points.iter().map(|p| p.name.as_str()).collect());
        let about = stated.about.as_ref().map(point).transpose()?;
        Ok(Interaction { is_torque: stated.is_torque, by, on, about, frame, axis: stated.axis })
    }

    /// Index of the body with the given name; `None` for the ground, named as `ground` or by the inertial frame.
    /// Returns an error for an unknown name.
    fn body_or_ground(&self, name: &Located) -> Result<Holder, Diagnostic> {
        if let Some(at) = self.bodies.iter().position(|b| b.name == name.text) {
            return Ok(Some(at));
        }
        if name.text == GROUND || name.text == self.frames[0].name {
            return Ok(None);
        }
        let names = self.bodies.iter().map(|b| b.name.as_str()).chain([GROUND]);
        let message = format!("the model has no body `{}`", name.text);
        Err(Diagnostic::new(name.span.clone(), message, nearest_name_advice(&name.text, names)))
    }

    /// Name of a body, or `ground` for `None`.
    pub(in crate::model) fn holder_name(&self, holder: Holder) -> &str {
        holder.map_or(GROUND, |at| &self.bodies[at].name)
    }

    /// Diagnostic that no reaction acts between the two bodies that a formula names.
    fn no_reaction_diagnostic(&self, stated: &StatedInteraction) -> Diagnostic {
        let mut pairs: Vec<String> = Vec::new();
        for BodyPair { body, against } in self.reactions.iter().map(|r| reaction_pair(r.kind)) {
            let pair = format!("{} on {}", self.holder_name(against), self.bodies[body].name);
            if !pairs.contains(&pair) {
                pairs.push(pair);
            }
        }
        let message = format!("no reaction acts between `{}` and `{}`", stated.by.text, stated.on.text);
        let help = if let Some(count) = self.too_many_to_find_reactions() {
            format!(
                "reactions are found of up to {MOST_EQUATIONS} equations of Newton and Euler, and the bodies of this model have {count}: name \
                 those between the two under [reactions]"
            )
        } else if pairs.is_empty() {
            "none of this model is known: `tripos derive MODEL --by newton-euler` says why".to_owned()
        } else {
            pairs.truncate(20);
            format!("reactions are of {}, or the other way round", pairs.join(", "))
        };
        Diagnostic::new(stated.span.clone(), message, help)
    }
}

/// Index of the point at which the wanted force acts through a reaction. It is the reaction's own point or, with the
/// opposite sense, the point of its opposite.
fn interaction_point(on: ForcePlace, against: Option<ForcePlace>, sense: ReactionSense) -> usize {
    against.filter(|_| sense == ReactionSense::Against).unwrap_or(on).point
}

/// Reaction in a condition of the domain, named by its own name or by two bodies.
#[derive(Clone, Debug)]
pub enum NamedReaction {
    /// Reaction that may be found later, as (symbol that stands for it, its name, its unit).
    Found(Expr, Located, Unit),
    /// Component of the force or torque that a body exerts on another.
    Between(StatedInteraction),
}

impl NamedReaction {
    /// Symbol that stands for the reaction until reactions are known, with its unit.
    pub fn symbol(&self) -> (Expr, Unit) {
        match self {
            Self::Between(stated) => (stated.symbol, stated.unit()),
            Self::Found(symbol, _, unit) => (*symbol, unit.clone()),
        }
    }
}

impl Model {
    /// Replaces the symbols that stand for reactions in conditions of the domain, once all reactions are known.
    /// Returns a diagnostic for each reaction that cannot be determined.
    pub(in crate::model) fn name_reactions(&mut self, asked: Vec<NamedReaction>) -> Vec<Diagnostic> {
        let (mut pairs, mut errors) = (Vec::new(), Vec::new());
        for reaction in asked {
            let (symbol, _) = reaction.symbol();
            let value = match reaction {
                NamedReaction::Between(stated) => self.interaction(&stated),
                NamedReaction::Found(_, name, _) => self.named_reaction(&name),
            };
            match value {
                Ok(value) => pairs.push((symbol, value)),
                Err(error) => errors.push(error),
            }
        }
        let mut put = Substitution::new(&pairs);
        for condition in &mut self.domain {
            let positive = put.apply(&mut self.arena, condition.positive);
            if positive != condition.positive && self.arena.as_number(positive).is_some() {
                let place = self.declared.get(&condition.name).cloned().unwrap_or_default();
                let message =
                    format!("the condition `{}` does not depend on the motion: the reaction is zero", condition.name);
                errors.push(Diagnostic::new(place, message, "remove the condition"));
            }
            condition.positive = positive;
        }
        let redundant = self
            .redundant
            .iter()
            .map(|redundant| &redundant.reaction)
            .filter(|r| self.domain.iter().any(|c| self.arena.mentions(c.positive, r.symbol)));
        errors.extend(redundant.map(|r| {
            let place = self.declared.get(&r.name).cloned().unwrap_or_default();
            let (message, help) = redundant_reaction_message(&r.name);
            Diagnostic::new(place, message, help)
        }));
        errors
    }

    /// Symbol of the reaction with the given name. Returns an error if no reaction has this name.
    fn named_reaction(&self, name: &Located) -> Result<Expr, Diagnostic> {
        self.reactions.iter().find(|r| r.name == name.text).map(|r| r.symbol).ok_or_else(|| {
            let names = self.reactions.iter().map(|r| r.name.as_str());
            let message = format!("no reaction `{}` is found", name.text);
            Diagnostic::new(name.span.clone(), message, nearest_name_advice(&name.text, names))
        })
    }
}

/// Message and advice for a redundant reaction, which has no value because another connection holds
/// the same direction.
pub fn redundant_reaction_message(name: &str) -> (String, &'static str) {
    let message = format!("equilibrium does not determine `{name}`: another connection holds the same motion");
    (
        message,
        "let a joint of the loop leave that motion free, or name a reaction that is determined: `tripos check` lists dependent constraints",
    )
}

/// Unit of the reaction that a name such as `BODY_force_…` or `BODY_torque_…` may denote, for one of the `bodies`.
/// `None` for other names.
pub fn named_reaction_unit<'n>(name: &str, mut bodies: impl Iterator<Item = &'n str>) -> Option<Unit> {
    let is_of = |body: &str| {
        let kinds = [("force", Unit::new(1, 1, -2)), ("torque", Unit::new(2, 1, -2))];
        kinds.into_iter().find(|(what, _)| name.starts_with(&found_reaction_prefix(body, what)))
    };
    bodies.find_map(is_of).map(|(_, unit)| unit)
}
