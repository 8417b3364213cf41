//! Phrases that several commands print.

/// Heading above the definitions of named terms in formulas.
pub const NAMED_TERMS_HEADING: &str = "Terms that stand by a name";

/// Returns a number of entries in words, such as `1 entry`.
pub fn entry_count_words(count: usize) -> String {
    if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") }
}

/// Shortens a formula of more than 400 characters, and refers to `--json` for the whole formula.
pub fn shorten_formula(formula: &str) -> String {
    cut_formula(formula, 400, ", see --json")
}

/// Shortens a formula of more than 200 characters to its beginning.
pub fn formula_beginning(formula: &str) -> String {
    cut_formula(formula, 200, "")
}

/// Cuts a formula after `most` characters and adds its length and the words `where_else`.
fn cut_formula(formula: &str, most: usize, where_else: &str) -> String {
    match formula.char_indices().nth(most) {
        Some((at, _)) => format!("{} … ({} characters{where_else})", &formula[..at], formula.chars().count()),
        None => formula.to_owned(),
    }
}
