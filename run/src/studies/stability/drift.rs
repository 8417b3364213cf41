//! Study of long runs by each integrator: does the energy drift without bound, or does its error stay
//! bounded? Also studies tolerances finer than rounding.

use super::findings::{FindingRow, FindingTopic, Findings, StudyInputs};
use crate::code::{CodePreparation, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::equally_spaced_instants;
use crate::observer::require_uninterrupted;
use crate::preparation::problem::Problem;
use crate::studies::figure::{Figure, Panel, Scale, Series};
use crate::trust::watched_invariants::WatchedInvariants;
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_sim::error_growth::{Trend, drift_trend};
use tripos_sim::{Method, Options, OutputOption};
use tripos_traits::larger;

/// Durations of a long run, in spans of the scene: first for a quick study, then for a full study.
const SPANS: [f64; 2] = [20.0, 200.0];
/// Number of steps of a fixed-step run in each span of the scene.
const FIXED: f64 = 400.0;

/// Runs every integrator over many spans of the scene, and records the drift of the energy. Does nothing
/// if energy is not conserved. If the motion leaves its domain, only tolerances are studied.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn study_drift(study: &StudyInputs<'_>, findings: &mut Findings) -> Result<(), Error> {
    let (model, scene) = (study.model, study.scene);
    let watch = WatchedInvariants::of_model(model)?;
    let Some(energy) = watch.integrals.iter().position(|integral| integral.kind.is_energy()) else { return Ok(()) };
    let by = EquationsOrigin::from(Formulation::Kane);
    let code = runnable_code(model, &by, scene.integration.distance, CodePreparation::Solved)?;
    let problem = Problem::new(model, scene, &by, &code, None)?;
    let y0 = problem.start()?;
    study_tolerance_below_rounding(study, &problem, &y0, findings)?;
    if findings.left_domain {
        return Ok(());
    }
    let (from, to) = scene.span;
    let length = (to - from) * if study.quick { SPANS[0] } else { SPANS[1] };
    let limit = if study.quick { 200_000 } else { 2_000_000 };
    let long = (from, from + length);
    let samples = equally_spaced_instants(long, 500);
    let unit = &watch.integrals[energy].unit;
    let mut series = Vec::new();
    let long_run = LongRun { problem: &problem, y0: &y0, span: long, watch: &watch, energy };
    for method in Method::ALL {
        let system = code.system();
        let has_jacobian = system.has_accelerations() || !method.needs_jacobian();
        if !has_jacobian || (method.needs_series() && !system.has_taylor()) {
            continue;
        }
        let fixed = [(true, "fixed step"), (false, "adaptive")];
        for (at, (is_fixed, how)) in fixed.into_iter().enumerate() {
            let fits = if is_fixed { method.has_fixed_use() } else { method.is_adaptive() };
            if !fits {
                continue;
            }
            let options = Options {
                method,
                step: is_fixed.then(|| (to - from).abs() / FIXED),
                step_limit: limit,
                output: OutputOption::At(samples.clone()),
                ..Options::tolerances(1e-6, 1e-8)
            };
            let EnergyDrift { trend, changes } = long_run.energy_drift(&options, how, findings)?;
            series.push(Series::curve(format!("{}, {how}: {trend}", method.name()), series.len() + at, changes));
        }
    }
    let panel = Panel {
        title: "Energy over a long run".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: format!("|E − E(t₀)| [{unit}]"),
        scale: Scale::Logarithmic,
        x_scale: Scale::Linear,
        series,
        note: Some(format!("Fixed steps of {:.1e} s; adaptive ones at rtol 1e-6.", (to - from).abs() / FIXED)),
    };
    findings.figures.push(("long_run.svg", Figure::Panels(vec![panel], 1)));
    Ok(())
}

/// Change of the energy T + V during a run.
struct EnergyDrift {
    /// Word for the trend of the drift: `secular`, `bounded` or `stopped`.
    trend: &'static str,
    /// Pairs of an instant, s, and the absolute change of the energy since the start.
    changes: Vec<(f64, f64)>,
}

/// Long run whose energy is examined.
struct LongRun<'r> {
    /// Scene with its equations of motion.
    problem: &'r Problem<'r>,
    /// Integrated state (q, v) at the start.
    y0: &'r [f64],
    /// First and last instant of the run, s.
    span: (f64, f64),
    /// First integrals of the motion, the energy among them.
    watch: &'r WatchedInvariants,
    /// Index of the energy among the first integrals.
    energy: usize,
}

impl LongRun<'_> {
    /// Makes the run with the given options. Adds its rows to the table of findings, under the case `how`.
    ///
    /// # Errors
    /// `Error::Request` if the options are invalid. `Error::Interrupted` if the observer ended the run.
    fn energy_drift(&self, options: &Options, how: &str, findings: &mut Findings) -> Result<EnergyDrift, Error> {
        let Self { problem, y0, span, watch, energy } = *self;
        let run =
            problem.integrate_over(span, y0, options, &mut []).map_err(|e| refused_scene_error(problem.scene, &e))?;
        let run = require_uninterrupted(run)?;
        let drifts = watch.integral_changes(problem, &run, energy);
        // A run that did not reach its end has no trend.
        let word = match drift_trend(&drifts) {
            _ if run.stop.is_failure() => "stopped",
            Trend::Secular => "secular",
            Trend::Bounded => "bounded",
        };
        findings.rows.push(FindingRow {
            check: "long run",
            formulation: problem.by.name(),
            solve: problem.solve.name(),
            method: options.method.name(),
            case: how.to_owned(),
            quantity: "energy drift",
            value: Some(drifts.iter().map(|x| x.abs()).fold(0.0, larger)),
            expected: None,
            remark: format!("{word}; {} after {} steps", run.stop.code(), run.steps),
        });
        let points: Vec<(f64, f64)> = run.t.iter().copied().zip(drifts.iter().map(|x| x.abs())).skip(1).collect();
        findings.rows.extend(points.iter().map(|(t, drift)| FindingRow {
            check: "long run",
            method: options.method.name(),
            case: format!("{how} t={t}"),
            quantity: "energy change",
            value: Some(*drift),
            ..FindingRow::default()
        }));
        Ok(EnergyDrift { trend: word, changes: points })
    }
}

/// Runs a problem twice: with an absolute tolerance below the rounding of its variables, and with a
/// larger tolerance for comparison. The small tolerance costs steps and improves nothing, so the run must
/// give a warning.
///
/// # Errors
/// `Error::Request` if the options are invalid. `Error::Interrupted` if the observer ended a run.
fn study_tolerance_below_rounding(
    study: &StudyInputs<'_>,
    problem: &Problem<'_>,
    y0: &[f64],
    findings: &mut Findings,
) -> Result<(), Error> {
    for (tolerance, case) in [(1e-12, "1e-12"), (1e-18, "1e-18")] {
        let options = Options {
            method: Method::Dop853,
            step_limit: if study.quick { 50_000 } else { 1_000_000 },
            output: OutputOption::Ends,
            ..Options::tolerances(0.0, tolerance)
        };
        let run = require_uninterrupted(
            problem.integrate(y0, &options, &mut []).map_err(|e| refused_scene_error(study.scene, &e))?,
        )?;
        let said: Vec<String> = run.warnings.iter().map(|w| w.warning_text(&problem.variable_names())).collect();
        findings.rows.push(FindingRow {
            check: "tolerance below rounding",
            formulation: problem.by.name(),
            solve: problem.solve.name(),
            method: Method::Dop853.name(),
            case: case.to_owned(),
            quantity: "steps",
            value: Some((run.steps + run.rejected) as f64),
            expected: None,
            remark: if said.is_empty() { run.stop.code() } else { format!("{}: {}", run.stop.code(), said.join("; ")) },
        });
        if let Some(warning) = said.first() {
            findings.add_statement(
                FindingTopic::Drift,
                format!("absolute tolerance {case}: {} steps; {warning}", run.steps + run.rejected),
            );
        }
    }
    Ok(())
}
