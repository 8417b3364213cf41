//! Sketch of a mechanism as SVG, for a file or for a page.

use super::look::{Look, look_of_role};
use super::sketch_coordinate_text;
use crate::page::escape;
use std::fmt::Write;
use tripos::pictures::sketch::{DrawingPoint, Label, LabelWord, Mark, MarkRole, PaintKind, Path, PathPart, Sketch};
use tripos_derive::algebra::text::print::name_parts;

/// Returns a sketch as a complete SVG file. Its colours are light or dark, according to the setting of the reader's
/// system.
pub fn sketch_svg_file(sketch: &Sketch) -> String {
    let colour = |[r, g, b]: [u8; 3]| format!("#{r:02x}{g:02x}{b:02x}");
    let mut style = String::from("text{font:15px \"STIX Two Text\",\"Times New Roman\",Times,serif;stroke:none}\n");
    for look in MarkRole::ALL.map(look_of_role) {
        style += &svg_css_rules(&look, &colour(look.ink), &colour(look.shade));
    }
    style += "@media (prefers-color-scheme:dark){\n";
    for look in MarkRole::ALL.map(look_of_role) {
        style += &svg_css_rules(&look, &colour(look.dark[0]), &colour(look.dark[1]));
    }
    format!("{}\n", svg_element(sketch, &format!("<style>{style}}}</style>\n")))
}

/// Returns a sketch as an `<svg>` element without colours, for a page that styles its classes.
pub fn sketch_svg_element(sketch: &Sketch) -> String {
    svg_element(sketch, "")
}

/// Returns the CSS rules of a class. `ink` is the colour of lines, words and filled shapes; `shade` is the colour
/// inside outlines.
fn svg_css_rules(look: &Look, ink: &str, shade: &str) -> String {
    let name = look.name;
    format!(".{name}{{stroke:{ink};fill:none}}.{name}.full,.{name}.word{{fill:{ink}}}.{name}.over{{fill:{shade}}}\n")
}

/// Returns the `<svg>` element of a sketch. The text `style` is placed before its marks.
fn svg_element(sketch: &Sketch, style: &str) -> String {
    let [width, height] = sketch.size.map(sketch_coordinate_text);
    let title = escape(&format!("Sketch: {}", sketch.title));
    let mut out = format!(
        "<svg class=\"sketch\" role=\"img\" aria-label=\"{title}\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<title>{title}</title>\n<desc>{}</desc>\n{style}",
        escape(&format!("{} {}", sketch.about, sketch.drawn)),
    );
    // Successive lines with the same look become one element.
    let mut marks = sketch.marks.as_slice();
    while let Some(first) = marks.first() {
        let alike =
            |mark: &&Mark| mark.role == first.role && mark.paint == first.paint && first.paint == PaintKind::Line;
        let count = marks.iter().take_while(alike).count().max(1);
        out += &svg_path_element(&marks[..count]);
        marks = &marks[count..];
    }
    for label in &sketch.labels {
        out += &svg_label(label);
    }
    out + "</svg>"
}

/// Returns one path element for marks of the same look.
fn svg_path_element(marks: &[Mark]) -> String {
    let Some(first) = marks.first() else { return String::new() };
    let look = look_of_role(first.role);
    let paint = match first.paint {
        PaintKind::Line => "",
        PaintKind::Filled => " full",
        PaintKind::Solid => " over",
    };
    let dashes = look.dashes.map_or_else(String::new, |(on, off)| format!(" stroke-dasharray=\"{on} {off}\""));
    let wide = if first.paint == PaintKind::Filled { 0.5 } else { look.wide };
    let data: Vec<String> = marks.iter().map(|mark| svg_path_data(&mark.path)).collect();
    format!("<path class=\"{}{paint}\" stroke-width=\"{wide}\"{dashes} d=\"{}\"/>\n", look.name, data.concat())
}

/// Returns the path of a mark in the syntax of SVG.
fn svg_path_data(path: &Path) -> String {
    let spot = |at: DrawingPoint| format!("{} {}", sketch_coordinate_text(at[0]), sketch_coordinate_text(at[1]));
    let mut out = format!("M{}", spot(path.from));
    for part in &path.parts {
        let _ = match part {
            PathPart::Line(to) => write!(out, "L{}", spot(*to)),
            PathPart::Curve([a, b, to]) => write!(out, "C{} {} {}", spot(*a), spot(*b), spot(*to)),
        };
    }
    if path.is_closed {
        out.push('Z');
    }
    out
}

/// Returns the text element of a label, centred at its place. The base line is a third of a letter below the middle.
fn svg_label(label: &Label) -> String {
    let inside: String = label.words.iter().map(svg_label_word).collect();
    let (x, y) = (sketch_coordinate_text(label.at[0]), sketch_coordinate_text(label.at[1] + 4.5));
    format!(
        "<text class=\"{} word\" x=\"{x}\" y=\"{y}\" text-anchor=\"middle\">{inside}</text>\n",
        look_of_role(label.role).name
    )
}

/// Returns a word of a label as SVG: a name with subscript, a unit vector, plain text or a minus
/// sign.
fn svg_label_word(word: &LabelWord) -> String {
    match word {
        LabelWord::Name(name) => {
            let (letters, subscript, _) = name_parts(name);
            // A name of several letters is upright; a single letter is italic.
            let style = if letters.chars().count() > 1 { "" } else { " font-style=\"italic\"" };
            format!("<tspan{style}>{}</tspan>{}", escape(&letters), svg_subscript(&subscript))
        }
        LabelWord::Basis(frame, axis) => {
            let letters = escape(&frame.to_lowercase());
            format!("<tspan font-weight=\"bold\">{letters}</tspan>{}", svg_subscript(&(axis + 1).to_string()))
        }
        LabelWord::Plain(text) => format!("<tspan>{}</tspan>", escape(text)),
        LabelWord::Minus => "<tspan>−</tspan>".to_owned(),
    }
}

/// Returns the elements of a subscript, after which the text returns to the base line. Empty for an
/// empty subscript.
fn svg_subscript(subscript: &str) -> String {
    if subscript.is_empty() {
        return String::new();
    }
    format!("<tspan dy=\"3.5\" font-size=\"10.5\">{}</tspan><tspan dy=\"-3.5\">&#8203;</tspan>", escape(subscript))
}
