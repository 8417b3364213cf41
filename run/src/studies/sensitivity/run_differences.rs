//! Derivatives of runs that change their generalized speeds on the way, from differences with
//! neighbouring runs.
//!
//! Equations in chosen speeds carry derivatives along a run. Near a state where these speeds fail,
//! the derivatives are divided by a number that vanishes there. The run itself passes such states
//! in the rates of all coordinates. So the run is repeated at finer tolerances, with the varied
//! number above and below its value. Central differences with ever smaller steps are extrapolated to
//! step 0, until rounding errors grow. A long run may depend on a number so strongly that no fixed
//! step serves.
//!
//! Source: C. J. F. Ridders, "Accurate computation of F'(x) and F'(x) F''(x)", *Advances in
//! Engineering Software* 4 (1982) 75–76.

use super::ridders_table::RiddersTable;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::simulation::run::Run;
use crate::simulation::simulate::simulate_full_equations_watched;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::model::Unit;
use tripos_derive::scene::{ENERGIES, Scene, SceneNeighbours};
use tripos_traits::{AbsoluteTolerance, DoubleDouble, Real, Scalar, larger};

/// First change of the varied number in the differences of runs, relative to its size. Each further
/// change is half as large.
const STEP: f64 = 1.0 / 256.0;
/// Greatest number of changes of a varied number that are tried, each half as large as the last.
const MOST_STEPS: usize = 14;
/// Least size, in its own unit, that is assumed for a varied number of the start, or for a parameter
/// that is zero. The step of any other parameter is relative to its own size.
const LEAST: f64 = 0.01;
/// Factor from the tolerances of a run to the tolerances of the neighbouring runs, whose differences
/// give its derivatives.
const FINER: f64 = 0.01;
/// Least tolerance of neighbouring runs, whose differences give derivatives.
const FINEST: f64 = 1e-13;

/// Text for the user that says how derivatives were found: by differences with neighbouring runs.
pub const WORDS: &str = "differences with neighbouring runs, since this run changes its speeds";

/// Request for derivatives by differences of runs: the scene, its equations and the wanted quantities.
pub struct RunDifferences<'a> {
    /// Mechanism of the scene.
    pub mechanism: &'a Mechanism,
    /// Scene whose run is differentiated.
    pub scene: &'a Scene,
    /// Names and values of the numbers that differ from the scene file.
    pub set: &'a [(String, f64)],
    /// Origin of the equations of motion.
    pub by: &'a EquationsOrigin,
    /// Names of the differentiated quantities at the end of the run: states, outputs and energies.
    pub names: &'a [String],
}

/// Derivatives of all requested quantities by one varied number, from differences of runs.
pub struct DerivativesByDifferences {
    /// Unit of the varied number.
    pub unit: Unit,
    /// Derivative of each requested quantity at the end of the run, in the order of the request.
    pub values: Vec<f64>,
    /// Estimated error of each derivative; `None` if the error of a run is not known.
    pub errors: Option<Vec<f64>>,
    /// Derivative of the instant at which the run ends, s per unit of the varied number.
    pub t_end: f64,
    /// Derivatives of the instants of the run's events, s per unit of the varied number. `None` if a
    /// neighbouring run has a different number of events.
    pub events: Option<Vec<f64>>,
}

/// Results of one run that enter the differences of runs: the values at its end, their errors, and the
/// instants of its end and events.
struct RunResults {
    /// Values of the requested quantities at the end of the run.
    values: Vec<f64>,
    /// Estimated errors of `values`; `None` if an error is unknown.
    errors: Option<Vec<f64>>,
    /// Instant at which the run ends, s.
    t_end: f64,
    /// Instants of the run's events, s.
    events: Vec<f64>,
}

impl RunDifferences<'_> {
    /// Computes the derivatives of the given run by the varied number with the given name.
    ///
    /// # Errors
    /// [`Error::Input`] if the scene has no number of this name. [`Error::Stopped`] if a neighbouring run
    /// ends for another reason than this run.
    pub fn differentiate_by(&self, name: &str, run: &Run) -> Result<DerivativesByDifferences, Error> {
        let mut nearby = SceneNeighbours::new(self.scene, self.mechanism, self.set, name)?;
        let (value, unit) = (nearby.value(), nearby.unit());
        let size = value.to_f64().abs();
        let is_parameter = self.mechanism.parameters.iter().any(|p| p.name == name);
        let size = if is_parameter && size > 0.0 { size } else { size.max(LEAST) };
        let mut at = |by: f64| -> Result<RunResults, Error> {
            let scene = nearby.at(value + DoubleDouble::from_f64(by))?;
            self.run_neighbour(&with_tolerances_for_differences(scene), run)
        };
        let count = run.solution.events.len();
        let quantities = self.names.len();
        let mut tables = vec![RiddersTable::default(); quantities + 1 + count];
        let (mut have_errors, mut have_events) = (true, true);
        let mut failure = None;
        for level in 0..MOST_STEPS {
            let step = size * STEP / f64::from(1 << level);
            // A run with a large change of the number may end for another reason, although a run with a small
            // change does not.
            let (above, below) = match at(step).and_then(|above| Ok((above, at(-step)?))) {
                Ok(pair) => pair,
                Err(error) => {
                    failure = Some(error);
                    tables.iter_mut().for_each(RiddersTable::clear);
                    continue;
                }
            };
            failure = None;
            have_errors &= above.errors.is_some() && below.errors.is_some();
            have_events = above.events.len() == count && below.events.len() == count;
            let known = |told: &RunResults, at: usize| told.errors.as_ref().map_or(0.0, |errors| errors[at]);
            for (at, table) in tables.iter_mut().enumerate() {
                let pick = |told: &RunResults| match at.checked_sub(quantities) {
                    None => told.values[at],
                    Some(0) => told.t_end,
                    Some(event) => told.events.get(event - 1).copied().unwrap_or(f64::NAN),
                };
                let rounding = if at < quantities { larger(known(&above, at), known(&below, at)) } else { 0.0 };
                table.add((pick(&above) - pick(&below)) / (2.0 * step), rounding / step);
            }
            // A neighbouring run may lack an event, and the derivative of this event then does not exist. So
            // only the other quantities prolong the search.
            if tables[..=quantities].iter().all(RiddersTable::is_done) {
                break;
            }
        }
        if let Some(error) = failure {
            return Err(error);
        }
        let best: Vec<(f64, f64)> = tables.iter().map(|table| table.best).collect();
        Ok(DerivativesByDifferences {
            unit,
            values: best[..quantities].iter().map(|(value, _)| *value).collect(),
            errors: have_errors.then(|| best[..quantities].iter().map(|(_, error)| *error).collect()),
            t_end: best[quantities].0,
            events: have_events.then(|| best[quantities + 1..].iter().map(|(value, _)| *value).collect()),
        })
    }

    /// Runs a scene with a changed number, and returns the results that enter the differences of runs.
    ///
    /// # Errors
    /// `Error::Stopped` if this run ends for another reason than the run `first`.
    fn run_neighbour(&self, scene: &Scene, first: &Run) -> Result<RunResults, Error> {
        let run = simulate_full_equations_watched(self.mechanism, scene, self.by, None)?;
        if run.solution.stop.code() != first.solution.stop.code() {
            let message = format!("derivatives do not exist: a neighbouring run ends differently, {}", run.ending);
            return Err(Error::Stopped(message));
        }
        let place = |name: &String| run.names.iter().position(|other| other == name);
        let energies = run.energies.last().copied().unwrap_or((f64::NAN, f64::NAN));
        let value = |name: &String| match place(name) {
            Some(at) => run.end[at],
            None if *name == ENERGIES[0] => energies.0,
            None => energies.1,
        };
        let known = run.digits.as_ref().and_then(|digits| digits.errors_at_end());
        // The largest known error of the states is used as the error of an energy.
        let worst = known.map(|errors| errors.iter().copied().fold(0.0, larger));
        let error = |name: &String| place(name).map_or(worst, |at| known.and_then(|errors| errors.get(at).copied()));
        Ok(RunResults {
            values: self.names.iter().map(value).collect(),
            errors: self.names.iter().map(error).collect(),
            t_end: run.solution.t_end,
            events: run.solution.events.iter().map(|event| event.t).collect(),
        })
    }
}

/// Tightens the tolerances of a scene for neighbouring runs, whose differences give derivatives.
fn with_tolerances_for_differences(mut scene: Scene) -> Scene {
    let how = &mut scene.integration;
    let finer = |x: f64| if x > 0.0 { (FINER * x).max(FINEST.min(x)) } else { x };
    how.rtol = finer(how.rtol);
    how.atol = match &how.atol {
        AbsoluteTolerance::Uniform(atol) => AbsoluteTolerance::Uniform(finer(*atol)),
        AbsoluteTolerance::Each(list) => AbsoluteTolerance::Each(list.iter().map(|atol| finer(*atol)).collect()),
    };
    scene
}
