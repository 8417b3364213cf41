//! Supports: the body, or the ground, on which each body rests, as the model file states it.
//!
//! A joint states its support. Otherwise a body rests where it moves least. If it moves equally little against
//! several bodies, it rests first on a body that the file says it touches. Next comes a body from whose points or in
//! whose frames it is placed, then the ground. Two bodies touch if one rolls on the other, a reaction or friction
//! acts between them, or one constraint compares their motions.
//!
//! A statement has a direction. A body that rolls, or on which (key `on`) a reaction or friction acts, rests on the
//! body under the key `against`. An equation has no direction. Of two bodies that it compares, the body further from
//! the ground rests on the other; the distance is counted in such equations. An equation that relates two bodies
//! without comparing them, such as a rope over a pulley, does not make them touch.

use super::relative_motion::{BodyPair, Holder, RelativeMotion, reaction_pair};
use crate::algebra::text::parse::VelocityOf;
use crate::model::{ComparedBodies, MotionConstraintKind, Placement, SlipComponent};
use std::cmp::{Ordering, Reverse};

/// Reason for a body's support, from the strongest reason to the weakest.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum SupportReason {
    /// A joint of the model file places the body on the supporting body or the ground.
    Joint,
    /// The model file states a contact of the two bodies.
    Touch,
    /// The body is placed from a point of the supporting body, or in the supporting body's frame.
    Placed,
    /// The body rests on the ground, from which all positions are measured.
    Ground,
    /// The body moves least against the supporting body, and the model file states nothing between the two.
    Least,
}

/// Body with its support, which is another body or the ground, and the reason for it.
#[derive(Clone, Copy, Debug)]
pub struct Support {
    /// Index of the supported body.
    pub body: usize,
    /// Index of the body on which the supported body rests; `None` for the ground.
    pub holder: Holder,
    /// Reason why the body rests on this support.
    pub reason: SupportReason,
}

impl Support {
    /// The body and its support as a pair.
    pub fn pair(&self) -> BodyPair {
        BodyPair { body: self.body, against: self.holder }
    }
}

impl RelativeMotion<'_> {
    /// Finds the support of each body. The outermost bodies come first: a body comes after all bodies that rest on
    /// it.
    pub fn supports(&self) -> Vec<Support> {
        let count = self.model.bodies.len();
        let free = self.degrees_of_freedom();
        let touches = self.touching_supports(&free);
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|body| (free[*body], *body));
        let mut found: Vec<Support> = Vec::with_capacity(count);
        for body in &order {
            found.push(self.support(*body, &free, &touches, &found));
        }
        found.sort_by_key(|support| Reverse((free[support.body], support.body)));
        let mut list = Vec::with_capacity(count);
        while !found.is_empty() {
            // The next body is one on which no remaining body rests.
            let is_free = |support: &Support| found.iter().all(|other| other.holder != Some(support.body));
            let next = found.iter().position(is_free).unwrap_or(0);
            list.push(found.remove(next));
        }
        list
    }

    /// Each body with the body or ground on which it rests, in the order of [`Self::supports`].
    pub fn supported_pairs(&self) -> Vec<BodyPair> {
        self.supports().iter().map(Support::pair).collect()
    }

    /// Finds the support of a body. `free` are the degrees of freedom of all bodies, `touches` the pairs that touch,
    /// and `found` the supports found so far.
    fn support(&self, body: usize, free: &[usize], touches: &[BodyPair], found: &[Support]) -> Support {
        if let Some(carried) = self.model.carried.iter().find(|carried| carried.body == body) {
            return Support { body, holder: carried.on, reason: SupportReason::Joint };
        }
        let reason = |holder: Holder| {
            let touch = |body: usize, against: Holder| touches.contains(&BodyPair { body, against });
            let is_stated = touch(body, holder);
            let is_behind = |other: usize| free[other] < free[body] && touch(other, Some(body));
            match holder {
                _ if is_stated => SupportReason::Touch,
                Some(other) if is_behind(other) => SupportReason::Touch,
                Some(other) if self.is_placed_on(body, other) => SupportReason::Placed,
                Some(_) => SupportReason::Least,
                None => SupportReason::Ground,
            }
        };
        let candidates = (0..free.len()).filter(|other| *other != body && !rests_on(found, *other, body));
        let supports = std::iter::once(None).chain(candidates.map(Some)).map(|holder| (holder, reason(holder)));
        // A body with more freedom may rest on this body, not vice versa. A body with equal freedom is a support only
        // if the file says so.
        let supports = supports.filter(|(holder, reason)| {
            holder.is_none_or(|other| {
                let is_before = (free[other], other) < (free[body], body);
                is_before || *reason < SupportReason::Ground && free[other] <= free[body]
            })
        });
        let least = supports.min_by_key(|(holder, reason)| {
            (self.freedom(body, *holder), *reason, holder.map_or(0, |other| free[other]))
        });
        let (holder, reason) = least.unwrap_or((None, SupportReason::Ground));
        Support { body, holder, reason }
    }

    /// Number of degrees of freedom of each body relative to the ground.
    pub fn degrees_of_freedom(&self) -> Vec<usize> {
        (0..self.model.bodies.len()).map(|body| self.freedom(body, None)).collect()
    }

    /// Pairs of bodies that the model file states to touch: a body, and the body or ground on which it
    /// rests. `free` are the degrees of freedom of all bodies.
    pub fn touching_supports(&self, free: &[usize]) -> Vec<BodyPair> {
        let model = self.model;
        let rolled = model.motion_constraints.iter().filter_map(|constraint| match constraint.kind {
            MotionConstraintKind::Rolling(rolled) => Some(rolled),
            _ => None,
        });
        let rolled = rolled.chain(model.repeated.iter().filter_map(|repeated| repeated.rolled));
        let mut list: Vec<BodyPair> =
            rolled.map(|SlipComponent { body, against, .. }| BodyPair { body, against }).collect();
        list.extend(model.stated_reactions().iter().map(|reaction| reaction_pair(reaction.kind)));
        // Friction against the ground may be air resistance, which is no contact.
        let rubbing = model.contacts.rubbing.iter().filter(|(_, against)| against.is_some());
        list.extend(rubbing.map(|(body, against)| BodyPair { body: *body, against: *against }));
        list.extend(self.supports_by_comparison(free, &list));
        list
    }

    /// Pairs of bodies that a constraint compares, as (body, its support). `stated` are the pairs that touch for
    /// other reasons.
    fn supports_by_comparison(&self, free: &[usize], stated: &[BodyPair]) -> Vec<BodyPair> {
        let constraints = &self.model.contacts.compared;
        let tied: Vec<(Vec<usize>, bool)> =
            constraints.iter().map(|compared| (self.support_candidates(compared), compared.is_difference)).collect();
        let compared = tied.iter().filter(|(_, is_difference)| *is_difference);
        let pairs: Vec<[usize; 2]> = compared.filter_map(|(bodies, _)| bodies.as_slice().try_into().ok()).collect();
        // Bodies that another constraint or contact holds. A constraint or contact with the body with which they are
        // compared does not count.
        let is_pair = |one: usize, other: usize| pairs.iter().any(|pair| pair.contains(&one) && pair.contains(&other));
        let is_apart =
            |body: usize| (0..free.len()).all(|other| !is_pair(body, other) || !self.is_placed_on(body, other));
        let alone = tied.iter().filter_map(|(bodies, _)| <[usize; 1]>::try_from(bodies.as_slice()).ok()).flatten();
        let mut held: Vec<usize> = alone.filter(|body| is_apart(*body)).collect();
        let touches = stated.iter().filter(|pair| !pair.against.is_some_and(|other| is_pair(pair.body, other)));
        held.extend(touches.map(|pair| pair.body));
        let steps = self.support_distances(free, &pairs, &held);
        let supports = |[one, other]: [usize; 2]| match (free[one], steps[one]).cmp(&(free[other], steps[other])) {
            Ordering::Greater => Some(BodyPair { body: one, against: Some(other) }),
            Ordering::Less => Some(BodyPair { body: other, against: Some(one) }),
            Ordering::Equal => None,
        };
        pairs.into_iter().filter_map(supports).collect()
    }

    /// Number of `pairs` between each body and the nearest body that is `held` or that no constraint moves. `None`
    /// for a body in no pair.
    ///
    /// In a group of bodies without such a nearest body, the first body with the least freedom counts as held.
    fn support_distances(&self, free: &[usize], pairs: &[[usize; 2]], held: &[usize]) -> Vec<Option<usize>> {
        let is_moved = |body: usize| self.model.contacts.compared.iter().any(|compared| compared.moved.contains(&body));
        let mut steps = vec![None; free.len()];
        let mut left: Vec<usize> = pairs.as_flattened().to_vec();
        left.sort_by_key(|body| (free[*body], *body));
        left.dedup();
        for body in left.extract_if(.., |body| held.contains(body) || !is_moved(*body)) {
            steps[body] = Some(0);
        }
        while !left.is_empty() {
            let from = |body: usize| pairs.iter().filter(move |pair| pair.contains(&body)).flatten();
            let near = |body: &usize| from(*body).filter_map(|other| steps[*other]).min();
            let nearest = (0..left.len()).filter_map(|at| Some((near(&left[at])? + 1, at))).min();
            let (step, at) = nearest.unwrap_or((0, 0));
            steps[left.remove(at)] = Some(step);
        }
        steps
    }

    /// Bodies whose velocities or positions a constraint names. Bodies whose own coordinates the constraint contains
    /// are added if it names none, or if it compares bodies.
    fn support_candidates(&self, compared: &ComparedBodies) -> Vec<usize> {
        let named = compared.named.iter().filter_map(|of| match of {
            VelocityOf::Material(body, _) => Some(*body),
            VelocityOf::Point(point) | VelocityOf::Place(point) => self.body_of_point(*point),
            VelocityOf::Turning(_) => None,
        });
        let mut bodies: Vec<usize> = Vec::new();
        let own = compared.own.iter().filter(|_| compared.named.is_empty() || compared.is_difference);
        for body in named.chain(own.copied()) {
            if !bodies.contains(&body) {
                bodies.push(body);
            }
        }
        bodies
    }

    /// Index of the only body to which a point belongs, as its mass centre or else in its material. `None` if there
    /// is no such body or more than one.
    pub fn body_of_point(&self, point: usize) -> Option<usize> {
        let bodies = &self.model.bodies;
        if let Some(body) = bodies.iter().position(|body| body.centre == point) {
            return Some(body);
        }
        let mut owners = (0..bodies.len()).filter(|body| self.has_material_point(*body, point));
        owners.next().filter(|_| owners.next().is_none())
    }

    /// True if a body is placed from a point of another body, or in the other body's frame.
    fn is_placed_on(&self, body: usize, other: usize) -> bool {
        let model = self.model;
        let frame_of = |body: usize| model.bodies[body].rigid.as_ref().map(|(frame, _)| *frame);
        let own = frame_of(body);
        let mut frames: Vec<usize> = own.into_iter().collect();
        let mut at = model.bodies[body].centre;
        while let Some(Placement { parent, frame, .. }) = model.points[at].position {
            frames.push(frame);
            if parent != 0 && !self.has_material_point(body, parent) {
                if self.has_material_point(other, parent) {
                    return true;
                }
                // If a third body is in between, that body is placed on the other body.
                if (0..model.bodies.len()).any(|third| self.has_material_point(third, parent)) {
                    break;
                }
            }
            at = parent;
        }
        // The inertial frame belongs to no body, even if a body that does not rotate uses it.
        let Some(wanted) = frame_of(other).filter(|frame| *frame != 0 && Some(*frame) != own) else { return false };
        frames.into_iter().any(|mut frame| {
            while frame != wanted {
                let Some((parent, _)) = &model.frames[frame].rotation else { return false };
                frame = *parent;
            }
            true
        })
    }
}

/// True if a body rests on another body, directly or through further bodies.
fn rests_on(found: &[Support], body: usize, other: usize) -> bool {
    let mut at = Some(body);
    while let Some(next) = at {
        if next == other {
            return true;
        }
        at = found.iter().find(|support| support.body == next).and_then(|support| support.holder);
    }
    false
}
