//! What came out of one run of a scene.

use crate::code::{Code, Form};
use crate::digits::Digits;
use crate::error::{Error, refused};
use crate::invariants::{Course, Drift, Watch};
use crate::problem::Problem;
use crate::residuals::Residual;
use tripos_derive::mechanics::By;
use tripos_derive::scene::{Scene, Solve};
use tripos_sim::{Dynamics, EventRecord, ImpactRecord, Kind, Solution};

/// What came out of a run.
pub struct Run {
    /// Which equations ran.
    pub by: By,
    /// What ran them.
    pub code: Form,
    /// How accelerations were found.
    pub solve: Solve,
    /// The integrator's result.
    pub solution: Solution,
    /// Why it ended, with the names of its variables.
    pub why: String,
    /// When, after how many steps and why it ended, in a sentence.
    pub ending: String,
    /// What has no value, and when first; set by [`Run::look_for_missing`].
    pub(crate) missing: Option<String>,
    /// What is shown of a state: the names of coordinates and generalized speeds, or of the outputs of a scene.
    pub names: Vec<String>,
    /// Their values at each sample.
    pub states: Vec<Vec<f64>>,
    /// Kinetic and potential energy at each sample; nothing where a scene shows outputs of its own.
    pub energies: Vec<(f64, f64)>,
    /// What is shown at the end.
    pub end: Vec<f64>,
    /// How many digits of what is shown are right; nothing if the run took no step or was interrupted.
    pub digits: Option<Digits>,
    /// Largest change of total energy over the samples, J, if it is known.
    pub energy_drift: Option<f64>,
    /// How much each first integral that was watched changed.
    pub drifts: Vec<Drift>,
    /// How far the run is from the constraints that it is kept on.
    pub residuals: Vec<Residual>,
    /// What a reader may want to know of how the run was made; no reason to distrust it.
    pub notes: Vec<String>,
    /// What a reader must know before trusting the numbers.
    pub warnings: Vec<String>,
}

impl Run {
    /// The values of what is shown under this name, at each sample.
    ///
    /// # Errors
    /// [`Error::Request`] if nothing of this name is shown.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, Error> {
        let at = self.names.iter().position(|shown| shown == name).ok_or_else(|| {
            let known = self.names.iter().map(String::as_str);
            Error::request(format!("the run shows no `{name}`"), tripos_derive::diagnostic::nearest(name, known))
        })?;
        Ok(self.states.iter().map(|values| values[at]).collect())
    }

    /// The samples in order: the time, s, and the values of what is shown, in the order of [`Run::names`].
    pub fn samples(&self) -> impl Iterator<Item = (f64, &[f64])> {
        self.solution.t.iter().copied().zip(self.states.iter().map(Vec::as_slice))
    }

    /// The events and the conditions of the domain that the run met, in order, with their instants and states.
    #[must_use]
    pub fn events(&self) -> &[EventRecord] {
        &self.solution.events
    }

    /// The impacts of the run, in order.
    #[must_use]
    pub fn impacts(&self) -> &[ImpactRecord] {
        &self.solution.impacts
    }

    /// The estimated error of the instant of an impact, s; nothing where it was not assessed, and of one at the start.
    #[must_use]
    pub fn error_of_impact(&self, impact: &ImpactRecord) -> Option<f64> {
        let at = self
            .solution
            .events
            .iter()
            .position(|event| event.t.total_cmp(&impact.t).is_eq() && event.kind == Kind::Falling)?;
        self.digits.as_ref().and_then(|digits| digits.events[at])
    }

    /// Why the run must not be trusted to the end that was asked for, a reason a line; nothing if it can be.
    #[must_use]
    pub fn objections(&self) -> Vec<String> {
        self.failure().into_iter().chain(self.warnings.iter().cloned()).collect()
    }

    /// Whether the run can be trusted to its end: nothing objects to it, and its digits were assessed.
    #[must_use]
    pub fn is_trusted(&self) -> bool {
        self.objections().is_empty() && self.digits.as_ref().is_none_or(Digits::is_complete)
    }

    /// Why the run could not go on, or what it does not give; nothing if it gives all that was asked for.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        if self.solution.stop.is_failure() { Some(self.ending.clone()) } else { self.missing.clone() }
    }

    /// Looks whether all that is shown has a value, as it is shown now.
    ///
    /// # Errors
    /// As [`Problem::near_divisors`].
    pub(crate) fn look_for_missing(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.missing = None;
        let Solution { t, y, t_end, y_end, .. } = &self.solution;
        // The last sample is the end, unless only some instants were asked for.
        let end = Some(((t_end, y_end), &self.end)).filter(|_| t.last() != Some(t_end));
        let samples = t.iter().zip(y).zip(&self.states).chain(end);
        let without = samples.filter_map(|(at, values)| Some((at, values.iter().position(|x| !x.is_finite())?)));
        let mut without = without.peekable();
        let Some(&((t, y), which)) = without.peek() else {
            let lost = self.energy_drift.is_some_and(f64::is_nan);
            self.missing = lost.then(|| "the energy has no value that doubles can hold".to_owned());
            return Ok(());
        };
        let more = without.count() - 1;
        let more = if more == 0 { String::new() } else { format!(" and at {more} of the samples after it") };
        let near = problem.near_divisors(y)?;
        self.missing = Some(format!("`{}` has no value at t = {t} s{more}{near}", self.names[which]));
        Ok(())
    }

    /// Everything watched along the run, which was by this code.
    ///
    /// # Errors
    /// [`Error::Request`] if the parameters are not those of the equations.
    pub fn course(&self, watch: &Watch, scene: &Scene, code: &Code) -> Result<Course, Error> {
        let (integrals, divisors) = watch.along(&scene.parameters, &self.states);
        let (mut determinant, mut condition) = (Vec::new(), Vec::new());
        // A scene's own equations are solved: they have no matrix, and parameters of their own.
        if !self.by.is_reduced() {
            let mut dynamics =
                Dynamics::new(code.system(), &scene.parameters).map_err(|error| refused(scene, &error))?;
            for y in &self.solution.y {
                let (q, v) = y.split_at(code.system().lengths().coordinates.min(y.len()));
                determinant.push(dynamics.determinant(q, v));
                condition.push(dynamics.reciprocal_condition(q, v));
            }
        }
        Ok(Course { t: self.solution.t.clone(), integrals, determinant, condition, divisors })
    }
}
