//! Standing (trustworthiness) of each run of a scene, from the verdict on its equations and its number of correct
//! digits.

use crate::page::Standing;
use tripos::studies::model_analysis::ModelAnalysis;
use tripos::{CorrectDigits, Run, integration_method_words};
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::scene::Scene;
use tripos_traits::largest;

/// Returns the standing of printed equations, from the verdict on their accelerations. `None` if the accelerations
/// equal the derived accelerations.
fn printed_equations_standing(study: &ModelAnalysis, id: &str) -> Option<Standing> {
    let mut systems = study.published.iter().flat_map(|published| &published.difference.consequences);
    match systems.find(|system| system.system == id).map(|system| &system.accelerations) {
        Some(Verdict::Equal(_)) => None,
        Some(Verdict::Different(_)) => Some(Standing::Wrong),
        Some(Verdict::Undecided(why)) => Some(Standing::Undecided(why.clone())),
        None => Some(Standing::Undecided("they do not determine the motion".to_owned())),
    }
}

/// Returns the standing of a run: right, loose (with few correct digits) with its error, stopped, or by wrong or
/// undecided equations.
pub fn run_standing(study: &ModelAnalysis, scene: &Scene, run: &Run) -> Standing {
    if let Some(standing) = run.by.printed_id().and_then(|id| printed_equations_standing(study, id)) {
        return standing;
    }
    if run.failure().is_some() {
        return Standing::Stopped;
    }
    if run.warnings.is_empty() {
        return Standing::Right;
    }
    Standing::Loose { how: integration_method_words(scene), error: standing_error_at_end(run) }
}

/// Returns the error of a run at its end, the largest |e|/(1 + |value|), estimated by a second run.
/// `Err` is the reason why it is unknown.
fn standing_error_at_end(run: &Run) -> Result<f64, String> {
    let errors = run.digits.as_ref().and_then(CorrectDigits::errors_at_end);
    let errors = errors.ok_or_else(|| "it was not assessed to its end".to_owned())?;
    let error = largest(errors.iter().zip(&run.end).map(|(error, value)| error / (1.0 + value.abs())));
    if error.is_finite() { Ok(error) } else { Err("something that is shown has no value there".to_owned()) }
}
