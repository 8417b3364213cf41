//! Problem of one point of a sweep, and the results of its run.

use super::sweep_row::RunEnd;
use crate::error::{Error, refused_scene_error};
use crate::preparation::problem::Problem;
use crate::simulation::shown_quantities::ShownQuantities;
use crate::trust::correct_digits::{FEW, estimate_digits};
use crate::trust::objections_without_digits;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use crate::trust::watched_invariants::WatchedInvariants;
use tripos_derive::prove::IntegralKind;
use tripos_sim::{Options, Solution};

/// Conserved quantities whose changes the rows of a sweep state.
#[derive(Clone, Copy)]
pub enum ConservedColumns<'a> {
    /// Proved first integrals of the model.
    Integrals(&'a WatchedInvariants),
    /// Energy T + V alone.
    Energy,
    /// No quantity, because none is known to be constant.
    Nothing,
}

impl<'a> ConservedColumns<'a> {
    /// Names of the quantities, in the order of their columns.
    pub fn names(self) -> Vec<&'a str> {
        match self {
            Self::Integrals(watch) => watch.integrals.iter().map(|integral| integral.name.as_str()).collect(),
            Self::Energy => vec!["energy T + V"],
            Self::Nothing => Vec::new(),
        }
    }

    /// Largest change of each quantity over a run, in its unit.
    ///
    /// # Errors
    /// [`Error`] if the equations refuse the parameters of the problem.
    fn changes(self, problem: &Problem<'_>, solution: &Solution) -> Result<Vec<f64>, Error> {
        Ok(match self {
            Self::Integrals(watch) => watch.changes(problem, solution),
            Self::Energy => {
                let dynamics = problem.dynamics().map_err(|error| refused_scene_error(problem.scene, &error))?;
                vec![dynamics.energy_drift(solution)]
            }
            Self::Nothing => Vec::new(),
        })
    }

    /// Objections to a run whose changes of the quantities are `changes`, and to other errors that the run shows.
    ///
    /// # Errors
    /// [`Error`] if the equations refuse the parameters of the problem.
    fn objections(self, problem: &Problem<'_>, solution: &Solution, changes: &[f64]) -> Result<Vec<String>, Error> {
        let (watch, energy_drift) = match self {
            Self::Integrals(watch) => {
                let energy = watch.integrals.iter().position(|integral| integral.kind == IntegralKind::Energy);
                (Some(watch), energy.map(|at| changes[at]))
            }
            Self::Energy => (None, Some(changes[0])),
            Self::Nothing => (None, None),
        };
        objections_without_digits(problem, solution, watch, energy_drift)
    }

    /// Tells for each quantity if it exists at the parameters of a problem.
    fn exist(self, problem: &Problem<'_>) -> Vec<bool> {
        match self {
            Self::Integrals(watch) => watch.integrals_exist(&problem.shown.parameters),
            Self::Energy => vec![true],
            Self::Nothing => Vec::new(),
        }
    }
}

/// Problem of a point with the functions that its run needs.
pub struct PointProblem<'a, 'p> {
    /// Scene of the point with its equations.
    pub problem: &'a Problem<'p>,
    /// Events and domain conditions that the run watches.
    pub balance: &'a WatchedFunctions,
    /// Functions that compute the shown quantities. `None` for reduced equations, which compute them themselves.
    pub shown: Option<&'a ShownQuantities>,
    /// Solution that was already computed; `None` if the point is still to be run.
    pub solution: Option<Solution>,
}

impl PointProblem<'_, '_> {
    /// Runs the point, and returns the results of its row. The shown quantities have the names `names`. With
    /// `tells_digits`, a second run determines the number of correct digits.
    ///
    /// # Errors
    /// [`Error`] if the run cannot start.
    pub fn run_end(
        &self,
        names: &[String],
        conserved: ConservedColumns<'_>,
        options: &Options,
        tells_digits: bool,
    ) -> Result<RunEnd, Error> {
        if let Some(solution) = self.solution.as_ref().filter(|_| !tells_digits) {
            return self.results(names, conserved, solution, None);
        }
        let Self { problem, balance, .. } = self;
        let y0 = problem.start()?;
        let solution = match &self.solution {
            Some(solution) => solution.clone(),
            None => problem.solve(&y0, options, &mut watched_events(problem, balance), None)?,
        };
        let values = |problem: &Problem<'_>, t: f64, y: &[f64]| self.shown_values(problem, t, y);
        let digits =
            if tells_digits { estimate_digits(problem, &y0, options, &solution, &values, balance)? } else { None };
        self.results(names, conserved, &solution, digits.and_then(|digits| digits.digits_at_end_least()))
    }

    /// Values of the shown quantities at the instant `t`, s, in the integrated state `y`.
    fn shown_values(&self, problem: &Problem<'_>, t: f64, y: &[f64]) -> Result<Vec<f64>, Error> {
        match self.shown {
            Some(shown) => shown.of(problem, t, y),
            None => Ok(problem.shown_state(t, y)),
        }
    }

    /// Reasons why the numbers of the run cannot be trusted, joined by semicolons; `None` if there are none.
    /// `digits` is the number of correct digits, if known.
    ///
    /// # Errors
    /// [`Error`] if the equations refuse the parameters of the problem.
    fn warning(
        &self,
        conserved: ConservedColumns<'_>,
        solution: &Solution,
        changes: &[f64],
        digits: Option<f64>,
    ) -> Result<Option<String>, Error> {
        let names = self.problem.variable_names();
        let mut list: Vec<String> = solution.warnings.iter().map(|warning| warning.warning_text(&names)).collect();
        if digits.is_some_and(|digits| digits < FEW) {
            list.push("fewer than three digits are right at the end".to_owned());
        }
        list.extend(conserved.objections(self.problem, solution, changes)?);
        Ok((!list.is_empty()).then(|| list.join("; ")))
    }

    /// Collects the results of the run at its end: shown quantities, changes of conserved quantities,
    /// counts and failures. `digits` is the number of correct digits, if known.
    fn results(
        &self,
        names: &[String],
        conserved: ConservedColumns<'_>,
        solution: &Solution,
        digits: Option<f64>,
    ) -> Result<RunEnd, Error> {
        let problem = self.problem;
        let changes = conserved.changes(problem, solution)?;
        let all = self.shown_values(problem, solution.t_end, &solution.y_end)?;
        // Full equations compute all states, also if a scene shows its outputs alone.
        let value = |name: &String| {
            let shown = self.shown.and_then(|shown| shown.names.iter().position(|other| other == name));
            shown.map(|at| all[at])
        };
        let shown = match self.shown {
            Some(_) => names.iter().map(|name| value(name).unwrap_or(f64::NAN)).collect(),
            None => all,
        };
        let failed = solution.stop.is_failure().then(|| solution.stop.described(&problem.variable_names()));
        let without = shown.iter().position(|x| !x.is_finite());
        let missing = || without.map(|at| format!("`{}` has no value at the end", names[at]));
        let mut both = changes.iter().zip(conserved.exist(problem));
        let lost = both.any(|(change, exists)| change.is_nan() && exists);
        let unkept = || lost.then(|| "a conserved quantity of this motion is not a finite number".to_owned());
        let failure = failed.or_else(missing).or_else(unkept);
        let warning = if failure.is_none() { self.warning(conserved, solution, &changes, digits)? } else { None };
        Ok(RunEnd {
            t_end: solution.t_end,
            stop: solution.stop.code(),
            failure,
            warning,
            shown,
            steps: solution.steps,
            rejected: solution.rejected,
            evaluations: solution.evaluations,
            changes,
            digits,
        })
    }
}
