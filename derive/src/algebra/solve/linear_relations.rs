//! Linear relations with constant coefficients between expressions, found exactly by the normal
//! form.

use super::linear::solve_linear;
use crate::algebra::form::fraction::over_common_denominator;
use crate::algebra::form::normal_form::Normalizer;
use crate::algebra::form::ring_polynomial::{Powers, RingPolynomial};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::value::rank::pivot_rows_and_columns;
use crate::algebra::{Arena, Expr};
use rustc_hash::FxHashMap;

/// Finds all linear relations Σ cₖ eₖ = 0 between the expressions eₖ of `list`. Returns a basis of
/// the vectors c, whose entries contain no symbols except `constants`.
///
/// The expressions are brought over a common denominator. Each monomial in the other symbols gives
/// one linear equation for c. Independence of the chosen equations is tested modulo a random prime,
/// so the caller must prove the relations.
///
/// `None` if an expression has no normal form within the budget.
pub fn linear_relations(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    normalizer: &mut Normalizer,
    list: &[Expr],
    constants: &[Expr],
) -> Option<Vec<Vec<Expr>>> {
    let mut matrix = coefficients(arena, normalizer, list, constants)?;
    matrix.sort_by_key(|row| arena.reachable(row).len());
    matrix.dedup();
    let forced = forced_relation_zeros(&mut matrix, list.len());
    let (rows, columns) =
        if matrix.is_empty() { (Vec::new(), Vec::new()) } else { pivot_rows_and_columns(arena, &matrix)? };
    let free: Vec<usize> = (0..list.len()).filter(|c| !columns.contains(c) && !forced[*c]).collect();
    let solved = if rows.is_empty() || free.is_empty() {
        Vec::new()
    } else {
        let a: Vec<Vec<Expr>> = rows.iter().map(|r| columns.iter().map(|c| matrix[*r][*c]).collect()).collect();
        let b: Vec<Vec<Expr>> = rows.iter().map(|r| free.iter().map(|c| arena.neg(matrix[*r][*c])).collect()).collect();
        solve_linear(arena, simplifier, &a, &b).ok()?.0
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

/// Finds the coefficients of a relation that must be zero: those that are the only entry of an
/// equation (a row). Their columns are set to 0, and empty rows are removed. This is repeated until
/// nothing changes. Returns true for each coefficient that must be zero.
fn forced_relation_zeros(matrix: &mut Vec<Vec<Expr>>, columns: usize) -> Vec<bool> {
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

/// Matrix of the linear equations for the coefficients of a relation. It has a row for each
/// monomial in symbols that are not constant, and a column for each expression. `None` if the
/// budget of multiplications is used up.
fn coefficients(
    arena: &mut Arena,
    normalizer: &mut Normalizer,
    list: &[Expr],
    constants: &[Expr],
) -> Option<Vec<Vec<Expr>>> {
    // All angles are prepared first, because finer base angles would invalidate earlier normal
    // forms.
    normalizer.prepare(arena, list);
    let forms: Option<Vec<_>> = list.iter().map(|e| normalizer.normal_form(arena, *e)).collect();
    let numerators = over_common_denominator(normalizer.ring(), &forms?)?;
    let constant_generators = normalizer.generators_in(arena, constants);
    let mut rows: FxHashMap<Powers, usize> = FxHashMap::default();
    let mut entries: Vec<Vec<RingPolynomial>> = Vec::new();
    for (column, numerator) in numerators.iter().enumerate() {
        for (powers, k) in &numerator.terms {
            let (constant, rest) = powers.split(&constant_generators);
            let row = *rows.entry(rest).or_insert_with(|| {
                entries.push(vec![RingPolynomial::default(); list.len()]);
                entries.len() - 1
            });
            entries[row][column].terms.push((constant, k.clone()));
        }
    }
    let expression = |arena: &mut Arena, p: &RingPolynomial| normalizer.polynomial(p).expand(arena);
    Some(entries.iter().map(|row| row.iter().map(|p| expression(arena, p)).collect()).collect())
}
