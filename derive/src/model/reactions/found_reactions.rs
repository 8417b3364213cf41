//! Connections of bodies: finds the reactions that the model file does not state, for the Newton–Euler equations.
//!
//! The connections of the model file are visited in a fixed order, the most plainly stated first
//! ([`stated_connections`]). First come stated reactions, contacts without slip, joints and placement on other
//! bodies. Then come other contacts, and last the ground.
//!
//! Each connection transmits forces along axes of frames and torques about them, if these do no work in the motions
//! that the connection itself permits. It gets only directions that earlier connections leave open, even if its
//! reactions are not needed.
//!
//! If reactions are still missing, forces and torques are searched wherever they do no work
//! ([`unstated_connections`]). An example is a model whose equations relate coordinates. In closed loops, the joints
//! of the tree hold the directions that they would hold in open loops. A pin transmits no torque about its axis, even
//! if a loop prevents it from rotating.
//!
//! A contact, or the ground, that transmits no reaction is left out ([`crate::model::Contacts::idle`]): no load goes
//! through it.
//!
//! Some directions are along no axis of a frame, as with gears, or with a direction that a formula states. All axes
//! together hold such a direction, by forces and torques at the body's support. Each of these reactions does work,
//! but for each speed their powers sum to zero ([`Reaction::is_shared`]). The force and torque of a screw obey the
//! law of that screw alone ([`Reaction::law`]), since a loop has fewer speeds than screws.
//!
//! Reactions are found in one random pose ([`super::random_pose`]). The derivation of the equations proves that they
//! do no work.

mod reaction_search;
mod stated_connections;
mod unstated_connections;

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::{Expr, Function};
use crate::geometry::Frames;
use crate::model::{Model, Reaction, ReactionKind};
use reaction_search::{FoundReaction, ReactionDirection, Search};

/// Largest number of Newton–Euler equations for which reactions are found automatically. In larger systems the model
/// file must state the reactions.
pub(in crate::model) const MOST_EQUATIONS: usize = 72;
/// Largest number of characters in the name of a found reaction. The number that makes the name unique is not
/// counted.
const MAX_LENGTH: usize = 56;

/// Prefix `BODY_force_` or `BODY_torque_` of the names of found reactions on a body. `what` is `force` or `torque`.
pub fn found_reaction_prefix(body: &str, what: &str) -> String {
    format!("{body}_{what}_")
}

impl Model {
    /// Reactions that the model file states. They come before the found reactions in [`Self::reactions`].
    #[must_use]
    pub fn stated_reactions(&self) -> &[Reaction] {
        let found = self.reactions.iter().position(|r| !r.is_stated);
        &self.reactions[..found.unwrap_or(self.reactions.len())]
    }

    /// Number of Newton–Euler equations of all bodies, if it is too large for finding reactions; otherwise `None`.
    pub(in crate::model) fn too_many_to_find_reactions(&self) -> Option<usize> {
        let equations = |body: &crate::model::Body| if body.rigid.is_some() { 6 } else { 3 };
        Some(self.bodies.iter().map(equations).sum()).filter(|all| *all > MOST_EQUATIONS)
    }

    /// Finds and adds reactions until the Newton–Euler equations of all bodies have as many unknowns as they need.
    /// Adds none if that is impossible.
    pub(in crate::model) fn add_found_reactions(&mut self) {
        let on_nothing =
            |t: &crate::model::Torque| t.on.1.is_none() || t.against.is_some_and(|(_, body)| body.is_none());
        if self.too_many_to_find_reactions().is_some() || self.torques.iter().any(on_nothing) {
            return;
        }
        let Some(mut search) = Search::new(self) else { return };
        search.choose_stated_connections();
        search.choose_unstated_reactions();
        // An incomplete set would make the equations unsolvable, and the model file did not ask for these
        // reactions.
        if search.missing > 0 {
            return;
        }
        let (found, idle) = search.results();
        for one in found {
            self.add_found_reaction(one);
        }
        self.contacts.idle = idle;
    }

    /// Adds a found reaction to the model, under a name that no other quantity has.
    fn add_found_reaction(&mut self, FoundReaction { kind, along, is_shared, law }: FoundReaction) {
        let (what, body) = match kind {
            ReactionKind::Force { on, .. } => ("force", on.body),
            ReactionKind::Torque { on, .. } => ("torque", on),
        };
        let (frame, direction, along) = match along {
            ReactionDirection::Axis(frame, axis) => {
                let mut direction = [Expr::ZERO; 3];
                direction[axis] = Expr::ONE;
                (frame, direction, format!("{}{}", self.frames[frame].name.to_lowercase(), axis + 1))
            }
            ReactionDirection::Line(from, to) => {
                (0, self.found_reaction_direction(from, to), format!("to_{}", self.points[to].name.to_lowercase()))
            }
        };
        let mut wanted = found_reaction_prefix(&self.bodies[body].name, what) + &along;
        wanted.truncate(MAX_LENGTH);
        let mut name = wanted.clone();
        let mut times = 1;
        while self.arena.find_symbol(&name).is_some() || self.declared.contains_key(&name) {
            times += 1;
            name = format!("{wanted}_{times}");
        }
        let symbol = self.arena.symbol(&name);
        self.reactions.push(Reaction { name, symbol, kind, frame, direction, is_stated: false, is_shared, law });
    }

    /// Unit vector from one point to another, as terms, with components in the inertial frame.
    fn found_reaction_direction(&mut self, from: usize, to: usize) -> [Expr; 3] {
        let mut arena = std::mem::take(&mut self.arena);
        let mut frames = Frames::new(&self.frames);
        let back = self.position(&mut arena, from).neg(&mut arena);
        let way = self.position(&mut arena, to).add(&mut arena, &back);
        let mut simplifier = Simplifier::default();
        let square = frames.dot(&mut arena, &way, &way);
        let square = simplifier.simplify(&mut arena, square);
        let length = arena.apply(Function::Sqrt, square);
        let direction = frames.express(&mut arena, &way, 0).map(|e| {
            let e = simplifier.simplify(&mut arena, e);
            arena.div(e, length).unwrap_or(e)
        });
        self.arena = arena;
        direction
    }
}
