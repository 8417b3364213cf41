//! Derivation as a Typst document that compiles without further files.
//!
//! Invariant: for any names in a model, the result compiles, and its words stay words.

use super::derivation_document::{
    Axis, Block, BodyEntry, Document, Equation, InlineContent, LeftSide, Level, Meaning, System, Vector,
};
use super::latex_formulas::{DocumentLanguage, formula_index_text};
use super::layout::{RowMarks, SystemLayout, extent, lay_out_equations, lay_out_unit, system_layout_entries};
use std::fmt::Write;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{break_typst_lines, typst_name, typst_of};
use tripos_derive::mechanics::VectorName;

/// Functions that write formulas in Typst.
const TYPST: DocumentLanguage = DocumentLanguage { lines: break_typst_lines, left: typst_left };

/// Returns the document about a derivation as Typst text.
pub fn typst(document: &Document) -> String {
    let mut out =
        "#set page(paper: \"a4\", margin: 25mm)\n#show math.equation: set block(breakable: true)\n#set math.equation(numbering: \"(1)\")\n".to_owned();
    let _ = write!(out, "\n= {}\n", escape_typst(&document.title));
    for words in &document.about {
        let _ = write!(out, "\n{}\n", escape_typst(words));
    }
    out += &typst_symbols(&document.symbols);
    out += &typst_bodies(&document.bodies);
    out + &document.blocks.iter().map(typst_block).collect::<String>()
}

/// Returns the Typst section about the symbols with their meanings and units.
fn typst_symbols(list: &[Meaning]) -> String {
    let mut out = "\n== Symbols\n\n".to_owned();
    for Meaning { symbol, about, unit } in list {
        let unit = lay_out_unit(unit, escape_typst, |power| format!("#super[{}]", escape_typst(power)));
        let parts: Vec<String> = [escape_typst(about), unit].into_iter().filter(|part| !part.is_empty()).collect();
        let _ = writeln!(out, "/ ${}$: {}", typst_of(symbol), parts.join(", "));
    }
    out
}

/// Returns the Typst section about the bodies with mass and inertia.
fn typst_bodies(list: &[BodyEntry]) -> String {
    let mut out = "\n== Bodies\n\n".to_owned();
    for BodyEntry { name, about } in list {
        let about: String = about.iter().map(typst_inline_content).collect();
        let _ = writeln!(out, "/ ${}$: {about}", typst_of(name));
    }
    out
}

/// Returns a block (heading, words, equations or linear system) in Typst.
fn typst_block(block: &Block) -> String {
    match block {
        Block::Heading(level, runs) => {
            let marks = match level {
                Level::Section => "==",
                Level::Step => "===",
                Level::Item => "====",
            };
            format!("\n{marks} {}\n", runs.iter().map(typst_inline_content).collect::<String>())
        }
        Block::Words(words) => format!("\n{}\n", escape_typst(words)),
        Block::Equations(list) => typst_equations(list),
        Block::System(system) => self::typst_system(system),
    }
}

/// Returns words or a formula within a line of Typst.
fn typst_inline_content(run: &InlineContent) -> String {
    match run {
        InlineContent::Words(words) => escape_typst(words),
        InlineContent::Formula(left) => format!("${}$", (TYPST.left)(left)),
    }
}

/// Returns a formula as a separate block in Typst.
fn typst_math_block(formula: &str) -> String {
    format!("\n$ {formula} $\n")
}

/// Returns the linear system M x = f in Typst: as matrices if they fit into a line, otherwise as a
/// list of entries.
fn typst_system(system: &System) -> String {
    let extent = extent(system);
    let mut out = format!("\nOne row for each of {}.\n", escape_typst(&system.rows.join(", ")));
    let row = |row: &Vec<DisplayTree>| row.iter().map(typst_of).collect::<Vec<_>>().join(", ");
    let m = || format!("mat(delim: \"[\",\n  {})", system.matrix.iter().map(row).collect::<Vec<_>>().join(";\n  "));
    let column = |list: &[DisplayTree]| list.iter().map(typst_of).collect::<Vec<_>>().join(", ");
    let vector = |list: &[DisplayTree]| format!("vec(delim: \"[\", {})", column(list));
    if extent == SystemLayout::Whole {
        let (unknowns, right) = (vector(&system.unknowns), vector(&system.forcing));
        return out + &typst_math_block(&format!("{}\n  {unknowns}\n  = {right}", m()));
    }
    let _ = writeln!(out, "\n$M x = f$ with $x = ({})$.", column(&system.unknowns));
    if extent == SystemLayout::Matrix {
        out += &typst_math_block(&format!("M = {}", m()));
    } else {
        out.push_str("\nEntries of $M$ that are not listed are 0.\n");
    }
    out + &typst_equations(&system_layout_entries(system, extent))
}

/// Returns equations below one another in Typst, each on as many lines as it needs.
fn typst_equations(list: &[Equation]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let marks = RowMarks { end: " \\\n    ", indent: "&", deep: "&quad ", words: |words| format!("\"{words}\"") };
    let rows = lay_out_equations(list, &TYPST).into_iter().map(|laid| laid.row(&marks));
    typst_math_block(&rows.collect::<Vec<_>>().join(" \\\n  "))
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

/// Writes a word in a Typst formula. A word of more than one letter is put in quotes, as Typst requires.
fn typst_word(word: &str) -> String {
    if word.len() == 1 { word.to_owned() } else { format!("\"{word}\"") }
}

/// Escapes the characters of a text that Typst would read as markup.
fn escape_typst(text: &str) -> String {
    let mut out = String::new();
    for (at, c) in text.char_indices() {
        let (before, after) = (&text[..at], &text[at + c.len_utf8()..]);
        let is_escaped = match c {
            '\\' | '*' | '_' | '`' | '$' | '#' | '<' | '>' | '@' | '[' | ']' | '~' => true,
            // These characters would begin comments or dashes.
            '/' => before.is_empty() || after.starts_with(['/', '*']),
            '-' => before.is_empty() || after.starts_with(['-', '?']),
            // These characters would begin a list or a heading if they begin a line.
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
    use super::escape_typst;

    #[test]
    fn words_stay_words() {
        for (words, expected) in [
            ("a rod_1 <b> of #1 @ 5 $", "a rod\\_1 \\<b\\> of \\#1 \\@ 5 \\$"),
            ("- one -- two", "\\- one \\-- two"),
            ("12. one... // two", "12\\. one\\... \\// two"),
            ("two-part, T + V, m/s", "two-part, T + V, m/s"),
        ] {
            assert_eq!(escape_typst(words), expected);
        }
    }
}
