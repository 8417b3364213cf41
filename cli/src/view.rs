//! A motion to be seen: a figure of HTML that turns, plays and speaks, in a page or alone.
//!
//! Invariant: it needs nothing but itself, no network above all; every text that came from a file reaches the browser as text: in HTML
//! through [`escape`], in data through [`as_script`], and from there by `textContent` alone. Absent on purpose: mechanics, which is
//! [`tripos::view`]'s, and libraries.

mod data;

use crate::page::escape;
use data::{as_script, figure_data};
use std::fmt::Write;
use tripos::Mechanism;
use tripos::view::{Form, Motion, View};
use tripos_derive::scene::Scene;

/// The viewer, in the order in which its parts use one another.
const SCRIPT: [&str; 8] = [
    include_str!("view/space.js"),
    include_str!("view/motion.js"),
    include_str!("view/mesh.js"),
    include_str!("view/paint.js"),
    include_str!("view/camera.js"),
    include_str!("view/picture.js"),
    include_str!("view/player.js"),
    include_str!("view/begin.js"),
];
/// How it looks.
pub const STYLE: &str = include_str!("view/style.css");
const PAGE_STYLE: &str = include_str!("view/page.css");

/// Bytes that the data of a motion may take, about.
const ALONE: usize = 800_000;

/// What is to be seen.
pub struct Seen<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// The scene that ran.
    pub scene: &'a Scene,
    /// Its solids.
    pub view: View,
    /// What moved: the first as solids, the others as ghosts.
    pub motions: Vec<Motion>,
    /// The scene's title, or the name of its file.
    pub title: String,
}

/// The most that a body turns by from one picture of a page of its own to the next, rad.
pub fn largest_turn(seen: &Seen<'_>) -> f64 {
    data::largest_turn(seen, ALONE)
}

/// A page of its own.
pub fn document(seen: &Seen<'_>) -> String {
    let (title, scene) = (escape(&seen.mechanism.title), escape(&seen.title));
    let about = if seen.scene.about.is_empty() { String::new() } else { format!(": {}", escape(&seen.scene.about)) };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title} – {scene}</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<style>\n{PAGE_STYLE}{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n\
         <p class=\"scene\">{scene}{about}</p>\n{}</main>\n{}</body>\n</html>\n",
        figure(seen, Home::Alone),
        script(),
    )
}

/// Where a view stands.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Home {
    /// In a file of its own.
    Alone,
}

/// The viewer, once for all views of a page.
pub fn script() -> String {
    format!("<script>\n(() => {{\n'use strict';\n{}}})();\n</script>\n", SCRIPT.concat())
}

/// A view as a figure.
pub fn figure(seen: &Seen<'_>, home: Home) -> String {
    let words = words(seen);
    let label = format!("3-D view of {}, {}: drag to turn, keys are listed below", seen.mechanism.title, seen.title);
    format!(
        "<figure class=\"view\">\n\
         <div class=\"view-stage\" tabindex=\"0\" role=\"application\" aria-label=\"{}\">\n\
         <canvas class=\"view-solids\" aria-hidden=\"true\"></canvas><canvas class=\"view-words\" aria-hidden=\"true\"></canvas>\n{}</div>\n\
         <div class=\"view-bar\">\n<button type=\"button\" class=\"view-play\" aria-label=\"Play\"></button>\n\
         <input type=\"range\" class=\"view-scrub\" min=\"0\" max=\"1000\" step=\"any\" value=\"0\" aria-label=\"Time\">\n\
         <output class=\"view-clock\"></output>\n</div>\n\
         <div class=\"view-more\">\n\
         <label>Speed <select class=\"view-speed\"></select></label>\n\
         <label>Follow <select class=\"view-follow\"></select></label>\n\
         <label>Trace <select class=\"view-trace\"></select></label>\n\
         <label><input type=\"checkbox\" class=\"view-axes\" checked> Axes</label>\n\
         <label><input type=\"checkbox\" class=\"view-names\"> Points</label>\n\
         <label hidden><input type=\"checkbox\" class=\"view-ghosts\" checked> Ghosts</label>\n\
         <button type=\"button\" class=\"view-home\">Reset view</button>\n</div>\n\
         <p class=\"view-said\" aria-live=\"polite\">The view needs JavaScript.</p>\n\
         <figcaption>{words}</figcaption>\n\
         <details><summary>Keys</summary>\n<p>With the picture in focus: <kbd>space</kbd> plays and pauses; <kbd>←</kbd> <kbd>→</kbd> step, \
         <kbd>Home</kbd> <kbd>End</kbd> go to the ends; <kbd>↑</kbd> <kbd>↓</kbd> play faster and slower; \
         <kbd>Shift</kbd> with arrows turns the view; <kbd>+</kbd> <kbd>-</kbd> zoom, <kbd>0</kbd> resets; <kbd>a</kbd> axes, \
         <kbd>n</kbd> names of points, <kbd>g</kbd> ghosts. A finger or the mouse turns the view, two fingers or the right button move it, \
         a pinch or the wheel zooms.</p>\n</details>\n\
         <script type=\"application/json\">{}</script>\n</figure>\n",
        escape(&label),
        legend(seen),
        as_script(&figure_data(seen, home, ALONE)),
    )
}

/// What each motion is, where there is more than one.
fn legend(seen: &Seen<'_>) -> String {
    if seen.motions.len() < 2 {
        return String::new();
    }
    let mut out = String::from("<ul class=\"view-legend\">\n");
    for (at, motion) in seen.motions.iter().enumerate() {
        let mark =
            if at == 0 { "var(--view-body-1)".to_owned() } else { format!("var(--view-ghost-{})", (at - 1) % 4 + 1) };
        let _ = writeln!(out, "<li style=\"--mark: {mark}\">{}</li>", escape(&motion.title));
    }
    out + "</ul>\n"
}

/// What is shown, in words, as HTML.
fn words(seen: &Seen<'_>) -> String {
    let mut out = String::new();
    let kinds: Vec<String> = seen
        .mechanism
        .bodies
        .iter()
        .enumerate()
        .filter_map(|(at, body)| {
            let forms = seen.view.solids.iter().filter(|solid| solid.body == Some(at)).map(|solid| &solid.form);
            let mut nouns: Vec<&str> = forms.map(Form::noun).collect();
            nouns.sort_unstable();
            nouns.dedup();
            (!nouns.is_empty()).then(|| format!("{} ({})", body.name, nouns.join(", ")))
        })
        .collect();
    if let Some(motion) = seen.motions.first() {
        let (from, to) = (motion.t.first().copied().unwrap_or_default(), motion.t.last().copied().unwrap_or_default());
        let _ = write!(out, "The motion from t = {} s to {} s by {}", short(from), short(to), escape(&motion.title));
    }
    let most = 12;
    let more = if kinds.len() > most { format!(" and {} more", kinds.len() - most) } else { String::new() };
    if !kinds.is_empty() {
        let _ = write!(out, ", of {}{more}", escape(&kinds[..kinds.len().min(most)].join(", ")));
    }
    out += ". ";
    out += if seen.view.is_stated {
        "Shapes are those of the model file."
    } else {
        "The model states no shapes: these are made of its bodies, points and joints."
    };
    if seen.motions.len() > 1 {
        let ghosts: Vec<String> = seen.motions[1..].iter().map(|motion| escape(&motion.title)).collect();
        let _ = write!(out, " Seen through, beside it: {}.", ghosts.join(", "));
    }
    for motion in &seen.motions {
        for why in &motion.objections {
            let _ = write!(
                out,
                " <strong class=\"alarm\">{}: {}.</strong>",
                escape(&motion.title),
                escape(why.trim_end_matches('.'))
            );
        }
    }
    out
}

/// A number in some digits.
fn short(x: f64) -> String {
    crate::page::rounded(x, 5).replace('-', "−")
}
