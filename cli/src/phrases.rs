//! Phrases, and numbers as text, that are used in commands and on the page.

/// Heading above the definitions of the names in formulas.
pub const NAMED_TERMS_HEADING: &str = "Terms that stand by a name";

/// Returns a number of entries in words, such as `1 entry`.
pub fn entry_count_words(count: usize) -> String {
    if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") }
}

/// Returns a number with its noun, with an `s` in the plural, such as `2 scenes`.
pub fn counted_noun(n: usize, one: &str) -> String {
    format!("{n} {one}{}", if n == 1 { "" } else { "s" })
}

/// Returns the singular for a count of 1, and otherwise the plural.
pub fn plural_form(count: usize, one: &'static str, more: &'static str) -> &'static str {
    if count == 1 { one } else { more }
}

/// Returns a number as text with `decimals` decimals. A number below 0.001 gets a power of ten,
/// since decimals would not show it.
pub fn decimal_text(x: f64, decimals: usize) -> String {
    // The sum with 0 removes the sign of a negative zero.
    let x = x + 0.0;
    let is_small = x.abs() > 0.0 && x.abs() < 1e-3;
    if is_small { format!("{x:.decimals$e}") } else { format!("{x:.decimals$}") }
}

/// Returns a time as text with a readable unit, such as `1.25 ms`; `s` is in seconds.
pub fn seconds(s: f64) -> String {
    match s {
        s if s < 1e-3 => format!("{:.0} µs", s * 1e6),
        s if s < 1.0 => format!("{:.2} ms", s * 1e3),
        s => format!("{s:.2} s"),
    }
}

/// Shortens a formula of more than 400 characters, and refers to `--json` for the whole formula.
pub fn shorten_formula(formula: &str) -> String {
    cut_formula(formula, 400, ", see --json")
}

/// Shortens a formula of more than 200 characters to its beginning.
pub fn formula_beginning(formula: &str) -> String {
    cut_formula(formula, 200, "")
}

/// Cuts a formula after `most` characters, and appends its length and the words `where_else`.
fn cut_formula(formula: &str, most: usize, where_else: &str) -> String {
    match formula.char_indices().nth(most) {
        Some((at, _)) => format!("{} … ({} characters{where_else})", &formula[..at], formula.chars().count()),
        None => formula.to_owned(),
    }
}
