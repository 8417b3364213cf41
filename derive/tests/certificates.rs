//! Results made from equations of motion are refused unless they are proved from them.

use std::path::{Path, PathBuf};
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{
    Derivation, SolvedAccelerations, Unproved, Unsolved, certify_accelerations, certify_inverse_dynamics,
    equations_in_distance, singular_distances,
};
use tripos_derive::{Equations, Formulation, Model, derive, model};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every model file of the library and of these tests.
fn models() -> Vec<PathBuf> {
    let folders = [root().join("models"), root().join("derive/tests/models")];
    let entries = folders.iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let mut paths: Vec<PathBuf> = entries
        .map(|entry| entry.unwrap().path())
        .map(|path| if path.is_dir() { path.join("model.toml") } else { path })
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    paths.sort();
    paths
}

fn solved(arena: &mut Arena, equations: &Equations, what: &str) {
    match SolvedAccelerations::new(arena, equations) {
        Ok(solved) => assert_eq!(solved.certificate.primes.len(), 2, "{what}"),
        Err(why) => panic!("{what}: {why}"),
    }
}

/// Goal: a right derivation is never refused. Method: every formulation of every model, also measured from singular
/// poses.
#[test]
fn every_model_of_the_library_is_proved() {
    for path in models() {
        let model = Model::read(&path).unwrap();
        for formulation in Formulation::ALL {
            let Ok(derivation) = derive(&model, formulation) else { continue };
            let what = format!("{} {}", path.display(), formulation.name());
            for distance in singular_distances(&model) {
                let Derivation { mut arena, equations } = equations_in_distance(&model, derivation.clone(), distance);
                solved(&mut arena, &equations, &format!("{what} in a distance"));
            }
            let Derivation { mut arena, equations } = derivation;
            solved(&mut arena, &equations, &what);
            equations.with_certified_inverse_dynamics(&mut arena).unwrap_or_else(|why| panic!("{what}: {why}"));
        }
    }
}

/// The parameters of a cart with a pendulum that carries a ball-jointed body, and its equations by one formulation.
fn pendulum(formulation: Formulation) -> (Vec<Expr>, Derivation) {
    let text = r#"
name = "Cart, rod and body"
[parameters]
m = { unit = "kg", value = 2 }
J = { unit = "kg*m^2", value = 1 }
l = { unit = "m", value = 0.5 }
g = { unit = "m/s^2", value = 9.81 }
[inertial]
frame = "N"
origin = "O"
[bodies]
cart = { mass = "m", inertia = { diagonal = ["J", "J", "J"] } }
rod = { mass = "m", inertia = { diagonal = ["J", "2*J", "J"] } }
body = { mass = "m", inertia = { diagonal = ["J", "2*J", "3*J"] } }
[joints]
s = { kind = "slider", axis = 1, body = "cart", coordinates = ["x"], speeds = ["v"] }
p = { kind = "pin", axis = 2, body = "rod", to = "cart", centre = [0, 0, "-l"], coordinates = ["q"], speeds = ["u"] }
b = { kind = "ball", body = "body", to = "rod", at = [0, 0, "-l"], centre = ["l", 0, 0] }
[gravity]
frame = "N"
acceleration = [0, 0, "-g"]
"#;
    let model = model::load(&Source::from_text("model.toml", text)).unwrap();
    (model.p(), derive(&model, formulation).unwrap())
}

/// Goal: what is wrong is found. Method: each number that is used is changed in one place, by a factor in one term.
#[test]
fn a_wrong_term_anywhere_is_found() {
    for formulation in Formulation::ALL {
        let (parameters, Derivation { mut arena, equations }) = pendulum(formulation);
        let equations = equations.with_definitions(&mut arena);
        let right = SolvedAccelerations::new(&mut arena, &equations).unwrap();
        let twice = |arena: &mut Arena, e: Expr| arena.add(e, e);
        let rates = &equations.unknowns[..equations.variables.len()];
        let used = needed_steps(&arena, &right.accelerations.steps, rates);
        let inputs = [parameters.clone(), equations.coordinates.clone(), equations.variables.clone()].concat();
        let values: Vec<f64> = (0..inputs.len()).map(|at| 0.3 + 0.07 * at as f64).collect();
        let numbers = |arena: &Arena, steps: &[Definition]| {
            Tape::stepwise(arena, &inputs, steps, rates).unwrap().evaluate(&values)
        };
        let expected = numbers(&arena, &used);
        let mut changes = 0;
        for at in (0..used.len()).filter(|at| used[*at].value != Expr::ZERO) {
            let mut wrong = Elimination { steps: used.clone(), ..right.accelerations.clone() };
            wrong.steps[at].value = twice(&mut arena, used[at].value);
            // What cancels in the end changes nothing.
            let found = numbers(&arena, &wrong.steps);
            let is_changed = found.iter().zip(&expected).any(|(a, b)| (a - b).abs() > 1e-9);
            let verdict = certify_accelerations(&arena, &equations, &wrong, None);
            let is_refused = matches!(verdict, Err(Unproved::Accelerations(_)));
            assert_eq!(is_refused, is_changed, "{formulation:?}, {}: {verdict:?}", print_text(&arena, used[at].value));
            changes += usize::from(is_changed);
        }
        assert!(changes > 10, "{formulation:?}: {changes}");
        let (rows, columns) = (right.jacobian.entries.len(), right.jacobian.entries[0].len());
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let mut wrong = right.jacobian.clone();
            let entry = &mut wrong.entries[row][column];
            *entry = arena.add(*entry, Expr::ONE);
            let found = certify_accelerations(&arena, &equations, &right.accelerations, Some(&wrong));
            assert!(matches!(found, Err(Unproved::Jacobian(_))), "{formulation:?}, entry {row} {column}: {found:?}");
        }
        let mut inverse = equations.clone().with_certified_inverse_dynamics(&mut arena).unwrap();
        for at in 0..inverse.required.len() {
            let right = inverse.required[at];
            inverse.required[at] = arena.add(right, Expr::ONE);
            assert_eq!(certify_inverse_dynamics(&arena, &inverse), Err(Unproved::InverseDynamics(at)));
            inverse.required[at] = right;
        }
    }
}

/// Goal: a wrong mass matrix is not confirmed by accelerations that were made from the right one.
#[test]
fn accelerations_of_other_equations_are_refused() {
    let (_, Derivation { mut arena, mut equations }) = pendulum(Formulation::Kane);
    let right = SolvedAccelerations::new(&mut arena, &equations).unwrap().accelerations;
    let entry = equations.matrix[1][1];
    equations.matrix[1][1] = arena.add(entry, Expr::ONE);
    let why = certify_accelerations(&arena, &equations, &right, None).unwrap_err();
    assert_eq!(why, Unproved::Accelerations(1));
    assert!(Unsolved::from(why).to_string().contains("row 2 of the equations of motion"));
}

/// Goal: a right derivation with many square roots is proved, though no prime field has all of them. Method: six
/// particles, each tied to all others by springs, have fifteen distances. A wrong entry of the Jacobian is not
/// confirmed.
#[test]
fn a_net_of_springs_is_proved() {
    let names: Vec<String> = (0..6).flat_map(|i| [format!("x{i}"), format!("y{i}")]).collect();
    let lines = |line: &dyn Fn(usize) -> String, count: usize| (0..count).map(line).collect::<Vec<_>>().concat();
    let pairs: Vec<(usize, usize)> = (0..6).flat_map(|i| (0..i).map(move |j| (i, j))).collect();
    let text = format!(
        "name = \"Net\"\n[parameters]\nm = {{ unit = \"kg\", value = 1 }}\nk = {{ unit = \"N/m\", value = 5 }}\nl = {{ unit = \"m\", value = 0.4 }}\n\
         [coordinates]\n{}[speeds]\n{}[inertial]\nframe = \"N\"\norigin = \"O\"\n[points]\n{}[particles]\n{}[potentials]\n{}",
        lines(&|at| format!("{} = {{ unit = \"m\" }}\n", names[at]), 12),
        lines(&|at| format!("u{at} = \"{}'\"\n", names[at]), 12),
        lines(&|i| format!("P{i} = {{ from = \"O\", frame = \"N\", position = [\"x{i}\", \"y{i}\", 0] }}\n"), 6),
        lines(&|i| format!("p{i} = {{ point = \"P{i}\", mass = \"m\" }}\n"), 6),
        lines(&|at| format!("s{at} = \"k*(distance(P{}, P{}) - l)^2/2\"\n", pairs[at].0, pairs[at].1), pairs.len()),
    );
    let model = model::load(&Source::from_text("net.toml", &text)).unwrap_or_else(|e| panic!("{e}"));
    for formulation in [Formulation::Kane, Formulation::Lagrange] {
        let Derivation { mut arena, equations } = derive(&model, formulation).unwrap();
        let equations = equations.with_definitions(&mut arena);
        let right =
            SolvedAccelerations::new(&mut arena, &equations).unwrap_or_else(|why| panic!("{formulation:?}: {why}"));
        let mut wrong = right.jacobian.clone();
        let entry = &mut wrong.entries[12][0];
        *entry = arena.add(*entry, Expr::ONE);
        assert!(
            certify_accelerations(&arena, &equations, &right.accelerations, Some(&wrong)).is_err(),
            "{formulation:?}"
        );
        equations.with_certified_inverse_dynamics(&mut arena).unwrap_or_else(|why| panic!("{formulation:?}: {why}"));
    }
}
