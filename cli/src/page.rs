//! The report: one page that needs nothing else, with a derivation and the runs of its equations.
//!
//! Invariant: the same input gives the same bytes, but for times that are measured; every text that came from a file is
//! escaped. Absent on purpose: scripts, outside resources, dates and paths of the machine. Links to the tables of
//! measured figures are all that leads out of the page.

mod advice;
mod derivation;
mod errata;
mod html;
mod math;
mod mechanism;
mod motion;
mod needs;
mod proof;
mod scene;
mod singular;
mod typeset;

use html::{anchor, escape};
use std::fmt::Write;
use tripos::reduced::Reduced;
use tripos::study::Study;
use tripos_codegen::plan::Costs;
use tripos_derive::mechanics::DerivationInSteps;
use tripos_derive::{Formulation, Model};

/// What the page shows.
pub struct Page<'a> {
    /// The mechanism.
    pub model: &'a Model,
    /// Its equations of motion by each formulation, or why there are none.
    pub derivations: Vec<(Formulation, Result<DerivationInSteps, String>)>,
    /// What is proved of them, and the report beside the model, judged.
    pub study: &'a Study,
    /// The simulations.
    pub scenes: Vec<SceneSection>,
    /// Why there are not all of them, if there are not.
    pub unfinished: Option<String>,
    /// The command that made the page.
    pub command: String,
}

/// One simulated scene.
pub struct SceneSection {
    /// Its title.
    pub title: String,
    /// What it shows.
    pub about: String,
    /// (what, value): parameters, start, tolerances.
    pub facts: Vec<(String, String)>,
    /// Its own equations, or why there are none.
    pub needs: Result<Needs, String>,
    /// One run for each formulation, one by the scene's own equations, then one for each printed system.
    pub runs: Vec<RunRow>,
    /// Printed systems that could not be run: (title, why).
    pub not_run: Vec<(String, String)>,
    /// Its figures.
    pub figures: Vec<Figure>,
    /// Figures that it cannot have, and why.
    pub not_drawn: Vec<String>,
    /// What to run it by, if that was measured.
    pub advice: Option<Advice>,
    /// First integrals over time, if there are any.
    pub integrals: Option<Figure>,
    /// Determinants, condition numbers and kinematic divisors over time.
    pub nearness: Option<Figure>,
}

/// What a scene needs of its model.
pub struct Needs {
    /// Its own equations.
    pub reduced: Reduced,
    /// What a call of them costs beside one of the whole model.
    pub costs: Costs,
}

/// What came of one run.
pub struct RunRow {
    /// Which equations ran, as in a heading.
    pub title: String,
    /// The id of the printed system; none for derived equations.
    pub printed: Option<String>,
    /// The integration method.
    pub method: String,
    /// `compiled` or `interpreted`.
    pub code: String,
    /// Accepted steps.
    pub steps: u64,
    /// Rejected steps.
    pub rejected: u64,
    /// Calls of the right-hand side.
    pub evaluations: u64,
    /// Where the run ended, s.
    pub t_end: f64,
    /// Whether it reached the end that was asked for.
    pub arrived: bool,
    /// Why it ended, as a sentence.
    pub stop: String,
    /// Whether the run went as far as its equations hold and it was asked to.
    pub trusted: bool,
    /// Largest change of total energy, J; none of equations that do not know it.
    pub energy_drift: Option<f64>,
    /// What else the reader should know.
    pub warnings: Vec<String>,
    /// Largest change of each first integral; nothing of a run that does not show every state.
    pub changes: Vec<f64>,
    /// How near it came to singular places.
    pub nearest: Nearest,
}

/// Extremes along a run: (value, time), nothing where no sample has a value.
#[derive(Default)]
pub struct Nearest {
    /// The least and the greatest determinant.
    pub determinant: Option<(f64, f64)>,
    /// The least |det A / det A(t₀)|.
    pub relative: Option<(f64, f64)>,
    /// The least reciprocal condition number.
    pub condition: Option<(f64, f64)>,
    /// The least absolute value of each divisor of the kinematic equations.
    pub divisors: Vec<Option<(f64, f64)>>,
}

/// A figure and its caption.
pub struct Figure {
    /// The caption.
    pub caption: String,
    /// An `<svg>` element.
    pub svg: String,
    /// What to learn from it, below the caption.
    pub remark: Option<String>,
    /// Tables with every plotted point, relative to the page.
    pub data: Vec<String>,
}

/// Which equations, solve and method to use, as measured.
pub struct Advice {
    /// In words.
    pub lead: String,
    /// (accuracy, the fastest run that reaches it).
    pub rows: Vec<(f64, Option<Choice>)>,
}

/// One run that was measured.
pub struct Choice {
    /// The name of the equations.
    pub equations: String,
    /// How accelerations were found.
    pub solve: &'static str,
    /// The method.
    pub method: &'static str,
    /// Its tolerance; none where no steps are taken.
    pub tolerance: Option<f64>,
    /// How long it took, s.
    pub seconds: f64,
    /// Its error.
    pub error: f64,
}

/// The page as HTML.
pub fn render(page: &Page) -> String {
    let title = escape(&page.model.title);
    let mut body = page
        .unfinished
        .as_ref()
        .map_or_else(String::new, |why| format!("<p class=\"missing\">This page is partial: {}.</p>\n", escape(why)));
    body += &mechanism::section(page.model);
    let mut shown = Vec::new();
    for (formulation, result) in &page.derivations {
        body += &derivation::section(page.model, *formulation, result, &mut shown);
    }
    body += &proof::section(page.model, page.study);
    if let Some(published) = &page.study.published {
        body += &errata::section(page, published);
    }
    if !page.scenes.is_empty() {
        body += "<section id=\"simulation\">\n<h2>Simulation</h2>\n";
        let mut figures = 0;
        for (at, scene) in page.scenes.iter().enumerate() {
            body += &scene::section(page, scene, at, &mut figures);
        }
        body += "</section>\n";
    }
    let source = match page.model.reference.as_str() {
        "" => String::new(),
        reference => format!("<p class=\"source\">{}</p>\n", escape(reference)),
    };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n<style>\n{}</style>\n</head>\n\
         <body>\n<header>\n<h1>{title}</h1>\n{source}<p class=\"count\">{}.</p>\n</header>\n{}<main>\n{body}</main>\n\
         {}</body>\n</html>\n",
        include_str!("page/style.css"),
        escape(&page.model.count()),
        contents(page),
        footer(page),
    )
}

fn contents(page: &Page) -> String {
    let mut out = String::from("<nav aria-label=\"Contents\">\n<ul>\n<li><a href=\"#mechanism\">Mechanism</a></li>\n");
    for (formulation, result) in &page.derivations {
        let missing = if result.is_err() { " <span class=\"quiet\">(not derived)</span>" } else { "" };
        let (name, title) = (formulation.name(), escape(formulation.title()));
        let _ = writeln!(out, "<li><a href=\"#{name}\">{title}</a>{missing}</li>");
    }
    out += "<li><a href=\"#proof\">Proof</a></li>\n";
    if page.study.published.is_some() {
        out += "<li><a href=\"#errata\">Errata</a></li>\n";
    }
    if !page.scenes.is_empty() {
        out += "<li><a href=\"#simulation\">Simulation</a>\n<ul>\n";
        for (at, scene) in page.scenes.iter().enumerate() {
            let _ = writeln!(out, "<li><a href=\"#{}\">{}</a></li>", anchor(at), escape(&scene.title));
        }
        out += "</ul></li>\n";
    }
    out + "</ul>\n</nav>\n"
}

fn footer(page: &Page) -> String {
    format!(
        "<footer>\n<p>To make this page again: <code>{}</code>. The equations carry the mark <code>{}</code> of the \
         model text that they were derived from.</p>\n</footer>\n",
        escape(&page.command),
        escape(&page.model.text_hash()),
    )
}

#[cfg(test)]
mod tests;
