//! Linear forms and linear systems: coefficients of given symbols in an expression, and exact
//! solution by elimination.

use super::pivot_values::PivotValues;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Differential, Gradient, Substitution};
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Function, Node};

/// Error: an expression is not linear in the given symbols.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NotLinear {
    /// Symbol in which the expression is not linear.
    pub symbol: Expr,
    /// Coefficient of the symbol, which depends on the symbols though it should not. It may also be
    /// the whole expression.
    pub coefficient: Expr,
}

/// Splitter of expressions into linear forms in fixed symbols. Reuse a value for many expressions.
pub struct LinearForm {
    /// Symbols in which expressions are split into linear forms.
    symbols: Vec<Expr>,
    /// Derivatives of expressions with respect to all symbols, computed in one pass.
    gradient: Gradient,
    /// Partial derivative operator for each symbol, for expressions that are not linear by form.
    partials: Vec<Differential>,
    /// Substitution of 0 for all symbols, which gives the rest of a linear form.
    at_zero: Substitution,
}

impl LinearForm {
    /// Creates a splitter into linear forms in the given symbols.
    #[must_use]
    pub fn new(symbols: &[Expr]) -> Self {
        let zeros: Vec<_> = symbols.iter().map(|s| (*s, Expr::ZERO)).collect();
        Self {
            symbols: symbols.to_vec(),
            gradient: Gradient::new(symbols),
            partials: symbols.iter().map(|s| Differential::partial(*s)).collect(),
            at_zero: Substitution::new(&zeros),
        }
    }

    /// Symbols in which expressions are split into linear forms, in order.
    #[must_use]
    pub fn symbols(&self) -> &[Expr] {
        &self.symbols
    }

    /// Splits an expression e into the linear form e = Σ coefficientᵢ · symbolᵢ + rest. Returns the
    /// coefficients, in the order of the symbols, and the rest.
    ///
    /// # Errors
    /// [`NotLinear`] if the expression is not linear in the symbols, in whatever form it is
    /// written.
    pub fn coefficients(&mut self, arena: &mut Arena, e: Expr) -> Result<(Vec<Expr>, Expr), NotLinear> {
        let parts = arena.reachable(&[e]);
        if !self.symbols.iter().any(|s| parts.binary_search(s).is_ok()) {
            return Ok((vec![Expr::ZERO; self.symbols.len()], e));
        }
        if let Some(form) = self.coefficients_by_form(arena, e, &parts) {
            return Ok(form);
        }
        self.coefficients_by_zero_tests(arena, e)
    }

    /// Splits an expression that is linear by form: its derivatives and the rest contain none of
    /// the symbols. `None` if this is not so, or if the expression contains a sign function, which
    /// has no derivative at its jump.
    fn coefficients_by_form(&mut self, arena: &mut Arena, e: Expr, parts: &[Expr]) -> Option<(Vec<Expr>, Expr)> {
        if parts.iter().any(|part| matches!(arena.node(*part), Node::Apply(Function::Sign, _))) {
            return None;
        }
        let mut coefficients = vec![Expr::ZERO; self.symbols.len()];
        let slopes = self.gradient.apply(arena, e);
        for (at, slope) in slopes.iter() {
            coefficients[*at] = *slope;
        }
        let rest = self.at_zero.apply(arena, e);
        let left = arena.reachable(&[&coefficients[..], &[rest]].concat());
        let mentioned = self.symbols.iter().any(|s| left.binary_search(s).is_ok());
        (!mentioned).then_some((coefficients, rest))
    }

    /// Splits an expression that is linear only after simplification, as zero tests prove. Error if
    /// it is not linear.
    fn coefficients_by_zero_tests(&mut self, arena: &mut Arena, e: Expr) -> Result<(Vec<Expr>, Expr), NotLinear> {
        let mut coefficients = Vec::with_capacity(self.symbols.len());
        for at in 0..self.symbols.len() {
            let slope = self.partials[at].apply(arena, e);
            for other in 0..self.symbols.len() {
                let second = self.partials[other].apply(arena, slope);
                if zero_test(arena, second) != ZeroTest::Zero {
                    return Err(NotLinear { symbol: self.symbols[at], coefficient: slope });
                }
            }
            // u| has the second derivative 0 but is not linear: its derivative sign(u) differs from that at 0.
            let at_zero = self.at_zero.apply(arena, slope);
            let change = arena.sub(slope, at_zero);
            if zero_test(arena, change) != ZeroTest::Zero {
                return Err(NotLinear { symbol: self.symbols[at], coefficient: slope });
            }
            coefficients.push(at_zero);
        }
        let rest = self.at_zero.apply(arena, e);
        // Decisive test: the linear form must equal the expression. Derivatives alone do not show
        // jumps such as sign(u).
        let mut terms: Vec<Expr> = coefficients.iter().zip(&self.symbols).map(|(c, s)| arena.mul(*c, *s)).collect();
        terms.push(rest);
        let form = arena.sum(&terms);
        let difference = arena.sub(e, form);
        let left = arena.reachable(&[&coefficients[..], &[rest]].concat());
        let mentioned = self.symbols.iter().find(|s| left.binary_search(s).is_ok());
        if mentioned.is_some() || zero_test(arena, difference) != ZeroTest::Zero {
            let symbol = mentioned.copied().unwrap_or(self.symbols[0]);
            return Err(NotLinear { symbol, coefficient: e });
        }
        Ok((coefficients, rest))
    }
}

/// Writes a row of a linear system as the term Σ entry · unknown − right, which is 0 in a solution.
/// The last entry of the row is the right-hand side.
pub fn linear_row_term(arena: &mut Arena, unknowns: &[Expr], row: &[Expr]) -> Expr {
    let mut terms: Vec<Expr> = row.iter().zip(unknowns).map(|(a, x)| arena.mul(*a, *x)).collect();
    terms.push(arena.neg(row[row.len() - 1]));
    arena.sum(&terms)
}

/// Error: the matrix of a linear system does not have full rank.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Singular {
    /// Number of independent rows of the singular matrix.
    pub rank: usize,
    /// Index of the first row of the matrix that depends on the rows before it.
    pub row: usize,
}

/// Solves A X = B exactly, for a square matrix A (n × n) and several right-hand sides, the columns
/// of B. Returns X by rows, and the pivots, which are its divisors.
///
/// The method is Gaussian elimination. An entry that the zero test finds identically zero is never
/// a pivot. Plain numbers are taken first, then short terms, so that divisors stay simple. Entries
/// are simplified as they are formed.
///
/// # Errors
/// [`Singular`] if A is singular for all values of its symbols.
pub fn solve_linear(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    a: &[Vec<Expr>],
    b: &[Vec<Expr>],
) -> Result<(Vec<Vec<Expr>>, Vec<Expr>), Singular> {
    solve_linear_near(arena, simplifier, a, b, None)
}

/// Solves A X = B as [`solve_linear`] does. If `point` is given, no pivot is small at this point beside the entries of
/// its row, so that the solution has values there if A is regular there.
///
/// # Errors
/// [`Singular`] if A is singular for all values of its symbols.
pub fn solve_linear_near(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    a: &[Vec<Expr>],
    b: &[Vec<Expr>],
    point: Option<&PivotValues>,
) -> Result<(Vec<Vec<Expr>>, Vec<Expr>), Singular> {
    let n = a.len();
    let mut rows: Vec<Vec<Expr>> = a.iter().zip(b).map(|(l, r)| [l.as_slice(), r].concat()).collect();
    let (mut pivots, mut used, mut order) = (Vec::new(), vec![false; n], Vec::new());
    for _ in 0..n {
        let Some((row, column)) = simplest_linear_pivot(arena, &rows, &used, &order, n, point)
            .or_else(|| simplest_linear_pivot(arena, &rows, &used, &order, n, None))
        else {
            let row = (0..n).find(|r| !used[*r]).unwrap_or(n);
            return Err(Singular { rank: order.len(), row });
        };
        used[row] = true;
        order.push((row, column));
        let pivot = rows[row][column];
        pivots.push(pivot);
        for entry in &mut rows[row] {
            let quotient = arena.div(*entry, pivot).expect("a pivot is not zero");
            *entry = simplifier.simplify(arena, quotient);
        }
        let pivot_row = rows[row].clone();
        for (other, target) in rows.iter_mut().enumerate() {
            let factor = target[column];
            if other == row || factor == Expr::ZERO {
                continue;
            }
            for (entry, &p) in target.iter_mut().zip(&pivot_row) {
                let product = arena.mul(factor, p);
                let difference = arena.sub(*entry, product);
                *entry = simplifier.simplify(arena, difference);
            }
        }
    }
    let mut x = vec![Vec::new(); n];
    for (row, column) in order {
        x[column] = rows[row][n..].to_vec();
    }
    Ok((x, pivots))
}

/// Determinant of a square matrix, simplified; 0 if the matrix is singular for all values of its
/// symbols.
///
/// The method is elimination with simple pivots, as in [`solve_linear`]; their divisions cancel in the
/// product.
pub fn determinant(arena: &mut Arena, simplifier: &mut Simplifier, a: &[Vec<Expr>]) -> Expr {
    let n = a.len();
    let mut rows = a.to_vec();
    let (mut used, mut order, mut product) = (vec![false; n], Vec::new(), Expr::ONE);
    for _ in 0..n {
        let Some((row, column)) = simplest_linear_pivot(arena, &rows, &used, &order, n, None) else {
            return Expr::ZERO;
        };
        used[row] = true;
        order.push((row, column));
        let pivot = rows[row].clone();
        product = arena.mul(product, pivot[column]);
        for (at, target) in rows.iter_mut().enumerate().filter(|(at, _)| !used[*at]) {
            debug_assert_ne!(at, row, "the pivot row is used");
            let factor = target[column];
            if factor == Expr::ZERO {
                continue;
            }
            let factor = arena.div(factor, pivot[column]).expect("a pivot is not zero");
            for (entry, &p) in target.iter_mut().zip(&pivot) {
                let share = arena.mul(factor, p);
                let difference = arena.sub(*entry, share);
                *entry = simplifier.simplify(arena, difference);
            }
        }
    }
    let product = simplifier.simplify(arena, product);
    if is_odd(&order) { arena.neg(product) } else { product }
}

/// True if the pairs (row, column) are an odd permutation. The determinant then has the opposite
/// sign of the product of its pivots.
fn is_odd(order: &[(usize, usize)]) -> bool {
    let inversions = |list: Vec<usize>| {
        (0..list.len()).map(|i| list[i + 1..].iter().filter(|later| **later < list[i]).count()).sum::<usize>()
    };
    let rows = inversions(order.iter().map(|(r, _)| *r).collect());
    let columns = inversions(order.iter().map(|(_, c)| *c).collect());
    (rows + columns) % 2 == 1
}

/// Row and column of the next pivot: the simplest entry that is not identically zero by the zero test, and not small at
/// `point`, if it is given. Rows and columns that have a pivot already are left out. `None` if there is no such entry.
fn simplest_linear_pivot(
    arena: &Arena,
    rows: &[Vec<Expr>],
    used: &[bool],
    order: &[(usize, usize)],
    n: usize,
    point: Option<&PivotValues>,
) -> Option<(usize, usize)> {
    let mut best: Option<(usize, usize, usize)> = None;
    let columns: Vec<usize> = (0..n).filter(|c| !order.iter().any(|(_, column)| column == c)).collect();
    let large = point.map(|point| point.large_entries(arena, rows, &columns));
    for (r, row) in rows.iter().enumerate().filter(|(r, _)| !used[*r]) {
        for &c in &columns {
            let entry = row[c];
            if entry == Expr::ZERO || large.as_ref().is_some_and(|large| !large[r][c]) {
                continue;
            }
            let cost = if arena.as_number(entry).is_some() { 0 } else { arena.reachable(&[entry]).len() };
            if best.is_none_or(|(least, _, _)| cost < least) && zero_test(arena, entry) != ZeroTest::Zero {
                best = Some((cost, r, c));
            }
        }
    }
    best.map(|(_, r, c)| (r, c))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    fn form(text: &str) -> Result<(Vec<Expr>, Expr), NotLinear> {
        let mut arena = Arena::new();
        let symbols = ["u", "v"].map(|name| arena.symbol(name));
        let e = parse_free(&mut arena, text).unwrap();
        LinearForm::new(&symbols).coefficients(&mut arena, e)
    }

    #[test]
    fn what_is_linear_by_form_or_by_meaning_has_coefficients() {
        for text in
            ["m*u*sin(q) + (u - v)*g + 1", "u*(cos(u)^2 + sin(u)^2)", "(u + v)^2 - u^2 - 2*u*v - v^2 + u", "sign(q)*u"]
        {
            assert!(form(text).is_ok(), "{text}");
        }
    }

    /// Terms with kinks or jumps are not linear, even if their slope is constant elsewhere.
    #[test]
    fn what_bends_or_jumps_has_none() {
        for text in ["u*v", "sin(u)", "u + sign(u)", "abs(u)", "m*u/(1 + v^2)"] {
            assert!(form(text).is_err(), "{text}");
        }
    }
}
