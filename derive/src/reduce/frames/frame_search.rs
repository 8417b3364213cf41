//! Search for the moving frame in which the reduced equations of a scene cost least.
//!
//! Symmetries that leave all wanted quantities unchanged are tried: single symmetries, and sets
//! whose brackets belong to the set. The frame pins states (keeps them at zero) that would
//! otherwise be integrated.

use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::rank::rank;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::flow::{Flow as Whole, Symmetry, symmetries_that_turn_states};
use crate::mechanics::SolvedAccelerations;
use crate::reduce::basis::moving_frame::FrameSymmetry;
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::basis::search_work::SearchWork;
use crate::reduce::slices::slice::Slice;
use crate::reduce::slices::wanted_outputs::WantedOutputs;

/// Largest number of symmetries for which sets of two and three symmetries are tried.
const MOST_TURNS: usize = 9;
/// Largest number of sets of pinned states that are tried for each set of symmetries and momenta.
const MOST_SECTIONS: usize = 4;
/// Cost of an integrated state in operations, without that of its rate: sums of stages, error
/// estimate and dense output.
const STATE: usize = 12;

/// Choice for reduced equations: the momenta that are kept constant, and a moving frame.
#[derive(Clone, Debug, Default)]
pub struct FrameAndMomenta {
    /// Momenta that are kept constant, as indices into `ReductionBasis::momenta`.
    pub momenta: Vec<usize>,
    /// Symmetries along which the frame moves, as indices into `ReductionBasis::turns`; empty without a
    /// frame.
    pub turns: Vec<usize>,
    /// States that the frame keeps at zero, as indices in q, then u.
    pub pins: Vec<usize>,
}

/// Cost of reduced equations, in operations. It follows from the number of integrated variables and
/// the number of operations of their rates.
fn frame_choice_cost(integrated: usize, operations: usize) -> usize {
    STATE * integrated + operations
}

impl ReductionBasis {
    /// Finds the moving frame whose equations cost least. It must leave fewer variables to
    /// integrate than the given momenta without a frame. `None` if there is no such frame, or if
    /// the limit on work is reached first.
    pub(in crate::reduce) fn find_frame(
        &mut self,
        wanted: &WantedOutputs,
        choices: &[Vec<usize>],
        momenta: &[usize],
        work: &mut SearchWork,
    ) -> Option<FrameAndMomenta> {
        if work.is_search_work_used_up() {
            return None;
        }
        let plain = FrameAndMomenta { momenta: momenta.to_vec(), ..FrameAndMomenta::default() };
        let mut trial = self.clone();
        let flow = trial.flow_of_frame_choice(&plain, wanted)?;
        let (_, without, operations) = flow.slice_cost(&trial);
        let (mut least, mut best) = (frame_choice_cost(without, operations), None);
        // Start values of the scene's integrated variables, in the variables of the model.
        let mut back = trial.basis_to_model_substitution();
        let variables = flow.core.iter().chain(&flow.quadratures);
        let starts: Vec<Expr> = variables.map(|v| back.apply(&mut trial.arena, v.symbol)).collect();
        let states = [self.q.as_slice(), &self.kane.variables].concat();
        let is_needed = |at: &usize| starts.iter().any(|start| trial.arena.mentions(*start, states[*at]));
        let needed: Vec<usize> = (0..states.len()).filter(is_needed).collect();
        self.find_frame_symmetries(&needed, wanted);
        for turns in self.closed_symmetry_sets() {
            for choice in self.frame_choices(&turns, wanted, choices) {
                if work.is_search_work_used_up() {
                    return best;
                }
                let mut trial = self.clone();
                let flow = trial.flow_of_frame_choice(&choice, wanted);
                work.add(&trial, self);
                let Some(flow) = flow else { continue };
                let (_, integrated, operations) = flow.slice_cost(&trial);
                let weight = frame_choice_cost(integrated, operations);
                if integrated < without && weight < least {
                    (least, best) = (weight, Some(choice));
                }
            }
        }
        best
    }

    /// Replaces variables that the symmetries of the chosen momenta move together by differences.
    /// Returns the wanted quantities in the new variables.
    ///
    /// With a frame, only momenta whose symmetries move all speeds at constant ratios are used. In
    /// the frame, other symmetries move fewer variables.
    pub(in crate::reduce) fn differences(&mut self, choice: &FrameAndMomenta, wanted: &WantedOutputs) -> WantedOutputs {
        let momenta = if choice.turns.is_empty() {
            choice.momenta.clone()
        } else {
            self.momenta_with_constant_directions(&choice.momenta)
        };
        self.replace_by_differences(&momenta, wanted.clone())
    }

    /// Selects the momenta whose symmetries move all speeds at constant ratios: all components
    /// along speeds are numbers.
    fn momenta_with_constant_directions(&self, momenta: &[usize]) -> Vec<usize> {
        let is_plain = |at: &&usize| self.momenta[**at].direction.iter().all(|e| self.arena.as_number(*e).is_some());
        momenta.iter().filter(is_plain).copied().collect()
    }

    /// Smallest set of variables that a scene integrates if the momenta and the frame are chosen as
    /// `choice`. `None` if the equations are not determined.
    fn flow_of_frame_choice(&mut self, choice: &FrameAndMomenta, wanted: &WantedOutputs) -> Option<Slice> {
        let wanted = self.differences(choice, wanted);
        let wanted = self.write_in_frame_choice(choice, wanted)?;
        let level = self.equations_on_momentum_level(&choice.momenta, None)?;
        Slice::new(self, &level, &wanted)
    }

    /// Writes the equations in the frame of `choice`, and returns the wanted quantities in it.
    /// Nothing changes if the choice has no frame. `None` if the frame is singular.
    pub(in crate::reduce) fn write_in_frame_choice(
        &mut self,
        choice: &FrameAndMomenta,
        wanted: WantedOutputs,
    ) -> Option<WantedOutputs> {
        match choice.turns.as_slice() {
            [] => Some(wanted),
            turns => self.equations_on_section(turns, &choice.pins, &choice.momenta, &wanted),
        }
    }

    /// Finds symmetries that move at least one of the states `needed` and leave the wanted
    /// quantities unchanged. They are stored in the field `turns`.
    fn find_frame_symmetries(&mut self, needed: &[usize], wanted: &WantedOutputs) {
        let Some(mut whole) = self.flow_for_frame_search() else { return };
        let rates = whole.rates.clone();
        let rates = whole.without_definitions(&rates);
        let accelerations: Vec<(Expr, Expr)> =
            self.kane.unknowns.iter().copied().zip(rates[self.q.len()..].iter().copied()).collect();
        let mut solved = Substitution::new(&accelerations);
        let shown = WantedOutputs { conditions: Vec::new(), ..wanted.clone() };
        let mut solve = |e: Expr| solved.apply(&mut whole.arena, e);
        let [all, shown] =
            [wanted, &shown].map(|wanted| wanted.values().into_iter().map(&mut solve).collect::<Vec<_>>());
        let states = whole.states.clone();
        let mut found = |values: &[Expr]| {
            let mut is_wanted = |arena: &mut Arena, along: &[Expr]| {
                let mut change =
                    Differential::along(&states.iter().copied().zip(along.iter().copied()).collect::<Vec<_>>());
                needed.iter().any(|at| along[*at] != Expr::ZERO)
                    && values.iter().all(|e| {
                        let change = change.apply(arena, *e);
                        zero_test(arena, change) == ZeroTest::Zero
                    })
            };
            symmetries_that_turn_states(&self.model, &mut whole, self.fields.clone(), &mut is_wanted)
        };
        let symmetries = found(&all);
        let mut kept = Vec::new();
        if symmetries.is_empty() && all.len() > shown.len() {
            kept = found(&shown);
        }
        let words = |symmetry: &Symmetry| symmetry.words(&self.model);
        let kept = kept.iter().map(words).collect();
        let turns = symmetries.into_iter().map(|symmetry| FrameSymmetry {
            words: words(&symmetry),
            of_model: symmetry.along.clone(),
            along: symmetry.along,
        });
        let turns = turns.collect();
        (self.turns, self.kept_by_domain) = (turns, kept);
        self.arena = whole.arena;
    }

    /// First-order system x' = f(x) of the whole model, with solved rates. `None` if the accelerations
    /// are not determined.
    fn flow_for_frame_search(&self) -> Option<Whole> {
        let mut arena = self.arena.clone();
        let steps = SolvedAccelerations::steps(&mut arena, &self.kane).ok()?;
        let unknowns = self.kane.unknowns.iter().take(self.model.speeds.len());
        Some(Whole {
            arena,
            steps,
            parameters: self.model.p(),
            states: [self.q.clone(), self.kane.variables.clone()].concat(),
            rates: self.kane.coordinate_rates.iter().chain(unknowns).copied().collect(),
            inertia: self.kane.matrix.clone(),
            balances: self.kane.forcing.clone(),
            loops: Vec::new(),
            closed: Vec::new(),
            symmetries: Vec::new(),
            energies: [Expr::ZERO; 3],
            divisors: Vec::new(),
        })
    }

    /// Sets of one, two or three symmetries that are closed: the bracket of any two is zero, a
    /// symmetry of the set, or its negative.
    fn closed_symmetry_sets(&mut self) -> Vec<Vec<usize>> {
        let count = self.turns.len();
        let mut sets: Vec<Vec<usize>> = (0..count).map(|at| vec![at]).collect();
        if count > MOST_TURNS {
            return sets;
        }
        // Kind of the bracket of each symmetry with every symmetry before it.
        let mut bracket: Vec<Vec<Bracket>> = Vec::new();
        for a in 0..count {
            bracket.push((0..a).map(|b| self.frame_symmetry_bracket(a, b)).collect());
        }
        let inside = |a: usize, b: usize, set: &[usize]| match bracket[a.max(b)][a.min(b)] {
            Bracket::Zero => true,
            Bracket::Turn(c) => set.contains(&c),
            Bracket::Other => false,
        };
        for a in 0..count {
            for b in a + 1..count {
                if inside(a, b, &[a, b]) {
                    sets.push(vec![a, b]);
                }
                for c in b + 1..count {
                    let set = [a, b, c];
                    if inside(a, b, &set) && inside(b, c, &set) && inside(a, c, &set) {
                        sets.push(set.to_vec());
                    }
                }
            }
        }
        sets
    }

    /// Kind of the bracket of the symmetries with the indices `a` and `b`: zero, a known symmetry,
    /// or another field.
    fn frame_symmetry_bracket(&mut self, a: usize, b: usize) -> Bracket {
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        let arena = &mut self.arena;
        let along = |field: &[Expr]| {
            Differential::along(&states.iter().copied().zip(field.iter().copied()).collect::<Vec<_>>())
        };
        let (one, other) = (&self.turns[a].along, &self.turns[b].along);
        let (mut by_one, mut by_other) = (along(one), along(other));
        let mut bracket = Vec::new();
        for (x, y) in one.iter().zip(other) {
            let (first, second) = (by_one.apply(arena, *y), by_other.apply(arena, *x));
            bracket.push(arena.sub(first, second));
        }
        let is_zero = |e: Expr, arena: &Arena| zero_test(arena, e) == ZeroTest::Zero;
        if bracket.iter().all(|e| is_zero(*e, arena)) {
            return Bracket::Zero;
        }
        for (at, turn) in self.turns.iter().enumerate() {
            let mut vanishes = |of: fn(&mut Arena, Expr, Expr) -> Expr| {
                bracket.iter().zip(&turn.along).all(|(e, x)| {
                    let rest = of(arena, *e, *x);
                    is_zero(rest, arena)
                })
            };
            if vanishes(Arena::add) || vanishes(Arena::sub) {
                return Bracket::Turn(at);
            }
        }
        Bracket::Other
    }

    /// Lists the possible choices of momenta and pinned states for a frame along the symmetries
    /// `turns`. Only the largest possible sets of momenta are listed.
    fn frame_choices(&self, turns: &[usize], wanted: &WantedOutputs, choices: &[Vec<usize>]) -> Vec<FrameAndMomenta> {
        let mut list: Vec<FrameAndMomenta> = Vec::new();
        let mut sorted: Vec<&Vec<usize>> = choices.iter().collect();
        sorted.sort_by_key(|momenta| std::cmp::Reverse(momenta.len()));
        for momenta in sorted {
            let smaller = list.first().is_some_and(|found| found.momenta.len() > momenta.len());
            if smaller {
                break;
            }
            let mut basis = self.clone();
            let wanted = basis.replace_by_differences(&self.momenta_with_constant_directions(momenta), wanted.clone());
            for pins in basis.search_frame_sections(turns, momenta, &wanted) {
                let mut trial = basis.clone();
                let framed = trial.equations_on_section(turns, &pins, momenta, &wanted);
                if framed.is_some_and(|_| trial.equations_on_momentum_level(momenta, None).is_some()) {
                    list.push(FrameAndMomenta { momenta: momenta.clone(), turns: turns.to_vec(), pins });
                }
            }
        }
        list
    }

    /// Sets of states that a frame may pin (keep at zero). Each pinned state is moved by a symmetry
    /// of the frame, and would be integrated without the frame.
    ///
    /// Coordinates come first, then speeds, each from the last to the first. So a distance in the
    /// frame lies along the first axis.
    fn search_frame_sections(&self, turns: &[usize], momenta: &[usize], wanted: &WantedOutputs) -> Vec<Vec<usize>> {
        let needed = self.variables_integrated_without_frame(momenta, wanted);
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        let moved = |at: usize| turns.iter().any(|turn| self.turns[*turn].along[at] != Expr::ZERO);
        let order = (0..self.q.len()).rev().chain((self.q.len()..states.len()).rev());
        let open: Vec<usize> = order.filter(|at| needed.contains(&states[*at]) && moved(*at)).collect();
        let mut sections: Vec<Vec<usize>> = Vec::new();
        for first in &open {
            let mut pins = vec![*first];
            for next in &open {
                if pins.len() < turns.len()
                    && !pins.contains(next)
                    && self.is_section(turns, &[&pins[..], &[*next]].concat())
                {
                    pins.push(*next);
                }
            }
            pins.sort_unstable();
            let is_whole = pins.len() == turns.len() && self.is_section(turns, &pins);
            if is_whole && !sections.contains(&pins) {
                sections.push(pins);
            }
            if sections.len() == MOST_SECTIONS {
                break;
            }
        }
        sections
    }

    /// True if the frame is regular where the pinned states are zero: the components of the
    /// symmetries at the pinned states are linearly independent.
    fn is_section(&self, turns: &[usize], pins: &[usize]) -> bool {
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        let mut arena = self.arena.clone();
        let mut put = Substitution::new(&pins.iter().map(|at| (states[*at], Expr::ZERO)).collect::<Vec<_>>());
        let mut rows: Vec<Vec<Expr>> = Vec::new();
        for pin in pins {
            rows.push(turns.iter().map(|turn| put.apply(&mut arena, self.turns[*turn].along[*pin])).collect());
        }
        put.undefined.is_none() && rank(&arena, &rows).is_some_and(|found| found.rank == pins.len())
    }

    /// Symbols of the variables that a scene integrates without a frame. Momenta are kept constant
    /// only if their symmetries move all speeds at constant ratios. Empty if the equations are not
    /// determined.
    fn variables_integrated_without_frame(&self, momenta: &[usize], wanted: &WantedOutputs) -> Vec<Expr> {
        let mut trial = self.clone();
        let level = trial
            .equations_on_momentum_level(&self.momenta_with_constant_directions(momenta), None)
            .or_else(|| trial.equations_on_momentum_level(&[], None));
        let Some(flow) = level.and_then(|level| Slice::new(&mut trial, &level, wanted)) else { return Vec::new() };
        flow.core.iter().chain(&flow.quadratures).map(|v| v.symbol).collect()
    }
}

/// Kind of the bracket of two symmetries of the reduction basis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Bracket {
    /// Bracket is zero: the symmetries commute.
    Zero,
    /// Bracket is a listed symmetry, given by its index, or the negative of it.
    Turn(usize),
    /// Bracket is a field that is not a symmetry in the list.
    Other,
}
