//! Sketch of a mechanism as SVG, as a file or for a page.

use super::look::{Look, of};
use super::rounded;
use crate::page::escape;
use std::fmt::Write;
use tripos::pictures::sketch::{Label, Mark, Paint, Part, Path, Role, SheetPoint, Sketch, Word};
use tripos_derive::algebra::text::print::name_parts;

/// Returns a sketch as a complete SVG file. Its colours are light or dark, as the reader's system
/// prefers.
pub fn document(sketch: &Sketch) -> String {
    let colour = |[r, g, b]: [u8; 3]| format!("#{r:02x}{g:02x}{b:02x}");
    let mut style = String::from("text{font:15px \"STIX Two Text\",\"Times New Roman\",Times,serif;stroke:none}\n");
    for look in Role::ALL.map(of) {
        style += &rules(&look, &colour(look.ink), &colour(look.shade));
    }
    style += "@media (prefers-color-scheme:dark){\n";
    for look in Role::ALL.map(of) {
        style += &rules(&look, &colour(look.dark[0]), &colour(look.dark[1]));
    }
    format!("{}\n", element(sketch, &format!("<style>{style}}}</style>\n")))
}

/// Returns a sketch as an `<svg>` element without colours, for a page that styles its classes.
pub fn figure(sketch: &Sketch) -> String {
    element(sketch, "")
}

/// Returns the CSS rules of a class: `ink` colours lines, words and filled shapes; `shade` colours
/// the inside of outlines.
fn rules(look: &Look, ink: &str, shade: &str) -> String {
    let name = look.name;
    format!(".{name}{{stroke:{ink};fill:none}}.{name}.full,.{name}.word{{fill:{ink}}}.{name}.over{{fill:{shade}}}\n")
}

/// Returns the `<svg>` element of a sketch, with the text `style` in front of its marks.
fn element(sketch: &Sketch, style: &str) -> String {
    let [width, height] = sketch.size.map(rounded);
    let title = escape(&format!("Sketch: {}", sketch.title));
    let mut out = format!(
        "<svg class=\"sketch\" role=\"img\" aria-label=\"{title}\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<title>{title}</title>\n<desc>{}</desc>\n{style}",
        escape(&format!("{} {}", sketch.about, sketch.drawn)),
    );
    // Successive lines of one look become one element.
    let mut marks = sketch.marks.as_slice();
    while let Some(first) = marks.first() {
        let alike = |mark: &&Mark| mark.role == first.role && mark.paint == first.paint && first.paint == Paint::Line;
        let count = marks.iter().take_while(alike).count().max(1);
        out += &path(&marks[..count]);
        marks = &marks[count..];
    }
    for label in &sketch.labels {
        out += &words(label);
    }
    out + "</svg>"
}

/// Returns one path element for marks of the same look.
fn path(marks: &[Mark]) -> String {
    let Some(first) = marks.first() else { return String::new() };
    let look = of(first.role);
    let paint = match first.paint {
        Paint::Line => "",
        Paint::Filled => " full",
        Paint::Solid => " over",
    };
    let dashes = look.dashes.map_or_else(String::new, |(on, off)| format!(" stroke-dasharray=\"{on} {off}\""));
    let wide = if first.paint == Paint::Filled { 0.5 } else { look.wide };
    let data: Vec<String> = marks.iter().map(|mark| data(&mark.path)).collect();
    format!("<path class=\"{}{paint}\" stroke-width=\"{wide}\"{dashes} d=\"{}\"/>\n", look.name, data.concat())
}

/// Returns the path of a mark in the syntax of SVG.
fn data(path: &Path) -> String {
    let spot = |at: SheetPoint| format!("{} {}", rounded(at[0]), rounded(at[1]));
    let mut out = format!("M{}", spot(path.from));
    for part in &path.parts {
        let _ = match part {
            Part::Line(to) => write!(out, "L{}", spot(*to)),
            Part::Curve([a, b, to]) => write!(out, "C{} {} {}", spot(*a), spot(*b), spot(*to)),
        };
    }
    if path.is_closed {
        out.push('Z');
    }
    out
}

/// Returns the text element of a label, centred at its place. The base line lies a third of a
/// letter below the middle.
fn words(label: &Label) -> String {
    let inside: String = label.words.iter().map(word).collect();
    let (x, y) = (rounded(label.at[0]), rounded(label.at[1] + 4.5));
    format!("<text class=\"{} word\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{inside}</text>\n", of(label.role).name)
}

/// Returns a word of a label as SVG: a name with subscript, a unit vector, plain text or a minus
/// sign.
fn word(word: &Word) -> String {
    match word {
        Word::Name(name) => {
            let (letters, subscript, _) = name_parts(name);
            // A name of several letters is upright, a single letter slanted.
            let style = if letters.chars().count() > 1 { "" } else { " font-style=\"italic\"" };
            format!("<tspan{style}>{}</tspan>{}", escape(&letters), lowered(&subscript))
        }
        Word::Basis(frame, axis) => {
            let letters = escape(&frame.to_lowercase());
            format!("<tspan font-weight=\"bold\">{letters}</tspan>{}", lowered(&(axis + 1).to_string()))
        }
        Word::Plain(text) => format!("<tspan>{}</tspan>", escape(text)),
        Word::Minus => "<tspan>−</tspan>".to_owned(),
    }
}

/// Returns the elements of a subscript, after which the text returns to the base line. Empty for an
/// empty subscript.
fn lowered(subscript: &str) -> String {
    if subscript.is_empty() {
        return String::new();
    }
    format!("<tspan dy=\"3.5\" font-size=\"10.5\">{}</tspan><tspan dy=\"-3.5\">&#8203;</tspan>", escape(subscript))
}
