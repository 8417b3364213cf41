//! Study of the growth of small errors. It predicts and measures the horizon: the instant after which no
//! correct digit is left.

use super::findings::{FindingRow, FindingTopic, Findings, StudyInputs};
use crate::code::{CodePreparation, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::equally_spaced_instants;
use crate::observer::require_uninterrupted;
use crate::preparation::problem::Problem;
use crate::studies::figure::{Figure, Panel, Scale, Series};
use crate::trust::reference_solution::ReferenceSolution;
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_sim::error_growth::error_growth;
use tripos_sim::work_precision::work_precision_error;
use tripos_sim::{EliminatedDynamics, Method, Options, OutputOption};
use tripos_traits::larger;

/// Number of instants at which the errors of runs are measured by the reference.
const INSTANTS: u32 = 40;
/// Relative and absolute tolerances of the runs whose horizons are predicted and measured. The horizon is
/// the instant after which no correct digit is left.
const TOLERANCES: [f64; 3] = [1e-4, 1e-7, 1e-10];

/// Predicts the growth of errors by the linearized equations, and compares the prediction with runs at
/// three tolerances. Does nothing if the accelerations are not eliminated.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn study_growth(study: &StudyInputs<'_>, findings: &mut Findings) -> Result<(), Error> {
    let (model, scene) = (study.model, study.scene);
    let by = EquationsOrigin::from(Formulation::Kane);
    let code = runnable_code(model, &by, scene.integration.distance, CodePreparation::Solved)?;
    let problem = Problem::new(model, scene, &by, &code, None)?;
    let Some(mut rhs) = EliminatedDynamics::new(problem.system(), &scene.parameters) else { return Ok(()) };
    let y0 = problem.start()?;
    let follow = Options { method: Method::Dop853, rtol: 1e-8, step_limit: 200_000, ..Options::default() };
    let found = error_growth(&mut rhs, scene.span, &y0, &vec![1.0; y0.len()], &problem.run_options(&follow))
        .map_err(|e| refused_scene_error(scene, &e))?;
    let (from, to) = scene.span;
    let times = equally_spaced_instants(scene.span, INSTANTS)[1..].to_vec();
    let reference = ReferenceSolution::new(model, scene, &times)?;
    let row = |case: String, quantity, value, expected, remark: &str| FindingRow {
        check: "growth",
        formulation: by.name(),
        solve: problem.solve.name(),
        method: Method::Dop853.name(),
        case,
        quantity,
        value,
        expected,
        remark: remark.to_owned(),
    };
    let most = found.logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    findings.rows.push(row("whole span".to_owned(), "largest growth, ln", Some(most), None, &found.stop.code()));
    let mut series = vec![Series::curve(
        "1e-16 times the growth".to_owned(),
        0,
        found.times.iter().zip(&found.logarithms).map(|(t, l)| (*t, f64::EPSILON * l.exp())).collect(),
    )];
    for (at, tolerance) in TOLERANCES.into_iter().enumerate() {
        let (steps, errors) = errors_at_instants(&problem, &y0, tolerance, &times, &reference)?;
        // Every step adds an error of its own. The prediction takes this into account.
        let predicted = found.horizon(|t| tolerance * (steps * (t - from) / (to - from)).max(1.0));
        let lost = errors.iter().find(|(_, e)| *e >= 1.0).map(|(t, _)| *t);
        let remark = if lost.is_none() { "a digit is left to the end" } else { "first instant with an error of 1" };
        findings.rows.push(row(format!("{tolerance:e}"), "horizon", lost, predicted, remark));
        for (t, e) in &errors {
            findings.rows.push(row(format!("{tolerance:e} t={t}"), "error", Some(*e), None, ""));
        }
        if let Some(t) = predicted {
            let confirmed =
                lost.map_or("a digit is left to the end".to_owned(), |t| format!("the error is 1 at t = {t:.3} s"));
            findings.add_statement(FindingTopic::Growth, format!(
                "at a tolerance of {tolerance:.0e} the growth of errors leaves no digit after t = {t:.3} s; measured: {confirmed}"
            ));
        }
        series.push(Series::curve(format!("error at {tolerance:.0e}"), at + 1, errors));
    }
    let part = if found.stop.is_failure() {
        format!("until {} ends it", found.stop.code())
    } else {
        "over the scene".to_owned()
    };
    findings.add_statement(
        FindingTopic::Growth,
        format!("a small error at the start grows at most {:.0e} times {part}", most.exp()),
    );
    let panel = Panel {
        title: "Growth of errors".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: "error".to_owned(),
        scale: Scale::Logarithmic,
        x_scale: Scale::Linear,
        series,
        note: Some(format!("Errors of DOP853 against a reference known to {:.0e}.", reference.uncertainty)),
    };
    findings.figures.push(("growth.svg", Figure::Panels(vec![panel], 1)));
    Ok(())
}

/// Makes a run at the given tolerance. Returns the number of its steps, and the pairs of instant, s, and
/// error for the instants `times` that it reached.
///
/// # Errors
/// `Error::Request` if the options are invalid. `Error::Interrupted` if the observer ended the run.
fn errors_at_instants(
    problem: &Problem<'_>,
    y0: &[f64],
    tolerance: f64,
    times: &[f64],
    reference: &ReferenceSolution,
) -> Result<(f64, Vec<(f64, f64)>), Error> {
    let output = OutputOption::At(times.to_vec());
    let options = Options { method: Method::Dop853, output, ..Options::tolerances(tolerance, tolerance) };
    let run = require_uninterrupted(
        problem.integrate(y0, &options, &mut []).map_err(|e| refused_scene_error(problem.scene, &e))?,
    )?;
    let samples = run.t.iter().zip(&run.y).zip(&reference.states);
    let error = |((t, y), state): ((&f64, &Vec<f64>), &Vec<_>)| {
        (*t, larger(work_precision_error(&problem.precise_state(*t, y), state), reference.uncertainty))
    };
    Ok((run.steps as f64, samples.map(error).collect()))
}
