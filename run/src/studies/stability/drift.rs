//! Long runs by each method, in which conserved quantities drift for ever or stay bounded; and tolerances finer than
//! rounding.

use super::findings::{Findings, Row, Study, Topic};
use crate::code::{Ready, code};
use crate::error::{Error, refused};
use crate::follow::uninterrupted;
use crate::options::instants;
use crate::preparation::problem::Problem;
use crate::studies::figure::{Figure, Panel, Scale, Series};
use crate::trust::invariants::Watch;
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_sim::stability::{Trend, trend};
use tripos_sim::{Method, Options, Output};
use tripos_traits::larger;

/// Length of a long run in spans of the scene: for a quick study, then for a full study.
const SPANS: [f64; 2] = [20.0, 200.0];
/// Number of steps of a fixed-step run in one span of the scene.
const FIXED: f64 = 400.0;

/// Runs every method over many spans, if energy is conserved and the motion stays in its domain.
///
/// # Errors
/// [`Error`] if the scene cannot be run at all.
pub fn study(study: &Study<'_>, findings: &mut Findings) -> Result<(), Error> {
    let (model, scene) = (study.model, study.scene);
    let watch = Watch::of_model(model)?;
    let Some(energy) = watch.integrals.iter().position(|integral| integral.kind.is_energy()) else { return Ok(()) };
    let by = EquationsOrigin::from(Formulation::Kane);
    let code = code(model, &by, scene.integration.distance, Ready::Solved)?;
    let problem = Problem::new(model, scene, &by, &code, None)?;
    let y0 = problem.start()?;
    below_rounding(study, &problem, &y0, findings)?;
    if findings.left_domain {
        return Ok(());
    }
    let (from, to) = scene.span;
    let length = (to - from) * if study.quick { SPANS[0] } else { SPANS[1] };
    let limit = if study.quick { 200_000 } else { 2_000_000 };
    let long = (from, from + length);
    let samples = instants(long, 500);
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
                output: Output::At(samples.clone()),
                ..Options::tolerances(1e-6, 1e-8)
            };
            let EnergyCourse { trend, changes } = long_run.course(&options, how, findings)?;
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

/// Change of the energy along a run.
struct EnergyCourse {
    /// Word that says if the energy drifts.
    trend: &'static str,
    /// Pairs of an instant, s, and the size of the energy's change since the start.
    changes: Vec<(f64, f64)>,
}

/// A long run whose energy is examined.
struct LongRun<'r> {
    problem: &'r Problem<'r>,
    /// Integrated state at the start.
    y0: &'r [f64],
    /// First and last instant, s.
    span: (f64, f64),
    /// First integrals of the motion.
    watch: &'r Watch,
    /// Index of the energy among the first integrals.
    energy: usize,
}

impl LongRun<'_> {
    /// Makes the run with given options. Adds the rows of the table, under the case `how`.
    fn course(&self, options: &Options, how: &str, findings: &mut Findings) -> Result<EnergyCourse, Error> {
        let Self { problem, y0, span, watch, energy } = *self;
        let run = problem.integrate_over(span, y0, options, &mut []).map_err(|e| refused(problem.scene, &e))?;
        let run = uninterrupted(run)?;
        let drifts = watch.course(problem, &run, energy);
        // A run that did not arrive has no trend.
        let word = match trend(&drifts) {
            _ if run.stop.is_failure() => "stopped",
            Trend::Secular => "secular",
            Trend::Bounded => "bounded",
        };
        findings.rows.push(Row {
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
        findings.rows.extend(points.iter().map(|(t, drift)| Row {
            check: "long run",
            method: options.method.name(),
            case: format!("{how} t={t}"),
            quantity: "energy change",
            value: Some(*drift),
            ..Row::default()
        }));
        Ok(EnergyCourse { trend: word, changes: points })
    }
}

/// Runs a problem with a tolerance below the rounding of the variables, and with a larger one for comparison. The small
/// tolerance makes a run longer and no better, so the run must warn.
fn below_rounding(study: &Study<'_>, problem: &Problem<'_>, y0: &[f64], findings: &mut Findings) -> Result<(), Error> {
    for (tolerance, case) in [(1e-12, "1e-12"), (1e-18, "1e-18")] {
        let options = Options {
            method: Method::Dop853,
            step_limit: if study.quick { 50_000 } else { 1_000_000 },
            output: Output::Ends,
            ..Options::tolerances(0.0, tolerance)
        };
        let run = uninterrupted(problem.integrate(y0, &options, &mut []).map_err(|e| refused(study.scene, &e))?)?;
        let said: Vec<String> = run.warnings.iter().map(|w| w.described(&problem.variables())).collect();
        findings.rows.push(Row {
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
            findings
                .say(Topic::Drift, format!("absolute tolerance {case}: {} steps; {warning}", run.steps + run.rejected));
        }
    }
    Ok(())
}
