//! Words that several parts of the command print.

/// Heading of the definitions of named terms in formulas.
pub const NAMED: &str = "Terms that stand by a name";

/// Number of entries, in words.
pub fn entries(count: usize) -> String {
    if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") }
}

/// Shortens a formula that is too long to read; `--json` has it whole.
pub fn shortened(formula: &str) -> String {
    cut(formula, 400, ", see --json")
}

/// Start of a formula, for a text that names the file with the rest.
pub fn start_of(formula: &str) -> String {
    cut(formula, 200, "")
}

fn cut(formula: &str, most: usize, where_else: &str) -> String {
    match formula.char_indices().nth(most) {
        Some((at, _)) => format!("{} … ({} characters{where_else})", &formula[..at], formula.chars().count()),
        None => formula.to_owned(),
    }
}
