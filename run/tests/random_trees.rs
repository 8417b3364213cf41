//! Runs of random trees of bodies over all kinds of joints, by every path to a number, against first principles.

use crate::random::Random;
use crate::tree::{Tree, scene};
use tripos::{Mechanism, Overrides, Run, Scene};
use tripos_derive::diagnostic::Source;

/// Length of the runs of trees, s, and number of steps of the reference, whose error is below 1e-12.
const SPAN: (f64, u32) = (0.1, 400);
/// Greatest error of a path, relative to the largest state; tolerances are 1e-12.
const TOLERANCE: f64 = 1e-9;

/// Factor on the number of random mechanisms that are tried, from `TRIPOS_RANDOM_TIMES`; 1 by default.
pub fn times() -> usize {
    std::env::var("TRIPOS_RANDOM_TIMES").ok().and_then(|text| text.parse().ok()).unwrap_or(1)
}

/// Number of trees that are run, from `TRIPOS_RANDOM_RUNS`; 8 by default.
fn count() -> u64 {
    std::env::var("TRIPOS_RANDOM_RUNS").ok().and_then(|text| text.parse().ok()).unwrap_or(8)
}

/// Equations, method and solve of each path; `None` is the default.
const PATHS: [(Option<&str>, Option<&str>, Option<&str>); 8] = [
    (None, None, None),
    (Some("kane"), None, None),
    (Some("kane"), None, Some("numeric")),
    (Some("kane"), Some("taylor"), None),
    (Some("kane"), Some("radau5"), None),
    (Some("lagrange"), None, None),
    (Some("lagrange"), Some("taylor"), Some("eliminated")),
    (Some("newton-euler"), None, None),
];

/// Goal: no default and no option leads to another motion. Method: for each tree and path, the state at the end is
/// compared with an integration by the classical Runge-Kutta method, whose accelerations share nothing with Tripos.
#[test]
fn runs_of_random_trees_are_those_of_first_principles() {
    let (mut runs, mut numbers) = (0, 0);
    for seed in 0..count() {
        let mut random = Random(1_000_000 + seed);
        let bodies = 1 + random.below(3);
        let tree = Tree::new(&mut random, bodies);
        let (q0, u0) = tree.state(&mut random);
        let (q, u) = tree.after(&q0, &u0, SPAN.0, SPAN.1);
        let scale = q.iter().chain(&u).fold(1.0_f64, |m, x| m.max(x.abs()));
        let model = tripos_derive::model::load(&Source::from_text("model.toml", &tree.text())).unwrap();
        for path in PATHS {
            let (by, method, solve) =
                (path.0.map(Into::into), path.1.map(|m| m.parse().unwrap()), path.2.map(|s| s.parse().unwrap()));
            let what = format!("tree {seed} ({}), {path:?}", tree.kinds());
            let run = Scene::parse(Mechanism::new(model.clone()), &scene(&q0, &u0, SPAN.0))
                .and_then(|scene| scene.simulate(&Overrides { by, method, solve, ..Overrides::default() }))
                .unwrap_or_else(|error| panic!("{what}: {error}\n{}", tree.text()));
            assert!(run.failure().is_none(), "{what}: {:?}\n{}", run.objections(), tree.text());
            for (name, expected) in ends("q", &q).chain(ends("u", &u)) {
                let found = end(&run, &name);
                let is_right = (found - expected).abs() <= TOLERANCE * scale;
                assert!(is_right, "{what}: {name} is {expected}, found {found}\n{}", tree.text());
                numbers += 1;
            }
            runs += 1;
        }
    }
    println!("{runs} runs, {numbers} numbers");
}

/// Names of the values in the scene, each with its value.
fn ends<'a>(letter: &'a str, values: &'a [f64]) -> impl Iterator<Item = (String, f64)> + 'a {
    values.iter().enumerate().map(move |(at, value)| (format!("{letter}{at}"), *value))
}

fn end(run: &Run, name: &str) -> f64 {
    *run.column_of_quantity(name).unwrap().last().unwrap()
}
