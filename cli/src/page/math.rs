//! Names and formulas as MathML.

use super::html::{each, escape};
use tripos_derive::Model;
use tripos_derive::algebra::print::{self, mathml_name};
use tripos_derive::algebra::{Arena, Expr};

/// Characters of plain text after which a formula is not printed: nobody reads on, and pages must load.
const LONGEST: usize = 12_000;

/// Whether a formula is short enough to be printed, by the length of its plain text.
pub fn length(arena: &Arena, e: Expr) -> Option<usize> {
    let text = print::text(arena, e);
    let length = text.chars().count();
    (length <= LONGEST && !text.contains('…')).then_some(length)
}

/// A formula, or a remark that it is too long.
pub fn formula(arena: &Arena, e: Expr) -> String {
    match length(arena, e) {
        Some(_) => spaced(&print::mathml(arena, e)),
        None => "<mtext>an expression too long to print here</mtext>".to_owned(),
    }
}

/// A function and an argument without parentheses, with the space that browsers leave out between them.
pub fn spaced(mathml: &str) -> String {
    let wide = mathml.replace("<mo>&#8289;</mo>", "<mo>&#8289;</mo><mspace width=\"0.17em\"/>");
    wide.replace("<mspace width=\"0.17em\"/><mrow><mo>(</mo>", "<mrow><mo>(</mo>")
}

/// A formula in the text.
pub fn inline(content: &str) -> String {
    format!("<math>{content}</math>")
}

/// A symbol's name.
pub fn symbol(name: &str) -> String {
    match name.strip_suffix("star") {
        Some(letter) if !letter.is_empty() => {
            format!("<msup>{}<mo lspace=\"0\" rspace=\"0\">⋆</mo></msup>", mathml_name(&escape(letter)))
        }
        _ => mathml_name(&escape(name)),
    }
}

/// A bold upright letter: a vector.
fn vector(letter: &str) -> String {
    format!("<mi mathvariant=\"normal\" class=\"vector\">{}</mi>", escape(letter))
}

/// Basis vector b₂ of frame B.
pub fn basis(frame: &str, index: &str) -> String {
    format!("<msub>{}<mn>{}</mn></msub>", vector(&frame.to_lowercase()), escape(index))
}

/// `omega(C)` as the angular velocity of C in the inertial frame; likewise v, a and alpha.
fn motion(model: &Model, text: &str) -> Option<String> {
    let (kind, of) = text.strip_suffix(')')?.split_once('(')?;
    let letter = match kind {
        "omega" => "ω",
        "alpha" => "α",
        "v" | "a" => kind,
        _ => return None,
    };
    let inertial = symbol(&model.frames.first()?.name);
    let (base, of) = (vector(letter), symbol(of));
    Some(format!("<mmultiscripts>{base}<mrow></mrow>{of}<mprescripts/><mrow></mrow>{inertial}</mmultiscripts>"))
}

/// The name of a line of a derivation, such as `omega(C) @ B [1]`, `d v(P) @ B [3]/d u2`, `F[u1]`, `q1'`.
pub fn step_name(model: &Model, name: &str) -> String {
    component(model, name)
        .or_else(|| partial(model, name))
        .or_else(|| generalized_force(name))
        .unwrap_or_else(|| symbol(name))
}

fn component(model: &Model, name: &str) -> Option<String> {
    let (of, place) = name.split_once(" @ ")?;
    let (frame, index) = place.strip_suffix(']')?.split_once(" [")?;
    Some(format!("<mrow>{}<mo>·</mo>{}</mrow>", motion(model, of)?, basis(frame, index)))
}

fn partial(model: &Model, name: &str) -> Option<String> {
    let (above, speed) = name.strip_prefix("d ")?.rsplit_once("/d ")?;
    let (of, place) = above.split_once(" @ ")?;
    let (frame, index) = place.strip_suffix(']')?.split_once(" [")?;
    Some(format!(
        "<mrow><mfrac><mrow><mo form=\"prefix\">∂</mo>{}</mrow><mrow><mo form=\"prefix\">∂</mo>{}</mrow></mfrac>\
         <mo>·</mo>{}</mrow>",
        motion(model, of)?,
        symbol(speed),
        basis(frame, index)
    ))
}

fn generalized_force(name: &str) -> Option<String> {
    let (letter, of) = name.strip_suffix(']')?.split_once('[')?;
    Some(format!("<msub><mi>{}</mi><mrow>{}</mrow></msub>", escape(letter), symbol(of)))
}

/// The title of a step, with a quantity at its end typeset, as HTML.
pub fn step_title(model: &Model, title: &str) -> String {
    let typeset = || {
        let (words, quantity) = title.split_once(": ")?;
        let (of, frame) = quantity.split_once(" @ ")?;
        let (of, frame) = (inline(&motion(model, of)?), inline(&symbol(frame)));
        Some(format!("{}: {of}, components in {frame}", escape(words)))
    };
    typeset().unwrap_or_else(|| escape(title))
}

/// What a row balances: a speed, a coordinate, or words such as `disk force b1`.
pub fn row_name(model: &Model, row: &str) -> String {
    if let Some((words, last)) = row.rsplit_once(' ') {
        let frame = model.frames.iter().find_map(|f| last.strip_prefix(&f.name.to_lowercase()));
        return match frame {
            Some(index @ ("1" | "2" | "3")) => {
                let of = &last[..last.len() - 1];
                format!("{} along {}", escape(words), inline(&basis(of, index)))
            }
            _ => escape(row),
        };
    }
    let known = model.speeds.iter().any(|s| s.name == row) || model.coordinates.iter().any(|c| c.name == row);
    if known { inline(&symbol(row)) } else { escape(row) }
}

/// Rows in square brackets. The brackets are drawn by the style sheet: without a mathematical font a
/// browser does not stretch them.
pub fn matrix(rows: &[Vec<String>]) -> String {
    let row = |cells: &Vec<String>| format!("<mtr>{}</mtr>\n", each(cells, |cell| format!("<mtd>{cell}</mtd>")));
    format!("<mtable class=\"matrix\">\n{}</mtable>", each(rows, row))
}

/// Lines `name = value` under each other at their equals signs; both sides are MathML.
pub fn lines(lines: &[(String, String)]) -> String {
    let line = |(name, value): &(String, String)| {
        format!("<tr><td>{}</td><td>{}</td></tr>\n", inline(name), inline(&format!("<mo form=\"infix\">=</mo>{value}")))
    };
    format!("<table class=\"lines\">\n<tbody>\n{}</tbody>\n</table>\n", each(lines, line))
}
