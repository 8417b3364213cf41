//! Pendulums of many links on a cart: the equations are those worked by hand, and they grow as they must.

use crate::chain;

use chain::{by_hand, chain};
use tripos_derive::algebra::form::simplify::operation_count_of_all;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr, Function, Node};
use tripos_derive::mechanics::{Derivation, Equations, derive_all};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, derive};

/// M and f, of a symmetric M what is not below the diagonal.
fn entries(e: &Equations) -> Vec<Expr> {
    let rows = e.matrix.iter().enumerate().flat_map(|(i, row)| &row[if e.symmetric { i } else { 0 }..]);
    rows.chain(&e.forcing).copied().collect()
}

/// (operations with 4 for a sine or cosine, operations with 1 for it)
fn operations(arena: &Arena, list: &[Expr]) -> (usize, usize) {
    let weighted = operation_count_of_all(arena, list);
    let functions = arena.reachable(list).into_iter().filter(|e| matches!(arena.node(*e), Node::Apply(..))).count();
    assert!(arena.reachable(list).into_iter().all(|e| match arena.node(e) {
        Node::Apply(f, _) => matches!(f, Function::Sin | Function::Cos),
        _ => true,
    }));
    (weighted, weighted - 3 * functions)
}

/// Goal: the equations are right whatever the length. Method: every entry minus the one worked by hand is zero by
/// meaning, for Kane and, with u_i for q_i', Lagrange.
#[test]
fn chains_have_the_equations_worked_by_hand() {
    for n in [1, 2, 3, 7, 20] {
        let model = chain(n);
        for formulation in [Formulation::Kane, Formulation::Lagrange, Formulation::GibbsAppell] {
            let Derivation { mut arena, equations } = derive(&model, formulation).unwrap();
            let speeds: Vec<_> = equations.variables.iter().copied().zip(model.u()).collect();
            let mut as_speeds = Substitution::new(&speeds);
            let (matrix, forcing) = by_hand(n);
            let derived = equations.matrix.concat().into_iter().chain(equations.forcing);
            for (got, expected) in derived.zip(matrix.concat().into_iter().chain(forcing)) {
                let got = as_speeds.apply(&mut arena, got);
                let right = parse_free(&mut arena, &expected).unwrap();
                let difference = arena.sub(got, right);
                let what = || format!("{n} {formulation:?}: {} is not {expected}", print_text(&arena, got));
                assert_eq!(zero_test(&arena, difference), ZeroTest::Zero, "{}", what());
            }
        }
    }
}

#[test]
fn chains_are_proved_to_be_the_same_by_all_formulations() {
    for n in [1, 2, 4] {
        let model = chain(n);
        let mut derivations = derive_all(&model).unwrap();
        assert!(derivations.list.iter().all(|(_, result)| result.is_ok()));
        assert!(prove(&model, &mut derivations).is_equivalent(), "{n}");
    }
}

/// Goal: the size of M and f stays what it is, and grows with the square of the length. Method: counted, against the
/// number at the time of writing; a smaller one should be put here.
#[test]
fn the_operations_of_chains_are_bounded() {
    // The last number bounds the terms that the whole derivation builds, in squares of the length: it was 47 864 terms
    // for Kane and n = 20 before equal products were put together. Accelerations have about twice the terms of
    // velocities.
    for (formulation, bounds, most) in [
        (Formulation::Kane, [(5, 325, 235), (10, 1200, 870), (20, 4600, 3340)], 20),
        (Formulation::Lagrange, [(5, 325, 235), (10, 1200, 870), (20, 4600, 3340)], 20),
        (Formulation::NewtonEuler, [(5, 169, 139), (10, 484, 424), (20, 1564, 1444)], 20),
        (Formulation::GibbsAppell, [(5, 325, 235), (10, 1200, 870), (20, 4600, 3340)], 30),
    ] {
        for (n, weighted, plain) in bounds {
            let Derivation { arena, equations } = derive(&chain(n), formulation).unwrap();
            let got = operations(&arena, &entries(&equations));
            assert!(got.0 <= weighted && got.1 <= plain, "{formulation:?} {n}: {got:?}");
            assert!(arena.len() <= most * (n + 2) * (n + 2), "{formulation:?} {n}: {} terms", arena.len());
        }
    }
}
