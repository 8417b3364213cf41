//! Names and formulas as MathML.

use super::html::{each, escape};
use crate::step_name::{Axis, StepName, VectorName};
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

/// Sides of an equation, or one formula, in pieces that may stand on several lines: it breaks behind `=` and before the
/// signs of its outermost sums.
pub fn wrapped(sides: &[String]) -> String {
    let last = sides.len().saturating_sub(1);
    let mut pieces = Vec::new();
    for (at, side) in sides.iter().enumerate() {
        let first = pieces.len();
        terms(bare(side), &mut pieces);
        if at < last && pieces.len() > first {
            pieces.last_mut().expect("just pushed").push_str("<mo form=\"infix\">=</mo>");
        }
    }
    pieces.iter().map(|piece| inline(&format!("<mrow>{piece}</mrow>"))).collect::<Vec<_>>().join(" ")
}

/// The terms of a row of MathML, each with its sign.
fn terms(row: &str, pieces: &mut Vec<String>) {
    let (mut piece, mut depth) = (String::new(), 0_i32);
    let mut tokens = row.split_inclusive('>').peekable();
    while let Some(token) = tokens.next() {
        let is_sign = tokens.peek().is_some_and(|next| ["+</mo>", "−</mo>"].contains(next));
        if depth == 0 && token == "<mo>" && is_sign {
            let form = if piece.is_empty() { "prefix" } else { "infix\" lspace=\"0" };
            if !piece.is_empty() {
                pieces.push(std::mem::take(&mut piece));
            }
            piece = format!("<mo form=\"{form}\">{}", tokens.next().unwrap_or_default());
            continue;
        }
        depth += nesting(token);
        piece += token;
    }
    pieces.push(piece);
}

/// Visible characters of the longest term of a row of MathML: what cannot stand on several lines.
pub fn widest(side: &str) -> usize {
    let mut pieces = Vec::new();
    terms(bare(side), &mut pieces);
    let visible = |piece: &String| {
        piece
            .split('<')
            .filter_map(|part| Some(part.split_once('>')?.1))
            .map(|text| text.chars().count())
            .sum::<usize>()
    };
    pieces.iter().map(visible).max().unwrap_or(0)
}

/// How much deeper it is behind the tag at the end of a token.
fn nesting(token: &str) -> i32 {
    match token.find('<').map(|at| &token[at..]) {
        Some(tag) if tag.starts_with("</") => -1,
        Some(tag) if !tag.ends_with("/>") => 1,
        _ => 0,
    }
}

/// A formula without the rows around the whole.
fn bare(mathml: &str) -> &str {
    let mut inner = mathml;
    while let Some(content) = inner.strip_prefix("<mrow>").and_then(|rest| rest.strip_suffix("</mrow>")) {
        let depths = content.split_inclusive('>').scan(0, |depth, token| {
            *depth += nesting(token);
            Some(*depth)
        });
        // Two rows beside each other are not a row around both.
        if depths.min().is_some_and(|least| least < 0) {
            break;
        }
        inner = content;
    }
    inner
}

/// A number with up to six significant digits.
pub fn decimal(x: f64) -> String {
    let short = format!("{x:.5e}").parse::<f64>().unwrap_or(x);
    let sign = if short < 0.0 { "<mo form=\"prefix\">−</mo>" } else { "" };
    let size = short.abs();
    if size == 0.0 || (1e-4..1e6).contains(&size) {
        return format!("<mrow>{sign}<mn>{size}</mn></mrow>");
    }
    let text = format!("{size:e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    let power = power.replace('-', "−");
    format!("<mrow>{sign}<mn>{digits}</mn><mo>×</mo><msup><mn>10</mn><mn>{power}</mn></msup></mrow>")
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

/// The velocity, angular velocity or acceleration of a frame or point in the inertial frame.
fn motion(model: &Model, VectorName { kind, of }: VectorName<'_>) -> Option<String> {
    let letter = match kind {
        "omega" => "ω",
        "alpha" => "α",
        letter => letter,
    };
    let inertial = symbol(&model.frames.first()?.name);
    let (base, of) = (vector(letter), symbol(of));
    Some(format!("<mmultiscripts>{base}<mrow></mrow>{of}<mprescripts/><mrow></mrow>{inertial}</mmultiscripts>"))
}

/// The name of a line of a derivation, such as `omega(C) @ B [1]`, `d v(P) @ B [3]/d u2`, `F[u1]`, `q1'`.
pub fn step_name(model: &Model, name: &str) -> String {
    let along = |axis: Axis<'_>| format!("<mo>·</mo>{}", basis(axis.frame, axis.index));
    let typeset = match StepName::read(name) {
        StepName::Component(of, axis) => motion(model, of).map(|of| format!("<mrow>{of}{}</mrow>", along(axis))),
        StepName::Partial(of, axis, speed) => motion(model, of).map(|of| {
            let (speed, d) = (symbol(speed), "<mo form=\"prefix\">∂</mo>");
            let fraction = format!("<mfrac><mrow>{d}{of}</mrow><mrow>{d}{speed}</mrow></mfrac>");
            format!("<mrow>{fraction}{}</mrow>", along(axis))
        }),
        StepName::Of(letter, of) => {
            Some(format!("<msub><mi>{}</mi><mrow>{}</mrow></msub>", escape(letter), symbol(of)))
        }
        StepName::Symbol(_) => None,
    };
    typeset.unwrap_or_else(|| symbol(name))
}

/// The title of a step, with a quantity at its end typeset, as HTML.
pub fn step_title(model: &Model, title: &str) -> String {
    let typeset = || {
        let (words, quantity) = title.split_once(": ")?;
        let (of, frame) = quantity.split_once(" @ ")?;
        let (of, frame) = (inline(&motion(model, VectorName::read(of)?)?), inline(&symbol(frame)));
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
