//! Words that several parts of the command say.

/// Heading of the terms that stand by their names in the formulas after it.
pub const NAMED: &str = "Terms that stand by a name";

/// A number of entries, in words.
pub fn entries(count: usize) -> String {
    if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") }
}

/// Formulas that nobody reads to their end are cut; --json has them whole.
pub fn shortened(formula: &str) -> String {
    cut(formula, 400, ", see --json")
}

/// The start of a formula where its name says in which file the rest is.
pub fn start_of(formula: &str) -> String {
    cut(formula, 200, "")
}

fn cut(formula: &str, most: usize, where_else: &str) -> String {
    match formula.char_indices().nth(most) {
        Some((at, _)) => format!("{} … ({} characters{where_else})", &formula[..at], formula.chars().count()),
        None => formula.to_owned(),
    }
}
