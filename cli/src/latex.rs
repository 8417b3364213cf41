//! LaTeX text for words and names from files: escaped characters and unit vectors.

use tripos_derive::plain_text::code_point_text;

/// Escapes a text for the text mode of LaTeX. Characters that LaTeX fonts lack are replaced with their names in
/// brackets.
pub fn escape_latex(text: &str) -> String {
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
        other => format!("[{}]", code_point_text(other)),
    };
    text.chars().map(one).collect()
}

/// Returns the unit vector of a frame's axis in LaTeX, such as b₂ of frame B. `axis` counts from 0.
pub fn latex_unit_vector(frame: &str, axis: usize) -> String {
    format!("\\mathbf{{{}}}_{{{}}}", escape_latex(&frame.to_lowercase()), axis + 1)
}
