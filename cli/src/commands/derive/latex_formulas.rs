//! Functions that write formulas in a document language, and their LaTeX versions, which Markdown uses, too.

use super::derivation_document::{Axis, LeftSide, Vector};
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{break_latex_lines, latex_name, latex_of};
use tripos_derive::mechanics::VectorName;

/// Functions that write formulas in a document language.
pub struct DocumentLanguage {
    /// Function that writes a formula as lines. Its second argument is the approximate largest width, in tenths of an
    /// em.
    pub lines: fn(&DisplayTree, usize) -> Vec<String>,
    /// Function that writes the left side of an equation.
    pub left: fn(&LeftSide) -> String,
}

/// Functions that write formulas in LaTeX with amsmath.
pub const LATEX: DocumentLanguage = DocumentLanguage { lines: break_latex_lines, left: latex_left_formula };

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

/// Returns the indices of a matrix entry as text. They are separated by commas only if an index has several digits: 12,
/// but 1,12.
pub fn formula_index_text(places: &[usize]) -> String {
    let comma = if places.iter().any(|place| *place > 9) { "," } else { "" };
    places.iter().map(usize::to_string).collect::<Vec<_>>().join(comma)
}
