//! Reactions elsewhere than at stated connections: where equations relate coordinates, and along
//! lines and directions that belong to no frame.
//!
//! All pairs of bodies are visited for contacts and loops, then for massless rods between two
//! points. A reaction is accepted if it does no work, acts in an equation that is not 0 = 0, and is
//! independent of those accepted before. The search ends when there are as many reactions as the
//! equations of all bodies need.

use super::search::{FoundReaction, ReactionDirection, Search};
use super::stated_connections::works_alone;
use crate::model::reactions::random_pose::{DrawnModel, Triple};
use crate::model::reactions::relative_motion::{BodyPair, Holder};
use crate::model::{Place, ReactionKind};

/// Slip of the two points between which forces are searched.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Slip {
    /// The points do not move relative to one another.
    None,
    /// The points may slide relative to one another.
    Allowed,
}

impl Search<'_> {
    /// Chooses reactions that no connection of the model file transmits and that are still missing.
    pub fn elsewhere(&mut self) {
        // Points without slip come first. A force at a point where bodies slide is tried last.
        for slip in [Slip::None, Slip::Allowed] {
            self.contacts(slip);
            if slip == Slip::Allowed {
                self.spins();
            }
            self.loops(slip);
        }
        self.lines();
        self.tree();
        self.shared();
    }

    /// Chooses reactions between each body and its support, in the motions that all constraints
    /// together permit.
    fn tree(&mut self) {
        for support in self.supports.clone() {
            for (kind, velocities) in self.relative.between(support.body, support.holder) {
                self.along_wanted_axes(kind, &velocities, support.body, support.holder);
            }
        }
    }

    /// Accepts the reactions of a kind along axes that do no work at these relative velocities, one
    /// velocity for each speed.
    fn along_wanted_axes(&mut self, kind: ReactionKind, velocities: &[Triple], body: usize, holder: Holder) {
        if self.missing == 0 {
            return;
        }
        for (frame, axis) in self.relative.axes_between(body, holder) {
            let direction = self.relative.drawn.frames[frame].axes[axis];
            let works = velocities.iter().any(|v| self.relative.drawn.space.dot(*v, direction) != 0);
            if !works && self.is_wanted(kind, direction) {
                self.choose(self.last_place(), FoundReaction::along_axis(kind, frame, axis), direction, Vec::new());
            }
        }
    }

    /// Chooses forces along massless rods: between points at a constant distance, of two bodies or of a
    /// body and the ground.
    fn lines(&mut self) {
        let count = self.relative.model.points.len();
        for BodyPair { body, against: holder } in self.relative.pairs() {
            if self.missing == 0 {
                return;
            }
            let is_end = |at: &usize| holder.map_or_else(|| self.relative.stays(*at), |b| self.relative.has(b, *at));
            let ends: Vec<usize> = (0..count).filter(is_end).collect();
            for point in (0..count).filter(|at| self.relative.has(body, *at)).collect::<Vec<_>>() {
                for opposite in &ends {
                    self.line(body, holder, point, *opposite);
                }
            }
        }
    }

    /// Chooses the force along the line between two points, if it does no work and is needed.
    fn line(&mut self, body: usize, holder: Holder, point: usize, opposite: usize) {
        let DrawnModel { space, points, .. } = &self.relative.drawn;
        let way = space.sub(points[opposite].place, points[point].place);
        if self.missing == 0 || way == [0; 3] {
            return;
        }
        let slips = self.relative.slips(body, holder, point, opposite);
        if slips.iter().any(|slip| space.dot(*slip, way) != 0) {
            return;
        }
        let against = holder.map(|body| Place { body, point: opposite });
        let kind = ReactionKind::Force { on: Place { body, point }, against };
        if self.is_wanted(kind, way) {
            let found =
                FoundReaction { kind, along: ReactionDirection::Line(point, opposite), is_shared: false, law: None };
            self.choose(self.last_place(), found, way, Vec::new());
        }
    }

    /// Chooses forces and torques at supports that each do work, and together hold directions that no
    /// axis holds. Each of them adds an unknown. They add as many equations as their powers for the
    /// speeds have independent vectors.
    fn shared(&mut self) {
        let all: Vec<_> =
            self.supports.iter().flat_map(|support| self.relative.working(support.body, support.holder)).collect();
        let powers: Vec<Vec<u64>> = all.iter().map(|(_, power)| power.clone()).collect();
        let field = self.relative.drawn.space.0;
        for (at, (found, power)) in all.into_iter().enumerate() {
            let Some(direction) = self.relative.direction(&found) else { continue };
            if !works_alone(field, &powers, at) && self.is_wanted(found.kind, direction) {
                self.choose(self.last_place(), found, direction, power);
            }
        }
    }

    /// Chooses forces between two bodies that touch at a point.
    fn contacts(&mut self, slip: Slip) {
        for BodyPair { body, against: holder } in self.relative.pairs() {
            for point in 0..self.relative.model.points.len() {
                let is_there =
                    |b: usize| self.relative.is_rigid(Some(b)) || self.relative.model.bodies[b].centre == point;
                if is_there(body) && holder.is_none_or(is_there) {
                    self.meeting(body, holder, point, point, slip);
                }
            }
        }
    }

    /// Chooses torques that prevent bodies from rotating relative to the ground, then relative to one
    /// another.
    fn spins(&mut self) {
        for BodyPair { body, against: holder } in self.relative.pairs() {
            if self.missing > 0 && self.relative.is_rigid(Some(body)) && self.relative.is_rigid(holder) {
                let turns = self.relative.turns(body, holder);
                self.along_wanted_axes(ReactionKind::Torque { on: body, against: holder }, &turns, body, holder);
            }
        }
    }

    /// Chooses forces between points of two bodies that loops keep together.
    fn loops(&mut self, slip: Slip) {
        for BodyPair { body, against: holder } in self.relative.pairs() {
            let Some(other) = holder else { continue };
            for point in 0..self.relative.model.points.len() {
                for opposite in 0..self.relative.model.points.len() {
                    if point != opposite && self.relative.has(body, point) && self.relative.has(other, opposite) {
                        self.meeting(body, holder, point, opposite, slip);
                    }
                }
            }
        }
    }

    /// Chooses forces between a point of one body and a point of another, or of the ground, as far as
    /// slip is allowed.
    fn meeting(&mut self, body: usize, holder: Holder, point: usize, opposite: usize, slip: Slip) {
        if self.missing == 0 {
            return;
        }
        let slips = self.relative.slips(body, holder, point, opposite);
        if slip == Slip::Allowed || slips.iter().all(|velocity| *velocity == [0; 3]) {
            let against = holder.map(|body| Place { body, point: opposite });
            let kind = ReactionKind::Force { on: Place { body, point }, against };
            self.along_wanted_axes(kind, &slips, body, holder);
        }
    }
}
