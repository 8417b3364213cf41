//! Verdict on many comparisons of terms at once.

use crate::algebra::meaning::compare::{Comparer, Engine, Verdict};
use crate::algebra::meaning::identity::Identity;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::zero_test::{ZeroTest, bounded_zero_test};
use crate::algebra::{Arena, Expr};

/// Limit on the product of the number of pairs and the number of their terms. Above it, all pairs
/// are compared in a single sum.
const MOST_SINGLE: usize = 2_000_000;

/// Result of the comparison of many pairs of terms: a verdict, and identities.
#[derive(Clone, Debug)]
pub struct Compared {
    /// Verdict on the claim that the two terms are equal in every pair.
    pub verdict: Verdict,
    /// Identities of the pairs, in their order; empty unless all pairs are equal.
    pub identities: Vec<Identity>,
}

/// Compares the two terms of every pair, and gives a single verdict.
///
/// In large systems, whose entries share most subterms, all pairs are compared at once. With the
/// differences d_i and a new symbol w_i for each, the sum Σ w_i d_i is zero if and only if all d_i
/// are zero.
pub fn verdict_on_pairs(arena: &mut Arena, comparer: &mut Comparer, pairs: &[(Expr, Expr)]) -> Compared {
    let differences: Vec<Expr> = pairs.iter().map(|(left, right)| arena.sub(*left, *right)).collect();
    let differences: Vec<Expr> = differences.into_iter().filter(|e| *e != Expr::ZERO).collect();
    if differences.len() * arena.reachable(&differences).len() > MOST_SINGLE {
        let weighted: Vec<Expr> = differences
            .iter()
            .enumerate()
            .map(|(at, e)| {
                let weight = fresh_symbol(arena, &format!("weight_{at}"));
                arena.mul(weight, *e)
            })
            .collect();
        let sum = arena.sum(&weighted);
        let sum = comparer.expand_angles(arena, sum);
        if let (ZeroTest::Zero, exponent) = bounded_zero_test(arena, sum) {
            let engine = |same: bool| if same { Engine::NormalForm } else { Engine::Modular { exponent } };
            let identity = |(left, right): &(Expr, Expr)| {
                let same = arena.sub(*left, *right) == Expr::ZERO;
                Identity { left: *left, right: *right, engine: engine(same) }
            };
            let identities = pairs.iter().map(identity).collect();
            return Compared { verdict: Verdict::Equal(Engine::Modular { exponent }), identities };
        }
    }
    let mut identities = Vec::with_capacity(pairs.len());
    for (left, right) in pairs {
        match comparer.compare(arena, *left, *right) {
            Verdict::Equal(engine) => identities.push(Identity { left: *left, right: *right, engine }),
            verdict => return Compared { verdict, identities: Vec::new() },
        }
    }
    let verdict = combined_verdict(identities.iter().map(|identity| Verdict::Equal(identity.engine)));
    Compared { verdict, identities }
}

/// Combines verdicts: the first verdict other than "equal", else "equal" by the engine with the
/// largest error bound.
pub fn combined_verdict(verdicts: impl IntoIterator<Item = Verdict>) -> Verdict {
    let mut engine = Engine::NormalForm;
    for verdict in verdicts {
        match verdict {
            Verdict::Equal(Engine::Modular { exponent }) => {
                let weakest = match engine {
                    Engine::Modular { exponent: other } => exponent.min(other),
                    Engine::NormalForm => exponent,
                };
                engine = Engine::Modular { exponent: weakest };
            }
            Verdict::Equal(Engine::NormalForm) => {}
            other => return other,
        }
    }
    Verdict::Equal(engine)
}
