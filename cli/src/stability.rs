//! Output of the stability studies of a scene: tables, figures and sentences.

pub mod passage_sentences;

use super::files::output_files::{write_table_file, write_text_file};
use super::terminal::failure::Failure;
use crate::chart::figure::draw_figure_svg;
use std::path::Path;
use tripos::Mechanism;
use tripos::studies::stability::{FindingTopic, Findings};

/// Writes the tables `stability.csv` and `passages.csv`, and the figures of the studies, into the folder `out`.
///
/// # Errors
/// [`Failure::Output`] if a file cannot be written.
pub fn write_stability_results(findings: &Findings, out: &Path) -> Result<(), Failure> {
    write_stability_tables(findings, out)?;
    for (name, figure) in &findings.figures {
        write_text_file(&out.join(name), &draw_figure_svg(figure)?)?;
    }
    Ok(())
}

/// Writes the table `stability.csv` into the folder `out`. If there are passages, also writes `passages.csv` with the
/// data of the heat map.
///
/// # Errors
/// [`Failure::Output`] if a file cannot be written.
pub fn write_stability_tables(findings: &Findings, out: &Path) -> Result<(), Failure> {
    let header = ["check", "formulation", "solve", "method", "case", "quantity", "value", "expected", "remark"];
    let number = |x: Option<f64>| x.map_or_else(String::new, |x| format!("{x:e}"));
    let rows = findings.rows.iter().map(|r| {
        let words = [r.check, &r.formulation, r.solve, r.method, &r.case, r.quantity].map(str::to_owned);
        [words.to_vec(), vec![number(r.value), number(r.expected), r.remark.clone()]].concat()
    });
    write_table_file(&out.join("stability.csv"), &header, rows)?;
    if findings.passages.is_empty() {
        return Ok(());
    }
    let header = ["formulation", "solve", "method", "variable", "least", "error", "steps", "stop", "t"];
    let rows = findings.passages.iter().map(|p| {
        let words = [&p.by.name(), p.solve, p.method, p.variable.name()].map(str::to_owned);
        let numbers = [format!("{:.2e}", p.least), number(p.error), p.steps.to_string(), p.stop.clone()];
        [words.to_vec(), numbers.to_vec(), vec![p.t_end.to_string()]].concat()
    });
    write_table_file(&out.join("passages.csv"), &header, rows)
}

/// Returns the conclusions of the studies, one sentence each. Conclusions from the table of
/// passages follow those of the study of passages.
pub fn stability_conclusions(model: &Mechanism, findings: &Findings) -> Vec<String> {
    let (passages, others): (Vec<_>, Vec<_>) =
        findings.statements.iter().partition(|s| s.study == FindingTopic::Passages);
    let mut list: Vec<String> = passages.into_iter().map(|s| s.text.clone()).collect();
    list.extend(passage_sentences::reduced_passages_sentence(&findings.passages));
    list.extend(passage_sentences::lagrange_passage_sentence(model, &findings.passages));
    list.extend(others.into_iter().map(|s| s.text.clone()));
    list
}
