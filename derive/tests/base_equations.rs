//! Equations in base parameters, beside Kane's equations in the parameters of the model.

use crate::mechanisms::Mechanism;
use crate::random::Random;
use std::path::Path;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::identify::BaseEquations;
use tripos_derive::{Equations, Formulation, Model, derive};

/// Tape of M row by row, then of f, from parameters, coordinates and speeds.
fn system(arena: &Arena, model: &Model, equations: &Equations) -> Tape<f64> {
    let symbols = [model.p(), model.q(), model.u()].concat();
    let terms: Vec<Expr> = equations.matrix.iter().flatten().chain(&equations.forcing).copied().collect();
    Tape::new(arena, &symbols, &terms).unwrap_or_else(|why| panic!("{why:?}"))
}

/// Compares both sets of equations at random states. The parameters have random values, from which the formulas give
/// the base parameters.
fn compare(model: &Model, base: &BaseEquations, states: usize, random: &mut Random, what: &str) {
    let kane = derive(model, Formulation::Kane).unwrap_or_else(|e| panic!("{what}: {e}"));
    let formulas: Vec<Expr> = base.base_parameters.iter().map(|base| base.value).collect();
    let formulas = Tape::<f64>::new(&base.derivation.arena, &model.p(), &formulas).unwrap();
    let plain = system(&kane.arena, model, &kane.equations);
    let short = system(&base.derivation.arena, &base.model, &base.derivation.equations);
    let mut finite = 0;
    for _ in 0..states {
        let mut list =
            |count: usize, low: f64, high: f64| -> Vec<f64> { (0..count).map(|_| random.between(low, high)).collect() };
        let own = list(model.parameters.len(), 0.3, 2.0);
        let state = [list(model.coordinates.len(), 0.2, 1.2), list(model.speeds.len(), -2.0, 2.0)].concat();
        let plain = plain.evaluate(&[own.clone(), state.clone()].concat());
        let short = short.evaluate(&[own.clone(), formulas.evaluate(&own), state].concat());
        let size = plain.iter().filter(|x| x.is_finite()).fold(1.0_f64, |most, x| most.max(x.abs()));
        finite += usize::from(plain.iter().all(|x| x.is_finite()));
        for (at, (plain, short)) in plain.iter().zip(&short).enumerate() {
            let is_same = (plain - short).abs() <= 1e-9 * size || !plain.is_finite();
            assert!(is_same, "{what}: entry {at} is {short}, not {plain}");
        }
    }
    assert!(2 * finite >= states, "{what}: {finite} of {states} states have values");
}

/// Goal: equations in base parameters are those of the model, whatever the mechanism is. Method: M and f of both in
/// doubles. The mechanisms have ball joints, loops, rolling, blades, springs, rotors and particles.
#[test]
fn random_mechanisms_have_the_same_equations_in_base_parameters() {
    let mut random = Random(71);
    let mut same = 0;
    for seed in 0..150 {
        let mechanism = Mechanism::new(&mut Random(seed));
        let Ok(model) = tripos_derive::model::load(&Source::from_text("model.toml", &mechanism.text)) else { continue };
        if derive(&model, Formulation::Kane).is_err() {
            continue;
        }
        let base = BaseEquations::new(&model).unwrap_or_else(|why| panic!("seed {seed}: {why}\n{}", mechanism.text));
        compare(&model, &base, 3, &mut random, &format!("seed {seed}\n{}", mechanism.text));
        same += 1;
    }
    assert!(same >= 100, "{same} mechanisms");
}

/// Goal: models of the library have equations in base parameters, and these are shorter in parameters. Method: M and f
/// of both in doubles.
#[test]
fn models_of_the_library_have_the_same_equations_in_base_parameters() {
    let mut random = Random(72);
    for name in [
        "furuta",
        "puma560",
        "gimbals",
        "heavy_top",
        "whipple_bicycle",
        "rolling_disc",
        "four_bar",
        "cart_with_spring",
        "satellite",
    ] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(name).join("model.toml");
        let model = Model::read(&path).unwrap_or_else(|e| panic!("{e}"));
        let base = BaseEquations::new(&model).unwrap_or_else(|why| panic!("{name}: {why:?}"));
        assert!(!base.base_parameters.is_empty(), "{name}");
        assert_eq!(base.model.parameters.len(), model.parameters.len() + base.base_parameters.len(), "{name}");
        compare(&model, &base, 3, &mut random, name);
    }
}

/// Goal: arms of which other generators tell operations have the same equations in base parameters. Method: M and f of
/// both in doubles, at 1000 states.
#[test]
fn arms_have_the_same_equations_in_base_parameters() {
    let mut random = Random(73);
    for file in ["models/puma560/model.toml", "benches/models/rx90.toml", "benches/models/rx90_symmetric.toml"] {
        let model = Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file)).unwrap();
        let base = BaseEquations::new(&model).unwrap_or_else(|why| panic!("{file}: {why:?}"));
        compare(&model, &base, 1000, &mut random, file);
    }
}
