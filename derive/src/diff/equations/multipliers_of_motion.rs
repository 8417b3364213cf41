//! Lagrange multipliers of printed equations into which the author has already inserted the constraints.
//!
//! In such equations, no comparison of coefficients tells which derived rows a printed row combines. The motion does.
//! With the derived accelerations a and multipliers λ of a state, printed rows P a + Q μ = r give the author's
//! multipliers μ. Both describe the same forces in all states, so that μ = K λ, where K does not depend on rates and
//! inputs. States with given rates and inputs determine K as a function of the coordinates and parameters.

use super::derived_system::DerivedSystem;
use super::lagrange_multipliers::{multiplier_row_subsets, unit_multiplier_matrix};
use super::row_judgement::{Row, TermTools, judged_row_in_permitted_states};
use crate::algebra::Expr;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::text::print::print_text;
use crate::algebra::value::rank::independent_rows;

/// Largest number of unknowns of a system that is solved for its motion.
const MOST_UNKNOWNS: usize = 10;
/// Largest number of states that are tried to find independent multipliers.
const MOST_STATES: i64 = 12;

/// Multipliers μ of an author who has inserted the constraints into the rows.
pub struct MultipliersOfMotion {
    /// Matrix B of λ = B μ, from the author's multipliers μ to the derived multipliers λ.
    pub matrix: Vec<Row>,
    /// Description of the printed multipliers as sums of the derived multipliers.
    pub words: String,
}

/// Motion of the derived system in a state with given rates and inputs.
struct StateOfMotion {
    /// Substitution of numbers for the rates and inputs.
    put: Substitution,
    /// Accelerations and multipliers in the state, as terms in coordinates and parameters.
    unknowns: Row,
}

impl StateOfMotion {
    /// Multipliers in the state. `columns` are their indices among the unknowns.
    fn multipliers(&self, columns: &[usize]) -> Row {
        columns.iter().map(|c| self.unknowns[*c]).collect()
    }
}

/// Printed rows that mention multipliers. `columns` are the columns of the multipliers.
fn rows_with_multipliers<'a>(printed: &'a [Row], columns: &'a [usize]) -> impl Iterator<Item = &'a Row> {
    printed.iter().filter(|row| columns.iter().any(|c| row[*c] != Expr::ZERO))
}

impl TermTools<'_> {
    /// Printed rows with multipliers that are combinations of the derived rows, if λ = B μ with the matrix B `change`.
    /// The test is done modulo random primes.
    pub fn rows_that_follow(
        &mut self,
        order: &DerivedSystem,
        printed: &[Row],
        columns: &[usize],
        change: &[Row],
    ) -> Vec<Row> {
        let derived: Vec<Row> = order
            .rows
            .iter()
            .map(|row| {
                let before: Vec<Expr> = columns.iter().map(|c| row[*c]).collect();
                let mut row = row.clone();
                for (column, value) in columns.iter().zip(self.row_times_matrix(&before, change)) {
                    row[*column] = value;
                }
                judged_row_in_permitted_states(self.arena, self.comparer, &row)
            })
            .collect();
        let Some(independent) = independent_rows(self.arena, &derived) else { return Vec::new() };
        let basis: Vec<Row> = independent.iter().map(|at| derived[*at].clone()).collect();
        let follows = |row: &&Row| {
            let row = judged_row_in_permitted_states(self.arena, self.comparer, row);
            let rows = [&basis[..], &[row]].concat();
            independent_rows(self.arena, &rows).is_some_and(|found| found.len() == basis.len())
        };
        rows_with_multipliers(printed, columns).filter(follows).cloned().collect()
    }

    /// Finds the author's multipliers from the motion. With them, more than `least` printed rows with multipliers must
    /// follow from the derived rows. `fixed` are the coordinates, and the parameters that are no inputs.
    ///
    /// The rows from which K is computed follow from it in any case. K therefore counts only if one of two conditions
    /// holds. Either the rows still determine each multiplier when any one row is left out. Or K is like a rotation:
    /// all axes are perpendicular, the axes of multipliers that fail the first test have unit length, and not all
    /// entries are numbers. Returns `None` if there is no such K.
    pub fn multipliers_of_motion(
        &mut self,
        order: &DerivedSystem,
        printed: &[Row],
        columns: &[usize],
        fixed: &[Expr],
        least: usize,
    ) -> Option<MultipliersOfMotion> {
        if order.unknowns.len() > MOST_UNKNOWNS {
            return None;
        }
        let mut seen = |row: &Row| judged_row_in_permitted_states(self.arena, self.comparer, row);
        let derived: Vec<Row> = order.rows.iter().map(&mut seen).collect();
        let rows: Vec<Row> = rows_with_multipliers(printed, columns).map(&mut seen).collect();
        let all = self.arena.reachable(&[derived.concat(), rows.concat()].concat());
        let varied: Vec<Expr> =
            all.into_iter().filter(|e| self.arena.symbol_name(*e).is_some() && !fixed.contains(e)).collect();
        let states = self.states_of_motion(&derived, columns, &varied)?;
        let is_printed = |row: &Row, at: usize| row[columns[at]] != Expr::ZERO;
        let used: Vec<usize> = (0..columns.len()).filter(|at| rows.iter().any(|row| is_printed(row, *at))).collect();
        // If no K for all multipliers is found, a row of one of them may be wrong. Each multiplier is then tried alone.
        let fewer: Vec<Vec<usize>> = used.iter().filter(|_| used.len() > 1).map(|at| vec![*at]).collect();
        let mut best: Option<(usize, MultipliersOfMotion)> = None;
        for used in std::iter::once(used).chain(fewer) {
            let is_other = |row: &Row| (0..columns.len()).any(|at| !used.contains(&at) && is_printed(row, at));
            let rows: Vec<&Row> = rows.iter().filter(|row| !is_other(row)).collect();
            for chosen in multiplier_row_subsets(rows.len(), used.len()) {
                let chosen: Vec<&Row> = chosen.iter().map(|at| rows[*at]).collect();
                let Some(matrix) = self.multiplier_matrix_of_rows(&states, &chosen, columns, &used) else { continue };
                let words = self.printed_multiplier_words(order, columns, &used, &matrix);
                let Some(inverse) = self.inverse_of_completed_matrix(&matrix, &used, columns.len()) else { continue };
                let found = self.rows_that_follow(order, printed, columns, &inverse);
                let follow = found.len();
                if follow > best.as_ref().map_or(least, |(most, _)| *most)
                    && self.are_multipliers_told(&matrix, &found, columns, &used)
                {
                    best = Some((follow, MultipliersOfMotion { matrix: inverse, words }));
                }
            }
            if best.is_some() {
                break;
            }
        }
        best.map(|(_, found)| found)
    }

    /// Finds states in which the derived multipliers are linearly independent, as many states as multipliers. `varied`
    /// are the rates and inputs that get numbers in each state. `None` if no such states are found.
    fn states_of_motion(&mut self, derived: &[Row], columns: &[usize], varied: &[Expr]) -> Option<Vec<StateOfMotion>> {
        let independent = independent_rows(self.arena, derived)?;
        let width = derived.first()?.len() - 1;
        if independent.len() != width {
            return None;
        }
        let mut states: Vec<StateOfMotion> = Vec::new();
        for number in 0..MOST_STATES {
            let value = |place: i64| (3 + 5 * number * place + place * place) % 11 - 4;
            let values: Vec<(Expr, Expr)> =
                varied.iter().zip(1..).map(|(symbol, place)| (*symbol, self.arena.integer(value(place)))).collect();
            let mut put = Substitution::new(&values);
            let at_state: Vec<Row> = independent.iter().map(|at| put.all(self.arena, &derived[*at])).collect();
            let a: Vec<Row> = at_state.iter().map(|row| row[..width].to_vec()).collect();
            let b: Vec<Row> = at_state.iter().map(|row| vec![row[width]]).collect();
            let Ok((unknowns, _)) = solve_linear(self.arena, self.simplifier, &a, &b) else { continue };
            let unknowns: Row = unknowns.iter().map(|row| self.simplifier.simplify(self.arena, row[0])).collect();
            states.push(StateOfMotion { put, unknowns });
            let known: Vec<Row> = states.iter().map(|state| state.multipliers(columns)).collect();
            if independent_rows(self.arena, &known)?.len() < known.len() {
                states.pop();
            }
            if states.len() == columns.len() {
                return Some(states);
            }
        }
        None
    }

    /// Computes the matrix K of μ = K λ from as many printed rows as there are used multipliers; K has a row for each
    /// of them. Returns `None` if these rows do not determine the multipliers.
    fn multiplier_matrix_of_rows(
        &mut self,
        states: &[StateOfMotion],
        chosen: &[&Row],
        columns: &[usize],
        used: &[usize],
    ) -> Option<Vec<Row>> {
        let (mut of_derived, mut of_printed): (Vec<Row>, Vec<Row>) = (Vec::new(), Vec::new());
        for state in states {
            let mut put = state.put.clone();
            let rows: Vec<Row> = chosen.iter().map(|row| put.all(self.arena, row)).collect();
            // Q μ = r − P a.
            let q: Vec<Row> = rows.iter().map(|row| used.iter().map(|at| row[columns[*at]]).collect()).collect();
            let mut rest = Vec::new();
            for row in &rows {
                let (right, left) = row.split_last()?;
                let terms: Vec<Expr> = (0..left.len())
                    .filter(|c| !columns.contains(c))
                    .map(|c| self.arena.mul(left[c], state.unknowns[c]))
                    .collect();
                let sum = self.arena.sum(&terms);
                rest.push(vec![self.arena.sub(*right, sum)]);
            }
            let (mu, _) = solve_linear(self.arena, self.simplifier, &q, &rest).ok()?;
            of_derived.push(state.multipliers(columns));
            of_printed.push(mu.iter().map(|row| self.simplifier.simplify(self.arena, row[0])).collect());
        }
        // Each state gives an equation K λ = μ, which is a row of λᵀ Kᵀ = μᵀ.
        let (transposed, _) = solve_linear(self.arena, self.simplifier, &of_derived, &of_printed).ok()?;
        let row = |i: usize| transposed.iter().map(|row| self.simplifier.simplify(self.arena, row[i])).collect();
        Some((0..used.len()).map(row).collect())
    }

    /// True if the choice of multipliers is certain. Either the rows still determine each used multiplier when any one
    /// row is left out. Or K is like a rotation: all axes are perpendicular, the axes of multipliers that fail the
    /// first test have unit length, and not all entries are numbers.
    fn are_multipliers_told(&mut self, matrix: &[Row], rows: &[Row], columns: &[usize], used: &[usize]) -> bool {
        let forces: Vec<Row> = rows.iter().map(|row| used.iter().map(|at| row[columns[*at]]).collect()).collect();
        let arena = &*self.arena;
        let count = |rows: &[Row]| independent_rows(arena, rows).map(|found| found.len());
        let is_told_twice = |own: usize| {
            (0..forces.len()).all(|left_out| {
                let others = [&forces[..left_out], &forces[left_out + 1..]].concat();
                // The multiplier is determined if its axis is in the span of the rows.
                let axis: Row = (0..used.len()).map(|i| if i == own { Expr::ONE } else { Expr::ZERO }).collect();
                let with = [&others[..], &[axis]].concat();
                !others.is_empty() && count(&others).is_some() && count(&others) == count(&with)
            })
        };
        let told: Vec<bool> = (0..used.len()).map(is_told_twice).collect();
        if told.iter().all(|is_told| *is_told) {
            return true;
        }
        let mut product = |row: &Row, other: &Row| {
            let terms: Vec<Expr> = row.iter().zip(other).map(|(a, b)| self.arena.mul(*a, *b)).collect();
            let sum = self.arena.sum(&terms);
            self.simplifier.simplify(self.arena, sum)
        };
        let are_turned = matrix.iter().enumerate().all(|(i, row)| {
            matrix[..i].iter().all(|other| product(row, other) == Expr::ZERO)
                && (told[i] || product(row, row) == Expr::ONE)
        });
        are_turned && !matrix.iter().flatten().all(|e| self.arena.as_number(*e).is_some())
    }

    /// Inverse of a matrix that is completed with rows for the multipliers that no printed row mentions. `used` are the
    /// indices of the mentioned multipliers, in the order of the rows. `None` if the completed matrix is not regular.
    fn inverse_of_completed_matrix(&mut self, matrix: &[Row], used: &[usize], width: usize) -> Option<Vec<Row>> {
        let mut whole: Vec<Row> = vec![Row::new(); width];
        for (at, row) in used.iter().zip(matrix) {
            whole[*at].clone_from(row);
        }
        for at in 0..width {
            if !whole[at].is_empty() {
                continue;
            }
            let known: Vec<Row> = whole.iter().filter(|row| !row.is_empty()).cloned().collect();
            // Of two multipliers, the unmentioned one has the axis perpendicular to the other.
            let perpendicular = match known.as_slice() {
                [row] if width == 2 => Some(vec![self.arena.neg(row[1]), row[0]]),
                _ => None,
            };
            whole[at] = perpendicular.into_iter().chain(unit_multiplier_matrix(width)).find(|row| {
                let rows = [&known[..], std::slice::from_ref(row)].concat();
                independent_rows(self.arena, &rows).is_some_and(|found| found.len() == rows.len())
            })?;
        }
        let (inverse, _) = solve_linear(self.arena, self.simplifier, &whole, &unit_multiplier_matrix(width)).ok()?;
        let simplified = |row: Row| row.into_iter().map(|e| self.simplifier.simplify(self.arena, e)).collect();
        Some(inverse.into_iter().map(simplified).collect())
    }

    /// Describes the printed multipliers, each as a sum of derived multipliers.
    fn printed_multiplier_words(
        &mut self,
        order: &DerivedSystem,
        columns: &[usize],
        used: &[usize],
        matrix: &[Row],
    ) -> String {
        let mut list = Vec::new();
        for (at, row) in used.iter().zip(matrix) {
            let terms: Vec<Expr> =
                row.iter().zip(columns).map(|(k, c)| self.arena.mul(*k, order.unknowns[*c])).collect();
            let sum = self.arena.sum(&terms);
            let printed = order.unknowns[columns[*at]];
            if sum != printed {
                let (name, sum) = (print_text(self.arena, printed), print_text(self.arena, sum));
                list.push(format!("with the derived values, the printed {name} is {sum}"));
            }
        }
        format!("multipliers of its own: {}", list.join(", "))
    }
}
