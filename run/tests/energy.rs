//! Energy of a run: kinetic, every potential, and the work of loads without one; and the instants of events with their
//! errors.

use expect_test::expect;
use tripos::{Mechanism, Method, Overrides, Scene};
use tripos_derive::diagnostic::Source;

const MASS: f64 = 2.0;
const RATE: f64 = 0.2;
const WAVE: f64 = 1.989_974_874_213_24;

/// A mass on a damped spring of a free length, which also slides freely across it: ẍ = −k (x − l)/m − c ẋ/m.
const SLIDER: &str = r#"
name = "Damped mass on a spring"
[parameters]
m = { unit = "kg", value = 2, positive = true }
k = { unit = "N/m", value = 8, positive = true }
c = { unit = "N*s/m", value = "4/5", positive = true }
l = { unit = "m", value = "3/10" }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
v = "2*x'"
w = "y' - x'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", "y", 0] }
[particles]
b = { point = "P", mass = "m" }
[forces.spring]
on = "b"
frame = "N"
vector = ["-k*(x - l) - c*x'", 0, 0]
"#;

const SCENE: &str = r#"
model = "model.toml"
span = [0, 10]
[start]
x = 1.3
y = 0
"x'" = 0
"y'" = 0.5
[integration]
rtol = 1e-10
atol = 1e-11
samples = 60
[[events]]
name = "rest"
zero = "x - l"
"#;

/// Exact x − l and ẋ: e^(−γt) (cos ωt + γ/ω sin ωt), and its rate −(ω + γ²/ω) e^(−γt) sin ωt.
fn exact(t: f64) -> (f64, f64) {
    let (sin, cos) = (WAVE * t).sin_cos();
    let fading = (-RATE * t).exp();
    (fading * (cos + RATE / WAVE * sin), -(WAVE + RATE * RATE / WAVE) * fading * sin)
}

fn energy(t: f64) -> f64 {
    let (stretch, rate) = exact(t);
    0.5 * MASS * rate * rate + 0.5 * 8.0 * stretch * stretch
}

#[test]
fn what_damping_takes_is_accounted_for_at_every_sample_by_every_method_and_kind_of_equations() {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", SLIDER)).unwrap_or_else(|e| panic!("{e}"));
    let scene = Scene::parse(Mechanism::new(model), SCENE).unwrap_or_else(|e| panic!("{e}"));
    for by in [None, Some("kane"), Some("lagrange")] {
        for method in ["rk4", "ode45", "dopri5", "dop853", "gauss6", "radau5", "taylor"] {
            let how = Overrides {
                by: by.map(Into::into),
                method: Some(method.parse().unwrap()),
                step: (method == "rk4").then_some(4e-3),
                ..Overrides::default()
            };
            let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{by:?} {method}: {e}"));
            let what = format!("{by:?} {method}");
            assert!(run.is_trusted(), "{what}: {:?}", run.objections());
            // Between the ends of their steps implicit methods are of order 3.
            let allowed = if ["gauss6", "radau5"].contains(&method) { 1e-6 } else { 1e-8 };
            let work = &run.solution.work;
            assert_eq!((work.len(), run.energies.len()), (run.states.len(), run.states.len()), "{what}");
            for ((t, _), ((kinetic, potential), work)) in run.samples().zip(run.energies.iter().zip(work)) {
                let (stretch, rate) = exact(t);
                let (of_rate, of_spring) = (0.5 * MASS * (rate * rate + 0.25), 4.0 * stretch * stretch);
                let lost = energy(t) - energy(0.0);
                assert!(
                    (kinetic - of_rate).abs() < allowed && (potential - of_spring).abs() < allowed,
                    "{what} at {t}"
                );
                assert!((work - lost).abs() < allowed, "{what} at {t}: {work} for {lost}");
            }
            assert!((run.solution.work_end - (energy(10.0) - energy(0.0))).abs() < allowed, "{what}");
            assert!(run.energy_drift.unwrap() < allowed, "{what}: {:?}", run.energy_drift);

            // Each passage satisfies tan ωt = −ω/γ.
            let digits = run.digits.as_ref().unwrap();
            assert_eq!((run.events().len(), digits.events.len()), (6, 6), "{what}");
            for (at, (event, error)) in run.events().iter().zip(&digits.events).enumerate() {
                let exact = ((-WAVE / RATE).atan() + std::f64::consts::PI * (at + 1) as f64) / WAVE;
                let (error, off) = (error.expect("both runs have it"), (event.t - exact).abs());
                assert!(off <= 10.0 * error && error < 1e-6, "{what}: off by {off:e}, said {error:e}");
            }
        }
    }
}

#[test]
fn a_run_that_loses_its_energy_says_so_though_something_works() {
    let model = tripos_derive::model::load(&Source::from_text("model.toml", SLIDER)).unwrap_or_else(|e| panic!("{e}"));
    let scene = Scene::parse(Mechanism::new(model), SCENE).unwrap_or_else(|e| panic!("{e}"));
    let how = Overrides {
        by: Some("kane".into()),
        method: Some(Method::Rk4.into()),
        step: Some(0.8),
        ..Overrides::default()
    };
    let run = scene.simulate(&how).unwrap();
    expect![[r"
        fewer than three digits are right from t = 0.1695 s on, where `v` may be off by 0.059: this is the difference from another run, dop853 at tolerances of 1e-12
        total energy less the work done, constant in this motion, changed by 1.099 J of 8.25 J: fewer than three digits are left"]].assert_eq(&run.warnings.join("\n"));
}
