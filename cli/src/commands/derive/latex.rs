//! A derivation in LaTeX: a document, or the sections for another document.
//!
//! Invariant: for any names in a model, the result compiles with `amsmath` alone. Text is escaped, and printed formulas
//! are read back as their terms by [`tripos_derive::algebra::text::notation`].

use super::document::{Block, Document, Equation, Level, Meaning, Run, System};
use super::formulas::LATEX;
use super::layout::{Extent, TOO_LONG, entries, extent, lay, raised};
use crate::latex::escape;
use std::fmt::Write;
use tripos_derive::algebra::text::print::latex_of;
use tripos_derive::algebra::text::view::View;

/// Number of columns that a matrix of amsmath has by default.
const COLUMNS: usize = 10;

/// Extent of the LaTeX text: a document, or its sections.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// A whole document, which compiles by itself.
    Document,
    /// Sections of the document, for another document to `\\input`.
    Fragment,
}

/// Writes a document, or its sections, in LaTeX.
pub fn latex(document: &Document, part: Part) -> String {
    let title = escape(&document.title);
    let about: Vec<String> = document.about.iter().map(|words| escape(words) + "\n").collect();
    let body = about.join("\n") + &symbols(&document.symbols) + &document.blocks.iter().map(block).collect::<String>();
    match part {
        Part::Fragment => format!(
            "% Needs \\usepackage{{amsmath}} and \\allowdisplaybreaks in the preamble.\n\\section*{{{title}}}\n{body}"
        ),
        Part::Document => format!(
            "\\documentclass[a4paper]{{article}}\n\\usepackage[margin=25mm]{{geometry}}\n\\usepackage{{amsmath}}\n\\allowdisplaybreaks\n\
             \\begin{{document}}\n\\section*{{{title}}}\n{body}\n\\end{{document}}\n"
        ),
    }
}

fn symbols(list: &[Meaning]) -> String {
    let mut out = "\n\\section{Symbols}\n\\begin{description}\n\\setlength{\\itemsep}{0pt}\\setlength{\\parsep}{0pt}\n"
        .to_owned();
    for Meaning { symbol, about, unit } in list {
        let unit = raised(unit, escape, |power| format!("\\textsuperscript{{{}}}", escape(power)));
        let parts: Vec<String> = [escape(about), unit].into_iter().filter(|part| !part.is_empty()).collect();
        let _ = writeln!(out, "\\item[\\({}\\)] {}", latex_of(symbol), parts.join(", "));
    }
    out + "\\end{description}\n"
}

fn block(block: &Block) -> String {
    match block {
        Block::Heading(level, runs) => {
            let command = match level {
                Level::Section => "section",
                Level::Step => "subsection",
                Level::Item => "paragraph",
            };
            format!("\n\\{command}{{{}}}\n", runs.iter().map(run).collect::<String>())
        }
        Block::Words(words) => escape(words) + "\n",
        Block::Equations(list) => equations(list),
        Block::System(system) => self::system(system),
    }
}

fn run(run: &Run) -> String {
    match run {
        Run::Words(words) => escape(words),
        Run::Formula(left) => format!("${}$", (LATEX.left)(left)),
    }
}

/// Writes the system M x = f with matrices if they fit into a line; else lists the entries one by one.
fn system(system: &System) -> String {
    let extent = extent(system);
    let mut out = format!("One row for each of {}.\n\n", escape(&system.rows.join(", ")));
    if extent != Extent::Entries && system.unknowns.len() > COLUMNS {
        let _ = writeln!(out, "\\setcounter{{MaxMatrixCols}}{{{}}}", system.unknowns.len());
    }
    let row = |row: &Vec<View>| row.iter().map(latex_of).collect::<Vec<_>>().join(" & ");
    let matrix = |rows: Vec<String>| format!("\\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}", rows.join(" \\\\\n"));
    let column = |list: &[View]| list.iter().map(latex_of).collect::<Vec<_>>();
    let m = || matrix(system.matrix.iter().map(row).collect());
    if extent == Extent::Whole {
        let (unknowns, right) = (matrix(column(&system.unknowns)), matrix(column(&system.forcing)));
        let _ = writeln!(out, "\\[\n{}\n{unknowns}\n=\n{right}\n\\]", m());
        return out;
    }
    let _ = writeln!(out, "\\(M x = f\\) with \\(x = ({})\\).", column(&system.unknowns).join(", "));
    if extent == Extent::Matrix {
        let _ = writeln!(out, "\\[\nM = {}\n\\]", m());
    } else {
        out.push_str("Entries of \\(M\\) that are not listed are 0.\n");
    }
    out + &equations(&entries(system, extent))
}

/// Writes equations below one another, each in as many lines as it needs.
fn equations(list: &[Equation]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let rows = lay(list, &LATEX).into_iter().map(|laid| match laid.lines {
        Some(lines) => format!("{} &= {}", laid.left, lines.join(" \\\\\n  &\\qquad ")),
        None => format!("{} &= \\text{{{TOO_LONG}}}", laid.left),
    });
    format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", rows.collect::<Vec<_>>().join(" \\\\\n"))
}
