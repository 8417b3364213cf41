//! Tests of the whole page: its HTML is well formed and escaped, and the same in each run.

use super::markup::formula_mathml;
use crate::page::*;
use crate::plot::{Panel, Scale, Series, draw};
use std::path::Path;
use tripos::ReducedScene;
use tripos::studies::model_analysis::ModelAnalysis;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{EnergyQuantity, LineName, QuantityKind, VectorName, derive_in_steps};
use tripos_derive::{Formulation, Model};

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

/// Returns the first place where the tags of a page do not match; `None` if all match. Only the elements that occur on
/// the page are supported.
pub fn unbalanced(html: &str) -> Option<String> {
    const VOID: [&str; 5] = ["meta", "!DOCTYPE", "br", "wbr", "col"];
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
    let loose = |error| Standing::Loose { how: "ode45 with rtol 1e-3".to_owned(), error };
    let run = |title: &str, printed: Option<&str>, standing: Standing| RunRow {
        title: title.to_owned(),
        printed: printed.map(str::to_owned),
        method: "dop853",
        code: "compiled".to_owned(),
        steps: 40,
        rejected: 2,
        evaluations: 500,
        t_end: 0.931_234_567,
        arrived: standing != Standing::Stopped,
        stop: "component 3 < 0 is not finite".to_owned(),
        digits: Some(6.25),
        few_from: (printed.is_none() && standing != Standing::Right).then_some(0.5),
        energy_drift: Some(if standing == Standing::Stopped { f64::NAN } else { 1.25e-9 }),
        standing,
        warnings: vec!["M is <badly> conditioned".to_owned()],
        changes: vec![if printed.is_some() { 0.25 } else { 3e-9 }],
        nearest: SingularityDistances {
            determinant: Some((8.0, 8.0)),
            relative: Some((1.0, 0.0)),
            condition: Some((1.25e-7, 0.5)),
            divisors: Vec::new(),
        },
    };
    let series = || Series::curve("K & <L>".to_owned(), 0, vec![(0.0, 1.0), (1.0, 2.0)]);
    let panel = || Panel {
        title: "<T>".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: "a < \"b\" [J]".to_owned(),
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        series: vec![series()],
        note: Some("ends & stops".to_owned()),
    };
    let data = vec!["fall <2>/work_precision.csv".to_owned()];
    let figure = |caption: &str| Figure {
        caption: caption.to_owned(),
        svg: draw(&[panel()], 1).unwrap(),
        remark: Some("<errors> differ".to_owned()),
        data: data.clone(),
    };
    let choice = RecommendedRun {
        equations: "kane & <sons>".to_owned(),
        solve: "eliminated",
        method: "dop853",
        tolerance: Some(1e-9),
        seconds: 2.5e-4,
        error: 7.421e-7,
    };
    SceneSection {
        file: "fall <2>.toml".to_owned(),
        title: "Fall <1>".to_owned(),
        about: "a & b".to_owned(),
        needs: needs(),
        facts: vec![("Start", SceneFact::Values(vec![("q1".to_owned(), -0.5), ("u1".to_owned(), 0.0)]))],
        runs: vec![
            run("Kane's method", None, Standing::Right),
            run("Lagrange's equations", None, Standing::Stopped),
            run("Newton–Euler equations", None, loose(Ok(0.25))),
            run("Reduced equations", None, loose(Err("no <way> there".to_owned()))),
            run("Kane's method as printed (swing)", Some("swing"), Standing::Wrong),
            run("Kane's method as printed (scaled)", Some("scaled"), Standing::Right),
        ],
        claims: vec![
            claim("q1 < <2>", "the angle <stays>", ClaimOutcome::Proved),
            claim("q1 < 0.1", "", ClaimOutcome::Refuted { by: 0.25 }),
            claim("q1 > 0", "", ClaimOutcome::Open { proved_to: Some(0.5) }),
            claim("q1 > 1", "", ClaimOutcome::NotJudged("no <series>".to_owned())),
        ],
        not_run: vec![("printed:<odd>".to_owned(), "it mentions `<N>`".to_owned())],
        figures: vec![figure("x > y")],
        not_drawn: vec!["`passages` cannot be drawn: <no divisor>".to_owned()],
        advice: Some(Advice { lead: "Use <dop853>".to_owned(), rows: vec![(1e-6, Some(choice)), (1e-9, None)] }),
        integrals: Some(figure("I & I")),
        nearness: Some(figure("A & A")),
    }
}

/// Returns a row of the table of claims.
fn claim(text: &str, printed: &str, outcome: ClaimOutcome) -> ClaimRow {
    let [claim, printed] = [text, printed].map(str::to_owned);
    ClaimRow { claim, equations: "Kane's <method>".to_owned(), printed, about: "as x < y says".to_owned(), outcome }
}

/// Returns the reduced equations for the pendulum's swing, with the angle as the only output.
fn needs() -> Result<ReducedEquationsContent, String> {
    let mut model = tripos_derive::model::load(&Source::from_text("no/such/place/model.toml", PENDULUM)).unwrap();
    let text = "span = [0, 1]\noutputs = [\"q1\"]\n[start]\nq1 = 0.5\nu1 = 0\n";
    let scene = tripos_derive::scene::load(&Source::from_text("scene.toml", text), &mut model).unwrap();
    let reduced = ReducedScene::new(&model, &scene).map_err(|failure| failure.to_string())?;
    let costs = tripos_codegen::plan::scene_costs(&model, &reduced.reduction).unwrap();
    Ok(ReducedEquationsContent { reduced, costs })
}

/// Returns a page about the pendulum.
pub fn page() -> String {
    page_of(&tripos_derive::model::load(&Source::from_text("no/such/place/model.toml", PENDULUM)).unwrap())
}

fn page_of(model: &Model) -> String {
    let derivations =
        Formulation::STANDARD.map(|f| (f, derive_in_steps(model, f, None).map_err(|error| error.to_string()))).to_vec();
    let (study, broken) = ModelAnalysis::new(model, &[]).unwrap();
    assert!(broken.is_none(), "{}", broken.unwrap());
    let file = "<x>".to_owned();
    render_page(&Page {
        model,
        derivations,
        study: &study,
        scenes: vec![scene(), scene()],
        sketch: Ok(drawing()),
        moving: Some(moving()),
        unfinished: None,
        file,
    })
}

/// Returns a picture that replaces the sketch.
fn drawing() -> SketchPicture {
    SketchPicture { svg: "<svg class=\"sketch\"></svg>".to_owned(), caption: "Drawn at <rest>.".to_owned() }
}

/// Returns a moving figure that replaces the viewer.
fn moving() -> MotionFigure {
    let viewer = Viewer {
        figure: "<figure class=\"view\"></figure>\n".to_owned(),
        style: ".view { color: red; }\n",
        script: "<script>\nplay();\n</script>\n".to_owned(),
        doubt: Some("it turns <fast>".to_owned()),
    };
    MotionFigure { scene: 0, viewer: Ok(viewer) }
}

/// Publication about the pendulum: an error, a factor, a system with wrong gravity, and a system that contains the
/// state only.
const PUBLICATION: &str = r#"
title = "A <course> report & more"
source = "Smith & Sons"
[[equation]]
id = "1-T"
section = "1"
quantity = "T"
printed = "m*l^2*u1^2/2"
[[equation]]
id = "2-V<1>"
section = "2"
quantity = "V"
printed = "m*g*l*(1 - cos(q1))/2"
note = "hard to <read>"
[[definition]]
id = "3"
section = "2"
printed = "F = m a, a > 0"
[[system]]
id = "swing"
section = "3"
formulation = "kane"
unknowns = ["u1'"]
matrix = [["l"]]
right = ["-2*g*sin(q1)"]
[[system]]
id = "scaled"
section = "3"
formulation = "kane"
unknowns = ["u1'"]
matrix = [["l"]]
right = ["-g*sin(q1)"]
"#;

/// Returns a page about the pendulum with a publication.
pub fn page_with_publication() -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), PENDULUM).unwrap();
    std::fs::write(folder.path().join("publication.toml"), PUBLICATION).unwrap();
    page_of(&tripos_derive::model::load(&Source::read(Path::new(&folder.path().join("model.toml"))).unwrap()).unwrap())
}

/// Returns the part of a page from the text `from` up to the next text `to`.
pub fn part<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    let (_, rest) = page.split_once(from).unwrap_or_else(|| panic!("no {from}"));
    rest.split_once(to).unwrap_or_else(|| panic!("no {to}")).0
}

#[test]
fn every_tag_of_a_page_is_closed() {
    assert_eq!(unbalanced(&page()), None);
    assert_eq!(unbalanced(&page_with_publication()), None);
    assert!(unbalanced("<p><b></p>").is_some(), "the check itself sees a fault");
}

#[test]
fn texts_of_the_model_are_escaped() {
    let page = page_with_publication();
    let publication =
        ["<course>", "report & more", "Smith & Sons", "V<1>", "hard to <read>", "<odd>", "<N>", "a, a > 0"];
    for text in ["<b>bob", "R&D", "mass & <more>", "Fall <1>", "<badly>", "page <x>", "K & <L>", "& <sons>"]
        .iter()
        .chain(&publication)
    {
        assert!(!page.contains(text), "`{text}` stands unescaped");
    }
    assert!(page.contains("<h1>A &lt;b&gt;bob&lt;/b&gt; &amp; &quot;string&quot;</h1>"));
}

#[test]
fn a_page_is_the_same_each_time() {
    assert_eq!(page(), page());
    assert_eq!(page_with_publication(), page_with_publication());
}

#[test]
fn a_page_needs_nothing_else() {
    let page = page_with_publication();
    for foreign in ["<link", "src=", "url(", "@import", "https://"] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    assert!(page.contains("content=\"default-src 'none'; script-src 'unsafe-inline'"), "and forbids itself all else");
    assert_eq!(page.matches("<script>").count(), 2, "what opens, and what moves");
}

#[test]
fn a_run_that_could_not_go_on_is_shown_with_its_reason() {
    let page = page();
    let row =
        "<tr class=\"stopped\"><th scope=\"row\">Lagrange's equations <strong class=\"standing\">stopped</strong></th>";
    assert!(page.contains(row) && page.contains("<strong>How it ended:</strong> component 3 &lt; 0 is not finite"));
}

/// Goal: wrong and loose runs are distinguished. Method: right equations at loose tolerances are called loose, with
/// tolerance and error. Wrong equations are called wrong although their run ends well.
#[test]
fn loose_is_not_wrong_and_wrong_is_wrong_however_it_ends() {
    let page = page_with_publication();
    let rows = part(&page, "<table class=\"runs\">\n<caption>Runs</caption>", "</table>");
    let (derived, printed) = rows.split_once("<tr class=\"group\">").unwrap();
    let error = "right equations, loosely integrated: ode45 with rtol 1e−3 leaves an error of 0.25";
    let unknown = derived.contains("s is not known: no &lt;way&gt; there");
    assert!(unknown && derived.contains(error) && !derived.contains("wrong"), "{derived}");
    assert!(printed.contains("1 of 2 are wrong, they do not give the derived accelerations"), "{printed}");
    assert!(printed.contains("<tr class=\"printed wrong\"><th scope=\"row\"><code>printed:swing</code>"), "{printed}");
    assert!(printed.contains("<tr class=\"printed\"><th scope=\"row\"><code>printed:scaled</code></th>"), "{printed}");
}

/// Recommendations of a speed chart are shown as a table, a figure has a link to its data, and the page says why a
/// figure is missing.
#[test]
fn measured_figures_have_data_and_advice() {
    let page = page();
    assert!(
        page.contains(
            "<a href=\"fall%20%3C2%3E/work_precision.csv\"><code>fall &lt;2&gt;/work_precision.csv</code></a>"
        )
    );
    let advice = part(&page, "Which equations, accelerations and method to use", "</table>");
    assert!(advice.contains("<td>kane &amp; &lt;sons&gt;</td><td>eliminated</td><td>dop853</td>"), "{advice}");
    assert!(advice.contains("<td>250 µs</td><td>7.4 × 10<sup>−7</sup></td>"), "{advice}");
    assert!(advice.contains("<td>nothing measured here</td>") && advice.contains("Use &lt;dop853&gt;"), "{advice}");
    assert!(page.contains("<p class=\"missing\">`passages` cannot be drawn: &lt;no divisor&gt;</p>"));
}

/// The reduced equations of the pendulum keep both of its states. A scene without reduced equations gives the reason.
#[test]
fn a_scene_shows_what_it_needs_or_why_not() {
    let model = tripos_derive::model::load(&Source::from_text("no/such/place/model.toml", PENDULUM)).unwrap();
    let needs = part(&page(), "What the scene needs", "</article>").to_owned();
    assert!(
        needs.contains("<p class=\"formula\">Of 2 states 2 are kept.") && needs.contains("<td>angle</td>"),
        "{needs}"
    );
    assert!(
        needs.contains("<summary>What is left out, and why (") && needs.contains("the scene fixes it at"),
        "{needs}"
    );
    let (study, _) = ModelAnalysis::new(&model, &[]).unwrap();
    let scenes = vec![SceneSection { needs: Err("u1 is <odd>".to_owned()), ..scene() }];
    let page = render_page(&Page {
        model: &model,
        derivations: Vec::new(),
        study: &study,
        scenes,
        sketch: Err("it has <no> place".to_owned()),
        moving: None,
        unfinished: None,
        file: String::new(),
    });
    assert!(page.contains("The scene has no equations of its own: u1 is &lt;odd&gt;."), "{page}");
    assert!(page.contains("<p class=\"missing\">There is no sketch of it: it has &lt;no&gt; place.</p>"), "{page}");
}

/// A run that does not record every state has no row in the table of first integrals.
#[test]
fn a_run_without_integrals_is_left_out_of_their_table() {
    let mut section = scene();
    section.runs[1].changes.clear();
    section.runs[1].energy_drift = None;
    let model = tripos_derive::model::load(&Source::from_text("no/such/place/model.toml", PENDULUM)).unwrap();
    let (study, _) = ModelAnalysis::new(&model, &[]).unwrap();
    let page = render_page(&Page {
        model: &model,
        derivations: Vec::new(),
        study: &study,
        scenes: vec![section],
        sketch: Err("it has <no> place".to_owned()),
        moving: None,
        unfinished: None,
        file: String::new(),
    });
    let changes = part(&page, "Largest |I(t)", "</table>");
    assert!(changes.contains("Kane's method") && !changes.contains("Lagrange's equations"), "{changes}");
    let runs = part(&page, "<caption>Runs</caption>", "</table>");
    assert!(runs.contains("Lagrange's equations") && runs.contains("<td class=\"n\">–</td>"), "{runs}");
}

#[test]
fn names_of_steps_are_typeset() {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", PENDULUM)).unwrap();
    let component = |vector, of| QuantityKind::Component { vector, of, frame: 1, axis: 0 };
    let names = [
        component(VectorName::AngularVelocity, 1),
        component(VectorName::Velocity, 1),
        QuantityKind::Partial { vector: VectorName::Velocity, of: 1, frame: 0, axis: 0, speed: 0 },
        QuantityKind::Energy(EnergyQuantity::Kinetic),
        QuantityKind::Rate(0),
    ];
    let forces = [LineName::ActiveForce(0), LineName::GeneralizedForce(0), LineName::Symbol("S")];
    for name in names.map(LineName::Quantity).iter().chain(&forces) {
        let typeset = formula_mathml::line_name_mathml(&model, name);
        assert_eq!(unbalanced(&typeset), None, "{name:?}");
        assert!(!typeset.contains(['@', '[', '\'']), "{name:?}: {typeset}");
    }
    let velocity = formula_mathml::line_name_mathml(&model, &LineName::Quantity(component(VectorName::Velocity, 1)));
    assert!(velocity.contains("<mprescripts/><mrow></mrow><mi>N</mi>"));
}

#[test]
fn proofs_and_first_integrals_are_shown_for_any_model() {
    let page = page();
    let proof = part(&page, "<section id=\"proof\">", "</section>");
    assert!(proof.contains("Kane's method ⇔ Lagrange's equations</td><td>proved"), "{proof}");
    assert!(proof.contains("⇔ Newton–Euler equations</td><td>proved") && proof.contains("bob_force_b1"), "{proof}");
    assert!(proof.contains("Valid everywhere") && proof.contains("energy T + V"), "{proof}");
    assert!(
        proof.contains("<th scope=\"row\">Kane's method</th>") && proof.contains("<td>nowhere</td>"),
        "m l² is never zero: {proof}"
    );
}

#[test]
fn without_a_publication_nothing_is_said_of_one() {
    let page = page();
    for text in ["id=\"errata\"", "As printed", "printed − derived"] {
        assert!(!page.contains(text), "{text}");
    }
}

#[test]
fn errata_show_what_is_wrong_and_fold_the_rest() {
    let page = page_with_publication();
    let errata = part(&page, "<section id=\"errata\">", "</section>");
    let wrong = part(errata, "<h3 id=\"mistakes\">Root mistakes</h3>", "<summary>Equal up to a factor");
    for text in ["2-<wbr>V&lt;1&gt;", "swing-<wbr>row1", "printed − derived", "for instance", "hard to &lt;read&gt;"]
    {
        assert!(wrong.contains(text), "{text}: {wrong}");
    }
    assert!(!wrong.contains("1-<wbr>T<") && !wrong.contains("scaled-<wbr>row1"), "{wrong}");
    assert!(part(errata, "<summary>Equal up to a factor", "</details>").contains("scaled-<wbr>row1"));
    let all = part(errata, "<summary>All entries", "</details>");
    for text in ["1-<wbr>T</code> equal", "3</code> stated", "2-<wbr>V&lt;1&gt;</code> <strong"] {
        assert!(all.contains(text), "{text}: {all}");
    }
    assert!(part(errata, "<tr><td><code>swing</code>", "</tr>").contains(">broken</strong>"), "energy is not kept");
    assert!(!part(errata, "<tr><td><code>scaled</code>", "</tr>").contains("<strong"), "a factor does no harm");
}

#[test]
fn printed_runs_stand_apart_and_raise_no_alarm() {
    let page = page_with_publication();
    let (_, rows) = page.split_once("<tr class=\"group\">").unwrap();
    assert!(rows.contains("<code>printed:swing</code> <strong class=\"standing\">wrong</strong></th>"), "{rows}");
    assert!(rows.contains("printed:&lt;odd&gt;</code></th>") && rows.contains("not run: it mentions `&lt;N&gt;`"));
    let changes = part(rows, "Largest |I(t)", "</table>");
    assert!(changes.contains("<strong class=\"wrong\">0.25</strong>"), "proved to be broken: {changes}");
    assert!(rows.contains("keeps about 9 of 16 digits"), "1.25e-7 costs seven digits");
}
