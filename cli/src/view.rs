//! View of a motion: a three-dimensional HTML figure that can be turned and played and describes itself. It is a file
//! of its own or a part of a page.
//!
//! Invariant: a view needs no other file and no network. Text from a file reaches the browser only as text: in HTML
//! through [`escape`], in data through [`as_script`], and from there by `textContent`. The mechanics is in
//! [`tripos::pictures::view`]. No libraries are used.

mod data;
mod live_equations;

use crate::page::escape;
pub use live_equations::LiveEquations;

use data::{as_script, figure_data};
use std::fmt::Write;
use tripos::Mechanism;
use tripos::pictures::view::{ForceArrows, ForceSource, SolidForm, View, ViewMotion};
use tripos_codegen::js::{RUNNERS, javascript_script_text};
use tripos_derive::scene::Scene;

/// JavaScript sources of the viewer. Each source comes after the sources that it needs.
const SCRIPT: [&str; 11] = [
    include_str!("view/space.js"),
    include_str!("view/motion.js"),
    include_str!("view/mesh.js"),
    include_str!("view/paint.js"),
    include_str!("view/arrows.js"),
    include_str!("view/camera.js"),
    include_str!("view/picture.js"),
    include_str!("view/player.js"),
    include_str!("view/poses.js"),
    include_str!("view/curve.js"),
    include_str!("view/live.js"),
];
/// JavaScript that starts a viewer in each figure after the page is loaded.
const BEGIN: &str = include_str!("view/begin.js");
/// CSS text of the viewer in a page.
pub const STYLE: &str = include_str!("view/style.css");
/// CSS of a page that contains only a view.
const PAGE_STYLE: &str = include_str!("view/page.css");

/// Content of a view: the mechanism, its scene, solids and motions.
pub struct ViewContent<'a> {
    /// Mechanism whose motion is shown.
    pub mechanism: &'a Mechanism,
    /// Scene whose motion is shown.
    pub scene: &'a Scene,
    /// Solids of the mechanism, and the size and orientation of the view.
    pub view: View,
    /// Motions of the mechanism: the first is drawn as solids, the others as ghosts.
    pub motions: Vec<ViewMotion>,
    /// Title of the scene, or the name of its file.
    pub title: String,
}

impl ViewContent<'_> {
    /// True if the first motion has forces that are drawn as arrows.
    fn has_arrows(&self) -> bool {
        self.motions.first().is_some_and(|motion| !motion.forces.list.is_empty())
    }
}

/// View together with the equations that it can run in the browser, or the reason why it runs none.
#[derive(Clone, Copy)]
pub struct LiveView<'a> {
    /// Content of the view: mechanism, scene, solids and motions.
    pub seen: &'a ViewContent<'a>,
    /// Equations that the view runs in the browser, or the reason why it runs none.
    pub live: &'a LiveEquations,
}

/// True if the viewer's frames are close enough in time to show correctly how every body rotates.
pub fn turns_truly(seen: &ViewContent<'_>, home: ViewPlace) -> bool {
    data::turns_truly(seen, home.bytes())
}

/// Returns the HTML page of a view that is a file of its own.
pub fn document(seen: &ViewContent<'_>, live: &LiveEquations) -> String {
    let shown = LiveView { seen, live };
    let (title, scene) = (escape(&seen.mechanism.title), escape(&seen.title));
    let about = if seen.scene.about.is_empty() { String::new() } else { format!(": {}", escape(&seen.scene.about)) };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n<title>{title} – {scene}</title>\n\
         <link rel=\"icon\" href=\"data:,\">\n<style>\n{PAGE_STYLE}{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n\
         <p class=\"scene\">{scene}{about}</p>\n{}</main>\n{}</body>\n</html>\n",
        figure(shown, ViewPlace::Alone),
        script(&[shown]),
    )
}

/// Place of a view: a file of its own, or a model's page.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ViewPlace {
    /// The view is an HTML file of its own.
    Alone,
    /// The view is part of a model's page.
    Page,
}

impl ViewPlace {
    /// Returns the largest number of bytes, approximately, of the data of the motions.
    const fn bytes(self) -> usize {
        match self {
            Self::Alone => 800_000,
            Self::Page => 250_000,
        }
    }

    /// Returns the largest number of bytes of the code of the equations that a view runs.
    const fn equations(self) -> usize {
        match self {
            Self::Alone => 400_000,
            Self::Page => 120_000,
        }
    }
}

/// Returns the `<script>` element with the viewer, once for all views of a page. It also contains the equations of the
/// views that run equations.
pub fn script(list: &[LiveView<'_>]) -> String {
    let method: String = RUNNERS.iter().map(|(_, text)| javascript_script_text(text)).collect();
    let equations = list.iter().map(|shown| match shown.live {
        LiveEquations::Runs(running) => running.equations.as_str(),
        LiveEquations::Rests(_) => "null",
    });
    let equations = equations.collect::<Vec<_>>().join(",\n");
    format!(
        "<script>\n(() => {{\n'use strict';\nconst {{ run, assemble }} = (() => {{\n{method}return {{ run, assemble }};\n}})();\n\
         const EQUATIONS = [{equations}];\n{}{BEGIN}}})();\n</script>\n",
        SCRIPT.concat()
    )
}

/// Returns the HTML of a view's figure. It must be the first view of its page.
pub fn figure(shown: LiveView<'_>, home: ViewPlace) -> String {
    let LiveView { seen, live } = shown;
    let words = view_description(seen);
    let label = format!("3-D view of {}, {}: drag to turn, keys are listed below", seen.mechanism.title, seen.title);
    format!(
        "<figure class=\"view{}\">\n\
         <div class=\"view-stage\" tabindex=\"0\" role=\"application\" aria-label=\"{}\">\n\
         <canvas class=\"view-solids\" aria-hidden=\"true\"></canvas><canvas class=\"view-words\" aria-hidden=\"true\"></canvas>\n{}{}</div>\n\
         <div class=\"view-bar\">\n<button type=\"button\" class=\"view-play\" aria-label=\"Play\"></button>\n\
         <input type=\"range\" class=\"view-scrub\" min=\"0\" max=\"1000\" step=\"any\" value=\"0\" aria-label=\"Time\">\n\
         <output class=\"view-clock\"></output>\n</div>\n\
         <div class=\"view-more\">\n\
         <label>Speed <select class=\"view-speed\"></select></label>\n\
         <label>Follow <select class=\"view-follow\"></select></label>\n\
         <label>Trace <select class=\"view-trace\"></select></label>\n\
         <label>Forces <select class=\"view-forces\"></select></label>\n\
         <label><input type=\"checkbox\" class=\"view-axes\" checked> Axes</label>\n\
         <label><input type=\"checkbox\" class=\"view-names\"> Points</label>\n\
         <label hidden><input type=\"checkbox\" class=\"view-ghosts\" checked> Ghosts</label>\n\
         <button type=\"button\" class=\"view-home\">Reset view</button>\n</div>\n\
         <p class=\"view-said\" aria-live=\"polite\">The view needs JavaScript.</p>\n\
         {}<figcaption>{words}</figcaption>\n\
         <details><summary>Keys</summary>\n<p>With the picture in focus: <kbd>space</kbd> plays and pauses; <kbd>←</kbd> <kbd>→</kbd> step, \
         <kbd>Home</kbd> <kbd>End</kbd> go to the ends; <kbd>↑</kbd> <kbd>↓</kbd> play faster and slower; \
         <kbd>Shift</kbd> with arrows turns the view; <kbd>+</kbd> <kbd>-</kbd> zoom, <kbd>0</kbd> resets; <kbd>a</kbd> axes, \
         <kbd>n</kbd> names of points, <kbd>f</kbd> forces, <kbd>g</kbd> ghosts. A finger or the mouse turns the view, two fingers or the right button move it, \
         a pinch or the wheel zooms.</p>\n</details>\n\
         <script type=\"application/json\">{}</script>\n</figure>\n",
        if matches!(live, LiveEquations::Runs(_)) { " live" } else { "" },
        escape(&label),
        legend(seen),
        force_legend(seen),
        live_controls(seen, live),
        as_script(&figure_data(seen, live, home, home.bytes())),
    )
}

/// Returns the HTML of the controls that change the motion, or of the reason why there are none.
fn live_controls(seen: &ViewContent<'_>, live: &LiveEquations) -> String {
    let title = match live {
        LiveEquations::Rests(why) => {
            return format!(
                "<p class=\"view-rests\">This motion is as it was computed: nothing of it can be changed here, since {why}.</p>\n"
            );
        }
        LiveEquations::Runs(running) => escape(&running.title),
    };
    let drawn = if seen.view.is_stated {
        ""
    } else {
        " The file states no shapes: of those that were made, only what touches changes its size."
    };
    let others = match (seen.motions.len() > 1, seen.has_arrows()) {
        (true, true) => " What is seen through, and arrows of forces, are hidden then.",
        (true, false) => " What is seen through is hidden then.",
        (false, true) => " Arrows of forces are hidden then.",
        (false, false) => "",
    };
    let many = |count: usize| if count > 12 { "" } else { " open" };
    let (parameters, start) =
        (seen.mechanism.parameters.len(), seen.mechanism.coordinates.len() + seen.mechanism.speeds.len());
    format!(
        "<section class=\"view-live\" aria-label=\"Change the motion\">\n\
         <canvas class=\"view-curve\" aria-hidden=\"true\"></canvas>\n\
         <div class=\"view-choice\"><label>Curve <select class=\"view-quantity\"></select></label>\n\
         <button type=\"button\" class=\"view-reset\" disabled>Reset numbers</button></div>\n\
         <p class=\"view-ran\" aria-live=\"polite\"></p>\n\
         <details{}><summary>Start ({start})</summary><div class=\"view-start\"></div></details>\n\
         <details{}><summary>Parameters ({parameters})</summary><div class=\"view-parameters\"></div></details>\n\
         <p class=\"view-how\">Move a slider, or type a number: the page runs {title} again, and the motion and the curve follow. The dashed \
         curve is that of the file.{drawn}{others}</p>\n</section>\n",
        many(start),
        many(parameters),
    )
}

/// Returns the HTML legend of the motions; empty for a single motion.
fn legend(seen: &ViewContent<'_>) -> String {
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

/// Returns the HTML legend of the kinds of force arrows; empty without arrows.
fn force_legend(seen: &ViewContent<'_>) -> String {
    let Some(forces) = seen.motions.first().map(|motion| &motion.forces) else { return String::new() };
    let kinds = [
        (ForceSource::Weight, "weight", "weights"),
        (ForceSource::Applied, "applied", "applied forces"),
        (ForceSource::Reaction, "reaction", "forces of constraints"),
    ];
    let there = kinds.iter().filter(|(kind, ..)| forces.list.iter().any(|arrow| arrow.kind == *kind));
    let mut items = String::new();
    for (_, name, words) in there {
        let _ = writeln!(items, "<li style=\"--mark: var(--view-{name})\">{words}</li>");
    }
    if items.is_empty() { items } else { format!("<ul class=\"view-acts\">\n{items}</ul>\n") }
}

/// Returns HTML sentences about forces: the scale of the arrows, and the forces that are not shown.
fn view_forces_in_words(forces: &ForceArrows) -> String {
    let mut out = String::new();
    if !forces.list.is_empty() {
        let largest = forces.largest();
        let _ = write!(out, " Arrows are forces, of at most {} N", view_number_text(largest));
        let cut = ForceArrows::CUT * forces.usual;
        if largest > cut {
            let _ = write!(out, "; those over {} N are cut, and have two heads", view_number_text(cut));
        }
        out += ".";
    }
    if let Some(why) = &forces.without {
        let _ = write!(out, " Forces of constraints are not shown: {}.", escape(why.trim_end_matches('.')));
    }
    if !forces.unknown.is_empty() {
        let names: Vec<String> = forces.unknown.iter().map(|name| escape(name)).collect();
        let _ = write!(out, " Not shown, since they have no value at some instant: {}.", names.join("; "));
    }
    out
}

/// Returns the HTML description of a view in words: bodies, motions, forces and warnings.
fn view_description(seen: &ViewContent<'_>) -> String {
    let mut out = String::new();
    let kinds: Vec<String> = seen
        .mechanism
        .bodies
        .iter()
        .enumerate()
        .filter_map(|(at, body)| {
            let forms = seen.view.solids.iter().filter(|solid| solid.body == Some(at)).map(|solid| &solid.form);
            let mut nouns: Vec<&str> = forms.map(SolidForm::noun).collect();
            nouns.sort_unstable();
            nouns.dedup();
            (!nouns.is_empty()).then(|| format!("{} ({})", body.name, nouns.join(", ")))
        })
        .collect();
    if let Some(motion) = seen.motions.first() {
        let (from, to) = (motion.t.first().copied().unwrap_or_default(), motion.t.last().copied().unwrap_or_default());
        let _ = write!(
            out,
            "The motion from t = {} s to {} s by {}",
            view_number_text(from),
            view_number_text(to),
            escape(&motion.title)
        );
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
    if let Some(motion) = seen.motions.first() {
        out += &view_forces_in_words(&motion.forces);
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

/// Returns a number as text with five significant digits.
fn view_number_text(x: f64) -> String {
    crate::page::rounded_number_html(x, 5).replace('-', "−")
}
