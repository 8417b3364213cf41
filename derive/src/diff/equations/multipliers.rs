//! Multipliers of printed equations, whose names, signs and sizes are the author's choice.
//!
//! Aᵀλ = Aᵀ B μ for λ = B μ. Equations of motion with μ are equivalent to those with λ for every regular B. Rows that
//! agree with the derived rows, or with combinations of these, up to their multipliers determine B. B is used if it
//! explains more rows than λ = μ does, and holds for later entries of the publication too.

use super::derived_system::Ordered;
use super::matching::explained;
use super::rows::{Row, Terms, combination, seen};
use crate::algebra::solve::linear::{determinant, solve};
use crate::algebra::text::print::text;
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::algebra::value::rank::echelon;
use crate::algebra::{Arena, Expr};

/// Most choices of rows that determine multipliers.
const MOST_CHOICES: usize = 50;

/// Coefficients of the multipliers in a printed row, and in the multiple or the combination of derived rows that agrees
/// with it in all other coefficients.
struct Pair {
    derived: Row,
    printed: Row,
}

/// Form of a matrix B, the plainest first. Of matrices that explain the same number of rows the plainest is meant.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Form {
    /// λ = μ, or the matrix of earlier entries.
    Known,
    /// All entries are numbers.
    Numbers,
    /// All entries are parameters and numbers.
    Parameters,
    /// Entries depend on the state, and the determinant does not: B is regular everywhere.
    Turning,
    /// The determinant depends on the state.
    Other,
}

impl Terms<'_> {
    /// Writes the derived rows with the printed multipliers, and describes these in words. `known` is the matrix B of
    /// earlier entries, and becomes that of these rows. `None` if the printed multipliers are the derived ones.
    pub fn adapt(
        &mut self,
        order: &mut Ordered,
        printed: &[Row],
        multipliers: &[Expr],
        parameters: &[Expr],
        known: &mut Option<Vec<Row>>,
    ) -> Option<String> {
        let at = |m: &Expr| order.unknowns.iter().position(|u| u == m);
        let columns: Vec<usize> = multipliers.iter().filter_map(at).collect();
        if columns.is_empty() {
            return None;
        }
        let pairs = self.pairs(order, printed, &columns);
        let as_derived = unit(columns.len());
        let mut best = (self.explained(&pairs, &as_derived), Form::Known, as_derived.clone());
        if let Some(known) = known.as_ref().filter(|known| known.len() == columns.len()) {
            let count = self.explained(&pairs, known);
            if count >= best.0 {
                best = (count, Form::Known, known.clone());
            }
        }
        let mentions = |row: &Row| columns.iter().any(|c| row[*c] != Expr::ZERO);
        if best.0 < pairs.len() && printed.iter().any(mentions) {
            for chosen in choices(pairs.len(), columns.len()) {
                let Some(change) = self.change(&chosen.iter().map(|at| &pairs[*at]).collect::<Vec<_>>()) else {
                    continue;
                };
                let count = self.explained(&pairs, &change);
                if count < best.0 {
                    continue;
                }
                let form = self.form(&change, parameters);
                if count > best.0 || form < best.1 {
                    best = (count, form, change);
                }
            }
        }
        let change = best.2;
        if change == as_derived {
            return None;
        }
        for row in &mut order.rows {
            let before: Vec<Expr> = columns.iter().map(|c| row[*c]).collect();
            for (column, value) in columns.iter().zip(self.times(&before, &change)) {
                row[*column] = value;
            }
        }
        let words = self.words(order, &columns, &change);
        *known = Some(change);
        printed.iter().any(mentions).then_some(words)
    }

    /// Coefficients of the multipliers in the printed rows that agree with derived rows, or with combinations of these,
    /// up to their multipliers.
    fn pairs(&mut self, order: &Ordered, printed: &[Row], columns: &[usize]) -> Vec<Pair> {
        let without = |row: &Row| {
            let mut row = row.clone();
            for c in columns {
                row[*c] = Expr::ZERO;
            }
            row
        };
        let of = |row: &Row| columns.iter().map(|c| row[*c]).collect::<Row>();
        let derived: Vec<Row> = order.rows.iter().map(|row| seen(self.arena, self.comparer, &without(row))).collect();
        let mut list = Vec::new();
        for (index, row) in printed.iter().enumerate() {
            let row_seen = seen(self.arena, self.comparer, &without(row));
            let factors = if let Some((at, column)) = explained(self.arena, &row_seen, &derived, index) {
                let Some(factor) = self.arena.div(row[column], order.rows[at][column]) else { continue };
                let mut factors = vec![Expr::ZERO; derived.len()];
                factors[at] = factor;
                factors
            } else {
                // Constraints have no multipliers, and more rows than unknowns have no unique combination.
                let equations = &derived[..derived.len() - columns.len()];
                let Terms { arena, simplifier, comparer } = self;
                match combination(arena, simplifier, comparer, &row_seen, equations) {
                    Ok(Some(factors)) if factors.len() == equations.len() => factors,
                    _ => continue,
                }
            };
            let mut sums = vec![Vec::new(); columns.len()];
            for (factor, row) in factors.iter().zip(&order.rows).filter(|(factor, _)| **factor != Expr::ZERO) {
                for (sum, entry) in sums.iter_mut().zip(of(row)) {
                    sum.push(self.arena.mul(*factor, entry));
                }
            }
            let scaled: Row = sums.iter().map(|sum| self.arena.sum(sum)).collect();
            let scaled: Row = scaled.into_iter().map(|e| self.simplifier.simplify(self.arena, e)).collect();
            if scaled.iter().any(|e| *e != Expr::ZERO) {
                list.push(Pair { derived: scaled, printed: of(row) });
            }
        }
        list
    }

    fn form(&mut self, change: &[Row], parameters: &[Expr]) -> Form {
        let arena = &mut *self.arena;
        let is_fixed = |arena: &Arena, e: Expr| {
            arena.reachable(&[e]).iter().all(|part| arena.symbol_name(*part).is_none() || parameters.contains(part))
        };
        if change.iter().flatten().all(|e| arena.as_number(*e).is_some()) {
            Form::Numbers
        } else if change.iter().flatten().all(|e| is_fixed(arena, *e)) {
            Form::Parameters
        } else {
            let regular = determinant(arena, self.simplifier, change);
            let regular = self.simplifier.simplify(arena, regular);
            if is_fixed(arena, regular) { Form::Turning } else { Form::Other }
        }
    }

    /// Matrix B with derived · B = printed for as many pairs as there are multipliers. `None` if it is not determined,
    /// or not regular.
    fn change(&mut self, pairs: &[&Pair]) -> Option<Vec<Row>> {
        let rows: Vec<Row> = pairs.iter().map(|pair| seen(self.arena, self.comparer, &pair.derived)).collect();
        let (independent, _) = echelon(self.arena, &rows)?;
        if independent.len() < pairs.len() {
            return None;
        }
        let of = |part: fn(&Pair) -> &Row| pairs.iter().map(|pair| part(pair).clone()).collect::<Vec<_>>();
        let (a, b) = (of(|pair| &pair.derived), of(|pair| &pair.printed));
        let (change, _) = solve(self.arena, self.simplifier, &a, &b).ok()?;
        let regular = determinant(self.arena, self.simplifier, &change);
        (zero_test(self.arena, regular) == ZeroTest::NonZero).then_some(change)
    }

    /// Number of pairs that agree if the printed multipliers are those of the matrix B, `change`.
    fn explained(&mut self, pairs: &[Pair], change: &[Row]) -> usize {
        let mut count = 0;
        for pair in pairs {
            let expected = self.times(&pair.derived, change);
            let mut same = |(a, b): (&Expr, &Expr)| self.comparer.compare(self.arena, *a, *b).is_equal();
            count += usize::from(expected.iter().zip(&pair.printed).all(&mut same));
        }
        count
    }

    fn times(&mut self, row: &[Expr], matrix: &[Row]) -> Row {
        let mut result = Vec::new();
        for column in 0..matrix.len() {
            let products: Vec<Expr> =
                row.iter().zip(matrix).map(|(e, line)| self.arena.mul(*e, line[column])).collect();
            let sum = self.arena.sum(&products);
            result.push(self.simplifier.simplify(self.arena, sum));
        }
        result
    }

    fn words(&mut self, order: &Ordered, columns: &[usize], change: &[Row]) -> String {
        let mut list = Vec::new();
        for (row, line) in columns.iter().zip(change) {
            let own: Vec<Expr> = columns.iter().map(|c| order.unknowns[*c]).collect();
            let terms: Vec<Expr> = line.iter().zip(own).map(|(k, m)| self.arena.mul(*k, m)).collect();
            let sum = self.arena.sum(&terms);
            let name = text(self.arena, order.unknowns[*row]);
            list.push(format!("with the printed values, the derived {name} is {}", text(self.arena, sum)));
        }
        format!("multipliers of its own: {}", list.join(", "))
    }
}

/// Choices of `size` out of `count` indices, in ascending order; the first ones if there are many.
fn choices(count: usize, size: usize) -> Vec<Vec<usize>> {
    let mut list: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..size {
        let longer = |chosen: &Vec<usize>| {
            let next = chosen.last().map_or(0, |last| last + 1);
            (next..count).map(|at| [&chosen[..], &[at]].concat()).collect::<Vec<_>>()
        };
        list = list.iter().flat_map(longer).collect();
        list.truncate(MOST_CHOICES);
    }
    list
}

fn unit(n: usize) -> Vec<Row> {
    (0..n).map(|i| (0..n).map(|k| if i == k { Expr::ONE } else { Expr::ZERO }).collect()).collect()
}
