//! Vectors that are expressed in another frame one rotation at a time, with a name for each component.
//!
//! Products of rotations grow with every frame between two bodies. Here a vector is rotated once for each frame, and
//! vectors that it meets on the way are added. For example, the angular velocity of a frame is that of its parent,
//! rotated once, plus its own. So velocities become recursions along the tree without being written as recursions.
//!
//! Source: J. Y. S. Luh, M. W. Walker & R. P. C. Paul, "On-line computational scheme for mechanical manipulators",
//! ASME J. Dyn. Sys. Meas. Control 102 (1980) 69–76. [`EquationForm`](crate::mechanics::EquationForm) decides
//! which models are derived in this way.

use super::{Components, Frames, Turn, TurnSense, Vector};
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};

impl Frames {
    /// Index of the frame in which the given vectors have short components. It is the deepest frame of their parts,
    /// if all other frames of their parts are its ancestors. Otherwise it is the frame where the paths to the ground
    /// meet.
    #[must_use]
    pub fn common_transport_frame<'a>(&self, vectors: impl IntoIterator<Item = &'a Vector>) -> usize {
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

    /// Expresses a vector in one frame, and returns its components with names. The farthest part moves first, one
    /// rotation at a time, and is added to the parts that it meets.
    ///
    /// A final name consists of the letter and the owner, such as `w_B_1`. An intermediate name also contains the
    /// frame of origin, such as `w_A_in_B_1`.
    pub fn express_frame_by_frame(
        &self,
        arena: &mut Arena,
        v: &Vector,
        frame: usize,
        letter: &str,
        of: &str,
    ) -> Components {
        let path = self.ancestors(frame);
        let what = &format!("{letter}_{of}");
        let mut parts: BTreeMap<usize, Components> = v.parts.iter().copied().collect();
        let place: FxHashMap<usize, usize> = path.iter().enumerate().map(|(at, frame)| (*frame, at)).collect();
        // Number of steps up to the path and then down the path.
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
        // Among parts that are equally far, the part of the first declared frame moves first. So sums over bodies
        // share their first terms.
        let farthest = |parts: &BTreeMap<usize, Components>| {
            let elsewhere = parts.keys().copied().filter(|from| *from != frame);
            elsewhere.max_by_key(|from| (distance(*from), std::cmp::Reverse(*from)))
        };
        while let Some(from) = farthest(&parts) {
            let Some(components) = parts.remove(&from) else { break };
            // The part moves down if the target frame lies below it, otherwise up.
            let (next, way) = match (place.get(&from), self.parent(from)) {
                (None, Some(parent)) => (parent, self.turn_from_parent(from).map(|turn| (turn, TurnSense::Back))),
                (at, _) => {
                    let next = path[at.map_or(0, |at| at - 1)];
                    (next, self.turn_from_parent(next).map(|turn| (turn, TurnSense::Forward)))
                }
            };
            let carried = way.map_or(components, |(turn, sense)| {
                let called = format!("{letter}_{}_in_{}", self.name(from), self.name(next));
                rotate_and_name_components(arena, turn, sense, &components, &called)
            });
            let sum = match parts.get(&next) {
                Some(there) => {
                    let sum = std::array::from_fn(|i| arena.add(there[i], carried[i]));
                    name_transported_components(arena, sum, what)
                }
                None => carried,
            };
            parts.insert(next, sum);
        }
        parts.remove(&frame).map_or([Expr::ZERO; 3], |components| name_transported_components(arena, components, what))
    }
}

/// Gives each of three components a name with a number at the end: `w_B_1`, `w_B_2`, `w_B_3` for `what` = `w_B`.
pub fn name_transported_components(arena: &mut Arena, components: Components, what: &str) -> Components {
    let mut at = 0;
    components.map(|e| {
        at += 1;
        arena.name(e, &format!("{what}_{at}"))
    })
}

/// Rotates the components of a vector through `turn`, forwards or back, and names the results.
pub fn rotate_and_name_components(
    arena: &mut Arena,
    turn: &Turn,
    sense: TurnSense,
    v: &Components,
    what: &str,
) -> Components {
    let result = turn.apply(arena, v, sense);
    name_transported_components(arena, result, what)
}
