//! Names and formulas of the page as MathML. Wide formulas may be broken into several lines.

use crate::page::markup::html::{escape, join_html};
use crate::phrases::counted_noun;
use tripos_derive::Model;
use tripos_derive::algebra::form::simplify::operation_count;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{self, mathml_name};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{BalanceName, LineName, QuantityKind, RowName, Stage, VectorName};

/// Largest number of characters, as plain text, of a formula that the page shows. A longer formula is replaced with its
/// number of operations.
const LONGEST: usize = 1_500;
/// Largest number of characters, as plain text, of a formula in a sentence or in a table row.
const LONGEST_IN_WORDS: usize = 420;
/// Width, in tenths of an em, above which a formula may be broken into lines. It is about half the width of a phone.
const PIECE: usize = 120;

/// Returns the number of characters of a formula as plain text; `None` if it is too long to show.
pub fn length(arena: &Arena, e: Expr) -> Option<usize> {
    let text = print::print_text(arena, e);
    let length = text.chars().count();
    (length <= LONGEST && !text.contains('…')).then_some(length)
}

/// True if a formula is short enough for a sentence.
pub fn is_short_formula_mathml(arena: &Arena, e: Expr) -> bool {
    length(arena, e).is_some_and(|length| length <= LONGEST_IN_WORDS)
}

/// Returns a formula as MathML, without places for line breaks. A formula that is too long is replaced with its number
/// of operations.
pub fn formula(arena: &Arena, e: Expr) -> String {
    match length(arena, e) {
        Some(_) => print::mathml(arena, e),
        None => too_long_formula_mathml(arena, e),
    }
}

/// Returns the MathML that replaces a formula that is too long to read: its number of operations.
fn too_long_formula_mathml(arena: &Arena, e: Expr) -> String {
    format!("<mtext>{}</mtext>", operations(arena, e))
}

/// Returns the words that replace a formula that is too long to read: its number of operations.
fn operations(arena: &Arena, e: Expr) -> String {
    format!("a term of {}", counted_noun(operation_count(arena, e), "operation"))
}

/// Returns a paragraph with the command that prints the formulas that are too long for the page.
pub fn long_formulas_note(command: &str) -> String {
    format!(
        "<p class=\"quiet\">A term that is too long to be read stands as the number of its operations; <code>{}</code> has it whole.</p>\n",
        escape(command)
    )
}

/// Left or right side of an equation whose formulas may be broken over lines.
pub enum MathmlSide {
    /// MathML that is never broken into lines.
    Whole(String),
    /// Formula that may be broken over lines at its plus and minus signs.
    Marks(DisplayTree),
}

impl MathmlSide {
    /// Returns the side for a formula. A formula that is too long to read is replaced with its number of operations.
    pub fn of(arena: &Arena, e: Expr) -> Self {
        match length(arena, e) {
            Some(_) => Self::Marks(print::print_view(arena, e)),
            None => Self::Whole(too_long_formula_mathml(arena, e)),
        }
    }

    /// Returns the side for a formula in a sentence. A formula of more than 420 characters is replaced with its number
    /// of operations.
    pub fn short(arena: &Arena, e: Expr) -> Self {
        if is_short_formula_mathml(arena, e) {
            Self::of(arena, e)
        } else {
            Self::Whole(too_long_formula_mathml(arena, e))
        }
    }

    /// Returns the MathML of the side as pieces. A line break is allowed between two pieces.
    fn pieces(&self) -> Vec<String> {
        match self {
            Self::Whole(content) => vec![content.clone()],
            Self::Marks(view) => print::break_mathml_pieces(view, PIECE),
        }
    }

    /// True if the side may be broken into several lines.
    fn breaks(&self) -> bool {
        matches!(self, Self::Marks(view) if print::formula_width(view) > PIECE)
    }
}

/// Returns the HTML of an equation between the given sides, or of a single formula. Line breaks are allowed after `=`
/// and before signs; in a wide formula, also inside parentheses.
pub fn breakable_mathml<'a>(sides: impl IntoIterator<Item = &'a MathmlSide>) -> String {
    let mut pieces: Vec<String> = Vec::new();
    for side in sides {
        if let Some(end) = pieces.last_mut() {
            // The space between two pieces replaces the space after the equals sign.
            end.push_str("<mo form=\"infix\" rspace=\"0\">=</mo>");
        }
        pieces.extend(side.pieces());
    }
    pieces.iter().map(|piece| inline_mathml(piece)).collect::<Vec<_>>().join(" ")
}

/// Returns the HTML of three components as (x, y, z). If a component is wide, line breaks are allowed.
pub fn vector_components_html(arena: &Arena, components: &[Expr; 3]) -> String {
    let comma = "<mo separator=\"true\">,</mo>";
    let sides = components.map(|e| MathmlSide::of(arena, e));
    if !sides.iter().any(MathmlSide::breaks) {
        let inside = components.map(|e| formula(arena, e)).join(comma);
        return inline_mathml(&format!("<mrow><mo>(</mo>{inside}<mo>)</mo></mrow>"));
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
    pieces.iter().map(|piece| inline_mathml(piece)).collect::<Vec<_>>().join(" ")
}

/// Returns the HTML of a formula in a sentence. A long formula is replaced with its number of operations.
pub fn formula_mathml_in_sentence(arena: &Arena, e: Expr) -> String {
    if is_short_formula_mathml(arena, e) { breakable_mathml(&[MathmlSide::of(arena, e)]) } else { operations(arena, e) }
}

/// Returns the HTML of the statement that a term is zero.
pub fn zero_formula_mathml(arena: &Arena, e: Expr) -> String {
    if is_short_formula_mathml(arena, e) {
        breakable_mathml(&[MathmlSide::of(arena, e), MathmlSide::Whole("<mn>0</mn>".to_owned())])
    } else {
        format!("{} vanishes", operations(arena, e))
    }
}

/// Returns the number of visible characters of the longest term of a formula. A single term cannot be broken into
/// lines.
pub fn widest(view: &DisplayTree) -> usize {
    match view {
        DisplayTree::Sum(terms) => terms.iter().map(|(_, term)| 1 + mathml_factor_width(term)).max().unwrap_or(0),
        view => mathml_width(view),
    }
}

/// Returns the number of visible characters of a formula on one line.
fn mathml_width(view: &DisplayTree) -> usize {
    match view {
        DisplayTree::Number(text) | DisplayTree::Name(text) | DisplayTree::Word(text) | DisplayTree::Shared(text) => {
            text.chars().count()
        }
        DisplayTree::Pi | DisplayTree::Cut => 1,
        DisplayTree::Sum(terms) => {
            let sign = |at: usize, negative: bool| usize::from(at > 0 || negative);
            terms.iter().enumerate().map(|(at, (negative, term))| sign(at, *negative) + mathml_factor_width(term)).sum()
        }
        DisplayTree::Product(factors) => factors.iter().map(mathml_factor_width).sum(),
        DisplayTree::Fraction(above, below) => mathml_width(above).max(mathml_width(below)),
        DisplayTree::Power(base, n) => mathml_factor_width(base) + n.to_string().len(),
        DisplayTree::Call(name, argument) => name.len() + mathml_factor_width(argument),
        DisplayTree::Root(argument) => 1 + mathml_width(argument),
    }
}

/// Returns the number of visible characters of a formula that is used as a factor. A sum gets parentheses.
fn mathml_factor_width(view: &DisplayTree) -> usize {
    mathml_width(view) + if matches!(view, DisplayTree::Sum(_)) { 2 } else { 0 }
}

/// Returns the HTML of a formula in the verdicts on a publication. A long formula is shown as plain text, which is cut
/// after 120 characters.
pub fn formula_mathml_in_verdict(arena: &Arena, e: Expr) -> String {
    if is_short_formula_mathml(arena, e) {
        return breakable_mathml(&[MathmlSide::of(arena, e)]);
    }
    let text = print::print_text(arena, e);
    let start: String = text.chars().take(120).collect();
    format!(
        "<code>{} …</code> <span class=\"quiet\">({} characters; <code>tripos diff --json</code> has it whole)</span>",
        escape(&start),
        text.chars().count()
    )
}

/// Returns the MathML of a number with up to six significant digits.
pub fn number_mathml(x: f64) -> String {
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

/// Returns the HTML of a formula within a sentence, from its MathML.
pub fn inline_mathml(content: &str) -> String {
    format!("<math>{content}</math>")
}

/// Returns the MathML of a symbol's name. The ending `star` becomes a superscript star.
pub fn symbol_mathml(name: &str) -> String {
    match name.strip_suffix("star") {
        Some(letter) if !letter.is_empty() => {
            format!("<msup>{}<mo lspace=\"0\" rspace=\"0\">⋆</mo></msup>", mathml_name(&escape(letter)))
        }
        _ => mathml_name(&escape(name)),
    }
}

/// Returns the MathML of the name of a model symbol. It differs visibly from other names that would look equal.
pub fn distinct_symbol_mathml(model: &Model, name: &str) -> String {
    match print::print_symbol_view(&model.arena, name) {
        word @ DisplayTree::Word(_) => print::mathml_of(&word),
        DisplayTree::Name(printed) => symbol_mathml(&printed),
        _ => symbol_mathml(name),
    }
}

/// Returns the MathML of a vector's letter, bold and upright.
fn vector_letter_mathml(letter: &str) -> String {
    format!("<mi mathvariant=\"normal\" class=\"vector\">{}</mi>", escape(letter))
}

/// Returns the MathML of a unit vector of a frame, such as b₂ of frame B for the axis 1. Axes count
/// from 0.
pub fn unit_vector_mathml(frame: &str, axis: usize) -> String {
    format!("<msub>{}<mn>{}</mn></msub>", vector_letter_mathml(&frame.to_lowercase()), axis + 1)
}

/// Returns the MathML of a vector of a point, frame or body relative to the inertial frame, such as ᴺωᶜ. `of` is the
/// index of the point, frame or body in the model.
fn motion_vector_mathml(model: &Model, name: VectorName, of: usize) -> String {
    let letter = match name {
        VectorName::AngularVelocity => "ω",
        VectorName::AngularAcceleration => "α",
        other => other.name(),
    };
    let (base, of) = (vector_letter_mathml(letter), symbol_mathml(name.owner_name(model, of)));
    let inertial = symbol_mathml(&model.frames[0].name);
    format!("<mmultiscripts>{base}<mrow></mrow>{of}<mprescripts/><mrow></mrow>{inertial}</mmultiscripts>")
}

/// Returns the MathML of the name on the left side of a line of a derivation.
pub fn line_name_mathml(model: &Model, name: &LineName) -> String {
    match name {
        LineName::Quantity(kind) => quantity_mathml(model, kind),
        LineName::ActiveForce(at) => generalized_force_mathml("F", &model.speeds[*at].name),
        LineName::GeneralizedForce(at) => generalized_force_mathml("Q", &model.coordinates[*at].name),
        LineName::Symbol(letter) => symbol_mathml(letter),
    }
}

/// Returns the MathML of the name of a kinematic or dynamic quantity, such as a component of a
/// velocity.
fn quantity_mathml(model: &Model, kind: &QuantityKind) -> String {
    let basis = |frame: usize, axis| unit_vector_mathml(&model.frames[frame].name, axis);
    match *kind {
        QuantityKind::Component { vector, of, frame, axis } => {
            format!("<mrow>{}<mo>·</mo>{}</mrow>", motion_vector_mathml(model, vector, of), basis(frame, axis))
        }
        QuantityKind::Partial { vector, of, frame, axis, speed } => format!(
            "<mrow><mfrac><mrow><mo form=\"prefix\">∂</mo>{}</mrow><mrow><mo form=\"prefix\">∂</mo>{}</mrow></mfrac>\
             <mo>·</mo>{}</mrow>",
            motion_vector_mathml(model, vector, of),
            distinct_symbol_mathml(model, &model.speeds[speed].name),
            basis(frame, axis)
        ),
        _ => distinct_symbol_mathml(model, &kind.name(model)),
    }
}

/// Returns the MathML of a generalized force, such as F or Q with the speed or coordinate as index.
fn generalized_force_mathml(letter: &str, of: &str) -> String {
    format!("<msub><mi>{letter}</mi><mrow>{}</mrow></msub>", symbol_mathml(of))
}

/// Returns the HTML heading of a stage of a derivation, with velocities typeset.
pub fn stage_title_mathml(model: &Model, stage: Stage) -> String {
    let Stage::Velocities { vector, of, frame } = stage else { return escape(&stage.title(model)) };
    let (of, frame) = (
        inline_mathml(&motion_vector_mathml(model, vector, of)),
        inline_mathml(&symbol_mathml(&model.frames[frame].name)),
    );
    format!("Velocity and partial velocities: {of}, components in {frame}")
}

/// Returns the HTML name of a row of equations: a speed, a coordinate, or words such as `disk force
/// along b₁`.
pub fn row_name_mathml(model: &Model, row: &RowName) -> String {
    match row {
        RowName::Speed(_) | RowName::Coordinate(_) => inline_mathml(&distinct_symbol_mathml(model, &row.text(model))),
        RowName::Balance(BalanceName { frame, axis, .. }) => {
            let along = inline_mathml(&unit_vector_mathml(&model.frames[*frame].name, *axis));
            format!("{} along {along}", escape(&row.balance_name_without_axis(model)))
        }
        RowName::Constraint(_) | RowName::Power(_) | RowName::Law { .. } | RowName::Along(_) | RowName::Printed(_) => {
            escape(&row.text(model))
        }
    }
}

/// Returns the MathML of a matrix in square brackets, from cells in MathML. The style sheet draws the brackets, because
/// browsers without a mathematical font do not stretch them.
pub fn matrix_mathml(rows: &[Vec<String>]) -> String {
    let row = |cells: &Vec<String>| format!("<mtr>{}</mtr>\n", join_html(cells, |cell| format!("<mtd>{cell}</mtd>")));
    format!("<mtable class=\"matrix\">\n{}</mtable>", join_html(rows, row))
}

/// Returns the HTML of equations `left = right` below one another, aligned at their equals signs. Wide sides may be
/// broken into lines.
pub fn aligned_mathml_equations(lines: &[(MathmlSide, MathmlSide)]) -> String {
    format!("<table class=\"lines\">\n<tbody>\n{}</tbody>\n</table>\n", join_html(lines, aligned_mathml_row))
}

/// Returns the HTML of one equation as a table row.
fn aligned_mathml_row(sides: &(MathmlSide, MathmlSide)) -> String {
    let (left, right) = sides;
    // A wide left side would push all equals signs to the right.
    if left.breaks() {
        return format!("<tr><td class=\"wide\" colspan=\"2\">{}</td></tr>\n", breakable_mathml([left, right]));
    }
    let mut pieces = right.pieces();
    if let Some(first) = pieces.first_mut() {
        *first = format!("<mo form=\"infix\">=</mo><mrow>{first}</mrow>");
    }
    let class = if right.breaks() { " class=\"wide\"" } else { "" };
    let pieces = pieces.iter().map(|piece| inline_mathml(piece)).collect::<Vec<_>>().join(" ");
    format!("<tr><td>{}</td><td{class}>{pieces}</td></tr>\n", breakable_mathml([left]))
}
