//! Complete work-precision chart of a scene: the span of the chart, the reference and the measurements.

use super::{ChartPlan, ChartReference, Measurement, measure_cases};
use crate::code::{CodePreparation, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::integration_options;
use crate::mechanism::Mechanism;
use crate::observer::Progress;
use crate::preparation::problem::Problem;
use crate::studies::chart_case::{PrintedEquationsChoice, cases};
use crate::trust::compared_quantities::ComparedQuantities;
use crate::trust::reference_solution::ReferenceSolution;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use crate::trust::watched_invariants::WatchedInvariants;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::Scene;
use tripos_sim::{Method, Options, OutputOption, Stop};
use tripos_traits::Real;

/// Complete work-precision chart of a scene: the measurements, with the reference that gives the errors.
pub struct SceneChart {
    /// All measured points of the chart, in the order of the cases.
    pub list: Vec<Measurement>,
    /// Reference solution in higher precision, which gives the errors of the runs.
    pub reference: ReferenceSolution,
    /// First integrals of the motion, whose changes over each run are measured.
    pub watch: WatchedInvariants,
    /// Sentence that names the compared quantities; `None` if runs are compared in all states.
    pub compared: Option<String>,
    /// Instant at which the errors are measured, s.
    pub until: f64,
    /// Reason why errors are measured before the end of the scene; `None` if they are measured at its end.
    pub cut: Option<String>,
    /// Cases that could not be measured: a sentence for each, with the reason.
    pub left_out: Vec<String>,
}

/// Measures the chart of a scene, up to the end of its span. If the motion leaves the domain of its
/// equations or meets a terminal event earlier, the chart ends shortly before that instant.
///
/// # Errors
/// [`Error`] if no equations of the scene can be run, or if its start is outside the domain.
pub fn chart_scene(
    model: &Mechanism,
    scene: &Scene,
    printed: PrintedEquationsChoice,
    plan: &ChartPlan,
    bar: &dyn Progress,
) -> Result<SceneChart, Error> {
    model.require_speeds("the model has no equations of motion to compare methods on")?;
    let mut scene = scene.clone();
    bar.set_message("reference");
    let (mut cases, mut left_out) = cases(model, &scene, printed)?;
    let mut compared = ComparedQuantities::new(model, &scene)?;
    let in_words = compared.in_words();
    if compared.is_empty() {
        // States of the whole model determine no requested output, so the states themselves are compared.
        scene.states_outputs = false;
        compared = ComparedQuantities::new(model, &scene)?;
        cases.retain(|case| case.reduction.is_none());
    }
    let mut cut = None;
    if let Some(t) = chart_end_instant(model, &scene, &cases[0].by)? {
        let (from, to) = scene.span;
        if t - from == 0.0 {
            let help = "choose another start: `tripos simulate` says which condition does not hold".to_owned();
            return Err(Error::request("the start is outside the domain of the model's equations".to_owned(), help));
        }
        scene.span.1 = from + (t - from) * 0.99;
        cut = Some(format!(
            "the motion ends at t = {} s of {to} s, where it leaves the domain or meets a terminal event: charted to t = {} s",
            with_reliable_digits(t, None),
            with_reliable_digits(scene.span.1, None)
        ));
    }
    let reference = ReferenceSolution::new(model, &scene, &[scene.span.1])?;
    let right = compared.comparable_quantities(compared.quantities_of_state(reference.end()));
    if right.iter().any(|x| !x.to_f64().is_finite()) {
        let what = format!(
            "the scene's outputs have no value at t = {} s: there is nothing to compare",
            with_reliable_digits(scene.span.1, None)
        );
        return Err(Error::Stopped(what));
    }
    let watch = WatchedInvariants::of_model(model)?;
    let truth = ChartReference { reference: &reference, compared: &compared, watch: &watch };
    let measured = measure_cases(model, &scene, &cases, plan, &truth, bar)?;
    left_out.extend(measured.left_out);
    let list = measured.list;
    Ok(SceneChart { list, compared: in_words, reference, watch, until: scene.span.1, cut, left_out })
}

/// Finds the instant, s, at which the motion leaves the domain of its equations or meets a terminal
/// event. `None` if neither happens before the end of the span.
///
/// # Errors
/// `Error` if the scene cannot be run.
fn chart_end_instant(model: &Mechanism, scene: &Scene, by: &EquationsOrigin) -> Result<Option<f64>, Error> {
    let code = runnable_code(model, by, scene.integration.distance, CodePreparation::Solved)?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let balance = WatchedFunctions::new(model, model, scene, by)?;
    let mut events = watched_events(&problem, &balance);
    let how = Options {
        method: Method::Ode45,
        output: OutputOption::Ends,
        rtol: 1e-9,
        step: None,
        ..integration_options(scene)
    };
    let solution =
        problem.integrate(&problem.start()?, &how, &mut events).map_err(|error| refused_scene_error(scene, &error))?;
    Ok(matches!(solution.stop, Stop::Event { .. } | Stop::LeftDomain { .. }).then_some(solution.t_end))
}
