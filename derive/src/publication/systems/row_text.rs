//! Text of a printed row of a linear system, assembled from the texts of its entries.

use crate::algebra::text::notation::Notation;
use crate::algebra::text::print::latex_name;

/// Text `a·x + b·y = c` of a row of a linear system, in the notation of the row. Terms whose entry is "0" are left out.
pub fn system_row_text(entries: &[String], unknowns: &[String], right: &str, notation: Notation) -> String {
    let is_latex = notation == Notation::Latex;
    let (times, open, close) = if is_latex { (" ", "\\left(", "\\right)") } else { ("*", "(", ")") };
    let terms: Vec<String> = entries
        .iter()
        .zip(unknowns)
        .filter(|(entry, _)| *entry != "0")
        .map(|(entry, unknown)| {
            let unknown = if is_latex { latex_name(unknown) } else { unknown.clone() };
            match entry.as_str() {
                "1" => unknown,
                entry if entry.trim_start_matches('-').contains(['+', '-']) => {
                    format!("{open}{entry}{close}{times}{unknown}")
                }
                entry => format!("{entry}{times}{unknown}"),
            }
        })
        .collect();
    let left = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
    format!("{left} = {right}")
}
