//! Runs of mechanisms whose forces are potentials of the file.
//!
//! Truth: the period of x" = -x^3 from 1, Gamma(1/4)^2/sqrt(pi) (P. F. Byrd & M. D. Friedman, Handbook of Elliptic
//! Integrals, 2nd edition (1971), 130.05).

use tripos::{Mechanism, Overrides, Scene};
use tripos_derive::diagnostic::Source;
use tripos_derive::{Formulation, model};

const QUARTIC: &str = r#"
name = "A bead in a quartic well"
[parameters]
m = { unit = "kg", value = 1, positive = true }
k = { unit = "N/m^3", value = 1, positive = true }
[inertial]
frame = "N"
origin = "O"
[coordinates]
x = { unit = "m" }
[speeds]
u = "x'"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
[particles]
bead = { point = "P", mass = "m" }
[potentials]
well = "k*(p(P) @ N [1])^4/4"
"#;

#[test]
fn a_bead_comes_back_after_the_period_of_its_well() {
    let period = 3.625_609_908_221_908_f64.powi(2) / std::f64::consts::PI.sqrt();
    let scene = format!(
        "model = \"model.toml\"\nspan = [0, {period:?}]\n[start]\nx = 1\nu = 0\n[integration]\nmethod = \"dop853\"\nrtol = 1e-12\natol = 1e-13\n"
    );
    for by in Formulation::ALL {
        let model = model::load(&Source::from_text("model.toml", QUARTIC)).unwrap_or_else(|e| panic!("{e}"));
        let scene = Scene::parse(Mechanism::new(model), &scene).unwrap_or_else(|e| panic!("{e}"));
        let how = Overrides { by: Some(by.name().into()), ..Overrides::default() };
        let run = scene.simulate(&how).unwrap_or_else(|e| panic!("{}: {e}", by.name()));
        assert!(run.failure().is_none(), "{}: {:?}", by.name(), run.objections());
        assert!((run.end[0] - 1.0).abs() < 1e-10 && run.end[1].abs() < 1e-9, "{}: {:?}", by.name(), run.end);
        for (kinetic, potential) in &run.energies {
            assert!((kinetic + potential - 0.25).abs() < 1e-11, "T + V stays at k/4");
        }
    }
}
