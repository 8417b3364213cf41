//! `tripos sketch`: the pictures that it writes, and what it refuses.

use crate::latex::{compiled, has_latex};
use crate::support::{SLIDER, root, status, stderr, tripos, tripos_in};
use expect_test::expect;
use std::path::Path;

/// Exit status, picture, what is printed and standard error.
fn sketch(folder: &Path, what: &str, name: &str, arguments: &[&str]) -> (i32, String, String, String) {
    let place = tempfile::tempdir().unwrap();
    let out = place.path().join(name);
    let (status, said, error) =
        tripos_in(folder, &[&["sketch", what, "--out", out.to_str().unwrap()], arguments].concat());
    (status, std::fs::read_to_string(&out).unwrap_or_default(), said, error)
}

/// The elements of a picture, without its style.
fn elements(svg: &str) -> String {
    let (before, rest) = svg.split_once("<style>").unwrap();
    format!("{before}{}", rest.split_once("</style>\n").unwrap().1)
}

/// Goal: the picture is the one that a person checked. Method: the sketch of a mass on a spring, compared by a person
/// with a textbook's drawing.
#[test]
fn the_sketch_of_a_slider() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.toml"), SLIDER).unwrap();
    let (status, svg, said, error) = sketch(folder.path(), "model.toml", "s.svg", &[]);
    assert_eq!((status, error.as_str()), (0, ""));
    expect![[r#"
        <svg class="sketch" role="img" aria-label="Sketch: Slider" xmlns="http://www.w3.org/2000/svg" width="386" height="146" viewBox="0 0 386 146" stroke-linejoin="round" stroke-linecap="round">
        <title>Sketch: Slider</title>
        <desc>Seen against a3, across the plane of the motion. Drawn are slider (particle). x is a length towards P. Drawn at x = 0.8 m, to be seen; the model by itself has x = 0 m.</desc>
        <path class="mass over" stroke-width="1.4" d="M366.5 89C366.5 101.1 356.7 110.9 344.6 110.9C332.5 110.9 322.8 101.1 322.8 89C322.8 76.9 332.5 67.1 344.6 67.1C356.7 67.1 366.5 76.9 366.5 89Z"/>
        <path class="point full" stroke-width="0.5" d="M28.7 89C28.7 90.2 27.7 91.2 26.5 91.2C25.3 91.2 24.3 90.2 24.3 89C24.3 87.8 25.3 86.8 26.5 86.8C27.7 86.8 28.7 87.8 28.7 89Z"/>
        <path class="point full" stroke-width="0.5" d="M346.8 89C346.8 90.2 345.8 91.2 344.6 91.2C343.4 91.2 342.4 90.2 342.4 89C342.4 87.8 343.4 86.8 344.6 86.8C345.8 86.8 346.8 87.8 346.8 89Z"/>
        <path class="reference" stroke-width="0.8" stroke-dasharray="3 3" d="M26.5 93L26.5 123M344.6 93L344.6 123"/>
        <path class="coordinate" stroke-width="1.4" d="M26.5 119L344.6 119"/>
        <path class="coordinate full" stroke-width="0.5" d="M344.6 119L336.6 121.6L338.2 119L336.6 116.4Z"/>
        <path class="coordinate full" stroke-width="0.5" d="M26.5 119L34.5 116.4L32.9 119L34.5 121.6Z"/>
        <path class="axis" stroke-width="1.2" d="M26.5 89L88.5 89"/>
        <path class="axis full" stroke-width="0.5" d="M88.5 89L80.5 91.6L82.1 89L80.5 86.4Z"/>
        <path class="axis" stroke-width="1.2" d="M26.5 89L26.5 27"/>
        <path class="axis full" stroke-width="0.5" d="M26.5 27L29.1 35L26.5 33.4L23.9 35Z"/>
        <path class="axis over" stroke-width="1.2" d="M31.5 89C31.5 91.8 29.3 94 26.5 94C23.7 94 21.5 91.8 21.5 89C21.5 86.2 23.7 84 26.5 84C29.3 84 31.5 86.2 31.5 89Z"/>
        <path class="axis full" stroke-width="0.5" d="M28.1 89C28.1 89.9 27.4 90.6 26.5 90.6C25.6 90.6 24.9 89.9 24.9 89C24.9 88.1 25.6 87.4 26.5 87.4C27.4 87.4 28.1 88.1 28.1 89Z"/>
        <text class="point word" x="13" y="93.5" text-anchor="middle"><tspan font-style="italic">O</tspan></text>
        <text class="point word" x="353.1" y="93.5" text-anchor="middle"><tspan font-style="italic">P</tspan></text>
        <text class="coordinate word" x="185.6" y="133.5" text-anchor="middle"><tspan font-style="italic">x</tspan></text>
        <text class="axis word" x="99" y="90.7" text-anchor="middle"><tspan font-weight="bold">a</tspan><tspan dy="3.5" font-size="10.5">1</tspan><tspan dy="-3.5">&#8203;</tspan></text>
        <text class="axis word" x="29.3" y="21" text-anchor="middle"><tspan font-weight="bold">a</tspan><tspan dy="3.5" font-size="10.5">2</tspan><tspan dy="-3.5">&#8203;</tspan></text>
        <text class="axis word" x="38.9" y="81.1" text-anchor="middle"><tspan font-weight="bold">a</tspan><tspan dy="3.5" font-size="10.5">3</tspan><tspan dy="-3.5">&#8203;</tspan></text>
        <text class="body word" x="354.1" y="58" text-anchor="middle"><tspan>slider</tspan></text>
        </svg>
    "#]].assert_eq(&elements(&svg));
    expect![[r"
        Seen against a3, across the plane of the motion. Drawn are slider (particle). x is a length towards P.
        Drawn at x = 0.8 m, to be seen; the model by itself has x = 0 m.
    "]]
    .assert_eq(said.split_once('\n').unwrap().1);
}

/// Goal: both pictures say the same. Method: how many paths and labels each has, of models in a plane and in space.
#[test]
fn svg_and_latex_are_one_drawing() {
    for model in ["models/pendulum", "models/disk", "models/squeezer", "models/satellite"] {
        let (_, svg, said, _) = sketch(&root(), model, "it.svg", &[]);
        let (status, tex, same, _) = sketch(&root(), model, "it.tex", &[]);
        assert_eq!(status, 0);
        assert_eq!(svg.matches("<text").count(), tex.matches("\\node").count(), "{model}");
        let moves = elements(&svg)
            .split(" d=\"")
            .skip(1)
            .map(|d| d.split('"').next().unwrap().matches('M').count())
            .sum::<usize>();
        assert_eq!(moves, tex.matches("\\path").count(), "{model}");
        assert_eq!(said.split_once('\n').unwrap().1, same.split_once('\n').unwrap().1);
        let open = |c: char| tex.matches(c).count() - tex.matches(&format!("\\{c}")).count();
        assert_eq!(open('{'), open('}'), "{model}");
        assert!(
            tex.starts_with("% Needs \\usepackage{tikz} in the preamble.\n") && tex.ends_with("\\end{tikzpicture}\n")
        );
    }
}

/// Goal: sketches compile unchanged in a thesis. Method: every model of the library, put into a document by `\input`,
/// by pdflatex if there is one with `TikZ`.
#[test]
fn latex_of_every_model_compiles() {
    if !has_latex(&["article.cls", "tikz.sty"]) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir(root().join("models")).unwrap() {
        let model = entry.unwrap().path();
        let (_, picture, ..) = sketch(&root(), model.to_str().unwrap(), "it.tex", &[]);
        std::fs::write(folder.path().join("part.tex"), picture).unwrap();
        let around =
            "\\documentclass{article}\\usepackage{tikz}\\begin{document}\\noindent\\input{part}\\end{document}";
        compiled(folder.path(), around).unwrap_or_else(|said| panic!("{}: {said}", model.display()));
    }
}

/// Goal: a given state is drawn exactly, and wrong requests are refused. Method: a pendulum on its side; a missing
/// file, a state of another mechanism, a picture of no kind, one that would replace an input, and no model.
#[test]
fn states_are_drawn_and_what_is_no_state_or_picture_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.to_str().unwrap().to_owned()
    };
    let aside = write("aside.toml", "[state]\ntheta = \"90 deg\"\nomega = 0\n");
    let (status, svg, said, _) = sketch(&root(), "models/pendulum", "p.svg", &["--at", &aside]);
    assert_eq!(status, 0);
    assert!(
        said.ends_with("Drawn at theta = 90°: the state that was asked for.\n") && svg.contains("theta = 90°"),
        "{said}"
    );
    let refused = |arguments: &[&str], what: &str| {
        let (status, out, error) = tripos_in(folder.path(), arguments);
        assert!(status == 2 && out.is_empty() && error.contains(what), "{arguments:?}: {status} {error}");
    };
    let pendulum = root().join("models/pendulum");
    let pendulum = pendulum.to_str().unwrap();
    refused(&["sketch", pendulum, "--at", "none.toml"], "none.toml");
    let other = write("other.toml", "[state]\nx = 1\n");
    refused(&["sketch", pendulum, "--at", &other], "the model has no coordinate or speed `x`");
    refused(&["sketch", pendulum, "--out", "p.gif"], "`p.gif` names no kind of figure");
    refused(&["sketch", pendulum, "--out", "p"], "give a file that ends in .svg, .png or .pdf, or in .tex for LaTeX");
    refused(&["sketch", "nowhere"], "there is no model at `nowhere`");
    assert!(!folder.path().join("sketch.svg").exists());
    let own = write("model.svg", SLIDER);
    refused(&["sketch", &own, "--out", &own], "would overwrite the input");
}

/// Goal: no text of a file becomes markup. Method: hostile titles, descriptions and names of bodies, as SVG, as LaTeX
/// and on the page.
#[test]
fn hostile_texts_stay_text() {
    let folder = tempfile::tempdir().unwrap();
    let evil = "</title><script>alert(1)</script>%\\\\input{x}$&";
    let model = SLIDER.replace("Slider", evil).replace(
        "coordinates.x = { unit = \"m\" }",
        &format!("coordinates.x = {{ unit = \"m\", about = \"{evil}\" }}"),
    );
    std::fs::write(folder.path().join("model.toml"), model).unwrap();
    let (status, svg, _, error) = sketch(folder.path(), "model.toml", "s.svg", &[]);
    assert_eq!((status, error.as_str()), (0, ""));
    assert!(!svg.contains("<script") && svg.contains("&lt;/title&gt;&lt;script&gt;"), "{svg}");
    let (_, tex, ..) = sketch(folder.path(), "model.toml", "s.tex", &[]);
    assert!(!tex.contains("\\input{") && tex.contains("\\textbackslash{}input\\{x\\}\\$\\&"), "{tex}");
}

/// Goal: the page begins with the sketch. Method: that of a model with a scene and of one without: one picture, in the
/// abstract, with its caption.
#[test]
fn the_page_begins_with_the_sketch() {
    let bare = tempfile::tempdir().unwrap();
    std::fs::write(bare.path().join("model.toml"), SLIDER).unwrap();
    for (model, caption) in
        [("models/pendulum", "the start of over.toml"), (bare.path().to_str().unwrap(), "the model by itself")]
    {
        let out = tempfile::tempdir().unwrap();
        let output = tripos(&["page", model, "--out", out.path().to_str().unwrap()]);
        assert_eq!(status(&output), 0, "{}", stderr(&output));
        let page = std::fs::read_to_string(out.path().join("index.html")).unwrap();
        assert_eq!(page.matches("<svg class=\"sketch\"").count(), 1);
        let (_, summary) = page.split_once("<section id=\"abstract\"").unwrap();
        let (summary, _) = summary.split_once("<dl>").unwrap();
        assert!(summary.contains("<figure>\n<svg class=\"sketch\"") && summary.contains(caption), "{summary}");
        assert!(!summary.contains("<style>"), "the page has its own");
    }
}
