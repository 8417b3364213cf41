//! Page about a model: one HTML file without outside resources, with a derivation and the runs of its equations.
//!
//! Parts are ordered by importance: an abstract, the motion, the mistakes in print, the runs, then equations, proofs
//! and derivations. Long parts are folded.
//!
//! Invariant: equal input gives equal bytes, except for measured times. Every text from a file is escaped, and every
//! link inside the page has a target. Two scripts in the page open the folded target of a link and move the motion;
//! without scripts the page has the same content. Absent on purpose: outside resources, which the page's policy
//! forbids, dates, and paths of the machine. Links out of the page lead only to the tables of measured figures.

mod abstract_section;
mod content;
pub mod markup;
mod model;
mod print;
mod scenes;

pub use content::{
    Advice, ClaimOutcome, ClaimRow, Figure, MotionFigure, Page, RecommendedRun, ReducedEquationsContent, RunRow,
    SceneFact, SceneSection, SingularityDistances, SketchPicture, Standing, Viewer,
};
pub use markup::html::{escape, rounded_number_html};

use markup::html::link;
use scenes::scene::{VisiblePart, scene_anchor};
use std::fmt::Write;
use tripos_derive::Formulation;
use tripos_derive::mechanics::DerivationInSteps;

/// Content security policy of the page: it may load and run only its own content.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:";

/// Returns the page as HTML text.
pub fn render_page(page: &Page) -> String {
    let title = escape(&page.model.title);
    let viewer = page.moving.as_ref().and_then(|moving| moving.viewer.as_ref().ok());
    let source = match page.model.reference.as_str() {
        "" => String::new(),
        reference => format!("<p class=\"source\">{}</p>\n", escape(reference)),
    };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title}</title>\n<style>\n{}{}</style>\n</head>\n\
         <body>\n<header>\n<h1>{title}</h1>\n{source}</header>\n<main>\n{}{}</main>\n\
         {}<script>\n{}</script>\n{}</body>\n</html>\n",
        include_str!("page/style.css"),
        viewer.map_or("", |viewer| viewer.style),
        abstract_section::section(page),
        page_sections(page),
        page_footer(page),
        include_str!("page/open.js"),
        viewer.map_or("", |viewer| viewer.script.as_str()),
    )
}

/// Returns the HTML of all sections after the abstract, in order of importance.
fn page_sections(page: &Page) -> String {
    let mut out = table_of_contents(page);
    if let Some(why) = &page.unfinished {
        let _ = writeln!(out, "<p class=\"missing\">This page is partial: {}.</p>", escape(why));
    }
    out += &page.moving.as_ref().map_or_else(String::new, |moving| scenes::motion_section::section(page, moving));
    if let Some(published) = &page.study.published {
        out += &print::errata::section(page, published);
    }
    out += &scenes::claims::section(page);
    out += &page_scenes_section(page);
    out += &model::mechanism::section(page.model);
    out += "<section id=\"equations\">\n<h2>Equations of motion</h2>\n";
    for (formulation, result) in &page.derivations {
        out += &model::derivation::section(page, *formulation, result);
    }
    out += "</section>\n";
    out += &model::proof::section(page);
    out + &derivations_section(page)
}

/// Returns the HTML of the scenes. The scene whose motion is shown is unfolded; the other scenes are folded.
fn page_scenes_section(page: &Page) -> String {
    if page.scenes.is_empty() {
        return String::new();
    }
    let open = page.moving.as_ref().map_or(0, |moving| moving.scene);
    let mut out = String::from("<section id=\"simulation\">\n<h2>Simulation</h2>\n");
    let mut figures = 0;
    for (at, scene) in page.scenes.iter().enumerate() {
        let shown = if at == open { VisiblePart::Open } else { VisiblePart::InASentence };
        out += &scenes::scene::section(page, scene, at, shown, &mut figures);
    }
    out + "</section>\n"
}

/// Returns the HTML of the derivations of all formulations, stage by stage.
fn derivations_section(page: &Page) -> String {
    let mut shown = Vec::new();
    let steps = page.derivations.iter();
    let steps: String = steps.map(|(f, result)| model::derivation::steps(page, *f, result, &mut shown)).collect();
    format!("<section id=\"derivations\">\n<h2>Derivations, step by step</h2>\n{steps}</section>\n")
}

/// Returns the HTML of the table of contents.
fn table_of_contents(page: &Page) -> String {
    let scenes: Vec<String> =
        page.scenes.iter().enumerate().map(|(at, scene)| link(&scene_anchor(at), &escape(&scene.title))).collect();
    let formulations: Vec<String> =
        page.derivations.iter().map(|(of, result)| page_contents_entry(*of, result)).collect();
    let entries = [
        page.moving.as_ref().map(|_| ("motion", "The motion", Vec::new())),
        page.study.published.as_ref().map(|_| ("errata", "Errata", Vec::new())),
        page.scenes.iter().any(|scene| !scene.claims.is_empty()).then_some((
            "claims",
            "Claims about the motions",
            Vec::new(),
        )),
        (!scenes.is_empty()).then_some(("simulation", "Simulation", scenes)),
        Some(("mechanism", "Mechanism", Vec::new())),
        Some(("equations", "Equations of motion", formulations)),
        Some(("proof", "Proof", Vec::new())),
        Some(("derivations", "Derivations", Vec::new())),
    ];
    let mut out = String::from("<nav aria-label=\"Contents\">\n<ul>\n");
    for (place, title, inside) in entries.into_iter().flatten() {
        let inside = if inside.is_empty() { String::new() } else { format!(": {}", inside.join(" · ")) };
        let _ = writeln!(out, "<li>{}{inside}</li>", link(place, title));
    }
    out + "</ul>\n<button type=\"button\" id=\"unfold\" hidden>Unfold all parts, for printing</button>\n</nav>\n"
}

/// Returns the HTML of a formulation's entry in the table of contents.
fn page_contents_entry(formulation: Formulation, result: &Result<DerivationInSteps, String>) -> String {
    let missing = if result.is_err() { " <span class=\"quiet\">(not derived)</span>" } else { "" };
    format!("{}{missing}", link(formulation.name(), &escape(formulation.title())))
}

/// Returns the HTML of the footer: the command that writes this page, and the hash of the model text.
fn page_footer(page: &Page) -> String {
    format!(
        "<footer>\n<p>To make this page again: <code>tripos page {}</code>. The equations carry the mark <code>{}</code> of the \
         model text that they were derived from.</p>\n</footer>\n",
        escape(&page.file),
        escape(&page.model.text_hash()),
    )
}

#[cfg(test)]
mod links_and_abstract_tests;
#[cfg(test)]
mod tests;
