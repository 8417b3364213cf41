//! Words and names from files, in LaTeX.

use tripos_derive::plain::called;

/// Escapes words for the text mode of LaTeX. Characters that its fonts do not have are replaced by their names.
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

/// Writes an axis of a frame, counted from 0, as a basis vector in LaTeX.
pub fn basis(frame: &str, axis: usize) -> String {
    format!("\\mathbf{{{}}}_{{{}}}", escape(&frame.to_lowercase()), axis + 1)
}
