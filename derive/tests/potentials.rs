//! Energies and canonical momenta of forces that have a potential which is no polynomial, or that depend on velocities
//! and do no work.

use tripos_derive::algebra::modular::{ZeroTest, zero_test};
use tripos_derive::algebra::parse::parse_free;
use tripos_derive::algebra::print::text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::model;
use tripos_derive::prove::prove;

/// Holds that these, and no others, are proved to be conserved of a bead in a plane under these components of force.
fn keeps(force: [&str; 2], expected: &[&str]) {
    let [x, y] = force;
    let file = format!(
        r#"
name = "Bead in a plane"
[parameters]
m = {{ unit = "kg", positive = true }}
k = {{ unit = "N/m", positive = true }}
l = {{ unit = "m", positive = true }}
G = {{ unit = "N*m^2", positive = true }}
B = {{ unit = "N*s/m" }}
c = {{ unit = "N*s/m", positive = true }}
[coordinates]
x = {{ unit = "m" }}
y = {{ unit = "m" }}
[speeds]
u = "x'"
v = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
P = {{ from = "O", frame = "N", position = ["x", "y", 0] }}
[particles]
bead = {{ point = "P", mass = "m" }}
[forces.f]
on = "bead"
frame = "N"
vector = ["{x}", "{y}", 0]
"#
    );
    let model = model::load(&Source::from_text("bead.toml", &file)).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    assert!(proof.integrals.iter().all(|integral| integral.verdict.is_equal()));
    let arena = &mut derivations.kinematics.arena;
    let found: Vec<_> = proof.integrals.iter().map(|i| i.expression).collect();
    let all: Vec<String> = found.iter().map(|e| text(arena, *e)).collect();
    assert_eq!(found.len(), expected.len(), "{force:?}: {all:?}");
    for formula in expected {
        let value = parse_free(arena, formula).unwrap();
        let is_there = found.iter().any(|e| {
            let difference = arena.sub(*e, value);
            zero_test(arena, difference) == ZeroTest::Zero
        });
        assert!(is_there, "{force:?}: {formula} is not among {all:?}");
    }
}

#[test]
fn laws_of_force_that_are_no_polynomials_have_their_energy() {
    let kinetic = "m*(u^2 + v^2)/2";
    let turning = "m*(x*v - y*u)";
    for (force, potential, momentum) in [
        (["-k*l*sin(x/l)", "0"], "-k*l^2*cos(x/l)", Some("m*v")),
        (
            ["-k*(1 - l/sqrt(x^2 + y^2))*x", "-k*(1 - l/sqrt(x^2 + y^2))*y"],
            "k*(x^2 + y^2)/2 - k*l*sqrt(x^2 + y^2)",
            Some(turning),
        ),
        (["-G*x/sqrt(x^2 + y^2)^3", "-G*y/sqrt(x^2 + y^2)^3"], "-G/sqrt(x^2 + y^2)", Some(turning)),
        (["-G/x^2", "-k*l*exp(y/l)"], "k*l^2*exp(y/l) - G/x", None),
    ] {
        let energy = format!("{potential} + {kinetic}");
        keeps(force, &[Some(energy.as_str()), momentum].into_iter().flatten().collect::<Vec<_>>());
    }
}

/// x″ = ω y′, y″ = −ω x′ with ω = B/m.
#[test]
fn a_magnetic_force_leaves_the_energy_and_canonical_momenta() {
    let about_origin = "m*(x*v - y*u) + B*(x^2 + y^2)/2";
    keeps(["B*y'", "-B*x'"], &["m*(u^2 + v^2)/2", "m*u - B*y", "m*v + B*x", about_origin]);
    keeps(["B*y' - k*x", "-B*x' - k*y"], &["k*(x^2 + y^2)/2 + m*(u^2 + v^2)/2", about_origin]);
}

/// Drag takes the energy, and of a momentum along which nothing else works leaves m u + c x.
#[test]
fn drag_keeps_no_energy_and_gives_its_momentum_to_the_place() {
    keeps(["-c*x'", "-k*y - c*y'"], &["m*u + c*x"]);
    // A field with curl.
    keeps(["-k*y", "k*x"], &[]);
}
