//! Tokens as formatted text, with comments.

use proc_macro2::TokenStream;
use quote::quote;
use std::fmt::Write;
use tripos_derive::plain::{one_line, visible};

/// Words of a file for a doc comment: on one line, and plain for Markdown, which would run fenced and indented text as examples and
/// follow brackets and addresses as links.
#[must_use]
pub fn prose(text: &str) -> String {
    let line = one_line(text);
    let mut out = String::new();
    for c in visible(&line).chars() {
        if matches!(c, '`' | '~' | '[' | ']' | '<' | '>') {
            out.push('\\');
        }
        out.push(c);
    }
    // An address is a text, too.
    out.replace("://", "\\://")
}

/// A comment on the next statement.
#[must_use]
pub fn comment(text: &str) -> TokenStream {
    let marked = format!("{MARK}{text}");
    quote!(#[doc = #marked])
}

const MARK: &str = "~";

/// Formats items and turns the marked attributes into comments.
///
/// # Panics
/// If the tokens are not a Rust file: a defect of the generator.
#[must_use]
pub fn format(header: &[String], items: TokenStream) -> String {
    let file: syn::File = syn::parse2(items).expect("generated tokens are a Rust file");
    let body = prettyplease::unparse(&file);
    // A line break in a line would end its comment: what follows would be code.
    let lines = header.iter().map(|line| one_line(&visible(line)));
    let mut out: String =
        lines.map(|line| if line.is_empty() { "//!\n".to_owned() } else { format!("//! {line}\n") }).collect();
    out.push('\n');
    let marked = format!("///{MARK}");
    let mut before = "";
    for line in body.lines() {
        // A blank line before each item, as rustfmt would keep.
        let starts = ["///", "pub ", "impl", "fn ", "use ", "#["].iter().any(|start| line.starts_with(start));
        let ended = before.starts_with('}') || before.ends_with(';') && !before.starts_with(' ');
        let group = |l: &str| l.split_whitespace().next() == Some("use") || l.starts_with("pub mod");
        if starts && ended && !(group(before) && (group(line) || line.starts_with("#[rustfmt"))) {
            out.push('\n');
        }
        before = line;
        match line.split_once(&marked) {
            Some((indent, text)) if indent.trim().is_empty() => {
                for (at, part) in wrap(&visible(text), 104 - indent.len().min(60)).iter().enumerate() {
                    let hang = if at == 0 { "" } else { "  " };
                    let _ = writeln!(out, "{indent}// {hang}{part}");
                }
            }
            _ => {
                out.push_str(line);
                out.push('\n');
            }
        }
    }
    out
}

/// Breaks a long comment at spaces.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split(' ') {
        let last = lines.last_mut().expect("at least one line");
        if !last.is_empty() && last.len() + 1 + word.len() > width {
            lines.push(word.to_owned());
        } else {
            if !last.is_empty() {
                last.push(' ');
            }
            last.push_str(word);
        }
    }
    lines
}
