//! Names and formulas of the page as MathML.

use crate::page::markup::html::{count, each, escape};
use tripos_derive::Model;
use tripos_derive::algebra::form::simplify::cost;
use tripos_derive::algebra::text::print::{self, mathml_name};
use tripos_derive::algebra::text::view::View;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{BalanceName, LineName, QuantityKind, RowName, Stage, VectorName};

/// Number of characters of plain text, half a printed page, above which the page shows only a formula's number of
/// operations: nobody would read it.
const LONGEST: usize = 1_500;
/// Largest number of characters of plain text of a formula in a sentence, or in a row of a table.
const LONGEST_IN_WORDS: usize = 420;
/// Width, in tenths of an em, above which a formula may break over several lines: about half of a phone.
const PIECE: usize = 120;

/// Number of characters of a formula's plain text; `None` if it is too long to be printed.
pub fn length(arena: &Arena, e: Expr) -> Option<usize> {
    let text = print::text(arena, e);
    let length = text.chars().count();
    (length <= LONGEST && !text.contains('…')).then_some(length)
}

/// True if a formula is short enough for a sentence.
pub fn is_short(arena: &Arena, e: Expr) -> bool {
    length(arena, e).is_some_and(|length| length <= LONGEST_IN_WORDS)
}

/// Formula as MathML, in one piece; a formula that is too long to read becomes the number of its operations.
pub fn formula(arena: &Arena, e: Expr) -> String {
    match length(arena, e) {
        Some(_) => print::mathml(arena, e),
        None => unprinted(arena, e),
    }
}

/// MathML in place of a formula that is too long to read.
fn unprinted(arena: &Arena, e: Expr) -> String {
    format!("<mtext>{}</mtext>", operations(arena, e))
}

/// Words in place of a formula that is too long to read.
fn operations(arena: &Arena, e: Expr) -> String {
    format!("a term of {}", count(cost(arena, e), "operation"))
}

/// Paragraph with the command that prints the formulas that are too long for the page.
pub fn unread(command: &str) -> String {
    format!(
        "<p class=\"quiet\">A term that is too long to be read stands as the number of its operations; <code>{}</code> has it whole.</p>\n",
        escape(command)
    )
}

/// Side of an equation that is laid out in lines.
pub enum Side {
    /// MathML that stays in one piece.
    Whole(String),
    /// Formula that may be broken over lines at its signs.
    Marks(View),
}

impl Side {
    /// Side for a formula; if it is too long to read, the number of its operations.
    pub fn of(arena: &Arena, e: Expr) -> Self {
        match length(arena, e) {
            Some(_) => Self::Marks(print::view_of(arena, e)),
            None => Self::Whole(unprinted(arena, e)),
        }
    }

    /// Side for a formula in a sentence; if it is too long for that, the number of its operations.
    pub fn short(arena: &Arena, e: Expr) -> Self {
        if is_short(arena, e) { Self::of(arena, e) } else { Self::Whole(unprinted(arena, e)) }
    }

    /// MathML of the pieces between which a line may end.
    fn pieces(&self) -> Vec<String> {
        match self {
            Self::Whole(content) => vec![content.clone()],
            Self::Marks(view) => print::mathml_pieces(view, PIECE),
        }
    }

    /// True if the side may break over several lines.
    fn breaks(&self) -> bool {
        matches!(self, Self::Marks(view) if print::formula_width(view) > PIECE)
    }
}

/// HTML of an equation by its sides, or of one formula, in pieces that may stand on several lines. It breaks after `=`
/// and before signs; a wide formula also breaks inside parentheses.
pub fn wrapped<'a>(sides: impl IntoIterator<Item = &'a Side>) -> String {
    let mut pieces: Vec<String> = Vec::new();
    for side in sides {
        if let Some(end) = pieces.last_mut() {
            // The space between pieces replaces the space behind the sign.
            end.push_str("<mo form=\"infix\" rspace=\"0\">=</mo>");
        }
        pieces.extend(side.pieces());
    }
    pieces.iter().map(|piece| inline(piece)).collect::<Vec<_>>().join(" ")
}

/// HTML of components as (x, y, z); if one of them is wide, they may stand on several lines.
pub fn tuple(arena: &Arena, components: &[Expr; 3]) -> String {
    let comma = "<mo separator=\"true\">,</mo>";
    let sides = components.map(|e| Side::of(arena, e));
    if !sides.iter().any(Side::breaks) {
        let inside = components.map(|e| formula(arena, e)).join(comma);
        return inline(&format!("<mrow><mo>(</mo>{inside}<mo>)</mo></mrow>"));
    }
    let mut pieces: Vec<String> = Vec::new();
    for side in &sides {
        let begin = if pieces.is_empty() { "<mo form=\"prefix\" stretchy=\"false\">(</mo>" } else { "" };
        if let Some(end) = pieces.last_mut() {
            end.push_str(comma);
        }
        let mut own = side.pieces();
        if let Some(first) = own.first_mut() {
            first.insert_str(0, begin);
        }
        pieces.extend(own);
    }
    if let Some(end) = pieces.last_mut() {
        end.push_str("<mo form=\"postfix\" stretchy=\"false\">)</mo>");
    }
    pieces.iter().map(|piece| inline(piece)).collect::<Vec<_>>().join(" ")
}

/// HTML of a formula in a sentence; if it is long, the number of its operations.
pub fn in_sentence(arena: &Arena, e: Expr) -> String {
    if is_short(arena, e) { wrapped(&[Side::of(arena, e)]) } else { operations(arena, e) }
}

/// HTML of words for a sentence that says that a term is zero.
pub fn vanishing(arena: &Arena, e: Expr) -> String {
    if is_short(arena, e) {
        wrapped(&[Side::of(arena, e), Side::Whole("<mn>0</mn>".to_owned())])
    } else {
        format!("{} vanishes", operations(arena, e))
    }
}

/// Number of visible characters of the longest term of a formula: a term cannot stand on several lines.
pub fn widest(view: &View) -> usize {
    match view {
        View::Sum(terms) => terms.iter().map(|(_, term)| 1 + factor_width(term)).max().unwrap_or(0),
        view => width(view),
    }
}

/// Number of visible characters of a formula in one line.
fn width(view: &View) -> usize {
    match view {
        View::Number(text) | View::Name(text) | View::Word(text) | View::Shared(text) => text.chars().count(),
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

/// Number of visible characters of a formula as a factor: a sum stands in parentheses.
fn factor_width(view: &View) -> usize {
    width(view) + if matches!(view, View::Sum(_)) { 2 } else { 0 }
}

/// HTML of a formula in the verdicts on a publication; a long formula is cut, and shown as text.
pub fn value(arena: &Arena, e: Expr) -> String {
    if is_short(arena, e) {
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

/// MathML of a number with up to six significant digits.
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

/// HTML of a formula among words, from its MathML.
pub fn inline(content: &str) -> String {
    format!("<math>{content}</math>")
}

/// MathML of a symbol's name.
pub fn symbol(name: &str) -> String {
    match name.strip_suffix("star") {
        Some(letter) if !letter.is_empty() => {
            format!("<msup>{}<mo lspace=\"0\" rspace=\"0\">⋆</mo></msup>", mathml_name(&escape(letter)))
        }
        _ => mathml_name(&escape(name)),
    }
}

/// MathML of the name of a model's symbol, different from that of a symbol that would look like it.
pub fn told_apart(model: &Model, name: &str) -> String {
    match print::symbol_view(&model.arena, name) {
        word @ View::Word(_) => print::mathml_of(&word),
        View::Name(printed) => symbol(&printed),
        _ => symbol(name),
    }
}

/// MathML of a vector's letter: bold and upright.
fn vector(letter: &str) -> String {
    format!("<mi mathvariant=\"normal\" class=\"vector\">{}</mi>", escape(letter))
}

/// MathML of a basis vector, such as b₂ of frame B for the axis 1; axes are counted from 0.
pub fn basis(frame: &str, axis: usize) -> String {
    format!("<msub>{}<mn>{}</mn></msub>", vector(&frame.to_lowercase()), axis + 1)
}

/// MathML of a vector of a point, frame or body in the inertial frame, such as ᴺωᶜ.
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

/// MathML of the left side of a line of a derivation.
pub fn line_name(model: &Model, name: &LineName) -> String {
    match name {
        LineName::Quantity(kind) => quantity(model, kind),
        LineName::ActiveForce(at) => force("F", &model.speeds[*at].name),
        LineName::GeneralizedForce(at) => force("Q", &model.coordinates[*at].name),
        LineName::Symbol(letter) => symbol(letter),
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
            told_apart(model, &model.speeds[speed].name),
            basis(frame, axis)
        ),
        _ => told_apart(model, &kind.name(model)),
    }
}

/// MathML of the generalized force along a speed or coordinate.
fn force(letter: &str, of: &str) -> String {
    format!("<msub><mi>{letter}</mi><mrow>{}</mrow></msub>", symbol(of))
}

/// HTML of the heading of a derivation's step, with a velocity typeset.
pub fn stage_title(model: &Model, stage: Stage) -> String {
    let Stage::Velocities { vector, of, frame } = stage else { return escape(&stage.title(model)) };
    let (of, frame) = (inline(&motion(model, vector, of)), inline(&symbol(&model.frames[frame].name)));
    format!("Velocity and partial velocities: {of}, components in {frame}")
}

/// HTML of the name of a row of equations: a speed, a coordinate, or words such as `disk force along b₁`.
pub fn row_name(model: &Model, row: &RowName) -> String {
    match row {
        RowName::Speed(_) | RowName::Coordinate(_) => inline(&told_apart(model, &row.text(model))),
        RowName::Balance(BalanceName { frame, axis, .. }) => {
            let along = inline(&basis(&model.frames[*frame].name, *axis));
            format!("{} along {along}", escape(&row.subject(model)))
        }
        RowName::Constraint(_) | RowName::Power(_) | RowName::Law { .. } | RowName::Along(_) | RowName::Printed(_) => {
            escape(&row.text(model))
        }
    }
}

/// MathML of a matrix in square brackets. The brackets are drawn by the style sheet: without a mathematical font a
/// browser does not stretch them.
pub fn matrix(rows: &[Vec<String>]) -> String {
    let row = |cells: &Vec<String>| format!("<mtr>{}</mtr>\n", each(cells, |cell| format!("<mtd>{cell}</mtd>")));
    format!("<mtable class=\"matrix\">\n{}</mtable>", each(rows, row))
}

/// HTML of lines `left = right`, aligned at their equals signs; a wide side may stand on several lines.
pub fn lines(lines: &[(Side, Side)]) -> String {
    format!("<table class=\"lines\">\n<tbody>\n{}</tbody>\n</table>\n", each(lines, line))
}

fn line(sides: &(Side, Side)) -> String {
    let (left, right) = sides;
    // A wide left side would push all equals signs to the right.
    if left.breaks() {
        return format!("<tr><td class=\"wide\" colspan=\"2\">{}</td></tr>\n", wrapped([left, right]));
    }
    let mut pieces = right.pieces();
    if let Some(first) = pieces.first_mut() {
        *first = format!("<mo form=\"infix\">=</mo><mrow>{first}</mrow>");
    }
    let class = if right.breaks() { " class=\"wide\"" } else { "" };
    let pieces = pieces.iter().map(|piece| inline(piece)).collect::<Vec<_>>().join(" ");
    format!("<tr><td>{}</td><td{class}>{pieces}</td></tr>\n", wrapped([left]))
}
