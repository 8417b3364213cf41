//! Search for rest by the balance of forces along every motion that the constraints permit.
//!
//! In a dead point, the chosen generalized speeds do not move the mechanism. The balance along these
//! speeds then holds trivially, and attracts Newton's method. The balance with multipliers has no
//! dead points ([`tripos_derive::flow::RestBalance`]).

use super::SteadyProblem;
use super::singular_states::SingularStateTest;
use super::steady_newton::Unknowns;
use super::steady_state::{SteadyState, is_same_steady_state};
use crate::Mechanism;
use std::cell::OnceCell;
use tripos_derive::flow::RestBalance;
use tripos_traits::{DoubleDouble, Scalar};

/// Search for rest by the balance of forces. It is prepared when it is first needed.
#[derive(Default)]
pub(super) struct RestSearch {
    /// Prepared search; empty before the first use, and `None` if Lagrange's equations cannot be
    /// derived.
    forces: OnceCell<Option<ForceBalance>>,
}

/// Search for states at which the forces balance. The unknowns are the coordinates and multipliers.
struct ForceBalance {
    /// Equations of the balance. Their states are the coordinates, followed by the multipliers.
    question: SteadyProblem,
    /// Number of multipliers among the unknowns.
    multipliers: usize,
}

impl RestSearch {
    /// Searches for rest by the balance of forces, if the result `steady` of a search in the chosen speeds
    /// is singular or failed. Begins at this result, then at `x`, the start of that search.
    ///
    /// A regular result is returned unchanged. If no rest is found, the result is returned with the
    /// unbalanced forces.
    pub(super) fn replace_by_balanced_rest(
        &self,
        model: &Mechanism,
        question: &SteadyProblem,
        steady: SteadyState,
        x: &[DoubleDouble],
        unknowns: &Unknowns,
    ) -> SteadyState {
        let is_singular = question.poles.refuse_singular_state(&question.parameters, &steady).is_err();
        let may_rest = question.time.is_none() && (!unknowns.moves || steady.is_steady() && steady.is_rest());
        let is_good = steady.is_steady() && !is_singular;
        if is_good || !may_rest || question.flow.divisors.is_empty() {
            return steady;
        }
        let forces = self.forces.get_or_init(|| ForceBalance::new(model, question));
        let Some(forces) = forces else { return steady };
        let starts = [steady.x.clone(), x.to_vec()];
        let mut rests = starts.iter().filter_map(|x| forces.find_rest(model, question, x, unknowns));
        rests.next().unwrap_or_else(|| {
            let mut steady = steady;
            if steady.is_steady() {
                steady.forces = forces.unbalanced_forces(&steady);
            }
            steady
        })
    }
}

impl ForceBalance {
    /// Prepares the balance of forces of a model. `None` if Lagrange's equations cannot be derived.
    fn new(model: &Mechanism, question: &SteadyProblem) -> Option<Self> {
        let RestBalance { residuals: flow, multipliers, speeds } = RestBalance::new(model).ok()?;
        let program = flow.program(&[], &speeds).ok()?;
        let n = question.coordinates;
        let of_forces = (0..multipliers).map(|at| format!("multiplier {}", at + 1));
        let question = SteadyProblem {
            poles: SingularStateTest::new(model, &flow).ok()?,
            names: question.names[..n].iter().cloned().chain(of_forces).collect(),
            coordinates: n,
            time: None,
            by_time: None,
            loops: question.loops.clone(),
            is_angle: (0..n + multipliers).map(|at| at < n && question.is_angle[at]).collect(),
            inputs: Vec::new(),
            outputs: Vec::new(),
            output_terms: Vec::new(),
            wide: program.tape().to(),
            program,
            parameters: question.parameters.clone(),
            flow,
        };
        Some(Self { question, multipliers })
    }

    /// Finds the multipliers that best balance the forces at a state `x` of the mechanism. Returns the
    /// coordinates and multipliers.
    fn with_balancing_multipliers(&self, x: &[DoubleDouble]) -> SteadyState {
        let n = self.question.coordinates;
        let none = std::iter::repeat_n(DoubleDouble::int(0), self.multipliers);
        let x: Vec<DoubleDouble> = x[..n].iter().copied().chain(none).collect();
        self.question.find_steady_state(&x, &Unknowns { states: (n..n + self.multipliers).collect(), moves: false })
    }

    /// Forces that no multipliers balance at a state of the mechanism. Each comes with the index of its
    /// coordinate.
    fn unbalanced_forces(&self, steady: &SteadyState) -> Vec<(usize, f64)> {
        let left = self.with_balancing_multipliers(&steady.x).unbalanced;
        left.into_iter().filter(|(at, _)| *at < self.question.coordinates).collect()
    }

    /// Finds a rest position by changing the unknown coordinates of a state. `None` if none is found.
    fn find_rest(
        &self,
        model: &Mechanism,
        question: &SteadyProblem,
        x: &[DoubleDouble],
        unknowns: &Unknowns,
    ) -> Option<SteadyState> {
        let n = self.question.coordinates;
        let places = unknowns.states.iter().copied().filter(|at| *at < n);
        let states = places.chain(n..n + self.multipliers).collect();
        let found =
            self.question.find_steady_state(&self.with_balancing_multipliers(x).x, &Unknowns { states, moves: false });
        if !found.is_steady() {
            return None;
        }
        let (values, _) = self.question.program.evaluate(&self.question.wide, &self.question.parameters, &found.x, &[]);
        let state: Vec<DoubleDouble> = found.x[..n].iter().chain(&values.outputs).copied().collect();
        // A regular rest is solved for again in the chosen speeds.
        let again = question.find_steady_state(&state, &Unknowns { states: unknowns.states.clone(), moves: false });
        let rest = question.rest_at(state, &found);
        let is_regular = question.poles.refuse_singular_state(&question.parameters, &again).is_ok();
        let is_it = again.is_steady() && is_regular && is_same_steady_state(model, &again, &rest);
        Some(if is_it { again } else { rest })
    }
}

impl SteadyProblem {
    /// Makes the result of a search for rest at the state `x`, where the forces balance along every
    /// permitted motion. `by_forces` has the residuals of this balance.
    fn rest_at(&self, x: Vec<DoubleDouble>, by_forces: &SteadyState) -> SteadyState {
        SteadyState { x, along: self.rest_velocities(), by_time: self.by_time, ..by_forces.clone() }
    }
}
