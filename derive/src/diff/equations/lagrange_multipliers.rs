//! Lagrange multipliers of printed equations, whose names, signs and sizes are the author's choice.
//!
//! With λ = B μ, Aᵀλ = Aᵀ B μ. So equations of motion with the author's μ are equivalent to those
//! with the derived λ, for every regular matrix B. Printed rows that agree with derived rows,
//! except in their multipliers, determine B. B is used if it explains more rows than λ = μ does.
//! One B holds for all entries of a publication.

use super::derived_system::DerivedSystem;
use super::row_judgement::{Row, TermTools, WRITTEN, judged_row_in_permitted_states, row_combination};
use super::row_matching::matching_row_with_factor;
use crate::algebra::solve::linear::{determinant, solve_linear};
use crate::algebra::text::print::print_text;
use crate::algebra::value::rank::{independent_rows, pivot_rows_and_columns};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr};
use crate::model::Model;
use std::cmp::Reverse;

/// Largest number of choices of rows from which a matrix B is computed.
const MOST_CHOICES: usize = 50;

/// Multipliers' coefficients in a printed row, and in derived rows that agree with it in all other
/// coefficients.
#[derive(Clone)]
struct MultiplierRows {
    /// Coefficients of the derived multipliers λ in the multiple or combination of derived rows.
    derived: Row,
    /// Coefficients of the printed multipliers μ in the printed row.
    printed: Row,
    /// True if every derived row in the combination has the factor 1.
    is_plain: bool,
}

/// Multipliers of a publication: coefficients collected from its entries, and the matrix B (λ = B
/// μ) that explains most.
#[derive(Default)]
pub struct Multipliers {
    /// Coefficients of printed and derived multipliers, from all entries so far.
    pairs: Vec<MultiplierRows>,
    /// Number of entries that mention multipliers.
    entries: usize,
    /// Printed rows with multipliers of all systems that are compared with the derived rows of the
    /// first such system.
    printed: Option<PrintedRows>,
    /// Matrix B chosen for all entries; `None` before the choice.
    decided: Option<Vec<Row>>,
}

/// Printed rows with multipliers of systems that are compared with the same derived rows.
struct PrintedRows {
    /// Derived rows, in the derived multipliers.
    order: DerivedSystem,
    /// Printed rows that mention multipliers.
    rows: Vec<Row>,
    /// Columns of the multipliers.
    columns: Vec<usize>,
}

impl Multipliers {
    /// Chooses one matrix B for all entries if at least two mention multipliers. Returns true if B
    /// was chosen.
    pub fn choose_multiplier_matrix(&mut self, terms: &mut TermTools<'_>, model: &Model) -> bool {
        if self.entries < 2 {
            return false;
        }
        if let Some(width) = self.pairs.first().map(|pair| pair.printed.len()) {
            let pairs: Vec<MultiplierRows> =
                self.pairs.iter().filter(|pair| pair.printed.len() == width).cloned().collect();
            self.decided = Some(terms.best_multiplier_matrix(&pairs, width, &model.p()).1);
        }
        if let Some(PrintedRows { order, rows, columns }) = &self.printed {
            let own = self.decided.clone().unwrap_or_else(|| unit_multiplier_matrix(columns.len()));
            let follow = terms.rows_that_follow(order, rows, columns, &own).len();
            if follow < rows.len()
                && let Some(found) = terms.multipliers_of_motion(order, rows, columns, &fixed_symbols(model), follow)
            {
                self.decided = Some(found.matrix);
            }
        }
        self.decided.is_some()
    }
}

/// Form of a matrix B, the plainest first. If several matrices explain the same number of rows, the
/// plainest is chosen.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Form {
    /// The unit matrix: the printed multipliers are the derived ones, λ = μ.
    Derived,
    /// All entries of the matrix are numbers.
    Numbers,
    /// All entries of the matrix are terms in parameters.
    Parameters,
    /// Entries depend on the state, and the determinant is 1 or −1, as for a rotation matrix.
    Turning,
    /// Matrix B of any form not listed before.
    Other,
}

/// Score of a matrix B: the higher it is, the better B explains the printed multipliers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Score {
    /// Number of row pairs that the matrix explains.
    explained: usize,
    /// Number of explained row pairs whose derived rows have the factor 1.
    plain: usize,
    /// Form of the matrix, reversed so that a plainer form gives a higher score.
    form: Reverse<Form>,
}

impl TermTools<'_> {
    /// Rewrites the derived rows in the printed multipliers, and returns a description of the
    /// printed multipliers.
    /// `known` holds the multipliers found in the publication so far. Returns `None` if the printed
    /// multipliers equal the derived ones, or if the rows mention none.
    pub fn adapt_to_printed_multipliers(
        &mut self,
        order: &mut DerivedSystem,
        printed: &[Row],
        model: &Model,
        known: &mut Multipliers,
    ) -> Option<String> {
        let parameters = &model.p();
        let multipliers: Vec<Expr> = model.motion_constraints.iter().map(|one| one.multiplier).collect();
        let at = |m: &Expr| order.unknowns.iter().position(|u| u == m);
        let columns: Vec<usize> = multipliers.iter().filter_map(at).collect();
        let width = columns.len();
        if columns.is_empty() {
            return None;
        }
        let mentions = |row: &Row| columns.iter().any(|c| row[*c] != Expr::ZERO);
        let is_mentioned = printed.iter().any(mentions);
        let pairs = self.multiplier_rows(order, printed, &columns);
        let decided = known.decided.clone().filter(|decided| decided.len() == width);
        let change = match decided {
            Some(decided) => {
                // Another part of the publication may define its multipliers anew, if all its rows agree on them.
                let count = if pairs.len() > width {
                    self.count_explained_multiplier_rows(&pairs, &decided)
                } else {
                    pairs.len()
                };
                let own = (count < pairs.len()).then(|| self.best_multiplier_matrix(&pairs, width, parameters));
                own.filter(|(score, _)| score.explained == pairs.len()).map_or(decided, |(_, change)| change)
            }
            None if is_mentioned => self.best_multiplier_matrix(&pairs, width, parameters).1,
            None => unit_multiplier_matrix(width),
        };
        let is_first = known.decided.is_none();
        if is_mentioned && is_first {
            known.entries += 1;
            known.pairs.extend(pairs);
            let own = known.printed.get_or_insert_with(|| PrintedRows {
                order: order.clone(),
                rows: Vec::new(),
                columns: columns.clone(),
            });
            if own.order.unknowns == order.unknowns && own.order.rows == order.rows {
                own.rows.extend(printed.iter().filter(|row| mentions(row)).cloned());
            }
        }
        let count = printed.iter().filter(|row| mentions(row)).count();
        let follow = self.rows_that_follow(order, printed, &columns, &change).len();
        if follow < count
            && is_first
            && let Some(found) = self.multipliers_of_motion(order, printed, &columns, &fixed_symbols(model), follow)
        {
            self.replace_multipliers(order, &columns, &found.matrix);
            return Some(found.words);
        }
        if change == unit_multiplier_matrix(width) {
            return None;
        }
        self.replace_multipliers(order, &columns, &change);
        is_mentioned.then(|| self.multiplier_words(order, &columns, &change))
    }

    /// Replaces the derived multipliers λ in the derived rows by B μ, with the matrix B `change`.
    fn replace_multipliers(&mut self, order: &mut DerivedSystem, columns: &[usize], change: &[Row]) {
        for row in &mut order.rows {
            let before: Vec<Expr> = columns.iter().map(|c| row[*c]).collect();
            for (column, value) in columns.iter().zip(self.row_times_matrix(&before, change)) {
                row[*column] = value;
            }
        }
    }

    /// Matrix B, `width` × `width`, that explains most row pairs, with its score; the plainest if
    /// several explain as many.
    /// Diagonal matrices are tried first, and full matrices only if a pair stays unexplained.
    fn best_multiplier_matrix(
        &mut self,
        pairs: &[MultiplierRows],
        width: usize,
        parameters: &[Expr],
    ) -> (Score, Vec<Row>) {
        let as_derived = unit_multiplier_matrix(width);
        let mut best = (self.multiplier_matrix_score(pairs, &as_derived, Form::Derived), as_derived);
        let mut scaled: Vec<Vec<Row>> =
            (0..pairs.len()).filter_map(|first| self.diagonal_multiplier_matrix(pairs, first, width)).collect();
        scaled.dedup();
        for change in scaled.into_iter().take(MOST_CHOICES) {
            self.keep_better_matrix(&mut best, change, pairs, parameters);
        }
        if best.0.explained < pairs.len() {
            for chosen in multiplier_row_subsets(pairs.len(), width) {
                let chosen: Vec<&MultiplierRows> = chosen.iter().map(|at| &pairs[*at]).collect();
                if let Some(change) = self.solve_multiplier_matrix(&chosen) {
                    self.keep_better_matrix(&mut best, change, pairs, parameters);
                }
            }
        }
        best
    }

    /// Replaces the best matrix by the matrix `change` if `change` has a higher score.
    fn keep_better_matrix(
        &mut self,
        best: &mut (Score, Vec<Row>),
        change: Vec<Row>,
        pairs: &[MultiplierRows],
        parameters: &[Expr],
    ) {
        let form = self.multiplier_matrix_form(&change, parameters);
        // Axes that are neither perpendicular nor of unit length are nobody's choice, unless all rows agree on them.
        if form == Form::Other && !self.are_multipliers_told_twice(pairs) {
            return;
        }
        let score = self.multiplier_matrix_score(pairs, &change, form);
        if score > best.0 {
            *best = (score, change);
        }
    }

    /// True if the printed rows determine the multipliers that they mention also without any one row.
    fn are_multipliers_told_twice(&self, pairs: &[MultiplierRows]) -> bool {
        let width = pairs.first().map_or(0, |pair| pair.printed.len());
        let mentioned = (0..width).filter(|at| pairs.iter().any(|pair| pair.printed[*at] != Expr::ZERO)).count();
        (0..pairs.len()).all(|left_out| {
            let others = pairs.iter().enumerate().filter(|(at, _)| *at != left_out);
            let rows: Vec<Row> = others.map(|(_, pair)| pair.printed.clone()).collect();
            !rows.is_empty() && independent_rows(self.arena, &rows).is_some_and(|found| found.len() == mentioned)
        })
    }

    /// Score of the matrix B `change`, whose form is `form`.
    fn multiplier_matrix_score(&mut self, pairs: &[MultiplierRows], change: &[Row], form: Form) -> Score {
        let explained: Vec<&MultiplierRows> =
            pairs.iter().filter(|pair| self.explains_multiplier_row(pair, change)).collect();
        let plain = explained.iter().filter(|pair| pair.is_plain).count();
        Score { explained: explained.len(), plain, form: Reverse(form) }
    }

    /// Diagonal matrix B in which each multiplier has its own factor, read from the first pair that
    /// contains the multiplier.
    /// The pair `first` is read before all others. Returns `None` if this pair shows that the
    /// multipliers are mixed.
    fn diagonal_multiplier_matrix(&mut self, pairs: &[MultiplierRows], first: usize, width: usize) -> Option<Vec<Row>> {
        let mut change = unit_multiplier_matrix(width);
        let mut known = vec![false; width];
        let order = std::iter::once(first).chain((0..pairs.len()).filter(|at| *at != first));
        for at in order {
            let pair = &pairs[at];
            let is_present = |row: &Row, column: usize| row[column] != Expr::ZERO;
            if (0..width).any(|column| is_present(&pair.derived, column) != is_present(&pair.printed, column)) {
                if at == first {
                    return None;
                }
                continue;
            }
            for column in 0..width {
                if known[column] || !is_present(&pair.derived, column) {
                    continue;
                }
                let factor = self.arena.div(pair.printed[column], pair.derived[column])?;
                change[column][column] = self.simplifier.simplify(self.arena, factor);
                known[column] = true;
            }
        }
        Some(change)
    }

    /// Coefficients of multipliers in each printed row that agrees with derived rows in all other
    /// coefficients.
    fn multiplier_rows(&mut self, order: &DerivedSystem, printed: &[Row], columns: &[usize]) -> Vec<MultiplierRows> {
        let without = |row: &Row| {
            let mut row = row.clone();
            for c in columns {
                row[*c] = Expr::ZERO;
            }
            row
        };
        let of = |row: &Row| columns.iter().map(|c| row[*c]).collect::<Row>();
        let derived: Vec<Row> = order
            .rows
            .iter()
            .map(|row| judged_row_in_permitted_states(self.arena, self.comparer, &without(row)))
            .collect();
        let mut list = Vec::new();
        for (index, row) in printed.iter().enumerate() {
            let row_seen = judged_row_in_permitted_states(self.arena, self.comparer, &without(row));
            let factors = if let Some((at, column)) = matching_row_with_factor(self.arena, &row_seen, &derived, index) {
                let Some(factor) = self.arena.div(row[column], order.rows[at][column]) else { continue };
                let mut factors = vec![Expr::ZERO; derived.len()];
                factors[at] = factor;
                factors
            } else {
                // Constraints have no multipliers, and more rows than unknowns have no unique combination.
                let mut chosen: Vec<usize> = (0..derived.len() - columns.len()).collect();
                if chosen.len() > WRITTEN {
                    let width = row_seen.len() - 1;
                    let within = |other: &Row| {
                        (0..width).all(|column| other[column] == Expr::ZERO || row_seen[column] != Expr::ZERO)
                    };
                    chosen.retain(|at| within(&derived[*at]));
                }
                let equations: Vec<Row> = chosen.iter().map(|at| derived[*at].clone()).collect();
                let TermTools { arena, simplifier, comparer } = self;
                match row_combination(arena, simplifier, comparer, &row_seen, &equations) {
                    Ok(Some(found)) if found.len() == equations.len() => {
                        let mut factors = vec![Expr::ZERO; derived.len()];
                        chosen.iter().zip(found).for_each(|(at, factor)| factors[*at] = factor);
                        factors
                    }
                    _ => continue,
                }
            };
            let is_plain = factors.iter().all(|factor| matches!(*factor, Expr::ZERO | Expr::ONE));
            let mut sums = vec![Vec::new(); columns.len()];
            for (factor, row) in factors.iter().zip(&order.rows).filter(|(factor, _)| **factor != Expr::ZERO) {
                for (sum, entry) in sums.iter_mut().zip(of(row)) {
                    sum.push(self.arena.mul(*factor, entry));
                }
            }
            let scaled: Row = sums.iter().map(|sum| self.arena.sum(sum)).collect();
            let scaled: Row = scaled.into_iter().map(|e| self.simplifier.simplify(self.arena, e)).collect();
            if scaled.iter().any(|e| *e != Expr::ZERO) {
                list.push(MultiplierRows { derived: scaled, printed: of(row), is_plain });
            }
        }
        list
    }

    /// Form of a matrix B: numbers, parameters, rotation-like, or other.
    fn multiplier_matrix_form(&mut self, change: &[Row], parameters: &[Expr]) -> Form {
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
            if matches!(regular, Expr::ONE | Expr::MINUS_ONE) { Form::Turning } else { Form::Other }
        }
    }

    /// Solves derived · B = printed for the matrix B, from as many pairs as there are multipliers.
    /// Returns `None` if the pairs do not determine B, or if B is not regular.
    fn solve_multiplier_matrix(&mut self, pairs: &[&MultiplierRows]) -> Option<Vec<Row>> {
        let rows: Vec<Row> =
            pairs.iter().map(|pair| judged_row_in_permitted_states(self.arena, self.comparer, &pair.derived)).collect();
        let (independent, _) = pivot_rows_and_columns(self.arena, &rows)?;
        if independent.len() < pairs.len() {
            return None;
        }
        let of = |part: fn(&MultiplierRows) -> &Row| pairs.iter().map(|pair| part(pair).clone()).collect::<Vec<_>>();
        let (a, b) = (of(|pair| &pair.derived), of(|pair| &pair.printed));
        let (change, _) = solve_linear(self.arena, self.simplifier, &a, &b).ok()?;
        let regular = determinant(self.arena, self.simplifier, &change);
        (zero_test(self.arena, regular) == ZeroTest::NonZero).then_some(change)
    }

    /// Number of pairs for which derived · B = printed, with B = `change`.
    fn count_explained_multiplier_rows(&mut self, pairs: &[MultiplierRows], change: &[Row]) -> usize {
        pairs.iter().filter(|pair| self.explains_multiplier_row(pair, change)).count()
    }

    /// True if derived · B = printed for a pair, with B = `change`.
    fn explains_multiplier_row(&mut self, pair: &MultiplierRows, change: &[Row]) -> bool {
        let expected = self.row_times_matrix(&pair.derived, change);
        let mut same = |(a, b): (&Expr, &Expr)| self.comparer.compare(self.arena, *a, *b).is_equal();
        expected.iter().zip(&pair.printed).all(&mut same)
    }

    /// Product of a row and a square matrix, simplified.
    pub(super) fn row_times_matrix(&mut self, row: &[Expr], matrix: &[Row]) -> Row {
        let mut result = Vec::new();
        for column in 0..matrix.len() {
            let products: Vec<Expr> =
                row.iter().zip(matrix).map(|(e, line)| self.arena.mul(*e, line[column])).collect();
            let sum = self.arena.sum(&products);
            result.push(self.simplifier.simplify(self.arena, sum));
        }
        result
    }

    /// Describes the printed multipliers: each derived multiplier as a sum of the printed ones.
    fn multiplier_words(&mut self, order: &DerivedSystem, columns: &[usize], change: &[Row]) -> String {
        let mut list = Vec::new();
        for (row, line) in columns.iter().zip(change) {
            let own: Vec<Expr> = columns.iter().map(|c| order.unknowns[*c]).collect();
            let terms: Vec<Expr> = line.iter().zip(own).map(|(k, m)| self.arena.mul(*k, m)).collect();
            let sum = self.arena.sum(&terms);
            // A multiplier that the author uses exactly as derived needs no mention.
            if sum == order.unknowns[*row] {
                continue;
            }
            let name = print_text(self.arena, order.unknowns[*row]);
            list.push(format!("with the printed values, the derived {name} is {}", print_text(self.arena, sum)));
        }
        format!("multipliers of its own: {}", list.join(", "))
    }
}

/// Coordinates and parameters of a model that are no inputs: symbols that a matrix B may contain.
fn fixed_symbols(model: &Model) -> Vec<Expr> {
    let constants = model.parameters.iter().filter(|parameter| !parameter.is_input).map(|parameter| parameter.symbol);
    model.q().into_iter().chain(constants).collect()
}

/// Subsets of `size` of the indices below `count`, each in ascending order; at most 50.
pub(super) fn multiplier_row_subsets(count: usize, size: usize) -> Vec<Vec<usize>> {
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

/// Unit matrix as terms, n × n.
pub(super) fn unit_multiplier_matrix(n: usize) -> Vec<Row> {
    (0..n).map(|i| (0..n).map(|k| if i == k { Expr::ONE } else { Expr::ZERO }).collect()).collect()
}
