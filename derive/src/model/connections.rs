//! Reactions that nobody named: what holds bodies to each other and to the ground, for the Newton–Euler equations.
//!
//! Each body hangs on the body, or the ground, against which it moves least, at the point that moves least there. Along each axis
//! and about each axis of a frame that permitted motions do not know, a force or a torque acts; then loops and contacts are
//! gone through, pair by pair, and rods without mass between two points. Kept is what does no work, is felt, and is independent of what
//! was kept before, until there are as many as the equations of all bodies leave over. Where loops are closed, the joints of the tree hold
//! first what they would hold if the loops were open: a pin takes no torque about its axis because a loop lets it turn no more.
//!
//! What is held along no axis of a frame, as by gears or along a direction that a formula states, is held by all axes together: forces
//! and torques where bodies hang, of which each works, and whose power along each speed adds up to zero ([`super::Reaction::is_shared`]).
//! All of it is asked in one random pose ([`super::drawn`]); that no reaction works is shown when equations are derived.

use super::drawn::{DrawnModel, Triple};
use super::relative::{Holder, Relative};
use super::{Model, Place, Reaction, ReactionKind, Rolled, Tie};
use crate::algebra::field::Field;
use crate::algebra::rank::Basis;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr, Function};
use crate::geometry::Frames;

/// Equations of bodies up to which reactions are found: larger systems must name them.
pub(super) const MOST_EQUATIONS: usize = 72;
/// The longest name of a reaction, before its number.
const MAX_LENGTH: usize = 56;

/// Along what a reaction acts.
#[derive(Clone, Copy)]
enum Along {
    /// An axis of a frame.
    Axis(usize, usize),
    /// From one point to another.
    Line(usize, usize),
}

/// A reaction that was found.
#[derive(Clone, Copy)]
struct Found {
    kind: ReactionKind,
    along: Along,
    is_shared: bool,
}

/// The search in one pose.
struct Search<'m> {
    relative: Relative<'m>,
    /// Six for each body, in the frame of its inertia: which components of its balances are not 0 = 0 without reactions, and with
    /// those that are known.
    moved: Vec<bool>,
    felt: Vec<bool>,
    /// What each reaction does to all balances, those of the file first.
    actions: Vec<Vec<u64>>,
    found: Vec<Found>,
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

    /// How many equations Newton and Euler state of all bodies, where these are too many to find reactions for.
    pub(super) fn too_many_equations(&self) -> Option<usize> {
        let equations = |body: &super::Body| if body.rigid.is_some() { 6 } else { 3 };
        Some(self.bodies.iter().map(equations).sum()).filter(|all| *all > MOST_EQUATIONS)
    }

    /// Completes the reactions, so that there are as many as Newton and Euler's equations of all bodies need; leaves them as they
    /// are where that cannot be done.
    pub(super) fn complete_reactions(&mut self) {
        let on_nothing = |t: &super::Torque| t.on.1.is_none() || t.against.is_some_and(|(_, body)| body.is_none());
        if self.too_many_equations().is_some() || self.torques.iter().any(on_nothing) {
            return;
        }
        let Some(mut search) = Search::new(self) else { return };
        // What closes a loop is held by what closes it, and not by the joints that it ties.
        if !self.loops.is_empty() {
            search.relative.ways_if_open = search.relative.open_ways(&mut self.arena.clone());
        }
        // What is said not to slip is held where it is said, and not by the joint or the ground that the body hangs on.
        search.rolled();
        search.tree();
        search.relative.ways_if_open = None;
        search.rolled();
        // Where bodies hold fast first: a force where they slide along it is the last to be thought of.
        for holds in [true, false] {
            search.contacts(holds);
            if !holds {
                search.spins();
            }
            search.loops(holds);
        }
        search.lines();
        search.tree();
        search.shared();
        // Some alone would make the equations neither solvable nor what the file says.
        if search.missing > 0 {
            return;
        }
        search.leave_out_zeros();
        for found in search.found {
            self.name_reaction(found);
        }
    }

    /// Adds a reaction that was found, under a name that is free.
    fn name_reaction(&mut self, Found { kind, along, is_shared }: Found) {
        let (what, body) = match kind {
            ReactionKind::Force { on, .. } => ("force", on.body),
            ReactionKind::Torque { on, .. } => ("torque", on),
        };
        let (frame, direction, along) = match along {
            Along::Axis(frame, axis) => {
                let mut direction = [Expr::ZERO; 3];
                direction[axis] = Expr::ONE;
                (frame, direction, format!("{}{}", self.frames[frame].name.to_lowercase(), axis + 1))
            }
            Along::Line(from, to) => {
                (0, self.unit_along(from, to), format!("to_{}", self.points[to].name.to_lowercase()))
            }
        };
        let mut wanted = format!("{}_{what}_{along}", self.bodies[body].name);
        wanted.truncate(MAX_LENGTH);
        let mut name = wanted.clone();
        let mut times = 1;
        while self.arena.find_symbol(&name).is_some() || self.declared.contains_key(&name) {
            times += 1;
            name = format!("{wanted}_{times}");
        }
        let symbol = self.arena.symbol(&name);
        self.reactions.push(Reaction { name, symbol, kind, frame, direction, is_stated: false, is_shared });
    }

    /// The unit vector from one point to another, in the inertial frame.
    fn unit_along(&mut self, from: usize, to: usize) -> [Expr; 3] {
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

impl<'m> Search<'m> {
    /// What the stated reactions leave to be found; nothing if they leave nothing.
    fn new(model: &'m Model) -> Option<Self> {
        let arena = &mut model.arena.clone();
        let drawn = DrawnModel::new(model, arena)?;
        let felt = vec![false; 6 * model.bodies.len()];
        let (basis, actions, found) = (Basis::new(drawn.space.0), Vec::new(), Vec::new());
        let relative = Relative { model, drawn, ways_if_open: None };
        let mut search = Self { moved: felt.clone(), felt, relative, basis, actions, found, missing: 0 };
        search.moved = search.relative.drawn.balances(model, arena)?.iter().map(|x| *x != 0).collect();
        search.felt.clone_from(&search.moved);
        let stated = search.stated(arena)?;
        for action in &stated {
            search.feel(action);
        }
        let unknowns = search.relative.model.speeds.len() + stated.len();
        search.missing = search.felt.iter().filter(|felt| **felt).count().checked_sub(unknowns)?;
        search.actions.clone_from(&stated);
        let independent = stated.into_iter().filter(|action| search.basis.take(action.clone()).is_some()).count();
        (search.missing > 0 && independent + search.relative.model.speeds.len() == unknowns).then_some(search)
    }

    /// What the stated reactions do to the balances.
    fn stated(&self, arena: &mut Arena) -> Option<Vec<Vec<u64>>> {
        let directions: Vec<Expr> = self.relative.model.reactions.iter().flat_map(|r| r.direction).collect();
        let mut values = self.relative.drawn.values(self.relative.model, arena, &directions)?;
        let actions = self.relative.model.reactions.iter().map(|reaction| {
            let direction =
                self.relative.drawn.space.along(&self.relative.drawn.frames[reaction.frame].axes, values.triple());
            self.relative.drawn.action(self.relative.model, reaction.kind, direction)
        });
        Some(actions.collect())
    }

    /// Each body on what it hangs on.
    fn tree(&mut self) {
        // From the outside in, so that what a body hands on is felt where it hangs.
        for (body, holder) in self.relative.holders() {
            let point = self.relative.least_moving_point(body, holder);
            self.forces(body, holder, (point, point));
            if self.relative.is_rigid(Some(body)) && self.relative.is_rigid(holder) {
                self.torques(body, holder);
            }
        }
    }

    /// Keeps the forces on a body at a point, from its holder at another, that do no work.
    fn forces(&mut self, body: usize, holder: Holder, (point, opposite): (usize, usize)) {
        let slips = self.relative.slips(body, holder, (point, opposite));
        let against = holder.map(|body| Place { body, point: opposite });
        let kind = ReactionKind::Force { on: Place { body, point }, against };
        self.along_axes(kind, &slips, (body, holder));
    }

    /// Keeps the torques on a body from its holder that do no work.
    fn torques(&mut self, body: usize, holder: Holder) {
        let turns = self.relative.turns(body, holder);
        self.along_axes(ReactionKind::Torque { on: body, against: holder }, &turns, (body, holder));
    }

    /// Keeps the reactions of a kind along axes that do no work on these velocities, which are along each speed.
    fn along_axes(&mut self, kind: ReactionKind, velocities: &[Triple], (body, holder): (usize, Holder)) {
        for frame in self.relative.frames(body, holder) {
            (0..3).for_each(|axis| self.along_axis(kind, velocities, (frame, axis)));
        }
    }

    /// Keeps a reaction along an axis of a frame, if one is missing and it does no work on these velocities.
    fn along_axis(&mut self, kind: ReactionKind, velocities: &[Triple], (frame, axis): (usize, usize)) {
        if self.missing == 0 {
            return;
        }
        let DrawnModel { space, frames, .. } = &self.relative.drawn;
        let direction = frames[frame].axes[axis];
        let works = velocities.iter().any(|v| space.dot(*v, direction) != 0);
        let action = self.relative.drawn.action(self.relative.model, kind, direction);
        let is_felt = action.iter().zip(&self.felt).any(|(x, felt)| *x != 0 && *felt);
        if !works && is_felt && self.basis.take(action.clone()).is_some() {
            self.keep(Found { kind, along: Along::Axis(frame, axis), is_shared: false }, action);
        }
    }

    /// Keeps a reaction that was taken into the basis.
    fn keep(&mut self, found: Found, action: Vec<u64>) {
        self.feel(&action);
        self.actions.push(action);
        self.found.push(found);
        self.missing -= 1;
    }

    /// Forces along rods without mass: between points of two bodies, or of a body and the ground, that stay as far apart as they are.
    fn lines(&mut self) {
        let count = self.relative.model.points.len();
        for (body, holder) in self.relative.pairs() {
            let is_end = |at: &usize| holder.map_or_else(|| self.relative.stays(*at), |b| self.relative.has(b, *at));
            let ends: Vec<usize> = (0..count).filter(is_end).collect();
            for point in (0..count).filter(|at| self.relative.has(body, *at)).collect::<Vec<_>>() {
                for opposite in &ends {
                    self.line(body, holder, (point, *opposite));
                }
            }
        }
    }

    fn line(&mut self, body: usize, holder: Holder, (point, opposite): (usize, usize)) {
        let DrawnModel { space, points, .. } = &self.relative.drawn;
        let way = space.sub(points[opposite].place, points[point].place);
        if self.missing == 0 || way == [0; 3] {
            return;
        }
        let slips = self.relative.slips(body, holder, (point, opposite));
        if slips.iter().any(|slip| space.dot(*slip, way) != 0) {
            return;
        }
        let against = holder.map(|body| Place { body, point: opposite });
        let kind = ReactionKind::Force { on: Place { body, point }, against };
        let action = self.relative.drawn.action(self.relative.model, kind, way);
        let is_felt = action.iter().zip(&self.felt).any(|(x, felt)| *x != 0 && *felt);
        if is_felt && self.basis.take(action.clone()).is_some() {
            self.keep(Found { kind, along: Along::Line(point, opposite), is_shared: false }, action);
        }
    }

    /// Forces and torques where bodies hang that work, each of them, and hold together what is held along no axis: each brings an unknown,
    /// and as many equations as there are independent ones among their powers along the speeds.
    fn shared(&mut self) {
        let all = self.working();
        let candidates: Vec<_> =
            (0..all.len()).filter(|at| !works_alone(self.relative.drawn.space.0, &all, *at)).collect();
        let mut powers = Basis::new(self.relative.drawn.space.0);
        for at in candidates {
            let (found, power) = &all[at];
            let Along::Axis(frame, axis) = found.along else { continue };
            let direction = self.relative.drawn.frames[frame].axes[axis];
            let action = self.relative.drawn.action(self.relative.model, found.kind, direction);
            let is_felt = action.iter().zip(&self.felt).any(|(x, felt)| *x != 0 && *felt);
            if self.missing > 0 && is_felt && self.basis.take(action.clone()).is_some() {
                self.keep(*found, action);
                self.missing += usize::from(powers.take(power.clone()).is_some());
            }
        }
    }

    /// What may act where bodies hang, along axes of one frame, and works, with its power along each speed.
    fn working(&self) -> Vec<(Found, Vec<u64>)> {
        let mut list = Vec::new();
        for (body, holder) in self.relative.holders() {
            let point = self.relative.least_moving_point(body, holder);
            let against = holder.map(|body| Place { body, point });
            let force = ReactionKind::Force { on: Place { body, point }, against };
            let mut kinds = vec![(force, self.relative.slips(body, holder, (point, point)))];
            if self.relative.is_rigid(Some(body)) && self.relative.is_rigid(holder) {
                let torque = ReactionKind::Torque { on: body, against: holder };
                kinds.push((torque, self.relative.turns(body, holder)));
            }
            let frame = self.relative.frames(body, holder)[0];
            let DrawnModel { space, frames, .. } = &self.relative.drawn;
            for (kind, velocities) in kinds {
                for axis in 0..3 {
                    let direction = frames[frame].axes[axis];
                    let power: Vec<u64> = velocities.iter().map(|v| space.dot(*v, direction)).collect();
                    if power.iter().any(|x| *x != 0) {
                        list.push((Found { kind, along: Along::Axis(frame, axis), is_shared: true }, power));
                    }
                }
            }
        }
        list
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
                // What is shared holds something elsewhere.
                (acting.next().is_none() && !self.found[only - stated].is_shared).then_some(only)
            });
            let Some(zero) = alone else { return };
            self.actions.remove(zero);
            self.found.remove(zero - stated);
        }
    }

    /// Forces where bodies touch at a point, without slip or with it.
    fn contacts(&mut self, holds: bool) {
        for (body, holder) in self.relative.pairs() {
            for point in 0..self.relative.model.points.len() {
                let is_there =
                    |b: usize| self.relative.is_rigid(Some(b)) || self.relative.model.bodies[b].centre == point;
                if is_there(body) && holder.is_none_or(is_there) {
                    self.meeting(body, holder, (point, point), holds);
                }
            }
        }
    }

    /// Forces where a body rolls, along what is said not to slip: other axes, such as those of a gear, come to lie across it.
    fn rolled(&mut self) {
        let model = self.relative.model;
        let components = model.motion_constraints.iter().filter_map(|constraint| match constraint.tie {
            Tie::Rolling(rolled) => Some(rolled),
            _ => None,
        });
        for Rolled { body, against, point, frame, axis, .. } in components {
            let slips = self.relative.slips(body, against, (point, point));
            let on = Place { body, point };
            let kind = ReactionKind::Force { on, against: against.map(|body| Place { body, point }) };
            self.along_axis(kind, &slips, (frame, axis));
        }
    }

    /// Torques that hold bodies from turning against the ground, then against one another.
    fn spins(&mut self) {
        for (body, holder) in self.relative.pairs() {
            if self.missing > 0 && self.relative.is_rigid(Some(body)) && self.relative.is_rigid(holder) {
                self.torques(body, holder);
            }
        }
    }

    /// Forces between points that loops hold together.
    fn loops(&mut self, holds: bool) {
        for (body, holder) in self.relative.pairs() {
            let Some(other) = holder else { continue };
            for point in 0..self.relative.model.points.len() {
                for opposite in 0..self.relative.model.points.len() {
                    if point != opposite && self.relative.has(body, point) && self.relative.has(other, opposite) {
                        self.meeting(body, holder, (point, opposite), holds);
                    }
                }
            }
        }
    }

    /// Forces where two bodies meet, without slip or with it.
    fn meeting(&mut self, body: usize, holder: Holder, points: (usize, usize), holds: bool) {
        if self.missing > 0 && (!holds || self.relative.slips(body, holder, points).iter().all(|slip| *slip == [0; 3]))
        {
            self.forces(body, holder, points);
        }
    }
}

/// Whether the power of one is independent of those of all others: it can be nothing but zero, for no other makes up for it.
fn works_alone(field: Field, all: &[(Found, Vec<u64>)], at: usize) -> bool {
    let mut others = Basis::new(field);
    for (_, power) in all.iter().enumerate().filter(|(other, _)| *other != at).map(|(_, entry)| entry) {
        others.take(power.clone());
    }
    others.take(all[at].1.clone()).is_some()
}
