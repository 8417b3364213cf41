//! Exact proofs of the identities about a model, by normal forms instead of residues modulo primes.

use super::Proof;
use crate::algebra::form::normal_form::{Normalizer, Zero};
use crate::algebra::meaning::compare::{Comparer, Engine};
use crate::algebra::meaning::identity::Identity;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Formulation;

/// Number of multiplications of polynomial terms for the normal form of one identity. Proofs modulo primes are tried
/// first with a fifth of it.
const BUDGET: u64 = 5 * Normalizer::BUDGET;

/// Number of multiplications for all identities of a model together.
const WHOLE_BUDGET: u64 = 100 * Normalizer::BUDGET;

/// Statement of a proof to which identities belong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProvedStatement {
    /// The rows of the first formulation, times multipliers, are the rows of the second one.
    Combination(Formulation, Formulation),
    /// The first integral with this index is constant.
    Integral(usize),
}

/// Identities of one statement of a proof, counted by the way in which they are proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactCount {
    /// Statement to which the identities belong.
    pub statement: ProvedStatement,
    /// Number of identities whose difference has the normal form 0: fractions over the rational numbers, with
    /// s² + c² = 1 for each angle and r² = x for each root.
    pub exact: usize,
    /// Number of identities that are proved modulo primes alone, because their normal form is too long.
    pub open: usize,
}

/// Proves every identity of a proof by its normal form, with a larger budget than [`super::prove`]. Returns a count for
/// each statement.
///
/// The substitutions for constraints are already in the sides of the identities. The cost is limited: an identity whose
/// normal form is too long is counted as open.
#[must_use]
pub fn prove_exactly(arena: &mut Arena, proof: &Proof) -> Vec<ExactCount> {
    let mut tools = ExactProver { angles: Comparer::default(), left: WHOLE_BUDGET };
    let mut counts = Vec::new();
    for combination in proof.pairs.iter().flat_map(|pair| &pair.combinations) {
        let identities = combination.identities.iter().map(|(_, identity)| identity);
        let statement = ProvedStatement::Combination(combination.of, combination.gives);
        counts.push(tools.count(arena, statement, identities));
    }
    for (at, integral) in proof.integrals.iter().enumerate().filter(|(_, integral)| integral.verdict.is_equal()) {
        counts.push(tools.count(arena, ProvedStatement::Integral(at), integral.identities.iter()));
    }
    counts
}

/// Tools for exact proofs, with the budget that is left.
struct ExactProver {
    /// Comparer that expands the angles of sines and cosines.
    angles: Comparer,
    /// Number of multiplications that are left for all identities.
    left: u64,
}

impl ExactProver {
    /// Counts the identities of a statement that are proved exactly, and the others.
    fn count<'a>(
        &mut self,
        arena: &mut Arena,
        statement: ProvedStatement,
        identities: impl Iterator<Item = &'a Identity>,
    ) -> ExactCount {
        let (mut exact, mut open) = (0, 0);
        for identity in identities {
            if self.is_exact(arena, identity) {
                exact += 1;
            } else {
                open += 1;
            }
        }
        ExactCount { statement, exact, open }
    }

    /// True if the two sides of an identity have the same normal form.
    fn is_exact(&mut self, arena: &mut Arena, identity: &Identity) -> bool {
        if identity.engine == Engine::NormalForm {
            return true;
        }
        let difference = arena.sub(identity.left, identity.right);
        if difference == Expr::ZERO {
            return true;
        }
        let difference = self.angles.expand_angles(arena, difference);
        let granted = BUDGET.min(self.left);
        let mut normalizer = Normalizer::new(granted);
        let answer = normalizer.zero_by_normal_form(arena, difference);
        self.left -= granted - normalizer.ring().budget.min(granted);
        matches!(answer, Zero::Yes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    /// Result of the exact proof of left = right, which was proved modulo primes.
    fn is_exact(left: &str, right: &str, budget: u64) -> bool {
        let mut arena = Arena::new();
        let [left, right] = [left, right].map(|text| parse_free(&mut arena, text).unwrap());
        let identity = Identity { left, right, engine: Engine::Modular { exponent: 100.0 } };
        ExactProver { angles: Comparer::default(), left: budget }.is_exact(&mut arena, &identity)
    }

    /// Goal: true identities are proved, and a false one is not, although the identity claims a proof modulo primes.
    #[test]
    fn normal_forms_decide() {
        for (left, right) in [
            ("sin(a + b)^2", "(sin(a)*cos(b) + cos(a)*sin(b))^2"),
            ("1/(1 - sin(q)^2)", "1 + tan(q)^2"),
            ("(x^2 - y^2)/(x - y)", "x + y"),
        ] {
            assert!(is_exact(left, right, WHOLE_BUDGET), "{left} = {right}");
        }
        assert!(!is_exact("sin(q)^2", "1 - cos(q)^3", WHOLE_BUDGET));
    }

    /// Goal: an identity that is too long is open, not proved.
    #[test]
    fn long_identities_are_open() {
        let (left, right) =
            ("(a + b + c + d + e + f)^12*(a - f)", "(a + b + c + d + e + f)^12*a - f*(f + e + d + c + b + a)^12");
        assert!(!is_exact(left, right, 100));
    }
}
