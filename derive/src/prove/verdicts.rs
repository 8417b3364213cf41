//! Many verdicts as one.

use crate::algebra::meaning::compare::{Comparer, Engine, Verdict};
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::value::modular::{ZeroTest, bounded_zero_test};
use crate::algebra::{Arena, Expr};

/// Terms times questions above which one question is asked for all.
const MOST_SINGLE: usize = 2_000_000;

/// Compares two terms of every pair and gives one verdict. For large systems, whose entries share most terms, one
/// question is asked: is Σ w_i d_i zero, for the differences d_i with a new symbol w_i for each? It is if and only if
/// all differences are.
pub fn all_equal(arena: &mut Arena, comparer: &mut Comparer, pairs: &[(Expr, Expr)]) -> Verdict {
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
        let sum = comparer.with_plain_angles(arena, sum);
        if let (ZeroTest::Zero, exponent) = bounded_zero_test(arena, sum) {
            return Verdict::Equal(Engine::Modular { exponent });
        }
    }
    all(pairs.iter().map(|(left, right)| comparer.compare(arena, *left, *right)))
}

/// One verdict for many: the first that is not "equal", else the weakest engine.
pub fn all(verdicts: impl IntoIterator<Item = Verdict>) -> Verdict {
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
