//! Tables of a scene's runs, with a row for each run: results, and largest changes of first integrals.

use crate::page::content::{Page, RunRow, SceneSection, Standing};
use crate::page::markup::formula_mathml::inline_mathml;
use crate::page::markup::html::{escape, number, rounded_number_html, scrolling_box, table_head, words_html};
use crate::page::model::proof::{proved_integral_name, proved_integral_symbol};
use crate::page::scenes::standing::{self, standing_row_class};
use std::fmt::Write;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::plain_text::with_significant_digits;

/// Column headings of the table of a scene's runs.
const HEAD: [&str; 8] = [
    "Equations",
    "Result",
    "Ended at [s]",
    "Digits there",
    "Energy drift [J]",
    "Steps (rejected)",
    "Evaluations",
    "Method, code",
];

/// Returns the HTML table of all runs of a scene, derived and printed.
pub fn runs_table(page: &Page, scene: &SceneSection) -> String {
    let of = |printed: bool| scene.runs.iter().filter(move |row| row.printed.is_some() == printed);
    let rows_of = |printed: bool| -> String {
        let before = std::iter::once(None).chain(of(printed).map(Some));
        before.zip(of(printed)).map(|(before, row)| run_rows(row, before)).collect()
    };
    let mut rows = rows_of(false);
    let not_run = scene.not_run.iter().map(|(title, why)| {
        let (columns, why) = (HEAD.len() - 1, escape(why));
        format!(
            "<tr class=\"printed\"><th scope=\"row\"><code>{}</code></th><td colspan=\"{columns}\">not run: {why}</td></tr>\n",
            escape(title)
        )
    });
    let printed: String = std::iter::once(rows_of(true)).chain(not_run).collect();
    if let (false, Some(published)) = (printed.is_empty(), &page.study.published) {
        let (columns, title) = (HEAD.len(), escape(published.publication.heading()));
        let _ = writeln!(
            rows,
            "<tr class=\"group\"><th scope=\"rowgroup\" colspan=\"{columns}\">As printed in {title}{}</th></tr>",
            wrong_runs_words(scene)
        );
        rows += &printed;
    }
    let table = format!(
        "<table class=\"runs\">\n<caption>Runs</caption>\n{}<tbody>\n{rows}</tbody>\n\
         </table>\n",
        table_head(&HEAD)
    );
    scrolling_box(&format!("Runs of {}", scene.title), &table)
}

/// Returns words for the number of wrong systems among the printed equations that were run. Empty if none were run.
fn wrong_runs_words(scene: &SceneSection) -> String {
    let printed: Vec<&RunRow> = scene.runs.iter().filter(|run| run.printed.is_some()).collect();
    match (printed.iter().filter(|run| run.standing == Standing::Wrong).count(), printed.len()) {
        (_, 0) => String::new(),
        (0, _) => ": none is wrong".to_owned(),
        (wrong, all) if wrong == all => ": all are wrong, they do not give the derived accelerations".to_owned(),
        (wrong, all) => format!(": {wrong} of {all} are wrong, they do not give the derived accelerations"),
    }
}

/// Returns the HTML table of the largest change of each first integral in each run.
pub fn integral_changes_table(page: &Page, scene: &SceneSection) -> String {
    let integrals = &page.study.proof.integrals;
    let heads: Vec<String> = (0..integrals.len()).map(|at| inline_mathml(&proved_integral_symbol(at))).collect();
    let columns: Vec<&str> = std::iter::once("Equations").chain(heads.iter().map(String::as_str)).collect();
    let row = |run: &RunRow| {
        let cell = |(at, change): (usize, &f64)| {
            let (open, close) =
                if violates_integral(page, run, at) { ("<strong class=\"wrong\">", "</strong>") } else { ("", "") };
            format!("<td class=\"n\">{open}{}{close}</td>", run_drift_html(*change))
        };
        let cells: String = run.changes.iter().enumerate().map(cell).collect();
        format!(
            "<tr{}><th scope=\"row\">{}</th>{cells}</tr>\n",
            standing_row_class(run, ""),
            standing::run_name_with_standing(run)
        )
    };
    let named = |(at, integral): (usize, &tripos_derive::prove::Integral)| {
        format!(
            "{}: {}",
            inline_mathml(&proved_integral_symbol(at)),
            proved_integral_name(page.model, &page.study.derivations.kinematics.arena, integral)
        )
    };
    let names: Vec<String> = integrals.iter().enumerate().map(named).collect();
    let marked = scene.runs.iter().any(|run| (0..integrals.len()).any(|at| violates_integral(page, run, at)));
    let marked =
        if marked { " Marked: these equations do not conserve it, however well they are integrated." } else { "" };
    let table = format!(
        "<table class=\"runs extremes\">\n<caption>Largest |I(t) − I(t₀)|, in SI units</caption>\n{}<tbody>\n{}</tbody>\n</table>\n",
        table_head(&columns),
        scene.runs.iter().filter(|run| !run.changes.is_empty()).map(row).collect::<String>()
    );
    format!(
        "{}<p class=\"quiet\">{}. What the derived equations show here is the error of the integration: their exact \
         solutions keep all of these.{marked}</p>\n",
        scrolling_box("Largest change of each first integral", &table),
        names.join("; ")
    )
}

/// True if the printed equations of a run are proved not to conserve the first integral with this
/// index.
fn violates_integral(page: &Page, run: &RunRow, integral: usize) -> bool {
    let (Some(id), Some(published)) = (&run.printed, &page.study.published) else { return false };
    let system = published.difference.consequences.iter().find(|c| c.system == *id);
    let rate = system.and_then(|c| c.rates.get(integral));
    rate.is_some_and(|rate| matches!(rate.verdict, Verdict::Different(_)))
}

/// Returns the HTML rows of a run: its numbers and, if needed, a row with remarks, the reason of an early end, and
/// warnings. The reason is not repeated if the run `before` has the same reason.
fn run_rows(run: &RunRow, before: Option<&RunRow>) -> String {
    let is_like_before = before.is_some_and(|before| !before.arrived && before.stop == run.stop);
    let result = match run.arrived {
        true => escape(&run.stop),
        false if is_like_before => "ended early, likewise".to_owned(),
        false => "ended early".to_owned(),
    };
    let mut out = format!(
        "<tr{}><th scope=\"row\">{}</th><td class=\"result\">{result}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
         <td class=\"n\">{}</td><td class=\"n\">{} ({})</td><td class=\"n\">{}</td><td>{}, {}</td></tr>\n",
        standing_row_class(run, ""),
        standing::run_name_with_standing(run),
        number(&rounded_number_html(run.t_end, 6)),
        run.digits.map_or_else(|| "–".to_owned(), |digits| number(&format!("{digits:.1}"))),
        run.energy_drift.map_or_else(|| "–".to_owned(), run_drift_html),
        run.steps,
        run.rejected,
        run.evaluations,
        escape(run.method),
        escape(&run.code),
    );
    let word = run
        .standing
        .standing_word()
        .map_or(String::new(), |word| format!("{}{}:", word[..1].to_uppercase(), &word[1..]));
    let standing = run.standing.standing_remark(run.t_end).map(|text| (word.as_str(), text));
    let ending = (!run.arrived && !is_like_before).then(|| ("How it ended:", run.stop.clone()));
    let warnings = run.warnings.iter().map(|warning| ("Warning:", warning.clone()));
    let said = |(label, text): (&str, String)| format!("<strong>{label}</strong> {}", words_html(text.trim()));
    let all: Vec<String> = standing.into_iter().chain(ending).chain(warnings).map(said).collect();
    if !all.is_empty() {
        let (class, columns, text) = (standing_row_class(run, "remark"), HEAD.len(), all.join(". "));
        let _ = writeln!(out, "<tr{class}><td colspan=\"{columns}\" class=\"wide\">{text}</td></tr>");
    }
    out
}

/// Returns the HTML of an energy in J with two significant digits.
pub fn run_drift_html(drift: f64) -> String {
    if !drift.is_finite() {
        return "<strong>not finite</strong>".to_owned();
    }
    number(&with_significant_digits(drift, 2))
}

/// Returns the HTML name of a run for a sentence.
pub fn run_name(run: &RunRow) -> String {
    match &run.printed {
        Some(id) => format!("<code>printed:{}</code>", escape(id)),
        None => escape(&run.title),
    }
}
