//! Sketch of a mechanism in `TikZ`, for another LaTeX document to `\input`.

use super::look::look_of_role;
use super::sketch_coordinate_text;
use crate::latex::{escape_latex, latex_unit_vector};
use std::fmt::Write;
use tripos::pictures::sketch::{DrawingPoint, Label, LabelWord, Mark, MarkRole, PaintKind, Path, PathPart, Sketch};
use tripos_derive::algebra::text::print::latex_name;

/// Number of TeX points per pixel. At this scale, the places of labels are right for letters of 10 points.
const SCALE: f64 = 0.7;

/// Returns the sketch in `TikZ`, with its description as a comment. The picture needs only the package `tikz`.
pub fn tikz_picture(sketch: &Sketch) -> String {
    let mut out = String::from("% Needs \\usepackage{tikz} in the preamble.\n");
    for line in [&sketch.title, &sketch.about, &sketch.drawn] {
        let _ = writeln!(out, "% {}", escape_latex(line));
    }
    let _ = write!(out, "\\begin{{tikzpicture}}[x={SCALE}pt,y=-{SCALE}pt,line join=round,line cap=round,inner sep=0pt");
    for look in MarkRole::ALL.map(look_of_role) {
        let dashes = look.dashes.map_or_else(String::new, |(on, off)| {
            format!(
                ",dash pattern=on {}pt off {}pt",
                sketch_coordinate_text(on * SCALE),
                sketch_coordinate_text(off * SCALE)
            )
        });
        let _ = write!(
            out,
            ",\n  {}/.style={{draw={},line width={}pt{dashes}}}",
            look.name,
            colour(look.ink),
            sketch_coordinate_text(look.wide * SCALE)
        );
    }
    out += "]\n";
    let [width, height] = sketch.size.map(sketch_coordinate_text);
    let _ = writeln!(out, "\\useasboundingbox (0,0) rectangle ({width},{height});");
    for mark in &sketch.marks {
        let _ = writeln!(out, "\\path[{}{}] {};", look_of_role(mark.role).name, tikz_fill(mark), tikz_path(&mark.path));
    }
    for label in &sketch.labels {
        let at = tikz_point(label.at);
        let _ =
            writeln!(out, "\\node[text={}] at {at} {{{}}};", colour(look_of_role(label.role).ink), tikz_label(label));
    }
    out + "\\end{tikzpicture}\n"
}

/// Returns a colour as a mixture of red, green and blue that `xcolor` accepts without a colour name.
fn colour([r, g, b]: [u8; 3]) -> String {
    format!("{{rgb,255:red,{r};green,{g};blue,{b}}}")
}

/// Returns the `TikZ` options that fill a mark; empty for a line.
fn tikz_fill(mark: &Mark) -> String {
    let look = look_of_role(mark.role);
    match mark.paint {
        PaintKind::Line => String::new(),
        PaintKind::Filled => format!(",fill={},line width=0.3pt", colour(look.ink)),
        PaintKind::Solid => format!(",fill={}", colour(look.shade)),
    }
}

/// Returns a point of the drawing as coordinates in `TikZ`.
fn tikz_point(at: DrawingPoint) -> String {
    format!("({},{})", sketch_coordinate_text(at[0]), sketch_coordinate_text(at[1]))
}

/// Returns the path of a mark in the syntax of `TikZ`.
fn tikz_path(path: &Path) -> String {
    let mut out = tikz_point(path.from);
    for part in &path.parts {
        let _ = match part {
            PathPart::Line(to) => write!(out, " -- {}", tikz_point(*to)),
            PathPart::Curve([a, b, to]) => {
                write!(out, " .. controls {} and {} .. {}", tikz_point(*a), tikz_point(*b), tikz_point(*to))
            }
        };
    }
    out + if path.is_closed { " -- cycle" } else { "" }
}

/// Returns the words of a label in LaTeX.
fn tikz_label(label: &Label) -> String {
    let word = |word: &LabelWord| match word {
        LabelWord::Name(name) => format!("${}$", latex_name(name)),
        LabelWord::Basis(frame, axis) => format!("${}$", latex_unit_vector(frame, *axis)),
        LabelWord::Minus => "$-$".to_owned(),
        LabelWord::Plain(text) => escape_latex(text),
    };
    label.words.iter().map(word).collect()
}
