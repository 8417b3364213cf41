//! Text of files in JavaScript: in comments, and as strings.
//!
//! Invariant: whatever the text is, it ends no comment, no string and no element `script` that the module is put into.

use crate::lines::wrap;
use std::fmt::Write;
use tripos_derive::plain::{one_line, visible};

/// The width of comments and code.
const WIDTH: usize = 110;

/// A text as a string of JavaScript.
#[must_use]
pub fn string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            // What could begin markup, and what ends lines.
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

/// A list of texts as an array, on as many lines as it takes.
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

/// A text as lines of a comment, indented.
pub fn comment(out: &mut String, indent: &str, text: &str) {
    let line = visible(&one_line(text)).replace('<', "< ").replace("<  ", "< ").replace("-->", "-- >");
    for (at, part) in wrap(line.trim(), WIDTH - indent.len() - 3).iter().enumerate() {
        let hang = if at == 0 || part.is_empty() { "" } else { "  " };
        let _ = writeln!(out, "{}", format!("{indent}// {hang}{part}").trim_end());
    }
}

/// Writes a statement without string literals on as many lines as it takes. It is broken at the spaces about operators,
/// so that no line but the last is a complete statement.
pub fn statement(out: &mut String, indent: &str, text: &str) {
    for (at, part) in wrap(text, WIDTH - indent.len() - 4).iter().enumerate() {
        let hang = if at == 0 { "" } else { "    " };
        let _ = writeln!(out, "{indent}{hang}{part}");
    }
}

/// A module's text as it stands in a script of a page, which neither imports nor exports.
#[must_use]
pub fn in_page(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("import "));
    lines.flat_map(|line| [line.strip_prefix("export ").unwrap_or(line), "\n"]).collect()
}
