//! The report: one page that needs nothing else, with a derivation and the runs of its equations.
//!
//! Invariant: the same input gives the same bytes, but for times that are measured; every text that came from a file
//! is escaped. Absent on purpose: scripts, outside resources, dates and paths of the machine. Links to the tables of
//! measured figures are all that leads out of the page.

mod advice;
mod content;
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
mod standing;
mod typeset;

pub use content::{Advice, Choice, Fact, Figure, Nearest, Needs, Page, RunRow, SceneSection, Standing};
pub use html::{escape, rounded};
pub use standing::two_digits;

use html::anchor;
use std::fmt::Write;

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
