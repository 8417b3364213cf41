//! Section of the page with the measured recommendation of equations, solve and method for a scene.

use crate::page::content::Advice;
use crate::page::markup::html::{escape, number, rounded_number_html, table};
use crate::phrases::seconds;

/// Column headings of the table of recommended runs.
const HEAD: [&str; 7] = ["Error below", "Equations", "Accelerations", "Method", "Tolerance", "Time of a run", "Error"];

/// Returns the HTML of the recommendation: a paragraph with the id `place`, and a table of the
/// fastest runs.
pub fn section(advice: &Advice, place: &str) -> String {
    let rows: Vec<Vec<String>> = advice
        .rows
        .iter()
        .map(|(target, choice)| {
            let size = |x: f64| number(&format!("{x:e}"));
            let mut cells = vec![size(*target)];
            match choice {
                Some(c) => cells.extend([
                    escape(&c.equations),
                    c.solve.to_owned(),
                    c.method.to_owned(),
                    c.tolerance.map_or_else(|| "–".to_owned(), size),
                    seconds(c.seconds),
                    size(rounded_number_html(c.error, 2).parse().unwrap_or(c.error)),
                ]),
                None => cells.extend(["nothing measured here", "", "", "", "", ""].map(str::to_owned)),
            }
            cells
        })
        .collect();
    format!(
        "<h4 id=\"{place}\">Which equations, accelerations and method to use</h4>\n<p>{}</p>\n{}",
        escape(&advice.lead),
        table("The fastest run to three accuracies", &HEAD, &rows)
    )
}
