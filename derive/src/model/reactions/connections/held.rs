//! Reactions that the connections of the file carry, in order.
//!
//! 1. Reactions that the file names, and joints that close loops.
//! 2. Contacts without slip, along the directions that are stated.
//! 3. Joints, and bodies from whose points or in whose frames others are placed.
//! 4. Contacts without slip that follow from how bodies are placed: a wheel presses on the ground, not the car.
//! 5. The ground, under bodies that rest on nothing else; under those last that touch another body.
//! 6. Bodies that the file says to touch: all reactions between them, beside those stated for the contact.

use super::search::{Along, Found, Search};
use crate::algebra::value::field::Field;
use crate::algebra::value::rank::Basis;
use crate::model::reactions::random_pose::Triple;
use crate::model::reactions::relative_motion::{Holder, Relative};
use crate::model::reactions::supports::{Reason, Rest};
use crate::model::{MotionConstraint, Place, ReactionKind, Rolled, Tie};

/// Motions of a mechanism if loops were open and nothing rolled, where these differ from its own motions.
struct Ways {
    /// With the file's other equations between velocities.
    open: Option<Vec<Vec<u64>>>,
    /// Without them.
    free: Option<Vec<Vec<u64>>>,
}

impl Search<'_> {
    /// Chooses the reactions that the connections of the file carry.
    pub fn held(&mut self) {
        let model = self.relative.model;
        let touches = self.relative.touches(&self.relative.freedoms());
        let on_body = |body: usize| touches.iter().any(|(one, other)| *one == body && other.is_some());
        let (mut placed, mut ground, mut touching) = (Vec::new(), Vec::new(), Vec::new());
        for rest in &self.rests {
            match (rest.reason, rest.holder) {
                (Reason::Joint | Reason::Placed | Reason::Least, _) => placed.push(*rest),
                (_, None) => ground.push(*rest),
                (_, Some(_)) => touching.push(*rest),
            }
        }
        ground.sort_by_key(|rest| on_body(rest.body));
        let tied = model.motion_constraints.iter().filter_map(|constraint| match constraint.tie {
            Tie::Rolling(rolled) => Some(rolled),
            _ => None,
        });
        let tied: Vec<Rolled> = tied.collect();
        // What a body rests on presses along the axes of that connection.
        let rests_there =
            |rolled: &Rolled| self.rests.iter().any(|rest| (rest.body, rest.holder) == (rolled.body, rolled.against));
        let built_in = model.repeated.iter().filter_map(|repeated| repeated.rolled);
        let built_in: Vec<Rolled> = built_in.filter(|rolled| !rests_there(rolled)).collect();
        let ways = Ways { open: self.relative.open(true), free: self.relative.open(false) };
        self.rolled(&tied, 0);
        self.connections(&placed, &ways);
        let built_in: Vec<Rolled> = built_in.into_iter().map(|rolled| self.relative.along_own_axis(rolled)).collect();
        self.rolled(&built_in, self.last_place());
        self.connections(&ground, &ways);
        self.connections(&touching, &ways);
    }

    /// Chooses the forces where bodies roll, along the directions without slip. Other axes, such as those of a gear,
    /// come to lie across these directions.
    fn rolled(&mut self, components: &[Rolled], place: usize) {
        for &Rolled { body, against, point, frame, axis, .. } in components {
            let on = Place { body, point };
            let kind = ReactionKind::Force { on, against: against.map(|body| Place { body, point }) };
            let slips = self.relative.slips(body, against, (point, point));
            let direction = self.relative.drawn.frames[frame].axes[axis];
            if slips.iter().all(|slip| self.relative.drawn.space.dot(*slip, direction) == 0) {
                self.choose(place, Found::along_axis(kind, (frame, axis)), direction, Vec::new());
            }
        }
    }

    /// Chooses the reactions between bodies and their holders where they are joined, whatever else ties them.
    fn connections(&mut self, rests: &[Rest], ways: &Ways) {
        self.relative.ways_if_open.clone_from(&ways.open);
        for rest in rests {
            for (kind, velocities) in self.relative.between(rest.body, rest.holder) {
                self.along_axes(kind, &velocities, rest);
            }
        }
        for rest in rests {
            self.together(rest.body, rest.holder, ways);
        }
        self.relative.ways_if_open = None;
    }

    /// Chooses reactions along axes of frames that do no work by themselves: as many as are independent.
    fn along_axes(&mut self, kind: ReactionKind, velocities: &[Triple], rest: &Rest) {
        let field = self.relative.drawn.space.0;
        let mut open = 3 - rank(field, velocities.iter().map(|velocity| velocity.to_vec()));
        let mut own = Basis::new(field);
        for (frame, axis) in self.relative.axes_between(rest.body, rest.holder) {
            if open == 0 {
                return;
            }
            let direction = self.relative.drawn.frames[frame].axes[axis];
            let works = velocities.iter().any(|v| self.relative.drawn.space.dot(*v, direction) != 0);
            if works || own.take(direction.to_vec()).is_none() {
                continue;
            }
            open -= 1;
            let found = Found::along_axis(kind, (frame, axis));
            self.choose(self.place_of(rest.body), found, direction, Vec::new());
        }
    }

    /// Chooses the forces and torques of a connection that do no work together only, as those of a screw.
    fn together(&mut self, body: usize, holder: Holder, ways: &Ways) {
        let field = self.relative.drawn.space.0;
        self.relative.ways_if_open.clone_from(&ways.free);
        let (working, kinds) = (self.relative.working(body, holder), self.relative.between(body, holder));
        self.relative.ways_if_open = None;
        let alone: usize = kinds.iter().map(|(_, v)| 3 - rank(field, v.iter().map(|v| v.to_vec()))).sum();
        let twist = |way: usize| kinds.iter().flat_map(|(_, velocities)| velocities[way]).collect::<Vec<u64>>();
        let all = 3 * kinds.len() - rank(field, (0..kinds[0].1.len()).map(twist));
        if all <= alone {
            return;
        }
        let in_motion = self.relative.working(body, holder);
        let powers: Vec<Vec<u64>> = working.iter().map(|(_, power)| power.clone()).collect();
        for (found, power) in in_motion {
            let Some(at) = working.iter().position(|(other, _)| other.is_same(&found)) else { continue };
            if !works_alone(field, &powers, at) {
                let (Some(direction), place) = (self.relative.direction(&found), self.place_of(body)) else { continue };
                self.choose(place, found, direction, power);
            }
        }
    }
}

impl Relative<'_> {
    /// Motions of the mechanism if loops were open and nothing rolled. Equations of the file between velocities hold if
    /// `are_held`. `None` if these are its own motions.
    fn open(&self, are_held: bool) -> Option<Vec<Vec<u64>>> {
        let model = self.model;
        let holds = |constraint: &MotionConstraint| match constraint.tie {
            Tie::Loop(at) => model.loops[at].prescribes,
            Tie::Clock => true,
            Tie::Rolling(_) => false,
            Tie::Stated => are_held,
        };
        let is_open = !model.motion_constraints.iter().all(holds);
        is_open.then(|| self.open_ways(&mut model.arena.clone(), &holds)).flatten()
    }

    /// The component along the first axis of the bodies' own frames that has its direction, if one has.
    fn along_own_axis(&self, rolled: Rolled) -> Rolled {
        let direction = |frame: usize, axis: usize| self.drawn.frames[frame].axes[axis];
        let wanted = direction(rolled.frame, rolled.axis);
        let mut axes = self.axes_between(rolled.body, rolled.against).into_iter();
        let same = axes.find(|(frame, axis)| direction(*frame, *axis) == wanted);
        same.map_or(rolled, |(frame, axis)| Rolled { frame, axis, ..rolled })
    }

    /// Force and torque between a body and its holder where they move least, each with the velocities at which it does
    /// work.
    pub fn between(&self, body: usize, holder: Holder) -> Vec<(ReactionKind, Vec<Triple>)> {
        let point = self.least_moving_point(body, holder);
        let against = holder.map(|body| Place { body, point });
        let force = ReactionKind::Force { on: Place { body, point }, against };
        let mut kinds = vec![(force, self.slips(body, holder, (point, point)))];
        if self.is_rigid(Some(body)) && self.is_rigid(holder) {
            kinds.push((ReactionKind::Torque { on: body, against: holder }, self.turns(body, holder)));
        }
        kinds
    }

    /// Those of them that work, along axes of one frame, with the power of each along every way to move.
    pub fn working(&self, body: usize, holder: Holder) -> Vec<(Found, Vec<u64>)> {
        let frame = self.frames(body, holder)[0];
        let mut list = Vec::new();
        for (kind, velocities) in self.between(body, holder) {
            for axis in 0..3 {
                let direction = self.drawn.frames[frame].axes[axis];
                let power: Vec<u64> = velocities.iter().map(|v| self.drawn.space.dot(*v, direction)).collect();
                if power.iter().any(|x| *x != 0) {
                    list.push((Found { is_shared: true, ..Found::along_axis(kind, (frame, axis)) }, power));
                }
            }
        }
        list
    }

    /// The direction of a reaction along an axis of a frame.
    pub fn direction(&self, found: &Found) -> Option<Triple> {
        match found.along {
            Along::Axis(frame, axis) => Some(self.drawn.frames[frame].axes[axis]),
            Along::Line(..) => None,
        }
    }

    /// The axes of frames along which a body and its holder may act on one another, those of their own frames first.
    pub fn axes_between(&self, body: usize, holder: Holder) -> Vec<(usize, usize)> {
        let frames = self.frames(body, holder).into_iter();
        frames.flat_map(|frame| (0..3).map(move |axis| (frame, axis))).collect()
    }
}

/// Number of independent rows.
fn rank(field: Field, rows: impl Iterator<Item = Vec<u64>>) -> usize {
    let mut basis = Basis::new(field);
    rows.for_each(|row| {
        basis.take(row);
    });
    basis.len()
}

/// True if the power of one reaction is independent of the powers of all others. It can then only be zero, since no
/// other balances it.
pub fn works_alone(field: Field, powers: &[Vec<u64>], at: usize) -> bool {
    let mut others = Basis::new(field);
    for (_, power) in powers.iter().enumerate().filter(|(other, _)| *other != at) {
        others.take(power.clone());
    }
    others.take(powers[at].clone()).is_some()
}
