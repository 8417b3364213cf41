//! Test that the steps and values after sharing are the same functions of the inputs as before.

use super::SharedComputation;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::{Definition, substitute_steps};
use crate::algebra::value::residues::PointWithResidues;
use crate::algebra::{Arena, Expr};

/// True if every value, and every step that keeps its symbol, is the same function of the inputs
/// before and after sharing.
///
/// The terms before and after are evaluated at a random point modulo a random prime. A difference
/// is overlooked with a probability below the degree of the terms divided by 2^60. False also if no
/// point was found at which all terms have a value.
#[must_use]
pub fn is_equivalent_after_sharing(
    arena: &mut Arena,
    steps: &[Definition],
    values: &[Expr],
    shared: &SharedComputation,
) -> bool {
    let symbols: Vec<Expr> = shared.steps.iter().map(|step| step.symbol).collect();
    let kept: Vec<Expr> = steps.iter().map(|step| step.symbol).filter(|symbol| symbols.contains(symbol)).collect();
    let mut terms = Vec::with_capacity(2 * (kept.len() + values.len()));
    for (steps, values) in [(steps, values), (&shared.steps, &shared.values)] {
        let mut put = Substitution::default();
        substitute_steps(arena, &mut put, steps);
        terms.extend(put.all(arena, &kept));
        terms.extend(put.all(arena, values));
    }
    let (before, after) = terms.split_at(kept.len() + values.len());
    before == after
        || PointWithResidues::new(arena, &terms)
            .is_some_and(|(_, residues)| residues[..before.len()] == residues[after.len()..])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::form::sharing::{SharingOptions, share_common_parts};
    use crate::algebra::form::simplify::Simplifier;
    use crate::algebra::text::parse::parse_free;

    #[test]
    fn what_sharing_makes_is_the_same_and_another_value_is_not() {
        for reading in SharingOptions::ALL {
            let mut arena = Arena::new();
            let values = ["a*b*sin(q + p) + a*c*sin(q + p)", "(a*b + a*c)^2 - sin(q)^2"]
                .map(|text| parse_free(&mut arena, text).unwrap());
            let Some(mut shared) = share_common_parts(&mut arena, &mut Simplifier::default(), reading, &[], &values)
            else {
                continue;
            };
            assert!(is_equivalent_after_sharing(&mut arena, &[], &values, &shared), "{reading:?}");
            shared.values[1] = arena.add(shared.values[1], Expr::ONE);
            assert!(!is_equivalent_after_sharing(&mut arena, &[], &values, &shared), "{reading:?}");
        }
    }
}
