//! Derivatives of runs that change their speeds on the way, as differences of whole runs.
//!
//! Equations in chosen speeds carry slopes along a run. Near a state where these speeds fail, slopes would be divided
//! by a number that vanishes there. The run itself passes such states in the rates of all coordinates. So it is
//! repeated with eight other values of a number, at finer tolerances, and the derivative is a difference of order 4.
//! Its error comes from the same rule with twice the step, and from the errors of the runs divided by the step.

use super::difference::CENTRAL;
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::simulation::run::Run;
use crate::simulation::simulate::run_whole;
use tripos_derive::mechanics::By;
use tripos_derive::model::Unit;
use tripos_derive::scene::{ENERGIES, Nearby, Scene};
use tripos_traits::{AbsoluteTolerance, DoubleDouble, Real, Scalar, larger};

/// Step of the differences of runs, relative to the size of the number that changes.
const STEP: f64 = 1.0 / 1024.0;
/// Least size of a number of the start, in its unit: a smaller number counts as this size. The step of a parameter that
/// is not zero is always relative to its own size.
const LEAST: f64 = 0.01;
/// Factor from the tolerances of a run to those of the runs with other values, whose differences give its derivatives.
const FINER: f64 = 0.01;
/// Least tolerance of the runs whose differences give a derivative.
const FINEST: f64 = 1e-13;

/// Text that tells how derivatives by differences of runs were found.
pub const WORDS: &str = "differences of eight runs beside this one, since it changes its speeds";

/// Request for derivatives by differences of runs: quantities, scene and equations.
pub struct Apart<'a> {
    pub mechanism: &'a Mechanism,
    pub scene: &'a Scene,
    /// Names and values of numbers that were set and differ from the scene file.
    pub set: &'a [(String, f64)],
    pub by: &'a By,
    /// Names of the differentiated quantities: states, outputs and energies at the end.
    pub names: &'a [String],
}

/// Derivatives of all requested quantities by one number.
pub struct Difference {
    /// Unit of the number.
    pub unit: Unit,
    /// Derivative of each requested quantity at the end of the run.
    pub values: Vec<f64>,
    /// Error of each derivative; `None` if an error is not known.
    pub errors: Option<Vec<f64>>,
    /// Derivative of the instant at which the run ends.
    pub t_end: f64,
    /// Derivatives of the instants of events; `None` if another run has a different number of events.
    pub events: Option<Vec<f64>>,
}

/// Results of one run: values at its end with their errors, the instant of the end, and the instants of events.
struct Told {
    values: Vec<f64>,
    errors: Option<Vec<f64>>,
    t_end: f64,
    events: Vec<f64>,
}

impl Apart<'_> {
    /// Computes the derivatives by the number with the given name, for a run that was made.
    ///
    /// # Errors
    /// [`Error::Input`] for a name that is no number of the scene; [`Error::Stopped`] if another run ends for a
    /// different reason.
    pub fn by(&self, name: &str, run: &Run) -> Result<Difference, Error> {
        let mut nearby = Nearby::new(self.scene, self.mechanism, self.set, name)?;
        let (value, unit) = (nearby.value(), nearby.unit());
        let size = value.to_f64().abs();
        let is_parameter = self.mechanism.parameters.iter().any(|p| p.name == name);
        let step = STEP * if is_parameter && size > 0.0 { size } else { size.max(LEAST) };
        let mut at = |place: i32| -> Result<Told, Error> {
            let scene = nearby.at(value + DoubleDouble::from_f64(step) * DoubleDouble::int(i64::from(place)))?;
            self.told(&finer(scene), run)
        };
        let narrow = CENTRAL.iter().map(|(place, _)| at(*place)).collect::<Result<Vec<_>, _>>()?;
        let wide = CENTRAL.iter().map(|(place, _)| at(2 * place)).collect::<Result<Vec<_>, _>>()?;
        let of = |list: &[Told], step: f64, pick: &dyn Fn(&Told) -> f64| {
            let terms = list.iter().zip(CENTRAL).map(|(told, (_, weight))| weight as f64 * pick(told));
            terms.sum::<f64>() / (12.0 * step)
        };
        let rounded = |at: usize| {
            let errors = narrow.iter().map(|told| told.errors.as_ref().map(|errors| errors[at]));
            errors.collect::<Option<Vec<f64>>>().map(|list| 1.5 * list.into_iter().fold(0.0, larger) / step)
        };
        let (mut values, mut errors) = (Vec::new(), Some(Vec::new()));
        for at in 0..self.names.len() {
            let pick = |told: &Told| told.values[at];
            let (value, other) = (of(&narrow, step, &pick), of(&wide, 2.0 * step, &pick));
            values.push(value);
            errors = errors.zip(rounded(at)).map(|(mut list, rounded)| {
                list.push((value - other).abs() + rounded);
                list
            });
        }
        let count = run.solution.events.len();
        let has_events = narrow.iter().all(|told| told.events.len() == count);
        let events = has_events.then(|| (0..count).map(|at| of(&narrow, step, &|told| told.events[at])).collect());
        Ok(Difference { unit, values, errors, t_end: of(&narrow, step, &|told| told.t_end), events })
    }

    /// Runs a scene with a changed number. The error says if this run ends for another reason than `first`.
    fn told(&self, scene: &Scene, first: &Run) -> Result<Told, Error> {
        let run = run_whole(self.mechanism, scene, self.by, None)?;
        if run.solution.stop.code() != first.solution.stop.code() {
            let message = format!("there are no derivatives: a run beside this one ends otherwise, {}", run.ending);
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
        Ok(Told {
            values: self.names.iter().map(value).collect(),
            errors: self.names.iter().map(error).collect(),
            t_end: run.solution.t_end,
            events: run.solution.events.iter().map(|event| event.t).collect(),
        })
    }
}

/// Gives a scene the finer tolerances of runs whose differences give a derivative.
fn finer(mut scene: Scene) -> Scene {
    let how = &mut scene.integration;
    let finer = |x: f64| if x > 0.0 { (FINER * x).max(FINEST.min(x)) } else { x };
    how.rtol = finer(how.rtol);
    how.atol = match &how.atol {
        AbsoluteTolerance::Uniform(atol) => AbsoluteTolerance::Uniform(finer(*atol)),
        AbsoluteTolerance::Each(list) => AbsoluteTolerance::Each(list.iter().map(|atol| finer(*atol)).collect()),
    };
    scene
}
