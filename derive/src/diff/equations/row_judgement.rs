//! Comparison of linear systems row by row. Each printed row may have its own factor.
//!
//! A search (`matching`) finds the factor. A row with one wrong entry is therefore still matched, and the wrong entry
//! can be named. The search proves nothing. Its result is then proved entry by entry.

use super::row_independence::is_last_row_independent;
use super::row_matching::{RowMatch, best_row_match};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::meaning::compare::{Comparer, Engine, Verdict};
use crate::algebra::meaning::permitted_states::StatesOfValidity;
use crate::algebra::solve::linear::solve_linear;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::text::print::print_text;
use crate::algebra::value::rank::pivot_rows_and_columns;
use crate::algebra::value::zero_test::{ZeroTest, has_roots, zero_test};
use crate::algebra::{Arena, Expr, Function, Node};

/// Row of a linear system: one coefficient for each unknown, then the right-hand side.
pub type Row = Vec<Expr>;

/// Match of a printed row with rows of the derived system.
#[derive(Clone, Debug)]
pub enum RowMatchResult {
    /// Printed row that is a multiple of one derived row, in most entries.
    Row {
        /// Index of the derived row that the printed row is a multiple of.
        at: usize,
        /// Factor with printed = factor · derived in most entries.
        factor: Expr,
    },
    /// Printed row that is a linear combination of derived rows, in all entries or in all except
    /// one.
    Combination {
        /// Multipliers, one for each derived row; empty if they are too long or too many to be stated.
        multipliers: Vec<Expr>,
    },
}

/// Arena, simplifier and comparer for the comparison of terms.
pub struct TermTools<'a> {
    /// Arena that holds all compared terms.
    pub arena: &'a mut Arena,
    /// Simplifier that finds short forms of terms.
    pub simplifier: &'a mut Simplifier,
    /// Comparer that decides whether two terms are equal.
    pub comparer: &'a mut Comparer,
}

/// Judgement of one printed row against the derived rows.
#[derive(Clone, Debug)]
pub struct RowJudgement {
    /// Derived row, or combination of derived rows, that the printed row was matched with.
    pub by: RowMatchResult,
    /// Verdicts on printed = expected, one for each entry; the right-hand side is last.
    pub entries: Vec<Verdict>,
    /// Expected value of each entry, with the right-hand side last. It is the sum of the matched derived rows times
    /// their factors.
    pub expected: Row,
    /// Region of states in which each right entry equals its expected value, with the right-hand side last.
    pub holds: Vec<StatesOfValidity>,
    /// True if entries agree only to the number of digits printed.
    pub is_rounded: bool,
}

impl RowJudgement {
    /// True if every entry of the row, with the right-hand side, has its expected value.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.entries.iter().all(Verdict::is_equal)
    }

    /// Region of states in which all right entries of the row equal their expected values.
    #[must_use]
    pub fn holds(&self) -> StatesOfValidity {
        self.holds.iter().fold(StatesOfValidity::EVERYWHERE, |all, one| all | *one)
    }
}

/// Largest number of rows of a system for which a combination of rows is written out and proved
/// entry by entry.
pub(super) const WRITTEN: usize = 6;
/// Longest multiplier, in characters, that a match reports.
const LONGEST: usize = 200;

/// Judges a printed row against the derived rows. `index` is the row's index, from 0. All rows have the same length.
/// `parameters` are the symbols that do not depend on the state.
pub fn judge_row(
    terms: &mut TermTools<'_>,
    parameters: &[Expr],
    printed: &Row,
    derived: &[Row],
    index: usize,
) -> RowJudgement {
    let TermTools { arena, simplifier, comparer } = terms;
    // The search runs modulo primes, in which different angle terms are unrelated. Equal angles must therefore be equal
    // terms.
    let mut plain = |row: &Row| row.iter().map(|e| comparer.expand_angles(arena, *e)).collect::<Row>();
    let (printed, derived) = (&plain(printed), derived.iter().map(&mut plain).collect::<Vec<Row>>());
    let derived = derived.as_slice();
    // The search runs in permitted states, where equal entries are equal by plain algebra.
    let seen_printed = judged_row_in_permitted_states(arena, comparer, printed);
    let seen_derived: Vec<Row> =
        derived.iter().map(|row| judged_row_in_permitted_states(arena, comparer, row)).collect();
    let found = best_row_match(arena, simplifier, parameters, &seen_printed, &seen_derived, index);
    let by = match found {
        // Equal entries may be written as different terms, and their ratio then does not simplify to 1.
        RowMatch::Row { at, column: Some(column) }
            if !comparer.compare(arena, printed[column], derived[at][column]).is_equal() =>
        {
            let ratio = arena.div(printed[column], derived[at][column]).unwrap_or(Expr::ONE);
            RowMatchResult::Row { at, factor: simplifier.simplify(arena, ratio) }
        }
        RowMatch::Row { at, .. } => RowMatchResult::Row { at, factor: Expr::ONE },
        RowMatch::Combination(multipliers) => RowMatchResult::Combination { multipliers },
    };
    let sums: Row = (0..printed.len())
        .map(|column| {
            let parts: Vec<Expr> = match &by {
                RowMatchResult::Row { at, factor } => vec![arena.mul(*factor, derived[*at][column])],
                RowMatchResult::Combination { multipliers } => {
                    multipliers.iter().zip(derived).map(|(m, row)| arena.mul(*m, row[column])).collect()
                }
            };
            arena.sum(&parts)
        })
        .collect();
    let expected: Row = sums.into_iter().map(|e| simplifier.simplify(arena, e)).collect();
    let compared = printed.iter().zip(&expected).map(|(p, e)| comparer.compare_with_states(arena, *p, *e));
    let (entries, holds): (Vec<Verdict>, Vec<StatesOfValidity>) = compared.unzip();
    let judged = RowJudgement { by, entries, expected, holds, is_rounded: false };
    if judged.is_right() {
        return judged;
    }
    let found = row_combination(arena, simplifier, comparer, printed, derived)
        .map(|found| (found, StatesOfValidity::EVERYWHERE));
    let found = match found {
        Ok((None, _)) if (&seen_printed, &seen_derived[..]) != (printed, derived) => {
            let holds = StatesOfValidity { on_constraints: true, in_domain: false };
            row_combination(arena, simplifier, comparer, &seen_printed, &seen_derived).map(|found| (found, holds))
        }
        found => found,
    };
    match found.map(|(found, holds)| found.map(|multipliers| (multipliers, holds))) {
        Ok(Some((multipliers, holds))) => RowJudgement {
            by: RowMatchResult::Combination { multipliers },
            entries: vec![Verdict::Equal(Engine::NormalForm); printed.len()],
            expected: printed.clone(),
            holds: vec![holds; printed.len()],
            is_rounded: false,
        },
        Ok(None) => judged,
        // The row may be a combination of derived rows. Then no entry is wrong.
        Err(why) => {
            let open = |v: Verdict| if v.is_equal() { v } else { Verdict::Undecided(why.clone()) };
            RowJudgement { entries: judged.entries.into_iter().map(open).collect(), ..judged }
        }
    }
}

/// Rewrites a row for states that the model's constraints permit: dependent symbols are replaced by their values. Equal
/// angles become equal terms.
pub fn judged_row_in_permitted_states(arena: &mut Arena, comparer: &mut Comparer, row: &Row) -> Row {
    let put: Row = row.iter().map(|e| comparer.permitted().write_in_free_symbols(arena, *e)).collect();
    put.into_iter().map(|e| comparer.expand_angles(arena, e)).collect()
}

/// Multipliers λ with Σ λᵢ · derivedᵢ = printed, one for each derived row. The list is empty if they are too many or
/// too long to be stated. Returns `None` if the printed row is not a combination of the derived rows. The error is the
/// reason why no decision is possible.
pub(super) fn row_combination(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    comparer: &mut Comparer,
    printed: &Row,
    derived: &[Row],
) -> Result<Option<Vec<Expr>>, String> {
    if printed.iter().all(|e| *e == Expr::ZERO) {
        return Ok(None);
    }
    let unknown = || "whether the row is a combination of derived rows is not known".to_owned();
    // If there are more rows than unknowns, some rows depend on others.
    let (independent, columns) = pivot_rows_and_columns(arena, derived).ok_or_else(unknown)?;
    let mut rows: Vec<Row> = independent.iter().map(|at| derived[*at].clone()).collect();
    rows.push(printed.clone());
    let all = arena.reachable(&rows.concat());
    let with_roots = has_roots(arena, &all);
    if with_roots && independent.len() > WRITTEN {
        // A combination that holds for any values of the roots also holds for their actual values.
        rows = judged_rows_with_free_roots(arena, &all, rows);
    }
    let (found, _) = pivot_rows_and_columns(arena, &rows).ok_or_else(unknown)?;
    let follows = found.len() < rows.len();
    if !follows && !with_roots {
        return Ok(None);
    }
    if independent.len() > WRITTEN {
        if follows {
            return Ok(Some(Vec::new()));
        }
        let rows: Vec<Row> = independent.iter().map(|at| derived[*at].clone()).chain([printed.clone()]).collect();
        return if is_last_row_independent(arena, comparer, &rows) { Ok(None) } else { Err(unknown()) };
    }
    let transposed: Vec<Row> =
        columns.iter().map(|c| independent.iter().map(|at| derived[*at][*c]).collect()).collect();
    let right: Vec<Row> = columns.iter().map(|c| vec![printed[*c]]).collect();
    let (values, _) = solve_linear(arena, simplifier, &transposed, &right).map_err(|_| unknown())?;
    let mut multipliers = vec![Expr::ZERO; derived.len()];
    for (at, value) in independent.iter().zip(values) {
        multipliers[*at] = value[0];
    }
    for (column, entry) in printed.iter().enumerate() {
        let terms: Vec<Expr> = derived.iter().zip(&multipliers).map(|(row, m)| arena.mul(row[column], *m)).collect();
        let sum = arena.sum(&terms);
        match comparer.compare(arena, sum, *entry) {
            Verdict::Equal(_) => {}
            Verdict::Different(_) => return Ok(None),
            Verdict::Undecided(why) => return Err(why),
        }
    }
    let short = multipliers.iter().all(|m| print_text(arena, *m).len() <= LONGEST);
    Ok(Some(if short { multipliers } else { Vec::new() }))
}

/// Replaces roots, absolute values and signs among the terms `all` with free symbols. Equal roots get the same symbol
/// r, and r² replaces the argument of a square root.
fn judged_rows_with_free_roots(arena: &mut Arena, all: &[Expr], rows: Vec<Row>) -> Vec<Row> {
    let mut put: Vec<(Expr, Expr)> = Vec::new();
    let mut known: Vec<(Function, Expr, Expr)> = Vec::new();
    for part in all {
        let Node::Apply(f @ (Function::Sqrt | Function::Abs | Function::Sign), argument) = *arena.node(*part) else {
            continue;
        };
        let same = known.iter().find(|(g, other, _)| {
            let is_same = *other == argument || {
                let difference = arena.sub(argument, *other);
                zero_test(arena, difference) == ZeroTest::Zero
            };
            *g == f && is_same
        });
        let symbol = match same {
            Some((_, _, symbol)) => *symbol,
            None => fresh_symbol(arena, "root"),
        };
        known.push((f, argument, symbol));
        put.push((*part, symbol));
        if f == Function::Sqrt && arena.as_number(argument).is_none() {
            put.push((argument, arena.square(symbol)));
        }
    }
    let mut put = Substitution::new(&put);
    rows.into_iter().map(|row| row.into_iter().map(|e| put.apply(arena, e)).collect()).collect()
}
