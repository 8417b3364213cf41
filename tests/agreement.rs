//! The three formulations of the disk agree, and compiled code computes what was derived.

use crate::support;

use proptest::prelude::*;
use std::path::Path;
use support::{Random, accelerations, compiled, largest_terms, system};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::{Formulation, Model, derive};
use tripos_sim::Dynamics;
use tripos_traits::{DoubleDouble, Real, Scalar, System};

/// Parameters, coordinates and speeds of the disk, away from lying flat: |cos q2| ≥ 0.01.
fn disk_states() -> impl Strategy<Value = (Vec<f64>, Vec<f64>, Vec<f64>)> {
    let parameters = prop::collection::vec(0.1..10.0_f64, 3);
    let q = prop::collection::vec(-7.0..7.0_f64, 5).prop_filter("flat", |q| q[1].cos().abs() >= 0.01);
    let u = prop::collection::vec(-5.0..5.0_f64, 5);
    (parameters, q, u)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Goal: equivalence in numbers. Method: accelerations by all three at random states.
    /// 1e-13 / cos² q2 of the largest acceleration: entries of the systems grow like tan² q2, what is left
    /// of them after elimination does not, and a solve spreads the error over all components: taken value by
    /// value, about one in a thousand of such states would break the bound, where one acceleration is some
    /// hundred times smaller than another.
    #[test]
    fn formulations_of_the_disk_agree((p, q, u) in disk_states()) {
        let tolerance = 1e-13 / q[1].cos().powi(2);
        let [kane, lagrange, newton_euler] =
            Formulation::STANDARD.map(|f| accelerations(system("disk", f.name()), &p, &q, &u));
        let scale = newton_euler.iter().fold(1.0_f64, |m, a| m.max(a.abs()));
        for ((a, b), c) in kane.iter().zip(&lagrange).zip(&newton_euler) {
            prop_assert!((a - b).abs() <= tolerance * scale, "kane {kane:?} lagrange {lagrange:?}");
            prop_assert!((a - c).abs() <= tolerance * scale, "kane {kane:?} newton-euler {newton_euler:?}");
        }
    }
}

/// Goal: printing loses nothing. Method: generated Rust against the interpreter at 1 000 seeded states of every model,
/// entry by entry, both in 32 digits. The bound is 1e-20 of the largest term, since the two sum in different orders,
/// and near a singular pose rounding grows by up to ten orders.
#[test]
fn generated_code_equals_the_interpreter() {
    for name in tripos_models::MODELS.iter().map(|model| model.name) {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models").join(name).join("model.toml");
        let model = Model::read(&path).unwrap();
        for formulation in Formulation::STANDARD {
            let Ok(derivation) = derive(&model, formulation) else { continue };
            compare_with_interpreter(&model, name, formulation, &derivation);
        }
    }
}

fn compare_with_interpreter(
    model: &Model,
    name: &str,
    formulation: Formulation,
    derivation: &tripos_derive::mechanics::Derivation,
) {
    let e = &derivation.equations;
    let system = compiled(name, formulation.name()).extended;
    let inputs: Vec<Expr> = [model.p(), model.q(), e.variables.clone()].concat();
    let energies = vec![e.kinetic_energy, e.potential_energy];
    let rates = e.coordinate_rates.clone();
    let outputs: Vec<Expr> =
        [e.matrix.concat(), e.forcing.clone(), rates, e.generalized_speeds.clone(), energies].concat();
    let tape = Tape::new(&derivation.arena, &inputs, &outputs).unwrap().to::<DoubleDouble>();
    let mut random = support::Random(7);
    let n = e.unknowns.len();
    for _ in 0..1000 {
        let p: Vec<f64> = model.parameters.iter().map(|_| random.between(0.1, 10.0)).collect();
        let q: Vec<f64> = model.coordinates.iter().map(|_| random.between(-7.0, 7.0)).collect();
        let v: Vec<f64> = e.variables.iter().map(|_| random.between(-5.0, 5.0)).collect();
        let values = [p.clone(), q.clone(), v.clone()].concat();
        let [p, q, v] = [p, q, v].map(|list| list.into_iter().map(DoubleDouble::from_f64).collect::<Vec<_>>());
        let speeds = system.lengths().speeds;
        let mut compiled = vec![DoubleDouble::int(0); n * n + n + q.len() + speeds + 2];
        let (matrix, rest) = compiled.split_at_mut(n * n);
        system.mass_matrix(&p, &q, &v, matrix);
        let (forcing, rest) = rest.split_at_mut(n);
        system.forcing(&p, &q, &v, forcing);
        let (rates, rest) = rest.split_at_mut(q.len());
        system.coordinate_rates(&p, &q, &v, rates);
        let (speeds, energies) = rest.split_at_mut(speeds);
        system.generalized_speeds(&p, &q, &v, speeds);
        energies[0] = system.kinetic_energy(&p, &q, &v);
        energies[1] = system.potential_energy(&p, &q);
        let interpreted = tape.evaluate(&[p, q, v].concat());
        let largest = largest_terms(&derivation.arena, &inputs, &values, &outputs);
        for (at, (a, b)) in compiled.iter().zip(&interpreted).enumerate() {
            let bound = 1e-20 * largest[at].max(b.to_f64().abs());
            assert!((*a - *b).to_f64().abs() <= bound, "{name} {}: entry {at}: {a} and {b}", formulation.name());
        }
    }
}

/// Goal: no formulation mistakes an energy. Method: T from u equals T from q' at random states; dT/dt of
/// a free system would not see a wrong constant, this does.
#[test]
fn energies_agree_between_formulations() {
    let mut random = support::Random(11);
    for _ in 0..100 {
        let p: Vec<f64> = (0..3).map(|_| random.between(0.1, 10.0)).collect();
        let q: Vec<f64> = (0..5).map(|_| random.between(-1.0, 1.0)).collect();
        let u: Vec<f64> = (0..5).map(|_| random.between(-5.0, 5.0)).collect();
        let (kane, lagrange) = (system("disk", "kane"), system("disk", "lagrange"));
        let mut v = vec![0.0; 5];
        lagrange.motion_variables(&p, &q, &u, &mut v);
        let (a, b) = (kane.kinetic_energy(&p, &q, &u), lagrange.kinetic_energy(&p, &q, &v));
        // 1e-12: a dozen terms whose largest is a few times the sum.
        assert!((a - b).abs() <= 1e-12 * a.max(1.0), "{a} and {b}");
        let (a, b) = (kane.potential_energy(&p, &q), lagrange.potential_energy(&p, &q));
        assert_eq!(a.to_bits(), b.to_bits(), "the same formula");
    }
}

/// The zero of potential energy is where the model file puts it: the report's V = −M g R (1 − cos q2).
#[test]
fn potential_energy_is_zero_upright() {
    let (kane, p) = (system("disk", "kane"), [2.0, 0.5, 9.81]);
    let v = |q2: f64| kane.potential_energy(&p, &[0.3, q2, 0.2, 5.0, 1.0]);
    assert!(v(0.0).abs() <= f64::EPSILON);
    let expected = -2.0 * 9.81 * 0.5 * (1.0 - 1.2_f64.cos());
    assert!((v(1.2) - expected).abs() <= 8.0 * f64::EPSILON * expected.abs());
}

/// Goal: Lagrange's conversions are inverse to each other. Method: u to q' and back at random states, and
/// u' from q'' against central differences of u along the motion.
#[test]
fn conversions_between_speeds_and_rates_are_inverse() {
    let (lagrange, mut random) = (system("disk", "lagrange"), support::Random(5));
    for _ in 0..100 {
        let p: Vec<f64> = (0..3).map(|_| random.between(0.1, 10.0)).collect();
        let q: Vec<f64> = (0..5).map(|_| random.between(-1.2, 1.2)).collect();
        let u: Vec<f64> = (0..5).map(|_| random.between(-5.0, 5.0)).collect();
        let a: Vec<f64> = (0..5).map(|_| random.between(-5.0, 5.0)).collect();
        let (mut v, mut back, mut rates) = (vec![0.0; 5], vec![0.0; 5], vec![0.0; 5]);
        lagrange.motion_variables(&p, &q, &u, &mut v);
        lagrange.generalized_speeds(&p, &q, &v, &mut back);
        lagrange.generalized_speed_rates(&p, &q, &v, &a, &mut rates);
        let speeds_at = |t: f64| {
            let q: Vec<f64> = q.iter().zip(&v).map(|(q, v)| q + t * v).collect();
            let v: Vec<f64> = v.iter().zip(&a).map(|(v, a)| v + t * a).collect();
            let mut u = vec![0.0; 5];
            lagrange.generalized_speeds(&p, &q, &v, &mut u);
            u
        };
        let h = 1e-6;
        let (later, earlier) = (speeds_at(h), speeds_at(-h));
        for i in 0..5 {
            assert!((back[i] - u[i]).abs() <= 1e-13 * u[i].abs().max(10.0));
            // Rounding, 50 times 1e-16 over h, and truncation, h squared, stay below 1e-7 of 100 here.
            let slope = (later[i] - earlier[i]) / (2.0 * h);
            assert!((slope - rates[i]).abs() <= 1e-7 * rates[i].abs().max(100.0), "{slope} {}", rates[i]);
        }
    }
}

/// Goal: what is generated from an elimination computes what it says, also in a distance. Method: at random states of
/// every derived system, accelerations against the numeric solve (1e-9 of the largest: its own error), the derivative
/// against both parts, and the Jacobian against central differences in twice the precision (1e-12 of the largest slope:
/// h² is 1e-16).
#[test]
fn generated_accelerations_derivatives_and_jacobians_agree() {
    let derived = |name: &str| !name.starts_with("printed:");
    for model in tripos_models::MODELS {
        for compiled in model.systems.iter().filter(|s| derived(s.name)) {
            let place = format!("{} {}", model.name, compiled.name);
            let (double, extended) = (compiled.double, compiled.extended);
            let (n, m) = (double.lengths().coordinates, double.lengths().variables);
            let mut random = Random(7);
            for _ in 0..20 {
                let p: Vec<f64> = (0..double.lengths().parameters).map(|_| random.between(0.5, 2.0)).collect();
                let q: Vec<f64> = (0..n).map(|_| random.between(0.2, 1.2)).collect();
                // Rates that the constraints permit: of others the two ways make what they like.
                let u: Vec<f64> = (0..double.lengths().speeds).map(|_| random.between(-2.0, 2.0)).collect();
                let (mut v, mut found) = (vec![0.0; m], vec![0.0; m]);
                double.motion_variables(&p, &q, &u, &mut v);
                double.accelerations(&p, &q, &v, &mut found);
                let solved = Dynamics::new(double, &p).unwrap().unknowns(&q, &v).unwrap()[..m].to_vec();
                let largest = found.iter().fold(1.0_f64, |most, a| most.max(a.abs()));
                assert!(found.iter().zip(&solved).all(|(a, b)| (a - b).abs() <= 1e-9 * largest), "{place}");
                let (mut q_dot, mut v_dot, mut rates) = (vec![0.0; n], vec![0.0; m], vec![0.0; n]);
                double.derivative(&p, &q, &v, &mut q_dot, &mut v_dot);
                double.coordinate_rates(&p, &q, &v, &mut rates);
                assert!(v_dot.iter().zip(&found).all(|(a, b)| (a - b).abs() <= 1e-12 * largest), "{place}");
                assert!(q_dot.iter().zip(&rates).all(|(a, b)| (a - b).abs() <= 1e-12 * (1.0 + b.abs())), "{place}");
                compare_jacobian(extended, double, &p, &[q, v].concat(), &place);
            }
        }
    }
}

fn compare_jacobian(extended: &dyn System<DoubleDouble>, double: &dyn System<f64>, p: &[f64], y: &[f64], place: &str) {
    let (n, size) = (double.lengths().coordinates, y.len());
    let lift = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let p_wide = lift(p);
    let derivative = |y: &[DoubleDouble]| {
        let mut out = vec![DoubleDouble::int(0); size];
        let (q_dot, v_dot) = out.split_at_mut(n);
        extended.derivative(&p_wide, &y[..n], &y[n..], q_dot, v_dot);
        out
    };
    let mut found = vec![0.0; size * size];
    double.jacobian(p, &y[..n], &y[n..], &mut found);
    let largest = found.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    let h = DoubleDouble::from_f64(1e-8);
    for by in 0..size {
        let moved = |step: DoubleDouble| {
            let mut y = lift(y);
            y[by] = y[by] + step;
            derivative(&y)
        };
        let slopes = |h: DoubleDouble| -> Vec<f64> {
            moved(h).iter().zip(moved(-h)).map(|(after, before)| ((*after - before) / (h + h)).to_f64()).collect()
        };
        for (row, (slope, wider)) in slopes(h).into_iter().zip(slopes(h + h)).enumerate() {
            let entry = found[row * size + by];
            // Close to a singularity the error of a difference is more than rounding: a third of the change that twice
            // the step makes.
            let bound = 1e-12 * largest + (slope - wider).abs();
            assert!((entry - slope).abs() <= bound, "{place}: d{row}/d{by} is {entry}, not {slope}");
        }
    }
}
