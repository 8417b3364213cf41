//! Derivation as a Typst document that compiles without further files.
//!
//! Invariant: for any names in a model, the result compiles, and its words stay words.

use super::document::{Block, BodyEntry, Document, Equation, Level, Meaning, Run, System};
use super::formulas::TYPST;
use super::layout::{Extent, RowMarks, entries, extent, lay, raised};
use std::fmt::Write;
use tripos_derive::algebra::text::print::typst_of;
use tripos_derive::algebra::text::view::View;

/// Returns the document about a derivation as Typst text.
pub fn typst(document: &Document) -> String {
    let mut out =
        "#set page(paper: \"a4\", margin: 25mm)\n#show math.equation: set block(breakable: true)\n#set math.equation(numbering: \"(1)\")\n".to_owned();
    let _ = write!(out, "\n= {}\n", escape(&document.title));
    for words in &document.about {
        let _ = write!(out, "\n{}\n", escape(words));
    }
    out += &symbols(&document.symbols);
    out += &bodies(&document.bodies);
    out + &document.blocks.iter().map(block).collect::<String>()
}

/// Returns the Typst section on the symbols with their meanings and units.
fn symbols(list: &[Meaning]) -> String {
    let mut out = "\n== Symbols\n\n".to_owned();
    for Meaning { symbol, about, unit } in list {
        let unit = raised(unit, escape, |power| format!("#super[{}]", escape(power)));
        let parts: Vec<String> = [escape(about), unit].into_iter().filter(|part| !part.is_empty()).collect();
        let _ = writeln!(out, "/ ${}$: {}", typst_of(symbol), parts.join(", "));
    }
    out
}

/// Returns the Typst section on the bodies with mass and inertia.
fn bodies(list: &[BodyEntry]) -> String {
    let mut out = "\n== Bodies\n\n".to_owned();
    for BodyEntry { name, about } in list {
        let about: String = about.iter().map(run).collect();
        let _ = writeln!(out, "/ ${}$: {about}", typst_of(name));
    }
    out
}

/// Returns a block (heading, words, equations or linear system) in Typst.
fn block(block: &Block) -> String {
    match block {
        Block::Heading(level, runs) => {
            let marks = match level {
                Level::Section => "==",
                Level::Step => "===",
                Level::Item => "====",
            };
            format!("\n{marks} {}\n", runs.iter().map(run).collect::<String>())
        }
        Block::Words(words) => format!("\n{}\n", escape(words)),
        Block::Equations(list) => equations(list),
        Block::System(system) => self::system(system),
    }
}

/// Returns words or a formula within a line of Typst.
fn run(run: &Run) -> String {
    match run {
        Run::Words(words) => escape(words),
        Run::Formula(left) => format!("${}$", (TYPST.left)(left)),
    }
}

/// Returns a formula as a separate block in Typst.
fn math(formula: &str) -> String {
    format!("\n$ {formula} $\n")
}

/// Returns the linear system M x = f in Typst: as matrices if they fit into a line, otherwise as a
/// list of entries.
fn system(system: &System) -> String {
    let extent = extent(system);
    let mut out = format!("\nOne row for each of {}.\n", escape(&system.rows.join(", ")));
    let row = |row: &Vec<View>| row.iter().map(typst_of).collect::<Vec<_>>().join(", ");
    let m = || format!("mat(delim: \"[\",\n  {})", system.matrix.iter().map(row).collect::<Vec<_>>().join(";\n  "));
    let column = |list: &[View]| list.iter().map(typst_of).collect::<Vec<_>>().join(", ");
    let vector = |list: &[View]| format!("vec(delim: \"[\", {})", column(list));
    if extent == Extent::Whole {
        let (unknowns, right) = (vector(&system.unknowns), vector(&system.forcing));
        return out + &math(&format!("{}\n  {unknowns}\n  = {right}", m()));
    }
    let _ = writeln!(out, "\n$M x = f$ with $x = ({})$.", column(&system.unknowns));
    if extent == Extent::Matrix {
        out += &math(&format!("M = {}", m()));
    } else {
        out.push_str("\nEntries of $M$ that are not listed are 0.\n");
    }
    out + &equations(&entries(system, extent))
}

/// Returns equations below one another in Typst, each on as many lines as it needs.
fn equations(list: &[Equation]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let marks = RowMarks { end: " \\\n    ", indent: "&", deep: "&quad ", words: |words| format!("\"{words}\"") };
    let rows = lay(list, &TYPST).into_iter().map(|laid| laid.row(&marks));
    math(&rows.collect::<Vec<_>>().join(" \\\n  "))
}

/// Escapes the characters of a text that Typst would read as markup.
fn escape(text: &str) -> String {
    let mut out = String::new();
    for (at, c) in text.char_indices() {
        let (before, after) = (&text[..at], &text[at + c.len_utf8()..]);
        let is_escaped = match c {
            '\\' | '*' | '_' | '`' | '$' | '#' | '<' | '>' | '@' | '[' | ']' | '~' => true,
            // These characters begin comments or dashes.
            '/' => before.is_empty() || after.starts_with(['/', '*']),
            '-' => before.is_empty() || after.starts_with(['-', '?']),
            // At the beginning of a line these characters would make a list or a heading.
            '+' | '=' => before.is_empty(),
            '.' => after.starts_with("..") || (!before.is_empty() && before.bytes().all(|b| b.is_ascii_digit())),
            _ => false,
        };
        out.push_str(if is_escaped { "\\" } else { "" });
        out.push(c);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::escape;

    #[test]
    fn words_stay_words() {
        for (words, expected) in [
            ("a rod_1 <b> of #1 @ 5 $", "a rod\\_1 \\<b\\> of \\#1 \\@ 5 \\$"),
            ("- one -- two", "\\- one \\-- two"),
            ("12. one... // two", "12\\. one\\... \\// two"),
            ("two-part, T + V, m/s", "two-part, T + V, m/s"),
        ] {
            assert_eq!(escape(words), expected);
        }
    }
}
