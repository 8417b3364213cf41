//! Displayed equations of a LaTeX file, found by their labels.

use super::latex_macros::{Macros, group_end, latex_without_comments, next_latex_mark_nearby};
use super::traced_text::{TracedError, TracedText};
use crate::diagnostic::nearest_name_advice;
use std::ops::Range;

/// LaTeX environments in which every line is an equation.
const LINES: [&str; 6] = ["align", "gather", "eqnarray", "flalign", "alignat", "xalignat"];
/// LaTeX environments that contain a single equation.
const SINGLE: [&str; 4] = ["equation", "displaymath", "multline", "math"];
/// LaTeX environments that split a single equation into lines.
const INNER: [&str; 6] = ["split", "aligned", "gathered", "alignedat", "multlined", "cases"];
/// Commands that begin or end environments or set labels; macros that contain them are expanded
/// first.
const STRUCTURE: [&str; 6] = ["begin", "end", "[", "]", "label", "tag"];
/// Largest number of lines that are read in one LaTeX environment.
const MAX_LINES: usize = 1000;
/// Largest length, in bytes, of a label that may be suggested for an unknown label.
const MAX_LABEL: usize = 100;
/// Largest number of labels that are searched for a suggestion if a label is unknown.
const MAX_LABELS: usize = 1000;
/// Largest length of one printed formula, in bytes.
const MAX_FORMULA: usize = 100_000;

/// LaTeX file prepared for the search for equations: its text without comments and definitions, and its macros.
pub struct LatexFile {
    /// Text without comments and definitions, with places in the file.
    text: TracedText,
    /// LaTeX macros that the file defines.
    pub macros: Macros,
    /// Displayed formulas of the file, in its order.
    displays: Vec<DisplayedFormula>,
}

/// Displayed formula of a LaTeX file, as a list of equations.
struct DisplayedFormula {
    equations: Vec<EquationLines>,
}

/// Lines of one equation of a displayed formula, as byte ranges.
struct EquationLines {
    /// Left side, from earlier lines, of an equation whose own line begins with `=`.
    left: Vec<Range<usize>>,
    /// Byte ranges of the equation's own lines in the text of the file.
    pieces: Vec<Range<usize>>,
    /// Labels and tags that the lines of the equation have.
    labels: Vec<String>,
    /// True if the lines contain an `=` outside of groups.
    has_relation: bool,
    /// Start, as a byte position, of a line that may belong to this equation or to the next. `None` if there is no such
    /// line.
    unclear: Option<usize>,
}

/// Choice of the equations that are found by a label.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum LabelChoice {
    /// Only the equations that have the label themselves.
    Labelled,
    /// All equations of the environment that contains the label.
    Display,
}

impl LatexFile {
    /// Prepares the text of a LaTeX file. The error is a macro that cannot be expanded.
    pub fn read(text: &str) -> Result<Self, TracedError> {
        let mut macros = Macros::default();
        let rest = macros.take_macro_definitions(&latex_without_comments(text));
        let structure = macros.with_commands(&STRUCTURE);
        let text = macros.expand_macros(&rest, &|name| structure.contains(name))?;
        let displays = displayed_formulas(&text.text);
        Ok(Self { text, macros, displays })
    }

    /// Equations with a label, as formulas without macros. The outer error is advice for a label that is not found or
    /// not unique. The inner error is a formula that cannot be read.
    pub fn equations(&self, label: &str, choice: LabelChoice) -> Result<Result<Vec<TracedText>, TracedError>, String> {
        let has = |lines: &EquationLines| lines.labels.iter().any(|l| l == label);
        let found: Vec<&DisplayedFormula> = self.displays.iter().filter(|d| d.equations.iter().any(has)).collect();
        let [display] = found[..] else {
            if found.len() > 1 {
                return Err(format!("the label stands at {} displayed formulas: name each once", found.len()));
            }
            let labels = self.displays.iter().flat_map(|d| &d.equations).flat_map(|lines| &lines.labels);
            let labels = labels.map(String::as_str).filter(|label| label.len() <= MAX_LABEL).take(MAX_LABELS);
            return Err(nearest_name_advice(label, labels));
        };
        let chosen = display.equations.iter().filter(|lines| choice == LabelChoice::Display || has(lines));
        Ok(chosen.map(|lines| self.formula(lines)).collect())
    }

    /// Formula of one equation, in one line and without macros. The error is an unclear line or a
    /// formula that is too long.
    fn formula(&self, lines: &EquationLines) -> Result<TracedText, TracedError> {
        let mut formula = TracedText::default();
        if let Some(at) = lines.unclear {
            let message = "this line may continue the equation above or begin the one below";
            let help = "copy the equation into the publication file, under `printed`";
            return Err(TracedError::new(self.text.place_of_part(at..at + 1), message, help));
        }
        for range in lines.left.iter().chain(&lines.pieces) {
            let part = text_without_labels(&self.text.part_with_places(range.clone()));
            if !formula.text.is_empty() {
                let place = part.place_of_part(0..0);
                formula.push_with_place(" ", &place);
            }
            formula.push_part(&part, 0..part.text.len());
        }
        let formula = self.macros.expand_macros(&formula, &|_| true)?.in_one_line();
        if formula.text.len() > MAX_FORMULA {
            let message = format!("the formula has more than {MAX_FORMULA} characters");
            let start = formula.place_of_part(0..1);
            return Err(TracedError::new(start, message, "print it in parts, with abbreviations"));
        }
        Ok(formula)
    }
}

/// Name of the environment that begins or ends at byte `at`, and the byte after its closing brace. `mark` is `\begin{`
/// or `\end{`. Returns `None` if `mark` is not at this byte.
fn latex_environment(text: &str, at: usize, mark: &str) -> Option<(String, usize)> {
    let rest = text[at..].strip_prefix(mark)?;
    let close = next_latex_mark_nearby(rest, 0, '}').filter(|close| *close < 40)?;
    Some((rest[..close].to_owned(), at + mark.len() + close + 1))
}

/// Displayed formulas of a LaTeX text, in its order.
fn displayed_formulas(text: &str) -> Vec<DisplayedFormula> {
    let (mut list, mut at) = (Vec::new(), 0);
    while let Some(found) = text[at..].find(['\\', '$']) {
        at += found;
        let rest = &text[at..];
        let (end_mark, start, layout) = if rest.starts_with("$$") {
            ("$$".to_owned(), at + 2, DisplayLayout::Single)
        } else if rest.starts_with("\\[") {
            ("\\]".to_owned(), at + 2, DisplayLayout::Single)
        } else if let Some((name, end)) = latex_environment(text, at, "\\begin{") {
            let plain = name.trim_end_matches('*');
            if !LINES.contains(&plain) && !SINGLE.contains(&plain) {
                at = end;
                continue;
            }
            // The number of columns of an `alignat` is not part of the formula.
            let columns = plain.ends_with("alignat") && text[end..].starts_with('{');
            let start = if columns { group_end(text, end).unwrap_or(end) } else { end };
            let layout = if LINES.contains(&plain) { DisplayLayout::Lines } else { DisplayLayout::Single };
            (format!("\\end{{{name}}}"), start, layout)
        } else {
            let escaped = rest.starts_with('\\').then(|| rest[1..].chars().next().map_or(0, char::len_utf8));
            at += 1 + escaped.unwrap_or(0);
            continue;
        };
        let Some(length) = text[start..].find(&end_mark) else { break };
        let body = start..start + length;
        at = body.end + end_mark.len();
        list.push(split_displayed_formula(text, body, layout));
    }
    list
}

/// Layout of a displayed formula in LaTeX: lines, or a single formula.
#[derive(Clone, Copy, PartialEq)]
enum DisplayLayout {
    /// Lines, each of which may have its own number and labels.
    Lines,
    /// Single formula with one number; an inner environment may split it into lines.
    Single,
}

/// Splits a displayed formula into its equations.
fn split_displayed_formula(text: &str, body: Range<usize>, layout: DisplayLayout) -> DisplayedFormula {
    let inner = match layout {
        DisplayLayout::Lines => None,
        DisplayLayout::Single => inner_environment_content(text, &body),
    };
    let rows = match (&inner, layout) {
        (Some(inner), _) => display_rows(text, inner.clone()),
        (None, DisplayLayout::Lines) => display_rows(text, body.clone()),
        (None, DisplayLayout::Single) => vec![body.clone()],
    };
    let mut equations: Vec<EquationLines> = Vec::new();
    let mut left: Vec<Range<usize>> = Vec::new();
    for (at, row) in rows.iter().enumerate() {
        let own = latex_labels(&text[row.clone()]);
        let before = equals_sign_of_display_row(text, row).map(|at| row.start..at);
        let above = at.checked_sub(1).map(|above| &text[rows[above].clone()]);
        let goes_on = display_row_begins_with_sign(&text[row.clone()]) || above.is_some_and(display_row_ends_with_sign);
        let joins = match (&before, equations.last()) {
            (_, None) => false,
            // The equation in the line above has no `=` yet.
            (_, Some(last)) if !last.has_relation => true,
            (None, _) => goes_on,
            (Some(_), _) => false,
        };
        if joins {
            let last = equations.last_mut().expect("an equation above");
            // A number ends an equation. A line without a number may be the beginning of the next equation.
            let numbered = above.is_some_and(|above| !is_without_number(above));
            let followed = at + 1 < rows.len();
            let is_unclear = layout == DisplayLayout::Lines && last.has_relation && numbered && followed;
            if is_unclear && is_without_number(&text[row.clone()]) {
                last.unclear = Some(row.start);
            }
            if let Some(before) = before {
                last.has_relation = true;
                left = last.pieces.iter().cloned().chain([before]).collect();
            }
            last.pieces.push(row.clone());
            last.labels.extend(own);
            continue;
        }
        let has_relation = before.is_some();
        let is_chain = before.as_ref().is_some_and(|before| is_blank(&text[before.clone()]));
        if let Some(before) = before.filter(|_| !is_chain) {
            left = vec![before];
        }
        let left = if is_chain { left.clone() } else { Vec::new() };
        equations.push(EquationLines { left, pieces: vec![row.clone()], labels: own, has_relation, unclear: None });
    }
    if layout == DisplayLayout::Single {
        let shared = latex_labels(&text[body]);
        for lines in &mut equations {
            lines.labels.clone_from(&shared);
        }
    }
    DisplayedFormula { equations }
}

/// True if LaTeX prints no number after a line.
fn is_without_number(row: &str) -> bool {
    row.contains("\\nonumber") || row.contains("\\notag")
}

/// Line without labels, alignment marks, and commands that only insert space.
fn display_row_without_space(row: &str) -> String {
    let mut text = text_without_labels(&TracedText::text_at_place(row, 0)).text.replace('&', " ").replace("{}", " ");
    for space in ["\\qquad", "\\quad", "\\,", "\\;", "\\:", "\\!", "\\ ", "\\left.", "\\right.", "~"] {
        text = text.replace(space, " ");
    }
    text.trim().to_owned()
}

/// True if a part of a line prints nothing.
fn is_blank(part: &str) -> bool {
    display_row_without_space(part).is_empty()
}

/// True if a line begins with an operator or `=`, so that it continues the line above.
fn display_row_begins_with_sign(row: &str) -> bool {
    let row = display_row_without_space(row);
    row.starts_with(['+', '-', '*', '/', '=']) || row.starts_with("\\cdot") || row.starts_with("\\times")
}

/// True if a line ends with an operator, `=` or an open parenthesis, so that the next line
/// continues it.
fn display_row_ends_with_sign(row: &str) -> bool {
    let row = display_row_without_space(row);
    row.ends_with(['+', '-', '*', '/', '=', '(']) || row.ends_with("\\cdot") || row.ends_with("\\times")
}

/// Content of an inner environment, such as split, that makes up the whole formula; `None` if there is none.
fn inner_environment_content(text: &str, body: &Range<usize>) -> Option<Range<usize>> {
    let open = body.start + text[body.clone()].find("\\begin{")?;
    let (name, mut start) = latex_environment(text, open, "\\begin{")?;
    INNER.contains(&name.trim_end_matches('*')).then_some(())?;
    if name == "alignedat" && text[start..].starts_with('{') {
        start = group_end(text, start)?;
    }
    if text[start..].starts_with('[') {
        start += next_latex_mark_nearby(text, start, ']')? + 1;
    }
    let end_mark = format!("\\end{{{name}}}");
    let end = start + text[start..body.end].find(&end_mark)?;
    let around = [&text[body.start..open], &text[end + end_mark.len()..body.end]];
    let is_frame = |part: &str| {
        let part = text_without_labels(&TracedText::text_at_place(part, 0)).text;
        ["", ",", ".", ";", "\\left\\{", "\\left.", "\\right.", "\\right\\}", "\\right.,", "\\right.."]
            .contains(&part.replace(char::is_whitespace, "").as_str())
    };
    around.into_iter().all(is_frame).then_some(start..end)
}

/// Walks through a range of LaTeX text, and calls `each(byte, rest of the range)` at every character outside of groups
/// and environments. The walk ends when `each` returns false.
fn walk_display_outside_groups(text: &str, range: &Range<usize>, mut each: impl FnMut(usize, &str) -> bool) {
    let (mut depth, mut at) = (0_usize, range.start);
    while at < range.end {
        let rest = &text[at..range.end];
        if depth == 0 && !each(at, rest) {
            return;
        }
        let step = rest.chars().next().map_or(1, char::len_utf8);
        match rest.as_bytes()[0] {
            b'{' => depth += 1,
            b'}' => depth = depth.saturating_sub(1),
            b'\\' if rest.starts_with("\\begin{") => {
                depth += 1;
                at += "\\begin{".len()
                    + next_latex_mark_nearby(rest, 0, '}').map_or(0, |close| close + 1 - "\\begin{".len());
                continue;
            }
            b'\\' if rest.starts_with("\\end{") => {
                depth = depth.saturating_sub(1);
                at += next_latex_mark_nearby(rest, 0, '}').map_or(1, |close| close + 1);
                continue;
            }
            b'\\' => at += rest[1..].chars().next().map_or(0, char::len_utf8),
            _ => {}
        }
        at += step;
    }
}

/// Byte ranges of the non-empty lines of a text. Lines are separated by `\\`, after which a row distance may follow.
fn display_rows(text: &str, range: Range<usize>) -> Vec<Range<usize>> {
    let mut cuts = Vec::new();
    walk_display_outside_groups(text, &range, |at, rest| {
        if rest.starts_with("\\\\") {
            let star = at + 2 + usize::from(text[at + 2..range.end].starts_with('*'));
            let distance = text[star..range.end].starts_with('[').then(|| next_latex_mark_nearby(text, star, ']'));
            cuts.push((at, (star + distance.flatten().map_or(0, |close| close + 1)).min(range.end)));
        }
        true
    });
    let mut list = Vec::new();
    let mut from = range.start;
    for (at, next) in cuts {
        // A separator inside of a row distance does not count.
        if at < from {
            continue;
        }
        list.push(from..at);
        from = next;
    }
    list.push(from..range.end);
    list.truncate(MAX_LINES);
    list.retain(|row| !is_blank(&text[row.clone()]) || !latex_labels(&text[row.clone()]).is_empty());
    list
}

/// Byte of the first `=` of a line outside of groups and environments; `None` if there is none.
fn equals_sign_of_display_row(text: &str, row: &Range<usize>) -> Option<usize> {
    let mut found = None;
    walk_display_outside_groups(text, row, |at, rest| {
        if rest.starts_with('=') {
            found = Some(at);
        }
        found.is_none()
    });
    found
}

/// Labels and tags that a LaTeX text sets.
fn latex_labels(text: &str) -> Vec<String> {
    let mut list = Vec::new();
    for mark in ["\\label{", "\\tag{", "\\tag*{"] {
        for (at, _) in text.match_indices(mark) {
            let open = at + mark.len() - 1;
            if let Some(end) = group_end(text, open) {
                list.push(text[open + 1..end - 1].trim().to_owned());
            }
        }
    }
    list
}

/// Text without labels, tags, fixed spaces and commands about line numbers.
fn text_without_labels(text: &TracedText) -> TracedText {
    let with_group = ["label", "tag", "intertext", "shortintertext", "hspace", "vspace", "phantom", "hphantom"];
    let alone = ["nonumber", "notag", "displaybreak", "allowdisplaybreaks", "ensuremath", "xspace"];
    let (mut out, mut at) = (TracedText::default(), 0);
    while let Some(c) = text.text[at..].chars().next() {
        let name = if c == '\\' { super::latex_macros::command_at(&text.text, at) } else { "" };
        let behind = at + 1 + name.len();
        if with_group.contains(&name) {
            let open = behind + usize::from(text.text[behind..].starts_with('*'));
            at = text.text[open..].starts_with('{').then(|| group_end(&text.text, open)).flatten().unwrap_or(open);
        } else if alone.contains(&name) {
            at = behind;
        } else if c == '\\' {
            let end = behind.max(at + 1);
            out.push_part(text, at..end);
            at = end;
        } else {
            out.push_part(text, at..at + c.len_utf8());
            at += c.len_utf8();
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{LabelChoice, LatexFile};

    fn read(text: &str, label: &str, choice: LabelChoice) -> Vec<String> {
        let paper = LatexFile::read(text).unwrap();
        let found = paper.equations(label, choice).unwrap().unwrap();
        found.into_iter().map(|formula| formula.text).collect()
    }

    #[test]
    fn lines_of_environments_are_found_by_their_labels() {
        let text = r"% \begin{equation} x = 1 \label{a} \end{equation}
            \newcommand{\be}{\begin{equation}} \def\ee{\end{equation}} \newcommand{\D}[2][t]{\frac{d #2}{d#1}}
            \be m \D{x} = 1. \label{a} \ee
            \begin{align} a &= b \nonumber \\ &\quad + c, \label{b} \\[2pt] &= d \tag{2.1} \\ e &= 100\% f \end{align}
            \begin{equation}\label{c}\begin{split} x &= 1 \\ y &= 2\end{split}\end{equation}";
        assert_eq!(read(text, "a", LabelChoice::Labelled), [r"m \frac{d x}{dt} = 1."]);
        assert_eq!(read(text, "b", LabelChoice::Labelled), [r"a &= b &\quad + c,"]);
        assert_eq!(read(text, "2.1", LabelChoice::Labelled), ["a & &= d"]);
        assert_eq!(read(text, "2.1", LabelChoice::Display).len(), 3);
        assert_eq!(read(text, "c", LabelChoice::Labelled), ["x &= 1", "y &= 2"]);
    }

    #[test]
    fn bombs_are_refused() {
        let pair = |c: u8| format!("\\newcommand{{\\x{}}}{{\\x{1}\\x{1}}}", char::from(c), char::from(c + 1));
        let doubled: Vec<String> = (b'a'..b'y').map(pair).collect();
        let paper = LatexFile::read(&format!("{}\\[ \\xa \\label{{x}} \\]", doubled.concat())).unwrap();
        assert!(paper.equations("x", LabelChoice::Labelled).unwrap().is_err());
        for text in [
            r"\newcommand{\a}{\a}\begin{equation}\a\label{x}\end{equation}",
            r"\def\a{x\a\a}\begin{equation}\a\label{x}\end{equation}",
            r"\newcommand{\a}[1]{#1#1#1#1#1#1#1#1#1#1}\begin{equation}\a{\a{\a{\a{\a{\a{\a{x}}}}}}}\label{x}\end{equation}",
            r"\def\a#1.{x}\begin{equation}\a y.\label{x}\end{equation}",
            r"\newcommand{\a}[1]{x}\begin{equation}\label{x}\a\end{equation}",
        ] {
            let paper = LatexFile::read(text).unwrap();
            let problem = paper.equations("x", LabelChoice::Labelled).unwrap().unwrap_err();
            assert!(text[problem.place.clone()].starts_with("\\a"), "{problem:?}");
        }
        for text in
            ["\\", "\\begin{", "$$", "\\begin{align}\\\\&", "\\newcommand", "\\def\\a", "}é{\\é", "\\[\\label{x}\\]"]
        {
            let paper = LatexFile::read(text).unwrap();
            let _ = paper.equations("x", LabelChoice::Labelled);
        }
    }

    #[test]
    fn large_texts_cost_bounded_time() {
        let begun = std::time::Instant::now();
        for part in [
            "\\a",
            "{",
            "\\[",
            "\\begin{align}",
            "$$",
            "\\\\[",
            "\\label{",
            "\\\\[x\\\\]y",
            "\\newcommand\\a{",
            "\\begin{",
            "\\label{",
            "\\def\\a",
            "\\def\\a{\\a}",
            "a&\\\\",
            "%",
            "=",
        ] {
            let many = part.repeat(400_000 / part.len());
            let text = format!("\\begin{{align}}{many}\\label{{x}}\\end{{align}}");
            let found = LatexFile::read(&text).map(|paper| paper.equations("x", LabelChoice::Labelled).is_ok());
            drop(found);
        }
        assert!(begun.elapsed().as_secs() < 20, "{:?}", begun.elapsed());
    }
}
