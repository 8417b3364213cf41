//! Texts in JavaScript files, as string literals or inside a page.
//!
//! Invariant: no text can end a comment, a string, or the `script` element that contains the module.

use crate::syntax::WIDTH;
use std::fmt::Write;

/// Returns the JavaScript string literal for a text. Characters that could end the string or the
/// `script` element are escaped.
#[must_use]
pub fn javascript_string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            // Characters that could begin markup or end a line are escaped.
            '<' | '>' | '&' | '\u{2028}' | '\u{2029}' => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04x}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// Returns a JavaScript array of string literals, on as many lines as it needs.
#[must_use]
pub fn javascript_string_array<'t>(list: impl IntoIterator<Item = &'t str>) -> String {
    let mut lines = vec![String::new()];
    for text in list.into_iter().map(javascript_string) {
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].len() + text.len() > WIDTH {
            lines.push(String::new());
        }
        let last = lines.len() - 1;
        let gap = if lines[last].is_empty() { "" } else { " " };
        lines[last].extend([gap, text.as_str(), ","]);
    }
    match lines.as_slice() {
        [one] => format!("[{}]", one.trim_end_matches(',')),
        many => format!("[\n  {}\n]", many.join("\n  ")),
    }
}

/// Returns the text of a module for a `script` element of a page, without its imports and the word
/// `export`.
#[must_use]
pub fn javascript_script_text(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("import "));
    lines.flat_map(|line| [line.strip_prefix("export ").unwrap_or(line), "\n"]).collect()
}
