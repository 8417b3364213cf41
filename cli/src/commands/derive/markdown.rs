//! Derivation in the Markdown of GitHub. Formulas are LaTeX, between dollars or in blocks of `math`.
//!
//! Invariant: for any names in a model, its words stay words. Characters that Markdown or HTML would interpret, or that
//! would begin a formula, are escaped.

use super::derivation_document::{Block, BodyEntry, Document, Equation, InlineContent, Level, Meaning, System};
use super::latex_formulas::LATEX;
use super::layout::{
    EquationLayout, RowMarks, SystemLayout, extent, lay_out_equations, lay_out_unit, system_layout_entries,
};
use std::fmt::Write;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::latex_of;

/// Largest number of equations in a block of `math`. A browser typesets each block as a whole, which is slow for long
/// blocks.
const ROWS: usize = 25;

/// Returns the document about a derivation as Markdown text.
pub fn markdown(document: &Document) -> String {
    let mut out = format!("# {}\n", escape_markdown(&document.title));
    for words in &document.about {
        let _ = write!(out, "\n{}\n", escape_markdown(words));
    }
    out += &markdown_symbols(&document.symbols);
    out += &markdown_bodies(&document.bodies);
    out + &document.blocks.iter().map(markdown_block).collect::<String>()
}

/// Returns the Markdown table of the symbols with their meanings and units.
fn markdown_symbols(list: &[Meaning]) -> String {
    let mut out = "\n## Symbols\n\n| symbol | meaning | unit |\n|---|---|---|\n".to_owned();
    for Meaning { symbol, about, unit } in list {
        let unit = lay_out_unit(unit, escape_markdown, |power| format!("<sup>{}</sup>", escape_markdown(power)));
        let _ =
            writeln!(out, "| {} | {} | {unit} |", markdown_inline_formula(&latex_of(symbol)), escape_markdown(about));
    }
    out
}

/// Returns the Markdown table of the bodies with mass and inertia.
fn markdown_bodies(list: &[BodyEntry]) -> String {
    let mut out = "\n## Bodies\n\n| body | mass and inertia |\n|---|---|\n".to_owned();
    for BodyEntry { name, about } in list {
        let about: String = about.iter().map(markdown_inline_content).collect();
        let _ = writeln!(out, "| {} | {about} |", markdown_inline_formula(&latex_of(name)));
    }
    out
}

/// Returns a block (heading, words, equations or linear system) in Markdown.
fn markdown_block(block: &Block) -> String {
    match block {
        Block::Heading(level, runs) => {
            let marks = match level {
                Level::Section => "##",
                Level::Step => "###",
                Level::Item => "####",
            };
            format!("\n{marks} {}\n", runs.iter().map(markdown_inline_content).collect::<String>())
        }
        Block::Words(words) => format!("\n{}\n", escape_markdown(words)),
        Block::Equations(list) => markdown_equations(list),
        Block::System(system) => self::markdown_system(system),
    }
}

/// Returns words or a formula within a line of Markdown.
fn markdown_inline_content(run: &InlineContent) -> String {
    match run {
        InlineContent::Words(words) => escape_markdown(words),
        InlineContent::Formula(left) => markdown_inline_formula(&(LATEX.left)(left)),
    }
}

/// Writes a formula within a line, between dollars with backticks if needed. Between bare dollars, Markdown removes a
/// backslash before a punctuation mark, as in `\_`. Between dollars with backticks it removes nothing, but fewer
/// programs support them.
fn markdown_inline_formula(formula: &str) -> String {
    let mut after_backslash = formula.split('\\').skip(1);
    let is_plain = after_backslash.all(|rest| rest.starts_with(|c: char| c.is_ascii_alphabetic()));
    if is_plain { format!("${formula}$") } else { format!("$`{formula}`$") }
}

/// Returns a formula as a separate block of `math` in Markdown.
fn markdown_math_block(formula: &str) -> String {
    // GitHub does not allow `\operatorname`; both commands set a word upright.
    format!("\n```math\n{}\n```\n", formula.replace("\\operatorname{", "\\mathrm{"))
}

/// Returns the linear system M x = f in Markdown: as matrices if they fit into a line, otherwise as
/// a list of entries.
fn markdown_system(system: &System) -> String {
    let extent = extent(system);
    let mut out = format!("\nOne row for each of {}.\n", escape_markdown(&system.rows.join(", ")));
    let row = |row: &Vec<DisplayTree>| row.iter().map(latex_of).collect::<Vec<_>>().join(" & ");
    let matrix = |rows: Vec<String>| format!("\\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}", rows.join(" \\\\\n"));
    let column = |list: &[DisplayTree]| list.iter().map(latex_of).collect::<Vec<_>>();
    let m = || matrix(system.matrix.iter().map(row).collect());
    if extent == SystemLayout::Whole {
        let (unknowns, right) = (matrix(column(&system.unknowns)), matrix(column(&system.forcing)));
        return out + &markdown_math_block(&format!("{}\n{unknowns}\n=\n{right}", m()));
    }
    let unknowns = markdown_inline_formula(&format!("x = ({})", column(&system.unknowns).join(", ")));
    let _ = writeln!(out, "\n$M x = f$ with {unknowns}.");
    if extent == SystemLayout::Matrix {
        out += &markdown_math_block(&format!("M = {}", m()));
    } else {
        out.push_str("\nEntries of $M$ that are not listed are 0.\n");
    }
    out + &markdown_equations(&system_layout_entries(system, extent))
}

/// Returns equations below one another in Markdown, each on as many lines as it needs.
fn markdown_equations(list: &[Equation]) -> String {
    let marks = RowMarks {
        end: " \\\\\n  ",
        indent: "&\\quad ",
        deep: "&\\qquad ",
        words: |words| format!("\\text{{{words}}}"),
    };
    let block = |rows: &[EquationLayout]| {
        let rows: Vec<String> = rows.iter().map(|laid| laid.row(&marks)).collect();
        markdown_math_block(&format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", rows.join(" \\\\\n")))
    };
    lay_out_equations(list, &LATEX).chunks(ROWS).map(block).collect()
}

/// Escapes the characters of a text that Markdown would read as markup.
fn escape_markdown(text: &str) -> String {
    let mut out = String::new();
    for (at, c) in text.char_indices() {
        // Some characters at the beginning of a line would begin a list or a heading.
        let before = &text[..at];
        let begins = match c {
            '-' | '+' | '=' => before.is_empty(),
            '.' | ')' => !before.is_empty() && before.bytes().all(|b| b.is_ascii_digit()),
            _ => false,
        };
        match c {
            // GitHub begins a formula at a dollar sign even if a backslash precedes it.
            '$' => out.push_str("<span>$</span>"),
            '\\' | '`' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '|' | '~' | '&' => out.extend(['\\', c]),
            c if begins => out.extend(['\\', c]),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{escape_markdown, markdown_inline_formula};

    #[test]
    fn words_stay_words() {
        for (words, expected) in [
            ("a rod_1 and <b> of 5 $ | `x`", "a rod\\_1 and \\<b\\> of 5 <span>$</span> \\| \\`x\\`"),
            ("- one", "\\- one"),
            ("12. one", "12\\. one"),
            ("two-part, T + V, v1.5", "two-part, T + V, v1.5"),
        ] {
            assert_eq!(escape_markdown(words), expected);
        }
    }

    #[test]
    fn formulas_with_escapes_stand_between_backticks() {
        assert_eq!(markdown_inline_formula("\\dot{q}_{1}"), "$\\dot{q}_{1}$");
        assert_eq!(markdown_inline_formula("\\mathrm{rod\\_1}"), "$`\\mathrm{rod\\_1}`$");
    }
}
