//! Formulas in the document languages LaTeX (also used by Markdown) and Typst.

use super::derivation_document::{Axis, LeftSide, Vector};
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{
    break_latex_lines, break_typst_lines, latex_name, latex_of, typst_name, typst_of,
};
use tripos_derive::mechanics::VectorName;

/// Functions that write formulas in a document language.
pub struct DocumentLanguage {
    /// Function that writes a formula as lines of at most about the given width, in tenths of an
    /// em.
    pub lines: fn(&DisplayTree, usize) -> Vec<String>,
    /// Function that writes the left side of an equation.
    pub left: fn(&LeftSide) -> String,
}

/// Functions that write formulas in LaTeX with amsmath.
pub const LATEX: DocumentLanguage = DocumentLanguage { lines: break_latex_lines, left: latex_left_formula };

/// Functions that write formulas in Typst.
pub const TYPST: DocumentLanguage = DocumentLanguage { lines: break_typst_lines, left: typst_left };

/// Writes the left side of an equation in LaTeX.
fn latex_left_formula(left: &LeftSide) -> String {
    match left {
        LeftSide::Symbol(symbol) => latex_of(symbol),
        LeftSide::Zero => "0".to_owned(),
        LeftSide::EnergyRate => "\\frac{\\mathrm{d}}{\\mathrm{d}t}(T + V)".to_owned(),
        LeftSide::Entry(letter, places) => format!("{letter}_{{{}}}", formula_index_text(places)),
        LeftSide::Along(letter, name) => format!("{letter}_{{{}}}", latex_of(name)),
        LeftSide::Vector(vector) => latex_vector_formula(vector),
        LeftSide::Component(vector, axis) => {
            format!("{} \\cdot {}", latex_vector_formula(vector), latex_axis_formula(axis))
        }
        LeftSide::Partial(vector, speed, axis) => {
            let (vector, speed) = (latex_vector_formula(vector), latex_of(speed));
            format!("\\frac{{\\partial {vector}}}{{\\partial {speed}}} \\cdot {}", latex_axis_formula(axis))
        }
    }
}

/// Writes a vector in LaTeX: the frame at the upper left, the owner at the upper right.
fn latex_vector_formula(vector: &Vector) -> String {
    let letter = match vector.name {
        VectorName::AngularVelocity => "\\boldsymbol{\\omega}".to_owned(),
        VectorName::AngularAcceleration => "\\boldsymbol{\\alpha}".to_owned(),
        other => format!("\\mathbf{{{}}}", other.name()),
    };
    format!("{{}}^{{{}}}{letter}^{{{}}}", latex_name(&vector.frame), latex_name(&vector.of))
}

/// Writes the unit vector of an axis in LaTeX, such as b₂ of frame B.
fn latex_axis_formula(axis: &Axis) -> String {
    format!("\\mathbf{{{}}}_{{{}}}", axis.frame.replace('_', "\\_"), axis.number)
}

/// Writes the left side of an equation in Typst.
fn typst_left(left: &LeftSide) -> String {
    match left {
        LeftSide::Symbol(symbol) => typst_of(symbol),
        LeftSide::Zero => "0".to_owned(),
        LeftSide::EnergyRate => "frac(upright(d), upright(d) t) (T + V)".to_owned(),
        LeftSide::Entry(letter, places) => format!("{letter}_({})", formula_index_text(places)),
        LeftSide::Along(letter, name) => format!("{letter}_({})", typst_of(name)),
        LeftSide::Vector(vector) => typst_vector(vector),
        LeftSide::Component(vector, axis) => format!("{} dot {}", typst_vector(vector), typst_axis(axis)),
        LeftSide::Partial(vector, speed, axis) => {
            let (vector, speed) = (typst_vector(vector), typst_of(speed));
            format!("frac(partial {vector}, partial {speed}) dot {}", typst_axis(axis))
        }
    }
}

/// Writes a vector in Typst: the frame at the upper left, the owner at the upper right.
fn typst_vector(vector: &Vector) -> String {
    let letter = match vector.name {
        VectorName::AngularVelocity => "bold(omega)".to_owned(),
        VectorName::AngularAcceleration => "bold(alpha)".to_owned(),
        other => format!("bold(upright({}))", typst_word(other.name())),
    };
    format!("attach({letter}, tl: {}, tr: {})", typst_name(&vector.frame), typst_name(&vector.of))
}

/// Writes the unit vector of an axis in Typst, such as b₂ of frame B.
fn typst_axis(axis: &Axis) -> String {
    format!("bold(upright({}))_{}", typst_word(&axis.frame), axis.number)
}

/// Writes a word in a Typst formula. A longer word than one letter is put in quotes, as Typst
/// requires.
fn typst_word(word: &str) -> String {
    if word.len() == 1 { word.to_owned() } else { format!("\"{word}\"") }
}

/// Returns the indices of a matrix entry as text. They are separated by commas if an index has
/// several digits: 12, but 1,12.
fn formula_index_text(places: &[usize]) -> String {
    let comma = if places.iter().any(|place| *place > 9) { "," } else { "" };
    places.iter().map(usize::to_string).collect::<Vec<_>>().join(comma)
}
