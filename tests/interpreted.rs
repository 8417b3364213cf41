//! Models that are not compiled have all that compiled ones have, to the same digits.

use crate::support::{Random, compiled};
use std::path::{Path, PathBuf};
use tripos::code::{CodeForm, CodePreparation, runnable_code};
use tripos::{Mechanism, ReferenceSolution};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::load;
use tripos_derive::{Formulation, Model};
use tripos_sim::work_precision::work_precision_error;
use tripos_traits::{DoubleDouble, Real, Scalar, System};

type Dd = DoubleDouble;

fn folder(model: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(model)
}

/// Everything that a run asks of a system, one after the other.
fn all(system: &dyn System<Dd>, has_taylor: bool, p: &[Dd], q: &[Dd], v: &[Dd]) -> Vec<(&'static str, Vec<Dd>)> {
    let zeros = |n: usize| vec![Dd::int(0); n];
    let (m, n) = (system.lengths().unknowns(), system.lengths().state());
    let (mut matrix, mut forcing, mut jacobian) = (zeros(m * m), zeros(m), zeros(n * n));
    let (mut q_dot, mut v_dot, mut u) = (zeros(q.len()), zeros(v.len()), zeros(system.lengths().speeds));
    system.mass_matrix(p, q, v, &mut matrix);
    system.forcing(p, q, v, &mut forcing);
    system.derivative(p, q, v, &mut q_dot, &mut v_dot);
    system.jacobian(p, q, v, &mut jacobian);
    system.generalized_speeds(p, q, v, &mut u);
    let mut series = [q, v, &zeros(4 * n)].concat();
    // Long equations are compiled without their series, and tapes of them have it: there is nothing to compare.
    if has_taylor {
        system.taylor(p, 4, &mut series, &mut zeros(system.taylor_work(4)));
    }
    let energies = vec![system.kinetic_energy(p, q, v), system.potential_energy(p, q)];
    vec![
        ("M", matrix),
        ("f", forcing),
        ("q'", q_dot),
        ("v'", v_dot),
        ("Jacobian", jacobian),
        ("u", u),
        ("Taylor coefficients", series),
        ("energies", energies),
    ]
}

/// Goal: a reference does not depend on whether its model is compiled. Method: generated Rust against tapes, both in 32
/// digits, at seeded states of every model. 1e-28 of the largest entry: some thousand roundings of 5e-32 in the longest
/// functions, those of the governor. Added is 16 times the change that the last three bits of the state make, which is
/// larger near singular poses.
#[test]
fn interpreted_equations_have_28_digits_of_the_compiled_ones() {
    for name in tripos_models::MODELS.iter().map(|model| model.name) {
        let mechanism = Mechanism::new(Model::read(&folder(name).join("model.toml")).unwrap());
        for formulation in [Formulation::Kane, Formulation::Lagrange] {
            let tape =
                runnable_code(&mechanism, &EquationsOrigin::from(formulation), None, CodePreparation::Solved).unwrap();
            assert_eq!(tape.form(), CodeForm::Interpreted);
            let [tape, rust] = [tape.extended(), compiled(name, formulation.name()).extended];
            let both = tape.has_taylor() && rust.has_taylor();
            let (lengths, mut random) = (tape.lengths(), Random(11));
            for _ in 0..5 {
                let mut list = |n: usize, from, to| -> Vec<Dd> {
                    (0..n).map(|_| Dd::from_f64(random.between(from, to)) / Dd::int(3)).collect()
                };
                let p = list(lengths.parameters, 1.0, 9.0);
                let (q, v) = (list(lengths.coordinates, 0.5, 3.0), list(lengths.variables, -5.0, 5.0));
                let nearby = [&p, &q, &v].map(|list| {
                    let bits = [8_i32, -8, -8].into_iter().cycle();
                    list.iter()
                        .zip(bits)
                        .map(|(x, n)| *x + *x * Dd::from_f64(f64::from(n) * Dd::EPSILON))
                        .collect::<Vec<_>>()
                });
                let [found, truth] = [tape, rust].map(|system| all(system, both, &p, &q, &v));
                let moved = all(rust, both, &nearby[0], &nearby[1], &nearby[2]);
                for (((part, a), (_, b)), (_, moved)) in found.into_iter().zip(truth).zip(moved) {
                    let size = b.iter().map(|x| x.abs().to_f64()).fold(0.0, f64::max);
                    let felt = moved.iter().zip(&b).map(|(a, b)| (*a - *b).abs().to_f64()).fold(0.0, f64::max);
                    for (a, b) in a.iter().zip(&b) {
                        let off = (*a - *b).abs().to_f64();
                        assert!(
                            off <= 1e-28 * size + 16.0 * felt,
                            "{name} {} {part}: {a} and {b}, {felt:e} of {size:e}",
                            formulation.name()
                        );
                    }
                }
            }
        }
    }
}

/// An edited model's reference is as good as a compiled one's: a double would leave an uncertainty of 1e-16.
#[test]
fn references_of_interpreted_models_have_32_digits() {
    let mut model = Model::read(&folder("spherical_pendulum").join("model.toml")).unwrap();
    let file = Source::read(&folder("spherical_pendulum").join("scenes/wide.toml")).unwrap();
    let scene = load(&file, &mut model).unwrap();
    let interpreted = ReferenceSolution::new(&Mechanism::new(model.clone()), &scene, &[0.5]).unwrap();
    let compiled = Mechanism::new(model).with_compiled_equations(tripos_models::MODELS);
    let compiled = ReferenceSolution::new(&compiled, &scene, &[0.5]).unwrap();
    assert!(interpreted.how.contains("(32 digits)"), "{}", interpreted.how);
    assert!(interpreted.uncertainty < 1e-19, "{}", interpreted.how);
    let difference = work_precision_error(interpreted.end(), compiled.end());
    assert!(difference < 1e-25, "{difference:e}; {} and {}", interpreted.how, compiled.how);
}
