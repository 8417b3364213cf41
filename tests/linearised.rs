//! Linear systems of random mechanisms, and of linkages, at states of any kind.
//!
//! Truth: differences in 32 digits of Kane's and Newton and Euler's equations, with loops closed again at each
//! displaced state.

use crate::mechanism;
use crate::spoilt::Random;
use std::path::Path;
use tripos::code::{Code, CodePreparation, runnable_code};
use tripos::studies::steady::{LinearisationOptions, SteadyLinearSystem, WideMatrix, linearise};
use tripos::{Mechanism, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::{Loops, load_state_with_unknowns};
use tripos_derive::{Formulation, Model, model};
use tripos_traits::{DoubleDouble as Dd, Real, Scalar};

/// Displacement for the differences: third derivatives then change them by 1e-18 of their size.
const STEP: f64 = 1e-9;
/// Largest permitted difference of a slope and its finite difference, relative to the largest entry of the system.
const APART: f64 = 1e-15;

/// The equations of a mechanism by one formulation.
struct Rates {
    code: Code,
    coordinates: usize,
}

impl Rates {
    fn new(mechanism: &Mechanism, by: Formulation) -> Self {
        let code = runnable_code(mechanism, &EquationsOrigin::from(by), None, CodePreparation::Solved)
            .unwrap_or_else(|e| panic!("{e}"));
        Self { code, coordinates: mechanism.coordinates.len() }
    }

    /// q', u' and T at parameters and a state, q and u.
    fn at(&self, p: &[Dd], x: &[Dd]) -> Vec<Dd> {
        let (system, (q, u)) = (self.code.extended(), x.split_at(self.coordinates));
        let (mut q_dot, mut u_dot) = (vec![Dd::int(0); q.len()], vec![Dd::int(0); u.len()]);
        system.derivative(p, q, u, &mut q_dot, &mut u_dot);
        [q_dot, u_dot, vec![system.kinetic_energy(p, q, u)]].concat()
    }
}

/// A mechanism to linearise, with parameters and a state.
struct Case {
    mechanism: Mechanism,
    p: Vec<Dd>,
    x: Vec<Dd>,
    inputs: Vec<String>,
    found: SteadyLinearSystem,
}

impl Case {
    /// The linear system at a state, whatever its rates are, with q', u' and T as outputs, and these parameters as
    /// inputs.
    fn new(text: Model, state: &str, inputs: &[&str]) -> Self {
        let mut text = text;
        let names = |list: &mut dyn Iterator<Item = &str>| list.map(|name| format!("\"{name}'\"")).collect::<Vec<_>>();
        let rates = names(&mut text.coordinates.iter().map(|c| c.name.as_str()));
        let accelerations = names(&mut text.speeds.iter().map(|s| s.name.as_str()));
        let shown = [rates, accelerations, vec!["\"kinetic_energy\"".to_owned()]].concat();
        let file = format!("outputs = [{}]\n{state}", shown.join(", "));
        let asked = load_state_with_unknowns(&Source::from_text("state.toml", &file), &mut text, &[])
            .unwrap_or_else(|e| panic!("{e}\n{file}"));
        let mechanism = Mechanism::new(text);
        let inputs: Vec<String> = inputs.iter().map(|name| (*name).to_owned()).collect();
        let wanted = LinearisationOptions { inputs: inputs.clone(), whole: true, as_is: true };
        let found = linearise(&mechanism, &asked, &wanted).unwrap_or_else(|e| panic!("{e}\n{file}"));
        Self { p: asked.parameters.clone(), x: found.steady.x.clone(), mechanism, inputs, found }
    }

    /// The state with one number of it, or a parameter, displaced by so much; what the loops determine follows.
    fn displaced(&self, state: Option<usize>, input: Option<usize>, by: f64) -> (Vec<Dd>, Vec<Dd>) {
        let (mut p, mut x) = (self.p.clone(), self.x.clone());
        let numbers = state.map(|at| (&mut x, at)).into_iter().chain(input.map(|at| (&mut p, at)));
        numbers.for_each(|(list, at)| list[at] = list[at] + Dd::from_f64(by));
        let closed = &self.found.system.closed;
        if !closed.is_empty() {
            let n = self.mechanism.coordinates.len();
            let q = Loops::new(&self.mechanism).close(&p, &x[..n], closed).expect("a small displacement closes");
            x[..n].copy_from_slice(&q);
        }
        (p, x)
    }

    /// A column of slopes of q', u' and T by differences.
    fn slopes(&self, rates: &Rates, state: Option<usize>, input: Option<usize>) -> Vec<Dd> {
        let [after, before] = [STEP, -STEP].map(|by| {
            let (p, x) = self.displaced(state, input, by);
            rates.at(&p, &x)
        });
        after.iter().zip(&before).map(|(a, b)| (*a - *b) / Dd::from_f64(2.0 * STEP)).collect()
    }

    /// Compares A, B, C and D with differences of both formulations; how many entries that are not zero were compared.
    fn compare(&self, what: &str) -> usize {
        let system = &self.found.system;
        let mut compared = 0;
        for by in [Formulation::Kane, Formulation::NewtonEuler] {
            let rates = Rates::new(&self.mechanism, by);
            let places = self.inputs.iter().map(|name| self.mechanism.parameters.iter().position(|p| p.name == *name));
            let by_state: Vec<_> = system.kept.iter().map(|at| self.slopes(&rates, Some(*at), None)).collect();
            let by_input: Vec<_> = places.map(|at| self.slopes(&rates, None, at)).collect();
            let all = by_state.iter().chain(&by_input).flatten();
            let scale = all.fold(1.0, |most: f64, x| most.max(x.to_f64().abs()));
            let rows = self.x.len() + 1;
            let mut check = |name: &str, found: &WideMatrix, columns: &[Vec<Dd>], rows: &[usize]| {
                assert_eq!((found.rows.len(), found.columns()), (rows.len(), columns.len()), "{what}: {name}");
                for (i, row) in rows.iter().enumerate() {
                    for (j, column) in columns.iter().enumerate() {
                        let (slope, truth) = (found.rows[i][j], column[*row]);
                        let off = (slope - truth).to_f64().abs();
                        compared += usize::from(truth.to_f64() != 0.0);
                        assert!(
                            off <= APART * scale,
                            "{what}, {}: {name}[{i}][{j}] is {slope} and by differences {truth}: off by {off:e} of {scale:e}",
                            by.name()
                        );
                    }
                }
            };
            let outputs: Vec<usize> = (0..rows).collect();
            check("A", &system.a, &by_state, &system.kept);
            check("C", &system.c, &by_state, &outputs);
            if !by_input.is_empty() {
                check("B", &system.b, &by_input, &system.kept);
                check("D", &system.d, &by_input, &outputs);
            }
        }
        compared
    }
}

/// Goal: A, B, C and D are the derivatives of the equations of any open mechanism at any state. Method: random
/// mechanisms of one to three links with mixed speeds, drag, springs and dampers, at their random starts; masses,
/// springs and gravity as inputs; against differences.
#[test]
fn linear_systems_of_random_mechanisms_are_their_derivatives() {
    let mut random = Random(20);
    let mut compared = 0;
    let turns = std::env::var("TRIPOS_RANDOM_LINEARISED").map_or(12, |text| text.parse().expect("a number"));
    for turn in 0..turns {
        let drawn = mechanism::Mechanism::new(&mut random);
        let text = drawn.text();
        let source = Source::from_text("random.toml", &text);
        let model = model::load(&source).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let names = model.coordinates.iter().map(|c| &c.name).chain(model.speeds.iter().map(|s| &s.name));
        let state: Vec<String> = names.map(|name| format!("{name} = {}", random.between(-0.9, 0.9))).collect();
        let state = format!("[state]\n{}\n", state.join("\n"));
        compared +=
            Case::new(model, &state, &["g", "m0", "a0", "k0", "c0"]).compare(&format!("turn {turn}\n{text}{state}"));
    }
    assert!(compared > 300, "{compared} entries");
}

/// Goal: `as_is` takes a state unchanged, but no pose whose loops are open. Method: the crossed four-bar linkage that
/// is let go, with the crank stated and the others guessed: the pose that closes, and its slopes; with all coordinates
/// stated wrongly, a refusal.
#[test]
fn a_state_is_taken_as_it_is_with_its_loops_closed() {
    let model = || Model::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("models/four_bar/model.toml")).unwrap();
    let case = Case::new(model(), "[state]\nq1 = 0.5\nu1 = 3\n[guess]\nq2 = -1.1\nq3 = -1.8\n", &["d"]);
    let doubles = |list: &[Dd]| list.iter().map(|x| x.to_f64()).collect::<Vec<f64>>();
    let (loops, q) = (Loops::new(&case.mechanism), doubles(&case.x[..3]));
    let open = loops.openings(&doubles(&case.p), &q);
    assert!(open.iter().all(|(_, open)| open.abs() < 1e-15) && q.starts_with(&[0.5]), "{open:?}");
    assert!(case.compare("four_bar") > 4);
    let mut text = model();
    let source = Source::from_text("state.toml", "[state]\nq1 = 0.5\nq2 = -1.1\nq3 = -1.8\nu1 = 3\n");
    let asked = load_state_with_unknowns(&source, &mut text, &[]).unwrap_or_else(|e| panic!("{e}"));
    let wanted = LinearisationOptions { as_is: true, ..LinearisationOptions::default() };
    let refused = linearise(&Mechanism::new(text), &asked, &wanted).unwrap_err().to_string();
    assert!(refused.contains("loops are open at this state: `"), "{refused}");
}

/// Goal: loops are eliminated rightly. Method: linkages of the library from the starts of their scenes, unchanged, with
/// dependent coordinates found again at each displaced state; lengths, which the loops depend on, and masses as inputs.
#[test]
fn linear_systems_of_linkages_are_their_derivatives() {
    let cases: [(&str, &str, &[&str]); 7] = [
        ("four_bar", "turning", &["b", "mb", "g"]),
        ("four_bar", "crossed", &["a", "mc"]),
        ("slider_crank", "coasting", &["r", "l"]),
        ("governor", "hunting", &["l"]),
        ("bricard", "let_go", &["m", "g"]),
        ("whipple_bicycle", "knocked", &["w", "g"]),
        ("satellite", "spin_up", &["A"]),
    ];
    for (name, scene, inputs) in cases {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(name);
        let text = Model::read(&folder.join("model.toml")).unwrap();
        let start = Scene::read(folder.join("scenes").join(format!("{scene}.toml"))).unwrap();
        let start = start.description();
        let names = text.coordinates.iter().map(|c| &c.name).chain(text.speeds.iter().map(|s| &s.name));
        let values = names.zip(start.q.iter().chain(&start.u)).map(|(name, x)| format!("{name} = {x:e}\n"));
        let state = format!("[state]\n{}", values.collect::<String>());
        let case = Case::new(text, &state, inputs);
        assert!(!case.found.system.closed.is_empty(), "{name}");
        assert!(case.compare(name) > 4, "{name}");
    }
}
