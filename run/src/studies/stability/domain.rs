//! Study of the domain of the equations: its conditions stop a run where the equations no longer hold.

use super::findings::{FindingRow, FindingTopic, Findings, StudyInputs};
use crate::code::{CodePreparation, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::integration_options;
use crate::observer::require_uninterrupted;
use crate::preparation::problem::Problem;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_sim::{Method, Options, OutputOption, Stop};

/// Runs a scene with and without the conditions of the model's domain, and records the difference. Does
/// nothing if the model has no such conditions and the scene has no events.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn study_domain(study: &StudyInputs<'_>, findings: &mut Findings) -> Result<(), Error> {
    let model = study.model;
    if model.domain.is_empty() && study.scene.events.is_empty() {
        return Ok(());
    }
    let mut said = false;
    for formulation in Formulation::STANDARD {
        let by = EquationsOrigin::from(formulation);
        let code = match runnable_code(model, &by, study.scene.integration.distance, CodePreparation::Solved) {
            Ok(code) => code,
            Err(Error::Unsupported(_)) => continue,
            Err(failure) => return Err(failure),
        };
        for method in [Method::Ode45, Method::Dop853] {
            let problem = Problem::new(model, study.scene, &by, &code, None)?;
            let balance = WatchedFunctions::new(model, model, study.scene, &by)?;
            let tight = Options {
                method,
                rtol: 1e-12,
                atol: 1e-12.into(),
                step: None,
                output: OutputOption::Steps { refine: 1 },
                ..integration_options(study.scene)
            };
            let y0 = problem.start()?;
            let mut watched = watched_events(&problem, &balance);
            let run = require_uninterrupted(
                problem.integrate(&y0, &tight, &mut watched).map_err(|e| refused_scene_error(study.scene, &e))?,
            )?;
            drop(watched);
            let row = |quantity, value, remark: String| FindingRow {
                check: "domain",
                formulation: by.name(),
                solve: problem.solve.name(),
                method: method.name(),
                case: "with the domain".to_owned(),
                quantity,
                value: Some(value),
                expected: None,
                remark,
            };
            for event in &run.events {
                findings.rows.push(row("event at", event.t, event.name.clone()));
            }
            if !matches!(run.stop, Stop::LeftDomain { .. }) {
                continue;
            }
            findings.left_domain = true;
            findings.rows.push(row("left at", run.t_end, run.stop.code()));
            let through = require_uninterrupted(
                problem.integrate(&y0, &tight, &mut []).map_err(|e| refused_scene_error(study.scene, &e))?,
            )?;
            let dynamics = problem.dynamics().map_err(|e| refused_scene_error(study.scene, &e))?;
            let drift = (!study.model.is_driven()).then(|| dynamics.energy_drift(&through));
            let unseen =
                |drift| FindingRow { case: "without it".to_owned(), ..row("energy drift", drift, through.stop.code()) };
            findings.rows.extend(drift.map(unseen));
            let drift = drift.map_or_else(String::new, |drift| {
                format!(", and its energy has changed by {} J", with_significant_digits(drift, 2))
            });
            if !said {
                said = true;
                findings.add_statement(FindingTopic::Domain, format!(
                    "the motion leaves its domain at t = {} s ({}); without the domain the run goes on to t = {} s, ends with `{}`{drift}",
                    with_reliable_digits(run.t_end, None),
                    run.stop.code(),
                    with_reliable_digits(through.t_end, None),
                    through.stop.code()
                ));
            }
        }
    }
    Ok(())
}
