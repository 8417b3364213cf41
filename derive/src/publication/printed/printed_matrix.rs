//! Parsing of a printed matrix in LaTeX, MATLAB, NumPy or SymPy: finds the places of its entries.

use crate::algebra::text::notation::Notation;
use std::ops::Range;

/// Byte ranges of the entries of a printed matrix, and of the factor before the matrix.
#[derive(Debug, PartialEq, Eq)]
pub struct MatrixCells {
    /// Byte ranges of the entries in the text, row by row. All rows have the same length.
    pub rows: Vec<Vec<Range<usize>>>,
    /// Byte range of the factor before the matrix; `None` if there is none.
    pub factor: Option<Range<usize>>,
}

/// Finds the entries of a printed matrix in a text. A factor may precede the matrix, and a transpose mark may follow
/// it.
///
/// # Errors
/// Reason why the text is not read as a matrix.
pub fn printed_matrix_cells(text: &str, notation: Notation) -> Result<MatrixCells, &'static str> {
    let (mut rows, around) =
        if notation == Notation::Latex { latex_matrix_cells(text)? } else { bracket_matrix_cells(text)? };
    let width = match rows.first().map(Vec::len) {
        None | Some(0) => return Err("the matrix has no entries"),
        Some(width) if rows.iter().any(|row| row.len() != width) => {
            return Err("the rows of the matrix differ in length");
        }
        Some(width) => width,
    };
    let Some(around) = around else { return Ok(MatrixCells { rows, factor: None }) };
    let (factor, is_transposed) = if notation == Notation::Latex {
        text_around_latex_matrix(text, &around)?
    } else {
        text_around_bracket_matrix(text, &around)?
    };
    if is_transposed {
        rows = (0..width).map(|column| rows.iter().map(|row| row[column].clone()).collect()).collect();
    }
    Ok(MatrixCells { rows, factor })
}

/// Factor before a LaTeX matrix environment, if any, and true if a transpose mark follows the environment. `around` is
/// the byte range of the environment. The error is a reason why the text around it is not read.
fn text_around_latex_matrix(text: &str, around: &Range<usize>) -> Result<(Option<Range<usize>>, bool), &'static str> {
    const OPENING: [&str; 12] =
        ["\\left[", "\\left(", "\\left\\{", "(", "[", "&", "\\,", "\\;", "\\:", "\\!", "\\quad", "\\qquad"];
    const CLOSING: [&str; 15] = [
        "\\right]",
        "\\right)",
        "\\right\\}",
        ")",
        "]",
        "\\,",
        "\\;",
        "\\:",
        "\\!",
        ".",
        ",",
        ";",
        "\\nonumber",
        "\\notag",
        "\\\\",
    ];
    const TRANSPOSES: [&str; 9] = [
        "^T",
        "^{T}",
        "^\\top",
        "^{\\top}",
        "^\\mathsf{T}",
        "^{\\mathsf{T}}",
        "^{\\mathsf T}",
        "^\\mathrm{T}",
        "^{\\mathrm{T}}",
    ];
    let start = text[..around.start].rfind('=').map_or(0, |at| at + 1);
    let mut front = text[start..around.start].trim_end();
    while let Some(rest) = OPENING.iter().find_map(|mark| front.strip_suffix(mark)) {
        front = rest.trim_end();
    }
    let end = start + front.len();
    let front = front.trim_start_matches(|c: char| c == '&' || c.is_whitespace());
    let factor = (!front.is_empty()).then(|| end - front.len()..end);
    let mut behind = text[around.end..].trim_start();
    let mut is_transposed = false;
    loop {
        if let Some(rest) = TRANSPOSES.iter().find_map(|mark| behind.strip_prefix(mark)) {
            (behind, is_transposed) = (rest.trim_start(), !is_transposed);
        } else if let Some(rest) = CLOSING.iter().find_map(|mark| behind.strip_prefix(mark)) {
            behind = rest.trim_start();
        } else if behind.starts_with("\\label{") {
            behind = behind.split_once('}').map_or("", |(_, rest)| rest).trim_start();
        } else if behind.is_empty() {
            return Ok((factor, is_transposed));
        } else {
            return Err("what stands behind the matrix is not read: print the matrix alone under `printed`");
        }
    }
}

/// Factor before a matrix in brackets, if any, and true if a transpose mark follows the brackets. `around` is the byte
/// range of the brackets. The error is a reason why the text around them is not read.
fn text_around_bracket_matrix(text: &str, around: &Range<usize>) -> Result<(Option<Range<usize>>, bool), &'static str> {
    let start = text[..around.start].rfind('=').map_or(0, |at| at + 1);
    let front = text[start..around.start].trim_end();
    // The text before the brackets may be the name of a function, as in `np.array(` or `vertcat(*`.
    let name = front.trim_end_matches('*');
    let is_call =
        name.ends_with('(') && name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.' | '(' | ' '));
    let factor = if front.trim().is_empty() || is_call {
        None
    } else if let Some(factor) = front.strip_suffix('*') {
        let inner = factor.trim();
        let from = start + factor.len() - factor.trim_start().len();
        (!inner.is_empty()).then(|| from..from + inner.len())
    } else {
        return Err("what stands in front of the matrix is not read: multiply it into the entries");
    };
    let mut behind = text[around.end..].trim_start();
    let mut is_transposed = false;
    loop {
        let transposed = [".transpose()", ".T", ".'", "'"].iter().find_map(|mark| behind.strip_prefix(mark));
        // A named argument may follow, as in `, dtype=float)`.
        let named = behind.strip_prefix(',').filter(|rest| rest.trim_start().starts_with(|c: char| c.is_alphabetic()));
        if let Some(rest) = transposed {
            (behind, is_transposed) = (rest.trim_start(), !is_transposed);
        } else if let Some(rest) = named {
            behind = rest.find(')').map_or("", |close| &rest[close..]);
        } else if let Some(rest) = behind.strip_prefix([')', ';', ',', '.']) {
            behind = rest.trim_start();
        } else if behind.is_empty() || behind.starts_with(['%', '#']) {
            return Ok((factor, is_transposed));
        } else {
            return Err("what stands behind the matrix is not read: write it into the entries");
        }
    }
}

/// Byte ranges of the entries, row by row, and the byte range of the matrix; `None` if the matrix is the whole text.
type Found = (Vec<Vec<Range<usize>>>, Option<Range<usize>>);

/// Finds the entries of a LaTeX environment such as bmatrix or array. Returns the byte ranges of the entries and of the
/// environment. The error is the reason why it is not read.
fn latex_matrix_cells(text: &str) -> Result<Found, &'static str> {
    let no_end = "the matrix has no `\\end{…}`";
    let begin = text
        .find("\\begin{")
        .ok_or("the matrix has no `\\begin{…}`, as in \\begin{bmatrix} a & b \\\\ c & d \\end{bmatrix}")?;
    let name_end = text[begin..].find('}').map(|at| begin + at + 1).ok_or(no_end)?;
    let end = text.rfind("\\end{").filter(|end| *end >= name_end).ok_or(no_end)?;
    let mut start = name_end;
    // The column specification of an array, such as {cc}, is not an entry.
    if text[begin..name_end].ends_with("array}") {
        let rest = &text[start..end];
        let space = rest.len() - rest.trim_start().len();
        if rest[space..].starts_with('{') {
            start += rest.find('}').ok_or(no_end)? + 1;
        }
    }
    let mut rows = vec![Vec::new()];
    let (mut open, mut from, mut at) = (0_usize, start, start);
    while at < end {
        let rest = &text[at..end];
        let step = rest.chars().next().map_or(1, char::len_utf8);
        match rest.as_bytes()[0] {
            b'{' => open += 1,
            b'}' => open = open.saturating_sub(1),
            b'\\' if rest.starts_with("\\\\") && open == 0 => {
                rows.last_mut().expect("one row at least").push(from..at);
                rows.push(Vec::new());
                at += 2;
                // The row distance, as in \\[2pt], is not an entry.
                if text[at..end].starts_with('[') {
                    at += text[at..end].find(']').map_or(0, |close| close + 1);
                }
                from = at;
                continue;
            }
            // An escaped character, such as \&, is no separator.
            b'\\' => {
                at += 1 + rest[1..].chars().next().map_or(0, char::len_utf8);
                continue;
            }
            b'&' if open == 0 => {
                rows.last_mut().expect("one row at least").push(from..at);
                from = at + 1;
            }
            _ => {}
        }
        at += step;
    }
    // A \\ after the last row begins no further row.
    let is_open_row = rows.last().is_some_and(Vec::is_empty) && text[from..end].trim().is_empty();
    if is_open_row && rows.len() > 1 {
        rows.pop();
    } else {
        rows.last_mut().expect("one row at least").push(from..end);
    }
    let whole_end = text[end..].find('}').map_or(text.len(), |close| end + close + 1);
    Ok((rows, Some(begin..whole_end)))
}

/// Finds the entries of `[a, b; c, d]`, `[a b; c d]` or `[[a, b], [c, d]]`, after any text such as `np.array(`. Returns
/// the byte ranges of the entries and of the brackets. The error is the reason why they are not read.
fn bracket_matrix_cells(text: &str) -> Result<Found, &'static str> {
    if let Some(rows) = stacked_matrix_cells(text) {
        return rows.map(|rows| (rows, None));
    }
    let open = text.find('[').ok_or("the matrix has no `[`, as in [a, b; c, d] or [[a, b], [c, d]]")?;
    let mut depth = 0_i64;
    let closes = |(_, c): &(usize, char)| {
        depth += i64::from(*c == '[') - i64::from(*c == ']');
        depth == 0
    };
    let closing = text[open..].char_indices().find(closes);
    let close = closing.map(|(at, _)| open + at).ok_or("the `[` of the matrix is never closed")?;
    let inside = open + 1..close;
    if !text[inside.clone()].trim_start().starts_with('[') {
        let rows = split_matrix_outside_brackets(text, inside, |c| c == ';' || c == '\n').into_iter();
        let rows = rows.filter(|row| !text[row.clone()].trim().is_empty()).map(|row| row_cells(text, row));
        return Ok((rows.collect(), Some(open..close + 1)));
    }
    let mut rows = Vec::new();
    for part in split_matrix_outside_brackets(text, inside, |c| c == ',') {
        let row = &text[part.clone()];
        if row.trim().is_empty() {
            continue;
        }
        let (Some(from), Some(to)) = (row.find('['), row.rfind(']')) else {
            return Err("each row of the matrix stands in brackets of its own");
        };
        rows.push(row_cells(text, part.start + from + 1..part.start + to));
    }
    Ok((rows, Some(open..close + 1)))
}

/// Finds the entries of a matrix written by `vertcat` and `horzcat`, such as `vertcat(horzcat(a,
/// b), horzcat(c, d))`.
/// Returns `None` for a text without these functions. The error is a reason why the matrix is not
/// read.
fn stacked_matrix_cells(text: &str) -> Option<Result<Vec<Vec<Range<usize>>>, &'static str>> {
    let names = ["vertcat(", "horzcat("];
    let trimmed = |range: Range<usize>| {
        let part = &text[range.clone()];
        let start = range.start + part.len() - part.trim_start().len();
        start..start + part.trim().len()
    };
    // Name and arguments of the call in a range. Names of modules before the function are skipped.
    let call = |range: Range<usize>| {
        let range = trimmed(range);
        let (at, name) = names.iter().filter_map(|name| Some((text[range.clone()].find(name)?, *name))).min()?;
        let is_module =
            text[range.start..range.start + at].chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.'));
        let inside = range.start + at + name.len()..range.end.checked_sub(1)?;
        let closes = is_module && text[range].ends_with(')') && inside.start <= inside.end;
        closes.then(|| (name, split_matrix_outside_brackets(text, inside, |c| c == ',')))
    };
    let (outer, parts) = call(0..text.len())?;
    let lists: Vec<Vec<Range<usize>>> = parts
        .into_iter()
        .filter(|part| !text[part.clone()].trim().is_empty())
        .map(|part| match call(part.clone()) {
            Some((inner, list)) if inner != outer => list,
            _ => vec![part],
        })
        .collect();
    if outer == "vertcat(" {
        return Some(Ok(lists));
    }
    let height = lists.first().map_or(0, Vec::len);
    if lists.iter().any(|column| column.len() != height) {
        return Some(Err("the columns of the matrix differ in length"));
    }
    Some(Ok((0..height).map(|row| lists.iter().map(|column| column[row].clone()).collect()).collect()))
}

/// Byte ranges of the entries of one row. Entries are separated by commas, or else by spaces as in MATLAB.
fn row_cells(text: &str, row: Range<usize>) -> Vec<Range<usize>> {
    let by_comma: Vec<Range<usize>> = split_matrix_outside_brackets(text, row.clone(), |c| c == ',')
        .into_iter()
        .filter(|cell| !text[cell.clone()].trim().is_empty())
        .collect();
    if by_comma.len() > 1 {
        return by_comma;
    }
    // As in MATLAB, `a -b` is two entries, but `a - b` and `a-b` are one.
    let mut cells: Vec<Range<usize>> = Vec::new();
    for word in
        split_matrix_outside_brackets(text, row, char::is_whitespace).into_iter().filter(|word| !word.is_empty())
    {
        let binds = |c: char| matches!(c, '+' | '-' | '*' | '/' | '^');
        let own = &text[word.clone()];
        let goes_on = cells.last().is_some_and(|cell| {
            text[cell.clone()].ends_with(binds) || own.starts_with(['*', '/', '^']) || own.chars().all(binds)
        });
        match cells.last_mut() {
            Some(cell) if goes_on => cell.end = word.end,
            _ => cells.push(word),
        }
    }
    cells
}

/// Splits a range of the text of a matrix at the separators outside of all parentheses and brackets. Returns the byte
/// ranges of the parts.
fn split_matrix_outside_brackets(text: &str, range: Range<usize>, is_mark: impl Fn(char) -> bool) -> Vec<Range<usize>> {
    let (mut parts, mut depth, mut from) = (Vec::new(), 0_usize, range.start);
    for (at, c) in text[range.clone()].char_indices() {
        let at = range.start + at;
        match c {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth = depth.saturating_sub(1),
            c if depth == 0 && is_mark(c) => {
                parts.push(from..at);
                from = at + c.len_utf8();
            }
            _ => {}
        }
    }
    parts.push(from..range.end);
    parts
}

#[cfg(test)]
mod tests {
    use super::printed_matrix_cells;
    use crate::algebra::text::notation::Notation;

    fn read(text: &str, notation: Notation) -> Result<Vec<Vec<String>>, &'static str> {
        let cells = printed_matrix_cells(text, notation)?;
        let cell = |cell: &std::ops::Range<usize>| text[cell.clone()].trim().to_owned();
        Ok(cells.rows.iter().map(|row| row.iter().map(cell).collect()).collect())
    }

    #[test]
    fn matrices_are_read_in_each_notation() {
        let expected = Ok(vec![vec!["a + b".to_owned(), "0".to_owned()], vec!["f(x, y)".to_owned(), "-c".to_owned()]]);
        for text in ["[a + b, 0; f(x, y), -c]", "[a + b 0; f(x, y) -c]", "[a + b, 0\n f(x, y), -c]"] {
            assert_eq!(read(text, Notation::Matlab), expected, "{text}");
        }
        for text in [
            "ca.vertcat(ca.horzcat(a + b, 0), ca.horzcat(f(x, y), -c))",
            "horzcat(vertcat(a + b, f(x, y)), vertcat(0, -c))",
        ] {
            assert_eq!(read(text, Notation::Python), expected, "{text}");
        }
        for text in ["np.array([[a + b, 0], [f(x, y), -c]])", "Matrix([[a + b, 0], [f(x, y), -c],])"] {
            assert_eq!(read(text, Notation::Python), expected, "{text}");
        }
        let latex = [
            r"\begin{bmatrix} a + b & 0 \\ f(x, y) & -c \end{bmatrix}",
            r"\left[\begin{array}{cc} a + b & 0 \\[2pt] f(x, y) & -c \\ \end{array}\right]",
        ];
        for text in latex {
            assert_eq!(read(text, Notation::Latex), expected, "{text}");
        }
        assert_eq!(read("[1 2; 3]", Notation::Matlab), Err("the rows of the matrix differ in length"));
        assert!(read("a, b", Notation::Python).is_err() && read("[]", Notation::Matlab).is_err());
        assert!(read(r"\begin{bmatrix} a", Notation::Latex).is_err() && read("]é[", Notation::C).is_err());
    }
    #[test]
    fn what_stands_around_a_matrix_is_not_lost() {
        let of = |text: &str, notation: Notation| {
            printed_matrix_cells(text, notation).map(|found| {
                let factor = found.factor.map(|range| text[range].to_owned());
                let rows = found
                    .rows
                    .iter()
                    .map(|row| row.iter().map(|c| text[c.clone()].trim().to_owned()).collect::<Vec<_>>());
                (factor, rows.collect::<Vec<_>>())
            })
        };
        let (latex, matlab, python) = (Notation::Latex, Notation::Matlab, Notation::Python);
        let [a, b] = ["a", "b"].map(str::to_owned);
        let (whole, turned) = (vec![vec![a.clone(), b.clone()]], vec![vec![a], vec![b]]);
        let some = |factor: &str| Some(factor.to_owned());
        for (text, factor) in [
            (r"M = \frac12 m l^2 \begin{bmatrix} a & b \end{bmatrix}, \label{eq:M}", some(r"\frac12 m l^2")),
            (r"M(q) &= \left[\begin{array}{cc} a & b \end{array}\right].", None),
            (r"-\begin{pmatrix} a & b \end{pmatrix}", some("-")),
        ] {
            assert_eq!(of(text, latex), Ok((factor, whole.clone())), "{text}");
        }
        for mark in ["^T", r"^{\mathsf{T}}", r"^\top"] {
            let text = format!(r"\begin{{bmatrix}} a & b \end{{bmatrix}}{mark}");
            assert_eq!(of(&text, latex), Ok((None, turned.clone())), "{text}");
        }
        assert_eq!(of("m*l^2*[a, b]';", matlab), Ok((some("m*l^2"), turned.clone())));
        assert_eq!(of("[a, b].';", matlab), Ok((None, turned.clone())));
        assert_eq!(
            of("M = 0.5*np.array([[a, b]], dtype=float)", python),
            Err("what stands in front of the matrix is not read: multiply it into the entries")
        );
        assert_eq!(of("M = np.array([[a, b]], dtype=float).T", python), Ok((None, turned)));
        assert!(of(r"\begin{bmatrix} a & b \end{bmatrix}, \qquad h = m l", latex).is_err());
        assert!(of(r"\begin{bmatrix} a & b \end{bmatrix} + C", latex).is_err());
        assert!(of("m*np.array([a, b])", python).is_err() && of("vertcat(*[a, b])", python).is_ok());
        assert!(of("[a, b]*m", matlab).is_err() && of("[a, b] + [c, d]", matlab).is_err());
    }
}
