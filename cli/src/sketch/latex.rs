//! Sketch of a mechanism in `TikZ`, for another LaTeX document to `\input`.

use super::look::of;
use super::rounded;
use crate::latex::{basis, escape};
use std::fmt::Write;
use tripos::pictures::sketch::{Label, Mark, Paint, Part, Path, Role, SheetPoint, Sketch, Word};
use tripos_derive::algebra::text::print::latex_name;

/// Number of TeX points per pixel. With it, letters of 10 points have the size for which the places
/// of labels were computed.
const SCALE: f64 = 0.7;

/// Returns the sketch in `TikZ`, with its description as a comment. It needs only the package
/// `tikz`.
pub fn picture(sketch: &Sketch) -> String {
    let mut out = String::from("% Needs \\usepackage{tikz} in the preamble.\n");
    for line in [&sketch.title, &sketch.about, &sketch.drawn] {
        let _ = writeln!(out, "% {}", escape(line));
    }
    let _ = write!(out, "\\begin{{tikzpicture}}[x={SCALE}pt,y=-{SCALE}pt,line join=round,line cap=round,inner sep=0pt");
    for look in Role::ALL.map(of) {
        let dashes = look.dashes.map_or_else(String::new, |(on, off)| {
            format!(",dash pattern=on {}pt off {}pt", rounded(on * SCALE), rounded(off * SCALE))
        });
        let _ = write!(
            out,
            ",\n  {}/.style={{draw={},line width={}pt{dashes}}}",
            look.name,
            colour(look.ink),
            rounded(look.wide * SCALE)
        );
    }
    out += "]\n";
    let [width, height] = sketch.size.map(rounded);
    let _ = writeln!(out, "\\useasboundingbox (0,0) rectangle ({width},{height});");
    for mark in &sketch.marks {
        let _ = writeln!(out, "\\path[{}{}] {};", of(mark.role).name, fill(mark), data(&mark.path));
    }
    for label in &sketch.labels {
        let at = spot(label.at);
        let _ = writeln!(out, "\\node[text={}] at {at} {{{}}};", colour(of(label.role).ink), words(label));
    }
    out + "\\end{tikzpicture}\n"
}

/// Returns a colour as a mixture of red, green and blue, which `xcolor` accepts without a name.
fn colour([r, g, b]: [u8; 3]) -> String {
    format!("{{rgb,255:red,{r};green,{g};blue,{b}}}")
}

/// Returns the `TikZ` options that fill a mark; empty for a line.
fn fill(mark: &Mark) -> String {
    let look = of(mark.role);
    match mark.paint {
        Paint::Line => String::new(),
        Paint::Filled => format!(",fill={},line width=0.3pt", colour(look.ink)),
        Paint::Solid => format!(",fill={}", colour(look.shade)),
    }
}

/// Returns a point of the sheet as coordinates in `TikZ`.
fn spot(at: SheetPoint) -> String {
    format!("({},{})", rounded(at[0]), rounded(at[1]))
}

/// Returns the path of a mark in the syntax of `TikZ`.
fn data(path: &Path) -> String {
    let mut out = spot(path.from);
    for part in &path.parts {
        let _ = match part {
            Part::Line(to) => write!(out, " -- {}", spot(*to)),
            Part::Curve([a, b, to]) => write!(out, " .. controls {} and {} .. {}", spot(*a), spot(*b), spot(*to)),
        };
    }
    out + if path.is_closed { " -- cycle" } else { "" }
}

/// Returns the words of a label in LaTeX.
fn words(label: &Label) -> String {
    let word = |word: &Word| match word {
        Word::Name(name) => format!("${}$", latex_name(name)),
        Word::Basis(frame, axis) => format!("${}$", basis(frame, *axis)),
        Word::Minus => "$-$".to_owned(),
        Word::Plain(text) => escape(text),
    };
    label.words.iter().map(word).collect()
}
