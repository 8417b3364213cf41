//! Motion of bodies relative to one another and to the ground, in one random pose ([`super::random_pose`]).

use super::random_pose::{RandomModel, VectorResidues};
use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::rank::Basis;
use crate::algebra::{Arena, Expr};
use crate::model::{Model, MotionConstraint, MotionConstraintKind, ReactionKind};

/// Index of the body on which another body rests; `None` is the ground.
pub type Holder = Option<usize>;

/// Pair of a body and another body or the ground, for example its support, or the body on which a reaction's opposite
/// acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BodyPair {
    /// Index of the first body.
    pub body: usize,
    /// Index of the second body; `None` is the ground.
    pub against: Holder,
}

impl BodyPair {
    /// True if the pair consists of the bodies `one` and `other`, in any order.
    pub fn joins(self, one: Holder, other: Holder) -> bool {
        [(one, other), (other, one)].contains(&(Some(self.body), self.against))
    }

    /// The pair with its two bodies exchanged; `None` for a pair with the ground.
    pub fn reversed(self) -> Option<Self> {
        self.against.map(|body| Self { body, against: Some(self.body) })
    }
}

/// Body on which a reaction acts, paired with the body or ground on which its opposite acts.
pub fn reaction_pair(kind: ReactionKind) -> BodyPair {
    match kind {
        ReactionKind::Force { on, against } => BodyPair { body: on.body, against: against.map(|place| place.body) },
        ReactionKind::Torque { on, against } => BodyPair { body: on, against },
    }
}

/// Model in a random pose, with the relative motion of its bodies in that pose.
pub struct RelativeMotion<'m> {
    /// Model whose bodies move relative to one another.
    pub model: &'m Model,
    /// Model in the random pose, as residues.
    pub drawn: RandomModel,
    /// Basis of motions that replaces the motions along the generalized speeds; `None` keeps those. Each motion has a
    /// rate for every coordinate, then for each motion of an opened joint (`Model::openings`).
    pub ways_if_open: Option<Vec<Vec<u64>>>,
}

impl Model {
    /// Indices of the coordinates whose rates are free if all loops are open: those that are neither time nor
    /// prescribed.
    pub(crate) fn undriven_coordinates(&self) -> Vec<usize> {
        let drives = |constraint: &&MotionConstraint| match constraint.kind {
            MotionConstraintKind::Loop(at) => self.loops[at].prescribes,
            MotionConstraintKind::Clock => true,
            MotionConstraintKind::Rolling(_) | MotionConstraintKind::Stated => false,
        };
        let is_driven =
            |rate: Expr| self.motion_constraints.iter().filter(drives).any(|c| self.arena.mentions(c.equation, rate));
        (0..self.coordinates.len()).filter(|at| !is_driven(self.coordinates[*at].rate)).collect()
    }
}

impl RelativeMotion<'_> {
    /// Velocity of the material of a body, or of the ground, at a point, per unit rate of the motion with the index
    /// `along`.
    pub fn material_velocity(&self, body: Holder, point: usize, along: usize) -> VectorResidues {
        body.map_or([0; 3], |body| self.drawn.material(self.model, body, point, Some(along)))
    }

    /// Angular velocity of a rigid body, or of the ground, per unit rate of the motion with the index `along`. It is
    /// zero for a particle.
    pub fn angular_velocity(&self, body: Holder, along: usize) -> VectorResidues {
        let frame = body.and_then(|body| Some(self.model.bodies[body].rigid.as_ref()?.0));
        frame.map_or([0; 3], |frame| self.drawn.frames[frame].along[along])
    }

    /// True for a rigid body and for the ground; false for a particle.
    pub fn is_rigid(&self, body: Holder) -> bool {
        body.is_none_or(|body| self.model.bodies[body].rigid.is_some())
    }

    /// Number of motions of the mechanism if all closing joints are open. There is one along each coordinate, then
    /// one for each opened joint (`Model::openings`).
    fn motions(&self) -> usize {
        self.model.coordinates.len() + self.model.openings.len()
    }

    /// Indices of the motions of the mechanism if all closing joints are open, without that along time.
    pub fn own_motions(&self) -> impl Iterator<Item = usize> + use<'_> {
        let time = self.model.time();
        (0..self.motions()).filter(move |at| Some(*at) != time)
    }

    /// Rank of the vectors `of(motion)` over all motions, the one along time included. Time counts, since a body that
    /// hangs on a driven crank does not hang on the ground.
    pub fn rank_of_motions(&self, of: impl Fn(usize) -> Vec<VectorResidues>) -> usize {
        let mut basis = Basis::new(self.drawn.space.0);
        for along in 0..self.motions() {
            basis.add_row(of(along).concat());
        }
        basis.len()
    }

    /// Number of degrees of freedom of a body relative to another, or to the ground.
    pub fn freedom(&self, body: usize, against: Holder) -> usize {
        let space = self.drawn.space;
        // A particle has no rotation relative to another body.
        let turns = self.is_rigid(Some(body));
        // The material of a particle is only at the particle's own point.
        let particle = against.filter(|_| !self.is_rigid(against));
        let point = self.model.bodies[particle.unwrap_or(body)].centre;
        self.rank_of_motions(|along| {
            let slip = space
                .sub(self.material_velocity(Some(body), point, along), self.material_velocity(against, point, along));
            let turn = space.sub(self.angular_velocity(Some(body), along), self.angular_velocity(against, along));
            if turns { vec![slip, turn] } else { vec![slip] }
        })
    }

    /// Index of the point at which the material of two bodies moves least relative to one another. Among equal
    /// points, the mass centre of `body` is preferred.
    pub fn least_moving_point(&self, body: usize, holder: Holder) -> usize {
        let centre = self.model.bodies[body].centre;
        let own: Vec<usize> = [Some(body), holder]
            .into_iter()
            .flatten()
            .filter(|body| !self.is_rigid(Some(*body)))
            .map(|body| self.model.bodies[body].centre)
            .collect();
        let points: Vec<usize> = match own.first() {
            Some(own) => vec![*own],
            None => std::iter::once(centre).chain((0..self.model.points.len()).filter(|at| *at != centre)).collect(),
        };
        let space = self.drawn.space;
        let slip = |point: usize| {
            self.rank_of_motions(|along| {
                vec![space.sub(
                    self.material_velocity(Some(body), point, along),
                    self.material_velocity(holder, point, along),
                )]
            })
        };
        points.into_iter().min_by_key(|point| slip(*point)).unwrap_or(centre)
    }

    /// Frames along whose axes reactions are searched: the frame of the supporting body, then that of the body, then
    /// all other frames.
    pub fn frames(&self, body: usize, holder: Holder) -> Vec<usize> {
        let of = |body: usize| self.model.bodies[body].rigid.as_ref().map(|(frame, _)| *frame);
        let mut list = vec![holder.and_then(of).unwrap_or(0)];
        let others = of(body).into_iter().chain(0..self.model.frames.len());
        for frame in others {
            if !list.contains(&frame) {
                list.push(frame);
            }
        }
        list
    }

    /// Basis of the motions that the mechanism would have if no motion constraint held except those that `holds`
    /// accepts. `None` if a term has no value.
    pub fn open_motions(&self, arena: &mut Arena, holds: &dyn Fn(&MotionConstraint) -> bool) -> Option<Vec<Vec<u64>>> {
        let model = self.model;
        let held: Vec<&MotionConstraint> = model.motion_constraints.iter().filter(|c| holds(c)).collect();
        let mut along = Gradient::new(&model.q_dot());
        let (first, n) = (model.coordinates.len(), self.motions());
        let mut terms = vec![Expr::ZERO; n * held.len()];
        for (row, constraint) in held.iter().enumerate() {
            for (at, slope) in along.apply(arena, constraint.equation).iter() {
                terms[row * n + at] = *slope;
            }
            for (at, opening) in model.openings.iter().enumerate() {
                let broken = opening.breaks.iter().find(|(name, _)| *name == constraint.name);
                terms[row * n + first + at] = broken.map_or(Expr::ZERO, |(_, slope)| *slope);
            }
        }
        let mut values = self.drawn.values(model, arena, &terms)?;
        let mut basis = Basis::new(self.drawn.space.0);
        for _ in &held {
            basis.add_row((0..n).map(|_| values.one()).collect());
        }
        Some(basis.null_space(n))
    }

    /// Converts velocities `along` each rate q̇ into velocities for each generalized speed. If [`Self::ways_if_open`]
    /// is set, into velocities for each motion of that basis.
    pub fn permitted_velocities(&self, along: impl Fn(usize) -> VectorResidues) -> Vec<VectorResidues> {
        let space = self.drawn.space;
        if let Some(ways) = &self.ways_if_open {
            let velocity = |way: &Vec<u64>| {
                let moving = way.iter().enumerate().filter(|(_, rate)| **rate != 0);
                moving.fold([0; 3], |sum, (at, rate)| space.add(sum, space.scale(*rate, along(at))))
            };
            return ways.iter().map(velocity).collect();
        }
        let mut list = vec![[0; 3]; self.model.speeds.len()];
        for (at, rates) in self.drawn.partial_rates.iter().enumerate() {
            let velocity = along(at);
            for (sum, rate) in list.iter_mut().zip(rates) {
                *sum = space.add(*sum, space.scale(*rate, velocity));
            }
        }
        list
    }

    /// Velocities of a body's material at `point` relative to the supporting body's material at `opposite`, one for
    /// each speed or motion of [`Self::permitted_velocities`].
    pub fn slip_velocities(&self, body: usize, holder: Holder, point: usize, opposite: usize) -> Vec<VectorResidues> {
        let space = self.drawn.space;
        self.permitted_velocities(|along| {
            space.sub(self.material_velocity(Some(body), point, along), self.material_velocity(holder, opposite, along))
        })
    }

    /// Pairs between which reactions are searched: each body with the ground, then each body with each later body.
    pub fn pairs(&self) -> Vec<BodyPair> {
        let count = self.model.bodies.len();
        let on_ground = (0..count).map(|body| BodyPair { body, against: None });
        let on_bodies = (0..count).flat_map(|body| (body + 1..count).map(move |b| BodyPair { body, against: Some(b) }));
        on_ground.chain(on_bodies).collect()
    }

    /// True if the same material of a body is at a point at all times.
    pub fn has_material_point(&self, body: usize, point: usize) -> bool {
        if !self.is_rigid(Some(body)) {
            return self.model.bodies[body].centre == point;
        }
        let moves =
            |along: usize| self.drawn.points[point].along[along] != self.material_velocity(Some(body), point, along);
        !self.own_motions().any(moves)
    }

    /// True if a point is fixed to the ground: no motion moves it, except perhaps that along time.
    pub fn is_ground_point(&self, point: usize) -> bool {
        self.own_motions().all(|along| self.drawn.points[point].along[along] == [0; 3])
    }

    /// Angular velocities of a body relative to the supporting body, one for each speed or motion of
    /// [`Self::permitted_velocities`].
    pub fn relative_angular_velocities(&self, body: usize, holder: Holder) -> Vec<VectorResidues> {
        let space = self.drawn.space;
        self.permitted_velocities(|along| {
            space.sub(self.angular_velocity(Some(body), along), self.angular_velocity(holder, along))
        })
    }
}
