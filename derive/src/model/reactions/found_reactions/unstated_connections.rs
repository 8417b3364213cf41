//! Reactions at places that are no stated connections: where equations relate coordinates, and along lines and
//! directions that belong to no frame.
//!
//! All pairs of bodies are visited for contacts and loops, then for massless rods between two points. A reaction is
//! accepted if it does no work, acts in an equation that is not 0 = 0, and is independent of the reactions accepted
//! before. The search ends when there are as many reactions as the equations of all bodies need.

use super::reaction_search::{FoundReaction, ReactionDirection, Search};
use super::stated_connections::is_power_unbalanced;
use crate::model::reactions::random_pose::{RandomModel, VectorResidues};
use crate::model::reactions::relative_motion::{BodyPair, Holder};
use crate::model::{ForcePlace, ReactionKind};

/// Relative motion that is allowed at the two points between which forces are searched.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Slip {
    /// The two points do not move relative to one another.
    None,
    /// The two points may slide relative to one another.
    Allowed,
}

impl Search<'_> {
    /// Adds reactions that the stated connections do not give, until the Newton–Euler equations have enough unknowns.
    pub fn choose_unstated_reactions(&mut self) {
        // Points without slip come first. A force at a point where bodies slide is tried last.
        for slip in [Slip::None, Slip::Allowed] {
            self.choose_at_contacts(slip);
            if slip == Slip::Allowed {
                self.choose_torques();
            }
            self.choose_in_loops(slip);
        }
        self.choose_unstated_along_rods();
        self.choose_at_supports();
        self.choose_shared();
    }

    /// Chooses reactions between each body and its support. A reaction must do no work in the motions that all
    /// constraints together permit.
    fn choose_at_supports(&mut self) {
        for support in self.supports.clone() {
            for (kind, steady_velocities_along_symmetries) in
                self.relative.reactions_between(support.body, support.holder)
            {
                self.choose_unstated_along_axes(
                    kind,
                    &steady_velocities_along_symmetries,
                    support.body,
                    support.holder,
                );
            }
        }
    }

    /// Chooses the reactions of a kind along axes of frames that do no work at the given relative velocities. There
    /// is one velocity for each speed.
    fn choose_unstated_along_axes(
        &mut self,
        kind: ReactionKind,
        velocities: &[VectorResidues],
        body: usize,
        holder: Holder,
    ) {
        if self.missing == 0 {
            return;
        }
        for (frame, axis) in self.relative.axes_between(body, holder) {
            let direction = self.relative.drawn.frames[frame].axes[axis];
            let works = velocities.iter().any(|v| self.relative.drawn.space.dot(*v, direction) != 0);
            if !works && self.is_wanted(kind, direction) {
                self.choose(
                    self.last_list_position(),
                    FoundReaction::along_axis(kind, frame, axis),
                    direction,
                    Vec::new(),
                );
            }
        }
    }

    /// Chooses forces along massless rods. A rod connects two points at a constant distance, of two bodies or of a
    /// body and the ground.
    fn choose_unstated_along_rods(&mut self) {
        let count = self.relative.model.points.len();
        for BodyPair { body, against: holder } in self.relative.pairs() {
            if self.missing == 0 {
                return;
            }
            let is_end = |at: &usize| {
                holder.map_or_else(|| self.relative.is_ground_point(*at), |b| self.relative.has_material_point(b, *at))
            };
            let ends: Vec<usize> = (0..count).filter(is_end).collect();
            for point in (0..count).filter(|at| self.relative.has_material_point(body, *at)).collect::<Vec<_>>() {
                for opposite in &ends {
                    self.choose_unstated_along_rod(body, holder, point, *opposite);
                }
            }
        }
    }

    /// Chooses the force along the line between two points, if it does no work and reactions are still missing.
    fn choose_unstated_along_rod(&mut self, body: usize, holder: Holder, point: usize, opposite: usize) {
        let RandomModel { space, points, .. } = &self.relative.drawn;
        let way = space.sub(points[opposite].place, points[point].place);
        if self.missing == 0 || way == [0; 3] {
            return;
        }
        let slips = self.relative.slip_velocities(body, holder, point, opposite);
        if slips.iter().any(|slip| space.dot(*slip, way) != 0) {
            return;
        }
        let against = holder.map(|body| ForcePlace { body, point: opposite });
        let kind = ReactionKind::Force { on: ForcePlace { body, point }, against };
        if self.is_wanted(kind, way) {
            let found =
                FoundReaction { kind, along: ReactionDirection::Line(point, opposite), is_shared: false, law: None };
            self.choose(self.last_list_position(), found, way, Vec::new());
        }
    }

    /// Chooses forces and torques at supports that each do work, but together hold directions that are along no axis.
    /// Each of them adds an unknown. They add as many equations as their powers for the speeds have independent
    /// vectors.
    fn choose_shared(&mut self) {
        let all: Vec<_> = self
            .supports
            .iter()
            .flat_map(|support| self.relative.working_found_reactions(support.body, support.holder))
            .collect();
        let powers: Vec<Vec<u64>> = all.iter().map(|(_, power)| power.clone()).collect();
        let field = self.relative.drawn.space.0;
        for (at, (found, power)) in all.into_iter().enumerate() {
            let Some(direction) = self.relative.direction_of_found_reaction(&found) else { continue };
            if !is_power_unbalanced(field, &powers, at) && self.is_wanted(found.kind, direction) {
                self.choose(self.last_list_position(), found, direction, power);
            }
        }
    }

    /// Chooses forces between two bodies that touch at a point. `slip` says if the bodies may slide there.
    fn choose_at_contacts(&mut self, slip: Slip) {
        for BodyPair { body, against: holder } in self.relative.pairs() {
            for point in 0..self.relative.model.points.len() {
                let is_there =
                    |b: usize| self.relative.is_rigid(Some(b)) || self.relative.model.bodies[b].centre == point;
                if is_there(body) && holder.is_none_or(is_there) {
                    self.choose_unstated_at_points(body, holder, point, point, slip);
                }
            }
        }
    }

    /// Chooses torques that prevent bodies from rotating relative to the ground, then relative to one
    /// another.
    fn choose_torques(&mut self) {
        for BodyPair { body, against: holder } in self.relative.pairs() {
            if self.missing > 0 && self.relative.is_rigid(Some(body)) && self.relative.is_rigid(holder) {
                let turns = self.relative.relative_angular_velocities(body, holder);
                self.choose_unstated_along_axes(
                    ReactionKind::Torque { on: body, against: holder },
                    &turns,
                    body,
                    holder,
                );
            }
        }
    }

    /// Chooses forces between points of two bodies that loops keep together. `slip` says if the points may slide.
    fn choose_in_loops(&mut self, slip: Slip) {
        for BodyPair { body, against: holder } in self.relative.pairs() {
            let Some(other) = holder else { continue };
            for point in 0..self.relative.model.points.len() {
                for opposite in 0..self.relative.model.points.len() {
                    if point != opposite
                        && self.relative.has_material_point(body, point)
                        && self.relative.has_material_point(other, opposite)
                    {
                        self.choose_unstated_at_points(body, holder, point, opposite, slip);
                    }
                }
            }
        }
    }

    /// Chooses forces between a point of one body and a point of another body or of the ground. `slip` says if the
    /// points may slide relative to one another.
    fn choose_unstated_at_points(&mut self, body: usize, holder: Holder, point: usize, opposite: usize, slip: Slip) {
        if self.missing == 0 {
            return;
        }
        let slips = self.relative.slip_velocities(body, holder, point, opposite);
        if slip == Slip::Allowed || slips.iter().all(|velocity| *velocity == [0; 3]) {
            let against = holder.map(|body| ForcePlace { body, point: opposite });
            let kind = ReactionKind::Force { on: ForcePlace { body, point }, against };
            self.choose_unstated_along_axes(kind, &slips, body, holder);
        }
    }
}
