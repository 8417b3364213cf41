//! Accelerations that were solved for at derivation time, against the equations they come from, by meaning.

use std::fmt::Write;
use tripos_derive::algebra::form::simplify::{Simplifier, operation_count_of_all};
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::calculus::{Differential, Substitution};
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{
    Derivation, SingularDistance, accelerations, equations_in_distance, jacobian, singular_distances,
};
use tripos_derive::{Formulation, Model, derive, model};

const MODELS: [&str; 10] = [
    "models/disk/model.toml",
    "models/cart_pendulum_3/model.toml",
    "models/chaotic_pendulum/model.toml",
    "derive/tests/models/free_body.toml",
    "derive/tests/models/k01.toml",
    "derive/tests/models/k02.toml",
    "derive/tests/models/k06a.toml",
    "derive/tests/models/k06b.toml",
    "derive/tests/models/k11.toml",
    "derive/tests/models/k17a.toml",
];

fn read(path: &str) -> Model {
    Model::read(&std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(path)).unwrap()
}

fn solved(derivation: &mut Derivation) -> Elimination {
    accelerations(&mut derivation.arena, &mut Simplifier::default(), &derivation.equations).unwrap()
}

/// The steps' values in parameters, q and v alone.
fn unfolded(arena: &mut Arena, steps: &[Definition]) -> Substitution {
    let mut pairs: Vec<(Expr, Expr)> = Vec::new();
    for step in steps {
        let value = Substitution::new(&pairs).apply(arena, step.value);
        pairs.push((step.symbol, value));
    }
    Substitution::new(&pairs)
}

fn dot(arena: &mut Arena, a: &[Expr], b: &[Expr]) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(a, b)| arena.mul(*a, *b)).collect();
    arena.sum(&products)
}

/// Goal: the solution solves the system. Method: exact zero tests of A x − b with every step put in; for
/// Newton–Euler, whose reactions are not solved for, of its projection on the partial velocities.
#[test]
fn eliminated_accelerations_satisfy_the_equations() {
    for path in MODELS {
        let model = read(path);
        for formulation in Formulation::ALL {
            let Ok(mut derivation) = derive(&model, formulation) else { continue };
            let solution = solved(&mut derivation);
            let Derivation { arena, equations: e } = &mut derivation;
            let n = e.variables.len();
            let mut put = unfolded(arena, &solution.steps);
            let mut residuals = Vec::new();
            for (row, right) in e.matrix.iter().zip(&e.forcing) {
                let left = dot(arena, row, &e.unknowns);
                residuals.push(arena.sub(left, *right));
            }
            if !e.projection.is_empty() {
                residuals = e.projection.iter().map(|by| dot(arena, by, &residuals)).collect();
            }
            assert_eq!(residuals.len(), n, "{path} {formulation:?}");
            for residual in residuals {
                assert_ne!(zero_test(arena, residual), ZeroTest::Zero, "{path}: a residual says nothing without x");
                let with = put.apply(arena, residual);
                assert_eq!(zero_test(arena, with), ZeroTest::Zero, "{path} {formulation:?}");
            }
        }
    }
}

#[test]
fn the_disk_ends_in_a_closed_form_that_divides_by_three_things() {
    let model = read("models/disk/model.toml");
    for formulation in Formulation::ALL {
        let mut derivation = derive(&model, formulation).unwrap();
        let solution = solved(&mut derivation);
        assert_eq!(solution.steps.len(), 5, "no intermediate quantities: {formulation:?}");
        let divisors: Vec<String> = solution.divisors.iter().map(|e| print_text(&derivation.arena, *e)).collect();
        // 4 cos² − 5 is −(1 + 4 sin²).
        assert_eq!(divisors, ["cos(q2)", "R", "4*cos(q2)^2 - 5"], "{formulation:?}");
    }
}

/// Goal: the Jacobian by the chain rule over the steps is the derivative. Method: zero tests against the derivative of
/// what the steps unfold to.
#[test]
fn the_jacobian_is_the_derivative() {
    for path in ["models/disk/model.toml", "models/cart_pendulum_3/model.toml", "derive/tests/models/k02.toml"] {
        let model = read(path);
        for formulation in [Formulation::Kane, Formulation::Lagrange] {
            let mut derivation = derive(&model, formulation).unwrap();
            let solution = solved(&mut derivation);
            let Derivation { arena, equations: e } = &mut derivation;
            let found = jacobian(arena, &mut Simplifier::default(), e, &solution);
            let mut put = unfolded(arena, &found.steps);
            let rates: Vec<Expr> = e.coordinate_rates.iter().chain(&e.unknowns[..e.variables.len()]).copied().collect();
            let state: Vec<Expr> = e.coordinates.iter().chain(&e.variables).copied().collect();
            assert_eq!(found.entries.len(), state.len());
            for (rate, row) in rates.iter().zip(&found.entries) {
                let rate = put.apply(arena, *rate);
                for (by, entry) in state.iter().zip(row) {
                    let expected = Differential::partial(*by).apply(arena, rate);
                    let entry = put.apply(arena, *entry);
                    let difference = arena.sub(entry, expected);
                    assert_eq!(zero_test(arena, difference), ZeroTest::Zero, "{path} {formulation:?}");
                }
            }
        }
    }
}

#[test]
fn the_disk_is_worth_a_distance_from_lying_flat() {
    assert_eq!(
        singular_distances(&read("models/disk/model.toml")),
        [SingularDistance { coordinate: 1, quarter_turns: 1 }]
    );
    assert_eq!(singular_distances(&read("models/cart_pendulum_3/model.toml")), []);
}

/// Goal: equations in a distance are the same equations. Method: put q2 − 90° back for the distance; zero tests.
#[test]
fn equations_in_a_distance_mean_the_same() {
    let model = read("models/disk/model.toml");
    for quarter_turns in [1, -1, 2] {
        let distance = SingularDistance { coordinate: 1, quarter_turns };
        for formulation in Formulation::ALL {
            let plain = derive(&model, formulation).unwrap();
            let Derivation { mut arena, equations } = equations_in_distance(&model, plain.clone(), distance);
            let pi = arena.pi();
            let half = arena.ratio(i64::from(quarter_turns), 2);
            let origin = arena.mul(half, pi);
            let back = arena.sub(plain.equations.coordinates[1], origin);
            let mut put = Substitution::new(&[(equations.coordinates[1], back)]);
            let old = plain.equations.matrix.concat().into_iter().chain(plain.equations.forcing);
            let new = equations.matrix.concat().into_iter().chain(equations.forcing);
            for (old, new) in old.zip(new) {
                let new = put.apply(&mut arena, new);
                let difference = arena.sub(old, new);
                assert_eq!(zero_test(&arena, difference), ZeroTest::Zero, "{quarter_turns} {formulation:?}");
            }
        }
    }
}

/// n particles on massless rods that hang from one another.
fn chain(n: usize) -> Model {
    let mut text = "name = \"Chain\"\n[parameters]\nm = { unit = \"kg\", value = 1, positive = true }\n\
        l = { unit = \"m\", value = 1, positive = true }\ng = { unit = \"m/s^2\", value = 9.81 }\n[coordinates]\n"
        .to_owned();
    let each = |text: &mut String, line: &dyn Fn(usize) -> String| (1..=n).for_each(|i| text.push_str(&line(i)));
    each(&mut text, &|i| format!("q{i} = {{ unit = \"rad\" }}\n"));
    text += "[speeds]\n";
    each(&mut text, &|i| format!("u{i} = \"q{i}'\"\n"));
    text += "[inertial]\nframe = \"N\"\norigin = \"P0\"\n[frames]\n";
    each(&mut text, &|i| format!("A{i} = {{ from = \"N\", axis = 3, angle = \"q{i}\" }}\n"));
    text += "[points]\n";
    each(&mut text, &|i| format!("P{i} = {{ from = \"P{}\", frame = \"A{i}\", position = [0, \"-l\", 0] }}\n", i - 1));
    text += "[particles]\n";
    each(&mut text, &|i| format!("b{i} = {{ point = \"P{i}\", mass = \"m\" }}\n"));
    let _ = writeln!(text, "[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]");
    model::load(&Source { path: "chain.toml".into(), text }).unwrap()
}

/// Goal: a large system falls back to shared arithmetic. Method: operations of chains twice as long; those of a dense
/// factorization grow eightfold at the most.
#[test]
fn operations_of_a_chain_grow_as_those_of_a_factorization() {
    let operations = |n: usize| {
        let mut derivation = derive(&chain(n), Formulation::Kane).unwrap();
        let solution = solved(&mut derivation);
        let values: Vec<Expr> = solution.steps.iter().map(|step| step.value).collect();
        operation_count_of_all(&derivation.arena, &values)
    };
    let (five, ten) = (operations(5), operations(10));
    assert!(ten < 10 * five, "{five} operations for 5 links, {ten} for 10");
}
