//! Vectors that are carried from frame to frame, one turn at a time, with a name for each component.
//!
//! Products of rotations grow with every frame between two bodies. A carried vector is turned once per frame and takes
//! up the vectors that it meets. The angular velocity of a frame is that of its parent, turned once, plus its own. So
//! velocities become recursions along the tree without being written as such (J. Y. S. Luh, M. W. Walker & R. P. C.
//! Paul, "On-line computational scheme for mechanical manipulators", ASME J. Dyn. Sys. Meas. Control 102 (1980) 69–76).
//! [`Form`](super::form::Form) decides which models are derived with carried vectors.

use crate::algebra::{Arena, Expr};
use crate::geometry::{Components, Frames, Turn, TurnSense, Vector};
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};

impl Frames {
    /// Frame in which vectors have short components: the deepest frame of their parts if all others lie above it, else
    /// the frame where the paths to the ground meet.
    #[must_use]
    pub fn home<'a>(&self, vectors: impl IntoIterator<Item = &'a Vector>) -> usize {
        let frames: BTreeSet<usize> =
            vectors.into_iter().flat_map(|v| v.parts.iter().map(|(frame, _)| *frame)).collect();
        let deepest = frames.iter().copied().max_by_key(|frame| self.ancestors(*frame).len());
        let mut meeting = self.ancestors(deepest.unwrap_or(0));
        if frames.iter().all(|frame| meeting.contains(frame)) {
            return deepest.unwrap_or(0);
        }
        for frame in frames {
            let path = self.ancestors(frame);
            meeting.retain(|above| path.contains(above));
        }
        meeting[0]
    }

    /// Carries all parts of a vector into one frame, the farthest part first, and returns the components there. A part
    /// on its way takes up the parts that it meets. Components are named after the letter and the owner, `w_B_1`; on
    /// the way they are named after the frame that they come from, `w_A_in_B_1`.
    pub fn carry(&self, arena: &mut Arena, v: &Vector, frame: usize, letter: &str, of: &str) -> Components {
        let path = self.ancestors(frame);
        let what = &format!("{letter}_{of}");
        let mut parts: BTreeMap<usize, Components> = v.parts.iter().copied().collect();
        let place: FxHashMap<usize, usize> = path.iter().enumerate().map(|(at, frame)| (*frame, at)).collect();
        // Steps up to the path, then down the path.
        let distance = |mut from: usize| {
            let mut steps = 0;
            loop {
                match (place.get(&from), self.parent(from)) {
                    (Some(at), _) => return steps + at,
                    (None, Some(parent)) => (from, steps) = (parent, steps + 1),
                    (None, None) => return steps,
                }
            }
        };
        let way_from: FxHashMap<usize, usize> = parts.keys().map(|from| (*from, distance(*from))).collect();
        let distance = |from: usize| way_from.get(&from).copied().unwrap_or_else(|| distance(from));
        // Among parts equally far, the first declared goes first, so that sums over bodies share their beginnings.
        let farthest = |parts: &BTreeMap<usize, Components>| {
            let elsewhere = parts.keys().copied().filter(|from| *from != frame);
            elsewhere.max_by_key(|from| (distance(*from), std::cmp::Reverse(*from)))
        };
        while let Some(from) = farthest(&parts) {
            let Some(components) = parts.remove(&from) else { break };
            // Down towards the target frame if it lies below, else up.
            let (next, way) = match (place.get(&from), self.parent(from)) {
                (None, Some(parent)) => (parent, self.turned_into(from).map(|turn| (turn, TurnSense::Back))),
                (at, _) => {
                    let next = path[at.map_or(0, |at| at - 1)];
                    (next, self.turned_into(next).map(|turn| (turn, TurnSense::Forward)))
                }
            };
            let carried = way.map_or(components, |(turn, sense)| {
                let called = format!("{letter}_{}_in_{}", self.name(from), self.name(next));
                turned(arena, turn, sense, &components, &called)
            });
            let sum = match parts.get(&next) {
                Some(there) => {
                    let sum = std::array::from_fn(|i| arena.add(there[i], carried[i]));
                    named(arena, sum, what)
                }
                None => carried,
            };
            parts.insert(next, sum);
        }
        parts.remove(&frame).map_or([Expr::ZERO; 3], |components| named(arena, components, what))
    }
}

/// Names three components after their owner: `w_B_1`, `w_B_2`, `w_B_3`.
pub fn named(arena: &mut Arena, components: Components, what: &str) -> Components {
    let mut at = 0;
    components.map(|e| {
        at += 1;
        arena.name(e, &format!("{what}_{at}"))
    })
}

/// Components of a vector in the frame to which a turn leads, each with a name.
pub fn turned(arena: &mut Arena, turn: &Turn, sense: TurnSense, v: &Components, what: &str) -> Components {
    let result = turn.apply(arena, v, sense);
    named(arena, result, what)
}
