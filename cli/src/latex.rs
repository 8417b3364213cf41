//! Words of files in LaTeX.

use tripos_derive::plain::called;

/// Words for text mode: what TeX reads otherwise is written out, and what its fonts do not have is named.
pub fn escape(text: &str) -> String {
    let one = |c: char| match c {
        '\\' => "\\textbackslash{}".to_owned(),
        '~' => "\\textasciitilde{}".to_owned(),
        '^' => "\\textasciicircum{}".to_owned(),
        '{' | '}' | '$' | '&' | '#' | '_' | '%' => format!("\\{c}"),
        '<' | '>' | '|' => format!("\\ensuremath{{{c}}}").replace('|', "\\vert"),
        '∂' => "\\ensuremath{\\partial}".to_owned(),
        '–' => "--".to_owned(),
        '—' => "---".to_owned(),
        '’' => "'".to_owned(),
        ' '..='~' | '\u{c0}'..='\u{ff}' => c.to_string(),
        other => format!("[{}]", called(other)),
    };
    text.chars().map(one).collect()
}

/// An axis of a frame, counted from 0, as a basis vector.
pub fn basis(frame: &str, axis: usize) -> String {
    format!("\\mathbf{{{}}}_{{{}}}", escape(&frame.to_lowercase()), axis + 1)
}
