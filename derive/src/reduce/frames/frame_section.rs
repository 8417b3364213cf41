//! Equations on the section of a moving frame. The section is the set of states at which all pinned
//! states are zero.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::elimination::{LinearSystem, eliminate};
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::reduce::basis::moving_frame::{FrameSymmetry, PinnedFrame};
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::basis::solved_rows::{SolvedRows, solve_rows};
use crate::reduce::result::reduction::MovingFrame;
use crate::reduce::slices::wanted_outputs::WantedOutputs;

impl ReductionBasis {
    /// Writes the equations in the frame that moves along the symmetries `turns` and keeps the
    /// states `pins` at zero. Returns the wanted quantities in this frame.
    ///
    /// `None` if the frame is singular, or if its motion changes a momentum that is to be kept
    /// constant.
    pub(in crate::reduce) fn equations_on_section(
        &mut self,
        turns: &[usize],
        pins: &[usize],
        momenta: &[usize],
        wanted: &WantedOutputs,
    ) -> Option<WantedOutputs> {
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        let count = self.q.len();
        let pairs: Vec<(Expr, Expr)> = pins.iter().map(|at| (states[*at], Expr::ZERO)).collect();
        let mut put = Substitution::new(&pairs);
        let changes: Vec<Vec<Expr>> =
            turns.iter().map(|turn| self.momentum_changes_on_section(*turn, momenta, &states)).collect();
        let (variables, unknowns) = (self.kane.variables.clone(), self.kane.unknowns.clone());
        self.rewrite_basis_terms(&mut |arena, simplifier, e| {
            let there = put.apply(arena, e);
            simplifier.simplify(arena, there)
        });
        let wanted = wanted.map(|e| put.apply(&mut self.arena, e));
        let changes: Vec<Vec<Expr>> =
            changes.into_iter().map(|list| list.into_iter().map(|e| put.apply(&mut self.arena, e)).collect()).collect();
        if put.undefined.is_some() {
            return None;
        }
        self.kane.coordinates.clone_from(&self.q);
        (self.kane.variables, self.kane.unknowns) = (variables, unknowns);
        let rates = self.rates_on_section(pins)?;
        let (arena, simplifier) = (&mut self.arena, &mut self.simplifier);
        let fields: Vec<&Vec<Expr>> = turns.iter().map(|turn| &self.turns[*turn].along).collect();
        let rows = pins.iter().map(|pin| fields.iter().map(|field| field[*pin]).collect()).collect();
        let right = rates.into_iter().map(|rate| vec![arena.neg(rate)]).collect();
        let columns: Vec<usize> = (0..turns.len()).collect();
        let solved = solve_rows(arena, simplifier, rows, right, &states, &columns);
        if solved.pivots.len() < turns.len() {
            return None;
        }
        let rates = values_of_solved_rows(arena, simplifier, &solved);
        let still = rates.iter().zip(&changes).all(|(rate, changes)| {
            *rate == Expr::ZERO || changes.iter().all(|e| zero_test(arena, *e) == ZeroTest::Zero)
        });
        if !still {
            return None;
        }
        let mut added = Vec::new();
        for at in 0..states.len() {
            let terms: Vec<Expr> = rates.iter().zip(&fields).map(|(rate, field)| arena.mul(*rate, field[at])).collect();
            let sum = arena.sum(&terms);
            added.push(simplifier.simplify(arena, sum));
        }
        for (at, (rate, added)) in self.kane.coordinate_rates.iter_mut().zip(&added).enumerate() {
            let moved = arena.add(*rate, *added);
            *rate = if pins.contains(&at) { Expr::ZERO } else { simplifier.simplify(arena, moved) };
        }
        let divisors = solved.divisors.iter().copied().filter(|d| arena.as_number(*d).is_none()).collect();
        let pinned_speeds = pins.iter().filter_map(|pin| pin.checked_sub(count));
        for at in pinned_speeds {
            for momentum in &mut self.momenta {
                (momentum.row[at], momentum.direction[at]) = (Expr::ZERO, Expr::ZERO);
            }
        }
        self.frame = Some(PinnedFrame { turns: turns.to_vec(), pins: pins.to_vec(), rates, added, divisors });
        Some(wanted)
    }

    /// Data by which a start of the whole model is moved to a start in the frame; `None` without a
    /// frame.
    pub(in crate::reduce) fn start_on_section(&mut self) -> Option<MovingFrame> {
        let frame = self.frame.clone()?;
        let starts = [self.q_start.as_slice(), &self.u_start].concat();
        let pins: Vec<Expr> = frame.pins.iter().map(|pin| starts[*pin]).collect();
        let of_model = [self.model.q(), self.model.u()].concat();
        let turns: Vec<FrameSymmetry> = frame.turns.iter().map(|turn| self.turns[*turn].clone()).collect();
        let mut slopes = vec![Vec::new(); pins.len()];
        for turn in &turns {
            let along = of_model.iter().copied().zip(turn.of_model.iter().copied()).collect::<Vec<_>>();
            let mut change = Differential::along(&along);
            for (pin, slopes) in pins.iter().zip(&mut slopes) {
                slopes.push(change.apply(&mut self.arena, *pin));
            }
        }
        let (about, fields) = turns.into_iter().map(|turn| (turn.words, turn.of_model)).unzip();
        Some(MovingFrame { about, fields, pins, slopes })
    }

    /// Substitution of zero for the states that the frame keeps at zero; empty without a frame.
    pub(in crate::reduce) fn section_substitution(&self) -> Substitution {
        let states = [self.q.as_slice(), &self.kane.variables].concat();
        let pins = self.frame.iter().flat_map(|frame| &frame.pins);
        Substitution::new(&pins.map(|pin| (states[*pin], Expr::ZERO)).collect::<Vec<_>>())
    }

    /// True if the frame keeps the speed with this index at zero.
    pub(in crate::reduce) fn section_pins_speed(&self, at: usize) -> bool {
        self.frame.as_ref().is_some_and(|frame| frame.pins.contains(&(self.q.len() + at)))
    }

    /// Derivatives of the given momenta along the symmetry with the index `turn`. A derivative is
    /// zero if the symmetry leaves the momentum unchanged.
    fn momentum_changes_on_section(&mut self, turn: usize, momenta: &[usize], states: &[Expr]) -> Vec<Expr> {
        let along = states.iter().copied().zip(self.turns[turn].along.iter().copied()).collect::<Vec<_>>();
        let mut change = Differential::along(&along);
        momenta.iter().map(|at| change.apply(&mut self.arena, self.momenta[*at].value)).collect()
    }

    /// Rates of the pinned states where these are zero, without the motion of the frame. `None` if
    /// the accelerations are not determined.
    fn rates_on_section(&mut self, pins: &[usize]) -> Option<Vec<Expr>> {
        let count = self.q.len();
        let (arena, simplifier) = (&mut self.arena, &mut self.simplifier);
        let mut solved = Substitution::default();
        if pins.iter().any(|pin| *pin >= count) {
            let unknowns = self.kane.unknowns.clone();
            let system = LinearSystem {
                matrix: &self.kane.matrix,
                right: &self.kane.forcing,
                unknowns: &unknowns,
                symmetric: self.kane.symmetric,
                is_large: false,
            };
            for step in eliminate(arena, simplifier, system).ok()?.steps {
                let value = solved.apply(arena, step.value);
                solved.set(step.symbol, value);
            }
        }
        let mut rates = Vec::new();
        for pin in pins {
            let rate = match pin.checked_sub(count) {
                None => self.kane.coordinate_rates[*pin],
                Some(at) => solved.apply(arena, self.kane.unknowns[at]),
            };
            let rate = simplifier.simplify(arena, rate);
            rates.push(if zero_test(arena, rate) == ZeroTest::Zero { Expr::ZERO } else { rate });
        }
        Some(rates)
    }
}

/// Values of the unknowns of a linear system after elimination, by back substitution.
fn values_of_solved_rows(arena: &mut Arena, simplifier: &mut Simplifier, solved: &SolvedRows) -> Vec<Expr> {
    let mut rates = vec![Expr::ZERO; solved.pivots.len()];
    for k in (0..solved.pivots.len()).rev() {
        let rate = solved.value_of_pivot_unknown(arena, k, 0, &rates);
        let rate = simplifier.simplify(arena, rate);
        rates[solved.pivots[k].1] = if zero_test(arena, rate) == ZeroTest::Zero { Expr::ZERO } else { rate };
    }
    rates
}
