//! Linear systems with symmetric or general matrices, solved in the arena for generated code. Separate from `blocks`,
//! which divides by determinants alone, from `linear`, which only reads coefficients, and from `reduce::pivots`, which
//! solves rows for some columns.
//!
//! The method is Gaussian elimination in an order that keeps the fill-in low, with every entry in its short form. Short
//! entries are written out, so that terms that are zero by meaning disappear: a small system ends in a closed form. An
//! entry that grows gets a name, and later entries mention that name: a large system ends in the shared arithmetic of a
//! sparse L D Lᵀ factorization. Absent on purpose: choosing pivots by value. A pivot of a symmetric positive definite
//! matrix is never zero. In other matrices, pivots that are proved never to be zero go first, if there are any.

use super::linear::Singular;
use crate::algebra::form::sharing::{Reading, share};
use crate::algebra::form::simplify::{Simplifier, cost, cost_of_all};
use crate::algebra::term::steps::{Definition, fresh_symbol};
use crate::algebra::value::modular::{ZeroTest, zero_test};
use crate::algebra::value::range::never_zero;
use crate::algebra::{Arena, Expr, Node};

/// Number of operations above which an entry gets a name of its own, for each trial. The first trial keeps long
/// entries, which may cancel some pivots later. The last trial names every entry.
const LONGEST: [usize; 3] = [150, 40, 0];

/// Linear system A x = b with a square matrix A.
#[derive(Clone, Copy)]
pub struct LinearSystem<'a> {
    /// Matrix A, row by row.
    pub matrix: &'a [Vec<Expr>],
    /// The right-hand side b.
    pub right: &'a [Expr],
    /// Symbols of the unknowns x.
    pub unknowns: &'a [Expr],
    /// True if A is symmetric, and positive definite wherever it is regular.
    pub symmetric: bool,
    /// True if every entry gets a name at once, without the search for entries that cancel.
    pub is_large: bool,
}

/// The solution of a linear system, step by step.
#[derive(Clone, Debug, Default)]
pub struct Elimination {
    /// Definitions of named entries and of all unknowns, in the order of computation.
    pub steps: Vec<Definition>,
    /// Divisors of the steps, each base once, in order of appearance, without plain numbers.
    pub divisors: Vec<Expr>,
}

/// Solves a linear system by the cheapest of several eliminations.
///
/// # Errors
/// [`Singular`] if the matrix is singular identically.
pub fn eliminate(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    system: LinearSystem<'_>,
) -> Result<Elimination, Singular> {
    if system.is_large {
        let steps = solve(arena, simplifier, system, 0)?;
        let divisors = divisors(arena, &steps.iter().map(|step| step.value).collect::<Vec<_>>());
        return Ok(Elimination { steps, divisors });
    }
    let mut best: Option<(usize, Arena, Simplifier, Vec<Definition>)> = None;
    for longest in LONGEST {
        // Each trial has an arena of its own, so that the names of a trial that loses stay free.
        let (mut arena, mut simplifier) = (arena.clone(), simplifier.clone());
        let steps = solve(&mut arena, &mut simplifier, system, longest)?;
        let total = least_cost(&arena, &steps, system.unknowns);
        let has_names = steps.len() > system.unknowns.len();
        if best.as_ref().is_none_or(|(least, ..)| total < *least) {
            best = Some((total, arena, simplifier, steps));
        }
        // If no entry was long enough for a name, lower limits are not tried: they are for larger systems.
        if !has_names {
            break;
        }
    }
    let Some((_, its_arena, its_simplifier, steps)) = best else { return Ok(Elimination::default()) };
    (*arena, *simplifier) = (its_arena, its_simplifier);
    let divisors = divisors(arena, &steps.iter().map(|step| step.value).collect::<Vec<_>>());
    Ok(Elimination { steps, divisors })
}

/// Number of operations of a solution after common parts are shared, as they will be in the generated code.
fn least_cost(arena: &Arena, steps: &[Definition], unknowns: &[Expr]) -> usize {
    let counts = Reading::SAMPLE.into_iter().filter_map(|reading| {
        let mut arena = arena.clone();
        let shared = share(&mut arena, &mut Simplifier::default(), reading, steps, unknowns)?;
        let values: Vec<Expr> = shared.steps.iter().map(|step| step.value).chain(shared.values).collect();
        Some(cost_of_all(&arena, &values))
    });
    counts.min().unwrap_or(0)
}

/// Steps of one elimination, in which entries of more than `longest` operations get names.
fn solve(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    system: LinearSystem<'_>,
    longest: usize,
) -> Result<Vec<Definition>, Singular> {
    let mut work = Work::new(arena, simplifier, system, longest);
    while work.order.len() < system.right.len() {
        let Some((row, column)) = work.pivot() else {
            let row = work.rows.iter().position(|active| *active).unwrap_or(0);
            return Err(Singular { rank: work.order.len(), row });
        };
        work.clear(row, column);
    }
    work.substitute_back(system.unknowns);
    Ok(work.steps)
}

/// State of an elimination between two pivots.
struct Work<'a> {
    arena: &'a mut Arena,
    simplifier: &'a mut Simplifier,
    matrix: Vec<Vec<Expr>>,
    right: Vec<Expr>,
    symmetric: bool,
    /// True for each row that had no pivot yet.
    rows: Vec<bool>,
    /// True for each column that had no pivot yet.
    columns: Vec<bool>,
    /// Pivots so far, as (row, column).
    order: Vec<(usize, usize)>,
    steps: Vec<Definition>,
    /// Number of operations above which an entry gets a name.
    longest: usize,
}

impl<'a> Work<'a> {
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
                work.matrix[i][j] = work.short(system.matrix[i][j]);
            }
        }
        work
    }

    /// Short form of an entry; the literal 0 if it is 0 by meaning.
    fn short(&mut self, e: Expr) -> Expr {
        let e = self.simplifier.simplify(self.arena, e);
        let zero = matches!(self.arena.node(e), Node::Sum(..)) && zero_test(self.arena, e) == ZeroTest::Zero;
        if zero { Expr::ZERO } else { e }
    }

    /// Returns the entry `e`, or a new name for it if it is long.
    fn named(&mut self, e: Expr, name: &str) -> Expr {
        if cost(self.arena, e) <= self.longest {
            return e;
        }
        let symbol = fresh_symbol(self.arena, &format!("{name}{}", self.steps.len() + 1));
        self.steps.push(Definition { symbol, value: e });
        symbol
    }

    /// Best pivot as (row, column): proved never to be zero, then with least fill-in, then the shortest.
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
            let key = (!never_zero(self.arena, entry), right * below, cost(self.arena, entry), row, column);
            if best.is_none_or(|least| key < least) && zero_test(self.arena, entry) != ZeroTest::Zero {
                best = Some(key);
            }
        }
        best.map(|(.., row, column)| (row, column))
    }

    /// Eliminates the pivot's column from all remaining rows: a_ij becomes a_ij − (a_ic / d) a_rj, with pivot d in row
    /// r.
    fn clear(&mut self, row: usize, column: usize) {
        let n = self.right.len();
        let d = self.named(self.matrix[row][column], "d");
        self.matrix[row][column] = d;
        self.rows[row] = false;
        self.columns[column] = false;
        self.order.push((row, column));
        for i in (0..n).filter(|i| self.rows[*i]).collect::<Vec<_>>() {
            if self.matrix[i][column] == Expr::ZERO {
                continue;
            }
            let factor = self.arena.div(self.matrix[i][column], d).expect("a pivot is not zero");
            let factor = self.short(factor);
            let factor = self.named(factor, "l");
            for j in (0..n).filter(|j| self.columns[*j]).collect::<Vec<_>>() {
                if self.matrix[row][j] == Expr::ZERO || (self.symmetric && j < i) {
                    continue;
                }
                let product = self.arena.mul(factor, self.matrix[row][j]);
                let difference = self.arena.sub(self.matrix[i][j], product);
                let entry = self.short(difference);
                self.matrix[i][j] = self.named(entry, "s");
                if self.symmetric {
                    self.matrix[j][i] = self.matrix[i][j];
                }
            }
            let product = self.arena.mul(factor, self.right[row]);
            let difference = self.arena.sub(self.right[i], product);
            let entry = self.simplifier.simplify(self.arena, difference);
            self.right[i] = self.named(entry, "r");
        }
    }

    /// Adds the steps of the unknowns, the last pivot's first, each in terms of the unknowns before it.
    fn substitute_back(&mut self, unknowns: &[Expr]) {
        // Term that stands for an unknown in other steps: its symbol, or 0 if its value is 0.
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

/// Divisors in terms: the bases of negative powers, each once.
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
