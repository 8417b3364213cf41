//! Text of Rust files, which is formatted from tokens and has comments.

use crate::lines::wrap;
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use std::fmt::Write;
use tripos_derive::plain_text::{one_line, with_visible_characters};

/// Returns a text from a model file that is safe in a Rust doc comment: on one line, with Markdown escaped. Otherwise
/// rustdoc would run indented text as examples, and make links of brackets and addresses.
#[must_use]
pub fn escape_doc_comment(text: &str) -> String {
    let line = one_line(text);
    let mut out = String::new();
    for c in with_visible_characters(&line).chars() {
        if matches!(c, '`' | '~' | '[' | ']' | '<' | '>') {
            out.push('\\');
        }
        out.push(c);
    }
    // An address in the text must not become a link.
    out.replace("://", "\\://")
}

/// Returns the lines of a file's header: its title, the sentence on its origin, and facts on its contents.
#[must_use]
pub fn rust_file_header(first: String, origin: &str, facts: &[String]) -> Vec<String> {
    let mut lines = vec![first, String::new(), origin.to_owned()];
    lines.extend(facts.iter().map(|fact| escape_doc_comment(fact)));
    lines
}

/// Returns a doc attribute that is marked as a comment on the next statement. Formatting turns it into a plain
/// comment.
#[must_use]
pub fn comment(text: &str) -> TokenStream {
    let marked = format!("{MARK}{text}");
    quote!(#[doc = #marked])
}

/// Mark at the beginning of those doc attributes that formatting turns into plain comments.
const MARK: &str = "~";

/// Returns the Rust item `pub use` that re-exports names of a module, in alphabetical order.
pub fn reexport<'n>(parent: &TokenStream, module: &str, names: impl IntoIterator<Item = &'n str>) -> TokenStream {
    let mut names: Vec<&str> = names.into_iter().collect();
    names.sort_unstable();
    let (module, names) = (format_ident!("{module}"), names.into_iter().map(|name| format_ident!("{name}")));
    quote!(pub use #parent::#module::{#(#names),*};)
}

/// Returns the Rust type and value of a constant array of names.
pub fn rust_name_array<'n>(list: impl Iterator<Item = &'n str>) -> (TokenStream, TokenStream) {
    let list: Vec<&str> = list.collect();
    let count = Literal::usize_unsuffixed(list.len());
    (quote!([&str; #count]), quote!([#(#list),*]))
}

/// Returns the formatted text of a Rust file. The header becomes file documentation, and marked attributes become
/// comments.
///
/// # Panics
/// Panics if the tokens are not a Rust file, which would be a defect of the generator.
#[must_use]
pub fn format(header: &[String], items: TokenStream) -> String {
    format_with_header("//!", header, items)
}

/// Returns the formatted text of a Rust file that another file can contain by `include!`. The header becomes a plain
/// comment, because file documentation would be an error there.
///
/// # Panics
/// Panics if the tokens are not a Rust file, which would be a defect of the generator.
#[must_use]
pub fn format_to_include(header: &[String], items: TokenStream) -> String {
    format_with_header("//", header, items)
}

/// Returns the formatted text of a Rust file. The header becomes comments that begin with `sign`.
fn format_with_header(sign: &str, header: &[String], items: TokenStream) -> String {
    let file: syn::File = syn::parse2(items).expect("generated tokens are a Rust file");
    let body = join_short_lines(&prettyplease::unparse(&file));
    // A line break in a header line would end the comment, and the rest would be code.
    let lines = header.iter().map(|line| one_line(&with_visible_characters(line)));
    let mut out: String =
        lines.map(|line| if line.is_empty() { format!("{sign}\n") } else { format!("{sign} {line}\n") }).collect();
    out.push('\n');
    let marked = format!("///{MARK}");
    let mut before = "";
    for line in body.lines() {
        // Blank lines separate items, as rustfmt would keep them.
        let starts = ["///", "pub ", "impl", "fn ", "use ", "#["].iter().any(|start| line.starts_with(start));
        let ended = before.starts_with('}') || before.ends_with(';') && !before.starts_with(' ');
        let both = |start: &str| before.starts_with(start) && line.starts_with(start);
        let in_list = before.starts_with("pub mod") && line.starts_with("#[rustfmt");
        if starts && ended && !(both("use") || both("pub mod") || in_list) {
            out.push('\n');
        }
        before = line;
        match line.split_once(&marked) {
            Some((indent, text)) if indent.trim().is_empty() => {
                for (at, part) in wrap(&with_visible_characters(text), 104 - indent.len().min(60)).iter().enumerate() {
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

/// Largest number of bytes in a line of code.
const WIDTH: usize = 100;

/// Joins short lines of code into lines of up to `WIDTH` bytes. They are short items of lists and fields, and
/// continuations that begin with an operator.
fn join_short_lines(body: &str) -> String {
    let is_short = |item: &str| {
        // A struct field that is set from an array entry counts as short.
        let item = if item.ends_with("],") { item.replacen(": ", "", 1) } else { item.to_owned() };
        let opens = item.starts_with(|c: char| c.is_ascii_alphanumeric() || matches!(c, '_' | '-' | '"'));
        opens && item.ends_with(',') && !item.contains([' ', '(', ')', '{', '}', '|', '&'])
    };
    let goes_on = |item: &str| ["+ ", "- ", "* ", "/ "].iter().any(|operator| item.starts_with(operator));
    let mut out = String::with_capacity(body.len());
    // `open` is the indent of the list whose last line can be continued, and `length` is the length of that line.
    let (mut open, mut length): (Option<usize>, usize) = (None, 0);
    let indent_of = |line: &str| line.len() - line.trim_start().len();
    let mut lines = body.lines().peekable();
    while let Some(line) = lines.next() {
        let (item, indent) = (line.trim_start(), indent_of(line));
        // An item stays on its own line if lines that belong to it follow.
        let is_whole = lines.peek().is_none_or(|next| indent_of(next) <= indent);
        let fits = length + 1 + item.len() <= WIDTH;
        if fits && (open == Some(indent) && is_short(item) || is_whole && goes_on(item)) {
            out.push(' ');
            out.push_str(item);
            length += 1 + item.len();
        } else {
            if !out.is_empty() {
                out.push('\n');
            }
            out.push_str(line);
            length = line.len();
            open = is_short(item).then_some(indent);
        }
    }
    out.push('\n');
    out
}
