//! Study of the domain of the equations: the conditions that stop a run where its equations no
//! longer hold.

use super::findings::{Findings, Row, Study, Topic};
use crate::code::{Ready, code};
use crate::error::{Error, refused};
use crate::follow::uninterrupted;
use crate::options::options;
use crate::preparation::problem::Problem;
use crate::trust::events::{Balance, events};
use tripos_derive::Formulation;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::plain::{significant, within};
use tripos_sim::{Method, Options, Output, Stop};

/// Runs a scene with and without the conditions of the model's domain, and records the difference.
/// Does nothing if the model has no such conditions and the scene has no events.
///
/// # Errors
/// [`Error`] if the scene cannot be run.
pub fn study(study: &Study<'_>, findings: &mut Findings) -> Result<(), Error> {
    let model = study.model;
    if model.domain.is_empty() && study.scene.events.is_empty() {
        return Ok(());
    }
    let mut said = false;
    for formulation in Formulation::STANDARD {
        let by = EquationsOrigin::from(formulation);
        let code = match code(model, &by, study.scene.integration.distance, Ready::Solved) {
            Ok(code) => code,
            Err(Error::Unsupported(_)) => continue,
            Err(failure) => return Err(failure),
        };
        for method in [Method::Ode45, Method::Dop853] {
            let problem = Problem::new(model, study.scene, &by, &code, None)?;
            let balance = Balance::new(model, model, study.scene, &by)?;
            let tight = Options {
                method,
                rtol: 1e-12,
                atol: 1e-12.into(),
                step: None,
                output: Output::Steps { refine: 1 },
                ..options(study.scene)
            };
            let y0 = problem.start()?;
            let mut watched = events(&problem, &balance);
            let run =
                uninterrupted(problem.integrate(&y0, &tight, &mut watched).map_err(|e| refused(study.scene, &e))?)?;
            drop(watched);
            let row = |quantity, value, remark: String| Row {
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
            let through =
                uninterrupted(problem.integrate(&y0, &tight, &mut []).map_err(|e| refused(study.scene, &e))?)?;
            let dynamics = problem.dynamics().map_err(|e| refused(study.scene, &e))?;
            let drift = (!study.model.is_driven()).then(|| dynamics.energy_drift(&through));
            let unseen =
                |drift| Row { case: "without it".to_owned(), ..row("energy drift", drift, through.stop.code()) };
            findings.rows.extend(drift.map(unseen));
            let drift = drift.map_or_else(String::new, |drift| {
                format!(", and its energy has changed by {} J", significant(drift, 2))
            });
            if !said {
                said = true;
                findings.say(Topic::Domain, format!(
                    "the motion leaves its domain at t = {} s ({}); without the domain the run goes on to t = {} s, ends with `{}`{drift}",
                    within(run.t_end, None),
                    run.stop.code(),
                    within(through.t_end, None),
                    through.stop.code()
                ));
            }
        }
    }
    Ok(())
}
