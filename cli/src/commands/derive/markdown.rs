//! Derivation in Markdown as GitHub shows it. Formulas are LaTeX, between dollars or in blocks of
//! `math`.
//!
//! Invariant: for any names in a model, its words stay words. Characters that Markdown, HTML or its
//! search for formulas would read otherwise are escaped.

use super::document::{Block, BodyEntry, Document, Equation, Level, Meaning, Run, System};
use super::formulas::LATEX;
use super::layout::{Extent, Laid, RowMarks, entries, extent, lay, raised};
use std::fmt::Write;
use tripos_derive::algebra::text::print::latex_of;
use tripos_derive::algebra::text::view::View;

/// Largest number of equations in a block of `math`. Browsers set each block as a whole, which
/// takes long.
const ROWS: usize = 25;

/// Returns the document about a derivation as Markdown text.
pub fn markdown(document: &Document) -> String {
    let mut out = format!("# {}\n", escape(&document.title));
    for words in &document.about {
        let _ = write!(out, "\n{}\n", escape(words));
    }
    out += &symbols(&document.symbols);
    out += &bodies(&document.bodies);
    out + &document.blocks.iter().map(block).collect::<String>()
}

/// Returns the Markdown table of the symbols with their meanings and units.
fn symbols(list: &[Meaning]) -> String {
    let mut out = "\n## Symbols\n\n| symbol | meaning | unit |\n|---|---|---|\n".to_owned();
    for Meaning { symbol, about, unit } in list {
        let unit = raised(unit, escape, |power| format!("<sup>{}</sup>", escape(power)));
        let _ = writeln!(out, "| {} | {} | {unit} |", inline(&latex_of(symbol)), escape(about));
    }
    out
}

/// Returns the Markdown table of the bodies with mass and inertia.
fn bodies(list: &[BodyEntry]) -> String {
    let mut out = "\n## Bodies\n\n| body | mass and inertia |\n|---|---|\n".to_owned();
    for BodyEntry { name, about } in list {
        let about: String = about.iter().map(run).collect();
        let _ = writeln!(out, "| {} | {about} |", inline(&latex_of(name)));
    }
    out
}

/// Returns a block (heading, words, equations or linear system) in Markdown.
fn block(block: &Block) -> String {
    match block {
        Block::Heading(level, runs) => {
            let marks = match level {
                Level::Section => "##",
                Level::Step => "###",
                Level::Item => "####",
            };
            format!("\n{marks} {}\n", runs.iter().map(run).collect::<String>())
        }
        Block::Words(words) => format!("\n{}\n", escape(words)),
        Block::Equations(list) => equations(list),
        Block::System(system) => self::system(system),
    }
}

/// Returns words or a formula within a line of Markdown.
fn run(run: &Run) -> String {
    match run {
        Run::Words(words) => escape(words),
        Run::Formula(left) => inline(&(LATEX.left)(left)),
    }
}

/// Writes a formula within a line. Between bare dollars Markdown removes a backslash before a
/// punctuation mark, as in `\_`. Between dollars with backticks it removes nothing, but fewer
/// programs know these.
fn inline(formula: &str) -> String {
    let mut after_backslash = formula.split('\\').skip(1);
    let is_plain = after_backslash.all(|rest| rest.starts_with(|c: char| c.is_ascii_alphabetic()));
    if is_plain { format!("${formula}$") } else { format!("$`{formula}`$") }
}

/// Returns a formula as a separate block of `math` in Markdown.
fn math(formula: &str) -> String {
    // GitHub does not allow `\operatorname`; both commands set a word upright.
    format!("\n```math\n{}\n```\n", formula.replace("\\operatorname{", "\\mathrm{"))
}

/// Returns the linear system M x = f in Markdown: as matrices if they fit into a line, otherwise as
/// a list of entries.
fn system(system: &System) -> String {
    let extent = extent(system);
    let mut out = format!("\nOne row for each of {}.\n", escape(&system.rows.join(", ")));
    let row = |row: &Vec<View>| row.iter().map(latex_of).collect::<Vec<_>>().join(" & ");
    let matrix = |rows: Vec<String>| format!("\\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}", rows.join(" \\\\\n"));
    let column = |list: &[View]| list.iter().map(latex_of).collect::<Vec<_>>();
    let m = || matrix(system.matrix.iter().map(row).collect());
    if extent == Extent::Whole {
        let (unknowns, right) = (matrix(column(&system.unknowns)), matrix(column(&system.forcing)));
        return out + &math(&format!("{}\n{unknowns}\n=\n{right}", m()));
    }
    let unknowns = inline(&format!("x = ({})", column(&system.unknowns).join(", ")));
    let _ = writeln!(out, "\n$M x = f$ with {unknowns}.");
    if extent == Extent::Matrix {
        out += &math(&format!("M = {}", m()));
    } else {
        out.push_str("\nEntries of $M$ that are not listed are 0.\n");
    }
    out + &equations(&entries(system, extent))
}

/// Returns equations below one another in Markdown, each on as many lines as it needs.
fn equations(list: &[Equation]) -> String {
    let marks = RowMarks {
        end: " \\\\\n  ",
        indent: "&\\quad ",
        deep: "&\\qquad ",
        words: |words| format!("\\text{{{words}}}"),
    };
    let block = |rows: &[Laid]| {
        let rows: Vec<String> = rows.iter().map(|laid| laid.row(&marks)).collect();
        math(&format!("\\begin{{aligned}}\n{}\n\\end{{aligned}}", rows.join(" \\\\\n")))
    };
    lay(list, &LATEX).chunks(ROWS).map(block).collect()
}

/// Escapes the characters of a text that Markdown would read as markup.
fn escape(text: &str) -> String {
    let mut out = String::new();
    for (at, c) in text.char_indices() {
        // At the beginning of a line some characters would make a list or a heading.
        let before = &text[..at];
        let begins = match c {
            '-' | '+' | '=' => before.is_empty(),
            '.' | ')' => !before.is_empty() && before.bytes().all(|b| b.is_ascii_digit()),
            _ => false,
        };
        match c {
            // GitHub begins a formula at a dollar even after a backslash.
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
    use super::{escape, inline};

    #[test]
    fn words_stay_words() {
        for (words, expected) in [
            ("a rod_1 and <b> of 5 $ | `x`", "a rod\\_1 and \\<b\\> of 5 <span>$</span> \\| \\`x\\`"),
            ("- one", "\\- one"),
            ("12. one", "12\\. one"),
            ("two-part, T + V, v1.5", "two-part, T + V, v1.5"),
        ] {
            assert_eq!(escape(words), expected);
        }
    }

    #[test]
    fn formulas_with_escapes_stand_between_backticks() {
        assert_eq!(inline("\\dot{q}_{1}"), "$\\dot{q}_{1}$");
        assert_eq!(inline("\\mathrm{rod\\_1}"), "$`\\mathrm{rod\\_1}`$");
    }
}
