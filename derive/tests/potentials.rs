//! Energies and momenta of forces that have a potential which is no polynomial, or that depend on velocities
//! and do no work.

use tripos_derive::algebra::text::parse::{parse_free, parse_primed};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{derive_all, speeds_to_rates};
use tripos_derive::model;
use tripos_derive::prove::prove;

/// Holds what a name says, read with p_x = m u and p_y = m v, against the integral.
fn says_what_is_constant(arena: &mut Arena, names: &[String], expression: Expr) {
    for name in names {
        let Some(said) = name.strip_prefix("momentum ") else { continue };
        let said = said.split(", where").next().unwrap_or_default().split(" = ").next().unwrap_or_default();
        let value = parse_free(arena, &said.replace("p_x", "m*u").replace("p_y", "m*v")).unwrap();
        let either = [arena.sub(value, expression), arena.add(value, expression)];
        assert!(
            either.into_iter().any(|e| zero_test(arena, e) == ZeroTest::Zero),
            "{name}: {}",
            print_text(arena, expression)
        );
    }
}

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
    let names: Vec<_> =
        proof.integrals.iter().map(|i| (i.names(&model, &derivations.kinematics.arena), i.expression)).collect();
    let arena = &mut derivations.kinematics.arena;
    for (names, expression) in names {
        says_what_is_constant(arena, &names, expression);
    }
    let found: Vec<_> = proof.integrals.iter().map(|i| i.expression).collect();
    let all: Vec<String> = found.iter().map(|e| print_text(arena, *e)).collect();
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
fn a_magnetic_force_leaves_the_energy_and_momenta_with_functions_of_place() {
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

/// V, and the power of what it leaves out, by every formulation, in the words of the file.
fn energies(file: &str, potential: &str, power: &str) {
    let model = model::load(&Source::from_text("model.toml", file)).unwrap_or_else(|e| panic!("{e}"));
    let mut derivations = derive_all(&model).unwrap();
    let found: Vec<_> = derivations.list.iter().filter_map(|(_, e)| e.as_ref().ok()).cloned().collect();
    assert!(found.len() >= 2);
    for equations in found {
        let arena = &mut derivations.kinematics.arena;
        let mut to_rates = speeds_to_rates(&model);
        for (derived, stated) in [(equations.potential_energy, potential), (equations.power, power)] {
            let stated = parse_primed(arena, stated, 1, &mut |arena, name| {
                arena.find_symbol(name).ok_or_else(|| (format!("no {name}"), None))
            })
            .unwrap();
            let derived = to_rates.apply(arena, derived);
            let difference = arena.sub(derived, stated);
            assert_eq!(
                zero_test(arena, difference),
                ZeroTest::Zero,
                "{:?}: {}",
                equations.by,
                print_text(arena, derived)
            );
        }
    }
}

const TWO_IN_A_PLANE: &str = r#"
name = "Two beads in a plane"
[parameters]
m = { unit = "kg", positive = true }
k = { unit = "N/m", positive = true }
l = { unit = "m", positive = true }
c = { unit = "N*s/m", positive = true }
g = { unit = "m/s^2", positive = true }
F = { unit = "N" }
[coordinates]
x = { unit = "m" }
y = { unit = "m" }
[speeds]
u = "x' + y'"
v = "y'"
[inertial]
frame = "N"
origin = "O"
[points]
P = { from = "O", frame = "N", position = ["x", 0, 0] }
Q = { from = "P", frame = "N", position = [0, "y", 0] }
[particles]
a = { point = "P", mass = "m" }
b = { point = "Q", mass = "m" }
"#;

/// The parts of a load are told apart: what is there at rest is potential energy, what moving adds is power; gravity's
/// part stays with its own zero, and a load whose work depends on the way is all power.
#[test]
fn what_of_each_load_has_a_potential_is_in_v_and_the_rest_is_power() {
    let loads =
        |rest: &str| format!("{TWO_IN_A_PLANE}\n[gravity]\nframe = \"N\"\nacceleration = [0, \"-g\", 0]\n{rest}");
    let spring =
        "[forces.spring]\non = \"b\"\nagainst = \"a\"\nframe = \"N\"\nvector = [0, \"-k*(y - l) - c*y'\", 0]\n";
    energies(&loads(spring), "m*g*y + k*(y - l)^2/2", "-c*y'^2");
    let push = "[forces.push]\non = \"a\"\nframe = \"N\"\nvector = [\"F\", 0, 0]\n";
    energies(&loads(&format!("{spring}{push}")), "m*g*y + k*(y - l)^2/2 - F*x", "-c*y'^2");
    // The curl of this one leaves the spring and the push their potentials.
    let stir = "[forces.stir]\non = \"b\"\nframe = \"N\"\nvector = [\"-k*y\", 0, 0]\n";
    energies(&loads(&format!("{spring}{push}{stir}")), "m*g*y + k*(y - l)^2/2 - F*x", "-c*y'^2 - k*y*x'");
    // A magnetic force works never.
    let magnet = "[forces.magnet]\non = \"b\"\nframe = \"N\"\nvector = [\"c*y'\", \"-c*x'\", 0]\n";
    energies(&loads(&format!("{push}{magnet}")), "m*g*y - F*x", "0");
    // Dry friction has no value at rest.
    let dry = "[forces.dry]\non = \"a\"\nframe = \"N\"\nvector = [\"-F*x'/abs(x')\", 0, 0]\n";
    energies(&loads(&format!("{spring}{dry}")), "m*g*y + k*(y - l)^2/2", "-c*y'^2 - F*x'^2/abs(x')");
}

/// Both together have a potential that neither has alone.
#[test]
fn loads_that_have_a_potential_only_together_have_it() {
    let both = "[forces.e]\non = \"a\"\nframe = \"N\"\nvector = [\"-k*y\", 0, 0]\n[forces.f]\non = \"b\"\nframe = \"N\"\nvector = [0, \"-k*x\", 0]\n";
    energies(&format!("{TWO_IN_A_PLANE}{both}"), "k*x*y", "0");
    let other = both.replace("-k*x", "k*x");
    energies(&format!("{TWO_IN_A_PLANE}{other}"), "0", "k*(x*y' - y*x')");
}
