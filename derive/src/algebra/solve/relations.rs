//! Linear relations with constant coefficients between expressions: exact, and decidable by the normal form.

use super::linear::solve;
use crate::algebra::form::fraction::over_common_denominator;
use crate::algebra::form::normal::Normalizer;
use crate::algebra::form::ring::{Poly, Powers};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::value::rank::echelon;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;

/// Basis of all vectors c with Σ c_k e_k = 0 identically, where e_k are the expressions of `list`, and c depends on no
/// symbols but `constants`.
///
/// The expressions are brought over one denominator. Each monomial in the other symbols gives one linear equation for
/// c. Independence of the chosen equations is tested modulo a random prime. The caller must prove that the vectors are
/// relations. `None` if an expression has no normal form within the budget.
pub fn relations(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    normalizer: &mut Normalizer,
    list: &[Expr],
    constants: &[Expr],
) -> Option<Vec<Vec<Expr>>> {
    let mut matrix = coefficients(arena, normalizer, list, constants)?;
    matrix.sort_by_key(|row| arena.reachable(row).len());
    matrix.dedup();
    let forced = forced_zeros(&mut matrix, list.len());
    let (rows, columns) = if matrix.is_empty() { (Vec::new(), Vec::new()) } else { echelon(arena, &matrix)? };
    let free: Vec<usize> = (0..list.len()).filter(|c| !columns.contains(c) && !forced[*c]).collect();
    let solved = if rows.is_empty() || free.is_empty() {
        Vec::new()
    } else {
        let a: Vec<Vec<Expr>> = rows.iter().map(|r| columns.iter().map(|c| matrix[*r][*c]).collect()).collect();
        let b: Vec<Vec<Expr>> = rows.iter().map(|r| free.iter().map(|c| arena.neg(matrix[*r][*c])).collect()).collect();
        solve(arena, simplifier, &a, &b).ok()?.0
    };
    let mut basis = Vec::new();
    for (k, &column) in free.iter().enumerate() {
        let mut vector = vec![Expr::ZERO; list.len()];
        vector[column] = Expr::ONE;
        for (row, &pivot) in solved.iter().zip(&columns) {
            vector[pivot] = row[k];
        }
        basis.push(vector);
    }
    Some(basis)
}

/// Marks the coefficients that a row with a single entry makes zero, repeatedly. These rows and columns are cleared,
/// which leaves little to eliminate.
fn forced_zeros(matrix: &mut Vec<Vec<Expr>>, columns: usize) -> Vec<bool> {
    let mut forced = vec![false; columns];
    loop {
        let mut changed = false;
        for row in &mut *matrix {
            let mut entries = (0..columns).filter(|c| row[*c] != Expr::ZERO);
            if let (Some(only), None) = (entries.next(), entries.next()) {
                forced[only] = true;
                changed = true;
            }
            for (entry, zero) in row.iter_mut().zip(&forced) {
                if *zero {
                    *entry = Expr::ZERO;
                }
            }
        }
        matrix.retain(|row| row.iter().any(|e| *e != Expr::ZERO));
        if !changed {
            return forced;
        }
    }
}

/// Matrix of the equations for the coefficients: a row for each monomial in symbols that are not constant, a column for
/// each expression. `None` beyond the budget.
fn coefficients(
    arena: &mut Arena,
    normalizer: &mut Normalizer,
    list: &[Expr],
    constants: &[Expr],
) -> Option<Vec<Vec<Expr>>> {
    // All angles first: finer base angles would make earlier forms void.
    normalizer.prepare(arena, list);
    let forms: Option<Vec<_>> = list.iter().map(|e| normalizer.fraction(arena, *e)).collect();
    let numerators = over_common_denominator(normalizer.ring(), &forms?)?;
    let constant_generators = normalizer.generators_in(arena, constants);
    let mut rows: FxHashMap<Powers, usize> = FxHashMap::default();
    let mut entries: Vec<Vec<Poly>> = Vec::new();
    for (column, numerator) in numerators.iter().enumerate() {
        for (powers, k) in &numerator.terms {
            let (constant, rest) = powers.split(&constant_generators);
            let row = *rows.entry(rest).or_insert_with(|| {
                entries.push(vec![Poly::default(); list.len()]);
                entries.len() - 1
            });
            entries[row][column].terms.push((constant, k.clone()));
        }
    }
    let expression = |arena: &mut Arena, p: &Poly| normalizer.polynomial(p).expand(arena);
    Some(entries.iter().map(|row| row.iter().map(|p| expression(arena, p)).collect()).collect())
}
