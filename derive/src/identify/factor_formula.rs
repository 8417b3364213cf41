//! Formulas for factors in known parameters, found from their residues modulo a prime. A formula is
//! a sum of products of lengths, and of sines and cosines of constant angles. The coefficients are
//! rational or, if square roots occur, a + b √n with rational a and b.
//!
//! The unit of a factor excludes most products. A formula must agree with the residues at more
//! points than it has unknown coefficients. It is proved afterwards.

use super::BaseParameterFactor;
use super::column_relations::{ColumnRelations, RelationResidues};
use super::known_parameters::{KnownParameters, PowerProduct, STAGES};
use crate::algebra::value::field::Field;
use crate::algebra::value::rank::unique_solution;
use crate::algebra::value::reconstruction::{reconstruct_rational, reconstruct_surd};
use crate::algebra::{Arena, Expr, Function};
use crate::mechanics::Column;
use crate::model::Unit;
use rustc_hash::FxHashSet;

/// Number of random points at which factors are evaluated before the search for formulas.
const FIRST: usize = 6;
/// Number of points, in addition to the number of unknown coefficients, at which a formula must
/// agree with the residues.
const BEYOND: usize = 4;
/// Value of a product of powers of atoms modulo a prime, from the residues of the atoms. `None` if
/// it divides by zero.
fn product_residue(f: Field, atoms: &[u64], powers: &PowerProduct) -> Option<u64> {
    powers.iter().try_fold(1, |product, (at, n)| Some(f.mul(product, f.signed_power(atoms[*at], *n)?)))
}

/// Dependent column of a regressor as a sum of pivot columns: the index of the column, and pairs
/// (index of a pivot, factor).
pub type DependentColumn = (usize, Vec<(usize, BaseParameterFactor)>);

/// Finds the factors in the sums of pivot columns that give the dependent columns of a regressor. A
/// factor is a formula if one is found, else unknown.
pub fn factor_formulas(
    table: &mut ColumnRelations<'_>,
    arena: &mut Arena,
    letters: &KnownParameters,
    columns: &[Column],
) -> Vec<DependentColumn> {
    let Some(mut known) = FactorResidues::new(table, letters) else {
        let unknown = |support: &[usize]| support.iter().map(|pivot| (*pivot, BaseParameterFactor::Unknown)).collect();
        return table.dependent.iter().map(|(column, support)| (*column, unknown(support))).collect();
    };
    let mut made = Vec::new();
    for (k, (column, support)) in table.dependent.clone().into_iter().enumerate() {
        let mut list = Vec::new();
        for (i, pivot) in support.into_iter().enumerate() {
            let unit = columns[table.pivots[pivot]].unit.divided_by(&columns[column].unit);
            let factor = known.formula(table, arena, letters, Entry { k, i }, &unit);
            if factor != BaseParameterFactor::Exact(Expr::ZERO) {
                list.push((pivot, factor));
            }
        }
        made.push((column, list));
    }
    made
}

/// Position of a factor in the factors of all dependent columns.
#[derive(Clone, Copy)]
struct Entry {
    /// Index of the column in the list of dependent columns.
    k: usize,
    /// Index of the factor in the list of the column's factors.
    i: usize,
}

/// Residues of the factors at random points. A point is one choice of random values for the known
/// parameters.
struct FactorResidues {
    /// Residues at points where all parameters have random values, one row for each point.
    rows: Vec<RelationResidues>,
    /// Residues at the first point with the value of one parameter changed, with one row for each
    /// parameter.
    beside: Vec<RelationResidues>,
}

impl FactorResidues {
    /// Evaluates the factors at the first points; `None` if the factors have no values at a point.
    fn new(table: &mut ColumnRelations<'_>, letters: &KnownParameters) -> Option<Self> {
        let first = table.seed();
        let mut rows = vec![table.relation_factors_at(first, None)?];
        while rows.len() < FIRST {
            let seed = table.seed();
            rows.push(table.relation_factors_at(seed, None)?);
        }
        let elsewhere = table.seed();
        let beside = letters.list.iter().map(|letter| {
            let moved = FxHashSet::from_iter([letter.symbol]);
            table.relation_factors_at(first, Some((&moved, elsewhere)))
        });
        let beside = beside.collect::<Option<Vec<_>>>()?;
        Some(Self { rows, beside })
    }

    /// Searches a formula for a factor, stage by stage. Returns `BaseParameterFactor::Unknown` if
    /// no stage finds a formula.
    fn formula(
        &mut self,
        table: &mut ColumnRelations<'_>,
        arena: &mut Arena,
        letters: &KnownParameters,
        entry: Entry,
        unit: &Unit,
    ) -> BaseParameterFactor {
        let Entry { k, i } = entry;
        let here = self.rows[0].factors[k][i];
        let depends: Vec<usize> = (0..letters.list.len()).filter(|at| self.beside[*at].factors[k][i] != here).collect();
        for stage in STAGES {
            let products = letters.products(&depends, unit, stage);
            if products.is_empty() {
                continue;
            }
            while self.rows.len() < products.len() + BEYOND {
                let seed = table.seed();
                let Some(row) = table.relation_factors_at(seed, None) else { return BaseParameterFactor::Unknown };
                self.rows.push(row);
            }
            let f = table.field();
            if let Some(found) = self.formula_coefficients(f, &products, entry)
                && let Some(formula) = formula_of(arena, letters, f, products.iter().zip(found))
            {
                return BaseParameterFactor::Exact(formula);
            }
        }
        BaseParameterFactor::Unknown
    }

    /// Coefficients, as residues, with which the sum of the given products equals a factor at all
    /// points. `None` if there are no such coefficients, or if they are not unique.
    fn formula_coefficients(&self, f: Field, products: &[PowerProduct], entry: Entry) -> Option<Vec<u64>> {
        let Entry { k, i } = entry;
        let rows: Option<Vec<Vec<u64>>> = self
            .rows
            .iter()
            .map(|row| {
                let values: Option<Vec<u64>> =
                    products.iter().map(|powers| product_residue(f, &row.atoms, powers)).collect();
                Some(values?.into_iter().chain([row.factors[k][i]]).collect())
            })
            .collect();
        unique_solution(f, rows?)
    }
}

/// Builds a formula from products and the residues of their coefficients. `None` if a residue is
/// not that of a simple number.
fn formula_of<'p>(
    arena: &mut Arena,
    letters: &KnownParameters,
    f: Field,
    products: impl Iterator<Item = (&'p PowerProduct, u64)>,
) -> Option<Expr> {
    let mut terms = Vec::new();
    for (powers, residue) in products.filter(|(_, residue)| *residue != 0) {
        let term = letters.term(arena, powers)?;
        if let Some(k) = reconstruct_rational(f, residue) {
            terms.push((term, k));
            continue;
        }
        let (a, n, b) = if letters.has_roots { reconstruct_surd(f, residue)? } else { return None };
        let n = arena.integer(n);
        let root = arena.apply(Function::Sqrt, n);
        terms.extend([(term, a), (arena.mul(term, root), b)]);
    }
    Some(arena.linear_combination(&terms))
}
