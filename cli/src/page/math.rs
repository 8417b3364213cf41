//! Names and formulas as MathML.

use super::html::{each, escape};
use tripos_derive::Model;
use tripos_derive::algebra::print::{self, mathml_name};
use tripos_derive::algebra::view::View;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{BalanceName, LineName, QuantityKind, RowName, Stage, VectorName};

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
        Some(_) => print::mathml(arena, e),
        None => TOO_LONG.to_owned(),
    }
}

const TOO_LONG: &str = "<mtext>an expression too long to print here</mtext>";

/// One side of an equation that is laid out in lines.
pub enum Side {
    /// What stays in one piece, as MathML.
    Whole(String),
    /// Marks whose outermost sum may be broken.
    Marks(View),
}

impl Side {
    /// A formula, or a remark that it is too long.
    pub fn of(arena: &Arena, e: Expr) -> Self {
        match length(arena, e) {
            Some(_) => Self::Marks(print::view_of(arena, e)),
            None => Self::Whole(TOO_LONG.to_owned()),
        }
    }

    /// The pieces between which a line may end, each with its sign.
    fn pieces(&self) -> Vec<String> {
        match self {
            Self::Whole(content) => vec![content.clone()],
            Self::Marks(view) => print::mathml_terms(view).into_iter().enumerate().map(signed).collect(),
        }
    }
}

/// A term with the sign that it has at its place of a sum.
fn signed((at, (negative, term)): (usize, (bool, String))) -> String {
    let sign = if negative { '−' } else { '+' };
    match (at, negative) {
        (0, false) => term,
        (0, true) => format!("<mo form=\"prefix\">{sign}</mo>{term}"),
        _ => format!("<mo form=\"infix\" lspace=\"0\">{sign}</mo>{term}"),
    }
}

/// Sides of an equation, or one formula, in pieces that may stand on several lines: it breaks behind `=` and before the
/// signs of its outermost sums.
pub fn wrapped(sides: &[Side]) -> String {
    let last = sides.len().saturating_sub(1);
    let mut pieces = Vec::new();
    for (at, side) in sides.iter().enumerate() {
        pieces.extend(side.pieces());
        if let (true, Some(end)) = (at < last, pieces.last_mut()) {
            end.push_str("<mo form=\"infix\">=</mo>");
        }
    }
    pieces.iter().map(|piece| inline(&format!("<mrow>{piece}</mrow>"))).collect::<Vec<_>>().join(" ")
}

/// Visible characters of the longest term of some marks: what cannot stand on several lines.
pub fn widest(view: &View) -> usize {
    match view {
        View::Sum(terms) => terms.iter().map(|(_, term)| 1 + factor_width(term)).max().unwrap_or(0),
        view => width(view),
    }
}

/// Visible characters of some marks beside each other.
fn width(view: &View) -> usize {
    match view {
        View::Number(text) | View::Name(text) | View::Shared(text) => text.chars().count(),
        View::Pi | View::Cut => 1,
        View::Sum(terms) => {
            let sign = |at: usize, negative: bool| usize::from(at > 0 || negative);
            terms.iter().enumerate().map(|(at, (negative, term))| sign(at, *negative) + factor_width(term)).sum()
        }
        View::Product(factors) => factors.iter().map(factor_width).sum(),
        View::Fraction(above, below) => width(above).max(width(below)),
        View::Power(base, n) => factor_width(base) + n.to_string().len(),
        View::Call(name, argument) => name.len() + factor_width(argument),
        View::Root(argument) => 1 + width(argument),
    }
}

/// Visible characters of marks as a factor: a sum stands in parentheses.
fn factor_width(view: &View) -> usize {
    width(view) + if matches!(view, View::Sum(_)) { 2 } else { 0 }
}

/// Formulas of more characters of plain text are cut.
const LONGEST_VALUE: usize = 420;

/// A formula; of a long one the beginning, as text.
pub fn value(arena: &Arena, e: Expr) -> String {
    if length(arena, e).is_some_and(|length| length <= LONGEST_VALUE) {
        return wrapped(&[Side::of(arena, e)]);
    }
    let text = print::text(arena, e);
    let start: String = text.chars().take(120).collect();
    format!(
        "<code>{} …</code> <span class=\"quiet\">({} characters; <code>tripos diff --json</code> has it whole)</span>",
        escape(&start),
        text.chars().count()
    )
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

/// Basis vector b₂ of frame B, for the axis 1 that is counted from 0.
pub fn basis(frame: &str, axis: usize) -> String {
    format!("<msub>{}<mn>{}</mn></msub>", vector(&frame.to_lowercase()), axis + 1)
}

/// A vector of a point, frame or body in the inertial frame, such as ᴺωᶜ.
fn motion(model: &Model, name: VectorName, of: usize) -> String {
    let letter = match name {
        VectorName::AngularVelocity => "ω",
        VectorName::AngularAcceleration => "α",
        other => other.name(),
    };
    let (base, of) = (vector(letter), symbol(name.owner_name(model, of)));
    let inertial = symbol(&model.frames[0].name);
    format!("<mmultiscripts>{base}<mrow></mrow>{of}<mprescripts/><mrow></mrow>{inertial}</mmultiscripts>")
}

/// What a line of a derivation is.
pub fn line_name(model: &Model, name: &LineName) -> String {
    match name {
        LineName::Quantity(kind) => quantity(model, kind),
        LineName::ActiveForce(at) => force("F", &model.speeds[*at].name),
        LineName::GeneralizedForce(at) => force("Q", &model.coordinates[*at].name),
    }
}

fn quantity(model: &Model, kind: &QuantityKind) -> String {
    let basis = |frame: usize, axis| basis(&model.frames[frame].name, axis);
    match *kind {
        QuantityKind::Component { vector, of, frame, axis } => {
            format!("<mrow>{}<mo>·</mo>{}</mrow>", motion(model, vector, of), basis(frame, axis))
        }
        QuantityKind::Partial { vector, of, frame, axis, speed } => format!(
            "<mrow><mfrac><mrow><mo form=\"prefix\">∂</mo>{}</mrow><mrow><mo form=\"prefix\">∂</mo>{}</mrow></mfrac>\
             <mo>·</mo>{}</mrow>",
            motion(model, vector, of),
            symbol(&model.speeds[speed].name),
            basis(frame, axis)
        ),
        _ => symbol(&kind.name(model)),
    }
}

/// A generalized force of a speed or coordinate.
fn force(letter: &str, of: &str) -> String {
    format!("<msub><mi>{letter}</mi><mrow>{}</mrow></msub>", symbol(of))
}

/// The heading of a step, with a velocity typeset, as HTML.
pub fn stage_title(model: &Model, stage: Stage) -> String {
    let Stage::Velocities { vector, of, frame } = stage else { return escape(&stage.title(model)) };
    let (of, frame) = (inline(&motion(model, vector, of)), inline(&symbol(&model.frames[frame].name)));
    format!("Velocity and partial velocities: {of}, components in {frame}")
}

/// What a row is of: a speed, a coordinate, or words such as `disk force along b₁`.
pub fn row_name(model: &Model, row: &RowName) -> String {
    match row {
        RowName::Speed(_) | RowName::Coordinate(_) => inline(&symbol(&row.text(model))),
        RowName::Balance(BalanceName { frame, axis, .. }) => {
            let along = inline(&basis(&model.frames[*frame].name, *axis));
            format!("{} along {along}", escape(&row.subject(model)))
        }
        RowName::Constraint(_) | RowName::Power(_) | RowName::Along(_) | RowName::Printed(_) => {
            escape(&row.text(model))
        }
    }
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
