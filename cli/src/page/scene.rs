//! One simulated scene: what was given, how each run went, figures.

use super::html::{anchor, each, escape, head, number, scroll};
use super::{RunRow, SceneSection};
use crate::plot::pretty;
use std::fmt::Write;

const HEAD: [&str; 9] = [
    "Formulation",
    "Result",
    "Ended at [s]",
    "Energy change [J]",
    "Steps",
    "Rejected",
    "Evaluations",
    "Method",
    "Code",
];

/// The part of one scene. `figures` counts figures over the whole page.
pub fn section(scene: &SceneSection, at: usize, figures: &mut usize) -> String {
    let mut out = format!("<article id=\"{}\">\n<h3>{}</h3>\n", anchor(at), escape(&scene.title));
    if !scene.about.is_empty() {
        let _ = writeln!(out, "<p>{}</p>", escape(&scene.about));
    }
    if !scene.facts.is_empty() {
        out += "<dl>\n";
        for (what, value) in &scene.facts {
            let _ = writeln!(out, "<div><dt>{}</dt><dd>{}</dd></div>", escape(what), escape(&fact(value)));
        }
        out += "</dl>\n";
    }
    if !scene.runs.is_empty() {
        out += &runs(scene);
    }
    for figure in &scene.figures {
        *figures += 1;
        let _ = write!(
            out,
            "<figure>\n<div class=\"card\">\n{}</div>\n<figcaption>Figure {figures}. {}</figcaption>\n</figure>\n",
            figure.svg,
            escape(&figure.caption)
        );
    }
    out + "</article>\n"
}

/// `q1 = 0.2, q2 = 1e-3` with subscripts; other texts as they are.
fn fact(value: &str) -> String {
    let assignment = |text: &str| match text.split_once(" = ") {
        Some((name, value)) => format!("{}\u{a0}=\u{a0}{}", pretty(name), value.replace('-', "−")),
        None => text.to_owned(),
    };
    value.split(", ").map(assignment).collect::<Vec<_>>().join(", ")
}

fn runs(scene: &SceneSection) -> String {
    let (head, rows) = (head(&HEAD), each(&scene.runs, run));
    let table = format!(
        "<table class=\"runs\">\n<caption>Runs</caption>\n{head}<tbody>\n{rows}</tbody>\n\
         </table>\n"
    );
    scroll(&format!("Runs of {}", scene.title), &table)
}

/// One row of numbers; below it how a run ended that cannot be trusted, and warnings.
fn run(run: &RunRow) -> String {
    let class = if run.trusted { "" } else { " class=\"untrusted\"" };
    let result = if run.trusted { escape(&run.stop) } else { "<strong>not trusted</strong>".to_owned() };
    let mut out = format!(
        "<tr{class}><th scope=\"row\">{}</th><td class=\"result\">{result}</td><td class=\"n\">{}</td><td class=\"n\">{}</td>\
         <td class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td><td>{}</td></tr>\n",
        escape(&run.formulation),
        number(&rounded(run.t_end)),
        energy(run.energy_drift),
        run.steps,
        run.rejected,
        run.evaluations,
        escape(&run.method),
        escape(&run.code),
    );
    let mut remark = |label: &str, text: &str| {
        let (columns, text) = (HEAD.len() - 1, escape(text.trim()));
        let _ = writeln!(
            out,
            "<tr class=\"remark{}\"><td></td><td colspan=\"{columns}\"><strong>{label}</strong> {text}</td></tr>",
            if run.trusted { "" } else { " untrusted" }
        );
    };
    if !run.trusted {
        remark("How it ended:", &run.stop);
    }
    for warning in &run.warnings {
        remark("Warning:", warning);
    }
    out
}

/// Six significant digits, without trailing zeros.
fn rounded(x: f64) -> String {
    let short = format!("{x:.5e}").parse::<f64>().unwrap_or(x);
    if short != 0.0 && !(1e-4..1e6).contains(&short.abs()) { format!("{short:e}") } else { short.to_string() }
}

/// Two significant digits.
fn energy(drift: f64) -> String {
    if !drift.is_finite() {
        return "<strong>not finite</strong>".to_owned();
    }
    let digits = format!("{drift:.1e}");
    match digits.parse::<f64>() {
        Ok(short) if short == 0.0 || (1e-2..1e4).contains(&short.abs()) => number(&short.to_string()),
        _ => number(&digits),
    }
}
