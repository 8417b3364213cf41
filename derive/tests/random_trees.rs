//! Accelerations of random trees over all pairs of joints, each way to them, against first principles.

use crate::random::Random;
use crate::tree::Tree;
use nalgebra::{DMatrix, DVector};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::needed_steps;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Derivation, SolvedAccelerations, Unsolved};
use tripos_derive::{Formulation, Model, derive, model};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// Number of trees that are tried: `TRIPOS_RANDOM_TREES`, else 60.
fn count() -> u64 {
    std::env::var("TRIPOS_RANDOM_TREES").ok().and_then(|text| text.parse().ok()).unwrap_or(60)
}

/// Tolerance relative to the largest acceleration: the reference solves a dense system in doubles, whose condition
/// number is at most about 1e4.
const TOLERANCE: f64 = 1e-9;

/// Numbers of trees, formulations and values that were tried.
#[derive(Default, Debug)]
struct Table {
    trees: usize,
    formulations: usize,
    unsupported: usize,
    numbers: usize,
}

/// Goal: no path from a model to accelerations is wrong. Method: for each tree and formulation, accelerations
/// eliminated, solved numerically, in 32 digits and by inverse dynamics, against a computation that shares nothing with
/// them.
#[test]
fn accelerations_of_random_trees_are_those_of_first_principles() {
    let mut table = Table::default();
    for seed in 0..count() {
        let mut random = Random(seed);
        let bodies = 1 + random.below(if seed % 10 == 9 { 5 } else { 3 });
        let tree = Tree::new(&mut random, bodies);
        let source = Source::from_text("tree.toml", &tree.text());
        let model = model::load(&source).unwrap_or_else(|error| panic!("tree {seed}: {error}\n{}", tree.text()));
        let (q, u) = tree.state(&mut random);
        table.trees += 1;
        for formulation in Formulation::ALL {
            match derive(&model, formulation) {
                Ok(derivation) => {
                    let numbers = numbers(&model, &tree, &q, &u, derivation, seed);
                    table.numbers += numbers;
                    table.formulations += 1;
                }
                Err(error) if error.is_unsupported() => table.unsupported += 1,
                Err(error) => panic!("tree {seed} ({}): {error}", tree.kinds()),
            }
        }
    }
    println!("{table:?}");
    assert_eq!(table.unsupported, 0, "every tree has every formulation");
}

/// Compares all accelerations of one formulation at one state; returns the number of comparisons.
fn numbers(model: &Model, tree: &Tree, q: &[f64], u: &[f64], derivation: Derivation, seed: u64) -> usize {
    let Derivation { mut arena, equations } = derivation;
    let e = equations.with_definitions(&mut arena);
    let n = e.variables.len();
    let (seconds, u_dot) = tree.accelerations(q, u);
    let in_rates = e.formulation.is_in_rates();
    let (v, expected) = if in_rates { (tree.rates(q, u), seconds) } else { (u.to_vec(), u_dot) };
    let what = format!("tree {seed} ({}), {}", tree.kinds(), e.formulation.name());
    let inputs: Vec<Expr> = [model.p(), e.coordinates.clone(), e.variables.clone()].concat();
    let values: Vec<f64> =
        model.parameters.iter().map(|p| p.value.as_ref().unwrap().to_f64()).chain(q.iter().copied()).chain(v).collect();
    let scale = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    let compare = |path: &str, found: &[f64]| {
        for (at, (a, b)) in found.iter().zip(&expected).enumerate() {
            assert!((a - b).abs() <= TOLERANCE * scale, "{what}, {path}: v̇{at} is {b}, found {a}\n{}", tree.text());
        }
    };
    let solved = match SolvedAccelerations::new(&mut arena, &e) {
        Ok(solved) => solved,
        Err(Unsolved::Singular(_)) => panic!("{what}: singular"),
        Err(why) => panic!("{what}: {why}\n{}", tree.text()),
    };
    let rates = &e.unknowns[..n];
    let tape = Tape::stepwise(&arena, &inputs, &solved.accelerations.steps, rates).unwrap();
    compare("eliminated", &tape.evaluate(&values));
    let wide: Vec<DoubleDouble> = values.iter().map(|x| DoubleDouble::from_f64(*x)).collect();
    let wide: Vec<f64> = tape.to::<DoubleDouble>().evaluate(&wide).iter().map(|x| x.to_f64()).collect();
    compare("in 32 digits", &wide);

    let steps = needed_steps(&arena, &e.definitions, &[e.matrix.concat(), e.forcing.clone()].concat());
    let m = e.unknowns.len();
    let system = Tape::stepwise(&arena, &inputs, &steps, &[e.matrix.concat(), e.forcing.clone()].concat()).unwrap();
    let system = system.evaluate(&values);
    let matrix = DMatrix::from_row_slice(m, m, &system[..m * m]);
    let found = matrix.lu().solve(&DVector::from_row_slice(&system[m * m..])).expect("regular");
    compare("solved numerically", &found.as_slice()[..n]);

    let inverse = e.clone().with_certified_inverse_dynamics(&mut arena).unwrap_or_else(|why| panic!("{what}: {why}"));
    if !inverse.required.is_empty() {
        let inverse = inverse.with_definitions(&mut arena);
        let inputs = [inputs.clone(), rates.to_vec()].concat();
        let steps = needed_steps(&arena, &inverse.definitions, &inverse.required);
        let tape = Tape::stepwise(&arena, &inputs, &steps, &inverse.required).unwrap();
        let required = tape.evaluate(&[values.clone(), expected.clone()].concat());
        let largest = system.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        assert!(
            required.iter().all(|x| x.abs() <= TOLERANCE * largest * scale),
            "{what}, inverse dynamics: {required:?}"
        );
    }
    3 * n
}
