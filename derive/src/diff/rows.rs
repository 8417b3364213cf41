//! Linear systems compared row by row: each printed row may carry a factor of its own.
//!
//! The factor is found, not given: every ratio of a printed entry to a derived one is tried, and the ratio that
//! explains most entries wins. So a row with one wrong entry is still matched, and that entry named.

use crate::algebra::compare::{Comparer, Engine, Verdict};
use crate::algebra::linear::solve;
use crate::algebra::modular::{ZeroTest, rank, zero_test};
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr};

/// A row of a linear system: entries, then the right-hand side.
pub type Row = Vec<Expr>;

/// What a printed row was matched with.
#[derive(Clone, Debug)]
pub enum Match {
    /// `factor` times a derived row, as well as it goes.
    Row {
        /// The derived row.
        at: usize,
        /// printed = factor · derived in most entries.
        factor: Expr,
    },
    /// A combination of derived rows, exactly.
    Combination {
        /// One multiplier for each derived row; empty where they are too large to be stated.
        multipliers: Vec<Expr>,
    },
}

/// How a printed row relates to the derived ones.
#[derive(Clone, Debug)]
pub struct RowJudgement {
    /// What it was matched with.
    pub by: Match,
    /// For each entry and the right-hand side: printed against what it should be.
    pub entries: Vec<Verdict>,
    /// What each entry should be.
    pub expected: Row,
}

impl RowJudgement {
    /// Whether every entry is as it should be.
    #[must_use]
    pub fn is_right(&self) -> bool {
        self.entries.iter().all(Verdict::is_equal)
    }
}

/// Largest system whose combinations of rows are written out.
const WRITTEN: usize = 6;

/// Judges the printed row number `index`.
pub fn judge(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    comparer: &mut Comparer,
    printed: &Row,
    derived: &[Row],
    index: usize,
) -> RowJudgement {
    let (at, factor, explained) = best_factor(arena, printed, derived, index);
    if explained < printed.len() && is_combination(arena, printed, derived) {
        let multipliers = multipliers(arena, simplifier, printed, derived);
        let entries = vec![Verdict::Equal(Engine::NormalForm); printed.len()];
        return RowJudgement { by: Match::Combination { multipliers }, entries, expected: printed.clone() };
    }
    let factor = simplifier.simplify(arena, factor);
    let mut expected = Vec::new();
    for entry in &derived[at] {
        let product = arena.mul(factor, *entry);
        expected.push(simplifier.simplify(arena, product));
    }
    let entries = printed.iter().zip(&expected).map(|(p, e)| comparer.compare(arena, *p, *e)).collect();
    RowJudgement { by: Match::Row { at, factor }, entries, expected }
}

/// (derived row, factor, entries that agree): the row of the same number first, any other only if it explains more.
fn best_factor(arena: &mut Arena, printed: &Row, derived: &[Row], index: usize) -> (usize, Expr, usize) {
    let own = index.min(derived.len() - 1);
    let mut best = (own, Expr::ONE, 0, 0);
    let order = std::iter::once(own).chain((0..derived.len()).filter(|at| *at != own));
    for at in order {
        // Entries of the matrix come before the right-hand side: of two equally good factors theirs is taken.
        let mut tried: Vec<Expr> = Vec::new();
        for (p, d) in printed.iter().zip(&derived[at]) {
            if zero_test(arena, *p) != ZeroTest::NonZero || zero_test(arena, *d) != ZeroTest::NonZero {
                continue;
            }
            let Some(factor) = arena.div(*p, *d) else { continue };
            let known = tried.iter().any(|other| {
                let difference = arena.sub(factor, *other);
                zero_test(arena, difference) == ZeroTest::Zero
            });
            if known {
                continue;
            }
            tried.push(factor);
            let (mut agree, mut weight) = (0, 0);
            for (p, d) in printed.iter().zip(&derived[at]) {
                let product = arena.mul(factor, *d);
                let difference = arena.sub(*p, product);
                if zero_test(arena, difference) == ZeroTest::Zero {
                    agree += 1;
                    // Two zeros agree with any factor: they count, but little.
                    weight += if *p == Expr::ZERO { 1 } else { 100 };
                }
            }
            if weight > best.3 {
                best = (at, factor, agree, weight);
            }
        }
        if best.2 == printed.len() {
            break;
        }
    }
    (best.0, best.1, best.2)
}

/// Whether the printed row follows from the derived ones, which are independent: it adds nothing to their rank.
fn is_combination(arena: &Arena, printed: &Row, derived: &[Row]) -> bool {
    let mut all = derived.to_vec();
    all.push(printed.clone());
    let entries: Vec<Expr> = all.concat();
    // Functions without rules could make independent rows look dependent only by chance, but dependent ones independent.
    let is_zero_row = printed.iter().all(|e| zero_test(arena, *e) == ZeroTest::Zero);
    !is_zero_row && !entries.is_empty() && rank(arena, &all).is_some_and(|found| found.rank == derived.len())
}

/// λ with λᵀ A = the entries of the row.
fn multipliers(arena: &mut Arena, simplifier: &mut Simplifier, printed: &Row, derived: &[Row]) -> Vec<Expr> {
    let n = derived.len();
    if n > WRITTEN {
        return Vec::new();
    }
    let transposed: Vec<Row> = (0..n).map(|c| derived.iter().map(|row| row[c]).collect()).collect();
    let right: Vec<Row> = printed[..n].iter().map(|e| vec![*e]).collect();
    match solve(arena, simplifier, &transposed, &right) {
        Ok((values, _)) => values.into_iter().map(|row| row[0]).collect(),
        Err(_) => Vec::new(),
    }
}
