//! Elimination for generated code: linear systems with symmetric or general matrices are solved in
//! the arena. The module is separate from `block_systems`, which divides by determinants of blocks.
//! It is also separate from `linear`, which solves systems without named entries. The module
//! `solved_rows` of reductions solves rows for a part of the columns.
//!
//! The method is Gaussian elimination in an order that keeps the fill-in low, with every entry in
//! its short form. Short entries are written out, so that terms that are identically zero
//! disappear: a small system ends in a closed form. An entry that grows gets a name, and later
//! entries mention that name. So a large system ends in the shared arithmetic of a sparse L D Lᵀ
//! factorization. Absent on purpose: choosing pivots by value. A pivot of a symmetric positive
//! definite matrix is never zero. In other matrices, pivots that are proved never to be zero go
//! first, if there are any.

use super::linear::Singular;
use crate::algebra::form::sharing::{SharingOptions, share_common_parts};
use crate::algebra::form::simplify::{Simplifier, operation_count, operation_count_of_all};
use crate::algebra::term::steps::{Definition, fresh_symbol};
use crate::algebra::value::range::range_excludes_zero;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Node};

/// Number of operations above which an entry gets its own name, for each of three trials. The first
/// trial keeps long entries, which may cancel later. The last trial names every entry that needs an
/// operation.
const LONGEST: [usize; 3] = [150, 40, 0];

/// Linear system A x = b with a square matrix A (n × n).
#[derive(Clone, Copy)]
pub struct LinearSystem<'a> {
    /// Matrix A, as a list of rows.
    pub matrix: &'a [Vec<Expr>],
    /// Right-hand side b, with n entries.
    pub right: &'a [Expr],
    /// Symbols of the n unknowns x.
    pub unknowns: &'a [Expr],
    /// True if A is symmetric, and positive definite wherever it is regular.
    pub symmetric: bool,
    /// True for a large system: every entry gets a name at once, without the search for entries
    /// that cancel.
    pub is_large: bool,
}

/// Solution of a linear system as a sequence of computation steps.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Steps that define named entries and all unknowns, in the order of computation.
    pub steps: Vec<Definition>,
    /// Bases of the divisors in the steps, each once, in the order in which they occur. Plain
    /// numbers are left out.
    pub divisors: Vec<Expr>,
}

/// Solves a linear system by up to three eliminations, and returns the one with the fewest
/// operations.
///
/// # Errors
/// [`Singular`] if the matrix is singular for all values of its symbols.
pub fn eliminate(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    system: LinearSystem<'_>,
) -> Result<Elimination, Singular> {
    if system.is_large {
        let steps = eliminate_once(arena, simplifier, system, 0)?;
        let divisors = divisors(arena, &steps.iter().map(|step| step.value).collect::<Vec<_>>());
        return Ok(Elimination { steps, divisors });
    }
    let mut best: Option<(usize, Arena, Simplifier, Vec<Definition>)> = None;
    for longest in LONGEST {
        // Each trial has its own copy of the arena, so that names from rejected trials are not used
        // up.
        let (mut arena, mut simplifier) = (arena.clone(), simplifier.clone());
        let steps = eliminate_once(&mut arena, &mut simplifier, system, longest)?;
        let total = elimination_cost(&arena, &steps, system.unknowns);
        let has_names = steps.len() > system.unknowns.len();
        if best.as_ref().is_none_or(|(least, ..)| total < *least) {
            best = Some((total, arena, simplifier, steps));
        }
        // If no entry was long enough for a name, the next trials with lower limits are left out:
        // they are meant for larger systems.
        if !has_names {
            break;
        }
    }
    let Some((_, its_arena, its_simplifier, steps)) = best else { return Ok(Elimination::default()) };
    (*arena, *simplifier) = (its_arena, its_simplifier);
    let divisors = divisors(arena, &steps.iter().map(|step| step.value).collect::<Vec<_>>());
    Ok(Elimination { steps, divisors })
}

/// Number of operations of a solution after common parts are shared, as in the generated code. It
/// is the least over three options for sharing.
fn elimination_cost(arena: &Arena, steps: &[Definition], unknowns: &[Expr]) -> usize {
    let counts = SharingOptions::COMMON_OPTIONS.into_iter().filter_map(|reading| {
        let mut arena = arena.clone();
        let shared = share_common_parts(&mut arena, &mut Simplifier::default(), reading, steps, unknowns)?;
        let values: Vec<Expr> = shared.steps.iter().map(|step| step.value).chain(shared.values).collect();
        Some(operation_count_of_all(&arena, &values))
    });
    counts.min().unwrap_or(0)
}

/// Solves a system by a single elimination, in which entries of more than `longest` operations get
/// names. Error if the matrix is singular.
fn eliminate_once(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    system: LinearSystem<'_>,
    longest: usize,
) -> Result<Vec<Definition>, Singular> {
    let mut work = EliminationState::new(arena, simplifier, system, longest);
    while work.order.len() < system.right.len() {
        let Some((row, column)) = work.pivot() else {
            let row = work.rows.iter().position(|active| *active).unwrap_or(0);
            return Err(Singular { rank: work.order.len(), row });
        };
        work.eliminate_column(row, column);
    }
    work.substitute_back(system.unknowns);
    Ok(work.steps)
}

/// State of an elimination after some of its pivots.
struct EliminationState<'a> {
    /// Arena of the terms.
    arena: &'a mut Arena,
    /// Simplifier of the entries.
    simplifier: &'a mut Simplifier,
    /// Matrix A as eliminated so far, by rows.
    matrix: Vec<Vec<Expr>>,
    /// Right-hand side b as eliminated so far.
    right: Vec<Expr>,
    /// True if the matrix A is symmetric, and positive definite wherever it is regular.
    symmetric: bool,
    /// True for each row that has not been a pivot row yet.
    rows: Vec<bool>,
    /// True for each column that has not been a pivot column yet.
    columns: Vec<bool>,
    /// Pivots chosen so far, as pairs (row, column).
    order: Vec<(usize, usize)>,
    /// Steps so far, which define the named entries.
    steps: Vec<Definition>,
    /// Number of operations above which an entry gets a name.
    longest: usize,
}

impl<'a> EliminationState<'a> {
    /// Prepares the elimination of a system, with every entry in short form.
    fn new(arena: &'a mut Arena, simplifier: &'a mut Simplifier, system: LinearSystem<'_>, longest: usize) -> Self {
        let n = system.right.len();
        let mut work = Self {
            arena,
            simplifier,
            matrix: system.matrix.to_vec(),
            right: system.right.to_vec(),
            symmetric: system.symmetric,
            rows: vec![true; n],
            columns: vec![true; n],
            order: Vec::new(),
            steps: Vec::new(),
            longest,
        };
        for i in 0..n {
            for j in 0..n {
                work.matrix[i][j] = work.short_entry(system.matrix[i][j]);
            }
        }
        work
    }

    /// Short form of an entry; the literal 0 if the entry is identically 0.
    fn short_entry(&mut self, e: Expr) -> Expr {
        let e = self.simplifier.simplify(self.arena, e);
        let zero = matches!(self.arena.node(e), Node::Sum(..)) && zero_test(self.arena, e) == ZeroTest::Zero;
        if zero { Expr::ZERO } else { e }
    }

    /// Names an entry `e` with more than `longest` operations: adds a step for it and returns the
    /// new symbol. Returns a shorter entry unchanged.
    fn name_entry(&mut self, e: Expr, name: &str) -> Expr {
        if operation_count(self.arena, e) <= self.longest {
            return e;
        }
        let symbol = fresh_symbol(self.arena, &format!("{name}{}", self.steps.len() + 1));
        self.steps.push(Definition { symbol, value: e });
        symbol
    }

    /// Row and column of the best pivot. A pivot that is proved never to be zero is best; then the
    /// least fill-in decides, then the shortest entry. `None` if no pivot is left.
    fn pivot(&self) -> Option<(usize, usize)> {
        let n = self.right.len();
        let active = |flags: &[bool]| -> Vec<usize> { (0..n).filter(|i| flags[*i]).collect() };
        let (rows, columns) = (active(&self.rows), active(&self.columns));
        let filled = |row: usize, column: usize| self.matrix[row][column] != Expr::ZERO;
        let mut best = None;
        for (&row, &column) in rows.iter().flat_map(|row| columns.iter().map(move |column| (row, column))) {
            let entry = self.matrix[row][column];
            if entry == Expr::ZERO || (self.symmetric && row != column) {
                continue;
            }
            let right = columns.iter().filter(|j| filled(row, **j)).count() - 1;
            let below = rows.iter().filter(|i| filled(**i, column)).count() - 1;
            let key = (
                !range_excludes_zero(self.arena, entry),
                right * below,
                operation_count(self.arena, entry),
                row,
                column,
            );
            if best.is_none_or(|least| key < least) && zero_test(self.arena, entry) != ZeroTest::Zero {
                best = Some(key);
            }
        }
        best.map(|(.., row, column)| (row, column))
    }

    /// Eliminates the pivot's column from all remaining rows. With the pivot d in row r and column
    /// c, entry a_ij becomes a_ij − (a_ic / d) a_rj.
    fn eliminate_column(&mut self, row: usize, column: usize) {
        let n = self.right.len();
        let d = self.name_entry(self.matrix[row][column], "d");
        self.matrix[row][column] = d;
        self.rows[row] = false;
        self.columns[column] = false;
        self.order.push((row, column));
        for i in (0..n).filter(|i| self.rows[*i]).collect::<Vec<_>>() {
            if self.matrix[i][column] == Expr::ZERO {
                continue;
            }
            let factor = self.arena.div(self.matrix[i][column], d).expect("a pivot is not zero");
            let factor = self.short_entry(factor);
            let factor = self.name_entry(factor, "l");
            for j in (0..n).filter(|j| self.columns[*j]).collect::<Vec<_>>() {
                if self.matrix[row][j] == Expr::ZERO || (self.symmetric && j < i) {
                    continue;
                }
                let product = self.arena.mul(factor, self.matrix[row][j]);
                let difference = self.arena.sub(self.matrix[i][j], product);
                let entry = self.short_entry(difference);
                self.matrix[i][j] = self.name_entry(entry, "s");
                if self.symmetric {
                    self.matrix[j][i] = self.matrix[i][j];
                }
            }
            let product = self.arena.mul(factor, self.right[row]);
            let difference = self.arena.sub(self.right[i], product);
            let entry = self.simplifier.simplify(self.arena, difference);
            self.right[i] = self.name_entry(entry, "r");
        }
    }

    /// Adds the steps that define the unknowns, from the last pivot to the first. Each step uses
    /// the unknowns already defined.
    fn substitute_back(&mut self, unknowns: &[Expr]) {
        // Value of each unknown in other steps: its symbol, or 0 if the unknown is 0.
        let mut known: Vec<Option<Expr>> = vec![None; unknowns.len()];
        for (row, column) in self.order.clone().into_iter().rev() {
            let mut terms = vec![self.right[row]];
            for (j, x) in known.iter().enumerate() {
                if let Some(x) = x {
                    let product = self.arena.mul(self.matrix[row][j], *x);
                    terms.push(self.arena.neg(product));
                }
            }
            let sum = self.arena.sum(&terms);
            let value = self.arena.div(sum, self.matrix[row][column]).expect("a pivot is not zero");
            let value = self.simplifier.simplify(self.arena, value);
            known[column] = Some(if value == Expr::ZERO { Expr::ZERO } else { unknowns[column] });
            self.steps.push(Definition { symbol: unknowns[column], value });
        }
    }
}

/// Divisors in the given terms: the bases of powers with negative exponents, each once.
#[must_use]
pub fn divisors(arena: &Arena, values: &[Expr]) -> Vec<Expr> {
    let mut found = Vec::new();
    for part in arena.reachable(values) {
        if let Node::Product(factors) = arena.node(part) {
            for (base, n) in factors {
                if *n < 0 && !found.contains(base) {
                    found.push(*base);
                }
            }
        }
    }
    found
}
