//! Search for reactions in one random pose: the reactions chosen, the balances in which bodies feel them, and the
//! number of reactions still missing.

use crate::algebra::value::rank::Basis;
use crate::algebra::{Arena, Expr};
use crate::model::reactions::random_pose::{DrawnModel, Triple};
use crate::model::reactions::relative_motion::{Relative, sides};
use crate::model::reactions::supports::{Reason, Support};
use crate::model::{Model, ReactionKind};

/// Direction along which a reaction acts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ReactionDirection {
    /// Direction along an axis, 0, 1 or 2, of a frame: frame, axis.
    Axis(usize, usize),
    /// Direction from one point to another: indices of the points.
    Line(usize, usize),
}

/// A reaction that was found, before it has a name.
#[derive(Clone, Copy)]
pub struct FoundReaction {
    pub kind: ReactionKind,
    pub along: ReactionDirection,
    pub is_shared: bool,
    /// Body whose connection to its holder has a law of its own, as in [`crate::model::Reaction::law`].
    pub law: Option<usize>,
}

impl FoundReaction {
    /// A reaction along an axis of a frame that does no work by itself.
    pub fn along_axis(kind: ReactionKind, frame: usize, axis: usize) -> Self {
        Self { kind, along: ReactionDirection::Axis(frame, axis), is_shared: false, law: None }
    }

    /// True if both reactions are the same component between the same bodies.
    pub fn is_same(&self, other: &Self) -> bool {
        self.kind == other.kind && self.along == other.along
    }
}

/// A reaction that was chosen: one that the model file names, or one that was found.
struct Chosen {
    /// Contribution of the reaction to all balances.
    action: Vec<u64>,
    /// Power of the reaction along each speed, then along each coordinate for each body: it is zero unless the body's
    /// connection has a law that the reaction obeys. Empty if the reaction does no work by itself.
    power: Vec<u64>,
    /// Reaction that was found, after its place in the list of reactions; `None` for one that the model file names.
    found: Option<(usize, FoundReaction)>,
    /// True if bodies feel the reaction: it acts in a balance that is not 0 = 0.
    is_felt: bool,
}

/// State of the search for reactions in one random pose.
pub struct Search<'m> {
    pub relative: Relative<'m>,
    /// Each body with its holder, outermost bodies first.
    pub supports: Vec<Support>,
    /// Number of reactions that are still missing.
    pub missing: usize,
    /// True for each balance that is not 0 = 0 without reactions: six for each body. `felt` is true for each balance
    /// that is not 0 = 0 with the chosen reactions.
    moved: Vec<bool>,
    felt: Vec<bool>,
    chosen: Vec<Chosen>,
    /// Basis of the contributions of the chosen reactions to all balances and to the laws of connections.
    basis: Basis,
}

impl<'m> Search<'m> {
    /// Starts the search from the stated reactions; `None` if no reaction is missing, or the stated reactions are not
    /// independent.
    pub fn new(model: &'m Model) -> Option<Self> {
        let arena = &mut model.arena.clone();
        let drawn = DrawnModel::new(model, arena)?;
        let (basis, chosen) = (Basis::new(drawn.space.0), Vec::new());
        let moved: Vec<bool> = drawn.balances(model, arena)?.iter().map(|x| *x != 0).collect();
        let relative = Relative { model, drawn, ways_if_open: None };
        let supports = relative.supports();
        let mut search = Self { felt: moved.clone(), moved, relative, supports, basis, chosen, missing: 0 };
        let stated = search.stated(arena)?;
        for action in stated {
            search.basis.take(search.column(&action, &[]))?;
            search.chosen.push(Chosen { action, power: Vec::new(), found: None, is_felt: true });
        }
        search.feel();
        (search.missing > 0).then_some(search)
    }

    /// Contributions of the stated reactions to the balances of all bodies.
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

    /// Contribution of a reaction of size 1 in this direction to all balances.
    fn action(&self, kind: ReactionKind, direction: Triple) -> Vec<u64> {
        self.relative.drawn.action(self.relative.model, kind, direction)
    }

    /// Place of a body's reactions in the list of reactions: outermost bodies come first.
    pub fn place_of(&self, body: usize) -> usize {
        1 + self.supports.iter().position(|support| support.body == body).unwrap_or(self.supports.len())
    }

    /// Place in the list of reactions after those of all bodies.
    pub fn last_place(&self) -> usize {
        2 + self.supports.len()
    }

    /// True if reactions are missing, and a reaction in this direction acts in a balance that bodies feel.
    pub fn is_wanted(&self, kind: ReactionKind, direction: Triple) -> bool {
        self.missing > 0 && self.action(kind, direction).iter().zip(&self.felt).any(|(x, felt)| *x != 0 && *felt)
    }

    /// Chooses a reaction in this direction, at this place of the list, unless the reactions already chosen carry the
    /// same load. Returns true if it is chosen.
    pub fn choose(&mut self, place: usize, found: FoundReaction, direction: Triple, mut power: Vec<u64>) -> bool {
        if !power.is_empty() {
            let model = self.relative.model;
            power.resize(model.speeds.len() + model.bodies.len() * model.coordinates.len(), 0);
        }
        let action = self.action(found.kind, direction);
        let is_new = self.basis.take(self.column(&action, &power)).is_some();
        if is_new {
            self.chosen.push(Chosen { action, power, found: Some((place, found)), is_felt: false });
            self.feel();
        }
        is_new
    }

    /// Column of a reaction in the balances of all bodies and in the laws of connections.
    fn column(&self, action: &[u64], power: &[u64]) -> Vec<u64> {
        let model = self.relative.model;
        let mut column = action.to_vec();
        column.extend(power.iter().skip(model.speeds.len()));
        column.resize(action.len() + model.bodies.len() * model.coordinates.len(), 0);
        column
    }

    /// Marks the chosen reactions that bodies feel, and counts the missing ones: each equation needs an unknown.
    fn feel(&mut self) {
        while let Some(at) = self.chosen.iter().position(|chosen| !chosen.is_felt && self.acts(chosen)) {
            self.chosen[at].is_felt = true;
        }
        let mut felt = self.moved.clone();
        for chosen in self.chosen.iter().filter(|chosen| chosen.is_felt) {
            felt.iter_mut().zip(&chosen.action).for_each(|(felt, x)| *felt |= *x != 0);
        }
        self.felt = felt;
        let mut powers = Basis::new(self.relative.drawn.space.0);
        let mut unknowns = self.relative.model.speeds.len();
        for chosen in self.chosen.iter().filter(|chosen| chosen.is_felt) {
            unknowns += 1;
            if !chosen.power.is_empty() {
                powers.take(chosen.power.clone());
            }
        }
        let equations = self.felt.iter().filter(|felt| **felt).count() + powers.len();
        self.missing = equations.saturating_sub(unknowns);
    }

    /// True if a reaction acts in a balance that bodies feel, or shares its power with a reaction that bodies feel.
    fn acts(&self, one: &Chosen) -> bool {
        let meets = |a: &[u64], b: &[u64]| a.iter().zip(b).any(|(x, y)| *x != 0 && *y != 0);
        let felt = self.chosen.iter().filter(|chosen| chosen.is_felt);
        one.action.iter().zip(&self.moved).any(|(x, moved)| *x != 0 && *moved)
            || felt.into_iter().any(|other| meets(&one.action, &other.action) || meets(&one.power, &other.power))
    }

    /// Reactions that were found and that bodies feel, in the order of their places. Also the bodies on which the
    /// ground, or the body they touch, exerts only the forces that the model file names.
    pub fn results(mut self) -> (Vec<FoundReaction>, Vec<usize>) {
        self.chosen.retain(|chosen| chosen.is_felt);
        self.leave_out_zeros();
        let mut found: Vec<(usize, FoundReaction)> = self.chosen.iter().filter_map(|chosen| chosen.found).collect();
        found.sort_by_key(|(place, _)| *place);
        let found: Vec<FoundReaction> = found.into_iter().map(|(_, found)| found).collect();
        let carries = |support: &Support| found.iter().any(|found| sides(found.kind) == support.pair());
        let is_open =
            |support: &&Support| matches!(support.reason, Reason::Ground | Reason::Touch) && !carries(support);
        let idle = self.supports.iter().filter(is_open).map(|support| support.body).collect();
        (found, idle)
    }

    /// Leaves out reactions that are 0, since each is alone in a balance in which nothing moves and no load acts.
    fn leave_out_zeros(&mut self) {
        while let Some(zero) = (0..self.moved.len()).filter(|row| !self.moved[*row]).find_map(|row| {
            let mut acting = (0..self.chosen.len()).filter(|at| self.chosen[*at].action[row] != 0);
            let only = acting.next()?;
            let chosen = &self.chosen[only];
            // A shared reaction holds a direction elsewhere.
            (acting.next().is_none() && chosen.found.is_some_and(|(_, found)| !found.is_shared)).then_some(only)
        }) {
            self.chosen.remove(zero);
        }
    }
}
