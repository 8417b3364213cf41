//! Derivation in LaTeX: a document, or sections to be included in another document.
//!
//! Invariant: for any names in a model, the result compiles with `amsmath` alone. Text is escaped,
//! and printed formulas are read back as their terms by [`tripos_derive::algebra::text::notation`].

use super::derivation_document::{Block, BodyEntry, Document, Equation, InlineContent, Level, Meaning, System};
use super::latex_formulas::LATEX;
use super::layout::{RowMarks, SystemLayout, extent, lay_out_equations, lay_out_unit, system_layout_entries};
use crate::latex::escape_latex;
use std::fmt::Write;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::latex_of;

/// Number of columns that a matrix of amsmath has by default.
const COLUMNS: usize = 10;

/// Choice between a whole LaTeX document and only its sections.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum LatexExtent {
    /// A whole document, which compiles by itself.
    Document,
    /// Sections of the document, for another document to `\\input`.
    Fragment,
}

/// Returns the document about a derivation as LaTeX text: the whole document, or only its sections.
pub fn latex_document(document: &Document, part: LatexExtent) -> String {
    let title = escape_latex(&document.title);
    let about: Vec<String> = document.about.iter().map(|words| escape_latex(words) + "\n").collect();
    let blocks = document.blocks.iter().map(latex_block).collect::<String>();
    let body = about.join("\n") + &latex_symbols(&document.symbols) + &latex_bodies(&document.bodies) + &blocks;
    match part {
        LatexExtent::Fragment => format!(
            "% Needs \\usepackage{{amsmath}} and \\allowdisplaybreaks in the preamble.\n\\section*{{{title}}}\n{body}"
        ),
        LatexExtent::Document => format!(
            "\\documentclass[a4paper]{{article}}\n\\usepackage[margin=25mm]{{geometry}}\n\\usepackage{{amsmath}}\n\\allowdisplaybreaks\n\
             {LONG_NAMES}\\begin{{document}}\n\\section*{{{title}}}\n{body}\n\\end{{document}}\n"
        ),
    }
}

/// Marks between the lines of equations in the LaTeX environment `align`.
const ROWS: RowMarks = RowMarks {
    end: " \\notag \\\\\n  ",
    indent: "&\\quad ",
    deep: "&\\qquad ",
    words: |words| format!("\\text{{{words}}}"),
};

/// LaTeX commands that permit line breaks within long names of a model file, and between formulas
/// in a sentence.
const LONG_NAMES: &str = "\\emergencystretch=3em\n\\let\\underscore\\_\n\
    \\renewcommand{\\_}{\\underscore\\ifmmode\\else\\allowbreak\\fi}\n";

/// LaTeX text that begins a list of names with their meanings.
const LIST: &str = "\\begin{description}\n\\setlength{\\itemsep}{0pt}\\setlength{\\parsep}{0pt}\n";

/// Returns the LaTeX section about the bodies with mass and inertia.
fn latex_bodies(list: &[BodyEntry]) -> String {
    let mut out = format!("\n\\section{{Bodies}}\n{LIST}");
    for BodyEntry { name, about } in list {
        let about: String = about.iter().map(latex_inline_content).collect();
        let _ = writeln!(out, "\\item[\\({}\\)] {about}", latex_of(name));
    }
    out + "\\end{description}\n"
}

/// Returns the LaTeX section about the symbols with their meanings and units.
fn latex_symbols(list: &[Meaning]) -> String {
    let mut out = format!("\n\\section{{Symbols}}\n{LIST}");
    for Meaning { symbol, about, unit } in list {
        let unit = lay_out_unit(unit, escape_latex, |power| format!("\\textsuperscript{{{}}}", escape_latex(power)));
        let parts: Vec<String> = [escape_latex(about), unit].into_iter().filter(|part| !part.is_empty()).collect();
        let _ = writeln!(out, "\\item[\\({}\\)] {}", latex_of(symbol), parts.join(", "));
    }
    out + "\\end{description}\n"
}

/// Returns a block (heading, words, equations or linear system) in LaTeX.
fn latex_block(block: &Block) -> String {
    match block {
        Block::Heading(level, runs) => {
            let command = match level {
                Level::Section => "section",
                Level::Step => "subsection",
                Level::Item => "paragraph",
            };
            format!("\n\\{command}{{{}}}\n", runs.iter().map(latex_inline_content).collect::<String>())
        }
        Block::Words(words) => escape_latex(words) + "\n",
        Block::Equations(list) => latex_equations(list),
        Block::System(system) => self::latex_system(system),
    }
}

/// Returns words or a formula within a line of LaTeX.
fn latex_inline_content(run: &InlineContent) -> String {
    match run {
        InlineContent::Words(words) => escape_latex(words),
        InlineContent::Formula(left) => format!("${}$", (LATEX.left)(left)),
    }
}

/// Returns the linear system M x = f in LaTeX: as matrices if they fit into a line, otherwise as a
/// list of entries.
fn latex_system(system: &System) -> String {
    let extent = extent(system);
    let mut out = format!("One row for each of {}.\n\n", escape_latex(&system.rows.join(", ")));
    if extent != SystemLayout::Entries && system.unknowns.len() > COLUMNS {
        let _ = writeln!(out, "\\setcounter{{MaxMatrixCols}}{{{}}}", system.unknowns.len());
    }
    let row = |row: &Vec<DisplayTree>| row.iter().map(latex_of).collect::<Vec<_>>().join(" & ");
    let matrix = |rows: Vec<String>| format!("\\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}", rows.join(" \\\\\n"));
    let column = |list: &[DisplayTree]| list.iter().map(latex_of).collect::<Vec<_>>();
    let m = || matrix(system.matrix.iter().map(row).collect());
    if extent == SystemLayout::Whole {
        let (unknowns, right) = (matrix(column(&system.unknowns)), matrix(column(&system.forcing)));
        let _ = writeln!(out, "\\begin{{equation}}\n{}\n{unknowns}\n=\n{right}\n\\end{{equation}}", m());
        return out;
    }
    // Each unknown is a formula of its own, so that lines break between them.
    let unknowns: Vec<String> = column(&system.unknowns).iter().map(|x| format!("\\({x}\\)")).collect();
    let _ = writeln!(out, "\\(M x = f\\), where \\(x\\) has the components {}.", unknowns.join(", "));
    if extent == SystemLayout::Matrix {
        let _ = writeln!(out, "\\begin{{equation}}\nM = {}\n\\end{{equation}}", m());
    } else {
        out.push_str("Entries of \\(M\\) that are not listed are 0.\n");
    }
    out + &latex_equations(&system_layout_entries(system, extent))
}

/// Returns numbered equations below one another in LaTeX, each on as many lines as it needs.
fn latex_equations(list: &[Equation]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let rows = lay_out_equations(list, &LATEX).into_iter().map(|laid| laid.row(&ROWS));
    format!("\\begin{{align}}\n{}\n\\end{{align}}\n", rows.collect::<Vec<_>>().join(" \\\\\n"))
}
