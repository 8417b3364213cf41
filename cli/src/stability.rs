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
pub mod words;

use crate::failure::Failure;
use crate::follow;
use crate::output::{table, text};
use indicatif::ProgressBar;
use std::path::Path;
use tripos_derive::Model;
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
    pub figures: Vec<(&'static str, String)>,
    /// What to take away, a line each.
    pub statements: Vec<String>,
    /// The study that was interrupted, if one was: those after it were not begun.
    pub unfinished: Option<&'static str>,
}

/// What a study works on.
pub struct Study<'a> {
    /// The model.
    pub model: &'a Model,
    /// The scene.
    pub scene: &'a Scene,
    /// Whether less is to be run.
    pub quick: bool,
    /// What is being done.
    pub bar: &'a ProgressBar,
}

/// A study: what it finds is added.
pub type Run = fn(&Study<'_>, &mut Findings) -> Result<(), Failure>;

/// Runs every study that applies.
///
/// # Errors
/// [`Failure`] if the scene cannot be run at all.
pub fn all(study: &Study<'_>) -> Result<Findings, Failure> {
    let mut findings = Findings::default();
    let studies: [(&'static str, Run); 5] = [
        ("passages", ladder::study),
        ("conditioning", conditioning::study),
        ("domain", domain::study),
        ("growth", growth::study),
        ("drift", drift::study),
    ];
    study.bar.set_length(studies.len() as u64);
    for (name, run) in studies {
        study.bar.set_message(name);
        let outcome = run(study, &mut findings);
        if follow::asked() {
            // What it had found until then is found.
            findings.unfinished = Some(name);
            break;
        }
        outcome?;
        study.bar.inc(1);
    }
    Ok(findings)
}

impl Findings {
    /// `stability.csv`, `passages.csv` and the figures.
    ///
    /// # Errors
    /// [`Failure::Output`] if a file cannot be written.
    pub fn write(&self, out: &Path) -> Result<(), Failure> {
        self.tables(out)?;
        for (name, svg) in &self.figures {
            text(&out.join(name), svg)?;
        }
        Ok(())
    }

    /// `stability.csv`, and `passages.csv` if there were any: what the heat map shows.
    ///
    /// # Errors
    /// [`Failure::Output`] if a file cannot be written.
    pub fn tables(&self, out: &Path) -> Result<(), Failure> {
        let header = ["check", "formulation", "solve", "method", "case", "quantity", "value", "expected", "remark"];
        let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:e}"));
        let rows = self.rows.iter().map(|r| {
            let words = [r.check, &r.formulation, r.solve, r.method, &r.case, r.quantity].map(str::to_owned);
            [words.to_vec(), vec![number(r.value), number(r.expected), r.remark.clone()]].concat()
        });
        table(&out.join("stability.csv"), &header, rows)?;
        if self.passages.is_empty() {
            return Ok(());
        }
        let header = ["formulation", "solve", "method", "variable", "least", "error", "steps", "stop", "t"];
        let rows = self.passages.iter().map(|p| {
            let words = [&p.formulation, p.solve, p.method, p.variable].map(str::to_owned);
            let numbers = [format!("{:.2e}", p.least), number(p.error), p.steps.to_string(), p.stop.clone()];
            [words.to_vec(), numbers.to_vec(), vec![p.t_end.to_string()]].concat()
        });
        table(&out.join("passages.csv"), &header, rows)
    }
}
