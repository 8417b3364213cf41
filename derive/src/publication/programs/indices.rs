//! Indices of vectors and matrices in printed programs: what they select, and how entries are spelled.

use crate::algebra::text::notation::Notation;
use crate::publication::names::program_variables::{ArrayKind, ArrayShape};
use crate::publication::printed::comma_parts;

/// Largest number of entries that indices select.
const MOST_ENTRIES: usize = 100;

/// Byte position behind the bracket that closes the one at `open`; `None` if it is missing.
pub fn bracketed_end(text: &str, open: usize) -> Option<usize> {
    let mut depth = 0_i64;
    for (at, c) in text.get(open..)?.char_indices() {
        depth += i64::from(matches!(c, '(' | '[' | '{')) - i64::from(matches!(c, ')' | ']' | '}'));
        if depth == 0 {
            return Some(open + at + c.len_utf8());
        }
    }
    None
}

/// Closing bracket of each bracket of a text: pairs of byte positions (open, close), in the order of the closing ones.
/// Brackets of different kinds close one another, as in [`bracketed_end`].
pub fn bracket_pairs(text: &str) -> Vec<(usize, usize)> {
    let (mut open, mut pairs) = (Vec::new(), Vec::new());
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' | '{' => open.push(at),
            ')' | ']' | '}' => pairs.extend(open.pop().map(|from| (from, at))),
            _ => {}
        }
    }
    pairs
}

/// Name and indices of an indexed variable, as `M(1,2)` or `M[0][1]`; `None` for any other text.
pub fn indexed_name(text: &str) -> Option<(&str, Vec<&str>)> {
    let open = text.find(['(', '['])?;
    let name = &text[..open];
    if name.is_empty() || !name.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '.')) {
        return None;
    }
    let (mut indices, mut at) = (Vec::new(), open);
    while at < text.len() {
        if !text[at..].starts_with(['(', '[']) {
            return None;
        }
        let end = bracketed_end(text, at)?;
        let inside = &text[at + 1..end - 1];
        indices.extend(comma_parts(inside).into_iter().map(|part| inside[part].trim()));
        at = end;
    }
    (indices.len() <= 2).then_some((name, indices))
}

/// Places from 0 that an index selects along `size` entries; `None` if they cannot be told.
fn selected_places(index: &str, size: Option<usize>, notation: Notation) -> Option<Vec<usize>> {
    let is_python = notation != Notation::Matlab;
    let place = |text: &str| -> Option<usize> {
        let text = text.trim();
        if let Some(back) = text.strip_prefix("end").filter(|_| !is_python) {
            let back = back.trim();
            let back = if back.is_empty() { 0 } else { back.strip_prefix('-')?.trim().parse().ok()? };
            return size?.checked_sub(1 + back);
        }
        match text.strip_prefix('-') {
            Some(back) if is_python => size?.checked_sub(back.trim().parse().ok()?),
            Some(_) => None,
            None => text.parse::<usize>().ok()?.checked_sub(usize::from(!is_python)),
        }
    };
    let Some((first, last)) = index.split_once(':') else { return Some(vec![place(index)?]) };
    let range = match (first.trim(), last.trim(), is_python) {
        ("", "", _) => 0..size?,
        (first, last, true) => {
            let first = if first.is_empty() { 0 } else { place(first)? };
            first..if last.is_empty() { size? } else { place(last)? }
        }
        (first, last, false) => place(first)?..place(last)? + 1,
    };
    (range.len() <= MOST_ENTRIES && size.is_none_or(|size| range.end <= size)).then(|| range.collect())
}

/// Rows and columns, from 0, that indices select of an array; `None` if they cannot be told. Without
/// a known shape, one index counts rows.
pub fn selected_entries(
    indices: &[&str],
    shape: Option<ArrayShape>,
    notation: Notation,
) -> Option<(Vec<usize>, Vec<usize>)> {
    let rows = |index: &str| selected_places(index, shape.map(|shape| shape.rows), notation);
    let columns = |index: &str| selected_places(index, shape.map(|shape| shape.columns), notation);
    match (indices, shape) {
        ([row, column], _) => Some((rows(row)?, columns(column)?)),
        ([index], None | Some(ArrayShape { columns: 1, .. })) => Some((rows(index)?, vec![0])),
        ([index], Some(ArrayShape { rows: 1, kind: ArrayKind::Matrix, .. })) => Some((vec![0], columns(index)?)),
        ([index], Some(shape)) if notation == Notation::Matlab => {
            // One index counts the entries column by column.
            let [place] = selected_places(index, Some(shape.rows * shape.columns), notation)?[..] else { return None };
            Some((vec![place % shape.rows], vec![place / shape.rows]))
        }
        ([index], Some(shape)) => Some((rows(index)?, (0..shape.columns).collect())),
        _ => None,
    }
}

/// All names of the entry in `row` and `column`, from 0, of an array.
pub fn entry_names(
    name: &str,
    (row, column): (usize, usize),
    shape: Option<ArrayShape>,
    notation: Notation,
) -> Vec<String> {
    if notation == Notation::Matlab {
        let height = shape.map_or(1, |shape| shape.rows);
        let mut list = vec![format!("{name}({},{})", row + 1, column + 1)];
        // One index counts the entries column by column.
        if shape.is_some() || column == 0 {
            list.push(format!("{name}({})", column * height + row + 1));
        }
        return list;
    }
    let is_flat = shape.is_some_and(|shape| shape.kind == ArrayKind::Flat);
    let mut list = Vec::new();
    if !is_flat {
        list.extend([format!("{name}[{row},{column}]"), format!("{name}[{row}][{column}]")]);
    }
    if shape.is_none_or(|shape| shape.columns == 1) && column == 0 {
        list.push(format!("{name}[{row}]"));
    }
    if shape.is_some_and(|shape| shape.rows == 1 && shape.kind == ArrayKind::Matrix) {
        list.push(format!("{name}[{column}]"));
    }
    list
}

#[cfg(test)]
mod tests {
    use super::{entry_names, indexed_name, selected_entries};
    use crate::algebra::text::notation::Notation;
    use crate::publication::names::program_variables::{ArrayKind, ArrayShape};

    fn selected(
        name: &str,
        shape: Option<(usize, usize, ArrayKind)>,
        notation: Notation,
    ) -> Option<(Vec<usize>, Vec<usize>)> {
        let (_, indices) = indexed_name(name)?;
        selected_entries(&indices, shape.map(|(rows, columns, kind)| ArrayShape { rows, columns, kind }), notation)
    }

    #[test]
    fn indices_select_rows_and_columns() {
        let (matlab, python) = (Notation::Matlab, Notation::Python);
        let column = Some((4, 1, ArrayKind::Matrix));
        assert_eq!(selected("dz(3:4)", None, matlab), Some((vec![2, 3], vec![0])));
        assert_eq!(selected("dz(3:end)", column, matlab), Some((vec![2, 3], vec![0])));
        assert_eq!(selected("dz(end-1)", column, matlab), Some((vec![2], vec![0])));
        assert_eq!(selected("dz(3:end)", None, matlab), None);
        assert_eq!(selected("A(2,:)", Some((2, 2, ArrayKind::Matrix)), matlab), Some((vec![1], vec![0, 1])));
        assert_eq!(selected("A(3)", Some((2, 2, ArrayKind::Matrix)), matlab), Some((vec![0], vec![1])));
        assert_eq!(selected("f(i)", column, matlab), None);
        let flat = Some((4, 1, ArrayKind::Flat));
        assert_eq!(selected("z[2:]", flat, python), Some((vec![2, 3], vec![0])));
        assert_eq!(selected("z[-1]", flat, python), Some((vec![3], vec![0])));
        assert_eq!(selected("z[0:2]", None, python), Some((vec![0, 1], vec![0])));
        assert_eq!(selected("M[0][1]", None, python), Some((vec![0], vec![1])));
        assert_eq!(selected("M[1]", Some((2, 2, ArrayKind::Table)), python), Some((vec![1], vec![0, 1])));
        assert_eq!(selected("z[::2]", flat, python), None);
    }

    #[test]
    fn an_entry_has_all_its_names() {
        let shape = |rows, columns, kind| Some(ArrayShape { rows, columns, kind });
        assert_eq!(entry_names("A", (0, 1), shape(2, 2, ArrayKind::Matrix), Notation::Matlab), ["A(1,2)", "A(3)"]);
        assert_eq!(entry_names("f", (1, 0), None, Notation::Matlab), ["f(2,1)", "f(2)"]);
        assert_eq!(entry_names("f", (1, 0), shape(2, 1, ArrayKind::Flat), Notation::Python), ["f[1]"]);
        assert_eq!(entry_names("M", (0, 1), shape(2, 2, ArrayKind::Table), Notation::Python), ["M[0,1]", "M[0][1]"]);
    }
}
