//! Solutions of linear systems in printed programs, as in `M\f` or `np.linalg.solve(M, f)`.

use super::assignments::names_of_assigned_entries;
use crate::algebra::Expr;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::text::notation::Notation;
use crate::publication::names::program_variables::{LinearSolution, ProgramValue};
use crate::publication::publication_reader::PublicationReader;
use crate::toml_reader::Located;
use std::ops::Range;
use std::sync::Arc;

/// Largest number of unknowns of a linear system in a program.
const MOST_UNKNOWNS: usize = 8;
/// Functions with two arguments, A and b, that solve A x = b.
const SOLVERS: [&str; 4] = ["linsolve", "mldivide", "solve", "lstsq"];
/// Functions that invert a matrix.
const INVERSES: [&str; 2] = ["inv", "pinv"];

/// Byte ranges of A and b in a formula that solves A x = b; `None` for any other formula.
///
/// # Examples
/// `M\f`, `linsolve(M, f)`, `np.linalg.solve(M, f)`, `inv(M)*f`, `np.linalg.inv(M) @ f`,
/// `np.linalg.inv(M).dot(f)`
fn linear_system_operands(text: &str) -> Option<(Range<usize>, Range<usize>)> {
    let start = text.len() - text.trim_start().len();
    let end = text.trim_end().trim_end_matches(';').trim_end().len();
    if let Some(at) = text[start..end].find('\\') {
        return Some((start..start + at, start + at + 1..end));
    }
    let open = start + text.get(start..end)?.find('(')?;
    let close = closing_parenthesis(text, open)?;
    let function = text[start..open].rsplit('.').next()?.trim();
    if SOLVERS.contains(&function) && close + 1 == end {
        let comma = open + text[open..close].find(',')?;
        return Some((open + 1..comma, comma + 1..close));
    }
    if !INVERSES.contains(&function) {
        return None;
    }
    let behind = &text[close + 1..end];
    let space = behind.len() - behind.trim_start().len();
    let first = close + 1 + space;
    if behind.trim_start().starts_with(['*', '@']) {
        return Some((open + 1..close, first + 1..end));
    }
    let dot = ".dot(";
    let inside = first + dot.len();
    (behind.trim_start().starts_with(dot) && closing_parenthesis(text, inside - 1)? + 1 == end)
        .then_some((open + 1..close, inside..end - 1))
}

/// Byte position of the parenthesis that closes the one at `open`; `None` if it is missing.
fn closing_parenthesis(text: &str, open: usize) -> Option<usize> {
    let mut depth = 0_i64;
    let found = text[open..].bytes().position(|c| {
        depth += i64::from(c == b'(') - i64::from(c == b')');
        depth == 0
    });
    found.map(|at| open + at)
}

impl PublicationReader<'_, '_> {
    /// Assigns the solution x of A x = b to a vector, or to a range of its entries. Returns false if
    /// the formula is no such solution, or if A and b are not known entry by entry.
    pub(in crate::publication) fn assign_linear_solution(
        &mut self,
        name: &str,
        formula: &Located,
        notation: Notation,
    ) -> bool {
        let Some((a, b)) = linear_system_operands(&formula.text) else { return false };
        let mut entries = |range: Range<usize>, place: &str| {
            let whole = formula.text[range.clone()].trim().to_owned();
            if !self.words.locals.entries(&whole).is_empty() {
                return Some(whole);
            }
            let part = Located {
                text: formula.text[range.clone()].to_owned(),
                span: formula.part(range),
                exact: formula.exact,
            };
            let own = format!("{place} of {name}");
            self.assign_vector_entries(&own, &part, notation).then_some(own)
        };
        let (Some(a), Some(b)) = (entries(a, "matrix"), entries(b, "vector")) else { return false };
        let Some(solution) = self.solved_system(&a, &b, notation) else { return false };
        let Some(names) = names_of_assigned_entries(name, solution.values.len(), notation) else { return false };
        for (name, value) in names.iter().zip(&solution.values) {
            self.assign_program_value(name, ProgramValue::Value(*value));
        }
        if let Some(locals) = Arc::get_mut(&mut self.words.locals) {
            locals.record_linear_solution(solution);
        }
        true
    }

    /// Solution of A x = b for a matrix and a vector of the program; `None` if an entry is not known,
    /// or if A is singular or too large.
    fn solved_system(&mut self, a: &str, b: &str, notation: Notation) -> Option<LinearSolution> {
        let first = usize::from(notation == Notation::Matlab);
        let value = |name: String| {
            let locals = &self.words.locals;
            match locals.value(locals.variable_number(&name)?)? {
                ProgramValue::Value(e) => Some(*e),
                ProgramValue::Unread(_) => None,
            }
        };
        let entry = |i: usize| {
            let i = i + first;
            value(if notation == Notation::Matlab { format!("{b}({i})") } else { format!("{b}[{i}]") })
        };
        let right: Vec<Expr> = (0..=MOST_UNKNOWNS).map_while(entry).collect();
        let n = right.len();
        if !(1..=MOST_UNKNOWNS).contains(&n) {
            return None;
        }
        let name = |i: usize, k: usize| {
            let (i, k) = (i + first, k + first);
            if notation == Notation::Matlab { format!("{a}({i},{k})") } else { format!("{a}[{i},{k}]") }
        };
        // A larger matrix has other rows and columns.
        if value(name(n, 0)).is_some() || value(name(0, n)).is_some() {
            return None;
        }
        let matrix: Option<Vec<Vec<Expr>>> = (0..n).map(|i| (0..n).map(|k| value(name(i, k))).collect()).collect();
        let matrix = matrix?;
        let columns: Vec<Vec<Expr>> = right.iter().map(|e| vec![*e]).collect();
        let (values, _) = solve_linear(&mut self.model.arena, &mut Simplifier::default(), &matrix, &columns).ok()?;
        Some(LinearSolution { values: values.into_iter().map(|row| row[0]).collect(), matrix, right })
    }
}

#[cfg(test)]
mod tests {
    use super::linear_system_operands;

    #[test]
    fn a_solution_of_a_linear_system_is_recognised() {
        let parts = |text: &'static str| linear_system_operands(text).map(|(a, b)| (text[a].trim(), text[b].trim()));
        for text in [
            "M\\f;",
            " M \\ f",
            "linsolve(M, f)",
            "np.linalg.solve(M, f)",
            "inv(M)*f",
            "np.linalg.inv(M) @ f",
            "np.linalg.inv(M).dot(f)",
        ] {
            assert_eq!(parts(text), Some(("M", "f")), "{text}");
        }
        for text in ["", "M", "sin(M)*f", "inv(M", "inv(M)", "solve(M)", "f*inv(M)", "np.linalg.inv(M).dot(f) + 1"] {
            assert_eq!(parts(text), None, "{text}");
        }
    }
}
