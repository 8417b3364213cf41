//! Closures: pairs of points of two bodies that equations of the model file keep together. Finds further forces and
//! torques that may act at such a pair.
//!
//! A pin that is stated as two equations in the plane of a linkage holds in that plane. It may also hold across the
//! plane, but equations between coordinates do not tell. So a force or torque may act along each direction in which
//! no permitted motion moves the points relative to one another, in equilibrium with other reactions.
//!
//! Closures are searched where at least two forces were found between two bodies at a pair of points. The bodies must
//! neither rest on one another nor be connected by a joint of the model file. A single force, as that of a tooth or a
//! slot, holds nothing else.

use super::relative_motion::{BodyPair, RelativeMotion};
use crate::algebra::Expr;
use crate::model::{ForcePlace, MotionConstraintKind, Reaction, ReactionKind};

/// Pair of bodies, or a body and the ground, that equations keep together at a point of each.
#[derive(Clone, Copy, PartialEq, Eq)]
struct PointClosure {
    /// Body, and point of this body that equations keep together with the second body's point.
    on: ForcePlace,
    /// Second body, and its point that is kept together with the first; `None` for the ground.
    against: Option<ForcePlace>,
    /// Index of the frame along whose axes the bodies are kept together.
    frame: usize,
}

impl RelativeMotion<'_> {
    /// Reactions of size 1 that may act where equations of the model file keep two points together. `resting` are
    /// pairs of a body and the body on which it rests.
    pub fn closure_reactions(&self, resting: &[BodyPair]) -> Vec<Reaction> {
        let found: Vec<PointClosure> =
            self.model.reactions.iter().filter_map(|r| self.closure_of_reaction(r, resting)).collect();
        let mut list = Vec::new();
        for (at, closing) in found.iter().enumerate() {
            let is_first = !found[..at].contains(closing);
            if is_first && found.iter().filter(|other| *other == closing).count() > 1 {
                list.extend(self.reactions_at_closure(closing));
            }
        }
        list
    }

    /// Closure of the two points at which a reaction acts. `None` unless the reaction was found automatically and
    /// belongs to a loop that equations close.
    fn closure_of_reaction(&self, reaction: &Reaction, resting: &[BodyPair]) -> Option<PointClosure> {
        let ReactionKind::Force { on, against } = reaction.kind else { return None };
        let by = against.map(|place| place.body);
        let pairs = [(Some(on.body), by), (by, Some(on.body))];
        let rolls = self.model.motion_constraints.iter().any(|c| match c.kind {
            MotionConstraintKind::Rolling(rolled) => pairs.contains(&(Some(rolled.body), rolled.against)),
            _ => false,
        });
        let hangs = resting.iter().any(|pair| pair.joins(Some(on.body), by));
        // A reaction of a joint of the model file has a declared name.
        let is_named = reaction.is_stated || self.model.declared.contains_key(&reaction.name);
        let is_axis = reaction.direction.iter().all(|e| [Expr::ZERO, Expr::ONE].contains(e));
        (is_axis && !is_named && !reaction.is_shared && !rolls && !hangs).then_some(PointClosure {
            on,
            against,
            frame: reaction.frame,
        })
    }

    /// Reactions of size 1 at the pair of points `closing` that do no work in any motion that the constraints permit.
    fn reactions_at_closure(&self, closing: &PointClosure) -> Vec<Reaction> {
        let &PointClosure { on, against, frame } = closing;
        let (body, holder, space) = (on.body, against.map(|place| place.body), self.drawn.space);
        let force = ReactionKind::Force { on, against };
        let slips = self.slip_velocities(body, holder, on.point, against.map_or(on.point, |place| place.point));
        let mut kinds = vec![("force", force, slips)];
        if self.is_rigid(Some(body)) && self.is_rigid(holder) {
            kinds.push((
                "torque",
                ReactionKind::Torque { on: body, against: holder },
                self.relative_angular_velocities(body, holder),
            ));
        }
        let mut list = Vec::new();
        for (what, kind, velocities) in kinds {
            for axis in 0..3 {
                let along = self.drawn.frames[frame].axes[axis];
                if velocities.iter().all(|v| space.dot(*v, along) == 0) {
                    let name = format!("{what} along {} [{}]", self.model.frames[frame].name, axis + 1);
                    let mut direction = [Expr::ZERO; 3];
                    direction[axis] = Expr::ONE;
                    let symbol = Expr::ONE;
                    list.push(Reaction {
                        name,
                        symbol,
                        kind,
                        frame,
                        direction,
                        is_stated: false,
                        is_shared: false,
                        law: None,
                    });
                }
            }
        }
        list
    }
}
