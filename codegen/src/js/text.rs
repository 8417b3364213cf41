//! Text in JavaScript files: in comments, and as string literals.
//!
//! Invariant: no text can end a comment, a string or the `script` element that contains the module.

use crate::lines::wrap;
use std::fmt::Write;
use tripos_derive::plain::{one_line, visible};

/// Most bytes of a line of comments and code.
const WIDTH: usize = 110;

/// JavaScript string literal for a text.
#[must_use]
pub fn string(text: &str) -> String {
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

/// JavaScript array of string literals, on as many lines as it needs.
#[must_use]
pub fn strings<'t>(list: impl IntoIterator<Item = &'t str>) -> String {
    let mut lines = vec![String::new()];
    for text in list.into_iter().map(string) {
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

/// Writes a text as comment lines with an indent.
pub fn comment(out: &mut String, indent: &str, text: &str) {
    let line = visible(&one_line(text)).replace('<', "< ").replace("<  ", "< ").replace("-->", "-- >");
    for (at, part) in wrap(line.trim(), WIDTH - indent.len() - 3).iter().enumerate() {
        let hang = if at == 0 || part.is_empty() { "" } else { "  " };
        let _ = writeln!(out, "{}", format!("{indent}// {hang}{part}").trim_end());
    }
}

/// Writes a statement without string literals on as many lines as it needs. It is broken at the spaces around
/// operators, so that no line except the last is a complete statement.
pub fn statement(out: &mut String, indent: &str, text: &str) {
    for (at, part) in wrap(text, WIDTH - indent.len() - 4).iter().enumerate() {
        let hang = if at == 0 { "" } else { "    " };
        let _ = writeln!(out, "{indent}{hang}{part}");
    }
}

/// Text of a module for a script of a page, without its imports and the word `export`.
#[must_use]
pub fn in_page(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("import "));
    lines.flat_map(|line| [line.strip_prefix("export ").unwrap_or(line), "\n"]).collect()
}
