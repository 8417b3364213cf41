//! Known mechanisms: accelerations and energies by every formulation against published figures.

#![allow(clippy::needless_range_loop, reason = "matrices are read by row and column")]

use crate::figures;

use figures::{CASES, Case, State};
use std::path::Path;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::mechanics::{Derivation, Kinematics};
use tripos_derive::{Formulation, Model, derive};

fn model(case: &Case) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(case.file);
    Model::read(&path).unwrap_or_else(|errors| panic!("{errors}"))
}

/// Solves A x = b by elimination with row pivoting.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|i, j| a[*i][k].abs().total_cmp(&a[*j][k].abs())).unwrap_or(k);
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

/// u̇, T and the potential of gravity at a state given in q and u.
fn evaluate(model: &Model, derivation: &Derivation, state: &State) -> (Vec<f64>, f64, f64) {
    let (arena, e) = (&derivation.arena, &derivation.equations);
    let p: Vec<f64> = model.parameters.iter().map(|p| p.value.as_ref().expect("all have values").to_f64()).collect();
    let known = [model.p(), model.q()].concat();
    let values = [p.as_slice(), state.q].concat();
    // The motion variables v of the formulation, from u.
    let inputs = [known.clone(), model.u()].concat();
    let v = Tape::new(arena, &inputs, &e.motion_variables).expect("closed").evaluate(&[&values, state.u].concat());
    let inputs = [known, e.variables.clone()].concat();
    let values = [values, v].concat();
    let n = e.unknowns.len();
    let outputs = [e.matrix.concat(), e.forcing.clone(), vec![e.kinetic_energy]].concat();
    let out = Tape::new(arena, &inputs, &outputs).expect("closed").evaluate(&values);
    let matrix = out[..n * n].chunks(n).map(<[f64]>::to_vec).collect();
    let unknowns = solve(matrix, out[n * n..n * n + n].to_vec());
    // Back to the generalized speeds.
    let inputs = [inputs, e.unknowns[..e.variables.len()].to_vec()].concat();
    let values = [&values, &unknowns[..e.variables.len()]].concat();
    let u_dot = Tape::new(arena, &inputs, &e.generalized_speed_rates).expect("closed").evaluate(&values);
    let mut kinematics = Kinematics::new(model).expect("it was derived");
    let gravity = kinematics.gravity_potential(model).expect("it has a zero");
    let inputs = [model.p(), model.q()].concat();
    let potential =
        Tape::new(&kinematics.arena, &inputs, &[gravity]).expect("closed").evaluate(&[&p, state.q].concat());
    (u_dot, out[n * n + n], potential[0])
}

fn close(got: f64, expected: f64, what: &str) {
    // The figures are correctly rounded; 1e-12 leaves room for the elimination, whose condition is below 1e3.
    let error = (got - expected).abs();
    assert!(error <= 1e-12 * expected.abs().max(1.0), "{what}: {got} instead of {expected}, off by {error:e}");
}

fn check(formulation: Formulation) {
    for case in CASES {
        if formulation == Formulation::NewtonEuler && !case.reactions {
            continue;
        }
        let model = model(case);
        let derivation = derive(&model, formulation);
        let derivation = derivation.unwrap_or_else(|error| panic!("{}", model.diagnose(&error)));
        let mut zero = None;
        for (at, state) in case.states.iter().enumerate() {
            let what = |name: &str| format!("{} by {}, state {at}, {name}", case.file, formulation.name());
            let (u_dot, t, v) = evaluate(&model, &derivation, state);
            for (i, (got, expected)) in u_dot.iter().zip(state.u_dot).enumerate() {
                close(*got, *expected, &what(&format!("acceleration {i}")));
            }
            close(t, state.kinetic_energy, &what("kinetic energy"));
            // The potential is known up to a constant: the same in all states.
            let offset = *zero.get_or_insert(v - state.gravity_potential);
            close(v - offset, state.gravity_potential, &what("potential energy"));
        }
    }
}

#[test]
fn kane_gives_the_published_accelerations() {
    check(Formulation::Kane);
}

#[test]
fn lagrange_gives_the_published_accelerations() {
    check(Formulation::Lagrange);
}

#[test]
fn newton_euler_gives_the_published_accelerations() {
    check(Formulation::NewtonEuler);
}
