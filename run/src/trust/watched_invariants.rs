//! Quantities that are watched along a run in addition to its state: first integrals, determinants,
//! condition numbers, and the divisors of the kinematic equations.
//!
//! Invariant: no watched quantity can stop a run or a page. A value that does not exist is NaN.

use crate::code::compile_tape;
use crate::error::Error;
use crate::preparation::problem::Problem;
use std::fmt;
use tripos_derive::Model;
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::model::Unit;
use tripos_derive::prove::{Integral, IntegralKind};
use tripos_derive::reduce::ReductionBasis;
use tripos_sim::Solution;
use tripos_traits::larger;

/// First integral (a quantity that stays constant) that is watched along a run: its kind, name and
/// unit.
#[derive(Clone, Debug)]
pub struct ConservedQuantity {
    /// Kind of the integral, such as energy or a momentum.
    pub kind: IntegralKind,
    /// Name of the first integral in all results, such as `momentum p_q3 = ∂L/∂q3'`.
    pub name: String,
    /// Unit of the first integral, such as J; "SI" if the unit is not known.
    pub unit: String,
}

impl ConservedQuantity {
    /// Describes a first integral. Its expression belongs to `arena`.
    fn new(model: &Model, arena: &Arena, integral: &Integral) -> Self {
        let unit = match model.unit_of(arena, integral.expression) {
            Some(unit) if unit == Unit::new(2, 1, -2) => "J".to_owned(),
            Some(unit) => unit.to_string(),
            None => "SI".to_owned(),
        };
        let kind = integral.kinds[0];
        Self { kind, name: integral.name(model, arena), unit }
    }
}

impl fmt::Display for ConservedQuantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

/// Largest change of a first integral along a run.
#[derive(Clone, Debug)]
pub struct Drift {
    /// First integral whose largest change is stated.
    pub integral: ConservedQuantity,
    /// Largest absolute change of the integral from its first value over the samples of the run, in the
    /// unit of the integral.
    pub change: f64,
}

/// Compiled first integrals and divisors that are watched along a run.
pub struct WatchedInvariants {
    /// Descriptions of the first integrals, in the order of the program's outputs.
    pub integrals: Vec<ConservedQuantity>,
    /// Divisors of the kinematic equations, as text. The equations are singular where a divisor is zero.
    pub divisors: Vec<String>,
    /// Program that computes the first integrals, then the divisors, from the parameters, coordinates and
    /// generalized speeds.
    tape: Tape,
    /// Program that computes one product for each first integral, from the parameters. Its factors are
    /// the integral's divisors that depend only on parameters.
    divided: Tape,
}

/// Rounding error allowed in the value of a first integral, in units of the double precision.
const ROUNDINGS: f64 = 64.0;

/// Change of a first integral since the start of a run, at one instant.
#[derive(Clone, Copy, Debug, Default)]
pub struct Excursion {
    /// Instant at which the change is taken, s.
    pub t: f64,
    /// Absolute change of the integral since the start, in its unit.
    pub change: f64,
    /// Quotient of this change and the change that allowed errors of the state can cause at this instant.
    pub ratio: f64,
}

/// Values of the watched quantities at the samples of a run.
pub struct InvariantValues {
    /// Instants of the samples of the run, s.
    pub t: Vec<f64>,
    /// Values of each first integral at all samples, in its unit: one list for each integral.
    pub integrals: Vec<Vec<f64>>,
    /// Determinant of the matrix A at each sample, where A x = b is the linear system that gives the
    /// accelerations. Empty for reduced equations.
    pub determinant: Vec<f64>,
    /// Reciprocal condition number of this matrix A, with scaled rows and columns, at each sample.
    pub condition: Vec<f64>,
    /// Absolute values of the divisors of the kinematic equations at all samples: one list for each
    /// divisor.
    pub divisors: Vec<Vec<f64>>,
}

impl WatchedInvariants {
    /// Compiles first integrals of a model, and the divisors of its kinematic equations. The expressions
    /// of the integrals belong to `arena`.
    ///
    /// # Errors
    /// [`Error::Request`] if an integral or a divisor mentions a symbol without a value during a
    /// run.
    pub fn new(model: &Model, arena: &Arena, integrals: &[Integral]) -> Result<Self, Error> {
        let divisors = &model.kinematic_equations.divisors;
        let outputs: Vec<_> = integrals.iter().map(|i| i.expression).chain(divisors.iter().copied()).collect();
        let inputs = [model.p(), model.q(), model.u()].concat();
        Ok(Self {
            integrals: integrals.iter().map(|i| ConservedQuantity::new(model, arena, i)).collect(),
            divisors: divisors.iter().map(|e| print_text(arena, *e)).collect(),
            tape: compile_tape(arena, &inputs, &outputs, "what is conserved")?,
            divided: Self::parameter_divisors(model, arena, integrals)?,
        })
    }

    /// Compiles one product for each first integral: the product of its divisors that depend only on
    /// parameters.
    ///
    /// # Errors
    /// `Error::Request` if a divisor mentions a symbol without a value during a run.
    fn parameter_divisors(model: &Model, arena: &Arena, integrals: &[Integral]) -> Result<Tape, Error> {
        let mut arena = arena.clone();
        let parameters = model.p();
        let products: Vec<_> = integrals
            .iter()
            .map(|integral| {
                let state = [model.q(), model.u()].concat();
                let mut divisors = integral.divisors(&arena);
                divisors.retain(|e| !state.iter().any(|s| arena.mentions(*e, *s)));
                arena.product(&divisors)
            })
            .collect();
        compile_tape(&arena, &parameters, &products, "what a first integral divides by")
    }

    /// Tells for each first integral if it exists at the given parameters: true unless it divides by
    /// zero.
    #[must_use]
    pub fn integrals_exist(&self, parameters: &[f64]) -> Vec<bool> {
        self.divided.evaluate(parameters).into_iter().map(|divisor| divisor != 0.0).collect()
    }

    /// Derives a model, proves its first integrals and compiles them for runs.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived.
    pub fn of_model(model: &Model) -> Result<Self, Error> {
        Self::of_basis(model, &ReductionBasis::new(model).map_err(|error| model.diagnose(&error))?)
    }

    /// Compiles the first integrals of a model that are known from `basis`.
    ///
    /// # Errors
    /// Errors of [`WatchedInvariants::new`].
    pub fn of_basis(model: &Model, basis: &ReductionBasis) -> Result<Self, Error> {
        Self::new(model, &basis.arena, &basis.integrals)
    }

    /// Largest change along a run of each first integral that exists at the parameters of the problem.
    #[must_use]
    pub fn integral_drifts(&self, problem: &Problem<'_>, solution: &Solution) -> Vec<Drift> {
        let exist = self.integrals_exist(&problem.shown.parameters);
        let changes = self.integrals.iter().zip(self.changes(problem, solution)).zip(exist);
        let drift = |(integral, change): (&ConservedQuantity, f64)| Drift { integral: integral.clone(), change };
        changes.filter(|(_, exists)| *exists).map(|(found, _)| drift(found)).collect()
    }

    /// Largest absolute change of each first integral from its first value over the samples of a run, in
    /// the unit of the integral.
    #[must_use]
    pub fn changes(&self, problem: &Problem<'_>, solution: &Solution) -> Vec<f64> {
        let n = self.integrals.len();
        let (mut scratch, mut out) = (Vec::new(), vec![f64::NAN; n + self.divisors.len()]);
        let (mut first, mut largest) = (None, vec![0.0; n]);
        let samples = solution.t.iter().zip(&solution.y).chain([(&solution.t_end, &solution.y_end)]);
        for (t, y) in samples {
            let inputs = [problem.shown.parameters.clone(), problem.shown_state(*t, y)].concat();
            self.tape.evaluate_into(&inputs, &mut scratch, &mut out);
            let first = first.get_or_insert_with(|| out[..n].to_vec());
            for ((largest, value), first) in largest.iter_mut().zip(&out).zip(first.iter()) {
                *largest = larger((value - first).abs(), *largest);
            }
        }
        largest
    }

    /// Change of the first integral with the index `integral` from its first value, at each sample, in
    /// the unit of the integral.
    #[must_use]
    pub fn integral_changes(&self, problem: &Problem<'_>, solution: &Solution, integral: usize) -> Vec<f64> {
        let (mut scratch, mut out) = (Vec::new(), vec![f64::NAN; self.integrals.len() + self.divisors.len()]);
        let mut value = |(t, y): (&f64, &Vec<f64>)| {
            let inputs = [problem.shown.parameters.clone(), problem.shown_state(*t, y)].concat();
            self.tape.evaluate_into(&inputs, &mut scratch, &mut out);
            out[integral]
        };
        let values: Vec<f64> = solution.t.iter().zip(&solution.y).map(&mut value).collect();
        values.iter().map(|x| x - values[0]).collect()
    }

    /// Finds for each first integral the instant at which its change is largest relative to the allowed
    /// change. `allowance` gives the allowed error of a component of (q, u), from its index and value.
    /// About `samples` states of the run are examined.
    pub fn worst_excursions(
        &self,
        problem: &Problem<'_>,
        solution: &Solution,
        samples: usize,
        allowance: &dyn Fn(usize, f64) -> f64,
    ) -> Vec<Excursion> {
        let n = self.integrals.len();
        let mut worst = vec![Excursion::default(); n];
        let p = &problem.shown.parameters;
        let mut scratch = Vec::new();
        let mut value = |state: &[f64]| {
            let mut out = vec![f64::NAN; n + self.divisors.len()];
            self.tape.evaluate_into(&[p.as_slice(), state].concat(), &mut scratch, &mut out);
            out.truncate(n);
            out
        };
        let first = solution.t.first().zip(solution.y.first()).unwrap_or((&solution.t_end, &solution.y_end));
        let start = value(&problem.shown_state(*first.0, first.1));
        let every = solution.y.len().div_ceil(samples).max(1);
        for (t, y) in solution.t.iter().zip(&solution.y).step_by(every).chain([(&solution.t_end, &solution.y_end)]) {
            let mut state = problem.shown_state(*t, y);
            let here = value(&state);
            let terms = self.tape.largest_terms(&[p.as_slice(), &state].concat());
            let mut allowed = vec![0.0; n];
            for at in 0..state.len() {
                let kept = state[at];
                state[at] += allowance(at, kept);
                for ((sum, moved), here) in allowed.iter_mut().zip(value(&state)).zip(&here) {
                    *sum += (moved - here).abs();
                }
                state[at] = kept;
            }
            for (at, worst) in worst.iter_mut().enumerate() {
                let change = (here[at] - start[at]).abs();
                // The terms of a sum are rounded, so no value is known better than this.
                let rounding = ROUNDINGS * f64::EPSILON * terms[at].max(start[at].abs()).max(1e-290);
                let ratio = change / allowed[at].max(rounding);
                // An integral without a value counts as violated.
                let ratio = if ratio.is_nan() { f64::INFINITY } else { ratio };
                if ratio > worst.ratio {
                    *worst = Excursion { t: *t, change, ratio };
                }
            }
        }
        worst
    }

    /// Computes the first integrals and the absolute values of the divisors at the given states (q, u).
    /// The first result has a list for each integral. The second result has a list for each divisor.
    #[must_use]
    pub fn invariants_along_states(&self, parameters: &[f64], states: &[Vec<f64>]) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let mut list = vec![Vec::with_capacity(states.len()); self.integrals.len() + self.divisors.len()];
        let (mut scratch, mut out) = (Vec::new(), vec![f64::NAN; list.len()]);
        for state in states {
            self.tape.evaluate_into(&[parameters, state].concat(), &mut scratch, &mut out);
            for (values, value) in list.iter_mut().zip(&out) {
                values.push(*value);
            }
        }
        let divisors = list.split_off(self.integrals.len());
        (list, divisors.into_iter().map(|values| values.into_iter().map(f64::abs).collect()).collect())
    }
}

impl InvariantValues {
    /// Finds the least number in `values`, which has one value for each sample. Returns it with its
    /// instant, s. Values that are NaN are ignored; `None` if all are.
    #[must_use]
    pub fn least(&self, values: &[f64]) -> Option<(f64, f64)> {
        let pairs = values.iter().copied().zip(self.t.iter().copied()).filter(|(x, _)| !x.is_nan());
        pairs.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Absolute determinant |det A| at each sample, divided by its value at the first sample. A is the
    /// matrix of the linear system for the accelerations.
    #[must_use]
    pub fn relative_determinant(&self) -> Vec<f64> {
        let start = self.determinant.first().copied().unwrap_or(f64::NAN);
        self.determinant.iter().map(|det| (det / start).abs()).collect()
    }

    /// Absolute change of the first integral with the index `integral` since the first sample, at each
    /// sample, in the unit of the integral.
    #[must_use]
    pub fn changes(&self, integral: usize) -> Vec<f64> {
        let values = &self.integrals[integral];
        values.iter().map(|x| (x - values[0]).abs()).collect()
    }

    /// Largest absolute change of each first integral over the samples, in the unit of the integral. NaN
    /// if a sample has no value.
    #[must_use]
    pub fn largest_changes(&self) -> Vec<f64> {
        (0..self.integrals.len()).map(|at| self.changes(at).into_iter().fold(0.0, larger)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_pass_over_what_has_no_value() {
        let course = InvariantValues {
            t: vec![0.0, 1.0, 2.0],
            integrals: vec![vec![1.0, 3.0, 0.5], vec![1.0, f64::NAN, 1.0], vec![2.0; 3]],
            determinant: vec![-4.0, -1.0, -2.0],
            condition: vec![f64::NAN, 0.5, 0.25],
            divisors: vec![vec![f64::NAN; 3]],
        };
        assert_eq!(course.least(&course.condition), Some((0.25, 2.0)));
        assert_eq!(course.least(&course.divisors[0]), None);
        assert_eq!(course.relative_determinant(), [1.0, 0.25, 0.5]);
        assert_eq!(course.changes(0), [0.0, 2.0, 0.5]);
        let changes = course.largest_changes();
        assert_eq!(format!("{changes:?}"), "[2.0, NaN, 0.0]", "a sample without a value is no change of 0");
    }
}
