//! Readable names of a publication's entries, made from their ids: number of the equation, line, and symbol.

use crate::page::markup::formula_mathml::{inline_mathml, symbol_mathml};
use crate::page::markup::html::escape;

/// Returns the HTML name of a printed entry: `kane-3.2-line1-b1` becomes "Kane (3.2), line 1, b₁". A part of the id
/// that has no known form is left unchanged.
pub fn entry_name(id: &str) -> String {
    let mut parts = Vec::new();
    for (at, part) in id.split('-').enumerate() {
        let words = entry_name_part(part, at == 0 && id.contains('-'));
        match parts.last_mut() {
            // The number of an equation belongs to the word before it.
            Some(last) if words.starts_with('(') => *last = format!("{last} {words}"),
            _ => parts.push(words),
        }
    }
    parts.join(", ")
}

/// Returns the HTML of one part of an entry's id. The first part, for which `is_first` is true, gets a capital letter.
fn entry_name_part(part: &str, is_first: bool) -> String {
    let letters = part.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &part[letters.len()..];
    if part.contains('.') && part.chars().all(|c| c.is_ascii_digit() || c == '.') {
        return format!("({part})");
    }
    match (letters, digits) {
        ("line" | "row" | "step", n) if !n.is_empty() => format!("{letters} {n}"),
        _ if is_first => {
            let mut rest = part.chars();
            rest.next().map_or_else(String::new, |first| escape(&(first.to_uppercase().to_string() + rest.as_str())))
        }
        (name, n) if name.len() == 1 && !n.is_empty() => inline_mathml(&symbol_mathml(part)),
        _ if part.ends_with('\'') => inline_mathml(&symbol_mathml(part)),
        _ => escape(part),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_become_numbers_lines_and_symbols() {
        let text = |id: &str| {
            let html = entry_name(id);
            html.split('<').map(|piece| piece.split_once('>').map_or(piece, |(_, text)| text)).collect::<String>()
        };
        assert_eq!(text("kane-3.2-line1-b1"), "Kane (3.2), line 1, b1");
        assert_eq!(text("2.1"), "(2.1)");
        assert_eq!(text("kane-final-row1"), "Kane, final, row 1");
        assert_eq!(text("swing"), "swing");
        assert!(entry_name("4.3-q1'").contains("<math>"));
    }
}
