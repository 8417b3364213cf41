//! Where runs of a scene give way: passages near a singular surface, ill-conditioned matrices, unstable motions, domains
//! that are left unseen, drifts, and tolerances finer than rounding.
//!
//! Each study finds out by itself whether it applies to the scene. Every number that is plotted or stated is a row of the
//! table.

pub mod conditioning;
pub mod domain;
pub mod drift;
pub mod growth;
pub mod ladder;

use crate::error::Error;
use crate::figure::Figure;
use crate::follow::Progress;
use crate::mechanism::Mechanism;
use tripos_derive::scene::Scene;

/// One number that was found.
#[derive(Clone, Debug, Default)]
pub struct Row {
    /// Which study.
    pub check: &'static str,
    /// Which equations; empty where it does not matter.
    pub formulation: String,
    /// How accelerations were found.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// Which rung, instant or tolerance.
    pub case: String,
    /// What the value is.
    pub quantity: &'static str,
    /// The value; none where a run did not get there.
    pub value: Option<f64>,
    /// What theory or the reference says.
    pub expected: Option<f64>,
    /// Where and why a run stopped, or what to know.
    pub remark: String,
}

/// A run past a singular surface: a cell of the heat map.
#[derive(Clone, Debug)]
pub struct Passed {
    /// Which equations.
    pub formulation: String,
    /// How accelerations were found.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// What was integrated: `coordinate` or `distance`.
    pub variable: &'static str,
    /// How near it came: the least size of what the kinematic equations divide by.
    pub least: f64,
    /// The error at the end; none if the run did not get there.
    pub error: Option<f64>,
    /// Accepted steps.
    pub steps: u64,
    /// Why it ended.
    pub stop: String,
    /// Where it ended, s.
    pub t_end: f64,
}

/// What the studies found.
#[derive(Default)]
pub struct Findings {
    /// Every number.
    pub rows: Vec<Row>,
    /// The cells of the heat map of passages.
    pub passages: Vec<Passed>,
    /// Figures by file name.
    pub figures: Vec<(&'static str, Figure)>,
    /// What to take away, a line each.
    pub statements: Vec<Statement>,
    /// The study that was interrupted, if one was: those after it were not begun.
    pub unfinished: Option<&'static str>,
}

/// What to take away, in a sentence.
#[derive(Clone, Debug)]
pub struct Statement {
    /// The study that found it.
    pub study: &'static str,
    /// The sentence.
    pub text: String,
}

/// What a study works on.
pub struct Study<'a> {
    /// The model.
    pub model: &'a Mechanism,
    /// The scene.
    pub scene: &'a Scene,
    /// Whether less is to be run.
    pub quick: bool,
    /// What is being done.
    pub progress: &'a dyn Progress,
}

/// A study: what it finds is added.
pub type Run = fn(&Study<'_>, &mut Findings) -> Result<(), Error>;

/// Runs every study that applies.
///
/// # Errors
/// [`Error`] if the scene cannot be run at all.
pub fn all(study: &Study<'_>) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let studies: [(&'static str, Run); 5] = [
        ("passages", ladder::study),
        ("conditioning", conditioning::study),
        ("domain", domain::study),
        ("growth", growth::study),
        ("drift", drift::study),
    ];
    study.progress.set_length(studies.len() as u64);
    for (name, run) in studies {
        study.progress.set_message(name);
        let outcome = run(study, &mut findings);
        if study.model.follow.asked() {
            // What it had found until then is found.
            findings.unfinished = Some(name);
            break;
        }
        outcome?;
        study.progress.inc(1);
    }
    Ok(findings)
}

impl Findings {
    /// Adds what to take away from a study.
    fn say(&mut self, study: &'static str, text: String) {
        self.statements.push(Statement { study, text });
    }
}
