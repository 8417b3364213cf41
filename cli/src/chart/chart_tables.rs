//! Files of a speed chart: CSV tables for other programs, and a table of recommendations for the user.

use super::sentences::{TARGETS, fastest};
use crate::files::output_files::write_table_file;
use crate::phrases::seconds;
use crate::terminal::failure::Failure;
use std::fmt::Write;
use std::path::Path;
use tripos::ConservedQuantity;
use tripos::studies::work_precision_chart::Measurement;

/// Writes the CSV tables of a speed chart into the folder `out`: `work_precision.csv`, `times.csv`
/// (shortest, median and longest run) and `drifts.csv` (drifts of integrals).
///
/// # Errors
/// [`Failure::Output`] if a file cannot be written.
pub fn write_chart_tables(out: &Path, list: &[Measurement], integrals: &[ConservedQuantity]) -> Result<(), Failure> {
    let key = |m: &Measurement| {
        vec![
            m.by.name(),
            m.way.solve(m.solve).to_owned(),
            m.way.name().to_owned(),
            table_tolerance_text(m.way.tolerance()),
        ]
    };
    let header = ["formulation", "solve", "method", "tolerance", "seconds", "error", "steps", "evaluations", "stop"];
    let rows = list.iter().map(|m| {
        let error = m.error.map_or_else(String::new, |e| format!("{e:e}"));
        let numbers = [format!("{:e}", m.seconds.median), error, m.steps.to_string(), m.evaluations.to_string()];
        [key(m), numbers.to_vec(), vec![m.stop.code()]].concat()
    });
    write_table_file(&out.join("work_precision.csv"), &header, rows)?;
    let header = ["formulation", "solve", "method", "tolerance", "runs", "shortest", "median", "longest"];
    let rows = list.iter().map(|m| {
        let times = [m.seconds.least, m.seconds.median, m.seconds.most].map(|t| format!("{t:e}"));
        [key(m), vec![m.seconds.runs.to_string()], times.to_vec()].concat()
    });
    write_table_file(&out.join("times.csv"), &header, rows)?;
    let header = ["formulation", "solve", "method", "tolerance", "integral", "drift"];
    let rows = list.iter().flat_map(|m| {
        let each = integrals.iter().zip(&m.drifts);
        each.map(move |(integral, drift)| [key(m), vec![integral.name.clone(), format!("{drift:e}")]].concat())
    });
    write_table_file(&out.join("drifts.csv"), &header, rows)
}

/// Returns a tolerance as text in a table; `-` for `None`.
pub fn table_tolerance_text(tolerance: Option<f64>) -> String {
    tolerance.map_or_else(|| "-".to_owned(), |tolerance| format!("{tolerance:e}"))
}

/// Returns a table of recommendations: the fastest run for each of three accuracies.
pub fn chart_advice_table(list: &[Measurement]) -> String {
    let mut out = "to reach  use                                          tolerance  time       error\n".to_owned();
    for target in TARGETS {
        let _ = match fastest(list, target, |_| true) {
            Some(m) => {
                let name = format!("{}, {}, {}", m.by.name(), m.way.solve(m.solve), m.way.name());
                let (time, error) = (seconds(m.seconds.median), m.error.unwrap_or(f64::NAN));
                writeln!(
                    out,
                    "{target:<9e} {name:<44} {:<10} {time:<10} {error:.1e}",
                    table_tolerance_text(m.way.tolerance())
                )
            }
            None => writeln!(out, "{target:<9e} nothing measured here reaches it"),
        };
    }
    out
}
