//! Abbreviated equations: their effects against exact changes, and their runs against an integration that shares
//! nothing with the search.

use crate::random::Random;
use crate::tree::Tree;
use nalgebra::{DMatrix, DVector};
use rustc_hash::FxHashSet;
use std::path::Path;
use tripos::studies::abbreviation::{Abbreviation, abbreviate};
use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::SumTerms;
use tripos_derive::{Equations, Formulation, derive, model};

fn library(scene: &str) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(scene);
    Scene::read(path).unwrap_or_else(|e| panic!("{e}"))
}

/// State (q, v) at the end of a span by the classical Runge-Kutta method, from the terms of the equations.
fn state_after(of: &Abbreviation, p: &[f64], start: &[f64], span: (f64, f64), steps: u32) -> Vec<f64> {
    let (arena, e) = (&of.derivation.arena, &of.derivation.equations);
    let n = e.forcing.len();
    let inputs = [of.model.p(), e.coordinates.clone(), e.variables.clone()].concat();
    let outputs: Vec<_> =
        e.coordinate_rates.iter().chain(e.matrix.iter().flatten()).chain(&e.forcing).copied().collect();
    let tape = Tape::new(arena, &inputs, &outputs).unwrap();
    let rates = |y: &[f64]| {
        let values = tape.evaluate(&[p, y].concat());
        let (q_dot, rest) = values.split_at(e.coordinates.len());
        let (matrix, forcing) = rest.split_at(n * n);
        let matrix = DMatrix::from_row_slice(n, n, matrix);
        let unknowns = matrix.lu().solve(&DVector::from_column_slice(forcing)).unwrap();
        [q_dot, &unknowns.as_slice()[..e.variables.len()]].concat()
    };
    let h = (span.1 - span.0) / f64::from(steps);
    let add = |y: &[f64], k: &[f64], by: f64| y.iter().zip(k).map(|(y, k)| y + by * k).collect::<Vec<_>>();
    let mut y = start.to_vec();
    for _ in 0..steps {
        let k1 = rates(&y);
        let k2 = rates(&add(&y, &k1, h / 2.0));
        let k3 = rates(&add(&y, &k2, h / 2.0));
        let k4 = rates(&add(&y, &k3, h));
        for (at, value) in y.iter_mut().enumerate() {
            *value += h / 6.0 * (k1[at] + 2.0 * k2[at] + 2.0 * k3[at] + k4[at]);
        }
    }
    y
}

/// Truth: an integration of the abbreviated terms by a method of its own, beside a run of the whole equations. The
/// difference of each state at the end is within the stated bound, and the operations are far fewer.
#[test]
fn abbreviated_equations_keep_their_bound() {
    for (file, within, steps, most_operations) in
        [("puma560/scenes/collapse.toml", 1e-2, 1000, 0.85), ("whipple_bicycle/scenes/knocked.toml", 1e-2, 2000, 0.45)]
    {
        let scene = library(file);
        let of = scene.abbreviate(within).unwrap_or_else(|e| panic!("{file}: {e}"));
        assert_eq!(of.by.formulation(), Some(Formulation::Kane), "{file}");
        let description = scene.description();
        let start = [&description.q[..], &description.u].concat();
        let found = state_after(&of, &description.parameters, &start, description.span, steps);
        let kane = Overrides { by: Some("kane".into()), ..Overrides::default() };
        let run = scene.simulate(&kane).unwrap();
        let names = tripos::state_names(scene.mechanism());
        assert!(of.differences.iter().map(|d| &d.name).eq(&names), "{file}");
        for ((name, difference), found) in names.iter().zip(&of.differences).zip(found) {
            let expected = *run.column_of_quantity(name).unwrap().last().unwrap();
            let allowed = 1.05 * within * difference.scale;
            assert!((found - expected).abs() <= allowed, "{file}: {name} is {expected}, abbreviated {found}");
        }
        assert!(of.differences.iter().all(|d| d.relative() <= within), "{file}");
        let part = of.cost.operations as f64 / of.whole_cost.operations as f64;
        println!(
            "{file} within {within:e}: {} of {} terms left out, {} operations of {}, {} runs",
            of.dropped.len(),
            of.terms,
            of.cost.operations,
            of.whole_cost.operations,
            of.runs
        );
        assert!(part <= most_operations, "{file}: {part}");
    }
}

/// Change of Σ wᵢ (f − M x)ᵢ between two sets of equations at one state.
fn change(arena: &Arena, p: &[Expr], of: [&Equations; 2], inputs: &[f64], x: &[f64], w: &[f64]) -> f64 {
    let [whole, without] = of.map(|e| {
        let symbols = [p, &e.coordinates, &e.variables].concat();
        let outputs: Vec<_> = e.matrix.iter().flatten().chain(&e.forcing).copied().collect();
        let values = Tape::new(arena, &symbols, &outputs).unwrap().evaluate(inputs);
        let (matrix, forcing) = values.split_at(x.len() * x.len());
        let residual = |i: usize| {
            let row = &matrix[i * x.len()..(i + 1) * x.len()];
            forcing[i] - row.iter().zip(x).map(|(m, x)| m * x).sum::<f64>()
        };
        (0..x.len()).map(|i| w[i] * residual(i)).sum::<f64>()
    });
    whole - without
}

/// Truth: the equations without a term, evaluated. An effect is exact where the equations are linear in the sum, which
/// holds for nearly all sums; the others are squares and divisors.
#[test]
fn effects_of_terms_on_random_trees_are_exact_changes() {
    let (mut exact, mut all) = (0, 0);
    for seed in 0..12 {
        let mut random = Random(7_000 + seed);
        let bodies = 1 + random.below(3);
        let tree = Tree::new(&mut random, bodies);
        let (q, u) = tree.state(&mut random);
        let model = model::load(&Source::from_text("tree.toml", &tree.text())).unwrap();
        let mut derivation = derive(&model, Formulation::Kane).unwrap();
        let terms = SumTerms::new(&mut derivation.arena, &derivation.equations, &model.p()).unwrap();
        let p = model.parameters.iter().map(|p| p.value.as_ref().unwrap().to_f64());
        let inputs: Vec<f64> = p.chain(q).chain(u).collect();
        let values = terms.values(&inputs);
        let count = derivation.equations.unknowns.len();
        let mut draw = || (0..count).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>();
        let (x, w) = (draw(), draw());
        let effects = terms.effects(&derivation.arena, &values, &x, &w);
        let size = effects.iter().fold(0.0_f64, |m, e| m.max(e.abs()));
        for (term, effect) in terms.list().iter().zip(effects).step_by(7) {
            let dropped: FxHashSet<_> = [*term].into_iter().collect();
            let Some(without) = terms.equations_without(&mut derivation.arena, &dropped) else { continue };
            let both = [&derivation.equations, &without];
            let truth = change(&derivation.arena, &model.p(), both, &inputs, &x, &w);
            exact += usize::from((truth - effect).abs() <= 1e-9 * size);
            all += 1;
        }
    }
    println!("{exact} of {all} effects are exact");
    assert!(all > 200 && exact as f64 > 0.9 * f64::from(all), "{exact} of {all}");
}

/// A pendulum with a drag that is too small to be seen, and a spring that is not.
const PENDULUM: &str = r#"
name = "Pendulum"
[parameters]
m = "1 kg"
l = "1 m"
g = "9.81 m/s^2"
k = "2 N*m"
c = "1e-7 N*m*s"
[coordinates]
q1 = { unit = "rad" }
[speeds]
u1 = "q1'"
[inertial]
frame = "N"
origin = "O"
[frames]
A = { from = "N", axis = 3, angle = "q1" }
[points]
P = { from = "O", frame = "A", position = [0, "-l", 0] }
[particles]
bob = { point = "P", mass = "m" }
[torques]
drag = { on = "A", vector = [0, 0, "-c*u1 - k*q1"], frame = "N" }
[gravity]
frame = "N"
acceleration = [0, "-g", 0]
"#;

fn pendulum(rest: &str) -> Scene {
    let model = model::load(&Source::from_text("model.toml", PENDULUM)).unwrap_or_else(|e| panic!("{e}"));
    let text = format!("title = \"Swing\"\nspan = [0, 3]\n[start]\nq1 = 0.4\nu1 = 0\n{rest}");
    Scene::parse(Mechanism::new(model), &text).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn the_term_below_the_bound_is_left_out_and_no_other() {
    let of = pendulum("").abbreviate(1e-5).unwrap();
    let dropped: Vec<&str> = of.dropped.iter().map(|d| d.term.as_str()).collect();
    assert_eq!(dropped, ["-c*u1"]);
    assert!(of.differences.iter().all(|d| d.largest > 0.0 && d.relative() < 1e-5), "{:?}", of.differences);
    // Below the effect of the drag, nothing can be left out.
    let of = pendulum("").abbreviate(1e-9).unwrap();
    assert!(of.dropped.is_empty() && of.cost == of.whole_cost);
}

/// An energy of 1e-13 J is compared with its own size, and a scene may lack a relative tolerance.
#[test]
fn small_quantities_keep_the_bound() {
    let tiny = PENDULUM.replace("m = \"1 kg\"", "m = \"1e-13 kg\"").replace("c*u1 - k*q1", "c*u1");
    let tiny = tiny.replace("1e-7 N*m*s", "1e-17 N*m*s");
    let model = model::load(&Source::from_text("model.toml", &tiny)).unwrap_or_else(|e| panic!("{e}"));
    let scene = "title = \"Swing\"\nspan = [0, 8]\noutputs = [\"kinetic_energy\"]\n[start]\nq1 = 0.4\nu1 = 0\n[integration]\nrtol = 0\n";
    let scene = Scene::parse(Mechanism::new(model), scene).unwrap_or_else(|e| panic!("{e}"));
    let of = scene.abbreviate(1e-2).unwrap();
    assert!(of.dropped.iter().all(|d| !d.term.contains("sin(q1)")), "{:?}", of.dropped);
    assert!(of.differences.iter().all(|d| d.scale < 1e-9 && d.relative() <= 1e-2), "{:?}", of.differences);
}

/// Without all terms, the mass matrix is singular: the accelerations that implicit methods need cannot be eliminated.
#[test]
fn implicit_methods_try_groups_of_terms_too() {
    let of = pendulum("[integration]\nmethod = \"radau5\"\nrtol = 1e-8\natol = 1e-10\n").abbreviate(1e-4).unwrap();
    assert_eq!(of.dropped.iter().map(|d| d.term.as_str()).collect::<Vec<_>>(), ["-c*u1"]);
}

#[test]
fn what_cannot_be_abbreviated_is_refused() {
    for within in [0.0, 1.0, -1e-3, 1e-12, f64::NAN, f64::INFINITY] {
        let error = pendulum("").abbreviate(within).err().unwrap().to_string();
        assert!(error.contains("is not between 1e-10 and 1"), "{error}");
    }
    let scene = pendulum("[[events]]\nname = \"at once\"\nzero = \"u1 + 1e-3\"\nterminal = true\n");
    let error = scene.abbreviate(1e-3).err().unwrap().to_string();
    assert!(error.contains("too early for a comparison"), "{error}");
    let scene = pendulum("");
    let mut description = scene.description().clone();
    description.integration.step_limit = 3;
    let error = abbreviate(scene.mechanism(), &description, 1e-3).err().unwrap().to_string();
    assert!(error.contains("does not reach its end"), "{error}");
}
