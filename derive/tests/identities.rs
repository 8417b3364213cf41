//! Proofs as values: the identities that `prove` and the reduction of a scene return.

use crate::random::Random;
use std::path::Path;
use tripos_derive::algebra::meaning::identity::Identity;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr, Node};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::{Combination, CombinationPart, prove};
use tripos_derive::{Formulation, Model};

fn library(name: &str) -> Model {
    Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).join("model.toml")).unwrap()
}

/// Largest difference of the sides of identities at a random state, relative to the larger side or 1.
fn gap(arena: &Arena, identities: &[Identity]) -> f64 {
    let sides: Vec<Expr> = identities.iter().flat_map(|identity| [identity.left, identity.right]).collect();
    let mut symbols = arena.reachable(&sides);
    symbols.retain(|e| matches!(arena.node(*e), Node::Symbol(_)));
    let mut random = Random(7);
    let values: Vec<f64> = symbols.iter().map(|_| random.between(0.2, 1.1)).collect();
    let found = Tape::new(arena, &symbols, &sides).unwrap().evaluate(&values);
    let gap = |pair: &[f64]| (pair[0] - pair[1]).abs() / pair[0].abs().max(pair[1].abs()).max(1.0);
    found.chunks(2).map(gap).fold(0.0, f64::max)
}

fn identities_of(combination: &Combination) -> Vec<Identity> {
    combination.identities.iter().map(|(_, identity)| *identity).collect()
}

/// Goal: whoever reads the identities can check them without Tripos' proofs. Method: both sides in doubles at a random
/// state, for models that are free, rolling, driven, with loops, and written in named terms.
#[test]
fn identities_of_pairs_hold_in_numbers() {
    for name in ["disk", "rolling_disc", "four_bar", "satellite", "whipple_bicycle"] {
        let model = library(name);
        let mut derivations = derive_all(&model).unwrap();
        let proof = prove(&model, &mut derivations);
        assert!(proof.is_equivalent());
        let arena = &derivations.kinematics.arena;
        for pair in &proof.pairs {
            assert!(!pair.combinations.is_empty());
            for combination in &pair.combinations {
                assert!([pair.left, pair.right].contains(&combination.of) && combination.of != combination.gives);
                let list = identities_of(combination);
                assert!(!list.is_empty(), "{name}: {:?}", pair.map);
                let gap = gap(arena, &list);
                assert!(gap < 1e-8, "{name}: {:?} {gap:e}", pair.map);
            }
        }
        for integral in &proof.integrals {
            assert_eq!(integral.identities.len(), model.speeds.len() + 1);
            assert_eq!(integral.multipliers.len(), model.speeds.len());
            assert!(gap(arena, &integral.identities) < 1e-8, "{name}: {}", integral.name(&model, arena));
        }
    }
}

/// Goal: a certificate can be made from the values alone. Method: the relations are put into the rows of one
/// formulation and the multipliers combine them; the result is the left side of each identity, and the right side is
/// the entry of the other formulation.
#[test]
fn multipliers_and_relations_lead_from_one_formulation_to_the_other() {
    let model = library("disk");
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let pair = &proof.pairs[0];
    assert_eq!((pair.left, pair.right), (Formulation::Kane, Formulation::Lagrange));
    let [forward, backward] = pair.combinations.as_slice() else { panic!("two directions") };
    for (combination, from, to) in
        [(forward, Formulation::Lagrange, Formulation::Kane), (backward, Formulation::Kane, Formulation::Lagrange)]
    {
        assert_eq!((combination.of, combination.gives), (from, to));
        let [from, to] = [from, to].map(|f| derivations.get(f).unwrap().clone());
        let arena = &mut derivations.kinematics.arena;
        let mut put = tripos_derive::algebra::term::calculus::Substitution::new(&combination.relations);
        for (r, multipliers) in combination.multipliers.iter().enumerate() {
            // Σ multiplier (row · unknowns − right), with the relations put in, is row · unknowns − right of the other.
            let mut terms = Vec::new();
            for (by, (row, right)) in multipliers.iter().zip(from.matrix.iter().zip(&from.forcing)) {
                let products: Vec<Expr> = row.iter().zip(&from.unknowns).map(|(m, x)| arena.mul(*m, *x)).collect();
                let sum = arena.sum(&products);
                let residual = arena.sub(sum, *right);
                let residual = put.apply(arena, residual);
                terms.push(arena.mul(*by, residual));
            }
            for (entry, unknown) in to.matrix[r].iter().zip(&to.unknowns) {
                terms.push(arena.product(&[Expr::MINUS_ONE, *entry, *unknown]));
            }
            terms.push(to.forcing[r]);
            let difference = arena.sum(&terms);
            assert_eq!(zero_test(arena, difference), ZeroTest::Zero, "row {r}");
            let of_row = |part: &CombinationPart| matches!(part, CombinationPart::Coefficient { row, .. } | CombinationPart::Right { row } if *row == r);
            let own: Vec<_> = combination.identities.iter().filter(|(part, _)| of_row(part)).collect();
            assert_eq!(own.len(), to.unknowns.len() + 1);
            assert_eq!(own.last().map(|(_, identity)| identity.right), Some(to.forcing[r]));
        }
    }
}

/// Goal: primes and points are evidence. Method: they are there where the sides are different terms, and are primes of
/// 61 bits; equations with a wrong sign give no identities.
#[test]
fn trials_are_at_large_primes_and_a_wrong_sign_proves_nothing() {
    let model = library("disk");
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let list: Vec<Identity> = proof.pairs.iter().flat_map(|pair| &pair.combinations).flat_map(identities_of).collect();
    let arena = &mut derivations.kinematics.arena;
    let unlike: Vec<_> = list.iter().filter(|identity| identity.left != identity.right).collect();
    assert!(unlike.len() > 10, "{}", unlike.len());
    for identity in unlike {
        let trials = identity.trials(arena);
        if arena.sub(identity.left, identity.right) != Expr::ZERO {
            assert!(trials.len() > 1 && trials.iter().all(|trial| trial.prime > 1 << 60 && trial.prime % 2 == 1));
        }
        assert_eq!(trials, identity.trials(arena));
    }
    let (_, kane) = derivations.list.iter_mut().find(|(f, _)| *f == Formulation::Kane).unwrap();
    let wrong = &mut kane.as_mut().unwrap().forcing[0];
    *wrong = derivations.kinematics.arena.neg(*wrong);
    let proof = prove(&model, &mut derivations);
    let of_kane = proof.pairs.iter().filter(|pair| pair.left == Formulation::Kane);
    assert!(
        of_kane.clone().count() == 2 && of_kane.flat_map(|pair| &pair.combinations).any(|c| c.identities.is_empty())
    );
}

/// Goal: a reduction's identities belong to the store that it returns. Method: their sides in doubles.
#[test]
fn identities_of_a_reduction_hold_in_numbers() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/spherical_pendulum");
    let mut model = Model::read(&folder.join("model.toml")).unwrap();
    let source = Source::read(&folder.join("scenes/wide.toml")).unwrap();
    let scene = tripos_derive::scene::load(&source, &mut model).unwrap();
    let reduction = tripos_derive::reduce::reduce(&model, &scene).unwrap();
    assert!(reduction.proof.identities.len() > 10);
    let gap = gap(reduction.arena(), &reduction.proof.identities);
    assert!(gap < 1e-8, "{gap:e}");
}
