//! Reactions that nobody named: what holds bodies to each other and to the ground, for the Newton–Euler equations.
//!
//! Each body hangs on the body, or the ground, against which it moves least, at the point that moves least there. Along each axis
//! and about each axis of a frame that permitted motions do not know, a force or a torque acts; then loops and contacts are
//! gone through, pair by pair. Kept is what does no work, is felt, and is independent of what was kept before, until there are as
//! many as the equations of all bodies leave over. All of it is asked in one random pose ([`super::drawn`]); that no
//! reaction works is shown when equations are derived.

use super::drawn::{DrawnModel, Triple};
use super::{Model, Place, Reaction, ReactionKind};
use crate::algebra::rank::Basis;
use crate::algebra::{Arena, Expr};
use std::cmp::Reverse;

/// Equations of bodies up to which reactions are found: larger systems must name them.
const MOST_EQUATIONS: usize = 72;
/// The longest name of a reaction, before its number.
const MAX_LENGTH: usize = 56;

/// A body, or the ground.
type Holder = Option<usize>;

/// The search in one pose.
struct Search<'m> {
    model: &'m Model,
    drawn: DrawnModel,
    /// Six for each body, in the frame of its inertia: which components of its balances are not 0 = 0 without reactions, and with
    /// those that are known.
    moved: Vec<bool>,
    felt: Vec<bool>,
    /// What each reaction does to all balances, those of the file first.
    actions: Vec<Vec<u64>>,
    /// Those that were found, each along an axis of a frame.
    found: Vec<(ReactionKind, usize, usize)>,
    /// What reactions that were kept do to all balances.
    basis: Basis,
    /// Reactions that are still to be found.
    missing: usize,
}

impl Model {
    /// The reactions that the file names: the first.
    #[must_use]
    pub fn stated_reactions(&self) -> &[Reaction] {
        let found = self.reactions.iter().position(|r| !r.is_stated);
        &self.reactions[..found.unwrap_or(self.reactions.len())]
    }

    /// Completes the reactions, so that there are as many as Newton and Euler's equations of all bodies need; leaves them as they
    /// are where that cannot be done.
    pub(super) fn complete_reactions(&mut self) {
        let equations = |body: &super::Body| if body.rigid.is_some() { 6 } else { 3 };
        let all: usize = self.bodies.iter().map(equations).sum();
        let on_nothing = |t: &super::Torque| t.on.1.is_none() || t.against.is_some_and(|(_, body)| body.is_none());
        if all > MOST_EQUATIONS || self.torques.iter().any(on_nothing) {
            return;
        }
        let Some(mut search) = Search::new(self) else { return };
        search.tree();
        // Where bodies hold fast first: a force where they slide along it is the last to be thought of.
        for holds in [true, false] {
            search.contacts(holds);
            search.loops(holds);
        }
        // Some alone would make the equations neither solvable nor what the file says.
        if search.missing > 0 {
            return;
        }
        search.leave_out_zeros();
        for (kind, frame, axis) in search.found {
            self.name_reaction(kind, frame, axis);
        }
    }

    /// Adds a reaction along an axis of a frame, under a name that is free.
    fn name_reaction(&mut self, kind: ReactionKind, frame: usize, axis: usize) {
        let (what, body) = match kind {
            ReactionKind::Force { on, .. } => ("force", on.body),
            ReactionKind::Torque { on, .. } => ("torque", on),
        };
        let along = self.frames[frame].name.to_lowercase();
        let mut wanted = format!("{}_{what}_{along}{}", self.bodies[body].name, axis + 1);
        wanted.truncate(MAX_LENGTH);
        let mut name = wanted.clone();
        let mut times = 1;
        while self.arena.find_symbol(&name).is_some() || self.declared.contains_key(&name) {
            times += 1;
            name = format!("{wanted}_{times}");
        }
        let symbol = self.arena.symbol(&name);
        let mut direction = [Expr::ZERO; 3];
        direction[axis] = Expr::ONE;
        self.reactions.push(Reaction { name, symbol, kind, frame, direction, is_stated: false });
    }
}

impl<'m> Search<'m> {
    /// What the stated reactions leave to be found; nothing if they leave nothing.
    fn new(model: &'m Model) -> Option<Self> {
        let arena = &mut model.arena.clone();
        let drawn = DrawnModel::new(model, arena)?;
        let felt = vec![false; 6 * model.bodies.len()];
        let (basis, actions, found) = (Basis::new(drawn.space.0), Vec::new(), Vec::new());
        let mut search = Self { moved: felt.clone(), felt, model, drawn, basis, actions, found, missing: 0 };
        search.moved = search.drawn.balances(model, arena)?.iter().map(|x| *x != 0).collect();
        search.felt.clone_from(&search.moved);
        let stated = search.stated(arena)?;
        for action in &stated {
            search.feel(action);
        }
        let unknowns = search.model.speeds.len() + stated.len();
        search.missing = search.felt.iter().filter(|felt| **felt).count().checked_sub(unknowns)?;
        search.actions.clone_from(&stated);
        let independent = stated.into_iter().filter(|action| search.basis.take(action.clone()).is_some()).count();
        (search.missing > 0 && independent + search.model.speeds.len() == unknowns).then_some(search)
    }

    /// What the stated reactions do to the balances.
    fn stated(&self, arena: &mut Arena) -> Option<Vec<Vec<u64>>> {
        let directions: Vec<Expr> = self.model.reactions.iter().flat_map(|r| r.direction).collect();
        let mut values = self.drawn.values(self.model, arena, &directions)?;
        let actions = self.model.reactions.iter().map(|reaction| {
            let direction = self.drawn.space.along(&self.drawn.frames[reaction.frame].axes, values.triple());
            self.drawn.action(self.model, reaction.kind, direction)
        });
        Some(actions.collect())
    }

    /// The velocity of the material of a body, or of the ground, at a point, along q̇.
    fn material(&self, body: Holder, point: usize, along: usize) -> Triple {
        body.map_or([0; 3], |body| self.drawn.material(self.model, body, point, Some(along)))
    }

    /// The angular velocity of a rigid body, or of the ground, along q̇.
    fn turning(&self, body: Holder, along: usize) -> Triple {
        let frame = body.and_then(|body| Some(self.model.bodies[body].rigid.as_ref()?.0));
        frame.map_or([0; 3], |frame| self.drawn.frames[frame].along[along])
    }

    fn is_rigid(&self, body: Holder) -> bool {
        body.is_none_or(|body| self.model.bodies[body].rigid.is_some())
    }

    /// Coordinates other than time.
    fn own_motions(&self) -> impl Iterator<Item = usize> + use<'_> {
        let time = self.model.time();
        (0..self.model.coordinates.len()).filter(move |at| Some(*at) != time)
    }

    /// In how many ways triples change along the coordinates.
    fn ways(&self, of: impl Fn(usize) -> Vec<Triple>) -> usize {
        let mut basis = Basis::new(self.drawn.space.0);
        for along in self.own_motions() {
            basis.take(of(along).concat());
        }
        basis.len()
    }

    /// In how many ways a body moves against another, or the ground.
    fn freedom(&self, body: usize, against: Holder) -> usize {
        let space = self.drawn.space;
        // A particle holds nothing that turns.
        let turns = self.is_rigid(Some(body));
        // The material of a particle is at its own point alone.
        let particle = against.filter(|_| !self.is_rigid(against));
        let point = self.model.bodies[particle.unwrap_or(body)].centre;
        self.ways(|along| {
            let slip = space.sub(self.material(Some(body), point, along), self.material(against, point, along));
            let turn = space.sub(self.turning(Some(body), along), self.turning(against, along));
            if turns { vec![slip, turn] } else { vec![slip] }
        })
    }

    /// Each body on what it hangs on.
    fn tree(&mut self) {
        let count = self.model.bodies.len();
        let free: Vec<usize> = (0..count).map(|body| self.freedom(body, None)).collect();
        // From the outside in, so that what a body hands on is felt where it hangs.
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|body| Reverse((free[*body], *body)));
        for body in order {
            let before = (0..count).filter(|other| (free[*other], *other) < (free[body], body));
            let holders = std::iter::once(None).chain(before.map(Some));
            let of_holder = |holder: Holder| holder.map_or(0, |other| free[other]);
            let Some(holder) = holders.min_by_key(|holder| (self.freedom(body, *holder), of_holder(*holder))) else {
                continue;
            };
            let point = self.least_moving_point(body, holder);
            self.forces(body, holder, (point, point));
            if self.is_rigid(Some(body)) && self.is_rigid(holder) {
                self.torques(body, holder);
            }
        }
    }

    /// The point at which the material of two bodies moves least against one another; the mass centre, if it is one of several.
    fn least_moving_point(&self, body: usize, holder: Holder) -> usize {
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
            self.ways(|along| {
                vec![space.sub(self.material(Some(body), point, along), self.material(holder, point, along))]
            })
        };
        points.into_iter().min_by_key(|point| slip(*point)).unwrap_or(centre)
    }

    /// The frames along whose axes reactions are sought: that of the holder, that of the body, all others.
    fn frames(&self, body: usize, holder: Holder) -> Vec<usize> {
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

    /// Velocities along each speed, from those along q̇.
    fn permitted(&self, along: impl Fn(usize) -> Triple) -> Vec<Triple> {
        let space = self.drawn.space;
        let mut list = vec![[0; 3]; self.model.speeds.len()];
        for (at, rates) in self.drawn.partial_rates.iter().enumerate() {
            let velocity = along(at);
            for (sum, rate) in list.iter_mut().zip(rates) {
                *sum = space.add(*sum, space.scale(*rate, velocity));
            }
        }
        list
    }

    /// At which velocities the material of a body at a point moves against that of its holder at another, along each speed.
    fn slips(&self, body: usize, holder: Holder, (point, opposite): (usize, usize)) -> Vec<Triple> {
        let space = self.drawn.space;
        self.permitted(|along| {
            space.sub(self.material(Some(body), point, along), self.material(holder, opposite, along))
        })
    }

    /// Keeps the forces on a body at a point, from its holder at another, that do no work.
    fn forces(&mut self, body: usize, holder: Holder, (point, opposite): (usize, usize)) {
        let slips = self.slips(body, holder, (point, opposite));
        let against = holder.map(|body| Place { body, point: opposite });
        let kind = ReactionKind::Force { on: Place { body, point }, against };
        self.along_axes(kind, &slips, (body, holder));
    }

    /// Keeps the torques on a body from its holder that do no work.
    fn torques(&mut self, body: usize, holder: Holder) {
        let space = self.drawn.space;
        let turns = self.permitted(|along| space.sub(self.turning(Some(body), along), self.turning(holder, along)));
        self.along_axes(ReactionKind::Torque { on: body, against: holder }, &turns, (body, holder));
    }

    /// Keeps the reactions of a kind along axes that do no work on these velocities, which are along each speed.
    fn along_axes(&mut self, kind: ReactionKind, velocities: &[Triple], (body, holder): (usize, Holder)) {
        for frame in self.frames(body, holder) {
            for axis in 0..3 {
                if self.missing == 0 {
                    return;
                }
                let DrawnModel { space, frames, .. } = &self.drawn;
                let direction = frames[frame].axes[axis];
                let works = velocities.iter().any(|v| space.dot(*v, direction) != 0);
                let action = self.drawn.action(self.model, kind, direction);
                let is_felt = action.iter().zip(&self.felt).any(|(x, felt)| *x != 0 && *felt);
                if !works && is_felt && self.basis.take(action.clone()).is_some() {
                    self.feel(&action);
                    self.actions.push(action);
                    self.found.push((kind, frame, axis));
                    self.missing -= 1;
                }
            }
        }
    }

    /// Brings the components in which a reaction acts into play: something must hold each of them.
    fn feel(&mut self, action: &[u64]) {
        for (felt, x) in self.felt.iter_mut().zip(action) {
            if *x != 0 && !*felt {
                *felt = true;
                self.missing += 1;
            }
        }
    }

    /// Leaves out reactions that are 0, being alone in a balance in which nothing moves and no load acts.
    fn leave_out_zeros(&mut self) {
        let stated = self.actions.len() - self.found.len();
        loop {
            let count = self.actions.len();
            let alone = (0..self.moved.len()).filter(|row| !self.moved[*row]).find_map(|row| {
                let mut acting = (0..count).filter(|at| self.actions[*at][row] != 0);
                let only = acting.next().filter(|at| *at >= stated)?;
                acting.next().is_none().then_some(only)
            });
            let Some(zero) = alone else { return };
            self.actions.remove(zero);
            self.found.remove(zero - stated);
        }
    }

    /// Pairs of a body with the ground, then with each body after it, that both may have material at a point.
    fn pairs(&self) -> Vec<(usize, Holder)> {
        let count = self.model.bodies.len();
        let on_ground = (0..count).map(|body| (body, None));
        on_ground.chain((0..count).flat_map(|a| (a + 1..count).map(move |b| (a, Some(b))))).collect()
    }

    /// Whether the material of a body is at a point, and stays there.
    fn has(&self, body: usize, point: usize) -> bool {
        if !self.is_rigid(Some(body)) {
            return self.model.bodies[body].centre == point;
        }
        let moves = |along: usize| self.drawn.points[point].along[along] != self.material(Some(body), point, along);
        !self.own_motions().any(moves)
    }

    /// Forces where bodies touch at a point, without slip or with it.
    fn contacts(&mut self, holds: bool) {
        for (body, holder) in self.pairs() {
            for point in 0..self.model.points.len() {
                let is_there = |b: usize| self.is_rigid(Some(b)) || self.model.bodies[b].centre == point;
                if is_there(body) && holder.is_none_or(is_there) {
                    self.meeting(body, holder, (point, point), holds);
                }
            }
        }
    }

    /// Forces between points that loops hold together.
    fn loops(&mut self, holds: bool) {
        for (body, holder) in self.pairs() {
            let Some(other) = holder else { continue };
            for point in 0..self.model.points.len() {
                for opposite in 0..self.model.points.len() {
                    if point != opposite && self.has(body, point) && self.has(other, opposite) {
                        self.meeting(body, holder, (point, opposite), holds);
                    }
                }
            }
        }
    }

    /// Forces where two bodies meet, without slip or with it.
    fn meeting(&mut self, body: usize, holder: Holder, points: (usize, usize), holds: bool) {
        if self.missing > 0 && (!holds || self.slips(body, holder, points).iter().all(|slip| *slip == [0; 3])) {
            self.forces(body, holder, points);
        }
    }
}
