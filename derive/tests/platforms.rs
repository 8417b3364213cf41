//! Platforms on legs, whose loops are too long to be written out.
//!
//! Truth: finite differences of the loops' equations along the rates, Lagrange's kinetic energy in all rates, and
//! Lagrange's equations with multipliers.

use crate::common::read;
use crate::random::Random;
use std::fmt::Write;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{SolvedAccelerations, derive_all};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model, derive};

/// Kinds of legs, each with its joints from the ground up, as (kind, other keys), and its closing joint.
const LEGS: [(&[(&str, &str)], &str); 5] = [
    (&[("ball", "sequence = \"euler\""), ("slider", "axis = 3")], "kind = \"ball\""),
    (&[("universal", "axes = [1, 2]"), ("slider", "axis = 3")], "kind = \"ball\""),
    (&[("pin", "axis = 2"), ("universal", "axes = [1, 2]")], "kind = \"ball\""),
    (&[("ball", "sequence = \"euler\""), ("pin", "axis = 1")], "kind = \"universal\", axes = [1, 2]"),
    (&[("pin", "axis = 2"), ("pin", "axis = 1"), ("ball", "sequence = \"euler\"")], "kind = \"ball\""),
];

/// Text of a platform on legs of the given kinds, with random lengths and places.
fn platform_text(random: &mut Random, kinds: &[usize]) -> String {
    let mut joints = String::new();
    let mut bodies = String::from("platform = { mass = \"m\", inertia = { diagonal = [\"I\", \"J\", \"K\"] } }\n");
    let mut place = |low: f64, high: f64| format!("\"{:.2} m\"", random.between(low, high));
    for (leg, kind) in kinds.iter().enumerate() {
        let (list, closing) = LEGS[*kind];
        let mut below = String::new();
        for (at, (kind, keys)) in list.iter().enumerate() {
            let body = format!("part{leg}_{at}");
            let at_joint = [place(-1.0, 1.0), place(-1.0, 1.0), place(0.1, 0.5)].join(", ");
            let turned = ", turned = { sequence = \"31\", angles = [\"a\", \"b\"] }";
            let turned = if at == 0 { turned } else { "" };
            let _ = writeln!(
                joints,
                "j{leg}_{at} = {{ kind = \"{kind}\", {keys}, body = \"{body}\"{below}, at = [{at_joint}]{turned}, centre = [\
                 0, \"d\", \"c\"] }}",
            );
            let _ = writeln!(bodies, "{body} = {{ mass = \"m\", inertia = {{ diagonal = [\"I\", \"J\", \"K\"] }} }}");
            below = format!(", to = \"{body}\"");
        }
        let on_platform = [place(-0.5, 0.5), place(-0.5, 0.5), place(-0.1, 0.1)].join(", ");
        let _ = writeln!(
            joints,
            "close{leg} = {{ {closing}, body = \"platform\"{below}, at = [0, 0, \"e\"], body_at = [{on_platform}] }}"
        );
    }
    format!(
        "name = \"platform\"\n[parameters]\nm = {{ unit = \"kg\", value = 2, positive = true }}\n\
         I = {{ unit = \"kg*m^2\", value = 0.2, positive = true }}\nJ = {{ unit = \"kg*m^2\", value = 0.3, positive = true }}\n\
         K = {{ unit = \"kg*m^2\", value = 0.25, positive = true }}\na = {{ unit = \"rad\", value = 0.4 }}\n\
         b = {{ unit = \"rad\", value = -0.3 }}\nc = {{ unit = \"m\", value = 0.3 }}\nd = {{ unit = \"m\", value = 0.1 }}\n\
         e = {{ unit = \"m\", value = 0.6 }}\ng = {{ unit = \"m/s^2\", value = 9.81 }}\n\
         [inertial]\nframe = \"N\"\norigin = \"O\"\n[bodies]\n{bodies}[joints]\n\
         platform_joint = {{ kind = \"free\", sequence = \"euler\", body = \"platform\", centre = [\"d\", 0, \"c\"] }}\n\
         {joints}[gravity]\nframe = \"N\"\nacceleration = [0, 0, \"-g\"]\n"
    )
}

/// Values of terms of `arena` at the given state, with the parameters at their default values.
struct State {
    /// Symbols of parameters, coordinates and motion variables.
    symbols: Vec<String>,
    /// Values of the symbols.
    values: Vec<f64>,
}

impl State {
    /// Random state of a model: coordinates and the given motion variables.
    fn new(random: &mut Random, model: &Model, variables: &[String]) -> Self {
        let mut state = Self { symbols: Vec::new(), values: Vec::new() };
        for parameter in &model.parameters {
            let value = parameter.value.as_ref().expect("every parameter has a value");
            state.set(&parameter.name, value.to_f64());
        }
        let names = model.coordinates.iter().map(|c| c.name.clone()).chain(variables.iter().cloned());
        names.for_each(|name| state.set(&name, random.between(-1.0, 1.0)));
        state
    }

    fn set(&mut self, name: &str, value: f64) {
        self.symbols.push(name.to_owned());
        self.values.push(value);
    }

    fn value(&self, name: &str) -> f64 {
        self.values[self.symbols.iter().position(|symbol| symbol == name).unwrap()]
    }

    fn evaluate(&self, arena: &Arena, terms: &[Expr]) -> Vec<f64> {
        let mut arena = arena.clone();
        let symbols: Vec<Expr> = self.symbols.iter().map(|name| arena.symbol(name)).collect();
        let tape: Tape<f64> = Tape::new(&arena, &symbols, terms).unwrap_or_else(|e| panic!("{e:?}"));
        tape.evaluate(&self.values)
    }
}

/// Checks the rates, the kinetic energy and the equations of a platform on legs of the given kinds.
fn check(random: &mut Random, kinds: &[usize]) {
    let text = platform_text(random, kinds);
    let model = read(&text).unwrap_or_else(|e| panic!("{kinds:?}: {e}\n{text}"));
    assert!(model.kinematic_equations.has_dependent_speeds, "{kinds:?}: the loops are short");
    let speeds: Vec<String> = model.speeds.iter().map(|speed| speed.name.clone()).collect();
    let state = State::new(random, &model, &speeds);
    let rates = state.evaluate(&model.arena, &model.kinematic_equations.rates);
    // The loops stay closed, or open by the same amount.
    let equations: Vec<Expr> = model.loops.iter().map(|one| one.equation).collect();
    let moved = |h: f64| {
        let mut state = State { symbols: state.symbols.clone(), values: state.values.clone() };
        for (coordinate, rate) in model.coordinates.iter().zip(&rates) {
            let at = state.symbols.iter().position(|name| *name == coordinate.name).unwrap();
            state.values[at] += h * rate;
        }
        state.evaluate(&model.arena, &equations)
    };
    let h = 1e-5;
    let size = rates.iter().fold(1.0, |most: f64, rate| most.max(rate.abs()));
    for (at, (after, before)) in moved(h).into_iter().zip(moved(-h)).enumerate() {
        let slope = (after - before) / (2.0 * h);
        assert!(slope.abs() < 1e-8 * size.powi(3), "{kinds:?}: {} opens by {slope}", model.loops[at].name);
    }
    // Each generalized speed is what its definition says.
    let mut in_rates = State { symbols: state.symbols.clone(), values: state.values.clone() };
    for (coordinate, rate) in model.coordinates.iter().zip(&rates) {
        in_rates.set(&format!("{}'", coordinate.name), *rate);
    }
    let definitions: Vec<Expr> = model.speeds.iter().map(|speed| speed.definition).collect();
    for (speed, defined) in speeds.iter().zip(in_rates.evaluate(&model.arena, &definitions)) {
        let wanted = state.value(speed);
        assert!((defined - wanted).abs() < 1e-9 * size, "{kinds:?}: {speed} is {defined}, not {wanted}");
    }
    // Kane's mass matrix has the energy of Lagrange's rates.
    let kane = derive(&model, Formulation::Kane).unwrap();
    let lagrange = derive(&model, Formulation::Lagrange).unwrap();
    let energy = in_rates.evaluate(&lagrange.arena, &[lagrange.equations.kinetic_energy])[0];
    let matrix: Vec<Expr> = kane.equations.matrix.iter().flatten().copied().collect();
    let matrix = state.evaluate(&kane.arena, &matrix);
    let mut along = 0.0;
    for (i, u) in speeds.iter().enumerate() {
        for (j, v) in speeds.iter().enumerate() {
            along += 0.5 * matrix[i * speeds.len() + j] * state.value(u) * state.value(v);
        }
    }
    assert!((along - energy).abs() < 1e-9 * energy, "{kinds:?}: {along} against {energy}");
    let mut arena = kane.arena;
    SolvedAccelerations::new(&mut arena, &kane.equations).unwrap_or_else(|e| panic!("{kinds:?}: {e}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    assert!(!proof.pairs.is_empty());
    assert!(proof.pairs.iter().all(|pair| pair.verdict.is_equal()), "{kinds:?}: {:?}", proof.pairs);
}

/// Goal: mechanisms with long loops get right rates, energies and equations, whatever their legs. Method: each kind of
/// leg, with others at random.
#[test]
fn platforms_on_random_legs_have_right_equations() {
    let mut random = Random(81);
    for kind in 0..LEGS.len() {
        let kinds = [kind, random.below(LEGS.len()), random.below(2)];
        check(&mut random, &kinds);
    }
}
