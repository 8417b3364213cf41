//! Proof that the base parameters are complete: M u̇ − f minus the sum over the columns of the base
//! parameters is zero.

use super::{BaseParameter, BaseParameterFactor, Completeness};
use crate::algebra::Expr;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::zero_test::{ZeroTest, bounded_zero_test};
use crate::mechanics::Regressor;

/// Proves two statements at once. First, each dependent column is the stated sum of base columns,
/// so Σ π_k Y_k = Σ π_b Y_b for all values of the parameters π. Second, M u̇ − f by Kane's method
/// is Σ π_b Y_b + rest, with the parameters π of the model.
///
/// Each entry is multiplied by a new symbol of its own, so that the sum of all is zero only if each
/// entry is zero.
pub fn prove_base_parameters(regressor: &mut Regressor, base: &[BaseParameter]) -> Completeness {
    let Regressor { arena, columns, rest, required, .. } = regressor;
    let values: Vec<Expr> = (0..columns.len()).map(|at| fresh_symbol(arena, &format!("pi_{at}"))).collect();
    let factor =
        |factor: &BaseParameterFactor| if let BaseParameterFactor::Exact(e) = factor { *e } else { Expr::ZERO };
    let of_base = |arena: &mut crate::algebra::Arena, values: &[Expr]| -> Vec<Expr> {
        base.iter()
            .map(|base| {
                let mut terms = vec![values[base.column]];
                terms.extend(base.with.iter().map(|(at, k)| arena.mul(values[*at], factor(k))));
                arena.sum(&terms)
            })
            .collect()
    };
    let general = of_base(arena, &values);
    let stated: Vec<Expr> = columns.iter().map(|column| column.stated).collect();
    let stated = of_base(arena, &stated);
    let mut all = Vec::new();
    for row in 0..required.len() {
        let [first, second] = ["first", "second"].map(|side| fresh_symbol(arena, &format!("{side}_{row}")));
        let whole: Vec<Expr> =
            columns.iter().zip(&values).map(|(column, pi)| arena.mul(column.forces[row], *pi)).collect();
        let whole = arena.sum(&whole);
        let mut sum = |values: &[Expr]| {
            let terms: Vec<Expr> =
                base.iter().zip(values).map(|(base, pi)| arena.mul(columns[base.column].forces[row], *pi)).collect();
            arena.sum(&terms)
        };
        let (by_base, by_model) = (sum(&general), sum(&stated));
        let grouped = arena.sub(whole, by_base);
        let by_model = arena.add(by_model, rest[row]);
        let completed = arena.sub(required[row], by_model);
        all.extend([(first, grouped), (second, completed)].map(|(letter, e)| arena.mul(letter, e)));
    }
    let total = arena.sum(&all);
    match bounded_zero_test(arena, total) {
        (ZeroTest::Zero, bound) => Completeness::Proved(bound),
        (ZeroTest::Undecided, _) => Completeness::Undecided,
        (ZeroTest::NonZero, _) => Completeness::No,
    }
}
