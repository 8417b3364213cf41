//! Result of a run of a scene, with its checks.

use crate::code::{Code, CodeForm};
use crate::error::{Error, refused_scene_error};
use crate::preparation::problem::Problem;
use crate::trust::constraint_residuals::Residual;
use crate::trust::correct_digits::CorrectDigits;
use crate::trust::watched_invariants::{Drift, InvariantValues, WatchedInvariants};
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::{Dynamics, EventRecord, ImpactRecord, Kind, Solution};

/// Result of a run of a scene: states, estimated errors and checks.
pub struct Run {
    /// Equations of motion that were integrated: a formulation, printed or reduced equations.
    pub by: EquationsOrigin,
    /// Form of the code that was run, such as compiled or interpreted.
    pub code: CodeForm,
    /// Method that found the accelerations: eliminated, or solved for numerically.
    pub solve: AccelerationSolution,
    /// Solution that the integrator returned, in the variables that were integrated.
    pub solution: Solution,
    /// Reason why the run ended, in words.
    pub why: String,
    /// Sentence that says when, after how many steps and why the run ended.
    pub ending: String,
    /// Sentence that names the first shown quantity without a finite value, and its instant. `None` if
    /// all have finite values. It is set by [`Run::find_missing_values`].
    pub(crate) missing: Option<String>,
    /// Names of the shown quantities: coordinates and generalized speeds, or the outputs of a scene.
    pub names: Vec<String>,
    /// Values of the shown quantities at each sample: one list for each sample, in the order of
    /// `names`.
    pub states: Vec<Vec<f64>>,
    /// Kinetic and potential energy at each sample, J. Empty if the scene requests its own outputs.
    pub energies: Vec<(f64, f64)>,
    /// Values of the shown quantities at the end of the run, in the order of `names`.
    pub end: Vec<f64>,
    /// Estimated errors and correct digits of the shown quantities; `None` if the run took no step
    /// or was interrupted.
    pub digits: Option<CorrectDigits>,
    /// Largest change of the total energy over the samples, J; `None` if it is not known.
    pub energy_drift: Option<f64>,
    /// Largest change of each watched first integral (a quantity that stays constant).
    pub drifts: Vec<Drift>,
    /// Largest residuals of the constraints that the run enforces.
    pub residuals: Vec<Residual>,
    /// Notes on how the run was made. They are no reasons to distrust it.
    pub notes: Vec<String>,
    /// Warnings about the numbers of the run, one text for each.
    pub warnings: Vec<String>,
}

impl Run {
    /// Returns the values of the shown quantity `name` at all samples, in the order of time.
    ///
    /// # Errors
    /// [`Error::Request`] if the run does not show this quantity.
    pub fn column_of_quantity(&self, name: &str) -> Result<Vec<f64>, Error> {
        let at = self.names.iter().position(|shown| shown == name).ok_or_else(|| {
            let known = self.names.iter().map(String::as_str);
            Error::request(
                format!("the run shows no `{name}`"),
                tripos_derive::diagnostic::nearest_name_advice(name, known),
            )
        })?;
        Ok(self.states.iter().map(|values| values[at]).collect())
    }

    /// Iterates over the samples: the instant, s, and the shown values in the order of [`Run::names`].
    pub fn samples(&self) -> impl Iterator<Item = (f64, &[f64])> {
        self.solution.t.iter().copied().zip(self.states.iter().map(Vec::as_slice))
    }

    /// Events of the run in order, each with its instant and state. They include crossings of domain
    /// conditions.
    #[must_use]
    pub fn events(&self) -> &[EventRecord] {
        &self.solution.events
    }

    /// Impacts of the run, in the order of time.
    #[must_use]
    pub fn impacts(&self) -> &[ImpactRecord] {
        &self.solution.impacts
    }

    /// Estimated error of the instant of an impact, s. `None` if it was not estimated, or for an impact
    /// at the start.
    #[must_use]
    pub fn error_of_impact(&self, impact: &ImpactRecord) -> Option<f64> {
        let at = self
            .solution
            .events
            .iter()
            .position(|event| event.t.total_cmp(&impact.t).is_eq() && event.kind == Kind::Falling)?;
        self.digits.as_ref().and_then(|digits| digits.events[at])
    }

    /// Reasons not to trust the run to its requested end, one text for each. Empty if the run can be
    /// trusted.
    #[must_use]
    pub fn objections(&self) -> Vec<String> {
        self.failure().into_iter().chain(self.warnings.iter().cloned()).collect()
    }

    /// True if the run can be trusted to its end: there are no objections, and the errors, if any, were
    /// estimated to the end.
    #[must_use]
    pub fn is_trusted(&self) -> bool {
        self.objections().is_empty() && self.digits.as_ref().is_none_or(CorrectDigits::is_complete)
    }

    /// Sentence that says why the run could not go on, or which quantity has no value. `None` if the run
    /// is complete.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        if self.solution.stop.is_failure() { Some(self.ending.clone()) } else { self.missing.clone() }
    }

    /// Looks for a shown quantity without a finite value, and stores a sentence about it in `missing`.
    ///
    /// # Errors
    /// Errors of [`Problem::near_divisors`].
    pub(crate) fn find_missing_values(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.missing = None;
        let Solution { t, y, t_end, y_end, .. } = &self.solution;
        // The last sample is the end, unless only certain instants were requested.
        let end = Some(((t_end, y_end), &self.end)).filter(|_| t.last() != Some(t_end));
        let samples = t.iter().zip(y).zip(&self.states).chain(end);
        let without = samples.filter_map(|(at, values)| Some((at, values.iter().position(|x| !x.is_finite())?)));
        let mut without = without.peekable();
        let Some(&((t, y), which)) = without.peek() else {
            let lost = self.energy_drift.is_some_and(f64::is_nan);
            self.missing = lost.then(|| "the energy is not a finite number".to_owned());
            return Ok(());
        };
        let more = without.count() - 1;
        let more = if more == 0 { String::new() } else { format!(" and at {more} of the samples after it") };
        let near = problem.near_divisors(y)?;
        self.missing = Some(format!(
            "`{}` has no value at t = {} s{more}{near}",
            self.names[which],
            with_reliable_digits(*t, None)
        ));
        Ok(())
    }

    /// Computes the values of all watched quantities at the samples of the run. `code` is the code that
    /// made the run.
    ///
    /// # Errors
    /// [`Error::Request`] if the number of parameters does not fit the equations.
    pub fn course(&self, watch: &WatchedInvariants, scene: &Scene, code: &Code) -> Result<InvariantValues, Error> {
        let (integrals, divisors) = watch.invariants_along_states(&scene.parameters, &self.states);
        let (mut determinant, mut condition) = (Vec::new(), Vec::new());
        // Reduced equations of a scene are already solved for the rates. They have no matrix, and other
        // parameters.
        if !self.by.is_reduced() {
            let mut dynamics =
                Dynamics::new(code.system(), &scene.parameters).map_err(|error| refused_scene_error(scene, &error))?;
            for y in &self.solution.y {
                let (q, v) = y.split_at(code.system().lengths().coordinates.min(y.len()));
                determinant.push(dynamics.determinant(q, v));
                condition.push(dynamics.reciprocal_condition(q, v));
            }
        }
        Ok(InvariantValues { t: self.solution.t.clone(), integrals, determinant, condition, divisors })
    }
}
