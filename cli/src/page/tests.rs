//! The page as a whole: well formed, escaped, the same each time.

use super::*;
use crate::plot::{Panel, Series, draw};
use tripos_derive::derive;
use tripos_derive::diagnostic::Source;

const PENDULUM: &str = r#"
name = "A <b>bob</b> & \"string\""
source = "R&D <notes>"
[parameters]
m = { unit = "kg", value = 2, positive = true, about = "mass & <more>" }
l = { unit = "m", value = 1, positive = true }
g = { unit = "m/s^2", value = 9.81 }
[coordinates]
q1 = { unit = "rad", about = "angle" }
[speeds]
u1 = "q1'"
[inertial]
frame = "N"
origin = "O"
[frames]
B = { from = "N", axis = 3, angle = "q1" }
[points]
P = { from = "O", frame = "B", position = ["l", "0", "0"] }
[particles.bob]
point = "P"
mass = "m"
[gravity]
frame = "N"
acceleration = ["g", "0", "0"]
"#;

/// Where the tags of a page stop matching, if anywhere. Knows only what the page contains.
fn unbalanced(html: &str) -> Option<String> {
    const VOID: [&str; 2] = ["meta", "!DOCTYPE"];
    let mut open: Vec<&str> = Vec::new();
    for piece in html.split('<').skip(1) {
        let Some((tag, _)) = piece.split_once('>') else { return Some(format!("no end: {piece}")) };
        let name = tag.trim_start_matches('/').split([' ', '\n', '/']).next().unwrap_or_default();
        if VOID.contains(&name) || tag.ends_with('/') {
            continue;
        }
        if !tag.starts_with('/') {
            open.push(name);
        } else if open.pop() != Some(name) {
            return Some(format!("</{name}> after <{}>", open.join("><")));
        }
    }
    open.pop().map(|name| format!("<{name}> is never closed"))
}

fn scene() -> SceneSection {
    let run = |formulation: &str, trusted: bool| RunRow {
        formulation: formulation.to_owned(),
        method: "dop853".to_owned(),
        code: "compiled".to_owned(),
        steps: 40,
        rejected: 2,
        evaluations: 500,
        t_end: 0.931_234_567,
        stop: "component 3 < 0 is not finite".to_owned(),
        trusted,
        energy_drift: if trusted { 1.25e-9 } else { f64::NAN },
        warnings: vec!["M is <badly> conditioned".to_owned()],
    };
    let series = Series { label: "K & <L>".to_owned(), style: 0, points: vec![(0.0, 1.0), (1.0, 2.0)] };
    let panel = Panel {
        title: "<T>".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: "a < \"b\" [J]".to_owned(),
        series: vec![series],
        note: Some("ends & stops".to_owned()),
    };
    SceneSection {
        title: "Fall <1>".to_owned(),
        about: "a & b".to_owned(),
        facts: vec![("Start".to_owned(), "q1 = -0.5, u1 = 0".to_owned())],
        runs: vec![run("Kane's method", true), run("Lagrange's equations", false)],
        figures: vec![Figure { caption: "x > y".to_owned(), svg: draw(&[panel], 1).unwrap() }],
    }
}

fn page() -> String {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", PENDULUM)).unwrap();
    let derivations = Formulation::ALL.map(|f| (f, derive(&model, f).map_err(|error| error.to_string()))).to_vec();
    render(&Page { model: &model, derivations, scenes: vec![scene()], command: "tripos report <x>".to_owned() })
}

#[test]
fn every_tag_of_a_page_is_closed() {
    assert_eq!(unbalanced(&page()), None);
    assert!(unbalanced("<p><b></p>").is_some(), "the check itself sees a fault");
}

#[test]
fn texts_of_the_model_are_escaped() {
    let page = page();
    for text in ["<b>bob", "R&D", "mass & <more>", "Fall <1>", "<badly>", "report <x>", "K & <L>"] {
        assert!(!page.contains(text), "`{text}` stands unescaped");
    }
    assert!(page.contains("<h1>A &lt;b&gt;bob&lt;/b&gt; &amp; &quot;string&quot;</h1>"));
}

#[test]
fn a_page_is_the_same_each_time() {
    assert_eq!(page(), page());
}

#[test]
fn a_page_needs_nothing_else() {
    for foreign in ["<script", "<link", "src=", "url(", "@import", "https://"] {
        assert!(!page().contains(foreign), "{foreign}");
    }
}

#[test]
fn an_untrusted_run_is_shown_with_its_reason() {
    let page = page();
    assert!(page.contains("<tr class=\"untrusted\"><th scope=\"row\">Lagrange's equations</th>"));
    assert!(page.contains("<strong>not trusted</strong>"));
    assert!(page.contains("<strong>How it ended:</strong> component 3 &lt; 0 is not finite"));
}

#[test]
fn names_of_steps_are_typeset() {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", PENDULUM)).unwrap();
    for name in ["omega(B) @ N [1]", "v(Pstar) @ B [3]", "d v(P) @ N [1]/d u1", "F[u1]", "Q[q1]", "T", "q1'"] {
        let typeset = math::step_name(&model, name);
        assert_eq!(unbalanced(&typeset), None, "{name}");
        assert!(!typeset.contains(['@', '[', '\'']), "{name}: {typeset}");
    }
    assert!(math::step_name(&model, "v(P) @ B [2]").contains("<mprescripts/><mrow></mrow><mi>N</mi>"));
}
