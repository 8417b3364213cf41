//! Layout of formulas on a page of a derivation. Formulas are broken into lines at signs, no matrix is wider than a
//! page, and formulas that are too long to read are left out.
//!
//! Invariant: a document has the same layout in LaTeX, Markdown and Typst. Widths are estimates, in tenths of an em.

use super::derivation_document::{Equation, LeftSide, System};
use super::latex_formulas::{DocumentLanguage, LATEX};
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::formula_width;

/// Largest number of characters in the source of a formula that is printed. Longer formulas are not readable.
const LONGEST: usize = 20_000;
/// Largest number of characters in the source of a line of a printed formula. TeX cannot typeset longer lines.
const LONGEST_LINE: usize = 4_000;
/// Width of a line on the page, in tenths of an em.
const LINE: usize = 380;
/// Largest width of a left side that shares its line with a right side, in tenths of an em. A wider
/// left side gets its own line.
const WIDE: usize = 120;
/// Width of the equals sign and of the indentation of further lines, in tenths of an em.
const INDENT: usize = 60;
/// Largest width of a line with matrices, in tenths of an em.
const MATRIX: usize = 430;

/// Words that replace a formula that is too long to print.
const TOO_LONG: &str = "an expression too long to print here";

/// Equation laid out for a page, with its right side broken into lines.
pub struct EquationLayout {
    /// Left side of the equation, in the document language.
    pub left: String,
    /// Lines of the right side, in the document language; `None` if it is too long to print.
    pub lines: Option<Vec<String>>,
    /// True if the left side is so wide that it gets its own line.
    pub is_wide: bool,
}

/// Marks of a document language between the lines of aligned equations.
pub struct RowMarks {
    /// Mark at the end of a line whose equation continues.
    pub end: &'static str,
    /// Indentation of a right side that begins on its own line below a wide left side.
    pub indent: &'static str,
    /// Beginning of a further line of a right side.
    pub deep: &'static str,
    /// Function that writes plain words inside a formula.
    pub words: fn(&str) -> String,
}

impl EquationLayout {
    /// Returns the text of the equation with the marks of a document language.
    pub fn row(&self, marks: &RowMarks) -> String {
        let next = format!("{}{}", marks.end, marks.deep);
        let right = self.lines.as_ref().map_or_else(|| (marks.words)(TOO_LONG), |lines| lines.join(&next));
        if self.is_wide {
            format!("& {}{}{}= {right}", self.left, marks.end, marks.indent)
        } else {
            format!("{} &= {right}", self.left)
        }
    }
}

/// Lays equations out for a page, in a document language, with their right sides aligned.
pub fn lay_out_equations(list: &[Equation], language: &DocumentLanguage) -> Vec<EquationLayout> {
    // Right sides are aligned: they begin after the widest left side that shares its line with a right side.
    let column = list.iter().map(|(left, _)| left_side_layout_width(left)).filter(|width| *width <= WIDE).max();
    let rest = LINE - column.unwrap_or(0).max(INDENT);
    let one = |(left, right): &Equation| {
        let is_wide = left_side_layout_width(left) > WIDE;
        let lines = (language.lines)(right, rest);
        let lengths = lines.iter().map(String::len);
        let is_too_long = lengths.clone().sum::<usize>() > LONGEST || lengths.max() > Some(LONGEST_LINE);
        EquationLayout { left: (language.left)(left), lines: (!is_too_long).then_some(lines), is_wide }
    };
    list.iter().map(one).collect()
}

/// Returns the estimated width of a left side, in tenths of an em. It includes 40 for spacing.
fn left_side_layout_width(left: &LeftSide) -> usize {
    let shown = (LATEX.left)(left);
    let shown =
        shown.replace("\\mathbf", "").replace("\\boldsymbol", "").replace("\\partial", "d").replace("\\frac", "");
    let shown = shown.replace("\\mathrm", "").replace("\\cdot", "").replace("\\omega", "o").replace("\\alpha", "a");
    4 * shown.chars().filter(char::is_ascii_alphanumeric).count() + 40
}

/// Choice of the layout of a linear system of equations of motion on a page.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum SystemLayout {
    /// The system M x = f is written with matrices, in one line.
    Whole,
    /// The matrix M gets its own line; the entries of f are listed as equations.
    Matrix,
    /// The entries of M and f are listed as equations, except the entries of M that are 0.
    Entries,
}

/// Chooses the layout of a linear system by its estimated width.
pub fn extent(system: &System) -> SystemLayout {
    let widest = |list: &mut dyn Iterator<Item = &DisplayTree>| list.map(formula_width).max().unwrap_or(0);
    let columns = (0..system.unknowns.len()).map(|j| 10 + widest(&mut system.matrix.iter().map(|row| &row[j])));
    let matrix = columns.sum::<usize>() + 40;
    let all = matrix + widest(&mut system.unknowns.iter()) + widest(&mut system.forcing.iter()) + 40;
    match () {
        () if all <= MATRIX => SystemLayout::Whole,
        () if matrix <= MATRIX => SystemLayout::Matrix,
        () => SystemLayout::Entries,
    }
}

/// Returns the entries of a linear system that a layout lists as equations. None are listed for `SystemLayout::Whole`.
pub fn system_layout_entries(system: &System, extent: SystemLayout) -> Vec<Equation> {
    let mut entries = Vec::new();
    if extent == SystemLayout::Entries {
        let entry = |(i, j): &(usize, usize)| (LeftSide::Entry('M', vec![i + 1, j + 1]), system.matrix[*i][*j].clone());
        entries.extend(system.filled.iter().map(entry));
    }
    if extent != SystemLayout::Whole {
        let forcing = system.forcing.iter().enumerate();
        entries.extend(forcing.map(|(i, entry)| (LeftSide::Entry('f', vec![i + 1]), entry.clone())));
    }
    entries
}

/// Returns a unit with raised powers. The functions `words` and `power` write its parts in a
/// document language.
pub fn lay_out_unit(unit: &str, words: fn(&str) -> String, power: fn(&str) -> String) -> String {
    let unit = unit.replace('*', " ");
    let mut parts = unit.split('^');
    let mut out = words(parts.next().unwrap_or_default());
    for part in parts {
        let end = part.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(part.len());
        out += &power(&part[..end]);
        out += &words(&part[end..]);
    }
    out
}
