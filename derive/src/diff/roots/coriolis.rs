//! Tracing of wrong entries of the matrix C in M q̈ + C q̇ + g = τ, between the row with a wrong entry and wrong
//! statements about the entry.

use super::root::DependenceKind;
use super::source_search::DependenceReason;
use crate::algebra::value::zero_test::{ZeroTest, zero_test};
use crate::algebra::{Arena, Expr, Rational};
use crate::diff::equations::claim::Claim;
use crate::diff::formulas::finding::Finding;
use crate::mechanics::{QuantityKind, RowQuantity};

/// Traces wrong statements about an entry of C to the wrong row of C q̇ that has the same wrong entry. `rates` are the
/// symbols q̇. The links found are written to `reasons`, which has one item for each wrong entry.
pub fn link_coriolis_entries(
    arena: &mut Arena,
    rates: &[Expr],
    stated: &[&Claim],
    wrong: &[&Finding],
    reasons: &mut [Option<DependenceReason>],
) {
    let kind = |at: usize| match stated[at] {
        Claim::Value { kind, .. } => Some(kind),
        _ => None,
    };
    for at in 0..stated.len() {
        let (Some(difference), None) = (wrong[at].difference, &reasons[at]) else { continue };
        // An entry on the diagonal counts twice in C + Cᵀ.
        let (entries, times) = match kind(at) {
            Some(QuantityKind::Christoffel(i, j)) => (vec![(*i, *j)], 1),
            Some(QuantityKind::MassRate(i, j)) if i == j => (vec![(*i, *j)], 2),
            Some(QuantityKind::MassRate(i, j)) => (vec![(*i, *j), (*j, *i)], 1),
            _ => continue,
        };
        let source = (0..at).find(|source| {
            let Some(QuantityKind::Row(RowQuantity::VelocityTerms, row)) = kind(*source) else { return false };
            let Some(of_row) = wrong[*source].difference else { return false };
            entries.iter().filter(|(i, _)| i == row).any(|(_, j)| {
                let own = arena.mul(difference, rates[*j]);
                let rest = arena.linear_combination(&[(of_row, Rational::integer(times)), (own, Rational::MINUS_ONE)]);
                zero_test(arena, rest) == ZeroTest::Zero
            })
        });
        if let Some(source) = source {
            reasons[at] = Some(DependenceReason::new(DependenceKind::Repeated, vec![source]));
        }
    }
}
