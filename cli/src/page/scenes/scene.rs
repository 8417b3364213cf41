//! Section of the page about one scene: outcome in sentences, runs, figures and given data. Long parts are folded.

use crate::page::content::{Figure, Page, SceneFact, SceneSection};
use crate::page::markup::html::{address, escape, foldable_part, folded_html, words_html};
use crate::page::scenes::advice;
use crate::page::scenes::outcome;
use crate::page::scenes::reduced_equations;
use crate::page::scenes::runs;
use crate::page::scenes::singular_matrices;
use crate::plot::figure_text_in_symbols;
use std::fmt::Write;

/// Largest number of figures of a scene that are not folded.
const SEEN: usize = 2;

/// Choice of the parts of a scene's section that are visible before it is unfolded.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum VisiblePart {
    /// The outcome, the runs and the first figures of the scene are visible.
    Open,
    /// Only the outcome of the scene is visible.
    InASentence,
}

/// Returns the HTML id of a scene's section on the page. The index `scene` counts from 0, the number in the id from 1.
pub fn scene_anchor(scene: usize) -> String {
    format!("scene-{}", scene + 1)
}

/// Returns the HTML section of one scene. `at` is its index; `figures` counts the figures of the
/// whole page.
pub fn section(page: &Page, scene: &SceneSection, at: usize, shown: VisiblePart, figures: &mut usize) -> String {
    let place = scene_anchor(at);
    let mut out = format!("<article id=\"{place}\">\n<h3>{}</h3>\n", escape(&scene.title));
    let about = match scene.about.as_str() {
        "" => String::new(),
        about => format!("<p>{}</p>\n", escape(about)),
    };
    let printed = page.study.published.as_ref().and_then(|_| outcome::printed_outcome(scene));
    let sentences: Vec<String> = std::iter::once(outcome::derived_outcome(scene)).chain(printed).collect();
    let _ = writeln!(out, "<p class=\"outcome\">{}</p>", sentences.join(" "));
    let content = scene_content(page, scene, &place, figures);
    out += &match shown {
        VisiblePart::Open => about + &content,
        VisiblePart::InASentence => folded_html("Runs, figures and numbers", &(about + &content)),
    };
    out + "</article>\n"
}

/// Returns the HTML of a scene's section without title and outcome. Long parts are folded.
fn scene_content(page: &Page, scene: &SceneSection, place: &str, figures: &mut usize) -> String {
    let id = |what: &str| format!("{place}-{what}");
    let mut out = String::new();
    if !scene.runs.is_empty() {
        out += &runs::runs_table(page, scene);
    }
    let (seen, others) = scene.figures.split_at(scene.figures.len().min(SEEN));
    out.extend(seen.iter().map(|shown| figure_html(shown, figures)));
    out.extend(scene.not_drawn.iter().map(|why| format!("<p class=\"missing\">{}</p>\n", escape(why))));
    if let Some(measured) = &scene.advice {
        out += &advice::section(measured, &id("advice"));
    }
    if !others.is_empty() {
        let others: String = others.iter().map(|shown| figure_html(shown, figures)).collect();
        out += &foldable_part(&id("figures"), "More figures", &others);
    }
    out += &foldable_part(&id("needs"), "What the scene needs", &reduced_equations::section(page, scene));
    if let Some(shown) = &scene.integrals {
        let content = figure_html(shown, figures) + &runs::integral_changes_table(page, scene);
        out += &foldable_part(&id("integrals"), "First integrals along the runs", &content);
    }
    if let Some(shown) = &scene.nearness {
        let content = figure_html(shown, figures) + &singular_matrices::singularity_statements(page, scene);
        out += &foldable_part(&id("singular"), "Does a matrix become singular?", &content);
    }
    out + &given_data_html(scene, &id("given"))
}

/// Returns the HTML of the given data of a scene: parameters, start, span and integration. Empty if there are none.
fn given_data_html(scene: &SceneSection, place: &str) -> String {
    if scene.facts.is_empty() {
        return String::new();
    }
    let facts = scene.facts.iter().fold(String::new(), |mut out, (what, value)| {
        let _ = writeln!(out, "<div><dt>{}</dt><dd>{}</dd></div>", escape(what), escape(&fact_text(value)));
        out
    });
    foldable_part(place, "What is given", &format!("<dl>\n{facts}</dl>\n"))
}

/// Returns the HTML of a numbered figure with caption, links to data and remark. Increases the number `count`.
fn figure_html(figure: &Figure, count: &mut usize) -> String {
    *count += 1;
    let link = |path: &String| format!("<a href=\"{}\"><code>{}</code></a>", address(path), escape(path));
    let data = match figure.data.iter().map(link).collect::<Vec<_>>().join(", ") {
        links if links.is_empty() => links,
        links => format!(" Data: {links}."),
    };
    let remark = figure.remark.as_ref().map_or_else(String::new, |remark| format!("<p>{}</p>\n", words_html(remark)));
    format!(
        "<figure>\n<div class=\"card\">\n{}</div>\n<figcaption>Figure {count}. {}{data}</figcaption>\n</figure>\n{remark}",
        figure.svg,
        words_html(&figure.caption)
    )
}

/// Returns given data as text: `q₁ = 0.2, q₂ = 1e−3`, or words.
fn fact_text(fact: &SceneFact) -> String {
    match fact {
        SceneFact::Words(words) => words.clone(),
        SceneFact::Values(list) => {
            let one = |(name, value): &(String, f64)| {
                format!("{}\u{a0}=\u{a0}{}", figure_text_in_symbols(name), value.to_string().replace('-', "−"))
            };
            list.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}
