//! Stated connections: chooses the reactions that connections of the model file transmit, in a fixed order.
//!
//! 1. Stated reactions, and joints that close loops.
//! 2. Contacts without slip, along the directions that are stated, and edges. An edge is a
//!    constraint that states a single velocity component of a body's point, or of its angular
//!    velocity; it holds the body against the ground.
//! 3. Joints, and bodies from whose points or in whose frames other bodies are placed.
//! 4. Contacts without slip that follow from the placement of bodies: a wheel, not the car, presses
//!    on the ground.
//! 5. The ground, under bodies that rest on nothing else. Last, the ground under bodies that touch
//!    another body.
//! 6. Bodies that the file states to touch: all reactions between them, in addition to those of the
//!    contact.

use super::reaction_search::{FoundReaction, ReactionDirection, Search};
use crate::algebra::text::parse::VelocityOf;
use crate::algebra::value::field::Field;
use crate::algebra::value::rank::Basis;
use crate::model::reactions::random_pose::VectorResidues;
use crate::model::reactions::relative_motion::{Holder, RelativeMotion, reaction_pair};
use crate::model::reactions::supports::{Support, SupportReason};
use crate::model::{
    ConstrainedVelocity, ForcePlace, MotionConstraint, MotionConstraintKind, ReactionKind, SlipComponent,
};

/// Motions that a mechanism would have if loops were open and nothing rolled, each as a basis. `None` in place of a
/// basis means the mechanism's own motions.
struct OpenMotions {
    /// Basis of the motions in which the velocity equations of the model file hold, except those in `placed`.
    open: Option<Vec<Vec<u64>>>,
    /// Basis of the motions in which no velocity equation of the model file needs to hold.
    free: Option<Vec<Vec<u64>>>,
    /// Names of the velocity constraints that edges enforce.
    placed: Vec<String>,
}

/// Treatment of the velocity equations that the model file states, edges excepted.
#[derive(Clone, Copy, PartialEq, Eq)]
enum OtherEquations {
    /// The velocity equations hold in the motions.
    Hold,
    /// The velocity equations need not hold in the motions.
    Ignored,
}

/// Edge: a constraint that states a single velocity component of a single body, as a blade does.
struct StatedEdge {
    /// Name of the constraint in the model file.
    name: String,
    /// Force or torque that holds the body against the ground.
    kind: ReactionKind,
    /// Index of the frame along whose axis the force or torque acts.
    frame: usize,
    /// Axis of the force or torque: 0, 1 or 2.
    axis: usize,
}

impl Search<'_> {
    /// Chooses the reactions that the connections of the model file transmit.
    pub fn choose_stated_connections(&mut self) {
        let model = self.relative.model;
        let touches = self.relative.touching_supports(&self.relative.degrees_of_freedom());
        let on_body = |body: usize| touches.iter().any(|pair| pair.body == body && pair.against.is_some());
        let (mut placed, mut ground, mut touching) = (Vec::new(), Vec::new(), Vec::new());
        for support in &self.supports {
            match (support.reason, support.holder) {
                (SupportReason::Joint | SupportReason::Placed | SupportReason::Least, _) => placed.push(*support),
                (_, None) => ground.push(*support),
                (_, Some(_)) => touching.push(*support),
            }
        }
        ground.sort_by_key(|support| on_body(support.body));
        let tied = model.motion_constraints.iter().filter_map(|constraint| match constraint.kind {
            MotionConstraintKind::Rolling(rolled) => Some(rolled),
            _ => None,
        });
        let tied: Vec<SlipComponent> = tied.collect();
        // A body that rests on another body presses along the axes of that connection.
        let rests_there = |rolled: &SlipComponent| {
            self.supports.iter().any(|support| (support.body, support.holder) == (rolled.body, rolled.against))
        };
        let built_in = model.repeated.iter().filter_map(|repeated| repeated.rolled);
        let built_in: Vec<SlipComponent> = built_in.filter(|rolled| !rests_there(rolled)).collect();
        let edges = self.relative.stated_edges();
        let elsewhere: Vec<&str> = edges.iter().map(|edge| edge.name.as_str()).collect();
        let ways = OpenMotions {
            open: self.relative.motions_of_opened_loops(OtherEquations::Hold, &elsewhere),
            free: self.relative.motions_of_opened_loops(OtherEquations::Ignored, &elsewhere),
            placed: elsewhere.iter().map(|name| (*name).to_owned()).collect(),
        };
        self.choose_stated_rolling_forces(&tied, 0);
        self.choose_stated_edges(&edges);
        self.choose_stated_supports(&placed, &ways);
        let built_in: Vec<SlipComponent> =
            built_in.into_iter().map(|rolled| self.relative.along_own_axis(rolled)).collect();
        self.choose_stated_rolling_forces(&built_in, self.last_list_position());
        self.choose_stated_supports(&ground, &ways);
        self.choose_stated_supports(&touching, &ways);
    }

    /// Chooses forces at rolling contacts along the directions without slip. The axes of other connections, such as
    /// those of a gear, may be oblique to these directions.
    fn choose_stated_rolling_forces(&mut self, components: &[SlipComponent], place: usize) {
        for &SlipComponent { body, against, point, frame, axis, .. } in components {
            let on = ForcePlace { body, point };
            let kind = ReactionKind::Force { on, against: against.map(|body| ForcePlace { body, point }) };
            let slips = self.relative.slip_velocities(body, against, point, point);
            let direction = self.relative.drawn.frames[frame].axes[axis];
            if slips.iter().all(|slip| self.relative.drawn.space.dot(*slip, direction) == 0) {
                self.choose(place, FoundReaction::along_axis(kind, frame, axis), direction, Vec::new());
            }
        }
    }

    /// Chooses the forces and torques of edges, unless a stated reaction holds the edge's body against
    /// the ground.
    fn choose_stated_edges(&mut self, edges: &[StatedEdge]) {
        for StatedEdge { name, kind, frame, axis } in edges {
            let model = self.relative.model;
            let is_enforced = model.motion_constraints.iter().any(|c| c.name == *name && c.enforced_by.is_some());
            let is_held =
                model.stated_reactions().iter().any(|reaction| reaction_pair(reaction.kind) == reaction_pair(*kind));
            let velocities = match *kind {
                ReactionKind::Force { on, .. } => self.relative.slip_velocities(on.body, None, on.point, on.point),
                ReactionKind::Torque { on, .. } => self.relative.relative_angular_velocities(on, None),
            };
            let direction = self.relative.drawn.frames[*frame].axes[*axis];
            let works = velocities.iter().any(|v| self.relative.drawn.space.dot(*v, direction) != 0);
            if !is_enforced && !is_held && !works {
                self.choose(0, FoundReaction::along_axis(*kind, *frame, *axis), direction, Vec::new());
            }
        }
    }

    /// Chooses the reactions between bodies and the bodies on which they rest. Each connection is treated without
    /// regard to the other connections.
    fn choose_stated_supports(&mut self, supports: &[Support], ways: &OpenMotions) {
        self.relative.ways_if_open.clone_from(&ways.open);
        for support in supports {
            for (kind, steady_velocities_along_symmetries) in
                self.relative.reactions_between(support.body, support.holder)
            {
                self.choose_stated_along_axes(kind, &steady_velocities_along_symmetries, support);
            }
        }
        for support in supports {
            self.choose_joint_work_reactions(support.body, support.holder, ways);
        }
        self.relative.ways_if_open = None;
    }

    /// Chooses independent reactions between a body and its support, along axes of frames. Each chosen reaction does
    /// no work by itself.
    fn choose_stated_along_axes(&mut self, kind: ReactionKind, velocities: &[VectorResidues], support: &Support) {
        let field = self.relative.drawn.space.0;
        let mut open = 3 - rank(field, velocities.iter().map(|velocity| velocity.to_vec()));
        let mut own = Basis::new(field);
        for (frame, axis) in self.relative.axes_between(support.body, support.holder) {
            if open == 0 {
                return;
            }
            let direction = self.relative.drawn.frames[frame].axes[axis];
            let works = velocities.iter().any(|v| self.relative.drawn.space.dot(*v, direction) != 0);
            if works || own.add_row(direction.to_vec()).is_none() {
                continue;
            }
            open -= 1;
            let found = FoundReaction::along_axis(kind, frame, axis);
            self.choose(self.list_position_of_body(support.body), found, direction, Vec::new());
        }
    }

    /// Chooses the forces and torques of a connection that do no work together, but do work by themselves, such as
    /// those of a screw.
    fn choose_joint_work_reactions(&mut self, body: usize, holder: Holder, ways: &OpenMotions) {
        let field = self.relative.drawn.space.0;
        self.relative.ways_if_open.clone_from(&ways.free);
        let (working, kinds) =
            (self.relative.working_found_reactions(body, holder), self.relative.reactions_between(body, holder));
        self.relative.ways_if_open = None;
        let alone: usize = kinds.iter().map(|(_, v)| 3 - rank(field, v.iter().map(|v| v.to_vec()))).sum();
        let twist = |way: usize| kinds.iter().flat_map(|(_, velocities)| velocities[way]).collect::<Vec<u64>>();
        let all = 3 * kinds.len() - rank(field, (0..kinds[0].1.len()).map(twist));
        if all <= alone {
            return;
        }
        let in_motion = self.relative.working_found_reactions(body, holder);
        let powers: Vec<Vec<u64>> = working.iter().map(|(_, power)| power.clone()).collect();
        let law = if ways.free.is_some() { self.stated_connection_law(body, holder, &ways.placed) } else { None };
        let of_speeds = self.relative.model.speeds.len();
        for (at, (found, _)) in working.iter().enumerate() {
            let along_speeds = in_motion.iter().find(|(other, _)| other.is_same(found)).map(|(_, power)| power.clone());
            if is_power_unbalanced(field, &powers, at) || along_speeds.is_none() && law.is_none() {
                continue;
            }
            let mut power = along_speeds.unwrap_or_else(|| vec![0; of_speeds]);
            let mut found = *found;
            if let Some(law) = &law {
                found.law = Some(body);
                power.resize(of_speeds + body * self.relative.model.coordinates.len(), 0);
                let own = law.iter().find(|(other, _)| other.is_same(&found));
                power.extend(own.into_iter().flat_map(|(_, power)| power));
            }
            let (Some(direction), place) =
                (self.relative.direction_of_found_reaction(&found), self.list_position_of_body(body))
            else {
                continue;
            };
            self.choose(place, found, direction, power);
        }
    }

    /// Law of a connection: the connection's reactions that do work if loops are open and nothing rolls. Each has its
    /// power along each coordinate's rate. `None` if a stated velocity equation restricts these rates, since the
    /// connection may then hold what the equation prevents.
    fn stated_connection_law(
        &mut self,
        body: usize,
        holder: Holder,
        placed: &[String],
    ) -> Option<Vec<(FoundReaction, Vec<u64>)>> {
        let model = self.relative.model;
        let (n, open) = (model.coordinates.len(), model.undriven_coordinates());
        let unit = |along: usize| (0..n).map(|at| u64::from(at == along && open.contains(&at))).collect();
        let before = self.relative.ways_if_open.replace((0..n).map(unit).collect());
        let list = self.relative.working_found_reactions(body, holder);
        self.relative.ways_if_open = before;
        let moves = |at: usize| list.iter().any(|(_, power)| power[at] != 0);
        let ties = |at: usize, constraint: &MotionConstraint| {
            constraint.kind == MotionConstraintKind::Stated
                && !placed.contains(&constraint.name)
                && model.arena.mentions(constraint.equation, model.coordinates[at].rate)
        };
        let is_tied = (0..n).any(|at| moves(at) && model.motion_constraints.iter().any(|c| ties(at, c)));
        (!is_tied).then_some(list)
    }
}

impl RelativeMotion<'_> {
    /// Edges: constraints that each state a single velocity component of a single body.
    fn stated_edges(&self) -> Vec<StatedEdge> {
        let model = self.model;
        let holds = |of: &VelocityOf<usize>| {
            let (body, point) = match *of {
                VelocityOf::Material(body, point) => (body, point),
                VelocityOf::Point(point) => (self.body_of_point(point)?, point),
                VelocityOf::Turning(frame) => {
                    let is_own =
                        |body: &usize| model.bodies[*body].rigid.as_ref().is_some_and(|(own, _)| *own == frame);
                    let mut bodies = (0..model.bodies.len()).filter(is_own);
                    let on = bodies.next().filter(|_| bodies.next().is_none())?;
                    return Some(ReactionKind::Torque { on, against: None });
                }
                VelocityOf::Place(_) => return None,
            };
            Some(ReactionKind::Force { on: ForcePlace { body, point }, against: None })
        };
        let stated = model.motion_constraints.iter().filter(|c| c.kind == MotionConstraintKind::Stated);
        let edge = |constraint: &MotionConstraint| {
            let compared = model.contacts.compared.iter().find(|compared| compared.name == constraint.name)?;
            let ConstrainedVelocity { of, frame, axis } = compared.alone.as_ref()?;
            Some(StatedEdge { name: constraint.name.clone(), kind: holds(of)?, frame: *frame, axis: *axis })
        };
        stated.filter_map(edge).collect()
    }

    /// Basis of the motions that the mechanism would have if loops were open and nothing rolled, without the
    /// constraints named in `placed`. `others` says if the other velocity equations of the model file hold. `None` if
    /// these motions are the mechanism's own.
    fn motions_of_opened_loops(&self, others: OtherEquations, placed: &[&str]) -> Option<Vec<Vec<u64>>> {
        let model = self.model;
        let holds = |constraint: &MotionConstraint| match constraint.kind {
            MotionConstraintKind::Loop(at) => model.loops[at].prescribes,
            MotionConstraintKind::Clock => true,
            MotionConstraintKind::Rolling(_) => false,
            MotionConstraintKind::Stated => {
                others == OtherEquations::Hold && !placed.contains(&constraint.name.as_str())
            }
        };
        let is_open = !model.openings.is_empty() || !model.motion_constraints.iter().all(holds);
        is_open.then(|| self.open_motions(&mut model.arena.clone(), &holds)).flatten()
    }

    /// The rolling component, taken along that axis of the bodies' own frames which has the same direction. Unchanged
    /// if no axis has this direction.
    fn along_own_axis(&self, rolled: SlipComponent) -> SlipComponent {
        let direction = |frame: usize, axis: usize| self.drawn.frames[frame].axes[axis];
        let wanted = direction(rolled.frame, rolled.axis);
        let mut axes = self.axes_between(rolled.body, rolled.against).into_iter();
        let same = axes.find(|(frame, axis)| direction(*frame, *axis) == wanted);
        same.map_or(rolled, |(frame, axis)| SlipComponent { frame, axis, ..rolled })
    }

    /// Force and torque between a body and its support, each with the relative velocities at which it does work. They
    /// act at the point where the two bodies move least relative to one another.
    pub fn reactions_between(&self, body: usize, holder: Holder) -> Vec<(ReactionKind, Vec<VectorResidues>)> {
        let point = self.least_moving_point(body, holder);
        let against = holder.map(|body| ForcePlace { body, point });
        let force = ReactionKind::Force { on: ForcePlace { body, point }, against };
        let mut kinds = vec![(force, self.slip_velocities(body, holder, point, point))];
        if self.is_rigid(Some(body)) && self.is_rigid(holder) {
            kinds.push((
                ReactionKind::Torque { on: body, against: holder },
                self.relative_angular_velocities(body, holder),
            ));
        }
        kinds
    }

    /// Forces and torques between a body and its support that do work, along the axes of one frame. Each has its
    /// power for every permitted motion.
    pub fn working_found_reactions(&self, body: usize, holder: Holder) -> Vec<(FoundReaction, Vec<u64>)> {
        let frame = self.frames(body, holder)[0];
        let mut list = Vec::new();
        for (kind, velocities) in self.reactions_between(body, holder) {
            for axis in 0..3 {
                let direction = self.drawn.frames[frame].axes[axis];
                let power: Vec<u64> = velocities.iter().map(|v| self.drawn.space.dot(*v, direction)).collect();
                if power.iter().any(|x| *x != 0) {
                    list.push((
                        FoundReaction { is_shared: true, ..FoundReaction::along_axis(kind, frame, axis) },
                        power,
                    ));
                }
            }
        }
        list
    }

    /// Direction of a reaction along an axis of a frame, as residues; `None` for a reaction along a
    /// line.
    pub fn direction_of_found_reaction(&self, found: &FoundReaction) -> Option<VectorResidues> {
        match found.along {
            ReactionDirection::Axis(frame, axis) => Some(self.drawn.frames[frame].axes[axis]),
            ReactionDirection::Line(..) => None,
        }
    }

    /// Axes along which a body and its support may act on one another, as (frame, axis 0, 1 or 2). Axes of the two
    /// bodies' own frames come first.
    pub fn axes_between(&self, body: usize, holder: Holder) -> Vec<(usize, usize)> {
        let frames = self.frames(body, holder).into_iter();
        frames.flat_map(|frame| (0..3).map(move |axis| (frame, axis))).collect()
    }
}

/// Rank of a matrix of residues modulo a prime. The matrix is given by its rows.
fn rank(field: Field, rows: impl Iterator<Item = Vec<u64>>) -> usize {
    let mut basis = Basis::new(field);
    rows.for_each(|row| {
        basis.add_row(row);
    });
    basis.len()
}

/// True if the power of the reaction `at` is independent of the powers of all other reactions. Such a reaction is
/// zero, since no other reaction balances its power.
pub fn is_power_unbalanced(field: Field, powers: &[Vec<u64>], at: usize) -> bool {
    let mut others = Basis::new(field);
    for (_, power) in powers.iter().enumerate().filter(|(other, _)| *other != at) {
        others.add_row(power.clone());
    }
    others.add_row(powers[at].clone()).is_some()
}
