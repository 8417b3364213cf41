//! Limits of the runs of a scene: passages near a singular surface, ill-conditioned matrices, growth of
//! errors, domains of the equations, drifts, and tolerances finer than rounding.
//!
//! Each study finds out if it applies to the scene. Every number that is plotted or stated is a row of
//! the table of findings.

pub mod conditioning;
pub mod domain;
pub mod drift;
mod findings;
pub mod growth;
pub mod passages;

pub use findings::{
    ConditioningFinding, FindingRow, FindingTopic, Findings, PassageRun, PassageVariable, Statement, StudyInputs,
};

use crate::error::Error;

/// Function that runs a study of one topic and adds its results to the findings.
pub type TopicStudy = fn(&StudyInputs<'_>, &mut Findings) -> Result<(), Error>;

/// Runs the studies of all topics that apply to a scene, and collects their findings. If the observer
/// interrupts a study, returns the findings up to then.
///
/// # Errors
/// [`Error`] if the scene cannot be run or has impacts, or if its model has no generalized speed.
pub fn run_all_studies(study: &StudyInputs<'_>) -> Result<Findings, Error> {
    study.model.require_speeds("the model has no equations of motion to study")?;
    if !study.scene.impacts.is_empty() {
        let help = "leave the impacts out, and end the span before the first of them";
        return Err(Error::request("this study needs a smooth motion, and the scene has impacts", help));
    }
    let mut findings = Findings::default();
    let studies: [(FindingTopic, TopicStudy); 5] = [
        (FindingTopic::Passages, passages::study_passages),
        (FindingTopic::Conditioning, conditioning::study_conditioning),
        (FindingTopic::Domain, domain::study_domain),
        (FindingTopic::Growth, growth::study_growth),
        (FindingTopic::Drift, drift::study_drift),
    ];
    study.progress.set_length(studies.len() as u64);
    for (topic, run) in studies {
        study.progress.set_message(topic.name());
        let outcome = run(study, &mut findings);
        if study.model.follow.is_interrupted() {
            // The findings up to the interruption are kept.
            findings.unfinished = Some(topic);
            break;
        }
        outcome?;
        study.progress.add_finished_parts(1);
    }
    Ok(findings)
}
