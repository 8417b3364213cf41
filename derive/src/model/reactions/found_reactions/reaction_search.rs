//! Search for reactions in one random pose. It keeps the chosen reactions, the Newton–Euler equations in which they
//! act, and the number of missing reactions.

use crate::algebra::value::rank::Basis;
use crate::algebra::{Arena, Expr};
use crate::model::reactions::random_pose::{RandomModel, VectorResidues};
use crate::model::reactions::relative_motion::{RelativeMotion, reaction_pair};
use crate::model::reactions::supports::{Support, SupportReason};
use crate::model::{Model, ReactionKind};

/// Direction along which a found reaction acts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ReactionDirection {
    /// Direction of an axis of a frame: (frame, axis 0, 1 or 2).
    Axis(usize, usize),
    /// Direction from one point to another: (first point, second point).
    Line(usize, usize),
}

/// Reaction that was found automatically, before it has a name.
#[derive(Clone, Copy)]
pub struct FoundReaction {
    /// Places or bodies on which the reaction and its opposite act.
    pub kind: ReactionKind,
    /// Direction of the reaction.
    pub along: ReactionDirection,
    /// True if the reaction does work that other reactions balance (`crate::model::Reaction::is_shared`).
    pub is_shared: bool,
    /// Index of the body whose connection has its own law that the reaction obeys ([`crate::model::Reaction::law`]).
    /// `None` if there is no such law.
    pub law: Option<usize>,
}

impl FoundReaction {
    /// Creates a reaction along an axis, 0 to 2, of a frame. The reaction does no work by itself.
    pub fn along_axis(kind: ReactionKind, frame: usize, axis: usize) -> Self {
        Self { kind, along: ReactionDirection::Axis(frame, axis), is_shared: false, law: None }
    }

    /// True if both reactions are the same force or torque between the same bodies, along the same direction.
    pub fn is_same(&self, other: &Self) -> bool {
        self.kind == other.kind && self.along == other.along
    }
}

/// A chosen reaction: stated in the model file, or found automatically.
struct ChosenReaction {
    /// Contribution of the reaction, with size 1, to the Newton–Euler equations: six residues for each body.
    action: Vec<u64>,
    /// Power of the reaction with size 1. First comes its power for each speed. Then come, for each body, the powers
    /// along each coordinate's rate; these are zero unless the reaction obeys the law of the body's connection. Empty
    /// if the reaction does no work by itself.
    power: Vec<u64>,
    /// Position in the list of reactions and the found reaction itself; `None` for a reaction that the model file
    /// states.
    found: Option<(usize, FoundReaction)>,
    /// True if the reaction acts in an equation that contains inertia, loads or other acting reactions, so that it is
    /// not 0 = 0.
    is_felt: bool,
}

/// State of the search for reactions in one random pose.
pub struct Search<'m> {
    /// Model in the random pose, with the relative motions of its bodies in that pose.
    pub relative: RelativeMotion<'m>,
    /// Each body with the body or ground on which it rests, outermost bodies first.
    pub supports: Vec<Support>,
    /// Number of reactions that are still missing.
    pub missing: usize,
    /// For each Newton–Euler equation, six for each body: true if it is not 0 = 0 even without reactions.
    moved: Vec<bool>,
    /// For each Newton–Euler equation, six for each body: true if it is not 0 = 0 with the chosen reactions.
    felt: Vec<bool>,
    /// Reactions chosen so far.
    chosen: Vec<ChosenReaction>,
    /// Basis of the columns of the chosen reactions: their contributions to all equations and to the laws of
    /// connections.
    basis: Basis,
}

impl<'m> Search<'m> {
    /// Starts the search from the stated reactions. `None` if no reaction is missing, if the stated
    /// reactions are dependent, or if no random pose is found.
    pub fn new(model: &'m Model) -> Option<Self> {
        let arena = &mut model.arena.clone();
        let drawn = RandomModel::new(model, arena)?;
        let (basis, chosen) = (Basis::new(drawn.space.0), Vec::new());
        let moved: Vec<bool> = drawn.newton_euler_balances(model, arena)?.iter().map(|x| *x != 0).collect();
        let relative = RelativeMotion { model, drawn, ways_if_open: None };
        let supports = relative.supports();
        let mut search = Self { felt: moved.clone(), moved, relative, supports, basis, chosen, missing: 0 };
        let stated = search.actions_of_known_reactions(arena)?;
        for action in stated {
            search.basis.add_row(search.column(&action, &[]))?;
            search.chosen.push(ChosenReaction { action, power: Vec::new(), found: None, is_felt: true });
        }
        search.update_active_reactions();
        (search.missing > 0).then_some(search)
    }

    /// Contributions of the stated reactions to the Newton–Euler equations of all bodies. `None` if a
    /// term has no value.
    fn actions_of_known_reactions(&self, arena: &mut Arena) -> Option<Vec<Vec<u64>>> {
        let directions: Vec<Expr> = self.relative.model.reactions.iter().flat_map(|r| r.direction).collect();
        let mut values = self.relative.drawn.values(self.relative.model, arena, &directions)?;
        let actions = self.relative.model.reactions.iter().map(|reaction| {
            let direction =
                self.relative.drawn.space.along(&self.relative.drawn.frames[reaction.frame].axes, values.triple());
            self.relative.drawn.reaction_action(self.relative.model, reaction.kind, direction)
        });
        Some(actions.collect())
    }

    /// Contribution of a reaction of size 1 along `direction` to the Newton–Euler equations: six residues for each
    /// body.
    fn action(&self, kind: ReactionKind, direction: VectorResidues) -> Vec<u64> {
        self.relative.drawn.reaction_action(self.relative.model, kind, direction)
    }

    /// Position of a body's reactions in the list of reactions. The outermost bodies come first.
    pub fn list_position_of_body(&self, body: usize) -> usize {
        1 + self.supports.iter().position(|support| support.body == body).unwrap_or(self.supports.len())
    }

    /// Position in the list of reactions that comes after the reactions of all bodies.
    pub fn last_list_position(&self) -> usize {
        2 + self.supports.len()
    }

    /// True if reactions are missing, and a reaction along `direction` acts in an equation that is not 0 = 0.
    pub fn is_wanted(&self, kind: ReactionKind, direction: VectorResidues) -> bool {
        self.missing > 0 && self.action(kind, direction).iter().zip(&self.felt).any(|(x, felt)| *x != 0 && *felt)
    }

    /// Chooses a reaction along `direction`, for the position `place` in the list of reactions. Returns false,
    /// without choosing it, if the chosen reactions already span its contribution.
    pub fn choose(
        &mut self,
        place: usize,
        found: FoundReaction,
        direction: VectorResidues,
        mut power: Vec<u64>,
    ) -> bool {
        if !power.is_empty() {
            let model = self.relative.model;
            power.resize(model.speeds.len() + model.bodies.len() * model.coordinates.len(), 0);
        }
        let action = self.action(found.kind, direction);
        let is_new = self.basis.add_row(self.column(&action, &power)).is_some();
        if is_new {
            self.chosen.push(ChosenReaction { action, power, found: Some((place, found)), is_felt: false });
            self.update_active_reactions();
        }
        is_new
    }

    /// Column of a reaction: its contributions to the equations of all bodies, then to the laws of connections.
    fn column(&self, action: &[u64], power: &[u64]) -> Vec<u64> {
        let model = self.relative.model;
        let mut column = action.to_vec();
        column.extend(power.iter().skip(model.speeds.len()));
        column.resize(action.len() + model.bodies.len() * model.coordinates.len(), 0);
        column
    }

    /// Finds the chosen reactions that act in equations that are not 0 = 0, and counts the missing reactions. Each
    /// such equation needs an unknown.
    fn update_active_reactions(&mut self) {
        while let Some(at) = self.chosen.iter().position(|chosen| !chosen.is_felt && self.is_active(chosen)) {
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
                powers.add_row(chosen.power.clone());
            }
        }
        let equations = self.felt.iter().filter(|felt| **felt).count() + powers.len();
        self.missing = equations.saturating_sub(unknowns);
    }

    /// True if a chosen reaction acts in an equation that is not 0 = 0. Also true if it shares an equation or its
    /// power with a reaction that acts.
    fn is_active(&self, one: &ChosenReaction) -> bool {
        let meets = |a: &[u64], b: &[u64]| a.iter().zip(b).any(|(x, y)| *x != 0 && *y != 0);
        let felt = self.chosen.iter().filter(|chosen| chosen.is_felt);
        one.action.iter().zip(&self.moved).any(|(x, moved)| *x != 0 && *moved)
            || felt.into_iter().any(|other| meets(&one.action, &other.action) || meets(&one.power, &other.power))
    }

    /// Found reactions that act, in the order of their positions in the list. Also the indices of bodies on which the
    /// ground, or the body they touch, exerts no forces except those that the model file states.
    pub fn results(mut self) -> (Vec<FoundReaction>, Vec<usize>) {
        self.chosen.retain(|chosen| chosen.is_felt);
        self.leave_out_zero_reactions();
        let mut found: Vec<(usize, FoundReaction)> = self.chosen.iter().filter_map(|chosen| chosen.found).collect();
        found.sort_by_key(|(place, _)| *place);
        let found: Vec<FoundReaction> = found.into_iter().map(|(_, found)| found).collect();
        let carries = |support: &Support| found.iter().any(|found| reaction_pair(found.kind) == support.pair());
        let is_open = |support: &&Support| {
            matches!(support.reason, SupportReason::Ground | SupportReason::Touch) && !carries(support)
        };
        let idle = self.supports.iter().filter(is_open).map(|support| support.body).collect();
        (found, idle)
    }

    /// Removes reactions that are always 0: each is the only term in an equation without inertia and loads.
    fn leave_out_zero_reactions(&mut self) {
        while let Some(zero) = (0..self.moved.len()).filter(|row| !self.moved[*row]).find_map(|row| {
            let mut acting = (0..self.chosen.len()).filter(|at| self.chosen[*at].action[row] != 0);
            let only = acting.next()?;
            let chosen = &self.chosen[only];
            // A shared reaction also holds a direction in other equations, so it is not removed.
            (acting.next().is_none() && chosen.found.is_some_and(|(_, found)| !found.is_shared)).then_some(only)
        }) {
            self.chosen.remove(zero);
        }
    }
}
